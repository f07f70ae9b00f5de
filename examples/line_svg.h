/* line_svg.h: lines as SVG. What can be seen of them is told by a picture of depths. */
#ifndef LINE_SVG_H
#define LINE_SVG_H

#include <stdbool.h>
#include <stddef.h>

#include "depth_image.h"

typedef struct svg {
    char *text; /* malloc'd; NULL at first */
    size_t length, capacity;
    bool out_of_memory;           /* nothing is added then */
    int width, height;            /* pixels */
    double line_width, width_now; /* of the job; of the kind of line that is being written */
    const depth_image *image;     /* of what hides lines; it covers the picture in any number of pixels */
    bool outer;                   /* lines that border the background are twice as wide */
    bool hidden;                  /* hidden lines are there, with short dashes */
} svg;

/* In this order: begin; for each part group, for each kind of line in it group, strips, end_group; end_group; end. */
void svg_begin(svg *s, const float background[4]);
void svg_part(svg *s, size_t number, const char *name, bool phantom);
void svg_kind(svg *s, const char *kind, double width);
void svg_end_group(svg *s);
void svg_end(svg *s);

/* The bytes of the character at `at` if it is whole UTF-8, else 0. */
int utf8_length(const char *at);

/* One line over `count` places, three floats each, `stride` bytes apart. A closed one repeats its first place. */
void svg_strip(svg *s, const float *places, size_t stride, size_t count, const double model_view[16],
               const double projection[16]);

#endif
