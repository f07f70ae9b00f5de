/* mock_driver.h: GL without a GPU or a driver, for the mock tests of transparency.h, which is included before: notes the
 * calls, counts what is alive, fails where it is told to, and refuses what would wait. */
#ifndef GLASSINE_TESTS_MOCK_DRIVER_H
#define GLASSINE_TESTS_MOCK_DRIVER_H

/* ---- the driver that is not there ---- */

enum { MAX_CALLS = 20000 };

static struct {
    const char *version;
    const char *missing;  /* function that get_proc does not know */
    int fail_compile;     /* 1: shaders do not compile; 2: programs do not link */
    int lost_at;          /* this call and all after it do nothing, as when the context is lost; 0: none */
    int fail_framebuffer; /* the n-th check of completeness fails; 0: none */
    uint32_t refused_framebuffer, refused_texture, other_texture; /* other_texture: one that is not 2D */
    int width, height;                                            /* of the host's textures */
    int depth_bits;                                               /* of the target; 32: floats */
    bool depth_alone;                                             /* its stencil is not attached */
    uint32_t color_buffer, component_type;                        /* its first draw buffer, and what is in all of its */
    int framebuffer_checks, samples, max_texture_size;
    int live[7];           /* textures, framebuffers, buffers, vertex arrays, shaders, programs, fences */
    bool signalled;        /* fences are, as soon as they are made */
    unsigned char *mapped; /* what a buffer that is mapped holds */
    int scissors;          /* calls that set a box */
    uint32_t next_name;
    const char *calls[MAX_CALLS];
    int call_count;
    uint32_t bound_framebuffer, program, vertex_array;
    uint32_t attachments[256][3]; /* depth and two colour textures of a framebuffer */
    int active_unit;
    uint32_t unit_textures[32];
    unsigned char switched_off[0x10000]; /* by name of the switch */
    char text[4096];                     /* all that was logged */
} driver;

enum { TEXTURES, FRAMEBUFFERS, BUFFERS, ARRAYS, SHADERS, PROGRAMS, FENCES };

static void reset_driver(void) {
    memset(&driver, 0, sizeof driver);
    driver.version = "4.5.0 Mock";
    driver.max_texture_size = 16384;
    driver.depth_bits = 24;
    driver.color_buffer = 0x8CE0u;
    driver.component_type = 0x8C17u;
}

static void note(const char *name) {
    assert_true(driver.call_count < MAX_CALLS);
    driver.calls[driver.call_count++] = name;
}

/* A lost context answers nothing: what is asked for stays as it was, values are 0. Asked after each note. */
static bool lost(void) {
    return driver.lost_at && driver.call_count >= driver.lost_at;
}

static int called_since(int first, const char *name) {
    int count = 0;
    for (int i = first; i < driver.call_count; ++i)
        count += strcmp(driver.calls[i], name) == 0;
    return count;
}

static void generate(int kind, int32_t count, uint32_t *names) {
    driver.live[kind] += count;
    for (int32_t i = 0; i < count; ++i)
        names[i] = ++driver.next_name;
}

/* Deleting the name 0 is silently nothing, as in GL. */
static void discard(int kind, int32_t count, const uint32_t *names) {
    for (int32_t i = 0; i < count; ++i)
        driver.live[kind] -= names[i] != 0;
}

#define U uint32_t
#define I int32_t
#define B unsigned char
/* No unit may hold a texture that is being drawn into. */
static void check_units(void) {
    const uint32_t *drawn = driver.attachments[driver.bound_framebuffer & 255];
    for (int unit = 0; unit < 32; ++unit)
        for (int a = 0; a < 3; ++a)
            if (driver.bound_framebuffer && drawn[a])
                assert_int_not_equal(driver.unit_textures[unit], drawn[a]);
}

#define FAKE(name, parameters, body)                                                                                   \
    static void fake_##name parameters {                                                                               \
        note(#name);                                                                                                   \
        if (lost())                                                                                                    \
            return;                                                                                                    \
        body                                                                                                           \
    }

FAKE(ActiveTexture, (U a), driver.active_unit = (int)(a - 0x84C0u);)
FAKE(AttachShader, (U a, U b), (void)a; (void)b;)
FAKE(BindBuffer, (U a, U b), (void)a; (void)b;)
FAKE(BindBufferBase, (U a, U b, U c), (void)a; (void)b; (void)c;)
FAKE(BindBufferRange, (U a, U b, U c, ptrdiff_t d, ptrdiff_t e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(BindFramebuffer, (U a, U b),
     if (a == 0x8CA9u && (b == 0 || b != driver.refused_framebuffer)) driver.bound_framebuffer = b;)
FAKE(BindSampler, (U a, U b), (void)a; (void)b;)
FAKE(BindTexture, (U a, U b), (void)a;
     if (b == 0 || b != driver.other_texture) driver.unit_textures[driver.active_unit & 31] = b;)
FAKE(BindVertexArray, (U a), driver.vertex_array = a;)
FAKE(BlendEquationSeparate, (U a, U b), (void)a; (void)b;)
FAKE(BlendEquationSeparatei, (U a, U b, U c), (void)a; (void)b; (void)c;)
FAKE(BlendFuncSeparate, (U a, U b, U c, U d), (void)a; (void)b; (void)c; (void)d;)
FAKE(BlendFuncSeparatei, (U a, U b, U c, U d, U e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(BlitFramebuffer, (I a, I b, I c, I d, I e, I f, I g, I h, U i, U j), (void)a; (void)b; (void)c; (void)d; (void)e;
     (void)f; (void)g; (void)h; (void)i; (void)j;)
FAKE(BufferData, (U a, ptrdiff_t b, const void *c, U d), (void)a; (void)b; (void)c; (void)d;)
FAKE(BufferSubData, (U a, ptrdiff_t b, ptrdiff_t c, const void *d), (void)a; (void)b; (void)c; (void)d;)
FAKE(ClearBufferfv, (U a, I b, const float *c), (void)a; (void)b; (void)c;)
FAKE(ColorMask, (B a, B b, B c, B d), (void)a; (void)b; (void)c; (void)d;)
FAKE(ColorMaski, (U a, B b, B c, B d, B e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(CompileShader, (U a), (void)a;)
FAKE(CullFace, (U a), (void)a;)
FAKE(DeleteBuffers, (I a, const U *b), discard(BUFFERS, a, b);)
FAKE(DeleteFramebuffers, (I a, const U *b), discard(FRAMEBUFFERS, a, b);)
FAKE(DeleteProgram, (U a), discard(PROGRAMS, 1, &a);)
FAKE(DeleteShader, (U a), discard(SHADERS, 1, &a);)
FAKE(DeleteTextures, (I a, const U *b), discard(TEXTURES, a, b);)
FAKE(DeleteVertexArrays, (I a, const U *b), discard(ARRAYS, a, b);)
FAKE(DepthFunc, (U a), (void)a;)
FAKE(DepthMask, (B a), (void)a;)
FAKE(DepthRange, (double a, double b), (void)a; (void)b;)
FAKE(DepthRangef, (float a, float b), (void)a; (void)b;)
FAKE(DepthRangeIndexed, (U a, double b, double c), (void)a; (void)b; (void)c;)
FAKE(GetDoublev, (U a, double *b), (void)a; b[0] = 0; b[1] = 1;)
FAKE(GetDoublei_v, (U a, U b, double *c), (void)a; (void)b; c[0] = 0; c[1] = 1;)
FAKE(GetFloati_v, (U a, U b, float *c), (void)a; (void)b; c[0] = c[1] = c[2] = c[3] = 7;)
FAKE(ViewportIndexedf, (U a, float b, float c, float d, float e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(Disable, (U a), driver.switched_off[a & 0xffffu] = 1;)
FAKE(Disablei, (U a, U b), (void)a; (void)b;)
FAKE(DrawArrays, (U a, I b, I c), (void)a; (void)b; (void)c; check_units();)
FAKE(DrawBuffers, (I a, const U *b), (void)a; (void)b;)
FAKE(Enable, (U a), (void)a;)
FAKE(Enablei, (U a, U b), (void)a; (void)b;)
FAKE(FramebufferTexture2D, (U a, U b, U c, U d, I e), (void)a; (void)c; (void)e;
     driver.attachments[driver.bound_framebuffer & 255][b == 0x8D00u || b == 0x821Au ? 0 : b - 0x8CDFu] = d;)
FAKE(FramebufferTextureLayer, (U a, U b, U c, I d, I e), (void)a; (void)d; (void)e;
     driver.attachments[driver.bound_framebuffer & 255][b == 0x8D00u ? 0 : b - 0x8CDFu] = c;)
FAKE(FrontFace, (U a), (void)a;)
FAKE(GenBuffers, (I a, U *b), generate(BUFFERS, a, b);)
FAKE(GenFramebuffers, (I a, U *b), generate(FRAMEBUFFERS, a, b);)
FAKE(GenTextures, (I a, U *b), generate(TEXTURES, a, b);)
FAKE(GenVertexArrays, (I a, U *b), generate(ARRAYS, a, b);)
FAKE(GetBooleanv, (U a, B *b), (void)a; memset(b, 1, 4);)
FAKE(GetBooleani_v, (U a, U b, B *c), (void)a; (void)b; memset(c, 1, 4);)
FAKE(GetFloatv, (U a, float *b), (void)a; b[0] = 0; b[1] = 1;)
/* Of a target of so many bits of depth, and 8 of stencil in the same texture. */
FAKE(GetFramebufferAttachmentParameteriv, (U a, U b, U c, I *d), (void)a;
     *d = b == 0x8D20u && driver.depth_alone ? 0
          : c == 0x8CD0u                     ? (driver.depth_bits || b == driver.color_buffer ? 0x1702 : 0)
          : c == 0x8216u                     ? driver.depth_bits
          : c == 0x8217u                     ? 8
          : c == 0x8210u                     ? 0x2601
          : c == 0x8211u ? (I)(b == 0x8D00u && driver.depth_bits == 32 ? 0x1406u : driver.component_type)
                         : 1;)
FAKE(GetTexLevelParameteriv, (U a, I b, U c, I *d), (void)a; (void)b; *d = c == 0x1000u ? driver.width : driver.height;)
FAKE(GetInteger64i_v, (U a, U b, int64_t *c), (void)a; (void)b; *c = 0;)
FAKE(GetIntegeri_v, (U a, U b, I *c), (void)a; (void)b; *c = 0;)
FAKE(GetProgramInfoLog, (U a, I b, I *c, char *d), (void)a; (void)c; snprintf(d, (size_t)b, "link trouble");)
FAKE(GetShaderInfoLog, (U a, I b, I *c, char *d), (void)a; (void)c; snprintf(d, (size_t)b, "compile trouble");)
FAKE(GetProgramiv, (U a, U b, I *c), (void)a; (void)b; *c = driver.fail_compile != 2;)
FAKE(GetShaderiv, (U a, U b, I *c), (void)a; (void)b; *c = driver.fail_compile != 1;)
FAKE(LinkProgram, (U a), (void)a;)
FAKE(PolygonMode, (U a, U b), (void)a; (void)b;)
FAKE(PixelStorei, (U a, I b), (void)a; (void)b;)
FAKE(ReadBuffer, (U a), (void)a;)
FAKE(ReadPixels, (I a, I b, I c, I d, U e, U f, void *g), (void)a; (void)b; (void)c; (void)d; (void)e; (void)f;
     (void)g;)
FAKE(DeleteSync, (void *a), driver.live[FENCES] -= a != NULL;)
FAKE(Scissor, (I a, I b, I c, I d), (void)a; (void)b; (void)c; (void)d; ++driver.scissors;)
FAKE(ScissorIndexed, (U a, I b, I c, I d, I e), (void)a; (void)b; (void)c; (void)d; (void)e; ++driver.scissors;)
FAKE(ShaderSource, (U a, I b, const char *const *c, const I *d), (void)a; (void)b; (void)c; (void)d;)
FAKE(TexImage2D, (U a, I b, I c, I d, I e, I f, U g, U h, const void *i), (void)a; (void)b; (void)c; (void)d; (void)e;
     (void)f; (void)g; (void)h; (void)i;)
FAKE(TexImage3D, (U a, I b, I c, I d, I e, I f, I g, U h, U i, const void *j), (void)a; (void)b; (void)c; (void)d;
     (void)e; (void)f; (void)g; (void)h; (void)i; (void)j;)
FAKE(TexParameteri, (U a, U b, I c), (void)a; (void)b; (void)c;)
FAKE(TexSubImage2D, (U a, I b, I c, I d, I e, I f, U g, U h, const void *i), (void)a; (void)b; (void)c; (void)d;
     (void)e; (void)f; (void)g; (void)h; (void)i;)
FAKE(Uniform1i, (I a, I b), (void)a; (void)b;)
FAKE(Uniform1ui, (I a, U b), (void)a; (void)b;)
FAKE(Uniform2i, (I a, I b, I c), (void)a; (void)b; (void)c;)
FAKE(Uniform2f, (I a, float b, float c), (void)a; (void)b; (void)c;)
FAKE(Uniform3f, (I a, float b, float c, float d), (void)a; (void)b; (void)c; (void)d;)
FAKE(Uniform4fv, (I a, I b, const float *c), (void)a; (void)b; (void)c;)
FAKE(Uniform4ui, (I a, U b, U c, U d, U e), (void)a; (void)b; (void)c; (void)d; (void)e;)
FAKE(UniformBlockBinding, (U a, U b, U c), (void)a; (void)b; (void)c;)
FAKE(UniformMatrix3fv, (I a, I b, B c, const float *d), (void)a; (void)b; (void)c; (void)d;)
FAKE(UniformMatrix4fv, (I a, I b, B c, const float *d), (void)a; (void)b; (void)c; (void)d;)
FAKE(UseProgram, (U a), driver.program = a;)
FAKE(Viewport, (I a, I b, I c, I d), (void)a; (void)b; (void)c; (void)d;)

static void fake_GetIntegerv(U what, I *out) {
    note("GetIntegerv");
    if (lost())
        return;
    *out = 0;
    switch (what) {
    case 0x0BA2u:
        out[1] = out[2] = out[3] = 7;
        break; /* viewport */
    case 0x0B40u:
        out[0] = 0x1B02;
        break; /* polygon mode */
    case 0x0D33u:
        *out = driver.max_texture_size;
        break;
    case 0x0D3Au: /* viewport dims */
        out[0] = out[1] = 32768;
        break;
    case 0x8B4Du:
        *out = 32;
        break; /* texture units */
    case 0x8A2Fu:
        *out = 36;
        break; /* uniform bindings */
    case 0x8824u:
        *out = 8;
        break; /* draw buffers */
    case 0x0D32u:
        *out = 8;
        break; /* clip distances */
    case 0x8825u:
        *out = (I)driver.color_buffer;
        break;
    case 0x80A9u:
        *out = driver.samples;
        break;
    case 0x84E0u:
        *out = 0x84C0 + driver.active_unit;
        break;
    case 0x8069u: /* GL_TEXTURE_BINDING_2D */
        *out = (I)driver.unit_textures[driver.active_unit & 31];
        break;
    case 0x8B8Du:
        *out = (I)driver.program;
        break;
    case 0x8CA6u:
        *out = (I)driver.bound_framebuffer;
        break;
    default:
        break;
    }
}

static U fake_CheckFramebufferStatus(U a) {
    note("CheckFramebufferStatus");
    (void)a;
    if (lost())
        return 0;
    return ++driver.framebuffer_checks == driver.fail_framebuffer ? 0x8CD6u : 0x8CD5u;
}

static U fake_CreateProgram(void) {
    U name;
    note("CreateProgram");
    if (lost())
        return 0;
    generate(PROGRAMS, 1, &name);
    return name;
}

static U fake_CreateShader(U a) {
    U name;
    note("CreateShader");
    (void)a;
    if (lost())
        return 0;
    generate(SHADERS, 1, &name);
    return name;
}

static const B *fake_GetString(U a) {
    note("GetString");
    (void)a;
    return lost() ? NULL : (const B *)driver.version;
}

static U fake_GetUniformBlockIndex(U a, const char *b) {
    note("GetUniformBlockIndex");
    (void)a, (void)b;
    return lost() ? 0xFFFFFFFFu : 0;
}

static I fake_GetUniformLocation(U a, const char *b) {
    note("GetUniformLocation");
    (void)a, (void)b;
    return lost() ? -1 : 1;
}

static B fake_IsEnabled(U a) {
    note("IsEnabled");
    (void)a;
    return 0;
}

static B fake_IsEnabledi(U a, U b) {
    note("IsEnabledi");
    (void)a, (void)b;
    return 0;
}

static B fake_IsTexture(U a) {
    note("IsTexture");
    return a != driver.refused_texture && !lost();
}

static B fake_IsProgram(U a) {
    note("IsProgram");
    return a != 0 && !lost();
}

static void *fake_FenceSync(U a, U b) {
    note("FenceSync");
    (void)a, (void)b;
    if (lost())
        return NULL;
    ++driver.live[FENCES];
    return &driver;
}

/* Whoever gives it time wants to wait. */
static U fake_ClientWaitSync(void *a, U b, uint64_t c) {
    note("ClientWaitSync");
    (void)a, (void)b;
    assert_true(c == 0);
    return driver.signalled ? 0x911Au : 0x911Bu;
}

static void *fake_MapBufferRange(U a, ptrdiff_t b, ptrdiff_t c, U d) {
    note("MapBufferRange");
    (void)a, (void)b, (void)c, (void)d;
    assert_true(driver.signalled); /* or the driver would wait */
    return lost() ? NULL : driver.mapped;
}

static B fake_UnmapBuffer(U a) {
    note("UnmapBuffer");
    (void)a;
    return 1;
}

static tr_proc get_proc(const char *name) {
#define GIVE(type, function, parameters)                                                                               \
    if (strcmp(name, "gl" #function) == 0)                                                                             \
        return driver.missing && strcmp(driver.missing, name) == 0 ? NULL : (tr_proc)fake_##function;
    TR_I_GL_REQUIRED(GIVE)
    TR_I_GL_DESKTOP(GIVE)
    TR_I_GL_INDEXED(GIVE)
    TR_I_GL_INDEXED_BLEND(GIVE)
    TR_I_GL_VIEWPORTS(GIVE)
    TR_I_GL_ES(GIVE)
    TR_I_GL_QUERY(GIVE)
#undef GIVE
    return NULL;
}

/* ---- helpers ---- */

static int blocks, blocks_left;

static void *count_alloc(size_t size, void *user) {
    (void)user;
    if (blocks_left == 0)
        return NULL;
    --blocks_left;
    ++blocks;
    return malloc(size);
}

static void count_free(void *block, void *user) {
    (void)user;
    blocks -= block != NULL;
    free(block);
}

static void keep_text(tr_log_level level, tr_result code, const char *text, void *user) {
    (void)level, (void)code, (void)user;
    snprintf(driver.text + strlen(driver.text), sizeof driver.text - strlen(driver.text), "%s\n", text);
}

static tr_desc make_desc(tr_state_policy policy) {
    tr_desc desc = {0};
    desc.get_proc = get_proc;
    desc.alloc_fn = count_alloc;
    desc.free_fn = count_free;
    desc.log_fn = keep_text;
    desc.state = policy;
    blocks = 0;
    blocks_left = 1000;
    return desc;
}

static void assert_nothing_left(void) {
    for (int i = 0; i < 7; ++i)
        assert_int_equal(driver.live[i], 0);
    assert_int_equal(blocks, 0);
}

#endif
