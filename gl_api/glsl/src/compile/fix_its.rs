//! Compiling with fix-its: the suggested edits are applied to the text, round by round, until none
//! is left.

use super::{Compiled, Options, Pass, compile_once};
use crate::text::diagnostics::{Diagnostic, Edit, Severity};
use crate::text::source::Span;
use rasterizer::ir::Stage;

/// The maximum number of rounds: one edit can uncover another error.
const MAX_ROUNDS: usize = 8;

/// Compiles `text` and applies the fix-its of its diagnostics.
pub fn compile(stage: Stage, text: &str, strings: &[u32], options: &Options) -> Compiled {
    let (mut text, mut strings) = (text.to_owned(), strings.to_vec());
    let mut rounds: Vec<Vec<Edit>> = Vec::new();
    let mut repaired: Vec<Diagnostic> = Vec::new();
    let mut pass = compile_once(stage, &text, &strings, options);
    let original = pass.source.clone();
    while pass.log.has_errors() && rounds.len() < MAX_ROUNDS {
        let edits = applicable(&pass, &rounds, &mut repaired);
        if edits.is_empty() {
            break;
        }
        text = apply(&text, &edits);
        for string in &mut strings {
            *string = edited(*string, &edits);
        }
        rounds.push(edits);
        pass = compile_once(stage, &text, &strings, options);
    }
    repaired.sort_by_key(|warning| warning.span);
    let mut log: String = repaired.iter().map(|warning| warning.render(Some(&original))).collect();
    log.push_str(&pass.log.render(Some(&pass.source)));
    Compiled { shader: pass.shader(), log }
}

/// The edits of a pass, in order and disjoint, and the warnings that report them.
fn applicable(pass: &Pass, rounds: &[Vec<Edit>], repaired: &mut Vec<Diagnostic>) -> Vec<Edit> {
    let mut edits: Vec<Edit> = Vec::new();
    for item in &pass.log.items {
        let Some(suggestion) = &item.suggestion else { continue };
        let new = &suggestion.edits;
        let apart = |edit: &Edit| {
            edits.iter().all(|known| {
                let before = edit.span.end <= known.span.start;
                let after = known.span.end <= edit.span.start;
                edit.span != known.span && (before || after)
            })
        };
        if item.severity != Severity::Error || new.is_empty() || !new.iter().all(apart) {
            continue;
        }
        let span = item.span.unwrap_or_default();
        let span = Span { start: original(span.start, rounds), end: original(span.end, rounds) };
        let message = format!("repaired: {}", item.message);
        let mut warning = Diagnostic::warning(span, message);
        warning.rule.clone_from(&item.rule);
        repaired.push(warning.help(suggestion.text.clone()));
        edits.extend(new.iter().cloned());
    }
    edits.sort_by_key(|edit| edit.span);
    edits
}

fn apply(text: &str, edits: &[Edit]) -> String {
    let mut result = String::with_capacity(text.len() + 64);
    let mut at = 0;
    for edit in edits {
        result.push_str(text.get(at..edit.span.start as usize).unwrap_or(""));
        result.push_str(&edit.text);
        at = edit.span.end as usize;
    }
    result.push_str(text.get(at..).unwrap_or(""));
    result
}

/// The position in the edited text of an offset in the text before; that behind an edit which covers it.
fn edited(offset: u32, edits: &[Edit]) -> u32 {
    let mut grown = 0_i64;
    for edit in edits.iter().take_while(|edit| edit.span.start < offset) {
        let end = edit.span.end.max(offset);
        grown += edit.text.len() as i64 - i64::from(edit.span.end - edit.span.start);
        grown += i64::from(end - offset);
    }
    u32::try_from(i64::from(offset) + grown).unwrap_or(0)
}

/// The position in the original text of an offset in the edited text.
fn original(offset: u32, rounds: &[Vec<Edit>]) -> u32 {
    rounds.iter().rev().fold(offset, |offset, edits| {
        // How much longer the text before the offset has become.
        let mut grown = 0i64;
        for edit in edits {
            let start = i64::from(edit.span.start) + grown;
            let (new, old) =
                (edit.text.len() as i64, i64::from(edit.span.end) - i64::from(edit.span.start));
            if i64::from(offset) <= start {
                break;
            }
            if i64::from(offset) < start + new {
                return edit.span.start;
            }
            grown += new - old;
        }
        u32::try_from(i64::from(offset) - grown).unwrap_or(0)
    })
}
