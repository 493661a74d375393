/* GLU's quadrics, cameras and projections: lit and textured in four viewports. Writes a picture as
   PPM: quadrics OUT */

#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glu.h>
#include <math.h>
#include <stdio.h>

enum { SIZE = 256 };

static void view(int column, int row)
{
    glViewport(column * SIZE / 2, row * SIZE / 2, SIZE / 2, SIZE / 2);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, 1, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(2, -3, 2.2, 0, 0, 0.3, 0, 0, 1);
}

/* Whether a point comes back from the window as it went. */
static int there_and_back(void)
{
    GLdouble model[16], projection[16], x, y, z, back[3];
    GLint viewport[4];
    glGetDoublev(GL_MODELVIEW_MATRIX, model);
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetIntegerv(GL_VIEWPORT, viewport);
    return gluProject(0.5, 0.25, 0.75, model, projection, viewport, &x, &y, &z) == GL_TRUE
        && gluUnProject(x, y, z, model, projection, viewport, &back[0], &back[1], &back[2])
            == GL_TRUE
        && fabs(back[0] - 0.5) + fabs(back[1] - 0.25) + fabs(back[2] - 0.75) < 1e-6;
}

int main(int argc, char **argv)
{
    static GLubyte pixels[SIZE * SIZE * 3];
    static const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
        EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE };
    static const EGLint size[] = { EGL_WIDTH, SIZE, EGL_HEIGHT, SIZE, EGL_NONE };
    static const GLubyte checks[] = { 255, 230, 60, 255, 60, 90, 230, 255, 60, 90, 230, 255, 255,
        230, 60, 255 };
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

    glClearColor(0.2f, 0.2f, 0.25f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, checks);

    GLUquadric *quadric = gluNewQuadric();
    view(0, 0);
    if (!there_and_back())
        return 1;
    gluSphere(quadric, 0.9, 24, 16);

    view(1, 0);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_TEXTURE);
    glScalef(3, 2, 1);
    gluQuadricTexture(quadric, GL_TRUE);
    gluCylinder(quadric, 0.7, 0.3, 1.2, 20, 4);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();

    view(0, 1);
    gluDisk(quadric, 0.3, 0.9, 20, 3);
    gluSphere(quadric, 0.25, 12, 8);

    view(1, 1);
    glDisable(GL_TEXTURE_2D);
    glShadeModel(GL_FLAT);
    gluQuadricNormals(quadric, GLU_FLAT);
    gluQuadricOrientation(quadric, GLU_INSIDE);
    gluPartialDisk(quadric, 0.2, 1, 12, 2, 30, 200);
    glTranslatef(0, 0, 0.6f);
    gluSphere(quadric, 0.4, 10, 6);
    gluDeleteQuadric(quadric);

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
