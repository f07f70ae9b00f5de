// For: transparency.h
// Cool-to-warm shading, Gooch 1999, section 3.2 (the model of Gooch 1998): hue carries orientation, so that black is
// left for lines and white for highlights.
//
// normal and light: unit vectors in one space, light points toward the light. cool.a and warm.a say how much of the
// diffuse colour is mixed into the cool and the warm end.
vec3 tr_cool_to_warm(vec3 diffuse, vec3 normal, vec3 light, vec4 cool, vec4 warm)
{
    float warmth = 0.5 + 0.5 * dot(normal, light);
    vec3 cool_end = cool.rgb + cool.a * diffuse;
    vec3 warm_end = warm.rgb + warm.a * diffuse;
    return clamp(mix(cool_end, warm_end, warmth), 0.0, 1.0);
}
