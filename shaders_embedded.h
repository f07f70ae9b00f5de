/*
shaders_embedded.h - v0.1.0 - all of Glassine's GLSL as named strings, for hosts with passes of their own - MIT licence

DOES      hands out each file of Glassine's shaders/ folder by its name, as the strings that glShaderSource takes.
DOES NOT  call OpenGL, allocate, or read files. transparency.h and oit_buffers.h do not need this header: each of them
          carries the GLSL that it uses itself.

QUICK START

    --8<-- quick start
    #include <stdio.h>
    #define SHADERS_EMBEDDED_IMPLEMENTATION
    #include "shaders_embedded.h"

    int main(void) {
        int i, j, chunk_count;
        for (i = 0; i < shaders_count(); i++) {
            const char *const *chunks = shaders_get(shaders_name(i), &chunk_count);
            printf("======== %s ========\n", shaders_name(i));
            for (j = 0; j < chunk_count; j++)
                fputs(chunks[j], stdout);
        }
        return 0;
    }
    -->8--

HOW TO BUILD
    Copy this file. In exactly one C or C++ file define SHADERS_EMBEDDED_IMPLEMENTATION before including it:

        #define SHADERS_EMBEDDED_IMPLEMENTATION
        #include "shaders_embedded.h"

    C99 or C++11, and the C standard library's strcmp. Nothing to link.

OPTIONS
    SHADERS_STATIC    (wherever the header is included) the functions are static. Each file that includes the header then
                      defines SHADERS_EMBEDDED_IMPLEMENTATION as well, and has a copy of its own.

OPENGL
    No function of this header calls OpenGL, so there is no lowest version and no state is touched. What each shader
    needs is said in its first lines. No file has a #version line: the program that compiles it writes one in front.

ERRORS, MEMORY, THREADS
    An unknown name or index gives a null pointer. Strings are constant data that live as long as the program. Nothing
    is written, so that every function may be called from any thread at any time.

RECIPES
    Compile a stage, with what it includes, behind a preamble of the program's own (GL 4.1 or ES 3.0 shown):

        const char *strings[64];
        int count = 0, chunk_count, i;
        const char *const *chunks = shaders_get("cool_to_warm.glsl", &chunk_count);
        strings[count++] = "#version 410 core\n";
        for (i = 0; i < chunk_count; i++)
            strings[count++] = chunks[i];
        strings[count++] = my_fragment_main;
        glShaderSource(shader, count, strings, NULL);

LIMITS
    A string is shorter than 4,000 bytes, because C99 promises no more than 4,095. It starts with a #line of its own, so
    that a compiler's messages name the line in the shader's file whether or not it counts anew in each string. GLSL
    numbers lines after #line in this way from 3.30 and ES 3.00 on.

The licence (MIT) stands at the end of this file.
*/

#ifndef SHADERS_EMBEDDED_H
#define SHADERS_EMBEDDED_H

#define SHADERS_VERSION 100 /* major * 10000 + minor * 100 + patch: 0.1.0 */

/* How the functions are declared; not for users. A file need not use all that are static in it. */
#if !defined(SHADERS_STATIC)
#define SHADERS_DEF extern
#elif defined(__GNUC__) || defined(__clang__)
#define SHADERS_DEF static __attribute__((unused))
#else
#define SHADERS_DEF static
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The shader of that name, as in "surface.vert": an array of *chunk_count strings, followed by a null pointer, whose
   concatenation is the shader's text. An unknown or null name gives NULL and 0. chunk_count may be null. */
SHADERS_DEF const char *const *shaders_get(const char *name, int *chunk_count);

/* How many shaders there are. */
SHADERS_DEF int shaders_count(void);

/* The name of a shader, 0 <= index < shaders_count(), sorted by bytes. NULL for any other index. */
SHADERS_DEF const char *shaders_name(int index);

#ifdef __cplusplus
}
#endif

#endif /* SHADERS_EMBEDDED_H */

#ifdef SHADERS_EMBEDDED_IMPLEMENTATION
#ifndef SHADERS_EMBEDDED_IMPLEMENTATION_ONCE
#define SHADERS_EMBEDDED_IMPLEMENTATION_ONCE

#include <string.h>

typedef struct shaders_i_entry {
    const char *name;
    const char *const *chunks;
    int chunk_count;
} shaders_i_entry;

/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */
/* clang-format off */
static const char *const shaders_i_shader_alpha_law_glsl[] = {
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
static const char *const shaders_i_shader_compose_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// The transparent layer over opaque things, into the host's target; Diepstraten 2002, sections 5 and 7.\n"
    "//\n"
    "// alpha_t, C_t: the transparent surface; w, C_d: what is behind it, an opaque thing or the background, which is what\n"
    "// the host's target holds. All three blendings have the form rgb + a * target, drawn with the blend function\n"
    "// (ONE, SRC_ALPHA), so that the target's own alpha is neither needed nor touched.\n"
    "#define TR_BLENDING_OVER 0\n"
    "#define TR_BLENDING_NORMALISED 1\n"
    "#define TR_BLENDING_PUBLISHED 2\n"
    "\n"
    "uniform highp sampler2D tr_scene_depth;\n"
    "#if TR_HAS_OPAQUE\n"
    "uniform highp sampler2D tr_opaque_color; // a = 1 where an opaque thing is\n"
    "#endif\n"
    "#if TR_HAS_LAYER\n"
    "uniform highp sampler2D tr_front_depth;\n"
    "uniform highp sampler2D tr_layer_color;\n"
    "#endif\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy);\n"
    "    highp float depth = texelFetch(tr_scene_depth, pixel, 0).r;\n"
    "    gl_FragDepth = depth;\n"
    "#if TR_HAS_OPAQUE\n"
    "    highp vec4 behind = texelFetch(tr_opaque_color, pixel, 0);\n"
    "#else\n"
    "    highp vec4 behind = vec4(0.0);\n"
    "#endif\n"
    "    bool opaque = behind.a > 0.5;\n"
    "    // What is behind, as rgb + keep * target.\n"
    "    highp float keep = opaque ? 0.0 : 1.0;\n"
    "    highp vec3 color = opaque ? behind.rgb : vec3(0.0);\n"
    "#if TR_HAS_LAYER\n"
    "    // The scene's depth is the front-most transparent surface's where that was drawn, and only there.\n"
    "    if (depth != TR_CLEAR_DEPTH && depth == texelFetch(tr_front_depth, pixel, 0).r) {\n"
    "        highp vec4 front = texelFetch(tr_layer_color, pixel, 0);\n"
    "        highp float weight = opaque ? tr_weights.x : tr_weights.y;\n"
    "#if TR_BLENDING == TR_BLENDING_OVER\n"
    "        weight = 1.0 - front.a;\n"
    "#elif TR_BLENDING == TR_BLENDING_NORMALISED\n"
    "        highp float total = front.a + weight;\n"
    "        front.a = total > 0.0 ? front.a / total : 0.0;\n"
    "        weight = 1.0 - front.a;\n"
    "#endif\n"
    "        // The published sum may be above one; where the target adds its own part, its format clamps.\n"
    "        tr_color = vec4(min(front.a * front.rgb + weight * color, 1.0), weight * keep);\n"
    "        return;\n"
    "    }\n"
    "#endif\n"
    "    if (!opaque)\n"
    "        discard;\n"
    "    tr_color = vec4(color, keep);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_cool_to_warm_glsl[] = {
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
static const char *const shaders_i_shader_copy_depth_frag[] = {
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
static const char *const shaders_i_shader_frame_block_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// What is the same for all passes of one frame (std140, written by tr_begin).\n"
    "layout(std140) uniform tr_frame\n"
    "{\n"
    "    highp vec4 tr_light;    // xyz: toward the light, unit length, in the space of the normals\n"
    "    highp vec4 tr_cool;     // rgb, and how much diffuse colour is mixed in\n"
    "    highp vec4 tr_warm;\n"
    "    highp vec4 tr_weights;  // x: of opaque things, y: of the background, z: tolerance of lines in pixels\n"
    "    highp vec4 tr_viewport; // x, y, width, height of the target's viewport\n"
    "    highp vec4 tr_ink[2];   // rgb: creases; outlines\n"
    "};\n",
    0};
static const char *const shaders_i_shader_fullscreen_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// One triangle that covers the viewport; no vertex buffer.\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(corner, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_line_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Feature lines: fragment stage.\n"
    "//\n"
    "// A line lies on the rim of its own surface: tested pixel by pixel, the surface would eat its inner half. So a line's\n"
    "// visibility is that of its centre, against the farthest depth around it: on a silhouette one side always lies\n"
    "// farther, and where something covers the line all sides are nearer.\n"
    "#if TR_ON_TARGET\n"
    "#define TR_ORIGIN ivec2(tr_viewport.xy)\n"
    "#else\n"
    "#define TR_ORIGIN ivec2(0)\n"
    "#endif\n"
    "uniform highp sampler2D tr_scene_depth;\n"
    "in highp vec4 tr_v_line;\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 last = textureSize(tr_scene_depth, 0) - 1;\n"
    "    ivec2 center = ivec2(floor(tr_v_line.xy));\n"
    "    highp float tolerance = tr_v_line.w * tr_weights.z;\n"
    "#ifdef TR_REVERSED_Z\n"
    "    highp float farthest = 1.0;\n"
    "#else\n"
    "    highp float farthest = 0.0;\n"
    "#endif\n"
    "    for (int y = -1; y <= 1; ++y) {\n"
    "        for (int x = -1; x <= 1; ++x) {\n"
    "            highp float depth = texelFetch(tr_scene_depth, clamp(center + ivec2(x, y), ivec2(0), last), 0).r;\n"
    "#ifdef TR_REVERSED_Z\n"
    "            farthest = min(farthest, depth);\n"
    "#else\n"
    "            farthest = max(farthest, depth);\n"
    "#endif\n"
    "        }\n"
    "    }\n"
    "#ifdef TR_REVERSED_Z\n"
    "    if (tr_v_line.z + tolerance < farthest)\n"
    "        discard;\n"
    "#else\n"
    "    if (tr_v_line.z - tolerance > farthest)\n"
    "        discard;\n"
    "#endif\n"
    "    // The nearer of line and surface: passes the depth test wherever the centre is visible, and hides what comes later.\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy) - TR_ORIGIN;\n"
    "    highp float surface = texelFetch(tr_scene_depth, clamp(pixel, ivec2(0), last), 0).r;\n"
    "#ifdef TR_REVERSED_Z\n"
    "    gl_FragDepth = max(tr_v_line.z, surface);\n"
    "#else\n"
    "    gl_FragDepth = min(tr_v_line.z, surface);\n"
    "#endif\n"
    "    tr_color = vec4(tr_ink[TR_INK].rgb, 1.0);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_line_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Feature lines as triangles in screen space: vertex stage. The layout is that of a sil_ribbon_vertex.\n"
    "layout(location = 0) in highp vec4 tr_line_corner; // x, y in pixels, window depth, slack: depth per pixel toward the eye\n"
    "layout(location = 1) in highp vec2 tr_line_center; // the point of the centre line, pixels\n"
    "out highp vec4 tr_v_line;                          // centre x, y, depth, slack\n"
    "\n"
    "void main()\n"
    "{\n"
    "    tr_v_line = vec4(tr_line_center, tr_line_corner.zw);\n"
    "    // Depth is written by the fragment stage, so the clip convention in force does not matter here.\n"
    "    gl_Position = vec4(2.0 * tr_line_corner.xy / tr_viewport.zw - 1.0, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_surface_frag[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Built-in surface program for hosts without shaders of their own: fragment stage.\n"
    "uniform highp uint tr_object;\n"
    "#if TR_WANTS_COLOR\n"
    "in highp vec3 tr_v_normal;\n"
    "in highp vec4 tr_v_color;\n"
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
    "    tr_surface(vec4(tr_cool_to_warm(tr_v_color.rgb, normal, tr_light.xyz, tr_cool, tr_warm), tr_v_color.a), tr_object);\n"
    "#else\n"
    "    tr_surface(vec4(0.0), tr_object);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_surface_vert[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Built-in surface program for hosts without shaders of their own: vertex stage.\n"
    "layout(location = 0) in highp vec3 tr_position;\n"
    "layout(location = 1) in highp vec3 tr_normal;\n"
    "layout(location = 2) in highp float tr_distance; // to the nearest silhouette, see alpha_law.glsl\n"
    "layout(location = 3) in highp vec3 tr_tint;      // added to the object's colour; by default 0\n"
    "\n"
    "uniform highp mat4 tr_model_view_projection;\n"
    "#if TR_WANTS_COLOR\n"
    "uniform highp mat3 tr_normal_matrix;\n"
    "uniform highp vec4 tr_object_color; // a: alpha on the silhouette\n"
    "uniform highp vec2 tr_falloff;      // d_max, k of equation 2; d_max = 0 for a constant alpha\n"
    "out highp vec3 tr_v_normal;\n"
    "out highp vec4 tr_v_color;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if TR_WANTS_COLOR\n"
    "    tr_v_normal = tr_normal_matrix * tr_normal;\n"
    "    tr_v_color = vec4(tr_object_color.rgb + tr_tint,\n"
    "                      tr_object_color.a * tr_view_alpha(tr_distance, tr_falloff.x, tr_falloff.y));\n"
    "#endif\n"
    "    gl_Position = tr_model_view_projection * vec4(tr_position, 1.0);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_surface_rules_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Fragment stage. What a surface fragment does in each pass of a sequence: Diepstraten 2002, section 6, as amended.\n"
    "//\n"
    "// A host's fragment shader calls tr_surface(color, object) once, last, in main. TR_RULE is defined by the preamble.\n"
    "// Depths of transparent things are written and compared as the shader sees them (gl_FragCoord.z, stored unrounded in\n"
    "// 32-bit float depth), so that equality means \"the same fragment\" and no epsilon is needed. Opaque things write no\n"
    "// depth here: they keep the early depth test.\n"
    "\n"
    "#define TR_RULE_FRONT 0         // nearest front face: depth only\n"
    "#define TR_RULE_OWNER 1         // whose it is: the lowest object id among those that tie\n"
    "#define TR_RULE_LIMIT 2         // where opaque things stop to show: one-sided transparent objects\n"
    "#define TR_RULE_LIMIT_SHEET 3   // the same for two-sided ones, whose both sides count as front\n"
    "#define TR_RULE_LIMIT_BEHIND 4  // whatever faces the pass culls not, behind the front-most one\n"
    "#define TR_RULE_OPAQUE 5        // opaque colour\n"
    "#define TR_RULE_BLENDED 6       // the one transparent fragment of a pixel\n"
    "#define TR_RULE_BLENDED_ALONE 7 // the same when no other transparent object can tie\n"
    "\n"
    "#if TR_WANTS_COLOR // defined by the preamble; where it is 0 color is not read and a host may skip its shading\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "#endif\n"
    "\n"
    "#if TR_RULE != TR_RULE_FRONT && TR_RULE != TR_RULE_OPAQUE\n"
    "uniform highp sampler2D tr_front_depth;\n"
    "#endif\n"
    "#if TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET || TR_RULE == TR_RULE_BLENDED\n"
    "uniform highp sampler2D tr_front_owner;\n"
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
    "    return float(object) * (1.0 / 16777216.0);\n"
    "}\n"
    "\n"
    "void tr_surface(highp vec4 color, highp uint object)\n"
    "{\n"
    "#if TR_RULE == TR_RULE_OPAQUE\n"
    "    tr_color = vec4(color.rgb, 1.0); // alpha marks \"an opaque thing is here\"\n"
    "#else\n"
    "    highp float depth = gl_FragCoord.z;\n"
    "#if TR_RULE != TR_RULE_FRONT\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    highp float front = texelFetch(tr_front_depth, pixel, 0).r;\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_OWNER\n"
    "    if (depth != front)\n"
    "        discard;\n"
    "    gl_FragDepth = tr_owner_code(object);\n"
    "#else\n"
    "\n"
    "#if TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET || TR_RULE == TR_RULE_BLENDED\n"
    "    bool owner = texelFetch(tr_front_owner, pixel, 0).r == tr_owner_code(object);\n"
    "#endif\n"
    "\n"
    "#if TR_RULE == TR_RULE_LIMIT\n"
    "    // A back face limits only what has a front face before it; a front face only if it is another object's.\n"
    "    if (gl_FrontFacing ? owner || TR_BEHIND(front, depth) : !TR_BEHIND(depth, front))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_LIMIT_SHEET\n"
    "    if (owner || TR_BEHIND(front, depth))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_LIMIT_BEHIND\n"
    "    if (!TR_BEHIND(depth, front))\n"
    "        discard;\n"
    "#elif TR_RULE == TR_RULE_BLENDED\n"
    "    if (depth != front || !owner)\n"
    "        discard;\n"
    "    tr_color = color;\n"
    "#elif TR_RULE == TR_RULE_BLENDED_ALONE\n"
    "    if (depth != front)\n"
    "        discard;\n"
    "    tr_color = color;\n"
    "#endif\n"
    "    gl_FragDepth = depth;\n"
    "#endif\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_surface_vertex_glsl[] = {
    "#line 1\n"
    "// For: transparency.h\n"
    "// Vertex stage. What every vertex shader of a sequence shares.\n"
    "//\n"
    "// Passes compare depths for equality: all programs that draw an object must compute the very same position.\n"
    "invariant gl_Position;\n",
    0};
static const shaders_i_entry shaders_i_table[] = {
    {"alpha_law.glsl", shaders_i_shader_alpha_law_glsl, 1},
    {"compose.frag", shaders_i_shader_compose_frag, 1},
    {"cool_to_warm.glsl", shaders_i_shader_cool_to_warm_glsl, 1},
    {"copy_depth.frag", shaders_i_shader_copy_depth_frag, 1},
    {"frame_block.glsl", shaders_i_shader_frame_block_glsl, 1},
    {"fullscreen.vert", shaders_i_shader_fullscreen_vert, 1},
    {"line.frag", shaders_i_shader_line_frag, 1},
    {"line.vert", shaders_i_shader_line_vert, 1},
    {"surface.frag", shaders_i_shader_surface_frag, 1},
    {"surface.vert", shaders_i_shader_surface_vert, 1},
    {"surface_rules.glsl", shaders_i_shader_surface_rules_glsl, 1},
    {"surface_vertex.glsl", shaders_i_shader_surface_vertex_glsl, 1},
    {0, 0, 0}};
/* clang-format on */
/* ==== end of generated shaders ==== */

#ifdef __cplusplus
extern "C" {
#endif

/* The table ends with an empty row. */
SHADERS_DEF int shaders_count(void) {
    return (int)(sizeof shaders_i_table / sizeof *shaders_i_table) - 1;
}

SHADERS_DEF const char *shaders_name(int index) {
    return index >= 0 && index < shaders_count() ? shaders_i_table[index].name : 0;
}

SHADERS_DEF const char *const *shaders_get(const char *name, int *chunk_count) {
    int first = 0, end = name ? shaders_count() : 0;
    while (first < end) {
        int middle = first + (end - first) / 2;
        int order = strcmp(name, shaders_i_table[middle].name);
        if (order == 0) {
            if (chunk_count)
                *chunk_count = shaders_i_table[middle].chunk_count;
            return shaders_i_table[middle].chunks;
        }
        if (order < 0)
            end = middle;
        else
            first = middle + 1;
    }
    if (chunk_count)
        *chunk_count = 0;
    return 0;
}

#ifdef __cplusplus
}
#endif

#endif /* SHADERS_EMBEDDED_IMPLEMENTATION_ONCE */
#endif /* SHADERS_EMBEDDED_IMPLEMENTATION */

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
