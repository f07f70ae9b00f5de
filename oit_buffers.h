/* oit_buffers.h - v0.1.0 - what fragment buffers need of an OpenGL context, found out and said - MIT licence, at the end

   DOES
   - tells whether the current context has what buffers that keep every fragment of every pixel need: OpenGL 4.3 or
     OpenGL ES 3.1, the functions, the limits. A refusal says what is missing and what was found
   - says what else the context has: its version, the size of storage blocks, image atomics

   DOES NOT
   - store, sort or blend a single fragment. Version 0.1 has no stores, no operators and no shaders: the buffers
     themselves come with a later version, and the calls of this one will stay. To draw transparent things today,
     use transparency.h, which needs only OpenGL 3.3, OpenGL ES 3.0 or WebGL 2
   - create a context, or run where there are no compute shaders: macOS and WebGL 2 stay with transparency.h

   QUICK START: given a current context and its getter of function pointers

    --8<-- quick start
    #define OIT_BUFFERS_IMPLEMENTATION
    #include "oit_buffers.h"

    extern oit_proc get_proc(const char *name); // eglGetProcAddress, glfwGetProcAddress, ...
    extern void show_line(const char *text);

    static void on_log(oit_log_level level, oit_result code, const char *text, void *user) {
        (void)level;
        (void)code;
        (void)user;
        show_line(text);
    }

    int64_t largest_fragment_buffer(void) { // in bytes, 0 where there can be none
        oit_desc desc = {0};
        oit_context *oit;
        int64_t bytes = 0;
        desc.get_proc = get_proc;
        desc.log_fn = on_log;
        oit = oit_create(&desc, 0);
        if (oit) bytes = oit_get_info(oit).storage_block_bytes;
        oit_destroy(oit);
        return bytes;
    }
    -->8--

   BUILD
   Define OIT_BUFFERS_IMPLEMENTATION in one C (C99) or C++ (C++11) file before including this header; include it anywhere
   else without. Link nothing but your GL loader; oit_* functions call GL through the table that desc.get_proc fills.

   OPTIONS, defined before the implementation unless said otherwise
   - OIT_STATIC            every function static; define it wherever the header is included
   - OIT_GL_STATIC         take the gl* names that are visible (glad, GLEW, epoxy, GLES3/gl31.h: include it first) instead
                           of desc.get_proc
   - OIT_MALLOC, OIT_FREE  used when the desc brings no allocator; default malloc and free

   GL FLOOR
   OpenGL 4.3 core or OpenGL ES 3.1, and of the limits at least (ES 3.1 lets a driver have no storage block in the
   fragment stage, so the version alone does not tell):
   - GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS 2: one with a word for each pixel, one for the fragments
   - GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS 4 and GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS 128, for the prefix sum
   - GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES 4: those two blocks and colour outputs
   - GL_MAX_SHADER_STORAGE_BLOCK_SIZE 2^24 bytes
   Image atomics are reported, not required. A function pointer that is not null proves nothing (drivers hand out
   stubs): versions and extensions decide, and then the functions must be there as well.

   GL STATE CONTRACT
   oit_create only asks (glGetString, glGetStringi, glGetIntegerv, glGetInteger64v): no state is changed and no object
   is made. glGetError is never called, so that no error of the host's is swallowed, and nothing is asked that a context
   of that version does not know, so that none is added.

   ERRORS, MEMORY, THREADS
   oit_create returns NULL and the reason, and says it in words through desc.log_fn. One heap block a context, none after
   a refusal. One context of ours for one GL context, used from the thread that has it current; oit_get_info and
   oit_destroy call no GL and may be used from any one thread at a time.

   RECIPES
   - Try a fall-back: desc.max_gl_version = 330 refuses as on a context of OpenGL 3.3.

   LIMITS AND PRECISION
   - Versions are read from the GL_VERSION string, which the specifications lay down.
*/
#ifndef OIT_BUFFERS_H
#define OIT_BUFFERS_H

#include <stddef.h>
#include <stdint.h>

#define OIT_VERSION 100 /* major * 10000 + minor * 100 + patch */

/* How the functions are declared; not for users. A file need not use all that are static in it. */
#if !defined(OIT_STATIC)
#define OIT_DEF extern
#elif defined(__GNUC__) || defined(__clang__)
#define OIT_DEF static __attribute__((unused))
#else
#define OIT_DEF static
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What went wrong. oit_result_string gives the sentence. */
#define OIT_RESULTS(X)                                                                                                 \
    X(OIT_OK, "no error")                                                                                              \
    X(OIT_INVALID_ARGUMENT, "an argument is missing or out of range")                                                  \
    X(OIT_OUT_OF_MEMORY, "out of memory")                                                                              \
    X(OIT_GL_TOO_OLD, "the context is older than OpenGL 4.3 or OpenGL ES 3.1")                                         \
    X(OIT_MISSING_FUNCTION, "a GL function that is needed was not found")                                              \
    X(OIT_LIMIT_TOO_SMALL, "a limit of the context is too small for fragment buffers")

typedef enum oit_result {
#define OIT_I_ENUM(name, text) name,
    OIT_RESULTS(OIT_I_ENUM)
#undef OIT_I_ENUM
        OIT_RESULT_COUNT
} oit_result;

typedef enum oit_log_level { OIT_LOG_ERROR, OIT_LOG_WARNING, OIT_LOG_INFO } oit_log_level;

typedef void (*oit_proc)(void);

typedef struct oit_desc {
    oit_proc (*get_proc)(const char *name);     /* required, except with OIT_GL_STATIC */
    void *(*alloc_fn)(size_t size, void *user); /* both or neither */
    void (*free_fn)(void *block, void *user);
    void *alloc_user;
    void (*log_fn)(oit_log_level level, oit_result code, const char *text, void *user); /* optional */
    void *log_user;
    int max_gl_version; /* 0: what the context has; 430: use nothing newer than 4.3 (for tests of fall-backs) */
} oit_desc;

typedef struct oit_info {
    int es;                      /* 1: OpenGL ES */
    int version;                 /* 430 for 4.3; after desc.max_gl_version */
    int fragment_storage_blocks; /* that a fragment shader may use */
    int compute_storage_blocks;  /* that a compute shader may use */
    int combined_outputs;        /* storage blocks, images and colour outputs of a fragment shader, together */
    int compute_invocations;     /* in one work group */
    int image_atomics;           /* 1: imageAtomicAdd and the like; always on desktop GL */
    int64_t storage_block_bytes; /* the most that one storage block may hold */
} oit_info;

typedef struct oit_context oit_context;

/* Needs a current context. Returns NULL and the reason (result may be NULL) on failure; nothing is left behind. */
OIT_DEF oit_context *oit_create(const oit_desc *desc, oit_result *result);
OIT_DEF void oit_destroy(oit_context *oit); /* NULL is fine */
/* What was found by oit_create; all zeros for NULL. */
OIT_DEF oit_info oit_get_info(const oit_context *oit);
OIT_DEF const char *oit_result_string(oit_result result);

#ifdef __cplusplus
}
#endif

#endif /* OIT_BUFFERS_H */

#ifdef OIT_BUFFERS_IMPLEMENTATION
#ifndef OIT_BUFFERS_IMPLEMENTATION_ONCE
#define OIT_BUFFERS_IMPLEMENTATION_ONCE

#include <string.h>

#ifndef OIT_MALLOC
#include <stdlib.h>
#define OIT_MALLOC(size) malloc(size)
#define OIT_FREE(block) free(block)
#endif

#ifdef OIT_STATIC
#define OIT_I_API OIT_DEF
#else
#define OIT_I_API
#endif

#if defined(_WIN32) && !defined(_WIN64)
#define OIT_I_GLAPI __stdcall
#else
#define OIT_I_GLAPI
#endif

/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */
/* ==== end of generated shaders ==== */

/* ---- GL: enumerants and the function table ---------------------------------------------------------------------- */

#define OIT_I_GL_VERSION 0x1F02u
#define OIT_I_GL_EXTENSIONS 0x1F03u
#define OIT_I_GL_NUM_EXTENSIONS 0x821Du
#define OIT_I_GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS 0x90DAu
#define OIT_I_GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS 0x90DBu
#define OIT_I_GL_MAX_SHADER_STORAGE_BLOCK_SIZE 0x90DEu
#define OIT_I_GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES 0x8F39u
#define OIT_I_GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS 0x90EBu

/* X(result type, name without gl, parameters), with C's types for GL's of the same size. */
#define OIT_I_GL_QUERIES(X)                                                                                            \
    X(const unsigned char *, GetString, (uint32_t))                                                                    \
    X(const unsigned char *, GetStringi, (uint32_t, uint32_t))                                                         \
    X(void, GetIntegerv, (uint32_t, int32_t *))                                                                        \
    X(void, GetInteger64v, (uint32_t, int64_t *))

/* What fills and reads the buffers. */
#define OIT_I_GL_BUFFERS(X)                                                                                            \
    X(void, BindBufferBase, (uint32_t, uint32_t, uint32_t))                                                            \
    X(void, BindImageTexture, (uint32_t, uint32_t, int32_t, unsigned char, int32_t, uint32_t, uint32_t))               \
    X(void, BufferData, (uint32_t, ptrdiff_t, const void *, uint32_t))                                                 \
    X(void, DeleteBuffers, (int32_t, const uint32_t *))                                                                \
    X(void, DispatchCompute, (uint32_t, uint32_t, uint32_t))                                                           \
    X(void, GenBuffers, (int32_t, uint32_t *))                                                                         \
    X(void, MemoryBarrier, (uint32_t))

/* Members are pasted names, because <windows.h> has a macro for one of them. */
typedef struct oit_i_gl {
#define OIT_I_MEMBER(type, name, parameters) type(OIT_I_GLAPI *gl_##name) parameters;
    OIT_I_GL_QUERIES(OIT_I_MEMBER)
    OIT_I_GL_BUFFERS(OIT_I_MEMBER)
#undef OIT_I_MEMBER
} oit_i_gl;

struct oit_context {
    oit_desc desc;
    oit_info info;
    oit_i_gl gl;
};

/* ---- text without stdio ----------------------------------------------------------------------------------------- */

/* Long enough for every message; a longer one is cut. */
typedef struct oit_i_text {
    char text[384];
    size_t length;
} oit_i_text;

static void oit_i_put(oit_i_text *to, const char *string) {
    for (; *string && to->length + 1 < sizeof to->text; ++string)
        to->text[to->length++] = *string;
    to->text[to->length] = 0;
}

static void oit_i_put_number(oit_i_text *to, int64_t number) {
    char digits[24];
    size_t at = sizeof digits - 1;
    uint64_t left = number < 0 ? 0u - (uint64_t)number : (uint64_t)number;
    digits[at] = 0;
    do {
        digits[--at] = (char)('0' + (int)(left % 10u));
        left /= 10u;
    } while (left);
    if (number < 0)
        digits[--at] = '-';
    oit_i_put(to, digits + at);
}

static void oit_i_put_version(oit_i_text *to, int es, int version) {
    oit_i_put(to, es ? "OpenGL ES " : "OpenGL ");
    oit_i_put_number(to, version / 100);
    oit_i_put(to, ".");
    oit_i_put_number(to, version / 10 % 10);
}

static oit_i_text oit_i_begin_text(void) {
    oit_i_text text;
    text.length = 0;
    oit_i_put(&text, "oit_create: ");
    return text;
}

/* Says why the context is refused, and what can be had instead. */
static oit_result oit_i_refuse(const oit_desc *desc, oit_result code, oit_i_text *text) {
    if (code == OIT_GL_TOO_OLD || code == OIT_MISSING_FUNCTION || code == OIT_LIMIT_TOO_SMALL)
        oit_i_put(text, "; transparency.h needs only OpenGL 3.3 or OpenGL ES 3.0");
    if (desc->log_fn)
        desc->log_fn(OIT_LOG_ERROR, code, text->text, desc->log_user);
    return code;
}

/* ---- what the context has --------------------------------------------------------------------------------------- */

static oit_result oit_i_lacks_function(const oit_desc *desc, const char *name) {
    oit_i_text text = oit_i_begin_text();
    oit_i_put(&text, name);
    oit_i_put(&text, " is missing");
    return oit_i_refuse(desc, OIT_MISSING_FUNCTION, &text);
}

/* The name is pasted before it can be expanded, so that a loader's macros for gl names work. */
#ifdef OIT_GL_STATIC
#define OIT_I_GET(type, name, parameters) gl->gl_##name = gl##name;
#else
#define OIT_I_GET(type, name, parameters) gl->gl_##name = (type(OIT_I_GLAPI *) parameters)desc->get_proc("gl" #name);
#endif
#define OIT_I_CHECK(type, name, parameters)                                                                            \
    if (!gl->gl_##name)                                                                                                \
        result = oit_i_lacks_function(desc, "gl" #name);

static oit_result oit_i_load_queries(const oit_desc *desc, oit_i_gl *gl) {
    oit_result result = OIT_OK;
    OIT_I_GL_QUERIES(OIT_I_GET)
    OIT_I_GL_QUERIES(OIT_I_CHECK)
    return result;
}

/* All that are missing are named. */
static oit_result oit_i_load_buffers(const oit_desc *desc, oit_i_gl *gl) {
    oit_result result = OIT_OK;
    OIT_I_GL_BUFFERS(OIT_I_GET)
    OIT_I_GL_BUFFERS(OIT_I_CHECK)
    return result;
}
#undef OIT_I_GET
#undef OIT_I_CHECK

static int oit_i_is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* "4.5 (Core Profile) Mesa 22.3.6" or "OpenGL ES 3.1 Mesa 22.3.6". Returns 0 for anything else. */
static int oit_i_parse_version(const char *text, oit_info *info) {
    static const char es_prefix[] = "OpenGL ES ";
    int major = 0;
    info->es = strncmp(text, es_prefix, sizeof es_prefix - 1) == 0;
    if (info->es)
        text += sizeof es_prefix - 1;
    if (!oit_i_is_digit(*text))
        return 0;
    for (; oit_i_is_digit(*text) && major < 100; ++text)
        major = major * 10 + (*text - '0');
    if (*text != '.' || !oit_i_is_digit(text[1]))
        return 0;
    info->version = major * 100 + (text[1] - '0') * 10;
    return 1;
}

static oit_result oit_i_find_version(const oit_desc *desc, const oit_i_gl *gl, oit_info *info) {
    const char *string = (const char *)gl->gl_GetString(OIT_I_GL_VERSION);
    oit_i_text text = oit_i_begin_text();
    if (!string) {
        oit_i_put(&text, "there is no GL_VERSION; is a context current?");
        return oit_i_refuse(desc, OIT_GL_TOO_OLD, &text);
    }
    if (!oit_i_parse_version(string, info)) {
        oit_i_put(&text, "no version can be read from GL_VERSION \"");
        oit_i_put(&text, string);
        oit_i_put(&text, "\"");
        return oit_i_refuse(desc, OIT_GL_TOO_OLD, &text);
    }
    oit_i_put(&text, "found ");
    oit_i_put_version(&text, info->es, info->version);
    if (desc->max_gl_version > 0 && info->version > desc->max_gl_version) {
        info->version = desc->max_gl_version;
        oit_i_put(&text, ", used as ");
        oit_i_put_version(&text, info->es, info->version);
    }
    oit_i_put(&text, "; needed is OpenGL 4.3 or OpenGL ES 3.1");
    return info->version < (info->es ? 310 : 430) ? oit_i_refuse(desc, OIT_GL_TOO_OLD, &text) : OIT_OK;
}

static int oit_i_has_extension(const oit_i_gl *gl, const char *name) {
    int32_t count = 0, i;
    gl->gl_GetIntegerv(OIT_I_GL_NUM_EXTENSIONS, &count);
    for (i = 0; i < count; ++i) {
        const char *extension = (const char *)gl->gl_GetStringi(OIT_I_GL_EXTENSIONS, (uint32_t)i);
        if (extension && strcmp(extension, name) == 0)
            return 1;
    }
    return 0;
}

static oit_result oit_i_check_limit(const oit_desc *desc, const char *name, int64_t found, int64_t needed) {
    oit_i_text text = oit_i_begin_text();
    if (found >= needed)
        return OIT_OK;
    oit_i_put(&text, name);
    oit_i_put(&text, " is ");
    oit_i_put_number(&text, found);
    oit_i_put(&text, "; needed is ");
    oit_i_put_number(&text, needed);
    return oit_i_refuse(desc, OIT_LIMIT_TOO_SMALL, &text);
}

/* X(member of oit_info, name without GL_MAX_, least value) */
#define OIT_I_LIMITS(X)                                                                                                \
    X(fragment_storage_blocks, FRAGMENT_SHADER_STORAGE_BLOCKS, 2)                                                      \
    X(compute_storage_blocks, COMPUTE_SHADER_STORAGE_BLOCKS, 4)                                                        \
    X(combined_outputs, COMBINED_SHADER_OUTPUT_RESOURCES, 4)                                                           \
    X(compute_invocations, COMPUTE_WORK_GROUP_INVOCATIONS, 128)

/* All limits that are too small are named. The size of blocks may be beyond 32 bits. */
static oit_result oit_i_find_limits(const oit_desc *desc, const oit_i_gl *gl, oit_info *info) {
    oit_result result = OIT_OK;
    int32_t value;
#define OIT_I_LIMIT(member, name, least)                                                                               \
    value = 0;                                                                                                         \
    gl->gl_GetIntegerv(OIT_I_GL_MAX_##name, &value);                                                                   \
    info->member = value;                                                                                              \
    if (oit_i_check_limit(desc, "GL_MAX_" #name, value, least) != OIT_OK)                                              \
        result = OIT_LIMIT_TOO_SMALL;
    OIT_I_LIMITS(OIT_I_LIMIT)
#undef OIT_I_LIMIT
    gl->gl_GetInteger64v(OIT_I_GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &info->storage_block_bytes);
    if (oit_i_check_limit(desc, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", info->storage_block_bytes, 1 << 24) != OIT_OK)
        result = OIT_LIMIT_TOO_SMALL;
    /* All of desktop GL that comes as far as this is newer. */
    info->image_atomics = info->version >= 320 || oit_i_has_extension(gl, "GL_OES_shader_image_atomic");
    return result;
}

static oit_result oit_i_check_desc(const oit_desc *desc) {
    oit_i_text text = oit_i_begin_text();
    if (!desc)
        return OIT_INVALID_ARGUMENT;
#ifndef OIT_GL_STATIC
    if (!desc->get_proc) {
        oit_i_put(&text, "get_proc is missing");
        return oit_i_refuse(desc, OIT_INVALID_ARGUMENT, &text);
    }
#endif
    if (!desc->alloc_fn != !desc->free_fn) {
        oit_i_put(&text, "alloc_fn and free_fn go together");
        return oit_i_refuse(desc, OIT_INVALID_ARGUMENT, &text);
    }
    if (desc->max_gl_version < 0) {
        oit_i_put(&text, "max_gl_version is negative");
        return oit_i_refuse(desc, OIT_INVALID_ARGUMENT, &text);
    }
    return OIT_OK;
}

/* ---- the functions ---------------------------------------------------------------------------------------------- */

/* Everything is found out before anything is allocated. */
static oit_result oit_i_create(const oit_desc *desc, oit_context **out) {
    oit_context made;
    oit_i_text text = oit_i_begin_text();
    oit_result result = oit_i_check_desc(desc);
    if (result != OIT_OK)
        return result;
    memset(&made, 0, sizeof made);
    made.desc = *desc;
    result = oit_i_load_queries(desc, &made.gl);
    if (result == OIT_OK)
        result = oit_i_find_version(desc, &made.gl, &made.info);
    if (result == OIT_OK)
        result = oit_i_load_buffers(desc, &made.gl);
    if (result == OIT_OK)
        result = oit_i_find_limits(desc, &made.gl, &made.info);
    if (result != OIT_OK)
        return result;
    *out = (oit_context *)(desc->alloc_fn ? desc->alloc_fn(sizeof made, desc->alloc_user) : OIT_MALLOC(sizeof made));
    if (!*out) {
        oit_i_put(&text, "out of memory");
        return oit_i_refuse(desc, OIT_OUT_OF_MEMORY, &text);
    }
    memcpy(*out, &made, sizeof made);
    return OIT_OK;
}

#ifdef __cplusplus
extern "C" {
#endif

OIT_I_API oit_context *oit_create(const oit_desc *desc, oit_result *result) {
    oit_context *oit = 0;
    oit_result outcome = oit_i_create(desc, &oit);
    if (result)
        *result = outcome;
    return oit;
}

OIT_I_API void oit_destroy(oit_context *oit) {
    if (!oit)
        return;
    if (oit->desc.free_fn)
        oit->desc.free_fn(oit, oit->desc.alloc_user);
    else
        OIT_FREE(oit);
}

OIT_I_API oit_info oit_get_info(const oit_context *oit) {
    oit_info nothing;
    memset(&nothing, 0, sizeof nothing);
    return oit ? oit->info : nothing;
}

OIT_I_API const char *oit_result_string(oit_result result) {
    static const char *const strings[] = {
#define OIT_I_STRING(name, text) text,
        OIT_RESULTS(OIT_I_STRING)
#undef OIT_I_STRING
    };
    return (unsigned)result < (unsigned)OIT_RESULT_COUNT ? strings[result] : "not a result";
}

#ifdef __cplusplus
}
#endif

#endif /* OIT_BUFFERS_IMPLEMENTATION_ONCE */
#endif /* OIT_BUFFERS_IMPLEMENTATION */

/*
MIT License

Copyright (c) 2026 the Glassine authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
