//! The programs take any picture, and say what the lecture's mistakes are.

use examples::picture::Picture;
use examples::programs::{self, lecture_mistakes};
use examples::window::{Program, Rendered, render};
use gl_api::context::ContextDesc;

fn draw(program: &Program, image: Option<Picture>) -> Rendered {
    render(program, 64, image, &ContextDesc::default()).expect("a context of this size")
}

#[test]
fn a_picture_of_any_size_and_alignment_can_be_given() {
    // 39 bytes a row, and no power of two.
    let image = Picture::paint(13, 7, |x, y| [x, y, 0.5]);
    for program in &programs::ALL {
        let rendered = draw(program, Some(image.clone()));
        assert!(rendered.errors.is_empty(), "{}: {:?}", program.name, rendered.errors);
    }
}

#[test]
fn every_panel_has_a_caption_or_none_has() {
    for program in &programs::ALL {
        let (captions, panels) = (program.panels.len(), draw(program, None).panels);
        assert!(captions == 0 || captions == panels, "{}: {captions} of {panels}", program.name);
    }
}

#[test]
fn shaders_that_were_repaired_by_hand_compile_without_a_word() {
    for program in programs::ALL.iter().filter(|p| p.name != lecture_mistakes::PROGRAM.name) {
        assert_eq!(draw(program, None).notes, "", "{}", program.name);
    }
}

#[test]
fn the_lectures_text_is_rejected_and_with_repairs_it_runs() {
    let notes = draw(&lecture_mistakes::PROGRAM, None).notes;
    let sections: Vec<&str> = notes.split("== ").skip(1).collect();
    let (rejected, repaired) = sections.split_at(3);
    for section in rejected {
        assert!(section.contains("error: "), "{section}");
    }
    assert_eq!(repaired.len(), 3);
    for section in repaired {
        assert!(section.contains("warning: ") && !section.contains("error: "), "{section}");
    }
}
