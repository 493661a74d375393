//! A program to IR. There are no jumps, so a temporary is the values that were last written to it.

use super::arithmetic::Math;
use super::layout::Layout;
use super::program::{
    Attribute, Destination, Fog, Instruction, Lookup, Opcode, Options, Pick, Program, Register,
    Result as Output, Saturation, Source, Target, Written,
};
use crate::base::assembly_limits::MAX_ADDRESS_REGISTERS;
use crate::base::limits::MAX_COLOR_ATTACHMENTS;
use crate::base::vector::{clamp, transform};
use crate::glsl::{ComparisonResult, Dim, SamplerSlot};
use crate::interface::*;
use rasterizer::ir;
use rasterizer::ir::{
    Builder, Expr, Input, Interpolation, Lod, Module, Op, Stage, Stmt, Texture, TextureDecl, Ty,
    Value,
};
use texunit::image::Shape;

/// The stage of a kind of program.
pub(crate) fn stage(target: Target) -> Stage {
    match target {
        Target::Vertex => Stage::Vertex,
        Target::Fragment => Stage::Fragment,
    }
}

/// A program as IR.
pub(crate) struct Lowered {
    pub module: Module,
    pub layout: Layout,
    pub samplers: Vec<SamplerSlot>,
}

/// Where a vector is kept.
enum Place {
    Temporary(usize),
    Result(usize),
}

struct Lowerer<'a> {
    program: &'a Program,
    math: Math,
    layout: Layout,
    /// What was last written, by number.
    temporaries: Vec<Option<[Value; 4]>>,
    addresses: [Option<Value>; MAX_ADDRESS_REGISTERS as usize],
    results: Vec<(Output, [Value; 4])>,
    /// By unit.
    textures: [Option<Texture>; MAX_TEXTURE_IMAGE_UNITS as usize],
    samplers: Vec<SamplerSlot>,
}

/// Lowers a program.
pub(crate) fn lower(program: &Program) -> Lowered {
    let mut lowerer = Lowerer {
        program,
        math: Math { b: Builder::new(stage(program.target)) },
        layout: Layout::default(),
        temporaries: vec![None; program.counts.temporaries as usize],
        addresses: [None; MAX_ADDRESS_REGISTERS as usize],
        results: Vec::new(),
        textures: [None; MAX_TEXTURE_IMAGE_UNITS as usize],
        samplers: Vec::new(),
    };
    for instruction in &program.instructions {
        lowerer.instruction(instruction);
    }
    match program.target {
        Target::Vertex => lowerer.vertex_results(),
        Target::Fragment => lowerer.fragment_results(),
    }
    let Lowerer { math, layout, samplers, .. } = lowerer;
    let mut module = math.b.finish();
    if program.target == Target::Fragment {
        module.varyings = vec![Interpolation::Smooth; usize::from(VARYING_USER)];
    }
    // Elements that an address reaches count as well.
    module.uniform_words = layout.len();
    Lowered { module, layout, samplers }
}

impl Lowerer<'_> {
    /// What was never written: 0, 0, 0, 1.
    fn unwritten(&mut self) -> [Value; 4] {
        [0.0, 0.0, 0.0, 1.0].map(|value| self.math.b.float(value))
    }

    fn attribute(&mut self, attribute: Attribute) -> [Value; 4] {
        let b = &mut self.math.b;
        match attribute {
            Attribute::Vertex(location) => {
                [0, 1, 2, 3].map(|component| b.input(Input::Attribute { location, component }))
            }
            Attribute::Varyings(first) => {
                [0, 1, 2, 3].map(|slot| b.input(Input::Varying(first + slot)))
            }
            Attribute::Fog => {
                let fog = b.input(Input::Varying(VARYING_FOG));
                let [zero, one] = [0.0, 1.0].map(|value| b.float(value));
                [fog, zero, zero, one]
            }
            Attribute::Position => self.position(),
        }
    }

    /// `fragment.position`, as `ARB_fragment_coord_conventions` may have it.
    fn position(&mut self) -> [Value; 4] {
        let Options { origin_upper_left, pixel_center_integer, .. } = self.program.options;
        let mut position = [0, 1, 2, 3].map(|i| self.math.b.input(Input::FragCoord(i)));
        if origin_upper_left {
            let word = self.layout.state(StateVar::FramebufferHeight);
            let height = self.math.b.uniform(word, Ty::F32);
            position[1] = self.math.b.op(Op::Sub, &[height, position[1]]);
        }
        if pixel_center_integer {
            let half = self.math.b.float(0.5);
            for coordinate in &mut position[..2] {
                *coordinate = self.math.b.op(Op::Sub, &[*coordinate, half]);
            }
        }
        position
    }

    fn register(&mut self, register: Register) -> [Value; 4] {
        match register {
            Register::Temporary(number) => match self.temporaries[usize::from(number)] {
                Some(values) => values,
                None => self.unwritten(),
            },
            Register::Attribute(attribute) => self.attribute(attribute),
            Register::Parameter(parameter) => self.layout.parameter(&mut self.math.b, parameter),
            Register::Relative { array, address, offset } => self.element(array, address, offset),
        }
    }

    /// Element `address + offset` of an array; beyond its ends, the last one.
    fn element(&mut self, array: u16, address: u16, offset: i32) -> [Value; 4] {
        let elements = &self.program.arrays[usize::from(array)];
        let first = self.layout.array(array, elements);
        let b = &mut self.math.b;
        let address = match self.addresses[usize::from(address)] {
            Some(address) => address,
            None => b.int(0),
        };
        let (offset, four) = (b.int(offset), b.int(4));
        let element = b.op(Op::IAdd, &[address, offset]);
        let index = b.op(Op::IMul, &[element, four]);
        let len = 4 * elements.len() as u32 - 3;
        [0, 1, 2, 3].map(|component| {
            b.value(Expr::UniformAt { base: first + component, len, index, ty: Ty::F32 })
        })
    }

    fn source(&mut self, source: &Source) -> [Value; 4] {
        let values = self.register(source.register);
        std::array::from_fn(|at| {
            let value = match source.picks[at] {
                Pick::Component(component) => values[usize::from(component)],
                Pick::Zero => self.math.b.float(0.0),
                Pick::One => self.math.b.float(1.0),
            };
            if source.negated[at] { self.math.b.op(Op::Neg, &[value]) } else { value }
        })
    }

    fn instruction(&mut self, instruction: &Instruction) {
        let sources: Vec<[Value; 4]> =
            instruction.sources.iter().map(|source| self.source(source)).collect();
        // What lacks further operands does not look at them.
        let operand = |at: usize| sources.get(at).copied().unwrap_or(sources[0]);
        let operands = [operand(0), operand(1), operand(2)];
        let mut values = match (instruction.opcode, instruction.lookup) {
            (Opcode::Kil, _) => return self.kill(operands[0]),
            (opcode, Some(lookup)) => self.sample(opcode, operands[0], lookup),
            (opcode, None) => self.math.compute(opcode, operands),
        };
        if instruction.saturation == Saturation::On {
            values = values.map(|value| clamp(&mut self.math.b, value));
        }
        self.write(instruction.destination, values);
    }

    fn write(&mut self, Destination { written, mask }: Destination, values: [Value; 4]) {
        let place = match written {
            Written::Nowhere => return,
            Written::Address(number) => {
                self.addresses[usize::from(number)] = Some(values[0]);
                return;
            }
            Written::Temporary(number) => Place::Temporary(usize::from(number)),
            Written::Result(result) => {
                let known = self.results.iter().position(|(other, _)| *other == result);
                Place::Result(known.unwrap_or_else(|| {
                    let unwritten = self.unwritten();
                    self.results.push((result, unwritten));
                    self.results.len() - 1
                }))
            }
        };
        let old = match place {
            Place::Temporary(at) => self.temporaries[at],
            Place::Result(at) => Some(self.results[at].1),
        };
        let old = old.unwrap_or_else(|| self.unwritten());
        let new = std::array::from_fn(|at| if mask[at] { values[at] } else { old[at] });
        match place {
            Place::Temporary(at) => self.temporaries[at] = Some(new),
            Place::Result(at) => self.results[at].1 = new,
        }
    }

    /// Discards the fragment where a component is negative.
    fn kill(&mut self, values: [Value; 4]) {
        let b = &mut self.math.b;
        let zero = b.float(0.0);
        let negative = values.map(|value| b.op(Op::Less, &[value, zero]));
        let any = negative.into_iter().reduce(|any, one| b.op(Op::Or, &[any, one]));
        if let Some(condition) = any {
            let (accept, reject) = (vec![Stmt::Discard], Vec::new());
            b.push(Stmt::If { condition, accept, reject });
        }
    }

    fn sample(&mut self, opcode: Opcode, coords: [Value; 4], lookup: Lookup) -> [Value; 4] {
        let texture = self.texture(lookup);
        let b = &mut self.math.b;
        let [mut s, mut t, mut r, q] = coords;
        let mut bias = None;
        if opcode == Opcode::Txp {
            [s, t, r] = [s, t, r].map(|coord| b.op(Op::Div, &[coord, q]));
        } else if opcode == Opcode::Txb {
            bias = Some(q);
        }
        let zero = b.float(0.0);
        let coords = match lookup.shape {
            Shape::D1 => [s, zero, zero],
            Shape::D2 | Shape::Rect | Shape::D1Array => [s, t, zero],
            Shape::D3 | Shape::Cube | Shape::D2Array | Shape::CubeArray => [s, t, r],
        };
        b.sample(texture, coords, lookup.compare.then_some(r), Lod::Implicit { bias })
    }

    /// The slot of a unit's texture.
    fn texture(&mut self, Lookup { unit, shape, compare }: Lookup) -> Texture {
        if let Some(texture) = self.textures[usize::from(unit)] {
            return texture;
        }
        let decl = TextureDecl { compare, ..TextureDecl::color(shape) };
        let texture = self.math.b.texture(decl);
        self.textures[usize::from(unit)] = Some(texture);
        let dim = match shape {
            Shape::D1 => Dim::D1,
            Shape::D3 => Dim::D3,
            Shape::Cube => Dim::Cube,
            Shape::Rect => Dim::Rect,
            // No target names an array.
            Shape::D2 | Shape::D1Array | Shape::D2Array | Shape::CubeArray => Dim::D2,
        };
        self.samplers.push(SamplerSlot {
            stage: stage(self.program.target),
            slot: texture.0,
            word: self.layout.constant(u32::from(unit)),
            dim,
            // Without the option, the mode of comparison does not count.
            result: if compare {
                ComparisonResult::DepthTextureMode
            } else {
                ComparisonResult::Ignored
            },
        });
        texture
    }

    fn store(&mut self, output: ir::Output, value: Value) {
        let var = self.math.b.output(output);
        self.math.b.store(var, value);
    }

    fn vertex_results(&mut self) {
        if self.program.options.position_invariant {
            // As the fixed function computes it, to the bit.
            let mvp = StateVar::Matrix(StateMatrix::ModelViewProjection, MatrixForm::Plain);
            let word = self.layout.state(mvp);
            let position = self.attribute(Attribute::Vertex(ATTRIB_VERTEX));
            let position = transform(&mut self.math.b, word, position);
            self.results.push((Output::Position, position));
        }
        for (result, values) in std::mem::take(&mut self.results) {
            match result {
                Output::Position => {
                    for (component, value) in (0..).zip(values) {
                        self.store(ir::Output::Position(component), value);
                    }
                }
                Output::PointSize => self.store(ir::Output::PointSize, values[0]),
                Output::Fog => self.store(ir::Output::Varying(VARYING_FOG), values[0]),
                Output::Varyings(first) => {
                    for (slot, value) in (first..).zip(values) {
                        self.store(ir::Output::Varying(slot), value);
                    }
                }
                Output::Color(_) | Output::Depth => {}
            }
        }
    }

    fn fragment_results(&mut self) {
        for (result, mut values) in std::mem::take(&mut self.results) {
            let target = match result {
                // The depth is z.
                Output::Depth => {
                    self.store(ir::Output::Depth, values[2]);
                    continue;
                }
                Output::Color(target) => target,
                Output::Position | Output::PointSize | Output::Fog | Output::Varyings(_) => {
                    continue;
                }
            };
            if let Some(fog) = self.program.options.fog {
                values = self.fog(fog, values);
            }
            // Without draw buffers of its own, every one takes the colour.
            let all = if self.program.options.draw_buffers {
                target..target + 1
            } else {
                0..MAX_COLOR_ATTACHMENTS as u8
            };
            for (component, value) in (0..).zip(values) {
                let first = ir::Output::Color { target: all.start, component };
                let var = self.math.b.output(first);
                self.math.b.store(var, value);
                let others = all.clone().skip(1);
                let outputs = &mut self.math.b.module_mut().outputs;
                outputs.extend(others.map(|target| (ir::Output::Color { target, component }, var)));
            }
        }
    }

    /// A colour in fog, held in [0, 1] before (ARB_fragment_program, section 3.11.4.5.1).
    fn fog(&mut self, fog: Fog, color: [Value; 4]) -> [Value; 4] {
        let first = self.layout.state(StateVar::Fog);
        let b = &mut self.math.b;
        let [red, green, blue, _, density, _, end, scale] =
            [0, 1, 2, 3, 4, 5, 6, 7].map(|word| b.uniform(first + word, Ty::F32));
        let distance = b.input(Input::Varying(VARYING_FOG));
        let clear = match fog {
            Fog::Linear => {
                let left = b.op(Op::Sub, &[end, distance]);
                b.op(Op::Mul, &[left, scale])
            }
            Fog::Exp | Fog::Exp2 => {
                let mut exponent = b.op(Op::Mul, &[density, distance]);
                if fog == Fog::Exp2 {
                    exponent = b.op(Op::Mul, &[exponent, exponent]);
                }
                let exponent = b.op(Op::Neg, &[exponent]);
                b.op(Op::Exp, &[exponent])
            }
        };
        let clear = clamp(b, clear);
        let [r, g, blue_of, alpha] = color.map(|value| clamp(b, value));
        let mut mix = |value: Value, of_fog: Value| {
            let apart = b.op(Op::Sub, &[value, of_fog]);
            let part = b.op(Op::Mul, &[apart, clear]);
            b.op(Op::Add, &[part, of_fog])
        };
        [mix(r, red), mix(g, green), mix(blue_of, blue), alpha]
    }
}
