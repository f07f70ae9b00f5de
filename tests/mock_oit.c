/* oit_buffers.h against a context that is made up here: no GL library, no driver. */
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

/* ---- the context ---- */

enum { LIMIT_COUNT = 4, LOG_CAPACITY = 4096 };

typedef struct limit {
    uint32_t name;
    int32_t value;
} limit;

/* A driver that has everything, with values as of Mesa's llvmpipe. */
static struct driver {
    const char *version;
    limit limits[LIMIT_COUNT];
    int64_t block_bytes;
    const char *extensions[3]; /* null strings are a driver's fault that is to be survived */
    int32_t extension_count;
    const char *missing[2]; /* functions that the getter does not know */
    bool out_of_memory;
} driver;

static int block_count; /* on the heap */
static char logged[LOG_CAPACITY];
static int error_count, unknown_query_count, changing_call_count, getter_call_count;

/* Binding points, draw buffers, viewports, clip distances, viewport dimensions. */
static const limit state_limits[] = {{0x90DD, 8},  {0x8A2F, 36}, {0x8824, 8},
                                     {0x825B, 16}, {0x0D32, 8},  {0x0D3A, 16384}};

static const unsigned char *get_string(uint32_t name) {
    assert_int_equal(name, 0x1F02);
    return (const unsigned char *)driver.version;
}

static const unsigned char *get_string_indexed(uint32_t name, uint32_t index) {
    assert_int_equal(name, 0x1F03);
    assert_true((int32_t)index < driver.extension_count);
    return (const unsigned char *)driver.extensions[index];
}

/* An enumerant that a context does not know sets an error, which the host would find later. */
static void get_integer(uint32_t name, int32_t *value) {
    if (name == 0x821D) {
        *value = driver.extension_count;
        return;
    }
    for (size_t i = 0; i < LIMIT_COUNT; i++) {
        if (driver.limits[i].name == name) {
            *value = driver.limits[i].value;
            return;
        }
    }
    for (size_t i = 0; i < sizeof state_limits / sizeof *state_limits; i++) {
        if (state_limits[i].name == name) {
            value[0] = state_limits[i].value;
            if (name == 0x0D3A) /* viewport dimensions are two */
                value[1] = state_limits[i].value;
            return;
        }
    }
    unknown_query_count++;
}

static void get_integer64(uint32_t name, int64_t *value) {
    assert_int_equal(name, 0x90DE);
    *value = driver.block_bytes;
}

/* Stands for every function that changes something; none may be called. */
static void change_something(void) {
    changing_call_count++;
}

static bool is_missing(const char *name) {
    for (size_t i = 0; i < sizeof driver.missing / sizeof *driver.missing; i++)
        if (driver.missing[i] && strcmp(driver.missing[i], name) == 0)
            return true;
    return false;
}

static oit_proc get_proc(const char *name) {
    getter_call_count++;
    assert_string_not_equal(name, "glGetError");
    if (is_missing(name))
        return NULL;
    if (strcmp(name, "glGetString") == 0)
        return (oit_proc)get_string;
    if (strcmp(name, "glGetStringi") == 0)
        return (oit_proc)get_string_indexed;
    if (strcmp(name, "glGetIntegerv") == 0)
        return (oit_proc)get_integer;
    if (strcmp(name, "glGetInteger64v") == 0)
        return (oit_proc)get_integer64;
    return change_something;
}

/* ---- the host ---- */

static void *allocate(size_t size, void *user) {
    assert_ptr_equal(user, &block_count);
    if (driver.out_of_memory)
        return NULL;
    block_count++;
    return malloc(size);
}

static void release(void *block, void *user) {
    assert_ptr_equal(user, &block_count);
    assert_non_null(block);
    block_count--;
    free(block);
}

static void on_log(oit_log_level level, oit_result code, const char *text, void *user) {
    assert_ptr_equal(user, logged);
    assert_int_equal(level, OIT_LOG_ERROR);
    assert_int_not_equal(code, OIT_OK);
    assert_true(strlen(logged) + strlen(text) + 2 < sizeof logged);
    strcat(logged, text);
    strcat(logged, "\n");
    error_count++;
}

static int set_up(void **state) {
    static const struct driver good = {
        .version = "4.5 (Core Profile) Mesa 22.3.6",
        .limits = {{0x90DA, 16}, {0x90DB, 16}, {0x8F39, 24}, {0x90EB, 1024}},
        .block_bytes = (int64_t)1 << 33,
        .extensions = {"GL_KHR_debug", NULL, "GL_OES_shader_image_atomic_not"},
        .extension_count = 3,
    };
    (void)state;
    driver = good;
    logged[0] = '\0';
    block_count = error_count = unknown_query_count = changing_call_count = getter_call_count = 0;
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    return block_count != 0 || unknown_query_count != 0 || changing_call_count != 0;
}

static oit_desc make_desc(void) {
    oit_desc desc = {.get_proc = get_proc,
                     .alloc_fn = allocate,
                     .free_fn = release,
                     .alloc_user = &block_count,
                     .log_fn = on_log,
                     .log_user = logged};
    return desc;
}

static void expect_said(const char *text) {
    if (!strstr(logged, text)) {
        print_error("not said: %s\nsaid: %s", text, logged);
        fail();
    }
}

static void expect_refusal(const oit_desc *desc, oit_result expected) {
    oit_result result = OIT_OK;
    assert_null(oit_create(desc, &result));
    assert_int_equal(result, expected);
    assert_int_equal(block_count, 0);
    assert_int_equal(unknown_query_count + changing_call_count, 0);
    assert_null(oit_create(desc, NULL));
}

static oit_info expect_success(const oit_desc *desc) {
    oit_result result = OIT_RESULT_COUNT;
    oit_context *oit = oit_create(desc, &result);
    assert_int_equal(result, OIT_OK);
    assert_non_null(oit);
    oit_info info = oit_get_info(oit);
    oit_destroy(oit);
    assert_int_equal(error_count, 0);
    return info;
}

/* ---- tests ---- */

static void test_desktop(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    oit_info info = expect_success(&desc);
    assert_int_equal(info.es, 0);
    assert_int_equal(info.version, 450);
    assert_int_equal(info.fragment_storage_blocks, 16);
    assert_int_equal(info.compute_storage_blocks, 16);
    assert_int_equal(info.combined_outputs, 24);
    assert_int_equal(info.compute_invocations, 1024);
    assert_true(info.storage_block_bytes == (int64_t)1 << 33);
    assert_int_equal(info.image_atomics, 1);
}

/* The least that is accepted, exactly. */
static void test_least_that_is_enough(void **state) {
    static const limit least[LIMIT_COUNT] = {{0x90DA, 2}, {0x90DB, 4}, {0x8F39, 4}, {0x90EB, 128}};
    (void)state;
    oit_desc desc = make_desc();
    driver.version = "OpenGL ES 3.1 Mesa 22.3.6";
    memcpy(driver.limits, least, sizeof least);
    driver.block_bytes = 1 << 24;
    oit_info info = expect_success(&desc);
    assert_int_equal(info.es, 1);
    assert_int_equal(info.version, 310);
    assert_int_equal(info.image_atomics, 0);
}

static void test_versions(void **state) {
    static const struct {
        const char *string;
        oit_result result;
        int version;
        const char *said;
    } cases[] = {
        {"4.3.0 NVIDIA 535.54", OIT_OK, 430, NULL},
        {"4.6 (Compatibility Profile)", OIT_OK, 460, NULL},
        {"10.0", OIT_OK, 1000, NULL},
        {"OpenGL ES 3.1", OIT_OK, 310, NULL},
        {"OpenGL ES 3.2 v1.r38p1", OIT_OK, 320, NULL},
        {"4.2", OIT_GL_TOO_OLD, 0, "found OpenGL 4.2; needed is OpenGL 4.3 or OpenGL ES 3.1"},
        {"3.3 (Core Profile) Mesa 22.3.6", OIT_GL_TOO_OLD, 0, "found OpenGL 3.3; needed is OpenGL 4.3"},
        {"OpenGL ES 3.0 Mesa 22.3.6", OIT_GL_TOO_OLD, 0, "found OpenGL ES 3.0; needed is OpenGL 4.3"},
        {"OpenGL ES-CM 1.1", OIT_GL_TOO_OLD, 0, "no version can be read from GL_VERSION \"OpenGL ES-CM 1.1\""},
        {NULL, OIT_GL_TOO_OLD, 0, "there is no GL_VERSION; is a context current?"},
        {"", OIT_GL_TOO_OLD, 0, "no version can be read from GL_VERSION \"\""},
        {"OpenGL ES ", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"4", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"4.", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"4.x", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {".3", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"-4.3", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"1234.5", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"99999999999999999999.3", OIT_GL_TOO_OLD, 0, "no version can be read"},
        {"\xff\xfe", OIT_GL_TOO_OLD, 0, "no version can be read"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        oit_desc desc = make_desc();
        set_up(state);
        driver.version = cases[i].string;
        if (cases[i].result == OIT_OK) {
            assert_int_equal(expect_success(&desc).version, cases[i].version);
            continue;
        }
        expect_refusal(&desc, cases[i].result);
        expect_said(cases[i].said);
        expect_said("layers(n) of transparency.h needs only OpenGL 3.3 or OpenGL ES 3.0");
    }
}

/* A version string without an end in sight is cut in the message. */
static void test_long_version_is_cut(void **state) {
    static char string[3000];
    (void)state;
    oit_desc desc = make_desc();
    memset(string, 'x', sizeof string - 1);
    driver.version = string;
    expect_refusal(&desc, OIT_GL_TOO_OLD);
    expect_said("no version can be read from GL_VERSION \"xxxx");
    assert_in_range(strlen(logged), 300, 800); /* of two refusals */
}

static void test_version_can_be_capped(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    desc.max_gl_version = 430;
    assert_int_equal(expect_success(&desc).version, 430);
    desc.max_gl_version = 460;
    assert_int_equal(expect_success(&desc).version, 450);
    desc.max_gl_version = 330;
    expect_refusal(&desc, OIT_GL_TOO_OLD);
    expect_said("found OpenGL 4.5, used as OpenGL 3.3; needed is OpenGL 4.3");
}

/* On ES an image atomic is known by version or extension, never by a pointer. */
static void test_image_atomics(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    driver.version = "OpenGL ES 3.2";
    assert_int_equal(expect_success(&desc).image_atomics, 1);
    desc.max_gl_version = 310;
    assert_int_equal(expect_success(&desc).image_atomics, 0);
    driver.extensions[2] = "GL_OES_shader_image_atomic";
    assert_int_equal(expect_success(&desc).image_atomics, 1);
    driver.extension_count = 2;
    assert_int_equal(expect_success(&desc).image_atomics, 0);
}

static void test_missing_functions_are_named(void **state) {
    static const char *const names[] = {"glGetString",     "glGetStringi",     "glGetIntegerv",      "glGetInteger64v",
                                        "glBufferData",    "glGenBuffers",     "glDispatchCompute",  "glMemoryBarrier",
                                        "glDeleteBuffers", "glBindBufferBase", "glViewportIndexedf", "glColorMaski"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char message[64] = "oit_create: ";
        oit_desc desc = make_desc();
        set_up(state);
        driver.missing[0] = names[i];
        expect_refusal(&desc, OIT_MISSING_FUNCTION);
        strcat(message, names[i]);
        strcat(message, " is missing;");
        expect_said(message);
        expect_said("transparency.h");
    }
}

static void test_all_missing_functions_are_named(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    driver.missing[0] = "glMemoryBarrier";
    driver.missing[1] = "glBufferData";
    expect_refusal(&desc, OIT_MISSING_FUNCTION);
    expect_said("glMemoryBarrier is missing");
    expect_said("glBufferData is missing");
}

/* Bytes of a fragment, by what is chosen: eight-byte steps, four bytes a field, and not one for what is not chosen. */
static void test_bytes_of_a_fragment(void **state) {
    static const struct {
        oit_color color;
        uint32_t fields;
        int words, bytes;
    } cases[] = {
        {OIT_COLOR_8, 0, 0, 16},
        {OIT_COLOR_8, OIT_FIELD_PART, 0, 16},
        {OIT_COLOR_8, OIT_FIELD_BLEND, 0, 16},
        {OIT_COLOR_8, OIT_FIELD_PART | OIT_FIELD_BLEND, 0, 16},
        {OIT_COLOR_8, OIT_FIELD_PART | OIT_FIELD_KEY, 0, 24},
        {OIT_COLOR_8, OIT_FIELD_COVERAGE, 0, 16},
        {OIT_COLOR_8, OIT_FIELD_UV, 0, 24},
        {OIT_COLOR_8, OIT_FIELD_UV | OIT_FIELD_NORMAL, 0, 24},
        {OIT_COLOR_8, 0, 1, 16},
        {OIT_COLOR_8, 0, 2, 24},
        {OIT_COLOR_HALF, 0, 0, 16},
        {OIT_COLOR_HALF, OIT_FIELD_PART, 0, 16},
        {OIT_COLOR_HALF, OIT_FIELD_BLEND, 0, 16},
        {OIT_COLOR_HALF, OIT_FIELD_BLEND | OIT_FIELD_PART, 0, 24},
        {OIT_COLOR_FLOAT, 0, 0, 24},
        {OIT_COLOR_FLOAT, OIT_FIELD_PART, 0, 24},
        {OIT_COLOR_FLOAT, OIT_FIELD_PART | OIT_FIELD_KEY, 0, 32},
        {OIT_COLOR_FLOAT, OIT_FIELD_NORMAL | OIT_FIELD_UV | OIT_FIELD_PART, 8, 72},
    };
    (void)state;
    driver.extensions[0] = "GL_ARB_post_depth_coverage";
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        oit_desc desc = make_desc();
        desc.color = cases[i].color;
        desc.fields = cases[i].fields;
        desc.host_words = cases[i].words;
        assert_int_equal(expect_success(&desc).fragment_bytes, cases[i].bytes);
    }
}

/* The value that all stages are compiled with. */
static bool find_define(const char *source, const char *condition_name, int *value) {
    char pattern[64];
    snprintf(pattern, sizeof pattern, "#define %s ", condition_name);
    const char *at = strstr(source, pattern);
    if (!at)
        return false;
    *value = atoi(at + strlen(pattern));
    return true;
}

/* What is not chosen is switched off in the text of every stage, extensions are asked for only where they are needed, and the
 * switches are not cut. */
static void test_text_of_what_is_not_chosen(void **state) {
    static const struct {
        uint32_t field;
        const char *name;
    } fields[] = {{OIT_FIELD_PART, "OIT_HAS_PART"},   {OIT_FIELD_KEY, "OIT_HAS_KEY"},
                  {OIT_FIELD_BLEND, "OIT_HAS_BLEND"}, {OIT_FIELD_NORMAL, "OIT_HAS_NORMAL"},
                  {OIT_FIELD_UV, "OIT_HAS_UV"},       {OIT_FIELD_COVERAGE, "OIT_HAS_COVERAGE"}};
    (void)state;
    driver.extensions[0] = "GL_ARB_post_depth_coverage";
    for (unsigned chosen = 0; chosen < 64; chosen++) {
        oit_desc desc = make_desc();
        desc.fields = chosen;
        desc.alpha_law = chosen % 2 ? OIT_ALPHA_ADAPTIVE : OIT_ALPHA_CONSTANT;
        oit_context *oit = oit_create(&desc, NULL);
        assert_non_null(oit);
        int value = -1;
        for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
            assert_true(find_define(oit->preamble, fields[i].name, &value));
            assert_int_equal(value, (chosen & fields[i].field) != 0);
        }
        assert_true(find_define(oit->preamble, "OIT_ADAPTIVE", &value));
        assert_int_equal(value, chosen % 2);
        assert_int_equal(strstr(oit->preamble, "#extension") != NULL, (chosen & OIT_FIELD_COVERAGE) != 0);
        assert_true(strlen(oit->preamble) + 1 < sizeof oit->preamble);
        oit_destroy(oit);
    }
}

static void test_small_limits_are_named(void **state) {
    static const struct {
        size_t index;
        int32_t value;
        const char *said;
    } cases[] = {
        {0, 0, "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS is 0; needed is 2"},
        {0, 1, "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS is 1; needed is 2"},
        {1, 3, "GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS is 3; needed is 4"},
        {2, 3, "GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES is 3; needed is 4"},
        {3, 127, "GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS is 127; needed is 128"},
        {3, INT32_MIN, "GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS is -2147483648; needed is 128"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        oit_desc desc = make_desc();
        set_up(state);
        driver.limits[cases[i].index].value = cases[i].value;
        expect_refusal(&desc, OIT_LIMIT_TOO_SMALL);
        expect_said(cases[i].said);
        expect_said("transparency.h");
    }
}

static void test_small_blocks_are_named(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    driver.block_bytes = (1 << 24) - 1;
    driver.limits[0].value = 0;
    expect_refusal(&desc, OIT_LIMIT_TOO_SMALL);
    expect_said("GL_MAX_SHADER_STORAGE_BLOCK_SIZE is 16777215; needed is 16777216");
    expect_said("GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS is 0; needed is 2");
}

static void test_out_of_memory(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    driver.out_of_memory = true;
    expect_refusal(&desc, OIT_OUT_OF_MEMORY);
    expect_said("oit_create: out of memory\n");
}

static void test_bad_descs(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    expect_refusal(NULL, OIT_INVALID_ARGUMENT);
    desc.get_proc = NULL;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("get_proc is missing");
    desc = make_desc();
    desc.free_fn = NULL;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("alloc_fn and free_fn go together");
    desc = make_desc();
    desc.alloc_fn = NULL;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    desc = make_desc();
    desc.max_gl_version = -1;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("max_gl_version is negative");
    assert_int_equal(getter_call_count, 0);
}

/* What the stores that keep the k nearest are given. */
static void test_bad_budgets(void **state) {
    (void)state;
    oit_desc desc = make_desc();
    desc.store = OIT_STORE_BUDGET;
    desc.budget_bytes = -1;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("budget_bytes or layers is negative");
    desc.budget_bytes = 0;
    desc.layers = -1;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("budget_bytes or layers is negative");
    desc = make_desc();
    desc.store = OIT_STORE_BUCKETED;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("OIT_STORE_BUCKETED groups fragments by OIT_FIELD_PART, which is not chosen");
    desc.fields = OIT_FIELD_PART;
    desc.bucket_depth_bits = 24;
    expect_refusal(&desc, OIT_INVALID_ARGUMENT);
    expect_said("bucket_depth_bits is none of 0, 16 and 32");
    assert_int_equal(getter_call_count, 0);
}

/* Without an allocator, a log function or a result the defaults serve. */
static void test_defaults(void **state) {
    (void)state;
    oit_desc desc = {.get_proc = get_proc};
    oit_context *oit = oit_create(&desc, NULL);
    assert_non_null(oit);
    oit_destroy(oit);
    driver.version = "3.3";
    expect_refusal(&desc, OIT_GL_TOO_OLD);
    assert_int_equal(error_count, 0);
}

static void test_null_contexts(void **state) {
    (void)state;
    oit_info info = oit_get_info(NULL);
    assert_int_equal(info.version, 0);
    assert_int_equal(info.fragment_storage_blocks, 0);
    oit_destroy(NULL);
}

static void test_result_strings(void **state) {
    (void)state;
    assert_string_equal(oit_result_string(OIT_OK), "no error");
    assert_string_equal(oit_result_string(OIT_LIMIT_TOO_SMALL),
                        "a limit of the context is too small for fragment buffers");
    assert_string_equal(oit_result_string(OIT_RESULT_COUNT), "not a result");
    for (unsigned i = 0; i < (unsigned)OIT_RESULT_COUNT; i++)
        for (unsigned j = 0; j < i; j++)
            assert_string_not_equal(oit_result_string((oit_result)i), oit_result_string((oit_result)j));
}

#define DRIVER_TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void) {
    const struct CMUnitTest tests[] = {
        DRIVER_TEST(test_desktop),
        DRIVER_TEST(test_least_that_is_enough),
        DRIVER_TEST(test_versions),
        DRIVER_TEST(test_long_version_is_cut),
        DRIVER_TEST(test_version_can_be_capped),
        DRIVER_TEST(test_image_atomics),
        DRIVER_TEST(test_missing_functions_are_named),
        DRIVER_TEST(test_all_missing_functions_are_named),
        DRIVER_TEST(test_bytes_of_a_fragment),
        DRIVER_TEST(test_text_of_what_is_not_chosen),
        DRIVER_TEST(test_small_limits_are_named),
        DRIVER_TEST(test_small_blocks_are_named),
        DRIVER_TEST(test_out_of_memory),
        DRIVER_TEST(test_bad_descs),
        DRIVER_TEST(test_bad_budgets),
        DRIVER_TEST(test_defaults),
        DRIVER_TEST(test_null_contexts),
        DRIVER_TEST(test_result_strings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
