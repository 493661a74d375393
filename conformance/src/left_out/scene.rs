//! The scenes that features are asked of, in the GL of GL 2.1.

use crate::gl::*;
use gl_api::constants::*;

/// Pixels across and up.
pub(super) const SIDE: usize = 1024;

/// Texels across and up of the scenes' textures: magnified four times where a quad shows one once.
const TEXELS: usize = 256;

/// A picture of `channels` bytes a texel; alpha is not one everywhere.
fn texels(channels: usize) -> Vec<u8> {
    let texel = |at: usize| {
        let (x, y) = (at % TEXELS, at / TEXELS);
        let check = if (x / 16 + y / 16) % 2 == 0 { 200 } else { 60 };
        [check, (x * 255 / TEXELS) as u8, (y * 255 / TEXELS) as u8, 128 + (x / 2 % 128) as u8]
    };
    (0..TEXELS * TEXELS).flat_map(|at| texel(at).into_iter().take(channels)).collect()
}

/// Binds a new texture with one level to the active unit, and enables it.
fn texture(name: u32, internal: u32, format: u32, channels: usize) {
    let (target, image) = (GL_TEXTURE_2D, texels(channels));
    glBindTexture(target, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(target, 0, internal, TEXELS, TEXELS, 0, format, GL_UNSIGNED_BYTE, &image);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glEnable(target);
}

/// Nothing but colours at the vertices.
pub(super) fn gouraud() {}

/// Colours and a depth test.
pub(super) fn gouraud_with_depth() {
    glEnable(GL_DEPTH_TEST);
}

/// A texture with alpha, filtered linearly, times the colour.
pub(super) fn textured() {
    texture(1, GL_RGBA8, GL_RGBA, 4);
}

/// A texture without alpha.
pub(super) fn textured_opaque() {
    texture(1, GL_RGB8, GL_RGB, 3);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

/// [`textured`] with all levels.
pub(super) fn mipmapped() {
    textured();
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

/// One light, colours of material, smooth shading.
pub(super) fn lit() {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, &[0.3f32, 0.4, 1.0, 0.0]);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, &[0.8f32, 0.5, 0.3, 1.0]);
    glMaterialfv(GL_FRONT, GL_SPECULAR, &[0.4f32, 0.4, 0.4, 1.0]);
    glMaterialf(GL_FRONT, GL_SHININESS, 20);
    mesh();
}

/// Uploads the mesh of [`draw_mesh`].
pub(super) fn mesh() {
    const ACROSS: usize = 160;
    let mut vertices: Vec<f32> = Vec::new();
    for at in 0..=ACROSS {
        for to in 0..=ACROSS {
            let [x, y] = [to, at].map(|c| c as f32 / ACROSS as f32 * 1.8 - 0.9);
            // A sphere's cap: exact unit normals.
            let z = (1.7 - x * x - y * y).sqrt();
            let length = (x * x + y * y + z * z).sqrt();
            vertices.extend([x, y, 0.1 * z - 0.2]);
            vertices.extend([x, y, z].map(|c| c / length));
        }
    }
    let mut indices: Vec<u32> = Vec::new();
    for at in 0..ACROSS as u32 {
        for to in 0..ACROSS as u32 {
            let low = at * (ACROSS as u32 + 1) + to;
            let high = low + ACROSS as u32 + 1;
            indices.extend([low, low + 1, high, low + 1, high + 1, high]);
        }
    }
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, size_of_val(&vertices[..]), &vertices, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 2);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, size_of_val(&indices[..]), &indices, GL_STATIC_DRAW);
    glVertexPointer(3, GL_FLOAT, 24, BUFFER_OFFSET(0));
    glNormalPointer(GL_FLOAT, 24, BUFFER_OFFSET(12));
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
}

/// Links a fragment shader with the given body of `main`, in use with the textures 1 and 2 on units 0 and 1; all
/// uniforms but the samplers are zero.
pub(super) fn program(body: &str) {
    glActiveTexture(GL_TEXTURE1);
    texture(2, GL_RGBA8, GL_RGBA, 4);
    glActiveTexture(GL_TEXTURE0);
    textured();
    let source = format!(
        "uniform sampler2D first, second;\nuniform float u;\nuniform float one;\nuniform int count;\n\
         uniform bool flag;\nvarying vec4 color;\nvarying vec2 at;\nvarying vec4 unread;\n\
         void main() {{\n    vec4 texel = texture2D(first, at);\n{body}\n}}\n"
    );
    let vertex = "varying vec4 color;\nvarying vec2 at;\nvarying vec4 unread;\n\
                  void main() {\n    gl_Position = gl_Vertex;\n    color = gl_Color;\n    \
                  at = gl_MultiTexCoord0.xy;\n    unread = gl_Vertex * 3.0;\n}\n";
    let program = glCreateProgram();
    for (stage, text) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, source.as_str())] {
        let shader = glCreateShader(stage);
        glShaderSource(shader, 1, text, NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    let location = |name: &str| glGetUniformLocation(program, name);
    glUniform1i(location("first"), 0);
    if location("second") >= 0 {
        glUniform1i(location("second"), 1);
    }
    if location("one") >= 0 {
        glUniform1f(location("one"), 1.0);
    }
}

/// Corners with texture coordinates from 0 to `times`, at a depth.
fn quad(times: f32, z: f32, alpha: f32) {
    glBegin(GL_QUADS);
    let corners = [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for [x, y] in corners {
        glColor4f(1.0 - 0.5 * x, 1.0 - 0.25 * y, 0.5 + 0.5 * x, alpha);
        glTexCoord2f(times * x, times * y);
        glVertex3f(2.0 * x - 1.0, 2.0 * y - 1.0, z);
    }
    glEnd();
}

/// A clear and a quad over the whole picture that shows a texture once.
pub(super) fn draw_quad() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    quad(1.0, 0.0, 1.0);
}

/// As [`draw_quad`], with the texture 16 times along both axes: four texels a pixel.
pub(super) fn draw_minified() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    quad(16.0, 0.0, 1.0);
}

/// As [`draw_quad`], after a quad behind it.
pub(super) fn draw_over_hidden() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    quad(2.0, 0.5, 1.0);
    quad(1.0, 0.0, 1.0);
}

/// As [`draw_quad`], before a quad behind it that the depth test rejects.
pub(super) fn draw_front_to_back() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    quad(1.0, 0.0, 1.0);
    quad(2.0, 0.5, 1.0);
}

/// As [`draw_quad`], with a clear more.
pub(super) fn draw_cleared_twice() {
    glClear(GL_COLOR_BUFFER_BIT);
    draw_quad();
}

/// As [`draw_quad`], after a quad that writes nothing to any buffer.
pub(super) fn draw_after_masked() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    quad(1.0, 0.0, 1.0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    quad(1.0, 0.0, 1.0);
}

/// A clear and the mesh.
pub(super) fn draw_mesh() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, 160 * 160 * 6, GL_UNSIGNED_INT, BUFFER_OFFSET(0));
}
