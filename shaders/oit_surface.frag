// For: oit_buffers.h
// Built-in surfaces: the object's colour, lit from both sides where the frame has a light.
#if OIT_PASS == OIT_FILL
in vec3 oit_v_color;
uniform vec4 oit_object_color;
#endif
#if OIT_WANTS_NORMAL
in vec3 oit_v_normal;
#endif
#if (OIT_PASS == OIT_FILL && (OIT_HAS_PART || OIT_HAS_KEY || OIT_HAS_BLEND || OIT_HAS_NORMAL)) || OIT_KEY_BITS == 16
uniform uvec4 oit_object; // part, key, blend, whether normals go with the side that is seen
#endif

void main()
{
#if OIT_PASS == OIT_COUNT && OIT_KEY_BITS == 16
    oit_fragment f;
    f.part = oit_object.x;
    oit_store(f);
#elif OIT_PASS == OIT_COUNT
    oit_store(vec4(0.0));
#else
    vec4 color = oit_object_color;
    color.rgb += oit_v_color;
#if OIT_WANTS_NORMAL
    float size = dot(oit_v_normal, oit_v_normal);
    vec3 normal = size > 1.0e-30 ? oit_v_normal * inversesqrt(size) : vec3(0.0, 0.0, 1.0);
#endif
#if OIT_LIT
    color.rgb *= 0.35 + 0.65 * abs(dot(normal, oit_light.xyz));
#endif
#if OIT_PREMULTIPLIED
    color.rgb *= color.a;
#endif
    oit_fragment f;
    f.color = color;
#if OIT_HAS_PART
    f.part = oit_object.x;
#endif
#if OIT_HAS_KEY
    f.key = oit_object.y;
#endif
#if OIT_HAS_BLEND
    f.blend = oit_object.z;
#endif
#if OIT_HAS_NORMAL
    f.normal = oit_object.w != 0u && !gl_FrontFacing ? -normal : normal;
#endif
#if OIT_HAS_UV
    f.uv = vec2(0.0);
#endif
#if OIT_HOST_WORDS > 0
    for (int i = 0; i < OIT_HOST_WORDS; ++i)
        f.words[i] = 0u;
#endif
    oit_store(f);
#endif
}
