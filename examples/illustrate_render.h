/* illustrate_render.h: draws a scene as a technical illustration into an image. The only part of the main program that
 * speaks OpenGL; the command line, the files and the context belong to the others. */
#ifndef ILLUSTRATE_RENDER_H
#define ILLUSTRATE_RENDER_H

#include <stdbool.h>

#include "scene.h"

typedef enum illustrate_style {
    STYLE_AUTO,
    STYLE_HODGES,
    STYLE_LINES,
    STYLE_OPAQUE,
    STYLE_GLASS,
    STYLE_SMART,
    STYLE_CURVATURE
} illustrate_style;
/* Opacity that a layer starts with: oit_buffers.h's laws. */
typedef enum illustrate_law {
    LAW_AUTO, /* ADAPTIVE */
    LAW_GIVEN,
    LAW_CONSTANT,
    LAW_ADAPTIVE,
    LAW_ANGLE,
    LAW_VARIATION,
    LAW_DISTANCE
} illustrate_law;
/* When fragments are neighbours: oit_buffers.h's, or as the papers have it; ONE_SIDED: Murray's without the reverse check
 * (figure 5a). */
typedef enum illustrate_neighbours {
    NEIGHBOURS_MUTUAL,
    NEIGHBOURS_MURRAY,
    NEIGHBOURS_ONE_SIDED,
    NEIGHBOURS_CARNECKY
} illustrate_neighbours;
typedef enum illustrate_shade { SHADE_COOL_TO_WARM, SHADE_FLAT } illustrate_shade;
/* AUTO: explicit for transparent parts with inner walls, else implicit. PUBLISHED: implicit, with the paper's faults.
 * LAYERS: the closest transparent surfaces, whatever they belong to. */
typedef enum illustrate_interior {
    INTERIOR_AUTO,
    INTERIOR_IMPLICIT,
    INTERIOR_EXPLICIT,
    INTERIOR_PUBLISHED,
    INTERIOR_LAYERS
} illustrate_interior;
typedef enum illustrate_blend { BLEND_OVER, BLEND_NORMALISED, BLEND_PUBLISHED } illustrate_blend;
/* How heavy lines are: silhouette.h's conventions. */
typedef enum illustrate_weight {
    WEIGHT_ONE,
    WEIGHT_THICK_THIN,
    WEIGHT_OUTER,
    WEIGHT_PERSPECTIVE,
    WEIGHT_LIGHT
} illustrate_weight;
enum { PART_AUTO = 0, PART_TRANSPARENT = 1, PART_OPAQUE = 2 };

typedef struct illustrate_job {
    const scene *scene; /* hidden parts are not drawn */
    illustrate_style style;
    int width, height;         /* pixels of the result, 1 to 16384 */
    double azimuth, elevation; /* degrees; azimuth 0 looks at the front, positive goes to the scene's right */
    bool ortho;
    const unsigned char *transparent; /* per part PART_AUTO, PART_TRANSPARENT or PART_OPAQUE; NULL: all PART_AUTO */
    int quality;                      /* supersampling factor per axis, 1 to 8 */
    bool silhouettes, boundaries, creases;
    bool
        lines_asked; /* false: STYLE_SMART and STYLE_CURVATURE, which show silhouettes of their own, draw none of them */
    float line_width; /* pixels of the result */
    illustrate_weight weight;
    bool phantom; /* transparent parts are drawn by their lines alone, dashed */
    bool hidden;  /* hidden lines are there, in short dashes */
    bool smooth;  /* silhouettes of meshes without creases are smooth ones */
    illustrate_shade shade;
    float background[4]; /* colour and alpha, 0 to 1; alpha 0: the result is see-through where nothing was drawn */
    float opaque_weight; /* weight of opaque things behind a transparent surface; negative: the renderer's default */
    float background_weight; /* the same for the background */
    float k;                 /* exponent of equation 2; negative: the renderer's default */
    int alpha_quality;       /* rung of the alpha ladder, 1 to 4; 0: 3 */
    illustrate_blend blending;
    illustrate_interior interior;
    int layers;                  /* of INTERIOR_LAYERS, 1 to 8 */
    const unsigned char *groups; /* per part, 1 to 127, 0: of none; transparent parts of one show through each other */
    double group_distance;       /* along the view, units of the scene; 0: however far */
    bool adaptive;               /* STYLE_GLASS: the layers of a pixel hide together what one would, however many */
    float opacity;               /* STYLE_GLASS: of parts that the file has opaque, 0 to 1; 0: 0.3, adaptive 0.7 */
    illustrate_law law;          /* STYLE_SMART, STYLE_CURVATURE */
    float law_opacity;           /* of that law; 0: 0.3, ADAPTIVE 0.6 */
    illustrate_neighbours neighbours; /* STYLE_SMART, STYLE_CURVATURE */
    int iterations; /* STYLE_SMART: pixels of the result that silhouettes fade over; 0: 20, negative: the law alone */
    double halo;    /* the same of halos; 0: 5, negative: none */
    bool shade_convex, shade_curved, opacity_front, opacity_deep; /* STYLE_CURVATURE: presets; none: convex and deep */
    const float *shades, *opacities;                              /* instead, where not NULL: oit_curvature's arrays */
    double contours; /* STYLE_SMART, STYLE_CURVATURE: the least rise of suggestive ones, radii of the scene to the power
                        -2; 0: none, negative: 1 */
    float enter;     /* shade taken from opaque parts where they enter transparent ones, 0 to 1 */
    bool explain, verbose; /* explain: fill explain_json; verbose: lines about the path taken may go to stderr */
    void (*progress)(const char *what, double fraction, void *user); /* may be NULL; fraction 0 to 1 */
    void *user;
} illustrate_job;

typedef struct illustrate_result {
    unsigned char *rgba; /* width*height*4 bytes, top row first, not premultiplied, malloc'd; NULL after a failure */
    char *explain_json;  /* malloc'd or NULL */
    char message[256];   /* what was wrong, without a line end, after a failure */
} illustrate_result;

/* The lines alone, as SVG: text of `length` bytes, malloc'd. Needs no GL. Parts are groups; widths go by kind, so weights
 * by perspective and light are none here. NULL: result->message says why. */
char *illustrate_svg(const illustrate_job *job, size_t *length, illustrate_result *result);

/* Needs a current GL context (desktop 3.3 core or later, or GLES 3.0 or later). False: nothing allocated is left in
 * the result, message says why. */
bool illustrate_render(const illustrate_job *job, void (*(*get_proc)(const char *))(void), illustrate_result *result);

#endif
