//! Which calls are compiled into lists: GL 2.1, section 5.4, and the extensions' additions to it.
//!
//! Calls that answer something never are, whatever is said here.

use crate::constants::*;
use crate::types::GLenum;

/// What happens to a call while a list is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// It is recorded.
    Compiled,
    /// It is carried out at once, or records itself.
    Immediate,
}

/// The calls that are not recorded by the table of entry points, sorted.
const IMMEDIATE: &[&str] = &[
    "glArrayElement",
    "glArrayElementEXT",
    "glAttachObjectARB",
    "glAttachShader",
    "glBegin",
    "glBindAttribLocation",
    "glBindAttribLocationARB",
    "glBindBuffer",
    "glBindBufferARB",
    "glBindFragDataLocation",
    "glBindFragDataLocationEXT",
    "glBindFramebuffer",
    "glBindFramebufferEXT",
    "glBindRenderbuffer",
    "glBindRenderbufferEXT",
    "glBindSampler",
    "glBindVertexArray",
    "glBufferData",
    "glBufferDataARB",
    "glBufferSubData",
    "glBufferSubDataARB",
    "glClientActiveTexture",
    "glClientActiveTextureARB",
    "glColorPointer",
    "glColorPointerEXT",
    "glCompileShader",
    "glCompileShaderARB",
    "glCopyBufferSubData",
    "glDebugMessageCallback",
    "glDebugMessageCallbackARB",
    "glDebugMessageControl",
    "glDebugMessageControlARB",
    "glDebugMessageInsert",
    "glDebugMessageInsertARB",
    "glDeleteBuffers",
    "glDeleteBuffersARB",
    "glDeleteFramebuffers",
    "glDeleteFramebuffersEXT",
    "glDeleteLists",
    "glDeleteObjectARB",
    "glDeleteProgram",
    "glDeleteQueries",
    "glDeleteQueriesARB",
    "glDeleteRenderbuffers",
    "glDeleteRenderbuffersEXT",
    "glDeleteSamplers",
    "glDeleteShader",
    "glDeleteSync",
    "glDeleteTextures",
    "glDeleteTexturesEXT",
    "glDeleteVertexArrays",
    "glDetachObjectARB",
    "glDetachShader",
    "glDisableClientState",
    "glDisableVertexAttribArray",
    "glDisableVertexAttribArrayARB",
    "glDrawArrays",
    "glDrawArraysEXT",
    "glDrawArraysInstanced",
    "glDrawArraysInstancedARB",
    "glDrawArraysInstancedEXT",
    "glDrawElements",
    "glDrawElementsBaseVertex",
    "glDrawElementsInstanced",
    "glDrawElementsInstancedARB",
    "glDrawElementsInstancedBaseVertex",
    "glDrawElementsInstancedEXT",
    "glDrawRangeElements",
    "glDrawRangeElementsBaseVertex",
    "glDrawRangeElementsEXT",
    "glEdgeFlagPointer",
    "glEnableClientState",
    "glEnableVertexAttribArray",
    "glEnableVertexAttribArrayARB",
    "glEnd",
    "glEndList",
    "glFinish",
    "glFlush",
    "glFlushMappedBufferRange",
    "glFogCoordPointer",
    "glFogCoordPointerEXT",
    "glFramebufferRenderbuffer",
    "glFramebufferRenderbufferEXT",
    "glFramebufferTexture",
    "glFramebufferTexture1D",
    "glFramebufferTexture1DEXT",
    "glFramebufferTexture2D",
    "glFramebufferTexture2DEXT",
    "glFramebufferTexture3D",
    "glFramebufferTexture3DEXT",
    "glFramebufferTextureLayer",
    "glFramebufferTextureLayerEXT",
    "glGenerateMipmap",
    "glGenerateMipmapEXT",
    "glInterleavedArrays",
    "glLinkProgram",
    "glLinkProgramARB",
    "glMultiDrawArrays",
    "glMultiDrawArraysEXT",
    "glMultiDrawElements",
    "glMultiDrawElementsBaseVertex",
    "glMultiDrawElementsEXT",
    "glNewList",
    "glNormalPointer",
    "glObjectLabel",
    "glObjectPtrLabel",
    "glPixelStoref",
    "glPixelStorei",
    "glPopClientAttrib",
    "glPopDebugGroup",
    "glPrimitiveRestartIndex",
    "glPrimitiveRestartIndexNV",
    "glPushClientAttrib",
    "glPushDebugGroup",
    "glRenderbufferStorage",
    "glRenderbufferStorageEXT",
    "glRenderbufferStorageMultisample",
    "glRenderbufferStorageMultisampleEXT",
    "glSamplerParameterIiv",
    "glSamplerParameterIuiv",
    "glSamplerParameterf",
    "glSamplerParameterfv",
    "glSamplerParameteri",
    "glSamplerParameteriv",
    "glSecondaryColorPointer",
    "glSecondaryColorPointerEXT",
    "glShaderSource",
    "glShaderSourceARB",
    "glTexCoordPointer",
    "glTexCoordPointerEXT",
    "glTexStorage1D",
    "glTexStorage2D",
    "glTexStorage3D",
    "glValidateProgram",
    "glValidateProgramARB",
    "glVertexAttribDivisor",
    "glVertexAttribDivisorARB",
    "glVertexAttribIPointer",
    "glVertexAttribIPointerEXT",
    "glVertexAttribPointer",
    "glVertexAttribPointerARB",
    "glVertexPointer",
    "glVertexPointerEXT",
    "glWaitSync",
];

/// What happens to the call of that name.
pub(super) fn of(name: &str) -> Class {
    match IMMEDIATE.binary_search(&name) {
        Ok(_) => Class::Immediate,
        Err(_) => Class::Compiled,
    }
}

/// Whether a target is a proxy.
pub(super) fn is_proxy(target: i64) -> bool {
    const PROXIES: [GLenum; 7] = [
        GL_PROXY_TEXTURE_1D,
        GL_PROXY_TEXTURE_2D,
        GL_PROXY_TEXTURE_3D,
        GL_PROXY_TEXTURE_RECTANGLE,
        GL_PROXY_TEXTURE_CUBE_MAP,
        GL_PROXY_TEXTURE_1D_ARRAY,
        GL_PROXY_TEXTURE_2D_ARRAY,
    ];
    PROXIES.iter().any(|&proxy| i64::from(proxy) == target)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_names_are_sorted_and_exist() {
        assert!(IMMEDIATE.is_sorted());
        for name in IMMEDIATE {
            assert!(COMMANDS.iter().any(|(known, _)| known == name), "{name}");
        }
    }
}
