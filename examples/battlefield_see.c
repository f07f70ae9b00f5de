#include "battlefield_see.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glad/gl.h>

bool battlefield_see_create(battlefield_see *see, tr_context *tr, battlefield_gl *gl, bool es, const char *defines) {
    memset(see, 0, sizeof *see);
    see->tr = tr;
    see->gl = gl;
    see->es = es;
    see->defines = defines;
    see->units = calloc(gl->part_count + 1, sizeof *see->units);
    see->drawn = calloc(gl->part_count + 1, sizeof *see->drawn);
    if (!see->units || !see->drawn) {
        battlefield_see_destroy(see);
        return false;
    }
    battlefield_see_move(see);
    return true;
}

void battlefield_see_destroy(battlefield_see *see) {
    for (int rule = 0; rule < TR_RULE_SEE_END; rule++)
        if (see->programs[rule])
            glDeleteProgram(see->programs[rule]);
    free(see->units);
    free(see->drawn);
    memset(see, 0, sizeof *see);
}

void battlefield_see_code(battlefield_see *see) {
    for (size_t i = 0; i < see->unit_count; i++)
        see->gl->instances[see->gl->all[i]].code = tr_unit_code(&see->units[i]);
}

void battlefield_see_move(battlefield_see *see) {
    see->unit_count = see->gl->shown;
    for (size_t i = 0; i < see->unit_count; i++) {
        uint32_t part = see->gl->all[i];
        const battlefield_object *object = &see->gl->source->objects[part];
        tr_unit *unit = &see->units[i];
        unit->id = part + 1;
        unit->flags = (object->flags & BATTLEFIELD_TARGET ? TR_UNIT_TARGET : 0u) |
                      (object->flags & BATTLEFIELD_IMPENETRABLE ? TR_UNIT_IMPENETRABLE : 0u) |
                      (object->flags & BATTLEFIELD_HOLLOW ? TR_UNIT_HOLLOW : 0u) |
                      (object->flags & BATTLEFIELD_BACKDROP ? TR_UNIT_BACKDROP : 0u) | (unit->flags & TR_UNIT_ACTIVE);
        unit->importance = object->importance;
        unit->group = object->group;
        unit->rank = object->rank;
        battlefield_gl_sphere(see->gl, part, unit->center, &unit->radius);
    }
    battlefield_see_code(see);
}

/* Built when a rule is first met. */
static uint32_t program_of(battlefield_see *see, tr_rule rule, char *message, size_t size) {
    if (see->programs[rule])
        return see->programs[rule];
    battlefield_strings strings = {NULL, NULL, 0, 0};
    char defines[256];
    strings.vertex = tr_glsl(see->tr, TR_VERTEX, rule, &strings.vertex_count);
    strings.fragment = tr_glsl(see->tr, TR_FRAGMENT, rule, &strings.fragment_count);
    /* In that rule location 1 is the header's. */
    snprintf(defines, sizeof defines, "%s#define SEE_THROUGH\n%s", see->defines,
             rule == TR_RULE_SEE_PEEL ? "#define ONE_OUTPUT\n" : "");
    see->programs[rule] = rule == TR_RULE_SEE_PLAIN ? battlefield_gl_program(NULL, see->es, see->defines, message, size)
                                                    : battlefield_gl_program(&strings, see->es, defines, message, size);
    if (see->programs[rule] && rule != TR_RULE_SEE_PLAIN)
        tr_prepare_program(see->tr, see->programs[rule]);
    return see->programs[rule];
}

static void draw_pass(battlefield_see *see, const battlefield_look *look, const tr_pass *pass, uint32_t program,
                      bool in_order) {
    if (pass->kind == TR_PASS_SCENE && see->draw_scene) {
        see->draw_scene(see, look, program, see->user);
        return;
    }
    battlefield_gl_use(look, program);
    for (size_t i = 0; i < pass->unit_count; i++)
        see->drawn[i] = see->gl->all[pass->units[i]];
    if (see->draw_all && !in_order)
        battlefield_gl_draw(see->gl, NULL, 0, false);
    else
        battlefield_gl_draw(see->gl, see->drawn, pass->unit_count, in_order);
}

bool battlefield_see_draw(battlefield_see *see, const battlefield_look *look, const tr_frame *frame, tr_dynamic *wish,
                          char *message, size_t message_size) {
    tr_pass pass;
    bool ok = true;
    wish->units = see->units;
    wish->unit_count = see->unit_count;
    wish->unit_stride = sizeof *see->units;
    for (int i = 0; i < 16; i++) {
        wish->view[i] = (float)look->view[i];
        wish->projection[i] = (float)look->projection[i];
    }
    tr_result result = tr_begin_dynamic(see->tr, frame, wish);
    if (result != TR_OK) {
        snprintf(message, message_size, "%s", tr_result_string(result));
        return false;
    }
    tr_see chosen = tr_get_info(see->tr).see_plan->see;
    bool in_order = chosen == TR_SEE_SEQUENCE || chosen == TR_SEE_PUBLISHED;
    while (ok && tr_next_pass(see->tr, &pass)) {
        uint32_t program = program_of(see, pass.rule, message, message_size);
        ok = program != 0;
        if (ok)
            draw_pass(see, look, &pass, program, in_order && pass.kind != TR_PASS_SCENE);
    }
    result = tr_end(see->tr);
    if (ok && result != TR_OK) {
        snprintf(message, message_size, "%s", tr_result_string(result));
        ok = false;
    }
    return ok;
}
