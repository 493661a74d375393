//! The functions, by kind of sampler.

use super::textures::{Kind, Texels, depth};
use super::{Stage, context, run};
use gl_api::*;

/// What is asked of a kind of sampler. Coordinates move by one texel of level 0 per pixel, `d`.
struct Row {
    /// As it stands in the names of functions before 1.30, and of samplers.
    name: &'static str,
    target: GLenum,
    size: [i32; 3],
    /// The coordinates, layer included, without parentheses.
    coords: &'static str,
    /// The texel they lie in, of levels 0 and 1 (column, row, slice).
    texel: [[i32; 3]; 2],
    /// The same place with a q of 2, by constructor.
    projected: &'static [&'static str],
    /// An offset and the texels it leads to.
    offset: Option<(&'static str, [[i32; 3]; 2])>,
    /// A texel to fetch from level 1 (of a rectangle: 0).
    fetch: Option<(&'static str, [i32; 3])>,
    /// Derivatives whose λ is 1.
    gradient: &'static str,
    /// Whether the shadow form has a bias, and an explicit level.
    shadow: Shadow,
}

/// The levels that the shadow form of a sampler can be asked for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Shadow {
    None,
    Implicit,
    Derived,
    Biased,
    All,
}

const ROWS: &[Row] = &[
    Row {
        name: "1D",
        target: GL_TEXTURE_1D,
        size: [8, 1, 1],
        coords: "0.66 + d / 8.0",
        texel: [[5, 0, 0], [2, 0, 0]],
        projected: &["vec2(1.32 + d / 4.0, 2.0)", "vec4(1.32 + d / 4.0, 9.0, 9.0, 2.0)"],
        offset: Some(("-2", [[3, 0, 0], [0, 0, 0]])),
        fetch: Some(("3", [3, 0, 0])),
        gradient: "0.25, 0.0",
        shadow: Shadow::All,
    },
    Row {
        name: "2D",
        target: GL_TEXTURE_2D,
        size: [8, 4, 1],
        coords: "0.3 + d / 8.0, 0.6",
        texel: [[2, 2, 0], [1, 1, 0]],
        projected: &["vec3(0.6 + d / 4.0, 1.2, 2.0)", "vec4(0.6 + d / 4.0, 1.2, 9.0, 2.0)"],
        offset: Some(("ivec2(3, -1)", [[5, 1, 0], [3, 0, 0]])),
        fetch: Some(("ivec2(3, 1)", [3, 1, 0])),
        gradient: "vec2(0.25, 0.0), vec2(0.0)",
        shadow: Shadow::All,
    },
    Row {
        name: "3D",
        target: GL_TEXTURE_3D,
        size: [8, 4, 4],
        coords: "0.3 + d / 8.0, 0.6, 0.9",
        texel: [[2, 2, 3], [1, 1, 1]],
        projected: &["vec4(0.6 + d / 4.0, 1.2, 1.8, 2.0)"],
        offset: Some(("ivec3(-2, 1, -1)", [[0, 3, 2], [0, 1, 0]])),
        fetch: Some(("ivec3(3, 0, 1)", [3, 0, 1])),
        gradient: "vec3(0.0, 0.0, 0.5), vec3(0.0)",
        shadow: Shadow::None,
    },
    Row {
        name: "Cube",
        target: GL_TEXTURE_CUBE_MAP,
        size: [4, 4, 1],
        // The face -Y: s = x / 2 + 1/2, t = -z / 2 + 1/2 of (x, -1, z).
        coords: "-0.4 + d / 2.0, -1.0, -0.8",
        texel: [[1, 3, 3], [0, 1, 3]],
        projected: &[],
        offset: None,
        fetch: None,
        gradient: "vec3(1.0, 0.0, 0.0), vec3(0.0)",
        shadow: Shadow::Biased,
    },
    Row {
        name: "2DRect",
        target: GL_TEXTURE_RECTANGLE,
        size: [8, 4, 1],
        coords: "2.5 + d, 1.5",
        texel: [[2, 1, 0]; 2],
        projected: &["vec3(5.0 + d, 3.0, 2.0)", "vec4(5.0 + d, 3.0, 9.0, 2.0)"],
        offset: Some(("ivec2(2, 7)", [[4, 3, 0]; 2])),
        fetch: Some(("ivec2(6, 3)", [6, 3, 0])),
        gradient: "vec2(2.0, 0.0), vec2(0.0)",
        shadow: Shadow::Derived,
    },
    Row {
        name: "1DArray",
        target: GL_TEXTURE_1D_ARRAY,
        size: [8, 1, 3],
        coords: "0.3 + d / 8.0, 1.6",
        texel: [[2, 0, 2], [1, 0, 2]],
        projected: &[],
        offset: Some(("1", [[3, 0, 2], [2, 0, 2]])),
        fetch: Some(("ivec2(1, 2)", [1, 0, 2])),
        gradient: "0.25, 0.0",
        shadow: Shadow::All,
    },
    Row {
        name: "2DArray",
        target: GL_TEXTURE_2D_ARRAY,
        size: [8, 4, 3],
        coords: "0.3 + d / 8.0, 0.6, 0.7",
        texel: [[2, 2, 1], [1, 1, 1]],
        projected: &[],
        offset: Some(("ivec2(-8, 7)", [[0, 3, 1], [0, 1, 1]])),
        fetch: Some(("ivec3(2, 1, 2)", [2, 1, 2])),
        gradient: "vec2(0.0, 0.5), vec2(0.0)",
        shadow: Shadow::Derived,
    },
    Row {
        name: "CubeArray",
        target: GL_TEXTURE_CUBE_MAP_ARRAY,
        size: [4, 4, 18],
        // As of one cube; the face -Y is the fourth of the second cube.
        coords: "-0.4 + d / 2.0, -1.0, -0.8, 0.6",
        texel: [[1, 3, 9], [0, 1, 9]],
        projected: &[],
        offset: None,
        fetch: None,
        gradient: "vec3(1.0, 0.0, 0.0), vec3(0.0)",
        shadow: Shadow::Implicit,
    },
];

impl Row {
    /// The generations that have functions for it.
    fn names(&self) -> &'static [Names] {
        match self.target {
            GL_TEXTURE_CUBE_MAP_ARRAY => &[Names::Overloaded],
            _ => &[Names::ByKind, Names::Overloaded],
        }
    }
}

/// Where a lookup takes its level of detail from, and the level it comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Implicit,
    Bias,
    Lod,
    Grad,
}

const FORMS: [Form; 4] = [Form::Implicit, Form::Bias, Form::Lod, Form::Grad];

impl Form {
    fn infix(self) -> &'static str {
        match self {
            Self::Implicit | Self::Bias => "",
            Self::Lod => "Lod",
            Self::Grad => "Grad",
        }
    }

    /// The level that is read. Without neighbours λ is 0, with a bias 1.
    fn level(self) -> usize {
        match self {
            Self::Implicit => 0,
            Self::Bias | Self::Lod | Self::Grad => 1,
        }
    }

    /// The arguments behind coordinates: level or derivatives, offset, bias.
    fn arguments(self, row: &Row, offset: Option<&str>) -> String {
        let mut all = match self {
            Self::Implicit | Self::Bias => String::new(),
            Self::Lod => ", 1.0".into(),
            Self::Grad => format!(", {}", row.gradient),
        };
        if let Some(offset) = offset {
            all += &format!(", {offset}");
        }
        if self == Self::Bias {
            all += ", 1.0";
        }
        all
    }
}

/// The generations of names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Names {
    /// `texture2DProjLod`, with `EXT_gpu_shader4`.
    ByKind,
    /// `textureProjLod`, of 1.30.
    Overloaded,
}

impl Names {
    pub(super) fn preamble(self) -> &'static str {
        match self {
            Self::ByKind => {
                "#version 120\n#extension GL_EXT_gpu_shader4 : enable\n\
                 #extension GL_ARB_texture_rectangle : enable\n\
                 #extension GL_EXT_texture_array : enable"
            }
            Self::Overloaded => {
                "#version 130\n#extension GL_EXT_gpu_shader4 : enable\n\
                 #extension GL_ARB_texture_rectangle : enable\n\
                 #extension GL_ARB_texture_cube_map_array : enable"
            }
        }
    }

    /// `texture`, `shadow`, `texelFetch` or `textureSize` of this generation.
    fn of(self, function: &str, row: &Row) -> String {
        match (self, function) {
            (Self::ByKind, _) => format!("{function}{}", row.name),
            (Self::Overloaded, "shadow") => "texture".into(),
            (Self::Overloaded, _) => function.into(),
        }
    }
}

/// What went wrong in a table.
#[derive(Default)]
pub(super) struct Wrong(Vec<String>);

impl Wrong {
    pub(super) fn check(&mut self, what: &str, got: Result<[u8; 4], String>, want: [u8; 4]) {
        match got {
            Ok(got) if got == want => {}
            Ok(got) => self.0.push(format!("{what}: expected {want:?}, found {got:?}")),
            Err(log) => self.0.push(log),
        }
    }
}

impl Drop for Wrong {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            assert!(self.0.is_empty(), "{} wrong:\n{}", self.0.len(), self.0.join("\n"));
        }
    }
}

/// The bytes that stand for a texel.
pub(super) fn bytes([x, y, z]: [i32; 3], level: usize) -> [u8; 4] {
    [x as u8, y as u8, z as u8, level as u8]
}

/// The constructor for coordinates of so many components.
fn constructed(coords: &str) -> String {
    match coords.split(", ").count() {
        1 => format!("({coords})"),
        count => format!("vec{count}({coords})"),
    }
}

/// The coordinates with the offset or without, in all forms: coordinates, whether projected.
fn coordinates(row: &Row) -> Vec<(&'static str, String)> {
    let projected = row.projected.iter().map(|coords| ("Proj", (*coords).to_owned()));
    std::iter::once(("", constructed(row.coords))).chain(projected).collect()
}

/// Kind of texels, the letter of its samplers, and how a texel becomes fractions.
const KINDS: [(Kind, &str, &str); 3] = [
    (Kind::Float, "", "r = vec4(LOOKUP);"),
    (Kind::Int, "i", "r = vec4(-(LOOKUP + ivec4(1879048192))) / 255.0;"),
    (Kind::Uint, "u", "r = vec4(ivec4(LOOKUP - uvec4(2147483647) - uvec4(1))) / 255.0;"),
];

#[test]
fn samples() {
    let _current = context();
    let mut wrong = Wrong::default();
    for row in ROWS {
        let Row { target, size, .. } = *row;
        for (kind, letter, convert) in KINDS {
            let texels = Texels { target, size, kind };
            let sampler = format!("{letter}sampler{}", row.name);
            for &names in row.names() {
                for stage in [Stage::Fragment, Stage::Vertex] {
                    for form in FORMS {
                        let rect = target == GL_TEXTURE_RECTANGLE;
                        if rect && matches!(form, Form::Bias | Form::Lod)
                            || stage == Stage::Vertex && form == Form::Bias
                        {
                            continue;
                        }
                        let level = if rect { 0 } else { form.level() };
                        let unmoved = (None, "", row.texel[level]);
                        let moved = row
                            .offset
                            .map(|(offset, texels)| (Some(offset), "Offset", texels[level]));
                        for (proj, coords) in coordinates(row) {
                            for (offset, suffix, texel) in std::iter::once(unmoved).chain(moved) {
                                let name = names.of("texture", row) + proj + form.infix() + suffix;
                                let rest = form.arguments(row, offset);
                                let call = format!("{name}(s, {coords}{rest})");
                                let body = convert.replace("LOOKUP", &call);
                                let got = run(stage, names.preamble(), &sampler, &body, texels);
                                let what = format!("{stage:?} {sampler} {body}");
                                wrong.check(&what, got, bytes(texel, level));
                            }
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn comparisons() {
    let _current = context();
    let mut wrong = Wrong::default();
    for row in ROWS.iter().filter(|row| row.shadow != Shadow::None) {
        let Row { target, size, .. } = *row;
        let texels = Texels { target, size, kind: Kind::Depth };
        let sampler = format!("sampler{}Shadow", row.name);
        for &names in row.names() {
            for form in FORMS {
                let allowed = match form {
                    Form::Implicit => true,
                    Form::Grad => row.shadow != Shadow::Implicit,
                    Form::Bias => matches!(row.shadow, Shadow::Biased | Shadow::All),
                    Form::Lod => row.shadow == Shadow::All,
                };
                if !allowed {
                    continue;
                }
                let level = if target == GL_TEXTURE_RECTANGLE { 0 } else { form.level() };
                let mut lookups = vec![("", "", None, row.texel[level])];
                if let Some((offset, texels)) = row.offset {
                    lookups.push(("", "Offset", Some(offset), texels[level]));
                }
                if !row.projected.is_empty() {
                    lookups.push(("Proj", "", None, row.texel[level]));
                }
                for (proj, suffix, offset, texel) in lookups {
                    let [x, y, z] = texel;
                    let at = depth([x, y, z, level as i32]);
                    let name = names.of("shadow", row) + proj + form.infix() + suffix;
                    let rest = form.arguments(row, offset);
                    let lookup = |reference: f32| {
                        let coords = match (row.name, proj) {
                            ("1D", "") => format!("vec3({}, 9.0, {reference:?})", row.coords),
                            ("1D", _) => format!(
                                "vec4(2.0 * ({}), 9.0, {:?}, 2.0)",
                                row.coords,
                                2.0 * reference
                            ),
                            ("CubeArray", _) => format!("vec4({}), {reference:?}", row.coords),
                            (_, "") => constructed(&format!("{}, {reference:?}", row.coords)),
                            (_, _) => format!(
                                "vec4(2.0 * vec2({}), {:?}, 2.0)",
                                row.coords,
                                2.0 * reference
                            ),
                        };
                        let component = if names == Names::ByKind { ".r" } else { "" };
                        format!("{name}(s, {coords}{rest}){component}")
                    };
                    let body = format!(
                        "r = vec4({}, {}, 0.0, 1.0);",
                        lookup(at),
                        lookup(at + 1.0 / 131_072.0)
                    );
                    let got = run(Stage::Fragment, names.preamble(), &sampler, &body, texels);
                    wrong.check(&format!("{sampler} {body}"), got, [255, 0, 0, 255]);
                }
            }
        }
    }
}

#[test]
fn fetches_and_sizes() {
    let _current = context();
    let mut wrong = Wrong::default();
    for row in ROWS {
        let Row { target, size, .. } = *row;
        let rect = target == GL_TEXTURE_RECTANGLE;
        let level = usize::from(!rect);
        for (kind, letter, convert) in KINDS {
            let texels = Texels { target, size, kind };
            let sampler = format!("{letter}sampler{}", row.name);
            for &names in row.names() {
                for stage in [Stage::Fragment, Stage::Vertex] {
                    let mut check = |body: &str, want| {
                        let got = run(stage, names.preamble(), &sampler, body, texels);
                        wrong.check(&format!("{stage:?} {sampler} {body}"), got, want);
                    };
                    let lod = if rect { "" } else { ", 1" };
                    if let Some((at, texel)) = row.fetch {
                        let call = format!("{}(s, {at}{lod})", names.of("texelFetch", row));
                        check(&convert.replace("LOOKUP", &call), bytes(texel, level));
                        // From the neighbour, whose offset leads back.
                        let zero = ["0", "ivec2(0)", "ivec3(0)"];
                        let count = match row.name {
                            "1D" | "1DArray" => 0,
                            "3D" => 2,
                            _ => 1,
                        };
                        let one = zero[count].replace('0', "-1");
                        let moved = match row.name {
                            "1DArray" => format!("{at} + ivec2(1, 0)"),
                            "2DArray" => format!("{at} + ivec3(1, 1, 0)"),
                            _ => format!("{at} + 1"),
                        };
                        let name = names.of("texelFetch", row) + "Offset";
                        let call = format!("{name}(s, {moved}{lod}, {one})");
                        check(&convert.replace("LOOKUP", &call), bytes(texel, level));
                    }
                    let [width, height, depth] = texels.level_size(level as i32);
                    let (parts, sides): (&str, &[i32]) = match row.name {
                        "1D" => ("r = vec4(SIZE, 0, 0, 0) / 255.0;", &[width]),
                        "3D" | "2DArray" => ("r = vec4(SIZE, 0) / 255.0;", &[width, height, depth]),
                        "1DArray" => ("r = vec4(SIZE, 0, 0) / 255.0;", &[width, depth]),
                        "CubeArray" => ("r = vec4(SIZE, 0) / 255.0;", &[width, height, depth / 6]),
                        _ => ("r = vec4(SIZE, 0, 0) / 255.0;", &[width, height]),
                    };
                    let mut want = [0; 4];
                    for (want, side) in want.iter_mut().zip(sides) {
                        *want = *side as u8;
                    }
                    let call = format!("{}(s{lod})", names.of("textureSize", row));
                    check(&parts.replace("SIZE", &call), want);
                }
            }
        }
    }
}

/// A sampler chosen by what is not constant gives integers too.
#[test]
fn integers_come_through_arrays_of_samplers() {
    let _current = context();
    let texels = Texels { target: GL_TEXTURE_2D, size: [4, 4, 1], kind: Kind::Uint };
    let body =
        "uvec4 t = uvec4(0u); for (int i = 0; i < 2; ++i) t += texelFetch2D(list[i], ivec2(3, 2), 0);
                r = vec4(ivec4(t)) / 255.0;";
    // Twice 2^31 is 0.
    let preamble =
        "#version 120\n#extension GL_EXT_gpu_shader4 : enable\nuniform usampler2D list[2];";
    let got = run(Stage::Fragment, preamble, "sampler2D", body, texels);
    assert_eq!(got, Ok([6, 4, 0, 0]));
}

/// An incomplete texture gives 0, 0, 0, 1, of integers too.
#[test]
fn what_is_incomplete_is_opaque_black() {
    let _current = context();
    for (kind, sampler, body) in [
        (Kind::Float, "sampler2D", "r = texture(s, vec2(0.5));"),
        (Kind::Int, "isampler2D", "r = vec4(texture(s, vec2(0.5)));"),
        (Kind::Uint, "usampler2D", "r = vec4(texture(s, vec2(0.5)));"),
    ] {
        let texels = Texels { target: GL_TEXTURE_2D, size: [0, 0, 1], kind };
        let unbound = Texels { target: GL_TEXTURE_3D, size: [1, 1, 1], ..texels };
        let got = run(Stage::Fragment, "#version 130", sampler, body, unbound);
        assert_eq!(got, Ok([0, 0, 0, 255]), "{sampler}");
    }
}
