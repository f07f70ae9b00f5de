#define _XOPEN_SOURCE 700

#include "load_model.h"

#include <assimp/cimport.h>
#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* The implementation is not held to our warnings. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wundef"
#endif
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

/* Sharper than this, an edge keeps two normals where the file has none. */

/* Larger files are refused: what they would need is beyond an illustration. */
static const long long LARGEST_FILE = 4LL << 30;

static bool fail(char *message, size_t size, const char *what) {
    snprintf(message, size, "%s", what);
    return false;
}

static const char *extension_of(const char *path) {
    const char *slash = strrchr(path, '/'), *dot = strrchr(path, '.');
    return dot && (!slash || dot > slash) ? dot + 1 : "";
}

static bool has_extension(const char *path, const char *extension) {
    return strcasecmp(extension_of(path), extension) == 0;
}

/* ---- checks before assimp sees the file ------------------------------------------------------------------ */

/* What a header claims against what is there: readers that believe the header allocate all of it. */

static uint32_t little32(const unsigned char *bytes) {
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static bool check_glb(const unsigned char *head, size_t count, long long size, char *message, size_t message_size) {
    if (count < 12 || memcmp(head, "glTF", 4) != 0)
        return fail(message, message_size, "is not a GLB file: it does not begin with glTF");
    long long claimed = little32(head + 8);
    if (claimed > size)
        snprintf(message, message_size, "is cut short: its GLB header says %lld bytes, the file has %lld", claimed,
                 size);
    return claimed <= size;
}

static bool is_ascii_stl(const unsigned char *head, size_t count) {
    char text[1025];
    size_t length = count < 1024 ? count : 1024;
    memcpy(text, head, length);
    text[length] = '\0';
    return strncasecmp(text, "solid", 5) == 0 && (strstr(text, "facet") || strstr(text, "endsolid"));
}

/* The end of a text file, to see whether it has one. */
static bool ends_with_word(FILE *file, long long size, const char *word) {
    char tail[513];
    if (fseek(file, (long)(size > 512 ? size - 512 : 0), SEEK_SET) != 0)
        return false;
    size_t length = fread(tail, 1, sizeof tail - 1, file);
    for (size_t i = 0; i < length; i++)
        tail[i] = tail[i] ? (char)tolower((unsigned char)tail[i]) : ' ';
    tail[length] = '\0';
    return strstr(tail, word) != NULL;
}

static bool check_stl(FILE *file, const unsigned char *head, size_t count, long long size, char *message,
                      size_t message_size) {
    if (is_ascii_stl(head, count))
        return ends_with_word(file, size, "endsolid") ||
               fail(message, message_size, "is cut short: an STL file in text ends with endsolid");
    if (count < 84)
        return fail(message, message_size, "is not an STL file: neither text nor long enough for the binary header");
    long long claimed = 84 + 50 * (long long)little32(head + 80);
    if (claimed > size)
        snprintf(message, message_size,
                 "is cut short or no STL file: its header says %lu triangles, %lld bytes; it has %lld",
                 (unsigned long)little32(head + 80), claimed, size);
    return claimed <= size;
}

/* The least that a PLY property takes up. */
static long long ply_bytes(const char *type, bool text) {
    static const struct {
        const char *name;
        long long bytes;
    } types[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
                 {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
                 {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
    if (text)
        return 2; /* a digit and a blank or line end */
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++)
        if (strcmp(type, types[i].name) == 0)
            return types[i].bytes;
    return 1; /* "list" and whatever assimp may make of the unknown */
}

/* What a PLY header claims. Counts are doubles, as one may be beyond any integer. */
typedef struct ply_header {
    bool text, ended;
    double elements, last_elements, bytes;
    size_t length; /* of the header itself */
} ply_header;

static void read_ply_line(ply_header *h, const char *line) {
    char word[64], second[64], name[64];
    double number = 0;
    if (sscanf(line, " format %63s", word) == 1) {
        h->text = strcmp(word, "ascii") == 0;
    } else if (sscanf(line, " element %63s %lf", word, &number) == 2) {
        h->last_elements = number;
        h->elements += number;
    } else if (sscanf(line, " property list %63s %63s %63s", word, second, name) == 3) {
        bool corners = strncmp(name, "vertex_ind", 10) == 0; /* no face has less than three */
        h->bytes +=
            h->last_elements * (double)(ply_bytes(word, h->text) + (corners ? 3 : 0) * ply_bytes(second, h->text));
    } else if (sscanf(line, " property %63s %63s", word, name) == 2) {
        h->bytes += h->last_elements * (double)ply_bytes(word, h->text);
    }
    h->ended = strncmp(line, "end_header", 10) == 0;
}

static void read_ply_header(ply_header *h, const unsigned char *head, size_t count) {
    memset(h, 0, sizeof *h);
    for (size_t at = 0, end; at < count && !h->ended; at = end + 1) {
        char line[256];
        for (end = at; end < count && head[end] != '\n' && head[end] != '\r';)
            end++;
        snprintf(line, sizeof line, "%.*s", (int)(end - at < 255 ? end - at : 255), (const char *)head + at);
        read_ply_line(h, line);
        h->length = end + 1;
    }
}

/* Lines of text that are not blank, up to `enough`. */
static double count_lines(FILE *file, size_t start, double enough) {
    double lines = 0;
    bool blank = true;
    if (fseek(file, (long)start, SEEK_SET) != 0)
        return 0;
    for (int c = getc(file); lines < enough; c = getc(file)) {
        if ((c == '\n' || c == '\r' || c == EOF) && !blank)
            lines++;
        if (c == EOF)
            break;
        blank = c == '\n' || c == '\r' || (blank && isspace(c));
    }
    return lines;
}

static bool check_ply(FILE *file, const unsigned char *head, size_t count, long long size, char *message,
                      size_t message_size) {
    ply_header h;
    if (count < 4 || memcmp(head, "ply", 3) != 0)
        return fail(message, message_size, "is not a PLY file: it does not begin with ply");
    read_ply_header(&h, head, count);
    if (!h.ended)
        return fail(message, message_size, "is cut short: its PLY header has no end");
    double there = (double)size - (double)h.length + 1; /* the last number of a text may lack its line end */
    if (!(h.bytes <= there))
        snprintf(message, message_size, "is cut short: its PLY header says at least %.0f bytes, the file has %.0f",
                 h.bytes, fmax(there - 1, 0));
    else if (h.text && count_lines(file, h.length, h.elements) < h.elements)
        snprintf(message, message_size, "is cut short: its PLY header says %.0f lines, the file has fewer", h.elements);
    else
        return true;
    return false;
}

static bool is_exchange_file(const char *path, const unsigned char *head, size_t count) {
    static const char *const extensions[] = {"step", "stp", "stpz", "p21", "iges", "igs"};
    for (size_t i = 0; i < sizeof extensions / sizeof extensions[0]; i++)
        if (has_extension(path, extensions[i]))
            return true;
    if (count >= 12 && memcmp(head, "ISO-10303-21", 12) == 0)
        return !has_extension(path, "ifc"); /* buildings are written in the same way, and assimp reads those */
    /* IGES: lines of 80 columns, the first with S and a number at its end. */
    return count >= 81 && head[72] == 'S' && head[79] == '1' && (head[80] == '\n' || head[80] == '\r');
}

static bool check_content(FILE *file, const char *path, long long size, char *message, size_t message_size) {
    static unsigned char head[65536];
    size_t count = fread(head, 1, sizeof head, file);
    if (ferror(file))
        return fail(message, message_size, strerror(errno));
    if (is_exchange_file(path, head, count))
        return fail(message, message_size, "is a STEP or IGES file of exact surfaces: tessellate to glTF first");
    if (has_extension(path, "glb"))
        return check_glb(head, count, size, message, message_size);
    if (has_extension(path, "stl"))
        return check_stl(file, head, count, size, message, message_size);
    if (has_extension(path, "ply"))
        return check_ply(file, head, count, size, message, message_size);
    if (!aiIsExtensionSupported(strrchr(path, '.') ? strrchr(path, '.') : ""))
        return fail(message, message_size,
                    "is of no known kind (known are glTF, GLB, OBJ, STL, PLY, 3DS, FBX, DAE and more)");
    return true;
}

static bool check_file(const char *path, long long *size, char *message, size_t message_size) {
    struct stat there;
    if (stat(path, &there) != 0)
        return fail(message, message_size, strerror(errno));
    if (!S_ISREG(there.st_mode))
        return fail(message, message_size,
                    S_ISDIR(there.st_mode) ? "is a folder, not a file" : "is not a regular file");
    *size = (long long)there.st_size;
    if (*size > LARGEST_FILE)
        return fail(message, message_size, "is larger than 4 GiB, which is the limit");
    FILE *file = fopen(path, "rb");
    if (!file)
        return fail(message, message_size, strerror(errno));
    bool ok =
        *size > 0 ? check_content(file, path, *size, message, message_size) : fail(message, message_size, "is empty");
    fclose(file);
    return ok;
}

/* ---- materials ------------------------------------------------------------------------------------------- */

typedef struct surface {
    float color[3], opacity;
    bool plain; /* nobody chose the colour */
    bool two_sided, alpha_blended;
    unsigned uv_channel;
    char texture[1024]; /* "" where there is none */
} surface;

typedef struct image {
    char name[1024];
    unsigned char *rgba;
    int width, height;
} image;

typedef struct import {
    const struct aiScene *file;
    const char *path;
    bool is_gltf; /* its colours are linear light */
    scene *out;
    size_t *mesh_index; /* per aiMesh, SIZE_MAX where not converted yet */
    surface *surfaces;  /* per aiMesh, of converted ones */
    image cached;       /* the last texture read: meshes tend to share one */
    load_report report;
    bool out_of_memory;
} import;

static float to_display(float linear) {
    if (!(linear > 0))
        return 0;
    if (linear >= 1)
        return 1;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1 / 2.4f) - 0.055f;
}

static float clamp01(float value) {
    return value > 0 ? (value < 1 ? value : 1) : 0;
}

static void display_color(const import *in, const struct aiColor4D *color, float out[3]) {
    const float channels[3] = {color->r, color->g, color->b};
    for (size_t i = 0; i < 3; i++)
        out[i] = in->is_gltf ? to_display(channels[i]) : clamp01(channels[i]);
}

static bool chosen_by_nobody(const struct aiMaterial *material, const struct aiColor4D *color) {
    struct aiString name;
    if (aiGetMaterialString(material, AI_MATKEY_NAME, &name) == AI_SUCCESS && name.length > 0 &&
        strcmp(name.data, AI_DEFAULT_MATERIAL_NAME) != 0)
        return false;
    return color->r == color->g && color->g == color->b;
}

static void read_texture_name(const struct aiMaterial *material, surface *s) {
    static const enum aiTextureType types[2] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
    for (size_t i = 0; i < 2; i++) {
        struct aiString path;
        if (aiGetMaterialTexture(material, types[i], 0, &path, NULL, &s->uv_channel, NULL, NULL, NULL, NULL) !=
            AI_SUCCESS)
            continue;
        snprintf(s->texture, sizeof s->texture, "%s", path.data);
        return;
    }
}

static void read_surface(const import *in, unsigned index, surface *s) {
    memset(s, 0, sizeof *s);
    struct aiColor4D color = {1, 1, 1, 1};
    s->opacity = 1;
    s->plain = true;
    if (index < in->file->mNumMaterials) {
        const struct aiMaterial *material = in->file->mMaterials[index];
        if (aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &color) != AI_SUCCESS)
            aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &color);
        ai_real opacity = 1;
        int two_sided = 0;
        struct aiString mode;
        aiGetMaterialFloatArray(material, AI_MATKEY_OPACITY, &opacity, NULL);
        aiGetMaterialIntegerArray(material, AI_MATKEY_TWOSIDED, &two_sided, NULL);
        bool has_mode = aiGetMaterialString(material, AI_MATKEY_GLTF_ALPHAMODE, &mode) == AI_SUCCESS;
        s->alpha_blended = has_mode && strcmp(mode.data, "BLEND") == 0;
        if (!has_mode || s->alpha_blended) /* glTF's opaque materials may have an alpha that means nothing */
            s->opacity = clamp01(opacity);
        s->two_sided = two_sided != 0;
        s->plain = chosen_by_nobody(material, &color);
        read_texture_name(material, s);
    }
    display_color(in, &color, s->color);
}

/* ---- textures -------------------------------------------------------------------------------------------- */

static bool decode(image *out, const unsigned char *bytes, size_t count) {
    int width, height, channels;
    if (count > INT32_MAX || !stbi_info_from_memory(bytes, (int)count, &width, &height, &channels))
        return false;
    if ((long long)width * height > 1 << 26)
        return false;
    out->rgba = stbi_load_from_memory(bytes, (int)count, &out->width, &out->height, &channels, 4);
    return out->rgba != NULL;
}

/* An embedded texture is a compressed file, or rows of pixels where its height is not 0. */
static bool decode_embedded(image *out, const struct aiTexture *texture) {
    if (texture->mHeight == 0)
        return decode(out, (const unsigned char *)texture->pcData, texture->mWidth);
    size_t pixels = (size_t)texture->mWidth * texture->mHeight;
    if (pixels == 0 || pixels > 1 << 26 || !(out->rgba = malloc(4 * pixels)))
        return false;
    for (size_t i = 0; i < pixels; i++) {
        struct aiTexel t = texture->pcData[i];
        const unsigned char rgba[4] = {t.r, t.g, t.b, t.a};
        memcpy(&out->rgba[4 * i], rgba, 4);
    }
    out->width = (int)texture->mWidth;
    out->height = (int)texture->mHeight;
    return true;
}

static bool decode_file(image *out, const char *path) {
    struct stat there;
    if (stat(path, &there) != 0 || !S_ISREG(there.st_mode) || there.st_size < 1 || there.st_size > 1 << 29)
        return false;
    size_t size = (size_t)there.st_size;
    unsigned char *bytes = malloc(size);
    FILE *file = bytes ? fopen(path, "rb") : NULL;
    bool ok = file && fread(bytes, 1, size, file) == size && decode(out, bytes, size);
    if (file)
        fclose(file);
    free(bytes);
    return ok;
}

static int hex_digit(char c) {
    return isdigit((unsigned char)c) ? c - '0' : isxdigit((unsigned char)c) ? tolower((unsigned char)c) - 'a' + 10 : -1;
}

/* Names in files may have backslashes or, in glTF, %20 for a blank. */
static void plain_path(char *path) {
    char *out = path;
    for (const char *in = path; *in; in++) {
        int high = in[0] == '%' ? hex_digit(in[1]) : -1, low = high >= 0 ? hex_digit(in[2]) : -1;
        if (low >= 0 && high + low > 0) {
            *out++ = (char)(16 * high + low);
            in += 2;
        } else {
            *out++ = *in == '\\' ? '/' : *in;
        }
    }
    *out = '\0';
}

/* Beside the model: by its path from there, or else by its bare name, as many files keep their author's folders. */
static bool decode_beside(image *out, const char *model, const char *name) {
    char relative[1024], full[4096];
    const char *slash = strrchr(model, '/');
    int folder = slash ? (int)(slash - model) + 1 : 0;
    snprintf(relative, sizeof relative, "%s", name);
    snprintf(full, sizeof full, "%.*s%s", folder, model, relative);
    if (relative[0] != '/' && decode_file(out, full))
        return true;
    plain_path(relative);
    snprintf(full, sizeof full, "%.*s%s", folder, model, relative);
    if (relative[0] != '/' && decode_file(out, full))
        return true;
    const char *bare = strrchr(relative, '/');
    snprintf(full, sizeof full, "%.*s%s", folder, model, bare ? bare + 1 : relative);
    return bare && decode_file(out, full);
}

/* Embedded ones are called "*" and their number, or by the name of the file they came from. */
static const struct aiTexture *find_embedded(const struct aiScene *file, const char *name) {
    unsigned long number = name[0] == '*' ? strtoul(name + 1, NULL, 10) : ULONG_MAX;
    if (number < file->mNumTextures)
        return file->mTextures[number];
    for (unsigned i = 0; i < file->mNumTextures; i++)
        if (name[0] && strcmp(file->mTextures[i]->mFilename.data, name) == 0)
            return file->mTextures[i];
    return NULL;
}

/* The texture's pixels, NULL where they cannot be had. */
static const image *find_texture(import *in, const char *name) {
    if (strcmp(in->cached.name, name) == 0)
        return in->cached.rgba ? &in->cached : NULL;
    free(in->cached.rgba);
    memset(&in->cached, 0, sizeof in->cached);
    snprintf(in->cached.name, sizeof in->cached.name, "%s", name);
    const struct aiTexture *embedded = find_embedded(in->file, name);
    bool found = embedded ? decode_embedded(&in->cached, embedded) : decode_beside(&in->cached, in->path, name);
    in->report.textures_missed += !found;
    return found ? &in->cached : NULL;
}

static size_t wrap(double coordinate, int size) {
    double within = coordinate - floor(coordinate); /* textures repeat */
    size_t at = isfinite(within) ? (size_t)(within * size) : 0;
    return at < (size_t)size ? at : (size_t)size - 1;
}

/* Adds the colour at a place in the texture, by its alpha; v is counted from the lower edge. */
static void add_texel(const image *texture, const double uv[2], double weight, double sum[5]) {
    size_t x = wrap(uv[0], texture->width), y = wrap(1 - uv[1], texture->height);
    const unsigned char *texel = &texture->rgba[4 * (y * (size_t)texture->width + x)];
    double visible = weight * (texel[3] + 1) / 256.0; /* never nothing: a see-through texture has a colour too */
    for (size_t i = 0; i < 3; i++)
        sum[i] += visible * texel[i] / 255.0;
    sum[3] += visible;
    sum[4] += weight * texel[3] / 255.0;
}

/* A vertex gets the mean over the part of each of its triangles that is nearest to it. Sampling there and not at the
 * vertex itself keeps palettes exact, whose cells end where the triangles do, and evens out photographs. */
static void sample_triangle(const image *texture, const struct aiVector3D *uvs, const uint32_t corner[3],
                            double *sums) {
    enum { STEPS = 4 };
    for (size_t c = 0; c < 3; c++) {
        const struct aiVector3D *own = &uvs[corner[c]], *next = &uvs[corner[(c + 1) % 3]],
                                *last = &uvs[corner[(c + 2) % 3]];
        for (int i = 0; i < STEPS; i++)
            for (int j = 0; i + j < STEPS; j++) {
                double a = (i + 0.33) / (2.0 * STEPS), b = (j + 0.33) / (2.0 * STEPS), rest = 1 - a - b;
                double uv[2] = {rest * (double)own->x + a * (double)next->x + b * (double)last->x,
                                rest * (double)own->y + a * (double)next->y + b * (double)last->y};
                add_texel(texture, uv, 1, &sums[5 * (size_t)corner[c]]);
            }
    }
}

/* ---- one mesh -------------------------------------------------------------------------------------------- */

static bool finite3(const struct aiVector3D *v) {
    return isfinite(v->x) && isfinite(v->y) && isfinite(v->z);
}

/* The triangles that can be drawn. */
static bool take_faces(import *in, const struct aiMesh *mesh, scene_mesh *out) {
    out->indices = malloc(((size_t)mesh->mNumFaces * 3 + 1) * sizeof *out->indices);
    if (!out->indices)
        return false;
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        bool ok = face->mNumIndices == 3, finite = true;
        for (unsigned i = 0; ok && i < 3; i++) {
            ok = face->mIndices[i] < mesh->mNumVertices;
            finite = ok && finite && finite3(&mesh->mVertices[face->mIndices[i]]);
        }
        in->report.others_dropped += !ok;
        in->report.faces_dropped += ok && !finite;
        for (unsigned i = 0; ok && finite && i < 3; i++)
            out->indices[out->index_count++] = face->mIndices[i];
    }
    return true;
}

/* Drops vertices that no triangle uses: their normals and colours need no care then, and NaN is gone for good. */
static bool take_vertices(const struct aiMesh *mesh, scene_mesh *out, uint32_t *old_of_new) {
    size_t count = mesh->mNumVertices;
    uint32_t *new_of_old = malloc((count + 1) * sizeof *new_of_old);
    if (!new_of_old)
        return false;
    memset(new_of_old, 0xff, count * sizeof *new_of_old);
    for (size_t i = 0; i < out->index_count; i++) {
        uint32_t *number = &new_of_old[out->indices[i]];
        if (*number == UINT32_MAX) {
            old_of_new[out->vertex_count] = out->indices[i];
            *number = (uint32_t)out->vertex_count++;
        }
        out->indices[i] = *number;
    }
    free(new_of_old);
    out->positions = malloc((out->vertex_count + 1) * 3 * sizeof *out->positions);
    for (size_t i = 0; out->positions && i < out->vertex_count; i++)
        memcpy(&out->positions[3 * i], &mesh->mVertices[old_of_new[i]], 3 * sizeof *out->positions);
    return out->positions != NULL;
}

static void face_direction(const scene_mesh *mesh, const uint32_t *corner, double normal[3]) {
    const float *p = &mesh->positions[3 * (size_t)corner[0]], *q = &mesh->positions[3 * (size_t)corner[1]],
                *r = &mesh->positions[3 * (size_t)corner[2]];
    double u[3], v[3];
    for (size_t i = 0; i < 3; i++) {
        u[i] = (double)q[i] - (double)p[i];
        v[i] = (double)r[i] - (double)p[i];
    }
    for (size_t i = 0; i < 3; i++)
        normal[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
}

static bool set_unit(float out[3], const double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0) || !isfinite(length))
        return false;
    for (size_t i = 0; i < 3; i++)
        out[i] = (float)(v[i] / length);
    return true;
}

/* The file's normals at length one; where one is no direction, that of a triangle there. */
static bool take_normals(const struct aiMesh *mesh, scene_mesh *out, const uint32_t *old_of_new) {
    out->normals = calloc((out->vertex_count + 1) * 3, sizeof *out->normals);
    if (!out->normals)
        return false;
    for (size_t i = 0; i < out->vertex_count; i++) {
        const struct aiVector3D *n = &mesh->mNormals[old_of_new[i]];
        const double normal[3] = {(double)n->x, (double)n->y, (double)n->z};
        set_unit(&out->normals[3 * i], normal);
    }
    for (size_t i = 0; i < out->index_count; i++) {
        float *normal = &out->normals[3 * (size_t)out->indices[i]];
        double direction[3];
        if (normal[0] != 0 || normal[1] != 0 || normal[2] != 0)
            continue;
        face_direction(out, &out->indices[i / 3 * 3], direction);
        if (!set_unit(normal, direction))
            normal[2] = 1;
    }
    return true;
}

/* Texture, vertex colours and factor multiplied, as glTF has it. NULL where the mesh has one colour. */
static bool take_colors(import *in, const struct aiMesh *mesh, surface *s, scene_mesh *out,
                        const uint32_t *old_of_new) {
    const struct aiVector3D *uvs =
        s->uv_channel < AI_MAX_NUMBER_OF_TEXTURECOORDS ? mesh->mTextureCoords[s->uv_channel] : NULL;
    const image *texture = s->texture[0] && uvs ? find_texture(in, s->texture) : NULL;
    if (!texture && !mesh->mColors[0])
        return true;
    double *sums = calloc(5 * ((size_t)mesh->mNumVertices + 1), sizeof *sums), alpha = 0, alpha_weight = 0;
    out->colors = malloc((out->vertex_count + 1) * 3 * sizeof *out->colors);
    for (size_t i = 0; texture && sums && i + 2 < out->index_count; i += 3) {
        const uint32_t corner[3] = {old_of_new[out->indices[i]], old_of_new[out->indices[i + 1]],
                                    old_of_new[out->indices[i + 2]]};
        sample_triangle(texture, uvs, corner, sums);
    }
    for (size_t i = 0; sums && out->colors && i < out->vertex_count; i++) {
        const double *sum = &sums[5 * (size_t)old_of_new[i]];
        float *color = &out->colors[3 * i];
        color[0] = color[1] = color[2] = 1;
        if (mesh->mColors[0])
            display_color(in, &mesh->mColors[0][old_of_new[i]], color);
        for (size_t k = 0; k < 3; k++)
            color[k] *=
                (texture && sum[3] > 0 ? (float)(sum[k] / sum[3]) : 1) * (s->plain && !texture ? 1 : s->color[k]);
        alpha += sum[4];
        alpha_weight += texture ? 10 * (sum[3] > 0) : 0;
    }
    if (texture && s->alpha_blended && alpha_weight > 0) /* roughly: a vertex with more triangles counts more */
        s->opacity *= clamp01((float)(alpha / alpha_weight));
    s->plain = false;
    free(sums);
    return sums && out->colors;
}

static void average_color(const scene_mesh *mesh, float color[3]) {
    double sum[3] = {0}, weight = 0;
    for (size_t i = 0; i + 2 < mesh->index_count; i += 3) {
        double n[3];
        face_direction(mesh, &mesh->indices[i], n);
        double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + 1e-30;
        for (size_t c = 0; c < 3; c++)
            for (size_t k = 0; k < 3; k++)
                sum[k] += area * (double)mesh->colors[3 * (size_t)mesh->indices[i + c] + k] / 3;
        weight += area;
    }
    for (size_t k = 0; k < 3; k++)
        color[k] = weight > 0 ? clamp01((float)(sum[k] / weight)) : 1;
}

/* ---- skins ----------------------------------------------------------------------------------------------- */

static void to_doubles(const struct aiMatrix4x4 *from, double to[16]) {
    const ai_real *rows = &from->a1;
    for (size_t row = 0; row < 4; row++)
        for (size_t column = 0; column < 4; column++)
            to[4 * column + row] = (double)rows[4 * row + column];
}

static void world_of_node(const struct aiNode *node, double world[16]) {
    to_doubles(&node->mTransformation, world);
    for (node = node->mParent; node; node = node->mParent) {
        double above[16];
        to_doubles(&node->mTransformation, above);
        scene_multiply(above, world, world);
    }
}

/* assimp knows a bone by its node's name only, and files give a mesh the name of its bone: a node without meshes is the
 * better guess. */
static const struct aiNode *find_bone(const struct aiNode *node, const char *name) {
    const struct aiNode *best = strcmp(node->mName.data, name) == 0 ? node : NULL;
    for (unsigned i = 0; i < node->mNumChildren && !(best && best->mNumMeshes == 0); i++) {
        const struct aiNode *found = find_bone(node->mChildren[i], name);
        if (found && (!best || found->mNumMeshes == 0))
            best = found;
    }
    return best;
}

/* Adds weight * matrix * (v, w) */
static void add_transformed(const double m[16], const struct aiVector3D *v, double w, double weight, double sum[3]) {
    for (size_t row = 0; row < 3; row++)
        sum[row] +=
            weight * (m[row] * (double)v->x + m[4 + row] * (double)v->y + m[8 + row] * (double)v->z + m[12 + row] * w);
}

/* A skinned mesh stands where its bones are at rest; the transform of its own node does not count. The mesh itself is
 * changed, in place. */
static bool pose_mesh(const import *in, struct aiMesh *mesh) {
    size_t count = mesh->mNumVertices;
    double *sums = calloc(7 * (count + 1), sizeof *sums);
    if (!sums)
        return false;
    for (unsigned b = 0; b < mesh->mNumBones; b++) {
        const struct aiBone *bone = mesh->mBones[b];
        const struct aiNode *node = find_bone(in->file->mRootNode, bone->mName.data);
        double world[16], offset[16];
        if (!node)
            continue;
        world_of_node(node, world);
        to_doubles(&bone->mOffsetMatrix, offset);
        scene_multiply(world, offset, world);
        for (unsigned i = 0; i < bone->mNumWeights; i++) {
            unsigned v = bone->mWeights[i].mVertexId;
            double weight = (double)bone->mWeights[i].mWeight;
            if (v >= count || !(weight > 0))
                continue;
            add_transformed(world, &mesh->mVertices[v], 1, weight, &sums[7 * (size_t)v]);
            if (mesh->mNormals)
                add_transformed(world, &mesh->mNormals[v], 0, weight, &sums[7 * (size_t)v + 3]);
            sums[7 * (size_t)v + 6] += weight;
        }
    }
    for (size_t v = 0; v < count; v++) {
        const double *s = &sums[7 * v];
        if (s[6] > 0) {
            mesh->mVertices[v] =
                (struct aiVector3D){(ai_real)(s[0] / s[6]), (ai_real)(s[1] / s[6]), (ai_real)(s[2] / s[6])};
            if (mesh->mNormals)
                mesh->mNormals[v] = (struct aiVector3D){(ai_real)s[3], (ai_real)s[4], (ai_real)s[5]};
        }
    }
    free(sums);
    return true;
}

/* ---- the whole ------------------------------------------------------------------------------------------- */

static void free_arrays(scene_mesh *mesh) {
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->colors);
    free(mesh->indices);
    *mesh = (scene_mesh){0};
}

static bool fill_mesh(import *in, struct aiMesh *mesh, surface *s, scene_mesh *out) {
    uint32_t *old_of_new = malloc(((size_t)mesh->mNumVertices + 1) * sizeof *old_of_new);
    bool facets = has_extension(in->path, "stl"); /* its normals belong to triangles, not to vertices */
    bool own_normals = mesh->mNormals && !facets;
    bool ok = old_of_new && take_faces(in, mesh, out) && take_vertices(mesh, out, old_of_new) &&
              (!own_normals || take_normals(mesh, out, old_of_new)) && take_colors(in, mesh, s, out, old_of_new);
    free(old_of_new);
    if (ok && out->colors)
        average_color(out, s->color);
    if (ok)
        ok = own_normals ? scene_mesh_share_vertices(out) : scene_mesh_make_normals(out, SCENE_CREASE_DEGREES);
    return ok;
}

/* Converts a mesh at its first use. False where it has nothing to draw. */
static bool convert_mesh(import *in, unsigned index) {
    if (in->mesh_index[index] != SIZE_MAX)
        return in->out->meshes[in->mesh_index[index]].index_count > 0;
    struct aiMesh *mesh = in->file->mMeshes[index];
    surface *s = &in->surfaces[index];
    scene_mesh arrays = {0};
    read_surface(in, mesh->mMaterialIndex, s);
    bool ok = (!mesh->mNumBones || pose_mesh(in, mesh)) && fill_mesh(in, mesh, s, &arrays);
    arrays.two_sided =
        s->two_sided && !has_extension(in->path, "ply"); /* assimp says so of every PLY, the files do not */
    if (!ok)
        free_arrays(&arrays);
    in->mesh_index[index] = ok ? scene_add_mesh(in->out, mesh->mName.data, &arrays) : SIZE_MAX;
    in->out_of_memory |= in->mesh_index[index] == SIZE_MAX;
    return !in->out_of_memory && in->out->meshes[in->mesh_index[index]].index_count > 0;
}

/* Names become one component of a path, fit for a list between commas and for a line of text. */
static void append_component(char *path, size_t size, const char *name) {
    size_t length = strlen(path);
    if (!name[0])
        return;
    if (length > 0 && length + 1 < size)
        path[length++] = '/';
    for (; *name && length + 1 < size; name++)
        path[length++] = *name == '/' || *name == ',' || (unsigned char)*name < ' ' || *name == 127 ? '_' : *name;
    path[length] = '\0';
}

static void file_stem(const char *path, char *stem, size_t size) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    snprintf(stem, size, "%.*s", dot && dot > name ? (int)(dot - name) : (int)strlen(name), name);
}

/* <STL_BINARY> and nodes[3] are names that the importer made up. The root stands for the file and says nothing, except
 * in glTF, where it may be the file's only node. */
static bool has_own_name(const import *in, const struct aiNode *node) {
    const char *name = node->mName.data;
    bool counts = node->mParent || (in->is_gltf && node->mNumMeshes > 0);
    return counts && name[0] && name[0] != '<' && strncmp(name, "nodes[", 6) != 0;
}

/* What tells the meshes of one node apart: their own names or those of their materials. A lone mesh lends its name to a
 * node without one, a lone nameless mesh has its file's. */
static void append_mesh_name(const import *in, const struct aiNode *node, unsigned which, char *path, size_t size) {
    const struct aiMesh *mesh = in->file->mMeshes[node->mMeshes[which]];
    struct aiString name = {0};
    if (node->mNumMeshes > 1) {
        bool same = false; /* importers name the pieces of one mesh alike */
        for (unsigned i = 0; i < node->mNumMeshes; i++)
            same |= i != which && strcmp(in->file->mMeshes[node->mMeshes[i]]->mName.data, mesh->mName.data) == 0;
        if (!same && mesh->mName.length > 0)
            name = mesh->mName;
        else if (mesh->mMaterialIndex < in->file->mNumMaterials)
            aiGetMaterialString(in->file->mMaterials[mesh->mMaterialIndex], AI_MATKEY_NAME, &name);
        append_component(path, size, name.length > 0 ? name.data : "piece");
    } else if (!has_own_name(in, node)) {
        char stem[256];
        file_stem(in->path, stem, sizeof stem);
        append_component(path, size, mesh->mName.length > 0 && mesh->mName.data[0] != '<' ? mesh->mName.data : stem);
    }
}

static bool finite_matrix(const double m[16]) {
    for (size_t i = 0; i < 16; i++)
        if (!isfinite(m[i]))
            return false;
    return true;
}

static void add_node_parts(import *in, const struct aiNode *node, const double world[16], const char *path) {
    for (unsigned i = 0; i < node->mNumMeshes && !in->out_of_memory; i++) {
        unsigned index = node->mMeshes[i];
        char name[1024];
        if (index >= in->file->mNumMeshes || !convert_mesh(in, index))
            continue;
        if (!finite_matrix(world)) {
            in->report.parts_dropped++;
            continue;
        }
        snprintf(name, sizeof name, "%s", path);
        append_mesh_name(in, node, i, name, sizeof name);
        bool posed = in->file->mMeshes[index]->mNumBones > 0;
        size_t part = scene_add_part(in->out, name[0] ? name : "part", in->mesh_index[index], posed ? NULL : world,
                                     in->surfaces[index].color);
        in->out_of_memory |= part == SIZE_MAX;
        if (part != SIZE_MAX)
            in->out->parts[part].opacity = in->surfaces[index].opacity;
    }
}

static void add_node(import *in, const struct aiNode *node, const double above[16], const char *path) {
    double world[16];
    char own[1024];
    to_doubles(&node->mTransformation, world);
    scene_multiply(above, world, world);
    snprintf(own, sizeof own, "%s", path);
    if (has_own_name(in, node))
        append_component(own, sizeof own, node->mName.data);
    add_node_parts(in, node, world, own);
    for (unsigned i = 0; i < node->mNumChildren && !in->out_of_memory; i++)
        add_node(in, node->mChildren[i], world, own);
}

/* How long a name is without the number at its end and what stands before it: link0_11 and link0_12 are of one kind. */
static int stem_length(const char *name) {
    size_t length = strlen(name), digits = length;
    while (digits > 0 && isdigit((unsigned char)name[digits - 1]))
        digits--;
    if (digits < length && digits > 0 && strchr("_-.# ", name[digits - 1]))
        length = digits - 1;
    return (int)length;
}

/* A file that says no more than one grey for all says nothing. */
static bool all_the_same_grey(const scene *s) {
    for (size_t i = 0; i < s->part_count; i++) {
        const float *color = s->parts[i].color;
        if (s->meshes[s->parts[i].mesh].colors || color[0] != color[1] || color[1] != color[2] ||
            color[0] != s->parts[0].color[0])
            return false;
    }
    return true;
}

/* Parts that nobody gave a colour are told apart by ones that suit a printed page. */
static bool color_plain_parts(const import *in) {
    static const float colors[][3] = {{0.78f, 0.76f, 0.71f}, {0.52f, 0.63f, 0.70f}, {0.80f, 0.62f, 0.42f},
                                      {0.56f, 0.66f, 0.53f}, {0.72f, 0.50f, 0.45f}, {0.62f, 0.60f, 0.71f},
                                      {0.83f, 0.75f, 0.52f}, {0.45f, 0.58f, 0.58f}, {0.74f, 0.66f, 0.66f},
                                      {0.58f, 0.55f, 0.48f}};
    scene *s = in->out;
    bool *plain = calloc(s->mesh_count + 1, sizeof *plain), all = all_the_same_grey(s);
    for (size_t i = 0; plain && i < in->file->mNumMeshes; i++)
        if (in->mesh_index[i] != SIZE_MAX)
            plain[in->mesh_index[i]] = all || in->surfaces[i].plain;
    const char *last = NULL;
    size_t next = 0;
    for (size_t i = 0; plain && i < s->part_count; i++) {
        scene_part *part = &s->parts[i];
        if (!plain[part->mesh])
            continue;
        int length = stem_length(part->name);
        if (last && (length != stem_length(last) || strncmp(last, part->name, (size_t)length) != 0))
            next++;
        last = part->name;
        memcpy(part->color, colors[next % (sizeof colors / sizeof colors[0])], sizeof part->color);
    }
    free(plain);
    return plain != NULL;
}

/* By the format's convention; FBX says it itself. assimp turns 3DS, Blender and COLLADA files to y up as it reads. */
static int up_axis_of(const struct aiScene *file, const char *path) {
    static const char *const z_up[] = {"stl", "3mf", "amf", "off", "dxf"};
    for (unsigned i = 0; file->mMetaData && i < file->mMetaData->mNumProperties; i++)
        if (strcmp(file->mMetaData->mKeys[i].data, "UpAxis") == 0 && file->mMetaData->mValues[i].mType == AI_INT32)
            return *(const int *)file->mMetaData->mValues[i].mData == 2 ? 2 : 1;
    for (size_t i = 0; i < sizeof z_up / sizeof z_up[0]; i++)
        if (has_extension(path, z_up[i]))
            return 2;
    return 1;
}

static void explain_nothing(const import *in, char *message, size_t size) {
    if (in->out_of_memory)
        fail(message, size, "out of memory");
    else if (in->report.faces_dropped > 0)
        fail(message, size, "has no triangle without NaN or infinite coordinates");
    else if (in->report.others_dropped > 0)
        fail(message, size, "has no triangles, only points, lines or faces of vertices that are not there");
    else
        fail(message, size, "has no triangles");
}

static scene *convert(const struct aiScene *file, const char *path, load_report *report, char *message, size_t size) {
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
import in = {.file = file, .path = path };
    in.is_gltf = has_extension(path, "glb") || has_extension(path, "gltf");
    in.out = scene_create();
    in.mesh_index = malloc(((size_t)file->mNumMeshes + 1) * sizeof *in.mesh_index);
    in.surfaces = calloc((size_t)file->mNumMeshes + 1, sizeof *in.surfaces);
    in.out_of_memory = !in.out || !in.mesh_index || !in.surfaces;
    if (!in.out_of_memory) {
        memset(in.mesh_index, 0xff, file->mNumMeshes * sizeof *in.mesh_index);
        in.out->up_axis = up_axis_of(file, path);
        if (file->mRootNode)
            add_node(&in, file->mRootNode, identity, "");
        in.out_of_memory = in.out_of_memory || !color_plain_parts(&in);
    }
    free(in.mesh_index);
    free(in.surfaces);
    free(in.cached.rgba);
    *report = in.report;
    if (!in.out_of_memory && in.out->part_count > 0)
        return in.out;
    explain_nothing(&in, message, size);
    scene_destroy(in.out);
    return NULL;
}

static scene *import_file(const char *path, load_report *report, char *message, size_t size) {
    const struct aiScene *file = aiImportFile(path, aiProcess_Triangulate);
    if (!file) {
        const char *why = aiGetErrorString();
        if (strstr(why, "bad_alloc") || strstr(why, "length_error") || strstr(why, "cannot create std"))
            fail(message, size, "is damaged: reading it asks for far more memory than a file of its size needs");
        else
            snprintf(message, size, "cannot be read: %.200s", why[0] ? why : "no reason given");
        return NULL;
    }
    if (!file->mRootNode || file->mNumMeshes == 0) {
        fail(message, size, "has no triangles");
        return NULL;
    }
    return convert(file, path, report, message, size); /* the process ends soon, and the import with it */
}

/* ---- between the two processes --------------------------------------------------------------------------- */

typedef struct wire_header {
    char message[256]; /* "" for success */
    load_report report;
    size_t mesh_count, part_count;
    int up_axis;
} wire_header;

typedef struct wire_mesh {
    size_t name_length, vertex_count, index_count;
    bool colors, two_sided;
} wire_mesh;

typedef struct wire_part {
    size_t name_length, mesh;
    double transform[16];
    float color[3], opacity;
} wire_part;

static bool send_bytes(FILE *pipe_end, const void *bytes, size_t count) {
    return count == 0 || fwrite(bytes, 1, count, pipe_end) == count;
}

static bool send_mesh(FILE *to, const scene_mesh *mesh) {
    wire_mesh wire = {strlen(mesh->name), mesh->vertex_count, mesh->index_count, mesh->colors != NULL, mesh->two_sided};
    size_t floats = 3 * mesh->vertex_count * sizeof(float);
    return send_bytes(to, &wire, sizeof wire) && send_bytes(to, mesh->name, wire.name_length) &&
           send_bytes(to, mesh->positions, floats) && send_bytes(to, mesh->normals, floats) &&
           send_bytes(to, mesh->colors, mesh->colors ? floats : 0) &&
           send_bytes(to, mesh->indices, mesh->index_count * sizeof(uint32_t));
}

static bool send_part(FILE *to, const scene_part *part) {
    wire_part wire = {.name_length = strlen(part->name), .mesh = part->mesh, .opacity = part->opacity};
    memcpy(wire.transform, part->transform, sizeof wire.transform);
    memcpy(wire.color, part->color, sizeof wire.color);
    return send_bytes(to, &wire, sizeof wire) && send_bytes(to, part->name, wire.name_length);
}

static bool send_scene(FILE *to, const scene *s, const wire_header *header) {
    bool ok = send_bytes(to, header, sizeof *header);
    for (size_t i = 0; s && ok && i < s->mesh_count; i++)
        ok = send_mesh(to, &s->meshes[i]);
    for (size_t i = 0; s && ok && i < s->part_count; i++)
        ok = send_part(to, &s->parts[i]);
    return ok && fflush(to) == 0;
}

static void *receive_array(FILE *from, size_t count, size_t element) {
    if (count > SIZE_MAX / element - 1)
        return NULL;
    void *array = malloc(count * element + 1);
    if (array && fread(array, element, count, from) == count)
        return array;
    free(array);
    return NULL;
}

static char *receive_name(FILE *from, size_t length) {
    char *name = receive_array(from, length, 1);
    if (name)
        name[length] = '\0';
    return name;
}

static bool receive_mesh(FILE *from, scene *s) {
    wire_mesh wire;
    if (fread(&wire, sizeof wire, 1, from) != 1)
        return false;
    scene_mesh mesh = {.vertex_count = wire.vertex_count, .index_count = wire.index_count, .two_sided = wire.two_sided};
    char *name = receive_name(from, wire.name_length);
    if (name)
        mesh.positions = receive_array(from, wire.vertex_count, 3 * sizeof(float));
    if (mesh.positions)
        mesh.normals = receive_array(from, wire.vertex_count, 3 * sizeof(float));
    if (mesh.normals && wire.colors)
        mesh.colors = receive_array(from, wire.vertex_count, 3 * sizeof(float));
    if (mesh.normals && (mesh.colors || !wire.colors))
        mesh.indices = receive_array(from, wire.index_count, sizeof(uint32_t));
    bool ok = mesh.indices != NULL;
    if (ok)
        ok = scene_add_mesh(s, name, &mesh) != SIZE_MAX;
    else
        free_arrays(&mesh);
    free(name);
    return ok;
}

static bool receive_part(FILE *from, scene *s) {
    wire_part wire;
    if (fread(&wire, sizeof wire, 1, from) != 1 || wire.mesh >= s->mesh_count)
        return false;
    char *name = receive_name(from, wire.name_length);
    size_t part = name ? scene_add_part(s, name, wire.mesh, wire.transform, wire.color) : SIZE_MAX;
    free(name);
    if (part != SIZE_MAX)
        s->parts[part].opacity = wire.opacity;
    return part != SIZE_MAX;
}

/* NULL with an empty message: the other side ended too early, and how it ended says why. */
static scene *receive_scene(FILE *from, load_report *report, char *message, size_t size) {
    wire_header header;
    message[0] = '\0';
    if (fread(&header, sizeof header, 1, from) != 1)
        return NULL;
    *report = header.report;
    header.message[sizeof header.message - 1] = '\0';
    if (header.message[0]) {
        snprintf(message, size, "%s", header.message);
        return NULL;
    }
    scene *s = scene_create();
    bool ok = s != NULL;
    if (s)
        s->up_axis = header.up_axis;
    for (size_t i = 0; ok && i < header.mesh_count; i++)
        ok = receive_mesh(from, s);
    for (size_t i = 0; ok && i < header.part_count; i++)
        ok = receive_part(from, s);
    if (ok)
        return s;
    if (!feof(from))
        fail(message, size, "out of memory");
    scene_destroy(s);
    return NULL;
}

/* Sanitizers reserve more address space than any limit leaves. */
#if defined(__SANITIZE_ADDRESS__)
#define NO_MEMORY_LIMIT 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer)
#define NO_MEMORY_LIMIT 1
#endif
#endif

static unsigned seconds_for(long long size) {
    return 60 + (unsigned)(size >> 20) * 5;
}

static void limit_child(long long size) {
    struct rlimit limit;
#ifndef NO_MEMORY_LIMIT
    limit.rlim_cur = limit.rlim_max = (rlim_t)((2LL << 30) + 64 * size);
    setrlimit(RLIMIT_AS, &limit);
#endif
    limit.rlim_cur = limit.rlim_max = 0;
    setrlimit(RLIMIT_CORE, &limit);
    signal(SIGALRM, SIG_DFL);
    alarm(seconds_for(size)); /* waiting counts too: a file may name a pipe as its texture or buffer */
}

/* Reads the file and sends what it found. Never returns. */
static void run_child(const char *path, long long size, int pipe_end) {
    int nowhere = open("/dev/null", O_RDWR);
    if (nowhere >= 0) { /* a C++ library that gives up writes to stderr, where one clear line is promised */
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    static const int deadly[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    for (size_t i = 0; i < sizeof deadly / sizeof deadly[0]; i++)
        signal(deadly[i], SIG_DFL);
    limit_child(size);
    FILE *to = fdopen(pipe_end, "wb");
    wire_header header = {.message = ""};
    scene *s = to ? import_file(path, &header.report, header.message, sizeof header.message) : NULL;
    if (s) {
        header.mesh_count = s->mesh_count;
        header.part_count = s->part_count;
        header.up_axis = s->up_axis;
    }
    _exit(to && send_scene(to, s, &header) ? 0 : 1);
}

static void explain_end(int status, long long size, char *message, size_t message_size) {
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGALRM || WTERMSIG(status) == SIGXCPU))
        snprintf(message, message_size, "takes longer than %u seconds to read", seconds_for(size));
    else if (WIFSIGNALED(status))
        snprintf(message, message_size, "is damaged: assimp breaks down on it (signal %d)", WTERMSIG(status));
    else
        fail(message, message_size, "is damaged: assimp gives up on it");
}

scene *load_model(const char *path, load_report *report, char *message, size_t message_size) {
    long long size = 0;
    int ends[2], status = 0;
    memset(report, 0, sizeof *report);
    if (!check_file(path, &size, message, message_size))
        return NULL;
    if (pipe(ends) != 0) {
        fail(message, message_size, strerror(errno));
        return NULL;
    }
    fflush(NULL); /* or the child would have what waits in our buffers */
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        run_child(path, size, ends[1]);
    }
    close(ends[1]);
    FILE *from = child > 0 ? fdopen(ends[0], "rb") : NULL;
    scene *s = from ? receive_scene(from, report, message, message_size) : NULL;
    if (!from) {
        fail(message, message_size, strerror(errno));
        close(ends[0]);
    } else {
        fclose(from);
    }
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!s && !message[0])
        explain_end(status, size, message, message_size);
    return s;
}
