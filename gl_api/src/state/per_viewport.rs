//! State of each viewport (ARB_viewport_array).

use rasterizer::driver::MAX_VIEWPORTS;

/// The viewports from number 1 on.
const MORE: usize = MAX_VIEWPORTS - 1;

/// A value of each viewport. Most programs know of number 0 alone.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PerViewport<T> {
    /// That of number 0, which commands without a number are about.
    pub first: T,
    /// Those from number 1 on; `None` while all are that of number 0.
    more: Option<Box<[T; MORE]>>,
}

impl<T: Copy + PartialEq> PerViewport<T> {
    pub fn new(value: T) -> Self {
        Self { first: value, more: None }
    }

    /// Changes all.
    pub fn change_all(&mut self, change: impl Fn(&mut T)) {
        change(&mut self.first);
        if let Some(more) = &mut self.more {
            more.iter_mut().for_each(change);
        }
    }

    /// Changes that of a viewport, which exists.
    pub fn change(&mut self, viewport: usize, change: impl Fn(&mut T)) {
        let first = self.first;
        let more = self.more.get_or_insert_with(|| Box::new([first; MORE]));
        match viewport.checked_sub(1) {
            None => change(&mut self.first),
            Some(at) => change(&mut more[at]),
        }
        if more.iter().all(|other| *other == self.first) {
            self.more = None;
        }
    }

    /// That of a viewport, which exists.
    pub fn get(&self, viewport: usize) -> T {
        match (&self.more, viewport.checked_sub(1)) {
            (Some(more), Some(at)) => more[at],
            (None, _) | (_, None) => self.first,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_changes_alone_and_all_together() {
        let mut values = PerViewport::new([1, 1]);
        values.change(3, |value| value[0] = 7);
        assert_eq!([0, 1, 3, 15].map(|at| values.get(at)), [[1, 1], [1, 1], [7, 1], [1, 1]]);
        values.change(0, |value| value[0] = 5);
        assert_eq!([0, 1, 3].map(|at| values.get(at)), [[5, 1], [1, 1], [7, 1]]);
        values.change_all(|value| value[1] = 2);
        assert_eq!([0, 1, 3].map(|at| values.get(at)), [[5, 2], [1, 2], [7, 2]]);
        values.change_all(|value| *value = [0, 0]);
        values.change(2, |value| *value = [0, 0]);
        assert_eq!(values, PerViewport::new([0, 0]));
    }
}
