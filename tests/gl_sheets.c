/* gl_sheets.c: feature lines among the layers of smart transparency (Carnecky 2013, figure 13), and the curvature of sheets,
 * which have no outside. Both against closed forms. */
#include "smart_stage.h"

enum { SIZE = 24, MOST_LAYERS = 6, FIRST = 9, LAST = 12 /* columns of the line */ };

/* ---- lines behind layers ---- */

static double layer_z(int layer, int layers) {
    return -0.8 + 1.6 * (layer + 0.5) / (layers + 1);
}

/* Layers wider than the picture, whose frame is no silhouette, and a line that `before` of them are nearer than. */
static void make_layers(smart_stage *t, int layers, int before, double ink) {
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 5;
    for (int i = 0, at = 0; i <= layers; ++i) {
        double z = layer_z(i, layers), zs[4] = {z, z, z, z}, color[4];
        const double black[4] = {0.1, 0, 0.2, ink}, pixel = 2.0 / SIZE;
        if (i == before) {
            oit_scene_quad(s, FIRST * pixel - 1, -1, (LAST + 1) * pixel - 1, 1, zs, black);
            s->objects[s->count - 1].blend = OIT_BLEND_LINE;
            continue;
        }
        smart_stage_color(&state, 0.9, color);
        s->objects[oit_scene_quad(s, -1.5, -1.5, 1.5, 1.5, zs, color)].part = (uint32_t)++at;
    }
}

/* What is laid from the eye on, with an opacity of `base` for layers; lines keep theirs. Without the line where it is not. */
static void lay(const oit_scene *s, double base, bool in_line, double out[3]) {
    double through = 1;
    out[0] = out[1] = out[2] = 0;
    for (size_t i = 0; i < s->count; ++i) {
        bool line = s->objects[i].blend == OIT_BLEND_LINE;
        double alpha = line ? s->truths[i].alpha : base;
        for (int k = 0; k < 3 && (!line || in_line); ++k)
            out[k] += through * alpha * s->truths[i].color[k];
        through *= line && !in_line ? 1 : 1 - alpha;
    }
    for (int k = 0; k < 3; ++k)
        out[k] += through;
}

static size_t smart_operators(oit_operator ops[3], oit_law_kind law) {
    memset(ops, 0, 3 * sizeof *ops);
    ops[0].kind = OIT_RUN_LINK;
    ops[1].kind = OIT_RUN_LAW;
    ops[1].law.kind = law;
    ops[1].law.s = 0.6f;
    ops[2].kind = OIT_RUN_SMART;
    return 3;
}

/* A line is seen through as many layers as are before it; it is none, so that the adaptive law does not count it, and no
 * surface ends at it: nothing but its own pixels changes. */
static void lines_are_seen_through_what_is_before_them(void **state) {
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_BLEND, .operators = OIT_OPERATE_ALL};
    desc.operator_fields = 1;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        int compared = 0;
        smart_stage_open(&t, es != 0, SIZE, desc, 1 << 14);
        for (int layers = 0; layers <= MOST_LAYERS; ++layers)
            for (int before = 0; before <= layers; ++before)
                for (int kind = 0; kind < 4; ++kind) {
                    oit_operator ops[3];
                    bool adaptive = kind & 1;
                    make_layers(&t, layers, before, kind & 2 ? 0.5 : 1);
                    size_t count = smart_operators(ops, adaptive ? OIT_LAW_ADAPTIVE : OIT_LAW_CONSTANT);
                    float *picture = smart_stage_frame(&t, ops, count, NULL, NULL);
                    double base = adaptive && layers ? 1 - pow(1 - 0.6, 1.0 / layers) : 0.6, truths[2][3];
                    lay(&t.scene, base, false, truths[0]);
                    lay(&t.scene, base, true, truths[1]);
                    for (int p = 0; p < SIZE * SIZE; ++p, ++compared)
                        for (int k = 0; k < 3; ++k) {
                            bool in_line = p % SIZE >= FIRST && p % SIZE <= LAST;
                            assert_true(fabs((double)picture[4 * p + k] - truths[in_line][k]) < 1e-5);
                        }
                    free(picture);
                }
        printf("    %s: %d pixels\n", es ? "ES 3.1" : "GL 4.3", compared);
        smart_stage_close(&t);
    }
}

/* ---- sheets ---- */

/* kappa of the near and the far wall in the middle of an open pipe, whose normals point to its axis. */
static void walls(smart_stage *t, int two_sided, GLenum front, double kappa[2]) {
    oit_scene *s = &t->scene;
    oit_frame frame = oit_scene_frame(s, t->set.framebuffer);
    oit_pass pass;
    oit_operator op;
    double truth[16];
    smart_stage_projection(t, frame.projection, truth);
    oit_setting_clear(&t->set, s);
    oit_scene_expect(oit_begin(t->set.oit, &frame), "oit_begin");
    while (oit_next_pass(t->set.oit, &pass)) {
        oit_material material;
        memset(&material, 0, sizeof material);
        oit_scene_matrix(s, 0, material.model_view_projection);
        material.normal_matrix[0] = material.normal_matrix[4] = material.normal_matrix[8] = 1;
        material.two_sided = two_sided;
        glFrontFace(front);
        oit_set_material(t->set.oit, &pass, &material);
        oit_scene_elements(s, 0);
    }
    glFrontFace(GL_CCW);
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_LINK;
    op.link.radius = (float)t->radius;
    smart_stage_run(t, &op);
    op.kind = OIT_RUN_CURVATURE;
    op.curvature.unit = 0.5f;
    smart_stage_run(t, &op);
    ref_smart_image image = smart_stage_look(t);
    assert_int_equal(ref_smart_count(&image, SIZE / 2, SIZE / 2), 2);
    for (size_t k = 0; k < 2; ++k)
        kappa[k] = ref_smart_at(&image, SIZE / 2, SIZE / 2, k)->kappa;
    smart_stage_drop(&image);
    free(smart_stage_end(t));
}

/* kappa1 + kappa2 of a cylinder is 1 / R, and its sign that of the side that normals are of: by the mesh both walls bend
 * the same way; of a sheet the near one comes toward the eye and the far one goes away from it. */
static void sheets_bend_as_the_side_that_is_seen(void **state) {
    (void)state;
    const double radius = 0.9, numbers[4] = {radius, 3, 0, 1}, color[4] = {0.5, 0.5, 0.5, 0.4};
    const double expected = tanh(0.5 / radius);
    oit_desc desc = {.fields = OIT_FIELD_NORMAL, .operators = OIT_OPERATE_ALL, .operator_fields = 1};
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open(&t, es != 0, SIZE, desc, 1 << 14);
        oit_scene *s = smart_stage_clear(&t);
        oit_scene_camera(s, 6, 1, 10, 0.25);
        t.radius = 1.8;
        smart_stage_sheet(s, smart_stage_pipe, numbers, 96, color);
        for (int kind = 0; kind < 3;
             ++kind) { /* as the mesh has it; turned; turned, with the front the other way round */
            static const double signs[3][2] = {{1, 1}, {-1, 1}, {1, -1}};
            double kappa[2];
            walls(&t, kind > 0, kind == 2 ? GL_CW : GL_CCW, kappa);
            printf("    %s: %.4f before, %.4f behind; %.4f\n", es ? "ES 3.1" : "GL 4.3", kappa[0], kappa[1], expected);
            for (int k = 0; k < 2; ++k) /* 96 steps round, and steps of several pixels */
                assert_true(fabs(kappa[k] - signs[kind][k] * expected) < 0.01);
        }
        smart_stage_close(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines_are_seen_through_what_is_before_them),
                                       cmocka_unit_test(sheets_bend_as_the_side_that_is_seen)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
