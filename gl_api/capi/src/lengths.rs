//! How many elements a typed pointer of C has.
//!
//! The Khronos registry says so for nearly all: a number, another parameter, or a product
//! (`LENGTHS` is generated from it). Where it only names a formula (`COMPSIZE(pname)`), the formula
//! stands here; a new entry point whose formula is missing does not compile.

mod formulas;
mod named;

pub(crate) use formulas::values;

use super::param::{Counted, TERMINATED};
use formulas::{attached_shaders, block, buffer, map1, map2, of_program, uniform};
use gl_api::GLenum;
use gl_api::host::limits::{
    MAX_CAPTURED_COMPONENTS, MAX_DRAW_BUFFERS, MAX_ENV_PARAMETERS, MAX_LABEL, MAX_LENGTH,
    MAX_LOCAL_PARAMETERS, MAX_LOGGED, MAX_UNIFORM_ELEMENTS, MAX_VIEWPORTS,
};

/// What the registry says of a parameter.
#[derive(Clone, Copy)]
pub(crate) enum Length {
    /// Nothing, as for what is no pointer.
    Unsaid,
    /// So many.
    Fixed(usize),
    /// An argument, by position, times a number.
    Times(usize, usize),
    /// A formula of arguments, by position.
    Formula(&'static str, &'static [usize]),
}

include!(concat!(env!("OUT_DIR"), "/lengths.rs"));

/// How the length follows from the arguments.
#[derive(Clone, Copy)]
pub(crate) enum Rule {
    /// Not needed.
    None,
    /// So many.
    Fixed(usize),
    /// An argument, by position, times a number.
    Times(usize, usize),
    /// The same, of which nothing is read if the argument is larger than a limit: the call refuses it.
    TimesWithin { argument: usize, factor: usize, limit: usize },
    /// The same, of which no more is read than of the limit: the call has no use for the rest.
    TimesAtMost { argument: usize, factor: usize, limit: usize },
    /// As many as the state or parameter of that name has values; its position.
    Named(usize),
    /// Computed from all arguments.
    Computed(fn(&[isize]) -> usize),
    /// Text that a zero ends.
    Terminated,
    /// Text as long as an argument says, by position; a negative one means that a zero ends it.
    Text(usize),
    /// The same, of which nothing is read if it is so long or longer: the call refuses it by its length.
    TextBelow(usize, usize),
}

/// `glGetDebugMessageLog`: an element for each message, of which there are no more than the log has.
const PER_MESSAGE: Rule = Rule::TimesAtMost { argument: 0, factor: 1, limit: MAX_LOGGED };

/// Where the registry is silent, says the largest of several lengths, or where a call has a limit; by the first name of
/// an entry point, for its other names too.
const OVERRIDES: &[(&str, usize, Rule)] = &[
    ("glGetVertexAttribfv", 2, Rule::Named(1)),
    ("glGetVertexAttribdv", 2, Rule::Named(1)),
    ("glGetVertexAttribiv", 2, Rule::Named(1)),
    ("glGetVertexAttribIiv", 2, Rule::Named(1)),
    ("glGetVertexAttribIuiv", 2, Rule::Named(1)),
    // The registry names the array `count`, whose length `drawcount` is.
    ("glMultiDrawArrays", 1, Rule::Times(3, 1)),
    ("glGetMultisamplefv", 2, Rule::Fixed(2)),
    ("glPolygonStipple", 0, Rule::Fixed(128)),
    ("glGetPolygonStipple", 0, Rule::Fixed(128)),
    ("glDebugMessageInsert", 5, Rule::TextBelow(4, MAX_LENGTH)),
    ("glPushDebugGroup", 3, Rule::TextBelow(2, MAX_LENGTH)),
    ("glObjectLabel", 3, Rule::TextBelow(2, MAX_LABEL)),
    ("glObjectPtrLabel", 2, Rule::TextBelow(1, MAX_LABEL)),
    (
        "glProgramEnvParameters4fvEXT",
        3,
        Rule::TimesWithin { argument: 2, factor: 4, limit: MAX_ENV_PARAMETERS },
    ),
    (
        "glProgramLocalParameters4fvEXT",
        3,
        Rule::TimesWithin { argument: 2, factor: 4, limit: MAX_LOCAL_PARAMETERS },
    ),
    ("glViewportArrayv", 2, Rule::TimesWithin { argument: 1, factor: 4, limit: MAX_VIEWPORTS }),
    ("glScissorArrayv", 2, Rule::TimesWithin { argument: 1, factor: 4, limit: MAX_VIEWPORTS }),
    ("glDepthRangeArrayv", 2, Rule::TimesWithin { argument: 1, factor: 2, limit: MAX_VIEWPORTS }),
    ("glDrawBuffers", 1, Rule::TimesWithin { argument: 0, factor: 1, limit: MAX_DRAW_BUFFERS }),
    // Linking fails with one component more than the limit.
    (
        "glTransformFeedbackVaryings",
        2,
        Rule::TimesAtMost { argument: 1, factor: 1, limit: MAX_CAPTURED_COMPONENTS + 1 },
    ),
    ("glGetDebugMessageLog", 2, PER_MESSAGE),
    ("glGetDebugMessageLog", 3, PER_MESSAGE),
    ("glGetDebugMessageLog", 4, PER_MESSAGE),
    ("glGetDebugMessageLog", 5, PER_MESSAGE),
    ("glGetDebugMessageLog", 6, PER_MESSAGE),
    ("glGetSynciv", 4, Rule::TimesAtMost { argument: 2, factor: 1, limit: 1 }),
    ("glGetAttachedShaders", 3, Rule::Computed(attached_shaders)),
    ("glGetActiveUniformsiv", 2, Rule::Computed(of_program)),
    ("glGetActiveUniformsiv", 4, Rule::Computed(of_program)),
];

const fn same(a: &str, b: &str) -> bool {
    matches!(order(a.as_bytes(), b.as_bytes()), std::cmp::Ordering::Equal)
}

const fn order(a: &[u8], b: &[u8]) -> std::cmp::Ordering {
    let mut at = 0;
    while at < a.len() && at < b.len() {
        if a[at] < b[at] {
            return std::cmp::Ordering::Less;
        }
        if a[at] > b[at] {
            return std::cmp::Ordering::Greater;
        }
        at += 1;
    }
    if a.len() < b.len() {
        std::cmp::Ordering::Less
    } else if a.len() > b.len() {
        std::cmp::Ordering::Greater
    } else {
        std::cmp::Ordering::Equal
    }
}

const fn registry(command: &str) -> &'static [Length] {
    let (mut low, mut high) = (0, LENGTHS.len());
    while low < high {
        let middle = usize::midpoint(low, high);
        match order(LENGTHS[middle].0.as_bytes(), command.as_bytes()) {
            std::cmp::Ordering::Less => low = middle + 1,
            std::cmp::Ordering::Greater => high = middle,
            std::cmp::Ordering::Equal => return LENGTHS[middle].1,
        }
    }
    panic!("an entry point that is not in the Khronos registry")
}

const fn overridden(rows: &[(&str, usize, Rule)], command: &str, parameter: usize) -> Option<Rule> {
    let mut at = 0;
    while at < rows.len() {
        if rows[at].1 == parameter && same(rows[at].0, command) {
            return Some(rows[at].2);
        }
        at += 1;
    }
    None
}

const fn rule(length: Length) -> Rule {
    match length {
        Length::Fixed(count) => Rule::Fixed(count),
        Length::Times(argument, factor) => Rule::Times(argument, factor),
        Length::Formula(formula, arguments) => {
            if same(formula, "COMPSIZE(pname)")
                || same(formula, "COMPSIZE(target,pname)")
                || same(formula, "COMPSIZE(id,pname)")
                || same(formula, "COMPSIZE(target)")
            {
                Rule::Named(arguments[arguments.len() - 1])
            } else if same(formula, "COMPSIZE(drawcount)")
                || same(formula, "COMPSIZE(primcount)")
                || same(formula, "COMPSIZE(count)")
                || same(formula, "COMPSIZE(uniformCount)")
                || same(formula, "COMPSIZE(uniformCount,pname)")
            {
                Rule::Times(arguments[0], 1)
            } else if same(formula, "COMPSIZE(program,location)")
                || same(formula, "COMPSIZE(programObj,location)")
            {
                Rule::Computed(uniform)
            } else if same(formula, "COMPSIZE(program,uniformBlockIndex,pname)") {
                Rule::Computed(block)
            } else if same(formula, "COMPSIZE(buffer)") {
                Rule::Computed(buffer)
            } else if same(formula, "COMPSIZE(target,stride,order)") {
                Rule::Computed(map1)
            } else if same(formula, "COMPSIZE(target,ustride,uorder,vstride,vorder)") {
                Rule::Computed(map2)
            } else {
                panic!(
                    "the length of a pointer is a formula that gl_api/capi/src/lengths.rs lacks: add it"
                )
            }
        }
        Length::Unsaid => {
            panic!("the registry has no length for a pointer: add a row to OVERRIDES")
        }
    }
}

/// Text has a length only beside one that is an argument.
const fn text_rule(length: Length) -> Rule {
    match length {
        Length::Formula(_, arguments) if arguments.len() == 2 => Rule::Text(arguments[1]),
        Length::Times(argument, 1) => Rule::Text(argument),
        Length::Formula(..) | Length::Times(..) | Length::Fixed(_) | Length::Unsaid => {
            Rule::Terminated
        }
    }
}

/// `glUniform*v` and `glProgramUniform*v` take no more elements than an array of uniforms has.
const fn limited(command: &str, rule: Rule) -> Rule {
    match rule {
        Rule::Times(argument, factor)
            if begins(command, "glUniform") || begins(command, "glProgramUniform") =>
        {
            Rule::TimesAtMost { argument, factor, limit: MAX_UNIFORM_ELEMENTS }
        }
        rule => rule,
    }
}

const fn begins(text: &str, beginning: &str) -> bool {
    let (text, beginning) = (text.as_bytes(), beginning.as_bytes());
    let mut at = 0;
    while at < beginning.len() {
        if at >= text.len() || text[at] != beginning[at] {
            return false;
        }
        at += 1;
    }
    true
}

/// The rules of the parameters of an entry point, which is named `first` in the table and `command` here; `counted` says
/// which need one.
pub(crate) const fn rules<const N: usize>(
    first: &str,
    command: &str,
    counted: [Counted; N],
) -> [Rule; N] {
    let (lengths, of_first) = (registry(command), registry(first));
    let mut rules = [Rule::None; N];
    let mut at = 0;
    while at < N {
        let rule_of_row = match overridden(OVERRIDES, first, at) {
            None => overridden(named::OVERRIDES, first, at),
            found => found,
        };
        rules[at] = match (counted[at], rule_of_row) {
            (Counted::No, _) => Rule::None,
            (Counted::Elements | Counted::Text, Some(rule)) => rule,
            (Counted::Elements, None) => {
                // The registry says less of some names of extensions.
                let length = match lengths[at] {
                    Length::Unsaid => of_first[at],
                    said => said,
                };
                limited(command, rule(length))
            }
            (Counted::Text, None) => text_rule(lengths[at]),
        };
        at += 1;
    }
    rules
}

/// Parameters of an entry point, at most.
const MAX_PARAMETERS: usize = 16;

/// How many bytes each pointer of a call stands for; `sizes` are those of an element.
#[inline(never)]
pub(crate) fn extents(
    rules: &[Rule],
    sizes: &[usize],
    arguments: &[isize],
) -> [usize; MAX_PARAMETERS] {
    let mut extents = [0; MAX_PARAMETERS];
    for (extent, (rule, size)) in extents.iter_mut().zip(rules.iter().zip(sizes)) {
        *extent = match size {
            0 => 0,
            size => rule.length(arguments).saturating_mul(*size),
        };
    }
    extents
}

impl Rule {
    /// The length, of a call with these arguments; 0 for negative ones, which the call refuses.
    #[inline]
    pub(crate) fn length(self, arguments: &[isize]) -> usize {
        match self {
            Self::None => 0,
            Self::Fixed(count) => count,
            Self::Times(argument, factor) => {
                usize::try_from(arguments[argument]).unwrap_or(0).saturating_mul(factor)
            }
            Self::TimesWithin { argument, factor, limit } => {
                let count = usize::try_from(arguments[argument]).unwrap_or(0);
                if count > limit { 0 } else { count * factor }
            }
            Self::TimesAtMost { argument, factor, limit } => {
                usize::try_from(arguments[argument]).unwrap_or(0).min(limit) * factor
            }
            Self::Named(argument) => values(arguments[argument] as GLenum),
            Self::Computed(formula) => formula(arguments),
            Self::Terminated => TERMINATED,
            Self::Text(argument) => usize::try_from(arguments[argument]).unwrap_or(TERMINATED),
            Self::TextBelow(argument, limit) => match usize::try_from(arguments[argument]) {
                Ok(length) if length >= limit => 0,
                Ok(length) => length,
                Err(_) => TERMINATED,
            },
        }
    }
}
