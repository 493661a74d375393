//! The table of entry points against the Khronos registry, and calls as C writes them.

use gl_api::availability::{self, Api, Availability, Version};
use gl_api::description::{BeginEnd, DisplayList, EntryPoint};
use gl_api::*;
use std::collections::{BTreeMap, BTreeSet};

#[test]
fn every_entry_point_is_one_of_the_registry_with_as_many_parameters() {
    let registry: BTreeMap<&str, usize> = COMMANDS.iter().copied().collect();
    let mut seen = BTreeSet::new();
    for (name, arity) in implemented() {
        assert_eq!(registry.get(name), Some(&arity), "{name}");
        assert!(seen.insert(name), "{name} is there twice");
    }
}

#[test]
fn the_readme_counts_the_formats() {
    let readme = include_str!("../../README.md").replace('\n', " ");
    let formats = format!("in {} formats", texunit::format::Format::ALL.len());
    assert!(readme.contains(&formats), "README.md should say {formats:?}");
}

#[test]
fn values_have_the_names_that_one_expects() {
    for (value, name) in [
        (GL_TEXTURE_2D, "GL_TEXTURE_2D"),
        (GL_TEXTURE_CUBE_MAP, "GL_TEXTURE_CUBE_MAP"),
        (GL_LINEAR_MIPMAP_LINEAR, "GL_LINEAR_MIPMAP_LINEAR"),
        (GL_UNSIGNED_BYTE, "GL_UNSIGNED_BYTE"),
        (GL_FRAMEBUFFER, "GL_FRAMEBUFFER"),
        (GL_COLOR_ATTACHMENT0, "GL_COLOR_ATTACHMENT0"),
        (GL_DEPTH_COMPONENT24, "GL_DEPTH_COMPONENT24"),
        (GL_SRGB8_ALPHA8, "GL_SRGB8_ALPHA8"),
        (GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION"),
        (3, "3"),
    ] {
        assert_eq!(enum_name(value), name);
    }
}

#[test]
fn calls_compile_as_c_writes_them() {
    let desc = ContextDesc { width: 4, height: 4, ..ContextDesc::default() };
    let current = Context::new(desc).expect("a device").make_current();
    let (twidth, theight): (GLint, GLint) = (2, 2);
    let pixdata: Vec<[u8; 3]> = vec![[1, 2, 3]; 8];
    let mut h_texture: GLuint = 0;
    glActiveTexture(GL_TEXTURE0);
    glGenTextures(1, &mut h_texture);
    glBindTexture(GL_TEXTURE_2D, h_texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB, twidth, theight, 0, GL_RGB, GL_UNSIGNED_BYTE, &pixdata);
    glTexImage2D(GL_TEXTURE_2D, 0, 3, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
    let vertices = [[-1.0f32, -1.0], [3.0, -1.0], [-1.0, 3.0]];
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, &vertices);
    glColor4ub(255, 0, 0, 255);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, &[0u8, 1, 2]);
    let mut buffer: GLuint = 0;
    glGenBuffers(1, &mut buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, size_of_val(&vertices), &vertices, GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, BUFFER_OFFSET(0));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    let mut pixels = [[0u8; 4]; 16];
    glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixels);
    assert_eq!(pixels, [[255, 0, 0, 255]; 16]);
    glMultiTexCoord2f(GL_TEXTURE0, 0, 0.5);
    glLoadMatrixf(&[[1.0f32; 4]; 4]);
    glDepthMask(GL_FALSE);
    glDeleteTextures(1, &h_texture);
    assert_eq!(glGetError(), GL_NO_ERROR);
    let mut context = current.release().expect("it was current");
    let texts: Vec<String> = context.messages().iter().map(ToString::to_string).collect();
    assert!(texts.iter().all(|text| text.contains("texturing is off")), "{texts:?}");
}

#[test]
fn contexts_are_current_one_inside_the_other() {
    let make = |width| Context::new(ContextDesc { width, height: 1, ..ContextDesc::default() });
    let width = || with_current(|context| context.size().0);
    let outer = make(1).expect("a device").make_current();
    {
        let _inner = make(2).expect("a device").make_current();
        assert_eq!(width(), Some(2));
    }
    assert_eq!(width(), Some(1));
    assert_eq!(with_current(|_| width()), Some(None), "a call within a call has none");
    assert_eq!(outer.release().map(|context| context.size()), Some((1, 1)));
    assert_eq!(width(), None);
}

/// What the registry says of a command.
fn available(name: &str) -> Availability {
    availability::of(name).expect("a command of the registry")
}

#[test]
fn commands_are_where_the_registry_says() {
    let is_in =
        |name: &str, api, major, minor| available(name).is_in(api, Version::new(major, minor));
    for (name, api, without, with) in [
        ("glActiveTexture", Api::Compatibility, (1, 2), (1, 3)),
        ("glGenVertexArrays", Api::Core, (2, 1), (3, 2)),
        ("glGetPointerv", Api::Core, (4, 2), (4, 3)),
        ("glGenVertexArrays", Api::Es2, (2, 0), (3, 0)),
        ("glAlphaFuncx", Api::Es1, (0, 9), (1, 0)),
    ] {
        assert!(!is_in(name, api, without.0, without.1), "{name} {api:?} {without:?}");
        assert!(is_in(name, api, with.0, with.1), "{name} {api:?} {with:?}");
    }
    assert!(is_in("glBegin", Api::Compatibility, 4, 6));
    assert!(!is_in("glBegin", Api::Core, 3, 2) && !is_in("glBegin", Api::Es2, 3, 2));
    assert!(!is_in("glVertexP2ui", Api::Core, 3, 3), "of the compatibility profile alone");
    let brings = |name, api| available(name).extensions_of(api).collect::<Vec<_>>();
    assert_eq!(brings("glDrawArraysInstancedARB", Api::Core), ["GL_ARB_draw_instanced"]);
    assert!(brings("glDrawArraysInstancedARB", Api::Es2).is_empty());
    assert_eq!(availability::of("glNothing"), None);
}

#[test]
fn rows_say_what_is_allowed_and_compiled() {
    let row = |name: &str| {
        let is_named = |row: &&EntryPoint| row.names.iter().any(|known| known.name == name);
        table().find(is_named).expect("an entry point")
    };
    let blend = row("glBlendFunc");
    assert_eq!((blend.begin_end, blend.display_list), (BeginEnd::Refused, DisplayList::Compiled));
    let parameters: Vec<_> = blend.parameters.iter().map(|row| (row.name, row.ty)).collect();
    assert_eq!(parameters, [("sfactor", "GLenum"), ("dfactor", "GLenum")]);
    let color = row("glColor3ubv");
    assert_eq!((color.begin_end, color.display_list), (BeginEnd::Allowed, DisplayList::Compiled));
    for name in ["glGenLists", "glBindBufferARB", "glFlush"] {
        assert_eq!(row(name).display_list, DisplayList::NotCompiled, "{name}");
    }
    assert!(row("glVertexPointer").is_in(Api::Es1, Version::new(1, 0)));
}

/// A version or extension, and the commands that the registry says it brings.
type Chapter<'a> = (&'a str, Vec<&'a str>);

/// The chapters of the Khronos registry, in its order.
fn chapters(registry: &str) -> Vec<Chapter<'_>> {
    let attribute = |line: &'_ str, name: &str| -> Option<(usize, usize)> {
        let start = line.find(&format!(" {name}=\""))? + name.len() + 3;
        Some((start, start + line[start..].find('"')?))
    };
    let text = |line, name| attribute(line, name).map(|(start, end)| &line[start..end]);
    let mut chapters: Vec<Chapter<'_>> = Vec::new();
    let mut required = false;
    for line in registry.lines().map(str::trim) {
        let begins = line.starts_with("<feature ") || line.starts_with("<extension ");
        if begins && let Some(name) = text(line, "name") {
            chapters.push((name, Vec::new()));
        } else if line.starts_with("<require") {
            required = text(line, "api").is_none_or(|api| api == "gl");
        } else if line.starts_with("<remove") {
            required = false;
        } else if required
            && line.starts_with("<command ")
            && let (Some(name), Some((_, commands))) = (text(line, "name"), chapters.last_mut())
        {
            commands.push(name);
        }
    }
    chapters
}

/// The last version that is claimed.
const CLAIMED: &str = "GL_VERSION_3_1";

/// The page: of each version up to 3.3 and each claimed extension, what is there and what is not; which extensions
/// bring no commands; and how much of later versions is there.
fn page(registry: &str) -> String {
    let there: BTreeSet<&str> = implemented().map(|(name, _)| name).collect();
    let context = Context::new(ContextDesc { width: 1, height: 1, ..ContextDesc::default() });
    let mut c = context.expect("a device");
    let mut count = [0];
    c.get_integerv(GL_NUM_EXTENSIONS, &mut count);
    let claimed: BTreeSet<&str> =
        (0..count[0] as GLuint).map(|index| c.get_stringi(GL_EXTENSIONS, index)).collect();
    let mut text = String::from(
        "# Entry points\n\nGenerated from the Khronos registry by \
         `DETGL_BLESS=1 cargo test -p gl_api --test entries`. What is missing resolves to null.\n\n\
         | version or extension | there | of | missing |\n|---|---|---|---|\n",
    );
    let (mut lists, mut later, mut bare) = (String::new(), String::new(), Vec::new());
    for (name, commands) in chapters(registry) {
        let (has, lacks): (Vec<&str>, Vec<&str>) =
            commands.iter().partition(|command| there.contains(*command));
        let is_version = name.starts_with("GL_VERSION_") && !name.starts_with("GL_VERSION_ES");
        if is_version && name > CLAIMED {
            later += &format!("| {name} | {} | {} |\n", has.len(), commands.len());
        }
        if claimed.contains(name) && commands.is_empty() {
            bare.push(name);
        }
        let wanted = is_version && name <= CLAIMED || claimed.contains(name);
        if !wanted || commands.is_empty() {
            continue;
        }
        let quoted = |names: &[&str]| {
            names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
        };
        let (all, missing) = (commands.len(), quoted(&lacks));
        text += &format!("| {name} | {} | {all} | {missing} |\n", has.len());
        lists += &format!("\n## {name}\n\n{}\n", quoted(&has));
    }
    text += "\nLater versions are not claimed; some of their commands are there as extensions':\n\n\
             | version | there | of |\n|---|---|---|\n";
    text += &later;
    let bare: Vec<String> = bare.iter().map(|name| format!("`{name}`")).collect();
    text += &format!("\nExtensions without commands: {}.\n", bare.join(", "));
    text += &by_api(&there);
    text += &lists;
    text + &rows()
}

/// How much there is of each API's version, and what not.
fn by_api(there: &BTreeSet<&str>) -> String {
    let mut text = String::from(
        "\n## By API\n\nThe commands of a version without its extensions. Contexts are OpenGL 3.3's, core or compatibility; of \
         the others, the table says what their programs would find.\n\n\
         | API | there | of | missing |\n|---|---|---|---|\n",
    );
    for (title, api, version) in [
        ("OpenGL 3.3, compatibility", Api::Compatibility, Version::new(3, 3)),
        ("OpenGL 3.3, core", Api::Core, Version::new(3, 3)),
        ("OpenGL ES 2.0", Api::Es2, Version::new(2, 0)),
        ("OpenGL ES 3.0", Api::Es2, Version::new(3, 0)),
    ] {
        let commands = availability::registry().filter(|(_, found)| found.is_in(api, version));
        let (has, lacks): (Vec<&str>, Vec<&str>) =
            commands.map(|(name, _)| name).partition(|name| there.contains(name));
        let missing: Vec<String> = lacks.iter().map(|name| format!("`{name}`")).collect();
        let all = has.len() + lacks.len();
        text += &format!("| {title} | {} | {all} | {} |\n", has.len(), missing.join(", "));
    }
    text
}

/// Every row of the table.
fn rows() -> String {
    let mut text = String::from(
        "\n## Every entry point\n\nThe first version of each API that has it (the core profile begins with 3.2) or the extensions of OpenGL that do, whether \
         it is allowed between `glBegin` and `glEnd`, and whether display lists compile it.\n\n\
         | entry point | other names | compatibility | core | ES 1 | ES 2 and later | `glBegin` | lists |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    let version =
        |found: Option<Version>| found.map_or_else(String::new, |found| found.to_string());
    let mut all: Vec<&EntryPoint> = table().collect();
    all.sort_by_key(|row| row.names[0].name);
    for row in all {
        let (first, aliases) = row.names.split_first().expect("a row has a name");
        let aliases: Vec<String> = aliases.iter().map(|row| format!("`{}`", row.name)).collect();
        let found = first.availability;
        let core = found.core.filter(|core| core.removed_in.is_none()).map(|core| core.from);
        let allowed = match row.begin_end {
            BeginEnd::Allowed => "allowed",
            BeginEnd::Refused => "",
        };
        let compiled = match row.display_list {
            DisplayList::Compiled => "compiled",
            DisplayList::NotCompiled => "",
        };
        text += &format!(
            "| `{}` | {} | {} | {} | {} | {} | {allowed} | {compiled} |\n",
            first.name,
            aliases.join(", "),
            found.compatibility.map_or_else(
                || found.extensions_of(Api::Compatibility).collect::<Vec<_>>().join(", "),
                |version| version.to_string(),
            ),
            version(core.map(|from| from.max(Version::new(3, 2)))),
            version(found.es1),
            version(found.es2),
        );
    }
    text
}

#[test]
fn the_page_of_entry_points_is_up_to_date() {
    let page = page(&String::from_utf8_lossy(khronos_api::GL_XML));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/entry-points.md");
    if std::env::var_os("DETGL_BLESS").is_some() {
        std::fs::write(path, &page).expect("docs/ is writable");
    }
    let written = std::fs::read_to_string(path).unwrap_or_default();
    assert!(written == page, "docs/entry-points.md is old: run this with DETGL_BLESS=1");
}
