//! `docs/lectures.md`: every program, panel, check and file that it names exists, and no item is left out.

use conformance::chapters::CHAPTERS;
use examples::lectures::{Lecture, PAGE, lectures, wrong};
use examples::programs;
use std::fs;
use std::path::Path;

/// How many items each lecture has.
const ITEMS: [(char, usize); 4] = [('A', 81), ('B', 45), ('C', 27), ('D', 32)];

fn wrong_references(page: &str) -> Vec<String> {
    let checks = CHAPTERS.iter().flat_map(|(_, checks)| checks.iter());
    let checks: Vec<&str> = checks.map(|check| check.name).collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let read = |file: &str| fs::read_to_string(root.join(file)).ok();
    wrong(&lectures(page), &programs::ALL, &checks, read)
}

/// The number of a lecture's items where it is not the one that it should be.
fn wrong_counts(lectures: &[Lecture]) -> Vec<String> {
    let items = |letter| lectures.iter().find(|lecture| lecture.letter == letter);
    ITEMS
        .into_iter()
        .map(|(letter, wanted)| (letter, wanted, items(letter).map_or(0, |l| l.items.len())))
        .filter(|(_, wanted, got)| got != wanted)
        .map(|(letter, wanted, got)| format!("lecture {letter}: {got} items, not {wanted}"))
        .collect()
}

#[test]
fn every_reference_of_the_page_exists() {
    let wrong = wrong_references(PAGE);
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}

#[test]
fn no_item_of_a_lecture_is_left_out() {
    let lectures = lectures(PAGE);
    let wrong = wrong_counts(&lectures);
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
    assert_eq!(lectures.iter().map(|l| l.letter).collect::<String>(), "ABCD");
}

#[test]
fn a_false_reference_is_noticed() {
    let row = |pictures: &str, checks: &str, files: &str| {
        format!("## A: planted\n\n| slide 1 | text | {pictures} | {checks} | {files} | |\n")
    };
    let cases = [
        (row("`gloss_map`", "`lod`", "`README.md#DetGL`"), None),
        (row("`glossy_map`", "", ""), Some("no program \"glossy_map\"")),
        (row("`gloss_map` \"shiny\"", "", ""), Some("gloss_map has no panel \"shiny\"")),
        (row("", "`lods`", ""), Some("no check \"lods\"")),
        (row("", "", "`docs/nowhere.md`"), Some("no file \"docs/nowhere.md\"")),
        (row("", "", "`README.md#MetGL`"), Some("README.md does not have \"MetGL\"")),
        (row("", "", ""), Some("or else says \"not drawn yet\"")),
        (row("not drawn yet", "`lod`", ""), Some("or else says \"not drawn yet\"")),
        (row("not drawn yet", "", ""), None),
        (row("`gloss_map` | too many", "", ""), Some("7 cells in place of 6")),
    ];
    for (page, wanted) in cases {
        let got = wrong_references(&page);
        match wanted {
            None => assert!(got.is_empty(), "{page}: {got:?}"),
            Some(wanted) => assert!(
                matches!(&got[..], [one, ..] if one.starts_with("docs/lectures.md:3: ")
                    && one.contains(wanted)),
                "{page}: {got:?}"
            ),
        }
    }
}

#[test]
fn a_missing_item_is_noticed() {
    let mut lectures = lectures(PAGE);
    lectures[0].items.pop();
    lectures.pop();
    let wanted = ["lecture A: 80 items, not 81", "lecture D: 0 items, not 32"];
    assert_eq!(wrong_counts(&lectures), wanted);
}
