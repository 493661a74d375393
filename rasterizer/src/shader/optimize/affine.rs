//! What fragments make of smooth varyings by sums, and by products with and quotients by what is the same in the whole
//! draw, moves to the vertices: an affine map of interpolated values is the map's values, interpolated.
//!
//! Of the varyings that such maps share, all move or none: they do where that makes no more scalars to interpolate than
//! there were. A projective shadow's `gl_TextureMatrix[0] * vec4(object, 1)` then costs a fragment nothing.

use super::super::Facts;
use super::{dead, simplify};
use crate::ir::{
    Builder, Expr, Input, Interpolation, Module, Op, Output, Stmt, Ty, Value, Var, Variable,
};

/// Moves maps of the fragment module: gives the vertex module with what it then brings, if there is any.
pub fn hoist_to_vertex(vertex: &Module, fragment: &mut Module) -> Option<Module> {
    let groups = Search::new(fragment).groups();
    let written = |slot: u16| {
        let mut outputs = vertex.outputs.iter();
        outputs.find(|(output, _)| *output == Output::Varying(slot)).map(|&(_, var)| var)
    };
    let mut hoisting = Hoisting {
        copies: vec![None; fragment.values.len()],
        next: first_free(fragment, vertex),
        vertex: None,
    };
    for group in groups {
        let sources: Option<Vec<Var>> = group.slots.iter().map(|&slot| written(slot)).collect();
        if let Some(sources) = sources.filter(|_| group.is_profitable()) {
            hoisting.group(fragment, vertex, &group, &sources);
        }
    }
    let vertex = hoisting.vertex?.finish();
    simplify::run(fragment, &Facts::NONE);
    dead::run(fragment);
    Some(vertex)
}

/// The first slot that neither stage knows.
fn first_free(fragment: &Module, vertex: &Module) -> u16 {
    let written = vertex.outputs.iter().filter_map(|(output, _)| match output {
        Output::Varying(slot) => Some(slot + 1),
        Output::Position(_)
        | Output::PointSize
        | Output::ClipDistance(_)
        | Output::CullDistance(_)
        | Output::Color { .. }
        | Output::SecondColor(_)
        | Output::Depth
        | Output::StencilReference
        | Output::SampleMask
        | Output::Layer
        | Output::PrimitiveId
        | Output::ViewportIndex => None,
    });
    let own = fragment.primitive_id.map(|first| first + 2);
    written.chain(own).fold(fragment.varyings.len() as u16, u16::max)
}

/// The class of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ValueClass {
    /// Uniform over the draw.
    Uniform,
    /// An affine map of smooth varyings.
    Affine,
    /// Anything else.
    Other,
}

/// Affine maps that share varyings.
#[derive(Default)]
struct MapGroup {
    slots: Vec<u16>,
    /// The number of slots that are also read by other expressions.
    still_read: usize,
    /// The maps that other expressions read.
    maps: Vec<Value>,
}

impl MapGroup {
    /// Whether hoisting does not increase the number of interpolated scalars.
    fn is_profitable(&self) -> bool {
        !self.maps.is_empty() && self.maps.len() <= self.slots.len() - self.still_read
    }
}

/// How many operations deep a map is followed.
const DEPTH: u8 = 64;

struct Search<'a> {
    module: &'a Module,
    /// By value, as far as it has been evaluated.
    classes: Vec<ValueClass>,
    /// How many operations deep each is.
    depths: Vec<u8>,
    /// Of each map, a slot that it reads.
    slots: Vec<u16>,
    /// By value: whether it is a map that anything else is made of.
    is_read: Vec<bool>,
    varyings: Vec<Varying>,
}

/// A varying of the fragment module.
#[derive(Clone, Copy)]
struct Varying {
    /// Of those that it shares maps with, the next on the way to the one that stands for all.
    parent: u16,
    /// Whether a map reads it.
    is_mapped: bool,
    /// Whether another expression reads it.
    is_read_directly: bool,
}

impl<'a> Search<'a> {
    fn new(module: &'a Module) -> Self {
        let slots = 0..module.varyings.len() as u16;
        let varying = |slot| Varying { parent: slot, is_mapped: false, is_read_directly: false };
        let mut search = Self {
            module,
            classes: vec![ValueClass::Other; module.values.len()],
            depths: vec![0; module.values.len()],
            slots: vec![0; module.values.len()],
            is_read: vec![false; module.values.len()],
            varyings: slots.map(varying).collect(),
        };
        for (at, expr) in module.values.iter().enumerate() {
            match expr {
                Expr::Const { ty, .. } | Expr::Uniform { ty, .. } => {
                    if *ty == Ty::F32 {
                        search.classes[at] = ValueClass::Uniform;
                    }
                }
                Expr::Input(Input::Varying(slot)) => {
                    if search.is_smooth(*slot) {
                        search.classes[at] = ValueClass::Affine;
                        search.slots[at] = *slot;
                    }
                }
                // Other values are classified where they are evaluated, or not at all.
                Expr::Input(_)
                | Expr::UniformAt { .. }
                | Expr::Load(_)
                | Expr::LoadAt { .. }
                | Expr::Op { .. }
                | Expr::Derivative { .. }
                | Expr::Tabulated { .. }
                | Expr::Sample(_)
                | Expr::Component { .. } => {}
            }
        }
        module.body.iter().for_each(|stmt| stmt.walk(&mut |stmt| search.statement(stmt)));
        search
    }

    /// Whether a varying is interpolated at the pixel's centre, in perspective.
    fn is_smooth(&self, slot: u16) -> bool {
        self.module.varyings.get(usize::from(slot)) == Some(&Interpolation::Smooth)
            && !self.module.centroids.contains(&slot)
    }

    fn statement(&mut self, stmt: &Stmt) {
        match stmt {
            Stmt::Eval(value) => self.evaluate(*value),
            Stmt::Store { value, .. } => self.read(*value),
            Stmt::StoreAt { value, .. } => self.read(*value),
            // Conditions and indices are no numbers of this kind.
            Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope(_)
            | Stmt::Break
            | Stmt::Continue
            | Stmt::Leave
            | Stmt::Discard
            | Stmt::EmitVertex(_)
            | Stmt::EndPrimitive => {}
        }
    }

    fn evaluate(&mut self, value: Value) {
        let at = value.0 as usize;
        let expr = self.module.expr(value);
        self.classes[at] = self.class_of(expr);
        expr.operands(|operand| {
            self.depths[at] = self.depths[at].max(self.depths[operand.0 as usize] + 1);
        });
        if self.depths[at] >= DEPTH {
            self.classes[at] = ValueClass::Other;
        }
        if self.classes[at] != ValueClass::Affine {
            self.depths[at] =
                if self.classes[at] == ValueClass::Uniform { self.depths[at] } else { 0 };
            expr.operands(|operand| self.read(operand));
            return;
        }
        let mut own = None;
        expr.operands(|operand| {
            let from = operand.0 as usize;
            if self.classes[from] == ValueClass::Affine {
                let slot = self.slots[from];
                self.varyings[usize::from(slot)].is_mapped = true;
                let first = *own.get_or_insert(slot);
                self.join(first, slot);
            }
        });
        self.slots[at] = own.unwrap_or(0);
    }

    fn class_of(&self, expr: &Expr) -> ValueClass {
        let Expr::Op { op, args: [a, b, _] } = *expr else { return ValueClass::Other };
        let of = |value: Value| self.classes[value.0 as usize];
        match (op, of(a), of(b)) {
            (Op::Neg, of_a, _) => of_a,
            (Op::Add | Op::Sub | Op::Mul | Op::Div, ValueClass::Uniform, ValueClass::Uniform) => {
                ValueClass::Uniform
            }
            (
                Op::Add | Op::Sub,
                ValueClass::Uniform | ValueClass::Affine,
                ValueClass::Uniform | ValueClass::Affine,
            )
            | (Op::Mul | Op::Div, ValueClass::Affine, ValueClass::Uniform)
            | (Op::Mul, ValueClass::Uniform, ValueClass::Affine) => ValueClass::Affine,
            _ => ValueClass::Other,
        }
    }

    /// Notes that something that is no map reads `value`.
    fn read(&mut self, value: Value) {
        let at = value.0 as usize;
        match (self.classes[at], self.module.expr(value)) {
            (ValueClass::Affine, Expr::Input(_)) => {
                self.varyings[usize::from(self.slots[at])].is_read_directly = true;
            }
            (ValueClass::Affine, _) => self.is_read[at] = true,
            (ValueClass::Uniform | ValueClass::Other, _) => {}
        }
    }

    /// The slot that stands for all that share maps with this one.
    fn root(&self, slot: u16) -> u16 {
        let mut at = slot;
        while self.varyings[usize::from(at)].parent != at {
            at = self.varyings[usize::from(at)].parent;
        }
        at
    }

    fn join(&mut self, a: u16, b: u16) {
        let (a, b) = (self.root(a), self.root(b));
        self.varyings[usize::from(a.max(b))].parent = a.min(b);
    }

    /// The maps that anything else is made of, by the varyings that they share.
    fn groups(&self) -> Vec<MapGroup> {
        let mut groups: Vec<MapGroup> = Vec::new();
        groups.resize_with(self.varyings.len(), MapGroup::default);
        for (slot, varying) in self.varyings.iter().enumerate().filter(|(_, v)| v.is_mapped) {
            let group = &mut groups[usize::from(self.root(slot as u16))];
            group.slots.push(slot as u16);
            group.still_read += usize::from(varying.is_read_directly);
        }
        for (at, _) in self.is_read.iter().enumerate().filter(|(_, is_read)| **is_read) {
            groups[usize::from(self.root(self.slots[at]))].maps.push(Value(at as u32));
        }
        groups
    }
}

struct Hoisting {
    /// By value of the fragment module: the vertex module's, once it has it.
    copies: Vec<Option<Value>>,
    /// The slot of the next varying.
    next: u16,
    /// The vertex module so far, from the first map on.
    vertex: Option<Builder>,
}

impl Hoisting {
    /// Moves a group, whose varyings the vertex module leaves in `sources`.
    fn group(&mut self, fragment: &mut Module, vertex: &Module, group: &MapGroup, sources: &[Var]) {
        let builder = self.vertex.get_or_insert_with(|| Builder::resume(vertex.clone()));
        let words = &mut builder.module_mut().uniform_words;
        *words = fragment.uniform_words.max(*words);
        for map in &group.maps {
            let slot = self.next;
            self.next += 1;
            let source = |of: u16| {
                let at = group.slots.iter().position(|&slot| slot == of)?;
                sources.get(at).copied()
            };
            let copy = copied(fragment, *map, builder, &mut self.copies, &source);
            let variables = &mut builder.module_mut().variables;
            let var = Var(variables.len() as u32);
            variables.push(Variable { ty: Ty::F32, len: 1, name: format!("varying {slot}") });
            builder.push(Stmt::Store { var, value: copy });
            builder.module_mut().outputs.push((Output::Varying(slot), var));
            let varyings = &mut fragment.varyings;
            varyings.resize(varyings.len().max(usize::from(slot) + 1), Interpolation::Smooth);
            fragment.values[map.0 as usize] = Expr::Input(Input::Varying(slot));
        }
    }
}

/// A map of the fragment module, made in the vertex module.
fn copied(
    fragment: &Module,
    value: Value,
    vertex: &mut Builder,
    copies: &mut [Option<Value>],
    source: &impl Fn(u16) -> Option<Var>,
) -> Value {
    if let Some(copy) = copies[value.0 as usize] {
        return copy;
    }
    let expr = match fragment.expr(value) {
        Expr::Input(Input::Varying(slot)) => {
            source(*slot).map_or_else(|| Expr::Input(Input::Varying(*slot)), Expr::Load)
        }
        expr => expr.map(&mut |operand| copied(fragment, operand, vertex, copies, source)),
    };
    let copy = vertex.value(expr);
    copies[value.0 as usize] = Some(copy);
    copy
}
