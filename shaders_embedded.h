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
static const char *const shaders_i_shader_chain_glsl[] = {
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
static const char *const shaders_i_shader_compose_frag[] = {
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
    "    highp ivec4 tr_step;    // x: the layer that this pass reads\n"
    "};\n"
    "\n"
    "// How far a window depth is from the eye, along the view direction.\n"
    "highp float tr_distance_of(highp float depth)\n"
    "{\n"
    "    return (tr_eye.x + tr_eye.y * depth) / (tr_eye.z + tr_eye.w * depth);\n"
    "}\n",
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
    "#if TR_HAS_FRONT\n"
    "uniform highp sampler2DArray tr_front_depth;\n"
    "#endif\n"
    "in highp vec4 tr_v_line;\n"
    "layout(location = 0) out highp vec4 tr_color;\n"
    "\n"
    "// The nearest of what is seen at a texel.\n"
    "highp float tr_depth_at(ivec2 texel)\n"
    "{\n"
    "    highp float depth = TR_CLEAR_DEPTH;\n"
    "#if TR_HAS_SCENE\n"
    "    texel = clamp(texel, ivec2(0), textureSize(tr_scene_depth, 0) - 1);\n"
    "    depth = texelFetch(tr_scene_depth, texel, 0).r;\n"
    "#endif\n"
    "#if TR_HAS_FRONT\n"
    "    texel = clamp(texel, ivec2(0), textureSize(tr_front_depth, 0).xy - 1);\n"
    "    highp float front = texelFetch(tr_front_depth, ivec3(texel, 0), 0).r;\n"
    "    depth = TR_BEHIND(depth, front) ? front : depth;\n"
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
    "            highp float depth = tr_depth_at(center + ivec2(x, y) * TR_SUPERSAMPLE);\n"
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
    "        highp float depth = tr_depth_at(pixel + ivec2(i % TR_TEXELS, i / TR_TEXELS));\n"
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
    "    // Lines are found without the host's jitter, and shifted by as much as its surfaces are.\n"
    "    tr_v_line = vec4(tr_line_center + tr_shift.xy, tr_line_corner.zw);\n"
    "    // Depth is written by the fragment stage, so the clip convention in force does not matter here.\n"
    "    gl_Position = vec4(2.0 * (tr_line_corner.xy + tr_shift.xy) / tr_viewport.zw - 1.0, 0.0, 1.0);\n"
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
    "#if !TR_IS_FIRST && TR_RULE != TR_RULE_OPAQUE\n"
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
    "#if TR_IS_LIMIT_MARKED\n"
    "// Whether a fragment ends what is seen through the last shown layer, by the method of the front-most object. Explicit\n",
    "#line 86\n"
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
    "void tr_surface(highp vec4 color, highp uint object)\n"
    "{\n"
    "#if TR_RULE == TR_RULE_OPAQUE\n"
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
    "#elif TR_RULE == TR_RULE_LIMIT_MARKED\n"
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
    {"chain.glsl", shaders_i_shader_chain_glsl, 1},
    {"compose.frag", shaders_i_shader_compose_frag, 2},
    {"cool_to_warm.glsl", shaders_i_shader_cool_to_warm_glsl, 1},
    {"copy_depth.frag", shaders_i_shader_copy_depth_frag, 1},
    {"frame_block.glsl", shaders_i_shader_frame_block_glsl, 1},
    {"fullscreen.vert", shaders_i_shader_fullscreen_vert, 1},
    {"line.frag", shaders_i_shader_line_frag, 1},
    {"line.vert", shaders_i_shader_line_vert, 1},
    {"surface.frag", shaders_i_shader_surface_frag, 1},
    {"surface.vert", shaders_i_shader_surface_vert, 1},
    {"surface_rules.glsl", shaders_i_shader_surface_rules_glsl, 2},
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
