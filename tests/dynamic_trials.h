/* dynamic_trials.h: random scenes of units, drawn by a rung of dynamic transparency in a context of some kind, against the
 * truth. For tests. */
#ifndef GLASSINE_TESTS_DYNAMIC_TRIALS_H
#define GLASSINE_TESTS_DYNAMIC_TRIALS_H

#include "dynamic_stage.h"

static inline void set_truth(stage *s, tr_see see) {
    s->wish.see = see;
    s->truth.order = see <= TR_SEE_EXACT ? REF_DYN_PER_PIXEL : REF_DYN_OBJECT_CENTRES;
    s->truth.one_mask = see == TR_SEE_ONE_MASK || see == TR_SEE_DITHER; /* dithering's mean is the same */
    if (see == TR_SEE_PUBLISHED)
        ref_dyn_published(&s->truth);
}

static inline void write_pictures(const stage *s, const char *name) {
    const char *folder = getenv("GLASSINE_PICTURES");
    char path[512];
    for (int which = 0; folder && which < 2; ++which) {
        snprintf(path, sizeof path, "%s/%s_%s.ppm", folder, name, which ? "truth" : "gl");
        FILE *file = fopen(path, "wb");
        if (!file)
            return;
        fprintf(file, "P6 %d %d 255\n", s->scene.width, s->scene.height);
        for (int y = s->scene.height - 1; y >= 0; --y)
            for (int x = 0; x < s->scene.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    size_t i = (size_t)(y * s->scene.width + x);
                    fputc(which ? (int)(stage_encode(s, s->pixels[i].color[c]) + 0.5) : s->picture[4 * i + (size_t)c],
                          file);
                }
        fclose(file);
    }
}

/* ---- random scenes ---- */

enum {
    SOLIDS = 0,
    IMPENETRABLES = 2,
    HOLLOWS = 4,
    BACKDROPS = 8,
    IMPORTANCES = 16,
    GROUPS = 32,
    LIGHTS = 64,
    FADES = 128
};

/* Boxes and rings at random; `wanted` of them targets. */
static inline void scatter(stage *s, uint64_t seed, size_t count, size_t wanted, unsigned kinds) {
    stage_dice dice = {seed * 7919 + 17};
    stage_look(s, 13, stage_throw(&dice, 0, 6.28), stage_throw(&dice, -0.6, 0.9));
    for (size_t i = 0; i < count; ++i) {
        uint32_t flags = i < wanted ? (uint32_t)REF_DYN_TARGET : 0u;
        double middle[3], half[3];
        for (int k = 0; k < 3; ++k) {
            middle[k] = stage_throw(&dice, -3.5, 3.5);
            half[k] = stage_throw(&dice, 0.3, 1.2);
        }
        if (!flags && (kinds & IMPENETRABLES) && stage_pick(&dice, 5) == 0)
            flags |= REF_DYN_IMPENETRABLE;
        size_t ring = stage_pick(&dice, 3);
        if (ring == 0 && (kinds & HOLLOWS))
            flags |= REF_DYN_HOLLOW;
        size_t at = ring == 0 ? stage_ring(s, flags, middle, 1.1, 0.4)
                              : stage_box(s, flags, middle, half, stage_throw(&dice, 0, 3));
        if (kinds & GROUPS) {
            s->marks[at].group = (uint32_t)stage_pick(&dice, 4);
            s->marks[at].rank = (int)stage_pick(&dice, 3);
        }
        if (!(flags & REF_DYN_TARGET) && (kinds & IMPORTANCES))
            s->marks[at].importance = stage_throw(&dice, 0, 1);
        if ((flags & REF_DYN_TARGET) && (kinds & LIGHTS))
            s->marks[at].flags |= REF_DYN_ACTIVE;
        if ((flags & REF_DYN_TARGET) && (kinds & FADES))
            s->marks[at].faded = stage_throw(&dice, 0, 1);
    }
    s->truth.light_count = kinds & LIGHTS ? 2 : 0;
    for (size_t i = 0; i < s->truth.light_count; ++i) {
        const ref_dyn_light light = {stage_throw(&dice, 20, 100), stage_throw(&dice, 20, 80), stage_throw(&dice, 0, 25),
                                     i ? stage_throw(&dice, 1, 20) : 0};
        s->lights[i] = light;
    }
    if (kinds & BACKDROPS) {
        const double middle[3] = {0, -6, 0}, half[3] = {9, 0.1, 9};
        stage_box(s, REF_DYN_BACKDROP, middle, half, 0);
    }
}

/* ---- trials ---- */

enum { GL33 = 0, ES = 1, REVERSED = 2, EIGHT_BITS = 4, GL45 = 8, SRGB = 16 };
enum { DITHER_FRAMES = 64 };

typedef struct trial {
    const char *name;
    tr_see see;
    unsigned kinds;
    ref_dyn_combine combine;
    ref_dyn_occluders occluders;
    uint32_t layers;
    int divisor;
    unsigned where;
    double allowed, share; /* 255ths that all pixels but this share of them keep to */
    ref_dyn_shape shape;
} trial;

typedef struct tally {
    size_t over, compared, see_through, unexplained;
    double most, left_out;
} tally;

static inline void draw_trial(harness *h, stage *s, const trial *t, uint64_t seed) {
    stage_clean(s);
    scatter(s, seed, 16, 1 + seed % 5, t->kinds);
    s->wish.mask_divisor = t->divisor;
    s->truth.combine = t->combine;
    s->truth.occluders = t->occluders;
    s->truth.layers = t->layers;
    s->truth.shape = t->shape;
    set_truth(s, t->see);
    s->srgb = t->where & SRGB;
    tr_result result = stage_draw_mean(h, s, t->where & REVERSED, t->see == TR_SEE_DITHER ? DITHER_FRAMES : 1);
    if (result != TR_OK)
        fail_msg("%s: %s", t->name, tr_result_string(result));
    stage_truth(s);
}

/* Pixels that are off by more than the truth itself changes when the picture moves by up to 1/60 pixel, within which
 * rasteriser and ray may disagree. One pixel of an outline decides over all that it is the nearest to: how much is seen
 * there, and by its depth of what. With a divisor the truth too takes the nearest pixel from the cells around. */
static inline size_t count_unexplained(stage *s, int divisor, double allowed) {
    enum { MOVES = 16 };
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height, count = 0;
    double *low = malloc(3 * pixels * sizeof *low), *high = malloc(3 * pixels * sizeof *high), kept[16];
    bool *off = malloc(pixels * sizeof *off);
    assert_true(low && high && off);
    memcpy(kept, s->scene.projection, sizeof kept);
    s->truth.cell = divisor;
    for (int move = 0; move <= MOVES; ++move) {
        double turn = 6.28318530717959 * move / MOVES, by = move ? 0.004 * (1 + move % 4) : 0;
        for (int c = 0; c < 4; ++c) {
            s->scene.projection[4 * c] = kept[4 * c] + 2 * by * cos(turn) / s->scene.width * kept[4 * c + 3];
            s->scene.projection[4 * c + 1] = kept[4 * c + 1] + 2 * by * sin(turn) / s->scene.height * kept[4 * c + 3];
        }
        stage_truth(s);
        for (size_t i = 0; i < 3 * pixels; ++i) {
            double value = stage_encode(s, s->pixels[i / 3].color[i % 3]);
            low[i] = move ? fmin(low[i], value) : value;
            high[i] = move ? fmax(high[i], value) : value;
        }
        for (size_t i = 0; !move && i < pixels; ++i)
            off[i] = !s->pixels[i].left_out;
    }
    for (size_t i = 0; i < pixels; ++i) {
        bool within = true;
        for (size_t c = 0; c < 3; ++c) {
            double is = s->picture[4 * i + c];
            within = within && is >= low[3 * i + c] - allowed - 1 && is <= high[3 * i + c] + allowed + 1;
        }
        count += off[i] && !within;
    }
    memcpy(s->scene.projection, kept, sizeof kept);
    s->truth.cell = 0;
    stage_truth(s);
    free(low);
    free(high);
    free(off);
    return count;
}

static inline void count_trial(stage *s, const trial *t, uint64_t seed, tally *all) {
    stage_error e = stage_compare(s, t->allowed);
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    if (e.over && t->shape == REF_DYN_OUTLINE)
        all->unexplained += count_unexplained(s, t->divisor, t->allowed);
    if (e.over > pixels / 500) {
        char name[96];
        snprintf(name, sizeof name, "%s_%d", t->name, (int)seed);
        write_pictures(s, name);
    }
    all->over += e.over;
    all->see_through += e.see_through;
    all->compared += pixels - (size_t)(e.left_out * (double)pixels + 0.5);
    all->most = fmax(all->most, e.largest);
    all->left_out += e.left_out;
}

static inline void run_trial(const trial *t, uint64_t seeds) {
    harness h;
    tr_desc desc;
    tally all = {0, 0, 0, 0, 0, 0};
    const tr_see_plan *plan;
    bool es = t->where & ES;
    memset(&desc, 0, sizeof desc);
    desc.reversed_z = (t->where & REVERSED) != 0;
    desc.eight_bits = (t->where & EIGHT_BITS) != 0;
    harness_open(&h, es ? 300 : t->where & GL45 ? 450 : 330, es, &desc);
    harness_target(&h, 128, 112);
    if (t->where & SRGB) {
        glBindTexture(GL_TEXTURE_2D, h.color);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 128, 112, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    stage *s = stage_new(120, 100);
    s->frame.x = 5;
    s->frame.y = 7;
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        draw_trial(&h, s, t, seed);
        count_trial(s, t, seed, &all);
        plan = tr_get_info(h.tr).see_plan;
        if (plan->see != TR_SEE_OFF && t->see >= TR_SEE_EXACT) /* which masks there are is said */
            assert_true((strstr(plan->why, "8 bits") != NULL) == ((t->where & EIGHT_BITS) != 0));
    }
    printf("    %-30s %5zu of %zu over %.1f/255, most %5.1f; %zu see-through, %.1f %% left out\n", t->name, all.over,
           all.compared, t->allowed, all.most, all.see_through, 100 * all.left_out / (double)seeds);
    assert_true(all.see_through > 100 * seeds);
    assert_true(all.left_out / (double)seeds <= 0.1);
    assert_true((double)all.over <= t->share * (double)all.compared);
    assert_int_equal(all.unexplained, 0);
    stage_free(s);
    harness_close(&h);
}

#define MIN_ REF_DYN_MIN
#define PRODUCT REF_DYN_PRODUCT
#define TOGETHER REF_DYN_TOGETHER
#define EACH REF_DYN_EACH
#define FEW 2.0e-3 /* all of them explained: see count_trial */
#define OUTLINE REF_DYN_OUTLINE

#endif
