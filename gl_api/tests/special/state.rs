//! Every row of the tables of GL 2.1, section 6.2: what `glGet` answers at first, in each type.

use super::state_table::{As, LEAST, STATE, get};
use super::{context, fine};
use gl_api::description::{ValueType, states};
use gl_api::*;

/// A fraction as an integer: the entry INT of GL 2.1, table 4.9.
fn int_of_fraction(value: f64) -> i32 {
    (((2_f64.powi(32) - 1.0) * value - 1.0) / 2.0).round_ties_even() as i32
}

#[test]
fn state_begins_as_the_tables_say_in_every_type() {
    let mut c = context(16, 8);
    for &(name, conversion, expected) in STATE {
        let label = enum_name(name);
        assert_eq!(get(&mut c, name).as_deref(), Some(expected), "{label}");
        let mut floats = [f32::NAN; 16];
        c.get_floatv(name, &mut floats);
        let mut ints = [i32::MIN; 16];
        c.get_integerv(name, &mut ints);
        let mut bools = [9; 17];
        c.get_booleanv(name, &mut bools);
        let mut longs = [0; 16];
        c.get_integer64v(name, &mut longs);
        fine(&mut c);
        for (at, &value) in expected.iter().enumerate() {
            assert_eq!(floats[at], value as f32, "{label}");
            assert_eq!(bools[at], u8::from(value != 0.0), "{label}");
            let int = match conversion {
                As::Number => value.round() as i64 as i32,
                As::Fraction => int_of_fraction(value),
            };
            assert_eq!(ints[at], int, "{label}");
            match conversion {
                As::Number => assert_eq!(longs[at], value.round() as i64, "{label}"),
                As::Fraction => assert_eq!(longs[at], i64::from(int), "{label}"),
            }
        }
        assert!(bools[expected.len()] == 9, "{label} has more values");
    }
}

#[test]
fn limits_are_at_least_those_of_the_tables() {
    let mut c = context(16, 8);
    for &(name, _, least) in LEAST {
        let values = get(&mut c, name).unwrap_or_default();
        let enough = values.iter().zip(least).all(|(value, least)| value >= least);
        assert!(values.len() == least.len() && enough, "{}: {values:?}", enum_name(name));
    }
}

#[test]
fn capabilities_answer_both_ways() {
    let mut c = context(16, 8);
    let one = |row: &&(GLenum, As, &[f64])| row.2.len() == 1;
    let mut capabilities = 0;
    for (name, ..) in STATE.iter().filter(one) {
        let before = c.is_enabled(*name);
        if c.get_error() != GL_NO_ERROR {
            continue;
        }
        capabilities += 1;
        for on in [!before, before] {
            if on {
                c.enable(*name)
            } else {
                c.disable(*name)
            }
            assert_eq!(c.is_enabled(*name), on, "{}", enum_name(*name));
            assert_eq!(get(&mut c, *name), Some(vec![f64::from(u8::from(on))]));
        }
    }
    fine(&mut c);
    assert!(capabilities > 80, "{capabilities}");
}

#[test]
fn texts_answer() {
    let mut c = context(16, 8);
    assert!(c.get_string(GL_VERSION).starts_with("3.3"));
    assert_eq!(get(&mut c, GL_MAJOR_VERSION), Some(vec![3.0]));
    assert_eq!(get(&mut c, GL_MINOR_VERSION), Some(vec![3.0]));
    for name in [GL_VENDOR, GL_RENDERER, GL_SHADING_LANGUAGE_VERSION] {
        assert!(!c.get_string(name).is_empty());
    }
    let count = get(&mut c, GL_NUM_EXTENSIONS).expect("a number")[0] as u32;
    let listed: Vec<&str> = (0..count).map(|index| c.get_stringi(GL_EXTENSIONS, index)).collect();
    // As many as fit into the array of an old program.
    let (all, string) = (listed.join(" "), c.get_string(GL_EXTENSIONS));
    assert!(string.len() < 4096 && string.len() > 4000, "{}", string.len());
    let rest = all.strip_prefix(string).expect("the names, in their order");
    assert!(rest.is_empty() || rest.starts_with(' '), "a name is cut: {rest}");
    fine(&mut c);
}

/// Sets much of the state to numbers that are not whole.
fn set_fractions(c: &mut Context) {
    c.clear_color(0.1, 0.25, 0.7, 0.3);
    c.clear_accum(-0.3, 0.6, 0.25, 0.1);
    c.clear_depth(0.3);
    c.clear_index(6.6);
    c.depth_range(0.1, 0.7);
    c.blend_color(0.1, 0.9, 0.3, 0.2);
    c.alpha_func(GL_LESS, 0.3);
    c.color_4f(0.1, 0.2, 0.7, 0.9);
    c.secondary_color_3f(0.2, 0.7, 0.9);
    c.normal_3f(-0.3, 0.1, 0.6);
    c.multi_tex_coord_4f(GL_TEXTURE0, -1.6, 0.4, 2.5, -0.5);
    c.fog_coordf(-2.6);
    c.indexf(7.6);
    c.fogfv(GL_FOG_COLOR, &[0.3, 0.2, 0.7, 0.1]);
    for (pname, value) in [(GL_FOG_DENSITY, 0.6), (GL_FOG_START, -3.5), (GL_FOG_INDEX, 4.4)] {
        c.fogf(pname, value);
    }
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.1, -0.7, 0.4, 0.3]);
    c.point_size(2.6);
    c.line_width(3.4);
    c.point_parameterfv(GL_POINT_DISTANCE_ATTENUATION, &[0.6, 1.4, 2.5]);
    c.point_parameterf(GL_POINT_FADE_THRESHOLD_SIZE, 4.6);
    c.polygon_offset(-1.6, 2.4);
    c.sample_coverage(0.6, true);
    c.pixel_transferf(GL_RED_SCALE, 1.6);
    c.pixel_transferf(GL_DEPTH_BIAS, -0.6);
    c.pixel_transferf(GL_INDEX_OFFSET, 5.6);
    c.pixel_zoom(-1.6, 0.4);
    c.matrix_mode(GL_PROJECTION);
    c.scalef(0.6, -1.6, 2.4);
    c.map_grid1f(4, 0.3, 2.7);
    c.raster_pos_2f(0.3, 0.1);
    c.stencil_mask(0xFFFF_0000);
    fine(c);
}

/// GL 2.1, section 6.1.2, for every row of the table of state that `glGet` reads.
#[test]
fn state_is_converted_by_its_type() {
    let mut c = context(16, 8);
    set_fractions(&mut c);
    let mut fractions = 0;
    for state in states().filter(|state| state.value != GL_TIMESTAMP) {
        let (name, label) = (state.value, state.name);
        let doubles = get(&mut c, name).expect(label);
        if let Some(row) = STATE.iter().find(|row| row.0 == name) {
            let is_fraction = state.ty == ValueType::Fraction;
            assert_eq!(is_fraction, row.1 == As::Fraction, "{label}");
        }
        let mut floats = [f32::NAN; 256];
        c.get_floatv(name, &mut floats);
        let mut ints = [i32::MIN; 256];
        c.get_integerv(name, &mut ints);
        let mut longs = [i64::MIN; 256];
        c.get_integer64v(name, &mut longs);
        let mut bools = [9; 256];
        c.get_booleanv(name, &mut bools);
        fine(&mut c);
        for (at, &value) in doubles.iter().enumerate() {
            let (int, long) = match state.ty {
                ValueType::Fraction => {
                    fractions += usize::from(value.fract() != 0.0);
                    (int_of_fraction(value), i64::from(int_of_fraction(value)))
                }
                // The same bits.
                ValueType::Word => (value as u32 as i32, value as i64),
                ValueType::Capability
                | ValueType::Boolean
                | ValueType::Integer
                | ValueType::Float => (value.round() as i32, value.round() as i64),
            };
            assert_eq!(floats[at], value as f32, "{label}");
            assert_eq!((ints[at], longs[at]), (int, long), "{label} = {value}");
            assert_eq!(bools[at], u8::from(value != 0.0), "{label}");
        }
    }
    assert!(fractions > 35, "{fractions}");
}

/// How a parameter of textures and samplers is stored.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stored {
    Float,
    /// Clamped to [0, 1]; integers are scaled (GL 2.1, section 3.8.4).
    Fraction,
    /// Rounded; not negative.
    Integer,
    Boolean,
}

/// Parameters of one number, and whether sampler objects have them.
const PARAMETERS: [(GLenum, Stored, bool); 7] = [
    (GL_TEXTURE_MIN_LOD, Stored::Float, true),
    (GL_TEXTURE_MAX_LOD, Stored::Float, true),
    (GL_TEXTURE_LOD_BIAS, Stored::Float, true),
    (GL_TEXTURE_PRIORITY, Stored::Fraction, false),
    (GL_TEXTURE_BASE_LEVEL, Stored::Integer, false),
    (GL_TEXTURE_MAX_LEVEL, Stored::Integer, false),
    (GL_GENERATE_MIPMAP, Stored::Boolean, false),
];

/// What a parameter is after a call with a float, or with an integer; `None` where that is refused.
fn stored(pname: GLenum, stored: Stored, value: Result<f32, i32>) -> Option<f64> {
    let number = value.map_or_else(f64::from, f64::from);
    match stored {
        Stored::Float if pname == GL_TEXTURE_LOD_BIAS => Some(number.clamp(-16.0, 16.0)),
        Stored::Float => Some((number as f32).into()),
        Stored::Fraction => {
            // GL 2.1, table 2.9.
            let scaled = |c: i32| (2.0 * f64::from(c) + 1.0) / (2_f64.powi(32) - 1.0);
            Some((value.map_or_else(scaled, f64::from).clamp(0.0, 1.0) as f32).into())
        }
        Stored::Integer => Some(number.round() + 0.0).filter(|level| *level >= 0.0),
        Stored::Boolean => Some(f64::from(u8::from(number != 0.0))),
    }
}

/// The answers of the queries, in the order `fv`, `iv`, `Iiv`, `Iuiv`.
fn answers(c: &mut Context, sampler: Option<u32>, pname: GLenum) -> (f64, [i64; 3]) {
    let t = GL_TEXTURE_2D;
    let (mut float, mut int, mut signed, mut unsigned) = ([f32::NAN], [9], [9], [9]);
    match sampler {
        None => {
            c.get_tex_parameterfv(t, pname, &mut float);
            c.get_tex_parameteriv(t, pname, &mut int);
            c.get_tex_parameter_i_iv(t, pname, &mut signed);
            c.get_tex_parameter_i_uiv(t, pname, &mut unsigned);
        }
        Some(s) => {
            c.get_sampler_parameterfv(s, pname, &mut float);
            c.get_sampler_parameteriv(s, pname, &mut int);
            c.get_sampler_parameter_i_iv(s, pname, &mut signed);
            c.get_sampler_parameter_i_uiv(s, pname, &mut unsigned);
        }
    }
    fine(c);
    (float[0].into(), [int[0].into(), signed[0].into(), unsigned[0].into()])
}

#[test]
fn texture_parameters_are_converted_by_their_type() {
    const FLOATS: [f32; 9] = [0.25, -0.4, 0.4, 0.6, 2.5, -0.6, 7.0, 0.0, -3.0];
    const INTS: [i32; 7] = [0x3fff_ffff, 0, 5, 16_777_217, i32::MAX, -1, i32::MIN];
    let mut c = context(16, 8);
    let t = GL_TEXTURE_2D;
    let mut sampler = [0];
    c.gen_samplers(1, &mut sampler);
    let values = FLOATS.map(Ok).into_iter().chain(INTS.map(Err));
    let cases = PARAMETERS.iter().flat_map(|row| values.clone().map(move |value| (*row, value)));
    for ((pname, kind, for_samplers), value) in cases {
        let label = format!("{} {value:?}", enum_name(pname));
        let forms = if value.is_ok() { 2 } else { 4 };
        for form in 0..forms {
            for object in [None, Some(sampler[0])].into_iter().take(1 + usize::from(for_samplers)) {
                let (before, _) = answers(&mut c, object, pname);
                match (value, object, form) {
                    (Ok(float), None, 0) => c.tex_parameterf(t, pname, float),
                    (Ok(float), None, _) => c.tex_parameterfv(t, pname, &[float]),
                    (Ok(float), Some(s), 0) => c.sampler_parameterf(s, pname, float),
                    (Ok(float), Some(s), _) => c.sampler_parameterfv(s, pname, &[float]),
                    (Err(int), None, 0) => c.tex_parameteri(t, pname, int),
                    (Err(int), None, 1) => c.tex_parameteriv(t, pname, &[int]),
                    (Err(int), None, 2) => c.tex_parameter_i_iv(t, pname, &[int]),
                    (Err(int), Some(s), 0) => c.sampler_parameteri(s, pname, int),
                    (Err(int), Some(s), 1) => c.sampler_parameteriv(s, pname, &[int]),
                    (Err(int), Some(s), 2) => c.sampler_parameter_i_iv(s, pname, &[int]),
                    // Negative ones are large numbers there, except as fractions.
                    (Err(int), ..) if int < 0 && kind != Stored::Fraction => continue,
                    (Err(int), None, _) => c.tex_parameter_i_uiv(t, pname, &[int as u32]),
                    (Err(int), Some(s), _) => c.sampler_parameter_i_uiv(s, pname, &[int as u32]),
                }
                let want = stored(pname, kind, value);
                let error = if want.is_some() { GL_NO_ERROR } else { GL_INVALID_VALUE };
                assert_eq!(c.get_error(), error, "{label}, form {form}");
                c.messages();
                let (float, ints) = answers(&mut c, object, pname);
                let Some(want) = want else {
                    assert_eq!(float, before, "{label}, form {form}");
                    continue;
                };
                assert_eq!(float, f64::from(want as f32), "{label}, form {form}");
                let int = match kind {
                    Stored::Fraction => int_of_fraction(want),
                    Stored::Float | Stored::Integer | Stored::Boolean => want.round() as i32,
                };
                let unsigned = match kind {
                    Stored::Float => want.round() as u32,
                    Stored::Fraction | Stored::Integer | Stored::Boolean => int as u32,
                };
                let want = [int.into(), int.into(), unsigned.into()];
                assert_eq!(ints, want, "{label}, form {form}");
            }
        }
    }
}

/// The pixel store: numbers are rounded, and every truth value but 0 is true (GL 2.1, section 3.6.1).
#[test]
fn floats_set_the_pixel_store() {
    let mut c = context(16, 8);
    for (value, length, flag) in
        [(0.4, 0.0, 1.0), (-0.4, 0.0, 1.0), (2.6, 3.0, 1.0), (0.0, 0.0, 0.0)]
    {
        c.pixel_storef(GL_UNPACK_ROW_LENGTH, value);
        c.pixel_storef(GL_PACK_SWAP_BYTES, value);
        assert_eq!(get(&mut c, GL_UNPACK_ROW_LENGTH), Some(vec![length]), "{value}");
        assert_eq!(get(&mut c, GL_PACK_SWAP_BYTES), Some(vec![flag]), "{value}");
    }
    c.pixel_storef(GL_UNPACK_ALIGNMENT, 1.7);
    c.pixel_transferi(GL_INDEX_OFFSET, 16_777_217);
    assert_eq!(get(&mut c, GL_UNPACK_ALIGNMENT), Some(vec![2.0]));
    assert_eq!(get(&mut c, GL_INDEX_OFFSET), Some(vec![16_777_217.0]));
    fine(&mut c);
}

/// Numbers that are read one way as floats, the other as integers.
type Queries = (fn(&mut Context, GLenum, &mut [f32]), fn(&mut Context, GLenum, &mut [i32]));

/// State with queries of its own: fractions are colours alone (GL 2.1, section 6.1.2).
#[test]
fn parameters_of_lights_materials_and_units_are_converted_by_their_type() {
    const COLORS: [GLenum; 4] = [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION];
    let mut c = context(16, 8);
    let numbers = [0.3, -0.7, 2.6, 0.9];
    let (light, face) = (GL_LIGHT3, GL_FRONT);
    let of_lights = [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION];
    of_lights.iter().for_each(|&pname| c.lightfv(light, pname, &numbers));
    let attenuations = [GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION];
    let others = [GL_SPOT_EXPONENT, GL_SPOT_CUTOFF];
    attenuations.iter().chain(&others).for_each(|&pname| c.lightf(light, pname, 1.6));
    COLORS.iter().for_each(|&pname| c.materialfv(face, pname, &numbers));
    c.materialf(face, GL_SHININESS, 2.6);
    c.materialfv(face, GL_COLOR_INDEXES, &numbers);
    c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.3, 0.7, 0.1, 0.9]);
    c.tex_envf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, -1.6);
    c.tex_genfv(GL_S, GL_OBJECT_PLANE, &numbers);
    c.tex_genfv(GL_S, GL_EYE_PLANE, &numbers);
    fine(&mut c);
    let lights: Queries =
        (|c, p, v| c.get_lightfv(GL_LIGHT3, p, v), |c, p, v| c.get_lightiv(GL_LIGHT3, p, v));
    let materials: Queries =
        (|c, p, v| c.get_materialfv(GL_FRONT, p, v), |c, p, v| c.get_materialiv(GL_FRONT, p, v));
    let environments: Queries = (
        |c, p, v| c.get_tex_envfv(GL_TEXTURE_ENV, p, v),
        |c, p, v| c.get_tex_enviv(GL_TEXTURE_ENV, p, v),
    );
    let filters: Queries = (
        |c, p, v| c.get_tex_envfv(GL_TEXTURE_FILTER_CONTROL, p, v),
        |c, p, v| c.get_tex_enviv(GL_TEXTURE_FILTER_CONTROL, p, v),
    );
    let planes: Queries =
        (|c, p, v| c.get_tex_genfv(GL_S, p, v), |c, p, v| c.get_tex_geniv(GL_S, p, v));
    let rows: [(Queries, &[GLenum]); 8] = [
        (lights, &of_lights),
        (lights, &attenuations),
        (lights, &others),
        (materials, &COLORS),
        (materials, &[GL_SHININESS, GL_COLOR_INDEXES]),
        (environments, &[GL_TEXTURE_ENV_COLOR]),
        (filters, &[GL_TEXTURE_LOD_BIAS]),
        (planes, &[GL_OBJECT_PLANE, GL_EYE_PLANE]),
    ];
    for ((as_floats, as_ints), pnames) in rows {
        for &pname in pnames {
            let (mut floats, mut ints) = ([f32::NAN; 4], [i32::MIN; 4]);
            as_floats(&mut c, pname, &mut floats);
            as_ints(&mut c, pname, &mut ints);
            fine(&mut c);
            let is_color = COLORS.contains(&pname) || pname == GL_TEXTURE_ENV_COLOR;
            let given = floats.iter().zip(ints).filter(|(float, _)| !float.is_nan());
            for (&float, int) in given {
                let value = f64::from(float);
                let want = if is_color { int_of_fraction(value) } else { value.round() as i32 };
                assert_eq!(int, want, "{} {float}", enum_name(pname));
            }
        }
    }
    // Numbers that no `f32` holds.
    c.vertex_attrib_divisor(3, 16_777_217);
    let (mut double, mut int, mut word) = ([0.0], [0], [0]);
    c.get_vertex_attribdv(3, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &mut double);
    c.get_vertex_attribiv(3, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &mut int);
    c.get_vertex_attrib_i_uiv(3, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &mut word);
    assert_eq!((double[0], int[0], word[0]), (16_777_217.0, 16_777_217, 16_777_217));
    c.vertex_attrib_4f(3, 0.6, -1.6, 2.4, 1.0);
    let mut ints = [0; 4];
    c.get_vertex_attribiv(3, GL_CURRENT_VERTEX_ATTRIB, &mut ints);
    assert_eq!(ints, [1, -2, 2, 1]);
    fine(&mut c);
}
