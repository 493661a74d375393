//! Which names `glGen…` gives: the smallest that are free, whatever was bound and deleted before.

use super::{context, fine};
use gl_api::*;
use proptest::prelude::*;
use std::collections::BTreeSet;

#[derive(Clone, Debug)]
enum Call {
    Gen(usize),
    Bind(GLuint),
    Delete(GLuint),
}

fn call() -> impl Strategy<Value = Call> {
    prop_oneof![
        (1..5_usize).prop_map(Call::Gen),
        (1..20_u32).prop_map(Call::Bind),
        (1..20_u32).prop_map(Call::Delete),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_smallest_free_names_are_given(calls in proptest::collection::vec(call(), 1..60)) {
        let mut c = context();
        let mut used = BTreeSet::new();
        for call in calls {
            match call {
                Call::Gen(count) => {
                    let mut names = vec![0; count];
                    c.gen_textures(count as GLsizei, &mut names);
                    for name in names {
                        let free = (1..).find(|name| !used.contains(name)).expect("many");
                        prop_assert_eq!(name, free);
                        used.insert(name);
                    }
                }
                Call::Bind(name) => {
                    c.bind_texture(GL_TEXTURE_2D, name);
                    used.insert(name);
                }
                Call::Delete(name) => {
                    c.delete_textures(1, &[name]);
                    used.remove(&name);
                }
            }
        }
        fine(&mut c);
    }
}
