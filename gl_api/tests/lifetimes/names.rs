//! Which names `glGen…` gives: the smallest that are free, whatever was bound and deleted before, and how
//! soon.

use super::{context, cpu_time::CpuTime, fine};
use gl_api::*;
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::time::Duration;

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

/// With 200,000 names, to walk over all of them for each would take minutes.
#[test]
fn a_name_costs_the_same_however_many_there_are() {
    const MANY: usize = 200_000;
    let mut c = context();
    let mut names = vec![0; MANY];
    c.gen_buffers(MANY as GLsizei, &mut names);
    let start = CpuTime::begin();
    for round in 0..10_000 {
        c.delete_buffers(1, &[1]);
        let mut two = [0; 2];
        c.gen_buffers(2, &mut two);
        assert_eq!(two, [1, MANY as GLuint + 1 + round]);
    }
    // In either order, and one by one.
    names.reverse();
    for name in &names {
        c.delete_buffers(1, &[*name]);
    }
    for want in 1..=MANY as GLuint {
        let mut one = [0];
        c.gen_buffers(1, &mut one);
        assert_eq!(one, [want]);
    }
    let took = start.elapsed();
    assert!(took < Duration::from_secs(30), "{took:?}");
    fine(&mut c);
}
