/* gl_state.c: the state contract of transparency.h on a real driver. Hostile random state before, every call made, a
 * full snapshot compared after; and what a steady frame may not do. */
#include "gl_harness.h"

/* ---- a snapshot that knows nothing of the header's own ---- */

enum { MAX_VALUES = 800 };

typedef struct snapshot {
    const char *names[MAX_VALUES];
    double values[MAX_VALUES];
    int count;
} snapshot;

static bool is_es;
static int version;

static void take(snapshot *s, const char *name, double value) {
    assert_true(s->count < MAX_VALUES);
    s->names[s->count] = name;
    s->values[s->count++] = value;
}

static void take_integers(snapshot *s, const char *name, GLenum what, int count) {
    GLint v[16] = {0};
    glGetIntegerv(what, v);
    for (int i = 0; i < count; ++i)
        take(s, name, v[i]);
}

static void take_floats(snapshot *s, const char *name, GLenum what, int count) {
    GLfloat v[16] = {0};
    glGetFloatv(what, v);
    for (int i = 0; i < count; ++i)
        take(s, name, (double)v[i]);
}

static const GLenum switches[] = {
    GL_BLEND,           GL_CULL_FACE,          GL_DEPTH_TEST,          GL_DITHER,
    GL_SCISSOR_TEST,    GL_STENCIL_TEST,       GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD,
};
static const GLenum desktop_switches[] = {
    GL_COLOR_LOGIC_OP,    GL_DEPTH_CLAMP,        GL_FRAMEBUFFER_SRGB,    GL_LINE_SMOOTH,
    GL_MULTISAMPLE,       GL_POLYGON_SMOOTH,     GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT,
    GL_PRIMITIVE_RESTART, GL_PROGRAM_POINT_SIZE, GL_SAMPLE_MASK,         GL_SAMPLE_ALPHA_TO_ONE,
    GL_CLIP_DISTANCE0,    GL_CLIP_DISTANCE3,     GL_CLIP_DISTANCE7,      GL_TEXTURE_CUBE_MAP_SEAMLESS,
};

static const struct {
    const char *name;
    GLenum what;
    int count;
} integers[] = {
    {"program", GL_CURRENT_PROGRAM, 1},
    {"vertex array", GL_VERTEX_ARRAY_BINDING, 1},
    {"draw framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 1},
    {"read framebuffer", GL_READ_FRAMEBUFFER_BINDING, 1},
    {"renderbuffer", GL_RENDERBUFFER_BINDING, 1},
    {"array buffer", GL_ARRAY_BUFFER_BINDING, 1},
    {"uniform buffer", GL_UNIFORM_BUFFER_BINDING, 1},
    {"copy read buffer", GL_COPY_READ_BUFFER_BINDING, 1},
    {"copy write buffer", GL_COPY_WRITE_BUFFER_BINDING, 1},
    {"pixel pack buffer", GL_PIXEL_PACK_BUFFER_BINDING, 1},
    {"pixel unpack buffer", GL_PIXEL_UNPACK_BUFFER_BINDING, 1},
    {"viewport", GL_VIEWPORT, 4},
    {"scissor box", GL_SCISSOR_BOX, 4},
    {"depth function", GL_DEPTH_FUNC, 1},
    {"depth mask", GL_DEPTH_WRITEMASK, 1},
    {"cull face", GL_CULL_FACE_MODE, 1},
    {"front face", GL_FRONT_FACE, 1},
    {"stencil mask", GL_STENCIL_WRITEMASK, 1},
    {"stencil back mask", GL_STENCIL_BACK_WRITEMASK, 1},
    {"stencil function", GL_STENCIL_FUNC, 1},
    {"stencil reference", GL_STENCIL_REF, 1},
    {"stencil fail", GL_STENCIL_FAIL, 1},
    {"stencil depth fail", GL_STENCIL_PASS_DEPTH_FAIL, 1},
    {"stencil depth pass", GL_STENCIL_PASS_DEPTH_PASS, 1},
    {"stencil clear", GL_STENCIL_CLEAR_VALUE, 1},
    {"active texture", GL_ACTIVE_TEXTURE, 1},
    {"unpack alignment", GL_UNPACK_ALIGNMENT, 1},
    {"unpack row length", GL_UNPACK_ROW_LENGTH, 1},
    {"pack alignment", GL_PACK_ALIGNMENT, 1},
};

static void take_blend(snapshot *s, GLuint buffer) {
    static const GLenum what[] = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                  GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
    GLboolean mask[4];
    for (int i = 0; i < 6; ++i) {
        GLint v;
        if (version >= (is_es ? 320 : 400))
            glGetIntegeri_v(what[i], buffer, &v);
        else
            glGetIntegerv(what[i], &v);
        take(s, "blend of a draw buffer", v);
    }
    take(s, "blend switch of a draw buffer", glIsEnabledi(GL_BLEND, buffer));
    glGetBooleani_v(GL_COLOR_WRITEMASK, buffer, mask);
    for (int i = 0; i < 4; ++i)
        take(s, "colour mask of a draw buffer", mask[i]);
}

static void take_units(snapshot *s) {
    GLint active;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint unit = 0; unit < 16; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        take_integers(s, "texture of a unit", GL_TEXTURE_BINDING_2D, 1);
        take_integers(s, "array texture of a unit", GL_TEXTURE_BINDING_2D_ARRAY, 1);
        take_integers(s, "sampler of a unit", GL_SAMPLER_BINDING, 1);
    }
    glActiveTexture((GLenum)active);
    for (GLuint i = 0; i < 20; ++i) {
        GLint buffer;
        GLint64 start, size;
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, i, &buffer);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_START, i, &start);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, i, &size);
        take(s, "indexed uniform buffer", buffer);
        take(s, "its start", (double)start);
        take(s, "its size", (double)size);
    }
}

/* GL 4.1: sixteen viewports, of which a frame needs the first. */
static void take_viewports(snapshot *s) {
    for (GLuint i = 0; i < 3; ++i) {
        GLfloat viewport[4];
        GLdouble range[2];
        glGetFloati_v(GL_VIEWPORT, i, viewport);
        glGetDoublei_v(GL_DEPTH_RANGE, i, range);
        take(s, "scissor test of a viewport", glIsEnabledi(GL_SCISSOR_TEST, i));
        for (int k = 0; k < 4; ++k)
            take(s, "viewport by index", (double)viewport[k]);
        take(s, "depth range by index", range[0]);
        take(s, "depth range by index", range[1]);
    }
}

static snapshot take_snapshot(void) {
    snapshot s = {{0}, {0}, 0};
    for (size_t i = 0; i < sizeof integers / sizeof integers[0]; ++i)
        take_integers(&s, integers[i].name, integers[i].what, integers[i].count);
    for (size_t i = 0; i < sizeof switches / sizeof switches[0]; ++i)
        take(&s, "a switch", glIsEnabled(switches[i]));
    take_floats(&s, "depth range", GL_DEPTH_RANGE, 2);
    take_floats(&s, "clear colour", GL_COLOR_CLEAR_VALUE, 4);
    take_floats(&s, "clear depth", GL_DEPTH_CLEAR_VALUE, 1);
    take_floats(&s, "blend colour", GL_BLEND_COLOR, 4);
    take_floats(&s, "polygon offset factor", GL_POLYGON_OFFSET_FACTOR, 1);
    take_floats(&s, "line width", GL_LINE_WIDTH, 1);
    take_units(&s);
    if (!is_es) {
        for (size_t i = 0; i < sizeof desktop_switches / sizeof desktop_switches[0]; ++i)
            take(&s, "a desktop switch", glIsEnabled(desktop_switches[i]));
        take_integers(&s, "polygon mode", GL_POLYGON_MODE, 1);
        take_integers(&s, "logic op", GL_LOGIC_OP_MODE, 1);
        if (version >= 410)
            take_viewports(&s);
    }
    if (!is_es || version >= 320)
        for (GLuint buffer = 0; buffer < 8; ++buffer)
            take_blend(&s, buffer);
    return s;
}

static void compare_snapshots(const snapshot *before, const snapshot *after) {
    assert_int_equal(before->count, after->count);
    for (int i = 0; i < before->count; ++i)
        if (before->values[i] != after->values[i])
            fail_msg("%s: was %g, is %g", before->names[i], before->values[i], after->values[i]);
}

/* ---- hostile state ---- */

static uint32_t seed;

static uint32_t draw_number(uint32_t below) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 9) % below;
}

static void flip(GLenum what) {
    if (draw_number(2))
        glEnable(what);
    else
        glDisable(what);
}

typedef struct hostile_names {
    GLuint textures[16], arrays_of_textures[2], samplers[16], buffers[8], arrays[2], framebuffers[3], program;
} hostile_names;

static GLuint make_program(const char *fragment_text) {
    const char *es = "#version 300 es\nprecision highp float;\n", *desktop = "#version 330 core\n";
    const char *vertex[2] = {is_es ? es : desktop, "void main() { gl_Position = vec4(0.0); }\n"};
    const char *fragment[2] = {vertex[0], fragment_text};
    GLuint program = glCreateProgram(),
           shaders[2] = {glCreateShader(GL_VERTEX_SHADER), glCreateShader(GL_FRAGMENT_SHADER)};
    glShaderSource(shaders[0], 2, vertex, NULL);
    glShaderSource(shaders[1], 2, fragment, NULL);
    for (int i = 0; i < 2; ++i) {
        glCompileShader(shaders[i]);
        glAttachShader(program, shaders[i]);
        glDeleteShader(shaders[i]);
    }
    glLinkProgram(program);
    return program;
}

static void make_names(hostile_names *n) {
    glGenTextures(16, n->textures);
    glGenTextures(2, n->arrays_of_textures);
    glGenSamplers(16, n->samplers);
    glGenBuffers(8, n->buffers);
    glGenVertexArrays(2, n->arrays);
    glGenFramebuffers(3, n->framebuffers); /* the last stays incomplete */
    for (int i = 0; i < 8; ++i) {
        glBindBuffer(GL_COPY_READ_BUFFER, n->buffers[i]);
        glBufferData(GL_COPY_READ_BUFFER, 4096, NULL, GL_STATIC_DRAW);
    }
    for (int i = 0; i < 16; ++i) {
        glBindTexture(GL_TEXTURE_2D, n->textures[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    }
    for (int i = 0; i < 2; ++i) {
        glBindFramebuffer(GL_FRAMEBUFFER, n->framebuffers[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, n->textures[i], 0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, n->framebuffers[2]);
    n->program = make_program("out vec4 c; void main() { c = vec4(1.0); }\n");
}

static void drop_names(hostile_names *n) {
    glUseProgram(0);
    glDeleteTextures(16, n->textures);
    glDeleteTextures(2, n->arrays_of_textures);
    glDeleteSamplers(16, n->samplers);
    glDeleteBuffers(8, n->buffers);
    glDeleteVertexArrays(2, n->arrays);
    glDeleteFramebuffers(3, n->framebuffers);
    glDeleteProgram(n->program);
}

static void hostile_bindings(const hostile_names *n) {
    static const GLenum buffers[] = {GL_ARRAY_BUFFER,      GL_UNIFORM_BUFFER,    GL_COPY_READ_BUFFER,
                                     GL_COPY_WRITE_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER};
    for (GLuint unit = 0; unit < 16; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, draw_number(3) ? n->textures[draw_number(16)] : 0);
        glBindTexture(GL_TEXTURE_2D_ARRAY, draw_number(3) ? n->arrays_of_textures[draw_number(2)] : 0);
        glBindSampler(unit, draw_number(2) ? n->samplers[draw_number(16)] : 0);
    }
    for (GLuint i = 0; i < 20; ++i) {
        GLuint name = n->buffers[draw_number(8)];
        if (draw_number(2))
            glBindBufferRange(GL_UNIFORM_BUFFER, i, name, 256 * (GLintptr)draw_number(4),
                              256 + (GLsizeiptr)draw_number(9));
        else
            glBindBufferBase(GL_UNIFORM_BUFFER, i, draw_number(2) ? name : 0);
    }
    for (size_t i = 0; i < sizeof buffers / sizeof buffers[0]; ++i)
        glBindBuffer(buffers[i], draw_number(2) ? n->buffers[draw_number(8)] : 0);
    glActiveTexture(GL_TEXTURE0 + draw_number(16));
    glBindVertexArray(draw_number(2) ? n->arrays[draw_number(2)] : 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw_number(2) ? n->framebuffers[draw_number(2)] : 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, draw_number(2) ? n->framebuffers[draw_number(2)] : 0);
    glUseProgram(draw_number(2) ? n->program : 0);
}

static void hostile_blend(void) {
    static const GLenum factors[] = {GL_ZERO, GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA};
    static const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_MIN, GL_MAX};
    for (GLuint b = 0; b < 8; ++b) {
        GLboolean m[4];
        GLenum f[4];
        for (int i = 0; i < 4; ++i) {
            m[i] = (GLboolean)draw_number(2);
            f[i] = factors[draw_number(5)];
        }
        if (is_es && version < 320) {
            glColorMask(m[0], m[1], m[2], m[3]);
            glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
            glBlendEquationSeparate(equations[draw_number(4)], equations[draw_number(4)]);
            continue;
        }
        glColorMaski(b, m[0], m[1], m[2], m[3]);
        if (version >= (is_es ? 320 : 400)) {
            glBlendFuncSeparatei(b, f[0], f[1], f[2], f[3]);
            glBlendEquationSeparatei(b, equations[draw_number(4)], equations[draw_number(4)]);
        } else {
            glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
            glBlendEquationSeparate(equations[draw_number(4)], equations[draw_number(4)]);
        }
        if (draw_number(2))
            glEnablei(GL_BLEND, b);
        else
            glDisablei(GL_BLEND, b);
    }
}

static void hostile_viewports(void) {
    for (GLuint i = 0; i < 3; ++i) {
        glViewportIndexedf(i, 1.25f + (float)i, 2.5f, 30.5f, 20.0f + (float)draw_number(9));
        glDepthRangeIndexed(i, 0.1 * (double)draw_number(5), 0.9);
        if (draw_number(2))
            glEnablei(GL_SCISSOR_TEST, i);
        else
            glDisablei(GL_SCISSOR_TEST, i);
    }
}

static void hostile_state(const hostile_names *n) {
    for (size_t i = 1; i < sizeof switches / sizeof switches[0]; ++i)
        flip(switches[i]);
    if (!is_es) {
        static const GLenum modes[] = {GL_POINT, GL_LINE, GL_FILL};
        for (size_t i = 0; i < sizeof desktop_switches / sizeof desktop_switches[0]; ++i)
            flip(desktop_switches[i]);
        glPolygonMode(GL_FRONT_AND_BACK, modes[draw_number(3)]);
        glLogicOp(GL_XOR);
        glPrimitiveRestartIndex(0xffffffffu);
    }
    hostile_bindings(n);
    hostile_blend();
    glViewport((GLint)draw_number(50), (GLint)draw_number(50), (GLsizei)draw_number(90), (GLsizei)draw_number(90));
    glScissor((GLint)draw_number(50), (GLint)draw_number(50), (GLsizei)draw_number(9), (GLsizei)draw_number(9));
    glDepthMask((GLboolean)draw_number(2));
    glDepthFunc(GL_NEVER + draw_number(8));
    if (is_es)
        glDepthRangef(0.25f * (float)draw_number(4), 0.25f * (float)draw_number(4));
    else
        glDepthRange(0.1 * (double)draw_number(4), 0.1 * (double)draw_number(4));
    if (!is_es && version >= 410)
        hostile_viewports();
    glCullFace(draw_number(2) ? GL_FRONT : GL_BACK);
    glFrontFace(draw_number(2) ? GL_CW : GL_CCW);
    glPolygonOffset(3.0f, 4.0f);
    glSampleCoverage(0.5f, GL_TRUE);
    glStencilMask(draw_number(256));
    glStencilFunc(GL_NEVER + draw_number(8), 3, 255);
    glStencilOp(GL_INVERT, GL_INCR, GL_DECR);
    glClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    if (is_es)
        glClearDepthf(0.5f);
    else
        glClearDepth(0.5);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, (GLint)draw_number(9));
}

/* ---- a small scene: a box around a box ---- */

static const float corners[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
static const uint32_t sides[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

static ref_scene box_scene;
static ref_object box_truths[3];
static harness_object boxes[3];

static void make_boxes(void) {
    static const double sizes[3] = {0.9, 0.4, 0.6};
    memset(&box_scene, 0, sizeof box_scene);
    memset(box_truths, 0, sizeof box_truths);
    memset(boxes, 0, sizeof boxes);
    for (int i = 0; i < 3; ++i) {
        ref_object *o = &box_truths[i];
        for (int k = 0; k < 3; ++k)
            o->model[5 * k] = sizes[i];
        o->model[15] = 1;
        o->model[12] = i == 2 ? 0.5 : 0;
        o->model[14] = i == 2 ? -0.23 : 0;
        o->positions = corners;
        o->indices = sides;
        o->vertex_count = 8;
        o->triangle_count = 12;
        o->id = (uint32_t)(i + 1);
        o->transparent = i != 1;
        o->color[i] = 0.8;
        o->alpha = 0.5;
        o->group = 3;
        boxes[i].truth = *o;
        harness_upload(&boxes[i], NULL);
    }
    const double view[16] = {0.8, 0.2, -0.3, 0, 0, 0.8, 0.3, 0, 0.4, -0.3, 0.8, 0, 0, 0, 0, 1};
    /* The near plane cuts the first box: with depth clamp the picture would be another one. */
    const double projection[16] = {0.7, 0, 0, 0, 0, 0.7, 0, 0, 0, 0, -0.9, 0, 0, 0, 0, 1};
    memcpy(box_scene.view, view, sizeof view);
    memcpy(box_scene.projection, projection, sizeof projection);
    box_scene.width = box_scene.height = 64;
    box_scene.opaque_weight = 0.7;
    box_scene.background_weight = 0.4;
    box_scene.blending = REF_BLEND_OVER;
    box_scene.objects = box_truths;
    box_scene.object_count = 3;
}

static tr_pass run_frame(harness *h, const tr_frame *frame) {
    tr_pass pass = {0};
    assert_int_equal(tr_begin(h->tr, frame), TR_OK);
    while (tr_next_pass(h->tr, &pass))
        for (int i = 0; i < 3; ++i) {
            tr_material material;
            if (pass.lines || !tr_pass_draws(&pass, &boxes[i].object))
                continue;
            harness_material(&box_scene, &boxes[i].truth, &material);
            material.object = tr_object_code(&boxes[i].object, &frame->wishes);
            tr_set_material(h->tr, &pass, &material);
            glBindVertexArray(boxes[i].array);
            glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_INT, NULL);
        }
    assert_int_equal(tr_end(h->tr), TR_OK);
    return pass;
}

static void read_picture(const harness *h, unsigned char *pixels) {
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

static void plain_state(void) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (size_t i = 0; i < sizeof switches / sizeof switches[0]; ++i)
        glDisable(switches[i]);
    for (size_t i = 0; !is_es && i < sizeof desktop_switches / sizeof desktop_switches[0]; ++i)
        glDisable(desktop_switches[i]);
    glColorMask(1, 1, 1, 1);
    glDepthMask(1);
    glStencilMask(255);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

/* ---- tests ---- */

/* Modes in turn: layers of a group, with a second buffer of ours; several layers; every kind of lines, and light. */
static void set_mode(tr_frame *frame, int mode) {
    frame->wishes.lines = mode == 2 ? 15 : TR_LINES_CREASES | TR_LINES_OUTLINES;
    frame->wishes.interior = mode == 1 ? TR_INTERIOR_LAYERS : TR_INTERIOR_IMPLICIT;
    frame->wishes.layers = mode == 1 ? 3 : mode == 2 ? 1 : 0;
    frame->wishes.options = mode == 2 ? TR_WISH_SRGB : 0;
    frame->wishes.supersample = mode == 1 ? 2 : 1;
}

/* Random state before each frame: the same state after it, and the same picture every time. Sizes change, so that
 * frames that create are among them, as are frames that fail and calls in the wrong order. */
static void check_restore(int gl_version, bool es) {
    static const double grey[3] = {0.5, 0.5, 0.5};
    static unsigned char first[3][64 * 64 * 4], picture[64 * 64 * 4];
    static const int other_sizes[3][2] = {{32, 64}, {17, 5}, {64, 0}};
    harness h;
    hostile_names names;
    is_es = es;
    version = gl_version;
    harness_open(&h, gl_version, es, NULL);
    make_boxes();
    make_names(&names);
    harness_target(&h, 64, 64);
    for (int round = 0; round < 60; ++round) {
        tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
        set_mode(&frame, round % 3);
        plain_state();
        harness_clear(&h, grey, 1.0f);
        seed = (uint32_t)round;
        hostile_state(&names);
        if (round % 4 == 3) {
            frame.width = other_sizes[round / 4 % 3][0];
            frame.height = other_sizes[round / 4 % 3][1];
        }
        snapshot before = take_snapshot();
        GLint array;
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &array);
        run_frame(&h, &frame);
        snapshot after = take_snapshot();
        compare_snapshots(&before, &after);
        h.quiet = true;
        assert_int_equal(tr_end(h.tr), TR_WRONG_ORDER);
        frame.framebuffer = names.framebuffers[2];
        frame.width = frame.height = 64;
        assert_int_equal(tr_begin(h.tr, &frame), TR_TARGET_INCOMPLETE);
        snapshot failed = take_snapshot();
        compare_snapshots(&before, &failed);
        h.quiet = false;
        plain_state();
        read_picture(&h, round < 3 ? first[round] : picture);
        if (round >= 3 && round % 4 != 3)
            assert_memory_equal(first[round % 3], picture, sizeof picture);
    }
    for (int i = 0; i < 3; ++i)
        harness_drop_object(&boxes[i]);
    drop_names(&names);
    harness_close(&h);
}

static void test_state_is_restored_gl45(void **state) {
    (void)state;
    check_restore(450, false);
}

/* The newest driver held to 3.3: no blend state by buffer, no viewports by index. */
static void test_state_is_restored_gl33(void **state) {
    (void)state;
    check_restore(330, false);
}

static void test_state_is_restored_es32(void **state) {
    (void)state;
    check_restore(320, true);
}

static void test_state_is_restored_es30(void **state) {
    (void)state;
    check_restore(300, true);
}

/* Creating, asking for strings, preparing a program, releasing, destroying: none of it moves a bit of state. */
static void test_other_calls_leave_state(void **state) {
    harness h;
    hostile_names names;
    int count;
    static float segments[20 * 6];
    (void)state;
    is_es = false;
    version = 450;
    harness_open(&h, 450, false, NULL);
    make_names(&names);
    for (uint32_t round = 0; round < 20; ++round) {
        seed = round;
        hostile_state(&names);
        snapshot before = take_snapshot();
        tr_desc desc = {0};
        desc.get_proc = harness_get_proc;
        tr_context *tr = tr_create(&desc, NULL);
        assert_non_null(tr);
        assert_non_null(tr_glsl(tr, TR_FRAGMENT, TR_RULE_LAYER, &count));
        assert_int_equal(tr_prepare_program(tr, names.program), TR_OK);
        assert_int_equal(tr_prepare_program(tr, 987654), TR_INVALID_ARGUMENT);
        assert_int_equal(tr_set_crossings(tr, segments, round), TR_OK);
        tr_release(tr);
        tr_destroy(tr);
        snapshot after = take_snapshot();
        compare_snapshots(&before, &after);
    }
    plain_state();
    drop_names(&names);
    harness_close(&h);
}

/* LEAVE_DEFAULTS: that part of the state that a frame changes is a fresh context's, whatever it was. */
static void test_defaults_are_left(void **state) {
    harness h;
    hostile_names names;
    tr_desc desc = {0};
    (void)state;
    is_es = false;
    version = 450;
    desc.state = TR_STATE_LEAVE_DEFAULTS;
    harness_open(&h, 450, false, &desc);
    make_boxes();
    make_names(&names);
    harness_target(&h, 64, 64);
    seed = 77;
    hostile_state(&names);
    tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
    GLfloat before[4], after[4];
    glGetFloati_v(GL_VIEWPORT, 0, before);
    run_frame(&h, &frame);
    glGetFloati_v(GL_VIEWPORT, 0, after);
    assert_memory_equal(before, after, sizeof before);
    static const GLenum off[] = {GL_CULL_FACE,    GL_DEPTH_TEST,     GL_SCISSOR_TEST,
                                 GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_DEPTH_CLAMP};
    for (size_t i = 0; i < sizeof off / sizeof off[0]; ++i)
        assert_false(glIsEnabled(off[i]));
    assert_true(glIsEnabled(GL_DITHER));
    snapshot s = {{0}, {0}, 0};
    take_integers(&s, "program", GL_CURRENT_PROGRAM, 1);
    take_integers(&s, "vertex array", GL_VERTEX_ARRAY_BINDING, 1);
    take_integers(&s, "framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 1);
    for (int i = 0; i < s.count; ++i)
        assert_int_equal((int)s.values[i], 0);
    GLint value;
    glGetIntegerv(GL_DEPTH_FUNC, &value);
    assert_int_equal(value, GL_LESS);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &value);
    assert_int_equal(value, GL_TEXTURE0);
    for (int i = 0; i < 3; ++i)
        harness_drop_object(&boxes[i]);
    plain_state();
    drop_names(&names);
    harness_close(&h);
}

/* Applies a pass's state by hand, from the data alone, on top of anything. */
static void apply_by_hand(const tr_state *state) {
    plain_state();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, state->framebuffer);
    glViewport(state->viewport[0], state->viewport[1], state->viewport[2], state->viewport[3]);
    glDepthRange(0, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    if (state->scissor[2]) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(state->scissor[0], state->scissor[1], state->scissor[2], state->scissor[3]);
    }
    if (state->clear_color)
        glClearBufferfv(GL_COLOR, 0, state->clear_color_value);
    if (state->clear_depth)
        glClearBufferfv(GL_DEPTH, 0, &state->clear_depth_value);
    GLboolean color = (GLboolean)state->color_write;
    glColorMask(color, color, color, color);
    glDepthMask((GLboolean)state->depth_write);
    if (state->depth_test)
        glEnable(GL_DEPTH_TEST);
    glDepthFunc(state->depth_func);
    if (state->blend)
        glEnable(GL_BLEND);
    glBlendFuncSeparate(state->blend_source, state->blend_destination, state->blend_source_alpha,
                        state->blend_destination_alpha);
    glBlendEquation(state->blend_equation ? state->blend_equation : GL_FUNC_ADD);
    if (state->cull_face) {
        glEnable(GL_CULL_FACE);
        glCullFace(state->cull_face);
    }
    glFrontFace(state->front_face);
    glUseProgram(state->program);
    for (int i = 0; i < TR_TEXTURE_UNITS; ++i) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)(state->first_texture_unit + i));
        glBindTexture(state->texture_targets[i], state->textures[i]);
        glBindSampler((GLuint)(state->first_texture_unit + i), 0);
    }
    glBindBufferRange(GL_UNIFORM_BUFFER, (GLuint)state->uniform_binding, state->uniform_buffer, state->uniform_offset,
                      state->uniform_size);
    if (state->vertex_count) {
        glBindVertexArray(state->vertex_array);
        glDrawArrays(GL_TRIANGLES, 0, state->vertex_count);
    }
}

static void draw_from_data(harness *h, const tr_frame *frame) {
    tr_pass pass;
    assert_int_equal(tr_begin(h->tr, frame), TR_OK);
    while (tr_next_pass(h->tr, &pass)) {
        apply_by_hand(&pass.state);
        for (int i = 0; i < 3 && !pass.state.vertex_count; ++i) {
            tr_material material;
            if (!tr_pass_draws(&pass, &boxes[i].object))
                continue;
            harness_material(&box_scene, &boxes[i].truth, &material);
            material.object = tr_object_code(&boxes[i].object, &frame->wishes);
            tr_set_material(h->tr, &pass, &material);
            glBindVertexArray(boxes[i].array);
            glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_INT, NULL);
        }
    }
    assert_int_equal(tr_end(h->tr), TR_OK);
}

/* Opaque things in textures: what they show does not matter, as long as some of it is hidden. */
static void give_textures(tr_frame *frame, GLuint textures[2]) {
    static unsigned char colors[64 * 64][4];
    static float depths[64 * 64];
    for (int i = 0; i < 64 * 64; ++i) {
        colors[i][0] = (unsigned char)i;
        depths[i] = (float)(i % 11) / 10;
    }
    glGenTextures(2, textures);
    for (int i = 0; i < 2; ++i) {
        glBindTexture(GL_TEXTURE_2D, textures[i]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, i ? GL_DEPTH_COMPONENT32F : GL_RGBA8, 64, 64, 0,
                     i ? GL_DEPTH_COMPONENT : GL_RGBA, i ? GL_FLOAT : GL_UNSIGNED_BYTE,
                     i ? (const void *)depths : (const void *)colors);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    frame->opaque_color = textures[0];
    frame->opaque_depth = textures[1];
}

/* All four policies give the very same picture; with STATE_NONE the host applies what the passes carry. */
static void check_policies(bool given) {
    static const double grey[3] = {0.5, 0.5, 0.5};
    static unsigned char pictures[4][64 * 64 * 4];
    is_es = false;
    version = 450;
    for (int policy = 0; policy < 4; ++policy) {
        harness h;
        tr_desc desc = {0};
        desc.state = (tr_state_policy)policy;
        harness_open(&h, 450, false, &desc);
        make_boxes();
        harness_target(&h, 64, 64);
        harness_clear(&h, grey, 1.0f);
        tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
        GLuint textures[2] = {0, 0};
        if (given)
            give_textures(&frame, textures);
        if (policy == TR_STATE_NONE) {
            draw_from_data(&h, &frame);
        } else {
            snapshot before = take_snapshot();
            run_frame(&h, &frame);
            snapshot after = take_snapshot();
            if (policy == TR_STATE_RESTORE)
                compare_snapshots(&before, &after);
        }
        plain_state();
        glDeleteTextures(2, textures);
        read_picture(&h, pictures[policy]);
        assert_memory_equal(pictures[0], pictures[policy], sizeof pictures[0]);
        for (int i = 0; i < 3; ++i)
            harness_drop_object(&boxes[i]);
        harness_close(&h);
    }
}

static void test_policies_draw_the_same(void **state) {
    (void)state;
    check_policies(false);
    check_policies(true);
}

/* A host that applies state itself leaves the last frame's textures bound, and a frame of another size deletes them:
 * nothing that is gone is bound again when state is put back. */
static void test_deleted_names_stay_unbound(void **state) {
    harness h;
    tr_desc desc = {0};
    (void)state;
    is_es = false;
    version = 450;
    desc.state = TR_STATE_NONE;
    harness_open(&h, 450, false, &desc);
    make_boxes();
    harness_target(&h, 64, 64);
    tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
    for (int i = 0; i < 3; ++i) {
        frame.width = 64 - i;
        draw_from_data(&h, &frame);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    plain_state();
    for (int i = 0; i < 3; ++i)
        harness_drop_object(&boxes[i]);
    harness_close(&h);
}

/* Of a multisampled target the state is left as found too. */
static void test_multisampled_target_leaves_state(void **state) {
    harness h;
    GLuint framebuffer, renderbuffer;
    (void)state;
    is_es = false;
    version = 450;
    harness_open(&h, 450, false, NULL);
    make_boxes();
    harness_target(&h, 64, 64);
    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 64, 64);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
    frame.framebuffer = framebuffer;
    snapshot before = take_snapshot();
    run_frame(&h, &frame);
    snapshot after = take_snapshot();
    compare_snapshots(&before, &after);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &renderbuffer);
    for (int i = 0; i < 3; ++i)
        harness_drop_object(&boxes[i]);
    harness_close(&h);
}

/* ---- dynamic transparency ---- */

static const double DARK[3] = {0.25, 0.5, 0.75};

/* The second box is a target within the first, the third is impenetrable and cuts both. */
static tr_dynamic dynamic_wish(tr_see see, tr_unit units[3]) {
    tr_dynamic d;
    memset(&d, 0, sizeof d);
    memset(units, 0, 3 * sizeof *units);
    for (int i = 0; i < 3; ++i) {
        const double *m = box_truths[i].model;
        units[i].id = (uint32_t)i + 1;
        for (int k = 0; k < 3; ++k)
            units[i].center[k] = (float)m[12 + k];
        units[i].radius = 1.8f * (float)m[0];
    }
    units[1].flags = TR_UNIT_TARGET;
    units[2].flags = TR_UNIT_IMPENETRABLE;
    units[0].importance = 0.25f;
    /* Of whole objects the outer one is to be painted last. */
    units[0].group = units[1].group = 1;
    units[0].rank = 1;
    for (int k = 0; k < 16; ++k) {
        d.view[k] = (float)box_scene.view[k];
        d.projection[k] = (float)box_scene.projection[k];
    }
    d.see = see;
    d.units = units;
    d.unit_count = 3;
    d.query = see <= TR_SEE_DITHER;
    return d;
}

static void draw_units(harness *h, const tr_pass *pass, const tr_unit *units) {
    for (size_t i = 0; i < pass->unit_count; ++i) {
        tr_material material;
        uint32_t unit = pass->units[i];
        harness_material(&box_scene, &boxes[unit].truth, &material);
        material.object = tr_unit_code(&units[unit]);
        tr_set_material(h->tr, pass, &material);
        glBindVertexArray(boxes[unit].array);
        glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_INT, NULL);
    }
}

/* The scene as a host has drawn it before, so that hostile state need not be left for it. Sequences paint the outer box
 * themselves. */
static void draw_scene_alone(harness *h, tr_frame frame, tr_see see) {
    tr_unit units[3];
    tr_dynamic d = dynamic_wish(TR_SEE_OFF, units);
    tr_pass pass;
    plain_state();
    harness_clear(h, DARK, 1.0f);
    glViewport(0, 0, 64, 64);
    glDepthFunc(GL_LESS);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDepthRangef(0, 1);
    if (!is_es)
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    frame.width = frame.height = 64;
    assert_int_equal(tr_begin_dynamic(h->tr, &frame, &d), TR_OK);
    while (tr_next_pass(h->tr, &pass)) {
        bool painted = see == TR_SEE_SEQUENCE || see == TR_SEE_PUBLISHED;
        pass.units += painted;
        pass.unit_count -= painted;
        draw_units(h, &pass, units);
    }
    assert_int_equal(tr_end(h->tr), TR_OK);
    glBindVertexArray(0);
}

static void run_dynamic(harness *h, const tr_frame *frame, tr_see see, bool in_parts) {
    tr_unit units[3];
    tr_dynamic d = dynamic_wish(see, units);
    tr_pass pass;
    tr_hidden hidden[4];
    size_t count;
    d.in_parts = in_parts;
    assert_int_equal(tr_begin_dynamic(h->tr, frame, &d), TR_OK);
    assert_int_equal(tr_get_info(h->tr).see_plan->see, frame->height ? see : TR_SEE_OFF);
    while (tr_next_pass(h->tr, &pass))
        if (pass.kind != TR_PASS_SCENE)
            draw_units(h, &pass, units);
    assert_int_equal(tr_end(h->tr), TR_OK);
    assert_int_equal(tr_query_hidden(h->tr, hidden, 4, &count), TR_OK);
}

/* As check_restore, of every rung; sizes change, and rungs from frame to frame. */
static void check_dynamic_restore(int gl_version, bool es) {
    static unsigned char first[5][64 * 64 * 4], plain[64 * 64 * 4], picture[64 * 64 * 4];
    static const int other_sizes[3][2] = {{32, 64}, {17, 5}, {64, 0}};
    harness h;
    hostile_names names;
    is_es = es;
    version = gl_version;
    harness_open(&h, gl_version, es, NULL);
    make_boxes();
    make_names(&names);
    harness_target(&h, 64, 64);
    for (int round = 0; round < 60; ++round) {
        tr_see see = (tr_see)(round % 5);
        tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
        draw_scene_alone(&h, frame, see);
        read_picture(&h, plain);
        seed = (uint32_t)round;
        hostile_state(&names);
        bool other = round >= 5 && round % 4 == 3;
        if (other) {
            frame.width = other_sizes[round / 4 % 3][0];
            frame.height = other_sizes[round / 4 % 3][1];
        }
        snapshot before = take_snapshot();
        run_dynamic(&h, &frame, see, other); /* other pictures, of which the state alone is looked at */
        snapshot after = take_snapshot();
        compare_snapshots(&before, &after);
        h.quiet = true;
        tr_unit units[3];
        tr_dynamic wish = dynamic_wish(see, units);
        frame.framebuffer = names.framebuffers[2];
        frame.width = frame.height = 64;
        assert_int_equal(tr_begin_dynamic(h.tr, &frame, &wish), TR_TARGET_INCOMPLETE);
        wish.mask_divisor = 3;
        assert_int_equal(tr_begin_dynamic(h.tr, &frame, &wish), TR_INVALID_ARGUMENT);
        snapshot failed = take_snapshot();
        compare_snapshots(&before, &failed);
        h.quiet = false;
        plain_state();
        read_picture(&h, round < 5 ? first[round] : picture);
        if (round < 5 && see != TR_SEE_DITHER)
            assert_memory_not_equal(plain, first[round], sizeof plain);
        if (round >= 5 && !other)
            assert_memory_equal(first[see], picture, sizeof picture);
    }
    for (int i = 0; i < 3; ++i)
        harness_drop_object(&boxes[i]);
    drop_names(&names);
    harness_close(&h);
}

static void test_dynamic_state_is_restored(void **state) {
    (void)state;
    check_dynamic_restore(450, false);
    check_dynamic_restore(330, false);
    check_dynamic_restore(320, true);
    check_dynamic_restore(300, true);
}

static void draw_dynamic_from_data(harness *h, const tr_frame *frame, tr_see see) {
    tr_unit units[3];
    tr_dynamic d = dynamic_wish(see, units);
    tr_pass pass;
    assert_int_equal(tr_begin_dynamic(h->tr, frame, &d), TR_OK);
    while (tr_next_pass(h->tr, &pass)) {
        apply_by_hand(&pass.state);
        draw_units(h, &pass, units);
    }
    assert_int_equal(tr_end(h->tr), TR_OK);
}

/* The scene is the host's to draw; with LEAVE_DIRTY and LEAVE_DEFAULTS it sets all that it needs. */
static void draw_dynamic(harness *h, const tr_frame *frame, tr_see see) {
    tr_unit units[3];
    tr_dynamic d = dynamic_wish(see, units);
    tr_pass pass;
    assert_int_equal(tr_begin_dynamic(h->tr, frame, &d), TR_OK);
    while (tr_next_pass(h->tr, &pass)) {
        if (pass.kind == TR_PASS_SCENE) {
            glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
            glViewport(0, 0, 64, 64);
            glEnable(GL_DEPTH_TEST);
            glEnable(GL_CULL_FACE);
            glDisable(GL_BLEND);
            glDisable(GL_SCISSOR_TEST);
            glDepthFunc(GL_LESS);
            glDepthMask(1);
            glColorMask(1, 1, 1, 1);
        }
        draw_units(h, &pass, units);
    }
    assert_int_equal(tr_end(h->tr), TR_OK);
}

/* All four policies, every rung, two frames each: the very same picture. */
static void test_dynamic_policies_draw_the_same(void **state) {
    static unsigned char pictures[4][64 * 64 * 4], plain[64 * 64 * 4];
    (void)state;
    is_es = false;
    version = 450;
    for (int see = TR_SEE_OFF; see >= TR_SEE_ONE_MASK; --see)
        for (int policy = 0; policy < 4; ++policy) {
            harness h;
            tr_desc desc = {0};
            desc.state = (tr_state_policy)policy;
            harness_open(&h, 450, false, &desc);
            make_boxes();
            harness_target(&h, 64, 64);
            tr_frame frame = harness_frame(&h, &box_scene, boxes, 3);
            for (int i = 0; i < 2; ++i) {
                plain_state();
                harness_clear(&h, DARK, 1.0f);
                if (policy == TR_STATE_NONE)
                    draw_dynamic_from_data(&h, &frame, (tr_see)see);
                else
                    draw_dynamic(&h, &frame, (tr_see)see);
                assert_int_equal(glGetError(), GL_NO_ERROR);
            }
            plain_state();
            read_picture(&h, pictures[policy]);
            assert_memory_equal(pictures[0], pictures[policy], sizeof pictures[0]);
            if (see == TR_SEE_OFF)
                memcpy(plain, pictures[0], sizeof plain);
            else
                assert_memory_not_equal(pictures[0], plain, sizeof plain);
            for (int i = 0; i < 3; ++i)
                harness_drop_object(&boxes[i]);
            harness_close(&h);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_state_is_restored_gl45),         cmocka_unit_test(test_state_is_restored_gl33),
        cmocka_unit_test(test_state_is_restored_es32),         cmocka_unit_test(test_state_is_restored_es30),
        cmocka_unit_test(test_other_calls_leave_state),        cmocka_unit_test(test_defaults_are_left),
        cmocka_unit_test(test_policies_draw_the_same),         cmocka_unit_test(test_multisampled_target_leaves_state),
        cmocka_unit_test(test_deleted_names_stay_unbound),     cmocka_unit_test(test_dynamic_state_is_restored),
        cmocka_unit_test(test_dynamic_policies_draw_the_same),
    };
    return cmocka_run_group_tests_name("gl_state", tests, NULL, NULL);
}
