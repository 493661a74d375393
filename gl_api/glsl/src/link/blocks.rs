//! The uniform blocks of a program: the active blocks, their words, and the offsets of their
//! members (ARB_uniform_buffer_object, sections 2.15.3.1 and 4.3.5.1).

use super::stage::StageUnits;
use super::std140;
use crate::hir::{Block, BlockPacking, Storage, Variable};
use crate::language::stage_name;
use crate::limits::{MAX_UNIFORM_BLOCK_SIZE, MAX_UNIFORM_BLOCKS, MAX_UNIFORM_WORDS};
use crate::lower::Words;
use crate::program::{Member, UniformBlock};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::{MatrixOrder, Type};
use std::collections::BTreeMap;
use std::sync::Arc;

const RULE: &str = "ARB_uniform_buffer_object, section 2.15.3.1";

/// The uniform blocks of a program.
#[derive(Default)]
pub struct Blocks {
    /// The blocks, as GL lists them.
    pub list: Vec<UniformBlock>,
    /// Their members, block after block.
    pub members: Vec<Member>,
    /// The first word of each block that a stage reads, by the name of its variable.
    pub words: BTreeMap<Arc<str>, u32>,
}

/// The active blocks: all but those that are `packed` and not referenced.
pub fn blocks(stages: &[&StageUnits<'_>], words: &mut Words, log: &mut Log) -> Blocks {
    let mut blocks = Blocks::default();
    let bindings = bindings(stages, log);
    for (variable, block) in declared(stages, log) {
        let named = |stage: &&&StageUnits<'_>| {
            stage.used.iter().any(|used| used.block.is_some() && used.name == variable.name)
        };
        let readers: Vec<_> = stages.iter().filter(named).map(|stage| stage.stage).collect();
        if block.packing == BlockPacking::Packed && readers.is_empty() {
            continue;
        }
        let index = blocks.list.len() as u32;
        let first = blocks.members.len() as u32;
        let Type::Struct(structure) = variable.ty.base() else { continue };
        let (mut end, mut word) = (0, 0);
        for ((name, ty), &order) in structure.fields.iter().zip(&block.orders) {
            let offset = std140::aligned_offset(end, ty);
            end = offset.saturating_add(std140::size(ty, order));
            if end > MAX_UNIFORM_BLOCK_SIZE {
                break;
            }
            let mut layout = Layout { block: index, order, members: &mut blocks.members };
            let name = match block.is_named {
                true => &format!("{}.{name}", block.name),
                false => &**name,
            };
            layout.add(name, ty, offset, word);
            word += ty.scalars();
        }
        let bytes = std140::padded(end);
        if bytes > MAX_UNIFORM_BLOCK_SIZE {
            let message = format!(
                "the uniform block `{}` takes {bytes} bytes; GL_MAX_UNIFORM_BLOCK_SIZE is \
                 {MAX_UNIFORM_BLOCK_SIZE}",
                block.name
            );
            log.push(Diagnostic::link_error(message).rule(RULE));
            return blocks;
        }
        if !readers.is_empty() {
            blocks.words.insert(variable.name.clone(), words.next);
        }
        // The instances of an array are blocks of their own with the same members.
        let bound = bindings.get(&*variable.name).copied();
        for (number, name) in (0..).zip(instances(&block.name, &variable.ty)) {
            blocks.list.push(UniformBlock {
                name,
                binding: bound.map_or(0, |first| first + number),
                bytes,
                word: (!readers.is_empty()).then_some(words.next),
                members: first..blocks.members.len() as u32,
                stages: readers.clone(),
            });
            if !readers.is_empty() {
                words.next = words.next.saturating_add(word);
            }
            if words.next > MAX_UNIFORM_WORDS {
                break;
            }
        }
        if words.next > MAX_UNIFORM_WORDS {
            let message = format!("the uniforms have more than {MAX_UNIFORM_WORDS} components");
            log.push(Diagnostic::link_error(message));
            return blocks;
        }
    }
    for stage in stages {
        let count = blocks.list.iter().filter(|block| block.stages.contains(&stage.stage)).count();
        if count > MAX_UNIFORM_BLOCKS {
            let message = format!(
                "the {} shader reads {count} uniform blocks; a stage has {MAX_UNIFORM_BLOCKS}",
                stage_name(stage.stage)
            );
            log.push(Diagnostic::link_error(message).rule(RULE));
        }
    }
    blocks
}

/// The bindings that shaders give to blocks, by the name of the variable; all must be the same.
fn bindings<'a>(stages: &[&StageUnits<'a>], log: &mut Log) -> BTreeMap<&'a str, u32> {
    let mut bindings = BTreeMap::new();
    for variable in stages.iter().flat_map(|stage| stage.declared()) {
        let (Some(block), Some(binding)) = (&variable.block, variable.interface_qualifiers.bound())
        else {
            continue;
        };
        let first = *bindings.entry(&*variable.name).or_insert(binding);
        if first != binding {
            let message = format!(
                "the uniform block `{}` has the bindings {first} and {binding}",
                block.name
            );
            log.push(Diagnostic::link_error(message).rule("ARB_shading_language_420pack"));
        }
    }
    bindings
}

/// The names of the instances of a block of this type: `block[0]`, `block[1]` of an array.
fn instances(name: &str, ty: &Type) -> Vec<String> {
    match ty {
        Type::Array(element, len) => {
            // More are over the limit in any case.
            let len = len.unwrap_or(0).min(2 * MAX_UNIFORM_BLOCKS as u32);
            (0..len).flat_map(|index| instances(&format!("{name}[{index}]"), element)).collect()
        }
        Type::Void
        | Type::Vector(..)
        | Type::Matrix(..)
        | Type::Sampler(_)
        | Type::Struct(_)
        | Type::Error => vec![name.to_owned()],
    }
}

/// Every block that a shader declares, once. The shaders must declare it alike; a member name must
/// belong to one block only.
fn declared<'a>(stages: &[&StageUnits<'a>], log: &mut Log) -> Vec<(&'a Variable, &'a Block)> {
    let mut known: Vec<(&Variable, &Block)> = Vec::new();
    let mut names: BTreeMap<&str, usize> = BTreeMap::new();
    let all = || stages.iter().flat_map(|stage| stage.declared());
    let is_es = stages.iter().flat_map(|stage| &stage.units).all(|unit| unit.version.is_es());
    for variable in all() {
        let Some(block) = &variable.block else { continue };
        let first = *names.entry(&*variable.name).or_insert(known.len());
        let Some((other, same)) = known.get(first) else {
            known.push((variable, block));
            continue;
        };
        if other.ty == variable.ty && is_es && other.ty.differs_in_precision(&variable.ty) {
            let message = format!(
                "members of the uniform block `{}` have other precisions in another shader",
                block.name
            );
            log.push(Diagnostic::link_error(message).rule("GLSL ES 3.00 section 4.3.7"));
        } else if other.ty != variable.ty || *same != &**block {
            let message = format!(
                "the uniform block `{}` has other members or another layout in another shader",
                block.name
            );
            log.push(Diagnostic::link_error(message).rule(RULE));
        }
    }
    let mut owners: BTreeMap<&str, &str> = BTreeMap::new();
    for (variable, block) in known.iter().filter(|(_, block)| !block.is_named) {
        let Type::Struct(structure) = &variable.ty else { continue };
        for (member, _) in &structure.fields {
            let other = owners.insert(member, &block.name);
            if let Some(other) = other.filter(|other| **other != *block.name) {
                let message =
                    format!("`{member}` is in the uniform blocks `{other}` and `{}`", block.name);
                log.push(Diagnostic::link_error(message).rule(RULE));
            }
        }
    }
    let uniform = |v: &&Variable| v.storage == Storage::Uniform && v.block.is_none();
    // Uniforms and blocks share a name space (GLSL ES 3.00 section 4.2.5).
    for variable in all().filter(uniform) {
        if is_es && known.iter().any(|(_, block)| block.name == variable.name) {
            let message =
                format!("`{}` is a uniform in one shader and a block in another", variable.name);
            log.push(Diagnostic::link_error(message).rule("GLSL ES 3.00 section 4.2.5"));
        }
        if let Some(block) = owners.remove(&*variable.name) {
            let message = format!(
                "`{}` is in the uniform block `{block}`, and a uniform of its own in another shader",
                variable.name
            );
            log.push(Diagnostic::link_error(message).rule(RULE));
        }
    }
    known
}

/// Lists the members of one block.
struct Layout<'a> {
    block: u32,
    order: MatrixOrder,
    members: &'a mut Vec<Member>,
}

impl Layout<'_> {
    /// Adds the leaves of a member that begins at this byte and this word.
    fn add(&mut self, name: &str, ty: &Type, offset: u32, word: u32) {
        match ty {
            Type::Struct(structure) => {
                let (mut end, mut word) = (offset, word);
                for (field, ty) in &structure.fields {
                    let offset = std140::aligned_offset(end, ty);
                    self.add(&format!("{name}.{field}"), ty, offset, word);
                    end = offset + std140::size(ty, self.order);
                    word += ty.scalars();
                }
            }
            Type::Array(element, len) if matches!(**element, Type::Struct(_) | Type::Array(..)) => {
                let stride = std140::stride(element, self.order);
                for index in 0..len.unwrap_or(0) {
                    let (offset, word) =
                        (offset + index * stride, word + index * element.scalars());
                    self.add(&format!("{name}[{index}]"), element, offset, word);
                }
            }
            Type::Array(element, len) => {
                let stride = std140::stride(element, self.order);
                self.leaf(name, element, (*len, stride), [offset, word]);
            }
            Type::Vector(..) | Type::Matrix(..) | Type::Sampler(_) | Type::Void | Type::Error => {
                self.leaf(name, ty, (None, 0), [offset, word]);
            }
        }
    }

    fn leaf(
        &mut self,
        name: &str,
        ty: &Type,
        (array, array_stride): (Option<u32>, u32),
        [offset, word]: [u32; 2],
    ) {
        let matrix_stride = std140::matrix_stride(ty);
        let Some(data_type) = ty.data_type() else { return };
        self.members.push(Member {
            name: name.to_owned(),
            ty: data_type,
            array,
            block: self.block,
            word,
            offset,
            array_stride,
            matrix_stride,
            order: if matrix_stride == 0 { MatrixOrder::Columns } else { self.order },
        });
    }
}
