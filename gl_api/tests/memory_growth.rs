//! What is deleted gives its memory back: the process is as large after thousands of objects as after the first ones.
//! One test, as the memory is the process's.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;

/// Bytes of memory that the process has in use; `None` where the system does not say.
fn resident_bytes() -> Option<u64> {
    let statm = std::fs::read_to_string("/proc/self/statm").ok()?;
    // Pages of 4 KiB, or more on other machines: then the limit is the stricter one.
    Some(statm.split_whitespace().nth(1)?.parse::<u64>().ok()? * 4096)
}

fn context() -> Context {
    Context::new(ContextDesc { width: 16, height: 16, ..ContextDesc::default() }).expect("a device")
}

fn draw(c: &mut Context) {
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    c.finish();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
}

fn contexts(count: u32) {
    for _ in 0..count {
        let mut c = context();
        draw(&mut c);
        draw(
            &mut c
                .new_shared(ContextDesc { width: 16, height: 16, ..ContextDesc::default() })
                .expect("a context"),
        );
    }
}

fn textures(count: u32) {
    let mut c = context();
    let texels = vec![9; 64 * 64 * 4];
    c.enable(GL_TEXTURE_2D);
    for _ in 0..count {
        let mut name = [0];
        c.gen_textures(1, &mut name);
        c.bind_texture(GL_TEXTURE_2D, name[0]);
        let data = Data::Bytes(&texels);
        c.tex_image_2d(
            GL_TEXTURE_2D,
            0,
            GL_RGBA8 as i32,
            64,
            64,
            0,
            GL_RGBA,
            GL_UNSIGNED_BYTE,
            data,
        );
        draw(&mut c);
        c.delete_textures(1, &name);
    }
}

fn buffers(count: u32) {
    let mut c = context();
    for _ in 0..count {
        let mut name = [0];
        c.gen_buffers(1, &mut name);
        c.bind_buffer(GL_ARRAY_BUFFER, name[0]);
        c.buffer_data(GL_ARRAY_BUFFER, 4096, Data::Null, GL_STREAM_DRAW);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Null);
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.draw_arrays(GL_TRIANGLES, 0, 3);
        draw(&mut c);
        c.delete_buffers(1, &name);
    }
}

fn programs(count: u32) {
    let mut c = context();
    for number in 0..count {
        // Each another text, so that nothing that is kept of one serves the next.
        let fragment = format!("void main() {{ gl_FragColor = vec4({number}.0, 1.0, 0.0, 1.0); }}");
        let program = shading::use_program(&mut c, "", &fragment);
        draw(&mut c);
        let mut shaders = [0; 2];
        let mut attached = [0];
        c.get_attached_shaders(program, 2, &mut attached, &mut shaders);
        for &shader in &shaders[..attached[0] as usize] {
            c.delete_shader(shader);
        }
        c.use_program(0);
        c.delete_program(program);
    }
}

fn lists(count: u32) {
    let mut c = context();
    for _ in 0..count {
        let list = c.gen_lists(1);
        c.new_list(list, GL_COMPILE);
        c.color_3f(1.0, 0.0, 0.0);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        c.end_list();
        c.call_list(list);
        draw(&mut c);
        c.delete_lists(list, 1);
    }
}

/// The objects, how they are made and deleted, and how many of them.
type Case = (&'static str, fn(u32), u32);

#[test]
fn thousands_of_objects_leave_the_process_as_large_as_the_first_ones_did() {
    if resident_bytes().is_none() {
        eprintln!("skipped: this system has no /proc/self/statm");
        return;
    }
    let cases: &[Case] = &[
        ("contexts", contexts, 10_000),
        ("textures", textures, 10_000),
        ("buffers", buffers, 10_000),
        ("lists", lists, 10_000),
        ("programs", programs, 10_000),
    ];
    for (kind, make, count) in cases {
        // The first ones fill caches, and give the allocator the most memory that is in use at once.
        make(*count);
        let before = resident_bytes().expect("as above");
        // What the allocator keeps varies from round to round by a megabyte; a leak grows with every one.
        let mut rounds = (0..3).map(|_| {
            make(*count);
            resident_bytes().expect("as above")
        });
        let mut after = Vec::new();
        let is_as_before = rounds.any(|bytes| {
            after.push(bytes);
            bytes <= before + (1 << 20)
        });
        assert!(is_as_before, "{count} {kind}: {before} bytes, then {after:?}");
    }
}
