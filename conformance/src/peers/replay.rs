//! Draws a frame description with a driver.

use super::client::{ClientError, Gl, MeshName};
use super::frame::{
    Draw, FrameDescription, Lighting, Output, Program, Shading, Step, Texels, Texture, VERTEX,
};
use crate::oracle::lod::{Filter, Mipmap};
use crate::oracle::texture::Level;
use gl_api::constants::*;

/// A frame description whose GL objects exist.
#[derive(Debug)]
pub struct Replayer<'a> {
    gl: &'a Gl,
    steps: Vec<Ready<'a>>,
    side: usize,
    picture: Vec<u8>,
}

/// A step whose GL objects exist.
#[derive(Debug)]
enum Ready<'a> {
    Clear([f32; 4]),
    Draw(&'a Draw, MeshName, u32),
    ShadowMap(&'a Draw, MeshName, u32),
    Upload(&'a Level),
    GenerateMipmaps,
    ReadBack,
}

impl<'a> Replayer<'a> {
    /// Creates the GL objects.
    ///
    /// # Errors
    /// When a shader is refused, or a call sets the error flag.
    pub fn new(
        gl: &'a Gl,
        recipe: &'a FrameDescription,
        side: usize,
        picture: Vec<u8>,
    ) -> Result<Self, ClientError> {
        let mut names = Vec::new();
        for (unit, texture) in (GL_TEXTURE0..).zip(&recipe.textures) {
            let name = gl.gen_texture();
            gl.active_texture(unit);
            let target = target(texture);
            gl.bind_texture(target, name);
            define(gl, texture, target, side);
            names.push(name);
        }
        gl.active_texture(GL_TEXTURE0);
        let steps: Result<_, ClientError> =
            recipe.steps.iter().map(|step| Ready::new(gl, step, &names)).collect();
        gl.viewport(0, 0, side as i32, side as i32);
        gl.check("making the objects of a scene")?;
        Ok(Self { gl, steps: steps?, side, picture })
    }

    /// Draws a frame and waits until it is done.
    pub fn frame(&mut self) {
        for step in &self.steps {
            match step {
                Ready::Clear([red, green, blue, alpha]) => {
                    self.gl.clear_color(*red, *green, *blue, *alpha);
                    self.gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                }
                Ready::Draw(draw, mesh, program) => play(self.gl, draw, *mesh, *program),
                Ready::ShadowMap(draw, mesh, framebuffer) => {
                    self.gl.bind_framebuffer(GL_FRAMEBUFFER_EXT, *framebuffer);
                    self.gl.clear(GL_DEPTH_BUFFER_BIT);
                    play(self.gl, draw, *mesh, 0);
                    self.gl.bind_framebuffer(GL_FRAMEBUFFER_EXT, 0);
                }
                Ready::Upload(level) => self.gl.tex_sub_image(level),
                Ready::GenerateMipmaps => self.gl.generate_mipmap(GL_TEXTURE_2D),
                Ready::ReadBack => self.gl.read_pixels(self.side, &mut self.picture),
            }
        }
        self.gl.finish();
    }

    /// The picture of the last frame: RGBA bytes, rows from the lowest.
    ///
    /// # Errors
    /// When a call has set the error flag since the objects were made.
    pub fn picture(mut self) -> Result<Vec<u8>, ClientError> {
        self.read();
        self.gl.check("drawing and reading")?;
        Ok(self.picture)
    }

    /// Reads the picture.
    pub fn read(&mut self) {
        self.gl.read_pixels(self.side, &mut self.picture);
    }
}

impl<'a> Ready<'a> {
    fn new(gl: &Gl, step: &'a Step, textures: &[u32]) -> Result<Self, ClientError> {
        Ok(match step {
            Step::Clear(color) => Self::Clear(*color),
            Step::Draw(draw) => {
                let program = match draw.shading {
                    Shading::Modulate(_) | Shading::CubeMapped | Shading::Lit(_) => 0,
                    Shading::Program(program) => compile(gl, program)?,
                };
                Self::Draw(draw, gl.mesh(&draw.mesh), program)
            }
            Step::ShadowMap(draw) => {
                let framebuffer = shadow_framebuffer(gl, textures.first().copied());
                Self::ShadowMap(draw, gl.mesh(&draw.mesh), framebuffer)
            }
            Step::Upload(level) => Self::Upload(level),
            Step::GenerateMipmaps => Self::GenerateMipmaps,
            Step::ReadBack => Self::ReadBack,
        })
    }
}

/// What a texture is bound to.
fn target(texture: &Texture) -> u32 {
    match &texture.texels {
        Texels::Given(_) | Texels::ShadowMap => GL_TEXTURE_2D,
        Texels::Cube(_) => GL_TEXTURE_CUBE_MAP,
    }
}

/// Specifies texels and parameters of the texture that is bound to the target.
fn define(gl: &Gl, texture: &Texture, target: u32, side: usize) {
    let min = match (texture.filters.min, texture.filters.mipmap) {
        (Filter::Nearest, Mipmap::None) => GL_NEAREST,
        (Filter::Linear, Mipmap::None) => GL_LINEAR,
        (Filter::Nearest, Mipmap::Nearest) => GL_NEAREST_MIPMAP_NEAREST,
        (Filter::Linear, Mipmap::Nearest) => GL_LINEAR_MIPMAP_NEAREST,
        (Filter::Nearest, Mipmap::Linear) => GL_NEAREST_MIPMAP_LINEAR,
        (Filter::Linear, Mipmap::Linear) => GL_LINEAR_MIPMAP_LINEAR,
    };
    let mag = match texture.filters.mag {
        Filter::Nearest => GL_NEAREST,
        Filter::Linear => GL_LINEAR,
    };
    let set = |name, value| gl.tex_parameter_i(target, name, value as i32);
    set(GL_TEXTURE_MIN_FILTER, min);
    set(GL_TEXTURE_MAG_FILTER, mag);
    if texture.anisotropy > 1.0 {
        let limit = texture.anisotropy as f32;
        gl.tex_parameter_f(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, limit);
    }
    match &texture.texels {
        Texels::Given(levels) => {
            for (number, level) in levels.iter().enumerate() {
                gl.tex_image(target, number, level);
            }
        }
        Texels::Cube(faces) => {
            gl.enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
            set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
            set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
            for (face, levels) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(faces) {
                for (number, level) in levels.iter().enumerate() {
                    gl.tex_image(face, number, level);
                }
            }
        }
        Texels::ShadowMap => {
            set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
            set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
            gl.depth_image(side);
        }
    }
}

/// A framebuffer whose depth is a texture.
fn shadow_framebuffer(gl: &Gl, texture: Option<u32>) -> u32 {
    let framebuffer = gl.gen_framebuffer();
    gl.bind_framebuffer(GL_FRAMEBUFFER_EXT, framebuffer);
    let (target, texture) = (GL_FRAMEBUFFER_EXT, texture.unwrap_or(0));
    gl.framebuffer_texture(target, GL_DEPTH_ATTACHMENT_EXT, GL_TEXTURE_2D, texture, 0);
    gl.draw_buffer(GL_NONE);
    gl.read_buffer(GL_NONE);
    gl.bind_framebuffer(GL_FRAMEBUFFER_EXT, 0);
    framebuffer
}

fn compile(gl: &Gl, program: &Program) -> Result<u32, ClientError> {
    let name = gl.program(VERTEX, program.fragment)?;
    gl.use_program(name);
    gl.sampler(name, c"unit0", 0);
    gl.sampler(name, c"unit1", 1);
    gl.use_program(0);
    Ok(name)
}

fn play(gl: &Gl, draw: &Draw, mesh: MeshName, program: u32) {
    for (mode, matrix) in [
        (GL_TEXTURE, &draw.texture_matrix),
        (GL_PROJECTION, &draw.projection),
        (GL_MODELVIEW, &draw.model_view),
    ] {
        gl.matrix_mode(mode);
        gl.load_matrix(matrix);
    }
    let switch = |on: bool, what| if on { gl.enable(what) } else { gl.disable(what) };
    switch(draw.output == Output::Blend, GL_BLEND);
    gl.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    switch(draw.output == Output::DepthTest, GL_DEPTH_TEST);
    gl.use_program(program);
    let units = match draw.shading {
        Shading::Modulate(units) => units as u32,
        Shading::CubeMapped | Shading::Lit(_) | Shading::Program(_) => 0,
    };
    for unit in 0..2 {
        gl.active_texture(GL_TEXTURE0 + unit);
        switch(unit < units, GL_TEXTURE_2D);
    }
    gl.active_texture(GL_TEXTURE0);
    let is_cube = matches!(draw.shading, Shading::CubeMapped);
    switch(is_cube, GL_TEXTURE_CUBE_MAP);
    for (axis, (coordinate, generator)) in
        [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T), (GL_R, GL_TEXTURE_GEN_R)]
            .into_iter()
            .enumerate()
    {
        switch(is_cube, generator);
        gl.tex_gen_i(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR as i32);
        let mut plane = [0.0; 4];
        plane[axis] = 1.0;
        gl.object_plane(coordinate, plane);
    }
    let lit = matches!(draw.shading, Shading::Lit(_));
    switch(lit, GL_LIGHTING);
    switch(lit, GL_FOG);
    if let Shading::Lit(lighting) = draw.shading {
        light(gl, lighting, draw);
    }
    gl.draw(mesh);
}

/// Sets lights, which are given in eye coordinates, material and fog.
fn light(gl: &Gl, lighting: &Lighting, draw: &Draw) {
    let single = |v: [f64; 4]| v.map(|c| c as f32);
    gl.load_matrix(&super::frame::IDENTITY);
    for (light, name) in lighting.lights.iter().zip(GL_LIGHT0..) {
        gl.enable(name);
        gl.light(name, GL_AMBIENT, single(light.ambient));
        gl.light(name, GL_DIFFUSE, single(light.diffuse));
        gl.light(name, GL_SPECULAR, single(light.specular));
        gl.light(name, GL_POSITION, single(light.position));
    }
    gl.load_matrix(&draw.model_view);
    gl.enable(GL_NORMALIZE);
    let of = &lighting.surface;
    gl.light_model(GL_LIGHT_MODEL_AMBIENT, single(of.scene_ambient));
    gl.material(GL_AMBIENT, single(of.ambient));
    gl.material(GL_DIFFUSE, single(of.diffuse));
    gl.material(GL_SPECULAR, single(of.specular));
    gl.material(GL_SHININESS, [of.shininess as f32; 4]);
    gl.fog_i(GL_FOG_MODE, GL_EXP2 as i32);
    gl.fog_f(GL_FOG_DENSITY, lighting.density as f32);
    gl.fog_color(single(lighting.fog));
}
