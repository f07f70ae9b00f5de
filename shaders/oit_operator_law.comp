// For: oit_buffers.h
// The opacity that each surface fragment starts with (Carnecky 2013, section 5.2). OIT_STEP: x: the law; y: distances
// beyond that many steps are not known for certain: far; oit_set[0]: s, exponent, scale, reach.
#define OIT_LAW_GIVEN 0u
#define OIT_LAW_CONSTANT 1u
#define OIT_LAW_ADAPTIVE 2u
#define OIT_LAW_ANGLE 3u
#define OIT_LAW_VARIATION 4u

#if OIT_HAS_NORMAL
float oit_facing(uint p, uint slot)
{
    return pow(min(abs(dot(oit_normal(slot), oit_to_eye(oit_device(p)))), 1.0), oit_set[0].y);
}
#endif

#if OIT_HAS_SLOPE
// How much normals change around it: halved across both neighbours, the whole of one where the other is missing.
float oit_variation(uint p, uint slot)
{
    float sum = 0.0;
    for (uint axis = 0u; axis < 2u; ++axis) {
        uint low = oit_neighbour(p, slot, 2u * axis), high = oit_neighbour(p, slot, 2u * axis + 1u);
        vec3 step = oit_normal(high == OIT_NONE ? slot : high) - oit_normal(low == OIT_NONE ? slot : low);
        sum += dot(step, step) * (low == OIT_NONE || high == OIT_NONE ? 1.0 : 0.25);
    }
    return sqrt(sum);
}
#endif

// 1 - (1 - s)^(1/m), by logarithms, both as series where 1 - s and 1 - e^x would lose the digits of what is small.
float oit_adaptive(float s, float layers)
{
    if (s >= 1.0)
        return 1.0;
    float x = (s < 0.01 ? -s * (1.0 + s * (0.5 + s * (1.0 / 3.0 + s * 0.25))) : log(1.0 - s)) / layers;
    return x > -0.01 ? -x * (1.0 + x * (0.5 + x * (1.0 / 6.0))) : 1.0 - exp(x);
}

float oit_law(uint p, uint slot, float layers)
{
    float s = oit_set[0].x;
    if (OIT_STEP.x == OIT_LAW_GIVEN)
        return oit_color(slot).a;
    if (OIT_STEP.x == OIT_LAW_CONSTANT)
        return s;
    if (OIT_STEP.x == OIT_LAW_ADAPTIVE)
        return oit_adaptive(s, layers);
#if OIT_HAS_NORMAL
    if (OIT_STEP.x == OIT_LAW_ANGLE)
        return 1.0 - (1.0 - s) * oit_facing(p, slot);
#endif
#if OIT_HAS_SLOPE
    if (OIT_STEP.x == OIT_LAW_VARIATION)
        return 1.0 - (1.0 - s) * exp(-oit_set[0].z * oit_variation(p, slot));
    uint steps = oit_steps(slot, false);
    float near = steps <= OIT_STEP.y ? min(float(steps) / oit_set[0].w, 1.0) : 1.0;
    return 1.0 - (1.0 - s) * pow(near, oit_set[0].y);
#else
    return s;
#endif
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first), layers = 0u;
    for (uint i = 0u; i < n; ++i)
        layers += oit_is_surface(first + i) ? 1u : 0u;
    for (uint i = 0u; i < n; ++i)
        oit_set_value(OIT_BASE, first + i, oit_is_surface(first + i) ? oit_law(p, first + i, float(layers)) : 0.0);
}
