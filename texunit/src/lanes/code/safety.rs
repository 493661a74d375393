//! The proof of the code's safety, looked for in its bytes: a disassembler reads what random blocks become, and holds each
//! instruction against what the call in [`Code::run`] relies on.

use super::{Binary, Block, Code, Compare, Rounding, Step, Target, Unary, Value};
use crate::lanes::{Isa, LANES, U32s};
use iced_x86::{
    Decoder, DecoderOptions, FlowControl, Instruction, InstructionInfoFactory, Mnemonic, OpAccess,
    OpKind, Register,
};

/// Bytes of a register.
const BATCH: u64 = 4 * LANES as u64;
/// What a function may touch below the stack pointer without a probe.
const PAGE: u64 = 4096;

fn compiling() -> impl Iterator<Item = (Isa, Target)> {
    Isa::available().into_iter().filter_map(|isa| Some((isa, Target::of(isa)?)))
}

/// Choices that look random, the same in every run.
struct Choices(u64);

impl Choices {
    fn below(&mut self, count: u32) -> u32 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        ((self.0 >> 33) % u64::from(count)) as u32
    }
}

const OPERATIONS: &[Binary] = &[
    Binary::Add,
    Binary::Div,
    Binary::Min,
    Binary::Compare(Compare::Less),
    Binary::And,
    Binary::Xor,
    Binary::IntMul,
    Binary::UintMax,
    Binary::IntEqual,
    Binary::IntGreater,
    Binary::ShiftRightSigned,
];

/// Steps of every form, over registers that are near and far.
fn block(choices: &mut Choices) -> Block {
    let splats = choices.below(4) * choices.below(300);
    let mut block = Block::new(splats);
    let mut values = vec![block.value(Step::Mask), block.value(Step::Constant(choices.below(9)))];
    let alive = 1 + choices.below(40);
    for _ in 0..choices.below(150) {
        let pick = |choices: &mut Choices, values: &[Value]| {
            let recent = values.len().min(alive as usize);
            values[values.len() - 1 - choices.below(recent as u32) as usize]
        };
        let [a, b, c] = [(); 3].map(|()| pick(choices, &values));
        let far = [1, 40, 40_000][choices.below(3) as usize];
        let register = splats + choices.below(far);
        let value = match choices.below(8) {
            0 => block.read(choices.below(splats + far)),
            1 => block.value(Step::Constant(choices.below(u32::MAX))),
            2 => block.value(Step::Unary(Unary::Round(Rounding::Up), a)),
            3 => block.value(Step::Unary(Unary::Sqrt, a)),
            4 => block.value(Step::Select(a, b, c)),
            5 => {
                block.write(register, a);
                continue;
            }
            _ => {
                let op = OPERATIONS[choices.below(OPERATIONS.len() as u32) as usize];
                block.value(Step::Binary(op, a, b))
            }
        };
        values.push(value);
    }
    let kept = choices.below(50).min(values.len() as u32);
    for (at, value) in values.iter().rev().take(kept as usize).enumerate() {
        block.write(splats + at as u32 * 3, *value);
    }
    block
}

/// The function that begins at `entry`, and the address after it.
fn function(bytes: &[u8], entry: usize) -> (Vec<Instruction>, usize) {
    let mut decoder = Decoder::with_ip(64, &bytes[entry..], entry as u64, DecoderOptions::NONE);
    let mut all = Vec::new();
    loop {
        assert!(decoder.can_decode(), "no return before the end of the code");
        let instruction = decoder.decode();
        assert!(!instruction.is_invalid(), "byte {}", instruction.ip());
        all.push(instruction);
        if instruction.flow_control() == FlowControl::Return {
            return (all, decoder.ip() as usize);
        }
    }
}

/// What a caller of the System V calling convention does not expect to be kept.
fn is_scratch(register: Register) -> bool {
    use Register::{EAX, ECX, K1, RAX, RCX, RDI, RDX, RSI};
    register.is_vector_register() || [RDI, RSI, RDX, RCX, ECX, RAX, EAX, K1].contains(&register)
}

/// Fails on an instruction that the proof of the call does not cover.
fn check(code: &Code, block: &Block, target: Target, instructions: &[Instruction]) {
    let vector = 4 * target.lanes() as u64;
    let registers = u64::from(block.registers());
    let splats = u64::from(block.splats());
    assert!(registers <= u64::from(code.registers) && splats <= u64::from(code.splats));
    let mut infos = InstructionInfoFactory::new();
    let stack = match instructions[0].mnemonic() {
        Mnemonic::Sub => instructions[0].immediate(1),
        _ => 0,
    };
    assert!(stack < PAGE, "{stack} bytes of the stack without a probe");
    let head = usize::from(stack > 0) + 1;
    let count = &instructions[head - 1];
    assert_eq!((count.mnemonic(), count.op0_register()), (Mnemonic::Mov, Register::ECX));
    assert_eq!(count.immediate(1) * target.lanes() as u64, LANES as u64);
    let (mut pointers, mut stack_pointers, mut jumps) = (Vec::new(), Vec::new(), 0);
    for instruction in instructions {
        let what = format!("{instruction:?}");
        match instruction.flow_control() {
            FlowControl::Next | FlowControl::Return => {}
            FlowControl::ConditionalBranch => {
                // The loop is left after the rounds that were counted.
                assert_eq!(instruction.near_branch_target(), instructions[head].ip(), "{what}");
                jumps += 1;
            }
            other => panic!("{other:?}: {what}"),
        }
        if instruction.flow_control() == FlowControl::Return {
            continue;
        }
        let info = infos.info(instruction);
        for used in info.used_registers() {
            let is_written = !matches!(used.access(), OpAccess::Read | OpAccess::CondRead);
            match used.register() {
                register if !is_written || is_scratch(register) => {}
                Register::RSP => stack_pointers.push(*instruction),
                register => panic!("{register:?} is the caller's: {what}"),
            }
            if is_written
                && [Register::RDI, Register::RSI, Register::RDX].contains(&used.register())
            {
                pointers.push(*instruction);
            }
            if is_written && [Register::ECX, Register::RCX].contains(&used.register()) {
                assert!(matches!(instruction.mnemonic(), Mnemonic::Mov | Mnemonic::Dec), "{what}");
            }
        }
        for memory in info.used_memory() {
            assert_eq!(memory.index(), Register::None, "{what}");
            let (at, size) = (memory.displacement(), memory.memory_size().size() as u64);
            let is_written = !matches!(memory.access(), OpAccess::Read | OpAccess::CondRead);
            match memory.base() {
                Register::RDI => {
                    // Of the register it reaches the lanes of this round alone.
                    assert!(at.is_multiple_of(BATCH) && at / BATCH < registers, "{what}");
                    assert!(size <= vector, "{what}");
                    assert!(!is_written || at / BATCH >= splats, "a splat's register: {what}");
                }
                Register::RSI => {
                    assert!(!is_written && size == 4 && at + 4 <= 4 * splats, "{what}");
                }
                Register::RDX => assert!(!is_written && at == 0 && size <= vector, "{what}"),
                Register::RSP => assert!(at + size <= stack, "{what}"),
                base => panic!("{base:?} is no base: {what}"),
            }
        }
    }
    assert_eq!(jumps, 1);
    let added = |all: &[Instruction]| -> Vec<(Mnemonic, Register, OpKind, u64)> {
        let of = |add: &Instruction| {
            (add.mnemonic(), add.op0_register(), add.op1_kind(), add.immediate(1))
        };
        all.iter().map(of).collect()
    };
    let next = |register| (Mnemonic::Add, register, OpKind::Immediate32to64, vector);
    assert_eq!(added(&pointers), [next(Register::RDI), next(Register::RDX)]);
    let moves = |mnemonic| (mnemonic, Register::RSP, OpKind::Immediate32to64, stack);
    match stack {
        0 => assert_eq!(added(&stack_pointers), []),
        _ => assert_eq!(added(&stack_pointers), [Mnemonic::Sub, Mnemonic::Add].map(moves)),
    }
}

#[test]
fn each_instruction_keeps_to_registers_splats_mask_and_spills() {
    let (mut checked, mut spilling) = (0, 0);
    for (isa, target) in compiling() {
        let mut choices = Choices(1);
        for _ in 0..300 {
            let blocks: Vec<_> = (0..1 + choices.below(3)).map(|_| block(&mut choices)).collect();
            let Some(code) = Code::compile(isa, &blocks) else { continue };
            let mut end = 0;
            for (block, entry) in blocks.iter().zip(&code.entries) {
                assert_eq!(*entry as usize, end, "code that nothing enters");
                let (instructions, after) = function(&code.memory.0, end);
                check(&code, block, target, &instructions);
                end = after;
                checked += instructions.len();
                spilling += usize::from(instructions[0].mnemonic() == Mnemonic::Sub);
            }
        }
    }
    if compiling().next().is_some() {
        assert!(
            checked > 10_000 && spilling > 20,
            "{checked} instructions, {spilling} blocks spill"
        );
    }
}

/// A block of one register, which is written.
fn writing(register: u32) -> Block {
    let mut block = Block::new(0);
    let mask = block.value(Step::Mask);
    block.write(register, mask);
    block
}

#[test]
fn registers_beyond_the_displacement_have_no_code() {
    for (isa, _) in compiling() {
        // The last that 31 bits reach: 8,388,607.
        let last = (i32::MAX as u32 + 1) / BATCH as u32 - 1;
        assert!(Code::compile(isa, &[writing(last)]).is_some());
        for far in [last + 1, 2 * last + 2, u32::MAX / 4, u32::MAX - 1, u32::MAX] {
            assert!(Code::compile(isa, &[writing(far)]).is_none(), "register {far}");
            let mut block = Block::new(0);
            let value = block.value(Step::Register(far));
            block.write(0, value);
            assert!(Code::compile(isa, &[block]).is_none(), "register {far}");
        }
    }
}

fn panics(run: impl FnOnce()) -> bool {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).is_err()
}

/// However a register came into the block.
#[test]
fn fewer_registers_or_splats_than_code_addresses_are_refused() {
    let written = || writing(7);
    let read = || {
        let mut block = Block::new(0);
        let value = block.read(7);
        block.write(0, value);
        block
    };
    let named = || {
        let mut block = Block::new(0);
        let value = block.value(Step::Register(7));
        block.write(0, value);
        block
    };
    let mask = U32s::ZERO;
    for (isa, _) in compiling() {
        for made in [&written as &dyn Fn() -> Block, &read, &named] {
            let code = Code::compile(isa, &[made()]).expect("code of a small block");
            let mut registers = vec![U32s::ZERO; 8];
            code.run(0, &mut registers, &[], &mask);
            assert!(panics(|| code.run(0, &mut registers[..7], &[], &mask)));
            assert!(panics(|| code.run(1, &mut registers, &[], &mask)), "there is no block 1");
        }
        let mut block = Block::new(3);
        let value = block.read(2);
        block.write(3, value);
        let code = Code::compile(isa, &[block]).expect("code of a small block");
        let mut registers = vec![U32s::ZERO; 4];
        code.run(0, &mut registers, &[0.0, 0.0, 1.0], &mask);
        assert_eq!(registers[3], U32s::splat(1.0_f32.to_bits()));
        assert!(panics(|| code.run(0, &mut registers, &[0.0, 0.0], &mask)));
    }
    let other_splat = || _ = Block::new(3).value(Step::Splat(3));
    assert!(panics(other_splat), "a splat that is not the block's");
    let write_splat = || {
        let mut block = Block::new(3);
        let mask = block.value(Step::Mask);
        block.write(2, mask);
    };
    assert!(panics(write_splat), "a splat's register is not written");
}

/// Values of another block, of which this one has only some.
#[test]
fn values_of_other_blocks_are_no_addresses() {
    for (isa, _) in compiling() {
        let mut other = Block::new(0);
        let values: Vec<_> = (0..20).map(|word| other.value(Step::Constant(word))).collect();
        for (at, value) in values.into_iter().enumerate() {
            let made = std::panic::catch_unwind(|| {
                let mut block = Block::new(0);
                let mask = block.value(Step::Mask);
                let sum = block.value(Step::Binary(Binary::IntAdd, mask, value));
                let next = block.value(Step::Binary(Binary::IntSub, sum, mask));
                block.write(1, next);
                Code::compile(isa, &[block])
            });
            match (at, made) {
                (0, Ok(code)) => assert!(code.is_some(), "the mask"),
                (1 | 2, Ok(code)) => assert!(code.is_none(), "a value that is made later"),
                (3.., Err(_)) => {}
                (_, made) => panic!("value {at}: {made:?}"),
            }
        }
    }
}
