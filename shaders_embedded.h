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
static const char *const shaders_i_shader_oit_clear_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Counts to zero; with the first slab of a frame the totals too.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) writeonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = first + 128u * i;\n"
    "        if (p < oit_pool.x)\n"
    "            oit_pixel[OIT_LEFT(p)] = 0u;\n"
    "    }\n"
    "    if (oit_step.x != 0u && first < OIT_HEADER)\n"
    "        oit_pixel[first] = 0u;\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_compose_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The pixels whose runs have more than OIT_ABOVE and at most OIT_CLASS records, composed over the target; with OIT_DEEP\n"
    "// all that are deeper than the programs that were drawn before, OIT_CLASS records at a time.\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "layout(location = 0, index = 0) out highp vec4 oit_out;\n"
    "layout(location = 0, index = 1) out highp vec4 oit_keep;\n"
    "#else\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "#endif\n"
    "\n"
    "// Lays the first m of oit_order, which holds `known`. With ties, all records of that depth, be they in this block or not,\n"
    "// are laid when the first of them is met.\n"
    "void oit_lay_sorted(uint base, uint n, uint m, uint known, bool tie, inout uint grouped)\n"
    "{\n"
    "    for (uint i = 0u; i < m && oit_visible(); ++i) {\n"
    "        uint at = oit_order[i];\n"
    "        bool alone = true;\n"
    "        uint depth = 0u;\n"
    "        if (tie) {\n"
    "            depth = oit_record_depth(at);\n"
    "            if (depth == grouped)\n"
    "                continue;\n"
    "            alone = i + 1u >= known || oit_record_depth(oit_order[i + 1u]) != depth;\n"
    "        }\n"
    "        if (alone) {\n"
    "            oit_lay(at);\n"
    "        } else {\n"
    "            oit_lay_group(base, n, depth);\n"
    "            grouped = depth;\n"
    "        }\n"
    "    }\n"
    "}\n"
    "\n"
    "void oit_lay_run(uint base, uint n)\n"
    "{\n"
    "    uint grouped = OIT_NONE;\n"
    "#if OIT_DEEP\n"
    "    uint depth = 0u, at = 0u;\n"
    "    for (uint done = 0u; done < n && oit_visible(); done += uint(OIT_CLASS)) {\n"
    "        // One more than are laid, to see whether it ties with the last of them.\n"
    "        oit_select(base, n, done > 0u, depth, at);\n"
    "        oit_lay_sorted(base, n, min(uint(OIT_CLASS), n - done), min(uint(OIT_CLASS + 1), n - done), true, grouped);\n"
    "    }\n"
    "#else\n"
    "    bool tie = oit_sort(base, n);\n"
    "    oit_lay_sorted(base, n, n, n, tie, grouped);\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);\n"
    "    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];\n"
    "#if OIT_ASYNC\n"
    "    if (end > oit_pool.z)\n"
    "        discard;\n"
    "#endif\n"
    "    // Fragments that were counted and did not come have left the first places empty.\n"
    "    start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));\n"
    "    uint n = end - start;\n"
    "#if OIT_DEEP\n"
    "    if (n <= oit_step.y)\n"
    "        discard;\n"
    "#else\n"
    "    if (n <= uint(OIT_ABOVE) || n > uint(OIT_CLASS))\n"
    "        discard;\n"
    "#endif\n"
    "    oit_lay_run((start - oit_pool.y) * uint(OIT_VECTORS), n);\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "    oit_out = vec4(oit_sum, 0.0);\n"
    "    oit_keep = vec4(oit_light.w * oit_through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_FILTER\n"
    "    oit_out = vec4(oit_light.w * oit_through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_LIGHT\n"
    "    oit_out = vec4(oit_sum, 0.0);\n"
    "#else\n"
    "    oit_out = vec4(oit_sum, oit_light.w * oit_through);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_compose_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Records laid one behind the other, front to back (Carnecky 2013, section 4.6): oit_sum is what has come of them so far,\n"
    "// oit_through how much is still seen of what is behind.\n"
    "#if OIT_HAS_BLEND\n"
    "#define OIT_THROUGH vec3\n"
    "#else\n"
    "#define OIT_THROUGH float\n"
    "#endif\n"
    "vec3 oit_sum = vec3(0.0);\n"
    "OIT_THROUGH oit_through = OIT_THROUGH(1.0);\n"
    "\n"
    "// Below 2^-24 of it nothing behind can change a float that is brighter than that.\n"
    "bool oit_visible()\n"
    "{\n"
    "#if OIT_HAS_BLEND\n"
    "    return max(oit_through.r, max(oit_through.g, oit_through.b)) > 5.9604645e-8;\n"
    "#else\n"
    "    return oit_through > 5.9604645e-8;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void oit_lay(uint at)\n"
    "{\n"
    "    uvec4 words = oit_record_words(at);\n"
    "    vec4 color = oit_unpack_color(words);\n"
    "#if OIT_PREMULTIPLIED\n"
    "    vec3 light = color.rgb;\n"
    "#else\n"
    "    vec3 light = color.a * color.rgb;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "#if OIT_COLOR == OIT_COLOR_8\n"
    "    uint blend = words.x >> 30u;\n"
    "#else\n"
    "    uint blend = OIT_WORD(at, OIT_AT_BLEND);\n"
    "#endif\n"
    "    if (blend == 2u) { // multiply: seen through a filter of that colour\n"
    "        oit_through *= 1.0 - color.a + light;\n"
    "        return;\n"
    "    }\n"
    "    oit_sum += oit_through * light;\n"
    "    if (blend == 1u) // add: light, which hides nothing\n"
    "        return;\n"
    "#else\n"
    "    oit_sum += oit_through * light;\n"
    "#endif\n"
    "    oit_through *= 1.0 - color.a;\n"
    "}\n"
    "\n"
    "// All records of one depth, in their order, each found anew: ties are rare.\n"
    "void oit_lay_group(uint base, uint count, uint depth)\n"
    "{\n"
    "    uint last = OIT_NONE;\n"
    "    for (;;) {\n"
    "        uint best = OIT_NONE;\n"
    "        for (uint i = 0u; i < count; ++i) {\n"
    "            uint at = base + i * uint(OIT_VECTORS);\n"
    "            if (oit_record_depth(at) != depth || (last != OIT_NONE && !oit_after(at, last)))\n"
    "                continue;\n"
    "            if (best == OIT_NONE || oit_after(best, at))\n"
    "                best = at;\n"
    "        }\n"
    "        if (best == OIT_NONE)\n"
    "            return;\n"
    "        oit_lay(best);\n"
    "        last = best;\n"
    "    }\n"
    "}\n"
    "\n"
    "// What oit_i_add_network writes is made of these: registers d (depth) and o (where the record lies).\n"
    "#define L(d, o, i) uint d = OIT_NONE, o = base; if (i < n) { o = base + i * uint(OIT_VECTORS); d = oit_record_depth(o); }\n"
    "#define S(d, o, e, p) { bool g = e < d; uint t = g ? p : o; p = g ? o : p; o = t; t = min(d, e); e = max(d, e); d = t; }\n"
    "#define T(d, e, i) tie = tie || (d == e && i < n);\n"
    "#define D(d, o) uint d = OIT_NONE, o = base;\n"
    "#define I(d, o) { s = s || x < d; uint t = d; d = s ? x : d; x = s ? t : x; t = o; o = s ? y : o; y = s ? t : y; }\n"
    "uint oit_order[OIT_CLASS + OIT_DEEP];\n",
    0};
static const char *const shaders_i_shader_oit_frame_block_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What is the same for all of a pass (std140, written by oit_i_upload_block), and where things lie in the pixel buffer.\n"
    "layout(std140, binding = OIT_UNIFORM_BINDING) uniform oit_frame\n"
    "{\n"
    "    highp ivec4 oit_area;  // x, y of the slab's corner in the target, its width and height\n"
    "    highp uvec4 oit_pool;  // x: pixels of the slab, y: first fragment of the band, z: capacity, w: blocks of the scan\n"
    "    highp uvec4 oit_step;  // x: 1 with the first slab of a frame, y: what is deeper is left to the program for all depths\n"
    "    highp vec4 oit_light;  // xyz: toward the light, unit length; zero: no shading. w: weight of the background\n"
    "};\n"
    "\n"
    "// The pixel buffer: 16 words of totals, then two words a pixel (where its run starts; how many fragments are still to\n"
    "// come), one more start, a word for each block of the scan, and four words a pixel for the tail.\n"
    "#define OIT_NEEDED 0u      // fragments of the slab that needs most\n"
    "#define OIT_DEEPEST 1u     // fragments of the deepest pixel\n"
    "#define OIT_LOST_PIXELS 2u // pixels that are composed from the tail\n"
    "#define OIT_LOST 3u        // fragments that went to the tail\n"
    "#define OIT_EXTRA 4u       // fragments that the fill met and the count had not\n"
    "#define OIT_TOTAL 5u       // fragments of this slab\n"
    "#define OIT_HEADER 16u\n"
    "#define OIT_START(p) (OIT_HEADER + 2u * (p))\n"
    "#define OIT_LEFT(p) (OIT_HEADER + 1u + 2u * (p))\n"
    "#define OIT_SUM(b) (OIT_HEADER + 2u + 2u * oit_pool.x + (b))\n"
    "#define OIT_TAIL(p) (OIT_HEADER + 2u + 2u * oit_pool.x + oit_pool.w + 4u * (p))\n"
    "\n"
    "// With what is to come of a pixel whose run does not fit. A pixel has less than 2^30 fragments.\n"
    "#define OIT_UNFIT 0x40000000u\n"
    "\n"
    "// A block of the scan: 128 invocations of 8 pixels each.\n"
    "#define OIT_BLOCK 1024u\n",
    0};
static const char *const shaders_i_shader_oit_fullscreen_vert[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// One triangle that covers the viewport; no vertex buffer.\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));\n"
    "    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_record_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Records read back: the order of two, colour, how it is laid over what is behind.\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "layout(std430, binding = OIT_BINDING_FRAGMENTS) readonly buffer oit_fragments { OIT_VECTOR oit_data[]; };\n"
    "\n"
    "#define OIT_NONE 0xffffffffu\n"
    "\n"
    "// Whether the record at a comes after that at b; by their words, then by where they lie, which only tells apart records\n"
    "// that are alike in every word.\n"
    "bool oit_after(uint a, uint b)\n"
    "{\n"
    "    for (uint i = 0u; i < uint(OIT_VECTORS); ++i) {\n"
    "        OIT_VECTOR x = oit_data[a + i], y = oit_data[b + i];\n"
    "        for (int k = 0; k < OIT_LANES; ++k)\n"
    "            if (x[k] != y[k])\n"
    "                return x[k] > y[k];\n"
    "    }\n"
    "    return a > b;\n"
    "}\n"
    "\n"
    "// Word i of the record at `at`; i is a constant.\n"
    "#define OIT_WORD(at, i) oit_data[(at) + uint((i) / OIT_LANES)][(i) % OIT_LANES]\n"
    "\n"
    "uint oit_record_depth(uint at)\n"
    "{\n"
    "    return oit_data[at].x;\n"
    "}\n"
    "\n"
    "vec4 oit_unpack_color(uvec4 w)\n"
    "{\n"
    "#if OIT_COLOR == OIT_COLOR_8\n"
    "    return vec4(vec3(uvec3(w.x, w.x >> 10u, w.x >> 20u) & 1023u) * (1.0 / 1023.0), uintBitsToFloat(w.y));\n"
    "#elif OIT_COLOR == OIT_COLOR_HALF\n"
    "    return vec4(unpackHalf2x16(w.x), unpackHalf2x16(w.y));\n"
    "#else\n"
    "    return uintBitsToFloat(w);\n"
    "#endif\n"
    "}\n"
    "\n"
    "// The words of the colour; of one vector where they lie in one, which some drivers load much faster.\n"
    "uvec4 oit_record_words(uint at)\n"
    "{\n"
    "#if OIT_COLOR != OIT_COLOR_FLOAT && OIT_LANES == 4 && OIT_AT_COLOR < 3\n"
    "    uvec4 w = oit_data[at];\n"
    "    return uvec4(w[OIT_AT_COLOR], w[OIT_AT_COLOR + 1], 0u, 0u);\n"
    "#elif OIT_COLOR != OIT_COLOR_FLOAT\n"
    "    return uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), 0u, 0u);\n"
    "#else\n"
    "    return uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), OIT_WORD(at, OIT_AT_COLOR + 2),\n"
    "                 OIT_WORD(at, OIT_AT_COLOR + 3));\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_report_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The totals into a buffer of their own, which the CPU reads when its fence has passed.\n"
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "layout(std430, binding = OIT_BINDING_REPORT) writeonly buffer oit_report { uint oit_total[]; };\n"
    "\n"
    "void main()\n"
    "{\n"
    "    for (uint i = 0u; i < 8u; ++i)\n"
    "        oit_total[i] = oit_pixel[i];\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_scan_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Sums that stay at the largest number instead of starting again from zero, and their prefix sum over a work group.\n"
    "uint oit_add(uint a, uint b)\n"
    "{\n"
    "    uint sum = a + b;\n"
    "    return sum < a ? 0xffffffffu : sum;\n"
    "}\n"
    "#ifdef OIT_SCANS\n"
    "shared uint oit_scanned[128];\n"
    "\n"
    "// What lies before this invocation. All 128 must call it.\n"
    "uint oit_scan(uint self, uint value)\n"
    "{\n"
    "    oit_scanned[self] = value;\n"
    "    barrier();\n"
    "    for (uint reach = 1u; reach < 128u; reach <<= 1u) {\n"
    "        uint other = self >= reach ? oit_scanned[self - reach] : 0u;\n"
    "        barrier();\n"
    "        oit_scanned[self] = oit_add(oit_scanned[self], other);\n"
    "        barrier();\n"
    "    }\n"
    "    return self > 0u ? oit_scanned[self - 1u] : 0u;\n"
    "}\n"
    "#endif\n",
    0};
static const char *const shaders_i_shader_oit_spread_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The scan, third of three: where the run of each pixel starts. A run that ends beyond the pool does not fit; since starts\n"
    "// ascend, that follows from its end alone and needs no mark.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "void oit_lose(uint p, uint count)\n"
    "{\n"
    "    atomicAdd(oit_pixel[OIT_LOST_PIXELS], 1u);\n"
    "    atomicAdd(oit_pixel[OIT_LOST], count);\n"
    "    oit_pixel[OIT_LEFT(p)] = count | OIT_UNFIT;\n"
    "    for (uint c = 0u; c < 4u; ++c)\n"
    "        oit_pixel[OIT_TAIL(p) + c] = 0u;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + 8u * gl_LocalInvocationID.x;\n"
    "    uint sum = 0u;\n"
    "    for (uint p = first; p < first + 8u; ++p)\n"
    "        sum = oit_add(sum, p < oit_pool.x ? oit_pixel[OIT_LEFT(p)] : 0u);\n"
    "    uint before = oit_scan(gl_LocalInvocationID.x, sum);\n"
    "    before = oit_add(before, block < oit_pool.w ? oit_pixel[OIT_SUM(block)] : 0u);\n"
    "    for (uint p = first; p < first + 8u && p < oit_pool.x; ++p) {\n"
    "        uint count = oit_pixel[OIT_LEFT(p)];\n"
    "        oit_pixel[OIT_START(p)] = before;\n"
    "        before = oit_add(before, count);\n"
    "#if OIT_ASYNC\n"
    "        if (before > oit_pool.z && count > 0u)\n"
    "            oit_lose(p, count);\n"
    "#endif\n"
    "    }\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_store_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What a fragment shader calls: oit_store(fragment), or oit_store(color). Counts in the count pass; in the fill pass writes\n"
    "// one record of OIT_VECTORS vectors into the pixel's run. Records are written so that their words, compared one after the\n"
    "// other, give the order in which they are composed: depth, part, key, and all else for fragments that tie.\n"
    "layout(early_fragment_tests) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "#if OIT_PASS == OIT_FILL\n"
    "layout(std430, binding = OIT_BINDING_FRAGMENTS) writeonly buffer oit_fragments { OIT_VECTOR oit_data[]; };\n"
    "#endif\n"
    "\n"
    "#define OIT_BLEND_OVER 0u\n"
    "#define OIT_BLEND_ADD 1u\n"
    "#define OIT_BLEND_MULTIPLY 2u\n"
    "\n"
    "struct oit_fragment\n"
    "{\n"
    "    vec4 color; // rgb and alpha\n"
    "#if OIT_HAS_PART\n"
    "    uint part;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    uint key;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    uint blend;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    vec3 normal;\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    vec2 uv;\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    uint words[OIT_HOST_WORDS];\n"
    "#endif\n"
    "};\n"
    "\n"
    "// NaN and infinities by their bits: compilers may take comparisons with them away.\n"
    "float oit_finite(float x)\n"
    "{\n"
    "    return (floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u ? 0.0 : x;\n"
    "}\n"
    "\n"
    "vec4 oit_finite(vec4 color)\n"
    "{\n"
    "    vec3 c = vec3(oit_finite(color.r), oit_finite(color.g), oit_finite(color.b));\n"
    "    return vec4(c, clamp(oit_finite(color.a), 0.0, 1.0));\n"
    "}\n"
    "\n"
    "// Ascends from the eye on, in either convention. A depth of -0.0 is 0.0.\n"
    "uint oit_depth_bits()\n"
    "{\n"
    "    uint bits = floatBitsToUint(gl_FragCoord.z);\n"
    "    bits = bits > 0x7fffffffu ? 0u : bits;\n"
    "#if OIT_REVERSED_Z\n"
    "    bits = 0x7fffffffu - bits;\n"
    "#endif\n"
    "    return bits;\n"
    "}\n"
    "\n"
    "uint oit_pixel_index()\n"
    "{\n"
    "    ivec2 at = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    return uint(at.y) * uint(oit_area.z) + uint(at.x);\n"
    "}\n"
    "\n"
    "#if OIT_PASS == OIT_FILL\n"
    "#if OIT_HAS_NORMAL\n"
    "// The octahedron unfolded: both coordinates of a direction in 16 bits each. A normal of no length is that toward the eye.\n"
    "uint oit_pack_normal(vec3 n)\n"
    "{\n"
    "    n = vec3(oit_finite(n.x), oit_finite(n.y), oit_finite(n.z));\n"
    "    float size = abs(n.x) + abs(n.y) + abs(n.z);\n"
    "    n = size > 0.0 && size < 1.0e38 ? n / size : vec3(0.0, 0.0, 1.0);\n"
    "    vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);\n"
    "    return packSnorm2x16(n.z < 0.0 ? folded : n.xy);\n"
    "}\n"
    "#endif\n"
    "\n"
    "void oit_write(uint at, oit_fragment f)\n"
    "{\n"
    "    vec4 color = oit_finite(f.color);\n"
    "    uint w[OIT_VECTORS * OIT_LANES];\n"
    "    for (int i = 0; i < OIT_VECTORS * OIT_LANES; ++i)\n"
    "        w[i] = 0u;\n"
    "    w[0] = oit_depth_bits();\n"
    "#if OIT_HAS_PART\n"
    "    w[OIT_AT_PART] = f.part;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    w[OIT_AT_KEY] = f.key;\n"
    "#endif\n"
    "#if OIT_COLOR == OIT_COLOR_8\n"
    "    uvec3 c = uvec3(clamp(color.rgb, 0.0, 1.0) * 1023.0 + 0.5);\n"
    "    w[OIT_AT_COLOR] = c.r | c.g << 10u | c.b << 20u;\n"
    "#if OIT_HAS_BLEND\n"
    "    w[OIT_AT_COLOR] |= f.blend << 30u;\n"
    "#endif\n"
    "    w[OIT_AT_COLOR + 1] = floatBitsToUint(color.a);\n"
    "#elif OIT_COLOR == OIT_COLOR_HALF\n"
    "    vec3 c = clamp(color.rgb, -65504.0, 65504.0);\n"
    "    w[OIT_AT_COLOR] = packHalf2x16(c.rg);\n"
    "    w[OIT_AT_COLOR + 1] = packHalf2x16(vec2(c.b, color.a));\n"
    "#else\n"
    "    for (int i = 0; i < 4; ++i)\n"
    "        w[OIT_AT_COLOR + i] = floatBitsToUint(color[i]);\n"
    "#endif\n"
    "#if OIT_HAS_BLEND && OIT_COLOR != OIT_COLOR_8\n"
    "    w[OIT_AT_BLEND] = f.blend;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    w[OIT_AT_NORMAL] = oit_pack_normal(f.normal);\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    w[OIT_AT_UV] = floatBitsToUint(f.uv.x);\n"
    "    w[OIT_AT_UV + 1] = floatBitsToUint(f.uv.y);\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    for (int i = 0; i < OIT_HOST_WORDS; ++i)\n"
    "        w[OIT_AT_HOST + i] = f.words[i];\n"
    "#endif\n"
    "    for (int i = 0; i < OIT_VECTORS; ++i)\n"
    "#if OIT_LANES == 4\n"
    "        oit_data[at + uint(i)] = uvec4(w[4 * i], w[4 * i + 1], w[4 * i + 2], w[4 * i + 3]);\n"
    "#else\n"
    "        oit_data[at + uint(i)] = uvec2(w[2 * i], w[2 * i + 1]);\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if OIT_ASYNC\n"
    "// The tail: sums that do not depend on the order, in integers so that rounding does not either. The layers of a pixel are\n",
    "#line 132\n"
    "// taken as mixed evenly: optical depths add, colours are weighted by them. Bits are shared out by the count of the\n"
    "// pixel, so that no sum overflows: colours up to 4 and optical depths up to 11 make less than 64 a fragment.\n"
    "void oit_to_tail(uint p, uint count, oit_fragment f)\n"
    "{\n"
    "    vec4 color = oit_finite(f.color);\n"
    "    float scale = exp2(float(26 - findMSB(count) - 1));\n"
    "    float thickness = min(-log(1.0 - min(color.a, 0.999999)), 11.0);\n"
    "    vec3 c = clamp(color.rgb, 0.0, 4.0);\n"
    "#if OIT_PREMULTIPLIED\n"
    "    c = color.a > 0.0 ? min(c / color.a, vec3(4.0)) : c;\n"
    "    float weight = color.a > 0.0 ? thickness : 1.0;\n"
    "#else\n"
    "    float weight = thickness;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    if (f.blend == OIT_BLEND_ADD) {\n"
    "        weight = OIT_PREMULTIPLIED == 1 ? max(color.a, 1.0e-6) : color.a;\n"
    "        thickness = 0.0;\n"
    "    } else if (f.blend == OIT_BLEND_MULTIPLY) {\n"
    "        float keep = 1.0 - color.a + color.a * min((c.r + c.g + c.b) / 3.0, 1.0);\n"
    "        thickness = min(-log(max(keep, 1.0e-6)), 11.0);\n"
    "        weight = 0.0;\n"
    "    }\n"
    "#endif\n"
    "    uvec4 parts = uvec4(vec4(c * weight, thickness) * scale + 0.5);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p)], parts.r);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p) + 1u], parts.g);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p) + 2u], parts.b);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p) + 3u], parts.a);\n"
    "}\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "void oit_store(oit_fragment f)\n"
    "{\n"
    "    uint p = oit_pixel_index();\n"
    "#if OIT_PASS == OIT_COUNT\n"
    "    atomicAdd(oit_pixel[OIT_LEFT(p)], 1u);\n"
    "#else\n"
    "    uint left = atomicAdd(oit_pixel[OIT_LEFT(p)], 0xffffffffu);\n"
    "#if OIT_ASYNC\n"
    "    if (left >> 30u == 1u) { // OIT_UNFIT, and not what wraps below 0\n"
    "        uint count = oit_pixel[OIT_START(p + 1u)] - oit_pixel[OIT_START(p)];\n"
    "        if (left != OIT_UNFIT)\n"
    "            oit_to_tail(p, count, f);\n"
    "        else\n"
    "            atomicAdd(oit_pixel[OIT_EXTRA], 1u);\n"
    "        return;\n"
    "    }\n"
    "#endif\n"
    "    // Nothing is written outside of the run, however many fragments come: after as many as were counted, what is left is\n"
    "    // 0, and then wraps to more than any pool holds.\n"
    "    uint slot = oit_pixel[OIT_START(p)] + left - 1u - oit_pool.y;\n"
    "    if (left - 1u >= oit_pool.z || slot >= oit_pool.z) {\n"
    "        atomicAdd(oit_pixel[OIT_EXTRA], 1u);\n"
    "        return;\n"
    "    }\n"
    "    oit_write(slot * uint(OIT_VECTORS), f);\n"
    "#endif\n"
    "}\n"
    "\n"
    "void oit_store(vec4 color)\n"
    "{\n"
    "    oit_fragment f;\n"
    "    f.color = color;\n"
    "#if OIT_HAS_PART\n"
    "    f.part = 0u;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    f.key = 0u;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    f.blend = OIT_BLEND_OVER;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    f.normal = vec3(0.0, 0.0, 1.0);\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    f.uv = vec2(0.0);\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    for (int i = 0; i < OIT_HOST_WORDS; ++i)\n"
    "        f.words[i] = 0u;\n"
    "#endif\n"
    "    oit_store(f);\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_sum_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The scan, first of three: the fragments of each block, and of the deepest pixel.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "shared uint oit_sums[128];\n"
    "shared uint oit_most[128];\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint self = gl_LocalInvocationID.x;\n"
    "    uint sum = 0u, most = 0u;\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = block * OIT_BLOCK + 128u * i + self;\n"
    "        uint count = p < oit_pool.x ? oit_pixel[OIT_LEFT(p)] : 0u;\n"
    "        sum = oit_add(sum, count);\n"
    "        most = max(most, count);\n"
    "    }\n"
    "    oit_sums[self] = sum;\n"
    "    oit_most[self] = most;\n"
    "    barrier();\n"
    "    for (uint half_size = 64u; half_size > 0u; half_size >>= 1u) {\n"
    "        if (self < half_size) {\n"
    "            oit_sums[self] = oit_add(oit_sums[self], oit_sums[self + half_size]);\n"
    "            oit_most[self] = max(oit_most[self], oit_most[self + half_size]);\n"
    "        }\n"
    "        barrier();\n"
    "    }\n"
    "    if (self == 0u && block < oit_pool.w) {\n"
    "        oit_pixel[OIT_SUM(block)] = oit_sums[0];\n"
    "        atomicMax(oit_pixel[OIT_DEEPEST], oit_most[0]);\n"
    "    }\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_surface_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Built-in surfaces: the object's colour, lit from both sides where the frame has a light.\n"
    "#if OIT_PASS == OIT_FILL\n"
    "in vec3 oit_v_color;\n"
    "uniform vec4 oit_object_color;\n"
    "#endif\n"
    "#if OIT_WANTS_NORMAL\n"
    "in vec3 oit_v_normal;\n"
    "#endif\n"
    "#if OIT_PASS == OIT_FILL && (OIT_HAS_PART || OIT_HAS_KEY || OIT_HAS_BLEND)\n"
    "uniform uvec4 oit_object; // part, key, blend\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if OIT_PASS == OIT_COUNT\n"
    "    oit_store(vec4(0.0));\n"
    "#else\n"
    "    vec4 color = oit_object_color;\n"
    "    color.rgb += oit_v_color;\n"
    "#if OIT_WANTS_NORMAL\n"
    "    float size = dot(oit_v_normal, oit_v_normal);\n"
    "    vec3 normal = size > 1.0e-30 ? oit_v_normal * inversesqrt(size) : vec3(0.0, 0.0, 1.0);\n"
    "#endif\n"
    "#if OIT_LIT\n"
    "    color.rgb *= 0.35 + 0.65 * abs(dot(normal, oit_light.xyz));\n"
    "#endif\n"
    "#if OIT_PREMULTIPLIED\n"
    "    color.rgb *= color.a;\n"
    "#endif\n"
    "    oit_fragment f;\n"
    "    f.color = color;\n"
    "#if OIT_HAS_PART\n"
    "    f.part = oit_object.x;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    f.key = oit_object.y;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    f.blend = oit_object.z;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    f.normal = normal;\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    f.uv = vec2(0.0);\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    for (int i = 0; i < OIT_HOST_WORDS; ++i)\n"
    "        f.words[i] = 0u;\n"
    "#endif\n"
    "    oit_store(f);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_surface_vert[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Built-in surfaces, for hosts without shaders: position, normal, colour to be added. The count pass needs no more than\n"
    "// the position.\n"
    "layout(location = 0) in vec3 oit_position;\n"
    "uniform mat4 oit_model_view_projection;\n"
    "#if OIT_PASS == OIT_FILL\n"
    "layout(location = 3) in vec3 oit_vertex_color;\n"
    "out vec3 oit_v_color;\n"
    "#endif\n"
    "#if OIT_WANTS_NORMAL\n"
    "layout(location = 1) in vec3 oit_normal;\n"
    "uniform mat3 oit_normal_matrix;\n"
    "out vec3 oit_v_normal;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    gl_Position = oit_model_view_projection * vec4(oit_position, 1.0);\n"
    "#if OIT_PASS == OIT_FILL\n"
    "    oit_v_color = oit_vertex_color;\n"
    "#endif\n"
    "#if OIT_WANTS_NORMAL\n"
    "    oit_v_normal = oit_normal_matrix * oit_normal;\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_tail_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The pixels whose runs did not fit, from the sums of oit_to_tail: layers of mean colour, as thick as all together.\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "layout(location = 0, index = 0) out highp vec4 oit_out;\n"
    "layout(location = 0, index = 1) out highp vec4 oit_keep;\n"
    "#else\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);\n"
    "    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];\n"
    "    if (end <= oit_pool.z || end == start)\n"
    "        discard;\n"
    "    float unit = exp2(float(findMSB(end - start) - 25));\n"
    "    uint at = OIT_TAIL(p);\n"
    "    vec3 light = vec3(uvec3(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u])) * unit;\n"
    "    float thickness = float(oit_pixel[at + 3u]) * unit;\n"
    "    float through = exp(-thickness);\n"
    "    // (1 - e^-t) / t, whose quotient loses its digits near 0.\n"
    "    vec3 sum = light * (thickness > 1.0e-3 ? (1.0 - through) / thickness : 1.0 - 0.5 * thickness);\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "    oit_out = vec4(sum, 0.0);\n"
    "    oit_keep = vec4(vec3(oit_light.w * through), 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_FILTER\n"
    "    oit_out = vec4(vec3(oit_light.w * through), 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_LIGHT\n"
    "    oit_out = vec4(sum, 0.0);\n"
    "#else\n"
    "    oit_out = vec4(sum, oit_light.w * through);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const shaders_i_shader_oit_tops_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The scan, second of three: sums of blocks become what lies before each block. One work group, whatever the size.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint self = gl_LocalInvocationID.x;\n"
    "    uint each = (oit_pool.w + 127u) / 128u;\n"
    "    uint first = min(self * each, oit_pool.w), end = min(first + each, oit_pool.w);\n"
    "    uint sum = 0u;\n"
    "    for (uint b = first; b < end; ++b)\n"
    "        sum = oit_add(sum, oit_pixel[OIT_SUM(b)]);\n"
    "    uint before = oit_scan(self, sum);\n"
    "    for (uint b = first; b < end; ++b) {\n"
    "        uint here = oit_pixel[OIT_SUM(b)];\n"
    "        oit_pixel[OIT_SUM(b)] = before;\n"
    "        before = oit_add(before, here);\n"
    "    }\n"
    "    if (self == 127u) {\n"
    "        oit_pixel[OIT_START(oit_pool.x)] = before;\n"
    "        oit_pixel[OIT_TOTAL] = before;\n"
    "        oit_pixel[OIT_NEEDED] = max(oit_pixel[OIT_NEEDED], before);\n"
    "    }\n"
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
    {"oit_clear.comp", shaders_i_shader_oit_clear_comp, 1},
    {"oit_compose.frag", shaders_i_shader_oit_compose_frag, 1},
    {"oit_compose.glsl", shaders_i_shader_oit_compose_glsl, 1},
    {"oit_frame_block.glsl", shaders_i_shader_oit_frame_block_glsl, 1},
    {"oit_fullscreen.vert", shaders_i_shader_oit_fullscreen_vert, 1},
    {"oit_record.glsl", shaders_i_shader_oit_record_glsl, 1},
    {"oit_report.comp", shaders_i_shader_oit_report_comp, 1},
    {"oit_scan.glsl", shaders_i_shader_oit_scan_glsl, 1},
    {"oit_spread.comp", shaders_i_shader_oit_spread_comp, 1},
    {"oit_store.glsl", shaders_i_shader_oit_store_glsl, 2},
    {"oit_sum.comp", shaders_i_shader_oit_sum_comp, 1},
    {"oit_surface.frag", shaders_i_shader_oit_surface_frag, 1},
    {"oit_surface.vert", shaders_i_shader_oit_surface_vert, 1},
    {"oit_tail.frag", shaders_i_shader_oit_tail_frag, 1},
    {"oit_tops.comp", shaders_i_shader_oit_tops_comp, 1},
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
