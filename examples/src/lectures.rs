//! `docs/lectures.md`: what the lectures contain, item by item, and which programs and checks have it.

use crate::window::Program;

/// The text of the page.
pub const PAGE: &str = include_str!("../../docs/lectures.md");

/// What an item without a picture, check or file says.
pub const PENDING: &str = "not drawn yet";

/// A lecture and its items, in its order.
#[derive(Clone, Debug)]
pub struct Lecture {
    /// `A` to `D`.
    pub letter: char,
    /// The title.
    pub title: String,
    /// The items.
    pub items: Vec<Item>,
}

/// A row of the page.
#[derive(Clone, Debug)]
pub struct Item {
    /// The line of the page, from 1.
    pub line: usize,
    /// The slide or section.
    pub place: String,
    /// What it says.
    pub says: String,
    /// The programs that draw it.
    pub pictures: Vec<Shown>,
    /// The checks of `conformance` that compute it.
    pub checks: Vec<String>,
    /// Files that have it, from the root of the project; `FILE#WORD`: the word is in the file.
    pub files: Vec<String>,
    /// Whether it says [`PENDING`].
    pub pending: bool,
    /// How many cells its row has.
    cells: usize,
}

/// A program, and the captions of its panels that are meant; none: the whole picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The name of the program.
    pub program: String,
    /// Captions.
    pub panels: Vec<String>,
}

/// Cells of a row: place, what it says, pictures, checks, code, printed slip.
const CELLS: usize = 6;

/// The lectures of a page: a heading `## A: title` each, and the rows of the tables under it.
pub fn lectures(page: &str) -> Vec<Lecture> {
    let mut lectures: Vec<Lecture> = Vec::new();
    let mut is_lecture = false;
    for (line, text) in (1..).zip(page.lines()) {
        if let Some(heading) = text.strip_prefix("## ") {
            let lecture = heading.split_once(": ").filter(|(letter, _)| letter.len() == 1);
            is_lecture = lecture.is_some();
            lectures.extend(lecture.map(|(letter, title)| Lecture {
                letter: letter.chars().next().unwrap_or('?'),
                title: title.to_owned(),
                items: Vec::new(),
            }));
        } else if let (true, Some(lecture), Some(item)) =
            (is_lecture, lectures.last_mut(), item(line, text))
        {
            lecture.items.push(item);
        }
    }
    lectures
}

/// The item of a line of the page; the heading of a table and the line under it are none.
fn item(line: usize, text: &str) -> Option<Item> {
    let row = text.strip_prefix("| ")?.trim_end().strip_suffix('|')?;
    let cells: Vec<&str> = row.split('|').map(str::trim).collect();
    let cell = |at: usize| cells.get(at).copied().unwrap_or_default();
    if cell(0) == "section or slide" || cell(0).starts_with("---") {
        return None;
    }
    Some(Item {
        line,
        place: cell(0).to_owned(),
        says: cell(1).to_owned(),
        pictures: pictures(cell(2)),
        checks: between(cell(3), '`').map(str::to_owned).collect(),
        files: between(cell(4), '`').map(str::to_owned).collect(),
        pending: cell(2) == PENDING,
        cells: cells.len(),
    })
}

/// The programs of a cell such as `` `gloss_map` "gloss", "sum"; `skins` ``.
fn pictures(cell: &str) -> Vec<Shown> {
    let parts: Vec<&str> = cell.split('`').collect();
    let named = parts.chunks(2).filter_map(|pair| Some((*pair.get(1)?, pair)));
    let after = parts.iter().skip(2).step_by(2);
    named
        .zip(after)
        .map(|((program, _), after)| Shown {
            program: program.to_owned(),
            panels: between(after, '"').map(str::to_owned).collect(),
        })
        .collect()
}

/// What stands between pairs of a mark.
fn between(text: &str, mark: char) -> impl Iterator<Item = &str> {
    text.split(mark).skip(1).step_by(2)
}

/// What is wrong with the references of lectures, each with its line: `checks` are the names of checks, `read`
/// gives the text of a file of the project.
pub fn wrong(
    lectures: &[Lecture],
    programs: &[Program],
    checks: &[&str],
    read: impl Fn(&str) -> Option<String>,
) -> Vec<String> {
    let mut wrong = Vec::new();
    for item in lectures.iter().flat_map(|lecture| &lecture.items) {
        let mut say = |what: String| wrong.push(format!("docs/lectures.md:{}: {what}", item.line));
        if item.cells != CELLS {
            say(format!("{} cells in place of {CELLS}", item.cells));
        }
        let shown = item.pictures.len() + item.checks.len() + item.files.len();
        if item.pending == (shown > 0) {
            say(format!("has a picture, a check or a file, or else says {PENDING:?}"));
        }
        for Shown { program: name, panels } in &item.pictures {
            match programs.iter().find(|program| program.name == name) {
                None => say(format!("no program {name:?}")),
                Some(program) => panels
                    .iter()
                    .filter(|panel| !program.panels.contains(&panel.as_str()))
                    .for_each(|panel| say(format!("{name} has no panel {panel:?}"))),
            }
        }
        for check in item.checks.iter().filter(|check| !checks.contains(&check.as_str())) {
            say(format!("no check {check:?}"));
        }
        for file in &item.files {
            let (path, word) = file.split_once('#').unwrap_or((file, ""));
            match read(path) {
                None => say(format!("no file {path:?}")),
                Some(text) if !text.contains(word) => say(format!("{path} does not have {word:?}")),
                Some(_) => {}
            }
        }
    }
    wrong
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_name_programs_and_their_panels() {
        let shown = |program: &str, panels: &[&str]| Shown {
            program: program.to_owned(),
            panels: panels.iter().map(|panel| (*panel).to_owned()).collect(),
        };
        let got = pictures("`gloss_map` \"gloss\", \"sum\"; `skins`");
        assert_eq!(got, [shown("gloss_map", &["gloss", "sum"]), shown("skins", &[])]);
        assert_eq!(pictures("none"), []);
    }
}
