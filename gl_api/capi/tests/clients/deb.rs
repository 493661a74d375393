//! The package for Debian, unpacked as its system would: the command finds the libraries of its own folder.

use super::wheel::root;
use super::{folder, python_program, run, skip, source};
use std::path::Path;
use std::process::Command;

#[test]
fn a_debian_package_has_the_command_and_its_libraries() {
    let test = "deb";
    let folder = folder(test);
    for tool in [python_program(), "dpkg-deb".into(), "cc".into()] {
        if let Err(said) = run(Command::new(tool).arg("--version")) {
            return skip(test, &said);
        }
    }
    let built = Path::new(env!("CARGO_BIN_EXE_detgl")).parent().expect("a folder");
    let build = |out: &str| {
        let mut build = Command::new(python_program());
        build.arg(root().join("package/build_deb.py")).arg("--prebuilt").arg(built);
        build.arg("--compress=0").arg("--out").arg(folder.join(out));
        build.env("PYTHONDONTWRITEBYTECODE", "1");
        run(&mut build).unwrap_or_else(|said| panic!("{said}"));
        let mut files = std::fs::read_dir(folder.join(out)).expect("it is there");
        files.next().expect("a package").expect("readable").path()
    };
    let package = build("first");
    let [first, second] =
        [&package, &build("second")].map(|file| std::fs::read(file).expect("readable"));
    assert!(first == second, "the same libraries give another package");
    let tree = folder.join("root");
    let unpack = run(Command::new("dpkg-deb").arg("-x").arg(&package).arg(&tree));
    unpack.unwrap_or_else(|said| panic!("{said}"));
    let link = std::fs::read_link(tree.join("usr/bin/detgl")).expect("a link");
    assert_eq!(link, Path::new("/opt/detgl/bin/detgl"));
    let vendor = std::fs::read_to_string(tree.join("opt/detgl/lib/egl_vendor.json"));
    let vendor = vendor.expect("it is there");
    assert!(vendor.contains("\"/opt/detgl/lib/libdetgl.so\""), "{vendor}");
    let (prefix, program) = (tree.join("opt/detgl"), folder.join("draw"));
    let mut compile = Command::new("cc");
    compile.arg(source("osmesa.c")).arg("-o").arg(&program).arg("-I").arg(prefix.join("include"));
    compile.arg("-L").arg(prefix.join("lib")).args(["-lOSMesa", "-Wl,--allow-shlib-undefined"]);
    run(&mut compile).unwrap_or_else(|said| panic!("{said}"));
    // By a link, as in /usr/bin.
    let command = folder.join("detgl");
    std::os::unix::fs::symlink(prefix.join("bin/detgl"), &command).expect("the folder is writable");
    let drawn = run(Command::new(command).args(["run", "--"]).arg(&program));
    let drawn = drawn.unwrap_or_else(|said| panic!("{said}"));
    assert_eq!(String::from_utf8_lossy(&drawn.stdout), "DetGL 255 0 0 255\n");
}
