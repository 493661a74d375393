//! The description of a texture's plan, which the texture unit writes in its own names, in GL's names.

use crate::base::compare::COMPARE;
use crate::base::constants::*;
use crate::base::error::Table;
use crate::objects::sampler::WRAP;
use crate::objects::target::TARGET;
use crate::pixel::formats::{format_name, stored_formats};
use std::fmt::Debug;

/// GL's name of the value that the texture unit calls `word`.
fn of_table<T: Copy + Debug>(table: &Table<T>, word: &str) -> Option<String> {
    let row = table.rows.iter().find(|row| format!("{:?}", row.1) == word)?;
    Some(enum_name(row.0))
}

/// GL's name of a word.
fn gl_name(word: &str) -> Option<String> {
    match word {
        "Nearest" => return Some("GL_NEAREST".to_owned()),
        "Linear" => return Some("GL_LINEAR".to_owned()),
        "None" => return Some("none".to_owned()),
        _ => {}
    }
    let of_format = || {
        let found = stored_formats().find(|format| format!("{format:?}") == word)?;
        Some(format_name(found))
    };
    of_table(&TARGET, word)
        .or_else(|| of_table(&WRAP, word))
        .or_else(|| of_table(&COMPARE, word))
        .or_else(of_format)
}

/// Puts GL's names in place of the texture unit's.
pub fn in_gl_names(description: &str) -> String {
    let words = description.split(' ').map(|word| {
        let (stem, rest) = word.split_at(word.trim_end_matches([',', ';']).len());
        match gl_name(stem) {
            Some(name) => name + rest,
            None => word.to_owned(),
        }
    });
    words.collect::<Vec<_>>().join(" ")
}
