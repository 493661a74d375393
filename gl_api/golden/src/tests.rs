use super::*;

fn old() -> Picture {
    Picture::rgb(4, 2, &(0..24).collect::<Vec<_>>())
}

fn changed(at: usize, value: u8) -> Picture {
    let mut picture = old();
    picture.bytes[at] = value;
    picture
}

fn blessed(folder: &Path) -> Golden {
    let golden = Golden::new(folder.join("golden"), folder.join("failures"));
    let bless = Golden { task: Task::Bless, ..golden.clone() };
    bless.check(&old(), "a").expect("written");
    Golden { task: Task::Compare, ..golden }
}

#[test]
fn a_difference_says_how_many_how_much_and_where() {
    let folder = tempfile::tempdir().expect("a folder");
    let golden = blessed(folder.path());
    assert_eq!(golden.check(&old(), "a"), Ok(()));
    assert!(!golden.failures.exists());
    let said = golden.check(&changed(17, 19), "a").expect_err("they differ");
    assert!(said.starts_with("a: 1 pixels differ, by 2 at most, first at (1, 1). See "), "{said}");
    let read = |kind: &str| {
        Picture::read(&golden.failures.join(format!("a-{kind}.png"))).expect("a picture")
    };
    assert_eq!((read("old"), read("new")), (old(), changed(17, 19)));
    let mut bytes = [0; 24];
    bytes[17] = 32;
    assert_eq!(read("difference"), Picture::rgb(4, 2, &bytes));
    let page = fs::read_to_string(golden.failures.join("index.html")).expect("a page");
    assert!(page.contains("1 pictures differ") && page.contains("a-difference.png"), "{page}");
    assert_eq!(golden.check(&old(), "a"), Ok(()));
    let page = fs::read_to_string(golden.failures.join("index.html")).expect("a page");
    assert!(page.contains("0 pictures differ") && !golden.failures.join("a-new.png").exists());
}

#[test]
fn a_tolerance_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let golden = blessed(folder.path());
    let with = |tolerance| Golden { tolerance, ..golden.clone() }.check(&changed(17, 19), "a");
    assert!(with(1).is_err());
    assert_eq!(with(2), Ok(()));
}

#[test]
fn another_size_and_no_picture_fail() {
    let folder = tempfile::tempdir().expect("a folder");
    let golden = blessed(folder.path());
    let other = Picture::rgba(3, 2, &[0; 24]);
    let said = golden.check(&other, "a").expect_err("they differ");
    assert!(said.contains("the old is 4×2 Rgb, the new 3×2 Rgba"), "{said}");
    let said = golden.check(&old(), "b").expect_err("there is none");
    assert!(said.contains("no picture to compare with"), "{said}");
}

#[test]
fn a_difference_of_alpha_alone_is_seen() {
    let [before, after] = [255, 250].map(|alpha| Picture::rgba(1, 1, &[9, 9, 9, alpha]));
    let difference = Difference::between(&before, &after).expect("one");
    assert_eq!(difference.picture, Picture::rgb(1, 1, &[80; 3]));
}

#[test]
fn a_digest_is_that_of_pythons_module() {
    // By printf '2x4x3 B\n\x00\x01…\x17' | sha256sum.
    let expected = "2db9f17b72bd6577fdec0ad5e75a1d3cfadb72b2d9dac27ea0b4f2da15c782e0";
    assert_eq!(old().digest(), expected);
    assert_eq!(old().flipped().flipped().digest(), expected);
    assert_ne!(old().flipped().digest(), expected);
}
