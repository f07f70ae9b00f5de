// For: transparency.h
// Fragment stage. What a surface fragment does in each pass of a sequence: Diepstraten 2002, section 6, as amended.
//
// A host's fragment shader calls tr_surface(color, object) once, last, in main. TR_RULE is defined by the preamble.
// Depths of transparent things are written and compared as the shader sees them (gl_FragCoord.z, stored unrounded in
// 32-bit float depth), so that equality means "the same fragment" and no epsilon is needed. Opaque things write no
// depth here: they keep the early depth test.
//
// object: the number that tr_object_code makes. Bits 0 to 23: id, 24 to 30: group, 31: explicit interiors.

#define TR_RULE_FRONT 0        // nearest front face: depth only
#define TR_RULE_FRONT_ALONE 1  // and its colour, when no other transparent object can tie
#define TR_RULE_PEEL 2         // the next layer behind another: depth only
#define TR_RULE_PEEL_ALONE 3   // and its colour
#define TR_RULE_PEEL_GROUP 4   // the next front face of an object that none of the layers before shows
#define TR_RULE_LAYER 5        // whose a layer is, the lowest id among those that tie, and its colour
#define TR_RULE_LAYER_MARKED 6 // and its group and method
#define TR_RULE_LAYER_GROUP 7  // a further layer: only of the first one's group, and near enough
#define TR_RULE_LIMIT 8        // where opaque things stop to show: one-sided transparent objects
#define TR_RULE_LIMIT_SHEET 9  // the same for two-sided ones, whose both sides count as front
#define TR_RULE_LIMIT_BEHIND 10 // whatever faces the pass culls not, behind a layer
#define TR_RULE_LIMIT_MARKED 11 // by the method of the front-most object, past its group
#define TR_RULE_LIMIT_MARKED_SHEET 12
#define TR_RULE_OPAQUE 13 // opaque colour
#define TR_RULE_OPAQUE_ENTERING 14 // the same; tr_strengthen, of crossings.glsl, does something

#if TR_WANTS_COLOR // defined by the preamble; where it is 0 color is not read and a host may skip its shading
layout(location = 0) out highp vec4 tr_color;
#endif
#if TR_RULE == TR_RULE_LAYER_MARKED
layout(location = 1) out highp float tr_marking;
#endif

#define TR_IS_LIMIT_MARKED (TR_RULE == TR_RULE_LIMIT_MARKED || TR_RULE == TR_RULE_LIMIT_MARKED_SHEET)
#define TR_IS_FIRST (TR_RULE == TR_RULE_FRONT || TR_RULE == TR_RULE_FRONT_ALONE)

#if !TR_IS_FIRST && TR_RULE < TR_RULE_OPAQUE
uniform highp sampler2DArray tr_front_depth; // of layers 0, 2, 4, ...; where one alone is read, those of its parity
#endif
#if TR_RULE == TR_RULE_LAYER_GROUP || TR_IS_LIMIT_MARKED
uniform highp sampler2DArray tr_odd_depth; // of layers 1, 3, 5, ...; in TR_RULE_LAYER_GROUP those of the layer before
#endif
#if TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET
uniform highp sampler2DArray tr_front_owner;
#endif
#if TR_RULE == TR_RULE_PEEL_GROUP || TR_RULE == TR_RULE_LAYER_GROUP || TR_IS_LIMIT_MARKED
uniform highp sampler2D tr_front_mark;
#endif

#ifdef TR_REVERSED_Z
#define TR_BEHIND(a, b) ((a) < (b))
#else
#define TR_BEHIND(a, b) ((a) > (b))
#endif

// Object ids travel as depths: n / 2^24 is exact in a float, and the depth test keeps the lowest.
highp float tr_owner_code(highp uint object)
{
    return float(object & 0xffffffu) * (1.0 / 16777216.0);
}

#if TR_RULE == TR_RULE_PEEL_GROUP || TR_RULE == TR_RULE_LAYER_GROUP || TR_IS_LIMIT_MARKED
// Of the front-most object.
highp uint tr_mark(ivec2 pixel)
{
    return uint(texelFetch(tr_front_mark, pixel, 0).r * 255.0 + 0.5);
}

bool tr_same_group(highp uint object, highp uint mark)
{
    return ((object >> 24) & 127u) == (mark & 127u) && (mark & 127u) != 0u;
}
#endif

#if TR_RULE == TR_RULE_PEEL_GROUP || TR_IS_LIMIT_MARKED
bool tr_is_shown(highp uint object, int count, ivec2 pixel)
{
    for (int i = 0; i < count; ++i)
        if (texelFetch(tr_front_owner, ivec3(pixel, i), 0).r == tr_owner_code(object))
            return true;
    return false;
}
#endif

#if TR_IS_LIMIT_MARKED
// Whether a fragment ends what is seen through the last shown layer, by the method of the front-most object. Explicit
// interiors end at the next face; implicit ones at a back face, or the face of an object that is not shown.
bool tr_limits(highp float depth, bool faces_eye, highp uint object, ivec2 pixel)
{
    highp uint mark = tr_mark(pixel);
    int count = tr_chain(pixel, tr_step.x + 1), last = count - 1;
    highp float behind = (last & 1) == 0 ? texelFetch(tr_front_depth, ivec3(pixel, last >> 1), 0).r
                                         : texelFetch(tr_odd_depth, ivec3(pixel, last >> 1), 0).r;
    if (mark >= 128u)
        return faces_eye && TR_BEHIND(depth, behind);
    if (!faces_eye || tr_same_group(object, mark))
        return TR_BEHIND(depth, behind) && !(faces_eye && tr_is_shown(object, count, pixel));
    return !TR_BEHIND(behind, depth) && !tr_is_shown(object, count, pixel);
}
#endif

#if TR_RULE == TR_RULE_PEEL_GROUP
// Whether a face may be the next layer: it joins the chain, or ends it. With implicit interiors further faces of objects
// that are shown do neither, and faces of other groups end it where they coincide with the layer before, too.
bool tr_may_follow(highp float depth, highp float before, highp uint object, ivec2 pixel)
{
    highp uint mark = tr_mark(pixel);
    int count = tr_step.x + 1;
    if ((mark & 127u) == 0u || tr_chain(pixel, count) < count)
        return false;
    if (mark >= 128u)
        return TR_BEHIND(depth, before);
    return !tr_is_shown(object, count, pixel) &&
           (tr_same_group(object, mark) ? TR_BEHIND(depth, before) : !TR_BEHIND(before, depth));
}
#endif

#if TR_RULE == TR_RULE_LAYER_GROUP
// Whether a face joins the chain: of the first layer's group, and near enough to the layer before (tr_blend.a; negative:
// however far).
bool tr_joins(highp float depth, highp uint object, ivec2 pixel)
{
    highp float before = texelFetch(tr_odd_depth, ivec3(pixel, (tr_step.x - 1) >> 1), 0).r;
    highp float gap = tr_distance_of(depth) - tr_distance_of(before);
    return tr_same_group(object, tr_mark(pixel)) && TR_BEHIND(depth, before) &&
           (tr_blend.a < 0.0 || gap < tr_blend.a);
}
#endif

// Whether tr_surface may keep this fragment's colour: for shaders that have much to do before they call it.
bool tr_may_show()
{
#if TR_RULE == TR_RULE_LAYER || TR_RULE == TR_RULE_LAYER_MARKED || TR_RULE == TR_RULE_LAYER_GROUP
    return gl_FragCoord.z == texelFetch(tr_front_depth, ivec3(gl_FragCoord.xy, tr_step.x >> 1), 0).r;
#else
    return true;
#endif
}

void tr_surface(highp vec4 color, highp uint object)
{
#if TR_RULE >= TR_RULE_OPAQUE
    tr_color = vec4(color.rgb, 1.0); // alpha marks "an opaque thing is here"
#else
    highp float depth = gl_FragCoord.z;
#if !TR_IS_FIRST
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#if !TR_IS_LIMIT_MARKED
    highp float front = texelFetch(tr_front_depth, ivec3(pixel, tr_step.x >> 1), 0).r;
#endif
#endif

#if TR_RULE == TR_RULE_PEEL || TR_RULE == TR_RULE_PEEL_ALONE || TR_RULE == TR_RULE_LIMIT_BEHIND
    if (!TR_BEHIND(depth, front))
        discard;
#elif TR_RULE == TR_RULE_PEEL_GROUP
    if (!tr_may_follow(depth, front, object, pixel))
        discard;
#elif TR_RULE == TR_RULE_LAYER || TR_RULE == TR_RULE_LAYER_MARKED
    if (depth != front)
        discard;
#elif TR_RULE == TR_RULE_LAYER_GROUP
    if (depth != front || !tr_joins(depth, object, pixel))
        discard;
#elif TR_RULE == TR_RULE_LIMIT || TR_RULE == TR_RULE_LIMIT_SHEET
    bool owner = texelFetch(tr_front_owner, ivec3(pixel, 0), 0).r == tr_owner_code(object);
#if TR_RULE == TR_RULE_LIMIT
    // A back face limits only what has a front face before it; a front face only if it is another object's.
    if (gl_FrontFacing ? owner || TR_BEHIND(front, depth) : !TR_BEHIND(depth, front))
        discard;
#else
    if (owner || TR_BEHIND(front, depth))
        discard;
#endif
#elif TR_RULE == TR_RULE_LIMIT_MARKED
    if (!tr_limits(depth, gl_FrontFacing, object, pixel))
        discard;
#elif TR_RULE == TR_RULE_LIMIT_MARKED_SHEET
    if (!tr_limits(depth, true, object, pixel))
        discard;
#endif

#if TR_RULE == TR_RULE_LAYER_MARKED
    tr_marking = float(object >> 24) * (1.0 / 255.0);
#endif
#if TR_WANTS_COLOR
    tr_color = color;
#endif
#if TR_RULE == TR_RULE_LAYER || TR_RULE == TR_RULE_LAYER_MARKED || TR_RULE == TR_RULE_LAYER_GROUP
    gl_FragDepth = tr_owner_code(object);
#else
    gl_FragDepth = depth;
#endif
#endif
}
