// For: transparency.h
// A copy of the depths drawn so far, for the lines to read while they write depth themselves.
uniform highp sampler2D tr_scene_depth;

void main()
{
    gl_FragDepth = texelFetch(tr_scene_depth, ivec2(gl_FragCoord.xy), 0).r;
}
