// For: transparency.h
// View-dependent alpha, Diepstraten 2002, equation 2: alpha = 1 - (d / d_max)^k, clamped to [0, 1].
//
// d: distance to the nearest silhouette, d_max: farthest surface point from the object's centre, both in one unit.
// alpha = 1 at d = 0 for every k >= 0, wherever d_max <= 0, and for NaN; alpha = 0 from d = d_max on.
// k = 0 leaves the silhouette alone opaque; negative k counts as 0.
float tr_view_alpha(highp float d, highp float d_max, highp float k)
{
    if (!(d > 0.0) || !(d_max > 0.0))
        return 1.0;
    if (!(d < d_max))
        return 0.0;
    // The floor keeps log2 finite where a driver flushes denormals to zero.
    highp float ratio = max(d / d_max, 1.0e-30);
    return clamp(1.0 - exp2(max(k, 0.0) * log2(ratio)), 0.0, 1.0);
}
