// For: transparency.h
// Fragment stage. Hodges' first rule (Diepstraten 2002, section 3): the shade of an opaque object is strengthened where
// it enters a transparent one, by distance from the curves where their surfaces cross.
#if TR_STRENGTHENS
uniform highp sampler2D tr_crossings; // two texels a segment, rows of 1024 texels: its ends

highp vec3 tr_crossing_end(int index)
{
    return texelFetch(tr_crossings, ivec2(index & 1023, index >> 10), 0).xyz;
}

// Of a point to the segments range.x up to range.x + range.y; the reach, tr_enter.y, where none is nearer.
highp float tr_crossing_distance(highp vec3 point, highp ivec2 range)
{
    highp float least = tr_enter.y * tr_enter.y;
    // A range of more than there is ends where the texture does.
    int end = min(range.x + range.y, 512 * textureSize(tr_crossings, 0).y);
    for (int i = max(range.x, 0); i < end; ++i) {
        highp vec3 a = tr_crossing_end(2 * i);
        highp vec3 along = tr_crossing_end(2 * i + 1) - a, from = point - a;
        highp float square = dot(along, along);
        highp float t = square > 0.0 ? clamp(dot(from, along) / square, 0.0, 1.0) : 0.0;
        highp vec3 away = from - t * along;
        least = min(least, dot(away, away));
    }
    return sqrt(least);
}
#endif

// position: of the fragment in the space of the segments. Returns color where there is nothing to strengthen.
highp vec4 tr_strengthen(highp vec4 color, highp vec3 position, highp ivec2 range)
{
#if TR_STRENGTHENS
    highp float reach = tr_enter.y, distance_to = tr_crossing_distance(position, range);
    highp float pixel = max(length(dFdx(position)), length(dFdy(position)));
    color.rgb *= 1.0 - tr_enter.x * (1.0 - distance_to / reach);
    // The curve itself, as a line: half of its width on either side.
    if (distance_to < 0.5 * tr_enter.z * pixel)
        color.rgb = tr_ink[1].rgb;
#endif
    return color;
}
