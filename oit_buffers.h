/* oit_buffers.h - v0.3.0 - every fragment of every pixel: exact order-independent transparency - MIT licence, at the end

   DOES
   - keeps every fragment of every pixel in a buffer on the GPU, sorts each pixel's fragments and composes them front to
     back over what the host has drawn: exact transparency for any number of layers, without sorting a triangle
   - gives the same bits in whatever order things are drawn, and every time: fragments are ordered by depth, then by part
     and key where those are chosen, then by all else that they carry
   - loses nothing: with OIT_FIT_WAIT the buffer is made to fit, and over its ceiling the picture is drawn in bands. With
     OIT_FIT_ASYNC it never waits for the GPU: pixels that do not fit for a frame are composed from sums that do not
     depend on the order either, are counted, and fit in the frames after
   - or, with OIT_STORE_BUDGET, takes no more memory than it is given and never waits: the k nearest fragments of each
     pixel, chosen by set and not by arrival, and sums of the others behind them; what was lost is counted.
     OIT_STORE_BUCKETED also groups them by part (Murray, Baril, Granier 2016)
   - blends by fragment: over, additive, multiply; with each fragment's own alpha, or so that all layers of a pixel hide
     together what one would, however many they are
   - draws into multisampled targets: order by pixel, coverage and the host's opaque depth by sample
   - tells which fragment lies at a pixel and a layer, and writes one depth for all of them, for passes that come after
   - knows each fragment's neighbours along its surface, and draws from that silhouettes strengthened, halos before what
     lies behind (Carnecky et al. 2013) and opacity and shade by curvature (Murray et al. 2016); and runs the host's own
     operators on all fragments
   - works with the host's own shaders through one function call, and has shaders for hosts that have none
   - leaves the GL state as found, or tells the host which state each pass wants

   DOES NOT
   - create a context, or run where there are no compute shaders: macOS and WebGL 2 stay with transparency.h

   QUICK START, given a current context and its getter of function pointers

    --8<-- quick start
    #define OIT_BUFFERS_IMPLEMENTATION
    #include "oit_buffers.h"
    #include <string.h>

    extern oit_proc get_proc(const char *name);                      // eglGetProcAddress, glfwGetProcAddress, ...
    extern void draw_my_mesh(int index);                             // binds a vertex array, calls glDrawElements
    extern void my_matrices(int index, float mvp[16], float normal_matrix[9]);

    oit_context *start(void) {
        oit_desc desc = {0};
        desc.get_proc = get_proc;
        return oit_create(&desc, 0);
    }

    oit_result draw_glass(oit_context *oit, int width, int height) { // over what the default framebuffer holds
        oit_frame frame = {0};
        oit_pass pass;
        oit_result result;
        int i;
        frame.width = width;
        frame.height = height;
        frame.light[1] = frame.light[2] = 1.0f;
        result = oit_begin(oit, &frame);
        if (result != OIT_OK) return result;
        while (oit_next_pass(oit, &pass))
            for (i = 0; i < 2; ++i) {
                oit_material material;
                memset(&material, 0, sizeof material);
                my_matrices(i, material.model_view_projection, material.normal_matrix);
                material.color[0] = material.color[1] = material.color[2] = 0.7f;
                material.color[3] = 0.5f;
                oit_set_material(oit, &pass, &material);
                draw_my_mesh(i);
            }
        oit_compose(oit);
        return oit_end(oit);
    }
    -->8--

   BUILD
   Define OIT_BUFFERS_IMPLEMENTATION in one C (C99) or C++ (C++11) file before including this header; include it anywhere
   else without. Link nothing but your GL loader; oit_* functions call GL through the table that desc.get_proc fills. On
   Windows wglGetProcAddress does not know the functions of GL 1.1: give a getter that asks opengl32.dll as well.

   OPTIONS, defined before the implementation unless said otherwise
   - OIT_STATIC            every function static; define it wherever the header is included
   - OIT_GL_STATIC         take the gl* names that are visible (glad, GLEW, epoxy, GLES3/gl31.h: include it first) instead
                           of desc.get_proc
   - OIT_MALLOC, OIT_FREE  used when the desc brings no allocator; default malloc and free

   GL FLOOR
   OpenGL 4.3 core or OpenGL ES 3.1, and of the limits at least (ES 3.1 lets a driver have no storage block in the
   fragment stage, so the version alone does not tell):
   - GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS 2: the pixels and the fragments; with operators 3
   - GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS 4 and GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS 128, for the prefix sum
   - GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES 4: those two blocks and colour outputs
   - GL_MAX_SHADER_STORAGE_BLOCK_SIZE 2^24 bytes
   A function pointer that is not null proves nothing (drivers hand out stubs): versions and extensions decide, and then
   the functions must be there as well. A refusal says what is missing and what was found.

   GL STATE CONTRACT
   oit_create only asks: no state is changed and no object is made. Between oit_begin and oit_end the header owns the state
   of the context; the host draws its transparent objects with what each pass has set. The target's own depth, written
   before by the host, hides fragments; it is tested, and written only where oit_frame.depth asks for it. Culling is off,
   because both sides of a surface are layers: a host that wants otherwise switches it on after oit_next_pass. desc.state
   says what happens around that:
   - OIT_STATE_RESTORE         all that a frame changed is as it was after oit_end (the list is oit_i_snapshot)
   - OIT_STATE_LEAVE_DEFAULTS  that state has the values of a fresh context, framebuffer 0
   - OIT_STATE_LEAVE_DIRTY     it is whatever the last pass needed
   - OIT_STATE_NONE            no state call is made between oit_begin and oit_end, but for memory barriers and the fence:
                               pass.state holds what the host sets, and the passes that are not the host's (those with
                               groups or a vertex_count) come to it as well. It needs OIT_FIT_ASYNC
   Not touched, and expected to be at rest: conditional rendering, transform feedback. GL_FRAMEBUFFER_SRGB is the host's
   choice: on, with an sRGB target, colours are taken for light. The alpha channel of the target is not written, and of
   several draw buffers only the first; ES before 3.2 has no mask by buffer: give it a framebuffer with one. glGetError is
   never called. Where memory runs out, GL_OUT_OF_MEMORY is left for the host to find, and where OIT_STORE_FETCH refuses a
   depth that is a layer of an array, GL's error; the header itself goes by the size that the buffer has.

   ERRORS, MEMORY, THREADS
   Every function that can fail returns an oit_result and logs through desc.log_fn. Where something fails between oit_begin
   and oit_end, oit_next_pass returns 0 and oit_compose and oit_end return the reason; oit_end restores the state even so,
   and the next frame may be tried. One heap block a context, and one more for the time that a shader is made. On the GPU:
   8 bytes a pixel (24 with OIT_FIT_ASYNC; 4 more with OIT_FIELD_COVERAGE), and oit_get_info().fragment_bytes a fragment,
   a quarter more of them than the last frame needed. With OIT_STORE_BUDGET and OIT_STORE_BUCKETED 40 bytes a pixel and
   desc.budget_bytes. One context of ours for one GL context, used from the thread that has it current.

   STORES, desc.store
   They differ in geometry passes, memory and what happens when there is too much; the layers of a pixel come in the same
   order in all, and what fits looks the same, to the bit.
   - OIT_STORE_EXACT    two geometry passes: counted, then filled
   - OIT_STORE_PREDICT  one, into runs as long as the pixel or one of its eight neighbours needed in the frame before, and
                        desc.headroom. What the guess does not hold is filled again with OIT_FIT_WAIT (two passes more), and
                        with OIT_FIT_ASYNC composed from the tail, alone the pixels that it concerns. The first frame, a new
                        size and oit_frame.cut are counted first. Where an image takes several slabs, or runs of guessed
                        lengths do not fit below the ceiling and nothing may be lost, every frame is.
                        12 bytes a pixel (36 with OIT_FIT_ASYNC)
   - OIT_STORE_LINKED   one, into a list a pixel, as published (Carnecky 2013, 4.1 to 4.3), each then copied into a run: two
                        records for each fragment, and all fragments share one counter. A list that is too small is filled
                        again with OIT_FIT_WAIT; with OIT_FIT_ASYNC the whole picture is composed from the tail for that
                        frame, because which records found place depends on the order in which they came. Where the report
                        of a frame before says that not all will fit, the frame is counted first, and only the pixels that
                        do not fit are lost. 12 bytes a pixel (36 with OIT_FIT_ASYNC)
   - OIT_STORE_FETCH    seven layers a geometry pass (three where there are less than eight draw buffers) in attachments, by
                        GL_EXT_shader_framebuffer_fetch; as many passes as the deepest pixel needs: known by one read-back
                        after the first, or with OIT_FIT_ASYNC from the last report, and then layers beyond those are left
                        out, farthest first, and counted as lost. No fragment is stored: 52 bytes a pixel and 120 a pixel of
                        targets, however many layers; no picking and no depth of the composite. 16 bytes a fragment at most
                        (OIT_COLOR_8 or OIT_COLOR_HALF and one word more), no coverage, not with OIT_STATE_NONE. The
                        target's depth must be a renderbuffer or a 2D texture, not that of the default framebuffer
   - OIT_STORE_BUDGET   two, within desc.budget_bytes: first the depth up to which the k nearest of a pixel reach, then those
                        stored and the others summed up behind them. Neither wait nor growth, whatever the fit; about as
                        fast as OIT_STORE_EXACT, faster for deep pixels and small k
   - OIT_STORE_BUCKETED the same, and the fragments of a pixel grouped by OIT_FIELD_PART

   RECIPES
   - Your own shaders: prepend the strings of oit_glsl() to a vertex and a fragment shader (which then begins without
     #version; #extension lines go between the first string and the second) and call, in the fragment main,
     oit_store(color), or fill an oit_fragment (color; part, key, blend, normal, uv, words where chosen) and call
     oit_store(fragment). One program with OIT_PASS_COUNT, one with OIT_PASS_FILL. Both must cover the same fragments: the
     same gl_Position (it is invariant) and the same discards. The depth test comes before the shader: gl_FragDepth has
     no effect. Bindings are in the text, nothing has to be set. The program must have no other colour output.
   - Particles and tinted glass: OIT_FIELD_BLEND, and fragment.blend = OIT_BLEND_ADD or OIT_BLEND_MULTIPLY.
   - A stable order where surfaces coincide: OIT_FIELD_PART with the object's number.
   - What a frame needed: oit_get_report. In games look at lost_pixels now and then.
   - A fixed price whatever is drawn: OIT_STORE_BUDGET; desc.layers bounds k where the budget would give more. With
     OIT_STORE_BUCKETED and 16 bits of depth the count pass chooses by part as well: set fragment.part there too.
   - What is under the cursor: oit_pick_begin(oit, x, y, layer) at any time, and oit_pick_result(oit, 0, &pick) in the
     frames after until it is not OIT_NOT_READY; that never waits. In a tool: draw the frame, then wait with 1.
   - Fog, depth of field, temporal anti-aliasing after glass: frame.depth = OIT_DEPTH_MEDIAN, and frame.depth_framebuffer
     the target itself, or a framebuffer with a copy of the opaque depth.
   - Surfaces with many layers that must not turn into a wall: desc.alpha_law = OIT_ALPHA_ADAPTIVE.

   MULTISAMPLED TARGETS
   With OIT_FIELD_COVERAGE, of 2 to OIT_MAX_SAMPLES samples. A fragment is stored once a pixel with the samples that it
   covers and that the host's depth leaves of them; its place in the order is its depth at the middle of those. Where all
   fragments of a pixel cover all of it, it is composed once, else once a sample (each inner edge of a mesh is such an
   edge). Surfaces that cross within a pixel are in one order there. desc.sample_order stores each sample by itself
   instead: order and depth by sample, for as many times the fragments. It is also what is done where the driver does not
   tell which samples the depth test leaves (GL_ARB_post_depth_coverage, GL_EXT_post_depth_coverage in ES). ES needs
   GL_OES_sample_variables; oit_create says so. There is no OIT_STATE_NONE for it. In ES, call oit_store where control
   flow is uniform: it takes derivatives of the depth. The depth of the composite is one a pixel, in which a fragment
   hides by the share of samples that it covers, as it does in the tail.

   OPERATORS, desc.operators and oit_run
   Silhouettes that show through glass, in a frame whose frame.projection is set:

       desc.operators = OIT_OPERATE_SMART;                          // at creation
       ...
       while (oit_next_pass(oit, &pass)) draw();
       memset(&op, 0, sizeof op);
       op.kind = OIT_RUN_LINK;  op.link.radius = 3.5f;              // of the scene's bounding sphere
       oit_run(oit, &op);
       op.kind = OIT_RUN_LAW;   op.law.kind = OIT_LAW_ADAPTIVE;     // optional; else alpha as it was stored
       oit_run(oit, &op);
       op.kind = OIT_RUN_SMART; op.smart.jumps = 1;
       oit_run(oit, &op);
       oit_compose(oit);

   Shaders store normals in the space of the eye (fragment.normal), and the number of a connected surface (fragment.part):
   fragments of two parts are never neighbours. Slopes of the depth are stored by oit_store itself; in ES call it where
   control flow is uniform. Ribbons of feature lines go into the same buffer with OIT_BLEND_LINE (and OIT_FIELD_BLEND).
   Operators need all of the image at once: in bands or slabs oit_run is refused, and the frame is composed without it.
   Pixels whose run did not fit (OIT_FIT_ASYNC) have no fragments for them. The depth of the composite and picking go by
   alpha as it was stored. Not with OIT_STORE_FETCH, OIT_FIELD_COVERAGE or desc.alpha_law.
   JUMPS. Beta and gamma by equation 9 depend on the number of steps to the nearest source alone, which is what is kept: 16
   bits each, exact. Iterated, each pass is one step. With smart.jumps a pass carries distances 32 pixels along rows, the
   next along columns, and so on: never below the true distance, so never above the iterated field; each bend of a path
   costs a round. smart.until_stable asks for as many rounds as iterations, of which those after the last change end at
   once. Base is made smooth by the weights of several steps along rows, then columns, and so on: n + 1 passes for 7 n
   iterations, where links are mutual; without the reverse check, or with OIT_LINK_PUBLISHED, it is iterated.
   smart.thin is against silhouettes so dense that nothing but them is seen: a field ends within that share of the distance
   between the boundary conditions on either side along the row, or along the column if that is less.

   OPERATORS OF THE HOST'S
   A compute shader of the strings of oit_operator_glsl() and a text that defines void oit_operate(uint p), which is called
   once for each pixel p of the viewport (row by row from the bottom). A fragment is known by its slot:

       uint oit_list(uint p, out uint first)        how many the pixel has; slots first, first + 1, ... from the eye on
       float oit_depth(slot)  vec4 oit_color(slot)  bool oit_is_surface(slot)      window depth; color as stored
       vec3 oit_normal(slot)  uint oit_part_of(slot)  vec2 oit_uv(slot)  vec2 oit_slope(slot)      where stored
       uint oit_neighbour(p, slot, direction)       a slot, or OIT_NONE; OIT_LEFTWARD, _RIGHTWARD, _DOWNWARD, _UPWARD
       bool oit_beside(p, direction, out uint q)    the pixel there; false where the image ends
       float oit_value(which, slot)                 OIT_BASE, OIT_BETA, OIT_GAMMA (before profiles), OIT_KAPPA, OIT_HOST + k
       void oit_set_value(which, slot, x)           OIT_BASE, OIT_HOST + k, of the own pixel
       float oit_before(slot)  void oit_set_after(slot, x)      with host.iterations; set it for every fragment
       vec3 oit_position(oit_device(p), depth)  vec3 oit_to_eye(oit_device(p))     in the space of the eye
       OIT_STEP.x                                   which iteration

   Uniforms of the host's own may have locations from 128 on, or none given. Storage bindings of ours are the three from
   desc.first_storage_binding on; the last is the buffer of all values. Ours are written with the same functions.

   LIMITS AND PRECISION
   - Depths are gl_FragCoord.z in 32 bits: layers are told apart down to one unit in the last place.
   - A fragment at the very depth of the host's opaque surface is hidden.
   - Colours: see oit_color. Into a target of 8 bits the picture is within 1.5/255 of the exact one (drivers may round
     when they blend it over the background: 1.05/255 measured), into one of floats within 10^-5 with OIT_COLOR_FLOAT.
     Infinities and NaN in a colour become 0, alpha is cut to [0,1].
   - The tail takes colours up to 4, takes all layers of a pixel as evenly mixed, and is exact where they have one colour.
   - Of the k nearest: where fragments tie for the last places of a pixel, those of that depth go to the tail together, be
     their parts and keys what they may. A tail holds 65,535 fragments, to 2^-26 of optical depth each; k is at most 1,024.
   - Mesa's software driver ends a shader's loops after 65,535 rounds: pixels of more than about 1,400 fragments lose some
     there.
   - Image size: what GL_MAX_VIEWPORT_DIMS and storage blocks of one row allow; what one block does not hold is drawn in
     slabs. A viewport of no area is no error; its corner is in -32,768 ... 32,767. All fragments of an image (of a slab)
     are less than 2^32: OIT_FIT_WAIT refuses more, OIT_FIT_ASYNC shows what is beyond as nothing. A pixel's are less than
     2^30. Numbers of a report that count over all slabs wrap at 2^32.
*/
#ifndef OIT_BUFFERS_H
#define OIT_BUFFERS_H

#include <stddef.h>
#include <stdint.h>

#define OIT_VERSION 300 /* major * 10000 + minor * 100 + patch */

/* How the functions are declared; not for users. A file need not use all that are static in it. */
#if !defined(OIT_STATIC)
#define OIT_DEF extern
#elif defined(__GNUC__) || defined(__clang__) || defined(__TINYC__)
#define OIT_DEF static __attribute__((unused))
#else
#define OIT_DEF static
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What went wrong. oit_result_string gives the sentence. */
#define OIT_RESULTS(X)                                                                                                 \
    X(OIT_OK, "no error")                                                                                              \
    X(OIT_INVALID_ARGUMENT, "an argument is missing or out of range")                                                  \
    X(OIT_OUT_OF_MEMORY, "out of memory")                                                                              \
    X(OIT_GL_TOO_OLD, "the context is older than OpenGL 4.3 or OpenGL ES 3.1")                                         \
    X(OIT_MISSING_FUNCTION, "a GL function that is needed was not found")                                              \
    X(OIT_LIMIT_TOO_SMALL, "a limit of the context is too small for fragment buffers")                                 \
    X(OIT_SHADER_FAILED, "a shader did not compile or link")                                                           \
    X(OIT_TARGET_INCOMPLETE, "the target framebuffer is not complete")                                                 \
    X(OIT_TARGET_MULTISAMPLED, "the target is multisampled, and coverage is not stored or holds fewer samples")        \
    X(OIT_TOO_LARGE, "the viewport is larger than the context's buffers or viewports can be")                          \
    X(OIT_PIXEL_TOO_DEEP, "one pixel alone has more fragments than the ceiling holds")                                 \
    X(OIT_WRONG_ORDER, "a function of a frame was called outside of it, or before its passes were done")               \
    X(OIT_NOT_READY, "the GPU has not come as far yet; ask again")                                                     \
    X(OIT_NO_FETCH, "the context has no EXT_shader_framebuffer_fetch, or the target's depth cannot be shared with it")

typedef enum oit_result {
#define OIT_I_ENUM(name, text) name,
    OIT_RESULTS(OIT_I_ENUM)
#undef OIT_I_ENUM
        OIT_RESULT_COUNT
} oit_result;

typedef enum oit_log_level { OIT_LOG_ERROR, OIT_LOG_WARNING, OIT_LOG_INFO } oit_log_level;

typedef void (*oit_proc)(void);

typedef enum oit_state_policy {
    OIT_STATE_RESTORE,
    OIT_STATE_LEAVE_DEFAULTS,
    OIT_STATE_LEAVE_DIRTY,
    OIT_STATE_NONE /* goes with OIT_FIT_ASYNC */
} oit_state_policy;

/* How the fragment pool comes to be large enough. */
typedef enum oit_fit {
    OIT_FIT_WAIT, /* one read-back of 64 bytes between count and fill; over the ceiling in bands: nothing is ever lost */
    OIT_FIT_ASYNC /* never waits: what does not fit this frame is composed from the tail, and the pool grows for the next */
} oit_fit;

/* How fragments come to lie in the pool. All compose the same layers in the same order. */
typedef enum oit_store_kind {
    OIT_STORE_EXACT,   /* counted, then filled: two geometry passes, runs that fit exactly */
    OIT_STORE_PREDICT, /* one geometry pass: runs as long as the frame before suggests */
    /* Two geometry passes: the first finds the depth up to which k fragments of a pixel fit in budget_bytes, the second
       stores those before it and sums up the others. No read-back between them and no growth, whatever the fit. */
    OIT_STORE_BUDGET,
    OIT_STORE_LINKED,   /* one geometry pass into lists, as published, each copied into a run */
    OIT_STORE_BUCKETED, /* as BUDGET; and the fragments of each pixel grouped by OIT_FIELD_PART, for neighbours */
    OIT_STORE_FETCH     /* seven layers a geometry pass by framebuffer fetch; see STORES */
} oit_store_kind;

/* How a fragment's colour is kept. Bytes are those of a fragment with nothing else chosen; sizes go in steps of 8. */
typedef enum oit_color {
    OIT_COLOR_8, /* for targets of 8 bits: rgb in 10 bits each, alpha as a 32-bit float; 16 bytes, of which 4 are free */
    OIT_COLOR_HALF, /* rgb and alpha as 16-bit floats, for brightnesses above 1; 16 bytes, of which 4 are free */
    OIT_COLOR_FLOAT /* rgb and alpha as 32-bit floats; 24 bytes, of which 4 are free */
} oit_color;

/* What a fragment carries beside depth and colour, 4 bytes each but for OIT_FIELD_UV's 8; OIT_FIELD_BLEND is free with
   OIT_COLOR_8. What is not chosen costs nothing. */
enum {
    OIT_FIELD_PART = 1,     /* uint: orders fragments of the same depth, before all else */
    OIT_FIELD_KEY = 2,      /* uint: orders fragments of the same depth and part */
    OIT_FIELD_BLEND = 4,    /* over, add or multiply by fragment */
    OIT_FIELD_NORMAL = 8,   /* a direction in 2 x 16 bits */
    OIT_FIELD_UV = 16,      /* two floats */
    OIT_FIELD_COVERAGE = 32 /* which samples are covered: for multisampled targets; 4 bytes a pixel, too */
};
#define OIT_FIELD_ALL 63u

/* What alpha a fragment is composed with. */
typedef enum oit_alpha_law {
    OIT_ALPHA_CONSTANT, /* its own */
    OIT_ALPHA_ADAPTIVE /* 1 - (1 - its own)^(1/n), n the layers of the pixel: n layers of alpha s hide together what one
                           would (Carnecky 2013, equation 5). Not layers: what is added or multiplied, what is opaque and
                           what lies behind that, all of which keep their alpha. Takes the run once more through memory */
} oit_alpha_law;

#define OIT_MAX_SAMPLES 8
#define OIT_MAX_HOST_WORDS 8

typedef struct oit_desc {
    oit_proc (*get_proc)(const char *name);     /* required, except with OIT_GL_STATIC */
    void *(*alloc_fn)(size_t size, void *user); /* both or neither */
    void (*free_fn)(void *block, void *user);
    void *alloc_user;
    void (*log_fn)(oit_log_level level, oit_result code, const char *text, void *user); /* optional */
    void *log_user;
    int max_gl_version; /* 0: what the context has; 430: use nothing newer than 4.3 (for tests of fall-backs) */
    oit_state_policy state;
    oit_fit fit;
    oit_color color;
    uint32_t fields;   /* OIT_FIELD_* */
    int host_words;    /* words of the host's own in each fragment, at most OIT_MAX_HOST_WORDS */
    int premultiplied; /* 1: the rgb that shaders give is multiplied by alpha already */
    int reversed_z;    /* 1: near is 1, far is 0 */
    int64_t
        ceiling_bytes; /* most that the fragment pool may take, no more than a storage block holds; OIT_STORE_FETCH: most
                              that its targets may take; 0: 512 MiB */
    int64_t max_block_bytes;   /* 0: what the context has; else storage blocks are taken to hold no more (for tests) */
    int first_storage_binding; /* three shader storage binding points from here on are ours */
    int uniform_binding;       /* uniform buffer binding point that is ours; 0: 14 */
    oit_store_kind store;
    /* BUDGET, BUCKETED: for the fragments of the image; 0: 256 MiB, or what a storage block holds. A fragment takes 4 bytes
       more than fragment_bytes, with BUCKETED 12 more; k is what that gives for each pixel, at most 1,024. What a block does
       not hold is drawn in slabs. */
    int64_t budget_bytes;
    int layers;            /* BUDGET, BUCKETED: keep no more of a pixel; 0: as many as the budget has room for */
    int bucket_depth_bits; /* BUCKETED: choose the nearest by so many bits of the depth, 16 (then by part, as published) or 32;
                              0: 32. They are composed by all bits in either case */
    int sample_order; /* 1, with OIT_FIELD_COVERAGE: each sample is a fragment of its own; see MULTISAMPLED TARGETS */
    int headroom; /* OIT_STORE_PREDICT: places that a pixel gets beyond those that it or a neighbour needed in the frame
                     before, in sixteenths, rounded up; at most 64; 0: default 2; negative: none */
    oit_alpha_law alpha_law; /* ADAPTIVE counts layers: with EXACT, and with PREDICT or LINKED where they wait */
    uint32_t operators;      /* OIT_OPERATE_*: what oit_run may be asked for; see OPERATORS */
    int operator_fields;     /* numbers of the host's own for each fragment, kept between its operators; 4 bytes each */
} oit_desc;

typedef struct oit_info {
    int es;                      /* 1: OpenGL ES */
    int version;                 /* 430 for 4.3; after desc.max_gl_version */
    int fragment_storage_blocks; /* that a fragment shader may use */
    int compute_storage_blocks;  /* that a compute shader may use */
    int combined_outputs;        /* storage blocks, images and colour outputs of a fragment shader, together */
    int compute_invocations;     /* in one work group */
    int image_atomics;           /* 1: imageAtomicAdd and the like; always on desktop GL */
    int64_t storage_block_bytes; /* the most that one storage block may hold */
    int fragment_bytes;          /* of one stored fragment */
    uint64_t bytes;              /* of GL buffers held now */
} oit_info;

/* What the last frame that the GPU has finished was like. */
typedef struct oit_report {
    uint64_t frame;       /* 1 is the first oit_begin; 0: none is finished yet */
    uint32_t needed;      /* fragments of the image (of its largest slab, where it needs several) */
    uint32_t deepest;     /* fragments of the deepest pixel */
    uint32_t lost_pixels; /* composed from the tail; BUDGET, BUCKETED: that have a tail behind what is kept */
    uint32_t lost;        /* fragments of those; BUDGET, BUCKETED: that are in the tail */
    uint32_t extra;       /* fragments that the fill pass met and the count pass had not: not stored */
    uint32_t capacity;    /* fragments that the pool held in that frame */
    uint32_t bands;       /* fill passes; with PREDICT and LINKED also where a frame was filled again */
    uint32_t layers;      /* BUDGET, BUCKETED: k, the most that was kept of a pixel */
} oit_report;

/* ---- a frame ---------------------------------------------------------------------------------------------------- */

/* Which depth stands for all that was composed, for passes that come after and know one depth a pixel: fog, depth of
   field, temporal filters. It is a window depth, that of the fragment with which the transmittance, from the eye on, falls
   below a limit; written to the depth attachment of frame.depth_framebuffer, whatever is there (no depth test), or as a
   colour. Where no fragment qualifies, and where the run of a pixel did not fit, nothing is written: what the host has put
   there stays. So give the target itself, or a framebuffer into which the opaque depth was copied. Of a filter
   (OIT_BLEND_MULTIPLY) the channel counts that lets most through. */
typedef enum oit_depth {
    OIT_DEPTH_NONE,
    OIT_DEPTH_FIRST,    /* the nearest fragment, however transparent */
    OIT_DEPTH_MEDIAN,   /* below one half */
    OIT_DEPTH_THRESHOLD /* below frame.depth_threshold */
} oit_depth;

typedef struct oit_frame {
    uint32_t framebuffer; /* target; its depth, if it has any, hides fragments; its first draw buffer is drawn into */
    int x, y, width, height; /* viewport within the target, pixels */
    float background_weight; /* of the target's own content, in [0,1]; 0: default 1; negative: 0 */
    float light[3]; /* built-in surfaces: toward the light, any length, in the space of the normals; zero: not shaded */
    oit_depth depth;            /* of the composite; OIT_DEPTH_NONE costs nothing */
    float depth_threshold;      /* OIT_DEPTH_THRESHOLD: in ]0,1] */
    uint32_t depth_framebuffer; /* takes the depth, at the same viewport; see oit_depth */
    int depth_to_color;         /* 1: in its first draw buffer instead, which is of floats (R32F) */
    int cut;              /* 1: the picture has nothing to do with the one before; OIT_STORE_PREDICT counts first */
    float projection[16]; /* column-major, of the transparent objects; needed by oit_run alone */
    int zero_to_one; /* 1: it makes depths in [0,1], as for glClipControl(..., GL_ZERO_TO_ONE); needed by oit_run alone */
} oit_frame;

typedef enum oit_pass_kind {
    OIT_PASS_CLEAR,
    OIT_PASS_COUNT, /* the host draws its transparent objects */
    OIT_PASS_SUM,
    OIT_PASS_TOPS,
    OIT_PASS_SPREAD,
    OIT_PASS_REPORT,
    OIT_PASS_FILL, /* the host draws them again */
    OIT_PASS_COMPOSE,
    OIT_PASS_KEEP,    /* BUDGET, BUCKETED: what is kept of each pixel */
    OIT_PASS_ARRANGE, /* BUCKETED: its fragments by part */
    OIT_PASS_PICK,    /* where oit_pick_begin has asked for it */
    OIT_PASS_DEPTH,   /* with oit_frame.depth */
    OIT_PASS_PREDICT, /* PREDICT: how long runs shall be */
    OIT_PASS_SETTLE,  /* PREDICT: how many fragments came, and where they were too many */
    OIT_PASS_GATHER,  /* LINKED: lists copied into runs */
    OIT_PASS_LAY,     /* FETCH: the layers of a pass behind those before */
    OIT_PASS_OPERATE, /* of oit_run */
    OIT_PASS_KIND_COUNT
} oit_pass_kind;

/* The state that a pass wants, as data; GL enumerants by their numbers. Under OIT_STATE_NONE the host applies it. */
typedef struct oit_state {
    uint32_t framebuffer;
    int viewport[4], scissor[4]; /* the scissor test is on */
    uint32_t program;            /* built-in; the host's own stands in for it where the host draws */
    uint32_t groups[3];          /* not 0: glDispatchCompute, nothing is drawn */
    uint32_t vertex_array;       /* with vertex_count */
    int vertex_count;            /* 3: glDrawArrays(GL_TRIANGLES, 0, 3); 0: the host draws its objects, or dispatches */
    uint32_t storage_buffers[3]; /* bound to first_storage_binding + i */
    int first_storage_binding;
    uint32_t uniform_buffer; /* bound to uniform_binding */
    int uniform_binding;
    int depth_test;
    uint32_t depth_func;
    int color_write;                          /* rgb of the first draw buffer; alpha and others are never written */
    int blend;                                /* equation: add */
    uint32_t blend_source, blend_destination; /* of rgb */
    int depth_write;                          /* only OIT_PASS_DEPTH, whose test always passes */
} oit_state;

typedef struct oit_pass {
    oit_pass_kind kind;
    const char *name;
    uint32_t barriers; /* what oit_next_pass gave glMemoryBarrier before this pass */
    oit_state state;
} oit_pass;

typedef struct oit_context oit_context;

/* Needs a current context. Returns NULL and the reason (result may be NULL) on failure; nothing is left behind. */
OIT_DEF oit_context *oit_create(const oit_desc *desc, oit_result *result);
/* With the GL context current; NULL is fine. Inside of a frame it leaves GL state as the last pass set it. */
OIT_DEF void oit_destroy(oit_context *oit);
/* All zeros for NULL. */
OIT_DEF oit_info oit_get_info(const oit_context *oit);
OIT_DEF const char *oit_result_string(oit_result result);
OIT_DEF const char *oit_pass_kind_name(oit_pass_kind kind);

OIT_DEF oit_result oit_begin(oit_context *oit, const oit_frame *frame);
/* 1: draw all transparent objects; 0: none is left (or something failed, which oit_compose and oit_end return). Under
   OIT_STATE_NONE also the passes that are not the host's come this way. */
OIT_DEF int oit_next_pass(oit_context *oit, oit_pass *pass);
/* Composes the fragments over the target. Under OIT_STATE_NONE the passes of it come from oit_next_pass after this. */
OIT_DEF oit_result oit_compose(oit_context *oit);
OIT_DEF oit_result oit_end(oit_context *oit); /* may come early: what is drawn so far stays */
/* The latest that is known; with OIT_FIT_WAIT it waits for the last frame. */
OIT_DEF oit_result oit_get_report(oit_context *oit, oit_report *report);

/* ---- picking ----------------------------------------------------------------------------------------------------- */

#define OIT_MAX_PICKS 4

/* One fragment of one pixel. Members whose fields were not chosen are 0. */
typedef struct oit_pick {
    int x, y, layer; /* as asked */
    uint64_t frame;  /* that it is of, counted as in oit_report */
    uint32_t layers; /* fragments of the pixel before the host's opaque things; BUDGET, BUCKETED: that are kept */
    int found;       /* 0: there is no such layer, or the pixel's run did not fit; what follows is then 0 */
    float depth;     /* window depth */
    float color[4];  /* as it was stored: multiplied by alpha with desc.premultiplied */
    uint32_t part, key, blend;
    float normal[3], uv[2]; /* the normal of unit length */
    uint32_t coverage;      /* a bit for each sample */
    uint32_t words[8];      /* the host's */
} oit_pick;

/* Asks for the fragment at a pixel of the target (y as in gl_FragCoord) that `layer` others come before, 0 being the
   nearest. The next oit_compose answers, that of this frame where one is under way. Needs the context current; makes a
   program and a buffer when first called. OIT_MAX_PICKS may be under way; one more is OIT_WRONG_ORDER. */
OIT_DEF oit_result oit_pick_begin(oit_context *oit, int x, int y, int layer);
/* The answer asked for first, which is then done with. OIT_NOT_READY: not there yet; with wait it is waited for, once the
   frame that answers has ended. OIT_WRONG_ORDER: none is under way, or none that can be waited for. */
OIT_DEF oit_result oit_pick_result(oit_context *oit, int wait, oit_pick *pick);

/* ---- operators --------------------------------------------------------------------------------------------------- */

/* Between the last pass of the host's and oit_compose, operators may work on all fragments of the image: Carnecky et al.
   2013 (smart transparency; sections and equations below are theirs) and Murray et al. 2016 (curvature). Each oit_run is
   one operator; they build on one another in the order in which they are run, and only for this frame:

       LINK        neighbours along the surface, which the three below need
       LAW         the opacity that a fragment starts with, "base"
       SMART       silhouettes strengthened, halos before what lies behind: fields beta and gamma, base made smooth
       CURVATURE   kappa of each fragment, and opacity, shade and suggestive contours from it
       HOST        a compute program of the host's

   and oit_compose lays a fragment with opacity (1 - gamma)(base + (1 - base) beta) and shade(kappa) times its colour. What
   was not run has no part in that; a frame without oit_run is composed as ever. Surfaces are the fragments of
   OIT_BLEND_OVER; others are composed as they are. What oit_run may be asked for is chosen at creation: what is not costs
   no byte and no program. Bytes are those of a fragment, in the buffer of the surfaces. */
enum {
    OIT_OPERATE_LINKS = 1, /* 8 (12 from 255 layers on), and 4 to 12 in the record: normal, part, slope of the depth */
    OIT_OPERATE_LAW = 2,   /* 4 */
    OIT_OPERATE_SMART = 4, /* 8; takes LINKS and LAW along */
    OIT_OPERATE_CURVATURE = 8,  /* 4; takes LINKS and LAW along */
    OIT_OPERATE_LOCAL = 16,     /* 4, shared with SMART: for HOST with iterations */
    OIT_OPERATE_DIFFUSION = 32, /* 8: beta and gamma of SMART by equation 8 */
    OIT_OPERATE_THIN = 64,      /* 8: smart.thin */
    OIT_OPERATE_BUCKETS = 128,  /* 4: OIT_SEARCH_BUCKETS */
    OIT_OPERATE_CONTOURS = 256  /* 4, and 4 shared with SMART: curvature.contours; takes CURVATURE along */
};
#define OIT_OPERATE_ALL 511u
#define OIT_MAX_OPERATOR_FIELDS 4

/* When two fragments of one part, in pixels side by side, are neighbours: each is what the other likes best of that pixel
   (section 4.4, figure 7b), by a measure of how little the surface would have to bend. */
typedef enum oit_criterion {
    OIT_LINK_DEPTH, /* equations 1 to 3: depth_weight times the distance, in radii, of the depth that the fragment's own
                       slope predicts, plus normal_weight times 1 - n.n; none farther than limit (radii), but
                       where a surface of steadily changing slope may be: between what both slopes predict */
    OIT_LINK_UV,    /* distance in (u, v), none farther than limit; needs OIT_FIELD_UV */
    OIT_LINK_PUBLISHED, /* as DEPTH, without limit, and both ways by the measure of one side (algorithm 2) */
    OIT_LINK_MURRAY     /* 1 - n.n plus the difference of window depths squared; no limit (Murray 2016, section 5.1) */
} oit_criterion;

typedef enum oit_search {
    OIT_SEARCH_WINDOWED, /* outward from the predicted depth, until depth alone is worse: the links of BRUTE. For DEPTH; the
                            other criteria have no order to search by and are searched as by BRUTE */
    OIT_SEARCH_BRUTE,  /* all pairs (k^2) */
    OIT_SEARCH_BUCKETS /* all pairs within a part, found by runs that are grouped by part (Murray 2016, section 4) */
} oit_search;

typedef struct oit_link {
    oit_criterion criterion;
    oit_search search;
    float depth_weight, normal_weight; /* not negative; both 0: default 0.5 and 0.5 */
    float radius;                      /* of the scene's bounding sphere, units of the eye's space; 0: default 1 */
    float limit;                       /* 0: default 0.04; negative: none */
    int no_reverse_check;              /* 1: what one side likes best is its neighbour (Murray 2016, figure 5a) */
    int count_pairs;                   /* 1: pairs that are compared are counted in the header of the buffer */
} oit_link;

/* Base, where |n.v| is the cosine between the normal and the direction to the eye, d the distance to the nearest
   silhouette along the surface in pixels, m the number of surfaces of the pixel:

       GIVEN      alpha as it was stored
       CONSTANT   s                                          equation 4
       ADAPTIVE   1 - (1 - s)^(1/m)                          equation 5: the m together make s
       ANGLE      1 - (1 - s) |n.v|^exponent                 s where the surface faces the eye
       VARIATION  1 - (1 - s) e^(-scale v)                   v: root of the sum of the squared differences of normals to
                                                             the neighbours, those across a pixel halved; needs LINK
       DISTANCE   1 - (1 - s) min(1, d/reach)^exponent       needs SMART, whose beta or gamma goes reach iterations or
                                                             more by equation 9: beyond them d counts as reach */
typedef enum oit_law_kind {
    OIT_LAW_GIVEN,
    OIT_LAW_CONSTANT,
    OIT_LAW_ADAPTIVE,
    OIT_LAW_ANGLE,
    OIT_LAW_VARIATION,
    OIT_LAW_DISTANCE
} oit_law_kind;

typedef struct oit_law {
    oit_law_kind kind;
    float s;        /* in [0,1]; 0: default 0.3; negative: 0 */
    float exponent; /* 0: default 1 */
    float scale;    /* VARIATION; 0: default 4 */
    float reach;    /* DISTANCE, pixels; 0: default 20 */
} oit_law;

/* How a field spreads from its boundary conditions (section 5.4). */
typedef enum oit_process {
    OIT_PROCESS_DEFAULT,   /* DIFFUSION for base, GREATEST for beta and gamma */
    OIT_PROCESS_DIFFUSION, /* equation 8 with 1/8 of the sum of differences; beta and gamma: OIT_OPERATE_DIFFUSION */
    OIT_PROCESS_GREATEST   /* equation 9; not for base */
} oit_process;

typedef enum oit_profile {
    OIT_PROFILE_NONE,
    OIT_PROFILE_10, /* (e^(-p (1-u)^2) - e^-p) / (1 - e^-p), and its limit 1 - (1-u)^2 for p = 0 */
    OIT_PROFILE_11  /* u^p */
} oit_profile;

typedef struct oit_spread {
    oit_process process;
    int iterations;      /* at most 65533; 0: default 20; negative: none */
    float lambda;        /* in [0,1]; 0: default 1 for base, 0.05 for beta, 0.1 for gamma; negative: 0 */
    oit_profile profile; /* of beta and gamma */
    float p;             /* 0: default 3 with OIT_PROFILE_10, 0.3 with 11; negative: 0 */
} oit_spread;

typedef struct oit_smart {
    oit_spread base, beta, gamma; /* where no LAW was run, base starts as GIVEN */
    int jumps;  /* 1: few passes that go far along rows and columns instead of one an iteration; see JUMPS */
    int rounds; /* of jumps: along rows and along columns; 0: default what reaches without a bend, and 2 for bends */
    int until_stable; /* 1: as many rounds as are needed: beta and gamma as iterated, exactly */
    float thin;       /* beta and gamma reach no farther than this share of the surface's width there; 0: any (paper) */
    int published;    /* 1: the paper's own: mean of four in equation 8, equation 9 without b, plain layer indices, and
                         algorithm 3 as printed, whose weights do not sum to 1; iterated */
} oit_smart;

/* Transfer functions (Murray 2016, section 5.2), interpolated between their entries. */
#define OIT_TRANSFER_SHADES 32
#define OIT_TRANSFER_CURVATURES 32
#define OIT_TRANSFER_DEPTHS 16

typedef enum oit_shade {
    OIT_SHADE_NONE,
    OIT_SHADE_CONVEX, /* brightens what is convex, darkens what is concave (figure 6a) */
    OIT_SHADE_CURVED  /* bright where curved, dark where flat (figure 6b) */
} oit_shade;

typedef enum oit_opacity {
    OIT_OPACITY_NONE,  /* base is left as it is */
    OIT_OPACITY_FRONT, /* clear where flat and near; grows fast with depth (figure 7a) */
    OIT_OPACITY_DEEP   /* clear where flat, over a wider range of depth (figure 7b) */
} oit_opacity;

/* Lines within a surface, drawn by oit_compose on every layer, hidden ones as well. SUGGESTIVE (DeCarlo et al. 2003): where
   the curvature in the direction to the eye, laid into the surface, is 0 and rises toward the eye: contours of views
   nearby. None on what is convex. They fade where surfaces face the eye (below 30 degrees; from 14 on there is none), and
   where that rise is small. */
typedef enum oit_contours { OIT_CONTOURS_NONE, OIT_CONTOURS_SUGGESTIVE } oit_contours;

typedef struct oit_curvature {
    float unit; /* length whose reciprocal is a curvature of 1, units of the eye's space; 0: per pixel, as published */
    oit_shade shade;
    oit_opacity opacity;
    const float *shades;    /* instead: OIT_TRANSFER_SHADES rgb factors, for kappa from -1 to 1 */
    const float *opacities; /* instead: OIT_TRANSFER_DEPTHS rows, near to far, of OIT_TRANSFER_CURVATURES opacities in
                               [0,1] for |kappa| from 0 to 1; kept in 16 bits */
    float first, last;      /* distances along the view that are the depths 0 and 1; both 0: those of the projection */
    oit_contours contours;  /* needs OIT_OPERATE_CONTOURS */
    int contour_iterations; /* of equation 8 that the curvature toward the eye is smoothed by, over sqrt(n)/2 pixels along
                               the surface: faces that are larger show; at most 65533; 0: default 64; negative: none */
    float contour_width;    /* pixels; 0: default 1.5 */
    float
        contour_least; /* of the rise, in radii of the link to the power -2: below it is no line, from twice as much on a
                            whole one; 0: default 1; negative: 0 */
    float contour_color[3];
} oit_curvature;

/* The values of a fragment, by the names that shaders have for them: OIT_BASE, ..., OIT_HOST + k. */
typedef enum oit_value { OIT_VALUE_BASE, OIT_VALUE_BETA, OIT_VALUE_GAMMA, OIT_VALUE_KAPPA, OIT_VALUE_HOST } oit_value;

/* Section 4.5. Without iterations the program runs once: purely local (it looks at a pixel's list) or global; it may write
   OIT_BASE and OIT_HOST + k of the fragments of its own pixel, and reads there what was before it only in its own pixel.
   With iterations, a local operator: `value` (BASE or HOST + k) goes from oit_before() to oit_set_after(), n times. */
typedef struct oit_host_operator {
    uint32_t program; /* of oit_operator_glsl() and `void oit_operate(uint p)`, linked; it stays the host's */
    int iterations;   /* 0: once, without oit_before and oit_set_after */
    int value;        /* what it makes: OIT_VALUE_BASE, which is GIVEN where no LAW was run, or OIT_VALUE_HOST + k */
} oit_host_operator;

typedef enum oit_run_kind { OIT_RUN_LINK, OIT_RUN_LAW, OIT_RUN_SMART, OIT_RUN_CURVATURE, OIT_RUN_HOST } oit_run_kind;

typedef struct oit_operator {
    oit_run_kind kind; /* only the member of that kind is looked at */
    oit_link link;
    oit_law law;
    oit_smart smart;
    oit_curvature curvature;
    oit_host_operator host;
} oit_operator;

/* After oit_next_pass has returned 0, before oit_compose. The first run of a frame sorts, too. Under OIT_STATE_NONE the
   passes of it come from oit_next_pass after this, before anything else is called. Makes programs when they are first
   needed. On failure the frame goes on as if it had not been called: OIT_INVALID_ARGUMENT (what was not chosen, a number
   out of range, frame.projection missing), OIT_WRONG_ORDER (what it builds on was not run), OIT_TOO_LARGE (the image is
   drawn in bands or slabs: operators need all of it at once), OIT_OUT_OF_MEMORY, OIT_SHADER_FAILED. */
OIT_DEF oit_result oit_run(oit_context *oit, const oit_operator *op);
/* Strings (with #version) to put before the host's text, which defines `void oit_operate(uint p)`, called for each pixel;
   see OPERATORS OF THE HOST'S. Valid as long as the context; NULL without operators. */
OIT_DEF const char *const *oit_operator_glsl(const oit_context *oit, int *count);

/* Uniforms of the built-in surface programs. */
typedef struct oit_material {
    float model_view_projection[16]; /* column-major */
    float normal_matrix[9];          /* column-major 3x3: object space to the space of oit_frame.light */
    float color[4];                  /* rgb added to attribute 3, and alpha; not multiplied by it */
    uint32_t part, key;              /* where those fields are chosen */
    uint32_t blend;                  /* OIT_BLEND_*, where OIT_FIELD_BLEND is chosen */
    int two_sided; /* 1: of a sheet: where the back of a triangle is seen (by glFrontFace) its stored normal is turned round,
                      so that curvature is that of the side that is seen, and a seam where normals change sides is none */
} oit_material;

/* LINE: of a feature line: laid over as OVER is, and no surface: operators give it no layer index, links or fields. */
enum { OIT_BLEND_OVER, OIT_BLEND_ADD, OIT_BLEND_MULTIPLY, OIT_BLEND_LINE };

/* For objects drawn with the built-in program; call it after oit_next_pass, before the draw call. */
OIT_DEF void oit_set_material(oit_context *oit, const oit_pass *pass, const oit_material *material);

typedef enum oit_stage { OIT_VERTEX, OIT_FRAGMENT, OIT_STAGE_COUNT } oit_stage;

/* Strings (with #version) to put before a shader of the host's, for OIT_PASS_COUNT or OIT_PASS_FILL; valid as long as the
   context; NULL for bad arguments. */
OIT_DEF const char *const *oit_glsl(const oit_context *oit, oit_stage stage, oit_pass_kind kind, int *count);

/* Gives the buffers back, e.g. when transparency pauses; the next frame makes them anew. */
OIT_DEF oit_result oit_release(oit_context *oit);

#ifdef __cplusplus
}
#endif

#endif /* OIT_BUFFERS_H */

#ifdef OIT_BUFFERS_IMPLEMENTATION
#ifndef OIT_BUFFERS_IMPLEMENTATION_ONCE
#define OIT_BUFFERS_IMPLEMENTATION_ONCE

#include <math.h>
#include <string.h>

#ifndef OIT_MALLOC
#include <stdlib.h>
#define OIT_MALLOC(size) malloc(size)
#define OIT_FREE(block) free(block)
#endif

#ifdef OIT_STATIC
#define OIT_I_API OIT_DEF
#else
#define OIT_I_API
#endif

#if defined(_WIN32) && !defined(_WIN64)
#define OIT_I_GLAPI __stdcall
#else
#define OIT_I_GLAPI
#endif

/* clang-format off */
/* ==== generated from shaders/ by tools/embed_shaders: edit there, then `make shaders` ==== */
/* clang-format off */
static const char *const oit_i_shader_oit_arrange_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// After the second geometry pass of the bucketed store (Murray 2016, section 4.1): the fragments of each pixel grouped by\n"
    "// part, and by depth within a part (reordering of Z), and where each group lies (bucket creation). The places in Z are\n"
    "// ordered, not the records, which stay where they are.\n"
    "layout(local_size_x = 128) in;\n"
    "\n"
    "// One more fragment of that part. Its slot is part mod k, or the next that is free: there are k, and no more parts. Of two\n"
    "// parts that meet the smaller takes the slot and the other moves on; so the table is the one that the paper gets from parts\n"
    "// in ascending order, in whatever order they come.\n"
    "void oit_count_part(uint p, uint part)\n"
    "{\n"
    "    uint count = 1u, slot = part % OIT_LAYERS;\n"
    "    for (uint i = 0u; i < OIT_LAYERS; ++i) {\n"
    "        uint at = OIT_BUCKET(p, slot), there = oit_pixel[at], others = oit_pixel[at + 1u];\n"
    "        if (others > 0u && there == part) {\n"
    "            oit_pixel[at + 1u] = others + 1u;\n"
    "            return;\n"
    "        }\n"
    "        if (others == 0u || part < there) {\n"
    "            oit_pixel[at] = part;\n"
    "            oit_pixel[at + 1u] = count;\n"
    "            if (others == 0u)\n"
    "                return;\n"
    "            part = there;\n"
    "            count = others;\n"
    "        }\n"
    "        slot = slot + 1u < OIT_LAYERS ? slot + 1u : 0u;\n"
    "    }\n"
    "}\n"
    "\n"
    "// Into its bucket, behind the fragments that are composed before it.\n"
    "void oit_place(uint p, uint place)\n"
    "{\n"
    "    uint part = OIT_WORD(place * uint(OIT_VECTORS), OIT_AT_PART), first, count;\n"
    "    uint at = oit_find_bucket(p, part, first, count), to = first + count;\n"
    "    for (; to > first && oit_after(oit_bucket_record(p, to - 1u) * uint(OIT_VECTORS), place * uint(OIT_VECTORS)); --to)\n"
    "        oit_pixel[OIT_KEY(p, to)] = oit_bucket_record(p, to - 1u);\n"
    "    oit_pixel[OIT_KEY(p, to)] = place;\n"
    "    oit_pixel[at] += 1u << 16u;\n"
    "}\n"
    "\n"
    "void oit_arrange(uint p)\n"
    "{\n"
    "    uint end = oit_pixel[OIT_START(p + 1u)];\n"
    "    uint start = oit_pixel[OIT_START(p)] + uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));\n"
    "    for (uint slot = 0u; slot < OIT_LAYERS; ++slot)\n"
    "        oit_pixel[OIT_BUCKET(p, slot) + 1u] = 0u;\n"
    "    for (uint place = start; place < end; ++place)\n"
    "        oit_count_part(p, OIT_WORD(place * uint(OIT_VECTORS), OIT_AT_PART));\n"
    "    uint first = 0u;\n"
    "    for (uint slot = 0u; slot < OIT_LAYERS; ++slot) {\n"
    "        uint at = OIT_BUCKET(p, slot) + 1u, count = oit_pixel[at];\n"
    "        oit_pixel[at] = count > 0u ? OIT_BUCKET_USED | first : 0u;\n"
    "        first += count;\n"
    "    }\n"
    "    for (uint place = start; place < end; ++place)\n"
    "        oit_place(p, place);\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;\n"
    "    for (uint i = 0u; i < 8u; ++i)\n"
    "        if (first + 128u * i < oit_pool.x)\n"
    "            oit_arrange(first + 128u * i);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_behind_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The tail read back: the sums of oit_to_tail, and what layers that are mixed evenly look like.\n"
    "#ifndef OIT_CLASS // not after oit_record.glsl\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "#endif\n"
    "\n"
    "#if OIT_TAIL_WORDS == 6\n"
    "vec4 oit_tail_sums(uint p)\n"
    "{\n"
    "    uint at = OIT_TAIL(p);\n"
    "    uvec4 low = uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]);\n"
    "    uvec4 carries = uvec4(oit_pixel[at + 4u], oit_pixel[at + 4u] >> 16u, oit_pixel[at + 5u], oit_pixel[at + 5u] >> 16u);\n"
    "    return vec4(low) * (1.0 / 67108864.0) + vec4(carries & 0xffffu) * 64.0;\n"
    "}\n"
    "#else\n"
    "vec4 oit_tail_sums(uint p, uint count)\n"
    "{\n"
    "    uint at = OIT_TAIL(p);\n"
    "    float unit = exp2(float(findMSB(count) - 25));\n"
    "    return vec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]) * unit;\n"
    "}\n"
    "#endif\n"
    "\n"
    "// rgb: the light that comes of them; a: how much is seen through them.\n"
    "vec4 oit_tail_light(vec4 sums)\n"
    "{\n"
    "    float thickness = sums.a, through = exp(-thickness);\n"
    "    // (1 - e^-t) / t, whose quotient loses its digits near 0.\n"
    "    return vec4(sums.rgb * (thickness > 1.0e-3 ? (1.0 - through) / thickness : 1.0 - 0.5 * thickness), through);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_buckets_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What the bucketed store keeps beside the runs, for those who look for fragments of one part. After the blocks of\n"
    "// oit_record.glsl. Records of a bucket are numbered from `first` on and ordered as they are composed.\n"
    "#define OIT_BUCKET_USED 0x80000000u\n"
    "\n"
    "// Place of the i-th record of the pixel, by bucket and depth; OIT_VECTORS vectors each.\n"
    "uint oit_bucket_record(uint p, uint i)\n"
    "{\n"
    "    return oit_pixel[OIT_KEY(p, i)];\n"
    "}\n"
    "\n"
    "// Which records a part has, in the order of oit_bucket_record. Returns where its bucket says so; 0: the pixel has none.\n"
    "uint oit_find_bucket(uint p, uint part, out uint first, out uint count)\n"
    "{\n"
    "    uint slot = OIT_LAYERS > 0u ? part % OIT_LAYERS : 0u;\n"
    "    first = count = 0u;\n"
    "    for (uint i = 0u; i < OIT_LAYERS; ++i) {\n"
    "        uint at = OIT_BUCKET(p, slot), range = oit_pixel[at + 1u];\n"
    "        if (range == 0u)\n"
    "            break;\n"
    "        if (oit_pixel[at] == part) {\n"
    "            first = range & 0xffffu;\n"
    "            count = range >> 16u & 0x7fffu;\n"
    "            return at + 1u;\n"
    "        }\n"
    "        slot = slot + 1u < OIT_LAYERS ? slot + 1u : 0u;\n"
    "    }\n"
    "    return 0u;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_clear_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Counts to zero; with the first slab of a frame the totals too. Of the stores that keep the k nearest also the keys,\n"
    "// limits and tails.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) writeonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = first + 128u * i;\n"
    "        if (p >= oit_pool.x)\n"
    "            continue;\n"
    "#if OIT_STORE == OIT_LINKED\n"
    "        oit_pixel[OIT_HEAD(p)] = 0u;\n"
    "        if (OIT_AGAIN)\n"
    "            continue;\n"
    "#endif\n"
    "        oit_pixel[OIT_WANTED(p)] = 0u;\n"
    "#if OIT_HAS_COVERAGE\n"
    "        oit_pixel[OIT_EDGE(p)] = 0u;\n"
    "#endif\n"
    "#if OIT_TAIL_WORDS == 6\n"
    "        for (uint c = 0u; c < 6u; ++c)\n"
    "            oit_pixel[OIT_TAIL(p) + c] = 0u;\n"
    "#endif\n"
    "    }\n"
    "#if OIT_KEEPS\n"
    "    uint each = OIT_LAYERS + 1u, end = min((block + 1u) * OIT_BLOCK, oit_pool.x) * each;\n"
    "    for (uint i = block * OIT_BLOCK * each + gl_LocalInvocationID.x; i < end; i += 128u)\n"
    "        oit_pixel[OIT_KEY(0u, i)] = OIT_NONE;\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = first + 128u * i;\n"
    "        if (p >= oit_pool.x)\n"
    "            break;\n"
    "        oit_pixel[OIT_LIMIT(p)] = OIT_NONE;\n"
    "    }\n"
    "#endif\n"
    "#if OIT_STORE == OIT_LINKED\n"
    "    if (first == OIT_TAKEN)\n"
    "        oit_pixel[first] = 0u;\n"
    "    if (OIT_AGAIN)\n"
    "        return;\n"
    "#endif\n"
    "    if (oit_step.x != 0u && first < OIT_HEADER)\n"
    "        oit_pixel[first] = 0u;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_color_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Colour and coverage of a record, from the words that hold them.\n"
    "#define OIT_COVERAGE_OF(word) ((word) >> uint(OIT_COVERAGE_SHIFT))\n"
    "\n"
    "vec4 oit_unpack_color(uvec4 w)\n"
    "{\n"
    "#if OIT_COLOR == OIT_COLOR_8\n"
    "    return vec4(vec3(uvec3(w.x, w.x >> 10u, w.x >> 20u) & 1023u) * (1.0 / 1023.0), uintBitsToFloat(w.y));\n"
    "#elif OIT_COLOR == OIT_COLOR_HALF\n"
    "    return vec4(unpackHalf2x16(w.x), unpackHalf2x16(w.y));\n"
    "#else\n"
    "    return uintBitsToFloat(w);\n"
    "#endif\n"
    "}\n"
    "\n"
    "// Word i of a record whose first eight are r and q.\n"
    "#define OIT_SORTED_WORD(i) ((i) < 4 ? r[(i) & 3] : q[(i) & 3])\n"
    "\n"
    "uvec4 oit_color_words(uvec4 r, uvec4 q)\n"
    "{\n"
    "    uvec4 w = uvec4(OIT_SORTED_WORD(OIT_AT_COLOR), OIT_SORTED_WORD(OIT_AT_COLOR + 1), 0u, 0u);\n"
    "#if OIT_COLOR == OIT_COLOR_FLOAT\n"
    "    w.z = OIT_SORTED_WORD(OIT_AT_COLOR + 2);\n"
    "    w.w = OIT_SORTED_WORD(OIT_AT_COLOR + 3);\n"
    "#endif\n"
    "    return w;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_compose_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The pixels whose runs have at most OIT_CLASS records and are too deep for the program drawn before, composed over the\n"
    "// target; with OIT_DEEP all that are deeper than the programs that were drawn before, OIT_CLASS records at a time.\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "layout(location = 0, index = 0) out highp vec4 oit_out;\n"
    "layout(location = 0, index = 1) out highp vec4 oit_keep;\n"
    "#else\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "#endif\n"
    "\n"
    "#if OIT_DEEP\n"
    "// Lays the first m of oit_order, which holds `known`. Of ties all records of that depth, be they in this block or not, are\n"
    "// laid when the first of them is met.\n"
    "void oit_lay_sorted(uint base, uint n, uint m, uint known, inout uint grouped)\n"
    "{\n"
    "    for (uint i = 0u; i < m && oit_visible(); ++i) {\n"
    "        uint at = oit_order[i], depth = oit_record_depth(at);\n"
    "        if (depth == grouped)\n"
    "            continue;\n"
    "        if (i + 1u >= known || oit_record_depth(oit_order[i + 1u]) != depth) {\n"
    "            oit_lay(at);\n"
    "        } else {\n"
    "            oit_lay_group(base, n, depth);\n"
    "            grouped = depth;\n"
    "        }\n"
    "    }\n"
    "}\n"
    "\n"
    "void oit_lay_run(uint base, uint n)\n"
    "{\n"
    "    uint depth = 0u, at = 0u, grouped = OIT_NONE;\n"
    "    for (uint done = 0u; done < n && oit_visible(); done += uint(OIT_CLASS)) {\n"
    "        // One more than are laid, to see whether it ties with the last of them.\n"
    "        oit_select(base, n, done > 0u, depth, at);\n"
    "        oit_lay_sorted(base, n, min(uint(OIT_CLASS), n - done), min(uint(OIT_CLASS + 1), n - done), grouped);\n"
    "    }\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if OIT_KEEPS\n"
    "// Behind what is kept, all that is not.\n"
    "void oit_lay_tail(uint p)\n"
    "{\n"
    "    if (oit_pixel[OIT_LIMIT(p)] == OIT_NONE)\n"
    "        return;\n"
    "    vec4 tail = oit_tail_light(oit_tail_sums(p));\n"
    "    oit_sum += oit_through * tail.rgb;\n"
    "    oit_through *= tail.a;\n"
    "}\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);\n"
    "#if OIT_HAS_COVERAGE // each sample by itself where they differ, the whole pixel where not\n"
    "    if (OIT_OUTSIDE || (oit_pixel[OIT_EDGE(p)] != 0u) != (OIT_COVERED == OIT_BY_SAMPLE))\n"
    "        discard;\n"
    "#endif\n"
    "    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];\n"
    "#if OIT_ASYNC\n"
    "    if (end > oit_pool.z)\n"
    "        discard;\n"
    "#endif\n"
    "#if OIT_ASYNC && OIT_STORE == OIT_PREDICT\n"
    "    if (int(oit_pixel[OIT_LEFT(p)]) < 0)\n"
    "        discard;\n"
    "#endif\n"
    "    // Fragments that were counted and did not come have left the first places empty.\n"
    "    start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));\n"
    "    uint n = end - start;\n"
    "#if OIT_DEEP\n"
    "    if (n <= oit_step.y)\n"
    "        discard;\n"
    "#else\n"
    "    if (n <= oit_above[OIT_INDEX] || n > uint(OIT_CLASS))\n"
    "        discard;\n"
    "#endif\n"
    "#if OIT_ADAPTIVE\n"
    "    oit_count_layers((start - oit_pool.y) * uint(OIT_VECTORS), n);\n"
    "#endif\n"
    "    oit_lay_run((start - oit_pool.y) * uint(OIT_VECTORS), n);\n"
    "#if OIT_KEEPS\n"
    "    oit_lay_tail(p);\n"
    "#endif\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "    oit_out = vec4(oit_sum, 0.0);\n"
    "    oit_keep = vec4(oit_light.w * oit_through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_FILTER\n"
    "    oit_out = vec4(oit_light.w * oit_through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_LIGHT\n"
    "    oit_out = vec4(oit_sum, 0.0);\n"
    "#else\n"
    "    oit_out = vec4(oit_sum, oit_light.w * oit_through);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_compose_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Records laid one behind the other, front to back (Carnecky 2013, section 4.6): oit_sum is what has come of them so far,\n"
    "// oit_through how much is still seen of what is behind.\n"
    "#if OIT_HAS_BLEND\n"
    "#define OIT_THROUGH vec3\n"
    "#else\n"
    "#define OIT_THROUGH float\n"
    "#endif\n"
    "vec3 oit_sum = vec3(0.0);\n"
    "OIT_THROUGH oit_through = OIT_THROUGH(1.0);\n"
    "\n"
    "#if OIT_ADAPTIVE\n"
    "// Adaptive transparency (Carnecky 2013, equation 5): each of a pixel's n layers gets 1 - (1 - s)^(1/n), so that together they\n"
    "// hide as much as one of opacity s, however many there are. Here s is a fragment's own alpha. Layers are what that changes:\n"
    "// neither light that is added nor filters, nor what is opaque, nor what lies behind that.\n"
    "float oit_layers = 1.0;\n"
    "\n"
    "// Alpha, where the record is laid over what is behind it, else 0; and how much of what is composed it covers.\n"
    "float oit_over_alpha(uint at, out float part)\n"
    "{\n"
    "    uvec4 r, q;\n"
    "    oit_load(at, r, q);\n"
    "    part = 1.0;\n"
    "#if OIT_COVERED == OIT_BY_SAMPLE\n"
    "    part = float(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE)) >> uint(gl_SampleID) & 1u);\n"
    "#elif OIT_COVERED == OIT_BY_SHARE\n"
    "    part = OIT_SHARE(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE)));\n"
    "#endif\n"
    "#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8\n"
    "    if (OIT_SORTED_WORD(OIT_AT_COLOR) >> 30u != 0u)\n"
    "        return 0.0;\n"
    "#elif OIT_HAS_BLEND\n"
    "    if ((OIT_SORTED_WORD(OIT_AT_BLEND) & 255u) != 0u)\n"
    "        return 0.0;\n"
    "#endif\n"
    "    return oit_unpack_color(oit_color_words(r, q)).a;\n"
    "}\n"
    "\n"
    "void oit_count_layers(uint base, uint n)\n"
    "{\n"
    "    uint wall = OIT_NONE;\n"
    "    float part;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint at = base + i * uint(OIT_VECTORS);\n"
    "        if (oit_over_alpha(at, part) >= 1.0 && part == 1.0)\n"
    "            wall = min(wall, oit_record_depth(at));\n"
    "    }\n"
    "    oit_layers = 0.0;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint at = base + i * uint(OIT_VECTORS);\n"
    "        float alpha = oit_over_alpha(at, part);\n"
    "        if (alpha > 0.0 && alpha < 1.0 && oit_record_depth(at) < wall)\n"
    "            oit_layers += part;\n"
    "    }\n"
    "}\n"
    "\n"
    "// 1 - (1 - alpha)^(1/n) = 1 - e^(log(1 - alpha) / n); by series where the plain functions lose their digits, or are none\n"
    "// too good on some drivers: log(1 - a) = -2 artanh(a / (2 - a)).\n"
    "float oit_adapt(float alpha)\n"
    "{\n"
    "    if (!(alpha > 0.0 && alpha < 1.0 && oit_layers > 1.0))\n"
    "        return alpha;\n"
    "    float z = alpha / (2.0 - alpha), y = z * z, t = log(1.0 - alpha);\n"
    "    if (alpha < 0.5)\n"
    "        t = -2.0 * z * (1.0 + y * (1.0 / 3.0 + y * (1.0 / 5.0 + y * (1.0 / 7.0 + y * (1.0 / 9.0 + y * (1.0 / 11.0 + y / 13.0))))));\n"
    "    t /= oit_layers;\n"
    "    if (t < -0.3)\n"
    "        return 1.0 - exp(t);\n"
    "    return -t * (1.0 + t / 2.0 * (1.0 + t / 3.0 * (1.0 + t / 4.0 * (1.0 + t / 5.0 * (1.0 + t / 6.0 * (1.0 + t / 7.0))))));\n"
    "}\n"
    "#endif\n"
    "\n"
    "void oit_lay(uvec4 r, uvec4 q)\n"
    "{\n"
    "#if OIT_COVERED == OIT_BY_SAMPLE\n"
    "    if ((OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE)) >> uint(gl_SampleID) & 1u) == 0u)\n"
    "        return;\n"
    "#endif\n"
    "    uvec4 words = oit_color_words(r, q);\n"
    "    vec4 color = oit_unpack_color(words);\n"
    "#if OIT_ADAPTIVE && OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8\n"
    "    float adapted = words.x >> 30u == 0u ? oit_adapt(color.a) : color.a;\n"
    "#elif OIT_ADAPTIVE && OIT_HAS_BLEND\n"
    "    float adapted = (OIT_SORTED_WORD(OIT_AT_BLEND) & 255u) == 0u ? oit_adapt(color.a) : color.a;\n"
    "#elif OIT_ADAPTIVE\n"
    "    float adapted = oit_adapt(color.a);\n"
    "#endif\n"
    "#if OIT_ADAPTIVE\n"
    "    if (adapted != color.a)\n"
    "        color = vec4(color.rgb * (OIT_PREMULTIPLIED == 1 ? adapted / color.a : 1.0), adapted);\n"
    "#endif\n"
    "#if OIT_COVERED == OIT_BY_SHARE\n"
    "    color *= vec4(vec3(OIT_PREMULTIPLIED == 1 ? OIT_SHARE(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE))) : 1.0),\n"
    "                  OIT_SHARE(OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE))));\n"
    "#endif\n"
    "#if OIT_PREMULTIPLIED\n"
    "    vec3 light = color.rgb;\n"
    "#else\n"
    "    vec3 light = color.a * color.rgb;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "#if OIT_COLOR == OIT_COLOR_8\n"
    "    uint blend = words.x >> 30u;\n"
    "#else\n"
    "    uint blend = OIT_SORTED_WORD(OIT_AT_BLEND) & 255u;\n"
    "#endif\n",
    "#line 107\n"
    "    if (blend == 2u) { // multiply: seen through a filter of that colour\n"
    "        oit_through *= 1.0 - color.a + light;\n"
    "        return;\n"
    "    }\n"
    "    oit_sum += oit_through * light;\n"
    "    if (blend == 1u) // add: light, which hides nothing\n"
    "        return;\n"
    "#else\n"
    "    oit_sum += oit_through * light;\n"
    "#endif\n"
    "    oit_through *= 1.0 - color.a;\n"
    "}\n"
    "\n"
    "#if OIT_STORE != OIT_FETCH\n"
    "void oit_lay(uint at)\n"
    "{\n"
    "    uvec4 r, q;\n"
    "    oit_load(at, r, q);\n"
    "    oit_lay(r, q);\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if OIT_DEEP\n"
    "// Behind what is opaque all weights are zero, so that to stop there changes no bit.\n"
    "bool oit_visible()\n"
    "{\n"
    "#if OIT_HAS_BLEND\n"
    "    return max(oit_through.r, max(oit_through.g, oit_through.b)) > 0.0;\n"
    "#else\n"
    "    return oit_through > 0.0;\n"
    "#endif\n"
    "}\n"
    "\n"
    "// All records of one depth, in their order, each found anew: ties are rare.\n"
    "void oit_lay_group(uint base, uint count, uint depth)\n"
    "{\n"
    "    uint last = OIT_NONE;\n"
    "    for (;;) {\n"
    "        uint best = OIT_NONE;\n"
    "        for (uint i = 0u; i < count; ++i) {\n"
    "            uint at = base + i * uint(OIT_VECTORS);\n"
    "            if (oit_record_depth(at) != depth || (last != OIT_NONE && !oit_after(at, last)))\n"
    "                continue;\n"
    "            if (best == OIT_NONE || oit_after(best, at))\n"
    "                best = at;\n"
    "        }\n"
    "        if (best == OIT_NONE)\n"
    "            return;\n"
    "        oit_lay(best);\n"
    "        last = best;\n"
    "    }\n"
    "}\n"
    "\n"
    "// What oit_i_put_selection writes is made of these: registers d (depth) and o (where the record lies).\n"
    "#define D(d, o) uint d = OIT_NONE, o = base;\n"
    "#define I(d, o) { s = s || x < d; uint t = d; d = s ? x : d; x = s ? t : x; t = o; o = s ? y : o; y = s ? t : y; }\n"
    "uint oit_order[OIT_CLASS + 1];\n"
    "#else\n"
    "// By all their words, so that two of which neither comes after the other are alike: ties need no further care.\n"
    "bool oit_words_after(uvec4 a, uvec4 b, bool more)\n"
    "{\n"
    "    bool w = a.w > b.w || (a.w == b.w && more);\n"
    "    bool z = a.z > b.z || (a.z == b.z && w);\n"
    "    bool y = a.y > b.y || (a.y == b.y && z);\n"
    "    return a.x > b.x || (a.x == b.x && y);\n"
    "}\n"
    "\n"
    "// What oit_i_put_network writes is made of these: registers r and q (oit_load), swapped where they are in the wrong order,\n"
    "// then laid. Each record is read once; what is not there comes after all that is, and has no colour and no alpha.\n"
    "#define L(r, q, i) uvec4 r = uvec4(OIT_NONE, 0u, 0u, 0u), q = uvec4(0u); if (i < n) oit_load(base + i * uint(OIT_VECTORS), r, q);\n"
    "#define X(r, u, g) { uvec4 t = g ? u : r; u = g ? r : u; r = t; }\n"
    "#if OIT_SORTED > 4\n"
    "#define S(r, q, u, v) { bool g = oit_words_after(r, u, oit_words_after(q, v, false)); X(r, u, g) X(q, v, g) }\n"
    "#else\n"
    "#define S(r, q, u, v) { bool g = oit_words_after(r, u, false); X(r, u, g) }\n"
    "#endif\n"
    "#define Y(r, q, i) oit_lay(r, q);\n"
    "#endif\n",
    0};
static const char *const oit_i_shader_oit_contour_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Suggestive contours (DeCarlo, Finkelstein, Rusinkiewicz, Santella 2003) on every layer, by links: where the curvature\n"
    "// in the direction to the eye, laid into the surface, is 0 and rises toward the eye. With normals that face the eye convex\n"
    "// is positive here. Surfaces are looked at over two pixels each way, or as far as links lead. Lengths are in radii of the\n"
    "// links, so that fourth powers of them stay in the range of floats whatever the unit. oit_set[1].z: 1 over the radius.\n"
    "#define OIT_IN_RADIAL oit_at[5].w // that curvature, then smoothed; 0 where it cannot be told\n"
    "\n"
    "struct oit_cross // around a fragment: left, right, below, above\n"
    "{\n"
    "    uint slots[4];\n"
    "    vec3 across[2]; // along the axes of the eye's space\n"
    "    vec2 pixels;\n"
    "};\n"
    "\n"
    "// False: an axis has no extent.\n"
    "bool oit_cross_of(uint p, uint slot, out oit_cross c)\n"
    "{\n"
    "    uvec4 pixels = uvec4(p);\n"
    "    c.pixels = vec2(0.0);\n"
    "    for (uint d = 0u; d < 4u; ++d) {\n"
    "        c.slots[d] = slot;\n"
    "        for (uint k = 0u; k < 2u; ++k) {\n"
    "            uint next = oit_neighbour(pixels[d], c.slots[d], d), q;\n"
    "            if (next == OIT_NONE || !oit_beside(pixels[d], d, q))\n"
    "                break;\n"
    "            pixels[d] = q;\n"
    "            c.slots[d] = next;\n"
    "            c.pixels[d >> 1u] += 1.0;\n"
    "        }\n"
    "    }\n"
    "    for (uint axis = 0u; axis < 2u; ++axis)\n"
    "        c.across[axis] = (oit_position(oit_device(pixels[2u * axis + 1u]), oit_depth(c.slots[2u * axis + 1u])) -\n"
    "                          oit_position(oit_device(pixels[2u * axis]), oit_depth(c.slots[2u * axis]))) *\n"
    "                         oit_set[1].z;\n"
    "    return c.pixels.x > 0.0 && c.pixels.y > 0.0;\n"
    "}\n"
    "\n"
    "// The direction to the eye less its part along the normal, and that as so much of what lies across on either axis. False:\n"
    "// it cannot be told.\n"
    "bool oit_toward(uint p, uint slot, oit_cross c, out vec3 toward, out vec2 parts)\n"
    "{\n"
    "    vec3 normal = oit_normal(slot), eye = oit_to_eye(oit_device(p));\n"
    "    float xx = dot(c.across[0], c.across[0]), xy = dot(c.across[0], c.across[1]), yy = dot(c.across[1], c.across[1]);\n"
    "    float square = xx * yy - xy * xy;\n"
    "    toward = eye - dot(eye, normal) * normal;\n"
    "    float x = dot(toward, c.across[0]), y = dot(toward, c.across[1]);\n"
    "    parts = vec2(yy * x - xy * y, xx * y - xy * x) / square;\n"
    "    return square > 1.0e-6 * xx * yy && dot(toward, toward) > 1.0e-6;\n"
    "}\n"
    "\n"
    "#ifndef OIT_COMPOSES\n"
    "// Beside silhouettes curvatures without bound would be smoothed into their surroundings: k becomes k / (1 + |k| / 10),\n"
    "// which keeps zeros, and slopes there.\n"
    "float oit_radial(uint p, uint slot)\n"
    "{\n"
    "    oit_cross c;\n"
    "    vec3 toward;\n"
    "    vec2 parts;\n"
    "    if (!oit_cross_of(p, slot, c) || !oit_toward(p, slot, c, toward, parts))\n"
    "        return 0.0;\n"
    "    vec3 bend = parts.x * (oit_normal(c.slots[1]) - oit_normal(c.slots[0])) +\n"
    "                parts.y * (oit_normal(c.slots[3]) - oit_normal(c.slots[2]));\n"
    "    float radial = dot(bend, toward) / dot(toward, toward);\n"
    "    radial /= 1.0 + abs(radial) * 0.1;\n"
    "    return dot(oit_normal(slot), oit_to_eye(oit_device(p))) < 0.0 ? -radial : radial;\n"
    "}\n"
    "#else\n"
    "float oit_radial_of(uint slot)\n"
    "{\n"
    "    return uintBitsToFloat(oit_surface[OIT_IN_RADIAL + slot]);\n"
    "}\n"
    "\n"
    "// How much of a fragment a contour covers: by its distance in pixels, to first order, and fading where the curvature rises\n"
    "// slowly or the surface faces the eye, where contours say little. oit_set[1]: x: half a line and half a pixel; y: 1 over\n"
    "// the least rise.\n"
    "float oit_contour(uint p, uint slot)\n"
    "{\n"
    "    oit_cross c;\n"
    "    vec3 toward;\n"
    "    vec2 parts, rise;\n"
    "    if (!oit_cross_of(p, slot, c) || !oit_toward(p, slot, c, toward, parts))\n"
    "        return 0.0;\n"
    "    for (uint axis = 0u; axis < 2u; ++axis)\n"
    "        rise[axis] = oit_radial_of(c.slots[2u * axis + 1u]) - oit_radial_of(c.slots[2u * axis]);\n"
    "    float steep = length(toward), each = length(rise / c.pixels), covered = oit_set[1].x * each - abs(oit_radial_of(slot));\n"
    "    if (!(covered > 0.0))\n"
    "        return 0.0;\n",
    "#line 88\n"
    "    return min(covered / each, 1.0) * clamp(dot(parts, rise) / steep * oit_set[1].y - 1.0, 0.0, 1.0) *\n"
    "           clamp(4.0 * steep - 1.0, 0.0, 1.0);\n"
    "}\n"
    "#endif\n",
    0};
static const char *const oit_i_shader_oit_depth_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The depth of the composite: of the fragment with which the transmittance falls below oit_output.x. Where it never does,\n"
    "// what the host has put there stays. Written as a depth and as a colour; masks say which of them is taken.\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if OIT_HAS_COVERAGE\n"
    "    if (OIT_OUTSIDE)\n"
    "        discard;\n"
    "#endif\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint base, n, at = OIT_NONE;\n"
    "    if (!oit_find_run(uint(where.y) * uint(oit_area.z) + uint(where.x), base, n))\n"
    "        discard;\n"
    "#if OIT_ADAPTIVE\n"
    "    oit_count_layers(base, n);\n"
    "#endif\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        at = oit_next(base, n, at);\n"
    "        oit_lay(at);\n"
    "#if OIT_HAS_BLEND\n"
    "        float through = max(oit_through.r, max(oit_through.g, oit_through.b));\n"
    "#else\n"
    "        float through = oit_through;\n"
    "#endif\n"
    "        if (through < oit_output.x) {\n"
    "#if OIT_REVERSED_Z\n"
    "            float depth = uintBitsToFloat(0x7fffffffu - oit_record_depth(at));\n"
    "#else\n"
    "            float depth = uintBitsToFloat(oit_record_depth(at));\n"
    "#endif\n"
    "            gl_FragDepth = depth;\n"
    "            oit_out = vec4(depth);\n"
    "            return;\n"
    "        }\n"
    "    }\n"
    "    discard;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_fetch_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// OIT_STORE_FETCH: the nearest layers of a pass, held in the attachments and changed in place by the fragments of a pixel, one\n"
    "// after the other as they are drawn.\n"
    "layout(location = 0) inout highp uvec4 oit_layer_0;\n"
    "layout(location = 1) inout highp uvec4 oit_layer_1;\n"
    "layout(location = 2) inout highp uvec4 oit_layer_2;\n"
    "#if OIT_FETCHED == 7\n"
    "layout(location = 3) inout highp uvec4 oit_layer_3;\n"
    "layout(location = 4) inout highp uvec4 oit_layer_4;\n"
    "layout(location = 5) inout highp uvec4 oit_layer_5;\n"
    "layout(location = 6) inout highp uvec4 oit_layer_6;\n"
    "#define OIT_EACH_LAYER(X) \\\n"
    "    X(oit_layer_0) X(oit_layer_1) X(oit_layer_2) X(oit_layer_3) X(oit_layer_4) X(oit_layer_5) X(oit_layer_6)\n"
    "#else\n"
    "#define OIT_EACH_LAYER(X) X(oit_layer_0) X(oit_layer_1) X(oit_layer_2)\n"
    "#endif\n"
    "// How many were like the last one that was composed; how many there were.\n"
    "layout(location = OIT_FETCHED) inout highp uvec2 oit_seen;\n",
    0};
static const char *const oit_i_shader_oit_frame_block_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What is the same for all of a pass (std140, written by oit_i_upload_block), and where things lie in the pixel buffer.\n"
    "layout(std140, binding = OIT_UNIFORM_BINDING) uniform oit_frame\n"
    "{\n"
    "    highp ivec4 oit_area;  // x, y of the slab's corner in the target, its width and height\n"
    "    highp uvec4 oit_pool;  // x: pixels of the slab, y: first fragment of the band, z: capacity, w: blocks of the scan\n"
    "    highp uvec4 oit_step;  // x: 1 with the first slab of a frame, y: what is deeper is left to the program for all depths,\n"
    "                           // w: k of the stores that keep the k nearest; of others 1 where the fragments are stored before\n"
    "                           // they are counted, 2 where they are stored again; of fetch how many passes there are, if known\n"
    "    highp uvec4 oit_above; // what is not deeper than this is left to the program before: of up to 8, 16, 32\n"
    "    highp vec4 oit_light;  // xyz: toward the light, unit length; zero: no shading. w: weight of the background\n"
    "    highp vec4 oit_output; // x: transmittance below which the depth of the composite is taken\n"
    "    highp ivec4 oit_part;          // x, y of the corner in the target, width and height of what is filled and composed now\n"
    "    highp uvec4 oit_samples;       // x: a bit for each sample of the target\n"
    "    highp vec4 oit_positions[4];   // of two samples each, from the middle of the pixel\n"
    "};\n"
    "\n"
    "// The pixel buffer: 16 words of totals, then two words a pixel (where its run starts; how many fragments are still to\n"
    "// come), one more start, a word for each block of the scan, a word a pixel where the store has one of its own, and four or\n"
    "// six words a pixel for the tail.\n"
    "#define OIT_NEEDED 0u      // fragments of the slab that needs most\n"
    "#define OIT_DEEPEST 1u     // fragments of the deepest pixel\n"
    "#define OIT_LOST_PIXELS 2u // pixels that are composed from the tail\n"
    "#define OIT_LOST 3u        // fragments that went to the tail\n"
    "#define OIT_EXTRA 4u       // fragments that the fill met and the count had not\n"
    "#define OIT_TOTAL 5u       // fragments of this slab\n"
    "#define OIT_TAKEN 6u       // OIT_STORE_LINKED: records taken of the list\n"
    "#define OIT_PIXELS 8u      // from here on, by power of two: pixels of up to 8, 16, 32 fragments, and of more\n"
    "#define OIT_HEADER 16u\n"
    "#define OIT_START(p) (OIT_HEADER + 2u * (p))\n"
    "#define OIT_LEFT(p) (OIT_HEADER + 1u + 2u * (p))\n"
    "#define OIT_SUM(b) (OIT_HEADER + 2u + 2u * oit_pool.x + (b))\n"
    "#define OIT_MORE (OIT_HEADER + 2u + 2u * oit_pool.x + oit_pool.w)\n"
    "#if OIT_KEEPS\n"
    "// With the stores that keep the k nearest: six words a pixel for the tail, the limit (keys from there on are not kept),\n"
    "// k + 1 keys; and k buckets of two words: a part, and which records it has.\n"
    "#define OIT_LAYERS oit_step.w\n"
    "#define OIT_TAIL(p) (OIT_MORE + 6u * (p))\n"
    "#define OIT_LIMIT(p) (OIT_MORE + 6u * oit_pool.x + (p))\n"
    "#define OIT_KEY(p, i) (OIT_MORE + 7u * oit_pool.x + (p) * (OIT_LAYERS + 1u) + (i))\n"
    "#define OIT_BUCKET(p, i) (OIT_MORE + (8u + OIT_LAYERS) * oit_pool.x + 2u * ((p) * OIT_LAYERS + (i)))\n"
    "#else\n"
    "#define OIT_OWN(p) (OIT_MORE + (p))\n"
    "#define OIT_TAIL(p) (OIT_MORE + uint(OIT_OWN_WORDS) * oit_pool.x + uint(OIT_TAIL_WORDS) * (p))\n"
    "#endif\n"
    "#define OIT_DIRECT (OIT_KEEPS == 0 && oit_step.w == 1u)\n"
    "#define OIT_AGAIN (OIT_KEEPS == 0 && oit_step.w == 2u)\n"
    "\n"
    "// OIT_STORE_FETCH: eleven words a pixel: the last record that was composed and how many were like it; light and transmittance\n"
    "// of what was.\n"
    "#define OIT_LAID(p) (OIT_MORE + 11u * (p))\n"
    "\n"
    "// OIT_STORE_LINKED: one more than the place of the pixel's last record; 0: none.\n"
    "#define OIT_HEAD(p) OIT_OWN(p)\n"
    "\n"
    "// Where the scan finds how long the run of a pixel shall be. OIT_STORE_PREDICT keeps how many fragments came in the frame\n"
    "// before, and needs no place for its guess but that where the scan writes the start.\n"
    "#if OIT_STORE == OIT_PREDICT\n"
    "#define OIT_SEEN(p) OIT_OWN(p)\n"
    "#define OIT_WANTED(p) OIT_START(p)\n"
    "#else\n"
    "#define OIT_WANTED(p) OIT_LEFT(p)\n"
    "#endif\n"
    "#define OIT_NONE 0xffffffffu\n"
    "\n",
    "#line 66\n"
    "// With OIT_HAS_COVERAGE one word a pixel follows: 1 where a fragment covers not all of its samples.\n"
    "#if OIT_KEEPS\n"
    "#define OIT_EDGE(p) (OIT_BUCKET(OIT_STORE == OIT_BUCKETED ? oit_pool.x : 0u, 0u) + (p))\n"
    "#else\n"
    "#define OIT_EDGE(p) (OIT_TAIL(oit_pool.x * uint(OIT_ASYNC)) + (p))\n"
    "#endif\n"
    "\n"
    "// With what is to come of a pixel whose run does not fit. A pixel has less than 2^30 fragments.\n"
    "#define OIT_UNFIT 0x40000000u\n"
    "// How many places are left, without that; negative: so many came too much.\n"
    "#define OIT_TRUE_LEFT(left) (int(left) - (OIT_ASYNC == 1 && int(left) >= 0x20000000 ? 0x40000000 : 0))\n"
    "\n"
    "// Mesa 22's software driver lets multisampled fragments pass beyond the scissor box, by one pixel to the left and below.\n"
    "#define OIT_OUTSIDE (any(lessThan(ivec2(gl_FragCoord.xy), oit_part.xy)) || \\\n"
    "                     any(greaterThanEqual(ivec2(gl_FragCoord.xy), oit_part.xy + oit_part.zw)))\n"
    "\n"
    "// The part of a pixel that some of its samples are.\n"
    "#define OIT_SHARE(covered) (float(bitCount(covered)) / float(max(bitCount(oit_samples.x), 1)))\n"
    "\n"
    "// A block of the scan: 128 invocations of 8 pixels each.\n"
    "#define OIT_BLOCK 1024u\n",
    0};
static const char *const oit_i_shader_oit_fullscreen_vert[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// One triangle that covers the viewport; no vertex buffer.\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));\n"
    "    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_gather_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// OIT_STORE_LINKED, after the fill: the list of each pixel copied into a run of its own (Carnecky 2013, section 4.3, which\n"
    "// sorts as it copies; ours are sorted where they are composed). Where the list was too small, into the pixel's tail.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_FRAGMENTS) writeonly buffer oit_runs { OIT_VECTOR oit_run[]; };\n"
    "\n"
    "// Without the link, which differs from frame to frame, so that only the fragment's own words are ever compared.\n"
    "void oit_copy(uint from, uint to)\n"
    "{\n"
    "    for (uint i = 0u; i < uint(OIT_VECTORS); ++i) {\n"
    "        OIT_VECTOR words = oit_data[from + i];\n"
    "        if (i == uint(OIT_AT_LINK / OIT_LANES))\n"
    "            words[OIT_AT_LINK % OIT_LANES] = 0u;\n"
    "        oit_run[to + i] = words;\n"
    "    }\n"
    "}\n"
    "\n"
    "void oit_gather(uint p)\n"
    "{\n"
    "    uint end = oit_pixel[OIT_START(p + 1u)], n = end - oit_pixel[OIT_START(p)], found = 0u;\n"
    "    bool lost = OIT_ASYNC == 1 && end > oit_pool.z;\n"
    "    for (uint link = oit_pixel[OIT_HEAD(p)]; link != 0u && found < n; ++found) {\n"
    "        uint at = (link - 1u) * uint(OIT_VECTORS);\n"
    "#if OIT_ASYNC\n"
    "        if (lost)\n"
    "            oit_add_to_tail(p, oit_record_amounts(at));\n"
    "#endif\n"
    "        if (!lost)\n"
    "            oit_copy(at, (end - 1u - found - oit_pool.y) * uint(OIT_VECTORS));\n"
    "        link = OIT_WORD(at, OIT_AT_LINK);\n"
    "    }\n"
    "    if (!lost)\n"
    "        oit_pixel[OIT_LEFT(p)] = n - found;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;\n"
    "    for (uint i = 0u; i < 8u; ++i)\n"
    "        if (first + 128u * i < oit_pool.x)\n"
    "            oit_gather(first + 128u * i);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_keep_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Between the two geometry passes of the stores that keep the k nearest: what is kept of each pixel. With more than k\n"
    "// fragments the limit is the greatest of its k + 1 smallest keys. Fewer than k + 1 lie below, and those that equal it,\n"
    "// which do not all fit, go to the tail together: which ones are kept depends on the set of fragments alone.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "shared uint oit_all[5];     // needed, deepest, lost pixels, lost fragments\n"
    "shared uint oit_classes[4]; // pixels by how many fragments are kept\n"
    "\n"
    "uint oit_kept(uint p, uint count)\n"
    "{\n"
    "    uint limit = OIT_NONE, kept = count;\n"
    "    if (count > OIT_LAYERS) {\n"
    "        limit = 0u;\n"
    "        kept = 0u;\n"
    "        for (uint i = 0u; i <= OIT_LAYERS; ++i)\n"
    "            limit = max(limit, oit_pixel[OIT_KEY(p, i)]);\n"
    "        for (uint i = 0u; i <= OIT_LAYERS; ++i)\n"
    "            kept += oit_pixel[OIT_KEY(p, i)] < limit ? 1u : 0u;\n"
    "    }\n"
    "    oit_pixel[OIT_LIMIT(p)] = limit;\n"
    "    return kept;\n"
    "}\n"
    "\n"
    "void oit_keep_nearest(uint p)\n"
    "{\n"
    "    uint count = oit_pixel[OIT_LEFT(p)];\n"
    "    uint kept = oit_kept(p, count);\n"
    "    oit_pixel[OIT_START(p)] = p * OIT_LAYERS;\n"
    "    oit_pixel[OIT_LEFT(p)] = OIT_LAYERS;\n"
    "    atomicAdd(oit_all[0], count);\n"
    "    atomicMax(oit_all[1], count);\n"
    "    atomicAdd(oit_all[2], kept < count ? 1u : 0u);\n"
    "    atomicAdd(oit_all[3], count - kept);\n"
    "    if (kept > 0u)\n"
    "        atomicAdd(oit_classes[kept <= 8u ? 0u : min(uint(findMSB(kept - 1u)) - 2u, 3u)], 1u);\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint self = gl_LocalInvocationID.x;\n"
    "    if (self < 4u)\n"
    "        oit_all[self] = oit_classes[self] = 0u;\n"
    "    barrier();\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = block * OIT_BLOCK + 128u * i + self;\n"
    "        if (p < oit_pool.x)\n"
    "            oit_keep_nearest(p);\n"
    "    }\n"
    "    barrier();\n"
    "    if (self < 4u && oit_classes[self] > 0u)\n"
    "        atomicAdd(oit_pixel[OIT_PIXELS + self], oit_classes[self]);\n"
    "    if (self == 0u && block == 0u)\n"
    "        oit_pixel[OIT_START(oit_pool.x)] = oit_pool.x * OIT_LAYERS;\n"
    "    if (self == 0u) {\n"
    "        atomicAdd(oit_pixel[OIT_NEEDED], oit_all[0]);\n"
    "        atomicMax(oit_pixel[OIT_DEEPEST], oit_all[1]);\n"
    "        atomicAdd(oit_pixel[OIT_LOST_PIXELS], oit_all[2]);\n"
    "        atomicAdd(oit_pixel[OIT_LOST], oit_all[3]);\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_laid_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// OIT_STORE_FETCH: what has come of all layers, over the target.\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "layout(location = 0, index = 0) out highp vec4 oit_out;\n"
    "layout(location = 0, index = 1) out highp vec4 oit_keep;\n"
    "#else\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x), at = OIT_LAID(p) + 5u;\n"
    "    if (oit_pixel[OIT_LEFT(p)] == 0u)\n"
    "        discard;\n"
    "    vec3 sum = uintBitsToFloat(uvec3(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u]));\n"
    "    vec3 through = uintBitsToFloat(uvec3(oit_pixel[at + 3u], oit_pixel[at + 4u], oit_pixel[at + 5u]));\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "    oit_out = vec4(sum, 0.0);\n"
    "    oit_keep = vec4(oit_light.w * through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_FILTER\n"
    "    oit_out = vec4(oit_light.w * through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_LIGHT\n"
    "    oit_out = vec4(sum, 0.0);\n"
    "#else\n"
    "    oit_out = vec4(sum, oit_light.w * through.r);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_lay_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// OIT_STORE_FETCH, after a geometry pass: the layers that it left, laid behind those of the passes before, and taken away for\n"
    "// the next. With OIT_FIRST, before the first: nothing laid yet.\n"
    "#if OIT_FIRST == 0\n"
    "void oit_lay_next(uvec4 layer, inout uvec4 last, inout uint copies)\n"
    "{\n"
    "    if (layer.x == OIT_NONE)\n"
    "        return;\n"
    "    copies = layer == last ? copies + 1u : 1u;\n"
    "    last = layer;\n"
    "    oit_lay(layer, uvec4(0u));\n"
    "}\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x), at = OIT_LAID(p);\n"
    "#if OIT_FIRST\n"
    "    for (uint i = 0u; i < 8u; ++i)\n"
    "        oit_pixel[at + i] = 0u;\n"
    "    for (uint i = 8u; i < 11u; ++i)\n"
    "        oit_pixel[at + i] = floatBitsToUint(1.0);\n"
    "    if (p == 0u && oit_step.x != 0u)\n"
    "        for (uint i = 0u; i < OIT_HEADER; ++i)\n"
    "            oit_pixel[i] = 0u;\n"
    "#else\n"
    "    uvec4 last = uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]);\n"
    "    uint copies = oit_pixel[at + 4u];\n"
    "    if (copies == 0u)\n"
    "        oit_pixel[OIT_LEFT(p)] = oit_seen.y;\n"
    "    for (uint c = 0u; c < 3u; ++c)\n"
    "        oit_sum[c] = uintBitsToFloat(oit_pixel[at + 5u + c]);\n"
    "#if OIT_HAS_BLEND\n"
    "    for (uint c = 0u; c < 3u; ++c)\n"
    "        oit_through[c] = uintBitsToFloat(oit_pixel[at + 8u + c]);\n"
    "#else\n"
    "    oit_through = uintBitsToFloat(oit_pixel[at + 8u]);\n"
    "#endif\n"
    "#define OIT_LAY_NEXT(l) oit_lay_next(l, last, copies);\n"
    "    OIT_EACH_LAYER(OIT_LAY_NEXT)\n"
    "    for (uint c = 0u; c < 4u; ++c)\n"
    "        oit_pixel[at + c] = last[c];\n"
    "    oit_pixel[at + 4u] = copies;\n"
    "    vec3 through = vec3(oit_through);\n"
    "    for (uint c = 0u; c < 3u; ++c) {\n"
    "        oit_pixel[at + 5u + c] = floatBitsToUint(oit_sum[c]);\n"
    "        oit_pixel[at + 8u + c] = floatBitsToUint(through[c]);\n"
    "    }\n"
    "#endif\n"
    "#define OIT_TAKE_AWAY(l) l = uvec4(OIT_NONE);\n"
    "    OIT_EACH_LAYER(OIT_TAKE_AWAY)\n"
    "    oit_seen = uvec2(0u);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What operators are written with, ours and the host's (Carnecky 2013, section 4.5). A fragment is known by its slot: those\n"
    "// of a pixel are first, first + 1, ... from the eye on. After oit_ordered.glsl. The buffer of the surfaces stands at the\n"
    "// binding point of the reports.\n"
    "#ifdef OIT_COMPOSES\n"
    "layout(std430, binding = OIT_BINDING_REPORT) readonly buffer oit_surfaces { uint oit_surface[]; };\n"
    "#else\n"
    "layout(local_size_x = 8, local_size_y = 8) in;\n"
    "layout(std430, binding = OIT_BINDING_REPORT) buffer oit_surfaces { uint oit_surface[]; };\n"
    "#endif\n"
    "// Where the sections lie in it, a word a fragment each; 0: there is none.\n"
    "#ifdef OIT_COMPOSES\n"
    "layout(location = 0) uniform highp uvec4 oit_at[6];\n"
    "layout(location = 8) uniform highp vec4 oit_set[8]; // 0 to 3: of the operator's own\n"
    "#else\n"
    "layout(location = 0) uniform highp uvec4 oit_given_at[6];\n"
    "layout(location = 8) uniform highp vec4 oit_given_set[8];\n"
    "// Taken once: some drivers read a uniform lane by lane, wherever it stands in a loop.\n"
    "highp uvec4 oit_at[6];\n"
    "highp vec4 oit_set[8];\n"
    "void oit_take_numbers()\n"
    "{\n"
    "    for (int i = 0; i < 6; ++i)\n"
    "        oit_at[i] = oit_given_at[i];\n"
    "    for (int i = 0; i < 8; ++i)\n"
    "        oit_set[i] = oit_given_set[i];\n"
    "}\n"
    "#endif\n"
    "#define OIT_IN_ORDER oit_at[0].x   // number of the record\n"
    "#define OIT_IN_LINKS oit_at[0].y   // left, right, down, up: layers of the neighbours in their pixels, 8 bits each\n"
    "#define OIT_IN_FAR_LINKS oit_at[0].z // not 0: 16 bits each, the last two here\n"
    "#define OIT_IN_REACH oit_at[0].w   // beta, gamma: steps to the nearest source, 16 bits each\n"
    "#define OIT_IN_BASE oit_at[1].x\n"
    "#define OIT_IN_KAPPA oit_at[1].y\n"
    "#define OIT_IN_BETA oit_at[1].z    // where it is diffused\n"
    "#define OIT_IN_GAMMA oit_at[1].w\n"
    "#define OIT_IN_BEFORE oit_at[2].x  // what goes on to OIT_IN_AFTER\n"
    "#define OIT_IN_AFTER oit_at[2].y\n"
    "#define OIT_IN_SIZES oit_at[2].z   // how far the surface goes on to the left, right, down, up, 16 bits each; two words\n"
    "#define OIT_IN_GROUPED oit_at[2].w // layers by part, then depth\n"
    "#define OIT_IN_HOST oit_at[3]\n"
    "#define OIT_STEP oit_at[4]         // of the operator's own\n"
    "#define OIT_EXTRA_STEP oit_at[5]\n"
    "\n"
    "#define OIT_LEFTWARD 0u\n"
    "#define OIT_RIGHTWARD 1u\n"
    "#define OIT_DOWNWARD 2u\n"
    "#define OIT_UPWARD 3u\n"
    "#define OIT_UNREACHED 65535u\n"
    "#define OIT_BLOCKED 65534u // kept at 0: nothing passes\n"
    "\n"
    "// How many fragments pixel p has, and the first of their slots. A pixel whose run did not fit has none.\n"
    "uint oit_list(uint p, out uint first)\n"
    "{\n"
    "    uint base, n;\n"
    "    bool fits = oit_find_run(p, base, n);\n"
    "    first = base / uint(OIT_VECTORS);\n"
    "    return fits ? n : 0u;\n"
    "}\n"
    "\n"
    "uint oit_record(uint slot)\n"
    "{\n"
    "    return oit_surface[OIT_IN_ORDER + slot] * uint(OIT_VECTORS);\n"
    "}\n"
    "\n"
    "float oit_record_window_depth(uint at)\n"
    "{\n"
    "#if OIT_REVERSED_Z\n"
    "    return uintBitsToFloat(0x7fffffffu - oit_record_depth(at));\n"
    "#else\n"
    "    return uintBitsToFloat(oit_record_depth(at));\n"
    "#endif\n"
    "}\n"
    "\n"
    "uint oit_record_blend(uint at)\n"
    "{\n"
    "#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8\n"
    "    return OIT_WORD(at, OIT_AT_COLOR) >> 30u;\n"
    "#elif OIT_HAS_BLEND\n"
    "    return OIT_WORD(at, OIT_AT_BLEND) & 255u;\n"
    "#else\n"
    "    return 0u;\n"
    "#endif\n"
    "}\n"
    "\n"
    "vec4 oit_record_color(uint at)\n"
    "{\n"
    "#if OIT_COLOR == OIT_COLOR_FLOAT\n"
    "    return oit_unpack_color(uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), OIT_WORD(at, OIT_AT_COLOR + 2),\n"
    "                                  OIT_WORD(at, OIT_AT_COLOR + 3)));\n"
    "#else\n"
    "    return oit_unpack_color(uvec4(OIT_WORD(at, OIT_AT_COLOR), OIT_WORD(at, OIT_AT_COLOR + 1), 0u, 0u));\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if OIT_HAS_NORMAL\n"
    "vec3 oit_record_normal(uint at)\n"
    "{\n"
    "    vec2 folded = unpackSnorm2x16(OIT_WORD(at, OIT_AT_NORMAL));\n"
    "    vec3 n = vec3(folded, 1.0 - abs(folded.x) - abs(folded.y));\n"
    "    float under = max(-n.z, 0.0);\n"
    "    n.xy -= vec2(n.x >= 0.0 ? under : -under, n.y >= 0.0 ? under : -under);\n"
    "    return normalize(n);\n"
    "}\n"
    "#endif\n"
    "\n"
    "// ---- of a fragment ----\n"
    "\n"
    "float oit_depth(uint slot) // window depth\n"
    "{\n"
    "    return oit_record_window_depth(oit_record(slot));\n"
    "}\n"
    "\n"
    "vec4 oit_color(uint slot) // as it was stored\n"
    "{\n",
    "#line 116\n"
    "    return oit_record_color(oit_record(slot));\n"
    "}\n"
    "\n"
    "bool oit_is_surface(uint slot)\n"
    "{\n"
    "#if OIT_HAS_BLEND\n"
    "    return oit_record_blend(oit_record(slot)) == 0u;\n"
    "#else\n"
    "    return true;\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if OIT_HAS_NORMAL\n"
    "vec3 oit_normal(uint slot)\n"
    "{\n"
    "    return oit_record_normal(oit_record(slot));\n"
    "}\n"
    "#endif\n"
    "#if OIT_HAS_PART\n"
    "uint oit_part_of(uint slot)\n"
    "{\n"
    "    return OIT_WORD(oit_record(slot), OIT_AT_PART);\n"
    "}\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "vec2 oit_uv(uint slot)\n"
    "{\n"
    "    uint at = oit_record(slot);\n"
    "    return vec2(uintBitsToFloat(OIT_WORD(at, OIT_AT_UV)), uintBitsToFloat(OIT_WORD(at, OIT_AT_UV + 1)));\n"
    "}\n"
    "#endif\n"
    "#if OIT_HAS_SLOPE\n"
    "vec2 oit_slope(uint slot) // of the window depth, a pixel to the right and a pixel up\n"
    "{\n"
    "    return unpackHalf2x16(OIT_WORD(oit_record(slot), OIT_AT_SLOPE)) * (1.0 / 4096.0);\n"
    "}\n"
    "#endif\n"
    "\n"
    "// ---- neighbours ----\n"
    "\n"
    "// The pixel beside p; false: the image ends there.\n"
    "bool oit_beside(uint p, uint direction, out uint q)\n"
    "{\n"
    "    uint width = uint(oit_area.z);\n"
    "    q = direction == OIT_LEFTWARD ? p - 1u : direction == OIT_RIGHTWARD ? p + 1u : direction == OIT_DOWNWARD ? p - width : p + width;\n"
    "    if (direction < 2u)\n"
    "        return direction == OIT_LEFTWARD ? p % width != 0u : q % width != 0u;\n"
    "    return direction == OIT_DOWNWARD ? p >= width : q < oit_pool.x;\n"
    "}\n"
    "\n"
    "// Layer of the neighbour within its pixel; OIT_NONE: there is no neighbour.\n"
    "uint oit_link(uint slot, uint direction)\n"
    "{\n"
    "    bool wide = OIT_IN_FAR_LINKS != 0u; // without a branch: some drivers go both ways\n"
    "    uint word = oit_surface[(wide && direction >= 2u ? OIT_IN_FAR_LINKS : OIT_IN_LINKS) + slot];\n"
    "    uint none = wide ? 65535u : 255u, layer = word >> (wide ? 16u * (direction & 1u) : 8u * direction) & none;\n"
    "    return layer == none ? OIT_NONE : layer;\n"
    "}\n"
    "\n"
    "// Slot of the neighbour of a fragment of pixel p, or OIT_NONE.\n"
    "uint oit_neighbour(uint p, uint slot, uint direction)\n"
    "{\n"
    "    uint layer = oit_link(slot, direction), q, first;\n"
    "    if (layer == OIT_NONE || !oit_beside(p, direction, q))\n"
    "        return OIT_NONE;\n"
    "    oit_list(q, first);\n"
    "    return first + layer;\n"
    "}\n"
    "\n"
    "// ---- values ----\n"
    "\n"
    "#define OIT_BASE 0u\n"
    "#define OIT_BETA 1u\n"
    "#define OIT_GAMMA 2u\n"
    "#define OIT_KAPPA 3u\n"
    "#define OIT_HOST 4u // + k\n"
    "\n"
    "// Of equation 9 after n steps from 1 at the sources: the distance says it all.\n"
    "float oit_reached(uint distance, uint n, float lambda)\n"
    "{\n"
    "    return distance <= n ? max(1.0 - lambda * float(distance), 0.0) : 0.0;\n"
    "}\n"
    "\n"
    "// What lambda has to be for a field to end within its share of the surface's width (oit_set[7].z), which is the distance\n"
    "// between the fragments with boundary conditions on either side along the row, or the column if that is less. Distances\n"
    "// beyond oit_set[7].w are not known for certain: there it is wide.\n"
    "float oit_steepest(uint slot, float lambda)\n"
    "{\n"
    "    float width = 1.0e9;\n"
    "    for (uint axis = 0u; axis < 2u; ++axis) {\n"
    "        uint word = oit_surface[(axis == 0u ? OIT_IN_SIZES : OIT_EXTRA_STEP.z) + slot];\n"
    "        uvec2 sides = uvec2(word & 65535u, word >> 16u);\n"
    "        if (float(max(sides.x, sides.y)) <= oit_set[7].w)\n"
    "            width = min(width, float(sides.x + sides.y));\n"
    "    }\n"
    "    return max(lambda, 1.0 / max(oit_set[7].z * width, 1.0));\n"
    "}\n"
    "\n"
    "uint oit_steps(uint slot, bool gamma)\n"
    "{\n"
    "    return oit_surface[OIT_IN_REACH + slot] >> (gamma ? 16u : 0u) & 65535u;\n"
    "}\n"
    "\n"
    "// A value before its profile.\n"
    "float oit_value(uint which, uint slot)\n"
    "{\n"
    "    if (which >= OIT_HOST)\n"
    "        return uintBitsToFloat(oit_surface[OIT_IN_HOST[which - OIT_HOST] + slot]);\n"
    "    if (which == OIT_BASE)\n"
    "        return uintBitsToFloat(oit_surface[OIT_IN_BASE + slot]);\n"
    "    if (which == OIT_KAPPA)\n"
    "        return uintBitsToFloat(oit_surface[OIT_IN_KAPPA + slot]);\n"
    "    bool gamma = which == OIT_GAMMA;\n"
    "    uint diffused = gamma ? OIT_IN_GAMMA : OIT_IN_BETA;\n"
    "    if (diffused != 0u)\n"
    "        return uintBitsToFloat(oit_surface[diffused + slot]);\n"
    "    float lambda = gamma ? oit_set[7].y : oit_set[7].x;\n"
    "    if (oit_set[7].z > 0.0)\n"
    "        lambda = oit_steepest(slot, lambda);\n",
    "#line 235\n"
    "    return oit_reached(oit_steps(slot, gamma), gamma ? OIT_EXTRA_STEP.y : OIT_EXTRA_STEP.x, lambda);\n"
    "}\n"
    "\n"
    "#ifndef OIT_COMPOSES\n"
    "// OIT_BASE and OIT_HOST + k; NaN and infinities become 0, and base is cut to [0,1].\n"
    "void oit_set_value(uint which, uint slot, float x)\n"
    "{\n"
    "    uint bits = floatBitsToUint(x);\n"
    "    x = (bits & 0x7f800000u) == 0x7f800000u ? 0.0 : x;\n"
    "    if (which == OIT_BASE)\n"
    "        oit_surface[OIT_IN_BASE + slot] = floatBitsToUint(clamp(x, 0.0, 1.0));\n"
    "    else\n"
    "        oit_surface[OIT_IN_HOST[which - OIT_HOST] + slot] = floatBitsToUint(x);\n"
    "}\n"
    "\n"
    "// Of an operator with iterations.\n"
    "float oit_before(uint slot)\n"
    "{\n"
    "    return uintBitsToFloat(oit_surface[OIT_IN_BEFORE + slot]);\n"
    "}\n"
    "\n"
    "void oit_set_after(uint slot, float x)\n"
    "{\n"
    "    uint bits = floatBitsToUint(x);\n"
    "    oit_surface[OIT_IN_AFTER + slot] = (bits & 0x7f800000u) == 0x7f800000u ? 0u : bits;\n"
    "}\n"
    "#endif\n"
    "\n"
    "// ---- where a fragment is ----\n"
    "\n"
    "// Distance along the view of a window depth: equations of clip z and w solved for the eye's z, by oit_i_operator_view.\n"
    "float oit_distance(float depth)\n"
    "{\n"
    "    return (oit_set[4].x + oit_set[4].y * depth) / (oit_set[4].z + oit_set[4].w * depth);\n"
    "}\n"
    "\n"
    "vec2 oit_device(uint p)\n"
    "{\n"
    "    uint width = uint(oit_area.z);\n"
    "    return (2.0 * vec2(float(p % width), float(p / width)) + 1.0) / vec2(oit_area.zw) - 1.0;\n"
    "}\n"
    "\n"
    "// In the space of the eye.\n"
    "vec3 oit_position(vec2 device, float depth)\n"
    "{\n"
    "    float z = -oit_distance(depth);\n"
    "    return vec3(device * (oit_set[6].x * z + oit_set[6].y) * oit_set[5].xy - oit_set[5].zw * z - oit_set[6].zw, z);\n"
    "}\n"
    "\n"
    "// Toward the eye: how x and y change along the ray of a pixel, by z.\n"
    "vec3 oit_to_eye(vec2 device)\n"
    "{\n"
    "    return normalize(vec3(device * oit_set[6].x * oit_set[5].xy - oit_set[5].zw, 1.0));\n"
    "}\n"
    "\n"
    "#ifndef OIT_COMPOSES\n"
    "void oit_operate(uint p);\n"
    "\n"
    "#ifndef OIT_OWN_MAIN\n"
    "void main()\n"
    "{\n"
    "    oit_take_numbers();\n"
    "    uvec2 where = gl_GlobalInvocationID.xy;\n"
    "    if (where.x < uint(oit_area.z) && where.y < uint(oit_area.w))\n"
    "        oit_operate(where.y * uint(oit_area.z) + where.x);\n"
    "}\n"
    "#endif\n"
    "#endif\n",
    0};
static const char *const oit_i_shader_oit_operator_bound_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Boundary conditions of beta and gamma (Carnecky 2013, section 5.3): a missing neighbour (red) makes beta 1, being\n"
    "// underneath (green) keeps it 0, being before (blue) makes gamma 1. By layer indices, surfaces only, and without the\n"
    "// differences that linked surfaces make which merely change places: what is left is surfaces that begin on the way to the\n"
    "// neighbour less those that end on it. OIT_STEP: x: 1: plain indices (published); y: 1: nothing is kept at 0, since equation\n"
    "// 9 as published has no b; equation 8 has; z: as OIT_STEP.w of jumps.\n"
    "\n"
    "// Of those before `layer` in the list: how many are surfaces without a link that way; or, published, how many surfaces.\n"
    "// Kept from one call to the next, since layers mostly ascend.\n"
    "struct oit_ends\n"
    "{\n"
    "    uint layer, count;\n"
    "};\n"
    "\n"
    "uint oit_is_end(uint slot, uint direction)\n"
    "{\n"
    "    if (!oit_is_surface(slot))\n"
    "        return 0u;\n"
    "    return OIT_STEP.x != 0u || oit_link(slot, direction) == OIT_NONE ? 1u : 0u;\n"
    "}\n"
    "\n"
    "uint oit_ends_before(inout oit_ends ends, uint first, uint layer, uint direction)\n"
    "{\n"
    "    for (; ends.layer < layer; ++ends.layer)\n"
    "        ends.count += oit_is_end(first + ends.layer, direction);\n"
    "    for (; ends.layer > layer; --ends.layer)\n"
    "        ends.count -= oit_is_end(first + ends.layer - 1u, direction);\n"
    "    return ends.count;\n"
    "}\n"
    "\n"
    "// Bits by fragment: 1: a link is missing, 2: an index falls, 4: one rises. Collected in the word of the reach.\n"
    "void oit_bound_along(uint p, uint first, uint n, uint direction)\n"
    "{\n"
    "    uint q, other;\n"
    "    if (!oit_beside(p, direction, q))\n"
    "        return;\n"
    "    oit_list(q, other);\n"
    "    oit_ends there = oit_ends(0u, 0u);\n"
    "    uint here = 0u;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint layer = oit_link(first + i, direction), bits = 1u;\n"
    "        if (layer != OIT_NONE) {\n"
    "            uint ends = oit_ends_before(there, other, layer, direction ^ 1u);\n"
    "            bits = ends > here ? 4u : ends < here ? 2u : 0u;\n"
    "        }\n"
    "        here += oit_is_end(first + i, direction);\n"
    "        oit_surface[OIT_IN_REACH + first + i] |= bits;\n"
    "    }\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        oit_surface[OIT_IN_REACH + first + i] = 0u;\n"
    "    for (uint direction = 0u; direction < 4u; ++direction)\n"
    "        oit_bound_along(p, first, n, direction);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint slot = first + i, bits = oit_is_surface(slot) ? oit_surface[OIT_IN_REACH + slot] : 0u;\n"
    "        bool missing = (bits & 1u) != 0u, under = (bits & 2u) != 0u && OIT_STEP.y == 0u, before = (bits & 4u) != 0u;\n"
    "        oit_surface[OIT_IN_REACH + slot] =\n"
    "            (missing ? 0u : under ? OIT_BLOCKED : OIT_UNREACHED) | (before ? 0u : OIT_UNREACHED) << 16u;\n"
    "        if (OIT_IN_BETA != 0u)\n"
    "            oit_surface[OIT_IN_BETA + slot] = floatBitsToUint(missing ? 1.0 : 0.0);\n"
    "        if (OIT_IN_GAMMA != 0u)\n"
    "            oit_surface[OIT_IN_GAMMA + slot] = floatBitsToUint(before ? 1.0 : 0.0);\n"
    "    }\n"
    "    uvec2 at = uvec2(p % uint(oit_area.z), p / uint(oit_area.z));\n"
    "    if (OIT_STEP.z != 0u && all(equal(at & 31u, uvec2(0u)))) // no pass of jumps has changed anything there\n"
    "        oit_surface[OIT_STEP.z + at.y / 32u * ((uint(oit_area.z) + 31u) / 32u) + at.x / 32u] = 0u;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_chain_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Many iterations of equation 8 at once, along rows or along columns: the binomial weights of so many steps, over the\n"
    "// fragments that up to seven links lead to. Where the surface ends the walk turns back, which is what leaving out a link's\n"
    "// term does in each step. Rows after columns are not quite both at a time: the error is in docs/smart.md.\n"
    "// A work item takes 32 pixels in turn and follows each chain of links through them once, with what lies around in\n"
    "// registers: a link and a value are read for each fragment, however wide the weights. Links are mutual. OIT_STEP: x: 0\n"
    "// rows, 1 columns; oit_set[0], oit_set[1]: weights of the fragment itself, of one link each way, ...\n"
    "#define OIT_OWN_MAIN 1\n"
    "const uint oit_reach = 32u, oit_wide = 7u;\n"
    "uint oit_firsts[46], oit_counts[46]; // of the 32 pixels, and of seven on either side\n"
    "\n"
    "// One link on from a fragment of a pixel, or turned where there is none.\n"
    "struct oit_walker\n"
    "{\n"
    "    uint slot, place, direction;\n"
    "};\n"
    "\n"
    "uint oit_ahead()\n"
    "{\n"
    "    return 2u * OIT_STEP.x + 1u;\n"
    "}\n"
    "\n"
    "// False where the chain ends. Without a branch: some drivers go both ways.\n"
    "bool oit_walk(inout oit_walker w)\n"
    "{\n"
    "    uint layer = oit_link(w.slot, w.direction), place = w.direction == oit_ahead() ? w.place + 1u : w.place - 1u;\n"
    "    bool on = layer != OIT_NONE;\n"
    "    w.direction = on ? w.direction : w.direction ^ 1u;\n"
    "    w.place = on ? place : w.place;\n"
    "    w.slot = on ? oit_firsts[w.place] + layer : w.slot;\n"
    "    return on;\n"
    "}\n"
    "\n"
    "// What lies around the fragment that is written next, seven links each way, and the slots of those ahead.\n"
    "float oit_around[15];\n"
    "uint oit_slots[8];\n"
    "\n"
    "void oit_take(uint slot)\n"
    "{\n"
    "    for (int k = 0; k < 14; ++k)\n"
    "        oit_around[k] = oit_around[k + 1];\n"
    "    for (int k = 0; k < 7; ++k)\n"
    "        oit_slots[k] = oit_slots[k + 1];\n"
    "    oit_around[14] = oit_before(slot);\n"
    "    oit_slots[7] = slot;\n"
    "}\n"
    "\n"
    "float oit_weigh()\n"
    "{\n"
    "    float sum = oit_around[7] * oit_set[0].x;\n"
    "    sum += (oit_around[6] + oit_around[8]) * oit_set[0].y;\n"
    "    sum += (oit_around[5] + oit_around[9]) * oit_set[0].z;\n"
    "    sum += (oit_around[4] + oit_around[10]) * oit_set[0].w;\n"
    "    sum += (oit_around[3] + oit_around[11]) * oit_set[1].x;\n"
    "    sum += (oit_around[2] + oit_around[12]) * oit_set[1].y;\n"
    "    sum += (oit_around[1] + oit_around[13]) * oit_set[1].z;\n"
    "    return sum + (oit_around[0] + oit_around[14]) * oit_set[1].w;\n"
    "}\n"
    "\n"
    "// From where the chain begins or comes into the stretch to where either ends: at most `left` fragments.\n"
    "void oit_follow(uint slot, uint place, uint left)\n"
    "{\n"
    "    oit_walker w = oit_walker(slot, place, oit_ahead() ^ 1u);\n"
    "    for (uint k = 0u; k < oit_wide; ++k) { // where the next eight push them to\n"
    "        oit_walk(w);\n"
    "        for (int i = 14; i > 8; --i)\n"
    "            oit_around[i] = oit_around[i - 1];\n"
    "        oit_around[8] = oit_before(w.slot);\n"
    "    }\n"
    "    w = oit_walker(slot, place, oit_ahead());\n"
    "    oit_take(slot);\n"
    "    for (uint k = 1u; left > 0u; ++k) {\n"
    "        left = oit_walk(w) ? left : min(left, min(k, oit_wide));\n"
    "        oit_take(w.slot);\n"
    "        if (k >= oit_wide) {\n"
    "            oit_set_after(oit_slots[0], oit_weigh());\n"
    "            --left;\n"
    "        }\n"
    "    }\n"
    "}\n"
    "\n"
    "// On to where a chain begins or comes into the stretch, from the i-th of the pixel at `place` on. False: there is none.\n"
    "bool oit_find(inout uint place, inout uint i, uint end)\n"
    "{\n"
    "    while (place < end) {\n"
    "        bool there = i < oit_counts[place];\n"
    "        if (there && (place == oit_wide || oit_link(oit_firsts[place] + i, oit_ahead() ^ 1u) == OIT_NONE))\n"
    "            return true;\n"
    "        i = there ? i + 1u : 0u;\n"
    "        place = there ? place : place + 1u;\n"
    "    }\n"
    "    return false;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    oit_take_numbers();\n"
    "    uvec2 size = uvec2(oit_area.zw), at = gl_GlobalInvocationID.xy;\n"
    "    bool column = OIT_STEP.x != 0u;\n"
    "    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x); // x is what is long\n"
    "    if (any(greaterThanEqual(start, size)))\n"
    "        return;\n",
    "#line 103\n"
    "    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u, from = column ? start.y : start.x;\n"
    "    uint rest = (column ? size.y : size.x) - from, end = oit_wide + min(oit_reach, rest);\n"
    "    for (uint k = oit_wide - min(oit_wide, from); k < oit_wide + min(oit_reach + oit_wide, rest); ++k)\n"
    "        oit_counts[k] = oit_list(p + k * stride - oit_wide * stride, oit_firsts[k]);\n"
    "    for (uint place = oit_wide, i = 0u; oit_find(place, i, end); ++i)\n"
    "        oit_follow(oit_firsts[place] + i, place, end - place);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_compose_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The pixels' runs in the order of their slots over the target, each surface with the opacity that the operators made\n"
    "// (Carnecky 2013, section 5.5, algorithm 3) and shaded by its curvature (Murray 2016, section 5.2). OIT_STEP: x: bits: 1:\n"
    "// base, 2: beta and gamma, 4: shade, 8: algorithm 3 as printed, 16: contours; y, z: profiles of beta and gamma; oit_set[0]:\n"
    "// their p; oit_set[2]: colour of contours.\n"
    "// OIT_EXTRA_STEP and oit_set[7]: as oit_value says.\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "layout(location = 0, index = 0) out highp vec4 oit_out;\n"
    "layout(location = 0, index = 1) out highp vec4 oit_keep;\n"
    "#else\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "#endif\n"
    "layout(location = 16) uniform highp vec4 oit_shades[32];\n"
    "#if OIT_HAS_BLEND\n"
    "#define OIT_THROUGH vec3\n"
    "#else\n"
    "#define OIT_THROUGH float\n"
    "#endif\n"
    "vec3 oit_sum = vec3(0.0);\n"
    "OIT_THROUGH oit_through = OIT_THROUGH(1.0);\n"
    "uint oit_here = 0u; // the pixel\n"
    "\n"
    "bool oit_visible()\n"
    "{\n"
    "#if OIT_HAS_BLEND\n"
    "    return max(oit_through.r, max(oit_through.g, oit_through.b)) > 5.9604645e-8;\n"
    "#else\n"
    "    return oit_through > 5.9604645e-8;\n"
    "#endif\n"
    "}\n"
    "\n"
    "// e^x - 1, whose difference loses its digits near 0.\n"
    "float oit_expm1(float x)\n"
    "{\n"
    "    return abs(x) < 0.01 ? x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0)))) : exp(x) - 1.0;\n"
    "}\n"
    "\n"
    "// Equations 10 and 11. 1 - (1 - u)^2 is u (2 - u): nothing cancels, and p = 0 is the limit.\n"
    "float oit_profile(uint kind, float u, float p)\n"
    "{\n"
    "    if (kind == 0u || u <= 0.0 || u >= 1.0)\n"
    "        return clamp(u, 0.0, 1.0);\n"
    "    if (kind == 2u)\n"
    "        return p > 0.0 ? pow(u, p) : 1.0;\n"
    "    float v = u * (2.0 - u);\n"
    "    return p > 1.0e-6 ? exp(p * (v - 1.0)) * oit_expm1(-p * v) / oit_expm1(-p) : v;\n"
    "}\n"
    "\n"
    "float oit_halo(uint slot)\n"
    "{\n"
    "    return oit_profile(OIT_STEP.z, oit_value(OIT_GAMMA, slot), oit_set[0].y);\n"
    "}\n"
    "\n"
    "float oit_outline(uint slot)\n"
    "{\n"
    "    return oit_profile(OIT_STEP.y, oit_value(OIT_BETA, slot), oit_set[0].x);\n"
    "}\n"
    "\n"
    "vec3 oit_shade(float kappa)\n"
    "{\n"
    "    float at = clamp(0.5 * kappa + 0.5, 0.0, 1.0) * 31.0;\n"
    "    uint cell = min(uint(at), 30u);\n"
    "    return mix(oit_shades[cell].rgb, oit_shades[cell + 1u].rgb, at - float(cell));\n"
    "}\n"
    "\n"
    "// rgb not multiplied by alpha, and the fragment's opacity.\n"
    "vec4 oit_surface_color(uint slot, vec4 color)\n"
    "{\n"
    "    uint what = OIT_STEP.x;\n"
    "    if ((what & 1u) != 0u)\n"
    "        color.a = oit_value(OIT_BASE, slot);\n"
    "    float line = 0.0;\n"
    "#if OIT_CONTOURS\n"
    "    if ((what & 16u) != 0u)\n"
    "        line = oit_contour(oit_here, slot);\n"
    "    color.a += (1.0 - color.a) * line;\n"
    "#endif\n"
    "    if ((what & 2u) != 0u)\n"
    "        color.a = (1.0 - oit_halo(slot)) * (color.a + (1.0 - color.a) * oit_outline(slot));\n"
    "    if ((what & 4u) != 0u)\n"
    "        color.rgb *= oit_shade(oit_value(OIT_KAPPA, slot));\n"
    "    color.rgb = mix(color.rgb, oit_set[2].rgb, line);\n"
    "    return color;\n"
    "}\n"
    "\n"
    "void oit_lay(uint slot)\n"
    "{\n"
    "    uint at = oit_record(slot), blend = oit_record_blend(at);\n"
    "    vec4 color = oit_record_color(at);\n"
    "    float printed = color.a;\n"
    "#if OIT_PREMULTIPLIED\n"
    "    color.rgb = color.a > 0.0 ? color.rgb / color.a : vec3(0.0);\n"
    "#endif\n"
    "    if (blend == 0u) {\n"
    "        color = oit_surface_color(slot, color);\n"
    "        printed = (OIT_STEP.x & 8u) != 0u && (OIT_STEP.x & 1u) != 0u ? oit_value(OIT_BASE, slot) : color.a;\n"
    "    }\n"
    "    vec3 light = color.a * color.rgb;\n"
    "#if OIT_HAS_BLEND\n"
    "    if (blend == 2u) { // multiply: seen through a filter of that colour\n"
    "        oit_through *= 1.0 - color.a + light;\n"
    "        return;\n"
    "    }\n"
    "    oit_sum += oit_through * light;\n"
    "    if (blend == 1u) // add: light, which hides nothing\n"
    "        return;\n"
    "#else\n"
    "    oit_sum += oit_through * light;\n"
    "#endif\n"
    "    oit_through *= 1.0 - printed;\n"
    "}\n"
    "\n"
    "#if OIT_KEEPS\n"
    "// Behind what is kept, all that is not.\n"
    "void oit_lay_tail(uint p)\n"
    "{\n"
    "    if (oit_pixel[OIT_LIMIT(p)] == OIT_NONE)\n"
    "        return;\n"
    "    vec4 tail = oit_tail_light(oit_tail_sums(p));\n"
    "    oit_sum += oit_through * tail.rgb;\n"
    "    oit_through *= tail.a;\n"
    "}\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n",
    "#line 128\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x), first, n = oit_list(p, first);\n"
    "    if (n == 0u)\n"
    "        discard;\n"
    "    oit_here = p;\n"
    "    for (uint i = 0u; i < n && oit_visible(); ++i)\n"
    "        oit_lay(first + i);\n"
    "#if OIT_KEEPS\n"
    "    oit_lay_tail(p);\n"
    "#endif\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "    oit_out = vec4(oit_sum, 0.0);\n"
    "    oit_keep = vec4(oit_light.w * oit_through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_FILTER\n"
    "    oit_out = vec4(oit_light.w * oit_through, 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_LIGHT\n"
    "    oit_out = vec4(oit_sum, 0.0);\n"
    "#else\n"
    "    oit_out = vec4(oit_sum, oit_light.w * oit_through);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_connect_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What each surface fragment likes best of the pixels beside its own (Carnecky 2013, section 4.4, equations 1 to 3; Murray\n"
    "// 2016, section 5.1), found by looking at all of them. Whether that is mutual is seen in a pass after this, when all have\n"
    "// chosen. After oit_operator_pairs.glsl. OIT_STEP: x: direction; z: criterion.\n"
    "#define OIT_BY_DEPTH 0u\n"
    "#define OIT_BY_UV 1u\n"
    "#define OIT_PUBLISHED 2u\n"
    "#define OIT_MURRAY 3u\n"
    "\n"
    "oit_side oit_look_toward(uint slot, uint direction)\n"
    "{\n"
    "    return oit_toward(oit_look(slot), direction);\n"
    "}\n"
    "\n"
    "float oit_measure(oit_side side, uint slot)\n"
    "{\n"
    "    uint at = oit_record(slot);\n"
    "    if (!oit_may_join(side, at))\n"
    "        return OIT_NEVER;\n"
    "#if OIT_HAS_UV\n"
    "    if (OIT_STEP.z == OIT_BY_UV) {\n"
    "        float apart = distance(side.uv, oit_uv(slot));\n"
    "        return apart <= OIT_LIMIT_APART ? apart : OIT_NEVER;\n"
    "    }\n"
    "#endif\n"
    "    if (OIT_STEP.z == OIT_MURRAY) {\n"
    "        float gap = side.depth - oit_record_window_depth(at);\n"
    "        return oit_bend(side, at) + gap * gap;\n"
    "    }\n"
    "    return oit_measure_by_depth(side, at, oit_apart(side, at));\n"
    "}\n"
    "\n"
    "// All of the list; of several that measure the same the nearest to the eye.\n"
    "uint oit_best_of_all(oit_side side, uint first, uint n, out float least)\n"
    "{\n"
    "    uint best = OIT_NONE;\n"
    "    least = OIT_NEVER;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        float measure = oit_measure(side, first + i);\n"
    "        best = measure < least ? i : best;\n"
    "        least = measure < least ? measure : least;\n"
    "    }\n"
    "    return best;\n"
    "}\n"
    "\n"
    "// The same for a list that is grouped by part: only that part is looked at (Murray 2016, section 5.1).\n"
    "uint oit_best_of_part(oit_side side, uint first, uint n, out float least)\n"
    "{\n"
    "    uint best = OIT_NONE, low = 0u;\n"
    "    for (uint high = n; low < high;) { // where its group begins\n"
    "        uint middle = (low + high) / 2u;\n"
    "        if (oit_part_of(first + oit_surface[OIT_IN_GROUPED + first + middle]) < side.part)\n"
    "            low = middle + 1u;\n"
    "        else\n"
    "            high = middle;\n"
    "    }\n"
    "    least = OIT_NEVER;\n"
    "    for (; low < n; ++low) {\n"
    "        uint i = oit_surface[OIT_IN_GROUPED + first + low];\n"
    "        if (oit_part_of(first + i) != side.part)\n"
    "            break;\n"
    "        float measure = oit_measure(side, first + i);\n"
    "        best = measure < least ? i : best;\n"
    "        least = measure < least ? measure : least;\n"
    "    }\n"
    "    return best;\n"
    "}\n"
    "\n"
    "// Algorithm 2, lines 12 to 17: none of the list to which i belongs may measure less toward the same candidate.\n"
    "bool oit_published_holds(uint first, uint n, uint i, uint candidate, uint direction, float least)\n"
    "{\n"
    "    for (uint k = 0u; k < n; ++k)\n"
    "        if (k != i && oit_is_surface(first + k) && oit_measure(oit_look_toward(first + k, direction), candidate) < least)\n"
    "            return false;\n"
    "    return true;\n"
    "}\n"
    "\n"
    "void oit_set_link(uint slot, uint direction, uint layer)\n"
    "{\n"
    "    bool wide = OIT_IN_FAR_LINKS != 0u;\n"
    "    uint bits = wide ? 16u : 8u, none = (1u << bits) - 1u, shift = bits * (wide ? direction & 1u : direction);\n"
    "    uint at = (wide && direction >= 2u ? OIT_IN_FAR_LINKS : OIT_IN_LINKS) + slot;\n"
    "    oit_surface[at] = (oit_surface[at] & ~(none << shift)) | min(layer, none) << shift;\n"
    "}\n"
    "\n"
    "uint oit_choose(uint first, uint n, uint i, uint direction, uint other, uint m)\n"
    "{\n"
    "    float least;\n"
    "    oit_side side = oit_look_toward(first + i, direction);\n"
    "    uint best = (OIT_STEP.w & OIT_CHOOSE_GROUPED) != 0u ? oit_best_of_part(side, other, m, least)\n"
    "                                                        : oit_best_of_all(side, other, m, least);\n"
    "    if (OIT_STEP.z == OIT_PUBLISHED && best != OIT_NONE && oit_set[1].x == 0.0 &&\n"
    "        !oit_published_holds(first, n, i, other + best, direction, least))\n"
    "        best = OIT_NONE;\n"
    "    return best;\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint direction = OIT_STEP.x, first, n = oit_list(p, first), q, other;\n"
    "    uint m = oit_beside(p, direction, q) ? oit_list(q, other) : 0u;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint best = OIT_NONE;\n"
    "        if (m > 0u && oit_is_surface(first + i))\n",
    "#line 105\n"
    "            best = oit_choose(first, n, i, direction, other, m);\n"
    "        oit_set_link(first + i, direction, best);\n"
    "    }\n"
    "    if ((OIT_STEP.w & OIT_CHOOSE_COUNTS) != 0u)\n"
    "        atomicAdd(oit_surface[0], oit_pairs);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_curve_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Curvature of the surface at a fragment, tanh(kappa1 + kappa2) (Murray 2016, section 5.1), and opacity from it. The trace\n"
    "// of the map from steps along the surface to differences of normals: no division by a normal's z, so that grazing normals\n"
    "// are bounded. Without one of the four neighbours -1. OIT_STEP: x: 1: the opacities go to base; oit_set[0]: x: 1 / unit, 0:\n"
    "// steps are those in the window; y, z: distance to depth. OIT_STEP.y: 1: the curvature toward the eye, too.\n"
    "layout(location = 16) uniform highp uvec4 oit_opacities[64]; // 16 rows of 32 in 16 bits each\n"
    "\n"
    "float oit_opacity_entry(uint at)\n"
    "{\n"
    "    uint word = oit_opacities[at >> 3u][at >> 1u & 3u];\n"
    "    return float((at & 1u) != 0u ? word >> 16u : word & 65535u) * (1.0 / 65535.0);\n"
    "}\n"
    "\n"
    "float oit_opacity(float curvature, float depth)\n"
    "{\n"
    "    vec2 at = vec2(clamp(curvature, 0.0, 1.0) * 31.0, clamp(depth, 0.0, 1.0) * 15.0);\n"
    "    uvec2 cell = min(uvec2(at), uvec2(30u, 14u));\n"
    "    vec2 within = at - vec2(cell);\n"
    "    uint from = cell.y * 32u + cell.x;\n"
    "    return mix(mix(oit_opacity_entry(from), oit_opacity_entry(from + 1u), within.x),\n"
    "               mix(oit_opacity_entry(from + 32u), oit_opacity_entry(from + 33u), within.x), within.y);\n"
    "}\n"
    "\n"
    "float oit_trace(vec3 t[2], vec3 dn[2])\n"
    "{\n"
    "    float a = dot(t[0], t[0]), b = dot(t[0], t[1]), c = dot(t[1], t[1]), square = a * c - b * b;\n"
    "    if (!(square > 1.0e-6 * a * c))\n"
    "        return 0.0;\n"
    "    return -(c * dot(dn[0], t[0]) - b * (dot(dn[0], t[1]) + dot(dn[1], t[0])) + a * dot(dn[1], t[1])) / square;\n"
    "}\n"
    "\n"
    "float oit_kappa(uint p, uint slot)\n"
    "{\n"
    "    vec3 t[2] = vec3[2](vec3(2.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0)), dn[2];\n"
    "    for (uint axis = 0u; axis < 2u; ++axis) {\n"
    "        uint low = oit_neighbour(p, slot, 2u * axis), high = oit_neighbour(p, slot, 2u * axis + 1u), q, r;\n"
    "        if (low == OIT_NONE || high == OIT_NONE)\n"
    "            return -1.0;\n"
    "        dn[axis] = oit_normal(high) - oit_normal(low);\n"
    "        if (oit_set[0].x > 0.0) {\n"
    "            oit_beside(p, 2u * axis, q);\n"
    "            oit_beside(p, 2u * axis + 1u, r);\n"
    "            t[axis] = (oit_position(oit_device(r), oit_depth(high)) - oit_position(oit_device(q), oit_depth(low))) * oit_set[0].x;\n"
    "        }\n"
    "    }\n"
    "    return tanh(clamp(oit_trace(t, dn), -20.0, 20.0));\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint slot = first + i;\n"
    "        bool surface = oit_is_surface(slot);\n"
    "        float kappa = surface ? oit_kappa(p, slot) : 0.0;\n"
    "        oit_surface[OIT_IN_KAPPA + slot] = floatBitsToUint(kappa);\n"
    "#if OIT_CONTOURS\n"
    "        if (OIT_STEP.y != 0u)\n"
    "            oit_surface[OIT_IN_RADIAL + slot] = floatBitsToUint(surface ? oit_radial(p, slot) : 0.0);\n"
    "#endif\n"
    "        if (OIT_STEP.x != 0u && surface)\n"
    "            oit_set_value(OIT_BASE, slot, oit_opacity(abs(kappa), (oit_distance(oit_depth(slot)) - oit_set[0].y) * oit_set[0].z));\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_group_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Layers of each pixel by part, and by depth within a part (Murray 2016, section 4.1: buckets), for searches that look at\n"
    "// one part alone.\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint part = oit_part_of(first + i), before = 0u;\n"
    "        for (uint k = 0u; k < n; ++k) {\n"
    "            uint other = oit_part_of(first + k);\n"
    "            before += other < part || (other == part && k < i) ? 1u : 0u;\n"
    "        }\n"
    "        oit_surface[OIT_IN_GROUPED + first + before] = i;\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_jump_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Distances carried 32 pixels along a row or a column in one pass, both ways: a work item takes a stretch of 32 pixels in\n"
    "// turn, where they lie. Stretches side by side take turns, too: what lies beyond the ends of one does not change while it is\n"
    "// read, so that the result depends on nothing but the values before. Never less than the true distance: each is that of a\n"
    "// path. OIT_STEP: x: 0 rows, 1 columns; y: number of the pass: four are a round; z: 1: the second, fourth, ... stretches;\n"
    "// w: where a word for each 32 x 32 pixels lies, one more than the last pass that changed something there; 0: none.\n"
    "#define OIT_OWN_MAIN 1\n"
    "const uint oit_reach = 32u;\n"
    "\n"
    "uint oit_nearer(uint own, uint other)\n"
    "{\n"
    "    bool kept = own == 0u || own == OIT_BLOCKED;\n"
    "    return !kept && other < OIT_BLOCKED - 1u ? min(own, other + 1u) : own;\n"
    "}\n"
    "\n"
    "// To pixel p from the one beside, of which these are the slots.\n"
    "bool oit_carry(uint p, uint direction, inout uint other)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    bool changed = false;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint slot = first + i, layer = oit_link(slot, direction), own = oit_surface[OIT_IN_REACH + slot];\n"
    "        uint come = layer == OIT_NONE ? own : oit_surface[OIT_IN_REACH + other + layer];\n"
    "        uint word = oit_nearer(own & 65535u, come & 65535u) | oit_nearer(own >> 16u, come >> 16u) << 16u;\n"
    "        if (word != own) {\n"
    "            oit_surface[OIT_IN_REACH + slot] = word;\n"
    "            changed = true;\n"
    "        }\n"
    "    }\n"
    "    other = first;\n"
    "    return changed;\n"
    "}\n"
    "\n"
    "// Whether nothing has changed here and on either side since the stretch was looked at last, a round ago.\n"
    "bool oit_is_done(uint tile, uint step, bool low, bool high)\n"
    "{\n"
    "    if (OIT_STEP.w == 0u || OIT_STEP.y < 4u)\n"
    "        return false;\n"
    "    uint last = oit_surface[OIT_STEP.w + tile];\n"
    "    last = max(last, low ? oit_surface[OIT_STEP.w + tile - step] : 0u);\n"
    "    last = max(last, high ? oit_surface[OIT_STEP.w + tile + step] : 0u);\n"
    "    return last + 3u <= OIT_STEP.y;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    oit_take_numbers();\n"
    "    uvec2 size = uvec2(oit_area.zw), tiles = (size + oit_reach - 1u) / oit_reach;\n"
    "    uvec2 at = uvec2(gl_GlobalInvocationID.x, 2u * gl_GlobalInvocationID.y + OIT_STEP.z); // x across, y along\n"
    "    bool column = OIT_STEP.x != 0u, changed = false;\n"
    "    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x), tile = start / oit_reach;\n"
    "    if (any(greaterThanEqual(start, size)))\n"
    "        return;\n"
    "    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u, back = column ? OIT_DOWNWARD : OIT_LEFTWARD;\n"
    "    uint rest = column ? size.y - start.y : size.x - start.x, n = min(oit_reach, rest), own = tile.y * tiles.x + tile.x, other;\n"
    "    if (oit_is_done(own, column ? tiles.x : 1u, at.y > 0u, rest > n))\n"
    "        return;\n"
    "    oit_list(at.y > 0u ? p - stride : p, other);\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        changed = oit_carry(p + i * stride, back, other) || changed;\n"
    "    oit_list(rest > n ? p + n * stride : p, other);\n"
    "    for (uint i = n; i > 0u; --i)\n"
    "        changed = oit_carry(p + (i - 1u) * stride, back + 1u, other) || changed;\n"
    "    if (changed && OIT_STEP.w != 0u)\n"
    "        oit_surface[OIT_STEP.w + own] = OIT_STEP.y + 1u;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_law_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The opacity that each surface fragment starts with (Carnecky 2013, section 5.2). OIT_STEP: x: the law; y: distances\n"
    "// beyond that many steps are not known for certain: far; oit_set[0]: s, exponent, scale, reach.\n"
    "#define OIT_LAW_GIVEN 0u\n"
    "#define OIT_LAW_CONSTANT 1u\n"
    "#define OIT_LAW_ADAPTIVE 2u\n"
    "#define OIT_LAW_ANGLE 3u\n"
    "#define OIT_LAW_VARIATION 4u\n"
    "\n"
    "#if OIT_HAS_NORMAL\n"
    "float oit_facing(uint p, uint slot)\n"
    "{\n"
    "    return pow(min(abs(dot(oit_normal(slot), oit_to_eye(oit_device(p)))), 1.0), oit_set[0].y);\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if OIT_HAS_SLOPE\n"
    "// How much normals change around it: halved across both neighbours, the whole of one where the other is missing.\n"
    "float oit_variation(uint p, uint slot)\n"
    "{\n"
    "    float sum = 0.0;\n"
    "    for (uint axis = 0u; axis < 2u; ++axis) {\n"
    "        uint low = oit_neighbour(p, slot, 2u * axis), high = oit_neighbour(p, slot, 2u * axis + 1u);\n"
    "        vec3 step = oit_normal(high == OIT_NONE ? slot : high) - oit_normal(low == OIT_NONE ? slot : low);\n"
    "        sum += dot(step, step) * (low == OIT_NONE || high == OIT_NONE ? 1.0 : 0.25);\n"
    "    }\n"
    "    return sqrt(sum);\n"
    "}\n"
    "#endif\n"
    "\n"
    "// 1 - (1 - s)^(1/m), by logarithms, both as series where 1 - s and 1 - e^x would lose the digits of what is small.\n"
    "float oit_adaptive(float s, float layers)\n"
    "{\n"
    "    if (s >= 1.0)\n"
    "        return 1.0;\n"
    "    float x = (s < 0.01 ? -s * (1.0 + s * (0.5 + s * (1.0 / 3.0 + s * 0.25))) : log(1.0 - s)) / layers;\n"
    "    return x > -0.01 ? -x * (1.0 + x * (0.5 + x * (1.0 / 6.0))) : 1.0 - exp(x);\n"
    "}\n"
    "\n"
    "float oit_law(uint p, uint slot, float layers)\n"
    "{\n"
    "    float s = oit_set[0].x;\n"
    "    if (OIT_STEP.x == OIT_LAW_GIVEN)\n"
    "        return oit_color(slot).a;\n"
    "    if (OIT_STEP.x == OIT_LAW_CONSTANT)\n"
    "        return s;\n"
    "    if (OIT_STEP.x == OIT_LAW_ADAPTIVE)\n"
    "        return oit_adaptive(s, layers);\n"
    "#if OIT_HAS_NORMAL\n"
    "    if (OIT_STEP.x == OIT_LAW_ANGLE)\n"
    "        return 1.0 - (1.0 - s) * oit_facing(p, slot);\n"
    "#endif\n"
    "#if OIT_HAS_SLOPE\n"
    "    if (OIT_STEP.x == OIT_LAW_VARIATION)\n"
    "        return 1.0 - (1.0 - s) * exp(-oit_set[0].z * oit_variation(p, slot));\n"
    "    uint steps = oit_steps(slot, false);\n"
    "    float near = steps <= OIT_STEP.y ? min(float(steps) / oit_set[0].w, 1.0) : 1.0;\n"
    "    return 1.0 - (1.0 - s) * pow(near, oit_set[0].y);\n"
    "#else\n"
    "    return s;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first), layers = 0u;\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        layers += oit_is_surface(first + i) ? 1u : 0u;\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        oit_set_value(OIT_BASE, first + i, oit_is_surface(first + i) ? oit_law(p, first + i, float(layers)) : 0.0);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_mutual_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What is not chosen by what it has chosen is no neighbour (Carnecky 2013, figure 7b). In place: a link that another\n"
    "// invocation has taken away meanwhile was not to this fragment, or would have stayed.\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first), firsts[4];\n"
    "    bool wide = OIT_IN_FAR_LINKS != 0u;\n"
    "    for (uint d = 0u; d < 4u; ++d) {\n"
    "        uint q;\n"
    "        firsts[d] = 0u;\n"
    "        if (oit_beside(p, d, q))\n"
    "            oit_list(q, firsts[d]);\n"
    "    }\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uvec2 none = uvec2(0u); // of the two words, or all in the first\n"
    "        for (uint d = 0u; d < 4u; ++d) {\n"
    "            uint layer = oit_link(first + i, d);\n"
    "            bool lost = layer != OIT_NONE && oit_link(firsts[d] + layer, d ^ 1u) != i;\n"
    "            none[wide ? d >> 1u : 0u] |= lost ? (wide ? 65535u << 16u * (d & 1u) : 255u << 8u * d) : 0u;\n"
    "        }\n"
    "        if (none.x != 0u)\n"
    "            oit_surface[OIT_IN_LINKS + first + i] |= none.x;\n"
    "        if (none.y != 0u)\n"
    "            oit_surface[OIT_IN_FAR_LINKS + first + i] |= none.y;\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_pairs_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// How well two fragments of pixels side by side would join (Carnecky 2013, section 4.4, equations 1 to 3): what both\n"
    "// searches for links measure by. OIT_STEP.w: bits of OIT_CHOOSE_*.\n"
    "#define OIT_CHOOSE_COUNTS 1u\n"
    "#define OIT_CHOOSE_GROUPED 2u\n"
    "#define OIT_DEPTH_WEIGHT oit_set[0].x\n"
    "#define OIT_NORMAL_WEIGHT oit_set[0].y\n"
    "#define OIT_PER_RADIUS oit_set[0].z\n"
    "#define OIT_LIMIT_APART oit_set[0].w\n"
    "#define OIT_NEVER uintBitsToFloat(0x7f800000u) // infinity\n"
    "uint oit_pairs = 0u;\n"
    "\n"
    "struct oit_side // of a pair: the one that looks\n"
    "{\n"
    "    float depth, predicted; // window depth, and distance along the view that its slope makes for the pixel beside\n"
    "    float ahead;            // what the slope adds to the depth on the way there\n"
    "    uint direction;\n"
    "    vec2 slope;\n"
    "    vec3 normal;\n"
    "    vec2 uv;\n"
    "    uint part;\n"
    "};\n"
    "\n"
    "vec2 oit_record_slope(uint at)\n"
    "{\n"
    "    return unpackHalf2x16(OIT_WORD(at, OIT_AT_SLOPE)) * (1.0 / 4096.0);\n"
    "}\n"
    "\n"
    "float oit_ahead(vec2 slope, uint direction)\n"
    "{\n"
    "    float ahead = direction < 2u ? slope.x : slope.y;\n"
    "    return (direction & 1u) != 0u ? ahead : -ahead;\n"
    "}\n"
    "\n"
    "oit_side oit_toward(oit_side side, uint direction)\n"
    "{\n"
    "    side.direction = direction;\n"
    "    side.ahead = oit_ahead(side.slope, direction);\n"
    "    side.predicted = oit_distance(side.depth + side.ahead);\n"
    "    return side;\n"
    "}\n"
    "\n"
    "// Toward no side yet.\n"
    "oit_side oit_look(uint slot)\n"
    "{\n"
    "    uint at = oit_record(slot);\n"
    "    oit_side side;\n"
    "    side.slope = oit_record_slope(at);\n"
    "    side.depth = side.predicted = oit_record_window_depth(at);\n"
    "    side.ahead = 0.0;\n"
    "    side.direction = 0u;\n"
    "    side.normal = oit_record_normal(at);\n"
    "    side.part = OIT_WORD(at, OIT_AT_PART);\n"
    "    side.uv = vec2(0.0);\n"
    "#if OIT_HAS_UV\n"
    "    side.uv = oit_uv(slot);\n"
    "#endif\n"
    "    return side;\n"
    "}\n"
    "\n"
    "// How far apart in depth, in radii.\n"
    "float oit_apart(oit_side side, uint at)\n"
    "{\n"
    "    return abs(side.predicted - oit_distance(oit_record_window_depth(at))) * OIT_PER_RADIUS;\n"
    "}\n"
    "\n"
    "// Two units of rounding may leave the product of unit vectors above 1; bends that are not negative are what the window\n"
    "// stops by.\n"
    "float oit_bend(oit_side side, uint at)\n"
    "{\n"
    "    return max(1.0 - dot(side.normal, oit_record_normal(at)), 0.0);\n"
    "}\n"
    "\n"
    "bool oit_may_join(oit_side side, uint at)\n"
    "{\n"
    "    ++oit_pairs;\n"
    "    return OIT_WORD(at, OIT_AT_PART) == side.part && oit_record_blend(at) == 0u;\n"
    "}\n"
    "\n"
    "// Within the limit of what its slope predicts, or where a surface is found whose slope changes steadily from the one's to\n"
    "// the other's: between what the two slopes say. So a surface holds together where it is seen at a grazing angle, and\n"
    "// beyond the limit nothing is glued to what lies behind it and slopes alike.\n"
    "bool oit_is_continuous(oit_side side, uint at, float apart)\n"
    "{\n"
    "    float rise = oit_record_window_depth(at) - side.depth;\n"
    "    return apart <= OIT_LIMIT_APART || (rise > side.ahead) != (rise > oit_ahead(oit_record_slope(at), side.direction));\n"
    "}\n"
    "\n"
    "float oit_measure_by_depth(oit_side side, uint at, float apart)\n"
    "{\n"
    "    return oit_is_continuous(side, at, apart) ? OIT_DEPTH_WEIGHT * apart + OIT_NORMAL_WEIGHT * oit_bend(side, at)\n"
    "                                              : OIT_NEVER;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_size_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// How far it is along the surface to the next fragment with a boundary condition, on either side along its row or its\n"
    "// column: the width of what lies between two silhouettes or halos. Each pass carries that 32 pixels; what has not come is\n"
    "// not known (65535), at the frame of the picture never. OIT_STEP: x: 0 rows, 1 columns; y: 1: the first of its axis.\n"
    "#define OIT_OWN_MAIN 1\n"
    "const uint oit_reach = 32u;\n"
    "\n"
    "bool oit_is_wall(uint slot)\n"
    "{\n"
    "    uint low = oit_steps(slot, false);\n"
    "    return low == 0u || low == OIT_BLOCKED || oit_steps(slot, true) == 0u;\n"
    "}\n"
    "\n"
    "// Toward which it is known from the pixel beside: `direction`. The half of the word that it has.\n"
    "void oit_carry(uint p, uint direction, uint section)\n"
    "{\n"
    "    uint first, n = oit_list(p, first), q, other, shift = 16u * (direction & 1u);\n"
    "    bool beside = oit_beside(p, direction, q);\n"
    "    if (beside)\n"
    "        oit_list(q, other);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint slot = first + i, layer = beside ? oit_link(slot, direction) : OIT_NONE, distance = OIT_UNREACHED;\n"
    "        if (oit_is_wall(slot)) {\n"
    "            distance = 0u;\n"
    "        } else if (layer != OIT_NONE) {\n"
    "            uint come = oit_surface[section + other + layer] >> shift & 65535u;\n"
    "            distance = come < OIT_BLOCKED ? come + 1u : OIT_UNREACHED;\n"
    "        }\n"
    "        uint word = oit_surface[section + slot];\n"
    "        oit_surface[section + slot] = (word & ~(65535u << shift)) | distance << shift;\n"
    "    }\n"
    "}\n"
    "\n"
    "void oit_forget(uint p, uint section)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        oit_surface[section + first + i] = 0xffffffffu;\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    oit_take_numbers();\n"
    "    uvec2 size = uvec2(oit_area.zw), at = gl_GlobalInvocationID.xy;\n"
    "    bool column = OIT_STEP.x != 0u;\n"
    "    uvec2 start = column ? uvec2(at.x, at.y * oit_reach) : uvec2(at.y * oit_reach, at.x); // x is what is long\n"
    "    if (any(greaterThanEqual(start, size)))\n"
    "        return;\n"
    "    uint p = start.y * size.x + start.x, stride = column ? size.x : 1u, section = column ? OIT_EXTRA_STEP.z : OIT_IN_SIZES;\n"
    "    uint n = min(oit_reach, column ? size.y - start.y : size.x - start.x), back = column ? 2u : 0u;\n"
    "    for (uint i = 0u; i < n && OIT_STEP.y != 0u; ++i)\n"
    "        oit_forget(p + i * stride, section);\n"
    "    for (uint i = 0u; i < n && OIT_STEP.y == 0u; ++i)\n"
    "        oit_carry(p + i * stride, back, section);\n"
    "    for (uint i = n; i > 0u && OIT_STEP.y == 0u; --i)\n"
    "        oit_carry(p + (i - 1u) * stride, back + 1u, section);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_solve_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// One iteration: equation 8 of one field, and equation 9 of beta and gamma (Carnecky 2013, section 5.4), as distances in\n"
    "// steps to the nearest source. Distances are relaxed where they lie: one that is read while it changes is still that of a\n"
    "// path, and after n iterations all of up to n are right; greater ones are cut when they are used. OIT_STEP: x: 1: equation\n"
    "// 9; y: 1: equation 8, from oit_before to oit_set_after; z: whose boundary is kept there: 1 beta, 2 gamma, 0 none;\n"
    "// oit_set[0].x: lambda times the weight of the sum.\n"
    "uint oit_nearer(uint distance, uint other)\n"
    "{\n"
    "    return other < OIT_BLOCKED - 1u ? min(distance, other + 1u) : distance;\n"
    "}\n"
    "\n"
    "bool oit_is_kept(uint steps)\n"
    "{\n"
    "    return steps == 0u || steps == OIT_BLOCKED;\n"
    "}\n"
    "\n"
    "void oit_relax(uint slot, uint others[4])\n"
    "{\n"
    "    uint word = oit_surface[OIT_IN_REACH + slot], low = word & 65535u, high = word >> 16u, beta = low, gamma = high;\n"
    "    for (uint d = 0u; d < 4u; ++d)\n"
    "        if (others[d] != OIT_NONE) {\n"
    "            uint other = oit_surface[OIT_IN_REACH + others[d]];\n"
    "            beta = oit_nearer(beta, other & 65535u);\n"
    "            gamma = oit_nearer(gamma, other >> 16u);\n"
    "        }\n"
    "    beta = oit_is_kept(low) ? low : beta;\n"
    "    gamma = oit_is_kept(high) ? high : gamma;\n"
    "    if (beta != low || gamma != high)\n"
    "        oit_surface[OIT_IN_REACH + slot] = beta | gamma << 16u;\n"
    "}\n"
    "\n"
    "void oit_diffuse(uint slot, uint others[4])\n"
    "{\n"
    "    float value = oit_before(slot), sum = 0.0;\n"
    "    for (uint d = 0u; d < 4u; ++d)\n"
    "        if (others[d] != OIT_NONE)\n"
    "            sum += oit_before(others[d]) - value;\n"
    "    if (OIT_STEP.z != 0u && oit_is_kept(oit_steps(slot, OIT_STEP.z == 2u)))\n"
    "        sum = 0.0;\n"
    "    oit_set_after(slot, value + oit_set[0].x * sum);\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first), firsts[4];\n"
    "    if (n == 0u)\n"
    "        return;\n"
    "    for (uint d = 0u; d < 4u; ++d) {\n"
    "        uint q;\n"
    "        if (oit_beside(p, d, q))\n"
    "            oit_list(q, firsts[d]);\n"
    "    }\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint others[4];\n"
    "        for (uint d = 0u; d < 4u; ++d) {\n"
    "            uint layer = oit_link(first + i, d);\n"
    "            others[d] = layer == OIT_NONE ? OIT_NONE : firsts[d] + layer;\n"
    "        }\n"
    "        if (OIT_STEP.x != 0u)\n"
    "            oit_relax(first + i, others);\n"
    "        if (OIT_STEP.y != 0u)\n"
    "            oit_diffuse(first + i, others);\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_sort_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The order of each pixel's run, before the first operator: a fragment's slot is how many come before it. Eight at a time\n"
    "// are counted while the depths of the run pass by once: no array, no dependence from one step to the next.\n"
    "\n"
    "// Of records of one depth as they are composed.\n"
    "uint oit_before_ties(uint base, uint n, uint i)\n"
    "{\n"
    "    uint at = base + i * uint(OIT_VECTORS), before = 0u;\n"
    "    for (uint k = 0u; k < n; ++k) {\n"
    "        uint other = base + k * uint(OIT_VECTORS);\n"
    "        if (k != i && oit_record_depth(other) == oit_record_depth(at) && oit_after(at, other))\n"
    "            ++before;\n"
    "    }\n"
    "    return before;\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    if (p == 0u)\n"
    "        oit_surface[0] = 0u; // pairs compared since\n"
    "    uint first, n = oit_list(p, first), base = first * uint(OIT_VECTORS);\n"
    "    for (uint i = 0u; i < n; i += 8u) {\n"
    "        uint own[8], before[8], alike[8];\n"
    "        for (uint k = 0u; k < 8u; ++k) {\n"
    "            own[k] = i + k < n ? oit_record_depth(base + (i + k) * uint(OIT_VECTORS)) : OIT_NONE;\n"
    "            before[k] = alike[k] = 0u;\n"
    "        }\n"
    "        for (uint k = 0u; k < n; ++k) {\n"
    "            uint depth = oit_record_depth(base + k * uint(OIT_VECTORS));\n"
    "            for (uint j = 0u; j < 8u; ++j) {\n"
    "                before[j] += depth < own[j] ? 1u : 0u;\n"
    "                alike[j] += depth == own[j] ? 1u : 0u;\n"
    "            }\n"
    "        }\n"
    "        for (uint k = 0u; k < 8u && i + k < n; ++k) {\n"
    "            uint place = before[k];\n"
    "            if (alike[k] > 1u)\n"
    "                place += oit_before_ties(base, n, i + k);\n"
    "            oit_surface[OIT_IN_ORDER + first + place] = first + i + k;\n"
    "        }\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_operator_window_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What each surface fragment likes best of the pixels beside its own by predicted depth and normal, as oit_operator_connect\n"
    "// finds it, without looking at all of them: runs are sorted, and distance ascends with depth. From the predicted depth\n"
    "// outward on both sides, the nearer gap first, until the gap alone weighs more than the best so far. After\n"
    "// oit_operator_pairs.glsl. oit_set[1].y: -1 where the eye looks along +z, whose distances fall from the eye on.\n"
    "// Loops end where their conditions stand: a driver that masks lanes goes round once more for a condition at the top.\n"
    "\n"
    "// The run of a pixel beside, at the place where the predicted depth belongs: the two records around it. Surfaces mostly\n"
    "// keep their order, so that the next fragment's place is near.\n"
    "struct oit_window\n"
    "{\n"
    "    uint first, count, from; // from: of the one behind\n"
    "    uint before, behind;     // records\n"
    "    float low, high;         // their distances, ascending from the eye on\n"
    "};\n"
    "\n"
    "float oit_ascending(uint at)\n"
    "{\n"
    "    return oit_distance(oit_record_window_depth(at)) * oit_set[1].y;\n"
    "}\n"
    "\n"
    "oit_window oit_open(uint p, uint direction)\n"
    "{\n"
    "    uint q;\n"
    "    oit_window w = oit_window(0u, 0u, 0u, 0u, 0u, -OIT_NEVER, OIT_NEVER);\n"
    "    if (oit_beside(p, direction, q))\n"
    "        w.count = oit_list(q, w.first);\n"
    "    if (w.count > 0u) {\n"
    "        w.behind = oit_record(w.first);\n"
    "        w.high = oit_ascending(w.behind);\n"
    "    }\n"
    "    return w;\n"
    "}\n"
    "\n"
    "// On to where what is before comes before `place`, and what is behind does not.\n"
    "void oit_move(inout oit_window w, float place)\n"
    "{\n"
    "    bool on;\n"
    "    do {\n"
    "        bool up = w.from < w.count && w.high < place, down = w.from > 0u && !up && !(w.low < place);\n"
    "        w.from += up ? 1u : down ? 0xffffffffu : 0u;\n"
    "        uint index = up ? w.from : w.from - 1u, at = 0u;\n"
    "        float distance = up ? OIT_NEVER : -OIT_NEVER;\n"
    "        if ((up || down) && index < w.count) {\n"
    "            at = oit_record(w.first + index);\n"
    "            distance = oit_ascending(at);\n"
    "        }\n"
    "        if (up) {\n"
    "            w.before = w.behind;\n"
    "            w.low = w.high;\n"
    "            w.behind = at;\n"
    "            w.high = distance;\n"
    "        } else if (down) {\n"
    "            w.behind = w.before;\n"
    "            w.high = w.low;\n"
    "            w.before = at;\n"
    "            w.low = distance;\n"
    "        }\n"
    "        on = up ? w.from < w.count && w.high < place : down && w.from > 0u && !(w.low < place);\n"
    "    } while (on);\n"
    "}\n"
    "\n"
    "uint oit_choose(oit_side side, uint direction, inout oit_window w)\n"
    "{\n"
    "    side = oit_toward(side, direction);\n"
    "    float place = side.predicted * oit_set[1].y, least = OIT_NEVER;\n"
    "    oit_move(w, place);\n"
    "    uint before = w.from - 1u, behind = w.from, best = OIT_NONE; // before: beyond the run when it has passed 0\n"
    "    uint at_before = w.before, at_behind = w.behind;\n"
    "    float gap_before = abs(place - w.low) * OIT_PER_RADIUS, gap_behind = abs(place - w.high) * OIT_PER_RADIUS;\n"
    "    gap_before = before < w.count ? gap_before : OIT_NEVER;\n"
    "    gap_behind = behind < w.count ? gap_behind : OIT_NEVER;\n"
    "    bool on;\n"
    "    do {\n"
    "        bool back = gap_before < gap_behind;\n"
    "        float gap = back ? gap_before : gap_behind;\n"
    "        uint i = back ? before : behind, at = back ? at_before : at_behind, next = back ? i - 1u : i + 1u;\n"
    "        on = !(OIT_DEPTH_WEIGHT * gap > least) && i < w.count;\n"
    "        if (on) {\n"
    "            float measure = oit_may_join(side, at) ? oit_measure_by_depth(side, at, gap) : OIT_NEVER;\n"
    "            bool better = measure < least || (measure == least && best != OIT_NONE && i < best);\n"
    "            least = better ? measure : least;\n"
    "            best = better ? i : best;\n"
    "            gap = OIT_NEVER;\n"
    "            if (next < w.count) {\n"
    "                at = oit_record(w.first + next);\n"
    "                gap = abs(place - oit_ascending(at)) * OIT_PER_RADIUS;\n"
    "            }\n"
    "            before = back ? next : before;\n"
    "            behind = back ? behind : next;\n"
    "            at_before = back ? at : at_before;\n"
    "            at_behind = back ? at_behind : at;\n",
    "#line 93\n"
    "            gap_before = back ? gap : gap_before;\n"
    "            gap_behind = back ? gap_behind : gap;\n"
    "            on = !(OIT_DEPTH_WEIGHT * min(gap_before, gap_behind) > least);\n"
    "        }\n"
    "    } while (on);\n"
    "    return best;\n"
    "}\n"
    "\n"
    "void oit_set_links(uint slot, uvec4 layers)\n"
    "{\n"
    "    bool wide = OIT_IN_FAR_LINKS != 0u;\n"
    "    layers = min(layers, uvec4(wide ? 65535u : 255u));\n"
    "    uvec2 pairs = layers.xz | layers.yw << (wide ? 16u : 8u);\n"
    "    oit_surface[OIT_IN_LINKS + slot] = wide ? pairs.x : pairs.x | pairs.y << 16u;\n"
    "    if (wide)\n"
    "        oit_surface[OIT_IN_FAR_LINKS + slot] = pairs.y;\n"
    "}\n"
    "\n"
    "void oit_operate(uint p)\n"
    "{\n"
    "    uint first, n = oit_list(p, first);\n"
    "    oit_window left = oit_open(p, OIT_LEFTWARD), right = oit_open(p, OIT_RIGHTWARD);\n"
    "    oit_window down = oit_open(p, OIT_DOWNWARD), up = oit_open(p, OIT_UPWARD);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        oit_side side = oit_look(first + i);\n"
    "        uvec4 layers;\n"
    "        layers.x = oit_choose(side, OIT_LEFTWARD, left);\n"
    "        layers.y = oit_choose(side, OIT_RIGHTWARD, right);\n"
    "        layers.z = oit_choose(side, OIT_DOWNWARD, down);\n"
    "        layers.w = oit_choose(side, OIT_UPWARD, up);\n"
    "        oit_set_links(first + i, oit_is_surface(first + i) ? layers : uvec4(OIT_NONE));\n"
    "    }\n"
    "    if ((OIT_STEP.w & OIT_CHOOSE_COUNTS) != 0u)\n"
    "        atomicAdd(oit_surface[0], oit_pairs);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_ordered_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// A pixel's run in its order without a sort, for what looks at few of its records: picking, the depth of the composite.\n"
    "\n"
    "// Where the run of pixel p lies, and how many records it has; false where it did not fit into the pool.\n"
    "bool oit_find_run(uint p, out uint base, out uint n)\n"
    "{\n"
    "    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];\n"
    "    bool fits = true;\n"
    "#if OIT_ASYNC\n"
    "    fits = end <= oit_pool.z;\n"
    "#if OIT_STORE == OIT_PREDICT\n"
    "    fits = fits && int(oit_pixel[OIT_LEFT(p)]) >= 0;\n"
    "#endif\n"
    "#endif\n"
    "    // Fragments that were counted and did not come have left the first places empty.\n"
    "    if (fits)\n"
    "        start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));\n"
    "    n = end - start;\n"
    "#if OIT_ASYNC && OIT_STORE == OIT_PREDICT // the run was as long as guessed\n"
    "    n = fits ? n : oit_pixel[OIT_SEEN(p)];\n"
    "#endif\n"
    "    base = (start - oit_pool.y) * uint(OIT_VECTORS);\n"
    "    return fits;\n"
    "}\n"
    "\n"
    "// The record that comes next after `last`, or the first one after OIT_NONE; OIT_NONE after the last.\n"
    "uint oit_next(uint base, uint n, uint last)\n"
    "{\n"
    "    uint best = OIT_NONE, nearest = OIT_NONE;\n"
    "    uint before = last == OIT_NONE ? 0u : oit_record_depth(last);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint at = base + i * uint(OIT_VECTORS), depth = oit_record_depth(at);\n"
    "        if (depth < before || depth > nearest)\n"
    "            continue;\n"
    "        if (last != OIT_NONE && depth == before && !oit_after(at, last))\n"
    "            continue;\n"
    "        if (best != OIT_NONE && depth == nearest && !oit_after(best, at))\n"
    "            continue;\n"
    "        best = at;\n"
    "        nearest = depth;\n"
    "    }\n"
    "    return best;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_pick_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// One fragment of one pixel, the one that `layer` others come before, with all its words; and how many there are.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_REPORT) buffer oit_picks { uint oit_pick[]; }; // x, y, layer; layers, found; record\n"
    "\n"
    "void main()\n"
    "{\n"
    "    ivec2 where = ivec2(oit_pick[0], oit_pick[1]) - oit_area.xy;\n"
    "    uint self = gl_LocalInvocationID.x, layer = oit_pick[2], base, n;\n"
    "    bool fits = oit_find_run(uint(where.y) * uint(oit_area.z) + uint(where.x), base, n);\n"
    "    bool found = fits && layer < n;\n"
    "    if (self == 0u) {\n"
    "        oit_pick[3] = n;\n"
    "        oit_pick[4] = found ? 1u : 0u;\n"
    "    }\n"
    "    for (uint i = self; found && i < n; i += 128u) {\n"
    "        uint at = base + i * uint(OIT_VECTORS), before = 0u;\n"
    "        for (uint k = 0u; k < n; ++k)\n"
    "            before += oit_after(at, base + k * uint(OIT_VECTORS)) ? 1u : 0u;\n"
    "        for (uint k = 0u; before == layer && k < uint(OIT_VECTORS); ++k)\n"
    "            for (int lane = 0; lane < OIT_LANES; ++lane)\n"
    "                oit_pick[5u + k * uint(OIT_LANES) + uint(lane)] = oit_data[at + k][lane];\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_predict_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// OIT_STORE_PREDICT: how long the run of each pixel shall be: the most that it or a neighbour had in the frame before, and\n"
    "// some headroom; or, where the frame is filled again, what it had. Clears totals, and the sums of pixels that were lost.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "uint oit_most_around(uint p)\n"
    "{\n"
    "    ivec2 size = oit_area.zw, at = ivec2(int(p) % size.x, int(p) / size.x);\n"
    "    ivec2 low = max(at - 1, ivec2(0)), high = min(at + 1, size - 1);\n"
    "    uint most = 0u;\n"
    "    for (int y = low.y; y <= high.y; ++y)\n"
    "        for (int x = low.x; x <= high.x; ++x)\n"
    "            most = max(most, oit_pixel[OIT_SEEN(uint(y * size.x + x))]);\n"
    "    // Sixteenths, rounded up.\n"
    "    return most + (most >> 4u) * uint(OIT_HEADROOM) + (((most & 15u) * uint(OIT_HEADROOM) + 15u) >> 4u);\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + gl_LocalInvocationID.x;\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = first + 128u * i;\n"
    "        if (p >= oit_pool.x)\n"
    "            continue;\n"
    "#if OIT_HAS_COVERAGE\n"
    "        oit_pixel[OIT_EDGE(p)] = 0u;\n"
    "#endif\n"
    "#if OIT_ASYNC\n"
    "        if (oit_pixel[OIT_LEFT(p)] >= OIT_UNFIT >> 1u) // less than none left, or unfit\n"
    "            for (uint c = 0u; c < uint(OIT_TAIL_WORDS); ++c)\n"
    "                oit_pixel[OIT_TAIL(p) + c] = 0u;\n"
    "#endif\n"
    "        oit_pixel[OIT_WANTED(p)] = OIT_DIRECT ? oit_most_around(p) : oit_pixel[OIT_SEEN(p)];\n"
    "    }\n"
    "    if (first < OIT_HEADER)\n"
    "        oit_pixel[first] = 0u;\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_record_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Records read back: the order of two, colour, how it is laid over what is behind.\n"
    "#ifndef OIT_SETTLES\n"
    "#ifdef OIT_ARRANGES\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "#else\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "#endif\n"
    "#endif\n"
    "#ifndef OIT_BINDING_RECORDS\n"
    "#define OIT_BINDING_RECORDS OIT_BINDING_FRAGMENTS\n"
    "#endif\n"
    "layout(std430, binding = OIT_BINDING_RECORDS) readonly buffer oit_fragments { OIT_VECTOR oit_data[]; };\n"
    "\n"
    "// Whether the record at a comes after that at b; by their words, then by where they lie, which only tells apart records\n"
    "// that are alike in every word.\n"
    "bool oit_after(uint a, uint b)\n"
    "{\n"
    "    for (uint i = 0u; i < uint(OIT_VECTORS); ++i) {\n"
    "        OIT_VECTOR x = oit_data[a + i], y = oit_data[b + i];\n"
    "        for (int k = 0; k < OIT_LANES; ++k)\n"
    "            if (x[k] != y[k])\n"
    "                return x[k] > y[k];\n"
    "    }\n"
    "    return a > b;\n"
    "}\n"
    "\n"
    "// Word i of the record at `at`; i is a constant.\n"
    "#define OIT_WORD(at, i) oit_data[(at) + uint((i) / OIT_LANES)][(i) % OIT_LANES]\n"
    "\n"
    "uint oit_record_depth(uint at)\n"
    "{\n"
    "    return oit_data[at].x;\n"
    "}\n"
    "\n"
    "// The words by which records are sorted and composed: the first OIT_SORTED of them, depth to colour and blend, in two\n"
    "// vectors; zeros after them. What a record carries beyond cannot be seen in the picture.\n"
    "void oit_load(uint at, out uvec4 r, out uvec4 q)\n"
    "{\n"
    "    q = uvec4(0u);\n"
    "#if OIT_LANES == 4\n"
    "    r = oit_data[at];\n"
    "#if OIT_SORTED > 4\n"
    "    q = oit_data[at + 1u];\n"
    "#endif\n"
    "#else\n"
    "    r = uvec4(oit_data[at], oit_data[at + 1u]);\n"
    "#if OIT_SORTED > 4\n"
    "    q.xy = oit_data[at + 2u];\n"
    "#endif\n"
    "#if OIT_SORTED > 6\n"
    "    q.zw = oit_data[at + 3u];\n"
    "#endif\n"
    "#endif\n"
    "#if OIT_SORTED < 4\n"
    "    r.w = 0u;\n"
    "#endif\n"
    "#if OIT_SORTED < 6\n"
    "    q.y = 0u;\n"
    "#endif\n"
    "#if OIT_SORTED < 7\n"
    "    q.z = 0u;\n"
    "#endif\n"
    "#if OIT_SORTED < 8\n"
    "    q.w = 0u;\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if defined(OIT_SETTLES) && OIT_ASYNC\n"
    "// What the record adds to the tail.\n"
    "vec4 oit_record_amounts(uint at)\n"
    "{\n"
    "    uvec4 r, q;\n"
    "    uint blend = 0u, covered = 0u;\n"
    "    oit_load(at, r, q);\n"
    "    uvec4 words = oit_color_words(r, q);\n"
    "#if OIT_HAS_BLEND && OIT_COLOR == OIT_COLOR_8\n"
    "    blend = words.x >> 30u;\n"
    "#elif OIT_HAS_BLEND\n"
    "    blend = OIT_SORTED_WORD(OIT_AT_BLEND) & 255u;\n"
    "#endif\n"
    "#if OIT_HAS_COVERAGE\n"
    "    covered = OIT_COVERAGE_OF(OIT_SORTED_WORD(OIT_AT_COVERAGE));\n"
    "#endif\n"
    "    return oit_tail_amounts(oit_unpack_color(words), blend, covered);\n"
    "}\n"
    "#endif\n",
    0};
static const char *const oit_i_shader_oit_report_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The totals into a buffer of their own, which the CPU reads when its fence has passed.\n"
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) readonly buffer oit_pixels { uint oit_pixel[]; };\n"
    "layout(std430, binding = OIT_BINDING_REPORT) writeonly buffer oit_report { uint oit_total[]; };\n"
    "\n"
    "void main()\n"
    "{\n"
    "    for (uint i = 0u; i < 16u; ++i)\n"
    "        oit_total[i] = oit_pixel[i];\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_scan_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Sums that stay at the largest number instead of starting again from zero, and their prefix sum over a work group.\n"
    "uint oit_add(uint a, uint b)\n"
    "{\n"
    "    uint sum = a + b;\n"
    "    return sum < a ? 0xffffffffu : sum;\n"
    "}\n"
    "\n"
    "// OIT_STORE_LINKED, and the list was too small for `total`: which records it has depends on which came first, so all pixels\n"
    "// are lost alike: by this much their runs are moved, beyond the pool.\n"
    "uint oit_all_lost(uint total)\n"
    "{\n"
    "    return OIT_STORE == OIT_LINKED && OIT_ASYNC == 1 && OIT_DIRECT && total > oit_pool.z ? oit_pool.z : 0u;\n"
    "}\n"
    "\n"
    "// 0 for up to 8, then one more for each doubling.\n"
    "uint oit_class(uint count)\n"
    "{\n"
    "    return count <= 8u ? 0u : min(uint(findMSB(count - 1u)) - 2u, 3u);\n"
    "}\n"
    "#ifdef OIT_SCANS\n"
    "shared uint oit_scanned[128];\n"
    "\n"
    "// What lies before this invocation. All 128 must call it.\n"
    "uint oit_scan(uint self, uint value)\n"
    "{\n"
    "    oit_scanned[self] = value;\n"
    "    barrier();\n"
    "    for (uint reach = 1u; reach < 128u; reach <<= 1u) {\n"
    "        uint other = self >= reach ? oit_scanned[self - reach] : 0u;\n"
    "        barrier();\n"
    "        oit_scanned[self] = oit_add(oit_scanned[self], other);\n"
    "        barrier();\n"
    "    }\n"
    "    return self > 0u ? oit_scanned[self - 1u] : 0u;\n"
    "}\n"
    "#endif\n",
    0};
static const char *const oit_i_shader_oit_settle_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// OIT_STORE_PREDICT, after the fill: how many fragments came to each pixel, what the frame was like, and which pixels got\n"
    "// more than their runs hold. What such a pixel has stored goes to its tail, where the rest is already: so it does not show\n"
    "// which came first.\n"
    "layout(local_size_x = 128) in;\n"
    "shared uint oit_totals[OIT_HEADER];\n"
    "\n"
    "void oit_settle(uint p, inout uint deepest)\n"
    "{\n"
    "    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];\n"
    "    int left = OIT_TRUE_LEFT(oit_pixel[OIT_LEFT(p)]);\n"
    "    uint seen = end - start - uint(left);\n"
    "    oit_pixel[OIT_SEEN(p)] = seen;\n"
    "    if (seen == 0u)\n"
    "        return;\n"
    "    if (OIT_DIRECT) {\n"
    "        deepest = max(deepest, seen);\n"
    "        atomicAdd(oit_totals[OIT_NEEDED], seen);\n"
    "        atomicAdd(oit_totals[OIT_PIXELS + oit_class(seen)], 1u);\n"
    "    } else if (OIT_ASYNC == 0) { // counted: nothing is lost, and what is too much was not stored\n"
    "        atomicAdd(oit_totals[OIT_EXTRA], uint(max(-left, 0)));\n"
    "        return;\n"
    "    }\n"
    "    if (left >= 0 && end <= oit_pool.z)\n"
    "        return;\n"
    "    atomicAdd(oit_totals[OIT_LOST_PIXELS], 1u);\n"
    "    atomicAdd(oit_totals[OIT_LOST], seen);\n"
    "#if OIT_ASYNC\n"
    "    for (uint i = start; i < end && end <= oit_pool.z; ++i)\n"
    "        oit_add_to_tail(p, oit_record_amounts(i * uint(OIT_VECTORS)));\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint self = gl_LocalInvocationID.x, deepest = 0u;\n"
    "    if (self < OIT_HEADER)\n"
    "        oit_totals[self] = 0u;\n"
    "    barrier();\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = block * OIT_BLOCK + 128u * i + self;\n"
    "        if (p < oit_pool.x)\n"
    "            oit_settle(p, deepest);\n"
    "    }\n"
    "    atomicMax(oit_totals[OIT_DEEPEST], deepest);\n"
    "    barrier();\n"
    "    if (self == OIT_DEEPEST)\n"
    "        atomicMax(oit_pixel[OIT_DEEPEST], oit_totals[OIT_DEEPEST]);\n"
    "    else if (self < OIT_HEADER && oit_totals[self] > 0u)\n"
    "        atomicAdd(oit_pixel[self], oit_totals[self]);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_spread_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The scan, third of three: where the run of each pixel starts. A run that ends beyond the pool does not fit; since starts\n"
    "// ascend, that follows from its end alone and needs no mark.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "void oit_lose(uint p, uint count)\n"
    "{\n"
    "    oit_pixel[OIT_LEFT(p)] = count | OIT_UNFIT;\n"
    "#if OIT_STORE != OIT_PREDICT // where it is known when all have come\n"
    "    atomicAdd(oit_pixel[OIT_LOST_PIXELS], 1u);\n"
    "    atomicAdd(oit_pixel[OIT_LOST], count);\n"
    "#endif\n"
    "#if OIT_STORE == OIT_EXACT\n"
    "    for (uint c = 0u; c < 4u; ++c)\n"
    "        oit_pixel[OIT_TAIL(p) + c] = 0u;\n"
    "#endif\n"
    "}\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint first = block * OIT_BLOCK + 8u * gl_LocalInvocationID.x;\n"
    "    uint sum = 0u;\n"
    "    for (uint p = first; p < first + 8u; ++p)\n"
    "        sum = oit_add(sum, p < oit_pool.x ? oit_pixel[OIT_WANTED(p)] : 0u);\n"
    "    uint before = oit_scan(gl_LocalInvocationID.x, sum);\n"
    "    before = oit_add(before, block < oit_pool.w ? oit_pixel[OIT_SUM(block)] : 0u);\n"
    "    before = oit_add(before, oit_all_lost(oit_pixel[OIT_TOTAL]));\n"
    "    for (uint p = first; p < first + 8u && p < oit_pool.x; ++p) {\n"
    "        uint count = oit_pixel[OIT_WANTED(p)];\n"
    "        oit_pixel[OIT_START(p)] = before;\n"
    "#if OIT_STORE == OIT_PREDICT\n"
    "        oit_pixel[OIT_LEFT(p)] = count;\n"
    "#endif\n"
    "        before = oit_add(before, count);\n"
    "#if OIT_ASYNC\n"
    "        if (before > oit_pool.z && count > 0u)\n"
    "            oit_lose(p, count);\n"
    "#endif\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_store_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// What a fragment shader calls: oit_store(fragment), or oit_store(color). Counts in the count pass; in the fill pass writes\n"
    "// one record of OIT_VECTORS vectors into the pixel's run. Records are written so that their words, compared one after the\n"
    "// other, give the order in which they are composed: depth, part, key, and all else for fragments that tie.\n"
    "layout(early_fragment_tests) in;\n"
    "#if OIT_HAS_COVERAGE && OIT_POST_DEPTH\n"
    "layout(post_depth_coverage) in;\n"
    "#endif\n"
    "#if OIT_PASS == OIT_FILL && OIT_STORE != OIT_FETCH\n"
    "layout(std430, binding = OIT_BINDING_FRAGMENTS) writeonly buffer oit_fragments { OIT_VECTOR oit_data[]; };\n"
    "#endif\n"
    "\n"
    "#define OIT_BLEND_OVER 0u\n"
    "#define OIT_BLEND_ADD 1u\n"
    "#define OIT_BLEND_MULTIPLY 2u\n"
    "#define OIT_BLEND_LINE 3u\n"
    "\n"
    "struct oit_fragment\n"
    "{\n"
    "    vec4 color; // rgb and alpha\n"
    "#if OIT_HAS_PART\n"
    "    uint part;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    uint key;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    uint blend;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    vec3 normal;\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    vec2 uv;\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    uint words[OIT_HOST_WORDS];\n"
    "#endif\n"
    "};\n"
    "\n"
    "// NaN and infinities by their bits: compilers may take comparisons with them away.\n"
    "float oit_finite(float x)\n"
    "{\n"
    "    return (floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u ? 0.0 : x;\n"
    "}\n"
    "\n"
    "vec4 oit_finite(vec4 color)\n"
    "{\n"
    "    vec3 c = vec3(oit_finite(color.r), oit_finite(color.g), oit_finite(color.b));\n"
    "    return vec4(c, clamp(oit_finite(color.a), 0.0, 1.0));\n"
    "}\n"
    "\n"
    "#if OIT_HAS_SLOPE && OIT_PASS == OIT_FILL\n"
    "// What the window depth gains a pixel to the right and a pixel up, for operators; taken where control flow is uniform, as\n"
    "// below.\n"
    "#if OIT_ES\n"
    "#define OIT_DEPTH_SLOPE vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z))\n"
    "#else\n"
    "vec2 oit_depth_slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));\n"
    "#define OIT_DEPTH_SLOPE oit_depth_slope\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "#if OIT_HAS_COVERAGE\n"
    "// The samples that the fragment covers and that lie before the host's opaque things. Where the driver knows coverage only\n"
    "// from before the depth test, and where the host wants it, each sample is a fragment of its own.\n"
    "uint oit_coverage()\n"
    "{\n"
    "#if OIT_POST_DEPTH\n"
    "    return uint(gl_SampleMaskIn[0]);\n"
    "#else\n"
    "    return 1u << uint(gl_SampleID);\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if OIT_POST_DEPTH\n"
    "// The middle of the pixel may lie beyond the edge of the triangle, where the planes of a body's front and back have crossed\n"
    "// already: the depth is that at the middle of the samples that are covered. Derivatives are taken where control flow is\n"
    "// uniform, before whatever the host's main does; ES has no such place.\n"
    "#if OIT_ES\n"
    "#define OIT_SLOPE vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z))\n"
    "#else\n"
    "vec2 oit_slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));\n"
    "#define OIT_SLOPE oit_slope\n"
    "#endif\n"
    "\n"
    "float oit_depth()\n"
    "{\n"
    "    vec2 slope = OIT_SLOPE, sum = vec2(0.0);\n"
    "    uint covered = oit_coverage();\n"
    "    if (covered == oit_samples.x)\n"
    "        return gl_FragCoord.z;\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        vec4 two = oit_positions[i >> 1u];\n"
    "        sum += (covered >> i & 1u) != 0u ? ((i & 1u) != 0u ? two.zw : two.xy) : vec2(0.0);\n"
    "    }\n"
    "    return clamp(gl_FragCoord.z + dot(slope, sum / float(max(bitCount(covered), 1))), 0.0, 1.0);\n"
    "}\n"
    "#else\n"
    "#define oit_depth() gl_FragCoord.z\n"
    "#endif\n"
    "#else\n"
    "#define oit_depth() gl_FragCoord.z\n"
    "#endif\n"
    "\n"
    "// Ascends from the eye on, in either convention. A depth of -0.0 is 0.0.\n"
    "uint oit_depth_bits()\n"
    "{\n"
    "    uint bits = floatBitsToUint(oit_depth());\n"
    "    bits = bits > 0x7fffffffu ? 0u : bits;\n"
    "#if OIT_REVERSED_Z\n"
    "    bits = 0x7fffffffu - bits;\n"
    "#endif\n"
    "    return bits;\n"
    "}\n"
    "\n"
    "uint oit_pixel_index()\n"
    "{\n"
    "    ivec2 at = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    return uint(at.y) * uint(oit_area.z) + uint(at.x);\n"
    "}\n"
    "\n"
    "#if OIT_KEEPS\n"
    "// By what the k nearest are chosen, the same in both geometry passes: all bits of the depth, or (Murray 2016, section 4.2)\n"
    "// 16 of it and then 16 of the part. Never OIT_NONE.\n"
    "uint oit_key(oit_fragment f)\n"
    "{\n"
    "#if OIT_KEY_BITS == 16\n"
    "    uint depth = uint(clamp(gl_FragCoord.z, 0.0, 1.0) * 65534.0);\n",
    "#line 130\n"
    "#if OIT_REVERSED_Z\n"
    "    depth = 65534u - depth;\n"
    "#endif\n"
    "    return depth << 16u | (f.part & 0xffffu);\n"
    "#else\n"
    "    return oit_depth_bits();\n"
    "#endif\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if OIT_KEEPS && OIT_PASS == OIT_COUNT\n"
    "// Leaves the k + 1 smallest keys of the pixel in its k + 1 words, in no order. A word only ever gets smaller, and by a\n"
    "// swap that fails where another fragment was there before. So when the swap succeeds, all that was read of the other words\n"
    "// is still an upper bound of them: the key that goes is the greatest of the k + 2, whatever else is under way, and a key\n"
    "// that is not less than all words read is not less than all words are. The smallest k + 1 stay, in any order of arrival.\n"
    "// No word ever exceeds the limit once it is set, which spares most fragments the search.\n"
    "void oit_select(uint p, uint key)\n"
    "{\n"
    "    uint place = atomicAdd(oit_pixel[OIT_LEFT(p)], 1u);\n"
    "    if (place <= OIT_LAYERS && atomicCompSwap(oit_pixel[OIT_KEY(p, place)], OIT_NONE, key) == OIT_NONE)\n"
    "        return;\n"
    "    while (key < oit_pixel[OIT_LIMIT(p)]) {\n"
    "        uint most = 0u, second = 0u, at = 0u;\n"
    "        for (uint i = 0u; i <= OIT_LAYERS; ++i) {\n"
    "            uint other = oit_pixel[OIT_KEY(p, i)];\n"
    "            second = max(second, min(other, most));\n"
    "            at = other >= most ? i : at;\n"
    "            most = max(most, other);\n"
    "        }\n"
    "        if (key >= most)\n"
    "            return;\n"
    "        if (atomicCompSwap(oit_pixel[OIT_KEY(p, at)], most, key) == most) {\n"
    "            atomicMin(oit_pixel[OIT_LIMIT(p)], max(second, key));\n"
    "            return;\n"
    "        }\n"
    "    }\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if OIT_PASS == OIT_FILL\n"
    "#if OIT_HAS_NORMAL\n"
    "// The octahedron unfolded: both coordinates of a direction in 16 bits each. A normal of no length is that toward the eye.\n"
    "uint oit_pack_normal(vec3 n)\n"
    "{\n"
    "    n = vec3(oit_finite(n.x), oit_finite(n.y), oit_finite(n.z));\n"
    "    float size = abs(n.x) + abs(n.y) + abs(n.z);\n"
    "    n = size > 0.0 && size < 1.0e38 ? n / size : vec3(0.0, 0.0, 1.0);\n"
    "    vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);\n"
    "    return packSnorm2x16(n.z < 0.0 ? folded : n.xy);\n"
    "}\n"
    "#endif\n"
    "\n"
    "void oit_pack(oit_fragment f, out uint w[OIT_VECTORS * OIT_LANES])\n"
    "{\n"
    "    vec4 color = oit_finite(f.color);\n"
    "    for (int i = 0; i < OIT_VECTORS * OIT_LANES; ++i)\n"
    "        w[i] = 0u;\n"
    "    w[0] = oit_depth_bits();\n"
    "#if OIT_HAS_PART\n"
    "    w[OIT_AT_PART] = f.part;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    w[OIT_AT_KEY] = f.key;\n"
    "#endif\n"
    "#if OIT_COLOR == OIT_COLOR_8\n"
    "    uvec3 c = uvec3(clamp(color.rgb, 0.0, 1.0) * 1023.0 + 0.5);\n"
    "    w[OIT_AT_COLOR] = c.r | c.g << 10u | c.b << 20u;\n"
    "#if OIT_HAS_BLEND\n"
    "    w[OIT_AT_COLOR] |= f.blend << 30u;\n"
    "#endif\n"
    "    w[OIT_AT_COLOR + 1] = floatBitsToUint(color.a);\n"
    "#elif OIT_COLOR == OIT_COLOR_HALF\n"
    "    vec3 c = clamp(color.rgb, -65504.0, 65504.0);\n"
    "    w[OIT_AT_COLOR] = packHalf2x16(c.rg);\n"
    "    w[OIT_AT_COLOR + 1] = packHalf2x16(vec2(c.b, color.a));\n"
    "#else\n"
    "    for (int i = 0; i < 4; ++i)\n"
    "        w[OIT_AT_COLOR + i] = floatBitsToUint(color[i]);\n"
    "#endif\n"
    "#if OIT_HAS_BLEND && OIT_COLOR != OIT_COLOR_8\n"
    "    w[OIT_AT_BLEND] = f.blend & 255u;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    w[OIT_AT_NORMAL] = oit_pack_normal(f.normal);\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    w[OIT_AT_UV] = floatBitsToUint(f.uv.x);\n"
    "    w[OIT_AT_UV + 1] = floatBitsToUint(f.uv.y);\n"
    "#endif\n"
    "#if OIT_HAS_COVERAGE\n"
    "    w[OIT_AT_COVERAGE] |= oit_coverage() << uint(OIT_COVERAGE_SHIFT);\n"
    "#endif\n"
    "#if OIT_HAS_SLOPE // halves reach from 2^-24 to 65504: scaled, from 1.5e-11 to 16 a pixel\n"
    "    w[OIT_AT_SLOPE] = packHalf2x16(clamp(OIT_DEPTH_SLOPE * 4096.0, -65504.0, 65504.0));\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    for (int i = 0; i < OIT_HOST_WORDS; ++i)\n"
    "        w[OIT_AT_HOST + i] = f.words[i];\n"
    "#endif\n"
    "}\n"
    "\n"
    "#if OIT_STORE == OIT_FETCH\n"
    "bool oit_before(uvec4 a, uvec4 b)\n"
    "{\n"
    "    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z != b.z ? a.z < b.z : a.w < b.w;\n"
    "}\n"
    "\n"
    "// Into the layers of this pass, nearest first; what falls out is for a later pass. What has been composed is passed over:\n",
    "#line 238\n"
    "// all that comes before the last record that was, and of those like it, which no one can tell apart, as many as were.\n"
    "void oit_put(uint p, uvec4 r)\n"
    "{\n"
    "    uint at = OIT_LAID(p), copies = oit_pixel[at + 4u];\n"
    "    uvec4 last = uvec4(oit_pixel[at], oit_pixel[at + 1u], oit_pixel[at + 2u], oit_pixel[at + 3u]);\n"
    "    oit_seen.y += 1u;\n"
    "    if (copies > 0u && !oit_before(last, r)) {\n"
    "        oit_seen.x += r == last ? 1u : 0u;\n"
    "        if (r != last || oit_seen.x <= copies)\n"
    "            return;\n"
    "    }\n"
    "#define OIT_EXCHANGE(l) if (oit_before(r, l)) { uvec4 kept = l; l = r; r = kept; }\n"
    "    OIT_EACH_LAYER(OIT_EXCHANGE)\n"
    "}\n"
    "#else\n"
    "void oit_write(uint at, uint w[OIT_VECTORS * OIT_LANES])\n"
    "{\n"
    "    for (int i = 0; i < OIT_VECTORS; ++i)\n"
    "#if OIT_LANES == 4\n"
    "        oit_data[at + uint(i)] = uvec4(w[4 * i], w[4 * i + 1], w[4 * i + 2], w[4 * i + 3]);\n"
    "#else\n"
    "        oit_data[at + uint(i)] = uvec2(w[2 * i], w[2 * i + 1]);\n"
    "#endif\n"
    "}\n"
    "#endif\n"
    "\n"
    "#if (OIT_ASYNC || OIT_KEEPS) && OIT_STORE != OIT_FETCH\n"
    "#if OIT_HAS_COVERAGE\n"
    "#define OIT_COVERED_NOW oit_coverage()\n"
    "#else\n"
    "#define OIT_COVERED_NOW 0u\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "#define OIT_BLEND_OF(f) f.blend\n"
    "#else\n"
    "#define OIT_BLEND_OF(f) OIT_BLEND_OVER\n"
    "#endif\n"
    "\n"
    "#if OIT_KEEPS\n"
    "void oit_to_tail(uint p, oit_fragment f)\n"
    "{\n"
    "    oit_add_to_tail(p, oit_tail_amounts(oit_finite(f.color), OIT_BLEND_OF(f), OIT_COVERED_NOW));\n"
    "}\n"
    "#elif OIT_TAIL_WORDS == 6\n"
    "// With the colour as it would be read back: what is stored of the same pixel is added by others from there.\n"
    "void oit_to_tail(uint p, oit_fragment f, uint w[OIT_VECTORS * OIT_LANES])\n"
    "{\n"
    "    uvec4 words = uvec4(w[OIT_AT_COLOR], w[OIT_AT_COLOR + 1], 0u, 0u);\n"
    "#if OIT_COLOR == OIT_COLOR_FLOAT\n"
    "    words.zw = uvec2(w[OIT_AT_COLOR + 2], w[OIT_AT_COLOR + 3]);\n"
    "#endif\n"
    "    oit_add_to_tail(p, oit_tail_amounts(oit_unpack_color(words), OIT_BLEND_OF(f), OIT_COVERED_NOW));\n"
    "}\n"
    "#else\n"
    "// Bits are shared out by the count of the pixel, so that no sum overflows.\n"
    "void oit_to_tail(uint p, uint count, oit_fragment f)\n"
    "{\n"
    "    float scale = exp2(float(26 - findMSB(count) - 1));\n"
    "#if OIT_ADAPTIVE && OIT_HAS_BLEND // equation 5, all fragments of the pixel taken for layers\n"
    "    scale /= f.color.a < 1.0 && f.blend == OIT_BLEND_OVER ? float(count) : 1.0;\n"
    "#elif OIT_ADAPTIVE\n"
    "    scale /= f.color.a < 1.0 ? float(count) : 1.0;\n"
    "#endif\n"
    "    uvec4 parts = uvec4(oit_tail_amounts(oit_finite(f.color), OIT_BLEND_OF(f), OIT_COVERED_NOW) * scale + 0.5);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p)], parts.r);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p) + 1u], parts.g);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p) + 2u], parts.b);\n"
    "    atomicAdd(oit_pixel[OIT_TAIL(p) + 3u], parts.a);\n"
    "}\n"
    "#endif\n"
    "#endif\n"
    "#endif\n"
    "\n"
    "#if OIT_PASS == OIT_FILL && OIT_STORE == OIT_LINKED\n"
    "// Carnecky 2013, algorithm 1. A fragment for which the list is too small counts all the same.\n"
    "void oit_insert(uint p, oit_fragment f)\n"
    "{\n"
    "    uint w[OIT_VECTORS * OIT_LANES];\n"
    "    oit_pack(f, w);\n"
    "    uint slot = atomicAdd(oit_pixel[OIT_TAKEN], 1u);\n"
    "    if (slot >= oit_pool.z) {\n"
    "#if OIT_ASYNC\n"
    "        oit_to_tail(p, f, w);\n"
    "#endif\n"
    "        return;\n"
    "    }\n"
    "    w[OIT_AT_LINK] = atomicExchange(oit_pixel[OIT_HEAD(p)], slot + 1u);\n"
    "    oit_write(slot * uint(OIT_VECTORS), w);\n"
    "}\n"
    "#endif\n"
    "\n"
    "void oit_store(oit_fragment f)\n"
    "{\n"
    "    uint p = oit_pixel_index();\n"
    "#if OIT_HAS_COVERAGE\n"
    "    if (OIT_OUTSIDE)\n"
    "        return;\n"
    "    if (oit_coverage() != oit_samples.x)\n"
    "        oit_pixel[OIT_EDGE(p)] = 1u;\n"
    "#endif\n"
    "#if OIT_KEEPS && OIT_PASS == OIT_COUNT\n"
    "    oit_select(p, oit_key(f));\n"
    "#elif OIT_PASS == OIT_COUNT\n"
    "    atomicAdd(oit_pixel[OIT_WANTED(p)], 1u);\n"
    "#elif OIT_STORE == OIT_FETCH\n"
    "    uint w[4];\n"
    "    oit_pack(f, w);\n"
    "    oit_put(p, uvec4(w[0], w[1], w[2], w[3]));\n"
    "#else\n"
    "#if OIT_KEEPS\n"
    "    if (oit_key(f) >= oit_pixel[OIT_LIMIT(p)]) {\n"
    "        oit_to_tail(p, f);\n"
    "        return;\n"
    "    }\n"
    "#endif\n"
    "    uint left = atomicAdd(oit_pixel[OIT_LEFT(p)], OIT_STORE == OIT_LINKED && OIT_DIRECT ? 1u : 0xffffffffu);\n"
    "#if OIT_ASYNC && (OIT_STORE == OIT_EXACT || OIT_STORE == OIT_LINKED)\n"
    "    if (left >> 30u == 1u) { // OIT_UNFIT, and not what wraps below 0\n",
    "#line 356\n"
    "        if (left == OIT_UNFIT) {\n"
    "            atomicAdd(oit_pixel[OIT_EXTRA], 1u);\n"
    "            return;\n"
    "        }\n"
    "#if OIT_TAIL_WORDS == 4\n"
    "        oit_to_tail(p, oit_pixel[OIT_START(p + 1u)] - oit_pixel[OIT_START(p)], f);\n"
    "#else\n"
    "        uint words[OIT_VECTORS * OIT_LANES];\n"
    "        oit_pack(f, words);\n"
    "        oit_to_tail(p, f, words);\n"
    "#endif\n"
    "        return;\n"
    "    }\n"
    "#endif\n"
    "#if OIT_STORE == OIT_LINKED\n"
    "    if (OIT_DIRECT || left - 1u < oit_pool.z)\n"
    "        oit_insert(p, f);\n"
    "    else\n"
    "        atomicAdd(oit_pixel[OIT_EXTRA], 1u);\n"
    "#else\n"
    "    // Nothing is written outside of the run, however many fragments come: after as many as were counted, what is left is\n"
    "    // 0, and then wraps to more than any pool holds.\n"
    "    uint w[OIT_VECTORS * OIT_LANES];\n"
    "    oit_pack(f, w);\n"
    "    uint slot = oit_pixel[OIT_START(p)] + left - 1u - oit_pool.y;\n"
    "    if (left - 1u >= oit_pool.z || slot >= oit_pool.z) {\n"
    "#if OIT_STORE != OIT_PREDICT\n"
    "        atomicAdd(oit_pixel[OIT_EXTRA], 1u);\n"
    "#elif OIT_ASYNC\n"
    "        oit_to_tail(p, f, w);\n"
    "#endif\n"
    "        return;\n"
    "    }\n"
    "    oit_write(slot * uint(OIT_VECTORS), w);\n"
    "#endif\n"
    "#endif\n"
    "}\n"
    "\n"
    "void oit_store(vec4 color)\n"
    "{\n"
    "    oit_fragment f;\n"
    "    f.color = color;\n"
    "#if OIT_HAS_PART\n"
    "    f.part = 0u;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    f.key = 0u;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    f.blend = OIT_BLEND_OVER;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    f.normal = vec3(0.0, 0.0, 1.0);\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    f.uv = vec2(0.0);\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    for (int i = 0; i < OIT_HOST_WORDS; ++i)\n"
    "        f.words[i] = 0u;\n"
    "#endif\n"
    "    oit_store(f);\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_sum_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The scan, first of three: the fragments of each block, those of the deepest pixel, and how deep the pixels are.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "shared uint oit_sums[128];\n"
    "shared uint oit_most[128];\n"
    "shared uint oit_classes[4];\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n"
    "    uint self = gl_LocalInvocationID.x;\n"
    "    uint sum = 0u, most = 0u;\n"
    "    if (self < 4u)\n"
    "        oit_classes[self] = 0u;\n"
    "    barrier();\n"
    "    for (uint i = 0u; i < 8u; ++i) {\n"
    "        uint p = block * OIT_BLOCK + 128u * i + self;\n"
    "        uint count = p < oit_pool.x ? oit_pixel[OIT_WANTED(p)] : 0u;\n"
    "        sum = oit_add(sum, count);\n"
    "        most = max(most, count);\n"
    "#if OIT_STORE == OIT_FETCH && OIT_ASYNC // layers beyond the passes that the frame has\n"
    "        if (count > oit_step.w * uint(OIT_FETCHED)) {\n"
    "            atomicAdd(oit_pixel[OIT_LOST_PIXELS], 1u);\n"
    "            atomicAdd(oit_pixel[OIT_LOST], count - oit_step.w * uint(OIT_FETCHED));\n"
    "        }\n"
    "#endif\n"
    "        if (count > 0u)\n"
    "            atomicAdd(oit_classes[oit_class(count)], 1u);\n"
    "    }\n"
    "    oit_sums[self] = sum;\n"
    "    oit_most[self] = most;\n"
    "    barrier();\n"
    "    for (uint half_size = 64u; half_size > 0u; half_size >>= 1u) {\n"
    "        if (self < half_size) {\n"
    "            oit_sums[self] = oit_add(oit_sums[self], oit_sums[self + half_size]);\n"
    "            oit_most[self] = max(oit_most[self], oit_most[self + half_size]);\n"
    "        }\n"
    "        barrier();\n"
    "    }\n"
    "    bool known = OIT_STORE != OIT_PREDICT || !OIT_DIRECT; // what is only guessed is not reported\n"
    "    if (known && self < 4u && oit_classes[self] > 0u)\n"
    "        atomicAdd(oit_pixel[OIT_PIXELS + self], oit_classes[self]);\n"
    "    if (self == 0u && block < oit_pool.w) {\n"
    "        oit_pixel[OIT_SUM(block)] = oit_sums[0];\n"
    "        if (known)\n"
    "            atomicMax(oit_pixel[OIT_DEEPEST], oit_most[0]);\n"
    "    }\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_surface_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Built-in surfaces: the object's colour, lit from both sides where the frame has a light.\n"
    "#if OIT_PASS == OIT_FILL\n"
    "in vec3 oit_v_color;\n"
    "uniform vec4 oit_object_color;\n"
    "#endif\n"
    "#if OIT_WANTS_NORMAL\n"
    "in vec3 oit_v_normal;\n"
    "#endif\n"
    "#if (OIT_PASS == OIT_FILL && (OIT_HAS_PART || OIT_HAS_KEY || OIT_HAS_BLEND || OIT_HAS_NORMAL)) || OIT_KEY_BITS == 16\n"
    "uniform uvec4 oit_object; // part, key, blend, whether normals go with the side that is seen\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if OIT_PASS == OIT_COUNT && OIT_KEY_BITS == 16\n"
    "    oit_fragment f;\n"
    "    f.part = oit_object.x;\n"
    "    oit_store(f);\n"
    "#elif OIT_PASS == OIT_COUNT\n"
    "    oit_store(vec4(0.0));\n"
    "#else\n"
    "    vec4 color = oit_object_color;\n"
    "    color.rgb += oit_v_color;\n"
    "#if OIT_WANTS_NORMAL\n"
    "    float size = dot(oit_v_normal, oit_v_normal);\n"
    "    vec3 normal = size > 1.0e-30 ? oit_v_normal * inversesqrt(size) : vec3(0.0, 0.0, 1.0);\n"
    "#endif\n"
    "#if OIT_LIT\n"
    "    color.rgb *= 0.35 + 0.65 * abs(dot(normal, oit_light.xyz));\n"
    "#endif\n"
    "#if OIT_PREMULTIPLIED\n"
    "    color.rgb *= color.a;\n"
    "#endif\n"
    "    oit_fragment f;\n"
    "    f.color = color;\n"
    "#if OIT_HAS_PART\n"
    "    f.part = oit_object.x;\n"
    "#endif\n"
    "#if OIT_HAS_KEY\n"
    "    f.key = oit_object.y;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    f.blend = oit_object.z;\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "    f.normal = oit_object.w != 0u && !gl_FrontFacing ? -normal : normal;\n"
    "#endif\n"
    "#if OIT_HAS_UV\n"
    "    f.uv = vec2(0.0);\n"
    "#endif\n"
    "#if OIT_HOST_WORDS > 0\n"
    "    for (int i = 0; i < OIT_HOST_WORDS; ++i)\n"
    "        f.words[i] = 0u;\n"
    "#endif\n"
    "    oit_store(f);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_surface_vert[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// Built-in surfaces, for hosts without shaders: position, normal, colour to be added. The count pass needs no more than\n"
    "// the position.\n"
    "layout(location = 0) in vec3 oit_position;\n"
    "uniform mat4 oit_model_view_projection;\n"
    "#if OIT_PASS == OIT_FILL\n"
    "layout(location = 3) in vec3 oit_vertex_color;\n"
    "out vec3 oit_v_color;\n"
    "#endif\n"
    "#if OIT_WANTS_NORMAL\n"
    "layout(location = 1) in vec3 oit_normal;\n"
    "uniform mat3 oit_normal_matrix;\n"
    "out vec3 oit_v_normal;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "    gl_Position = oit_model_view_projection * vec4(oit_position, 1.0);\n"
    "#if OIT_PASS == OIT_FILL\n"
    "    oit_v_color = oit_vertex_color;\n"
    "#endif\n"
    "#if OIT_WANTS_NORMAL\n"
    "    oit_v_normal = oit_normal_matrix * oit_normal;\n"
    "#endif\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_tail_frag[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The pixels whose runs did not fit, from the sums of oit_to_tail: layers of mean colour, as thick as all together.\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "layout(location = 0, index = 0) out highp vec4 oit_out;\n"
    "layout(location = 0, index = 1) out highp vec4 oit_keep;\n"
    "#else\n"
    "layout(location = 0) out highp vec4 oit_out;\n"
    "#endif\n"
    "\n"
    "void main()\n"
    "{\n"
    "#if OIT_HAS_COVERAGE\n"
    "    if (OIT_OUTSIDE)\n"
    "        discard;\n"
    "#endif\n"
    "    ivec2 where = ivec2(gl_FragCoord.xy) - oit_area.xy;\n"
    "    uint p = uint(where.y) * uint(oit_area.z) + uint(where.x);\n"
    "    uint start = oit_pixel[OIT_START(p)], end = oit_pixel[OIT_START(p + 1u)];\n"
    "#if OIT_KEEPS\n"
    "    // Where some fragments are kept, the tail is laid behind them with the run.\n"
    "    start += uint(max(int(oit_pixel[OIT_LEFT(p)]), 0));\n"
    "    if (end != start || oit_pixel[OIT_LIMIT(p)] == OIT_NONE)\n"
    "        discard;\n"
    "    vec4 sums = oit_tail_sums(p);\n"
    "#elif OIT_STORE == OIT_PREDICT\n"
    "    int left = OIT_TRUE_LEFT(oit_pixel[OIT_LEFT(p)]);\n"
    "    if ((end <= oit_pool.z && left >= 0) || int(end - start) == left)\n"
    "        discard;\n"
    "    vec4 sums = oit_tail_sums(p);\n"
    "#else\n"
    "    if (end <= oit_pool.z || end == start)\n"
    "        discard;\n"
    "#if OIT_TAIL_WORDS == 6\n"
    "    vec4 sums = oit_tail_sums(p);\n"
    "#else\n"
    "    vec4 sums = oit_tail_sums(p, end - start);\n"
    "#endif\n"
    "#endif\n"
    "    vec4 tail = oit_tail_light(sums);\n"
    "    vec3 sum = tail.rgb;\n"
    "    float through = tail.a;\n"
    "#if OIT_MODE == OIT_MODE_DUAL\n"
    "    oit_out = vec4(sum, 0.0);\n"
    "    oit_keep = vec4(vec3(oit_light.w * through), 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_FILTER\n"
    "    oit_out = vec4(vec3(oit_light.w * through), 0.0);\n"
    "#elif OIT_MODE == OIT_MODE_LIGHT\n"
    "    oit_out = vec4(sum, 0.0);\n"
    "#else\n"
    "    oit_out = vec4(sum, oit_light.w * through);\n"
    "#endif\n"
    "}\n",
    0};
static const char *const oit_i_shader_oit_tail_glsl[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The pixel buffer, and what a fragment adds to the tail: sums that do not depend on the order, in integers so that rounding\n"
    "// does not either. The layers of a pixel are taken as mixed evenly: optical depths add, colours are weighted by them.\n"
    "#if OIT_KEEPS && OIT_PASS == OIT_COUNT\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) coherent buffer oit_pixels { uint oit_pixel[]; };\n"
    "#else\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "#endif\n"
    "\n"
    "#if OIT_ASYNC || OIT_KEEPS\n"
    "// Light and optical depth of one fragment: colours up to 4 and optical depths up to 11 make less than 64 each. By one chain of\n"
    "// roundings, whichever shader asks.\n"
    "vec4 oit_tail_amounts(vec4 color, uint blend, uint covered)\n"
    "{\n"
    "#if OIT_HAS_COVERAGE // the tail knows no samples: a fragment is as much thinner as it covers less of the pixel\n"
    "    color *= vec4(vec3(OIT_PREMULTIPLIED == 1 ? OIT_SHARE(covered) : 1.0), OIT_SHARE(covered));\n"
    "#endif\n"
    "    OIT_PRECISE float thickness = min(-log(1.0 - min(color.a, 0.999999)), 11.0);\n"
    "    vec3 c = clamp(color.rgb, 0.0, 4.0);\n"
    "#if OIT_PREMULTIPLIED\n"
    "    c = color.a > 0.0 ? min(c / color.a, vec3(4.0)) : c;\n"
    "    float weight = color.a > 0.0 ? thickness : 1.0;\n"
    "#else\n"
    "    float weight = thickness;\n"
    "#endif\n"
    "#if OIT_HAS_BLEND\n"
    "    if (blend == 1u) { // add\n"
    "        c = clamp(color.rgb, 0.0, 4.0); // premultiplied light needs no alpha\n"
    "        weight = OIT_PREMULTIPLIED == 1 ? 1.0 : color.a;\n"
    "        thickness = 0.0;\n"
    "    } else if (blend == 2u) { // multiply\n"
    "        OIT_PRECISE float keep = 1.0 - color.a * (1.0 - min((c.r + c.g + c.b) / 3.0, 1.0));\n"
    "        thickness = min(-log(max(keep, 1.0e-6)), 11.0);\n"
    "        weight = 0.0;\n"
    "    }\n"
    "#endif\n"
    "    OIT_PRECISE vec3 light = c * weight;\n"
    "    return vec4(light, thickness);\n"
    "}\n"
    "\n"
    "#if OIT_TAIL_WORDS == 6\n"
    "// Where the count is not known before. In units of 2^-26, with 16 more bits by carries: how many there are follows from the\n"
    "// sum alone. A fragment makes less than one, so that 65,535 fragments do not overflow.\n"
    "void oit_add_to_tail(uint p, vec4 amounts)\n"
    "{\n"
    "    uvec4 parts = uvec4(amounts * 67108864.0 + 0.5);\n"
    "    for (uint c = 0u; c < 4u; ++c) {\n"
    "        uint before = atomicAdd(oit_pixel[OIT_TAIL(p) + c], parts[c]);\n"
    "        if (before > 0xffffffffu - parts[c])\n"
    "            atomicAdd(oit_pixel[OIT_TAIL(p) + 4u + (c >> 1u)], 1u << (16u * (c & 1u)));\n"
    "    }\n"
    "}\n"
    "#endif\n"
    "#endif\n",
    0};
static const char *const oit_i_shader_oit_tops_comp[] = {
    "#line 1\n"
    "// For: oit_buffers.h\n"
    "// The scan, second of three: sums of blocks become what lies before each block. One work group, whatever the size.\n"
    "layout(local_size_x = 128) in;\n"
    "layout(std430, binding = OIT_BINDING_PIXELS) buffer oit_pixels { uint oit_pixel[]; };\n"
    "\n"
    "void main()\n"
    "{\n"
    "    uint self = gl_LocalInvocationID.x;\n"
    "    uint each = (oit_pool.w + 127u) / 128u;\n"
    "    uint first = min(self * each, oit_pool.w), end = min(first + each, oit_pool.w);\n"
    "    uint sum = 0u;\n"
    "    for (uint b = first; b < end; ++b)\n"
    "        sum = oit_add(sum, oit_pixel[OIT_SUM(b)]);\n"
    "    uint before = oit_scan(self, sum);\n"
    "    for (uint b = first; b < end; ++b) {\n"
    "        uint here = oit_pixel[OIT_SUM(b)];\n"
    "        oit_pixel[OIT_SUM(b)] = before;\n"
    "        before = oit_add(before, here);\n"
    "    }\n"
    "    if (self == 127u) {\n"
    "        oit_pixel[OIT_START(oit_pool.x)] = oit_add(before, oit_all_lost(before));\n"
    "        oit_pixel[OIT_TOTAL] = before;\n"
    "        if (OIT_STORE != OIT_PREDICT || !OIT_DIRECT)\n"
    "            oit_pixel[OIT_NEEDED] = max(oit_pixel[OIT_NEEDED], before);\n"
    "    }\n"
    "}\n",
    0};
/* clang-format on */
/* ==== end of generated shaders ==== */
/* clang-format on */

/* ---- GL: enumerants and the function table ---------------------------------------------------------------------- */

#define OIT_I_GL_ACTIVE_UNIFORMS 0x8B86u
#define OIT_I_GL_ALWAYS 0x0207u
#define OIT_I_GL_ALREADY_SIGNALED 0x911Au
#define OIT_I_GL_BLEND 0x0BE2u
#define OIT_I_GL_MULTISAMPLE 0x809Du
#define OIT_I_GL_SAMPLE_POSITION 0x8E50u
#define OIT_I_GL_SAMPLE_SHADING 0x8C36u
#define OIT_I_GL_BLEND_DST_ALPHA 0x80CAu
#define OIT_I_GL_BLEND_DST_RGB 0x80C8u
#define OIT_I_GL_BLEND_EQUATION_ALPHA 0x883Du
#define OIT_I_GL_BLEND_EQUATION_RGB 0x8009u
#define OIT_I_GL_BLEND_SRC_ALPHA 0x80CBu
#define OIT_I_GL_BLEND_SRC_RGB 0x80C9u
#define OIT_I_GL_BUFFER_SIZE 0x8764u
#define OIT_I_GL_BUFFER_UPDATE_BARRIER 0x00000200u
#define OIT_I_GL_CLIP_DISTANCE0 0x3000u
#define OIT_I_GL_COLOR_ATTACHMENT0 0x8CE0u
#define OIT_I_GL_COLOR_LOGIC_OP 0x0BF2u
#define OIT_I_GL_COLOR_WRITEMASK 0x0C23u
#define OIT_I_GL_COMPILE_STATUS 0x8B81u
#define OIT_I_GL_COMPUTE_SHADER 0x91B9u
#define OIT_I_GL_CONDITION_SATISFIED 0x911Cu
#define OIT_I_GL_COPY_WRITE_BUFFER 0x8F37u
#define OIT_I_GL_CULL_FACE 0x0B44u
#define OIT_I_GL_CURRENT_PROGRAM 0x8B8Du
#define OIT_I_GL_DEPTH 0x1801u
#define OIT_I_GL_DEPTH_ATTACHMENT 0x8D00u
#define OIT_I_GL_DEPTH_CLAMP 0x864Fu
#define OIT_I_GL_DEPTH_FUNC 0x0B74u
#define OIT_I_GL_DEPTH_RANGE 0x0B70u
#define OIT_I_GL_DEPTH_TEST 0x0B71u
#define OIT_I_GL_DEPTH_WRITEMASK 0x0B72u
#define OIT_I_GL_DITHER 0x0BD0u
#define OIT_I_GL_DRAW_FRAMEBUFFER 0x8CA9u
#define OIT_I_GL_DRAW_FRAMEBUFFER_BINDING 0x8CA6u
#define OIT_I_GL_DYNAMIC_COPY 0x88EAu
#define OIT_I_GL_DYNAMIC_DRAW 0x88E8u
#define OIT_I_GL_DYNAMIC_READ 0x88E9u
#define OIT_I_GL_EXTENSIONS 0x1F03u
#define OIT_I_GL_FILL 0x1B02u
#define OIT_I_GL_FRAGMENT_SHADER 0x8B30u
#define OIT_I_GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME 0x8CD1u
#define OIT_I_GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE 0x8CD0u
#define OIT_I_GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL 0x8CD2u
#define OIT_I_GL_FRAMEBUFFER_COMPLETE 0x8CD5u
#define OIT_I_GL_FRONT_AND_BACK 0x0408u
#define OIT_I_GL_FUNC_ADD 0x8006u
#define OIT_I_GL_GREATER 0x0204u
#define OIT_I_GL_LESS 0x0201u
#define OIT_I_GL_LINK_STATUS 0x8B82u
#define OIT_I_GL_MAP_READ_BIT 0x0001u
#define OIT_I_GL_MAX_CLIP_DISTANCES 0x0D32u
#define OIT_I_GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES 0x8F39u
#define OIT_I_GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS 0x90DBu
#define OIT_I_GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS 0x90EBu
#define OIT_I_GL_MAX_DRAW_BUFFERS 0x8824u
#define OIT_I_GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS 0x90DAu
#define OIT_I_GL_MAX_SHADER_STORAGE_BLOCK_SIZE 0x90DEu
#define OIT_I_GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS 0x90DDu
#define OIT_I_GL_MAX_UNIFORM_BUFFER_BINDINGS 0x8A2Fu
#define OIT_I_GL_MAX_VIEWPORTS 0x825Bu
#define OIT_I_GL_MAX_VIEWPORT_DIMS 0x0D3Au
#define OIT_I_GL_NUM_EXTENSIONS 0x821Du
#define OIT_I_GL_ONE 1u
#define OIT_I_GL_POLYGON_MODE 0x0B40u
#define OIT_I_GL_POLYGON_OFFSET_FILL 0x8037u
#define OIT_I_GL_POLYGON_OFFSET_LINE 0x2A02u
#define OIT_I_GL_POLYGON_OFFSET_POINT 0x2A01u
#define OIT_I_GL_RENDERBUFFER 0x8D41u
#define OIT_I_GL_RG32UI 0x823Cu
#define OIT_I_GL_RGBA32UI 0x8D70u
#define OIT_I_GL_RASTERIZER_DISCARD 0x8C89u
#define OIT_I_GL_SAMPLES 0x80A9u
#define OIT_I_GL_SAMPLE_ALPHA_TO_COVERAGE 0x809Eu
#define OIT_I_GL_SAMPLE_COVERAGE 0x80A0u
#define OIT_I_GL_SAMPLE_MASK 0x8E51u
#define OIT_I_GL_SCISSOR_BOX 0x0C10u
#define OIT_I_GL_SCISSOR_TEST 0x0C11u
#define OIT_I_GL_SHADER_STORAGE_BARRIER 0x00002000u
#define OIT_I_GL_SHADER_STORAGE_BUFFER 0x90D2u
#define OIT_I_GL_SHADER_STORAGE_BUFFER_BINDING 0x90D3u
#define OIT_I_GL_SHADER_STORAGE_BUFFER_SIZE 0x90D5u
#define OIT_I_GL_SHADER_STORAGE_BUFFER_START 0x90D4u
#define OIT_I_GL_SRC1_COLOR 0x88F9u
#define OIT_I_GL_SRC_ALPHA 0x0302u
#define OIT_I_GL_SRC_COLOR 0x0300u
#define OIT_I_GL_STENCIL_TEST 0x0B90u
#define OIT_I_GL_SYNC_FLUSH_COMMANDS_BIT 0x0001u
#define OIT_I_GL_SYNC_GPU_COMMANDS_COMPLETE 0x9117u
#define OIT_I_GL_TEXTURE 0x1702u
#define OIT_I_GL_TEXTURE_2D 0x0DE1u
#define OIT_I_GL_TEXTURE_BINDING_2D 0x8069u
#define OIT_I_GL_TRIANGLES 0x0004u
#define OIT_I_GL_UNIFORM_BUFFER 0x8A11u
#define OIT_I_GL_UNIFORM_BUFFER_BINDING 0x8A28u
#define OIT_I_GL_UNIFORM_BUFFER_SIZE 0x8A2Au
#define OIT_I_GL_UNIFORM_BUFFER_START 0x8A29u
#define OIT_I_GL_VERSION 0x1F02u
#define OIT_I_GL_VERTEX_ARRAY_BINDING 0x85B5u
#define OIT_I_GL_VERTEX_SHADER 0x8B31u
#define OIT_I_GL_VIEWPORT 0x0BA2u
#define OIT_I_GL_ZERO 0u

typedef uint32_t oit_i_u;
typedef const char *const *oit_i_strings;

/* X(result type, name without gl, parameters), with C's types for GL's of the same size. What oit_create asks with. */
#define OIT_I_GL_QUERIES(X)                                                                                            \
    X(const unsigned char *, GetString, (oit_i_u))                                                                     \
    X(const unsigned char *, GetStringi, (oit_i_u, oit_i_u))                                                           \
    X(void, GetIntegerv, (oit_i_u, int32_t *))                                                                         \
    X(void, GetInteger64v, (oit_i_u, int64_t *))

#define OIT_I_GL_REQUIRED(X)                                                                                           \
    X(void, AttachShader, (oit_i_u, oit_i_u))                                                                          \
    X(void, BindBuffer, (oit_i_u, oit_i_u))                                                                            \
    X(void, BindBufferBase, (oit_i_u, oit_i_u, oit_i_u))                                                               \
    X(void, BindBufferRange, (oit_i_u, oit_i_u, oit_i_u, ptrdiff_t, ptrdiff_t))                                        \
    X(void, BindFramebuffer, (oit_i_u, oit_i_u))                                                                       \
    X(void, BindVertexArray, (oit_i_u))                                                                                \
    X(void, BlendEquationSeparate, (oit_i_u, oit_i_u))                                                                 \
    X(void, BlendFuncSeparate, (oit_i_u, oit_i_u, oit_i_u, oit_i_u))                                                   \
    X(void, BufferData, (oit_i_u, ptrdiff_t, const void *, oit_i_u))                                                   \
    X(void, BufferSubData, (oit_i_u, ptrdiff_t, ptrdiff_t, const void *))                                              \
    X(oit_i_u, CheckFramebufferStatus, (oit_i_u))                                                                      \
    X(oit_i_u, ClientWaitSync, (oit_i_sync, oit_i_u, uint64_t))                                                        \
    X(void, ColorMask, (unsigned char, unsigned char, unsigned char, unsigned char))                                   \
    X(void, CompileShader, (oit_i_u))                                                                                  \
    X(oit_i_u, CreateProgram, (void))                                                                                  \
    X(oit_i_u, CreateShader, (oit_i_u))                                                                                \
    X(void, DeleteBuffers, (int32_t, const oit_i_u *))                                                                 \
    X(void, DeleteProgram, (oit_i_u))                                                                                  \
    X(void, DeleteShader, (oit_i_u))                                                                                   \
    X(void, DeleteSync, (oit_i_sync))                                                                                  \
    X(void, DeleteVertexArrays, (int32_t, const oit_i_u *))                                                            \
    X(void, DepthFunc, (oit_i_u))                                                                                      \
    X(void, DepthMask, (unsigned char))                                                                                \
    X(void, Disable, (oit_i_u))                                                                                        \
    X(void, DispatchCompute, (oit_i_u, oit_i_u, oit_i_u))                                                              \
    X(void, DrawArrays, (oit_i_u, int32_t, int32_t))                                                                   \
    X(void, Enable, (oit_i_u))                                                                                         \
    X(oit_i_sync, FenceSync, (oit_i_u, oit_i_u))                                                                       \
    X(void, GenBuffers, (int32_t, oit_i_u *))                                                                          \
    X(void, GenVertexArrays, (int32_t, oit_i_u *))                                                                     \
    X(void, GetBooleanv, (oit_i_u, unsigned char *))                                                                   \
    X(void, GetBufferParameteri64v, (oit_i_u, oit_i_u, int64_t *))                                                     \
    X(void, GetFloatv, (oit_i_u, float *))                                                                             \
    X(void, GetInteger64i_v, (oit_i_u, oit_i_u, int64_t *))                                                            \
    X(void, GetIntegeri_v, (oit_i_u, oit_i_u, int32_t *))                                                              \
    X(void, GetProgramInfoLog, (oit_i_u, int32_t, int32_t *, char *))                                                  \
    X(void, GetProgramiv, (oit_i_u, oit_i_u, int32_t *))                                                               \
    X(void, GetShaderInfoLog, (oit_i_u, int32_t, int32_t *, char *))                                                   \
    X(void, GetShaderiv, (oit_i_u, oit_i_u, int32_t *))                                                                \
    X(void, GetMultisamplefv, (oit_i_u, oit_i_u, float *))                                                             \
    X(int32_t, GetUniformLocation, (oit_i_u, const char *))                                                            \
    X(unsigned char, IsEnabled, (oit_i_u))                                                                             \
    X(unsigned char, IsProgram, (oit_i_u))                                                                             \
    X(void, LinkProgram, (oit_i_u))                                                                                    \
    X(void *, MapBufferRange, (oit_i_u, ptrdiff_t, ptrdiff_t, oit_i_u))                                                \
    X(void, MemoryBarrier, (oit_i_u))                                                                                  \
    X(void, ProgramUniform4fv, (oit_i_u, int32_t, int32_t, const float *))                                             \
    X(void, ProgramUniform4uiv, (oit_i_u, int32_t, int32_t, const oit_i_u *))                                          \
    X(void, Scissor, (int32_t, int32_t, int32_t, int32_t))                                                             \
    X(void, ShaderSource, (oit_i_u, int32_t, const char *const *, const int32_t *))                                    \
    X(void, Uniform4fv, (int32_t, int32_t, const float *))                                                             \
    X(void, Uniform4uiv, (int32_t, int32_t, const oit_i_u *))                                                          \
    X(void, UniformMatrix3fv, (int32_t, int32_t, unsigned char, const float *))                                        \
    X(void, UniformMatrix4fv, (int32_t, int32_t, unsigned char, const float *))                                        \
    X(unsigned char, UnmapBuffer, (oit_i_u))                                                                           \
    X(void, UseProgram, (oit_i_u))                                                                                     \
    X(void, Viewport, (int32_t, int32_t, int32_t, int32_t))

/* Desktop GL: by 4.3 all of this is there. */
#define OIT_I_GL_DESKTOP(X)                                                                                            \
    X(void, DepthRangeIndexed, (oit_i_u, double, double))                                                              \
    X(void, GetDoublei_v, (oit_i_u, oit_i_u, double *))                                                                \
    X(void, GetFloati_v, (oit_i_u, oit_i_u, float *))                                                                  \
    X(void, PolygonMode, (oit_i_u, oit_i_u))                                                                           \
    X(void, ScissorIndexed, (oit_i_u, int32_t, int32_t, int32_t, int32_t))                                             \
    X(void, ViewportIndexedf, (oit_i_u, float, float, float, float))

/* Desktop GL, and ES from 3.2: blending, masks and switches by draw buffer. */
#define OIT_I_GL_INDEXED(X)                                                                                            \
    X(void, BlendEquationSeparatei, (oit_i_u, oit_i_u, oit_i_u))                                                       \
    X(void, BlendFuncSeparatei, (oit_i_u, oit_i_u, oit_i_u, oit_i_u, oit_i_u))                                         \
    X(void, ColorMaski, (oit_i_u, unsigned char, unsigned char, unsigned char, unsigned char))                         \
    X(void, Disablei, (oit_i_u, oit_i_u))                                                                              \
    X(void, Enablei, (oit_i_u, oit_i_u))                                                                               \
    X(void, GetBooleani_v, (oit_i_u, oit_i_u, unsigned char *))                                                        \
    X(unsigned char, IsEnabledi, (oit_i_u, oit_i_u))

#define OIT_I_GL_ES(X) X(void, DepthRangef, (float, float))

/* OIT_STORE_FETCH alone. */
#define OIT_I_GL_FETCH(X)                                                                                              \
    X(void, BindTexture, (oit_i_u, oit_i_u))                                                                           \
    X(void, DeleteFramebuffers, (int32_t, const oit_i_u *))                                                            \
    X(void, DeleteTextures, (int32_t, const oit_i_u *))                                                                \
    X(void, DrawBuffers, (int32_t, const oit_i_u *))                                                                   \
    X(void, FramebufferRenderbuffer, (oit_i_u, oit_i_u, oit_i_u, oit_i_u))                                             \
    X(void, FramebufferTexture2D, (oit_i_u, oit_i_u, oit_i_u, oit_i_u, int32_t))                                       \
    X(void, GenFramebuffers, (int32_t, oit_i_u *))                                                                     \
    X(void, GenTextures, (int32_t, oit_i_u *))                                                                         \
    X(void, GetFramebufferAttachmentParameteriv, (oit_i_u, oit_i_u, oit_i_u, int32_t *))                               \
    X(void, TexStorage2D, (oit_i_u, int32_t, oit_i_u, int32_t, int32_t))

typedef void *oit_i_sync;

/* Members are pasted names, because <windows.h> has a macro for one of them. */
typedef struct oit_i_gl {
#define OIT_I_MEMBER(type, name, parameters) type(OIT_I_GLAPI *gl_##name) parameters;
    OIT_I_GL_QUERIES(OIT_I_MEMBER)
    OIT_I_GL_REQUIRED(OIT_I_MEMBER)
    OIT_I_GL_DESKTOP(OIT_I_MEMBER)
    OIT_I_GL_INDEXED(OIT_I_MEMBER)
    OIT_I_GL_ES(OIT_I_MEMBER)
    OIT_I_GL_FETCH(OIT_I_MEMBER)
#undef OIT_I_MEMBER
} oit_i_gl;

/* ---- the context ------------------------------------------------------------------------------------------------ */

/* Buffers; the first three by their binding points. */
enum {
    OIT_I_PIXELS,
    OIT_I_FRAGMENTS,
    OIT_I_REPORT,
    OIT_I_UNIFORMS = OIT_I_REPORT + 3,
    OIT_I_LIST, /* OIT_STORE_LINKED */
    OIT_I_PICKED,
    OIT_I_SURFACE = OIT_I_PICKED + OIT_MAX_PICKS, /* of operators; bound in the place of the report */
    OIT_I_BUFFER_COUNT
};
#define OIT_I_REPORTS 3

/* Runs are composed by programs for so many fragments, the last for all that are deeper. */
#define OIT_I_CLASSES 4
static const int oit_i_class_sizes[OIT_I_CLASSES] = {8, 16, 32, 32};

/* How a composed pixel goes into the target. */
enum {
    OIT_I_MODE_OVER,   /* light and what is kept of the background, one number for all channels */
    OIT_I_MODE_DUAL,   /* one for each channel, by dual-source blending */
    OIT_I_MODE_FILTER, /* the same in two draws, first what is kept */
    OIT_I_MODE_LIGHT
};

enum {
    OIT_I_PROGRAM_CLEAR,
    OIT_I_PROGRAM_SUM,
    OIT_I_PROGRAM_TOPS,
    OIT_I_PROGRAM_SPREAD,
    OIT_I_PROGRAM_REPORT,
    OIT_I_PROGRAM_KEEP,
    OIT_I_PROGRAM_ARRANGE,
    OIT_I_PROGRAM_PREDICT,
    OIT_I_PROGRAM_SETTLE,
    OIT_I_PROGRAM_GATHER,
    OIT_I_PROGRAM_COUNT,
    OIT_I_PROGRAM_FILL,
    OIT_I_PROGRAM_FILL_LIT,
    OIT_I_PROGRAM_FIRST, /* OIT_STORE_FETCH */
    OIT_I_PROGRAM_LAY,
    OIT_I_PROGRAM_COMPOSE, /* one a class, then that of the tail; all once more for the second draw */
    OIT_I_PROGRAM_SAMPLED = OIT_I_PROGRAM_COMPOSE + 2 * (OIT_I_CLASSES + 1), /* the same, sample by sample */
    OIT_I_PROGRAM_PICK = OIT_I_PROGRAM_SAMPLED + 2 * (OIT_I_CLASSES + 1),
    OIT_I_PROGRAM_DEPTH,
    OIT_I_PROGRAM_SORT, /* of operators, made when they are run */
    OIT_I_PROGRAM_CONNECT,
    OIT_I_PROGRAM_MUTUAL,
    OIT_I_PROGRAM_LAW,
    OIT_I_PROGRAM_BOUND,
    OIT_I_PROGRAM_SOLVE,
    OIT_I_PROGRAM_JUMP,
    OIT_I_PROGRAM_CHAIN,
    OIT_I_PROGRAM_CURVE,
    OIT_I_PROGRAM_GROUP,
    OIT_I_PROGRAM_SIZE,
    OIT_I_PROGRAM_WINDOW,
    OIT_I_PROGRAM_LAID,
    OIT_I_PROGRAM_LAID_LIGHT, /* the second draw, as of OIT_I_PROGRAM_COMPOSE */
    OIT_I_PROGRAMS,
    OIT_I_PROGRAM_HOST /* the host's own operator */
};

typedef struct oit_i_surface {
    int32_t model_view_projection, normal_matrix, color, object;
} oit_i_surface;

/* The uniform block oit_frame of shaders/oit_frame_block.glsl, std140. */
typedef struct oit_i_block {
    int32_t area[4];
    oit_i_u pool[4], step[4], above[4];
    float light[4], output[4];
    int32_t part[4];
    oit_i_u samples[4];
    float positions[OIT_MAX_SAMPLES][2];
} oit_i_block;

/* A fragment that is asked for: free, asked for, left to the GPU, known without it (outside of the viewport). */
enum { OIT_I_PICK_FREE, OIT_I_PICK_ASKED, OIT_I_PICK_RUNS, OIT_I_PICK_OUTSIDE };
#define OIT_I_PICK_WORDS 32 /* x, y, layer; layers, found; the record */

typedef struct oit_i_pick_slot {
    int state, x, y, layer;
    uint64_t turn, frame;
    void *fence;
} oit_i_pick_slot;

#define OIT_I_HEADER_WORDS 16
#define OIT_I_SCAN_BLOCK 1024
#define OIT_I_STORAGE_BINDINGS 3
#define OIT_I_MAX_DRAW_BUFFERS 8
#define OIT_I_MAX_CLIP_DISTANCES 8
#define OIT_I_MAX_VIEWPORTS 16
#define OIT_I_CAP_COUNT 16

/* A binding point of a buffer with its range. */
typedef struct oit_i_binding {
    int32_t buffer;
    int64_t start, size;
} oit_i_binding;

/* State that a frame changes: exactly what OIT_STATE_RESTORE puts back. */
typedef struct oit_i_snapshot {
    int32_t program, vertex_array, framebuffer;
    unsigned char caps[OIT_I_CAP_COUNT], clip_distances[OIT_I_MAX_CLIP_DISTANCES];
    unsigned char scissors[OIT_I_MAX_VIEWPORTS];
    unsigned char depth_mask, color_masks[OIT_I_MAX_DRAW_BUFFERS][4], blend;
    int32_t depth_func, polygon_mode[2], scissor[4];
    float viewport[4];
    double depth_range[2];
    int32_t blend_func[4], blend_equation[2];
    oit_i_binding storage[OIT_I_STORAGE_BINDINGS], uniforms;
    int32_t storage_buffer, uniform_buffer, copy_buffer;
} oit_i_snapshot;

/* Where a frame stands: the next thing to be done. */
typedef enum oit_i_step {
    OIT_I_STEP_CLEAR,
    OIT_I_STEP_COUNT,
    OIT_I_STEP_SUM,
    OIT_I_STEP_TOPS,
    OIT_I_STEP_SPREAD,
    OIT_I_STEP_MEASURE, /* OIT_FIT_WAIT: totals to the report, and read */
    OIT_I_STEP_PREDICT,
    OIT_I_STEP_SETTLE,
    OIT_I_STEP_GATHER,
    OIT_I_STEP_FIRST, /* OIT_STORE_FETCH: its targets made empty; then, after each fill, */
    OIT_I_STEP_LAY,
    OIT_I_STEP_CHECK, /* OIT_FIT_WAIT: totals again, to see whether all that was stored before it was counted found place */
    OIT_I_STEP_FILL,
    OIT_I_STEP_FILLED, /* all that is stored of the last part, which waits for oit_compose */
    OIT_I_STEP_PICK,
    OIT_I_STEP_COMPOSE,
    OIT_I_STEP_DEPTH,
    OIT_I_STEP_COMPOSED,
    OIT_I_STEP_REPORT,
    OIT_I_STEP_KEEP,
    OIT_I_STEP_ARRANGE,
    OIT_I_STEP_OPERATE, /* what oit_run asks for */
    OIT_I_STEP_DONE
} oit_i_step;

/* What a store does up to composing a slab, in this order; bands begin again at part_start. The last is
   OIT_I_STEP_FILLED. */
#define OIT_I_MAX_STEPS 12
typedef struct oit_i_list {
    unsigned char steps[OIT_I_MAX_STEPS];
    oit_i_step part_start;
    int direct; /* 1: the fragments are stored before they are counted; 2: they are stored again */
} oit_i_list;

/* Sections of the buffer of the surfaces: see shaders/oit_operator.glsl. */
enum {
    OIT_I_AT_ORDER,
    OIT_I_AT_LINKS,
    OIT_I_AT_LINKS_HIGH,
    OIT_I_AT_BASE,
    OIT_I_AT_SPARE, /* base, reach and the host's fields go to and fro between their own and this */
    OIT_I_AT_REACH,
    OIT_I_AT_KAPPA,
    OIT_I_AT_BETA,
    OIT_I_AT_GAMMA,
    OIT_I_AT_SIZES,
    OIT_I_AT_SIZES_HIGH,
    OIT_I_AT_GROUPED,
    OIT_I_AT_RADIAL,
    OIT_I_AT_HOST,
    OIT_I_SECTIONS = OIT_I_AT_HOST + OIT_MAX_OPERATOR_FIELDS
};

/* Passes of an operator that are alike: of a program, so many of them. */
typedef struct oit_i_stage {
    int program, what, count;
} oit_i_stage;
#define OIT_I_MAX_STAGES 10
#define OIT_I_OPACITY_WORDS (OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS / 2)

#define OIT_I_MAX_STRINGS 24
#define OIT_I_MAX_PREAMBLE 2000

struct oit_context {
    oit_desc desc;
    oit_info info;
    oit_i_gl gl;
    int has_indexed, has_dual, viewports, draw_buffers, clip_distances;
    int samples; /* of the frame's target; 0 or 1: not multisampled */
    float positions[OIT_MAX_SAMPLES][2];
    int32_t max_viewport[2];
    char preamble[OIT_I_MAX_PREAMBLE];
    const char *strings[OIT_STAGE_COUNT][2][OIT_I_MAX_STRINGS];
    int string_count[OIT_STAGE_COUNT][2];
    oit_i_u programs[OIT_I_PROGRAMS];
    oit_i_surface surfaces[3];
    oit_i_u buffers[OIT_I_BUFFER_COUNT], vertex_array;
    int64_t sizes[OIT_I_BUFFER_COUNT]; /* bytes held */
    oit_i_block block;                 /* as uploaded */
    oit_i_u capacity;                  /* fragments that the pool holds */
    oit_i_u places;                    /* that the runs of the frame heard of last would have taken */
    int settled_width, settled_height; /* of the frame whose counts are in the pixel buffer; 0: none */
    int small_needs;                   /* reports in a row that needed much less */
    uint64_t frame_number;
    oit_i_u class_pixels[OIT_I_CLASSES];       /* of the image that was heard of last, by depth */
    oit_report report, pending[OIT_I_REPORTS]; /* known; by slot, what is not read back */
    oit_i_sync fences[OIT_I_REPORTS];
    int news;                   /* whether a report has come since the pool was last looked at */
    int guessed[OIT_I_REPORTS]; /* whether the scan of that frame added up guesses */
    int slot;                   /* of the frame's report; -1: none is free */
    oit_i_snapshot saved;
    oit_frame frame;
    oit_i_u fetch_framebuffer, fetch_targets[8]; /* OIT_STORE_FETCH: layers, and what has been seen */
    int fetch_width, fetch_height, fetched;      /* of the targets; layers a pass */
    int fetches, fetch;                          /* passes that the frame has; is in */
    const oit_i_list *list;                      /* of the frame's steps */
    oit_i_step step;
    oit_result failure; /* of this frame */
    int rows, slab_y, slab_rows;
    int layers;                  /* k of the stores that keep the k nearest; 0 for the others */
    int part[4];                 /* x, y, width, height of the band within the slab */
    oit_i_u part_start;          /* its first fragment */
    oit_i_u needed, deepest;     /* of the slab; OIT_FIT_WAIT */
    int compose_index, composes; /* the next draw; whether one was drawn of this part */
    oit_i_u bands;
    int in_frame, saved_state;
    oit_i_pick_slot picks[OIT_MAX_PICKS];
    uint64_t pick_turns;
    int pick; /* the slot of the present pass */
    const char *operator_strings[OIT_I_MAX_STRINGS];
    int operator_string_count;
    oit_i_u sections[OIT_I_SECTIONS]; /* first words; 0: there is none */
    int wide;                         /* links are of 16 bits */
    oit_i_u did;                      /* OIT_I_DID_*, in this frame */
    oit_i_stage stages[OIT_I_MAX_STAGES];
    int stage_count, stage, stage_step;
    oit_link link; /* as run last, without zeros */
    oit_law law;
    oit_smart smart;
    oit_curvature curvature;
    int curvature_base; /* 1: its opacities go to base */
    float shades[OIT_TRANSFER_SHADES][4];
    oit_i_u opacities[OIT_I_OPACITY_WORDS]; /* of 16 bits */
    oit_i_u host_program;
    int host_section;
};

/* ---- text without stdio ----------------------------------------------------------------------------------------- */

/* Appended to what is there; cut where it is full. */
typedef struct oit_i_text {
    char *at;
    size_t capacity, length;
} oit_i_text;

static oit_i_text oit_i_text_in(char *at, size_t capacity) {
    oit_i_text text;
    text.at = at;
    text.capacity = capacity;
    text.length = 0;
    at[0] = 0;
    return text;
}

static void oit_i_put(oit_i_text *to, const char *string) {
    for (; *string && to->length + 1 < to->capacity; ++string)
        to->at[to->length++] = *string;
    to->at[to->length] = 0;
}

static void oit_i_put_number(oit_i_text *to, int64_t number) {
    char digits[24];
    size_t at = sizeof digits - 1;
    uint64_t left = number < 0 ? 0u - (uint64_t)number : (uint64_t)number;
    digits[at] = 0;
    do {
        digits[--at] = (char)('0' + (int)(left % 10u));
        left /= 10u;
    } while (left);
    if (number < 0)
        digits[--at] = '-';
    oit_i_put(to, digits + at);
}

static void oit_i_put_version(oit_i_text *to, int es, int version) {
    oit_i_put(to, es ? "OpenGL ES " : "OpenGL ");
    oit_i_put_number(to, version / 100);
    oit_i_put(to, ".");
    oit_i_put_number(to, version / 10 % 10);
}

/* "function: ...", in a buffer for one message. */
typedef struct oit_i_message {
    char buffer[2400];
    oit_i_text text;
} oit_i_message;

static oit_i_text *oit_i_say(oit_i_message *message, const char *function, const char *what) {
    message->text = oit_i_text_in(message->buffer, sizeof message->buffer);
    oit_i_put(&message->text, function);
    oit_i_put(&message->text, ": ");
    oit_i_put(&message->text, what);
    return &message->text;
}

static void oit_i_log(const oit_desc *desc, oit_log_level level, oit_result code, const oit_i_message *message) {
    if (desc->log_fn)
        desc->log_fn(level, code, message->buffer, desc->log_user);
}

static oit_result oit_i_fail(const oit_desc *desc, oit_result code, const char *function, const char *what) {
    oit_i_message message;
    oit_i_say(&message, function, what);
    oit_i_log(desc, OIT_LOG_ERROR, code, &message);
    return code;
}

/* Says why the context is refused, and what can be had instead. */
static oit_result oit_i_refuse(const oit_desc *desc, oit_result code, oit_i_message *message) {
    oit_i_put(&message->text, "; layers(n) of transparency.h needs only OpenGL 3.3 or OpenGL ES 3.0");
    oit_i_log(desc, OIT_LOG_ERROR, code, message);
    return code;
}

OIT_I_API const char *oit_result_string(oit_result result) {
    static const char *const strings[] = {
#define OIT_I_STRING(name, text) text,
        OIT_RESULTS(OIT_I_STRING)
#undef OIT_I_STRING
    };
    return (unsigned)result < (unsigned)OIT_RESULT_COUNT ? strings[result] : "not a result";
}

OIT_I_API const char *oit_pass_kind_name(oit_pass_kind kind) {
    static const char *const names[OIT_PASS_KIND_COUNT] = {
        "clear",   "count", "sum",   "tops",    "spread", "report", "fill", "compose", "keep",
        "arrange", "pick",  "depth", "predict", "settle", "gather", "lay",  "operate"};
    return (unsigned)kind < (unsigned)OIT_PASS_KIND_COUNT ? names[kind] : "not a pass";
}

/* ---- what the context has --------------------------------------------------------------------------------------- */

static oit_result oit_i_lacks_function(const oit_desc *desc, const char *name) {
    oit_i_message message;
    oit_i_put(oit_i_say(&message, "oit_create", name), " is missing");
    return oit_i_refuse(desc, OIT_MISSING_FUNCTION, &message);
}

#define OIT_I_CHECK(type, name, parameters)                                                                            \
    if (!gl->gl_##name)                                                                                                \
        result = oit_i_lacks_function(desc, "gl" #name);

#ifdef OIT_GL_STATIC
/* The names that the host's GL header declares; its version macros say which there are. */
static void oit_i_load(const oit_desc *desc, oit_i_gl *gl) {
#define OIT_I_TAKE(type, name, parameters) gl->gl_##name = (type(OIT_I_GLAPI *) parameters)(oit_proc)gl##name;
    (void)desc;
    OIT_I_GL_QUERIES(OIT_I_TAKE)
    OIT_I_GL_REQUIRED(OIT_I_TAKE)
    OIT_I_GL_FETCH(OIT_I_TAKE)
#if defined(GL_VERSION_4_1)
    OIT_I_GL_DESKTOP(OIT_I_TAKE)
#endif
#if defined(GL_VERSION_4_1) || defined(GL_ES_VERSION_2_0)
    OIT_I_GL_ES(OIT_I_TAKE)
#endif
#if defined(GL_VERSION_4_0) || defined(GL_ES_VERSION_3_2)
    OIT_I_GL_INDEXED(OIT_I_TAKE)
#endif
#undef OIT_I_TAKE
}
#else
static void oit_i_load(const oit_desc *desc, oit_i_gl *gl) {
#define OIT_I_TAKE(type, name, parameters) gl->gl_##name = (type(OIT_I_GLAPI *) parameters)desc->get_proc("gl" #name);
    OIT_I_GL_QUERIES(OIT_I_TAKE)
    OIT_I_GL_REQUIRED(OIT_I_TAKE)
    OIT_I_GL_DESKTOP(OIT_I_TAKE)
    OIT_I_GL_INDEXED(OIT_I_TAKE)
    OIT_I_GL_ES(OIT_I_TAKE)
    OIT_I_GL_FETCH(OIT_I_TAKE)
#undef OIT_I_TAKE
}
#endif

/* All that are missing are named. */
static oit_result oit_i_check_queries(const oit_desc *desc, const oit_i_gl *gl) {
    oit_result result = OIT_OK;
    OIT_I_GL_QUERIES(OIT_I_CHECK)
    return result;
}

/* A function that an older context need not have is only asked for where the version has it. */
static oit_result oit_i_check_functions(oit_context *oit) {
    const oit_desc *desc = &oit->desc;
    const oit_i_gl *gl = &oit->gl;
    oit_result result = OIT_OK;
    OIT_I_GL_REQUIRED(OIT_I_CHECK)
    if (oit->info.es) {
        OIT_I_GL_ES(OIT_I_CHECK)
    } else {
        OIT_I_GL_DESKTOP(OIT_I_CHECK)
    }
    if (desc->store == OIT_STORE_FETCH) {
        OIT_I_GL_FETCH(OIT_I_CHECK)
    }
    oit->has_indexed = 1;
    if (!oit->info.es) {
        OIT_I_GL_INDEXED(OIT_I_CHECK)
    } else { /* from 3.2 on, and where the host's headers know of it */
#define OIT_I_FIND(type, name, parameters)                                                                             \
    if (!gl->gl_##name || oit->info.version < 320)                                                                     \
        oit->has_indexed = 0;
        OIT_I_GL_INDEXED(OIT_I_FIND)
#undef OIT_I_FIND
    }
    return result;
}
#undef OIT_I_CHECK

static int oit_i_is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* "4.5 (Core Profile) Mesa 22.3.6" or "OpenGL ES 3.1 Mesa 22.3.6". Returns 0 for anything else. */
static int oit_i_parse_version(const char *text, oit_info *info) {
    static const char es_prefix[] = "OpenGL ES ";
    int major = 0;
    info->es = strncmp(text, es_prefix, sizeof es_prefix - 1) == 0;
    if (info->es)
        text += sizeof es_prefix - 1;
    if (!oit_i_is_digit(*text))
        return 0;
    for (; oit_i_is_digit(*text) && major < 100; ++text)
        major = major * 10 + (*text - '0');
    if (*text != '.' || !oit_i_is_digit(text[1]))
        return 0;
    info->version = major * 100 + (text[1] - '0') * 10;
    return 1;
}

static oit_result oit_i_find_version(oit_context *oit) {
    const oit_desc *desc = &oit->desc;
    oit_info *info = &oit->info;
    const char *string = (const char *)oit->gl.gl_GetString(OIT_I_GL_VERSION);
    oit_i_message message;
    oit_i_text *text;
    if (!string) {
        oit_i_say(&message, "oit_create", "there is no GL_VERSION; is a context current?");
        return oit_i_refuse(desc, OIT_GL_TOO_OLD, &message);
    }
    if (!oit_i_parse_version(string, info)) {
        text = oit_i_say(&message, "oit_create", "no version can be read from GL_VERSION \"");
        text->capacity = 320; /* of a string without an end in sight this much tells enough */
        oit_i_put(text, string);
        text->capacity = sizeof message.buffer;
        oit_i_put(text, "\"");
        return oit_i_refuse(desc, OIT_GL_TOO_OLD, &message);
    }
    text = oit_i_say(&message, "oit_create", "found ");
    oit_i_put_version(text, info->es, info->version);
    if (desc->max_gl_version > 0 && info->version > desc->max_gl_version) {
        info->version = desc->max_gl_version;
        oit_i_put(text, ", used as ");
        oit_i_put_version(text, info->es, info->version);
    }
    oit_i_put(text, "; needed is OpenGL 4.3 or OpenGL ES 3.1");
    return info->version < (info->es ? 310 : 430) ? oit_i_refuse(desc, OIT_GL_TOO_OLD, &message) : OIT_OK;
}

static int oit_i_has_extension(const oit_i_gl *gl, const char *name) {
    int32_t count = 0, i;
    gl->gl_GetIntegerv(OIT_I_GL_NUM_EXTENSIONS, &count);
    for (i = 0; i < count; ++i) {
        const char *extension = (const char *)gl->gl_GetStringi(OIT_I_GL_EXTENSIONS, (oit_i_u)i);
        if (extension && strcmp(extension, name) == 0)
            return 1;
    }
    return 0;
}

static oit_result oit_i_check_limit(const oit_desc *desc, const char *name, int64_t found, int64_t needed) {
    oit_i_message message;
    oit_i_text *text = oit_i_say(&message, "oit_create", name);
    if (found >= needed)
        return OIT_OK;
    oit_i_put(text, " is ");
    oit_i_put_number(text, found);
    oit_i_put(text, "; needed is ");
    oit_i_put_number(text, needed);
    return oit_i_refuse(desc, OIT_LIMIT_TOO_SMALL, &message);
}

/* X(member of oit_info, name without GL_MAX_, least value) */
#define OIT_I_LIMITS(X)                                                                                                \
    X(fragment_storage_blocks, FRAGMENT_SHADER_STORAGE_BLOCKS, 2)                                                      \
    X(compute_storage_blocks, COMPUTE_SHADER_STORAGE_BLOCKS, 4)                                                        \
    X(combined_outputs, COMBINED_SHADER_OUTPUT_RESOURCES, 4)                                                           \
    X(compute_invocations, COMPUTE_WORK_GROUP_INVOCATIONS, 128)

#define OIT_I_LEAST_BLOCK ((int64_t)1 << 24)

/* Whether there is a buffer of surfaces at all. */
static int oit_i_operates(const oit_desc *desc) {
    return desc->operators != 0 || desc->operator_fields > 0;
}

/* What a fragment shader knows of samples. Coverage from before the depth test does not do. */
static oit_result oit_i_find_coverage(oit_context *oit) {
    const oit_i_gl *gl = &oit->gl;
    oit_i_message message;
    if (oit->info.es && !oit_i_has_extension(gl, "GL_OES_sample_variables")) {
        oit_i_say(&message, "oit_create", "OIT_FIELD_COVERAGE needs GL_OES_sample_variables, which is not there");
        return oit_i_refuse(&oit->desc, OIT_LIMIT_TOO_SMALL, &message);
    }
    if (!oit_i_has_extension(gl, oit->info.es ? "GL_EXT_post_depth_coverage" : "GL_ARB_post_depth_coverage"))
        oit->desc.sample_order = 1;
    return OIT_OK;
}

/* All limits that are too small are named. The size of blocks may be beyond 32 bits. */
static oit_result oit_i_find_limits(oit_context *oit) {
    const oit_desc *desc = &oit->desc;
    const oit_i_gl *gl = &oit->gl;
    oit_info *info = &oit->info;
    oit_result result = OIT_OK;
    int32_t value;
#define OIT_I_LIMIT(member, name, least)                                                                               \
    value = 0;                                                                                                         \
    gl->gl_GetIntegerv(OIT_I_GL_MAX_##name, &value);                                                                   \
    info->member = value;                                                                                              \
    if (oit_i_check_limit(desc, "GL_MAX_" #name, value, least) != OIT_OK)                                              \
        result = OIT_LIMIT_TOO_SMALL;
    OIT_I_LIMITS(OIT_I_LIMIT)
#undef OIT_I_LIMIT
    gl->gl_GetInteger64v(OIT_I_GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &info->storage_block_bytes);
    if (oit_i_check_limit(desc, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", info->storage_block_bytes, OIT_I_LEAST_BLOCK) !=
        OIT_OK)
        result = OIT_LIMIT_TOO_SMALL;
    /* All of desktop GL that comes as far as this is newer. */
    info->image_atomics = info->version >= 320 || oit_i_has_extension(gl, "GL_OES_shader_image_atomic");
    oit->has_dual = !info->es;
    if (oit_i_operates(desc) && oit_i_check_limit(desc, "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS (with operators)",
                                                  info->fragment_storage_blocks, 3) != OIT_OK)
        result = OIT_LIMIT_TOO_SMALL;
    if (result == OIT_OK && (desc->fields & OIT_FIELD_COVERAGE))
        result = oit_i_find_coverage(oit);
    return result;
}

static int32_t oit_i_limit(const oit_context *oit, oit_i_u name, int32_t most) {
    int32_t value = 0;
    oit->gl.gl_GetIntegerv(name, &value);
    return value < 0 ? 0 : value > most ? most : value;
}

static oit_result oit_i_check_bindings(oit_context *oit) {
    int32_t storage = oit_i_limit(oit, OIT_I_GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, 1 << 20);
    int32_t uniforms = oit_i_limit(oit, OIT_I_GL_MAX_UNIFORM_BUFFER_BINDINGS, 1 << 20);
    if (oit->desc.uniform_binding == 0)
        oit->desc.uniform_binding = 14;
    if (oit->desc.first_storage_binding < 0 || oit->desc.first_storage_binding > storage - OIT_I_STORAGE_BINDINGS)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_create",
                          "first_storage_binding is beyond GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS");
    if (oit->desc.uniform_binding < 0 || oit->desc.uniform_binding >= uniforms)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_create",
                          "uniform_binding is beyond GL_MAX_UNIFORM_BUFFER_BINDINGS");
    return OIT_OK;
}

static void oit_i_find_state_limits(oit_context *oit) {
    oit->draw_buffers = oit->has_indexed ? oit_i_limit(oit, OIT_I_GL_MAX_DRAW_BUFFERS, OIT_I_MAX_DRAW_BUFFERS) : 1;
    if (!oit->info.es) {
        oit->viewports = oit_i_limit(oit, OIT_I_GL_MAX_VIEWPORTS, OIT_I_MAX_VIEWPORTS);
        oit->clip_distances = oit_i_limit(oit, OIT_I_GL_MAX_CLIP_DISTANCES, OIT_I_MAX_CLIP_DISTANCES);
    }
    oit->gl.gl_GetIntegerv(OIT_I_GL_MAX_VIEWPORT_DIMS, oit->max_viewport);
}

/* Whether the store keeps the k nearest fragments of each pixel, and the sum of the others. */
static int oit_i_keeps(const oit_desc *desc) {
    return desc->store == OIT_STORE_BUDGET || desc->store == OIT_STORE_BUCKETED;
}

/* Where the words of a record lie, in the order in which they are compared; 0: not there. */
typedef struct oit_i_record {
    int part, key, color, blend, normal, uv, slope, coverage, host, link, words, lanes;
    int sorted;         /* words up to colour, blend and coverage, by which runs are sorted and composed: 8 at most */
    int coverage_shift; /* bits; coverage shares the word of blend where that has one */
} oit_i_record;

static oit_i_record oit_i_layout(const oit_desc *desc);

/* ---- operators -------------------------------------------------------------------------------------------------- */

/* What a run of an operator leaves for those after it in the frame. */
enum { OIT_I_DID_SORT = 1, OIT_I_DID_LINK = 2, OIT_I_DID_BASE = 4, OIT_I_DID_SMART = 8, OIT_I_DID_CURVE = 16 };
enum { OIT_I_DID_SHADE = 32, OIT_I_DID_CONTOUR = 64 };

static oit_i_u oit_i_links_of(oit_i_u operators) {
    if (operators & (OIT_OPERATE_DIFFUSION | OIT_OPERATE_THIN))
        operators |= OIT_OPERATE_SMART;
    if (operators & OIT_OPERATE_CONTOURS)
        operators |= OIT_OPERATE_CURVATURE;
    if (operators & (OIT_OPERATE_SMART | OIT_OPERATE_CURVATURE))
        operators |= OIT_OPERATE_LINKS | OIT_OPERATE_LAW;
    if (operators & OIT_OPERATE_BUCKETS)
        operators |= OIT_OPERATE_LINKS;
    return operators;
}

static const char *oit_i_bad_operators(const oit_desc *desc) {
    if (desc->operators & ~OIT_OPERATE_ALL)
        return "operators has bits that are none";
    if (desc->operator_fields < 0 || desc->operator_fields > OIT_MAX_OPERATOR_FIELDS)
        return "operator_fields is not in 0 ... 4";
    if (!oit_i_operates(desc))
        return 0;
    if (desc->store == OIT_STORE_FETCH)
        return "operators do not go with OIT_STORE_FETCH, which keeps no fragments";
    if (desc->alpha_law != OIT_ALPHA_CONSTANT)
        return "alpha_law does not go with operators, which have OIT_RUN_LAW";
    if (desc->fields & OIT_FIELD_COVERAGE)
        return "operators do not go with OIT_FIELD_COVERAGE: neighbours are those of pixels, not of samples";
    return 0;
}

static const char *oit_i_bad_member(const oit_desc *desc) {
#ifndef OIT_GL_STATIC
    if (!desc->get_proc)
        return "get_proc is missing";
#endif
    if (!desc->alloc_fn != !desc->free_fn)
        return "alloc_fn and free_fn go together";
    if (desc->max_gl_version < 0)
        return "max_gl_version is negative";
    if ((unsigned)desc->state > (unsigned)OIT_STATE_NONE || (unsigned)desc->fit > (unsigned)OIT_FIT_ASYNC)
        return "state or fit is none of its enumerators";
    if (desc->state == OIT_STATE_NONE && desc->fit != OIT_FIT_ASYNC)
        return "OIT_STATE_NONE goes with OIT_FIT_ASYNC: a read-back is a state call";
    if ((unsigned)desc->color > (unsigned)OIT_COLOR_FLOAT || (desc->fields & ~OIT_FIELD_ALL) != 0)
        return "color or fields has bits that are none";
    if ((unsigned)desc->store > (unsigned)OIT_STORE_FETCH)
        return "store is none of its enumerators";
    if (desc->headroom > 64)
        return "headroom is more than 64 sixteenths";
    if (desc->store == OIT_STORE_FETCH && desc->state == OIT_STATE_NONE)
        return "OIT_STORE_FETCH draws into targets of its own, which OIT_STATE_NONE has no state for";
    if (desc->store == OIT_STORE_FETCH && (desc->fields & OIT_FIELD_COVERAGE))
        return "OIT_STORE_FETCH does not store coverage";
    if (desc->store == OIT_STORE_FETCH && oit_i_layout(desc).words > 4)
        return "OIT_STORE_FETCH has room for 16 bytes a fragment: depth, colour but not OIT_COLOR_FLOAT, and one word more";
    if (desc->budget_bytes < 0 || desc->layers < 0)
        return "budget_bytes or layers is negative";
    if (desc->bucket_depth_bits != 0 && desc->bucket_depth_bits != 16 && desc->bucket_depth_bits != 32)
        return "bucket_depth_bits is none of 0, 16 and 32";
    if (desc->store == OIT_STORE_BUCKETED && !(desc->fields & OIT_FIELD_PART))
        return "OIT_STORE_BUCKETED groups fragments by OIT_FIELD_PART, which is not chosen";
    if ((desc->fields & OIT_FIELD_COVERAGE) && desc->state == OIT_STATE_NONE)
        return "OIT_FIELD_COVERAGE does not go with OIT_STATE_NONE: samples are the target's, which is not asked there";
    if ((unsigned)desc->alpha_law > (unsigned)OIT_ALPHA_ADAPTIVE)
        return "alpha_law is none of its enumerators";
    if (desc->alpha_law == OIT_ALPHA_ADAPTIVE && desc->store != OIT_STORE_EXACT &&
        ((desc->store != OIT_STORE_PREDICT && desc->store != OIT_STORE_LINKED) || desc->fit == OIT_FIT_ASYNC))
        return "OIT_ALPHA_ADAPTIVE goes with OIT_STORE_EXACT, and with PREDICT or LINKED where they wait";
    if (desc->sample_order && !(desc->fields & OIT_FIELD_COVERAGE))
        return "sample_order goes with OIT_FIELD_COVERAGE";
    if (desc->host_words < 0 || desc->host_words > OIT_MAX_HOST_WORDS)
        return "host_words is not in 0 ... 8";
    if (desc->ceiling_bytes < 0 || desc->max_block_bytes < 0)
        return "ceiling_bytes or max_block_bytes is negative";
    return oit_i_bad_operators(desc);
}

/* ---- state: saved, set, restored -------------------------------------------------------------------------------- */

/* Switches that every pass wants off, with the first version that has them (0: never). Depth and scissor test, which
   passes set, come last. */
typedef struct oit_i_cap {
    oit_i_u name;
    int desktop, es;
} oit_i_cap;

static const oit_i_cap oit_i_caps[OIT_I_CAP_COUNT] = {
    {OIT_I_GL_STENCIL_TEST, 430, 310},
    {OIT_I_GL_DITHER, 430, 310},
    {OIT_I_GL_POLYGON_OFFSET_FILL, 430, 310},
    {OIT_I_GL_POLYGON_OFFSET_LINE, 430, 0}, /* not only for lines: Mesa 22 offsets clipped polygons by it */
    {OIT_I_GL_POLYGON_OFFSET_POINT, 430, 0},
    {OIT_I_GL_SAMPLE_ALPHA_TO_COVERAGE, 430, 310},
    {OIT_I_GL_SAMPLE_COVERAGE, 430, 310},
    {OIT_I_GL_RASTERIZER_DISCARD, 430, 310},
    {OIT_I_GL_COLOR_LOGIC_OP, 430, 0},
    {OIT_I_GL_DEPTH_CLAMP, 430, 0},
    {OIT_I_GL_SAMPLE_MASK, 430, 310},
    {OIT_I_GL_CULL_FACE, 430, 310}, /* both sides of a surface are layers */
    {OIT_I_GL_SAMPLE_SHADING, 430, 320},
    {OIT_I_GL_MULTISAMPLE, 430, 0}, /* the only one that is wanted on */
    {OIT_I_GL_DEPTH_TEST, 430, 310},
    {OIT_I_GL_SCISSOR_TEST, 430, 310},
};
#define OIT_I_CAPS_OFF 13

static int oit_i_has_cap(const oit_context *oit, int index) {
    int since = oit->info.es ? oit_i_caps[index].es : oit_i_caps[index].desktop;
    return since != 0 && oit->info.version >= since;
}

static void oit_i_switch(const oit_context *oit, oit_i_u cap, int on) {
    if (on)
        oit->gl.gl_Enable(cap);
    else
        oit->gl.gl_Disable(cap);
}

static void oit_i_switch_indexed(const oit_context *oit, oit_i_u cap, int index, int on) {
    if (on)
        oit->gl.gl_Enablei(cap, (oit_i_u)index);
    else
        oit->gl.gl_Disablei(cap, (oit_i_u)index);
}

static void oit_i_set_viewport(const oit_context *oit, const float box[4]) {
    if (oit->viewports)
        oit->gl.gl_ViewportIndexedf(0, box[0], box[1], box[2], box[3]);
    else
        oit->gl.gl_Viewport((int32_t)box[0], (int32_t)box[1], (int32_t)box[2], (int32_t)box[3]);
}

static void oit_i_set_scissor(const oit_context *oit, const int32_t box[4]) {
    if (oit->viewports)
        oit->gl.gl_ScissorIndexed(0, box[0], box[1], box[2], box[3]);
    else
        oit->gl.gl_Scissor(box[0], box[1], box[2], box[3]);
}

static void oit_i_set_depth_range(const oit_context *oit, double first, double last) {
    if (oit->viewports)
        oit->gl.gl_DepthRangeIndexed(0, first, last);
    else
        oit->gl.gl_DepthRangef((float)first, (float)last);
}

static void oit_i_save_viewport(const oit_context *oit, oit_i_snapshot *saved) {
    const oit_i_gl *gl = &oit->gl;
    int32_t viewport[4];
    float range[2];
    int i;
    if (oit->viewports) {
        gl->gl_GetFloati_v(OIT_I_GL_VIEWPORT, 0, saved->viewport);
        gl->gl_GetDoublei_v(OIT_I_GL_DEPTH_RANGE, 0, saved->depth_range);
        gl->gl_GetIntegeri_v(OIT_I_GL_SCISSOR_BOX, 0, saved->scissor);
        for (i = 0; i < oit->viewports; ++i)
            saved->scissors[i] = gl->gl_IsEnabledi(OIT_I_GL_SCISSOR_TEST, (oit_i_u)i);
        return;
    }
    gl->gl_GetIntegerv(OIT_I_GL_VIEWPORT, viewport);
    gl->gl_GetIntegerv(OIT_I_GL_SCISSOR_BOX, saved->scissor);
    gl->gl_GetFloatv(OIT_I_GL_DEPTH_RANGE, range);
    for (i = 0; i < 4; ++i)
        saved->viewport[i] = (float)viewport[i];
    saved->depth_range[0] = (double)range[0];
    saved->depth_range[1] = (double)range[1];
}

static void oit_i_save_blend(const oit_context *oit, oit_i_snapshot *saved) {
    static const oit_i_u names[6] = {OIT_I_GL_BLEND_SRC_RGB,      OIT_I_GL_BLEND_DST_RGB,
                                     OIT_I_GL_BLEND_SRC_ALPHA,    OIT_I_GL_BLEND_DST_ALPHA,
                                     OIT_I_GL_BLEND_EQUATION_RGB, OIT_I_GL_BLEND_EQUATION_ALPHA};
    int i;
    for (i = 0; i < 6; ++i) {
        int32_t *value = i < 4 ? &saved->blend_func[i] : &saved->blend_equation[i - 4];
        if (oit->has_indexed)
            oit->gl.gl_GetIntegeri_v(names[i], 0, value);
        else
            oit->gl.gl_GetIntegerv(names[i], value);
    }
    saved->blend = oit->has_indexed ? oit->gl.gl_IsEnabledi(OIT_I_GL_BLEND, 0) : oit->gl.gl_IsEnabled(OIT_I_GL_BLEND);
    for (i = 0; i < oit->draw_buffers; ++i) {
        if (oit->has_indexed)
            oit->gl.gl_GetBooleani_v(OIT_I_GL_COLOR_WRITEMASK, (oit_i_u)i, saved->color_masks[i]);
        else
            oit->gl.gl_GetBooleanv(OIT_I_GL_COLOR_WRITEMASK, saved->color_masks[i]);
    }
}

static void oit_i_save_binding(const oit_context *oit, oit_i_u name, int at, oit_i_binding *saved) {
    int storage = name == OIT_I_GL_SHADER_STORAGE_BUFFER_BINDING;
    oit->gl.gl_GetIntegeri_v(name, (oit_i_u)at, &saved->buffer);
    oit->gl.gl_GetInteger64i_v(storage ? OIT_I_GL_SHADER_STORAGE_BUFFER_START : OIT_I_GL_UNIFORM_BUFFER_START,
                               (oit_i_u)at, &saved->start);
    oit->gl.gl_GetInteger64i_v(storage ? OIT_I_GL_SHADER_STORAGE_BUFFER_SIZE : OIT_I_GL_UNIFORM_BUFFER_SIZE,
                               (oit_i_u)at, &saved->size);
}

static void oit_i_save_bindings(const oit_context *oit, oit_i_snapshot *saved) {
    const oit_i_gl *gl = &oit->gl;
    int i;
    gl->gl_GetIntegerv(OIT_I_GL_CURRENT_PROGRAM, &saved->program);
    gl->gl_GetIntegerv(OIT_I_GL_VERTEX_ARRAY_BINDING, &saved->vertex_array);
    gl->gl_GetIntegerv(OIT_I_GL_DRAW_FRAMEBUFFER_BINDING, &saved->framebuffer);
    gl->gl_GetIntegerv(OIT_I_GL_SHADER_STORAGE_BUFFER_BINDING, &saved->storage_buffer);
    gl->gl_GetIntegerv(OIT_I_GL_UNIFORM_BUFFER_BINDING, &saved->uniform_buffer);
    gl->gl_GetIntegerv(OIT_I_GL_COPY_WRITE_BUFFER, &saved->copy_buffer);
    for (i = 0; i < OIT_I_STORAGE_BINDINGS; ++i)
        oit_i_save_binding(oit, OIT_I_GL_SHADER_STORAGE_BUFFER_BINDING, oit->desc.first_storage_binding + i,
                           &saved->storage[i]);
    oit_i_save_binding(oit, OIT_I_GL_UNIFORM_BUFFER_BINDING, oit->desc.uniform_binding, &saved->uniforms);
}

static void oit_i_save(const oit_context *oit, oit_i_snapshot *saved) {
    const oit_i_gl *gl = &oit->gl;
    int i;
    memset(saved, 0, sizeof *saved);
    oit_i_save_bindings(oit, saved);
    oit_i_save_blend(oit, saved);
    for (i = 0; i < OIT_I_CAP_COUNT; ++i)
        if (oit_i_has_cap(oit, i))
            saved->caps[i] = gl->gl_IsEnabled(oit_i_caps[i].name);
    for (i = 0; i < oit->clip_distances; ++i)
        saved->clip_distances[i] = gl->gl_IsEnabled(OIT_I_GL_CLIP_DISTANCE0 + (oit_i_u)i);
    oit_i_save_viewport(oit, saved);
    gl->gl_GetBooleanv(OIT_I_GL_DEPTH_WRITEMASK, &saved->depth_mask);
    gl->gl_GetIntegerv(OIT_I_GL_DEPTH_FUNC, &saved->depth_func);
    if (!oit->info.es)
        gl->gl_GetIntegerv(OIT_I_GL_POLYGON_MODE, saved->polygon_mode);
}

/* What a fresh context would have saved, for OIT_STATE_LEAVE_DEFAULTS; viewport and scissor box stay what they were. */
static void oit_i_save_defaults(oit_i_snapshot *saved) {
    oit_i_snapshot fresh;
    memset(&fresh, 0, sizeof fresh);
    memset(fresh.color_masks, 1, sizeof fresh.color_masks);
    memcpy(fresh.viewport, saved->viewport, sizeof fresh.viewport);
    memcpy(fresh.scissor, saved->scissor, sizeof fresh.scissor);
    fresh.caps[1] = fresh.caps[OIT_I_CAPS_OFF] = 1; /* dither, multisampling */
    fresh.depth_mask = 1;
    fresh.depth_func = (int32_t)OIT_I_GL_LESS;
    fresh.depth_range[1] = 1.0;
    fresh.polygon_mode[0] = (int32_t)OIT_I_GL_FILL;
    fresh.blend_func[0] = fresh.blend_func[2] = (int32_t)OIT_I_GL_ONE;
    fresh.blend_equation[0] = fresh.blend_equation[1] = (int32_t)OIT_I_GL_FUNC_ADD;
    *saved = fresh;
}

/* rgb, then alpha. */
static void oit_i_set_blend(const oit_context *oit, int on, const oit_i_u func[4], const oit_i_u equation[2]) {
    if (!oit->has_indexed) {
        oit_i_switch(oit, OIT_I_GL_BLEND, on);
        oit->gl.gl_BlendFuncSeparate(func[0], func[1], func[2], func[3]);
        oit->gl.gl_BlendEquationSeparate(equation[0], equation[1]);
        return;
    }
    oit_i_switch_indexed(oit, OIT_I_GL_BLEND, 0, on);
    oit->gl.gl_BlendFuncSeparatei(0, func[0], func[1], func[2], func[3]);
    oit->gl.gl_BlendEquationSeparatei(0, equation[0], equation[1]);
}

/* A size of 0 means the whole buffer. */
static void oit_i_restore_binding(const oit_context *oit, oit_i_u target, int at, const oit_i_binding *saved) {
    if (saved->size > 0)
        oit->gl.gl_BindBufferRange(target, (oit_i_u)at, (oit_i_u)saved->buffer, (ptrdiff_t)saved->start,
                                   (ptrdiff_t)saved->size);
    else
        oit->gl.gl_BindBufferBase(target, (oit_i_u)at, (oit_i_u)saved->buffer);
}

static void oit_i_restore_bindings(const oit_context *oit, const oit_i_snapshot *saved) {
    const oit_i_gl *gl = &oit->gl;
    int i;
    if (saved->program == 0 || gl->gl_IsProgram((oit_i_u)saved->program))
        gl->gl_UseProgram((oit_i_u)saved->program);
    gl->gl_BindVertexArray((oit_i_u)saved->vertex_array);
    gl->gl_BindFramebuffer(OIT_I_GL_DRAW_FRAMEBUFFER, (oit_i_u)saved->framebuffer);
    /* The indexed bindings first: they move the generic ones along. */
    for (i = 0; i < OIT_I_STORAGE_BINDINGS; ++i)
        oit_i_restore_binding(oit, OIT_I_GL_SHADER_STORAGE_BUFFER, oit->desc.first_storage_binding + i,
                              &saved->storage[i]);
    oit_i_restore_binding(oit, OIT_I_GL_UNIFORM_BUFFER, oit->desc.uniform_binding, &saved->uniforms);
    gl->gl_BindBuffer(OIT_I_GL_SHADER_STORAGE_BUFFER, (oit_i_u)saved->storage_buffer);
    gl->gl_BindBuffer(OIT_I_GL_UNIFORM_BUFFER, (oit_i_u)saved->uniform_buffer);
    gl->gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, (oit_i_u)saved->copy_buffer);
}

static void oit_i_restore(const oit_context *oit, const oit_i_snapshot *saved) {
    const oit_i_gl *gl = &oit->gl;
    oit_i_u func[4], equation[2];
    int i;
    oit_i_restore_bindings(oit, saved);
    for (i = 0; i < OIT_I_CAP_COUNT; ++i)
        if (oit_i_has_cap(oit, i))
            oit_i_switch(oit, oit_i_caps[i].name, saved->caps[i]);
    for (i = 0; i < oit->clip_distances; ++i)
        oit_i_switch(oit, OIT_I_GL_CLIP_DISTANCE0 + (oit_i_u)i, saved->clip_distances[i]);
    for (i = 0; i < oit->viewports; ++i)
        oit_i_switch_indexed(oit, OIT_I_GL_SCISSOR_TEST, i, saved->scissors[i]);
    oit_i_set_viewport(oit, saved->viewport);
    oit_i_set_scissor(oit, saved->scissor);
    oit_i_set_depth_range(oit, saved->depth_range[0], saved->depth_range[1]);
    gl->gl_DepthMask(saved->depth_mask);
    gl->gl_DepthFunc((oit_i_u)saved->depth_func);
    if (!oit->info.es)
        gl->gl_PolygonMode(OIT_I_GL_FRONT_AND_BACK, (oit_i_u)saved->polygon_mode[0]);
    for (i = 0; i < 4; ++i)
        func[i] = (oit_i_u)saved->blend_func[i];
    for (i = 0; i < 2; ++i)
        equation[i] = (oit_i_u)saved->blend_equation[i];
    oit_i_set_blend(oit, saved->blend, func, equation);
    for (i = 0; i < oit->draw_buffers; ++i) {
        const unsigned char *mask = saved->color_masks[i];
        if (oit->has_indexed)
            gl->gl_ColorMaski((oit_i_u)i, mask[0], mask[1], mask[2], mask[3]);
        else
            gl->gl_ColorMask(mask[0], mask[1], mask[2], mask[3]);
    }
}

static void oit_i_mask_colors(const oit_context *oit, int write) {
    unsigned char all = write == 2, on = write != 0;
    int i;
    if (!oit->has_indexed) {
        oit->gl.gl_ColorMask(on, on, on, all);
        return;
    }
    for (i = 0; i < oit->draw_buffers; ++i) {
        on = (unsigned char)(all || (i == 0 && write));
        oit->gl.gl_ColorMaski((oit_i_u)i, on, on, on, all);
    }
}

/* What a dispatch needs, and a draw as well. */
static void oit_i_apply_bindings(const oit_context *oit, const oit_state *state) {
    int i;
    oit->gl.gl_UseProgram(state->program);
    for (i = 0; i < OIT_I_STORAGE_BINDINGS; ++i)
        oit->gl.gl_BindBufferBase(OIT_I_GL_SHADER_STORAGE_BUFFER, (oit_i_u)(state->first_storage_binding + i),
                                  state->storage_buffers[i]);
    oit->gl.gl_BindBufferBase(OIT_I_GL_UNIFORM_BUFFER, (oit_i_u)state->uniform_binding, state->uniform_buffer);
}

/* Makes the context's state what the pass says, whatever it was. */
static void oit_i_apply(const oit_context *oit, const oit_state *state) {
    static const oit_i_u equation[2] = {OIT_I_GL_FUNC_ADD, OIT_I_GL_FUNC_ADD};
    const oit_i_gl *gl = &oit->gl;
    oit_i_u func[4];
    float viewport[4];
    int i;
    oit_i_apply_bindings(oit, state);
    if (state->groups[0])
        return;
    for (i = 0; i < OIT_I_CAPS_OFF; ++i)
        if (oit_i_has_cap(oit, i))
            gl->gl_Disable(oit_i_caps[i].name);
    if (oit_i_has_cap(oit, OIT_I_CAPS_OFF))
        gl->gl_Enable(oit_i_caps[OIT_I_CAPS_OFF].name);
    for (i = 0; i < oit->clip_distances; ++i)
        gl->gl_Disable(OIT_I_GL_CLIP_DISTANCE0 + (oit_i_u)i);
    for (i = 0; i < 4; ++i)
        viewport[i] = (float)state->viewport[i];
    gl->gl_BindFramebuffer(OIT_I_GL_DRAW_FRAMEBUFFER, state->framebuffer);
    oit_i_set_viewport(oit, viewport);
    /* For the first viewport alone: Mesa 22 lets the scissor of another one cut what is drawn into the first. */
    oit_i_switch(oit, OIT_I_GL_SCISSOR_TEST, oit->viewports == 0);
    if (oit->viewports)
        gl->gl_Enablei(OIT_I_GL_SCISSOR_TEST, 0);
    oit_i_set_scissor(oit, state->scissor);
    oit_i_set_depth_range(oit, 0.0, 1.0);
    oit_i_switch(oit, OIT_I_GL_DEPTH_TEST, state->depth_test);
    gl->gl_DepthFunc(state->depth_func);
    gl->gl_DepthMask((unsigned char)state->depth_write);
    if (!oit->info.es)
        gl->gl_PolygonMode(OIT_I_GL_FRONT_AND_BACK, OIT_I_GL_FILL);
    func[0] = state->blend_source;
    func[1] = state->blend_destination;
    func[2] = OIT_I_GL_ZERO;
    func[3] = OIT_I_GL_ONE;
    oit_i_set_blend(oit, state->blend, func, equation);
    oit_i_mask_colors(oit, state->color_write);
}

/* ---- shaders and programs --------------------------------------------------------------------------------------- */

typedef struct oit_i_source {
    const char *strings[OIT_I_MAX_STRINGS];
    int count;
} oit_i_source;

static void oit_i_add(oit_i_source *source, const char *string) {
    if (source->count < OIT_I_MAX_STRINGS)
        source->strings[source->count++] = string;
}

static void oit_i_add_chunks(oit_i_source *source, oit_i_strings chunks) {
    for (; *chunks; ++chunks)
        oit_i_add(source, *chunks);
}

static void oit_i_define(oit_i_text *text, const char *name, int64_t value) {
    oit_i_put(text, "#define ");
    oit_i_put(text, name);
    oit_i_put(text, " ");
    oit_i_put_number(text, value);
    oit_i_put(text, "\n");
}

static oit_i_record oit_i_layout(const oit_desc *desc) {
    oit_i_record at;
    int next = 1;
    memset(&at, 0, sizeof at);
    if (desc->fields & OIT_FIELD_PART)
        at.part = next++;
    if (desc->fields & OIT_FIELD_KEY)
        at.key = next++;
    at.color = next;
    next += desc->color == OIT_COLOR_FLOAT ? 4 : 2;
    if ((desc->fields & OIT_FIELD_BLEND) && desc->color != OIT_COLOR_8)
        at.blend = next++;
    if (desc->fields & OIT_FIELD_COVERAGE) {
        at.coverage = at.blend ? at.blend : next++;
        at.coverage_shift = at.blend ? 8 : 0;
    }
    at.sorted = next;
    if (desc->fields & OIT_FIELD_NORMAL)
        at.normal = next++;
    if (desc->fields & OIT_FIELD_UV) {
        at.uv = next;
        next += 2;
    }
    if (desc->operators & OIT_OPERATE_LINKS)
        at.slope = next++;
    at.host = next;
    next += desc->host_words;
    if (desc->store == OIT_STORE_LINKED)
        at.link = next++;
    /* In vectors, which drivers move at once: of four words, or of two where that saves memory. */
    at.words = (next + 1) / 2 * 2;
    at.lanes = at.words % 4 == 0 ? 4 : 2;
    return at;
}

/* Words a pixel that the store has of its own, and those of the tail: shaders/oit_frame_block.glsl. */
static int oit_i_own_words(const oit_desc *desc) {
    return desc->store == OIT_STORE_FETCH ? 11 : desc->store == OIT_STORE_PREDICT || desc->store == OIT_STORE_LINKED;
}

static int oit_i_tail_words(const oit_desc *desc) {
    return oit_i_keeps(desc)                ? 6
           : desc->fit == OIT_FIT_WAIT      ? 0
           : desc->store == OIT_STORE_FETCH ? 0
           : desc->store == OIT_STORE_EXACT ? 4
                                            : 6;
}

static int oit_i_key_bits(const oit_desc *desc) {
    return desc->store == OIT_STORE_BUCKETED && desc->bucket_depth_bits == 16 ? 16 : 32;
}

/* gl_SampleID and gl_SampleMaskIn; and the latter as it is after the depth test. */
static void oit_i_put_extensions(oit_i_text *text, const oit_desc *desc, int es) {
    if (es)
        oit_i_put(text, "#extension GL_OES_sample_variables : require\n");
    if (!desc->sample_order)
        oit_i_put(text, es ? "#extension GL_EXT_post_depth_coverage : require\n"
                           : "#extension GL_ARB_post_depth_coverage : require\n");
}

/* What every stage begins with, after the version: what was chosen at creation. */
static void oit_i_write_preamble(const oit_desc *desc, int es, char *at, size_t capacity) {
    oit_i_text text = oit_i_text_in(at, capacity);
    oit_i_record record = oit_i_layout(desc);
    if (desc->fields & OIT_FIELD_COVERAGE) /* extensions come before all else */
        oit_i_put_extensions(&text, desc, es);
    if (desc->store == OIT_STORE_FETCH)
        oit_i_put(&text, "#extension GL_EXT_shader_framebuffer_fetch : require\n");
    if (es)
        oit_i_put(&text, "precision highp float;\nprecision highp int;\n");
    oit_i_define(&text, "OIT_BINDING_PIXELS", desc->first_storage_binding + OIT_I_PIXELS);
    oit_i_define(&text, "OIT_BINDING_FRAGMENTS", desc->first_storage_binding + OIT_I_FRAGMENTS);
    oit_i_define(&text, "OIT_BINDING_REPORT", desc->first_storage_binding + OIT_I_REPORT);
    oit_i_define(&text, "OIT_UNIFORM_BINDING", desc->uniform_binding);
    oit_i_define(&text, "OIT_REVERSED_Z", desc->reversed_z != 0);
    oit_i_define(&text, "OIT_ASYNC", desc->fit == OIT_FIT_ASYNC && !oit_i_keeps(desc));
    oit_i_define(&text, "OIT_PREMULTIPLIED", desc->premultiplied != 0);
    oit_i_define(&text, "OIT_HAS_PART", (desc->fields & OIT_FIELD_PART) != 0);
    oit_i_define(&text, "OIT_HAS_KEY", (desc->fields & OIT_FIELD_KEY) != 0);
    oit_i_define(&text, "OIT_HAS_BLEND", (desc->fields & OIT_FIELD_BLEND) != 0);
    oit_i_define(&text, "OIT_HAS_NORMAL", (desc->fields & OIT_FIELD_NORMAL) != 0);
    oit_i_define(&text, "OIT_HAS_UV", (desc->fields & OIT_FIELD_UV) != 0);
    oit_i_define(&text, "OIT_HAS_COVERAGE", (desc->fields & OIT_FIELD_COVERAGE) != 0);
    oit_i_define(&text, "OIT_POST_DEPTH", !desc->sample_order);
    oit_i_define(&text, "OIT_ES", es != 0);
    oit_i_define(&text, "OIT_ADAPTIVE", desc->alpha_law == OIT_ALPHA_ADAPTIVE);
    oit_i_define(&text, "OIT_HOST_WORDS", desc->host_words);
    oit_i_define(&text, "OIT_LANES", record.lanes);
    oit_i_define(&text, "OIT_VECTORS", record.words / record.lanes);
    oit_i_put(&text, record.lanes == 4 ? "#define OIT_VECTOR uvec4\n" : "#define OIT_VECTOR uvec2\n");
    oit_i_define(&text, "OIT_SORTED", record.sorted);
    oit_i_define(&text, "OIT_AT_PART", record.part);
    oit_i_define(&text, "OIT_AT_KEY", record.key);
    oit_i_define(&text, "OIT_AT_COLOR", record.color);
    oit_i_define(&text, "OIT_AT_BLEND", record.blend);
    oit_i_define(&text, "OIT_AT_NORMAL", record.normal);
    oit_i_define(&text, "OIT_AT_UV", record.uv);
    oit_i_define(&text, "OIT_HAS_SLOPE", record.slope != 0);
    oit_i_define(&text, "OIT_AT_SLOPE", record.slope);
    oit_i_define(&text, "OIT_AT_COVERAGE", record.coverage);
    oit_i_define(&text, "OIT_COVERAGE_SHIFT", record.coverage_shift);
    oit_i_define(&text, "OIT_AT_HOST", record.host);
    oit_i_define(&text, "OIT_AT_LINK", record.link);
    oit_i_define(&text, "OIT_COLOR", (int)desc->color);
    oit_i_define(&text, "OIT_STORE", (int)desc->store);
    oit_i_define(&text, "OIT_KEEPS", oit_i_keeps(desc));
    oit_i_define(&text, "OIT_KEY_BITS", oit_i_key_bits(desc));
    oit_i_define(&text, "OIT_OWN_WORDS", oit_i_own_words(desc));
    oit_i_define(&text, "OIT_TAIL_WORDS", oit_i_tail_words(desc));
    oit_i_define(&text, "OIT_HEADROOM", desc->headroom == 0 ? 2 : desc->headroom < 0 ? 0 : desc->headroom);
    oit_i_put(&text, es ? "#define OIT_PRECISE\n" : "#define OIT_PRECISE precise\n");
    oit_i_put(&text, "#define OIT_EXACT 0\n#define OIT_PREDICT 1\n#define OIT_BUDGET 2\n");
    oit_i_put(&text, "#define OIT_LINKED 3\n#define OIT_BUCKETED 4\n#define OIT_FETCH 5\n");
    oit_i_put(&text, "#define OIT_COLOR_8 0\n#define OIT_COLOR_HALF 1\n#define OIT_COLOR_FLOAT 2\n");
    oit_i_put(&text, "#define OIT_COUNT 0\n#define OIT_FILL 1\n");
    oit_i_put(&text, "#define OIT_MODE_OVER 0\n#define OIT_MODE_DUAL 1\n");
    oit_i_put(&text, "#define OIT_MODE_FILTER 2\n#define OIT_MODE_LIGHT 3\n");
    oit_i_put(&text, "#define OIT_BY_PIXEL 0\n#define OIT_BY_SAMPLE 1\n#define OIT_BY_SHARE 2\n");
}

/* A string of its own: what must follow the version at once, #extension lines, goes between this and the next. */
static void oit_i_add_preamble(oit_i_source *source, int es, const char *preamble) {
    source->count = 0;
    oit_i_add(source, es ? "#version 310 es\n" : "#version 430 core\n");
    oit_i_add(source, preamble);
}

/* What a host's shader begins with, and the built-in surface programs too. */
static void oit_i_host_source(oit_i_source *source, oit_stage stage, int fill, const oit_desc *desc, int es,
                              const char *preamble) {
    oit_i_add_preamble(source, es, preamble);
    oit_i_add(source, fill ? "#define OIT_PASS 1\n" : "#define OIT_PASS 0\n");
    if (stage == OIT_VERTEX) {
        oit_i_add(source, "invariant gl_Position;\n");
        return;
    }
    oit_i_add_chunks(source, oit_i_shader_oit_frame_block_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_color_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_tail_glsl);
    if (desc->store == OIT_STORE_FETCH && fill)
        oit_i_add_chunks(source, oit_i_shader_oit_fetch_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_store_glsl);
}

#define OIT_I_NETWORK_CAPACITY ((size_t)48 << 10)

static void oit_i_put_pair(oit_i_text *text, const char *macro, int i) {
    oit_i_put(text, macro);
    oit_i_put_number(text, i);
    oit_i_put(text, ",o");
    oit_i_put_number(text, i);
    oit_i_put(text, ")\n");
}

static void oit_i_put_order(oit_i_text *text, int size) {
    int i;
    for (i = 0; i < size; ++i) {
        oit_i_put(text, "oit_order[");
        oit_i_put_number(text, i);
        oit_i_put(text, "] = o");
        oit_i_put_number(text, i);
        oit_i_put(text, ";\n");
    }
}

/* "M(r1,q1" and, unless second is negative, ",r2,q2". */
static void oit_i_put_registers(oit_i_text *text, const char *macro, int first, int second) {
    oit_i_put(text, macro);
    oit_i_put(text, "(r");
    oit_i_put_number(text, first);
    oit_i_put(text, ",q");
    oit_i_put_number(text, first);
    if (second < 0)
        return;
    oit_i_put(text, ",r");
    oit_i_put_number(text, second);
    oit_i_put(text, ",q");
    oit_i_put_number(text, second);
}

/* macro(r, q, i) for each of `size` registers */
static void oit_i_put_each(oit_i_text *text, const char *macro, int size) {
    int i;
    for (i = 0; i < size; ++i) {
        oit_i_put_registers(text, macro, i, -1);
        oit_i_put(text, ",");
        oit_i_put_number(text, i);
        oit_i_put(text, "u)\n");
    }
}

/* oit_lay_run for up to `size` records: read, put in order by Batcher's odd-even merge network, laid; all in registers, in
   one straight line. */
static void oit_i_put_network(oit_i_text *text, int size) {
    int i, j, k, p;
    oit_i_put(text, "void oit_lay_run(uint base, uint n)\n{\n");
    oit_i_put_each(text, "L", size);
    for (p = 1; p < size; p *= 2)
        for (k = p; k >= 1; k /= 2)
            for (j = k % p; j + k < size; j += 2 * k)
                for (i = 0; i < k && i + j + k < size; ++i)
                    if ((i + j) / (2 * p) == (i + j + k) / (2 * p)) {
                        oit_i_put_registers(text, "S", i + j, i + j + k);
                        oit_i_put(text, ")\n");
                    }
    oit_i_put_each(text, "Y", size);
    oit_i_put(text, "}\n");
}

/* oit_select: of n records the `size` first that come after (depth, from), by depth and then by where they lie. The last
   is there to be looked at: (depth, from) becomes the one before it. */
static void oit_i_put_selection(oit_i_text *text, int size) {
    int i;
    oit_i_put(text, "void oit_select(uint base, uint n, bool more, inout uint depth, inout uint from)\n{\n");
    for (i = 0; i < size; ++i)
        oit_i_put_pair(text, "D(d", i);
    oit_i_put(text, "for (uint i = 0u; i < n; ++i) {\nuint y = base + i * uint(OIT_VECTORS), x = oit_record_depth(y);\n"
                    "if (x >= d");
    oit_i_put_number(text, size - 1);
    oit_i_put(text, " || (more && (x < depth || (x == depth && y <= from))))\ncontinue;\nbool s = false;\n");
    for (i = 0; i < size; ++i)
        oit_i_put_pair(text, "I(d", i);
    oit_i_put(text, "}\ndepth = d");
    oit_i_put_number(text, size - 2);
    oit_i_put(text, ";\nfrom = o");
    oit_i_put_number(text, size - 2);
    oit_i_put(text, ";\n");
    oit_i_put_order(text, size);
    oit_i_put(text, "}\n");
}

static void oit_i_add_records(oit_i_source *source) {
    oit_i_add_chunks(source, oit_i_shader_oit_color_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_record_glsl);
}

/* scratch: OIT_I_NETWORK_CAPACITY characters, for text that is made here. */
static void oit_i_compose_source(oit_i_source *source, int index, int mode, int sampled, int fetch, char *scratch) {
    oit_i_text text = oit_i_text_in(scratch, OIT_I_NETWORK_CAPACITY);
    int tail = index == OIT_I_CLASSES, deep = index == OIT_I_CLASSES - 1;
    size_t network;
    oit_i_define(&text, "OIT_MODE", mode);
    oit_i_define(&text, "OIT_COVERED", sampled); /* OIT_BY_PIXEL or OIT_BY_SAMPLE */
    if (!tail) {
        oit_i_define(&text, "OIT_CLASS", oit_i_class_sizes[index]);
        oit_i_define(&text, "OIT_INDEX", index);
        oit_i_define(&text, "OIT_DEEP", deep);
    }
    oit_i_add(source, scratch);
    oit_i_add_chunks(source, oit_i_shader_oit_frame_block_glsl);
    if (!tail)
        oit_i_add_records(source);
    oit_i_add_chunks(source, oit_i_shader_oit_behind_glsl);
    if (tail) {
        oit_i_add_chunks(source, fetch ? oit_i_shader_oit_laid_frag : oit_i_shader_oit_tail_frag);
        return;
    }
    oit_i_add_chunks(source, oit_i_shader_oit_compose_glsl);
    network = text.length + 1;
    text = oit_i_text_in(scratch + network, OIT_I_NETWORK_CAPACITY - network);
    if (deep)
        oit_i_put_selection(&text, oit_i_class_sizes[index] + 1);
    else
        oit_i_put_network(&text, oit_i_class_sizes[index]);
    oit_i_add(source, scratch + network);
    oit_i_add_chunks(source, oit_i_shader_oit_compose_frag);
}

/* In the order of OIT_I_PROGRAM_*. */
static const oit_i_strings oit_i_kernels[] = {oit_i_shader_oit_clear_comp,   oit_i_shader_oit_sum_comp,
                                              oit_i_shader_oit_tops_comp,    oit_i_shader_oit_spread_comp,
                                              oit_i_shader_oit_report_comp,  oit_i_shader_oit_keep_comp,
                                              oit_i_shader_oit_arrange_comp, oit_i_shader_oit_predict_comp,
                                              oit_i_shader_oit_settle_comp,  oit_i_shader_oit_gather_comp};

static void oit_i_compute_source(oit_i_source *source, int program, int async) {
    int settles = program == OIT_I_PROGRAM_SETTLE, gathers = program == OIT_I_PROGRAM_GATHER;
    if (program == OIT_I_PROGRAM_TOPS || program == OIT_I_PROGRAM_SPREAD)
        oit_i_add(source, "#define OIT_SCANS 1\n");
    if (settles || gathers)
        oit_i_add(source, "#define OIT_SETTLES 1\n");
    if (gathers) /* the list has the place that the report has at other times */
        oit_i_add(source, "#define OIT_BINDING_RECORDS OIT_BINDING_REPORT\n");
    oit_i_add_chunks(source, oit_i_shader_oit_frame_block_glsl);
    if (program == OIT_I_PROGRAM_ARRANGE) {
        oit_i_add(source, "#define OIT_ARRANGES 1\n");
        oit_i_add_records(source);
        oit_i_add_chunks(source, oit_i_shader_oit_buckets_glsl);
    } else {
        oit_i_add_chunks(source, oit_i_shader_oit_scan_glsl);
    }
    if (settles || gathers) {
        oit_i_add_chunks(source, oit_i_shader_oit_color_glsl);
        oit_i_add_chunks(source, oit_i_shader_oit_tail_glsl);
        if (async || gathers)
            oit_i_add_chunks(source, oit_i_shader_oit_record_glsl);
    }
    oit_i_add_chunks(source, oit_i_kernels[program]);
}

static int oit_i_is_compute(int program) {
    return program < OIT_I_PROGRAM_COUNT || program == OIT_I_PROGRAM_PICK ||
           (program >= OIT_I_PROGRAM_SORT && program < OIT_I_PROGRAM_LAID);
}

static int oit_i_is_surface(int program) {
    return program >= OIT_I_PROGRAM_COUNT && program <= OIT_I_PROGRAM_FILL_LIT;
}

/* OIT_STORE_FETCH: what reads and changes the layers of its targets. */
static void oit_i_lay_source(oit_i_source *source, int program) {
    oit_i_add(source, "#define OIT_SETTLES 1\n#define OIT_CLASS 1\n#define OIT_DEEP 0\n#define OIT_COVERED 0\n");
    oit_i_add(source, program == OIT_I_PROGRAM_FIRST ? "#define OIT_FIRST 1\n" : "#define OIT_FIRST 0\n");
    oit_i_add_chunks(source, oit_i_shader_oit_frame_block_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_color_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_tail_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_compose_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_fetch_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_lay_frag);
}

/* Picking, and the depth of the composite: records in their order, without networks. */
static void oit_i_ordered_source(oit_i_source *source, int program, const oit_desc *desc) {
    oit_i_add(source, "#define OIT_CLASS 1\n#define OIT_DEEP 0\n");
    oit_i_add(source, desc->fields & OIT_FIELD_COVERAGE ? "#define OIT_COVERED 2\n" : "#define OIT_COVERED 0\n");
    oit_i_add_chunks(source, oit_i_shader_oit_frame_block_glsl);
    oit_i_add_records(source);
    oit_i_add_chunks(source, oit_i_shader_oit_ordered_glsl);
    if (program == OIT_I_PROGRAM_DEPTH)
        oit_i_add_chunks(source, oit_i_shader_oit_compose_glsl);
    oit_i_add_chunks(source, program == OIT_I_PROGRAM_PICK ? oit_i_shader_oit_pick_comp : oit_i_shader_oit_depth_frag);
}

/* In the order of OIT_I_PROGRAM_SORT, ... */
static const oit_i_strings oit_i_operators[] = {
    oit_i_shader_oit_operator_sort_comp,   oit_i_shader_oit_operator_connect_comp,
    oit_i_shader_oit_operator_mutual_comp, oit_i_shader_oit_operator_law_comp,
    oit_i_shader_oit_operator_bound_comp,  oit_i_shader_oit_operator_solve_comp,
    oit_i_shader_oit_operator_jump_comp,   oit_i_shader_oit_operator_chain_comp,
    oit_i_shader_oit_operator_curve_comp,  oit_i_shader_oit_operator_group_comp,
    oit_i_shader_oit_operator_size_comp,   oit_i_shader_oit_operator_window_comp};

/* What every operator begins with, after the preamble. */
static void oit_i_operator_source(oit_i_source *source) {
    oit_i_add(source, "#define OIT_CLASS 1\n#define OIT_DEEP 0\n#define OIT_COVERED 0\n");
    oit_i_add_chunks(source, oit_i_shader_oit_frame_block_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_color_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_record_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_ordered_glsl);
}

static int oit_i_is_operator(int program) {
    return program >= OIT_I_PROGRAM_SORT && program < OIT_I_PROGRAM_LAID;
}

/* What curve and compose share where there are contours. */
static void oit_i_contour_source(oit_i_source *source, int contours) {
    if (contours)
        oit_i_add_chunks(source, oit_i_shader_oit_contour_glsl);
}

/* Whether a work item takes a stretch of a row or of a column, not a pixel. */
static int oit_i_goes_along(int program) {
    return program == OIT_I_PROGRAM_JUMP || program == OIT_I_PROGRAM_SIZE || program == OIT_I_PROGRAM_CHAIN;
}

static void oit_i_built_in_operator_source(oit_i_source *source, int program, int contours) {
    oit_i_add(source, contours ? "#define OIT_CONTOURS 1\n" : "#define OIT_CONTOURS 0\n");
    if (oit_i_goes_along(program))
        oit_i_add(source, "#define OIT_OWN_MAIN 1\n");
    oit_i_operator_source(source);
    oit_i_add_chunks(source, oit_i_shader_oit_operator_glsl);
    if (program == OIT_I_PROGRAM_CONNECT || program == OIT_I_PROGRAM_WINDOW)
        oit_i_add_chunks(source, oit_i_shader_oit_operator_pairs_glsl);
    if (program == OIT_I_PROGRAM_CURVE)
        oit_i_contour_source(source, contours);
    oit_i_add_chunks(source, oit_i_operators[program - OIT_I_PROGRAM_SORT]);
}

static void oit_i_laid_source(oit_i_source *source, int mode, int contours) {
    static const char *const modes[4] = {"#define OIT_MODE 0\n", "#define OIT_MODE 1\n", "#define OIT_MODE 2\n",
                                         "#define OIT_MODE 3\n"};
    oit_i_add(source, modes[mode]);
    oit_i_add(source, "#define OIT_COMPOSES 1\n");
    oit_i_add(source, contours ? "#define OIT_CONTOURS 1\n" : "#define OIT_CONTOURS 0\n");
    oit_i_operator_source(source);
    oit_i_add_chunks(source, oit_i_shader_oit_behind_glsl);
    oit_i_add_chunks(source, oit_i_shader_oit_operator_glsl);
    oit_i_contour_source(source, contours);
    oit_i_add_chunks(source, oit_i_shader_oit_operator_compose_frag);
}

/* The whole text of one stage of a built-in program; dual: there is dual-source blending. */
static void oit_i_program_source(oit_i_source *source, int program, oit_stage stage, const oit_desc *desc, int es,
                                 const char *preamble, char *scratch) {
    int sampled = program >= OIT_I_PROGRAM_SAMPLED, mode = OIT_I_MODE_OVER;
    int index = program - (sampled ? OIT_I_PROGRAM_SAMPLED : OIT_I_PROGRAM_COMPOSE);
    if (oit_i_is_surface(program)) {
        int fill = program != OIT_I_PROGRAM_COUNT, lit = program == OIT_I_PROGRAM_FILL_LIT;
        oit_i_host_source(source, stage, fill, desc, es, preamble);
        oit_i_add(source, lit ? "#define OIT_LIT 1\n" : "#define OIT_LIT 0\n");
        oit_i_add(source, lit || (fill && (desc->fields & OIT_FIELD_NORMAL)) ? "#define OIT_WANTS_NORMAL 1\n"
                                                                             : "#define OIT_WANTS_NORMAL 0\n");
        oit_i_add_chunks(source, stage == OIT_VERTEX ? oit_i_shader_oit_surface_vert : oit_i_shader_oit_surface_frag);
        return;
    }
    oit_i_add_preamble(source, es, preamble);
    if (oit_i_is_operator(program)) {
        oit_i_built_in_operator_source(source, program, (desc->operators & OIT_OPERATE_CONTOURS) != 0);
    } else if (program >= OIT_I_PROGRAM_LAID && stage == OIT_FRAGMENT) {
        if (desc->fields & OIT_FIELD_BLEND)
            mode = !es ? OIT_I_MODE_DUAL : program == OIT_I_PROGRAM_LAID_LIGHT ? OIT_I_MODE_LIGHT : OIT_I_MODE_FILTER;
        oit_i_laid_source(source, mode, (desc->operators & OIT_OPERATE_CONTOURS) != 0);
    } else if ((program == OIT_I_PROGRAM_FIRST || program == OIT_I_PROGRAM_LAY) && stage == OIT_FRAGMENT) {
        oit_i_lay_source(source, program);
    } else if (program == OIT_I_PROGRAM_PICK || (program == OIT_I_PROGRAM_DEPTH && stage == OIT_FRAGMENT)) {
        oit_i_ordered_source(source, program, desc);
    } else if (oit_i_is_compute(program)) {
        oit_i_compute_source(source, program, desc->fit == OIT_FIT_ASYNC);
    } else if (stage == OIT_VERTEX) {
        oit_i_add_chunks(source, oit_i_shader_oit_fullscreen_vert);
    } else {
        if (desc->fields & OIT_FIELD_BLEND)
            mode = !es ? OIT_I_MODE_DUAL : index > OIT_I_CLASSES ? OIT_I_MODE_LIGHT : OIT_I_MODE_FILTER;
        oit_i_compose_source(source, index % (OIT_I_CLASSES + 1), mode, sampled, desc->store == OIT_STORE_FETCH,
                             scratch);
    }
}

static oit_i_u oit_i_compile(oit_context *oit, int program, oit_i_u type, char *scratch) {
    oit_i_source source;
    oit_i_message message;
    char log[2048] = "";
    int32_t ok = 0;
    oit_i_u shader = oit->gl.gl_CreateShader(type);
    if (!shader)
        return 0;
    oit_i_program_source(&source, program, type == OIT_I_GL_VERTEX_SHADER ? OIT_VERTEX : OIT_FRAGMENT, &oit->desc,
                         oit->info.es, oit->preamble, scratch);
    oit->gl.gl_ShaderSource(shader, source.count, source.strings, 0);
    oit->gl.gl_CompileShader(shader);
    oit->gl.gl_GetShaderiv(shader, OIT_I_GL_COMPILE_STATUS, &ok);
    if (ok)
        return shader;
    oit->gl.gl_GetShaderInfoLog(shader, (int32_t)sizeof log, 0, log);
    oit_i_put(oit_i_say(&message, "oit_begin", "a built-in shader does not compile: "), log);
    oit_i_log(&oit->desc, OIT_LOG_ERROR, OIT_SHADER_FAILED, &message);
    oit->gl.gl_DeleteShader(shader);
    return 0;
}

static oit_i_u oit_i_link(oit_context *oit, const oit_i_u *shaders, int count) {
    oit_i_message message;
    char log[2048] = "";
    int32_t ok = 0;
    int i;
    oit_i_u program = oit->gl.gl_CreateProgram();
    if (!program)
        return 0;
    for (i = 0; i < count; ++i)
        oit->gl.gl_AttachShader(program, shaders[i]);
    oit->gl.gl_LinkProgram(program);
    oit->gl.gl_GetProgramiv(program, OIT_I_GL_LINK_STATUS, &ok);
    if (ok)
        return program;
    oit->gl.gl_GetProgramInfoLog(program, (int32_t)sizeof log, 0, log);
    oit_i_put(oit_i_say(&message, "oit_begin", "a built-in program does not link: "), log);
    oit_i_log(&oit->desc, OIT_LOG_ERROR, OIT_SHADER_FAILED, &message);
    oit->gl.gl_DeleteProgram(program);
    return 0;
}

static void oit_i_find_uniforms(oit_context *oit, int program) {
    oit_i_surface *surface = &oit->surfaces[program - OIT_I_PROGRAM_COUNT];
    oit_i_u name = oit->programs[program];
    surface->model_view_projection = oit->gl.gl_GetUniformLocation(name, "oit_model_view_projection");
    surface->normal_matrix = oit->gl.gl_GetUniformLocation(name, "oit_normal_matrix");
    surface->color = oit->gl.gl_GetUniformLocation(name, "oit_object_color");
    surface->object = oit->gl.gl_GetUniformLocation(name, "oit_object");
}

static oit_result oit_i_make_program(oit_context *oit, int program) {
    static const oit_i_u drawn[2] = {OIT_I_GL_VERTEX_SHADER, OIT_I_GL_FRAGMENT_SHADER};
    static const oit_i_u computed[1] = {OIT_I_GL_COMPUTE_SHADER};
    const oit_i_u *types = oit_i_is_compute(program) ? computed : drawn;
    int count = oit_i_is_compute(program) ? 1 : 2, made = 0;
    oit_i_u shaders[2];
    char *scratch;
    if (oit->programs[program])
        return OIT_OK;
    scratch = (char *)oit->desc.alloc_fn(OIT_I_NETWORK_CAPACITY, oit->desc.alloc_user);
    if (!scratch)
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no memory for the text of a shader");
    for (; made < count; ++made) {
        shaders[made] = oit_i_compile(oit, program, types[made], scratch);
        if (!shaders[made])
            break;
    }
    if (made == count)
        oit->programs[program] = oit_i_link(oit, shaders, count);
    while (made > 0)
        oit->gl.gl_DeleteShader(shaders[--made]);
    oit->desc.free_fn(scratch, oit->desc.alloc_user);
    if (!oit->programs[program])
        return oit_i_fail(&oit->desc, OIT_SHADER_FAILED, "oit_begin", oit_result_string(OIT_SHADER_FAILED));
    if (oit_i_is_surface(program))
        oit_i_find_uniforms(oit, program);
    return OIT_OK;
}

static void oit_i_assemble_host_sources(oit_context *oit) {
    oit_i_source source;
    int stage, fill;
    for (stage = 0; stage < (int)OIT_STAGE_COUNT; ++stage) {
        for (fill = 0; fill < 2; ++fill) {
            oit_i_host_source(&source, (oit_stage)stage, fill, &oit->desc, oit->info.es, oit->preamble);
            /* The host's own text counts its lines from 1. */
            oit_i_add(&source, "#line 1\n");
            memcpy(oit->strings[stage][fill], source.strings, (size_t)source.count * sizeof source.strings[0]);
            oit->string_count[stage][fill] = source.count;
        }
    }
}

static void oit_i_assemble_operator_source(oit_context *oit) {
    oit_i_source source;
    oit_i_add_preamble(&source, oit->info.es, oit->preamble);
    oit_i_operator_source(&source);
    oit_i_add_chunks(&source, oit_i_shader_oit_operator_glsl);
    oit_i_add(&source, "#line 1\n");
    memcpy(oit->operator_strings, source.strings, (size_t)source.count * sizeof source.strings[0]);
    oit->operator_string_count = source.count;
}

OIT_I_API const char *const *oit_glsl(const oit_context *oit, oit_stage stage, oit_pass_kind kind, int *count) {
    int fill = kind == OIT_PASS_FILL;
    if (!oit || (unsigned)stage >= (unsigned)OIT_STAGE_COUNT || !count || (kind != OIT_PASS_COUNT && !fill))
        return 0;
    *count = oit->string_count[stage][fill];
    return oit->strings[stage][fill];
}

/* ---- creation --------------------------------------------------------------------------------------------------- */

static void *oit_i_default_alloc(size_t size, void *user) {
    (void)user;
    return OIT_MALLOC(size);
}

static void oit_i_default_free(void *block, void *user) {
    (void)user;
    OIT_FREE(block);
}

/* Bytes of a storage block that can be addressed: by drivers in 31 bits, by the host's limits. */
static void oit_i_limit_blocks(oit_context *oit) {
    int64_t most = 0x7ffffff0;
    if (oit->info.storage_block_bytes < most)
        most = oit->info.storage_block_bytes;
    if (oit->desc.max_block_bytes && oit->desc.max_block_bytes < most)
        most = oit->desc.max_block_bytes;
    oit->desc.max_block_bytes = most;
    if (oit->desc.ceiling_bytes == 0)
        oit->desc.ceiling_bytes = (int64_t)512 << 20;
    if (oit->desc.ceiling_bytes > most && oit->desc.store != OIT_STORE_FETCH) /* whose targets are no blocks */
        oit->desc.ceiling_bytes = most;
    if (oit->desc.budget_bytes == 0) /* more than a block would cut the image into slabs, each drawn twice */
        oit->desc.budget_bytes = most < (int64_t)256 << 20 ? most : (int64_t)256 << 20;
}

/* OIT_STORE_FETCH: seven layers a pass where there are eight draw buffers, else three; a block of storage is among a fragment
   shader's outputs too. Fetching that takes barriers is of no use: fragments of one draw meet in a pixel. */
static oit_result oit_i_find_fetch(oit_context *oit) {
    oit_i_text text =
        oit_i_text_in(oit->preamble + strlen(oit->preamble), sizeof oit->preamble - strlen(oit->preamble));
    oit_i_message message;
    oit->fetched = 7;
    if (oit_i_limit(oit, OIT_I_GL_MAX_DRAW_BUFFERS, 8) < 8 || oit->info.combined_outputs < 9)
        oit->fetched = 3;
    oit_i_define(&text, "OIT_FETCHED", oit->fetched);
    if (oit_i_has_extension(&oit->gl, "GL_EXT_shader_framebuffer_fetch") &&
        oit->info.combined_outputs > oit->fetched + 1)
        return OIT_OK;
    oit_i_say(&message, "oit_create",
              "OIT_STORE_FETCH needs GL_EXT_shader_framebuffer_fetch and five outputs of a shader");
    return oit_i_refuse(&oit->desc, OIT_NO_FETCH, &message);
}

static oit_result oit_i_set_up(oit_context *oit) {
    oit_result result;
    oit_i_load(&oit->desc, &oit->gl);
    result = oit_i_check_queries(&oit->desc, &oit->gl);
    if (result == OIT_OK)
        result = oit_i_find_version(oit);
    if (result == OIT_OK)
        result = oit_i_check_functions(oit);
    if (result == OIT_OK)
        result = oit_i_find_limits(oit);
    if (result == OIT_OK)
        result = oit_i_check_bindings(oit);
    if (result != OIT_OK)
        return result;
    oit_i_find_state_limits(oit);
    oit_i_limit_blocks(oit);
    oit->info.fragment_bytes = 4 * oit_i_layout(&oit->desc).words;
    oit_i_write_preamble(&oit->desc, oit->info.es, oit->preamble, sizeof oit->preamble);
    if (oit->desc.store == OIT_STORE_FETCH && oit_i_find_fetch(oit) != OIT_OK)
        return OIT_NO_FETCH;
    oit_i_assemble_host_sources(oit);
    if (oit_i_operates(&oit->desc))
        oit_i_assemble_operator_source(oit);
    return OIT_OK;
}

OIT_I_API oit_context *oit_create(const oit_desc *desc, oit_result *result) {
    oit_context *oit;
    oit_result ignored;
    oit_desc d;
    if (!result)
        result = &ignored;
    *result = OIT_INVALID_ARGUMENT;
    if (!desc)
        return 0;
    d = *desc;
    d.operators = oit_i_links_of(d.operators);
    if (d.operators & OIT_OPERATE_LINKS)
        d.fields |= OIT_FIELD_PART | OIT_FIELD_NORMAL;
    if (oit_i_bad_member(&d)) {
        oit_i_fail(desc, OIT_INVALID_ARGUMENT, "oit_create", oit_i_bad_member(&d));
        return 0;
    }
    if (!d.alloc_fn) {
        d.alloc_fn = oit_i_default_alloc;
        d.free_fn = oit_i_default_free;
    }
    oit = (oit_context *)d.alloc_fn(sizeof *oit, d.alloc_user);
    if (!oit) {
        *result = oit_i_fail(&d, OIT_OUT_OF_MEMORY, "oit_create", "out of memory");
        return 0;
    }
    memset(oit, 0, sizeof *oit);
    oit->desc = d;
    *result = oit_i_set_up(oit);
    if (*result != OIT_OK) {
        d.free_fn(oit, d.alloc_user);
        return 0;
    }
    return oit;
}

static void oit_i_drop_fences(oit_context *oit) {
    int i;
    for (i = 0; i < OIT_I_REPORTS; ++i) {
        if (oit->fences[i])
            oit->gl.gl_DeleteSync(oit->fences[i]);
        oit->fences[i] = 0;
    }
    for (i = 0; i < OIT_MAX_PICKS; ++i) {
        if (oit->picks[i].fence)
            oit->gl.gl_DeleteSync(oit->picks[i].fence);
        oit->picks[i].fence = 0;
    }
}

static void oit_i_drop_fetch(oit_context *oit) {
    int i;
    if (oit->fetch_framebuffer)
        oit->gl.gl_DeleteFramebuffers(1, &oit->fetch_framebuffer);
    for (i = 0; i < 8; ++i)
        if (oit->fetch_targets[i])
            oit->gl.gl_DeleteTextures(1, &oit->fetch_targets[i]);
    memset(oit->fetch_targets, 0, sizeof oit->fetch_targets);
    oit->fetch_framebuffer = 0;
    oit->fetch_width = oit->fetch_height = 0;
}

static void oit_i_drop_buffers(oit_context *oit) {
    int i;
    oit_i_drop_fences(oit);
    for (i = 0; i < OIT_I_BUFFER_COUNT; ++i) {
        if (oit->buffers[i])
            oit->gl.gl_DeleteBuffers(1, &oit->buffers[i]);
        oit->buffers[i] = 0;
        oit->sizes[i] = 0;
    }
    oit_i_drop_fetch(oit);
    oit->capacity = 0;
    oit->settled_width = 0;
    memset(oit->picks, 0, sizeof oit->picks);
}

OIT_I_API oit_result oit_release(oit_context *oit) {
    if (!oit)
        return OIT_INVALID_ARGUMENT;
    if (oit->in_frame)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_release", "inside of a frame");
    oit_i_drop_buffers(oit);
    return OIT_OK;
}

OIT_I_API void oit_destroy(oit_context *oit) {
    int i;
    if (!oit)
        return;
    oit_i_drop_buffers(oit);
    for (i = 0; i < OIT_I_PROGRAMS; ++i)
        if (oit->programs[i])
            oit->gl.gl_DeleteProgram(oit->programs[i]);
    if (oit->vertex_array)
        oit->gl.gl_DeleteVertexArrays(1, &oit->vertex_array);
    oit->desc.free_fn(oit, oit->desc.alloc_user);
}

static int64_t oit_i_fetch_bytes(const oit_context *oit, int64_t width, int64_t height) {
    return width * height * (16 * oit->fetched + 8);
}

OIT_I_API oit_info oit_get_info(const oit_context *oit) {
    oit_info info;
    int i;
    memset(&info, 0, sizeof info);
    if (!oit)
        return info;
    info = oit->info;
    for (i = 0; i < OIT_I_BUFFER_COUNT; ++i)
        info.bytes += (uint64_t)oit->sizes[i];
    info.bytes += (uint64_t)oit_i_fetch_bytes(oit, oit->fetch_width, oit->fetch_height);
    return info;
}

/* ---- buffers ---------------------------------------------------------------------------------------------------- */

/* All work on buffers goes through this target, so that one binding is all that has to be put back. */
static int32_t oit_i_borrow_target(const oit_context *oit) {
    int32_t bound = 0;
    oit->gl.gl_GetIntegerv(OIT_I_GL_COPY_WRITE_BUFFER, &bound);
    return bound;
}

static void oit_i_return_target(const oit_context *oit, int32_t bound) {
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, (oit_i_u)bound);
}

/* glGetError is the host's: whether there was memory shows in the size that the buffer has afterwards. Left bound. */
static int oit_i_resize(oit_context *oit, int index, int64_t bytes, oit_i_u usage) {
    int64_t got = -1;
    if (!oit->buffers[index])
        oit->gl.gl_GenBuffers(1, &oit->buffers[index]);
    if (!oit->buffers[index])
        return 0;
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, oit->buffers[index]);
    oit->gl.gl_BufferData(OIT_I_GL_COPY_WRITE_BUFFER, (ptrdiff_t)bytes, 0, usage);
    oit->gl.gl_GetBufferParameteri64v(OIT_I_GL_COPY_WRITE_BUFFER, OIT_I_GL_BUFFER_SIZE, &got);
    oit->sizes[index] = got == bytes ? bytes : 0;
    if (got == bytes)
        return 1;
    oit->gl.gl_DeleteBuffers(1, &oit->buffers[index]);
    oit->buffers[index] = 0;
    return 0;
}

static oit_i_u oit_i_blocks(int64_t pixels) {
    return (oit_i_u)((pixels + OIT_I_SCAN_BLOCK - 1) / OIT_I_SCAN_BLOCK);
}

/* Words of the pixel buffer for each fragment that may be kept: its key, and a bucket of two. */
static int oit_i_kept_words(const oit_desc *desc) {
    return desc->store == OIT_STORE_BUCKETED ? 3 : 1;
}

/* Sections of the buffer of the surfaces that the operators of this context need; each of a word a fragment. */
static int oit_i_has_section(const oit_context *oit, int section, int wide) {
    oit_i_u operators = oit->desc.operators;
    switch (section) {
    case OIT_I_AT_ORDER:
        return oit_i_operates(&oit->desc);
    case OIT_I_AT_LINKS:
        return (operators & OIT_OPERATE_LINKS) != 0;
    case OIT_I_AT_LINKS_HIGH:
        return (operators & OIT_OPERATE_LINKS) != 0 && wide;
    case OIT_I_AT_BASE:
        return (operators & OIT_OPERATE_LAW) != 0;
    case OIT_I_AT_SPARE:
        return (operators & (OIT_OPERATE_SMART | OIT_OPERATE_LOCAL | OIT_OPERATE_CONTOURS)) != 0;
    case OIT_I_AT_REACH:
        return (operators & OIT_OPERATE_SMART) != 0;
    case OIT_I_AT_KAPPA:
        return (operators & OIT_OPERATE_CURVATURE) != 0;
    case OIT_I_AT_BETA:
    case OIT_I_AT_GAMMA:
        return (operators & OIT_OPERATE_DIFFUSION) != 0;
    case OIT_I_AT_SIZES:
    case OIT_I_AT_SIZES_HIGH:
        return (operators & OIT_OPERATE_THIN) != 0;
    case OIT_I_AT_GROUPED:
        return (operators & OIT_OPERATE_BUCKETS) != 0;
    case OIT_I_AT_RADIAL:
        return (operators & OIT_OPERATE_CONTOURS) != 0;
    default:
        return section - OIT_I_AT_HOST < oit->desc.operator_fields;
    }
}

static int oit_i_section_count(const oit_context *oit, int wide) {
    int i, count = 0;
    for (i = 0; i < OIT_I_SECTIONS; ++i)
        count += oit_i_has_section(oit, i, wide);
    return count;
}

#define OIT_I_MAX_LAYERS 1024

/* k: as many as the budget has room for in each pixel of the image. */
static int oit_i_layers(const oit_context *oit, int64_t pixels) {
    int64_t fields = 4 * (int64_t)oit_i_section_count(oit, 1);
    int64_t each = oit->info.fragment_bytes + 4 * oit_i_kept_words(&oit->desc) + fields;
    int64_t most = oit->desc.layers ? oit->desc.layers : OIT_I_MAX_LAYERS;
    int64_t layers = pixels > 0 ? oit->desc.budget_bytes / each / pixels : 0;
    if (!oit_i_keeps(&oit->desc))
        return 0;
    if (fields) { /* no slabs: operators need all of the image at once */
        int64_t widest = fields > oit->info.fragment_bytes ? fields : oit->info.fragment_bytes;
        int64_t held = (oit->desc.max_block_bytes - 4 * OIT_I_HEADER_WORDS) / widest / (pixels > 0 ? pixels : 1);
        most = held < most ? held : most;
    }
    if (most > OIT_I_MAX_LAYERS)
        most = OIT_I_MAX_LAYERS;
    return (int)(layers < most ? layers : most);
}

/* Of the pixel buffer, laid out as shaders/oit_frame_block.glsl says. */
static int64_t oit_i_pixel_bytes(const oit_context *oit, int64_t pixels) {
    int64_t words = OIT_I_HEADER_WORDS + 2 * pixels + 2 + (int64_t)oit_i_blocks(pixels);
    if (oit_i_keeps(&oit->desc))
        words += (8 + (int64_t)oit->layers * oit_i_kept_words(&oit->desc)) * pixels;
    else
        words += (oit_i_own_words(&oit->desc) + oit_i_tail_words(&oit->desc)) * pixels;
    if (oit->desc.fields & OIT_FIELD_COVERAGE)
        words += pixels;
    return 4 * words;
}

/* Whether the buffers of so many pixels are such as the context can have. */
static int oit_i_can_hold(const oit_context *oit, int64_t pixels) {
    return oit_i_pixel_bytes(oit, pixels) <= oit->desc.max_block_bytes &&
           pixels * oit->layers * oit->info.fragment_bytes <= oit->desc.max_block_bytes;
}

/* Rows of the image that one pixel buffer holds: all, or as many as fit; 0 where not even one does. */
static int oit_i_rows_at_once(const oit_context *oit, int width, int height) {
    int low = 0, high = height;
    while (low < high) {
        int middle = low + (high - low + 1) / 2;
        if (oit_i_can_hold(oit, (int64_t)width * middle))
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/* That a fragment takes of the ceiling. */
static int64_t oit_i_record_bytes(const oit_context *oit) {
    return oit->info.fragment_bytes * (oit->desc.store == OIT_STORE_LINKED ? 2 : 1);
}

static int oit_i_resize_pool(oit_context *oit, int64_t fragments) {
    int64_t bytes = fragments * oit->info.fragment_bytes;
    return oit_i_resize(oit, OIT_I_FRAGMENTS, bytes, OIT_I_GL_DYNAMIC_COPY) &&
           (oit->desc.store != OIT_STORE_LINKED || oit_i_resize(oit, OIT_I_LIST, bytes, OIT_I_GL_DYNAMIC_COPY));
}

/* A pool for so many fragments, or, where that is over the ceiling or there is no memory for it, for fewer. */
static oit_result oit_i_set_capacity(oit_context *oit, uint64_t wanted, const char *function) {
    int64_t record = oit_i_record_bytes(oit), most = oit->desc.ceiling_bytes / record;
    int64_t fragments = wanted > (uint64_t)most ? most : (int64_t)wanted;
    for (; fragments > 0; fragments /= 2) {
        if (oit_i_resize_pool(oit, fragments)) {
            oit->capacity = (oit_i_u)fragments;
            oit->small_needs = 0;
            return OIT_OK;
        }
    }
    oit->capacity = 0;
    return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, function, "no memory for the fragments");
}

static uint64_t oit_i_with_quarter(uint64_t fragments) {
    return fragments + fragments / 4 + 1;
}

/* Growth by a quarter more than is needed; shrinkage when for 60 frames in a row less than half of that was. */
static int oit_i_capacity_is_wrong(oit_context *oit, oit_i_u needed) {
    uint64_t wanted = oit_i_with_quarter(needed);
    int64_t most = oit->desc.ceiling_bytes / oit_i_record_bytes(oit);
    oit->small_needs = 2 * wanted < oit->capacity ? oit->small_needs + 1 : 0;
    return (needed > oit->capacity && (int64_t)oit->capacity < most) || oit->small_needs >= 60;
}

/* The uniform block: uploaded only when it changes. */
static oit_result oit_i_upload_block(oit_context *oit, const oit_i_block *block) {
    if (oit->sizes[OIT_I_UNIFORMS] && memcmp(block, &oit->block, sizeof *block) == 0)
        return OIT_OK;
    if (!oit->sizes[OIT_I_UNIFORMS] &&
        !oit_i_resize(oit, OIT_I_UNIFORMS, (int64_t)sizeof *block, OIT_I_GL_DYNAMIC_DRAW))
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no memory for the uniform block");
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, oit->buffers[OIT_I_UNIFORMS]);
    oit->gl.gl_BufferSubData(OIT_I_GL_COPY_WRITE_BUFFER, 0, (ptrdiff_t)sizeof *block, block);
    oit->block = *block;
    return OIT_OK;
}

/* k records a pixel; at least one, since a buffer of none cannot be bound. */
static oit_result oit_i_make_places(oit_context *oit, int64_t pixels) {
    int64_t places = pixels * oit->layers, bytes = (places > 0 ? places : 1) * oit_i_record_bytes(oit);
    if (oit->sizes[OIT_I_FRAGMENTS] < bytes || oit->sizes[OIT_I_FRAGMENTS] / 4 > bytes)
        if (!oit_i_resize(oit, OIT_I_FRAGMENTS, bytes, OIT_I_GL_DYNAMIC_COPY))
            return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no memory for the fragments");
    oit->capacity = (oit_i_u)places;
    return OIT_OK;
}

/* OIT_STORE_FETCH: targets as large as the host's up to the corner of the viewport, so that its depth can stand beside them. */
static oit_result oit_i_make_targets(oit_context *oit, int width, int height) {
    const oit_i_gl *gl = &oit->gl;
    oit_i_u buffers[8];
    int32_t texture = 0;
    int i;
    if (oit_i_fetch_bytes(oit, width, height) > oit->desc.ceiling_bytes)
        return oit_i_fail(&oit->desc, OIT_TOO_LARGE, "oit_begin", "the layers of a pass are over the ceiling");
    oit_i_drop_fetch(oit);
    gl->gl_GetIntegerv(OIT_I_GL_TEXTURE_BINDING_2D, &texture);
    gl->gl_GenFramebuffers(1, &oit->fetch_framebuffer);
    gl->gl_BindFramebuffer(OIT_I_GL_DRAW_FRAMEBUFFER, oit->fetch_framebuffer);
    for (i = 0; i <= oit->fetched; ++i) {
        buffers[i] = OIT_I_GL_COLOR_ATTACHMENT0 + (oit_i_u)i;
        gl->gl_GenTextures(1, &oit->fetch_targets[i]);
        gl->gl_BindTexture(OIT_I_GL_TEXTURE_2D, oit->fetch_targets[i]);
        gl->gl_TexStorage2D(OIT_I_GL_TEXTURE_2D, 1, i < oit->fetched ? OIT_I_GL_RGBA32UI : OIT_I_GL_RG32UI, width,
                            height);
        gl->gl_FramebufferTexture2D(OIT_I_GL_DRAW_FRAMEBUFFER, buffers[i], OIT_I_GL_TEXTURE_2D, oit->fetch_targets[i],
                                    0);
    }
    gl->gl_DrawBuffers(oit->fetched + 1, buffers);
    gl->gl_BindTexture(OIT_I_GL_TEXTURE_2D, (oit_i_u)texture);
    oit->fetch_width = width;
    oit->fetch_height = height;
    return OIT_OK;
}

/* The depth of the host's framebuffer becomes that of ours, where it has one. It may be another each frame. */
static oit_result oit_i_share_depth(oit_context *oit) {
    const oit_i_gl *gl = &oit->gl;
    oit_i_u where = oit->frame.framebuffer ? OIT_I_GL_DEPTH_ATTACHMENT : OIT_I_GL_DEPTH;
    int32_t type = 0, name = 0, level = 0, shared = 0;
    gl->gl_BindFramebuffer(OIT_I_GL_DRAW_FRAMEBUFFER, oit->frame.framebuffer);
    gl->gl_GetFramebufferAttachmentParameteriv(OIT_I_GL_DRAW_FRAMEBUFFER, where,
                                               OIT_I_GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type != 0 && where == OIT_I_GL_DEPTH)
        return oit_i_fail(&oit->desc, OIT_NO_FETCH, "oit_begin",
                          "OIT_STORE_FETCH cannot share the depth of the default framebuffer; draw into another one");
    if (type != 0)
        gl->gl_GetFramebufferAttachmentParameteriv(OIT_I_GL_DRAW_FRAMEBUFFER, where,
                                                   OIT_I_GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    if (type == (int32_t)OIT_I_GL_TEXTURE)
        gl->gl_GetFramebufferAttachmentParameteriv(OIT_I_GL_DRAW_FRAMEBUFFER, where,
                                                   OIT_I_GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, &level);
    gl->gl_BindFramebuffer(OIT_I_GL_DRAW_FRAMEBUFFER, oit->fetch_framebuffer);
    gl->gl_FramebufferRenderbuffer(OIT_I_GL_DRAW_FRAMEBUFFER, OIT_I_GL_DEPTH_ATTACHMENT, OIT_I_GL_RENDERBUFFER,
                                   type == 0 || type == (int32_t)OIT_I_GL_TEXTURE ? 0 : (oit_i_u)name);
    if (type == (int32_t)OIT_I_GL_TEXTURE)
        gl->gl_FramebufferTexture2D(OIT_I_GL_DRAW_FRAMEBUFFER, OIT_I_GL_DEPTH_ATTACHMENT, OIT_I_GL_TEXTURE_2D,
                                    (oit_i_u)name, level);
    /* A layer of an array is refused by GL, and the frame would go without the depth. */
    gl->gl_GetFramebufferAttachmentParameteriv(OIT_I_GL_DRAW_FRAMEBUFFER, OIT_I_GL_DEPTH_ATTACHMENT,
                                               OIT_I_GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &shared);
    if (shared != type)
        return oit_i_fail(&oit->desc, OIT_NO_FETCH, "oit_begin",
                          "OIT_STORE_FETCH: the target's depth is neither a renderbuffer nor a 2D texture");
    return OIT_OK;
}

static oit_result oit_i_make_fetch(oit_context *oit) {
    int right = oit->frame.x + oit->frame.width, top = oit->frame.y + oit->frame.height;
    int width = right > 0 ? right : 1, height = top > 0 ? top : 1; /* a viewport may lie outside of its target */
    oit_result result = OIT_OK;
    if (oit->fetch_width < width || oit->fetch_height < height)
        result = oit_i_make_targets(oit, width > oit->fetch_width ? width : oit->fetch_width,
                                    height > oit->fetch_height ? height : oit->fetch_height);
    if (result == OIT_OK)
        result = oit_i_share_depth(oit);
    if (result != OIT_OK)
        return result;
    if (oit->gl.gl_CheckFramebufferStatus(OIT_I_GL_DRAW_FRAMEBUFFER) == OIT_I_GL_FRAMEBUFFER_COMPLETE)
        return OIT_OK;
    oit_i_drop_fetch(oit);
    return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no memory for the layers of a pass");
}

static oit_result oit_i_make_buffers(oit_context *oit) {
    int64_t pixels = (int64_t)oit->frame.width * oit->rows, bytes = oit_i_pixel_bytes(oit, pixels);
    int i;
    /* Sizes that come and go, as while a window is dragged, do not make a new buffer each. */
    if (oit->sizes[OIT_I_PIXELS] < bytes || oit->sizes[OIT_I_PIXELS] / 4 > bytes)
        if (!oit_i_resize(oit, OIT_I_PIXELS, bytes, OIT_I_GL_DYNAMIC_COPY))
            return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no memory for the pixels");
    for (i = OIT_I_REPORT; i < OIT_I_REPORT + OIT_I_REPORTS; ++i)
        if (!oit->sizes[i] && !oit_i_resize(oit, i, 4 * OIT_I_HEADER_WORDS, OIT_I_GL_DYNAMIC_READ))
            return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no memory for the reports");
    if (oit_i_keeps(&oit->desc))
        return oit_i_make_places(oit, pixels);
    if (oit->desc.store == OIT_STORE_FETCH)
        return oit_i_make_fetch(oit);
    if (oit->desc.fit == OIT_FIT_WAIT && oit->capacity)
        return OIT_OK;
    if (!oit->capacity)
        return oit_i_set_capacity(
            oit, oit->report.needed ? oit_i_with_quarter(oit->report.needed) : 4 * (uint64_t)pixels, "oit_begin");
    return OIT_OK;
}

/* ---- the buffer of the surfaces ---- */

/* The buffer, for as many fragments as the pool holds, and where its sections lie. The target must be borrowed. */
static oit_result oit_i_make_surfaces(oit_context *oit, const char *function) {
    oit_i_u deepest = oit_i_keeps(&oit->desc)         ? (oit_i_u)oit->layers
                      : oit->desc.fit == OIT_FIT_WAIT ? oit->deepest
                                                      : oit->report.deepest;
    int64_t words = OIT_I_HEADER_WORDS;
    int i;
    oit->wide = deepest > 254;
    for (i = 0; i < OIT_I_SECTIONS; ++i) {
        oit->sections[i] = oit_i_has_section(oit, i, oit->wide) ? (oit_i_u)words : 0;
        words += oit->sections[i] ? (int64_t)oit->capacity : 0;
    }
    if (4 * words > oit->desc.max_block_bytes)
        return oit_i_fail(&oit->desc, OIT_TOO_LARGE, function,
                          "the fields of the fragments are more than a block holds");
    if (oit->sizes[OIT_I_SURFACE] >= 4 * words && oit->sizes[OIT_I_SURFACE] / 4 <= 4 * words)
        return OIT_OK;
    if (!oit_i_resize(oit, OIT_I_SURFACE, 4 * words, OIT_I_GL_DYNAMIC_COPY))
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, function, "no memory for the fields of the fragments");
    return OIT_OK;
}

/* ---- reports ---------------------------------------------------------------------------------------------------- */

/* Totals of a report buffer; the buffer's own barrier and fence are behind us. */
static int oit_i_read_totals(const oit_context *oit, int slot, oit_i_u totals[OIT_I_HEADER_WORDS]) {
    const void *mapped;
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, oit->buffers[OIT_I_REPORT + slot]);
    mapped = oit->gl.gl_MapBufferRange(OIT_I_GL_COPY_WRITE_BUFFER, 0, 4 * OIT_I_HEADER_WORDS, OIT_I_GL_MAP_READ_BIT);
    memset(totals, 0, sizeof(oit_i_u) * OIT_I_HEADER_WORDS);
    if (!mapped)
        return 0;
    memcpy(totals, mapped, sizeof(oit_i_u) * OIT_I_HEADER_WORDS);
    oit->gl.gl_UnmapBuffer(OIT_I_GL_COPY_WRITE_BUFFER);
    return 1;
}

static int oit_i_fence_passed(const oit_context *oit, oit_i_sync fence, int wait) {
    oit_i_u status;
    do {
        status = oit->gl.gl_ClientWaitSync(fence, OIT_I_GL_SYNC_FLUSH_COMMANDS_BIT, wait ? 1000000000u : 0u);
        if (status == OIT_I_GL_ALREADY_SIGNALED || status == OIT_I_GL_CONDITION_SATISFIED)
            return 1;
    } while (wait && status == 0x911Bu); /* GL_TIMEOUT_EXPIRED */
    return 0;
}

/* OIT_STORE_PREDICT: what the pool should hold. What was counted takes half of it in the next frame, until more is known:
   of few layers a run is twice as long as needed. */
static void oit_i_note_places(oit_context *oit, const oit_i_u totals[OIT_I_HEADER_WORDS], int guessed) {
    if (oit->desc.store != OIT_STORE_PREDICT)
        oit->places = totals[0];
    else
        oit->places = guessed ? totals[5] : totals[0] > 0x7fffffffu ? 0xffffffffu : 2 * totals[0];
}

/* Takes the reports whose frames are finished. The target must be borrowed. */
static void oit_i_take_reports(oit_context *oit, int wait) {
    int slot;
    for (slot = 0; slot < OIT_I_REPORTS; ++slot) {
        oit_i_u totals[OIT_I_HEADER_WORDS];
        if (!oit->fences[slot] || !oit_i_fence_passed(oit, oit->fences[slot], wait))
            continue;
        oit->gl.gl_DeleteSync(oit->fences[slot]);
        oit->fences[slot] = 0;
        if (oit->pending[slot].frame < oit->report.frame || !oit_i_read_totals(oit, slot, totals))
            continue;
        oit->report = oit->pending[slot];
        oit->report.needed = totals[0];
        oit->report.deepest = totals[1];
        oit->report.lost_pixels = totals[2];
        oit->report.lost = totals[3];
        oit->report.extra = totals[4];
        oit_i_note_places(oit, totals, oit->guessed[slot]);
        memcpy(oit->class_pixels, totals + 8, sizeof oit->class_pixels);
        oit->news = 1;
    }
}

OIT_I_API oit_result oit_get_report(oit_context *oit, oit_report *report) {
    int32_t bound;
    if (!oit || !report)
        return OIT_INVALID_ARGUMENT;
    if (oit->desc.fit == OIT_FIT_WAIT && !oit->in_frame) {
        bound = oit_i_borrow_target(oit);
        oit_i_take_reports(oit, 1);
        oit_i_return_target(oit, bound);
    }
    *report = oit->report;
    return OIT_OK;
}

/* ---- the sequence ----------------------------------------------------------------------------------------------- */

/* By its bits: comparisons with NaN are what -ffast-math takes away. */
static int oit_i_all_finite(const float *numbers, int count) {
    int i;
    for (i = 0; i < count; ++i) {
        oit_i_u bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        if ((bits & 0x7f800000u) == 0x7f800000u)
            return 0;
    }
    return 1;
}

static oit_result oit_i_check_frame(oit_context *oit, const oit_frame *frame) {
    if (!oit_i_all_finite(&frame->background_weight, 1) || !oit_i_all_finite(frame->light, 3))
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_begin", "a number of the frame is not finite");
    if ((unsigned)frame->depth > (unsigned)OIT_DEPTH_THRESHOLD)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_begin", "frame.depth is none of its enumerators");
    if (frame->depth == OIT_DEPTH_THRESHOLD && !(oit_i_all_finite(&frame->depth_threshold, 1) &&
                                                 frame->depth_threshold > 0.0f && frame->depth_threshold <= 1.0f))
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_begin", "frame.depth_threshold is not in ]0,1]");
    if (frame->depth != OIT_DEPTH_NONE && oit->desc.store == OIT_STORE_FETCH)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_begin",
                          "frame.depth: OIT_STORE_FETCH keeps no layers");
    if (frame->width < 0 || frame->height < 0)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_begin", "frame.width or frame.height is negative");
    if (frame->x < -32768 || frame->x > 32767 || frame->y < -32768 || frame->y > 32767) /* GL would move it, unasked */
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_begin",
                          "frame.x or frame.y is not in -32,768 ... 32,767");
    if (frame->width > oit->max_viewport[0] || frame->height > oit->max_viewport[1])
        return oit_i_fail(&oit->desc, OIT_TOO_LARGE, "oit_begin", "frame.width or frame.height");
    oit->layers = oit_i_layers(oit, (int64_t)frame->width * frame->height);
    oit->rows = oit_i_rows_at_once(oit, frame->width, frame->height);
    if (oit->rows == 0 && frame->width > 0 && frame->height > 0)
        return oit_i_fail(&oit->desc, OIT_TOO_LARGE, "oit_begin", "one row is more than a storage block holds");
    if (oit->rows < frame->height && oit->desc.state == OIT_STATE_NONE)
        return oit_i_fail(&oit->desc, OIT_TOO_LARGE, "oit_begin",
                          "the image is more than a storage block holds, and OIT_STATE_NONE draws it at once or not");
    return OIT_OK;
}

static oit_result oit_i_check_framebuffer(oit_context *oit, oit_i_u framebuffer, const char *name) {
    int32_t bound = 0;
    oit->gl.gl_BindFramebuffer(OIT_I_GL_DRAW_FRAMEBUFFER, framebuffer);
    /* A name that is none is not bound, and what was bound before would pass for it. */
    oit->gl.gl_GetIntegerv(OIT_I_GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    if ((oit_i_u)bound != framebuffer ||
        oit->gl.gl_CheckFramebufferStatus(OIT_I_GL_DRAW_FRAMEBUFFER) != OIT_I_GL_FRAMEBUFFER_COMPLETE)
        return oit_i_fail(&oit->desc, OIT_TARGET_INCOMPLETE, "oit_begin", name);
    return OIT_OK;
}

/* How many samples the target that is bound has, and where they lie, from the middle of a pixel. */
static oit_result oit_i_find_samples(oit_context *oit) {
    int i, k;
    oit->samples = 0;
    memset(oit->positions, 0, sizeof oit->positions);
    oit->gl.gl_GetIntegerv(OIT_I_GL_SAMPLES, &oit->samples);
    if (oit->samples <= 1)
        return OIT_OK;
    if (!(oit->desc.fields & OIT_FIELD_COVERAGE))
        return oit_i_fail(&oit->desc, OIT_TARGET_MULTISAMPLED, "oit_begin",
                          "frame.framebuffer is multisampled, for which OIT_FIELD_COVERAGE has to be chosen");
    if (oit->samples > OIT_MAX_SAMPLES)
        return oit_i_fail(&oit->desc, OIT_TARGET_MULTISAMPLED, "oit_begin",
                          "frame.framebuffer has more than OIT_MAX_SAMPLES samples");
    for (i = 0; i < oit->samples; ++i) {
        oit->gl.gl_GetMultisamplefv(OIT_I_GL_SAMPLE_POSITION, (oit_i_u)i, oit->positions[i]);
        for (k = 0; k < 2; ++k)
            oit->positions[i][k] -= 0.5f;
    }
    return OIT_OK;
}

static oit_result oit_i_check_target(oit_context *oit) {
    oit_result result = OIT_OK;
    if (oit->frame.depth != OIT_DEPTH_NONE)
        result = oit_i_check_framebuffer(oit, oit->frame.depth_framebuffer, "frame.depth_framebuffer");
    if (result == OIT_OK)
        result = oit_i_check_framebuffer(oit, oit->frame.framebuffer, "frame.framebuffer");
    return result == OIT_OK ? oit_i_find_samples(oit) : result;
}

static void oit_i_unit_vector(float out[4], const float in[3]) {
    double x = (double)in[0], y = (double)in[1], z = (double)in[2], length = sqrt(x * x + y * y + z * z);
    int i;
    for (i = 0; i < 3; ++i)
        out[i] = length > 0.0 ? (float)((double)in[i] / length) : 0.0f;
}

/* Which programs are drawn (bits of step[2]), the largest of them, and where each begins. */
static void oit_i_choose_programs(const oit_context *oit, oit_i_block *block) {
    int keeps = oit_i_keeps(&oit->desc);
    oit_i_u deepest = oit->desc.fit == OIT_FIT_WAIT && !keeps ? oit->deepest : oit->report.deepest, before = 0;
    uint64_t all = 0, waiting = 0;
    int i, last = 0;
    if (keeps && deepest > (oit_i_u)oit->layers)
        deepest = (oit_i_u)oit->layers;
    for (i = 0; i < OIT_I_CLASSES; ++i)
        all += oit->class_pixels[i];
    while (last < OIT_I_CLASSES - 2 && deepest > (oit_i_u)oit_i_class_sizes[last])
        ++last;
    for (i = 0; i <= last; ++i) {
        block->above[i] = before;
        waiting += oit->class_pixels[i];
        if (i < last && 8 * waiting < all)
            continue;
        block->step[2] |= 1u << i;
        before = (oit_i_u)oit_i_class_sizes[i];
        waiting = 0;
    }
    block->step[1] = before;
}

/* See oit_i_check_frame for what the threshold may be. */
static float oit_i_depth_limit(const oit_frame *frame) {
    if (frame->depth == OIT_DEPTH_THRESHOLD)
        return frame->depth_threshold;
    return frame->depth == OIT_DEPTH_FIRST ? 2.0f : 0.5f;
}

static oit_i_block oit_i_make_block(const oit_context *oit) {
    const oit_frame *frame = &oit->frame;
    float weight = frame->background_weight;
    int64_t pixels = (int64_t)frame->width * oit->slab_rows;
    oit_i_block block;
    memset(&block, 0, sizeof block);
    block.area[0] = frame->x;
    block.area[1] = frame->y + oit->slab_y;
    block.area[2] = frame->width;
    block.area[3] = oit->slab_rows;
    block.pool[0] = (oit_i_u)pixels;
    block.pool[1] = oit->part_start;
    block.pool[2] = oit->capacity;
    block.pool[3] = oit_i_blocks(pixels);
    block.step[0] = oit->slab_y == 0;
    block.step[3] = (oit_i_u)(oit_i_keeps(&oit->desc)              ? oit->layers
                              : oit->desc.store == OIT_STORE_FETCH ? (oit->desc.fit == OIT_FIT_ASYNC ? oit->fetches : 0)
                                                                   : oit->list->direct);
    oit_i_choose_programs(oit, &block);
    oit_i_unit_vector(block.light, frame->light);
    block.light[3] = weight == 0.0f ? 1.0f : weight < 0.0f ? 0.0f : weight > 1.0f ? 1.0f : weight;
    block.output[0] = oit_i_depth_limit(frame);
    block.part[0] = frame->x + oit->part[0];
    block.part[1] = frame->y + oit->slab_y + oit->part[1];
    block.part[2] = oit->part[2];
    block.part[3] = oit->part[3];
    block.samples[0] = (1u << (oit->samples > 1 ? oit->samples : 1)) - 1u;
    memcpy(block.positions, oit->positions, sizeof block.positions);
    return block;
}

/* Of whole pixels. */
static int oit_i_pixel_draws(const oit_context *oit) {
    int two = (oit->desc.fields & OIT_FIELD_BLEND) && !oit->has_dual;
    return (two ? 2 : 1) * (OIT_I_CLASSES + 1);
}

/* Into a multisampled target all are drawn once more, for pixels whose samples differ. */
static int oit_i_compose_draws(const oit_context *oit) {
    return (oit->samples > 1 ? 2 : 1) * oit_i_pixel_draws(oit);
}

static int oit_i_is_tail(int program) {
    return program >= OIT_I_PROGRAM_COMPOSE && program < OIT_I_PROGRAM_SAMPLED &&
           (program - OIT_I_PROGRAM_COMPOSE) % (OIT_I_CLASSES + 1) == OIT_I_CLASSES;
}

/* Whether the store has passes for that program. */
static int oit_i_has_program(const oit_desc *desc, int program) {
    int keeps = oit_i_keeps(desc);
    if (program >= OIT_I_PROGRAM_SUM && program <= OIT_I_PROGRAM_SPREAD)
        return !keeps;
    if (program == OIT_I_PROGRAM_KEEP)
        return keeps;
    if (program == OIT_I_PROGRAM_ARRANGE)
        return desc->store == OIT_STORE_BUCKETED;
    if (program == OIT_I_PROGRAM_PREDICT || program == OIT_I_PROGRAM_SETTLE)
        return desc->store == OIT_STORE_PREDICT;
    if (program == OIT_I_PROGRAM_FIRST || program == OIT_I_PROGRAM_LAY)
        return desc->store == OIT_STORE_FETCH;
    if (desc->store == OIT_STORE_FETCH && (program == OIT_I_PROGRAM_SPREAD || program == OIT_I_PROGRAM_COUNT ||
                                           (program >= OIT_I_PROGRAM_COMPOSE && !oit_i_is_tail(program))))
        return 0;
    if (program >= OIT_I_PROGRAM_SAMPLED && program < OIT_I_PROGRAM_PICK && !(desc->fields & OIT_FIELD_COVERAGE))
        return 0;
    if (oit_i_is_tail(program) && desc->store != OIT_STORE_FETCH && oit_i_tail_words(desc) == 0)
        return 0;
    return program != OIT_I_PROGRAM_GATHER || desc->store == OIT_STORE_LINKED;
}

/* Whether the frame has passes for it. */
static int oit_i_uses_program(const oit_context *oit, int program) {
    int draw = program - OIT_I_PROGRAM_COMPOSE, keeps = oit_i_keeps(&oit->desc);
    int sampled = program >= OIT_I_PROGRAM_SAMPLED;
    if (!oit_i_has_program(&oit->desc, program) || program >= OIT_I_PROGRAM_SORT) /* oit_run makes those */
        return 0;
    if (program == OIT_I_PROGRAM_DEPTH)
        return oit->frame.depth != OIT_DEPTH_NONE;
    if (sampled)
        draw = program - OIT_I_PROGRAM_SAMPLED;
    if (draw >= 0 && draw % (OIT_I_CLASSES + 1) == OIT_I_CLASSES) /* the tail */
        return (oit->desc.fit == OIT_FIT_ASYNC || keeps || oit->desc.store == OIT_STORE_FETCH) && !sampled;
    return draw < oit_i_pixel_draws(oit) && (!sampled || oit->samples > 1);
}

static oit_result oit_i_make_programs(oit_context *oit) {
    int i;
    oit_result result = OIT_OK;
    for (i = 0; i < OIT_I_PROGRAMS && result == OIT_OK; ++i)
        if (oit_i_uses_program(oit, i))
            result = oit_i_make_program(oit, i);
    return result;
}

/* ---- the steps of each store ---- */

/* The k nearest are chosen by their keys in a first geometry pass, and come in a second: with one, what a nearer fragment
   drives out would have to take its record along, and atomics of 32 bits move one word. */
static const oit_i_list oit_i_budget = {
    {OIT_I_STEP_CLEAR, OIT_I_STEP_COUNT, OIT_I_STEP_KEEP, OIT_I_STEP_FILL, OIT_I_STEP_FILLED}, OIT_I_STEP_FILL, 0};
static const oit_i_list oit_i_bucketed = {
    {OIT_I_STEP_CLEAR, OIT_I_STEP_COUNT, OIT_I_STEP_KEEP, OIT_I_STEP_FILL, OIT_I_STEP_ARRANGE, OIT_I_STEP_FILLED},
    OIT_I_STEP_FILL,
    0};

static const oit_i_list oit_i_exact = {{OIT_I_STEP_CLEAR, OIT_I_STEP_COUNT, OIT_I_STEP_SUM, OIT_I_STEP_TOPS,
                                        OIT_I_STEP_SPREAD, OIT_I_STEP_MEASURE, OIT_I_STEP_FILL, OIT_I_STEP_FILLED},
                                       OIT_I_STEP_FILL,
                                       0};

/* OIT_STORE_PREDICT: filled into runs of guessed lengths; counted first; filled again because something did not fit. */
static const oit_i_list oit_i_predicted = {{OIT_I_STEP_PREDICT, OIT_I_STEP_SUM, OIT_I_STEP_TOPS, OIT_I_STEP_SPREAD,
                                            OIT_I_STEP_FILL, OIT_I_STEP_SETTLE, OIT_I_STEP_CHECK, OIT_I_STEP_FILLED},
                                           OIT_I_STEP_FILL,
                                           1};
static const oit_i_list oit_i_counted = {{OIT_I_STEP_CLEAR, OIT_I_STEP_COUNT, OIT_I_STEP_SUM, OIT_I_STEP_TOPS,
                                          OIT_I_STEP_SPREAD, OIT_I_STEP_MEASURE, OIT_I_STEP_FILL, OIT_I_STEP_SETTLE,
                                          OIT_I_STEP_FILLED},
                                         OIT_I_STEP_FILL,
                                         0};
static const oit_i_list oit_i_refilled = {{OIT_I_STEP_PREDICT, OIT_I_STEP_SUM, OIT_I_STEP_TOPS, OIT_I_STEP_SPREAD,
                                           OIT_I_STEP_MEASURE, OIT_I_STEP_FILL, OIT_I_STEP_SETTLE, OIT_I_STEP_FILLED},
                                          OIT_I_STEP_FILL,
                                          0};

/* OIT_STORE_LINKED: filled, then counted and copied into runs; counted first, to know which pixels do not fit; filled again,
   the whole or a band, because the list was too small. */
static const oit_i_list oit_i_linked = {{OIT_I_STEP_CLEAR, OIT_I_STEP_FILL, OIT_I_STEP_SUM, OIT_I_STEP_TOPS,
                                         OIT_I_STEP_SPREAD, OIT_I_STEP_MEASURE, OIT_I_STEP_GATHER, OIT_I_STEP_FILLED},
                                        OIT_I_STEP_CLEAR,
                                        1};
static const oit_i_list oit_i_counted_and_linked = {{OIT_I_STEP_CLEAR, OIT_I_STEP_COUNT, OIT_I_STEP_SUM,
                                                     OIT_I_STEP_TOPS, OIT_I_STEP_SPREAD, OIT_I_STEP_FILL,
                                                     OIT_I_STEP_GATHER, OIT_I_STEP_FILLED},
                                                    OIT_I_STEP_CLEAR,
                                                    0};
static const oit_i_list oit_i_linked_again = {
    {OIT_I_STEP_CLEAR, OIT_I_STEP_FILL, OIT_I_STEP_GATHER, OIT_I_STEP_FILLED}, OIT_I_STEP_CLEAR, 2};

/* OIT_STORE_FETCH: the first geometry pass, after which it is known how deep the deepest pixel is; each other one. */
static const oit_i_list oit_i_fetched = {{OIT_I_STEP_FIRST, OIT_I_STEP_FILL, OIT_I_STEP_LAY, OIT_I_STEP_SUM,
                                          OIT_I_STEP_TOPS, OIT_I_STEP_CHECK, OIT_I_STEP_FILLED},
                                         OIT_I_STEP_FIRST,
                                         0};
static const oit_i_list oit_i_fetched_again = {
    {OIT_I_STEP_FILL, OIT_I_STEP_LAY, OIT_I_STEP_FILLED}, OIT_I_STEP_FILL, 0};

/* How many passes it takes to peel so many layers. */
static int oit_i_fetches(const oit_context *oit, oit_i_u deepest) {
    oit_i_u each = (oit_i_u)oit->fetched;
    return deepest > each ? (int)(deepest / each + (deepest % each != 0)) : 1;
}

/* The slab as one part. */
static void oit_i_whole_part(oit_context *oit) {
    oit->part[0] = oit->part[1] = 0;
    oit->part[2] = oit->frame.width;
    oit->part[3] = oit->slab_rows;
    oit->part_start = 0;
}

/* Whether the frame before was of this size, and of the same things. */
static int oit_i_continues(const oit_context *oit) {
    return !oit->frame.cut && oit->settled_width == oit->frame.width && oit->settled_height == oit->frame.height;
}

/* Whether the pixel buffer has counts to go by, and what they suggest may fit. */
static int oit_i_can_predict(const oit_context *oit) {
    oit_i_u most = (oit_i_u)(oit->desc.ceiling_bytes / oit_i_record_bytes(oit));
    return oit_i_continues(oit) && (oit->desc.fit == OIT_FIT_ASYNC || oit->places <= most);
}

/* Whether all may fit, or can be filled again if not. */
static int oit_i_can_link(const oit_context *oit) {
    return oit->desc.fit == OIT_FIT_WAIT ||
           (oit_i_continues(oit) && oit->report.frame > 0 && oit->places <= oit->capacity);
}

static void oit_i_start_slab(oit_context *oit) {
    oit->list = oit->desc.store == OIT_STORE_BUDGET     ? &oit_i_budget
                : oit->desc.store == OIT_STORE_BUCKETED ? &oit_i_bucketed
                                                        : &oit_i_exact;
    if (oit->desc.store == OIT_STORE_PREDICT)
        oit->list = oit_i_can_predict(oit) ? &oit_i_predicted : &oit_i_counted;
    if (oit->desc.store == OIT_STORE_LINKED)
        oit->list = oit_i_can_link(oit) ? &oit_i_linked : &oit_i_counted_and_linked;
    if (oit->desc.store == OIT_STORE_FETCH) {
        oit->list = &oit_i_fetched;
        oit->fetch = 1;
        oit->fetches = oit->desc.fit == OIT_FIT_ASYNC ? oit_i_fetches(oit, oit->report.deepest) : 0;
    }
    oit->settled_width = 0;
    oit->step = (oit_i_step)oit->list->steps[0];
    oit_i_whole_part(oit);
}

/* All that a frame needs; in a steady one nothing is missing, and the block is the same. */
static oit_result oit_i_prepare(oit_context *oit) {
    oit_i_block block;
    int32_t bound = oit_i_borrow_target(oit);
    oit_result result;
    int news;
    oit_i_take_reports(oit, 0);
    news = oit->news;
    oit->news = 0;
    result = oit_i_make_programs(oit);
    if (result == OIT_OK && !oit->vertex_array)
        oit->gl.gl_GenVertexArrays(1, &oit->vertex_array);
    if (result == OIT_OK && !oit->vertex_array)
        result = oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_begin", "no vertex array");
    if (result == OIT_OK)
        result = oit_i_make_buffers(oit);
    if (result == OIT_OK && !oit_i_keeps(&oit->desc) && oit->desc.store != OIT_STORE_FETCH &&
        (oit->desc.fit == OIT_FIT_ASYNC ? news : oit->desc.store != OIT_STORE_EXACT) &&
        oit_i_capacity_is_wrong(oit, oit->places))
        result = oit_i_set_capacity(oit, oit_i_with_quarter(oit->places), "oit_begin");
    if (result == OIT_OK && oit_i_operates(&oit->desc) && oit->desc.state == OIT_STATE_NONE)
        result = oit_i_make_surfaces(oit, "oit_begin");
    if (result == OIT_OK) {
        oit_i_start_slab(oit);
        block = oit_i_make_block(oit);
        result = oit_i_upload_block(oit, &block);
    }
    oit_i_return_target(oit, bound);
    return result;
}

static int oit_i_free_slot(oit_context *oit) {
    int slot = (int)(oit->frame_number % OIT_I_REPORTS);
    if (oit->fences[slot] && oit->desc.fit == OIT_FIT_WAIT)
        oit_i_take_reports(oit, 1);
    return oit->fences[slot] ? -1 : slot;
}

OIT_I_API oit_result oit_begin(oit_context *oit, const oit_frame *frame) {
    oit_result result;
    if (!oit || !frame)
        return OIT_INVALID_ARGUMENT;
    if (oit->in_frame)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_begin", "inside of a frame");
    result = oit_i_check_frame(oit, frame);
    if (result != OIT_OK)
        return result;
    oit->frame = *frame;
    oit->slab_y = 0;
    oit->slab_rows = oit->rows;
    oit->part_start = 0;
    oit->failure = OIT_OK;
    oit->saved_state = 0;
    oit->slot = -1;
    oit->bands = 0;
    oit->did = 0;
    oit->step = OIT_I_STEP_DONE;
    if (frame->width && frame->height) {
        if (oit->desc.state != OIT_STATE_NONE) {
            oit_i_save(oit, &oit->saved);
            oit->saved_state = 1;
            result = oit_i_check_target(oit);
        }
        oit_i_whole_part(oit);
        if (result == OIT_OK)
            result = oit_i_prepare(oit);
        if (result != OIT_OK) {
            if (oit->saved_state)
                oit_i_restore(oit, &oit->saved);
            return result;
        }
        ++oit->frame_number;
        oit->slot = oit_i_free_slot(oit);
    }
    oit->in_frame = 1;
    return OIT_OK;
}

/* What writes a buffer before a pass, and what the pass does with it; everything is incoherent to GL, so each step takes
   a barrier of shader storage before it:

     pass     reads and writes                        after
     clear    pixels: counts, totals      written     compose and report of the frame or slab before, which read them
     count    pixels: counts              atomics     clear
     sum      pixels: counts read; sums   written     count
     tops     pixels: sums                both        sum
     spread   pixels: sums, counts read; starts written (and the tail cleared)   tops
     report   pixels: totals read; report written     spread (totals), fill and compose (extra, at the end)
     fill     pixels: starts read, counts atomics; fragments written             spread; compose of the band before
     pick     pixels, fragments           read; one of the buffers for picks written   fill
     compose  pixels, fragments           read        fill; settle (how many came, the tail)
     depth    pixels, fragments           read        fill
     predict  pixels: own words, counts read; starts, totals, tail written    settle and report of the frame before
     settle   pixels: starts, counts read; own words, totals, tail written; fragments read    fill
     lay      pixels: laid words both, counts and totals written    fill; lay of the pass before. Layers lie in attachments,
              which the extension keeps in order
     gather   pixels: starts, own words read, counts and tail written; list read; fragments written    spread, fill, and
              compose of the frame or band before
   With OIT_STORE_LINKED fill writes the list in the place of the fragments, and clear what gather of the band before has
   read.

   Of the stores that keep the k nearest:

     clear    as above, and keys, limits, tail   written
     count    pixels: counts, keys, limits       atomics, keys and limits also read   clear
     keep     pixels: counts, keys read; starts, limits, left, totals written         count
     fill     pixels: starts, limits read; left, tail atomics; fragments written      keep
     arrange  pixels: starts, left read; keys, buckets both; fragments read           fill (bucketed)
     compose  pixels, fragments read                                                  fill, arrange

   Of operators, all on the buffer of the surfaces (each pass writes and reads it); pixels (starts, left) and fragments are
   read by all. Every pass of an operator has a barrier before it, the first because of fill (or gather, settle, arrange):

     sort     order written
     group    order read; grouped written               sort
     connect  order, grouped read; links written        sort, group
     mutual   links both, in place: see the shader      connect
     law      order, links, reach read; base written    sort, mutual, solve
     bound    order, links read; reach, beta, gamma written               mutual
     size     links, reach read; sizes both, in place: only distances that have come for certain are used     bound
     solve    links read; reach both, in place: see the shader; one field to spare      bound, law, solve
     jump     links read; reach both, in place: stretches side by side take turns; what has changed in spare     bound, jump
     chain    links, base or radial read; spare written, which then is that       law, curve, chain
     curve    order, links read; kappa, base, radial written              mutual
     host     anything read; base and fields of the own pixel, or spare, written      any of these
     compose  order, links, base, reach, sizes, beta, gamma, kappa, radial read
                                                     any of these; and the next frame's clear and fill

   What the CPU maps (report; starts, to cut bands) takes a barrier of buffer updates, and then its fence, or waits. */
static oit_i_u oit_i_barrier_before(oit_pass_kind kind) {
    switch (kind) {
    case OIT_PASS_CLEAR:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_COUNT:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_SUM:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_TOPS:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_SPREAD:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_REPORT:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_FILL:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_PREDICT:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_SETTLE:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_GATHER:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_LAY:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_KEEP:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_ARRANGE:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_PICK:
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    case OIT_PASS_DEPTH: /* compose, which always draws something, has waited for the same */
        return 0;
    default: /* compose; its draws only read, so once before the first */
        return OIT_I_GL_SHADER_STORAGE_BARRIER;
    }
}

static int oit_i_is_hosts(oit_pass_kind kind) {
    return kind == OIT_PASS_COUNT || kind == OIT_PASS_FILL;
}

static int oit_i_is_lit(const oit_context *oit) {
    return oit->block.light[0] != 0.0f || oit->block.light[1] != 0.0f || oit->block.light[2] != 0.0f;
}

/* Whether that draw of the composition is the one by what operators have made, which stands for the programs of all
   depths. */
static int oit_i_lays(const oit_context *oit, int draw) {
    oit_i_u made = OIT_I_DID_BASE | OIT_I_DID_SMART | OIT_I_DID_SHADE | OIT_I_DID_CONTOUR;
    return (oit->did & made) && draw % (OIT_I_CLASSES + 1) == 0;
}

static int oit_i_program_of(const oit_context *oit, oit_pass_kind kind) {
    switch (kind) {
    case OIT_PASS_CLEAR:
        return OIT_I_PROGRAM_CLEAR;
    case OIT_PASS_COUNT:
        return OIT_I_PROGRAM_COUNT;
    case OIT_PASS_SUM:
        return OIT_I_PROGRAM_SUM;
    case OIT_PASS_TOPS:
        return OIT_I_PROGRAM_TOPS;
    case OIT_PASS_SPREAD:
        return OIT_I_PROGRAM_SPREAD;
    case OIT_PASS_REPORT:
        return OIT_I_PROGRAM_REPORT;
    case OIT_PASS_PREDICT:
        return OIT_I_PROGRAM_PREDICT;
    case OIT_PASS_SETTLE:
        return OIT_I_PROGRAM_SETTLE;
    case OIT_PASS_GATHER:
        return OIT_I_PROGRAM_GATHER;
    case OIT_PASS_LAY:
        return oit->step == OIT_I_STEP_FIRST ? OIT_I_PROGRAM_FIRST : OIT_I_PROGRAM_LAY;
    case OIT_PASS_KEEP:
        return OIT_I_PROGRAM_KEEP;
    case OIT_PASS_ARRANGE:
        return OIT_I_PROGRAM_ARRANGE;
    case OIT_PASS_FILL:
        return oit_i_is_lit(oit) ? OIT_I_PROGRAM_FILL_LIT : OIT_I_PROGRAM_FILL;
    case OIT_PASS_PICK:
        return OIT_I_PROGRAM_PICK;
    case OIT_PASS_DEPTH:
        return OIT_I_PROGRAM_DEPTH;
    default:
        if (oit_i_lays(oit, oit->compose_index))
            return oit->compose_index == 0 ? OIT_I_PROGRAM_LAID : OIT_I_PROGRAM_LAID_LIGHT;
        return oit->compose_index < oit_i_pixel_draws(oit)
                   ? OIT_I_PROGRAM_COMPOSE + oit->compose_index
                   : OIT_I_PROGRAM_SAMPLED + oit->compose_index - oit_i_pixel_draws(oit);
    }
}

/* ---- passes of operators ---- */

/* Distance along the view of a window depth z is (out[0] + out[1] z) / (out[2] + out[3] z): clip z and w are
   p[10] e + p[14] and p[11] e + p[15] of the eye's z, e. */
static void oit_i_distance_terms(const oit_frame *frame, int zero_to_one, double out[4]) {
    const float *p = frame->projection;
    double scale = zero_to_one ? 1.0 : 2.0, offset = zero_to_one ? 0.0 : -1.0;
    out[0] = offset * (double)p[15] - (double)p[14];
    out[1] = scale * (double)p[15];
    out[2] = offset * (double)p[11] - (double)p[10];
    out[3] = scale * (double)p[11];
}

/* oit_set[4 ... 6] of shaders/oit_operator.glsl. */
static void oit_i_operator_view(const oit_context *oit, float set[8][4]) {
    const float *p = oit->frame.projection;
    double terms[4];
    int i;
    oit_i_distance_terms(&oit->frame, oit->frame.zero_to_one, terms);
    for (i = 0; i < 4; ++i)
        set[4][i] = (float)terms[i];
    set[5][0] = (float)(1.0 / (double)p[0]);
    set[5][1] = (float)(1.0 / (double)p[5]);
    set[5][2] = (float)((double)p[8] / (double)p[0]);
    set[5][3] = (float)((double)p[9] / (double)p[5]);
    set[6][0] = p[11];
    set[6][1] = p[15];
    set[6][2] = (float)((double)p[12] / (double)p[0]);
    set[6][3] = (float)((double)p[13] / (double)p[5]);
}

/* ---- what is asked for: defaults, and what cannot be ---- */

static float oit_i_or(float x, float standard) {
    return x == 0.0f ? standard : x < 0.0f ? 0.0f : x;
}

static oit_link oit_i_resolve_link(oit_link link) {
    if (link.depth_weight == 0.0f && link.normal_weight == 0.0f)
        link.depth_weight = link.normal_weight = 0.5f;
    link.radius = oit_i_or(link.radius, 1.0f);
    link.limit = link.limit == 0.0f ? 0.04f : link.limit;
    if (link.criterion != OIT_LINK_DEPTH && link.search == OIT_SEARCH_WINDOWED)
        link.search = OIT_SEARCH_BRUTE;
    return link;
}

static oit_spread oit_i_resolve_spread(oit_spread spread, float lambda, oit_process process) {
    spread.iterations = spread.iterations == 0 ? 20 : spread.iterations < 0 ? 0 : spread.iterations;
    spread.lambda = oit_i_or(spread.lambda, lambda);
    if (spread.process == OIT_PROCESS_DEFAULT)
        spread.process = process;
    spread.p = oit_i_or(spread.p, spread.profile == OIT_PROFILE_11 ? 0.3f : 3.0f);
    return spread;
}

static oit_smart oit_i_resolve_smart(oit_smart smart) {
    smart.base = oit_i_resolve_spread(smart.base, 1.0f, OIT_PROCESS_DIFFUSION);
    smart.beta = oit_i_resolve_spread(smart.beta, 0.05f, OIT_PROCESS_GREATEST);
    smart.gamma = oit_i_resolve_spread(smart.gamma, 0.1f, OIT_PROCESS_GREATEST);
    if (smart.published)
        smart.jumps = 0;
    return smart;
}

static oit_law oit_i_resolve_law(oit_law law) {
    law.s = oit_i_or(law.s, 0.3f);
    law.exponent = oit_i_or(law.exponent, 1.0f);
    law.scale = oit_i_or(law.scale, 4.0f);
    law.reach = oit_i_or(law.reach, 20.0f);
    return law;
}

static const char *oit_i_bad_link(const oit_context *oit, const oit_link *link) {
    if ((unsigned)link->criterion > (unsigned)OIT_LINK_MURRAY || (unsigned)link->search > (unsigned)OIT_SEARCH_BUCKETS)
        return "link.criterion or link.search is none of its enumerators";
    if (!oit_i_all_finite(&link->depth_weight, 4))
        return "a number of link is not finite";
    if (link->depth_weight < 0.0f || link->normal_weight < 0.0f || link->radius < 0.0f)
        return "a weight or the radius of link is negative";
    if (link->criterion == OIT_LINK_UV && !(oit->desc.fields & OIT_FIELD_UV))
        return "OIT_LINK_UV compares what OIT_FIELD_UV stores, which is not chosen";
    if (link->search == OIT_SEARCH_BUCKETS && !(oit->desc.operators & OIT_OPERATE_BUCKETS))
        return "OIT_SEARCH_BUCKETS needs OIT_OPERATE_BUCKETS in desc.operators";
    return 0;
}

static const char *oit_i_bad_law(const oit_context *oit, const oit_law *law) {
    if ((unsigned)law->kind > (unsigned)OIT_LAW_DISTANCE)
        return "law.kind is none of its enumerators";
    if (!oit_i_all_finite(&law->s, 4) || law->s > 1.0f)
        return "a number of law is not finite, or law.s is above 1";
    if ((law->kind == OIT_LAW_ANGLE) && !(oit->desc.fields & OIT_FIELD_NORMAL))
        return "OIT_LAW_ANGLE needs OIT_FIELD_NORMAL";
    return 0;
}

static const char *oit_i_bad_spread(const oit_context *oit, const oit_spread *spread, int base) {
    if ((unsigned)spread->process > (unsigned)OIT_PROCESS_GREATEST ||
        (unsigned)spread->profile > (unsigned)OIT_PROFILE_11)
        return "process or profile of a field of smart is none of its enumerators";
    if (spread->iterations > 65533)
        return "iterations of a field of smart are more than 65533";
    if (!oit_i_all_finite(&spread->lambda, 1) || spread->lambda > 1.0f || !oit_i_all_finite(&spread->p, 1))
        return "lambda of a field of smart is above 1, or a number is not finite";
    if (base && spread->process == OIT_PROCESS_GREATEST)
        return "base spreads by diffusion alone";
    if (!base && spread->process == OIT_PROCESS_DIFFUSION && !(oit->desc.operators & OIT_OPERATE_DIFFUSION))
        return "diffusion of beta or gamma needs OIT_OPERATE_DIFFUSION in desc.operators";
    return 0;
}

static const char *oit_i_bad_smart(const oit_context *oit, const oit_smart *smart) {
    const char *bad = oit_i_bad_spread(oit, &smart->base, 1);
    if (!bad)
        bad = oit_i_bad_spread(oit, &smart->beta, 0);
    if (!bad)
        bad = oit_i_bad_spread(oit, &smart->gamma, 0);
    if (!bad && (!oit_i_all_finite(&smart->thin, 1) || smart->thin < 0.0f || smart->rounds < 0))
        bad = "smart.thin or smart.rounds is negative or not finite";
    if (!bad && smart->thin > 0.0f && !(oit->desc.operators & OIT_OPERATE_THIN))
        bad = "smart.thin needs OIT_OPERATE_THIN in desc.operators";
    return bad;
}

static const char *oit_i_bad_contours(const oit_context *oit, const oit_curvature *curvature) {
    if ((unsigned)curvature->contours > (unsigned)OIT_CONTOURS_SUGGESTIVE)
        return "curvature.contours is none of its enumerators";
    if (curvature->contours == OIT_CONTOURS_NONE)
        return 0;
    if (!(oit->desc.operators & OIT_OPERATE_CONTOURS))
        return "curvature.contours needs OIT_OPERATE_CONTOURS in desc.operators";
    if (curvature->contour_iterations > 65533)
        return "curvature.contour_iterations are more than 65533";
    if (!oit_i_all_finite(&curvature->contour_width, 1) || curvature->contour_width < 0.0f ||
        !oit_i_all_finite(&curvature->contour_least, 1) || !oit_i_all_finite(curvature->contour_color, 3))
        return "a number of curvature.contour_* is not finite, or curvature.contour_width is negative";
    return 0;
}

static const char *oit_i_bad_curvature(const oit_context *oit, const oit_curvature *curvature) {
    const float numbers[3] = {curvature->unit, curvature->first, curvature->last};
    if ((unsigned)curvature->shade > (unsigned)OIT_SHADE_CURVED ||
        (unsigned)curvature->opacity > (unsigned)OIT_OPACITY_DEEP)
        return "curvature.shade or curvature.opacity is none of its enumerators";
    if (!oit_i_all_finite(numbers, 3) || curvature->unit < 0.0f)
        return "a number of curvature is not finite, or curvature.unit is negative";
    if (curvature->shades && !oit_i_all_finite(curvature->shades, 3 * OIT_TRANSFER_SHADES))
        return "a number of curvature.shades is not finite";
    if (curvature->opacities && !oit_i_all_finite(curvature->opacities, OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS))
        return "a number of curvature.opacities is not finite";
    return oit_i_bad_contours(oit, curvature);
}

static const char *oit_i_bad_host(const oit_context *oit, const oit_host_operator *host) {
    if (host->program == 0 || host->iterations < 0)
        return "host.program is missing, or host.iterations is negative";
    if (host->iterations == 0)
        return 0;
    if (!oit->sections[OIT_I_AT_SPARE])
        return "host.iterations need OIT_OPERATE_LOCAL in desc.operators";
    if (host->value == OIT_VALUE_BASE)
        return oit->sections[OIT_I_AT_BASE] ? 0 : "host.value is OIT_VALUE_BASE, which needs OIT_OPERATE_LAW";
    if (host->value < OIT_VALUE_HOST || host->value >= OIT_VALUE_HOST + oit->desc.operator_fields)
        return "host.value is neither OIT_VALUE_BASE nor one of desc.operator_fields";
    return 0;
}

static const char *oit_i_bad_operator(const oit_context *oit, const oit_operator *op) {
    static const oit_i_u needs[5] = {OIT_OPERATE_LINKS, OIT_OPERATE_LAW, OIT_OPERATE_SMART, OIT_OPERATE_CURVATURE, 0};
    const float *p = oit->frame.projection;
    if ((unsigned)op->kind > (unsigned)OIT_RUN_HOST)
        return "kind is none of its enumerators";
    if ((oit->desc.operators & needs[op->kind]) != needs[op->kind] || !oit_i_operates(&oit->desc))
        return "the operator is not one of desc.operators";
    if (!oit_i_all_finite(p, 16) || p[0] == 0.0f || p[5] == 0.0f || (p[11] == 0.0f && p[15] == 0.0f))
        return "frame.projection is missing, or no projection";
    switch (op->kind) {
    case OIT_RUN_LINK:
        return oit_i_bad_link(oit, &op->link);
    case OIT_RUN_LAW:
        return oit_i_bad_law(oit, &op->law);
    case OIT_RUN_SMART:
        return oit_i_bad_smart(oit, &op->smart);
    case OIT_RUN_CURVATURE:
        return oit_i_bad_curvature(oit, &op->curvature);
    default:
        return oit_i_bad_host(oit, &op->host);
    }
}

/* What has to be run before it, by name; NULL: nothing is missing. */
static const char *oit_i_missing_run(const oit_context *oit, const oit_operator *op) {
    int law = op->kind == OIT_RUN_LAW ? (int)op->law.kind : -1;
    int links = op->kind == OIT_RUN_SMART || op->kind == OIT_RUN_CURVATURE || law == (int)OIT_LAW_VARIATION;
    if (links && !(oit->did & OIT_I_DID_LINK))
        return "OIT_RUN_LINK comes before it";
    if (law == (int)OIT_LAW_DISTANCE && !(oit->did & OIT_I_DID_SMART))
        return "OIT_LAW_DISTANCE takes the distances of OIT_RUN_SMART, which comes before it";
    return 0;
}

/* ---- passes of an operator ---- */

static void oit_i_add_stage(oit_context *oit, int program, int what, int count) {
    oit_i_stage *stage = &oit->stages[oit->stage_count];
    if (count <= 0)
        return;
    stage->program = program;
    stage->what = what;
    stage->count = count;
    ++oit->stage_count;
}

/* 0 where neither is by equation 9. */
static int oit_i_greatest_steps(const oit_smart *smart) {
    int beta = smart->beta.process == OIT_PROCESS_GREATEST ? smart->beta.iterations : 0;
    int gamma = smart->gamma.process == OIT_PROCESS_GREATEST ? smart->gamma.iterations : 0;
    return beta > gamma ? beta : gamma;
}

/* Iterations of equation 8 that one pair of passes along rows and columns stands for: few, because along rows and then
   along columns is not quite both at a time. Pairs take turns in which comes first, so that errors of the order cancel, and
   what one ends with and the next begins with is one pass. */
#define OIT_I_CHAIN_STEPS 7
#define OIT_I_JUMP_REACH 32
#define OIT_I_JUMP_BENDS 2

/* Passes along rows and columns in turn that measure the surface's width, as far as smart.thin may matter. */
static int oit_i_size_passes(const oit_smart *smart) {
    int steps = oit_i_greatest_steps(smart), rounds = 1;
    double widest = smart->thin > 0.0f ? (double)steps / (double)smart->thin : 0.0;
    while (rounds < 64 && (double)(OIT_I_JUMP_REACH * rounds) < widest)
        ++rounds;
    return 2 * (rounds + 1); /* the first of each axis forgets */
}

static int oit_i_jump_rounds(const oit_smart *smart, int steps) {
    int borders =
        (steps + OIT_I_JUMP_REACH - 1) / OIT_I_JUMP_REACH; /* of stretches; a round passes two, the first one */
    int straight = 1 + (borders + 1) / 2;
    if (steps == 0)
        return 0;
    if (smart->until_stable)
        return steps; /* each round is worth an iteration at least */
    return smart->rounds ? smart->rounds : straight + OIT_I_JUMP_BENDS;
}

/* Whether what a fragment is linked to is linked back to it. Chains are followed only then. */
static int oit_i_links_are_mutual(const oit_context *oit) {
    return !oit->link.no_reverse_check && oit->link.criterion != OIT_LINK_PUBLISHED;
}

/* So many iterations of equation 8 without a mask; chains are followed only where links are mutual. */
static void oit_i_add_smoothing(oit_context *oit, int section, int iterations) {
    if (!oit_i_links_are_mutual(oit))
        oit_i_add_stage(oit, OIT_I_PROGRAM_SOLVE, section, iterations);
    else if (iterations > 0)
        oit_i_add_stage(oit, OIT_I_PROGRAM_CHAIN, section,
                        (iterations + OIT_I_CHAIN_STEPS - 1) / OIT_I_CHAIN_STEPS + 1);
}

static void oit_i_plan_smart(oit_context *oit) {
    const oit_smart *smart = &oit->smart;
    int greatest = oit_i_greatest_steps(smart), base = smart->base.iterations;
    if (!(oit->did & OIT_I_DID_BASE))
        oit_i_add_stage(oit, OIT_I_PROGRAM_LAW, OIT_LAW_GIVEN, 1);
    oit_i_add_stage(oit, OIT_I_PROGRAM_BOUND, 0, 1);
    if (smart->thin > 0.0f)
        oit_i_add_stage(oit, OIT_I_PROGRAM_SIZE, 0, oit_i_size_passes(smart));
    if (smart->jumps) {
        oit_i_add_stage(oit, OIT_I_PROGRAM_JUMP, 0, 4 * oit_i_jump_rounds(smart, greatest));
        oit_i_add_smoothing(oit, OIT_I_AT_BASE, base);
    } else {
        oit_i_add_stage(oit, OIT_I_PROGRAM_SOLVE, OIT_I_AT_BASE, greatest > base ? greatest : base);
    }
    if (smart->beta.process == OIT_PROCESS_DIFFUSION)
        oit_i_add_stage(oit, OIT_I_PROGRAM_SOLVE, OIT_I_AT_BETA, smart->beta.iterations);
    if (smart->gamma.process == OIT_PROCESS_DIFFUSION)
        oit_i_add_stage(oit, OIT_I_PROGRAM_SOLVE, OIT_I_AT_GAMMA, smart->gamma.iterations);
}

static int oit_i_host_makes_base(const oit_context *oit, const oit_operator *op) {
    return op->host.value == (int)OIT_VALUE_BASE && oit->sections[OIT_I_AT_BASE] != 0;
}

static void oit_i_plan(oit_context *oit, const oit_operator *op) {
    oit->stage_count = oit->stage = oit->stage_step = 0;
    if (!(oit->did & OIT_I_DID_SORT))
        oit_i_add_stage(oit, OIT_I_PROGRAM_SORT, 0, 1);
    if (op->kind == OIT_RUN_LINK) {
        if (oit->link.search == OIT_SEARCH_BUCKETS)
            oit_i_add_stage(oit, OIT_I_PROGRAM_GROUP, 0, 1);
        if (oit->link.search == OIT_SEARCH_WINDOWED)
            oit_i_add_stage(oit, OIT_I_PROGRAM_WINDOW, 0, 1);
        else
            oit_i_add_stage(oit, OIT_I_PROGRAM_CONNECT, 0,
                            4); /* a direction each: drivers end loops of too many rounds */
        if (oit_i_links_are_mutual(oit))
            oit_i_add_stage(oit, OIT_I_PROGRAM_MUTUAL, 0, 1);
    } else if (op->kind == OIT_RUN_LAW) {
        oit_i_add_stage(oit, OIT_I_PROGRAM_LAW, (int)op->law.kind, 1);
    } else if (op->kind == OIT_RUN_SMART) {
        oit_i_plan_smart(oit);
    } else if (op->kind == OIT_RUN_CURVATURE) {
        if (oit->curvature_base && !(oit->did & OIT_I_DID_BASE)) /* of what is no surface, too */
            oit_i_add_stage(oit, OIT_I_PROGRAM_LAW, OIT_LAW_GIVEN, 1);
        oit_i_add_stage(oit, OIT_I_PROGRAM_CURVE, 0, 1);
        if (oit->curvature.contours != OIT_CONTOURS_NONE)
            oit_i_add_smoothing(oit, OIT_I_AT_RADIAL, oit->curvature.contour_iterations);
    } else {
        if (oit_i_host_makes_base(oit, op) && !(oit->did & OIT_I_DID_BASE))
            oit_i_add_stage(oit, OIT_I_PROGRAM_LAW, OIT_LAW_GIVEN, 1);
        oit_i_add_stage(oit, OIT_I_PROGRAM_HOST, op->host.iterations > 0,
                        op->host.iterations ? op->host.iterations : 1);
    }
}

/* ---- numbers of a pass: oit_at and oit_set of shaders/oit_operator.glsl ---- */

typedef struct oit_i_numbers {
    oit_i_u at[6][4];
    float set[8][4];
} oit_i_numbers;

/* Weights of the fragments that 0, 1, ... links lead to, after so many steps of equation 8 along one axis: a walk that goes
   a link each way with probability `weight` in each. What lies beyond seven links is shared out. */
static void oit_i_chain_weights(int steps, double weight, float out[8]) {
    double w[33], next[32], sum = 0.0;
    int i, k;
    memset(w, 0, sizeof w);
    w[0] = 1.0;
    for (i = 0; i < steps; ++i) {
        for (k = 0; k < 32; ++k)
            next[k] = w[k] + weight * (w[k ? k - 1 : 1] - 2.0 * w[k] + w[k + 1]);
        memcpy(w, next, sizeof next);
    }
    for (k = 0; k < 8; ++k)
        sum += (k ? 2.0 : 1.0) * w[k];
    for (k = 0; k < 8; ++k)
        out[k] = (float)(w[k] / sum);
}

/* Iterations of base that the k-th of the pairs of passes stands for: as even as may be. */
static int oit_i_chain_steps(int iterations, int pairs, int k) {
    return k >= 0 && k < pairs ? iterations / pairs + (k < iterations % pairs) : 0;
}

static void oit_i_number_connect(const oit_context *oit, int step, oit_i_numbers *n) {
    const oit_link *link = &oit->link;
    float infinite = (float)(1e300 * 1e300);
    double t[4];
    n->at[4][0] = (oit_i_u)step;
    n->at[4][2] = (oit_i_u)link->criterion;
    n->at[4][3] = (link->count_pairs ? 1u : 0u) | (link->search == OIT_SEARCH_BUCKETS ? 2u : 0u);
    n->set[0][0] = link->depth_weight;
    n->set[0][1] = link->normal_weight;
    n->set[0][2] = 1.0f / link->radius;
    n->set[0][3] = link->limit < 0.0f || link->criterion == OIT_LINK_PUBLISHED ? infinite : link->limit;
    n->set[1][0] = link->no_reverse_check ? 1.0f : 0.0f;
    oit_i_distance_terms(&oit->frame, oit->frame.zero_to_one, t);
    n->set[1][1] = (t[1] * t[2] < t[0] * t[3]) == !oit->desc.reversed_z ? -1.0f : 1.0f;
}

static void oit_i_number_solve(const oit_context *oit, const oit_i_stage *stage, int step, oit_i_numbers *n) {
    const oit_smart *smart = &oit->smart;
    const oit_spread *spread = stage->what == OIT_I_AT_BASE   ? &smart->base
                               : stage->what == OIT_I_AT_BETA ? &smart->beta
                                                              : &smart->gamma;
    int is_radial = stage->what == OIT_I_AT_RADIAL;
    n->at[2][0] = oit->sections[stage->what];
    n->at[2][1] = oit->sections[OIT_I_AT_SPARE];
    n->at[4][0] = stage->what == OIT_I_AT_BASE && !smart->jumps && step < oit_i_greatest_steps(smart);
    n->at[4][1] = is_radial || step < spread->iterations;
    n->at[4][2] = stage->what == OIT_I_AT_BETA ? 1u : stage->what == OIT_I_AT_GAMMA ? 2u : 0u;
    n->set[0][0] = is_radial ? 0.125f : spread->lambda * (smart->published ? 0.25f : 0.125f);
}

static void oit_i_number_chain(const oit_context *oit, const oit_i_stage *stage, int step, oit_i_numbers *n) {
    int is_base = stage->what == OIT_I_AT_BASE, pairs = stage->count - 1;
    int all = is_base ? oit->smart.base.iterations : oit->curvature.contour_iterations;
    int steps = oit_i_chain_steps(all, pairs, step - 1) + oit_i_chain_steps(all, pairs, step);
    double lambda = is_base ? (double)oit->smart.base.lambda : 1.0;
    float weights[8];
    n->at[2][0] = oit->sections[stage->what];
    n->at[2][1] = oit->sections[OIT_I_AT_SPARE];
    n->at[4][0] = (oit_i_u)step & 1u;
    oit_i_chain_weights(steps, 0.125 * lambda, weights);
    memcpy(n->set, weights, sizeof weights);
}

/* Depths 0 and 1 where the host gives none: those of the window. An infinite far plane is taken as 16 times the near. */
static void oit_i_depth_range(const oit_context *oit, double *first, double *last) {
    double t[4], ends[2];
    int i;
    *first = (double)oit->curvature.first;
    *last = (double)oit->curvature.last;
    if (*first != 0.0 || *last != 0.0)
        return;
    oit_i_distance_terms(&oit->frame, oit->frame.zero_to_one, t);
    for (i = 0; i < 2; ++i) {
        double z = (i == 1) == !oit->desc.reversed_z ? 1.0 : 0.0, below = t[2] + t[3] * z;
        ends[i] = below != 0.0 ? (t[0] + t[1] * z) / below : 0.0;
    }
    *first = ends[0];
    *last = ends[1] > ends[0] && ends[1] < 1e30 ? ends[1] : 16.0 * ends[0];
}

static void oit_i_number_curve(const oit_context *oit, oit_i_numbers *n) {
    double first, last;
    oit_i_depth_range(oit, &first, &last);
    n->at[4][0] = oit->curvature_base != 0;
    n->at[4][1] = oit->curvature.contours != OIT_CONTOURS_NONE;
    n->set[0][0] = oit->curvature.unit > 0.0f ? 1.0f / oit->curvature.unit : 0.0f;
    n->set[0][1] = (float)first;
    n->set[0][2] = last != first ? (float)(1.0 / (last - first)) : 0.0f;
    n->set[1][2] = 1.0f / oit->link.radius;
}

/* Lengths in radii of the link. */
static void oit_i_number_contours(const oit_context *oit, oit_i_numbers *n) {
    const oit_curvature *curvature = &oit->curvature;
    float least = oit_i_or(curvature->contour_least, 1.0f);
    n->set[1][0] = 0.5f * oit_i_or(curvature->contour_width, 1.5f) + 0.5f;
    n->set[1][1] = 1.0f / (least > 1e-30f ? least : 1e-30f);
    n->set[1][2] = 1.0f / oit->link.radius;
    memcpy(n->set[2], curvature->contour_color, sizeof curvature->contour_color);
}

static void oit_i_number_compose(const oit_context *oit, oit_i_numbers *n) {
    const oit_smart *smart = &oit->smart;
    int is_smart = (oit->did & OIT_I_DID_SMART) != 0;
    n->at[4][0] = ((oit->did & OIT_I_DID_BASE) ? 1u : 0u) | (is_smart ? 2u : 0u) |
                  ((oit->did & OIT_I_DID_SHADE) ? 4u : 0u) | (is_smart && smart->published ? 8u : 0u) |
                  ((oit->did & OIT_I_DID_CONTOUR) ? 16u : 0u);
    oit_i_number_contours(oit, n);
    n->at[4][1] = (oit_i_u)smart->beta.profile;
    n->at[4][2] = (oit_i_u)smart->gamma.profile;
    n->set[0][0] = smart->beta.p;
    n->set[0][1] = smart->gamma.p;
}

/* What oit_value needs for beta and gamma. */
static void oit_i_number_values(const oit_context *oit, oit_i_numbers *n) {
    const oit_smart *smart = &oit->smart;
    n->at[5][0] = (oit_i_u)smart->beta.iterations;
    n->at[5][1] = (oit_i_u)smart->gamma.iterations;
    n->set[7][0] = smart->beta.lambda;
    n->set[7][1] = smart->gamma.lambda;
    n->set[7][2] = smart->thin;
    n->set[7][3] = (float)(OIT_I_JUMP_REACH * (oit_i_size_passes(smart) / 2 - 1));
}

static void oit_i_number_sections(const oit_context *oit, oit_i_numbers *n) {
    static const unsigned char places[3][4] = {
        {OIT_I_AT_ORDER, OIT_I_AT_LINKS, OIT_I_AT_LINKS_HIGH, OIT_I_AT_REACH},
        {OIT_I_AT_BASE, OIT_I_AT_KAPPA, OIT_I_AT_BETA, OIT_I_AT_GAMMA},
        {OIT_I_SECTIONS, OIT_I_SECTIONS, OIT_I_AT_SIZES, OIT_I_AT_GROUPED},
    };
    int i, k;
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 4; ++k)
            n->at[i][k] = places[i][k] < OIT_I_SECTIONS ? oit->sections[places[i][k]] : 0u;
    for (i = 0; i < OIT_MAX_OPERATOR_FIELDS; ++i)
        n->at[3][i] = oit->sections[OIT_I_AT_HOST + i];
    if (oit->smart.beta.process != OIT_PROCESS_DIFFUSION) /* its distances say it */
        n->at[1][2] = 0u;
    if (oit->smart.gamma.process != OIT_PROCESS_DIFFUSION)
        n->at[1][3] = 0u;
    n->at[5][2] = oit->sections[OIT_I_AT_SIZES_HIGH];
    n->at[5][3] = oit->sections[OIT_I_AT_RADIAL];
}

/* A word for each 32 x 32 pixels, in the section to spare, which jumps have no other use for; 0: it is too short, or links
   are not mutual: once to and fro is not all then that a stretch can do by itself. */
static oit_i_u oit_i_tiles(const oit_context *oit) {
    int64_t across = (oit->frame.width + OIT_I_JUMP_REACH - 1) / OIT_I_JUMP_REACH;
    int64_t tiles = across * ((oit->frame.height + OIT_I_JUMP_REACH - 1) / OIT_I_JUMP_REACH);
    return oit_i_links_are_mutual(oit) && tiles <= (int64_t)oit->capacity ? oit->sections[OIT_I_AT_SPARE] : 0u;
}

static void oit_i_number_stage(const oit_context *oit, const oit_i_stage *stage, int step, oit_i_numbers *n) {
    const oit_law *law = &oit->law;
    switch (stage->program) {
    case OIT_I_PROGRAM_CONNECT:
    case OIT_I_PROGRAM_WINDOW:
        oit_i_number_connect(oit, step, n);
        break;
    case OIT_I_PROGRAM_LAW:
        n->at[4][0] = (oit_i_u)stage->what;
        n->at[4][1] = (oit_i_u)oit_i_greatest_steps(&oit->smart);
        n->set[0][0] = law->s;
        n->set[0][1] = law->exponent;
        n->set[0][2] = law->scale;
        n->set[0][3] = law->reach;
        break;
    case OIT_I_PROGRAM_BOUND:
        n->at[4][0] = oit->smart.published != 0;
        n->at[4][1] = oit->smart.published && oit->smart.beta.process == OIT_PROCESS_GREATEST;
        n->at[4][2] = oit_i_tiles(oit);
        break;
    case OIT_I_PROGRAM_SIZE:
        n->at[4][0] = (oit_i_u)step & 1u;
        n->at[4][1] = step < 2;
        break;
    case OIT_I_PROGRAM_SOLVE:
        oit_i_number_solve(oit, stage, step, n);
        break;
    case OIT_I_PROGRAM_JUMP:
        n->at[4][0] = (oit_i_u)step >> 1 & 1u;
        n->at[4][1] = (oit_i_u)step;
        n->at[4][2] = (oit_i_u)step & 1u;
        n->at[4][3] = oit_i_tiles(oit);
        break;
    case OIT_I_PROGRAM_CHAIN:
        oit_i_number_chain(oit, stage, step, n);
        break;
    case OIT_I_PROGRAM_CURVE:
        oit_i_number_curve(oit, n);
        break;
    case OIT_I_PROGRAM_HOST:
        n->at[2][0] = stage->what ? oit->sections[oit->host_section] : 0u;
        n->at[2][1] = stage->what ? oit->sections[OIT_I_AT_SPARE] : 0u;
        n->at[4][0] = (oit_i_u)step;
        break;
    default:
        break;
    }
}

/* The numbers of the next pass into its program. No state of the context changes; names in the text have these locations. */
static void oit_i_send_numbers(const oit_context *oit, oit_i_u program, const oit_i_numbers *n) {
    oit->gl.gl_ProgramUniform4uiv(program, 0, 6, &n->at[0][0]);
    oit->gl.gl_ProgramUniform4fv(program, 8, 8, &n->set[0][0]);
}

static void oit_i_begin_numbers(const oit_context *oit, oit_i_numbers *n) {
    memset(n, 0, sizeof *n);
    oit_i_number_sections(oit, n);
    oit_i_number_values(oit, n);
    oit_i_operator_view(oit, n->set);
}

/* The pass of the present stage: its program, groups, and the buffer of the surfaces in the place of the report. */
static void oit_i_fill_operation(const oit_context *oit, oit_state *state) {
    const oit_i_stage *stage = &oit->stages[oit->stage];
    int along = oit_i_goes_along(stage->program), column;
    int size[2], i;
    oit_i_numbers numbers;
    oit_i_begin_numbers(oit, &numbers);
    oit_i_number_stage(oit, stage, oit->stage_step, &numbers);
    state->program = stage->program == OIT_I_PROGRAM_HOST ? oit->host_program : oit->programs[stage->program];
    state->storage_buffers[2] = oit->buffers[OIT_I_SURFACE];
    column = along && numbers.at[4][0] != 0;
    size[0] = along && !column ? oit->frame.height : oit->frame.width;
    size[1] = along && !column ? oit->frame.width : oit->frame.height;
    if (along) /* across x, along y, so that few columns of a narrow image leave no work items idle */
        size[1] = (size[1] + OIT_I_JUMP_REACH - 1) / OIT_I_JUMP_REACH;
    if (stage->program == OIT_I_PROGRAM_JUMP) /* every second */
        size[1] = (size[1] + 1) / 2;
    for (i = 0; i < 2; ++i)
        state->groups[i] = (oit_i_u)((size[i] + 7) / 8);
    state->groups[2] = 1;
    oit_i_send_numbers(oit, state->program, &numbers);
    if (stage->program == OIT_I_PROGRAM_CURVE)
        oit->gl.gl_ProgramUniform4uiv(state->program, 16, OIT_I_OPACITY_WORDS / 4, oit->opacities);
}

/* Composition by what the operators have made. */
static void oit_i_fill_laid(const oit_context *oit, oit_state *state) {
    oit_i_numbers numbers;
    oit_i_begin_numbers(oit, &numbers);
    oit_i_number_compose(oit, &numbers);
    state->storage_buffers[2] = oit->buffers[OIT_I_SURFACE];
    oit_i_send_numbers(oit, state->program, &numbers);
    oit->gl.gl_ProgramUniform4fv(state->program, 16, OIT_TRANSFER_SHADES, &oit->shades[0][0]);
}

static void oit_i_swap_sections(oit_context *oit, int a, int b) {
    oit_i_u kept = oit->sections[a];
    oit->sections[a] = oit->sections[b];
    oit->sections[b] = kept;
}

/* After a pass: what has gone to the spare section is now the field. */
static void oit_i_advance_operation(oit_context *oit) {
    const oit_i_stage *stage = &oit->stages[oit->stage];
    int step = oit->stage_step;
    if (stage->program == OIT_I_PROGRAM_CHAIN || (stage->program == OIT_I_PROGRAM_HOST && stage->what))
        oit_i_swap_sections(oit, stage->program == OIT_I_PROGRAM_CHAIN ? stage->what : oit->host_section,
                            OIT_I_AT_SPARE);
    else if (stage->program == OIT_I_PROGRAM_SOLVE &&
             (stage->what != OIT_I_AT_BASE || step < oit->smart.base.iterations))
        oit_i_swap_sections(oit, stage->what, OIT_I_AT_SPARE);
    if (++oit->stage_step < stage->count)
        return;
    oit->stage_step = 0;
    if (++oit->stage == oit->stage_count)
        oit->step = OIT_I_STEP_FILLED;
}

/* ---- transfer functions (Murray 2016, section 5.2) ---- */

static float oit_i_shade_preset(oit_shade shade, float kappa) {
    if (shade == OIT_SHADE_CONVEX)
        return 1.0f - 0.5f * kappa;
    return shade == OIT_SHADE_CURVED ? 0.5f + (kappa < 0.0f ? -kappa : kappa) : 1.0f;
}

static float oit_i_opacity_preset(oit_opacity opacity, float curvature, float depth) {
    float through = 0.95f * (1.0f - curvature) * (1.0f - depth);
    return opacity == OIT_OPACITY_FRONT ? 1.0f - through * (1.0f - depth) * (1.0f - depth) * (1.0f - depth)
                                        : 1.0f - through;
}

static void oit_i_take_shades(oit_context *oit, const oit_curvature *curvature) {
    int i, k;
    for (i = 0; i < OIT_TRANSFER_SHADES; ++i)
        for (k = 0; k < 3; ++k)
            oit->shades[i][k] =
                curvature->shades
                    ? curvature->shades[3 * i + k]
                    : oit_i_shade_preset(curvature->shade, -1.0f + 2.0f * (float)i / (OIT_TRANSFER_SHADES - 1));
}

static void oit_i_take_opacities(oit_context *oit, const oit_curvature *curvature) {
    int i, k;
    memset(oit->opacities, 0, sizeof oit->opacities);
    for (i = 0; i < OIT_TRANSFER_DEPTHS; ++i)
        for (k = 0; k < OIT_TRANSFER_CURVATURES; ++k) {
            int at = i * OIT_TRANSFER_CURVATURES + k;
            float x = curvature->opacities
                          ? curvature->opacities[at]
                          : oit_i_opacity_preset(curvature->opacity, (float)k / (OIT_TRANSFER_CURVATURES - 1),
                                                 (float)i / (OIT_TRANSFER_DEPTHS - 1));
            x = x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
            oit->opacities[at / 2] |= (oit_i_u)(x * 65535.0f + 0.5f) << (16 * (at & 1));
        }
}

/* ---- passes ---- */

static void oit_i_fill_groups(const oit_context *oit, oit_pass_kind kind, oit_state *state) {
    oit_i_u blocks = oit->block.pool[3];
    state->groups[0] = state->groups[1] = state->groups[2] = 1;
    /* A dimension has at least 65,535 groups everywhere. */
    if (kind != OIT_PASS_TOPS && kind != OIT_PASS_REPORT && kind != OIT_PASS_PICK && blocks > 1) {
        state->groups[0] = blocks < 32768u ? blocks : 32768u;
        state->groups[1] = (blocks + state->groups[0] - 1) / state->groups[0];
    }
}

static void oit_i_fill_blend(const oit_context *oit, oit_state *state) {
    state->color_write = 1;
    state->blend = 1;
    state->blend_source = OIT_I_GL_ONE;
    state->blend_destination = OIT_I_GL_SRC_ALPHA;
    if (!(oit->desc.fields & OIT_FIELD_BLEND))
        return;
    if (oit->has_dual) {
        state->blend_destination = OIT_I_GL_SRC1_COLOR;
    } else if (oit->compose_index % oit_i_pixel_draws(oit) <= OIT_I_CLASSES) {
        state->blend_source = OIT_I_GL_ZERO;
        state->blend_destination = OIT_I_GL_SRC_COLOR;
    } else {
        state->blend_destination = OIT_I_GL_ONE;
    }
}

static void oit_i_fill_pass(const oit_context *oit, oit_pass_kind kind, oit_pass *pass) {
    oit_state *state = &pass->state;
    const int *part = oit->part;
    int compose = kind == OIT_PASS_COMPOSE, depth = kind == OIT_PASS_DEPTH, lay = kind == OIT_PASS_LAY, i;
    int fetch = lay || (kind == OIT_PASS_FILL && oit->desc.store == OIT_STORE_FETCH);
    memset(pass, 0, sizeof *pass);
    pass->kind = kind;
    pass->name = oit_pass_kind_name(kind);
    if (!compose || !oit->composes) /* once before the first that is drawn */
        pass->barriers = oit_i_barrier_before(kind);
    state->program = oit->programs[oit_i_program_of(oit, kind)];
    for (i = 0; i < 2; ++i)
        state->storage_buffers[i] = oit->buffers[OIT_I_PIXELS + i];
    state->storage_buffers[2] = oit->slot >= 0 ? oit->buffers[OIT_I_REPORT + oit->slot] : 0;
    if (oit->desc.store == OIT_STORE_LINKED && (kind == OIT_PASS_FILL || kind == OIT_PASS_GATHER))
        state->storage_buffers[kind == OIT_PASS_FILL ? 1 : 2] = oit->buffers[OIT_I_LIST];
    state->first_storage_binding = oit->desc.first_storage_binding;
    state->uniform_buffer = oit->buffers[OIT_I_UNIFORMS];
    state->uniform_binding = oit->desc.uniform_binding;
    state->blend_source = OIT_I_GL_ONE;
    state->depth_func = oit->desc.reversed_z ? OIT_I_GL_GREATER : OIT_I_GL_LESS;
    if (!oit_i_is_hosts(kind) && !compose && !depth && !lay) {
        if (kind == OIT_PASS_PICK)
            state->storage_buffers[2] = oit->buffers[OIT_I_PICKED + oit->pick];
        if (kind == OIT_PASS_OPERATE)
            oit_i_fill_operation(oit, state);
        else
            oit_i_fill_groups(oit, kind, state);
        return;
    }
    state->framebuffer = depth ? oit->frame.depth_framebuffer : fetch ? oit->fetch_framebuffer : oit->frame.framebuffer;
    state->viewport[0] = oit->frame.x;
    state->viewport[1] = oit->frame.y;
    state->viewport[2] = oit->frame.width;
    state->viewport[3] = oit->frame.height;
    state->scissor[0] = oit->frame.x + (kind == OIT_PASS_COUNT ? 0 : part[0]);
    state->scissor[1] = oit->frame.y + oit->slab_y + (kind == OIT_PASS_COUNT ? 0 : part[1]);
    state->scissor[2] = kind == OIT_PASS_COUNT ? oit->frame.width : part[2];
    state->scissor[3] = kind == OIT_PASS_COUNT ? oit->slab_rows : part[3];
    state->depth_test = !compose && !lay;
    state->color_write = fetch ? 2 : 0;
    if (depth) {
        state->depth_func = OIT_I_GL_ALWAYS;
        state->color_write = oit->frame.depth_to_color != 0;
        state->depth_write = !state->color_write;
    }
    if (compose)
        oit_i_fill_blend(oit, state);
    if (compose && oit_i_lays(oit, oit->compose_index))
        oit_i_fill_laid(oit, state);
    if (compose || depth || lay) {
        state->vertex_array = oit->vertex_array;
        state->vertex_count = 3;
    }
}

/* Dispatches, or draws the triangle; the host's vertex array stays bound for its own draws. */
static void oit_i_execute(const oit_context *oit, const oit_state *state) {
    int32_t vertex_array = 0;
    if (state->groups[0]) {
        oit->gl.gl_DispatchCompute(state->groups[0], state->groups[1], state->groups[2]);
        return;
    }
    oit->gl.gl_GetIntegerv(OIT_I_GL_VERTEX_ARRAY_BINDING, &vertex_array);
    oit->gl.gl_BindVertexArray(state->vertex_array);
    oit->gl.gl_DrawArrays(OIT_I_GL_TRIANGLES, 0, state->vertex_count);
    oit->gl.gl_BindVertexArray((oit_i_u)vertex_array);
}

/* ---- picking ---------------------------------------------------------------------------------------------------- */

static int oit_i_is_inside(int x, int y, int left, int bottom, int width, int height) {
    return x >= left && y >= bottom && x - left < width && y - bottom < height;
}

/* One that is asked for in the part that is stored now; -1: none. */
static int oit_i_next_pick(const oit_context *oit) {
    const int *part = oit->part;
    int i;
    for (i = 0; i < OIT_MAX_PICKS; ++i)
        if (oit->picks[i].state == OIT_I_PICK_ASKED &&
            oit_i_is_inside(oit->picks[i].x, oit->picks[i].y, oit->frame.x + part[0],
                            oit->frame.y + oit->slab_y + part[1], part[2], part[3]))
            return i;
    return -1;
}

/* The end of a frame: fences behind what the GPU will know; what lies outside of the viewport is known now. */
static void oit_i_end_picks(oit_context *oit) {
    const oit_frame *frame = &oit->frame;
    int i, barrier = 0;
    for (i = 0; i < OIT_MAX_PICKS; ++i) {
        oit_i_pick_slot *pick = &oit->picks[i];
        if (pick->state == OIT_I_PICK_RUNS && pick->frame == oit->frame_number && !pick->fence) {
            if (!barrier++)
                oit->gl.gl_MemoryBarrier(OIT_I_GL_BUFFER_UPDATE_BARRIER);
            pick->fence = oit->gl.gl_FenceSync(OIT_I_GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            if (!pick->fence) /* the next frame answers */
                pick->state = OIT_I_PICK_ASKED;
        }
        if (pick->state == OIT_I_PICK_ASKED && oit->step == OIT_I_STEP_DONE &&
            !oit_i_is_inside(pick->x, pick->y, frame->x, frame->y, frame->width, frame->height)) {
            pick->state = OIT_I_PICK_OUTSIDE;
            pick->frame = oit->frame_number;
        }
    }
}

static oit_result oit_i_ask(oit_context *oit, int slot) {
    const oit_i_pick_slot *pick = &oit->picks[slot];
    int index = OIT_I_PICKED + slot;
    oit_i_u words[3];
    if (!oit->sizes[index] && !oit_i_resize(oit, index, 4 * OIT_I_PICK_WORDS, OIT_I_GL_DYNAMIC_READ))
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_pick_begin", "no memory for the answer");
    words[0] = (oit_i_u)pick->x;
    words[1] = (oit_i_u)pick->y;
    words[2] = (oit_i_u)pick->layer;
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, oit->buffers[index]);
    oit->gl.gl_BufferSubData(OIT_I_GL_COPY_WRITE_BUFFER, 0, (ptrdiff_t)sizeof words, words);
    return OIT_OK;
}

OIT_I_API oit_result oit_pick_begin(oit_context *oit, int x, int y, int layer) {
    oit_result result;
    int32_t bound;
    int slot = 0;
    if (!oit)
        return OIT_INVALID_ARGUMENT;
    if (oit->desc.store == OIT_STORE_FETCH)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_pick_begin", "OIT_STORE_FETCH keeps no layers");
    if (layer < 0)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_pick_begin", "layer is negative");
    while (slot < OIT_MAX_PICKS && oit->picks[slot].state != OIT_I_PICK_FREE)
        ++slot;
    if (slot == OIT_MAX_PICKS)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_pick_begin", "OIT_MAX_PICKS are under way");
    result = oit_i_make_program(oit, OIT_I_PROGRAM_PICK);
    if (result != OIT_OK)
        return result;
    oit->picks[slot].x = x;
    oit->picks[slot].y = y;
    oit->picks[slot].layer = layer;
    bound = oit_i_borrow_target(oit);
    result = oit_i_ask(oit, slot);
    oit_i_return_target(oit, bound);
    if (result != OIT_OK)
        return result;
    oit->picks[slot].turn = ++oit->pick_turns;
    oit->picks[slot].state = OIT_I_PICK_ASKED;
    return OIT_OK;
}

static float oit_i_as_float(oit_i_u bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static float oit_i_half(oit_i_u bits) {
    int exponent = (int)(bits >> 10 & 31u), mantissa = (int)(bits & 1023u);
    double x = exponent ? ldexp(1024.0 + mantissa, exponent - 25) : ldexp((double)mantissa, -24);
    return (float)(bits & 0x8000u ? -x : x);
}

static void oit_i_read_color(const oit_desc *desc, const oit_i_u *words, oit_pick *pick) {
    int i;
    for (i = 0; i < 4; ++i) {
        if (desc->color == OIT_COLOR_FLOAT)
            pick->color[i] = oit_i_as_float(words[i]);
        else if (desc->color == OIT_COLOR_HALF)
            pick->color[i] = oit_i_half(words[i / 2] >> 16 * (i % 2) & 0xffffu);
        else
            pick->color[i] = i < 3 ? (float)(words[0] >> 10 * i & 1023u) / 1023.0f : oit_i_as_float(words[1]);
    }
}

/* Out of oit_pack_normal. */
static void oit_i_read_normal(oit_i_u word, float normal[3]) {
    double x[2], z, length;
    int i;
    for (i = 0; i < 2; ++i) {
        int bits = (int)(word >> 16 * i & 0xffffu);
        x[i] = (bits > 32767 ? bits - 65536 : bits) / 32767.0;
        x[i] = x[i] < -1.0 ? -1.0 : x[i];
    }
    z = 1.0 - fabs(x[0]) - fabs(x[1]);
    if (z < 0.0) {
        double folded = (1.0 - fabs(x[1])) * (x[0] < 0.0 ? -1.0 : 1.0);
        x[1] = (1.0 - fabs(x[0])) * (x[1] < 0.0 ? -1.0 : 1.0);
        x[0] = folded;
    }
    length = sqrt(x[0] * x[0] + x[1] * x[1] + z * z);
    normal[0] = (float)(x[0] / length);
    normal[1] = (float)(x[1] / length);
    normal[2] = (float)(z / length);
}

static void oit_i_read_record(const oit_desc *desc, const oit_i_u *words, oit_pick *pick) {
    oit_i_record at = oit_i_layout(desc);
    int i;
    pick->depth = oit_i_as_float(desc->reversed_z ? 0x7fffffffu - words[0] : words[0]);
    oit_i_read_color(desc, words + at.color, pick);
    if (at.part)
        pick->part = words[at.part];
    if (at.key)
        pick->key = words[at.key];
    if (desc->fields & OIT_FIELD_BLEND)
        pick->blend = at.blend ? words[at.blend] & 255u : words[at.color] >> 30;
    if (at.normal)
        oit_i_read_normal(words[at.normal], pick->normal);
    for (i = 0; i < 2 && at.uv; ++i)
        pick->uv[i] = oit_i_as_float(words[at.uv + i]);
    if (at.coverage)
        pick->coverage = words[at.coverage] >> at.coverage_shift;
    for (i = 0; i < desc->host_words; ++i)
        pick->words[i] = words[at.host + i];
}

/* The slot's fence has passed. The target must be borrowed. */
static oit_result oit_i_read_pick(oit_context *oit, int slot, oit_pick *pick) {
    const void *mapped;
    oit_i_u words[OIT_I_PICK_WORDS];
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, oit->buffers[OIT_I_PICKED + slot]);
    mapped = oit->gl.gl_MapBufferRange(OIT_I_GL_COPY_WRITE_BUFFER, 0, (ptrdiff_t)sizeof words, OIT_I_GL_MAP_READ_BIT);
    if (!mapped)
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_pick_result", "the answer cannot be mapped");
    memcpy(words, mapped, sizeof words);
    oit->gl.gl_UnmapBuffer(OIT_I_GL_COPY_WRITE_BUFFER);
    pick->layers = words[3];
    pick->found = words[4] == 1u;
    if (pick->found)
        oit_i_read_record(&oit->desc, words + 5, pick);
    return OIT_OK;
}

OIT_I_API oit_result oit_pick_result(oit_context *oit, int wait, oit_pick *pick) {
    oit_result result = OIT_OK;
    oit_i_pick_slot *first = 0;
    int32_t bound;
    int i;
    if (!oit || !pick)
        return OIT_INVALID_ARGUMENT;
    for (i = 0; i < OIT_MAX_PICKS; ++i)
        if (oit->picks[i].state != OIT_I_PICK_FREE && (!first || oit->picks[i].turn < first->turn))
            first = &oit->picks[i];
    if (!first)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_pick_result", "none is under way");
    if (first->state != OIT_I_PICK_OUTSIDE && !first->fence)
        return wait ? oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_pick_result", "no frame that answers has ended")
                    : OIT_NOT_READY;
    if (first->fence && !oit_i_fence_passed(oit, first->fence, wait))
        return OIT_NOT_READY;
    memset(pick, 0, sizeof *pick);
    pick->x = first->x;
    pick->y = first->y;
    pick->layer = first->layer;
    pick->frame = first->frame;
    if (first->fence) {
        bound = oit_i_borrow_target(oit);
        result = oit_i_read_pick(oit, (int)(first - oit->picks), pick);
        oit_i_return_target(oit, bound);
        oit->gl.gl_DeleteSync(first->fence);
    }
    memset(first, 0, sizeof *first);
    return result;
}

/* ---- the steps of a frame ---------------------------------------------------------------------------------------- */

static int oit_i_part_end(const oit_context *oit) {
    return oit->part[1] * oit->frame.width + oit->part[0] + (oit->part[3] - 1) * oit->frame.width + oit->part[2];
}

/* The band from pixel `first` on: as many whole rows as the pool holds, or as much of one row. starts[2 i] is where the
   run of pixel first + i starts. */
static oit_result oit_i_cut(oit_context *oit, const oit_i_u *starts, int first) {
    int width = oit->frame.width, left = width * oit->slab_rows - first, x = first % width, rows = 0, columns = 0;
    while (x == 0 && (rows + 1) * width <= left && starts[2 * (rows + 1) * width] - starts[0] <= oit->capacity)
        ++rows;
    while (rows == 0 && x + columns < width && starts[2 * (columns + 1)] - starts[0] <= oit->capacity)
        ++columns;
    if (rows == 0 && columns == 0)
        return oit_i_fail(&oit->desc, OIT_PIXEL_TOO_DEEP, "oit_next_pass", oit_result_string(OIT_PIXEL_TOO_DEEP));
    oit->part[0] = x;
    oit->part[1] = first / width;
    oit->part[2] = rows ? width : columns;
    oit->part[3] = rows ? rows : 1;
    oit->part_start = starts[0];
    return OIT_OK;
}

/* OIT_FIT_WAIT, and the slab needs more than the pool holds. */
static oit_result oit_i_next_band(oit_context *oit, int first) {
    ptrdiff_t offset = 4 * (OIT_I_HEADER_WORDS + 2 * (ptrdiff_t)first);
    ptrdiff_t length = 8 * ((ptrdiff_t)oit->frame.width * oit->slab_rows - first) + 4;
    const void *mapped;
    oit_result result;
    oit->gl.gl_MemoryBarrier(OIT_I_GL_BUFFER_UPDATE_BARRIER);
    oit->gl.gl_BindBuffer(OIT_I_GL_COPY_WRITE_BUFFER, oit->buffers[OIT_I_PIXELS]);
    mapped = oit->gl.gl_MapBufferRange(OIT_I_GL_COPY_WRITE_BUFFER, offset, length, OIT_I_GL_MAP_READ_BIT);
    if (!mapped)
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_next_pass", "the pixels cannot be mapped");
    result = oit_i_cut(oit, (const oit_i_u *)mapped, first);
    oit->gl.gl_UnmapBuffer(OIT_I_GL_COPY_WRITE_BUFFER);
    return result;
}

/* OIT_FIT_WAIT: what is filled next, the whole slab, or a band of it. */
static oit_result oit_i_next_part(oit_context *oit, int first) {
    oit_i_block block;
    oit_result result = OIT_OK;
    int32_t bound;
    oit_i_whole_part(oit);
    bound = oit_i_borrow_target(oit);
    if (oit->needed > oit->capacity)
        result = oit_i_next_band(oit, first);
    block = oit_i_make_block(oit);
    if (result == OIT_OK)
        result = oit_i_upload_block(oit, &block);
    oit_i_return_target(oit, bound);
    return result;
}

/* The target must be borrowed. */
static oit_result oit_i_read_measure(oit_context *oit, oit_i_u totals[OIT_I_HEADER_WORDS]) {
    oit->gl.gl_MemoryBarrier(OIT_I_GL_BUFFER_UPDATE_BARRIER);
    if (!oit_i_read_totals(oit, oit->slot, totals))
        return oit_i_fail(&oit->desc, OIT_OUT_OF_MEMORY, "oit_next_pass", "the report cannot be mapped");
    oit->deepest = totals[1];
    memcpy(oit->class_pixels, totals + 8, sizeof oit->class_pixels);
    return OIT_OK;
}

/* Lists that fit stay as they are: they hold what has been drawn. */
static oit_result oit_i_fit_pool(oit_context *oit) {
    if (oit->list == &oit_i_linked && oit->needed <= oit->capacity)
        return OIT_OK;
    if (oit->list == &oit_i_linked) {
        oit->list = &oit_i_linked_again;
        oit->step = (oit_i_step)oit->list->steps[0];
    }
    return oit_i_capacity_is_wrong(oit, oit->needed)
               ? oit_i_set_capacity(oit, oit_i_with_quarter(oit->needed), "oit_next_pass")
               : OIT_OK;
}

/* OIT_FIT_WAIT: how much the slab needs is read, and the pool made to hold it if that may be. */
static oit_result oit_i_measure(oit_context *oit) {
    oit_i_u totals[OIT_I_HEADER_WORDS];
    int32_t bound = oit_i_borrow_target(oit);
    oit_result result = oit_i_read_measure(oit, totals);
    if (result == OIT_OK && totals[5] == 0xffffffffu)
        result = oit_i_fail(&oit->desc, OIT_TOO_LARGE, "oit_next_pass", "2^32 fragments or more");
    if (result == OIT_OK) {
        oit->needed = totals[5];
        if (oit->list != &oit_i_refilled)
            oit_i_note_places(oit, totals, 0);
        result = oit_i_fit_pool(oit);
    }
    oit_i_return_target(oit, bound);
    return result;
}

/* OIT_FIT_WAIT, and runs were guessed: where something did not fit, all is filled again, from the counts. */
static oit_result oit_i_check_fit(oit_context *oit) {
    oit_i_u totals[OIT_I_HEADER_WORDS];
    int32_t bound = oit_i_borrow_target(oit);
    oit_result result = oit_i_read_measure(oit, totals);
    oit_i_return_target(oit, bound);
    oit->needed = 0; /* the pool is large enough for what it holds */
    if (result != OIT_OK)
        return result;
    if (oit->desc.store == OIT_STORE_FETCH)
        oit->fetches = oit_i_fetches(oit, totals[1]);
    oit_i_note_places(oit, totals, 1);
    if (totals[2] > 0 && oit->desc.store == OIT_STORE_PREDICT) {
        oit->list = &oit_i_refilled;
        oit->step = (oit_i_step)oit->list->steps[0];
    }
    return OIT_OK;
}

static oit_result oit_i_next_slab(oit_context *oit) {
    oit_i_block block;
    int32_t bound = oit_i_borrow_target(oit);
    oit_result result;
    oit->slab_y += oit->slab_rows;
    oit->slab_rows = oit->frame.height - oit->slab_y < oit->rows ? oit->frame.height - oit->slab_y : oit->rows;
    oit_i_start_slab(oit);
    block = oit_i_make_block(oit);
    result = oit_i_upload_block(oit, &block);
    oit_i_return_target(oit, bound);
    return result;
}

static int oit_i_is_last_part(const oit_context *oit) {
    return oit_i_part_end(oit) == oit->frame.width * oit->slab_rows &&
           oit->slab_y + oit->slab_rows == oit->frame.height;
}

static int oit_i_is_whole(const oit_context *oit) {
    return oit->part[0] == 0 && oit->part[1] == 0 && oit_i_is_last_part(oit) && oit->slab_y == 0;
}

/* A program is drawn where it serves an eighth of the pixels or more, and that of the deepest ones; the pixels of one that
   is not fall to the next. What is deeper than was known falls to the last, so that a wrong guess costs only time. */
static int oit_i_is_needed(const oit_context *oit, int draw) {
    int index = draw % (OIT_I_CLASSES + 1), deep = index == OIT_I_CLASSES - 1, wait = oit->desc.fit == OIT_FIT_WAIT;
    if (index < OIT_I_CLASSES && oit_i_lays(oit, 0))
        return index == 0;
    if (oit->desc.store == OIT_STORE_FETCH)
        return index == OIT_I_CLASSES;
    if (oit_i_keeps(&oit->desc) && deep)
        return (oit_i_u)oit->layers > oit->block.step[1];
    if (oit_i_keeps(&oit->desc) && index == OIT_I_CLASSES)
        return 1;
    if (index == OIT_I_CLASSES && draw >= oit_i_pixel_draws(oit))
        return 0;
    if (index == OIT_I_CLASSES || deep)
        return !wait || (deep && oit->deepest > oit->block.step[1]);
    return (oit->block.step[2] >> index) & 1u;
}

static void oit_i_skip_draws(oit_context *oit) {
    while (oit->compose_index < oit_i_compose_draws(oit) && !oit_i_is_needed(oit, oit->compose_index))
        ++oit->compose_index;
}

/* What there is none of: picks in this part, draws, a depth. */
static void oit_i_skip_steps(oit_context *oit) {
    if (oit->step == OIT_I_STEP_PICK) {
        oit->pick = oit_i_next_pick(oit);
        if (oit->pick < 0)
            oit->step = OIT_I_STEP_COMPOSE;
    }
    if (oit->step == OIT_I_STEP_COMPOSE) {
        oit_i_skip_draws(oit);
        if (oit->compose_index == oit_i_compose_draws(oit))
            oit->step = oit->frame.depth != OIT_DEPTH_NONE ? OIT_I_STEP_DEPTH : OIT_I_STEP_COMPOSED;
    }
}

static void oit_i_start_composing(oit_context *oit) {
    oit->step = OIT_I_STEP_PICK;
    oit->compose_index = 0;
    oit->composes = 0;
}

/* After the last draw of a part. */
static oit_result oit_i_after_part(oit_context *oit) {
    if (oit_i_is_last_part(oit)) {
        oit->step = oit->slot >= 0 ? OIT_I_STEP_REPORT : OIT_I_STEP_DONE;
        return OIT_OK;
    }
    if (oit_i_part_end(oit) < oit->frame.width * oit->slab_rows) {
        oit->step = oit->list->part_start;
        return oit_i_next_part(oit, oit_i_part_end(oit));
    }
    return oit_i_next_slab(oit);
}

/* The pass of the present step. Returns 0 where there is none. */
static int oit_i_kind_of_step(const oit_context *oit, oit_pass_kind *kind) {
    static const oit_pass_kind kinds[OIT_I_STEP_DONE] = {
        OIT_PASS_CLEAR,   OIT_PASS_COUNT,  OIT_PASS_SUM,     OIT_PASS_TOPS,    OIT_PASS_SPREAD, OIT_PASS_REPORT,
        OIT_PASS_PREDICT, OIT_PASS_SETTLE, OIT_PASS_GATHER,  OIT_PASS_LAY,     OIT_PASS_LAY,    OIT_PASS_REPORT,
        OIT_PASS_FILL,    OIT_PASS_FILL,   OIT_PASS_PICK,    OIT_PASS_COMPOSE, OIT_PASS_DEPTH,  OIT_PASS_DEPTH,
        OIT_PASS_REPORT,  OIT_PASS_KEEP,   OIT_PASS_ARRANGE, OIT_PASS_OPERATE};
    if (oit->step == OIT_I_STEP_FILLED || oit->step == OIT_I_STEP_DONE)
        return 0;
    *kind = kinds[(int)oit->step];
    return 1;
}

static int oit_i_has_step(const oit_context *oit, oit_i_step step) {
    if (step == OIT_I_STEP_MEASURE || step == OIT_I_STEP_CHECK)
        return oit->desc.fit == OIT_FIT_WAIT;
    /* Settled when the last band of the slab is filled: those before need the counts as they are. */
    return step != OIT_I_STEP_SETTLE || oit_i_part_end(oit) == oit->frame.width * oit->slab_rows;
}

/* OIT_STORE_FETCH: another pass, if there are layers left. */
static void oit_i_fetch_more(oit_context *oit) {
    if (oit->desc.store != OIT_STORE_FETCH || oit->fetch >= oit->fetches)
        return;
    ++oit->fetch;
    oit->list = &oit_i_fetched_again;
    oit->step = (oit_i_step)oit->list->steps[0];
}

/* After the present step's pass. */
static void oit_i_advance(oit_context *oit) {
    const unsigned char *at = oit->list->steps;
    if (oit->step == OIT_I_STEP_PICK) {
        oit->picks[oit->pick].state = OIT_I_PICK_RUNS;
        oit->picks[oit->pick].frame = oit->frame_number;
    } else if (oit->step == OIT_I_STEP_COMPOSE) {
        ++oit->compose_index;
        oit->composes = 1;
    } else if (oit->step == OIT_I_STEP_DEPTH) {
        oit->step = OIT_I_STEP_COMPOSED;
    } else if (oit->step == OIT_I_STEP_REPORT) {
        oit->step = OIT_I_STEP_DONE;
    } else if (oit->step == OIT_I_STEP_OPERATE) {
        oit_i_advance_operation(oit);
    } else {
        if ((oit->step == OIT_I_STEP_SETTLE || oit->step == OIT_I_STEP_GATHER) && oit_i_is_whole(oit)) {
            oit->settled_width = oit->frame.width;
            oit->settled_height = oit->frame.height;
        }
        while (*at != (unsigned char)oit->step)
            ++at;
        do
            oit->step = (oit_i_step) * ++at;
        while (!oit_i_has_step(oit, oit->step));
        if (oit->step == OIT_I_STEP_FILLED)
            oit_i_fetch_more(oit);
        if (oit->step == OIT_I_STEP_FILLED && !oit_i_is_last_part(oit))
            oit_i_start_composing(oit);
    }
}

OIT_I_API int oit_next_pass(oit_context *oit, oit_pass *pass) {
    oit_pass_kind kind;
    oit_i_step step;
    if (!oit || !pass || !oit->in_frame)
        return 0;
    while (oit->failure == OIT_OK) {
        oit_i_skip_steps(oit);
        if (oit->step == OIT_I_STEP_COMPOSED) {
            oit->failure = oit_i_after_part(oit);
            continue;
        }
        if (!oit_i_kind_of_step(oit, &kind))
            return 0;
        if (kind == OIT_PASS_FILL)
            ++oit->bands;
        oit_i_fill_pass(oit, kind, pass);
        if (pass->barriers)
            oit->gl.gl_MemoryBarrier(pass->barriers);
        if (oit->desc.state != OIT_STATE_NONE)
            oit_i_apply(oit, &pass->state);
        step = oit->step;
        oit_i_advance(oit);
        if (oit->desc.state == OIT_STATE_NONE || oit_i_is_hosts(kind))
            return 1;
        oit_i_execute(oit, &pass->state);
        if (step == OIT_I_STEP_MEASURE || step == OIT_I_STEP_CHECK)
            oit->failure = step == OIT_I_STEP_MEASURE ? oit_i_measure(oit) : oit_i_check_fit(oit);
        if ((step == OIT_I_STEP_MEASURE || step == OIT_I_STEP_CHECK) && oit->failure == OIT_OK)
            oit->failure = oit_i_next_part(oit, 0);
        if (step == OIT_I_STEP_CHECK && oit->failure == OIT_OK)
            oit_i_fetch_more(oit);
    }
    return 0;
}

/* ---- oit_run ---- */

static void oit_i_take_operator(oit_context *oit, const oit_operator *op) {
    if (op->kind == OIT_RUN_LINK)
        oit->link = oit_i_resolve_link(op->link);
    if (op->kind == OIT_RUN_LAW)
        oit->law = oit_i_resolve_law(op->law);
    if (op->kind == OIT_RUN_SMART)
        oit->smart = oit_i_resolve_smart(op->smart);
    if (op->kind == OIT_RUN_CURVATURE) {
        oit->curvature = op->curvature;
        if (op->curvature.contour_iterations <= 0)
            oit->curvature.contour_iterations = op->curvature.contour_iterations ? 0 : 64;
        oit->curvature_base = op->curvature.opacities || op->curvature.opacity != OIT_OPACITY_NONE;
        oit_i_take_shades(oit, &op->curvature);
        oit_i_take_opacities(oit, &op->curvature);
    }
    if (op->kind == OIT_RUN_HOST) {
        oit->host_program = op->host.program;
        oit->host_section = op->host.value == (int)OIT_VALUE_BASE ? (int)OIT_I_AT_BASE
                                                                  : OIT_I_AT_HOST + op->host.value - OIT_VALUE_HOST;
    }
}

static oit_i_u oit_i_deeds(const oit_context *oit, const oit_operator *op) {
    static const oit_i_u deeds[5] = {OIT_I_DID_LINK, OIT_I_DID_BASE, OIT_I_DID_SMART | OIT_I_DID_BASE, OIT_I_DID_CURVE,
                                     0};
    oit_i_u did = OIT_I_DID_SORT | deeds[op->kind];
    if ((op->kind == OIT_RUN_CURVATURE && oit->curvature_base) ||
        (op->kind == OIT_RUN_HOST && oit_i_host_makes_base(oit, op)))
        did |= OIT_I_DID_BASE;
    if (op->kind == OIT_RUN_CURVATURE && (op->curvature.shades || op->curvature.shade != OIT_SHADE_NONE))
        did |= OIT_I_DID_SHADE;
    if (op->kind == OIT_RUN_CURVATURE && op->curvature.contours != OIT_CONTOURS_NONE)
        did |= OIT_I_DID_CONTOUR;
    return did;
}

/* Programs of the stages, and of the composition that follows. */
static oit_result oit_i_make_operator_programs(oit_context *oit) {
    oit_result result = oit_i_make_program(oit, OIT_I_PROGRAM_LAID);
    int i;
    if (result == OIT_OK && oit_i_pixel_draws(oit) > OIT_I_CLASSES + 1)
        result = oit_i_make_program(oit, OIT_I_PROGRAM_LAID_LIGHT);
    for (i = 0; i < oit->stage_count && result == OIT_OK; ++i)
        if (oit->stages[i].program != OIT_I_PROGRAM_HOST)
            result = oit_i_make_program(oit, oit->stages[i].program);
    return result;
}

static oit_result oit_i_check_run(oit_context *oit, const oit_operator *op) {
    const char *bad = oit_i_bad_operator(oit, op);
    if (bad)
        return oit_i_fail(&oit->desc, OIT_INVALID_ARGUMENT, "oit_run", bad);
    bad = oit_i_missing_run(oit, op);
    if (bad)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_run", bad);
    if (oit->bands > 1 || oit->rows < oit->frame.height)
        return oit_i_fail(&oit->desc, OIT_TOO_LARGE, "oit_run",
                          "the image is drawn in bands, and operators need all of it at once: raise ceiling_bytes");
    return OIT_OK;
}

/* For the frame's pool, which may have grown since oit_begin. Sections that something is in stay where they are. */
static oit_result oit_i_prepare_surfaces(oit_context *oit) {
    int32_t bound;
    oit_result result;
    if (oit->did || oit->desc.state == OIT_STATE_NONE) /* there they were made with the frame */
        return OIT_OK;
    bound = oit_i_borrow_target(oit);
    result = oit_i_make_surfaces(oit, "oit_run");
    oit_i_return_target(oit, bound);
    return result;
}

OIT_I_API oit_result oit_run(oit_context *oit, const oit_operator *op) {
    oit_result result;
    oit_pass pass;
    if (!oit || !op)
        return OIT_INVALID_ARGUMENT;
    if (oit->in_frame && oit->failure == OIT_OK && oit->step == OIT_I_STEP_DONE &&
        oit->frame.width * oit->frame.height == 0)
        return OIT_OK;
    if (!oit->in_frame || oit->failure != OIT_OK || oit->step != OIT_I_STEP_FILLED)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_run", "between oit_next_pass's 0 and oit_compose");
    result = oit_i_operates(&oit->desc) ? oit_i_prepare_surfaces(oit) : OIT_OK;
    if (result == OIT_OK)
        result = oit_i_check_run(oit, op);
    if (result != OIT_OK)
        return result;
    oit_i_take_operator(oit, op);
    oit_i_plan(oit, op);
    result = oit_i_make_operator_programs(oit);
    if (result != OIT_OK)
        return result;
    if (op->kind == OIT_RUN_CURVATURE) /* run again: what it was asked for last */
        oit->did &= ~(oit_i_u)(OIT_I_DID_SHADE | OIT_I_DID_CONTOUR);
    oit->did |= oit_i_deeds(oit, op);
    oit->step = OIT_I_STEP_OPERATE;
    if (oit->desc.state != OIT_STATE_NONE)
        oit_next_pass(oit, &pass);
    return oit->failure;
}

OIT_I_API const char *const *oit_operator_glsl(const oit_context *oit, int *count) {
    if (!oit || !count || !oit_i_operates(&oit->desc))
        return 0;
    *count = oit->operator_string_count;
    return oit->operator_strings;
}

OIT_I_API oit_result oit_compose(oit_context *oit) {
    oit_pass pass;
    if (!oit)
        return OIT_INVALID_ARGUMENT;
    if (!oit->in_frame)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_compose", "outside of a frame");
    if (oit->failure != OIT_OK || oit->step == OIT_I_STEP_DONE)
        return oit->failure;
    if (oit->step != OIT_I_STEP_FILLED)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_compose", "before oit_next_pass has returned 0");
    oit_i_start_composing(oit);
    if (oit->desc.state != OIT_STATE_NONE)
        oit_next_pass(oit, &pass);
    return oit->failure;
}

OIT_I_API oit_result oit_end(oit_context *oit) {
    if (!oit)
        return OIT_INVALID_ARGUMENT;
    if (!oit->in_frame)
        return oit_i_fail(&oit->desc, OIT_WRONG_ORDER, "oit_end", "outside of a frame");
    oit->in_frame = 0;
    if (oit->step == OIT_I_STEP_DONE && oit->slot >= 0 && oit->failure == OIT_OK) {
        oit_report *pending = &oit->pending[oit->slot];
        memset(pending, 0, sizeof *pending);
        pending->frame = oit->frame_number;
        pending->capacity = oit->capacity;
        pending->bands = oit->bands;
        oit->guessed[oit->slot] = oit->list->direct;
        pending->layers = (uint32_t)oit->layers;
        oit->gl.gl_MemoryBarrier(OIT_I_GL_BUFFER_UPDATE_BARRIER);
        oit->fences[oit->slot] = oit->gl.gl_FenceSync(OIT_I_GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }
    oit_i_end_picks(oit);
    if (oit->saved_state && oit->desc.state == OIT_STATE_LEAVE_DEFAULTS)
        oit_i_save_defaults(&oit->saved);
    if (oit->saved_state && oit->desc.state != OIT_STATE_LEAVE_DIRTY)
        oit_i_restore(oit, &oit->saved);
    return oit->failure;
}

OIT_I_API void oit_set_material(oit_context *oit, const oit_pass *pass, const oit_material *material) {
    const oit_i_surface *surface;
    oit_i_u object[4];
    if (!oit || !pass || !material || !oit_i_is_hosts(pass->kind))
        return;
    surface = &oit->surfaces[oit_i_program_of(oit, pass->kind) - OIT_I_PROGRAM_COUNT];
    object[0] = material->part;
    object[1] = material->key;
    object[2] = material->blend;
    object[3] = material->two_sided ? 1u : 0u;
    oit->gl.gl_UniformMatrix4fv(surface->model_view_projection, 1, 0, material->model_view_projection);
    /* A location of -1 is of what the pass does not use, and setting it is no error. */
    oit->gl.gl_UniformMatrix3fv(surface->normal_matrix, 1, 0, material->normal_matrix);
    oit->gl.gl_Uniform4fv(surface->color, 1, material->color);
    oit->gl.gl_Uniform4uiv(surface->object, 1, object);
}

#endif /* OIT_BUFFERS_IMPLEMENTATION_ONCE */
#endif /* OIT_BUFFERS_IMPLEMENTATION */

/*
MIT License

Copyright (c) 2026 the Glassine authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
