/* The lecture's code as printed ("Texture Mapping", slides "Texture Mapping in OpenGL" and "Loose
   Ends of Texture Setup") in a program without a window. Writes a picture as PPM: demon OUT */

#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glu.h>
#include <stdio.h>

#include "lecture.h"

int main(int argc, char **argv)
{
    enum { SIZE = 256 };
    static GLubyte pixels[SIZE * SIZE * 3];
    static const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
        EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_NONE };
    static const EGLint size[] = { EGL_WIDTH, SIZE, EGL_HEIGHT, SIZE, EGL_NONE };
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EGLConfig config;
    EGLint count;
    if (argc != 2 || !eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)
        || !eglChooseConfig(display, wanted, &config, 1, &count) || count != 1)
        return 1;
    EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
    if (!eglMakeCurrent(display, surface, surface, context))
        return 1;

    setup();
    draw();

    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    if (glGetError() != GL_NO_ERROR)
        return 1;
    FILE *file = fopen(argv[1], "wb");
    if (!file)
        return 1;
    fprintf(file, "P6\n%d %d\n255\n", SIZE, SIZE);
    fwrite(pixels, 1, sizeof pixels, file);
    return fclose(file);
}
