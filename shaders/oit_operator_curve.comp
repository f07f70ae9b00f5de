// For: oit_buffers.h
// Curvature of the surface at a fragment, tanh(kappa1 + kappa2) (Murray 2016, section 5.1), and opacity from it. The trace
// of the map from steps along the surface to differences of normals: no division by a normal's z, so that grazing normals
// are bounded. Without one of the four neighbours -1. OIT_STEP: x: 1: the opacities go to base; oit_set[0]: x: 1 / unit, 0:
// steps are those in the window; y, z: distance to depth. OIT_STEP.y: 1: the curvature toward the eye, too.
layout(location = 16) uniform highp uvec4 oit_opacities[64]; // 16 rows of 32 in 16 bits each

float oit_opacity_entry(uint at)
{
    uint word = oit_opacities[at >> 3u][at >> 1u & 3u];
    return float((at & 1u) != 0u ? word >> 16u : word & 65535u) * (1.0 / 65535.0);
}

float oit_opacity(float curvature, float depth)
{
    vec2 at = vec2(clamp(curvature, 0.0, 1.0) * 31.0, clamp(depth, 0.0, 1.0) * 15.0);
    uvec2 cell = min(uvec2(at), uvec2(30u, 14u));
    vec2 within = at - vec2(cell);
    uint from = cell.y * 32u + cell.x;
    return mix(mix(oit_opacity_entry(from), oit_opacity_entry(from + 1u), within.x),
               mix(oit_opacity_entry(from + 32u), oit_opacity_entry(from + 33u), within.x), within.y);
}

float oit_trace(vec3 t[2], vec3 dn[2])
{
    float a = dot(t[0], t[0]), b = dot(t[0], t[1]), c = dot(t[1], t[1]), square = a * c - b * b;
    if (!(square > 1.0e-6 * a * c))
        return 0.0;
    return -(c * dot(dn[0], t[0]) - b * (dot(dn[0], t[1]) + dot(dn[1], t[0])) + a * dot(dn[1], t[1])) / square;
}

float oit_kappa(uint p, uint slot)
{
    vec3 t[2] = vec3[2](vec3(2.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0)), dn[2];
    for (uint axis = 0u; axis < 2u; ++axis) {
        uint low = oit_neighbour(p, slot, 2u * axis), high = oit_neighbour(p, slot, 2u * axis + 1u), q, r;
        if (low == OIT_NONE || high == OIT_NONE)
            return -1.0;
        dn[axis] = oit_normal(high) - oit_normal(low);
        if (oit_set[0].x > 0.0) {
            oit_beside(p, 2u * axis, q);
            oit_beside(p, 2u * axis + 1u, r);
            t[axis] = (oit_position(oit_device(r), oit_depth(high)) - oit_position(oit_device(q), oit_depth(low))) * oit_set[0].x;
        }
    }
    return tanh(clamp(oit_trace(t, dn), -20.0, 20.0));
}

void oit_operate(uint p)
{
    uint first, n = oit_list(p, first);
    for (uint i = 0u; i < n; ++i) {
        uint slot = first + i;
        bool surface = oit_is_surface(slot);
        float kappa = surface ? oit_kappa(p, slot) : 0.0;
        oit_surface[OIT_IN_KAPPA + slot] = floatBitsToUint(kappa);
#if OIT_CONTOURS
        if (OIT_STEP.y != 0u)
            oit_surface[OIT_IN_RADIAL + slot] = floatBitsToUint(surface ? oit_radial(p, slot) : 0.0);
#endif
        if (OIT_STEP.x != 0u && surface)
            oit_set_value(OIT_BASE, slot, oit_opacity(abs(kappa), (oit_distance(oit_depth(slot)) - oit_set[0].y) * oit_set[0].z));
    }
}
