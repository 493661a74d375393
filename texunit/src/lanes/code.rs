//! Straight code over the 64 lanes of registers, as machine code that is made at run time.
//!
//! A [`Block`] is a list of steps whose operands are the results of earlier steps: what a run of instructions without
//! control flow computes. [`Code::compile`] assigns vector registers to them and encodes them for AVX2 or AVX-512; what
//! an interpreter loads and stores with each instruction stays in a vector register here. Each step is one operation of
//! IEEE 754 or on words, so that its bits are those of the same operation in a kernel.
//!
//! Code is safe by construction: it has no calls and no jump but that of the loop over the lanes, and addresses only the
//! registers and splats whose number [`Code::run`] checks.

// What compiling asks of a block.
#[cfg_attr(
    not(all(target_arch = "x86_64", not(miri))),
    allow(dead_code, reason = "nothing is compiled")
)]
mod block;
#[cfg(all(target_arch = "x86_64", not(miri)))]
mod compile;
#[cfg(all(target_arch = "x86_64", not(miri)))]
mod encode;
#[cfg(all(test, target_arch = "x86_64", not(miri)))]
mod safety;
#[cfg(test)]
mod tests;

pub use block::{Binary, Block, Compare, Rounding, Step, Unary, Value};

use super::{Isa, U32s};
#[cfg(all(target_arch = "x86_64", not(miri)))]
use std::sync::atomic::{AtomicUsize, Ordering};

/// The instruction set that code is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// 8 lanes to a vector register, 16 of these.
    Avx2,
    /// 16 lanes to a vector register, 32 of these.
    Avx512,
}

impl Target {
    /// How many there are: their numbers are smaller.
    pub const COUNT: usize = 2;

    /// That of an instruction set; `None` where shaders are interpreted.
    pub fn of(isa: Isa) -> Option<Self> {
        isa.code_target()
    }
}

/// The memory that holds code.
#[cfg(all(target_arch = "x86_64", not(miri)))]
#[derive(Debug)]
struct Mapping(memmap2::Mmap);

/// The mappings of a process that hold code. Beyond, there is no code: Linux lets a process have 65,530, and without them
/// its allocator fails. Neighbours are one to the system only until one between them goes.
#[cfg(all(target_arch = "x86_64", not(miri)))]
const MAX_MAPPINGS: usize = 1 << 14;

#[cfg(all(target_arch = "x86_64", not(miri)))]
static MAPPINGS: AtomicUsize = AtomicUsize::new(0);

#[cfg(all(target_arch = "x86_64", not(miri)))]
impl Mapping {
    /// Memory with these bytes, which can be executed and no longer be written.
    fn of(bytes: &[u8]) -> Option<Self> {
        let count = |mappings| (mappings < MAX_MAPPINGS).then_some(mappings + 1);
        MAPPINGS.fetch_update(Ordering::Relaxed, Ordering::Relaxed, count).ok()?;
        let map = || {
            let mut memory = memmap2::MmapMut::map_anon(bytes.len().max(1)).ok()?;
            memory.get_mut(..bytes.len())?.copy_from_slice(bytes);
            memory.make_exec().ok()
        };
        let made = map().map(Self);
        if made.is_none() {
            MAPPINGS.fetch_sub(1, Ordering::Relaxed);
        }
        made
    }
}

#[cfg(all(target_arch = "x86_64", not(miri)))]
impl Drop for Mapping {
    fn drop(&mut self) {
        MAPPINGS.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Machine code of several blocks.
#[derive(Debug)]
pub struct Code {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    memory: Mapping,
    /// By block: where its code begins.
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    entries: Vec<u32>,
    /// Registers that the code may address.
    registers: u32,
    /// Splats that the code may address.
    splats: u32,
}

impl Code {
    /// The code of `blocks` for this processor; `None` where there is no code generator for the instruction set, where
    /// the system refuses executable memory, where a process has code in very many places, or where a block needs more
    /// vector registers than can be spilled.
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    pub fn compile(isa: Isa, blocks: &[Block]) -> Option<Self> {
        let target = Target::of(isa)?;
        let mut bytes = Vec::new();
        let mut entries = Vec::with_capacity(blocks.len());
        for block in blocks {
            entries.push(u32::try_from(bytes.len()).ok()?);
            compile::compile(block, target, &mut bytes)?;
        }
        Some(Self {
            memory: Mapping::of(&bytes)?,
            entries,
            registers: blocks.iter().map(Block::registers).max().unwrap_or(0),
            splats: blocks.iter().map(Block::splats).max().unwrap_or(0),
        })
    }

    /// There is no code generator for this architecture.
    #[cfg(not(all(target_arch = "x86_64", not(miri))))]
    pub fn compile(_isa: Isa, _blocks: &[Block]) -> Option<Self> {
        None
    }

    /// Runs a block over 64 lanes. `mask` has the lanes of [`Step::Mask`].
    ///
    /// # Panics
    /// When there is no such block, or when registers or splats are fewer than the blocks address.
    #[inline]
    pub fn run(&self, block: usize, registers: &mut [U32s], splats: &[f32], mask: &U32s) {
        assert!(registers.len() >= self.registers as usize, "registers that code addresses");
        assert!(splats.len() >= self.splats as usize, "splats that code addresses");
        #[cfg(all(target_arch = "x86_64", not(miri)))]
        {
            type Entry = unsafe extern "sysv64" fn(*mut U32s, *const f32, *const U32s);
            let entry = self.entries[block] as usize;
            // SAFETY: `entry` is inside of the mapping, where `compile` has written a function of this signature for an
            // instruction set that this processor has. It addresses `self.registers` registers and `self.splats`
            // splats, which are there, and one mask; it keeps all that the calling convention asks for.
            unsafe {
                let entry: Entry = std::mem::transmute(self.memory.0.as_ptr().add(entry));
                entry(registers.as_mut_ptr(), splats.as_ptr(), mask);
            }
        }
        #[cfg(not(all(target_arch = "x86_64", not(miri))))]
        {
            let _ = (block, mask);
            unreachable!("there is no code without a code generator");
        }
    }
}
