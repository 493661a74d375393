//! The Python wheel, as somebody gets it who has Python and nothing else: built of this library, installed in a fresh
//! environment, its own tests, and each program of `examples/python`.

use super::{folder, python_program, run, skip};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A fresh environment in which the wheel is installed; says why there is none.
struct Environment {
    folder: PathBuf,
}

impl Environment {
    fn new(folder: PathBuf) -> Result<Self, String> {
        let wheels = folder.join("wheels");
        let built = Path::new(env!("CARGO_BIN_EXE_detgl")).parent().expect("a folder");
        let mut wheel = Command::new(python_program());
        wheel.args(["-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir"]);
        wheel.arg(&wheels).arg(root().join("python"));
        wheel.arg(format!("--config-settings=prebuilt={}", built.display()));
        // An environment has pip, the Python that makes it need not.
        let environment = Self { folder };
        run(Command::new(python_program())
            .args(["-m", "venv"])
            .arg(environment.folder.join("venv")))?;
        run(wheel.env("PYTHONDONTWRITEBYTECODE", "1")).map_err(|said| {
            if said.contains("No module named pip") { said } else { panic!("{said}") }
        })?;
        let mut files = std::fs::read_dir(&wheels).expect("pip made it");
        let file = files.next().expect("a wheel").expect("readable").path();
        // It would not be manylinux if the library needed more than glibc.
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        assert!(name.contains("-py3-none-manylinux_") || !cfg!(target_env = "gnu"), "{name}");
        let mut install = environment.python();
        install.args(["-m", "pip", "install", "--no-index", "--no-deps"]).arg(&file);
        run(&mut install).unwrap_or_else(|said| panic!("{said}"));
        Ok(environment)
    }

    fn program(&self, name: &str) -> Command {
        let mut command = Command::new(self.folder.join("venv/bin").join(name));
        for variable in ["MUJOCO_GL", "PYOPENGL_PLATFORM", "DETGL_THREADS", "DETGL_ISA"] {
            command.env_remove(variable);
        }
        command.env("PYTHONDONTWRITEBYTECODE", "1");
        command
    }

    fn python(&self) -> Command {
        self.program("python")
    }

    /// What a program of `examples/python` prints.
    fn example(&self, name: &str, arguments: &[&Path], threads: &str) -> String {
        let mut command = self.python();
        command.arg(root().join("examples/python").join(name)).args(arguments);
        let output =
            run(command.env("DETGL_THREADS", threads)).unwrap_or_else(|said| panic!("{said}"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!said.contains("that nobody read"), "{name}: {said}");
        String::from_utf8_lossy(&output.stdout).into_owned()
    }

    fn pytest(&self, tests: &str) {
        let mut command = self.python();
        command.args(["-m", "pytest", "-q", "-p", "no:cacheprovider"]).arg(root().join(tests));
        run(&mut command).unwrap_or_else(|said| panic!("{said}"));
    }
}

/// The folder of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("it is there")
}

#[test]
fn the_wheel_runs_its_examples_in_a_fresh_environment() {
    let test = "wheel";
    let environment = match Environment::new(folder(test)) {
        Ok(environment) => environment,
        Err(said) => return skip(test, &said),
    };
    let output = run(environment.program("detgl").arg("--version")).expect("it is installed");
    let version = format!("detgl {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(String::from_utf8_lossy(&output.stdout), version);

    let requirements = root().join("examples/python/requirements.txt");
    let mut install = environment.python();
    install.args(["-m", "pip", "install", "--retries", "0", "-r"]).arg(requirements);
    if let Err(said) = run(&mut install) {
        return skip(&format!("{test}: examples/python"), &said);
    }
    environment.pytest("python/tests");
    environment.pytest("examples/python");
    // Ray is 90 MB, and takes half a minute to start.
    match std::env::var_os("DETGL_TEST_RAY") {
        None => skip(&format!("{test}: ray_frames.py"), "set DETGL_TEST_RAY=1 to fetch ray"),
        Some(_) => {
            let mut install = environment.python();
            run(install.args(["-m", "pip", "install", "ray"]))
                .unwrap_or_else(|said| panic!("{said}"));
            let printed = environment.example("ray_frames.py", &[], "1");
            assert_eq!(printed.matches("the digests of this one").count(), 2, "{printed}");
        }
    }
    for (example, picture) in [("mujoco_frame.py", true), ("gymnasium_digest.py", false)] {
        let out = environment.folder.join(example).with_extension("png");
        let arguments = if picture { vec![out.as_path()] } else { Vec::new() };
        let printed = environment.example(example, &arguments, "1");
        assert_eq!(printed.trim().len(), 64, "{printed}");
        assert_eq!(printed, environment.example(example, &arguments, "3"));
    }
}
