/* line_svg.c: lines as SVG. */
#include "line_svg.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- text -------------------------------------------------------------------------------------------------------- */

#if defined(__GNUC__)
#define PRINTF_LIKE __attribute__((format(printf, 2, 3)))
#else
#define PRINTF_LIKE
#endif

PRINTF_LIKE static void add(svg *s, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (s->length + (size_t)length + 1 > s->capacity) {
        size_t capacity = 2 * (s->capacity + (size_t)length) + 4096;
        char *text = s->out_of_memory ? NULL : realloc(s->text, capacity);
        if (!text) {
            s->out_of_memory = true;
            return;
        }
        s->text = text;
        s->capacity = capacity;
    }
    va_start(arguments, format);
    vsnprintf(s->text + s->length, s->capacity - s->length, format, arguments);
    va_end(arguments);
    s->length += (size_t)length;
}

int utf8_length(const char *at) {
    unsigned char first = (unsigned char)*at;
    int length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    for (int i = 1; i < length; ++i)
        if (((unsigned char)at[i] & 0xC0) != 0x80)
            return 0;
    /* Overlong forms, surrogates, and what is beyond the last character. */
    unsigned char second = length > 2 ? (unsigned char)at[1] : 0;
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || (first == 0xF0 && second < 0x90) ||
        (first == 0xF4 && second > 0x8F))
        return 0;
    return length;
}

/* XML has no control characters and three with a meaning of their own here; bytes that are no UTF-8 are taken for
 * Latin-1, as in the JSON of --explain. */
static void add_escaped(svg *s, const char *text) {
    while (*text) {
        int length = utf8_length(text);
        if (length == 0 || strchr("<>&", *text))
            add(s, "&#%d;", (unsigned char)*text);
        else if (length == 1)
            add(s, "%c", *text < ' ' || *text == 127 ? '?' : *text);
        else if (length == 3 && memcmp(text, "\xEF\xBF", 2) == 0 && (unsigned char)text[2] > 0xBD)
            add(s, "?"); /* U+FFFE and U+FFFF are no characters in XML */
        else
            add(s, "%.*s", length, text);
        text += length ? length : 1;
    }
}

void svg_begin(svg *s, const float background[4]) {
    add(s,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
        "height=\"%d\" viewBox=\"0 0 %d %d\">\n",
        s->width, s->height, s->width, s->height);
    bool dark = background[3] > 0 && 0.3f * background[0] + 0.6f * background[1] + 0.1f * background[2] < 0.4f;
    if (background[3] > 0)
        add(s, "<rect width=\"100%%\" height=\"100%%\" fill=\"#%02x%02x%02x\"/>\n", (unsigned)(background[0] * 255.5f),
            (unsigned)(background[1] * 255.5f), (unsigned)(background[2] * 255.5f));
    add(s, "<g fill=\"none\" stroke=\"%s\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        dark ? "white" : "black");
}

void svg_part(svg *s, size_t number, const char *name, bool phantom) {
    double unit = fmax(1, s->line_width / 1.5);
    add(s, "<g id=\"part%zu\" class=\"part\"", number);
    if (phantom) /* Diepstraten 2002, figure 2: a long dash and two short ones */
        add(s, " stroke-linecap=\"butt\" stroke-dasharray=\"%g %g %g %g %g %g\"", 16 * unit, 5 * unit, 4 * unit,
            5 * unit, 4 * unit, 5 * unit);
    add(s, "><title>");
    add_escaped(s, name);
    add(s, "</title>\n");
}

void svg_kind(svg *s, const char *kind, double width) {
    add(s, "<g class=\"%s\" stroke-width=\"%.3g\">\n", kind, width);
    s->width_now = width;
}

void svg_end_group(svg *s) {
    add(s, "</g>\n");
}

void svg_end(svg *s) {
    add(s, "</g>\n</svg>\n");
}

/* ---- what can be seen ---------------------------------------------------------------------------------------------- */

typedef enum sight { HIDDEN, SEEN, OUTER } sight;

typedef struct sample {
    double x, y; /* pixels, upward */
    bool corner; /* of the line, not between two */
    sight sight; /* from here to the next */
} sample;

typedef struct spot {
    double x, y, depth;
    double slack; /* change of depth per motion of a pixel's size toward the eye */
    bool before;  /* the eye */
} spot;

static double transform(const double m[16], const double p[4], int row) {
    return m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row] * p[3];
}

static spot spot_at(const svg *s, const float *place, const double model_view[16], const double projection[16]) {
    const double p[4] = {(double)place[0], (double)place[1], (double)place[2], 1};
    double eye[4], clip[4], nearer[4];
    for (int k = 0; k < 4; k++)
        eye[k] = transform(model_view, p, k);
    for (int k = 0; k < 4; k++)
        clip[k] = transform(projection, eye, k);
    double pixel = 2 * clip[3] / (projection[5] * s->height);
    double far_off = sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    for (int k = 0; k < 3; k++) /* in parallel views w is 1 everywhere */
        nearer[k] = projection[11] != 0 ? eye[k] * (1 - pixel / far_off) : eye[k] + (k == 2 ? pixel : 0);
    nearer[3] = 1;
    spot at = {0.5 * s->width * (clip[0] / clip[3] + 1), 0.5 * s->height * (clip[1] / clip[3] + 1),
               0.5 * clip[2] / clip[3] + 0.5, 0, clip[3] > 0};
    at.slack = fabs(0.5 * transform(projection, nearer, 2) / transform(projection, nearer, 3) + 0.5 - at.depth);
    return at;
}

static float depth_at(const svg *s, double x, double y) {
    int column = (int)floor(x / s->width * s->image->width), row = (int)floor(y / s->height * s->image->height);
    column = column < 0 ? 0 : column >= s->image->width ? s->image->width - 1 : column;
    row = row < 0 ? 0 : row >= s->image->height ? s->image->height - 1 : row;
    return s->image->depth[(size_t)row * (size_t)s->image->width + (size_t)column];
}

/* A line is hidden where everything around it, within a pixel, is nearer by more than a pixel and a half; it borders the
 * background where that lies to a side. */
static sight sight_of(const svg *s, double x, double y, double depth, double slack, const double d[2]) {
    float farthest = 0;
    for (int up = -1; up <= 1; up++)
        for (int right = -1; right <= 1; right++)
            farthest = fmaxf(farthest, depth_at(s, x + right, y + up));
    if (depth - 1.5 * slack > (double)farthest)
        return HIDDEN;
    bool outer = depth_at(s, x - 1.5 * d[1], y + 1.5 * d[0]) >= 1 || depth_at(s, x + 1.5 * d[1], y - 1.5 * d[0]) >= 1;
    return s->outer && outer ? OUTER : SEEN;
}

/* Steps of at most a pixel along the line. Returns how many samples; `out` may be NULL. */
static size_t take_samples(const svg *s, const spot *spots, size_t count, sample *out) {
    size_t taken = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        const spot *a = &spots[i], *b = &spots[i + 1];
        double length = hypot(b->x - a->x, b->y - a->y), d[2] = {1, 0};
        int parts = !(length > 1) ? 1 : length < 100000 ? (int)ceil(length) : 100000;
        if (length > 0) {
            d[0] = (b->x - a->x) / length;
            d[1] = (b->y - a->y) / length;
        }
        for (int k = 0; k < parts; k++, taken++) {
            double t = (double)k / parts, m = (k + 0.5) / parts;
            if (!out)
                continue;
            out[taken] = (sample){a->x + t * (b->x - a->x), a->y + t * (b->y - a->y), k == 0, HIDDEN};
            if (a->before && b->before)
                out[taken].sight =
                    sight_of(s, a->x + m * (b->x - a->x), a->y + m * (b->y - a->y),
                             a->depth + m * (b->depth - a->depth), a->slack + m * (b->slack - a->slack), d);
        }
    }
    if (out && count)
        out[taken] = (sample){spots[count - 1].x, spots[count - 1].y, true, HIDDEN};
    return taken + 1;
}

/* Stretches shorter than three samples are what lies before them, or after at the beginning. */
static void drop_specks(sample *samples, size_t count) {
    for (size_t i = 0, end; i < count; i = end) {
        for (end = i + 1; end < count && samples[end].sight == samples[i].sight; end++)
            ;
        if (end - i < 3 && (i > 0 || end < count))
            for (size_t k = i; k < end; k++)
                samples[k].sight = i > 0 ? samples[i - 1].sight : samples[end].sight;
    }
}

static void add_path(svg *s, const sample *samples, size_t first, size_t last, bool closed) {
    sight kind = samples[first].sight;
    if (kind == HIDDEN && !s->hidden)
        return;
    add(s, "<path d=\"M");
    for (size_t i = first; i <= last - closed; i++)
        if (i == first || i == last || samples[i].corner)
            add(s, "%s%.2f %.2f", i == first ? "" : "L", samples[i].x, s->height - samples[i].y);
    add(s, "%s\"", closed ? "Z" : "");
    if (kind == OUTER)
        add(s, " stroke-width=\"%.3g\"", 2 * s->width_now);
    if (kind == HIDDEN)
        add(s, " class=\"hidden\" stroke-linecap=\"butt\" stroke-width=\"%.3g\" stroke-dasharray=\"%.3g %.3g\"",
            0.6 * s->width_now, 3 * s->width_now, 2 * s->width_now);
    add(s, "/>\n");
}

void svg_strip(svg *s, const float *places, size_t stride, size_t count, const double model_view[16],
               const double projection[16]) {
    spot *spots = malloc((count + 1) * sizeof *spots);
    for (size_t i = 0; spots && i < count; i++)
        spots[i] = spot_at(s, (const float *)(const void *)((const char *)places + stride * i), model_view, projection);
    size_t taken = spots && count > 1 ? take_samples(s, spots, count, NULL) : 0;
    sample *samples = malloc((taken + 1) * sizeof *samples);
    if (!spots || !samples)
        s->out_of_memory = true;
    else if (taken > 1) {
        bool closed = memcmp(places, (const char *)places + stride * (count - 1), 3 * sizeof *places) == 0;
        take_samples(s, spots, count, samples);
        drop_specks(samples, taken - 1);
        for (size_t i = 0, end; i + 1 < taken; i = end) {
            for (end = i + 1; end + 1 < taken && samples[end].sight == samples[i].sight; end++)
                ;
            add_path(s, samples, i, end, closed && i == 0 && end + 1 == taken);
        }
    }
    free(spots);
    free(samples);
}
