//! Contexts and what their attributes ask for (EGL 1.5, section 3.7.1; `EGL_KHR_create_context`).

use super::config::Config;
use super::constants::*;
use super::error::{Code, Result, fail, name_of};
use super::raw::{Attrib, Handle, Id, Int, handle, put};
use super::registry::{ContextEntry, Holder, Registry, registry};
use super::thread::{Api, thread};
use gl_api::host::{self, DebugOutput, ShareHandle, limits};
use gl_api::{Api as ClientApi, ContextDesc, ForwardCompatible, ResetNotification, Version};

impl Registry {
    /// Removes a context, now or when it is current no more.
    pub fn doom_context(&mut self, id: Id) {
        if let Some(entry) = self.contexts.get_mut(&id) {
            entry.doomed = true;
            if matches!(entry.holder, Holder::Registry(_)) {
                self.contexts.remove(&id);
            }
        }
    }
}

/// The versions of OpenGL that were ever defined.
fn is_version(major: Attrib, minor: Attrib) -> bool {
    match major {
        1 => (0..=5).contains(&minor),
        2 => (0..=1).contains(&minor),
        3 => (0..=3).contains(&minor),
        4 => (0..=6).contains(&minor),
        _ => false,
    }
}

/// What the attributes ask for.
struct Asked {
    api: ClientApi,
    version: Version,
    forward_compatible: ForwardCompatible,
    /// The log of messages is on at first in debug contexts (`KHR_debug`, section 5.5).
    output: DebugOutput,
    reset_notification: ResetNotification,
}

/// Checks that the attributes ask for no more than there is.
fn check(attributes: &[(Int, Attrib)]) -> Result<Asked> {
    let mut reset_notification = ResetNotification::Never;
    let (mut major, mut minor, mut flags) = (1, 0, 0);
    let (mut forward, mut debug, mut robust, mut no_error) = (false, false, false, false);
    let mut profile = EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT as Attrib;
    for &(name, value) in attributes {
        match name {
            EGL_CONTEXT_MAJOR_VERSION => major = value,
            EGL_CONTEXT_MINOR_VERSION => minor = value,
            EGL_CONTEXT_OPENGL_PROFILE_MASK => profile = value,
            EGL_CONTEXT_FLAGS_KHR => flags = value,
            EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE => forward = value != 0,
            EGL_CONTEXT_OPENGL_DEBUG => debug = value != 0,
            // Accesses and errors are always checked.
            EGL_CONTEXT_OPENGL_ROBUST_ACCESS | EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT => {
                robust = value != 0;
            }
            EGL_CONTEXT_OPENGL_NO_ERROR_KHR => no_error = value != 0,
            EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY
            | EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT => match value as Int {
                EGL_NO_RESET_NOTIFICATION => reset_notification = ResetNotification::Never,
                EGL_LOSE_CONTEXT_ON_RESET => {
                    reset_notification = ResetNotification::LoseContextOnReset;
                }
                value => {
                    return fail(
                        Code::BadAttribute,
                        format!(
                            "EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY = {value:#x} must be \
                             EGL_NO_RESET_NOTIFICATION or EGL_LOSE_CONTEXT_ON_RESET"
                        ),
                    );
                }
            },
            _ => {
                return fail(
                    Code::BadAttribute,
                    format!("attrib_list: no attribute {}", name_of(name)),
                );
            }
        }
    }
    let known = EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR
        | EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR
        | EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR;
    if flags & !(known as Attrib) != 0 {
        return fail(
            Code::BadAttribute,
            format!("EGL_CONTEXT_FLAGS_KHR = {flags:#x}: no such bit"),
        );
    }
    debug |= flags & EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR as Attrib != 0;
    robust |= flags & EGL_CONTEXT_OPENGL_ROBUST_ACCESS_BIT_KHR as Attrib != 0;
    forward |= flags & EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR as Attrib != 0;
    if no_error && (debug || robust) {
        return fail(
            Code::BadMatch,
            "EGL_CONTEXT_OPENGL_NO_ERROR_KHR cannot go with a debug or robust context: leave one out",
        );
    }
    if !is_version(major, minor) {
        return fail(Code::BadMatch, format!("there is no OpenGL {major}.{minor}"));
    }
    let most = limits::version();
    if (major, minor) > (most.major.into(), most.minor.into()) {
        return fail(
            Code::BadMatch,
            format!(
                "OpenGL {major}.{minor} was asked for; DetGL has {most} (DETGL_GL_VERSION={major}.{minor} lets \
                 programs start that use nothing later)"
            ),
        );
    }
    let api = profile_of((major, minor), profile, forward)?;
    let version = Version::new(major as u8, minor as u8);
    let forward_compatible = if forward { ForwardCompatible::Yes } else { ForwardCompatible::No };
    let output = if debug { DebugOutput::On } else { DebugOutput::Off };
    Ok(Asked { api, version, forward_compatible, output, reset_notification })
}

/// The profile that is asked for. Before 3.2 there are none (EGL 1.5, section 3.7.1): a context of 3.0 or 3.1 has all
/// that any version had, unless it is forward-compatible, which is without what the core profile removed.
fn profile_of(version: (Attrib, Attrib), profile: Attrib, forward: bool) -> Result<ClientApi> {
    const CORE: Attrib = EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT as Attrib;
    const COMPATIBILITY: Attrib = EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT as Attrib;
    let (major, minor) = version;
    if forward && version < (3, 0) {
        return fail(
            Code::BadMatch,
            format!(
                "a forward-compatible context of OpenGL {major}.{minor}: only 3.0 and later can be so"
            ),
        );
    }
    match profile {
        _ if version < (3, 2) => {
            Ok(if forward { ClientApi::Core } else { ClientApi::Compatibility })
        }
        CORE => Ok(ClientApi::Core),
        COMPATIBILITY => Ok(ClientApi::Compatibility),
        _ => fail(
            Code::BadMatch,
            format!(
                "EGL_CONTEXT_OPENGL_PROFILE_MASK = {profile:#x} must be \
                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT or EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT"
            ),
        ),
    }
}

/// What a new context needs to share the objects of another, wherever that is current.
pub(crate) fn shared_by(display: Id, share: Handle) -> Result<ShareHandle> {
    registry().context(display, share).map(|(_, entry)| entry.share.clone())
}

pub(super) fn create(
    dpy: Handle,
    config: Handle,
    share: Handle,
    attributes: &[(Int, Attrib)],
) -> Result<Handle> {
    let display = registry().display(dpy)?;
    let config = if config.is_null() { None } else { Some(Config::find(config)?) };
    if thread(|thread| thread.api.get()) == Api::None {
        return fail(
            Code::BadMatch,
            "there is no OpenGL ES: call eglBindAPI(EGL_OPENGL_API) before",
        );
    }
    let Asked { api, version, forward_compatible, output, reset_notification } = check(attributes)?;
    // The surface comes with eglMakeCurrent.
    let desc = ContextDesc {
        api,
        version,
        forward_compatible,
        width: 1,
        height: 1,
        reset_notification,
        ..ContextDesc::default()
    };
    let shared = if share.is_null() { None } else { Some(shared_by(display, share)?) };
    let context = match host::new_context(desc, shared, output) {
        Ok(context) => context,
        Err(error) => return fail(Code::BadAlloc, error.to_string()),
    };
    let mut registry = registry();
    let id = registry.new_id();
    registry.contexts.insert(id, ContextEntry::new(display, config, context));
    Ok(handle(id))
}

pub(super) fn destroy(dpy: Handle, context: Handle) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let (id, _) = registry.context(display, context)?;
    registry.doom_context(id);
    Ok(1)
}

pub(super) unsafe fn query(
    dpy: Handle,
    context: Handle,
    attribute: Int,
    value: *mut Int,
) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let (id, entry) = registry.context(display, context)?;
    let binding = thread(|thread| thread.binding.get());
    let bound = binding.filter(|binding| binding.context == id);
    let found = match attribute {
        EGL_CONFIG_ID => entry.config.map_or(0, |config| config.id),
        EGL_CONTEXT_CLIENT_TYPE => EGL_OPENGL_API,
        EGL_CONTEXT_CLIENT_VERSION => limits::version().major.into(),
        EGL_RENDER_BUFFER if bound.is_some_and(|bound| bound.surface.is_some()) => EGL_BACK_BUFFER,
        EGL_RENDER_BUFFER => EGL_NONE,
        _ => {
            let rule = format!("attribute = {} is none of contexts", name_of(attribute));
            return fail(Code::BadAttribute, rule);
        }
    };
    if value.is_null() {
        return fail(Code::BadParameter, "value must not be NULL");
    }
    // SAFETY: not null, and the client's.
    unsafe { put(value, found) };
    Ok(1)
}

pub(super) fn bind_api(api: u32) -> Result<u32> {
    if api as Int != EGL_OPENGL_API {
        return fail(Code::BadParameter, format!("api = {} must be EGL_OPENGL_API", name_of(api)));
    }
    thread(|thread| thread.api.set(Api::OpenGl));
    Ok(1)
}

pub(super) fn query_api() -> Result<u32> {
    Ok(match thread(|thread| thread.api.get()) {
        Api::None => EGL_NONE as u32,
        Api::OpenGl => EGL_OPENGL_API as u32,
    })
}
