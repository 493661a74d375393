//! The text and the parameters of programs: ARB_vertex_program, section 2.14.1;
//! EXT_gpu_program_parameters.

use crate::assembly::program::Target;
use crate::assembly::{load, too_large};
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, not_negative};
use crate::base::types::*;
use crate::context::Context;
use crate::generate::executable::assembly_executable;
use crate::objects::assemblies::TARGET;
use crate::state::assembly::{SECTION, Scope, checked};
use std::sync::Arc;

const FORMAT: Table<()> = Table { section: SECTION, rows: &[(GL_PROGRAM_FORMAT_ASCII_ARB, ())] };

/// The parameters of a scope, as far as they were set.
pub(crate) fn parameters(context: &Context, target: Target, scope: Scope) -> &[[f32; 4]] {
    let state = &context.state.assembly;
    match scope {
        Scope::Env => &state.env[target as usize],
        Scope::Local => &context.objects.assembly(target, &state.bound[target as usize]).local,
    }
}

fn set(
    context: &mut Context,
    scope: Scope,
    target: GLenum,
    index: GLuint,
    values: &[[f32; 4]],
) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    let first = checked(scope, index, values.len())?;
    let state = &mut context.state.assembly;
    let all = match scope {
        Scope::Env => &mut state.env[target as usize],
        Scope::Local => {
            &mut context.objects.assembly_mut(target, &state.bound[target as usize]).local
        }
    };
    let end = first + values.len();
    if all.len() < end {
        all.resize(end, [0.0; 4]);
    }
    all[first..end].copy_from_slice(values);
    Ok(())
}

/// The four numbers of a parameter.
fn four<T: Copy>(params: &[T]) -> Result<[T; 4]> {
    match params.first_chunk() {
        Some(four) => Ok(*four),
        None => invalid_operation(SECTION, format!("params has {} of 4 numbers", params.len())),
    }
}

fn set_several(
    context: &mut Context,
    scope: Scope,
    target: GLenum,
    index: GLuint,
    count: GLsizei,
    params: &[GLfloat],
) -> Result<()> {
    const SECTION: &str = "EXT_gpu_program_parameters";
    let count = not_negative(SECTION, "count", count.into())?;
    TARGET.decode("target", target)?;
    checked(scope, index, count)?;
    let values: Vec<[f32; 4]> =
        params.chunks_exact(4).take(count).map(|chunk| std::array::from_fn(|i| chunk[i])).collect();
    if values.len() < count {
        let has = params.len();
        return invalid_operation(SECTION, format!("params has {has} numbers, count = {count}"));
    }
    set(context, scope, target, index, &values)
}

macro_rules! setters {
    ($($scope:ident $f:ident $d:ident $fv:ident $dv:ident $several:ident;)*) => { $(
        pub(crate) fn $f(
            context: &mut Context,
            target: GLenum,
            index: GLuint,
            x: GLfloat,
            y: GLfloat,
            z: GLfloat,
            w: GLfloat,
        ) -> Result<()> {
            set(context, Scope::$scope, target, index, &[[x, y, z, w]])
        }

        pub(crate) fn $d(
            context: &mut Context,
            target: GLenum,
            index: GLuint,
            x: GLdouble,
            y: GLdouble,
            z: GLdouble,
            w: GLdouble,
        ) -> Result<()> {
            set(context, Scope::$scope, target, index, &[[x, y, z, w].map(|value| value as f32)])
        }

        pub(crate) fn $fv(
            context: &mut Context,
            target: GLenum,
            index: GLuint,
            params: &[GLfloat],
        ) -> Result<()> {
            set(context, Scope::$scope, target, index, &[four(params)?])
        }

        pub(crate) fn $dv(
            context: &mut Context,
            target: GLenum,
            index: GLuint,
            params: &[GLdouble],
        ) -> Result<()> {
            let values = four(params)?.map(|value| value as f32);
            set(context, Scope::$scope, target, index, &[values])
        }

        pub(crate) fn $several(
            context: &mut Context,
            target: GLenum,
            index: GLuint,
            count: GLsizei,
            params: &[GLfloat],
        ) -> Result<()> {
            set_several(context, Scope::$scope, target, index, count, params)
        }
    )* };
}

setters! {
    Env program_env_parameter_4f program_env_parameter_4d
        program_env_parameter_4fv program_env_parameter_4dv program_env_parameters_4fv;
    Local program_local_parameter_4f program_local_parameter_4d
        program_local_parameter_4fv program_local_parameter_4dv program_local_parameters_4fv;
}

/// A text that does not load leaves the program as it was.
pub(crate) fn program_string(
    context: &mut Context,
    target: GLenum,
    format: GLenum,
    len: GLsizei,
    string: &str,
) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    FORMAT.decode("format", format)?;
    let len = not_negative(SECTION, "len", len.into())?;
    let Some(text) = string.get(..len) else {
        let has = string.len();
        return invalid_operation(SECTION, format!("len = {len}, but the string has {has} bytes"));
    };
    let loaded = load(text, target)
        .and_then(|loaded| assembly_executable(loaded).map_err(|error| too_large(text, &error)));
    match loaded {
        Ok(loaded) => {
            let bound = &context.state.assembly.bound[target as usize];
            let program = context.objects.assembly_mut(target, bound);
            program.text = text.to_owned();
            program.loaded = Some(Arc::new(loaded));
            context.state.assembly.error = None;
            Ok(())
        }
        Err(failure) => {
            let message = failure.in_text(text);
            let position = GLint::try_from(failure.position).unwrap_or(GLint::MAX);
            context.state.assembly.error =
                Some((position, crate::calls::program::assembly_query::kept(&message)));
            invalid_operation(target.section(), format!("the program does not load: {message}"))
        }
    }
}
