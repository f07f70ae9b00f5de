// For: transparency.h
// Adds the masks of a run to those of targets painted before, by GL_MIN or by multiplication. Red: where the target
// itself is not; green: where it is, which alone cuts other targets.
#if TR_TOGETHER
uniform highp sampler2D tr_remaining; // occluders still to be painted, in 255ths
#endif
layout(location = 0) out highp vec4 tr_alphas;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool own;
    highp float depth, alpha = tr_mask_at(pixel, own, depth);
    if (alpha >= 1.0)
        discard;
#if TR_TOGETHER
    highp vec2 after = texelFetch(tr_remaining, pixel, 0).rg;
    highp float m = floor((own ? after.g : after.r) * 255.0 + 0.5);
    alpha = tr_shared(alpha, tr_seq_numbers.z > 0 ? min(m, float(tr_seq_numbers.z)) : m);
#endif
    alpha = mix(1.0, alpha, tr_masks[tr_v_mask].law.z);
    tr_alphas = own ? vec4(1.0, alpha, 1.0, 1.0) : vec4(alpha, 1.0, 1.0, 1.0);
}
