// For: transparency.h
// What the mask of a target asks for at a pixel: Assarsson 2006, rule R2 and figure 2.
uniform highp sampler2D tr_seed;          // depth where the target is, open
uniform highp usampler2D tr_nearest_seed; // of seq_near.frag
flat in highp int tr_v_mask;

int tr_seed_distance(ivec2 way)
{
#if TR_RINGS
    int rings = max(abs(way.x), abs(way.y));
    return rings * rings;
#else
    return way.x * way.x + way.y * way.y;
#endif
}

// The square of the distance from a pixel to the nearest pixel of the target, and the depth there; -1: none within reach.
// The target itself is had at full resolution; around it the nearest of what the four cells around have found is taken.
int tr_find_seed(ivec2 pixel, out highp float depth)
{
    int cell = tr_seq_numbers.x, least = -1;
    depth = texelFetch(tr_seed, pixel, 0).r;
    if (depth != TR_CLEAR_DEPTH)
        return 0;
    ivec2 last = (tr_seq_view.zw - 1) / cell;
    ivec2 first = (2 * pixel - (cell - 1) + 2 * cell) / (2 * cell) - 1; // rounded down
    for (int i = 0; i < (cell == 1 ? 1 : 4); ++i) {
        ivec2 at = clamp(first + ivec2(i & 1, i >> 1), ivec2(0), last);
        highp uvec2 found = texelFetch(tr_nearest_seed, at, 0).rg;
        if (found.x == 0u)
            continue;
        ivec2 seed = at * cell + ivec2(found) - 32768;
        int size = tr_seed_distance(seed - pixel);
        highp float there = texelFetch(tr_seed, seed, 0).r;
        if (least >= 0 && (size > least || (size == least && !TR_NEARER(there, depth))))
            continue;
        least = size;
        depth = there;
    }
    return least;
}

// The strongest of the search lights: 1 within its radius, falling to 0 over its edge.
highp float tr_light_at(highp vec2 place)
{
    highp float most = 0.0;
    for (int i = 0; i < tr_seq_numbers.w; ++i) {
        highp vec4 light = tr_seq_lights[i];
        highp float beyond = length(place - light.xy) - light.z;
        most = max(most, beyond <= 0.0 ? 1.0 : light.w > 0.0 ? clamp(1.0 - beyond / light.w, 0.0, 1.0) : 0.0);
    }
    return most;
}

uniform highp usampler2D tr_forms; // of seq_forms.frag

highp float tr_form_at(int texel)
{
    return uintBitsToFloat(texelFetch(tr_forms, ivec2(tr_v_mask, texel), 0).r);
}

// How many pixels outside of circle, ellipse or hull a pixel's middle lies; 0 within.
highp float tr_beyond_form(highp vec2 place)
{
    highp vec2 high = vec2(tr_form_at(0), tr_form_at(16)), low = -vec2(tr_form_at(32), tr_form_at(48));
    highp vec2 radius = (high - low) * 0.5, way = place - (low + high) * 0.5;
    highp float scale = tr_form_at(64), beyond = 0.0;
    if (tr_seq_law.w == 1.0)
        return max(length(way) - scale, 0.0);
    if (tr_seq_law.w == 2.0) { // along the ray from the middle
        highp vec2 far = vec2(radius.x > 0.0 ? way.x / (radius.x * scale) : 0.0,
                              radius.y > 0.0 ? way.y / (radius.y * scale) : 0.0);
        highp float size = length(far);
        return size > 1.0 ? length(way) * (1.0 - 1.0 / size) : 0.0;
    }
    // The hull by the lines that touch it in 64 directions: at a corner it is off by a hundredth of the sides there.
    for (int i = 0; i < 64; ++i) {
        highp float angle = float(i) * (6.283185307179586 / 64.0);
        beyond = max(beyond, dot(place, vec2(cos(angle), sin(angle))) - tr_form_at(i));
    }
    return beyond;
}

// Opacity that what is before the target is to have together; 1: no mask here. own: the target itself is here.
highp float tr_mask_at(ivec2 pixel, out bool own, out highp float depth)
{
    int square = tr_find_seed(pixel, depth);
    own = square == 0;
    if (square < 0)
        return 1.0;
    highp float beyond = tr_seq_law.w > 0.0 ? tr_beyond_form(vec2(pixel) + 0.5) : max(sqrt(float(square)) - 1.0, 0.0);
    // Pixels of the target lie on the form's very outline, but for rounding.
    beyond = beyond > 1.0e-3 ? beyond : 0.0;
    highp float opacity = 1.0;
    if (own || (tr_seq_law.w > 0.0 && beyond <= 0.0))
        opacity = tr_seq_law.x;
    else if (tr_seq_law.z > 0.0)
        opacity = mix(tr_seq_law.y, 1.0, min(beyond / tr_seq_law.z, 1.0));
    highp float strength = tr_masks[tr_v_mask].law.x;
    if (tr_masks[tr_v_mask].law.y > 0.0)
        strength *= tr_light_at(vec2(pixel) + 0.5);
    return mix(1.0, opacity, strength);
}

// What each of m layers has so that together they have this opacity (Carnecky 2013, equation 5).
highp float tr_shared(highp float opacity, highp float m)
{
    return m > 0.0 ? 1.0 - pow(1.0 - opacity, 1.0 / m) : opacity;
}
