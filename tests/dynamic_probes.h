/* dynamic_probes.h: the scenes of probes_dynamic.h as fields, for the reference and for GL. */
#ifndef GLASSINE_TESTS_DYNAMIC_PROBES_H
#define GLASSINE_TESTS_DYNAMIC_PROBES_H

#include "dynamic_scene.h"
#include "probes_dynamic.h"

/* Growing arrays of one object's triangles, each with both windings: every part is seen from both sides. */
typedef struct probe_mesh {
    float *positions;
    uint32_t *indices;
    size_t vertex_count, index_count;
} probe_mesh;

static inline uint32_t probe_vertex(probe_mesh *m, const double p[3]) {
    m->positions = realloc(m->positions, 3 * (m->vertex_count + 1) * sizeof *m->positions);
    assert_non_null(m->positions);
    for (size_t k = 0; k < 3; ++k)
        m->positions[3 * m->vertex_count + k] = (float)p[k];
    return (uint32_t)m->vertex_count++;
}

static inline void probe_triangle(probe_mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t both[6] = {a, b, c, a, c, b};
    m->indices = realloc(m->indices, (m->index_count + 6) * sizeof *m->indices);
    assert_non_null(m->indices);
    memcpy(m->indices + m->index_count, both, sizeof both);
    m->index_count += 6;
}

/* Perpendicular to an axis, at the place that a has along it. */
static inline void probe_rectangle(probe_mesh *m, const double a[3], const double b[3], int axis) {
    uint32_t v[4];
    for (int i = 0; i < 4; ++i) {
        int u = (axis + 1) % 3, w = (axis + 2) % 3;
        double p[3];
        p[axis] = a[axis];
        p[u] = i == 1 || i == 2 ? b[u] : a[u];
        p[w] = i >= 2 ? b[w] : a[w];
        v[i] = probe_vertex(m, p);
    }
    probe_triangle(m, v[0], v[1], v[2]);
    probe_triangle(m, v[0], v[2], v[3]);
}

/* So fine that no probe is nearer to the true outline than to the polyhedron's. */
static inline void probe_sphere(probe_mesh *m, const double center[3], double radius) {
    enum { RINGS = 48, SECTORS = 96 };
    uint32_t first = (uint32_t)m->vertex_count;
    for (int ring = 0; ring <= RINGS; ++ring)
        for (int sector = 0; sector < SECTORS; ++sector) {
            double polar = 3.14159265358979 * ring / RINGS, turn = 6.28318530717959 * sector / SECTORS;
            const double p[3] = {center[0] + radius * sin(polar) * cos(turn),
                                 center[1] + radius * sin(polar) * sin(turn), center[2] + radius * cos(polar)};
            probe_vertex(m, p);
        }
    for (uint32_t ring = 0; ring < RINGS; ++ring)
        for (uint32_t sector = 0; sector < SECTORS; ++sector) {
            uint32_t a = first + ring * SECTORS + sector, b = first + ring * SECTORS + (sector + 1) % SECTORS;
            probe_triangle(m, a, a + SECTORS, b + SECTORS);
            probe_triangle(m, a, b + SECTORS, b);
        }
}

static inline void probe_part_mesh(probe_mesh *m, const dyn_probe_part *p) {
    if (p->kind == DYN_PROBE_SPHERE)
        probe_sphere(m, p->a, p->b[0]);
    for (int axis = 0; p->kind != DYN_PROBE_SPHERE && axis < 3; ++axis) {
        bool flat = !(p->a[axis] < p->b[axis]) && !(p->a[axis] > p->b[axis]);
        if (p->kind == DYN_PROBE_BOX || flat)
            probe_rectangle(m, p->a, p->b, axis);
        if (p->kind == DYN_PROBE_BOX)
            probe_rectangle(m, p->b, p->a, axis);
    }
}

static inline battlefield *probe_field(const dyn_probe_scene *s) {
    battlefield *b = dynamic_empty_field();
    for (int o = 0; o < s->object_count; ++o) {
        const dyn_probe_object *from = &s->objects[o];
        probe_mesh m = {NULL, NULL, 0, 0};
        scene_mesh made;
        float color[3];
        for (int i = 0; i < from->part_count; ++i)
            probe_part_mesh(&m, &from->parts[i]);
        memset(&made, 0, sizeof made);
        made.positions = m.positions;
        made.indices = m.indices;
        made.vertex_count = m.vertex_count;
        made.index_count = m.index_count;
        made.normals = dynamic_need(3 * m.vertex_count * sizeof *made.normals);
        for (size_t v = 0; v < m.vertex_count; ++v) /* of no account: colours are flat */
            made.normals[3 * v + 2] = 1;
        for (int k = 0; k < 3; ++k)
            color[k] = (float)from->color[k];
        size_t mesh = scene_add_mesh(b->scene, from->name, &made);
        assert_true(mesh != SIZE_MAX);
        dynamic_add(b, mesh, NULL, color, 0);
    }
    return b;
}

/* What the eye sees, in the convention of probes_dynamic.h: depth grows away from it. */
static inline void probe_look(dynamic_scene *d, const dyn_probe_scene *s) {
    double *v = d->look.view, *p = d->look.projection, nearest = s->perspective ? 0.25 : -1, farthest = 256;
    memset(v, 0, 16 * sizeof *v);
    memset(p, 0, 16 * sizeof *p);
    v[0] = v[5] = v[15] = 1;
    v[10] = -1;
    p[0] = 2 / (double)s->width;
    p[5] = 2 / (double)s->height;
    if (s->perspective) {
        p[0] *= s->focal;
        p[5] *= s->focal;
        p[10] = -(farthest + nearest) / (farthest - nearest);
        p[11] = -1;
        p[14] = -2 * farthest * nearest / (farthest - nearest);
    } else {
        p[10] = -2 / (farthest - nearest);
        p[12] = p[13] = -1;
        p[14] = -(farthest + nearest) / (farthest - nearest);
        p[15] = 1;
    }
    memcpy(d->scene.view, v, sizeof d->scene.view);
    memcpy(d->scene.projection, p, sizeof d->scene.projection);
    d->scene.width = s->width;
    d->scene.height = s->height;
}

static inline ref_dyn_object probe_mark(const dyn_probe_object *o) {
    ref_dyn_object mark;
    memset(&mark, 0, sizeof mark);
    mark.flags = (o->flags & DYN_PROBE_TARGET ? REF_DYN_TARGET : 0u) |
                 (o->flags & DYN_PROBE_IMPENETRABLE ? REF_DYN_IMPENETRABLE : 0u) |
                 (o->flags & DYN_PROBE_HOLLOW ? REF_DYN_HOLLOW : 0u) |
                 (o->flags & DYN_PROBE_BACKDROP ? REF_DYN_BACKDROP : 0u) |
                 (o->flags & DYN_PROBE_ACTIVE ? REF_DYN_ACTIVE : 0u);
    mark.importance = o->importance;
    mark.group = (uint32_t)o->group;
    mark.rank = o->rank;
    return mark;
}

/* lights: room for TR_MAX_LIGHTS, as long as d. */
static inline void probe_open(dynamic_scene *d, harness *h, const dyn_probe_scene *s, ref_dyn_light *lights) {
    dynamic_open(d, h, probe_field(s));
    dynamic_shade(d, true);
    probe_look(d, s);
    for (int k = 0; k < 3; ++k) {
        d->look.background[k] = (float)s->background[k];
        d->scene.background[k] = s->background[k];
    }
    for (int o = 0; o < s->object_count; ++o)
        d->marks[o] = probe_mark(&s->objects[o]);
    d->truth.alpha_target = s->alpha_t;
    d->truth.alpha_start = s->alpha_0;
    d->truth.width = s->gradient;
    d->truth.combine = s->combine == DYN_PROBE_PRODUCT ? REF_DYN_PRODUCT : REF_DYN_MIN;
    d->truth.occluders = s->occluders == DYN_PROBE_EACH ? REF_DYN_EACH : REF_DYN_TOGETHER;
    d->truth.layers = (uint32_t)s->layers;
    for (int i = 0; i < s->light_count; ++i) {
        lights[i].x = s->lights[i].x;
        lights[i].y = s->lights[i].y;
        lights[i].radius = s->lights[i].radius;
        lights[i].edge = s->lights[i].soft;
    }
    d->truth.lights = lights;
    d->truth.light_count = (size_t)s->light_count;
}

#endif
