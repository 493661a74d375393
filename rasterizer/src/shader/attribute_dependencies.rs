//! What an output of the vertex stage is made of: the components of attributes that it may depend
//! on. Where a draw has none of them in an array, the output is the same at every vertex, and needs
//! no plane.

use crate::ir::{Block, Expr, Input, Module, Output, Stage, Stmt, Value, Var};

/// What a value depends on besides what is the same in the whole draw: components of attributes,
/// bit by word; every bit where it depends on more, or is not known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct AttributeSet(u128);

impl AttributeSet {
    const NONE: Self = Self(0);
    const ANYTHING: Self = Self(!0);

    /// Some components of the attribute at a location, bit by component.
    pub fn attribute(location: u8, components: u8) -> Self {
        match u32::from(location) {
            location @ 0..32 => Self(u128::from(components & 0xF) << (4 * location)),
            _ => Self::ANYTHING,
        }
    }

    /// Both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether any of `self` is among `other`.
    pub fn meet(self, other: Self) -> bool {
        self == Self::ANYTHING || self.0 & other.0 != 0
    }
}

/// The sources of each output of a module, in their order. Those of a fragment program are not used,
/// which are not looked for.
pub(super) fn of_outputs(module: &Module) -> Vec<(Output, AttributeSet)> {
    if module.stage == Stage::Fragment {
        return module
            .outputs
            .iter()
            .map(|&(output, _)| (output, AttributeSet::ANYTHING))
            .collect();
    }
    let mut search = Search {
        module,
        values: vec![None; module.values.len()],
        variables: vec![AttributeSet::NONE; module.variables.len()],
    };
    // How often a loop turns is not followed.
    for stmt in &module.body {
        stmt.walk(&mut |stmt| {
            if let Stmt::Loop { .. } = stmt {
                stmt.walk(&mut |inside| {
                    if let Stmt::Store { var, .. } | Stmt::StoreAt { var, .. } = inside {
                        search.variables[var.0 as usize] = AttributeSet::ANYTHING;
                    }
                });
            }
        });
    }
    search.block(&module.body, AttributeSet::NONE);
    let of = |&(output, var): &(Output, Var)| (output, search.variables[var.0 as usize]);
    module.outputs.iter().map(of).collect()
}

struct Search<'a> {
    module: &'a Module,
    /// By value, where it has been evaluated.
    values: Vec<Option<AttributeSet>>,
    /// By variable, all that has been stored so far.
    variables: Vec<AttributeSet>,
}

impl Search<'_> {
    /// Follows a block that runs where `control` says.
    fn block(&mut self, block: &Block, mut control: AttributeSet) {
        for stmt in block {
            match stmt {
                Stmt::Eval(value) => {
                    self.values[value.0 as usize] = None;
                    self.value(*value);
                }
                Stmt::Store { var, value } => {
                    let stored = self.value(*value).and(control);
                    self.store(*var, stored);
                }
                Stmt::StoreAt { var, index, value } => {
                    let stored = self.value(*value).and(self.value(*index)).and(control);
                    self.store(*var, stored);
                }
                Stmt::If { condition, accept, reject } => {
                    let inside = self.value(*condition).and(control);
                    self.block(accept, inside);
                    self.block(reject, inside);
                }
                Stmt::Loop { body: inside, continuing } => {
                    self.block(inside, control);
                    self.block(continuing, control);
                }
                Stmt::Scope(body) => self.block(body, control),
                Stmt::EmitVertex(_) | Stmt::EndPrimitive => {}
                Stmt::Break | Stmt::Continue | Stmt::Leave | Stmt::Discard => return,
            }
            // Lanes that left from inside it do not run what follows.
            if !matches!(stmt, Stmt::Scope(_)) {
                stmt.walk(&mut |inside| {
                    if inside.is_jump() && *inside != Stmt::Break {
                        control = AttributeSet::ANYTHING;
                    }
                });
            }
        }
    }

    fn store(&mut self, var: Var, stored: AttributeSet) {
        let to = &mut self.variables[var.0 as usize];
        *to = to.and(stored);
    }

    fn value(&mut self, value: Value) -> AttributeSet {
        if let Some(known) = self.values[value.0 as usize] {
            return known;
        }
        let expr = self.module.expr(value);
        let mut sources = match expr {
            Expr::Input(Input::Attribute { location, component }) => {
                AttributeSet::attribute(*location, 1 << component)
            }
            Expr::Input(_) => AttributeSet::ANYTHING,
            Expr::Load(var) | Expr::LoadAt { var, .. } => self.variables[var.0 as usize],
            Expr::Const { .. }
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => AttributeSet::NONE,
        };
        expr.operands(|operand| sources = sources.and(self.value(operand)));
        self.values[value.0 as usize] = Some(sources);
        sources
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Builder, Op, Stage};

    fn words(locations: &[u8]) -> AttributeSet {
        let of =
            |sources: AttributeSet, &location| sources.and(AttributeSet::attribute(location, 0b10));
        locations.iter().fold(AttributeSet::NONE, of)
    }

    #[test]
    fn outputs_depend_on_what_is_stored_and_on_the_branches_around() {
        let mut b = Builder::new(Stage::Vertex);
        let [first, second, third] = [0, 1, 2].map(|slot| b.output(Output::Varying(slot)));
        let [x, y, z] =
            [3, 4, 5].map(|location| b.input(Input::Attribute { location, component: 1 }));
        let (one, sum) = (b.float(1.0), b.op(Op::Add, &[x, y]));
        let positive = b.op(Op::Less, &[one, z]);
        for (var, value) in [(first, one), (second, sum), (third, one)] {
            b.store(var, value);
        }
        let mut module = b.finish();
        let branch = |accept| Stmt::If { condition: positive, accept, reject: Vec::new() };
        let sources = |module: &Module| of_outputs(module).into_iter().map(|(_, s)| s);

        module.body.push(branch(vec![Stmt::Store { var: third, value: x }]));
        assert!(sources(&module).eq([words(&[]), words(&[3, 4]), words(&[3, 5])]));

        // What a loop stores, and what some lanes do not reach, is not followed.
        let store = Stmt::Store { var: first, value: one };
        let mut looping = module.clone();
        let body = vec![store.clone(), Stmt::Break];
        looping.body.push(Stmt::Loop { body, continuing: Vec::new() });
        assert_eq!(sources(&looping).next(), Some(AttributeSet::ANYTHING));
        module.body.push(Stmt::Scope(vec![branch(vec![Stmt::Leave]), store]));
        assert_eq!(sources(&module).next(), Some(AttributeSet::ANYTHING));
        assert_eq!(sources(&module).nth(1), Some(words(&[3, 4])));
    }

    #[test]
    fn sources_meet_where_they_share_a_component() {
        let both = words(&[3, 4]);
        assert!(both.meet(words(&[4])) && !both.meet(words(&[5])));
        assert!(!both.meet(AttributeSet::attribute(3, 0b1101)));
        assert!(AttributeSet::ANYTHING.meet(AttributeSet::NONE) && !AttributeSet::NONE.meet(both));
        assert_eq!(AttributeSet::attribute(32, 1), AttributeSet::ANYTHING);
    }
}
