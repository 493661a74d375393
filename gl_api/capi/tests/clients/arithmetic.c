/* Has its processor flush denormals or round toward zero, as its argument says, and makes a context. */

#include <EGL/egl.h>
#include <stddef.h>
#include <string.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

int main(int count, char **arguments)
{
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    eglInitialize(display, NULL, NULL);
    eglBindAPI(EGL_OPENGL_API);
#ifdef __SSE2__
    if (count > 1)
        _mm_setcsr(_mm_getcsr() | (strcmp(arguments[1], "flush") == 0 ? 0x8040 : 0x6000));
#endif
    return eglCreateContext(display, NULL, EGL_NO_CONTEXT, NULL) == EGL_NO_CONTEXT;
}
