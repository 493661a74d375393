//! Names of assembly programs: declarations, and what a name refers to (ARB_vertex_program, sections 2.14.3.1 to 2.14.3.7).

use super::lexer::Token;
use super::parser::{Parser, Symbol};
use super::program::{Target, opcode};
use super::{Failure, Parsed};
use crate::base::assembly_limits as limits;

impl<'a> Parser<'a> {
    /// Where a name is among the declared ones, or where it would be.
    fn place(&self, name: &str) -> Result<usize, usize> {
        self.names.binary_search_by(|(known, _)| (*known).cmp(name))
    }

    /// What a declared name refers to.
    pub fn symbol(&mut self) -> Parsed<Symbol> {
        let position = self.position();
        let name = self.word("a variable")?;
        match self.place(name) {
            Ok(place) => Ok(self.names[place].1),
            Err(_) => {
                let roots = match self.target {
                    Target::Vertex => "vertex",
                    Target::Fragment => "fragment",
                };
                let known: Vec<&str> =
                    self.names.iter().map(|row| row.0).chain([roots, "program", "state"]).collect();
                Err(Failure::unknown(position, format!("{name} is not declared"), name, &known))
            }
        }
    }

    /// Whether a name is reserved.
    fn is_reserved(&self, name: &str) -> bool {
        let words: &[&str] = match self.target {
            Target::Vertex => &["ADDRESS", "vertex"],
            Target::Fragment => &["fragment", "texture"],
        };
        let both = ["ALIAS", "ATTRIB", "END", "OPTION", "OUTPUT", "PARAM", "TEMP"];
        let roots = ["program", "result", "state"];
        words.iter().chain(&both).chain(&roots).any(|word| *word == name)
            || opcode(name, self.target).is_some()
    }

    /// A name that is declared here, and where it stands.
    fn new_name(&mut self) -> Parsed<(&'a str, usize)> {
        let position = self.position();
        let name = self.word("a name")?;
        if self.is_reserved(name) || name.starts_with(|c: char| c.is_ascii_digit()) {
            return Failure::at(position, format!("{name} is a reserved word"));
        }
        Ok((name, position))
    }

    fn declare(&mut self, (name, position): (&'a str, usize), symbol: Symbol) -> Parsed<()> {
        match self.place(name) {
            Ok(_) => Failure::at(position, format!("{name} is declared twice")),
            Err(place) => {
                self.names.insert(place, (name, symbol));
                Ok(())
            }
        }
    }

    /// `a, b, c`.
    pub fn variables(&mut self, make: fn(&mut Self) -> Symbol) -> Parsed<()> {
        loop {
            let name = self.new_name()?;
            let symbol = make(self);
            self.declare(name, symbol)?;
            if !self.eat(Token::Mark(',')) {
                return Ok(());
            }
        }
    }

    /// `a = …`.
    pub fn declaration(&mut self, bind: fn(&mut Self) -> Parsed<Symbol>) -> Parsed<()> {
        let name = self.new_name()?;
        self.expect('=')?;
        let symbol = bind(self)?;
        self.declare(name, symbol)
    }

    /// `a = …` or `a[n] = { … }`, of parameters.
    pub fn parameters(&mut self) -> Parsed<()> {
        let name = self.new_name()?;
        let position = self.position();
        if !self.eat(Token::Mark('[')) {
            self.expect('=')?;
            let parameter = self.declared_parameter()?;
            self.counts.parameters += 1;
            return self.declare(name, Symbol::Parameter(parameter));
        }
        let mut size = None;
        if !self.eat(Token::Mark(']')) {
            let limit = limits::MAX_PARAMETERS + 1;
            size = Some(usize::from(self.integer(limit, "elements")?));
            self.expect(']')?;
        }
        self.expect('=')?;
        self.expect('{')?;
        let mut array = Vec::new();
        loop {
            self.elements(&mut array)?;
            if array.len() > limits::MAX_PARAMETERS as usize {
                return self.fail("the array has more elements than there are parameters");
            }
            if !self.eat(Token::Mark(',')) {
                break;
            }
        }
        self.expect('}')?;
        if size.is_some_and(|size| size != array.len()) {
            let has = array.len();
            return Failure::at(position, format!("the array has {has} elements, not as it says"));
        }
        self.counts.parameters += array.len() as u32;
        let number = self.arrays.len() as u16;
        self.arrays.push(array);
        self.declare(name, Symbol::Array(number))
    }
}
