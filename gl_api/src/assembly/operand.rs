//! Parsing of operands: sources with swizzles, destinations with masks.

use super::lexer::Token;
use super::parser::{Parser, Symbol};
use super::program::{
    Attribute, Destination, Lookup, Parameter, Pick, Register, Result as Output, Source, Target,
    Written,
};
use super::{Failure, Parsed};
use crate::base::limits::MAX_COLOR_ATTACHMENTS;
use crate::interface::*;
use texunit::image::Shape;

/// The names of the components; the second only in fragment programs.
const COMPONENTS: [&str; 2] = ["xyzw", "rgba"];
/// How far from its address an element may be.
const MAX_OFFSET: u32 = 1 << 14;

/// A source without swizzle.
fn whole(register: Register) -> Source {
    Source { register, picks: [0, 1, 2, 3].map(Pick::Component), negated: [false; 4] }
}

impl Parser<'_> {
    /// The components that a word names, all of one set, if it names nothing else.
    fn components(&self, word: &str) -> Option<Vec<u8>> {
        let sets = match self.target {
            Target::Vertex => &COMPONENTS[..1],
            Target::Fragment => &COMPONENTS[..],
        };
        sets.iter().find_map(|set| {
            word.chars().map(|name| set.find(name).map(|place| place as u8)).collect()
        })
    }

    /// `+`, `-` or nothing; whether it negates.
    fn sign(&mut self) -> bool {
        let negative = self.eat(Token::Mark('-'));
        if !negative {
            self.eat(Token::Mark('+'));
        }
        negative
    }

    /// A vector: a register, its sign, and four components or one for all.
    pub fn vector(&mut self) -> Parsed<Source> {
        let negative = self.sign();
        let mut source = self.register()?;
        if self.coming_member().is_some() {
            source.picks = self.swizzle()?;
        }
        source.negated = [negative; 4];
        Ok(source)
    }

    /// `.x` or `.xyzw`.
    fn swizzle(&mut self) -> Parsed<[Pick; 4]> {
        let position = self.position();
        let word = self.member()?;
        match self.components(word).as_deref() {
            Some(&[all]) => Ok([Pick::Component(all); 4]),
            Some(&[x, y, z, w]) => Ok([x, y, z, w].map(Pick::Component)),
            Some(_) | None => Failure::at(position, format!(".{word} is no swizzle")),
        }
    }

    /// A number: one component of a register.
    pub fn scalar(&mut self) -> Parsed<Source> {
        let negative = self.sign();
        let mut source = self.register()?;
        let position = self.position();
        let word = self.member()?;
        let Some(&[component]) = self.components(word).as_deref() else {
            return Failure::at(position, format!(".{word} is not one component"));
        };
        source.picks = [Pick::Component(component); 4];
        source.negated = [negative; 4];
        Ok(source)
    }

    /// The operand of `SWZ`: a register, and a sign and a component, 0 or 1 for each component.
    pub fn swizzled(&mut self) -> Parsed<Source> {
        let mut source = self.register()?;
        let mut names = String::new();
        for at in 0..4 {
            self.expect(',')?;
            source.negated[at] = self.sign();
            source.picks[at] = match self.peek() {
                Token::Integer(0) => Pick::Zero,
                Token::Integer(1) => Pick::One,
                Token::Word(word) => match self.components(word).as_deref() {
                    Some(&[component]) => {
                        names.push_str(word);
                        Pick::Component(component)
                    }
                    Some(_) | None => return self.fail(format!("{word} is no component")),
                },
                _ => return self.fail("expected 0, 1 or a component"),
            };
            if self.components(&names).is_none() {
                return self.fail("components of colours and of coordinates are mixed");
            }
            self.next();
        }
        Ok(source)
    }

    /// A register or constant, as it is.
    fn register(&mut self) -> Parsed<Source> {
        Ok(whole(match (self.peek(), self.target) {
            (Token::Word("vertex"), Target::Vertex)
            | (Token::Word("fragment"), Target::Fragment) => Register::Attribute(self.attribute()?),
            (Token::Word("program" | "state"), _) => self.inline_parameter()?,
            (Token::Word(_), _) => self.variable()?,
            (Token::Integer(_) | Token::Float(_) | Token::Mark('{'), _) => {
                self.inline_parameter()?
            }
            (Token::Mark(_) | Token::Range | Token::End, _) => {
                return self.fail("expected an operand");
            }
        }))
    }

    /// A parameter that has no name; the same one counts once.
    fn inline_parameter(&mut self) -> Parsed<Register> {
        let parameter = self.parameter()?;
        if !self.inline.contains(&parameter) {
            self.inline.push(parameter);
            self.counts.parameters += 1;
        }
        Ok(Register::Parameter(parameter))
    }

    fn variable(&mut self) -> Parsed<Register> {
        let position = self.position();
        Ok(match self.symbol()? {
            Symbol::Temporary(number) => Register::Temporary(number),
            Symbol::Attribute(attribute) => Register::Attribute(attribute),
            Symbol::Parameter(parameter) => Register::Parameter(parameter),
            Symbol::Array(array) => self.element(array)?,
            Symbol::Address(_) => return Failure::at(position, "an address is no operand"),
            Symbol::Result(_) => return Failure::at(position, "results cannot be read"),
        })
    }

    /// `[n]`, or `[A0.x + n]` in vertex programs.
    fn element(&mut self, array: u16) -> Parsed<Register> {
        let elements = &self.arrays[usize::from(array)];
        let len = elements.len() as u32;
        self.expect('[')?;
        let register = match self.peek() {
            Token::Integer(_) => {
                let at = self.integer(len, "elements")?;
                Register::Parameter(self.arrays[usize::from(array)][usize::from(at)])
            }
            _ => {
                let position = self.position();
                let Symbol::Address(address) = self.symbol()? else {
                    return Failure::at(position, "only an address can index an array");
                };
                self.address_component()?;
                let offset = match self.peek() {
                    Token::Mark(sign @ ('+' | '-')) => {
                        self.next();
                        let offset = i32::from(self.integer(MAX_OFFSET, "elements")?);
                        if sign == '-' { -offset } else { offset }
                    }
                    _ => 0,
                };
                self.check_indexed(array, position)?;
                Register::Relative { array, address, offset }
            }
        };
        self.expect(']')?;
        Ok(register)
    }

    /// An array that an address indexes has every parameter once (ARB_vertex_program, section
    /// 2.14.3.2).
    fn check_indexed(&mut self, array: u16, position: usize) -> Parsed<()> {
        if self.indexed.contains(&array) {
            return Ok(());
        }
        self.indexed.push(array);
        let elements = &self.arrays[usize::from(array)];
        // Constants may repeat.
        let twice = elements.iter().enumerate().any(|(at, element)| {
            !matches!(element, Parameter::Constant(_)) && elements[..at].contains(element)
        });
        if twice {
            return Failure::at(position, "the indexed array has a parameter twice");
        }
        Ok(())
    }

    /// `.x`, the one component of an address.
    fn address_component(&mut self) -> Parsed<()> {
        let position = self.position();
        match self.member()? {
            "x" => Ok(()),
            other => Failure::at(position, format!("addresses have no component {other}, only x")),
        }
    }

    /// The address that `ARL` writes.
    pub fn address(&mut self) -> Parsed<Destination> {
        let position = self.position();
        let Symbol::Address(number) = self.symbol()? else {
            return Failure::at(position, "expected an address");
        };
        self.address_component()?;
        Ok(Destination { written: Written::Address(number), mask: [true, false, false, false] })
    }

    /// A destination with its mask.
    pub fn destination(&mut self) -> Parsed<Destination> {
        let position = self.position();
        let written = if self.eat(Token::Word("result")) {
            Written::Result(self.result()?)
        } else {
            match self.symbol()? {
                Symbol::Temporary(number) => Written::Temporary(number),
                Symbol::Result(result) => Written::Result(result),
                Symbol::Address(_) => return Failure::at(position, "only ARL writes addresses"),
                Symbol::Attribute(_) | Symbol::Parameter(_) | Symbol::Array(_) => {
                    return Failure::at(position, "what comes into a program cannot be written");
                }
            }
        };
        let mut mask = [true; 4];
        if self.coming_member().is_some() {
            let position = self.position();
            let word = self.member()?;
            let components = self.components(word).filter(|all| all.is_sorted_by(|a, b| a < b));
            let Some(components) = components else {
                return Failure::at(position, format!(".{word} is no mask"));
            };
            mask = [0, 1, 2, 3].map(|component| components.contains(&component));
        }
        Ok(Destination { written, mask })
    }

    /// An attribute: `vertex.…` or `fragment.…`.
    pub fn attribute(&mut self) -> Parsed<Attribute> {
        let position = self.position();
        let root = match self.target {
            Target::Vertex => "vertex",
            Target::Fragment => "fragment",
        };
        if !self.eat(Token::Word(root)) {
            return self.fail(format!("expected {root}."));
        }
        let attribute = match self.target {
            Target::Vertex => self.vertex_attribute(position)?,
            Target::Fragment => self.fragment_attribute(position)?,
        };
        if !self.attributes.contains(&attribute) {
            self.attributes.push(attribute);
        }
        Ok(attribute)
    }

    /// Whether `.primary` or `.secondary` follows a colour; it is taken.
    fn is_secondary(&mut self) -> Parsed<bool> {
        match self.coming_member() {
            Some("primary") => self.member().map(|_| false),
            Some("secondary") => self.member().map(|_| true),
            Some(_) | None => Ok(false),
        }
    }

    /// Attributes, and the number of the generic one that each may share its place with
    /// (ARB_vertex_program, table X.1): a program names one of the two.
    fn vertex_attribute(&mut self, position: usize) -> Parsed<Attribute> {
        let units = u32::from(MAX_TEXTURE_UNITS);
        let (location, number, way) = match self.member()? {
            "position" => (ATTRIB_VERTEX, 0, 0),
            "normal" => (ATTRIB_NORMAL, 2, 0),
            "color" if self.is_secondary()? => (ATTRIB_SECONDARY_COLOR, 4, 0),
            "color" => (ATTRIB_COLOR, 3, 0),
            "fogcoord" => (ATTRIB_FOG_COORD, 5, 0),
            "texcoord" => {
                let unit = self.optional_index(units, "texture coordinates")? as u8;
                (ATTRIB_TEX_COORD + unit, 8 + unit, 0)
            }
            "attrib" => {
                let index = self.index(MAX_VERTEX_ATTRIBS.into(), "attributes")? as u8;
                (index, index, 1)
            }
            other => {
                let known =
                    ["position", "normal", "color", "fogcoord", "texcoord", "attrib", "weight"];
                let message = format!("there is no vertex.{other}");
                return Err(Failure::unknown(position, message, other, &known));
            }
        };
        self.named[way] |= 1 << number;
        if self.named[1 - way] >> number & 1 == 1 {
            let message = format!("the attribute is vertex.attrib[{number}] too: use one of both");
            return Failure::at(position, message);
        }
        Ok(Attribute::Vertex(location))
    }

    fn fragment_attribute(&mut self, position: usize) -> Parsed<Attribute> {
        Ok(match self.member()? {
            "color" if self.is_secondary()? => Attribute::Varyings(VARYING_SECONDARY_COLOR),
            "color" => Attribute::Varyings(VARYING_COLOR),
            "texcoord" => {
                let unit = self.optional_index(MAX_TEXTURE_UNITS.into(), "texture coordinates")?;
                Attribute::Varyings(VARYING_TEX_COORD + 4 * unit)
            }
            "fogcoord" => Attribute::Fog,
            "position" => Attribute::Position,
            other => {
                let known = ["position", "color", "fogcoord", "texcoord"];
                let message = format!("there is no fragment.{other}");
                return Err(Failure::unknown(position, message, other, &known));
            }
        })
    }

    /// What follows `result`.
    pub fn result(&mut self) -> Parsed<Output> {
        let position = self.position();
        let name = self.member()?;
        Ok(match (name, self.target) {
            ("position", Target::Vertex) if self.options.position_invariant => {
                return Failure::at(position, "ARB_position_invariant writes result.position");
            }
            ("position", Target::Vertex) => Output::Position,
            ("pointsize", Target::Vertex) => Output::PointSize,
            ("fogcoord", Target::Vertex) => Output::Fog,
            ("texcoord", Target::Vertex) => {
                let unit = self.optional_index(MAX_TEXTURE_UNITS.into(), "texture coordinates")?;
                Output::Varyings(VARYING_TEX_COORD + 4 * unit)
            }
            ("color", Target::Vertex) => {
                let side = self.coming_member().filter(|side| ["front", "back"].contains(side));
                if side.is_some() {
                    self.member()?;
                }
                let base = if side == Some("back") { VARYING_BACK_COLOR } else { VARYING_COLOR };
                let secondary = VARYING_SECONDARY_COLOR - VARYING_COLOR;
                Output::Varyings(base + if self.is_secondary()? { secondary } else { 0 })
            }
            ("color", Target::Fragment) if self.peek() == Token::Mark('[') => {
                if !self.options.draw_buffers {
                    return self.fail("result.color[n] needs OPTION ARB_draw_buffers");
                }
                Output::Color(self.index(MAX_COLOR_ATTACHMENTS as u32, "colors")? as u8)
            }
            ("color", Target::Fragment) => Output::Color(0),
            ("depth", Target::Fragment) => Output::Depth,
            (other, _) => {
                let known = ["position", "color", "fogcoord", "pointsize", "texcoord", "depth"];
                let message = format!("there is no result.{other}");
                return Err(Failure::unknown(position, message, other, &known));
            }
        })
    }

    /// `texture[n], 2D`.
    pub fn texture(&mut self) -> Parsed<Lookup> {
        if !self.eat(Token::Word("texture")) {
            return self.fail("expected texture[n]");
        }
        let unit = self.optional_index(MAX_TEXTURE_IMAGE_UNITS.into(), "texture units")? as u8;
        self.expect(',')?;
        let position = self.position();
        let name = self.word("a texture target")?;
        let (shape, compare) = match name {
            "1D" => (Shape::D1, false),
            "2D" => (Shape::D2, false),
            "3D" => (Shape::D3, false),
            "CUBE" => (Shape::Cube, false),
            "RECT" => (Shape::Rect, false),
            "SHADOW1D" => (Shape::D1, true),
            "SHADOW2D" => (Shape::D2, true),
            "SHADOWRECT" => (Shape::Rect, true),
            _ => return Failure::at(position, format!("{name} is no texture target")),
        };
        if compare && !self.options.shadow {
            let message = format!("{name} needs OPTION ARB_fragment_program_shadow");
            return Failure::at(position, message);
        }
        Ok(Lookup { unit, shape, compare })
    }
}
