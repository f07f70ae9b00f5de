// For: transparency.h
// What the masks of a run leave of the opacity of four layers, over those before by GL_MIN or by multiplication:
// Assarsson 2006, rules R2 to R4, section 3.5. tr_seq_step.x: which four.
uniform highp sampler2DArray tr_layer_even; // depths
uniform highp sampler2DArray tr_layer_odd;
uniform highp usampler2DArray tr_chain;
layout(location = 0) out highp vec4 tr_alphas;

// How much of a layer yields to the mask; 0: it does not act on it.
highp float tr_acts(ivec2 pixel, int layer, highp uint code, bool own, highp float behind)
{
    highp vec4 law = tr_masks[tr_v_mask].law;
    highp float depth = (layer & 1) == 0 ? texelFetch(tr_layer_even, ivec3(pixel, layer >> 1), 0).r
                                         : texelFetch(tr_layer_odd, ivec3(pixel, layer >> 1), 0).r;
    if ((code & 0xffffu) == uint(law.w) || !TR_NEARER(depth, behind) || ((code & TR_CODE_TARGET) != 0u && !own))
        return 0.0;
    return tr_yields(law.z, code);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool own;
    highp float behind, opacity = tr_mask_at(pixel, own, behind), m = 0.0;
    highp vec4 yields = vec4(0.0);
    if (opacity >= 1.0)
        discard;
    for (int i = 0; i < tr_seq_more.x; ++i) {
        highp uint code = texelFetch(tr_chain, ivec3(pixel, i), 0).r;
        if ((code & TR_LAYER_NONE) != 0u || (tr_seq_numbers.z > 0 && m >= float(tr_seq_numbers.z)))
            break;
        highp float yield_ = tr_acts(pixel, i, code, own, behind);
        if (i >> 2 == tr_seq_step.x)
            yields[i & 3] = yield_;
        m += yield_ > 0.0 ? 1.0 : 0.0;
        if ((code & TR_LAYER_LAST) != 0u)
            break;
    }
    tr_alphas = mix(vec4(1.0), vec4(tr_seq_more.w != 0 ? tr_shared(opacity, m) : opacity), yields);
}
