//! The program `window` on a screen of Xvfb, whose memory is a file: the frame is in it.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Ends the process when the test does.
struct Ended(Child);

impl Drop for Ended {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// The picture of a file of the format XWD (version 7, 32 bits a pixel): width, and pixels without their highest byte.
fn screen(path: &Path) -> Option<(usize, Vec<u32>)> {
    let bytes = std::fs::read(path).ok()?;
    let word = |at: usize| {
        let bytes = bytes.get(4 * at..4 * at + 4)?.try_into().ok()?;
        Some(u32::from_be_bytes(bytes) as usize)
    };
    let (header, width, height) = (word(0)?, word(4)?, word(5)?);
    let (row_bytes, colors) = (word(12)?, word(19)?);
    assert_eq!(
        (word(1)?, word(7)?, word(11)?),
        (7, 0, 32),
        "the lowest byte first, 32 bits a pixel"
    );
    let rows = bytes.get(header + 12 * colors..)?.chunks_exact(row_bytes).take(height);
    let pixel = |pixel: &[u8]| u32::from_le_bytes([pixel[0], pixel[1], pixel[2], 0]);
    Some((width, rows.flat_map(|row| row[..4 * width].chunks_exact(4)).map(pixel).collect()))
}

#[test]
fn a_frame_is_on_the_screen() {
    let folder = tempfile::tempdir().expect("a folder");
    let xvfb = Command::new("Xvfb")
        .args(["-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp", "-fbdir"])
        .arg(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn();
    let Ok(xvfb) = xvfb else {
        eprintln!(
            "skipped: Xvfb is missing (Debian: apt-get install xvfb libx11-xcb1 libxkbcommon-x11-0)"
        );
        return;
    };
    let mut xvfb = Ended(xvfb);
    let mut number = String::new();
    let out = xvfb.0.stdout.take().expect("a pipe");
    BufReader::new(out).read_line(&mut number).expect("the display's number");
    // What is drawn before the window is on the screen is lost.
    let window = Command::new(env!("CARGO_BIN_EXE_window"))
        .arg("30")
        .env("DISPLAY", format!(":{}", number.trim()))
        .env_remove("WAYLAND_DISPLAY")
        .spawn();
    let mut window = Ended(window.expect("it starts"));
    let path = folder.path().join("Xvfb_screen0");
    let start = Instant::now();
    // The background, below the left of the window's area; and in its middle red, green and blue are mixed.
    let is_shown = |width: usize, pixels: &[u32]| {
        let at = |x: usize, y: usize| pixels[y * width + x];
        let [red, green, blue] = [16, 8, 0].map(|shift| at(160, 130) >> shift & 255);
        at(2, 237) == 0x33_4D_66 && at(317, 2) == 0x33_4D_66 && red > 80 && green > 60 && blue > 60
    };
    loop {
        if screen(&path).is_some_and(|(width, pixels)| is_shown(width, &pixels)) {
            break;
        }
        let ended = window.0.try_wait().expect("its state");
        assert!(ended.is_none(), "the program has ended, and no frame was seen: {ended:?}");
        assert!(start.elapsed() < Duration::from_secs(60), "no frame is on the screen");
        std::thread::sleep(Duration::from_millis(20));
    }
    assert!(window.0.wait().expect("its state").success());
}
