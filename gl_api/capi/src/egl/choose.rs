//! How configs are chosen (EGL 1.5, section 3.4.1).

use super::config::{CONFIGS, Config};
use super::constants::*;
use super::error::{Code, Result, fail, name_of, say};
use super::raw::{Attrib, Handle, Int, handle, int_attributes, put};
use super::registry::registry;
use std::cmp::Reverse;

/// How an attribute of a request is compared (EGL 1.5, table 3.4).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Criterion {
    AtLeast,
    Exact,
    Mask,
    Ignored,
}

/// The values that a request may ask for, beside `EGL_DONT_CARE`; other ones no config could ever have.
#[derive(Clone, Copy)]
enum Allowed {
    Any,
    /// Any, but not `EGL_DONT_CARE`.
    Level,
    Boolean,
    /// 0 and above.
    Count,
    /// 1 and above.
    Positive,
    OneOf(&'static [Int]),
    Bits(Int),
}

impl Allowed {
    fn has(self, value: Int) -> bool {
        (value == EGL_DONT_CARE && !matches!(self, Self::Level))
            || match self {
                Self::Any => true,
                Self::Level => value != EGL_DONT_CARE,
                Self::Boolean => (0..=1).contains(&value),
                Self::Count => value >= 0,
                Self::Positive => value > 0,
                Self::OneOf(values) => values.contains(&value),
                Self::Bits(bits) => value & !bits == 0,
            }
    }
}

/// The bits of `EGL_RENDERABLE_TYPE`.
const APIS: Int =
    EGL_OPENGL_ES_BIT | EGL_OPENVG_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_ES3_BIT | EGL_OPENGL_BIT;
/// The bits of `EGL_SURFACE_TYPE`.
const SURFACES: Int = EGL_PBUFFER_BIT
    | EGL_PIXMAP_BIT
    | EGL_WINDOW_BIT
    | EGL_VG_COLORSPACE_LINEAR_BIT
    | EGL_VG_ALPHA_FORMAT_PRE_BIT
    | EGL_MULTISAMPLE_RESOLVE_BOX_BIT
    | EGL_SWAP_BEHAVIOR_PRESERVED_BIT
    | EGL_MUTABLE_RENDER_BUFFER_BIT_KHR;
const COLOR_BUFFERS: [Int; 2] = [EGL_RGB_BUFFER, EGL_LUMINANCE_BUFFER];
const CAVEATS: [Int; 3] = [EGL_NONE, EGL_SLOW_CONFIG, EGL_NON_CONFORMANT_CONFIG];
const TRANSPARENCIES: [Int; 2] = [EGL_NONE, EGL_TRANSPARENT_RGB];
const COMPONENTS: [Int; 2] =
    [EGL_COLOR_COMPONENT_TYPE_FIXED_EXT, EGL_COLOR_COMPONENT_TYPE_FLOAT_EXT];

/// A row of the table: attribute, criterion, what counts when a request does not name it, and what a
/// request may ask for.
type Row = (Int, Criterion, Int, Allowed);

const ATTRIBUTES: [Row; 34] = [
    (EGL_BUFFER_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_RED_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_GREEN_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_BLUE_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_LUMINANCE_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_ALPHA_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_ALPHA_MASK_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_BIND_TO_TEXTURE_RGB, Criterion::Exact, EGL_DONT_CARE, Allowed::Boolean),
    (EGL_BIND_TO_TEXTURE_RGBA, Criterion::Exact, EGL_DONT_CARE, Allowed::Boolean),
    (EGL_COLOR_BUFFER_TYPE, Criterion::Exact, EGL_RGB_BUFFER, Allowed::OneOf(&COLOR_BUFFERS)),
    (EGL_CONFIG_CAVEAT, Criterion::Exact, EGL_DONT_CARE, Allowed::OneOf(&CAVEATS)),
    (EGL_CONFIG_ID, Criterion::Exact, EGL_DONT_CARE, Allowed::Positive),
    (EGL_CONFORMANT, Criterion::Mask, 0, Allowed::Bits(APIS)),
    (EGL_DEPTH_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_LEVEL, Criterion::Exact, 0, Allowed::Level),
    (EGL_MATCH_NATIVE_PIXMAP, Criterion::Ignored, EGL_NONE, Allowed::Any),
    (EGL_MAX_PBUFFER_WIDTH, Criterion::Ignored, EGL_DONT_CARE, Allowed::Count),
    (EGL_MAX_PBUFFER_HEIGHT, Criterion::Ignored, EGL_DONT_CARE, Allowed::Count),
    (EGL_MAX_PBUFFER_PIXELS, Criterion::Ignored, EGL_DONT_CARE, Allowed::Count),
    (EGL_MAX_SWAP_INTERVAL, Criterion::Exact, EGL_DONT_CARE, Allowed::Count),
    (EGL_MIN_SWAP_INTERVAL, Criterion::Exact, EGL_DONT_CARE, Allowed::Count),
    (EGL_NATIVE_RENDERABLE, Criterion::Exact, EGL_DONT_CARE, Allowed::Boolean),
    (EGL_NATIVE_VISUAL_ID, Criterion::Ignored, EGL_DONT_CARE, Allowed::Any),
    (EGL_NATIVE_VISUAL_TYPE, Criterion::Exact, EGL_DONT_CARE, Allowed::Any),
    // EGL's default is OpenGL ES 1, which no config has: a request that names no API would find none.
    (EGL_RENDERABLE_TYPE, Criterion::Mask, EGL_DONT_CARE, Allowed::Bits(APIS)),
    (EGL_SAMPLE_BUFFERS, Criterion::AtLeast, 0, Allowed::Boolean),
    (EGL_SAMPLES, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_STENCIL_SIZE, Criterion::AtLeast, 0, Allowed::Count),
    (EGL_SURFACE_TYPE, Criterion::Mask, EGL_WINDOW_BIT, Allowed::Bits(SURFACES)),
    (EGL_TRANSPARENT_TYPE, Criterion::Exact, EGL_NONE, Allowed::OneOf(&TRANSPARENCIES)),
    (EGL_TRANSPARENT_RED_VALUE, Criterion::Exact, EGL_DONT_CARE, Allowed::Count),
    (EGL_TRANSPARENT_GREEN_VALUE, Criterion::Exact, EGL_DONT_CARE, Allowed::Count),
    (EGL_TRANSPARENT_BLUE_VALUE, Criterion::Exact, EGL_DONT_CARE, Allowed::Count),
    (
        EGL_COLOR_COMPONENT_TYPE_EXT,
        Criterion::Exact,
        EGL_COLOR_COMPONENT_TYPE_FIXED_EXT,
        Allowed::OneOf(&COMPONENTS),
    ),
];

/// Whether a config has what a row of a request wants.
fn meets(config: &Config, (attribute, criterion, wanted, _): Row) -> bool {
    let value = config.get(attribute).unwrap_or(0);
    wanted == EGL_DONT_CARE
        || match criterion {
            Criterion::AtLeast => value >= wanted,
            Criterion::Exact => value == wanted,
            Criterion::Mask => value & wanted == wanted,
            Criterion::Ignored => true,
        }
}

/// Why no config meets a request: the first attribute that none has, by itself.
#[cold]
fn why_none(wanted: &[Row]) -> String {
    let lacks = |row: &&Row| !CONFIGS.iter().any(|config| meets(config, **row));
    match wanted.iter().find(lacks) {
        Some((EGL_SURFACE_TYPE, _, value, _)) if value & EGL_WINDOW_BIT != 0 => {
            "eglChooseConfig: no config, as EGL_SURFACE_TYPE has EGL_WINDOW_BIT, which is its default, \
             and there are no windows: ask for EGL_PBUFFER_BIT"
                .to_owned()
        }
        Some((name, _, value, _)) => format!(
            "eglChooseConfig: no config, as none meets attribute {} = {value} (EGL 1.5, \
             section 3.4)", name_of(*name)
        ),
        None => "eglChooseConfig: no config has all that is asked for together".to_owned(),
    }
}

/// The configs that meet a request, in the order of EGL 1.5, section 3.4.1.2.
fn matching(request: &[(Int, Attrib)]) -> Result<Vec<&'static Config>> {
    let mut wanted = ATTRIBUTES;
    for &(name, value) in request {
        match wanted.iter_mut().find(|row| row.0 == name) {
            Some(row) if row.3.has(value as Int) => row.2 = value as Int,
            Some(_) => {
                let rule =
                    format!("attrib_list: attribute {} has no value {value:#x}", name_of(name));
                return fail(Code::BadAttribute, rule);
            }
            None => {
                return fail(
                    Code::BadAttribute,
                    format!("attrib_list: no attribute {}", name_of(name)),
                );
            }
        }
    }
    let asked =
        |name: Int| wanted.iter().any(|row| row.0 == name && row.2 != 0 && row.2 != EGL_DONT_CARE);
    // An id alone decides.
    let id = wanted.iter().find(|row| row.0 == EGL_CONFIG_ID).map_or(EGL_DONT_CARE, |row| row.2);
    let chosen = |config: &&Config| {
        if id == EGL_DONT_CARE {
            wanted.iter().all(|&row| meets(config, row))
        } else {
            config.id == id
        }
    };
    let mut found: Vec<_> = CONFIGS.iter().filter(chosen).collect();
    if found.is_empty() {
        say("warning", &why_none(&wanted));
    }
    let color = |config: &Config| {
        let rgb = [EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE];
        let rgb = rgb.into_iter().filter(|&name| asked(name)).count() as Int * 8;
        rgb + if asked(EGL_ALPHA_SIZE) { config.alpha } else { 0 }
    };
    found.sort_by_key(|config| {
        let Config { id, alpha, depth, stencil, samples } = **config;
        (Reverse(color(config)), alpha, samples, depth, stencil, id)
    });
    Ok(found)
}

/// Hands configs out, as many as there is room for; without room only their number.
///
/// # Safety
/// `configs`, if not null, has room for `size` handles.
unsafe fn give(
    found: &[&Config],
    configs: *mut Handle,
    size: Int,
    number: *mut Int,
) -> Result<u32> {
    if number.is_null() {
        return fail(Code::BadParameter, "num_config must not be NULL");
    }
    let room = if configs.is_null() { found.len() } else { usize::try_from(size).unwrap_or(0) };
    let count = found.len().min(room);
    if !configs.is_null() {
        for (at, config) in found[..count].iter().enumerate() {
            // SAFETY: `at` is below `size`.
            unsafe { put(configs.add(at), handle(config.handle_id())) };
        }
    }
    // SAFETY: not null, and the client's.
    unsafe { put(number, count as Int) };
    Ok(1)
}

pub(super) unsafe fn choose_config(
    dpy: Handle,
    list: *const Int,
    configs: *mut Handle,
    size: Int,
    number: *mut Int,
) -> Result<u32> {
    registry().display(dpy)?;
    // SAFETY: the client's, as C's prototype says.
    unsafe { give(&matching(&int_attributes(list))?, configs, size, number) }
}

pub(super) unsafe fn get_configs(
    dpy: Handle,
    configs: *mut Handle,
    size: Int,
    number: *mut Int,
) -> Result<u32> {
    registry().display(dpy)?;
    let all: Vec<_> = CONFIGS.iter().collect();
    // SAFETY: the client's, as C's prototype says.
    unsafe { give(&all, configs, size, number) }
}

pub(super) unsafe fn get_config_attrib(
    dpy: Handle,
    config: Handle,
    attribute: Int,
    value: *mut Int,
) -> Result<u32> {
    registry().display(dpy)?;
    let config = Config::find(config)?;
    let Some(found) = config.get(attribute) else {
        return fail(
            Code::BadAttribute,
            format!("attribute = {} is none of configs", name_of(attribute)),
        );
    };
    if value.is_null() {
        return fail(Code::BadParameter, "value must not be NULL");
    }
    // SAFETY: not null, and the client's.
    unsafe { put(value, found) };
    Ok(1)
}
