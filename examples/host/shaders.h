/* shaders.h: the engine's GLSL. Blocks: 0 Frame, 1 Material, 2 Bones. Units: 0 sun, 1 colour, 2 normal, 3 id, 4 depth,
 * 5 occlusion. */
#ifndef HOST_SHADERS_H
#define HOST_SHADERS_H

#define FRAME_BLOCK                                                                                                    \
    "layout(std140, binding = 0) uniform Frame {\n"                                                                    \
    "    mat4 clip_from_world, view_from_world, sun_from_world;\n"                                                     \
    "    vec4 eye, sun, lens;\n" /* lens: tan of half the field of view in x and y, nearest, half width of the sun */  \
    "};\n"

#define MATERIAL_BLOCK                                                                                                 \
    "layout(std140, binding = 1) uniform Material {\n"                                                                 \
    "    vec4 base, surface;\n" /* surface: pattern, shine, metal, glow */                                             \
    "};\n"

/* Every pass that draws the world has this stage and so the same bits of gl_Position: the depth prepass is followed by
 * a pass that tests for equality. SUN draws for the sun, SKINNED with bones. */
static const char world_vert[] =
    FRAME_BLOCK "layout(location = 0) in vec3 position;\n"
                "layout(location = 1) in vec3 normal;\n"
                "layout(location = 2) in uvec2 bones;\n"
                "layout(location = 3) in uvec2 weights;\n"
                "layout(location = 4) in vec4 row_0;\n"
                "layout(location = 5) in vec4 row_1;\n"
                "layout(location = 6) in vec4 row_2;\n"
                "layout(location = 7) in vec3 instance_tint;\n"
                "layout(location = 8) in uint instance_id;\n"
                "#ifdef SKINNED\n"
                "layout(std140, binding = 2) uniform Bones { mat4 palette[16]; };\n"
                "#endif\n"
                "invariant gl_Position;\n"
                "out vec3 world, world_normal, local, tint;\n"
                "flat out uint id;\n"
                "void main() {\n"
                "    vec4 p = vec4(position, 1);\n"
                "    vec3 n = normal;\n"
                "#ifdef SKINNED\n"
                "    vec2 w = vec2(weights) / 255.0;\n"
                "    mat4 skin = palette[bones.x] * w.x + palette[bones.y] * w.y;\n"
                "    p = skin * p;\n"
                "    n = mat3(skin) * n;\n"
                "#endif\n"
                "    world = vec3(dot(row_0, p), dot(row_1, p), dot(row_2, p));\n"
                "    world_normal = vec3(dot(row_0.xyz, n), dot(row_1.xyz, n), dot(row_2.xyz, n));\n"
                "    local = position;\n"
                "    tint = instance_tint;\n"
                "    id = instance_id;\n"
                "#ifdef SUN\n"
                "    gl_Position = sun_from_world * vec4(world, 1);\n"
                "#else\n"
                "    gl_Position = clip_from_world * vec4(world, 1);\n"
                "#endif\n"
                "}\n";

static const char depth_frag[] = "void main() {}\n";

static const char noise_glsl[] =
    "float random(vec3 p) {\n"
    "    return fract(sin(dot(p, vec3(12.71, 78.23, 37.72))) * 4375.85);\n"
    "}\n"
    "float noise(vec3 p) {\n"
    "    vec3 i = floor(p), f = fract(p);\n"
    "    f = f * f * (3.0 - 2.0 * f);\n"
    "    vec4 a = vec4(random(i), random(i + vec3(0, 1, 0)), random(i + vec3(0, 0, 1)), random(i + vec3(0, 1, 1)));\n"
    "    i.x += 1.0;\n"
    "    vec4 b = vec4(random(i), random(i + vec3(0, 1, 0)), random(i + vec3(0, 0, 1)), random(i + vec3(0, 1, 1)));\n"
    "    a = mix(a, b, f.x);\n"
    "    return mix(mix(a.x, a.y, f.y), mix(a.z, a.w, f.y), f.z);\n"
    "}\n"
    "float clouds(vec3 p) {\n"
    "    return (noise(p) + 0.5 * noise(2.1 * p + 7.0) + 0.25 * noise(4.3 * p + 3.0)) / 1.75;\n"
    "}\n";

static const char material_glsl[] = MATERIAL_BLOCK
    /* Grass, trodden earth along a path, layers of earth where the ground is cut. */
    "vec3 ground_colour(vec3 p, vec3 n) {\n"
    "    float rough = clouds(p * 0.9), fine = clouds(p * 5.0);\n"
    "    vec3 grass = mix(vec3(0.20, 0.25, 0.09), vec3(0.36, 0.37, 0.14), rough) * (0.75 + 0.5 * fine);\n"
    "    vec3 earth = mix(vec3(0.36, 0.26, 0.16), vec3(0.50, 0.40, 0.27), fine);\n"
    "    float path = abs(p.z - 3.6 - 1.3 * sin(p.x * 0.33)) - 1.4 + 1.6 * (rough - 0.5);\n"
    "    float yard = length((p.xz - vec2(-9.0, -6.0)) * vec2(0.9, 1.1)) - 3.4 + 2.0 * (rough - 0.5);\n"
    "    vec3 top = mix(earth, grass, smoothstep(-0.25, 0.45, min(path, yard)));\n"
    "    float layer = p.y * 5.0 + 1.5 * clouds(p * 0.7);\n"
    "    vec3 cut = mix(vec3(0.23, 0.16, 0.11), vec3(0.42, 0.31, 0.20), noise(vec3(0.0, layer, 0.0)));\n"
    "    return mix(cut, top, smoothstep(0.55, 0.8, n.y));\n"
    "}\n"
    /* Plates with dark joints between them, worn bare here and there. */
    "vec3 plate_colour(vec3 c, vec3 p) {\n"
    "    vec3 cell = abs(fract(p * 1.1 + 0.5) - 0.5) / 1.1;\n"
    "    float joint = min(cell.x, min(cell.y, cell.z));\n"
    "    c *= mix(0.62, 1.0, smoothstep(0.006, 0.018, joint));\n"
    "    return mix(c, vec3(0.42, 0.38, 0.34), 0.55 * smoothstep(0.60, 0.74, clouds(p * 3.1)));\n"
    "}\n"
    "vec3 material_colour(vec3 tint, vec3 p, vec3 world, vec3 n) {\n"
    "    vec3 c = base.rgb * tint;\n"
    "    if (surface.x == 1.0)\n"
    "        c = ground_colour(world, n);\n"
    "    else if (surface.x == 2.0)\n"
    "        c *= 0.6 + 0.75 * clouds(world * 2.3);\n"
    "    else if (surface.x == 3.0)\n"
    "        c = plate_colour(c, p);\n"
    "    return c;\n"
    "}\n";

static const char light_glsl[] =
    "layout(binding = 0) uniform sampler2DShadow sun_depth;\n"
    "float sunlight(vec3 world, vec3 n) {\n"
    "    vec3 p = (sun_from_world * vec4(world + 0.04 * n, 1)).xyz;\n"
    "    vec2 texel = 1.0 / vec2(textureSize(sun_depth, 0));\n"
    "    float lit = 0.0;\n"
    "    for (int y = -2; y <= 2; y++)\n"
    "        for (int x = -2; x <= 2; x++)\n"
    "            lit += texture(sun_depth, vec3(p.xy * 0.5 + 0.5 + vec2(x, y) * texel, p.z));\n"
    "    return lit / 25.0;\n"
    "}\n"
    "vec3 light(vec3 colour, vec3 world, vec3 n) {\n"
    "    vec3 v = normalize(eye.xyz - world), h = normalize(v + sun.xyz);\n"
    "    float facing = max(dot(n, sun.xyz), 0.0), lit = facing > 0.0 ? sunlight(world, n) : 0.0;\n"
    "    vec3 sky = mix(vec3(0.34, 0.28, 0.22), vec3(0.50, 0.60, 0.74), 0.5 + 0.5 * n.y);\n"
    "    float shine = surface.y * pow(max(dot(n, h), 0.0), mix(18.0, 90.0, surface.z)) * lit * facing;\n"
    "    float rim = 0.35 * surface.y * pow(1.0 - max(dot(n, v), 0.0), 4.0);\n"
    "    vec3 bright = mix(vec3(1), colour, surface.z);\n"
    "    return colour * (sky * 0.62 + vec3(2.7, 2.4, 1.9) * facing * lit + surface.w) + bright * (2.5 * shine + rim * sky);\n"
    "}\n";

static const char world_frag[] = "in vec3 world, world_normal, local, tint;\n"
                                 "flat in uint id;\n"
                                 "layout(location = 0) out vec4 out_colour;\n"
                                 "layout(location = 1) out vec2 out_normal;\n"
                                 "layout(location = 2) out uint out_id;\n"
                                 "void main() {\n"
                                 "    vec3 n = normalize(world_normal);\n"
                                 "    out_colour = vec4(light(material_colour(tint, local, world, n), world, n), 1);\n"
                                 "    vec3 e = mat3(view_from_world) * n;\n"
                                 "    e.xy /= abs(e.x) + abs(e.y) + abs(e.z);\n" /* the octahedral map */
                                 "    vec2 folded = (1.0 - abs(e.yx)) * vec2(e.x < 0.0 ? -1 : 1, e.y < 0.0 ? -1 : 1);\n"
                                 "    out_normal = e.z < 0.0 ? folded : e.xy;\n"
                                 "    out_id = id;\n"
                                 "}\n";

/* One triangle over everything. */
static const char screen_vert[] = "out vec2 at;\n"
                                  "void main() {\n"
                                  "    at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;\n"
                                  "    gl_Position = vec4(at * 2.0 - 1.0, 0, 1);\n"
                                  "}\n";

/* How much of the hemisphere over a pixel is covered nearby: points of a spiral in it against the depth buffer. */
static const char occlusion_frag[] = FRAME_BLOCK
    "layout(binding = 2) uniform sampler2D normals;\n"
    "layout(binding = 4) uniform sampler2D depths;\n"
    "in vec2 at;\n"
    "layout(location = 0) out float open;\n"
    "const int TAPS = 14;\n"
    "const float REACH = 0.9;\n"
    "vec3 view_at(vec2 where, float depth) {\n"
    "    float away = lens.z / max(depth, 1e-6);\n"
    "    return vec3((where * 2.0 - 1.0) * lens.xy * away, -away);\n"
    "}\n"
    "vec3 normal_at(vec2 e) {\n"
    "    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));\n"
    "    if (n.z < 0.0)\n"
    "        n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1 : 1, n.y < 0.0 ? -1 : 1);\n"
    "    return normalize(n);\n"
    "}\n"
    "void main() {\n"
    "    float depth = textureLod(depths, at, 0.0).r;\n"
    "    open = 1.0;\n"
    "    if (depth == 0.0)\n"
    "        return;\n"
    "    vec3 n = normal_at(textureLod(normals, at, 0.0).xy), p = view_at(at, depth) + 0.02 * n;\n"
    "    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;\n"
    "    float start = float((cell.x * 4 + cell.y * 7) & 15) / 16.0, covered = 0.0;\n"
    "    vec3 side = normalize(abs(n.z) < 0.9 ? cross(n, vec3(0, 0, 1)) : cross(n, vec3(1, 0, 0))), up = cross(n, side);\n"
    "    for (int i = 0; i < TAPS; i++) {\n"
    "        float t = (float(i) + start) / float(TAPS), angle = 2.399963 * (float(i) + 16.0 * start), z = sqrt(1.0 - t);\n"
    "        float around = sqrt(t);\n"
    "        vec3 q = p + REACH * (0.15 + 0.85 * t) * (around * (cos(angle) * side + sin(angle) * up) + z * n);\n"
    "        vec2 where = q.xy / (-q.z * lens.xy) * 0.5 + 0.5;\n"
    "        float found = lens.z / max(textureLod(depths, where, 0.0).r, 1e-6), in_front = -q.z - found;\n"
    "        covered += in_front > 0.0 ? smoothstep(1.6 * REACH, 0.4 * REACH, in_front) : 0.0;\n"
    "    }\n"
    "    open = 1.0 - covered / float(TAPS);\n"
    "}\n";

/* The picture: occlusion, blurred over the 4x4 cells of its pattern, lines where things end, tones, and SCALE^2 samples
 * to a pixel. */
static const char resolve_frag[] =
    "layout(binding = 1) uniform sampler2D colours;\n"
    "layout(binding = 3) uniform usampler2D ids;\n"
    "layout(binding = 4) uniform sampler2D depths;\n"
    "layout(binding = 5) uniform sampler2D opens;\n"
    "in vec2 at;\n"
    "layout(location = 0) out vec4 pixel;\n"
    "float open_at(ivec2 p, float depth) {\n"
    "    float sum = 0.0, weights = 1e-4;\n"
    "    for (int y = -2; y < 2; y++)\n"
    "        for (int x = -2; x < 2; x++) {\n"
    "            ivec2 q = clamp(p + ivec2(x, y), ivec2(0), textureSize(depths, 0) - 1);\n"
    "            float w = abs(texelFetch(depths, q, 0).r / depth - 1.0) < 0.02 ? 1.0 : 0.0;\n"
    "            sum += w * texelFetch(opens, q, 0).r;\n"
    "            weights += w;\n"
    "        }\n"
    "    return sum / weights;\n"
    "}\n"
    /* A line lies on the nearer side of the boundary of two things. */
    "float line_at(ivec2 p, uint id, float depth) {\n"
    "    float line = 0.0;\n"
    "    for (int k = 0; k < 4; k++) {\n"
    "        ivec2 q = clamp(p + ivec2((k & 1) * 2 - 1, 0).xy * (1 - (k >> 1)) + ivec2(0, (k & 1) * 2 - 1) * (k >> 1),\n"
    "                        ivec2(0), textureSize(ids, 0) - 1);\n"
    "        if (texelFetch(ids, q, 0).r != id && texelFetch(depths, q, 0).r <= depth)\n"
    "            line = 1.0;\n"
    "    }\n"
    "    return line;\n"
    "}\n"
    "vec3 sample_at(ivec2 p) {\n"
    "    float depth = texelFetch(depths, p, 0).r;\n"
    "    vec3 backdrop = mix(vec3(0.80, 0.76, 0.68), vec3(0.50, 0.56, 0.62), smoothstep(0.0, 1.1, length(at - vec2(0.5, 0.35))));\n"
    "    if (depth == 0.0)\n"
    "        return backdrop;\n"
    "    float open = open_at(p, depth);\n"
    "    vec3 c = texelFetch(colours, p, 0).rgb * mix(vec3(0.20, 0.17, 0.16), vec3(1), open * open);\n"
    "    return mix(c, c * 0.25, line_at(p, texelFetch(ids, p, 0).r, depth));\n"
    "}\n"
    "vec3 tone(vec3 c) {\n"
    "    c = 1.0 - exp(-0.92 * c);\n"
    "    c = mix(vec3(dot(c, vec3(0.30, 0.55, 0.15))), c, 1.18);\n"
    "    return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2));\n"
    "}\n"
    "void main() {\n"
    "    vec3 sum = vec3(0);\n"
    "    for (int y = 0; y < SCALE; y++)\n"
    "        for (int x = 0; x < SCALE; x++)\n"
    "            sum += tone(sample_at(ivec2(gl_FragCoord.xy) * SCALE + ivec2(x, y)));\n"
    "    pixel = vec4(sum / float(SCALE * SCALE), 1);\n"
    "}\n";

#endif
