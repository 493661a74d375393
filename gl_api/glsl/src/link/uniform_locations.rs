//! The locations of uniforms: those that `layout(location = n)` gives, and the free ones between them for all others
//! (ARB_explicit_uniform_location).

use crate::hir::Variable;
use crate::limits::MAX_UNIFORM_LOCATIONS;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::Type;
use std::collections::BTreeMap;
use std::ops::Range;

const RULE: &str = "ARB_explicit_uniform_location";

/// The locations of the uniforms of a program.
pub struct UniformLocations<'a> {
    /// The first location of each uniform with an explicit one.
    explicit: BTreeMap<&'a str, u32>,
    /// The explicit locations, in ascending order, none overlapping another.
    ranges: Vec<Range<u32>>,
    /// All free locations are from here on.
    next: u32,
}

impl<'a> UniformLocations<'a> {
    /// The explicit locations among all declarations, of active uniforms and others: they must not overlap.
    pub fn of(declarations: &[&'a Variable], log: &mut Log) -> Self {
        let mut explicit = BTreeMap::new();
        let mut ranges: Vec<(Range<u32>, &str)> = Vec::new();
        for variable in declarations {
            let Some(location) = variable.interface_qualifiers.location else { continue };
            let name = &*variable.name;
            match explicit.insert(name, location) {
                Some(other) if other != location => {
                    let message =
                        format!("uniform `{name}` has the locations {other} and {location}");
                    log.push(Diagnostic::link_error(message).rule(RULE));
                    continue;
                }
                Some(_) => continue,
                None => {}
            }
            let end = location.saturating_add(locations_of(&variable.ty));
            if end > MAX_UNIFORM_LOCATIONS {
                let message = format!(
                    "uniform `{name}` has the locations {location} to {}: they end at {}",
                    end - 1,
                    MAX_UNIFORM_LOCATIONS - 1
                );
                log.push(Diagnostic::link_error(message).rule(RULE));
                continue;
            }
            ranges.push((location..end, name));
        }
        ranges.sort_by_key(|(range, _)| range.start);
        for pair in ranges.windows(2) {
            let [(a, first), (b, second)] = pair else { continue };
            if b.start < a.end {
                let message =
                    format!("uniforms `{first}` and `{second}` both have location {}", b.start);
                log.push(Diagnostic::link_error(message).rule(RULE));
            }
        }
        let ranges = ranges.into_iter().map(|(range, _)| range).collect();
        Self { explicit, ranges, next: 0 }
    }

    /// The first location of a uniform whose declaration has one.
    pub fn explicit(&self, name: &str) -> Option<u32> {
        self.explicit.get(name).copied()
    }

    /// The first of `count` free locations in a row, which are taken.
    pub fn free(&mut self, count: u32) -> u32 {
        for range in &self.ranges {
            let overlaps = range.start < self.next.saturating_add(count) && self.next < range.end;
            if overlaps {
                self.next = range.end;
            }
        }
        let found = self.next;
        self.next = self.next.saturating_add(count);
        found
    }

    /// Fails if explicit locations left too few for the others.
    pub fn check_end(&self, log: &mut Log) {
        if self.next > MAX_UNIFORM_LOCATIONS {
            let message = format!("the uniforms take more than {MAX_UNIFORM_LOCATIONS} locations");
            log.push(Diagnostic::link_error(message).rule(RULE));
        }
    }

    /// The explicit locations.
    pub fn into_ranges(self) -> Vec<Range<u32>> {
        self.ranges
    }
}

/// How many locations a uniform takes: one for each element of each leaf.
fn locations_of(ty: &Type) -> u32 {
    match ty {
        Type::Array(element, len) => locations_of(element).saturating_mul(len.unwrap_or(1)),
        Type::Struct(structure) => structure
            .fields
            .iter()
            .map(|(_, field)| locations_of(field))
            .fold(0, u32::saturating_add),
        Type::Void | Type::Vector(..) | Type::Matrix(..) | Type::Sampler(_) | Type::Error => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_locations_leave_the_explicit_ones_out() {
        let ranges = vec![2..4, 5..6, 6..9];
        let mut locations = UniformLocations { explicit: BTreeMap::new(), ranges, next: 0 };
        assert_eq!([1, 1, 1, 2, 1].map(|count| locations.free(count)), [0, 1, 4, 9, 11]);
    }
}
