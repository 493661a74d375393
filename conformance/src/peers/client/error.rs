//! Why a driver cannot be used.

/// Why a driver cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ClientError {
    /// The library is not there, or is no EGL 1.4.
    #[error("{library} cannot be opened as EGL 1.4: {reason}")]
    Library {
        /// Its path or name.
        library: String,
        /// The loader's message.
        reason: String,
    },
    /// An EGL call failed.
    #[error("{call}: {reason}")]
    Egl {
        /// The call.
        call: &'static str,
        /// Its error.
        reason: String,
    },
    /// A shader does not compile, or a program does not link.
    #[error("the driver refuses a {stage}: {log}")]
    Shader {
        /// "vertex shader", "fragment shader" or "program".
        stage: &'static str,
        /// Its info log.
        log: String,
    },
    /// A GL call failed.
    #[error("{after}: glGetError is {code:#06x}")]
    Gl {
        /// The operation.
        after: &'static str,
        /// The code.
        code: u32,
    },
}
