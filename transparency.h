/* transparency.h - v0.3.0 - illustrators' transparency for OpenGL 3.3, OpenGL ES 3.0 and WebGL 2 - MIT licence, at the end

   DOES
   - draws technical illustrations in which opaque things show through the transparent objects that enclose them, after
     Diepstraten, Weiskopf and Ertl, "Transparency in Interactive Technical Illustrations" (2002): faces of transparent
     objects never shine through each other, an opaque thing behind two transparent objects does not show, and
     transparency falls off toward the silhouettes of the transparent object
   - does so by implicit or explicit interiors (the paper's two methods), for all objects or object by object; shows the n
     closest layers, or objects of one semantic group through each other; strengthens the shade of opaque objects where
     they enter transparent ones
   - gives the same picture, bit for bit, in whatever order the objects are drawn; sorts nothing, reads nothing back
     (opaque objects that share a plane are the exception: see LIMITS)
   - shows units that must not be lost from sight through whatever hides them, after Assarsson, Elmqvist and Tsigas,
     "Image-Space Dynamic Transparency for Improved Object Discovery in 3D Environments" (2006), with one mask for all of
     them, blended or screen-door: see DYNAMIC TRANSPARENCY
   - shades from cool to warm (Gooch et al. 1999) and draws silhouettes and creases in the right passes, for hosts that
     have no shaders of their own; works with the host's own shaders through one function call
   - leaves the GL state as found, or tells the host which state each pass wants

   DOES NOT
   - create a GL context, load models, find silhouettes or their distances: silhouette.h does the last two, or anything
     else that fills plain arrays
   - draw by sample: multisampled targets are served by textures of our own with two by two texels a pixel

   QUICK START: a triangle's worth of it, given a current context and its getter of function pointers

    --8<-- quick start
    #define TRANSPARENCY_IMPLEMENTATION
    #include "transparency.h"
    #include <string.h>

    extern tr_proc get_proc(const char *name);                       // eglGetProcAddress, glfwGetProcAddress, ...
    extern void draw_my_mesh(int index);                             // binds a vertex array, calls glDrawElements
    extern void my_matrices(int index, float mvp[16], float normal_matrix[9]);

    static const tr_object objects[2] = {{1, TR_TRANSPARENT}, {2, TR_OPAQUE}};

    tr_context *start(void) {
        tr_desc desc = {0};
        desc.get_proc = get_proc;
        return tr_create(&desc, 0);
    }

    tr_result draw_frame(tr_context *tr, int width, int height) {    // into the default framebuffer, cleared before
        tr_frame frame = {0};
        tr_pass pass;
        tr_result result;
        int i;
        frame.width = width;
        frame.height = height;
        frame.scene = tr_scene_count(objects, 2, sizeof objects[0]);
        result = tr_begin(tr, &frame);
        if (result != TR_OK) return result;
        while (tr_next_pass(tr, &pass))
            for (i = 0; i < 2; ++i)
                if (pass.lines == 0 && tr_pass_draws(&pass, &objects[i])) {
                    tr_material material;
                    memset(&material, 0, sizeof material);
                    my_matrices(i, material.model_view_projection, material.normal_matrix);
                    material.object = objects[i].id;
                    material.color[0] = material.color[1] = material.color[2] = 0.7f;
                    material.color[3] = 0.5f;
                    tr_set_material(tr, &pass, &material);
                    draw_my_mesh(i);
                }
        return tr_end(tr);
    }
    -->8--

   BUILD
   Define TRANSPARENCY_IMPLEMENTATION in one C (C99) or C++ (C++11) file before including this header; include it
   anywhere else without. Link nothing but your GL loader; tr_* functions call GL through the table that desc.get_proc
   fills. On Windows wglGetProcAddress does not know the functions of GL 1.1: give a getter that asks opengl32.dll as
   well, as those of GLFW and SDL do.

   OPTIONS, defined before the implementation unless said otherwise
   - TR_STATIC           every function static; define it wherever the header is included
   - TR_GL_STATIC        take the gl* names that are visible (glad, GLEW, epoxy, GLES3/gl3.h: include it first) instead
                         of desc.get_proc
   - TR_MALLOC, TR_FREE  used when the desc brings no allocator; default malloc and free

   GL FLOOR
   OpenGL 3.3 core, OpenGL ES 3.0, WebGL 2. Newer functions (indexed blend and mask state) are used where the version
   has them. No extension is needed.

   GL STATE CONTRACT
   Between tr_begin and tr_end the header owns the state of the context; the host draws its objects with what each pass
   has set: program (a built-in one, or the host's own), framebuffer, viewport, masks, depth, blend, cull. The host binds
   vertex arrays, its own textures below desc.first_texture_unit and its own uniform buffers. desc.state says what
   happens around that:
   - TR_STATE_RESTORE         all that tr_begin changed is as it was after tr_end (the state list is tr_i_snapshot)
   - TR_STATE_LEAVE_DEFAULTS  that state has the values of a fresh context after tr_end, target framebuffer 0
   - TR_STATE_LEAVE_DIRTY     it is whatever the last pass needed
   - TR_STATE_NONE            no state call is made between tr_begin and tr_end: pass.state holds what the host must
                              set, clear and bind, and passes with vertex_count > 0 are drawn by the host as well
   Not touched, and expected to be at rest: conditional rendering, transform feedback, clip control's origin, sample
   shading, smooth polygons, what only compatibility contexts have. Clip distances are switched off in each pass; a host whose shaders write them switches them on again after
   tr_next_pass. Under TR_STATE_NONE, tr_begin may still bind and restore when something is created or changed, and does
   not look at the target or the host's textures: that they are right is the host's to see to, and wishes.supersample.
   tr_state then lists what differs from pass to pass; all else is to be as in a fresh context, dither off.
   The alpha channel of the target is not written. Of a target with several draw buffers the first is drawn into, the
   others are masked off; ES before 3.2 and WebGL 2 have no such mask: give them a framebuffer with one draw buffer.
   With desc.max_gl_version below 4.0 on a newer context the blend functions of further draw buffers are not kept.
   GL_FRAMEBUFFER_SRGB is the host's, except with TR_WISH_SRGB. glGetError is never called, so that no error of the host's is swallowed.

   ERRORS, MEMORY, THREADS
   Every function that can fail returns a tr_result and logs through desc.log_fn. A failed tr_begin leaves the state as
   found and nothing allocated that tr_destroy would not free; the next frame may be tried. One heap block a context, up to two more with
   tr_begin_dynamic.
   tr_set_edges and tr_find_outlines make textures of their own when sizes change, and hold them until tr_release;
   tr_set_crossings until tr_destroy.
   Textures are created when a plan first needs them or the size changes (never in a steady frame): 24 bytes a pixel with
   lines and one layer, 8 or 12 more for each further layer, see tr_plan.bytes_per_pixel and docs/transparency.md. Programs
   are compiled when a plan first needs them. tr_crossings allocates by TR_MALLOC while it runs. One context of ours for
   one GL context, used from the thread that has it current.

   RECIPES
   - Your own shaders: prepend the strings of tr_glsl() to a vertex and a fragment shader (which then begins without
     #version; #extension lines go between the first string and the second), call tr_surface(color, object) last in the
     fragment main, link, tr_prepare_program() once; make one program for each tr_rule that you meet in pass.rule. The
     vertex shader must compute gl_Position alike in all. TR_WANTS_COLOR is 0 where shading may be skipped.
   - Mirrored objects (a model matrix of negative determinant): their front faces are wound the other way round; call
     glFrontFace with the opposite of pass.state.front_face before, and with it after drawing them.
   - Lines: fill a buffer with triangles in screen space (sil_ribbons of silhouette.h has the layout: four floats x, y,
     depth, slack as attribute 0, centre x, y as attribute 1), ask for them with wishes.lines, and draw them in passes
     whose pass.lines is not 0: the creases of an object or its outlines; dashed ones for TR_LINES_HIDDEN, wide ones for
     TR_LINES_OUTER.
   - Interiors: TR_INTERIOR_AUTO wants facts, as flags of each object: TR_CLOSED, TR_HOLDING. Objects that differ, and
     groups, are told apart by the number that shaders get: pass tr_object_code() where you passed the id.
   - Opaque things that enter glass: tr_crossings() for each opaque object once its place is known, all segments to
     tr_set_crossings(), wishes.options TR_WISH_ENTERING, frame.enter_distance, and the object's range and model matrix in
     its material. Your own opaque shader calls color = tr_strengthen(color, position, range) before tr_surface.
   - View-dependent alpha: attribute 2 holds each vertex's distance to the nearest silhouette (sil_distances),
     material.d_max the largest (sil_max_distance). Where that shows bands or seams: the next section.
   - Existing depth: the picture is drawn into the target depth tested, so what the host drew there before hides it. Opaque
     things that are to be seen through glass, and hidden by it, must not be in the target: all of it is background. If
     they are in textures already, frame.opaque_color and opaque_depth take them from there, by one full-screen pass, in
     place of drawing them again; the nearest opaque surface is all that any rule asks for. Objects that are listed and
     lie in the textures are TR_DRAWN; others are drawn as ever. The textures: drawn with the frame's projection, jitter
     and depth convention, into depths from 0 to 1; the far value is background, and so is what lies outside of them.
     Hodges' first rule wants shading object by object and leaves them as they are. See docs/transparency.md.
   - Newer GLSL: the first string of tr_glsl() is the line of #version and nothing else; a host's newer one may stand in
     its place. A vertex shader that declares gl_Position invariant itself needs none of the vertex stage's strings.
   - Caches of GL state: with TR_STATE_RESTORE what a host believed before tr_begin is true again after tr_end, but for
     what the header does not touch: bindings of the host's own uniform buffers and textures. At the start of a pass
     pass.state.program is in use. docs/integration.md puts the header into an engine that has such a cache.
   - High dynamic range: make tones first, in the shader that calls tr_surface as well, and draw afterwards; see LIMITS.

   THE ALPHA LADDER
   alpha = 1 - (d / d_max)^k (equation 2), d the distance to the nearest silhouette in the world. frame.wishes.alpha says
   how d is had; prices and errors are in docs/transparency.md. Each rung is a program of its own: what is not used costs
   nothing.
   - TR_ALPHA_PUBLISHED    alpha at vertices, attribute 2. As good as the mesh is fine; a box is opaque
   - TR_ALPHA_DISTANCE     (default) the same distances, alpha a pixel: the law's bend is right within a triangle
   - TR_ALPHA_CANDIDATES   distance a pixel to the edges that its triangle carries: the field itself, no band, no seam.
                           tr_set_edges with the lists of sil_candidates when the eye or the object has moved. Attribute 4
                           (an unsigned integer, glVertexAttribIPointer) holds the triangle's number at its last vertex,
                           so that vertices are not shared unless a triangle has one that is last in it alone. The
                           larger a triangle, the more edges it carries to each of its pixels: divide the largest
   - TR_ALPHA_EXACT        distance a pixel to all edges by a hierarchy over them: the same field, nothing per triangle,
                           any mesh as it is. tr_set_edges with the order of sil_edge_tree_order
   - TR_ALPHA_IMAGE        distance a pixel in the picture, to outlines found in it: for hosts without meshes on the CPU,
                           who draw depth (and ids) of the transparent objects themselves before tr_find_outlines. Knows
                           the front-most surface alone, and is right to a pixel where that faces the eye
   Hosts' own programs put the strings of tr_alpha_glsl() after those of tr_glsl(), and multiply their alpha by tr_alpha().
   Shaders that cost much may ask tr_may_show() first.

   DYNAMIC TRANSPARENCY
   Targets are seen through what lies before them, and through a soft edge around them: opacity alpha_target before the
   target itself, beside it rising from alpha_start to 1 over `width` pixels. An opaque scene of any engine stays as it is;
   the header asks for a few things to be drawn once more. A second recipe:

    static tr_unit units[COUNT];        // what the game knows: bounding spheres, which are targets, what is the ground

    tr_result draw_battle(tr_context *tr, const tr_frame *frame, tr_dynamic *dynamic) {   // both begin as zeros
        tr_pass pass;                                                 // frame: target and viewport
        size_t i;
        tr_result result;
        dynamic->units = units;
        dynamic->unit_count = COUNT;                                  // and dynamic->view, dynamic->projection
        result = tr_begin_dynamic(tr, frame, dynamic);
        if (result != TR_OK) {                                        // no pass comes: the scene is yours to draw
            draw_everything_as_ever();
            return result;
        }
        while (tr_next_pass(tr, &pass)) {
            if (pass.kind == TR_PASS_SCENE && pass.rule == TR_RULE_SEE_PLAIN)
                draw_everything_as_ever();                            // own programs, own state, all attachments
            else
                for (i = 0; i < pass.unit_count; ++i)                 // a variant of your program for each rule that you
                    draw_unit(pass.units[i], my_program_for(pass.rule));    // meet; see below. Batches may hold more
        }
        return tr_end(tr);
    }

   - The variant: tr_glsl(tr, stage, rule) before your shaders, tr_see_through(color, code) last in main, then write color to
     location 0; tr_prepare_program() once. code is tr_unit_code() of the unit, a uniform, an attribute of instances or a
     texel. Where TR_WANTS_COLOR is 0 shading may be skipped. Shaders that discard (leaves) do so before the call. Outputs
     beyond location 0 go nowhere but in TR_PASS_SCENE: attachments of a G-buffer are drawn as ever, and left alone. In
     TR_RULE_SEE_PEEL location 1 is ours: leave yours out. Sequences paint what meets masks after TR_PASS_SCENE, into the
     first draw buffer alone: other attachments lack those units.
   - What to call what: units that must be seen are targets, all else is a distractor but for the ground and the sky, which
     are backdrops (a distractor ground would be cut open along the lower edge of each target), and what shall never be
     seen through, which is impenetrable. Hills are distractors, or impenetrable.
   - TR_SEE_ONE_MASK (default) blends. TR_SEE_DITHER leaves out fragments instead, by a threshold a pixel that changes with
     frame_index: for deferred pipelines (draw your G-buffer in TR_PASS_SCENE, and depth is right) and with temporal
     anti-aliasing. Both sort nothing, and cost the same for one target and for a thousand but for what is covered.
   - Where no target is in view, or nothing that yields lies before one, TR_PASS_SCENE is all there is and no GL call is made.
   - In parts: hosts that clear before tr_begin_dynamic, and draw in TR_PASS_SCENE as in any other pass no unit but
     pass.units, set dynamic.in_parts. Then TR_PASS_SCENE comes several times, by TR_RULE_SEE_PLAIN with the host's own
     programs into its own target: targets, what never yields, the rest; depth and colour are copied in between, so that
     TR_SEE_ONE_MASK draws again what shows through and nothing else, and TR_SEE_DITHER draws each unit once, most of them
     without the discard. The picture is the same. What the target has to be for it: tr_begin_dynamic. A host that draws
     all it has whenever it draws its scene leaves in_parts at 0: everything would be taken for what never yields.
   - Search lights: targets with TR_UNIT_ACTIVE are seen inside of dynamic.lights only. Coming and going: tr_advance(), with
     wanted 1 for what shall fade out; it is the mask that fades, not the unit.
   - tr_query_hidden() tells how much of each target is hidden, two or three frames late, without waiting.
   - Two-sided materials: passes cull back faces, as pass.state says; switch that off and on again around what has two sides.
   - State: before TR_PASS_SCENE it is the host's, see tr_begin_dynamic; in the other passes it is ours, as in any sequence.
   - Memory: 14.9 bytes of textures a pixel with masks at a quarter of the resolution; TR_SEE_ONE_MASK with lights or
     queries 4 more, in parts 8 more; 1 more where some importance of a distractor is neither 0 nor 1
     (tr_see_plan.bytes). Lists of units, 52 bytes each, and the answers of
     queries, half a megabyte, are a second and a third block on the heap; tr_release gives all of it back.
   - Limits: the nearest of several targets at a pixel owns it, so that what is before the others is cut for the nearest
     alone. Behind an occluder other faces of the same object may show beside a target. What shows through passes through 8
     bits; with TR_WISH_SRGB through sRGB ones. Of multisampled targets the mask is a pixel's. Errors, prices and where
     we depart from the paper: docs/dynamic.md.

   LIMITS AND PRECISION
   - Depths are 32-bit floats; transparent layers are told apart down to one unit in the last place. Opaque things are
     depth tested against them by fixed function: where an opaque surface and the front-most transparent one have the
     same depth the opaque one is seen through the other, if the driver's depth test and its gl_FragCoord.z agree. Those of
     frame.opaque_depth are compared as its format has rounded them: within half a step either may be the nearer.
   - Where two opaque surfaces have the same depth, the one drawn first is seen, as with any depth test.
   - Layers and members of groups: at most TR_MAX_LAYERS a pixel. With TR_BLENDING_PUBLISHED and several layers the sum is
     clamped layer by layer, but for the background's part, which the target's format clamps once.
   - Distances between members of a group, and to crossings, are those of 32-bit floats in the space they are given in.
   - Coincident front faces count as one surface, that of the lowest object id. With implicit interiors another object's
     coincident front face limits what is seen through it as if it were behind; with explicit ones it does not.
     Ids are below 2^24 - 1.
   - Colours of opaque things and of the transparent surface pass through 8-bit textures, alpha too: into an 8-bit linear
     target at most 1/255 is lost; more into sRGB or float targets (the dark end is coarse, what is brighter than 1 is
     cut), and with TR_BLENDING_NORMALISED where alpha and w are both below 0.01.
   - Image size: what GL_MAX_TEXTURE_SIZE and GL_MAX_VIEWPORT_DIMS allow. A viewport of no area draws nothing and is no error.
*/
#ifndef TRANSPARENCY_H
#define TRANSPARENCY_H

#include <stddef.h>
#include <stdint.h>

#define TR_VERSION 300 /* major * 10000 + minor * 100 + patch */

#ifndef TR_STATIC
#define TR_DEF extern
#elif defined(__GNUC__) || defined(__TINYC__)
#define TR_DEF static __attribute__((unused))
#else
#define TR_DEF static
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What went wrong. tr_result_string gives the sentence. */
#define TR_RESULTS(X)                                                                                                  \
    X(TR_OK, "no error")                                                                                               \
    X(TR_INVALID_ARGUMENT, "an argument is missing or out of range")                                                   \
    X(TR_OUT_OF_MEMORY, "out of memory")                                                                               \
    X(TR_GL_TOO_OLD, "the context is older than OpenGL 3.3 or OpenGL ES 3.0")                                          \
    X(TR_GL_FUNCTION_MISSING, "a GL function that is needed was not found")                                            \
    X(TR_SHADER_FAILED, "a shader did not compile or link")                                                            \
    X(TR_TARGET_INCOMPLETE, "a framebuffer is not complete (no memory for its textures, or the target is not)")        \
    X(TR_TOO_LARGE, "the viewport or an array is larger than the context's textures can be")                           \
    X(TR_WRONG_ORDER, "inside of a frame what belongs outside of it, or tr_end outside")

typedef enum tr_result {
#define TR_I_ENUM(name, text) name,
    TR_RESULTS(TR_I_ENUM)
#undef TR_I_ENUM
        TR_RESULT_COUNT
} tr_result;

typedef enum tr_state_policy {
    TR_STATE_RESTORE,
    TR_STATE_LEAVE_DEFAULTS,
    TR_STATE_LEAVE_DIRTY,
    TR_STATE_NONE
} tr_state_policy;

typedef enum tr_log_level { TR_LOG_ERROR, TR_LOG_WARNING, TR_LOG_INFO } tr_log_level;

typedef void (*tr_proc)(void);

typedef struct tr_desc {
    tr_proc (*get_proc)(const char *name);      /* required, except with TR_GL_STATIC */
    void *(*alloc_fn)(size_t size, void *user); /* both or neither */
    void (*free_fn)(void *block, void *user);
    void *alloc_user;
    void (*log_fn)(tr_log_level level, tr_result code, const char *text, void *user); /* optional */
    void *log_user;
    tr_state_policy state;
    int max_gl_version;     /* 0: what the context has; 330: use nothing newer than 3.3 (for tests of fall-backs) */
    int first_texture_unit; /* TR_TEXTURE_UNITS + 2 units from here on are ours; 0: 8 */
    int uniform_binding;    /* uniform buffer binding point that is ours; 0: 15 */
    int reversed_z;         /* 1: near is 1, far is 0 */
    int front_face_cw;      /* 1: front faces are wound clockwise in window space */
    int zero_to_one;        /* 1: clip depth runs from 0 to 1 (glClipControl), as frame.projection has it */
    int eight_bits; /* 1: no colour textures of floats, even where they can be drawn into: less to move, and masks of
                               dynamic transparency are rounded to 255ths */
} tr_desc;

/* ---- what is drawn ---------------------------------------------------------------------------------------------- */

enum {
    TR_OPAQUE = 0,
    TR_TRANSPARENT = 1,
    TR_TWO_SIDED = 2, /* open sheets: both sides count as front, none as back */
    TR_IMPLICIT = 4,  /* interiors of this object, whatever the frame's are */
    TR_EXPLICIT = 8,
    TR_CLOSED =
        16, /* a fact, for TR_INTERIOR_AUTO: each edge has two faces, so that there is an inside (sil_mesh_info) */
    TR_HOLDING = 32, /* a fact: opaque objects lie within that inside, between front and back faces (sil_containment) */
    TR_DRAWN = 64 /* opaque, and in frame.opaque_color and opaque_depth already: not drawn again, but for its lines */
};
/* Transparent objects of one semantic group, 1 to 127, show through each other; to be or-ed into the flags. */
#define TR_GROUP(number) ((uint32_t)(number) << 8)
#define TR_MAX_GROUP 127

/* One object of the host's, as far as passes care. */
typedef struct tr_object {
    uint32_t id;    /* stable, unique among transparent objects, 0 ... 2^24 - 2 */
    uint32_t flags; /* TR_TRANSPARENT, TR_TWO_SIDED, ..., TR_GROUP() */
} tr_object;

/* What is in the scene, as counts: a plan follows from them, no object list is kept. */
typedef struct tr_scene {
    uint32_t opaque, opaque_two_sided, transparent, transparent_two_sided;
    uint32_t implicit_asked, explicit_asked; /* of the transparent ones: TR_IMPLICIT, TR_EXPLICIT */
    uint32_t holding;                        /* of the other transparent ones: TR_CLOSED and TR_HOLDING */
    uint32_t group_size;                     /* transparent objects in the largest group */
    uint32_t invalid;                        /* objects with an id, a group or flags out of range */
    uint32_t opaque_drawn;                   /* TR_DRAWN; a frame with frame.opaque_depth counts one at least */
} tr_scene;

typedef enum tr_interior {
    TR_INTERIOR_IMPLICIT, /* Diepstraten 6.1 (method I), mended: opaque things show up to the next back face */
    TR_INTERIOR_IMPLICIT_PUBLISHED, /* the same as the paper has it, with its two faults: see docs/transparency.md */
    TR_INTERIOR_EXPLICIT, /* Diepstraten 6.2 (method II): up to the next front face; for modelled inner walls */
    TR_INTERIOR_AUTO,     /* object by object: implicit where TR_CLOSED and TR_HOLDING, else explicit */
    TR_INTERIOR_LAYERS    /* wishes.layers front faces, opaque things up to the next one; 1: as TR_INTERIOR_EXPLICIT */
} tr_interior;
#define TR_MAX_LAYERS 8
#define TR_MAX_SUPERSAMPLE 4

/* alpha and C of the transparent surface; w: weight of what is behind it, D: its colour. */
typedef enum tr_blending {
    TR_BLENDING_OVER,       /* alpha C + (1 - alpha) D */
    TR_BLENDING_NORMALISED, /* (alpha C + w D) / (alpha + w); D where both are 0 */
    TR_BLENDING_PUBLISHED   /* alpha C + w D, clamped by the target */
} tr_blending;

/* How equation 2 is evaluated, by rising accuracy but for the first two: see THE ALPHA LADDER. */
typedef enum tr_alpha {
    TR_ALPHA_DISTANCE,   /* distance at vertices (attribute 2), alpha a pixel */
    TR_ALPHA_PUBLISHED,  /* distance and alpha at vertices: Diepstraten 2002, section 5 */
    TR_ALPHA_CANDIDATES, /* distance a pixel, to the edges that each triangle carries: tr_set_edges */
    TR_ALPHA_EXACT,      /* distance a pixel, to all edges of the object: tr_set_edges */
    TR_ALPHA_IMAGE,      /* distance a pixel, in the image, to outlines found there: tr_find_outlines */
    TR_ALPHA_COUNT
} tr_alpha;

enum {
    TR_LINES_CREASES = 1,
    TR_LINES_OUTLINES = 2, /* silhouettes and boundaries */
    TR_LINES_HIDDEN = 4,   /* phantom lines, of whatever kind, drawn where the others are hidden */
    TR_LINES_OUTER = 8     /* wide outlines, drawn only where no surface is: Gooch 1999, section 5.1.3 */
};

enum {
    TR_WISH_BLEND_COLOR = 1, /* frame.blend_color in place of the background behind transparent surfaces */
    TR_WISH_SRGB = 2,        /* colours are sRGB, blended as light; into a target with an sRGB format */
    TR_WISH_ENTERING = 4     /* opaque shade is strengthened near tr_set_crossings: Hodges' first rule */
};

typedef struct tr_wishes {
    tr_interior interior;
    tr_blending blending;
    uint32_t lines;       /* TR_LINES_*: which the host has ribbons for */
    uint32_t layers;      /* TR_INTERIOR_LAYERS: 1 ... TR_MAX_LAYERS; else the most of a group that are shown; 0: all */
    uint32_t options;     /* TR_WISH_* */
    uint32_t supersample; /* our textures per side of a pixel, 1 ... TR_MAX_SUPERSAMPLE; 0: 1, multisampled targets 2 */
    tr_alpha alpha;
} tr_wishes;

typedef struct tr_frame {
    uint32_t framebuffer;    /* target; its first draw buffer is drawn into, depth tested if it has depth */
    int x, y, width, height; /* viewport within the target, pixels */
    tr_scene scene;
    tr_wishes wishes;
    float opaque_weight;     /* w of opaque things, in [0,1]; 0: default 1; negative: 0 */
    float background_weight; /* w of the target's own content; 0: default 0.5 (Diepstraten 7); negative: 0 */
    /* Built-in shading. All zeros: cool-to-warm with the default ends; flat_shading: the object's colour as it is. */
    int flat_shading;
    float light[3];         /* toward the light, any length, in the space of the normals; zero: (-0.45, 0.65, 0.62) */
    float cool[4], warm[4]; /* rgb, and the amount of the object's colour in it; both zero: defaults */
    float crease_color[3];  /* ink; zero: white (Gooch 1999, figure 9) unless black_creases */
    int black_creases;
    float outline_color[3]; /* zero: black */
    float line_tolerance;   /* depth tolerance of lines in pixels toward the eye; 0: default 2 */
    float blend_color[3];   /* of TR_WISH_BLEND_COLOR */
    float group_distance;   /* groups: distance along the view, in eye units, below which one shows; 0: however far */
    float projection[16];   /* column-major, as the objects are drawn; needed where group_distance is given */
    float enter_strength;   /* of TR_WISH_ENTERING: share of the shade taken away at the curve; 0: default 0.5 */
    float enter_distance;   /* in which that falls to nothing, units of the segments; needed with TR_WISH_ENTERING */
    float enter_line;       /* width in pixels of the curve as a line, in the outlines' colour; 0: none */
    float jitter[2];        /* sub-pixel jitter in the projection, pixels: lines are shifted by it, as surfaces are */
    /* Opaque things that the host has drawn already, see RECIPES, "Existing depth": two of GL_TEXTURE_2D, or neither. Depth
       or red, without comparison; colours of floats or normalised, with TR_WISH_SRGB light, as sRGB formats give it. */
    uint32_t opaque_color, opaque_depth; /* 0: none */
    int opaque_x, opaque_y;              /* texel of both at the viewport's lower left corner */
} tr_frame;

/* ---- the plan --------------------------------------------------------------------------------------------------- */

typedef enum tr_pass_kind {
    TR_PASS_FRONT,             /* depth of the nearest transparent front face; with its colour where that cannot tie */
    TR_PASS_PEEL,              /* the same of the next layer behind */
    TR_PASS_LAYER,             /* whose a layer is, and its colour and alpha */
    TR_PASS_LIMIT,             /* depth from which on opaque things are hidden */
    TR_PASS_OPAQUE,            /* opaque colour */
    TR_PASS_COPY_DEPTH,        /* full screen */
    TR_PASS_OPAQUE_LINES,      /* lines of opaque objects */
    TR_PASS_COMPOSE,           /* full screen, into the target */
    TR_PASS_TRANSPARENT_LINES, /* lines of transparent objects, into the target */
    TR_PASS_HIDDEN_LINES,      /* phantom lines where those are hidden, into the target */
    TR_PASS_OUTER_LINES,       /* wide outlines outside of everything, into the target */
    TR_PASS_TAKE_OPAQUE,       /* full screen, before TR_PASS_OPAQUE: the same, from the host's textures */
    /* of tr_begin_dynamic; the host draws pass.units in those that are not called full screen */
    TR_PASS_BLOCK,        /* depth of what closes masks */
    TR_PASS_TARGETS,      /* depth, strength and colour of the nearest target */
    TR_PASS_BITS,         /* full screen, as are all of these five: pixels of targets, packed */
    TR_PASS_SPREAD_X,     /* the nearest of them in each row */
    TR_PASS_SPREAD_Y,     /* nearest of all, at the mask's resolution */
    TR_PASS_FINISH,       /* mask and its depth, at the target's resolution */
    TR_PASS_PRIME,        /* depth that lets nothing be drawn outside of masks */
    TR_PASS_SCENE,        /* the host's whole scene, as it always draws it */
    TR_PASS_BEHIND,       /* what shows through masks */
    TR_PASS_YIELD,        /* importance of the front-most unit */
    TR_PASS_COMPOSE_MASK, /* full screen, into the target: the former over the scene */
    TR_PASS_QUERY,        /* full screen: which target, at a quarter of the resolution */
    TR_PASS_HIDES,        /* the same resolution: where something lies before it */
    /* of TR_SEE_SEQUENCE and TR_SEE_PUBLISHED */
    TR_PASS_WIPE,        /* boxes of masks, as are ROWS, NEAREST and MASKS: forgets the targets of the run before */
    TR_PASS_SEEDS,       /* depth of the targets of a run */
    TR_PASS_ROWS,        /* nearest pixel of a target in each row */
    TR_PASS_NEAREST,     /* nearest of all */
    TR_PASS_EXTENTS,     /* columns of texels a mask, as is FORMS: first and last pixel of a target in each row */
    TR_PASS_FORMS,       /* circle, ellipse or hull of these */
    TR_PASS_MASKS,       /* what the masks of a run leave of opacity, with those before */
    TR_PASS_PAINT_DEPTH, /* depth of solid units: their front-most surfaces */
    TR_PASS_PAINT,       /* units, blended; triangles of TR_UNIT_HOLLOW ones are to come back to front */
    TR_PASS_COUNT,       /* occluders a pixel */
    TR_PASS_PAINT_OVER,  /* full screen: from a target of our own into the host's */
    /* of TR_SEE_EXACT, besides SCENE, BLOCK, WIPE, SEEDS, ROWS and NEAREST */
    TR_PASS_REACH,          /* boxes: how far masks look through */
    TR_PASS_PEEL_UNITS,     /* the next layer of what is within masks */
    TR_PASS_KEEP,           /* full screen: whose it is */
    TR_PASS_SHARE,          /* boxes: what masks leave of the opacity of four layers */
    TR_PASS_COMPOSE_LAYERS, /* full screen, into the target */
    /* of tr_dynamic.in_parts */
    TR_PASS_TAKE, /* within tr_next_pass: copies depth or colour of what the host has drawn so far */
    TR_PASS_KIND_COUNT
} tr_pass_kind;

/* What the fragment shader of an object does in a pass: TR_RULE of shaders/surface_rules.glsl. */
typedef enum tr_rule {
    TR_RULE_FRONT,
    TR_RULE_FRONT_ALONE,
    TR_RULE_PEEL,
    TR_RULE_PEEL_ALONE,
    TR_RULE_PEEL_GROUP,
    TR_RULE_LAYER,
    TR_RULE_LAYER_MARKED,
    TR_RULE_LAYER_GROUP,
    TR_RULE_LIMIT,
    TR_RULE_LIMIT_SHEET,
    TR_RULE_LIMIT_BEHIND,
    TR_RULE_LIMIT_MARKED,
    TR_RULE_LIMIT_MARKED_SHEET,
    TR_RULE_OPAQUE,
    TR_RULE_OPAQUE_ENTERING,
    TR_RULE_COUNT, /* of those of tr_begin */
    /* Of tr_begin_dynamic, shaders/see_rules.glsl: tr_see_through in place of tr_surface. */
    TR_RULE_SEE_PLAIN = TR_RULE_COUNT, /* nothing: the host's own program, as it is */
    TR_RULE_SEE_BLOCK,
    TR_RULE_SEE_TARGET,
    TR_RULE_SEE_BEHIND,
    TR_RULE_SEE_YIELD,
    TR_RULE_SEE_DITHER,
    TR_RULE_SEE_HIDES,
    /* of shaders/seq_units.glsl */
    TR_RULE_SEE_DEPTH,
    TR_RULE_SEE_SEED,
    TR_RULE_SEE_BLEND,
    TR_RULE_SEE_BLEND_LAYERS,
    TR_RULE_SEE_COUNT,
    TR_RULE_SEE_PEEL,
    TR_RULE_SEE_END
} tr_rule;

#define TR_MAX_PASSES 64

typedef struct tr_plan_pass {
    tr_pass_kind kind;
    tr_rule rule;                 /* of surface passes */
    uint32_t classes;             /* which objects: bit (TR_TRANSPARENT and TR_TWO_SIDED of their flags) */
    uint32_t lines;               /* 0: surfaces; else which lines */
    int layer;                    /* that the pass draws, 0: the front-most */
    int clear_color, clear_depth; /* 1: the first to draw there */
    uint32_t bytes_per_pixel;     /* of textures that this pass is the first to need */
    int cull;                     /* 0: nothing, 1: back faces, 2: front faces */
    const char *why;
} tr_plan_pass;

typedef struct tr_plan {
    int pass_count;
    tr_plan_pass passes[TR_MAX_PASSES];
    uint32_t textures;        /* bits of those that are needed, see tr_plan_print */
    uint32_t bytes_per_pixel; /* of our own textures, per pixel of the target */
    int layers;               /* transparent surfaces that a pixel may show, one behind the other */
    int supersample;          /* texels of ours per side of a pixel */
    int grouped, mixed;       /* 1: groups show through; objects differ in their interiors */
    tr_interior interior;     /* of all, where not mixed; never TR_INTERIOR_AUTO */
    const char *why;          /* of interior and layers */
} tr_plan;

/* Pure CPU: the fewest passes that draw what is there and wished. Returns TR_INVALID_ARGUMENT for values out of range. */
TR_DEF tr_result tr_plan_make(const tr_scene *counts, const tr_wishes *wishes, tr_plan *plan);
/* The plan as text, a line a pass. Writes at most capacity bytes with a final 0; returns the length needed without it. */
TR_DEF size_t tr_plan_print(const tr_plan *plan, char *text, size_t capacity);
TR_DEF const char *tr_pass_kind_name(tr_pass_kind kind);
/* Counts an array of tr_object (or of larger structs that begin with one). */
TR_DEF tr_scene tr_scene_count(const void *objects, size_t count, size_t stride);

/* ---- the sequence ----------------------------------------------------------------------------------------------- */

#define TR_TEXTURE_UNITS 8

/* The state that differs from pass to pass, as data; GL enumerants by their numbers. Under TR_STATE_NONE the host applies it:
   framebuffer, viewport, clears (of the whole framebuffer, masks open), then the rest. */
typedef struct tr_state {
    uint32_t framebuffer;
    int viewport[4];
    uint32_t program;      /* built-in; the host's own may stand in for it in surface passes */
    uint32_t vertex_array; /* of full-screen passes */
    int vertex_count;      /* not 0: the host draws glDrawArrays(GL_TRIANGLES, 0, vertex_count); 0: its objects */
    uint32_t textures[TR_TEXTURE_UNITS];        /* on unit first_texture_unit + i, no sampler object; 0: not read */
    uint32_t texture_targets[TR_TEXTURE_UNITS]; /* GL_TEXTURE_2D or GL_TEXTURE_2D_ARRAY */
    int first_texture_unit;
    uint32_t
        edge_textures[2];    /* GL_TEXTURE_2D on the two units after those; 0: not read, and the unit is not touched */
    uint32_t uniform_buffer; /* bound to uniform_binding, this range of it */
    int uniform_binding, uniform_offset, uniform_size;
    int clear_color, clear_depth; /* 1: clear before drawing */
    float clear_color_value[4], clear_depth_value;
    int color_write; /* attachment 0 of the target, all of framebuffers of ours; others are never written */
    int srgb;        /* 1: GL_FRAMEBUFFER_SRGB on */
    int depth_test, depth_write;
    uint32_t depth_func;
    int blend;
    uint32_t blend_source, blend_destination, blend_source_alpha, blend_destination_alpha; /* equation: add */
    uint32_t cull_face;                                                                    /* 0: none */
    uint32_t front_face;
    uint32_t blend_equation; /* 0: add */
    int scissor[4];          /* x, y, width, height, for clears too; width 0: no scissor test */
} tr_state;

typedef struct tr_pass {
    tr_pass_kind kind;
    tr_rule rule;
    uint32_t classes;
    uint32_t lines; /* 0: draw surfaces; one of TR_LINES_*: draw these lines of the objects */
    int layer;      /* that the pass draws, 0: the front-most */
    const char *name;
    tr_state state;
    const uint32_t *units; /* of tr_begin_dynamic: indices into the host's array, in the order in which to draw them */
    size_t unit_count;
} tr_pass;

typedef struct tr_context tr_context;

/* Needs a current context. Returns NULL and the reason (result may be NULL) on failure; nothing is left behind. */
TR_DEF tr_context *tr_create(const tr_desc *desc, tr_result *result);
/* With the GL context current; NULL is fine. Inside of a frame it leaves GL state as the last pass set it. */
TR_DEF void tr_destroy(tr_context *tr);

TR_DEF tr_result tr_begin(tr_context *tr, const tr_frame *frame);
/* 1: draw all objects for which tr_pass_draws says so; 0: no pass is left, call tr_end. */
TR_DEF int tr_next_pass(tr_context *tr, tr_pass *pass);
TR_DEF int tr_pass_draws(const tr_pass *pass, const tr_object *object);
TR_DEF tr_result tr_end(tr_context *tr); /* may come early: what is drawn so far stays */

/* The number that shaders know an object by: id, group (from bit 24) and, in bit 31, whether its interiors are explicit. */
TR_DEF uint32_t tr_object_code(const tr_object *object, const tr_wishes *wishes);

/* ---- dynamic transparency --------------------------------------------------------------------------------------- */

/* What a unit is; without TR_UNIT_TARGET, a distractor: something that a target is seen through. */
enum {
    TR_UNIT_TARGET = 1,       /* is to be seen through what lies before it */
    TR_UNIT_IMPENETRABLE = 2, /* never made transparent; closes the mask of targets behind it */
    TR_UNIT_HOLLOW = 4,       /* each of its front faces is a layer; without it the front-most one alone */
    TR_UNIT_BACKDROP = 8,     /* ground, sky: never made transparent, and the host knows of no target behind it. Not for
                                 targets. Where there is one after all it closes the mask */
    TR_UNIT_ACTIVE = 16       /* a target that is seen inside of the lights only */
};

/* One a host's object, in a plain array or at the start of larger structs; read by tr_begin_dynamic, not kept. */
typedef struct tr_unit {
    uint32_t id;             /* stable, at most 65535; targets: from 1, unique among them; TR_SEE_EXACT: among all */
    uint32_t flags;          /* TR_UNIT_*; 0: a distractor */
    float center[3], radius; /* bounding sphere in the world. Not finite, or radius < 0: no bounds, the whole viewport;
                                radius 0: a point. Where middles give the order, a centre that is not finite is the
                                farthest */
    float importance; /* clamped to [0,1]; 0: the default, 1 for targets and 0 for others; negative: 0. An occluder
                                gives up clamp(target's - occluder's) of what the mask asks for: 1 and 0 give the paper */
    uint32_t group;   /* 0: on its own; members of a group are ordered by rank, lowest innermost (TR_SEE_SEQUENCE) */
    int rank;
    float fade; /* of a target's mask: 0 whole ... 1 gone, clamped; tr_advance moves it */
} tr_unit;

/* How units are seen: see docs/dynamic.md for the error and the price of each. */
typedef enum tr_see {
    TR_SEE_ONE_MASK,  /* one mask for all targets, blended; order-free, one more drawing of what is in masks */
    TR_SEE_DITHER,    /* the same mask, screen-door: one drawing, depth writes, no blending; for deferred pipelines */
    TR_SEE_EXACT,     /* layer by layer, as the truth has it, within the masks; ids of all units have to differ */
    TR_SEE_SEQUENCE,  /* whole objects back to front, a mask a target: Assarsson 2006, section 4, as amended */
    TR_SEE_PUBLISHED, /* the same as published: all masks multiply, each occluder on its own */
    TR_SEE_OFF,       /* plain drawing */
    TR_SEE_COUNT
} tr_see;

typedef enum tr_mask_shape {
    TR_MASK_OUTLINE, /* the target's own outline, grown */
    TR_MASK_CIRCLE,
    TR_MASK_ELLIPSE,
    TR_MASK_HULL
} tr_mask_shape;

typedef enum tr_mask_combine {
    TR_MASK_MIN,    /* where masks overlap the lowest opacity counts (rule R2) */
    TR_MASK_PRODUCT /* they multiply (Assarsson 2006, section 4) */
} tr_mask_combine;

typedef enum tr_occluders {
    TR_OCCLUDERS_TOGETHER, /* however many lie before a target, they leave it 1 - alpha_target */
    TR_OCCLUDERS_EACH      /* each leaves 1 - alpha_target of what is behind it (the paper) */
} tr_occluders;

/* A search light on the screen: full strength within radius, falling linearly to nothing over edge. */
typedef struct tr_light {
    float x, y, radius, edge; /* pixels of the viewport, y up */
} tr_light;
#define TR_MAX_LIGHTS 8
#define TR_MAX_MASK_WIDTH 100

/* What is wished of a frame. */
typedef struct tr_dynamic {
    tr_see see;
    tr_mask_shape shape;
    tr_mask_combine combine;
    tr_occluders occluders;
    float alpha_target;     /* opacity left before a target, in [0,1]; 0: 0.3; negative: 0 */
    float alpha_start;      /* and beside it, from where it rises to 1; 0: 0.1; negative: 0 */
    float width;            /* pixels in which it rises, at most TR_MAX_MASK_WIDTH; 0: 12; negative: none */
    int mask_divisor;       /* pixels a mask texel, 1, 2, 4 or 8; 0: 4, of the sequences 2, of TR_SEE_EXACT 1. The
                               target's own pixels are always as drawn */
    int layers;             /* layer control: only so many layers, from the eye, become transparent; 0: all */
    const tr_light *lights; /* of active targets; at most TR_MAX_LIGHTS */
    size_t light_count;
    uint32_t frame_index; /* of TR_SEE_DITHER: counts frames, for a pattern that averages out over time */
    int query;            /* 1: count what is hidden, for tr_query_hidden; one more pass, see there */
    float background[3];  /* colour where nothing is drawn, as the target was cleared to; a sky is better a backdrop. In
                             parts what is in the target stands for it */
    const void *units;    /* unit_count times tr_unit, unit_stride bytes apart; 0: sizeof(tr_unit) */
    size_t unit_count, unit_stride;
    float view[16], projection[16]; /* column-major: world to eye (w = 1), eye to clip */
    int in_parts; /* of TR_SEE_ONE_MASK and TR_SEE_DITHER. 1: TR_PASS_SCENE comes in parts, so that hardly anything is
                     drawn twice: see tr_begin_dynamic. The host clears before that, and draws no unit but pass.units */
} tr_dynamic;

#define TR_MAX_SEE_PASSES 20

typedef struct tr_see_pass {
    tr_pass_kind kind;
    tr_rule rule;        /* of passes that the host draws */
    uint32_t unit_count; /* that the host draws in it */
    const char *why;
    uint32_t times; /* how often in a frame: of TR_PASS_BEHIND, TR_SEE_EXACT and the sequences */
} tr_see_pass;

/* What runs, and why. */
typedef struct tr_see_plan {
    tr_see see; /* TR_SEE_OFF where nothing would differ from plain drawing */
    const char *why;
    uint32_t targets, targets_in_view; /* by their bounds */
    uint32_t masks;                    /* of targets that something may lie before */
    int pass_count;
    tr_see_pass passes[TR_MAX_SEE_PASSES];
    int rectangle[4]; /* x, y, width, height of the viewport: holds all masks */
    uint32_t tiles;   /* rectangles that full-screen passes cover, in place of all of it */
    float covered;    /* by them, share of the viewport */
    uint64_t bytes;   /* of textures that are needed */
    uint32_t runs;    /* of masks, in TR_SEE_EXACT and the sequences: those of one run do not overlap */
    /* Of TR_SEE_EXACT: layers peeled a pixel, and how many there may be at most, by the units' bounds. Where these are more,
       what is behind the first layers - 1, but before the farthest target that a pixel shows, may be left out of the picture.
       Targets farthest at their pixels are not; nor is the sum of targets' weights ever less than 1 - alpha_target. */
    uint32_t layers, layer_bound;
    int in_parts;          /* whether the scene comes in parts */
    const char *parts_why; /* why not, where it was asked for; else 0 */
} tr_see_plan;

/* Begins a frame; then tr_next_pass and tr_end as always: in each pass the host draws pass.units, with the program for
   pass.rule. Of the frame: framebuffer, x, y, width, height, what is said of built-in shading, and TR_WISH_SRGB (the shaders
   write light, the target encodes it). The rest is not looked at.
   In TR_PASS_SCENE the host draws all that it has, as it does without this header: its own target and attachments, its own
   state. Before it the state is what desc.state says of the end of a frame, but for our texture units and uniform buffer.
   Where no target may be hidden, or nothing that yields may lie before one, this is the only pass and no GL call is made.
   With TR_RULE_SEE_PLAIN the host's program is as it always was; tr_set_material puts the built-in one to use.
   With TR_SEE_ONE_MASK and TR_SEE_DITHER a host that draws instances in batches may draw more than pass.units: shaders know
   by the code what is not wanted. With the other rungs it draws these alone, with the sequences in their order.
   With dynamic.in_parts there may be up to four of TR_PASS_SCENE, each with units of its own that the others do not have,
   and pass.rule tells the program. What never yields comes first, and its depth and colour are copied from the target in
   between. So the target is cleared before tr_begin_dynamic, to the far depth; nothing else is drawn there before; the
   depth range is 0 to 1; and polygons are not offset. With active or fading targets, such of importance below 1 and
   queries, targets are drawn again against the copy: the host's own programs for them declare gl_Position invariant, too,
   and compute it as their variants do. The scene comes whole where the plan says so (tr_see_plan.parts_why): with
   TR_STATE_NONE; into multisampled targets, those without depth or of integers, and where TR_WISH_SRGB says another
   encoding than the target's; with targets drawn again, into a viewport that is not at the target's corner.
   On an error no pass comes, TR_PASS_SCENE neither: the host draws its scene as it does without this header.
   TR_INVALID_ARGUMENT: matrices or numbers that are not finite, values out of range, an id out of range or of two
   targets; lights or units that are NULL; what the rung cannot do (see docs/dynamic.md). */
TR_DEF tr_result tr_begin_dynamic(tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic);
TR_DEF size_t tr_see_plan_print(const tr_see_plan *plan, char *text, size_t capacity);

/* What shaders know a unit by, for tr_see_through: id, flags from bit 16, from bit 24 importance in 255ths; of targets
   less what has faded. A uniform, an attribute of instances or a texel. */
TR_DEF uint32_t tr_unit_code(const tr_unit *unit);
/* Pixels of a viewport that a unit may cover: x, y, width, height, the least by its sphere. 0: none; 1: some. Touches the
   plane of the eye: the whole viewport. */
TR_DEF int tr_unit_rectangle(const tr_unit *unit, const float view[16], const float projection[16], int width,
                             int height, int rectangle[4]);
/* Moves each unit's fade toward wanted[i] (NULL: toward 0), by seconds / fade_time; pure CPU. Two steps of half the time are
   one of the whole, to rounding. fade_time not above 0: at once; seconds not above 0, or not finite: nothing. */
TR_DEF void tr_advance(void *units, size_t count, size_t stride, const float *wanted, float seconds, float fade_time);

/* How much of a target is hidden, by something that is neither a target nor made transparent for it yet. */
typedef struct tr_hidden {
    uint32_t id;
    uint32_t
        pixels; /* that it covers and nothing impenetrable hides; in steps of 16, as one of 4 by 4 pixels is looked at */
    uint32_t hidden; /* of these, behind something */
} tr_hidden;
/* Of the last frame with dynamic.query whose answer has arrived, two or three frames ago; never waits. Targets that cover
   nothing are left out; by rising id. Writes at most capacity, and the number there are to count. */
TR_DEF tr_result tr_query_hidden(tr_context *tr, tr_hidden *out, size_t capacity, size_t *count);

/* ---- edges for alpha -------------------------------------------------------------------------------------------- */

/* The silhouettes (or whatever lines) of one object, that alpha's distance is measured to: plain arrays, from
   silhouette.h or anything else, not needed after tr_set_edges. */
typedef struct tr_edges {
    const float *positions; /* x, y, z of points in object space */
    size_t position_stride; /* bytes; 0: 12 */
    size_t position_count;
    const uint32_t *ends; /* two indices of points an edge; an array of sil_edge begins with them */
    size_t end_stride;    /* bytes; 0: 8 */
    /* 0: no silhouette, so that alpha is 0. Edges with a point that is not finite count as none. */
    size_t edge_count;
    /* For TR_ALPHA_EXACT: which edges of `ends`, edge_count of them, in an order in which neighbours are close
       (sil_edge_tree_order). NULL: as they come, slower if that is not so. */
    const uint32_t *order;
    /* For TR_ALPHA_CANDIDATES, as sil_candidates makes them: the edges that triangle i carries are
       candidates[offsets[i]] ... candidates[offsets[i + 1] - 1]; offsets has triangle_count + 1 numbers. */
    const uint32_t *offsets, *candidates;
    size_t triangle_count;
    float model[9]; /* object to world, column-major 3x3: distances are in world units. All zero: the identity */
} tr_edges;

/* Where an object's edges are on the GPU, as the two uniforms of alpha_vertex.glsl and alpha_fragment.glsl. */
typedef struct tr_edge_set {
    float frame[16];    /* vec4 tr_edge_frame[4] */
    uint32_t ranges[4]; /* uvec4 tr_edge_ranges */
} tr_edge_set;

/* Uploads the edges of all objects of the frames to come into two textures of ours, and fills `sets`, one an object. Call
   it when a silhouette has changed, before tr_begin; GL state is left as found. Nothing is created or allocated while the
   sizes change by less than a quarter. Either order or offsets, candidates; a set made for one rung is searched whole,
   which is right and slow, by the other. count 0 frees the textures. TR_INVALID_ARGUMENT: NULL, an index out of range,
   offsets that fall, a matrix that is not finite. TR_TOO_LARGE: more than 1024 * GL_MAX_TEXTURE_SIZE texels of 16 bytes (two
   an edge, and 2/7 of one for the hierarchy) or of 4 (one a triangle, one a candidate). TR_WRONG_ORDER: inside of a
   frame. After an error the sets of before are still good. */
TR_DEF tr_result tr_set_edges(tr_context *tr, const tr_edges *edges, size_t count, tr_edge_set *sets);

/* An image of the front-most transparent surfaces, drawn by the host before the frame, as large as that or not. */
typedef struct tr_outlines {
    uint32_t depth_texture; /* GL_TEXTURE_2D, depth or red, without comparison and complete; far where nothing is */
    uint32_t id_texture;    /* GL_TEXTURE_2D of one unsigned integer: which object; 0: outlines from depth alone */
    int width, height;      /* of both; at most 65535 */
    float projection[16];   /* with which it was drawn */
} tr_outlines;

/* For TR_ALPHA_IMAGE: finds the outlines in an image, and each pixel's nearest by jump flooding. For hosts that have no
   meshes on the CPU: sees what is front-most and nothing of hidden outlines, measures across the picture (what slants
   away is nearer to its outline than it is), and is right to a pixel. Draws 2 + log2(size) times over the image into two
   textures of ours, 4 bytes a pixel each, made when the size changes; GL state is left as found, and nothing is waited
   for. TR_WRONG_ORDER: inside of a frame. */
TR_DEF tr_result tr_find_outlines(tr_context *tr, const tr_outlines *image);
/* The uniform tr_outline of alpha_fragment.glsl, for programs of the host's, within a frame. */
TR_DEF void tr_outline_uniform(const tr_context *tr, float uniform[3]);

/* Uniforms of the built-in surface programs. */
typedef struct tr_material {
    float model_view_projection[16];    /* column-major */
    float normal_matrix[9];             /* column-major 3x3: object space to the space of tr_frame.light */
    float color[4];                     /* rgb added to attribute 3; alpha on the silhouette, of transparent objects */
    float d_max, k;                     /* equation 2; d_max = 0: alpha is constant */
    float model[16];                    /* column-major, object to the space of the segments; for TR_WISH_ENTERING */
    int crossing_first, crossing_count; /* this object's among the segments of tr_set_crossings */
    uint32_t object;                    /* tr_object_code, or the id alone without groups and methods of its own */
    const tr_edge_set *edges;           /* of TR_ALPHA_CANDIDATES and TR_ALPHA_EXACT; NULL: no edges */
    uint32_t first_triangle;            /* of TR_ALPHA_CANDIDATES: added to the triangles' numbers */
} tr_material;

/* A triangle mesh, as far as its shape goes. */
typedef struct tr_mesh {
    const float *positions; /* x y z */
    const uint32_t *indices;
    size_t vertex_count, index_count;
    float model[16]; /* column-major, to the common space; all zeros: none */
} tr_mesh;

/* Pure CPU: where the surface of a mesh crosses those of others, as segments of six floats in the common space. Writes at
   most capacity segments; returns how many there are, SIZE_MAX without memory or for bad arguments, such as a model that
   is not finite. Each pair of triangles that cross gives one; triangles with an index out of range or a number that is
   not finite give none, nor do such as touch or lie in one plane. Ends are rounded to float. Time grows with the
   triangles whose extents along x overlap. */
TR_DEF size_t tr_crossings(const tr_mesh *mesh, const tr_mesh *others, size_t other_count, float *segments,
                           size_t capacity);
/* For TR_WISH_ENTERING; outside of a frame; count may be 0. The segments are copied, and GL state is left as found. No
   texture is made anew while their number changes by less than a quarter. TR_TOO_LARGE: more than 512 *
   GL_MAX_TEXTURE_SIZE of them. */
TR_DEF tr_result tr_set_crossings(tr_context *tr, const float *segments, size_t count);

/* For surface passes drawn with the built-in program; call it after tr_next_pass, before the draw call. */
TR_DEF void tr_set_material(tr_context *tr, const tr_pass *pass, const tr_material *material);

typedef enum tr_stage { TR_VERTEX, TR_FRAGMENT, TR_STAGE_COUNT } tr_stage;

/* Strings to put before a shader of the host's, the first of them the line of #version alone; valid as long as the
   context; NULL for bad arguments. */
TR_DEF const char *const *tr_glsl(const tr_context *tr, tr_stage stage, tr_rule rule, int *count);
/* Strings to put after those of tr_glsl and before the host's own: tr_alpha_vertex(position, distance, triangle) for the
   vertex stage, tr_alpha() for the fragment stage (see shaders/alpha_vertex.glsl). The host sets the uniforms
   tr_falloff (d_max, k) and, for the last two rungs, tr_edge_frame and tr_edge_ranges from a tr_edge_set. NULL for bad
   arguments. */
TR_DEF const char *const *tr_alpha_glsl(const tr_context *tr, tr_stage stage, tr_alpha alpha, int *count);
/* Once for each linked program of the host's that has tr_glsl in it. */
TR_DEF tr_result tr_prepare_program(tr_context *tr, uint32_t program);

typedef struct tr_info {
    int es;                      /* 1: OpenGL ES */
    int version;                 /* 330 for 3.3; after desc.max_gl_version */
    uint64_t bytes;              /* of GL textures held now */
    const tr_plan *plan;         /* of the last tr_begin */
    const tr_see_plan *see_plan; /* of the last tr_begin_dynamic */
} tr_info;
TR_DEF tr_info tr_get_info(const tr_context *tr);
/* Gives the textures back, e.g. when illustrations pause; the next frame makes them anew. Edges and outlines have to be
   given anew before it; crossings stay. TR_WRONG_ORDER: inside of a frame. */
TR_DEF tr_result tr_release(tr_context *tr);

TR_DEF const char *tr_result_string(tr_result result);
/* Equation 2 as the shaders compute it: 1 - (d / d_max)^k in [0,1]; 1 where d or d_max is not > 0 (NaN included); 0
   elsewhere where k is not > 0. */
TR_DEF float tr_view_alpha(float d, float d_max, float k);

#ifdef __cplusplus
}
#endif

#endif /* TRANSPARENCY_H */

#ifdef TRANSPARENCY_IMPLEMENTATION
#ifndef TRANSPARENCY_IMPLEMENTATION_ONCE
#define TRANSPARENCY_IMPLEMENTATION_ONCE

#include <math.h>
#include <string.h>

#ifndef TR_MALLOC
#include <stdlib.h>
#define TR_MALLOC(size) malloc(size)
#define TR_FREE(block) free(block)
#endif

#ifdef TR_STATIC
#define TR_I_API TR_DEF
#else
#define TR_I_API
#endif

#if defined(_WIN32) && !defined(_WIN64)
#define TR_I_GLAPI __stdcall
#else
#define TR_I_GLAPI
#endif

/* clang-format off */
/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */
/* clang-format off */
static const char *const tr_i_shader_alpha_fragment_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// View-dependent alpha, fragment stage: tr_alpha() is equation 2 of Diepstraten 2002 at this pixel, by the rung TR_ALPHA.\n"
    "#define TR_ALPHA_DISTANCE 0\n"
    "#define TR_ALPHA_PUBLISHED 1\n"
    "#define TR_ALPHA_CANDIDATES 2\n"
    "#define TR_ALPHA_EXACT 3\n"
    "#define TR_ALPHA_IMAGE 4\n"
    "\n"
    "uniform highp vec2 tr_falloff;\n"
    "#if TR_ALPHA == TR_ALPHA_DISTANCE || TR_ALPHA == TR_ALPHA_PUBLISHED\n"
    "in highp float tr_v_falloff;\n"
    "#elif TR_ALPHA == TR_ALPHA_IMAGE\n"
    "uniform highp usampler2D tr_outlines; // the nearest outline's pixel\n"
    "uniform highp vec3 tr_outline;        // size of its pixels in the world where w is 1, its pixels a fragment\n"
    "#define TR_NOWHERE 65535u\n"
    "#else\n"
    "uniform highp vec4 tr_edge_frame[4]; // [3].w: the unit of the frame, in the world\n"
    "uniform highp uvec4 tr_edge_ranges;  // tr_edge_set.ranges\n"
    "uniform highp sampler2D tr_edge_segments;\n"
    "in highp vec3 tr_v_place;\n"
    "#if TR_ALPHA == TR_ALPHA_CANDIDATES\n"
    "uniform highp usampler2D tr_edge_lists;\n"
    "#ifndef TR_TRIANGLE\n"
    "flat in highp uint tr_v_triangle;\n"
    "#define TR_TRIANGLE tr_v_triangle\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "#define TR_NO_LIST 0xffffffffu\n"
    "#define TR_FAR 3.0e38\n"
    "\n"
    "// Both textures are arrays in rows of 1024.\n"
    "highp vec4 tr_edge_texel(highp uint at)\n"
    "{\n"
    "    return texelFetch(tr_edge_segments, ivec2(at & 1023u, at >> 10u), 0);\n"
    "}\n"
    "\n"
    "// The square of the distance to one segment: start and 1 / length^2 (0: a point), then the way to its end.\n"
    "highp float tr_edge_square(highp uint segment)\n"
    "{\n"
    "    highp uint at = tr_edge_ranges.x + 2u * segment;\n"
    "    highp vec4 start = tr_edge_texel(at);\n"
    "    highp vec3 way = tr_edge_texel(at + 1u).xyz;\n"
    "    highp vec3 from = tr_v_place - start.xyz;\n"
    "    from -= clamp(dot(from, way) * start.w, 0.0, 1.0) * way;\n"
    "    return dot(from, from);\n"
    "}\n"
    "\n"
    "highp float tr_edge_square_of_range(highp uint first, highp uint end, highp float least)\n"
    "{\n"
    "    for (highp uint i = first; i < end; ++i)\n"
    "        least = min(least, tr_edge_square(i));\n"
    "    return least;\n"
    "}\n"
    "\n"
    "#if TR_ALPHA == TR_ALPHA_CANDIDATES\n"
    "highp uint tr_edge_entry(highp uint at)\n"
    "{\n"
    "    return texelFetch(tr_edge_lists, ivec2(at & 1023u, at >> 10u), 0).r;\n"
    "}\n"
    "\n"
    "highp float tr_edge_least()\n"
    "{\n"
    "    if (tr_edge_ranges.w == TR_NO_LIST)\n"
    "        return tr_edge_square_of_range(0u, tr_edge_ranges.y, TR_FAR);\n"
    "    highp uint offset = tr_edge_ranges.z + TR_TRIANGLE;\n"
    "    highp uint first = tr_edge_entry(offset);\n"
    "    // No list is longer than there are edges: a triangle that has none, drawn by mistake, is no endless loop.\n"
    "    highp uint count = min(tr_edge_entry(offset + 1u) - first, tr_edge_ranges.y);\n"
    "    highp float least = TR_FAR;\n"
    "    for (highp uint i = 0u; i < count; ++i)\n"
    "        least = min(least, tr_edge_square(tr_edge_entry(tr_edge_ranges.w + first + i)));\n"
    "    return least;\n"
    "}\n"
    "#else\n"
    "// Boxes of eight segments, of eight boxes and so on, each before its children, from texel x + 2 y on: middle and the\n"
    "// number of the box after its last descendant; half size and the first of its segments, or -1.\n"
    "highp float tr_edge_box_square(highp uint box, out highp uint next, out highp float leaf)\n"
    "{\n"
    "    highp uint at = tr_edge_ranges.x + 2u * (tr_edge_ranges.y + box);\n"
    "    highp vec4 middle = tr_edge_texel(at), extent = tr_edge_texel(at + 1u);\n"
    "    highp vec3 outside = max(abs(tr_v_place - middle.xyz) - extent.xyz, 0.0);\n"
    "    next = max(uint(middle.w), box + 1u);\n"
    "    leaf = extent.w;\n"
    "    return dot(outside, outside);\n"
    "}\n"
    "\n"
    "highp float tr_edge_square_of_leaf(highp float leaf, highp float least)\n"
    "{\n"
    "    highp uint first = uint(leaf);\n"
    "    return tr_edge_square_of_range(first, min(first + 8u, tr_edge_ranges.y), least);\n"
    "}\n"
    "\n"
    "// Down to the box that is nearest each time: a first guess, so that the search after it passes most boxes by.\n"
    "highp float tr_edge_guess()\n"
    "{\n"
    "    highp uint box = 0u, end = 0u, next = 0u;\n"
    "    highp float leaf = 0.0;\n"
    "    tr_edge_box_square(0u, end, leaf);\n"
    "    while (leaf < 0.0) {\n"
    "        highp float least = TR_FAR, leaf_here = 0.0;\n"
    "        highp uint best_end = end, best = box + 1u;\n"
    "        for (highp uint child = box + 1u; child < end; child = next) {\n",
    "#line 104\n"
    "            highp float square = tr_edge_box_square(child, next, leaf_here);\n"
    "            if (square < least) {\n"
    "                least = square;\n"
    "                best = child;\n"
    "                best_end = next;\n"
    "                leaf = leaf_here;\n"
    "            }\n"
    "        }\n"
    "        if (best >= tr_edge_ranges.z)\n"
    "            return TR_FAR;\n"
    "        box = best;\n"
    "        end = best_end;\n"
    "    }\n"
    "    return tr_edge_square_of_leaf(leaf, TR_FAR);\n"
    "}\n"
    "\n"
    "highp float tr_edge_least()\n"
    "{\n"
    "    if (tr_edge_ranges.w != TR_NO_LIST)\n"
    "        return tr_edge_square_of_range(0u, tr_edge_ranges.y, TR_FAR);\n"
    "    highp float least = tr_edge_guess(), leaf = 0.0;\n"
    "    highp uint next = 0u;\n"
    "    for (highp uint box = 0u; box < tr_edge_ranges.z; box = next) {\n"
    "        bool skip = tr_edge_box_square(box, next, leaf) >= least;\n"
    "        if (!skip && leaf >= 0.0)\n"
    "            least = tr_edge_square_of_leaf(leaf, least);\n"
    "        if (!skip)\n"
    "            next = box + 1u;\n"
    "    }\n"
    "    return least;\n"
    "}\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "float tr_alpha()\n"
    "{\n"
    "#if TR_ALPHA == TR_ALPHA_PUBLISHED\n"
    "    return tr_v_falloff;\n"
    "#elif TR_ALPHA == TR_ALPHA_DISTANCE\n"
    "    return tr_view_alpha(tr_v_falloff, tr_falloff.x, tr_falloff.y);\n"
    "#elif TR_ALPHA == TR_ALPHA_IMAGE\n"
    "    highp vec2 place = gl_FragCoord.xy * tr_outline.yz;\n"
    "    highp uvec2 nearest = texelFetch(tr_outlines, ivec2(place), 0).rg;\n"
    "    // gl_FragCoord.w is 1 / w: the distance along the view, or 1 where parallel lines stay parallel.\n"
    "    highp float distance = length(vec2(nearest) + 0.5 - place) * tr_outline.x / gl_FragCoord.w;\n"
    "    return tr_view_alpha(nearest.x == TR_NOWHERE ? 3.0e38 : distance, tr_falloff.x, tr_falloff.y);\n"
    "#else\n"
    "    if (!tr_positive(tr_falloff.x))\n"
    "        return 1.0;\n"
    "    highp float distance = TR_FAR; // without an edge, as with the eye inside: no silhouette anywhere\n"
    "    if (tr_edge_ranges.y > 0u)\n"
    "        distance = sqrt(tr_edge_least()) * tr_edge_frame[3].w;\n"
    "    return tr_view_alpha(distance, tr_falloff.x, tr_falloff.y);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const tr_i_shader_alpha_law_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// View-dependent alpha, Diepstraten 2002, equation 2: alpha = 1 - (d / d_max)^k, clamped to [0, 1].\n"
    "//\n"
    "// d: distance to the nearest silhouette, d_max: farthest surface point from the object's centre, both in one unit.\n"
    "// alpha = 1 at d = 0 for every k >= 0, wherever d_max <= 0, and where either is NaN; alpha = 0 from d = d_max on.\n"
    "// k = 0, and what is no positive number, leaves the silhouette alone opaque.\n"
    "\n"
    "// x > 0, infinity included, by its bits: compilers may read !(x > 0.0) as x <= 0.0, and NaN is neither.\n"
    "bool tr_positive(highp float x)\n"
    "{\n"
    "    return floatBitsToUint(x) - 1u < 0x7f800000u;\n"
    "}\n"
    "\n"
    "float tr_view_alpha(highp float d, highp float d_max, highp float k)\n"
    "{\n"
    "    if (!tr_positive(d) || !tr_positive(d_max))\n"
    "        return 1.0;\n"
    "    if (d >= d_max || !tr_positive(k))\n"
    "        return 0.0;\n"
    "    // The floor keeps log2 finite where a driver flushes denormals to zero.\n"
    "    highp float ratio = max(d / d_max, 1.0e-30);\n"
    "    return clamp(1.0 - exp2(k * log2(ratio)), 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_alpha_vertex_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// View-dependent alpha, vertex stage: what the rung TR_ALPHA of the ladder needs from the vertices.\n"
    "//\n"
    "// A vertex shader calls tr_alpha_vertex(position, distance, triangle) once: the vertex in object space; its distance to\n"
    "// the nearest silhouette, which the first two rungs read; and the number of its triangle, for the third, which reads that\n"
    "// of the triangle's last vertex. An attribute, for gl_PrimitiveID is not in ES 3.0, and Mesa's softpipe draws nothing\n"
    "// with it and counts gl_VertexID anew every few thousand vertices. A host that trusts its drivers defines TR_TRIANGLE as\n"
    "// uint(gl_PrimitiveID) before these strings in both stages, passes 0, and draws by indices.\n"
    "#define TR_ALPHA_DISTANCE 0   // distance at vertices, alpha a pixel\n"
    "#define TR_ALPHA_PUBLISHED 1  // alpha at vertices: Diepstraten 2002\n"
    "#define TR_ALPHA_CANDIDATES 2 // distance a pixel, to the edges that the triangle carries\n"
    "#define TR_ALPHA_EXACT 3      // distance a pixel, to all edges of the object\n"
    "#define TR_ALPHA_IMAGE 4      // distance a pixel, to outlines found in an image\n"
    "\n"
    "uniform highp vec2 tr_falloff; // d_max, k of equation 2; d_max = 0 for a constant alpha\n"
    "#if TR_ALPHA == TR_ALPHA_DISTANCE || TR_ALPHA == TR_ALPHA_PUBLISHED\n"
    "out highp float tr_v_falloff; // the distance, or alpha\n"
    "#elif TR_ALPHA != TR_ALPHA_IMAGE\n"
    "uniform highp vec4 tr_edge_frame[4]; // tr_edge_set.frame: columns, then the middle\n"
    "out highp vec3 tr_v_place;           // in the frame of the edges\n"
    "#if TR_ALPHA == TR_ALPHA_CANDIDATES && !defined(TR_TRIANGLE)\n"
    "flat out highp uint tr_v_triangle;\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "void tr_alpha_vertex(highp vec3 position, highp float distance, highp uint triangle)\n"
    "{\n"
    "#if TR_ALPHA == TR_ALPHA_DISTANCE\n"
    "    // No two points are further apart than 2 d_max; what is infinite could not be interpolated.\n"
    "    tr_v_falloff = min(distance, min(2.0 * tr_falloff.x, 1.0e30));\n"
    "#elif TR_ALPHA == TR_ALPHA_PUBLISHED\n"
    "    tr_v_falloff = tr_view_alpha(distance, tr_falloff.x, tr_falloff.y);\n"
    "#elif TR_ALPHA != TR_ALPHA_IMAGE\n"
    "    highp vec3 from = position - tr_edge_frame[3].xyz;\n"
    "    tr_v_place = from.x * tr_edge_frame[0].xyz + from.y * tr_edge_frame[1].xyz + from.z * tr_edge_frame[2].xyz;\n"
    "#if TR_ALPHA == TR_ALPHA_CANDIDATES && !defined(TR_TRIANGLE)\n"
    "    tr_v_triangle = triangle;\n"
    "#endif\n"
    "#endif\n"
    "}\n",
    0};
static const char *const tr_i_shader_chain_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Fragment stage. Which layers of a semantic group are shown: a chain from the front-most face on.\n"
    "//\n"
    "// A layer whose owner was not written is not of the group or too far away; one of an object that an earlier layer shows\n"
    "// is that object's next face, which never shines through. Either ends the chain.\n"
    "#if TR_CHAIN\n"
    "uniform highp sampler2DArray tr_front_owner; // by layer: ids as depths, 1 where none was written\n"
    "\n"
    "// How many of the first `count` layers are shown.\n"
    "int tr_chain(ivec2 pixel, int count)\n"
    "{\n"
    "    for (int i = 1; i < count; ++i) {\n"
    "        highp float owner = texelFetch(tr_front_owner, ivec3(pixel, i), 0).r;\n"
    "        if (owner == 1.0)\n"
    "            return i;\n"
    "        for (int j = 0; j < i; ++j)\n"
    "            if (texelFetch(tr_front_owner, ivec3(pixel, j), 0).r == owner)\n"
    "                return i;\n"
    "    }\n"
    "    return count;\n"
    "}\n"
    "#endif\n",
    0};
static const char *const tr_i_shader_compose_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Transparent layers over opaque things, into the host's target; Diepstraten 2002, sections 5 and 7.\n"
    "//\n"
    "// alpha_t, C_t: a transparent surface; w, C_d: what is behind it, an opaque thing or the background, which is what the\n"
    "// host's target holds. All three blendings have the form rgb + a * target, drawn with the blend function\n"
    "// (ONE, SRC_ALPHA), so that the target's own alpha is neither needed nor touched.\n"
    "//\n"
    "// TR_SUPERSAMPLE: our textures have that many texels along each side of a target's pixel, averaged here.\n"
    "#define TR_BLENDING_OVER 0\n"
    "#define TR_BLENDING_NORMALISED 1\n"
    "#define TR_BLENDING_PUBLISHED 2\n"
    "\n"
    "#if TR_HAS_SCENE\n"
    "uniform highp sampler2D tr_scene_depth;\n"
    "#endif\n"
    "#if TR_HAS_OPAQUE\n"
    "uniform highp sampler2D tr_opaque_color; // a = 1 where an opaque thing is\n"
    "#endif\n"
    "#if TR_LAYERS > 0\n"
    "uniform highp sampler2DArray tr_front_depth; // of layers 0, 2, 4, ...\n"
    "uniform highp sampler2DArray tr_layer_color;\n"
    "#endif\n"
    "#if TR_LAYERS > 1\n"
    "uniform highp sampler2DArray tr_odd_depth; // of layers 1, 3, 5, ...\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "#ifdef TR_REVERSED_Z\n"
    "#define TR_BEHIND(a, b) ((a) < (b))\n"
    "#else\n"
    "#define TR_BEHIND(a, b) ((a) > (b))\n"
    "#endif\n"
    "\n"
    "// Display values to light, IEC 61966-2-1, where light is what is blended.\n"
    "highp vec3 tr_light_of(highp vec3 color)\n"
    "{\n"
    "#if TR_SRGB\n"
    "    return mix(color * (1.0 / 12.92), pow((color + 0.055) * (1.0 / 1.055), vec3(2.4)), step(0.04045, color));\n"
    "#else\n"
    "    return color;\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if TR_LAYERS > 0\n"
    "highp float tr_depth_of_layer(ivec2 pixel, int layer)\n"
    "{\n"
    "#if TR_LAYERS > 1\n"
    "    if ((layer & 1) != 0)\n"
    "        return texelFetch(tr_odd_depth, ivec3(pixel, layer >> 1), 0).r;\n"
    "#endif\n"
    "    return texelFetch(tr_front_depth, ivec3(pixel, layer >> 1), 0).r;\n"
    "}\n"
    "\n"
    "// A layer's surface over rgb + a * target.\n"
    "highp vec4 tr_over(highp vec4 surface, highp vec4 behind, highp float weight)\n"
    "{\n"
    "#if TR_BLENDING == TR_BLENDING_OVER\n"
    "    weight = 1.0 - surface.a;\n"
    "#elif TR_BLENDING == TR_BLENDING_NORMALISED\n"
    "    highp float total = surface.a + weight;\n"
    "    surface.a = total > 0.0 ? surface.a / total : 0.0;\n"
    "    weight = 1.0 - surface.a;\n"
    "#endif\n"
    "    // The published sum may be above one; where the target adds its own part, its format clamps.\n"
    "    return vec4(min(surface.a * tr_light_of(surface.rgb) + weight * behind.rgb, 1.0), weight * behind.a);\n"
    "}\n"
    "#endif\n"
    "\n"
    "// One texel: rgb + a * target; depth of what is seen there, TR_CLEAR_DEPTH where nothing is.\n"
    "highp vec4 tr_compose(ivec2 pixel, out highp float depth)\n"
    "{\n"
    "    highp vec4 result = vec4(0.0, 0.0, 0.0, 1.0);\n"
    "    highp float weight = tr_weights.y;\n"
    "    bool hides = TR_PUBLISHED != 0; // published: the limit hides transparent surfaces too\n"
    "    depth = TR_CLEAR_DEPTH;\n"
    "#if TR_HAS_SCENE\n"
    "    highp float scene = texelFetch(tr_scene_depth, pixel, 0).r;\n"
    "#else\n"
    "    highp float scene = TR_CLEAR_DEPTH;\n"
    "#endif\n"
    "#if TR_HAS_OPAQUE\n"
    "    highp vec4 opaque = texelFetch(tr_opaque_color, pixel, 0);\n"
    "    if (opaque.a > 0.5) {\n"
    "        result = vec4(tr_light_of(opaque.rgb), 0.0);\n"
    "        weight = tr_weights.x;\n"
    "        hides = true;\n"
    "        depth = scene;\n"
    "    }\n"
    "#endif\n"
    "#if TR_LAYERS > 0\n"
    "    bool first = true;\n"
    "#if TR_CHAIN\n"
    "    int layers = tr_chain(pixel, TR_LAYERS);\n"
    "#else\n"
    "    const int layers = TR_LAYERS;\n"
    "#endif\n"
    "    for (int layer = layers - 1; layer >= 0; --layer) {\n"
    "        highp float at = tr_depth_of_layer(pixel, layer);\n"
    "        if (at == TR_CLEAR_DEPTH || (hides && TR_BEHIND(at, scene)))\n"
    "            continue;\n"
    "#if TR_BLEND_COLOR\n"
    "        if (first && result.a > 0.0)\n"
    "            result = vec4(tr_light_of(tr_blend.rgb), 0.0);\n"
    "#endif\n"
    "        first = false;\n"
    "        result = tr_over(texelFetch(tr_layer_color, ivec3(pixel, layer), 0), result, weight);\n"
    "        depth = at;\n"
    "    }\n"
    "#endif\n"
    "    return result;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 corner = (ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy)) * TR_SUPERSAMPLE;\n"
    "    highp vec4 sum = vec4(0.0);\n"
    "    highp float nearest = TR_CLEAR_DEPTH;\n"
    "    for (int y = 0; y < TR_SUPERSAMPLE; ++y) {\n"
    "        for (int x = 0; x < TR_SUPERSAMPLE; ++x) {\n",
    "#line 120\n"
    "            highp float depth;\n"
    "            sum += tr_compose(corner + ivec2(x, y), depth);\n"
    "            nearest = TR_BEHIND(nearest, depth) ? depth : nearest;\n"
    "        }\n"
    "    }\n"
    "    tr_color = sum * (1.0 / float(TR_SUPERSAMPLE * TR_SUPERSAMPLE));\n"
    "    if (nearest == TR_CLEAR_DEPTH && tr_color.a == 1.0)\n"
    "        discard;\n"
    "    gl_FragDepth = nearest;\n"
    "}\n",
    0};
static const char *const tr_i_shader_cool_to_warm_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Cool-to-warm shading, Gooch 1999, section 3.2 (the model of Gooch 1998): hue carries orientation, so that black is\n"
    "// left for lines and white for highlights.\n"
    "//\n"
    "// normal and light: unit vectors in one space, light points toward the light. cool.a and warm.a say how much of the\n"
    "// diffuse colour is mixed into the cool and the warm end.\n"
    "vec3 tr_cool_to_warm(vec3 diffuse, vec3 normal, vec3 light, vec4 cool, vec4 warm)\n"
    "{\n"
    "    float warmth = 0.5 + 0.5 * dot(normal, light);\n"
    "    vec3 cool_end = cool.rgb + cool.a * diffuse;\n"
    "    vec3 warm_end = warm.rgb + warm.a * diffuse;\n"
    "    return clamp(mix(cool_end, warm_end, warmth), 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_copy_depth_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// A copy of the depths drawn so far, for the lines to read while they write depth themselves.\n"
    "uniform highp sampler2D tr_scene_depth;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    gl_FragDepth = texelFetch(tr_scene_depth, ivec2(gl_FragCoord.xy), 0).r;\n"
    "}\n",
    0};
static const char *const tr_i_shader_crossings_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Fragment stage. Hodges' first rule (Diepstraten 2002, section 3): the shade of an opaque object is strengthened where\n"
    "// it enters a transparent one, by distance from the curves where their surfaces cross.\n"
    "#if TR_STRENGTHENS\n"
    "uniform highp sampler2D tr_crossings; // two texels a segment, rows of 1024 texels: its ends\n"
    "\n"
    "highp vec3 tr_crossing_end(int index)\n"
    "{\n"
    "    return texelFetch(tr_crossings, ivec2(index & 1023, index >> 10), 0).xyz;\n"
    "}\n"
    "\n"
    "// Of a point to the segments range.x up to range.x + range.y; the reach, tr_enter.y, where none is nearer.\n"
    "highp float tr_crossing_distance(highp vec3 point, highp ivec2 range)\n"
    "{\n"
    "    highp float least = tr_enter.y * tr_enter.y;\n"
    "    // A range of more than there is ends where the texture does.\n"
    "    int end = min(range.x + range.y, 512 * textureSize(tr_crossings, 0).y);\n"
    "    for (int i = max(range.x, 0); i < end; ++i) {\n"
    "        highp vec3 a = tr_crossing_end(2 * i);\n"
    "        highp vec3 along = tr_crossing_end(2 * i + 1) - a, from = point - a;\n"
    "        highp float square = dot(along, along);\n"
    "        highp float t = square > 0.0 ? clamp(dot(from, along) / square, 0.0, 1.0) : 0.0;\n"
    "        highp vec3 away = from - t * along;\n"
    "        least = min(least, dot(away, away));\n"
    "    }\n"
    "    return sqrt(least);\n"
    "}\n"
    "#endif\n"
    "\n"
    "// position: of the fragment in the space of the segments. Returns color where there is nothing to strengthen.\n"
    "highp vec4 tr_strengthen(highp vec4 color, highp vec3 position, highp ivec2 range)\n"
    "{\n"
    "#if TR_STRENGTHENS\n"
    "    highp float reach = tr_enter.y, distance_to = tr_crossing_distance(position, range);\n"
    "    highp float pixel = max(length(dFdx(position)), length(dFdy(position)));\n"
    "    color.rgb *= 1.0 - tr_enter.x * (1.0 - distance_to / reach);\n"
    "    // The curve itself, as a line: half of its width on either side.\n"
    "    if (distance_to < 0.5 * tr_enter.z * pixel)\n"
    "        color.rgb = tr_ink[1].rgb;\n"
    "#endif\n"
    "    return color;\n"
    "}\n",
    0};
static const char *const tr_i_shader_frame_block_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What is the same for all passes of one frame (std140, written by tr_begin), but for its last member.\n"
    "layout(std140) uniform tr_frame\n"
    "{\n"
    "    highp vec4 tr_light;    // xyz: toward the light, unit length, in the space of the normals\n"
    "    highp vec4 tr_cool;     // rgb, and how much diffuse colour is mixed in\n"
    "    highp vec4 tr_warm;\n"
    "    highp vec4 tr_weights;  // x: of opaque things, y: of the background, z: tolerance of lines in pixels\n"
    "    highp vec4 tr_viewport; // x, y, width, height of the target's viewport\n"
    "    highp vec4 tr_ink[2];   // rgb: creases; outlines\n"
    "    highp vec4 tr_eye;      // distance along the view of window depth d: (x + y d) / (z + w d)\n"
    "    highp vec4 tr_blend;    // rgb: stands for the background behind transparent surfaces; a: group distance\n"
    "    highp vec4 tr_enter;    // x: strength of the shade, y: its width, z: width of the curve, in pixels\n"
    "    highp vec4 tr_shift;    // xy: sub-pixel jitter in pixels\n"
    "    highp ivec4 tr_step;    // x: the layer that this pass reads; yz: where the viewport is in the host's opaque textures\n"
    "};\n"
    "\n"
    "// How far a window depth is from the eye, along the view direction.\n"
    "highp float tr_distance_of(highp float depth)\n"
    "{\n"
    "    return (tr_eye.x + tr_eye.y * depth) / (tr_eye.z + tr_eye.w * depth);\n"
    "}\n",
    0};
static const char *const tr_i_shader_fullscreen_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// One triangle that covers the viewport; no vertex buffer.\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(corner, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_line_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Feature lines: fragment stage.\n"
    "//\n"
    "// A line lies on the rim of its own surface: tested pixel by pixel, the surface would eat its inner half. So a line's\n"
    "// visibility is that of its centre, against the farthest depth around it: on a silhouette one side always lies\n"
    "// farther, and where something covers the line all sides are nearer.\n"
    "#define TR_LINE_VISIBLE 0\n"
    "#define TR_LINE_HIDDEN 1 // what the others leave out\n"
    "#define TR_LINE_OUTER 2  // only where no surface is: the outer half of wide outlines, Gooch 1999, section 5.1.3\n"
    "\n"
    "#ifdef TR_REVERSED_Z\n"
    "#define TR_BEHIND(a, b) ((a) < (b))\n"
    "#else\n"
    "#define TR_BEHIND(a, b) ((a) > (b))\n"
    "#endif\n"
    "#if TR_ON_TARGET\n"
    "#define TR_ORIGIN ivec2(tr_viewport.xy)\n"
    "#define TR_TEXELS TR_SUPERSAMPLE // of our textures, along each side of a pixel that is drawn\n"
    "#else\n"
    "#define TR_ORIGIN ivec2(0)\n"
    "#define TR_TEXELS 1\n"
    "#endif\n"
    "#if TR_HAS_SCENE\n"
    "uniform highp sampler2D tr_scene_depth;\n"
    "#endif\n"
    "#if TR_HAS_FRONT // 2: seen through by this line, which is an opaque object's\n"
    "uniform highp sampler2DArray tr_front_depth;\n"
    "#endif\n"
    "in highp vec4 tr_v_line;\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "// The nearest of what is seen at a texel, with transparent surfaces or without.\n"
    "highp float tr_depth_at(ivec2 texel, bool transparent)\n"
    "{\n"
    "    highp float depth = TR_CLEAR_DEPTH;\n"
    "#if TR_HAS_SCENE\n"
    "    texel = clamp(texel, ivec2(0), textureSize(tr_scene_depth, 0) - 1);\n"
    "    depth = texelFetch(tr_scene_depth, texel, 0).r;\n"
    "#endif\n"
    "#if TR_HAS_FRONT\n"
    "    texel = clamp(texel, ivec2(0), textureSize(tr_front_depth, 0).xy - 1);\n"
    "    highp float front = texelFetch(tr_front_depth, ivec3(texel, 0), 0).r;\n"
    "    depth = transparent && TR_BEHIND(depth, front) ? front : depth;\n"
    "#endif\n"
    "    return depth;\n"
    "}\n"
    "\n"
    "highp vec3 tr_light_of(highp vec3 color)\n"
    "{\n"
    "#if TR_SRGB && TR_ON_TARGET\n"
    "    return mix(color * (1.0 / 12.92), pow((color + 0.055) * (1.0 / 1.055), vec3(2.4)), step(0.04045, color));\n"
    "#else\n"
    "    return color;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 center = ivec2(floor(tr_v_line.xy * float(TR_SUPERSAMPLE)));\n"
    "    highp float tolerance = tr_v_line.w * tr_weights.z;\n"
    "#ifdef TR_REVERSED_Z\n"
    "    highp float nearer = tr_v_line.z + tolerance;\n"
    "    highp float farthest = 1.0;\n"
    "#else\n"
    "    highp float nearer = tr_v_line.z - tolerance;\n"
    "    highp float farthest = 0.0;\n"
    "#endif\n"
    "    for (int y = -1; y <= 1; ++y) {\n"
    "        for (int x = -1; x <= 1; ++x) {\n"
    "            highp float depth = tr_depth_at(center + ivec2(x, y) * TR_SUPERSAMPLE, TR_HAS_FRONT == 1);\n"
    "            farthest = TR_BEHIND(depth, farthest) ? depth : farthest;\n"
    "        }\n"
    "    }\n"
    "#if TR_LINE == TR_LINE_HIDDEN\n"
    "    if (!TR_BEHIND(nearer, farthest))\n"
    "        discard;\n"
    "#else\n"
    "    if (TR_BEHIND(nearer, farthest))\n"
    "        discard;\n"
    "#endif\n"
    "    // The nearer of line and surface: passes the depth test wherever the centre is visible, and hides what comes later.\n"
    "    ivec2 pixel = (ivec2(gl_FragCoord.xy) - TR_ORIGIN) * TR_TEXELS;\n"
    "    highp float surface = TR_CLEAR_DEPTH;\n"
    "    for (int i = 0; i < TR_TEXELS * TR_TEXELS; ++i) {\n"
    "        highp float depth = tr_depth_at(pixel + ivec2(i % TR_TEXELS, i / TR_TEXELS), true);\n"
    "        surface = TR_BEHIND(surface, depth) ? depth : surface;\n"
    "    }\n"
    "#if TR_LINE == TR_LINE_OUTER\n"
    "    if (surface != TR_CLEAR_DEPTH)\n"
    "        discard;\n"
    "#endif\n"
    "    gl_FragDepth = TR_BEHIND(tr_v_line.z, surface) ? surface : tr_v_line.z;\n"
    "    tr_color = vec4(tr_light_of(tr_ink[TR_INK].rgb), 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_line_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Feature lines as triangles in screen space: vertex stage. The layout is that of a sil_ribbon_vertex.\n"
    "layout(location = 0) in highp vec4 tr_line_corner; // x, y in pixels, window depth, slack: depth per pixel toward the eye\n"
    "layout(location = 1) in highp vec2 tr_line_center; // the point of the centre line, pixels\n"
    "out highp vec4 tr_v_line;                          // centre x, y, depth, slack\n"
    "\n"
    "void main()\n"
    "{\n"
    "    // Lines are found without the host's jitter, and shifted by as much as its surfaces are.\n"
    "    tr_v_line = vec4(tr_line_center + tr_shift.xy, tr_line_corner.zw);\n"
    "    // Depth is written by the fragment stage, so the clip convention in force does not matter here.\n"
    "    gl_Position = vec4(2.0 * (tr_line_corner.xy + tr_shift.xy) / tr_viewport.zw - 1.0, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_outline_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Outlines in the image, and the nearest one of each pixel, for hosts without meshes on the CPU.\n"
    "//\n"
    "// TR_JUMP 0: a pixel of the surface is an outline where a neighbour is none of it, is another object's and farther, or\n"
    "// is farther by more than the surface's own slope explains. TR_JUMP 1: one round of jump flooding (Rong and Tan 2006):\n"
    "// the nearest outline that is known to one of the nine pixels tr_jump apart. Where there are ids, an object's pixels\n"
    "// take outlines of that object alone.\n"
    "uniform highp sampler2D tr_scene_depth;\n"
    "#if TR_HAS_IDS\n"
    "uniform highp usampler2D tr_ids;\n"
    "#endif\n"
    "#if TR_JUMP\n"
    "uniform highp usampler2D tr_nearest; // x, y of a pixel; TR_NOWHERE: none is known\n"
    "uniform highp int tr_jump;\n"
    "#else\n"
    "uniform highp vec4 tr_depth_law; // distance along the view of window depth d: (x + y d) / (z + w d)\n"
    "uniform highp vec2 tr_pixel;     // size of a pixel in the world: x, or y at distance 1\n"
    "#endif\n"
    "layout(location = 0) out highp uvec2 tr_outline_here;\n"
    "\n"
    "#define TR_NOWHERE 65535u\n"
    "\n"
    "bool tr_same_object(ivec2 a, ivec2 b)\n"
    "{\n"
    "#if TR_HAS_IDS\n"
    "    return texelFetch(tr_ids, a, 0).r == texelFetch(tr_ids, b, 0).r;\n"
    "#else\n"
    "    return true;\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if TR_JUMP\n"
    "void main()\n"
    "{\n"
    "    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(tr_nearest, 0) - 1;\n"
    "    highp float least = 3.0e38;\n"
    "    tr_outline_here = uvec2(TR_NOWHERE);\n"
    "    for (int y = -1; y <= 1; ++y) {\n"
    "        for (int x = -1; x <= 1; ++x) {\n"
    "            ivec2 at = here + ivec2(x, y) * tr_jump;\n"
    "            if (at != clamp(at, ivec2(0), last))\n"
    "                continue;\n"
    "            highp uvec2 found = texelFetch(tr_nearest, at, 0).rg;\n"
    "            if (found.x == TR_NOWHERE || !tr_same_object(ivec2(found), here))\n"
    "                continue;\n"
    "            highp vec2 way = vec2(found) - vec2(here);\n"
    "            if (dot(way, way) < least) {\n"
    "                least = dot(way, way);\n"
    "                tr_outline_here = found;\n"
    "            }\n"
    "        }\n"
    "    }\n"
    "}\n"
    "#else\n"
    "highp float tr_distance_at(ivec2 pixel)\n"
    "{\n"
    "    highp float depth = texelFetch(tr_scene_depth, pixel, 0).r;\n"
    "    return (tr_depth_law.x + tr_depth_law.y * depth) / (tr_depth_law.z + tr_depth_law.w * depth);\n"
    "}\n"
    "\n"
    "bool tr_ends(ivec2 here, ivec2 step, highp float distance)\n"
    "{\n"
    "    ivec2 last = textureSize(tr_scene_depth, 0) - 1, next = here + step, before = here - step;\n"
    "    if (next != clamp(next, ivec2(0), last))\n"
    "        return false; // the image ends here, the object need not\n"
    "    if (texelFetch(tr_scene_depth, next, 0).r == TR_CLEAR_DEPTH)\n"
    "        return true;\n"
    "    highp float gap = tr_distance_at(next) - distance;\n"
    "    if (!tr_same_object(here, next))\n"
    "        return gap > 0.0;\n"
    "    highp float slope = 0.0;\n"
    "    if (before == clamp(before, ivec2(0), last) && texelFetch(tr_scene_depth, before, 0).r != TR_CLEAR_DEPTH)\n"
    "        slope = abs(distance - tr_distance_at(before));\n"
    "    return gap > 3.0 * slope + 4.0 * (tr_pixel.x + tr_pixel.y * distance);\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 here = ivec2(gl_FragCoord.xy);\n"
    "    tr_outline_here = uvec2(TR_NOWHERE);\n"
    "    if (texelFetch(tr_scene_depth, here, 0).r == TR_CLEAR_DEPTH)\n"
    "        return;\n"
    "    highp float distance = tr_distance_at(here);\n"
    "    if (tr_ends(here, ivec2(1, 0), distance) || tr_ends(here, ivec2(-1, 0), distance) ||\n"
    "        tr_ends(here, ivec2(0, 1), distance) || tr_ends(here, ivec2(0, -1), distance))\n"
    "        tr_outline_here = uvec2(here);\n"
    "}\n"
    "#endif\n",
    0};
static const char *const tr_i_shader_see_block_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What is the same for all passes of a frame of dynamic transparency (std140, written by tr_begin_dynamic).\n"
    "layout(std140) uniform tr_frame\n"
    "{\n"
    "    highp vec4 tr_light;          // xyz: toward the light, unit length, in the space of the normals\n"
    "    highp vec4 tr_cool;           // rgb, and how much diffuse colour is mixed in\n"
    "    highp vec4 tr_warm;\n"
    "    highp vec4 tr_viewport;       // x, y, width, height of the target's viewport\n"
    "    highp vec4 tr_see_law;        // opacity before a target, and beside it; width of the gradient; how many lights,\n"
    "                                  // or -1: none, and targets are drawn in colour\n"
    "    highp vec4 tr_see_background; // rgb: where nothing is drawn; a: 1 where each occluder counts on its own\n"
    "    highp ivec4 tr_see_grid;      // pixels a texel of masks; a cell; frame index; pixels that masks reach\n"
    "    highp vec4 tr_see_lights[8];  // x, y, radius, edge, pixels of the viewport\n"
    "    highp uvec4 tr_see_tiles[500]; // four each: x0, y0, x1, y1 in cells, a byte each, x0 the lowest\n"
    "};\n"
    "\n"
    "#ifdef TR_REVERSED_Z\n"
    "#define TR_BEHIND(a, b) ((a) < (b))\n"
    "#else\n"
    "#define TR_BEHIND(a, b) ((a) > (b))\n"
    "#endif\n",
    0};
static const char *const tr_i_shader_see_compose_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What shows through masks, over the scene: alpha of it is what the mask takes away. At the mask's depth, so that where\n"
    "// the target has depth this is done behind what was drawn there, and nothing where the scene lies behind anyway.\n"
    "uniform highp sampler2D tr_see_depth;\n"
    "uniform highp sampler2D tr_see_mask;\n"
    "uniform highp sampler2D tr_see_behind;\n"
    "#if TR_HAS_YIELD\n"
    "uniform highp sampler2D tr_see_yield; // importance of the front-most unit\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy);\n"
    "    highp vec2 mask = texelFetch(tr_see_mask, pixel, 0).rg;\n"
    "#if TR_HAS_YIELD\n"
    "    mask.g = clamp(mask.g - texelFetch(tr_see_yield, pixel, 0).r, 0.0, 1.0);\n"
    "#endif\n"
    "    if (mask.r == 1.0 || mask.g == 0.0)\n"
    "        discard;\n"
    "    tr_color = vec4(texelFetch(tr_see_behind, pixel, 0).rgb, (1.0 - mask.r) * mask.g);\n"
    "    gl_FragDepth = texelFetch(tr_see_depth, pixel, 0).r;\n"
    "}\n",
    0};
static const char *const tr_i_shader_see_finish_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The mask at the target's resolution: red the opacity that it asks for (Assarsson 2006, algorithm 2), green the target's\n"
    "// strength; and its depth. On the target as that was drawn, beside it from the mask's texels: their distances are\n"
    "// interpolated, their depths never.\n"
    "uniform highp sampler2D tr_see_depth; // of targets\n"
    "#if TR_IN_PARTS\n"
    "uniform highp sampler2D tr_see_bits; // which of eight pixels are a target's\n"
    "#else\n"
    "uniform highp sampler2D tr_see_mark;\n"
    "#endif\n"
    "#if TR_HAS_LOW\n"
    "uniform highp sampler2D tr_see_low; // distance, strength, active\n"
    "uniform highp sampler2D tr_see_low_depth;\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "// Of the search lights at a pixel; full within the radius, linear over the edge, of several the strongest.\n"
    "highp float tr_light_at(highp vec2 position)\n"
    "{\n"
    "    highp float most = 0.0;\n"
    "    for (int i = 0; i < int(tr_see_law.w); ++i) {\n"
    "        highp vec4 light = tr_see_lights[i];\n"
    "        highp float outside = distance(position, light.xy) - light.z;\n"
    "        most = max(most, outside <= 0.0 ? 1.0 : light.w > 0.0 ? clamp(1.0 - outside / light.w, 0.0, 1.0) : 0.0);\n"
    "    }\n"
    "    return most;\n"
    "}\n"
    "\n"
    "#if TR_HAS_LOW\n"
    "highp float tr_low_distance(ivec2 texel, ivec2 size)\n"
    "{\n"
    "    return texelFetch(tr_see_low, clamp(texel, ivec2(0), size - 1), 0).r;\n"
    "}\n"
    "\n"
    "// To the nearest pixel of a target, interpolated between the four texels around.\n"
    "highp float tr_distance_at(ivec2 pixel)\n"
    "{\n"
    "    int divisor = tr_see_grid.x;\n"
    "    ivec2 size = (ivec2(tr_viewport.zw) + divisor - 1) / divisor;\n"
    "    highp vec2 place = (vec2(pixel) + 0.5) / float(divisor) - 0.5;\n"
    "    ivec2 low = ivec2(floor(place));\n"
    "    highp vec2 part = place - vec2(low);\n"
    "    highp float below = mix(tr_low_distance(low, size), tr_low_distance(low + ivec2(1, 0), size), part.x);\n"
    "    highp float above = mix(tr_low_distance(low + ivec2(0, 1), size), tr_low_distance(low + 1, size), part.x);\n"
    "    return mix(below, above, part.y) * float(tr_see_grid.w + 2 * divisor);\n"
    "}\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "#if TR_IN_PARTS\n"
    "    int bits = int(texelFetch(tr_see_bits, ivec2(pixel.x >> 3, pixel.y), 0).r * 255.0 + 0.5);\n"
    "    highp vec2 mark = vec2(float((bits >> (pixel.x & 7)) & 1), 0.0);\n"
    "#else\n"
    "    highp vec2 mark = texelFetch(tr_see_mark, pixel, 0).ab;\n"
    "#endif\n"
    "    highp float opacity = tr_see_law.x, depth;\n"
    "    if (mark.r > 0.0) {\n"
    "        depth = texelFetch(tr_see_depth, pixel, 0).r;\n"
    "    } else {\n"
    "#if TR_HAS_LOW\n"
    "        ivec2 texel = pixel / tr_see_grid.x;\n"
    "        highp vec3 low = texelFetch(tr_see_low, texel, 0).rgb;\n"
    "        // The pixels beside the target are the gradient's first ring.\n"
    "        opacity = mix(tr_see_law.y, 1.0, clamp((tr_distance_at(pixel) - 1.0) / tr_see_law.z, 0.0, 1.0));\n"
    "        if (opacity == 1.0 || low.r == 1.0)\n"
    "            discard;\n"
    "        mark = low.gb;\n"
    "        depth = texelFetch(tr_see_low_depth, texel, 0).r;\n"
    "#else\n"
    "        discard;\n"
    "#endif\n"
    "    }\n"
    "    if (tr_see_law.w > 0.0 && mark.g > 0.5)\n"
    "        opacity = 1.0 - tr_light_at(vec2(pixel) + 0.5) * (1.0 - opacity);\n"
    "    tr_color = vec4(opacity, mark.r, 0.0, 0.0);\n"
    "    gl_FragDepth = depth;\n"
    "}\n",
    0};
static const char *const tr_i_shader_see_prime_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Opens the depth buffer where a mask is, and nowhere else: the depth test then stops all else before it is shaded. What\n"
    "// is there in colour already, the target or all that never yields, only what is before it may cover.\n"
    "uniform highp sampler2D tr_see_mask;\n"
    "#if TR_IN_PARTS\n"
    "uniform highp sampler2D tr_see_depth;  // of all that never yields\n"
    "#elif TR_HAS_COLOR\n"
    "uniform highp sampler2D tr_see_depth;  // of the mask\n"
    "uniform highp sampler2D tr_see_behind; // in alpha the strength, 0 where there is no target\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    highp vec2 mask = texelFetch(tr_see_mask, pixel, 0).rg;\n"
    "    if (mask.r == 1.0 || mask.g == 0.0)\n"
    "        discard;\n"
    "    tr_color = vec4(tr_see_background.rgb, 1.0);\n"
    "    gl_FragDepth = TR_CLEAR_DEPTH;\n"
    "#if TR_IN_PARTS\n"
    "    gl_FragDepth = texelFetch(tr_see_depth, pixel, 0).r;\n"
    "#elif TR_HAS_COLOR\n"
    "    if (texelFetch(tr_see_behind, pixel, 0).a > 0.0)\n"
    "        gl_FragDepth = texelFetch(tr_see_depth, pixel, 0).r;\n"
    "#endif\n"
    "}\n",
    0};
static const char *const tr_i_shader_see_query_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// For tr_query_hidden: a texel for 4 by 4 pixels, the id of the target at its middle in two bytes.\n"
    "uniform highp sampler2D tr_see_mark;\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 size = ivec2(tr_viewport.zw);\n"
    "    ivec2 pixel = min(ivec2(gl_FragCoord.xy * tr_viewport.zw / vec2((size + 3) >> 2)), size - 1);\n"
    "    tr_color = vec4(texelFetch(tr_see_mark, pixel, 0).rg, 0.0, 0.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_see_rules_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Fragment stage. What a unit's fragment does in each pass of dynamic transparency: Assarsson 2006, section 3, as amended.\n"
    "//\n"
    "// A host's fragment shader calls tr_see_through(color, code) once, last in main, before it writes color to its output of\n"
    "// location 0. code: what tr_unit_code makes. Bits 0 to 15: id, from 16 flags, from 24 importance in 255ths.\n"
    "#define TR_RULE_SEE_PLAIN 15  // nothing\n"
    "#define TR_RULE_SEE_BLOCK 16  // depth of what closes masks\n"
    "#define TR_RULE_SEE_TARGET 17 // depth, and colour or mark, of the nearest target\n"
    "#define TR_RULE_SEE_BEHIND 18 // what shows through masks\n"
    "#define TR_RULE_SEE_YIELD 19  // importance of the front-most unit\n"
    "#define TR_RULE_SEE_DITHER 20 // the whole scene, with holes\n"
    "#define TR_RULE_SEE_HIDES 21  // what lies before a target\n"
    "\n"
    "#if TR_RULE == TR_RULE_SEE_PLAIN\n"
    "#define tr_see_through(color, code)\n"
    "#else\n"
    "\n"
    "#if TR_RULE >= TR_RULE_SEE_BEHIND && TR_RULE != TR_RULE_SEE_YIELD\n"
    "uniform highp sampler2D tr_see_depth; // of the mask: what lies before it yields\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_SEE_BEHIND || TR_RULE == TR_RULE_SEE_DITHER\n"
    "uniform highp sampler2D tr_see_mask; // opacity that it asks for, the target's strength\n"
    "#endif\n"
    "\n"
    "bool tr_see_is(highp uint code, highp uint flags)\n"
    "{\n"
    "    return ((code >> 16) & flags) != 0u;\n"
    "}\n"
    "\n"
    "// Targets, and what is never made transparent.\n"
    "bool tr_see_keeps(highp uint code)\n"
    "{\n"
    "    return tr_see_is(code, 1u | 2u | 8u);\n"
    "}\n"
    "\n"
    "highp float tr_see_importance(highp uint code)\n"
    "{\n"
    "    return float(code >> 24) * (1.0 / 255.0);\n"
    "}\n"
    "\n"
    "#if TR_RULE == TR_RULE_SEE_DITHER\n"
    "highp uint tr_see_hash(highp uint x)\n"
    "{\n"
    "    x = (x ^ (x >> 16)) * 0x7feb352du;\n"
    "    x = (x ^ (x >> 15)) * 0x846ca68bu;\n"
    "    return x ^ (x >> 16);\n"
    "}\n"
    "\n"
    "// Fragments stay whose opacity is above it. Together: one threshold a pixel, interleaved gradient noise moved on by the\n"
    "// golden ratio from frame to frame, so that any few frames in a row average well. Each on its own: one a pixel and unit.\n"
    "highp float tr_see_threshold(ivec2 pixel, highp uint code)\n"
    "{\n"
    "    highp uint frame = uint(tr_see_grid.z);\n"
    "    if (tr_see_background.a > 0.5) {\n"
    "        highp uint bits = tr_see_hash(uint(pixel.x) + tr_see_hash(uint(pixel.y) + tr_see_hash((code & 0xffffu) + tr_see_hash(frame))));\n"
    "        return float(bits >> 8) * (1.0 / 16777216.0);\n"
    "    }\n"
    "    highp float noise = fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));\n"
    "    // frame * (sqrt(5) - 1) / 2 modulo 1, in integers: it stays exact however long a game runs.\n"
    "    return fract(noise + float((frame * 0x9e3779b9u) >> 8) * (1.0 / 16777216.0));\n"
    "}\n"
    "#endif\n"
    "\n"
    "void tr_see_through(inout highp vec4 color, highp uint code)\n"
    "{\n"
    "#if TR_RULE == TR_RULE_SEE_BLOCK\n"
    "    if (!tr_see_is(code, 2u | 8u))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_SEE_TARGET\n"
    "    if (!tr_see_is(code, 1u) || (code >> 24) == 0u)\n"
    "        discard;\n"
    "    if (tr_see_law.w >= 0.0)\n"
    "        color.rgb = vec3(float(code & 255u) * (1.0 / 255.0), float((code >> 8) & 255u) * (1.0 / 255.0), tr_see_is(code, 16u) ? 1.0 : 0.0);\n"
    "    color.a = tr_see_importance(code);\n"
    "#elif TR_RULE == TR_RULE_SEE_BEHIND\n"
    "    if (tr_see_keeps(code))\n"
    "        return;\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    if (!TR_BEHIND(texelFetch(tr_see_depth, pixel, 0).r, gl_FragCoord.z))\n"
    "        return;\n"
    "    if (code < 0x1000000u || texelFetch(tr_see_mask, pixel, 0).g > tr_see_importance(code))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_SEE_YIELD\n"
    "    color = vec4(tr_see_keeps(code) ? 1.0 : tr_see_importance(code));\n"
    "#elif TR_RULE == TR_RULE_SEE_DITHER\n"
    "    if (tr_see_keeps(code))\n"
    "        return;\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy);\n"
    "    highp vec2 mask = texelFetch(tr_see_mask, pixel, 0).rg;\n"
    "    highp float yielding = clamp(mask.g - tr_see_importance(code), 0.0, 1.0), alpha = 1.0 - (1.0 - mask.r) * yielding;\n"
    "    if (alpha < 1.0 && TR_BEHIND(texelFetch(tr_see_depth, pixel, 0).r, gl_FragCoord.z) &&\n"
    "        tr_see_threshold(pixel, code) >= alpha)\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_SEE_HIDES\n",
    "#line 95\n"
    "    // A texel's fragment stands at its middle: the pixel that it is compared with is there.\n"
    "    ivec2 size = ivec2(tr_viewport.zw);\n"
    "    ivec2 pixel = min(ivec2(gl_FragCoord.xy * tr_viewport.zw / vec2((size + 3) >> 2)), size - 1);\n"
    "    if (tr_see_keeps(code) || !TR_BEHIND(texelFetch(tr_see_depth, pixel, 0).r, gl_FragCoord.z))\n"
    "        discard;\n"
    "    color = vec4(0.0, 0.0, 1.0, 0.0);\n"
    "#endif\n"
    "}\n"
    "#endif\n",
    0};
static const char *const tr_i_shader_see_spread_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// How far the nearest pixel of a target is: exact, by rows and then across them.\n"
    "//\n"
    "// TR_SPREAD 0: eight pixels of a row as bits, so that the next steps over empty space are long ones. TR_SPREAD 1: in its\n"
    "// row, for each texel of masks, as the pixels from the texel's first one to it, plus 128, in 255ths; 0: none; of four rows\n"
    "// at once, so that the next step reads them at once. TR_SPREAD 2: of the rows' the nearest, of equally near ones that\n"
    "// nearest to the eye. A texel stands for the middle of its pixels; twice the positions are integers. Steps go outward.\n"
    "uniform highp sampler2D tr_see_depth; // of targets\n"
    "#if TR_IN_PARTS\n"
    "uniform highp sampler2D tr_see_base;  // of all that never yields: the same where a target is open\n"
    "#else\n"
    "uniform highp sampler2D tr_see_mark;  // of targets: in alpha the strength, 0 where there is none; in blue 1 where active\n"
    "#endif\n"
    "#if TR_SPREAD != 0\n"
    "uniform highp sampler2D tr_see_rows; // the step before this one's\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "#if TR_SPREAD == 0\n"
    "bool tr_is_target(ivec2 pixel)\n"
    "{\n"
    "#if TR_IN_PARTS\n"
    "    highp float depth = texelFetch(tr_see_depth, pixel, 0).r;\n"
    "    return depth != TR_CLEAR_DEPTH && depth == texelFetch(tr_see_base, pixel, 0).r;\n"
    "#else\n"
    "    return texelFetch(tr_see_mark, pixel, 0).a > 0.0;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 first = ivec2(int(gl_FragCoord.x) * 8, int(gl_FragCoord.y));\n"
    "    int bits = 0, count = min(8, int(tr_viewport.z) - first.x);\n"
    "    for (int i = 0; i < count; ++i)\n"
    "        bits |= tr_is_target(first + ivec2(i, 0)) ? 1 << i : 0;\n"
    "    tr_color = vec4(float(bits) * (1.0 / 255.0));\n"
    "}\n"
    "#elif TR_SPREAD == 1\n"
    "// The highest bit of a number above 0, by the exponent of a float.\n"
    "int tr_highest(int bits)\n"
    "{\n"
    "    return (floatBitsToInt(float(bits)) >> 23) - 127;\n"
    "}\n"
    "\n"
    "int tr_bits(int block, int y)\n"
    "{\n"
    "    return int(texelFetch(tr_see_rows, ivec2(block, y), 0).r * 255.0 + 0.5);\n"
    "}\n"
    "\n"
    "highp float tr_nearest_in(int y)\n"
    "{\n"
    "    int divisor = tr_see_grid.x, reach = tr_see_grid.w + 2 * divisor, first = int(gl_FragCoord.x) * divisor;\n"
    "    int from_left = first + (divisor - 1) / 2, from_right = first + divisor / 2;\n"
    "    int left = -0x10000, right = 0x10000;\n"
    "    int lowest = max(from_left - reach, 0), highest = min(from_right + reach, int(tr_viewport.z) - 1);\n"
    "    for (int block = from_left >> 3, mask = (2 << (from_left & 7)) - 1; block * 8 + 7 >= lowest; --block, mask = 255) {\n"
    "        int bits = tr_bits(block, y) & mask;\n"
    "        if (bits != 0) {\n"
    "            left = block * 8 + tr_highest(bits);\n"
    "            break;\n"
    "        }\n"
    "    }\n"
    "    for (int block = from_right >> 3, mask = 255 << (from_right & 7); block * 8 <= highest; ++block, mask = 255) {\n"
    "        int bits = tr_bits(block, y) & mask;\n"
    "        if (bits != 0) {\n"
    "            right = block * 8 + tr_highest(bits & -bits);\n"
    "            break;\n"
    "        }\n"
    "    }\n"
    "    int to_left = from_left - left, to_right = right - from_right;\n"
    "    bool at_left = to_left < to_right;\n"
    "    if (to_left == to_right && to_left <= reach)\n"
    "        at_left = TR_BEHIND(texelFetch(tr_see_depth, ivec2(right, y), 0).r, texelFetch(tr_see_depth, ivec2(left, y), 0).r);\n"
    "    int found = min(to_left, to_right) <= reach ? (at_left ? left : right) - first + 128 : 0;\n"
    "    return float(found) * (1.0 / 255.0);\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    vec4 rows = vec4(0.0); // ES has outputs indexed by constants only\n"
    "    for (int i = 0, y = 4 * int(gl_FragCoord.y); i < 4 && y + i < int(tr_viewport.w); ++i)\n"
    "        rows[i] = tr_nearest_in(y + i);\n"
    "    tr_color = rows;\n"
    "}\n"
    "#else\n"
    "void main()\n"
    "{\n"
    "    ivec2 texel = ivec2(gl_FragCoord.xy), first = texel * tr_see_grid.x, nearest = ivec2(-1);\n"
    "    int divisor = tr_see_grid.x, steps = tr_see_grid.w + 2 * divisor, least = 4 * steps * steps;\n"
    "    int middle = first.y >> 2, last = (int(tr_viewport.w) - 1) >> 2;\n"
    "    // Four rows at a time, outward: those i texels away are 4 * i - 3 and more pixels away, less the texel's own.\n",
    "#line 92\n"
    "    for (int i = 0; i == 0 || 4 * i - 3 - divisor <= 0 || (4 * i - 3 - divisor) * (4 * i - 3 - divisor) * 4 <= least; ++i) {\n"
    "        for (int side = 0; side < (i == 0 ? 1 : 2); ++side) {\n"
    "            int four = side == 0 ? middle - i : middle + i;\n"
    "            if (four < 0 || four > last)\n"
    "                continue;\n"
    "            ivec4 found = ivec4(texelFetch(tr_see_rows, ivec2(texel.x, four), 0) * 255.0 + 0.5);\n"
    "            if (found == ivec4(0))\n"
    "                continue;\n"
    "            for (int k = 0; k < 4; ++k) {\n"
    "                if (found[k] == 0)\n"
    "                    continue;\n"
    "                ivec2 pixel = ivec2(first.x + found[k] - 128, 4 * four + k), offset = 2 * (pixel - first) - divisor + 1;\n"
    "                int square = offset.x * offset.x + offset.y * offset.y;\n"
    "                if (square < least ||\n"
    "                    (square == least && nearest.x >= 0 &&\n"
    "                     TR_BEHIND(texelFetch(tr_see_depth, nearest, 0).r, texelFetch(tr_see_depth, pixel, 0).r))) {\n"
    "                    least = square;\n"
    "                    nearest = pixel;\n"
    "                }\n"
    "            }\n"
    "        }\n"
    "    }\n"
    "    tr_color = vec4(1.0, 0.0, 0.0, 0.0);\n"
    "    gl_FragDepth = TR_CLEAR_DEPTH;\n"
    "    if (nearest.x < 0)\n"
    "        return;\n"
    "#if TR_IN_PARTS\n"
    "    tr_color = vec4(0.5 * sqrt(float(least)) / float(steps), 1.0, 0.0, 0.0);\n"
    "#else\n"
    "    tr_color = vec4(0.5 * sqrt(float(least)) / float(steps), texelFetch(tr_see_mark, nearest, 0).ab, 0.0);\n"
    "#endif\n"
    "    gl_FragDepth = texelFetch(tr_see_depth, nearest, 0).r;\n"
    "}\n"
    "#endif\n",
    0};
static const char *const tr_i_shader_see_tile_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Six vertices a tile: passes of dynamic transparency cover the cells that have masks, and no more.\n"
    "//\n"
    "// TR_COARSE_X, TR_COARSE_Y: 1 where the texture has a texel for tr_see_grid.x pixels; 2: for eight across, four\n"
    "// up.\n"
    "void main()\n"
    "{\n"
    "    int tile = gl_VertexID / 6, corner = gl_VertexID - 6 * tile, divisor = tr_see_grid.x;\n"
    "    highp uvec4 four = tr_see_tiles[tile >> 2];\n"
    "    int which = tile & 3;\n"
    "    highp uint box = which == 0 ? four.x : which == 1 ? four.y : which == 2 ? four.z : four.w;\n"
    "    bool right = corner == 1 || corner == 2 || corner == 4, high = corner == 2 || corner == 4 || corner == 5;\n"
    "    highp uint x = (box >> (right ? 16 : 0)) & 255u, y = (box >> (high ? 24 : 8)) & 255u;\n"
    "    ivec2 size = ivec2(tr_viewport.zw);\n"
    "#if TR_COARSE_X == 2\n"
    "    size.x = (size.x + 7) / 8 * 8;\n"
    "#elif TR_COARSE_X == 1\n"
    "    size.x = (size.x + divisor - 1) / divisor * divisor;\n"
    "#endif\n"
    "#if TR_COARSE_Y == 2\n"
    "    size.y = (size.y + 3) / 4 * 4;\n"
    "#elif TR_COARSE_Y == 1\n"
    "    size.y = (size.y + divisor - 1) / divisor * divisor;\n"
    "#endif\n"
    "    gl_Position = vec4(vec2(ivec2(x, y) * tr_see_grid.y) / vec2(size) * 2.0 - 1.0, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_block_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What is the same for all passes of a frame of TR_SEE_EXACT, TR_SEE_SEQUENCE and TR_SEE_PUBLISHED, and the masks of one\n"
    "// run of passes (std140, written by tr_begin_dynamic).\n"
    "struct tr_mask {\n"
    "    highp vec4 box; // x0, y0, x1, y1 in pixels of the viewport, x1 and y1 outside; the mask lies well within\n"
    "    highp vec4 law; // x: strength, 1 less what has faded, y: 1: opens in lights only, z: importance, w: the target's id\n"
    "};\n"
    "layout(std140) uniform tr_frame\n"
    "{\n"
    "    highp vec4 tr_light; // of built-in shading, as in frame_block.glsl\n"
    "    highp vec4 tr_cool;\n"
    "    highp vec4 tr_warm;\n"
    "    highp vec4 tr_seq_law;       // x: alpha_target, y: alpha_start, z: width of the gradient in pixels, w: tr_mask_shape\n"
    "    highp vec4 tr_seq_background;\n"
    "    highp ivec4 tr_seq_view;     // the viewport: x, y, width, height\n"
    "    highp ivec4 tr_seq_numbers;  // x: divisor, y: how far a mask reaches, in pixels, z: layer control, 0: none, w: lights\n"
    "    highp ivec4 tr_seq_step;     // x: which layer a pass peels or keeps; y: 1: masks multiply,\n"
    "                                 // z: 1: whole masks cut targets, w: 1: units are painted into a target of our own\n"
    "    highp ivec4 tr_seq_more;     // x: layers peeled in all, y: 1: the last of them is the end, z: 1: something closes masks,\n"
    "                                 // w: 1: occluders share a mask\n"
    "    highp vec4 tr_seq_lights[8]; // x, y, radius, edge in pixels of the viewport\n"
    "    tr_mask tr_masks[64];\n"
    "};\n"
    "\n"
    "#ifdef TR_REVERSED_Z\n"
    "#define TR_NEARER(a, b) ((a) > (b))\n"
    "#define TR_NO_REACH 1.0\n"
    "#else\n"
    "#define TR_NEARER(a, b) ((a) < (b))\n"
    "#define TR_NO_REACH 0.0\n"
    "#endif\n",
    0};
static const char *const tr_i_shader_seq_boxes_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The boxes of the masks of a run, two triangles each and no vertex buffer. TR_BOXES says whose texels they are counted\n"
    "// in: 0: pixels, 1: columns of cells by rows of pixels, 2: cells of tr_seq_numbers.x pixels a side. Cells reach one\n"
    "// further on each side, for those who read the nearest four.\n"
    "flat out highp int tr_v_mask;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    int corner = gl_VertexID % 6;\n"
    "    tr_v_mask = gl_VertexID / 6;\n"
    "    highp vec4 box = tr_masks[tr_v_mask].box;\n"
    "    highp vec2 size = vec2(tr_seq_view.zw), cell = vec2(1.0);\n"
    "#if TR_BOXES >= 1\n"
    "    cell.x = float(tr_seq_numbers.x);\n"
    "#endif\n"
    "#if TR_BOXES == 2\n"
    "    cell.y = cell.x;\n"
    "#endif\n"
    "#if TR_BOXES >= 1\n"
    "    size = ceil(size / cell);\n"
    "    box = vec4(floor(box.xy / cell) - step(1.5, cell), ceil(box.zw / cell) + step(1.5, cell));\n"
    "    box = clamp(box, vec4(0.0), size.xyxy);\n"
    "#endif\n"
    "    bvec2 far = bvec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);\n"
    "    highp vec2 at = vec2(far.x ? box.z : box.x, far.y ? box.w : box.y);\n"
    "    gl_Position = vec4(at / size * 2.0 - 1.0, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_codes_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Codes of units: what tr_unit_code makes. Bits 0 to 15: id, 16 to 20: TR_UNIT_*, 24 to 31: importance in 255ths.\n"
    "#define TR_CODE_TARGET (1u << 16)\n"
    "#define TR_CODE_CLOSES (10u << 16) // impenetrable or backdrop\n"
    "#define TR_CODE_HOLLOW (4u << 16)\n",
    0};
static const char *const tr_i_shader_seq_compose_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The layers of a pixel, front to back, over the background.\n"
    "uniform highp sampler2D tr_reach;\n"
    "uniform highp usampler2DArray tr_chain;\n"
    "uniform highp sampler2DArray tr_layer_color;\n"
    "uniform highp sampler2DArray tr_layer_alphas; // of four a slice\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - tr_seq_view.xy;\n"
    "    highp float left = 1.0;\n"
    "    highp vec3 sum = vec3(0.0);\n"
    "    if (texelFetch(tr_reach, pixel, 0).r == TR_NO_REACH)\n"
    "        discard;\n"
    "    for (int i = 0; i < tr_seq_more.x; ++i) {\n"
    "        highp uint code = texelFetch(tr_chain, ivec3(pixel, i), 0).r;\n"
    "        if ((code & TR_LAYER_NONE) != 0u)\n"
    "            break;\n"
    "        highp float alpha = texelFetch(tr_layer_alphas, ivec3(pixel, i >> 2), 0)[i & 3];\n"
    "        sum += left * alpha * texelFetch(tr_layer_color, ivec3(pixel, i), 0).rgb;\n"
    "        left *= 1.0 - alpha;\n"
    "        if ((code & TR_LAYER_LAST) != 0u || left <= 0.0)\n"
    "            break;\n"
    "    }\n"
    "    tr_color = vec4(sum + left * tr_seq_background.rgb, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_extents_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The first and last pixel of a target in each row of its box: a column of texels a mask, a texel a row. Stored + 1; 0: none.\n"
    "uniform highp sampler2D tr_seed;\n"
    "layout(location = 0) out highp uvec4 tr_extent;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
    "    highp ivec4 box = ivec4(tr_masks[at.x].box);\n"
    "    int first = -1, last = -1;\n"
    "    tr_extent = uvec4(0u);\n"
    "    if (at.y < box.y || at.y >= box.w)\n"
    "        return;\n"
    "    for (int x = box.x; x < box.z && first < 0; ++x)\n"
    "        if (texelFetch(tr_seed, ivec2(x, at.y), 0).r != TR_CLEAR_DEPTH)\n"
    "            first = x;\n"
    "    for (int x = box.z - 1; x >= box.x && first >= 0 && last < 0; --x)\n"
    "        if (texelFetch(tr_seed, ivec2(x, at.y), 0).r != TR_CLEAR_DEPTH)\n"
    "            last = x;\n"
    "    tr_extent = uvec4(uint(first + 1), uint(last + 1), 0u, 0u);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_forms_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What circle, ellipse and convex hull of a target's pixels are found by, a column of texels a mask: how far the pixels' middles\n"
    "// reach in each of 64 directions, then how much the rectangle of all has to be scaled for circle or ellipse to hold them.\n"
    "// Bits of floats; 0: the target has no pixel.\n"
    "uniform highp usampler2D tr_extents; // of seq_extents.frag\n"
    "layout(location = 0) out highp uvec4 tr_form;\n"
    "\n"
    "// Calls nothing for rows without the target; x: first, y: last, both middles of pixels.\n"
    "bool tr_row(int mask, int row, out highp vec2 ends)\n"
    "{\n"
    "    highp uvec2 extent = texelFetch(tr_extents, ivec2(mask, row), 0).rg;\n"
    "    ends = vec2(extent) - 0.5;\n"
    "    return extent.x != 0u;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
    "    highp ivec4 box = ivec4(tr_masks[at.x].box);\n"
    "    highp vec2 ends, low = vec2(1.0e6), high = vec2(-1.0e6);\n"
    "    highp float angle = float(at.y) * (6.283185307179586 / 64.0), reach = -1.0e6, scale = 0.0;\n"
    "    highp vec2 way = vec2(cos(angle), sin(angle));\n"
    "    for (int y = box.y; y < box.w; ++y) {\n"
    "        highp float middle = float(y) + 0.5;\n"
    "        if (!tr_row(at.x, y, ends))\n"
    "            continue;\n"
    "        reach = max(reach, max(ends.x * way.x, ends.y * way.x) + middle * way.y);\n"
    "        low = min(low, vec2(ends.x, middle));\n"
    "        high = max(high, vec2(ends.y, middle));\n"
    "    }\n"
    "    tr_form = uvec4(0u);\n"
    "    if (high.x < 0.0)\n"
    "        return;\n"
    "    tr_form.r = floatBitsToUint(reach);\n"
    "    if (at.y < 64)\n"
    "        return;\n"
    "    highp vec2 radius = tr_seq_law.w == 1.0 ? vec2(1.0) : (high - low) * 0.5, centre = (low + high) * 0.5;\n"
    "    for (int y = box.y; y < box.w; ++y) {\n"
    "        highp float up = float(y) + 0.5 - centre.y, across;\n"
    "        if (!tr_row(at.x, y, ends))\n"
    "            continue;\n"
    "        across = max(abs(ends.x - centre.x), abs(ends.y - centre.x));\n"
    "        scale = max(scale, length(vec2(radius.x > 0.0 ? across / radius.x : 0.0, radius.y > 0.0 ? up / radius.y : 0.0)));\n"
    "    }\n"
    "    // A single pixel has none; 0 would say that there is not even that.\n"
    "    tr_form.r = floatBitsToUint(max(scale, 1.0e-6));\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_keep_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// After a layer is peeled: whose it is goes where later layers look it up, with whether it ends the pixel.\n"
    "uniform highp sampler2D tr_reach;\n"
    "uniform highp usampler2D tr_code;             // of the layer\n"
    "uniform highp sampler2DArray tr_layer_now;    // its depth\n"
    "uniform highp sampler2DArray tr_layer_before; // that of the one before\n"
    "layout(location = 0) out highp uvec4 tr_kept;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    int layer = tr_seq_step.x;\n"
    "    highp float reach = texelFetch(tr_reach, pixel, 0).r, depth = texelFetch(tr_layer_now, ivec3(pixel, layer >> 1), 0).r;\n"
    "    highp uint code = texelFetch(tr_code, pixel, 0).r;\n"
    "    if (reach == TR_NO_REACH)\n"
    "        discard;\n"
    "    if (depth == TR_CLEAR_DEPTH)\n"
    "        code = TR_LAYER_LAST | TR_LAYER_NONE;\n"
    "    else if (!TR_NEARER(depth, reach))\n"
    "        code |= TR_LAYER_LAST;\n"
    "    if (layer > 0 && depth == texelFetch(tr_layer_before, ivec3(pixel, (layer - 1) >> 1), 0).r)\n"
    "        code |= TR_LAYER_COINCIDENT;\n"
    "    tr_kept = uvec4(code, 0u, 0u, 0u);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_layers_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Layers of TR_SEE_EXACT: whose each is, front to back. The codes of units, with what is known of the layer in bits that\n"
    "// those leave free.\n"
    "#define TR_LAYER_LAST (1u << 21)       // no mask looks through it, or there is nothing\n"
    "#define TR_LAYER_NONE (1u << 22)       // there is none\n"
    "#define TR_LAYER_COINCIDENT (1u << 23) // at the same depth as the one before\n"
    "\n"
    "// What of an occluder a mask lets be, of a target's importance: an occluder that is a target counts one less.\n"
    "highp float tr_yields(highp float importance, highp uint code)\n"
    "{\n"
    "    highp float occluder = float(code >> 24) * (1.0 / 255.0);\n"
    "    if ((code & TR_CODE_CLOSES) != 0u)\n"
    "        return 0.0;\n"
    "    return clamp(importance - ((code & TR_CODE_TARGET) != 0u ? occluder - 1.0 : occluder), 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_mask_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Adds the masks of a run to those of targets painted before, by GL_MIN or by multiplication. Red: where the target\n"
    "// itself is not; green: where it is, which alone cuts other targets.\n"
    "#if TR_TOGETHER\n"
    "uniform highp sampler2D tr_remaining; // occluders still to be painted, in 255ths\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_alphas;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    bool own;\n"
    "    highp float depth, alpha = tr_mask_at(pixel, own, depth);\n"
    "    if (alpha >= 1.0)\n"
    "        discard;\n"
    "#if TR_TOGETHER\n"
    "    highp vec2 after = texelFetch(tr_remaining, pixel, 0).rg;\n"
    "    highp float m = floor((own ? after.g : after.r) * 255.0 + 0.5);\n"
    "    alpha = tr_shared(alpha, tr_seq_numbers.z > 0 ? min(m, float(tr_seq_numbers.z)) : m);\n"
    "#endif\n"
    "    alpha = mix(1.0, alpha, tr_masks[tr_v_mask].law.z);\n"
    "    tr_alphas = own ? vec4(1.0, alpha, 1.0, 1.0) : vec4(alpha, 1.0, 1.0, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_mask_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What the mask of a target asks for at a pixel: Assarsson 2006, rule R2 and figure 2.\n"
    "uniform highp sampler2D tr_seed;          // depth where the target is, open\n"
    "uniform highp usampler2D tr_nearest_seed; // of seq_near.frag\n"
    "flat in highp int tr_v_mask;\n"
    "\n"
    "int tr_seed_distance(ivec2 way)\n"
    "{\n"
    "#if TR_RINGS\n"
    "    int rings = max(abs(way.x), abs(way.y));\n"
    "    return rings * rings;\n"
    "#else\n"
    "    return way.x * way.x + way.y * way.y;\n"
    "#endif\n"
    "}\n"
    "\n"
    "// The square of the distance from a pixel to the nearest pixel of the target, and the depth there; -1: none within reach.\n"
    "// The target itself is had at full resolution; around it the nearest of what the four cells around have found is taken.\n"
    "int tr_find_seed(ivec2 pixel, out highp float depth)\n"
    "{\n"
    "    int cell = tr_seq_numbers.x, least = -1;\n"
    "    depth = texelFetch(tr_seed, pixel, 0).r;\n"
    "    if (depth != TR_CLEAR_DEPTH)\n"
    "        return 0;\n"
    "    ivec2 last = (tr_seq_view.zw - 1) / cell;\n"
    "    ivec2 first = (2 * pixel - (cell - 1) + 2 * cell) / (2 * cell) - 1; // rounded down\n"
    "    for (int i = 0; i < (cell == 1 ? 1 : 4); ++i) {\n"
    "        ivec2 at = clamp(first + ivec2(i & 1, i >> 1), ivec2(0), last);\n"
    "        highp uvec2 found = texelFetch(tr_nearest_seed, at, 0).rg;\n"
    "        if (found.x == 0u)\n"
    "            continue;\n"
    "        ivec2 seed = at * cell + ivec2(found) - 32768;\n"
    "        int size = tr_seed_distance(seed - pixel);\n"
    "        highp float there = texelFetch(tr_seed, seed, 0).r;\n"
    "        if (least >= 0 && (size > least || (size == least && !TR_NEARER(there, depth))))\n"
    "            continue;\n"
    "        least = size;\n"
    "        depth = there;\n"
    "    }\n"
    "    return least;\n"
    "}\n"
    "\n"
    "// The strongest of the search lights: 1 within its radius, falling to 0 over its edge.\n"
    "highp float tr_light_at(highp vec2 place)\n"
    "{\n"
    "    highp float most = 0.0;\n"
    "    for (int i = 0; i < tr_seq_numbers.w; ++i) {\n"
    "        highp vec4 light = tr_seq_lights[i];\n"
    "        highp float beyond = length(place - light.xy) - light.z;\n"
    "        most = max(most, beyond <= 0.0 ? 1.0 : light.w > 0.0 ? clamp(1.0 - beyond / light.w, 0.0, 1.0) : 0.0);\n"
    "    }\n"
    "    return most;\n"
    "}\n"
    "\n"
    "uniform highp usampler2D tr_forms; // of seq_forms.frag\n"
    "\n"
    "highp float tr_form_at(int texel)\n"
    "{\n"
    "    return uintBitsToFloat(texelFetch(tr_forms, ivec2(tr_v_mask, texel), 0).r);\n"
    "}\n"
    "\n"
    "// How many pixels outside of circle, ellipse or hull a pixel's middle lies; 0 within.\n"
    "highp float tr_beyond_form(highp vec2 place)\n"
    "{\n"
    "    highp vec2 high = vec2(tr_form_at(0), tr_form_at(16)), low = -vec2(tr_form_at(32), tr_form_at(48));\n"
    "    highp vec2 radius = (high - low) * 0.5, way = place - (low + high) * 0.5;\n"
    "    highp float scale = tr_form_at(64), beyond = 0.0;\n"
    "    if (tr_seq_law.w == 1.0)\n"
    "        return max(length(way) - scale, 0.0);\n"
    "    if (tr_seq_law.w == 2.0) { // along the ray from the middle\n"
    "        highp vec2 far = vec2(radius.x > 0.0 ? way.x / (radius.x * scale) : 0.0,\n"
    "                              radius.y > 0.0 ? way.y / (radius.y * scale) : 0.0);\n"
    "        highp float size = length(far);\n"
    "        return size > 1.0 ? length(way) * (1.0 - 1.0 / size) : 0.0;\n"
    "    }\n"
    "    // The hull by the lines that touch it in 64 directions: at a corner it is off by a hundredth of the sides there.\n"
    "    for (int i = 0; i < 64; ++i) {\n"
    "        highp float angle = float(i) * (6.283185307179586 / 64.0);\n"
    "        beyond = max(beyond, dot(place, vec2(cos(angle), sin(angle))) - tr_form_at(i));\n"
    "    }\n"
    "    return beyond;\n"
    "}\n"
    "\n"
    "// Opacity that what is before the target is to have together; 1: no mask here. own: the target itself is here.\n"
    "highp float tr_mask_at(ivec2 pixel, out bool own, out highp float depth)\n"
    "{\n"
    "    int square = tr_find_seed(pixel, depth);\n"
    "    own = square == 0;\n"
    "    if (square < 0)\n"
    "        return 1.0;\n"
    "    highp float beyond = tr_seq_law.w > 0.0 ? tr_beyond_form(vec2(pixel) + 0.5) : max(sqrt(float(square)) - 1.0, 0.0);\n"
    "    // Pixels of the target lie on the form's very outline, but for rounding.\n"
    "    beyond = beyond > 1.0e-3 ? beyond : 0.0;\n"
    "    highp float opacity = 1.0;\n",
    "#line 95\n"
    "    if (own || (tr_seq_law.w > 0.0 && beyond <= 0.0))\n"
    "        opacity = tr_seq_law.x;\n"
    "    else if (tr_seq_law.z > 0.0)\n"
    "        opacity = mix(tr_seq_law.y, 1.0, min(beyond / tr_seq_law.z, 1.0));\n"
    "    highp float strength = tr_masks[tr_v_mask].law.x;\n"
    "    if (tr_masks[tr_v_mask].law.y > 0.0)\n"
    "        strength *= tr_light_at(vec2(pixel) + 0.5);\n"
    "    return mix(1.0, opacity, strength);\n"
    "}\n"
    "\n"
    "// What each of m layers has so that together they have this opacity (Carnecky 2013, equation 5).\n"
    "highp float tr_shared(highp float opacity, highp float m)\n"
    "{\n"
    "    return m > 0.0 ? 1.0 - pow(1.0 - opacity, 1.0 / m) : opacity;\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_near_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The nearest pixel of a target, second half: over the rows above and below, for the middle of each cell. Distances are\n"
    "// those between centres of pixels, or counted in rings of eight neighbours (TR_RINGS). Of several equally near that\n"
    "// nearest to the eye. Stored: its column and row, from the cell's first, + 32768; 0: none.\n"
    "uniform highp usampler2D tr_rows; // of seq_row.frag\n"
    "uniform highp sampler2D tr_seed;\n"
    "flat in highp int tr_v_mask;\n"
    "layout(location = 0) out highp uvec4 tr_nearest;\n"
    "\n"
    "int tr_size(ivec2 way)\n"
    "{\n"
    "#if TR_RINGS\n"
    "    return max(abs(way.x), abs(way.y));\n"
    "#else\n"
    "    return way.x * way.x + way.y * way.y;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    highp ivec2 at = ivec2(gl_FragCoord.xy);\n"
    "    highp ivec4 box = ivec4(tr_masks[tr_v_mask].box);\n"
    "    int cell = tr_seq_numbers.x, least = 0x7fffffff;\n"
    "    ivec2 first = at * cell, best = ivec2(0);\n"
    "    for (int i = 0; i <= 2 * (tr_seq_numbers.y + cell) + 1; ++i) {\n"
    "        int row = first.y + (i % 2 == 0 ? (cell - 1) / 2 - i / 2 : cell / 2 + i / 2);\n"
    "        // In halves of pixels, since the middle of a cell may lie between two.\n"
    "        int dy = 2 * (row - first.y) - (cell - 1);\n"
    "        if (tr_size(ivec2(0, dy)) > least)\n"
    "            break;\n"
    "        if (row < box.y || row >= box.w || (cell % 2 == 1 && i == 1))\n"
    "            continue;\n"
    "        int column = int(texelFetch(tr_rows, ivec2(at.x, row), 0).r) - 32768;\n"
    "        if (column == -32768)\n"
    "            continue;\n"
    "        int size = tr_size(ivec2(2 * column - (cell - 1), dy));\n"
    "        if (size > least)\n"
    "            continue;\n"
    "        ivec2 seed = ivec2(first.x + column, row);\n"
    "        if (size == least && !TR_NEARER(texelFetch(tr_seed, seed, 0).r, texelFetch(tr_seed, best, 0).r))\n"
    "            continue;\n"
    "        least = size;\n"
    "        best = seed;\n"
    "    }\n"
    "    tr_nearest = least == 0x7fffffff ? uvec4(0u) : uvec4(uvec2(best - first + 32768), 0u, 0u);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_own_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What was painted into a target of our own, over the host's: colour is premultiplied.\n"
    "uniform highp sampler2D tr_own_color;\n"
    "uniform highp sampler2D tr_own_depth;\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - tr_seq_view.xy;\n"
    "    tr_color = texelFetch(tr_own_color, pixel, 0);\n"
    "    if (tr_color.a <= 0.0)\n"
    "        discard;\n"
    "    gl_FragDepth = texelFetch(tr_own_depth, pixel, 0).r;\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_reach_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// How far the masks of a pixel look: the farthest of their depths is kept by the depth test.\n"
    "void main()\n"
    "{\n"
    "    bool own;\n"
    "    highp float depth, opacity = tr_mask_at(ivec2(gl_FragCoord.xy), own, depth);\n"
    "    if (opacity >= 1.0)\n"
    "        discard;\n"
    "    gl_FragDepth = depth;\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_row_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The nearest pixel of a target to the left or right, first half of an exact distance: along the row, for the middle of\n"
    "// each cell. Of two equally near the one nearer to the eye. Stored: its column, from the cell's first, + 32768; 0: none.\n"
    "uniform highp sampler2D tr_seed; // depth where a target is\n"
    "flat in highp int tr_v_mask;\n"
    "layout(location = 0) out highp uvec4 tr_nearest;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    highp ivec2 at = ivec2(gl_FragCoord.xy);\n"
    "    highp ivec4 box = ivec4(tr_masks[tr_v_mask].box);\n"
    "    int cell = tr_seq_numbers.x, first = at.x * cell, low = first + (cell - 1) / 2, high = first + cell / 2;\n"
    "    tr_nearest = uvec4(0u);\n"
    "    for (int i = 0; i <= tr_seq_numbers.y + cell; ++i) {\n"
    "        int left = low - i, right = high + i;\n"
    "        highp float to_left = left >= box.x && left < box.z ? texelFetch(tr_seed, ivec2(left, at.y), 0).r : TR_CLEAR_DEPTH;\n"
    "        highp float to_right =\n"
    "            right >= box.x && right < box.z ? texelFetch(tr_seed, ivec2(right, at.y), 0).r : TR_CLEAR_DEPTH;\n"
    "        if (to_left == TR_CLEAR_DEPTH && to_right == TR_CLEAR_DEPTH)\n"
    "            continue;\n"
    "        tr_nearest.r = uint((TR_NEARER(to_right, to_left) ? right : left) - first + 32768);\n"
    "        break;\n"
    "    }\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_share_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What the masks of a run leave of the opacity of four layers, over those before by GL_MIN or by multiplication:\n"
    "// Assarsson 2006, rules R2 to R4, section 3.5. tr_seq_step.x: which four.\n"
    "uniform highp sampler2DArray tr_layer_even; // depths\n"
    "uniform highp sampler2DArray tr_layer_odd;\n"
    "uniform highp usampler2DArray tr_chain;\n"
    "layout(location = 0) out highp vec4 tr_alphas;\n"
    "\n"
    "// How much of a layer yields to the mask; 0: it does not act on it.\n"
    "highp float tr_acts(ivec2 pixel, int layer, highp uint code, bool own, highp float behind)\n"
    "{\n"
    "    highp vec4 law = tr_masks[tr_v_mask].law;\n"
    "    highp float depth = (layer & 1) == 0 ? texelFetch(tr_layer_even, ivec3(pixel, layer >> 1), 0).r\n"
    "                                         : texelFetch(tr_layer_odd, ivec3(pixel, layer >> 1), 0).r;\n"
    "    if ((code & 0xffffu) == uint(law.w) || !TR_NEARER(depth, behind) || ((code & TR_CODE_TARGET) != 0u && !own))\n"
    "        return 0.0;\n"
    "    return tr_yields(law.z, code);\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    bool own;\n"
    "    highp float behind, opacity = tr_mask_at(pixel, own, behind), m = 0.0;\n"
    "    highp vec4 yields = vec4(0.0);\n"
    "    if (opacity >= 1.0)\n"
    "        discard;\n"
    "    for (int i = 0; i < tr_seq_more.x; ++i) {\n"
    "        highp uint code = texelFetch(tr_chain, ivec3(pixel, i), 0).r;\n"
    "        if ((code & TR_LAYER_NONE) != 0u || (tr_seq_numbers.z > 0 && m >= float(tr_seq_numbers.z)))\n"
    "            break;\n"
    "        highp float yield_ = tr_acts(pixel, i, code, own, behind);\n"
    "        if (i >> 2 == tr_seq_step.x)\n"
    "            yields[i & 3] = yield_;\n"
    "        m += yield_ > 0.0 ? 1.0 : 0.0;\n"
    "        if ((code & TR_LAYER_LAST) != 0u)\n"
    "            break;\n"
    "    }\n"
    "    tr_alphas = mix(vec4(1.0), vec4(tr_seq_more.w != 0 ? tr_shared(opacity, m) : opacity), yields);\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_units_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Fragment stage. What a unit's fragment does in the passes of TR_SEE_SEQUENCE, TR_SEE_PUBLISHED and TR_SEE_EXACT.\n"
    "//\n"
    "// A host's fragment shader calls tr_see_through(color, code) once, last in main, before it writes color to its output of\n"
    "// location 0. code: what tr_unit_code makes; see seq_codes.glsl. TR_RULE_SEE_PEEL writes the code to location 1: shaders for\n"
    "// it have an output at location 0 and no other.\n"
    "#define TR_RULE_SEE_BLOCK 16 // of the cheaper rungs\n"
    "#define TR_RULE_SEE_DEPTH 22 // front-most surfaces: depth alone\n"
    "#define TR_RULE_SEE_SEED 23  // where a target is, open\n"
    "#define TR_RULE_SEE_BLEND 24 // colour, with the opacity that masks leave\n"
    "#define TR_RULE_SEE_BLEND_LAYERS 25 // the same under layer control\n"
    "#define TR_RULE_SEE_COUNT 26 // occluders a pixel\n"
    "#define TR_RULE_SEE_PEEL 27  // the next layer of those within masks\n"
    "\n"
    "// What an occluder keeps of its opacity whatever masks say. A target counts one less than it does as a target.\n"
    "highp float tr_code_keeps(highp uint code)\n"
    "{\n"
    "    if ((code & TR_CODE_CLOSES) != 0u)\n"
    "        return 1.0;\n"
    "    return (code & TR_CODE_TARGET) != 0u ? 0.0 : float(code >> 24) * (1.0 / 255.0);\n"
    "}\n"
    "\n"
    "#if TR_RULE == TR_RULE_SEE_SEED\n"
    "uniform highp sampler2D tr_block_depth; // of what closes masks\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_SEE_BLEND || TR_RULE == TR_RULE_SEE_BLEND_LAYERS\n"
    "uniform highp sampler2D tr_mask_alphas; // of seq_mask.frag\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_SEE_BLEND_LAYERS\n"
    "uniform highp sampler2D tr_remaining; // occluders still to be painted, in 255ths\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_SEE_BLEND || TR_RULE == TR_RULE_SEE_BLEND_LAYERS\n"
    "highp float tr_opacity_of(highp uint code)\n"
    "{\n"
    "    highp float keeps = tr_code_keeps(code);\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - (tr_seq_step.w != 0 ? ivec2(0) : tr_seq_view.xy);\n"
    "    if (keeps >= 1.0)\n"
    "        return 1.0;\n"
    "    highp vec2 alphas = texelFetch(tr_mask_alphas, pixel, 0).rg;\n"
    "#if TR_RULE == TR_RULE_SEE_BLEND_LAYERS\n"
    "    // As many as are still to come lie nearer to the eye; of solids this one is among them. All of a hollow one's count as\n"
    "    // one.\n"
    "    highp vec2 nearer = texelFetch(tr_remaining, pixel, 0).rg * 255.0 + ((code & TR_CODE_HOLLOW) != 0u ? 0.5 : -0.5);\n"
    "    alphas = mix(alphas, vec2(1.0), greaterThan(nearer, vec2(float(tr_seq_numbers.z))));\n"
    "#endif\n"
    "    if ((code & TR_CODE_TARGET) != 0u && tr_seq_step.z == 0)\n"
    "        alphas.r = 1.0;\n"
    "    return mix(tr_seq_step.y != 0 ? alphas.r * alphas.g : min(alphas.r, alphas.g), 1.0, keeps);\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_SEE_PEEL\n"
    "layout(location = 1) out highp uint tr_layer_code;\n"
    "uniform highp sampler2D tr_reach;             // the farthest that masks look through; TR_NO_REACH: no mask\n"
    "uniform highp sampler2DArray tr_layer_before; // depth, of this layer's parity less one\n"
    "uniform highp usampler2DArray tr_chain;       // codes of the layers before\n"
    "\n"
    "// Whether a surface may be the next layer: behind or at the last one, of a unit that has none yet. Those of hollow units\n"
    "// are told apart by their depths.\n"
    "bool tr_may_be_next(highp uint code, ivec2 pixel, int layer)\n"
    "{\n"
    "    highp uint last = texelFetch(tr_chain, ivec3(pixel, layer - 1), 0).r;\n"
    "    highp float before = texelFetch(tr_layer_before, ivec3(pixel, (layer - 1) >> 1), 0).r;\n"
    "    bool hollow = (code & TR_CODE_HOLLOW) != 0u, same_depth = gl_FragCoord.z == before;\n"
    "    if ((last & TR_LAYER_LAST) != 0u || TR_NEARER(gl_FragCoord.z, before))\n"
    "        return false;\n"
    "    for (int i = layer - 1; i >= 0 && (!hollow || same_depth); --i) {\n"
    "        highp uint other = texelFetch(tr_chain, ivec3(pixel, i), 0).r;\n"
    "        if (((other ^ code) & 0xffffu) == 0u)\n"
    "            return false;\n"
    "        same_depth = same_depth && (other & TR_LAYER_COINCIDENT) != 0u;\n"
    "    }\n"
    "    return true;\n"
    "}\n"
    "\n"
    "bool tr_peels(highp uint code)\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    highp float reach = texelFetch(tr_reach, pixel, 0).r;\n"
    "    int layer = tr_seq_step.x;\n"
    "    if (reach == TR_NO_REACH || ((code & TR_CODE_HOLLOW) != 0u && !gl_FrontFacing))\n",
    "#line 82\n"
    "        return false;\n"
    "    // The last place is kept for what ends the pixel, so that layers that are too many lose no target.\n"
    "    if (tr_seq_more.y != 0 && layer == tr_seq_more.x - 1 && TR_NEARER(gl_FragCoord.z, reach) &&\n"
    "        (code & TR_CODE_CLOSES) == 0u)\n"
    "        return false;\n"
    "    return layer == 0 || tr_may_be_next(code, pixel, layer);\n"
    "}\n"
    "#endif\n"
    "\n"
    "void tr_see_through(inout highp vec4 color, highp uint code)\n"
    "{\n"
    "#if TR_RULE == TR_RULE_SEE_SEED\n"
    "    if (tr_seq_more.z != 0 && TR_NEARER(texelFetch(tr_block_depth, ivec2(gl_FragCoord.xy), 0).r, gl_FragCoord.z))\n"
    "        discard;\n"
    "    gl_FragDepth = gl_FragCoord.z;\n"
    "#elif TR_RULE == TR_RULE_SEE_PEEL\n"
    "    // Depths are written as they are compared, so that equality means the same surface.\n"
    "    if (!tr_peels(code))\n"
    "        discard;\n"
    "    tr_layer_code = code & 0xff1fffffu;\n"
    "    gl_FragDepth = gl_FragCoord.z;\n"
    "#elif TR_RULE == TR_RULE_SEE_BLEND || TR_RULE == TR_RULE_SEE_BLEND_LAYERS\n"
    "    color.a = tr_opacity_of(code);\n"
    "#elif TR_RULE == TR_RULE_SEE_COUNT\n"
    "    // Red: what a mask acts on beside its target, green: what it acts on where the target is.\n"
    "    if (tr_code_keeps(code) >= 1.0)\n"
    "        discard;\n"
    "    bool beside = (code & TR_CODE_TARGET) == 0u || tr_seq_step.z != 0;\n"
    "    color = vec4(beside ? 1.0 : 0.0, 1.0, 0.0, 0.0) * (1.0 / 255.0);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const tr_i_shader_seq_wipe_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Makes a texture of depths forget what was within the boxes.\n"
    "void main()\n"
    "{\n"
    "    gl_FragDepth = TR_CLEAR_DEPTH;\n"
    "}\n",
    0};
static const char *const tr_i_shader_surface_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Built-in surface program for hosts without shaders of their own: fragment stage.\n"
    "uniform highp uint tr_object;\n"
    "#if TR_STRENGTHENS\n"
    "uniform highp ivec2 tr_crossing_range;\n"
    "in highp vec3 tr_v_position;\n"
    "#endif\n"
    "#if TR_WANTS_COLOR\n"
    "in highp vec3 tr_v_normal;\n"
    "in highp vec4 tr_v_color;\n"
    "#endif\n"
    "\n"
    "#if TR_IS_SEE && TR_RULE != TR_RULE_SEE_BLOCK\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if TR_WANTS_COLOR\n"
    "    highp float length_squared = dot(tr_v_normal, tr_v_normal);\n"
    "    // A missing or cancelled normal shades as if it faced across the light, not as NaN.\n"
    "    highp vec3 normal = length_squared > 0.0 ? tr_v_normal * inversesqrt(length_squared) : vec3(0.0);\n"
    "    if (!gl_FrontFacing)\n"
    "        normal = -normal;\n"
    "    highp vec4 color = vec4(tr_cool_to_warm(tr_v_color.rgb, normal, tr_light.xyz, tr_cool, tr_warm), tr_v_color.a);\n"
    "#if TR_STRENGTHENS\n"
    "    color = tr_strengthen(color, tr_v_position, tr_crossing_range);\n"
    "#endif\n"
    "#if TR_WANTS_ALPHA\n"
    "    if (tr_may_show())\n"
    "        color.a *= tr_alpha();\n"
    "#endif\n"
    "#else\n"
    "    highp vec4 color = vec4(0.0);\n"
    "#endif\n"
    "#if TR_IS_SEE\n"
    "    tr_see_through(color, tr_object);\n"
    "#if TR_RULE != TR_RULE_SEE_BLOCK\n"
    "    tr_color = color;\n"
    "#endif\n"
    "#else\n"
    "    tr_surface(color, tr_object);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const tr_i_shader_surface_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Built-in surface program for hosts without shaders of their own: vertex stage.\n"
    "layout(location = 0) in highp vec3 tr_position;\n"
    "layout(location = 1) in highp vec3 tr_normal;\n"
    "layout(location = 2) in highp float tr_distance; // to the nearest silhouette, for the rungs of alpha that want it\n"
    "layout(location = 3) in highp vec3 tr_tint;      // added to the object's colour; by default 0\n"
    "#if TR_WANTS_ALPHA && TR_ALPHA == TR_ALPHA_CANDIDATES\n"
    "layout(location = 4) in highp uint tr_triangle; // its number, at the last vertex of each\n"
    "#else\n"
    "#define tr_triangle 0u\n"
    "#endif\n"
    "\n"
    "uniform highp mat4 tr_model_view_projection;\n"
    "#if TR_STRENGTHENS\n"
    "uniform highp mat4 tr_model;\n"
    "out highp vec3 tr_v_position;\n"
    "#endif\n"
    "#if TR_WANTS_COLOR\n"
    "uniform highp mat3 tr_normal_matrix;\n"
    "uniform highp vec4 tr_object_color; // a: alpha on the silhouette\n"
    "out highp vec3 tr_v_normal;\n"
    "out highp vec4 tr_v_color;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if TR_WANTS_COLOR\n"
    "    tr_v_normal = tr_normal_matrix * tr_normal;\n"
    "    tr_v_color = vec4(tr_object_color.rgb + tr_tint, tr_object_color.a);\n"
    "#endif\n"
    "#if TR_WANTS_ALPHA\n"
    "    tr_alpha_vertex(tr_position, tr_distance, tr_triangle);\n"
    "#endif\n"
    "#if TR_STRENGTHENS\n"
    "    tr_v_position = (tr_model * vec4(tr_position, 1.0)).xyz;\n"
    "#endif\n"
    "    gl_Position = tr_model_view_projection * vec4(tr_position, 1.0);\n"
    "}\n",
    0};
static const char *const tr_i_shader_surface_rules_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Fragment stage. What a surface fragment does in each pass of a sequence: Diepstraten 2002, section 6, as amended.\n"
    "//\n"
    "// A host's fragment shader calls tr_surface(color, object) once, last, in main. TR_RULE is defined by the preamble.\n"
    "// Depths of transparent things are written and compared as the shader sees them (gl_FragCoord.z, stored unrounded in\n"
    "// 32-bit float depth), so that equality means \"the same fragment\" and no epsilon is needed. Opaque things write no\n"
    "// depth here: they keep the early depth test.\n"
    "//\n"
    "// object: the number that tr_object_code makes. Bits 0 to 23: id, 24 to 30: group, 31: explicit interiors.\n"
    "\n"
    "#define TR_RULE_FRONT 0        // nearest front face: depth only\n"
    "#define TR_RULE_FRONT_ALONE 1  // and its colour, when no other transparent object can tie\n"
    "#define TR_RULE_PEEL 2         // the next layer behind another: depth only\n"
    "#define TR_RULE_PEEL_ALONE 3   // and its colour\n"
    "#define TR_RULE_PEEL_GROUP 4   // the next front face of an object that none of the layers before shows\n"
    "#define TR_RULE_LAYER 5        // whose a layer is, the lowest id among those that tie, and its colour\n"
    "#define TR_RULE_LAYER_MARKED 6 // and its group and method\n"
    "#define TR_RULE_LAYER_GROUP 7  // a further layer: only of the first one's group, and near enough\n"
    "#define TR_RULE_LIMIT 8        // where opaque things stop to show: one-sided transparent objects\n"
    "#define TR_RULE_LIMIT_SHEET 9  // the same for two-sided ones, whose both sides count as front\n"
    "#define TR_RULE_LIMIT_BEHIND 10 // whatever faces the pass culls not, behind a layer\n"
    "#define TR_RULE_LIMIT_MARKED 11 // by the method of the front-most object, past its group\n"
    "#define TR_RULE_LIMIT_MARKED_SHEET 12\n"
    "#define TR_RULE_OPAQUE 13 // opaque colour\n"
    "#define TR_RULE_OPAQUE_ENTERING 14 // the same; tr_strengthen, of crossings.glsl, does something\n"
    "\n"
    "#if TR_WANTS_COLOR // defined by the preamble; where it is 0 color is not read and a host may skip its shading\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_LAYER_MARKED\n"
    "layout(location = 1) out highp float tr_marking;\n"
    "#endif\n"
    "\n"
    "#define TR_IS_LIMIT_MARKED (TR_RULE == TR_RULE_LIMIT_MARKED || TR_RULE == TR_RULE_LIMIT_MARKED_SHEET)\n"
    "#define TR_IS_FIRST (TR_RULE == TR_RULE_FRONT || TR_RULE == TR_RULE_FRONT_ALONE)\n"
    "\n"
    "#if !TR_IS_FIRST && TR_RULE < TR_RULE_OPAQUE\n"
    "uniform highp sampler2DArray tr_front_depth; // of layers 0, 2, 4, ...; where one alone is read, those of its parity\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_LAYER_GROUP || TR_IS_LIMIT_MARKED\n"
    "uniform highp sampler2DArray tr_odd_depth; // of layers 1, 3, 5, ...; in TR_RULE_LAYER_GROUP those of the layer before\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET\n"
    "uniform highp sampler2DArray tr_front_owner;\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_PEEL_GROUP || TR_RULE == TR_RULE_LAYER_GROUP || TR_IS_LIMIT_MARKED\n"
    "uniform highp sampler2D tr_front_mark;\n"
    "#endif\n"
    "\n"
    "#ifdef TR_REVERSED_Z\n"
    "#define TR_BEHIND(a, b) ((a) < (b))\n"
    "#else\n"
    "#define TR_BEHIND(a, b) ((a) > (b))\n"
    "#endif\n"
    "\n"
    "// Object ids travel as depths: n / 2^24 is exact in a float, and the depth test keeps the lowest.\n"
    "highp float tr_owner_code(highp uint object)\n"
    "{\n"
    "    return float(object & 0xffffffu) * (1.0 / 16777216.0);\n"
    "}\n"
    "\n"
    "#if TR_RULE == TR_RULE_PEEL_GROUP || TR_RULE == TR_RULE_LAYER_GROUP || TR_IS_LIMIT_MARKED\n"
    "// Of the front-most object.\n"
    "highp uint tr_mark(ivec2 pixel)\n"
    "{\n"
    "    return uint(texelFetch(tr_front_mark, pixel, 0).r * 255.0 + 0.5);\n"
    "}\n"
    "\n"
    "bool tr_same_group(highp uint object, highp uint mark)\n"
    "{\n"
    "    return ((object >> 24) & 127u) == (mark & 127u) && (mark & 127u) != 0u;\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_PEEL_GROUP || TR_IS_LIMIT_MARKED\n"
    "bool tr_is_shown(highp uint object, int count, ivec2 pixel)\n"
    "{\n"
    "    for (int i = 0; i < count; ++i)\n"
    "        if (texelFetch(tr_front_owner, ivec3(pixel, i), 0).r == tr_owner_code(object))\n"
    "            return true;\n"
    "    return false;\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if TR_IS_LIMIT_MARKED\n",
    "#line 86\n"
    "// Whether a fragment ends what is seen through the last shown layer, by the method of the front-most object. Explicit\n"
    "// interiors end at the next face; implicit ones at a back face, or the face of an object that is not shown.\n"
    "bool tr_limits(highp float depth, bool faces_eye, highp uint object, ivec2 pixel)\n"
    "{\n"
    "    highp uint mark = tr_mark(pixel);\n"
    "    int count = tr_chain(pixel, tr_step.x + 1), last = count - 1;\n"
    "    highp float behind = (last & 1) == 0 ? texelFetch(tr_front_depth, ivec3(pixel, last >> 1), 0).r\n"
    "                                         : texelFetch(tr_odd_depth, ivec3(pixel, last >> 1), 0).r;\n"
    "    if (mark >= 128u)\n"
    "        return faces_eye && TR_BEHIND(depth, behind);\n"
    "    if (!faces_eye || tr_same_group(object, mark))\n"
    "        return TR_BEHIND(depth, behind) && !(faces_eye && tr_is_shown(object, count, pixel));\n"
    "    return !TR_BEHIND(behind, depth) && !tr_is_shown(object, count, pixel);\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_PEEL_GROUP\n"
    "// Whether a face may be the next layer: it joins the chain, or ends it. With implicit interiors further faces of objects\n"
    "// that are shown do neither, and faces of other groups end it where they coincide with the layer before, too.\n"
    "bool tr_may_follow(highp float depth, highp float before, highp uint object, ivec2 pixel)\n"
    "{\n"
    "    highp uint mark = tr_mark(pixel);\n"
    "    int count = tr_step.x + 1;\n"
    "    if ((mark & 127u) == 0u || tr_chain(pixel, count) < count)\n"
    "        return false;\n"
    "    if (mark >= 128u)\n"
    "        return TR_BEHIND(depth, before);\n"
    "    return !tr_is_shown(object, count, pixel) &&\n"
    "           (tr_same_group(object, mark) ? TR_BEHIND(depth, before) : !TR_BEHIND(before, depth));\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_LAYER_GROUP\n"
    "// Whether a face joins the chain: of the first layer's group, and near enough to the layer before (tr_blend.a; negative:\n"
    "// however far).\n"
    "bool tr_joins(highp float depth, highp uint object, ivec2 pixel)\n"
    "{\n"
    "    highp float before = texelFetch(tr_odd_depth, ivec3(pixel, (tr_step.x - 1) >> 1), 0).r;\n"
    "    highp float gap = tr_distance_of(depth) - tr_distance_of(before);\n"
    "    return tr_same_group(object, tr_mark(pixel)) && TR_BEHIND(depth, before) &&\n"
    "           (tr_blend.a < 0.0 || gap < tr_blend.a);\n"
    "}\n"
    "#endif\n"
    "\n"
    "// Whether tr_surface may keep this fragment's colour: for shaders that have much to do before they call it.\n"
    "bool tr_may_show()\n"
    "{\n"
    "#if TR_RULE == TR_RULE_LAYER || TR_RULE == TR_RULE_LAYER_MARKED || TR_RULE == TR_RULE_LAYER_GROUP\n"
    "    return gl_FragCoord.z == texelFetch(tr_front_depth, ivec3(gl_FragCoord.xy, tr_step.x >> 1), 0).r;\n"
    "#else\n"
    "    return true;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void tr_surface(highp vec4 color, highp uint object)\n"
    "{\n"
    "#if TR_RULE >= TR_RULE_OPAQUE\n"
    "    tr_color = vec4(color.rgb, 1.0); // alpha marks \"an opaque thing is here\"\n"
    "#else\n"
    "    highp float depth = gl_FragCoord.z;\n"
    "#if !TR_IS_FIRST\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "#if !TR_IS_LIMIT_MARKED\n"
    "    highp float front = texelFetch(tr_front_depth, ivec3(pixel, tr_step.x >> 1), 0).r;\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_PEEL || TR_RULE == TR_RULE_PEEL_ALONE || TR_RULE == TR_RULE_LIMIT_BEHIND\n"
    "    if (!TR_BEHIND(depth, front))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_PEEL_GROUP\n"
    "    if (!tr_may_follow(depth, front, object, pixel))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_LAYER || TR_RULE == TR_RULE_LAYER_MARKED\n"
    "    if (depth != front)\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_LAYER_GROUP\n"
    "    if (depth != front || !tr_joins(depth, object, pixel))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET\n"
    "    bool owner = texelFetch(tr_front_owner, ivec3(pixel, 0), 0).r == tr_owner_code(object);\n"
    "#if TR_RULE == TR_RULE_LIMIT\n"
    "    // A back face limits only what has a front face before it; a front face only if it is another object's.\n"
    "    if (gl_FrontFacing ? owner || TR_BEHIND(front, depth) : !TR_BEHIND(depth, front))\n"
    "        discard;\n"
    "#else\n"
    "    if (owner || TR_BEHIND(front, depth))\n"
    "        discard;\n"
    "#endif\n"
    "#elif TR_RULE == TR_RULE_LIMIT_MARKED\n",
    "#line 176\n"
    "    if (!tr_limits(depth, gl_FrontFacing, object, pixel))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_LIMIT_MARKED_SHEET\n"
    "    if (!tr_limits(depth, true, object, pixel))\n"
    "        discard;\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_LAYER_MARKED\n"
    "    tr_marking = float(object >> 24) * (1.0 / 255.0);\n"
    "#endif\n"
    "#if TR_WANTS_COLOR\n"
    "    tr_color = color;\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_LAYER || TR_RULE == TR_RULE_LAYER_MARKED || TR_RULE == TR_RULE_LAYER_GROUP\n"
    "    gl_FragDepth = tr_owner_code(object);\n"
    "#else\n"
    "    gl_FragDepth = depth;\n"
    "#endif\n"
    "#endif\n"
    "}\n",
    0};
static const char *const tr_i_shader_surface_vertex_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Vertex stage. What every vertex shader of a sequence shares.\n"
    "//\n"
    "// Passes compare depths for equality: all programs that draw an object must compute the very same position.\n"
    "invariant gl_Position;\n",
    0};
static const char *const tr_i_shader_take_opaque_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Opaque things from the host's textures. Of those the nearest alone can show, whatever the rule: where the limit hides it,\n"
    "// it hides all behind it. The depth test against the limit decides; the far value, which is nearer than nothing, is\n"
    "// background. What is outside of the textures, and NaN, too.\n"
    "//\n"
    "// TR_SUPERSAMPLE: the host's texel stands for that many of ours along each side.\n"
    "// TR_SRGB: what is read is light; our textures hold display values, IEC 61966-2-1.\n"
    "uniform highp sampler2D tr_scene_depth;  // the host's\n"
    "uniform highp sampler2D tr_opaque_color; // the host's\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "#ifdef TR_REVERSED_Z\n"
    "#define TR_IS_SOMETHING(depth) ((depth) > 0.0)\n"
    "#else\n"
    "#define TR_IS_SOMETHING(depth) ((depth) < 1.0)\n"
    "#endif\n"
    "\n"
    "highp vec3 tr_display_of(highp vec3 light)\n"
    "{\n"
    "#if TR_SRGB\n"
    "    light = clamp(light, 0.0, 1.0);\n"
    "    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));\n"
    "#else\n"
    "    return light;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 texel = ivec2(gl_FragCoord.xy) / TR_SUPERSAMPLE + tr_step.yz;\n"
    "    if (any(greaterThanEqual(texel, min(textureSize(tr_scene_depth, 0), textureSize(tr_opaque_color, 0)))))\n"
    "        discard;\n"
    "    highp float depth = texelFetch(tr_scene_depth, texel, 0).r;\n"
    "    if (!TR_IS_SOMETHING(depth))\n"
    "        discard;\n"
    "    tr_color = vec4(tr_display_of(texelFetch(tr_opaque_color, texel, 0).rgb), 1.0);\n"
    "    gl_FragDepth = depth;\n"
    "}\n",
    0};
/* clang-format on */
/* ==== end of generated shaders ==== */
/* clang-format on */

/* ---- GL: enumerants and the function table ---------------------------------------------------------------------- */

#define TR_I_GL_ALWAYS 0x0207u
#define TR_I_GL_BACK 0x0405u
#define TR_I_GL_BLEND 0x0BE2u
#define TR_I_GL_BLEND_DST_ALPHA 0x80CAu
#define TR_I_GL_BLEND_DST_RGB 0x80C8u
#define TR_I_GL_BLEND_EQUATION_ALPHA 0x883Du
#define TR_I_GL_BLEND_EQUATION_RGB 0x8009u
#define TR_I_GL_BLEND_SRC_ALPHA 0x80CBu
#define TR_I_GL_BLEND_SRC_RGB 0x80C9u
#define TR_I_GL_CCW 0x0901u
#define TR_I_GL_CLIP_DISTANCE0 0x3000u
#define TR_I_GL_COLOR 0x1800u
#define TR_I_GL_COLOR_ATTACHMENT0 0x8CE0u
#define TR_I_GL_COLOR_LOGIC_OP 0x0BF2u
#define TR_I_GL_COLOR_WRITEMASK 0x0C23u
#define TR_I_GL_COMPILE_STATUS 0x8B81u
#define TR_I_GL_COPY_WRITE_BUFFER 0x8F37u
#define TR_I_GL_COPY_WRITE_BUFFER_BINDING 0x8F37u
#define TR_I_GL_CULL_FACE 0x0B44u
#define TR_I_GL_CULL_FACE_MODE 0x0B45u
#define TR_I_GL_CURRENT_PROGRAM 0x8B8Du
#define TR_I_GL_CW 0x0900u
#define TR_I_GL_DEPTH 0x1801u
#define TR_I_GL_DEPTH_ATTACHMENT 0x8D00u
#define TR_I_GL_DEPTH_CLAMP 0x864Fu
#define TR_I_GL_DEPTH_COMPONENT 0x1902u
#define TR_I_GL_DEPTH_COMPONENT16 0x81A5u
#define TR_I_GL_DEPTH_COMPONENT24 0x81A6u
#define TR_I_GL_DEPTH_COMPONENT32 0x81A7u
#define TR_I_GL_DEPTH_COMPONENT32F 0x8CACu
#define TR_I_GL_DEPTH24_STENCIL8 0x88F0u
#define TR_I_GL_DEPTH32F_STENCIL8 0x8CADu
#define TR_I_GL_DEPTH_STENCIL 0x84F9u
#define TR_I_GL_UNSIGNED_INT_24_8 0x84FAu
#define TR_I_GL_FLOAT_32_UNSIGNED_INT_24_8_REV 0x8DADu
#define TR_I_GL_COLOR_BUFFER_BIT 0x4000u
#define TR_I_GL_DEPTH_BUFFER_BIT 0x0100u
#define TR_I_GL_STENCIL_BUFFER_BIT 0x0400u
#define TR_I_GL_DRAW_BUFFER0 0x8825u
#define TR_I_GL_READ_BUFFER 0x0C02u
#define TR_I_GL_FRONT_LEFT 0x0400u
#define TR_I_GL_BACK_LEFT 0x0402u
#define TR_I_GL_STENCIL 0x1802u
#define TR_I_GL_DEPTH_STENCIL_ATTACHMENT 0x821Au
#define TR_I_GL_ATTACHMENT_OBJECT_TYPE 0x8CD0u
#define TR_I_GL_ATTACHMENT_COLOR_ENCODING 0x8210u
#define TR_I_GL_ATTACHMENT_COMPONENT_TYPE 0x8211u
#define TR_I_GL_ATTACHMENT_DEPTH_SIZE 0x8216u
#define TR_I_GL_ATTACHMENT_STENCIL_SIZE 0x8217u
#define TR_I_GL_INT 0x1404u
#define TR_I_GL_SRGB 0x8C40u
#define TR_I_GL_DEPTH_FUNC 0x0B74u
#define TR_I_GL_DEPTH_RANGE 0x0B70u
#define TR_I_GL_DEPTH_TEST 0x0B71u
#define TR_I_GL_DEPTH_WRITEMASK 0x0B72u
#define TR_I_GL_DITHER 0x0BD0u
#define TR_I_GL_DRAW_FRAMEBUFFER 0x8CA9u
#define TR_I_GL_DRAW_FRAMEBUFFER_BINDING 0x8CA6u
#define TR_I_GL_DYNAMIC_DRAW 0x88E8u
#define TR_I_GL_EQUAL 0x0202u
#define TR_I_GL_FILL 0x1B02u
#define TR_I_GL_FLOAT 0x1406u
#define TR_I_GL_FRAGMENT_SHADER 0x8B30u
#define TR_I_GL_FRAMEBUFFER_COMPLETE 0x8CD5u
#define TR_I_GL_FRONT 0x0404u
#define TR_I_GL_FRONT_AND_BACK 0x0408u
#define TR_I_GL_FRONT_FACE 0x0B46u
#define TR_I_GL_FRAMEBUFFER_SRGB 0x8DB9u
#define TR_I_GL_FUNC_ADD 0x8006u
#define TR_I_GL_FUNC_REVERSE_SUBTRACT 0x800Bu
#define TR_I_GL_GEQUAL 0x0206u
#define TR_I_GL_GREATER 0x0204u
#define TR_I_GL_INVALID_INDEX 0xFFFFFFFFu
#define TR_I_GL_LEQUAL 0x0203u
#define TR_I_GL_LESS 0x0201u
#define TR_I_GL_LINK_STATUS 0x8B82u
#define TR_I_GL_MAX_CLIP_DISTANCES 0x0D32u
#define TR_I_GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS 0x8B4Du
#define TR_I_GL_MAX_DRAW_BUFFERS 0x8824u
#define TR_I_GL_MAX_TEXTURE_SIZE 0x0D33u
#define TR_I_GL_MAX_VIEWPORT_DIMS 0x0D3Au
#define TR_I_GL_MAX_VIEWPORTS 0x825Bu
#define TR_I_GL_MAX_UNIFORM_BUFFER_BINDINGS 0x8A2Fu
#define TR_I_GL_MIN 0x8007u
#define TR_I_GL_NEAREST 0x2600
#define TR_I_GL_CLAMP_TO_EDGE 0x812F
#define TR_I_GL_ONE 1u
#define TR_I_GL_ALREADY_SIGNALED 0x911Au
#define TR_I_GL_CONDITION_SATISFIED 0x911Cu
#define TR_I_GL_MAP_READ_BIT 1u
#define TR_I_GL_PIXEL_PACK_BUFFER 0x88EBu
#define TR_I_GL_PIXEL_PACK_BUFFER_BINDING 0x88EDu
#define TR_I_GL_STREAM_READ 0x88E1u
#define TR_I_GL_SYNC_FLUSH_COMMANDS_BIT 1u
#define TR_I_GL_SYNC_GPU_COMMANDS_COMPLETE 0x9117u
#define TR_I_GL_PIXEL_UNPACK_BUFFER 0x88ECu
#define TR_I_GL_PIXEL_UNPACK_BUFFER_BINDING 0x88EFu
#define TR_I_GL_POLYGON_MODE 0x0B40u
#define TR_I_GL_POLYGON_OFFSET_FILL 0x8037u
#define TR_I_GL_POLYGON_OFFSET_LINE 0x2A02u
#define TR_I_GL_POLYGON_OFFSET_POINT 0x2A01u
#define TR_I_GL_RASTERIZER_DISCARD 0x8C89u
#define TR_I_GL_R8 0x8229u
#define TR_I_GL_R16UI 0x8234u
#define TR_I_GL_RED 0x1903u
#define TR_I_GL_READ_FRAMEBUFFER 0x8CA8u
#define TR_I_GL_READ_FRAMEBUFFER_BINDING 0x8CAAu
#define TR_I_GL_RGBA 0x1908u
#define TR_I_GL_RGBA8 0x8058u
#define TR_I_GL_RGBA32F 0x8814u
#define TR_I_GL_RGBA16F 0x881Au
#define TR_I_GL_R32UI 0x8236u
#define TR_I_GL_RED_INTEGER 0x8D94u
#define TR_I_GL_RG16UI 0x823Au
#define TR_I_GL_RG16F 0x822Fu
#define TR_I_GL_RG_INTEGER 0x8228u
#define TR_I_GL_UNSIGNED_SHORT 0x1403u
#define TR_I_GL_UNSIGNED_INT 0x1405u
#define TR_I_GL_SAMPLER_BINDING 0x8919u
#define TR_I_GL_SAMPLES 0x80A9u
#define TR_I_GL_SAMPLE_ALPHA_TO_COVERAGE 0x809Eu
#define TR_I_GL_SAMPLE_COVERAGE 0x80A0u
#define TR_I_GL_SAMPLE_MASK 0x8E51u
#define TR_I_GL_SCISSOR_BOX 0x0C10u
#define TR_I_GL_SCISSOR_TEST 0x0C11u
#define TR_I_GL_SRC_ALPHA 0x0302u
#define TR_I_GL_SRC_COLOR 0x0300u
#define TR_I_GL_ONE_MINUS_SRC_ALPHA 0x0303u
#define TR_I_GL_RG 0x8227u
#define TR_I_GL_RG8 0x822Bu
#define TR_I_GL_SRGB8_ALPHA8 0x8C43u
#define TR_I_GL_STENCIL_TEST 0x0B90u
#define TR_I_GL_TEXTURE0 0x84C0u
#define TR_I_GL_TEXTURE_2D 0x0DE1u
#define TR_I_GL_TEXTURE_2D_ARRAY 0x8C1Au
#define TR_I_GL_TEXTURE_BINDING_2D 0x8069u
#define TR_I_GL_TEXTURE_BINDING_2D_ARRAY 0x8C1Du
#define TR_I_GL_TEXTURE_HEIGHT 0x1001u
#define TR_I_GL_TEXTURE_MAG_FILTER 0x2800u
#define TR_I_GL_TEXTURE_MIN_FILTER 0x2801u
#define TR_I_GL_TEXTURE_WIDTH 0x1000u
#define TR_I_GL_TEXTURE_WRAP_S 0x2802u
#define TR_I_GL_TEXTURE_WRAP_T 0x2803u
#define TR_I_GL_TRIANGLES 0x0004u
#define TR_I_GL_UNIFORM_BUFFER 0x8A11u
#define TR_I_GL_UNIFORM_BUFFER_BINDING 0x8A28u
#define TR_I_GL_UNIFORM_BUFFER_SIZE 0x8A2Au
#define TR_I_GL_UNIFORM_BUFFER_START 0x8A29u
#define TR_I_GL_UNPACK_ALIGNMENT 0x0CF5u
#define TR_I_GL_UNPACK_ROW_LENGTH 0x0CF2u
#define TR_I_GL_UNPACK_SKIP_PIXELS 0x0CF4u
#define TR_I_GL_UNPACK_SKIP_ROWS 0x0CF3u
#define TR_I_GL_UNPACK_SWAP_BYTES 0x0CF0u
#define TR_I_GL_UNSIGNED_BYTE 0x1401u
#define TR_I_GL_ACTIVE_TEXTURE 0x84E0u
#define TR_I_GL_VERSION 0x1F02u
#define TR_I_GL_VERTEX_ARRAY_BINDING 0x85B5u
#define TR_I_GL_VERTEX_SHADER 0x8B31u
#define TR_I_GL_VIEWPORT 0x0BA2u
#define TR_I_GL_ZERO 0u

typedef uint32_t tr_i_u;
typedef const char *const *tr_i_strings;

/* X(result type, name without gl, parameters). Sizes of GL types: GLenum, GLuint, GLbitfield 32 bits unsigned, GLint,
   GLsizei 32 bits signed, GLboolean, GLubyte unsigned char, GLsizeiptr pointer-sized. */
#define TR_I_GL_REQUIRED(X)                                                                                            \
    X(void, ActiveTexture, (tr_i_u))                                                                                   \
    X(void, AttachShader, (tr_i_u, tr_i_u))                                                                            \
    X(void, BindBuffer, (tr_i_u, tr_i_u))                                                                              \
    X(void, BindBufferBase, (tr_i_u, tr_i_u, tr_i_u))                                                                  \
    X(void, BindBufferRange, (tr_i_u, tr_i_u, tr_i_u, ptrdiff_t, ptrdiff_t))                                           \
    X(void, BindFramebuffer, (tr_i_u, tr_i_u))                                                                         \
    X(void, BindSampler, (tr_i_u, tr_i_u))                                                                             \
    X(void, BindTexture, (tr_i_u, tr_i_u))                                                                             \
    X(void, BindVertexArray, (tr_i_u))                                                                                 \
    X(void, BlendEquationSeparate, (tr_i_u, tr_i_u))                                                                   \
    X(void, BlendFuncSeparate, (tr_i_u, tr_i_u, tr_i_u, tr_i_u))                                                       \
    X(void, BlitFramebuffer, (int32_t, int32_t, int32_t, int32_t, int32_t, int32_t, int32_t, int32_t, tr_i_u, tr_i_u)) \
    X(void, BufferData, (tr_i_u, ptrdiff_t, const void *, tr_i_u))                                                     \
    X(void, BufferSubData, (tr_i_u, ptrdiff_t, ptrdiff_t, const void *))                                               \
    X(tr_i_u, CheckFramebufferStatus, (tr_i_u))                                                                        \
    X(void, ClearBufferfv, (tr_i_u, int32_t, const float *))                                                           \
    X(void, ColorMask, (unsigned char, unsigned char, unsigned char, unsigned char))                                   \
    X(void, CompileShader, (tr_i_u))                                                                                   \
    X(tr_i_u, CreateProgram, (void))                                                                                   \
    X(tr_i_u, CreateShader, (tr_i_u))                                                                                  \
    X(void, CullFace, (tr_i_u))                                                                                        \
    X(void, DeleteBuffers, (int32_t, const tr_i_u *))                                                                  \
    X(void, DeleteFramebuffers, (int32_t, const tr_i_u *))                                                             \
    X(void, DeleteProgram, (tr_i_u))                                                                                   \
    X(void, DeleteShader, (tr_i_u))                                                                                    \
    X(void, DeleteTextures, (int32_t, const tr_i_u *))                                                                 \
    X(void, DeleteVertexArrays, (int32_t, const tr_i_u *))                                                             \
    X(void, DepthFunc, (tr_i_u))                                                                                       \
    X(void, DepthMask, (unsigned char))                                                                                \
    X(void, Disable, (tr_i_u))                                                                                         \
    X(void, DrawArrays, (tr_i_u, int32_t, int32_t))                                                                    \
    X(void, DrawBuffers, (int32_t, const tr_i_u *))                                                                    \
    X(void, Enable, (tr_i_u))                                                                                          \
    X(void, FramebufferTexture2D, (tr_i_u, tr_i_u, tr_i_u, tr_i_u, int32_t))                                           \
    X(void, FramebufferTextureLayer, (tr_i_u, tr_i_u, tr_i_u, int32_t, int32_t))                                       \
    X(void, FrontFace, (tr_i_u))                                                                                       \
    X(void, GenBuffers, (int32_t, tr_i_u *))                                                                           \
    X(void, GenFramebuffers, (int32_t, tr_i_u *))                                                                      \
    X(void, GenTextures, (int32_t, tr_i_u *))                                                                          \
    X(void, GenVertexArrays, (int32_t, tr_i_u *))                                                                      \
    X(void, GetBooleanv, (tr_i_u, unsigned char *))                                                                    \
    X(void, GetFloatv, (tr_i_u, float *))                                                                              \
    X(void, GetFramebufferAttachmentParameteriv, (tr_i_u, tr_i_u, tr_i_u, int32_t *))                                  \
    X(void, GetInteger64i_v, (tr_i_u, tr_i_u, int64_t *))                                                              \
    X(void, GetIntegeri_v, (tr_i_u, tr_i_u, int32_t *))                                                                \
    X(void, GetIntegerv, (tr_i_u, int32_t *))                                                                          \
    X(void, GetProgramInfoLog, (tr_i_u, int32_t, int32_t *, char *))                                                   \
    X(void, GetProgramiv, (tr_i_u, tr_i_u, int32_t *))                                                                 \
    X(void, GetShaderInfoLog, (tr_i_u, int32_t, int32_t *, char *))                                                    \
    X(void, GetShaderiv, (tr_i_u, tr_i_u, int32_t *))                                                                  \
    X(const unsigned char *, GetString, (tr_i_u))                                                                      \
    X(tr_i_u, GetUniformBlockIndex, (tr_i_u, const char *))                                                            \
    X(int32_t, GetUniformLocation, (tr_i_u, const char *))                                                             \
    X(unsigned char, IsEnabled, (tr_i_u))                                                                              \
    X(unsigned char, IsProgram, (tr_i_u))                                                                              \
    X(unsigned char, IsTexture, (tr_i_u))                                                                              \
    X(void, LinkProgram, (tr_i_u))                                                                                     \
    X(void, PixelStorei, (tr_i_u, int32_t))                                                                            \
    X(void, ReadBuffer, (tr_i_u))                                                                                      \
    X(void, Scissor, (int32_t, int32_t, int32_t, int32_t))                                                             \
    X(void, ShaderSource, (tr_i_u, int32_t, const char *const *, const int32_t *))                                     \
    X(void, TexImage2D, (tr_i_u, int32_t, int32_t, int32_t, int32_t, int32_t, tr_i_u, tr_i_u, const void *))           \
    X(void, TexImage3D, (tr_i_u, int32_t, int32_t, int32_t, int32_t, int32_t, int32_t, tr_i_u, tr_i_u, const void *))  \
    X(void, TexParameteri, (tr_i_u, tr_i_u, int32_t))                                                                  \
    X(void, TexSubImage2D, (tr_i_u, int32_t, int32_t, int32_t, int32_t, int32_t, tr_i_u, tr_i_u, const void *))        \
    X(void, Uniform1i, (int32_t, int32_t))                                                                             \
    X(void, Uniform1ui, (int32_t, tr_i_u))                                                                             \
    X(void, Uniform2i, (int32_t, int32_t, int32_t))                                                                    \
    X(void, Uniform2f, (int32_t, float, float))                                                                        \
    X(void, Uniform3f, (int32_t, float, float, float))                                                                 \
    X(void, Uniform4fv, (int32_t, int32_t, const float *))                                                             \
    X(void, Uniform4ui, (int32_t, tr_i_u, tr_i_u, tr_i_u, tr_i_u))                                                     \
    X(void, UniformBlockBinding, (tr_i_u, tr_i_u, tr_i_u))                                                             \
    X(void, UniformMatrix3fv, (int32_t, int32_t, unsigned char, const float *))                                        \
    X(void, UniformMatrix4fv, (int32_t, int32_t, unsigned char, const float *))                                        \
    X(void, UseProgram, (tr_i_u))                                                                                      \
    X(void, Viewport, (int32_t, int32_t, int32_t, int32_t))

/* Desktop GL 3.3. */
#define TR_I_GL_DESKTOP(X)                                                                                             \
    X(void, DepthRange, (double, double))                                                                              \
    X(void, GetDoublev, (tr_i_u, double *))                                                                            \
    X(void, GetTexLevelParameteriv, (tr_i_u, int32_t, tr_i_u, int32_t *))                                              \
    X(void, PolygonMode, (tr_i_u, tr_i_u))

/* Desktop GL 3.3 and ES 3.2: masks and switches by draw buffer. */
#define TR_I_GL_INDEXED(X)                                                                                             \
    X(void, ColorMaski, (tr_i_u, unsigned char, unsigned char, unsigned char, unsigned char))                          \
    X(void, Disablei, (tr_i_u, tr_i_u))                                                                                \
    X(void, Enablei, (tr_i_u, tr_i_u))                                                                                 \
    X(void, GetBooleani_v, (tr_i_u, tr_i_u, unsigned char *))                                                          \
    X(unsigned char, IsEnabledi, (tr_i_u, tr_i_u))

/* Desktop GL 4.0 and ES 3.2: blend functions by draw buffer. */
#define TR_I_GL_INDEXED_BLEND(X)                                                                                       \
    X(void, BlendEquationSeparatei, (tr_i_u, tr_i_u, tr_i_u))                                                          \
    X(void, BlendFuncSeparatei, (tr_i_u, tr_i_u, tr_i_u, tr_i_u, tr_i_u))

/* Desktop GL 4.1: viewports, scissors and depth ranges by index; the plain functions set all sixteen. */
#define TR_I_GL_VIEWPORTS(X)                                                                                           \
    X(void, DepthRangeIndexed, (tr_i_u, double, double))                                                               \
    X(void, GetDoublei_v, (tr_i_u, tr_i_u, double *))                                                                  \
    X(void, GetFloati_v, (tr_i_u, tr_i_u, float *))                                                                    \
    X(void, ScissorIndexed, (tr_i_u, int32_t, int32_t, int32_t, int32_t))                                              \
    X(void, ViewportIndexedf, (tr_i_u, float, float, float, float))

#define TR_I_GL_ES(X) X(void, DepthRangef, (float, float))

/* What tr_query_hidden needs; any 3.3 and ES 3.0, but WebGL 2 cannot map. */
#define TR_I_GL_QUERY(X)                                                                                               \
    X(tr_i_u, ClientWaitSync, (void *, tr_i_u, uint64_t))                                                              \
    X(void, DeleteSync, (void *))                                                                                      \
    X(void *, FenceSync, (tr_i_u, tr_i_u))                                                                             \
    X(void *, MapBufferRange, (tr_i_u, ptrdiff_t, ptrdiff_t, tr_i_u))                                                  \
    X(void, ReadPixels, (int32_t, int32_t, int32_t, int32_t, tr_i_u, tr_i_u, void *))                                  \
    X(unsigned char, UnmapBuffer, (tr_i_u))

typedef struct tr_i_gl {
#define TR_I_MEMBER(type, name, parameters) type(TR_I_GLAPI *name) parameters;
    TR_I_GL_REQUIRED(TR_I_MEMBER)
    TR_I_GL_DESKTOP(TR_I_MEMBER)
    TR_I_GL_INDEXED(TR_I_MEMBER)
    TR_I_GL_INDEXED_BLEND(TR_I_MEMBER)
    TR_I_GL_VIEWPORTS(TR_I_MEMBER)
    TR_I_GL_ES(TR_I_MEMBER)
    TR_I_GL_QUERY(TR_I_MEMBER)
#undef TR_I_MEMBER
} tr_i_gl;

/* ---- the context ------------------------------------------------------------------------------------------------ */

/* Textures by what they hold, and by the unit (plus first_texture_unit) that they are read from. Layers alternate between
   two array textures, so that none is read while another one of it is drawn. The depth that opaque things and lines are
   drawn into and the depth that lines and the composition read are two names for one or two textures: DEPTH_COPY is read
   from the unit of SCENE_DEPTH. */
enum {
    TR_I_FRONT_DEPTH,  /* of transparent layers 0, 2, 4, ... */
    TR_I_ODD_DEPTH,    /* of layers 1, 3, 5, ... */
    TR_I_FRONT_OWNER,  /* their objects' ids, as depths */
    TR_I_SCENE_DEPTH,  /* limit, then opaque things */
    TR_I_OPAQUE_COLOR, /* alpha 1 where an opaque thing is */
    TR_I_LAYER_COLOR,  /* of all layers */
    TR_I_MARK,         /* group, and method in the highest bit, of the front-most transparent object */
    TR_I_CROSSINGS,    /* segments, two texels each; not of the frame's size */
    TR_I_DEPTH_COPY,   /* of SCENE_DEPTH without lines */
    TR_I_TEXTURE_COUNT
};

static const tr_i_u tr_i_targets[TR_TEXTURE_UNITS] = {
    TR_I_GL_TEXTURE_2D_ARRAY, TR_I_GL_TEXTURE_2D_ARRAY, TR_I_GL_TEXTURE_2D_ARRAY, TR_I_GL_TEXTURE_2D,
    TR_I_GL_TEXTURE_2D,       TR_I_GL_TEXTURE_2D_ARRAY, TR_I_GL_TEXTURE_2D,       TR_I_GL_TEXTURE_2D};

/* Arrays that alpha is found by, on the units after those: see tr_set_edges. */
enum { TR_I_EDGE_SEGMENTS, TR_I_EDGE_LISTS, TR_I_EDGE_TEXTURE_COUNT };

/* Framebuffers, by the textures attached. */
enum {
    TR_I_FBO_DEPTH,                                  /* depth of a layer */
    TR_I_FBO_ALONE = TR_I_FBO_DEPTH + TR_MAX_LAYERS, /* its depth and colour */
    TR_I_FBO_LAYER = TR_I_FBO_ALONE + TR_MAX_LAYERS, /* its colour; owner in the first slice */
    TR_I_FBO_GROUP =
        TR_I_FBO_LAYER + TR_MAX_LAYERS, /* its colour; owner in a slice of its own; of the first the mark */
    TR_I_FBO_LIMIT = TR_I_FBO_GROUP + TR_MAX_LAYERS,
    TR_I_FBO_OPAQUE,
    TR_I_FBO_COPY,
    TR_I_FBO_COUNT
};

/* Programs of full-screen passes of sequences. */
enum {
    TR_I_SEQ_WIPE,
    TR_I_SEQ_ROW,
    TR_I_SEQ_NEAR,                     /* round; in rings */
    TR_I_SEQ_MASK = TR_I_SEQ_NEAR + 2, /* + 1: in rings, + 2: shared by the occluders */
    TR_I_SEQ_OVER = TR_I_SEQ_MASK + 4,
    TR_I_SEQ_DEPTHS, /* of TR_PASS_REACH */
    TR_I_SEQ_KEEP,
    TR_I_SEQ_SHARE,
    TR_I_SEQ_COMPOSE,
    TR_I_SEQ_EXTENT,
    TR_I_SEQ_FORM,
    TR_I_SEQ_PROGRAM_COUNT
};

/* Built-in programs: one a rule, one that copies depth, and variants of the composition and of lines, which are found by
   a key; see tr_i_key_of. More of these than a plan can need. Then one a rule for each further rung of alpha. */
#define TR_I_VARIANT_COUNT 24
enum {
    TR_I_PROGRAM_COPY_DEPTH = TR_RULE_SEE_END,
    TR_I_PROGRAM_VARIANT,
    TR_I_PROGRAM_ALPHA = TR_I_PROGRAM_VARIANT + TR_I_VARIANT_COUNT,
    TR_I_PROGRAM_OUTLINE =
        TR_I_PROGRAM_ALPHA + ((int)TR_ALPHA_COUNT - 1) * (int)TR_RULE_COUNT, /* found; jumps; with ids */
    TR_I_PROGRAM_SEE = TR_I_PROGRAM_OUTLINE + 4, /* full-screen ones of dynamic transparency: tr_i_see_source */
    TR_I_PROGRAM_BITS = TR_I_PROGRAM_SEE,
    TR_I_PROGRAM_SPREAD_X,
    TR_I_PROGRAM_SPREAD_Y,
    TR_I_PROGRAM_FINISH,
    TR_I_PROGRAM_FINISH_BARE, /* no gradient */
    TR_I_PROGRAM_PRIME,
    TR_I_PROGRAM_PRIME_COLOR, /* targets have their colour */
    TR_I_PROGRAM_COMPOSE_MASK,
    TR_I_PROGRAM_COMPOSE_YIELD,
    TR_I_PROGRAM_QUERY,
    TR_I_PROGRAM_PARTS, /* the first six of these, for a scene in parts: targets are known by depth alone */
    TR_I_PROGRAM_PRIME_PARTS = TR_I_PROGRAM_PARTS + TR_I_PROGRAM_PRIME - TR_I_PROGRAM_SEE,
    TR_I_PROGRAM_SEQUENCE, /* those from TR_I_SEQ_WIPE on */
    TR_I_PROGRAM_COUNT = TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_PROGRAM_COUNT
};

typedef struct tr_i_program {
    tr_i_u name;  /* 0: not yet made */
    uint32_t key; /* of a variant */
    int32_t model_view_projection, normal_matrix, color, falloff, object, model, crossing_range;
    int32_t edge_frame, edge_ranges, outline;
    int32_t jump, depth_law, pixel; /* of those that find outlines */
} tr_i_program;

/* The uniform block tr_frame of shaders/frame_block.glsl, std140. */
typedef struct tr_i_block {
    float light[4], cool[4], warm[4], weights[4], viewport[4], ink[2][4], eye[4], blend[4], enter[4], shift[4];
    int32_t step[4];
} tr_i_block;
#define TR_I_CROSSING_ROW 1024 /* texels; see crossings.glsl */
#define TR_I_STRIDE 256        /* of the copies of it in the buffer, one a layer; GL asks for no coarser alignment */

#define TR_I_MAX_DRAW_BUFFERS 8
#define TR_I_MAX_CLIP_DISTANCES 8
#define TR_I_MAX_VIEWPORTS 16
#define TR_I_CAP_COUNT 15

/* State that a frame changes: exactly what TR_STATE_RESTORE puts back. */
typedef struct tr_i_snapshot {
    int32_t program, vertex_array, draw_framebuffer, read_framebuffer;
    unsigned char caps[TR_I_CAP_COUNT], clip_distances[TR_I_MAX_CLIP_DISTANCES];
    unsigned char scissors[TR_I_MAX_VIEWPORTS];
    int32_t scissor[4]; /* of dynamic transparency, which alone sets one */
    unsigned char depth_mask, color_masks[TR_I_MAX_DRAW_BUFFERS][4], blends[2];
    int32_t depth_func, cull_mode, front_face, polygon_mode[2];
    float viewport[4];
    double depth_range[2];
    int32_t blend_func[4], blend_equation[2];
    int32_t active_texture, textures[TR_TEXTURE_UNITS], samplers[TR_TEXTURE_UNITS];
    int32_t edge_textures[TR_I_EDGE_TEXTURE_COUNT], edge_samplers[TR_I_EDGE_TEXTURE_COUNT];
    int32_t uniform_buffer, indexed_buffer, copy_buffer, unpack_buffer;
    int64_t indexed_start, indexed_size;
} tr_i_snapshot;

/* ---- dynamic transparency: what a context keeps ----------------------------------------------------------------- */

/* Lists of units, as indices into the host's array, each as long as that. */
enum {
    TR_I_UNITS_ALL,
    TR_I_UNITS_BLOCK,   /* impenetrable, or backdrops, in masks */
    TR_I_UNITS_TARGETS, /* that something may lie before */
    TR_I_UNITS_BEHIND,  /* that may show through a mask */
    TR_I_UNITS_BEFORE,  /* distractors that may lie before a target */
    TR_I_UNITS_MASKED,  /* all in masks */
    TR_I_UNITS_HOLED,   /* that may yield to a target */
    TR_I_UNITS_REGION,  /* of those that may show through, what meets masks of one region */
    TR_I_UNITS_REST,    /* of a scene in parts, what is in none of the others */
    TR_I_UNIT_LISTS
};

/* Where a unit is on the screen (x0, y0, x1, y1; x1 = 0: nowhere), and its reach along the view. */
typedef struct tr_i_place {
    uint16_t x0, y0, x1, y1;
    float first, last;
} tr_i_place;

#define TR_I_CELLS 128 /* along each side, at most */
#define TR_I_MAX_TILES 2000
#define TR_I_MAX_REGIONS 8
#define TR_I_REGION_SAVES 64 /* a further one has to leave out this share of the viewport */

/* The screen in cells: a target needs a mask where something that yields lies before it, and only units that meet masks
   are drawn again. Cells in place of rectangles of targets, so that the work does not grow with targets times units. */
typedef struct tr_i_grid {
    int side, columns, rows;                         /* a cell's, pixels; cells */
    float nearest_yielding[TR_I_CELLS * TR_I_CELLS]; /* along the view; infinite: none */
    float nearest_target[TR_I_CELLS * TR_I_CELLS];   /* of those that have masks */
    float farthest_target[TR_I_CELLS * TR_I_CELLS];  /* -infinite: no mask here */
    unsigned char tiles[TR_I_MAX_TILES][4];          /* of cells with masks: x0, y0, x1, y1 in cells */
    int tile_count, cell_count;
    int regions[TR_I_MAX_REGIONS][4]; /* rectangles that hold all of them: x0, y0, x1, y1 in cells */
    int region_count;
} tr_i_grid;

/* Numbers of a tr_dynamic with the defaults filled in. */
typedef struct tr_i_law {
    float target, start, width;
    int divisor, reach; /* pixels from a target's outline on which masks are 1, and nothing is left to look for */
} tr_i_law;

/* Textures and framebuffers of dynamic transparency; sizes follow from the viewport and the mask's divisor. */
enum {
    TR_I_SEE_DEPTH,        /* of blocks and targets; then of what shows through masks */
    TR_I_SEE_MARK,         /* of the nearest target: id in two bytes, whether it is active, strength */
    TR_I_SEE_BITS,         /* eight pixels a texel: which are a target's */
    TR_I_SEE_ROWS,         /* of four rows of pixels a texel: where the nearest pixel of a target is in each */
    TR_I_SEE_LOW,          /* the mask's texels: distance, strength, whether it is active */
    TR_I_SEE_LOW_DEPTH,    /* their depth */
    TR_I_SEE_MASK,         /* opacity before importance, strength */
    TR_I_SEE_MASK_DEPTH,   /* what lies before it yields */
    TR_I_SEE_BEHIND,       /* colour of what shows through masks; where targets have theirs, first that, and strength */
    TR_I_SEE_YIELD,        /* importance of the front-most unit */
    TR_I_SEE_QUERY,        /* 4 by 4 pixels a texel: id in two bytes, whether something lies before it */
    TR_I_SEE_TARGET_DEPTH, /* copied from the host's target, in its format: of targets alone */
    TR_I_SEE_BASE_DEPTH,   /* of all that never yields */
    TR_I_SEE_TEXTURE_COUNT
};

enum {
    TR_I_SEE_FBO_TARGETS,
    TR_I_SEE_FBO_BITS,
    TR_I_SEE_FBO_ROWS,
    TR_I_SEE_FBO_LOW,
    TR_I_SEE_FBO_MASK,
    TR_I_SEE_FBO_BEHIND,
    TR_I_SEE_FBO_YIELD,
    TR_I_SEE_FBO_QUERY,
    TR_I_SEE_FBO_PRIME,
    TR_I_SEE_FBO_TAKE_TARGETS,
    TR_I_SEE_FBO_TAKE_BASE,
    TR_I_SEE_FBO_TAKE_COLOR,
    TR_I_SEE_FBO_MARKS,
    TR_I_SEE_FBO_COUNT
};

/* The uniform block of shaders/see_block.glsl, std140. */
typedef struct tr_i_see_block {
    float light[4], cool[4], warm[4], viewport[4], law[4], background[4];
    int32_t grid[4];
    float lights[TR_MAX_LIGHTS][4];
    uint32_t tiles[TR_I_MAX_TILES];
} tr_i_see_block;

/* Within a frame: no pass of ours has begun; one has; the host draws its scene after one. */
enum { TR_I_OUTSIDE, TR_I_INSIDE, TR_I_LENT };

#define TR_I_QUERY_RING 3

typedef struct tr_i_query {
    tr_i_u buffer;
    void *fence; /* 0: nothing is under way */
    size_t texels;
    int stale; /* of a frame before one without masks */
} tr_i_query;

typedef struct tr_i_answer {
    uint32_t texels, hidden;
} tr_i_answer;

typedef struct tr_i_see {
    int active;  /* this frame is of tr_begin_dynamic */
    int partial; /* some importance of an occluder is neither 0 nor 1 */
    int colored; /* the pass of targets takes their colour, so that they are not drawn again */
    int marked;  /* of a scene in parts: targets are drawn once more for what depth does not tell of them */
    unsigned char units_of[TR_MAX_SEE_PASSES]; /* of passes of the scene and copies: which list */
    int host_depth, held_depth;                /* formats of the target, and of the textures held: tr_i_depths */
    int step, region;
    int entered; /* whose state it is: TR_I_OUTSIDE, ... */
    tr_i_law law;
    tr_see_plan plan;
    tr_i_grid grid;
    tr_i_place *places; /* of all units; with the lists one heap block */
    uint32_t *lists[TR_I_UNIT_LISTS];
    size_t counts[TR_I_UNIT_LISTS], capacity;
    int width, height, divisor, srgb; /* that the textures are made for */
    tr_i_u textures[TR_I_SEE_TEXTURE_COUNT], fbos[TR_I_SEE_FBO_COUNT], buffer;
    tr_i_see_block block, uploaded; /* of this frame; as it is in the buffer */
    tr_i_query queries[TR_I_QUERY_RING];
    int next_query;
    tr_i_answer *answer;        /* by id; 0: nobody has asked */
    int block_uploaded, in_use; /* in_use: the built-in program of this frame's scene is */
} tr_i_see;

/* ---- dynamic transparency: what a context keeps of sequences ---- */

typedef struct tr_i_array { /* grows, and never shrinks */
    void *items;
    size_t count, capacity;
} tr_i_array;

/* Where a unit comes when whole objects are painted back to front: Assarsson 2006, section 4. */
typedef struct tr_i_rank {
    double depth;             /* of its group's middle, along the view; of what has none TR_I_FARTHEST */
    uint32_t lowest, id;      /* of ids in its group; its own */
    uint32_t group, backdrop; /* backdrops come first */
    uint32_t target;
    int32_t rank;
} tr_i_rank;
#define TR_I_FARTHEST 1.0e300

/* The mask of a target; boxes are x0, y0, x1, y1, the last two outside. */
typedef struct tr_i_mask {
    int reach[4], box[4]; /* where it may be; what textures are drawn in for it */
    uint32_t unit, run;   /* run: of masks that are drawn together */
    float strength, active, importance, id;
    int form; /* pixels by which circle or ellipse may be larger than the target */
} tr_i_mask;

/* What is painted at a time: units of which none covers another on the screen; or masks that do not overlap. */
typedef struct tr_i_item {
    uint32_t first, count; /* of the list of units, or of the masks */
    unsigned char masks, hollow;
} tr_i_item;

typedef struct tr_i_step { /* a pass to come */
    uint32_t first, count; /* of the list of units, or boxes of a run of masks */
    uint32_t block;        /* the copy of the uniform block that it reads */
    uint8_t kind, rule, own, hollow, clear, subtract, layer;
} tr_i_step;

#define TR_I_RUN 64 /* masks, or units, at most in an item */

/* The uniform block of shaders/seq_block.glsl, std140. */
typedef struct tr_i_seq_block {
    float light[4], cool[4], warm[4], law[4], background[4];
    int32_t view[4], numbers[4], step[4], more[4];
    float lights[TR_MAX_LIGHTS][4];
    float masks[TR_I_RUN][8];
} tr_i_seq_block;
#define TR_I_SEQ_STRIDE 2560 /* of its copies, one a run or a layer: a multiple of 256 */

#define TR_I_SEQ_LAYERS 16 /* of a pixel, at most */

/* Textures: of pixels, but for ROWS and NEAREST, which have a texel a cell. */
enum {
    TR_I_SEQ_SEED,      /* depth where a target of the run is, open */
    TR_I_SEQ_ROWS,      /* the nearest pixel of it in each row */
    TR_I_SEQ_NEAREST,   /* the nearest of all */
    TR_I_SEQ_BLOCK,     /* depth of what closes masks */
    TR_I_SEQ_ALPHAS,    /* the masks so far */
    TR_I_SEQ_OWN_COLOR, /* a target of our own, where occluders have to be counted */
    TR_I_SEQ_OWN_DEPTH,
    TR_I_SEQ_REMAINING, /* occluders still to be painted */
    TR_I_SEQ_EXTENTS,   /* rows of targets */
    TR_I_SEQ_FORMS,     /* circle, ellipse or hull of each */
    TR_I_SEQ_REACH,     /* how far masks look through */
    TR_I_SEQ_CODE,      /* whose the layer is that is being peeled; layers are arrays from here on */
    TR_I_SEQ_EVEN,      /* depth of layers 0, 2, 4, ... */
    TR_I_SEQ_ODD,
    TR_I_SEQ_CHAIN,        /* whose they are */
    TR_I_SEQ_LAYER_COLOR,  /* their colours */
    TR_I_SEQ_LAYER_ALPHAS, /* of four a slice */
    TR_I_SEQ_TEXTURE_COUNT
};

enum {
    TR_I_SEQ_FBO_SEED,
    TR_I_SEQ_FBO_ROWS,
    TR_I_SEQ_FBO_NEAREST,
    TR_I_SEQ_FBO_BLOCK,
    TR_I_SEQ_FBO_ALPHAS,
    TR_I_SEQ_FBO_OWN,
    TR_I_SEQ_FBO_COUNTS,
    TR_I_SEQ_FBO_EXTENTS,
    TR_I_SEQ_FBO_FORMS,
    TR_I_SEQ_FBO_REACH,
    TR_I_SEQ_FBO_PEEL,
    TR_I_SEQ_FBO_KEEP = TR_I_SEQ_FBO_PEEL + TR_I_SEQ_LAYERS,
    TR_I_SEQ_FBO_SHARE = TR_I_SEQ_FBO_KEEP + TR_I_SEQ_LAYERS,
    TR_I_SEQ_FBO_COUNT = TR_I_SEQ_FBO_SHARE + TR_I_SEQ_LAYERS / 4
};

typedef struct tr_i_sequence {
    tr_i_array ranks, by_group, painted; /* of all units */
    tr_i_array tied;                     /* of all units: who is in front where depths are the same */
    tr_i_array list, scene;              /* of units, as passes draw them */
    tr_i_array masks, items, steps, blocks;
    tr_i_step lost; /* where a step goes that there is no memory for */
    size_t step;
    uint32_t pending; /* masks from this one on are of targets painted already, and not yet drawn */
    int open;         /* 1: the last item may still take units */
    int grow, reach;  /* pixels around a target that its mask's textures cover; that its mask covers */
    int no_memory;
    int counted, published, product, each, layers; /* of this frame */
    int extent[4], wanted[4];                      /* width, height, divisor, layers: of the textures; of this frame */
    tr_mask_shape shape;
    int light, made_for_light; /* 1: colours are light, the target encodes them */
    int has_block, exact, whole, layer_bound,
        peeled; /* peeled: layers; whole: the last of them is the end of the pixel */
    uint32_t runs;
    int bounds[4];  /* of all masks: x0, y0, x1, y1 */
    int eight_bits; /* 1: float textures cannot be drawn into */
    int active;     /* this frame is of one */
    tr_i_u textures[TR_I_SEQ_TEXTURE_COUNT], fbos[TR_I_SEQ_FBO_COUNT], buffer;
    size_t buffer_size;
} tr_i_sequence;

#define TR_I_MAX_STRINGS 48

struct tr_context {
    tr_desc desc;
    tr_i_gl gl;
    int es, version, has_indexed, has_indexed_blend, has_viewports, has_queries, viewports, draw_buffers,
        clip_distances;
    int32_t max_width, max_height, max_texture; /* of a viewport; of a texture */
    const char *strings[TR_STAGE_COUNT][TR_RULE_SEE_END][TR_I_MAX_STRINGS + 1];
    int string_count[TR_STAGE_COUNT][TR_RULE_SEE_END];
    const char *alpha_strings[TR_STAGE_COUNT][TR_ALPHA_COUNT][TR_I_MAX_STRINGS + 1];
    int alpha_string_count[TR_STAGE_COUNT][TR_ALPHA_COUNT];
    tr_i_program programs[TR_I_PROGRAM_COUNT];
    int next_variant; /* to be replaced when there is no room */
    tr_i_u textures[TR_I_TEXTURE_COUNT], fbos[TR_I_FBO_COUNT];
    int slices[TR_I_TEXTURE_COUNT]; /* of array textures; else 1 */
    int width, height;              /* of the textures */
    tr_i_u edge_textures[TR_I_EDGE_TEXTURE_COUNT];
    size_t edge_rows[TR_I_EDGE_TEXTURE_COUNT]; /* of 1024 texels */
    tr_i_u outline_textures[2], outline_fbos[2];
    int outline_width, outline_height, outline_at; /* outline_at: which of the two has the result */
    float outline_pixel;                           /* world size of its pixels where w is 1; 0: none found yet */
    tr_i_u vertex_array, uniform_buffer;
    tr_i_block block; /* as uploaded */
    int block_uploaded;
    tr_i_snapshot saved;
    tr_frame frame;
    tr_plan plan;
    int next_pass; /* of the plan */
    int in_frame;
    tr_i_see see;
    tr_i_sequence seq;
};

/* ---- text without stdio ----------------------------------------------------------------------------------------- */

typedef struct tr_i_text {
    char *at;
    size_t capacity, length;
} tr_i_text;

static void tr_i_put(tr_i_text *text, const char *string) {
    for (; *string; ++string) {
        if (text->length + 1 < text->capacity)
            text->at[text->length] = *string;
        ++text->length;
    }
    if (text->capacity)
        text->at[text->length < text->capacity ? text->length : text->capacity - 1] = 0;
}

static void tr_i_put_number(tr_i_text *text, uint64_t number) {
    char digits[21];
    int at = 20;
    digits[20] = 0;
    do {
        digits[--at] = (char)('0' + (int)(number % 10));
        number /= 10;
    } while (number);
    tr_i_put(text, digits + at);
}

static tr_i_text tr_i_text_in(char *at, size_t capacity) {
    tr_i_text text;
    text.at = at;
    text.capacity = capacity;
    text.length = 0;
    if (capacity)
        at[0] = 0;
    return text;
}

static void tr_i_log(const tr_desc *desc, tr_log_level level, tr_result code, const char *what, const char *detail) {
    char buffer[2400];
    tr_i_text text = tr_i_text_in(buffer, sizeof buffer);
    if (!desc->log_fn)
        return;
    tr_i_put(&text, "transparency: ");
    tr_i_put(&text, what);
    if (detail) {
        tr_i_put(&text, ": ");
        tr_i_put(&text, detail);
    }
    desc->log_fn(level, code, buffer, desc->log_user);
}

static tr_result tr_i_fail(const tr_desc *desc, tr_result code, const char *detail) {
    tr_i_log(desc, TR_LOG_ERROR, code, tr_result_string(code), detail);
    return code;
}

/* ---- plans ------------------------------------------------------------------------------------------------------ */

TR_I_API const char *tr_result_string(tr_result result) {
    static const char *const texts[] = {
#define TR_I_TEXT(name, text) text,
        TR_RESULTS(TR_I_TEXT)
#undef TR_I_TEXT
    };
    return (unsigned)result < (unsigned)TR_RESULT_COUNT ? texts[result] : "unknown result";
}

TR_I_API const char *tr_pass_kind_name(tr_pass_kind kind) {
    static const char *const names[] = {"front",        "peel",           "layer",
                                        "limit",        "opaque",         "copy depth",
                                        "opaque lines", "compose",        "transparent lines",
                                        "hidden lines", "outer lines",    "take opaque",
                                        "block",        "targets",        "bits",
                                        "spread x",     "spread y",       "finish",
                                        "prime",        "scene",          "behind",
                                        "yield",        "compose mask",   "query",
                                        "hides",        "wipe",           "seeds",
                                        "rows",         "nearest",        "extents",
                                        "forms",        "masks",          "paint depth",
                                        "paint",        "count",          "paint over",
                                        "reach",        "peel units",     "keep",
                                        "share",        "compose layers", "take"};
    return (unsigned)kind < (unsigned)TR_PASS_KIND_COUNT ? names[kind] : "unknown pass";
}

#define TR_I_MAX_ID 0xfffffeu
#define TR_I_FLAGS (127u | TR_GROUP(TR_MAX_GROUP))

/* What one object adds; members counts by group. */
static void tr_i_count(tr_scene *counts, const tr_object *object, uint32_t *members) {
    uint32_t flags = object->flags, group = flags >> 8 & TR_MAX_GROUP, size;
    int transparent = (flags & TR_TRANSPARENT) != 0;
    if ((flags & ~TR_I_FLAGS) || (transparent && (object->id > TR_I_MAX_ID || (flags & TR_DRAWN))) ||
        (flags & (TR_IMPLICIT | TR_EXPLICIT)) == (TR_IMPLICIT | TR_EXPLICIT))
        ++counts->invalid;
    if (!transparent) {
        ++*(flags & TR_DRAWN       ? &counts->opaque_drawn
            : flags & TR_TWO_SIDED ? &counts->opaque_two_sided
                                   : &counts->opaque);
        return;
    }
    ++*(flags & TR_TWO_SIDED ? &counts->transparent_two_sided : &counts->transparent);
    if (flags & TR_IMPLICIT)
        ++counts->implicit_asked;
    else if (flags & TR_EXPLICIT)
        ++counts->explicit_asked;
    else if ((flags & (TR_CLOSED | TR_HOLDING)) == (TR_CLOSED | TR_HOLDING))
        ++counts->holding;
    size = group ? ++members[group] : 0;
    if (counts->group_size < size)
        counts->group_size = size;
}

TR_I_API tr_scene tr_scene_count(const void *objects, size_t count, size_t stride) {
    tr_scene counts;
    uint32_t members[TR_MAX_GROUP + 1];
    size_t i;
    memset(&counts, 0, sizeof counts);
    memset(members, 0, sizeof members);
    for (i = 0; objects && i < count; ++i) {
        tr_object object;
        memcpy(&object, (const char *)objects + i * stride, sizeof object);
        tr_i_count(&counts, &object, members);
    }
    return counts;
}

/* Whether the interiors of a transparent object are explicit. */
static int tr_i_is_explicit(uint32_t flags, tr_interior interior) {
    if (flags & (TR_IMPLICIT | TR_EXPLICIT))
        return (flags & TR_EXPLICIT) != 0;
    if (interior == TR_INTERIOR_AUTO)
        return (flags & (TR_CLOSED | TR_HOLDING)) != (TR_CLOSED | TR_HOLDING);
    return interior == TR_INTERIOR_EXPLICIT;
}

TR_I_API uint32_t tr_object_code(const tr_object *object, const tr_wishes *wishes) {
    uint32_t code;
    if (!object || !wishes)
        return 0;
    code = (object->id & 0xffffffu) | (object->flags >> 8 & TR_MAX_GROUP) << 24;
    return code | (tr_i_is_explicit(object->flags, wishes->interior) ? 0x80000000u : 0u);
}

#define TR_I_CLASS(flags) (1u << (flags))
#define TR_I_ALL_OPAQUE (TR_I_CLASS(TR_OPAQUE) | TR_I_CLASS(TR_TWO_SIDED))
#define TR_I_ALL_TRANSPARENT (TR_I_CLASS(TR_TRANSPARENT) | TR_I_CLASS(TR_TRANSPARENT | TR_TWO_SIDED))

static tr_plan_pass *tr_i_add_pass(tr_plan *plan, tr_pass_kind kind, const char *why) {
    tr_plan_pass *pass = &plan->passes[plan->pass_count];
    memset(pass, 0, sizeof *pass);
    pass->kind = kind;
    pass->why = why;
    ++plan->pass_count;
    return pass;
}

/* One pass for closed objects, back faces culled, and one for sheets, if there are any. */
static void tr_i_add_surfaces(tr_plan *plan, tr_pass_kind kind, tr_rule rule, int layer, uint32_t closed,
                              uint32_t sheets, uint32_t flags, const char *why) {
    tr_plan_pass *pass;
    if (closed) {
        pass = tr_i_add_pass(plan, kind, why);
        pass->rule = rule;
        pass->layer = layer;
        pass->classes = TR_I_CLASS(flags);
        pass->cull = 1;
    }
    if (sheets) {
        pass = tr_i_add_pass(plan, kind, why);
        pass->rule = rule;
        pass->layer = layer;
        pass->classes = TR_I_CLASS(flags | TR_TWO_SIDED);
    }
}

static void tr_i_add_lines(tr_plan *plan, tr_pass_kind kind, uint32_t lines, uint32_t classes) {
    static const char *const why[2] = {"creases first: outlines are drawn over them",
                                       "outlines over surfaces and creases"};
    uint32_t i;
    for (i = 0; i < 2; ++i) {
        if (lines & (1u << i)) {
            tr_plan_pass *pass = tr_i_add_pass(plan, kind, why[i]);
            pass->lines = 1u << i;
            pass->classes = classes;
        }
    }
}

/* Lines drawn after everything else. Those of opaque objects are hidden by opaque things and the limit, not by the
   transparent surface that they are seen through; hence two passes. */
static void tr_i_add_late_lines(tr_plan *plan, uint32_t lines, uint32_t opaque, uint32_t transparent) {
    tr_plan_pass *pass;
    if ((lines & TR_LINES_HIDDEN) && opaque) {
        pass = tr_i_add_pass(plan, TR_PASS_HIDDEN_LINES, "opaque objects' lines behind other things and the limit");
        pass->lines = TR_LINES_HIDDEN;
        pass->classes = TR_I_ALL_OPAQUE;
    }
    if ((lines & TR_LINES_HIDDEN) && transparent) {
        pass = tr_i_add_pass(plan, TR_PASS_HIDDEN_LINES, "transparent objects' lines behind other things");
        pass->lines = TR_LINES_HIDDEN;
        pass->classes = TR_I_ALL_TRANSPARENT;
    }
    if (lines & TR_LINES_OUTER) {
        pass = tr_i_add_pass(plan, TR_PASS_OUTER_LINES, "wide outlines where no surface is");
        pass->lines = TR_LINES_OUTER;
        pass->classes = (opaque ? TR_I_ALL_OPAQUE : 0u) | (transparent ? TR_I_ALL_TRANSPARENT : 0u);
    }
}

/* The transparent layers that may be seen: depth, then, where faces may tie, whose it is. */
static void tr_i_add_layers(tr_plan *plan, const tr_scene *counts, int alone) {
    int marked = plan->grouped || plan->mixed, layer;
    for (layer = 0; layer < plan->layers; ++layer) {
        tr_rule next = alone ? TR_RULE_PEEL_ALONE : plan->grouped ? TR_RULE_PEEL_GROUP : TR_RULE_PEEL;
        tr_rule depth = layer ? next : alone ? TR_RULE_FRONT_ALONE : TR_RULE_FRONT;
        tr_rule owner = layer && plan->grouped ? TR_RULE_LAYER_GROUP : marked ? TR_RULE_LAYER_MARKED : TR_RULE_LAYER;
        tr_i_add_surfaces(plan, layer ? TR_PASS_PEEL : TR_PASS_FRONT, depth, layer, counts->transparent,
                          counts->transparent_two_sided, TR_TRANSPARENT,
                          layer   ? plan->grouped ? "the next face of another object" : "the next layer behind"
                          : alone ? "the front-most transparent face, depth and colour"
                                  : "the front-most transparent face");
        if (!alone)
            tr_i_add_surfaces(plan, TR_PASS_LAYER, owner, layer, counts->transparent, counts->transparent_two_sided,
                              TR_TRANSPARENT,
                              layer && plan->grouped ? "whose it is, and its colour if it is of the group"
                                                     : "whose it is: faces may tie; and its colour");
    }
}

/* Where opaque things stop to show: SCENE_DEPTH before anything opaque is drawn into it. */
static void tr_i_add_limit(tr_plan *plan, const tr_scene *counts, int alone) {
    tr_plan_pass *pass;
    int published = plan->interior == TR_INTERIOR_IMPLICIT_PUBLISHED, marked = plan->grouped || plan->mixed;
    if (!marked && (plan->interior == TR_INTERIOR_EXPLICIT || plan->interior == TR_INTERIOR_LAYERS)) {
        tr_i_add_surfaces(plan, TR_PASS_LIMIT, TR_RULE_LIMIT_BEHIND, 0, counts->transparent,
                          counts->transparent_two_sided, TR_TRANSPARENT,
                          plan->layers > 1 ? "the next front face behind the layers"
                                           : "explicit interiors: the second-closest front face");
        return;
    }
    if (counts->transparent) {
        pass = tr_i_add_pass(plan, TR_PASS_LIMIT,
                             published ? "published: the nearest back face of all"
                             : marked  ? "what ends the interior of the front-most object, by its method and group"
                             : alone   ? "back faces behind the front-most face"
                                       : "back faces, and fronts of other objects, behind the front-most face");
        pass->rule = published ? TR_RULE_FRONT
                     : marked  ? TR_RULE_LIMIT_MARKED
                     : alone   ? TR_RULE_LIMIT_BEHIND
                               : TR_RULE_LIMIT;
        pass->classes = TR_I_CLASS(TR_TRANSPARENT);
        pass->cull = published || alone ? 2 : 0;
    }
    if (counts->transparent_two_sided && !published && !alone) {
        pass = tr_i_add_pass(plan, TR_PASS_LIMIT, "sheets of other objects behind the front-most face");
        pass->rule = marked ? TR_RULE_LIMIT_MARKED_SHEET : TR_RULE_LIMIT_SHEET;
        pass->classes = TR_I_CLASS(TR_TRANSPARENT | TR_TWO_SIDED);
    }
}

static uint32_t tr_i_texel_bytes(int texture) {
    return texture == TR_I_MARK ? 1 : 4;
}

/* Array slices of a texture that a plan needs; 1 for those that are no arrays. */
static int tr_i_slices_of(const tr_plan *plan, int texture) {
    switch (texture) {
    case TR_I_FRONT_DEPTH:
        return (plan->layers + 1) / 2;
    case TR_I_ODD_DEPTH:
        return plan->layers / 2;
    case TR_I_FRONT_OWNER:
        return plan->grouped ? plan->layers : 1;
    case TR_I_LAYER_COLOR:
        return plan->layers;
    default:
        return 1;
    }
}

/* The textures that a pass draws into. */
static uint32_t tr_i_draws(const tr_plan_pass *pass) {
    uint32_t depth = 1u << (pass->layer & 1 ? TR_I_ODD_DEPTH : TR_I_FRONT_DEPTH);
    switch (pass->kind) {
    case TR_PASS_FRONT:
    case TR_PASS_PEEL:
        return depth |
               (pass->rule == TR_RULE_FRONT_ALONE || pass->rule == TR_RULE_PEEL_ALONE ? 1u << TR_I_LAYER_COLOR : 0u);
    case TR_PASS_LAYER:
        return (1u << TR_I_FRONT_OWNER) | (1u << TR_I_LAYER_COLOR) |
               (pass->rule == TR_RULE_LAYER_MARKED ? 1u << TR_I_MARK : 0u);
    case TR_PASS_LIMIT:
        return 1u << TR_I_SCENE_DEPTH;
    case TR_PASS_OPAQUE:
    case TR_PASS_OPAQUE_LINES:
    case TR_PASS_TAKE_OPAQUE:
        return (1u << TR_I_SCENE_DEPTH) | (1u << TR_I_OPAQUE_COLOR);
    case TR_PASS_COPY_DEPTH:
        return 1u << TR_I_DEPTH_COPY;
    default:
        return 0;
    }
}

/* Who clears what; which textures there are, and what they weigh. */
static void tr_i_plan_textures(tr_plan *plan) {
    uint32_t texels = (uint32_t)(plan->supersample * plan->supersample);
    int i, texture;
    for (i = 0; i < plan->pass_count; ++i) {
        tr_plan_pass *pass = &plan->passes[i];
        const tr_plan_pass *last = i ? pass - 1 : pass;
        uint32_t draws = tr_i_draws(pass), fresh = draws & ~plan->textures;
        int again = i && last->kind == pass->kind && last->layer == pass->layer;
        /* Layers share textures, each in a slice of its own, or one after the other in the same. */
        if (pass->kind == TR_PASS_FRONT || pass->kind == TR_PASS_PEEL || pass->kind == TR_PASS_LAYER)
            pass->clear_depth = !again;
        else
            pass->clear_depth = (fresh & (1u << TR_I_SCENE_DEPTH)) != 0;
        /* The copy is written, and layers are read, in full only where something was drawn: neither needs a clear. */
        pass->clear_color = (fresh & (1u << TR_I_OPAQUE_COLOR)) != 0;
        plan->textures |= fresh;
        for (texture = 0; texture < TR_I_TEXTURE_COUNT; ++texture)
            if ((fresh >> texture) & 1u)
                pass->bytes_per_pixel += (uint32_t)tr_i_slices_of(plan, texture) * tr_i_texel_bytes(texture) * texels;
        plan->bytes_per_pixel += pass->bytes_per_pixel;
    }
}

/* Method and layers, from what there is and what is wished. */
static void tr_i_plan_interiors(tr_plan *plan, const tr_scene *counts, const tr_wishes *wishes) {
    uint64_t all = (uint64_t)counts->transparent + counts->transparent_two_sided, implicit = counts->implicit_asked;
    uint64_t others = all - implicit - counts->explicit_asked;
    int whole = wishes->interior == TR_INTERIOR_IMPLICIT_PUBLISHED || wishes->interior == TR_INTERIOR_LAYERS;
    implicit += wishes->interior == TR_INTERIOR_IMPLICIT ? others
                : wishes->interior == TR_INTERIOR_AUTO   ? counts->holding
                                                         : 0;
    plan->mixed = !whole && implicit > 0 && implicit < all;
    plan->interior = whole ? wishes->interior : implicit > 0 ? TR_INTERIOR_IMPLICIT : TR_INTERIOR_EXPLICIT;
    plan->layers = all ? 1 : 0;
    plan->why = whole ? "asked for" : plan->mixed ? "object by object" : "the same for all objects";
    if (wishes->interior == TR_INTERIOR_AUTO && !counts->implicit_asked && !counts->explicit_asked)
        plan->why = plan->mixed ? "chosen: implicit for closed objects with opaque ones inside, explicit for others"
                    : implicit  ? "chosen: all are closed, with opaque objects inside"
                                : "chosen: none is closed with opaque objects inside";
    if (wishes->interior == TR_INTERIOR_LAYERS) {
        plan->layers = all ? (int)wishes->layers : 0;
    } else if (!whole && counts->group_size > 1) {
        uint32_t most = wishes->layers ? wishes->layers : TR_MAX_LAYERS;
        plan->layers = (int)(counts->group_size < most ? counts->group_size : most);
        plan->grouped = plan->layers > 1;
    }
}

static int tr_i_wishes_are_valid(const tr_wishes *wishes) {
    return (unsigned)wishes->interior <= TR_INTERIOR_LAYERS && (unsigned)wishes->blending <= TR_BLENDING_PUBLISHED &&
           wishes->lines <= (TR_LINES_CREASES | TR_LINES_OUTLINES | TR_LINES_HIDDEN | TR_LINES_OUTER) &&
           wishes->layers <= TR_MAX_LAYERS && wishes->supersample <= TR_MAX_SUPERSAMPLE &&
           wishes->options <= (TR_WISH_BLEND_COLOR | TR_WISH_SRGB | TR_WISH_ENTERING) &&
           (unsigned)wishes->alpha < TR_ALPHA_COUNT && (wishes->interior != TR_INTERIOR_LAYERS || wishes->layers > 0);
}

static int tr_i_counts_are_valid(const tr_scene *counts) {
    uint64_t all = (uint64_t)counts->transparent + counts->transparent_two_sided;
    uint64_t sorted = (uint64_t)counts->implicit_asked + counts->explicit_asked + counts->holding;
    return !counts->invalid && sorted <= all && counts->group_size <= all;
}

TR_I_API tr_result tr_plan_make(const tr_scene *counts, const tr_wishes *wishes, tr_plan *plan) {
    uint32_t transparent, opaque, lines;
    int alone, entering;
    if (!counts || !wishes || !plan || !tr_i_wishes_are_valid(wishes) || !tr_i_counts_are_valid(counts))
        return TR_INVALID_ARGUMENT;
    memset(plan, 0, sizeof *plan);
    transparent = counts->transparent || counts->transparent_two_sided;
    opaque = counts->opaque || counts->opaque_two_sided || counts->opaque_drawn;
    lines = wishes->lines & (TR_LINES_CREASES | TR_LINES_OUTLINES);
    /* Counts may be large enough to wrap when added; either being over one rules "alone" out. */
    alone = counts->transparent <= 1 && counts->transparent_two_sided <= 1 &&
            counts->transparent + counts->transparent_two_sided == 1;
    plan->supersample = wishes->supersample ? (int)wishes->supersample : 1;
    if (!transparent && !opaque)
        return TR_OK;
    tr_i_plan_interiors(plan, counts, wishes);
    tr_i_add_layers(plan, counts, alone);
    /* Without an opaque thing nothing can be seen through a surface but the background, whatever the limit; but as
       published back faces hide front faces too. */
    if (transparent && (opaque || plan->interior == TR_INTERIOR_IMPLICIT_PUBLISHED))
        tr_i_add_limit(plan, counts, alone);
    if (counts->opaque_drawn)
        tr_i_add_pass(plan, TR_PASS_TAKE_OPAQUE,
                      transparent
                          ? "from the host's textures: the nearest surface, which alone can lie before the limit"
                          : "from the host's textures");
    entering = transparent && (wishes->options & TR_WISH_ENTERING);
    tr_i_add_surfaces(plan, TR_PASS_OPAQUE, entering ? TR_RULE_OPAQUE_ENTERING : TR_RULE_OPAQUE, 0, counts->opaque,
                      counts->opaque_two_sided, TR_OPAQUE,
                      entering      ? "opaque objects before the limit, strengthened where they enter others"
                      : transparent ? "opaque objects before the limit"
                                    : "opaque objects");
    if (opaque && lines) {
        tr_i_add_pass(plan, TR_PASS_COPY_DEPTH, "opaque lines read the depth that they write");
        tr_i_add_lines(plan, TR_PASS_OPAQUE_LINES, lines, TR_I_ALL_OPAQUE);
    }
    tr_i_add_pass(plan, TR_PASS_COMPOSE,
                  transparent ? "transparent layers over what is behind them, into the target"
                              : "opaque objects into the target");
    if (transparent)
        tr_i_add_lines(plan, TR_PASS_TRANSPARENT_LINES, lines, TR_I_ALL_TRANSPARENT);
    tr_i_add_late_lines(plan, wishes->lines, opaque, transparent);
    tr_i_plan_textures(plan);
    return TR_OK;
}

static void tr_i_put_plan_head(tr_i_text *text, const tr_plan *plan) {
    static const char *const names[] = {"implicit", "implicit, as published,", "explicit", "", "layered"};
    if (plan->layers) {
        tr_i_put(text, plan->mixed ? "implicit and explicit" : names[plan->interior]);
        tr_i_put(text, " interiors, ");
        tr_i_put(text, plan->why);
        tr_i_put(text, "; ");
        tr_i_put_number(text, (uint64_t)plan->layers);
        tr_i_put(text, plan->layers > 1 ? plan->grouped ? " layers for groups\n" : " layers\n" : " layer\n");
    }
    if (plan->supersample > 1) {
        tr_i_put_number(text, (uint64_t)plan->supersample);
        tr_i_put(text, " by ");
        tr_i_put_number(text, (uint64_t)plan->supersample);
        tr_i_put(text, " texels a pixel in textures of our own, averaged into the target\n");
    }
}

TR_I_API size_t tr_plan_print(const tr_plan *plan, char *string, size_t capacity) {
    static const char *const classes[4] = {"opaque", "transparent", "opaque two-sided", "transparent two-sided"};
    tr_i_text text = tr_i_text_in(string, string ? capacity : 0);
    int i, c;
    if (plan)
        tr_i_put_plan_head(&text, plan);
    for (i = 0; plan && i < plan->pass_count; ++i) {
        const tr_plan_pass *pass = &plan->passes[i];
        const char *separator = " [";
        tr_i_put_number(&text, (uint64_t)i + 1);
        tr_i_put(&text, ". ");
        tr_i_put(&text, tr_pass_kind_name(pass->kind));
        for (c = 0; c < 4; ++c) {
            if (pass->classes & (1u << c)) {
                tr_i_put(&text, separator);
                tr_i_put(&text, classes[c]);
                separator = ", ";
            }
        }
        tr_i_put(&text, pass->classes ? "]: " : ": ");
        tr_i_put(&text, pass->why);
        tr_i_put(&text, "\n");
    }
    tr_i_put_number(&text, plan ? plan->bytes_per_pixel : 0);
    tr_i_put(&text, " bytes a pixel\n");
    return text.length;
}

/* x > 0, infinity included; by its bits, so that NaN is not whatever the compiler's options make of it. */
static int tr_i_positive(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits - 1u < 0x7f800000u;
}

/* By its bits: comparisons with NaN are what -ffast-math takes away. */
static int tr_i_all_finite(const float *numbers, int count) {
    int i;
    for (i = 0; i < count; ++i) {
        uint32_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        if ((bits & 0x7f800000u) == 0x7f800000u)
            return 0;
    }
    return 1;
}

TR_I_API float tr_view_alpha(float d, float d_max, float k) {
    double ratio, alpha;
    if (!tr_i_positive(d) || !tr_i_positive(d_max))
        return 1.0f;
    if (d >= d_max || !tr_i_positive(k))
        return 0.0f;
    /* The quotient in double: two floats neither overflow nor vanish there. */
    ratio = (double)d / (double)d_max;
    if (ratio < 1.0e-30) /* as in the shader */
        ratio = 1.0e-30;
    alpha = 1.0 - pow(ratio, (double)k);
    return alpha < 0.0 ? 0.0f : alpha > 1.0 ? 1.0f : (float)alpha;
}

/* ---- dynamic transparency: units -------------------------------------------------------------------------------- */

#define TR_I_UNIT_FLAGS 31u
#define TR_I_KEPT (TR_UNIT_TARGET | TR_UNIT_IMPENETRABLE | TR_UNIT_BACKDROP) /* of these none yields */
#define TR_I_MAX_UNIT_ID 0xffffu

static float tr_i_clamp01(float x) {
    return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
}

static float tr_i_fade_of(const tr_unit *unit) {
    return tr_i_all_finite(&unit->fade, 1) ? tr_i_clamp01(unit->fade) : 0.0f;
}

static float tr_i_importance_of(const tr_unit *unit) {
    if (!tr_i_all_finite(&unit->importance, 1) || unit->importance == 0.0f)
        return unit->flags & TR_UNIT_TARGET ? 1.0f : 0.0f;
    return tr_i_clamp01(unit->importance);
}

/* How much of what a mask asks for is done, but for what occluders keep: the whole, less importance and fading. */
static float tr_i_strength_of(const tr_unit *unit) {
    return tr_i_importance_of(unit) * (unit->flags & TR_UNIT_TARGET ? 1.0f - tr_i_fade_of(unit) : 1.0f);
}

TR_I_API uint32_t tr_unit_code(const tr_unit *unit) {
    if (!unit)
        return 0;
    return (unit->id & TR_I_MAX_UNIT_ID) | (unit->flags & TR_I_UNIT_FLAGS) << 16 |
           (uint32_t)(tr_i_strength_of(unit) * 255.0f + 0.5f) << 24;
}

TR_I_API void tr_advance(void *units, size_t count, size_t stride, const float *wanted, float seconds,
                         float fade_time) {
    size_t i;
    int at_once = !tr_i_positive(fade_time);
    if (!units || !tr_i_positive(seconds) || !tr_i_all_finite(&seconds, 1))
        return;
    for (i = 0; i < count; ++i) {
        char *at = (char *)units + i * (stride ? stride : sizeof(tr_unit));
        float goal = wanted && tr_i_all_finite(&wanted[i], 1) ? tr_i_clamp01(wanted[i]) : 0.0f;
        tr_unit unit;
        double fade, step;
        memcpy(&unit, at, sizeof unit);
        fade = (double)tr_i_fade_of(&unit);
        step = at_once ? 1.0 : (double)seconds / (double)fade_time;
        /* Linear, and never past the goal: that is what makes steps add up. */
        fade = fade < (double)goal ? (fade + step < (double)goal ? fade + step : (double)goal)
                                   : (fade - step > (double)goal ? fade - step : (double)goal);
        unit.fade = (float)fade;
        memcpy(at, &unit, sizeof unit);
    }
}

/* World to clip, in double. */
static void tr_i_view_projection(const float view[16], const float projection[16], double out[16]) {
    int c, r, k;
    for (c = 0; c < 4; ++c) {
        for (r = 0; r < 4; ++r) {
            double sum = 0;
            for (k = 0; k < 4; ++k)
                sum += (double)projection[4 * k + r] * (double)view[4 * c + k];
            out[4 * c + r] = sum;
        }
    }
}

/* Whether a unit has bounds: else it may be anywhere. */
static int tr_i_is_bounded(const tr_unit *unit) {
    return tr_i_all_finite(unit->center, 3) && tr_i_all_finite(&unit->radius, 1) && unit->radius >= 0.0f;
}

/* Where the planes through the eye (or along the view) and one axis of the screen touch a sphere: clip x / w = t where
   the plane row_x - t row_w is as far from the centre as the radius; a quadratic in t. Returns 0 for the whole axis. */
static int tr_i_sphere_span(const double m[16], int axis, const tr_unit *unit, double out[2]) {
    const float *p = unit->center;
    double r = (double)unit->radius, a = m[12 + axis], b = m[15], aa = 0, ab = 0, bb = 0, root, middle, scale;
    int i;
    for (i = 0; i < 3; ++i) {
        a += m[4 * i + axis] * (double)p[i];
        b += m[4 * i + 3] * (double)p[i];
        aa += m[4 * i + axis] * m[4 * i + axis];
        ab += m[4 * i + axis] * m[4 * i + 3];
        bb += m[4 * i + 3] * m[4 * i + 3];
    }
    scale = b * b - r * r * bb;
    middle = a * b - r * r * ab;
    root = middle * middle - scale * (a * a - r * r * aa);
    if (!(scale > 0.0) || scale > 1.0e300 || middle > 1.0e150 || middle < -1.0e150)
        return 0;
    root = root > 0.0 ? sqrt(root) : 0.0;
    out[0] = (middle - root) / scale;
    out[1] = (middle + root) / scale;
    return 1;
}

/* -1: the sphere lies wholly behind the eye; 1: wholly before it; 0: it touches the plane of the eye. */
static int tr_i_side_of_eye(const double m[16], const tr_unit *unit) {
    double w = m[15], size = 0, r = (double)unit->radius;
    int i;
    for (i = 0; i < 3; ++i) {
        w += m[4 * i + 3] * (double)unit->center[i];
        size += m[4 * i + 3] * m[4 * i + 3];
    }
    r *= sqrt(size);
    return w > r ? 1 : w < -r ? -1 : 0;
}

/* Whether a sphere lies wholly outside of one of the four planes at the sides of the view, which all go through the eye, or
   along the view: one beside the eye has no rectangle that says so. */
static int tr_i_is_beside(const double m[16], const tr_unit *unit) {
    int plane, i;
    for (plane = 0; plane < 4; ++plane) {
        double sign = plane & 1 ? -1.0 : 1.0, size = 0, at = m[15] + sign * m[12 + plane / 2];
        for (i = 0; i < 3; ++i) {
            double c = m[4 * i + 3] + sign * m[4 * i + plane / 2];
            at += c * (double)unit->center[i];
            size += c * c;
        }
        if (at < -(double)unit->radius * sqrt(size))
            return 1;
    }
    return 0;
}

/* From clip coordinates -1 ... 1 to pixels, outward; 0 if none is left. */
static int tr_i_pixel_span(const double span[2], int size, int out[2]) {
    double low = floor((span[0] + 1.0) * 0.5 * (double)size), high = ceil((span[1] + 1.0) * 0.5 * (double)size);
    if (!(low < (double)size) || !(high > 0.0) || high <= low)
        return 0;
    out[0] = low > 0.0 ? (int)low : 0;
    out[1] = high < (double)size ? (int)high : size;
    return 1;
}

/* As x0, y0, x1, y1, the last two outside. */
static int tr_i_unit_bounds(const tr_unit *unit, const double m[16], int width, int height, int out[4]) {
    double x[2] = {-1.0, 1.0}, y[2] = {-1.0, 1.0};
    int side = 0, across[2], up[2];
    if (tr_i_is_bounded(unit)) {
        side = tr_i_side_of_eye(m, unit);
        if (side < 0 || tr_i_is_beside(m, unit))
            return 0;
        if (side > 0 && !(tr_i_sphere_span(m, 0, unit, x) && tr_i_sphere_span(m, 1, unit, y))) {
            x[0] = y[0] = -1.0;
            x[1] = y[1] = 1.0;
        }
    }
    if (side > 0 && unit->radius == 0.0f) { /* a point covers the pixel that it lies in */
        x[1] += 1.0e-9;
        y[1] += 1.0e-9;
    }
    if (!tr_i_pixel_span(x, width, across) || !tr_i_pixel_span(y, height, up))
        return 0;
    out[0] = across[0];
    out[1] = up[0];
    out[2] = across[1];
    out[3] = up[1];
    return 1;
}

TR_I_API int tr_unit_rectangle(const tr_unit *unit, const float view[16], const float projection[16], int width,
                               int height, int rectangle[4]) {
    double m[16];
    int bounds[4];
    if (!unit || !view || !projection || !rectangle || width <= 0 || height <= 0 || !tr_i_all_finite(view, 16) ||
        !tr_i_all_finite(projection, 16))
        return 0;
    tr_i_view_projection(view, projection, m);
    if (!tr_i_unit_bounds(unit, m, width, height, bounds))
        return 0;
    rectangle[0] = bounds[0];
    rectangle[1] = bounds[1];
    rectangle[2] = bounds[2] - bounds[0];
    rectangle[3] = bounds[3] - bounds[1];
    return 1;
}

/* ---- dynamic transparency: what is drawn where ------------------------------------------------------------------ */

static tr_unit tr_i_unit_at(const tr_dynamic *dynamic, size_t index) {
    tr_unit unit;
    size_t stride = dynamic->unit_stride ? dynamic->unit_stride : sizeof unit;
    memcpy(&unit, (const char *)dynamic->units + index * stride, sizeof unit);
    return unit;
}

/* Cells of a multiple of 8 pixels, so that texels of masks do not lie across their borders. */
static void tr_i_size_grid(tr_i_grid *grid, int width, int height, int side) {
    grid->side = side;
    while (width > grid->side * TR_I_CELLS || height > grid->side * TR_I_CELLS)
        grid->side += 8;
    grid->columns = (width + grid->side - 1) / grid->side;
    grid->rows = (height + grid->side - 1) / grid->side;
}

/* The cells of a rectangle grown by `by` pixels: x0, y0, x1, y1, the last two outside. */
static void tr_i_cells_of(const tr_i_grid *grid, const tr_i_place *place, int by, int out[4]) {
    int x0 = (int)place->x0 - by, y0 = (int)place->y0 - by;
    int x1 = ((int)place->x1 + by + grid->side - 1) / grid->side,
        y1 = ((int)place->y1 + by + grid->side - 1) / grid->side;
    out[0] = x0 > 0 ? x0 / grid->side : 0;
    out[1] = y0 > 0 ? y0 / grid->side : 0;
    out[2] = x1 < grid->columns ? x1 : grid->columns;
    out[3] = y1 < grid->rows ? y1 : grid->rows;
}

static float tr_i_infinite(void) {
    static const uint32_t bits = 0x7f800000u;
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Lowers values in the cells of a rectangle (or, with sign -1, raises them). */
static void tr_i_lower_cells(float *cells, const int box[4], float value, float sign) {
    int x, y;
    for (y = box[1]; y < box[3]; ++y)
        for (x = box[0]; x < box[2]; ++x) {
            float *cell = &cells[y * TR_I_CELLS + x];
            *cell = sign * value < sign * *cell ? value : *cell;
        }
}

/* Whether any cell of a rectangle has a value that `depth` is not before (sign 1) or not behind (sign -1). */
static int tr_i_any_cell(const float *cells, const int box[4], float depth, float sign) {
    int x, y;
    for (y = box[1]; y < box[3]; ++y)
        for (x = box[0]; x < box[2]; ++x)
            if (sign * cells[y * TR_I_CELLS + x] <= sign * depth)
                return 1;
    return 0;
}

static void tr_i_place_unit(const tr_unit *unit, const float view[16], const double m[16], int width, int height,
                            tr_i_place *place) {
    double depth, size, r = (double)unit->radius;
    int bounds[4];
    memset(place, 0, sizeof *place);
    if (!tr_i_unit_bounds(unit, m, width, height, bounds))
        return;
    place->x0 = (uint16_t)bounds[0];
    place->y0 = (uint16_t)bounds[1];
    place->x1 = (uint16_t)bounds[2];
    place->y1 = (uint16_t)bounds[3];
    place->last = tr_i_infinite();
    place->first = -place->last;
    if (!tr_i_is_bounded(unit))
        return;
    depth = -(double)view[14] - (double)view[2] * (double)unit->center[0] - (double)view[6] * (double)unit->center[1] -
            (double)view[10] * (double)unit->center[2];
    size = sqrt((double)view[2] * (double)view[2] + (double)view[6] * (double)view[6] +
                (double)view[10] * (double)view[10]);
    /* Outward by more than the rounding to float; what is too large for that is infinite. */
    r = r * size + 1.0e-6 * fabs(depth);
    if (fabs(depth) + r < 1.0e30) {
        place->first = (float)(depth - r);
        place->last = (float)(depth + r);
    }
}

/* Rows of cells with masks as few rectangles as a greedy search finds; 0 where they are more than there is room for. */
static int tr_i_make_tiles(tr_i_grid *grid) {
    unsigned char open[TR_I_CELLS][TR_I_CELLS];
    int x, y, x1, y1, i;
    float none = -tr_i_infinite();
    grid->tile_count = grid->cell_count = 0;
    for (y = 0; y < grid->rows; ++y)
        for (x = 0; x < grid->columns; ++x) {
            open[y][x] = grid->farthest_target[y * TR_I_CELLS + x] > none;
            grid->cell_count += open[y][x];
        }
    for (y = 0; y < grid->rows; ++y)
        for (x = 0; x < grid->columns; ++x) {
            unsigned char *tile = grid->tiles[grid->tile_count];
            if (!open[y][x])
                continue;
            if (grid->tile_count == TR_I_MAX_TILES)
                return 0;
            for (x1 = x + 1; x1 < grid->columns && open[y][x1];)
                ++x1;
            for (y1 = y, i = x1; i == x1 && y1 < grid->rows;) {
                for (i = x; i < x1 && open[y1][i];)
                    ++i;
                y1 += i == x1;
            }
            for (i = y; i < y1; ++i)
                memset(&open[i][x], 0, (size_t)(x1 - x));
            tile[0] = (unsigned char)x;
            tile[1] = (unsigned char)y;
            tile[2] = (unsigned char)x1;
            tile[3] = (unsigned char)y1;
            ++grid->tile_count;
        }
    return 1;
}

static int tr_i_cell_is_open(const tr_i_grid *grid, int x, int y) {
    return grid->farthest_target[y * TR_I_CELLS + x] > -tr_i_infinite();
}

/* A rectangle without its outer lines that have no masks; 0: nothing is left. */
static int tr_i_shrink_region(const tr_i_grid *grid, int box[4]) {
    int out[4] = {TR_I_CELLS, TR_I_CELLS, 0, 0}, x, y;
    for (y = box[1]; y < box[3]; ++y)
        for (x = box[0]; x < box[2]; ++x)
            if (tr_i_cell_is_open(grid, x, y)) {
                out[0] = x < out[0] ? x : out[0];
                out[1] = y < out[1] ? y : out[1];
                out[2] = x + 1 > out[2] ? x + 1 : out[2];
                out[3] = y + 1 > out[3] ? y + 1 : out[3];
            }
    memcpy(box, out, sizeof out);
    return out[2] > 0;
}

/* What the open cells of the lines from one end of a rectangle (step 1) or the other (-1) span, for each number of lines:
   areas[line] is of those up to and with it. */
static void tr_i_sweep_region(const tr_i_grid *grid, const int box[4], int axis, int step, int *areas) {
    int first = step > 0 ? box[axis] : box[axis + 2] - 1, end = step > 0 ? box[axis + 2] : box[axis] - 1, line, at;
    int low = TR_I_CELLS, high = 0, from = -1, area = 0;
    for (line = first; line != end; line += step) {
        int open = 0;
        for (at = box[1 - axis]; at < box[3 - axis]; ++at)
            if (tr_i_cell_is_open(grid, axis ? at : line, axis ? line : at)) {
                low = at < low ? at : low;
                high = at + 1 > high ? at + 1 : high;
                open = 1;
            }
        from = open && from < 0 ? line : from;
        area = open ? ((line - from) * step + 1) * (high - low) : area;
        areas[line] = area;
    }
}

/* Cuts a region in two where that leaves out the most cells; returns how many, 0 where there is no such place. */
static int tr_i_cut_region(const tr_i_grid *grid, const int box[4], int parts[2][4]) {
    int before[TR_I_CELLS], after[TR_I_CELLS], axis, line, most = 0, whole = (box[2] - box[0]) * (box[3] - box[1]);
    for (axis = 0; axis < 2; ++axis) {
        tr_i_sweep_region(grid, box, axis, 1, before);
        tr_i_sweep_region(grid, box, axis, -1, after);
        for (line = box[axis] + 1; line < box[axis + 2]; ++line) {
            int saved = whole - before[line - 1] - after[line];
            if (saved <= most)
                continue;
            most = saved;
            memcpy(parts[0], box, sizeof parts[0]);
            memcpy(parts[1], box, sizeof parts[1]);
            parts[0][axis + 2] = parts[1][axis] = line;
        }
    }
    return most;
}

/* Few rectangles that hold all masks. What shows through is drawn in each by itself: triangles outside of it are thrown
   away before they are set up, which tiles cannot do for a host's draws. */
static void tr_i_make_regions(tr_i_grid *grid) {
    int saved[TR_I_MAX_REGIONS], cuts[TR_I_MAX_REGIONS][2][4], i;
    int worth = grid->columns * grid->rows / TR_I_REGION_SAVES;
    grid->regions[0][0] = grid->regions[0][1] = 0;
    grid->regions[0][2] = grid->columns;
    grid->regions[0][3] = grid->rows;
    grid->region_count = tr_i_shrink_region(grid, grid->regions[0]);
    saved[0] = tr_i_cut_region(grid, grid->regions[0], cuts[0]);
    while (grid->region_count > 0 && grid->region_count < TR_I_MAX_REGIONS) {
        int best = 0, last = grid->region_count;
        for (i = 1; i < last; ++i)
            best = saved[i] > saved[best] ? i : best;
        if (saved[best] <= worth)
            return;
        memcpy(grid->regions[last], cuts[best][1], sizeof grid->regions[last]);
        memcpy(grid->regions[best], cuts[best][0], sizeof grid->regions[best]);
        tr_i_shrink_region(grid, grid->regions[last]);
        tr_i_shrink_region(grid, grid->regions[best]);
        saved[last] = tr_i_cut_region(grid, grid->regions[last], cuts[last]);
        saved[best] = tr_i_cut_region(grid, grid->regions[best], cuts[best]);
        ++grid->region_count;
    }
}

static tr_i_law tr_i_law_of(const tr_dynamic *dynamic) {
    tr_i_law law;
    law.target = dynamic->alpha_target == 0.0f ? 0.3f : tr_i_clamp01(dynamic->alpha_target);
    law.start = dynamic->alpha_start == 0.0f ? 0.1f : tr_i_clamp01(dynamic->alpha_start);
    law.width = dynamic->width == 0.0f ? 12.0f : dynamic->width > 0.0f ? dynamic->width : 0.0f;
    law.divisor = dynamic->mask_divisor                                              ? dynamic->mask_divisor
                  : dynamic->see == TR_SEE_ONE_MASK || dynamic->see == TR_SEE_DITHER ? 4
                  : dynamic->see == TR_SEE_EXACT                                     ? 1
                                                                                     : 2;
    law.reach = law.width > 0.0f ? (int)ceil((double)law.width) + 1 : 0;
    return law;
}

/* Pixels beyond a target's rectangle that its mask may reach, with the interpolation between texels. */
static int tr_i_margin(const tr_i_law *law) {
    return law->reach + (law->reach ? law->divisor : 0);
}

/* Whether a light reaches a rectangle grown by `by`. */
static int tr_i_is_lit(const tr_dynamic *dynamic, const tr_i_place *place, int by) {
    size_t i;
    for (i = 0; i < dynamic->light_count; ++i) {
        const tr_light *light = &dynamic->lights[i];
        double reach = (double)light->radius + (light->edge > 0.0f ? (double)light->edge : 0.0);
        double x0 = (double)place->x0 - by, x1 = (double)place->x1 + by, y0 = (double)place->y0 - by;
        double y1 = (double)place->y1 + by, x = (double)light->x, y = (double)light->y;
        double dx = x < x0 ? x0 - x : x > x1 ? x - x1 : 0.0, dy = y < y0 ? y0 - y : y > y1 ? y - y1 : 0.0;
        if (dx * dx + dy * dy <= reach * reach)
            return 1;
    }
    return 0;
}

/* Whether a target in view has a mask at all. */
static int tr_i_opens(const tr_dynamic *dynamic, const tr_unit *unit, const tr_i_place *place, int margin) {
    return place->x1 != 0 && tr_unit_code(unit) >> 24 != 0 && /* less than a step: none */
           (!(unit->flags & TR_UNIT_ACTIVE) || tr_i_is_lit(dynamic, place, margin));
}

/* Whether an occluder may yield to anything. */
static int tr_i_yields(const tr_unit *unit) {
    return !(unit->flags & TR_I_KEPT) && tr_i_importance_of(unit) < 1.0f;
}

static void tr_i_clear_grid(tr_i_grid *grid) {
    float none = tr_i_infinite();
    int i;
    for (i = 0; i < TR_I_CELLS * TR_I_CELLS; ++i) {
        grid->nearest_yielding[i] = grid->nearest_target[i] = none;
        grid->farthest_target[i] = -none;
    }
}

/* Places of all units, and where those that yield are. */
static void tr_i_place_units(tr_i_see *see, const tr_dynamic *dynamic, int width, int height) {
    double m[16];
    size_t i;
    int cells[4];
    tr_i_view_projection(dynamic->view, dynamic->projection, m);
    for (i = 0; i < dynamic->unit_count; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        tr_i_place *place = &see->places[i];
        tr_i_place_unit(&unit, dynamic->view, m, width, height, place);
        see->plan.targets += unit.flags & TR_UNIT_TARGET;
        see->plan.targets_in_view += (unit.flags & TR_UNIT_TARGET) && place->x1 != 0;
        if (place->x1 == 0 || !(dynamic->query ? !(unit.flags & TR_I_KEPT) : tr_i_yields(&unit)))
            continue;
        tr_i_cells_of(&see->grid, place, 0, cells);
        tr_i_lower_cells(see->grid.nearest_yielding, cells, place->first, 1.0f);
    }
}

static void tr_i_list(tr_i_see *see, int list, size_t unit) {
    see->lists[list][see->counts[list]++] = (uint32_t)unit;
}

/* Targets that something may lie before, and the cells of their masks. */
static void tr_i_find_masks(tr_i_see *see, const tr_dynamic *dynamic) {
    size_t i;
    int cells[4], margin = tr_i_margin(&see->law);
    for (i = 0; i < dynamic->unit_count; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        const tr_i_place *place = &see->places[i];
        if (!(unit.flags & TR_UNIT_TARGET) || !tr_i_opens(dynamic, &unit, place, margin))
            continue;
        tr_i_cells_of(&see->grid, place, margin, cells);
        if (!tr_i_any_cell(see->grid.nearest_yielding, cells, place->last, 1.0f))
            continue;
        tr_i_list(see, TR_I_UNITS_TARGETS, i);
        tr_i_lower_cells(see->grid.nearest_target, cells, place->first, 1.0f);
        tr_i_lower_cells(see->grid.farthest_target, cells, place->last, -1.0f);
    }
}

/* Who is drawn again, by the masks that it meets. */
static void tr_i_list_units(tr_i_see *see, const tr_dynamic *dynamic) {
    const tr_i_grid *grid = &see->grid;
    size_t i, next = 0;
    int cells[4], dither = dynamic->see == TR_SEE_DITHER;
    for (i = 0; i < dynamic->unit_count; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        const tr_i_place *place = &see->places[i];
        int target = next < see->counts[TR_I_UNITS_TARGETS] && see->lists[TR_I_UNITS_TARGETS][next] == i, before;
        int yields = tr_i_yields(&unit), /* of a scene in parts each unit is in one of them */
            block = (unit.flags & (TR_UNIT_IMPENETRABLE | TR_UNIT_BACKDROP)) && !(target && see->plan.in_parts);
        float importance = unit.flags & TR_I_KEPT ? 0.0f : tr_i_importance_of(&unit);
        next += (size_t)target;
        tr_i_cells_of(grid, place, 0, cells);
        if (place->x1 == 0 || !tr_i_any_cell(grid->nearest_target, cells, 3.0e38f, 1.0f)) {
            tr_i_list(see, TR_I_UNITS_REST, i);
            continue;
        }
        tr_i_list(see, TR_I_UNITS_MASKED, i);
        if (block)
            tr_i_list(see, TR_I_UNITS_BLOCK, i);
        before = !(unit.flags & TR_I_KEPT) && tr_i_any_cell(grid->farthest_target, cells, place->first, -1.0f);
        if (before) {
            tr_i_list(see, TR_I_UNITS_BEFORE, i);
            see->partial |= yields && importance > 0.0f;
        }
        if (!target && !block)
            tr_i_list(see, dither && before && yields ? TR_I_UNITS_HOLED : TR_I_UNITS_REST, i);
        /* What is there already; and what lies before all masks that it meets would be discarded to the last fragment. */
        if (!(target && (see->colored || see->plan.in_parts)) && !(block && see->plan.in_parts) &&
            (!yields || importance > 0.0f || tr_i_any_cell(grid->nearest_target, cells, place->last, 1.0f)))
            tr_i_list(see, TR_I_UNITS_BEHIND, i);
    }
}

/* Depth formats of targets, by what their framebuffers tell: copies need the very same. */
static const struct tr_i_depth {
    tr_i_u internal, format, type, bytes;
    int32_t bits, stencil, floats;
} tr_i_depths[] = {
    {TR_I_GL_DEPTH_COMPONENT16, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_UNSIGNED_SHORT, 2, 16, 0, 0},
    {TR_I_GL_DEPTH_COMPONENT24, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_UNSIGNED_INT, 4, 24, 0, 0},
    {TR_I_GL_DEPTH24_STENCIL8, TR_I_GL_DEPTH_STENCIL, TR_I_GL_UNSIGNED_INT_24_8, 4, 24, 8, 0},
    {TR_I_GL_DEPTH_COMPONENT32, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_UNSIGNED_INT, 4, 32, 0, 0},
    {TR_I_GL_DEPTH_COMPONENT32F, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_FLOAT, 4, 32, 0, 1},
    {TR_I_GL_DEPTH32F_STENCIL8, TR_I_GL_DEPTH_STENCIL, TR_I_GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 8, 32, 8, 1}};
#define TR_I_DEPTHS ((int)(sizeof tr_i_depths / sizeof tr_i_depths[0]))

static int32_t tr_i_of_attachment(const tr_context *tr, tr_i_u attachment, tr_i_u what) {
    int32_t value = 0;
    tr->gl.GetFramebufferAttachmentParameteriv(TR_I_GL_DRAW_FRAMEBUFFER, attachment, what, &value);
    return value;
}

/* Of the framebuffer that is bound; -1: none of those that we know. What is packed with a stencil stays that where it is
   attached for its depth alone; a stencil in a texture of its own is none of the depth's format. */
static int tr_i_find_depth(const tr_context *tr) {
    tr_i_u depth = tr->frame.framebuffer ? TR_I_GL_DEPTH_ATTACHMENT : TR_I_GL_DEPTH;
    int32_t bits, stencil, floats;
    int i;
    if (tr_i_of_attachment(tr, depth, TR_I_GL_ATTACHMENT_OBJECT_TYPE) == 0)
        return -1;
    bits = tr_i_of_attachment(tr, depth, TR_I_GL_ATTACHMENT_DEPTH_SIZE);
    floats = tr_i_of_attachment(tr, depth, TR_I_GL_ATTACHMENT_COMPONENT_TYPE) == (int32_t)TR_I_GL_FLOAT;
    if (!tr->frame.framebuffer && tr_i_of_attachment(tr, TR_I_GL_STENCIL, TR_I_GL_ATTACHMENT_OBJECT_TYPE) != 0)
        depth = TR_I_GL_STENCIL; /* a window's are in one buffer, but for each only its own size has to be told */
    stencil = tr_i_of_attachment(tr, depth, TR_I_GL_ATTACHMENT_STENCIL_SIZE);
    for (i = 0; i < TR_I_DEPTHS; ++i)
        if (tr_i_depths[i].bits == bits && tr_i_depths[i].stencil == stencil && tr_i_depths[i].floats == floats)
            return i;
    return -1;
}

/* Whether colours of the framebuffer that is bound can be copied as they are; TR_WISH_SRGB says how ours are kept. A target
   that could encode, as many windows can, does not where GL_FRAMEBUFFER_SRGB is off, in copies neither. */
static int tr_i_can_take_color(const tr_context *tr) {
    int32_t buffer = 0, type, wished = (tr->frame.wishes.options & TR_WISH_SRGB) != 0, encodes;
    tr_i_u attachment;
    tr->gl.GetIntegerv(TR_I_GL_DRAW_BUFFER0, &buffer);
    attachment = (tr_i_u)buffer;
    if (!tr->frame.framebuffer && !tr->es) /* of two eyes the left one */
        attachment = attachment == TR_I_GL_BACK    ? TR_I_GL_BACK_LEFT
                     : attachment == TR_I_GL_FRONT ? TR_I_GL_FRONT_LEFT
                                                   : attachment;
    if (buffer == 0 || tr_i_of_attachment(tr, attachment, TR_I_GL_ATTACHMENT_OBJECT_TYPE) == 0)
        return 0;
    type = tr_i_of_attachment(tr, attachment, TR_I_GL_ATTACHMENT_COMPONENT_TYPE);
    encodes = tr_i_of_attachment(tr, attachment, TR_I_GL_ATTACHMENT_COLOR_ENCODING) == (int32_t)TR_I_GL_SRGB &&
              (wished || tr->es || tr->gl.IsEnabled(TR_I_GL_FRAMEBUFFER_SRGB));
    return type != (int32_t)TR_I_GL_INT && type != (int32_t)TR_I_GL_UNSIGNED_INT && wished == encodes;
}

/* Why the scene cannot come in parts; 0: it can. Asks of the target what a copy has to know. */
static const char *tr_i_why_whole(tr_context *tr, const tr_dynamic *dynamic) {
    const char *why = 0;
    int32_t bound = 0, found = 0, samples = 0;
    if (dynamic->see != TR_SEE_ONE_MASK && dynamic->see != TR_SEE_DITHER)
        return "this rung draws each unit in its turn";
    if (tr->desc.state == TR_STATE_NONE)
        return "TR_STATE_NONE: a copy is none of the host's draws";
    if (tr->see.marked &&
        (tr->frame.x != 0 || tr->frame.y != 0)) /* depths of the same triangles would be rounded apart */
        return "lights, fading, importances or queries, and a viewport that is not at the target's corner";
    tr->gl.GetIntegerv(TR_I_GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    tr->gl.BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->frame.framebuffer);
    tr->gl.GetIntegerv(TR_I_GL_DRAW_FRAMEBUFFER_BINDING, &found);
    tr->gl.GetIntegerv(TR_I_GL_SAMPLES, &samples);
    if ((tr_i_u)found != tr->frame.framebuffer)
        why = "the target is none";
    else if (samples > 0)
        why = "the target is multisampled";
    else if ((tr->see.host_depth = tr_i_find_depth(tr)) < 0)
        why = "the target's depth has no format that can be copied";
    else if (dynamic->see == TR_SEE_ONE_MASK && !tr_i_can_take_color(tr))
        why = "the target's colours are integers, or encoded otherwise than TR_WISH_SRGB says";
    tr->gl.BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, (tr_i_u)bound);
    return why;
}

static tr_see_pass *tr_i_add_see_pass(tr_see_plan *plan, tr_pass_kind kind, tr_rule rule, size_t units,
                                      const char *why) {
    tr_see_pass *pass = &plan->passes[plan->pass_count++];
    pass->kind = kind;
    pass->rule = rule;
    pass->unit_count = (uint32_t)units;
    pass->why = why;
    pass->times = 0;
    return pass;
}

/* Plain drawing. */
static void tr_i_plan_plain(tr_i_see *see, const char *why) {
    see->plan.see = TR_SEE_OFF;
    see->plan.why = why;
    tr_i_add_see_pass(&see->plan, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, see->counts[TR_I_UNITS_ALL], why);
}

/* A part of the scene, or a copy of it: nothing where no unit is in the list. */
static void tr_i_add_part(tr_i_see *see, tr_pass_kind kind, tr_rule rule, int list, const char *why) {
    if (see->counts[list] == 0)
        return;
    see->units_of[see->plan.pass_count] = (unsigned char)list;
    tr_i_add_see_pass(&see->plan, kind, rule, kind == TR_PASS_SCENE ? see->counts[list] : 0, why);
}

/* Targets by themselves, then with what closes masks: where both depths are the same a target is open. */
static void tr_i_plan_base(tr_i_see *see) {
    int block = see->counts[TR_I_UNITS_BLOCK] != 0;
    tr_i_add_part(see, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, TR_I_UNITS_TARGETS, "targets, as ever");
    if (block && !see->marked)
        tr_i_add_part(see, TR_PASS_TAKE, TR_RULE_SEE_PLAIN, TR_I_UNITS_TARGETS, "their depth");
    tr_i_add_part(see, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, TR_I_UNITS_BLOCK, "what closes masks, as ever");
    tr_i_add_part(see, TR_PASS_TAKE, TR_RULE_SEE_PLAIN, block ? TR_I_UNITS_BLOCK : TR_I_UNITS_TARGETS,
                  "depth of what never yields");
    if (see->plan.see == TR_SEE_ONE_MASK)
        tr_i_add_part(see, TR_PASS_TAKE, TR_RULE_SEE_PLAIN, TR_I_UNITS_ALL, "its colour");
}

/* One mask for all targets, with depth. */
static void tr_i_plan_masks(tr_i_see *see, const tr_dynamic *dynamic) {
    tr_see_plan *plan = &see->plan;
    const size_t *counts = see->counts;
    if (counts[TR_I_UNITS_BLOCK] && !plan->in_parts)
        tr_i_add_see_pass(plan, TR_PASS_BLOCK, TR_RULE_SEE_BLOCK, counts[TR_I_UNITS_BLOCK],
                          "what closes masks, so that targets behind it open none");
    if (!plan->in_parts || see->marked)
        tr_i_add_see_pass(plan, TR_PASS_TARGETS, TR_RULE_SEE_TARGET, counts[TR_I_UNITS_TARGETS],
                          plan->in_parts ? "lights, fading, importances or queries: which target"
                                         : "the nearest target at each pixel");
    if (see->law.reach || (plan->in_parts && !see->marked))
        tr_i_add_see_pass(plan, TR_PASS_BITS, TR_RULE_SEE_PLAIN, 0, "pixels of targets, eight a texel");
    if (see->law.reach) {
        tr_i_add_see_pass(plan, TR_PASS_SPREAD_X, TR_RULE_SEE_PLAIN, 0, "the nearest pixel of a target in each row");
        tr_i_add_see_pass(plan, TR_PASS_SPREAD_Y, TR_RULE_SEE_PLAIN, 0, "of these the nearest: distance and depth");
    }
    tr_i_add_see_pass(plan, TR_PASS_FINISH, TR_RULE_SEE_PLAIN, 0,
                      "opacity and depth, with the target's own pixels as drawn");
    if (dynamic->query) {
        tr_i_add_see_pass(plan, TR_PASS_QUERY, TR_RULE_SEE_PLAIN, 0, "asked for: which target");
        tr_i_add_see_pass(plan, TR_PASS_HIDES, TR_RULE_SEE_HIDES, counts[TR_I_UNITS_BEFORE],
                          "asked for: whether something lies before it");
    }
}

static void tr_i_plan_one_mask(tr_i_see *see, const tr_dynamic *dynamic) {
    tr_see_plan *plan = &see->plan;
    /* First, so that the host's state is as it was and needs no second snapshot. */
    if (plan->in_parts) {
        tr_i_plan_base(see);
        tr_i_add_part(see, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, TR_I_UNITS_REST, "all else, as ever");
    } else {
        tr_i_add_see_pass(plan, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, see->counts[TR_I_UNITS_ALL],
                          "the whole scene, as ever");
    }
    tr_i_plan_masks(see, dynamic);
    if (see->counts[TR_I_UNITS_BEHIND] || !plan->in_parts) { /* else what was copied is all there is */
        tr_i_make_regions(&see->grid);
        tr_i_add_see_pass(plan, TR_PASS_PRIME, TR_RULE_SEE_PLAIN, 0, "so that nothing is shaded outside of masks");
        tr_i_add_see_pass(plan, TR_PASS_BEHIND, TR_RULE_SEE_BEHIND, see->counts[TR_I_UNITS_BEHIND],
                          "what shows through masks")
            ->times = (uint32_t)see->grid.region_count;
    }
    if (see->partial) {
        tr_i_add_see_pass(plan, TR_PASS_PRIME, TR_RULE_SEE_PLAIN, 0, "once more");
        tr_i_add_see_pass(plan, TR_PASS_YIELD, TR_RULE_SEE_YIELD, see->counts[TR_I_UNITS_MASKED],
                          "some yield in part: importance of the front-most");
    }
    tr_i_add_see_pass(plan, TR_PASS_COMPOSE_MASK, TR_RULE_SEE_PLAIN, 0, "what shows through masks, over it");
}

static void tr_i_plan_dither(tr_i_see *see, const tr_dynamic *dynamic) {
    if (see->plan.in_parts) {
        tr_i_plan_base(see);
        tr_i_add_part(see, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, TR_I_UNITS_REST, "what lies before no target, as ever");
        tr_i_plan_masks(see, dynamic);
        tr_i_add_part(see, TR_PASS_SCENE, TR_RULE_SEE_DITHER, TR_I_UNITS_HOLED, "all else, with holes before targets");
        return;
    }
    tr_i_plan_masks(see, dynamic);
    tr_i_add_see_pass(&see->plan, TR_PASS_SCENE, TR_RULE_SEE_DITHER, see->counts[TR_I_UNITS_ALL],
                      "the whole scene, with holes before targets");
}

static void tr_i_plan_passes(tr_i_see *see, const tr_dynamic *dynamic) {
    switch (dynamic->see) {
    case TR_SEE_DITHER:
        tr_i_plan_dither(see, dynamic);
        break;
    default:
        tr_i_plan_one_mask(see, dynamic);
        break;
    }
}

/* The rectangle of all tiles, and the share of the viewport that they cover. */
static void tr_i_plan_cover(tr_i_see *see, int width, int height) {
    const tr_i_grid *grid = &see->grid;
    int *out = see->plan.rectangle, x1 = 0, y1 = 0, i;
    double area = 0;
    out[0] = width;
    out[1] = height;
    for (i = 0; i < grid->tile_count; ++i) {
        const unsigned char *tile = grid->tiles[i];
        int left = tile[0] * grid->side, low = tile[1] * grid->side, right = tile[2] * grid->side;
        int top = tile[3] * grid->side;
        right = right < width ? right : width;
        top = top < height ? top : height;
        area += (double)(right - left) * (double)(top - low);
        out[0] = out[0] < left ? out[0] : left;
        out[1] = out[1] < low ? out[1] : low;
        x1 = x1 > right ? x1 : right;
        y1 = y1 > top ? y1 : top;
    }
    out[2] = x1 - out[0];
    out[3] = y1 - out[1];
    see->plan.tiles = (uint32_t)grid->tile_count;
    see->plan.covered = (float)(area / ((double)width * (double)height));
}

/* The grid, coarser until there is room for its tiles, and who is in which list. */
static void tr_i_find_units(tr_i_see *see, const tr_dynamic *dynamic, int width, int height) {
    int side = 16, list;
    do {
        tr_i_size_grid(&see->grid, width, height, side);
        tr_i_clear_grid(&see->grid);
        for (list = 0; list < TR_I_UNIT_LISTS; ++list)
            see->counts[list] = 0;
        see->plan.targets = see->plan.targets_in_view = 0;
        tr_i_place_units(see, dynamic, width, height);
        tr_i_find_masks(see, dynamic);
        side = 2 * see->grid.side;
    } while (!tr_i_make_tiles(&see->grid));
    for (see->counts[TR_I_UNITS_ALL] = 0; see->counts[TR_I_UNITS_ALL] < dynamic->unit_count;)
        tr_i_list(see, TR_I_UNITS_ALL, see->counts[TR_I_UNITS_ALL]);
}

/* Whether all that is to be known of targets is where they are: lights, queries and what yields in part ask for more. */
static int tr_i_is_marked(const tr_i_see *see, const tr_dynamic *dynamic) {
    size_t i;
    for (i = 0; i < see->counts[TR_I_UNITS_TARGETS]; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, see->lists[TR_I_UNITS_TARGETS][i]);
        if (tr_unit_code(&unit) >> 24 != 255u || (unit.flags & TR_UNIT_ACTIVE))
            return 1;
    }
    return dynamic->query != 0;
}

/* Whether the scene comes in parts, which asks GL of the target. */
static void tr_i_plan_parts(tr_context *tr, const tr_dynamic *dynamic) {
    tr_i_see *see = &tr->see;
    if (!dynamic->in_parts || dynamic->see == TR_SEE_OFF || see->counts[TR_I_UNITS_TARGETS] == 0)
        return;
    see->marked = tr_i_is_marked(see, dynamic);
    see->plan.parts_why = tr_i_why_whole(tr, dynamic);
    see->plan.in_parts = see->plan.parts_why == 0;
    see->marked = see->marked && see->plan.in_parts;
    see->colored = see->colored && !see->plan.in_parts;
}

static void tr_i_plan_see(tr_context *tr, const tr_dynamic *dynamic, int width, int height) {
    tr_i_see *see = &tr->see;
    see->law = tr_i_law_of(dynamic);
    see->partial = see->marked = 0;
    /* Lights and queries ask for more of a target than fits beside its colour. */
    see->colored = dynamic->see == TR_SEE_ONE_MASK && dynamic->light_count == 0 && !dynamic->query;
    memset(see->units_of, TR_I_UNITS_ALL, sizeof see->units_of);
    memset(&see->plan, 0, sizeof see->plan);
    if (width == 0 || height == 0) {
        see->plan.see = TR_SEE_OFF;
        see->plan.why = "the viewport has no area";
        return;
    }
    tr_i_find_units(see, dynamic, width, height);
    tr_i_plan_parts(tr, dynamic);
    if (see->counts[TR_I_UNITS_TARGETS])
        tr_i_list_units(see, dynamic);
    see->plan.masks = (uint32_t)see->counts[TR_I_UNITS_TARGETS];
    if (dynamic->see == TR_SEE_OFF) {
        tr_i_plan_plain(see, "asked for");
    } else if (see->plan.targets_in_view == 0) {
        tr_i_plan_plain(see, "no target is in view");
    } else if (see->plan.masks == 0) {
        tr_i_plan_plain(see, "nothing that yields may lie before a target");
    } else {
        see->plan.see = dynamic->see;
        see->plan.why = "something that yields may lie before a target";
        tr_i_plan_cover(see, width, height);
        tr_i_plan_passes(see, dynamic);
    }
}

TR_I_API size_t tr_see_plan_print(const tr_see_plan *plan, char *string, size_t capacity) {
    static const char *const names[TR_SEE_COUNT] = {"one mask", "dither", "exact", "sequence", "published", "off"};
    tr_i_text text = tr_i_text_in(string, string ? capacity : 0);
    int i;
    if (!plan)
        return 0;
    tr_i_put(&text, names[plan->see]);
    tr_i_put(&text, ": ");
    tr_i_put(&text, plan->why ? plan->why : "no frame yet");
    tr_i_put(&text, "; ");
    tr_i_put_number(&text, plan->targets);
    tr_i_put(&text, " targets, ");
    tr_i_put_number(&text, plan->targets_in_view);
    tr_i_put(&text, " in view, ");
    tr_i_put_number(&text, plan->masks);
    tr_i_put(&text, " with masks; ");
    tr_i_put_number(&text, plan->tiles);
    tr_i_put(&text, " tiles, ");
    tr_i_put_number(&text, (uint64_t)(plan->covered * 100.0f + 0.5f));
    tr_i_put(&text, " % of the viewport\n");
    if (plan->parts_why) {
        tr_i_put(&text, "not in parts: ");
        tr_i_put(&text, plan->parts_why);
        tr_i_put(&text, "\n");
    }
    for (i = 0; i < plan->pass_count; ++i) {
        const tr_see_pass *pass = &plan->passes[i];
        tr_i_put_number(&text, (uint64_t)i + 1);
        tr_i_put(&text, ". ");
        tr_i_put(&text, tr_pass_kind_name(pass->kind));
        if (pass->unit_count) {
            tr_i_put(&text, " [");
            tr_i_put_number(&text, pass->unit_count);
            tr_i_put(&text, " units]");
        }
        tr_i_put(&text, ": ");
        tr_i_put(&text, pass->why);
        tr_i_put(&text, "\n");
    }
    tr_i_put_number(&text, plan->bytes);
    tr_i_put(&text, " bytes\n");
    return text.length;
}

/* ---- dynamic transparency: the order of painting ---- */

typedef int (*tr_i_before)(const tr_i_rank *ranks, uint32_t a, uint32_t b);

/* By groups, so that members stand together; units on their own as they come. */
static int tr_i_before_in_groups(const tr_i_rank *ranks, uint32_t a, uint32_t b) {
    return ranks[a].group != ranks[b].group ? ranks[a].group < ranks[b].group : a < b;
}

/* Farthest first; of groups equally far that with the lowest id is painted last, and so are ids within a rank. */
static int tr_i_before_in_painting(const tr_i_rank *ranks, uint32_t a, uint32_t b) {
    const tr_i_rank *p = &ranks[a], *q = &ranks[b];
    if (p->backdrop != q->backdrop)
        return p->backdrop > q->backdrop;
    if (p->depth != q->depth)
        return p->depth > q->depth;
    if (p->lowest != q->lowest)
        return p->lowest > q->lowest;
    if (p->rank != q->rank)
        return p->rank < q->rank;
    return p->id != q->id ? p->id > q->id : a > b;
}

/* Nearest to the eye first, where depths are the same: targets, so that nothing coincident hides them; of a group the higher
   rank; the lower id. */
static int tr_i_before_in_ties(const tr_i_rank *ranks, uint32_t a, uint32_t b) {
    const tr_i_rank *p = &ranks[a], *q = &ranks[b];
    if (p->target != q->target)
        return p->target > q->target;
    if (p->lowest != q->lowest)
        return p->lowest < q->lowest;
    if (p->rank != q->rank)
        return p->rank > q->rank;
    return p->id != q->id ? p->id < q->id : a < b;
}

/* Sorting by insertion, as long as that takes few moves: 0 when it took too many. */
static int tr_i_insert_all(const tr_i_rank *ranks, tr_i_before before, uint32_t *order, size_t count) {
    size_t moves = 0, i, at;
    for (i = 1; i < count; ++i) {
        uint32_t item = order[i];
        for (at = i; at > 0 && before(ranks, item, order[at - 1]); --at)
            order[at] = order[at - 1];
        order[at] = item;
        moves += i - at;
        if (moves > 16 * count)
            return 0;
    }
    return 1;
}

static void tr_i_sift_down(const tr_i_rank *ranks, tr_i_before before, uint32_t *heap, size_t root, size_t count) {
    uint32_t item = heap[root];
    size_t child;
    for (; (child = 2 * root + 1) < count; root = child) {
        if (child + 1 < count && before(ranks, heap[child], heap[child + 1]))
            ++child;
        if (!before(ranks, item, heap[child]))
            break;
        heap[root] = heap[child];
    }
    heap[root] = item;
}

/* From the order of the frame before there is little to do; where there is much, by a heap. Both orders are total, so that
   either way the result is one and the same. */
static void tr_i_sort_coherently(const tr_i_rank *ranks, tr_i_before before, uint32_t *order, size_t count) {
    size_t i;
    if (tr_i_insert_all(ranks, before, order, count))
        return;
    for (i = count / 2; i-- > 0;)
        tr_i_sift_down(ranks, before, order, i, count);
    for (i = count; i-- > 1;) {
        uint32_t top = order[0];
        order[0] = order[i];
        order[i] = top;
        tr_i_sift_down(ranks, before, order, 0, i);
    }
}

/* The distance of a unit's middle from the eye along the view. */
static double tr_i_middle(const float view[16], const tr_unit *unit) {
    double depth = -(double)view[14];
    int r;
    for (r = 0; r < 3; ++r)
        depth -= (double)view[4 * r + 2] * (double)unit->center[r];
    return fabs(depth) < TR_I_FARTHEST ? depth : TR_I_FARTHEST; /* NaN compares false */
}

static void tr_i_rank_unit(tr_i_rank *rank, const float view[16], const tr_unit *unit) {
    rank->depth = tr_i_middle(view, unit);
    rank->lowest = rank->id = unit->id;
    rank->group = unit->group;
    rank->backdrop = (unit->flags & TR_UNIT_BACKDROP) != 0;
    rank->rank = unit->rank;
    rank->target = unit->flags & TR_UNIT_TARGET;
}

/* Gives members of a group the mean of their middles, of those that have one, and the lowest id. */
static void tr_i_join_groups(tr_i_rank *ranks, const uint32_t *order, size_t count) {
    size_t first, end, i;
    for (first = 0; first < count; first = end) {
        uint32_t group = ranks[order[first]].group, lowest = UINT32_MAX;
        double sum = 0, members = 0;
        for (end = first; end < count && ranks[order[end]].group == group && (group != 0 || end == first); ++end) {
            const tr_i_rank *rank = &ranks[order[end]];
            lowest = rank->id < lowest ? rank->id : lowest;
            if (rank->depth < TR_I_FARTHEST) {
                sum += rank->depth;
                members += 1;
            }
        }
        for (i = first; i < end; ++i) {
            ranks[order[i]].lowest = lowest;
            ranks[order[i]].depth = members > 0 ? sum / members : TR_I_FARTHEST;
        }
    }
}

/* ---- dynamic transparency: sequences of whole objects ---- */

/* Room for one more; NULL without memory. */
static void *tr_i_push(tr_context *tr, tr_i_array *array, size_t size) {
    if (array->count == array->capacity) {
        size_t capacity = array->capacity + array->capacity / 2 + 64;
        void *items = capacity > SIZE_MAX / size ? 0 : tr->desc.alloc_fn(capacity * size, tr->desc.alloc_user);
        if (!items)
            return 0;
        if (array->items) {
            memcpy(items, array->items, array->count * size);
            tr->desc.free_fn(array->items, tr->desc.alloc_user);
        }
        array->items = items;
        array->capacity = capacity;
    }
    return (char *)array->items + size * array->count++;
}

static int tr_i_boxes_meet(const int a[4], const int b[4]) {
    return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

static void tr_i_grow_box(const int box[4], int by, int width, int height, int out[4]) {
    out[0] = box[0] > by ? box[0] - by : 0;
    out[1] = box[1] > by ? box[1] - by : 0;
    out[2] = box[2] < width - by ? box[2] + by : width;
    out[3] = box[3] < height - by ? box[3] + by : height;
}

/* Orders of as many units as in the frame before are good to start from. */
static int tr_i_fit_orders(tr_context *tr, tr_i_sequence *seq, size_t count) {
    size_t i;
    if (seq->painted.count == count && seq->ranks.count == count)
        return 1;
    seq->ranks.count = seq->by_group.count = seq->painted.count = seq->tied.count = 0;
    for (i = 0; i < count; ++i) {
        uint32_t *a = (uint32_t *)tr_i_push(tr, &seq->by_group, sizeof *a);
        uint32_t *b = (uint32_t *)tr_i_push(tr, &seq->painted, sizeof *b);
        uint32_t *c = (uint32_t *)tr_i_push(tr, &seq->tied, sizeof *c);
        if (!a || !b || !c || !tr_i_push(tr, &seq->ranks, sizeof(tr_i_rank)))
            return 0;
        *a = *b = *c = (uint32_t)i;
    }
    return 1;
}

static int tr_i_order_units(tr_context *tr, tr_i_sequence *seq, const tr_dynamic *dynamic) {
    tr_i_rank *ranks;
    size_t i, count = dynamic->unit_count;
    if (!tr_i_fit_orders(tr, seq, count))
        return 0;
    ranks = (tr_i_rank *)seq->ranks.items;
    for (i = 0; i < count; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        tr_i_rank_unit(&ranks[i], dynamic->view, &unit);
    }
    tr_i_sort_coherently(ranks, tr_i_before_in_groups, (uint32_t *)seq->by_group.items, count);
    tr_i_join_groups(ranks, (const uint32_t *)seq->by_group.items, count);
    if (seq->exact)
        tr_i_sort_coherently(ranks, tr_i_before_in_ties, (uint32_t *)seq->tied.items, count);
    else
        tr_i_sort_coherently(ranks, tr_i_before_in_painting, (uint32_t *)seq->painted.items, count);
    return 1;
}

/* What of the viewport a unit may cover; 0: nothing. */
static int tr_i_box_of(const tr_i_place *places, size_t unit, int box[4]) {
    box[0] = places[unit].x0;
    box[1] = places[unit].y0;
    box[2] = places[unit].x1;
    box[3] = places[unit].y1;
    return box[2] > box[0];
}

/* Whether any mask from the first-th on may reach into a box. */
static int tr_i_meets_masks(const tr_i_sequence *seq, size_t first, const int box[4]) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    size_t i;
    for (i = first; i < seq->masks.count; ++i)
        if (tr_i_boxes_meet(masks[i].reach, box))
            return 1;
    return 0;
}

static void tr_i_list_unit(tr_context *tr, tr_i_sequence *seq, tr_i_array *list, uint32_t unit) {
    uint32_t *at = (uint32_t *)tr_i_push(tr, list, sizeof *at);
    if (at)
        *at = unit;
    else
        seq->no_memory = 1;
}

static tr_i_item *tr_i_add_item(tr_context *tr, tr_i_sequence *seq, uint32_t first, uint32_t count) {
    tr_i_item *item = (tr_i_item *)tr_i_push(tr, &seq->items, sizeof *item);
    seq->open = 0;
    if (!item) {
        seq->no_memory = 1;
        return 0;
    }
    memset(item, 0, sizeof *item);
    item->first = first;
    item->count = count;
    return item;
}

/* The masks of all targets painted so far are drawn now. */
static void tr_i_flush_masks(tr_context *tr, tr_i_sequence *seq) {
    uint32_t count = (uint32_t)seq->masks.count - seq->pending;
    tr_i_item *item = count ? tr_i_add_item(tr, seq, seq->pending, count) : 0;
    if (item)
        item->masks = 1;
    seq->pending = (uint32_t)seq->masks.count;
}

/* Whether a unit may be painted along with those of the last item: nothing of one may cover anything of another. */
static int tr_i_joins_item(const tr_i_sequence *seq, const tr_i_place *places, const int box[4], int hollow) {
    const tr_i_item *item;
    const uint32_t *list = (const uint32_t *)seq->list.items;
    uint32_t i;
    int other[4];
    if (!seq->open)
        return 0;
    item = (const tr_i_item *)seq->items.items + seq->items.count - 1;
    if (item->hollow != hollow || item->count == TR_I_RUN)
        return 0;
    for (i = 0; i < item->count; ++i)
        if (tr_i_box_of(places, list[item->first + i], other) && tr_i_boxes_meet(other, box))
            return 0;
    return 1;
}

/* Paints a unit that masks may make transparent. */
static void tr_i_paint(tr_context *tr, tr_i_sequence *seq, const tr_i_place *places, uint32_t unit, int hollow,
                       const int box[4]) {
    if (tr_i_joins_item(seq, places, box, hollow)) {
        ++((tr_i_item *)seq->items.items + seq->items.count - 1)->count;
    } else {
        tr_i_item *item = tr_i_add_item(tr, seq, (uint32_t)seq->list.count, 1);
        if (item)
            item->hollow = (unsigned char)hollow;
        seq->open = item != 0;
    }
    tr_i_list_unit(tr, seq, &seq->list, unit);
}

/* By how many pixels circle or ellipse of a target may go beyond its rectangle: a circle's radius is half its diagonal, an
   ellipse is sqrt(2) times as large at most. */
static int tr_i_form_of(const tr_i_sequence *seq, const int core[4]) {
    int across = core[2] - core[0], up = core[3] - core[1], most = across > up ? across : up;
    return seq->shape == TR_MASK_CIRCLE ? most * 3 / 4 + 1 : seq->shape == TR_MASK_ELLIPSE ? most / 4 + 1 : 0;
}

static tr_i_mask *tr_i_push_mask(tr_context *tr, tr_i_sequence *seq, const tr_unit *unit, uint32_t index,
                                 const int core[4], const int size[2]) {
    tr_i_mask *mask = (tr_i_mask *)tr_i_push(tr, &seq->masks, sizeof *mask);
    if (!mask) {
        seq->no_memory = 1;
        return 0;
    }
    memset(mask, 0, sizeof *mask);
    mask->unit = index;
    mask->strength = 1.0f - tr_i_fade_of(unit);
    mask->importance = tr_i_importance_of(unit);
    mask->active = unit->flags & TR_UNIT_ACTIVE ? 1.0f : 0.0f;
    mask->id = (float)unit->id;
    mask->form = tr_i_form_of(seq, core);
    tr_i_grow_box(core, seq->reach + mask->form, size[0], size[1], mask->reach);
    tr_i_grow_box(core, seq->grow + mask->form, size[0], size[1], mask->box);
    return mask;
}

/* A target has been painted: its mask waits for the first that it may make transparent. Those that wait do not overlap,
   so that one run of passes draws them all. */
static void tr_i_add_mask(tr_context *tr, tr_i_sequence *seq, const tr_unit *unit, uint32_t index, const int core[4],
                          const int size[2]) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    int box[4];
    size_t i;
    tr_i_grow_box(core, seq->grow + tr_i_form_of(seq, core), size[0], size[1], box);
    for (i = seq->pending; i < seq->masks.count && !tr_i_boxes_meet(masks[i].box, box);)
        ++i;
    if (i < seq->masks.count || seq->masks.count - seq->pending == TR_I_RUN)
        tr_i_flush_masks(tr, seq);
    tr_i_push_mask(tr, seq, unit, index, core, size);
}

static int tr_i_seq_yields(const tr_unit *unit) {
    if (unit->flags & (TR_UNIT_IMPENETRABLE | TR_UNIT_BACKDROP))
        return 0;
    return (unit->flags & TR_UNIT_TARGET) || tr_i_importance_of(unit) < 1.0f;
}

/* Whether a target's mask may act on anything that is painted after it. */
static int tr_i_is_covered(const tr_i_sequence *seq, const tr_dynamic *dynamic, const tr_i_place *places, size_t at) {
    const uint32_t *order = (const uint32_t *)seq->painted.items;
    int core[4], reach[4], box[4];
    size_t i;
    tr_i_box_of(places, order[at], core);
    /* Of the viewport's edges nothing depends here. */
    tr_i_grow_box(core, seq->reach + tr_i_form_of(seq, core), 0xffff, 0xffff, reach);
    for (i = at + 1; i < dynamic->unit_count; ++i) {
        tr_unit unit;
        if (!tr_i_box_of(places, order[i], box) || !tr_i_boxes_meet(box, reach))
            continue;
        unit = tr_i_unit_at(dynamic, order[i]);
        if (tr_i_seq_yields(&unit))
            return 1;
    }
    return 0;
}

/* One unit in the order of painting. What no mask may make transparent is painted with the scene, in any order. */
static void tr_i_arrange_unit(tr_context *tr, const tr_dynamic *dynamic, size_t at, const int size[2]) {
    tr_i_sequence *seq = &tr->seq;
    const tr_i_place *places = tr->see.places;
    uint32_t index = ((const uint32_t *)seq->painted.items)[at];
    tr_unit unit = tr_i_unit_at(dynamic, index);
    int box[4];
    if (!tr_i_box_of(places, index, box)) {
        tr_i_list_unit(tr, seq, &seq->scene, index);
        return;
    }
    if (!tr_i_meets_masks(seq, 0, box)) {
        tr_i_list_unit(tr, seq, &seq->scene, index);
    } else {
        if (tr_i_seq_yields(&unit) && tr_i_meets_masks(seq, seq->pending, box))
            tr_i_flush_masks(tr, seq);
        tr_i_paint(tr, seq, places, index, (unit.flags & TR_UNIT_HOLLOW) != 0, box);
    }
    if ((unit.flags & TR_UNIT_TARGET) && tr_i_opens(dynamic, &unit, &places[index], seq->reach) &&
        tr_i_is_covered(seq, dynamic, places, at))
        tr_i_add_mask(tr, seq, &unit, index, box, size);
}

/* Who is painted when, and which masks are drawn when. */
static void tr_i_arrange_units(tr_context *tr, const tr_dynamic *dynamic, const int size[2]) {
    tr_i_sequence *seq = &tr->seq;
    size_t at;
    seq->list.count = seq->scene.count = seq->masks.count = seq->items.count = 0;
    seq->pending = 0;
    seq->open = seq->no_memory = 0;
    for (at = 0; at < dynamic->unit_count && !seq->no_memory; ++at)
        tr_i_arrange_unit(tr, dynamic, at, size);
}

/* ---- dynamic transparency: layers within masks ---- */

/* Whether anything that yields may lie before a target, where its mask may be. */
static int tr_i_is_behind(const tr_i_sequence *seq, const tr_dynamic *dynamic, const tr_i_place *places,
                          size_t target) {
    int core[4], reach[4], box[4];
    size_t i;
    if (!tr_i_box_of(places, target, core))
        return 0;
    tr_i_grow_box(core, seq->reach + tr_i_form_of(seq, core), 0xffff, 0xffff, reach);
    for (i = 0; i < dynamic->unit_count; ++i) {
        tr_unit unit;
        if (i == target || !tr_i_box_of(places, i, box) || !tr_i_boxes_meet(box, reach) ||
            !(places[i].first < places[target].last))
            continue;
        unit = tr_i_unit_at(dynamic, i);
        if (tr_i_seq_yields(&unit))
            return 1;
    }
    return 0;
}

/* The first run that a mask may be drawn in: with masks that it does not overlap. */
static uint32_t tr_i_find_run(const tr_i_sequence *seq, size_t index) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    uint32_t run = 0;
    size_t i, members = 0;
    for (i = 0; i < index;) {
        int meets = masks[i].run == run && tr_i_boxes_meet(masks[i].box, masks[index].box);
        members += masks[i].run == run;
        ++i;
        if (meets || members == TR_I_RUN) {
            ++run;
            i = members = 0;
        }
    }
    return run;
}

/* How many layers may lie before the farthest target of a mask or of one that overlaps it: by bounds, so more than do. Of a
   hollow unit four are allowed for. */
static int tr_i_bound_layers(const tr_i_sequence *seq, const tr_dynamic *dynamic, const tr_i_place *places,
                             size_t index, int most) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    float last = places[masks[index].unit].last;
    int layers = 0, box[4];
    size_t i;
    for (i = 0; i < seq->masks.count; ++i)
        if (places[masks[i].unit].last > last && tr_i_boxes_meet(masks[i].reach, masks[index].reach))
            last = places[masks[i].unit].last;
    for (i = 0; i < dynamic->unit_count && layers < most; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        if (i == masks[index].unit || !tr_i_box_of(places, i, box) || !tr_i_boxes_meet(box, masks[index].reach) ||
            !(places[i].first < last))
            continue;
        layers += unit.flags & TR_UNIT_HOLLOW ? 4 : 1;
    }
    return layers;
}

/* Whether some layer within masks stays opaque for another reason than layer control: occluders behind it are not seen, but
   share a mask all the same. */
static int tr_i_some_stay(const tr_i_sequence *seq, const tr_dynamic *dynamic, const tr_i_place *places) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    float least = 1.0f;
    size_t i, k;
    int box[4];
    for (i = 0; i < seq->masks.count; ++i)
        least = masks[i].importance < least ? masks[i].importance : least;
    for (i = 0; i < dynamic->unit_count; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        if (!tr_i_box_of(places, i, box) || !tr_i_meets_masks(seq, 0, box))
            continue;
        for (k = 0; k < seq->masks.count && masks[k].unit != i;)
            ++k;
        if (k == seq->masks.count && ((unit.flags & (TR_UNIT_TARGET | TR_UNIT_IMPENETRABLE | TR_UNIT_BACKDROP)) ||
                                      tr_i_importance_of(&unit) >= least))
            return 1;
    }
    return 0;
}

/* How many layers to peel. The last place is for what ends a pixel; layer control of masks that do not overlap needs no
   more than it lets through and the one that stays. */
static void tr_i_count_layers(tr_i_sequence *seq, const tr_dynamic *dynamic, const tr_i_place *places) {
    int bound = 0, most = 4 * TR_I_SEQ_LAYERS;
    size_t i;
    for (i = 0; i < seq->masks.count; ++i) {
        int layers = tr_i_bound_layers(seq, dynamic, places, i, most);
        bound = layers > bound ? layers : bound;
    }
    seq->layer_bound = bound + 1;
    seq->peeled = bound < TR_I_SEQ_LAYERS ? bound + 1 : TR_I_SEQ_LAYERS;
    seq->whole = 1;
    if (seq->layers > 0 && seq->runs == 1 && seq->layers < seq->peeled &&
        (seq->each || !tr_i_some_stay(seq, dynamic, places))) {
        seq->layer_bound = seq->peeled = seq->layers + 1;
        seq->whole = 0;
    }
}

/* Masks of targets that something may lie before, in as few runs as come of taking the first that will do. */
static void tr_i_arrange_masks(tr_context *tr, const tr_dynamic *dynamic, const int size[2]) {
    tr_i_sequence *seq = &tr->seq;
    const tr_i_place *places = tr->see.places;
    size_t i;
    seq->list.count = seq->scene.count = seq->masks.count = seq->items.count = 0;
    seq->no_memory = 0;
    seq->runs = 0;
    for (i = 0; i < dynamic->unit_count && !seq->no_memory; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        tr_i_mask *mask;
        int core[4];
        tr_i_list_unit(tr, seq, &seq->scene, (uint32_t)i);
        if (!(unit.flags & TR_UNIT_TARGET) || !tr_i_opens(dynamic, &unit, &places[i], seq->reach) ||
            !tr_i_is_behind(seq, dynamic, places, i))
            continue;
        tr_i_box_of(places, i, core);
        mask = tr_i_push_mask(tr, seq, &unit, (uint32_t)i, core, size);
        if (!mask)
            return;
        mask->run = tr_i_find_run(seq, seq->masks.count - 1);
        seq->runs = mask->run >= seq->runs ? mask->run + 1 : seq->runs;
    }
    seq->pending = (uint32_t)seq->masks.count;
    tr_i_count_layers(seq, dynamic, places);
}

/* Runs in one piece each. */
static void tr_i_sort_masks(tr_context *tr) {
    tr_i_sequence *seq = &tr->seq;
    tr_i_mask *masks = (tr_i_mask *)seq->masks.items;
    size_t first = 0, i, end;
    uint32_t run;
    for (run = 0; run < seq->runs; ++run) {
        tr_i_item *item;
        for (i = end = first; i < seq->masks.count; ++i)
            if (masks[i].run == run) {
                tr_i_mask kept = masks[i];
                masks[i] = masks[end];
                masks[end++] = kept;
            }
        item = tr_i_add_item(tr, seq, (uint32_t)first, (uint32_t)(end - first));
        if (item)
            item->masks = 1;
        first = end;
    }
}

/* ---- dynamic transparency: the steps of a sequence ---- */

static tr_i_step *tr_i_add_step(tr_context *tr, tr_pass_kind kind, tr_rule rule, size_t first, size_t count) {
    tr_i_step *step = (tr_i_step *)tr_i_push(tr, &tr->seq.steps, sizeof *step);
    if (!step) {
        tr->seq.no_memory = 1;
        step = &tr->seq.lost;
    }
    memset(step, 0, sizeof *step);
    step->kind = (uint8_t)kind;
    step->rule = (uint8_t)rule;
    step->first = (uint32_t)first;
    step->count = (uint32_t)count;
    return step;
}

/* Lists the units of a class that meet any mask, and returns how many. */
static size_t tr_i_list_meeting(tr_context *tr, const tr_dynamic *dynamic, const tr_i_array *from, int closing) {
    tr_i_sequence *seq = &tr->seq;
    size_t i, first = seq->list.count, count = from->count;
    for (i = 0; i < count; ++i) {
        uint32_t index = ((const uint32_t *)from->items)[i];
        tr_unit unit = tr_i_unit_at(dynamic, index);
        int box[4];
        if ((!closing || (unit.flags & (TR_UNIT_IMPENETRABLE | TR_UNIT_BACKDROP))) &&
            tr_i_box_of(tr->see.places, index, box) && tr_i_meets_masks(seq, 0, box))
            tr_i_list_unit(tr, seq, &seq->list, index);
    }
    return seq->list.count - first;
}

/* The targets of a run of masks: where they are open, and how far every pixel is from them. */
static void tr_i_add_distances(tr_context *tr, const tr_i_item *item, uint32_t block, int has_block) {
    tr_i_sequence *seq = &tr->seq;
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    tr_rule rule = has_block || seq->exact ? TR_RULE_SEE_SEED : TR_RULE_SEE_DEPTH;
    size_t units = seq->list.count;
    uint32_t i;
    for (i = 0; i < item->count; ++i)
        tr_i_list_unit(tr, seq, &seq->list, masks[item->first + i].unit);
    tr_i_add_step(tr, TR_PASS_WIPE, TR_RULE_SEE_PLAIN, 0, item->count)->block = block;
    tr_i_add_step(tr, TR_PASS_SEEDS, rule, units, item->count);
    tr_i_add_step(tr, TR_PASS_ROWS, TR_RULE_SEE_PLAIN, 0, item->count)->block = block;
    tr_i_add_step(tr, TR_PASS_NEAREST, TR_RULE_SEE_PLAIN, 0, item->count)->block = block;
    if (seq->shape == TR_MASK_OUTLINE)
        return;
    tr_i_add_step(tr, TR_PASS_EXTENTS, TR_RULE_SEE_PLAIN, 0, 0)->block = block;
    tr_i_add_step(tr, TR_PASS_FORMS, TR_RULE_SEE_PLAIN, 0, 0)->block = block;
}

/* And what follows from that. */
static void tr_i_add_run(tr_context *tr, const tr_i_item *item, uint32_t block, int has_block) {
    tr_i_step *step;
    tr_i_add_distances(tr, item, block, has_block);
    step = tr_i_add_step(tr, TR_PASS_MASKS, TR_RULE_SEE_PLAIN, 0, item->count);
    step->block = block;
    step->clear = block == 0;
}

/* The units of an item: solids by their front-most surfaces, which depth finds first; hollow ones surface by surface, as
   the host sorts them. */
static void tr_i_add_painting(tr_context *tr, const tr_i_item *item, int counting) {
    int counted = tr->seq.counted, hollow = item->hollow, i;
    for (i = 0; i < 3; ++i) {
        /* A hollow unit is counted before it is painted: afterwards its own depth would hide all but its nearest. */
        static const tr_pass_kind solid[3] = {TR_PASS_PAINT_DEPTH, TR_PASS_PAINT, TR_PASS_COUNT};
        static const tr_pass_kind surfaces[3] = {TR_PASS_PAINT_DEPTH, TR_PASS_COUNT, TR_PASS_PAINT};
        tr_pass_kind kind = hollow ? surfaces[i] : solid[i];
        tr_i_step *step;
        if ((kind == TR_PASS_PAINT_DEPTH && hollow) || (kind == TR_PASS_COUNT && !counted) ||
            (kind == TR_PASS_PAINT && counting))
            continue;
        step = tr_i_add_step(tr, kind,
                             kind == TR_PASS_PAINT_DEPTH ? TR_RULE_SEE_DEPTH
                             : kind == TR_PASS_COUNT     ? TR_RULE_SEE_COUNT
                             : tr->seq.layers            ? TR_RULE_SEE_BLEND_LAYERS
                                                         : TR_RULE_SEE_BLEND,
                             item->first, item->count);
        step->own = (uint8_t)counted;
        step->hollow = (uint8_t)hollow;
        step->subtract = (uint8_t)!counting;
    }
}

/* What is painted with the scene and may hide what is painted later, into our own depth. */
static void tr_i_add_priming(tr_context *tr, size_t first, size_t count, int counting) {
    tr_i_step *step = tr_i_add_step(tr, TR_PASS_PAINT_DEPTH, TR_RULE_SEE_DEPTH, first, count);
    step->own = 1;
    step->clear = 1;
    step->subtract = (uint8_t)!counting;
}

static void tr_i_add_sweep(tr_context *tr, int counting, int has_block) {
    tr_i_sequence *seq = &tr->seq;
    uint32_t block = 0;
    size_t i;
    for (i = 0; i < seq->items.count; ++i) {
        tr_i_item item = ((const tr_i_item *)seq->items.items)[i];
        if (!item.masks)
            tr_i_add_painting(tr, &item, counting);
        else if (!counting) {
            tr_i_add_run(tr, &item, block, has_block);
            ++block;
        }
    }
}

/* All passes of TR_SEE_SEQUENCE and TR_SEE_PUBLISHED, from the items. */
static void tr_i_add_steps(tr_context *tr, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    size_t first = seq->list.count, blocks = 0, primed = 0;
    seq->steps.count = 0;
    tr_i_add_step(tr, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, 0, seq->scene.count);
    if (!seq->published)
        blocks = tr_i_list_meeting(tr, dynamic, &seq->painted, 1);
    if (blocks)
        tr_i_add_step(tr, TR_PASS_BLOCK, TR_RULE_SEE_DEPTH, first, blocks)->clear = 1;
    seq->has_block = blocks != 0;
    first = seq->list.count;
    if (seq->counted) {
        primed = tr_i_list_meeting(tr, dynamic, &seq->scene, 0);
        tr_i_add_priming(tr, first, primed, 1);
        tr_i_add_sweep(tr, 1, blocks != 0);
        tr_i_add_priming(tr, first, primed, 0);
    }
    tr_i_add_sweep(tr, 0, blocks != 0);
    if (seq->counted)
        tr_i_add_step(tr, TR_PASS_PAINT_OVER, TR_RULE_SEE_PLAIN, 0, 0)->clear = 0;
}

/* ---- dynamic transparency: bad input ---- */

static const char *tr_i_check_law(const tr_dynamic *dynamic) {
    const float numbers[3] = {dynamic->alpha_target, dynamic->alpha_start, dynamic->width};
    int divisor = dynamic->mask_divisor;
    if ((unsigned)dynamic->see >= (unsigned)TR_SEE_COUNT || (unsigned)dynamic->shape > (unsigned)TR_MASK_HULL ||
        (unsigned)dynamic->combine > (unsigned)TR_MASK_PRODUCT ||
        (unsigned)dynamic->occluders > (unsigned)TR_OCCLUDERS_EACH)
        return "dynamic.see, shape, combine or occluders";
    if (!tr_i_all_finite(numbers, 3) || dynamic->alpha_target > 1.0f || dynamic->alpha_start > 1.0f ||
        dynamic->width > (float)TR_MAX_MASK_WIDTH)
        return "dynamic.alpha_target, alpha_start or width";
    if (divisor != 0 && divisor != 1 && divisor != 2 && divisor != 4 && divisor != 8)
        return "dynamic.mask_divisor is none of 1, 2, 4, 8";
    if (dynamic->layers < 0)
        return "dynamic.layers is negative";
    if (!tr_i_all_finite(dynamic->view, 16) || !tr_i_all_finite(dynamic->projection, 16) ||
        !tr_i_all_finite(dynamic->background, 3))
        return "dynamic.view, projection or background is not finite";
    return 0;
}

/* Rungs that keep masks target by target. */
static int tr_i_is_sequence(tr_see see) {
    return see == TR_SEE_EXACT || see == TR_SEE_SEQUENCE || see == TR_SEE_PUBLISHED;
}

/* TR_SEE_EXACT tells units apart by their ids. */
static int tr_i_ids_differ(const tr_dynamic *dynamic) {
    unsigned char seen[(TR_I_MAX_UNIT_ID + 1) / 8];
    size_t i;
    memset(seen, 0, sizeof seen);
    for (i = 0; i < dynamic->unit_count; ++i) {
        uint32_t id = tr_i_unit_at(dynamic, i).id & TR_I_MAX_UNIT_ID;
        unsigned char bit = (unsigned char)(1u << (id & 7u));
        if (seen[id >> 3] & bit)
            return 0;
        seen[id >> 3] |= bit;
    }
    return 1;
}

/* What the rung cannot do. */
static const char *tr_i_check_rung(const tr_dynamic *dynamic) {
    int one_mask = dynamic->see == TR_SEE_ONE_MASK, dither = dynamic->see == TR_SEE_DITHER;
    if (dynamic->shape != TR_MASK_OUTLINE && !tr_i_is_sequence(dynamic->see))
        return "dynamic.shape: one mask for all targets has their outlines";
    if ((one_mask || dither) && dynamic->combine != TR_MASK_MIN)
        return "dynamic.combine: one mask for all targets is the least of theirs";
    if (one_mask && dynamic->occluders != TR_OCCLUDERS_TOGETHER)
        return "dynamic.occluders: TR_SEE_ONE_MASK sees them together";
    if ((one_mask || dither) && dynamic->layers != 0)
        return "dynamic.layers: one mask knows no layers";
    if (dynamic->query && tr_i_is_sequence(dynamic->see))
        return "dynamic.query: TR_SEE_ONE_MASK and TR_SEE_DITHER count what is hidden";
    return 0;
}

static const char *tr_i_check_lights(const tr_dynamic *dynamic) {
    size_t i;
    if (dynamic->light_count > TR_MAX_LIGHTS || (dynamic->light_count && !dynamic->lights))
        return "dynamic.lights is NULL, or light_count above TR_MAX_LIGHTS";
    for (i = 0; i < dynamic->light_count; ++i) {
        const tr_light *light = &dynamic->lights[i];
        const float numbers[4] = {light->x, light->y, light->radius, light->edge};
        if (!tr_i_all_finite(numbers, 4) || light->radius < 0.0f || light->edge < 0.0f)
            return "dynamic.lights: a number is not finite, or a radius or edge negative";
    }
    return 0;
}

static const char *tr_i_check_units(const tr_dynamic *dynamic) {
    unsigned char seen[(TR_I_MAX_UNIT_ID + 1) / 8];
    size_t i;
    if (dynamic->unit_count && !dynamic->units)
        return "dynamic.units is NULL";
    if ((dynamic->unit_stride && dynamic->unit_stride < sizeof(tr_unit)) || dynamic->unit_count > 0x7fffffffu)
        return "dynamic.unit_stride or unit_count";
    memset(seen, 0, sizeof seen);
    for (i = 0; i < dynamic->unit_count; ++i) {
        tr_unit unit = tr_i_unit_at(dynamic, i);
        unsigned char bit = (unsigned char)(1u << (unit.id & 7u));
        if (unit.id > TR_I_MAX_UNIT_ID || (unit.flags & ~TR_I_UNIT_FLAGS))
            return "dynamic.units: an id or flags out of range";
        if (!(unit.flags & TR_UNIT_TARGET))
            continue;
        if (unit.flags & TR_UNIT_BACKDROP)
            return "dynamic.units: a target cannot be a backdrop";
        if (unit.id == 0 || (seen[unit.id >> 3] & bit))
            return "dynamic.units: the id of a target is 0, or another one's";
        seen[unit.id >> 3] |= bit;
    }
    return 0;
}

/* ---- state: saved, set, restored -------------------------------------------------------------------------------- */

/* Switches that every pass wants off, with the first version that has them (0: never). Those that passes set come last. */
typedef struct tr_i_cap {
    tr_i_u name;
    int desktop, es;
} tr_i_cap;

static const tr_i_cap tr_i_caps[TR_I_CAP_COUNT] = {
    {TR_I_GL_STENCIL_TEST, 330, 300},
    {TR_I_GL_SCISSOR_TEST, 330, 300},
    {TR_I_GL_DITHER, 330, 300},
    {TR_I_GL_POLYGON_OFFSET_FILL, 330, 300},
    {TR_I_GL_POLYGON_OFFSET_LINE, 330, 0}, /* not only for lines: Mesa 22 offsets clipped polygons by it */
    {TR_I_GL_POLYGON_OFFSET_POINT, 330, 0},
    {TR_I_GL_SAMPLE_ALPHA_TO_COVERAGE, 330, 300},
    {TR_I_GL_SAMPLE_COVERAGE, 330, 300},
    {TR_I_GL_RASTERIZER_DISCARD, 330, 300},
    {TR_I_GL_COLOR_LOGIC_OP, 330, 0},
    {TR_I_GL_DEPTH_CLAMP, 330, 0},
    {TR_I_GL_SAMPLE_MASK, 330, 310},
    {TR_I_GL_FRAMEBUFFER_SRGB, 330, 0}, /* see tr_i_has_cap */
    {TR_I_GL_DEPTH_TEST, 330, 300},
    {TR_I_GL_CULL_FACE, 330, 300},
};
#define TR_I_CAPS_OFF 12

static int tr_i_has_cap(const tr_context *tr, int index) {
    int since = tr->es ? tr_i_caps[index].es : tr_i_caps[index].desktop;
    /* Without the wish the host's choice of encoding stays in force; our own textures do not care. */
    if (tr_i_caps[index].name == TR_I_GL_FRAMEBUFFER_SRGB && !(tr->frame.wishes.options & TR_WISH_SRGB))
        return 0;
    return since != 0 && tr->version >= since;
}

static void tr_i_switch(const tr_context *tr, tr_i_u cap, int on) {
    if (on)
        tr->gl.Enable(cap);
    else
        tr->gl.Disable(cap);
}

static void tr_i_set_viewport(const tr_context *tr, float x, float y, float width, float height) {
    if (tr->has_viewports)
        tr->gl.ViewportIndexedf(0, x, y, width, height);
    else
        tr->gl.Viewport((int32_t)x, (int32_t)y, (int32_t)width, (int32_t)height);
}

static void tr_i_set_depth_range(const tr_context *tr, double first, double last) {
    if (tr->has_viewports)
        tr->gl.DepthRangeIndexed(0, first, last);
    else if (tr->es)
        tr->gl.DepthRangef((float)first, (float)last);
    else
        tr->gl.DepthRange(first, last);
}

static void tr_i_save_viewport(const tr_context *tr, tr_i_snapshot *saved) {
    const tr_i_gl *gl = &tr->gl;
    int32_t viewport[4];
    float range[2];
    int i;
    if (tr->has_viewports) {
        gl->GetFloati_v(TR_I_GL_VIEWPORT, 0, saved->viewport);
        gl->GetDoublei_v(TR_I_GL_DEPTH_RANGE, 0, saved->depth_range);
        /* Switched off for all viewports: Mesa 22 lets the scissor of another one cut what is drawn into the first. */
        for (i = 0; i < tr->viewports; ++i)
            saved->scissors[i] = gl->IsEnabledi(TR_I_GL_SCISSOR_TEST, (tr_i_u)i);
        return;
    }
    gl->GetIntegerv(TR_I_GL_VIEWPORT, viewport);
    for (i = 0; i < 4; ++i)
        saved->viewport[i] = (float)viewport[i];
    if (!tr->es) {
        gl->GetDoublev(TR_I_GL_DEPTH_RANGE, saved->depth_range);
        return;
    }
    gl->GetFloatv(TR_I_GL_DEPTH_RANGE, range);
    saved->depth_range[0] = (double)range[0];
    saved->depth_range[1] = (double)range[1];
}

static void tr_i_save_blend(const tr_context *tr, tr_i_snapshot *saved) {
    static const tr_i_u names[6] = {TR_I_GL_BLEND_SRC_RGB,   TR_I_GL_BLEND_DST_RGB,      TR_I_GL_BLEND_SRC_ALPHA,
                                    TR_I_GL_BLEND_DST_ALPHA, TR_I_GL_BLEND_EQUATION_RGB, TR_I_GL_BLEND_EQUATION_ALPHA};
    int i;
    for (i = 0; i < 6; ++i) {
        int32_t *value = i < 4 ? &saved->blend_func[i] : &saved->blend_equation[i - 4];
        if (tr->has_indexed_blend)
            tr->gl.GetIntegeri_v(names[i], 0, value);
        else
            tr->gl.GetIntegerv(names[i], value);
    }
    for (i = 0; i < 2; ++i)
        saved->blends[i] =
            tr->has_indexed ? tr->gl.IsEnabledi(TR_I_GL_BLEND, (tr_i_u)i) : tr->gl.IsEnabled(TR_I_GL_BLEND);
    for (i = 0; i < tr->draw_buffers; ++i) {
        if (tr->has_indexed)
            tr->gl.GetBooleani_v(TR_I_GL_COLOR_WRITEMASK, (tr_i_u)i, saved->color_masks[i]);
        else
            tr->gl.GetBooleanv(TR_I_GL_COLOR_WRITEMASK, saved->color_masks[i]);
    }
}

/* Whether frames of this one's wishes bind an array of edges, to the unit after those that they all bind. */
static int tr_i_reads_edges(const tr_context *tr, int index) {
    tr_alpha alpha = tr->frame.wishes.alpha;
    return alpha == TR_ALPHA_CANDIDATES || (alpha >= TR_ALPHA_EXACT && index == TR_I_EDGE_SEGMENTS);
}

static void tr_i_save_bindings(const tr_context *tr, tr_i_snapshot *saved) {
    const tr_i_gl *gl = &tr->gl;
    tr_i_u binding = (tr_i_u)tr->desc.uniform_binding;
    int i;
    gl->GetIntegerv(TR_I_GL_CURRENT_PROGRAM, &saved->program);
    gl->GetIntegerv(TR_I_GL_VERTEX_ARRAY_BINDING, &saved->vertex_array);
    gl->GetIntegerv(TR_I_GL_DRAW_FRAMEBUFFER_BINDING, &saved->draw_framebuffer);
    gl->GetIntegerv(TR_I_GL_READ_FRAMEBUFFER_BINDING, &saved->read_framebuffer);
    gl->GetIntegerv(TR_I_GL_UNIFORM_BUFFER_BINDING, &saved->uniform_buffer);
    gl->GetIntegerv(TR_I_GL_COPY_WRITE_BUFFER_BINDING, &saved->copy_buffer);
    gl->GetIntegerv(TR_I_GL_PIXEL_UNPACK_BUFFER_BINDING, &saved->unpack_buffer);
    gl->GetIntegeri_v(TR_I_GL_UNIFORM_BUFFER_BINDING, binding, &saved->indexed_buffer);
    gl->GetInteger64i_v(TR_I_GL_UNIFORM_BUFFER_START, binding, &saved->indexed_start);
    gl->GetInteger64i_v(TR_I_GL_UNIFORM_BUFFER_SIZE, binding, &saved->indexed_size);
    gl->GetIntegerv(TR_I_GL_ACTIVE_TEXTURE, &saved->active_texture);
    for (i = 0; i < TR_TEXTURE_UNITS; ++i) {
        gl->ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + i));
        gl->GetIntegerv(tr_i_targets[i] == TR_I_GL_TEXTURE_2D ? TR_I_GL_TEXTURE_BINDING_2D
                                                              : TR_I_GL_TEXTURE_BINDING_2D_ARRAY,
                        &saved->textures[i]);
        gl->GetIntegerv(TR_I_GL_SAMPLER_BINDING, &saved->samplers[i]);
    }
    for (i = 0; i < TR_I_EDGE_TEXTURE_COUNT && tr_i_reads_edges(tr, i); ++i) {
        gl->ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + TR_TEXTURE_UNITS + i));
        gl->GetIntegerv(TR_I_GL_TEXTURE_BINDING_2D, &saved->edge_textures[i]);
        gl->GetIntegerv(TR_I_GL_SAMPLER_BINDING, &saved->edge_samplers[i]);
    }
    gl->ActiveTexture((tr_i_u)saved->active_texture);
}

static void tr_i_save_scissor(const tr_context *tr, tr_i_snapshot *saved) {
    if (tr->has_viewports)
        tr->gl.GetIntegeri_v(TR_I_GL_SCISSOR_BOX, 0, saved->scissor);
    else
        tr->gl.GetIntegerv(TR_I_GL_SCISSOR_BOX, saved->scissor);
}

/* Of the first viewport: Mesa 22 lets the scissors of others cut what is drawn into that. */
static void tr_i_set_scissor(const tr_context *tr, const int32_t box[4], int on) {
    if (tr->has_viewports) {
        tr->gl.ScissorIndexed(0, box[0], box[1], box[2], box[3]);
        if (on)
            tr->gl.Enablei(TR_I_GL_SCISSOR_TEST, 0);
        return;
    }
    tr->gl.Scissor(box[0], box[1], box[2], box[3]);
    if (on)
        tr->gl.Enable(TR_I_GL_SCISSOR_TEST);
}

static void tr_i_save(const tr_context *tr, tr_i_snapshot *saved) {
    const tr_i_gl *gl = &tr->gl;
    int i;
    memset(saved, 0, sizeof *saved);
    tr_i_save_bindings(tr, saved);
    tr_i_save_blend(tr, saved);
    for (i = 0; i < TR_I_CAP_COUNT; ++i)
        if (tr_i_has_cap(tr, i))
            saved->caps[i] = gl->IsEnabled(tr_i_caps[i].name);
    for (i = 0; i < tr->clip_distances; ++i)
        saved->clip_distances[i] = gl->IsEnabled(TR_I_GL_CLIP_DISTANCE0 + (tr_i_u)i);
    tr_i_save_viewport(tr, saved);
    if (tr->see.active)
        tr_i_save_scissor(tr, saved);
    gl->GetBooleanv(TR_I_GL_DEPTH_WRITEMASK, &saved->depth_mask);
    gl->GetIntegerv(TR_I_GL_DEPTH_FUNC, &saved->depth_func);
    gl->GetIntegerv(TR_I_GL_CULL_FACE_MODE, &saved->cull_mode);
    gl->GetIntegerv(TR_I_GL_FRONT_FACE, &saved->front_face);
    if (!tr->es)
        gl->GetIntegerv(TR_I_GL_POLYGON_MODE, saved->polygon_mode);
}

/* What a fresh context would have saved, for TR_STATE_LEAVE_DEFAULTS; the viewport stays what it was. */
static void tr_i_save_defaults(tr_i_snapshot *saved) {
    float viewport[4];
    int32_t scissor[4];
    memcpy(viewport, saved->viewport, sizeof viewport);
    memcpy(scissor, saved->scissor, sizeof scissor);
    memset(saved, 0, sizeof *saved);
    memcpy(saved->scissor, scissor, sizeof scissor);
    memset(saved->color_masks, 1, sizeof saved->color_masks);
    memcpy(saved->viewport, viewport, sizeof viewport);
    saved->caps[2] = 1; /* dither */
    saved->depth_mask = 1;
    saved->depth_func = (int32_t)TR_I_GL_LESS;
    saved->depth_range[1] = 1.0;
    saved->cull_mode = (int32_t)TR_I_GL_BACK;
    saved->front_face = (int32_t)TR_I_GL_CCW;
    saved->polygon_mode[0] = (int32_t)TR_I_GL_FILL;
    saved->blend_func[0] = saved->blend_func[2] = (int32_t)TR_I_GL_ONE;
    saved->blend_equation[0] = saved->blend_equation[1] = (int32_t)TR_I_GL_FUNC_ADD;
    saved->active_texture = (int32_t)TR_I_GL_TEXTURE0;
}

static void tr_i_switch_of(const tr_context *tr, tr_i_u cap, int index, int on) {
    if (on)
        tr->gl.Enablei(cap, (tr_i_u)index);
    else
        tr->gl.Disablei(cap, (tr_i_u)index);
}

static void tr_i_set_blend(const tr_context *tr, int on, tr_i_u source, tr_i_u destination, tr_i_u source_alpha,
                           tr_i_u destination_alpha, tr_i_u equation, tr_i_u equation_alpha) {
    if (tr->has_indexed)
        tr_i_switch_of(tr, TR_I_GL_BLEND, 0, on);
    else
        tr_i_switch(tr, TR_I_GL_BLEND, on);
    if (tr->has_indexed_blend) {
        tr->gl.BlendFuncSeparatei(0, source, destination, source_alpha, destination_alpha);
        tr->gl.BlendEquationSeparatei(0, equation, equation_alpha);
    } else {
        tr->gl.BlendFuncSeparate(source, destination, source_alpha, destination_alpha);
        tr->gl.BlendEquationSeparate(equation, equation_alpha);
    }
}

static void tr_i_restore_bindings(const tr_context *tr, const tr_i_snapshot *saved) {
    const tr_i_gl *gl = &tr->gl;
    tr_i_u binding = (tr_i_u)tr->desc.uniform_binding;
    int i;
    if (saved->program == 0 || gl->IsProgram((tr_i_u)saved->program))
        gl->UseProgram((tr_i_u)saved->program);
    gl->BindVertexArray((tr_i_u)saved->vertex_array);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, (tr_i_u)saved->draw_framebuffer);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, (tr_i_u)saved->read_framebuffer);
    /* The indexed binding first: it moves the generic one along. A size of 0 means the whole buffer. */
    if (saved->indexed_size > 0)
        gl->BindBufferRange(TR_I_GL_UNIFORM_BUFFER, binding, (tr_i_u)saved->indexed_buffer,
                            (ptrdiff_t)saved->indexed_start, (ptrdiff_t)saved->indexed_size);
    else
        gl->BindBufferBase(TR_I_GL_UNIFORM_BUFFER, binding, (tr_i_u)saved->indexed_buffer);
    gl->BindBuffer(TR_I_GL_UNIFORM_BUFFER, (tr_i_u)saved->uniform_buffer);
    gl->BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, (tr_i_u)saved->copy_buffer);
    gl->BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, (tr_i_u)saved->unpack_buffer);
    for (i = 0; i < TR_TEXTURE_UNITS; ++i) {
        tr_i_u unit = (tr_i_u)(tr->desc.first_texture_unit + i);
        gl->ActiveTexture(TR_I_GL_TEXTURE0 + unit);
        gl->BindTexture(tr_i_targets[i], (tr_i_u)saved->textures[i]);
        gl->BindSampler(unit, (tr_i_u)saved->samplers[i]);
    }
    for (i = 0; i < TR_I_EDGE_TEXTURE_COUNT && tr_i_reads_edges(tr, i); ++i) {
        tr_i_u unit = (tr_i_u)(tr->desc.first_texture_unit + TR_TEXTURE_UNITS + i);
        gl->ActiveTexture(TR_I_GL_TEXTURE0 + unit);
        gl->BindTexture(TR_I_GL_TEXTURE_2D, (tr_i_u)saved->edge_textures[i]);
        gl->BindSampler(unit, (tr_i_u)saved->edge_samplers[i]);
    }
    gl->ActiveTexture((tr_i_u)saved->active_texture);
}

static void tr_i_restore(const tr_context *tr, const tr_i_snapshot *saved) {
    const tr_i_gl *gl = &tr->gl;
    int i;
    tr_i_restore_bindings(tr, saved);
    for (i = 0; i < TR_I_CAP_COUNT; ++i)
        if (tr_i_has_cap(tr, i))
            tr_i_switch(tr, tr_i_caps[i].name, saved->caps[i]);
    for (i = 0; i < tr->clip_distances; ++i)
        tr_i_switch(tr, TR_I_GL_CLIP_DISTANCE0 + (tr_i_u)i, saved->clip_distances[i]);
    for (i = 0; i < tr->viewports; ++i)
        tr_i_switch_of(tr, TR_I_GL_SCISSOR_TEST, i, saved->scissors[i]);
    tr_i_set_viewport(tr, saved->viewport[0], saved->viewport[1], saved->viewport[2], saved->viewport[3]);
    if (tr->see.active)
        tr_i_set_scissor(tr, saved->scissor, 0);
    gl->DepthMask(saved->depth_mask);
    gl->DepthFunc((tr_i_u)saved->depth_func);
    tr_i_set_depth_range(tr, saved->depth_range[0], saved->depth_range[1]);
    gl->CullFace((tr_i_u)saved->cull_mode);
    gl->FrontFace((tr_i_u)saved->front_face);
    if (!tr->es)
        gl->PolygonMode(TR_I_GL_FRONT_AND_BACK, (tr_i_u)saved->polygon_mode[0]);
    if (tr->has_indexed)
        tr_i_switch_of(tr, TR_I_GL_BLEND, 1, saved->blends[1]);
    tr_i_set_blend(tr, saved->blends[0], (tr_i_u)saved->blend_func[0], (tr_i_u)saved->blend_func[1],
                   (tr_i_u)saved->blend_func[2], (tr_i_u)saved->blend_func[3], (tr_i_u)saved->blend_equation[0],
                   (tr_i_u)saved->blend_equation[1]);
    for (i = 0; i < tr->draw_buffers; ++i) {
        const unsigned char *mask = saved->color_masks[i];
        if (tr->has_indexed)
            gl->ColorMaski((tr_i_u)i, mask[0], mask[1], mask[2], mask[3]);
        else if (i == 0)
            gl->ColorMask(mask[0], mask[1], mask[2], mask[3]);
    }
}

static void tr_i_bind_textures(const tr_context *tr, const tr_state *state) {
    int i;
    for (i = 0; i < TR_TEXTURE_UNITS; ++i) {
        tr_i_u unit = (tr_i_u)(state->first_texture_unit + i);
        /* Units that are not read are unbound as well: they may hold a texture that this pass draws into. */
        tr->gl.ActiveTexture(TR_I_GL_TEXTURE0 + unit);
        tr->gl.BindTexture(state->texture_targets[i], state->textures[i]);
        tr->gl.BindSampler(unit, 0);
    }
    for (i = 0; i < TR_I_EDGE_TEXTURE_COUNT; ++i) {
        tr_i_u unit = (tr_i_u)(state->first_texture_unit + TR_TEXTURE_UNITS + i);
        if (!state->edge_textures[i])
            continue;
        tr->gl.ActiveTexture(TR_I_GL_TEXTURE0 + unit);
        tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, state->edge_textures[i]);
        tr->gl.BindSampler(unit, 0);
    }
}

/* Opens the first `count` colour buffers. */
static void tr_i_mask_colors(const tr_context *tr, int count) {
    int i;
    unsigned char on = count > 0;
    if (!tr->has_indexed) {
        tr->gl.ColorMask(on, on, on, on);
        return;
    }
    for (i = 0; i < tr->draw_buffers; ++i) {
        on = i < count;
        tr->gl.ColorMaski((tr_i_u)i, on, on, on, on);
    }
}

/* Makes the context's state what the pass says, whatever it was. */
static void tr_i_apply(const tr_context *tr, const tr_state *state) {
    const tr_i_gl *gl = &tr->gl;
    tr_i_u equation = state->blend_equation ? state->blend_equation : TR_I_GL_FUNC_ADD;
    int i;
    for (i = 0; i < TR_I_CAPS_OFF; ++i)
        if (tr_i_has_cap(tr, i))
            tr->gl.Disable(tr_i_caps[i].name);
    for (i = 0; i < tr->clip_distances; ++i)
        gl->Disable(TR_I_GL_CLIP_DISTANCE0 + (tr_i_u)i);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, state->framebuffer);
    tr_i_set_viewport(tr, (float)state->viewport[0], (float)state->viewport[1], (float)state->viewport[2],
                      (float)state->viewport[3]);
    if (state->scissor[2] > 0)
        tr_i_set_scissor(tr, state->scissor, 1);
    tr_i_set_depth_range(tr, 0.0, 1.0);
    /* A second buffer is one of ours: the mark. The host may have left blending on for it. */
    tr_i_mask_colors(tr, !state->color_write && !state->clear_color    ? 0
                         : state->framebuffer == tr->frame.framebuffer ? 1
                                                                       : 2);
    if (tr->has_indexed)
        tr_i_switch_of(tr, TR_I_GL_BLEND, 1, 0);
    /* Before clearing, whose colour is encoded as well. */
    if (tr->frame.wishes.options & TR_WISH_SRGB && !tr->es)
        tr_i_switch(tr, TR_I_GL_FRAMEBUFFER_SRGB, state->srgb);
    gl->DepthMask((unsigned char)(state->depth_write || state->clear_depth));
    if (state->clear_color)
        gl->ClearBufferfv(TR_I_GL_COLOR, 0, state->clear_color_value);
    if (state->clear_depth)
        gl->ClearBufferfv(TR_I_GL_DEPTH, 0, &state->clear_depth_value);
    if (state->clear_color && !state->color_write)
        tr_i_mask_colors(tr, 0);
    gl->DepthMask((unsigned char)state->depth_write);
    tr_i_switch(tr, TR_I_GL_DEPTH_TEST, state->depth_test);
    gl->DepthFunc(state->depth_func);
    tr_i_set_blend(tr, state->blend, state->blend_source, state->blend_destination, state->blend_source_alpha,
                   state->blend_destination_alpha, equation, equation);
    tr_i_switch(tr, TR_I_GL_CULL_FACE, state->cull_face != 0);
    gl->CullFace(state->cull_face ? state->cull_face : TR_I_GL_BACK);
    gl->FrontFace(state->front_face);
    if (!tr->es)
        gl->PolygonMode(TR_I_GL_FRONT_AND_BACK, TR_I_GL_FILL);
    gl->UseProgram(state->program);
    tr_i_bind_textures(tr, state);
    if (state->uniform_buffer) /* those that find outlines read none, and a range of no size is an error to GL 3.3 */
        gl->BindBufferRange(TR_I_GL_UNIFORM_BUFFER, (tr_i_u)state->uniform_binding, state->uniform_buffer,
                            state->uniform_offset, state->uniform_size);
}

/* ---- shaders and programs --------------------------------------------------------------------------------------- */

typedef struct tr_i_source {
    const char *strings[TR_I_MAX_STRINGS];
    int count;
    char defines[512]; /* of variants; numbers in them are made at run time */
    size_t used;
} tr_i_source;

static void tr_i_add(tr_i_source *source, const char *string) {
    if (source->count < TR_I_MAX_STRINGS)
        source->strings[source->count++] = string;
}

static void tr_i_add_chunks(tr_i_source *source, tr_i_strings chunks) {
    for (; *chunks; ++chunks)
        tr_i_add(source, *chunks);
}

static void tr_i_add_define(tr_i_source *source, const char *name, uint32_t number) {
    tr_i_text text = tr_i_text_in(source->defines + source->used, sizeof source->defines - source->used);
    tr_i_put(&text, "#define ");
    tr_i_put(&text, name);
    tr_i_put(&text, " ");
    tr_i_put_number(&text, number);
    tr_i_put(&text, "\n");
    tr_i_add(source, text.at);
    source->used += text.length + 1;
}

static void tr_i_add_preamble(tr_i_source *source, int es, int reversed_z) {
    /* A string of its own: what must follow the version at once, #extension lines, goes between this and the next. */
    tr_i_add(source, es ? "#version 300 es\n" : "#version 330 core\n");
    if (es)
        tr_i_add(source, "precision highp float;\nprecision highp int;\n");
    tr_i_add(source,
             reversed_z ? "#define TR_REVERSED_Z 1\n#define TR_CLEAR_DEPTH 0.0\n" : "#define TR_CLEAR_DEPTH 1.0\n");
}

static int tr_i_wants_color(int rule) {
    return rule == TR_RULE_FRONT_ALONE || rule == TR_RULE_PEEL_ALONE || rule == TR_RULE_LAYER ||
           rule == TR_RULE_LAYER_MARKED || rule == TR_RULE_LAYER_GROUP || rule == TR_RULE_OPAQUE ||
           rule == TR_RULE_OPAQUE_ENTERING || rule == TR_RULE_SEE_PLAIN || rule == TR_RULE_SEE_BEHIND ||
           rule == TR_RULE_SEE_DITHER || rule == TR_RULE_SEE_BLEND || rule == TR_RULE_SEE_BLEND_LAYERS ||
           rule == TR_RULE_SEE_PEEL || rule == TR_RULE_SEE_TARGET;
}

static int tr_i_wants_alpha(int rule) {
    return tr_i_wants_color(rule) && rule < TR_RULE_OPAQUE;
}

/* Of dynamic transparency. */
static int tr_i_is_see(int rule) {
    return rule >= TR_RULE_SEE_PLAIN;
}

static void tr_i_add_rule(tr_i_source *source, int rule) {
    static const char *const rules[TR_RULE_SEE_END] = {
        "#define TR_RULE 0\n",  "#define TR_RULE 1\n",  "#define TR_RULE 2\n",  "#define TR_RULE 3\n",
        "#define TR_RULE 4\n",  "#define TR_RULE 5\n",  "#define TR_RULE 6\n",  "#define TR_RULE 7\n",
        "#define TR_RULE 8\n",  "#define TR_RULE 9\n",  "#define TR_RULE 10\n", "#define TR_RULE 11\n",
        "#define TR_RULE 12\n", "#define TR_RULE 13\n", "#define TR_RULE 14\n", "#define TR_RULE 15\n",
        "#define TR_RULE 16\n", "#define TR_RULE 17\n", "#define TR_RULE 18\n", "#define TR_RULE 19\n",
        "#define TR_RULE 20\n", "#define TR_RULE 21\n", "#define TR_RULE 22\n", "#define TR_RULE 23\n",
        "#define TR_RULE 24\n", "#define TR_RULE 25\n", "#define TR_RULE 26\n", "#define TR_RULE 27\n"};
    tr_i_add(source, rules[rule]);
    tr_i_add(source, tr_i_wants_color(rule) ? "#define TR_WANTS_COLOR 1\n" : "#define TR_WANTS_COLOR 0\n");
    tr_i_add(source, tr_i_wants_alpha(rule) ? "#define TR_WANTS_ALPHA 1\n" : "#define TR_WANTS_ALPHA 0\n");
    tr_i_add(source, rule == TR_RULE_PEEL_GROUP || rule == TR_RULE_LIMIT_MARKED || rule == TR_RULE_LIMIT_MARKED_SHEET
                         ? "#define TR_CHAIN 1\n"
                         : "#define TR_CHAIN 0\n");
    tr_i_add(source, rule == TR_RULE_OPAQUE_ENTERING ? "#define TR_STRENGTHENS 1\n" : "#define TR_STRENGTHENS 0\n");
    tr_i_add(source, tr_i_is_see(rule) ? "#define TR_IS_SEE 1\n" : "#define TR_IS_SEE 0\n");
}

/* What a host's shader begins with, and the built-in surface programs too. */
static void tr_i_host_source(tr_i_source *source, tr_stage stage, int rule, int es, int reversed_z) {
    source->count = 0;
    source->used = 0;
    tr_i_add_preamble(source, es, reversed_z);
    tr_i_add_rule(source, rule);
    if (stage == TR_VERTEX) {
        tr_i_add_chunks(source, tr_i_shader_surface_vertex_glsl);
        tr_i_add_chunks(source, tr_i_shader_alpha_law_glsl);
    } else if (rule >= TR_RULE_SEE_DEPTH) {
        tr_i_add_chunks(source, tr_i_shader_seq_block_glsl);
        tr_i_add_chunks(source, tr_i_shader_seq_codes_glsl);
        tr_i_add_chunks(source, tr_i_shader_seq_layers_glsl);
        tr_i_add_chunks(source, tr_i_shader_seq_units_glsl);
        tr_i_add_chunks(source, tr_i_shader_cool_to_warm_glsl);
    } else if (tr_i_is_see(rule)) {
        tr_i_add_chunks(source, tr_i_shader_see_block_glsl);
        tr_i_add_chunks(source, tr_i_shader_see_rules_glsl);
        tr_i_add_chunks(source, tr_i_shader_cool_to_warm_glsl);
    } else {
        tr_i_add_chunks(source, tr_i_shader_frame_block_glsl);
        tr_i_add_chunks(source, tr_i_shader_chain_glsl);
        tr_i_add_chunks(source, tr_i_shader_surface_rules_glsl);
        tr_i_add_chunks(source, tr_i_shader_crossings_glsl);
        tr_i_add_chunks(source, tr_i_shader_cool_to_warm_glsl);
    }
}

/* Variants of the composition, of lines and of what takes opaque things. A key has a field for each thing that its text depends on. */
enum {
    TR_I_COMPOSITION = 1,
    TR_I_LINE = 2,
    TR_I_TAKE_OPAQUE = 3,
    TR_I_INK_OUTLINES = 1,
    TR_I_LINE_HIDDEN = 1,
    TR_I_LINE_OUTER = 2
};
typedef struct tr_i_variant {
    uint32_t kind, supersample, srgb, has_scene;
    uint32_t layers, blending, has_opaque, groups, blend_color, published; /* compositions */
    uint32_t ink, line, on_target, has_front;                              /* lines */
} tr_i_variant;

static uint32_t tr_i_key_of(const tr_i_variant *v) {
    return v->kind | v->supersample << 2 | v->srgb << 5 | v->has_scene << 6 | v->layers << 7 | v->blending << 11 |
           v->has_opaque << 13 | v->groups << 14 | v->blend_color << 15 | v->published << 16 | v->ink << 17 |
           v->line << 18 | v->on_target << 20 | v->has_front << 21;
}

static tr_i_variant tr_i_variant_of(uint32_t key) {
    tr_i_variant v;
    v.kind = key & 3u;
    v.supersample = key >> 2 & 7u;
    v.srgb = key >> 5 & 1u;
    v.has_scene = key >> 6 & 1u;
    v.layers = key >> 7 & 15u;
    v.blending = key >> 11 & 3u;
    v.has_opaque = key >> 13 & 1u;
    v.groups = key >> 14 & 1u;
    v.blend_color = key >> 15 & 1u;
    v.published = key >> 16 & 1u;
    v.ink = key >> 17 & 1u;
    v.line = key >> 18 & 3u;
    v.on_target = key >> 20 & 1u;
    v.has_front = key >> 21 & 3u;
    return v;
}

static void tr_i_variant_source(tr_i_source *source, tr_stage stage, uint32_t key) {
    tr_i_variant v = tr_i_variant_of(key);
    if (v.kind != TR_I_LINE && stage == TR_VERTEX) {
        tr_i_add_chunks(source, tr_i_shader_fullscreen_vert);
        return;
    }
    tr_i_add_define(source, "TR_SUPERSAMPLE", v.supersample);
    tr_i_add_define(source, "TR_SRGB", v.srgb);
    tr_i_add_define(source, "TR_HAS_SCENE", v.has_scene);
    tr_i_add_chunks(source, tr_i_shader_frame_block_glsl);
    if (v.kind == TR_I_LINE) {
        tr_i_add_define(source, "TR_INK", v.ink);
        tr_i_add_define(source, "TR_LINE", v.line);
        tr_i_add_define(source, "TR_ON_TARGET", v.on_target);
        tr_i_add_define(source, "TR_HAS_FRONT", v.has_front);
        tr_i_add_chunks(source, stage == TR_VERTEX ? tr_i_shader_line_vert : tr_i_shader_line_frag);
        return;
    }
    if (v.kind == TR_I_TAKE_OPAQUE) {
        tr_i_add_chunks(source, tr_i_shader_take_opaque_frag);
        return;
    }
    tr_i_add_define(source, "TR_LAYERS", v.layers);
    tr_i_add_define(source, "TR_BLENDING", v.blending);
    tr_i_add_define(source, "TR_HAS_OPAQUE", v.has_opaque);
    tr_i_add_define(source, "TR_CHAIN", v.groups);
    tr_i_add_define(source, "TR_BLEND_COLOR", v.blend_color);
    tr_i_add_define(source, "TR_PUBLISHED", v.published);
    tr_i_add_chunks(source, tr_i_shader_chain_glsl);
    tr_i_add_chunks(source, tr_i_shader_compose_frag);
}

static void tr_i_outline_source(tr_i_source *source, tr_stage stage, int variant) {
    tr_i_add(source, variant & 1 ? "#define TR_JUMP 1\n" : "#define TR_JUMP 0\n");
    tr_i_add(source, variant & 2 ? "#define TR_HAS_IDS 1\n" : "#define TR_HAS_IDS 0\n");
    tr_i_add_chunks(source, stage == TR_VERTEX ? tr_i_shader_fullscreen_vert : tr_i_shader_outline_frag);
}

/* Full-screen passes of dynamic transparency. */
static void tr_i_see_source(tr_i_source *source, tr_stage stage, int program) {
    int parts = program >= TR_I_PROGRAM_PARTS, like = parts ? program - TR_I_PROGRAM_PARTS + TR_I_PROGRAM_SEE : program;
    int bits = like == TR_I_PROGRAM_BITS, rows = like == TR_I_PROGRAM_SPREAD_X, low = like == TR_I_PROGRAM_SPREAD_Y;
    int prime = like == TR_I_PROGRAM_PRIME || like == TR_I_PROGRAM_PRIME_COLOR;
    tr_i_add_chunks(source, tr_i_shader_see_block_glsl);
    if (stage == TR_VERTEX) {
        tr_i_add(source, bits          ? "#define TR_COARSE_X 2\n"
                         : rows || low ? "#define TR_COARSE_X 1\n"
                                       : "#define TR_COARSE_X 0\n");
        tr_i_add(source, low    ? "#define TR_COARSE_Y 1\n"
                         : rows ? "#define TR_COARSE_Y 2\n"
                                : "#define TR_COARSE_Y 0\n");
        tr_i_add_chunks(source, tr_i_shader_see_tile_vert);
        return;
    }
    tr_i_add(source, parts ? "#define TR_IN_PARTS 1\n" : "#define TR_IN_PARTS 0\n");
    tr_i_add(source, low ? "#define TR_SPREAD 2\n" : rows ? "#define TR_SPREAD 1\n" : "#define TR_SPREAD 0\n");
    tr_i_add(source, like == TR_I_PROGRAM_FINISH ? "#define TR_HAS_LOW 1\n" : "#define TR_HAS_LOW 0\n");
    tr_i_add(source, like == TR_I_PROGRAM_COMPOSE_YIELD ? "#define TR_HAS_YIELD 1\n" : "#define TR_HAS_YIELD 0\n");
    tr_i_add(source, like == TR_I_PROGRAM_PRIME_COLOR ? "#define TR_HAS_COLOR 1\n" : "#define TR_HAS_COLOR 0\n");
    tr_i_add_chunks(source, bits || rows || low                 ? tr_i_shader_see_spread_frag
                            : prime                             ? tr_i_shader_see_prime_frag
                            : like == TR_I_PROGRAM_QUERY        ? tr_i_shader_see_query_frag
                            : like >= TR_I_PROGRAM_COMPOSE_MASK ? tr_i_shader_see_compose_frag
                                                                : tr_i_shader_see_finish_frag);
}

/* After the strings of tr_i_host_source, which hold the law itself for the vertex stage. */
static void tr_i_alpha_source(tr_i_source *source, tr_stage stage, int alpha) {
    static const char *const rungs[TR_ALPHA_COUNT] = {"#define TR_ALPHA 0\n", "#define TR_ALPHA 1\n",
                                                      "#define TR_ALPHA 2\n", "#define TR_ALPHA 3\n",
                                                      "#define TR_ALPHA 4\n"};
    tr_i_add(source, rungs[alpha]);
    if (stage == TR_VERTEX) {
        tr_i_add_chunks(source, tr_i_shader_alpha_vertex_glsl);
    } else {
        tr_i_add_chunks(source, tr_i_shader_alpha_law_glsl);
        tr_i_add_chunks(source, tr_i_shader_alpha_fragment_glsl);
    }
}

/* Full-screen passes of sequences, by the programs' numbers from TR_I_SEQ_WIPE on. */
static void tr_i_seq_source(tr_i_source *source, tr_stage stage, int program) {
    static const tr_i_strings fragments[] = {
        tr_i_shader_seq_wipe_frag,    tr_i_shader_seq_row_frag,     tr_i_shader_seq_near_frag,
        tr_i_shader_seq_near_frag,    tr_i_shader_seq_mask_frag,    tr_i_shader_seq_mask_frag,
        tr_i_shader_seq_mask_frag,    tr_i_shader_seq_mask_frag,    tr_i_shader_seq_own_frag,
        tr_i_shader_seq_reach_frag,   tr_i_shader_seq_keep_frag,    tr_i_shader_seq_share_frag,
        tr_i_shader_seq_compose_frag, tr_i_shader_seq_extents_frag, tr_i_shader_seq_forms_frag};
    int masks = program >= TR_I_SEQ_MASK && program < TR_I_SEQ_OVER, near_ = program - TR_I_SEQ_NEAR;
    int rings = masks ? (program - TR_I_SEQ_MASK) & 1 : near_ == 1;
    int whole = program == TR_I_SEQ_OVER || program == TR_I_SEQ_KEEP || program >= TR_I_SEQ_COMPOSE;
    tr_i_add_chunks(source, tr_i_shader_seq_block_glsl);
    if (stage == TR_VERTEX) {
        tr_i_add_define(source, "TR_BOXES", program == TR_I_SEQ_ROW ? 1 : near_ == 0 || near_ == 1 ? 2 : 0);
        tr_i_add_chunks(source, whole ? tr_i_shader_fullscreen_vert : tr_i_shader_seq_boxes_vert);
        return;
    }
    tr_i_add_define(source, "TR_RINGS", (uint32_t)rings);
    tr_i_add_define(source, "TR_TOGETHER", masks && program >= TR_I_SEQ_MASK + 2);
    if (masks || program == TR_I_SEQ_DEPTHS || program == TR_I_SEQ_SHARE)
        tr_i_add_chunks(source, tr_i_shader_seq_mask_glsl);
    if (program > TR_I_SEQ_DEPTHS && program <= TR_I_SEQ_COMPOSE) {
        tr_i_add_chunks(source, tr_i_shader_seq_codes_glsl);
        tr_i_add_chunks(source, tr_i_shader_seq_layers_glsl);
    }
    tr_i_add_chunks(source, fragments[program]);
}

/* The whole text of one stage of a built-in program; key: of a variant. */
static void tr_i_program_source(tr_i_source *source, int program, uint32_t key, tr_stage stage, int es,
                                int reversed_z) {
    if (program < TR_I_PROGRAM_COPY_DEPTH || (program >= TR_I_PROGRAM_ALPHA && program < TR_I_PROGRAM_OUTLINE)) {
        int further = program - TR_I_PROGRAM_ALPHA;
        int rule = further < 0 ? program : further % (int)TR_RULE_COUNT;
        int alpha = further < 0 ? 0 : further / (int)TR_RULE_COUNT + 1;
        tr_i_host_source(source, stage, rule, es, reversed_z);
        if (tr_i_wants_alpha(rule))
            tr_i_alpha_source(source, stage, alpha);
        tr_i_add_chunks(source, stage == TR_VERTEX ? tr_i_shader_surface_vert : tr_i_shader_surface_frag);
        return;
    }
    source->count = 0;
    source->used = 0;
    tr_i_add_preamble(source, es, reversed_z);
    if (program >= TR_I_PROGRAM_SEQUENCE)
        tr_i_seq_source(source, stage, program - TR_I_PROGRAM_SEQUENCE);
    else if (program >= TR_I_PROGRAM_SEE)
        tr_i_see_source(source, stage, program);
    else if (program >= TR_I_PROGRAM_OUTLINE)
        tr_i_outline_source(source, stage, program - TR_I_PROGRAM_OUTLINE);
    else if (program >= TR_I_PROGRAM_VARIANT)
        tr_i_variant_source(source, stage, key);
    else
        tr_i_add_chunks(source, stage == TR_VERTEX ? tr_i_shader_fullscreen_vert : tr_i_shader_copy_depth_frag);
}

static tr_i_u tr_i_compile(tr_context *tr, int program, tr_stage stage) {
    tr_i_source source;
    char log[2048] = "";
    int32_t ok = 0;
    tr_i_u shader = tr->gl.CreateShader(stage == TR_VERTEX ? TR_I_GL_VERTEX_SHADER : TR_I_GL_FRAGMENT_SHADER);
    if (!shader)
        return 0;
    tr_i_program_source(&source, program, tr->programs[program].key, stage, tr->es, tr->desc.reversed_z);
    tr->gl.ShaderSource(shader, source.count, source.strings, 0);
    tr->gl.CompileShader(shader);
    tr->gl.GetShaderiv(shader, TR_I_GL_COMPILE_STATUS, &ok);
    if (ok)
        return shader;
    tr->gl.GetShaderInfoLog(shader, (int32_t)sizeof log, 0, log);
    tr_i_log(&tr->desc, TR_LOG_ERROR, TR_SHADER_FAILED,
             stage == TR_VERTEX ? "built-in vertex shader does not compile"
                                : "built-in fragment shader does not compile",
             log);
    tr->gl.DeleteShader(shader);
    return 0;
}

static tr_i_u tr_i_link(tr_context *tr, int index) {
    char log[2048] = "";
    int32_t ok = 0;
    tr_i_u vertex = tr_i_compile(tr, index, TR_VERTEX);
    tr_i_u fragment = vertex ? tr_i_compile(tr, index, TR_FRAGMENT) : 0;
    tr_i_u program = fragment ? tr->gl.CreateProgram() : 0;
    if (program) {
        tr->gl.AttachShader(program, vertex);
        tr->gl.AttachShader(program, fragment);
        tr->gl.LinkProgram(program);
        tr->gl.GetProgramiv(program, TR_I_GL_LINK_STATUS, &ok);
        if (!ok) {
            tr->gl.GetProgramInfoLog(program, (int32_t)sizeof log, 0, log);
            tr_i_log(&tr->desc, TR_LOG_ERROR, TR_SHADER_FAILED, "built-in program does not link", log);
            tr->gl.DeleteProgram(program);
            program = 0;
        }
    }
    if (vertex)
        tr->gl.DeleteShader(vertex);
    if (fragment)
        tr->gl.DeleteShader(fragment);
    return program;
}

/* Samplers of sequences; see tr_i_bind_step. */
static const struct {
    const char *name;
    int unit;
} tr_i_seq_samplers[] = {
    {"tr_seed", TR_I_SCENE_DEPTH},         {"tr_rows", TR_I_OPAQUE_COLOR},   {"tr_extents", TR_I_OPAQUE_COLOR},
    {"tr_forms", TR_I_OPAQUE_COLOR},       {"tr_nearest_seed", TR_I_MARK},   {"tr_block_depth", TR_I_MARK},
    {"tr_mask_alphas", TR_I_OPAQUE_COLOR}, {"tr_remaining", TR_I_CROSSINGS}, {"tr_own_depth", TR_I_SCENE_DEPTH},
    {"tr_own_color", TR_I_OPAQUE_COLOR},   {"tr_reach", TR_I_CROSSINGS},     {"tr_code", TR_I_OPAQUE_COLOR},
    {"tr_layer_before", TR_I_FRONT_DEPTH}, {"tr_layer_now", TR_I_ODD_DEPTH}, {"tr_layer_even", TR_I_FRONT_DEPTH},
    {"tr_layer_odd", TR_I_ODD_DEPTH},      {"tr_chain", TR_I_FRONT_OWNER},   {"tr_layer_alphas", TR_I_FRONT_DEPTH}};

/* Points a program's samplers and block at our units and binding. The program is left in use. */
static void tr_i_wire_program(tr_context *tr, tr_i_u program) {
    static const char *const samplers[TR_TEXTURE_UNITS] = {"tr_front_depth", "tr_odd_depth",    "tr_front_owner",
                                                           "tr_scene_depth", "tr_opaque_color", "tr_layer_color",
                                                           "tr_front_mark",  "tr_crossings"};
    /* No program has two names for one unit. */
    static const char *const others[] = {"tr_edge_segments", "tr_edge_lists", "tr_outlines",   "tr_ids",
                                         "tr_nearest",       "tr_see_depth",  "tr_see_mark",   "tr_see_mask",
                                         "tr_see_rows",      "tr_see_low",    "tr_see_behind", "tr_see_low_depth",
                                         "tr_see_yield",     "tr_see_base",   "tr_see_bits"};
    static const int units[] = {
        TR_TEXTURE_UNITS, TR_TEXTURE_UNITS + 1, TR_TEXTURE_UNITS,  TR_I_OPAQUE_COLOR, TR_I_MARK,
        TR_I_SCENE_DEPTH, TR_I_OPAQUE_COLOR,    TR_I_OPAQUE_COLOR, TR_I_MARK,         TR_I_MARK,
        TR_I_MARK,        TR_I_CROSSINGS,       TR_I_CROSSINGS,    TR_I_OPAQUE_COLOR, TR_I_OPAQUE_COLOR};
    tr_i_u block = tr->gl.GetUniformBlockIndex(program, "tr_frame");
    int i;
    tr->gl.UseProgram(program);
    for (i = 0; i < TR_TEXTURE_UNITS; ++i) {
        int32_t location = tr->gl.GetUniformLocation(program, samplers[i]);
        if (location >= 0)
            tr->gl.Uniform1i(location, tr->desc.first_texture_unit + i);
    }
    for (i = 0; i < (int)(sizeof units / sizeof units[0]); ++i) {
        int32_t location = tr->gl.GetUniformLocation(program, others[i]);
        if (location >= 0)
            tr->gl.Uniform1i(location, tr->desc.first_texture_unit + units[i]);
    }
    for (i = 0; i < (int)(sizeof tr_i_seq_samplers / sizeof tr_i_seq_samplers[0]); ++i) {
        int32_t location = tr->gl.GetUniformLocation(program, tr_i_seq_samplers[i].name);
        if (location >= 0)
            tr->gl.Uniform1i(location, tr->desc.first_texture_unit + tr_i_seq_samplers[i].unit);
    }
    if (block != TR_I_GL_INVALID_INDEX)
        tr->gl.UniformBlockBinding(program, block, (tr_i_u)tr->desc.uniform_binding);
}

static tr_result tr_i_make_program(tr_context *tr, int index) {
    tr_i_program *program = &tr->programs[index];
    if (program->name)
        return TR_OK;
    program->name = tr_i_link(tr, index);
    if (!program->name)
        return tr_i_fail(&tr->desc, TR_SHADER_FAILED, 0);
    tr_i_wire_program(tr, program->name);
    program->model_view_projection = tr->gl.GetUniformLocation(program->name, "tr_model_view_projection");
    program->normal_matrix = tr->gl.GetUniformLocation(program->name, "tr_normal_matrix");
    program->color = tr->gl.GetUniformLocation(program->name, "tr_object_color");
    program->falloff = tr->gl.GetUniformLocation(program->name, "tr_falloff");
    program->object = tr->gl.GetUniformLocation(program->name, "tr_object");
    program->model = tr->gl.GetUniformLocation(program->name, "tr_model");
    program->crossing_range = tr->gl.GetUniformLocation(program->name, "tr_crossing_range");
    program->edge_frame = tr->gl.GetUniformLocation(program->name, "tr_edge_frame");
    program->edge_ranges = tr->gl.GetUniformLocation(program->name, "tr_edge_ranges");
    program->outline = tr->gl.GetUniformLocation(program->name, "tr_outline");
    program->jump = tr->gl.GetUniformLocation(program->name, "tr_jump");
    program->depth_law = tr->gl.GetUniformLocation(program->name, "tr_depth_law");
    program->pixel = tr->gl.GetUniformLocation(program->name, "tr_pixel");
    return TR_OK;
}

TR_I_API const char *const *tr_glsl(const tr_context *tr, tr_stage stage, tr_rule rule, int *count) {
    if (!tr || (unsigned)stage >= (unsigned)TR_STAGE_COUNT || (unsigned)rule >= (unsigned)TR_RULE_SEE_END || !count)
        return 0;
    *count = tr->string_count[stage][rule];
    return tr->strings[stage][rule];
}

TR_I_API const char *const *tr_alpha_glsl(const tr_context *tr, tr_stage stage, tr_alpha alpha, int *count) {
    if (!tr || (unsigned)stage >= (unsigned)TR_STAGE_COUNT || (unsigned)alpha >= (unsigned)TR_ALPHA_COUNT || !count)
        return 0;
    *count = tr->alpha_string_count[stage][alpha];
    return tr->alpha_strings[stage][alpha];
}

TR_I_API tr_result tr_prepare_program(tr_context *tr, uint32_t program) {
    int32_t current = 0, linked = 0;
    if (!tr)
        return TR_INVALID_ARGUMENT;
    if (!tr->gl.IsProgram(program))
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "tr_prepare_program: no program has that name");
    tr->gl.GetProgramiv(program, TR_I_GL_LINK_STATUS, &linked);
    if (!linked)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "tr_prepare_program: the program is not linked");
    tr->gl.GetIntegerv(TR_I_GL_CURRENT_PROGRAM, &current);
    tr_i_wire_program(tr, program);
    if (current == 0 || tr->gl.IsProgram((tr_i_u)current))
        tr->gl.UseProgram((tr_i_u)current);
    return TR_OK;
}

/* Texels of a row of the two arrays: what any context has, and what the shaders divide by. */
#define TR_I_EDGE_ROW 1024u
#define TR_I_NO_LIST 0xffffffffu

/* ---- creation --------------------------------------------------------------------------------------------------- */

static void *tr_i_default_alloc(size_t size, void *user) {
    (void)user;
    return TR_MALLOC(size);
}

static void tr_i_default_free(void *block, void *user) {
    (void)user;
    TR_FREE(block);
}

#ifdef TR_GL_STATIC
/* In the static mode the names that the host's GL header declares; its version macros say which there are. */
static void tr_i_load_static(tr_i_gl *gl) {
#define TR_I_TAKE(type, name, parameters) gl->name = (type(TR_I_GLAPI *) parameters)(tr_proc)gl##name;
    TR_I_GL_REQUIRED(TR_I_TAKE)
#if defined(GL_VERSION_3_0)
    TR_I_GL_DESKTOP(TR_I_TAKE)
#endif
#if defined(GL_VERSION_4_1)
    TR_I_GL_VIEWPORTS(TR_I_TAKE)
#endif
#if defined(GL_VERSION_4_1) || defined(GL_ES_VERSION_2_0)
    TR_I_GL_ES(TR_I_TAKE)
#endif
#if (defined(GL_VERSION_3_2) || defined(GL_ES_VERSION_3_0)) && !defined(__EMSCRIPTEN__)
    TR_I_GL_QUERY(TR_I_TAKE)
#endif
#if defined(GL_VERSION_3_0) || defined(GL_ES_VERSION_3_2)
    TR_I_GL_INDEXED(TR_I_TAKE)
#endif
#if defined(GL_VERSION_4_0) || defined(GL_ES_VERSION_3_2)
    TR_I_GL_INDEXED_BLEND(TR_I_TAKE)
#endif
#undef TR_I_TAKE
}
#endif

static tr_result tr_i_load(tr_context *tr) {
    tr_i_gl *gl = &tr->gl;
    const char *missing = 0;
#ifdef TR_GL_STATIC
    tr_i_load_static(gl);
#else
    tr_proc (*get)(const char *) = tr->desc.get_proc;
#define TR_I_TAKE(type, name, parameters) gl->name = (type(TR_I_GLAPI *) parameters)get("gl" #name);
    TR_I_GL_REQUIRED(TR_I_TAKE)
    TR_I_GL_DESKTOP(TR_I_TAKE)
    TR_I_GL_INDEXED(TR_I_TAKE)
    TR_I_GL_INDEXED_BLEND(TR_I_TAKE)
    TR_I_GL_VIEWPORTS(TR_I_TAKE)
    TR_I_GL_ES(TR_I_TAKE)
    TR_I_GL_QUERY(TR_I_TAKE)
#undef TR_I_TAKE
#endif
#define TR_I_CHECK(type, name, parameters)                                                                             \
    if (!gl->name)                                                                                                     \
        missing = "gl" #name;
    TR_I_GL_REQUIRED(TR_I_CHECK)
#undef TR_I_CHECK
    return missing ? tr_i_fail(&tr->desc, TR_GL_FUNCTION_MISSING, missing) : TR_OK;
}

/* "3.3.0 NVIDIA ...", "OpenGL ES 3.2 Mesa ...": 330, 320. Anything else: 0. */
static int tr_i_parse_version(const char *string, int *es) {
    static const char prefix[] = "OpenGL ES ";
    *es = string && strncmp(string, prefix, sizeof prefix - 1) == 0;
    if (*es)
        string += sizeof prefix - 1;
    if (!string || string[0] < '1' || string[0] > '9' || string[1] != '.' || string[2] < '0' || string[2] > '9')
        return 0;
    return (string[0] - '0') * 100 + (string[2] - '0') * 10;
}

static tr_result tr_i_detect(tr_context *tr) {
    const char *string = (const char *)tr->gl.GetString(TR_I_GL_VERSION);
    const char *missing = 0;
    int32_t limit = 0, viewport[2] = {0, 0};
    tr->version = tr_i_parse_version(string, &tr->es);
    if (tr->desc.max_gl_version && tr->version > tr->desc.max_gl_version)
        tr->version = tr->desc.max_gl_version;
    if (tr->version < (tr->es ? 300 : 330))
        return tr_i_fail(&tr->desc, TR_GL_TOO_OLD, string ? string : "no context is current");
    /* A function's presence says little; the version says that it works. */
    if (tr->version >= (tr->es ? 320 : 330)) {
        tr->has_indexed = 1;
#define TR_I_CHECK(type, name, parameters)                                                                             \
    if (!tr->gl.name)                                                                                                  \
        tr->has_indexed = 0;
        TR_I_GL_INDEXED(TR_I_CHECK)
#undef TR_I_CHECK
    }
    tr->has_queries = 1;
#define TR_I_CHECK(type, name, parameters)                                                                             \
    if (!tr->gl.name)                                                                                                  \
        tr->has_queries = 0;
    TR_I_GL_QUERY(TR_I_CHECK)
#undef TR_I_CHECK
    tr->has_indexed_blend = tr->version >= (tr->es ? 320 : 400) && tr->gl.BlendFuncSeparatei &&
                            tr->gl.BlendEquationSeparatei && tr->has_indexed;
    tr->has_viewports = !tr->es && tr->version >= 410 && tr->gl.ViewportIndexedf && tr->gl.DepthRangeIndexed &&
                        tr->gl.GetFloati_v && tr->gl.GetDoublei_v && tr->gl.ScissorIndexed && tr->has_indexed;
    if (tr->has_viewports) {
        tr->gl.GetIntegerv(TR_I_GL_MAX_VIEWPORTS, &limit);
        tr->viewports = limit > TR_I_MAX_VIEWPORTS ? TR_I_MAX_VIEWPORTS : limit;
    }
    if (tr->es && !tr->gl.DepthRangef)
        missing = "glDepthRangef";
    else if (!tr->es && !tr->gl.DepthRange)
        missing = "glDepthRange";
    else if (!tr->es && !tr->gl.GetDoublev)
        missing = "glGetDoublev";
    else if (!tr->es && !tr->gl.GetTexLevelParameteriv)
        missing = "glGetTexLevelParameteriv";
    else if (!tr->es && !tr->gl.PolygonMode)
        missing = "glPolygonMode";
    if (missing)
        return tr_i_fail(&tr->desc, TR_GL_FUNCTION_MISSING, missing);
    tr->gl.GetIntegerv(TR_I_GL_MAX_TEXTURE_SIZE, &tr->max_width);
    tr->gl.GetIntegerv(TR_I_GL_MAX_VIEWPORT_DIMS, viewport);
    tr->max_texture = tr->max_width;
    tr->max_height = viewport[1] < tr->max_width ? viewport[1] : tr->max_width;
    tr->max_width = viewport[0] < tr->max_width ? viewport[0] : tr->max_width;
    tr->gl.GetIntegerv(TR_I_GL_MAX_DRAW_BUFFERS, &limit);
    tr->draw_buffers = !tr->has_indexed || limit < 1   ? 1
                       : limit > TR_I_MAX_DRAW_BUFFERS ? TR_I_MAX_DRAW_BUFFERS
                                                       : limit;
    limit = 0;
    if (!tr->es)
        tr->gl.GetIntegerv(TR_I_GL_MAX_CLIP_DISTANCES, &limit);
    tr->clip_distances = limit > TR_I_MAX_CLIP_DISTANCES ? TR_I_MAX_CLIP_DISTANCES : limit;
    return TR_OK;
}

static tr_result tr_i_check_bindings(tr_context *tr) {
    int32_t units = 0, bindings = 0;
    tr->gl.GetIntegerv(TR_I_GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    tr->gl.GetIntegerv(TR_I_GL_MAX_UNIFORM_BUFFER_BINDINGS, &bindings);
    if (tr->desc.first_texture_unit == 0)
        tr->desc.first_texture_unit = 8;
    if (tr->desc.uniform_binding == 0)
        tr->desc.uniform_binding = 15;
    if (tr->desc.first_texture_unit < 0 ||
        tr->desc.first_texture_unit > units - TR_TEXTURE_UNITS - TR_I_EDGE_TEXTURE_COUNT)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "desc.first_texture_unit");
    if (tr->desc.uniform_binding < 0 || tr->desc.uniform_binding >= bindings)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "desc.uniform_binding");
    return TR_OK;
}

static void tr_i_assemble_alpha_sources(tr_context *tr) {
    tr_i_source source;
    int stage, alpha;
    for (stage = 0; stage < (int)TR_STAGE_COUNT; ++stage) {
        for (alpha = 0; alpha < (int)TR_ALPHA_COUNT; ++alpha) {
            source.count = 0;
            source.used = 0;
            tr_i_alpha_source(&source, (tr_stage)stage, alpha);
            memcpy(tr->alpha_strings[stage][alpha], source.strings, (size_t)source.count * sizeof source.strings[0]);
            tr->alpha_strings[stage][alpha][source.count] = "#line 1\n";
            tr->alpha_string_count[stage][alpha] = source.count + 1;
        }
    }
}

static void tr_i_assemble_host_sources(tr_context *tr) {
    tr_i_source source;
    int stage, rule;
    for (stage = 0; stage < (int)TR_STAGE_COUNT; ++stage) {
        for (rule = 0; rule < (int)TR_RULE_SEE_END; ++rule) {
            tr_i_host_source(&source, (tr_stage)stage, rule, tr->es, tr->desc.reversed_z);
            memcpy(tr->strings[stage][rule], source.strings, (size_t)source.count * sizeof source.strings[0]);
            /* The host's own text counts its lines from 1. */
            tr->strings[stage][rule][source.count] = "#line 1\n";
            tr->string_count[stage][rule] = source.count + 1;
        }
    }
}

TR_I_API tr_context *tr_create(const tr_desc *desc, tr_result *result) {
    tr_context *tr;
    tr_desc d;
    tr_result ignored;
    if (!result)
        result = &ignored;
    *result = TR_INVALID_ARGUMENT;
    if (!desc || !desc->alloc_fn != !desc->free_fn || (unsigned)desc->state > TR_STATE_NONE)
        return 0;
    d = *desc;
#ifndef TR_GL_STATIC
    if (!d.get_proc) {
        tr_i_fail(&d, TR_INVALID_ARGUMENT, "desc.get_proc");
        return 0;
    }
#endif
    if (!d.alloc_fn) {
        d.alloc_fn = tr_i_default_alloc;
        d.free_fn = tr_i_default_free;
    }
    tr = (tr_context *)d.alloc_fn(sizeof *tr, d.alloc_user);
    *result = TR_OUT_OF_MEMORY;
    if (!tr)
        return 0;
    memset(tr, 0, sizeof *tr);
    tr->desc = d;
    *result = tr_i_load(tr);
    if (*result == TR_OK)
        *result = tr_i_detect(tr);
    if (*result == TR_OK)
        *result = tr_i_check_bindings(tr);
    if (*result != TR_OK) {
        d.free_fn(tr, d.alloc_user);
        return 0;
    }
    tr_i_assemble_host_sources(tr);
    tr_i_assemble_alpha_sources(tr);
    return tr;
}

/* Hosts that apply state themselves, and TR_STATE_LEAVE_DIRTY, leave ours bound. What is deleted is bound nowhere, and must
   not be bound again when the snapshot is put back: core GL would call that an error, and ES make a new texture. */
static void tr_i_forget(int32_t *saved, tr_i_u name) {
    if ((tr_i_u)*saved == name)
        *saved = 0;
}

static void tr_i_delete_textures(tr_context *tr, int count, tr_i_u *names) {
    int i, unit;
    for (i = 0; i < count; ++i) {
        for (unit = 0; unit < TR_TEXTURE_UNITS; ++unit)
            tr_i_forget(&tr->saved.textures[unit], names[i]);
        for (unit = 0; unit < TR_I_EDGE_TEXTURE_COUNT; ++unit)
            tr_i_forget(&tr->saved.edge_textures[unit], names[i]);
    }
    tr->gl.DeleteTextures(count, names);
    memset(names, 0, (size_t)count * sizeof names[0]);
}

static void tr_i_delete_framebuffers(tr_context *tr, int count, tr_i_u *names) {
    int i;
    for (i = 0; i < count; ++i) {
        tr_i_forget(&tr->saved.draw_framebuffer, names[i]);
        tr_i_forget(&tr->saved.read_framebuffer, names[i]);
    }
    tr->gl.DeleteFramebuffers(count, names);
    memset(names, 0, (size_t)count * sizeof names[0]);
}

static void tr_i_drop_textures(tr_context *tr) {
    tr_i_u crossings = tr->textures[TR_I_CROSSINGS];
    tr->textures[TR_I_CROSSINGS] = 0;
    tr_i_delete_framebuffers(tr, TR_I_FBO_COUNT, tr->fbos);
    tr_i_delete_textures(tr, TR_I_TEXTURE_COUNT, tr->textures);
    tr->textures[TR_I_CROSSINGS] = crossings; /* the host's data, of no frame's size */
    tr->width = tr->height = 0;
}

static void tr_i_drop_outlines(tr_context *tr) {
    tr_i_delete_framebuffers(tr, 2, tr->outline_fbos);
    tr_i_delete_textures(tr, 2, tr->outline_textures);
    tr->outline_width = tr->outline_height = 0;
    tr->outline_pixel = 0;
}

static void tr_i_drop_edges(tr_context *tr) {
    tr_i_delete_textures(tr, TR_I_EDGE_TEXTURE_COUNT, tr->edge_textures);
    memset(tr->edge_rows, 0, sizeof tr->edge_rows);
}

/* ---- dynamic transparency: memory and textures ------------------------------------------------------------------ */

typedef struct tr_i_see_format {
    tr_i_u internal, format, type;
    uint32_t bytes;
    int across, up; /* 0: the viewport's size; 1: divided as masks are; 2: by 4; 3: by 8 */
} tr_i_see_format;

/* depth: of what is copied, in tr_i_depths. */
static tr_i_see_format tr_i_see_format_of(int texture, int srgb, int depth) {
    static const tr_i_see_format formats[TR_I_SEE_TARGET_DEPTH] = {
        {TR_I_GL_DEPTH_COMPONENT32F, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_FLOAT, 4, 0, 0},
        {TR_I_GL_RGBA8, TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 4, 0, 0},
        {TR_I_GL_R8, TR_I_GL_RED, TR_I_GL_UNSIGNED_BYTE, 1, 3, 0},
        {TR_I_GL_RGBA8, TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 4, 1, 2},
        {TR_I_GL_RGBA8, TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 4, 1, 1},
        {TR_I_GL_DEPTH_COMPONENT32F, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_FLOAT, 4, 1, 1},
        {TR_I_GL_RG8, TR_I_GL_RG, TR_I_GL_UNSIGNED_BYTE, 2, 0, 0},
        {TR_I_GL_DEPTH_COMPONENT32F, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_FLOAT, 4, 0, 0},
        {TR_I_GL_RGBA8, TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 4, 0, 0},
        {TR_I_GL_R8, TR_I_GL_RED, TR_I_GL_UNSIGNED_BYTE, 1, 0, 0},
        {TR_I_GL_RGBA8, TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 4, 2, 2}};
    tr_i_see_format format = formats[texture < TR_I_SEE_TARGET_DEPTH ? texture : TR_I_SEE_DEPTH];
    if (texture >= TR_I_SEE_TARGET_DEPTH) {
        format.internal = tr_i_depths[depth].internal;
        format.format = tr_i_depths[depth].format;
        format.type = tr_i_depths[depth].type;
        format.bytes = tr_i_depths[depth].bytes;
    }
    if (texture == TR_I_SEE_BEHIND && srgb)
        format.internal = TR_I_GL_SRGB8_ALPHA8;
    return format;
}

static int tr_i_see_divisor(int kind, int divisor) {
    return kind == 0 ? 1 : kind == 1 ? divisor : kind == 2 ? 4 : 8;
}

static void tr_i_see_size(const tr_i_see_format *format, int width, int height, int divisor, int out[2]) {
    int across = tr_i_see_divisor(format->across, divisor), up = tr_i_see_divisor(format->up, divisor);
    out[0] = (width + across - 1) / across;
    out[1] = (height + up - 1) / up;
}

static uint64_t tr_i_see_weight(int texture, int depth, int width, int height, int divisor) {
    tr_i_see_format format = tr_i_see_format_of(texture, 0, depth);
    int size[2];
    tr_i_see_size(&format, width, height, divisor, size);
    return (uint64_t)size[0] * (uint64_t)size[1] * format.bytes;
}

/* Of the framebuffers: a colour and a depth; -1: none. */
static void tr_i_see_attached(int fbo, int out[2]) {
    static const signed char attached[TR_I_SEE_FBO_COUNT][2] = {{TR_I_SEE_MARK, TR_I_SEE_DEPTH},
                                                                {TR_I_SEE_BITS, -1},
                                                                {TR_I_SEE_ROWS, -1},
                                                                {TR_I_SEE_LOW, TR_I_SEE_LOW_DEPTH},
                                                                {TR_I_SEE_MASK, TR_I_SEE_MASK_DEPTH},
                                                                {TR_I_SEE_BEHIND, TR_I_SEE_DEPTH},
                                                                {TR_I_SEE_YIELD, TR_I_SEE_DEPTH},
                                                                {TR_I_SEE_QUERY, -1},
                                                                {-1, TR_I_SEE_DEPTH},
                                                                {-1, TR_I_SEE_TARGET_DEPTH},
                                                                {-1, TR_I_SEE_BASE_DEPTH},
                                                                {TR_I_SEE_BEHIND, -1},
                                                                {TR_I_SEE_MARK, TR_I_SEE_BASE_DEPTH}};
    out[0] = attached[fbo][0];
    out[1] = attached[fbo][1];
}

/* The framebuffer of ours that a pass of a plan draws into; -1: the host's. */
static int tr_i_see_fbo_of(const tr_i_see *see, int index) {
    const tr_see_plan *plan = &see->plan;
    switch (plan->passes[index].kind) {
    case TR_PASS_BLOCK:
    case TR_PASS_TARGETS:
        return plan->in_parts ? TR_I_SEE_FBO_MARKS : see->colored ? TR_I_SEE_FBO_BEHIND : TR_I_SEE_FBO_TARGETS;
    case TR_PASS_BITS:
        return TR_I_SEE_FBO_BITS;
    case TR_PASS_SPREAD_X:
        return TR_I_SEE_FBO_ROWS;
    case TR_PASS_SPREAD_Y:
        return TR_I_SEE_FBO_LOW;
    case TR_PASS_FINISH:
        return TR_I_SEE_FBO_MASK;
    case TR_PASS_PRIME: /* for the pass after it */
        return plan->passes[index + 1].kind == TR_PASS_YIELD ? TR_I_SEE_FBO_YIELD
               : see->colored || plan->in_parts              ? TR_I_SEE_FBO_PRIME
                                                             : TR_I_SEE_FBO_BEHIND;
    case TR_PASS_TAKE: /* depth that is copied last is that of all */
        return see->units_of[index] == TR_I_UNITS_ALL                                        ? TR_I_SEE_FBO_TAKE_COLOR
               : see->units_of[index] == TR_I_UNITS_TARGETS && see->counts[TR_I_UNITS_BLOCK] ? TR_I_SEE_FBO_TAKE_TARGETS
                                                                                             : TR_I_SEE_FBO_TAKE_BASE;
    case TR_PASS_BEHIND:
        return TR_I_SEE_FBO_BEHIND;
    case TR_PASS_YIELD:
        return TR_I_SEE_FBO_YIELD;
    case TR_PASS_QUERY:
    case TR_PASS_HIDES:
        return TR_I_SEE_FBO_QUERY;
    default:
        return -1;
    }
}

/* Bits of the textures that a plan draws into. */
static uint32_t tr_i_see_needs(const tr_i_see *see) {
    uint32_t needs = 0;
    int i, attached[2];
    for (i = 0; i < see->plan.pass_count; ++i) {
        int fbo = tr_i_see_fbo_of(see, i);
        if (fbo < 0)
            continue;
        tr_i_see_attached(fbo, attached);
        needs |= (attached[0] >= 0 ? 1u << attached[0] : 0u) | (attached[1] >= 0 ? 1u << attached[1] : 0u);
    }
    return needs;
}

/* Textures of dynamic transparency that are held now. */
static uint64_t tr_i_see_bytes(const tr_context *tr) {
    const tr_i_see *see = &tr->see;
    uint64_t bytes = 0;
    int i;
    for (i = 0; i < TR_I_SEE_TEXTURE_COUNT; ++i)
        if (see->textures[i])
            bytes += tr_i_see_weight(i, see->held_depth, see->width, see->height, see->divisor);
    return bytes;
}

static void tr_i_drop_queries(tr_context *tr) {
    int i;
    for (i = 0; i < TR_I_QUERY_RING; ++i) {
        tr_i_query *query = &tr->see.queries[i];
        if (query->fence)
            tr->gl.DeleteSync(query->fence);
        if (query->buffer)
            tr->gl.DeleteBuffers(1, &query->buffer);
        memset(query, 0, sizeof *query);
    }
}

static void tr_i_drop_see_textures(tr_context *tr) {
    tr_i_drop_queries(tr);
    tr_i_delete_framebuffers(tr, TR_I_SEE_FBO_COUNT, tr->see.fbos);
    tr_i_delete_textures(tr, TR_I_SEE_TEXTURE_COUNT, tr->see.textures);
    tr->see.width = tr->see.height = 0;
}

/* ---- dynamic transparency: textures of sequences ---- */

typedef struct tr_i_format {
    tr_i_u internal, format, type;
    uint32_t bytes;
} tr_i_format;

static tr_i_format tr_i_seq_format(const tr_i_sequence *seq, int texture) {
    static const tr_i_format depth = {TR_I_GL_DEPTH_COMPONENT32F, TR_I_GL_DEPTH_COMPONENT, TR_I_GL_FLOAT, 4};
    static const tr_i_format row = {TR_I_GL_R16UI, TR_I_GL_RED_INTEGER, TR_I_GL_UNSIGNED_SHORT, 2};
    static const tr_i_format nearest = {TR_I_GL_RG16UI, TR_I_GL_RG_INTEGER, TR_I_GL_UNSIGNED_SHORT, 4};
    static const tr_i_format pairs[2] = {{TR_I_GL_RG16F, TR_I_GL_RG, TR_I_GL_FLOAT, 4},
                                         {TR_I_GL_RG8, TR_I_GL_RG, TR_I_GL_UNSIGNED_BYTE, 2}};
    static const tr_i_format colors[2] = {{TR_I_GL_RGBA16F, TR_I_GL_RGBA, TR_I_GL_FLOAT, 8},
                                          {TR_I_GL_RGBA8, TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 4}};
    static const tr_i_format code = {TR_I_GL_R32UI, TR_I_GL_RED_INTEGER, TR_I_GL_UNSIGNED_INT, 4};
    switch (texture) {
    case TR_I_SEQ_CODE:
    case TR_I_SEQ_CHAIN:
    case TR_I_SEQ_FORMS:
        return code;
    case TR_I_SEQ_LAYER_COLOR: /* light has more dark than 8 bits hold */
        return colors[seq->eight_bits || !seq->light];
    case TR_I_SEQ_LAYER_ALPHAS:
        return colors[seq->eight_bits];
    case TR_I_SEQ_ROWS:
        return row;
    case TR_I_SEQ_NEAREST:
    case TR_I_SEQ_EXTENTS:
        return nearest;
    case TR_I_SEQ_ALPHAS:
        return pairs[seq->eight_bits];
    case TR_I_SEQ_REMAINING:
        return pairs[1];
    case TR_I_SEQ_OWN_COLOR:
        return colors[seq->eight_bits];
    default:
        return depth;
    }
}

/* Width, height and slices (0: no array) for a viewport's width and height, a divisor and layers. */
static void tr_i_seq_size(int texture, const int extent[4], int size[3]) {
    int cell = extent[2], layers = extent[3];
    size[0] = texture == TR_I_SEQ_ROWS || texture == TR_I_SEQ_NEAREST ? (extent[0] + cell - 1) / cell : extent[0];
    size[1] = texture == TR_I_SEQ_NEAREST ? (extent[1] + cell - 1) / cell : extent[1];
    if (texture == TR_I_SEQ_EXTENTS || texture == TR_I_SEQ_FORMS) {
        size[0] = TR_I_RUN;
        size[1] = texture == TR_I_SEQ_FORMS ? 65 : extent[1];
    }
    size[2] = texture < TR_I_SEQ_EVEN            ? 0
              : texture <= TR_I_SEQ_ODD          ? (layers + 1) / 2
              : texture == TR_I_SEQ_LAYER_ALPHAS ? (layers + 3) / 4
                                                 : layers;
}

/* Bits of the textures that the steps of this frame need. */
static uint32_t tr_i_seq_needs(const tr_i_sequence *seq) {
    uint32_t needs = 1u << TR_I_SEQ_SEED | 1u << TR_I_SEQ_ROWS | 1u << TR_I_SEQ_NEAREST;
    if (seq->has_block)
        needs |= 1u << TR_I_SEQ_BLOCK;
    if (seq->shape != TR_MASK_OUTLINE)
        needs |= 1u << TR_I_SEQ_EXTENTS | 1u << TR_I_SEQ_FORMS;
    if (seq->exact)
        return needs | 1u << TR_I_SEQ_REACH | 1u << TR_I_SEQ_CODE | 1u << TR_I_SEQ_EVEN | 1u << TR_I_SEQ_ODD |
               1u << TR_I_SEQ_CHAIN | 1u << TR_I_SEQ_LAYER_COLOR | 1u << TR_I_SEQ_LAYER_ALPHAS;
    needs |= 1u << TR_I_SEQ_ALPHAS;
    if (seq->counted)
        needs |= 1u << TR_I_SEQ_OWN_COLOR | 1u << TR_I_SEQ_OWN_DEPTH | 1u << TR_I_SEQ_REMAINING;
    return needs;
}

static uint64_t tr_i_seq_bytes(const tr_i_sequence *seq, uint32_t textures, const int extent[4]) {
    uint64_t bytes = 0;
    int i, size[3];
    for (i = 0; i < TR_I_SEQ_TEXTURE_COUNT; ++i) {
        if (!(textures >> i & 1u))
            continue;
        tr_i_seq_size(i, extent, size);
        bytes +=
            (uint64_t)size[0] * (uint64_t)size[1] * (uint64_t)(size[2] ? size[2] : 1) * tr_i_seq_format(seq, i).bytes;
    }
    return bytes;
}

static uint32_t tr_i_seq_held(const tr_i_sequence *seq) {
    uint32_t held = 0;
    int i;
    for (i = 0; i < TR_I_SEQ_TEXTURE_COUNT; ++i)
        held |= (uint32_t)(seq->textures[i] != 0) << i;
    return held;
}

static void tr_i_drop_seq_textures(tr_context *tr) {
    tr_i_delete_framebuffers(tr, TR_I_SEQ_FBO_COUNT, tr->seq.fbos);
    tr_i_delete_textures(tr, TR_I_SEQ_TEXTURE_COUNT, tr->seq.textures);
    memset(tr->seq.extent, 0, sizeof tr->seq.extent);
}

static void tr_i_drop_array(tr_context *tr, tr_i_array *array) {
    if (array->items)
        tr->desc.free_fn(array->items, tr->desc.alloc_user);
    memset(array, 0, sizeof *array);
}

/* All but programs. */
static void tr_i_drop_sequence(tr_context *tr) {
    tr_i_sequence *seq = &tr->seq;
    tr_i_array *arrays[10];
    int i;
    arrays[0] = &seq->ranks;
    arrays[1] = &seq->by_group;
    arrays[2] = &seq->painted;
    arrays[3] = &seq->list;
    arrays[4] = &seq->scene;
    arrays[5] = &seq->masks;
    arrays[6] = &seq->items;
    arrays[7] = &seq->steps;
    arrays[8] = &seq->blocks;
    arrays[9] = &seq->tied;
    for (i = 0; i < 10; ++i)
        tr_i_drop_array(tr, arrays[i]);
    tr_i_drop_seq_textures(tr);
    if (seq->buffer)
        tr->gl.DeleteBuffers(1, &seq->buffer);
    seq->buffer = 0;
    seq->buffer_size = 0;
}

/* The unit that a texture is read from, where it is read from one alone. */
static int tr_i_seq_unit(int texture) {
    static const int units[TR_I_SEQ_TEXTURE_COUNT] = {
        TR_I_SCENE_DEPTH, TR_I_OPAQUE_COLOR, TR_I_MARK,         TR_I_MARK,         TR_I_OPAQUE_COLOR, TR_I_OPAQUE_COLOR,
        TR_I_SCENE_DEPTH, TR_I_CROSSINGS,    TR_I_OPAQUE_COLOR, TR_I_OPAQUE_COLOR, TR_I_CROSSINGS,    TR_I_OPAQUE_COLOR,
        TR_I_FRONT_DEPTH, TR_I_ODD_DEPTH,    TR_I_FRONT_OWNER,  TR_I_LAYER_COLOR,  TR_I_FRONT_DEPTH};
    return units[texture];
}

static void tr_i_make_seq_texture(tr_context *tr, int index) {
    const tr_i_gl *gl = &tr->gl;
    tr_i_format format = tr_i_seq_format(&tr->seq, index);
    int size[3], unit = tr_i_seq_unit(index);
    tr_i_u target = tr_i_targets[unit];
    tr_i_seq_size(index, tr->seq.extent, size);
    gl->ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + unit));
    gl->GenTextures(1, &tr->seq.textures[index]);
    gl->BindTexture(target, tr->seq.textures[index]);
    if (size[2])
        gl->TexImage3D(target, 0, (int32_t)format.internal, size[0], size[1], size[2], 0, format.format, format.type,
                       0);
    else
        gl->TexImage2D(target, 0, (int32_t)format.internal, size[0], size[1], 0, format.format, format.type, 0);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_MIN_FILTER, TR_I_GL_NEAREST);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_MAG_FILTER, TR_I_GL_NEAREST);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_WRAP_S, TR_I_GL_CLAMP_TO_EDGE);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_WRAP_T, TR_I_GL_CLAMP_TO_EDGE);
}

/* What is attached to a framebuffer: depth and two colours, -1: none; and of arrays which slice. */
static void tr_i_seq_attachments(int fbo, int out[3], int slices[3]) {
    static const int attached[TR_I_SEQ_FBO_PEEL][2] = {{TR_I_SEQ_SEED, -1},
                                                       {-1, TR_I_SEQ_ROWS},
                                                       {-1, TR_I_SEQ_NEAREST},
                                                       {TR_I_SEQ_BLOCK, -1},
                                                       {-1, TR_I_SEQ_ALPHAS},
                                                       {TR_I_SEQ_OWN_DEPTH, TR_I_SEQ_OWN_COLOR},
                                                       {TR_I_SEQ_OWN_DEPTH, TR_I_SEQ_REMAINING},
                                                       {-1, TR_I_SEQ_EXTENTS},
                                                       {-1, TR_I_SEQ_FORMS},
                                                       {TR_I_SEQ_REACH, -1}};
    int layer = (fbo - TR_I_SEQ_FBO_PEEL) % TR_I_SEQ_LAYERS;
    slices[0] = layer / 2;
    slices[1] = layer;
    slices[2] = 0;
    out[2] = -1;
    if (fbo < TR_I_SEQ_FBO_PEEL) {
        out[0] = attached[fbo][0];
        out[1] = attached[fbo][1];
        return;
    }
    out[0] = -1;
    out[1] = fbo >= TR_I_SEQ_FBO_SHARE ? TR_I_SEQ_LAYER_ALPHAS : TR_I_SEQ_CHAIN;
    if (fbo >= TR_I_SEQ_FBO_KEEP)
        return;
    out[0] = layer & 1 ? TR_I_SEQ_ODD : TR_I_SEQ_EVEN;
    out[1] = TR_I_SEQ_LAYER_COLOR;
    out[2] = TR_I_SEQ_CODE;
}

static int tr_i_make_seq_fbo(tr_context *tr, int index) {
    static const tr_i_u points[3] = {TR_I_GL_DEPTH_ATTACHMENT, TR_I_GL_COLOR_ATTACHMENT0,
                                     TR_I_GL_COLOR_ATTACHMENT0 + 1};
    const tr_i_gl *gl = &tr->gl;
    tr_i_u buffers[2];
    int attached[3], slices[3], i;
    tr_i_seq_attachments(index, attached, slices);
    gl->GenFramebuffers(1, &tr->seq.fbos[index]);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->seq.fbos[index]);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, tr->seq.fbos[index]);
    for (i = 0; i < 3; ++i) {
        if (attached[i] >= TR_I_SEQ_EVEN)
            gl->FramebufferTextureLayer(TR_I_GL_DRAW_FRAMEBUFFER, points[i], tr->seq.textures[attached[i]], 0,
                                        slices[i]);
        else if (attached[i] >= 0)
            gl->FramebufferTexture2D(TR_I_GL_DRAW_FRAMEBUFFER, points[i], TR_I_GL_TEXTURE_2D,
                                     tr->seq.textures[attached[i]], 0);
    }
    for (i = 0; i < 2; ++i)
        buffers[i] = attached[i + 1] >= 0 ? points[i + 1] : 0;
    gl->DrawBuffers(buffers[1] ? 2 : 1, buffers);
    gl->ReadBuffer(buffers[0]);
    return gl->CheckFramebufferStatus(TR_I_GL_DRAW_FRAMEBUFFER) == TR_I_GL_FRAMEBUFFER_COMPLETE;
}

/* Whether all that a framebuffer attaches is there. */
static int tr_i_has_attached(const tr_i_sequence *seq, int fbo) {
    int attached[3], slices[3], size[3], i;
    tr_i_seq_attachments(fbo, attached, slices);
    for (i = 0; i < 3; ++i) {
        if (attached[i] < 0)
            continue;
        tr_i_seq_size(attached[i], seq->extent, size);
        if (!seq->textures[attached[i]] || (size[2] && slices[i] >= size[2]))
            return 0;
    }
    return 1;
}

/* Textures that are needed, and framebuffers of which all is there. */
static int tr_i_try_seq_textures(tr_context *tr, uint32_t needs) {
    int i;
    tr->gl.BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, 0);
    for (i = 0; i < TR_I_SEQ_TEXTURE_COUNT; ++i)
        if ((needs >> i & 1u) && !tr->seq.textures[i])
            tr_i_make_seq_texture(tr, i);
    for (i = 0; i < TR_I_SEQ_FBO_COUNT; ++i)
        if (!tr->seq.fbos[i] && tr_i_has_attached(&tr->seq, i) && !tr_i_make_seq_fbo(tr, i))
            return 0;
    return 1;
}

/* More layers than are needed are kept. */
static int tr_i_seq_misfits(const tr_context *tr) {
    const tr_i_sequence *seq = &tr->seq;
    return memcmp(seq->extent, seq->wanted, 3 * sizeof seq->extent[0]) != 0 || seq->extent[3] < seq->wanted[3] ||
           seq->light != seq->made_for_light;
}

/* Contexts that cannot draw into textures of floats (ES 3.0 without an extension) say so by an incomplete framebuffer. */
static tr_result tr_i_make_seq_textures(tr_context *tr) {
    tr_i_sequence *seq = &tr->seq;
    uint32_t needs = tr_i_seq_needs(seq);
    int tries;
    for (tries = 0; tries < 2; ++tries) {
        if (tr_i_seq_misfits(tr))
            tr_i_drop_seq_textures(tr);
        if (seq->extent[3] < seq->wanted[3] || seq->extent[0] == 0)
            seq->extent[3] = seq->wanted[3];
        memcpy(seq->extent, seq->wanted, 3 * sizeof seq->extent[0]);
        seq->made_for_light = seq->light;
        if (tr_i_try_seq_textures(tr, needs))
            return TR_OK;
        tr_i_drop_seq_textures(tr);
        if (seq->eight_bits)
            break;
        seq->eight_bits = 1;
    }
    return tr_i_fail(&tr->desc, TR_TARGET_INCOMPLETE, "one of the header's own");
}

/* All but the uniform buffer. */
static void tr_i_drop_see(tr_context *tr) {
    tr_i_drop_see_textures(tr);
    if (tr->see.places)
        tr->desc.free_fn(tr->see.places, tr->desc.alloc_user);
    tr->see.places = 0;
    tr->see.capacity = 0;
    tr_i_drop_sequence(tr);
    if (tr->see.answer)
        tr->desc.free_fn(tr->see.answer, tr->desc.alloc_user);
    tr->see.answer = 0;
}

/* Lists for so many units; grown by a quarter more, so that counts that change little allocate nothing. */
static tr_result tr_i_fit_units(tr_context *tr, size_t count) {
    tr_i_see *see = &tr->see;
    size_t capacity = count + count / 4 + 64, each = sizeof(tr_i_place) + TR_I_UNIT_LISTS * sizeof(uint32_t);
    char *block;
    int list;
    if (count <= see->capacity && see->places)
        return TR_OK;
    block = (char *)tr->desc.alloc_fn(capacity * each, tr->desc.alloc_user);
    if (!block)
        return tr_i_fail(&tr->desc, TR_OUT_OF_MEMORY, "dynamic.units");
    if (see->places)
        tr->desc.free_fn(see->places, tr->desc.alloc_user);
    see->places = (tr_i_place *)(void *)block;
    see->capacity = capacity;
    for (list = 0; list < TR_I_UNIT_LISTS; ++list)
        see->lists[list] =
            (uint32_t *)(void *)(block + capacity * (sizeof(tr_i_place) + (size_t)list * sizeof(uint32_t)));
    return TR_OK;
}

static void tr_i_make_see_texture(tr_context *tr, int index) {
    const tr_i_gl *gl = &tr->gl;
    const tr_i_see *see = &tr->see;
    tr_i_see_format format = tr_i_see_format_of(index, see->srgb, see->held_depth);
    int size[2];
    tr_i_see_size(&format, see->width, see->height, see->divisor, size);
    gl->GenTextures(1, &tr->see.textures[index]);
    gl->BindTexture(TR_I_GL_TEXTURE_2D, see->textures[index]);
    gl->TexImage2D(TR_I_GL_TEXTURE_2D, 0, (int32_t)format.internal, size[0], size[1], 0, format.format, format.type, 0);
    gl->TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MIN_FILTER, TR_I_GL_NEAREST);
    gl->TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MAG_FILTER, TR_I_GL_NEAREST);
    gl->TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_WRAP_S, TR_I_GL_CLAMP_TO_EDGE);
    gl->TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_WRAP_T, TR_I_GL_CLAMP_TO_EDGE);
}

static int tr_i_make_see_fbo(tr_context *tr, int index) {
    const tr_i_gl *gl = &tr->gl;
    int attached[2];
    tr_i_u color;
    tr_i_see_attached(index, attached);
    gl->GenFramebuffers(1, &tr->see.fbos[index]);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->see.fbos[index]);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, tr->see.fbos[index]);
    color = attached[0] >= 0 ? TR_I_GL_COLOR_ATTACHMENT0 : 0; /* GL_NONE */
    if (color)
        gl->FramebufferTexture2D(TR_I_GL_DRAW_FRAMEBUFFER, color, TR_I_GL_TEXTURE_2D, tr->see.textures[attached[0]], 0);
    if (attached[1] >= 0)
        gl->FramebufferTexture2D(TR_I_GL_DRAW_FRAMEBUFFER,
                                 attached[1] >= TR_I_SEE_TARGET_DEPTH && tr_i_depths[tr->see.held_depth].stencil
                                     ? TR_I_GL_DEPTH_STENCIL_ATTACHMENT
                                     : TR_I_GL_DEPTH_ATTACHMENT,
                                 TR_I_GL_TEXTURE_2D, tr->see.textures[attached[1]], 0);
    gl->DrawBuffers(1, &color);
    gl->ReadBuffer(color);
    return gl->CheckFramebufferStatus(TR_I_GL_DRAW_FRAMEBUFFER) == TR_I_GL_FRAMEBUFFER_COMPLETE;
}

/* The ring that queries are read through, and room for their answers. */
static tr_result tr_i_make_queries(tr_context *tr) {
    tr_i_see *see = &tr->see;
    size_t room = (TR_I_MAX_UNIT_ID + 1) * sizeof see->answer[0];
    int i;
    if (!see->answer)
        see->answer = (tr_i_answer *)tr->desc.alloc_fn(room, tr->desc.alloc_user);
    if (!see->answer)
        return tr_i_fail(&tr->desc, TR_OUT_OF_MEMORY, "dynamic.query");
    memset(see->answer, 0, room);
    for (i = 0; i < TR_I_QUERY_RING; ++i) {
        tr->gl.GenBuffers(1, &see->queries[i].buffer);
        tr->gl.BindBuffer(TR_I_GL_PIXEL_PACK_BUFFER, see->queries[i].buffer);
        tr->gl.BufferData(TR_I_GL_PIXEL_PACK_BUFFER,
                          (ptrdiff_t)tr_i_see_weight(TR_I_SEE_QUERY, 0, see->width, see->height, see->divisor), 0,
                          TR_I_GL_STREAM_READ);
    }
    return TR_OK;
}

static int tr_i_lacks_queries(const tr_i_see *see) {
    return ((tr_i_see_needs(see) >> TR_I_SEE_QUERY) & 1u) && (!see->queries[0].buffer || !see->answer);
}

/* Whether textures of another size, divisor or encoding are held. */
static int tr_i_see_misfits(const tr_context *tr) {
    const tr_i_see *see = &tr->see;
    int srgb = (tr->frame.wishes.options & TR_WISH_SRGB) != 0;
    return see->width != tr->frame.width || see->height != tr->frame.height || see->divisor != see->law.divisor ||
           see->srgb != srgb || (see->plan.in_parts && see->held_depth != see->host_depth);
}

static tr_result tr_i_make_see_textures(tr_context *tr) {
    tr_i_see *see = &tr->see;
    uint32_t needs = tr_i_see_needs(see);
    int i;
    if (tr_i_see_misfits(tr))
        tr_i_drop_see_textures(tr);
    see->width = tr->frame.width;
    see->height = tr->frame.height;
    see->divisor = see->law.divisor;
    see->held_depth = see->plan.in_parts ? see->host_depth : see->held_depth;
    see->srgb = (tr->frame.wishes.options & TR_WISH_SRGB) != 0;
    tr->gl.BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, 0);
    tr->gl.ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + TR_I_SCENE_DEPTH));
    for (i = 0; i < TR_I_SEE_TEXTURE_COUNT; ++i)
        if (((needs >> i) & 1u) && !see->textures[i])
            tr_i_make_see_texture(tr, i);
    for (i = 0; i < see->plan.pass_count; ++i) {
        int fbo = tr_i_see_fbo_of(see, i);
        if (fbo < 0 || see->fbos[fbo] || tr_i_make_see_fbo(tr, fbo))
            continue;
        tr_i_drop_see_textures(tr);
        return tr_i_fail(&tr->desc, TR_TARGET_INCOMPLETE, "one of the header's own");
    }
    return TR_OK;
}

TR_I_API tr_result tr_release(tr_context *tr) {
    if (!tr)
        return TR_INVALID_ARGUMENT;
    if (tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_release");
    tr_i_drop_textures(tr);
    tr_i_drop_edges(tr);
    tr_i_drop_outlines(tr);
    tr_i_drop_see(tr);
    return TR_OK;
}

TR_I_API void tr_destroy(tr_context *tr) {
    int i;
    if (!tr)
        return;
    tr_i_drop_textures(tr);
    tr->gl.DeleteTextures(1, &tr->textures[TR_I_CROSSINGS]);
    tr_i_drop_edges(tr);
    tr_i_drop_outlines(tr);
    tr_i_drop_see(tr);
    for (i = 0; i < TR_I_PROGRAM_COUNT; ++i)
        if (tr->programs[i].name)
            tr->gl.DeleteProgram(tr->programs[i].name);
    if (tr->vertex_array)
        tr->gl.DeleteVertexArrays(1, &tr->vertex_array);
    if (tr->uniform_buffer)
        tr->gl.DeleteBuffers(1, &tr->uniform_buffer);
    if (tr->see.buffer)
        tr->gl.DeleteBuffers(1, &tr->see.buffer);
    tr->desc.free_fn(tr, tr->desc.alloc_user);
}

TR_I_API tr_info tr_get_info(const tr_context *tr) {
    tr_info info;
    int i;
    memset(&info, 0, sizeof info);
    if (!tr)
        return info;
    info.es = tr->es;
    info.version = tr->version;
    info.plan = &tr->plan;
    info.see_plan = &tr->see.plan;
    info.bytes = tr_i_see_bytes(tr) + tr_i_seq_bytes(&tr->seq, tr_i_seq_held(&tr->seq), tr->seq.extent);
    if (tr->textures[TR_I_CROSSINGS])
        info.bytes += (uint64_t)tr->slices[TR_I_CROSSINGS] * TR_I_CROSSING_ROW * 16u;
    for (i = 0; i < TR_I_TEXTURE_COUNT; ++i)
        if (tr->textures[i] && i != TR_I_CROSSINGS)
            info.bytes += (uint64_t)tr->width * (uint64_t)tr->height * (uint64_t)tr->slices[i] * tr_i_texel_bytes(i);
    info.bytes += (uint64_t)tr->outline_width * (uint64_t)tr->outline_height * 8u;
    info.bytes += (uint64_t)tr->edge_rows[TR_I_EDGE_SEGMENTS] * TR_I_EDGE_ROW * 16u;
    info.bytes += (uint64_t)tr->edge_rows[TR_I_EDGE_LISTS] * TR_I_EDGE_ROW * 4u;
    return info;
}

/* ---- where surfaces cross --------------------------------------------------------------------------------------- */

typedef struct tr_i_triangle {
    double v[3][3], low[3], high[3];
} tr_i_triangle;

/* 0: an index is out of range or a number not finite. */
static int tr_i_take_triangle(const tr_mesh *mesh, size_t index, tr_i_triangle *t) {
    static const float zero[16] = {0};
    int moved = memcmp(mesh->model, zero, sizeof zero) != 0, i, k;
    for (i = 0; i < 3; ++i) {
        uint32_t vertex = mesh->indices[3 * index + (size_t)i];
        const float *p = mesh->positions + 3 * (size_t)vertex, *m = mesh->model;
        if (vertex >= mesh->vertex_count || !tr_i_all_finite(p, 3))
            return 0;
        for (k = 0; k < 3; ++k) {
            t->v[i][k] = moved ? (double)m[k] * (double)p[0] + (double)m[4 + k] * (double)p[1] +
                                     (double)m[8 + k] * (double)p[2] + (double)m[12 + k]
                               : (double)p[k];
            t->low[k] = i && t->low[k] < t->v[i][k] ? t->low[k] : t->v[i][k];
            t->high[k] = i && t->high[k] > t->v[i][k] ? t->high[k] : t->v[i][k];
        }
    }
    return 1;
}

static double tr_i_dot3(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void tr_i_cross3(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static void tr_i_normal3(const tr_i_triangle *t, double out[3]) {
    double e[2][3];
    int k;
    for (k = 0; k < 3; ++k) {
        e[0][k] = t->v[1][k] - t->v[0][k];
        e[1][k] = t->v[2][k] - t->v[0][k];
    }
    tr_i_cross3(e[0], e[1], out);
}

/* The two points where a triangle meets the plane through `point`; 0 where it lies on one side. A vertex on the plane
   counts as before it, so that neighbours agree. */
static int tr_i_cut(const tr_i_triangle *t, const double normal[3], const double point[3], double out[2][3]) {
    double d[3], from[3];
    int i, k, lone;
    for (i = 0; i < 3; ++i) {
        for (k = 0; k < 3; ++k)
            from[k] = t->v[i][k] - point[k];
        d[i] = tr_i_dot3(normal, from);
    }
    if ((d[0] >= 0) == (d[1] >= 0) && (d[1] >= 0) == (d[2] >= 0))
        return 0;
    lone = (d[0] >= 0) == (d[1] >= 0) ? 2 : (d[0] >= 0) == (d[2] >= 0) ? 1 : 0;
    for (i = 0; i < 2; ++i) {
        int other = (lone + 1 + i) % 3;
        double share = d[lone] / (d[lone] - d[other]); /* of unlike sign, one not 0 */
        for (k = 0; k < 3; ++k)
            out[i][k] = t->v[lone][k] + share * (t->v[other][k] - t->v[lone][k]);
    }
    return 1;
}

/* Both triangles meet the line of their planes in an interval; where these overlap they cross (Moeller 1997). */
static int tr_i_cross_triangles(const tr_i_triangle *a, const tr_i_triangle *b, float out[6]) {
    double normals[2][3], along[3], cuts[2][2][3], at[2][2];
    int i, k, first, last;
    tr_i_normal3(a, normals[0]);
    tr_i_normal3(b, normals[1]);
    if (!tr_i_cut(a, normals[1], b->v[0], cuts[0]) || !tr_i_cut(b, normals[0], a->v[0], cuts[1]))
        return 0;
    tr_i_cross3(normals[0], normals[1], along);
    for (i = 0; i < 2; ++i) {
        for (k = 0; k < 2; ++k)
            at[i][k] = tr_i_dot3(along, cuts[i][k]);
        if (at[i][0] > at[i][1]) {
            double swap = at[i][0];
            at[i][0] = at[i][1];
            at[i][1] = swap;
            for (k = 0; k < 3; ++k) {
                swap = cuts[i][0][k];
                cuts[i][0][k] = cuts[i][1][k];
                cuts[i][1][k] = swap;
            }
        }
    }
    first = at[0][0] >= at[1][0] ? 0 : 1;
    last = at[0][1] <= at[1][1] ? 0 : 1;
    if (!(at[first][0] < at[last][1]))
        return 0;
    for (k = 0; k < 3; ++k) {
        out[k] = (float)cuts[first][0][k];
        out[3 + k] = (float)cuts[last][1][k];
    }
    return tr_i_all_finite(out, 6);
}

/* A triangle by its extent along x. high: the farthest extent of it and all before it in the order. */
typedef struct tr_i_extent {
    double low, high;
    uint32_t triangle;
} tr_i_extent;

static void tr_i_sift(tr_i_extent *heap, size_t root, size_t count) {
    for (;;) {
        size_t child = 2 * root + 1;
        tr_i_extent swap = heap[root];
        if (child >= count)
            return;
        if (child + 1 < count && heap[child + 1].low > heap[child].low)
            ++child;
        if (!(heap[child].low > swap.low))
            return;
        heap[root] = heap[child];
        heap[child] = swap;
        root = child;
    }
}

/* The triangles of a mesh that can be used, by where they begin along x. */
static size_t tr_i_sort_extents(const tr_mesh *mesh, tr_i_extent *extents) {
    size_t count = 0, i;
    for (i = 0; i < mesh->index_count / 3; ++i) {
        tr_i_triangle t;
        if (!tr_i_take_triangle(mesh, i, &t))
            continue;
        extents[count].low = t.low[0];
        extents[count].high = t.high[0];
        extents[count++].triangle = (uint32_t)i;
    }
    for (i = count / 2; i-- > 0;)
        tr_i_sift(extents, i, count);
    for (i = count; i-- > 1;) {
        tr_i_extent swap = extents[0];
        extents[0] = extents[i];
        extents[i] = swap;
        tr_i_sift(extents, 0, i);
    }
    for (i = 1; i < count; ++i)
        if (extents[i].high < extents[i - 1].high)
            extents[i].high = extents[i - 1].high;
    return count;
}

/* The first extent that may reach `x`: high never falls along the order. */
static size_t tr_i_first_reaching(const tr_i_extent *extents, size_t count, double x) {
    size_t low = 0;
    while (low < count) {
        size_t middle = low + (count - low) / 2;
        if (extents[middle].high < x)
            low = middle + 1;
        else
            count = middle;
    }
    return low;
}

static int tr_i_mesh_is_valid(const tr_mesh *mesh) {
    return ((mesh->positions && mesh->indices) || mesh->index_count < 3) && tr_i_all_finite(mesh->model, 16);
}

TR_I_API size_t tr_crossings(const tr_mesh *mesh, const tr_mesh *others, size_t other_count, float *segments,
                             size_t capacity) {
    size_t found = 0, o, i, k;
    if (!mesh || (!others && other_count) || !tr_i_mesh_is_valid(mesh))
        return (size_t)-1;
    for (o = 0; o < other_count; ++o) {
        size_t triangles = others[o].index_count / 3, count;
        tr_i_extent *extents;
        if (!tr_i_mesh_is_valid(&others[o]) || triangles > 0xffffffffu / sizeof *extents)
            return (size_t)-1;
        extents = triangles ? (tr_i_extent *)TR_MALLOC(triangles * sizeof *extents) : 0;
        if (!extents && triangles)
            return (size_t)-1;
        count = triangles ? tr_i_sort_extents(&others[o], extents) : 0;
        for (i = 0; i < mesh->index_count / 3; ++i) {
            tr_i_triangle a, b;
            if (!tr_i_take_triangle(mesh, i, &a))
                continue;
            for (k = tr_i_first_reaching(extents, count, a.low[0]); k < count && extents[k].low <= a.high[0]; ++k) {
                float segment[6];
                tr_i_take_triangle(&others[o], extents[k].triangle, &b);
                if (a.low[1] > b.high[1] || b.low[1] > a.high[1] || a.low[2] > b.high[2] || b.low[2] > a.high[2] ||
                    a.low[0] > b.high[0] || !tr_i_cross_triangles(&a, &b, segment))
                    continue;
                if (segments && found < capacity)
                    memcpy(segments + 6 * found, segment, sizeof segment);
                ++found;
            }
        }
        if (extents)
            TR_FREE(extents);
    }
    return found;
}

/* Pixel storage and bindings that an upload depends on: set to plain values, or put back. */
static void tr_i_pixel_storage(const tr_context *tr, int32_t saved[8], int restore) {
    static const tr_i_u names[5] = {TR_I_GL_UNPACK_ALIGNMENT, TR_I_GL_UNPACK_ROW_LENGTH, TR_I_GL_UNPACK_SKIP_PIXELS,
                                    TR_I_GL_UNPACK_SKIP_ROWS, TR_I_GL_UNPACK_SWAP_BYTES};
    tr_i_u unit = TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + TR_I_CROSSINGS);
    int i, count = tr->es ? 4 : 5;
    if (!restore) {
        tr->gl.GetIntegerv(TR_I_GL_ACTIVE_TEXTURE, &saved[5]);
        tr->gl.ActiveTexture(unit);
        tr->gl.GetIntegerv(TR_I_GL_TEXTURE_BINDING_2D, &saved[6]);
        tr->gl.GetIntegerv(TR_I_GL_PIXEL_UNPACK_BUFFER_BINDING, &saved[7]);
        tr->gl.BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, 0);
    }
    for (i = 0; i < count; ++i) {
        if (!restore)
            tr->gl.GetIntegerv(names[i], &saved[i]);
        tr->gl.PixelStorei(names[i], restore ? saved[i] : i == 0 ? 4 : 0);
    }
    if (restore) {
        tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, (tr_i_u)saved[6]);
        tr->gl.ActiveTexture((tr_i_u)saved[5]);
        tr->gl.BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, (tr_i_u)saved[7]);
    }
}

/* Ends of segments as texels, a row at a time. */
static void tr_i_upload_crossings(const tr_context *tr, const float *segments, size_t ends) {
    float texels[TR_I_CROSSING_ROW][4];
    size_t first, i;
    memset(texels, 0, sizeof texels);
    for (first = 0; first < ends; first += TR_I_CROSSING_ROW) {
        size_t wide = ends - first < TR_I_CROSSING_ROW ? ends - first : TR_I_CROSSING_ROW;
        for (i = 0; i < wide; ++i)
            memcpy(texels[i], segments + 3 * (first + i), 3 * sizeof(float));
        tr->gl.TexSubImage2D(TR_I_GL_TEXTURE_2D, 0, 0, (int32_t)(first / TR_I_CROSSING_ROW), (int32_t)wide, 1,
                             TR_I_GL_RGBA, TR_I_GL_FLOAT, texels);
    }
}

/* Room for so many rows: a quarter more when it grows, given back when three quarters are not used. */
static void tr_i_fit_crossings(tr_context *tr, size_t rows) {
    size_t held = (size_t)tr->slices[TR_I_CROSSINGS], most = (size_t)tr->max_texture;
    int made = tr->textures[TR_I_CROSSINGS] != 0;
    if (!made)
        tr->gl.GenTextures(1, &tr->textures[TR_I_CROSSINGS]);
    tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, tr->textures[TR_I_CROSSINGS]);
    if (made && rows <= held && (rows + 1) * 4 >= held)
        return;
    rows = rows + rows / 4 < most ? rows + rows / 4 : most;
    tr->gl.TexImage2D(TR_I_GL_TEXTURE_2D, 0, (int32_t)TR_I_GL_RGBA32F, TR_I_CROSSING_ROW, (int32_t)rows, 0,
                      TR_I_GL_RGBA, TR_I_GL_FLOAT, 0);
    tr->gl.TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MIN_FILTER, TR_I_GL_NEAREST);
    tr->gl.TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MAG_FILTER, TR_I_GL_NEAREST);
    tr->slices[TR_I_CROSSINGS] = (int)rows;
}

TR_I_API tr_result tr_set_crossings(tr_context *tr, const float *segments, size_t count) {
    size_t rows;
    int32_t saved[8];
    if (!tr)
        return TR_INVALID_ARGUMENT;
    if (!segments && count)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "tr_set_crossings: segments");
    if (tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_set_crossings");
    if (count > (size_t)tr->max_texture * (TR_I_CROSSING_ROW / 2))
        return tr_i_fail(&tr->desc, TR_TOO_LARGE, "tr_set_crossings");
    rows = (2 * count + TR_I_CROSSING_ROW - 1) / TR_I_CROSSING_ROW;
    tr_i_pixel_storage(tr, saved, 0);
    tr_i_fit_crossings(tr, rows ? rows : 1);
    tr_i_upload_crossings(tr, segments, 2 * count);
    tr_i_pixel_storage(tr, saved, 1);
    return TR_OK;
}

/* ---- textures and framebuffers ---------------------------------------------------------------------------------- */

typedef struct tr_i_attachment {
    int texture, slice; /* texture -1: none */
} tr_i_attachment;

/* What is attached to a framebuffer: depth, then up to two colours. */
static void tr_i_attachments_of(int fbo, tr_i_attachment out[3]) {
    int layer = fbo % TR_MAX_LAYERS, depth = layer & 1 ? TR_I_ODD_DEPTH : TR_I_FRONT_DEPTH, i;
    for (i = 0; i < 3; ++i) {
        out[i].texture = -1;
        out[i].slice = i == 0 ? layer / 2 : 0;
    }
    if (fbo >= TR_I_FBO_LIMIT) {
        out[0].texture = fbo == TR_I_FBO_COPY ? TR_I_DEPTH_COPY : TR_I_SCENE_DEPTH;
        out[0].slice = 0;
        out[1].texture = fbo == TR_I_FBO_OPAQUE ? TR_I_OPAQUE_COLOR : -1;
        return;
    }
    out[0].texture = depth;
    out[1].slice = layer;
    if (fbo >= TR_I_FBO_ALONE)
        out[1].texture = TR_I_LAYER_COLOR;
    if (fbo >= TR_I_FBO_LAYER) {
        out[0].texture = TR_I_FRONT_OWNER;
        out[0].slice = fbo >= TR_I_FBO_GROUP ? layer : 0;
    }
    if (fbo == TR_I_FBO_GROUP)
        out[2].texture = TR_I_MARK;
}

static int tr_i_fbo_of(const tr_plan_pass *pass) {
    switch (pass->kind) {
    case TR_PASS_FRONT:
    case TR_PASS_PEEL:
        return pass->layer + (pass->rule == TR_RULE_FRONT_ALONE || pass->rule == TR_RULE_PEEL_ALONE ? TR_I_FBO_ALONE
                                                                                                    : TR_I_FBO_DEPTH);
    case TR_PASS_LAYER:
        return pass->layer + (pass->rule == TR_RULE_LAYER ? TR_I_FBO_LAYER : TR_I_FBO_GROUP);
    case TR_PASS_LIMIT:
        return TR_I_FBO_LIMIT;
    case TR_PASS_OPAQUE:
    case TR_PASS_OPAQUE_LINES:
    case TR_PASS_TAKE_OPAQUE:
        return TR_I_FBO_OPAQUE;
    case TR_PASS_COPY_DEPTH:
        return TR_I_FBO_COPY;
    default:
        return -1; /* the host's target */
    }
}

static void tr_i_make_texture(tr_context *tr, int index, int slices) {
    const tr_i_gl *gl = &tr->gl;
    int unit = index == TR_I_DEPTH_COPY ? TR_I_SCENE_DEPTH : index;
    int color = index == TR_I_OPAQUE_COLOR || index == TR_I_LAYER_COLOR, mark = index == TR_I_MARK;
    tr_i_u target = tr_i_targets[unit];
    tr_i_u internal = color ? TR_I_GL_RGBA8 : mark ? TR_I_GL_R8 : TR_I_GL_DEPTH_COMPONENT32F;
    tr_i_u format = color ? TR_I_GL_RGBA : mark ? TR_I_GL_RED : TR_I_GL_DEPTH_COMPONENT;
    tr_i_u type = color || mark ? TR_I_GL_UNSIGNED_BYTE : TR_I_GL_FLOAT;
    gl->ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + unit));
    gl->GenTextures(1, &tr->textures[index]);
    gl->BindTexture(target, tr->textures[index]);
    if (target == TR_I_GL_TEXTURE_2D)
        gl->TexImage2D(target, 0, (int32_t)internal, tr->width, tr->height, 0, format, type, 0);
    else
        gl->TexImage3D(target, 0, (int32_t)internal, tr->width, tr->height, slices, 0, format, type, 0);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_MIN_FILTER, TR_I_GL_NEAREST);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_MAG_FILTER, TR_I_GL_NEAREST);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_WRAP_S, TR_I_GL_CLAMP_TO_EDGE);
    gl->TexParameteri(target, TR_I_GL_TEXTURE_WRAP_T, TR_I_GL_CLAMP_TO_EDGE);
    tr->slices[index] = slices;
}

static void tr_i_attach(const tr_context *tr, tr_i_u point, tr_i_attachment a) {
    if (tr_i_targets[a.texture == TR_I_DEPTH_COPY ? TR_I_SCENE_DEPTH : a.texture] == TR_I_GL_TEXTURE_2D)
        tr->gl.FramebufferTexture2D(TR_I_GL_DRAW_FRAMEBUFFER, point, TR_I_GL_TEXTURE_2D, tr->textures[a.texture], 0);
    else
        tr->gl.FramebufferTextureLayer(TR_I_GL_DRAW_FRAMEBUFFER, point, tr->textures[a.texture], 0, a.slice);
}

static int tr_i_make_fbo(tr_context *tr, int index) {
    const tr_i_gl *gl = &tr->gl;
    tr_i_attachment attached[3];
    tr_i_u buffers[2];
    int i;
    tr_i_attachments_of(index, attached);
    gl->GenFramebuffers(1, &tr->fbos[index]);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->fbos[index]);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, tr->fbos[index]);
    tr_i_attach(tr, TR_I_GL_DEPTH_ATTACHMENT, attached[0]);
    for (i = 0; i < 2; ++i) {
        tr_i_u point = TR_I_GL_COLOR_ATTACHMENT0 + (tr_i_u)i;
        buffers[i] = attached[i + 1].texture >= 0 ? point : 0;
        if (buffers[i])
            tr_i_attach(tr, point, attached[i + 1]);
    }
    gl->DrawBuffers(buffers[1] ? 2 : 1, buffers);
    gl->ReadBuffer(buffers[0]);
    return gl->CheckFramebufferStatus(TR_I_GL_DRAW_FRAMEBUFFER) == TR_I_GL_FRAMEBUFFER_COMPLETE;
}

/* Whether a texture of the plan is missing, or an array too short. */
static int tr_i_lacks(const tr_context *tr, int texture) {
    return ((tr->plan.textures >> texture) & 1u) &&
           (!tr->textures[texture] || tr->slices[texture] < tr_i_slices_of(&tr->plan, texture));
}

/* Arrays that are too short go, with what they are attached to, as all go when the size changes. */
static void tr_i_drop_misfits(tr_context *tr, int width, int height) {
    int i, misfit = tr->width != width || tr->height != height;
    for (i = 0; i < TR_I_TEXTURE_COUNT; ++i)
        misfit = misfit || (tr->textures[i] && tr_i_lacks(tr, i));
    if (misfit)
        tr_i_drop_textures(tr);
    tr->width = width;
    tr->height = height;
}

/* glTexImage may fail for want of memory; then a framebuffer is not complete, and all textures are given back. */
static tr_result tr_i_make_textures(tr_context *tr) {
    int i;
    tr_i_drop_misfits(tr, tr->frame.width * tr->plan.supersample, tr->frame.height * tr->plan.supersample);
    tr->gl.BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, 0);
    for (i = 0; i < TR_I_TEXTURE_COUNT; ++i)
        if (tr_i_lacks(tr, i))
            tr_i_make_texture(tr, i, tr_i_slices_of(&tr->plan, i));
    for (i = 0; i < tr->plan.pass_count; ++i) {
        int fbo = tr_i_fbo_of(&tr->plan.passes[i]);
        if (fbo < 0 || tr->fbos[fbo] || tr_i_make_fbo(tr, fbo))
            continue;
        tr_i_drop_textures(tr);
        return tr_i_fail(&tr->desc, TR_TARGET_INCOMPLETE, "one of the header's own");
    }
    return TR_OK;
}

/* ---- edges for alpha -------------------------------------------------------------------------------------------- */

/* Two textures serve as arrays, in rows of 1024 texels, for ES 3.0 has no buffer textures: RGBA32F for segments (two texels
   each) and the boxes around them (two each), R32UI for lists. Of one object the segments come first, then the boxes,
   each before its children; in the lists the offsets of its triangles, then their candidates. */

/* What an array is written through: consecutive texels from `at` on, gathered on the way. */
#define TR_I_GATHERED 1024u
typedef struct tr_i_writer {
    const tr_context *tr;
    size_t at, count;
    float texels[TR_I_GATHERED][4];
} tr_i_writer;

static void tr_i_upload_texels(const tr_context *tr, int index, size_t at, size_t count, const void *data) {
    const char *from = (const char *)data;
    size_t texel = index == TR_I_EDGE_SEGMENTS ? 16 : 4;
    tr_i_u format = index == TR_I_EDGE_SEGMENTS ? TR_I_GL_RGBA : TR_I_GL_RED_INTEGER;
    tr_i_u type = index == TR_I_EDGE_SEGMENTS ? TR_I_GL_FLOAT : TR_I_GL_UNSIGNED_INT;
    while (count > 0) { /* to the end of the row, whole rows, the rest */
        size_t x = at % TR_I_EDGE_ROW, wide = TR_I_EDGE_ROW - x, rows = 1;
        if (x == 0 && count > wide)
            rows = count / wide;
        else if (wide > count)
            wide = count;
        tr->gl.TexSubImage2D(TR_I_GL_TEXTURE_2D, 0, (int32_t)x, (int32_t)(at / TR_I_EDGE_ROW), (int32_t)wide,
                             (int32_t)rows, format, type, from);
        at += wide * rows;
        from += wide * rows * texel;
        count -= wide * rows;
    }
}

static void tr_i_flush(tr_i_writer *writer) {
    tr_i_upload_texels(writer->tr, TR_I_EDGE_SEGMENTS, writer->at, writer->count, writer->texels);
    writer->at += writer->count;
    writer->count = 0;
}

static void tr_i_write(tr_i_writer *writer, const double xyz[3], double w) {
    float *texel = writer->texels[writer->count++];
    int i;
    for (i = 0; i < 3; ++i)
        texel[i] = (float)xyz[i];
    texel[3] = (float)w;
    if (writer->count == TR_I_GATHERED)
        tr_i_flush(writer);
}

/* The edge at a place: an index into `positions`, and that point. */
static const uint32_t *tr_i_edge_index(const tr_edges *edges, size_t place, int end) {
    size_t stride = edges->end_stride ? edges->end_stride : 2 * sizeof(uint32_t);
    size_t edge = edges->order ? edges->order[place] : place;
    return (const uint32_t *)(const void *)((const char *)edges->ends + edge * stride) + end;
}

static const float *tr_i_edge_end(const tr_edges *edges, size_t place, int end) {
    size_t stride = edges->position_stride ? edges->position_stride : 3 * sizeof(float);
    size_t point = *tr_i_edge_index(edges, place, end);
    return (const float *)(const void *)((const char *)edges->positions + point * stride);
}

/* Object space to a frame about the middle of the edges and of their size, so that neither an offset nor a unit costs
   precision or range: frame[0..8] the matrix by columns, then the middle and the unit. */
typedef struct tr_i_edge_frame {
    double matrix[9], middle[3], unit;
} tr_i_edge_frame;

static void tr_i_to_edge_frame(const tr_i_edge_frame *frame, const float p[3], double out[3]) {
    double d[3];
    int i;
    for (i = 0; i < 3; ++i)
        d[i] = (double)p[i] - frame->middle[i];
    for (i = 0; i < 3; ++i)
        out[i] = frame->matrix[i] * d[0] + frame->matrix[3 + i] * d[1] + frame->matrix[6 + i] * d[2];
}

static void tr_i_make_edge_frame(const tr_edges *edges, tr_i_edge_frame *frame) {
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300}, size = 0;
    size_t edge;
    int zero = 1, end, i, k;
    memset(frame, 0, sizeof *frame);
    for (edge = 0; edge < edges->edge_count; ++edge)
        for (end = 0; end < 2; ++end) {
            const float *p = tr_i_edge_end(edges, edge, end);
            for (k = 0; k < 3 && tr_i_all_finite(p, 3); ++k) {
                low[k] = (double)p[k] < low[k] ? (double)p[k] : low[k];
                high[k] = (double)p[k] > high[k] ? (double)p[k] : high[k];
            }
        }
    for (i = 0; i < 9; ++i)
        zero = zero && edges->model[i] == 0.0f;
    for (i = 0; i < 9; ++i)
        frame->matrix[i] = zero ? i % 4 == 0 : (double)edges->model[i];
    for (i = 0; i < 3 && low[0] <= high[0]; ++i) {
        double row = 0;
        for (k = 0; k < 3; ++k)
            row += fabs(frame->matrix[3 * k + i]) * (high[k] - low[k]);
        size = row > size ? row : size;
        frame->middle[i] = (double)(float)(0.5 * (low[i] + high[i])); /* as the shader has it */
    }
    (void)frexp(size, &k);
    k = k > 100 ? 100 : k < -100 ? -100 : k;
    frame->unit = size > 0 ? ldexp(1.0, k) : 1.0;
    for (i = 0; i < 9; ++i)
        frame->matrix[i] /= frame->unit;
}

/* Both ends; an edge that has none is put where it is nobody's nearest. */
static void tr_i_edge_ends(const tr_edges *edges, const tr_i_edge_frame *frame, size_t place, double p[3],
                           double q[3]) {
    const float *a = tr_i_edge_end(edges, place, 0), *b = tr_i_edge_end(edges, place, 1);
    if (tr_i_all_finite(a, 3) && tr_i_all_finite(b, 3)) {
        tr_i_to_edge_frame(frame, a, p);
        tr_i_to_edge_frame(frame, b, q);
        return;
    }
    p[0] = p[1] = p[2] = q[0] = q[1] = q[2] = 1e18;
}

static void tr_i_write_segments(tr_i_writer *writer, const tr_edges *edges, const tr_i_edge_frame *frame) {
    double p[3], q[3], square;
    size_t i;
    int k;
    for (i = 0; i < edges->edge_count; ++i) {
        tr_i_edge_ends(edges, frame, i, p, q);
        for (k = 0, square = 0; k < 3; ++k) {
            q[k] -= p[k];
            square += q[k] * q[k];
        }
        tr_i_write(writer, p, square > 1e-30 ? 1 / square : 0); /* shorter than 1e-15 of the whole: a point */
        tr_i_write(writer, q, 0);
    }
}

/* Boxes over `count` segments in a row: eight a leaf, and eight of a kind in a box of the next. */
static size_t tr_i_box_span(size_t count) {
    size_t span = 8;
    while (span < count)
        span *= 8;
    return span / 8; /* segments of a child */
}

static size_t tr_i_box_count(size_t count) {
    size_t span = tr_i_box_span(count), rest;
    if (count <= 8)
        return count > 0;
    rest = count % span;
    return 1 + count / span * tr_i_box_count(span) + tr_i_box_count(rest);
}

/* The box of segments first .. first + count - 1, then all in it. `box` is its number. */
static void tr_i_write_boxes(tr_i_writer *writer, const tr_edges *edges, const tr_i_edge_frame *frame, size_t first,
                             size_t count, size_t box) {
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300}, ends[2][3];
    size_t span = tr_i_box_span(count), i;
    int k, end;
    for (i = first; i < first + count; ++i) {
        tr_i_edge_ends(edges, frame, i, ends[0], ends[1]);
        for (end = 0; end < 2; ++end)
            for (k = 0; k < 3; ++k) {
                low[k] = ends[end][k] < low[k] ? ends[end][k] : low[k];
                high[k] = ends[end][k] > high[k] ? ends[end][k] : high[k];
            }
    }
    for (k = 0; k < 3; ++k) {
        ends[0][k] = 0.5 * (low[k] + high[k]);
        ends[1][k] = 0.5 * (high[k] - low[k]) * 1.000001 + 1e-6 * fabs(ends[0][k]); /* rounded to floats outward */
    }
    tr_i_write(writer, ends[0], (double)(box + tr_i_box_count(count)));
    tr_i_write(writer, ends[1], count <= 8 ? (double)first : -1.0);
    ++box;
    for (i = 0; count > 8 && i < count; i += span) {
        size_t child = count - i < span ? count - i : span;
        tr_i_write_boxes(writer, edges, frame, first + i, child, box);
        box += tr_i_box_count(child);
    }
}

static const char *tr_i_check_edges(const tr_edges *edges) {
    size_t i;
    if ((edges->edge_count && (!edges->positions || !edges->ends)) || !edges->offsets != !edges->candidates ||
        (edges->order && edges->offsets))
        return "tr_edges: an array is missing, or there are both order and offsets";
    if ((edges->position_stride && edges->position_stride < 3 * sizeof(float)) ||
        (edges->end_stride && edges->end_stride < 2 * sizeof(uint32_t)) || edges->position_stride % sizeof(float) ||
        edges->end_stride % sizeof(uint32_t))
        return "tr_edges: a stride is too small, or no multiple of 4";
    if (!tr_i_all_finite(edges->model, 9))
        return "tr_edges.model is not finite";
    for (i = 0; i < 2 * edges->edge_count; ++i)
        if (*tr_i_edge_index(edges, i / 2, (int)(i % 2)) >= edges->position_count)
            return "tr_edges.ends: a point past position_count";
    for (i = 0; edges->offsets && i < edges->triangle_count; ++i)
        if (edges->offsets[i] > edges->offsets[i + 1])
            return "tr_edges.offsets fall";
    for (i = edges->offsets ? edges->offsets[0] : 0; edges->offsets && i < edges->offsets[edges->triangle_count]; ++i)
        if (edges->candidates[i] >= edges->edge_count)
            return "tr_edges.candidates: an edge past edge_count";
    return 0;
}

/* Texels that an object needs in each array. The hierarchy is for sets without lists. */
static void tr_i_edge_texels(const tr_edges *edges, size_t texels[TR_I_EDGE_TEXTURE_COUNT]) {
    texels[TR_I_EDGE_SEGMENTS] = 2 * (edges->edge_count + (edges->offsets ? 0 : tr_i_box_count(edges->edge_count)));
    texels[TR_I_EDGE_LISTS] =
        edges->offsets ? edges->triangle_count + 1 + (size_t)edges->offsets[edges->triangle_count] : 0;
}

/* An array of at least so many texels; a quarter more when it grows, given back when three quarters are not used. */
static void tr_i_fit_array(tr_context *tr, int index, size_t texels) {
    size_t rows = (texels + TR_I_EDGE_ROW - 1) / TR_I_EDGE_ROW, most = (size_t)tr->max_texture;
    tr_i_u internal = index == TR_I_EDGE_SEGMENTS ? TR_I_GL_RGBA32F : TR_I_GL_R32UI;
    tr_i_u format = index == TR_I_EDGE_SEGMENTS ? TR_I_GL_RGBA : TR_I_GL_RED_INTEGER;
    tr_i_u type = index == TR_I_EDGE_SEGMENTS ? TR_I_GL_FLOAT : TR_I_GL_UNSIGNED_INT;
    if (index == TR_I_EDGE_SEGMENTS && rows == 0)
        rows = 1;
    if (rows <= tr->edge_rows[index] && (rows + 1) * 4 >= tr->edge_rows[index] && rows > 0) {
        tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, tr->edge_textures[index]);
        return;
    }
    if (tr->edge_textures[index])
        tr->gl.DeleteTextures(1, &tr->edge_textures[index]);
    tr->edge_textures[index] = 0;
    tr->edge_rows[index] = 0;
    if (rows == 0)
        return;
    rows = rows + rows / 4 < most ? rows + rows / 4 : most;
    tr->gl.GenTextures(1, &tr->edge_textures[index]);
    tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, tr->edge_textures[index]);
    tr->gl.TexImage2D(TR_I_GL_TEXTURE_2D, 0, (int32_t)internal, (int32_t)TR_I_EDGE_ROW, (int32_t)rows, 0, format, type,
                      0);
    tr->gl.TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MIN_FILTER, TR_I_GL_NEAREST);
    tr->gl.TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MAG_FILTER, TR_I_GL_NEAREST);
    tr->edge_rows[index] = rows;
}

static void tr_i_fill_edge_set(const tr_edges *edges, const tr_i_edge_frame *frame, const size_t at[2],
                               tr_edge_set *set) {
    int i;
    memset(set, 0, sizeof *set);
    for (i = 0; i < 9; ++i)
        set->frame[i / 3 * 4 + i % 3] = (float)frame->matrix[i];
    for (i = 0; i < 3; ++i)
        set->frame[12 + i] = (float)frame->middle[i];
    set->frame[15] = (float)frame->unit;
    set->ranges[0] = (uint32_t)at[TR_I_EDGE_SEGMENTS];
    set->ranges[1] = (uint32_t)edges->edge_count;
    set->ranges[2] = edges->offsets ? (uint32_t)at[TR_I_EDGE_LISTS] : (uint32_t)tr_i_box_count(edges->edge_count);
    set->ranges[3] = edges->offsets ? (uint32_t)(at[TR_I_EDGE_LISTS] + edges->triangle_count + 1) : TR_I_NO_LIST;
}

static void tr_i_upload_edges(tr_context *tr, const tr_edges *edges, size_t count, tr_edge_set *sets) {
    size_t at[TR_I_EDGE_TEXTURE_COUNT] = {0, 0}, texels[TR_I_EDGE_TEXTURE_COUNT], i;
    tr_i_writer writer;
    tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, tr->edge_textures[TR_I_EDGE_SEGMENTS]);
    writer.tr = tr;
    writer.at = writer.count = 0;
    for (i = 0; i < count; ++i) {
        tr_i_edge_frame frame;
        tr_i_make_edge_frame(&edges[i], &frame);
        tr_i_fill_edge_set(&edges[i], &frame, at, &sets[i]);
        tr_i_write_segments(&writer, &edges[i], &frame);
        if (!edges[i].offsets && edges[i].edge_count)
            tr_i_write_boxes(&writer, &edges[i], &frame, 0, edges[i].edge_count, 0);
        tr_i_edge_texels(&edges[i], texels);
        at[TR_I_EDGE_SEGMENTS] += texels[TR_I_EDGE_SEGMENTS];
        at[TR_I_EDGE_LISTS] += texels[TR_I_EDGE_LISTS];
    }
    tr_i_flush(&writer);
    if (tr->edge_textures[TR_I_EDGE_LISTS])
        tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, tr->edge_textures[TR_I_EDGE_LISTS]);
    for (i = 0; i < count; ++i) {
        size_t offsets = edges[i].triangle_count + 1;
        if (!edges[i].offsets)
            continue;
        tr_i_upload_texels(tr, TR_I_EDGE_LISTS, sets[i].ranges[2], offsets, edges[i].offsets);
        tr_i_upload_texels(tr, TR_I_EDGE_LISTS, sets[i].ranges[3], edges[i].offsets[offsets - 1], edges[i].candidates);
    }
}

TR_I_API tr_result tr_set_edges(tr_context *tr, const tr_edges *edges, size_t count, tr_edge_set *sets) {
    size_t total[TR_I_EDGE_TEXTURE_COUNT] = {0, 0}, i;
    int32_t saved[8];
    if (!tr || (count && (!edges || !sets)))
        return TR_INVALID_ARGUMENT;
    if (tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_set_edges");
    for (i = 0; i < count; ++i) {
        size_t texels[TR_I_EDGE_TEXTURE_COUNT], most = (size_t)tr->max_texture * TR_I_EDGE_ROW, k;
        const char *wrong = tr_i_check_edges(&edges[i]);
        if (wrong)
            return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, wrong);
        if (edges[i].edge_count > most) /* before anything can overflow */
            return tr_i_fail(&tr->desc, TR_TOO_LARGE, "tr_set_edges: edges");
        tr_i_edge_texels(&edges[i], texels);
        for (k = 0; k < TR_I_EDGE_TEXTURE_COUNT; ++k) {
            total[k] += texels[k];
            if (texels[k] > most || total[k] > most)
                return tr_i_fail(&tr->desc, TR_TOO_LARGE,
                                 k == TR_I_EDGE_SEGMENTS ? "tr_set_edges: edges" : "tr_set_edges: candidates");
        }
    }
    if (count == 0) {
        tr_i_drop_edges(tr);
        return TR_OK;
    }
    tr_i_pixel_storage(tr, saved, 0);
    for (i = 0; i < TR_I_EDGE_TEXTURE_COUNT; ++i)
        tr_i_fit_array(tr, (int)i, total[i]);
    tr_i_upload_edges(tr, edges, count, sets);
    tr_i_pixel_storage(tr, saved, 1);
    return TR_OK;
}

/* ---- the sequence ----------------------------------------------------------------------------------------------- */

static void tr_i_line_variant(const tr_context *tr, const tr_plan_pass *pass, tr_i_variant *v) {
    int opaque_alone = (pass->classes & TR_I_ALL_TRANSPARENT) == 0;
    v->kind = TR_I_LINE;
    v->ink = pass->lines != TR_LINES_CREASES;
    v->line = pass->lines == TR_LINES_HIDDEN  ? (uint32_t)TR_I_LINE_HIDDEN
              : pass->lines == TR_LINES_OUTER ? (uint32_t)TR_I_LINE_OUTER
                                              : 0u;
    v->on_target = pass->kind != TR_PASS_OPAQUE_LINES;
    if (v->on_target && (tr->plan.textures >> TR_I_FRONT_DEPTH & 1u))
        v->has_front = pass->kind == TR_PASS_HIDDEN_LINES && opaque_alone ? 2 : 1;
}

/* The key of a pass that is drawn by a variant; 0 where it is not. */
static uint32_t tr_i_pass_key(const tr_context *tr, const tr_plan_pass *pass) {
    const tr_wishes *wishes = &tr->frame.wishes;
    tr_i_variant v;
    memset(&v, 0, sizeof v);
    v.supersample = (uint32_t)tr->plan.supersample;
    v.srgb = (wishes->options & TR_WISH_SRGB) != 0;
    if (pass->kind == TR_PASS_TAKE_OPAQUE) {
        v.kind = TR_I_TAKE_OPAQUE;
        return tr_i_key_of(&v);
    }
    v.has_scene = tr->plan.textures >> TR_I_SCENE_DEPTH & 1u;
    if (pass->lines) {
        tr_i_line_variant(tr, pass, &v);
        return tr_i_key_of(&v);
    }
    if (pass->kind != TR_PASS_COMPOSE)
        return 0;
    v.kind = TR_I_COMPOSITION;
    v.layers = (uint32_t)tr->plan.layers;
    v.blending = v.layers ? (uint32_t)wishes->blending : 0;
    v.has_opaque = tr->plan.textures >> TR_I_OPAQUE_COLOR & 1u;
    v.groups = (uint32_t)tr->plan.grouped;
    v.blend_color = v.layers && (wishes->options & TR_WISH_BLEND_COLOR);
    v.published = tr->plan.interior == TR_INTERIOR_IMPLICIT_PUBLISHED && v.layers;
    return tr_i_key_of(&v);
}

/* -1: a variant that is not made yet. */
static int tr_i_surface_program(const tr_context *tr, int rule) {
    int alpha = tr_i_wants_alpha(rule) ? (int)tr->frame.wishes.alpha : 0;
    return alpha == 0 ? rule : TR_I_PROGRAM_ALPHA + (alpha - 1) * (int)TR_RULE_COUNT + rule;
}

static int tr_i_program_of(const tr_context *tr, const tr_plan_pass *pass) {
    uint32_t key = tr_i_pass_key(tr, pass);
    int i;
    if (pass->kind == TR_PASS_COPY_DEPTH)
        return TR_I_PROGRAM_COPY_DEPTH;
    if (!key)
        return tr_i_surface_program(tr, (int)pass->rule);
    for (i = TR_I_PROGRAM_VARIANT; i < TR_I_PROGRAM_ALPHA; ++i)
        if (tr->programs[i].name && tr->programs[i].key == key)
            return i;
    return -1;
}

static int tr_i_plan_needs(const tr_context *tr, uint32_t key) {
    int i;
    for (i = 0; i < tr->plan.pass_count; ++i)
        if (tr_i_pass_key(tr, &tr->plan.passes[i]) == key)
            return 1;
    return 0;
}

/* A free place for a variant, or that of the one made longest ago that this plan can do without: there is one, since there
   are more places than a plan has variants. */
static int tr_i_place_variant(tr_context *tr, uint32_t key) {
    int i;
    do {
        i = TR_I_PROGRAM_VARIANT + tr->next_variant;
        tr->next_variant = (tr->next_variant + 1) % TR_I_VARIANT_COUNT;
    } while (tr->programs[i].name && tr_i_plan_needs(tr, tr->programs[i].key));
    if (tr->programs[i].name)
        tr->gl.DeleteProgram(tr->programs[i].name);
    tr->programs[i].name = 0;
    tr->programs[i].key = key;
    return i;
}

static float tr_i_weight(float weight, float fallback) {
    if (weight == 0.0f)
        return fallback;
    return weight > 0.0f ? (weight < 1.0f ? weight : 1.0f) : 0.0f;
}

static void tr_i_unit_vector(float out[4], const float in[3], const float fallback[3]) {
    double length;
    int i;
    if (in[0] == 0.0f && in[1] == 0.0f && in[2] == 0.0f)
        in = fallback;
    /* In double the squares of floats neither overflow nor vanish. */
    length = sqrt((double)in[0] * (double)in[0] + (double)in[1] * (double)in[1] + (double)in[2] * (double)in[2]);
    for (i = 0; i < 3; ++i)
        out[i] = (float)((double)in[i] / length);
    out[3] = 0.0f;
}

/* Clip z = p10 z + p14 and w = p11 z + p15 for eye z; solved for the distance -z as (x + y d) / (z + w d) of the window
   depth d, which is clip z / w, or half of it and a half. */
static void tr_i_eye_depth(const float p[16], int zero_to_one, float out[4]) {
    double scale = zero_to_one ? 1.0 : 2.0, shift = zero_to_one ? 0.0 : -1.0;
    out[0] = (float)(shift * (double)p[15] - (double)p[14]);
    out[1] = (float)(scale * (double)p[15]);
    out[2] = (float)(shift * (double)p[11] - (double)p[10]);
    out[3] = (float)(scale * (double)p[11]);
}

static void tr_i_fill_block(const tr_frame *frame, int zero_to_one, int supersample, tr_i_block *block) {
    static const float light[3] = {-0.45f, 0.65f, 0.62f};
    static const float cool[4] = {0.10f, 0.14f, 0.30f, 0.45f}, warm[4] = {0.22f, 0.19f, 0.08f, 0.80f};
    static const float zero[4] = {0, 0, 0, 0};
    int i;
    memset(block, 0, sizeof *block);
    tr_i_unit_vector(block->light, frame->light, light);
    if (frame->flat_shading) {
        block->cool[3] = block->warm[3] = 1.0f;
    } else {
        int given = memcmp(frame->cool, zero, sizeof zero) != 0 || memcmp(frame->warm, zero, sizeof zero) != 0;
        memcpy(block->cool, given ? frame->cool : cool, sizeof cool);
        memcpy(block->warm, given ? frame->warm : warm, sizeof warm);
    }
    block->weights[0] = tr_i_weight(frame->opaque_weight, 1.0f);
    block->weights[1] = tr_i_weight(frame->background_weight, 0.5f);
    block->weights[2] = frame->line_tolerance > 0.0f ? frame->line_tolerance : 2.0f;
    tr_i_eye_depth(frame->projection, zero_to_one, block->eye);
    memcpy(block->blend, frame->blend_color, sizeof frame->blend_color);
    block->blend[3] = frame->group_distance > 0.0f ? frame->group_distance : -1.0f;
    memcpy(block->shift, frame->jitter, sizeof frame->jitter);
    block->enter[0] = tr_i_weight(frame->enter_strength, 0.5f);
    block->enter[1] = frame->enter_distance;
    block->enter[2] = frame->enter_line > 0.0f ? frame->enter_line * (float)supersample : 0.0f; /* in our texels */
    block->viewport[0] = (float)frame->x;
    block->viewport[1] = (float)frame->y;
    block->viewport[2] = (float)frame->width;
    block->viewport[3] = (float)frame->height;
    block->step[1] = frame->opaque_x;
    block->step[2] = frame->opaque_y;
    for (i = 0; i < 3; ++i) {
        block->ink[0][i] = frame->crease_color[i];
        block->ink[1][i] = frame->outline_color[i];
    }
    if (!frame->black_creases && memcmp(frame->crease_color, zero, 3 * sizeof zero[0]) == 0)
        block->ink[0][0] = block->ink[0][1] = block->ink[0][2] = 1.0f;
}

/* 1 if tr_begin has to create or upload something: never in a steady frame. */
static int tr_i_needs_work(const tr_context *tr, const tr_i_block *block) {
    int i;
    if (!tr->uniform_buffer || !tr->vertex_array || !tr->block_uploaded ||
        memcmp(block, &tr->block, sizeof *block) != 0)
        return 1;
    if (tr->width != tr->frame.width * tr->plan.supersample || tr->height != tr->frame.height * tr->plan.supersample)
        return 1;
    for (i = 0; i < TR_I_TEXTURE_COUNT; ++i)
        if (tr_i_lacks(tr, i))
            return 1;
    for (i = 0; i < tr->plan.pass_count; ++i) {
        int program = tr_i_program_of(tr, &tr->plan.passes[i]), fbo = tr_i_fbo_of(&tr->plan.passes[i]);
        if (program < 0 || !tr->programs[program].name || (fbo >= 0 && !tr->fbos[fbo]))
            return 1;
    }
    return 0;
}

/* A copy of the block for each layer that a pass may read: they differ in their last member. */
static void tr_i_upload_block(tr_context *tr, const tr_i_block *block) {
    unsigned char copies[TR_MAX_LAYERS * TR_I_STRIDE];
    tr_i_block copy = *block;
    int i;
    if (tr->block_uploaded && memcmp(block, &tr->block, sizeof *block) == 0)
        return;
    memset(copies, 0, sizeof copies);
    for (i = 0; i < TR_MAX_LAYERS; ++i) {
        copy.step[0] = i;
        memcpy(copies + i * TR_I_STRIDE, &copy, sizeof copy);
    }
    if (!tr->uniform_buffer)
        tr->gl.GenBuffers(1, &tr->uniform_buffer);
    tr->gl.BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, tr->uniform_buffer);
    if (!tr->block_uploaded)
        tr->gl.BufferData(TR_I_GL_COPY_WRITE_BUFFER, (ptrdiff_t)sizeof copies, copies, TR_I_GL_DYNAMIC_DRAW);
    else
        tr->gl.BufferSubData(TR_I_GL_COPY_WRITE_BUFFER, 0, (ptrdiff_t)sizeof copies, copies);
    tr->block = *block;
    tr->block_uploaded = 1;
}

static tr_result tr_i_work(tr_context *tr, const tr_i_block *block) {
    tr_result result = tr_i_make_textures(tr);
    int i;
    for (i = 0; i < tr->plan.pass_count && result == TR_OK; ++i) {
        int program = tr_i_program_of(tr, &tr->plan.passes[i]);
        if (program < 0)
            program = tr_i_place_variant(tr, tr_i_pass_key(tr, &tr->plan.passes[i]));
        result = tr_i_make_program(tr, program);
    }
    if (result != TR_OK)
        return result;
    if (!tr->vertex_array)
        tr->gl.GenVertexArrays(1, &tr->vertex_array);
    tr_i_upload_block(tr, block);
    return TR_OK;
}

/* Also whether the target is multisampled. */
static tr_result tr_i_check_target(tr_context *tr, int *multisampled) {
    int32_t bound = 0, samples = 0;
    tr->gl.BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->frame.framebuffer);
    /* A name that is none is not bound, and what was bound before would pass for it. */
    tr->gl.GetIntegerv(TR_I_GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    if ((tr_i_u)bound != tr->frame.framebuffer ||
        tr->gl.CheckFramebufferStatus(TR_I_GL_DRAW_FRAMEBUFFER) != TR_I_GL_FRAMEBUFFER_COMPLETE)
        return tr_i_fail(&tr->desc, TR_TARGET_INCOMPLETE, "frame.framebuffer");
    tr->gl.GetIntegerv(TR_I_GL_SAMPLES, &samples);
    *multisampled = samples > 0;
    return TR_OK;
}

static tr_result tr_i_check_frame(const tr_context *tr, const tr_frame *frame) {
    int texels = frame->wishes.supersample ? (int)frame->wishes.supersample : 1;
    if (!tr_i_all_finite(&frame->opaque_weight, 1) || !tr_i_all_finite(&frame->background_weight, 1) ||
        !tr_i_all_finite(&frame->line_tolerance, 1) || !tr_i_all_finite(frame->light, 3) ||
        !tr_i_all_finite(frame->cool, 4) || !tr_i_all_finite(frame->warm, 4) ||
        !tr_i_all_finite(frame->crease_color, 3) || !tr_i_all_finite(frame->outline_color, 3) ||
        !tr_i_all_finite(frame->blend_color, 3) || !tr_i_all_finite(&frame->group_distance, 1) ||
        !tr_i_all_finite(&frame->enter_strength, 1) || !tr_i_all_finite(&frame->enter_distance, 1) ||
        !tr_i_all_finite(&frame->enter_line, 1) || !tr_i_all_finite(frame->projection, 16) ||
        !tr_i_all_finite(frame->jitter, 2))
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "a number of the frame is not finite");
    if ((frame->wishes.options & TR_WISH_ENTERING) && !(frame->enter_distance > 0.0f))
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "TR_WISH_ENTERING needs frame.enter_distance");
    /* Without a projection every depth is the same distance off. */
    if (frame->group_distance > 0.0f &&
        frame->projection[10] * frame->projection[15] == frame->projection[11] * frame->projection[14])
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "frame.group_distance needs frame.projection");
    if (frame->width < 0 || frame->height < 0)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "frame.width or frame.height is negative");
    if (frame->width > tr->max_width / texels || frame->height > tr->max_height / texels)
        return tr_i_fail(&tr->desc, TR_TOO_LARGE, "frame.width or frame.height");
    return TR_OK;
}

/* ---- opaque things from the host's textures ---- */

/* As a plan sees it: textures that are given hold something. */
static tr_scene tr_i_scene_of(const tr_frame *frame) {
    tr_scene counts = frame->scene;
    if (frame->opaque_depth && !counts.opaque_drawn)
        counts.opaque_drawn = 1;
    return counts;
}

static tr_result tr_i_check_opaque(const tr_context *tr, const tr_frame *frame) {
    if (!frame->opaque_color != !frame->opaque_depth)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "frame.opaque_color and frame.opaque_depth: both or neither");
    if (frame->scene.opaque_drawn && !frame->opaque_depth)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT,
                         "objects that are TR_DRAWN need frame.opaque_color and frame.opaque_depth");
    if (frame->opaque_x < 0 || frame->opaque_y < 0 || frame->opaque_x > tr->max_texture ||
        frame->opaque_y > tr->max_texture)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "frame.opaque_x or frame.opaque_y is in no texture");
    return TR_OK;
}

/* That a texture is what the pass can read, and covers the viewport; ES 3.0 cannot be asked for sizes, so no ES is. */
static tr_result tr_i_check_opaque_texture(const tr_context *tr, tr_i_u texture, const char *wrong,
                                           const char *misfit) {
    const tr_i_gl *gl = &tr->gl;
    const tr_frame *frame = &tr->frame;
    int32_t bound = 0, width = 0, height = 0;
    /* Binding a name that is none would leave an error, or a texture, behind. */
    if (!gl->IsTexture(texture))
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, wrong);
    gl->ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + TR_I_SCENE_DEPTH));
    gl->BindTexture(TR_I_GL_TEXTURE_2D, texture);
    gl->GetIntegerv(TR_I_GL_TEXTURE_BINDING_2D, &bound);
    if ((tr_i_u)bound != texture)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, wrong);
    if (tr->es)
        return TR_OK;
    gl->GetTexLevelParameteriv(TR_I_GL_TEXTURE_2D, 0, TR_I_GL_TEXTURE_WIDTH, &width);
    gl->GetTexLevelParameteriv(TR_I_GL_TEXTURE_2D, 0, TR_I_GL_TEXTURE_HEIGHT, &height);
    if (frame->opaque_x > width - frame->width || frame->opaque_y > height - frame->height)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, misfit);
    return TR_OK;
}

static tr_result tr_i_check_opaque_textures(const tr_context *tr) {
    tr_result result = TR_OK;
    if (tr->frame.opaque_depth)
        result = tr_i_check_opaque_texture(tr, tr->frame.opaque_color, "frame.opaque_color is no GL_TEXTURE_2D",
                                           "frame.opaque_color is too small for the viewport");
    if (tr->frame.opaque_depth && result == TR_OK)
        result = tr_i_check_opaque_texture(tr, tr->frame.opaque_depth, "frame.opaque_depth is no GL_TEXTURE_2D",
                                           "frame.opaque_depth is too small for the viewport");
    return result;
}

/* A multisampled target is served by textures of our own with 2 by 2 texels a pixel, if they may be that large. */
static void tr_i_suit_target(tr_context *tr, int multisampled) {
    if (!multisampled || tr->frame.wishes.supersample || tr->frame.width > tr->max_width / 2 ||
        tr->frame.height > tr->max_height / 2)
        return;
    tr->frame.wishes.supersample = 2;
    tr_plan_make(&tr->frame.scene, &tr->frame.wishes, &tr->plan);
}

TR_I_API tr_result tr_begin(tr_context *tr, const tr_frame *frame) {
    tr_i_block block;
    tr_result result;
    tr_scene counts;
    int work, multisampled = 0, none;
    if (!tr || !frame)
        return TR_INVALID_ARGUMENT;
    if (tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_begin");
    result = tr_i_check_frame(tr, frame);
    if (result == TR_OK)
        result = tr_i_check_opaque(tr, frame);
    if (result != TR_OK)
        return result;
    counts = tr_i_scene_of(frame);
    result = tr_plan_make(&counts, &frame->wishes, &tr->plan);
    if (result != TR_OK)
        return tr_i_fail(&tr->desc, result, "frame.wishes, or an id or group in frame.scene");
    if (frame->wishes.alpha == TR_ALPHA_IMAGE && tr->outline_pixel == 0.0f)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "frame.wishes.alpha: tr_find_outlines comes first");
    if ((frame->wishes.alpha == TR_ALPHA_CANDIDATES || frame->wishes.alpha == TR_ALPHA_EXACT) &&
        !tr->edge_textures[TR_I_EDGE_SEGMENTS])
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "frame.wishes.alpha: tr_set_edges gives the edges first");
    if (frame->width == 0 || frame->height == 0)
        memset(&tr->plan, 0, sizeof tr->plan);
    tr->frame = *frame;
    tr->frame.scene = counts;
    tr->next_pass = 0;
    tr->see.active = 0;
    if (tr->plan.pass_count > 0) {
        none = tr->desc.state == TR_STATE_NONE;
        if (!none) {
            tr_i_save(tr, &tr->saved);
            result = tr_i_check_target(tr, &multisampled);
            if (result == TR_OK)
                result = tr_i_check_opaque_textures(tr);
            tr_i_suit_target(tr, multisampled);
        }
        tr_i_fill_block(frame, tr->desc.zero_to_one, tr->plan.supersample, &block);
        work = tr_i_needs_work(tr, &block);
        if (work && none)
            tr_i_save(tr, &tr->saved);
        if (work && result == TR_OK)
            result = tr_i_work(tr, &block);
        if (result != TR_OK || (work && none))
            tr_i_restore(tr, &tr->saved);
    }
    tr->in_frame = result == TR_OK;
    return result;
}

/* Which textures a pass reads: bits of the units. */
static uint32_t tr_i_reads(const tr_plan_pass *pass, const tr_plan *plan) {
    const uint32_t front = 1u << TR_I_FRONT_DEPTH, odd = 1u << TR_I_ODD_DEPTH, owner = 1u << TR_I_FRONT_OWNER;
    const uint32_t behind = 1u << TR_I_SCENE_DEPTH, mark = 1u << TR_I_MARK, color = 1u << TR_I_LAYER_COLOR;
    switch (pass->rule) {
    case TR_RULE_OPAQUE_ENTERING:
        return 1u << TR_I_CROSSINGS;
    case TR_RULE_PEEL_GROUP:
        return front | owner | mark;
    case TR_RULE_LAYER_GROUP:
        return front | odd | mark;
    case TR_RULE_LIMIT:
    case TR_RULE_LIMIT_SHEET:
        return front | owner;
    case TR_RULE_LIMIT_MARKED:
    case TR_RULE_LIMIT_MARKED_SHEET:
        return front | odd | owner | mark;
    case TR_RULE_PEEL:
    case TR_RULE_PEEL_ALONE:
    case TR_RULE_LAYER:
    case TR_RULE_LAYER_MARKED:
    case TR_RULE_LIMIT_BEHIND:
        return front;
    default:
        break;
    }
    switch (pass->kind) {
    case TR_PASS_COPY_DEPTH:
    case TR_PASS_OPAQUE_LINES:
        return behind;
    case TR_PASS_TRANSPARENT_LINES:
    case TR_PASS_HIDDEN_LINES:
    case TR_PASS_OUTER_LINES:
        return front | behind;
    case TR_PASS_COMPOSE:
        return front | odd | behind | 1u << TR_I_OPAQUE_COLOR | color | (plan->grouped ? owner : 0u);
    default:
        return 0;
    }
}

/* The layer whose copy of the block a pass reads. */
static int tr_i_step_of(const tr_plan_pass *pass, const tr_plan *plan) {
    return pass->kind == TR_PASS_PEEL    ? pass->layer - 1
           : pass->kind == TR_PASS_LAYER ? pass->layer
           : pass->kind == TR_PASS_LIMIT ? plan->layers - 1
                                         : 0;
}

/* Passes that read one layer find it on the first unit whatever its number; one that reads the layer before as well finds
   that on the second. */
static void tr_i_turn_layers(const tr_plan_pass *pass, const tr_plan *plan, tr_state *state) {
    int marked = pass->rule == TR_RULE_LIMIT_MARKED || pass->rule == TR_RULE_LIMIT_MARKED_SHEET;
    int odd = tr_i_step_of(pass, plan) & 1;
    uint32_t even = state->textures[TR_I_FRONT_DEPTH];
    if (!odd || marked)
        return;
    state->textures[TR_I_FRONT_DEPTH] = state->textures[TR_I_ODD_DEPTH];
    state->textures[TR_I_ODD_DEPTH] = even;
}

static void tr_i_fill_textures(const tr_context *tr, const tr_plan_pass *pass, tr_state *state) {
    const uint32_t depths = (1u << TR_I_FRONT_DEPTH) | (1u << TR_I_ODD_DEPTH);
    uint32_t reads = tr_i_reads(pass, &tr->plan) & (tr->plan.textures | 1u << TR_I_CROSSINGS);
    int turned = pass->kind == TR_PASS_PEEL || pass->kind == TR_PASS_LAYER || pass->kind == TR_PASS_LIMIT, i;
    for (i = 0; i < TR_TEXTURE_UNITS; ++i) {
        state->texture_targets[i] = tr_i_targets[i];
        state->textures[i] = ((reads | (turned ? depths & tr->plan.textures : 0u)) >> i) & 1u ? tr->textures[i] : 0;
    }
    if (turned) {
        tr_i_turn_layers(pass, &tr->plan, state);
        for (i = 0; i <= TR_I_ODD_DEPTH; ++i)
            if (!((tr_i_reads(pass, &tr->plan) >> i) & 1u))
                state->textures[i] = 0;
    }
    /* Lines read depths without lines: their own have another name, and phantom lines are hidden by surfaces alone. */
    if ((pass->kind == TR_PASS_OPAQUE_LINES || pass->kind == TR_PASS_HIDDEN_LINES) &&
        (tr->plan.textures >> TR_I_DEPTH_COPY & 1u))
        state->textures[TR_I_SCENE_DEPTH] = tr->textures[TR_I_DEPTH_COPY];
    if (pass->kind == TR_PASS_TAKE_OPAQUE) { /* the host's, on the units of those that are drawn */
        state->textures[TR_I_SCENE_DEPTH] = tr->frame.opaque_depth;
        state->textures[TR_I_OPAQUE_COLOR] = tr->frame.opaque_color;
    }
}

static void tr_i_fill_bindings(const tr_context *tr, const tr_plan_pass *pass, tr_state *state) {
    int fbo = tr_i_fbo_of(pass), own = fbo >= 0, i;
    state->framebuffer = own ? tr->fbos[fbo] : tr->frame.framebuffer;
    state->viewport[0] = own ? 0 : tr->frame.x;
    state->viewport[1] = own ? 0 : tr->frame.y;
    state->viewport[2] = own ? tr->width : tr->frame.width;
    state->viewport[3] = own ? tr->height : tr->frame.height;
    state->program = tr->programs[tr_i_program_of(tr, pass)].name;
    state->first_texture_unit = tr->desc.first_texture_unit;
    tr_i_fill_textures(tr, pass, state);
    for (i = 0; i < TR_I_EDGE_TEXTURE_COUNT; ++i)
        if (!pass->lines && pass->kind != TR_PASS_COMPOSE && tr_i_wants_alpha((int)pass->rule) &&
            tr_i_reads_edges(tr, i))
            state->edge_textures[i] =
                tr->frame.wishes.alpha == TR_ALPHA_IMAGE ? tr->outline_textures[tr->outline_at] : tr->edge_textures[i];
    state->uniform_buffer = tr->uniform_buffer;
    state->uniform_binding = tr->desc.uniform_binding;
    state->uniform_offset = tr_i_step_of(pass, &tr->plan) * TR_I_STRIDE;
    state->uniform_size = (int)sizeof(tr_i_block);
    state->srgb = !own && (tr->frame.wishes.options & TR_WISH_SRGB);
    if (pass->kind == TR_PASS_COPY_DEPTH || pass->kind == TR_PASS_COMPOSE || pass->kind == TR_PASS_TAKE_OPAQUE) {
        state->vertex_array = tr->vertex_array;
        state->vertex_count = 3;
    }
}

static void tr_i_fill_tests(const tr_context *tr, const tr_plan_pass *pass, tr_state *state) {
    int reversed = tr->desc.reversed_z;
    tr_i_u nearer = reversed ? TR_I_GL_GREATER : TR_I_GL_LESS;
    tr_i_u not_farther = reversed ? TR_I_GL_GEQUAL : TR_I_GL_LEQUAL;
    state->depth_test = 1;
    state->depth_func = nearer;
    state->depth_write = 1;
    state->blend_source = state->blend_source_alpha = TR_I_GL_ONE;
    state->clear_color = pass->clear_color;
    state->clear_depth = pass->clear_depth;
    state->clear_depth_value = reversed ? 0.0f : 1.0f;
    state->cull_face = pass->cull == 1 ? TR_I_GL_BACK : pass->cull == 2 ? TR_I_GL_FRONT : 0;
    state->front_face = tr->desc.front_face_cw ? TR_I_GL_CW : TR_I_GL_CCW;
    switch (pass->kind) {
    case TR_PASS_FRONT:
    case TR_PASS_PEEL:
        state->color_write = tr_i_wants_color((int)pass->rule);
        break;
    case TR_PASS_LAYER: /* ids are not depths of the scene: lowest first whatever the convention */
        state->color_write = 1;
        state->depth_func = TR_I_GL_LESS;
        state->clear_depth_value = 1.0f;
        break;
    case TR_PASS_COPY_DEPTH:
        state->depth_func = TR_I_GL_ALWAYS;
        break;
    case TR_PASS_OPAQUE:
    case TR_PASS_TAKE_OPAQUE:
        state->color_write = 1;
        break;
    case TR_PASS_COMPOSE:
        state->color_write = 1;
        state->depth_func = not_farther;
        state->blend = 1;
        state->blend_destination = TR_I_GL_SRC_ALPHA;
        state->blend_source_alpha = TR_I_GL_ZERO;
        state->blend_destination_alpha = TR_I_GL_ONE;
        break;
    case TR_PASS_TRANSPARENT_LINES: /* ink, opaque; the blend function leaves the target's alpha alone */
    case TR_PASS_HIDDEN_LINES:
    case TR_PASS_OUTER_LINES:
        state->blend = 1;
        state->blend_source_alpha = TR_I_GL_ZERO;
        state->blend_destination_alpha = TR_I_GL_ONE;
        /* fall through */
    case TR_PASS_OPAQUE_LINES:
        state->color_write = 1;
        state->depth_func = not_farther;
        /* Creases leave no depth: they lie within their surface, and outlines are to go over them. Phantom lines are no
           things at all. */
        state->depth_write = pass->lines == TR_LINES_OUTLINES || pass->lines == TR_LINES_OUTER;
        break;
    default:
        break;
    }
}

static void tr_i_draw_triangle(tr_context *tr, const tr_state *state) {
    int32_t vertex_array = 0;
    /* The host's vertex array stays bound for its own draws. */
    tr->gl.GetIntegerv(TR_I_GL_VERTEX_ARRAY_BINDING, &vertex_array);
    tr->gl.BindVertexArray(state->vertex_array);
    tr->gl.DrawArrays(TR_I_GL_TRIANGLES, 0, state->vertex_count);
    tr->gl.BindVertexArray((tr_i_u)vertex_array);
}

/* ---- dynamic transparency: the sequence ------------------------------------------------------------------------- */

static tr_result tr_i_check_dynamic(const tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic) {
    const char *wrong = tr_i_check_law(dynamic);
    if (!wrong)
        wrong = tr_i_check_rung(dynamic);
    if (!wrong)
        wrong = tr_i_check_lights(dynamic);
    if (!wrong)
        wrong = tr_i_check_units(dynamic);
    if (!wrong && dynamic->see == TR_SEE_EXACT && !tr_i_ids_differ(dynamic))
        wrong = "dynamic.units: two have one id, and TR_SEE_EXACT tells units apart by it";
    if (wrong)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, wrong);
    if (dynamic->query && !tr->has_queries)
        return tr_i_fail(&tr->desc, TR_GL_FUNCTION_MISSING, "dynamic.query: glMapBufferRange and glFenceSync");
    return tr_i_check_frame(tr, frame);
}

/* Bytes of the textures that the plan needs. */
static void tr_i_weigh_see(tr_context *tr) {
    tr_i_see *see = &tr->see;
    uint32_t needs = tr_i_see_needs(see);
    int i;
    for (i = 0; i < TR_I_SEE_TEXTURE_COUNT; ++i)
        if ((needs >> i) & 1u)
            see->plan.bytes += tr_i_see_weight(i, see->host_depth, tr->frame.width, tr->frame.height, see->law.divisor);
}

/* What of a frame is looked at. */
static tr_frame tr_i_dynamic_frame(const tr_frame *frame) {
    tr_frame used = *frame;
    memset(&used.scene, 0, sizeof used.scene);
    memset(&used.wishes, 0, sizeof used.wishes);
    used.wishes.options = frame->wishes.options & TR_WISH_SRGB;
    used.enter_distance = used.group_distance = 0.0f;
    return used;
}

/* The program of ours for a pass of the plan. */
static int tr_i_see_program(const tr_context *tr, int index) {
    const tr_see_pass *pass = &tr->see.plan.passes[index];
    int parts = tr->see.plan.in_parts && !tr->see.marked ? TR_I_PROGRAM_PARTS - TR_I_PROGRAM_SEE : 0;
    switch (pass->kind) {
    case TR_PASS_BITS:
        return TR_I_PROGRAM_BITS + parts;
    case TR_PASS_SPREAD_X:
        return TR_I_PROGRAM_SPREAD_X;
    case TR_PASS_SPREAD_Y:
        return TR_I_PROGRAM_SPREAD_Y + parts;
    case TR_PASS_FINISH:
        return (tr->see.law.reach ? TR_I_PROGRAM_FINISH : TR_I_PROGRAM_FINISH_BARE) + parts;
    case TR_PASS_PRIME: /* that there is colour already, the framebuffer shows */
        return tr_i_see_fbo_of(&tr->see, index) != TR_I_SEE_FBO_PRIME ? TR_I_PROGRAM_PRIME
               : tr->see.plan.in_parts                                ? TR_I_PROGRAM_PRIME_PARTS
                                                                      : TR_I_PROGRAM_PRIME_COLOR;
    case TR_PASS_COMPOSE_MASK:
        return tr->see.partial ? TR_I_PROGRAM_COMPOSE_YIELD : TR_I_PROGRAM_COMPOSE_MASK;
    case TR_PASS_QUERY:
        return TR_I_PROGRAM_QUERY;
    default:
        return (int)pass->rule;
    }
}

/* Whether the host draws in a pass; else it is one of tiles. */
static int tr_i_see_is_drawn(tr_pass_kind kind) {
    return kind == TR_PASS_BLOCK || kind == TR_PASS_TARGETS || kind == TR_PASS_SCENE || kind == TR_PASS_BEHIND ||
           kind == TR_PASS_YIELD || kind == TR_PASS_HIDES;
}

static const uint32_t *tr_i_see_units(const tr_i_see *see, int index) {
    switch (see->plan.passes[index].kind) {
    case TR_PASS_BLOCK:
        return see->lists[TR_I_UNITS_BLOCK];
    case TR_PASS_TARGETS:
        return see->lists[TR_I_UNITS_TARGETS];
    case TR_PASS_BEHIND:
        return see->lists[TR_I_UNITS_BEHIND];
    case TR_PASS_YIELD:
        return see->lists[TR_I_UNITS_MASKED];
    case TR_PASS_HIDES:
        return see->lists[TR_I_UNITS_BEFORE];
    case TR_PASS_SCENE:
        return see->lists[see->units_of[index]];
    default:
        return 0;
    }
}

static void tr_i_fill_see_block(tr_context *tr, const tr_dynamic *dynamic) {
    const tr_i_see *see = &tr->see;
    tr_i_see_block *block = &tr->see.block;
    tr_i_block shading;
    size_t i;
    tr_i_fill_block(&tr->frame, tr->desc.zero_to_one, 1, &shading);
    memset(block, 0, sizeof *block);
    memcpy(block->light, shading.light, sizeof shading.light);
    memcpy(block->cool, shading.cool, sizeof shading.cool);
    memcpy(block->warm, shading.warm, sizeof shading.warm);
    memcpy(block->viewport, shading.viewport, sizeof shading.viewport);
    block->law[0] = see->law.target;
    block->law[1] = see->law.start;
    block->law[2] = see->law.width;
    block->law[3] = see->colored || (see->plan.in_parts && !see->marked) ? -1.0f : (float)dynamic->light_count;
    memcpy(block->background, dynamic->background, sizeof dynamic->background);
    block->background[3] = dynamic->occluders == TR_OCCLUDERS_EACH ? 1.0f : 0.0f;
    block->grid[0] = see->law.divisor;
    block->grid[1] = see->grid.side;
    block->grid[2] = (int32_t)(dynamic->frame_index & 0x7fffffffu);
    block->grid[3] = see->law.reach;
    for (i = 0; i < dynamic->light_count; ++i) {
        const tr_light *light = &dynamic->lights[i];
        block->lights[i][0] = light->x;
        block->lights[i][1] = light->y;
        block->lights[i][2] = light->radius;
        block->lights[i][3] = light->edge;
    }
    for (i = 0; see->plan.see != TR_SEE_OFF && i < (size_t)see->grid.tile_count; ++i) {
        const unsigned char *tile = see->grid.tiles[i];
        block->tiles[i] = tile[0] | (uint32_t)tile[1] << 8 | (uint32_t)tile[2] << 16 | (uint32_t)tile[3] << 24;
    }
}

/* Whether a pass needs a program of ours before the host asks for it. */
static int tr_i_needs_program(const tr_context *tr, tr_pass_kind kind) {
    return kind != TR_PASS_TAKE && (kind != TR_PASS_SCENE || tr->desc.state == TR_STATE_NONE);
}

/* 1 if something has to be created: never in a steady frame. */
static int tr_i_see_lacks(const tr_context *tr) {
    const tr_i_see *see = &tr->see;
    uint32_t needs = tr_i_see_needs(see);
    int i;
    if (!see->buffer || !tr->vertex_array || (needs && tr_i_see_misfits(tr)) || tr_i_lacks_queries(see))
        return 1;
    for (i = 0; i < TR_I_SEE_TEXTURE_COUNT; ++i)
        if (((needs >> i) & 1u) && !see->textures[i])
            return 1;
    for (i = 0; i < see->plan.pass_count; ++i) {
        const tr_see_pass *pass = &see->plan.passes[i];
        int fbo = tr_i_see_fbo_of(see, i), wanted = tr_i_needs_program(tr, pass->kind);
        if ((fbo >= 0 && !see->fbos[fbo]) || (wanted && !tr->programs[tr_i_see_program(tr, i)].name))
            return 1;
    }
    return 0;
}

static void tr_i_make_see_buffer(tr_context *tr) {
    tr_i_see *see = &tr->see;
    if (see->buffer)
        return;
    tr->gl.GenBuffers(1, &see->buffer);
    tr->gl.BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, see->buffer);
    tr->gl.BufferData(TR_I_GL_COPY_WRITE_BUFFER, (ptrdiff_t)sizeof see->block, 0, TR_I_GL_DYNAMIC_DRAW);
    see->block_uploaded = 0;
}

/* The built-in programs of TR_PASS_SCENE are made by tr_set_material, as most hosts have their own; but hosts that apply
   state themselves are told a program's name. */
static tr_result tr_i_see_work(tr_context *tr) {
    tr_i_see *see = &tr->see;
    tr_result result = see->plan.see == TR_SEE_OFF ? TR_OK : tr_i_make_see_textures(tr);
    int i;
    if (result == TR_OK && tr_i_lacks_queries(see))
        result = tr_i_make_queries(tr);
    for (i = 0; i < see->plan.pass_count && result == TR_OK; ++i)
        if (tr_i_needs_program(tr, see->plan.passes[i].kind))
            result = tr_i_make_program(tr, tr_i_see_program(tr, i));
    if (result != TR_OK)
        return result;
    if (!tr->vertex_array)
        tr->gl.GenVertexArrays(1, &tr->vertex_array);
    tr_i_make_see_buffer(tr);
    return TR_OK;
}

/* Tiles change with the view, so that this is done in most frames. */
static void tr_i_upload_see_block(tr_context *tr) {
    tr_i_see *see = &tr->see;
    int32_t bound = 0;
    if (see->block_uploaded && memcmp(&see->block, &see->uploaded, sizeof see->block) == 0)
        return;
    tr->gl.GetIntegerv(TR_I_GL_COPY_WRITE_BUFFER_BINDING, &bound);
    tr_i_make_see_buffer(tr);
    tr->gl.BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, see->buffer);
    tr->gl.BufferSubData(TR_I_GL_COPY_WRITE_BUFFER, 0, (ptrdiff_t)sizeof see->block, &see->block);
    tr->gl.BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, (tr_i_u)bound);
    see->uploaded = see->block;
    see->block_uploaded = 1;
}

/* For tr_set_material in TR_PASS_SCENE, whose state is the host's: puts the built-in program to use, once a frame makes it
   and what it reads ready. 0: there is none. */
static int tr_i_use_in_scene(tr_context *tr, int rule) {
    if (tr->desc.state == TR_STATE_NONE)
        return 1;
    if (tr_i_make_program(tr, rule) != TR_OK)
        return 0;
    if (!tr->see.in_use) {
        tr_i_upload_see_block(tr);
        tr->gl.BindBufferBase(TR_I_GL_UNIFORM_BUFFER, (tr_i_u)tr->desc.uniform_binding, tr->see.buffer);
    }
    tr->see.in_use = 1;
    tr->gl.UseProgram(tr->programs[rule].name);
    return 1;
}

/* That there is a target, and with TR_STATE_NONE nothing. */
static tr_result tr_i_check_see_target(tr_context *tr) {
    int32_t bound = 0;
    int multisampled;
    tr_result result;
    if (tr->desc.state == TR_STATE_NONE)
        return TR_OK;
    tr->gl.GetIntegerv(TR_I_GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    result = tr_i_check_target(tr, &multisampled);
    tr->gl.BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, (tr_i_u)bound);
    return result;
}

/* Everything that a frame needs. The state is as found afterwards: the scene may come first. */
static tr_result tr_i_prepare_see(tr_context *tr) {
    tr_result result;
    int32_t pack = 0;
    if (tr->see.plan.see == TR_SEE_OFF && tr->desc.state != TR_STATE_NONE)
        return TR_OK;
    result = tr_i_check_see_target(tr);
    if (result == TR_OK && tr_i_see_lacks(tr)) {
        tr_i_save(tr, &tr->saved);
        tr->gl.GetIntegerv(TR_I_GL_PIXEL_PACK_BUFFER_BINDING, &pack);
        result = tr_i_see_work(tr);
        tr->gl.BindBuffer(TR_I_GL_PIXEL_PACK_BUFFER, (tr_i_u)pack);
        tr_i_restore(tr, &tr->saved);
    }
    if (result == TR_OK)
        tr_i_upload_see_block(tr);
    return result;
}

/* Nothing is hidden in a frame without masks. */
static void tr_i_forget_answers(tr_i_see *see) {
    int i;
    for (i = 0; i < TR_I_QUERY_RING; ++i)
        see->queries[i].stale = 1;
    if (see->answer)
        memset(see->answer, 0, (TR_I_MAX_UNIT_ID + 1) * sizeof see->answer[0]);
}

/* ---- dynamic transparency: a frame of a sequence ---- */

/* Each run's masks, by a step of the given kind: `step` is what a step of SHARE has as its layer. */
static void tr_i_add_boxes(tr_context *tr, tr_pass_kind kind, uint32_t run, int layer, int clear) {
    const tr_i_sequence *seq = &tr->seq;
    uint32_t count = ((const tr_i_item *)seq->items.items)[run].count;
    tr_i_step *step = tr_i_add_step(tr, kind, TR_RULE_SEE_PLAIN, 0, count);
    step->block = kind == TR_PASS_SHARE ? run * (TR_I_SEQ_LAYERS / 4) + (uint32_t)layer : run * (TR_I_SEQ_LAYERS / 4);
    step->layer = (uint8_t)layer;
    step->clear = (uint8_t)clear;
}

/* All passes of TR_SEE_EXACT: how far masks look, layer after layer up to there, what masks make of these. The distances of
   a run are found anew where another run has taken their place. */
static void tr_i_add_exact_steps(tr_context *tr, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    size_t first = seq->list.count, blocks, units;
    uint32_t run, stride = TR_I_SEQ_LAYERS / 4;
    int i;
    seq->steps.count = 0;
    tr_i_add_step(tr, TR_PASS_SCENE, TR_RULE_SEE_PLAIN, 0, seq->scene.count);
    blocks = tr_i_list_meeting(tr, dynamic, &seq->tied, 1);
    if (blocks)
        tr_i_add_step(tr, TR_PASS_BLOCK, TR_RULE_SEE_DEPTH, first, blocks)->clear = 1;
    seq->has_block = blocks != 0;
    for (run = 0; run < seq->runs; ++run) {
        tr_i_item item = ((const tr_i_item *)seq->items.items)[run];
        tr_i_add_distances(tr, &item, run * stride, 1);
        tr_i_add_boxes(tr, TR_PASS_REACH, run, 0, run == 0);
    }
    first = seq->list.count;
    units = tr_i_list_meeting(tr, dynamic, &seq->tied, 0);
    for (i = 0; i < seq->peeled; ++i) {
        tr_i_step *peel = tr_i_add_step(tr, TR_PASS_PEEL_UNITS, TR_RULE_SEE_PEEL, first, units), *keep;
        peel->clear = 1;
        peel->layer = (uint8_t)i;
        peel->block = seq->runs * stride + (uint32_t)i;
        keep = tr_i_add_step(tr, TR_PASS_KEEP, TR_RULE_SEE_PLAIN, 0, 0);
        keep->layer = (uint8_t)i;
        keep->block = seq->runs * stride + (uint32_t)i;
    }
    for (run = 0; run < seq->runs; ++run) {
        tr_i_item item = ((const tr_i_item *)seq->items.items)[run];
        if (seq->runs > 1)
            tr_i_add_distances(tr, &item, run * stride, 1);
        for (i = 0; 4 * i < seq->peeled; ++i)
            tr_i_add_boxes(tr, TR_PASS_SHARE, run, i, run == 0);
    }
    tr_i_add_step(tr, TR_PASS_COMPOSE_LAYERS, TR_RULE_SEE_PLAIN, 0, 0);
}

/* A copy of the uniform block for each run of masks. */
static void tr_i_fill_seq_block(const tr_i_sequence *seq, const tr_frame *frame, const tr_dynamic *dynamic,
                                const tr_i_law *law, tr_i_seq_block *block) {
    tr_i_block shading;
    size_t i;
    memset(block, 0, sizeof *block);
    tr_i_fill_block(frame, 0, 1, &shading);
    memcpy(block->light, shading.light, sizeof block->light);
    memcpy(block->cool, shading.cool, sizeof block->cool);
    memcpy(block->warm, shading.warm, sizeof block->warm);
    block->law[0] = law->target;
    block->law[1] = law->start;
    block->law[2] = law->width;
    block->law[3] = (float)(int)seq->shape;
    memcpy(block->background, dynamic->background, sizeof dynamic->background);
    block->view[0] = frame->x;
    block->view[1] = frame->y;
    block->view[2] = frame->width;
    block->view[3] = frame->height;
    block->numbers[0] = seq->wanted[2];
    block->numbers[1] = seq->reach;
    for (i = 0; i < seq->masks.count && seq->shape != TR_MASK_OUTLINE; ++i) {
        const int *box = ((const tr_i_mask *)seq->masks.items)[i].box;
        int most = box[2] - box[0] > box[3] - box[1] ? box[2] - box[0] : box[3] - box[1];
        block->numbers[1] = most > block->numbers[1] ? most : block->numbers[1];
    }
    block->numbers[2] = seq->layers;
    block->numbers[3] = (int32_t)dynamic->light_count;
    block->step[1] = seq->product;
    block->step[2] = seq->published;
    block->step[3] = seq->counted && !seq->exact;
    block->more[0] = seq->peeled;
    block->more[1] = seq->whole;
    block->more[2] = seq->has_block;
    block->more[3] = !seq->each;
    for (i = 0; i < dynamic->light_count; ++i) {
        const tr_light *light = &dynamic->lights[i];
        block->lights[i][0] = light->x;
        block->lights[i][1] = light->y;
        block->lights[i][2] = light->radius;
        block->lights[i][3] = light->edge;
    }
}

static void tr_i_fill_masks(const tr_i_sequence *seq, const tr_i_item *item, tr_i_seq_block *block) {
    uint32_t i;
    int k;
    for (i = 0; i < item->count; ++i) {
        const tr_i_mask *mask = (const tr_i_mask *)seq->masks.items + item->first + i;
        for (k = 0; k < 4; ++k)
            block->masks[i][k] = (float)mask->box[k];
        block->masks[i][4] = mask->strength;
        block->masks[i][5] = mask->active;
        block->masks[i][6] = mask->importance;
        block->masks[i][7] = mask->id;
    }
}

static void tr_i_push_block(tr_context *tr, const tr_i_seq_block *block) {
    unsigned char *copy = (unsigned char *)tr_i_push(tr, &tr->seq.blocks, TR_I_SEQ_STRIDE);
    if (!copy) {
        tr->seq.no_memory = 1;
        return;
    }
    memset(copy, 0, TR_I_SEQ_STRIDE);
    memcpy(copy, block, sizeof *block);
}

/* One a run; of TR_SEE_EXACT one for each four layers of a run, and one a layer. */
static void tr_i_add_blocks(tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    tr_i_seq_block block;
    size_t i;
    int layer;
    tr_i_fill_seq_block(seq, frame, dynamic, &tr->see.law, &block);
    seq->blocks.count = 0;
    for (i = 0; i < seq->items.count; ++i) {
        const tr_i_item *item = (const tr_i_item *)seq->items.items + i;
        if (!item->masks)
            continue;
        tr_i_fill_masks(seq, item, &block);
        for (layer = 0; layer < (seq->exact ? TR_I_SEQ_LAYERS / 4 : 1); ++layer) {
            block.step[0] = layer;
            tr_i_push_block(tr, &block);
        }
    }
    for (layer = 0; seq->exact && layer < seq->peeled; ++layer) {
        block.step[0] = layer;
        tr_i_push_block(tr, &block);
    }
}

/* The program of a full-screen pass; -1: the host draws. */
static int tr_i_seq_program(const tr_i_sequence *seq, const tr_i_step *step) {
    int together = seq->counted && !seq->each;
    switch ((tr_pass_kind)step->kind) {
    case TR_PASS_WIPE:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_WIPE;
    case TR_PASS_ROWS:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_ROW;
    case TR_PASS_NEAREST:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_NEAR + seq->published;
    case TR_PASS_MASKS:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_MASK + seq->published + 2 * together;
    case TR_PASS_PAINT_OVER:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_OVER;
    case TR_PASS_EXTENTS:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_EXTENT;
    case TR_PASS_FORMS:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_FORM;
    case TR_PASS_REACH:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_DEPTHS;
    case TR_PASS_KEEP:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_KEEP;
    case TR_PASS_SHARE:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_SHARE;
    case TR_PASS_COMPOSE_LAYERS:
        return TR_I_PROGRAM_SEQUENCE + TR_I_SEQ_COMPOSE;
    default:
        return -1;
    }
}

/* The program that a step is drawn with, by us or, in a built-in way, by the host. */
static int tr_i_step_program(const tr_i_sequence *seq, const tr_i_step *step) {
    int program = tr_i_seq_program(seq, step);
    return program >= 0 ? program : (int)step->rule;
}

static int tr_i_seq_needs_work(const tr_context *tr) {
    const tr_i_sequence *seq = &tr->seq;
    const tr_i_step *steps = (const tr_i_step *)seq->steps.items;
    uint32_t needs = tr_i_seq_needs(seq);
    size_t i;
    if (tr_i_seq_misfits(tr) || (needs & ~tr_i_seq_held(seq)) || !tr->vertex_array)
        return 1;
    for (i = 0; i < seq->steps.count; ++i)
        if (steps[i].kind != (uint8_t)TR_PASS_SCENE && !tr->programs[tr_i_step_program(seq, &steps[i])].name)
            return 1;
    return 0;
}

static void tr_i_upload_blocks(tr_context *tr) {
    tr_i_sequence *seq = &tr->seq;
    size_t size = seq->blocks.count * TR_I_SEQ_STRIDE;
    int32_t bound = 0;
    if (!seq->buffer)
        tr->gl.GenBuffers(1, &seq->buffer);
    tr->gl.GetIntegerv(TR_I_GL_COPY_WRITE_BUFFER_BINDING, &bound);
    tr->gl.BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, seq->buffer);
    if (seq->buffer_size < size) {
        seq->buffer_size = size + size / 4 / TR_I_SEQ_STRIDE * TR_I_SEQ_STRIDE;
        tr->gl.BufferData(TR_I_GL_COPY_WRITE_BUFFER, (ptrdiff_t)seq->buffer_size, 0, TR_I_GL_DYNAMIC_DRAW);
    }
    tr->gl.BufferSubData(TR_I_GL_COPY_WRITE_BUFFER, 0, (ptrdiff_t)size, seq->blocks.items);
    tr->gl.BindBuffer(TR_I_GL_COPY_WRITE_BUFFER, (tr_i_u)bound);
}

static tr_result tr_i_seq_work(tr_context *tr) {
    const tr_i_sequence *seq = &tr->seq;
    const tr_i_step *steps = (const tr_i_step *)seq->steps.items;
    tr_result result = tr_i_make_seq_textures(tr);
    size_t i;
    for (i = 0; i < seq->steps.count && result == TR_OK; ++i)
        if (steps[i].kind != (uint8_t)TR_PASS_SCENE)
            result = tr_i_make_program(tr, tr_i_step_program(seq, &steps[i]));
    if (!tr->vertex_array)
        tr->gl.GenVertexArrays(1, &tr->vertex_array);
    return result;
}

/* What this frame wishes, with the defaults filled in. */
static void tr_i_take_wishes(tr_context *tr, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    const tr_i_law *law = &tr->see.law;
    seq->exact = dynamic->see == TR_SEE_EXACT;
    seq->published = dynamic->see == TR_SEE_PUBLISHED;
    seq->product = seq->published || dynamic->combine == TR_MASK_PRODUCT;
    seq->each = seq->published || dynamic->occluders == TR_OCCLUDERS_EACH;
    seq->layers = dynamic->layers;
    seq->counted = !seq->exact && (!seq->each || seq->layers > 0);
    seq->wanted[0] = tr->frame.width;
    seq->wanted[1] = tr->frame.height;
    seq->wanted[2] = law->divisor;
    seq->wanted[3] = 0;
    seq->shape = dynamic->shape;
    seq->light = (tr->frame.wishes.options & TR_WISH_SRGB) != 0;
    seq->reach = law->reach;
    seq->grow = law->reach + 2 * law->divisor;
}

/* Adds to the line of a kind of pass in the plan. */
static void tr_i_plan_step(tr_see_plan *plan, const tr_i_sequence *seq, const tr_i_step *step) {
    static const struct {
        tr_pass_kind kind;
        const char *why;
    } whys[] = {{TR_PASS_SCENE, "what no mask makes transparent"},
                {TR_PASS_BLOCK, "what closes masks, so that targets behind it open none"},
                {TR_PASS_WIPE, "room for the targets of a run"},
                {TR_PASS_SEEDS, "the targets of a run: they and their masks do not overlap"},
                {TR_PASS_ROWS, "the nearest pixel of a target in each row"},
                {TR_PASS_NEAREST, "of these the nearest"},
                {TR_PASS_EXTENTS, "rows of the targets of a run"},
                {TR_PASS_FORMS, "circles, ellipses or hulls of them"},
                {TR_PASS_MASKS, "masks, over those of targets farther off"},
                {TR_PASS_PAINT_DEPTH, "front-most surfaces of solid units"},
                {TR_PASS_PAINT, "units that masks may make transparent, back to front"},
                {TR_PASS_COUNT, "occluders are counted, to share a mask or for layer control"},
                {TR_PASS_PAINT_OVER, "from a target of our own to the host's"},
                {TR_PASS_REACH, "how far masks look through"},
                {TR_PASS_PEEL_UNITS, "the next layer up to there, of all units that meet masks"},
                {TR_PASS_KEEP, "whose the layer is"},
                {TR_PASS_SHARE, "what masks leave of the opacity of four layers"},
                {TR_PASS_COMPOSE_LAYERS, "layers, front to back, over the scene"}};
    size_t i;
    int at;
    for (at = 0; at < plan->pass_count && plan->passes[at].kind != (tr_pass_kind)step->kind;)
        ++at;
    if (at == plan->pass_count) {
        tr_see_pass *pass = tr_i_add_see_pass(plan, (tr_pass_kind)step->kind, (tr_rule)step->rule, 0, "");
        for (i = 0; i < sizeof whys / sizeof whys[0]; ++i)
            if (whys[i].kind == pass->kind)
                pass->why = whys[i].why;
    }
    ++plan->passes[at].times;
    if (tr_i_seq_program(seq, step) < 0)
        plan->passes[at].unit_count += step->count;
}

/* The rectangle of all masks, to which passes are cut. */
static void tr_i_bound_masks(tr_i_sequence *seq) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    size_t i;
    int k;
    memset(seq->bounds, 0, sizeof seq->bounds);
    for (i = 0; i < seq->masks.count; ++i)
        for (k = 0; k < 4; ++k)
            if (i == 0 || (k < 2 ? masks[i].box[k] < seq->bounds[k] : masks[i].box[k] > seq->bounds[k]))
                seq->bounds[k] = masks[i].box[k];
}

/* What of the viewport is covered by boxes of masks, each counted whole. */
static void tr_i_plan_boxes(const tr_i_sequence *seq, tr_see_plan *plan) {
    const tr_i_mask *masks = (const tr_i_mask *)seq->masks.items;
    double area = 0;
    size_t i;
    for (i = 0; i < seq->masks.count; ++i)
        area += (double)(masks[i].box[2] - masks[i].box[0]) * (double)(masks[i].box[3] - masks[i].box[1]);
    plan->rectangle[0] = seq->bounds[0];
    plan->rectangle[1] = seq->bounds[1];
    plan->rectangle[2] = seq->bounds[2] - seq->bounds[0];
    plan->rectangle[3] = seq->bounds[3] - seq->bounds[1];
    plan->tiles = (uint32_t)seq->masks.count;
    plan->covered = (float)(area / ((double)seq->wanted[0] * (double)seq->wanted[1]));
}

/* Of what the textures of masks are: desc.eight_bits, or what the context has turned out to draw into. */
static const char *tr_i_seq_why(const tr_i_sequence *seq) {
    return seq->eight_bits ? "something that yields lies before a target; masks of 8 bits"
                           : "something that yields lies before a target; masks of floats";
}

/* The plan of the cheaper rungs gives way. */
static void tr_i_plan_sequence(tr_context *tr, const tr_dynamic *dynamic) {
    const tr_i_sequence *seq = &tr->seq;
    tr_see_plan *plan = &tr->see.plan;
    size_t i;
    plan->pass_count = 0;
    plan->bytes = 0;
    plan->masks = seq->pending;
    if (seq->exact ? seq->masks.count == 0 : seq->blocks.count == 0) {
        tr_i_plan_plain(&tr->see,
                        plan->targets_in_view ? "nothing that yields lies before a target" : "no target is in view");
        return;
    }
    plan->see = dynamic->see;
    plan->why = tr_i_seq_why(seq);
    plan->layers = seq->exact ? (uint32_t)seq->peeled : 0;
    plan->layer_bound = seq->exact ? (uint32_t)seq->layer_bound : 0;
    tr_i_plan_boxes(seq, plan);
    plan->runs = (uint32_t)(seq->exact ? seq->runs : seq->blocks.count);
    plan->bytes = tr_i_seq_bytes(seq, tr_i_seq_needs(seq), seq->wanted);
    for (i = 0; i < seq->steps.count; ++i)
        tr_i_plan_step(plan, seq, (const tr_i_step *)seq->steps.items + i);
}

/* The steps of what has been arranged. */
static void tr_i_add_sequence(tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    if (seq->exact) {
        tr_i_add_exact_steps(tr, dynamic);
        seq->wanted[3] = seq->peeled;
    } else {
        tr_i_add_steps(tr, dynamic);
    }
    tr_i_bound_masks(seq);
    tr_i_add_blocks(tr, frame, dynamic);
}

/* Lists and steps; no GL. */
static tr_result tr_i_arrange_sequence(tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    int size[2];
    size[0] = frame->width;
    size[1] = frame->height;
    tr_i_take_wishes(tr, dynamic);
    if (tr->desc.eight_bits)
        seq->eight_bits = 1;
    if (!tr_i_order_units(tr, seq, dynamic))
        return tr_i_fail(&tr->desc, TR_OUT_OF_MEMORY, "dynamic.units");
    if (seq->exact) {
        tr_i_arrange_masks(tr, dynamic, size);
        tr_i_sort_masks(tr);
    } else {
        tr_i_arrange_units(tr, dynamic, size);
    }
    if (!seq->no_memory) /* else lists are not whole */
        tr_i_add_sequence(tr, frame, dynamic);
    if (seq->no_memory)
        return tr_i_fail(&tr->desc, TR_OUT_OF_MEMORY, "dynamic.units");
    tr_i_plan_sequence(tr, dynamic);
    return TR_OK;
}

/* Hosts that apply state themselves are told the built-in program of the scene, and what it reads. */
static tr_result tr_i_prepare_scene(tr_context *tr) {
    tr_result result = TR_OK;
    if (tr->desc.state != TR_STATE_NONE || tr->see.plan.pass_count == 0)
        return TR_OK;
    if (!tr->see.buffer || !tr->programs[TR_RULE_SEE_PLAIN].name) {
        tr_i_save(tr, &tr->saved);
        result = tr_i_make_program(tr, TR_RULE_SEE_PLAIN);
        tr_i_make_see_buffer(tr);
        tr_i_restore(tr, &tr->saved);
    }
    if (result == TR_OK)
        tr_i_upload_see_block(tr);
    return result;
}

/* After tr_i_plan_see, which has placed the units. The state is as found afterwards: the scene comes first. */
static tr_result tr_i_begin_sequence(tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic) {
    tr_i_sequence *seq = &tr->seq;
    tr_result result = TR_OK;
    seq->step = 0;
    if (frame->width > 0 && frame->height > 0)
        result = tr_i_arrange_sequence(tr, frame, dynamic);
    if (result == TR_OK)
        result = tr_i_prepare_scene(tr);
    if (result != TR_OK || tr->see.plan.see == TR_SEE_OFF)
        return result;
    result = tr_i_check_see_target(tr);
    if (result == TR_OK && tr_i_seq_needs_work(tr)) {
        tr_i_save(tr, &tr->saved);
        result = tr_i_seq_work(tr);
        tr_i_restore(tr, &tr->saved);
        /* Floats may have turned out not to be had. */
        tr->see.plan.bytes = tr_i_seq_bytes(seq, tr_i_seq_needs(seq), seq->wanted);
        tr->see.plan.why = tr_i_seq_why(seq);
    }
    if (result == TR_OK)
        tr_i_upload_blocks(tr);
    return result;
}

TR_I_API tr_result tr_begin_dynamic(tr_context *tr, const tr_frame *frame, const tr_dynamic *dynamic) {
    tr_frame used;
    tr_result result;
    if (!tr || !frame || !dynamic)
        return TR_INVALID_ARGUMENT;
    if (tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_begin_dynamic");
    used = tr_i_dynamic_frame(frame);
    result = tr_i_check_dynamic(tr, &used, dynamic);
    if (result == TR_OK)
        result = tr_i_fit_units(tr, dynamic->unit_count);
    if (result != TR_OK)
        return result;
    tr->frame = used;
    tr->seq.active = tr_i_is_sequence(dynamic->see);
    tr_i_plan_see(tr, dynamic, frame->width, frame->height);
    tr_i_weigh_see(tr);
    if (tr->see.plan.see == TR_SEE_OFF)
        tr_i_forget_answers(&tr->see);
    tr_i_fill_see_block(tr, dynamic);
    tr->see.step = tr->see.region = 0;
    tr->see.active = 1;
    tr->see.in_use = 0;
    tr->see.entered = TR_I_OUTSIDE;
    result = tr->seq.active ? tr_i_begin_sequence(tr, &used, dynamic) : tr_i_prepare_see(tr);
    tr->in_frame = result == TR_OK;
    return result;
}

/* Textures that a pass reads, on units that hold two-dimensional ones. */
static void tr_i_fill_see_textures(const tr_i_see *see, tr_pass_kind kind, int fbo, tr_state *state) {
    /* Of a scene in parts the mark is that target's and all depths are the same. */
    int parts = see->plan.in_parts, bare = parts && !see->marked;
    const tr_i_u *from = see->textures, mark = bare ? 0 : from[see->colored ? TR_I_SEE_BEHIND : TR_I_SEE_MARK];
    tr_i_u targets = from[!parts                                  ? TR_I_SEE_DEPTH
                          : bare && see->counts[TR_I_UNITS_BLOCK] ? TR_I_SEE_TARGET_DEPTH
                                                                  : TR_I_SEE_BASE_DEPTH];
    tr_i_u *depth = &state->textures[TR_I_SCENE_DEPTH], *mask = &state->textures[TR_I_OPAQUE_COLOR];
    tr_i_u *third = &state->textures[TR_I_MARK], *fourth = &state->textures[TR_I_CROSSINGS];
    switch (kind) {
    case TR_PASS_BITS:
        *depth = bare ? targets : 0;
        *mask = bare ? from[TR_I_SEE_BASE_DEPTH] : mark;
        break;
    case TR_PASS_SPREAD_X:
        *depth = targets;
        *third = from[TR_I_SEE_BITS];
        break;
    case TR_PASS_SPREAD_Y:
    case TR_PASS_FINISH:
        *depth = targets;
        *mask = bare && kind == TR_PASS_FINISH ? from[TR_I_SEE_BITS] : mark;
        *third = from[kind == TR_PASS_SPREAD_Y ? TR_I_SEE_ROWS : TR_I_SEE_LOW];
        *fourth = kind == TR_PASS_FINISH ? from[TR_I_SEE_LOW_DEPTH] : 0;
        break;
    case TR_PASS_PRIME:
        *mask = from[TR_I_SEE_MASK];
        if (fbo == TR_I_SEE_FBO_PRIME) {
            *depth = from[parts ? TR_I_SEE_BASE_DEPTH : TR_I_SEE_MASK_DEPTH];
            *third = parts ? 0 : mark;
        }
        break;
    case TR_PASS_QUERY:
        *mask = mark;
        break;
    case TR_PASS_SCENE: /* with holes */
    case TR_PASS_BEHIND:
    case TR_PASS_HIDES:
    case TR_PASS_COMPOSE_MASK:
        *depth = from[TR_I_SEE_MASK_DEPTH];
        *mask = from[TR_I_SEE_MASK];
        if (kind == TR_PASS_COMPOSE_MASK) {
            *third = from[TR_I_SEE_BEHIND];
            *fourth = see->partial ? from[TR_I_SEE_YIELD] : 0;
        }
        break;
    default:
        break;
    }
}

/* The rectangle of masks with all that passes read around it, which has to be cleared as well. */
static void tr_i_surroundings(const tr_i_see *see, int out[4]) {
    const int *box = see->plan.rectangle;
    int by = see->law.reach + 2 * see->law.divisor + 8, k;
    for (k = 0; k < 2; ++k) {
        int size = k ? see->height : see->width, first = box[k] - by, last = box[k] + box[k + 2] + by;
        out[k] = first > 0 ? first : 0;
        out[k + 2] = (last < size ? last : size) - out[k];
    }
}

/* Viewport, and scissor to where masks are, of a framebuffer of ours. */
static void tr_i_fill_see_extent(const tr_context *tr, int fbo, tr_state *state) {
    const tr_i_see *see = &tr->see;
    tr_i_see_format format;
    int attached[2], across, up, k;
    tr_i_see_attached(fbo, attached);
    format = tr_i_see_format_of(attached[0] >= 0 ? attached[0] : attached[1], 0, 0);
    across = tr_i_see_divisor(format.across, see->divisor);
    up = tr_i_see_divisor(format.up, see->divisor);
    tr_i_see_size(&format, see->width, see->height, see->divisor, &state->viewport[2]);
    /* A whole scene reads the mask wherever it draws; texels of queries are not aligned with cells. */
    if ((fbo == TR_I_SEE_FBO_MASK && see->plan.see == TR_SEE_DITHER) || fbo == TR_I_SEE_FBO_QUERY)
        return;
    tr_i_surroundings(see, state->scissor);
    for (k = 0; k < 2; ++k) {
        int divisor = k ? up : across, first = state->scissor[k] / divisor;
        state->scissor[k + 2] = (state->scissor[k] + state->scissor[k + 2] + divisor - 1) / divisor - first;
        state->scissor[k] = first;
    }
}

static void tr_i_fill_see_bindings(const tr_context *tr, int index, tr_state *state) {
    const tr_i_see *see = &tr->see;
    const tr_see_pass *pass = &see->plan.passes[index];
    int fbo = tr_i_see_fbo_of(see, index), i;
    state->framebuffer = fbo >= 0 ? see->fbos[fbo] : tr->frame.framebuffer;
    if (fbo >= 0) {
        tr_i_fill_see_extent(tr, fbo, state);
    } else {
        state->viewport[0] = tr->frame.x;
        state->viewport[1] = tr->frame.y;
        state->viewport[2] = tr->frame.width;
        state->viewport[3] = tr->frame.height;
    }
    state->program = tr->programs[tr_i_see_program(tr, index)].name;
    state->first_texture_unit = tr->desc.first_texture_unit;
    for (i = 0; i < TR_TEXTURE_UNITS; ++i)
        state->texture_targets[i] = tr_i_targets[i];
    if (pass->rule != TR_RULE_SEE_PLAIN || pass->kind != TR_PASS_SCENE)
        tr_i_fill_see_textures(see, pass->kind, fbo, state);
    state->uniform_buffer = see->buffer;
    state->uniform_binding = tr->desc.uniform_binding;
    state->uniform_size = (int)sizeof see->block;
    state->srgb = (tr->frame.wishes.options & TR_WISH_SRGB) != 0;
    if (!tr_i_see_is_drawn(pass->kind)) {
        state->vertex_array = tr->vertex_array;
        state->vertex_count = 6 * see->grid.tile_count;
    }
}

static void tr_i_fill_see_tests(const tr_context *tr, int index, tr_state *state) {
    const tr_see_pass *pass = &tr->see.plan.passes[index];
    int reversed = tr->desc.reversed_z, drawn = tr_i_see_is_drawn(pass->kind);
    state->depth_test = state->depth_write = state->color_write = 1;
    state->depth_func = !drawn ? TR_I_GL_ALWAYS : reversed ? TR_I_GL_GREATER : TR_I_GL_LESS;
    state->clear_depth_value = reversed ? 0.0f : 1.0f;
    state->blend_source = state->blend_source_alpha = TR_I_GL_ONE;
    state->cull_face = drawn ? TR_I_GL_BACK : 0;
    state->front_face = tr->desc.front_face_cw ? TR_I_GL_CW : TR_I_GL_CCW;
    switch (pass->kind) {
    case TR_PASS_BLOCK:
        state->color_write = 0;
        state->clear_depth = 1;
        break;
    case TR_PASS_TARGETS: /* before what coincides with it */
        state->depth_func = reversed ? TR_I_GL_GEQUAL : TR_I_GL_LEQUAL;
        state->depth_write = !tr->see.plan.in_parts;
        state->clear_depth = state->depth_write && (index == 0 || tr->see.plan.passes[index - 1].kind != TR_PASS_BLOCK);
        state->clear_color = 1;
        if (tr->see.colored) /* what shows where nothing is behind a mask */
            memcpy(state->clear_color_value, tr->see.block.background, 3 * sizeof state->clear_color_value[0]);
        break;
    case TR_PASS_BITS:
    case TR_PASS_SPREAD_X:
        state->clear_color = 1;
        state->depth_test = state->depth_write = 0;
        break;
    case TR_PASS_SPREAD_Y:
    case TR_PASS_FINISH: /* no mask */
        state->clear_color = 1;
        state->clear_color_value[0] = 1.0f;
        break;
    case TR_PASS_PRIME: /* nothing is nearer */
        state->clear_depth = 1;
        state->clear_depth_value = reversed ? 1.0f : 0.0f;
        state->color_write = state->framebuffer != tr->see.fbos[TR_I_SEE_FBO_PRIME];
        break;
    case TR_PASS_COMPOSE_MASK:
        state->depth_func = reversed ? TR_I_GL_LESS : TR_I_GL_GREATER;
        state->depth_write = 0;
        state->blend = 1;
        state->blend_source = TR_I_GL_SRC_ALPHA;
        state->blend_destination = TR_I_GL_ONE_MINUS_SRC_ALPHA;
        state->blend_source_alpha = TR_I_GL_ZERO;
        state->blend_destination_alpha = TR_I_GL_ONE;
        break;
    case TR_PASS_QUERY:
    case TR_PASS_HIDES:
        state->clear_color = pass->kind == TR_PASS_QUERY;
        state->depth_test = state->depth_write = 0;
        state->blend = pass->kind == TR_PASS_HIDES; /* added to the id that is there */
        state->blend_destination = state->blend_destination_alpha = TR_I_GL_ONE;
        break;
    default:
        break;
    }
}

/* Before the host draws its scene after passes of ours: its own state, but for what the scene's shaders read. */
static void tr_i_leave_to_host(tr_context *tr, const tr_state *state) {
    tr_i_snapshot saved = tr->saved;
    int32_t active = 0, buffer = 0;
    if (tr->desc.state == TR_STATE_LEAVE_DEFAULTS)
        tr_i_save_defaults(&saved);
    if (tr->desc.state != TR_STATE_LEAVE_DIRTY)
        tr_i_restore(tr, &saved);
    else /* what it reads is not to be what is drawn into */
        tr->gl.BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, state->framebuffer);
    tr->gl.GetIntegerv(TR_I_GL_ACTIVE_TEXTURE, &active);
    tr->gl.GetIntegerv(TR_I_GL_UNIFORM_BUFFER_BINDING, &buffer);
    tr_i_bind_textures(tr, state);
    tr->gl.BindBufferRange(TR_I_GL_UNIFORM_BUFFER, (tr_i_u)state->uniform_binding, state->uniform_buffer,
                           state->uniform_offset, state->uniform_size);
    tr->gl.BindBuffer(TR_I_GL_UNIFORM_BUFFER, (tr_i_u)buffer);
    tr->gl.ActiveTexture((tr_i_u)active);
}

/* After it: only that is put back. What the host has set since is its own. */
static void tr_i_take_from_host(tr_context *tr) {
    tr_i_snapshot now;
    if (tr->desc.state == TR_STATE_LEAVE_DIRTY)
        return;
    if (tr->desc.state == TR_STATE_LEAVE_DEFAULTS)
        tr_i_save_defaults(&tr->saved);
    memset(&now, 0, sizeof now); /* a lost context answers nothing */
    tr_i_save_bindings(tr, &now);
    memcpy(now.textures, tr->saved.textures, sizeof now.textures);
    memcpy(now.samplers, tr->saved.samplers, sizeof now.samplers);
    now.indexed_buffer = tr->saved.indexed_buffer;
    now.indexed_start = tr->saved.indexed_start;
    now.indexed_size = tr->saved.indexed_size;
    tr_i_restore_bindings(tr, &now);
}

/* Sets the state of a pass; the scene's is the host's own. */
static void tr_i_apply_see(tr_context *tr, const tr_pass *pass) {
    tr_i_see *see = &tr->see;
    if (tr->desc.state == TR_STATE_NONE)
        return;
    if (pass->kind == TR_PASS_SCENE) {
        if (see->entered == TR_I_INSIDE) {
            tr_i_leave_to_host(tr, &pass->state);
            see->entered = TR_I_LENT;
        }
        return;
    }
    if (see->entered == TR_I_OUTSIDE)
        tr_i_save(tr, &tr->saved);
    see->entered = TR_I_INSIDE;
    tr_i_apply(tr, &pass->state);
}

/* ---- dynamic transparency: the passes of a sequence ---- */

/* Textures that a pass reads, on the units of their kind. */
static void tr_i_bind_step(const tr_i_sequence *seq, const tr_i_step *step, tr_state *state) {
    const tr_i_u *textures = seq->textures;
    int i;
    for (i = 0; i < TR_TEXTURE_UNITS; ++i)
        state->texture_targets[i] = tr_i_targets[i];
    switch ((tr_pass_kind)step->kind) {
    case TR_PASS_SEEDS:
        state->textures[TR_I_MARK] = seq->has_block ? textures[TR_I_SEQ_BLOCK] : 0;
        break;
    case TR_PASS_ROWS:
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_SEED];
        break;
    case TR_PASS_NEAREST:
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_SEED];
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_ROWS];
        break;
    case TR_PASS_MASKS:
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_SEED];
        state->textures[TR_I_MARK] = textures[TR_I_SEQ_NEAREST];
        state->textures[TR_I_CROSSINGS] = seq->counted ? textures[TR_I_SEQ_REMAINING] : 0;
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_FORMS];
        break;
    case TR_PASS_PAINT:
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_ALPHAS];
        state->textures[TR_I_CROSSINGS] = seq->counted ? textures[TR_I_SEQ_REMAINING] : 0;
        break;
    case TR_PASS_PAINT_OVER:
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_OWN_DEPTH];
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_OWN_COLOR];
        break;
    case TR_PASS_EXTENTS:
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_SEED];
        break;
    case TR_PASS_FORMS:
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_EXTENTS];
        break;
    case TR_PASS_REACH:
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_SEED];
        state->textures[TR_I_MARK] = textures[TR_I_SEQ_NEAREST];
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_FORMS];
        break;
    case TR_PASS_PEEL_UNITS:
        state->textures[TR_I_FRONT_DEPTH] = textures[step->layer & 1 ? TR_I_SEQ_EVEN : TR_I_SEQ_ODD];
        state->textures[TR_I_FRONT_OWNER] = textures[TR_I_SEQ_CHAIN];
        state->textures[TR_I_CROSSINGS] = textures[TR_I_SEQ_REACH];
        break;
    case TR_PASS_KEEP:
        state->textures[TR_I_FRONT_DEPTH] = textures[step->layer & 1 ? TR_I_SEQ_EVEN : TR_I_SEQ_ODD];
        state->textures[TR_I_ODD_DEPTH] = textures[step->layer & 1 ? TR_I_SEQ_ODD : TR_I_SEQ_EVEN];
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_CODE];
        state->textures[TR_I_CROSSINGS] = textures[TR_I_SEQ_REACH];
        break;
    case TR_PASS_SHARE:
        state->textures[TR_I_FRONT_DEPTH] = textures[TR_I_SEQ_EVEN];
        state->textures[TR_I_ODD_DEPTH] = textures[TR_I_SEQ_ODD];
        state->textures[TR_I_FRONT_OWNER] = textures[TR_I_SEQ_CHAIN];
        state->textures[TR_I_OPAQUE_COLOR] = textures[TR_I_SEQ_FORMS];
        state->textures[TR_I_SCENE_DEPTH] = textures[TR_I_SEQ_SEED];
        state->textures[TR_I_MARK] = textures[TR_I_SEQ_NEAREST];
        break;
    case TR_PASS_COMPOSE_LAYERS:
        state->textures[TR_I_FRONT_DEPTH] = textures[TR_I_SEQ_LAYER_ALPHAS];
        state->textures[TR_I_FRONT_OWNER] = textures[TR_I_SEQ_CHAIN];
        state->textures[TR_I_LAYER_COLOR] = textures[TR_I_SEQ_LAYER_COLOR];
        state->textures[TR_I_CROSSINGS] = textures[TR_I_SEQ_REACH];
        break;
    default:
        break;
    }
}

/* The framebuffer of a step; -1: the host's. */
static int tr_i_step_fbo(const tr_i_step *step) {
    switch ((tr_pass_kind)step->kind) {
    case TR_PASS_BLOCK:
        return TR_I_SEQ_FBO_BLOCK;
    case TR_PASS_WIPE:
    case TR_PASS_SEEDS:
        return TR_I_SEQ_FBO_SEED;
    case TR_PASS_ROWS:
        return TR_I_SEQ_FBO_ROWS;
    case TR_PASS_NEAREST:
        return TR_I_SEQ_FBO_NEAREST;
    case TR_PASS_MASKS:
        return TR_I_SEQ_FBO_ALPHAS;
    case TR_PASS_COUNT:
        return TR_I_SEQ_FBO_COUNTS;
    case TR_PASS_PAINT_DEPTH:
        /* The first of each sweep clears the colour that is attached. */
        return !step->own ? -1 : step->subtract ? TR_I_SEQ_FBO_OWN : TR_I_SEQ_FBO_COUNTS;
    case TR_PASS_PAINT:
        return step->own ? TR_I_SEQ_FBO_OWN : -1;
    case TR_PASS_EXTENTS:
        return TR_I_SEQ_FBO_EXTENTS;
    case TR_PASS_FORMS:
        return TR_I_SEQ_FBO_FORMS;
    case TR_PASS_REACH:
        return TR_I_SEQ_FBO_REACH;
    case TR_PASS_PEEL_UNITS:
        return TR_I_SEQ_FBO_PEEL + step->layer;
    case TR_PASS_KEEP:
        return TR_I_SEQ_FBO_KEEP + step->layer;
    case TR_PASS_SHARE:
        return TR_I_SEQ_FBO_SHARE + step->layer;
    default:
        return -1;
    }
}

/* Viewport, and scissor to where masks are, in texels of what is drawn into. */
static void tr_i_step_extent(const tr_i_sequence *seq, int fbo, tr_state *state) {
    int attached[3], slices[3], size[3], texture, across, up;
    const int *box = seq->bounds;
    tr_i_seq_attachments(fbo, attached, slices);
    texture = attached[1] >= 0 ? attached[1] : attached[0];
    tr_i_seq_size(texture, seq->extent, size);
    across = texture == TR_I_SEQ_ROWS || texture == TR_I_SEQ_NEAREST ? seq->extent[2] : 1;
    up = texture == TR_I_SEQ_NEAREST ? seq->extent[2] : 1;
    state->viewport[2] = size[0];
    state->viewport[3] = size[1];
    /* Boxes of cells reach a cell further; what units are painted into, and what they read there, is whole. */
    if (across > 1 || texture == TR_I_SEQ_EXTENTS || texture == TR_I_SEQ_FORMS || fbo == TR_I_SEQ_FBO_ALPHAS ||
        fbo == TR_I_SEQ_FBO_OWN || fbo == TR_I_SEQ_FBO_COUNTS)
        return;
    state->scissor[0] = box[0] / across;
    state->scissor[1] = box[1] / up;
    state->scissor[2] = (box[2] + across - 1) / across - state->scissor[0];
    state->scissor[3] = (box[3] + up - 1) / up - state->scissor[1];
}

static void tr_i_place_step(const tr_context *tr, const tr_i_step *step, tr_state *state) {
    const tr_i_sequence *seq = &tr->seq;
    int fbo = tr_i_step_fbo(step), program = tr_i_seq_program(seq, step);
    tr_pass_kind kind = (tr_pass_kind)step->kind;
    state->framebuffer = fbo >= 0 ? seq->fbos[fbo] : tr->frame.framebuffer;
    state->viewport[0] = fbo >= 0 ? 0 : tr->frame.x;
    state->viewport[1] = fbo >= 0 ? 0 : tr->frame.y;
    state->viewport[2] = tr->frame.width;
    state->viewport[3] = tr->frame.height;
    if (kind == TR_PASS_COMPOSE_LAYERS) {
        state->scissor[0] = tr->frame.x + seq->bounds[0];
        state->scissor[1] = tr->frame.y + seq->bounds[1];
        state->scissor[2] = seq->bounds[2] - seq->bounds[0];
        state->scissor[3] = seq->bounds[3] - seq->bounds[1];
    } else if (fbo >= 0) {
        tr_i_step_extent(seq, fbo, state);
    }
    state->program = tr->programs[tr_i_step_program(seq, step)].name;
    if (program >= 0) {
        state->vertex_array = tr->vertex_array;
        state->vertex_count = step->count ? 6 * (int)step->count : 3;
    }
    state->first_texture_unit = tr->desc.first_texture_unit;
    tr_i_bind_step(seq, step, state);
    state->uniform_buffer = seq->buffer;
    state->uniform_binding = tr->desc.uniform_binding;
    state->uniform_offset = (int)(step->block * TR_I_SEQ_STRIDE);
    state->uniform_size = TR_I_SEQ_STRIDE;
    state->srgb = fbo < 0 && (tr->frame.wishes.options & TR_WISH_SRGB);
}

static void tr_i_blend_step(const tr_i_sequence *seq, const tr_i_step *step, tr_state *state) {
    state->blend = 1;
    switch ((tr_pass_kind)step->kind) {
    case TR_PASS_MASKS:
    case TR_PASS_SHARE:
        state->blend_equation = seq->product ? 0 : TR_I_GL_MIN;
        state->blend_source = state->blend_source_alpha = seq->product ? TR_I_GL_ZERO : TR_I_GL_ONE;
        state->blend_destination = state->blend_destination_alpha = seq->product ? TR_I_GL_SRC_COLOR : TR_I_GL_ONE;
        break;
    case TR_PASS_COUNT:
        state->blend_equation = step->subtract ? TR_I_GL_FUNC_REVERSE_SUBTRACT : 0;
        state->blend_source = state->blend_source_alpha = TR_I_GL_ONE;
        state->blend_destination = state->blend_destination_alpha = TR_I_GL_ONE;
        break;
    case TR_PASS_PAINT: /* into our own: premultiplied, with alpha; the host's alpha is left alone */
        state->blend_source = TR_I_GL_SRC_ALPHA;
        state->blend_destination = TR_I_GL_ONE_MINUS_SRC_ALPHA;
        state->blend_source_alpha = step->own ? TR_I_GL_ONE : TR_I_GL_ZERO;
        state->blend_destination_alpha = step->own ? TR_I_GL_ONE_MINUS_SRC_ALPHA : TR_I_GL_ONE;
        break;
    case TR_PASS_COMPOSE_LAYERS:
        state->blend_source_alpha = TR_I_GL_ZERO;
        state->blend_destination_alpha = TR_I_GL_ONE;
        break;
    case TR_PASS_PAINT_OVER:
        state->blend_source = TR_I_GL_ONE;
        state->blend_destination = TR_I_GL_ONE_MINUS_SRC_ALPHA;
        state->blend_source_alpha = TR_I_GL_ZERO;
        state->blend_destination_alpha = TR_I_GL_ONE;
        break;
    default:
        state->blend = 0;
        break;
    }
}

static void tr_i_clear_step(tr_pass_kind kind, int reversed, int colors, tr_state *state) {
    int nearest = kind == TR_PASS_REACH, i;
    state->clear_color = kind == TR_PASS_MASKS || kind == TR_PASS_SHARE || kind == TR_PASS_PAINT_DEPTH;
    state->clear_depth = !colors;
    state->clear_depth_value = reversed == nearest ? 1.0f : 0.0f;
    for (i = 0; i < 4 && colors; ++i)
        state->clear_color_value[i] = 1.0f;
}

static void tr_i_test_step(const tr_context *tr, const tr_i_step *step, tr_state *state) {
    int reversed = tr->desc.reversed_z;
    tr_i_u nearer = reversed ? TR_I_GL_GREATER : TR_I_GL_LESS;
    tr_pass_kind kind = (tr_pass_kind)step->kind;
    int colors = kind == TR_PASS_EXTENTS || kind == TR_PASS_FORMS || kind == TR_PASS_ROWS || kind == TR_PASS_NEAREST ||
                 kind == TR_PASS_MASKS || kind == TR_PASS_KEEP || kind == TR_PASS_SHARE ||
                 kind == TR_PASS_COMPOSE_LAYERS;
    int later = kind == TR_PASS_PAINT || kind == TR_PASS_COUNT;
    state->blend_source = state->blend_source_alpha = TR_I_GL_ONE;
    state->front_face = tr->desc.front_face_cw ? TR_I_GL_CW : TR_I_GL_CCW;
    state->color_write = colors || later || kind == TR_PASS_PAINT_OVER || kind == TR_PASS_PEEL_UNITS;
    state->depth_test = state->depth_write = !colors;
    state->depth_func = nearer;
    state->cull_face = tr_i_seq_program(&tr->seq, step) < 0 ? TR_I_GL_BACK : 0;
    if (kind == TR_PASS_WIPE || kind == TR_PASS_PAINT_OVER)
        state->depth_func = kind == TR_PASS_WIPE ? TR_I_GL_ALWAYS : reversed ? TR_I_GL_GEQUAL : TR_I_GL_LEQUAL;
    if (kind == TR_PASS_REACH)
        state->depth_func = reversed ? TR_I_GL_LESS : TR_I_GL_GREATER;
    if (later && !step->hollow) {
        state->depth_func = TR_I_GL_EQUAL;
        state->depth_write = 0;
    }
    if (kind == TR_PASS_COUNT && step->hollow && step->subtract)
        state->depth_write = 0;
    if (step->clear)
        tr_i_clear_step(kind, reversed, colors, state);
    tr_i_blend_step(&tr->seq, step, state);
}

static void tr_i_fill_step(tr_context *tr, const tr_i_step *step, tr_pass *pass) {
    const tr_i_sequence *seq = &tr->seq;
    const tr_i_array *list = step->kind == (uint8_t)TR_PASS_SCENE ? &seq->scene : &seq->list;
    memset(pass, 0, sizeof *pass);
    pass->kind = (tr_pass_kind)step->kind;
    pass->rule = (tr_rule)step->rule;
    pass->name = tr_pass_kind_name(pass->kind);
    if (tr_i_seq_program(seq, step) < 0) {
        pass->units = (const uint32_t *)list->items + step->first;
        pass->unit_count = step->count;
    }
    if (pass->kind == TR_PASS_SCENE) { /* the first of the plan, as in the other rungs */
        tr_i_fill_see_bindings(tr, 0, &pass->state);
        tr_i_fill_see_tests(tr, 0, &pass->state);
        return;
    }
    tr_i_place_step(tr, step, &pass->state);
    tr_i_test_step(tr, step, &pass->state);
}

static int tr_i_next_step(tr_context *tr, tr_pass *pass) {
    tr_i_sequence *seq = &tr->seq;
    while (seq->step < seq->steps.count) {
        tr_i_fill_step(tr, (const tr_i_step *)seq->steps.items + seq->step++, pass);
        tr_i_apply_see(tr, pass);
        if (tr->desc.state == TR_STATE_NONE || pass->state.vertex_count == 0)
            return 1;
        tr_i_draw_triangle(tr, &pass->state);
    }
    return 0;
}

/* ---- dynamic transparency: the passes of all rungs ---- */

/* Of the first viewport: the one that copies heed. */
static void tr_i_switch_scissor(const tr_context *tr, int on) {
    if (tr->has_viewports)
        tr_i_switch_of(tr, TR_I_GL_SCISSOR_TEST, 0, on);
    else
        tr_i_switch(tr, TR_I_GL_SCISSOR_TEST, on);
}

/* Copies what the host has drawn so far, depth or colour, to where a pass of the plan says. Between parts of the scene: the
   host's state stays, without a snapshot of all of it. */
static void tr_i_take(tr_context *tr, int index) {
    const tr_i_gl *gl = &tr->gl;
    const int *box = tr->see.plan.rectangle;
    int fbo = tr_i_see_fbo_of(&tr->see, index), x = tr->frame.x, y = tr->frame.y;
    int x1 = box[0] + box[2], y1 = box[1] + box[3];
    tr_i_u what = fbo == TR_I_SEE_FBO_TAKE_COLOR ? TR_I_GL_COLOR_BUFFER_BIT : TR_I_GL_DEPTH_BUFFER_BIT;
    int32_t drawn = 0, read = 0, bound[2] = {0, 0};
    int cut = gl->IsEnabled(TR_I_GL_SCISSOR_TEST);
    if (what == TR_I_GL_DEPTH_BUFFER_BIT && tr_i_depths[tr->see.held_depth].stencil)
        what |= TR_I_GL_STENCIL_BUFFER_BIT; /* both at once are moved as they are */
    gl->GetIntegerv(TR_I_GL_DRAW_FRAMEBUFFER_BINDING, &bound[0]);
    gl->GetIntegerv(TR_I_GL_READ_FRAMEBUFFER_BINDING, &bound[1]);
    tr_i_switch_scissor(tr, 0);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->frame.framebuffer);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, tr->frame.framebuffer);
    gl->GetIntegerv(TR_I_GL_DRAW_BUFFER0, &drawn);
    gl->GetIntegerv(TR_I_GL_READ_BUFFER, &read);
    gl->ReadBuffer((tr_i_u)drawn);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->see.fbos[fbo]);
    gl->BlitFramebuffer(x + box[0], y + box[1], x + x1, y + y1, box[0], box[1], x1, y1, what, TR_I_GL_NEAREST);
    gl->ReadBuffer((tr_i_u)read);
    gl->BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, (tr_i_u)bound[0]);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, (tr_i_u)bound[1]);
    tr_i_switch_scissor(tr, cut);
}

/* What may show through the masks of the next region, in the region's rectangle. 0: no region is left. */
static int tr_i_next_region(tr_context *tr, tr_pass *pass) {
    tr_i_see *see = &tr->see;
    const tr_i_grid *grid = &see->grid;
    const int *region = grid->regions[see->region];
    size_t i;
    int cells[4], k;
    see->counts[TR_I_UNITS_REGION] = 0;
    for (i = 0; i < see->counts[TR_I_UNITS_BEHIND]; ++i) {
        uint32_t unit = see->lists[TR_I_UNITS_BEHIND][i];
        tr_i_cells_of(grid, &see->places[unit], 0, cells);
        for (k = 0; k < 2; ++k) {
            cells[k] = cells[k] > region[k] ? cells[k] : region[k];
            cells[k + 2] = cells[k + 2] < region[k + 2] ? cells[k + 2] : region[k + 2];
        }
        if (tr_i_any_cell(grid->nearest_target, cells, 3.0e38f, 1.0f))
            tr_i_list(see, TR_I_UNITS_REGION, unit);
    }
    pass->units = see->lists[TR_I_UNITS_REGION];
    pass->unit_count = see->counts[TR_I_UNITS_REGION];
    for (k = 0; k < 2; ++k) {
        int size = k ? see->height : see->width, end = region[k + 2] * grid->side;
        pass->state.scissor[k] = region[k] * grid->side;
        pass->state.scissor[k + 2] = (end < size ? end : size) - pass->state.scissor[k];
    }
    return ++see->region < grid->region_count;
}

static int tr_i_next_see_pass(tr_context *tr, tr_pass *pass) {
    tr_i_see *see = &tr->see;
    if (tr->seq.active && see->plan.see != TR_SEE_OFF)
        return tr_i_next_step(tr, pass);
    while (see->step < see->plan.pass_count) {
        int index = see->step++;
        const tr_see_pass *planned = &see->plan.passes[index];
        if (planned->kind == TR_PASS_TAKE) {
            tr_i_take(tr, index);
            continue;
        }
        memset(pass, 0, sizeof *pass);
        pass->kind = planned->kind;
        pass->rule = planned->rule;
        pass->name = tr_pass_kind_name(planned->kind);
        pass->units = tr_i_see_units(see, index);
        pass->unit_count = planned->unit_count;
        tr_i_fill_see_bindings(tr, index, &pass->state);
        tr_i_fill_see_tests(tr, index, &pass->state);
        see->step -= planned->kind == TR_PASS_BEHIND && tr_i_next_region(tr, pass);
        tr_i_apply_see(tr, pass);
        if (tr->desc.state == TR_STATE_NONE || pass->state.vertex_count == 0)
            return 1;
        tr_i_draw_triangle(tr, &pass->state);
    }
    return 0;
}

/* ---- dynamic transparency: what is hidden ----------------------------------------------------------------------- */

/* Starts to copy the answer of this frame to where it can be read when it is there. Nothing where all buffers of the ring
   are under way: then a later frame answers. */
static void tr_i_ask(tr_context *tr) {
    static const tr_i_u names[4] = {0x0D05u, 0x0D02u, 0x0D03u, 0x0D04u}; /* GL_PACK_ALIGNMENT, ROW_LENGTH, SKIP_* */
    const tr_i_gl *gl = &tr->gl;
    tr_i_see *see = &tr->see;
    tr_i_query *query = &see->queries[see->next_query];
    tr_i_see_format format = tr_i_see_format_of(TR_I_SEE_QUERY, 0, 0);
    int32_t pack[4], bound[2] = {0, 0};
    int size[2], i;
    if (query->fence)
        return;
    tr_i_see_size(&format, see->width, see->height, see->divisor, size);
    gl->GetIntegerv(TR_I_GL_PIXEL_PACK_BUFFER_BINDING, &bound[0]);
    gl->GetIntegerv(TR_I_GL_READ_FRAMEBUFFER_BINDING, &bound[1]);
    for (i = 0; i < 4; ++i) {
        gl->GetIntegerv(names[i], &pack[i]);
        gl->PixelStorei(names[i], i == 0 ? 4 : 0);
    }
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, see->fbos[TR_I_SEE_FBO_QUERY]);
    gl->BindBuffer(TR_I_GL_PIXEL_PACK_BUFFER, query->buffer);
    gl->ReadPixels(0, 0, size[0], size[1], TR_I_GL_RGBA, TR_I_GL_UNSIGNED_BYTE, 0);
    query->fence = gl->FenceSync(TR_I_GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    query->texels = (size_t)size[0] * (size_t)size[1];
    query->stale = 0;
    for (i = 0; i < 4; ++i)
        gl->PixelStorei(names[i], pack[i]);
    gl->BindFramebuffer(TR_I_GL_READ_FRAMEBUFFER, (tr_i_u)bound[1]);
    gl->BindBuffer(TR_I_GL_PIXEL_PACK_BUFFER, (tr_i_u)bound[0]);
    see->next_query = (see->next_query + 1) % TR_I_QUERY_RING;
}

/* Counts texels by id. */
static void tr_i_count_texels(tr_i_see *see, const unsigned char *texels, size_t count) {
    size_t i;
    memset(see->answer, 0, (TR_I_MAX_UNIT_ID + 1) * sizeof see->answer[0]);
    for (i = 0; i < count; ++i) {
        const unsigned char *texel = texels + 4 * i;
        tr_i_answer *answer = &see->answer[texel[0] | (unsigned)texel[1] << 8];
        ++answer->texels;
        answer->hidden += texel[2] != 0;
    }
}

/* Takes what has arrived, oldest first; the last of it stays. */
static void tr_i_take_answers(tr_context *tr) {
    const tr_i_gl *gl = &tr->gl;
    int i;
    for (i = 0; i < TR_I_QUERY_RING; ++i) {
        tr_i_query *query = &tr->see.queries[(tr->see.next_query + i) % TR_I_QUERY_RING];
        const void *texels;
        int32_t bound = 0;
        tr_i_u status;
        if (!query->fence)
            continue;
        status = gl->ClientWaitSync(query->fence, TR_I_GL_SYNC_FLUSH_COMMANDS_BIT, 0);
        if (status != TR_I_GL_ALREADY_SIGNALED && status != TR_I_GL_CONDITION_SATISFIED)
            return;
        gl->DeleteSync(query->fence);
        query->fence = 0;
        gl->GetIntegerv(TR_I_GL_PIXEL_PACK_BUFFER_BINDING, &bound);
        gl->BindBuffer(TR_I_GL_PIXEL_PACK_BUFFER, query->buffer);
        texels = gl->MapBufferRange(TR_I_GL_PIXEL_PACK_BUFFER, 0, (ptrdiff_t)(4 * query->texels), TR_I_GL_MAP_READ_BIT);
        if (texels && !query->stale)
            tr_i_count_texels(&tr->see, (const unsigned char *)texels, query->texels);
        if (texels)
            gl->UnmapBuffer(TR_I_GL_PIXEL_PACK_BUFFER);
        gl->BindBuffer(TR_I_GL_PIXEL_PACK_BUFFER, (tr_i_u)bound);
    }
}

TR_I_API tr_result tr_query_hidden(tr_context *tr, tr_hidden *out, size_t capacity, size_t *count) {
    uint32_t id;
    if (!tr || !count || (capacity && !out))
        return TR_INVALID_ARGUMENT;
    *count = 0;
    if (!tr->see.answer)
        return TR_OK;
    tr_i_take_answers(tr);
    for (id = 1; id <= TR_I_MAX_UNIT_ID; ++id) {
        const tr_i_answer *answer = &tr->see.answer[id];
        if (answer->texels == 0)
            continue;
        if (*count < capacity) {
            out[*count].id = id;
            out[*count].pixels = 16 * answer->texels;
            out[*count].hidden = 16 * answer->hidden;
        }
        ++*count;
    }
    return TR_OK;
}

/* Whether the frame has come to what a query asks. */
static int tr_i_has_asked(const tr_i_see *see) {
    int i;
    for (i = 0; i < see->step; ++i)
        if (see->plan.passes[i].kind == TR_PASS_HIDES)
            return 1;
    return 0;
}

/* Ends a frame of dynamic transparency. */
static void tr_i_end_see(tr_context *tr) {
    if (tr_i_has_asked(&tr->see))
        tr_i_ask(tr);
    if (tr->see.entered == TR_I_LENT)
        tr_i_take_from_host(tr);
    if (tr->see.entered != TR_I_INSIDE || tr->desc.state == TR_STATE_LEAVE_DIRTY)
        return;
    if (tr->desc.state == TR_STATE_LEAVE_DEFAULTS)
        tr_i_save_defaults(&tr->saved);
    tr_i_restore(tr, &tr->saved);
}

TR_I_API int tr_next_pass(tr_context *tr, tr_pass *pass) {
    if (!tr || !pass || !tr->in_frame)
        return 0;
    if (tr->see.active)
        return tr_i_next_see_pass(tr, pass);
    while (tr->next_pass < tr->plan.pass_count) {
        const tr_plan_pass *plan = &tr->plan.passes[tr->next_pass++];
        memset(pass, 0, sizeof *pass);
        pass->kind = plan->kind;
        pass->rule = plan->rule;
        pass->classes = plan->classes;
        pass->lines = plan->lines;
        pass->layer = plan->layer;
        pass->name = tr_pass_kind_name(plan->kind);
        tr_i_fill_bindings(tr, plan, &pass->state);
        tr_i_fill_tests(tr, plan, &pass->state);
        if (tr->desc.state == TR_STATE_NONE)
            return 1;
        tr_i_apply(tr, &pass->state);
        if (pass->state.vertex_count == 0)
            return 1;
        tr_i_draw_triangle(tr, &pass->state);
    }
    return 0;
}

TR_I_API int tr_pass_draws(const tr_pass *pass, const tr_object *object) {
    uint32_t flags;
    if (!pass || !object)
        return 0;
    if (pass->kind == TR_PASS_OPAQUE && (object->flags & TR_DRAWN))
        return 0;
    flags = object->flags & (TR_TRANSPARENT | TR_TWO_SIDED);
    return (int)((pass->classes >> flags) & 1u);
}

TR_I_API void tr_outline_uniform(const tr_context *tr, float uniform[3]) {
    if (!tr || !uniform)
        return;
    uniform[0] = tr->outline_pixel;
    uniform[1] = tr->width > 0 ? (float)tr->outline_width / (float)tr->width : 0;
    uniform[2] = tr->height > 0 ? (float)tr->outline_height / (float)tr->height : 0;
}

static void tr_i_set_edge_uniforms(const tr_context *tr, const tr_i_program *program, const tr_material *material) {
    const tr_edge_set *set = material->edges;
    tr_i_u first = material->first_triangle;
    if (!set) {
        tr->gl.Uniform4ui(program->edge_ranges, 0, 0, 0, TR_I_NO_LIST);
        return;
    }
    first = tr->frame.wishes.alpha == TR_ALPHA_CANDIDATES && set->ranges[3] != TR_I_NO_LIST ? first : 0;
    tr->gl.Uniform4ui(program->edge_ranges, set->ranges[0], set->ranges[1], set->ranges[2] + first, set->ranges[3]);
    tr->gl.Uniform4fv(program->edge_frame, 4, set->frame);
}

TR_I_API void tr_set_material(tr_context *tr, const tr_pass *pass, const tr_material *material) {
    const tr_i_program *program;
    const tr_i_gl *gl;
    if (!tr || !pass || !material || (unsigned)pass->rule >= (unsigned)TR_RULE_SEE_END || pass->lines)
        return;
    gl = &tr->gl;
    program = &tr->programs[tr_i_surface_program(tr, (int)pass->rule)];
    if (pass->kind == TR_PASS_SCENE && !tr_i_use_in_scene(tr, (int)pass->rule))
        return;
    gl->UniformMatrix4fv(program->model_view_projection, 1, 0, material->model_view_projection);
    if (program->normal_matrix >= 0)
        gl->UniformMatrix3fv(program->normal_matrix, 1, 0, material->normal_matrix);
    if (program->color >= 0)
        gl->Uniform4fv(program->color, 1, material->color);
    if (program->falloff >= 0)
        gl->Uniform2f(program->falloff, material->d_max, material->k);
    if (program->object >= 0)
        gl->Uniform1ui(program->object, material->object);
    if (program->model >= 0)
        gl->UniformMatrix4fv(program->model, 1, 0, material->model);
    if (program->crossing_range >= 0)
        gl->Uniform2i(program->crossing_range, material->crossing_first, material->crossing_count);
    if (program->edge_ranges >= 0)
        tr_i_set_edge_uniforms(tr, program, material);
    if (program->outline >= 0) {
        float outline[3];
        tr_outline_uniform(tr, outline);
        gl->Uniform3f(program->outline, outline[0], outline[1], outline[2]);
    }
}

/* ---- outlines in an image ---------------------------------------------------------------------------------------- */

static tr_result tr_i_fit_outlines(tr_context *tr, int width, int height) {
    int i;
    if (tr->outline_width == width && tr->outline_height == height)
        return TR_OK;
    tr_i_drop_outlines(tr);
    tr->gl.ActiveTexture(TR_I_GL_TEXTURE0 + (tr_i_u)(tr->desc.first_texture_unit + TR_I_MARK));
    tr->gl.BindBuffer(TR_I_GL_PIXEL_UNPACK_BUFFER, 0);
    tr->gl.GenTextures(2, tr->outline_textures);
    tr->gl.GenFramebuffers(2, tr->outline_fbos);
    for (i = 0; i < 2; ++i) {
        tr->gl.BindTexture(TR_I_GL_TEXTURE_2D, tr->outline_textures[i]);
        tr->gl.TexImage2D(TR_I_GL_TEXTURE_2D, 0, (int32_t)TR_I_GL_RG16UI, width, height, 0, TR_I_GL_RG_INTEGER,
                          TR_I_GL_UNSIGNED_SHORT, 0);
        tr->gl.TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MIN_FILTER, TR_I_GL_NEAREST);
        tr->gl.TexParameteri(TR_I_GL_TEXTURE_2D, TR_I_GL_TEXTURE_MAG_FILTER, TR_I_GL_NEAREST);
        tr->gl.BindFramebuffer(TR_I_GL_DRAW_FRAMEBUFFER, tr->outline_fbos[i]);
        tr->gl.FramebufferTexture2D(TR_I_GL_DRAW_FRAMEBUFFER, TR_I_GL_COLOR_ATTACHMENT0, TR_I_GL_TEXTURE_2D,
                                    tr->outline_textures[i], 0);
        if (tr->gl.CheckFramebufferStatus(TR_I_GL_DRAW_FRAMEBUFFER) != TR_I_GL_FRAMEBUFFER_COMPLETE) {
            tr_i_drop_outlines(tr);
            return tr_i_fail(&tr->desc, TR_TARGET_INCOMPLETE, "tr_find_outlines");
        }
    }
    tr->outline_width = width;
    tr->outline_height = height;
    return TR_OK;
}

/* One draw over the whole image into outline texture `to`, reading the other one. */
static void tr_i_outline_pass(tr_context *tr, const tr_outlines *image, int program, int to, int jump) {
    const tr_i_program *made = &tr->programs[program];
    double half = fabs(2.0 / ((double)image->projection[5] * (double)image->height));
    float law[4];
    tr_state state;
    int i;
    memset(&state, 0, sizeof state);
    state.framebuffer = tr->outline_fbos[to];
    state.viewport[2] = image->width;
    state.viewport[3] = image->height;
    state.program = made->name;
    state.vertex_array = tr->vertex_array;
    state.vertex_count = 3;
    state.first_texture_unit = tr->desc.first_texture_unit;
    for (i = 0; i < TR_TEXTURE_UNITS; ++i)
        state.texture_targets[i] = tr_i_targets[i];
    state.textures[TR_I_SCENE_DEPTH] = image->depth_texture;
    state.textures[TR_I_OPAQUE_COLOR] = image->id_texture;
    state.textures[TR_I_MARK] = tr->outline_textures[1 - to];
    state.color_write = 1;
    state.depth_func = TR_I_GL_ALWAYS;
    state.blend_source = state.blend_source_alpha = TR_I_GL_ONE;
    state.front_face = TR_I_GL_CCW;
    tr_i_apply(tr, &state);
    tr_i_eye_depth(image->projection, tr->desc.zero_to_one, law);
    if (made->jump >= 0)
        tr->gl.Uniform1i(made->jump, jump);
    if (made->depth_law >= 0)
        tr->gl.Uniform4fv(made->depth_law, 1, law);
    if (made->pixel >= 0)
        tr->gl.Uniform2f(made->pixel, (float)(half * (double)image->projection[15]),
                         (float)(-half * (double)image->projection[11]));
    tr_i_draw_triangle(tr, &state);
}

static tr_result tr_i_check_outlines(const tr_context *tr, const tr_outlines *image) {
    if (image->depth_texture == 0)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "tr_outlines.depth_texture");
    if (image->width < 1 || image->height < 1)
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "tr_outlines.width or height");
    if (image->width > tr->max_width || image->height > tr->max_height || image->width > 65535 || image->height > 65535)
        return tr_i_fail(&tr->desc, TR_TOO_LARGE, "tr_outlines.width or height");
    if (!tr_i_all_finite(image->projection, 16) || image->projection[5] == 0.0f ||
        image->projection[10] * image->projection[15] == image->projection[11] * image->projection[14])
        return tr_i_fail(&tr->desc, TR_INVALID_ARGUMENT, "tr_outlines.projection");
    return TR_OK;
}

/* Jumps of half the image, a quarter and so on to 1, and 1 once more, which mends most of what the rest got wrong. */
static void tr_i_flood(tr_context *tr, const tr_outlines *image, int program) {
    int side = image->width > image->height ? image->width : image->height, jump = 1, again = 1;
    while (2 * jump < side)
        jump *= 2;
    tr->outline_at = 0;
    tr_i_outline_pass(tr, image, program, 0, 0);
    for (; jump > 0; jump = jump > 1 ? jump / 2 : again--) {
        tr->outline_at = 1 - tr->outline_at;
        tr_i_outline_pass(tr, image, program + 1, tr->outline_at, jump);
    }
}

TR_I_API tr_result tr_find_outlines(tr_context *tr, const tr_outlines *image) {
    int program = TR_I_PROGRAM_OUTLINE + (image && image->id_texture ? 2 : 0);
    tr_result result;
    if (!tr || !image)
        return TR_INVALID_ARGUMENT;
    if (tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_find_outlines");
    result = tr_i_check_outlines(tr, image);
    if (result != TR_OK)
        return result;
    tr_i_save(tr, &tr->saved);
    if (!tr->vertex_array)
        tr->gl.GenVertexArrays(1, &tr->vertex_array);
    result = tr_i_fit_outlines(tr, image->width, image->height);
    if (result == TR_OK)
        result = tr_i_make_program(tr, program);
    if (result == TR_OK)
        result = tr_i_make_program(tr, program + 1);
    if (result == TR_OK) {
        tr_i_flood(tr, image, program);
        tr->outline_pixel = (float)fabs(2.0 / ((double)image->projection[5] * (double)image->height));
    }
    tr_i_restore(tr, &tr->saved);
    return result;
}

TR_I_API tr_result tr_end(tr_context *tr) {
    if (!tr)
        return TR_INVALID_ARGUMENT;
    if (!tr->in_frame)
        return tr_i_fail(&tr->desc, TR_WRONG_ORDER, "tr_end");
    tr->in_frame = 0;
    if (tr->see.active) {
        tr_i_end_see(tr);
        return TR_OK;
    }
    if (tr->plan.pass_count == 0)
        return TR_OK;
    if (tr->desc.state == TR_STATE_RESTORE) {
        tr_i_restore(tr, &tr->saved);
    } else if (tr->desc.state == TR_STATE_LEAVE_DEFAULTS) {
        tr_i_save_defaults(&tr->saved);
        tr_i_restore(tr, &tr->saved);
    }
    return TR_OK;
}

#endif /* TRANSPARENCY_IMPLEMENTATION_ONCE */
#endif /* TRANSPARENCY_IMPLEMENTATION */

/*
MIT License

Copyright (c) 2026 the Glassine authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
