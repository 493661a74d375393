//! What each attribute group holds: everything is changed after a push of one group, and what comes back
//! is listed.

#[path = "common/state_table.rs"]
mod state_table;

use gl_api::*;
use state_table::{LEAST, STATE, get};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::LazyLock;

const GROUPS: &[(&str, GLbitfield)] = &[
    ("nothing", 0),
    ("current", GL_CURRENT_BIT),
    ("point", GL_POINT_BIT),
    ("line", GL_LINE_BIT),
    ("polygon", GL_POLYGON_BIT),
    ("polygon stipple", GL_POLYGON_STIPPLE_BIT),
    ("pixel mode", GL_PIXEL_MODE_BIT),
    ("lighting", GL_LIGHTING_BIT),
    ("fog", GL_FOG_BIT),
    ("depth buffer", GL_DEPTH_BUFFER_BIT),
    ("accumulation buffer", GL_ACCUM_BUFFER_BIT),
    ("stencil buffer", GL_STENCIL_BUFFER_BIT),
    ("viewport", GL_VIEWPORT_BIT),
    ("transform", GL_TRANSFORM_BIT),
    ("enable", GL_ENABLE_BIT),
    ("color buffer", GL_COLOR_BUFFER_BIT),
    ("hint", GL_HINT_BIT),
    ("evaluators", GL_EVAL_BIT),
    ("list", GL_LIST_BIT),
    ("texture", GL_TEXTURE_BIT),
    ("scissor", GL_SCISSOR_BIT),
    ("multisample", GL_MULTISAMPLE_BIT),
];
const CLIENT_GROUPS: &[(&str, GLbitfield)] = &[
    ("nothing", 0),
    ("pixel store", GL_CLIENT_PIXEL_STORE_BIT),
    ("vertex arrays", GL_CLIENT_VERTEX_ARRAY_BIT),
];

const TARGETS: [GLenum; 3] = [GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP];
const SIDES: [GLenum; 2] = [GL_FRONT, GL_BACK];
const COORDS: [GLenum; 4] = [GL_S, GL_T, GL_R, GL_Q];
const UNITS: [GLenum; 2] = [GL_TEXTURE0, GL_TEXTURE3];

/// Of the state what can be switched on and off.
static CAPABILITIES: LazyLock<Vec<GLenum>> = LazyLock::new(|| {
    let mut c = context();
    let mut is_capability = |name: &GLenum| {
        c.is_enabled(*name);
        c.get_error() == GL_NO_ERROR && *name != GL_DEBUG_OUTPUT
    };
    STATE.iter().map(|row| row.0).filter(|name| is_capability(name)).collect()
});

fn context() -> Context {
    let mut c = Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() })
        .expect("a device");
    let mut samplers = [0; 1];
    c.gen_samplers(1, &mut samplers);
    c
}

/// Changes all of the state that calls change and `glGet…` gives; the more of it is switched on, the
/// higher the round.
fn change(c: &mut Context, round: u8) {
    let on = round % 2 == 1;
    let switch = |c: &mut Context, cap| if on { c.enable(cap) } else { c.disable(cap) };
    let number = f32::from(round) / 16.0;
    let four = [number, number * 0.5, number * 0.25, 0.75];
    CAPABILITIES.iter().for_each(|&name| switch(c, name));
    for cap in [GL_STENCIL_TEST_TWO_SIDE_EXT, GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_PRIMITIVE_RESTART] {
        switch(c, cap);
    }
    c.bind_buffer(GL_PIXEL_UNPACK_BUFFER, 0);
    c.pixel_storei(GL_UNPACK_SKIP_ROWS, 0);
    let choose = |off: GLenum, yes: GLenum| if on { yes } else { off };
    c.color_4f(four[0], four[1], four[2], four[3]);
    c.window_pos_2i(i32::from(round), 2);
    c.secondary_color_3f(four[0], four[1], four[2]);
    c.normal_3f(four[0], four[1], four[2]);
    c.tex_coord_4f(four[0], four[1], four[2], four[3]);
    c.fog_coordf(number);
    c.edge_flag(!on);
    c.vertex_attrib_4f(5, four[0], four[1], four[2], four[3]);
    c.point_size(1.0 + number);
    c.point_parameterf(GL_POINT_SIZE_MIN, number);
    c.point_parameterf(GL_POINT_FADE_THRESHOLD_SIZE, number);
    c.line_width(1.0 + number);
    c.line_stipple(1 + i32::from(round), 0x1234);
    c.cull_face(choose(GL_BACK, GL_FRONT));
    c.front_face(choose(GL_CCW, GL_CW));
    c.polygon_mode(GL_FRONT_AND_BACK, choose(GL_FILL, GL_LINE));
    c.polygon_offset(number, 2.0 * number);
    c.polygon_stipple(Data::Bytes(&[round; 128]));
    c.pixel_transferf(GL_RED_SCALE, number);
    c.pixel_transferi(GL_MAP_COLOR, i32::from(on));
    c.pixel_zoom(number, number);
    c.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 2, [number, 0.25].as_slice().arg());
    c.read_buffer(choose(GL_FRONT, GL_BACK));
    c.draw_buffer(choose(GL_FRONT, GL_BACK));
    for light in [GL_LIGHT0, GL_LIGHT5] {
        c.lightfv(light, GL_POSITION, &four);
        c.lightfv(light, GL_DIFFUSE, &four);
        c.lightf(light, GL_SPOT_CUTOFF, f32::from(round));
    }
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &four);
    c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, i32::from(on));
    c.color_material(GL_FRONT, choose(GL_EMISSION, GL_SPECULAR));
    c.materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, &four);
    c.materialf(GL_FRONT_AND_BACK, GL_SHININESS, number);
    c.shade_model(choose(GL_SMOOTH, GL_FLAT));
    c.provoking_vertex(choose(GL_LAST_VERTEX_CONVENTION, GL_FIRST_VERTEX_CONVENTION));
    c.fogf(GL_FOG_DENSITY, number);
    c.fogfv(GL_FOG_COLOR, &four);
    c.fogi(GL_FOG_MODE, choose(GL_EXP, GL_LINEAR) as i32);
    c.depth_func(choose(GL_LESS, GL_GREATER));
    c.depth_mask(!on);
    c.clear_depth(f64::from(number));
    c.clear_accum(four[0], four[1], four[2], four[3]);
    c.stencil_func(GL_LESS, i32::from(round), 5);
    c.stencil_op(GL_ZERO, choose(GL_KEEP, GL_INCR), GL_DECR);
    c.stencil_mask(u32::from(round));
    c.clear_stencil(i32::from(round));
    c.viewport(i32::from(round), 0, 3, 3);
    c.depth_range(f64::from(number), 0.5);
    c.clip_plane(GL_CLIP_PLANE3, &four.map(f64::from));
    c.alpha_func(choose(GL_ALWAYS, GL_LESS), number);
    c.blend_func(choose(GL_ONE, GL_DST_COLOR), GL_ONE);
    c.blend_equation(choose(GL_FUNC_ADD, GL_MAX));
    c.blend_color(four[0], four[1], four[2], four[3]);
    c.color_mask(on, false, true, on);
    c.index_mask(u32::from(round));
    c.logic_op(choose(GL_COPY, GL_XOR));
    c.clear_color(four[0], four[1], four[2], four[3]);
    c.clamp_color(GL_CLAMP_VERTEX_COLOR, choose(GL_TRUE, GL_FALSE));
    c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, choose(GL_TRUE, GL_FALSE));
    c.hint(GL_FOG_HINT, choose(GL_FASTEST, GL_NICEST));
    c.map_grid1f(1 + i32::from(round), 0.0, number);
    c.list_base(u32::from(round));
    c.scissor(0, 0, i32::from(round), 2);
    c.sample_coverage(number, on);
    for unit in UNITS {
        c.active_texture(unit);
        for target in TARGETS {
            c.bind_texture(target, if on { target } else { 0 });
            switch(c, target);
            c.tex_parameterf(target, GL_TEXTURE_MIN_LOD, number);
            c.tex_parameterf(target, GL_TEXTURE_PRIORITY, number);
            c.tex_parameteri(target, GL_GENERATE_MIPMAP, i32::from(on));
        }
        c.bind_sampler(unit - GL_TEXTURE0, u32::from(on));
        c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, choose(GL_BLEND, GL_ADD) as i32);
        c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &four);
        c.tex_envf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, number);
        c.tex_envi(GL_POINT_SPRITE, GL_COORD_REPLACE, i32::from(on));
        for (coord, cap) in COORDS.into_iter().zip(GL_TEXTURE_GEN_S..) {
            switch(c, cap);
            c.tex_genfv(coord, GL_OBJECT_PLANE, &four);
        }
    }
    c.active_texture(choose(GL_TEXTURE1, GL_TEXTURE2));
    c.matrix_mode(choose(GL_MODELVIEW, GL_PROJECTION));
    c.pixel_storei(GL_PACK_ROW_LENGTH, i32::from(round));
    c.pixel_storei(GL_UNPACK_SKIP_ROWS, i32::from(round));
    c.client_active_texture(choose(GL_TEXTURE0, GL_TEXTURE2));
    for target in [GL_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER] {
        c.bind_buffer(target, u32::from(round));
    }
    c.vertex_pointer(2, GL_SHORT, i32::from(round), Data::Offset(0));
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, u32::from(round));
    c.primitive_restart_index(u32::from(round));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

/// All state, by name.
fn state(c: &mut Context) -> BTreeMap<String, Vec<f64>> {
    let mut all = BTreeMap::new();
    for &(name, ..) in STATE.iter().filter(|row| !LEAST.iter().any(|least| least.0 == row.0)) {
        all.insert(enum_name(name), get(c, name).unwrap_or_default());
    }
    let mut put = |name: String, values: &[f32]| {
        all.insert(name, values.iter().copied().map(f64::from).collect());
    };
    let mut four = [0.0; 4];
    for light in [GL_LIGHT0, GL_LIGHT5] {
        for pname in [GL_POSITION, GL_DIFFUSE, GL_SPOT_CUTOFF] {
            c.get_lightfv(light, pname, &mut four);
            put(format!("{} {}", enum_name(light), enum_name(pname)), &four);
        }
    }
    for side in SIDES {
        for pname in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS] {
            c.get_materialfv(side, pname, &mut four);
            put(format!("{} {}", enum_name(side), enum_name(pname)), &four);
        }
    }
    c.get_vertex_attribfv(5, GL_CURRENT_VERTEX_ATTRIB, &mut four);
    put("attribute 5".into(), &four);
    let mut plane = [0.0; 4];
    c.get_clip_plane(GL_CLIP_PLANE3, &mut plane);
    put("GL_CLIP_PLANE3 equation".into(), &plane.map(|number| number as f32));
    let mut stipple = [0; 128];
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 0);
    c.pixel_storei(GL_PACK_ROW_LENGTH, 0);
    c.get_polygon_stipple(DataOut::Bytes(&mut stipple));
    put("stipple".into(), &[stipple[0].into()]);
    for unit in UNITS {
        let unit_name = enum_name(unit);
        c.active_texture(unit);
        for (target, binding) in TARGETS.into_iter().zip([
            GL_TEXTURE_BINDING_1D,
            GL_TEXTURE_BINDING_2D,
            GL_TEXTURE_BINDING_CUBE_MAP,
        ]) {
            let name = format!("{unit_name} {}", enum_name(target));
            c.get_floatv(binding, &mut four[..1]);
            put(format!("{name} binding"), &four[..1]);
            put(format!("{name} enabled"), &[u8::from(c.is_enabled(target)).into()]);
            for texture in [0, target] {
                c.bind_texture(target, texture);
                for pname in [GL_TEXTURE_MIN_LOD, GL_TEXTURE_PRIORITY, GL_GENERATE_MIPMAP] {
                    c.get_tex_parameterfv(target, pname, &mut four[..1]);
                    let of = format!("{} {texture} {}", enum_name(target), enum_name(pname));
                    put(of, &four[..1]);
                }
            }
        }
        c.get_floatv(GL_SAMPLER_BINDING, &mut four[..1]);
        put(format!("{unit_name} sampler"), &four[..1]);
        for (target, pname, count) in [
            (GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, 1),
            (GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 4),
            (GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1),
            (GL_POINT_SPRITE, GL_COORD_REPLACE, 1),
        ] {
            c.get_tex_envfv(target, pname, &mut four[..count]);
            put(format!("{unit_name} {}", enum_name(pname)), &four[..count]);
        }
        for (coord, cap) in COORDS.into_iter().zip(GL_TEXTURE_GEN_S..) {
            c.get_tex_genfv(coord, GL_OBJECT_PLANE, &mut four);
            put(format!("{unit_name} {} plane", enum_name(cap)), &four);
            put(format!("{unit_name} {}", enum_name(cap)), &[u8::from(c.is_enabled(cap)).into()]);
        }
    }
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    all
}

/// What comes back of what is changed between two calls, for state that was changed before or not.
fn comes_back(first: u8, push: impl Fn(&mut Context), pop: impl Fn(&mut Context)) -> Vec<String> {
    let after = |calls: &dyn Fn(&mut Context)| {
        let mut c = context();
        change(&mut c, first);
        calls(&mut c);
        state(&mut c)
    };
    let before = after(&|_| ());
    let changed = after(&|c| change(c, first + 1));
    let popped = after(&|c| {
        push(c);
        change(c, first + 1);
        pop(c);
    });
    let differ = before.iter().filter(|(name, value)| changed[*name] != **value);
    let back = differ.filter(|(name, value)| popped[*name] == **value);
    back.map(|(name, _)| name.clone()).collect()
}

#[test]
fn groups_are_what_comes_back() {
    let mut report = String::new();
    let mut list = |name: &str, of: &dyn Fn(u8) -> Vec<String>| {
        // Whether things are switched on or off meanwhile.
        let [on, off] = [2, 3].map(of);
        writeln!(report, "{name}:").expect("text");
        on.iter().for_each(|name| writeln!(report, "    {name}").expect("text"));
        let both = |name: &&String| !on.contains(*name);
        off.iter().filter(both).for_each(|name| writeln!(report, "    {name} (on)").expect("text"));
        on.iter().filter(|name| !off.contains(name)).for_each(|name| {
            writeln!(report, "    {name} (off)").expect("text");
        });
    };
    for &(name, bits) in GROUPS {
        list(name, &|first| comes_back(first, |c| c.push_attrib(bits), |c| c.pop_attrib()));
    }
    for &(name, bits) in CLIENT_GROUPS {
        let of =
            |first| comes_back(first, |c| c.push_client_attrib(bits), |c| c.pop_client_attrib());
        list(&format!("client's {name}"), &of);
    }
    insta::assert_snapshot!(report);
}

/// Memory of pushes is used again: nothing of an earlier one is in a later one.
#[test]
fn groups_that_were_popped_do_not_come_back() {
    let mut c = context();
    for &(_, bits) in GROUPS {
        change(&mut c, 2);
        c.push_attrib(GL_ALL_ATTRIB_BITS);
        c.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS);
        c.pop_client_attrib();
        c.pop_attrib();
        change(&mut c, 3);
        c.push_attrib(bits);
        c.push_client_attrib(0);
        c.pop_client_attrib();
        c.pop_attrib();
        let popped = state(&mut c);
        let mut other = context();
        change(&mut other, 2);
        change(&mut other, 3);
        assert!(popped == state(&mut other), "{bits:#x}");
    }
}
