//! The text of a shader, and positions in it.

/// Whether a byte ends a line.
pub fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// The length of the line end at the beginning: a carriage return, a line feed, or both in either
/// order, which are one line end (GLSL 1.30 section 3.1).
pub fn line_end(bytes: &[u8]) -> usize {
    match bytes {
        [b'\n', b'\r', ..] | [b'\r', b'\n', ..] => 2,
        [b'\n' | b'\r', ..] => 1,
        _ => 0,
    }
}

/// A range of bytes of the source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Span {
    /// Offset of the first byte.
    pub start: u32,
    /// Offset after the last byte.
    pub end: u32,
}

impl Span {
    /// From the start of `self` to the end of `other`.
    pub fn to(self, other: Self) -> Self {
        Self { start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// A position, as info logs show it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// The number of the string of `glShaderSource`, from 0, as renumbered by `#line`.
    pub string: i64,
    /// The line of the string, from 1, as renumbered by `#line`.
    pub line: i64,
    /// The column in characters, from 1.
    pub column: usize,
}

/// A `#line` directive, for the lines that follow.
#[derive(Clone, Copy, Debug)]
struct LineDirective {
    /// Index of the first line it holds for.
    first: usize,
    /// The number of that line.
    line: i64,
    /// The source string number.
    string: i64,
}

/// A shader's text with its lines.
#[derive(Clone, Debug)]
pub struct Source {
    text: String,
    /// Offset of the first byte of each line.
    lines: Vec<u32>,
    /// Offset of the first byte of each string but the first.
    strings: Vec<u32>,
    line_directives: Vec<LineDirective>,
}

impl Source {
    /// Finds the lines of `text`, which strings were joined to; `strings` has the offsets at which all but the first of
    /// them begin, in order.
    pub fn new(text: &str, strings: &[u32]) -> Self {
        let bytes = text.as_bytes();
        let mut lines = vec![0];
        let mut at = 0;
        while let Some(length) = bytes[at..].iter().position(|byte| is_line_end(*byte)) {
            at += length;
            at += line_end(&bytes[at..]);
            lines.push(at as u32);
        }
        let strings = strings.to_vec();
        Self { text: text.to_owned(), lines, strings, line_directives: Vec::new() }
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The text of a span.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.start as usize..span.end as usize).unwrap_or("")
    }

    /// The index of the line that holds a byte.
    pub fn line_index(&self, offset: u32) -> usize {
        self.lines.partition_point(|&start| start <= offset).saturating_sub(1)
    }

    /// The line that holds a byte, without its end, and the offset at which it begins.
    pub fn line_text(&self, offset: u32) -> (&str, u32) {
        let start = self.lines[self.line_index(offset)];
        let rest = &self.text[start as usize..];
        (rest.split(['\n', '\r']).next().unwrap_or(""), start)
    }

    /// How many strings begin at a byte or before it, without the first.
    fn strings_until(&self, offset: u32) -> usize {
        self.strings.partition_point(|&start| start <= offset)
    }

    /// The source string number and the line of a byte, as `#line` says. Lines are counted in each string, and strings
    /// after a `#line` from its string on (GLSL 1.30 section 3.3).
    pub fn line_of(&self, offset: u32) -> (i64, i64) {
        let index = self.line_index(offset);
        let string = self.strings_until(offset);
        let directive =
            self.line_directives.iter().rev().find(|directive| directive.first <= index);
        // What a `#line` at the end of a string says of the next line holds, whichever string that is in.
        let numbered =
            directive.map(|directive| (directive, self.strings_until(self.lines[directive.first])));
        match numbered {
            Some((directive, of)) if of == string => {
                (directive.string, directive.line.saturating_add((index - directive.first) as i64))
            }
            Some((directive, of)) => (
                directive.string.saturating_add((string - of) as i64),
                self.line_in_string(index, string),
            ),
            None => (string as i64, self.line_in_string(index, string)),
        }
    }

    /// The number of a line within a string, from 1.
    fn line_in_string(&self, index: usize, string: usize) -> i64 {
        let start = string.checked_sub(1).map_or(0, |before| self.strings[before]);
        (index - self.line_index(start)) as i64 + 1
    }

    /// The position of a byte, as `#line` says. Takes time proportional to the length of the line
    /// before it; use [`Source::line_of`] if no column is needed.
    pub fn position(&self, offset: u32) -> Position {
        let (text, start) = self.line_text(offset);
        let before = (offset - start) as usize;
        let column = 1 + text.char_indices().take_while(|&(at, _)| at < before).count();
        let (string, line) = self.line_of(offset);
        Position { string, line, column }
    }

    /// Applies a `#line`: the line after that of `directive` gets the number `line`.
    pub fn renumber(&mut self, directive: u32, line: i64, string: Option<i64>) {
        let string = string.unwrap_or_else(|| self.line_of(directive).0);
        let first = self.line_index(directive) + 1;
        self.line_directives.push(LineDirective { first, line, string });
    }
}
