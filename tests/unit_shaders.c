/* shaders_embedded.h, and tools/embed_shaders.c, which writes it: the program is run on folders that are made here. */
#define _POSIX_C_SOURCE 200809L
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define SHADERS_EMBEDDED_IMPLEMENTATION
#include "shaders_embedded.h"

/* Run from the top of the repository, as `make test` does. */
#define TOOL "build/embed_shaders"
#define MARKERS                                                                                                        \
    "/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */\n"                \
    "/* ==== end of generated shaders ==== */\n"
#define GOOD_SHADER "// For: transparency.h\n// Good.\nvoid main() {}\n"

static char folder[64];   /* the tree that the tool is run on */
static char output[4096]; /* what it said */

static void fail_with(const char *what, const char *name) {
    print_error("%s: %s\n", what, name);
    fail();
}

static void make_path(char path[512], const char *name) {
    assert_true(snprintf(path, 512, "%s/%s", folder, name) < 512);
}

static void write_bytes(const char *name, const char *bytes, size_t size) {
    char path[512];
    make_path(path, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static void write_text(const char *name, const char *content) {
    write_bytes(name, content, strlen(content));
}

/* The caller frees it. */
static char *read_path(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_with("cannot be read", path);
    size_t size = 0, capacity = 1 << 20;
    char *content = malloc(capacity);
    assert_non_null(content);
    size = fread(content, 1, capacity - 1, file);
    assert_true(size < capacity - 1);
    content[size] = '\0';
    fclose(file);
    return content;
}

static char *read_text(const char *name) {
    char path[512];
    make_path(path, name);
    return read_path(path);
}

static void assert_content(const char *name, const char *expected) {
    char *content = read_text(name);
    assert_string_equal(content, expected);
    free(content);
}

static int run(const char *command) {
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    size_t size = fread(output, 1, sizeof output - 1, pipe);
    output[size] = '\0';
    int status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static int run_tool(const char *options) {
    char command[256];
    snprintf(command, sizeof command, TOOL " %s %s 2>&1", folder, options);
    return run(command);
}

/* A tree that is good: three headers with empty blocks and a shader. */
static int set_up(void **state) {
    (void)state;
    strcpy(folder, "/tmp/unit_shaders.XXXXXX");
    assert_non_null(mkdtemp(folder));
    char path[512];
    make_path(path, "shaders");
    assert_int_equal(mkdir(path, 0755), 0);
    write_text("transparency.h", "before\n" MARKERS "after\n");
    write_text("oit_buffers.h", MARKERS);
    write_text("shaders_embedded.h", MARKERS);
    write_text("shaders/good.frag", GOOD_SHADER);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return run(command);
}

/* ---- the header ---- */

/* Drops the #line that a chunk begins with; it must name the line of the file that the chunk begins at. */
static const char *skip_line_directive(const char *chunk, int line) {
    char directive[32];
    int length = snprintf(directive, sizeof directive, "#line %d\n", line);
    assert_int_equal(strncmp(chunk, directive, (size_t)length), 0);
    return chunk + length;
}

static void expect_shader_is_file(const char *name) {
    char path[512];
    int chunk_count = -1, line = 1;
    snprintf(path, sizeof path, "shaders/%s", name);
    char *content = read_path(path);
    const char *rest = content;
    const char *const *chunks = shaders_get(name, &chunk_count);
    assert_non_null(chunks);
    assert_true(chunk_count > 0);
    for (int i = 0; i < chunk_count; i++) {
        assert_true(strlen(chunks[i]) < 4000);
        const char *chunk = skip_line_directive(chunks[i], line);
        size_t length = strlen(chunk);
        if (strncmp(rest, chunk, length) != 0)
            fail_with("differs from the file", name);
        rest += length;
        for (; *chunk; chunk++)
            line += *chunk == '\n';
    }
    assert_null(chunks[chunk_count]);
    assert_string_equal(rest, "");
    free(content);
}

static void test_each_shader_is_its_file(void **state) {
    (void)state;
    assert_true(shaders_count() > 0);
    for (int i = 0; i < shaders_count(); i++)
        expect_shader_is_file(shaders_name(i));
}

static void test_every_file_is_there(void **state) {
    (void)state;
    assert_int_equal(run("ls shaders | wc -l"), 0);
    assert_int_equal(atoi(output), shaders_count());
}

static void test_names_are_sorted(void **state) {
    (void)state;
    for (int i = 1; i < shaders_count(); i++)
        assert_true(strcmp(shaders_name(i - 1), shaders_name(i)) < 0);
    assert_null(shaders_name(-1));
    assert_null(shaders_name(shaders_count()));
}

static void test_unknown_names_give_null(void **state) {
    (void)state;
    static const char *const unknown[] = {NULL, "", "no_such.frag", "surface", "\xff", "~"};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
        int chunk_count = -1;
        assert_null(shaders_get(unknown[i], &chunk_count));
        assert_int_equal(chunk_count, 0);
        assert_null(shaders_get(unknown[i], NULL));
    }
    assert_non_null(shaders_get(shaders_name(0), NULL));
}

/* ---- the tool: good input ---- */

static void test_only_named_headers_get_a_shader(void **state) {
    (void)state;
    assert_int_equal(run_tool(""), 0);
    char *content = read_text("transparency.h");
    assert_non_null(strstr(content, "static const char *const tr_i_shader_good_frag[] = {\n    \"#line 1\\n\"\n"
                                    "    \"// For: transparency.h\\n\"\n    \"// Good.\\n\"\n"
                                    "    \"void main() {}\\n\",\n    0};\n"));
    assert_int_equal(strncmp(content, "before\n", 7), 0);
    assert_string_equal(content + strlen(content) - 6, "after\n");
    free(content);
    assert_content("oit_buffers.h", MARKERS);
    content = read_text("shaders_embedded.h");
    assert_non_null(strstr(content, "    {\"good.frag\", shaders_i_shader_good_frag, 1},\n    {0, 0, 0}};\n"));
    free(content);
}

static void test_both_headers_can_be_named(void **state) {
    (void)state;
    write_text("shaders/both.glsl", "// For: transparency.h, oit_buffers.h\n// Both.\n");
    assert_int_equal(run_tool(""), 0);
    char *content = read_text("transparency.h");
    assert_non_null(strstr(content, "tr_i_shader_both_glsl[]"));
    free(content);
    content = read_text("oit_buffers.h");
    assert_non_null(strstr(content, "oit_i_shader_both_glsl[]"));
    assert_null(strstr(content, "good"));
    free(content);
}

static void test_second_run_writes_nothing(void **state) {
    (void)state;
    assert_int_equal(run_tool(""), 0);
    assert_string_equal(output, "wrote transparency.h\nwrote shaders_embedded.h\n");
    assert_int_equal(run_tool(""), 0);
    assert_string_equal(output, "");
}

static void test_check_names_the_stale_and_writes_nothing(void **state) {
    (void)state;
    assert_int_equal(run_tool("--check"), 1);
    assert_non_null(strstr(output, "transparency.h is stale"));
    assert_non_null(strstr(output, "shaders_embedded.h is stale"));
    assert_null(strstr(output, "oit_buffers.h"));
    assert_content("transparency.h", "before\n" MARKERS "after\n");
    assert_int_equal(run_tool(""), 0);
    assert_int_equal(run_tool("--check"), 0);
    assert_string_equal(output, "");
    write_text("shaders/good.frag", GOOD_SHADER "// More.\n");
    assert_int_equal(run_tool("--check"), 1);
}

/* A removed shader leaves the block. */
static void test_blocks_are_emptied(void **state) {
    (void)state;
    assert_int_equal(run_tool(""), 0);
    char path[512];
    make_path(path, "shaders/good.frag");
    assert_int_equal(unlink(path), 0);
    assert_int_equal(run_tool(""), 0);
    assert_content("transparency.h", "before\n" MARKERS "after\n");
}

/* Compiles what was written and prints the shader: what comes back must be what went in. */
static void expect_round_trip(const char *shader) {
    write_text("shaders/good.frag", shader);
    char *header = read_path("shaders_embedded.h");
    write_text("shaders_embedded.h", header);
    free(header);
    assert_int_equal(run_tool(""), 0);
    write_text("print.c",
               "#include <stdio.h>\n#define SHADERS_EMBEDDED_IMPLEMENTATION\n#include \"shaders_embedded.h\"\n"
               "int main(void) {\n    int count, i;\n"
               "    const char *const *chunks = shaders_get(\"good.frag\", &count);\n"
               "    for (i = 0; i < count; i++)\n        fputs(chunks[i], stdout);\n    return 0;\n}\n");
    char command[512];
    snprintf(command, sizeof command,
             "cd %s && gcc -std=c99 -trigraphs -Wall -Wpedantic -Werror print.c -o print && ./print", folder);
    assert_int_equal(run(command), 0);
    assert_string_equal(skip_line_directive(output, 1), shader);
}

static void test_escapes_survive_a_compiler(void **state) {
    (void)state;
    expect_round_trip("// For: transparency.h\n// \"Quoted\", ?\?= ?\?/ ?\?\?( ?\?\?\?) \\ \\n \\\" %d %s */ /* 'x'\n"
                      "#define TWO(a) \\\n    ((a) + \\\n     (a))\n\n\n?\?\n=\n");
}

/* The bytes of the string literal between the quotes that `at` points to. */
static size_t literal_length(const char *at) {
    size_t length = 0;
    for (at++; *at != '"'; at++, length++)
        at += *at == '\\';
    return length;
}

/* Each chunk says at which line of the file it begins, is short enough, and is not cut off sooner than need be: the
   lines of the test are shorter than 120 bytes. Returns how many there are. */
static int expect_good_chunks(const char *block) {
    size_t length = 0;
    int line = 1, chunks = 0;
    for (const char *at = block; (at = strstr(at, "\n    \"")) != NULL; at++) {
        const char *literal = at + 5;
        if (strncmp(literal, "\"#line ", 7) == 0) {
            assert_int_equal(atoi(literal + 7), line);
            assert_int_equal(line % 2, 1); /* two lines a macro: none is cut in the middle */
            if (chunks > 0)
                assert_in_range(length, 4000 - 240, 3999);
            length = 0;
            chunks++;
        } else {
            line++;
        }
        length += literal_length(literal);
    }
    return chunks;
}

static void test_chunks_are_cut_between_lines(void **state) {
    (void)state;
    static char shader[40000];
    int length = snprintf(shader, sizeof shader, "// For: transparency.h\n// Long.\n");
    for (int i = 0; i < 400; i++)
        length +=
            snprintf(shader + length, sizeof shader - (size_t)length, "#define LINE_%d \\\n    %0*d\n", i, i % 90, i);
    write_text("shaders/good.frag", shader);
    assert_int_equal(run_tool(""), 0);
    char *content = read_text("transparency.h");
    assert_in_range(expect_good_chunks(content), 7, 8);
    free(content);
}

/* ---- the tool: bad input ---- */

/* The tool fails, says what is in `said`, and writes nothing. */
static void expect_refusal(const char *said) {
    char *before = read_text("transparency.h");
    assert_int_equal(run_tool(""), 1);
    if (!strstr(output, said)) {
        print_error("said: %s", output);
        fail_with("did not say", said);
    }
    assert_content("transparency.h", before);
    assert_content("shaders_embedded.h", MARKERS);
    free(before);
}

static void test_bad_shaders_are_refused(void **state) {
    (void)state;
    static const struct {
        const char *content, *said;
    } cases[] = {
        {"// Good.\nvoid main() {}\n", "shaders/bad.frag:1: the first line must name the headers"},
        {"", "shaders/bad.frag:1: the last line does not end with a line feed"},
        {"// For: nothing.h\n// Bad.\n", "shaders/bad.frag:1: unknown header 'nothing.h'"},
        {"// For: shaders_embedded.h\n// Bad.\n", "shaders/bad.frag:1: unknown header 'shaders_embedded.h'"},
        {"// For: transparency.h,\n// Bad.\n", "shaders/bad.frag:1: unknown header ''"},
        {"// For: transparency.h \n// Bad.\n", "shaders/bad.frag:1: unknown header 'transparency.h '"},
        {"// For: transparency.h, transparency.h\n// Bad.\n", "shaders/bad.frag:1: transparency.h is named twice"},
        {"// For: transparency.h\nvoid main() {}\n", "shaders/bad.frag:2: the second line must be a comment"},
        {"// For: transparency.h\n// Bad.\n\nfloat \xc3\xa9;\n", "shaders/bad.frag:4: byte 0xc3"},
        {"// For: transparency.h\n// Bad.\n\tvoid main() {}\n", "shaders/bad.frag:3: byte 0x09"},
        {"// For: transparency.h\r\n", "shaders/bad.frag:1: byte 0x0d"},
        {"// For: transparency.h\n// Bad.\n// no end", "shaders/bad.frag:3: the last line does not end"},
        {"// For: transparency.h\n// Bad.\n  #version 330\n", "shaders/bad.frag:3: no #version here"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        write_text("shaders/bad.frag", cases[i].content);
        expect_refusal(cases[i].said);
    }
}

static void test_zero_byte_is_refused(void **state) {
    (void)state;
    write_bytes("shaders/bad.frag", "// For: transparency.h\n// Bad.\n\0\n", 34);
    expect_refusal("shaders/bad.frag:3: byte 0x00");
}

static void write_long_line(const char *start, size_t length, const char *end) {
    static char content[8000];
    size_t at = strlen(start);
    memcpy(content, start, at);
    memset(content + at, '/', length);
    strcpy(content + at + length, end);
    write_text("shaders/long.glsl", content);
}

static void test_long_lines_are_refused(void **state) {
    (void)state;
    write_long_line("// For: transparency.h\n// Long.\n", 3900, "\n");
    expect_refusal("shaders/long.glsl:3: a line of 3901 bytes, more than 3900");
    write_long_line("// For: transparency.h\n// Long.\n#define X \\\n", 3890, "\n");
    expect_refusal("shaders/long.glsl:3: a line of 3903 bytes, more than 3900");
    write_long_line("// For: transparency.h\n// Long.\n", 3899, "\n");
    assert_int_equal(run_tool(""), 0);
}

static void test_bad_names_are_refused(void **state) {
    (void)state;
    static const char *const names[] = {"shaders/bad.frag~", "shaders/Bad.frag", "shaders/bad",
                                        "shaders/a.b.frag",  "shaders/bad.txt",  "shaders/b-d.vert"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[512];
        write_text(names[i], GOOD_SHADER);
        expect_refusal("file names are of a-z, 0-9 and _");
        make_path(path, names[i]);
        assert_int_equal(unlink(path), 0);
    }
    write_text("shaders/.hidden", "an editor's file\n");
    assert_int_equal(run_tool(""), 0);
}

static void test_bad_headers_are_refused(void **state) {
    (void)state;
    static const char *const bad[] = {
        "no markers\n",
        "/* ==== end of generated shaders ==== */\n"
        "/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */\n",
        "/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */\n",
        "  " MARKERS,
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        write_text("transparency.h", bad[i]);
        expect_refusal("transparency.h: needs the two marker lines");
    }
    write_text("transparency.h", MARKERS);
    write_text("oit_buffers.h", bad[2]); /* half a block is a mistake even where no shader goes */
    expect_refusal("oit_buffers.h: needs the two marker lines");
    write_text("transparency.h", MARKERS MARKERS);
    expect_refusal("transparency.h: this marker line stands there twice");
}

static void test_missing_files_are_refused(void **state) {
    (void)state;
    char path[512];
    make_path(path, "transparency.h");
    assert_int_equal(unlink(path), 0);
    assert_int_equal(run_tool(""), 1);
    assert_non_null(strstr(output, "transparency.h: there is no such file"));
    assert_content("shaders_embedded.h", MARKERS);
    assert_int_equal(run(TOOL " /nowhere 2>&1"), 1);
    assert_non_null(strstr(output, "/nowhere/shaders"));
}

/* A header that no shader names may be absent or without markers. */
static void test_unnamed_headers_are_left_alone(void **state) {
    (void)state;
    write_text("oit_buffers.h", "no markers\n");
    assert_int_equal(run_tool(""), 0);
    assert_content("oit_buffers.h", "no markers\n");
    char path[512];
    make_path(path, "oit_buffers.h");
    assert_int_equal(unlink(path), 0);
    assert_int_equal(run_tool(""), 0);
    assert_int_not_equal(access(path, F_OK), 0);
}

static void test_usage(void **state) {
    (void)state;
    assert_int_equal(run(TOOL " --nonsense 2>&1"), 2);
    assert_int_equal(run_tool("second"), 2);
    assert_non_null(strstr(output, "usage: embed_shaders"));
}

#define TREE_TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_shader_is_its_file),
        cmocka_unit_test(test_every_file_is_there),
        cmocka_unit_test(test_names_are_sorted),
        cmocka_unit_test(test_unknown_names_give_null),
        TREE_TEST(test_only_named_headers_get_a_shader),
        TREE_TEST(test_both_headers_can_be_named),
        TREE_TEST(test_second_run_writes_nothing),
        TREE_TEST(test_check_names_the_stale_and_writes_nothing),
        TREE_TEST(test_blocks_are_emptied),
        TREE_TEST(test_escapes_survive_a_compiler),
        TREE_TEST(test_chunks_are_cut_between_lines),
        TREE_TEST(test_bad_shaders_are_refused),
        TREE_TEST(test_zero_byte_is_refused),
        TREE_TEST(test_long_lines_are_refused),
        TREE_TEST(test_bad_names_are_refused),
        TREE_TEST(test_bad_headers_are_refused),
        TREE_TEST(test_missing_files_are_refused),
        TREE_TEST(test_unnamed_headers_are_left_alone),
        TREE_TEST(test_usage),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
