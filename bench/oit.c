/* oit: what exact order-independent transparency costs: the stores of oit_buffers.h beside unsorted blending, depth
 * peeling, dual depth peeling and weighted blending of the same fragments.
 *
 * usage: oit [FILE.csv]       BENCH=quick: fewer frames and one size
 *
 * Milliseconds are medians of whole frames by the wall clock around glFinish, the subjects of a scene in turn, so that
 * what else the machine does falls on all. error_max is in 1/255 against the reference in double precision, pixels near
 * edges left out. */
#include "../tests/oit_scene.h"
#include "bench.h"

enum { MAX_FRAMES = 31 };

typedef struct stage {
    headless context;
    oit_scene scene;
    GLuint framebuffer, color, depth;
    int size;
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

static void draw_oit(stage *s, subject *self) {
    oit_frame frame = oit_scene_frame(&s->scene, s->framebuffer);
    oit_scene_render(&s->scene, self->oit, &frame, NULL);
    self->bytes = oit_get_info(self->oit).bytes;
}

/* ---- measuring ---- */

static void measure(stage *s, subject *subjects, size_t count, const char *name, int frames, FILE *csv) {
    static double times[16][MAX_FRAMES];
    size_t pixels = (size_t)s->size * (size_t)s->size;
    unsigned char *picture = need(4 * pixels);
    oit_truth *truth = need(pixels * sizeof *truth);
    double unit = 0;
    bool known = is_quick() || s->size > 600 ? false : (oit_truth_render(&s->scene, truth), true);
    for (int frame = -2; frame < frames; ++frame)
        for (size_t i = 0; i < count; ++i) {
            clear(s);
            glFinish();
            double start = now_ms();
            subjects[i].draw(s, &subjects[i]);
            glFinish();
            if (frame >= 0)
                times[i][frame] = now_ms() - start;
        }
    for (size_t i = 0; i < count; ++i) {
        double error = 0, ms = median(times[i], (size_t)frames);
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

int main(int argc, char **argv) {
    FILE *csv = open_table(argc, argv, "build/bench/oit.csv");
    static stage s;
    char message[256];
    subject subjects[] = {{.name = "blend", .draw = draw_blend},
                          {.name = "exact", .draw = draw_oit},
                          {.name = "exact_async", .draw = draw_oit, .desc = {.fit = OIT_FIT_ASYNC}}};
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
    static const struct {
        const char *name;
        int sheets, concentric, balls, rings;
    } scenes[] = {{"sheets16", 16, 0, 0, 0},
                  {"sheets32", 32, 0, 0, 0},
                  {"concentric32", 0, 32, 0, 64},
                  {"random16", 0, 0, 16, 127}};
    for (int size = 512; size <= (is_quick() ? 512 : 1000); size += 488) {
        make_target(&s, size);
        for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; ++i) {
            oit_scene_init(&s.scene, size, size);
            if (scenes[i].sheets)
                oit_scene_sheets(&s.scene, scenes[i].sheets, 0.2, false);
            else if (scenes[i].concentric)
                oit_scene_concentric(&s.scene, scenes[i].concentric, scenes[i].rings, 0.1);
            else
                oit_scene_random_balls(&s.scene, scenes[i].balls, scenes[i].rings, 0.4);
            printf("%s: %zu triangles\n", scenes[i].name, s.scene.triangles);
            measure(&s, subjects, count, scenes[i].name, is_quick() ? 5 : 15, csv);
            measure_phases(&s, raw, 5);
            oit_scene_drop(&s.scene);
        }
    }
    for (size_t i = 0; i < count; ++i)
        oit_destroy(subjects[i].oit);
    oit_destroy(raw);
    headless_destroy(&s.context);
    return close_table(csv);
}
