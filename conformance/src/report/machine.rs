//! What the figures were measured on.

use serde::Serialize;
use std::fmt;

/// The machine, as far as it matters for times.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// The architecture, and the processor's name where the system tells it.
    pub processor: String,
    /// The instruction set that is drawn with.
    pub isa: &'static str,
    /// The threads that draw.
    pub threads: usize,
    /// How many processes were running or waiting, on the mean of the last minute, if the system tells.
    pub load: Option<f64>,
}

impl Machine {
    /// This machine.
    pub fn here() -> Self {
        let (isa, threads) = match gl_api::host::context_info() {
            Ok(info) => (info.isa, info.threads),
            Err(_) => ("unknown instruction set", 0),
        };
        let name = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split_once(':')?.1.trim().to_owned())
        });
        let arch = std::env::consts::ARCH;
        let processor = name.map_or(arch.to_owned(), |name| format!("{arch}, {name}"));
        let load = std::fs::read_to_string("/proc/loadavg")
            .ok()
            .and_then(|text| text.split_whitespace().next()?.parse().ok());
        Self { processor, isa, threads, load }
    }

    /// A warning if other processes take part of the processors.
    fn busy(&self) -> Option<String> {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let load = self.load.filter(|&load| load > 1.25 * processors as f64)?;
        Some(format!("the machine is busy (load {load:.1} on {processors} processors)"))
    }

    /// Warnings about times: a busy machine, and `noisy` of `of` rows whose rounds spread by more
    /// than [`NOISY`].
    pub fn warnings(&self, noisy: usize, of: usize) -> Option<String> {
        let spread = (noisy > 0).then(|| {
            let percent = 100.0 * NOISY;
            format!("{noisy} of {of} rows spread by more than {percent:.0} % over their rounds")
        });
        let warnings: Vec<String> = self.busy().into_iter().chain(spread).collect();
        (!warnings.is_empty()).then(|| format!("noisy times: {}", warnings.join(";\n  ")))
    }
}

/// A spread of rounds above this makes a time noisy.
pub const NOISY: f64 = 0.1;

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { processor, isa, threads, .. } = self;
        let word = if *threads == 1 { "thread" } else { "threads" };
        write!(f, "{processor}; {isa}, {threads} {word}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_said() {
        let machine =
            |load| Machine { processor: "x86_64".to_owned(), isa: "avx2", threads: 2, load };
        assert_eq!(machine(Some(0.0)).warnings(0, 9), None);
        let said = machine(Some(1e6)).warnings(2, 9).unwrap_or_default();
        assert!(said.contains("busy") && said.contains("2 of 9 rows"), "{said}");
        assert!(said.lines().all(|line| line.len() <= 100), "{said}");
        assert_eq!(machine(None).to_string(), "x86_64; avx2, 2 threads");
    }
}
