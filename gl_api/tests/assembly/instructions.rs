//! Every instruction, operand and modifier, as a vertex program and as a fragment program.

use super::{PASS, context, drawn, load, near};

/// Which programs have it.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Both,
    Vertex,
    Fragment,
}
use Of::{Both, Fragment, Vertex};

/// Statements that compute `r` from `a` = (1, -2, 3.5, 0.25), `b` = (4, 2, -1, 8) and
/// `c` = (0.5, 0, -0.5, 1), and what it is then.
const ROWS: &[(Of, &str, [f32; 4])] = &[
    (Both, "ABS r, a;", [1.0, 2.0, 3.5, 0.25]),
    (Both, "ADD r, a, b;", [5.0, 0.0, 2.5, 8.25]),
    (Fragment, "CMP r, a, b, c;", [0.5, 2.0, -0.5, 1.0]),
    (Fragment, "CMP r, -a, b, c;", [4.0, 0.0, -1.0, 8.0]),
    (Fragment, "COS r, {0}.x;", [1.0; 4]),
    (Both, "DP3 r, a, b;", [-3.5; 4]),
    (Both, "DP4 r, a, b;", [-1.5; 4]),
    (Both, "DPH r, a, b;", [4.5; 4]),
    (Both, "DST r, a, b;", [1.0, -4.0, 3.5, 8.0]),
    (Both, "EX2 r, a.z;", [11.313_708; 4]),
    (Vertex, "EXP r, a.z;", [8.0, 0.5, 11.313_708, 1.0]),
    (Vertex, "EXP r, -a.z;", [0.0625, 0.5, 0.088_388_35, 1.0]),
    (Both, "FLR r, a;", [1.0, -2.0, 3.0, 0.0]),
    (Both, "FLR r, -a;", [-1.0, 2.0, -4.0, -1.0]),
    (Both, "FRC r, -a;", [0.0, 0.0, 0.5, 0.75]),
    (Both, "LG2 r, b.w;", [3.0; 4]),
    (Both, "LIT r, b.wyyy;", [1.0, 8.0, 4.0, 1.0]),
    (Both, "LIT r, -b.wyyy;", [1.0, 0.0, 0.0, 1.0]),
    (Both, "LIT r, {2, 0, 0, 0};", [1.0, 2.0, 1.0, 1.0]),
    (Both, "LIT r, {2, 2, 0, 200};", [1.0, 2.0, 3.393_622e38, 1.0]),
    (Vertex, "LOG r, -b.w;", [3.0, 1.0, 3.0, 1.0]),
    (Vertex, "LOG r, {24}.x;", [4.0, 1.5, 4.584_962_5, 1.0]),
    (Vertex, "LOG r, c.y;", [f32::NEG_INFINITY, 1.0, f32::NEG_INFINITY, 1.0]),
    (Fragment, "LRP r, c, a, b;", [2.5, 2.0, -3.25, 0.25]),
    (Both, "MAD r, a, b, c;", [4.5, -4.0, -4.0, 3.0]),
    (Both, "MAX r, a, b;", [4.0, 2.0, 3.5, 8.0]),
    (Both, "MIN r, a, b;", [1.0, -2.0, -1.0, 0.25]),
    (Both, "MOV r, a;", [1.0, -2.0, 3.5, 0.25]),
    (Both, "MUL r, a, b;", [4.0, -4.0, -3.5, 2.0]),
    (Both, "POW r, b.x, c.x;", [2.0; 4]),
    (Both, "RCP r, a.w;", [4.0; 4]),
    (Both, "RSQ r, -a.w;", [2.0; 4]),
    (Fragment, "SCS r.xy, {0.5235988}.x; MOV r.zw, b;", [0.866_025_4, 0.5, -1.0, 8.0]),
    (Both, "SGE r, a, {1, -2, 4, 0};", [1.0, 1.0, 0.0, 1.0]),
    (Fragment, "SIN r, {0.5235988}.x;", [0.5; 4]),
    (Both, "SLT r, a, {1, -1, 4, 0};", [0.0, 1.0, 1.0, 0.0]),
    (Both, "SUB r, a, b;", [-3.0, -4.0, 4.5, -7.75]),
    (Both, "SWZ r, a, -x, 0, 1, -1;", [-1.0, 0.0, 1.0, -1.0]),
    (Both, "SWZ r, a, w, -z, y, +x;", [0.25, -3.5, -2.0, 1.0]),
    (Both, "XPD r.xyz, a, b; MOV r.w, a;", [-5.0, 15.0, 10.0, 0.25]),
    // A destination may be an operand: all is read before anything is written.
    (Both, "MOV r, a; XPD r.xyz, r, b; MOV r.w, a;", [-5.0, 15.0, 10.0, 0.25]),
    (Both, "MOV r, a; MOV r.xy, r.yxzw;", [-2.0, 1.0, 3.5, 0.25]),
    // Masks, swizzles, signs.
    (Both, "MOV r, a; MOV r.yw, b;", [1.0, 2.0, 3.5, 8.0]),
    (Both, "MOV r, -a.wzyx;", [-0.25, -3.5, 2.0, -1.0]),
    (Both, "MOV r, a.z;", [3.5; 4]),
    (Fragment, "MOV r, a; MOV r.ga, b.abgr;", [1.0, -1.0, 3.5, 4.0]),
    (Fragment, "ADD_SAT r, a, c;", [1.0, 0.0, 1.0, 1.0]),
    (Fragment, "MUL_SAT r, a.w, c;", [0.125, 0.0, 0.0, 0.25]),
    (Fragment, "MOV r, a; MOV_SAT r.yz, a;", [1.0, 0.0, 1.0, 0.25]),
    // Constants.
    (Both, "MOV r, 2.5;", [2.5; 4]),
    (Both, "MOV r, -3;", [-3.0; 4]),
    (Both, "MOV r, {1.5};", [1.5, 0.0, 0.0, 1.0]),
    (Both, "MOV r, {-1, .5, +2.};", [-1.0, 0.5, 2.0, 1.0]),
    (Both, "MOV r, {1e1, 1E-1, 2.5e+1, .5e1};", [10.0, 0.1, 25.0, 5.0]),
    (Both, "PARAM p = -2.5; MOV r, p;", [-2.5; 4]),
    (Both, "PARAM p = {1, 2, 3, 4}; MOV r, p.w;", [4.0; 4]),
    (Both, "PARAM p[] = { {1, 2, 3, 4}, 5, {6} }; ADD r, p[0], p[2];", [7.0, 2.0, 3.0, 5.0]),
    (Both, "ALIAS q = r; MOV q, a; TEMP s, t; MOV s, q; MOV r, s;", [1.0, -2.0, 3.5, 0.25]),
    (Both, "# MOV r, b;\n MOV r, a; # ;\n", [1.0, -2.0, 3.5, 0.25]),
    // Addresses round down; beyond its ends an array is undefined, and nothing breaks.
    (
        Vertex,
        "ADDRESS A; PARAM p[3] = { {1}, {2}, {3} }; ARL A.x, {1.9}.x; MOV r, p[A.x];",
        [2.0, 0.0, 0.0, 1.0],
    ),
    (
        Vertex,
        "ADDRESS A; PARAM p[3] = { {1}, {2}, {3} }; ARL A.x, {-0.1}.x; MOV r, p[A.x + 3];",
        [3.0, 0.0, 0.0, 1.0],
    ),
    (
        Vertex,
        "ADDRESS A; PARAM p[3] = { {1}, {2}, {3} }; ARL A.x, {7}.x; ADD r, p[A.x - 7], p[A.x];",
        [4.0, 0.0, 0.0, 2.0],
    ),
    (
        Vertex,
        "ADDRESS A; PARAM p[2] = { {1}, {2} }; ARL A.x, {-9e9}.x; MOV r, p[A.x]; MOV r, a;",
        [1.0, -2.0, 3.5, 0.25],
    ),
];

const OPERANDS: &str = "TEMP r;\nPARAM a = {1, -2, 3.5, 0.25}; PARAM b = {4, 2, -1, 8};\n\
    PARAM c = {0.5, 0, -0.5, 1};\n";

fn program(of: Of, statements: &str) -> String {
    let (header, end) = match of {
        Vertex => ("!!ARBvp1.0\nOPTION ARB_position_invariant;\n", "MOV result.texcoord[0], r;\n"),
        Both | Fragment => ("!!ARBfp1.0\n", "MOV result.color, r;\n"),
    };
    format!("{header}{OPERANDS}{statements}\n{end}END\n")
}

#[test]
fn instructions_compute_what_the_specification_says_in_both_stages() {
    for &(of, statements, expected) in ROWS {
        if of != Vertex {
            let mut c = context();
            load(&mut c, &program(Fragment, statements));
            let found = drawn(&mut c);
            assert!(near(found, expected), "fragment: {statements}: {found:?} {expected:?}");
        }
        if of != Fragment {
            let mut c = context();
            load(&mut c, &program(Vertex, statements));
            load(&mut c, PASS);
            let found = drawn(&mut c);
            assert!(near(found, expected), "vertex: {statements}: {found:?} {expected:?}");
        }
    }
}

/// Operands that are not constants, so that nothing folds.
#[test]
fn what_is_not_constant_computes_the_same() {
    for &(of, statements, expected) in ROWS.iter().filter(|row| row.0 != Vertex) {
        let mut c = context();
        let text = program(of, statements)
            .replace("a = {1, -2, 3.5, 0.25}", "a = program.local[0]")
            .replace("b = {4, 2, -1, 8}", "b = program.env[3]")
            .replace("c = {0.5, 0, -0.5, 1}", "c = program.local[2047]");
        load(&mut c, &text);
        let target = gl_api::GL_FRAGMENT_PROGRAM_ARB;
        c.program_local_parameter_4f(target, 0, 1.0, -2.0, 3.5, 0.25);
        c.program_env_parameter_4f(target, 3, 4.0, 2.0, -1.0, 8.0);
        c.program_local_parameter_4f(target, 2047, 0.5, 0.0, -0.5, 1.0);
        let found = drawn(&mut c);
        assert!(near(found, expected), "{statements}: {found:?} {expected:?}");
    }
}

#[test]
fn a_negative_component_kills() {
    for (operand, kept) in [
        ("{0, 0, 0, 0}", true),
        ("{1, 2, 3, -1}", false),
        ("-{1, 2, 3, -1}.w", true),
        ("{1, -2, 3, 1}.xxzw", true),
        ("{1, -2, 3, 1}.y", false),
    ] {
        let mut c = context();
        c.clear_color(9.0, 9.0, 9.0, 9.0);
        c.clear(gl_api::GL_COLOR_BUFFER_BIT);
        load(&mut c, &format!("!!ARBfp1.0\nMOV result.color, 1;\nKIL {operand};\nEND"));
        assert_eq!(drawn(&mut c) == [1.0; 4], kept, "{operand}");
    }
}
