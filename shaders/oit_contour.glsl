// For: oit_buffers.h
// Suggestive contours (DeCarlo, Finkelstein, Rusinkiewicz, Santella 2003) on every layer, by links: where the curvature
// in the direction to the eye, laid into the surface, is 0 and rises toward the eye. With normals that face the eye convex
// is positive here. Surfaces are looked at over two pixels each way, or as far as links lead. Lengths are in radii of the
// links, so that fourth powers of them stay in the range of floats whatever the unit. oit_set[1].z: 1 over the radius.
#define OIT_IN_RADIAL oit_at[5].w // that curvature, then smoothed; 0 where it cannot be told

struct oit_cross // around a fragment: left, right, below, above
{
    uint slots[4];
    vec3 across[2]; // along the axes of the eye's space
    vec2 pixels;
};

// False: an axis has no extent.
bool oit_cross_of(uint p, uint slot, out oit_cross c)
{
    uvec4 pixels = uvec4(p);
    c.pixels = vec2(0.0);
    for (uint d = 0u; d < 4u; ++d) {
        c.slots[d] = slot;
        for (uint k = 0u; k < 2u; ++k) {
            uint next = oit_neighbour(pixels[d], c.slots[d], d), q;
            if (next == OIT_NONE || !oit_beside(pixels[d], d, q))
                break;
            pixels[d] = q;
            c.slots[d] = next;
            c.pixels[d >> 1u] += 1.0;
        }
    }
    for (uint axis = 0u; axis < 2u; ++axis)
        c.across[axis] = (oit_position(oit_device(pixels[2u * axis + 1u]), oit_depth(c.slots[2u * axis + 1u])) -
                          oit_position(oit_device(pixels[2u * axis]), oit_depth(c.slots[2u * axis]))) *
                         oit_set[1].z;
    return c.pixels.x > 0.0 && c.pixels.y > 0.0;
}

// The direction to the eye less its part along the normal, and that as so much of what lies across on either axis. False:
// it cannot be told.
bool oit_toward(uint p, uint slot, oit_cross c, out vec3 toward, out vec2 parts)
{
    vec3 normal = oit_normal(slot), eye = oit_to_eye(oit_device(p));
    float xx = dot(c.across[0], c.across[0]), xy = dot(c.across[0], c.across[1]), yy = dot(c.across[1], c.across[1]);
    float square = xx * yy - xy * xy;
    toward = eye - dot(eye, normal) * normal;
    float x = dot(toward, c.across[0]), y = dot(toward, c.across[1]);
    parts = vec2(yy * x - xy * y, xx * y - xy * x) / square;
    return square > 1.0e-6 * xx * yy && dot(toward, toward) > 1.0e-6;
}

#ifndef OIT_COMPOSES
// Beside silhouettes curvatures without bound would be smoothed into their surroundings: k becomes k / (1 + |k| / 10),
// which keeps zeros, and slopes there.
float oit_radial(uint p, uint slot)
{
    oit_cross c;
    vec3 toward;
    vec2 parts;
    if (!oit_cross_of(p, slot, c) || !oit_toward(p, slot, c, toward, parts))
        return 0.0;
    vec3 bend = parts.x * (oit_normal(c.slots[1]) - oit_normal(c.slots[0])) +
                parts.y * (oit_normal(c.slots[3]) - oit_normal(c.slots[2]));
    float radial = dot(bend, toward) / dot(toward, toward);
    radial /= 1.0 + abs(radial) * 0.1;
    return dot(oit_normal(slot), oit_to_eye(oit_device(p))) < 0.0 ? -radial : radial;
}
#else
float oit_radial_of(uint slot)
{
    return uintBitsToFloat(oit_surface[OIT_IN_RADIAL + slot]);
}

// How much of a fragment a contour covers: by its distance in pixels, to first order, and fading where the curvature rises
// slowly or the surface faces the eye, where contours say little. oit_set[1]: x: half a line and half a pixel; y: 1 over
// the least rise.
float oit_contour(uint p, uint slot)
{
    oit_cross c;
    vec3 toward;
    vec2 parts, rise;
    if (!oit_cross_of(p, slot, c) || !oit_toward(p, slot, c, toward, parts))
        return 0.0;
    for (uint axis = 0u; axis < 2u; ++axis)
        rise[axis] = oit_radial_of(c.slots[2u * axis + 1u]) - oit_radial_of(c.slots[2u * axis]);
    float steep = length(toward), each = length(rise / c.pixels), covered = oit_set[1].x * each - abs(oit_radial_of(slot));
    if (!(covered > 0.0))
        return 0.0;
    return min(covered / each, 1.0) * clamp(dot(parts, rise) / steep * oit_set[1].y - 1.0, 0.0, 1.0) *
           clamp(4.0 * steep - 1.0, 0.0, 1.0);
}
#endif
