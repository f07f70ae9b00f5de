/* gpu.h: the engine's way to OpenGL 4.5: a cache of its state, programs, targets.
 *
 * Whatever draws asks for the state that it wants, and GL hears of it only where the cache says that it differs. So
 * nobody else may change that state and not put it back: what the engine then draws is wrong, for it will not set again
 * what it believes to be set. gpu_verify finds such a change. Objects are made and filled by direct state access, which
 * binds nothing. */
#ifndef HOST_GPU_H
#define HOST_GPU_H

#include <stdbool.h>
#include <glad/gl.h>

enum { GPU_TEXTURE_UNITS = 6, GPU_UNIFORM_BLOCKS = 3, GPU_MOST_COLOURS = 3 };

/* What a pass sets, all at once. Zero: no depth test, nothing written, both faces. */
typedef struct gpu_pipeline {
    GLuint program;
    GLenum depth_func; /* 0: no depth test */
    bool write_depth, write_colour;
    GLenum cull; /* 0: nothing is culled; else GL_BACK, GL_FRONT */
    bool depth_bias;
} gpu_pipeline;

typedef struct gpu_target {
    GLuint framebuffer, colours[GPU_MOST_COLOURS], depth;
    int width, height, colour_count;
} gpu_target;

typedef struct gpu_uniforms {
    GLuint buffer;
    GLintptr offset;
    GLsizeiptr size;
} gpu_uniforms;

/* What GL is believed to hold. */
typedef struct gpu_cache {
    gpu_pipeline pipeline;
    GLuint vertex_array, framebuffer, textures[GPU_TEXTURE_UNITS];
    GLint viewport[4];
    gpu_uniforms blocks[GPU_UNIFORM_BLOCKS];
    unsigned asked, sent; /* how much of what was asked for reached GL */
} gpu_cache;

/* A context is current. False: it is too old. Sets what never changes: reversed depth, clip depth in [0,1]. */
bool gpu_open(gpu_cache *cache);

void gpu_use(gpu_cache *cache, const gpu_pipeline *pipeline);
void gpu_use_target(gpu_cache *cache, const gpu_target *target);
void gpu_use_texture(gpu_cache *cache, unsigned unit, GLuint texture);
void gpu_use_uniforms(gpu_cache *cache, unsigned block, GLuint buffer, GLintptr offset, GLsizeiptr size);
void gpu_use_vertex_array(gpu_cache *cache, GLuint vertex_array);

/* Asks GL for everything that the cache knows. The number of differences, each printed to stderr. */
int gpu_verify(const gpu_cache *cache, const char *when);

/* Both texts follow the same lines of #define. Exits with the compiler's log where it fails. */
GLuint gpu_program(const char *name, const char *defines, const char *vertex, const char *fragment);

/* Textures of these formats and a framebuffer of them. No depth: depth_format 0. */
gpu_target gpu_target_create(int width, int height, int colour_count, const GLenum *formats, GLenum depth_format);
void gpu_target_destroy(gpu_target *target);

#endif
