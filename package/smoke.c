/* Draws two pictures into its own memory, the fixed function and a shader, and prints a digest (FNV-1a) of each: the same on
   every machine. */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>
#include <stdint.h>
#include <stdio.h>

enum { SIZE = 128 };
static unsigned char pixels[SIZE * SIZE * 4];

static const char *vertex = "#version 120\nvarying vec3 p; void main() { p = gl_Vertex.xyz; gl_Position = gl_Vertex; }";
static const char *fragment =
    "#version 120\nvarying vec3 p; uniform sampler2D image;\n"
    "void main() { float s = 0.0; for (int i = 1; i < 9; i++) s += sin(p.x * float(i)) * exp2(-p.y * float(i));\n"
    "gl_FragColor = vec4(fract(s), pow(abs(p.x), 0.3), atan(p.y, p.x) * 0.15 + 0.5, 1.0) * texture2D(image, p.xy * 3.0); }";

static void digest(const char *name)
{
    uint64_t hash = 14695981039346656037u;
    glFinish();
    for (unsigned at = 0; at < sizeof pixels; at++)
        hash = (hash ^ pixels[at]) * 1099511628211u;
    printf("%s %016llx\n", name, (unsigned long long)hash);
}

static GLuint shader(GLenum stage, const char *source)
{
    const GLuint name = glCreateShader(stage);
    glShaderSource(name, 1, &source, NULL);
    glCompileShader(name);
    return name;
}

static void square(void)
{
    static const float corners[4][2] = { { -0.9f, -0.8f }, { 0.95f, -0.9f }, { 0.7f, 0.9f }, { -0.7f, 0.6f } };
    glBegin(GL_QUADS);
    for (int at = 0; at < 4; at++) {
        glColor4f(at & 1, 0.5f * at, 0.3f, 0.4f + 0.15f * at);
        glNormal3f(corners[at][0], corners[at][1], 0.7f);
        glTexCoord2fv(corners[at]);
        glVertex3f(corners[at][0], corners[at][1], 0.3f * at - 0.4f);
    }
    glEnd();
}

int main(void)
{
    static unsigned char texels[32 * 32 * 4];
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, SIZE, SIZE))
        return 1;
    for (unsigned at = 0; at < sizeof texels; at++)
        texels[at] = at * at / 7 + at;
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);

    glClearColor(0.1f, 0.2f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_FOG);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (int turn = 0; turn < 5; turn++) {
        glRotatef(33, 0.3f, 0.4f, 1);
        square();
    }
    digest("fixed");

    const GLuint program = glCreateProgram();
    glAttachShader(program, shader(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    glUseProgram(program);
    glDisable(GL_BLEND);
    square();
    digest("shader");
    const GLenum error = glGetError();
    OSMesaDestroyContext(context);
    return error != GL_NO_ERROR;
}
