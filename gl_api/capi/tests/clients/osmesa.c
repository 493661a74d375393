/* Draws a triangle into its own memory, as a program that is linked with OSMesa; says which driver that was. */
#include <EGL/egl.h>
#include <GL/glext.h>
#include <GL/glu.h>
#include <GL/osmesa.h>
#include <GLES2/gl2.h>
#include <stdio.h>

#if !defined(GL_VERSION_3_3) || !defined(EGL_VERSION_1_5) || !defined(GL_ES_VERSION_2_0)
#error "the headers do not say which versions there are"
#endif

int main(void)
{
    static unsigned char pixels[64 * 64 * 4];
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 64, 64))
        return 1;
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(0, 1);
    glEnd();
    glFinish();
    const unsigned char *middle = &pixels[(32 * 64 + 32) * 4], *corner = &pixels[63 * 64 * 4];
    printf("%s %d %d %d %d\n", (const char *)glGetString(GL_RENDERER), middle[0], middle[2], corner[0], corner[2]);
    const GLenum error = glGetError();
    OSMesaDestroyContext(context);
    return error != GL_NO_ERROR;
}
