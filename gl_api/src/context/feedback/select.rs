//! The name stack and hit records: GL 2.1, section 5.2.

use crate::base::error::{ErrorCode, GlError, Result, invalid_operation};
use crate::base::types::*;
use crate::context::feedback::Target;

const SECTION: &str = "GL 2.1, section 5.2";

/// The stack holds so many names (GL 2.1, table 6.36 asks for 64).
pub(crate) const MAX_NAME_STACK_DEPTH: usize = 64;

/// Selection: the names, and the records of what was hit.
#[derive(Debug, Default)]
pub(crate) struct Select {
    target: Option<Target>,
    size: usize,
    names: Vec<GLuint>,
    /// The least and the largest depth of primitives since the names changed last.
    hit: Option<[f64; 2]>,
    hits: GLint,
    records: Vec<GLuint>,
    overflowed: bool,
}

impl Select {
    pub fn target(&self) -> Option<Target> {
        self.target
    }

    pub fn set_target(&mut self, size: usize, target: Target) {
        (self.size, self.target) = (size, Some(target));
    }

    /// Numbers that the buffer holds.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Names on the stack.
    pub fn depth(&self) -> usize {
        self.names.len()
    }

    pub fn records(&self) -> &[GLuint] {
        &self.records
    }

    /// A mode begins: no names. What the last selection found stays to be read until the next one.
    pub fn enter(&mut self) {
        self.names.clear();
        self.hit = None;
        self.hits = 0;
        self.overflowed = false;
    }

    /// Selection ends: how many hits there were, or -1 where the buffer was too small.
    pub fn leave(&mut self) -> GLint {
        self.finish_hit();
        if let Some(Target::Client(pointer)) = self.target {
            let bytes: &[u8] = bytemuck::cast_slice(&self.records);
            pointer.bytes_mut(bytes.len()).copy_from_slice(bytes);
        }
        if self.overflowed { -1 } else { self.hits }
    }

    /// A primitive reaches this window depth.
    pub fn hit(&mut self, z: f64) {
        let [least, most] = self.hit.unwrap_or([z; 2]);
        self.hit = Some([least.min(z), most.max(z)]);
    }

    /// Writes the record of a hit, if there was one, before the names change.
    fn finish_hit(&mut self) {
        let Some(depths) = self.hit.take() else { return };
        if self.hits == 0 {
            self.records.clear();
        }
        self.hits = self.hits.saturating_add(1);
        let depths = depths.map(|z| (z.clamp(0.0, 1.0) * f64::from(u32::MAX)).round_ties_even());
        let head = [self.names.len() as GLuint, depths[0] as GLuint, depths[1] as GLuint];
        for value in head.into_iter().chain(self.names.iter().copied()) {
            if self.records.len() < self.size {
                self.records.push(value);
            } else {
                self.overflowed = true;
            }
        }
    }

    pub fn init_names(&mut self) {
        self.finish_hit();
        self.names.clear();
    }

    pub fn load_name(&mut self, name: GLuint) -> Result<()> {
        if self.names.is_empty() {
            return invalid_operation(SECTION, "the name stack is empty: call glPushName");
        }
        self.finish_hit();
        if let Some(top) = self.names.last_mut() {
            *top = name;
        }
        Ok(())
    }

    pub fn push_name(&mut self, name: GLuint) -> Result<()> {
        if self.names.len() >= MAX_NAME_STACK_DEPTH {
            return stack_error(
                ErrorCode::StackOverflow,
                format!("the stack has {MAX_NAME_STACK_DEPTH} names: glPopName is missing"),
            );
        }
        self.finish_hit();
        self.names.push(name);
        Ok(())
    }

    pub fn pop_name(&mut self) -> Result<()> {
        if self.names.is_empty() {
            let rule = "the name stack is empty: glPushName is missing".into();
            return stack_error(ErrorCode::StackUnderflow, rule);
        }
        self.finish_hit();
        self.names.pop();
        Ok(())
    }
}

fn stack_error(code: ErrorCode, rule: String) -> Result<()> {
    Err(GlError::new(code, SECTION, rule))
}
