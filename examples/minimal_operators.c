/* cc minimal_operators.c -o minimal_operators -lEGL -lGLESv2 -lm     (needs oit_buffers.h beside it or -I)
 *
 * Operators of one's own on every fragment of a picture, with oit_operator_glsl and oit_run: three glass balls, one in
 * another and one through both, whose outlines are found by a Sobel filter and whose faces are clear, without a window,
 * into minimal_operators.ppm. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#define OIT_BUFFERS_IMPLEMENTATION
#define OIT_GL_STATIC
#include "oit_buffers.h"

enum { SIZE = 512, RINGS = 64, SECTORS = 128, BALL = RINGS * SECTORS * 6, MOST_STRINGS = 32 };
static float vertices[BALL][3]; /* of the unit ball, whose normals are its points */
static unsigned char pixels[SIZE * SIZE * 4];

/* A local operator: it looks at fragments of the pixels around, along the surface, so that every layer has its outlines.
 * The filter is that of Sobel on depth: how steep the surface is. */
static const char sobel[] =
    "uniform highp float pixel; // its size in the scene\n"
    "const uint NOWHERE = 4u;\n"
    "float z_at(uint p, uint slot, uint along, uint up) // of the fragment one step along, one up, or as far as it goes\n"
    "{\n"
    "    uint next = along == NOWHERE ? OIT_NONE : oit_neighbour(p, slot, along);\n"
    "    if (next != OIT_NONE) {\n"
    "        oit_beside(p, along, p);\n"
    "        slot = next;\n"
    "    }\n"
    "    next = up == NOWHERE ? OIT_NONE : oit_neighbour(p, slot, up);\n"
    "    if (next != OIT_NONE) {\n"
    "        oit_beside(p, up, p);\n"
    "        slot = next;\n"
    "    }\n"
    "    return oit_position(oit_device(p), oit_depth(slot)).z;\n"
    "}\n"
    "float edge(uint p, uint slot)\n"
    "{\n"
    "    float z[9];\n"
    "    for (uint i = 0u; i < 9u; ++i) {\n"
    "        uint x = i % 3u, y = i / 3u;\n"
    "        z[i] = z_at(p, slot, x == 0u ? OIT_LEFTWARD : x == 2u ? OIT_RIGHTWARD : NOWHERE,\n"
    "                    y == 0u ? OIT_DOWNWARD : y == 2u ? OIT_UPWARD : NOWHERE);\n"
    "    }\n"
    "    vec2 slope = vec2(z[2] - z[0] + 2.0 * (z[5] - z[3]) + z[8] - z[6],\n"
    "                      z[6] - z[0] + 2.0 * (z[7] - z[1]) + z[8] - z[2]) / (8.0 * pixel);\n"
    "    return smoothstep(2.0, 4.0, length(slope));\n"
    "}\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint slot = first; slot < first + n; ++slot)\n"
    "        oit_set_value(OIT_HOST, slot, edge(p, slot));\n"
    "}\n";

/* A purely local one: it looks at its own pixel alone. Surfaces hide the less the more they face the eye (the angle law),
 * but for the edges. */
static const char angle[] =
    "uniform highp float least; // opacity of what faces the eye\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint slot = first; slot < first + n; ++slot) {\n"
    "        float facing = abs(dot(oit_normal(slot), oit_to_eye(oit_device(p))));\n"
    "        oit_set_value(OIT_BASE, slot, max(1.0 - (1.0 - least) * facing, oit_value(OIT_HOST, slot)));\n"
    "    }\n"
    "}\n";

static bool make_context(void) {
    static const EGLint config[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT,
                                    EGL_NONE};
    static const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLConfig chosen;
    EGLint count = 0;
    if (!eglInitialize(display, NULL, NULL) && !eglInitialize(display = eglGetDisplay(EGL_DEFAULT_DISPLAY), NULL, NULL))
        return false;
    if (!eglChooseConfig(display, config, &chosen, 1, &count) || count == 0 || !eglBindAPI(EGL_OPENGL_ES_API))
        return false;
    EGLContext context = eglCreateContext(display, chosen, EGL_NO_CONTEXT, version);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

static void make_ball(void) {
    static const int corner[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    GLuint array, buffer;
    for (int i = 0; i < BALL; ++i) {
        const int *c = corner[i % 6];
        double polar = 3.14159265358979 * (i / 6 / SECTORS + c[0]) / RINGS;
        double turn = 6.28318530717959 * (i / 6 % SECTORS + c[1]) / SECTORS;
        vertices[i][0] = (float)(sin(polar) * cos(turn));
        vertices[i][1] = (float)(sin(polar) * sin(turn));
        vertices[i][2] = (float)cos(polar);
    }
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    }
}

static GLuint make_target(void) {
    GLuint names[2], framebuffer;
    glGenRenderbuffers(2, names);
    glBindRenderbuffer(GL_RENDERBUFFER, names[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, SIZE, SIZE);
    glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, SIZE, SIZE);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
    return framebuffer;
}

static GLuint make_operator(const oit_context *oit, const char *text, const char *name, float value) {
    const char *strings[MOST_STRINGS + 1];
    int count = 0;
    const char *const *before = oit_operator_glsl(oit, &count);
    GLint linked = 0;
    char log[1024] = "";
    if (count > MOST_STRINGS)
        return fprintf(stderr, "minimal_operators: %d strings\n", count), 0;
    for (int i = 0; i < count; ++i)
        strings[i] = before[i];
    strings[count] = text;
    GLuint shader = glCreateShader(GL_COMPUTE_SHADER), program = glCreateProgram();
    glShaderSource(shader, count + 1, strings, NULL);
    glCompileShader(shader);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
        return fprintf(stderr, "minimal_operators: %s\n", log), 0;
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, name), value);
    return program;
}

/* Neighbours, then the operators of ours: edges into a number that each fragment has for us, and from it opacity. */
static oit_result operate(oit_context *oit, const GLuint programs[2]) {
    static const int values[2] = {OIT_VALUE_HOST, OIT_VALUE_BASE};
    oit_operator op = {0}; /* OIT_RUN_LINK, by depth */
    oit_result result = oit_run(oit, &op);
    for (int i = 0; i < 2 && result == OIT_OK; ++i) {
        op.kind = OIT_RUN_HOST;
        op.host.program = programs[i];
        op.host.value = values[i];
        result = oit_run(oit, &op);
    }
    return result;
}

static void draw_balls(oit_context *oit, const oit_pass *pass) {
    static const float balls[3][4] = {{0, 0, 0, 0.85f}, {-0.2f, 0.1f, 0.1f, 0.4f}, {0.35f, -0.1f, -0.3f, 0.45f}};
    static const float colors[3][3] = {{0.3f, 0.6f, 0.9f}, {0.9f, 0.5f, 0.2f}, {0.3f, 0.8f, 0.3f}};
    for (int i = 0; i < 3; ++i) {
        const float *b = balls[i], r = b[3];
        oit_material material = {{r, 0, 0, 0, 0, r, 0, 0, 0, 0, -r, 0, b[0], b[1], -b[2], 1}, /* along -z */
                                 {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                 {colors[i][0], colors[i][1], colors[i][2], 1},
                                 (uint32_t)i, /* fragments of two parts are never neighbours */
                                 0,
                                 OIT_BLEND_OVER,
                                 0};
        oit_set_material(oit, pass, &material);
        glDrawArrays(GL_TRIANGLES, 0, BALL);
    }
}

static int write_picture(void) {
    FILE *file = fopen("minimal_operators.ppm", "wb");
    if (!file)
        return perror("minimal_operators.ppm"), 1;
    fprintf(file, "P6 %d %d 255\n", SIZE, SIZE);
    for (int y = SIZE - 1; y >= 0; --y)
        for (int x = 0; x < SIZE; ++x)
            fwrite(&pixels[(y * SIZE + x) * 4], 1, 3, file);
    return fclose(file) != 0;
}

int main(void) {
    oit_desc desc = {0};
    oit_frame frame = {0};
    oit_pass pass;
    oit_result result;
    if (!make_context())
        return fprintf(stderr, "minimal_operators: no OpenGL ES 3.1 context\n"), 1;
    desc.operators = OIT_OPERATE_LINKS | OIT_OPERATE_LAW; /* neighbours, and opacities of our own */
    desc.operator_fields = 1;
    oit_context *oit = oit_create(&desc, &result);
    if (!oit)
        return fprintf(stderr, "minimal_operators: %s\n", oit_result_string(result)), 1;
    const GLuint programs[2] = {make_operator(oit, sobel, "pixel", 2.0f / SIZE),
                                make_operator(oit, angle, "least", 0.1f)};
    frame.framebuffer = make_target();
    frame.width = frame.height = SIZE;
    frame.projection[0] = frame.projection[5] = frame.projection[15] = 1; /* parallel, from -1 to 1 */
    frame.projection[10] = -1;
    frame.light[0] = -0.4f;
    frame.light[1] = frame.light[2] = 0.7f;
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    make_ball();
    result = programs[0] && programs[1] ? oit_begin(oit, &frame) : OIT_SHADER_FAILED;
    while (result == OIT_OK && oit_next_pass(oit, &pass))
        draw_balls(oit, &pass);
    if (result == OIT_OK) {
        result = operate(oit, programs);
        oit_compose(oit);
        oit_result end = oit_end(oit);
        result = result == OIT_OK ? end : result;
    }
    if (result != OIT_OK)
        return fprintf(stderr, "minimal_operators: %s\n", oit_result_string(result)), 1;
    oit_destroy(oit);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    return write_picture();
}
