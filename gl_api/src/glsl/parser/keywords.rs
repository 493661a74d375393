//! The words that are not names (GLSL 1.30 section 3.6).

use crate::glsl::ast::Qualifier;
use crate::glsl::types::Type;
use crate::glsl::version::{Extension, Language, Since, Version};

const ALWAYS: Since = Since::ALWAYS;
const V120: Since = Since::V120;
const V130: Since = Since::V130;
/// Words about precision, which GLSL ES had first.
const PRECISION: Since = V130.and_es();

/// What a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// A name.
    Name,
    /// The name of a type.
    Type,
    /// Any other keyword.
    Keyword,
    /// Reserved: an error wherever it stands.
    Reserved,
}

/// Keywords that are no types, and since when.
const KEYWORDS: [(&str, Since); 29] = [
    ("attribute", ALWAYS),
    ("const", ALWAYS),
    ("uniform", ALWAYS),
    ("varying", ALWAYS),
    ("break", ALWAYS),
    ("continue", ALWAYS),
    ("do", ALWAYS),
    ("for", ALWAYS),
    ("while", ALWAYS),
    ("if", ALWAYS),
    ("else", ALWAYS),
    ("in", ALWAYS),
    ("out", ALWAYS),
    ("inout", ALWAYS),
    ("true", ALWAYS),
    ("false", ALWAYS),
    ("discard", ALWAYS),
    ("return", ALWAYS),
    ("struct", ALWAYS),
    ("centroid", V120),
    ("invariant", V120.and_es()),
    ("flat", V130.or(Extension::GpuShader4)),
    ("smooth", V130),
    ("noperspective", V130.or(Extension::GpuShader4)),
    ("switch", V130),
    ("case", V130),
    ("default", ALWAYS),
    ("lowp", PRECISION),
    ("mediump", PRECISION),
];

/// Qualifiers, and since when.
const QUALIFIERS: [(&str, Qualifier, Since); 15] = [
    ("const", Qualifier::Const, ALWAYS),
    ("attribute", Qualifier::Attribute, ALWAYS),
    ("varying", Qualifier::Varying, ALWAYS),
    ("uniform", Qualifier::Uniform, ALWAYS),
    ("in", Qualifier::In, ALWAYS),
    ("out", Qualifier::Out, ALWAYS),
    ("inout", Qualifier::Inout, ALWAYS),
    ("centroid", Qualifier::Centroid, V120),
    ("invariant", Qualifier::Invariant, V120.and_es()),
    ("smooth", Qualifier::Smooth, V130),
    ("flat", Qualifier::Flat, V130.or(Extension::GpuShader4)),
    ("noperspective", Qualifier::NoPerspective, V130.or(Extension::GpuShader4)),
    ("lowp", Qualifier::Precision, PRECISION),
    ("mediump", Qualifier::Precision, PRECISION),
    ("highp", Qualifier::Precision, PRECISION),
];

/// Reserved words.
const RESERVED: [&str; 45] = [
    "asm",
    "class",
    "union",
    "enum",
    "typedef",
    "template",
    "this",
    "packed",
    "goto",
    "inline",
    "noinline",
    "volatile",
    "public",
    "static",
    "extern",
    "external",
    "interface",
    "long",
    "short",
    "double",
    "half",
    "fixed",
    "unsigned",
    "superp",
    "input",
    "output",
    "hvec2",
    "hvec3",
    "hvec4",
    "dvec2",
    "dvec3",
    "dvec4",
    "fvec2",
    "fvec3",
    "fvec4",
    "sampler3DRect",
    "sizeof",
    "cast",
    "namespace",
    "using",
    "common",
    "partition",
    "active",
    "filter",
    "precision",
];

/// What a word is in a version.
pub fn classify(word: &str, language: Language) -> Word {
    if Type::named(word, language).is_some() {
        return Word::Type;
    }
    let keyword = KEYWORDS.iter().any(|row| row.0 == word && language.has(row.1))
        || QUALIFIERS.iter().any(|row| row.0 == word && language.has(row.2));
    if keyword {
        return Word::Keyword;
    }
    // `common`, `partition`, `active` and `filter` came with 1.30.
    let from_130 = ["common", "partition", "active", "filter"].contains(&word);
    if RESERVED.contains(&word)
        && !(from_130 && language.version < Version::V130)
        && word != "precision"
    {
        return Word::Reserved;
    }
    Word::Name
}

/// The qualifier that a word is.
pub fn qualifier(word: &str, language: Language) -> Option<Qualifier> {
    let row = QUALIFIERS.iter().find(|row| row.0 == word && language.has(row.2));
    row.map(|row| row.1)
}

/// What brings a qualifier that the language of the shader lacks.
pub fn missing_qualifier(word: &str, language: Language) -> Option<Since> {
    QUALIFIERS.iter().find(|row| row.0 == word && !language.has(row.2)).map(|row| row.2)
}

/// Whether the language has `precision` statements.
pub fn has_precision(language: Language) -> bool {
    language.has(PRECISION)
}

/// Every keyword of a version, for misspelt words.
pub fn known(language: Language) -> impl Iterator<Item = &'static str> {
    let words = KEYWORDS.iter().filter(move |row| language.has(row.1)).map(|row| row.0);
    words.chain(Type::names(language))
}
