//! The numbers of calls such as `glLightfv`, in whatever type they come: as they are, as colour
//! components (GL 2.1, table 2.9), or as named constants.

/// The four forms of a call that sets parameters: `f`, `i`, `fv`, `iv`.
macro_rules! parameter_calls {
    ($set:ident($($lead:ident),+): $f:ident, $i:ident, $fv:ident, $iv:ident) => {
        pub(crate) fn $f(context: &mut Context, $($lead: GLenum,)+ param: GLfloat) -> Result<()> {
            $set(context, $($lead,)+ &Params::scalar(param))
        }
        pub(crate) fn $i(context: &mut Context, $($lead: GLenum,)+ param: GLint) -> Result<()> {
            $set(context, $($lead,)+ &Params::scalar(param))
        }
        pub(crate) fn $fv(
            context: &mut Context,
            $($lead: GLenum,)+
            params: &[GLfloat],
        ) -> Result<()> {
            $set(context, $($lead,)+ &Params::vector(params))
        }
        pub(crate) fn $iv(
            context: &mut Context,
            $($lead: GLenum,)+
            params: &[GLint],
        ) -> Result<()> {
            $set(context, $($lead,)+ &Params::vector(params))
        }
    };
}

/// The two forms of a call that reads parameters: `fv`, `iv`.
macro_rules! parameter_queries {
    ($get:ident($($lead:ident),+): $fv:ident, $iv:ident) => {
        pub(crate) fn $fv(
            context: &mut Context,
            $($lead: GLenum,)+
            params: &mut [GLfloat],
        ) -> Result<()> {
            $crate::base::query_value::put_floats(params, $get(context, $($lead),+)?)
        }
        pub(crate) fn $iv(
            context: &mut Context,
            $($lead: GLenum,)+
            params: &mut [GLint],
        ) -> Result<()> {
            $crate::base::query_value::put_ints(params, $get(context, $($lead),+)?)
        }
    };
}

pub(crate) use {parameter_calls, parameter_queries};
