#include "kaykit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "load_model.h"

enum { CONIFER, BROADLEAF, COTTAGE, TAVERN, BARRACKS, CHURCH, KINDS };
static const char *const FILES[KINDS] = {"tree_single_A",        "tree_single_B",          "building_home_A_blue",
                                         "building_tavern_blue", "building_barracks_blue", "building_church_blue"};

typedef struct prop {
    size_t mesh;
    double low[3], high[3];
} prop;

/* ---- one mesh of a file ---------------------------------------------------------------------------------- */

static bool make_room(scene_mesh *m, size_t vertices, size_t indices) {
    m->positions = malloc((3 * vertices + 1) * sizeof *m->positions);
    m->normals = malloc((3 * vertices + 1) * sizeof *m->normals);
    m->colors = malloc((3 * vertices + 1) * sizeof *m->colors);
    m->indices = malloc((indices + 1) * sizeof *m->indices);
    return m->positions && m->normals && m->colors && m->indices;
}

/* Vectors of a file, y up, into ours. Its transforms are turns, moves and even scales. */
static void add_vector(const double m[16], const float v[3], double w, bool y_up, float out[3]) {
    double p[3];
    for (int r = 0; r < 3; r++)
        p[r] = m[r] * (double)v[0] + m[4 + r] * (double)v[1] + m[8 + r] * (double)v[2] + w * m[12 + r];
    out[0] = (float)p[0];
    out[1] = (float)(y_up ? -p[2] : p[1]);
    out[2] = (float)(y_up ? p[1] : p[2]);
}

static void add_part(scene_mesh *m, const scene *from, const scene_part *part) {
    const scene_mesh *mesh = &from->meshes[part->mesh];
    size_t base = m->vertex_count;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        size_t at = 3 * (base + v);
        add_vector(part->transform, mesh->positions + 3 * v, 1, from->up_axis == 1, m->positions + at);
        add_vector(part->transform, mesh->normals + 3 * v, 0, from->up_axis == 1, m->normals + at);
        memcpy(m->colors + at, mesh->colors ? mesh->colors + 3 * v : part->color, 3 * sizeof(float));
    }
    for (size_t i = 0; i < mesh->index_count; i++)
        m->indices[m->index_count + i] = (uint32_t)base + mesh->indices[i];
    m->vertex_count += mesh->vertex_count;
    m->index_count += mesh->index_count;
}

static bool add_scene(scene *into, const scene *from, const char *name, prop *p) {
    scene_mesh made = {0};
    size_t vertices = 0, indices = 0;
    for (size_t i = 0; i < from->part_count; i++) {
        vertices += from->meshes[from->parts[i].mesh].vertex_count;
        indices += from->meshes[from->parts[i].mesh].index_count;
    }
    if (!make_room(&made, vertices, indices)) {
        free(made.positions);
        free(made.normals);
        free(made.colors);
        free(made.indices);
        return false;
    }
    for (size_t i = 0; i < from->part_count; i++)
        add_part(&made, from, &from->parts[i]);
    for (size_t i = 0; i < 3 * vertices; i++) {
        double x = (double)made.positions[i];
        p->low[i % 3] = i < 3 ? x : fmin(p->low[i % 3], x);
        p->high[i % 3] = i < 3 ? x : fmax(p->high[i % 3], x);
    }
    p->mesh = scene_add_mesh(into, name, &made);
    return p->mesh != SIZE_MAX;
}

static bool load_prop(scene *into, const char *folder, const char *name, prop *p, char *message, size_t size) {
    char path[4096], why[256] = "";
    load_report report;
    snprintf(path, sizeof path, "%s/%s.obj", folder, name);
    scene *from = load_model(path, &report, why, sizeof why);
    if (!from) {
        snprintf(message, size, "%s.obj: %s", name, why);
        return false;
    }
    bool ok = add_scene(into, from, name, p) && p->high[2] > p->low[2];
    if (!ok)
        snprintf(message, size, "%s.obj: out of memory, or nothing in it", name);
    scene_destroy(from);
    return ok;
}

/* ---- places ---------------------------------------------------------------------------------------------- */

static void extent(const scene_mesh *mesh, size_t axis, double *low, double *high) {
    *low = *high = 0;
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double x = (double)mesh->positions[3 * v + axis];
        *low = v ? fmin(*low, x) : x;
        *high = v ? fmax(*high, x) : x;
    }
}

/* Puts the prop where the part is, `scale` as large. */
static void swap_mesh(scene_part *part, const prop *p, const double transform[16], double scale) {
    part->mesh = p->mesh;
    for (int i = 0; i < 16; i++)
        part->transform[i] = transform[i] * (i < 12 ? scale : 1);
}

static void swap_tree(const scene *s, scene_part *part, const prop *p) {
    double low, high;
    extent(&s->meshes[part->mesh], 2, &low, &high);
    swap_mesh(part, p, part->transform, 0.9 * (high - low) / (p->high[2] - p->low[2]));
}

/* A building's floor stays, its roof becomes the house, its walls go. The roof is the last of its parts. */
static void swap_house(battlefield *b, size_t floor_part, const prop *p) {
    scene *s = b->scene;
    double low, high, depth_low, depth_high;
    extent(&s->meshes[s->parts[floor_part].mesh], 0, &low, &high);
    extent(&s->meshes[s->parts[floor_part].mesh], 1, &depth_low, &depth_high);
    double scale = fmin((high - low) / (p->high[0] - p->low[0]), (depth_high - depth_low) / (p->high[1] - p->low[1]));
    size_t last = floor_part;
    for (size_t i = floor_part + 1; i < s->part_count && b->objects[i].group == b->objects[floor_part].group; i++) {
        s->parts[i].hidden = true;
        last = i;
    }
    s->parts[last].hidden = false;
    swap_mesh(&s->parts[last], p, s->parts[floor_part].transform, scale);
}

bool kaykit_replace(battlefield *b, const char *folder, char *message, size_t message_size) {
    static const int houses[4] = {COTTAGE, TAVERN, COTTAGE, CHURCH};
    prop props[KINDS];
    size_t count = 0;
    for (size_t i = 0; i < KINDS; i++)
        if (!load_prop(b->scene, folder, FILES[i], &props[i], message, message_size))
            return false;
    for (size_t i = 0; i < b->scene->part_count; i++) {
        scene_part *part = &b->scene->parts[i];
        if (strstr(part->name, "forest/conifer"))
            swap_tree(b->scene, part, &props[CONIFER]);
        else if (strstr(part->name, "forest/broadleaf"))
            swap_tree(b->scene, part, &props[BROADLEAF]);
        else if (b->objects[i].group && b->objects[i].rank == 0)
            swap_house(b, i, &props[strstr(part->name, "barn") ? BARRACKS : houses[count++ % 4]]);
    }
    return true;
}
