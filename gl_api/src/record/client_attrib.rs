//! The attribute stack of the client's state: `glPushClientAttrib`, GL 2.1, section 6.1.17.

use crate::base::constants::*;
use crate::base::error::{ErrorCode, Result};
use crate::base::types::*;
use crate::context::Context;
use crate::state::attrib::{MAX_ATTRIB_STACK_DEPTH, stack_error};
use crate::state::client_attrib::{ClientArrays, ClientAttribs, ClientPixels};
use crate::state::enable::Flag;

pub(crate) fn push_client_attrib(context: &mut Context, mask: GLbitfield) -> Result<()> {
    if context.attribs.client.len() >= MAX_ATTRIB_STACK_DEPTH {
        return stack_error(
            ErrorCode::StackOverflow,
            format!("the stack has {MAX_ATTRIB_STACK_DEPTH} groups: glPopClientAttrib is missing"),
        );
    }
    let state = &context.state;
    let bindings = &state.bindings;
    let pixels = || ClientPixels {
        pack: state.pack.clone(),
        unpack: state.unpack.clone(),
        pack_buffer: bindings.pixel_pack_buffer.clone(),
        unpack_buffer: bindings.pixel_unpack_buffer.clone(),
    };
    let arrays = || ClientArrays {
        arrays: state.arrays.clone(),
        array_buffer: bindings.array_buffer.clone(),
        element_array_buffer: bindings.element_array_buffer.clone(),
        vertex_array: bindings.vertex_array,
        restart: (state.enables.has(Flag::PrimitiveRestart), state.restart_index),
        client_active: state.units.client_active,
    };
    let saved = ClientAttribs {
        pixels: (mask & GL_CLIENT_PIXEL_STORE_BIT != 0).then(pixels),
        arrays: (mask & GL_CLIENT_VERTEX_ARRAY_BIT != 0).then(|| Box::new(arrays())),
    };
    context.attribs.client.push(saved);
    Ok(())
}

pub(crate) fn pop_client_attrib(context: &mut Context) -> Result<()> {
    let Some(saved) = context.attribs.client.pop() else {
        return stack_error(
            ErrorCode::StackUnderflow,
            "the stack is empty: glPushClientAttrib is missing".into(),
        );
    };
    if let Some(saved) = saved.arrays {
        // A vertex array object that was deleted meanwhile stays deleted (ARB_vertex_array_object,
        // section 2.10), and its arrays are no other object's.
        let name = saved.vertex_array;
        if name == 0 || context.objects.vertex_arrays.get(name).is_some() {
            crate::calls::vertex::array_objects::bind_vertex_array(context, name)?;
            context.state.arrays = saved.arrays;
            context.state.bindings.element_array_buffer.restore(saved.element_array_buffer);
        }
        context.state.bindings.array_buffer.restore(saved.array_buffer);
        let (restarts, index) = saved.restart;
        context.state.enables.set(Flag::PrimitiveRestart, restarts);
        context.state.restart_index = index;
        context.state.units.client_active = saved.client_active;
    }
    if let Some(saved) = saved.pixels {
        context.state.pack = saved.pack;
        context.state.unpack = saved.unpack;
        let bindings = &mut context.state.bindings;
        bindings.pixel_pack_buffer.restore(saved.pack_buffer);
        bindings.pixel_unpack_buffer.restore(saved.unpack_buffer);
    }
    Ok(())
}
