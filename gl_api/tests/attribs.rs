//! Attribute stacks: a group comes back whole, and nothing else does.

use gl_api::*;

fn context() -> Context {
    Context::new(ContextDesc { width: 4, height: 4, ..ContextDesc::default() }).expect("a device")
}

/// A piece of state: its group, a call that changes it, and what reads it.
type Row = (GLbitfield, GLenum, fn(&mut Context));

const ROWS: &[Row] = &[
    (GL_CURRENT_BIT, GL_CURRENT_COLOR, |c| c.color_4f(0.1, 0.2, 0.3, 0.4)),
    (GL_CURRENT_BIT, GL_CURRENT_NORMAL, |c| c.normal_3f(1.0, 0.0, 0.0)),
    (GL_CURRENT_BIT, GL_CURRENT_TEXTURE_COORDS, |c| c.tex_coord_2f(3.0, 4.0)),
    (GL_POINT_BIT, GL_POINT_SIZE, |c| c.point_size(3.0)),
    (GL_POINT_BIT, GL_POINT_SMOOTH, |c| c.enable(GL_POINT_SMOOTH)),
    (GL_LINE_BIT, GL_LINE_WIDTH, |c| c.line_width(2.0)),
    (GL_LINE_BIT, GL_LINE_STIPPLE, |c| c.enable(GL_LINE_STIPPLE)),
    (GL_POLYGON_BIT, GL_CULL_FACE, |c| c.enable(GL_CULL_FACE)),
    (GL_POLYGON_BIT, GL_CULL_FACE_MODE, |c| c.cull_face(GL_FRONT)),
    (GL_POLYGON_BIT, GL_FRONT_FACE, |c| c.front_face(GL_CW)),
    (GL_POLYGON_BIT, GL_POLYGON_OFFSET_FILL, |c| c.enable(GL_POLYGON_OFFSET_FILL)),
    (GL_POLYGON_BIT, GL_POLYGON_OFFSET_UNITS, |c| c.polygon_offset(1.0, 2.0)),
    (GL_POLYGON_BIT, GL_POLYGON_OFFSET_CLAMP, |c| c.polygon_offset_clamp(1.0, 2.0, 3.0)),
    (GL_LIGHTING_BIT, GL_LIGHTING, |c| c.enable(GL_LIGHTING)),
    (GL_LIGHTING_BIT, GL_LIGHT2, |c| c.enable(GL_LIGHT2)),
    (GL_LIGHTING_BIT, GL_SHADE_MODEL, |c| c.shade_model(GL_FLAT)),
    (GL_LIGHTING_BIT, GL_PROVOKING_VERTEX, |c| c.provoking_vertex(GL_FIRST_VERTEX_CONVENTION)),
    (GL_LIGHTING_BIT, GL_LIGHT_MODEL_TWO_SIDE, |c| c.light_modeli(GL_LIGHT_MODEL_TWO_SIDE, 1)),
    (GL_FOG_BIT, GL_FOG, |c| c.enable(GL_FOG)),
    (GL_FOG_BIT, GL_FOG_DENSITY, |c| c.fogf(GL_FOG_DENSITY, 3.0)),
    (GL_DEPTH_BUFFER_BIT, GL_DEPTH_TEST, |c| c.enable(GL_DEPTH_TEST)),
    (GL_TRANSFORM_BIT, GL_DEPTH_CLAMP, |c| c.enable(GL_DEPTH_CLAMP)),
    (GL_DEPTH_BUFFER_BIT, GL_DEPTH_FUNC, |c| c.depth_func(GL_GREATER)),
    (GL_DEPTH_BUFFER_BIT, GL_DEPTH_WRITEMASK, |c| c.depth_mask(false)),
    (GL_DEPTH_BUFFER_BIT, GL_DEPTH_CLEAR_VALUE, |c| c.clear_depth(0.5)),
    (GL_STENCIL_BUFFER_BIT, GL_STENCIL_TEST, |c| c.enable(GL_STENCIL_TEST)),
    (GL_STENCIL_BUFFER_BIT, GL_STENCIL_REF, |c| c.stencil_func(GL_LESS, 3, 5)),
    (GL_STENCIL_BUFFER_BIT, GL_STENCIL_CLEAR_VALUE, |c| c.clear_stencil(7)),
    (GL_VIEWPORT_BIT, GL_VIEWPORT, |c| c.viewport(1, 2, 3, 4)),
    (GL_VIEWPORT_BIT, GL_DEPTH_RANGE, |c| c.depth_range(0.25, 0.5)),
    (GL_TRANSFORM_BIT, GL_CLIP_ORIGIN, |c| c.clip_control(GL_UPPER_LEFT, GL_ZERO_TO_ONE)),
    (GL_TRANSFORM_BIT, GL_CLIP_DEPTH_MODE, |c| c.clip_control(GL_UPPER_LEFT, GL_ZERO_TO_ONE)),
    (GL_TRANSFORM_BIT, GL_MATRIX_MODE, |c| c.matrix_mode(GL_PROJECTION)),
    (GL_TRANSFORM_BIT, GL_NORMALIZE, |c| c.enable(GL_NORMALIZE)),
    (GL_TRANSFORM_BIT, GL_CLIP_PLANE3, |c| c.enable(GL_CLIP_PLANE3)),
    (GL_COLOR_BUFFER_BIT, GL_ALPHA_TEST, |c| c.enable(GL_ALPHA_TEST)),
    (GL_COLOR_BUFFER_BIT, GL_ALPHA_TEST_REF, |c| c.alpha_func(GL_LESS, 0.25)),
    (GL_COLOR_BUFFER_BIT, GL_BLEND, |c| c.enable(GL_BLEND)),
    (GL_COLOR_BUFFER_BIT, GL_BLEND_SRC_RGB, |c| c.blend_func(GL_ZERO, GL_ONE)),
    (GL_COLOR_BUFFER_BIT, GL_COLOR_WRITEMASK, |c| c.color_mask(true, false, true, false)),
    (GL_COLOR_BUFFER_BIT, GL_COLOR_CLEAR_VALUE, |c| c.clear_color(0.5, 0.25, 0.0, 1.0)),
    (GL_COLOR_BUFFER_BIT, GL_LOGIC_OP_MODE, |c| c.logic_op(GL_XOR)),
    (GL_LIGHTING_BIT, GL_CLAMP_VERTEX_COLOR, |c| c.clamp_color(GL_CLAMP_VERTEX_COLOR, GL_FALSE)),
    (GL_COLOR_BUFFER_BIT, GL_CLAMP_FRAGMENT_COLOR, |c| {
        c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    }),
    (GL_COLOR_BUFFER_BIT, GL_CLAMP_READ_COLOR, |c| c.clamp_color(GL_CLAMP_READ_COLOR, GL_TRUE)),
    (GL_COLOR_BUFFER_BIT, GL_DRAW_BUFFER, |c| c.draw_buffer(GL_NONE)),
    (GL_PIXEL_MODE_BIT, GL_RED_SCALE, |c| c.pixel_transferf(GL_RED_SCALE, 2.0)),
    (GL_PIXEL_MODE_BIT, GL_ZOOM_X, |c| c.pixel_zoom(2.0, 3.0)),
    (GL_CURRENT_BIT, GL_CURRENT_RASTER_POSITION, |c| c.window_pos_2i(1, 2)),
    (GL_PIXEL_MODE_BIT, GL_READ_BUFFER, |c| c.read_buffer(GL_NONE)),
    (GL_HINT_BIT, GL_FOG_HINT, |c| c.hint(GL_FOG_HINT, GL_NICEST)),
    (GL_LIST_BIT, GL_LIST_BASE, |c| c.list_base(5)),
    (GL_SCISSOR_BIT, GL_SCISSOR_TEST, |c| c.enable(GL_SCISSOR_TEST)),
    (GL_SCISSOR_BIT, GL_SCISSOR_BOX, |c| c.scissor(1, 1, 2, 2)),
    (GL_TEXTURE_BIT, GL_TEXTURE_BINDING_2D, |c| c.bind_texture(GL_TEXTURE_2D, 9)),
    (GL_TEXTURE_BIT, GL_TEXTURE_2D, |c| c.enable(GL_TEXTURE_2D)),
    (GL_TEXTURE_BIT, GL_TEXTURE_GEN_S, |c| c.enable(GL_TEXTURE_GEN_S)),
    (GL_TEXTURE_BIT, GL_ACTIVE_TEXTURE, |c| c.active_texture(GL_TEXTURE3)),
    (GL_MULTISAMPLE_BIT, GL_MULTISAMPLE, |c| c.disable(GL_MULTISAMPLE)),
    (GL_MULTISAMPLE_BIT, GL_SAMPLE_MASK, |c| c.enable(GL_SAMPLE_MASK)),
    (GL_MULTISAMPLE_BIT, GL_SAMPLE_SHADING, |c| c.enable(GL_SAMPLE_SHADING)),
    (GL_MULTISAMPLE_BIT, GL_MIN_SAMPLE_SHADING_VALUE, |c| c.min_sample_shading(0.5)),
];

/// Up to sixteen values of a piece of state.
fn read(c: &mut Context, pname: GLenum) -> [GLfloat; 16] {
    let mut values = [0.0; 16];
    c.get_floatv(pname, &mut values);
    values
}

#[test]
fn a_group_comes_back_and_no_other_does() {
    for &(bit, pname, change) in ROWS {
        let name = enum_name(pname);
        let mut c = context();
        let before = read(&mut c, pname);
        c.push_attrib(bit);
        change(&mut c);
        let changed = read(&mut c, pname);
        assert_ne!(before, changed, "{name}: the change changes nothing");
        c.pop_attrib();
        assert_eq!(before, read(&mut c, pname), "{name} comes back");
        c.push_attrib(GL_ALL_ATTRIB_BITS & !bit & !GL_ENABLE_BIT);
        change(&mut c);
        c.pop_attrib();
        assert_eq!(changed, read(&mut c, pname), "{name} stays");
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}: {:?}", c.messages());
    }
}

/// Whether sprites replace the coordinates of the active unit.
fn replaces(c: &mut Context) -> GLint {
    let mut value = [9];
    c.get_tex_enviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &mut value);
    value[0]
}

#[test]
fn the_coordinates_of_sprites_are_of_the_points() {
    for (bit, after) in [(GL_POINT_BIT, 0), (GL_TEXTURE_BIT, 1), (GL_ALL_ATTRIB_BITS, 0)] {
        let mut c = context();
        c.push_attrib(bit);
        c.tex_envi(GL_POINT_SPRITE, GL_COORD_REPLACE, 1);
        c.active_texture(GL_TEXTURE1);
        c.enable(GL_TEXTURE_GEN_S);
        c.pop_attrib();
        assert_eq!(c.is_enabled(GL_TEXTURE_GEN_S), bit == GL_POINT_BIT, "{bit:#x}");
        c.active_texture(GL_TEXTURE0);
        assert_eq!(replaces(&mut c), after, "{bit:#x}");
    }
}

#[test]
fn buffers_come_back_to_framebuffers_that_have_them() {
    let mut c = context();
    let mut names = [0; 2];
    c.gen_framebuffers(2, &mut names);
    let selected =
        |c: &mut Context| [GL_DRAW_BUFFER, GL_READ_BUFFER].map(|pname| read(c, pname)[0]);
    let of = |draw: GLenum, read: GLenum| [draw as f32, read as f32];
    // From the window to an object and back: each keeps what it can have.
    c.push_attrib(GL_ALL_ATTRIB_BITS);
    c.bind_framebuffer(GL_FRAMEBUFFER, names[0]);
    c.pop_attrib();
    assert_eq!(selected(&mut c), of(GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0));
    c.push_attrib(GL_ALL_ATTRIB_BITS);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.pop_attrib();
    assert_eq!(selected(&mut c), of(GL_FRONT, GL_FRONT));
    // What is read belongs to the framebuffer that is read.
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, names[0]);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, names[1]);
    c.read_buffer(GL_COLOR_ATTACHMENT1);
    c.draw_buffer(GL_COLOR_ATTACHMENT2);
    c.push_attrib(GL_PIXEL_MODE_BIT | GL_COLOR_BUFFER_BIT);
    c.read_buffer(GL_COLOR_ATTACHMENT0);
    c.draw_buffer(GL_NONE);
    c.pop_attrib();
    assert_eq!(selected(&mut c), of(GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT1));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn everything_that_is_enabled_is_a_group_too() {
    let capabilities = [
        GL_ALPHA_TEST,
        GL_BLEND,
        GL_CLIP_PLANE0,
        GL_COLOR_MATERIAL,
        GL_CULL_FACE,
        GL_DEPTH_TEST,
        GL_FOG,
        GL_LIGHT0,
        GL_LIGHTING,
        GL_LINE_SMOOTH,
        GL_NORMALIZE,
        GL_POINT_SPRITE,
        GL_POLYGON_STIPPLE,
        GL_SCISSOR_TEST,
        GL_STENCIL_TEST,
        GL_TEXTURE_1D,
        GL_TEXTURE_CUBE_MAP,
        GL_TEXTURE_GEN_Q,
        GL_VERTEX_PROGRAM_TWO_SIDE,
    ];
    let mut c = context();
    c.push_attrib(GL_ENABLE_BIT);
    for capability in capabilities {
        c.enable(capability);
    }
    c.color_3f(0.0, 1.0, 0.0);
    c.pop_attrib();
    for capability in capabilities {
        assert!(!c.is_enabled(capability), "{}", enum_name(capability));
    }
    assert_eq!(read(&mut c, GL_CURRENT_COLOR)[0], 0.0);
}

#[test]
fn texture_parameters_come_back_with_their_texture() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.push_attrib(GL_TEXTURE_BIT);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE as GLint);
    c.bind_texture(GL_TEXTURE_2D, 2);
    c.pop_attrib();
    let mut wrap = [0];
    c.get_tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &mut wrap);
    assert_eq!(wrap[0] as GLenum, GL_REPEAT);
    let rest = |c: &mut Context| {
        let mut values = [[9.0]; 2];
        c.get_tex_parameterfv(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, &mut values[0]);
        c.get_tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, &mut values[1]);
        values.concat()
    };
    c.push_attrib(GL_TEXTURE_BIT);
    c.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
    c.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, 0.25);
    assert_eq!(rest(&mut c), [1.0, 0.25]);
    c.pop_attrib();
    assert_eq!(rest(&mut c), [0.0, 1.0]);
    // One that was deleted meanwhile stays deleted.
    c.push_attrib(GL_TEXTURE_BIT);
    c.delete_textures(1, &[1]);
    c.pop_attrib();
    assert!(!c.is_texture(1));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

#[test]
fn the_maps_of_pixels_are_of_no_group() {
    let mut c = context();
    c.push_attrib(GL_ALL_ATTRIB_BITS);
    c.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 2, [0.5_f32, 0.25].as_slice().arg());
    c.pixel_transferi(GL_INDEX_OFFSET, 3);
    c.pop_attrib();
    let found = [GL_PIXEL_MAP_R_TO_R_SIZE, GL_INDEX_OFFSET].map(|pname| read(&mut c, pname)[0]);
    assert_eq!(found, [2.0, 0.0]);
}

#[test]
fn the_clients_groups_come_back() {
    let mut c = context();
    c.bind_buffer(GL_ARRAY_BUFFER, 3);
    c.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS);
    assert_eq!(read(&mut c, GL_CLIENT_ATTRIB_STACK_DEPTH)[0], 1.0);
    c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
    c.pixel_storei(GL_PACK_ROW_LENGTH, 9);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    c.client_active_texture(GL_TEXTURE2);
    c.enable(GL_PRIMITIVE_RESTART);
    c.primitive_restart_index(7);
    c.pop_client_attrib();
    for (pname, value) in [
        (GL_UNPACK_ALIGNMENT, 4.0),
        (GL_PACK_ROW_LENGTH, 0.0),
        (GL_VERTEX_ARRAY, 0.0),
        (GL_ARRAY_BUFFER_BINDING, 3.0),
        (GL_CLIENT_ACTIVE_TEXTURE, GL_TEXTURE0 as GLfloat),
        (GL_PRIMITIVE_RESTART, 0.0),
        (GL_PRIMITIVE_RESTART_INDEX, 0.0),
        (GL_CLIENT_ATTRIB_STACK_DEPTH, 0.0),
    ] {
        assert_eq!(read(&mut c, pname)[0], value, "{}", enum_name(pname));
    }
}

#[test]
fn the_arrays_of_an_object_come_back_to_it_alone() {
    for deleted in [false, true] {
        let mut c = context();
        let mut names = [0; 2];
        c.gen_vertex_arrays(2, &mut names);
        c.bind_vertex_array(names[0]);
        c.primitive_restart_index(9);
        c.bind_buffer(GL_ARRAY_BUFFER, 3);
        c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 4);
        c.vertex_pointer(3, GL_SHORT, 16, Data::Offset(0));
        c.push_client_attrib(GL_CLIENT_VERTEX_ARRAY_BIT);
        c.primitive_restart_index(5);
        c.bind_buffer(GL_ARRAY_BUFFER, 0);
        if deleted {
            c.delete_vertex_arrays(1, &names);
        }
        c.bind_vertex_array(names[1]);
        assert_eq!(read(&mut c, GL_PRIMITIVE_RESTART_INDEX)[0], 5.0, "is of no object");
        c.pop_client_attrib();
        // What is of no object comes back in any case.
        assert_eq!(read(&mut c, GL_ARRAY_BUFFER_BINDING)[0], 3.0);
        assert_eq!(read(&mut c, GL_PRIMITIVE_RESTART_INDEX)[0], 9.0);
        let arrays = |c: &mut Context| {
            [GL_VERTEX_ARRAY_BINDING, GL_VERTEX_ARRAY_STRIDE, GL_ELEMENT_ARRAY_BUFFER_BINDING]
                .map(|pname| read(c, pname)[0] as GLuint)
        };
        let expected = if deleted { [names[1], 0, 0] } else { [names[0], 16, 4] };
        assert_eq!(arrays(&mut c), expected, "deleted: {deleted}");
        c.bind_vertex_array(0);
        assert_eq!(arrays(&mut c), [0; 3], "deleted: {deleted}");
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    }
}

#[test]
fn stacks_have_an_end() {
    let mut c = context();
    c.pop_attrib();
    assert_eq!(c.get_error(), GL_STACK_UNDERFLOW);
    c.pop_client_attrib();
    assert_eq!(c.get_error(), GL_STACK_UNDERFLOW);
    for _ in 0..16 {
        c.push_attrib(GL_ALL_ATTRIB_BITS);
        c.push_client_attrib(GL_CLIENT_ALL_ATTRIB_BITS);
    }
    assert_eq!(c.get_error(), GL_NO_ERROR);
    c.push_attrib(0);
    assert_eq!(c.get_error(), GL_STACK_OVERFLOW);
    c.push_client_attrib(0);
    assert_eq!(c.get_error(), GL_STACK_OVERFLOW);
    assert_eq!(read(&mut c, GL_ATTRIB_STACK_DEPTH)[0], 16.0);
}
