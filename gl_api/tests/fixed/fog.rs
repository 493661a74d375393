//! Fog (section 3.10) and colour sum (section 3.9).

use crate::shading::use_program;
use crate::{BYTE, Random, assert_close, color, context, times, transform, triangle};
use gl_api::*;

#[test]
fn fog_follows_its_three_formulas() {
    let mut c = context();
    c.enable(GL_FOG);
    c.shade_model(GL_FLAT);
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let modelview = random.modelview();
        transform(&mut c, modelview);
        let z = random.between(-1.0, 1.0);
        let mode = random.of(&[GL_LINEAR, GL_EXP, GL_EXP2]);
        let density = random.between(0.0, 0.5);
        let (start, end) = (random.between(-2.0, 4.0), random.between(4.5, 12.0));
        let (fog, front) = (random.color(), random.color());
        c.fogi(GL_FOG_MODE, mode as GLint);
        c.fogf(GL_FOG_DENSITY, density as f32);
        c.fogf(GL_FOG_START, start as f32);
        c.fogf(GL_FOG_END, end as f32);
        c.fogfv(GL_FOG_COLOR, &fog);
        let by_coordinate = random.chance(50);
        let source = if by_coordinate { GL_FOG_COORD } else { GL_FRAGMENT_DEPTH };
        c.fogi(GL_FOG_COORD_SRC, source as GLint);
        let coordinate = random.between(-1.0, 10.0);
        c.fog_coordd(coordinate);
        c.color_4fv(&front);
        triangle(&mut c, z, true);
        let eye = times(&modelview, [0.0, 0.0, z, 1.0]);
        let distance = if by_coordinate { coordinate } else { eye[2].abs() };
        let clear = match mode {
            GL_LINEAR => (end - distance) / (end - start),
            GL_EXP => (-density * distance).exp(),
            _ => (-(density * distance).powi(2)).exp(),
        };
        let clear = clear.clamp(0.0, 1.0);
        let mix = |i: usize| f64::from(front[i]) * clear + f64::from(fog[i]) * (1.0 - clear);
        let expected = [mix(0), mix(1), mix(2), front[3].into()];
        assert_close(color(&mut c), expected, BYTE, &(seed, mode, distance, clear));
    }
}

#[test]
fn fog_without_an_extent_is_a_step() {
    let mut c = context();
    c.enable(GL_FOG);
    c.fogi(GL_FOG_MODE, GL_LINEAR as GLint);
    c.fogf(GL_FOG_START, 0.5);
    c.fogf(GL_FOG_END, 0.5);
    c.fogfv(GL_FOG_COLOR, &[0.0, 1.0, 0.0, 1.0]);
    for (z, seen) in [(0.0, [1.0; 4]), (-0.25, [1.0; 4]), (-0.75, [0.0, 1.0, 0.0, 1.0])] {
        triangle(&mut c, z, true);
        assert_eq!(color(&mut c), seen, "at depth {z}");
    }
}

#[test]
fn the_secondary_colour_is_added_where_it_is_asked_for() {
    let mut c = context();
    c.color_4f(0.5, 0.25, 1.0, 0.5);
    c.secondary_color_3f(0.25, 0.25, 0.25);
    triangle(&mut c, 0.0, true);
    assert_close(color(&mut c), [0.5, 0.25, 1.0, 0.5], BYTE, &"off");
    c.enable(GL_COLOR_SUM);
    triangle(&mut c, 0.0, true);
    assert_close(color(&mut c), [0.75, 0.5, 1.0, 0.5], BYTE, &"on");
    // Lighting decides for itself.
    c.enable(GL_LIGHTING);
    triangle(&mut c, 0.0, true);
    assert_close(color(&mut c), [0.04, 0.04, 0.04, 1.0], BYTE, &"lit");
}

#[test]
fn fog_comes_after_colour_sum() {
    let mut c = context();
    c.color_4f(1.0, 0.0, 0.0, 1.0);
    c.secondary_color_3f(0.0, 1.0, 0.0);
    c.enable(GL_COLOR_SUM);
    c.enable(GL_FOG);
    c.fogi(GL_FOG_COORD_SRC, GL_FOG_COORD as GLint);
    c.fogi(GL_FOG_MODE, GL_LINEAR as GLint);
    c.fog_coordf(0.5);
    c.fogfv(GL_FOG_COLOR, &[0.0, 0.0, 1.0, 1.0]);
    triangle(&mut c, 0.0, true);
    assert_close(color(&mut c), [0.5, 0.5, 0.5, 1.0], BYTE, &"half in fog");
}

#[test]
fn a_program_writes_the_fog_coordinate_for_the_fixed_fragment_stage() {
    let mut c = context();
    let source = "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; gl_FogFragCoord = 0.25; }";
    use_program(&mut c, source, "");
    c.enable(GL_FOG);
    c.fogi(GL_FOG_MODE, GL_LINEAR as GLint);
    c.fogfv(GL_FOG_COLOR, &[0.0; 4]);
    triangle(&mut c, 0.0, true);
    assert_close(color(&mut c), [0.75, 0.75, 0.75, 1.0], BYTE, &"a quarter in fog");
}
