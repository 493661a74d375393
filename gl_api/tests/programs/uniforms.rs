//! Uniforms: how they are listed, found, set, read back and reset.

use super::*;

#[test]
fn a_link_resets_uniforms_to_their_initial_values() {
    let mut c = context();
    let source = "#version 120
uniform vec2 start = vec2(3.0, 4.0); uniform float plain; uniform sampler2D map;
void main() { gl_FragColor = texture2D(map, start) * plain; }";
    let program = linked(&mut c, &[PASS], &[source]);
    c.use_program(program);
    let [start, plain, map] =
        ["start", "plain", "map"].map(|name| c.get_uniform_location(program, name));
    let read = |c: &mut Context| {
        let (mut two, mut one, mut unit) = ([0.0; 2], [0.0], [-1]);
        c.get_uniformfv(program, start, &mut two);
        c.get_uniformfv(program, plain, &mut one);
        c.get_uniformiv(program, map, &mut unit);
        (two, one[0], unit[0])
    };
    assert_eq!(read(&mut c), ([3.0, 4.0], 0.0, 0));
    c.uniform_2f(start, 1.0, 2.0);
    c.uniform_1f(plain, 5.0);
    c.uniform_1i(map, 7);
    c.use_program(0);
    assert_eq!(read(&mut c), ([1.0, 2.0], 5.0, 7), "values belong to the program");
    assert!(links(&mut c, program));
    assert_eq!(read(&mut c), ([3.0, 4.0], 0.0, 0));
    no_error(&mut c);
}

#[test]
fn samplers_of_arrays_of_cubes_have_types_of_their_own() {
    let mut c = context();
    let fragment = "#version 130
#extension GL_ARB_texture_cube_map_array : require
uniform samplerCubeArray f; uniform isamplerCubeArray i; uniform usamplerCubeArray u;
uniform samplerCubeArrayShadow s;
void main() {
    gl_FragColor = texture(f, vec4(1.0)) + vec4(texture(i, vec4(1.0))) + vec4(texture(u, vec4(1.0)))
        + texture(s, vec4(1.0), 0.5);
}";
    let program = linked(&mut c, &["void main() { gl_Position = gl_Vertex; }"], &[fragment]);
    let mut found = uniforms(&mut c, program);
    found.sort();
    let want = [
        ("f", GL_SAMPLER_CUBE_MAP_ARRAY),
        ("i", GL_INT_SAMPLER_CUBE_MAP_ARRAY),
        ("s", GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW),
        ("u", GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY),
    ];
    assert_eq!(found, want.map(|(name, ty)| (name.to_owned(), 1, ty)));
}

#[test]
fn uniforms_are_listed_and_found_in_parts() {
    let mut c = context();
    let source = "#version 120
struct S { float f; vec2 v[2]; }; struct T { S s[2]; mat2x3 m; };
uniform T t[2]; uniform mat4 many[3]; uniform bvec2 b;
void main() {
    gl_FragColor = vec4(t[1].s[1].v[1], t[0].m[0].x, t[0].s[0].f) * many[2] * float(b.x);
}";
    let program = linked(&mut c, &[PASS], &[source]);
    let all = uniforms(&mut c, program);
    for (name, size, ty) in [
        ("t[0].s[0].f", 1, GL_FLOAT),
        ("t[1].s[1].v[0]", 2, GL_FLOAT_VEC2),
        ("t[0].m", 1, GL_FLOAT_MAT2x3),
        ("many[0]", 3, GL_FLOAT_MAT4),
        ("b", 1, GL_BOOL_VEC2),
    ] {
        assert!(all.contains(&(name.to_owned(), size, ty)), "{name}: {all:?}");
        assert!(c.get_uniform_location(program, name) >= 0, "{name}");
    }
    let longest = all.iter().map(|(name, ..)| name.len() + 1).max();
    assert_eq!(Some(asked(&mut c, program, GL_ACTIVE_UNIFORM_MAX_LENGTH) as usize), longest);
    let first = c.get_uniform_location(program, "many");
    assert_eq!(c.get_uniform_location(program, "many[2]"), first + 2);
    assert_eq!(
        c.get_uniform_location(program, "t[1].s[0].v[1]"),
        c.get_uniform_location(program, "t[1].s[0].v") + 1
    );
    for none in ["t", "t[0]", "t[2].m", "many[3]", "many[01]", "many[-1]", "b[0]", "b.x", "", "["] {
        assert_eq!(c.get_uniform_location(program, none), -1, "{none}");
    }
    no_error(&mut c);
}

/// ARB_arrays_of_arrays: what is set is one row, by its name with or without the last `[0]`.
#[test]
fn arrays_of_arrays_are_set_row_by_row() {
    let mut c = context();
    let source = "#version 120
#extension GL_ARB_arrays_of_arrays : require
uniform float[3] a[2]; uniform int i;
void main() { gl_FragColor = vec4(a[1][i], a[i][1], a[0][2], 1.0); }";
    let program = linked(&mut c, &[PASS], &[source]);
    let all = uniforms(&mut c, program);
    for name in ["a[0][0]", "a[1][0]"] {
        assert!(all.contains(&(name.to_owned(), 3, GL_FLOAT)), "{name}: {all:?}");
    }
    assert_eq!(all.len(), 3, "{all:?}");
    let at = |c: &mut Context, name| c.get_uniform_location(program, name);
    let row = at(&mut c, "a[1]");
    assert_eq!(at(&mut c, "a[1][0]"), row);
    assert_eq!(at(&mut c, "a[1][2]"), row + 2);
    for none in ["a", "a[2]", "a[2][0]", "a[1][3]", "a[1][0][0]", "a[]", "a[01][0]"] {
        assert_eq!(at(&mut c, none), -1, "{none}");
    }
    c.use_program(program);
    c.uniform_1fv(row + 1, 2, &[5.0, 6.0]);
    let first = at(&mut c, "a[0][2]");
    c.uniform_1f(first, 7.0);
    let mut value = [0.0; 1];
    for (name, expected) in [("a[1][0]", 0.0), ("a[1][1]", 5.0), ("a[1][2]", 6.0), ("a[0][2]", 7.0)]
    {
        let location = at(&mut c, name);
        c.get_uniformfv(program, location, &mut value);
        assert_eq!(value, [expected], "{name}");
    }
    no_error(&mut c);
}

#[test]
fn built_in_variables_are_listed_without_locations() {
    let mut c = context();
    let vertex = "attribute vec3 own; void main() {
        gl_Position = gl_ModelViewMatrix * gl_Vertex + vec4(own, 0.0) + gl_MultiTexCoord1;
        gl_FrontColor = gl_FrontMaterial.diffuse; }";
    let program = linked(&mut c, &[vertex], &[]);
    let names: Vec<String> = uniforms(&mut c, program).into_iter().map(|u| u.0).collect();
    for name in ["gl_ModelViewMatrix", "gl_FrontMaterial.diffuse"] {
        assert!(names.iter().any(|known| known == name), "{name}: {names:?}");
        assert_eq!(c.get_uniform_location(program, name), -1, "{name}");
    }
    let all = attributes(&mut c, program);
    for (name, ty) in [("own", GL_FLOAT_VEC3), ("gl_Vertex", GL_FLOAT_VEC4)] {
        assert!(all.contains(&(name.to_owned(), ty)), "{name}: {all:?}");
    }
    assert_eq!(all.len(), 3);
    assert_eq!(c.get_attrib_location(program, "gl_Vertex"), -1);
    assert_eq!(c.get_attrib_location(program, "own"), 1, "0 is gl_Vertex");
    no_error(&mut c);
}

#[test]
fn values_convert_as_they_are_read() {
    let mut c = context();
    let program = everything(&mut c);
    let at = |c: &mut Context, name| c.get_uniform_location(program, name);
    let [f, i, u, b, m] = ["f", "i", "u", "b", "m"].map(|name| at(&mut c, name));
    c.uniform_1f(f, 2.75);
    c.uniform_1i(i, -3);
    c.uniform_1ui(u, u32::MAX);
    c.uniform_1f(b, -0.5);
    let matrix: Vec<f32> = (0..9_u8).map(f32::from).collect();
    c.uniform_matrix_3fv(m, 1, true, &matrix);
    for (location, float, int, uint) in
        [(f, 2.75, 3, 3), (i, -3.0, -3, (-3_i32) as u32), (u, 4_294_967_295.0, -1, u32::MAX)]
    {
        let (mut floats, mut ints, mut uints) = ([0.0], [0], [0]);
        c.get_uniformfv(program, location, &mut floats);
        c.get_uniformiv(program, location, &mut ints);
        c.get_uniformuiv(program, location, &mut uints);
        assert_eq!((floats[0], ints[0], uints[0]), (float, int, uint), "{location}");
    }
    let (mut truth, mut nine) = ([0], [0.0; 9]);
    c.get_uniformiv(program, b, &mut truth);
    c.get_uniformfv(program, m, &mut nine);
    assert_eq!((truth, nine), ([1], [0.0, 3.0, 6.0, 1.0, 4.0, 7.0, 2.0, 5.0, 8.0]));
    // Past an array's end nothing is written, and location -1 is no one's.
    let last = at(&mut c, "fa[2]");
    c.uniform_1fv(last, 2, &[8.0, 9.0]);
    c.uniform_1f(-1, 1.0);
    c.uniform_3fv(-1, 5, &[0.0; 15]);
    let mut value = [0.0];
    c.get_uniformfv(program, last, &mut value);
    assert_eq!(value, [8.0]);
    no_error(&mut c);
}
