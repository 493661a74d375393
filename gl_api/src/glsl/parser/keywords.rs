//! The words that are not names (GLSL 1.30 section 3.6).

use crate::glsl::ast::Qualifier;
use crate::glsl::types::Type;
use crate::glsl::version::Version;
use Version::{V110, V120, V130};

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
const KEYWORDS: [(&str, Version); 29] = [
    ("attribute", V110),
    ("const", V110),
    ("uniform", V110),
    ("varying", V110),
    ("break", V110),
    ("continue", V110),
    ("do", V110),
    ("for", V110),
    ("while", V110),
    ("if", V110),
    ("else", V110),
    ("in", V110),
    ("out", V110),
    ("inout", V110),
    ("true", V110),
    ("false", V110),
    ("discard", V110),
    ("return", V110),
    ("struct", V110),
    ("centroid", V120),
    ("invariant", V120),
    ("flat", V130),
    ("smooth", V130),
    ("noperspective", V130),
    ("switch", V130),
    ("case", V130),
    ("default", V110),
    ("lowp", V130),
    ("mediump", V130),
];

/// Qualifiers, and since when.
const QUALIFIERS: [(&str, Qualifier, Version); 15] = [
    ("const", Qualifier::Const, V110),
    ("attribute", Qualifier::Attribute, V110),
    ("varying", Qualifier::Varying, V110),
    ("uniform", Qualifier::Uniform, V110),
    ("in", Qualifier::In, V110),
    ("out", Qualifier::Out, V110),
    ("inout", Qualifier::Inout, V110),
    ("centroid", Qualifier::Centroid, V120),
    ("invariant", Qualifier::Invariant, V120),
    ("smooth", Qualifier::Smooth, V130),
    ("flat", Qualifier::Flat, V130),
    ("noperspective", Qualifier::NoPerspective, V130),
    ("lowp", Qualifier::Precision, V130),
    ("mediump", Qualifier::Precision, V130),
    ("highp", Qualifier::Precision, V130),
];

/// Reserved words.
const RESERVED: [&str; 47] = [
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
    "sampler2DRect",
    "sampler3DRect",
    "sampler2DRectShadow",
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
pub fn classify(word: &str, version: Version) -> Word {
    if Type::named(word, version).is_some() {
        return Word::Type;
    }
    let keyword = KEYWORDS.iter().any(|row| row.0 == word && row.1 <= version)
        || QUALIFIERS.iter().any(|row| row.0 == word && row.2 <= version);
    if keyword {
        return Word::Keyword;
    }
    // `common`, `partition`, `active` and `filter` came with 1.30.
    let from_130 = ["common", "partition", "active", "filter"].contains(&word);
    if RESERVED.contains(&word) && !(from_130 && version < V130) && word != "precision" {
        return Word::Reserved;
    }
    Word::Name
}

/// The qualifier that a word is.
pub fn qualifier(word: &str, version: Version) -> Option<Qualifier> {
    let row = QUALIFIERS.iter().find(|row| row.0 == word && row.2 <= version);
    row.map(|row| row.1)
}

/// Whether a word is a qualifier of a later version, and of which.
pub fn later_qualifier(word: &str, version: Version) -> Option<Version> {
    QUALIFIERS.iter().find(|row| row.0 == word && row.2 > version).map(|row| row.2)
}

/// Every keyword of a version, for misspelt words.
pub fn known(version: Version) -> impl Iterator<Item = &'static str> {
    let words = KEYWORDS.iter().filter(move |row| row.1 <= version).map(|row| row.0);
    words.chain(Type::names(version))
}
