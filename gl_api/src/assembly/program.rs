//! A parsed program: instructions whose operands are resolved.

use crate::interface::StateVar;
use texunit::image::Shape;

/// The target of a program: its stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Target {
    /// `GL_VERTEX_PROGRAM_ARB`.
    Vertex,
    /// `GL_FRAGMENT_PROGRAM_ARB`.
    Fragment,
}

impl Target {
    /// Where its programs are specified.
    pub fn section(self) -> &'static str {
        match self {
            Self::Vertex => "ARB_vertex_program, section 2.14",
            Self::Fragment => "ARB_fragment_program, section 3.11",
        }
    }
}

/// The operation of an instruction (ARB_vertex_program, table X.5; ARB_fragment_program, table X.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Opcode {
    Abs,
    Add,
    Arl,
    Cmp,
    Cos,
    Dp3,
    Dp4,
    Dph,
    Dst,
    Ex2,
    Exp,
    Flr,
    Frc,
    Kil,
    Lg2,
    Lit,
    Log,
    Lrp,
    Mad,
    Max,
    Min,
    Mov,
    Mul,
    Pow,
    Rcp,
    Rsq,
    Scs,
    Sge,
    Sin,
    Slt,
    Sub,
    Swz,
    Tex,
    Txb,
    Txp,
    Xpd,
}

/// The operands of an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operands {
    /// A destination and so many vectors.
    Vectors(u8),
    /// A destination and so many numbers.
    Scalars(u8),
    /// An address and a number.
    Address,
    /// A destination, a vector, and where each component comes from.
    Swizzle,
    /// A destination, coordinates, a unit and its target.
    Texture,
    /// A vector.
    Condition,
}

/// The targets that have an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Of {
    Both,
    Only(Target),
}

impl Of {
    fn has(self, target: Target) -> bool {
        match self {
            Self::Both => true,
            Self::Only(only) => only == target,
        }
    }
}

/// Every instruction.
const INSTRUCTIONS: &[(&str, Opcode, Operands, Of)] = &[
    ("ABS", Opcode::Abs, Operands::Vectors(1), Of::Both),
    ("ADD", Opcode::Add, Operands::Vectors(2), Of::Both),
    ("ARL", Opcode::Arl, Operands::Address, Of::Only(Target::Vertex)),
    ("CMP", Opcode::Cmp, Operands::Vectors(3), Of::Only(Target::Fragment)),
    ("COS", Opcode::Cos, Operands::Scalars(1), Of::Only(Target::Fragment)),
    ("DP3", Opcode::Dp3, Operands::Vectors(2), Of::Both),
    ("DP4", Opcode::Dp4, Operands::Vectors(2), Of::Both),
    ("DPH", Opcode::Dph, Operands::Vectors(2), Of::Both),
    ("DST", Opcode::Dst, Operands::Vectors(2), Of::Both),
    ("EX2", Opcode::Ex2, Operands::Scalars(1), Of::Both),
    ("EXP", Opcode::Exp, Operands::Scalars(1), Of::Only(Target::Vertex)),
    ("FLR", Opcode::Flr, Operands::Vectors(1), Of::Both),
    ("FRC", Opcode::Frc, Operands::Vectors(1), Of::Both),
    ("KIL", Opcode::Kil, Operands::Condition, Of::Only(Target::Fragment)),
    ("LG2", Opcode::Lg2, Operands::Scalars(1), Of::Both),
    ("LIT", Opcode::Lit, Operands::Vectors(1), Of::Both),
    ("LOG", Opcode::Log, Operands::Scalars(1), Of::Only(Target::Vertex)),
    ("LRP", Opcode::Lrp, Operands::Vectors(3), Of::Only(Target::Fragment)),
    ("MAD", Opcode::Mad, Operands::Vectors(3), Of::Both),
    ("MAX", Opcode::Max, Operands::Vectors(2), Of::Both),
    ("MIN", Opcode::Min, Operands::Vectors(2), Of::Both),
    ("MOV", Opcode::Mov, Operands::Vectors(1), Of::Both),
    ("MUL", Opcode::Mul, Operands::Vectors(2), Of::Both),
    ("POW", Opcode::Pow, Operands::Scalars(2), Of::Both),
    ("RCP", Opcode::Rcp, Operands::Scalars(1), Of::Both),
    ("RSQ", Opcode::Rsq, Operands::Scalars(1), Of::Both),
    ("SCS", Opcode::Scs, Operands::Scalars(1), Of::Only(Target::Fragment)),
    ("SGE", Opcode::Sge, Operands::Vectors(2), Of::Both),
    ("SIN", Opcode::Sin, Operands::Scalars(1), Of::Only(Target::Fragment)),
    ("SLT", Opcode::Slt, Operands::Vectors(2), Of::Both),
    ("SUB", Opcode::Sub, Operands::Vectors(2), Of::Both),
    ("SWZ", Opcode::Swz, Operands::Swizzle, Of::Both),
    ("TEX", Opcode::Tex, Operands::Texture, Of::Only(Target::Fragment)),
    ("TXB", Opcode::Txb, Operands::Texture, Of::Only(Target::Fragment)),
    ("TXP", Opcode::Txp, Operands::Texture, Of::Only(Target::Fragment)),
    ("XPD", Opcode::Xpd, Operands::Vectors(2), Of::Both),
];

/// Whether results are clamped to [0, 1].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Saturation {
    Off,
    On,
}

/// The names of the instructions of a target, without `_SAT`.
pub(crate) fn instructions(target: Target) -> Vec<&'static str> {
    INSTRUCTIONS.iter().filter(|row| row.3.has(target)).map(|row| row.0).collect()
}

/// The instruction of that name; fragment programs have each with `_SAT` too.
pub(crate) fn opcode(name: &str, target: Target) -> Option<(Opcode, Operands, Saturation)> {
    let plain = name.strip_suffix("_SAT").filter(|_| target == Target::Fragment);
    let saturation = if plain.is_some() { Saturation::On } else { Saturation::Off };
    let plain = plain.unwrap_or(name);
    let place = INSTRUCTIONS.binary_search_by_key(&plain, |row| row.0).ok()?;
    let (_, opcode, operands, of) = INSTRUCTIONS[place];
    let exists = of.has(target);
    // Without a result there is nothing to clamp.
    let saturates = saturation == Saturation::Off || operands != Operands::Condition;
    (exists && saturates).then_some((opcode, operands, saturation))
}

/// An input of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Attribute {
    /// A vertex attribute, by location.
    Vertex(u8),
    /// Four varyings, by the first slot.
    Varyings(u16),
    /// `fragment.fogcoord`.
    Fog,
    /// `fragment.position`.
    Position,
}

/// The source of a component of a state parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Word {
    /// A word of a piece of state.
    Of(StateVar, u8),
    /// This number.
    Is(f32),
}

/// A parameter, which is the same for all vertices or fragments of a draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Parameter {
    Constant([f32; 4]),
    /// `program.env[n]`.
    Env(u16),
    /// `program.local[n]`.
    Local(u16),
    /// `state.…`.
    State([Word; 4]),
}

/// A source of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Register {
    Temporary(u16),
    Attribute(Attribute),
    Parameter(Parameter),
    /// Element `address + offset` of an array.
    Relative {
        /// Which array.
        array: u16,
        /// Which address register.
        address: u16,
        offset: i32,
    },
}

/// The source of a component of an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pick {
    Component(u8),
    Zero,
    One,
}

/// An operand: picked components, some of them negated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Source {
    pub register: Register,
    pub picks: [Pick; 4],
    pub negated: [bool; 4],
}

/// An output of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Result {
    Position,
    PointSize,
    Fog,
    /// Four varyings, by the first slot.
    Varyings(u16),
    /// A colour for a draw buffer.
    Color(u8),
    Depth,
}

/// The register that an instruction writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Written {
    Temporary(u16),
    Address(u16),
    Result(Result),
    /// Nothing.
    Nowhere,
}

/// A destination and which of its components are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Destination {
    pub written: Written,
    pub mask: [bool; 4],
}

/// A texture lookup's unit and what is bound to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Lookup {
    pub unit: u8,
    pub shape: Shape,
    /// Whether texels are compared with r.
    pub compare: bool,
}

/// An instruction.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Instruction {
    pub opcode: Opcode,
    pub saturation: Saturation,
    pub destination: Destination,
    pub sources: Vec<Source>,
    pub lookup: Option<Lookup>,
}

/// The fog of a fragment program's option (ARB_fragment_program, section 3.11.4.5.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fog {
    Exp,
    Exp2,
    Linear,
}

/// The `OPTION` statements of a program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Options {
    /// `ARB_position_invariant`.
    pub position_invariant: bool,
    /// Whether the precision that is hinted at is the nicest.
    pub precision: Option<bool>,
    /// `ARB_fog_exp` and its kin.
    pub fog: Option<Fog>,
    /// `ARB_draw_buffers`, or `ATI_draw_buffers`, which says the same.
    pub draw_buffers: bool,
    /// `ARB_fragment_program_shadow`.
    pub shadow: bool,
    /// `ARB_fragment_coord_origin_upper_left`.
    pub origin_upper_left: bool,
    /// `ARB_fragment_coord_pixel_center_integer`.
    pub pixel_center_integer: bool,
}

/// Counts of the resources whose limits `glGetProgramivARB` reports.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    pub instructions: u32,
    pub temporaries: u32,
    pub parameters: u32,
    pub attributes: u32,
    pub addresses: u32,
    pub lookups: u32,
    pub indirections: u32,
}

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    pub target: Target,
    pub options: Options,
    pub instructions: Vec<Instruction>,
    /// The arrays of parameters.
    pub arrays: Vec<Vec<Parameter>>,
    pub counts: Counts,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_instructions_are_sorted() {
        assert!(INSTRUCTIONS.is_sorted_by_key(|row| row.0));
    }
}
