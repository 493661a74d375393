//! Functions that change state and may still fail after that.
//!
//! A call of GL that fails has no effect (GL 2.1, section 2.5), so that a function validates everything before it
//! assigns anything. What is found is an assignment to what a reference leads to (`context.state.x = …`), and an error
//! that may come after it: `?`, `return Err(…)`, `return invalid_…(…)`. Each branch is followed by itself, a loop twice.
//!
//! Not seen: changes by methods (`insert`, `clear`), errors of a call whose result is returned as it is, and closures.

use crate::error::ReadError;
use crate::is_test;
use crate::requests::{each_source, returns_result};
use std::collections::BTreeSet;
use std::path::Path;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// An error that may come after an assignment.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LateError {
    /// The file, relative to the folder that was asked for.
    pub file: String,
    /// The function.
    pub function: String,
    /// The line of the assignment.
    pub assigned: usize,
    /// The line of the error.
    pub fails: usize,
}

/// The late errors of the files under `folder`, with paths relative to `root`.
///
/// # Errors
/// When a file cannot be read, or is not Rust.
pub fn late_errors(root: &Path, folder: &Path) -> Result<Vec<LateError>, ReadError> {
    let mut found = Vec::new();
    each_source(root, folder, &mut |path, source| {
        let mut functions = Functions::default();
        functions.visit_file(source);
        found.extend(functions.found.into_iter().map(|(function, assigned, fails)| LateError {
            file: path.to_owned(),
            function,
            assigned,
            fails,
        }));
    })?;
    found.sort();
    Ok(found)
}

/// The functions of a file, and what was found in them: name, line of the assignment, line of the error.
#[derive(Default)]
struct Functions {
    found: Vec<(String, usize, usize)>,
}

impl Functions {
    fn function(&mut self, signature: &syn::Signature, body: &syn::Block) {
        if !returns_result(signature) {
            return;
        }
        let mut flow = Flow::default();
        for input in &signature.inputs {
            if let syn::FnArg::Typed(input) = input
                && is_output(&input.ty)
            {
                flow.own.extend(names(&input.pat));
            }
        }
        flow.visit_block(body);
        let name = signature.ident.to_string();
        self.found.extend(flow.late.into_iter().map(|(from, to)| (name.clone(), from, to)));
    }
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.function(&item.sig, &item.block);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.function(&item.sig, &item.block);
    }
}

/// Whether a parameter is memory that a call writes its answer to.
fn is_output(ty: &syn::Type) -> bool {
    matches!(ty, syn::Type::Reference(reference) if matches!(&*reference.elem, syn::Type::Slice(_)))
}

/// The names that a pattern binds.
fn names(pattern: &syn::Pat) -> Vec<String> {
    #[derive(Default)]
    struct Names(Vec<String>);
    impl Visit<'_> for Names {
        fn visit_pat_ident(&mut self, pattern: &syn::PatIdent) {
            self.0.push(pattern.ident.to_string());
            visit::visit_pat_ident(self, pattern);
        }
    }
    let mut found = Names::default();
    found.visit_pat(pattern);
    found.0
}

/// The body of a function, in the order in which it runs.
#[derive(Default)]
struct Flow {
    /// Variables of the function's own, and memory for answers.
    own: BTreeSet<String>,
    /// The line of the first assignment, if there was one.
    assigned: Option<usize>,
    late: BTreeSet<(usize, usize)>,
}

impl Flow {
    fn fails(&mut self, line: usize) {
        self.late.extend(self.assigned.map(|assigned| (assigned, line)));
    }

    fn assigns(&mut self, left: &syn::Expr) {
        if let Some(root) = root_of_place(left, Reach::Variable)
            && !self.own.contains(&root)
        {
            self.assigned.get_or_insert(left.span().start().line);
        }
    }

    /// Notes the variables that a pattern binds to an expression: to assign to a field of a local variable is local, too.
    fn binds(&mut self, pattern: &syn::Pat, to: &syn::Expr) {
        if root_of_place(to, Reach::Variable).is_some_and(|root| self.own.contains(&root)) {
            self.own.extend(names(pattern));
        }
        self.visit_pat(pattern);
    }

    /// Follows branches of which one runs.
    fn branches<'a>(
        &mut self,
        branches: impl IntoIterator<Item = Box<dyn FnOnce(&mut Self) + 'a>>,
    ) {
        let before = self.assigned;
        let mut after = None;
        for branch in branches {
            self.assigned = before;
            branch(self);
            after = after.or(self.assigned);
        }
        self.assigned = after;
    }
}

/// Whether an assigned place is a variable itself or lies inside it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reach {
    /// The variable itself.
    Variable,
    /// A field, an element, or a reference.
    Inside,
}

/// The variable whose fields, elements or referent a place is.
fn root_of_place(place: &syn::Expr, reach: Reach) -> Option<String> {
    match place {
        syn::Expr::Field(field) => root_of_place(&field.base, Reach::Inside),
        syn::Expr::Index(index) => root_of_place(&index.expr, Reach::Inside),
        syn::Expr::Unary(unary) => root_of_place(&unary.expr, Reach::Inside),
        syn::Expr::MethodCall(call) => root_of_place(&call.receiver, Reach::Inside),
        syn::Expr::Paren(paren) => root_of_place(&paren.expr, reach),
        syn::Expr::Try(tried) => root_of_place(&tried.expr, reach),
        syn::Expr::Path(path) if reach == Reach::Inside => {
            path.path.get_ident().map(ToString::to_string)
        }
        _ => None,
    }
}

/// Whether an expression is an error: `Err(…)`, `invalid_…(…)`.
fn is_error(expr: &syn::Expr) -> bool {
    let syn::Expr::Call(call) = expr else { return false };
    let syn::Expr::Path(function) = &*call.func else { return false };
    let Some(last) = function.path.segments.last() else { return false };
    last.ident == "Err" || last.ident.to_string().starts_with("invalid_")
}

impl<'ast> Visit<'ast> for Flow {
    fn visit_item(&mut self, _: &'ast syn::Item) {}

    fn visit_expr_closure(&mut self, _: &'ast syn::ExprClosure) {}

    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        // Without `mut`, only what the variable refers to can be assigned to.
        if pattern.mutability.is_some() && pattern.by_ref.is_none() {
            self.own.insert(pattern.ident.to_string());
        }
    }

    fn visit_expr_let(&mut self, expr: &'ast syn::ExprLet) {
        self.visit_expr(&expr.expr);
        self.binds(&expr.pat, &expr.expr);
    }

    fn visit_expr_assign(&mut self, expr: &'ast syn::ExprAssign) {
        self.visit_expr(&expr.right);
        self.visit_expr(&expr.left);
        self.assigns(&expr.left);
    }

    fn visit_expr_binary(&mut self, expr: &'ast syn::ExprBinary) {
        visit::visit_expr_binary(self, expr);
        use syn::BinOp::{
            AddAssign, BitAndAssign, BitOrAssign, BitXorAssign, DivAssign, MulAssign, RemAssign,
            ShlAssign, ShrAssign, SubAssign,
        };
        let op = &expr.op;
        if matches!(op, AddAssign(_) | SubAssign(_) | MulAssign(_) | DivAssign(_) | RemAssign(_))
            || matches!(op, BitAndAssign(_) | BitOrAssign(_) | BitXorAssign(_))
            || matches!(op, ShlAssign(_) | ShrAssign(_))
        {
            self.assigns(&expr.left);
        }
    }

    fn visit_expr_try(&mut self, expr: &'ast syn::ExprTry) {
        visit::visit_expr_try(self, expr);
        self.fails(expr.question_token.span().start().line);
    }

    fn visit_expr_return(&mut self, expr: &'ast syn::ExprReturn) {
        visit::visit_expr_return(self, expr);
        if expr.expr.as_deref().is_some_and(is_error) {
            self.fails(expr.span().start().line);
        }
        // Nothing runs after it.
        self.assigned = None;
    }

    fn visit_expr_if(&mut self, expr: &'ast syn::ExprIf) {
        self.visit_expr(&expr.cond);
        self.branches([
            Box::new(|flow: &mut Self| flow.visit_block(&expr.then_branch))
                as Box<dyn FnOnce(&mut Self)>,
            Box::new(|flow: &mut Self| {
                if let Some((_, other)) = &expr.else_branch {
                    flow.visit_expr(other);
                }
            }),
        ]);
    }

    fn visit_expr_match(&mut self, expr: &'ast syn::ExprMatch) {
        self.visit_expr(&expr.expr);
        self.branches(expr.arms.iter().map(|arm| {
            Box::new(move |flow: &mut Self| flow.visit_arm(arm)) as Box<dyn FnOnce(&mut Self)>
        }));
    }

    fn visit_expr_for_loop(&mut self, expr: &'ast syn::ExprForLoop) {
        self.visit_expr(&expr.expr);
        self.binds(&expr.pat, &expr.expr);
        self.visit_block(&expr.body);
        self.visit_block(&expr.body);
    }

    fn visit_expr_while(&mut self, expr: &'ast syn::ExprWhile) {
        self.visit_expr(&expr.cond);
        self.visit_block(&expr.body);
        self.visit_expr(&expr.cond);
        self.visit_block(&expr.body);
    }

    fn visit_expr_loop(&mut self, expr: &'ast syn::ExprLoop) {
        self.visit_block(&expr.body);
        self.visit_block(&expr.body);
    }
}
