//! Dead code elimination: values, stores, and empty control flow on which no output depends.
//!
//! Marks backwards from the outputs, the emitted vertices and the discards. A construct is needed when something needed
//! stands in it; then so are its condition, and every jump to its end. A loop that nothing leaves
//! is needed too, so that a program that cannot end still runs into its budget.

use crate::ir::{Block, Expr, Module, Stmt, Value, Var};

/// Runs the pass.
pub(super) fn run(module: &mut Module) {
    let mut marking = Marker {
        module,
        nodes: vec![Node::default()],
        writes: vec![Vec::new(); module.variables.len()],
        values: vec![false; module.values.len()],
        variables: vec![false; module.variables.len()],
        work: Vec::new(),
    };
    let mut roots = Roots::default();
    marking.build(&module.body, EnclosingNodes { node: 0, in_loop: 0, in_scope: 0 }, &mut roots);
    for at in 0..marking.nodes.len() {
        if marking.nodes[at].is_loop && !marking.nodes[at].is_left {
            roots.nodes.push(at);
        }
    }
    marking.work.extend(roots.nodes.into_iter().map(Item::Node));
    marking.work.extend(roots.values.into_iter().map(Item::Value));
    marking.work.extend(module.outputs.iter().map(|(_, var)| Item::Variable(*var)));
    marking.run();
    let Marker { nodes, values, variables, .. } = marking;
    let mut next = 1;
    let mut body = std::mem::take(&mut module.body);
    sweep(&mut body, &nodes, &values, &variables, &mut next);
    module.body = body;
}

/// An `If`, a `Loop` or a `Scope`; node 0 is the whole body. In program order.
#[derive(Default)]
struct Node {
    parent: usize,
    condition: Option<Value>,
    /// The nodes that contain a jump to the end of this one, or to its next iteration.
    jumps: Vec<usize>,
    is_loop: bool,
    /// Whether anything leaves the loop.
    is_left: bool,
    needed: bool,
    /// The node after the last inside.
    end: usize,
}

/// What is needed whatever else is: where statements with an effect stand, and what they read.
#[derive(Default)]
struct Roots {
    nodes: Vec<usize>,
    values: Vec<Value>,
}

/// A store.
#[derive(Clone, Copy)]
struct Write {
    value: Value,
    index: Option<Value>,
    node: usize,
}

enum Item {
    Node(usize),
    Value(Value),
    Variable(Var),
}

/// The nodes that enclose a statement; 0 for none.
#[derive(Clone, Copy)]
struct EnclosingNodes {
    node: usize,
    in_loop: usize,
    in_scope: usize,
}

struct Marker<'a> {
    module: &'a Module,
    nodes: Vec<Node>,
    /// By variable.
    writes: Vec<Vec<Write>>,
    /// By value: whether it is needed.
    values: Vec<bool>,
    /// By variable.
    variables: Vec<bool>,
    work: Vec<Item>,
}

impl Marker<'_> {
    fn open(&mut self, parent: usize, condition: Option<Value>) -> usize {
        self.nodes.push(Node { parent, condition, ..Node::default() });
        self.nodes.len() - 1
    }

    fn build(&mut self, block: &Block, around: EnclosingNodes, roots: &mut Roots) {
        let node = around.node;
        for stmt in block {
            match stmt {
                Stmt::Eval(_) => {}
                Stmt::Store { var, value } => {
                    self.writes[var.0 as usize].push(Write { value: *value, index: None, node });
                }
                Stmt::StoreAt { var, index, value } => {
                    let write = Write { value: *value, index: Some(*index), node };
                    self.writes[var.0 as usize].push(write);
                }
                Stmt::If { condition, accept, reject } => {
                    let inner = self.open(node, Some(*condition));
                    self.build(accept, EnclosingNodes { node: inner, ..around }, roots);
                    self.build(reject, EnclosingNodes { node: inner, ..around }, roots);
                    self.nodes[inner].end = self.nodes.len();
                }
                Stmt::Loop { body, continuing } => {
                    let inner = self.open(node, None);
                    self.nodes[inner].is_loop = true;
                    let around = EnclosingNodes { node: inner, in_loop: inner, ..around };
                    self.build(body, around, roots);
                    self.build(continuing, around, roots);
                    self.nodes[inner].end = self.nodes.len();
                }
                Stmt::Scope(body) => {
                    let inner = self.open(node, None);
                    self.build(
                        body,
                        EnclosingNodes { node: inner, in_scope: inner, ..around },
                        roots,
                    );
                    self.nodes[inner].end = self.nodes.len();
                }
                Stmt::Break => {
                    self.nodes[around.in_loop].jumps.push(node);
                    self.leave(node, around.in_loop);
                }
                Stmt::Continue => self.nodes[around.in_loop].jumps.push(node),
                Stmt::Leave => {
                    self.nodes[around.in_scope].jumps.push(node);
                    self.leave(node, around.in_scope);
                }
                Stmt::Discard => {
                    roots.nodes.push(node);
                    self.leave(node, 0);
                }
                Stmt::EmitVertex(values) => {
                    roots.nodes.push(node);
                    roots.values.extend(values);
                }
                Stmt::EndPrimitive => roots.nodes.push(node),
            }
        }
    }

    /// Marks the nodes from `from` out to `to` as left.
    fn leave(&mut self, from: usize, to: usize) {
        let mut at = from;
        while at != to {
            self.nodes[at].is_left = true;
            at = self.nodes[at].parent;
        }
        self.nodes[to].is_left = true;
    }

    fn run(&mut self) {
        while let Some(item) = self.work.pop() {
            match item {
                Item::Node(at) => {
                    let node = &mut self.nodes[at];
                    if !std::mem::replace(&mut node.needed, true) {
                        self.work.push(Item::Node(node.parent));
                        self.work.extend(node.condition.map(Item::Value));
                        self.work.extend(node.jumps.iter().copied().map(Item::Node));
                    }
                }
                Item::Value(value) => {
                    if !std::mem::replace(&mut self.values[value.0 as usize], true) {
                        let expr = self.module.expr(value);
                        expr.operands(|operand| self.work.push(Item::Value(operand)));
                        if let Expr::Load(var) | Expr::LoadAt { var, .. } = expr {
                            self.work.push(Item::Variable(*var));
                        }
                    }
                }
                Item::Variable(var) => {
                    if !std::mem::replace(&mut self.variables[var.0 as usize], true) {
                        for write in &self.writes[var.0 as usize] {
                            self.work.push(Item::Node(write.node));
                            self.work.push(Item::Value(write.value));
                            self.work.extend(write.index.map(Item::Value));
                        }
                    }
                }
            }
        }
    }
}

fn sweep(block: &mut Block, nodes: &[Node], values: &[bool], variables: &[bool], next: &mut usize) {
    block.retain_mut(|stmt| match stmt {
        Stmt::Eval(value) => values[value.0 as usize],
        Stmt::Store { var, .. } | Stmt::StoreAt { var, .. } => variables[var.0 as usize],
        Stmt::If { accept: a, reject: b, .. } | Stmt::Loop { body: a, continuing: b } => {
            let is_needed = enter(nodes, next);
            if is_needed {
                sweep(a, nodes, values, variables, next);
                sweep(b, nodes, values, variables, next);
            }
            is_needed
        }
        Stmt::Scope(body) => {
            let is_needed = enter(nodes, next);
            if is_needed {
                sweep(body, nodes, values, variables, next);
            }
            is_needed
        }
        Stmt::Break
        | Stmt::Continue
        | Stmt::Leave
        | Stmt::Discard
        | Stmt::EmitVertex(_)
        | Stmt::EndPrimitive => true,
    });
}

/// Moves to the first child of the next node if that is needed, else behind the node; returns whether it is needed.
fn enter(nodes: &[Node], next: &mut usize) -> bool {
    let node = &nodes[*next];
    *next = if node.needed { *next + 1 } else { node.end };
    node.needed
}
