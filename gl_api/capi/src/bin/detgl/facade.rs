//! Facades: shared libraries of a few kilobytes which have a SONAME that programs ask for, and need `libdetgl.so`, where
//! all functions are. A library can have one SONAME, and loaded twice DetGL would have two current contexts.
//!
//! The linker of a program reads the table of symbols, and finds the functions there. The loader looks symbols up by the
//! hash table, which is empty: it goes on to `libdetgl.so`. So a facade is for linking and for loading.

use std::io;

/// What a facade is made of.
pub struct Facade<'a> {
    /// By which loaders know it.
    pub soname: &'a str,
    /// The functions that programs linked with it may use.
    pub functions: &'a [&'a str],
}

/// The SONAME of the library that all facades need.
pub const NEEDED: &str = "libdetgl.so";

/// Where a facade's loader looks for that: beside the facade, and above it.
const RUN_PATH: &str = "$ORIGIN:$ORIGIN/..";

/// How numbers lie in an ELF file, and for which machine it is: as in another file.
struct Format {
    is_wide: bool,
    is_little: bool,
    /// `e_ident`.
    ident: [u8; 16],
    machine: u16,
    flags: u32,
}

const EI_CLASS: usize = 4;
const EI_DATA: usize = 5;
const SHT_STRTAB: u32 = 3;
const SHT_HASH: u32 = 5;
const SHT_DYNAMIC: u32 = 6;
const SHT_DYNSYM: u32 = 11;
const SHF_WRITE_ALLOC: u64 = 3;
const SHF_ALLOC: u64 = 2;
const PT_LOAD: u32 = 1;
const PT_DYNAMIC: u32 = 2;
const PT_GNU_STACK: u32 = 0x6474_e551;
const READ_WRITE: u32 = 6;
const GLOBAL_FUNCTION: u8 = 0x12;

fn broken() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, "is no shared library in the format ELF")
}

/// A file that is read.
struct Elf<'a> {
    bytes: &'a [u8],
    format: Format,
}

impl<'a> Elf<'a> {
    fn open(bytes: &'a [u8]) -> io::Result<Self> {
        let ident: [u8; 16] =
            bytes.get(..16).and_then(|start| start.try_into().ok()).ok_or_else(broken)?;
        if !ident.starts_with(b"\x7fELF") {
            return Err(broken());
        }
        let (is_wide, is_little) = (ident[EI_CLASS] == 2, ident[EI_DATA] == 1);
        let format = Format { is_wide, is_little, ident, machine: 0, flags: 0 };
        let mut elf = Self { bytes, format };
        elf.format.machine = elf.number(18, 2)? as u16;
        elf.format.flags = elf.number(elf.format.choose(36, 48), 4)? as u32;
        Ok(elf)
    }

    fn number(&self, at: usize, size: usize) -> io::Result<u64> {
        let end = at.checked_add(size).ok_or_else(broken)?;
        let bytes = self.bytes.get(at..end).ok_or_else(broken)?;
        let join = |number: u64, byte: &u8| number << 8 | u64::from(*byte);
        Ok(if self.format.is_little {
            bytes.iter().rev().fold(0, join)
        } else {
            bytes.iter().fold(0, join)
        })
    }

    /// A number of the machine's width.
    fn word(&self, at: usize) -> io::Result<usize> {
        let number = self.number(at, self.format.choose(4, 8))?;
        usize::try_from(number).map_err(|_| broken())
    }

    /// Where a section lies, and the section that it belongs with.
    fn section(&self, index: usize) -> io::Result<(u32, usize, usize, usize)> {
        let format = &self.format;
        let headers = self.word(format.choose(32, 40))?;
        let size = self.number(format.choose(46, 58), 2)? as usize;
        let at =
            index.checked_mul(size).and_then(|at| at.checked_add(headers)).ok_or_else(broken)?;
        let kind = self.number(at + 4, 4)? as u32;
        let (offset, length) =
            (self.word(at + format.choose(16, 24))?, self.word(at + format.choose(20, 32))?);
        let link = self.number(at + format.choose(24, 40), 4)? as usize;
        Ok((kind, offset, length, link))
    }

    /// The names of the symbols that the library defines for others.
    fn exports(&self) -> io::Result<Vec<&'a str>> {
        let format = &self.format;
        let count = self.number(format.choose(48, 60), 2)? as usize;
        let mut names = Vec::new();
        for index in 0..count {
            let (kind, offset, length, link) = self.section(index)?;
            if kind != SHT_DYNSYM {
                continue;
            }
            let (_, texts, _, _) = self.section(link)?;
            for at in (offset..offset.saturating_add(length)).step_by(format.choose(16, 24)) {
                let (info, section) = (at + format.choose(12, 4), at + format.choose(14, 6));
                if self.number(info, 1)? != u64::from(GLOBAL_FUNCTION)
                    || self.number(section, 2)? == 0
                {
                    continue;
                }
                let text = self
                    .bytes
                    .get(texts.saturating_add(self.number(at, 4)? as usize)..)
                    .ok_or_else(broken)?;
                let end = text.iter().position(|&byte| byte == 0).ok_or_else(broken)?;
                names.push(std::str::from_utf8(&text[..end]).map_err(|_| broken())?);
            }
        }
        names.sort_unstable();
        Ok(names)
    }
}

/// The functions that a library has for programs, in order.
pub fn exports(library: &[u8]) -> io::Result<Vec<&str>> {
    Elf::open(library)?.exports()
}

impl Format {
    /// One of two numbers, by whether the machine's addresses have 32 bits or 64.
    fn choose(&self, narrow: usize, wide: usize) -> usize {
        if self.is_wide { wide } else { narrow }
    }
}

/// A file that is written.
struct Writer<'a> {
    bytes: Vec<u8>,
    format: &'a Format,
}

impl Writer<'_> {
    fn put(&mut self, number: u64, size: usize) {
        let bytes = number.to_le_bytes();
        if self.format.is_little {
            self.bytes.extend(&bytes[..size]);
        } else {
            self.bytes.extend(bytes[..size].iter().rev());
        }
    }

    fn half(&mut self, number: usize) {
        self.put(number as u64, 2);
    }

    fn int(&mut self, number: u32) {
        self.put(number.into(), 4);
    }

    /// A number of the machine's width.
    fn word(&mut self, number: usize) {
        self.put(number as u64, self.format.choose(4, 8));
    }

    fn symbol(&mut self, name: usize, address: usize, info: u8, section: usize) {
        self.int(name as u32);
        if self.format.is_wide {
            self.put(info.into(), 1);
            self.put(0, 1);
            self.half(section);
            self.word(address);
            self.word(0);
        } else {
            self.word(address);
            self.word(0);
            self.put(info.into(), 1);
            self.put(0, 1);
            self.half(section);
        }
    }

    fn segment(&mut self, kind: u32, at: usize, size: usize, align: usize) {
        self.int(kind);
        if self.format.is_wide {
            self.int(READ_WRITE);
        }
        for number in [at, at, at, size, size] {
            self.word(number);
        }
        if !self.format.is_wide {
            self.int(READ_WRITE);
        }
        self.word(align);
    }
}

/// Texts one after the other, each ended by a zero.
struct Texts(Vec<u8>);

impl Texts {
    fn add(&mut self, text: &str) -> usize {
        let at = self.0.len();
        self.0.extend(text.bytes());
        self.0.push(0);
        at
    }
}

/// A section as its header says.
struct Section {
    name: &'static str,
    kind: u32,
    flags: u64,
    at: usize,
    size: usize,
    link: u32,
    info: u32,
    entry: usize,
}

/// A facade for the machine that `library` is for.
pub fn write(facade: &Facade<'_>, library: &[u8]) -> io::Result<Vec<u8>> {
    let format = Elf::open(library)?.format;
    let (word, symbol_size) = (format.choose(4, 8), format.choose(16, 24));
    let mut texts = Texts(vec![0]);
    let [soname, needed, run_path] = [facade.soname, NEEDED, RUN_PATH].map(|text| texts.add(text));
    let names: Vec<usize> = facade.functions.iter().map(|name| texts.add(name)).collect();
    let mut section_names = Texts(vec![0]);

    // Everything is in one segment, at the address that is its place in the file.
    let count = names.len() + 1;
    let symbols = format.choose(52, 64) + 3 * format.choose(32, 56);
    let hash = symbols + count * symbol_size;
    let strings = hash + (3 + count) * 4;
    let dynamic = (strings + texts.0.len()).next_multiple_of(word);
    let entries = [
        (1, needed),
        (14, soname),
        (29, run_path),
        (4, hash),
        (5, strings),
        (6, symbols),
        (10, texts.0.len()),
        (11, symbol_size),
        (0, 0),
    ];
    let end = dynamic + entries.len() * 2 * word;
    #[rustfmt::skip]
    let sections = [
        Section { name: ".dynsym", kind: SHT_DYNSYM, flags: SHF_ALLOC, at: symbols, size: hash - symbols,
            link: 3, info: 1, entry: symbol_size },
        Section { name: ".hash", kind: SHT_HASH, flags: SHF_ALLOC, at: hash, size: strings - hash,
            link: 1, info: 0, entry: 4 },
        Section { name: ".dynstr", kind: SHT_STRTAB, flags: SHF_ALLOC, at: strings, size: texts.0.len(),
            link: 0, info: 0, entry: 0 },
        Section { name: ".dynamic", kind: SHT_DYNAMIC, flags: SHF_WRITE_ALLOC, at: dynamic, size: end - dynamic,
            link: 3, info: 0, entry: 2 * word },
    ];
    let named: Vec<usize> =
        sections.iter().map(|section| section_names.add(section.name)).collect();
    let own_name = section_names.add(".shstrtab");
    let headers = (end + section_names.0.len()).next_multiple_of(word);

    let mut out = Writer { bytes: format.ident.to_vec(), format: &format };
    // ET_DYN, the machine, version 1, no entry point.
    out.half(3);
    out.half(format.machine.into());
    out.int(1);
    out.word(0);
    out.word(format.choose(52, 64));
    out.word(headers);
    out.int(format.flags);
    for number in [format.choose(52, 64), format.choose(32, 56), 3, format.choose(40, 64)] {
        out.half(number);
    }
    out.half(sections.len() + 2);
    out.half(sections.len() + 1);
    out.segment(PT_LOAD, 0, end, 0x1_0000);
    out.segment(PT_DYNAMIC, dynamic, end - dynamic, word);
    out.segment(PT_GNU_STACK, 0, 0, 16);
    out.symbol(0, 0, 0, 0);
    for name in names {
        out.symbol(name, dynamic, GLOBAL_FUNCTION, 4);
    }
    // One bucket, which is empty; then the chain of each symbol.
    out.int(1);
    out.int(count as u32);
    out.bytes.resize(strings, 0);
    out.bytes.extend(&texts.0);
    out.bytes.resize(dynamic, 0);
    for (tag, value) in entries {
        out.word(tag);
        out.word(value);
    }
    out.bytes.extend(&section_names.0);
    // The first header is of no section.
    out.bytes.resize(headers + format.choose(40, 64), 0);
    let strings = Section {
        name: ".shstrtab",
        kind: SHT_STRTAB,
        flags: 0,
        at: end,
        size: section_names.0.len(),
        link: 0,
        info: 0,
        entry: 0,
    };
    for (section, name) in
        sections.iter().chain([&strings]).zip(named.into_iter().chain([own_name]))
    {
        out.int(name as u32);
        out.int(section.kind);
        out.word(section.flags as usize);
        out.word(if section.flags == 0 { 0 } else { section.at });
        out.word(section.at);
        out.word(section.size);
        out.int(section.link);
        out.int(section.info);
        out.word(word);
        out.word(section.entry);
    }
    Ok(out.bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_facade_is_read_back_in_every_format() {
        for (class, data) in [(1, 1), (1, 2), (2, 1), (2, 2)] {
            let mut library = vec![0; 64];
            library[..7].copy_from_slice(&[0x7f, b'E', b'L', b'F', class, data, 1]);
            library[18..20].copy_from_slice(&[5, 6]);
            let functions = ["glBegin", "glEnd"];
            let file = write(&Facade { soname: "libGL.so.1", functions: &functions }, &library);
            let file = file.expect("written");
            assert_eq!((&file[..16], &file[18..20]), (&library[..16], &library[18..20]));
            assert_eq!(exports(&file).expect("readable"), functions);
        }
    }

    #[test]
    fn what_is_no_library_is_refused() {
        for bytes in [&b""[..], b"\x7fELF", b"not at all a library, however long", &[0x7f; 4096]] {
            assert!(exports(bytes).is_err());
        }
        let mut cut =
            write(&Facade { soname: "a", functions: &["glA"] }, &header()).expect("written");
        cut.truncate(cut.len() - 64);
        assert!(exports(&cut).is_err());
    }

    fn header() -> Vec<u8> {
        let mut header = b"\x7fELF\x02\x01\x01".to_vec();
        header.resize(64, 0);
        header
    }
}
