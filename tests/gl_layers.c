/* gl_layers.c: layers, groups and a method per object, on a real driver, held to the reference and to probe pixels. */
#include "gl_scenes.h"

#include "probes_more.h"

static harness desktop;

static int open_desktop(void **state) {
    (void)state;
    harness_open(&desktop, 450, false, NULL);
    return 0;
}

static int close_desktop(void **state) {
    (void)state;
    harness_close(&desktop);
    return 0;
}

/* ---- scenes ---- */

/* Five shells about an opaque core, with opaque balls between them. */
static void five_deep(test_scene *s) {
    for (int i = 0; i < 5; ++i) {
        ref_object *o = add_object(s, true, 0.2 + 0.15 * i, 0.5, 0.9 - 0.15 * i, 0.3 + 0.05 * i);
        make_ball(s, o, 0.05 * i, 0, 0, 1.6 - 0.25 * i, 1);
        o->group = 1;
    }
    make_ball(s, add_object(s, false, 0.1, 0.6, 0.1, 1), 0, 0, 0, 0.3, 1);
    make_ball(s, add_object(s, false, 0.7, 0.1, 0.6, 1), 0.5, 0.4, 1.0, 0.08, 1);
    make_ball(s, add_object(s, false, 0.1, 0.1, 0.1, 1), -0.5, 0.2, -1.0, 0.1, 1);
}

static void chain_of_groups(test_scene *s) {
    intersecting(s);
    s->truths[0].group = s->truths[1].group = 5;
    ref_object *third = add_object(s, true, 0.5, 0.9, 0.3, 0.6);
    make_ball(s, third, 0, 0.4, -1.4, 0.9, 1);
    third->group = 5;
    ref_object *other = add_object(s, true, 0.9, 0.9, 0.3, 0.6);
    make_ball(s, other, -0.3, -0.5, 0.3, 0.5, 1);
    other->group = 6;
}

static void mixed_methods(test_scene *s) {
    chain_of_groups(s);
    for (size_t i = 0; i < s->count; ++i) {
        s->truths[i].group = 0;
        s->truths[i].method = i % 2 ? 2 : 1;
    }
}

static void mixed_groups(test_scene *s) {
    chain_of_groups(s);
    for (size_t i = 0; i < s->count; ++i)
        s->truths[i].method = i % 3 ? 2 : 1;
}

static void grouped_sheets(test_scene *s) {
    open_sheet(s);
    for (size_t i = 0; i < s->count; ++i)
        s->truths[i].group = 3;
}

static void grouped_inside(test_scene *s) {
    eye_inside(s);
    s->truths[0].group = s->truths[1].group = 3;
}

static void grouped_coincident(test_scene *s) {
    coincident(s);
    ref_object *inner = add_object(s, true, 0.2, 0.9, 0.4, 0.5);
    make_ball(s, inner, 0, 0, 0, 1.0, 1);
    s->truths[0].group = s->truths[1].group = inner->group = 9;
}

static void coincident_strangers(test_scene *s) {
    grouped_coincident(s);
    s->truths[1].group = 8;
}

typedef struct named_layers {
    const char *name;
    void (*make)(test_scene *);
    ref_interior interior;
    int layers;
    double distance;
    int passes; /* of the plan: the path that the test is about has run */
} named_layers;

static const named_layers cases[] = {
    {"five deep, layers 1", five_deep, REF_INTERIOR_LAYERS, 1, 0, 5},
    {"five deep, layers 2", five_deep, REF_INTERIOR_LAYERS, 2, 0, 7},
    {"five deep, layers 3", five_deep, REF_INTERIOR_LAYERS, 3, 0, 9},
    {"five deep, layers 8", five_deep, REF_INTERIOR_LAYERS, 8, 0, 19},
    {"intersecting, layers 2", intersecting, REF_INTERIOR_LAYERS, 2, 0, 7},
    {"coincident, layers 2", grouped_coincident, REF_INTERIOR_LAYERS, 2, 0, 7},
    {"eye inside, layers 2", eye_inside, REF_INTERIOR_LAYERS, 2, 0, 7},
    {"sheets, layers 3", open_sheet, REF_INTERIOR_LAYERS, 3, 0, 16},
    {"a sheet alone, layers 2", lone_sheet, REF_INTERIOR_LAYERS, 2, 0, 5},
    {"only glass, layers 2", only_glass, REF_INTERIOR_LAYERS, 2, 0, 5},
    {"group of five", five_deep, REF_INTERIOR_IMPLICIT, 0, 0, 13},
    {"group of five, explicit", five_deep, REF_INTERIOR_EXPLICIT, 0, 0, 13},
    {"group of five, near", five_deep, REF_INTERIOR_IMPLICIT, 0, 0.3, 13},
    {"group of five, three shown", five_deep, REF_INTERIOR_IMPLICIT, 3, 0, 9},
    {"groups", chain_of_groups, REF_INTERIOR_IMPLICIT, 0, 0, 9},
    {"groups, explicit", chain_of_groups, REF_INTERIOR_EXPLICIT, 0, 0, 9},
    {"groups, near", chain_of_groups, REF_INTERIOR_IMPLICIT, 0, 0.6, 9},
    {"groups, mixed methods", mixed_groups, REF_INTERIOR_IMPLICIT, 0, 0, 9},
    {"mixed methods", mixed_methods, REF_INTERIOR_IMPLICIT, 0, 0, 5},
    {"grouped sheets", grouped_sheets, REF_INTERIOR_IMPLICIT, 0, 0, 12},
    {"grouped sheets, explicit", grouped_sheets, REF_INTERIOR_EXPLICIT, 0, 0, 12},
    {"eye inside a group", grouped_inside, REF_INTERIOR_IMPLICIT, 0, 0, 7},
    {"coincident in a group", grouped_coincident, REF_INTERIOR_IMPLICIT, 0, 0, 9},
    {"coincident in a group, explicit", grouped_coincident, REF_INTERIOR_EXPLICIT, 0, 0, 9},
    {"coincident strangers", coincident_strangers, REF_INTERIOR_IMPLICIT, 0, 0, 7},
    {"coincident strangers, explicit", coincident_strangers, REF_INTERIOR_EXPLICIT, 0, 0, 7},
};
enum { CASES = sizeof cases / sizeof cases[0] };

static void make_case(test_scene *s, const named_layers *c, int size) {
    init_scene(s, size);
    c->make(s);
    s->scene.interior = c->interior;
    s->scene.layers = c->layers;
    s->scene.group_distance = c->distance;
    finish_scene(s);
}

/* ---- pictures ---- */

static void check_case(const named_layers *c) {
    static const char *const blendings[3] = {"published", "normalised", "over"};
    test_scene s;
    make_case(&s, c, 160);
    size_t pixels = (size_t)s.scene.width * (size_t)s.scene.height;
    ref_pixel *truth = malloc(pixels * sizeof *truth);
    unsigned char *picture = malloc(4 * pixels);
    harness_target(&desktop, s.scene.width, s.scene.height);
    for (int blending = 0; blending < 3; ++blending) {
        char label[80];
        s.scene.blending = (ref_blending)blending;
        assert_true(ref_render(&s.scene, truth));
        harness_clear(&desktop, s.scene.background, 1.0f);
        harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, picture);
        snprintf(label, sizeof label, "%s, %s", c->name, blendings[blending]);
        harness_check(&desktop, label, &s.scene, truth, picture);
        assert_int_equal(tr_get_info(desktop.tr).plan->pass_count, c->passes);
    }
    free(truth);
    free(picture);
    drop_scene(&s);
}

static void test_layers_and_groups_match_reference(void **state) {
    (void)state;
    for (size_t i = 0; i < CASES; ++i)
        check_case(&cases[i]);
}

static void test_models_match_reference(void **state) {
    static const char *const names[] = {"mug", "crank", "shells", "gearbox"};
    static const int sizes[] = {256, 256, 256, 640};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        scene *model = models_make(names[i]);
        test_scene s;
        assert_non_null(model);
        init_scene(&s, sizes[i]);
        add_model(&s, model);
        frame_model(&s, model);
        for (size_t k = 0; k < s.count; ++k)
            s.truths[k].group = 1;
        finish_scene(&s);
        size_t pixels = (size_t)s.scene.width * (size_t)s.scene.height;
        ref_pixel *truth = malloc(pixels * sizeof *truth);
        unsigned char *picture = malloc(4 * pixels);
        harness_target(&desktop, s.scene.width, s.scene.height);
        s.scene.blending = REF_BLEND_OVER;
        for (int mode = 0; mode < 5; ++mode) {
            static const char *const modes[5] = {"group", "group, explicit", "layers 1", "layers 2", "layers 4"};
            static const int layers[5] = {0, 0, 1, 2, 4};
            char label[80];
            s.scene.interior = mode == 0   ? REF_INTERIOR_IMPLICIT
                               : mode == 1 ? REF_INTERIOR_EXPLICIT
                                           : REF_INTERIOR_LAYERS;
            s.scene.layers = layers[mode];
            assert_true(ref_render(&s.scene, truth));
            harness_clear(&desktop, s.scene.background, 1.0f);
            harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, picture);
            snprintf(label, sizeof label, "%s, %s", names[i], modes[mode]);
            harness_check(&desktop, label, &s.scene, truth, picture);
        }
        free(truth);
        free(picture);
        drop_scene(&s);
        scene_destroy(model);
    }
}

/* The order of the host's array changes no bit, in no mode. */
static void test_draw_order_changes_nothing(void **state) {
    static unsigned char first[128 * 128 * 4], other[128 * 128 * 4];
    (void)state;
    harness_target(&desktop, 128, 128);
    for (size_t i = 0; i < CASES; ++i) {
        test_scene s;
        make_case(&s, &cases[i], 128);
        harness_clear(&desktop, s.scene.background, 1.0f);
        harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, first);
        for (uint32_t turn = 0, random = 4321; turn < 8; ++turn) {
            for (size_t j = s.count; j > 1; --j) {
                random = random * 1664525u + 1013904223u;
                size_t at = (random >> 8) % j;
                harness_object swap = s.objects[j - 1];
                s.objects[j - 1] = s.objects[at];
                s.objects[at] = swap;
            }
            harness_clear(&desktop, s.scene.background, 1.0f);
            harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, other);
            if (memcmp(first, other, sizeof first) != 0)
                fail_msg("%s: the order changes the picture", cases[i].name);
        }
        drop_scene(&s);
    }
}

/* ---- probe pixels, worked out by hand ---- */

enum { PROBE_SIZE = 201 };

static const probe_object *object_of(const probe_object *objects, int count, uint32_t id) {
    for (int i = 0; i < count; ++i)
        if (objects[i].id == id)
            return &objects[i];
    return NULL;
}

/* Objects of one kind have one colour in the probes: here each id has its own, so that pictures tell them apart. */
static void paint(test_scene *s) {
    for (size_t i = 0; i < s->count; ++i) {
        uint32_t id = s->truths[i].id;
        const double color[3] = {(id * 5 % 13) / 13.0, (id * 7 % 11) / 11.0, (id * 3 % 7) / 7.0};
        memcpy(s->truths[i].color, color, sizeof color);
    }
}

static const ref_object *painted(const test_scene *s, uint32_t id) {
    for (size_t i = 0; i < s->count; ++i)
        if (s->truths[i].id == id)
            return &s->truths[i];
    return NULL;
}

static size_t pixel_at(double u, double v) {
    return (size_t)((v + 1) * 0.5 * PROBE_SIZE) * PROBE_SIZE + (size_t)((u + 1) * 0.5 * PROBE_SIZE);
}

static unsigned char drawn[PROBE_SIZE * PROBE_SIZE * 4];
static ref_pixel truth_at[PROBE_SIZE * PROBE_SIZE];

static void draw_probes(test_scene *s) {
    harness_clear(&desktop, s->scene.background, 1.0f);
    harness_draw(&desktop, &s->scene, s->objects, s->count, NULL, drawn);
    assert_true(ref_render(&s->scene, truth_at));
}

/* Reference and picture against the answer. */
static void check_list(const test_scene *s, const char *where, int index, double u, double v, const probe_list *list) {
    const ref_pixel *truth = &truth_at[pixel_at(u, v)];
    const unsigned char *found = &drawn[4 * pixel_at(u, v)];
    const ref_object *behind = list->behind ? painted(s, list->behind) : NULL;
    double color[3];
    memcpy(color, behind ? behind->color : s->scene.background, sizeof color);
    for (int i = list->count - 1; i >= 0; --i) {
        const ref_object *o = painted(s, list->blended[i]);
        ref_blend(REF_BLEND_OVER, o->alpha, o->color, 0, color, color);
    }
    bool same = truth->layer_count == list->count && truth->opaque_object == list->behind;
    for (int i = 0; same && i < list->count; ++i)
        same = truth->layer_objects[i] == list->blended[i];
    if (!same)
        fail_msg("reference, %s, probe %d (%g, %g): %d layers (first %u) before %u, should be %d (first %u) before %u",
                 where, index, u, v, truth->layer_count, truth->layer_objects[0], truth->opaque_object, list->count,
                 list->blended[0], list->behind);
    for (int k = 0; k < 3; ++k)
        if (fabs(color[k] * 255 - found[k]) > 2)
            fail_msg("%s, probe %d (%g, %g): channel %d is %d, should be %.1f", where, index, u, v, k, found[k],
                     color[k] * 255);
}

static void open_probe_scene(test_scene *s, const probe_object *objects, int count) {
    init_scene(s, PROBE_SIZE);
    s->scene.blending = REF_BLEND_OVER;
    for (int o = 0; o < count; ++o) {
        assert_ptr_equal(object_of(objects, count, objects[o].id), &objects[o]);
        add_probe_object(s, &objects[o]);
    }
    paint(s);
}

static void test_probes_of_layers(void **state) {
    int checked = 0;
    (void)state;
    harness_target(&desktop, PROBE_SIZE, PROBE_SIZE);
    for (size_t i = 0; i < PROBE_COUNT(probe_layers_scenes); ++i) {
        const probe_layers_scene *p = &probe_layers_scenes[i];
        test_scene s;
        open_probe_scene(&s, p->objects, p->object_count);
        s.scene.interior = REF_INTERIOR_LAYERS;
        finish_scene(&s);
        for (int v = 0; v < p->view_count; ++v) {
            static const int layers[4] = {1, 2, 3, 5};
            set_probe_camera(&s, &p->views[v].camera);
            for (int n = 0; n < 4; ++n) {
                s.scene.layers = layers[n];
                draw_probes(&s);
                for (int q = 0; q < p->views[v].probe_count; ++q, ++checked) {
                    const probe_layers *place = &p->views[v].probes[q];
                    const probe_list *lists[4] = {&place->n1, &place->n2, &place->n3, &place->n5};
                    check_list(&s, p->views[v].name, q, place->u, place->v, lists[n]);
                }
            }
        }
        drop_scene(&s);
    }
    printf("    %d probes\n", checked);
    assert_true(checked >= 80);
}

static void test_probes_of_groups(void **state) {
    int checked = 0;
    (void)state;
    harness_target(&desktop, PROBE_SIZE, PROBE_SIZE);
    for (size_t i = 0; i < PROBE_COUNT(probe_group_scenes); ++i) {
        const probe_group_scene *p = &probe_group_scenes[i];
        test_scene s;
        open_probe_scene(&s, p->objects, p->object_count);
        for (size_t o = 0; o < s.count; ++o)
            for (int m = 0; m < p->member_count; ++m)
                if (p->members[m].id == s.truths[o].id)
                    s.truths[o].group = p->members[m].group;
        finish_scene(&s);
        for (int v = 0; v < p->view_count; ++v) {
            double distance = p->views[v].group_distance;
            set_probe_camera(&s, &p->views[v].camera);
            s.scene.group_distance = distance < PROBE_ANY_DISTANCE ? distance : 0;
            for (int method = 0; method < 2; ++method) {
                s.scene.interior = method ? REF_INTERIOR_EXPLICIT : REF_INTERIOR_IMPLICIT;
                draw_probes(&s);
                for (int q = 0; q < p->views[v].probe_count; ++q, ++checked) {
                    const probe_group *place = &p->views[v].probes[q];
                    check_list(&s, p->views[v].name, q, place->u, place->v,
                               method ? &place->by_explicit : &place->by_default);
                }
            }
        }
        drop_scene(&s);
    }
    printf("    %d probes\n", checked);
    assert_true(checked >= 40);
}

static void test_probes_of_methods(void **state) {
    int checked = 0;
    (void)state;
    harness_target(&desktop, PROBE_SIZE, PROBE_SIZE);
    for (size_t i = 0; i < PROBE_COUNT(probe_mixed_scenes); ++i) {
        const probe_mixed_scene *p = &probe_mixed_scenes[i];
        for (int v = 0; v < p->view_count; ++v) {
            test_scene s;
            open_probe_scene(&s, p->objects, p->object_count);
            for (size_t o = 0; o < s.count; ++o) {
                s.truths[o].method = 1;
                for (int e = 0; e < 4 && p->views[v].explicit_ids[e]; ++e)
                    if (p->views[v].explicit_ids[e] == s.truths[o].id)
                        s.truths[o].method = 2;
            }
            finish_scene(&s);
            set_probe_camera(&s, &p->views[v].camera);
            draw_probes(&s);
            assert_true(tr_get_info(desktop.tr).plan->mixed);
            for (int q = 0; q < p->views[v].probe_count; ++q, ++checked) {
                const probe_mixed *place = &p->views[v].probes[q];
                probe_list list = {place->answer.front != 0, {place->answer.front, 0, 0, 0, 0}, place->answer.behind};
                check_list(&s, p->views[v].name, q, place->u, place->v, &list);
            }
            drop_scene(&s);
        }
    }
    printf("    %d probes\n", checked);
    assert_true(checked >= 20);
}

/* ---- Hodges' first rule ---- */

/* Bars that enter balls: into one, through two, aslant, and one that enters nothing. */
static void entering(test_scene *s) {
    static const double bars[4][6] = {{-2, 0.3, 0.2, 1.6, 0.15, 0.12},
                                      {0, -0.4, 0.5, 2.2, 0.12, 0.12},
                                      {0.9, 1.1, 0, 0.12, 0.9, 0.2},
                                      {0.3, 1.7, 0, 0.5, 0.1, 0.1}};
    static const float corners[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1,
                                      -1, -1, 1,  1, -1, 1,  -1, 1, 1,  1, 1, 1};
    static const uint32_t sides[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                       2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    make_ball(s, add_object(s, true, 0.3, 0.5, 0.9, 0.3), -0.8, 0, 0, 0.8, 1);
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.3), 0.9, 0.1, 0, 0.9, 1);
    for (int i = 0; i < 4; ++i) {
        ref_object *o = add_object(s, false, 0.2 * i + 0.3, 0.9 - 0.2 * i, 0.4, 1);
        o->positions = corners;
        o->indices = sides;
        o->vertex_count = 8;
        o->triangle_count = 12;
        for (int k = 0; k < 3; ++k) {
            o->model[5 * k] = bars[i][3 + k];
            o->model[12 + k] = bars[i][k];
        }
        o->model[1] = 0.2 * i;
    }
    s->scene.enter_strength = 0.7;
    s->scene.enter_reach = 0.35;
}

static void test_entering_matches_reference(void **state) {
    static const char *const modes[3] = {"implicit", "explicit", "layers 2"};
    static const ref_interior interiors[3] = {REF_INTERIOR_IMPLICIT, REF_INTERIOR_EXPLICIT, REF_INTERIOR_LAYERS};
    static ref_pixel truth[240 * 240];
    static unsigned char picture[240 * 240 * 4], plain[240 * 240 * 4];
    (void)state;
    harness_target(&desktop, 240, 240);
    for (int mode = 0; mode < 3; ++mode) {
        char label[80];
        test_scene s;
        init_scene(&s, 240);
        entering(&s);
        s.scene.interior = interiors[mode];
        s.scene.layers = mode == 2 ? 2 : 0;
        s.scene.blending = REF_BLEND_OVER;
        finish_scene(&s);
        assert_true(ref_render(&s.scene, truth));
        harness_clear(&desktop, s.scene.background, 1.0f);
        harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, picture);
        snprintf(label, sizeof label, "entering, %s", modes[mode]);
        harness_check(&desktop, label, &s.scene, truth, picture);
        s.scene.enter_reach = 0;
        harness_clear(&desktop, s.scene.background, 1.0f);
        harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, plain);
        size_t changed = 0;
        for (size_t i = 0; i < sizeof picture; ++i)
            changed += picture[i] != plain[i];
        assert_true(changed > 1000);
        drop_scene(&s);
    }
}

static void thin_line(tr_frame *frame) {
    frame->enter_line = 3.0f;
    frame->outline_color[0] = 1.0f;
}

static void thin_line_of_texels(tr_frame *frame) {
    thin_line(frame);
    frame->wishes.supersample = 3;
}

/* The curve as a line: ink where the plain picture has none, in a narrow band; as wide with more texels a pixel. */
static void test_curve_as_a_line(void **state) {
    static unsigned char picture[240 * 240 * 4];
    harness_options options = {0, 0, NULL, NULL, NULL, NULL, 0, thin_line};
    test_scene s;
    size_t ink = 0, other = 0;
    double red = 0, red_of_texels = 0;
    (void)state;
    init_scene(&s, 240);
    entering(&s);
    for (size_t i = 0; i < s.count; ++i) /* no red but the line's */
        s.truths[i].color[0] = 0;
    s.scene.background[0] = 0;
    s.scene.enter_strength = 0;
    finish_scene(&s);
    harness_target(&desktop, 240, 240);
    harness_clear(&desktop, s.scene.background, 1.0f);
    harness_draw(&desktop, &s.scene, s.objects, s.count, &options, picture);
    for (size_t i = 0; i < 240 * 240; ++i) {
        ink += picture[4 * i] > 100;
        other += picture[4 * i] > 0 && picture[4 * i] < 100;
        red += picture[4 * i];
    }
    printf("    %zu pixels of ink, %zu mixed\n", ink, other);
    assert_true(ink > 150 && ink < 3000 && other == 0);
    options.change = thin_line_of_texels;
    harness_clear(&desktop, s.scene.background, 1.0f);
    harness_draw(&desktop, &s.scene, s.objects, s.count, &options, picture);
    for (size_t i = 0; i < 240 * 240; ++i)
        red_of_texels += picture[4 * i];
    printf("    with 9 texels a pixel %.2f as much\n", red_of_texels / red);
    assert_true(fabs(red_of_texels / red - 1) < 0.1); /* rims are cut at texels, not pixels */
    drop_scene(&s);
}

/* One probe: half a pixel off its place, the distance differs by at most 0.03 of these scenes' units. */
static void check_entering(const test_scene *s, const probe_hodges_view *v, int index) {
    const probe_hodges *place = &v->probes[index];
    size_t pixel = pixel_at(place->u, place->v);
    const ref_object *front = place->answer.front ? painted(s, place->answer.front) : NULL;
    const ref_object *solid = painted(s, place->answer.behind);
    double slack = 0.03 * v->strength / v->reach * 255 + 2;
    for (size_t k = 0; k < 3; ++k) {
        double found = drawn[4 * pixel + k], truth = 255 * truth_at[pixel].color[k];
        double color = 255 * solid->color[k] * place->factor;
        if (front)
            color = front->alpha * 255 * front->color[k] + (1 - front->alpha) * color;
        if (fabs(truth - color) > slack || fabs(found - truth) > 2)
            fail_msg("%s, probe %d: channel %zu is %.0f, by the reference %.1f, should be %.1f", v->name, index, k,
                     found, truth, color);
    }
}

static void test_probes_of_entering(void **state) {
    int checked = 0;
    (void)state;
    harness_target(&desktop, PROBE_SIZE, PROBE_SIZE);
    for (size_t i = 0; i < PROBE_COUNT(probe_hodges_scenes); ++i) {
        const probe_hodges_scene *p = &probe_hodges_scenes[i];
        test_scene s;
        open_probe_scene(&s, p->objects, p->object_count);
        finish_scene(&s);
        for (int view = 0; view < p->view_count; ++view) {
            set_probe_camera(&s, &p->views[view].camera);
            s.scene.enter_strength = p->views[view].strength;
            s.scene.enter_reach = p->views[view].reach;
            draw_probes(&s);
            for (int q = 0; q < p->views[view].probe_count; ++q, ++checked)
                check_entering(&s, &p->views[view], q);
        }
        drop_scene(&s);
    }
    printf("    %d probes\n", checked);
    assert_true(checked >= 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_probes_of_layers),
        cmocka_unit_test(test_probes_of_groups),
        cmocka_unit_test(test_probes_of_methods),
        cmocka_unit_test(test_probes_of_entering),
        cmocka_unit_test(test_entering_matches_reference),
        cmocka_unit_test(test_curve_as_a_line),
        cmocka_unit_test(test_layers_and_groups_match_reference),
        cmocka_unit_test(test_models_match_reference),
        cmocka_unit_test(test_draw_order_changes_nothing),
    };
    return cmocka_run_group_tests_name("gl_layers", tests, open_desktop, close_desktop);
}
