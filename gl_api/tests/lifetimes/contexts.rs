//! What one context deletes stays bound in others of its group.

use super::kinds::KINDS;
use super::{context, fine, sharing};

/// And its name is free for another object at once, there too.
#[test]
fn another_context_goes_on_with_what_was_deleted() {
    for kind in KINDS {
        let what = kind.name;
        let mut a = context();
        let mut b = sharing(&mut a);
        let name = (kind.new)(&mut a);
        (kind.fill)(&mut b, name, 7);
        assert_eq!((kind.number)(&mut b), 7, "{what}");
        (kind.delete)(&mut a, name);
        fine(&mut a);
        assert!(!(kind.exists)(&mut a, name) && !(kind.exists)(&mut b, name), "{what}");
        assert_eq!(((kind.number)(&mut b), (kind.bound)(&mut b)), (7, name), "{what}");
        // The name is free, and what has it is another object.
        assert_eq!((kind.new)(&mut a), name, "{what}");
        (kind.fill)(&mut a, name, 9);
        assert_eq!(((kind.number)(&mut a), (kind.number)(&mut b)), (9, 7), "{what}");
        (kind.delete)(&mut a, name);
        assert_eq!(((kind.number)(&mut b), (kind.bound)(&mut b)), (7, name), "{what}");
        // The context that deletes has nothing bound any more.
        assert_eq!((kind.bound)(&mut a), 0, "{what}");
        // To bind the name again is to bind what has it now.
        assert_eq!((kind.new)(&mut b), name, "{what}");
        (kind.fill)(&mut b, name, 11);
        assert_eq!((kind.number)(&mut b), 11, "{what}");
        fine(&mut b);
    }
}

#[test]
fn it_outlives_the_context_that_deleted_it() {
    for kind in KINDS {
        let mut a = context();
        let mut b = sharing(&mut a);
        let mut other = sharing(&mut a);
        let name = (kind.new)(&mut a);
        (kind.fill)(&mut b, name, 7);
        (kind.delete)(&mut a, name);
        drop(a);
        assert_eq!((kind.number)(&mut b), 7, "{}", kind.name);
        // A context that had nothing to do with it does not take it along, either.
        other.flush();
        drop(other);
        b.flush();
        assert_eq!((kind.number)(&mut b), 7, "{}", kind.name);
    }
}

/// In the context that deletes, its binding is undone.
#[test]
fn the_context_that_deletes_lets_go() {
    for kind in KINDS {
        let mut a = context();
        let mut b = sharing(&mut a);
        let name = (kind.new)(&mut a);
        (kind.fill)(&mut a, name, 7);
        (kind.delete)(&mut a, name);
        assert_eq!((kind.bound)(&mut a), 0, "{}", kind.name);
        assert!(!(kind.exists)(&mut b, name), "{}", kind.name);
        fine(&mut a);
    }
}
