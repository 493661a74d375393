//! Prints the structure of a crate: layers, circles, and the references between layers.

use architecture::graph::layer_of;
use architecture::{Graph, Sources, check, page};
use clap::Parser;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::PathBuf;

/// The structure of a crate, as its sources have it.
#[derive(Parser)]
struct Options {
    /// The crate's folder, as `texunit` or `gl_api/glsl`.
    folder: PathBuf,
    /// Lists the references from each layer to this one, or to a file of it.
    #[arg(long, value_name = "LAYER")]
    to: Option<String>,
    /// Lists the references from this layer, or from a file of it.
    #[arg(long, value_name = "LAYER")]
    from: Option<String>,
    /// Checks against the tables of this page.
    #[arg(long, value_name = "FILE", default_value = "ARCHITECTURE.md")]
    page: PathBuf,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let name =
        options.folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into());
    let graph = Graph::of(&Sources::read(&name, &options.folder)?);
    if options.to.is_some() || options.from.is_some() {
        list(&graph, options.from.as_deref(), options.to.as_deref());
        return Ok(());
    }
    let edges = graph.layer_edges();
    let mut below: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (from, to) in &edges {
        below.entry(from).or_default().push(to);
    }
    for (layer, below) in below {
        println!("{layer}: {}", below.join(" "));
    }
    for circle in Graph::circles(&edges) {
        println!("circle of {} layers: {}", circle.len(), circle.join(" "));
    }
    for circle in graph.file_circles() {
        println!("circle of {} files: {}", circle.len(), circle.join(" "));
    }
    if let Some(order) = page::orders(&fs::read_to_string(&options.page)?).get(&name) {
        for violation in check(&graph, order) {
            println!("{violation}");
        }
    }
    Ok(())
}

/// The references between files of `from` and `to`, each a layer, a file, or everything.
fn list(graph: &Graph, from: Option<&str>, to: Option<&str>) {
    let fits = |file: &str, wanted: Option<&str>| {
        wanted.is_none_or(|wanted| file.starts_with(wanted) || layer_of(file) == wanted)
    };
    for ((a, b), references) in &graph.edges {
        let (a, b) = (&graph.files[*a], &graph.files[*b]);
        if layer_of(a) != layer_of(b) && fits(a, from) && fits(b, to) {
            let names: BTreeSet<_> =
                references.iter().map(|reference| reference.name.as_str()).collect();
            let line = references.first().map_or(0, |reference| reference.line);
            println!("{a}:{line} → {b}: {}", names.into_iter().collect::<Vec<_>>().join(", "));
        }
    }
}
