//! Attributes whose fourth component is 1 at all vertices are read as three: pictures are those of arrays with four.

#[path = "common/random.rs"]
mod random;

use gl_api::*;
use random::Random;

const SIZE: u32 = 32;

/// How the triangles are drawn.
#[derive(Clone, Copy, Debug)]
enum DrawMethod {
    Immediate,
    List,
    /// Arrays of four components.
    Arrays,
}

/// A triangle: positions, and the texture coordinates that are set before them.
type Triangle = [([f32; 4], Option<[f32; 4]>); 3];

/// Triangles whose q is 1 at none, some or all vertices, also at those that come before the first coordinates.
fn triangles(random: &mut Random) -> (Vec<Triangle>, [f32; 4]) {
    let all: &[f32] = random.pick(&[&[1.0][..], &[1.0], &[1.0, 1.0, 0.5], &[0.5, 2.0]]);
    let coordinates = |random: &mut Random| {
        let q = random.pick(all);
        [random.float(), random.float(), 0.0, q]
    };
    let before = [0.25, 0.75, 0.0, random.pick(&[1.0, 1.0, 0.5])];
    let count = 1 + random.below(3);
    let triangles = (0..count).map(|_| {
        [0, 1, 2].map(|at| {
            let position = [random.float(), random.float(), 0.5 * random.float(), 1.0];
            let is_set = at == 2 || random.below(3) > 0;
            (position, is_set.then(|| coordinates(random)))
        })
    });
    (triangles.collect(), before)
}

fn picture(triangles: &[Triangle], before: [f32; 4], method: DrawMethod) -> Vec<u8> {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    let texels: Vec<u8> = (0..8 * 8 * 4).map(|at| (at * 37 % 251) as u8).collect();
    c.tex_image_2d(
        GL_TEXTURE_2D,
        0,
        GL_RGBA as i32,
        8,
        8,
        0,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        Data::Bytes(&texels),
    );
    c.generate_mipmap(GL_TEXTURE_2D);
    c.enable(GL_TEXTURE_2D);
    c.tex_coord_4fv(&before);
    match method {
        DrawMethod::Immediate => calls(&mut c, triangles),
        DrawMethod::List => {
            c.new_list(1, GL_COMPILE);
            calls(&mut c, triangles);
            c.end_list();
            c.call_list(1);
        }
        DrawMethod::Arrays => {
            let (mut positions, mut coordinates) = (Vec::new(), Vec::new());
            let mut current = before;
            for &(position, set) in triangles.iter().flatten() {
                current = set.unwrap_or(current);
                positions.extend(position);
                coordinates.extend(current);
            }
            let bytes = size_of_val(&positions[..]);
            positions.extend(coordinates);
            let both: Vec<u8> = positions.iter().flat_map(|number| number.to_ne_bytes()).collect();
            c.bind_buffer(GL_ARRAY_BUFFER, 1);
            c.buffer_data(GL_ARRAY_BUFFER, both.len() as isize, Data::Bytes(&both), GL_STATIC_DRAW);
            c.vertex_pointer(4, GL_FLOAT, 0, Data::Offset(0));
            c.tex_coord_pointer(4, GL_FLOAT, 0, Data::Offset(bytes));
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.enable_client_state(GL_TEXTURE_COORD_ARRAY);
            c.draw_arrays(GL_TRIANGLES, 0, 3 * triangles.len() as i32);
        }
    }
    let mut bytes = vec![0; (SIZE * SIZE * 4) as usize];
    c.read_pixels(
        0,
        0,
        SIZE as i32,
        SIZE as i32,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        DataOut::Bytes(&mut bytes),
    );
    assert_eq!(c.get_error(), GL_NO_ERROR);
    bytes
}

/// A `glBegin` and `glEnd` for each triangle.
fn calls(c: &mut Context, triangles: &[Triangle]) {
    for triangle in triangles {
        c.begin(GL_TRIANGLES);
        for (position, set) in triangle {
            if let Some(coordinates) = set {
                c.tex_coord_4fv(coordinates);
            }
            c.vertex_4fv(position);
        }
        c.end();
    }
}

#[test]
fn pictures_are_those_of_four_components() {
    let mut drawn = 0;
    for seed in 0..300 {
        let (triangles, before) = triangles(&mut Random(seed));
        let want = picture(&triangles, before, DrawMethod::Arrays);
        drawn += usize::from(want.iter().any(|&byte| byte != 0));
        for method in [DrawMethod::Immediate, DrawMethod::List] {
            let found = picture(&triangles, before, method);
            let different = found.iter().zip(&want).filter(|(a, b)| a != b).count();
            assert_eq!(different, 0, "seed {seed}, {method:?}: {triangles:?} after {before:?}");
        }
    }
    assert!(drawn > 200, "{drawn}");
}
