//! Recursive calls.

use crate::hir::Function;
use crate::text::source::Span;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The state of a function in the depth-first search.
#[derive(Clone, Copy, PartialEq, Eq)]
enum VisitState {
    New,
    Open,
    Done,
}

/// The first function found that calls itself, directly or through others, and the call. Prototypes
/// stand for their definition.
pub fn recursive_call(functions: &[Function]) -> Option<(Arc<str>, Span)> {
    let mut bodies: BTreeMap<String, usize> = BTreeMap::new();
    for (index, function) in functions.iter().enumerate() {
        if function.body.is_some() {
            bodies.insert(function.signature(), index);
        }
    }
    let target = |call: u32| bodies.get(&functions[call as usize].signature()).copied();
    let mut states = vec![VisitState::New; functions.len()];
    for start in 0..functions.len() {
        if states[start] != VisitState::New {
            continue;
        }
        // Depth-first search with an explicit stack: function, and how many of its calls were
        // followed.
        let mut path = vec![(start, 0)];
        states[start] = VisitState::Open;
        while let Some((function, followed)) = path.last_mut() {
            let function = *function;
            let Some(&(call, span)) = functions[function].calls.get(*followed) else {
                states[function] = VisitState::Done;
                path.pop();
                continue;
            };
            *followed += 1;
            let Some(next) = target(call) else { continue };
            match states[next] {
                VisitState::Open => return Some((functions[next].name.clone(), span)),
                VisitState::New => {
                    states[next] = VisitState::Open;
                    path.push((next, 0));
                }
                VisitState::Done => {}
            }
        }
    }
    None
}
