/*
 * embed_shaders [TOP] [--check]
 *
 * Writes the GLSL of TOP/shaders/ as C strings into the marked blocks of the headers in TOP (default "."), so that each
 * header can be used alone. The first line of a shader file names the headers that need it:
 *
 *     // For: transparency.h, oit_buffers.h
 *     // What this file is, in a line.
 *
 * shaders_embedded.h gets every file, and a table of them sorted by name. Files are written only when their content
 * changes, and only after every input was found good. With --check nothing is written: a stale header is named and the
 * exit status is 1. Other exit statuses: 0 done, 1 failed, 2 usage.
 *
 * The output is the same on every machine: sorted by bytes, no dates. Each string literal is a chunk of less than
 * 4,000 bytes, because C99 promises no more than 4,095. Each chunk starts with a #line of its own, because drivers may
 * count lines anew in each string that glShaderSource is given.
 */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BLOCK_BEGIN "/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */\n"
#define BLOCK_END "/* ==== end of generated shaders ==== */\n"
#define FOR_LINE "// For: "

enum { CHUNK_LIMIT = 3999, LINE_LIMIT = 3900, NAME_LIMIT = 64, HEADER_COUNT = 3, ALL_HEADER = 2 };

typedef struct text {
    char *data; /* always ends with a zero byte that length does not count */
    size_t length, capacity;
} text;

typedef struct shader {
    char name[NAME_LIMIT];       /* "surface.vert" */
    char identifier[NAME_LIMIT]; /* "surface_vert" */
    text source;
    bool wanted[HEADER_COUNT];
    size_t chunk_count;
} shader;

typedef struct header {
    const char *name, *prefix;
    text old_text, new_text;
    bool present;
} header;

static _Noreturn void fail(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("embed_shaders: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(1);
}

static void text_append(text *to, const char *bytes, size_t count) {
    if (to->length + count + 1 > to->capacity) {
        to->capacity = (to->length + count + 1) * 2;
        to->data = realloc(to->data, to->capacity);
        if (!to->data)
            fail("out of memory");
    }
    memcpy(to->data + to->length, bytes, count);
    to->length += count;
    to->data[to->length] = '\0';
}

static void text_print(text *to, const char *format, ...) {
    char line[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= sizeof line)
        fail("a generated line is too long: %s", line);
    text_append(to, line, (size_t)length);
}

/* Returns false when there is no such file; every other trouble ends the program. */
static bool read_file(const char *path, text *to) {
    char block[4096];
    size_t count;
    FILE *file = fopen(path, "rb");
    if (!file && errno == ENOENT)
        return false;
    if (!file)
        fail("%s: %s", path, strerror(errno));
    text_append(to, "", 0);
    while ((count = fread(block, 1, sizeof block, file)) > 0)
        text_append(to, block, count);
    if (ferror(file))
        fail("%s: %s", path, strerror(errno));
    fclose(file);
    return true;
}

/* Through a temporary file, so that a full disk leaves the old header whole. */
static void write_file(const char *path, const text *from) {
    char temporary[4096 + 8];
    snprintf(temporary, sizeof temporary, "%s.new", path);
    FILE *file = fopen(temporary, "wb");
    if (!file)
        fail("%s: %s", temporary, strerror(errno));
    size_t written = fwrite(from->data, 1, from->length, file);
    if (fclose(file) != 0 || written != from->length || rename(temporary, path) != 0) {
        remove(temporary);
        fail("%s: cannot be written: %s", path, strerror(errno));
    }
}

static void join_path(char path[4096], const char *top, const char *folder, const char *name) {
    if (snprintf(path, 4096, "%s/%s%s", top, folder, name) >= 4096)
        fail("the path of %s is too long", name);
}

static size_t line_end(const text *source, size_t at) {
    return (size_t)(strchr(source->data + at, '\n') - source->data) + 1;
}

/* The end of a line together with those that it goes on in after a backslash: no #line may be put between them. */
static size_t logical_line_end(const text *source, size_t at) {
    size_t end = line_end(source, at);
    while (end < source->length && end - at >= 2 && source->data[end - 2] == '\\')
        end = line_end(source, end);
    return end;
}

static void check_name(shader *it) {
    static const char *const extensions[] = {".vert", ".frag", ".comp", ".glsl"};
    const char *dot = strrchr(it->name, '.');
    bool good = dot && strspn(it->name, "abcdefghijklmnopqrstuvwxyz0123456789_") == (size_t)(dot - it->name);
    bool known = false;
    for (size_t i = 0; good && i < sizeof extensions / sizeof *extensions; i++)
        known = known || strcmp(dot, extensions[i]) == 0;
    if (!known)
        fail("shaders/%s: file names are of a-z, 0-9 and _, and end with .vert, .frag, .comp or .glsl", it->name);
    memcpy(it->identifier, it->name, sizeof it->name);
    it->identifier[dot - it->name] = '_';
}

static void check_bytes(const shader *it) {
    size_t line = 1;
    for (size_t i = 0; i < it->source.length; i++) {
        unsigned byte = (unsigned char)it->source.data[i];
        if (byte == '\n')
            line++;
        else if (byte < 0x20 || byte > 0x7e)
            fail("shaders/%s:%zu: byte 0x%02x: only printable ASCII, spaces and line feeds are allowed", it->name, line,
                 byte);
    }
    if (it->source.length == 0 || it->source.data[it->source.length - 1] != '\n')
        fail("shaders/%s:%zu: the last line does not end with a line feed", it->name, line);
}

static void check_lines(const shader *it) {
    size_t line = 1;
    for (size_t at = 0, end; at < it->source.length; at = end) {
        const char *line_text = it->source.data + at;
        end = logical_line_end(&it->source, at);
        if (end - at > LINE_LIMIT)
            fail("shaders/%s:%zu: a line of %zu bytes, more than %d", it->name, line, end - at, (int)LINE_LIMIT);
        if (strncmp(line_text + strspn(line_text, " "), "#version", 8) == 0)
            fail("shaders/%s:%zu: no #version here: the header puts it in front at run time", it->name, line);
        if (line == 2 && strncmp(line_text, "// ", 3) != 0)
            fail("shaders/%s:2: the second line must be a comment that says what the file is", it->name);
        for (size_t i = at; i < end; i++)
            line += it->source.data[i] == '\n';
    }
}

static void want_header(shader *it, const header *headers, const char *name, size_t length) {
    for (size_t i = 0; i < ALL_HEADER; i++) {
        if (strlen(headers[i].name) != length || strncmp(headers[i].name, name, length) != 0)
            continue;
        if (it->wanted[i])
            fail("shaders/%s:1: %s is named twice", it->name, headers[i].name);
        it->wanted[i] = true;
        return;
    }
    fail("shaders/%s:1: unknown header '%.*s': there are %s and %s", it->name, (int)length, name, headers[0].name,
         headers[1].name);
}

static void read_for_line(shader *it, const header *headers) {
    const char *at = it->source.data;
    if (strncmp(at, FOR_LINE, strlen(FOR_LINE)) != 0)
        fail("shaders/%s:1: the first line must name the headers that need the file, as in '" FOR_LINE "%s'", it->name,
             headers[0].name);
    at += strlen(FOR_LINE);
    for (;;) {
        size_t length = strcspn(at, ",\n");
        want_header(it, headers, at, length);
        at += length;
        if (*at == '\n')
            break;
        at++;
        at += strspn(at, " ");
    }
    it->wanted[ALL_HEADER] = true;
}

static void read_shader(shader *it, const char *top, const char *name, const header *headers) {
    char path[4096];
    memset(it, 0, sizeof *it);
    if (strlen(name) >= NAME_LIMIT)
        fail("shaders/%s: the name is longer than %d bytes", name, NAME_LIMIT - 1);
    memcpy(it->name, name, strlen(name) + 1);
    check_name(it);
    join_path(path, top, "shaders/", name);
    if (!read_file(path, &it->source))
        fail("%s: %s", path, strerror(errno));
    check_bytes(it);
    read_for_line(it, headers);
    check_lines(it);
}

static int compare_names(const void *a, const void *b) {
    return strcmp(((const shader *)a)->name, ((const shader *)b)->name);
}

static shader *read_shaders(const char *top, const header *headers, size_t *count) {
    char path[4096];
    size_t capacity = 0;
    shader *all = NULL;
    join_path(path, top, "shaders", "");
    DIR *folder = opendir(path);
    if (!folder)
        fail("%s: %s", path, strerror(errno));
    *count = 0;
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (entry->d_name[0] == '.')
            continue;
        if (*count == capacity) {
            capacity = capacity * 2 + 16;
            all = realloc(all, capacity * sizeof *all);
            if (!all)
                fail("out of memory");
        }
        read_shader(&all[(*count)++], top, entry->d_name, headers);
    }
    closedir(folder);
    if (*count)
        qsort(all, *count, sizeof *all, compare_names);
    return all;
}

/* A second question mark in a row is escaped, so that no trigraph arises. */
static void append_quoted(text *to, const char *line, size_t length) {
    text_append(to, "    \"", 5);
    for (size_t i = 0; i < length; i++) {
        bool escaped = line[i] == '\\' || line[i] == '"' || (line[i] == '?' && i > 0 && line[i - 1] == '?');
        if (escaped)
            text_append(to, "\\", 1);
        text_append(to, line + i, 1);
    }
    text_append(to, "\\n\"", 3);
}

static void append_shader(text *to, shader *it, const char *prefix) {
    size_t line = 1, chunk_bytes = 0;
    it->chunk_count = 0;
    text_print(to, "static const char *const %s_i_shader_%s[] = {", prefix, it->identifier);
    for (size_t at = 0, end; at < it->source.length; at = end) {
        end = logical_line_end(&it->source, at);
        if (it->chunk_count == 0 || chunk_bytes + (end - at) > CHUNK_LIMIT) {
            char directive[32];
            chunk_bytes = (size_t)snprintf(directive, sizeof directive, "#line %zu\n", line);
            text_print(to, "%s\n", it->chunk_count ? "," : "");
            append_quoted(to, directive, chunk_bytes - 1);
            it->chunk_count++;
        }
        chunk_bytes += end - at;
        for (size_t stop; at < end; at = stop, line++) {
            stop = line_end(&it->source, at);
            text_append(to, "\n", 1);
            append_quoted(to, it->source.data + at, stop - at - 1);
        }
    }
    text_print(to, ",\n    0};\n");
}

/* The last row of zeros keeps the table legal C when there are no shaders. */
static void append_table(text *to, const shader *all, size_t count) {
    text_print(to, "static const shaders_i_entry shaders_i_table[] = {\n");
    for (size_t i = 0; i < count; i++)
        text_print(to, "    {\"%s\", shaders_i_shader_%s, %zu},\n", all[i].name, all[i].identifier, all[i].chunk_count);
    text_print(to, "    {0, 0, 0}};\n");
}

static void append_block(text *to, size_t which, const char *prefix, shader *all, size_t count) {
    size_t used = 0;
    for (size_t i = 0; i < count; i++)
        used += all[i].wanted[which];
    if (used == 0 && which != ALL_HEADER)
        return;
    text_print(to, "/* clang-format off */\n");
    for (size_t i = 0; i < count; i++)
        if (all[i].wanted[which])
            append_shader(to, &all[i], prefix);
    if (which == ALL_HEADER)
        append_table(to, all, count);
    text_print(to, "/* clang-format on */\n");
}

/* The only occurrence of the marker as a line of its own, or SIZE_MAX. */
static size_t find_marker(const header *it, const char *marker) {
    size_t found = SIZE_MAX;
    const char *start = it->old_text.data;
    for (const char *at = start; (at = strstr(at, marker)) != NULL; at += strlen(marker)) {
        if (at != start && at[-1] != '\n')
            continue;
        if (found != SIZE_MAX)
            fail("%s: this marker line stands there twice: %s", it->name, marker);
        found = (size_t)(at - start);
    }
    return found;
}

static void make_header(header *headers, size_t which, const char *top, shader *all, size_t count) {
    header *it = &headers[which];
    char path[4096];
    bool named = which == ALL_HEADER;
    for (size_t i = 0; i < count; i++)
        named = named || all[i].wanted[which];
    join_path(path, top, "", it->name);
    it->present = read_file(path, &it->old_text);
    if (!it->present && named)
        fail("%s: there is no such file although shaders are embedded in it", path);
    if (!it->present)
        return;
    size_t begin = find_marker(it, BLOCK_BEGIN), end = find_marker(it, BLOCK_END);
    it->present = begin != SIZE_MAX && end != SIZE_MAX && begin < end;
    if (!it->present && (named || begin != end))
        fail("%s: needs the two marker lines, in this order:\n" BLOCK_BEGIN BLOCK_END, path);
    if (!it->present)
        return;
    text_append(&it->new_text, it->old_text.data, begin + strlen(BLOCK_BEGIN));
    append_block(&it->new_text, which, it->prefix, all, count);
    text_append(&it->new_text, it->old_text.data + end, it->old_text.length - end);
}

static bool is_stale(const header *it) {
    return it->present && (it->old_text.length != it->new_text.length ||
                           memcmp(it->old_text.data, it->new_text.data, it->old_text.length) != 0);
}

static int finish_header(const header *it, const char *top, bool check) {
    char path[4096];
    if (!is_stale(it))
        return 0;
    if (check) {
        fprintf(stderr, "embed_shaders: %s is stale: run `make shaders`\n", it->name);
        return 1;
    }
    join_path(path, top, "", it->name);
    write_file(path, &it->new_text);
    printf("wrote %s\n", it->name);
    return 0;
}

static int usage(void) {
    fputs("usage: embed_shaders [TOP] [--check]\n", stderr);
    return 2;
}

int main(int argument_count, char **arguments) {
    header headers[HEADER_COUNT] = {{.name = "transparency.h", .prefix = "tr"},
                                    {.name = "oit_buffers.h", .prefix = "oit"},
                                    {.name = "shaders_embedded.h", .prefix = "shaders"}};
    const char *top = NULL;
    bool check = false;
    int result = 0;
    size_t count;
    for (int i = 1; i < argument_count; i++) {
        if (strcmp(arguments[i], "--check") == 0)
            check = true;
        else if (arguments[i][0] == '-' || top)
            return usage();
        else
            top = arguments[i];
    }
    if (!top)
        top = ".";
    shader *all = read_shaders(top, headers, &count);
    for (size_t i = 0; i < HEADER_COUNT; i++)
        make_header(headers, i, top, all, count);
    for (size_t i = 0; i < HEADER_COUNT; i++)
        result |= finish_header(&headers[i], top, check);
    for (size_t i = 0; i < count; i++)
        free(all[i].source.data);
    for (size_t i = 0; i < HEADER_COUNT; i++) {
        free(headers[i].old_text.data);
        free(headers[i].new_text.data);
    }
    free(all);
    return result;
}
