/* A program with variables of GL's names, as loaders generate them: the library must not take them
   for its own functions. */

#include <EGL/egl.h>
#include <GL/gl.h>
#include <stddef.h>

typedef void (*Buffers)(GLsizei n, GLuint *names);

Buffers glGenBuffers;

int main(void)
{
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    GLuint name = 0;
    eglInitialize(display, NULL, NULL);
    eglBindAPI(EGL_OPENGL_API);
    EGLContext context = eglCreateContext(display, NULL, EGL_NO_CONTEXT, NULL);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        return 1;
    glGenBuffers = (Buffers)eglGetProcAddress("glGenBuffers");
    if ((void *)glGenBuffers == (void *)&glGenBuffers)
        return 2;
    glGenBuffers(1, &name);
    return name == 0 || glGetError() != GL_NO_ERROR;
}
