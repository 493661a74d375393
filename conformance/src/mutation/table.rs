//! The list of mistakes, each with a description and the check that must fail.

mod programs;
mod raster;
mod sampling;
mod transfers;

use super::variant::Mutation;

/// A mistake, and the check that must fail.
#[derive(Clone, Copy, Debug)]
pub struct MutationRow {
    /// The mistake.
    pub mutation: Mutation,
    /// The name of the check.
    pub check: &'static str,
    /// A description of the mistake.
    pub what: &'static str,
}

const fn row(mutation: Mutation, check: &'static str, what: &'static str) -> MutationRow {
    MutationRow { mutation, check, what }
}

const PARTS: [&[MutationRow]; 4] = [sampling::ROWS, raster::ROWS, transfers::ROWS, programs::ROWS];

const COUNT: usize = {
    let (mut count, mut part) = (0, 0);
    while part < PARTS.len() {
        count += PARTS[part].len();
        part += 1;
    }
    count
};

/// All mistakes.
pub const MUTATIONS: &[MutationRow] = &{
    let mut all = [PARTS[0][0]; COUNT];
    let (mut count, mut part) = (0, 0);
    while part < PARTS.len() {
        let mut row = 0;
        while row < PARTS[part].len() {
            all[count] = PARTS[part][row];
            (count, row) = (count + 1, row + 1);
        }
        part += 1;
    }
    all
};
