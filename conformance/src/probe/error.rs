//! Why a value cannot be measured.

/// Why a value cannot be measured.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProbeError {
    /// No context could be created.
    #[error("no context: {0}")]
    Context(String),
    /// A GL call failed.
    #[error("GL error {code:#06x} after {after}: {message}")]
    Gl {
        /// The operation.
        after: &'static str,
        /// The code that `glGetError` returned.
        code: u32,
        /// The context's message.
        message: String,
    },
    /// A shader did not compile, or a program not link.
    #[error("{stage} was rejected: {log}")]
    Shader {
        /// The stage, or "program".
        stage: &'static str,
        /// The info log.
        log: String,
    },
    /// Not every case has a result.
    #[error("{cases} cases have {measured} results")]
    Missing {
        /// The cases.
        cases: usize,
        /// Their results.
        measured: usize,
    },
}
