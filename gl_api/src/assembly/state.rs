//! Parsing of parameter bindings: constants, `program.env`, `program.local`, and `state`
//! (ARB_vertex_program, tables X.2.1 to X.2.8; ARB_fragment_program, tables X.3.1 to X.3.8).

use super::lexer::Token;
use super::parser::Parser;
use super::program::{Parameter, Target, Word};
use super::{Failure, Parsed};
use crate::base::assembly_limits as limits;
use crate::interface::*;

/// The parameters of a binding.
enum Binding {
    One(Parameter),
    /// Allowed for arrays only.
    Several(Vec<Parameter>),
}

/// Four words of a piece of state.
fn four(var: StateVar, first: u8) -> Binding {
    Binding::One(Parameter::State([0, 1, 2, 3].map(|at| Word::Of(var, first + at))))
}

/// Three words of a piece of state and a number.
fn three(var: StateVar, first: u8, last: f32) -> Binding {
    let [x, y, z] = [0, 1, 2].map(|at| Word::Of(var, first + at));
    Binding::One(Parameter::State([x, y, z, Word::Is(last)]))
}

impl Parser<'_> {
    /// A parameter that stands in an instruction.
    pub fn parameter(&mut self) -> Parsed<Parameter> {
        let position = self.position();
        match self.peek() {
            Token::Integer(_) | Token::Float(_) => {
                let value = self.number()?;
                Ok(Parameter::Constant([value; 4]))
            }
            Token::Mark('{') => self.constant(),
            _ => match self.bound()? {
                Binding::One(parameter) => Ok(parameter),
                Binding::Several(_) => {
                    Failure::at(position, "several parameters stand where there is one")
                }
            },
        }
    }

    /// A parameter that is declared: its constants may have signs.
    pub fn declared_parameter(&mut self) -> Parsed<Parameter> {
        match self.peek() {
            Token::Mark('+' | '-') => Ok(Parameter::Constant([self.signed()?; 4])),
            _ => self.parameter(),
        }
    }

    /// What an item of an array's initializer adds to it.
    pub fn elements(&mut self, array: &mut Vec<Parameter>) -> Parsed<()> {
        match self.peek() {
            Token::Word(_) => match self.bound()? {
                Binding::One(parameter) => array.push(parameter),
                Binding::Several(parameters) => array.extend(parameters),
            },
            _ => array.push(self.declared_parameter()?),
        }
        Ok(())
    }

    fn number(&mut self) -> Parsed<f32> {
        let value = match self.peek() {
            Token::Integer(value) => value as f32,
            Token::Float(value) => value,
            _ => return self.fail("expected a number"),
        };
        self.next();
        Ok(value)
    }

    fn signed(&mut self) -> Parsed<f32> {
        let negative = self.eat(Token::Mark('-'));
        if !negative {
            self.eat(Token::Mark('+'));
        }
        let value = self.number()?;
        Ok(if negative { -value } else { value })
    }

    /// `{ x, y, z, w }`; what is left out is 0, 0 and 1.
    fn constant(&mut self) -> Parsed<Parameter> {
        let mut values = [0.0, 0.0, 0.0, 1.0];
        self.expect('{')?;
        for (at, value) in values.iter_mut().enumerate() {
            if at > 0 && !self.eat(Token::Mark(',')) {
                break;
            }
            *value = self.signed()?;
        }
        self.expect('}')?;
        Ok(Parameter::Constant(values))
    }

    fn bound(&mut self) -> Parsed<Binding> {
        if self.eat(Token::Word("program")) {
            return self.program_parameters();
        }
        if self.eat(Token::Word("state")) {
            return self.state();
        }
        self.fail("expected program. or state.")
    }

    /// `program.env[n]`, `program.local[n..m]`.
    fn program_parameters(&mut self) -> Parsed<Binding> {
        let position = self.position();
        let (limit, make): (_, fn(u16) -> Parameter) = match self.member()? {
            "env" => (limits::MAX_ENV_PARAMETERS, Parameter::Env),
            "local" => (limits::MAX_LOCAL_PARAMETERS, Parameter::Local),
            other => return Failure::at(position, format!("there is no program.{other}")),
        };
        let (first, last) = self.indices(limit, "parameters")?;
        Ok(match first == last {
            true => Binding::One(make(first)),
            false => Binding::Several((first..=last).map(make).collect()),
        })
    }

    /// What follows `state`.
    fn state(&mut self) -> Parsed<Binding> {
        let position = self.position();
        let group = self.member()?;
        let bound = match (group, self.target) {
            ("material", _) => {
                let (side, part) = self.side()?;
                let var = StateVar::Material(side);
                match part {
                    "emission" => Some(four(var, 0)),
                    "ambient" => Some(four(var, 4)),
                    "diffuse" => Some(four(var, 8)),
                    "specular" => Some(four(var, 12)),
                    "shininess" => {
                        let rest = [0.0, 0.0, 1.0].map(Word::Is);
                        let words = [Word::Of(var, 16), rest[0], rest[1], rest[2]];
                        Some(Binding::One(Parameter::State(words)))
                    }
                    _ => None,
                }
            }
            ("light", _) => self.light()?,
            ("lightmodel", _) => match self.side()? {
                (Side::Front, "ambient") => Some(four(StateVar::LightModel, 0)),
                (side, "scenecolor") => Some(four(StateVar::LightModelProduct(side), 0)),
                (_, _) => None,
            },
            ("lightprod", _) => {
                let light = self.index(MAX_LIGHTS.into(), "lights")? as u8;
                let (side, part) = self.side()?;
                let product = StateVar::LightProduct(side, light);
                // Alpha is the material's.
                let of = |place: u8, alpha: u8| {
                    let [red, green, blue] = [0, 1, 2].map(|at| Word::Of(product, place + at));
                    let alpha = Word::Of(StateVar::Material(side), alpha);
                    Some(Binding::One(Parameter::State([red, green, blue, alpha])))
                };
                match part {
                    "ambient" => of(0, 7),
                    "diffuse" => of(4, 11),
                    "specular" => of(8, 15),
                    _ => None,
                }
            }
            ("texgen", Target::Vertex) => self.texgen()?,
            ("texenv", Target::Fragment) => {
                let unit = self.optional_index(MAX_TEXTURE_UNITS.into(), "texture units")? as u8;
                (self.member()? == "color").then(|| four(StateVar::TextureEnvColor(unit), 0))
            }
            ("fog", _) => match self.member()? {
                "color" => Some(four(StateVar::Fog, 0)),
                "params" => Some(four(StateVar::Fog, 4)),
                _ => None,
            },
            ("clip", Target::Vertex) => {
                let plane = self.index(MAX_CLIP_PLANES.into(), "clip planes")? as u8;
                (self.member()? == "plane").then(|| four(StateVar::ClipPlane(plane), 0))
            }
            ("point", Target::Vertex) => match self.member()? {
                "size" => Some(four(StateVar::Point, 0)),
                "attenuation" => Some(three(StateVar::Point, 4, 1.0)),
                _ => None,
            },
            ("depth", Target::Fragment) => {
                (self.member()? == "range").then(|| three(StateVar::DepthRange, 0, 1.0))
            }
            ("matrix", _) => Some(self.matrix()?),
            (_, _) => None,
        };
        match bound {
            Some(bound) => Ok(bound),
            None => Failure::at(position, format!("there is no such part of state.{group}")),
        }
    }

    /// `.front.part`, `.back.part` or `.part`, which is the front's.
    fn side(&mut self) -> Parsed<(Side, &str)> {
        Ok(match self.member()? {
            "front" => (Side::Front, self.member()?),
            "back" => (Side::Back, self.member()?),
            part => (Side::Front, part),
        })
    }

    fn light(&mut self) -> Parsed<Option<Binding>> {
        let var = StateVar::Light(self.index(MAX_LIGHTS.into(), "lights")? as u8);
        let of = |words: [u8; 4]| {
            Some(Binding::One(Parameter::State(words.map(|word| Word::Of(var, word)))))
        };
        Ok(match self.member()? {
            "ambient" => Some(four(var, 0)),
            "diffuse" => Some(four(var, 4)),
            "specular" => Some(four(var, 8)),
            "position" => Some(four(var, 12)),
            "half" => Some(three(var, 16, 1.0)),
            // The direction and the cosine of the cutoff; the factors and the spot's exponent.
            "spot" if self.member()? == "direction" => of([20, 21, 22, 25]),
            "attenuation" => of([26, 27, 28, 23]),
            _ => None,
        })
    }

    fn texgen(&mut self) -> Parsed<Option<Binding>> {
        let unit = self.optional_index(MAX_TEXTURE_UNITS.into(), "texture units")? as u8;
        let plane = match self.member()? {
            "eye" => TexGenPlane::Eye,
            "object" => TexGenPlane::Object,
            _ => return Ok(None),
        };
        let coord = match self.member()? {
            "s" => TexCoord::S,
            "t" => TexCoord::T,
            "r" => TexCoord::R,
            "q" => TexCoord::Q,
            _ => return Ok(None),
        };
        Ok(Some(four(StateVar::TexGen(plane, coord, unit), 0)))
    }

    /// Rows of a matrix, whose words go column by column.
    fn matrix(&mut self) -> Parsed<Binding> {
        let position = self.position();
        let matrix = match self.member()? {
            "modelview" => {
                self.optional_index(1, "model-view matrices")?;
                StateMatrix::ModelView
            }
            "projection" => StateMatrix::Projection,
            "mvp" => StateMatrix::ModelViewProjection,
            "texture" => {
                let unit = self.optional_index(MAX_TEXTURE_UNITS.into(), "texture matrices")?;
                StateMatrix::Texture(unit as u8)
            }
            "program" => {
                let limit = limits::MAX_PROGRAM_MATRICES.into();
                StateMatrix::Program(self.index(limit, "program matrices")? as u8)
            }
            other => return Failure::at(position, format!("there is no state.matrix.{other}")),
        };
        let form = match self.coming_member() {
            Some("inverse") => MatrixForm::Inverse,
            Some("transpose") => MatrixForm::Transpose,
            Some("invtrans") => MatrixForm::InverseTranspose,
            Some(_) | None => MatrixForm::Plain,
        };
        if form != MatrixForm::Plain {
            self.member()?;
        }
        let var = StateVar::Matrix(matrix, form);
        let row = |row: u16| {
            Parameter::State([0, 4, 8, 12].map(|column| Word::Of(var, column + row as u8)))
        };
        if self.coming_member() != Some("row") {
            return Ok(Binding::Several((0..4).map(row).collect()));
        }
        self.member()?;
        let (first, last) = self.indices(4, "rows")?;
        Ok(match first == last {
            true => Binding::One(row(first)),
            false => Binding::Several((first..=last).map(row).collect()),
        })
    }
}
