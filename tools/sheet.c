/*
 * sheet OUT.png COLUMNS LABEL=FILE.png...
 *
 * Several pictures of one size as one, COLUMNS side by side, the label of each in its upper left corner. Exit status: 0
 * done, 1 failed, 2 usage.
 */
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#include <stb/stb_easy_font.h>

enum { MARGIN = 6, SCALE = 2, LONGEST_LABEL = 40, WIDEST = 16384 };

typedef struct picture {
    unsigned char *rgb;
    int width, height;
} picture;

/* One of the quads that stb_easy_font makes of a text. */
typedef struct corner {
    float x, y, z;
    unsigned char color[4];
} corner;

static int complain(int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("sheet: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    return status;
}

static void fill(const picture *p, int x0, int y0, int x1, int y1, unsigned char value) {
    for (int y = y0 < 0 ? 0 : y0; y < y1 && y < p->height; ++y)
        for (int x = x0 < 0 ? 0 : x0; x < x1 && x < p->width; ++x)
            memset(p->rgb + 3 * ((size_t)y * (size_t)p->width + (size_t)x), value, 3);
}

/* Dark with a light rim, so that it is read on any picture. */
static void write_label(const picture *p, const char *label, int left, int top) {
    char text[LONGEST_LABEL + 1];
    corner quads[4 * 20 * LONGEST_LABEL];
    snprintf(text, sizeof text, "%s", label);
    int count = stb_easy_font_print(0, 0, text, NULL, quads, (int)sizeof quads);
    for (int rim = SCALE; rim >= 0; rim -= SCALE)
        for (int i = 0; i < count; ++i) {
            const corner *a = &quads[4 * i], *c = &quads[4 * i + 2];
            fill(p, left + MARGIN - rim + (int)(SCALE * a->x), top + MARGIN - rim + (int)(SCALE * a->y),
                 left + MARGIN + rim + (int)(SCALE * c->x), top + MARGIN + rim + (int)(SCALE * c->y), rim ? 255 : 40);
        }
}

static void paste(const picture *onto, const unsigned char *rgb, int width, int height, int left, int top) {
    for (int y = 0; y < height; ++y)
        memcpy(onto->rgb + 3 * ((size_t)(top + y) * (size_t)onto->width + (size_t)left),
               rgb + 3 * (size_t)y * (size_t)width, 3 * (size_t)width);
}

/* The first picture says how large all are. */
static int place(picture *sheet, int columns, int count, int index, const char *argument) {
    const char *equals = strchr(argument, '=');
    char label[LONGEST_LABEL + 1];
    int width, height;
    if (!equals || equals - argument > LONGEST_LABEL)
        return complain(2, "%s: not LABEL=FILE.png with up to %d letters", argument, LONGEST_LABEL);
    snprintf(label, sizeof label, "%.*s", (int)(equals - argument), argument);
    unsigned char *rgb = stbi_load(equals + 1, &width, &height, NULL, 3);
    if (!rgb)
        return complain(1, "%s: %s", equals + 1, stbi_failure_reason());
    if (!sheet->rgb && width <= WIDEST / columns && height <= WIDEST / ((count + columns - 1) / columns)) {
        sheet->width = width * columns;
        sheet->height = height * ((count + columns - 1) / columns);
        sheet->rgb = malloc(3 * (size_t)sheet->width * (size_t)sheet->height);
        if (sheet->rgb)
            memset(sheet->rgb, 255, 3 * (size_t)sheet->width * (size_t)sheet->height);
    }
    bool fits =
        sheet->rgb && sheet->width == width * columns && sheet->height == height * ((count + columns - 1) / columns);
    if (fits) {
        paste(sheet, rgb, width, height, index % columns * width, index / columns * height);
        if (label[0])
            write_label(sheet, label, index % columns * width, index / columns * height);
    }
    stbi_image_free(rgb);
    return fits ? 0 : complain(1, "%s: %d x %d pixels, which does not fit", equals + 1, width, height);
}

int main(int count, char **arguments) {
    picture sheet = {NULL, 0, 0};
    int columns = count > 3 ? atoi(arguments[2]) : 0, status = 0;
    if (columns < 1 || columns > 64)
        return complain(2, "usage: sheet OUT.png COLUMNS LABEL=FILE.png...");
    for (int i = 3; i < count && status == 0; ++i)
        status = place(&sheet, columns, count - 3, i - 3, arguments[i]);
    if (status == 0 && !stbi_write_png(arguments[1], sheet.width, sheet.height, 3, sheet.rgb, 3 * sheet.width))
        status = complain(1, "%s: cannot be written", arguments[1]);
    free(sheet.rgb);
    return status;
}
