//! Where the members of uniform blocks lie.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::std140::{Leaf, Order, Type, leaves};
use crate::probe::{Dialect, ProbeError};
use crate::rng::Rng;
use gl_api::constants::*;

/// std140.
pub const STD140: Check = Check {
    name: "uniform-block-std140",
    citation: "GL 3.1, 2.11.4: standard uniform block layout; OpenGL ES 3.0, 2.12.6.4",
    what: "the word that each scalar of random blocks reads: vectors, matrices by columns and by rows, \
           arrays, structures and arrays of them, in OpenGL and OpenGL ES",
    unit: Unit::Codes,
    tolerance: 0.0,
    why: "each word is its own number",
    run,
};

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("uniform-block-std140");
    let blocks = harness.cases(24).max(10);
    let mut turned = 0;
    for round in 0..blocks {
        let dialect = [Dialect::Core, Dialect::Es][round % 2];
        let members: Vec<(Type, Order)> = (0..8)
            .map(|_| {
                let order = rng.pick(&[Order::ColumnMajor, Order::RowMajor]);
                (random(&mut rng, 2), order)
            })
            .collect();
        let (all, words) = leaves(&members, Variant::CORRECT);
        // Some of many, so that shaders stay small.
        let stride = all.len().div_ceil(96);
        let chosen: Vec<usize> = (0..all.len()).step_by(stride).collect();
        turned += members.iter().filter(|(ty, order)| is_turned(ty, *order)).count();
        let scene = declaration(&members);
        let expect = |&case: &usize, variant: Variant| {
            let (all, _) = leaves(&members, variant);
            [all[case].1 as f64, 0.0, 0.0, 0.0]
        };
        harness.compare_with(dialect, tally, &scene, &chosen, expect, |session| {
            let numbers: Vec<f32> = (0..words).map(|word| word as f32).collect();
            let mut buffer = 0u32;
            glGenBuffers(1, &mut buffer);
            glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer);
            glBufferData(GL_UNIFORM_BUFFER, 4 * words, &numbers, GL_STATIC_DRAW);
            let inputs: Vec<_> =
                chosen.iter().map(|&case| [[case as u32, 0, 0, 0], [0; 4]]).collect();
            let words = session.words(&body(&scene, &all, &chosen), &inputs)?;
            Ok(words.into_iter().map(|word| [word[0].into(), 0.0, 0.0, 0.0]).collect())
        })?;
        tally.reach(format!("block {round}, scalars"), chosen.len(), 6);
    }
    tally.reach("members by rows", turned, blocks / 8);
    Ok(())
}

/// Whether the order of a member makes a difference.
fn is_turned(ty: &Type, order: Order) -> bool {
    match ty {
        Type::Vector(_) => false,
        Type::Matrix(..) => order == Order::RowMajor,
        Type::Array(element, _) => is_turned(element, order),
        Type::Struct(members) => members.iter().any(|member| is_turned(member, order)),
    }
}

/// A random type: structures and arrays of them at most `depth` deep.
fn random(rng: &mut Rng, depth: usize) -> Type {
    let mut side = |least, most| rng.integer(least, most) as usize;
    match side(0, if depth > 0 { 11 } else { 7 }) {
        0..=4 => Type::Vector(side(1, 4)),
        5 => Type::Matrix(side(2, 4), side(2, 4)),
        6 => Type::Array(Box::new(Type::Vector(side(1, 4))), side(1, 3)),
        7 => Type::Array(Box::new(Type::Matrix(side(2, 4), side(2, 4))), 2),
        _ => {
            let (members, elements) = (side(1, 3), side(0, 3));
            let members = (0..members).map(|_| random(rng, depth - 1)).collect();
            let structure = Type::Struct(members);
            if elements > 2 { Type::Array(Box::new(structure), elements - 1) } else { structure }
        }
    }
}

/// The GLSL of a type: definitions of structures go to `structs`; the name, and the dimension after the variable.
fn glsl(ty: &Type, structs: &mut Vec<String>) -> (String, String) {
    match ty {
        Type::Vector(1) => ("float".to_owned(), String::new()),
        Type::Vector(size) => (format!("vec{size}"), String::new()),
        Type::Matrix(columns, rows) => (format!("mat{columns}x{rows}"), String::new()),
        Type::Array(element, count) => {
            let (name, _) = glsl(element, structs);
            (name, format!("[{count}]"))
        }
        Type::Struct(members) => {
            let mut lines = String::new();
            for (i, member) in members.iter().enumerate() {
                let (name, dimension) = glsl(member, structs);
                lines += &format!("{name} m{i}{dimension}; ");
            }
            let name = format!("S{}", structs.len());
            structs.push(format!("struct {name} {{ {lines}}};"));
            (name, String::new())
        }
    }
}

fn declaration(members: &[(Type, Order)]) -> String {
    let mut structs = Vec::new();
    let mut lines = String::new();
    for (i, (ty, order)) in members.iter().enumerate() {
        let (name, dimension) = glsl(ty, &mut structs);
        let order = match order {
            Order::ColumnMajor => "column_major",
            Order::RowMajor => "row_major",
        };
        lines += &format!("layout({order}) {name} b{i}{dimension};\n");
    }
    format!("{}\nlayout(std140) uniform Block {{\n{lines}}};\n", structs.join("\n"))
}

fn body(declaration: &str, all: &[Leaf], chosen: &[usize]) -> String {
    let cases: String =
        chosen.iter().map(|&case| format!("case {case}: x = {}; break;\n", all[case].0)).collect();
    format!(
        "{declaration}
        uvec4 value(uvec4 a, uvec4 b) {{
            float x = -1.0;
            switch (int(a.x)) {{\n{cases}}}
            return uvec4(uint(x), 0u, 0u, 0u);
        }}"
    )
}
