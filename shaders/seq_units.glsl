// For: transparency.h
// Fragment stage. What a unit's fragment does in the passes of TR_SEE_SEQUENCE, TR_SEE_PUBLISHED and TR_SEE_EXACT.
//
// A host's fragment shader calls tr_see_through(color, code) once, last in main, before it writes color to its output of
// location 0. code: what tr_unit_code makes; see seq_codes.glsl. TR_RULE_SEE_PEEL writes the code to location 1: shaders for
// it have an output at location 0 and no other.
#define TR_RULE_SEE_BLOCK 16 // of the cheaper rungs
#define TR_RULE_SEE_DEPTH 22 // front-most surfaces: depth alone
#define TR_RULE_SEE_SEED 23  // where a target is, open
#define TR_RULE_SEE_BLEND 24 // colour, with the opacity that masks leave
#define TR_RULE_SEE_BLEND_LAYERS 25 // the same under layer control
#define TR_RULE_SEE_COUNT 26 // occluders a pixel
#define TR_RULE_SEE_PEEL 27  // the next layer of those within masks

// What an occluder keeps of its opacity whatever masks say. A target counts one less than it does as a target.
highp float tr_code_keeps(highp uint code)
{
    if ((code & TR_CODE_CLOSES) != 0u)
        return 1.0;
    return (code & TR_CODE_TARGET) != 0u ? 0.0 : float(code >> 24) * (1.0 / 255.0);
}

#if TR_RULE == TR_RULE_SEE_SEED
uniform highp sampler2D tr_block_depth; // of what closes masks
#endif
#if TR_RULE == TR_RULE_SEE_BLEND || TR_RULE == TR_RULE_SEE_BLEND_LAYERS
uniform highp sampler2D tr_mask_alphas; // of seq_mask.frag
#endif
#if TR_RULE == TR_RULE_SEE_BLEND_LAYERS
uniform highp sampler2D tr_remaining; // occluders still to be painted, in 255ths
#endif
#if TR_RULE == TR_RULE_SEE_BLEND || TR_RULE == TR_RULE_SEE_BLEND_LAYERS
highp float tr_opacity_of(highp uint code)
{
    highp float keeps = tr_code_keeps(code);
    ivec2 pixel = ivec2(gl_FragCoord.xy) - (tr_seq_step.w != 0 ? ivec2(0) : tr_seq_view.xy);
    if (keeps >= 1.0)
        return 1.0;
    highp vec2 alphas = texelFetch(tr_mask_alphas, pixel, 0).rg;
#if TR_RULE == TR_RULE_SEE_BLEND_LAYERS
    // As many as are still to come lie nearer to the eye; of solids this one is among them. All of a hollow one's count as
    // one.
    highp vec2 nearer = texelFetch(tr_remaining, pixel, 0).rg * 255.0 + ((code & TR_CODE_HOLLOW) != 0u ? 0.5 : -0.5);
    alphas = mix(alphas, vec2(1.0), greaterThan(nearer, vec2(float(tr_seq_numbers.z))));
#endif
    if ((code & TR_CODE_TARGET) != 0u && tr_seq_step.z == 0)
        alphas.r = 1.0;
    return mix(tr_seq_step.y != 0 ? alphas.r * alphas.g : min(alphas.r, alphas.g), 1.0, keeps);
}
#endif

#if TR_RULE == TR_RULE_SEE_PEEL
layout(location = 1) out highp uint tr_layer_code;
uniform highp sampler2D tr_reach;             // the farthest that masks look through; TR_NO_REACH: no mask
uniform highp sampler2DArray tr_layer_before; // depth, of this layer's parity less one
uniform highp usampler2DArray tr_chain;       // codes of the layers before

// Whether a surface may be the next layer: behind or at the last one, of a unit that has none yet. Those of hollow units
// are told apart by their depths.
bool tr_may_be_next(highp uint code, ivec2 pixel, int layer)
{
    highp uint last = texelFetch(tr_chain, ivec3(pixel, layer - 1), 0).r;
    highp float before = texelFetch(tr_layer_before, ivec3(pixel, (layer - 1) >> 1), 0).r;
    bool hollow = (code & TR_CODE_HOLLOW) != 0u, same_depth = gl_FragCoord.z == before;
    if ((last & TR_LAYER_LAST) != 0u || TR_NEARER(gl_FragCoord.z, before))
        return false;
    for (int i = layer - 1; i >= 0 && (!hollow || same_depth); --i) {
        highp uint other = texelFetch(tr_chain, ivec3(pixel, i), 0).r;
        if (((other ^ code) & 0xffffu) == 0u)
            return false;
        same_depth = same_depth && (other & TR_LAYER_COINCIDENT) != 0u;
    }
    return true;
}

bool tr_peels(highp uint code)
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    highp float reach = texelFetch(tr_reach, pixel, 0).r;
    int layer = tr_seq_step.x;
    if (reach == TR_NO_REACH || ((code & TR_CODE_HOLLOW) != 0u && !gl_FrontFacing))
        return false;
    // The last place is kept for what ends the pixel, so that layers that are too many lose no target.
    if (tr_seq_more.y != 0 && layer == tr_seq_more.x - 1 && TR_NEARER(gl_FragCoord.z, reach) &&
        (code & TR_CODE_CLOSES) == 0u)
        return false;
    return layer == 0 || tr_may_be_next(code, pixel, layer);
}
#endif

void tr_see_through(inout highp vec4 color, highp uint code)
{
#if TR_RULE == TR_RULE_SEE_SEED
    if (tr_seq_more.z != 0 && TR_NEARER(texelFetch(tr_block_depth, ivec2(gl_FragCoord.xy), 0).r, gl_FragCoord.z))
        discard;
    gl_FragDepth = gl_FragCoord.z;
#elif TR_RULE == TR_RULE_SEE_PEEL
    // Depths are written as they are compared, so that equality means the same surface.
    if (!tr_peels(code))
        discard;
    tr_layer_code = code & 0xff1fffffu;
    gl_FragDepth = gl_FragCoord.z;
#elif TR_RULE == TR_RULE_SEE_BLEND || TR_RULE == TR_RULE_SEE_BLEND_LAYERS
    color.a = tr_opacity_of(code);
#elif TR_RULE == TR_RULE_SEE_COUNT
    // Red: what a mask acts on beside its target, green: what it acts on where the target is.
    if (tr_code_keeps(code) >= 1.0)
        discard;
    bool beside = (code & TR_CODE_TARGET) == 0u || tr_seq_step.z != 0;
    color = vec4(beside ? 1.0 : 0.0, 1.0, 0.0, 0.0) * (1.0 / 255.0);
#endif
}
