//! Transform feedback (GL 3.0 section 2.15): the varyings to capture become outputs of the last
//! stage before the fragments.

use super::stage::{BindingMap, StageUnits};
use crate::builtins::variable::Builtin;
use crate::hir::{Storage, Variable};
use crate::language::stage_name;
use crate::limits::{
    MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS, MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS,
};
use crate::lower::{Binding, varying_slots};
use crate::program::{BufferMode, Capture, CaptureRequest, Captured, CapturedItem, CapturedScalar};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::spelling::closest;
use crate::types::Type;
use rasterizer::ir::{Output, Stage, Ty};

const RULE: &str = "GL 3.0 section 2.15";

/// Finds the varyings to capture; those that the fragment stage does not read get slots from `next`
/// on.
pub fn captured(
    vertex: Option<&StageUnits<'_>>,
    request: &Capture,
    mut next: u16,
    in_vertex: &mut BindingMap,
    log: &mut Log,
) -> Vec<Captured> {
    let mut all: Vec<Captured> = Vec::new();
    for wanted in &request.varyings {
        let found = match wanted {
            CaptureRequest::Varying { variable, element } => {
                let captured = find(vertex, (variable, *element), &mut next, in_vertex);
                captured.map(|captured| Captured { name: wanted.to_string(), ..captured })
            }
            CaptureRequest::Gap(components) => {
                Ok(without_output(wanted, CapturedItem::Gap, *components))
            }
            CaptureRequest::NextBuffer => Ok(without_output(wanted, CapturedItem::NextBuffer, 0)),
        };
        let is_varying = matches!(wanted, CaptureRequest::Varying { .. });
        let twice = is_varying && all.iter().any(|other| other.name == wanted.to_string());
        match found {
            Ok(_) if twice => {
                let message = format!("transform feedback captures `{wanted}` twice");
                log.push(Diagnostic::link_error(message).rule(RULE));
            }
            Ok(captured) => all.push(captured),
            Err(why) => {
                let message = format!("transform feedback cannot capture `{wanted}`: {why}");
                log.push(Diagnostic::link_error(message).rule(RULE));
            }
        }
    }
    let (counts, limit): (Vec<usize>, usize) = match request.mode {
        BufferMode::Interleaved => (
            vec![all.iter().map(|captured| captured.scalars.len()).sum()],
            MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS,
        ),
        BufferMode::Separate => (
            all.iter().map(|captured| captured.scalars.len()).collect(),
            MAX_TRANSFORM_FEEDBACK_SEPARATE_COMPONENTS,
        ),
    };
    if let Some(count) = counts.into_iter().find(|count| *count > limit) {
        let message =
            format!("transform feedback captures {count} components for a buffer, at most {limit}");
        log.push(Diagnostic::link_error(message).rule(RULE));
    }
    all
}

/// A name that stands for no output, but for so many components that are left as they are.
fn without_output(wanted: &CaptureRequest, item: CapturedItem, components: u8) -> Captured {
    let scalars = vec![CapturedScalar::Gap; components.into()];
    Captured { name: wanted.to_string(), item, size: components.into(), scalars }
}

/// The variable, or element of an array, that a name stands for.
fn find(
    vertex: Option<&StageUnits<'_>>,
    (wanted, element): (&str, Option<u32>),
    next: &mut u16,
    in_vertex: &mut BindingMap,
) -> Result<Captured, String> {
    let Some(vertex) = vertex else { return Err("there is no vertex shader".to_owned()) };
    // Of an array of blocks, `block[i].member` is named (GL 3.2 section 2.11.4).
    let (name, instance) = match of_instance(wanted) {
        Some((name, instance)) => (name, Some(instance)),
        None => (wanted.to_owned(), None),
    };
    let named = |variable: &&Variable| {
        let is_array = variable.member_of.as_ref().is_some_and(|block| block.dimensions == 1);
        *variable.public_name() == *name && (instance.is_none() || is_array)
    };
    let is_output = |variable: &&Variable| matches!(variable.storage, Storage::Output(_));
    let declared = vertex.declared().filter(is_output).find(named);
    let Some(variable) = declared.or_else(|| vertex.used.iter().copied().find(named)) else {
        let names = vertex.declared().filter(is_output).map(Variable::public_name);
        let near = closest(wanted, names);
        let near = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
        let stage = stage_name(vertex.stage);
        return Err(format!("the {stage} shader has no such output{near}"));
    };
    if instance.is_none() && variable.member_of.as_ref().is_some_and(|block| block.dimensions > 0) {
        return Err("it is in an array of blocks: write which, as `block[0].member`".to_owned());
    }
    let native = match variable.storage {
        Storage::Output(_) => None,
        Storage::Builtin(Builtin::Varying(first)) => Some(first),
        Storage::Builtin(
            Builtin::Position
            | Builtin::PointSize
            | Builtin::ClipVertex
            | Builtin::ClipDistance
            | Builtin::CullDistance
            | Builtin::Layer
            | Builtin::ViewportIndex,
        ) => None,
        Storage::Builtin(Builtin::PrimitiveId) if vertex.stage == Stage::Geometry => None,
        Storage::Builtin(
            Builtin::InstanceId
            | Builtin::VertexId
            | Builtin::Attribute(_)
            | Builtin::FragCoord
            | Builtin::FrontFacing
            | Builtin::PointCoord
            | Builtin::PrimitiveId
            | Builtin::PrimitiveIdIn
            | Builtin::Incoming(_)
            | Builtin::FragColor
            | Builtin::FragData
            | Builtin::SecondaryFragColor
            | Builtin::SecondaryFragData
            | Builtin::FragDepth
            | Builtin::FragStencilRef
            | Builtin::SampleId
            | Builtin::SamplePosition
            | Builtin::SampleMask
            | Builtin::SampleCount
            | Builtin::State(_)
            | Builtin::States(_)
            | Builtin::Limit(_),
        )
        | Storage::Plain
        | Storage::Const
        | Storage::Parameter(_)
        | Storage::Uniform
        | Storage::Attribute
        | Storage::Input(_)
        | Storage::FragmentOutput => {
            return Err(format!("it is no output of the {} shader", stage_name(vertex.stage)));
        }
    };
    let types = variable.ty.flat();
    let first = native.unwrap_or_else(|| match in_vertex.get(&variable.name) {
        Some(Binding::Varying(Some(first))) => *first,
        Some(
            Binding::Varying(None)
            | Binding::Attribute(_)
            | Binding::Uniform(_)
            | Binding::Target(_)
            | Binding::SecondColor,
        )
        | None => {
            let first = *next;
            *next = next.saturating_add(varying_slots(&types));
            in_vertex.insert(variable.name.clone(), Binding::Varying(Some(first)));
            first
        }
    });
    let mut scalars = scalars(&types, first);
    let mut captured = &variable.ty;
    for index in instance.into_iter().chain(element) {
        let Type::Array(element, size) = captured else {
            return Err("it is no array".to_owned());
        };
        let size = size.unwrap_or(0);
        if index >= size {
            return Err(format!("the array has {size} elements"));
        }
        let each = element.scalars() as usize;
        scalars = scalars.split_off(index as usize * each);
        scalars.truncate(each);
        captured = element;
    }
    let (element_ty, size) = match captured {
        Type::Array(element, size) => (&**element, size.unwrap_or(0)),
        ty => (ty, 1),
    };
    let Some(ty) = element_ty.data_type() else { return Err(format!("it is of {element_ty}")) };
    let name = wanted.to_owned();
    Ok(Captured { name, item: CapturedItem::Varying(ty), size, scalars })
}

/// `block[i].member` as `block.member` and `i`.
fn of_instance(name: &str) -> Option<(String, u32)> {
    let (block, rest) = name.split_once('[')?;
    let (index, member) = rest.split_once("].")?;
    let is_number = index.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| Some((format!("{block}.{member}"), index.parse().ok()?))).flatten()
}

/// The outputs of scalars of these types, from a slot on.
fn scalars(types: &[Ty], first: u16) -> Vec<CapturedScalar> {
    let mut next = first;
    let mut take = || {
        next += 1;
        Output::Varying(next - 1)
    };
    let scalar = |ty: &Ty| match ty {
        Ty::F32 => CapturedScalar::Float(take()),
        Ty::I32 | Ty::U32 | Ty::Bool => CapturedScalar::Word { low: take(), high: take() },
    };
    types.iter().map(scalar).collect()
}
