//! Qualifiers of globals, and the types of variables that pass between stages (GLSL 1.30 section
//! 4.3).

use super::Checker;
use crate::ast::{self, Qualifier};
use crate::builtins::variable::{Builtin, Invariance};
use crate::hir::{InterfaceQualifiers, Storage};
use crate::language::{Extension, Version};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use rasterizer::ir::{Interpolation, Stage};

/// The storage that a qualifier gives a global in a stage; the error says why it is not allowed.
fn storage(
    qualifier: Qualifier,
    stage: Stage,
    interpolation: Interpolation,
) -> Result<Storage, &'static str> {
    match (qualifier, stage) {
        (Qualifier::Const, _) => Ok(Storage::Const),
        (Qualifier::Uniform, _) => Ok(Storage::Uniform),
        (Qualifier::Attribute | Qualifier::In, Stage::Vertex) => Ok(Storage::Attribute),
        (Qualifier::Varying | Qualifier::Out, Stage::Vertex | Stage::Geometry) => {
            Ok(Storage::Output(interpolation))
        }

        (Qualifier::Varying | Qualifier::In, Stage::Fragment)
        | (Qualifier::In, Stage::Geometry) => Ok(Storage::Input(interpolation)),
        (Qualifier::Out, Stage::Fragment) => Ok(Storage::FragmentOutput),
        (Qualifier::Attribute, Stage::Fragment) => {
            Err("attributes belong to vertices: the fragment stage has none")
        }
        (Qualifier::Attribute, Stage::Geometry) => Err("the geometry stage has `in` and `out`"),
        (Qualifier::Inout, _) => Err("`inout` is for parameters only"),
        (
            Qualifier::Centroid
            | Qualifier::Invariant
            | Qualifier::Smooth
            | Qualifier::Flat
            | Qualifier::NoPerspective
            | Qualifier::Precision(_)
            | Qualifier::OriginUpperLeft
            | Qualifier::PixelCenterInteger
            | Qualifier::Location(_)
            | Qualifier::Index(_)
            | Qualifier::Binding(_)
            | Qualifier::Depth(_)
            | Qualifier::Block(_)
            | Qualifier::Primitive(_)
            | Qualifier::MaxVertices(_),
            _,
        ) => Ok(Storage::Plain),
    }
}

impl Checker<'_> {
    /// The storage and the interface qualifiers of a global; `None` if its qualifiers contradict
    /// each other.
    pub(super) fn global_storage(
        &mut self,
        ty: &ast::QualifiedType,
    ) -> Option<(Storage, InterfaceQualifiers)> {
        self.check_order(&ty.qualifiers);
        self.no_block_layout(&ty.qualifiers);
        let mut word: Option<(Qualifier, Span)> = None;
        let mut interface_qualifiers = InterfaceQualifiers::default();
        let mut invariant = None;
        let mut words_of_passing: Vec<(Qualifier, Span)> = Vec::new();
        for &(qualifier, span) in &ty.qualifiers {
            let smoothness = match qualifier {
                Qualifier::Const
                | Qualifier::Attribute
                | Qualifier::Varying
                | Qualifier::Uniform
                | Qualifier::In
                | Qualifier::Out
                | Qualifier::Inout => {
                    let before = word.replace((qualifier, span));
                    // `varying out` of EXT_gpu_shader4 is an output of the fragment stage.
                    let output = self.language.enabled(Extension::GpuShader4)
                        && self.stage == Stage::Fragment
                        && qualifier == Qualifier::Out
                        && before.is_some_and(|(first, _)| first == Qualifier::Varying);
                    if before.is_some() && !output {
                        let message = "a second word that says what the variable is for";
                        self.log.push(Diagnostic::error(span, message).rule(self.rule("4.3")));
                        return None;
                    }
                    continue;
                }
                Qualifier::Smooth => Interpolation::Smooth,
                Qualifier::Flat => Interpolation::Flat,
                Qualifier::NoPerspective => Interpolation::NoPerspective,
                // Every result is invariant: the qualifier is only compared between the stages.
                Qualifier::Invariant => {
                    interface_qualifiers.invariant = true;
                    invariant = Some(span);
                    continue;
                }
                Qualifier::Centroid => {
                    interface_qualifiers.centroid = true;
                    words_of_passing.push((qualifier, span));
                    continue;
                }
                Qualifier::OriginUpperLeft => {
                    interface_qualifiers.origin_upper_left = true;
                    continue;
                }
                Qualifier::PixelCenterInteger => {
                    interface_qualifiers.pixel_center_integer = true;
                    continue;
                }
                Qualifier::Location(location) => {
                    let second = interface_qualifiers.location.replace(location).is_some();
                    if second && self.version == Version::Es300 {
                        let message = "a second location of the same variable";
                        self.log.push(Diagnostic::error(span, message).rule(self.rule("4.3.8")));
                    }
                    continue;
                }
                Qualifier::Index(index) => {
                    interface_qualifiers.index = Some(index);
                    continue;
                }
                Qualifier::Binding(binding) => {
                    interface_qualifiers.binding = Some((binding, span));
                    continue;
                }
                Qualifier::Depth(depth) => {
                    interface_qualifiers.depth = Some(depth);
                    continue;
                }
                Qualifier::Primitive(_) | Qualifier::MaxVertices(_) => {
                    let message =
                        "this layout stands before `in` or `out` alone, without a variable";
                    self.log.push(Diagnostic::error(span, message).rule(self.rule("4.3.8")));
                    continue;
                }
                Qualifier::Block(_) | Qualifier::Precision(_) => continue,
            };
            words_of_passing.push((qualifier, span));
            if interface_qualifiers.interpolation.replace(smoothness).is_some() {
                let message = "a second word that says how the variable is interpolated";
                self.log.push(Diagnostic::error(span, message).rule(self.rule("4.3.9")));
            }
        }
        let smoothness = interface_qualifiers.interpolation.unwrap_or(Interpolation::Smooth);
        let found = match word {
            Some((qualifier, span)) => {
                self.check_old(qualifier, span);
                storage(qualifier, self.stage, smoothness).map_err(|message| (message, span))
            }
            None => Ok(Storage::Plain),
        };
        match found {
            Ok(storage) => {
                let word = word.map(|(qualifier, _)| qualifier);
                self.check_passing(storage, &words_of_passing, word);
                self.check_location(storage, &ty.qualifiers, word);
                if let Some(span) = invariant {
                    self.check_invariant(storage, span);
                }
                Some((storage, interface_qualifiers))
            }
            Err((message, span)) => {
                self.log.push(Diagnostic::error(span, message).rule(self.rule("4.3")));
                None
            }
        }
    }

    /// Qualifiers have a fixed order (GLSL 1.30 section 4.7).
    pub(super) fn check_order(&mut self, qualifiers: &[(Qualifier, Span)]) {
        let any_order = [Extension::GpuShader4, Extension::ShadingLanguage420Pack];
        if any_order.into_iter().any(|extension| self.language.enabled(extension)) {
            return;
        }
        let wrong = qualifiers.windows(2).find(|pair| pair[0].0.rank() > pair[1].0.rank());
        if let Some([_, (_, span)]) = wrong {
            let message = "this qualifier stands too late";
            let problem = Diagnostic::error(*span, message).rule(self.rule("4.7"));
            let order = "the order is: invariant; smooth, flat or noperspective; const or \
                         centroid; in, out, varying and the like; the precision";
            self.log.push(problem.help(order));
        }
    }

    /// Interpolation qualifiers are for what passes from the vertex to the fragment stage, and not
    /// for the deprecated `varying` (GLSL 1.30 section 4.3).
    fn check_passing(
        &mut self,
        storage: Storage,
        words: &[(Qualifier, Span)],
        word: Option<Qualifier>,
    ) {
        let passes = matches!(storage, Storage::Output(_) | Storage::Input(_));
        let varying = word == Some(Qualifier::Varying);
        let deprecated = varying && !self.language.enabled(Extension::GpuShader4);
        for (qualifier, span) in words {
            let (message, help) = if !passes {
                let message = "only what passes from the vertex to the fragment stage is \
                               interpolated";
                (message, "leave this word out")
            } else if deprecated && *qualifier != Qualifier::Centroid {
                ("this word does not go with `varying`", "write `in` or `out`")
            } else {
                continue;
            };
            let problem = Diagnostic::error(*span, message).rule(self.rule("4.3.9"));
            self.log.push(problem.help(help));
        }
    }

    /// Only `in` of the vertex stage and `out` of the fragment stage have locations
    /// (ARB_explicit_attrib_location), not `attribute` and `varying`; by extensions uniforms, and what passes between
    /// stages, too.
    fn check_location(
        &mut self,
        storage: Storage,
        qualifiers: &[(Qualifier, Span)],
        word: Option<Qualifier>,
    ) {
        self.check_index(storage, qualifiers);
        let location =
            qualifiers.iter().find(|(qualifier, _)| matches!(qualifier, Qualifier::Location(_)));
        let Some(&(_, span)) = location else { return };
        if storage == Storage::Uniform {
            let extension = Extension::ExplicitUniformLocation;
            if !self.language.enabled(extension) {
                let message = "a uniform has a location only by an extension";
                let problem = Diagnostic::error(span, message).rule(extension.name());
                self.log.push(problem.help(format!("#extension {} : enable", extension.name())));
            }
            return;
        }
        let passes = matches!(storage, Storage::Output(_) | Storage::Input(_));
        let has_one = matches!(storage, Storage::Attribute | Storage::FragmentOutput)
            || passes && self.language.enabled(Extension::SeparateShaderObjects);
        if has_one && !matches!(word, Some(Qualifier::Attribute | Qualifier::Varying)) {
            return;
        }
        let message = "only an `in` of the vertex stage and an `out` of the fragment stage have a \
                       location";
        let problem = Diagnostic::error(span, message).rule("ARB_explicit_attrib_location");
        let help = if has_one {
            "write `in` or `out`"
        } else if passes {
            "write `#extension GL_ARB_separate_shader_objects : enable` first, or leave the location out"
        } else {
            "leave the location out"
        };
        self.log.push(problem.help(help));
    }

    /// Only an `out` of the fragment stage with a location has an index, 0 or 1 (GLSL 3.30 section
    /// 4.3.8.2).
    fn check_index(&mut self, storage: Storage, qualifiers: &[(Qualifier, Span)]) {
        let index = qualifiers.iter().find_map(|(qualifier, span)| {
            if let Qualifier::Index(index) = qualifier { Some((*index, *span)) } else { None }
        });
        let Some((index, span)) = index else { return };
        let located = qualifiers.iter().any(|(word, _)| matches!(word, Qualifier::Location(_)));
        let message = if storage != Storage::FragmentOutput {
            "only an `out` of the fragment stage has an index"
        } else if !located {
            "an index stands beside a location"
        } else if index > 1 {
            "an index is 0 or 1"
        } else {
            return;
        };
        self.error(span, "4.3.8.2", message);
    }

    /// Only what passes between the stages can be invariant (GLSL 1.20 section 4.6.1), and from 1.30
    /// on and in GLSL ES what the fragment stage writes.
    fn check_invariant(&mut self, storage: Storage, span: Span) {
        let later = self.version >= Version::V130 || self.version.is_es();
        let fits = match storage {
            Storage::Output(_) => true,
            // GLSL ES 3.00 section 4.6.1: outputs alone.
            Storage::Input(_) | Storage::Builtin(Builtin::FragCoord | Builtin::PointCoord) => {
                self.version != Version::Es300
            }
            Storage::FragmentOutput => later,
            Storage::Builtin(builtin) => match builtin.invariance() {
                Invariance::Allowed => true,
                Invariance::AllowedLater => later,
                Invariance::Forbidden => false,
            },
            Storage::Plain
            | Storage::Const
            | Storage::Parameter(_)
            | Storage::Uniform
            | Storage::Attribute => false,
        };
        if !fits {
            let message = "only what passes from the vertex to the fragment stage can be invariant";
            let problem = Diagnostic::error(span, message).rule(self.rule("4.6.1"));
            self.log.push(problem.help("leave `invariant` out"));
        }
    }

    /// `invariant a, b;`: recorded for the linker only, because every result is invariant.
    pub(super) fn invariant(&mut self, names: &[ast::Name]) {
        for name in names {
            let var = match self.scopes.find(&name.text) {
                Some(symbol) => symbol.variable(),
                None => self.builtin_variable(&name.text),
            };
            let Some(var) = var else {
                self.undeclared(&name.text, name.span);
                continue;
            };
            let variable = self.variable_mut(var);
            variable.interface_qualifiers.invariant = true;
            let (storage, used) = (variable.storage, variable.references > 0);
            self.check_invariant(storage, name.span);
            if used {
                let message = format!("`{}` is used before it is made invariant", name.text);
                let problem = Diagnostic::error(name.span, message).rule(self.rule("4.6.1"));
                self.log.push(problem.help("put this before the first use"));
            }
        }
    }

    /// `in` and `out` of globals came with 1.30. Before, they are reported and then treated like
    /// `attribute` and `varying`, so that there are no further errors.
    fn check_old(&mut self, qualifier: Qualifier, span: Span) {
        let is_in = qualifier == Qualifier::In;
        if !is_in && self.language.enabled(Extension::GpuShader4) {
            return;
        }
        let located = [Extension::ExplicitAttribLocation, Extension::SeparateShaderObjects];
        if located.into_iter().any(|extension| self.language.enabled(extension)) {
            return;
        }
        let layouts = self.language.enabled(Extension::FragmentCoordConventions);
        if is_in && self.stage == Stage::Fragment && layouts {
            return;
        }
        if self.version >= Version::V130 || !(is_in || qualifier == Qualifier::Out) {
            return;
        }
        let word = if is_in { "in" } else { "out" };
        let message = format!("`{word}` of global variables came with `#version 130`");
        let old = match (is_in, self.stage) {
            (true, Stage::Vertex) => "write `attribute`, or `#version 130` first",
            (true, Stage::Fragment) | (false, Stage::Vertex) => {
                "write `varying`, or `#version 130` first"
            }
            (true | false, Stage::Geometry) => "write `#version 150` first",
            (false, Stage::Fragment) => "write gl_FragColor, or `#version 130` first",
        };
        self.log.push(Diagnostic::error(span, message).rule(self.rule("4.3")).help(old));
    }
}
