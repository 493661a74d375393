//! A program in an environment in which its loader finds the library.

use super::{Glu, layout};
use std::ffi::OsString;
use std::io;
use std::os::unix::process::CommandExt;
use std::process::Command;

/// The variables by which clients choose between EGL and OSMesa. One that is set stays, and the
/// others follow it, as clients that go through PyOpenGL need both to agree.
const PLATFORMS: [&str; 2] = ["PYOPENGL_PLATFORM", "MUJOCO_GL"];

/// Becomes the program; comes back only with an error.
pub fn run(program: &[OsString], glu: Glu) -> io::Result<()> {
    let [name, arguments @ ..] = program else {
        return Err(io::Error::other("no program was named: detgl run -- PROGRAM"));
    };
    let mut command = Command::new(name);
    command.args(arguments);
    prepare(&mut command, glu)?;
    let error = command.exec();
    Err(io::Error::new(error.kind(), format!("{}: {error}", name.display())))
}

/// Sets a program's environment.
pub fn prepare(command: &mut Command, glu: Glu) -> io::Result<()> {
    let folder = layout::folder_for_programs()?;
    let before = std::env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let others = std::env::split_paths(&before).filter(|path| !path.as_os_str().is_empty());
    let path = layout::search_path(&folder, glu).into_iter().chain(others);
    command.env("LD_LIBRARY_PATH", std::env::join_paths(path).map_err(io::Error::other)?);
    command.env("__EGL_VENDOR_LIBRARY_FILENAMES", folder.join(layout::VENDOR_FILE));
    let platform = PLATFORMS.iter().find_map(std::env::var_os).unwrap_or_else(|| "egl".into());
    for variable in PLATFORMS {
        if std::env::var_os(variable).is_none() {
            command.env(variable, &platform);
        }
    }
    Ok(())
}
