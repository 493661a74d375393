//! Precision qualifiers (GLSL 1.30 section 4.5; GLSL ES 1.00 section 4.5; GLSL ES 3.00 section 4.5). All numbers have 32
//! bits; precisions are checked where GLSL ES has rules for them.

use super::Checker;
use crate::ast::{self, Precision, Qualifier};
use crate::language::Version;
use crate::text::diagnostics::Diagnostic;
use crate::types::{Comparison, Dim, FLOAT, INT, Sampler, Scalar, Type};
use rasterizer::ir::Stage;

/// The default precisions in force: the last one of a type counts.
#[derive(Debug)]
pub(super) struct DefaultPrecisions {
    rows: Vec<(Type, Precision)>,
    /// Whether types without a row have none: in GLSL ES.
    required: bool,
}

/// How many defaults there were where a scope began.
#[derive(Clone, Copy, Debug)]
pub(super) struct PrecisionScope(usize);

impl DefaultPrecisions {
    /// Those that a shader begins with (GLSL ES 3.00 section 4.5.4).
    pub fn new(version: Version, stage: Stage) -> Self {
        let plain = |dim| {
            let (scalar, comparison) = (Scalar::Float, Comparison::No);
            (Type::Sampler(Sampler { dim, scalar, comparison }), Precision::Low)
        };
        let samplers = [plain(Dim::D2), plain(Dim::Cube), plain(Dim::External)];
        let rows = match (version.is_es(), stage) {
            (false, _) => Vec::new(),
            (true, Stage::Vertex | Stage::Geometry) => {
                let numbers = [(FLOAT, Precision::High), (INT, Precision::High)];
                numbers.into_iter().chain(samplers).collect()
            }
            (true, Stage::Fragment) => {
                [(INT, Precision::Medium)].into_iter().chain(samplers).collect()
            }
        };
        Self { rows, required: version.is_es() }
    }

    pub fn open(&self) -> PrecisionScope {
        PrecisionScope(self.rows.len())
    }

    pub fn close(&mut self, scope: PrecisionScope) {
        self.rows.truncate(scope.0);
    }

    /// The row of a type is that of `int` for all integers, of `float` for vectors and matrices.
    fn of(&self, ty: &Type) -> Option<Precision> {
        let key = match ty.base() {
            Type::Sampler(_) => ty.base().clone(),
            numbers => match numbers.scalar() {
                Some(Scalar::Float) => FLOAT,
                Some(Scalar::Int | Scalar::Uint) => INT,
                Some(Scalar::Bool) | None => return None,
            },
        };
        self.rows.iter().rev().find(|row| row.0 == key).map(|row| row.1)
    }
}

/// Whether a type has a precision.
fn is_precise(ty: &Type) -> bool {
    match ty.base() {
        Type::Sampler(_) => true,
        base => base.scalar().is_some_and(|scalar| scalar != Scalar::Bool),
    }
}

impl Checker<'_> {
    /// `precision highp float;`
    pub(super) fn default_precision(&mut self, precision: Precision, name: &ast::TypeName) {
        let ty = self.type_of(name, &[]);
        match ty {
            FLOAT | INT | Type::Sampler(_) => {
                self.log.work.add(self.precisions.rows.len());
                if self.precisions.of(&ty) != Some(precision) {
                    self.precisions.rows.push((ty, precision));
                }
            }
            Type::Error => {}
            Type::Void
            | Type::Vector(..)
            | Type::Matrix(..)
            | Type::Struct(_)
            | Type::Array(..) => {
                let message = format!("{ty} has no default precision");
                let problem = Diagnostic::error(name.span, message).rule(self.rule("4.5.3"));
                self.log.push(problem.help("float, int and the samplers have one"));
            }
        }
    }

    /// The precision of what is declared: only numbers and samplers have one (GLSL 1.30 section 4.5.2), and in GLSL ES
    /// all of them need one, of their own or by default. `None` where there is none.
    pub(super) fn precision_of(&mut self, ty: &ast::QualifiedType) -> Option<Precision> {
        let mut words = ty.qualifiers.iter();
        let given = words.find_map(|(word, span)| match word {
            Qualifier::Precision(precision) => Some((*precision, *span)),
            _ => None,
        });
        let named = match &ty.ty.base {
            ast::TypeBase::Named(word) => Type::named(word, self.language),
            ast::TypeBase::Struct(_) => None,
        };
        let precise = named.as_ref().is_some_and(is_precise);
        if let (Some((_, span)), false) = (given, precise) {
            let message = "only numbers, their vectors and matrices, and samplers have a precision";
            self.error(span, "4.5.2", message);
        }
        if let Some((precision, _)) = given {
            return Some(precision);
        }
        let named = named.filter(|_| precise)?;
        self.log.work.add(self.precisions.rows.len());
        let found = self.precisions.of(&named);
        if found.is_none() && self.precisions.required && !self.reported_missing_precision {
            self.reported_missing_precision = true;
            let (message, default) = match &named {
                Type::Sampler(_) => (format!("{named} has no precision yet"), named.to_string()),
                _ => ("floats of the fragment stage have no precision yet".into(), "float".into()),
            };
            let problem = Diagnostic::error(ty.ty.span, message).rule(self.rule("4.5.3"));
            self.log.push(problem.help(format!("write `precision mediump {default};` first")));
        }
        found
    }
}
