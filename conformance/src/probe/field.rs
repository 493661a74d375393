//! Fields: one case a pixel. A shader computes the value from three vectors, which it fetches from
//! float textures.

use super::error::ProbeError;
use super::pack;
use super::picture::{FIELD, SIZE};
use super::program::Precision;
use super::session::{Session, Vertex, immediate};
use crate::gl::*;
use gl_api::constants::*;

/// Head of the fragment shader. Defines `a`, `b` and `c` as in the shaders of cells.
const HEAD: &str = "
uniform sampler2D inputs_a, inputs_b, inputs_c;
vec4 a, b, c;
vec4 field_value();
vec4 value() {
    vec2 at = gl_FragCoord.xy / 256.0;
    a = texture2D(inputs_a, at);
    b = texture2D(inputs_b, at);
    c = texture2D(inputs_c, at);
    return field_value();
}
";

/// The texture units of the inputs; the body may use the units below.
const UNITS: [u32; 3] = [5, 6, 7];

impl Session {
    /// The first `components` components of `vec4 value()`, which `body` defines in terms of `a`, `b`
    /// and `c`, for each case.
    ///
    /// # Errors
    /// When a call sets the error flag or the shader is rejected.
    pub fn field(
        &self,
        body: &str,
        components: usize,
        inputs: &[[[f32; 4]; 3]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let body = body.replace("vec4 value()", "vec4 field_value()");
        let program = self.field_program(HEAD, &body, Precision::Exact { components })?;
        glUseProgram(program.name);
        for (unit, name) in UNITS.iter().zip(["inputs_a", "inputs_b", "inputs_c"]) {
            glUniform1i(glGetUniformLocation(program.name, name), *unit);
        }
        let location = glGetUniformLocation(program.name, "component");
        glViewport(0, 0, FIELD, FIELD);
        let mut values = Vec::with_capacity(inputs.len());
        for chunk in inputs.chunks(FIELD * FIELD) {
            self.upload_inputs(chunk)?;
            let mut picture = vec![[0.0; 4]; FIELD * FIELD];
            for component in 0..components {
                let mut select = [0.0f32; 4];
                select[component] = 1.0;
                glUniform4f(location, select[0], select[1], select[2], select[3]);
                immediate(GL_QUADS, &whole());
                for (value, pixel) in picture.iter_mut().zip(self.read_square(FIELD)?) {
                    value[component] = pack::unpack(pixel);
                }
            }
            values.extend(picture.into_iter().take(chunk.len()));
        }
        glActiveTexture(GL_TEXTURE0);
        glViewport(0, 0, SIZE, SIZE);
        self.check("drawing a field")?;
        Ok(values)
    }

    /// The three vectors of each case as float textures.
    fn upload_inputs(&self, cases: &[[[f32; 4]; 3]]) -> Result<(), ProbeError> {
        for (index, unit) in UNITS.iter().enumerate() {
            let mut texels: Vec<f32> = cases.iter().flat_map(|case| case[index]).collect();
            texels.resize(FIELD * FIELD * 4, 0.0);
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, 100 + unit);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, FIELD, FIELD, 0, GL_RGBA, GL_FLOAT, &texels);
        }
        self.check("specifying the inputs of a field")
    }
}

/// A square over the whole picture.
fn whole() -> [Vertex; 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .map(|[x, y]| Vertex { position: [x, y, 0.0, 1.0], inputs: [[0.0; 4]; 3] })
}
