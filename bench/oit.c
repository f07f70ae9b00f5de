/* oit: what exact order-independent transparency costs: the stores of oit_buffers.h beside unsorted blending, depth
 * peeling, dual depth peeling and weighted blending of the same fragments.
 *
 * usage: oit [FILE.csv]       BENCH=quick: fewer frames and one size
 * BENCH_SCENES=FOLDER writes the scenes there, and what they should look like, for bench/vtk_transparency.py.
 *
 * Milliseconds are medians of whole frames by the wall clock around glFinish, the subjects of a scene in turn, so that
 * what else the machine does falls on all. error_max is in 1/255 against the reference in double precision, pixels near
 * edges left out. */
#include "../tests/oit_models.h"
#include "bench.h"
#include "load_model.h"

enum { MAX_FRAMES = 31 };

typedef struct stage {
    headless context;
    oit_scene scene;
    GLuint framebuffer, color, depth;
    GLuint programs[4], textures[8], framebuffers[4], query, array; /* of the peers */
    int size, dual_passes; /* half of the layers of the deepest pixel, and one */
} stage;

static void make_target(stage *s, int size) {
    s->size = size;
    glDeleteFramebuffers(1, &s->framebuffer);
    glDeleteTextures(1, &s->color);
    glDeleteTextures(1, &s->depth);
    glGenTextures(1, &s->color);
    glBindTexture(GL_TEXTURE_2D, s->color);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size, size);
    glGenTextures(1, &s->depth);
    glBindTexture(GL_TEXTURE_2D, s->depth);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, size, size);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &s->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, s->depth, 0);
}

static void clear(const stage *s) {
    const float white[4] = {1, 1, 1, 1}, far = 1;
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glViewport(0, 0, s->size, s->size);
    glClearBufferfv(GL_COLOR, 0, white);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &far);
}

/* ---- subjects ---- */

typedef struct subject {
    const char *name;
    void (*draw)(stage *s, struct subject *self);
    oit_desc desc;
    oit_context *oit;
    uint64_t bytes;
} subject;

static void draw_blend(stage *s, subject *self) {
    (void)self;
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    oit_scene_draw_plain(&s->scene, false, true);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
}

/* ---- peers: plain versions of what is known, with the shading of draw_blend ---- */

enum { PEEL, DUAL, WEIGHTED, FULL_SCREEN };

static GLuint peer_program(const char *fragment) {
    return oit_scene_program(false,
                             "layout(location = 0) in vec3 position;\nuniform mat4 matrix;\ninvariant gl_Position;\n"
                             "void main() { gl_Position = matrix * vec4(position, 1.0); }\n",
                             fragment);
}

static const char *const full_screen =
    "void main() { gl_Position = vec4(vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2)) * 2.0 - 1.0, 0, 1); }\n";

static GLuint texture(GLenum format, int size) {
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, size, size);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return name;
}

static void attach(GLuint framebuffer, GLenum where, GLuint name) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, name, 0);
}

static void make_peers(stage *s) {
    static const GLenum two[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    static const GLenum three[3] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    const GLenum formats[8] = {GL_DEPTH_COMPONENT32F,
                               GL_DEPTH_COMPONENT32F,
                               GL_RGBA16F,
                               GL_RG32F,
                               GL_RG32F,
                               GL_RGBA16F,
                               GL_RGBA16F,
                               GL_RGBA16F};
    if (!s->query) {
        s->programs[PEEL] = peer_program("uniform vec4 color;\nuniform sampler2D nearer;\nout vec4 result;\n"
                                         "void main() {\n"
                                         "    float last = texelFetch(nearer, ivec2(gl_FragCoord.xy), 0).r;\n"
                                         "    if (gl_FragCoord.z <= last) discard;\n"
                                         "    result = vec4(color.rgb * color.a, color.a);\n}\n");
        s->programs[DUAL] = peer_program(
            "uniform vec4 color;\nlayout(binding = 0) uniform sampler2D range;\nlayout(binding = 1) uniform sampler2D front;\n"
            "layout(location = 0) out vec2 next;\nlayout(location = 1) out vec4 nearest;\n"
            "layout(location = 2) out vec4 farthest;\nvoid main() {\n"
            "    ivec2 at = ivec2(gl_FragCoord.xy);\n    vec2 known = texelFetch(range, at, 0).xy;\n"
            "    float z = gl_FragCoord.z, low = -known.x, high = known.y;\n"
            "    next = vec2(-1.0);\n    nearest = texelFetch(front, at, 0);\n    farthest = vec4(0.0);\n"
            "    if (z < low || z > high) return;\n"
            "    if (z > low && z < high) { next = vec2(-z, z); return; }\n"
            "    if (z == low) nearest += (1.0 - nearest.a) * vec4(color.rgb * color.a, color.a);\n"
            "    else farthest = vec4(color.rgb * color.a, color.a);\n}\n");
        s->programs[WEIGHTED] = peer_program(
            "uniform vec4 color;\nlayout(location = 0) out vec4 sum;\nlayout(location = 1) out vec4 through;\n"
            "void main() {\n    float z = 1.0 - gl_FragCoord.z;\n"
            "    float w = color.a * clamp(10.0 / (1e-5 + pow(10.0 * (1.0 - z), 3.0)), 1e-2, 3e3);\n"
            "    sum = vec4(color.rgb * color.a, color.a) * w;\n    through = vec4(color.a);\n}\n");
        s->programs[FULL_SCREEN] = oit_scene_program(
            false, full_screen,
            "layout(binding = 0) uniform sampler2D first;\nlayout(binding = 1) uniform sampler2D second;\n"
            "uniform int kind;\nout vec4 result;\nvoid main() {\n    ivec2 at = ivec2(gl_FragCoord.xy);\n"
            "    vec4 a = texelFetch(first, at, 0), b = texelFetch(second, at, 0);\n"
            "    if (kind == 0) result = vec4(a.rgb, 1.0 - a.a);\n"
            "    else if (kind == 1) result = vec4(a.rgb + (1.0 - a.a) * b.rgb, (1.0 - a.a) * (1.0 - b.a));\n"
            "    else result = vec4(a.rgb / max(a.a, 1e-5) * (1.0 - b.r), b.r);\n}\n");
        glGenQueries(1, &s->query);
        glGenVertexArrays(1, &s->array);
    }
    glDeleteTextures(8, s->textures);
    glDeleteFramebuffers(4, s->framebuffers);
    for (int i = 0; i < 8; ++i)
        s->textures[i] = texture(formats[i], s->size);
    glGenFramebuffers(4, s->framebuffers);
    for (int i = 0; i < 2; ++i) { /* peeling: depth alone changes */
        attach(s->framebuffers[i], GL_DEPTH_ATTACHMENT, s->textures[i]);
        attach(s->framebuffers[i], GL_COLOR_ATTACHMENT0, s->textures[2]);
    }
    attach(s->framebuffers[3], GL_COLOR_ATTACHMENT0, s->textures[5]);
    attach(s->framebuffers[3], GL_COLOR_ATTACHMENT1, s->textures[6]);
    glDrawBuffers(2, two);
    attach(s->framebuffers[2], GL_COLOR_ATTACHMENT2, s->textures[7]);
    glDrawBuffers(3, three);
}

/* The transparent objects by one of the peers' programs. */
static void draw_objects(const stage *s, int program) {
    glUseProgram(s->programs[program]);
    GLint matrix = glGetUniformLocation(s->programs[program], "matrix");
    GLint color = glGetUniformLocation(s->programs[program], "color");
    for (size_t i = 0; i < s->scene.count; ++i) {
        const ref_object *t = &s->scene.truths[i];
        float m[16];
        oit_scene_matrix(&s->scene, i, m);
        glUniformMatrix4fv(matrix, 1, GL_FALSE, m);
        glUniform4f(color, (float)t->color[0], (float)t->color[1], (float)t->color[2], (float)t->alpha);
        oit_scene_elements(&s->scene, i);
    }
}

static void bind_texture(GLuint unit, GLuint name) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name);
}

static void finish_on_target(const stage *s, int kind, GLuint first, GLuint second) {
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    glUseProgram(s->programs[FULL_SCREEN]);
    glUniform1i(glGetUniformLocation(s->programs[FULL_SCREEN], "kind"), kind);
    bind_texture(1, second);
    bind_texture(0, first);
    glBindVertexArray(s->array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

/* Everitt: a layer a pass, front to back, until a pass draws nothing. */
static void draw_peel(stage *s, subject *self) {
    const float none[4] = {0, 0, 0, 0}, far = 1, before = -1;
    GLuint drawn = 1;
    self->bytes = (uint64_t)s->size * (uint64_t)s->size * 16;
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffers[0]);
    glClearBufferfv(GL_COLOR, 0, none);
    glClearBufferfv(GL_DEPTH, 0, &before);
    glEnable(GL_BLEND);
    for (int pass = 1; drawn; ++pass) {
        glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffers[pass % 2]);
        glDepthMask(GL_TRUE);
        glClearBufferfv(GL_DEPTH, 0, &far);
        bind_texture(0, s->textures[(pass + 1) % 2]);
        glEnable(GL_DEPTH_TEST);
        /* The depth of the layer, then its colour under what is there. */
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        draw_objects(s, PEEL);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_EQUAL);
        glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        glBeginQuery(GL_SAMPLES_PASSED, s->query);
        draw_objects(s, PEEL);
        glEndQuery(GL_SAMPLES_PASSED);
        glGetQueryObjectuiv(s->query, GL_QUERY_RESULT, &drawn);
        glDepthFunc(GL_LESS);
    }
    finish_on_target(s, 0, s->textures[2], s->textures[2]);
}

/* Bavoil and Myers 2008: the nearest and the farthest layer a pass, by MAX blending of (-z, z). */
static void draw_dual(stage *s, subject *self) {
    static const GLenum three[3] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    const float none[4] = {0, 0, 0, 0}, start[4] = {0, 1, 0, 0}, least[4] = {-1, -1, 0, 0};
    GLuint drawn = 1, front = 5;
    self->bytes = (uint64_t)s->size * (uint64_t)s->size * 48;
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffers[2]);
    glDisable(GL_DEPTH_TEST);
    attach(s->framebuffers[2], GL_COLOR_ATTACHMENT0, s->textures[3]);
    attach(s->framebuffers[2], GL_COLOR_ATTACHMENT1, s->textures[5]);
    glClearBufferfv(GL_COLOR, 0, start);
    glClearBufferfv(GL_COLOR, 1, none);
    glClearBufferfv(GL_COLOR, 2, none);
    for (int pass = 1; drawn; ++pass, front = 11 - front) {
        GLuint range = s->textures[3 + (pass + 1) % 2];
        attach(s->framebuffers[2], GL_COLOR_ATTACHMENT0, s->textures[3 + pass % 2]);
        attach(s->framebuffers[2], GL_COLOR_ATTACHMENT1, s->textures[11 - front]);
        glDrawBuffers(3, three);
        glClearBufferfv(GL_COLOR, 0, least);
        glClearBufferfv(GL_COLOR, 1, none);
        bind_texture(1, s->textures[front]);
        bind_texture(0, range);
        for (GLuint i = 0; i < 2; ++i) {
            glEnablei(GL_BLEND, i);
            glBlendEquationi(i, GL_MAX);
        }
        glEnablei(GL_BLEND, 2); /* back to front, over */
        glBlendEquationi(2, GL_FUNC_ADD);
        glBlendFunci(2, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        draw_objects(s, DUAL);
        drawn = pass < s->dual_passes;
    }
    for (GLuint i = 0; i < 3; ++i) {
        glDisablei(GL_BLEND, i);
        glBlendEquationi(i, GL_FUNC_ADD);
    }
    finish_on_target(s, 1, s->textures[front], s->textures[7]);
}

/* McGuire and Bavoil 2013, equation 9's kind of weight: not exact. */
static void draw_weighted(stage *s, subject *self) {
    const float none[4] = {0, 0, 0, 0}, one[4] = {1, 1, 1, 1};
    self->bytes = (uint64_t)s->size * (uint64_t)s->size * 16;
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffers[3]);
    glDisable(GL_DEPTH_TEST);
    glClearBufferfv(GL_COLOR, 0, none);
    glClearBufferfv(GL_COLOR, 1, one);
    glEnable(GL_BLEND);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    draw_objects(s, WEIGHTED);
    finish_on_target(s, 2, s->textures[5], s->textures[6]);
}

static void draw_oit(stage *s, subject *self) {
    oit_frame frame = oit_scene_frame(&s->scene, s->framebuffer);
    oit_scene_render(&s->scene, self->oit, &frame, NULL);
    self->bytes = oit_get_info(self->oit).bytes;
}

/* ---- measuring ---- */

/* A scene of the standard camera, or of none, as vtk_transparency.py reads it: without a camera z points away from the
 * eye here and toward it there. Beside it rgb of each pixel and whether it is left out. */
static void write_scene(const oit_scene *s, const char *name, const oit_truth *truth) {
    char path[1024];
    const char *folder = getenv("BENCH_SCENES");
    uint32_t size = (uint32_t)s->scene.width, head[3] = {size, s->scene.projection[11] != 0, (uint32_t)s->count};
    if (!folder)
        return;
    snprintf(path, sizeof path, "%s/%s.scene", folder, name);
    FILE *file = fopen(path, "wb");
    if (!file)
        return;
    fwrite(head, sizeof head, 1, file);
    for (size_t i = 0; i < s->count; ++i) {
        const ref_object *t = &s->truths[i];
        const uint32_t counts[2] = {(uint32_t)t->vertex_count, (uint32_t)t->triangle_count};
        const float color[4] = {(float)t->color[0], (float)t->color[1], (float)t->color[2], (float)t->alpha};
        fwrite(counts, sizeof counts, 1, file);
        fwrite(color, sizeof color, 1, file);
        for (size_t v = 0; v < t->vertex_count; ++v) {
            float p[3] = {t->positions[3 * v], t->positions[3 * v + 1], t->positions[3 * v + 2]};
            p[2] = head[1] ? p[2] : -p[2];
            fwrite(p, sizeof p, 1, file);
        }
        fwrite(t->indices, 3 * sizeof(uint32_t), t->triangle_count, file);
    }
    fclose(file);
    snprintf(path, sizeof path, "%s/%s.truth", folder, name);
    file = truth ? fopen(path, "wb") : NULL;
    for (size_t i = 0; file && i < size * size; ++i) {
        const float out[4] = {(float)truth[i].color[0], (float)truth[i].color[1], (float)truth[i].color[2],
                              (float)truth[i].left_out};
        fwrite(out, sizeof out, 1, file);
    }
    if (file)
        fclose(file);
}

static void measure(stage *s, subject *subjects, size_t count, const char *name, int frames, FILE *csv) {
    static double times[16][MAX_FRAMES];
    size_t pixels = (size_t)s->size * (size_t)s->size;
    unsigned char *picture = need(4 * pixels);
    oit_truth *truth = need(pixels * sizeof *truth);
    double unit = 0;
    bool known = is_quick() || s->size > 600 ? false : (oit_truth_render(&s->scene, truth), true);
    int taken[16] = {0};
    if (s->size <= 600 && !strchr(name, '.'))
        write_scene(&s->scene, name, known ? truth : NULL);
    for (int frame = -1; frame < frames; ++frame)
        for (size_t i = 0; i < count; ++i) {
            /* What takes seconds is noisy by less: of that a few frames are enough. */
            if (taken[i] >= (times[i][0] > 3000 ? 1 : 3) && times[i][0] > 500)
                continue;
            clear(s);
            glFinish();
            double start = now_ms();
            subjects[i].draw(s, &subjects[i]);
            glFinish();
            if (frame >= 0)
                times[i][taken[i]++] = now_ms() - start;
        }
    for (size_t i = 0; i < count; ++i) {
        double error = 0, ms = median(times[i], (size_t)taken[i]);
        clear(s);
        subjects[i].draw(s, &subjects[i]);
        glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
        glReadPixels(0, 0, s->size, s->size, GL_RGBA, GL_UNSIGNED_BYTE, picture);
        for (size_t p = 0; known && p < pixels; ++p)
            for (size_t c = 0; c < 3 && !truth[p].left_out; ++c)
                error = fmax(error, fabs(picture[4 * p + c] - 255 * truth[p].color[c]));
        if (i == 0)
            unit = ms;
        printf("%-18s %5d  %-10s %9.2f ms %7.2fx %11llu bytes", name, s->size, subjects[i].name, ms, ms / unit,
               (unsigned long long)subjects[i].bytes);
        printf(known ? "  error %.2f/255\n" : "\n", error);
        fprintf(csv, "oit,%s,%d,%s,%.3f,%llu,%.3f\n", name, s->size, subjects[i].name, ms,
                (unsigned long long)subjects[i].bytes, known ? error : -1.0);
    }
    free(picture);
    free(truth);
}

/* What the scene is like. Dual peeling is given the number of passes that it needs, which it would have to ask for. */
static oit_report look(stage *s, oit_context *oit) {
    oit_frame frame = oit_scene_frame(&s->scene, s->framebuffer);
    oit_report report = {0};
    clear(s);
    oit_scene_render(&s->scene, oit, &frame, NULL);
    oit_get_report(oit, &report);
    return report;
}

/* Where the time goes: each pass of OIT_STATE_NONE by itself, glFinish after each. */
typedef struct phases {
    double last, sums[OIT_PASS_KIND_COUNT];
} phases;

static void after_pass(const oit_pass *pass, void *user) {
    phases *p = user;
    glFinish();
    double now = now_ms();
    p->sums[pass->kind] += now - p->last;
    p->last = now;
}

static void measure_phases(stage *s, oit_context *oit, int frames) {
    oit_frame frame = oit_scene_frame(&s->scene, s->framebuffer);
    phases p = {0};
    for (int i = -2; i < frames; ++i) {
        clear(s);
        glFinish();
        if (i == 0)
            memset(&p, 0, sizeof p);
        p.last = now_ms();
        oit_scene_render_raw(&s->scene, oit, &frame, after_pass, &p);
    }
    for (int k = 0; k < OIT_PASS_KIND_COUNT; ++k)
        printf("    %-8s %8.2f ms\n", oit_pass_kind_name((oit_pass_kind)k), p.sums[k] / frames);
}

static const struct {
    const char *name; /* with a dot: a file of ../shared/models */
    int sheets, concentric, balls, rings;
} scenes[] = {{"sheets16", 16, 0, 0, 0},      {"sheets32", 32, 0, 0, 0}, {"concentric32", 0, 32, 0, 64},
              {"random16", 0, 0, 16, 127},    {"robot.glb", 0, 0, 0, 0}, {"skull.obj", 0, 0, 0, 0},
              {"chair_model.obj", 0, 0, 0, 0}};

/* Scene number i; false: there are no more. A file that is not there leaves it empty. */
static bool make_scene(oit_scene *s, size_t i, int size) {
    if (i >= sizeof scenes / sizeof scenes[0])
        return false;
    oit_scene_init(s, size, size);
    if (scenes[i].sheets) {
        oit_scene_sheets(s, scenes[i].sheets, 0.2, false);
    } else if (scenes[i].concentric) {
        oit_scene_concentric(s, scenes[i].concentric, scenes[i].rings, 0.1);
    } else if (scenes[i].balls) {
        oit_scene_random_balls(s, scenes[i].balls, scenes[i].rings, 0.4);
    } else {
        char path[1024], message[256];
        const char *folder = getenv("GLASSINE_MODELS");
        load_report report;
        snprintf(path, sizeof path, "%s/%s", folder ? folder : "../shared/models", scenes[i].name);
        scene *model = load_model(path, &report, message, sizeof message);
        if (model)
            oit_scene_of_model(s, model, size);
        scene_destroy(model);
    }
    return true;
}

int main(int argc, char **argv) {
    FILE *csv = open_table(argc, argv, "build/bench/oit.csv");
    static stage s;
    char message[256];
    setvbuf(stdout, NULL, _IOLBF, 0);
    subject subjects[] = {
        {.name = "blend", .draw = draw_blend},
        {.name = "exact", .draw = draw_oit},
        {.name = "exact_async", .draw = draw_oit, .desc = {.fit = OIT_FIT_ASYNC}},
        {.name = "budget",
         .draw = draw_oit,
         .desc = {.store = OIT_STORE_BUDGET, .budget_bytes = 1 << 30, .layers = 32}},
        {.name = "budget_8", .draw = draw_oit, .desc = {.store = OIT_STORE_BUDGET, .layers = 8}},
        {.name = "bucketed",
         .draw = draw_oit,
         .desc = {.store = OIT_STORE_BUCKETED, .fields = OIT_FIELD_PART, .budget_bytes = 1 << 30, .layers = 32}},
        {.name = "bucketed_8",
         .draw = draw_oit,
         .desc = {.store = OIT_STORE_BUCKETED, .fields = OIT_FIELD_PART, .layers = 8, .bucket_depth_bits = 16}},
        {.name = "predict", .draw = draw_oit, .desc = {.store = OIT_STORE_PREDICT}},
        {.name = "predict_async", .draw = draw_oit, .desc = {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC}},
        {.name = "fetch", .draw = draw_oit, .desc = {.store = OIT_STORE_FETCH}},
        {.name = "linked", .draw = draw_oit, .desc = {.store = OIT_STORE_LINKED}},
        {.name = "linked_async", .draw = draw_oit, .desc = {.store = OIT_STORE_LINKED, .fit = OIT_FIT_ASYNC}},
        {.name = "peel", .draw = draw_peel},
        {.name = "dual", .draw = draw_dual},
        {.name = "weighted", .draw = draw_weighted}};
    size_t count = sizeof subjects / sizeof subjects[0];
    if (!headless_create(&s.context, 4, 3, false, message, sizeof message) ||
        !gladLoadGL((GLADloadfunc)eglGetProcAddress)) {
        fprintf(stderr, "oit: %s\n", message);
        return 1;
    }
    printf("driver: %s\n", s.context.renderer);
    for (size_t i = 0; i < count; ++i) {
        subjects[i].desc.get_proc = oit_scene_get_proc;
        if (subjects[i].draw == draw_oit)
            subjects[i].oit = oit_create(&subjects[i].desc, NULL);
    }
    oit_desc raw_desc = {.get_proc = oit_scene_get_proc, .fit = OIT_FIT_ASYNC, .state = OIT_STATE_NONE};
    oit_context *raw = oit_create(&raw_desc, NULL);
    for (int size = 512; size <= (is_quick() ? 512 : 1000); size += 488) {
        make_target(&s, size);
        make_peers(&s);
        for (size_t i = 0; make_scene(&s.scene, i, size); ++i) {
            const char *name = scenes[i].name;
            if (s.scene.count == 0) {
                printf("%s: skipped, no such file\n", name);
                continue;
            }
            oit_report report = look(&s, subjects[1].oit);
            s.dual_passes = (int)report.deepest / 2 + 1;
            printf("%s: %zu triangles, %u fragments, deepest %u\n", name, s.scene.triangles, report.needed,
                   report.deepest);
            measure(&s, subjects, count, name, is_quick() ? 5 : 15, csv);
            measure_phases(&s, raw, 5);
            /* The floor: each record written once and read once; each pixel's two words cleared, counted, summed, spread,
             * taken and read. */
            printf("    floor    %8.1f MB of records, %.1f MB of pixels\n",
                   2e-6 * report.needed * oit_get_info(raw).fragment_bytes, 1e-6 * size * size * 8 * 6);
            oit_scene_drop(&s.scene);
        }
    }
    for (size_t i = 0; i < count; ++i)
        oit_destroy(subjects[i].oit);
    oit_destroy(raw);
    headless_destroy(&s.context);
    return close_table(csv);
}
