//! The stencil test and its operations against a table of what they mean.

use super::shading::use_program;
use super::{ALL, bytes, context, fine, framebuffer, rectangle};
use gl_api::*;

/// GL 2.1, section 4.1.5, in plain arithmetic.
fn operate(op: GLenum, stored: u8, reference: u8) -> u8 {
    match op {
        GL_KEEP => stored,
        GL_ZERO => 0,
        GL_REPLACE => reference,
        GL_INCR => stored.saturating_add(1),
        GL_DECR => stored.saturating_sub(1),
        GL_INCR_WRAP => stored.wrapping_add(1),
        GL_DECR_WRAP => stored.wrapping_sub(1),
        GL_INVERT => !stored,
        _ => unreachable!("no operation"),
    }
}

const OPS: [GLenum; 8] =
    [GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP];

const FUNCS: [GLenum; 8] =
    [GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS];

fn passes(func: GLenum, reference: u8, stored: u8) -> bool {
    match func {
        GL_NEVER => false,
        GL_LESS => reference < stored,
        GL_EQUAL => reference == stored,
        GL_LEQUAL => reference <= stored,
        GL_GREATER => reference > stored,
        GL_NOTEQUAL => reference != stored,
        GL_GEQUAL => reference >= stored,
        GL_ALWAYS => true,
        _ => unreachable!("no function"),
    }
}

/// Every value of a stencil, one a pixel of 16 × 16.
fn ramp(c: &mut Context) {
    c.disable(GL_STENCIL_TEST);
    c.stencil_mask(!0);
    c.enable(GL_SCISSOR_TEST);
    for value in 0..256 {
        c.scissor(value % 16, value / 16, 1, 1);
        c.clear_stencil(value);
        c.clear(GL_STENCIL_BUFFER_BIT);
    }
    c.disable(GL_SCISSOR_TEST);
}

fn stencils(c: &mut Context) -> Vec<u8> {
    bytes(c, [0, 0, 16, 16], GL_STENCIL_INDEX, 1)
}

#[test]
fn every_operation_does_to_every_value_what_it_should() {
    let mut c = context(16, 16);
    let reference = 0xA7;
    for op in OPS {
        for write_mask in [0xFF, 0x3C] {
            for outcome in 0..3 {
                ramp(&mut c);
                c.clear(GL_DEPTH_BUFFER_BIT);
                c.enable(GL_STENCIL_TEST);
                c.enable(GL_DEPTH_TEST);
                // Fails the stencil test, or the depth test, or passes both.
                let func = if outcome == 0 { GL_NEVER } else { GL_ALWAYS };
                c.depth_func(if outcome == 1 { GL_NEVER } else { GL_ALWAYS });
                let mut ops = [GL_ZERO; 3];
                ops[outcome] = op;
                c.stencil_func(func, reference, 0xFF);
                c.stencil_op(ops[0], ops[1], ops[2]);
                c.stencil_mask(write_mask);
                rectangle(&mut c, ALL, 0.0);
                for (value, got) in stencils(&mut c).into_iter().enumerate() {
                    let (value, mask) = (value as u8, write_mask as u8);
                    let want = operate(op, value, reference as u8) & mask | value & !mask;
                    assert_eq!(got, want, "{} of {value}, {outcome}", enum_name(op));
                }
            }
        }
    }
}

#[test]
fn every_function_compares_through_the_mask() {
    let mut c = context(16, 16);
    for func in FUNCS {
        for (reference, mask) in [(0, 0xFF), (0x80, 0xFF), (0xFF, 0xFF), (0x35, 0x3C), (300, 0xFF)]
        {
            ramp(&mut c);
            c.clear_color(0.0, 0.0, 0.0, 0.0);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.enable(GL_STENCIL_TEST);
            c.stencil_func(func, reference, mask);
            c.stencil_op(GL_KEEP, GL_KEEP, GL_KEEP);
            rectangle(&mut c, ALL, 0.0);
            let red = bytes(&mut c, [0, 0, 16, 16], GL_RED, 1);
            for (stored, got) in red.into_iter().enumerate() {
                let masked = mask as u8;
                let reference = reference.clamp(0, 255) as u8;
                let want = passes(func, reference & masked, stored as u8 & masked);
                assert_eq!(got == 255, want, "{} {reference} {stored}", enum_name(func));
            }
        }
    }
}

#[test]
fn each_side_has_a_state_of_its_own() {
    for two_side in [false, true] {
        let mut c = context(16, 16);
        c.clear(GL_STENCIL_BUFFER_BIT);
        c.enable(GL_STENCIL_TEST);
        if two_side {
            c.enable(GL_STENCIL_TEST_TWO_SIDE_EXT);
            c.active_stencil_face_ext(GL_BACK);
            c.stencil_op(GL_KEEP, GL_KEEP, GL_REPLACE);
            c.stencil_func(GL_ALWAYS, 9, !0);
            c.active_stencil_face_ext(GL_FRONT);
            c.stencil_op(GL_KEEP, GL_KEEP, GL_INCR);
        } else {
            c.stencil_op_separate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR);
            c.stencil_op_separate(GL_BACK, GL_KEEP, GL_KEEP, GL_REPLACE);
            c.stencil_func_separate(GL_BACK, GL_ALWAYS, 9, !0);
        }
        rectangle(&mut c, [-1.0, -1.0, 0.0, 1.0], 0.0);
        // Seen from behind.
        rectangle(&mut c, [1.0, -1.0, 0.0, 1.0], 0.0);
        for (i, got) in stencils(&mut c).into_iter().enumerate() {
            assert_eq!(got, if i % 16 < 8 { 1 } else { 9 }, "{two_side} {i}");
        }
    }
}

#[test]
fn a_fragment_that_is_thrown_away_leaves_no_stencil() {
    let mut c = context(16, 16);
    c.clear(GL_STENCIL_BUFFER_BIT);
    c.enable(GL_STENCIL_TEST);
    c.stencil_op(GL_INCR, GL_INCR, GL_INCR);
    c.enable(GL_ALPHA_TEST);
    c.alpha_func(GL_GREATER, 0.5);
    c.color_4f(1.0, 1.0, 1.0, 0.2);
    rectangle(&mut c, ALL, 0.0);
    c.color_4f(1.0, 1.0, 1.0, 0.8);
    rectangle(&mut c, [-1.0, -1.0, 0.0, 1.0], 0.0);
    for (i, got) in stencils(&mut c).into_iter().enumerate() {
        assert_eq!(got, u8::from(i % 16 < 8));
    }
}

/// GL 2.1, section 4.3.2: an index is masked with what its type can hold.
#[test]
fn a_byte_with_a_sign_takes_seven_bits_of_a_stencil() {
    let mut c = context(16, 16);
    ramp(&mut c);
    let mut found = [0_u8; 256];
    let out = DataOut::Bytes(&mut found);
    c.read_pixels(0, 0, 16, 16, GL_STENCIL_INDEX, GL_BYTE, out);
    for (value, got) in found.into_iter().enumerate() {
        assert_eq!(usize::from(got), value & 0x7F);
    }
    fine(&mut c);
}

#[test]
fn both_faces_can_be_compared_by_one_call() {
    let mut c = context(4, 4);
    c.stencil_func_separate_ati(GL_LESS, GL_GREATER, 5, 0x3F);
    for (pname, want) in [
        (GL_STENCIL_FUNC, GL_LESS as i32),
        (GL_STENCIL_BACK_FUNC, GL_GREATER as i32),
        (GL_STENCIL_REF, 5),
        (GL_STENCIL_BACK_REF, 5),
        (GL_STENCIL_VALUE_MASK, 0x3F),
        (GL_STENCIL_BACK_VALUE_MASK, 0x3F),
    ] {
        let mut value = [0];
        c.get_integerv(pname, &mut value);
        assert_eq!(value, [want], "{pname:#x}");
    }
}

#[test]
fn references_are_clamped_where_they_are_asked_for() {
    let mut c = context(4, 4);
    let references = |c: &mut Context| {
        [GL_STENCIL_REF, GL_STENCIL_BACK_REF].map(|pname| {
            let mut value = [-1];
            c.get_integerv(pname, &mut value);
            value[0]
        })
    };
    c.stencil_func_separate(GL_FRONT, GL_LESS, 300, 0xFF);
    c.stencil_func_separate(GL_BACK, GL_LESS, -3, 0xFF);
    assert_eq!(references(&mut c), [255, 0]);
    // To the stencils that are drawn to: of none here. What was given is kept.
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    assert_eq!(references(&mut c), [0, 0]);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    assert_eq!(references(&mut c), [255, 0]);
    fine(&mut c);
}

#[test]
fn the_state_can_be_asked_for() {
    let mut c = context(4, 4);
    c.stencil_func_separate(GL_BACK, GL_LESS, -3, 0xF0);
    c.stencil_op(GL_INCR_WRAP, GL_DECR_WRAP, GL_INVERT);
    c.stencil_mask_separate(GL_FRONT, 0x0F);
    for (pname, want) in [
        (GL_STENCIL_FUNC, GL_ALWAYS as i32),
        (GL_STENCIL_BACK_FUNC, GL_LESS as i32),
        (GL_STENCIL_BACK_REF, 0),
        (GL_STENCIL_BACK_VALUE_MASK, 0xF0),
        (GL_STENCIL_FAIL, GL_INCR_WRAP as i32),
        (GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_DECR_WRAP as i32),
        (GL_STENCIL_PASS_DEPTH_PASS, GL_INVERT as i32),
        (GL_STENCIL_WRITEMASK, 0x0F),
        (GL_STENCIL_BACK_WRITEMASK, -1),
        (GL_STENCIL_BITS, 8),
        (GL_DEPTH_BITS, 24),
    ] {
        let mut value = [0];
        c.get_integerv(pname, &mut value);
        assert_eq!(value[0], want, "{}", enum_name(pname));
    }
    // A mask has no sign; as an integer of 32 bits it is the same bits.
    let (mut long, mut float) = ([0], [0.0]);
    c.get_integer64v(GL_STENCIL_BACK_WRITEMASK, &mut long);
    c.get_doublev(GL_STENCIL_BACK_WRITEMASK, &mut float);
    assert_eq!((long[0], float[0]), (i64::from(u32::MAX), f64::from(u32::MAX)));
    fine(&mut c);
}

/// A program that writes the stencil's reference, of pixel (x, y) the low bits of 7x + 31y - 100.
const EXPORT: &str = "#extension GL_ARB_shader_stencil_export : require
void main() {
    gl_FragColor = vec4(1.0);
    gl_FragStencilRefARB = 7 * int(gl_FragCoord.x) + 31 * int(gl_FragCoord.y) - 100;
}";

/// That reference of the pixel of this number, of 16 a row.
fn exported(at: usize) -> u8 {
    (7 * (at % 16) as i32 + 31 * (at / 16) as i32 - 100) as u8
}

#[test]
fn a_reference_that_a_shader_writes_is_compared_and_stored() {
    let mut c = context(16, 16);
    for func in FUNCS {
        for (mask, write_mask) in [(0xFF, 0xFF), (0x3C, 0x0F)] {
            ramp(&mut c);
            c.clear_color(0.0, 0.0, 0.0, 0.0);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.enable(GL_STENCIL_TEST);
            c.stencil_mask(write_mask);
            // 0x55 is of nobody.
            c.stencil_func(func, 0x55, mask);
            c.stencil_op(GL_INVERT, GL_KEEP, GL_REPLACE);
            use_program(&mut c, "", EXPORT);
            rectangle(&mut c, ALL, 0.0);
            c.use_program(0);
            let (mask, write_mask) = (mask as u8, write_mask as u8);
            let red = bytes(&mut c, [0, 0, 16, 16], GL_RED, 1);
            let found = stencils(&mut c);
            for at in 0..256 {
                let (stored, reference) = (at as u8, exported(at));
                let passed = passes(func, reference & mask, stored & mask);
                assert_eq!(red[at] == 255, passed, "{} {at}", enum_name(func));
                let new = if passed { reference } else { !stored };
                let want = new & write_mask | stored & !write_mask;
                assert_eq!(found[at], want, "{} {at}", enum_name(func));
            }
        }
    }
}

/// Also where fragments are thrown away, of back faces, and where the depth is written as well.
#[test]
fn a_written_reference_counts_for_both_faces_and_only_for_what_is_left() {
    let mut c = context(16, 16);
    c.clear_depth(0.5);
    c.clear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    c.enable(GL_STENCIL_TEST);
    c.enable(GL_DEPTH_TEST);
    c.stencil_op_separate(GL_FRONT, GL_KEEP, GL_INVERT, GL_REPLACE);
    c.stencil_op_separate(GL_BACK, GL_KEEP, GL_REPLACE, GL_INVERT);
    let fragment = "#extension GL_ARB_shader_stencil_export : require
        void main() {
            gl_FragColor = vec4(1.0);
            gl_FragStencilRefARB = 256 + int(gl_FragCoord.y);
            if (gl_FragCoord.y > 12.0) discard;
            gl_FragDepth = mod(gl_FragCoord.y, 2.0) < 1.0 ? 0.25 : 0.75; }";
    use_program(&mut c, "", fragment);
    rectangle(&mut c, [-1.0, -1.0, 0.0, 1.0], 0.0);
    // Seen from behind.
    rectangle(&mut c, [1.0, -1.0, 0.0, 1.0], 0.0);
    for (at, got) in stencils(&mut c).into_iter().enumerate() {
        let (x, y) = (at % 16, at / 16);
        let want = match (y, y % 2 == 0, x < 8) {
            (12.., _, _) => 0,
            (_, true, true) | (_, false, false) => y as u8,
            (_, true, false) | (_, false, true) => 0xFF,
        };
        assert_eq!(got, want, "{x} {y}");
    }
}

/// A shader that writes no reference, if only because nothing is tested, changes nothing.
#[test]
fn without_a_test_a_written_reference_does_nothing() {
    let mut c = context(16, 16);
    ramp(&mut c);
    use_program(&mut c, "", EXPORT);
    rectangle(&mut c, ALL, 0.0);
    let want: Vec<u8> = (0..=255).collect();
    assert_eq!(stencils(&mut c), want);
    // Nor is there one without the extension.
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    let text = "void main() { gl_FragStencilRefARB = 1; }";
    c.shader_source(shader, 1, Strings(vec![text]), &[]);
    c.compile_shader(shader);
    let mut log = String::new();
    c.get_shader_info_log(shader, 1 << 16, &mut [], TextOut::String(&mut log));
    assert!(log.contains("#extension GL_ARB_shader_stencil_export : enable"), "{log}");
}

/// Each of a pixel's samples has its own stencil, and the pixel's reference.
#[test]
fn a_written_reference_is_that_of_all_samples() {
    let mut c = context(16, 16);
    let object = framebuffer(&mut c);
    for (point, format) in
        [(GL_COLOR_ATTACHMENT0, GL_RGBA8), (GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8)]
    {
        let mut name = [0];
        c.gen_renderbuffers(1, &mut name);
        c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
        c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, format, 16, 16);
        c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name[0]);
    }
    c.clear(GL_STENCIL_BUFFER_BIT);
    c.enable(GL_STENCIL_TEST);
    c.stencil_op(GL_KEEP, GL_KEEP, GL_REPLACE);
    use_program(&mut c, "", EXPORT);
    rectangle(&mut c, ALL, 0.0);
    // What all samples hold is what passes at all of them.
    c.stencil_op(GL_KEEP, GL_KEEP, GL_KEEP);
    c.stencil_func(GL_EQUAL, 0, !0);
    c.clear(GL_COLOR_BUFFER_BIT);
    rectangle(&mut c, ALL, 0.0);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    let what = GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
    c.blit_framebuffer(0, 0, 16, 16, 0, 0, 16, 16, what, GL_NEAREST);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    let red = bytes(&mut c, [0, 0, 16, 16], GL_RED, 1);
    assert!(red.iter().all(|&red| red == 255), "{red:?}");
    for (at, got) in stencils(&mut c).into_iter().enumerate() {
        assert_eq!(got, exported(at), "{at}");
    }
    c.delete_framebuffers(1, &[object]);
}
