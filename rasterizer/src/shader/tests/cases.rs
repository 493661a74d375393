//! Programs written by hand: control flow, arrays, derivatives, budgets, depth.
