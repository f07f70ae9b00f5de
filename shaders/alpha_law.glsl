// For: transparency.h
// View-dependent alpha, Diepstraten 2002, equation 2: alpha = 1 - (d / d_max)^k, clamped to [0, 1].
//
// d: distance to the nearest silhouette, d_max: farthest surface point from the object's centre, both in one unit.
// alpha = 1 at d = 0 for every k >= 0, wherever d_max <= 0, and where either is NaN; alpha = 0 from d = d_max on.
// k = 0, and what is no positive number, leaves the silhouette alone opaque.

// x > 0, infinity included, by its bits: compilers may read !(x > 0.0) as x <= 0.0, and NaN is neither.
bool tr_positive(highp float x)
{
    return floatBitsToUint(x) - 1u < 0x7f800000u;
}

float tr_view_alpha(highp float d, highp float d_max, highp float k)
{
    if (!tr_positive(d) || !tr_positive(d_max))
        return 1.0;
    if (d >= d_max || !tr_positive(k))
        return 0.0;
    // The floor keeps log2 finite where a driver flushes denormals to zero.
    highp float ratio = max(d / d_max, 1.0e-30);
    return clamp(1.0 - exp2(k * log2(ratio)), 0.0, 1.0);
}
