//! A file's text with mistakes.

use crate::choice::Mutant;
use std::ops::Range;

/// A file with mistakes.
#[derive(Clone, Debug, Default)]
pub struct Rewritten {
    /// The text.
    pub text: String,
    /// The bytes of it that replace an expression, and its mistakes; the inner ones after those around.
    pub parts: Vec<(Range<usize>, Vec<u32>)>,
}

impl Rewritten {
    /// The mistakes of the innermost part that contains these bytes of the text.
    pub fn at(&self, bytes: &Range<usize>) -> &[u32] {
        let holds =
            |part: &&(Range<usize>, _)| part.0.start <= bytes.start && bytes.end <= part.0.end;
        let parts = self.parts.iter().filter(holds);
        parts.min_by_key(|part| part.0.len()).map_or(&[], |part| &part.1)
    }
}

/// An expression and its mistakes.
struct Node<'a> {
    range: Range<usize>,
    mutants: Vec<&'a Mutant>,
}

/// Puts mistakes into a text; all are of this file.
pub fn rewrite(text: &str, mutants: &[&Mutant]) -> Rewritten {
    let mut nodes: Vec<Node> = Vec::new();
    let mut sorted = mutants.to_vec();
    // Outer expressions first.
    sorted.sort_by_key(|m| (m.replacement.range.start, usize::MAX - m.replacement.range.end));
    for mutant in sorted {
        match nodes.last_mut() {
            Some(node) if node.range == mutant.replacement.range => node.mutants.push(mutant),
            Some(_) | None => {
                nodes.push(Node { range: mutant.replacement.range.clone(), mutants: vec![mutant] });
            }
        }
    }
    let mut out = Rewritten::default();
    emit(text, 0..text.len(), &nodes, &mut out);
    out
}

/// Emits a range of the text, in which the nodes lie.
fn emit(text: &str, range: Range<usize>, mut nodes: &[Node], out: &mut Rewritten) {
    let mut at = range.start;
    while let Some((node, rest)) = nodes.split_first() {
        out.text += &text[at..node.range.start];
        let inner = rest.partition_point(|other| other.range.start < node.range.end);
        let start = out.text.len();
        let part = out.parts.len();
        out.parts.push((start..start, node.mutants.iter().map(|m| m.number).collect()));
        out.text.push('(');
        for mutant in &node.mutants {
            out.text += &format!("if ::mutant_switch::is({}) {{ ", mutant.number);
            let from = out.text.len();
            out.text += &mutant.replacement.after;
            out.parts.push((from..out.text.len(), vec![mutant.number]));
            out.text += " } else ";
        }
        out.text += "{ ";
        emit(text, node.range.clone(), &rest[..inner], out);
        out.text += " })";
        out.parts[part].0 = start..out.text.len();
        at = node.range.end;
        nodes = &rest[inner..];
    }
    out.text += &text[at..range.end];
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::replacements::replacements;

    #[test]
    fn mistakes_within_mistakes() {
        let text = "fn f() { g(a + b < c, d) }";
        let found = replacements(text).expect("it parses");
        let mutants: Vec<Mutant> = (1..)
            .zip(found)
            .map(|(number, replacement)| Mutant { number, file: String::new(), replacement })
            .collect();
        let rewritten = rewrite(text, &mutants.iter().collect::<Vec<_>>());
        let expected = "fn f() { g((if ::mutant_switch::is(1) { (a + b) <= (c) } else { \
            (if ::mutant_switch::is(2) { (a) - (b) } else { a + b }) < c }), d) }";
        assert_eq!(rewritten.text, expected);
        syn::parse_file(&rewritten.text).expect("it parses");
        let minus = rewritten.text.find("(a) - ").expect("the inner mistake");
        assert_eq!(rewritten.at(&(minus..minus + 3)), [2]);
        let less = rewritten.text.find("< c }").expect("the outer expression");
        assert_eq!(rewritten.at(&(less..less + 1)), [1]);
        assert_eq!(rewritten.at(&(0..2)), [0; 0]);
    }
}
