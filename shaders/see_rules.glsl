// For: transparency.h
// Fragment stage. What a unit's fragment does in each pass of dynamic transparency: Assarsson 2006, section 3, as amended.
//
// A host's fragment shader calls tr_see_through(color, code) once, last in main, before it writes color to its output of
// location 0. code: what tr_unit_code makes. Bits 0 to 15: id, from 16 flags, from 24 importance in 255ths.
#define TR_RULE_SEE_PLAIN 15  // nothing
#define TR_RULE_SEE_BLOCK 16  // depth of what closes masks
#define TR_RULE_SEE_TARGET 17 // depth, and colour or mark, of the nearest target
#define TR_RULE_SEE_BEHIND 18 // what shows through masks
#define TR_RULE_SEE_YIELD 19  // importance of the front-most unit
#define TR_RULE_SEE_DITHER 20 // the whole scene, with holes
#define TR_RULE_SEE_HIDES 21  // what lies before a target

#if TR_RULE == TR_RULE_SEE_PLAIN
#define tr_see_through(color, code)
#else

#if TR_RULE >= TR_RULE_SEE_BEHIND && TR_RULE != TR_RULE_SEE_YIELD
uniform highp sampler2D tr_see_depth; // of the mask: what lies before it yields
#endif
#if TR_RULE == TR_RULE_SEE_BEHIND || TR_RULE == TR_RULE_SEE_DITHER
uniform highp sampler2D tr_see_mask; // opacity that it asks for, the target's strength
#endif

bool tr_see_is(highp uint code, highp uint flags)
{
    return ((code >> 16) & flags) != 0u;
}

// Targets, and what is never made transparent.
bool tr_see_keeps(highp uint code)
{
    return tr_see_is(code, 1u | 2u | 8u);
}

highp float tr_see_importance(highp uint code)
{
    return float(code >> 24) * (1.0 / 255.0);
}

#if TR_RULE == TR_RULE_SEE_DITHER
highp uint tr_see_hash(highp uint x)
{
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// Fragments stay whose opacity is above it. Together: one threshold a pixel, interleaved gradient noise moved on by the
// golden ratio from frame to frame, so that any few frames in a row average well. Each on its own: one a pixel and unit.
highp float tr_see_threshold(ivec2 pixel, highp uint code)
{
    highp uint frame = uint(tr_see_grid.z);
    if (tr_see_background.a > 0.5) {
        highp uint bits = tr_see_hash(uint(pixel.x) + tr_see_hash(uint(pixel.y) + tr_see_hash((code & 0xffffu) + tr_see_hash(frame))));
        return float(bits >> 8) * (1.0 / 16777216.0);
    }
    highp float noise = fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715))));
    // frame * (sqrt(5) - 1) / 2 modulo 1, in integers: it stays exact however long a game runs.
    return fract(noise + float((frame * 0x9e3779b9u) >> 8) * (1.0 / 16777216.0));
}
#endif

void tr_see_through(inout highp vec4 color, highp uint code)
{
#if TR_RULE == TR_RULE_SEE_BLOCK
    if (!tr_see_is(code, 2u | 8u))
        discard;
#elif TR_RULE == TR_RULE_SEE_TARGET
    if (!tr_see_is(code, 1u) || (code >> 24) == 0u)
        discard;
    if (tr_see_law.w >= 0.0)
        color.rgb = vec3(float(code & 255u) * (1.0 / 255.0), float((code >> 8) & 255u) * (1.0 / 255.0), tr_see_is(code, 16u) ? 1.0 : 0.0);
    color.a = tr_see_importance(code);
#elif TR_RULE == TR_RULE_SEE_BEHIND
    if (tr_see_keeps(code))
        return;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (!TR_BEHIND(texelFetch(tr_see_depth, pixel, 0).r, gl_FragCoord.z))
        return;
    if (code < 0x1000000u || texelFetch(tr_see_mask, pixel, 0).g > tr_see_importance(code))
        discard;
#elif TR_RULE == TR_RULE_SEE_YIELD
    color = vec4(tr_see_keeps(code) ? 1.0 : tr_see_importance(code));
#elif TR_RULE == TR_RULE_SEE_DITHER
    if (tr_see_keeps(code))
        return;
    ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy);
    highp vec2 mask = texelFetch(tr_see_mask, pixel, 0).rg;
    highp float yielding = clamp(mask.g - tr_see_importance(code), 0.0, 1.0), alpha = 1.0 - (1.0 - mask.r) * yielding;
    if (alpha < 1.0 && TR_BEHIND(texelFetch(tr_see_depth, pixel, 0).r, gl_FragCoord.z) &&
        tr_see_threshold(pixel, code) >= alpha)
        discard;
#elif TR_RULE == TR_RULE_SEE_HIDES
    // A texel's fragment stands at its middle: the pixel that it is compared with is there.
    ivec2 size = ivec2(tr_viewport.zw);
    ivec2 pixel = min(ivec2(gl_FragCoord.xy * tr_viewport.zw / vec2((size + 3) >> 2)), size - 1);
    if (tr_see_keeps(code) || !TR_BEHIND(texelFetch(tr_see_depth, pixel, 0).r, gl_FragCoord.z))
        discard;
    color = vec4(0.0, 0.0, 1.0, 0.0);
#endif
}
#endif
