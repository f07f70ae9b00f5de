#include "mesh.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

mesh mesh_begin(void) {
    mesh m = {0};
    m.place = m4_identity();
    return m;
}

void mesh_bone(mesh *m, int bone) {
    mesh_joint(m, bone, bone, 0, 1);
}

void mesh_joint(mesh *m, int lower, int upper, float from, float to) {
    m->bones[0] = (uint8_t)lower;
    m->bones[1] = (uint8_t)upper;
    m->joint[0] = from;
    m->joint[1] = to;
}

static void *grown(void *items, uint32_t count, uint32_t *room, size_t size) {
    if (count < *room)
        return items;
    *room = *room ? 2 * *room : 256;
    items = realloc(items, *room * size);
    if (!items) {
        fprintf(stderr, "host: no memory\n");
        exit(1);
    }
    return items;
}

static uint32_t add_vertex(mesh *m, vec3 position, vec3 normal) {
    float t = fminf(1, fmaxf(0, (position.y - m->joint[0]) / (m->joint[1] - m->joint[0])));
    vec3 p = m4_point(m->place, position), n = v3_normalise(m4_direction(m->place, normal));
    uint8_t upper = (uint8_t)lrintf(255 * t * t * (3 - 2 * t));
    vertex v = {{p.x, p.y, p.z}, {n.x, n.y, n.z}, {m->bones[0], m->bones[1]}, {(uint8_t)(255 - upper), upper}};
    m->vertices = grown(m->vertices, m->vertex_count, &m->vertex_room, sizeof v);
    m->vertices[m->vertex_count] = v;
    return m->vertex_count++;
}

static void add_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t corners[3] = {a, b, c};
    for (int i = 0; i < 3; i++) {
        m->indices = grown(m->indices, m->index_count, &m->index_room, sizeof *m->indices);
        m->indices[m->index_count++] = corners[i];
    }
}

/* ---- solids -------------------------------------------------------------------------------------------------- */

/* The outward normal of the stretch from profile point i to i + 1, in (radius, height). */
static void stretch_normal(const float (*profile)[2], int i, float n[2]) {
    float dr = profile[i + 1][0] - profile[i][0], dy = profile[i + 1][1] - profile[i][1];
    float length = hypotf(dr, dy);
    n[0] = -dy / length;
    n[1] = dr / length;
}

/* The normal at one end of a stretch: shared with its neighbour where the corner is soft. */
static void corner_normal(const float (*profile)[2], int count, int stretch, int end, float n[2]) {
    int neighbour = stretch + (end ? 1 : -1);
    float other[2];
    stretch_normal(profile, stretch, n);
    if (neighbour < 0 || neighbour > count - 2)
        return;
    stretch_normal(profile, neighbour, other);
    if (n[0] * other[0] + n[1] * other[1] > 0.82f) {
        n[0] += other[0];
        n[1] += other[1];
    }
}

void mesh_lathe(mesh *m, const float (*profile)[2], int count, int segments) {
    for (int s = 0; s + 1 < count; s++) {
        uint32_t first = m->vertex_count;
        for (int k = 0; k < segments; k++) {
            float angle = 2 * PI * (float)k / (float)segments, c = cosf(angle), d = sinf(angle);
            for (int end = 0; end < 2; end++) {
                float n[2];
                corner_normal(profile, count, s, end, n);
                add_vertex(m, v3(profile[s + end][0] * c, profile[s + end][1], profile[s + end][0] * d),
                           v3(n[0] * c, n[1], n[0] * d));
            }
        }
        for (uint32_t k = 0; k < (uint32_t)segments; k++) {
            uint32_t a = first + 2 * k, b = first + 2 * ((k + 1) % (uint32_t)segments);
            if (profile[s][0] > 0)
                add_triangle(m, a, b, a + 1);
            if (profile[s + 1][0] > 0)
                add_triangle(m, a + 1, b, b + 1);
        }
    }
}

/* One face of the cube [-1,1]^3, seen from outside, pushed out to the rounded box. */
static void box_face(mesh *m, int axis, float side, vec3 half, float radius, int steps) {
    /* Two rows on the flat part, `steps` over each round edge. */
    int rows = 2 * (steps + 1);
    uint32_t first = m->vertex_count;
    const float halves[3] = {half.x, half.y, half.z};
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < rows; j++) {
            float unit[3], core[3], normal[3];
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            int at[2] = {i, j};
            normal[axis] = side;
            for (int e = 0; e < 2; e++) {
                int low = at[e] <= steps, step = low ? steps - at[e] : at[e] - steps - 1;
                float slope = steps ? tanf(PI / 4 * (float)step / (float)steps) : 0;
                unit[e] = low ? -1 : 1;
                normal[e ? v : u] = unit[e] * slope;
            }
            core[axis] = side * (halves[axis] - radius);
            core[u] = unit[0] * (halves[u] - radius);
            core[v] = unit[1] * (halves[v] - radius);
            vec3 n = v3_normalise(v3(normal[0], normal[1], normal[2]));
            add_vertex(m, v3_add(v3(core[0], core[1], core[2]), v3_scale(n, radius)), n);
        }
    for (uint32_t i = 0; i + 1 < (uint32_t)rows; i++)
        for (uint32_t j = 0; j + 1 < (uint32_t)rows; j++) {
            uint32_t a = first + i * (uint32_t)rows + j, b = a + (uint32_t)rows;
            if (side > 0) {
                add_triangle(m, a, b, b + 1);
                add_triangle(m, a, b + 1, a + 1);
            } else {
                add_triangle(m, a, b + 1, b);
                add_triangle(m, a, a + 1, b + 1);
            }
        }
}

void mesh_box(mesh *m, float x, float y, float z, float radius, int steps) {
    for (int axis = 0; axis < 3; axis++)
        for (int side = -1; side <= 1; side += 2)
            box_face(m, axis, (float)side, v3(x, y, z), radius, steps);
}

void mesh_ball(mesh *m, float x, float y, float z, int segments) {
    float profile[65][2];
    mat4 place = m->place;
    int rows = segments / 2 < 64 ? segments / 2 : 64;
    for (int i = 0; i <= rows; i++) {
        float angle = PI * (float)i / (float)rows;
        profile[i][0] = i == 0 || i == rows ? 0 : sinf(angle);
        profile[i][1] = cosf(angle);
    }
    m->place = m4_mul(place, m4_scale(x, y, z));
    mesh_lathe(m, (const float(*)[2])profile, rows + 1, segments);
    m->place = place;
}

/* The outline at corner k: four corners a tooth, two of them outside. */
static vec3 gear_corner(int teeth, float inner, float outer, int k, float y) {
    static const float turn[4] = {-0.25f, -0.14f, 0.14f, 0.25f};
    int corner = k % 4;
    float angle = 2 * PI * ((float)(k / 4) + turn[corner]) / (float)teeth;
    float radius = corner == 1 || corner == 2 ? outer : inner;
    return v3(radius * cosf(angle), y, radius * sinf(angle));
}

void mesh_gear(mesh *m, int teeth, float inner, float outer, float h) {
    int corners = 4 * teeth;
    for (int k = 0; k < corners; k++) {
        vec3 a = gear_corner(teeth, inner, outer, k, h), b = gear_corner(teeth, inner, outer, (k + 1) % corners, h);
        vec3 c = v3(a.x, -h, a.z), d = v3(b.x, -h, b.z), out = v3_cross(v3_sub(b, a), v3_sub(c, a));
        uint32_t v = add_vertex(m, a, out);
        add_vertex(m, b, out);
        add_vertex(m, c, out);
        add_vertex(m, d, out);
        add_triangle(m, v, v + 1, v + 2);
        add_triangle(m, v + 1, v + 3, v + 2);
        for (int side = 0; side < 2; side++) {
            vec3 up = v3(0, side ? -1.0f : 1.0f, 0);
            v = add_vertex(m, v3(0, up.y * h, 0), up);
            add_vertex(m, side ? c : a, up);
            add_vertex(m, side ? d : b, up);
            add_triangle(m, v, v + (side ? 1 : 2), v + (side ? 2 : 1));
        }
    }
}

/* ---- GL ------------------------------------------------------------------------------------------------------ */

static void attribute(GLuint array, GLuint index, GLuint binding, GLint size, GLenum type, size_t offset) {
    glEnableVertexArrayAttrib(array, index);
    glVertexArrayAttribBinding(array, index, binding);
    if (type == GL_FLOAT)
        glVertexArrayAttribFormat(array, index, size, type, GL_FALSE, (GLuint)offset);
    else
        glVertexArrayAttribIFormat(array, index, size, type, (GLuint)offset);
}

void mesh_upload(mesh *m, GLuint instance_buffer) {
    GLuint array;
    glCreateBuffers(1, &m->vertex_buffer);
    glCreateBuffers(1, &m->index_buffer);
    glNamedBufferStorage(m->vertex_buffer, (GLsizeiptr)(m->vertex_count * sizeof *m->vertices), m->vertices, 0);
    glNamedBufferStorage(m->index_buffer, (GLsizeiptr)(m->index_count * sizeof *m->indices), m->indices, 0);
    glCreateVertexArrays(1, &array);
    glVertexArrayElementBuffer(array, m->index_buffer);
    glVertexArrayVertexBuffer(array, 0, m->vertex_buffer, 0, sizeof(vertex));
    glVertexArrayVertexBuffer(array, 1, instance_buffer, 0, sizeof(instance));
    glVertexArrayBindingDivisor(array, 1, 1);
    attribute(array, 0, 0, 3, GL_FLOAT, offsetof(vertex, position));
    attribute(array, 1, 0, 3, GL_FLOAT, offsetof(vertex, normal));
    attribute(array, 2, 0, 2, GL_UNSIGNED_BYTE, offsetof(vertex, bones));
    attribute(array, 3, 0, 2, GL_UNSIGNED_BYTE, offsetof(vertex, weights));
    for (GLuint row = 0; row < 3; row++)
        attribute(array, 4 + row, 1, 4, GL_FLOAT, offsetof(instance, rows) + 16 * row);
    attribute(array, 7, 1, 3, GL_FLOAT, offsetof(instance, tint));
    attribute(array, 8, 1, 1, GL_UNSIGNED_INT, offsetof(instance, id));
    m->vertex_array = array;
}

void mesh_destroy(mesh *m) {
    glDeleteVertexArrays(1, &m->vertex_array);
    glDeleteBuffers(1, &m->vertex_buffer);
    glDeleteBuffers(1, &m->index_buffer);
    free(m->vertices);
    free(m->indices);
    memset(m, 0, sizeof *m);
}
