//! The instructions of AVX2 and AVX-512 that the steps need.

use super::Target;
use super::block::{Binary, Compare, Rounding, Unary};
use crate::lanes::LANES;
use iced_x86::{Code, Encoder, IcedError, Instruction, MemoryOperand, Register};

/// A vector register of the processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vector(pub u8);

/// Where an operand is in memory, relative to the lanes that the loop is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    Register(u32),
    Splat(u32),
    Mask,
    /// A slot on the stack.
    Spill(u32),
}

/// The second operand of an operation.
#[derive(Clone, Copy, Debug)]
pub enum Source {
    Vector(Vector),
    Memory(Location),
}

impl Target {
    /// Vector registers of the processor.
    pub fn vectors(self) -> u8 {
        match self {
            Self::Avx2 => 16,
            Self::Avx512 => 32,
        }
    }

    /// Lanes of a vector register.
    pub fn lanes(self) -> usize {
        match self {
            Self::Avx2 => 8,
            Self::Avx512 => 16,
        }
    }
}

/// Appends instructions.
pub struct Assembler {
    target: Target,
    encoder: Encoder,
    length: u64,
}

/// Bytes of a vector of 64 words.
const BATCH: i64 = 4 * LANES as i64;

impl Assembler {
    pub fn new(target: Target) -> Self {
        Self { target, encoder: Encoder::new(64), length: 0 }
    }

    fn push(&mut self, instruction: Result<Instruction, IcedError>) -> Option<()> {
        self.length += self.encoder.encode(&instruction.ok()?, self.length).ok()? as u64;
        Some(())
    }

    fn register(&self, Vector(number): Vector) -> Register {
        let number = u32::from(number);
        match self.target {
            Target::Avx2 => Register::YMM0 + number,
            Target::Avx512 => Register::ZMM0 + number,
        }
    }

    fn bytes(&self) -> i64 {
        4 * self.target.lanes() as i64
    }

    fn memory(&self, location: Location) -> MemoryOperand {
        let (base, offset, is_broadcast) = match location {
            Location::Register(register) => (Register::RDI, BATCH * i64::from(register), false),
            Location::Splat(splat) => (Register::RSI, 4 * i64::from(splat), true),
            Location::Mask => (Register::RDX, 0, false),
            Location::Spill(slot) => (Register::RSP, self.bytes() * i64::from(slot), false),
        };
        let displacement_size = u32::from(offset != 0);
        MemoryOperand::new(
            base,
            Register::None,
            1,
            offset,
            displacement_size,
            is_broadcast && self.target == Target::Avx512,
            Register::None,
        )
    }

    /// Whether an operation can read the operand from memory itself.
    pub fn folds(&self, location: Location) -> bool {
        match (self.target, location) {
            (Target::Avx2, Location::Splat(_)) => false,
            (Target::Avx2 | Target::Avx512, _) => true,
        }
    }

    /// The beginning of a function with so many spill slots, and of the loop over its lanes; gives the loop's address.
    pub fn begin(&mut self, spills: u32) -> Option<u64> {
        if spills > 0 {
            let size = (self.bytes() * i64::from(spills)) as i32;
            self.push(Instruction::with2(Code::Sub_rm64_imm32, Register::RSP, size))?;
        }
        let rounds = (LANES / self.target.lanes()) as i32;
        self.push(Instruction::with2(Code::Mov_r32_imm32, Register::ECX, rounds))?;
        Some(self.length)
    }

    /// The end of the loop, and of the function.
    pub fn end(mut self, head: u64, spills: u32) -> Option<Vec<u8>> {
        let bytes = self.bytes() as i32;
        self.push(Instruction::with2(Code::Add_rm64_imm32, Register::RDI, bytes))?;
        self.push(Instruction::with2(Code::Add_rm64_imm32, Register::RDX, bytes))?;
        self.push(Instruction::with1(Code::Dec_rm32, Register::ECX))?;
        self.push(Instruction::with_branch(Code::Jne_rel32_64, head))?;
        if spills > 0 {
            let size = (self.bytes() * i64::from(spills)) as i32;
            self.push(Instruction::with2(Code::Add_rm64_imm32, Register::RSP, size))?;
        }
        self.push(Ok(Instruction::with(Code::VEX_Vzeroupper)))?;
        self.push(Ok(Instruction::with(Code::Retnq)))?;
        Some(self.encoder.take_buffer())
    }

    /// Loads an operand.
    pub fn load(&mut self, to: Vector, from: Location) -> Option<()> {
        let register = self.register(to);
        let (code, memory) = match (self.target, from) {
            (Target::Avx2, Location::Splat(_)) => {
                (Code::VEX_Vbroadcastss_ymm_m32, self.memory(from))
            }
            (Target::Avx512, Location::Splat(splat)) => {
                let offset = 4 * i64::from(splat);
                let memory = MemoryOperand::with_base_displ(Register::RSI, offset);
                (Code::EVEX_Vbroadcastss_zmm_k1z_xmmm32, memory)
            }
            (Target::Avx2, _) => (Code::VEX_Vmovups_ymm_ymmm256, self.memory(from)),
            (Target::Avx512, _) => (Code::EVEX_Vmovups_zmm_k1z_zmmm512, self.memory(from)),
        };
        self.push(Instruction::with2(code, register, memory))
    }

    /// Stores a value, anywhere but to a splat.
    pub fn store(&mut self, to: Location, from: Vector) -> Option<()> {
        let (register, memory) = (self.register(from), self.memory(to));
        let code = match self.target {
            Target::Avx2 => Code::VEX_Vmovups_ymmm256_ymm,
            Target::Avx512 => Code::EVEX_Vmovups_zmmm512_k1z_zmm,
        };
        self.push(Instruction::with2(code, memory, register))
    }

    /// A word in all lanes.
    pub fn constant(&mut self, to: Vector, word: u32) -> Option<()> {
        let register = self.register(to);
        match (word, self.target) {
            (0, Target::Avx2) => {
                let code = Code::VEX_Vpxor_ymm_ymm_ymmm256;
                self.push(Instruction::with3(code, register, register, register))
            }
            (0, Target::Avx512) => {
                let code = Code::EVEX_Vpxord_zmm_k1z_zmm_zmmm512b32;
                self.push(Instruction::with3(code, register, register, register))
            }
            (_, target) => {
                self.push(Instruction::with2(Code::Mov_r32_imm32, Register::EAX, word))?;
                match target {
                    Target::Avx2 => {
                        let low = Register::XMM0 + u32::from(to.0);
                        let code = Code::VEX_Vmovd_xmm_rm32;
                        self.push(Instruction::with2(code, low, Register::EAX))?;
                        let code = Code::VEX_Vpbroadcastd_ymm_xmmm32;
                        self.push(Instruction::with2(code, register, low))
                    }
                    Target::Avx512 => {
                        let code = Code::EVEX_Vpbroadcastd_zmm_k1z_r32;
                        self.push(Instruction::with2(code, register, Register::EAX))
                    }
                }
            }
        }
    }

    fn copy(&mut self, to: Vector, from: Vector) -> Option<()> {
        let code = match self.target {
            Target::Avx2 => Code::VEX_Vmovaps_ymm_ymmm256,
            Target::Avx512 => Code::EVEX_Vmovaps_zmm_k1z_zmmm512,
        };
        self.push(Instruction::with2(code, self.register(to), self.register(from)))
    }

    pub fn unary(&mut self, op: Unary, to: Vector, from: Vector) -> Option<()> {
        let (to, from) = (self.register(to), self.register(from));
        let code = match (op, self.target) {
            (Unary::Sqrt, Target::Avx2) => Code::VEX_Vsqrtps_ymm_ymmm256,
            (Unary::Sqrt, Target::Avx512) => Code::EVEX_Vsqrtps_zmm_k1z_zmmm512b32_er,
            (Unary::IntToFloat, Target::Avx2) => Code::VEX_Vcvtdq2ps_ymm_ymmm256,
            (Unary::IntToFloat, Target::Avx512) => Code::EVEX_Vcvtdq2ps_zmm_k1z_zmmm512b32_er,
            (Unary::FloatToInt, Target::Avx2) => Code::VEX_Vcvttps2dq_ymm_ymmm256,
            (Unary::FloatToInt, Target::Avx512) => Code::EVEX_Vcvttps2dq_zmm_k1z_zmmm512b32_sae,
            (Unary::Round(rounding), target) => {
                // Bit 3: no exception for what is not exact.
                let mode = 8 | match rounding {
                    Rounding::Even => 0,
                    Rounding::Down => 1,
                    Rounding::Up => 2,
                    Rounding::Zero => 3,
                };
                let code = match target {
                    Target::Avx2 => Code::VEX_Vroundps_ymm_ymmm256_imm8,
                    Target::Avx512 => Code::EVEX_Vrndscaleps_zmm_k1z_zmmm512b32_imm8_sae,
                };
                return self.push(Instruction::with3(code, to, from, mode));
            }
        };
        self.push(Instruction::with2(code, to, from))
    }

    /// `to` may be `a` or `b`.
    pub fn binary(&mut self, op: Binary, to: Vector, a: Vector, b: Source) -> Option<()> {
        let (to, a) = (self.register(to), self.register(a));
        let code = match (self.target, op) {
            (target, Binary::Compare(compare)) => return self.compare(target, compare, to, a, b),
            (Target::Avx512, Binary::IntEqual) => {
                let code = Code::EVEX_Vpcmpeqd_kr_k1_zmm_zmmm512b32;
                self.with_source(code, Register::K1, a, b)?;
                return self.words_of_mask(to);
            }
            (Target::Avx512, Binary::IntGreater) => {
                let code = Code::EVEX_Vpcmpgtd_kr_k1_zmm_zmmm512b32;
                self.with_source(code, Register::K1, a, b)?;
                return self.words_of_mask(to);
            }
            (Target::Avx2, op) => avx2(op),
            (Target::Avx512, op) => avx512(op),
        };
        self.with_source(code?, to, a, b)
    }

    fn with_source(&mut self, code: Code, to: Register, a: Register, b: Source) -> Option<()> {
        match b {
            Source::Vector(b) => {
                let b = self.register(b);
                self.push(Instruction::with3(code, to, a, b))
            }
            Source::Memory(b) => {
                let b = self.memory(b);
                self.push(Instruction::with3(code, to, a, b))
            }
        }
    }

    fn words_of_mask(&mut self, to: Register) -> Option<()> {
        self.push(Instruction::with2(Code::EVEX_Vpmovm2d_zmm_kr, to, Register::K1))
    }

    fn compare(
        &mut self,
        target: Target,
        compare: Compare,
        to: Register,
        a: Register,
        b: Source,
    ) -> Option<()> {
        // Quiet forms.
        let predicate = match compare {
            Compare::Less => 0x11,
            Compare::LessEqual => 0x12,
            Compare::Equal => 0x00,
            Compare::NotEqual => 0x04,
            Compare::Unordered => 0x03,
        };
        let (code, out) = match target {
            Target::Avx2 => (Code::VEX_Vcmpps_ymm_ymm_ymmm256_imm8, to),
            Target::Avx512 => (Code::EVEX_Vcmpps_kr_k1_zmm_zmmm512b32_imm8_sae, Register::K1),
        };
        match b {
            Source::Vector(b) => {
                let b = self.register(b);
                self.push(Instruction::with4(code, out, a, b, predicate))?;
            }
            Source::Memory(b) => {
                let b = self.memory(b);
                self.push(Instruction::with4(code, out, a, b, predicate))?;
            }
        }
        match target {
            Target::Avx2 => Some(()),
            Target::Avx512 => self.words_of_mask(to),
        }
    }

    /// `b` where `mask` is set, else `c`. `to` may be `mask`, on AVX-512 neither `b` nor `c`.
    pub fn select(&mut self, to: Vector, mask: Vector, b: Vector, c: Vector) -> Option<()> {
        match self.target {
            Target::Avx2 => {
                let [to, mask, b, c] = [to, mask, b, c].map(|vector| self.register(vector));
                let code = Code::VEX_Vblendvps_ymm_ymm_ymmm256_ymm;
                self.push(Instruction::with4(code, to, c, b, mask))
            }
            Target::Avx512 => {
                if to != mask {
                    self.copy(to, mask)?;
                }
                let [to, b, c] = [to, b, c].map(|vector| self.register(vector));
                // The truth table of (A and B) or (not A and C).
                let code = Code::EVEX_Vpternlogd_zmm_k1z_zmm_zmmm512b32_imm8;
                self.push(Instruction::with4(code, to, b, c, 0xca))
            }
        }
    }
}

/// `None`: comparisons, which have a form of their own.
fn avx2(op: Binary) -> Option<Code> {
    Some(match op {
        Binary::Add => Code::VEX_Vaddps_ymm_ymm_ymmm256,
        Binary::Sub => Code::VEX_Vsubps_ymm_ymm_ymmm256,
        Binary::Mul => Code::VEX_Vmulps_ymm_ymm_ymmm256,
        Binary::Div => Code::VEX_Vdivps_ymm_ymm_ymmm256,
        Binary::Min => Code::VEX_Vminps_ymm_ymm_ymmm256,
        Binary::Max => Code::VEX_Vmaxps_ymm_ymm_ymmm256,
        Binary::And => Code::VEX_Vpand_ymm_ymm_ymmm256,
        Binary::Or => Code::VEX_Vpor_ymm_ymm_ymmm256,
        Binary::Xor => Code::VEX_Vpxor_ymm_ymm_ymmm256,
        Binary::IntAdd => Code::VEX_Vpaddd_ymm_ymm_ymmm256,
        Binary::IntSub => Code::VEX_Vpsubd_ymm_ymm_ymmm256,
        Binary::IntMul => Code::VEX_Vpmulld_ymm_ymm_ymmm256,
        Binary::IntMin => Code::VEX_Vpminsd_ymm_ymm_ymmm256,
        Binary::IntMax => Code::VEX_Vpmaxsd_ymm_ymm_ymmm256,
        Binary::UintMin => Code::VEX_Vpminud_ymm_ymm_ymmm256,
        Binary::UintMax => Code::VEX_Vpmaxud_ymm_ymm_ymmm256,
        Binary::IntEqual => Code::VEX_Vpcmpeqd_ymm_ymm_ymmm256,
        Binary::IntGreater => Code::VEX_Vpcmpgtd_ymm_ymm_ymmm256,
        Binary::ShiftLeft => Code::VEX_Vpsllvd_ymm_ymm_ymmm256,
        Binary::ShiftRight => Code::VEX_Vpsrlvd_ymm_ymm_ymmm256,
        Binary::ShiftRightSigned => Code::VEX_Vpsravd_ymm_ymm_ymmm256,
        Binary::Compare(_) => return None,
    })
}

/// `None`: comparisons, which have a form of their own.
fn avx512(op: Binary) -> Option<Code> {
    Some(match op {
        Binary::Add => Code::EVEX_Vaddps_zmm_k1z_zmm_zmmm512b32_er,
        Binary::Sub => Code::EVEX_Vsubps_zmm_k1z_zmm_zmmm512b32_er,
        Binary::Mul => Code::EVEX_Vmulps_zmm_k1z_zmm_zmmm512b32_er,
        Binary::Div => Code::EVEX_Vdivps_zmm_k1z_zmm_zmmm512b32_er,
        Binary::Min => Code::EVEX_Vminps_zmm_k1z_zmm_zmmm512b32_sae,
        Binary::Max => Code::EVEX_Vmaxps_zmm_k1z_zmm_zmmm512b32_sae,
        Binary::And => Code::EVEX_Vpandd_zmm_k1z_zmm_zmmm512b32,
        Binary::Or => Code::EVEX_Vpord_zmm_k1z_zmm_zmmm512b32,
        Binary::Xor => Code::EVEX_Vpxord_zmm_k1z_zmm_zmmm512b32,
        Binary::IntAdd => Code::EVEX_Vpaddd_zmm_k1z_zmm_zmmm512b32,
        Binary::IntSub => Code::EVEX_Vpsubd_zmm_k1z_zmm_zmmm512b32,
        Binary::IntMul => Code::EVEX_Vpmulld_zmm_k1z_zmm_zmmm512b32,
        Binary::IntMin => Code::EVEX_Vpminsd_zmm_k1z_zmm_zmmm512b32,
        Binary::IntMax => Code::EVEX_Vpmaxsd_zmm_k1z_zmm_zmmm512b32,
        Binary::UintMin => Code::EVEX_Vpminud_zmm_k1z_zmm_zmmm512b32,
        Binary::UintMax => Code::EVEX_Vpmaxud_zmm_k1z_zmm_zmmm512b32,
        Binary::ShiftLeft => Code::EVEX_Vpsllvd_zmm_k1z_zmm_zmmm512b32,
        Binary::ShiftRight => Code::EVEX_Vpsrlvd_zmm_k1z_zmm_zmmm512b32,
        Binary::ShiftRightSigned => Code::EVEX_Vpsravd_zmm_k1z_zmm_zmmm512b32,
        Binary::IntEqual | Binary::IntGreater | Binary::Compare(_) => return None,
    })
}
