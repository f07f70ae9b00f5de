/* mock_oit_frames.c: frames of oit_buffers.h on a driver that is not there. It knows from the shaders' own text which
 * buffers a program reads and writes, and fails on an access without the right barrier, on a map without one, and, where
 * the test says so, on any wait; software drivers hide all of these. Its objects can be refused one after the other. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define OIT_BUFFERS_IMPLEMENTATION
#include "oit_buffers.h"

/* ---- the driver that is not there ---- */

enum { MAX_NAMES = 4096, MAX_CALLS = 4000000, POINTS = 8, READS = 1, WRITES = 2 };
enum { BUFFERS, ARRAYS, SHADERS, PROGRAMS, FENCES, TEXTURES, FRAMEBUFFERS, KINDS };

typedef struct fake_buffer {
    int64_t size;
    unsigned char *data;
    bool unseen_writes, unseen_reads; /* by shaders, since the last barrier of shader storage */
    bool unmappable;                  /* written by shaders since the last barrier of buffer updates */
    uint32_t writer, reader;          /* programs */
    long written;                     /* when; see driver.now */
} fake_buffer;

typedef struct fake_program {
    int uses[3]; /* of pixels, fragments, report: READS, WRITES */
    bool hosts;  /* count or fill */
} fake_program;

static struct {
    const char *version, *extension;
    int32_t samples;       /* of every framebuffer */
    int32_t default_depth; /* type of the attachment */
    uint32_t texture;
    bool missing_target;
    int live[KINDS];
    long creations, refuse_creation; /* the n-th creation fails; 0: none */
    int64_t memory;                  /* that BufferData has; 0: any */
    int refuse_compile, refuse_map;  /* 1: shaders; 2: programs */
    uint32_t next_name, program, vertex_array, framebuffer, copy_target, storage[POINTS], uniforms[POINTS * 8];
    fake_buffer buffers[MAX_NAMES];
    fake_program programs[MAX_NAMES];
    int shader_uses[MAX_NAMES][3];
    bool shader_hosts[MAX_NAMES];
    long now, finished; /* of commands; what the GPU has done */
    int waits;
    uint32_t totals[16];   /* what the report kernel finds */
    uint32_t pixel_starts; /* fragments of each pixel, for bands */
    const char *calls[MAX_CALLS];
    int call_count;
    int violations;
    bool quiet;                     /* violations are provoked now */
    long barriers, dropped_barrier; /* the n-th barrier does nothing; 0: none */
    long operators[2];              /* those before the first operator, and up to the composition */
    char text[8192];
} driver;

static bool allocation_fails;
static int allocations;

static void violate(const char *what, uint32_t buffer) {
    if (driver.violations++ < 8 && !driver.quiet)
        print_message("    violation: %s, buffer %u\n", what, buffer);
}

static void note(const char *name) {
    assert_true(driver.call_count < MAX_CALLS);
    driver.calls[driver.call_count++] = name;
    ++driver.now;
}

static int called_since(int first, const char *name) {
    int count = 0;
    for (int i = first; i < driver.call_count; ++i)
        count += strcmp(driver.calls[i], name) == 0;
    return count;
}

static uint32_t create(int kind) {
    if (++driver.creations == driver.refuse_creation)
        return 0;
    assert_true(driver.next_name + 1 < MAX_NAMES);
    ++driver.live[kind];
    return ++driver.next_name;
}

static const char *line_start(const char *source, const char *at) {
    while (at > source && at[-1] != '\n')
        --at;
    return at;
}

/* Whether a declaration is left out because what "#ifdef" in the line before it asks for is not defined. */
static bool is_left_out(const char *source, const char *at) {
    char name[64], definition[80];
    const char *line = line_start(source, at);
    if (line == source || sscanf(line_start(source, line - 1), "#ifdef %63s", name) != 1)
        return false;
    snprintf(definition, sizeof definition, "#define %s", name);
    return !strstr(source, definition);
}

/* How a program uses the storage buffer of that binding: by the qualifiers of its declaration. */
static int uses_of(const char *source, const char *binding) {
    char pattern[64];
    snprintf(pattern, sizeof pattern, "binding = %s)", binding);
    const char *at = strstr(source, pattern);
    while (at && is_left_out(source, at))
        at = strstr(at + 1, pattern);
    if (!at)
        return 0;
    at += strlen(pattern);
    const char *end = strstr(at, "buffer");
    assert_non_null(end);
    size_t length = (size_t)(end - at);
    char qualifiers[64] = "";
    assert_true(length < sizeof qualifiers);
    memcpy(qualifiers, at, length);
    return strstr(qualifiers, "readonly") ? READS : strstr(qualifiers, "writeonly") ? WRITES : READS | WRITES;
}

static void use(uint32_t name, int how, uint32_t program, bool hosts) {
    fake_buffer *buffer = &driver.buffers[name];
    if (name == 0 || how == 0)
        return;
    /* One pass of the host's may draw as often as it likes: atomics order themselves. */
    bool same = hosts && buffer->writer == program;
    if (buffer->unseen_writes && !same)
        violate(how & WRITES ? "written after a write without a barrier" : "read without a barrier", name);
    if ((how & WRITES) && buffer->unseen_reads && !(hosts && buffer->reader == program))
        violate("written while it may still be read", name);
    if (how & READS) {
        buffer->unseen_reads = true;
        buffer->reader = program;
    }
    if (how & WRITES) {
        buffer->unseen_writes = buffer->unmappable = true;
        buffer->writer = program;
        buffer->written = driver.now;
    }
}

static void run_program(void) {
    static const char *const names[3] = {"pixels", "fragments", "report"};
    const fake_program *p = &driver.programs[driver.program];
    assert_true(driver.program != 0);
    for (int i = 0; i < 3; ++i) {
        if (p->uses[i] && (driver.storage[i] == 0 || driver.buffers[driver.storage[i]].size == 0))
            fail_msg("nothing is bound for the %s", names[i]);
        use(driver.storage[i], p->uses[i], driver.program, p->hosts);
    }
}

#define U uint32_t
#define I int32_t
#define B unsigned char
#define FAKE(type, name, parameters, body)                                                                             \
    static type fake_##name parameters {                                                                               \
        note(#name);                                                                                                   \
        body                                                                                                           \
    }

FAKE(void, AttachShader, (U a, U b), for (int i = 0; i < 3; ++i) driver.programs[a].uses[i] |= driver.shader_uses[b][i];
     driver.programs[a].hosts |= driver.shader_hosts[b];)
FAKE(void, BindBuffer, (U a, U b), if (a == 0x8F37u) driver.copy_target = b;)
FAKE(void, BindBufferBase, (U a, U b, U c), if (a == 0x90D2u) driver.storage[b] = c; else driver.uniforms[b] = c;)
FAKE(void, BindBufferRange, (U a, U b, U c, ptrdiff_t d, ptrdiff_t e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(void, BindFramebuffer, (U a, U b), (void)a; driver.framebuffer = b;)
FAKE(void, BindVertexArray, (U a), driver.vertex_array = a;)
FAKE(void, BlendEquationSeparate, (U a, U b), (void)a; (void)b;)
FAKE(void, BlendEquationSeparatei, (U a, U b, U c), (void)a; (void)b; (void)c;)
FAKE(void, BlendFuncSeparate, (U a, U b, U c, U d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, BlendFuncSeparatei, (U a, U b, U c, U d, U e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(U, CheckFramebufferStatus, (U a), (void)a; bool missing = driver.missing_target; driver.missing_target = false;
     return missing ? 0x8CD6u : 0x8CD5u;)
FAKE(void, ColorMask, (B a, B b, B c, B d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, ColorMaski, (U a, B b, B c, B d, B e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(void, CompileShader, (U a), (void)a;)
FAKE(U, CreateProgram, (void), U name = create(PROGRAMS); memset(&driver.programs[name], 0, sizeof driver.programs[0]);
     return name;)
FAKE(U, CreateShader, (U a), (void)a; return create(SHADERS);)
FAKE(void, DeleteProgram, (U a), driver.live[PROGRAMS] -= a != 0;)
FAKE(void, DeleteShader, (U a), driver.live[SHADERS] -= a != 0;)
FAKE(void, DeleteSync, (void *a), driver.live[FENCES] -= a != NULL;)
FAKE(void, DeleteVertexArrays, (I a, const U *b), driver.live[ARRAYS] -= a * (b[0] != 0);)
FAKE(void, DepthFunc, (U a), (void)a;)
FAKE(void, DepthMask, (B a), (void)a;)
FAKE(void, DepthRangeIndexed, (U a, double b, double c), (void)a; (void)b; (void)c;)
FAKE(void, DepthRangef, (float a, float b), (void)a; (void)b;)
FAKE(void, Disable, (U a), (void)a;)
FAKE(void, Disablei, (U a, U b), (void)a; (void)b;)
FAKE(void, DispatchCompute, (U a, U b, U c), assert_true(a > 0 && a <= 65535 && b > 0 && b <= 65535 && c == 1);
     run_program();)
FAKE(void, DrawArrays, (U a, I b, I c), (void)a; (void)b; (void)c; assert_true(driver.vertex_array != 0);
     run_program();)
FAKE(void, Enable, (U a), (void)a;)
FAKE(void, Enablei, (U a, U b), (void)a; (void)b;)
FAKE(void, GenVertexArrays, (I a, U *b), assert_int_equal(a, 1); b[0] = create(ARRAYS);)
FAKE(void, GetBooleanv, (U a, B *b), (void)a; memset(b, 1, 4);)
FAKE(void, GetBooleani_v, (U a, U b, B *c), (void)a; (void)b; memset(c, 1, 4);)
FAKE(void, GetDoublei_v, (U a, U b, double *c), (void)a; (void)b; c[0] = 0; c[1] = 1;)
FAKE(void, GetFloati_v, (U a, U b, float *c), (void)a; (void)b; c[0] = c[1] = c[2] = c[3] = 7;)
FAKE(void, GetFloatv, (U a, float *b), (void)a; b[0] = 0; b[1] = 1;)
FAKE(void, GetInteger64v, (U a, int64_t *b), (void)a; *b = (int64_t)1 << 27;)
FAKE(void, GetInteger64i_v, (U a, U b, int64_t *c), (void)a; (void)b; *c = 0;)
FAKE(void, GetProgramInfoLog, (U a, I b, I *c, char *d), (void)a; (void)c; snprintf(d, (size_t)b, "link trouble");)
FAKE(void, GetProgramiv, (U a, U b, I *c), (void)a; (void)b; *c = driver.refuse_compile != 2;)
FAKE(void, GetShaderInfoLog, (U a, I b, I *c, char *d), (void)a; (void)c; snprintf(d, (size_t)b, "compile trouble");)
FAKE(void, GetShaderiv, (U a, U b, I *c), (void)a; (void)b; *c = driver.refuse_compile != 1;)
FAKE(I, GetUniformLocation, (U a, const char *b), (void)a; (void)b; return 1;)
FAKE(void, GetMultisamplefv, (U a, U b, float *c), assert_int_equal(a, 0x8E50); c[0] = 0.25f * (float)b; c[1] = 0.5f;)
FAKE(B, IsEnabled, (U a), (void)a; return 0;)
FAKE(B, IsEnabledi, (U a, U b), (void)a; (void)b; return 0;)
FAKE(B, IsProgram, (U a), return a != 0;)
FAKE(void, LinkProgram, (U a), (void)a;)
FAKE(void, PolygonMode, (U a, U b), (void)a; (void)b;)
FAKE(void, ProgramUniform4fv, (U a, I b, I c, const float *d), (void)b; (void)c; (void)d; assert_true(a != 0);)
FAKE(void, ProgramUniform4uiv, (U a, I b, I c, const U *d), (void)b; (void)c; (void)d; assert_true(a != 0);)
FAKE(void, Scissor, (I a, I b, I c, I d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, ScissorIndexed, (U a, I b, I c, I d, I e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(void, Uniform4fv, (I a, I b, const float *c), (void)a; (void)b; (void)c;)
FAKE(void, Uniform4uiv, (I a, I b, const U *c), (void)a; (void)b; (void)c;)
FAKE(void, UniformMatrix3fv, (I a, I b, B c, const float *d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, UniformMatrix4fv, (I a, I b, B c, const float *d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, BindTexture, (U a, U b), assert_int_equal(a, 0x0DE1); driver.texture = b;)
FAKE(void, DeleteFramebuffers, (I a, const U *b), driver.live[FRAMEBUFFERS] -= a * (b[0] != 0);)
FAKE(void, DeleteTextures, (I a, const U *b), driver.live[TEXTURES] -= a * (b[0] != 0);)
FAKE(void, DrawBuffers, (I a, const U *b), assert_int_equal(a, 8); assert_int_equal(b[7], 0x8CE7);)
FAKE(void, FramebufferRenderbuffer, (U a, U b, U c, U d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, FramebufferTexture2D, (U a, U b, U c, U d, I e), (void)a; (void)b; (void)c; (void)e;
     driver.missing_target |= d == 0;)
FAKE(void, GenFramebuffers, (I a, U *b), assert_int_equal(a, 1); b[0] = create(FRAMEBUFFERS);)
FAKE(void, GenTextures, (I a, U *b), assert_int_equal(a, 1); b[0] = create(TEXTURES);)
FAKE(void, GetFramebufferAttachmentParameteriv, (U a, U b, U c, I *d), (void)a; (void)c;
     *d = b == 0x1801 ? driver.default_depth : 0;)
FAKE(void, TexStorage2D, (U a, I b, U c, I d, I e), (void)a; (void)b; (void)c; assert_true(d > 0 && e > 0);)
FAKE(B, UnmapBuffer, (U a), (void)a; return 1;)
FAKE(void, UseProgram, (U a), driver.program = a;)
FAKE(void, Viewport, (I a, I b, I c, I d), (void)a; (void)b; (void)c; (void)d;)
FAKE(void, ViewportIndexedf, (U a, float b, float c, float d, float e), (void)a; (void)b; (void)c; (void)d; (void)e;)

static void fake_ShaderSource(U shader, I count, const char *const *strings, const I *lengths) {
    static char source[200000];
    static const char *const bindings[3] = {"OIT_BINDING_PIXELS", "OIT_BINDING_FRAGMENTS", "OIT_BINDING_REPORT"};
    note("ShaderSource");
    (void)lengths;
    source[0] = 0;
    for (I i = 0; i < count; ++i) {
        assert_true(strlen(source) + strlen(strings[i]) < sizeof source);
        strcat(source, strings[i]);
    }
    driver.shader_hosts[shader] = strstr(source, "void oit_store(vec4 color)") != NULL;
    for (int i = 0; i < 3; ++i)
        driver.shader_uses[shader][i] = uses_of(source, bindings[i]);
    /* Records are read where they lie in runs, or in lists. */
    bool lists = strstr(source, "#define OIT_BINDING_RECORDS OIT_BINDING_REPORT") != NULL;
    driver.shader_uses[shader][lists ? 2 : 1] |= uses_of(source, "OIT_BINDING_RECORDS");
    if (strstr(source, "#define OIT_PASS 0\n") ||
        strstr(source, "inout highp uvec2 oit_seen")) /* counting stores nothing; fetching not in a buffer */
        driver.shader_uses[shader][1] = 0;
    if (strstr(source, "#define OIT_ARRANGES 1\n")) /* of two declarations the second holds */
        driver.shader_uses[shader][0] = READS | WRITES;
}

static void fake_GenBuffers(I count, U *names) {
    note("GenBuffers");
    assert_int_equal(count, 1);
    names[0] = create(BUFFERS);
}

static void fake_DeleteBuffers(I count, const U *names) {
    note("DeleteBuffers");
    for (I i = 0; i < count; ++i) {
        driver.live[BUFFERS] -= names[i] != 0;
        free(driver.buffers[names[i]].data);
        memset(&driver.buffers[names[i]], 0, sizeof driver.buffers[0]);
    }
}

static void fake_BufferData(U target, ptrdiff_t size, const void *data, U usage) {
    fake_buffer *buffer = &driver.buffers[driver.copy_target];
    note("BufferData");
    (void)data, (void)usage;
    assert_int_equal(target, 0x8F37);
    assert_true(driver.copy_target != 0 && size > 0);
    free(buffer->data);
    memset(buffer, 0, sizeof *buffer);
    if (driver.memory && size > driver.memory)
        return;
    buffer->size = size;
    buffer->data = calloc(1, (size_t)size);
}

static void fake_BufferSubData(U target, ptrdiff_t offset, ptrdiff_t size, const void *data) {
    fake_buffer *buffer = &driver.buffers[driver.copy_target];
    note("BufferSubData");
    assert_int_equal(target, 0x8F37);
    assert_true(offset >= 0 && offset + size <= buffer->size);
    memcpy(buffer->data + offset, data, (size_t)size);
}

static void fake_GetBufferParameteri64v(U target, U what, int64_t *value) {
    note("GetBufferParameteri64v");
    assert_int_equal(target, 0x8F37);
    assert_int_equal(what, 0x8764);
    *value = driver.buffers[driver.copy_target].size;
}

static void fake_MemoryBarrier(U bits) {
    note("MemoryBarrier");
    if (++driver.barriers == driver.dropped_barrier)
        return;
    for (U i = 1; i <= driver.next_name; ++i) {
        if (bits & 0x2000u)
            driver.buffers[i].unseen_writes = driver.buffers[i].unseen_reads = false;
        if (bits & 0x200u)
            driver.buffers[i].unmappable = false;
    }
}

/* What shaders would have written there. */
static void write_results(fake_buffer *buffer) {
    if (buffer->size == 64) {
        memcpy(buffer->data, driver.totals, 64);
        return;
    }
    if (buffer->size == 128) { /* a pick: layers, found; nothing else is looked at */
        ((uint32_t *)(void *)buffer->data)[3] = 12;
        return;
    }
    uint32_t *words = (uint32_t *)(void *)buffer->data;
    for (int64_t i = 0; 16 + 2 * i < buffer->size / 4; ++i)
        words[16 + 2 * i] = (uint32_t)i * driver.pixel_starts;
}

static void *fake_MapBufferRange(U target, ptrdiff_t offset, ptrdiff_t length, U access) {
    fake_buffer *buffer = &driver.buffers[driver.copy_target];
    note("MapBufferRange");
    assert_int_equal(target, 0x8F37);
    assert_int_equal(access, 1);
    assert_true(offset >= 0 && length > 0 && offset + length <= buffer->size);
    if (buffer->unmappable)
        violate("mapped without a barrier", driver.copy_target);
    if (buffer->written > driver.finished) {
        ++driver.waits;
        driver.finished = driver.now;
    }
    if (driver.refuse_map)
        return NULL;
    write_results(buffer);
    return buffer->data + offset;
}

static void *fake_FenceSync(U condition, U flags) {
    note("FenceSync");
    (void)condition, (void)flags;
    if (++driver.creations == driver.refuse_creation)
        return NULL;
    ++driver.live[FENCES];
    return (void *)(uintptr_t)driver.now;
}

static U fake_ClientWaitSync(void *fence, U flags, uint64_t timeout) {
    note("ClientWaitSync");
    assert_int_equal(flags, 1);
    if (timeout > 0 && (long)(uintptr_t)fence > driver.finished) {
        ++driver.waits;
        driver.finished = driver.now;
    }
    return (long)(uintptr_t)fence <= driver.finished ? 0x911Au : 0x911Bu;
}

static void fake_GetIntegerv(U what, I *out) {
    note("GetIntegerv");
    switch (what) {
    case 0x8F37:
        *out = (I)driver.copy_target;
        break;
    case 0x8B8D:
        *out = (I)driver.program;
        break;
    case 0x85B5:
        *out = (I)driver.vertex_array;
        break;
    case 0x8CA6:
        *out = (I)driver.framebuffer;
        break;
    case 0x8069:
        *out = (I)driver.texture;
        break;
    case 0x80A9:
        *out = driver.samples;
        break;
    case 0x821D:
        *out = 1;
        break;
    case 0x0D3A:
        out[0] = out[1] = 16384;
        break;
    case 0x90DA:
    case 0x90DB:
        *out = 8;
        break;
    case 0x8F39:
        *out = 16;
        break;
    case 0x90EB:
        *out = 1024;
        break;
    case 0x90DD:
        *out = POINTS;
        break;
    case 0x8A2F:
        *out = 36;
        break;
    case 0x8824:
        *out = 8;
        break;
    case 0x825B:
        *out = 16;
        break;
    case 0x0D32:
        *out = 8;
        break;
    case 0x0BA2:
    case 0x0C10:
        memset(out, 0, 4 * sizeof *out);
        break;
    case 0x0B40:
        out[0] = out[1] = 0x1B02;
        break;
    default:
        *out = 0;
        break;
    }
}

static void fake_GetIntegeri_v(U what, U index, I *out) {
    note("GetIntegeri_v");
    if (what == 0x0C10)
        memset(out, 0, 4 * sizeof *out);
    else
        *out = what == 0x90D3 ? (I)driver.storage[index] : what == 0x8A28 ? (I)driver.uniforms[index] : 0;
}

static const unsigned char *fake_GetString(U name) {
    (void)name;
    return (const unsigned char *)driver.version;
}

static const unsigned char *fake_GetStringi(U name, U index) {
    (void)name, (void)index;
    return (const unsigned char *)driver.extension;
}

static oit_proc get_proc(const char *name) {
#define GIVE(type, function, parameters)                                                                               \
    if (strcmp(name, "gl" #function) == 0)                                                                             \
        return (oit_proc)fake_##function;
    OIT_I_GL_QUERIES(GIVE)
    OIT_I_GL_REQUIRED(GIVE)
    OIT_I_GL_DESKTOP(GIVE)
    OIT_I_GL_INDEXED(GIVE)
    OIT_I_GL_ES(GIVE)
    OIT_I_GL_FETCH(GIVE)
    return NULL;
}

/* ---- the host ---- */

static void *allocate(size_t size, void *user) {
    (void)user;
    if (allocation_fails)
        return NULL;
    ++allocations;
    return malloc(size);
}

static void release(void *block, void *user) {
    (void)user;
    --allocations;
    free(block);
}

static void on_log(oit_log_level level, oit_result code, const char *text, void *user) {
    (void)level, (void)code, (void)user;
    if (strlen(driver.text) + strlen(text) + 2 < sizeof driver.text) {
        strcat(driver.text, text);
        strcat(driver.text, "\n");
    }
}

static int set_up(void **state) {
    (void)state;
    memset(&driver, 0, sizeof driver);
    driver.version = "4.5.0 Mock";
    driver.extension = "GL_OES_sample_variables";
    driver.pixel_starts = 2;
    driver.program = 4000;
    driver.vertex_array = 77;
    driver.framebuffer = 5;
    driver.copy_target = 78;
    allocation_fails = false;
    allocations = 0;
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    for (int i = 0; i < MAX_NAMES; ++i)
        free(driver.buffers[i].data);
    for (int i = 0; i < KINDS; ++i)
        if (driver.live[i] != 0) {
            print_error("%d objects of kind %d are left\n", driver.live[i], i);
            return 1;
        }
    return allocations != 0 || driver.violations != 0;
}

static oit_context *make(oit_desc desc) {
    desc.get_proc = get_proc;
    desc.alloc_fn = allocate;
    desc.free_fn = release;
    desc.log_fn = on_log;
    const char *extension = driver.extension;
    if (desc.store == OIT_STORE_FETCH)
        driver.extension = "GL_EXT_shader_framebuffer_fetch";
    oit_context *oit = oit_create(&desc, NULL);
    driver.extension = extension;
    assert_non_null(oit);
    return oit;
}

static void set_totals(uint32_t fragments, uint32_t deepest) {
    const uint32_t totals[16] = {fragments, deepest, 0, 0, 0, fragments};
    memcpy(driver.totals, totals, sizeof totals);
}

static const oit_frame frame = {.framebuffer = 5, .width = 64, .height = 48};

/* Two draws a pass. Under OIT_STATE_NONE the test does what the pass says. */
static oit_result draw_passes(oit_context *oit, int *passes) {
    oit_pass pass;
    while (oit_next_pass(oit, &pass)) {
        bool raw = oit->desc.state == OIT_STATE_NONE;
        if (raw) {
            fake_UseProgram(pass.state.program);
            for (U i = 0; i < 3; ++i)
                fake_BindBufferBase(0x90D2u, i, pass.state.storage_buffers[i]);
        }
        ++*passes;
        if (raw && pass.state.groups[0]) {
            fake_DispatchCompute(pass.state.groups[0], pass.state.groups[1], pass.state.groups[2]);
        } else {
            fake_DrawArrays(4, 0, 3);
            if (!pass.state.vertex_count)
                fake_DrawArrays(4, 0, 3);
        }
    }
    return OIT_OK;
}

static oit_result draw_frame(oit_context *oit, const oit_frame *f, int *passes) {
    int ignored = 0;
    oit_result result = oit_begin(oit, f), end;
    if (result != OIT_OK)
        return result;
    draw_passes(oit, passes ? passes : &ignored);
    result = oit_compose(oit);
    if (oit->desc.state == OIT_STATE_NONE)
        draw_passes(oit, passes ? passes : &ignored);
    end = oit_end(oit);
    return result != OIT_OK ? result : end;
}

/* ---- barriers and waits ---- */

static const oit_desc descs[] = {
    {.fit = OIT_FIT_WAIT},
    {.fit = OIT_FIT_ASYNC},
    {.fit = OIT_FIT_ASYNC, .state = OIT_STATE_NONE},
    {.fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_ALL, .color = OIT_COLOR_FLOAT},
    {.fit = OIT_FIT_WAIT, .ceiling_bytes = 64 * 16 * 9}, /* bands of rows */
    {.fit = OIT_FIT_WAIT, .ceiling_bytes = 16 * 9},      /* bands of parts of rows */
    {.fit = OIT_FIT_WAIT, .max_block_bytes = 9000},      /* slabs */
    {.fit = OIT_FIT_ASYNC, .max_block_bytes = 12000},    /* slabs */
    {.store = OIT_STORE_PREDICT},
    {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC},
    {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC, .state = OIT_STATE_NONE},
    {.store = OIT_STORE_PREDICT, .ceiling_bytes = 64 * 16 * 9},
    {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC, .max_block_bytes = 15000},
    {.store = OIT_STORE_LINKED},
    {.store = OIT_STORE_LINKED, .fit = OIT_FIT_ASYNC},
    {.store = OIT_STORE_LINKED, .fit = OIT_FIT_ASYNC, .state = OIT_STATE_NONE},
    {.store = OIT_STORE_LINKED, .ceiling_bytes = 64 * 16 * 18},
    {.store = OIT_STORE_LINKED, .fit = OIT_FIT_ASYNC, .max_block_bytes = 15000},
    {.store = OIT_STORE_FETCH},
    {.store = OIT_STORE_FETCH, .fit = OIT_FIT_ASYNC},
    {.store = OIT_STORE_BUDGET, .layers = 8},
    {.store = OIT_STORE_BUDGET, .layers = 70, .fit = OIT_FIT_ASYNC, .fields = OIT_FIELD_BLEND},
    {.store = OIT_STORE_BUDGET, .budget_bytes = 1, .fit = OIT_FIT_ASYNC, .state = OIT_STATE_NONE}, /* no layer */
    {.store = OIT_STORE_BUDGET, .layers = 3, .fit = OIT_FIT_ASYNC, .max_block_bytes = 20000},      /* slabs */
    {.store = OIT_STORE_BUCKETED, .layers = 8, .fields = OIT_FIELD_PART},
    {.store = OIT_STORE_BUCKETED, .layers = 8, .fields = OIT_FIELD_PART, .fit = OIT_FIT_ASYNC, .bucket_depth_bits = 16},
    {.store = OIT_STORE_BUCKETED,
     .layers = 8,
     .fields = OIT_FIELD_PART | OIT_FIELD_KEY | OIT_FIELD_BLEND | OIT_FIELD_NORMAL | OIT_FIELD_UV,
     .fit = OIT_FIT_ASYNC,
     .state = OIT_STATE_NONE,
     .color = OIT_COLOR_HALF},
    {.store = OIT_STORE_BUCKETED, .layers = 3, .fields = OIT_FIELD_PART, .max_block_bytes = 20000}, /* slabs */
};

/* tear_down fails where a barrier was missing. */
static void test_barriers(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es)
        for (size_t i = 0; i < sizeof descs / sizeof descs[0]; ++i) {
            driver.version = es ? "OpenGL ES 3.1 Mock" : "4.3.0 Mock";
            oit_context *oit = make(descs[i]);
            set_totals(64 * 48 * 2, 300);
            for (int run = 0; run < 5; ++run) {
                int passes = 0;
                driver.totals[8] = run >= 3; /* few shallow pixels: the first program of compose is not drawn */
                driver.totals[10] = run >= 3 ? 3000 : 0;
                driver.totals[2] = run == 2; /* a pixel that did not fit: OIT_STORE_PREDICT fills again */
                assert_int_equal(draw_frame(oit, &frame, &passes), OIT_OK);
                assert_true(passes >= (descs[i].store == OIT_STORE_EXACT ? 2 : 1));
                driver.finished = driver.now;
            }
            driver.call_count = 0; /* nobody looks back as far */
            oit_destroy(oit);
            assert_int_equal(driver.violations, 0);
        }
}

/* In a steady frame nothing is created, allocated or waited for, whatever the GPU's lag. */
static void test_steady_frames(void **state) {
    static const char *const never[] = {"GenBuffers",    "BufferData",         "GenVertexArrays", "CreateShader",
                                        "CreateProgram", "GetUniformLocation", "BufferSubData",   "DeleteBuffers"};
    (void)state;
    for (int lag = 0; lag < 5; ++lag)
        for (size_t i = 0; i < sizeof descs / sizeof descs[0]; ++i) {
            long ends[16] = {0};
            oit_context *oit = make(descs[i]);
            int kept = 0, waits = 0;
            set_totals(64 * 48 * 2, 30);
            for (int run = 0; run < 12; ++run) {
                int first = driver.call_count;
                if (run == 8) {
                    kept = allocations;
                    waits = driver.waits;
                }
                assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
                ends[run] = driver.now;
                if (run >= lag && ends[run - lag] > driver.finished)
                    driver.finished = ends[run - lag];
                if (run < 8 || descs[i].ceiling_bytes || descs[i].max_block_bytes)
                    continue; /* bands and slabs change the uniform block as they go */
                for (size_t k = 0; k < sizeof never / sizeof never[0]; ++k)
                    if (called_since(first, never[k]) && !(descs[i].fit == OIT_FIT_WAIT && k == 6))
                        fail_msg("%s in a steady frame", never[k]);
            }
            assert_int_equal(allocations, kept);
            if (descs[i].fit == OIT_FIT_ASYNC)
                assert_int_equal(driver.waits, waits);
            oit_destroy(oit);
            driver.call_count = 0;
            set_up(state);
        }
}

/* OIT_FIT_ASYNC never waits, not even while it grows. */
static void test_growth_does_not_wait(void **state) {
    (void)state;
    oit_desc desc = {.fit = OIT_FIT_ASYNC};
    oit_context *oit = make(desc);
    oit_report report;
    set_totals(100000, 40);
    for (int run = 0; run < 6; ++run) {
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        if (run >= 1)
            driver.finished = driver.now;
    }
    assert_int_equal(driver.waits, 0);
    assert_int_equal(oit_get_report(oit, &report), OIT_OK);
    assert_int_equal(report.needed, 100000);
    assert_int_equal(report.capacity, 125001);
    /* Much less for a while: it shrinks, but not at once. */
    set_totals(1000, 4);
    for (int run = 0; run < 70; ++run) {
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        driver.finished = driver.now;
        driver.call_count = 0;
        if (run == 40)
            assert_int_equal(oit->capacity, 125001);
    }
    assert_int_equal(oit->capacity, 1251);
    assert_int_equal(driver.waits, 0);
    oit_destroy(oit);
}

/* One read-back a frame between count and fill, and none else unless a report is asked for. */
static void test_wait_waits_once(void **state) {
    (void)state;
    oit_desc desc = {.fit = OIT_FIT_WAIT};
    oit_context *oit = make(desc);
    set_totals(5000, 10);
    for (int run = 0; run < 6; ++run) {
        int before = driver.waits, first = driver.call_count;
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        assert_int_equal(driver.waits, before + 1);
        if (run == 0)
            assert_int_equal(called_since(first, "MapBufferRange"), 1);
        driver.finished = driver.now;
    }
    oit_destroy(oit);
}

/* ---- picks and the depth of the composite ---- */

static const oit_frame frame_with_depth = {
    .framebuffer = 5, .width = 64, .height = 48, .depth = OIT_DEPTH_MEDIAN, .depth_framebuffer = 6};

/* Both in each kind of frame; tear_down fails where a barrier was missing. Other frames have no pass of theirs, nor the
 * program. */
static void test_barriers_of_picks_and_depths(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof descs / sizeof descs[0]; ++i) {
        oit_context *oit = make(descs[i]);
        oit_pick pick = {0};
        if (descs[i].store == OIT_STORE_FETCH) { /* keeps no layers to pick from */
            assert_int_equal(oit_pick_begin(oit, 60, 47, 1), OIT_INVALID_ARGUMENT);
            assert_int_equal(oit_begin(oit, &frame_with_depth), OIT_INVALID_ARGUMENT);
            oit_destroy(oit);
            continue;
        }
        set_totals(64 * 48 * 2, 300);
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        assert_int_equal(oit->programs[OIT_I_PROGRAM_PICK] + oit->programs[OIT_I_PROGRAM_DEPTH], 0);
        for (int run = 0; run < 4; ++run) {
            assert_int_equal(oit_pick_begin(oit, 60, 47, 1), OIT_OK);
            assert_int_equal(oit_pick_begin(oit, 3, 0, 0), OIT_OK);
            assert_int_equal(oit_pick_begin(oit, 64, 0, 0), OIT_OK); /* outside */
            assert_int_equal(draw_frame(oit, &frame_with_depth, NULL), OIT_OK);
            driver.finished = driver.now;
            for (int k = 0; k < 3; ++k) {
                assert_int_equal(oit_pick_result(oit, 0, &pick), OIT_OK);
                assert_int_equal(pick.layers, k < 2 ? 12 : 0);
            }
            assert_int_equal(driver.copy_target, 78);
        }
        oit_destroy(oit);
        assert_int_equal(driver.violations, 0);
    }
}

/* A pick in each frame, whose answer is asked for and not waited for: nothing is created, nothing waits. */
static void test_picks_do_not_wait(void **state) {
    static const char *const never[] = {"GenBuffers", "BufferData", "CreateProgram", "CreateShader"};
    (void)state;
    for (size_t lag = 0; lag < 3; ++lag) {
        oit_context *oit = make(descs[1]);
        long ends[16] = {0};
        int answers = 0;
        set_totals(64 * 48 * 2, 30);
        for (size_t run = 0; run < 12; ++run) {
            oit_pick pick = {0};
            int first = driver.call_count;
            assert_int_equal(oit_pick_begin(oit, 5, 7, 0), OIT_OK);
            assert_int_equal(draw_frame(oit, &frame_with_depth, NULL), OIT_OK);
            ends[run] = driver.now;
            if (run >= lag && ends[run - lag] > driver.finished)
                driver.finished = ends[run - lag];
            oit_result result = oit_pick_result(oit, 0, &pick);
            assert_int_equal(result, run >= lag ? OIT_OK : OIT_NOT_READY);
            answers += result == OIT_OK;
            for (size_t k = 0; k < sizeof never / sizeof never[0]; ++k)
                if (run > 6 && called_since(first, never[k]))
                    fail_msg("%s in a steady frame", never[k]);
        }
        assert_int_equal(answers, 12 - lag);
        assert_int_equal(driver.waits, 0);
        if (lag) { /* asked for, it waits */
            oit_pick pick = {0};
            assert_int_equal(oit_pick_result(oit, 1, &pick), OIT_OK);
            assert_int_equal(driver.waits, 1);
        }
        /* Where all reports are under way, no other barrier comes before the fence. */
        oit_pick last = {0};
        while (oit_pick_result(oit, 1, &last) == OIT_OK)
            continue;
        for (int run = 0; run < 4; ++run) {
            if (run == 3)
                assert_int_equal(oit_pick_begin(oit, 5, 7, 0), OIT_OK);
            assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        }
        assert_int_equal(oit->slot, -1);
        assert_int_equal(oit_pick_result(oit, 1, &last), OIT_OK);
        oit_destroy(oit);
        assert_int_equal(driver.violations, 0);
        set_up(state);
    }
}

/* Every creation refused in turn, with a pick and a depth. */
static void test_picks_with_creations_refused(void **state) {
    long total = 1;
    (void)state;
    for (long refused = 1; refused <= total; ++refused) {
        set_up(state);
        oit_context *oit = make(descs[0]);
        oit_pick pick = {0};
        set_totals(20000, 10);
        driver.refuse_creation = refused;
        bool asked = oit_pick_begin(oit, 5, 7, 0) == OIT_OK;
        oit_result result = draw_frame(oit, &frame_with_depth, NULL);
        if (result != OIT_OK || !asked)
            assert_true(strlen(driver.text) > 0);
        assert_int_equal(driver.program, 4000);
        assert_int_equal(driver.copy_target, 78);
        if (!asked)
            assert_int_equal(oit_pick_begin(oit, 5, 7, 0), OIT_OK);
        assert_int_equal(draw_frame(oit, &frame_with_depth, NULL), OIT_OK);
        assert_int_equal(oit_pick_result(oit, 1, &pick), OIT_OK); /* of the second frame where the first had no fence */
        assert_int_equal(pick.layers, 12);
        driver.finished = driver.now;
        if (driver.creations > total)
            total = driver.creations;
        oit_destroy(oit);
        assert_int_equal(tear_down(state), 0);
        memset(driver.buffers, 0, sizeof driver.buffers);
    }
    assert_true(total > 20);
}

/* ---- multisampled targets ---- */

/* With the same eyes; and what is refused, with the reason. */
static void test_multisampled_targets(void **state) {
    static const char *const extensions[] = {"GL_ARB_post_depth_coverage", "GL_EXT_post_depth_coverage", "none"};
    (void)state;
    for (int i = 0; i < 12; ++i) {
        oit_desc desc = {.fields = OIT_FIELD_COVERAGE | (i & 1 ? (uint32_t)OIT_FIELD_BLEND : 0u),
                         .fit = i & 2 ? OIT_FIT_ASYNC : OIT_FIT_WAIT};
        driver.version = i >= 8 ? "OpenGL ES 3.1 Mock" : "4.3.0 Mock";
        driver.extension = i >= 8 ? "GL_OES_sample_variables" : extensions[i / 4 * 2];
        oit_context *oit = make(desc);
        assert_int_equal(oit->desc.sample_order, i >= 4);
        set_totals(64 * 48 * 2, 300);
        for (int run = 0; run < 4; ++run) {
            driver.samples = run == 2 ? 0 : 4;
            assert_int_equal(draw_frame(oit, &frame_with_depth, NULL), OIT_OK);
            driver.finished = driver.now;
        }
        /* Beside 16 words, 3,072 pixels of two words and one start more, 3 sums and the tail: a word a pixel. */
        assert_int_equal(oit->sizes[OIT_I_PIXELS], 4 * (16 + (i & 2 ? 6 : 2) * 3072 + 2 + 3 + 3072));
        assert_int_equal(oit->block.samples[0], 15);
        assert_true(oit->block.positions[3][0] == 0.25f && oit->block.positions[0][0] == -0.5f);
        driver.samples = 16;
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_TARGET_MULTISAMPLED);
        assert_non_null(strstr(driver.text, "more than OIT_MAX_SAMPLES"));
        oit_destroy(oit);
    }
    driver.samples = 2;
    oit_context *plain = make(descs[0]);
    assert_int_equal(draw_frame(plain, &frame, NULL), OIT_TARGET_MULTISAMPLED);
    driver.samples = 0;
    assert_int_equal(draw_frame(plain, &frame, NULL), OIT_OK);
    assert_int_equal(plain->sizes[OIT_I_PIXELS], 4 * (16 + 2 * 3072 + 2 + 3));
    for (int k = OIT_I_PROGRAM_SAMPLED; k < OIT_I_PROGRAMS; ++k)
        assert_int_equal(plain->programs[k], 0);
    assert_int_equal(plain->sizes[OIT_I_PICKED], 0);
    assert_non_null(strstr(driver.text, "OIT_FIELD_COVERAGE has to be chosen"));
    assert_int_equal(driver.framebuffer, 5);
    oit_destroy(plain);
    oit_desc desc = {.get_proc = get_proc, .log_fn = on_log, .fields = OIT_FIELD_COVERAGE};
    oit_result result;
    driver.extension = "none";
    assert_null(oit_create(&desc, &result));
    assert_int_equal(result, OIT_LIMIT_TOO_SMALL);
    assert_non_null(strstr(driver.text, "GL_OES_sample_variables, which is not there; layers(n)"));
    desc.state = OIT_STATE_NONE;
    desc.fit = OIT_FIT_ASYNC;
    assert_null(oit_create(&desc, &result));
    assert_int_equal(result, OIT_INVALID_ARGUMENT);
}

/* ---- faults ---- */

/* Every creation refused in turn: an error or a frame, nothing left, the host's bindings as they were, and the next frame
 * works. */
static void test_every_creation_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof descs / sizeof descs[0]; ++i) {
        if (descs[i].ceiling_bytes || descs[i].max_block_bytes)
            continue;
        long total = 1;
        for (long refused = 1; refused <= total; ++refused) {
            set_up(state);
            oit_context *oit = make(descs[i]);
            set_totals(20000, 10);
            driver.refuse_creation = refused;
            oit_result result = draw_frame(oit, &frame, NULL);
            if (result == OIT_OK)
                result = draw_frame(oit, &frame, NULL);
            if (result != OIT_OK)
                assert_true(strlen(driver.text) > 0);
            if (descs[i].state == OIT_STATE_RESTORE) {
                assert_int_equal(driver.program, 4000);
                assert_int_equal(driver.vertex_array, 77);
                assert_int_equal(driver.framebuffer, 5);
            }
            assert_int_equal(driver.copy_target, 78);
            driver.finished = driver.now;
            assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
            if (driver.creations > total)
                total = driver.creations;
            oit_destroy(oit);
            assert_int_equal(tear_down(state), 0);
            memset(driver.buffers, 0, sizeof driver.buffers);
        }
        assert_true(total > 20);
    }
}

static void test_shaders_that_fail(void **state) {
    (void)state;
    for (int how = 1; how <= 2; ++how) {
        oit_context *oit = make(descs[0]);
        driver.refuse_compile = how;
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_SHADER_FAILED);
        assert_non_null(strstr(driver.text, how == 1 ? "compile trouble" : "link trouble"));
        driver.refuse_compile = 0;
        assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        oit_destroy(oit);
    }
}

/* Less memory than growth asks for: fewer fragments, in bands; none at all: an error, and the next frame works. */
static void test_no_memory_mid_growth(void **state) {
    (void)state;
    oit_report report;
    oit_context *oit = make(descs[0]);
    set_totals(64 * 48 * 2, 2);
    driver.memory = 30000; /* the pixels take 24,652 bytes */
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
    driver.finished = driver.now;
    assert_int_equal(oit_get_report(oit, &report), OIT_OK);
    assert_true(report.bands > 1 && report.capacity <= 30000 / 16);
    oit_destroy(oit);

    oit = make(descs[0]);
    driver.memory = 8;
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OUT_OF_MEMORY);
    assert_int_equal(driver.copy_target, 78);
    driver.memory = 0;
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
    oit_destroy(oit);

    oit = make(descs[0]);
    driver.refuse_map = 1;
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OUT_OF_MEMORY);
    driver.refuse_map = 0;
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
    allocation_fails = true;
    oit_destroy(oit);
    allocation_fails = false;
    oit = make(descs[0]);
    allocation_fails = true;
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OUT_OF_MEMORY);
    allocation_fails = false;
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
    oit_destroy(oit);
}

/* Growth that finds no memory in the second frame, whatever the store; the third works. */
static void test_no_memory_for_growth_of_any_store(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof descs / sizeof descs[0]; ++i) {
        if (descs[i].ceiling_bytes || descs[i].max_block_bytes || oit_i_keeps(&descs[i])) /* those do not grow */
            continue;
        oit_context *oit = make(descs[i]);
        for (int run = 0; run < 6; ++run) {
            set_totals(run < 2 ? 3000 : 300000, 20);
            driver.pixel_starts = run < 2 ? 1 : 2;
            driver.memory = run == 2 || run == 3 ? 8 : 0;
            oit_result result = draw_frame(oit, &frame, NULL);
            assert_true(result == OIT_OK || (result == OIT_OUT_OF_MEMORY && driver.memory));
            assert_int_equal(driver.copy_target, 78);
            driver.finished = driver.now;
        }
        assert_true(oit->capacity >= 300000 || descs[i].store == OIT_STORE_FETCH); /* which has no pool */
        oit_destroy(oit);
        driver.call_count = 0;
    }
}

/* OIT_STORE_PREDICT with OIT_FIT_WAIT: one read-back a frame, after the fill; two more passes and one more read-back where
 * something did not fit; and the first frame is counted. */
static void test_predicted_frames(void **state) {
    static const oit_pass_kind expected[3][4] = {
        {OIT_PASS_COUNT, OIT_PASS_FILL}, {OIT_PASS_FILL}, {OIT_PASS_FILL, OIT_PASS_FILL}};
    (void)state;
    oit_desc desc = {.store = OIT_STORE_PREDICT};
    oit_context *oit = make(desc);
    oit_frame f = frame;
    set_totals(5000, 10);
    for (int run = 0; run < 8; ++run) {
        int kind = run == 0 || run == 5 || run == 7 ? 0 : run == 3 ? 2 : 1, waits = driver.waits, passes = 0;
        oit_pass pass;
        driver.totals[2] = run == 3;
        f.cut = run == 5;
        f.width = run == 7 ? 63 : 64; /* counts of another size are none */
        assert_int_equal(oit_begin(oit, &f), OIT_OK);
        for (; oit_next_pass(oit, &pass); ++passes) {
            assert_int_equal(pass.kind, expected[kind][passes]);
            fake_DrawArrays(4, 0, 3);
            driver.totals[2] = run == 3 && passes == 0;
        }
        assert_int_equal(passes, kind == 1 ? 1 : 2);
        assert_int_equal(oit_compose(oit), OIT_OK);
        assert_int_equal(oit_end(oit), OIT_OK);
        assert_int_equal(driver.waits, waits + (kind == 2 ? 2 : 1));
        driver.finished = driver.now;
    }
    oit_destroy(oit);
}

/* OIT_STORE_FETCH: as many geometry passes as 15 layers take, known by one read-back after the first, or from the frame
 * before; a depth that it cannot share and a ceiling below its targets are refused. */
static void test_fetched_frames(void **state) {
    (void)state;
    for (int fit = 0; fit < 2; ++fit) {
        oit_desc desc = {.store = OIT_STORE_FETCH, .fit = (oit_fit)fit};
        oit_context *oit = make(desc);
        set_totals(5000, 15);
        for (int run = 0; run < 4; ++run) {
            int waits = driver.waits, passes = 0;
            assert_int_equal(draw_frame(oit, &frame, &passes), OIT_OK);
            assert_int_equal(passes, fit && run == 0 ? 1 : 3);
            assert_int_equal(driver.waits, waits + !fit);
            assert_int_equal(driver.texture, 0);
            driver.finished = driver.now;
        }
        oit_frame bad = frame;
        bad.framebuffer = 0;
        driver.default_depth = 0x8218;
        assert_int_equal(oit_begin(oit, &bad), OIT_NO_FETCH);
        assert_int_equal(driver.framebuffer, 5);
        driver.default_depth = 0;
        assert_int_equal(draw_frame(oit, &bad, NULL), OIT_OK);
        oit_destroy(oit);
        desc.ceiling_bytes = 64 * 48 * 120 - 1;
        oit = make(desc);
        assert_int_equal(oit_begin(oit, &frame), OIT_TOO_LARGE);
        oit_destroy(oit);
        desc.get_proc = get_proc;
        oit_result result;
        driver.extension = "GL_EXT_shader_framebuffer_fetch_non_coherent";
        assert_null(oit_create(&desc, &result));
        assert_int_equal(result, OIT_NO_FETCH);
    }
}

/* The stores that keep the k nearest: no memory for the pixels or for the fragments is an error, and the next frame works,
 * with what the budget has room for at its size; smaller ones need no new buffer. */
static void test_no_memory_for_a_budget(void **state) {
    static const int widths[] = {64, 64, 64, 32, 16, 64, 640};
    (void)state;
    for (int store = 0; store < 2; ++store) {
        oit_desc desc = {.store = store ? OIT_STORE_BUCKETED : OIT_STORE_BUDGET, .fields = OIT_FIELD_PART};
        desc.budget_bytes = 64 * 48 * (store ? 28 : 20) * 5;
        oit_context *oit = make(desc);
        for (int run = 0; run < 7; ++run) {
            int first = driver.call_count, k = 64 * 5 / widths[run];
            oit_frame f = frame;
            f.width = widths[run];
            driver.memory = run == 0 ? 1000 : run == 1 ? 64 * 48 * 16 * 5 - 1 : 0; /* neither; no fragments */
            oit_result result = draw_frame(oit, &f, NULL);
            assert_int_equal(result, driver.memory ? OIT_OUT_OF_MEMORY : OIT_OK);
            assert_int_equal(driver.copy_target, 78);
            assert_int_equal(driver.program, 4000);
            if (run > 1) {
                assert_int_equal(oit->layers, k);
                assert_int_equal(oit->capacity, k * widths[run] * 48);
            }
            if (run > 2 && run < 6)
                assert_int_equal(called_since(first, "BufferData"), 0);
            driver.finished = driver.now;
        }
        oit_destroy(oit);
    }
}

/* The stores that keep the k nearest need no read-back within a frame, whatever the fit; the third report from now is
 * waited for with OIT_FIT_WAIT, as ever. */
static void test_a_budget_reads_nothing_back(void **state) {
    (void)state;
    for (int store = 0; store < 2; ++store) {
        oit_desc desc = {.store = store ? OIT_STORE_BUCKETED : OIT_STORE_BUDGET, .fields = OIT_FIELD_PART, .layers = 8};
        oit_context *oit = make(desc);
        int maps = called_since(0, "MapBufferRange");
        for (int run = 0; run < 3; ++run)
            assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
        assert_int_equal(called_since(0, "MapBufferRange"), maps);
        assert_int_equal(driver.waits, 0);
        oit_destroy(oit);
    }
}

/* What a pass of the stores that keep the k nearest is, in its order. */
static void test_passes_of_a_budget(void **state) {
    static const oit_pass_kind expected[2][8] = {
        {OIT_PASS_CLEAR, OIT_PASS_COUNT, OIT_PASS_KEEP, OIT_PASS_FILL, OIT_PASS_COMPOSE},
        {OIT_PASS_CLEAR, OIT_PASS_COUNT, OIT_PASS_KEEP, OIT_PASS_FILL, OIT_PASS_ARRANGE, OIT_PASS_COMPOSE}};
    (void)state;
    for (int store = 0; store < 2; ++store) {
        oit_desc desc = {.store = store ? OIT_STORE_BUCKETED : OIT_STORE_BUDGET,
                         .fields = OIT_FIELD_PART,
                         .layers = 8,
                         .fit = OIT_FIT_ASYNC,
                         .state = OIT_STATE_NONE};
        oit_context *oit = make(desc);
        oit_pass pass;
        int passes = 0;
        assert_int_equal(oit_begin(oit, &frame), OIT_OK);
        for (; oit_next_pass(oit, &pass); ++passes)
            assert_int_equal(pass.kind, expected[store][passes]);
        assert_int_equal(passes, 4 + store); /* the buckets are there before oit_compose */
        assert_int_equal(oit_compose(oit), OIT_OK);
        assert_int_equal(oit_next_pass(oit, &pass), 1);
        assert_int_equal(pass.kind, OIT_PASS_COMPOSE);
        while (oit_next_pass(oit, &pass))
            ;
        assert_int_equal(pass.kind, OIT_PASS_REPORT);
        assert_int_equal(oit_end(oit), OIT_OK);
        oit_destroy(oit);
    }
}

static void test_pixel_deeper_than_the_ceiling(void **state) {
    (void)state;
    oit_desc desc = {.ceiling_bytes = 16 * 9};
    oit_context *oit = make(desc);
    driver.pixel_starts = 10;
    set_totals(64 * 48 * 10, 10);
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_PIXEL_TOO_DEEP);
    assert_int_equal(driver.program, 4000);
    driver.pixel_starts = 9;
    set_totals(64 * 48 * 9, 9);
    assert_int_equal(draw_frame(oit, &frame, NULL), OIT_OK);
    oit_destroy(oit);
}

static void test_wrong_order_and_bad_frames(void **state) {
    (void)state;
    oit_context *oit = make(descs[0]);
    oit_frame bad = frame;
    oit_pass pass;
    assert_int_equal(oit_compose(oit), OIT_WRONG_ORDER);
    assert_int_equal(oit_end(oit), OIT_WRONG_ORDER);
    assert_int_equal(oit_next_pass(oit, &pass), 0);
    assert_int_equal(oit_begin(oit, &frame), OIT_OK);
    assert_int_equal(oit_begin(oit, &frame), OIT_WRONG_ORDER);
    assert_int_equal(oit_release(oit), OIT_WRONG_ORDER);
    assert_int_equal(oit_next_pass(oit, &pass), 1);
    assert_int_equal(pass.kind, OIT_PASS_COUNT);
    assert_int_equal(oit_compose(oit), OIT_WRONG_ORDER);
    assert_int_equal(oit_end(oit), OIT_OK); /* early */
    assert_int_equal(driver.program, 4000);
    bad.width = -1;
    assert_int_equal(oit_begin(oit, &bad), OIT_INVALID_ARGUMENT);
    bad.width = 20000;
    assert_int_equal(oit_begin(oit, &bad), OIT_TOO_LARGE);
    bad = frame;
    bad.light[1] = (float)(1e300 * 1e300);
    assert_int_equal(oit_begin(oit, &bad), OIT_INVALID_ARGUMENT);
    bad = frame;
    bad.height = 0;
    assert_int_equal(draw_frame(oit, &bad, NULL), OIT_OK);
    assert_int_equal(oit_release(oit), OIT_OK);
    assert_true(oit_get_info(oit).bytes == 0);
    oit_destroy(oit);
}

/* 16k pixels wide, and sizes that change each frame. */
static void test_sizes(void **state) {
    static const int sizes[][2] = {{16384, 1}, {16384, 900}, {1, 16384}, {1, 1}, {640, 480}, {641, 480}, {3, 5}};
    (void)state;
    for (size_t i = 0; i < 2; ++i) {
        oit_context *oit = make(descs[i]);
        for (size_t k = 0; k < 2 * sizeof sizes / sizeof sizes[0]; ++k) {
            oit_frame f = frame;
            f.width = sizes[k % 7][0];
            f.height = sizes[k % 7][1];
            set_totals((uint32_t)(f.width * f.height) / 4, 5);
            driver.pixel_starts = 0;
            assert_int_equal(draw_frame(oit, &f, NULL), OIT_OK);
            driver.finished = driver.now;
        }
        oit_destroy(oit);
        driver.call_count = 0;
    }
}

/* ---- operators ---- */

static oit_frame frame_with_projection(void) {
    oit_frame f = frame;
    f.projection[0] = f.projection[5] = 2.0f;
    f.projection[10] = -1.2f;
    f.projection[11] = -1.0f;
    f.projection[14] = -2.2f;
    return f;
}

/* A host's operator, which uses what ours use. */
static U host_operator(const oit_context *oit) {
    int count = 0;
    const char *const *strings = oit_operator_glsl(oit, &count);
    assert_non_null(strings);
    U shader = fake_CreateShader(0x91B9u), program = fake_CreateProgram();
    fake_ShaderSource(shader, count, strings, NULL);
    fake_AttachShader(program, shader);
    fake_DeleteShader(shader);
    return program;
}

static const float mock_shades[3 * OIT_TRANSFER_SHADES], mock_opacities[OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS];

/* What makes the passes of an operator differ, and what they read and write. Other tests name the first two. */
typedef struct variant {
    const char *name;
    oit_link link;
    oit_law law;
    oit_smart smart;
    oit_curvature curvature;
    int host_iterations, host_value;
    int distance; /* 1: the law of distance after all else */
} variant;
enum {
    PLAIN,
    JUMPING,
    BUCKETED,
    BRUTE,
    ONE_SIDED,
    PUBLISHED,
    THIN,
    DIFFUSED,
    STILL,
    BASE_ALONE,
    LOCAL_BASE,
    LOCAL_FIELD,
    CONTOURS,
    ROUGH_CONTOURS,
    ONE_SIDED_CONTOURS,
    ONE_SIDED_JUMPS
};

static const variant variants[] = {
    {.name = "plain"},
    {.name = "jumps", .smart = {.jumps = 1}, .host_iterations = 1, .host_value = OIT_VALUE_HOST},
    {.name = "buckets", .link = {.search = OIT_SEARCH_BUCKETS, .count_pairs = 1}, .law = {.kind = OIT_LAW_ADAPTIVE}},
    {.name = "all pairs", .link = {.search = OIT_SEARCH_BRUTE}, .law = {.kind = OIT_LAW_CONSTANT}},
    {.name = "one-sided", .link = {.no_reverse_check = 1}, .law = {.kind = OIT_LAW_VARIATION}},
    {.name = "published", .link = {.criterion = OIT_LINK_PUBLISHED}, .smart = {.published = 1}},
    {.name = "thin", .smart = {.thin = 0.5f}, .law = {.kind = OIT_LAW_VARIATION}},
    {.name = "beta diffused", .smart = {.beta = {.process = OIT_PROCESS_DIFFUSION}}},
    {.name = "no steps",
     .smart = {.base = {.iterations = -1}, .beta = {.iterations = -1}, .gamma = {.iterations = -1}}},
    {.name = "base alone", .smart = {.beta = {.iterations = -1}, .gamma = {.iterations = -1}}},
    {.name = "base by the host", .host_iterations = 3, .host_value = OIT_VALUE_BASE},
    {.name = "a field by the host", .host_iterations = 3, .host_value = OIT_VALUE_HOST},
    {.name = "contours", .curvature = {.contours = OIT_CONTOURS_SUGGESTIVE}},
    {.name = "contours, not smoothed",
     .curvature = {.contours = OIT_CONTOURS_SUGGESTIVE, .contour_iterations = -1},
     .law = {.kind = OIT_LAW_ANGLE}},
    {.name = "contours, one-sided",
     .link = {.no_reverse_check = 1},
     .curvature = {.contours = OIT_CONTOURS_SUGGESTIVE, .contour_iterations = 9}},
    {.name = "jumps, one-sided", .link = {.no_reverse_check = 1}, .smart = {.jumps = 1}},
    {.name = "until stable", .smart = {.jumps = 1, .until_stable = 1}, .distance = 1},
    {.name = "thin, jumps", .smart = {.jumps = 1, .thin = 0.2f}, .law = {.kind = OIT_LAW_ADAPTIVE}},
    {.name = "gamma diffused", .smart = {.gamma = {.process = OIT_PROCESS_DIFFUSION}}, .distance = 1},
    {.name = "all diffused, published",
     .smart = {.published = 1,
               .beta = {.process = OIT_PROCESS_DIFFUSION, .iterations = 3},
               .gamma = {.process = OIT_PROCESS_DIFFUSION, .iterations = 5}}},
    {.name = "all diffused, jumps",
     .smart = {.jumps = 1, .beta = {.process = OIT_PROCESS_DIFFUSION}, .gamma = {.process = OIT_PROCESS_DIFFUSION}}},
    {.name = "Murray", .link = {.criterion = OIT_LINK_MURRAY, .search = OIT_SEARCH_BUCKETS}, .distance = 1},
    {.name = "shade", .curvature = {.shade = OIT_SHADE_CONVEX}},
    {.name = "opacity", .curvature = {.opacity = OIT_OPACITY_FRONT}, .host_value = OIT_VALUE_BASE},
    {.name = "tables",
     .curvature = {.unit = 0.5f, .shades = mock_shades, .opacities = mock_opacities},
     .host_iterations = 2,
     .host_value = OIT_VALUE_BASE},
};
enum { VARIANTS = sizeof variants / sizeof variants[0] };

static oit_operator operator_of(int kind, int which, U program) {
    const variant *v = &variants[which];
    oit_operator op = {.kind = (oit_run_kind)kind, .link = v->link, .law = v->law, .smart = v->smart};
    op.curvature = v->curvature;
    op.host.program = program;
    op.host.iterations = v->host_iterations;
    op.host.value = v->host_value;
    return op;
}

/* A frame with an operator of each of the kinds whose bits are set. counts: passes of each kind. */
static oit_result operate_frame(oit_context *oit, unsigned kinds, int which, U program,
                                int counts[OIT_PASS_KIND_COUNT]) {
    oit_frame f = frame_with_projection();
    int ignored = 0;
    oit_result result = oit_begin(oit, &f), end;
    if (result != OIT_OK)
        return result;
    draw_passes(oit, &ignored);
    driver.operators[0] = driver.barriers;
    for (int kind = 0; kind < 6 && result == OIT_OK; ++kind) {
        oit_operator op = operator_of(kind < 5 ? kind : OIT_RUN_LAW, which, program);
        int first = driver.call_count;
        if (!(kinds >> kind & 1u) || (kind == 5 && !variants[which].distance))
            continue;
        if (kind == 5)
            op.law.kind = OIT_LAW_DISTANCE;
        result = oit_run(oit, &op);
        if (result == OIT_OK && oit->desc.state == OIT_STATE_NONE)
            draw_passes(oit, &ignored);
        if (counts)
            counts[OIT_PASS_OPERATE] += called_since(first, "DispatchCompute");
    }
    driver.operators[1] = driver.barriers + 1;
    end = oit_compose(oit);
    if (oit->desc.state == OIT_STATE_NONE)
        draw_passes(oit, &ignored);
    result = result != OIT_OK ? result : end;
    end = oit_end(oit);
    return result != OIT_OK ? result : end;
}

static const oit_desc operator_descs[] = {
    {.fit = OIT_FIT_WAIT, .operators = OIT_OPERATE_ALL, .operator_fields = 2},
    {.fit = OIT_FIT_ASYNC, .operators = OIT_OPERATE_ALL, .operator_fields = 4, .fields = OIT_FIELD_BLEND},
    {.fit = OIT_FIT_ASYNC, .state = OIT_STATE_NONE, .operators = OIT_OPERATE_ALL, .operator_fields = 1},
    {.fit = OIT_FIT_WAIT, .store = OIT_STORE_BUDGET, .layers = 5, .operators = OIT_OPERATE_ALL, .operator_fields = 1},
    {.fit = OIT_FIT_WAIT, .store = OIT_STORE_BUCKETED, .layers = 5, .operators = OIT_OPERATE_ALL, .operator_fields = 1},
    {.fit = OIT_FIT_ASYNC, .store = OIT_STORE_PREDICT, .operators = OIT_OPERATE_ALL, .operator_fields = 1},
    {.fit = OIT_FIT_ASYNC, .store = OIT_STORE_LINKED, .operators = OIT_OPERATE_ALL, .operator_fields = 1},
};
enum { OPERATOR_DESCS = sizeof operator_descs / sizeof operator_descs[0] };

enum { EVERY_KIND = 63 }; /* a bit each, and the last that of the law of distance */

/* tear_down fails where a barrier was missing. Deep pixels make the links wide. Nothing waits but for the read-back of
 * OIT_FIT_WAIT. */
static void test_barriers_of_operators(void **state) {
    (void)state;
    for (int i = 0; i < 2 * OPERATOR_DESCS; ++i) {
        driver.version = i & 1 ? "OpenGL ES 3.1 Mock" : "4.3.0 Mock";
        oit_context *oit = make(operator_descs[i / 2]);
        U program = host_operator(oit);
        for (int which = 0; which < VARIANTS; ++which) {
            set_totals(64 * 48 * 2, which < VARIANTS / 2 ? 200 : 300);
            driver.waits = 0;
            if (operate_frame(oit, EVERY_KIND, which, program, NULL) != OIT_OK)
                fail_msg("%s: %s", variants[which].name, driver.text);
            assert_true(driver.waits <= (oit->desc.fit == OIT_FIT_WAIT && oit->desc.store == OIT_STORE_EXACT));
            driver.finished = driver.now;
            assert_int_equal(driver.copy_target, 78);
            if (driver.violations)
                fail_msg("in the frame of %s", variants[which].name);
        }
        if (operator_descs[i / 2].store == OIT_STORE_EXACT)
            assert_true(oit->wide);
        fake_DeleteProgram(program);
        oit_destroy(oit);
        driver.call_count = 0;
    }
}

/* Each barrier left out in turn: the driver that is not there notices every one. So none is given for nothing, and none
 * of them could be missing unseen. */
static void test_each_barrier_of_operators_is_needed(void **state) {
    int left_out = 0;
    (void)state;
    driver.quiet = true;
    for (int i = 0; i < OPERATOR_DESCS; i += 2) {
        oit_context *oit = make(operator_descs[i]);
        U program = host_operator(oit);
        set_totals(64 * 48 * 2, 200);
        for (int which = 0; which < VARIANTS; which += i ? 5 : 1) {
            for (int warm = 0; warm < 4; ++warm) { /* what is made, or grows, once */
                driver.barriers = 0;
                assert_int_equal(operate_frame(oit, EVERY_KIND, which, program, NULL), OIT_OK);
                driver.finished = driver.now;
            }
            const long first = driver.operators[0] + 1, last = driver.operators[1];
            for (long n = first - 1; n <= last; ++n) {
                driver.finished = driver.now;
                driver.dropped_barrier = 0;
                fake_MemoryBarrier(0xffffffffu); /* nothing is left of the frame before */
                driver.call_count = driver.violations = 0;
                driver.barriers = 0;
                driver.dropped_barrier = n < first ? 0 : n;
                assert_int_equal(operate_frame(oit, EVERY_KIND, which, program, NULL), OIT_OK);
                assert_true(driver.operators[0] == first - 1 && driver.operators[1] == last);
                if ((driver.violations > 0) != (n >= first))
                    fail_msg("desc %d, %s: %d violations without barrier %ld of %ld to %ld", i, variants[which].name,
                             driver.violations, n, first, last);
                left_out += n >= first;
            }
            assert_true(last - first > 5);
            driver.dropped_barrier = 0;
        }
        driver.violations = 0;
        fake_DeleteProgram(program);
        oit_destroy(oit);
    }
    driver.violations = 0;
    print_message("    %d barriers left out one at a time\n", left_out);
}

static int programs_made(const oit_context *oit) {
    int made = 0;
    for (int i = OIT_I_PROGRAM_SORT; i < OIT_I_PROGRAMS; ++i)
        made += oit->programs[i] != 0;
    return made;
}

/* What is not asked for is not stored, made or run. Bytes are counted by hand from the comments of OIT_OPERATE_*, passes
 * from the table of docs/smart.md. */
static void test_bytes_and_passes_of_operators(void **state) {
    enum { LINK = 1, LAW = 2, SMART = 4, CURVE = 8, HOST = 16 };
    static const struct {
        uint32_t operators;
        int fields;
        unsigned kinds; /* that are run */
        int which, record, words, programs, passes;
    } cases[] = {
        {0, 0, 0, PLAIN, 16, 0, 0, 0},
        {OIT_OPERATE_LAW, 0, 0, PLAIN, 16, 0, 0, 0},                /* chosen and not run: not made */
        {OIT_OPERATE_LAW, 0, LAW, PLAIN, 16, 2, 3, 2},              /* order, base; sort, law; no normals, no links */
        {0, 3, HOST, PLAIN, 16, 4, 2, 2},                           /* order and fields; sort, the host's */
        {OIT_OPERATE_LOCAL, 1, HOST, LOCAL_FIELD, 16, 3, 2, 1 + 3}, /* a second field for to and fro */
        {OIT_OPERATE_LOCAL | OIT_OPERATE_LAW, 0, HOST, LOCAL_BASE, 16, 3, 3, 2 + 3}, /* + given */
        {OIT_OPERATE_LINKS, 0, LINK, PLAIN, 24, 2, 4, 3},                            /* sort, window, mutual */
        {OIT_OPERATE_LINKS, 0, LINK, ONE_SIDED, 24, 2, 3, 2},                        /* no mutual */
        {OIT_OPERATE_LINKS, 0, LINK, BRUTE, 24, 2, 4, 1 + 4 + 1},                    /* a direction each */
        {OIT_OPERATE_LINKS, 0, LINK, PUBLISHED, 24, 2, 3, 1 + 4},
        {OIT_OPERATE_LINKS | OIT_OPERATE_BUCKETS, 0, LINK, BUCKETED, 24, 3, 5, 1 + 1 + 4 + 1}, /* group */
        {OIT_OPERATE_CURVATURE, 0, LINK | SMART, PLAIN, 24, 4, 0, 0},                          /* SMART is not chosen */
        {OIT_OPERATE_CURVATURE, 0, LINK | CURVE, PLAIN, 24, 4, 5, 4},
        {OIT_OPERATE_CONTOURS, 0, LINK | CURVE, PLAIN, 24, 6, 5, 4},         /* chosen, not asked for */
        {OIT_OPERATE_CONTOURS, 0, LINK | CURVE, CONTOURS, 24, 6, 6, 4 + 11}, /* 64 steps: ten pairs of chains */
        {OIT_OPERATE_CONTOURS, 0, LINK | CURVE, ROUGH_CONTOURS, 24, 6, 5, 4},
        {OIT_OPERATE_CONTOURS, 0, LINK | CURVE, ONE_SIDED_CONTOURS, 24, 6, 5, 3 + 9}, /* no chains: iterated */
        {OIT_OPERATE_SMART, 0, LINK | SMART, PLAIN, 24, 5, 7, 3 + 2 + 20}, /* + given, bound, 20 iterations */
        {OIT_OPERATE_SMART, 0, LINK | LAW | SMART, PLAIN, 24, 5, 7, 3 + 2 + 20},
        {OIT_OPERATE_SMART, 0, LINK | SMART, STILL, 24, 5, 6, 3 + 2},
        {OIT_OPERATE_SMART, 0, LINK | SMART, BASE_ALONE, 24, 5, 7, 3 + 2 + 20},
        {OIT_OPERATE_SMART, 0, LINK | SMART, JUMPING, 24, 5, 8, 3 + 2 + 16 + 4}, /* four rounds, three pairs for base */
        {OIT_OPERATE_SMART, 0, LINK | SMART, ONE_SIDED_JUMPS, 24, 5, 7, 2 + 2 + 16 + 20}, /* base is iterated */
        {OIT_OPERATE_SMART | OIT_OPERATE_THIN, 0, LINK | SMART, PLAIN, 24, 7, 7,
         3 + 2 + 20}, /* chosen, not asked for */
        {OIT_OPERATE_SMART | OIT_OPERATE_THIN, 0, LINK | LAW | SMART, THIN, 24, 7, 8, 3 + 2 + 6 + 20}, /* to 20 / 0.5 */
        {OIT_OPERATE_SMART | OIT_OPERATE_DIFFUSION, 0, LINK | SMART, DIFFUSED, 24, 7, 7, 3 + 2 + 20 + 20},
        {OIT_OPERATE_SMART | OIT_OPERATE_CURVATURE, 1, LINK | LAW | SMART | CURVE | HOST, PLAIN, 24, 7, 8,
         3 + 2 + 20 + 2},
    };
    (void)state;
    for (size_t i = 0; i < 2 * sizeof cases / sizeof cases[0]; ++i) {
        size_t c = i / 2;
        bool wide = i & 1;
        oit_desc desc = {.operators = cases[c].operators, .operator_fields = cases[c].fields};
        oit_context *oit = make(desc);
        U program = oit_operator_glsl(oit, &(int){0}) ? host_operator(oit) : 0;
        int counts[OIT_PASS_KIND_COUNT] = {0}, words = cases[c].words;
        set_totals(6000, wide ? 255 : 7);
        bool refused = cases[c].passes == 0 && cases[c].kinds != 0;
        assert_int_equal(operate_frame(oit, cases[c].kinds, cases[c].which, program, counts),
                         refused ? OIT_INVALID_ARGUMENT : OIT_OK);
        assert_int_equal(oit_get_info(oit).fragment_bytes, cases[c].record);
        words += wide && cases[c].record == 24; /* links of 16 bits */
        if (!refused) {
            int64_t bytes = words ? 4 * (16 + (int64_t)words * oit->capacity) : 0;
            if (oit->sizes[OIT_I_SURFACE] != bytes || programs_made(oit) != cases[c].programs ||
                counts[OIT_PASS_OPERATE] != cases[c].passes)
                fail_msg("case %d: %ld bytes for %ld, %d programs, %d passes", (int)c, (long)oit->sizes[OIT_I_SURFACE],
                         (long)bytes, programs_made(oit), counts[OIT_PASS_OPERATE]);
        }
        fake_DeleteProgram(program);
        oit_destroy(oit);
        driver.call_count = 0;
    }
}

/* Nothing is created or waited for once it has been run, and under OIT_STATE_NONE no state is touched. */
static void test_steady_operators(void **state) {
    static const char *const never[] = {"GenBuffers", "BufferData", "CreateShader", "CreateProgram", "BufferSubData"};
    static const char *const raw[] = {"MemoryBarrier", "ProgramUniform4fv", "ProgramUniform4uiv", "FenceSync"};
    (void)state;
    for (int i = 0; i < 3; ++i) {
        oit_context *oit = make(operator_descs[i]);
        U program = host_operator(oit);
        int kept = 0;
        set_totals(6000, 30);
        for (int run = 0; run < 8; ++run) {
            int first = driver.call_count;
            assert_int_equal(operate_frame(oit, 31, JUMPING, program, NULL), OIT_OK);
            driver.finished = driver.now;
            for (size_t k = 0; k < sizeof never / sizeof never[0] && run > 4; ++k)
                if (called_since(first, never[k]) && !(i == 0 && k == 4))
                    fail_msg("%s in a steady frame", never[k]);
            if (run == 4)
                kept = allocations;
        }
        assert_int_equal(allocations, kept);
        if (operator_descs[i].state == OIT_STATE_NONE) {
            oit_frame f = frame_with_projection();
            oit_pass pass;
            assert_int_equal(oit_begin(oit, &f), OIT_OK);
            draw_passes(oit, &(int){0});
            int first = driver.call_count, passes = 0;
            for (int kind = 0; kind < 5; ++kind) {
                oit_operator op = operator_of(kind, JUMPING, program);
                assert_int_equal(oit_run(oit, &op), OIT_OK);
                while (oit_next_pass(oit, &pass)) {
                    assert_int_equal(pass.kind, OIT_PASS_OPERATE);
                    assert_true(pass.state.program && pass.state.groups[0] && pass.barriers == 0x2000u);
                    ++passes;
                }
            }
            assert_true(passes > 10);
            for (; first < driver.call_count; ++first) {
                bool known = false;
                for (size_t k = 0; k < sizeof raw / sizeof raw[0]; ++k)
                    known = known || strcmp(driver.calls[first], raw[k]) == 0;
                if (!known)
                    fail_msg("%s under OIT_STATE_NONE", driver.calls[first]);
            }
            assert_int_equal(oit_compose(oit), OIT_OK);
            draw_passes(oit, &passes);
            assert_int_equal(oit_end(oit), OIT_OK);
        }
        fake_DeleteProgram(program);
        oit_destroy(oit);
        driver.call_count = 0;
    }
}

static void expect_refusal(oit_context *oit, oit_operator op, oit_result expected, const char *text) {
    driver.text[0] = 0;
    assert_int_equal(oit_run(oit, &op), expected);
    if (!strstr(driver.text, text))
        fail_msg("\"%s\" is not in \"%s\"", text, driver.text);
}

/* What is refused, with the reason; the frame goes on. */
static void test_operators_refused(void **state) {
    oit_frame f = frame_with_projection();
    oit_desc desc = {.operators = OIT_OPERATE_SMART | OIT_OPERATE_CURVATURE};
    oit_operator op = {.kind = OIT_RUN_LINK};
    const float bad_number = (float)(1e300 * 1e300);
    (void)state;
    set_totals(6000, 30);
    oit_context *oit = make(desc);
    expect_refusal(oit, op, OIT_WRONG_ORDER, "between oit_next_pass's 0 and oit_compose");
    assert_int_equal(oit_run(NULL, &op), OIT_INVALID_ARGUMENT);
    assert_int_equal(oit_begin(oit, &frame), OIT_OK);
    expect_refusal(oit, op, OIT_WRONG_ORDER, "between oit_next_pass's 0 and oit_compose");
    draw_passes(oit, &(int){0});
    expect_refusal(oit, op, OIT_INVALID_ARGUMENT, "frame.projection is missing");
    assert_int_equal(oit_compose(oit), OIT_OK);
    expect_refusal(oit, op, OIT_WRONG_ORDER, "between");
    assert_int_equal(oit_end(oit), OIT_OK);

    assert_int_equal(oit_begin(oit, &f), OIT_OK);
    draw_passes(oit, &(int){0});
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_SMART}, OIT_WRONG_ORDER, "OIT_RUN_LINK comes before");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_CURVATURE}, OIT_WRONG_ORDER, "OIT_RUN_LINK comes before");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_LAW, .law = {.kind = OIT_LAW_VARIATION}}, OIT_WRONG_ORDER,
                   "OIT_RUN_LINK comes before");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_LAW, .law = {.kind = OIT_LAW_DISTANCE}}, OIT_WRONG_ORDER,
                   "OIT_RUN_SMART");
    expect_refusal(oit, (oit_operator){.kind = (oit_run_kind)5}, OIT_INVALID_ARGUMENT, "kind is none");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_HOST}, OIT_INVALID_ARGUMENT, "host.program");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_HOST, .host = {.program = 5, .iterations = 1, .value = 4}},
                   OIT_INVALID_ARGUMENT, "operator_fields");
    expect_refusal(oit, (oit_operator){.link = {.criterion = OIT_LINK_UV}}, OIT_INVALID_ARGUMENT, "OIT_FIELD_UV");
    expect_refusal(oit, (oit_operator){.link = {.search = OIT_SEARCH_BUCKETS}}, OIT_INVALID_ARGUMENT, "BUCKETS");
    expect_refusal(oit, (oit_operator){.link = {.radius = -1}}, OIT_INVALID_ARGUMENT, "negative");
    expect_refusal(oit, (oit_operator){.link = {.limit = bad_number}}, OIT_INVALID_ARGUMENT, "not finite");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_LAW, .law = {.s = 1.5f}}, OIT_INVALID_ARGUMENT, "above 1");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_CURVATURE, .curvature = {.unit = -1}}, OIT_INVALID_ARGUMENT,
                   "negative");
    float tables[OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS] = {0}; /* the last number of each is none */
    tables[3 * OIT_TRANSFER_SHADES - 1] = tables[OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS - 1] =
        bad_number - bad_number;
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_CURVATURE, .curvature = {.shades = tables}},
                   OIT_INVALID_ARGUMENT, "curvature.shades is not finite");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_CURVATURE, .curvature = {.opacities = tables}},
                   OIT_INVALID_ARGUMENT, "curvature.opacities is not finite");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_CURVATURE, .curvature = {.last = bad_number}},
                   OIT_INVALID_ARGUMENT, "curvature is not finite");
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_CURVATURE, .curvature = {.shade = (oit_shade)3}},
                   OIT_INVALID_ARGUMENT, "none of its enumerators");
    op.kind = OIT_RUN_SMART;
    op.smart.beta.process = OIT_PROCESS_DIFFUSION;
    expect_refusal(oit, op, OIT_INVALID_ARGUMENT, "OIT_OPERATE_DIFFUSION");
    op.smart.beta.process = OIT_PROCESS_DEFAULT;
    op.smart.base.process = OIT_PROCESS_GREATEST;
    expect_refusal(oit, op, OIT_INVALID_ARGUMENT, "diffusion alone");
    op.smart.base.process = OIT_PROCESS_DEFAULT;
    op.smart.gamma.iterations = 65534;
    expect_refusal(oit, op, OIT_INVALID_ARGUMENT, "65533");
    op.smart.gamma.iterations = 0;
    op.smart.thin = 0.5f;
    expect_refusal(oit, op, OIT_INVALID_ARGUMENT, "OIT_OPERATE_THIN");
    assert_int_equal(oit_compose(oit), OIT_OK);
    assert_int_equal(oit_end(oit), OIT_OK);
    oit_destroy(oit);

    /* Bands: neighbours would be in others. */
    desc.ceiling_bytes = 64 * 24 * 9;
    oit = make(desc);
    set_totals(64 * 48 * 2, 2);
    assert_int_equal(oit_begin(oit, &f), OIT_OK);
    draw_passes(oit, &(int){0});
    expect_refusal(oit, (oit_operator){.kind = OIT_RUN_LINK}, OIT_TOO_LARGE, "in bands");
    assert_int_equal(oit_compose(oit), OIT_OK);
    assert_int_equal(oit_end(oit), OIT_OK);
    oit_destroy(oit);
}

static void test_operators_refused_at_creation(void **state) {
    static const struct {
        oit_desc desc;
        const char *text;
    } cases[] = {
        {{.operators = 512}, "operators has bits"},
        {{.operator_fields = 5}, "operator_fields"},
        {{.operators = 1, .store = OIT_STORE_FETCH}, ""},
        {{.operators = 1, .fields = OIT_FIELD_COVERAGE}, "OIT_FIELD_COVERAGE"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        oit_desc desc = cases[i].desc;
        oit_result result;
        desc.get_proc = get_proc;
        desc.log_fn = on_log;
        driver.text[0] = 0;
        assert_null(oit_create(&desc, &result));
        assert_int_equal(result, OIT_INVALID_ARGUMENT);
        assert_non_null(strstr(driver.text, cases[i].text));
    }
}

/* Every creation refused in turn: an error and a frame all the same, nothing left, and the next frame works. */
static void test_operators_with_creations_refused(void **state) {
    (void)state;
    for (int i = 0; i < 3; ++i) {
        long total = 1;
        for (long refused = 1; refused <= total; ++refused) {
            set_up(state);
            oit_context *oit = make(operator_descs[i]);
            U program = host_operator(oit);
            set_totals(6000, 10);
            driver.creations = 0;
            driver.refuse_creation = refused;
            oit_result result = operate_frame(oit, 31, 3, program, NULL);
            if (result != OIT_OK)
                assert_true(strlen(driver.text) > 0);
            assert_int_equal(driver.copy_target, 78);
            driver.finished = driver.now;
            assert_int_equal(operate_frame(oit, 31, 3, program, NULL), OIT_OK);
            if (driver.creations > total)
                total = driver.creations;
            fake_DeleteProgram(program);
            oit_destroy(oit);
            assert_int_equal(tear_down(state), 0);
            memset(driver.buffers, 0, sizeof driver.buffers);
        }
        assert_true(total > 30);
    }
}

#define DRIVER_TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void) {
    const struct CMUnitTest tests[] = {
        DRIVER_TEST(test_barriers),
        DRIVER_TEST(test_steady_frames),
        DRIVER_TEST(test_growth_does_not_wait),
        DRIVER_TEST(test_wait_waits_once),
        DRIVER_TEST(test_barriers_of_picks_and_depths),
        DRIVER_TEST(test_picks_do_not_wait),
        DRIVER_TEST(test_picks_with_creations_refused),
        DRIVER_TEST(test_multisampled_targets),
        DRIVER_TEST(test_every_creation_refused),
        DRIVER_TEST(test_shaders_that_fail),
        DRIVER_TEST(test_no_memory_mid_growth),
        DRIVER_TEST(test_no_memory_for_growth_of_any_store),
        DRIVER_TEST(test_predicted_frames),
        DRIVER_TEST(test_fetched_frames),
        DRIVER_TEST(test_no_memory_for_a_budget),
        DRIVER_TEST(test_a_budget_reads_nothing_back),
        DRIVER_TEST(test_passes_of_a_budget),
        DRIVER_TEST(test_pixel_deeper_than_the_ceiling),
        DRIVER_TEST(test_wrong_order_and_bad_frames),
        DRIVER_TEST(test_sizes),
        DRIVER_TEST(test_barriers_of_operators),
        DRIVER_TEST(test_each_barrier_of_operators_is_needed),
        DRIVER_TEST(test_bytes_and_passes_of_operators),
        DRIVER_TEST(test_steady_operators),
        DRIVER_TEST(test_operators_refused),
        DRIVER_TEST(test_operators_refused_at_creation),
        DRIVER_TEST(test_operators_with_creations_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
