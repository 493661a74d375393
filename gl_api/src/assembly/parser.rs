//! Parsing of statements and declarations (ARB_vertex_program, section 2.14.2;
//! ARB_fragment_program, section 3.11.2).

use super::lexer::{Placed, Token, tokens};
use super::program::{
    Attribute, Counts, Destination, Fog, Instruction, Lookup, Opcode, Operands, Options, Parameter,
    Program, Result as Output, Saturation, Target, Written, instructions, opcode,
};
use super::{Failure, Parsed};
use crate::interface::MAX_TEXTURE_IMAGE_UNITS;

/// What a declared name refers to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Symbol {
    Temporary(u16),
    Address(u16),
    Attribute(Attribute),
    Parameter(Parameter),
    /// An array of parameters, by number.
    Array(u16),
    Result(Output),
}

/// The parser: the rest of the tokens, and the program so far.
pub(crate) struct Parser<'a> {
    tokens: Vec<Placed<'a>>,
    at: usize,
    pub target: Target,
    pub options: Options,
    /// Sorted by name.
    pub names: Vec<(&'a str, Symbol)>,
    pub arrays: Vec<Vec<Parameter>>,
    /// The arrays that an address register indexes.
    pub indexed: Vec<u16>,
    instructions: Vec<Instruction>,
    pub counts: Counts,
    pub attributes: Vec<Attribute>,
    /// The attributes that are named, bit by number: by their conventional names, as generic ones.
    pub named: [u32; 2],
    /// The parameters that stand in instructions.
    pub inline: Vec<Parameter>,
    /// The texture target that each unit is read as.
    units: [Option<Lookup>; MAX_TEXTURE_IMAGE_UNITS as usize],
    /// Of each temporary the texture indirection in which an instruction last wrote it, and in
    /// which arithmetic last read or wrote it.
    pub recent: Vec<[u32; 2]>,
}

/// The first line of a program.
pub(crate) fn header(target: Target) -> &'static str {
    match target {
        Target::Vertex => "!!ARBvp1.0",
        Target::Fragment => "!!ARBfp1.0",
    }
}

/// Parses a program of a target.
///
/// # Errors
/// The first error in the text.
pub(crate) fn parse(text: &str, target: Target) -> Parsed<Program> {
    let header = header(target);
    if !text.starts_with(header) {
        return Failure::at(0, format!("the program must begin with {header}"));
    }
    let mut parser = Parser {
        tokens: tokens(text, header.len())?,
        at: 0,
        target,
        options: Options::default(),
        names: Vec::new(),
        arrays: Vec::new(),
        indexed: Vec::new(),
        instructions: Vec::new(),
        counts: Counts::default(),
        attributes: Vec::new(),
        named: [0; 2],
        inline: Vec::new(),
        units: [None; MAX_TEXTURE_IMAGE_UNITS as usize],
        recent: Vec::new(),
    };
    parser.program()?;
    let Parser { options, instructions, arrays, counts, .. } = parser;
    Ok(Program { target, options, instructions, arrays, counts })
}

impl<'a> Parser<'a> {
    /// The next token.
    pub fn peek(&self) -> Token<'a> {
        self.tokens[self.at].0
    }

    /// The token after the next.
    fn peek_second(&self) -> Token<'a> {
        self.tokens.get(self.at + 1).map_or(Token::End, |token| token.0)
    }

    /// Where the next token begins.
    pub fn position(&self) -> usize {
        self.tokens[self.at].1
    }

    /// Fails at the next token.
    pub fn fail<T>(&self, message: impl Into<String>) -> Parsed<T> {
        Failure::at(self.position(), message)
    }

    /// Takes the next token; the end stays.
    pub fn next(&mut self) -> Token<'a> {
        let token = self.peek();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    /// Takes the next token if it is this one.
    pub fn eat(&mut self, token: Token<'_>) -> bool {
        let found = self.peek() == token;
        if found {
            self.next();
        }
        found
    }

    pub fn expect(&mut self, mark: char) -> Parsed<()> {
        if self.eat(Token::Mark(mark)) { Ok(()) } else { self.fail(format!("expected '{mark}'")) }
    }

    /// A word; `what` says what it should be.
    pub fn word(&mut self, what: &str) -> Parsed<&'a str> {
        match self.peek() {
            Token::Word(word) => {
                self.next();
                Ok(word)
            }
            _ => self.fail(format!("expected {what}")),
        }
    }

    /// `.word`.
    pub fn member(&mut self) -> Parsed<&'a str> {
        self.expect('.')?;
        self.word("a name after '.'")
    }

    /// The word of `.word`, if that is what comes next.
    pub fn coming_member(&self) -> Option<&'a str> {
        match (self.peek(), self.peek_second()) {
            (Token::Mark('.'), Token::Word(word)) => Some(word),
            _ => None,
        }
    }

    /// A whole number below `limit`.
    pub fn integer(&mut self, limit: u32, what: &str) -> Parsed<u16> {
        match self.peek() {
            Token::Integer(value) if value < limit => {
                self.next();
                Ok(u16::try_from(value).unwrap_or(u16::MAX))
            }
            Token::Integer(value) => self.fail(format!("{what} {value} must be below {limit}")),
            _ => self.fail(format!("expected the number of {what}")),
        }
    }

    /// `[n]`.
    pub fn index(&mut self, limit: u32, what: &str) -> Parsed<u16> {
        self.expect('[')?;
        let value = self.integer(limit, what)?;
        self.expect(']')?;
        Ok(value)
    }

    /// `[n]`, or nothing, which is 0.
    pub fn optional_index(&mut self, limit: u32, what: &str) -> Parsed<u16> {
        match self.peek() {
            Token::Mark('[') => self.index(limit, what),
            _ => Ok(0),
        }
    }

    /// `[n]` or `[n..m]`, as the first and the last.
    pub fn indices(&mut self, limit: u32, what: &str) -> Parsed<(u16, u16)> {
        self.expect('[')?;
        let first = self.integer(limit, what)?;
        let mut last = first;
        if self.eat(Token::Range) {
            let position = self.position();
            last = self.integer(limit, what)?;
            if last < first {
                return Failure::at(position, format!("the range {first}..{last} is backwards"));
            }
        }
        self.expect(']')?;
        Ok((first, last))
    }

    fn program(&mut self) -> Parsed<()> {
        while self.eat(Token::Word("OPTION")) {
            self.option()?;
            self.expect(';')?;
        }
        loop {
            let position = self.position();
            match self.peek() {
                Token::Word("END") => return Ok(()),
                Token::Word(word) => {
                    self.next();
                    self.statement(word, position)?;
                    self.expect(';')?;
                }
                _ => return self.fail("expected an instruction, a declaration or END"),
            }
            self.check_counts(position)?;
        }
    }

    fn option(&mut self) -> Parsed<()> {
        let position = self.position();
        let name = self.word("an option")?;
        let options = &mut self.options;
        let fog = match (name, self.target) {
            ("ARB_position_invariant", Target::Vertex) => {
                options.position_invariant = true;
                return Ok(());
            }
            // Everything is computed as precisely as it can be.
            ("ARB_precision_hint_fastest" | "ARB_precision_hint_nicest", Target::Fragment) => {
                let other = options.precision.replace(name == "ARB_precision_hint_nicest");
                if other.is_some_and(|other| options.precision != Some(other)) {
                    return Failure::at(position, "both precisions are hinted at");
                }
                return Ok(());
            }
            ("ARB_draw_buffers" | "ATI_draw_buffers", Target::Fragment) => {
                options.draw_buffers = true;
                return Ok(());
            }
            ("ARB_fragment_program_shadow", Target::Fragment) => {
                options.shadow = true;
                return Ok(());
            }
            ("ARB_fragment_coord_origin_upper_left", Target::Fragment) => {
                options.origin_upper_left = true;
                return Ok(());
            }
            ("ARB_fragment_coord_pixel_center_integer", Target::Fragment) => {
                options.pixel_center_integer = true;
                return Ok(());
            }
            ("ARB_fog_exp", Target::Fragment) => Fog::Exp,
            ("ARB_fog_exp2", Target::Fragment) => Fog::Exp2,
            ("ARB_fog_linear", Target::Fragment) => Fog::Linear,
            (_, _) => return Failure::at(position, format!("there is no option {name} here")),
        };
        match options.fog.replace(fog) {
            Some(other) if other != fog => Failure::at(position, "there are two kinds of fog"),
            Some(_) | None => Ok(()),
        }
    }

    fn statement(&mut self, word: &str, position: usize) -> Parsed<()> {
        match (word, self.target) {
            ("TEMP", _) => self.variables(|parser| {
                parser.counts.temporaries += 1;
                parser.recent.push([0; 2]);
                Symbol::Temporary((parser.counts.temporaries - 1) as u16)
            }),
            ("ADDRESS", Target::Vertex) => self.variables(|parser| {
                parser.counts.addresses += 1;
                Symbol::Address((parser.counts.addresses - 1) as u16)
            }),
            ("ATTRIB", _) => self.declaration(|parser| Ok(Symbol::Attribute(parser.attribute()?))),
            ("OUTPUT", _) => self.declaration(|parser| {
                if !parser.eat(Token::Word("result")) {
                    return parser.fail("expected result.");
                }
                Ok(Symbol::Result(parser.result()?))
            }),
            ("ALIAS", _) => self.declaration(Self::symbol),
            ("PARAM", _) => self.parameters(),
            (_, target) => match opcode(word, target) {
                Some((opcode, operands, saturation)) => {
                    self.instruction(opcode, operands, saturation)
                }
                None => {
                    let message = format!("{word} is no instruction");
                    let capitals = word.to_ascii_uppercase();
                    if opcode(&capitals, target).is_some() {
                        return Failure::at(
                            position,
                            format!("{message}: did you mean {capitals}?"),
                        );
                    }
                    let known = instructions(target);
                    Err(Failure::unknown(position, message, &capitals, &known))
                }
            },
        }
    }

    fn instruction(
        &mut self,
        opcode: Opcode,
        operands: Operands,
        saturation: Saturation,
    ) -> Parsed<()> {
        let nowhere = Destination { written: Written::Nowhere, mask: [false; 4] };
        let mut sources = Vec::new();
        let mut lookup = None;
        let destination = match operands {
            Operands::Condition => nowhere,
            Operands::Address => self.address()?,
            Operands::Vectors(_) | Operands::Scalars(_) | Operands::Swizzle | Operands::Texture => {
                self.destination()?
            }
        };
        match operands {
            Operands::Condition => sources.push(self.vector()?),
            Operands::Vectors(count) => {
                for _ in 0..count {
                    self.expect(',')?;
                    sources.push(self.vector()?);
                }
            }
            Operands::Scalars(count) => {
                for _ in 0..count {
                    self.expect(',')?;
                    sources.push(self.scalar()?);
                }
            }
            Operands::Address => {
                self.expect(',')?;
                sources.push(self.scalar()?);
            }
            Operands::Swizzle => {
                self.expect(',')?;
                sources.push(self.swizzled()?);
            }
            Operands::Texture => {
                self.expect(',')?;
                sources.push(self.vector()?);
                self.expect(',')?;
                lookup = Some(self.lookup()?);
            }
        }
        self.counts.instructions += 1;
        let instruction = Instruction { opcode, saturation, destination, sources, lookup };
        self.count_indirections(&instruction);
        self.instructions.push(instruction);
        Ok(())
    }

    /// `texture[n], 2D`: every lookup of a unit must be of the same target.
    fn lookup(&mut self) -> Parsed<Lookup> {
        let position = self.position();
        let lookup = self.texture()?;
        let known = *self.units[usize::from(lookup.unit)].get_or_insert(lookup);
        if known != lookup {
            let unit = lookup.unit;
            return Failure::at(position, format!("texture[{unit}] is read as two targets"));
        }
        Ok(lookup)
    }
}
