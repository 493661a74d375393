//! Every kernel that a picture may take is reached by a check; `DETGL_BLESS=1` writes docs/kernels.md, which says by which.

use conformance::chapters::checks;
use conformance::check::{Effort, Harness, Subject};
use conformance::mutation::Variant;
use rasterizer::kernels::PixelKernel;
use std::fmt::Write;
use texunit::kernels::LookupKernel;
use texunit::lanes::Isa;

/// So many checks of a kernel are named.
const NAMED: usize = 6;

/// A kernel's name, what it is, and the checks that reach it.
type Row = (String, &'static str, Vec<&'static str>);

fn rows() -> [Vec<Row>; 2] {
    let row = |name: String, words| (name, words, Vec::new());
    let mut lookups: Vec<Row> =
        LookupKernel::ALL.iter().map(|of| row(format!("{of:?}"), of.describe())).collect();
    let mut pixels: Vec<Row> =
        PixelKernel::ALL.iter().map(|of| row(format!("{of:?}"), of.describe())).collect();
    let harness =
        Harness { subject: Subject::Driver, effort: Effort::Quick, variant: Variant::CORRECT };
    LookupKernel::take();
    PixelKernel::take();
    for check in checks() {
        check.run(&harness);
        LookupKernel::take().iter().for_each(|of| lookups[*of as usize].2.push(check.name));
        PixelKernel::take().iter().for_each(|of| pixels[*of as usize].2.push(check.name));
    }
    [lookups, pixels]
}

/// The page of what was reached.
fn page(tables: &[Vec<Row>; 2]) -> String {
    let mut page = String::from(
        "# Kernels and the checks that reach them\n\n\
        Made by `DETGL_BLESS=1 cargo test -p conformance --test kernels`, on a processor with AVX2 or AVX-512; the same test \
        fails where a kernel\nis reached by no check. `texunit::kernels` and \
        `rasterizer::kernels` list the kernels; builds with debug\nassertions note each that runs. Of many checks the first \
        are named.\n",
    );
    for (title, rows) in ["Lookups", "Vertices to pixels"].into_iter().zip(tables) {
        let _ = write!(page, "\n## {title}\n\n| kernel | is | checks |\n|---|---|---|\n");
        for (name, words, checks) in rows {
            let mut named: String =
                checks.iter().take(NAMED).map(|check| format!("`{check}`, ")).collect();
            named.truncate(named.len().saturating_sub(2));
            if checks.len() > NAMED {
                let _ = write!(named, " and {} more", checks.len() - NAMED);
            }
            let _ = writeln!(page, "| `{name}` | {words} | {named} |");
        }
    }
    page
}

#[test]
fn every_kernel_is_reached_by_a_check() {
    let is_wide = Isa::from_env().is_ok_and(Isa::is_wide);
    if !cfg!(debug_assertions) || !is_wide {
        // Nothing is noted, or there is one kernel of lookups.
        return;
    }
    let tables = rows();
    let unreached: Vec<&str> = tables
        .iter()
        .flatten()
        .filter(|(.., checks)| checks.is_empty())
        .map(|(name, ..)| name.as_str())
        .collect();
    assert!(unreached.is_empty(), "no check reaches {unreached:?}");
    if std::env::var_os("DETGL_BLESS").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/kernels.md");
        std::fs::write(path, page(&tables)).expect("a page that can be written");
    }
}
