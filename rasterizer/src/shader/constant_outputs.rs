//! Outputs that are 1 in every lane, whatever a draw's inputs are.

use crate::ir::{Module, Output, Stmt, Var};

/// The bits of 1.
const ONE: u32 = 0x3f80_0000;

/// The outputs of a module to which nothing but 1 is written, and that in every lane.
pub(super) fn ones(module: &Module) -> Vec<Output> {
    let any = |is: &dyn Fn(&Stmt) -> bool| {
        let mut found = false;
        module.body.iter().for_each(|stmt| stmt.walk(&mut |stmt| found |= is(stmt)));
        found
    };
    // Lanes that leave early may not come to the store.
    if any(&|stmt| matches!(stmt, Stmt::Leave)) {
        return Vec::new();
    }
    let is_one = |var: Var| {
        let stores = |stmt: &Stmt, one: bool| {
            let Stmt::Store { var: of, value } = stmt else { return false };
            *of == var && (module.constant(*value) == Some(ONE)) == one
        };
        let stores_else = |stmt: &Stmt| {
            stores(stmt, false) || matches!(stmt, Stmt::StoreAt { var: of, .. } if *of == var)
        };
        module.body.iter().any(|stmt| stores(stmt, true)) && !any(&stores_else)
    };
    let outputs = module.outputs.iter();
    outputs.filter(|(_, var)| is_one(*var)).map(|(output, _)| *output).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Builder, Input, Stage};

    #[test]
    fn an_output_is_one_where_all_that_is_stored_is() {
        let mut b = Builder::new(Stage::Fragment);
        let outputs = [0, 1, 2].map(|component| Output::Color { target: 0, component });
        let vars = outputs.map(|output| b.output(output));
        let one = b.float(1.0);
        let zero = b.float(0.0);
        let input = b.input(Input::Varying(0));
        b.store(vars[0], one);
        b.store(vars[1], input);
        b.store(vars[1], one);
        b.store(vars[2], zero);
        assert_eq!(ones(&b.finish()), [outputs[0]]);
    }
}
