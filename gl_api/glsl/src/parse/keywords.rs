//! Keywords, reserved words and names (GLSL 1.30 section 3.6).

use crate::ast::{BlockLayout, DepthLayout, Precision, PrimitiveLayout, Qualifier};
use crate::language::{Availability, EsVersions, Extension, Language, Version};
use crate::types::Type;

const DESKTOP_AND_ES: Availability = Availability::DESKTOP_AND_ES;
const DESKTOP_AND_ES_100: Availability = Availability::DESKTOP_AND_ES_100;
const V120: Availability = Availability::V120.and_es(EsVersions::From300);
const V130: Availability = Availability::V130.and_es(EsVersions::From300);
/// Precision qualifiers.
const PRECISION: Availability = V130.and_es(EsVersions::All);
/// Without perspective.
const NO_PERSPECTIVE: Availability = Availability::V130.or(Extension::GpuShader4);

/// `layout`: of `gl_FragCoord`, of attributes and outputs, of uniform blocks; a keyword from GLSL 1.40 on.
const LAYOUT: Availability = Availability::V140
    .or(Extension::FragmentCoordConventions)
    .or(Extension::ShadingLanguage420Pack)
    .or(Extension::AmdConservativeDepth)
    .or(Extension::ConservativeDepth)
    .or(Extension::ExplicitAttribLocation)
    .or(Extension::SeparateShaderObjects)
    .and_es(EsVersions::From300);

/// The layout qualifiers of uniform blocks.
const BLOCK_LAYOUTS: [(&str, BlockLayout); 5] = [
    ("shared", BlockLayout::Shared),
    ("packed", BlockLayout::Packed),
    ("std140", BlockLayout::Std140),
    ("row_major", BlockLayout::RowMajor),
    ("column_major", BlockLayout::ColumnMajor),
];

/// The layout qualifiers of `gl_FragDepth`.
const DEPTHS: [(&str, DepthLayout); 4] = [
    ("depth_any", DepthLayout::Any),
    ("depth_greater", DepthLayout::Greater),
    ("depth_less", DepthLayout::Less),
    ("depth_unchanged", DepthLayout::Unchanged),
];

/// The layout qualifiers of the geometry stage.
const PRIMITIVES: [(&str, PrimitiveLayout); 7] = [
    ("points", PrimitiveLayout::Points),
    ("lines", PrimitiveLayout::Lines),
    ("lines_adjacency", PrimitiveLayout::LinesAdjacency),
    ("triangles", PrimitiveLayout::Triangles),
    ("triangles_adjacency", PrimitiveLayout::TrianglesAdjacency),
    ("line_strip", PrimitiveLayout::LineStrip),
    ("triangle_strip", PrimitiveLayout::TriangleStrip),
];

/// The class of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordClass {
    /// An identifier.
    Name,
    /// The name of a type.
    Type,
    /// Any other keyword.
    Keyword,
    /// Reserved: an error wherever it stands.
    Reserved,
}

/// Keywords that name no types, and their availability.
const KEYWORDS: [(&str, Availability); 32] = [
    ("attribute", DESKTOP_AND_ES_100),
    ("const", DESKTOP_AND_ES),
    ("uniform", DESKTOP_AND_ES),
    ("varying", DESKTOP_AND_ES_100),
    ("break", DESKTOP_AND_ES),
    ("continue", DESKTOP_AND_ES),
    ("do", DESKTOP_AND_ES),
    ("for", DESKTOP_AND_ES),
    ("while", DESKTOP_AND_ES),
    ("if", DESKTOP_AND_ES),
    ("else", DESKTOP_AND_ES),
    ("in", DESKTOP_AND_ES),
    ("out", DESKTOP_AND_ES),
    ("inout", DESKTOP_AND_ES),
    ("true", DESKTOP_AND_ES),
    ("false", DESKTOP_AND_ES),
    ("discard", DESKTOP_AND_ES),
    ("return", DESKTOP_AND_ES),
    ("struct", DESKTOP_AND_ES),
    ("centroid", V120.or(Extension::GpuShader4)),
    ("invariant", V120.and_es(EsVersions::All)),
    ("flat", V130.or(Extension::GpuShader4)),
    ("smooth", V130),
    ("noperspective", NO_PERSPECTIVE),
    ("switch", V130),
    ("case", V130),
    ("default", DESKTOP_AND_ES),
    ("lowp", PRECISION),
    ("mediump", PRECISION),
    ("precision", PRECISION),
    ("layout", LAYOUT),
    ("layout", Availability::UNIFORM_BLOCKS),
];

/// Qualifiers, and their availability.
const QUALIFIERS: [(&str, Qualifier, Availability); 15] = [
    ("const", Qualifier::Const, DESKTOP_AND_ES),
    ("attribute", Qualifier::Attribute, DESKTOP_AND_ES_100),
    ("varying", Qualifier::Varying, DESKTOP_AND_ES_100),
    ("uniform", Qualifier::Uniform, DESKTOP_AND_ES),
    ("in", Qualifier::In, DESKTOP_AND_ES),
    ("out", Qualifier::Out, DESKTOP_AND_ES),
    ("inout", Qualifier::Inout, DESKTOP_AND_ES),
    ("centroid", Qualifier::Centroid, V120.or(Extension::GpuShader4)),
    ("invariant", Qualifier::Invariant, V120.and_es(EsVersions::All)),
    ("smooth", Qualifier::Smooth, V130),
    ("flat", Qualifier::Flat, V130.or(Extension::GpuShader4)),
    ("noperspective", Qualifier::NoPerspective, NO_PERSPECTIVE),
    ("lowp", Qualifier::Precision(Precision::Low), PRECISION),
    ("mediump", Qualifier::Precision(Precision::Medium), PRECISION),
    ("highp", Qualifier::Precision(Precision::High), PRECISION),
];

/// Words that every version reserves.
#[rustfmt::skip]
const RESERVED: [&str; 39] = [
    "asm", "class", "union", "enum", "typedef", "template",
    "this", "packed", "goto", "inline", "noinline", "volatile",
    "public", "static", "extern", "external", "interface", "long",
    "short", "double", "half", "fixed", "unsigned",
    "input", "output", "hvec2", "hvec3", "hvec4", "dvec2",
    "dvec3", "dvec4", "fvec2", "fvec3", "fvec4", "sampler3DRect",
    "sizeof", "cast", "namespace", "using",
];

/// Words that only these versions reserve, from the first to the last.
const RESERVED_EARLY: [(&str, Version, Version); 6] = [
    ("switch", Version::V110, Version::V120),
    ("superp", Version::Es100, Version::Es100),
    ("lowp", Version::V120, Version::V120),
    ("mediump", Version::V120, Version::V120),
    ("highp", Version::V120, Version::V120),
    ("precision", Version::V120, Version::V120),
];

/// Words that GLSL 1.30 reserves too, and 1.40 unless it uses them.
#[rustfmt::skip]
const RESERVED_130: [&str; 34] = [
    "common", "partition", "active", "filter", "image1D", "image2D",
    "image3D", "imageCube", "image1DArray", "image2DArray", "image1DShadow", "image2DShadow",
    "image1DArrayShadow", "image2DArrayShadow", "imageBuffer", "iimage1D", "iimage2D", "iimage3D",
    "iimageCube", "iimage1DArray", "iimage2DArray", "iimageBuffer", "uimage1D", "uimage2D",
    "uimage3D", "uimageCube", "uimage1DArray", "uimage2DArray", "uimageBuffer", "samplerBuffer",
    "sampler2DRect", "sampler2DRectShadow", "row_major", "superp",
];

/// Words that GLSL ES 1.00 reserves too (section 3.6).
#[rustfmt::skip]
const RESERVED_ES_100: [&str; 9] = [
    "flat", "superp", "sampler1D", "sampler3D", "sampler1DShadow", "sampler2DShadow", "sampler2DRect",
    "sampler2DRectShadow", "switch",
];

/// Words that GLSL ES 3.00 reserves beside those of GLSL 1.30 (section 3.7).
#[rustfmt::skip]
const RESERVED_ES_300: [&str; 30] = [
    "attribute", "varying", "coherent", "restrict", "readonly", "writeonly", "resource", "atomic_uint",
    "noperspective", "patch", "sample", "subroutine", "sampler1D", "sampler1DShadow", "sampler1DArray",
    "sampler1DArrayShadow", "isampler1D", "isampler1DArray", "usampler1D", "usampler1DArray", "isampler2DRect",
    "usampler2DRect", "isamplerBuffer", "usamplerBuffer", "sampler2DMS", "isampler2DMS", "usampler2DMS",
    "sampler2DMSArray", "isampler2DMSArray", "usampler2DMSArray",
];

/// Words that GLSL 1.30 reserves and GLSL ES 3.00 does not (section 3.7): the names of layouts, and the images with
/// comparison, which its sixth revision has struck out.
const FREE_IN_ES_300: [&str; 6] = [
    "packed",
    "row_major",
    "image1DShadow",
    "image2DShadow",
    "image1DArrayShadow",
    "image2DArrayShadow",
];

/// The class of a word in a version.
pub fn classify(word: &str, language: Language) -> WordClass {
    if Type::named(word, language).is_some() {
        return WordClass::Type;
    }
    let keyword = KEYWORDS.iter().any(|row| row.0 == word && language.has(row.1))
        || QUALIFIERS.iter().any(|row| row.0 == word && language.has(row.2));
    if keyword {
        return WordClass::Keyword;
    }
    if language.version == Version::Es300 && FREE_IN_ES_300.contains(&word) {
        return WordClass::Name;
    }
    let later = language.version >= Version::V130 && RESERVED_130.contains(&word);
    let early = |row: &(&str, Version, Version)| {
        row.0 == word && (row.1..=row.2).contains(&language.version)
    };
    let of_es = match language.version {
        Version::Es100 => RESERVED_ES_100.contains(&word),
        Version::Es300 => RESERVED_ES_300.contains(&word),
        Version::V110
        | Version::V120
        | Version::V130
        | Version::V140
        | Version::V150
        | Version::V330 => false,
    };
    if RESERVED.contains(&word) || of_es || later || RESERVED_EARLY.iter().any(early) {
        return WordClass::Reserved;
    }
    WordClass::Name
}

/// The qualifier that a word is.
pub fn qualifier(word: &str, language: Language) -> Option<Qualifier> {
    let row = QUALIFIERS.iter().find(|row| row.0 == word && language.has(row.2));
    row.map(|row| row.1)
}

/// The availability of a qualifier that the language of the shader does not have.
pub fn missing_qualifier(word: &str, language: Language) -> Option<Availability> {
    QUALIFIERS.iter().find(|row| row.0 == word && !language.has(row.2)).map(|row| row.2)
}

/// Whether the language has `layout(...)`.
pub fn has_layout(language: Language) -> bool {
    language.has(LAYOUT) || has_blocks(language)
}

/// Whether the language has what GLSL 4.20 has relaxed.
pub fn is_relaxed(language: Language) -> bool {
    language.has(Availability::RELAXED)
}

/// Whether the language has uniform blocks.
pub fn has_blocks(language: Language) -> bool {
    language.has(Availability::UNIFORM_BLOCKS)
}

/// The layout of uniform blocks that a word is.
pub fn block_layout(word: &str, language: Language) -> Option<BlockLayout> {
    let row = BLOCK_LAYOUTS.iter().find(|row| row.0 == word && has_blocks(language));
    row.map(|row| row.1)
}

/// The layout of `gl_FragDepth` that a word is.
pub fn depth_layout(word: &str, language: Language) -> Option<DepthLayout> {
    let has = language.has(Availability::CONSERVATIVE_DEPTH);
    DEPTHS.iter().find(|row| row.0 == word && has).map(|row| row.1)
}

/// The primitive of the geometry stage that a word is.
pub fn primitive_layout(word: &str, language: Language) -> Option<PrimitiveLayout> {
    let row = PRIMITIVES.iter().find(|row| row.0 == word && language.has(Availability::V150));
    row.map(|row| row.1)
}

/// Whether the language has unsigned integers.
pub fn has_unsigned(language: Language) -> bool {
    language.has(V130.or(Extension::GpuShader4))
}

/// Whether the language spells `uint` as `unsigned int` too.
pub fn has_unsigned_int(language: Language) -> bool {
    language.enabled(Extension::GpuShader4)
}

/// Whether the language has `precision` statements.
pub fn has_precision(language: Language) -> bool {
    language.has(PRECISION)
}

/// Every keyword of a version, for spelling suggestions.
pub fn known(language: Language) -> impl Iterator<Item = &'static str> {
    let words = KEYWORDS.iter().filter(move |row| language.has(row.1)).map(|row| row.0);
    words.chain(Type::names(language))
}
