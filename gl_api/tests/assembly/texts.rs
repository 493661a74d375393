//! What loads and what does not: the error, its position, its words.

use super::context;
use gl_api::*;

/// Programs of which the byte at the first `^` is where they are wrong, and words of the message.
const WRONG: &[(&str, &str)] = &[
    ("^", "must begin with !!ARBvp1.0"),
    ("^ !!ARBvp1.0\nEND", "must begin"),
    ("^!!ARBfp1.0\nEND", "must begin"),
    ("!!ARBvp1.0\n^", "expected an instruction"),
    ("!!ARBvp1.0\nTEMP a;\n^", "expected an instruction"),
    ("!!ARBvp1.0\n^FOO a, b;\nEND", "FOO is no instruction"),
    ("!!ARBvp1.0\nMOV result.position, vertex.position\n^END", "expected ';'"),
    ("!!ARBvp1.0\nTEMP a;\n^COS a, a.x;\nEND", "no instruction"),
    ("!!ARBvp1.0\nTEMP a;\n  ^MOVE a, a;\nEND", "MOVE is no instruction: did you mean MOV?"),
    ("!!ARBfp1.0\nTEMP a;\n^mul_sat a, a, a;\nEND", "did you mean MUL_SAT?"),
    ("!!ARBvp1.0\nTEMP color;\nMOV ^colour, color;\nEND", "did you mean color?"),
    ("!!ARBvp1.0\nMOV result^.colour, vertex.color;\nEND", "result.colour: did you mean color?"),
    ("!!ARBvp1.0\nMOV result.color, ^vertex.colour;\nEND", "vertex.colour: did you mean color?"),
    ("!!ARBfp1.0\nMOV result.color, ^fragment.colr;\nEND", "fragment.colr: did you mean color?"),
    ("!!ARBvp1.0\nTEMP a;\n^MOV_SAT a, a;\nEND", "no instruction"),
    ("!!ARBvp1.0\nTEMP a;\n^OPTION ARB_position_invariant;\nEND", "no instruction"),
    ("!!ARBvp1.0\nOPTION ^ARB_fog_exp;\nEND", "no option"),
    (
        "!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result^.position, vertex.position;\nEND",
        "ARB_position_invariant",
    ),
    ("!!ARBvp1.0\nTEMP a, ^a;\nEND", "declared twice"),
    ("!!ARBvp1.0\nTEMP ^vertex;\nEND", "reserved"),
    ("!!ARBvp1.0\nTEMP ^MOV;\nEND", "reserved"),
    ("!!ARBvp1.0\nMOV ^b, vertex.position;\nEND", "b is not declared"),
    ("!!ARBvp1.0\nALIAS a = ^b;\nEND", "b is not declared"),
    ("!!ARBvp1.0\n^ADDRESS a, b;\nEND", "address registers"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, ^result.position;\nEND", "result is not declared"),
    ("!!ARBvp1.0\nOUTPUT o = result.color;\nTEMP a;\nMOV a, ^o;\nEND", "cannot be read"),
    ("!!ARBvp1.0\nATTRIB i = vertex.color;\nMOV ^i, i;\nEND", "cannot be written"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a^.yx, a;\nEND", "no mask"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a^.rgb, a;\nEND", "no mask"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, a^.xy;\nEND", "no swizzle"),
    ("!!ARBvp1.0\nTEMP a;\nRCP a, a^;\nEND", "expected '.'"),
    ("!!ARBvp1.0\nTEMP a;\nRCP a, a^.xxxx;\nEND", "not one component"),
    ("!!ARBfp1.0\nTEMP a;\nCOS a, 1.5^;\nEND", "expected '.'"),
    ("!!ARBvp1.0\nTEMP a;\nSWZ a, a, x, y, ^2, w;\nEND", "0, 1 or a component"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, ^|a|;\nEND", "expected an operand"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, ^state.matrix.mvp;\nEND", "several parameters"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, state^.depth.range;\nEND", "no such part"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, state.light[^8].ambient;\nEND", "must be below 8"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, program.env[^256];\nEND", "must be below 256"),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, program^.foo[0];\nEND", "no program.foo"),
    ("!!ARBvp1.0\nPARAM a^[2] = { 1 };\nEND", "1 elements"),
    ("!!ARBvp1.0\nPARAM a[] = { state.matrix.mvp.row[2..^1] };\nEND", "backwards"),
    ("!!ARBvp1.0\nPARAM a[] = { 1 };\nTEMP b;\nMOV b, a^;\nEND", "expected '['"),
    ("!!ARBvp1.0\nPARAM a[] = { 1 };\nTEMP b;\nMOV b, a[^1];\nEND", "must be below 1"),
    ("!!ARBvp1.0\nPARAM a[] = { 1 };\nTEMP b;\nMOV b, a[^b.x];\nEND", "only an address"),
    ("!!ARBvp1.0\nPARAM a[] = { 1 };\nADDRESS A;\nTEMP b;\nMOV b, a[A^.y];\nEND", "only x"),
    (
        "!!ARBvp1.0\nPARAM a[] = { program.env[0..1], program.env[1] };\nADDRESS A;\nTEMP b;\n\
         MOV b, a[^A.x];\nEND",
        "a parameter twice",
    ),
    (
        "!!ARBvp1.0\nTEMP a;\nMOV a, vertex.normal;\nMOV a, ^vertex.attrib[2];\nEND",
        "use one of both",
    ),
    ("!!ARBvp1.0\nTEMP a;\nMOV a, ^vertex.foo;\nEND", "no vertex.foo"),
    ("!!ARBvp1.0\nTEMP a;\nMOV result^.depth, a;\nEND", "no result.depth"),
    ("!!ARBfp1.0\nTEMP a;\nMOV result^.position, a;\nEND", "no result.position"),
    ("!!ARBfp1.0\nTEMP a;\nMOV result.color^[1], a;\nEND", "ARB_draw_buffers"),
    ("!!ARBfp1.0\nTEMP a;\nMOV a, ^vertex.color;\nEND", "vertex is not declared"),
    ("!!ARBfp1.0\nTEMP a;\nMOV a, a^.xgba;\nEND", "no swizzle"),
    ("!!ARBfp1.0\nTEMP a;\nSWZ a, a, x, ^g, b, w;\nEND", "mixed"),
    ("!!ARBfp1.0\nTEMP a;\n^ARL a, a.x;\nEND", "no instruction"),
    ("!!ARBfp1.0\nTEMP a;\n^KIL_SAT a;\nEND", "no instruction"),
    ("!!ARBfp1.0\nTEMP a;\nTEX a, a, texture[^16], 2D;\nEND", "must be below 16"),
    ("!!ARBfp1.0\nTEMP a;\nTEX a, a, texture[0], ^4D;\nEND", "expected a texture target"),
    ("!!ARBfp1.0\nTEMP a;\nTEX a, a, texture[0], ^SHADOW2D;\nEND", "ARB_fragment_program_shadow"),
    (
        "!!ARBfp1.0\nTEMP a;\nTEX a, a, texture[0], 2D;\nTEX a, a, ^texture[0], 3D;\nEND",
        "two targets",
    ),
    ("!!ARBfp1.0\nOPTION ARB_fog_exp;\nOPTION ^ARB_fog_linear;\nEND", "two kinds of fog"),
    (
        "!!ARBfp1.0\nOPTION ARB_precision_hint_nicest;\nOPTION ^ARB_precision_hint_fastest;\nEND",
        "both precisions",
    ),
];

#[test]
fn what_is_wrong_is_told_with_its_place() {
    for (marked, words) in WRONG {
        let position = marked.find('^').expect("a mark");
        let text = marked.replace('^', "");
        let mut c = context();
        let is_fragment = text.starts_with("!!ARBfp") && !words.starts_with("must begin");
        let target = if is_fragment { GL_FRAGMENT_PROGRAM_ARB } else { GL_VERTEX_PROGRAM_ARB };
        c.program_string(target, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, &text);
        assert_eq!(c.get_error(), GL_INVALID_OPERATION, "{marked}");
        let message = c.get_string(GL_PROGRAM_ERROR_STRING_ARB);
        assert!(message.contains(words), "{marked}: {message}");
        let line = text[..position].matches('\n').count() + 1;
        let begin = text[..position].rfind('\n').map_or(0, |at| at + 1);
        let quoted = text[begin..].lines().next().unwrap_or_default().trim();
        let column = position - begin + 1;
        let place = match quoted {
            "" => format!("line {line}, column {column}: "),
            _ => format!("line {line}, column {column}, in \""),
        };
        assert!(message.starts_with(&place), "{marked}: {message}");
        let quoted = &quoted[..quoted.len().min(40)];
        assert!(message[place.len()..].starts_with(quoted), "{marked}: {message}");
        let mut found = [0];
        c.get_integerv(GL_PROGRAM_ERROR_POSITION_ARB, &mut found);
        assert_eq!(found, [position as GLint], "{marked}: {message}");
    }
}

/// Programs that load.
const RIGHT: &[&str] = &[
    "!!ARBvp1.0 END",
    "!!ARBvp1.0 END # and what follows does not matter; (",
    "!!ARBvp1.0\r\nOPTION ARB_position_invariant;\r\nEND\r\n",
    "!!ARBvp1.0 TEMP fragment, texture, COS; MOV COS, fragment; END",
    "!!ARBvp1.0 PARAM p[8] = { program.env[0..3], program.local[4..7] }; END",
    "!!ARBvp1.0 PARAM p[4] = { state.matrix.program[7].inverse }; END",
    "!!ARBvp1.0 TEMP a; MOV a, vertex.color.primary.xxxx; MOV a, vertex.texcoord.x; END",
    "!!ARBfp1.0 OPTION ARB_precision_hint_nicest; OPTION ARB_precision_hint_nicest; END",
    "!!ARBfp1.0 TEMP vertex, ADDRESS, ARL, EXP, x, xyzw, r; MOV r.r, xyzw.xyzw; END",
    "!!ARBfp1.0 OPTION ARB_draw_buffers; MOV result.color[7], fragment.position; END",
    "!!ARBfp1.0 TEMP a; TEX a, a, texture, RECT; TXB a, a, texture[1], CUBE; END",
];

#[test]
fn what_the_grammar_has_loads() {
    for text in RIGHT {
        let mut c = context();
        super::load(&mut c, text);
        let mut position = [0];
        c.get_integerv(GL_PROGRAM_ERROR_POSITION_ARB, &mut position);
        assert_eq!(position, [-1], "{text}");
        assert_eq!(c.get_string(GL_PROGRAM_ERROR_STRING_ARB), "", "{text}");
    }
}

/// Every text that a program is cut off to, and with a byte of it replaced.
#[test]
fn no_text_breaks_anything() {
    let text = "!!ARBfp1.0 OPTION ARB_fog_exp; PARAM p[2] = { {1, -2.5e1}, state.matrix.mvp.row[1] };\
        TEMP a, b; MAD_SAT a.xz, -p[1].yzwx, fragment.texcoord[0], {0.5}.x; KIL a.x;\
        TXP b, a, texture[3], 2D; SWZ result.color, b, -x, 0, 1, w; END";
    let mut c = context();
    for at in 0..text.len() {
        let replaced = [";", "[", ".", "9", "{", "-", "e", "\u{e9}"];
        let all = replaced.map(|mark| format!("{}{mark}{}", &text[..at], &text[at + 1..]));
        for text in all.iter().map(String::as_str).chain([&text[..at]]) {
            let target = GL_FRAGMENT_PROGRAM_ARB;
            c.program_string(target, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, text);
            assert!([GL_NO_ERROR, GL_INVALID_OPERATION].contains(&c.get_error()), "{text}");
        }
    }
}

/// A program of so many of something loads up to a limit.
#[test]
fn limits_are_where_they_are_said_to_be() {
    let temporaries = |n: usize| {
        let names: Vec<String> = (0..n).map(|i| format!("t{i}")).collect();
        format!("!!ARBfp1.0 TEMP {}; END", names.join(", "))
    };
    let instructions =
        |n: usize| format!("!!ARBfp1.0 TEMP a; {} END", "ADD a, a, fragment.color;".repeat(n));
    let parameters = |n: usize| {
        let all: Vec<String> = (0..n).map(|i| i.to_string()).collect();
        format!("!!ARBfp1.0 PARAM p[] = {{ {} }}; END", all.join(", "))
    };
    let makers: [(&dyn Fn(usize) -> String, GLenum); 3] = [
        (&temporaries, GL_MAX_PROGRAM_TEMPORARIES_ARB),
        (&instructions, GL_MAX_PROGRAM_INSTRUCTIONS_ARB),
        (&parameters, GL_MAX_PROGRAM_PARAMETERS_ARB),
    ];
    for (make, name) in makers {
        let mut c = context();
        let target = GL_FRAGMENT_PROGRAM_ARB;
        let mut limit = [0];
        c.get_assembly_programiv(target, name, &mut limit);
        for (count, error) in [(limit[0], GL_NO_ERROR), (limit[0] + 1, GL_INVALID_OPERATION)] {
            let text = make(count as usize);
            c.program_string(target, GL_PROGRAM_FORMAT_ASCII_ARB, text.len() as GLsizei, &text);
            assert_eq!(c.get_error(), error, "{} {count}", enum_name(name));
        }
    }
}
