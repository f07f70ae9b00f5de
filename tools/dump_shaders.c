/* dump_shaders: writes the whole text of every stage of every built-in program, and of the strings for hosts, for each
 * GLSL version that may be met, into a folder, for glslangValidator.
 *
 * usage: dump_shaders FOLDER */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"
#define OIT_BUFFERS_IMPLEMENTATION
#include "oit_buffers.h"

/* A newer host may compile the same text as 430 or 310: what we write must be valid there too. */
static const struct {
    const char *name, *first_line;
    bool es;
} versions[] = {
    {"330", "#version 330 core\n", false},
    {"430", "#version 430 core\n", false},
    {"300es", "#version 300 es\n", true},
    {"310es", "#version 310 es\n", true},
};

static bool dump(const char *folder, const char *name, int version, bool reversed, tr_stage stage,
                 const tr_i_source *source, const char *host_main) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s_%s%s.%s", folder, name, versions[version].name, reversed ? "_reversed" : "",
             stage == TR_VERTEX ? "vert" : "frag");
    FILE *file = fopen(path, "w");
    if (!file) {
        perror(path);
        return false;
    }
    fputs(versions[version].first_line, file); /* in the place of strings[0] */
    for (int i = 1; i < source->count; ++i)
        fputs(source->strings[i], file);
    fputs(host_main, file);
    return fclose(file) == 0;
}

/* What a host would add to tr_glsl(). */
static const char *host_main(tr_stage stage, int rule) {
    if (stage == TR_VERTEX)
        return "in vec3 position;\nvoid main()\n{\n    gl_Position = vec4(position, 1.0);\n}\n";
    return rule < TR_RULE_COUNT ? "void main()\n{\n    tr_surface(vec4(0.5), 7u);\n}\n"
                                : "layout(location = 0) out highp vec4 seen;\nvoid main()\n{\n    highp vec4 color = "
                                  "vec4(0.5);\n    tr_see_through(color, 7u);\n    seen = color;\n}\n";
}

/* Compositions, lines and what takes opaque things: each switch in turn, on the plainest variant and on the fullest. */
static bool dump_variants(const char *folder, int version, bool reversed, tr_stage stage) {
    static const tr_i_variant variants[] = {{TR_I_COMPOSITION, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 1, 0, 1, 1, 2, 1, 0, 0, 1, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 1, 0, 1, 2, 0, 1, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 4, 1, 1, 8, 1, 1, 1, 1, 0, 0, 0, 0, 0},
                                            {TR_I_COMPOSITION, 2, 1, 0, 8, 2, 0, 1, 1, 0, 0, 0, 0, 0},
                                            {TR_I_LINE, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_LINE, 2, 1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1},
                                            {TR_I_LINE, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1},
                                            {TR_I_LINE, 2, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 2},
                                            {TR_I_LINE, 2, 0, 1, 0, 0, 0, 0, 0, 0, 1, 2, 1, 1},
                                            {TR_I_TAKE_OPAQUE, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                            {TR_I_TAKE_OPAQUE, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
    bool ok = true;
    for (size_t i = 0; ok && i < sizeof variants / sizeof variants[0]; ++i) {
        tr_i_source source;
        char name[32];
        tr_i_program_source(&source, TR_I_PROGRAM_VARIANT, tr_i_key_of(&variants[i]), stage, versions[version].es,
                            reversed);
        snprintf(name, sizeof name, "tr_variant_%02d", (int)i);
        ok = dump(folder, name, version, reversed, stage, &source, "");
    }
    return ok;
}

static bool dump_version(const char *folder, int version, bool reversed) {
    bool ok = true, es = versions[version].es;
    for (int stage = 0; stage < TR_STAGE_COUNT; ++stage) {
        tr_i_source source;
        char name[32];
        ok = ok && dump_variants(folder, version, reversed, (tr_stage)stage);
        for (int program = 0; program < TR_I_PROGRAM_COUNT; ++program) {
            if (program >= TR_I_PROGRAM_VARIANT && program < TR_I_PROGRAM_ALPHA)
                continue; /* those are made by key: above */
            tr_i_program_source(&source, program, 0, (tr_stage)stage, es, reversed);
            snprintf(name, sizeof name, "tr_program_%03d", program);
            ok = ok && dump(folder, name, version, reversed, (tr_stage)stage, &source, "");
        }
        for (int rule = 0; rule < TR_RULE_SEE_END; ++rule) {
            tr_i_host_source(&source, (tr_stage)stage, rule, es, reversed);
            snprintf(name, sizeof name, "tr_host_%d", rule);
            ok =
                ok && dump(folder, name, version, reversed, (tr_stage)stage, &source, host_main((tr_stage)stage, rule));
        }
    }
    return ok;
}

static bool dump_oit_stage(const char *folder, const char *name, const char *suffix, const oit_i_source *source,
                           const char *host_main) {
    char path[512];
    snprintf(path, sizeof path, "%s/%s.%s", folder, name, suffix);
    FILE *file = fopen(path, "w");
    if (!file) {
        perror(path);
        return false;
    }
    for (int i = 0; i < source->count; ++i)
        fputs(source->strings[i], file);
    fputs(host_main, file);
    return fclose(file) == 0;
}

/* Every program of oit_buffers.h, and what hosts get, for one choice of what is stored. */
static bool dump_oit(const char *folder, int choice, oit_desc desc, bool es) {
    static char preamble[OIT_I_MAX_PREAMBLE], scratch[OIT_I_NETWORK_CAPACITY];
    static const char *const suffixes[2] = {"vert", "frag"};
    bool ok = true;
    desc.uniform_binding = 14;
    oit_i_write_preamble(&desc, es, preamble, sizeof preamble);
    if (desc.store == OIT_STORE_FETCH) /* which oit_create finds out */
        strcat(preamble, "#define OIT_FETCHED 7\n");
    for (int program = 0; program < (desc.operators ? OIT_I_PROGRAMS : OIT_I_PROGRAM_SORT); ++program)
        for (int stage = 0; stage < (oit_i_is_compute(program) ? 1 : 2); ++stage) {
            if (!oit_i_has_program(&desc, program))
                continue;
            oit_i_source source;
            char name[64];
            oit_i_program_source(&source, program, (oit_stage)stage, &desc, es, preamble, scratch);
            snprintf(name, sizeof name, "oit_program_%02d_%d%s", program, choice, es ? "_310es" : "_430");
            ok = ok && dump_oit_stage(folder, name, oit_i_is_compute(program) ? "comp" : suffixes[stage], &source, "");
        }
    for (int fill = 0; fill < 2; ++fill) {
        oit_i_source source;
        char name[64];
        oit_i_host_source(&source, OIT_FRAGMENT, fill, &desc, es, preamble);
        snprintf(name, sizeof name, "oit_host_%d_%d%s", fill, choice, es ? "_310es" : "_430");
        ok = ok && dump_oit_stage(folder, name, "frag", &source, "void main()\n{\n    oit_store(vec4(0.5));\n}\n");
    }
    return ok;
}

static bool dump_all_oit(const char *folder) {
    static const oit_desc descs[] = {
        {.fit = OIT_FIT_WAIT},
        {.fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_ALL, .color = OIT_COLOR_HALF, .host_words = 3, .reversed_z = 1},
        {.fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_BLEND, .color = OIT_COLOR_FLOAT, .premultiplied = 1},
        {.fit = OIT_FIT_WAIT, .fields = OIT_FIELD_BLEND | OIT_FIELD_KEY},
        {.store = OIT_STORE_PREDICT},
        {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_ALL, .premultiplied = 1},
        {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC, .color = OIT_COLOR_FLOAT, .host_words = 1},
        {.store = OIT_STORE_LINKED},
        {.store = OIT_STORE_FETCH, .fields = OIT_FIELD_BLEND},
        {.store = OIT_STORE_LINKED, .fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_ALL, .host_words = 2},
        {.store = OIT_STORE_BUDGET, .reversed_z = 1},
        {.store = OIT_STORE_BUDGET, .fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_ALL, .premultiplied = 1},
        {.store = OIT_STORE_BUCKETED, .fields = OIT_FIELD_PART, .color = OIT_COLOR_FLOAT},
        {.store = OIT_STORE_BUCKETED, .fields = OIT_FIELD_ALL, .bucket_depth_bits = 16, .reversed_z = 1},
        {.fields = OIT_FIELD_COVERAGE | OIT_FIELD_BLEND, .sample_order = 1, .alpha_law = OIT_ALPHA_ADAPTIVE},
        {.fit = OIT_FIT_ASYNC, .color = OIT_COLOR_FLOAT, .premultiplied = 1, .alpha_law = OIT_ALPHA_ADAPTIVE},
        {.operators = OIT_OPERATE_ALL, .fields = OIT_FIELD_PART | OIT_FIELD_NORMAL},
        {.operators = OIT_OPERATE_ALL,
         .fields = OIT_FIELD_PART | OIT_FIELD_NORMAL | OIT_FIELD_UV | OIT_FIELD_BLEND,
         .fit = OIT_FIT_ASYNC,
         .store = OIT_STORE_BUDGET,
         .color = OIT_COLOR_HALF,
         .reversed_z = 1,
         .premultiplied = 1},
    };
    bool ok = true;
    for (int i = 0; ok && i < (int)(sizeof descs / sizeof descs[0]); ++i)
        ok = dump_oit(folder, i, descs[i], false) && dump_oit(folder, i, descs[i], true);
    return ok;
}

int main(int argc, char **argv) {
    bool ok = argc == 2;
    if (!ok)
        fprintf(stderr, "usage: dump_shaders FOLDER\n");
    for (int version = 0; ok && version < (int)(sizeof versions / sizeof versions[0]); ++version)
        ok = dump_version(argv[1], version, false) && dump_version(argv[1], version, true);
    ok = ok && dump_all_oit(argv[1]);
    return ok ? 0 : 1;
}
