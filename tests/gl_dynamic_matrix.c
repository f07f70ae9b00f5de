/* Every rung of dynamic transparency in every kind of context and target, against the truth per pixel of
 * reference_dynamic.h: of sequences that by objects' middles, of one mask and of dithering's mean that under one mask. */
#include "dynamic_trials.h"

static const char *const see_names[] = {"one mask", "dither", "exact", "sequence", "published"};

/* What a picture may be off by, in 255ths: two roundings to 8 bits; of dithering also what is left of the noise in the mean
 * of 64 frames. Into sRGB targets a step in the dark is many of light, and what shows through is encoded once more. */
static double allowed_of(tr_see see, unsigned where) {
    double roundings = see == TR_SEE_EXACT || see == TR_SEE_ONE_MASK ? 2.5 : 3;
    return roundings + (see == TR_SEE_DITHER ? 5 : 0) + (where & SRGB ? 1.5 : 0);
}

static void try_contexts(unsigned kinds, const unsigned *where, const char *const *names, size_t count) {
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
        for (size_t i = 0; i < count; ++i) {
            bool published = see == TR_SEE_PUBLISHED;
            char name[64];
            snprintf(name, sizeof name, "%s, %s", see_names[see], names[i]);
            const trial t = {
                name,   (tr_see)see, kinds,    published ? PRODUCT : MIN_,        published ? EACH : TOGETHER,
                0,      1,           where[i], allowed_of((tr_see)see, where[i]), FEW,
                OUTLINE};
            run_trial(&t, 5);
        }
}

static void rungs_are_right_in_every_context(void **state) {
    static const unsigned where[] = {
        GL33, GL45, ES, GL33 | EIGHT_BITS, GL45 | EIGHT_BITS, ES | EIGHT_BITS, REVERSED, REVERSED | EIGHT_BITS};
    static const char *const names[] = {"GL 3.3",         "GL 4.5",         "ES 3.0",   "GL 3.3, 8 bits",
                                        "GL 4.5, 8 bits", "ES 3.0, 8 bits", "reversed", "reversed, 8 bits"};
    (void)state;
    try_contexts(IMPENETRABLES | FADES, where, names, sizeof where / sizeof where[0]);
}

static void rungs_are_right_into_srgb(void **state) {
    static const unsigned where[] = {SRGB, SRGB | GL45, SRGB | ES, SRGB | EIGHT_BITS};
    static const char *const names[] = {"GL 3.3, sRGB", "GL 4.5, sRGB", "ES 3.0, sRGB", "GL 3.3, sRGB, 8 bits"};
    (void)state;
    try_contexts(IMPENETRABLES, where, names, sizeof where / sizeof where[0]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rungs_are_right_in_every_context),
                                       cmocka_unit_test(rungs_are_right_into_srgb)};
    if (getenv("GLASSINE_TEST"))
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}
