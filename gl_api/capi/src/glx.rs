//! The functions of GLX, for programs that are linked with libGL or load it by name, and draw without windows. DetGL has
//! no GLX: each function answers what its specification says of a display without the extension, and the first that
//! reports a failure prints a line.

use crate::guard::enter;
use std::ffi::c_void;
use std::io::Write;
use std::sync::Once;

/// `False`, `None`, 0 or a null pointer.
const NOTHING: isize = 0;
/// `GLX_NO_EXTENSION`: the display has no GLX.
const NO_EXTENSION: isize = 3;
/// `GLX_BAD_CONTEXT`: no context is current, or there is none of that name.
const BAD_CONTEXT: isize = 5;
/// `UST`, `MSC` and `SBC` are not negative; a pointer is no offset into AGP memory.
const MINUS_ONE: isize = -1;

/// Whether an answer prints the line about a failure.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Report {
    Failure,
    /// That nothing is current, and that there is no GLX, is what was asked.
    Silent,
}

/// A function that reads no argument, and answers an integer or a pointer.
macro_rules! stub {
    (exported $name:ident $report:ident $answer:ident) => {
        #[unsafe(no_mangle)]
        #[allow(non_snake_case, reason = "GLX's name")]
        extern "C" fn $name() -> isize {
            report(Report::$report, stringify!($name));
            $answer
        }
    };
    (by_address $name:ident $report:ident $answer:ident) => {
        #[allow(non_snake_case, reason = "GLX's name")]
        extern "C" fn $name() -> isize {
            report(Report::$report, stringify!($name));
            $answer
        }
    };
}

/// Such functions, and their names and addresses.
macro_rules! stubs {
    ($table:ident $linkage:ident { $($report:ident, $answer:ident: $($name:ident)*;)* }) => {
        $($(stub!($linkage $name $report $answer);)*)*

        const $table: &[(&str, extern "C" fn() -> isize)] =
            &[$($((stringify!($name), $name as extern "C" fn() -> isize)),*),*];
    };
}

stubs! { GLX_1_4 exported {
    Silent, NOTHING:
        glXGetCurrentContext glXGetCurrentDisplay glXGetCurrentDrawable glXGetCurrentReadDrawable
        glXQueryExtension;
    Failure, NOTHING:
        glXChooseFBConfig glXChooseVisual glXCopyContext glXCreateContext glXCreateContextAttribsARB
        glXCreateGLXPixmap glXCreateNewContext glXCreatePbuffer glXCreatePixmap glXCreateWindow
        glXDestroyContext glXDestroyGLXPixmap glXDestroyPbuffer glXDestroyPixmap glXDestroyWindow
        glXGetClientString glXGetFBConfigs glXGetSelectedEvent glXGetVisualFromFBConfig glXIsDirect
        glXMakeContextCurrent glXMakeCurrent glXQueryDrawable glXQueryExtensionsString
        glXQueryServerString glXQueryVersion glXSelectEvent glXSwapBuffers glXUseXFont glXWaitGL
        glXWaitX;
    Failure, NO_EXTENSION: glXGetConfig glXGetFBConfigAttrib;
    Failure, BAD_CONTEXT: glXQueryContext;
} }

// Those of extensions have no exported names, as libGL's have none by Linux's ABI.
stubs! { EXTENSIONS by_address {
    Silent, NOTHING:
        glXGetCurrentAssociatedContextAMD glXGetCurrentDisplayEXT glXGetCurrentReadDrawableSGI;
    Failure, NOTHING:
        glXAssociateDMPbufferSGIX glXBindSwapBarrierNV glXBindSwapBarrierSGIX glXBindTexImageEXT
        glXBlitContextFramebufferAMD glXChooseFBConfigSGIX glXCopyBufferSubDataNV glXCopyImageSubDataNV
        glXCopySubBufferMESA glXCreateAssociatedContextAMD glXCreateAssociatedContextAttribsAMD
        glXCreateContextWithConfigSGIX glXCreateGLXPbufferSGIX glXCreateGLXPixmapMESA
        glXCreateGLXPixmapWithConfigSGIX glXCreateGLXVideoSourceSGIX glXCushionSGI glXDelayBeforeSwapNV
        glXDeleteAssociatedContextAMD glXDestroyGLXPbufferSGIX glXDestroyGLXVideoSourceSGIX
        glXEnumerateVideoCaptureDevicesNV glXEnumerateVideoDevicesNV glXFreeContextEXT
        glXGetContextGPUIDAMD glXGetContextIDEXT glXGetFBConfigFromVisualSGIX glXGetGPUIDsAMD
        glXGetMscRateOML glXGetSelectedEventSGIX glXGetSwapIntervalMESA glXGetSyncValuesOML
        glXGetTransparentIndexSUN glXGetVisualFromFBConfigSGIX glXImportContextEXT glXJoinSwapGroupNV
        glXJoinSwapGroupSGIX glXLockVideoCaptureDeviceNV glXMakeAssociatedContextCurrentAMD
        glXMakeCurrentReadSGI glXNamedCopyBufferSubDataNV glXQueryCurrentRendererIntegerMESA
        glXQueryCurrentRendererStringMESA glXQueryFrameCountNV glXQueryGLXPbufferSGIX
        glXQueryHyperpipeConfigSGIX glXQueryHyperpipeNetworkSGIX glXQueryMaxSwapBarriersSGIX
        glXQueryMaxSwapGroupsNV glXQueryRendererIntegerMESA glXQueryRendererStringMESA
        glXQuerySwapGroupNV glXReleaseBuffersMESA glXReleaseTexImageEXT glXReleaseVideoCaptureDeviceNV
        glXResetFrameCountNV glXSelectEventSGIX glXSet3DfxModeMESA glXSwapIntervalEXT glXWaitForMscOML
        glXWaitForSbcOML;
    Failure, NO_EXTENSION:
        glXBindChannelToWindowSGIX glXBindHyperpipeSGIX glXBindVideoCaptureDeviceNV glXBindVideoDeviceNV
        glXBindVideoImageNV glXChannelRectSGIX glXChannelRectSyncSGIX glXDestroyHyperpipeConfigSGIX
        glXGetFBConfigAttribSGIX glXGetVideoDeviceNV glXGetVideoInfoNV glXHyperpipeAttribSGIX
        glXHyperpipeConfigSGIX glXQueryChannelDeltasSGIX glXQueryChannelRectSGIX
        glXQueryHyperpipeAttribSGIX glXQueryHyperpipeBestAttribSGIX glXQueryVideoCaptureDeviceNV
        glXReleaseVideoDeviceNV glXReleaseVideoImageNV glXSendPbufferToVideoNV;
    Failure, BAD_CONTEXT:
        glXGetVideoSyncSGI glXQueryContextInfoEXT glXSwapIntervalMESA glXSwapIntervalSGI
        glXWaitVideoSyncSGI;
    Failure, MINUS_ONE: glXGetAGPOffsetMESA glXGetGPUInfoAMD glXSwapBuffersMscOML;
} }

/// The address of a function of GLX; null where there is none of the name.
pub(crate) fn function(name: &str) -> *const c_void {
    let found = GLX_1_4.iter().chain(EXTENSIONS).find(|row| row.0 == name);
    found.map_or(std::ptr::null(), |row| row.1 as *const c_void)
}

/// Prints a line, once in a process, that there is no GLX.
#[cold]
#[inline(never)]
fn report(report: Report, name: &str) {
    static REPORTED: Once = Once::new();
    if report == Report::Failure {
        // A panic ends there; stderr may be closed.
        let _ = enter(|| {
            REPORTED.call_once(|| {
                let _ = writeln!(
                    std::io::stderr(),
                    "detgl: {name} fails, as DetGL has no GLX: make contexts with EGL or OSMesa"
                );
            });
        });
    }
}
