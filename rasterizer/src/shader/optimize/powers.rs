//! Powers with constant exponents, as gamma curves have them, by a table each.

use crate::ir::{Expr, FunctionTable, Module, Op};

/// Runs the pass. It looks at constants of the module as it was built alone, so that what a power is does not depend on
/// what other passes find out.
pub(super) fn run(module: &mut Module) {
    let mut tables: Vec<(u32, Option<FunctionTable>)> = Vec::new();
    for at in 0..module.values.len() {
        let Expr::Op { op: Op::Pow, args: [value, exponent, _] } = module.values[at] else {
            continue;
        };
        let Some(exponent) = module.constant(exponent) else { continue };
        let known = tables.iter().find(|(of, _)| *of == exponent);
        let table = match known {
            Some((_, table)) => table.clone(),
            None => {
                let table = FunctionTable::power(exponent);
                tables.push((exponent, table.clone()));
                table
            }
        };
        if let Some(table) = table {
            module.values[at] = Expr::Tabulated { value, table };
        }
    }
}
