//! Random calls and shaders by seeds. `tests/bounded.rs` runs a fixed number of them, the program `fuzz-run` as many as it
//! is asked for; a seed makes the same calls in both.
//!
//! The devices of [`devices`] draw the same bits: an optimizing one, one that interprets its shaders, one of the plainest
//! instruction set, one that leaves nothing out, and one of a single thread.

#[path = "../../bodies/calls.rs"]
mod calls;
#[path = "../../bodies/context.rs"]
mod context;
#[path = "../../bodies/es_shader.rs"]
mod es_shader;
#[path = "../../bodies/random.rs"]
mod random;

use context::{context_of, context_on, device, picture, still_works};
use gl_api::exercise::{self, Exercise, exercises};
use gl_api::{Api, Context, GL_RENDER};
use random::Random;
use rasterizer::driver::{DeviceDesc, LeaveOut};
use std::ops::{AddAssign, Range};
use texunit::lanes::Isa;

/// What a run did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Calls of entry points with random arguments. Those that make a context, or look whether it works, do not count.
    pub calls: u64,
    /// Shaders that were compiled.
    pub shaders: u64,
    /// Pictures that were compared with another device's.
    pub pictures: u64,
    /// Of these, those that have more than one colour.
    pub varied: u64,
}

/// Counts a comparison of a picture.
fn compared(picture: &[u8]) -> Done {
    let is_varied = picture.chunks(4).any(|pixel| *pixel != picture[..4]);
    Done { pictures: 1, varied: is_varied.into(), ..Done::default() }
}

impl AddAssign for Done {
    fn add_assign(&mut self, other: Self) {
        self.calls += other.calls;
        self.shaders += other.shaders;
        self.pictures += other.pictures;
        self.varied += other.varied;
    }
}

/// What is run, by seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Every entry point of the table, with arguments by type.
    Table,
    /// Calls that fit together, with arguments that mostly do.
    Calls,
    /// Both, by contexts of one group on several threads at a time.
    Group,
    /// Both, on every device: the pictures are equal.
    Devices,
    /// Shaders of a grammar, on every device: they are refused everywhere, or their pictures are equal.
    Shaders,
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Table, Self::Calls, Self::Group, Self::Devices, Self::Shaders];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Table => "table",
            Self::Calls => "calls",
            Self::Group => "group",
            Self::Devices => "devices",
            Self::Shaders => "shaders",
        }
    }

    /// Runs the seeds.
    ///
    /// # Panics
    /// Where a call does, where a context does not work afterwards, or where two devices draw differently. The seed is
    /// printed.
    pub fn run(self, seeds: Range<u64>) -> Done {
        let all = entries();
        let mut done = Done::default();
        for seed in seeds {
            let named = NamedSeed { target: self, seed };
            done += match self {
                Self::Table => table(&all, seed),
                Self::Calls => calls(seed),
                Self::Group => group(&all, seed),
                Self::Devices => on_devices(&all, seed),
                Self::Shaders => shaders(seed),
            };
            std::mem::forget(named);
        }
        done
    }
}

/// Says which seed it was, should it panic.
struct NamedSeed {
    target: Target,
    seed: u64,
}

impl Drop for NamedSeed {
    fn drop(&mut self) {
        eprintln!("target {}, seed {}", self.target.name(), self.seed);
    }
}

/// The entry points of the table. Indirect draws take their counts from buffers of random bytes: billions of vertices,
/// of which `endless_draws.rs` has a test.
fn entries() -> Vec<Exercise> {
    let mut all = exercises();
    all.retain(|exercise| !exercise.name.ends_with("Indirect"));
    all
}

fn api(seed: u64) -> Api {
    match seed % 4 {
        0 | 1 => Api::Compatibility,
        2 => Api::Core,
        _ => Api::Es2,
    }
}

/// Devices that draw the same bits.
fn devices() -> Vec<DeviceDesc> {
    let best = device(Isa::best());
    vec![
        best,
        device(Isa::best().interpreting()),
        device(Isa::BASELINE),
        DeviceDesc { leave_out: LeaveOut::Nothing, ..best },
        DeviceDesc { threads: 1, ..best },
    ]
}

fn make_table_calls(
    c: &mut Context,
    all: &[Exercise],
    random: &mut exercise::Random<'_>,
    count: usize,
) -> Done {
    for number in 0..count {
        // What begins a primitive or a list would swallow most of the rest.
        if number % 16 == 0 {
            c.end();
            c.end_list();
        }
        (all[random.below(all.len())].run)(c, random);
    }
    Done { calls: count as u64, ..Done::default() }
}

fn make_calls(c: &mut Context, random: &mut Random<'_>, count: usize) -> Done {
    calls::make_calls(c, random, count);
    Done { calls: count as u64, ..Done::default() }
}

/// Ends what calls may have left open.
fn end_all(c: &mut Context) {
    c.end();
    c.end_list();
    c.render_mode(GL_RENDER);
    c.end_conditional_render();
    c.end_transform_feedback();
}

fn table(all: &[Exercise], seed: u64) -> Done {
    let mut c = context_on(api(seed), device(Isa::best()));
    let done = make_table_calls(&mut c, all, &mut exercise::Random::new(seed, &[]), 2000);
    end_all(&mut c);
    still_works(&mut c);
    done
}

fn calls(seed: u64) -> Done {
    let mut c = context_on(api(seed), device(Isa::best()));
    let done = make_calls(&mut c, &mut Random::new(seed, &[]), 2000);
    end_all(&mut c);
    still_works(&mut c);
    done
}

fn group(all: &[Exercise], seed: u64) -> Done {
    const THREADS: u64 = 3;
    let first = context_of(Api::Compatibility);
    let shared =
        |_| first.new_shared(gl_api::ContextDesc { width: 40, height: 30, ..Default::default() });
    let others: Vec<Context> = (1..THREADS).map(|at| shared(at).expect("a context")).collect();
    let mut done = Done::default();
    std::thread::scope(|scope| {
        let contexts = (0..).zip(std::iter::once(first).chain(others));
        let threads: Vec<_> = contexts
            .map(|(number, mut c)| {
                let seed = seed * THREADS + number;
                scope.spawn(move || {
                    let mut done = Done::default();
                    let mut random = exercise::Random::new(seed, &[]);
                    for part in 0..10 {
                        done += make_calls(&mut c, &mut Random::new(seed + part, &[]), 50);
                        done += make_table_calls(&mut c, all, &mut random, 50);
                    }
                    end_all(&mut c);
                    still_works(&mut c);
                    done
                })
            })
            .collect();
        for thread in threads {
            done += thread.join().expect("its panic was printed");
        }
    });
    done
}

/// The picture of the default framebuffer after each part of the calls, on every device.
fn on_devices(all: &[Exercise], seed: u64) -> Done {
    let mut done = Done::default();
    let run = |desc: DeviceDesc, done: &mut Done| -> Vec<Vec<u8>> {
        let mut c = context_on(api(seed), desc);
        let mut random = exercise::Random::new(seed, &[]);
        let parts = (0..4).map(|part| {
            *done += make_calls(&mut c, &mut Random::new(4 * seed + part, &[]), 150);
            *done += make_table_calls(&mut c, all, &mut random, 50);
            end_all(&mut c);
            picture(&mut c)
        });
        parts.collect()
    };
    let devices = devices();
    let first = run(devices[0], &mut done);
    for &desc in &devices[1..] {
        let other = run(desc, &mut done);
        for (part, (first, other)) in first.iter().zip(&other).enumerate() {
            assert!(first == other, "seed {seed}, part {part}: {desc:?} draws another picture");
            done += compared(first);
        }
    }
    done
}

fn shaders(seed: u64) -> Done {
    const SHADERS: u64 = 10;
    let mut done = Done::default();
    let run = |desc: DeviceDesc, done: &mut Done| {
        let mut c = context_on(Api::Es2, desc);
        let drawn = (0..SHADERS).map(|number| {
            let source = es_shader::shader(&mut Random::new(SHADERS * seed + number, &[]));
            done.shaders += 1;
            (es_shader::draw(&mut c, &source), picture(&mut c), source)
        });
        drawn.collect::<Vec<_>>()
    };
    let devices = devices();
    let first = run(devices[0], &mut done);
    for &desc in &devices[1..] {
        for (first, other) in first.iter().zip(run(desc, &mut done)) {
            assert!(*first == other, "{desc:?} draws another picture of\n{}", other.2);
            done += compared(&first.1);
        }
    }
    done
}
