//! Uniform blocks and their layouts (ARB_uniform_buffer_object, section 4.3.5).
//!
//! A block becomes one uniform whose type is a structure of its members; the name of a member
//! stands for the member of that structure.

use super::Checker;
use super::interface_block::InstanceMembers;
use super::scope::Symbol;
use crate::ast::{self, BlockLayout, Qualifier};
use crate::hir::{Block, BlockPacking, Expr, ExprKind, Storage, VarRef};
use crate::language::Availability;
use crate::limits::MAX_SCALARS;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{MatrixOrder, Struct, Type};
use std::sync::Arc;

const BLOCKS: &str = "ARB_uniform_buffer_object, section 4.3.5.1";
const LAYOUTS: &str = "ARB_uniform_buffer_object, section 4.3.5.2";

/// A block layout: packing and matrix order.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockDefaults {
    packing: BlockPacking,
    order: MatrixOrder,
}

impl Default for BlockDefaults {
    fn default() -> Self {
        Self { packing: BlockPacking::Shared, order: MatrixOrder::Columns }
    }
}

impl BlockDefaults {
    /// Applies a qualifier, which overrides those that it contradicts.
    fn set(&mut self, layout: BlockLayout) {
        match layout {
            BlockLayout::Shared => self.packing = BlockPacking::Shared,
            BlockLayout::Packed => self.packing = BlockPacking::Packed,
            BlockLayout::Std140 => self.packing = BlockPacking::Std140,
            BlockLayout::RowMajor => self.order = MatrixOrder::Rows,
            BlockLayout::ColumnMajor => self.order = MatrixOrder::Columns,
        }
    }
}

impl Checker<'_> {
    fn against(&mut self, span: Span, rule: &str, message: impl Into<String>) {
        self.log.push(Diagnostic::error(span, message).rule(rule));
    }

    /// The layout qualifiers; all other qualifiers must be `expected`.
    fn layouts(
        &mut self,
        words: &[(Qualifier, Span)],
        others: &[Qualifier],
        message: &str,
    ) -> Vec<(BlockLayout, Span)> {
        let mut layouts = Vec::new();
        for &(qualifier, span) in words {
            if matches!(qualifier, Qualifier::Binding(_) | Qualifier::Precision(_)) {
                continue;
            }
            if let Qualifier::Block(layout) = qualifier {
                layouts.push((layout, span));
            } else if !others.contains(&qualifier) {
                self.against(span, BLOCKS, message);
            }
        }
        layouts
    }

    /// The layout of a block with these qualifiers, over the default.
    fn layout_of(&mut self, words: &[(Qualifier, Span)]) -> BlockDefaults {
        let message = "before a uniform block stand `layout(...)` and `uniform`";
        let mut defaults = self.block_layout;
        for (layout, _) in self.layouts(words, &[Qualifier::Uniform], message) {
            defaults.set(layout);
        }
        defaults
    }

    /// `layout(std140) uniform;`, `layout(triangles) in;`.
    pub(super) fn layout_defaults(&mut self, words: &[(Qualifier, Span)]) {
        match words.last() {
            Some((Qualifier::In, span)) => self.input_layout(words, *span),
            Some((Qualifier::Out, span)) => self.output_layout(words, *span),
            Some(_) | None => self.block_layout = self.layout_of(words),
        }
    }

    /// The matrix order of a member.
    fn order_of(&mut self, words: &[(Qualifier, Span)], order: MatrixOrder) -> MatrixOrder {
        let message = "a member of a uniform block takes `layout(...)` and `uniform`";
        let others = [Qualifier::Uniform];
        let mut order = order;
        for (layout, span) in self.layouts(words, &others, message) {
            match layout {
                BlockLayout::RowMajor => order = MatrixOrder::Rows,
                BlockLayout::ColumnMajor => order = MatrixOrder::Columns,
                BlockLayout::Shared | BlockLayout::Packed | BlockLayout::Std140 => {
                    let message = "`shared`, `packed` and `std140` are of a whole block";
                    self.against(span, LAYOUTS, message);
                }
            }
        }
        order
    }

    /// A uniform block.
    pub(super) fn uniform_block(&mut self, declared: &ast::BlockDecl) {
        let ast::BlockDecl { qualifiers, name, members, instance } = declared;
        if let Some(extension) = self.language.warns(Availability::UNIFORM_BLOCKS) {
            let message = format!("uniform blocks come from {}", extension.name());
            self.log.push(Diagnostic::warning(name.span, message));
        }
        let layout = self.layout_of(qualifiers);
        let precise = |(word, _): &&(Qualifier, Span)| matches!(word, Qualifier::Precision(_));
        if let Some(&(_, span)) = qualifiers.iter().find(precise) {
            self.against(span, BLOCKS, "a block has no precision: its members have one each");
        }
        self.new_block_name(name, "uniform");
        let var = VarRef::Global(self.unit.globals.len() as u32);
        let whole = ast::Declarator { name: name.clone(), array: Vec::new(), init: None };
        let mut variable = self.new_variable(&whole, Type::Error, Storage::Uniform);
        // A name that no variable can have.
        variable.name = format!("block {}", name.text).into();
        self.unit.globals.push(variable);
        let mut fields: Vec<(Arc<str>, Type)> = Vec::new();
        let (mut orders, mut precisions) = (Vec::new(), Vec::new());
        for declaration in members {
            if self.log.is_full() {
                break;
            }
            let order = self.order_of(&declaration.ty.qualifiers, layout.order);
            let precision = self.precision_of(&declaration.ty);
            if declaration.names.is_empty() {
                self.against(declaration.ty.ty.span, BLOCKS, "a member needs a name");
            }
            for member in &declaration.names {
                let ty = self.type_of(&declaration.ty.ty, &member.array);
                self.check_member(member, &ty);
                let index = fields.len() as u32;
                if instance.is_none() {
                    self.check_new(&member.name);
                    self.scopes.add(member.name.text.clone(), Symbol::Member(var, index));
                } else if fields.iter().any(|(other, _)| *other == member.name.text) {
                    let message = format!("a second member `{}`", member.name.text);
                    self.against(member.name.span, BLOCKS, message);
                } else {
                    self.check_reserved(&member.name);
                }
                fields.push((member.name.text.clone(), ty));
                precisions.push(precision);
                orders.push(order);
            }
        }
        if fields.is_empty() {
            self.against(name.span, BLOCKS, "a uniform block needs a member");
        }
        let structure = Struct::new(name.text.clone(), fields).with_precisions(precisions);
        if structure.scalars > MAX_SCALARS {
            let message = format!("the block has more than {MAX_SCALARS} components");
            self.against(name.span, BLOCKS, message);
        }
        let mut ty = Type::Struct(Arc::new(structure));
        let block = Block {
            name: name.text.clone(),
            is_named: instance.is_some(),
            packing: layout.packing,
            orders,
        };
        if let Some(instance) = instance {
            for size in instance.array.iter().rev() {
                ty = self.array_of(ty, size);
            }
            if ty.is_unsized() {
                let message = "an array of uniform blocks needs a size";
                self.against(instance.name.span, BLOCKS, message);
            }
            self.check_new(&instance.name);
            let members = InstanceMembers::Uniform(var);
            self.add_instance(&instance.name, &block.name, instance.array.len(), members);
        }
        let binding = qualifiers.iter().find_map(|&(qualifier, span)| {
            if let Qualifier::Binding(binding) = qualifier { Some((binding, span)) } else { None }
        });
        if let Some(binding) = binding {
            let instances = ty.scalars() / ty.base().scalars().max(1);
            self.check_block_binding(binding, instances);
        }
        let variable = self.variable_mut(var);
        variable.interface_qualifiers.binding = binding;
        variable.ty = ty;
        variable.block = Some(Arc::new(block));
    }

    /// Reports a type or qualifier that a member cannot have.
    fn check_member(&mut self, member: &ast::Declarator, ty: &Type) {
        let (name, span) = (&member.name.text, member.name.span);
        if member.init.is_some() {
            let message = format!("`{name}` takes no value: its buffer has it");
            self.against(span, BLOCKS, message);
        }
        if ty.has_sampler() {
            self.against(span, BLOCKS, format!("`{name}`: a uniform block has no samplers"));
        }
        if *ty == Type::Void {
            self.against(span, BLOCKS, format!("`{name}` cannot be void"));
        }
        if ty.is_unsized() {
            self.against(span, BLOCKS, format!("`{name}`: an array in a block needs a size"));
        }
    }

    /// A member of a block, as an expression.
    pub(super) fn member(&mut self, block: VarRef, index: u32, span: Span) -> Expr {
        self.note_use(block);
        let ty = self.variable(block).ty.clone();
        let Type::Struct(structure) = &ty else { return Expr::error(span) };
        let Some((_, member)) = structure.fields.get(index as usize) else {
            return Expr::error(span);
        };
        let member = member.clone();
        let kind = ExprKind::Var(block);
        let whole = Expr { ty, span, constant: false, kind };
        let kind = ExprKind::Field(Box::new(whole), index);
        Expr { ty: member, span, constant: false, kind }
    }

    /// Reports block layouts on other declarations.
    pub(super) fn no_block_layout(&mut self, words: &[(Qualifier, Span)]) {
        let layout = words.iter().find(|(word, _)| matches!(word, Qualifier::Block(_)));
        if let Some(&(_, span)) = layout {
            self.against(span, LAYOUTS, "only uniform blocks have this layout");
        }
    }
}
