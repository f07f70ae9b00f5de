/* gl_oit_real.c: real models as glass, held to a reference in double: the same fragments in the same order, and the
 * picture; the same bits in another order and in bands. The models of examples/ and those of ../shared/models, where
 * they are. */
#include "oit_models.h"

#include "load_model.h"
#include "models.h"

enum { SIZE = 256 };

typedef struct setting {
    harness h;
    GLuint framebuffer, color;
    bool floats;
} setting;

static void open_setting(setting *t, bool floats) {
    memset(t, 0, sizeof *t);
    harness_open(&t->h, 430, false, NULL);
    t->floats = floats;
    glGenTextures(1, &t->color);
    glBindTexture(GL_TEXTURE_2D, t->color);
    glTexStorage2D(GL_TEXTURE_2D, 1, floats ? GL_RGBA32F : GL_RGBA8, SIZE, SIZE);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &t->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t->color, 0);
}

static void close_setting(setting *t) {
    glDeleteFramebuffers(1, &t->framebuffer);
    glDeleteTextures(1, &t->color);
    harness_close(&t->h);
}

static oit_context *make_oit(oit_desc desc) {
    oit_result result;
    desc.get_proc = oit_scene_get_proc;
    desc.max_gl_version = 430;
    oit_context *oit = oit_create(&desc, &result);
    oit_scene_expect(result, "oit_create");
    return oit;
}

static float *draw(setting *t, const oit_scene *s, oit_context *oit, const size_t *order) {
    const float white[4] = {1, 1, 1, 1};
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    float *picture = malloc(4 * SIZE * SIZE * sizeof *picture);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glClearBufferfv(GL_COLOR, 0, white);
    oit_scene_render(s, oit, &frame, order);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_FLOAT, picture);
    return picture;
}

static double worst_error(const oit_truth *truth, const float *picture) {
    double worst = 0;
    for (size_t i = 0; i < SIZE * SIZE; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c)
            worst = fmax(worst, fabs((double)picture[4 * i + c] - truth[i].color[c]));
    return worst;
}

static int by_depth(const void *left, const void *right) {
    const uint32_t *a = left, *b = right;
    for (int k = 0; k < 2; ++k) /* depth, then part */
        if (a[k] != b[k])
            return a[k] < b[k] ? -1 : 1;
    return 0;
}

/* The records of OIT_COLOR_FLOAT with parts, of 24 bytes, against the layers that a ray meets: which, and in which order.
 * Returns how many pixels differ. */
static size_t count_other_layers(const oit_scene *s, const oit_context *oit, const oit_truth *truth, size_t fragments) {
    static oit_truth_layer layers[4096];
    static uint32_t run[4096][6];
    ref_i_world world = {0};
    size_t wrong = 0;
    uint32_t *starts = malloc((16 + 2 * SIZE * SIZE + 2) * sizeof *starts);
    uint32_t(*records)[6] = malloc((fragments + 1) * sizeof *records);
    glBindBuffer(GL_COPY_READ_BUFFER, oit->buffers[OIT_I_PIXELS]);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, (16 + 2 * SIZE * SIZE + 2) * 4, starts);
    glBindBuffer(GL_COPY_READ_BUFFER, oit->buffers[OIT_I_FRAGMENTS]);
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, (GLsizeiptr)(24 * fragments), records);
    world.scene = &s->scene;
    assert_true(ref_i_make_world(&world));
    for (size_t i = 0; i < SIZE * SIZE; ++i) {
        size_t count = 0, first = starts[16 + 2 * i], n = starts[18 + 2 * i] - first;
        if (truth[i].left_out)
            continue;
        oit_truth_cast(&world, s, (double)(i % SIZE) + 0.5, (double)(i / SIZE) + 0.5, layers, &count);
        bool same = count == n && n < 4096;
        if (same) {
            memcpy(run, records[first], n * sizeof run[0]);
            qsort(run, n, sizeof run[0], by_depth);
        }
        for (size_t k = 0; same && k < n; ++k)
            same = run[k][1] == layers[k].part;
        wrong += !same;
    }
    ref_i_free_world(&world);
    free(starts);
    free(records);
    return wrong;
}

/* The picture again: drawn in another order, and in bands. */
static void check_same_bits(setting *t, const oit_scene *s, oit_desc desc, oit_context *oit, const float *picture,
                            uint32_t fragments) {
    size_t order[OIT_SCENE_MAX], bytes = 4 * SIZE * SIZE * sizeof *picture;
    oit_report report = {0};
    for (size_t i = 0; i < s->count; ++i)
        order[i] = s->count - 1 - i;
    float *again = draw(t, s, oit, order);
    assert_memory_equal(picture, again, bytes);
    free(again);
    desc.ceiling_bytes = (int64_t)fragments * oit_get_info(oit).fragment_bytes / 5 + 4096;
    oit = make_oit(desc);
    again = draw(t, s, oit, NULL);
    assert_int_equal(oit_get_report(oit, &report), OIT_OK);
    assert_true(report.bands > 1);
    assert_memory_equal(picture, again, bytes);
    free(again);
    oit_destroy(oit);
}

/* Into a target of 8 bits the driver blends in 8 bits: what comes in, its weight and the product are each rounded to half a
 * unit; half a step of the 10 bits of OIT_COLOR_8 besides. */
static const double tolerance_8 = 1.5 / 255 + 0.5 / 1023, tolerance_float = 1e-5;

static void check_picture(const char *name, oit_scene *s, const scene *model, const oit_truth *truth, bool floats) {
    oit_desc desc = {.color = floats ? OIT_COLOR_FLOAT : OIT_COLOR_8, .fields = floats ? OIT_FIELD_PART : 0};
    oit_report report = {0};
    setting t;
    open_setting(&t, floats);
    oit_scene_of_model(s, model, SIZE);
    oit_context *oit = make_oit(desc);
    float *picture = draw(&t, s, oit, NULL);
    assert_int_equal(oit_get_report(oit, &report), OIT_OK);
    double worst = worst_error(truth, picture);
    size_t wrong = floats ? count_other_layers(s, oit, truth, report.needed) : 0;
    printf("    %-16s %s target: max %.3g, %u fragments, deepest %u, %zu pixels with other layers\n", name,
           floats ? "float" : "8 bit", worst, report.needed, report.deepest, wrong);
    assert_true(worst <= (floats ? tolerance_float : tolerance_8));
    assert_int_equal(wrong, 0);
    assert_true(report.needed > SIZE * SIZE / 4);
    if (floats)
        check_same_bits(&t, s, desc, oit, picture, report.needed);
    free(picture);
    oit_destroy(oit);
    oit_scene_drop(s);
    close_setting(&t);
}

static void check_model(const char *name, const scene *model) {
    static oit_truth truth[SIZE * SIZE];
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false); /* objects need a context even where only the reference looks at them */
    oit_scene_of_model(s, model, SIZE);
    double left_out = oit_truth_render(s, truth);
    printf("    %-16s %zu triangles, %.1f %% left out\n", name, s->triangles, 100 * left_out);
    oit_scene_drop(s);
    close_setting(&t);
    assert_true(left_out <= 0.10);
    check_picture(name, s, model, truth, true);
    check_picture(name, s, model, truth, false);
    free(s);
}

static void test_own_models(void **state) {
    static const char *const names[] = {"mug", "crank", "torus_knot", "klein_bottle"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        scene *model = models_make(names[i]);
        assert_non_null(model);
        check_model(names[i], model);
        scene_destroy(model);
    }
}

static void test_shared_models(void **state) {
    static const char *const files[] = {"robot.glb", "skull.obj", "chair_model.obj", "klein_bottle.ply"};
    const char *folder = getenv("GLASSINE_MODELS");
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof files[0]; ++i) {
        char path[1024], message[256];
        load_report report;
        snprintf(path, sizeof path, "%s/%s", folder ? folder : "../shared/models", files[i]);
        FILE *file = fopen(path, "rb");
        if (!file) {
            printf("    skipped: no %s\n", path);
            continue;
        }
        fclose(file);
        scene *model = load_model(path, &report, message, sizeof message);
        if (!model)
            fail_msg("%s: %s", path, message);
        check_model(files[i], model);
        scene_destroy(model);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_own_models), cmocka_unit_test(test_shared_models)};
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
