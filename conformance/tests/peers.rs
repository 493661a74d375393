//! The comparison with other drivers, once and small, against the library that cargo built along.

use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// What `peers` prints as JSON; `None` where DetGL's shared library was not built.
fn compared(only: &str) -> Result<Option<Value>, Box<dyn std::error::Error>> {
    let program = Path::new(env!("CARGO_BIN_EXE_conformance"));
    let folder = program.parent().ok_or("a program is in a folder")?;
    if !["", "deps"].iter().any(|name| folder.join(name).join("libdetgl.so").is_file()) {
        println!("skipped: there is no libdetgl.so beside {}", program.display());
        return Ok(None);
    }
    let arguments = ["peers", "--size", "64", "--rounds", "1", "--json", "--only", only];
    let output = Command::new(program).args(arguments).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    Ok(Some(serde_json::from_slice(&output.stdout)?))
}

/// Of each scene DetGL's picture and time; beside it, its largest RMS error in steps of a byte.
fn have_the_formulas_picture(table: &[(&str, f64)]) -> Result<(), Box<dyn std::error::Error>> {
    for (scene, bound) in table {
        let Some(found) = compared(scene)? else { return Ok(()) };
        let rows = found["rows"].as_array().ok_or("rows")?;
        let ours = rows.iter().find(|row| row["driver"] == "DetGL" && row["scene"] == *scene);
        let ours = ours.ok_or("DetGL is always measured")?;
        let rms = ours["error"]["rms"].as_f64().ok_or("a number")?;
        assert!(rms <= *bound, "{scene}: {rms}");
        assert!(ours["frame_ms"].as_f64() > Some(0.0), "{scene}");
    }
    Ok(())
}

#[test]
fn textures_have_the_formulas_picture() -> Result<(), Box<dyn std::error::Error>> {
    have_the_formulas_picture(&[
        ("bilinear", 0.05),
        ("trilinear-floor", 0.05),
        ("eight-layers", 0.05),
        ("mipmaps", 0.0),
    ])
}

#[test]
fn shaders_and_copies_have_the_formulas_picture() -> Result<(), Box<dyn std::error::Error>> {
    have_the_formulas_picture(&[
        ("clear", 0.0),
        ("wood", 0.05),
        ("lit-fogged-mesh", 0.1),
        ("upload-read", 0.0),
    ])
}
