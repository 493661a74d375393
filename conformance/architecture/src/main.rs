//! Prints the structure of a crate: layers, circles, and the references between layers.

use architecture::{Graph, check, manifest, page, read_crate};
use clap::Parser;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::Path;

/// The structure of a crate, as its sources have it. To be run in the workspace's root.
#[derive(Parser)]
struct Options {
    /// The crate's folder, as `texunit` or `gl_api/glsl`.
    folder: String,
    /// Lists the references from each layer to this one, or to a file of it.
    #[arg(long, value_name = "LAYER")]
    to: Option<String>,
    /// Lists the references from this layer, or from a file of it.
    #[arg(long, value_name = "LAYER")]
    from: Option<String>,
    /// Checks against the tables of this page.
    #[arg(long, value_name = "FILE", default_value = "ARCHITECTURE.md")]
    page: String,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let root = Path::new(".");
    let folder = options.folder.trim_end_matches('/');
    let graph = Graph::of(&read_crate(root, folder)?);
    if options.to.is_some() || options.from.is_some() {
        list(&graph, options.from.as_deref(), options.to.as_deref());
        return Ok(());
    }
    summarize(&graph);
    let name = manifest::member(root, folder)?.name;
    if let Some(order) = page::orders(&fs::read_to_string(&options.page)?).get(&name) {
        for violation in check(&graph, order) {
            println!("{violation}");
        }
    }
    Ok(())
}

/// The layers, with what each refers to, and the circles.
fn summarize(graph: &Graph) {
    let mut references: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (from, to) in graph.layer_edges() {
        references.entry(from).or_default().push(to);
    }
    for (layer, others) in references {
        println!("{layer}: {}", others.join(" "));
    }
    for circle in graph.layer_circles() {
        println!("circle of {} layers: {}", circle.len(), circle.join(" "));
    }
    for circle in graph.file_circles() {
        println!("circle of {} files: {}", circle.len(), circle.join(" "));
    }
}

/// The references from `from` to `to`, each a layer, a file, or everything; those inside a layer where one is a file.
fn list(graph: &Graph, from: Option<&str>, to: Option<&str>) {
    let fits = |file: usize, wanted: Option<&str>| {
        wanted.is_none_or(|wanted| {
            graph.files[file].path.starts_with(wanted) || graph.layer(file) == Some(wanted)
        })
    };
    let names_file = [from, to].iter().flatten().any(|wanted| wanted.contains('/'));
    for ((a, b), references) in &graph.edges {
        let is_listed = names_file || graph.layer(*a) != graph.layer(*b);
        if is_listed && fits(*a, from) && fits(*b, to) {
            let names: BTreeSet<&str> =
                references.iter().map(|reference| reference.name.as_str()).collect();
            let line = references.first().map_or(0, |reference| reference.line);
            let (a, b) = (&graph.files[*a].path, &graph.files[*b].path);
            println!("{a}:{line} → {b}: {}", names.into_iter().collect::<Vec<_>>().join(", "));
        }
    }
}
