// For: oit_buffers.h
// What operators are written with, ours and the host's (Carnecky 2013, section 4.5). A fragment is known by its slot: those
// of a pixel are first, first + 1, ... from the eye on. After oit_ordered.glsl. The buffer of the surfaces stands at the
// binding point of the reports.
#ifdef OIT_COMPOSES
layout(std430, binding = OIT_BINDING_REPORT) readonly buffer oit_surfaces { uint oit_surface[]; };
#else
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = OIT_BINDING_REPORT) buffer oit_surfaces { uint oit_surface[]; };
#endif
// Where the sections lie in it, a word a fragment each; 0: there is none.
#ifdef OIT_COMPOSES
layout(location = 0) uniform highp uvec4 oit_at[6];
layout(location = 8) uniform highp vec4 oit_set[8]; // 0 to 3: of the operator's own
#else
layout(location = 0) uniform highp uvec4 oit_given_at[6];
layout(location = 8) uniform highp vec4 oit_given_set[8];
// Taken once: some drivers read a uniform lane by lane, wherever it stands in a loop.
highp uvec4 oit_at[6];
highp vec4 oit_set[8];
void oit_take_numbers()
{
    for (int i = 0; i < 6; ++i)
        oit_at[i] = oit_given_at[i];
    for (int i = 0; i < 8; ++i)
        oit_set[i] = oit_given_set[i];
}
#endif
#define OIT_IN_ORDER oit_at[0].x   // number of the record
#define OIT_IN_LINKS oit_at[0].y   // left, right, down, up: layers of the neighbours in their pixels, 8 bits each
#define OIT_IN_FAR_LINKS oit_at[0].z // not 0: 16 bits each, the last two here
#define OIT_IN_REACH oit_at[0].w   // beta, gamma: steps to the nearest source, 16 bits each
#define OIT_IN_BASE oit_at[1].x
#define OIT_IN_KAPPA oit_at[1].y
#define OIT_IN_BETA oit_at[1].z    // where it is diffused
#define OIT_IN_GAMMA oit_at[1].w
#define OIT_IN_BEFORE oit_at[2].x  // what goes on to OIT_IN_AFTER
#define OIT_IN_AFTER oit_at[2].y
#define OIT_IN_SIZES oit_at[2].z   // how far the surface goes on to the left, right, down, up, 16 bits each; two words
#define OIT_IN_GROUPED oit_at[2].w // layers by part, then depth
#define OIT_IN_HOST oit_at[3]
#define OIT_STEP oit_at[4]         // of the operator's own
#define OIT_EXTRA_STEP oit_at[5]

#define OIT_LEFTWARD 0u
#define OIT_RIGHTWARD 1u
#define OIT_DOWNWARD 2u
#define OIT_UPWARD 3u
#define OIT_UNREACHED 65535u
#define OIT_BLOCKED 65534u // kept at 0: nothing passes

// How many fragments pixel p has, and the first of their slots. A pixel whose run did not fit has none.
uint oit_list(uint p, out uint first)
{
    uint base, n;
    bool fits = oit_find_run(p, base, n);
    first = base / uint(OIT_VECTORS);
    return fits ? n : 0u;
}

uint oit_record(uint slot)
{
    return oit_surface[OIT_IN_ORDER + slot] * uint(OIT_VECTORS);
}

float oit_record_window_depth(uint at)
{
#if OIT_REVERSED_Z
    return uintBitsToFloat(0x7fffffffu - oit_record_depth(at));
#else
    return uintBitsToFloat(oit_record_depth(at));
#endif
}

uint oit_record_blend(uint at)
{
#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8
    return OIT_WORD(at, OIT_AT_COLOR) >> 30u;
#elif OIT_HAS_BLEND
    return OIT_WORD(at, OIT_AT_BLEND) & 255u;
#else
    return 0u;
#endif
}

vec4 oit_record_color(uint at)
{
#if OIT_COLOR == OIT_COLOR_FLOAT
    return oit_unpack_color(uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), OIT_WORD(at, OIT_AT_COLOR + 2),
                                  OIT_WORD(at, OIT_AT_COLOR + 3)));
#else
    return oit_unpack_color(uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), 0u, 0u));
#endif
}

#if OIT_HAS_NORMAL
vec3 oit_record_normal(uint at)
{
    vec2 folded = unpackSnorm2x16(OIT_WORD(at, OIT_AT_NORMAL));
    vec3 n = vec3(folded, 1.0 - abs(folded.x) - abs(folded.y));
    float under = max(-n.z, 0.0);
    n.xy -= vec2(n.x >= 0.0 ? under : -under, n.y >= 0.0 ? under : -under);
    return normalize(n);
}
#endif

// ---- of a fragment ----

float oit_depth(uint slot) // window depth
{
    return oit_record_window_depth(oit_record(slot));
}

vec4 oit_color(uint slot) // as it was stored
{
    return oit_record_color(oit_record(slot));
}

bool oit_is_surface(uint slot)
{
#if OIT_HAS_BLEND
    return oit_record_blend(oit_record(slot)) == 0u;
#else
    return true;
#endif
}

#if OIT_HAS_NORMAL
vec3 oit_normal(uint slot)
{
    return oit_record_normal(oit_record(slot));
}
#endif
#if OIT_HAS_PART
uint oit_part_of(uint slot)
{
    return OIT_WORD(oit_record(slot), OIT_AT_PART);
}
#endif
#if OIT_HAS_UV
vec2 oit_uv(uint slot)
{
    uint at = oit_record(slot);
    return vec2(uintBitsToFloat(OIT_WORD(at, OIT_AT_UV)), uintBitsToFloat(OIT_WORD(at, OIT_AT_UV + 1)));
}
#endif
#if OIT_HAS_SLOPE
vec2 oit_slope(uint slot) // of the window depth, a pixel to the right and a pixel up
{
    return unpackHalf2x16(OIT_WORD(oit_record(slot), OIT_AT_SLOPE)) * (1.0 / 4096.0);
}
#endif

// ---- neighbours ----

// The pixel beside p; false: the image ends there.
bool oit_beside(uint p, uint direction, out uint q)
{
    uint width = uint(oit_area.z);
    q = direction == OIT_LEFTWARD ? p - 1u : direction == OIT_RIGHTWARD ? p + 1u : direction == OIT_DOWNWARD ? p - width : p + width;
    if (direction < 2u)
        return direction == OIT_LEFTWARD ? p % width != 0u : q % width != 0u;
    return direction == OIT_DOWNWARD ? p >= width : q < oit_pool.x;
}

// Layer of the neighbour within its pixel; OIT_NONE: there is no neighbour.
uint oit_link(uint slot, uint direction)
{
    bool wide = OIT_IN_FAR_LINKS != 0u; // without a branch: some drivers go both ways
    uint word = oit_surface[(wide && direction >= 2u ? OIT_IN_FAR_LINKS : OIT_IN_LINKS) + slot];
    uint none = wide ? 65535u : 255u, layer = word >> (wide ? 16u * (direction & 1u) : 8u * direction) & none;
    return layer == none ? OIT_NONE : layer;
}

// Slot of the neighbour of a fragment of pixel p, or OIT_NONE.
uint oit_neighbour(uint p, uint slot, uint direction)
{
    uint layer = oit_link(slot, direction), q, first;
    if (layer == OIT_NONE || !oit_beside(p, direction, q))
        return OIT_NONE;
    oit_list(q, first);
    return first + layer;
}

// ---- values ----

#define OIT_BASE 0u
#define OIT_BETA 1u
#define OIT_GAMMA 2u
#define OIT_KAPPA 3u
#define OIT_HOST 4u // + k

// Of equation 9 after n steps from 1 at the sources: the distance says it all.
float oit_reached(uint distance, uint n, float lambda)
{
    return distance <= n ? max(1.0 - lambda * float(distance), 0.0) : 0.0;
}

// What lambda has to be for a field to end within its share of the surface's width (oit_set[7].z), which is the distance
// between the fragments with boundary conditions on either side along the row, or the column if that is less. Distances
// beyond oit_set[7].w are not known for certain: there it is wide.
float oit_steepest(uint slot, float lambda)
{
    float width = 1.0e9;
    for (uint axis = 0u; axis < 2u; ++axis) {
        uint word = oit_surface[(axis == 0u ? OIT_IN_SIZES : OIT_EXTRA_STEP.z) + slot];
        uvec2 sides = uvec2(word & 65535u, word >> 16u);
        if (float(max(sides.x, sides.y)) <= oit_set[7].w)
            width = min(width, float(sides.x + sides.y));
    }
    return max(lambda, 1.0 / max(oit_set[7].z * width, 1.0));
}

uint oit_steps(uint slot, bool gamma)
{
    return oit_surface[OIT_IN_REACH + slot] >> (gamma ? 16u : 0u) & 65535u;
}

// A value before its profile.
float oit_value(uint which, uint slot)
{
    if (which >= OIT_HOST)
        return uintBitsToFloat(oit_surface[OIT_IN_HOST[which - OIT_HOST] + slot]);
    if (which == OIT_BASE)
        return uintBitsToFloat(oit_surface[OIT_IN_BASE + slot]);
    if (which == OIT_KAPPA)
        return uintBitsToFloat(oit_surface[OIT_IN_KAPPA + slot]);
    bool gamma = which == OIT_GAMMA;
    uint diffused = gamma ? OIT_IN_GAMMA : OIT_IN_BETA;
    if (diffused != 0u)
        return uintBitsToFloat(oit_surface[diffused + slot]);
    float lambda = gamma ? oit_set[7].y : oit_set[7].x;
    if (oit_set[7].z > 0.0)
        lambda = oit_steepest(slot, lambda);
    return oit_reached(oit_steps(slot, gamma), gamma ? OIT_EXTRA_STEP.y : OIT_EXTRA_STEP.x, lambda);
}

#ifndef OIT_COMPOSES
// OIT_BASE and OIT_HOST + k; NaN and infinities become 0, and base is cut to [0,1].
void oit_set_value(uint which, uint slot, float x)
{
    uint bits = floatBitsToUint(x);
    x = (bits & 0x7f800000u) == 0x7f800000u ? 0.0 : x;
    if (which == OIT_BASE)
        oit_surface[OIT_IN_BASE + slot] = floatBitsToUint(clamp(x, 0.0, 1.0));
    else
        oit_surface[OIT_IN_HOST[which - OIT_HOST] + slot] = floatBitsToUint(x);
}

// Of an operator with iterations.
float oit_before(uint slot)
{
    return uintBitsToFloat(oit_surface[OIT_IN_BEFORE + slot]);
}

void oit_set_after(uint slot, float x)
{
    uint bits = floatBitsToUint(x);
    oit_surface[OIT_IN_AFTER + slot] = (bits & 0x7f800000u) == 0x7f800000u ? 0u : bits;
}
#endif

// ---- where a fragment is ----

// Distance along the view of a window depth: equations of clip z and w solved for the eye's z, by oit_i_operator_view.
float oit_distance(float depth)
{
    return (oit_set[4].x + oit_set[4].y * depth) / (oit_set[4].z + oit_set[4].w * depth);
}

vec2 oit_device(uint p)
{
    uint width = uint(oit_area.z);
    return (2.0 * vec2(float(p % width), float(p / width)) + 1.0) / vec2(oit_area.zw) - 1.0;
}

// In the space of the eye.
vec3 oit_position(vec2 device, float depth)
{
    float z = -oit_distance(depth);
    return vec3(device * (oit_set[6].x * z + oit_set[6].y) * oit_set[5].xy - oit_set[5].zw * z - oit_set[6].zw, z);
}

// Toward the eye: how x and y change along the ray of a pixel, by z.
vec3 oit_to_eye(vec2 device)
{
    return normalize(vec3(device * oit_set[6].x * oit_set[5].xy - oit_set[5].zw, 1.0));
}

#ifndef OIT_COMPOSES
void oit_operate(uint p);

#ifndef OIT_OWN_MAIN
void main()
{
    oit_take_numbers();
    uvec2 where = gl_GlobalInvocationID.xy;
    if (where.x < uint(oit_area.z) && where.y < uint(oit_area.w))
        oit_operate(where.y * uint(oit_area.z) + where.x);
}
#endif
#endif
