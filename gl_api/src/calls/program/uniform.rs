//! `glUniform` and `glGetUniform`: GL 2.1, section 2.15.3.

use crate::base::constants::enum_name;
use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::calls::program::data_type::gl_type;
use crate::calls::program::programs::program;
use crate::context::Context;
use crate::glsl::{DataType, Scalar, Uniform};
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::programs::ShaderOrProgram;
use rasterizer::ir::TRUE;

const SECTION: &str = "GL 2.1, section 2.15.3";

/// Values as a call brings them: words, and what they are. A word is read once it is known to be stored: a C
/// program may say that there are more than there are, where nothing is (of location -1, say).
#[derive(Clone, Copy)]
struct Values<'a> {
    scalar: Scalar,
    /// Numbers of an element: 1 to 4 of a vector.
    size: u8,
    /// How many words there are.
    len: usize,
    word: &'a dyn Fn(usize) -> u32,
}

/// The program whose uniforms a call sets.
#[derive(Clone, Copy)]
enum Receiver {
    /// The one in use, or else the active one of the bound pipeline.
    Active,
    /// That of a name.
    Named(GLuint),
}

impl Receiver {
    /// Its name.
    fn name(self, context: &mut Context) -> Result<GLuint> {
        match self {
            Self::Active => Ok(match context.state.bindings.program.name() {
                0 => context.objects.pipelines.current().map_or(0, |bound| bound.active.name()),
                name => name,
            }),
            Self::Named(name) => {
                if program(context, name)?.linked().is_none() {
                    let rule = format!("program = {name} is not linked: see glGetProgramInfoLog");
                    return invalid_operation(SECTION, rule);
                }
                Ok(name)
            }
        }
    }
}

/// Words of an element of a type.
pub(crate) fn element_words(ty: DataType) -> usize {
    ty.words() as usize
}

/// The uniform at a location, and which element of it.
pub(crate) fn at_location(uniforms: &[Uniform], location: GLint) -> Option<(&Uniform, usize)> {
    let location = u32::try_from(location).ok()?;
    uniforms.iter().find_map(|uniform| {
        let element = location.checked_sub(uniform.location)?;
        (element < uniform.array.unwrap_or(1)).then_some((uniform, element as usize))
    })
}

/// Writes `count` elements from a location on. `check` sees the uniform and how many elements it takes; `word`
/// makes a word of the uniform from one of the call.
fn store(
    (context, receiver): (&mut Context, Receiver),
    location: GLint,
    count: GLsizei,
    given: usize,
    check: impl FnOnce(&Uniform, usize) -> Result<()>,
    word: impl Fn(&Uniform, usize) -> u32,
) -> Result<()> {
    let count = not_negative(SECTION, "count", count.into())?;
    let name = receiver.name(context)?;
    let program = match context.objects.shared.programs.get_mut(name) {
        Some(ShaderOrProgram::Program(program)) => program.executable.as_mut(),
        Some(ShaderOrProgram::Shader(_)) | None => None,
    };
    let Some(linked) = program else {
        return invalid_operation(SECTION, "no linked program is in use: call glUseProgram");
    };
    if location == -1 {
        return Ok(());
    }
    let Some((uniform, element)) = at_location(&linked.program.uniforms, location) else {
        // One of a uniform that is not active (ARB_explicit_uniform_location).
        if linked.program.is_explicit_location(location) {
            return Ok(());
        }
        return invalid_operation(
            SECTION,
            format!("location = {location} is no uniform's of program {name}"),
        );
    };
    if count > 1 && uniform.array.is_none() {
        return invalid_operation(
            SECTION,
            format!("count = {count}, but \"{}\" is no array", uniform.name),
        );
    }
    // What lies past an array's end is ignored.
    let taken = count.min(uniform.array.unwrap_or(1) as usize - element);
    check(uniform, taken)?;
    let each = element_words(uniform.ty);
    let needed = taken * each;
    if given < needed {
        return invalid_operation(
            SECTION,
            format!(
                "{taken} of count = {count} elements take {needed} numbers, the memory has {given}"
            ),
        );
    }
    let first = uniform.word as usize + element * each;
    linked.set |= 1 << (uniform.location % 64);
    let words = linked.words.get_mut(first..first + taken * each).unwrap_or_default();
    let mut differs = 0;
    for (index, stored) in words.iter_mut().enumerate() {
        let word = word(uniform, index);
        differs |= *stored ^ word;
        *stored = word;
    }
    match differs {
        0 => context.state_changes.no_change(),
        _ => context.state_changes.values_only(),
    }
    Ok(())
}

fn set(
    to: (&mut Context, Receiver),
    location: GLint,
    count: GLsizei,
    values: Values<'_>,
) -> Result<()> {
    let Values { scalar, size, len, word } = values;
    let check = |uniform: &Uniform, taken: usize| match uniform.ty {
        DataType::Vector(Scalar::Bool, expected) if expected == size => Ok(()),
        DataType::Vector(expected, length) if expected == scalar && length == size => Ok(()),
        DataType::Sampler(_) if scalar == Scalar::Int && size == 1 => {
            let units = 0..u32::from(MAX_COMBINED_TEXTURE_IMAGE_UNITS);
            match (0..taken.min(len)).map(word).find(|unit| !units.contains(unit)) {
                Some(unit) => invalid_value(
                    SECTION,
                    format!(
                        "\"{}\" is a sampler: its value {} must be a texture unit, 0 to {}",
                        uniform.name,
                        unit as i32,
                        MAX_COMBINED_TEXTURE_IMAGE_UNITS - 1
                    ),
                ),
                None => Ok(()),
            }
        }
        DataType::Vector(..) | DataType::Matrix(..) | DataType::Sampler(_) => {
            mismatch(uniform, gl_type(DataType::Vector(scalar, size)))
        }
    };
    let convert = |uniform: &Uniform, index: usize| {
        let word = word(index);
        match uniform.ty {
            DataType::Vector(Scalar::Bool, _) => {
                let zero = match scalar {
                    Scalar::Float => f32::from_bits(word) == 0.0,
                    Scalar::Int | Scalar::Uint | Scalar::Bool => word == 0,
                };
                if zero { 0 } else { TRUE }
            }
            DataType::Vector(..) | DataType::Matrix(..) | DataType::Sampler(_) => word,
        }
    };
    store(to, location, count, len, check, convert)
}

fn mismatch(uniform: &Uniform, given: GLenum) -> Result<()> {
    let (is, given) = (enum_name(gl_type(uniform.ty)), enum_name(given));
    invalid_operation(SECTION, format!("\"{}\" is a {is}, the call brings {given}", uniform.name))
}

fn set_matrix(
    to: (&mut Context, Receiver),
    location: GLint,
    count: GLsizei,
    transpose: bool,
    [columns, rows]: [u8; 2],
    value: &[GLfloat],
) -> Result<()> {
    let ty = DataType::Matrix(columns, rows);
    let check = |uniform: &Uniform, _: usize| {
        if uniform.ty == ty { Ok(()) } else { mismatch(uniform, gl_type(ty)) }
    };
    let (columns, rows) = (usize::from(columns), usize::from(rows));
    let word = |_: &Uniform, index: usize| {
        let (element, at) = (index / (columns * rows), index % (columns * rows));
        let source = if transpose { at % rows * columns + at / rows } else { at };
        value[element * columns * rows + source].to_bits()
    };
    store(to, location, count, value.len(), check, word)
}

/// `glUniform{size}{letter}` and its vector form, and those of `glProgramUniform`.
macro_rules! uniforms {
    ($($scalar:ident $ty:ty as $to_word:path {
        $($name:ident $vector:ident $of_program:ident $vector_of_program:ident $size:literal ($($x:ident),*);)*
    })*) => {
        $($(
            pub(crate) fn $name(context: &mut Context, location: GLint $(, $x: $ty)*) -> Result<()> {
                $vector(context, location, 1, &[$($x),*])
            }

            pub(crate) fn $vector(
                context: &mut Context,
                location: GLint,
                count: GLsizei,
                value: &[$ty],
            ) -> Result<()> {
                let word = |index: usize| $to_word(value[index]);
                let (scalar, len) = (Scalar::$scalar, value.len());
                let values = Values { scalar, size: $size, len, word: &word };
                set((context, Receiver::Active), location, count, values)
            }

            pub(crate) fn $of_program(
                context: &mut Context,
                program: GLuint,
                location: GLint
                $(, $x: $ty)*
            ) -> Result<()> {
                $vector_of_program(context, program, location, 1, &[$($x),*])
            }

            pub(crate) fn $vector_of_program(
                context: &mut Context,
                program: GLuint,
                location: GLint,
                count: GLsizei,
                value: &[$ty],
            ) -> Result<()> {
                let word = |index: usize| $to_word(value[index]);
                let (scalar, len) = (Scalar::$scalar, value.len());
                let values = Values { scalar, size: $size, len, word: &word };
                set((context, Receiver::Named(program)), location, count, values)
            }
        )*)*
    };
}

uniforms! {
    Float GLfloat as f32::to_bits {
    uniform_1f uniform_1fv program_uniform_1f program_uniform_1fv 1 (x);
    uniform_2f uniform_2fv program_uniform_2f program_uniform_2fv 2 (x, y);
    uniform_3f uniform_3fv program_uniform_3f program_uniform_3fv 3 (x, y, z);
    uniform_4f uniform_4fv program_uniform_4f program_uniform_4fv 4 (x, y, z, w);
    }
    Int GLint as i32::cast_unsigned {
    uniform_1i uniform_1iv program_uniform_1i program_uniform_1iv 1 (x);
    uniform_2i uniform_2iv program_uniform_2i program_uniform_2iv 2 (x, y);
    uniform_3i uniform_3iv program_uniform_3i program_uniform_3iv 3 (x, y, z);
    uniform_4i uniform_4iv program_uniform_4i program_uniform_4iv 4 (x, y, z, w);
    }
    Uint GLuint as u32::from {
    uniform_1ui uniform_1uiv program_uniform_1ui program_uniform_1uiv 1 (x);
    uniform_2ui uniform_2uiv program_uniform_2ui program_uniform_2uiv 2 (x, y);
    uniform_3ui uniform_3uiv program_uniform_3ui program_uniform_3uiv 3 (x, y, z);
    uniform_4ui uniform_4uiv program_uniform_4ui program_uniform_4uiv 4 (x, y, z, w);
    }
}

/// `glUniformMatrix{columns}x{rows}fv`, and those of `glProgramUniform`.
macro_rules! matrices {
    ($($name:ident $of_program:ident $columns:literal $rows:literal;)*) => {
        $(pub(crate) fn $name(
            context: &mut Context,
            location: GLint,
            count: GLsizei,
            transpose: bool,
            value: &[GLfloat],
        ) -> Result<()> {
            let to = (context, Receiver::Active);
            set_matrix(to, location, count, transpose, [$columns, $rows], value)
        }

        pub(crate) fn $of_program(
            context: &mut Context,
            program: GLuint,
            location: GLint,
            count: GLsizei,
            transpose: bool,
            value: &[GLfloat],
        ) -> Result<()> {
            let to = (context, Receiver::Named(program));
            set_matrix(to, location, count, transpose, [$columns, $rows], value)
        })*
    };
}

matrices! {
    uniform_matrix_2fv program_uniform_matrix_2fv 2 2;
    uniform_matrix_3fv program_uniform_matrix_3fv 3 3;
    uniform_matrix_4fv program_uniform_matrix_4fv 4 4;
    uniform_matrix_2x3fv program_uniform_matrix_2x3fv 2 3;
    uniform_matrix_3x2fv program_uniform_matrix_3x2fv 3 2;
    uniform_matrix_2x4fv program_uniform_matrix_2x4fv 2 4;
    uniform_matrix_4x2fv program_uniform_matrix_4x2fv 4 2;
    uniform_matrix_3x4fv program_uniform_matrix_3x4fv 3 4;
    uniform_matrix_4x3fv program_uniform_matrix_4x3fv 4 3;
}
