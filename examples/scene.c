#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- life and parts -------------------------------------------------------------------------------------- */

scene *scene_create(void) {
    scene *made = calloc(1, sizeof *made);
    if (made)
        made->up_axis = 2;
    return made;
}

static void free_mesh(scene_mesh *mesh) {
    free(mesh->name);
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->colors);
    free(mesh->indices);
}

void scene_destroy(scene *s) {
    if (!s)
        return;
    for (size_t i = 0; i < s->mesh_count; i++)
        free_mesh(&s->meshes[i]);
    for (size_t i = 0; i < s->part_count; i++)
        free(s->parts[i].name);
    free(s->meshes);
    free(s->parts);
    free(s->name_slots);
    free(s);
}

static char *copy_name(const char *name) {
    size_t size = strlen(name) + 1;
    char *copy = malloc(size);
    if (copy)
        memcpy(copy, name, size);
    return copy;
}

/* Room for one more element. Counts of powers of two are where the array grows, so no capacity is stored. */
static bool grow(void **array, size_t count, size_t element) {
    if (count & (count - 1))
        return true;
    size_t capacity = count ? 2 * count : 1;
    if (capacity > SIZE_MAX / element)
        return false;
    void *bigger = realloc(*array, capacity * element);
    if (bigger)
        *array = bigger;
    return bigger != NULL;
}

size_t scene_add_mesh(scene *s, const char *name, const scene_mesh *arrays) {
    scene_mesh mesh = *arrays;
    mesh.name = copy_name(name);
    void *meshes = s->meshes;
    if (!mesh.name || !grow(&meshes, s->mesh_count, sizeof mesh)) {
        free_mesh(&mesh);
        return SIZE_MAX;
    }
    s->meshes = meshes;
    s->meshes[s->mesh_count] = mesh;
    return s->mesh_count++;
}

static size_t hash_name(const char *name) {
    uint64_t hash = 14695981039346656037u;
    for (; *name; name++)
        hash = (hash ^ (unsigned char)*name) * 1099511628211u;
    return (size_t)(hash ^ hash >> 32);
}

/* The slot where the name is, or the empty one where it would go. */
static size_t name_slot(const scene *s, const char *name) {
    size_t slot = hash_name(name) & (s->name_slot_count - 1);
    while (s->name_slots[slot] != UINT32_MAX && strcmp(s->parts[s->name_slots[slot]].name, name) != 0)
        slot = (slot + 1) & (s->name_slot_count - 1);
    return slot;
}

size_t scene_find_part(const scene *s, const char *name) {
    uint32_t found = s->name_slot_count ? s->name_slots[name_slot(s, name)] : UINT32_MAX;
    return found == UINT32_MAX ? SIZE_MAX : found;
}

/* Room for one more name at a load of at most one half. */
static bool grow_names(scene *s) {
    if (2 * (s->part_count + 1) <= s->name_slot_count)
        return true;
    size_t count = s->name_slot_count ? 2 * s->name_slot_count : 16;
    uint32_t *slots = malloc(count * sizeof *slots);
    if (!slots)
        return false;
    memset(slots, 0xff, count * sizeof *slots);
    free(s->name_slots);
    s->name_slots = slots;
    s->name_slot_count = count;
    for (size_t i = 0; i < s->part_count; i++)
        slots[name_slot(s, s->parts[i].name)] = (uint32_t)i;
    return true;
}

static bool number_taken(const scene *s, const char *name, size_t number, char *buffer, size_t size) {
    snprintf(buffer, size, "%s#%zu", name, number);
    return scene_find_part(s, buffer) != SIZE_MAX;
}

/* The number goes up by doubling and comes down by halves, as a file may have very many parts of one name. */
static char *unique_name(const scene *s, const char *name) {
    if (scene_find_part(s, name) == SIZE_MAX)
        return copy_name(name);
    size_t size = strlen(name) + 24, taken = 1, unused = 2;
    char *buffer = malloc(size);
    if (!buffer)
        return NULL;
    while (number_taken(s, name, unused, buffer, size)) {
        taken = unused;
        unused *= 2;
    }
    while (unused - taken > 1) {
        size_t middle = taken + (unused - taken) / 2;
        if (number_taken(s, name, middle, buffer, size))
            taken = middle;
        else
            unused = middle;
    }
    snprintf(buffer, size, "%s#%zu", name, unused);
    return buffer;
}

size_t scene_add_part(scene *s, const char *name, size_t mesh, const double transform[16], const float color[3]) {
    scene_part part = {.mesh = mesh, .opacity = 1};
    for (size_t i = 0; i < 16; i++) /* copied before the parts move: the arguments may come from one of them */
        part.transform[i] = transform ? transform[i] : (i % 5 == 0 ? 1 : 0);
    memcpy(part.color, color, sizeof part.color);
    part.name = unique_name(s, name);
    void *parts = s->parts;
    if (!part.name || !grow_names(s) || !grow(&parts, s->part_count, sizeof part)) {
        free(part.name);
        return SIZE_MAX;
    }
    s->parts = parts;
    s->parts[s->part_count] = part;
    s->name_slots[name_slot(s, part.name)] = (uint32_t)s->part_count;
    return s->part_count++;
}

void scene_multiply(const double a[16], const double b[16], double product[16]) {
    double result[16];
    for (size_t column = 0; column < 4; column++)
        for (size_t row = 0; row < 4; row++) {
            double sum = 0;
            for (size_t i = 0; i < 4; i++)
                sum += a[4 * i + row] * b[4 * column + i];
            result[4 * column + row] = sum;
        }
    memcpy(product, result, sizeof result);
}

static bool merge_part(scene *into, const scene_part *part, size_t mesh_base, const char *prefix,
                       const double turn[16]) {
    size_t size = strlen(part->name) + (prefix ? strlen(prefix) : 0) + 2;
    char *name = malloc(size);
    if (!name)
        return false;
    snprintf(name, size, "%s%s%s", prefix ? prefix : "", prefix ? "/" : "", part->name);
    double transform[16];
    scene_multiply(turn, part->transform, transform);
    size_t added = scene_add_part(into, name, mesh_base + part->mesh, transform, part->color);
    free(name);
    if (added == SIZE_MAX)
        return false;
    into->parts[added].opacity = part->opacity;
    into->parts[added].hidden = part->hidden;
    return true;
}

bool scene_merge(scene *into, scene *from, const char *prefix) {
    static const double same[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const double z_to_y[16] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    static const double y_to_z[16] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1};
    const double *turn = into->up_axis == from->up_axis ? same : into->up_axis == 1 ? z_to_y : y_to_z;
    size_t mesh_base = into->mesh_count;
    bool ok = true;
    for (size_t i = 0; ok && i < from->mesh_count; i++) {
        ok = scene_add_mesh(into, from->meshes[i].name, &from->meshes[i]) != SIZE_MAX;
        free(from->meshes[i].name);
        from->meshes[i] = (scene_mesh){0}; /* its arrays have a new owner, or are gone */
    }
    for (size_t i = 0; ok && i < from->part_count; i++)
        ok = merge_part(into, &from->parts[i], mesh_base, prefix, turn);
    scene_destroy(from);
    return ok;
}

static void transform_point(const double m[16], const float p[3], double out[3]) {
    for (size_t row = 0; row < 3; row++)
        out[row] = m[row] * (double)p[0] + m[4 + row] * (double)p[1] + m[8 + row] * (double)p[2] + m[12 + row];
}

/* Moves a mesh to its middle; where that was. */
static void center_mesh(scene_mesh *mesh, double middle[3]) {
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++) {
        size_t k = i % 3;
        double x = (double)mesh->positions[i];
        low[k] = i < 3 || x < low[k] ? x : low[k];
        high[k] = i < 3 || x > high[k] ? x : high[k];
    }
    for (size_t k = 0; k < 3; k++)
        middle[k] = 0.5 * low[k] + 0.5 * high[k];
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++)
        mesh->positions[i] = (float)((double)mesh->positions[i] - middle[i % 3]);
}

bool scene_center_meshes(scene *s) {
    double(*middles)[3] = malloc((s->mesh_count + 1) * sizeof *middles);
    if (!middles)
        return false;
    for (size_t i = 0; i < s->mesh_count; i++)
        center_mesh(&s->meshes[i], middles[i]);
    for (size_t i = 0; i < s->part_count; i++) {
        double shift[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, moved[16];
        memcpy(shift + 12, middles[s->parts[i].mesh], sizeof middles[0]);
        scene_multiply(s->parts[i].transform, shift, moved);
        memcpy(s->parts[i].transform, moved, sizeof moved);
    }
    free(middles);
    return true;
}

bool scene_bounds(const scene *s, double low[3], double high[3]) {
    for (size_t axis = 0; axis < 3; axis++) {
        low[axis] = (double)INFINITY;
        high[axis] = -(double)INFINITY;
    }
    for (size_t i = 0; i < s->part_count; i++) {
        const scene_mesh *mesh = &s->meshes[s->parts[i].mesh];
        for (size_t j = 0; !s->parts[i].hidden && j < mesh->index_count; j++) {
            double point[3];
            transform_point(s->parts[i].transform, &mesh->positions[3 * (size_t)mesh->indices[j]], point);
            for (size_t axis = 0; axis < 3; axis++) {
                low[axis] = fmin(low[axis], point[axis]);
                high[axis] = fmax(high[axis], point[axis]);
            }
        }
    }
    return low[0] <= high[0];
}

/* ---- welding --------------------------------------------------------------------------------------------- */

/* Records of up to nine floats, compared bit by bit. */
typedef struct record {
    uint32_t bits[9];
} record;

static uint32_t float_bits(float value) {
    uint32_t bits;
    if (value == 0) /* -0 and 0 are the same */
        return 0;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static uint64_t hash_record(const record *r, size_t words) {
    uint64_t hash = 0x9e3779b97f4a7c15u;
    for (size_t i = 0; i < words; i++) {
        hash = (hash ^ r->bits[i]) * 0xff51afd7ed558ccdu;
        hash ^= hash >> 32;
    }
    return hash;
}

/* Numbers the distinct records from 0 in the order of their first appearance. Returns how many there are. */
static size_t number_records(const record *records, size_t count, size_t words, uint32_t *numbers) {
    size_t slots = 16;
    while (slots < 2 * count)
        slots *= 2;
    uint32_t *table = malloc(slots * sizeof *table); /* the first record with that value */
    if (!table)
        return SIZE_MAX;
    memset(table, 0xff, slots * sizeof *table);
    size_t distinct = 0;
    for (size_t i = 0; i < count; i++) {
        size_t slot = (size_t)hash_record(&records[i], words) & (slots - 1);
        while (table[slot] != UINT32_MAX && memcmp(&records[table[slot]], &records[i], words * sizeof(uint32_t)) != 0)
            slot = (slot + 1) & (slots - 1);
        if (table[slot] == UINT32_MAX) {
            table[slot] = (uint32_t)i;
            numbers[i] = (uint32_t)distinct++;
        } else {
            numbers[i] = numbers[table[slot]];
        }
    }
    free(table);
    return distinct;
}

static void put_floats(record *r, size_t first, const float *floats) {
    for (size_t i = 0; i < 3; i++)
        r->bits[first + i] = float_bits(floats[i]);
}

size_t scene_weld(const float *positions, size_t vertex_count, uint32_t *places) {
    record *records = malloc((vertex_count + 1) * sizeof *records);
    if (!records)
        return SIZE_MAX;
    for (size_t i = 0; i < vertex_count; i++)
        put_floats(&records[i], 0, &positions[3 * i]);
    size_t count = number_records(records, vertex_count, 3, places);
    free(records);
    return count;
}

/* Moves each vertex to its number; vertices of one number are equal, so the order of writing does not matter. */
static void compact(float *floats, const uint32_t *numbers, size_t count) {
    for (size_t i = 0; floats && i < count;
         i++) /* a number is never larger than its vertex: nothing is overwritten early */
        memmove(&floats[3 * (size_t)numbers[i]], &floats[3 * i], 3 * sizeof *floats);
}

bool scene_mesh_share_vertices(scene_mesh *mesh) {
    size_t count = mesh->vertex_count, words = mesh->colors ? 9 : 6;
    record *records = malloc((count + 1) * sizeof *records);
    uint32_t *numbers = malloc((count + 1) * sizeof *numbers);
    size_t distinct = SIZE_MAX;
    for (size_t i = 0; records && numbers && i < count; i++) {
        put_floats(&records[i], 0, &mesh->positions[3 * i]);
        put_floats(&records[i], 3, &mesh->normals[3 * i]);
        if (mesh->colors)
            put_floats(&records[i], 6, &mesh->colors[3 * i]);
    }
    if (records && numbers)
        distinct = number_records(records, count, words, numbers);
    if (distinct != SIZE_MAX) {
        for (size_t i = 0; i < mesh->index_count; i++)
            mesh->indices[i] = numbers[mesh->indices[i]];
        compact(mesh->positions, numbers, count);
        compact(mesh->normals, numbers, count);
        compact(mesh->colors, numbers, count);
        mesh->vertex_count = distinct;
    }
    free(records);
    free(numbers);
    return distinct != SIZE_MAX;
}

/* ---- edges ----------------------------------------------------------------------------------------------- */

typedef struct half_edge {
    uint32_t low, high; /* places */
    uint32_t corner;    /* index of the corner where it starts: triangle * 3 + 0, 1, 2 */
    uint32_t forward;   /* 1: it runs from low to high */
} half_edge;

static int compare_half_edges(const void *a, const void *b) {
    const half_edge *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return x->corner < y->corner ? -1 : x->corner > y->corner;
}

/* All half edges, those of one edge side by side. NULL: out of memory. */
static half_edge *sorted_half_edges(const scene_mesh *mesh, const uint32_t *places) {
    half_edge *edges = malloc((mesh->index_count + 1) * sizeof *edges);
    if (!edges)
        return NULL;
    for (size_t i = 0; i < mesh->index_count; i++) {
        size_t next = i % 3 == 2 ? i - 2 : i + 1;
        uint32_t a = places[mesh->indices[i]], b = places[mesh->indices[next]];
        edges[i] = (half_edge){a < b ? a : b, a < b ? b : a, (uint32_t)i, a < b};
    }
    qsort(edges, mesh->index_count, sizeof *edges, compare_half_edges);
    return edges;
}

static bool same_edge(const half_edge *a, const half_edge *b) {
    return a->low == b->low && a->high == b->high;
}

static double volume_of(const scene_mesh *mesh) {
    double volume = 0;
    const float *origin = mesh->positions; /* any point will do for a closed mesh; a near one keeps the digits */
    for (size_t i = 0; i + 2 < mesh->index_count; i += 3) {
        double p[3][3];
        for (size_t j = 0; j < 3; j++)
            for (size_t axis = 0; axis < 3; axis++)
                p[j][axis] = (double)mesh->positions[3 * (size_t)mesh->indices[i + j] + axis] - (double)origin[axis];
        volume += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                  p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    return volume / 6;
}

bool scene_mesh_closed(const scene_mesh *mesh, double *signed_volume) {
    uint32_t *places = malloc((mesh->vertex_count + 1) * sizeof *places);
    half_edge *edges = NULL;
    if (places && scene_weld(mesh->positions, mesh->vertex_count, places) != SIZE_MAX)
        edges = sorted_half_edges(mesh, places);
    bool closed = edges && mesh->index_count > 0;
    for (size_t i = 0; closed && i < mesh->index_count; i += 2) {
        closed = i + 1 < mesh->index_count && same_edge(&edges[i], &edges[i + 1]) && edges[i].low != edges[i].high &&
                 edges[i].forward != edges[i + 1].forward &&
                 !(i + 2 < mesh->index_count && same_edge(&edges[i], &edges[i + 2]));
    }
    if (signed_volume)
        *signed_volume = mesh->index_count ? volume_of(mesh) : 0;
    free(places);
    free(edges);
    return closed;
}

/* ---- normals --------------------------------------------------------------------------------------------- */

static void subtract(const float *a, const float *b, double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = (double)a[i] - (double)b[i];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool normalise(double v[3]) {
    /* Scaled first: the square of a very small or very large length would leave the range of double. */
    double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (!(largest > 0) || !isfinite(largest))
        return false;
    for (size_t i = 0; i < 3; i++)
        v[i] /= largest;
    double length = sqrt(dot(v, v));
    for (size_t i = 0; i < 3; i++)
        v[i] /= length;
    return true;
}

/* Unit normal of a triangle, zero where it has no area. */
static void face_normal(const scene_mesh *mesh, size_t face, double normal[3]) {
    const float *p[3];
    for (size_t i = 0; i < 3; i++)
        p[i] = &mesh->positions[3 * (size_t)mesh->indices[3 * face + i]];
    double u[3], v[3];
    subtract(p[1], p[0], u);
    subtract(p[2], p[0], v);
    normal[0] = u[1] * v[2] - u[2] * v[1];
    normal[1] = u[2] * v[0] - u[0] * v[2];
    normal[2] = u[0] * v[1] - u[1] * v[0];
    if (!normalise(normal))
        normal[0] = normal[1] = normal[2] = 0;
}

static double corner_angle(const scene_mesh *mesh, size_t corner) {
    size_t face = corner / 3 * 3;
    const float *p = &mesh->positions[3 * (size_t)mesh->indices[corner]];
    double u[3], v[3];
    subtract(&mesh->positions[3 * (size_t)mesh->indices[face + (corner + 1) % 3]], p, u);
    subtract(&mesh->positions[3 * (size_t)mesh->indices[face + (corner + 2) % 3]], p, v);
    if (!normalise(u) || !normalise(v))
        return 0;
    return acos(fmax(-1, fmin(1, dot(u, v))));
}

static uint32_t find_root(uint32_t *parents, uint32_t i) {
    while (parents[i] != i) {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    return i;
}

static void join(uint32_t *parents, uint32_t a, uint32_t b) {
    a = find_root(parents, a);
    b = find_root(parents, b);
    if (a < b)
        parents[b] = a;
    else
        parents[a] = b;
}

static uint32_t next_corner(uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/* Two triangles along one edge share their normals at both of its ends if they meet at less than the crease angle. */
static void join_across(uint32_t *parents, const double *face_normals, const half_edge *a, const half_edge *b,
                        double cosine) {
    if (a->forward == b->forward || a->low == a->high)
        return;
    if (dot(&face_normals[3 * (size_t)(a->corner / 3)], &face_normals[3 * (size_t)(b->corner / 3)]) <= cosine)
        return;
    join(parents, a->corner, next_corner(b->corner));
    join(parents, next_corner(a->corner), b->corner);
}

/* Corners that share one normal get one root. */
static void group_corners(uint32_t *parents, const half_edge *edges, size_t count, const double *face_normals,
                          double cosine) {
    /* An edge with very many triangles is not worth the square of their number. */
    enum { MOST_AT_AN_EDGE = 8 };
    for (size_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && same_edge(&edges[first], &edges[end]);)
            end++;
        for (size_t i = first; end - first <= MOST_AT_AN_EDGE && i < end; i++)
            for (size_t j = i + 1; j < end; j++)
                join_across(parents, face_normals, &edges[i], &edges[j], cosine);
    }
}

static void sum_normals(const scene_mesh *mesh, uint32_t *parents, const double *face_normals, double *sums) {
    for (size_t corner = 0; corner < mesh->index_count; corner++) {
        double weight = corner_angle(mesh, corner);
        size_t root = find_root(parents, (uint32_t)corner);
        for (size_t axis = 0; axis < 3; axis++)
            sums[3 * root + axis] += weight * face_normals[3 * (corner / 3) + axis];
    }
}

/* One vertex a corner, with the normal of its group. */
static bool split_corners(scene_mesh *mesh, uint32_t *parents, double *sums) {
    size_t count = mesh->index_count;
    float *positions = malloc((count + 1) * 3 * sizeof *positions),
          *normals = malloc((count + 1) * 3 * sizeof *normals);
    float *colors = mesh->colors ? malloc((count + 1) * 3 * sizeof *colors) : NULL;
    if (!positions || !normals || (mesh->colors && !colors)) {
        free(positions);
        free(normals);
        free(colors);
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        double *sum = &sums[3 * (size_t)find_root(parents, (uint32_t)i)];
        if (!normalise(sum)) { /* only triangles without area meet here: any direction is as good */
            sum[0] = sum[1] = 0;
            sum[2] = 1;
        }
        for (size_t axis = 0; axis < 3; axis++)
            normals[3 * i + axis] = (float)sum[axis];
        memcpy(&positions[3 * i], &mesh->positions[3 * (size_t)mesh->indices[i]], 3 * sizeof *positions);
        if (colors)
            memcpy(&colors[3 * i], &mesh->colors[3 * (size_t)mesh->indices[i]], 3 * sizeof *colors);
        mesh->indices[i] = (uint32_t)i;
    }
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->colors);
    mesh->positions = positions;
    mesh->normals = normals;
    mesh->colors = colors;
    mesh->vertex_count = count;
    return true;
}

bool scene_mesh_make_normals(scene_mesh *mesh, double crease_degrees) {
    size_t corners = mesh->index_count;
    uint32_t *places = malloc((mesh->vertex_count + 1) * sizeof *places);
    uint32_t *parents = malloc((corners + 1) * sizeof *parents);
    double *face_normals = malloc((corners + 3) * sizeof *face_normals);
    double *sums = calloc(3 * corners + 3, sizeof *sums);
    half_edge *edges = NULL;
    bool ok = places && parents && face_normals && sums &&
              scene_weld(mesh->positions, mesh->vertex_count, places) != SIZE_MAX &&
              (edges = sorted_half_edges(mesh, places)) != NULL;
    if (ok) {
        for (size_t i = 0; i < corners; i++)
            parents[i] = (uint32_t)i;
        for (size_t face = 0; face < corners / 3; face++)
            face_normal(mesh, face, &face_normals[3 * face]);
        group_corners(parents, edges, corners, face_normals, cos(crease_degrees * 3.14159265358979323846 / 180));
        sum_normals(mesh, parents, face_normals, sums);
        ok = split_corners(mesh, parents, sums) && scene_mesh_share_vertices(mesh);
    }
    free(places);
    free(parents);
    free(face_normals);
    free(sums);
    free(edges);
    return ok;
}
