//! `detgl run -- PROGRAM`: runs a program on DetGL instead of the system's OpenGL.
//! `detgl install DIR`: lays the library out under the names that programs and loaders look for.

mod layout;

use clap::{Args, Parser, Subcommand};
use layout::Glu;
use std::ffi::OsString;
use std::io;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// DetGL in place of libEGL, libGL, libOpenGL and libOSMesa.
#[derive(Parser)]
#[command(version, about)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Runs a program on DetGL: `detgl run -- python3 draw.py`.
    Run {
        #[command(flatten)]
        library: Library,
        /// The program and its arguments.
        #[arg(required = true, trailing_var_arg = true, allow_hyphen_values = true)]
        program: Vec<OsString>,
    },
    /// Lays the library out in a folder, for LD_LIBRARY_PATH or `cc -L`.
    Install {
        #[command(flatten)]
        library: Library,
        /// The folder; it is made if need be.
        dir: PathBuf,
    },
}

#[derive(Args)]
struct Library {
    /// In place of libGLU too; without it programs keep the system's, which also has a tessellator
    /// and NURBS.
    #[arg(long)]
    glu: bool,
}

impl Library {
    fn glu(&self) -> Glu {
        if self.glu { Glu::Own } else { Glu::System }
    }
}

fn main() -> ExitCode {
    let result = match Arguments::parse().task {
        Task::Run { library, program } => run(&program, library.glu()),
        Task::Install { library, dir } => layout::install(&dir, library.glu()).map(|()| {
            println!("DetGL is in {0}: LD_LIBRARY_PATH={0} PROGRAM", dir.display());
        }),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("detgl: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The variables by which clients choose between EGL and OSMesa. One that is set stays, and the
/// others follow it, as clients that go through PyOpenGL need both to agree.
const PLATFORMS: [&str; 2] = ["PYOPENGL_PLATFORM", "MUJOCO_GL"];

/// Becomes the program; comes back only with an error.
fn run(program: &[OsString], glu: Glu) -> io::Result<()> {
    let [name, arguments @ ..] = program else {
        return Err(io::Error::other("no program was named: detgl run -- PROGRAM"));
    };
    let folder = layout::private_folder(glu)?;
    layout::install(&folder, glu)?;
    let mut command = Command::new(name);
    command.args(arguments).env("LD_LIBRARY_PATH", library_path(&folder)?);
    command.env("__EGL_VENDOR_LIBRARY_FILENAMES", folder.join(layout::VENDOR_FILE));
    let platform = PLATFORMS.iter().find_map(std::env::var_os).unwrap_or_else(|| "egl".into());
    for variable in PLATFORMS {
        if std::env::var_os(variable).is_none() {
            command.env(variable, &platform);
        }
    }
    let error = command.exec();
    Err(io::Error::new(error.kind(), format!("{}: {error}", name.display())))
}

/// The folder before those that LD_LIBRARY_PATH has already.
fn library_path(folder: &Path) -> io::Result<OsString> {
    let before = std::env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let others = std::env::split_paths(&before).filter(|path| !path.as_os_str().is_empty());
    std::env::join_paths(std::iter::once(folder.to_owned()).chain(others)).map_err(io::Error::other)
}
