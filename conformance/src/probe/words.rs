//! Fields of words: one case a pixel, whose inputs and result are the bits of 32-bit words, so that
//! every float comes and goes as it is. For contexts of OpenGL 3.3 and OpenGL ES 3.0.

use super::error::ProbeError;
use super::picture::FIELD;
use super::session::Session;
use super::stages::Stages;
use crate::gl::*;
use gl_api::constants::*;

/// A triangle over the whole picture, from the numbers of three vertices.
pub(super) const WHOLE: &str = "
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
";

const FRAGMENT: &str = "
uniform highp usampler2D inputs_a, inputs_b;
out uvec4 result;
uvec4 value(uvec4 a, uvec4 b);
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    result = value(texelFetch(inputs_a, at, 0), texelFetch(inputs_b, at, 0));
}
";

/// The texture units of the inputs; the body may use the units below.
const UNITS: [u32; 2] = [6, 7];

impl Session {
    /// `uvec4 value(uvec4 a, uvec4 b)`, which `body` defines, for each case.
    ///
    /// # Errors
    /// When a call sets the error flag or the shader is rejected.
    pub fn words(&self, body: &str, inputs: &[[[u32; 4]; 2]]) -> Result<Vec<[u32; 4]>, ProbeError> {
        let fragment = format!("{FRAGMENT}{body}");
        let program = self.stages(&Stages { vertex: WHOLE, geometry: "", fragment: &fragment })?;
        for (unit, name) in UNITS.iter().zip(["inputs_a", "inputs_b"]) {
            glUniform1i(glGetUniformLocation(program, name), *unit);
        }
        let mut values = Vec::with_capacity(inputs.len());
        for chunk in inputs.chunks(FIELD * FIELD) {
            let size = [FIELD, chunk.len().div_ceil(FIELD)];
            self.frame(GL_RGBA32UI, size, 0)?;
            self.upload_words(chunk, size)?;
            glDrawArrays(GL_TRIANGLES, 0, 3);
            values.extend(self.read_words(size)?.into_iter().take(chunk.len()));
        }
        Ok(values)
    }

    /// As [`Session::words`] of floats, whose result is of floats.
    ///
    /// # Errors
    /// When a call sets the error flag or the shader is rejected.
    pub fn float_words(
        &self,
        body: &str,
        inputs: &[[[f32; 4]; 2]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let body = format!(
            "{}
            uvec4 value(uvec4 a, uvec4 b) {{
                return floatBitsToUint(float_value(uintBitsToFloat(a), uintBitsToFloat(b)));
            }}",
            body.replace("vec4 value(", "vec4 float_value(")
        );
        let inputs: Vec<_> = inputs.iter().map(|case| case.map(|v| v.map(f32::to_bits))).collect();
        let words = self.words(&body, &inputs)?;
        Ok(words.into_iter().map(|word| word.map(|w| f32::from_bits(w).into())).collect())
    }

    /// The texels of the lowest row of the 2D texture at unit 0, [`FIELD`] of them, fetched.
    ///
    /// # Errors
    /// When a call sets the error flag or the shader is rejected.
    pub fn row(&self) -> Result<Vec<[f64; 4]>, ProbeError> {
        let column = |x: usize| f32::from_bits(x as u32);
        let inputs: Vec<_> = (0..FIELD).map(|x| [[column(x), 0.0, 0.0, 0.0], [0.0; 4]]).collect();
        let body = "uniform sampler2D image;
             vec4 value(vec4 a, vec4 b) {
                 return texelFetch(image, ivec2(floatBitsToInt(a.x), 0), 0);
             }";
        self.float_words(body, &inputs)
    }

    /// What a framebuffer of this format holds after fragments copy the lowest row of the 2D texture
    /// at unit 0 to it.
    ///
    /// # Errors
    /// When a call sets the error flag or the shader is rejected.
    pub fn copied_by_fragments(
        &self,
        internal: u32,
        width: usize,
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let fragment = "uniform sampler2D image; out vec4 color;
             void main() { color = texelFetch(image, ivec2(gl_FragCoord.x, 0), 0); }";
        self.stages(&Stages { vertex: WHOLE, geometry: "", fragment })?;
        self.frame(internal, [width, 1], 0)?;
        glDrawArrays(GL_TRIANGLES, 0, 3);
        self.read_floats([width, 1])
    }

    /// As [`Session::copied_by_fragments`], of unsigned integers.
    ///
    /// # Errors
    /// When a call sets the error flag or the shader is rejected.
    pub fn copied_words(&self, internal: u32, width: usize) -> Result<Vec<[f64; 4]>, ProbeError> {
        let fragment = "uniform highp usampler2D image; out uvec4 color;
             void main() { color = texelFetch(image, ivec2(gl_FragCoord.x, 0), 0); }";
        self.stages(&Stages { vertex: WHOLE, geometry: "", fragment })?;
        self.frame(internal, [width, 1], 0)?;
        glDrawArrays(GL_TRIANGLES, 0, 3);
        let words = self.read_words([width, 1])?;
        Ok(words.into_iter().map(|word| word.map(f64::from)).collect())
    }

    fn upload_words(
        &self,
        cases: &[[[u32; 4]; 2]],
        [width, height]: [usize; 2],
    ) -> Result<(), ProbeError> {
        let (internal, format, ty) = (GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
        for (index, unit) in UNITS.iter().enumerate() {
            let mut texels: Vec<u32> = cases.iter().flat_map(|case| case[index]).collect();
            texels.resize(width * height * 4, 0);
            let mut name = 0u32;
            glGenTextures(1, &mut name);
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, name);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, ty, &texels);
        }
        glActiveTexture(GL_TEXTURE0);
        self.check("specifying the inputs of a field of words")
    }
}

#[cfg(test)]
mod tests {
    use crate::probe::{Dialect, ProbeError, Session};

    #[test]
    fn words_come_and_go_as_they_are() -> Result<(), ProbeError> {
        let words: Vec<[[u32; 4]; 2]> = (0..700u32)
            .map(|i| [[i, i.wrapping_mul(0x9e37_79b1), !i, 0x7fc0_0001], [i; 4]])
            .collect();
        for dialect in [Dialect::Compatibility, Dialect::Core, Dialect::Es] {
            let session = Session::open_in(dialect)?;
            let back = session.words("uvec4 value(uvec4 a, uvec4 b) { return a ^ b; }", &words)?;
            let expected: Vec<[u32; 4]> =
                words.iter().map(|[a, b]| [0, 1, 2, 3].map(|i| a[i] ^ b[i])).collect();
            assert_eq!(back, expected, "{dialect:?}");
        }
        Ok(())
    }
}
