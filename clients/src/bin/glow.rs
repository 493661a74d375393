//! `glow` on OpenGL ES 3.0, without glutin: a texture array of three layers, by instances.
//!
//! `cargo run --release --manifest-path clients/Cargo.toml --bin glow -- picture.png`

use egui_glow::glow::{self, HasContext};
use gl_api::{Api, Context, ContextDesc};
use std::error::Error;

/// Width and height in pixels.
const SIZE: [u32; 2] = [192, 64];

const VERTEX: &str = "#version 300 es
out vec3 place;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    place = vec3(corner, gl_InstanceID);
    gl_Position = vec4((corner + vec2(gl_InstanceID, 0.0)) * vec2(2.0 / 3.0, 2.0) - 1.0, 0.0, 1.0);
}";

const FRAGMENT: &str = "#version 300 es
precision highp float;
precision highp sampler2DArray;
uniform sampler2DArray layers;
in vec3 place;
out vec4 color;
void main() { color = texture(layers, place); }";

/// A texel of a layer: a board whose squares are larger in each layer.
fn texel(x: usize, y: usize, layer: usize) -> [u8; 4] {
    let is_light = ((x >> layer) + (y >> layer)).is_multiple_of(2);
    let mut texel = if is_light { [240, 240, 230, 255] } else { [40, 50, 60, 255] };
    texel[layer] = 200;
    texel
}

/// Draws the picture: rows of RGBA bytes, the highest first.
fn draw() -> Result<image::RgbaImage, Box<dyn Error>> {
    const SIDE: usize = 8;
    let [width, height] = SIZE;
    let desc = ContextDesc { api: Api::Es2, width, height, ..Default::default() };
    let _current = Context::new(desc)?.make_current();
    let texels = (0..3).flat_map(|layer| {
        (0..SIDE).flat_map(move |y| (0..SIDE).flat_map(move |x| texel(x, y, layer)))
    });
    let texels: Vec<u8> = texels.collect();
    let mut pixels = vec![0; (width * height * 4) as usize];
    // SAFETY: the addresses are those of the functions of these names, on the current context; `glow` hands slices over
    // by their lengths, and they have the sizes that the calls name.
    unsafe {
        let gl = glow::Context::from_loader_function(detgl::get_proc_address);
        let program = gl.create_program()?;
        for (stage, source) in [(glow::VERTEX_SHADER, VERTEX), (glow::FRAGMENT_SHADER, FRAGMENT)] {
            let shader = gl.create_shader(stage)?;
            gl.shader_source(shader, source);
            gl.compile_shader(shader);
            gl.attach_shader(program, shader);
        }
        gl.link_program(program);
        if !gl.get_program_link_status(program) {
            return Err(gl.get_program_info_log(program).into());
        }
        gl.use_program(Some(program));
        gl.bind_texture(glow::TEXTURE_2D_ARRAY, Some(gl.create_texture()?));
        let (side, data) = (SIDE as i32, glow::PixelUnpackData::Slice(Some(&texels)));
        let (rgba8, ty) = (glow::RGBA8 as i32, glow::UNSIGNED_BYTE);
        gl.tex_image_3d(glow::TEXTURE_2D_ARRAY, 0, rgba8, side, side, 3, 0, glow::RGBA, ty, data);
        for name in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
            gl.tex_parameter_i32(glow::TEXTURE_2D_ARRAY, name, glow::LINEAR as i32);
        }
        gl.viewport(0, 0, width as i32, height as i32);
        gl.draw_arrays_instanced(glow::TRIANGLE_STRIP, 0, 4, 3);
        let out = glow::PixelPackData::Slice(Some(&mut pixels));
        gl.read_pixels(0, 0, width as i32, height as i32, glow::RGBA, glow::UNSIGNED_BYTE, out);
        assert_eq!(gl.get_error(), glow::NO_ERROR, "DETGL_DEBUG=1 says which call");
    }
    detgl_clients::picture([width, height], pixels)
}

fn main() -> Result<(), Box<dyn Error>> {
    detgl_clients::save(&draw()?, "glow.png")
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_draws_the_same_bits_as_ever() {
        let golden = image::load_from_memory(include_bytes!("../../glow.png"));
        let picture = super::draw().expect("glow draws");
        assert!(picture == golden.expect("a picture").into_rgba8());
    }
}
