//! The direction of dependencies between crates.

use crate::manifest::Member;
use std::collections::BTreeMap;

/// Compares the crates with the chain that the page prints ([`crate::page::chain`]): a crate may depend only on
/// crates of links before its own. A crate of no link depends on none of the workspace, and none depends on it.
/// Returns a line for each dependency that the chain does not allow, and for each name of the chain that no crate has.
pub fn against_chain(members: &[Member], chain: &[Vec<String>]) -> Vec<String> {
    let links: BTreeMap<&str, usize> = chain
        .iter()
        .enumerate()
        .flat_map(|(link, names)| names.iter().map(move |name| (name.as_str(), link)))
        .collect();
    let link = |name: &str| links.get(name).copied();
    let mut violations = Vec::new();
    for name in links.keys() {
        if !members.iter().any(|member| member.name == *name) {
            violations.push(format!("{name}: the chain of crates has it, the workspace does not"));
        }
    }
    for member in members {
        for dependency in members.iter().map(|other| &other.name) {
            let is_allowed = match (link(&member.name), link(dependency)) {
                (Some(from), Some(to)) => to < from,
                (None, _) | (_, None) => false,
            };
            if member.dependencies.contains(dependency) && !is_allowed {
                violations.push(format!(
                    "{}/Cargo.toml → {dependency}: against the chain of crates",
                    member.folder
                ));
            }
        }
    }
    violations
}
