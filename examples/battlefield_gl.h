/* battlefield_gl.h: a battlefield on the GPU: a vertex array a mesh and an instance a part, so that any set of parts is
 * drawn in one call a mesh. Needs the functions of GL 3.3 or ES 3.0, loaded by glad. */
#ifndef BATTLEFIELD_GL_H
#define BATTLEFIELD_GL_H

#include "battlefield.h"

typedef struct battlefield_instance {
    float rows[12]; /* of the transform to the world */
    float tint[3];
    uint32_t code; /* tr_unit_code: what shaders know of the part */
} battlefield_instance;

typedef struct battlefield_mesh {
    uint32_t array, buffer, indices;
    int index_count;
    float middle[3], radius; /* a sphere around it */
} battlefield_mesh;

typedef struct battlefield_gl {
    const battlefield *source;
    battlefield_mesh *meshes;
    battlefield_instance *instances, *staged; /* one a part; those of the next draw call */
    uint32_t *order, *all;
    size_t *starts; /* of each mesh's parts among the staged */
    size_t part_count, mesh_count, shown;
    uint32_t stream;
    bool plain;
    size_t draw_calls; /* so far; for whoever counts them */
} battlefield_gl;

/* Whether a picture is plain: each part in one colour, without shadows and haze, as the reference draws it. */
typedef struct battlefield_look {
    double view[16], projection[16], eye[3];
    double sun[3]; /* toward it, of length 1 */
    float cool[4], warm[4], background[3];
    float haze;           /* share of the light that is lost a metre */
    uint32_t shadow;      /* 0, or the depth texture of battlefield_gl_shadow */
    float sun_matrix[16]; /* world to the texture */
} battlefield_look;

/* False: out of memory; nothing is left. */
bool battlefield_gl_create(battlefield_gl *g, const battlefield *b, bool plain);
void battlefield_gl_destroy(battlefield_gl *g);

/* After battlefield_move: where everything is. */
void battlefield_gl_move(battlefield_gl *g);
void battlefield_gl_sphere(const battlefield_gl *g, size_t part, float center[3], float *radius);

/* Draws parts with the program in use; NULL: all that are not hidden. in_order: in that of the list, as few calls as
 * that allows; else a call a mesh. */
void battlefield_gl_draw(battlefield_gl *g, const uint32_t *parts, size_t count, bool in_order);

/* The program of the battlefield's shaders behind strings of the host's, the first of which is the #version; NULL: ours.
 * defines: lines of GLSL, "" for none. 0: message says why. */
typedef struct battlefield_strings {
    const char *const *vertex, *const *fragment;
    int vertex_count, fragment_count;
} battlefield_strings;
uint32_t battlefield_gl_program(const battlefield_strings *strings, bool es, const char *defines, char *message,
                                size_t message_size);
/* Uses the program and sets its uniforms. */
void battlefield_gl_use(const battlefield_look *look, uint32_t program);

/* Draws what the sun sees, of all parts, into a depth texture of size x size, made when look->shadow is 0. */
bool battlefield_gl_shadow(battlefield_gl *g, battlefield_look *look, uint32_t program, int size);

/* ---- cameras ---- */

/* Light and colours of the examples; no shadow. */
void battlefield_default_look(battlefield_look *look);
void battlefield_look_at(battlefield_look *look, const double eye[3], const double at[3]);
/* fov: of the shorter side, degrees. */
void battlefield_lens(battlefield_look *look, double fov, int width, int height, double nearest, double farthest);

#endif
