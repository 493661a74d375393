//! Text to tokens (GLSL 1.30 chapter 3): removes comments and line continuations. Characters that
//! are no part of the language become tokens too, because the preprocessor may skip them.

use crate::text::source::{Span, is_line_end, line_end};
use std::sync::Arc;

/// What a token is.
#[derive(Clone, Debug, PartialEq)]
pub enum TokenKind {
    /// An identifier or keyword.
    Word(Arc<str>),
    /// A number as written, checked when it is used.
    Number(Arc<str>),
    /// An operator or other punctuation.
    Punct(&'static str),
    /// A character that is no part of the language.
    Stray(char),
    /// The end of a line. Only the preprocessor sees it.
    Newline,
    /// The end of the text.
    End,
}

/// A token and its span.
#[derive(Clone, Debug)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Its span; in the result of a macro, that of the macro call.
    pub span: Span,
}

impl Token {
    /// Whether it is this punctuation.
    pub fn is(&self, punct: &str) -> bool {
        matches!(self.kind, TokenKind::Punct(p) if p == punct)
    }

    /// The word, if it is one.
    pub fn word(&self) -> Option<&Arc<str>> {
        match &self.kind {
            TokenKind::Word(word) => Some(word),
            TokenKind::Number(_)
            | TokenKind::Punct(_)
            | TokenKind::Stray(_)
            | TokenKind::Newline
            | TokenKind::End => None,
        }
    }

    /// Its description in messages.
    pub fn describe(&self) -> String {
        match &self.kind {
            TokenKind::Word(word) | TokenKind::Number(word) => {
                let short: String = word.chars().take(40).collect();
                format!("`{short}`")
            }
            TokenKind::Punct(punct) => format!("`{punct}`"),
            TokenKind::Stray(c) if c.is_ascii_graphic() => format!("the character `{c}`"),
            TokenKind::Stray(c) => format!("the character U+{:04X}", u32::from(*c)),
            TokenKind::Newline => "the end of the line".to_owned(),
            TokenKind::End => "the end of the shader".to_owned(),
        }
    }
}

/// Every punctuation, longer ones before their prefixes.
const PUNCTUATION: [&str; 47] = [
    "<<=", ">>=", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "^^", "*=", "/=", "+=", "-=",
    "%=", "&=", "^=", "|=", "<<", ">>", "##", "(", ")", "[", "]", "{", "}", ".", ",", ";", ":",
    "?", "=", "+", "-", "*", "/", "%", "<", ">", "!", "~", "&", "|", "^", "#",
];

/// The tokens of a text, and what is notable about it.
#[derive(Debug, Default)]
pub struct Lexed {
    /// Its tokens; the last is [`TokenKind::End`].
    pub tokens: Vec<Token>,
    /// The begin of a comment that is not closed.
    pub unclosed: Option<Span>,
    /// The first line continuation.
    pub continued: Option<Span>,
    /// The first U+0000 after the last token.
    pub terminator: Option<Span>,
}

/// Splits a text into tokens.
pub fn tokens(text: &str) -> Lexed {
    let blank = |c: char| c == '\0' || c.is_ascii_whitespace();
    let ended = text.trim_end_matches(blank).len();
    let terminator = text[ended..].find('\0').map(|at| {
        let start = (ended + at) as u32;
        Span { start, end: start + 1 }
    });
    let bytes = text.as_bytes();
    let mut tokens = Vec::new();
    let (mut unclosed, mut continued) = (None, None);
    let mut at = 0;
    while at < bytes.len() {
        let start = at;
        let kind = match bytes[at] {
            b'\n' | b'\r' => {
                at += line_end(&bytes[at..]);
                Some(TokenKind::Newline)
            }
            b' ' | b'\t' | 0x0b | 0x0c => {
                at += 1;
                None
            }
            b'\0' if at >= ended => {
                at += 1;
                None
            }
            b'\\' if line_end(&bytes[at + 1..]) > 0 => {
                continued = continued.or(Some(Span { start: at as u32, end: at as u32 + 1 }));
                at += 1 + line_end(&bytes[at + 1..]);
                None
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                at += bytes[at..].iter().position(|b| is_line_end(*b)).unwrap_or(bytes.len() - at);
                None
            }
            b'/' if bytes.get(at + 1) == Some(&b'*') => {
                match text[at + 2..].find("*/") {
                    Some(length) => at += length + 4,
                    None => {
                        at = bytes.len();
                        let span = Span { start: start as u32, end: start as u32 + 2 };
                        unclosed = Some(span);
                    }
                }
                None
            }
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => {
                let more = |b: &u8| !(b.is_ascii_alphanumeric() || *b == b'_');
                at += bytes[at..].iter().position(more).unwrap_or(bytes.len() - at);
                Some(TokenKind::Word(text[start..at].into()))
            }
            b'0'..=b'9' => {
                at = number_end(bytes, at);
                Some(TokenKind::Number(text[start..at].into()))
            }
            b'.' if bytes.get(at + 1).is_some_and(u8::is_ascii_digit) => {
                at = number_end(bytes, at);
                Some(TokenKind::Number(text[start..at].into()))
            }
            _ => match PUNCTUATION.iter().find(|punct| text[at..].starts_with(**punct)) {
                Some(punct) => {
                    at += punct.len();
                    Some(TokenKind::Punct(punct))
                }
                None => {
                    let c = text[at..].chars().next().unwrap_or(' ');
                    at += c.len_utf8();
                    Some(TokenKind::Stray(c))
                }
            },
        };
        if let Some(kind) = kind {
            tokens.push(Token { kind, span: Span { start: start as u32, end: at as u32 } });
        }
    }
    let end = text.len() as u32;
    tokens.push(Token { kind: TokenKind::Newline, span: Span { start: end, end } });
    tokens.push(Token { kind: TokenKind::End, span: Span { start: end, end } });
    Lexed { tokens, unclosed, continued, terminator }
}

/// Splits a text into tokens after each line that ends in a backslash is joined with the next one. The spans are those
/// of the text as it is.
pub fn spliced_tokens(text: &str) -> Lexed {
    let bytes = text.as_bytes();
    let mut joined = String::with_capacity(text.len());
    // The offsets in the joined text from which on so many bytes were left out before.
    let mut left_out: Vec<(u32, u32)> = vec![(0, 0)];
    let mut from = 0;
    for (at, _) in text.match_indices('\\') {
        let end = line_end(&bytes[at + 1..]);
        if end > 0 {
            joined.push_str(&text[from..at]);
            from = at + 1 + end;
            left_out.push((joined.len() as u32, (from - joined.len()) as u32));
        }
    }
    joined.push_str(&text[from..]);
    let original = |offset: u32| {
        let index = left_out.partition_point(|&(first, _)| first <= offset);
        offset + left_out[index - 1].1
    };
    let of = |span: Span| Span { start: original(span.start), end: original(span.end) };
    let mut lexed = tokens(&joined);
    for token in &mut lexed.tokens {
        token.span = of(token.span);
    }
    lexed.unclosed = lexed.unclosed.map(of);
    lexed.terminator = lexed.terminator.map(of);
    lexed
}

/// The end of a number: digits, letters, points, and signs after an exponent letter, as in C.
fn number_end(bytes: &[u8], mut at: usize) -> usize {
    let hexadecimal = bytes[at] == b'0' && matches!(bytes.get(at + 1), Some(b'x' | b'X'));
    while let Some(&byte) = bytes.get(at) {
        let sign = matches!(byte, b'+' | b'-');
        let exponent = at > 0 && matches!(bytes[at - 1], b'e' | b'E') && !hexadecimal;
        if !(byte.is_ascii_alphanumeric() || byte == b'.' || byte == b'_' || sign && exponent) {
            break;
        }
        at += 1;
    }
    at
}

/// The value of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Literal {
    /// A signed integer (its bits may come from an unsigned hexadecimal).
    Int(i32),
    /// With the suffix `u`.
    Uint(u32),
    /// With a point or an exponent; the suffix `f` may follow.
    Float(f32),
}

/// Parses a number; the error says what is wrong with it.
pub fn literal(text: &str) -> Result<Literal, &'static str> {
    let hexadecimal = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
    let is_float = hexadecimal.is_none() && text.contains(['.', 'e', 'E', 'f', 'F']);
    if is_float {
        let digits = text.strip_suffix(['f', 'F']).unwrap_or(text);
        let plain = digits.bytes().all(|b| b.is_ascii_digit() || b".eE+-".contains(&b));
        let has_digit = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        if plain && !digits.contains(['.', 'e', 'E']) {
            return Err("a whole number, which takes no `f`");
        }
        let value = if plain && has_digit { digits.parse::<f32>().ok() } else { None };
        return value.map(Literal::Float).ok_or("not a floating-point number");
    }
    let (digits, unsigned) = match hexadecimal.unwrap_or(text).strip_suffix(['u', 'U']) {
        Some(digits) => (digits, true),
        None => (hexadecimal.unwrap_or(text), false),
    };
    let radix = if hexadecimal.is_some() {
        16
    } else if digits.len() > 1 && digits.starts_with('0') {
        8
    } else {
        10
    };
    if digits.is_empty() || !digits.chars().all(|c| c.is_digit(radix)) {
        return Err("not a number");
    }
    let bits = u32::from_str_radix(digits, radix).map_err(|_| "too large for 32 bits")?;
    Ok(if unsigned { Literal::Uint(bits) } else { Literal::Int(bits as i32) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals() {
        let table: &[(&str, Result<Literal, &str>)] = &[
            ("10", Ok(Literal::Int(10))),
            ("010", Ok(Literal::Int(8))),
            ("0xFFFFFFFF", Ok(Literal::Int(-1))),
            ("3u", Ok(Literal::Uint(3))),
            (".5", Ok(Literal::Float(0.5))),
            ("1.", Ok(Literal::Float(1.0))),
            ("2e-1", Ok(Literal::Float(0.2))),
            ("1.5f", Ok(Literal::Float(1.5))),
            ("089", Err("not a number")),
            ("12ab", Err("not a number")),
            ("1.2.3", Err("not a floating-point number")),
            ("1f", Err("a whole number, which takes no `f`")),
            ("99999999999", Err("too large for 32 bits")),
        ];
        for (text, expected) in table {
            assert_eq!(literal(text), *expected, "{text}");
        }
    }
}
