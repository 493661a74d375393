//! Blocks of inputs and outputs, and the names of the instances of all blocks (GLSL 1.50 section
//! 4.3.7).
//!
//! Each member becomes a variable named `block.member`, so that blocks match between the stages as
//! variables do. Of an array of instances it is the array of that member over all instances.

use super::Checker;
use super::scope::Symbol;
use crate::ast::{self, Qualifier};
use crate::hir::{Expr, ExprKind, InterfaceBlock, VarRef};
use crate::language::{Extension, stage_name};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::text::spelling::closest;
use crate::types::{INT, Type};
use rasterizer::ir::Stage;
use std::sync::Arc;

const SECTION: &str = "4.3.7";

/// A block whose members are written with the name of its instance.
#[derive(Clone, Debug)]
pub(super) struct Instance {
    /// The block's name.
    pub block: Arc<str>,
    /// How many dimensions the array of instances has; 0 of one instance.
    pub dimensions: usize,
    /// Its members.
    pub members: InstanceMembers,
}

/// The members of an instance.
#[derive(Clone, Debug)]
pub(super) enum InstanceMembers {
    /// A variable for each.
    Variables(Vec<(Arc<str>, VarRef)>),
    /// The members of the structure that this uniform is.
    Uniform(VarRef),
    /// The built-in variables of the vertices that the geometry stage takes: `gl_in`.
    PerVertex,
}

/// An expression without the indices behind it, and these.
fn taken_apart(mut base: &ast::Expr) -> (&ast::Expr, Vec<&ast::Expr>) {
    let mut indices = Vec::new();
    while let ast::ExprKind::Index(array, index) = &base.kind {
        indices.push(&**index);
        base = array;
    }
    indices.reverse();
    (base, indices)
}

impl Checker<'_> {
    /// A block of uniforms, inputs or outputs.
    pub(super) fn block(&mut self, declared: &ast::BlockDecl) {
        match declared.qualifiers.last() {
            Some(&(way @ (Qualifier::In | Qualifier::Out), span)) => {
                self.interface_block(declared, way, span);
            }
            Some(_) | None => self.uniform_block(declared),
        }
    }

    fn interface_block(&mut self, declared: &ast::BlockDecl, way: Qualifier, span: Span) {
        let ast::BlockDecl { qualifiers, name, members, instance } = declared;
        if &*name.text == "gl_PerVertex" {
            self.per_vertex(declared, way, span);
            return;
        }
        let wrong = if (self.stage, way) == (Stage::Vertex, Qualifier::In) {
            Some("the vertex stage has no blocks of inputs")
        } else if (self.stage, way) == (Stage::Fragment, Qualifier::Out) {
            Some("the fragment stage has no blocks of outputs")
        } else {
            None
        };
        if let Some(message) = wrong {
            let problem = Diagnostic::error(span, message).rule(self.rule(SECTION));
            self.log.push(problem.help("declare the members as variables of their own"));
            return;
        }
        let mut location = None;
        for (qualifier, span) in &qualifiers[..qualifiers.len() - 1] {
            if let Qualifier::Location(first) = qualifier
                && self.language.enabled(Extension::SeparateShaderObjects)
            {
                location = Some(*first);
                continue;
            }
            let message = "before a block of inputs or outputs stands `in` or `out` alone";
            let problem = Diagnostic::error(*span, message).rule(self.rule(SECTION));
            self.log.push(problem.help("write it before the members"));
        }
        let of = if way == Qualifier::In { "in" } else { "out" };
        if !self.new_block_name(name, of) {
            return;
        }
        let array = instance.as_ref().map_or(&[][..], |instance| &instance.array);
        let block = Arc::new(InterfaceBlock {
            name: name.text.clone(),
            is_named: instance.is_some(),
            dimensions: array.len(),
            members: members.iter().flat_map(|m| &m.names).map(|m| m.name.text.clone()).collect(),
        });
        if (self.stage, way) == (Stage::Geometry, Qualifier::In) && block.dimensions == 0 {
            let message = "a block of inputs of the geometry stage is an array, with an element for \
                           each vertex";
            let problem = Diagnostic::error(name.span, message).rule(self.rule("4.3.4"));
            self.log.push(problem.help("write a name and `[]` behind it"));
            return;
        }
        let mut variables = Vec::new();
        for declaration in members {
            if self.log.is_full() {
                break;
            }
            variables.extend(self.interface_members(declaration, &block, array, (way, span)));
        }
        if variables.is_empty() {
            self.error(name.span, SECTION, "a block needs a member");
        }
        let per_vertex = (self.stage, way) == (Stage::Geometry, Qualifier::In);
        if let Some(first) = location {
            if block.dimensions > 0 && !per_vertex {
                let message = "an array of blocks has no location";
                let problem = Diagnostic::error(name.span, message);
                self.log.push(problem.rule("ARB_separate_shader_objects"));
            }
            self.locate_members(&variables, first, per_vertex);
        }
        let Some(instance) = instance else { return };
        self.check_new(&instance.name);
        let members = InstanceMembers::Variables(variables);
        self.add_instance(&instance.name, &block.name, block.dimensions, members);
    }

    /// Gives the members of a block consecutive locations from `next` on. Where `per_vertex`, they are arrays with an
    /// element for each vertex.
    fn locate_members(&mut self, members: &[(Arc<str>, VarRef)], mut next: u32, per_vertex: bool) {
        for (_, member) in members {
            let variable = self.variable_mut(*member);
            let first = *variable.interface_qualifiers.location.get_or_insert(next);
            let passed = match &variable.ty {
                Type::Array(element, _) if per_vertex => element,
                ty => ty,
            };
            next = first.saturating_add(passed.locations());
        }
    }

    /// The members of one declaration.
    fn interface_members(
        &mut self,
        declaration: &ast::Declaration,
        block: &Arc<InterfaceBlock>,
        instances: &[ast::ArraySize],
        (way, span): (Qualifier, Span),
    ) -> Vec<(Arc<str>, VarRef)> {
        let mut ty = declaration.ty.clone();
        let own = ty.qualifiers.iter().any(|(qualifier, _)| *qualifier == way);
        if !own {
            let at =
                ty.qualifiers.iter().take_while(|(other, _)| other.rank() < way.rank()).count();
            ty.qualifiers.insert(at, (way, span));
        }
        let Some((storage, interface_qualifiers)) = self.global_storage(&ty) else {
            return Vec::new();
        };
        self.precision_of(&ty);
        if declaration.names.is_empty() {
            self.error(ty.ty.span, SECTION, "a member needs a name");
        }
        let mut variables: Vec<(Arc<str>, VarRef)> = Vec::new();
        for member in &declaration.names {
            let (text, span) = (&member.name.text, member.name.span);
            if member.init.is_some() {
                self.error(span, SECTION, format!("`{text}` takes no value: it is in a block"));
            }
            let mut ty = self.type_of(&ty.ty, &member.array);
            self.check_interface_type(storage, &ty, span);
            self.check_layout(&member.name, interface_qualifiers);
            for size in instances.iter().rev() {
                ty = self.array_of(ty, size);
            }
            let ty = self.passed_type(ty, storage, span);
            let mut variable = self.new_variable(member, ty, storage);
            self.check_sized(&variable);
            // A block may be both an input and an output of the geometry stage.
            let prefix = match (self.stage, way) {
                (Stage::Geometry, Qualifier::In) => "in ",
                (Stage::Vertex | Stage::Geometry | Stage::Fragment, _) => "",
            };
            variable.name = format!("{prefix}{}.{text}", block.name).into();
            variable.interface_qualifiers = interface_qualifiers;
            variable.member_of = Some(Arc::clone(block));
            let var = VarRef::Global(self.unit.globals.len() as u32);
            if !block.is_named {
                self.check_new(&member.name);
                self.scopes.add(text.clone(), Symbol::Variable(var));
            } else if self.unit.globals.iter().any(|other| other.name == variable.name) {
                self.error(span, SECTION, format!("a second member `{text}`"));
            } else if text.starts_with("gl_") {
                self.check_new(&member.name);
            }
            self.unit.globals.push(variable);
            variables.push((text.clone(), var));
        }
        variables
    }

    /// Whether the name of a block is free: uniforms, inputs and outputs have each their own, and
    /// nothing else has the name.
    pub(super) fn new_block_name(&mut self, name: &ast::Name, of: &'static str) -> bool {
        let is_block = matches!(self.scopes.find_innermost(&name.text), Some(Symbol::Block));
        if !self.block_names.insert((of, name.text.clone())) {
            self.declared_already(name, &Symbol::Block);
            return false;
        }
        if !is_block {
            self.check_new(name);
            self.scopes.add(name.text.clone(), Symbol::Block);
        }
        true
    }

    /// Adds the name of an instance.
    pub(super) fn add_instance(
        &mut self,
        name: &ast::Name,
        block: &Arc<str>,
        dimensions: usize,
        members: InstanceMembers,
    ) {
        let index = self.instances.len() as u32;
        self.instances.push(Instance { block: block.clone(), dimensions, members });
        self.scopes.add(name.text.clone(), Symbol::Instance(index));
    }

    /// The instance that a name is.
    pub(super) fn instance_named(&self, name: &ast::Expr) -> Option<Instance> {
        let ast::ExprKind::Name(name) = &name.kind else { return None };
        match self.scopes.find(name) {
            Some(Symbol::Instance(index)) => self.instances.get(*index as usize).cloned(),
            None if &**name == "gl_in" && self.stage == Stage::Geometry => Some(Instance {
                block: "gl_PerVertex".into(),
                dimensions: 1,
                members: InstanceMembers::PerVertex,
            }),
            Some(_) | None => None,
        }
    }

    /// `instance.member`, `instance[i].member` or `instance[i][j].member`; `None` if `base` is something else.
    pub(super) fn instance_member(
        &mut self,
        base: &ast::Expr,
        name: &ast::Name,
        span: Span,
    ) -> Option<Expr> {
        let (root, indices) = taken_apart(base);
        let instance = self.instance_named(root)?;
        if instance.dimensions != indices.len() {
            let message = match indices.len() < instance.dimensions {
                true => "this is an array of blocks: an index is missing before the member",
                false => "this is one block, and no array of them",
            };
            self.error(base.span, SECTION, message);
            return Some(Expr::error(span));
        }
        let var = match &instance.members {
            InstanceMembers::Uniform(var) => Some(*var),
            InstanceMembers::Variables(all) => {
                all.iter().find(|(member, _)| *member == name.text).map(|(_, var)| *var)
            }
            InstanceMembers::PerVertex => {
                let full = format!("gl_in.{}", name.text);
                if self.leaves_out(&full) {
                    self.left_out(&full, name.span);
                    return Some(Expr::error(span));
                }
                let known = self.scopes.find_global(&full).and_then(Symbol::variable);
                known.or_else(|| self.builtin_variable(&full))
            }
        };
        let Some(var) = var else {
            let message = format!("the block `{}` has no member `{}`", instance.block, name.text);
            let mut problem = Diagnostic::error(name.span, message).rule(self.rule(SECTION));
            if let InstanceMembers::Variables(all) = &instance.members
                && let Some(near) = closest(&name.text, all.iter().map(|(member, _)| &**member))
            {
                let text = format!("did you mean `{near}`?");
                problem = problem.fix(text, name.span, near.to_owned());
            }
            self.log.push(problem);
            return Some(Expr::error(span));
        };
        self.note_use(var);
        let ty = self.variable(var).ty.clone();
        let whole = Expr { ty, span: base.span, constant: false, kind: ExprKind::Var(var) };
        let mut element = whole;
        for index in indices {
            let index = self.expr(index);
            let is_uniform = matches!(instance.members, InstanceMembers::Uniform(_));
            if is_uniform && !index.constant && !index.is_error() {
                let message = "blocks of uniforms are indexed by constant expressions only";
                self.error(index.span, SECTION, message);
            }
            element = self.indexed(element, index, span);
        }
        Some(match &instance.members {
            InstanceMembers::Variables(_) | InstanceMembers::PerVertex => element,
            InstanceMembers::Uniform(_) => self.member_of(element, name, span),
        })
    }

    /// `instances.length()` or `instances[i].length()`; `None` if the name is no instance.
    pub(super) fn instance_count(&mut self, base: &ast::Expr, span: Span) -> Option<Expr> {
        let (root, indices) = taken_apart(base);
        let instance = self.instance_named(root)?;
        let var = match &instance.members {
            InstanceMembers::Uniform(var) => Some(*var),
            InstanceMembers::Variables(all) => all.first().map(|(_, var)| *var),
            InstanceMembers::PerVertex if !indices.is_empty() => None,
            InstanceMembers::PerVertex => {
                let vertices = self.unit.geometry.input.map(|input| input.vertices().into());
                let Some(vertices) = vertices else {
                    let message = "the number of vertices is not known here";
                    let problem = Diagnostic::error(span, message).rule(self.rule("4.3.8.1"));
                    self.log.push(problem.help("write the layout of the inputs before"));
                    return Some(Expr::error(span));
                };
                return Some(super::expr::word(span, INT, vertices));
            }
        };
        let mut ty = var.map(|var| self.variable(var).ty.clone());
        for _ in &indices {
            ty = match ty {
                Some(Type::Array(element, _)) => Some(*element),
                Some(_) | None => None,
            };
        }
        let is_array = indices.len() < instance.dimensions;
        if let (true, Some(Type::Array(_, Some(len)))) = (is_array, ty) {
            return Some(super::expr::word(span, INT, len));
        }
        let message = match is_array {
            true => "the number of instances is not known here",
            false => "this is one block, and no array of them",
        };
        self.error(span, SECTION, message);
        Some(Expr::error(span))
    }

    /// Reports the name of an instance without a member.
    pub(super) fn whole_instance(&mut self, name: &str, span: Span) -> Expr {
        let message = format!(
            "`{name}` is a block in the {} stage: its members have values",
            stage_name(self.stage)
        );
        let problem = Diagnostic::error(span, message).rule(self.rule(SECTION));
        self.log.push(problem.help(format!("write `{name}.` and the name of a member")));
        Expr::error(span)
    }
}
