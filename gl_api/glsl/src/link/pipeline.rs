//! The programs of a pipeline as one program: each keeps its own uniforms and uniform blocks, whatever their names
//! (ARB_separate_shader_objects, section 2.14.PPO).

use super::{Matching, linked};
use crate::hir::{Block, Storage, Unit};
use crate::program::{Bindings, LinkedPipeline, Program, Uniform, UniformBlock, WordsOfPart};
use std::sync::Arc;

/// Between the number of a program and the name of what is its own.
const SEPARATOR: char = ':';

/// A name that no other program of the pipeline has.
fn own_name(part: usize, name: &str) -> Arc<str> {
    format!("{part}{SEPARATOR}{name}").into()
}

/// The program and the name that [`own_name`] has put together.
fn parsed(name: &str) -> Option<(usize, &str)> {
    let (part, name) = name.split_once(SEPARATOR)?;
    Some((part.parse().ok()?, name))
}

/// A shader whose uniforms and blocks have names of their own.
fn renamed(unit: &Unit, part: usize) -> Arc<Unit> {
    let mut unit = unit.clone();
    for variable in unit.globals.iter_mut().filter(|v| v.storage == Storage::Uniform) {
        variable.name = own_name(part, &variable.name);
        if let Some(block) = &mut variable.block {
            // So that members have names of their own, too.
            *block = Arc::new(Block {
                name: own_name(part, &block.name),
                is_named: true,
                ..(**block).clone()
            });
        }
    }
    Arc::new(unit)
}

/// A program: the shaders that it was linked from, and what it was linked to.
type Part<'a> = (Vec<Arc<Unit>>, &'a Program);

/// Links the programs of a pipeline.
pub fn link_pipeline(parts: &[Part<'_>], bindings: &Bindings) -> LinkedPipeline {
    let units: Vec<Arc<Unit>> = parts
        .iter()
        .enumerate()
        .flat_map(|(part, (units, _))| units.iter().map(move |unit| renamed(unit, part)))
        .collect();
    let units: Vec<&Arc<Unit>> = units.iter().collect();
    let mut linked = linked(&units, bindings, Matching::Pipeline);
    let (mut words, mut blocks) = (Vec::new(), Vec::new());
    if let Some(program) = &mut linked.program {
        (words, blocks) = sources(program, parts);
        restore_names(program);
    }
    LinkedPipeline { linked, words, blocks }
}

/// Where the uniforms and the blocks of a pipeline come from.
fn sources(program: &Program, parts: &[Part<'_>]) -> (Vec<WordsOfPart>, Vec<(usize, usize)>) {
    let of_uniform = |uniform: &Uniform| {
        let (part, name) = parsed(&uniform.name)?;
        let own = parts.get(part)?.1.uniforms.iter().find(|own| own.name == name)?;
        let elements = uniform.array.unwrap_or(1).min(own.array.unwrap_or(1));
        let count = elements * uniform.ty.words();
        Some(WordsOfPart { part, from: own.word, to: uniform.word, count })
    };
    let mut words: Vec<WordsOfPart> = Vec::new();
    for next in program.uniforms.iter().filter_map(of_uniform) {
        match words.last_mut() {
            Some(last)
                if last.part == next.part
                    && last.from + last.count == next.from
                    && last.to + last.count == next.to =>
            {
                last.count += next.count;
            }
            Some(_) | None => words.push(next),
        }
    }
    let of_block = |block: &UniformBlock| {
        let found = parsed(&block.name).and_then(|(part, name)| {
            let own = &parts.get(part)?.1.blocks;
            Some((part, own.iter().position(|own| own.name == name)?))
        });
        found.unwrap_or_default()
    };
    (words, program.blocks.iter().map(of_block).collect())
}

/// Gives what has a name of its own the name in its program, for messages.
fn restore_names(program: &mut Program) {
    let uniforms = program.uniforms.iter_mut().map(|uniform| &mut uniform.name);
    let blocks = program.blocks.iter_mut().map(|block| &mut block.name);
    let members = program.members.iter_mut().map(|member| &mut member.name);
    for name in uniforms.chain(blocks).chain(members) {
        if let Some((_, own)) = parsed(name) {
            *name = own.to_owned();
        }
    }
}
