//! The names of state that `glGet` answers: each once, with its availability by the Khronos registry.

#[path = "common/state_table.rs"]
mod state_table;

use gl_api::availability::{Api, Version};
use gl_api::description::{StateAvailability, ValueType, states};
use gl_api::*;
use state_table::{LEAST, STATE, get};

fn context() -> Context {
    let desc = ContextDesc { width: 16, height: 8, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

#[test]
fn each_name_has_one_row() {
    let values: Vec<GLenum> = states().map(|state| state.value).collect();
    assert!(values.is_sorted_by(|a, b| a < b));
}

#[test]
fn the_state_tables_are_answered() {
    let known: Vec<GLenum> = states().map(|state| state.value).collect();
    for name in STATE.iter().chain(LEAST).map(|row| row.0) {
        assert!(known.contains(&name), "{}", enum_name(name));
    }
}

/// Names in the table are answered and others refused, by `glGet` and by `glIsEnabled`.
#[test]
fn the_table_is_all_of_the_state() {
    let mut c = context();
    for name in 0..0x1_0000 {
        let state = states().find(|state| state.value == name);
        assert_eq!(get(&mut c, name).is_some(), state.is_some(), "{}", enum_name(name));
        c.is_enabled(name);
        let is_capability = state.is_some_and(|state| state.ty == ValueType::Capability);
        assert_eq!(c.get_error() == GL_NO_ERROR, is_capability, "{}", enum_name(name));
    }
}

/// All of it is OpenGL 3.3's or a claimed extension's, but for what only OpenGL ES 3.0 has.
#[test]
fn state_is_there_by_version_or_extension() {
    let mut c = context();
    let mut count = [0];
    c.get_integerv(GL_NUM_EXTENSIONS, &mut count);
    let extensions: Vec<&str> =
        (0..count[0] as GLuint).map(|index| c.get_stringi(GL_EXTENSIONS, index)).collect();
    let unclaimed: Vec<&str> = states()
        .filter(|state| {
            let found = state.availability.get();
            let claimed = |extension: &str| extensions.contains(&extension);
            !found.is_in(Api::Compatibility, Version::new(3, 3))
                && !found.extensions_of(Api::Compatibility).any(claimed)
        })
        .map(|state| state.name)
        .collect();
    let of_es = [
        "GL_TEXTURE_BINDING_EXTERNAL_OES",
        "GL_PRIMITIVE_RESTART_FIXED_INDEX",
        "GL_MAX_ELEMENT_INDEX",
        "GL_GPU_DISJOINT_EXT",
    ];
    assert_eq!(unclaimed, of_es);
}

#[test]
fn availability_of_the_registry_and_of_rows() {
    let of = |name: &str| states().find(|state| state.name == name).expect("state").availability;
    let fog = of("GL_FOG");
    assert!(matches!(fog, StateAvailability::Registry(_)));
    assert!(fog.get().is_in(Api::Compatibility, Version::new(1, 1)));
    assert!(!fog.get().is_in(Api::Core, Version::new(3, 2)));
    assert!(fog.get().is_in(Api::Es1, Version::new(1, 0)));
    let texture = of("GL_TEXTURE_2D");
    assert!(matches!(texture, StateAvailability::Stated(_)));
    assert!(!texture.get().is_in(Api::Core, Version::new(3, 2)));
    assert!(!texture.get().is_in(Api::Es2, Version::new(2, 0)));
    assert!(of("GL_DEPTH_TEST").get().is_in(Api::Es2, Version::new(2, 0)));
}
