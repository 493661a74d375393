//! Paths and calls in the tokens of macros, which `syn` does not parse.

use crate::sources::Written;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// What tokens name.
#[derive(Debug, PartialEq, Eq)]
pub enum Mention {
    /// A path of more than one segment.
    Path(Written),
    /// The call of a macro by a bare name, and the line.
    Macro(String, usize),
    /// The call of a method, and the line.
    Method(String, usize),
}

/// Reports everything that `tokens` name, in groups as well.
pub fn mentions(tokens: TokenStream, report: &mut impl FnMut(Mention)) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let is = |at: usize, character: char| matches!(tokens.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == character);
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Group(group) => mentions(group.stream(), report),
            TokenTree::Ident(first) => {
                let line = first.span().start().line;
                let begin = at;
                let mut segments = vec![first.to_string()];
                while is(at + 1, ':') && is(at + 2, ':') {
                    let Some(TokenTree::Ident(next)) = tokens.get(at + 3) else { break };
                    segments.push(next.to_string());
                    at += 3;
                }
                let is_before = |offset: usize, character| {
                    begin.checked_sub(offset).is_some_and(|before| is(before, character))
                };
                let begins_arguments = match tokens.get(at + 1) {
                    Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Parenthesis,
                    // A turbofish.
                    _ => is(at + 1, ':') && is(at + 2, ':') && is(at + 3, '<'),
                };
                // `..` is a range, not the dot of a method.
                let is_after_dot = is_before(1, '.') && !is_before(2, '.');
                let is_macro =
                    is(at + 1, '!') && matches!(tokens.get(at + 2), Some(TokenTree::Group(_)));
                // `::name` begins with another crate, `<T>::name` with a type.
                let is_outside = is_before(1, ':') && is_before(2, ':');
                if segments.len() > 1 {
                    if !is_outside {
                        report(Mention::Path(Written { segments, line }));
                    }
                } else if is_after_dot && begins_arguments {
                    report(Mention::Method(first.to_string(), line));
                } else if is_macro {
                    report(Mention::Macro(first.to_string(), line));
                }
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
        at += 1;
    }
}

/// Every identifier of `tokens`.
pub fn names(tokens: TokenStream) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => {
                found.insert(ident.to_string());
            }
            TokenTree::Group(group) => found.extend(names(group.stream())),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
    found
}

/// The identifiers that stand after the keyword of an item: what the expansion of a macro defines under a name of its
/// own.
pub fn defined(tokens: TokenStream) -> BTreeSet<String> {
    const KEYWORDS: &[&str] = &[
        "const",
        "enum",
        "fn",
        "macro_rules",
        "mod",
        "static",
        "struct",
        "trait",
        "type",
        "union",
    ];
    let mut found = BTreeSet::new();
    let mut is_after_keyword = false;
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => {
                let name = ident.to_string();
                let is_keyword = KEYWORDS.contains(&name.as_str());
                if is_after_keyword && !is_keyword {
                    found.insert(name);
                }
                is_after_keyword = is_keyword;
            }
            TokenTree::Group(group) => {
                found.extend(defined(group.stream()));
                is_after_keyword = false;
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => is_after_keyword = false,
        }
    }
    found
}
