/* maths.h: vectors and column-major matrices, as GL takes them. */
#ifndef HOST_MATHS_H
#define HOST_MATHS_H

#include <math.h>
#include <string.h>

#define PI 3.14159265f

typedef struct vec3 {
    float x, y, z;
} vec3;

typedef struct mat4 {
    float m[16]; /* m[4 * column + row] */
} mat4;

static inline vec3 v3(float x, float y, float z) {
    vec3 v = {x, y, z};
    return v;
}

static inline vec3 v3_add(vec3 a, vec3 b) {
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vec3 v3_sub(vec3 a, vec3 b) {
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vec3 v3_scale(vec3 a, float s) {
    return v3(a.x * s, a.y * s, a.z * s);
}

static inline float v3_dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 v3_cross(vec3 a, vec3 b) {
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline vec3 v3_normalise(vec3 a) {
    float length = sqrtf(v3_dot(a, a));
    return length > 0 ? v3_scale(a, 1 / length) : v3(0, 1, 0);
}

static inline mat4 m4_identity(void) {
    mat4 r = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    return r;
}

static inline mat4 m4_mul(mat4 a, mat4 b) {
    mat4 r;
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            float sum = 0;
            for (int k = 0; k < 4; k++)
                sum += a.m[4 * k + row] * b.m[4 * column + k];
            r.m[4 * column + row] = sum;
        }
    return r;
}

static inline mat4 m4_move(float x, float y, float z) {
    mat4 r = m4_identity();
    r.m[12] = x;
    r.m[13] = y;
    r.m[14] = z;
    return r;
}

static inline mat4 m4_scale(float x, float y, float z) {
    mat4 r = m4_identity();
    r.m[0] = x;
    r.m[5] = y;
    r.m[10] = z;
    return r;
}

/* About an axis of the coordinate system: 0 is x, 1 is y, 2 is z. Radians. */
static inline mat4 m4_turn(int axis, float angle) {
    mat4 r = m4_identity();
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    float c = cosf(angle), s = sinf(angle);
    r.m[5 * a] = c;
    r.m[5 * b] = c;
    r.m[4 * a + b] = s;
    r.m[4 * b + a] = -s;
    return r;
}

static inline vec3 m4_point(mat4 a, vec3 p) {
    return v3(a.m[0] * p.x + a.m[4] * p.y + a.m[8] * p.z + a.m[12],
              a.m[1] * p.x + a.m[5] * p.y + a.m[9] * p.z + a.m[13],
              a.m[2] * p.x + a.m[6] * p.y + a.m[10] * p.z + a.m[14]);
}

static inline vec3 m4_direction(mat4 a, vec3 d) {
    return v3(a.m[0] * d.x + a.m[4] * d.y + a.m[8] * d.z, a.m[1] * d.x + a.m[5] * d.y + a.m[9] * d.z,
              a.m[2] * d.x + a.m[6] * d.y + a.m[10] * d.z);
}

static inline mat4 m4_look_at(vec3 eye, vec3 target, vec3 up) {
    vec3 back = v3_normalise(v3_sub(eye, target)), right = v3_normalise(v3_cross(up, back));
    up = v3_cross(back, right);
    mat4 r = {{right.x, up.x, back.x, 0, right.y, up.y, back.y, 0, right.z, up.z, back.z, 0, -v3_dot(right, eye),
               -v3_dot(up, eye), -v3_dot(back, eye), 1}};
    return r;
}

/* Reversed and without end: depth is 1 at nearest and falls to 0 at infinity. For clip depths in [0,1]. */
static inline mat4 m4_perspective(float fov_y, float aspect, float nearest) {
    float f = 1 / tanf(fov_y / 2);
    mat4 r = {{f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, 0, -1, 0, 0, nearest, 0}};
    return r;
}

/* Reversed, too: 1 at nearest, 0 at farthest. */
static inline mat4 m4_orthographic(float half_width, float half_height, float nearest, float farthest) {
    float depth = farthest - nearest;
    mat4 r = {{1 / half_width, 0, 0, 0, 0, 1 / half_height, 0, 0, 0, 0, 1 / depth, 0, 0, 0, farthest / depth, 1}};
    return r;
}

#endif
