//! `detgl run -- PROGRAM`: runs a program on DetGL instead of the system's OpenGL.
//! `detgl doctor`: prints what programs load.
//! `detgl install DIR`: lays the library out under the names that programs and loaders look for.

#[cfg(all(unix, not(target_vendor = "apple")))]
mod doctor;
#[cfg(all(unix, not(target_vendor = "apple")))]
mod facade;
#[cfg(all(unix, not(target_vendor = "apple")))]
mod layout;
#[cfg(all(unix, not(target_vendor = "apple")))]
mod pipe;
#[cfg(all(unix, not(target_vendor = "apple")))]
mod probe;
#[cfg(all(unix, not(target_vendor = "apple")))]
mod run;
#[cfg(all(unix, not(target_vendor = "apple")))]
use {doctor::report, layout::install, pipe::end_with_reader, probe::probe, run::run};

#[cfg(not(all(unix, not(target_vendor = "apple"))))]
mod elsewhere;
#[cfg(not(all(unix, not(target_vendor = "apple"))))]
use elsewhere::{end_with_reader, install, probe, report, run};

use clap::{Args, Parser, Subcommand};
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

/// Shown at the end of `detgl --help`.
const EXAMPLES: &str = "\
Examples:
  detgl run -- python3 draw.py             runs a program on DetGL
  DETGL_DEBUG=1 detgl run -- ./app         prints every error and warning to stderr
  DETGL_THREADS=1 detgl run -- ./app       draws with one thread
  detgl run --glu -- ./app                 takes GLU from DetGL too
  detgl install /opt/detgl                 lays the library out; then:
  LD_LIBRARY_PATH=/opt/detgl ./app         runs without this command
  cc app.c -L/opt/detgl -lOSMesa -o app    links with it
";

/// DetGL in place of libEGL, libGL, libOpenGL and libOSMesa.
#[derive(Parser)]
#[command(name = "detgl", version, about, after_help = EXAMPLES)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Runs a program on DetGL: `detgl run -- python3 draw.py`.
    Run {
        #[command(flatten)]
        glu: OwnGlu,
        /// The program and its arguments.
        #[arg(required = true, trailing_var_arg = true, allow_hyphen_values = true)]
        program: Vec<OsString>,
    },
    /// Prints what programs load, in which order, and which contexts they can make: for reports of bugs.
    Doctor,
    /// What `doctor` runs in processes of their own.
    #[command(hide = true)]
    Probe,
    /// Lays the library out in a folder, for LD_LIBRARY_PATH or `cc -L`.
    Install {
        #[command(flatten)]
        glu: OwnGlu,
        /// No symbolic links, and no path of this machine: for archives, and to be moved. Not for `cc -L`.
        #[arg(long)]
        no_links: bool,
        /// The library to copy, in place of the one beside this program: one that was built for another machine.
        #[arg(long, value_name = "FILE")]
        library: Option<PathBuf>,
        /// The folder; it is made if need be.
        dir: PathBuf,
    },
}

/// Whose libGLU programs get.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Glu {
    /// The system's, if there is one; it works on top of this library.
    System,
    /// This library, which has GLU's functions itself.
    Own,
}

/// What the names without a version are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Links {
    /// Links to those with a version, as linkers want them.
    Symbolic,
    /// Files, with SONAMEs of their own, for programs that load these names.
    None,
}

#[derive(Args)]
struct OwnGlu {
    /// In place of libGLU too; without it programs keep the system's, which also has a tessellator
    /// and NURBS.
    #[arg(long)]
    glu: bool,
}

impl OwnGlu {
    fn choice(&self) -> Glu {
        if self.glu { Glu::Own } else { Glu::System }
    }
}

fn main() -> ExitCode {
    end_with_reader();
    let result = match Arguments::parse().task {
        Task::Run { glu, program } => run(&program, glu.choice()),
        Task::Doctor => report(),
        Task::Probe => probe(),
        Task::Install { glu, no_links, library, dir } => {
            let links = if no_links { Links::None } else { Links::Symbolic };
            install(&dir, glu.choice(), links, library.as_deref()).map(|()| {
                println!("DetGL is in {0}: LD_LIBRARY_PATH={0} PROGRAM", dir.display());
            })
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("detgl: {error}");
            ExitCode::FAILURE
        }
    }
}
