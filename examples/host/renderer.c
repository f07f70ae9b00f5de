#include "renderer.h"
#include "shaders.h"

#include <stdio.h>

enum { SUN_SIZE = 2048 };
enum { BLOCK_FRAME, BLOCK_MATERIAL, BLOCK_BONES };
enum { UNIT_SUN, UNIT_COLOUR, UNIT_NORMAL, UNIT_ID, UNIT_DEPTH, UNIT_OPEN };

static const GLenum world_formats[] = {GL_RGBA16F, GL_RG16F, GL_R16UI};
static const GLenum open_format[] = {GL_R8};
static const GLenum picture_format[] = {GL_RGBA8};

/* ---- making -------------------------------------------------------------------------------------------------- */

static void make_world_programs(world_programs programs, const char *name, const char *defines, const char *fragment) {
    char skinned[128];
    snprintf(skinned, sizeof skinned, "%s#define SKINNED\n", defines);
    programs[0] = gpu_program(name, defines, world_vert, fragment);
    programs[1] = gpu_program(name, skinned, world_vert, fragment);
}

static void make_programs(renderer *r) {
    static char lit[16384], resolve_defines[64];
    snprintf(lit, sizeof lit, "%s%s%s%s%s", FRAME_BLOCK, noise_glsl, material_glsl, light_glsl, world_frag);
    snprintf(resolve_defines, sizeof resolve_defines, "#define SCALE %d\n", (int)RENDERER_SCALE);
    make_world_programs(r->sun, "sun", "#define SUN\n", depth_frag);
    make_world_programs(r->prepass, "prepass", "", depth_frag);
    make_world_programs(r->lit, "world", "", lit);
    r->occlusion = gpu_program("occlusion", "", screen_vert, occlusion_frag);
    r->resolve = gpu_program("resolve", resolve_defines, screen_vert, resolve_frag);
}

/* Blocks that are bound by range begin at multiples of what the context says. */
static GLintptr stride_of(size_t size) {
    GLint alignment = 256;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    return ((GLintptr)size + alignment - 1) / alignment * alignment;
}

static GLuint make_buffer(GLsizeiptr size) {
    GLuint buffer;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, size, NULL, GL_DYNAMIC_STORAGE_BIT);
    return buffer;
}

static void make_buffers(renderer *r) {
    r->material_stride = stride_of(sizeof(material_block));
    r->palette_stride = stride_of(sizeof(mat4) * WORLD_BONES);
    r->frame_buffer = make_buffer(sizeof(frame_block));
    r->material_buffer = make_buffer(r->material_stride * MATERIAL_COUNT);
    r->palette_buffer = make_buffer(r->palette_stride * WORLD_MOST_PALETTES);
    r->instance_buffer = make_buffer(sizeof(instance) * WORLD_MOST_INSTANCES);
    for (int k = 0; k < MATERIAL_COUNT; k++)
        glNamedBufferSubData(r->material_buffer, r->material_stride * k, sizeof(material_block), &world_materials[k]);
    glCreateVertexArrays(1, &r->empty_array);
}

bool renderer_create(renderer *r, int width, int height) {
    memset(r, 0, sizeof *r);
    if (!gpu_open(&r->cache))
        return false;
    make_programs(r);
    make_buffers(r);
    r->sun_target = gpu_target_create(SUN_SIZE, SUN_SIZE, 0, NULL, GL_DEPTH_COMPONENT32F);
    glTextureParameteri(r->sun_target.depth, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(r->sun_target.depth, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    glTextureParameteri(r->sun_target.depth, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(r->sun_target.depth, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    int fine_width = width * RENDERER_SCALE, fine_height = height * RENDERER_SCALE;
    r->world_target = gpu_target_create(fine_width, fine_height, 3, world_formats, GL_DEPTH_COMPONENT32F);
    r->occlusion_target = gpu_target_create(fine_width, fine_height, 1, open_format, 0);
    r->picture = gpu_target_create(width, height, 1, picture_format, 0);
    return true;
}

void renderer_destroy(renderer *r) {
    const GLuint buffers[] = {r->frame_buffer, r->material_buffer, r->palette_buffer, r->instance_buffer};
    gpu_target *targets[] = {&r->sun_target, &r->world_target, &r->occlusion_target, &r->picture};
    GLuint *programs[] = {r->sun, r->prepass, r->lit};
    for (int k = 0; k < 4; k++)
        gpu_target_destroy(targets[k]);
    for (int k = 0; k < 6; k++)
        glDeleteProgram(programs[k / 2][k % 2]);
    glDeleteProgram(r->occlusion);
    glDeleteProgram(r->resolve);
    glDeleteVertexArrays(1, &r->empty_array);
    glDeleteBuffers(4, buffers);
}

/* ---- drawing ------------------------------------------------------------------------------------------------- */

static void set_frame(renderer *r, const camera *c) {
    frame_block *f = &r->frame;
    float aspect = (float)r->picture.width / (float)r->picture.height;
    vec3 sun = v3_normalise(v3(-0.80f, 0.66f, 0.22f));
    mat4 view = m4_look_at(c->eye, c->target, v3(0, 1, 0));
    mat4 sun_view = m4_look_at(v3_scale(sun, 40), v3(0, 0, 0), v3(0, 1, 0));
    f->clip_from_world = m4_mul(m4_perspective(c->fov_y, aspect, c->nearest), view);
    f->view_from_world = view;
    f->sun_from_world = m4_mul(m4_orthographic(18.5f, 16.5f, 10, 70), sun_view);
    f->eye[0] = c->eye.x;
    f->eye[1] = c->eye.y;
    f->eye[2] = c->eye.z;
    f->sun[0] = sun.x;
    f->sun[1] = sun.y;
    f->sun[2] = sun.z;
    f->lens[1] = tanf(c->fov_y / 2);
    f->lens[0] = f->lens[1] * aspect;
    f->lens[2] = c->nearest;
    glNamedBufferSubData(r->frame_buffer, 0, sizeof *f, f);
}

static void send_world(const renderer *r, const world *w) {
    glNamedBufferSubData(r->instance_buffer, 0, (GLsizeiptr)(w->instance_count * sizeof(instance)), w->instances);
    for (uint32_t k = 0; k < w->palette_count; k++)
        glNamedBufferSubData(r->palette_buffer, r->palette_stride * (GLintptr)k, sizeof w->palettes[k], w->palettes[k]);
}

static void draw_one(renderer *r, const world *w, const draw *d, const gpu_pipeline *pipeline,
                     const world_programs programs) {
    gpu_pipeline p = *pipeline;
    const mesh *m = &w->meshes[d->mesh];
    p.program = programs[d->palette >= 0];
    gpu_use(&r->cache, &p);
    gpu_use_vertex_array(&r->cache, m->vertex_array);
    gpu_use_uniforms(&r->cache, BLOCK_MATERIAL, r->material_buffer, r->material_stride * d->material,
                     sizeof(material_block));
    if (d->palette >= 0)
        gpu_use_uniforms(&r->cache, BLOCK_BONES, r->palette_buffer, r->palette_stride * d->palette,
                         sizeof(mat4) * WORLD_BONES);
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, (GLsizei)m->index_count, GL_UNSIGNED_INT, NULL,
                                        (GLsizei)d->instance_count, d->first_instance);
}

static void draw_world(renderer *r, const world *w, const gpu_pipeline *pipeline, const world_programs programs) {
    for (uint32_t k = 0; k < w->draw_count; k++)
        draw_one(r, w, &w->draws[k], pipeline, programs);
}

static void draw_sun(renderer *r, const world *w) {
    static const GLfloat far_away = 0;
    gpu_pipeline p = {0};
    p.depth_func = GL_GREATER;
    p.write_depth = p.depth_bias = true;
    p.cull = GL_BACK;
    gpu_use_target(&r->cache, &r->sun_target);
    gpu_use(&r->cache, &p);
    glClearBufferfv(GL_DEPTH, 0, &far_away);
    draw_world(r, w, &p, r->sun);
}

static void draw_prepass(renderer *r, const world *w) {
    static const GLfloat far_away = 0;
    gpu_pipeline p = {0};
    p.depth_func = GL_GREATER;
    p.write_depth = true;
    p.cull = GL_BACK;
    gpu_use_target(&r->cache, &r->world_target);
    gpu_use(&r->cache, &p);
    glClearBufferfv(GL_DEPTH, 0, &far_away);
    draw_world(r, w, &p, r->prepass);
}

static void draw_lit(renderer *r, const world *w) {
    static const GLfloat black[4] = {0};
    static const GLuint nobody[4] = {0};
    gpu_pipeline p = {0};
    p.depth_func = GL_EQUAL;
    p.write_colour = true;
    p.cull = GL_BACK;
    gpu_use_texture(&r->cache, UNIT_SUN, r->sun_target.depth);
    gpu_use(&r->cache, &p);
    glClearBufferfv(GL_COLOR, 0, black);
    glClearBufferfv(GL_COLOR, 1, black);
    glClearBufferuiv(GL_COLOR, 2, nobody);
    draw_world(r, w, &p, r->lit);
}

static void draw_screen(renderer *r, const gpu_target *target, GLuint program) {
    gpu_pipeline p = {0};
    p.program = program;
    p.write_colour = true;
    gpu_use_target(&r->cache, target);
    gpu_use(&r->cache, &p);
    gpu_use_vertex_array(&r->cache, r->empty_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void renderer_draw(renderer *r, const world *w, const camera *c) {
    set_frame(r, c);
    send_world(r, w);
    gpu_use_uniforms(&r->cache, BLOCK_FRAME, r->frame_buffer, 0, sizeof(frame_block));
    draw_sun(r, w);
    draw_prepass(r, w);
    draw_lit(r, w);
    gpu_use_texture(&r->cache, UNIT_COLOUR, r->world_target.colours[0]);
    gpu_use_texture(&r->cache, UNIT_NORMAL, r->world_target.colours[1]);
    gpu_use_texture(&r->cache, UNIT_ID, r->world_target.colours[2]);
    gpu_use_texture(&r->cache, UNIT_DEPTH, r->world_target.depth);
    draw_screen(r, &r->occlusion_target, r->occlusion);
    gpu_use_texture(&r->cache, UNIT_OPEN, r->occlusion_target.colours[0]);
    draw_screen(r, &r->picture, r->resolve);
}
