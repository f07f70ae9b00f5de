// For: transparency.h
// How far the masks of a pixel look: the farthest of their depths is kept by the depth test.
void main()
{
    bool own;
    highp float depth, opacity = tr_mask_at(ivec2(gl_FragCoord.xy), own, depth);
    if (opacity >= 1.0)
        discard;
    gl_FragDepth = depth;
}
