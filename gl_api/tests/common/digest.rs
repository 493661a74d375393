//! Everything that the queries of a context answer: what a refused call must leave alone.

use super::state_table::{LEAST, STATE, get};
use gl_api::*;
use std::collections::BTreeMap;

/// What a query answered, by the query.
pub type Digest = BTreeMap<String, Vec<f64>>;

/// Names of objects up to this one are asked about.
const NAMES: GLuint = 8;

/// Collects answers.
struct Reader<'a> {
    c: &'a mut Context,
    digest: Digest,
}

impl Reader<'_> {
    /// Keeps an answer; where the query is refused, that it was.
    fn keep(&mut self, key: String, read: impl FnOnce(&mut Context, &mut [f32; 16])) {
        let mut values = [f32::NAN; 16];
        read(self.c, &mut values);
        let answer = match self.c.get_error() {
            GL_NO_ERROR => {
                values.iter().filter(|value| !value.is_nan()).map(|&v| v.into()).collect()
            }
            error => vec![f64::from(error)],
        };
        self.digest.insert(key, answer);
    }

    fn keep_int(&mut self, key: String, read: impl FnOnce(&mut Context, &mut [i32; 16])) {
        self.keep(key, |c, values| {
            let mut ints = [0; 16];
            read(c, &mut ints);
            *values = ints.map(|value| value as f32);
        });
    }

    fn state(&mut self) {
        for (name, ..) in STATE.iter().chain(LEAST) {
            let answer = get(self.c, *name).unwrap_or_default();
            self.digest.insert(enum_name(*name), answer);
        }
        for buffer in 0..8 {
            let answer = get(self.c, GL_DRAW_BUFFER0 + buffer).unwrap_or_default();
            self.digest.insert(format!("draw buffer {buffer}"), answer);
        }
        for name in [
            GL_READ_BUFFER,
            GL_COPY_READ_BUFFER,
            GL_COPY_WRITE_BUFFER,
            GL_TEXTURE_BUFFER_BINDING,
            GL_TEXTURE_BINDING_BUFFER,
            GL_TEXTURE_BUFFER_DATA_STORE_BINDING,
            GL_TEXTURE_BUFFER_FORMAT_ARB,
        ] {
            let answer = get(self.c, name).unwrap_or_default();
            self.digest.insert(enum_name(name), answer);
        }
    }

    fn light(&mut self) {
        const LIGHT: [GLenum; 10] = [
            GL_AMBIENT,
            GL_DIFFUSE,
            GL_SPECULAR,
            GL_POSITION,
            GL_SPOT_DIRECTION,
            GL_SPOT_EXPONENT,
            GL_SPOT_CUTOFF,
            GL_CONSTANT_ATTENUATION,
            GL_LINEAR_ATTENUATION,
            GL_QUADRATIC_ATTENUATION,
        ];
        for light in 0..8 {
            for name in LIGHT {
                self.keep(format!("light {light} {name:#x}"), |c, v| {
                    c.get_lightfv(GL_LIGHT0 + light, name, v);
                });
            }
        }
        let material =
            [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES];
        for face in [GL_FRONT, GL_BACK] {
            for name in material {
                self.keep(format!("material {face:#x} {name:#x}"), |c, v| {
                    c.get_materialfv(face, name, v);
                });
            }
        }
        for plane in 0..8 {
            self.keep(format!("clip plane {plane}"), |c, v| {
                let mut equation = [0.0; 4];
                c.get_clip_plane(GL_CLIP_PLANE0 + plane, &mut equation);
                v[..4].copy_from_slice(&equation.map(|x| x as f32));
            });
        }
    }

    /// The environment of the unit that is active: a query must not change which one is.
    fn unit(&mut self) {
        const ENVIRONMENT: [GLenum; 19] = [
            GL_TEXTURE_ENV_MODE,
            GL_TEXTURE_ENV_COLOR,
            GL_COMBINE_RGB,
            GL_COMBINE_ALPHA,
            GL_SRC0_RGB,
            GL_SRC1_RGB,
            GL_SRC2_RGB,
            GL_SRC0_ALPHA,
            GL_SRC1_ALPHA,
            GL_SRC2_ALPHA,
            GL_OPERAND0_RGB,
            GL_OPERAND1_RGB,
            GL_OPERAND2_RGB,
            GL_OPERAND0_ALPHA,
            GL_OPERAND1_ALPHA,
            GL_OPERAND2_ALPHA,
            GL_RGB_SCALE,
            GL_ALPHA_SCALE,
            GL_TEXTURE_LOD_BIAS,
        ];
        for name in ENVIRONMENT {
            let target = if name == GL_TEXTURE_LOD_BIAS {
                GL_TEXTURE_FILTER_CONTROL
            } else {
                GL_TEXTURE_ENV
            };
            self.keep(format!("environment {name:#x}"), |c, v| c.get_tex_envfv(target, name, v));
        }
        self.keep("point sprites".into(), |c, v| {
            c.get_tex_envfv(GL_POINT_SPRITE, GL_COORD_REPLACE, v);
        });
        for coord in [GL_S, GL_T, GL_R, GL_Q] {
            for name in [GL_TEXTURE_GEN_MODE, GL_EYE_PLANE, GL_OBJECT_PLANE] {
                self.keep(format!("generation {coord:#x} {name:#x}"), |c, v| {
                    c.get_tex_genfv(coord, name, v);
                });
            }
        }
    }

    /// Parameters and levels of the textures that are bound to the active unit.
    fn textures(&mut self) {
        const TARGETS: [(GLenum, GLenum); 10] = [
            (GL_TEXTURE_1D, GL_TEXTURE_1D),
            (GL_TEXTURE_2D, GL_TEXTURE_2D),
            (GL_TEXTURE_3D, GL_TEXTURE_3D),
            (GL_TEXTURE_RECTANGLE, GL_TEXTURE_RECTANGLE),
            (GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X),
            (GL_TEXTURE_1D_ARRAY, GL_TEXTURE_1D_ARRAY),
            (GL_TEXTURE_2D_ARRAY, GL_TEXTURE_2D_ARRAY),
            (GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_CUBE_MAP_ARRAY),
            (GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_2D_MULTISAMPLE),
            (GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_2D_MULTISAMPLE_ARRAY),
        ];
        const LEVEL: [GLenum; 8] = [
            GL_TEXTURE_WIDTH,
            GL_TEXTURE_HEIGHT,
            GL_TEXTURE_DEPTH,
            GL_TEXTURE_INTERNAL_FORMAT,
            GL_TEXTURE_BORDER,
            GL_TEXTURE_COMPRESSED,
            GL_TEXTURE_SAMPLES,
            GL_TEXTURE_FIXED_SAMPLE_LOCATIONS,
        ];
        for (target, image) in TARGETS {
            for name in PARAMETERS {
                self.keep(format!("texture {target:#x} {name:#x}"), |c, v| {
                    c.get_tex_parameterfv(target, *name, v);
                });
            }
            const FLAT: [GLenum; 3] =
                [GL_TEXTURE_RECTANGLE, GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_2D_MULTISAMPLE_ARRAY];
            let levels = if FLAT.contains(&target) { 1 } else { 3 };
            for level in 0..levels {
                for name in LEVEL {
                    self.keep(format!("level {image:#x} {level} {name:#x}"), |c, v| {
                        c.get_tex_level_parameterfv(image, level, name, v);
                    });
                }
            }
        }
        let size = self.digest[&format!("level {GL_TEXTURE_2D:#x} 0 {GL_TEXTURE_WIDTH:#x}")][0];
        let plain = self.digest["GL_PIXEL_PACK_BUFFER_BINDING"] == [0.0]
            && self.digest["GL_PACK_ROW_LENGTH"] == [0.0];
        if plain && (1.0..=4.0).contains(&size) {
            let mut texels = [0_u8; 256];
            let out = DataOut::Bytes(&mut texels);
            self.c.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out);
            self.c.get_error();
            self.digest.insert("texels".into(), texels.map(f64::from).to_vec());
        }
    }

    fn objects(&mut self) {
        for name in 1..=NAMES {
            let c = &mut *self.c;
            let is = [
                c.is_texture(name),
                c.is_buffer(name),
                c.is_framebuffer(name),
                c.is_renderbuffer(name),
                c.is_vertex_array(name),
                c.is_sampler(name),
                c.is_query(name),
                c.is_list(name),
                c.is_shader(name),
                c.is_program(name),
            ];
            let is = is.map(|is| f64::from(u8::from(is))).to_vec();
            self.digest.insert(format!("objects {name}"), is.clone());
            if is[8] == 1.0 {
                self.shader(name);
            }
            if is[9] == 1.0 {
                self.program(name);
            }
            if is[5] == 1.0 {
                for parameter in [GL_TEXTURE_WRAP_S, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_BORDER_COLOR]
                {
                    self.keep(format!("sampler {name} {parameter:#x}"), |c, v| {
                        c.get_sampler_parameterfv(name, parameter, v);
                    });
                }
            }
        }
        for (target, binding) in BUFFERS {
            if get(self.c, *binding) == Some(vec![0.0]) {
                continue;
            }
            for parameter in [GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED] {
                self.keep_int(format!("buffer {target:#x} {parameter:#x}"), |c, v| {
                    c.get_buffer_parameteriv(*target, parameter, v);
                });
            }
        }
        for target in [GL_SAMPLES_PASSED, GL_TIME_ELAPSED, GL_ANY_SAMPLES_PASSED] {
            self.keep_int(format!("query {target:#x}"), |c, v| {
                c.get_queryiv(target, GL_CURRENT_QUERY, v);
            });
        }
    }

    /// A shader's state and source.
    fn shader(&mut self, name: GLuint) {
        for parameter in [GL_SHADER_TYPE, GL_COMPILE_STATUS, GL_DELETE_STATUS, GL_INFO_LOG_LENGTH] {
            self.keep_int(format!("shader {name} {parameter:#x}"), |c, v| {
                c.get_shaderiv(name, parameter, v);
            });
        }
        let mut source = String::new();
        self.c.get_shader_source(name, 4096, &mut [], TextOut::String(&mut source));
        let bytes = source.bytes().map(f64::from).collect();
        self.digest.insert(format!("source {name}"), bytes);
    }

    /// A program's state, and its uniforms.
    fn program(&mut self, name: GLuint) {
        let mut linked = [0];
        self.c.get_programiv(name, GL_LINK_STATUS, &mut linked);
        for parameter in [
            GL_LINK_STATUS,
            GL_DELETE_STATUS,
            GL_VALIDATE_STATUS,
            GL_ATTACHED_SHADERS,
            GL_ACTIVE_UNIFORMS,
            GL_ACTIVE_ATTRIBUTES,
            GL_INFO_LOG_LENGTH,
        ] {
            self.keep_int(format!("program {name} {parameter:#x}"), |c, v| {
                c.get_programiv(name, parameter, v);
            });
        }
        for location in 0..if linked[0] == 1 { 16 } else { 0 } {
            self.keep(format!("uniform {name} {location}"), |c, v| {
                c.get_uniformfv(name, location, v);
            });
        }
    }

    fn vertices(&mut self) {
        for index in 1..16 {
            for parameter in [
                GL_VERTEX_ATTRIB_ARRAY_ENABLED,
                GL_VERTEX_ATTRIB_ARRAY_SIZE,
                GL_VERTEX_ATTRIB_ARRAY_STRIDE,
                GL_VERTEX_ATTRIB_ARRAY_TYPE,
                GL_VERTEX_ATTRIB_ARRAY_NORMALIZED,
                GL_VERTEX_ATTRIB_ARRAY_INTEGER,
                GL_VERTEX_ATTRIB_ARRAY_DIVISOR,
                GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING,
                GL_CURRENT_VERTEX_ATTRIB,
            ] {
                self.keep(format!("attribute {index} {parameter:#x}"), |c, v| {
                    c.get_vertex_attribfv(index, parameter, v);
                });
            }
        }
    }

    fn framebuffers(&mut self) {
        let points = [GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT];
        for (target, binding) in [
            (GL_DRAW_FRAMEBUFFER, "GL_FRAMEBUFFER_BINDING"),
            (GL_READ_FRAMEBUFFER, "GL_READ_FRAMEBUFFER_BINDING"),
        ] {
            if self.digest[binding] == [0.0] {
                continue;
            }
            let status = self.c.check_framebuffer_status(target);
            self.digest.insert(format!("framebuffer {target:#x}"), vec![status.into()]);
            for point in points {
                for parameter in [
                    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
                    GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL,
                ] {
                    self.keep_int(
                        format!("attachment {target:#x} {point:#x} {parameter:#x}"),
                        |c, v| {
                            c.get_framebuffer_attachment_parameteriv(target, point, parameter, v);
                        },
                    );
                }
            }
        }
        if self.digest["GL_RENDERBUFFER_BINDING"] == [0.0] {
            return;
        }
        for parameter in
            [GL_RENDERBUFFER_WIDTH, GL_RENDERBUFFER_INTERNAL_FORMAT, GL_RENDERBUFFER_SAMPLES]
        {
            self.keep_int(format!("renderbuffer {parameter:#x}"), |c, v| {
                c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, parameter, v);
            });
        }
    }

    fn maps(&mut self) {
        for target in (GL_MAP1_COLOR_4..=GL_MAP1_VERTEX_4).chain(GL_MAP2_COLOR_4..=GL_MAP2_VERTEX_4)
        {
            for query in [GL_COEFF, GL_ORDER, GL_DOMAIN] {
                self.keep(format!("map {target:#x} {query:#x}"), |c, v| {
                    c.get_mapfv(target, query, v.as_mut_slice().arg());
                });
            }
        }
    }
}

const BUFFERS: &[(GLenum, GLenum)] = &[
    (GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING),
    (GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING),
    (GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING),
    (GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING),
    (GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER),
    (GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER),
];

const PARAMETERS: &[GLenum] = &[
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    GL_TEXTURE_WRAP_R,
    GL_TEXTURE_MIN_LOD,
    GL_TEXTURE_MAX_LOD,
    GL_TEXTURE_LOD_BIAS,
    GL_TEXTURE_BASE_LEVEL,
    GL_TEXTURE_MAX_LEVEL,
    GL_TEXTURE_COMPARE_MODE,
    GL_TEXTURE_COMPARE_FUNC,
    GL_DEPTH_TEXTURE_MODE,
    GL_TEXTURE_PRIORITY,
    GL_TEXTURE_RESIDENT,
    GL_GENERATE_MIPMAP,
    GL_TEXTURE_BORDER_COLOR,
    GL_TEXTURE_MAX_ANISOTROPY_EXT,
    GL_TEXTURE_SRGB_DECODE_EXT,
    GL_TEXTURE_SWIZZLE_RGBA,
    GL_TEXTURE_IMMUTABLE_FORMAT,
];

/// Asks for everything. The context's flag and messages are as they were before: none.
pub fn digest(c: &mut Context) -> Digest {
    let mut reader = Reader { c, digest: Digest::new() };
    reader.state();
    reader.light();
    reader.unit();
    reader.textures();
    reader.objects();
    reader.vertices();
    reader.framebuffers();
    reader.maps();
    reader.c.messages();
    reader.digest
}

/// The answers that differ.
pub fn differences(before: &Digest, after: &Digest) -> Vec<String> {
    let keys = before.keys().chain(after.keys().filter(|key| !before.contains_key(*key)));
    let differ = keys.filter(|key| before.get(*key) != after.get(*key));
    differ.map(|key| format!("{key}: {:?} became {:?}", before.get(key), after.get(key))).collect()
}
