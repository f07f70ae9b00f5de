// For: transparency.h
// The mask at the target's resolution: red the opacity that it asks for (Assarsson 2006, algorithm 2), green the target's
// strength; and its depth. On the target as that was drawn, beside it from the mask's texels: their distances are
// interpolated, their depths never.
uniform highp sampler2D tr_see_depth; // of targets
#if TR_IN_PARTS
uniform highp sampler2D tr_see_bits; // which of eight pixels are a target's
#else
uniform highp sampler2D tr_see_mark;
#endif
#if TR_HAS_LOW
uniform highp sampler2D tr_see_low; // distance, strength, active
uniform highp sampler2D tr_see_low_depth;
#endif
layout(location = 0) out highp vec4 tr_color;

// Of the search lights at a pixel; full within the radius, linear over the edge, of several the strongest.
highp float tr_light_at(highp vec2 position)
{
    highp float most = 0.0;
    for (int i = 0; i < int(tr_see_law.w); ++i) {
        highp vec4 light = tr_see_lights[i];
        highp float outside = distance(position, light.xy) - light.z;
        most = max(most, outside <= 0.0 ? 1.0 : light.w > 0.0 ? clamp(1.0 - outside / light.w, 0.0, 1.0) : 0.0);
    }
    return most;
}

#if TR_HAS_LOW
highp float tr_low_distance(ivec2 texel, ivec2 size)
{
    return texelFetch(tr_see_low, clamp(texel, ivec2(0), size - 1), 0).r;
}

// To the nearest pixel of a target, interpolated between the four texels around.
highp float tr_distance_at(ivec2 pixel)
{
    int divisor = tr_see_grid.x;
    ivec2 size = (ivec2(tr_viewport.zw) + divisor - 1) / divisor;
    highp vec2 place = (vec2(pixel) + 0.5) / float(divisor) - 0.5;
    ivec2 low = ivec2(floor(place));
    highp vec2 part = place - vec2(low);
    highp float below = mix(tr_low_distance(low, size), tr_low_distance(low + ivec2(1, 0), size), part.x);
    highp float above = mix(tr_low_distance(low + ivec2(0, 1), size), tr_low_distance(low + 1, size), part.x);
    return mix(below, above, part.y) * float(tr_see_grid.w + 2 * divisor);
}
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#if TR_IN_PARTS
    int bits = int(texelFetch(tr_see_bits, ivec2(pixel.x >> 3, pixel.y), 0).r * 255.0 + 0.5);
    highp vec2 mark = vec2(float((bits >> (pixel.x & 7)) & 1), 0.0);
#else
    highp vec2 mark = texelFetch(tr_see_mark, pixel, 0).ab;
#endif
    highp float opacity = tr_see_law.x, depth;
    if (mark.r > 0.0) {
        depth = texelFetch(tr_see_depth, pixel, 0).r;
    } else {
#if TR_HAS_LOW
        ivec2 texel = pixel / tr_see_grid.x;
        highp vec3 low = texelFetch(tr_see_low, texel, 0).rgb;
        // The pixels beside the target are the gradient's first ring.
        opacity = mix(tr_see_law.y, 1.0, clamp((tr_distance_at(pixel) - 1.0) / tr_see_law.z, 0.0, 1.0));
        if (opacity == 1.0 || low.r == 1.0)
            discard;
        mark = low.gb;
        depth = texelFetch(tr_see_low_depth, texel, 0).r;
#else
        discard;
#endif
    }
    if (tr_see_law.w > 0.0 && mark.g > 0.5)
        opacity = 1.0 - tr_light_at(vec2(pixel) + 0.5) * (1.0 - opacity);
    tr_color = vec4(opacity, mark.r, 0.0, 0.0);
    gl_FragDepth = depth;
}
