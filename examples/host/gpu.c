#define GLAD_GL_IMPLEMENTATION
#include "gpu.h"
#include "headless.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool gpu_open(gpu_cache *cache) {
    memset(cache, 0, sizeof *cache);
    if (gladLoadGL((GLADloadfunc)headless_get_proc) < GLAD_MAKE_VERSION(4, 5))
        return false;
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glClearDepth(0);
    glPolygonOffset(-1.5f, -4);
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glGetIntegerv(GL_VIEWPORT, cache->viewport);
    return true;
}

static void toggle(GLenum what, bool on) {
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

static bool changes(gpu_cache *cache, bool differs) {
    cache->asked++;
    cache->sent += differs;
    return differs;
}

void gpu_use(gpu_cache *cache, const gpu_pipeline *want) {
    gpu_pipeline *have = &cache->pipeline;
    if (changes(cache, have->program != want->program))
        glUseProgram(want->program);
    if (changes(cache, !have->depth_func != !want->depth_func))
        toggle(GL_DEPTH_TEST, want->depth_func != 0);
    if (changes(cache, want->depth_func && have->depth_func != want->depth_func))
        glDepthFunc(want->depth_func);
    if (changes(cache, have->write_depth != want->write_depth))
        glDepthMask(want->write_depth);
    if (changes(cache, have->write_colour != want->write_colour))
        glColorMask(want->write_colour, want->write_colour, want->write_colour, want->write_colour);
    if (changes(cache, !have->cull != !want->cull))
        toggle(GL_CULL_FACE, want->cull != 0);
    if (changes(cache, want->cull && have->cull != want->cull))
        glCullFace(want->cull);
    if (changes(cache, have->depth_bias != want->depth_bias))
        toggle(GL_POLYGON_OFFSET_FILL, want->depth_bias);
    *have = *want;
}

void gpu_use_target(gpu_cache *cache, const gpu_target *target) {
    GLint viewport[4] = {0, 0, target->width, target->height};
    if (changes(cache, cache->framebuffer != target->framebuffer))
        glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    if (changes(cache, memcmp(cache->viewport, viewport, sizeof viewport) != 0))
        glViewport(0, 0, target->width, target->height);
    cache->framebuffer = target->framebuffer;
    memcpy(cache->viewport, viewport, sizeof viewport);
}

void gpu_use_texture(gpu_cache *cache, unsigned unit, GLuint texture) {
    if (changes(cache, cache->textures[unit] != texture))
        glBindTextureUnit(unit, texture);
    cache->textures[unit] = texture;
}

void gpu_use_uniforms(gpu_cache *cache, unsigned block, GLuint buffer, GLintptr offset, GLsizeiptr size) {
    gpu_uniforms *have = &cache->blocks[block];
    if (changes(cache, have->buffer != buffer || have->offset != offset || have->size != size))
        glBindBufferRange(GL_UNIFORM_BUFFER, block, buffer, offset, size);
    have->buffer = buffer;
    have->offset = offset;
    have->size = size;
}

void gpu_use_vertex_array(gpu_cache *cache, GLuint vertex_array) {
    if (changes(cache, cache->vertex_array != vertex_array))
        glBindVertexArray(vertex_array);
    cache->vertex_array = vertex_array;
}

/* ---- what GL says -------------------------------------------------------------------------------------------- */

static int compare(const char *when, const char *what, GLint64 believed, GLint64 found) {
    if (believed == found)
        return 0;
    fprintf(stderr, "host: %s: %s is %lld behind the cache's back, not %lld\n", when, what, (long long)found,
            (long long)believed);
    return 1;
}

static int compare_integer(const char *when, const char *what, GLint64 believed, GLenum name) {
    GLint found = 0;
    glGetIntegerv(name, &found);
    return compare(when, what, believed, found);
}

static int verify_pipeline(const gpu_pipeline *p, const char *when) {
    GLint mask[4];
    int wrong = compare_integer(when, "program", p->program, GL_CURRENT_PROGRAM);
    wrong += compare(when, "depth test", p->depth_func != 0, glIsEnabled(GL_DEPTH_TEST));
    if (p->depth_func)
        wrong += compare_integer(when, "depth function", p->depth_func, GL_DEPTH_FUNC);
    wrong += compare_integer(when, "depth mask", p->write_depth, GL_DEPTH_WRITEMASK);
    for (GLuint target = 0; target < GPU_MOST_COLOURS; target++) {
        glGetIntegeri_v(GL_COLOR_WRITEMASK, target, mask);
        for (int c = 0; c < 4; c++)
            wrong += compare(when, "colour mask", p->write_colour, mask[c]);
        wrong += compare(when, "blending", 0, glIsEnabledi(GL_BLEND, target));
    }
    wrong += compare(when, "culling", p->cull != 0, glIsEnabled(GL_CULL_FACE));
    if (p->cull)
        wrong += compare_integer(when, "cull face", p->cull, GL_CULL_FACE_MODE);
    wrong += compare(when, "polygon offset", p->depth_bias, glIsEnabled(GL_POLYGON_OFFSET_FILL));
    wrong += compare(when, "scissor test", 0, glIsEnabled(GL_SCISSOR_TEST));
    wrong += compare(when, "stencil test", 0, glIsEnabled(GL_STENCIL_TEST));
    wrong += compare_integer(when, "clip depth", GL_ZERO_TO_ONE, GL_CLIP_DEPTH_MODE);
    return wrong + compare_integer(when, "front face", GL_CCW, GL_FRONT_FACE);
}

static int verify_bindings(const gpu_cache *cache, const char *when) {
    int wrong = compare_integer(when, "vertex array", cache->vertex_array, GL_VERTEX_ARRAY_BINDING);
    wrong += compare_integer(when, "draw framebuffer", cache->framebuffer, GL_DRAW_FRAMEBUFFER_BINDING);
    wrong += compare_integer(when, "read framebuffer", cache->framebuffer, GL_READ_FRAMEBUFFER_BINDING);
    for (GLuint unit = 0; unit < GPU_TEXTURE_UNITS; unit++) {
        GLint texture = 0, sampler = 0;
        glGetIntegeri_v(GL_TEXTURE_BINDING_2D, unit, &texture);
        glGetIntegeri_v(GL_SAMPLER_BINDING, unit, &sampler);
        wrong += compare(when, "texture", cache->textures[unit], texture);
        wrong += compare(when, "sampler", 0, sampler);
    }
    for (GLuint block = 0; block < GPU_UNIFORM_BLOCKS; block++) {
        const gpu_uniforms *u = &cache->blocks[block];
        GLint buffer = 0;
        GLint64 offset = 0, size = 0;
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, block, &buffer);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_START, block, &offset);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, block, &size);
        wrong += compare(when, "uniform buffer", u->buffer, buffer);
        wrong += compare(when, "uniform buffer's offset", u->offset, offset);
        wrong += compare(when, "uniform buffer's size", u->size, size);
    }
    return wrong;
}

int gpu_verify(const gpu_cache *cache, const char *when) {
    GLint viewport[4];
    int wrong = verify_pipeline(&cache->pipeline, when) + verify_bindings(cache, when);
    glGetIntegerv(GL_VIEWPORT, viewport);
    for (int i = 0; i < 4; i++)
        wrong += compare(when, "viewport", cache->viewport[i], viewport[i]);
    return wrong;
}

/* ---- programs and targets ------------------------------------------------------------------------------------ */

static GLuint compile(const char *name, GLenum stage, const char *defines, const char *text) {
    const char *parts[] = {"#version 450 core\n", defines, "#line 1\n", text};
    GLuint shader = glCreateShader(stage);
    GLint ok = 0;
    glShaderSource(shader, 4, parts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        char log[2048] = "";
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "host: shader %s:\n%s\n", name, log);
        exit(1);
    }
    return shader;
}

GLuint gpu_program(const char *name, const char *defines, const char *vertex, const char *fragment) {
    GLuint program = glCreateProgram();
    GLuint stages[2] = {compile(name, GL_VERTEX_SHADER, defines, vertex),
                        compile(name, GL_FRAGMENT_SHADER, defines, fragment)};
    GLint ok = 0;
    for (int i = 0; i < 2; i++)
        glAttachShader(program, stages[i]);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok) {
        char log[2048] = "";
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        fprintf(stderr, "host: program %s:\n%s\n", name, log);
        exit(1);
    }
    for (int i = 0; i < 2; i++)
        glDeleteShader(stages[i]);
    return program;
}

static GLuint texture_create(GLenum format, int width, int height) {
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, format, width, height);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

gpu_target gpu_target_create(int width, int height, int colour_count, const GLenum *formats, GLenum depth_format) {
    gpu_target t = {0};
    GLenum attachments[GPU_MOST_COLOURS];
    t.width = width;
    t.height = height;
    t.colour_count = colour_count;
    glCreateFramebuffers(1, &t.framebuffer);
    for (int i = 0; i < colour_count; i++) {
        t.colours[i] = texture_create(formats[i], width, height);
        attachments[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        glNamedFramebufferTexture(t.framebuffer, attachments[i], t.colours[i], 0);
    }
    if (colour_count)
        glNamedFramebufferDrawBuffers(t.framebuffer, colour_count, attachments);
    else
        glNamedFramebufferDrawBuffer(t.framebuffer, GL_NONE);
    if (depth_format) {
        t.depth = texture_create(depth_format, width, height);
        glNamedFramebufferTexture(t.framebuffer, GL_DEPTH_ATTACHMENT, t.depth, 0);
    }
    if (glCheckNamedFramebufferStatus(t.framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        fprintf(stderr, "host: a target of %dx%d cannot be had\n", width, height);
        exit(1);
    }
    return t;
}

void gpu_target_destroy(gpu_target *target) {
    glDeleteFramebuffers(1, &target->framebuffer);
    glDeleteTextures(target->colour_count, target->colours);
    glDeleteTextures(1, &target->depth);
    memset(target, 0, sizeof *target);
}
