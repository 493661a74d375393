//! What this process loads under the names of libraries, and which contexts it can make. In a process of its own, as
//! `doctor` starts it: what is loaded stays, and a driver may crash.
#![allow(unsafe_code, reason = "calls functions of drivers that are opened at run time")]

use super::layout::NAMES;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::io;
use std::ptr::{null, null_mut};

unsafe extern "C" {
    fn dlopen(file: *const c_char, mode: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
    fn dlerror() -> *const c_char;
    fn dlinfo(library: *mut c_void, request: c_int, out: *mut c_void) -> c_int;
}

const RTLD_NOW: c_int = 2;
const RTLD_DI_LINKMAP: c_int = 2;

/// The beginning of `struct link_map`.
#[repr(C)]
struct LinkMap {
    address: usize,
    name: *const c_char,
}

/// A library that is loaded, until the process ends.
struct Library(*mut c_void);

/// Text of C.
///
/// # Safety
/// What is not null is text that a zero ends.
unsafe fn text(text: *const c_char) -> Option<String> {
    // SAFETY: promised by the caller.
    (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned())
}

impl Library {
    fn open(name: &str) -> Result<Self, String> {
        let file = CString::new(name).map_err(|error| error.to_string())?;
        // SAFETY: running a library's initializers is what opening a driver means.
        let library = unsafe { dlopen(file.as_ptr(), RTLD_NOW) };
        if !library.is_null() {
            return Ok(Self(library));
        }
        // SAFETY: text of the loader's, until its next call.
        Err(unsafe { text(dlerror()) }.unwrap_or_default())
    }

    fn path(&self) -> Option<String> {
        let mut map: *const LinkMap = null();
        // SAFETY: the request writes a pointer to a map, which lives as long as the library.
        unsafe {
            let written = dlinfo(self.0, RTLD_DI_LINKMAP, (&raw mut map).cast()) == 0;
            if written { text((*map).name) } else { None }
        }
    }

    /// A function by its name.
    ///
    /// # Safety
    /// `F` is the type of a pointer to that function.
    unsafe fn function<F: Copy>(&self, name: &CStr) -> Result<F, String> {
        const { assert!(size_of::<F>() == size_of::<*mut c_void>()) };
        // SAFETY: a library and a text.
        let address = unsafe { dlsym(self.0, name.as_ptr()) };
        if address.is_null() {
            return Err(format!("{} is not there", name.to_string_lossy()));
        }
        // SAFETY: a pointer, of the type that the caller promises.
        Ok(unsafe { std::mem::transmute_copy(&address) })
    }

    /// Whether it is DetGL, or a facade of it.
    fn is_detgl(&self) -> bool {
        // SAFETY: only its presence is looked at.
        unsafe { self.function::<*const c_void>(c"detglInfo") }.is_ok()
    }
}

/// Prints everything.
pub fn probe() -> io::Result<()> {
    libraries();
    contexts();
    Ok(())
}

/// Prints what is loaded under each name; names without a version only where they are another's library.
fn libraries() {
    for name in &NAMES {
        let versioned = Library::open(name.versioned);
        print_library(name.versioned, &versioned);
        let plain = Library::open(name.plain);
        let whose = |library: &Result<Library, _>| library.as_ref().map(Library::is_detgl).ok();
        if plain.is_ok() && whose(&plain) != whose(&versioned) {
            print_library(name.plain, &plain);
        }
    }
}

fn print_library(name: &str, library: &Result<Library, String>) {
    match library {
        Ok(library) => {
            let whose = if library.is_detgl() { "DetGL" } else { "another driver" };
            println!("  {name:<15} {whose}: {}", library.path().unwrap_or_default());
        }
        Err(why) => println!("  {name:<15} none: {why}"),
    }
}

/// What a version of an API is asked for with.
struct Request {
    api: Api,
    version: (i32, i32),
    profile: Option<Profile>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Api {
    OpenGl,
    OpenGlEs,
}

#[derive(Clone, Copy)]
enum Profile {
    Core,
    Compatibility,
}

/// Each that programs ask for; those that DetGL refuses, too.
fn requests() -> Vec<Request> {
    let gl = [(2, 1), (3, 0), (3, 1), (3, 2), (3, 3), (4, 1), (4, 6)];
    let mut all = Vec::new();
    for version in gl {
        let profiles = [Some(Profile::Core), Some(Profile::Compatibility)];
        let profiles = if version < (3, 2) { &[None][..] } else { &profiles };
        let request = |&profile| Request { api: Api::OpenGl, version, profile };
        all.extend(profiles.iter().map(request));
    }
    let es = [(2, 0), (3, 0), (3, 1), (3, 2)];
    all.extend(es.map(|version| Request { api: Api::OpenGlEs, version, profile: None }));
    all
}

impl Request {
    fn name(&self) -> String {
        let (major, minor) = self.version;
        let (api, profile) = match (self.api, self.profile) {
            (Api::OpenGlEs, _) => ("OpenGL ES", ""),
            (Api::OpenGl, None) => ("OpenGL", ""),
            (Api::OpenGl, Some(Profile::Core)) => ("OpenGL", " core"),
            (Api::OpenGl, Some(Profile::Compatibility)) => ("OpenGL", " compatibility"),
        };
        format!("{api} {major}.{minor}{profile}")
    }
}

type Handle = *mut c_void;
type GetString = unsafe extern "C" fn(u32) -> *const c_char;
const GL_RENDERER: u32 = 0x1F01;
const GL_VERSION: u32 = 0x1F02;
const EGL_NONE: i32 = 0x3038;
/// EGL's errors, from 0x3000 on (EGL 1.5, section 3.1).
const EGL_ERRORS: [&str; 15] = [
    "EGL_SUCCESS",
    "EGL_NOT_INITIALIZED",
    "EGL_BAD_ACCESS",
    "EGL_BAD_ALLOC",
    "EGL_BAD_ATTRIBUTE",
    "EGL_BAD_CONFIG",
    "EGL_BAD_CONTEXT",
    "EGL_BAD_CURRENT_SURFACE",
    "EGL_BAD_DISPLAY",
    "EGL_BAD_MATCH",
    "EGL_BAD_NATIVE_PIXMAP",
    "EGL_BAD_NATIVE_WINDOW",
    "EGL_BAD_PARAMETER",
    "EGL_BAD_SURFACE",
    "EGL_CONTEXT_LOST",
];

/// An error's name; what is no error of EGL is a number.
fn egl_error(code: i32) -> String {
    let at = code.checked_sub(0x3000).and_then(|at| usize::try_from(at).ok());
    let name = at.and_then(|at| EGL_ERRORS.get(at));
    name.map_or_else(|| format!("{code:#06x}"), |name| (*name).to_owned())
}

/// What the current context says of itself.
///
/// # Safety
/// `get_string` is `glGetString`, and a context is current.
unsafe fn describe(get_string: Option<GetString>) -> Result<String, String> {
    let get_string = get_string.ok_or("glGetString is not there")?;
    // SAFETY: promised by the caller; the texts live as long as the context.
    let texts = unsafe { [GL_VERSION, GL_RENDERER].map(|name| text(get_string(name))) };
    let [Some(version), Some(renderer)] = texts else {
        return Err("the context says nothing of itself".to_owned());
    };
    Ok(format!("{version}, {renderer}"))
}

/// The functions of EGL that make a context.
struct Egl {
    display: Handle,
    choose: unsafe extern "C" fn(Handle, *const i32, *mut Handle, i32, *mut i32) -> u32,
    bind_api: unsafe extern "C" fn(u32) -> u32,
    create: unsafe extern "C" fn(Handle, Handle, Handle, *const i32) -> Handle,
    surface: unsafe extern "C" fn(Handle, Handle, *const i32) -> Handle,
    make_current: unsafe extern "C" fn(Handle, Handle, Handle, Handle) -> u32,
    destroy: unsafe extern "C" fn(Handle, Handle) -> u32,
    error: unsafe extern "C" fn() -> i32,
    address: unsafe extern "C" fn(*const c_char) -> Option<GetString>,
}

impl Egl {
    fn open() -> Result<Self, String> {
        const DEFAULT_DISPLAY: Handle = null_mut();
        let library = Library::open("libEGL.so.1")?;
        // SAFETY: EGL's prototypes (EGL 1.5, chapter 3); null where it is allowed.
        unsafe {
            let get: unsafe extern "C" fn(Handle) -> Handle = library.function(c"eglGetDisplay")?;
            let initialize: unsafe extern "C" fn(Handle, *mut i32, *mut i32) -> u32 =
                library.function(c"eglInitialize")?;
            let error: unsafe extern "C" fn() -> i32 = library.function(c"eglGetError")?;
            let display = get(DEFAULT_DISPLAY);
            if display.is_null() || initialize(display, null_mut(), null_mut()) == 0 {
                return Err(format!("no display: eglInitialize, {}", egl_error(error())));
            }
            Ok(Self {
                display,
                choose: library.function(c"eglChooseConfig")?,
                bind_api: library.function(c"eglBindAPI")?,
                create: library.function(c"eglCreateContext")?,
                surface: library.function(c"eglCreatePbufferSurface")?,
                make_current: library.function(c"eglMakeCurrent")?,
                destroy: library.function(c"eglDestroyContext")?,
                error,
                address: library.function(c"eglGetProcAddress")?,
            })
        }
    }

    /// What a context says that has just been made.
    fn try_context(&self, request: &Request) -> Result<String, String> {
        let (api, bit) = match request.api {
            Api::OpenGl => (0x30A2, 0x8),
            Api::OpenGlEs if request.version.0 >= 3 => (0x30A0, 0x40),
            Api::OpenGlEs => (0x30A0, 0x4),
        };
        // EGL_SURFACE_TYPE is EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE.
        let wanted = [0x3033, 1, 0x3040, bit, EGL_NONE];
        // EGL_CONTEXT_MAJOR_VERSION, _MINOR_VERSION, _OPENGL_PROFILE_MASK.
        let mut attributes = vec![0x3098, request.version.0, 0x30FB, request.version.1];
        match request.profile {
            None => {}
            Some(Profile::Core) => attributes.extend([0x30FD, 1]),
            Some(Profile::Compatibility) => attributes.extend([0x30FD, 2]),
        }
        attributes.push(EGL_NONE);
        let (mut config, mut count) = (null_mut(), 0);
        let dpy = self.display;
        // SAFETY: EGL's prototypes; lists end with EGL_NONE, and results are written to locals.
        unsafe {
            let failed = |call: &str| Err(format!("{call}: {}", egl_error((self.error)())));
            if (self.bind_api)(api) == 0 {
                return failed("eglBindAPI");
            }
            let chosen = (self.choose)(dpy, wanted.as_ptr(), &mut config, 1, &mut count);
            if chosen == 0 || count == 0 {
                return Err("no configuration with a pbuffer".to_owned());
            }
            let context = (self.create)(dpy, config, null_mut(), attributes.as_ptr());
            if context.is_null() {
                return failed("eglCreateContext");
            }
            let size = [0x3057, 16, 0x3056, 16, EGL_NONE];
            let surface = (self.surface)(dpy, config, size.as_ptr());
            let said = if (self.make_current)(dpy, surface, surface, context) == 0 {
                failed("eglMakeCurrent")
            } else {
                describe((self.address)(c"glGetString".as_ptr()))
            };
            (self.make_current)(dpy, null_mut(), null_mut(), null_mut());
            (self.destroy)(dpy, context);
            said
        }
    }
}

/// What a context of OSMesa says that has just been made.
fn try_osmesa(library: &Library, request: &Request) -> Result<String, String> {
    // OSMESA_FORMAT, _PROFILE, _CONTEXT_MAJOR_VERSION, _CONTEXT_MINOR_VERSION.
    let profile = match request.profile {
        Some(Profile::Core) => 0x34,
        Some(Profile::Compatibility) | None => 0x35,
    };
    let (major, minor) = request.version;
    let attributes = [0x22, 0x1908, 0x33, profile, 0x36, major, 0x37, minor, 0];
    let mut memory = [0_u8; 16 * 16 * 4];
    // SAFETY: OSMesa's prototypes; the list ends with 0, and the memory is left alone when the context is gone.
    unsafe {
        let create: unsafe extern "C" fn(*const i32, Handle) -> Handle =
            library.function(c"OSMesaCreateContextAttribs")?;
        let make_current: unsafe extern "C" fn(Handle, *mut u8, u32, i32, i32) -> u8 =
            library.function(c"OSMesaMakeCurrent")?;
        let destroy: unsafe extern "C" fn(Handle) = library.function(c"OSMesaDestroyContext")?;
        let context = create(attributes.as_ptr(), null_mut());
        if context.is_null() {
            return Err("OSMesaCreateContextAttribs: NULL".to_owned());
        }
        let said = if make_current(context, memory.as_mut_ptr(), 0x1401, 16, 16) == 0 {
            Err("OSMesaMakeCurrent: GL_FALSE".to_owned())
        } else {
            describe(library.function(c"glGetString").ok())
        };
        destroy(context);
        said
    }
}

/// Prints which contexts can be made.
fn contexts() {
    fn print(name: &str, said: Result<String, String>) {
        match said {
            Ok(said) => println!("  {name:<32} yes: {said}"),
            Err(why) => println!("  {name:<32} no: {why}"),
        }
    }
    match Egl::open() {
        Ok(egl) => {
            for request in requests() {
                print(&format!("EGL, {}", request.name()), egl.try_context(&request));
            }
        }
        Err(why) => print("EGL", Err(why)),
    }
    match Library::open("libOSMesa.so.8") {
        Ok(library) => {
            for request in requests().iter().filter(|request| request.api == Api::OpenGl) {
                print(&format!("OSMesa, {}", request.name()), try_osmesa(&library, request));
            }
        }
        Err(why) => print("OSMesa", Err(why)),
    }
}
