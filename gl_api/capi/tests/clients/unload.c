/* Loads OSMesa by hand, draws, and unloads it while its context is current and its threads wait. */

#include <GL/gl.h>
#include <dlfcn.h>
#include <stdio.h>
#include <unistd.h>

enum { SIZE = 192 };

typedef void *(*Create)(GLenum format, void *share);
typedef GLboolean (*MakeCurrent)(void *context, void *buffer, GLenum type, GLsizei w, GLsizei h);
typedef void (*Rect)(GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2);
typedef void (*Finish)(void);

int main(void)
{
    static GLubyte pixels[SIZE * SIZE * 4];
    for (int round = 0; round < 2; round++) {
        void *library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
        if (!library)
            return fprintf(stderr, "%s\n", dlerror());
        Create create = (Create)dlsym(library, "OSMesaCreateContext");
        MakeCurrent make_current = (MakeCurrent)dlsym(library, "OSMesaMakeCurrent");
        Rect rect = (Rect)dlsym(library, "glRectf");
        Finish finish = (Finish)dlsym(library, "glFinish");
        if (!create || !make_current || !rect || !finish)
            return 1;
        pixels[0] = 0;
        if (!make_current(create(GL_RGBA, NULL), pixels, GL_UNSIGNED_BYTE, SIZE, SIZE))
            return 1;
        rect(-1, -1, 1, 1);
        finish();
        if (pixels[0] != 255 || dlclose(library))
            return 1;
        usleep(20000);
    }
    return 0;
}
