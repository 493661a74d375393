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

/// The versions of OpenGL ES that were ever defined.
fn is_es_version(major: Attrib, minor: Attrib) -> bool {
    match major {
        1 => (0..=1).contains(&minor),
        2 => minor == 0,
        3 => (0..=2).contains(&minor),
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

/// Checks that the attributes ask for no more than there is of the thread's API.
fn check(client: Api, attributes: &[(Int, Attrib)]) -> Result<Asked> {
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
    let api = match client {
        Api::OpenGl => {
            check_version(major, minor)?;
            profile_of((major, minor), profile, forward)?
        }
        Api::OpenGlEs => {
            check_es_version(major, minor, attributes)?;
            ClientApi::Es2
        }
    };
    let version = Version::new(major as u8, minor as u8);
    let forward_compatible = if forward { ForwardCompatible::Yes } else { ForwardCompatible::No };
    let output = if debug { DebugOutput::On } else { DebugOutput::Off };
    Ok(Asked { api, version, forward_compatible, output, reset_notification })
}

fn check_version(major: Attrib, minor: Attrib) -> Result<()> {
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
    Ok(())
}

/// Checks that there are contexts of a version of OpenGL ES, and that no attribute is OpenGL's alone.
fn check_es_version(major: Attrib, minor: Attrib, attributes: &[(Int, Attrib)]) -> Result<()> {
    const FORWARD: Attrib = EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE_BIT_KHR as Attrib;
    let of_opengl = attributes.iter().find(|(name, value)| match *name {
        EGL_CONTEXT_OPENGL_PROFILE_MASK | EGL_CONTEXT_OPENGL_FORWARD_COMPATIBLE => true,
        EGL_CONTEXT_FLAGS_KHR => value & FORWARD != 0,
        _ => false,
    });
    if let Some((name, _)) = of_opengl {
        let name = name_of(*name);
        let rule = format!("attrib_list: {name} is for OpenGL: call eglBindAPI(EGL_OPENGL_API)");
        return fail(Code::BadAttribute, rule);
    }
    if !is_es_version(major, minor) {
        return fail(Code::BadMatch, format!("there is no OpenGL ES {major}.{minor}"));
    }
    let most = limits::es_version();
    if major < 2 || (major, minor) > (most.major.into(), most.minor.into()) {
        return fail(
            Code::BadMatch,
            format!(
                "OpenGL ES {major}.{minor} was asked for; DetGL has 2.0 and {most}: set \
                 EGL_CONTEXT_MAJOR_VERSION to 2 or 3 (without it, it is 1)"
            ),
        );
    }
    Ok(())
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

/// What a new context needs to share the objects of another of the same API, wherever that is current.
pub(crate) fn shared_by(
    display: Id,
    client: Api,
    share: Handle,
    reset_notification: ResetNotification,
) -> Result<ShareHandle> {
    let mut registry = registry();
    let (_, entry) = registry.context(display, share)?;
    if entry.client != client {
        return fail(
            Code::BadContext,
            "share_context is of another API: contexts of OpenGL share with such, those of OpenGL ES too",
        );
    }
    if entry.reset_notification != reset_notification {
        return fail(
            Code::BadMatch,
            "share_context has another EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY: contexts that share have the \
             same (EGL 1.5, section 3.7.1)",
        );
    }
    Ok(entry.share.clone())
}

pub(super) fn create(
    dpy: Handle,
    config: Handle,
    share: Handle,
    attributes: &[(Int, Attrib)],
) -> Result<Handle> {
    let display = registry().display(dpy)?;
    let config = if config.is_null() { None } else { Some(Config::find(config)?) };
    let client = thread(|thread| thread.api.get());
    let Asked { api, version, forward_compatible, output, reset_notification } =
        check(client, attributes)?;
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
    let shared = match share.is_null() {
        true => None,
        false => Some(shared_by(display, client, share, reset_notification)?),
    };
    let context = match host::new_context(desc, shared, output) {
        Ok(context) => context,
        Err(error) => return fail(Code::BadAlloc, error.to_string()),
    };
    let mut registry = registry();
    let id = registry.new_id();
    registry.contexts.insert(id, ContextEntry::new(display, client, config, context));
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
        EGL_CONTEXT_CLIENT_TYPE => entry.client.encode(),
        EGL_CONTEXT_CLIENT_VERSION => match entry.client {
            Api::OpenGl => limits::version().major.into(),
            Api::OpenGlEs => limits::es_version().major.into(),
        },
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
    let api = match api as Int {
        EGL_OPENGL_API => Api::OpenGl,
        EGL_OPENGL_ES_API => Api::OpenGlEs,
        name => {
            let name = name_of(name);
            let rule = format!("api = {name} must be EGL_OPENGL_API or EGL_OPENGL_ES_API");
            return fail(Code::BadParameter, rule);
        }
    };
    thread(|thread| thread.api.set(api));
    Ok(1)
}

pub(super) fn query_api() -> Result<u32> {
    Ok(thread(|thread| thread.api.get()).encode() as u32)
}
