//! Program objects: GL 2.1, section 2.15.2.

use crate::base::clamp::Clamp;
use crate::base::types::*;
use crate::glsl;
use crate::objects::blocks::BlockState;
use crate::objects::shaders::ShaderObject;
use crate::objects::shared::SharedObjects;
use rasterizer::driver::ShaderModule;
use rasterizer::ir::GeometryInterface;
use std::sync::Arc;

/// Shaders and programs share one space of names.
#[derive(Debug)]
pub(crate) enum ShaderOrProgram {
    Shader(ShaderObject),
    Program(Box<ProgramObject>),
}

/// How the last link of a program went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LinkStatus {
    /// It failed, or there was none.
    #[default]
    Failed,
    Linked,
}

/// A program object.
#[derive(Debug, Default)]
pub(crate) struct ProgramObject {
    /// The names of the attached shaders.
    pub attached: Vec<GLuint>,
    pub bindings: glsl::Bindings,
    /// The executable that draws run: the result of the last link, or of the one before if that failed while the
    /// program is in use (GL 2.1, section 2.15.2).
    pub executable: Option<Linked>,
    /// How the last link went.
    pub link: LinkStatus,
    pub log: String,
    pub validated: bool,
    /// `GL_PROGRAM_BINARY_RETRIEVABLE_HINT` of the last link, and what the next one takes.
    pub binary_hint: bool,
    pub next_binary_hint: bool,
    /// `GL_PROGRAM_SEPARABLE` of the next link.
    pub separable: glsl::Separable,
    pub doomed: bool,
}

/// What a program was linked from: pipelines link it with others.
#[derive(Debug, Default)]
pub(crate) struct LinkSources {
    pub shaders: Vec<glsl::Shader>,
    pub bindings: glsl::Bindings,
}

/// A linked program, ready to draw with.
#[derive(Debug)]
pub(crate) struct Linked {
    /// What it was linked from; another one after each link.
    pub sources: Arc<LinkSources>,
    pub program: glsl::Program,
    pub vertex: Option<ShaderModule>,
    /// The vertex stage with its colours as they are, for `glClampColor`; the same one if it writes
    /// none.
    pub unclamped_vertex: Option<ShaderModule>,
    pub geometry: Option<ShaderModule>,
    /// The geometry stage with its colours as they are.
    pub unclamped_geometry: Option<ShaderModule>,
    pub fragment: Option<ShaderModule>,
    /// The attributes that its vertex stage reads, bit by location.
    pub attributes: u64,
    /// The values of its uniforms; state is filled in when it draws.
    pub words: Vec<u32>,
    /// Its uniform blocks.
    pub blocks: Vec<BlockState>,
    /// The locations of uniforms that were set, one bit for each 64th.
    pub set: u64,
}

impl Linked {
    /// Whether the uniform at a location may have been set.
    pub fn is_set(&self, location: u32) -> bool {
        self.set >> (location % 64) & 1 == 1
    }

    /// The primitives of its geometry stage, and what it makes of them.
    pub fn geometry_interface(&self) -> Option<&GeometryInterface> {
        self.geometry.as_ref()?.module().geometry.as_ref()
    }

    /// The vertex stage with clamped or unclamped colours.
    pub fn vertex_of(&self, clamp: Clamp) -> &Option<ShaderModule> {
        match clamp {
            Clamp::On => &self.vertex,
            Clamp::Off => &self.unclamped_vertex,
        }
    }

    /// The geometry stage with clamped or unclamped colours.
    pub fn geometry_of(&self, clamp: Clamp) -> &Option<ShaderModule> {
        match clamp {
            Clamp::On => &self.geometry,
            Clamp::Off => &self.unclamped_geometry,
        }
    }
}

impl ProgramObject {
    /// The result of the last link, if it worked.
    pub fn linked(&self) -> Option<&Linked> {
        match self.link {
            LinkStatus::Linked => self.executable.as_ref(),
            LinkStatus::Failed => None,
        }
    }
}

impl Linked {
    /// The name of the uniform that has this word, quoted, after a space.
    pub fn quoted_name(&self, word: u32) -> String {
        let uniform = self.program.uniforms.iter().rfind(|uniform| uniform.word <= word);
        uniform.map_or_else(String::new, |uniform| format!(" \"{}\"", uniform.name))
    }
}

impl SharedObjects {
    /// The executable of a program.
    pub fn linked_program(&self, name: GLuint) -> Option<&Linked> {
        match self.programs.get(name)? {
            ShaderOrProgram::Program(program) => program.executable.as_ref(),
            ShaderOrProgram::Shader(_) => None,
        }
    }

    /// Removes programs that are deleted and that no context uses any more, and detaches their shaders.
    pub fn sweep_programs(&mut self) {
        for name in std::mem::take(&mut self.doomed_programs) {
            if self.programs.is_held(name) {
                self.doomed_programs.push(name);
                continue;
            }
            let attached = match self.programs.get_mut(name) {
                Some(ShaderOrProgram::Program(program)) => std::mem::take(&mut program.attached),
                Some(ShaderOrProgram::Shader(_)) | None => Vec::new(),
            };
            self.programs.remove(name);
            for name in attached {
                self.detach(name);
            }
        }
    }

    /// Detaches a shader from one program.
    pub fn detach(&mut self, name: GLuint) {
        if let Some(ShaderOrProgram::Shader(shader)) = self.programs.get_mut(name) {
            shader.attachments -= 1;
        }
        self.remove_unattached(name);
    }

    /// Removes a shader that was deleted, once it is attached to no program.
    pub fn remove_unattached(&mut self, name: GLuint) {
        if let Some(ShaderOrProgram::Shader(shader)) = self.programs.get(name)
            && shader.doomed
            && shader.attachments == 0
        {
            self.programs.remove(name);
        }
    }
}
