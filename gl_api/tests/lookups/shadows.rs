//! The comparison of a shadow lookup under each `GL_DEPTH_TEXTURE_MODE`, in both stages: functions of
//! GLSL 1.20 give a vector that the mode places, those of 1.30 the comparison itself.

use super::*;

/// A depth texture of one texel, one half, compared by `GL_LEQUAL`.
fn depth_texture(mode: GLenum) {
    let target = GL_TEXTURE_2D;
    glBindTexture(target, 7);
    let (format, ty) = (GL_DEPTH_COMPONENT, GL_FLOAT);
    glTexImage2D(target, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, format, ty, &[0.5_f32]);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, mode);
}

/// What a shader with this lookup draws.
fn drawn_with(stage: Stage, version: &str, lookup: &str) -> [u8; 4] {
    let sampler = "uniform sampler2DShadow s;";
    let (vertex, fragment) = match stage {
        Stage::Vertex => (
            format!(
                "#version {version}\n{sampler} varying vec4 v;
                void main() {{ v = vec4({lookup}); gl_Position = gl_Vertex; }}"
            ),
            "varying vec4 v; void main() { gl_FragColor = v; }".to_owned(),
        ),
        Stage::Fragment => (
            "void main() { gl_Position = gl_Vertex; }".to_owned(),
            format!(
                "#version {version}\n{sampler} void main() {{ gl_FragColor = vec4({lookup}); }}"
            ),
        ),
    };
    drawn(program(&vertex, &fragment).expect("it links"))
}

#[test]
fn the_mode_places_the_results_of_old_functions_alone() {
    let _current = context();
    const ON: u8 = 255;
    for (mode, placed) in
        [(GL_LUMINANCE, [ON, ON, ON, ON]), (GL_INTENSITY, [ON; 4]), (GL_ALPHA, [0, 0, 0, ON])]
    {
        depth_texture(mode);
        for stage in [Stage::Vertex, Stage::Fragment] {
            let of = |version: &str, lookup: &str| drawn_with(stage, version, lookup);
            let what = (enum_name(mode), stage);
            let old = |depth: &str| format!("shadow2DLod(s, vec3(0.5, 0.5, {depth}), 0.0)");
            if stage == Stage::Vertex {
                assert_eq!(of("120", &old("0.25")), placed, "{what:?}");
            }
            let new = |depth: &str| format!("textureLod(s, vec3(0.5, 0.5, {depth}), 0.0)");
            assert_eq!(of("130", &new("0.25")), [ON; 4], "{what:?}");
            assert_eq!(of("130", &new("0.75")), [0; 4], "{what:?}");
        }
        let old = "shadow2D(s, vec3(0.5, 0.5, 0.25))";
        assert_eq!(drawn_with(Stage::Fragment, "120", old), placed, "{}", enum_name(mode));
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}
