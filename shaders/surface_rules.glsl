// For: transparency.h
// Fragment stage. What a surface fragment does in each pass of a sequence: Diepstraten 2002, section 6, as amended.
//
// A host's fragment shader calls tr_surface(color, object) once, last, in main. TR_RULE is defined by the preamble.
// Depths of transparent things are written and compared as the shader sees them (gl_FragCoord.z, stored unrounded in
// 32-bit float depth), so that equality means "the same fragment" and no epsilon is needed. Opaque things write no
// depth here: they keep the early depth test.

#define TR_RULE_FRONT 0         // nearest front face: depth only
#define TR_RULE_OWNER 1         // whose it is: the lowest object id among those that tie
#define TR_RULE_LIMIT 2         // where opaque things stop to show: one-sided transparent objects
#define TR_RULE_LIMIT_SHEET 3   // the same for two-sided ones, whose both sides count as front
#define TR_RULE_LIMIT_BEHIND 4  // whatever faces the pass culls not, behind the front-most one
#define TR_RULE_OPAQUE 5        // opaque colour
#define TR_RULE_BLENDED 6       // the one transparent fragment of a pixel
#define TR_RULE_BLENDED_ALONE 7 // the same when no other transparent object can tie

#if TR_WANTS_COLOR // defined by the preamble; where it is 0 color is not read and a host may skip its shading
layout(location = 0) out highp vec4 tr_color;
#endif

#if TR_RULE != TR_RULE_FRONT && TR_RULE != TR_RULE_OPAQUE
uniform highp sampler2D tr_front_depth;
#endif
#if TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET || TR_RULE == TR_RULE_BLENDED
uniform highp sampler2D tr_front_owner;
#endif

#ifdef TR_REVERSED_Z
#define TR_BEHIND(a, b) ((a) < (b))
#else
#define TR_BEHIND(a, b) ((a) > (b))
#endif

// Object ids travel as depths: n / 2^24 is exact in a float, and the depth test keeps the lowest.
highp float tr_owner_code(highp uint object)
{
    return float(object) * (1.0 / 16777216.0);
}

void tr_surface(highp vec4 color, highp uint object)
{
#if TR_RULE == TR_RULE_OPAQUE
    tr_color = vec4(color.rgb, 1.0); // alpha marks "an opaque thing is here"
#else
    highp float depth = gl_FragCoord.z;
#if TR_RULE != TR_RULE_FRONT
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    highp float front = texelFetch(tr_front_depth, pixel, 0).r;
#endif

#if TR_RULE == TR_RULE_OWNER
    if (depth != front)
        discard;
    gl_FragDepth = tr_owner_code(object);
#else

#if TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET || TR_RULE == TR_RULE_BLENDED
    bool owner = texelFetch(tr_front_owner, pixel, 0).r == tr_owner_code(object);
#endif

#if TR_RULE == TR_RULE_LIMIT
    // A back face limits only what has a front face before it; a front face only if it is another object's.
    if (gl_FrontFacing ? owner || TR_BEHIND(front, depth) : !TR_BEHIND(depth, front))
        discard;
#elif TR_RULE == TR_RULE_LIMIT_SHEET
    if (owner || TR_BEHIND(front, depth))
        discard;
#elif TR_RULE == TR_RULE_LIMIT_BEHIND
    if (!TR_BEHIND(depth, front))
        discard;
#elif TR_RULE == TR_RULE_BLENDED
    if (depth != front || !owner)
        discard;
    tr_color = color;
#elif TR_RULE == TR_RULE_BLENDED_ALONE
    if (depth != front)
        discard;
    tr_color = color;
#endif
    gl_FragDepth = depth;
#endif
#endif
}
