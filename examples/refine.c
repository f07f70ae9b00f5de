#include "refine.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Midpoints by edge, open addressing; a slot is empty where its vertex is 0: a midpoint is never vertex 0. */
typedef struct midpoint {
    uint32_t low, high, vertex;
} midpoint;

typedef struct work {
    scene_mesh mesh;
    size_t vertex_capacity;
    midpoint *slots;
    size_t slot_count;
    double longest_squared;
} work;

static bool grow_vertices(work *w, size_t wanted) {
    float **arrays[3] = {&w->mesh.positions, &w->mesh.normals, &w->mesh.colors};
    if (wanted <= w->vertex_capacity)
        return true;
    size_t capacity = wanted + wanted / 2;
    for (int i = 0; i < 3; ++i) {
        if (i == 2 && !w->mesh.colors && w->vertex_capacity)
            continue;
        float *grown = realloc(*arrays[i], capacity * 3 * sizeof *grown);
        if (!grown)
            return false;
        *arrays[i] = grown;
    }
    w->vertex_capacity = capacity;
    return true;
}

static double length_squared(const work *w, uint32_t a, uint32_t b) {
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) {
        double d = (double)w->mesh.positions[3 * (size_t)a + k] - (double)w->mesh.positions[3 * (size_t)b + k];
        sum += d * d;
    }
    return sum;
}

/* The same from both sides of an edge, whatever its direction: halves are added in either order alike. */
static void put_midpoint(work *w, uint32_t a, uint32_t b, uint32_t at) {
    float *arrays[3] = {w->mesh.positions, w->mesh.normals, w->mesh.colors};
    for (int i = 0; i < 3; ++i)
        for (size_t k = 0; arrays[i] && k < 3; ++k)
            arrays[i][3 * (size_t)at + k] = 0.5f * arrays[i][3 * (size_t)a + k] + 0.5f * arrays[i][3 * (size_t)b + k];
}

/* The vertex in the middle of an edge that is too long; 0 where it is not. Vertices must have been reserved. */
static uint32_t split(work *w, uint32_t a, uint32_t b) {
    if (!(length_squared(w, a, b) > w->longest_squared))
        return 0;
    uint32_t low = a < b ? a : b, high = a < b ? b : a;
    size_t at = (size_t)((low * 0x9E3779B97F4A7C15u ^ high * 0xC2B2AE3D27D4EB4Fu) >> 20) & (w->slot_count - 1);
    while (w->slots[at].vertex && (w->slots[at].low != low || w->slots[at].high != high))
        at = (at + 1) & (w->slot_count - 1);
    if (!w->slots[at].vertex) {
        midpoint made = {low, high, (uint32_t)w->mesh.vertex_count++};
        w->slots[at] = made;
        put_midpoint(w, a, b, made.vertex);
    }
    return w->slots[at].vertex;
}

static uint32_t *put_triangle(uint32_t *out, uint32_t a, uint32_t b, uint32_t c) {
    out[0] = a, out[1] = b, out[2] = c;
    return out + 3;
}

/* Which diagonal cuts the quad a, b, bc, ca: a to bc, or b to ca. The shorter one; where they are equal the place of a
 * and b decides, so that the same triangle wound the other way, with vertices of its own, is cut alike. */
static bool cuts_from_first(const work *w, uint32_t a, uint32_t b, uint32_t bc, uint32_t ca) {
    double first = length_squared(w, a, bc), second = length_squared(w, b, ca);
    if (first != second)
        return first < second;
    for (size_t k = 0; k < 3; ++k) {
        float p = w->mesh.positions[3 * (size_t)a + k], q = w->mesh.positions[3 * (size_t)b + k];
        if (p != q)
            return p < q;
    }
    return true;
}

/* One triangle with the midpoints of its edges ab, bc, ca (0: whole): one to four triangles of the same winding. */
static uint32_t *divide(const work *w, uint32_t *out, const uint32_t v[3], const uint32_t m[3]) {
    int whole = !m[0] + !m[1] + !m[2], turn = 0;
    if (whole == 3)
        return put_triangle(out, v[0], v[1], v[2]);
    if (whole == 0) {
        out = put_triangle(out, v[0], m[0], m[2]);
        out = put_triangle(out, v[1], m[1], m[0]);
        out = put_triangle(out, v[2], m[2], m[1]);
        return put_triangle(out, m[0], m[1], m[2]);
    }
    /* Turn the triangle so that edge ab is the divided one of one, or the whole one of one. */
    while ((whole == 2) != (m[turn] != 0))
        ++turn;
    uint32_t a = v[turn], b = v[(turn + 1) % 3], c = v[(turn + 2) % 3];
    uint32_t ab = m[turn], bc = m[(turn + 1) % 3], ca = m[(turn + 2) % 3];
    if (whole == 2) {
        out = put_triangle(out, a, ab, c);
        return put_triangle(out, ab, b, c);
    }
    out = put_triangle(out, c, ca, bc);
    if (cuts_from_first(w, a, b, bc, ca)) {
        out = put_triangle(out, a, b, bc);
        return put_triangle(out, a, bc, ca);
    }
    out = put_triangle(out, ca, a, b);
    return put_triangle(out, ca, b, bc);
}

/* One round. *changed: whether an edge was divided. */
static bool refine_once(work *w, bool *changed) {
    size_t before = w->mesh.vertex_count, triangles = w->mesh.index_count / 3, slots = 16;
    while (slots < 6 * triangles)
        slots *= 2;
    w->slot_count = slots;
    w->slots = calloc(slots, sizeof *w->slots);
    uint32_t *divided = malloc((12 * triangles + 1) * sizeof *divided), *end = divided;
    bool ok = w->slots && divided && grow_vertices(w, before + 3 * triangles);
    for (size_t t = 0; ok && t < triangles; ++t) {
        const uint32_t *v = w->mesh.indices + 3 * t;
        const uint32_t m[3] = {split(w, v[0], v[1]), split(w, v[1], v[2]), split(w, v[2], v[0])};
        end = divide(w, end, v, m);
    }
    free(w->slots);
    if (!ok) {
        free(divided);
        return false;
    }
    free(w->mesh.indices);
    w->mesh.indices = divided;
    w->mesh.index_count = (size_t)(end - divided);
    *changed = w->mesh.vertex_count != before;
    return true;
}

static void drop(scene_mesh *mesh) {
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->colors);
    free(mesh->indices);
    memset(mesh, 0, sizeof *mesh);
}

static bool copy_in(work *w, const scene_mesh *in) {
    size_t bytes = in->vertex_count * 3 * sizeof(float);
    w->mesh.indices = malloc((in->index_count + 1) * sizeof *w->mesh.indices);
    if (!w->mesh.indices || !grow_vertices(w, in->vertex_count + 1))
        return false;
    memcpy(w->mesh.positions, in->positions, bytes);
    memcpy(w->mesh.normals, in->normals, bytes);
    if (in->colors) {
        memcpy(w->mesh.colors, in->colors, bytes);
    } else {
        free(w->mesh.colors);
        w->mesh.colors = NULL;
    }
    memcpy(w->mesh.indices, in->indices, in->index_count * sizeof *in->indices);
    w->mesh.vertex_count = in->vertex_count;
    w->mesh.index_count = in->index_count - in->index_count % 3;
    w->mesh.two_sided = in->two_sided;
    return true;
}

bool refine_mesh(const scene_mesh *in, double longest_edge, size_t most_triangles, scene_mesh *out) {
    work w;
    bool changed = longest_edge > 0;
    memset(&w, 0, sizeof w);
    w.longest_squared = longest_edge * longest_edge;
    bool ok = copy_in(&w, in);
    /* A round makes at most four of each triangle. */
    while (ok && changed && w.mesh.index_count / 3 * 4 <= most_triangles)
        ok = refine_once(&w, &changed);
    if (!ok)
        drop(&w.mesh);
    *out = w.mesh;
    return ok;
}
