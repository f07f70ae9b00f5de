/* battlefield_see.h: a battlefield drawn with dynamic transparency: what a game writes around transparency.h. */
#ifndef BATTLEFIELD_SEE_H
#define BATTLEFIELD_SEE_H

#include "battlefield_gl.h"
#include "transparency.h"

typedef struct battlefield_see {
    tr_context *tr;
    battlefield_gl *gl;
    tr_unit *units; /* of the parts that are not hidden, in the order of gl->all */
    size_t unit_count;
    uint32_t *drawn;                    /* parts that a pass draws */
    uint32_t programs[TR_RULE_SEE_END]; /* 0: not met yet */
    const char *defines;
    bool es;
    bool draw_all; /* in passes of any order: a host whose batches hold more than is asked for */
    /* What the host does in TR_PASS_SCENE: NULL: draws all with the program of the rule. */
    void (*draw_scene)(struct battlefield_see *see, const battlefield_look *look, uint32_t program, void *user);
    void *user;
} battlefield_see;

/* tr stays the caller's. defines: of the battlefield's shaders, kept. False: out of memory. */
bool battlefield_see_create(battlefield_see *see, tr_context *tr, battlefield_gl *gl, bool es, const char *defines);
void battlefield_see_destroy(battlefield_see *see);

/* After battlefield_gl_move: bounds, flags and the numbers that shaders know units by. Fades stay. */
void battlefield_see_move(battlefield_see *see);
/* Alone, where flags, importances or fades of see->units were changed by hand. */
void battlefield_see_code(battlefield_see *see);

/* A frame into what is bound and cleared; of `wish`, units and matrices are filled in. message: why it failed. */
bool battlefield_see_draw(battlefield_see *see, const battlefield_look *look, const tr_frame *frame, tr_dynamic *wish,
                          char *message, size_t message_size);

#endif
