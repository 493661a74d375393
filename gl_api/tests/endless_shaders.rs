//! Shaders that do not end: the draw is left out soon, the same pixels on every machine, and the context goes on.

#[path = "common/cpu_time.rs"]
mod cpu_time;
#[path = "common/shading.rs"]
mod shading;

use cpu_time::CpuTime;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use shading::use_program;
use std::sync::Arc;
use std::time::Duration;
use texunit::lanes::Isa;

/// Half a second of two cores where it is compiled for speed; here, others run at the same time.
const SOON: Duration =
    if cfg!(debug_assertions) { Duration::from_secs(10) } else { Duration::from_secs(1) };

const TRIANGLE: [f32; 6] = [-1.0, -1.0, 3.0, -1.0, -1.0, 3.0];

fn context(size: u32, threads: usize, isa: Isa, draw_budget: Option<u64>) -> Context {
    let desc = DeviceDesc::new(isa, threads);
    let device = Some(Arc::new(Device::new(desc).expect("a device")));
    let desc =
        ContextDesc { width: size, height: size, device, draw_budget, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a context");
    let texels: Vec<u8> = (0..64 * 64 * 4).map(|at| (at * 7 % 251) as u8).collect();
    let ty = GL_UNSIGNED_BYTE;
    let (rgba, data) = (GL_RGBA as GLint, Data::Bytes(&texels));
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba, 64, 64, 0, GL_RGBA, ty, data);
    c.generate_mipmap(GL_TEXTURE_2D);
    c.tex_image_3d(GL_TEXTURE_3D, 0, rgba, 16, 16, 16, 0, GL_RGBA, ty, Data::Bytes(&texels));
    c.generate_mipmap(GL_TEXTURE_3D);
    for face in 0..6 {
        let target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
        c.tex_image_2d(target, 0, rgba, 32, 32, 0, GL_RGBA, ty, Data::Bytes(&texels[..4096]));
    }
    c.generate_mipmap(GL_TEXTURE_CUBE_MAP);
    for target in [GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP] {
        c.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR as GLint);
    }
    c.clear_color(0.0, 0.0, 1.0, 1.0);
    c
}

fn draw(c: &mut Context) {
    c.begin(GL_TRIANGLES);
    TRIANGLE.chunks(2).for_each(|at| c.vertex_2f(at[0], at[1]));
    c.end();
}

fn picture(c: &mut Context, size: u32) -> Vec<u8> {
    let mut pixels = vec![0; (size * size * 4) as usize];
    let side = size as GLsizei;
    c.read_pixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
    pixels
}

const VERTEX: &str = "void main() { gl_Position = gl_Vertex; }";
const STOPPED: &str = "so long that the rest of its draw was left out";

const ENDLESS: [(&str, &str); 9] = [
    ("empty", "void main() { while (true) ; gl_FragColor = vec4(1.0); }"),
    (
        "sums",
        "void main() { float s = 0.0; while (s < 2.0) s = fract(s + gl_FragCoord.x * 0.37);
         gl_FragColor = vec4(s); }",
    ),
    (
        "functions",
        "void main() { float s = 0.5; while (s < 20.0) s = sin(s * gl_FragCoord.x) + pow(abs(s), 1.7);
         gl_FragColor = vec4(s); }",
    ),
    (
        "lookups",
        "uniform sampler2D t; void main() { vec4 s = vec4(0.0);
         while (s.x < 20.0) s = texture2D(t, gl_FragCoord.xy * 0.013 + s.xy);
         gl_FragColor = s; }",
    ),
    (
        "anisotropic lookups",
        "uniform sampler2D t; void main() { vec4 s = vec4(0.0);
         while (s.x < 20.0) s = texture2D(t, gl_FragCoord.xy * vec2(0.4, 0.013) + s.xy);
         gl_FragColor = s; }",
    ),
    (
        "volumes",
        "uniform sampler3D t; void main() { vec4 s = vec4(0.0);
         while (s.x < 20.0) s = texture3D(t, gl_FragCoord.xyx * 0.013 + s.xyz);
         gl_FragColor = s; }",
    ),
    (
        "cubes",
        "uniform samplerCube t; void main() { vec4 s = vec4(0.0);
         while (s.x < 20.0) s = textureCube(t, gl_FragCoord.xyx * 0.013 - 2.0 + s.xyz);
         gl_FragColor = s; }",
    ),
    (
        "arrays",
        "void main() { float a[64]; int i = int(gl_FragCoord.x);
         while (a[i] < 1.0) { i = i > 50 ? 0 : i + 7; a[i] *= 0.5; } gl_FragColor = vec4(a[5]); }",
    ),
    (
        "above",
        "void main() { float s = 0.0; while (gl_FragCoord.y > SIZE * 0.7 && s < 2.0) s = fract(s + 0.37);
         gl_FragColor = vec4(s); }",
    ),
];

#[test]
fn they_end_soon_at_every_size() {
    for (name, source) in ENDLESS {
        for size in [64, 512, 1024] {
            let mut c = context(size, 2, Isa::best(), None);
            use_program(&mut c, VERTEX, &source.replace("SIZE", &format!("{size}.0")));
            if name.contains("anisotropic") {
                c.tex_parameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16.0);
            }
            c.clear(GL_COLOR_BUFFER_BIT);
            c.finish();
            let start = CpuTime::begin();
            draw(&mut c);
            c.finish();
            let elapsed = start.elapsed();
            println!("{name}, {size}: {elapsed:?}");
            assert!(elapsed < SOON, "{name}, {size}: {elapsed:?}");
            assert!(c.messages().iter().any(|m| m.text.contains(STOPPED)), "{name}, {size}");
            // The context goes on.
            use_program(&mut c, VERTEX, "void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }");
            draw(&mut c);
            assert!(picture(&mut c, size).chunks(4).all(|pixel| pixel == [0, 255, 0, 255]));
        }
    }
    let endless = "void main() { gl_Position = gl_Vertex; float s = 0.0;
        while (s < 2.0) s = fract(s + gl_Vertex.x * 0.37); gl_Position.x += s; }";
    let mut c = context(64, 2, Isa::best(), None);
    use_program(&mut c, endless, "void main() { gl_FragColor = vec4(1.0); }");
    let start = CpuTime::begin();
    draw(&mut c);
    c.finish();
    let elapsed = start.elapsed();
    println!("vertices: {elapsed:?}");
    assert!(elapsed < SOON, "{elapsed:?}");
    assert!(c.messages().iter().any(|m| m.text.contains(STOPPED)));
}

/// Of a draw that ends at some pixels, what is drawn depends on neither threads nor instruction set. Draws before and
/// after it are there.
#[test]
fn what_is_left_of_a_draw_is_the_same_everywhere() {
    const SIZE: u32 = 832;
    let source = "uniform sampler2D t; void main() {
        float s = 0.0;
        bool ends = mod(gl_FragCoord.x, 97.0) > 1.0 || gl_FragCoord.y < 300.0;
        for (int i = 0; !ends || i < int(gl_FragCoord.x); i++)
            s = fract(s + texture2D(t, vec2(s, gl_FragCoord.x)).x + 0.37);
        gl_FragColor = vec4(s, 1.0, 0.0, 1.0); }";
    let mut all = Vec::new();
    let ways =
        Isa::executions().into_iter().flat_map(|isa| [1, 2, 8].map(|threads| (isa, threads)));
    for (isa, threads) in ways {
        let mut c = context(SIZE, threads, isa, Some(1 << 21));
        c.clear(GL_COLOR_BUFFER_BIT);
        c.enable(GL_BLEND);
        c.blend_func(GL_ONE, GL_ONE);
        use_program(&mut c, VERTEX, source);
        draw(&mut c);
        draw(&mut c);
        use_program(&mut c, VERTEX, "void main() { gl_FragColor = vec4(0.125); }");
        draw(&mut c);
        all.push(picture(&mut c, SIZE));
        assert!(c.messages().iter().any(|m| m.text.contains(STOPPED)));
    }
    let [first, others @ ..] = &all[..] else { panic!("no instruction set") };
    assert!(others.iter().all(|other| other == first));
    // Something of the draw, not all of it, and all of the last.
    let green = first.chunks(4).filter(|pixel| pixel[1] > 200).count();
    assert!(green > 0 && green < (SIZE * SIZE) as usize, "{green}");
    assert!(first.chunks(4).all(|pixel| pixel[2] == 255 && pixel[1] >= 32));
}

/// A loop that is long and ends is no endless one, whatever the size of the draw.
#[test]
fn long_loops_are_drawn() {
    let (size, steps) = if cfg!(debug_assertions) { (128, 500) } else { (1024, 500) };
    let source = format!(
        "uniform sampler2D t; void main() {{ vec3 p = vec3(gl_FragCoord.xy * 0.001, 0.1); float s = 0.0;
         for (int i = 0; i < {steps}; i++) {{
             p += normalize(p) * 0.01; s += texture2D(t, p.xy + p.z).x * exp(-p.z) * 0.001; }}
         gl_FragColor = vec4(s + 0.5, 1.0, 0.0, 1.0); }}"
    );
    // Without a budget it is not stopped either: what each batch may run for free is enough.
    for budget in [None, Some(0)] {
        let mut c = context(size, 2, Isa::best(), budget);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR as GLint);
        use_program(&mut c, VERTEX, &source);
        let start = CpuTime::begin();
        draw(&mut c);
        c.finish();
        println!("{steps} steps at {size}: {:?}", start.elapsed());
        assert!(picture(&mut c, size).chunks(4).all(|pixel| pixel[1] == 255));
        assert!(c.messages().is_empty(), "{:?}", c.messages());
    }
}

#[test]
fn a_context_has_its_own_budget() {
    let source = "void main() { int i = 0; while (i < 1000000) i += 1 + int(gl_FragCoord.x) / 5000;
         gl_FragColor = vec4(i == 1000000 ? 1.0 : 0.0); }";
    for (budget, is_drawn) in [(0, false), (u64::MAX, true)] {
        let mut c = context(8, 1, Isa::best(), Some(budget));
        c.clear(GL_COLOR_BUFFER_BIT);
        use_program(&mut c, VERTEX, source);
        draw(&mut c);
        let white = picture(&mut c, 8).chunks(4).all(|pixel| pixel == [255; 4]);
        assert_eq!(white, is_drawn);
        assert_eq!(c.messages().is_empty(), is_drawn);
    }
}

#[test]
fn a_context_that_asks_for_notifications_is_told_once_of_a_stopped_draw() {
    let desc = ContextDesc {
        width: 16,
        height: 16,
        draw_budget: Some(1000),
        reset_notification: ResetNotification::LoseContextOnReset,
        ..ContextDesc::default()
    };
    let mut other = Context::new(ContextDesc { draw_budget: Some(1000), ..ContextDesc::default() })
        .expect("a context");
    let mut c = Context::new(desc).expect("a context");
    let (mut strategy, mut is_robust) = ([0], [0]);
    c.get_integerv(GL_RESET_NOTIFICATION_STRATEGY, &mut strategy);
    c.get_integerv(GL_CONTEXT_ROBUST_ACCESS, &mut is_robust);
    assert_eq!((strategy[0] as GLenum, is_robust), (GL_LOSE_CONTEXT_ON_RESET, [1]));
    other.get_integerv(GL_RESET_NOTIFICATION_STRATEGY, &mut strategy);
    assert_eq!(strategy[0] as GLenum, GL_NO_RESET_NOTIFICATION);
    assert_eq!(c.get_graphics_reset_status(), GL_NO_ERROR);
    for (context, told) in [(&mut c, GL_GUILTY_CONTEXT_RESET), (&mut other, GL_NO_ERROR)] {
        use_program(context, VERTEX, ENDLESS[0].1);
        draw(context);
        assert_eq!(context.get_graphics_reset_status(), told);
        assert_eq!(context.get_graphics_reset_status(), GL_NO_ERROR);
    }
    // It can be used further.
    c.use_program(0);
    c.color_3f(1.0, 0.0, 0.0);
    draw(&mut c);
    assert_eq!(picture(&mut c, 16)[..4], [255, 0, 0, 255]);
    assert_eq!((c.get_graphics_reset_status(), c.get_error()), (GL_NO_ERROR, GL_NO_ERROR));
}

/// What the first draw compiles takes as little time as what it runs: loops in loops, with arrays that each may write.
#[test]
fn programs_of_nested_loops_and_arrays_are_compiled_soon() {
    for (depth, length, stores) in [(100, 4, 1), (60, 4000, 4), (100, 30_000, 1), (20, 16_000, 20)]
    {
        let mut body = "s += 1.0;".to_owned();
        for level in 0..depth {
            let stores: String = (0..stores)
                .map(|at| format!("a[i{level} + {at}] = s; s += a[i{level} * {at}];"))
                .collect();
            body =
                format!("for (int i{level} = 0; i{level} < n; i{level}++) {{ {stores} {body} }}");
        }
        let fragment = format!(
            "uniform int n; void main() {{ float a[{length}]; float s = 0.0; a[n] = 1.0; {body} gl_FragColor = vec4(s, 1.0, 0.0, 1.0); }}"
        );
        let mut c = context(8, 2, Isa::best(), None);
        let start = CpuTime::begin();
        use_program(&mut c, "void main() { gl_Position = gl_Vertex; }", &fragment);
        let linked = start.elapsed();
        draw(&mut c);
        c.finish();
        let all = start.elapsed();
        println!("{depth} loops, {length} words, {stores} stores: link {linked:?}, all {all:?}");
        assert!(all < SOON, "{depth} loops, {length} words: link {linked:?}, all {all:?}");
        assert_eq!(picture(&mut c, 8)[..4], [0, 255, 0, 255]);
    }
}
