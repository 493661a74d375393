//! The comparisons of depth, alpha and stencil tests and of shadow lookups.

use crate::base::constants::*;
use crate::base::error::Table;
use texunit::sampler::Compare;

pub(crate) const COMPARE: Table<Compare> = Table {
    section: "GL 2.1, section 4.1.5",
    rows: &[
        (GL_NEVER, Compare::Never),
        (GL_LESS, Compare::Less),
        (GL_EQUAL, Compare::Equal),
        (GL_LEQUAL, Compare::LessEqual),
        (GL_GREATER, Compare::Greater),
        (GL_NOTEQUAL, Compare::NotEqual),
        (GL_GEQUAL, Compare::GreaterEqual),
        (GL_ALWAYS, Compare::Always),
    ],
};
