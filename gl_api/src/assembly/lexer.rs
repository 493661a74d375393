//! Text to tokens, each with the byte where it begins: `GL_PROGRAM_ERROR_POSITION_ARB` counts bytes
//! (ARB_vertex_program, section 2.14.2).

use super::Failure;

/// A token.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Token<'a> {
    /// A word, and a texture target such as `2D`.
    Word(&'a str),
    /// A whole number.
    Integer(u32),
    /// A number with a point or an exponent.
    Float(f32),
    /// One of `; , . [ ] { } ( ) = + - |`, or any other character.
    Mark(char),
    /// `..`.
    Range,
    /// The end of the text.
    End,
}

/// A token and where it begins.
pub(crate) type Placed<'a> = (Token<'a>, usize);

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'$'
}

/// How many bytes from `at` on fulfil a condition.
fn run(text: &[u8], at: usize, is: impl Fn(u8) -> bool) -> usize {
    text[at..].iter().take_while(|&&byte| is(byte)).count()
}

/// Where a number ends that begins at `at`, and whether it has a point or an exponent.
fn number(text: &[u8], at: usize) -> (usize, bool) {
    let digit = |byte: u8| byte.is_ascii_digit();
    let mut end = at + run(text, at, digit);
    let mut fraction = false;
    // Of `0..3` the point is none of the number's.
    if text.get(end) == Some(&b'.') && text.get(end + 1) != Some(&b'.') {
        end += 1 + run(text, end + 1, digit);
        fraction = true;
    }
    if matches!(text.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(text.get(end + 1), Some(b'+' | b'-')));
        let first = (end + 1 + sign).min(text.len());
        let digits = run(text, first, digit);
        if digits > 0 {
            end = first + digits;
            fraction = true;
        }
    }
    (end, fraction)
}

/// All tokens of a program behind its first line's `!!ARBvp1.0`, which is `start` bytes long.
pub(crate) fn tokens(text: &str, start: usize) -> Result<Vec<Placed<'_>>, Failure> {
    let bytes = text.as_bytes();
    let mut tokens = Vec::new();
    let mut at = start;
    while let Some(&byte) = bytes.get(at) {
        let next = bytes.get(at + 1).copied().unwrap_or(0);
        let begins_number = byte.is_ascii_digit() || byte == b'.' && next.is_ascii_digit();
        let (token, end) = match byte {
            b' ' | b'\t' | b'\r' | b'\n' | 0x0b | 0x0c => {
                at += 1;
                continue;
            }
            b'#' => {
                at += run(bytes, at, |byte| byte != b'\n' && byte != b'\r');
                continue;
            }
            b'1'..=b'3' if next == b'D' => (Token::Word(&text[at..at + 2]), at + 2),
            _ if begins_number => {
                let (end, fraction) = number(bytes, at);
                let written = &text[at..end];
                let token = match written.parse() {
                    Ok(value) if !fraction => Token::Integer(value),
                    Ok(_) | Err(_) => match written.parse() {
                        Ok(value) => Token::Float(value),
                        Err(_) => return Failure::at(at, format!("{written} is no number")),
                    },
                };
                (token, end)
            }
            _ if is_word(byte) => {
                let end = at + run(bytes, at, is_word);
                (Token::Word(&text[at..end]), end)
            }
            b'.' if next == b'.' => (Token::Range, at + 2),
            _ => {
                let mark = text[at..].chars().next().unwrap_or(' ');
                (Token::Mark(mark), at + mark.len_utf8())
            }
        };
        tokens.push((token, at));
        at = end;
    }
    tokens.push((Token::End, text.len()));
    Ok(tokens)
}
