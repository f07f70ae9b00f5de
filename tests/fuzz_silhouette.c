/* Structured random input for every function of silhouette.h: hostile meshes, poses, views, edges and matrices.
   cc -std=c11 -g -O1 -fsanitize=address,undefined -I. tests/fuzz_silhouette.c -o fuzz -lm && ./fuzz 100000 1
   clang -g -O1 -fsanitize=fuzzer,address,undefined -DFUZZ_LIBFUZZER -I. tests/fuzz_silhouette.c -o fuzz && ./fuzz
   Arguments: number of inputs, seed. Every input also checks what must hold whatever the input is. */
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bytes that decide everything; zeros once they are used up. */
typedef struct source {
    const unsigned char *data;
    size_t size, at;
} source;

static unsigned take(source *s) {
    return s->at < s->size ? s->data[s->at++] : 0;
}

static uint32_t take_word(source *s) {
    uint32_t word = 0;
    int i;
    for (i = 0; i < 4; ++i)
        word = word << 8 | take(s);
    return word;
}

static void require(int condition, const char *what) {
    if (condition)
        return;
    fprintf(stderr, "fuzz_silhouette: %s\n", what);
    abort();
}

/* Small integers, halves, and now and then any bits at all: NaN, infinities, subnormals, huge values. */
static float take_float(source *s) {
    const unsigned kind = take(s);
    float value;
    uint32_t bits;
    if (kind < 150)
        return (float)((int)(take(s) % 9) - 4);
    if (kind < 230)
        return (float)((int)take(s) - 128) / 16;
    bits = take_word(s);
    if (kind < 250)
        bits = (bits & 0x81ffffffu) | 0x3e000000u; /* ordinary magnitudes, all bits of the mantissa */
    memcpy(&value, &bits, sizeof value);
    return value;
}

static double take_double(source *s) {
    uint64_t bits;
    double value;
    if (take(s) < 240)
        return (double)take_float(s);
    bits = (uint64_t)take_word(s) << 32 | take_word(s);
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* A side may be cut at every vertex but its own. */
enum { MOST_VERTICES = 24, MOST_FACES = 40, MOST_EDGES = 3 * (MOST_FACES + 3 * MOST_FACES * (MOST_VERTICES - 2)) };
enum { MOST_OUT = 4000, ALL_KINDS = 79 };

typedef struct scene {
    float positions[4 * MOST_VERTICES];
    uint32_t indices[3 * MOST_FACES], parts[3 * MOST_FACES];
    sil_mesh_desc desc;
} scene;

static void take_scene(source *s, scene *out) {
    size_t i, faces = take(s) % (MOST_FACES + 1);
    const size_t vertices = take(s) % (MOST_VERTICES + 1);
    memset(out, 0, sizeof *out);
    for (i = 0; i < 4 * vertices; ++i)
        out->positions[i] = take_float(s);
    for (i = 0; i < 3 * faces; ++i) {
        const unsigned v = take(s);
        out->indices[i] = v == 255 ? take_word(s) : v % (unsigned)(vertices + 1 + (v > 250));
        if (v < 240 && vertices)
            out->indices[i] = v % (unsigned)vertices;
        if (i >= 3 && v % 3 == 0)
            out->indices[i] = out->indices[i - 3 + v / 3 % 3]; /* neighbours and duplicates */
    }
    out->desc.positions = out->positions;
    out->desc.position_stride = take(s) % 2 ? 16 : 0;
    out->desc.vertex_count = vertices;
    out->desc.indices = take(s) % 8 ? out->indices : NULL;
    out->desc.index_count = out->desc.indices ? 3 * faces + (take(s) > 250) : 0;
    out->desc.weld_distance = take(s) % 4 ? 0 : take_float(s);
    out->desc.crease_degrees = take(s) % 4 ? 0 : take_float(s);
    out->desc.flags = take(s) % 4 ? SIL_MESH_HIERARCHY : SIL_MESH_NO_HIERARCHY;
    out->desc.flags |= take(s) % 4 ? 0 : SIL_MESH_ORIENT;
    out->desc.t_junction_distance = take(s) % 4 ? 0 : take_float(s);
    for (i = 0; i < 3 * MOST_FACES; ++i)
        out->parts[i] = (uint32_t)(i * i % 7 % 3);
    out->desc.face_parts = take(s) % 4 ? NULL : out->parts;
}

static sil_view take_view(source *s) {
    sil_view view;
    int i;
    for (i = 0; i < 3; ++i)
        view.eye[i] = take_double(s);
    view.eye[3] = take(s) % 8 ? take(s) % 2 : take_double(s);
    return view;
}

static void take_matrix(source *s, float *m, int count, int side) {
    int i;
    for (i = 0; i < count; ++i)
        m[i] = take(s) % 4 ? (float)(i % (side + 1) == 0) : take_float(s);
}

static int is_finite(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (bits & 0x7f800000u) != 0x7f800000u;
}

/* Edges of a closed manifold mesh make closed loops, with and without a pose. */
static size_t check_extract(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, unsigned kinds,
                            sil_edge *edges) {
    static sil_edge other[MOST_EDGES];
    const sil_mesh_info info = sil_mesh_get_info(mesh);
    unsigned char odd[MOST_VERTICES];
    const size_t count = sil_extract(mesh, pose, view, kinds, edges, MOST_EDGES);
    const int zone = pose && pose->zone_sine > 0;
    size_t i;
    memset(odd, 0, sizeof odd);
    require(count <= info.edge_count && info.edge_count <= MOST_EDGES, "more edges than there are");
    for (i = 0; i < count; ++i) {
        require(edges[i].a < info.vertex_count && edges[i].b < info.vertex_count, "an edge's vertex is out of range");
        require(edges[i].edge < info.edge_count && (i == 0 || edges[i].edge > edges[i - 1].edge), "edges out of order");
        require((edges[i].kinds & kinds & ALL_KINDS) != 0 && edges[i].kinds < 128, "a kind that was not asked for");
        odd[edges[i].a] ^= 1;
        odd[edges[i].b] ^= 1;
    }
    for (i = 0; i < MOST_VERTICES && kinds == SIL_SILHOUETTE && info.closed && !info.nonmanifold_edge_count &&
                !info.degenerate_face_count && (!pose || (zone && !pose->is_set));
         ++i)
        require(!odd[i], "a silhouette that is not closed");
    if (pose && !zone && sil_pose_set(pose, NULL, 0) == SIL_OK) {
        const size_t with = sil_extract(mesh, pose, view, kinds, edges, MOST_EDGES);
        require(with == sil_extract(mesh, NULL, view, kinds, other, MOST_EDGES), "a pose finds other edges");
        require(memcmp(edges, other, with * sizeof *edges) == 0, "a pose finds edges that differ");
        return with;
    }
    return count;
}

/* Candidates of triangles with corners and indices of any kind: lists that follow each other, of edges that are there. */
static void check_candidates(const sil_edge_tree *tree, size_t edge_count, source *s) {
    static uint32_t candidates[MOST_OUT];
    float corners[3 * 6];
    uint32_t indices[9], offsets[4];
    size_t i, needed = 0;
    for (i = 0; i < 18; ++i)
        corners[i] = take_float(s);
    for (i = 0; i < 9; ++i)
        indices[i] = take(s) % 7;
    require(sil_candidates(tree, corners, 0, 6, indices, 3, offsets, candidates, MOST_OUT, &needed) == SIL_OK,
            "no candidates");
    for (i = 0; i < 3; ++i)
        require(offsets[i] <= offsets[i + 1], "candidates out of order");
    require(offsets[0] == 0 && offsets[3] == needed, "candidates are missing");
    for (i = 0; i < needed && i < MOST_OUT; ++i)
        require(candidates[i] < edge_count, "a candidate is out of range");
}

/* Vector code and plain code find the same. */
static void check_plain(sil_mesh *mesh, const sil_view *view, unsigned kinds) {
    static sil_edge wide[MOST_EDGES], plain[MOST_EDGES];
    const int is_wide = mesh->wide;
    size_t count = sil_extract(mesh, NULL, view, kinds, wide, MOST_EDGES);
    mesh->wide = 0;
    require(count == sil_extract(mesh, NULL, view, kinds, plain, MOST_EDGES), "vector code finds other edges");
    require(memcmp(wide, plain, count * sizeof *wide) == 0, "vector code finds edges that differ");
    mesh->wide = is_wide;
}

static void check_components(const sil_mesh *mesh, size_t triangles, source *s) {
    uint32_t components[3 * MOST_FACES], parents[3], facts[3];
    const sil_mesh_info info = sil_mesh_get_info(mesh);
    sil_part parts[3];
    sil_result result;
    size_t i, steps, count = take(s) % 4;
    require(sil_mesh_components(mesh, components, triangles) == SIL_OK, "no components");
    for (i = 0; i < triangles; ++i)
        require(components[i] < info.component_count || components[i] == SIL_NONE, "a component is out of range");
    memset(parts, 0, sizeof parts);
    for (i = 0; i < count; ++i) {
        parts[i].mesh = mesh;
        take_matrix(s, parts[i].transform, 16, 4);
        parts[i].component = take(s) % 4 ? 0 : take(s);
    }
    result = sil_containment(parts, count, take(s) % 32, parents, facts);
    require(result == SIL_OK || result == SIL_INVALID_ARGUMENT, "containment: a strange result");
    for (i = 0; result == SIL_OK && i < count; ++i) {
        uint32_t at = (uint32_t)i;
        for (steps = 0; steps < 3 && at != SIL_NONE; ++steps) {
            require(at < count, "a parent is out of range");
            at = parents[at];
        }
        require(at == SIL_NONE, "parents in a circle");
        require(facts[i] < 8, "facts that are none");
    }
}

static void check_smooth(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, const float *normals, source *s) {
    static sil_smooth_point points[2 * MOST_EDGES];
    static sil_strip strips[MOST_EDGES];
    size_t needed, i, count;
    const unsigned flags = take(s) % 2;
    count = sil_smooth(mesh, pose, view, take(s) % 2 ? normals : NULL, 0, flags, points, 2 * MOST_EDGES, strips,
                       MOST_EDGES, &needed);
    require(count <= MOST_EDGES && needed <= 2 * MOST_EDGES, "more smooth silhouettes than edges");
    for (i = 0; i < needed; ++i)
        require(points[i].t >= 0 && points[i].t <= 1 && points[i].edge < sil_mesh_get_info(mesh).edge_count,
                "a smooth silhouette is beside its edge");
}

static void check_chain(const sil_mesh *mesh, sil_pose *pose, sil_edge *edges, size_t count, source *s) {
    static sil_strip strips[MOST_EDGES];
    static uint32_t vertices[2 * MOST_EDGES];
    static sil_ribbon_vertex out[MOST_OUT];
    static float widths[2 * MOST_EDGES], along[2 * MOST_EDGES];
    const float dashes[4] = {3, take_float(s), 1, 2};
    const uint32_t ids[4] = {0, 1, 1, 0};
    sil_image image;
    sil_chain_desc corners;
    sil_ribbon_desc desc;
    size_t i, strip_count, needed, total = 0, made;
    for (i = 0; i < count && take(s) > 200; ++i) { /* hostile edges */
        edges[i].edge = take_word(s) % 200;
        edges[i].kinds = take(s);
        edges[i].face[0] = take(s);
        edges[i].a = take(s);
    }
    memset(&corners, 0, sizeof corners);
    corners.corner_degrees = take(s) % 2 ? 0 : take_float(s) * 20;
    take_matrix(s, corners.matrix, take(s) % 2 ? 16 : 0, 4);
    corners.viewport_width = corners.viewport_height = take(s) % 2 ? 0 : take_float(s) * 100;
    corners.flags = take(s) % 2;
    strip_count = sil_chain_corners(mesh, pose, take(s) % 2 ? &corners : NULL, edges, count, strips, MOST_EDGES,
                                    vertices, 2 * MOST_EDGES, &needed);
    require(strip_count <= count && needed <= 2 * count, "more strips than edges");
    for (i = 0; i < strip_count; ++i) {
        require(strips[i].first == total && strips[i].count >= 2, "strips do not follow each other");
        total += strips[i].count;
    }
    require(total == needed, "vertices are missing");
    memset(&desc, 0, sizeof desc);
    take_matrix(s, desc.model_view, 16, 4);
    take_matrix(s, desc.projection, 16, 4);
    desc.viewport_width = take(s) % 4 ? 640 : take_float(s);
    desc.viewport_height = take(s) % 4 ? 480 : take_float(s);
    desc.width = take(s) % 2 ? 0 : take_float(s);
    desc.width_scale[take(s) % 5] = take_float(s);
    desc.tolerance = take(s) % 4 ? 0 : take_float(s);
    desc.cap = (sil_cap)(take(s) % 3);
    desc.join = (sil_join)(take(s) % 3);
    desc.flags = take(s) % 2;
    desc.weight = (sil_weight)(take(s) % 5);
    desc.heavy = take(s) % 2 ? 0 : take_float(s);
    desc.thin = take(s) % 2 ? 0 : take_float(s);
    desc.light[0] = take(s) % 2 ? 0 : take_float(s);
    desc.reach[1] = take(s) % 2 ? 0 : take_float(s);
    memset(&image, 0, sizeof image);
    image.ids = ids;
    image.width = image.height = 2;
    desc.image = take(s) % 2 ? &image : NULL;
    for (i = 0; i < needed && i < 2 * MOST_EDGES; ++i)
        widths[i] = i < 8 ? take_float(s) : widths[i % 8];
    desc.widths = take(s) % 4 ? NULL : widths;
    desc.taper = take(s) % 2 ? 0 : take_float(s);
    if (take(s) % 2) {
        desc.dashes = dashes;
        desc.dash_count = take(s) % 2 ? 4 : 2;
        if (take(s) % 2) {
            sil_dashes *memory = sil_dashes_create(NULL, NULL);
            require(memory != NULL, "no dashes");
            for (i = 0; i < 2; ++i) {
                const sil_result followed =
                    sil_dashes_follow(memory, mesh, pose, strips, strip_count, vertices, &desc, along);
                require(followed == SIL_OK || followed == SIL_INVALID_ARGUMENT, "dashes: a strange result");
                desc.along = followed == SIL_OK ? along : NULL;
                desc.model_view[12] += 0.1f;
            }
            sil_dashes_destroy(memory);
        }
    }
    made = sil_ribbons(mesh, pose, strips, strip_count, vertices, &desc, out, MOST_OUT);
    require(made % 3 == 0, "not whole triangles");
    for (i = 0; i < made && i < MOST_OUT / 3 * 3; ++i) {
        const float reach_x = desc.viewport_width + 20000, reach_y = desc.viewport_height + 20000;
        require(out[i].depth >= 0 && out[i].depth <= 1 && out[i].slack >= 0, "depth or slack out of range");
        require(out[i].x > -reach_x && out[i].x < 2 * reach_x && out[i].y > -reach_y && out[i].y < 2 * reach_y,
                "far away");
        require(is_finite(out[i].arc) && out[i].arc >= 0, "arc is not finite");
    }
}

static void check_distances(const sil_mesh *mesh, const sil_pose *pose, const sil_edge *edges, size_t count,
                            source *s) {
    float distances[MOST_VERTICES];
    uint32_t nearest[MOST_VERTICES];
    sil_distance_desc desc;
    const size_t vertices = sil_mesh_get_info(mesh).vertex_count, first = take(s), some = take(s) % 32;
    sil_result result;
    size_t i;
    memset(&desc, 0, sizeof desc);
    take_matrix(s, desc.model, 9, 3);
    desc.flags = take(s) % 2;
    result = sil_distances(mesh, pose, edges, count, take(s) % 4 ? &desc : NULL, first % (vertices + 1),
                           first + some <= vertices ? some : 0, distances, nearest);
    require(result == SIL_OK || result == SIL_INVALID_ARGUMENT, "distances: a strange result");
    for (i = 0; result == SIL_OK && first + some <= vertices && i < some; ++i) {
        require(distances[i] >= 0, "a distance is negative or NaN");
        require(nearest[i] < count || nearest[i] == SIL_NONE, "nearest is out of range");
    }
    if (!(desc.flags & SIL_DISTANCE_INFINITE_LINE)) {
        float by_tree[MOST_VERTICES];
        uint32_t its_nearest[MOST_VERTICES];
        sil_edge_tree *tree = sil_edge_tree_create(mesh, NULL);
        const sil_result built = sil_edge_tree_build(tree, pose, edges, count, &desc);
        require(built == (sil_distances(mesh, pose, edges, count, &desc, 0, vertices, distances, nearest)),
                "a tree and all pairs judge the matrix differently");
        if (built == SIL_OK) {
            require(sil_distances_by_tree(tree, 0, vertices, by_tree, its_nearest) == SIL_OK, "no distances by tree");
            require(memcmp(by_tree, distances, vertices * sizeof(float)) == 0, "a tree finds other distances");
            require(memcmp(its_nearest, nearest, vertices * sizeof(uint32_t)) == 0, "a tree finds other edges");
            check_candidates(tree, count, s);
        }
        sil_edge_tree_destroy(tree);
    }
    require(sil_max_distance(mesh, pose, desc.model) >= 0, "the greatest distance is negative or NaN");
}

static void run_one(const unsigned char *data, size_t size) {
    static scene input;
    static sil_edge edges[MOST_EDGES];
    source s;
    sil_result result;
    sil_mesh *mesh;
    sil_pose *pose;
    int round;
    s.data = data;
    s.size = size;
    s.at = 0;
    take_scene(&s, &input);
    mesh = sil_mesh_create(&input.desc, &result);
    require((mesh != NULL) == (result == SIL_OK), "a mesh and an error");
    if (!mesh)
        return;
    pose = sil_pose_create(mesh, &result);
    require(pose != NULL, "no pose");
    check_components(mesh, input.desc.indices ? input.desc.index_count / 3 : input.desc.vertex_count / 3, &s);
    for (round = 0; round < 4; ++round) {
        sil_view view = take_view(&s);
        const unsigned kinds = take(&s) % 3 ? SIL_SILHOUETTE : take(&s);
        float posed[4 * MOST_VERTICES];
        size_t i, count;
        if (take(&s) % 4 == 0) {
            float model_view[16], projection[16];
            take_matrix(&s, model_view, 16, 4);
            take_matrix(&s, projection, 16, 4);
            (void)sil_view_from_matrices(model_view, projection, &view);
        }
        if (round % 2)
            for (i = 0; i < 4 * input.desc.vertex_count; ++i)
                posed[i] = take_float(&s);
        if (round % 2)
            require(sil_pose_set(pose, posed, 16) == SIL_OK, "the pose was not set");
        result = sil_pose_set_dead_zone(pose, take(&s) % 4 ? 0 : take_double(&s), take(&s) % 2);
        require(result == SIL_OK || result == SIL_INVALID_ARGUMENT, "the dead zone: a strange result");
        if (take(&s) % 4 == 0) /* what is remembered matters the second time */
            (void)sil_extract(mesh, pose, &view, kinds, NULL, 0);
        check_plain(mesh, &view, kinds);
        check_smooth(mesh, round ? pose : NULL, &view, input.positions, &s);
        count = check_extract(mesh, round ? pose : NULL, take(&s) % 8 ? &view : NULL, kinds, edges);
        check_distances(mesh, round ? pose : NULL, edges, count, &s);
        check_chain(mesh, round % 2 ? pose : NULL, edges, count, &s);
    }
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
}

#ifdef FUZZ_LIBFUZZER
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    run_one(data, size);
    return 0;
}
#else
int main(int argc, char **argv) {
    const unsigned long count = argc > 1 ? strtoul(argv[1], NULL, 10) : 20000;
    uint64_t state = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    unsigned long n;
    for (n = 0; n < count; ++n) {
        unsigned char data[2048];
        size_t i;
        for (i = 0; i < sizeof data; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            data[i] = (unsigned char)(state >> 56);
        }
        run_one(data, sizeof data);
    }
    printf("fuzz_silhouette: %lu inputs\n", count);
    return 0;
}
#endif
