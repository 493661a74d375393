//! What a scene may ask for without effect.

/// Something that has no effect on a scene's picture.
#[derive(Clone, Copy, Debug)]
pub struct Feature {
    /// The name, for `--only`.
    pub name: &'static str,
    /// What is asked for, in words.
    pub what: &'static str,
    /// Sets the scene up without it, in a new context.
    pub plain: fn(),
    /// Sets the scene up with it, in a new context.
    pub asked: fn(),
    /// A frame without it.
    pub plain_frame: fn(),
    /// A frame with it.
    pub asked_frame: fn(),
    /// What its plan has to say.
    pub rule: Rule,
}

/// What the plan of a feature has to say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The work of the plain scene, and no more.
    SameWork,
    /// More than the plain scene, for a reason; the cost is reported.
    MoreWork(Reason),
}

/// Why a plan may do more than the plain scene's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It is left out for each block of pixels or each triangle, which no plan of a draw shows.
    DecidedPerBlock,
    /// It has to run: a later read or another value of the same state would see it.
    Visible,
    /// It is not left out yet.
    NotLeftOut,
}

impl Reason {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::DecidedPerBlock => "left out per block or triangle",
            Self::Visible => "runs: what it writes can be read later",
            Self::NotLeftOut => "not left out",
        }
    }
}

impl Feature {
    /// A feature of state: `asked` sets up what `plain` does and more; both draw the same frame.
    pub const fn state(
        name: &'static str,
        what: &'static str,
        plain: fn(),
        asked: fn(),
        frame: fn(),
    ) -> Self {
        let rule = Rule::SameWork;
        Self { name, what, plain, asked, plain_frame: frame, asked_frame: frame, rule }
    }

    /// A feature of what a frame calls.
    pub const fn calls(
        name: &'static str,
        what: &'static str,
        setup: fn(),
        plain_frame: fn(),
        asked_frame: fn(),
    ) -> Self {
        let rule = Rule::SameWork;
        Self { name, what, plain: setup, asked: setup, plain_frame, asked_frame, rule }
    }

    /// With work that the plan shows, for this reason.
    pub const fn because(self, reason: Reason) -> Self {
        Self { rule: Rule::MoreWork(reason), ..self }
    }
}
