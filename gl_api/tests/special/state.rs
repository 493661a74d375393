//! Every row of the tables of GL 2.1, section 6.2: what `glGet` answers at first, in each type.

use super::state_table::{As, LEAST, STATE, get};
use super::{context, fine};
use gl_api::*;

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
                // GL 2.1, table 4.9.
                As::Fraction => (((u32::MAX as f64) * value - 1.0) / 2.0).round_ties_even() as i32,
            };
            let near = i64::from(ints[at]) - i64::from(int);
            assert!(near.abs() <= 1, "{label}: {} is not {int}", ints[at]);
            if conversion == As::Number {
                assert_eq!(longs[at], value.round() as i64, "{label}");
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
    assert!(c.get_string(GL_VERSION).starts_with("3.1"));
    assert_eq!(get(&mut c, GL_MAJOR_VERSION), Some(vec![3.0]));
    assert_eq!(get(&mut c, GL_MINOR_VERSION), Some(vec![1.0]));
    for name in [GL_VENDOR, GL_RENDERER, GL_SHADING_LANGUAGE_VERSION] {
        assert!(!c.get_string(name).is_empty());
    }
    let count = get(&mut c, GL_NUM_EXTENSIONS).expect("a number")[0] as u32;
    let listed: Vec<&str> = (0..count).map(|index| c.get_stringi(GL_EXTENSIONS, index)).collect();
    assert_eq!(listed.join(" "), c.get_string(GL_EXTENSIONS));
    fine(&mut c);
}
