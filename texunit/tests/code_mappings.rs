//! Code of very many programs, in a process of its own: what is counted is the process's.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use texunit::lanes::code::{Block, Code, Step, Target};
use texunit::lanes::{Isa, U32s};

/// Linux's default for the mappings of a process.
const MAX_MAP_COUNT: usize = 65_530;

fn block(register: u32) -> Block {
    let mut block = Block::new(0);
    let mask = block.value(Step::Mask);
    block.write(register, mask);
    block
}

fn mappings() -> usize {
    std::fs::read_to_string("/proc/self/maps").expect("Linux's list").lines().count()
}

/// A host with 70,000 programs, which deletes every second one: the system is left with mappings for others.
#[test]
fn code_leaves_the_mappings_of_a_process_to_others() {
    let Some(isa) = Isa::available().into_iter().find(|&isa| Target::of(isa).is_some()) else {
        return;
    };
    let before = mappings();
    let mut codes: Vec<Option<Code>> =
        (0..70_000).map(|register| Code::compile(isa, &[block(register % 9)])).collect();
    let has_code = |codes: &[Option<Code>]| codes.iter().flatten().count();
    let most = has_code(&codes);
    assert!((1000..MAX_MAP_COUNT / 2).contains(&most), "{most}");
    codes.iter_mut().step_by(2).for_each(|code| *code = None);
    let after = mappings();
    println!("{most} with code, {before} mappings before, {after} after every second one went");
    assert!(after < MAX_MAP_COUNT / 2, "{after}");
    // What went makes room.
    for (register, code) in (0..).zip(&mut codes).step_by(2) {
        *code = Code::compile(isa, &[block(register % 9)]);
    }
    assert_eq!(has_code(&codes), most);
    // Each has kept its own.
    let mask = U32s::splat(!0);
    for (register, code) in
        codes.iter().enumerate().filter_map(|(at, code)| Some((at % 9, code.as_ref()?)))
    {
        let mut registers = [U32s::ZERO; 9];
        code.run(0, &mut registers, &[], &mask);
        assert_eq!(registers[register], mask);
    }
}
