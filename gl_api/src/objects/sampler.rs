//! Sampler state, which textures and sampler objects have: GL 2.1, table 3.18;
//! `ARB_sampler_objects`, `EXT_texture_filter_anisotropic`, `EXT_texture_mirror_clamp`,
//! `EXT_texture_sRGB_decode`.

use crate::base::compare::COMPARE;
use crate::base::constants::*;
use crate::base::convert::{lod_bias, signed_to_unit, symbol, unit_to_signed};
use crate::base::error::{Result, Table, invalid_enum, invalid_value};
use crate::base::types::*;
use crate::objects::target::TextureTarget;
use texunit::sampler::{
    Border, Compare, Filter, MAX_ANISOTROPY, Mipmap, Sampler, Seamless, SrgbRead, Wrap,
};

pub(crate) const WRAP: Table<Wrap> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[
        (GL_REPEAT, Wrap::Repeat),
        (GL_CLAMP, Wrap::Clamp),
        (GL_CLAMP_TO_EDGE, Wrap::ClampToEdge),
        (GL_CLAMP_TO_BORDER, Wrap::ClampToBorder),
        (GL_MIRRORED_REPEAT, Wrap::MirroredRepeat),
        (GL_MIRROR_CLAMP_EXT, Wrap::MirrorClamp),
        (GL_MIRROR_CLAMP_TO_EDGE, Wrap::MirrorClampToEdge),
        (GL_MIRROR_CLAMP_TO_BORDER_EXT, Wrap::MirrorClampToBorder),
    ],
};

const RECTANGLE_WRAP: Table<Wrap> = Table {
    section: "ARB_texture_rectangle, section 3.8.4",
    rows: &[
        (GL_CLAMP, Wrap::Clamp),
        (GL_CLAMP_TO_EDGE, Wrap::ClampToEdge),
        (GL_CLAMP_TO_BORDER, Wrap::ClampToBorder),
    ],
};

const MIN_FILTER: Table<(Filter, Mipmap)> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[
        (GL_NEAREST, (Filter::Nearest, Mipmap::None)),
        (GL_LINEAR, (Filter::Linear, Mipmap::None)),
        (GL_NEAREST_MIPMAP_NEAREST, (Filter::Nearest, Mipmap::Nearest)),
        (GL_LINEAR_MIPMAP_NEAREST, (Filter::Linear, Mipmap::Nearest)),
        (GL_NEAREST_MIPMAP_LINEAR, (Filter::Nearest, Mipmap::Linear)),
        (GL_LINEAR_MIPMAP_LINEAR, (Filter::Linear, Mipmap::Linear)),
    ],
};

const RECTANGLE_MIN_FILTER: Table<(Filter, Mipmap)> = Table {
    section: "ARB_texture_rectangle, section 3.8.4",
    rows: &[
        (GL_NEAREST, (Filter::Nearest, Mipmap::None)),
        (GL_LINEAR, (Filter::Linear, Mipmap::None)),
    ],
};

/// Of external images, which have one level and do not repeat.
const EXTERNAL_WRAP: Table<Wrap> = Table {
    section: "OES_EGL_image_external, section 3.7.4",
    rows: &[(GL_CLAMP_TO_EDGE, Wrap::ClampToEdge)],
};

const EXTERNAL_MIN_FILTER: Table<(Filter, Mipmap)> =
    Table { section: EXTERNAL_WRAP.section, rows: RECTANGLE_MIN_FILTER.rows };

const MAG_FILTER: Table<Filter> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[(GL_NEAREST, Filter::Nearest), (GL_LINEAR, Filter::Linear)],
};

const COMPARE_MODE: Table<bool> = Table {
    section: "GL 2.1, table 3.18",
    rows: &[(GL_NONE, false), (GL_COMPARE_R_TO_TEXTURE, true)],
};

const SRGB_DECODE: Table<SrgbRead> = Table {
    section: "EXT_texture_sRGB_decode",
    rows: &[(GL_DECODE_EXT, SrgbRead::Decode), (GL_SKIP_DECODE_EXT, SrgbRead::AsIs)],
};

/// A parameter with one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SamplerParameter {
    /// Of s, t or r.
    Wrap(u8),
    MinFilter,
    MagFilter,
    MinLod,
    MaxLod,
    LodBias,
    CompareMode,
    CompareFunc,
    MaxAnisotropy,
    SrgbDecode,
    /// Of one texture, where the capability is off (`ARB_seamless_cubemap_per_texture`).
    CubeMapSeamless,
}

pub(crate) const SAMPLER_PARAMETER: Table<SamplerParameter> = Table {
    section: "GL 2.1, table 3.18; ARB_sampler_objects",
    rows: &[
        (GL_TEXTURE_WRAP_S, SamplerParameter::Wrap(0)),
        (GL_TEXTURE_WRAP_T, SamplerParameter::Wrap(1)),
        (GL_TEXTURE_WRAP_R, SamplerParameter::Wrap(2)),
        (GL_TEXTURE_MIN_FILTER, SamplerParameter::MinFilter),
        (GL_TEXTURE_MAG_FILTER, SamplerParameter::MagFilter),
        (GL_TEXTURE_MIN_LOD, SamplerParameter::MinLod),
        (GL_TEXTURE_MAX_LOD, SamplerParameter::MaxLod),
        (GL_TEXTURE_LOD_BIAS, SamplerParameter::LodBias),
        (GL_TEXTURE_COMPARE_MODE, SamplerParameter::CompareMode),
        (GL_TEXTURE_COMPARE_FUNC, SamplerParameter::CompareFunc),
        (GL_TEXTURE_MAX_ANISOTROPY_EXT, SamplerParameter::MaxAnisotropy),
        (GL_TEXTURE_SRGB_DECODE_EXT, SamplerParameter::SrgbDecode),
        (GL_TEXTURE_CUBE_MAP_SEAMLESS, SamplerParameter::CubeMapSeamless),
    ],
};

impl SamplerParameter {
    /// Its value as an enum, if it is one.
    pub fn symbol(self, value: f64) -> Option<GLenum> {
        match self {
            Self::Wrap(_)
            | Self::MinFilter
            | Self::MagFilter
            | Self::CompareMode
            | Self::CompareFunc
            | Self::SrgbDecode => Some(symbol(value as f32)),
            Self::MinLod
            | Self::MaxLod
            | Self::LodBias
            | Self::MaxAnisotropy
            | Self::CubeMapSeamless => None,
        }
    }
}

/// The sampler state of a texture or sampler object.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SamplerState {
    pub sampler: Sampler,
    /// `GL_TEXTURE_COMPARE_FUNC`, whether comparing is on or not.
    pub compare_func: CompareFunc,
}

/// A comparison, at first `GL_LEQUAL`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CompareFunc(pub Compare);

impl Default for CompareFunc {
    fn default() -> Self {
        Self(Compare::LessEqual)
    }
}

impl SamplerState {
    /// Sets a parameter; `target` is a texture's, none a sampler object's.
    pub fn set(
        &mut self,
        target: Option<TextureTarget>,
        parameter: SamplerParameter,
        value: f64,
    ) -> Result<()> {
        let sampler = &mut self.sampler;
        let value = value as f32;
        let symbol = symbol(value);
        let (wrap, min_filter) = match target {
            Some(TextureTarget::Rect) => (&RECTANGLE_WRAP, &RECTANGLE_MIN_FILTER),
            Some(TextureTarget::External) => (&EXTERNAL_WRAP, &EXTERNAL_MIN_FILTER),
            Some(
                TextureTarget::D1
                | TextureTarget::D2
                | TextureTarget::D3
                | TextureTarget::Cube
                | TextureTarget::D1Array
                | TextureTarget::D2Array
                | TextureTarget::CubeArray
                | TextureTarget::D2Multisample
                | TextureTarget::D2MultisampleArray
                | TextureTarget::Buffer,
            )
            | None => (&WRAP, &MIN_FILTER),
        };
        match parameter {
            SamplerParameter::Wrap(axis) => {
                sampler.wrap[usize::from(axis)] = wrap.decode("param", symbol)?;
            }
            SamplerParameter::MinFilter => {
                (sampler.min, sampler.mipmap) = min_filter.decode("param", symbol)?;
            }
            SamplerParameter::MagFilter => sampler.mag = MAG_FILTER.decode("param", symbol)?,
            SamplerParameter::MinLod => sampler.min_lod = value,
            SamplerParameter::MaxLod => sampler.max_lod = value,
            SamplerParameter::LodBias => sampler.lod_bias = lod_bias(value),
            SamplerParameter::CompareMode => {
                let is_on = COMPARE_MODE.decode("param", symbol)?;
                sampler.compare = is_on.then_some(self.compare_func.0);
            }
            SamplerParameter::CompareFunc => {
                let func = COMPARE.decode("param", symbol)?;
                self.compare_func = CompareFunc(func);
                sampler.compare = sampler.compare.map(|_| func);
            }
            SamplerParameter::SrgbDecode => sampler.srgb = SRGB_DECODE.decode("param", symbol)?,
            SamplerParameter::CubeMapSeamless if value == 0.0 => sampler.seamless = Seamless::Off,
            SamplerParameter::CubeMapSeamless if value == 1.0 => sampler.seamless = Seamless::On,
            SamplerParameter::CubeMapSeamless => {
                return invalid_value(
                    "ARB_seamless_cubemap_per_texture",
                    format!("GL_TEXTURE_CUBE_MAP_SEAMLESS = {value} must be GL_FALSE or GL_TRUE"),
                );
            }
            SamplerParameter::MaxAnisotropy if value >= 1.0 => {
                sampler.max_anisotropy = value.min(MAX_ANISOTROPY);
            }
            SamplerParameter::MaxAnisotropy => {
                return invalid_value(
                    "EXT_texture_filter_anisotropic, section 3.8.4",
                    format!("GL_TEXTURE_MAX_ANISOTROPY_EXT = {value} must be at least 1"),
                );
            }
        }
        Ok(())
    }

    /// A parameter as a number.
    pub fn get(&self, parameter: SamplerParameter) -> f32 {
        let sampler = &self.sampler;
        let symbol = |value: GLenum| value as f32;
        match parameter {
            SamplerParameter::Wrap(axis) => symbol(WRAP.encode(sampler.wrap[usize::from(axis)])),
            SamplerParameter::MinFilter => symbol(MIN_FILTER.encode((sampler.min, sampler.mipmap))),
            SamplerParameter::MagFilter => symbol(MAG_FILTER.encode(sampler.mag)),
            SamplerParameter::MinLod => sampler.min_lod,
            SamplerParameter::MaxLod => sampler.max_lod,
            SamplerParameter::LodBias => sampler.lod_bias,
            SamplerParameter::CompareMode => symbol(COMPARE_MODE.encode(sampler.compare.is_some())),
            SamplerParameter::CompareFunc => symbol(COMPARE.encode(self.compare_func.0)),
            SamplerParameter::MaxAnisotropy => sampler.max_anisotropy,
            SamplerParameter::SrgbDecode => symbol(SRGB_DECODE.encode(sampler.srgb)),
            SamplerParameter::CubeMapSeamless => match sampler.seamless {
                Seamless::Off => 0.0,
                Seamless::On => 1.0,
            },
        }
    }
}

/// The values of a call, by its type.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    /// As they are; zeros behind the last.
    plain: [f64; 4],
    /// How many there are, at most four.
    count: usize,
    /// The first as a fraction: integers are scaled, as those of colours are.
    fraction: f32,
    /// As a colour, if there are four: `glTexParameteriv` scales the whole `i32` range to [-1, 1].
    color: Option<Border>,
}

impl Values {
    pub fn floats(values: &[GLfloat]) -> Self {
        Self {
            plain: std::array::from_fn(|at| values.get(at).copied().unwrap_or_default().into()),
            count: values.len().min(4),
            fraction: values.first().copied().unwrap_or_default(),
            color: values.first_chunk().copied().map(Border::Float),
        }
    }

    pub fn fixed(values: &[GLint]) -> Self {
        let color = values.first_chunk::<4>();
        let color = color.map(|color| Border::Float(color.map(signed_to_unit)));
        Self { color, ..Self::signed(values) }
    }

    /// Of the `I` calls: a colour is what it is.
    pub fn signed(values: &[GLint]) -> Self {
        Self {
            plain: std::array::from_fn(|at| values.get(at).copied().unwrap_or_default().into()),
            count: values.len().min(4),
            fraction: signed_to_unit(values.first().copied().unwrap_or_default()),
            color: values.first_chunk().copied().map(Border::Sint),
        }
    }

    pub fn unsigned(values: &[GLuint]) -> Self {
        Self {
            plain: std::array::from_fn(|at| values.get(at).copied().unwrap_or_default().into()),
            count: values.len().min(4),
            fraction: signed_to_unit(values.first().copied().unwrap_or_default().cast_signed()),
            color: values.first_chunk().copied().map(Border::Uint),
        }
    }

    /// The first number.
    pub fn one(&self, section: &'static str, pname: GLenum) -> Result<f64> {
        if self.count == 0 {
            return self.too_few(section, pname, 1);
        }
        Ok(self.plain[0])
    }

    /// The first number as a fraction; of integers by the signed conversion (GL 2.1, section 3.8.4 and table 2.9).
    pub fn fraction(&self, section: &'static str, pname: GLenum) -> Result<f32> {
        self.one(section, pname).map(|_| self.fraction)
    }

    /// The numbers as they are; zeros behind the last.
    pub fn plain(&self) -> [f64; 4] {
        self.plain
    }

    /// All four, as a colour.
    pub fn four(&self, section: &'static str, pname: GLenum) -> Result<Border> {
        match self.color {
            Some(color) => Ok(color),
            None => self.too_few(section, pname, 4),
        }
    }

    #[cold]
    fn too_few<T>(&self, section: &'static str, pname: GLenum, needed: usize) -> Result<T> {
        crate::base::error::invalid_operation(
            section,
            format!("params has {} of {needed} values of {}", self.count, enum_name(pname)),
        )
    }
}

/// The result of a query of a parameter.
#[derive(Clone, Debug)]
pub(crate) enum Answer {
    Numbers(Vec<f64>),
    /// A fraction: as an integer of any kind, 1 is the largest signed one.
    Fraction(f32),
    /// Colours go to integers by rules of their own.
    Color(Border),
}

impl Answer {
    pub fn floats(&self) -> Vec<GLfloat> {
        match self {
            Self::Numbers(numbers) => numbers.iter().map(|&number| number as GLfloat).collect(),
            Self::Fraction(fraction) => vec![*fraction],
            Self::Color(border) => border.floats().to_vec(),
        }
    }

    /// As integers; of a colour, the whole `i32` range stands for [-1, 1] (GL 2.1, section 6.1.2).
    pub fn fixed(&self) -> Vec<GLint> {
        match self {
            Self::Numbers(_) | Self::Fraction(_) => self.signed(),
            Self::Color(border) => border.floats().map(|c| unit_to_signed(c.into())).to_vec(),
        }
    }

    /// As the `I` calls read it: a colour of integers is what it is.
    pub fn signed(&self) -> Vec<GLint> {
        match self {
            Self::Numbers(numbers) => numbers.iter().map(|n| n.round() as GLint).collect(),
            Self::Fraction(fraction) => vec![unit_to_signed((*fraction).into())],
            Self::Color(Border::Uint(color)) => color.map(|c| c as GLint).to_vec(),
            Self::Color(border) => {
                let held = |c: i64| c.clamp(GLint::MIN.into(), GLint::MAX.into()) as GLint;
                border.integers().map(held).to_vec()
            }
        }
    }

    /// As [`Answer::signed`].
    pub fn unsigned(&self) -> Vec<GLuint> {
        match self {
            Self::Numbers(numbers) => numbers.iter().map(|n| n.round() as GLuint).collect(),
            Self::Fraction(_) => self.signed().into_iter().map(GLint::cast_unsigned).collect(),
            Self::Color(Border::Sint(color)) => color.map(|c| c as GLuint).to_vec(),
            Self::Color(border) => {
                border.integers().map(|c| c.clamp(0, GLuint::MAX.into()) as GLuint).to_vec()
            }
        }
    }
}

/// The error for a parameter with several values in a call that has one.
pub(crate) fn needs_vector<T>(section: &'static str, pname: GLenum, call: &str) -> Result<T> {
    invalid_enum(section, format!("pname = {} has four components: use {call}fv", enum_name(pname)))
}
