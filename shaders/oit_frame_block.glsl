// For: oit_buffers.h
// What is the same for all of a pass (std140, written by oit_i_upload_block), and where things lie in the pixel buffer.
layout(std140, binding = OIT_UNIFORM_BINDING) uniform oit_frame
{
    highp ivec4 oit_area;  // x, y of the slab's corner in the target, its width and height
    highp uvec4 oit_pool;  // x: pixels of the slab, y: first fragment of the band, z: capacity, w: blocks of the scan
    highp uvec4 oit_step;  // x: 1 with the first slab of a frame, y: what is deeper is left to the program for all depths,
                           // w: k of the stores that keep the k nearest; of others 1 where the fragments are stored before
                           // they are counted, 2 where they are stored again; of fetch how many passes there are, if known
    highp uvec4 oit_above; // what is not deeper than this is left to the program before: of up to 8, 16, 32, 64
    highp vec4 oit_light;  // xyz: toward the light, unit length; zero: no shading. w: weight of the background
    highp vec4 oit_output; // x: transmittance below which the depth of the composite is taken
    highp ivec4 oit_part;          // x, y of the corner in the target, width and height of what is filled and composed now
    highp uvec4 oit_samples;       // x: a bit for each sample of the target
    highp vec4 oit_positions[4];   // of two samples each, from the middle of the pixel
};

// The pixel buffer: 16 words of totals, then two words a pixel (where its run starts; how many fragments are still to
// come), one more start, a word for each block of the scan, a word a pixel where the store has one of its own, and four or
// six words a pixel for the tail.
#define OIT_NEEDED 0u      // fragments of the slab that needs most
#define OIT_DEEPEST 1u     // fragments of the deepest pixel
#define OIT_LOST_PIXELS 2u // pixels that are composed from the tail
#define OIT_LOST 3u        // fragments that went to the tail
#define OIT_EXTRA 4u       // fragments that the fill met and the count had not
#define OIT_TOTAL 5u       // fragments of this slab
#define OIT_TAKEN 6u       // OIT_STORE_LINKED: records taken of the list
#define OIT_PIXELS 8u      // from here on, by power of two: pixels of up to 8, 16, 32, 64 fragments, and of more
#define OIT_HEADER 16u
#define OIT_START(p) (OIT_HEADER + 2u * (p))
#define OIT_LEFT(p) (OIT_HEADER + 1u + 2u * (p))
#define OIT_SUM(b) (OIT_HEADER + 2u + 2u * oit_pool.x + (b))
#define OIT_MORE (OIT_HEADER + 2u + 2u * oit_pool.x + oit_pool.w)
#if OIT_KEEPS
// With the stores that keep the k nearest: six words a pixel for the tail, the limit (keys from there on are not kept),
// k + 1 keys; and k buckets of two words: a part, and which records it has.
#define OIT_LAYERS oit_step.w
#define OIT_TAIL(p) (OIT_MORE + 6u * (p))
#define OIT_LIMIT(p) (OIT_MORE + 6u * oit_pool.x + (p))
#define OIT_KEY(p, i) (OIT_MORE + 7u * oit_pool.x + (p) * (OIT_LAYERS + 1u) + (i))
#define OIT_BUCKET(p, i) (OIT_MORE + (8u + OIT_LAYERS) * oit_pool.x + 2u * ((p) * OIT_LAYERS + (i)))
#else
#define OIT_OWN(p) (OIT_MORE + (p))
#define OIT_TAIL(p) (OIT_MORE + uint(OIT_OWN_WORDS) * oit_pool.x + uint(OIT_TAIL_WORDS) * (p))
#endif
#define OIT_DIRECT (OIT_KEEPS == 0 && oit_step.w == 1u)
#define OIT_AGAIN (OIT_KEEPS == 0 && oit_step.w == 2u)

// OIT_STORE_FETCH: eleven words a pixel: the last record that was composed and how many were like it; light and transmittance
// of what was.
#define OIT_LAID(p) (OIT_MORE + 11u * (p))

// OIT_STORE_LINKED: one more than the place of the pixel's last record; 0: none.
#define OIT_HEAD(p) OIT_OWN(p)

// Where the scan finds how long the run of a pixel shall be. OIT_STORE_PREDICT keeps how many fragments came in the frame
// before, and needs no place for its guess but that where the scan writes the start.
#if OIT_STORE == OIT_PREDICT
#define OIT_SEEN(p) OIT_OWN(p)
#define OIT_WANTED(p) OIT_START(p)
#else
#define OIT_WANTED(p) OIT_LEFT(p)
#endif
#define OIT_NONE 0xffffffffu

// With OIT_HAS_COVERAGE one word a pixel follows: 1 where a fragment covers not all of its samples.
#if OIT_KEEPS
#define OIT_EDGE(p) (OIT_BUCKET(OIT_STORE == OIT_BUCKETED ? oit_pool.x : 0u, 0u) + (p))
#else
#define OIT_EDGE(p) (OIT_TAIL(oit_pool.x * uint(OIT_ASYNC)) + (p))
#endif

// With what is to come of a pixel whose run does not fit. A pixel has less than 2^30 fragments.
#define OIT_UNFIT 0x40000000u
// How many places are left, without that; negative: so many came too much.
#define OIT_TRUE_LEFT(left) (int(left) - (OIT_ASYNC == 1 && int(left) >= 0x20000000 ? 0x40000000 : 0))

// Mesa 22's software driver lets multisampled fragments pass beyond the scissor box, by one pixel to the left and below.
#define OIT_OUTSIDE (any(lessThan(ivec2(gl_FragCoord.xy), oit_part.xy)) || \
                     any(greaterThanEqual(ivec2(gl_FragCoord.xy), oit_part.xy + oit_part.zw)))

// The part of a pixel that some of its samples are.
#define OIT_SHARE(covered) (float(bitCount(covered)) / float(max(bitCount(oit_samples.x), 1)))

// A block of the scan: 128 invocations of 8 pixels each.
#define OIT_BLOCK 1024u
