//! Primitives that wait for more of their kind are drawn with the state of their `glEnd`: the same calls with and without
//! a `glFlush` after each primitive, which has nothing wait, give the same picture. Nor does it matter then which primitives
//! others hide, or whether anything is left out at all.

use gl_api::constants::*;
use gl_api::context::{Context, ContextDesc};
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc, LeaveOut};
use std::sync::Arc;

const SIDE: usize = 64;

/// Numbers by a linear congruence.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    fn unit(&mut self) -> f32 {
        self.below(256) as f32 / 255.0
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }
}

fn switch(random: &mut Random) {
    let cap = random.of(&[
        GL_BLEND,
        GL_DEPTH_TEST,
        GL_SCISSOR_TEST,
        GL_CULL_FACE,
        GL_ALPHA_TEST,
        GL_STENCIL_TEST,
        GL_TEXTURE_2D,
        GL_LIGHTING,
        GL_LIGHT0,
        GL_FOG,
        GL_COLOR_LOGIC_OP,
        GL_CLIP_PLANE0,
        GL_COLOR_MATERIAL,
        GL_COLOR_SUM,
        GL_POLYGON_STIPPLE,
        GL_NORMALIZE,
    ]);
    match random.below(2) {
        0 => glEnable(cap),
        _ => glDisable(cap),
    }
}

/// Changes a matrix; pops what was pushed, or finds nothing to pop.
fn matrix(random: &mut Random) {
    glMatrixMode(random.of(&[GL_MODELVIEW, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE]));
    match random.below(6) {
        0 => glLoadIdentity(),
        1 => glPushMatrix(),
        2 => glTranslatef(random.of(&[0.0, 0.25]), random.of(&[0.0, -0.25]), 0.0),
        3 => glScalef(1.0, random.of(&[1.0, -1.0]), 1.0),
        4 => glMultMatrixf(&[1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0.25, 0., 0., 0., 1.0f32]),
        _ => glPopMatrix(),
    }
}

/// Pushes or pops attributes.
fn groups(random: &mut Random) {
    let mask = random.of(&[
        GL_ALL_ATTRIB_BITS,
        GL_ENABLE_BIT,
        GL_CURRENT_BIT,
        GL_LIGHTING_BIT,
        GL_TEXTURE_BIT,
        GL_FOG_BIT,
        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
        GL_TRANSFORM_BIT | GL_VIEWPORT_BIT | GL_POLYGON_BIT,
    ]);
    match random.below(2) {
        0 => glPushAttrib(mask),
        _ => glPopAttrib(),
    }
}

/// Changes light, fog or an environment, or sets what is set.
fn shade(random: &mut Random) {
    let fraction = random.of(&[0.25f32, 1.0]);
    match random.below(12) {
        0 => glLightfv(GL_LIGHT0, GL_POSITION, &[0.0, fraction, 1.0, 0.0]),
        1 => glLightfv(GL_LIGHT0, GL_DIFFUSE, &[fraction, 1.0, 1.0, 1.0]),
        2 => glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, &[0.5, 1.0, 0.5, fraction]),
        3 => glMaterialfv(GL_BACK, GL_AMBIENT, &[fraction, 0.5, 0.0, 1.0]),
        4 => glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, random.below(2) as i32),
        5 => glFogi(GL_FOG_MODE, random.of(&[GL_LINEAR, GL_LINEAR, GL_EXP]) as i32),
        6 => glFogf(GL_FOG_START, random.of(&[0.25, 2.0, 2.0])),
        7 => glFogf(GL_FOG_END, random.of(&[1.0, 4.0, 4.0])),
        8 => glFogfv(GL_FOG_COLOR, &[fraction, 0.5, 1.0, 1.0]),
        9 => glTexEnvi(
            GL_TEXTURE_ENV,
            GL_TEXTURE_ENV_MODE,
            random.of(&[GL_MODULATE, GL_REPLACE]) as i32,
        ),
        10 => glPolygonStipple(&random.of(&[[0xffu8; 128], [0x3c; 128]])),
        _ => glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
    }
}

fn set(random: &mut Random) {
    let compares = [GL_ALWAYS, GL_LESS, GL_GEQUAL, GL_NEVER, GL_LEQUAL, GL_NOTEQUAL];
    let factors =
        [GL_ONE, GL_ZERO, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_COLOR, GL_CONSTANT_COLOR];
    let side = SIDE as u64;
    match random.below(38) {
        22..26 => matrix(random),
        26..28 => groups(random),
        28..34 => shade(random),
        0 => glDepthFunc(random.of(&compares)),
        1 => glDepthMask(random.below(2) == 0),
        2 => glAlphaFunc(random.of(&compares), random.unit()),
        3 => glBlendFunc(random.of(&factors), random.of(&factors)),
        4 => glBlendColor(random.unit(), random.unit(), random.unit(), random.unit()),
        5 => glScissor(random.below(side) as i32, random.below(side) as i32, 40, 40),
        6 => glViewport(random.below(8) as i32, random.below(8) as i32, SIDE, SIDE - 8),
        7 => glDepthRange(random.unit(), random.unit()),
        8 => glCullFace(random.of(&[GL_FRONT, GL_BACK])),
        9 => glFrontFace(random.of(&[GL_CW, GL_CCW])),
        10 => glShadeModel(random.of(&[GL_FLAT, GL_SMOOTH])),
        11 => glStencilFunc(random.of(&compares), random.below(4) as i32, 3),
        12 => glStencilOp(
            GL_KEEP,
            random.of(&[GL_INCR, GL_KEEP]),
            random.of(&[GL_REPLACE, GL_INVERT]),
        ),
        13 => glColorMask(random.below(2) == 0, true, random.below(2) == 0, true),
        14 => glLogicOp(random.of(&[GL_COPY, GL_XOR, GL_INVERT])),
        15 => glPolygonMode(GL_FRONT_AND_BACK, random.of(&[GL_FILL, GL_LINE])),
        16 => glBindTexture(GL_TEXTURE_2D, random.below(3) as u32),
        17 => glSecondaryColor3f(random.of(&[0.0, 0.5]), 0.0, 0.0),
        18 => glActiveTexture(GL_TEXTURE0 + random.below(2) as u32),
        19 => glLineWidth(1.0 + random.below(3) as f32),
        // Refused: nothing changes.
        20 => glDepthFunc(GL_TEXTURE_2D),
        _ => switch(random),
    }
}

fn query(random: &mut Random) {
    let mut values = [0i32; 16];
    match random.below(3) {
        0 => glGetIntegerv(random.of(&[GL_VIEWPORT, GL_DEPTH_FUNC, GL_SCISSOR_BOX]), &mut values),
        1 => drop(glIsEnabled(GL_BLEND)),
        _ => drop(glGetError()),
    }
}

fn triangle(random: &mut Random) {
    // Some cover the whole picture.
    let scale = random.of(&[1.0, 1.0, 8.0]);
    let is_opaque = random.below(2) == 0;
    glBegin(GL_TRIANGLES);
    for _ in 0..3 {
        let alpha = if is_opaque { 1.0 } else { random.unit() };
        glColor4f(random.unit(), random.unit(), random.unit(), alpha);
        glTexCoord2f(random.unit(), random.unit());
        let mut at = || scale * (2.0 * random.unit() - 1.0);
        glVertex3f(at(), at(), at());
    }
    glEnd();
}

/// The picture of 60 calls.
fn picture(seed: u64, after_primitive: fn(), leave_out: LeaveOut) -> Vec<u8> {
    let desc = DeviceDesc { leave_out, ..DeviceDesc::from_env().expect("a valid environment") };
    let device = Some(Arc::new(Device::new(desc).expect("threads start")));
    let (width, height) = (SIDE as u32, SIDE as u32);
    let desc = ContextDesc { width, height, device, ..ContextDesc::default() };
    let _current = Context::new(desc).expect("a device").make_current();
    for name in [1u32, 2] {
        glBindTexture(GL_TEXTURE_2D, name);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        let texels: Vec<u8> = (0..64).map(|at| (at * 37 * name) as u8).collect();
        let format = [GL_RGBA, GL_RGB][name as usize - 1];
        glTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    let mut random = Random(seed);
    for _ in 0..60 {
        match random.below(5) {
            0 | 1 => {
                triangle(&mut random);
                after_primitive();
            }
            2 | 3 => set(&mut random),
            _ => query(&mut random),
        }
    }
    let mut bytes = vec![0u8; SIDE * SIDE * 4];
    glReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
    bytes
}

#[test]
fn primitives_that_wait_are_drawn_with_the_state_of_their_end() {
    let mut drawn = 0;
    for seed in 0..300 {
        let waiting = picture(seed, || {}, LeaveOut::WithoutEffect);
        let others = [(glFlush as fn(), LeaveOut::WithoutEffect), (|| {}, LeaveOut::Nothing)];
        for (after_primitive, leave_out) in others {
            let other = picture(seed, after_primitive, leave_out);
            let different = waiting.iter().zip(&other).position(|(a, b)| a != b);
            assert_eq!(different, None, "seed {seed}: first byte that differs, {leave_out:?}");
        }
        drawn += usize::from(waiting.iter().any(|byte| *byte != 0));
    }
    assert!(drawn > 200, "only {drawn} pictures show anything");
}
