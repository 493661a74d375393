/* How programs end and divide, with a context current: lifetimes fork | exit | atexit | thread */

#include <EGL/egl.h>
#include <GL/gl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SIZE = 192 };

static EGLDisplay display;
static EGLSurface surface;
static EGLContext context;

static int start(void)
{
    static const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
        EGL_OPENGL_BIT, EGL_NONE };
    static const EGLint size[] = { EGL_WIDTH, SIZE, EGL_HEIGHT, SIZE, EGL_NONE };
    EGLConfig config;
    EGLint count;
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)
        || !eglChooseConfig(display, wanted, &config, 1, &count) || count != 1)
        return 0;
    surface = eglCreatePbufferSurface(display, config, size);
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
    return eglMakeCurrent(display, surface, surface, context);
}

/* Whether a triangle over everything gives its colour everywhere. */
static int draws(float red, float green)
{
    static GLubyte pixels[SIZE * SIZE * 4];
    glColor4f(red, green, 0, 1);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1);
    glVertex2f(3, -1);
    glVertex2f(-1, 3);
    glEnd();
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (int at = 0; at < SIZE * SIZE * 4; at += 4)
        if (pixels[at] != (GLubyte)(red * 255) || pixels[at + 1] != (GLubyte)(green * 255))
            return 0;
    return glGetError() == GL_NO_ERROR;
}

static int in_both_processes(void)
{
    if (!start() || !draws(1, 0))
        return 1;
    pid_t child = fork();
    if (child == 0) {
        /* What the parent drew is there, and the context goes on; so does a new one. */
        int good = draws(0, 1) && eglMakeCurrent(display, NULL, NULL, NULL) && start()
            && draws(1, 1);
        exit(!good);
    }
    int status = 1;
    int good = draws(1, 0) && draws(0, 1);
    return waitpid(child, &status, 0) != child || status != 0 || !good;
}

static void *elsewhere(void *unused)
{
    (void)unused;
    /* The other thread's context is refused; a thread that ends gives its own back. */
    int refused = !eglMakeCurrent(display, surface, surface, context)
        && eglGetError() == EGL_BAD_ACCESS;
    return refused && start() && draws(0, 1) ? display : NULL;
}

static int on_two_threads(void)
{
    pthread_t thread;
    void *good = NULL;
    if (!start() || !draws(1, 0))
        return 1;
    EGLContext mine = context;
    if (pthread_create(&thread, NULL, elsewhere, NULL) || pthread_join(thread, &good))
        return 1;
    return !good || eglGetCurrentContext() != mine || !draws(1, 1);
}

/* The main thread's destructors have run: its context is still there, and others can be made. */
static void at_last(void)
{
    EGLContext mine = context;
    int good = eglGetCurrentContext() == mine && draws(0, 1)
        && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT)
        && eglMakeCurrent(display, surface, surface, mine) && eglGetCurrentContext() == mine
        && draws(1, 0) && start() && context != mine && eglGetCurrentContext() == context
        && draws(1, 1) && !eglMakeCurrent(display, surface, surface, EGL_NO_CONTEXT)
        && eglGetError() == EGL_BAD_MATCH;
    _exit(!good);
}

int main(int argc, char **argv)
{
    const char *what = argc == 2 ? argv[1] : "";
    if (!strcmp(what, "fork"))
        return in_both_processes();
    if (!strcmp(what, "thread"))
        return on_two_threads();
    if (!strcmp(what, "exit"))
        exit(!(start() && draws(1, 0)));
    if (!strcmp(what, "atexit") && !atexit(at_last))
        exit(start() && draws(1, 0) ? 0 : 1);
    fprintf(stderr, "lifetimes fork | exit | atexit | thread\n");
    return 2;
}
