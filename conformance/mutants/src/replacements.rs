//! The expressions of a file that a mistake fits.

use proc_macro2::Span;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, BinOp, Expr, ExprBinary, ExprMethodCall, ItemFn, Lit, UnOp};

/// A mistake: an expression of a file, and what stands there instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replacement {
    /// The line where the expression begins, from 1.
    pub line: usize,
    /// Its bytes in the file.
    pub range: Range<usize>,
    /// Its text.
    pub before: String,
    /// The text that stands there instead.
    pub after: String,
}

/// Functions whose results are read by people.
const DESCRIBING: [&str; 4] = ["fmt", "describe", "explain", "name"];

/// Every mistake that fits an expression of a file, in the order of the text.
///
/// # Errors
/// When the text does not parse.
pub fn replacements(text: &str) -> Result<Vec<Replacement>, syn::Error> {
    let file = syn::parse_file(text)?;
    let mut finder = Finder { text, found: Vec::new() };
    if !is_test(&file.attrs) {
        finder.visit_file(&file);
    }
    finder.found.sort_by_key(|found| found.range.start);
    Ok(finder.found)
}

struct Finder<'a> {
    text: &'a str,
    found: Vec<Replacement>,
}

/// Whether it is compiled for tests only.
fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let is = |name| attribute.path().is_ident(name);
        let list = attribute.meta.require_list().map(|list| list.tokens.to_string());
        is("test") || is("cfg") && list.is_ok_and(|list| list.starts_with("test"))
    })
}

/// Whether a condition has a pattern, so that it cannot stand in parentheses.
fn has_let(expr: &Expr) -> bool {
    match expr {
        Expr::Let(_) => true,
        Expr::Binary(ExprBinary { left, op: BinOp::And(_), right, .. }) => {
            has_let(left) || has_let(right)
        }
        _ => false,
    }
}

/// The operators that one may be taken for.
fn taken_for(op: BinOp) -> &'static [&'static str] {
    match op {
        BinOp::Lt(_) => &["<="],
        BinOp::Le(_) => &["<"],
        BinOp::Gt(_) => &[">="],
        BinOp::Ge(_) => &[">"],
        BinOp::Eq(_) => &["!="],
        BinOp::Ne(_) => &["=="],
        BinOp::Add(_) => &["-"],
        BinOp::Sub(_) => &["+"],
        BinOp::Mul(_) => &["+"],
        BinOp::Div(_) | BinOp::Rem(_) => &["*"],
        BinOp::Shl(_) => &[">>"],
        BinOp::Shr(_) => &["<<"],
        BinOp::BitAnd(_) => &["|"],
        BinOp::BitOr(_) => &["&"],
        BinOp::And(_) => &["||"],
        BinOp::Or(_) => &["&&"],
        BinOp::AddAssign(_) => &["-="],
        BinOp::SubAssign(_) => &["+="],
        BinOp::BitAndAssign(_) => &["|="],
        BinOp::BitOrAssign(_) => &["&="],
        _ => &[],
    }
}

/// The functions that one of one or two arguments may be taken for.
fn confused(method: &str) -> Option<&'static str> {
    Some(match method {
        "min" => "max",
        "max" => "min",
        "floor" => "ceil",
        "ceil" | "round" | "round_ties_even" | "trunc" => "floor",
        "first" => "last",
        "last" => "first",
        "any" => "all",
        "all" => "any",
        "wrapping_add" => "wrapping_sub",
        "wrapping_sub" | "saturating_sub" => "wrapping_add",
        _ => return None,
    })
}

impl Finder<'_> {
    fn source(&self, of: &impl Spanned) -> &str {
        &self.text[of.span().byte_range()]
    }

    fn add(&mut self, at: Span, after: String) {
        let range = at.byte_range();
        let before = self.text[range.clone()].to_owned();
        self.found.push(Replacement { line: at.start().line, range, before, after });
    }

    fn binary(&mut self, expr: &ExprBinary) {
        if has_let(&expr.left) || has_let(&expr.right) {
            return;
        }
        let [left, right] = [&expr.left, &expr.right].map(|side| self.source(side).to_owned());
        for other in taken_for(expr.op) {
            let is_assignment =
                other.len() == 2 && other.ends_with('=') && !"<>!=".contains(&other[..1]);
            let after = match is_assignment {
                true => format!("{left} {other} {right}"),
                false => format!("({left}) {other} ({right})"),
            };
            self.add(expr.span(), after);
        }
    }

    fn method(&mut self, call: &ExprMethodCall) {
        let receiver = self.source(&call.receiver).to_owned();
        let arguments: Vec<_> = call.args.iter().map(|arg| self.source(arg)).collect();
        let arguments = arguments.join(", ");
        let method = call.method.to_string();
        if let Some(other) = confused(&method) {
            self.add(call.span(), format!("{receiver}.{other}({arguments})"));
        }
        if matches!(method.as_str(), "clamp" | "min" | "max" | "rev" | "abs") {
            self.add(call.span(), receiver);
        }
    }

    /// A number that is one off.
    fn literal(&mut self, lit: &Lit) {
        match lit {
            Lit::Int(int) if int.base10_parse::<u64>().is_ok_and(|value| value < 100) => {
                let value: u64 = int.base10_parse().unwrap_or_default();
                self.add(lit.span(), format!("{}{}", value + 1, int.suffix()));
                if value > 0 {
                    self.add(lit.span(), format!("{}{}", value - 1, int.suffix()));
                }
            }
            Lit::Float(float) => {
                let digits = float.base10_digits();
                let plain = digits.parse::<f64>().is_ok_and(|value| value.abs() < 1e6);
                if plain && digits.contains('.') && !digits.contains('e') {
                    let suffix = float.suffix();
                    self.add(lit.span(), format!("({digits}{suffix} + 1.0{suffix})"));
                }
            }
            Lit::Bool(value) => self.add(lit.span(), (!value.value).to_string()),
            _ => {}
        }
    }
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        match expr {
            Expr::Binary(binary) => self.binary(binary),
            Expr::MethodCall(call) => self.method(call),
            Expr::Call(call) => {
                let arguments: Vec<_> = call.args.iter().map(|arg| self.source(arg)).collect();
                let name = self.source(&call.func).to_owned();
                match (name.rsplit("::").next(), arguments.as_slice()) {
                    (Some("clamp"), [value, ..]) => {
                        let value = (*value).to_owned();
                        self.add(call.span(), value);
                    }
                    (Some(end @ ("min" | "max")), [a, b]) => {
                        let other = if end == "min" { "max" } else { "min" };
                        let path = name.strip_suffix(end).unwrap_or_default();
                        let after = format!("{path}{other}({a}, {b})");
                        let first = (*a).to_owned();
                        self.add(call.span(), after);
                        self.add(call.span(), first);
                    }
                    _ => {}
                }
            }
            Expr::Unary(unary) => match unary.op {
                UnOp::Neg(_) | UnOp::Not(_) => {
                    let inner = self.source(&unary.expr).to_owned();
                    self.add(unary.span(), inner);
                }
                _ => {}
            },
            Expr::If(choice) if !has_let(&choice.cond) => {
                let condition = self.source(&choice.cond).to_owned();
                self.add(choice.cond.span(), format!("!({condition})"));
            }
            Expr::Lit(lit) => return self.literal(&lit.lit),
            // Numbers here are sizes: what is one off is out of bounds.
            Expr::Range(range) => {
                for end in [&range.start, &range.end].into_iter().flatten() {
                    if !matches!(**end, Expr::Lit(_)) {
                        self.visit_expr(end);
                    }
                }
                return;
            }
            Expr::Repeat(repeat) => return self.visit_expr(&repeat.expr),
            Expr::Const(_) => return,
            _ => {}
        }
        visit::visit_expr(self, expr);
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        let name = item.sig.ident.to_string();
        if item.sig.constness.is_none()
            && !is_test(&item.attrs)
            && !DESCRIBING.contains(&name.as_str())
        {
            self.visit_block(&item.block);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        let name = item.sig.ident.to_string();
        if item.sig.constness.is_none() && !DESCRIBING.contains(&name.as_str()) {
            self.visit_block(&item.block);
        }
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    // What is computed when the crate is compiled cannot change at run time.
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_item_enum(&mut self, _: &'ast syn::ItemEnum) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'ast syn::TraitItemConst) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_path(&mut self, _: &'ast syn::Path) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
    fn visit_generic_argument(&mut self, _: &'ast syn::GenericArgument) {}
}

#[cfg(test)]
mod tests {
    use super::replacements;

    fn after(text: &str) -> Vec<String> {
        let found = replacements(text).expect("it parses");
        found.into_iter().map(|found| format!("{} -> {}", found.before, found.after)).collect()
    }

    #[test]
    fn boundaries_signs_clamps_and_constants() {
        let found = after("fn f(a: f32, b: f32) -> bool { a.clamp(b, 9.5) - b < -a }");
        assert_eq!(
            found,
            [
                "a.clamp(b, 9.5) - b < -a -> (a.clamp(b, 9.5) - b) <= (-a)",
                "a.clamp(b, 9.5) - b -> (a.clamp(b, 9.5)) + (b)",
                "a.clamp(b, 9.5) -> a",
                "9.5 -> (9.5 + 1.0)",
                "-a -> a",
            ]
        );
    }

    #[test]
    fn what_is_no_expression_of_run_time_is_left_alone() {
        let text = "const A: u32 = 1 + 2; const fn f() -> u32 { 3 + 4 } #[cfg(test)] mod t { fn g() -> u32 { 5 } }
            fn h() { let [_, 1] = x else { return }; for _ in 0..4 {} let _ = [a; 7]; m!(1 + 1); }";
        assert!(after(text).is_empty(), "{:?}", after(text));
    }

    #[test]
    fn conditions_with_patterns_keep_their_form() {
        let found = after("fn f() { if let Some(x) = a && x < b { g(); } if c == d { g(); } }");
        assert_eq!(
            found,
            ["x < b -> (x) <= (b)", "c == d -> !(c == d)", "c == d -> (c) != (d)"]
                .map(String::from)
        );
    }
}
