//! The forms of calls that the other tables leave out: each refuses as its siblings do.

use gl_api::*;

/// The preparation, the call, the error flag that it must set, and words that its message must have.
type Case = (fn(&mut Context), fn(&mut Context), GLenum, &'static str);

/// Most rows need nothing.
fn nothing(_: &mut Context) {}

const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const ENUM: GLenum = GL_INVALID_ENUM;
const NO_FRAMEBUFFER: GLenum = GL_INVALID_FRAMEBUFFER_OPERATION;
const T2D: GLenum = GL_TEXTURE_2D;
const NEAR: GLint = GL_NEAREST as GLint;
const COLOR: GLenum = GL_TEXTURE_BORDER_COLOR;

/// A framebuffer without attachments is bound.
fn incomplete(c: &mut Context) {
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
}

/// Query 1 has counted.
fn counted(c: &mut Context) {
    c.gen_queries(1, &mut [0]);
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.end_query(GL_SAMPLES_PASSED);
}

/// Sampler 1 exists.
fn sampler(c: &mut Context) {
    c.gen_samplers(1, &mut [0]);
}

const CASES: &[Case] = &[
    // Reading state.
    (nothing, |c| c.get_booleanv(GL_LINEAR, &mut [0]), ENUM, "names no state"),
    (nothing, |c| c.get_floatv(GL_LINEAR, &mut [0.0]), ENUM, "names no state"),
    (nothing, |c| c.get_doublev(GL_VIEWPORT, &mut [0.0]), OPERATION, "4 values"),
    (nothing, |c| c.get_integer64v(GL_LINEAR, &mut [0]), ENUM, "names no state"),
    (nothing, |c| assert_eq!(c.get_stringi(GL_VENDOR, 0), ""), ENUM, "GL_EXTENSIONS"),
    (nothing, |c| assert_eq!(c.get_stringi(GL_EXTENSIONS, 9999), ""), VALUE, "index = 9999"),
    (nothing, |c| c.get_pointerv(GL_LINEAR, &mut [std::ptr::null_mut()]), ENUM, "no pointer"),
    (nothing, |c| assert!(!c.is_enabled(GL_LINEAR)), ENUM, "cap = GL_LINEAR"),
    (nothing, |c| c.disable(GL_LINEAR), ENUM, "cap = GL_LINEAR"),
    (nothing, |c| c.disable_client_state(GL_LINEAR), ENUM, "array = GL_LINEAR"),
    // Parameters as integers.
    (nothing, |c| c.light_modeliv(GL_AMBIENT, &[0; 4]), ENUM, "pname = GL_AMBIENT"),
    (nothing, |c| c.light_modeliv(GL_LIGHT_MODEL_AMBIENT, &[0]), OPERATION, "1 of 4"),
    (nothing, |c| c.materialiv(GL_LEFT, GL_AMBIENT, &[0; 4]), ENUM, "face = GL_LEFT"),
    (nothing, |c| c.materialiv(GL_BACK, GL_SHININESS, &[129]), VALUE, "GL_SHININESS = 129"),
    (nothing, |c| c.fogiv(GL_AMBIENT, &[0]), ENUM, "pname = GL_AMBIENT"),
    (nothing, |c| c.fogiv(GL_FOG_COLOR, &[0]), OPERATION, "1 of 4"),
    (nothing, |c| c.tex_geniv(GL_AMBIENT, GL_TEXTURE_GEN_MODE, &[0]), ENUM, "coord"),
    (nothing, |c| c.tex_geniv(GL_S, GL_EYE_PLANE, &[0]), OPERATION, "1 of 4"),
    (nothing, |c| c.tex_enviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &[NEAR]), ENUM, "GL_NEAREST"),
    (nothing, |c| c.tex_parameteriv(T2D, COLOR, &[0; 3]), OPERATION, "3 of 4"),
    (nothing, |c| c.tex_parameter_i_iv(T2D, COLOR, &[0; 3]), OPERATION, "3 of 4"),
    (nothing, |c| c.tex_parameter_i_uiv(T2D, COLOR, &[0; 3]), OPERATION, "3 of 4"),
    (nothing, |c| c.get_tex_parameteriv(T2D, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    (nothing, |c| c.get_tex_parameterfv(T2D, GL_LINE, &mut [0.0]), ENUM, "pname = GL_LINE"),
    (nothing, |c| c.get_tex_parameter_i_iv(GL_LINE, COLOR, &mut [0; 4]), ENUM, "target = GL_LINE"),
    (nothing, |c| c.get_tex_parameter_i_uiv(GL_LINE, COLOR, &mut [0; 4]), ENUM, "target = GL_LINE"),
    (nothing, |c| c.get_tex_level_parameterfv(T2D, 0, GL_LINE, &mut [0.0]), ENUM, "pname"),
    (nothing, |c| c.sampler_parameteri(9, GL_TEXTURE_WRAP_S, NEAR), OPERATION, "glGenSamplers"),
    (sampler, |c| c.sampler_parameteriv(1, GL_TEXTURE_WRAP_S, &[NEAR]), ENUM, "GL_NEAREST"),
    (sampler, |c| c.sampler_parameter_i_iv(1, COLOR, &[0; 3]), OPERATION, "3 of 4"),
    (sampler, |c| c.sampler_parameter_i_uiv(1, COLOR, &[0; 3]), OPERATION, "3 of 4"),
    (sampler, |c| c.get_sampler_parameteriv(1, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    (sampler, |c| c.get_sampler_parameter_i_iv(1, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    (sampler, |c| c.get_sampler_parameter_i_uiv(1, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    (nothing, |c| c.pixel_storef(GL_UNPACK_ALIGNMENT, 3.0), VALUE, "must be 1, 2, 4 or 8"),
    // Queries.
    (counted, |c| c.get_query_objectuiv(1, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    (nothing, |c| c.get_query_objecti64v(1, GL_QUERY_RESULT, &mut [0]), OPERATION, "id = 1"),
    (nothing, |c| c.get_query_objectui64v(1, GL_QUERY_RESULT, &mut [0]), OPERATION, "id = 1"),
    // Arrays.
    (nothing, |c| c.normal_pointer(GL_UNSIGNED_BYTE, 0, Data::Null), ENUM, "type ="),
    (nothing, |c| c.normal_pointer(GL_FLOAT, -1, Data::Null), VALUE, "stride = -1"),
    (nothing, |c| c.color_pointer(2, GL_FLOAT, 0, Data::Null), VALUE, "size = 2 must be 3 to 4"),
    (nothing, |c| c.vertex_pointer_ext(2, GL_FLOAT, 0, -1, Data::Null), VALUE, "count = -1"),
    (nothing, |c| c.vertex_pointer_ext(5, GL_FLOAT, 0, 1, Data::Null), VALUE, "size = 5"),
    (nothing, |c| c.normal_pointer_ext(GL_FLOAT, 0, -1, Data::Null), VALUE, "count = -1"),
    (nothing, |c| c.color_pointer_ext(3, GL_LINE, 0, 1, Data::Null), ENUM, "type = GL_LINE"),
    (nothing, |c| c.tex_coord_pointer_ext(2, GL_FLOAT, -1, 1, Data::Null), VALUE, "stride = -1"),
    (nothing, |c| c.index_pointer_ext(GL_FLOAT, 0, -1, Data::Null), VALUE, "count = -1"),
    (nothing, |c| c.edge_flag_pointer_ext(0, -2, Data::Null), VALUE, "count = -2"),
    (nothing, |c| c.color_pointer(3, GL_LINE, 0, Data::Null), ENUM, "type = GL_LINE"),
    (nothing, |c| c.secondary_color_pointer(4, GL_FLOAT, 0, Data::Null), VALUE, "size = 4"),
    (nothing, |c| c.fog_coord_pointer(GL_INT, 0, Data::Null), ENUM, "type = GL_INT"),
    (nothing, |c| c.tex_coord_pointer(0, GL_FLOAT, 0, Data::Null), VALUE, "size = 0"),
    (nothing, |c| c.tex_coord_pointer(5, GL_FLOAT, 0, Data::Null), VALUE, "size = 5"),
    (
        nothing,
        |c| c.vertex_attrib_pointer(16, 4, GL_FLOAT, false, 0, Data::Null),
        VALUE,
        "index = 16",
    ),
    (nothing, |c| c.vertex_attrib_pointer(1, 5, GL_FLOAT, false, 0, Data::Null), VALUE, "size = 5"),
    (nothing, |c| c.enable_vertex_attrib_array(16), VALUE, "index = 16"),
    (nothing, |c| c.disable_vertex_attrib_array(16), VALUE, "index = 16"),
    (
        nothing,
        |c| c.get_vertex_attrib_pointerv(1, GL_LINE, &mut [std::ptr::null_mut()]),
        ENUM,
        "pname = GL_LINE",
    ),
    (nothing, |c| c.get_vertex_attribiv(16, GL_CURRENT_VERTEX_ATTRIB, &mut [0; 4]), VALUE, "16"),
    (nothing, |c| c.get_vertex_attribdv(1, GL_LINE, &mut [0.0]), ENUM, "pname = GL_LINE"),
    (nothing, |c| c.get_vertex_attrib_i_iv(16, GL_CURRENT_VERTEX_ATTRIB, &mut [0; 4]), VALUE, "16"),
    (nothing, |c| c.get_vertex_attrib_i_uiv(1, GL_LINE, &mut [0]), ENUM, "pname = GL_LINE"),
    // Draws.
    (
        incomplete,
        |c| c.rects(0, 0, 1, 1),
        NO_FRAMEBUFFER,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (
        incomplete,
        |c| c.recti(0, 0, 1, 1),
        NO_FRAMEBUFFER,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (
        incomplete,
        |c| c.rectf(0.0, 0.0, 1.0, 1.0),
        NO_FRAMEBUFFER,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (
        incomplete,
        |c| c.rectd(0.0, 0.0, 1.0, 1.0),
        NO_FRAMEBUFFER,
        "framebuffer 1 is incomplete: nothing is attached",
    ),
    (
        nothing,
        |c| c.draw_elements_base_vertex(GL_POINTS, -1, GL_UNSIGNED_BYTE, Data::Null, 0),
        VALUE,
        "count = -1",
    ),
    (
        nothing,
        |c| {
            let none = Data::Null;
            c.draw_range_elements_base_vertex(GL_POINTS, 2, 1, 1, GL_UNSIGNED_BYTE, none, 0);
        },
        VALUE,
        "end = 1",
    ),
    (
        nothing,
        |c| {
            let none = Data::Null;
            c.draw_elements_instanced_base_vertex(GL_POINTS, 1, GL_FLOAT, none, 1, 0);
        },
        ENUM,
        "type = GL_FLOAT",
    ),
    (
        nothing,
        |c| {
            let none = Pointers(vec![]);
            c.multi_draw_elements_base_vertex(GL_POINTS, &[], GL_UNSIGNED_BYTE, none, -1, &[]);
        },
        VALUE,
        "primcount = -1",
    ),
    // Objects.
    (nothing, |c| c.gen_buffers(-1, &mut []), VALUE, "n = -1"),
    (nothing, |c| c.delete_buffers(-1, &[]), VALUE, "n = -1"),
    (nothing, |c| c.gen_framebuffers(-1, &mut []), VALUE, "n = -1"),
    (nothing, |c| c.delete_framebuffers(-1, &[]), VALUE, "n = -1"),
    (nothing, |c| c.gen_renderbuffers(-1, &mut []), VALUE, "n = -1"),
    (nothing, |c| c.delete_renderbuffers(-1, &[]), VALUE, "n = -1"),
    (nothing, |c| c.prioritize_textures(-1, &[], &[]), VALUE, "n = -1"),
    (nothing, |c| assert!(!c.are_textures_resident(-1, &[], &mut [])), VALUE, "n = -1"),
    (nothing, |c| c.delete_object(99), VALUE, "99"),
    (nothing, |c| c.get_object_parameteriv(99, GL_OBJECT_TYPE_ARB, &mut [0]), VALUE, "99"),
    (nothing, |c| c.get_object_parameterfv(99, GL_OBJECT_TYPE_ARB, &mut [0.0]), VALUE, "99"),
    (nothing, |c| c.get_info_log(99, 1, &mut [], TextOut::Null), VALUE, "99"),
    (nothing, |c| assert_eq!(c.get_handle(GL_LINE), 0), ENUM, "pname = GL_LINE"),
    (
        nothing,
        |c| c.get_object_label(GL_LINE, 1, 1, &mut [], TextOut::Null),
        ENUM,
        "identifier = GL_LINE",
    ),
    (
        nothing,
        |c| c.get_object_ptr_label(std::ptr::without_provenance(5), 1, &mut [], TextOut::Null),
        VALUE,
        "ptr",
    ),
    // Clamping.
    (nothing, |c| c.clamp_color(GL_LINE, GL_TRUE), ENUM, "target = GL_LINE"),
    (nothing, |c| c.clamp_color(GL_CLAMP_READ_COLOR, GL_LINE), ENUM, "GL_FIXED_ONLY"),
    // Blending.
    (
        nothing,
        |c| c.blend_func_separate(GL_LINE, GL_ONE, GL_ONE, GL_ONE),
        ENUM,
        "GL_ZERO, GL_ONE, GL_",
    ),
    (nothing, |c| c.blend_func_separate(GL_ONE, GL_ONE, GL_ONE, GL_LINE), ENUM, "GL_LINE"),
    (nothing, |c| c.blend_equation_separate(GL_FUNC_ADD, GL_ONE), ENUM, "GL_FUNC_ADD"),
    // Compressed images.
    (
        nothing,
        |c| {
            let format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
            c.compressed_tex_sub_image_1d(GL_TEXTURE_1D, 0, 0, 4, format, 8, Data::Null);
        },
        OPERATION,
        "level 0 has no image yet: call glTexImage1D first",
    ),
    (
        nothing,
        |c| {
            let (target, format) = (GL_TEXTURE_3D, GL_COMPRESSED_RGB_S3TC_DXT1_EXT);
            c.compressed_tex_sub_image_3d(target, 0, 0, 0, 0, 4, 4, 1, format, 8, Data::Null);
        },
        OPERATION,
        "level 0 has no image yet: call glTexImage3D first",
    ),
    // Uniforms without a program.
    (nothing, |c| c.uniform_4f(0, 0.0, 0.0, 0.0, 0.0), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_4i(0, 0, 0, 0, 0), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_2ui(0, 0, 0), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_3ui(0, 0, 0, 0), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_4ui(0, 0, 0, 0, 0), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_2fv(0, 1, &[0.0; 2]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_1iv(0, 1, &[0]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_2iv(0, 1, &[0; 2]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_3iv(0, 1, &[0; 3]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_4iv(0, 1, &[0; 4]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_1uiv(0, 1, &[0]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_2uiv(0, 1, &[0; 2]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_3uiv(0, 1, &[0; 3]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_4uiv(0, 1, &[0; 4]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_matrix_4fv(0, 1, false, &[0.0; 16]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_matrix_2x3fv(0, 1, false, &[0.0; 6]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_matrix_2x4fv(0, 1, false, &[0.0; 8]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_matrix_4x2fv(0, 1, false, &[0.0; 8]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_matrix_3x4fv(0, 1, false, &[0.0; 12]), OPERATION, "no linked program"),
    (nothing, |c| c.uniform_matrix_4x3fv(0, 1, false, &[0.0; 12]), OPERATION, "no linked program"),
];

/// Runs the rows.
pub fn run() {
    for (number, (prepare, call, flag, words)) in CASES.iter().enumerate() {
        let mut c = super::context();
        prepare(&mut c);
        super::row(&mut c, format!("sibling forms {number}"), call, *flag, words);
    }
}
