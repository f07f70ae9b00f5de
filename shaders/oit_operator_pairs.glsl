// For: oit_buffers.h
// How well two fragments of pixels side by side would join (Carnecky 2013, section 4.4, equations 1 to 3): what both
// searches for links measure by. OIT_STEP.w: bits of OIT_CHOOSE_*.
#define OIT_CHOOSE_COUNTS 1u
#define OIT_CHOOSE_GROUPED 2u
#define OIT_DEPTH_WEIGHT oit_set[0].x
#define OIT_NORMAL_WEIGHT oit_set[0].y
#define OIT_PER_RADIUS oit_set[0].z
#define OIT_LIMIT_APART oit_set[0].w
#define OIT_NEVER uintBitsToFloat(0x7f800000u) // infinity
uint oit_pairs = 0u;

struct oit_side // of a pair: the one that looks
{
    float depth, predicted; // window depth, and distance along the view that its slope makes for the pixel beside
    float ahead;            // what the slope adds to the depth on the way there
    uint direction;
    vec2 slope;
    vec3 normal;
    vec2 uv;
    uint part;
};

vec2 oit_record_slope(uint at)
{
    return unpackHalf2x16(OIT_WORD(at, OIT_AT_SLOPE)) * (1.0 / 4096.0);
}

float oit_ahead(vec2 slope, uint direction)
{
    float ahead = direction < 2u ? slope.x : slope.y;
    return (direction & 1u) != 0u ? ahead : -ahead;
}

oit_side oit_toward(oit_side side, uint direction)
{
    side.direction = direction;
    side.ahead = oit_ahead(side.slope, direction);
    side.predicted = oit_distance(side.depth + side.ahead);
    return side;
}

// Toward no side yet.
oit_side oit_look(uint slot)
{
    uint at = oit_record(slot);
    oit_side side;
    side.slope = oit_record_slope(at);
    side.depth = side.predicted = oit_record_window_depth(at);
    side.ahead = 0.0;
    side.direction = 0u;
    side.normal = oit_record_normal(at);
    side.part = OIT_WORD(at, OIT_AT_PART);
    side.uv = vec2(0.0);
#if OIT_HAS_UV
    side.uv = oit_uv(slot);
#endif
    return side;
}

// How far apart in depth, in radii.
float oit_apart(oit_side side, uint at)
{
    return abs(side.predicted - oit_distance(oit_record_window_depth(at))) * OIT_PER_RADIUS;
}

// Two units of rounding may leave the product of unit vectors above 1; bends that are not negative are what the window
// stops by.
float oit_bend(oit_side side, uint at)
{
    return max(1.0 - dot(side.normal, oit_record_normal(at)), 0.0);
}

bool oit_may_join(oit_side side, uint at)
{
    ++oit_pairs;
    return OIT_WORD(at, OIT_AT_PART) == side.part && oit_record_blend(at) == 0u;
}

// Within the limit of what its slope predicts, or where a surface is found whose slope changes steadily from the one's to
// the other's: between what the two slopes say. So a surface holds together where it is seen at a grazing angle, and
// beyond the limit nothing is glued to what lies behind it and slopes alike.
bool oit_is_continuous(oit_side side, uint at, float apart)
{
    float rise = oit_record_window_depth(at) - side.depth;
    return apart <= OIT_LIMIT_APART || (rise > side.ahead) != (rise > oit_ahead(oit_record_slope(at), side.direction));
}

float oit_measure_by_depth(oit_side side, uint at, float apart)
{
    return oit_is_continuous(side, at, apart) ? OIT_DEPTH_WEIGHT * apart + OIT_NORMAL_WEIGHT * oit_bend(side, at)
                                              : OIT_NEVER;
}
