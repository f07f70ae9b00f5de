// For: transparency.h
// Built-in surface program for hosts without shaders of their own: fragment stage.
uniform highp uint tr_object;
#if TR_STRENGTHENS
uniform highp ivec2 tr_crossing_range;
in highp vec3 tr_v_position;
#endif
#if TR_WANTS_COLOR
in highp vec3 tr_v_normal;
in highp vec4 tr_v_color;
#endif

#if TR_IS_SEE && TR_RULE != TR_RULE_SEE_BLOCK
layout(location = 0) out highp vec4 tr_color;
#endif

void main()
{
#if TR_WANTS_COLOR
    highp float length_squared = dot(tr_v_normal, tr_v_normal);
    // A missing or cancelled normal shades as if it faced across the light, not as NaN.
    highp vec3 normal = length_squared > 0.0 ? tr_v_normal * inversesqrt(length_squared) : vec3(0.0);
    if (!gl_FrontFacing)
        normal = -normal;
    highp vec4 color = vec4(tr_cool_to_warm(tr_v_color.rgb, normal, tr_light.xyz, tr_cool, tr_warm), tr_v_color.a);
#if TR_STRENGTHENS
    color = tr_strengthen(color, tr_v_position, tr_crossing_range);
#endif
#if TR_WANTS_ALPHA
    if (tr_may_show())
        color.a *= tr_alpha();
#endif
#else
    highp vec4 color = vec4(0.0);
#endif
#if TR_IS_SEE
    tr_see_through(color, tr_object);
#if TR_RULE != TR_RULE_SEE_BLOCK
    tr_color = color;
#endif
#else
    tr_surface(color, tr_object);
#endif
}
