//! What the core profile of OpenGL 3.3 has removed (GL 3.3, appendix E.2.2): commands by the Khronos registry, and
//! values of enums, with what takes their place.

use super::availability::{Api, Availability, REMOVED_VALUES, has_name};
use super::constants::enum_name;
use super::error::{ErrorCode, GlError};
use super::types::GLenum;
use super::version;

const SECTION: &str = "GL 3.3, appendix E.2.2";

/// Whether the core profile has a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InCore {
    /// In its version or by an extension.
    Kept,
    /// Only the compatibility profile has it.
    Removed,
}

/// Commands of `EXT_framebuffer_multisample` under a name of its own, which Mesa's core contexts have.
const ALSO_KEPT: [&str; 1] = ["glRenderbufferStorageMultisampleEXT"];

impl InCore {
    /// Of a command with these names.
    pub const fn of(names: &[&str]) -> Self {
        let mut at = 0;
        while at < names.len() {
            if has_name(&ALSO_KEPT, names[at]) {
                return Self::Kept;
            }
            if let Some(availability) = super::availability::of(names[at])
                && has(&availability)
            {
                return Self::Kept;
            }
            at += 1;
        }
        Self::Removed
    }
}

/// Whether core contexts have what is available there.
pub const fn has(availability: &Availability) -> bool {
    if availability.is_in(Api::Core, version::IMPLEMENTED) {
        return true;
    }
    let mut at = 0;
    while at < availability.extensions.len() {
        let apis = availability.extensions[at].apis;
        let mut api = 0;
        while api < apis.len() {
            if matches!(apis[api], Api::Core) {
                return true;
            }
            api += 1;
        }
        at += 1;
    }
    false
}

/// An argument of a call to a core context.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// Its name.
    pub name: &'static str,
    /// Its type, as Rust writes it.
    pub ty: &'static str,
    /// Its value; 0 for pointers and floats.
    pub value: i64,
}

/// The first rule of the core profile that a call breaks.
#[inline(never)]
pub fn check(
    command: &'static str,
    in_core: InCore,
    arguments: &[Argument],
) -> Result<(), GlError> {
    if in_core == InCore::Removed {
        let rule = format!("was removed from core profiles{}", replacement(command));
        return Err(GlError::new(ErrorCode::InvalidOperation, SECTION, rule));
    }
    arguments.iter().try_for_each(check_argument)
}

/// The enum that an argument is, and the error flag where a profile does not have its value; `None` for what is no enum.
pub(super) fn enum_of(argument: &Argument) -> Option<(GLenum, ErrorCode)> {
    let Argument { name, ty, value } = *argument;
    match (ty, name) {
        ("GLenum", _) | ("GLint", "param") => Some((value as GLenum, ErrorCode::InvalidEnum)),
        ("GLint", "internalformat") => Some((value as GLenum, ErrorCode::InvalidValue)),
        (_, _) => None,
    }
}

fn check_argument(argument: &Argument) -> Result<(), GlError> {
    let Argument { name, ty, value } = *argument;
    match (ty, name) {
        // Of glTexImage: the number of components was removed too.
        ("GLint", "internalformat") if (1..=4).contains(&value) => {
            let rule = format!(
                "internalformat = {value}: numbers of components were removed from core profiles; name a format, as \
                 GL_RGBA8"
            );
            return Err(GlError::new(ErrorCode::InvalidValue, SECTION, rule));
        }
        ("GLint", "border") if value != 0 => {
            let rule = format!(
                "border = {value} must be 0: borders of textures were removed from core profiles; use \
                 GL_CLAMP_TO_BORDER"
            );
            return Err(GlError::new(ErrorCode::InvalidValue, SECTION, rule));
        }
        (_, _) => {}
    }
    let Some((symbol, code)) = enum_of(argument) else { return Ok(()) };
    // Of glDrawArrays and its kin; the values are too small to be told apart from others.
    let removed_mode = match (name, symbol) {
        ("mode", 7) => "GL_QUADS",
        ("mode", 8) => "GL_QUAD_STRIP",
        ("mode", 9) => "GL_POLYGON",
        (_, _) => "",
    };
    if !removed_mode.is_empty() {
        let rule = format!("mode = {removed_mode} was removed from core profiles; draw triangles");
        return Err(GlError::new(code, SECTION, rule));
    }
    // GL_TEXTUREi has the values of other enums from 32 on; glActiveTexture knows how many there are.
    if name == "texture" {
        return Ok(());
    }
    if REMOVED_VALUES.binary_search(&symbol).is_ok() {
        return Err(removed_value(name, symbol, code));
    }
    Ok(())
}

/// The error for an argument whose value core profiles do not have.
#[cold]
pub fn removed_value(argument: &str, value: GLenum, code: ErrorCode) -> GlError {
    let name = enum_name(value);
    let instead = replacement(&name);
    let rule = format!("{argument} = {name} was removed from core profiles{instead}");
    GlError::new(code, SECTION, rule)
}

/// What takes the place of a command or a value whose name begins so; the longest beginning counts.
const REPLACEMENTS: &[(&[&str], &str)] = &[
    (
        &[
            "glBegin",
            "glEnd",
            "glVertex",
            "glNormal",
            "glColor",
            "glTexCoord",
            "glMultiTexCoord",
            "glSecondaryColor",
            "glFogCoord",
            "glIndex",
            "glEdgeFlag",
            "glArrayElement",
            "glRect",
            "glEnableClientState",
            "glDisableClientState",
            "glClientActiveTexture",
            "glInterleavedArrays",
            "glEval",
            "glMap1",
            "glMap2",
            "glMapGrid",
            "GL_VERTEX_ARRAY_",
            "GL_NORMAL_ARRAY",
            "GL_COLOR_ARRAY",
            "GL_TEXTURE_COORD_ARRAY",
            "GL_MAP1",
            "GL_MAP2",
        ],
        "put vertices into a buffer and use glVertexAttribPointer, glEnableVertexAttribArray and glDrawArrays",
    ),
    (
        &[
            "glMatrixMode",
            "glLoadMatrix",
            "glLoadIdentity",
            "glLoadTransposeMatrix",
            "glMultMatrix",
            "glMultTransposeMatrix",
            "glPushMatrix",
            "glPopMatrix",
            "glRotate",
            "glScale",
            "glTranslate",
            "glOrtho",
            "glFrustum",
            "GL_MODELVIEW",
            "GL_PROJECTION",
            "GL_TEXTURE_MATRIX",
            "GL_MATRIX_MODE",
        ],
        "compute matrices in the program and pass them with glUniformMatrix4fv",
    ),
    (
        &[
            "glLight",
            "glMaterial",
            "glShadeModel",
            "glFog",
            "glTexEnv",
            "glTexGen",
            "glAlphaFunc",
            "glColorMaterial",
            "glClipPlane",
            "GL_LIGHT",
            "GL_COLOR_MATERIAL",
            "GL_NORMALIZE",
            "GL_RESCALE_NORMAL",
            "GL_FOG",
            "GL_ALPHA_TEST",
            "GL_TEXTURE_GEN",
            "GL_TEXTURE_ENV",
            "GL_COLOR_SUM",
        ],
        "compute it in shaders (glUseProgram; discard, gl_ClipDistance)",
    ),
    (
        &[
            "glNewList",
            "glEndList",
            "glCallList",
            "glGenLists",
            "glDeleteLists",
            "glIsList",
            "glListBase",
            "GL_LIST",
        ],
        "keep what is drawn again in buffers and vertex array objects",
    ),
    (
        &["glPushAttrib", "glPopAttrib", "glPushClientAttrib", "glPopClientAttrib"],
        "set the state that was changed back",
    ),
    (
        &[
            "glDrawPixels",
            "glBitmap",
            "glRasterPos",
            "glWindowPos",
            "glPixelZoom",
            "glCopyPixels",
            "glPixelMap",
        ],
        "draw a textured rectangle, or copy with glBlitFramebuffer",
    ),
    (&["glPixelTransfer"], "compute it in shaders"),
    (&["glAccum", "glClearAccum"], "add up in a framebuffer object with a floating-point format"),
    (
        &["glRenderMode", "glSelectBuffer", "glFeedbackBuffer"],
        "draw object numbers into an integer format, or capture",
    ),
    (&["GL_POINT_SPRITE"], "points always have gl_PointCoord"),
    (
        &[
            "GL_POINT_SMOOTH",
            "GL_LINE_STIPPLE",
            "GL_POLYGON_STIPPLE",
            "glLineStipple",
            "glPolygonStipple",
        ],
        "compute it in the fragment shader",
    ),
    (&["GL_CLAMP"], "use GL_CLAMP_TO_EDGE"),
    (&["GL_GENERATE_MIPMAP"], "call glGenerateMipmap"),
    (&["GL_LUMINANCE_ALPHA", "GL_LUMINANCE8_ALPHA8"], "use GL_RG with GL_TEXTURE_SWIZZLE_RGBA"),
    (&["GL_LUMINANCE", "GL_INTENSITY", "GL_ALPHA"], "use GL_RED with GL_TEXTURE_SWIZZLE_RGBA"),
    (&["GL_DEPTH_TEXTURE_MODE"], "use GL_TEXTURE_SWIZZLE_RGBA"),
    (&["GL_EXTENSIONS"], "call glGetStringi"),
    (
        &["GL_MAX_TEXTURE_UNITS", "GL_MAX_TEXTURE_COORDS"],
        "ask for GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS",
    ),
    (
        &[
            "glProgram",
            "glBindProgram",
            "glGenPrograms",
            "glDeletePrograms",
            "GL_VERTEX_PROGRAM_ARB",
            "GL_FRAGMENT_PROGRAM_ARB",
        ],
        "write shaders in GLSL",
    ),
];

pub(super) fn replacement(name: &str) -> String {
    let rows = REPLACEMENTS.iter();
    let beginnings =
        rows.flat_map(|(names, instead)| names.iter().map(move |begin| (begin, instead)));
    let fitting = beginnings.filter(|(begin, _)| name.starts_with(**begin));
    match fitting.max_by_key(|(begin, _)| begin.len()) {
        Some((_, instead)) => format!("; {instead}"),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::constants::*;

    fn keeps(name: &str) -> bool {
        InCore::of(&[name]) == InCore::Kept
    }

    #[test]
    fn commands_are_removed_as_the_registry_says() {
        let removed = [
            "glBegin",
            "glEnableClientState",
            "glMatrixMode",
            "glNewList",
            "glTexEnvi",
            "glDrawPixels",
        ];
        removed.iter().for_each(|name| assert!(!keeps(name), "{name}"));
        let kept = [
            "glDrawArrays",
            "glBindTexture",
            "glTexStorage2D",
            "glVertexAttrib4f",
            "glDebugMessageCallback",
        ];
        kept.iter().for_each(|name| assert!(keeps(name), "{name}"));
        assert_eq!(InCore::of(&["glBindFramebufferEXT", "glBindFramebuffer"]), InCore::Kept);
    }

    #[test]
    fn values_are_removed_that_no_use_of_the_core_profile_has() {
        for value in [
            GL_CLAMP,
            GL_LUMINANCE,
            GL_ALPHA_TEST,
            GL_LIGHTING,
            GL_MODELVIEW_MATRIX,
            GL_GENERATE_MIPMAP,
        ] {
            assert!(REMOVED_VALUES.binary_search(&value).is_ok(), "{}", enum_name(value));
        }
        for value in [
            GL_TEXTURE_2D,
            GL_RGBA8,
            GL_CLAMP_TO_EDGE,
            GL_CLIP_DISTANCE0,
            GL_FRONT,
            GL_TRIANGLES,
            GL_ZERO,
        ] {
            assert!(REMOVED_VALUES.binary_search(&value).is_err(), "{}", enum_name(value));
        }
    }

    #[test]
    fn the_message_says_what_takes_the_place() {
        let error = check("glRotatef", InCore::Removed, &[]).expect_err("it was removed");
        assert!(error.to_string().contains("glUniformMatrix4fv"), "{error}");
        let argument = Argument { name: "param", ty: "GLint", value: i64::from(GL_CLAMP) };
        let error =
            check("glTexParameteri", InCore::Kept, &[argument]).expect_err("it was removed");
        assert!(error.to_string().contains("GL_CLAMP_TO_EDGE"), "{error}");
    }
}
