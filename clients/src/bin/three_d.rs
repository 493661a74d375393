//! `three-d` (OpenGL 3.3, core): bodies by instances lit by an environment's maps, two lamps with shadow maps, a
//! transparent body, four samples a pixel, FXAA.
//!
//! `cargo run --release --manifest-path clients/Cargo.toml --bin three_d -- picture.png`

use gl_api::{Api, ContextDesc};
use std::error::Error;
use three_d::*;

/// Width and height in pixels.
const SIZE: [u32; 2] = [320, 240];

/// A board of two colours as a texture.
fn board() -> CpuTexture {
    let texel = |at: usize| match (at % 8 + at / 8) % 2 {
        0 => [235, 225, 200, 255],
        _ => [70, 90, 120, 255],
    };
    CpuTexture {
        data: TextureData::RgbaU8((0..64).map(texel).collect()),
        width: 8,
        height: 8,
        mag_filter: Interpolation::Nearest,
        ..Default::default()
    }
}

/// A sky whose light all bodies reflect: floats, brighter above.
fn sky() -> CpuTexture {
    const SIDE: usize = 32;
    let texel = |at: usize| {
        let up = 1.0 - (at / (2 * SIDE)) as f32 / SIDE as f32;
        let side = (at % (2 * SIDE)) as f32 / (2 * SIDE) as f32;
        [0.2 + 0.8 * up * up, 0.3 + 0.6 * up, 0.4 + up + side * (1.0 - side)]
    };
    CpuTexture {
        data: TextureData::RgbF32((0..2 * SIDE * SIDE).map(texel).collect()),
        width: 2 * SIDE as u32,
        height: SIDE as u32,
        ..Default::default()
    }
}

fn material(albedo: Srgba, metallic: f32, roughness: f32) -> CpuMaterial {
    CpuMaterial { albedo, metallic, roughness, ..Default::default() }
}

/// Draws the picture: rows of RGBA bytes, the highest first.
fn draw() -> Result<image::RgbaImage, Box<dyn Error>> {
    let [width, height] = SIZE;
    let desc = ContextDesc { api: Api::Core, width, height, ..Default::default() };
    let _current = gl_api::Context::new(desc)?.make_current();
    // SAFETY: the addresses are those of the functions of these names, on the current context.
    let gl = unsafe { context::Context::from_loader_function(detgl::get_proc_address) };
    let context = Context::from_gl_context(std::sync::Arc::new(gl))?;
    let viewport = Viewport::new_at_origo(width, height);
    let (eye, middle) = (vec3(4.0, 3.5, 6.0), vec3(0.0, 0.4, 0.0));
    let camera = Camera::new_perspective(
        viewport,
        eye,
        middle,
        vec3(0.0, 1.0, 0.0),
        degrees(40.0),
        0.1,
        40.0,
    );

    let mut plane = CpuMesh::square();
    plane.transform(Mat4::from_angle_x(degrees(-90.0)) * Mat4::from_scale(3.5))?;
    let mut ground = material(Srgba::WHITE, 0.0, 0.8);
    ground.albedo_texture = Some(board().into());
    let ground =
        Gm::new(Mesh::new(&context, &plane), PhysicalMaterial::new_opaque(&context, &ground));

    let mut ball = CpuMesh::sphere(24);
    ball.transform(Mat4::from_scale(0.35))?;
    let places = (0..9).map(|at| {
        vec3((at % 3) as f32 * 1.2 - 1.2, 0.35 + 0.2 * (at / 3) as f32, (at / 3) as f32 * 1.2 - 1.2)
    });
    let colors = (0..9).map(|at| Srgba::new(60 + 20 * at, 220 - 20 * at, 120, 255));
    let instances = Instances {
        transformations: places.map(Mat4::from_translation).collect(),
        colors: Some(colors.collect()),
        ..Default::default()
    };
    let balls = Gm::new(
        InstancedMesh::new(&context, &instances, &ball),
        PhysicalMaterial::new_opaque(&context, &material(Srgba::WHITE, 0.6, 0.3)),
    );
    let mut glass = Gm::new(
        Mesh::new(&context, &CpuMesh::cube()),
        PhysicalMaterial::new_transparent(
            &context,
            &material(Srgba::new(255, 120, 60, 140), 0.0, 0.2),
        ),
    );
    glass.set_transformation(Mat4::from_translation(vec3(0.6, 1.2, 0.9)) * Mat4::from_scale(0.6));

    let skybox = Skybox::new_from_equirectangular(&context, &sky());
    let ambient = AmbientLight::new_with_environment(&context, 0.7, Srgba::WHITE, skybox.texture());
    let mut sun = DirectionalLight::new(&context, 2.5, Srgba::WHITE, vec3(-1.0, -1.5, -0.4));
    sun.generate_shadow_map(
        1024,
        [&ground.geometry as &dyn Geometry, &balls.geometry, &glass.geometry],
    )?;
    let mut lamp = SpotLight::new(
        &context,
        6.0,
        Srgba::new(255, 90, 90, 255),
        vec3(-2.5, 2.5, 2.0),
        vec3(2.0, -2.0, -1.5),
        degrees(25.0),
        Attenuation::default(),
    );
    lamp.generate_shadow_map(512, [&balls.geometry])?;

    let many = RenderTargetMultisample::<[u8; 4], f32>::new(&context, width, height, 4);
    many.clear(ClearState::color_and_depth(0.1, 0.1, 0.1, 1.0, 1.0));
    let objects: [&dyn Object; 4] = [&skybox, &ground, &balls, &glass];
    many.render(&camera, objects, &[&ambient as &dyn Light, &sun, &lamp]);
    let resolved = many.resolve_color();
    let (filter, wrap) = (Interpolation::Nearest, Wrapping::ClampToEdge);
    let whole =
        Texture2D::new_empty::<[u8; 4]>(&context, width, height, filter, filter, None, wrap, wrap);
    let mut target = whole.as_color_target(None);
    let source = Some(ColorTexture::Single(&resolved));
    target.apply_screen_effect(&FxaaEffect {}, &camera, &[], source, None);
    let texels: Vec<[u8; 4]> = target.read();
    // `three-d` hands the highest row over first.
    Ok(image::RgbaImage::from_raw(width, height, texels.concat()).ok_or("as many as needed")?)
}

fn main() -> Result<(), Box<dyn Error>> {
    detgl_clients::save(&draw()?, "three_d.png")
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_draws_the_same_bits_as_ever() {
        let golden = image::load_from_memory(include_bytes!("../../three_d.png"));
        let picture = super::draw().expect("three-d draws");
        assert!(picture == golden.expect("a picture").into_rgba8());
    }
}
