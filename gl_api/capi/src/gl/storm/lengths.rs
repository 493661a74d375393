//! How much memory the specification gives each pointer.

use super::random::{FORMATS, TYPES};
use crate::lengths::Rule;
use crate::param::TERMINATED;
use gl_api::GLenum;
use gl_api::constants::*;

/// What a count is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Counts {
    /// Small, and the memory has so many elements.
    Honest,
    /// Negative or huge, of the parameter of this number; the memory has a few elements.
    Hostile(usize),
}

/// Whether a parameter says how much memory there is, or how large an image is.
pub(super) fn is_count(name: &str, ty: &str) -> bool {
    matches!(ty, "GLsizei" | "GLsizeiptr" | "GLintptr")
        || matches!(
            name,
            "order"
                | "uorder"
                | "vorder"
                | "stride"
                | "ustride"
                | "vstride"
                | "count"
                | "size"
                | "n"
        )
}

/// Bytes of pixels in rows that begin at multiples of 4 (GL 2.1, section 3.6.4): the last row has no padding.
pub(super) fn image(size: [isize; 3], format: isize, ty: isize) -> Option<usize> {
    let components = FORMATS.iter().find(|row| row.0 == format as GLenum)?.1;
    let &(_, bytes, packed) = TYPES.iter().find(|row| row.0 == ty as GLenum)?;
    let [width, height, depth] = size.map(|side| usize::try_from(side).unwrap_or(0));
    let row = width * bytes * if packed { 1 } else { components };
    match width * height * depth {
        0 => Some(0),
        _ => Some(row.next_multiple_of(4) * (height * depth - 1) + row),
    }
}

pub(super) fn bits(width: isize, height: isize) -> Option<usize> {
    let (width, height) = (usize::try_from(width).ok()?, usize::try_from(height).ok()?);
    let row = width.div_ceil(8);
    Some(if row * height == 0 { 0 } else { row.next_multiple_of(4) * (height - 1) + row })
}

/// Bytes of an index, and of a name of a list.
pub(super) fn element(ty: isize) -> usize {
    match ty as GLenum {
        GL_UNSIGNED_BYTE | GL_BYTE => 1,
        GL_UNSIGNED_SHORT | GL_SHORT | GL_2_BYTES => 2,
        GL_3_BYTES => 3,
        _ => 4,
    }
}

/// How many bytes an untyped pointer stands for; `None` where the null pointer is passed: what a call keeps, and what
/// no formula of arguments says.
pub(super) fn data_bytes(name: &str, a: &[isize]) -> Option<usize> {
    let many = |count: isize, each: usize| Some(usize::try_from(count).unwrap_or(0) * each);
    match name {
        "glBitmap" => bits(a[0], a[1]),
        "glPolygonStipple" | "glGetPolygonStipple" => Some(128),
        "glCallLists" => many(a[0], element(a[1])),
        "glTexImage1D" => image([a[3], 1, 1], a[5], a[6]),
        "glTexImage2D" => image([a[3], a[4], 1], a[6], a[7]),
        "glTexImage3D" | "glTexImage3DEXT" => image([a[3], a[4], a[5]], a[7], a[8]),
        "glTexSubImage1D" | "glTexSubImage1DEXT" => image([a[3], 1, 1], a[4], a[5]),
        "glTexSubImage2D" | "glTexSubImage2DEXT" => image([a[4], a[5], 1], a[6], a[7]),
        "glTexSubImage3D" | "glTexSubImage3DEXT" => image([a[5], a[6], a[7]], a[8], a[9]),
        "glDrawPixels" => image([a[0], a[1], 1], a[2], a[3]),
        "glReadPixels" => image([a[2], a[3], 1], a[4], a[5]),
        "glPixelMapfv" | "glPixelMapuiv" => many(a[1], 4),
        "glPixelMapusv" => many(a[1], 2),
        // A table that nobody has set has one entry.
        "glGetPixelMapfv" | "glGetPixelMapuiv" => Some(4),
        "glGetPixelMapusv" => Some(2),
        "glBufferData" | "glBufferDataARB" => many(a[1], 1),
        "glBufferSubData"
        | "glBufferSubDataARB"
        | "glGetBufferSubData"
        | "glGetBufferSubDataARB" => many(a[2], 1),
        "glDrawElements"
        | "glDrawElementsBaseVertex"
        | "glDrawElementsInstanced"
        | "glDrawElementsInstancedARB"
        | "glDrawElementsInstancedEXT"
        | "glDrawElementsInstancedBaseVertex" => many(a[1], element(a[2])),
        "glDrawRangeElements" | "glDrawRangeElementsEXT" | "glDrawRangeElementsBaseVertex" => {
            many(a[3], element(a[4]))
        }
        "glCompressedTexImage1D" | "glCompressedTexImage1DARB" => many(a[5], 1),
        "glCompressedTexImage2D" | "glCompressedTexImage2DARB" => many(a[6], 1),
        "glCompressedTexImage3D" | "glCompressedTexImage3DARB" => many(a[7], 1),
        "glCompressedTexSubImage1D" | "glCompressedTexSubImage1DARB" => many(a[5], 1),
        "glCompressedTexSubImage2D" | "glCompressedTexSubImage2DARB" => many(a[7], 1),
        "glCompressedTexSubImage3D" | "glCompressedTexSubImage3DARB" => many(a[9], 1),
        _ => None,
    }
}

/// Calls that read or write as many elements as the client says, without a limit: with a huge count it is the client
/// that has to have the memory.
pub(super) const UNLIMITED: &[&str] = &[
    "glAreTexturesResident",
    "glAreTexturesResidentEXT",
    "glBufferData",
    "glBufferDataARB",
    "glCallLists",
    "glDebugMessageControl",
    "glDebugMessageControlARB",
    "glDeleteBuffers",
    "glDrawPixels",
    "glBitmap",
    "glGetActiveUniformsiv",
    "glGetUniformIndices",
    "glPrioritizeTextures",
    "glPrioritizeTexturesEXT",
    "glSelectBuffer",
    "glFeedbackBuffer",
    "glShaderSource",
    "glShaderSourceARB",
    "glMap1f",
    "glMap1d",
    "glMap2f",
    "glMap2d",
    "glReadPixels",
    "glShaderBinary",
    "glProgramStringARB",
];

pub(super) fn is_unlimited(name: &str) -> bool {
    let starts = |beginning| name.starts_with(beginning);
    UNLIMITED.contains(&name)
        || starts("glGen")
        || starts("glCreate") && name.ends_with('s')
        || starts("glDelete")
        || starts("glMultiDraw")
        || starts("glDrawArrays")
        || starts("glDrawElements")
        || starts("glDrawRangeElements")
}

/// Elements of a pointer: as many as its rule says; of untyped memory, bytes.
pub(super) fn elements(
    rule: Option<&Rule>,
    name: &str,
    numbers: &[isize],
    counts: Counts,
) -> usize {
    let honest = match rule {
        None | Some(Rule::None) => data_bytes(name, numbers).unwrap_or(TERMINATED),
        Some(rule) => rule.length(numbers),
    };
    match (counts, rule) {
        (Counts::Honest, _) => honest,
        // The call may look at as many as it has a use for.
        (Counts::Hostile(_), Some(Rule::TimesAtMost { .. })) => honest,
        (Counts::Hostile(_), _) if honest == TERMINATED => honest,
        (Counts::Hostile(_), _) => honest.min(256),
    }
}
