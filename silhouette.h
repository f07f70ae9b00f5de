/* silhouette.h - v0.2.0 - feature lines of triangle meshes, on the CPU - MIT licence (text at the end of the file)

    Silhouettes, creases, boundaries and non-manifold edges of a triangle mesh for a given eye; chains of them; screen
    space ribbons with the illustrators' weights, dashes, joins and caps; smooth silhouettes; the distance of every
    vertex to the nearest of them. One header, no GL, no dependency but the C library's memory, string and mathematics
    functions.

    DOES
      - find silhouettes without gaps: every face is classified once, exactly, and an edge is a silhouette if and only
        if its faces differ, so that the silhouettes of a mesh whose edges have two faces are closed loops in every
        view;
      - take meshes as they come: split vertices, faces given twice, faces without area, open borders, edges of three
        and more faces, NaN, indices out of range. Each has a documented result (see DIRTY MESHES);
      - give the same lines whatever the order of the faces and of the vertices within a face.

    DOES NOT
      - draw, or decide what is hidden: the lines are all of the mesh's, visible or not. Hidden ones are for a depth
        test (see `slack` of sil_ribbon_vertex);
      - mend meshes beyond what DIRTY MESHES says;
      - find lines where two faces pass through each other.

    QUICK START

    --8<-- quick start
    #define SILHOUETTE_IMPLEMENTATION
    #include "silhouette.h"
    #include <stdio.h>
    #include <string.h>

    int main(void)
    {
        // A tetrahedron. Faces are counter-clockwise seen from outside.
        const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        const uint32_t indices[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
        const double eye[3] = {3, 2, 5};
        sil_mesh_desc desc;
        sil_result result;
        sil_mesh *mesh;
        sil_view view;
        sil_edge edges[6];
        size_t count, i;

        memset(&desc, 0, sizeof desc);
        desc.positions = positions;
        desc.vertex_count = 4;
        desc.indices = indices;
        desc.index_count = 12;
        mesh = sil_mesh_create(&desc, &result);
        if (!mesh) {
            printf("%s\n", sil_result_string(result));
            return 1;
        }
        view = sil_view_perspective(eye);
        count = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, edges, 6);
        for (i = 0; i < count; ++i)
            printf("silhouette from vertex %u to vertex %u\n", (unsigned)edges[i].a, (unsigned)edges[i].b);
        sil_mesh_destroy(mesh);
        return count == 3 ? 0 : 1;
    }
    -->8--

    HOW TO BUILD
      In one source file of the program write `#define SILHOUETTE_IMPLEMENTATION` before including this header; include
      it without the define elsewhere. C99 and later, C++11 and later. Link with -lm where there is such a library.

    OPTIONS (macros)
      SILHOUETTE_IMPLEMENTATION   in one file: the code as well as the declarations
      SIL_STATIC                  in that one file: every function is static
      SIL_MALLOC(n), SIL_FREE(p)  in that one file, both or neither: the memory functions used where a desc has no
                                  allocator. Default: malloc and free of the C library
      SIL_ASSERT(x)               in that one file: checks of the header's own invariants. Default: nothing
      SIL_NO_SIMD                 in that one file: no vector code. The results are the same without

    CONVENTIONS
      - Matrices are column-major float[16] (model: float[9]) as GL takes them. Eye space is GL's: the camera looks down
        the negative z axis. Faces are counter-clockwise seen from their front.
      - A desc of all zero bytes asks for the defaults. Set every desc to zero first.
      - A function that fills an array returns the number of elements that it has or would have, as snprintf does, and
        writes no more than the capacity. With a NULL array it only counts.
      - Vertices are named by the caller's indices. Where several were welded into one it is the smallest of them.

    ERRORS, MEMORY, THREADS
      - Functions that can fail say so by a sil_result. sil_mesh_create gives NULL and the reason; messages in words go
        to desc.log_fn, which is called only while a mesh is being made.
      - Memory comes from desc.allocator; a sil_dashes has one of its own. What is made by sil_mesh_create,
        sil_pose_create, sil_edge_tree_create and sil_dashes_create is allocated. sil_pose_set, and a dead zone that
        remembers, allocate the first time. A pose keeps the scratch memory of sil_chain and sil_smooth and the edges of
        sil_track, an edge tree its edges, a sil_dashes its lines; all that only ever grows, and sil_pose_reserve
        (chains and tracks) and sil_edge_tree_reserve make it large enough at once. So a steady frame allocates nothing.
        Without a pose sil_chain and sil_smooth allocate and free in the call. sil_mesh_components and sil_containment
        always do. All other functions never allocate.
      - No global variables. A mesh never changes once made: any number of threads may use it at once, also to create
        poses and trees if the allocator allows it. A pose, an edge tree and a sil_dashes hold what changes: each is for
        one thread at a time in functions that take it without const. Those that take it const only read it, and
        threads may share it in them: a pose in sil_distances and sil_ribbons, a built tree in sil_distances_by_tree,
        sil_distances_at and sil_candidates, each thread with a range of its own. The first two of these three use 40
        KiB of stack.

    THE EYE
      The eye is homogeneous and in the coordinates of the mesh: a point with w = 1, or a direction toward the eye with
      w = 0 (orthographic). A face with corners a, b, c is in front if and only if det[b - a, c - a, eye - w * a] > 0.
      Zero, that is a face seen edge-on, counts as back. The sign is that of exact arithmetic for every finite input,
      and for every order of the corners, and does not depend on compiler flags. Before that the eye is rounded once for
      all faces: scaled to 1 <= w < 2 (a direction: largest coordinate in [1, 2)), bits below 2^-200 are cut off; an eye
      2^130 or more away is brought back to there along its direction. An eye that is NaN, infinite or zero sees only
      backs. w < 0 is the same point as its negation.

    THE HIERARCHY
      Faces are numbered in patches of 32 that are close together and look the same way, and all that is read of a patch
      to find and write its silhouettes is one run of cache lines. A mesh of 4,000 edges and more (desc.flags changes
      that) has a hierarchy: for each patch a box around its planes (normal and offset) and those of the faces across its
      edges, and boxes of boxes. sil_extract then leaves out patches whose planes surely have one sign, with rounding
      accounted for, so that edges and order are those of the flat scan, in perspective and in parallel views. Patches
      that lie exactly in one plane have no silhouettes in any view and are never looked at. Within a patch signs are
      told by sums of products of 16-bit steps within its box: whole numbers, the same whatever the compiler does; those
      in doubt by the float plane, then in double, then exactly. With a vector unit (AVX2, asked for at run time) dense
      silhouettes cost no more than by the flat scan; without one up to a fifth more.
      The flat scan tells all faces by their float planes, then takes the patches that are not of one sign. It serves
      posed meshes, poses with a dead zone, and meshes without a hierarchy.
      Cost of a view, about: 60 ns for each patch that a silhouette passes near, 5 ns for each edge written; the flat
      scan 1.5 ns an edge of the mesh. Memory: 9 bytes an edge for the hierarchy, of 86 for the mesh. docs/silhouette.md
      has figures.

    LINE WEIGHTS (Gooch 1999, 3.1 and 5.1.3)
      The width of a line is width * width_scale of its kind * widths of the vertex * a factor by desc.weight, `heavy` or
      `thin` or in between. It is linear on the screen between two vertices; a vertex given twice makes a step.
      - SIL_WEIGHT_THICK_THIN: what a line is says whether one or both of its faces can be seen. Costs nothing.
      - SIL_WEIGHT_OUTER: where the background lies within a pixel and a half on either side the line is heavy, in
        whatever edge that begins or ends; it passes from thin to heavy in eight pixels. Three ways to the outer lines:
          - the host's depth or ids, read back: exact to a pixel, lines through the middle of the picture included.
            Making the ribbons takes 2.1 times as long (docs/silhouette.md); reading back waits for the GPU, or is a
            frame late;
          - the same from a picture that the CPU draws (examples/depth_image.c): no wait, but each triangle again;
          - on the GPU (5.1.3): silhouettes and boundaries once more, wider, where no surface was drawn, by a stencil or
            as transparency.h does it (TR_LINES_OUTER). No read-back, one more pass over the ribbons; only the half of a
            line that lies outside becomes wider.
        SIL_WEIGHT_THICK_THIN is what comes close without any picture: outer lines are among its heavy ones, and so are
        silhouettes before other things.
      - SIL_WEIGHT_PERSPECTIVE: by the distance of the vertex along the view, linear between desc.reach, also in parallel
        views. Give reach where several meshes make one picture.
      - SIL_WEIGHT_LIGHT: by the angle between the light on the screen and the way outward, to the right of the strip.
        Chains with corners keep the corners of a box sharp. Creases are in the middle.
      - sil_ribbon_desc.widths: any other, for instance by the line's curvature; and desc.taper for thin ends.

    DASHES
      Lengths in pixels along the line, as on paper: the caps of dashes lie beyond them, butt ones excepted. A dash of no
      length is a dot. Phantom lines, of things that are not there or transparent (Diepstraten 2002, figure 2): {24, 5,
      6, 5, 6, 5}, a long dash and two short ones. Hidden lines: {6, 4}. Lengths that are negative or not finite, an odd
      number of them, more than 64, or all 0 draw nothing. A segment of more than 65,536 periods is drawn whole. Arcs go
      on outside of the viewport, so that dashes do not swim at its border. In moving pictures: sil_dashes.

    DIRTY MESHES
      - Split vertices are welded by position (weld_distance = 0, the default: same x, y, z; -0 is 0), by distance
        (weld_distance > 0: vertices are taken in order, each joins the first earlier kept one within that distance),
        or not (weld_distance < 0).
      - Faces with an index out of range or a vertex that is NaN or infinite are left out: dropped_face_count.
      - Faces with two corners the same after welding are left out: degenerate_face_count. Their neighbours then meet.
      - Faces whose corners lie exactly on a line: counted there too, but kept. Such a face is as the neighbour across
        its longest edge is (on through further such faces; if those go in a circle, as the closest other neighbour), so
        it adds no line to that neighbour. One that has no proper face around it draws no line at all.
      - Faces with the same three corners count as one: duplicate_face_count tells how many were left out. Where both
        windings occur (a sheet modelled from both sides) the face is two-sided: its winding is chosen to agree with its
        neighbours, so that the sheet has silhouettes where it turns away and boundary lines where it ends; its creases
        are lines seen from either side.
      - Neighbours are assumed to be consistently wound. A pair that is not counts in flipped_edge_count, and the rule
        above is applied as the windings stand: the edge between is a silhouette when both sides can be seen.
      - An edge of three or more faces is SIL_NONMANIFOLD, and SIL_SILHOUETTE as well when one of its faces is
        front and another back. Nothing depends on the order of the faces.
        With SIL_MESH_ORIENT in desc.flags faces are wound as their neighbours across edges of two faces are, first of
        all: closed sets of faces outward, those in an odd number of other closed ones (cavities) inward, open sets as
        most of their area was. reversed_face_count tells how many were turned. Where that cannot be done everywhere (a
        Moebius strip) some flipped edges remain, the same for every order of the faces.
      - An edge of one face is SIL_BOUNDARY, in every view.
      - T-junctions: with t_junction_distance > 0 an edge of one face is cut at the vertices of other such edges that lie
        within that distance of it and further than that from its ends. Its pieces then meet their mates, and are no
        borders any more: t_junction_count tells how many cuts were made. A face that was cut stays one face: its
        pieces have its number in sil_edge.face, all take the sign of the largest of them, and nothing is a line between
        them (edge_count counts those edges). Vertices closer to each other than that are for weld_distance.
      - Slivers: with the same distance, faces whose height above their longest edge is not more than it are as faces
        whose corners lie on a line: above. They are not cut.
      - Parts: with face_parts an edge whose faces are not all of one part is SIL_PART_BORDER. Of triangles with the same
        corners the part of the kept one (the first) counts.
      - A mesh without any face is fine, and has no lines. An index_count that is no multiple of 3 is an error.

    RECIPES
      - All lines of a drawing: kinds SIL_SILHOUETTE | SIL_BOUNDARY | SIL_CREASE, then sil_chain, then sil_ribbons.
      - Lines hidden by the surface they lie on: draw ribbons with the depth test at depth minus one to two times slack.
      - Transparency that depends on the view (Diepstraten 2002, equation 2): alpha = 1 - pow(distance /
        sil_max_distance, k). Pixel by pixel and without seams at triangle edges: sil_candidates gives each triangle the
        edges that can be nearest within it, for a shader to take the least distance to.
      - Silhouettes of a large mesh that does not move: rest positions (a pose that is not set, or none); it is what the
        hierarchy needs. What changed since the last frame: sil_track.
      - Distances for many vertices in every frame: one sil_edge_tree, built after sil_extract, then ranges of vertices
        by sil_distances_by_tree in as many threads as there are. sil_distances is for few edges or few vertices.
      - Lines that flicker where a scanned or tessellated surface is seen edge-on: sil_pose_set_dead_zone, of a degree
        or two more than the noise of the normals.
      - A CAD model with cracks and needles: t_junction_distance of 1e-5 of its size, and SIL_MESH_ORIENT.
      - An animated character: one sil_pose an instance; sil_pose_set after skinning.
      - Hidden lines dashed: the ribbons once more with dashes, drawn where the depth test fails (transparency.h:
        TR_LINES_HIDDEN).
      - Things with sharp edges, lit from a side: sil_chain_corners by 60 degrees, then SIL_WEIGHT_LIGHT.
      - A scanned or modelled surface without sharp edges: sil_smooth, with SIL_SMOOTH_HERMITE, in place of
        SIL_SILHOUETTE; boundaries by sil_extract. Or SIL_CHAIN_NO_CONCAVE, against the hooks of silhouettes at cusps.
      - Dashes in a shader: discard where fmod(arc, period) > on. Arc is counted in pixels along a strip.

    LIMITS AND PRECISION
      - At most 2^32 - 2 vertices and 2^28 - 1 triangles.
      - Positions are float. Only lines' places on the screen, distances and dihedral angles are rounded, not the
        decision which edges are lines.
      - Crease angles are those of the rest positions, in a pose as well, and so are the faces without area.
      - In a pose, faces with a vertex that is not finite are back faces, and edges that end there are left out.
*/
#ifndef SILHOUETTE_H
#define SILHOUETTE_H

#include <stddef.h>
#include <stdint.h>

#define SIL_VERSION "0.2.0"
#define SIL_VERSION_NUMBER 200 /* major * 10000 + minor * 100 + patch */

#ifndef SIL_DEF
#ifndef SIL_STATIC
#define SIL_DEF extern
#elif defined(__GNUC__) || defined(__TINYC__)
#define SIL_DEF static __attribute__((unused))
#else
#define SIL_DEF static
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What functions return and what messages are about: name, text. The last two are messages only, never returned. */
#define SIL_RESULTS(X)                                                                                                 \
    X(SIL_OK, "no error")                                                                                              \
    X(SIL_INVALID_ARGUMENT, "an argument is missing, not finite or out of its range")                                  \
    X(SIL_INCOMPLETE_TRIANGLE, "the number of indices is not a multiple of three")                                     \
    X(SIL_TOO_LARGE, "more vertices or triangles than 32-bit indices or the address space can hold")                   \
    X(SIL_OUT_OF_MEMORY, "the allocator returned NULL")                                                                \
    X(SIL_DROPPED_FACES, "faces with a vertex that is not finite or an index out of range were left out")              \
    X(SIL_FLIPPED_EDGES, "neighbouring faces are wound in opposite senses; lines between them may be wrong")

typedef enum sil_result {
#define SIL_I_ENUMERATOR(name, text) name,
    SIL_RESULTS(SIL_I_ENUMERATOR)
#undef SIL_I_ENUMERATOR
        SIL_RESULT_COUNT
} sil_result;

/* The text of a result in English; never NULL. */
SIL_DEF const char *sil_result_string(sil_result result);

/* "No such index", in every field that is a 32-bit index. */
#define SIL_NONE 0xffffffffu

/* Kinds of lines, as bits: which are asked for, which an edge is. */
enum {
    SIL_SILHOUETTE = 1,  /* between a front face and a back face */
    SIL_BOUNDARY = 2,    /* edge of one face */
    SIL_CREASE = 4,      /* dihedral angle above crease_degrees; in a view: both faces in front, no silhouette */
    SIL_NONMANIFOLD = 8, /* edge of three or more faces */
    SIL_PART_BORDER = 64 /* between faces of different parts; in a view: both faces in front, no silhouette */
};
/* More about an edge of two faces, in sil_edge.kinds only: cannot be asked for, and makes no difference to strips. Exact,
   from the rest positions: each face's third corner lies behind or before the other's plane. Neither: in the plane, or
   without area, two-sided, or wound in opposite senses. A silhouette that is concave is never visible: the faces on both
   sides of it hide it. */
enum { SIL_CONVEX = 16, SIL_CONCAVE = 32 };

enum { SIL_LOG_ERROR = 1, SIL_LOG_WARNING = 2 }; /* level of a message */
typedef void (*sil_log_fn)(int level, int code, const char *text, void *user);

/* Flags of a mesh. */
enum {
    SIL_MESH_NO_HIERARCHY = 1, /* never one */
    SIL_MESH_HIERARCHY = 2,    /* one, however small the mesh is */
    SIL_MESH_ORIENT = 16       /* wind faces as their neighbours are, and solids outward (DIRTY MESHES) */
};

/* Both functions or neither. alloc_fn returns memory aligned for any type, or NULL. */
typedef struct sil_allocator {
    void *(*alloc_fn)(size_t size, void *user);
    void (*free_fn)(void *memory, void *user);
    void *user;
} sil_allocator;

typedef struct sil_mesh_desc {
    const float *positions; /* x, y, z of each vertex; copied */
    size_t position_stride; /* bytes from one vertex to the next; 0: 12, tightly packed */
    size_t vertex_count;
    const uint32_t *indices; /* three a triangle; NULL (with index_count 0): vertices 0 1 2, 3 4 5, ... are triangles */
    size_t index_count;
    float weld_distance;  /* 0: weld equal positions; > 0: weld within that distance; < 0: do not weld */
    float crease_degrees; /* 0: 30. Dihedral angle above which an edge is a crease; < 0: every edge that is not flat */
    sil_allocator allocator;
    sil_log_fn log_fn; /* NULL: no messages */
    void *log_user;
    unsigned flags;             /* 0: a hierarchy (see THE HIERARCHY) where the mesh has 4,000 edges or more */
    float t_junction_distance;  /* > 0: borders are cut at vertices of other borders within that distance, so that they
                                   meet, and faces thinner than it count as without area. In units of the positions */
    const uint32_t *face_parts; /* one a triangle, any numbers: for SIL_PART_BORDER. NULL: there are no parts */
} sil_mesh_desc;

typedef struct sil_mesh_info {
    size_t vertex_count;           /* as given */
    size_t unique_vertex_count;    /* after welding, unreferenced ones included */
    size_t face_count;             /* kept */
    size_t edge_count;             /* edges of kept faces; sil_edge.edge is below this */
    size_t boundary_edge_count;    /* edges of one face */
    size_t nonmanifold_edge_count; /* edges of three or more faces */
    size_t crease_edge_count;      /* edges of two faces with a dihedral angle above crease_degrees */
    size_t degenerate_face_count;  /* faces without area: those left out and those kept */
    size_t duplicate_face_count;   /* faces left out because another has the same corners */
    size_t two_sided_face_count;   /* kept faces that were given in both windings */
    size_t flipped_edge_count;     /* edges of two faces that are wound in opposite senses */
    size_t dropped_face_count;     /* faces left out because of an index out of range or a vertex that is not finite */
    size_t t_junction_count;       /* places where a border was cut at a vertex, for t_junction_distance */
    size_t part_border_edge_count; /* edges between faces of different parts */
    size_t reversed_face_count;    /* faces that SIL_MESH_ORIENT turned round */
    size_t component_count;        /* sets of faces connected by edges */
    size_t bytes;                  /* memory held by the mesh */
    size_t hierarchy_bytes;        /* of these the hierarchy's; 0: there is none */
    int closed;                    /* 1: there are faces, and every edge has an even number of them */
} sil_mesh_info;

typedef struct sil_mesh sil_mesh;
typedef struct sil_pose sil_pose;

/* Topology and rest positions, from arrays that are not needed afterwards. NULL on error, with the reason in *result
   (which may be NULL): SIL_INVALID_ARGUMENT, SIL_INCOMPLETE_TRIANGLE, SIL_TOO_LARGE, SIL_OUT_OF_MEMORY. */
SIL_DEF sil_mesh *sil_mesh_create(const sil_mesh_desc *desc, sil_result *result);
SIL_DEF void sil_mesh_destroy(sil_mesh *mesh); /* NULL is fine; no pose of it may be in use any more */
SIL_DEF sil_mesh_info sil_mesh_get_info(const sil_mesh *mesh);

/* Which component each of the caller's first triangle_count triangles is in: a number below component_count (sets of
   faces connected by edges, in an order that does not depend on that of the triangles), SIL_NONE for those left out.
   Allocates and frees in the call. SIL_INVALID_ARGUMENT, SIL_OUT_OF_MEMORY. */
SIL_DEF sil_result sil_mesh_components(const sil_mesh *mesh, uint32_t *components, size_t triangle_count);

/* A mesh, or one component of it, at a place in the world, in its rest positions. Parts may share meshes. */
typedef struct sil_part {
    const sil_mesh *mesh;
    float transform[16]; /* mesh to world, column-major, affine; mirrored is fine. All zero: the identity */
    uint32_t component;  /* 0: the whole mesh; n + 1: only its component n */
} sil_part;

enum {
    SIL_PART_CLOSED = 1,   /* all its components are closed: each edge has an even number of faces */
    SIL_PART_ENCLOSES = 2, /* it encloses another part */
    SIL_PART_CROSSES = 4   /* it is partly within another part, or another partly within it: no parent by that one */
};

/* Which part encloses which: B is within A if all of it is within closed components of A, in cavities of A as well. In
   parents[i] the innermost part around part i, or SIL_NONE; following parents ends. In facts[i] (may be NULL) the bits
   above. A part without SIL_PART_CLOSED may have an inside that is not known: only its closed components enclose.
   Windings do not matter. Points of B are tried, corners and middles of faces, `samples` of each component (0: 24;
   larger numbers up to SIZE_MAX: all), each by three rays counted in exact arithmetic, of which most decide, so that
   small cracks do not. Points in the surface of A say nothing. What no point shows is not noticed: a thin rod through a
   part. Points are rounded to float in the coordinates of A's mesh. Trees over parts and faces: the cost is nearly
   linear. Memory is allocated by the first part's mesh, and freed, in the call. SIL_INVALID_ARGUMENT: NULL, a component
   that is not there, a transform that is not finite; SIL_TOO_LARGE: 2^32 - 1 parts or more; SIL_OUT_OF_MEMORY. */
SIL_DEF sil_result sil_containment(const sil_part *parts, size_t part_count, size_t samples, uint32_t *parents,
                                   uint32_t *facts);

/* What changes: posed positions, the faces' signs of the last view, scratch memory. Starts in the rest positions. */
SIL_DEF sil_pose *sil_pose_create(const sil_mesh *mesh, sil_result *result);
SIL_DEF void sil_pose_destroy(sil_pose *pose); /* before its mesh; NULL is fine */
/* New positions, one for each of the mesh's vertices (stride in bytes, 0: 12); copied. Welded vertices follow the one
   with the smallest index. NULL: back to the rest positions. SIL_INVALID_ARGUMENT, SIL_OUT_OF_MEMORY (nothing changed).
   */
SIL_DEF sil_result sil_pose_set(sil_pose *pose, const float *positions, size_t stride);
/* Makes room for sil_chain and sil_track with so many edges (each once), so that they allocate nothing later. */
SIL_DEF sil_result sil_pose_reserve(sil_pose *pose, size_t edge_count);

/* A dead zone for all later views of the pose: a face whose plane is within an angle of the line of sight to the middle
   of its corners counts as back, or, with SIL_ZONE_REMEMBER, keeps the sign that it had when it was last outside of the
   zone (back, if it never was). It stills the noise of surfaces seen edge-on, such as a pipe looked down. Faces are
   still told apart once each, so that loops stay closed; faces outside of the zone have their exact signs, only where
   the zone ends is rounded. sine: of that angle, below 1; 0: no zone, the default. Each call forgets. The flat scan is
   used then, not the hierarchy. Allocates when first asked to remember. SIL_INVALID_ARGUMENT, SIL_OUT_OF_MEMORY (nothing
   changed). */
enum { SIL_ZONE_REMEMBER = 1 };
SIL_DEF sil_result sil_pose_set_dead_zone(sil_pose *pose, double sine, unsigned flags);

/* The eye in the mesh's own coordinates: {x, y, z, 1} a point, {x, y, z, 0} a direction from the mesh toward the eye.
   */
typedef struct sil_view {
    double eye[4];
} sil_view;

SIL_DEF sil_view sil_view_perspective(const double eye[3]);
SIL_DEF sil_view sil_view_orthographic(const double toward_eye[3]);
/* From the matrices a scene is drawn with, for any invertible affine model_view (scaled, sheared, mirrored) and any
   projection whose eye space looks down -z. In a mirrored model_view GL's sense of front faces is swapped; ours is not:
   it is that of the mesh. SIL_INVALID_ARGUMENT: a matrix is singular or not finite; *view then sees only backs. */
SIL_DEF sil_result sil_view_from_matrices(const float model_view[16], const float projection[16], sil_view *view);

typedef struct sil_edge {
    uint32_t a, b;    /* the caller's vertices; where a face is in front, a front face is on the left of a -> b */
    uint32_t face[2]; /* the caller's triangles (index / 3): face[0] on the left; face[1] may be SIL_NONE. Of an edge of
                         three or more faces: a front one and a back one where there are both, else the first two */
    uint32_t edge;    /* index of the edge, below edge_count; the same in every view and for every order of the faces */
    uint32_t kinds;   /* all that this edge is in this view, asked for or not */
} sil_edge;

/* The edges that are of one of the kinds asked for, by rising `edge`. pose: NULL for the rest positions (needs no
   memory; slower without a hierarchy). view: NULL for what does not depend on the eye: boundaries, non-manifold edges and all
   creases. */
SIL_DEF size_t sil_extract(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, unsigned kinds, sil_edge *edges,
                           size_t capacity);

/* What sil_track tells: numbers of edges (sil_edge.edge), rising, in arrays of the caller's. */
typedef struct sil_changes {
    uint32_t *entered, *left;         /* NULL: only counted */
    size_t capacity;                  /* of each array */
    size_t entered_count, left_count; /* set by sil_track; may be above the capacity: the rest is not written */
} sil_changes;

/* sil_extract, and which edges entered and left the set since the pose's last sil_track, whatever the views, positions
   and kinds were then; before the first it is empty. When the edges do not fit the call only counts: the changes are
   zero, and the next call tells them. The pose keeps the numbers of the edges; memory for that only grows, and
   sil_pose_reserve makes it large enough at once. pose must not be NULL. 0 with both counts SIZE_MAX: out of memory,
   nothing changed. */
SIL_DEF size_t sil_track(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, unsigned kinds, sil_edge *edges,
                         size_t capacity, sil_changes *changes);

typedef struct sil_strip {
    uint32_t first, count; /* range in the vertex array; a closed strip repeats its first vertex at the end */
    uint32_t id;           /* smallest `edge` in it: the same while that edge remains in it */
    uint32_t kinds;        /* of all its edges */
    uint32_t closed;       /* 1: a loop */
} sil_strip;

/* Edges to strips. At a vertex a silhouette goes on where the front faces around it end: one successor, and loops do
   not cross. Other lines, and silhouettes where that way is barred, go on where exactly two ends of the same kinds
   meet. Every edge is in one strip; edges given twice count once; edges that are not of this mesh are left out. The
   result, strips by rising id, does not depend on the order of the edges. Silhouettes have front faces on their left if
   the mesh is wound consistently. Returns the number of strips; *vertices_needed (may be NULL) is the number of
   vertices. Vertices past vertex_capacity are not written: when *vertices_needed is larger, the strips' ranges go past
   the array. 0 with *vertices_needed = SIZE_MAX: out of memory. */
SIL_DEF size_t sil_chain(const sil_mesh *mesh, sil_pose *pose, const sil_edge *edges, size_t edge_count,
                         sil_strip *strips, size_t strip_capacity, uint32_t *vertices, size_t vertex_capacity,
                         size_t *vertices_needed);

enum { SIL_CHAIN_NO_CONCAVE = 1 }; /* flag: silhouettes that are concave are left out; they are never visible */

typedef struct sil_chain_desc {
    float corner_degrees; /* strips end where they turn by more than this; 0: nowhere */
    float matrix[16]; /* turns are those after it. Without a viewport: affine, a model matrix for turns in the world;
                             all zero: the mesh's own coordinates */
    float viewport_width, viewport_height; /* > 0: matrix is projection * model_view, turns are those on the screen */
    unsigned flags;
} sil_chain_desc;

/* sil_chain with corners: where dashes and tapers begin anew, and where a line that doubles back is cut. Every other
   property stays, ids too. desc NULL: sil_chain. A desc that is not finite has no corners. On the screen a vertex that
   is not before the eye is no corner; nor is one where an edge has no length. */
SIL_DEF size_t sil_chain_corners(const sil_mesh *mesh, sil_pose *pose, const sil_chain_desc *desc,
                                 const sil_edge *edges, size_t edge_count, sil_strip *strips, size_t strip_capacity,
                                 uint32_t *vertices, size_t vertex_capacity, size_t *vertices_needed);

/* Smooth silhouettes: where interpolated normals are at right angles to the view, through the inside of faces. What a
   smooth surface's silhouette would be, without the zigzag and the hooks of edges; but it lies inside of the mesh's own
   outline by up to the sagitta of an edge, and is hidden by the mesh in places: draw it with a depth test that forgives
   as much. */
typedef struct sil_smooth_point {
    float position[3]; /* in the mesh's coordinates */
    float normal[3];   /* interpolated, of length 1; zero where the normals cancel each other */
    uint32_t edge;     /* the edge that is crossed, */
    uint32_t a, b;     /* from the caller's vertex a to b */
    float t;           /* at this part of it, 0 to 1 */
} sil_smooth_point;

/* Flag of sil_smooth: points not on the edge but on a cubic curve over it that is at right angles to the normals at both ends: much
   closer to a smooth surface */
enum { SIL_SMOOTH_HERMITE = 1 };

/* normals: one a vertex, any length (stride in bytes, 0: 12); welded vertices have the sum of theirs made unit. NULL:
   made from the faces in this pose, exact on spheres (Max 1999). n * (eye - position) is taken to be linear along
   edges; zero counts as positive, so that each face has no crossing or two, and a mesh whose edges all have two faces
   has closed loops in every view. Strips are ranges of points, for sil_ribbons without `vertices` (desc.points =
   points[0].position, desc.point_stride = sizeof *points); closed ones repeat their first point; positive normals lie
   on the left. They end at edges of one face and of three and more. Ids, kinds (SIL_SILHOUETTE) and order as in
   sil_chain: by the smallest edge crossed, but for the order, which is by the smallest face. Scratch memory as in
   sil_chain: 32 bytes a vertex and 1 a face. Returns the number of strips; *points_needed (may be NULL) is that of the
   points. No eye, one that is not finite: none. 0 with *points_needed = SIZE_MAX: out of memory. */
SIL_DEF size_t sil_smooth(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, const float *normals,
                          size_t normal_stride, unsigned flags, sil_smooth_point *points, size_t point_capacity,
                          sil_strip *strips, size_t strip_capacity, size_t *points_needed);

enum { SIL_DISTANCE_INFINITE_LINE = 1 }; /* to the endless line through each edge (Diepstraten 2002), not to the edge */

typedef struct sil_distance_desc {
    float model[9]; /* mesh to world, column-major: distances are in world units. All zero: the identity */
    unsigned flags;
} sil_distance_desc;

/* Distance of vertices first_vertex .. first_vertex + vertex_count - 1 (the caller's) to the nearest of a set of edges,
   and that edge's index in `edges` (nearest may be NULL). Equal distances: the one with the smallest `edge`. No edges:
   +infinity and SIL_NONE; the same for a vertex that is not finite. Unreferenced vertices have distances like others.
   Welded vertices have that of the one with the smallest index. An edge of no length is a point. A singular matrix
   gives distances in the flattened space. Errors are below 1e-6 of the mesh's size in the world. SIL_INVALID_ARGUMENT:
   NULL, a range out of bounds, a matrix that is not finite. */
SIL_DEF sil_result sil_distances(const sil_mesh *mesh, const sil_pose *pose, const sil_edge *edges, size_t edge_count,
                                 const sil_distance_desc *desc, size_t first_vertex, size_t vertex_count,
                                 float *distances, uint32_t *nearest);

/* The same distances without trying every pair: a tree over the edges of one frame. The results are those of
   sil_distances to the bit, but for the flag SIL_DISTANCE_INFINITE_LINE, which a tree does not take. */
typedef struct sil_edge_tree sil_edge_tree;
SIL_DEF sil_edge_tree *sil_edge_tree_create(const sil_mesh *mesh, sil_result *result);
SIL_DEF void sil_edge_tree_destroy(sil_edge_tree *tree); /* before its mesh; NULL is fine */
/* Makes room for so many edges (each once), so that building allocates nothing later. */
SIL_DEF sil_result sil_edge_tree_reserve(sil_edge_tree *tree, size_t edge_count);
/* Over these edges in the pose's positions; edges are not needed afterwards, mesh and pose are. Build again after the
   pose was set. SIL_INVALID_ARGUMENT, SIL_OUT_OF_MEMORY: the tree is empty then. */
SIL_DEF sil_result sil_edge_tree_build(sil_edge_tree *tree, const sil_pose *pose, const sil_edge *edges,
                                       size_t edge_count, const sil_distance_desc *desc);
SIL_DEF size_t sil_edge_tree_bytes(const sil_edge_tree *tree); /* memory held by it */
/* As sil_distances, from the tree as last built. Only reads it: threads may share one. SIL_INVALID_ARGUMENT also for a
   tree that was never built. */
SIL_DEF sil_result sil_distances_by_tree(const sil_edge_tree *tree, size_t first_vertex, size_t vertex_count,
                                         float *distances, uint32_t *nearest);
/* The same for any points, in the mesh's own coordinates (stride in bytes, 0: 12): of a mesh divided more finely, of
   something near it. Points that follow each other should be close to each other. Not finite: +infinity, SIL_NONE. */
SIL_DEF sil_result sil_distances_at(const sil_edge_tree *tree, const float *points, size_t stride, size_t count,
                                    float *distances, uint32_t *nearest);

/* The edges of the tree, as indices in the `edges` that it was built from, in an order in which neighbours are close to
   each other: for hierarchies of others over boxes of consecutive edges. Those with an end that is not finite are left
   out. Returns how many there are; as many as fit into capacity are written. 0 for a tree that was never built. */
SIL_DEF size_t sil_edge_tree_order(const sil_edge_tree *tree, uint32_t *order, size_t capacity);

/* For each triangle, the edges of the tree that can be the nearest to some point of it: the least distance to these is,
   anywhere within the triangle, that to all edges, but for 1e-6 of the mesh's size. So a fragment shader finds exact
   distances from a short list that the triangle carries. triangle_count triangles of positions in the mesh's own
   coordinates (stride in bytes, 0: 12; vertex_count of them), three indices each, or NULL for 0 1 2, 3 4 5, ...; not
   necessarily the mesh's own, and any part of them: threads may share one tree, each with a range of its own.
   offsets: triangle_count + 1 numbers; the candidates of triangle i, as indices in the `edges` that the tree was built
   from, are candidates[offsets[i]] ... candidates[offsets[i + 1] - 1], in an order that depends on the tree alone. What
   fits into capacity is written, offsets always; *needed is how many there are. A triangle with an index out of range
   or a corner that is not finite has none; one with a corner further away than 10^12 sizes of the mesh has all.
   SIL_INVALID_ARGUMENT: NULL, a tree that was never built. SIL_TOO_LARGE: more than 2^32 - 1 candidates; ask for fewer
   triangles at a time. */
SIL_DEF sil_result sil_candidates(const sil_edge_tree *tree, const float *positions, size_t stride, size_t vertex_count,
                                  const uint32_t *indices, size_t triangle_count, uint32_t *offsets,
                                  uint32_t *candidates, size_t capacity, size_t *needed);

/* Largest distance between the centre of the mesh and its vertices, in world units: d_object,max of Diepstraten 2002,
   equation 2. The centre is that of the bounding box, along the mesh's axes, of the vertices of the kept faces.
   model: as above; NULL for the identity. 0 for a mesh without faces. */
SIL_DEF float sil_max_distance(const sil_mesh *mesh, const sil_pose *pose, const float model[9]);

typedef struct sil_ribbon_vertex {
    float x, y;               /* pixels from the viewport's lower left corner */
    float depth;              /* window depth in [0,1] */
    float slack;              /* change of window depth per motion of one pixel's size toward the eye here, >= 0 */
    float center_x, center_y; /* the point of the centre line that this vertex belongs to, pixels */
    float arc;                /* pixels along the strip; starts again from 0 every 2^20 pixels, between two segments */
    uint32_t kinds;           /* of the strip */
} sil_ribbon_vertex;

typedef enum sil_cap { SIL_CAP_ROUND = 0, SIL_CAP_BUTT, SIL_CAP_SQUARE } sil_cap;     /* ends of a strip */
typedef enum sil_join { SIL_JOIN_ROUND = 0, SIL_JOIN_BEVEL, SIL_JOIN_NONE } sil_join; /* between two segments */

/* Which lines are heavy: the illustrators' conventions (Gooch 1999, 3.1 and 5.1.3). See LINE WEIGHTS. */
typedef enum sil_weight {
    SIL_WEIGHT_ONE = 0,     /* all alike */
    SIL_WEIGHT_THICK_THIN,  /* heavy where only one of the faces at the line can be seen: silhouettes and boundaries */
    SIL_WEIGHT_OUTER,       /* heavy where the line borders the background of `image` */
    SIL_WEIGHT_PERSPECTIVE, /* heavy in the foreground, thin in the distance */
    SIL_WEIGHT_LIGHT        /* silhouettes and boundaries thin toward the light, heavy away from it */
} sil_weight;

enum { SIL_IMAGE_REVERSED = 1 }; /* flag of an image: background has depth 0 */

/* What the host has drawn, read back; it covers the viewport, in any number of pixels. Rows upward, as GL gives them.
   Either depth (background: 1 and above) or, where depth is NULL, ids. */
typedef struct sil_image {
    const float *depth;
    const uint32_t *ids;
    uint32_t background; /* the id of pixels where nothing is */
    uint32_t width, height;
    size_t stride; /* elements from a row to the next; 0: width */
    unsigned flags;
} sil_image;

enum { SIL_RIBBON_ZERO_TO_ONE = 1 }; /* clip space has 0 <= z <= w, as after glClipControl; default: -w <= z <= w */

typedef struct sil_ribbon_desc {
    float model_view[16], projection[16]; /* reversed depth and infinite far planes are fine */
    float viewport_width, viewport_height;
    float width;          /* pixels; 0: 1.5; at most 4096, factors included */
    float width_scale[5]; /* times this for silhouettes, boundaries, creases, non-manifold edges, part borders; 0: 1. A
                             line of several kinds has that of the first */
    float tolerance;      /* pixels that round caps and joins may lie inside the true circle; 0: 0.1 */
    sil_cap cap;
    sil_join join;
    unsigned flags;
    sil_weight weight;
    float heavy, thin; /* factors of the width, for `weight`; 0: 2 and 1 */
    float light[2];    /* WEIGHT_LIGHT: on the screen, right and up, toward the light; both 0: from the upper left */
    float reach[2];    /* WEIGHT_PERSPECTIVE: distances from the eye, along its view, at which lines are heavy and
                               thin; both 0: those of the box around the mesh in this pose, nearest and farthest corner */
    const sil_image *image; /* WEIGHT_OUTER */
    const float *widths;    /* a further factor for each strip vertex, as many as `vertices`; NULL: 1. Negative and not
                               finite: 0 */
    float taper;            /* pixels over which the ends of open strips grow from nothing; 0: none */
    const float *dashes;    /* pixels drawn, left out, drawn, ...; NULL: all is drawn. See DASHES */
    size_t dash_count;      /* even, at most 64 */
    const float *phases;    /* one a strip: where in the dashes it begins, pixels; NULL: 0 */
    const float *along;     /* where in the dashes each strip vertex is, as many as `vertices`, in place of arc length
                               plus phase: see sil_dashes; NULL: none */
    const float *points;    /* strips over these places, three floats each, instead of over the mesh's vertices: see
                               sil_smooth. mesh may be NULL then */
    size_t point_stride, point_count; /* bytes, 0: 12 */
} sil_ribbon_desc;

/* Strips to triangles, three vertices each, in the mesh's rest or posed positions. Triangles of one line overlap at
   joins (draw them opaque, or once each by stencil) but leave no gap. Lines are clipped to the depth range, and to the
   viewport widened by the line's width: a cut outside the viewport has a cap where it cannot be seen. Neither order nor
   winding of the triangles means anything. vertices: the array that the strips were made into; NULL, with points:
   strips are ranges of points. Widths change linearly on the screen between two vertices. Ranges, vertices, matrices
   and dashes that make no sense draw nothing. Whole triangles are written while there is room. */
SIL_DEF size_t sil_ribbons(const sil_mesh *mesh, const sil_pose *pose, const sil_strip *strips, size_t strip_count,
                           const uint32_t *vertices, const sil_ribbon_desc *desc, sil_ribbon_vertex *out,
                           size_t capacity);

/* Dashes that stay where they are while the contour moves. Arc length has no fixed origin on a silhouette: strips begin
   elsewhere, join and part from frame to frame, and dashes counted from their begin jump. A sil_dashes remembers where
   in the dashes each place of the lines was; in the next frame each strip vertex takes over what the nearest line of
   the same kinds had, where that line's places in the mesh are now seen. Toward even dashes it then moves by no more
   than half of what the contour moved there on the screen, so that a dash slides less than the contour under it, and
   not at all in a still picture. One for each mesh instance. */
typedef struct sil_dashes sil_dashes;
SIL_DEF sil_dashes *sil_dashes_create(const sil_allocator *allocator, sil_result *result); /* NULL: malloc, free */
SIL_DEF void sil_dashes_destroy(sil_dashes *dashes);                                       /* NULL is fine */
SIL_DEF void sil_dashes_forget(sil_dashes *dashes); /* as if new: after a jump of the camera */
/* Fills `along` for sil_ribbons, as many floats as `vertices` (or, with points and no vertices, as the strips' ranges
   go): the arguments are those of sil_ribbons, with the dashes in desc; desc.along and desc.phases are not read. Once a
   frame. Lines that were not there before begin anew, and so does a strip whose dashes would be stretched or squeezed
   by more than half. Memory only ever grows. SIL_INVALID_ARGUMENT (as where sil_ribbons draws nothing, or without
   dashes), SIL_OUT_OF_MEMORY: `along` is then of no use. */
SIL_DEF sil_result sil_dashes_follow(sil_dashes *dashes, const sil_mesh *mesh, const sil_pose *pose,
                                     const sil_strip *strips, size_t strip_count, const uint32_t *vertices,
                                     const sil_ribbon_desc *desc, float *along);

#ifdef __cplusplus
}
#endif
#endif /* SILHOUETTE_H */

#ifdef SILHOUETTE_IMPLEMENTATION
#ifndef SILHOUETTE_IMPLEMENTATION_ONCE
#define SILHOUETTE_IMPLEMENTATION_ONCE

#include <math.h>
#include <string.h>

#if defined(SIL_MALLOC) != defined(SIL_FREE)
#error "silhouette.h: define both SIL_MALLOC and SIL_FREE or neither"
#endif
#ifndef SIL_MALLOC
#include <stdlib.h>
#define SIL_MALLOC(size) malloc(size)
#define SIL_FREE(memory) free(memory)
#endif
#ifndef SIL_ASSERT
#define SIL_ASSERT(condition) ((void)0)
#endif

/* Vector code is made for machines that have AVX2, and used where this one does; SIL_NO_SIMD leaves it out. Both ways
   give the same bits. Not with gcc for Windows, whose stack is not aligned for vectors of 32 bytes. */
#if !defined(SIL_NO_SIMD) && (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__) && !defined(__TINYC__) && \
    (!defined(_WIN32) || defined(__clang__))
#include <immintrin.h>
#define SIL_I_WIDE __attribute__((target("avx2,bmi")))
#endif
#ifdef SIL_I_WIDE
#define SIL_I_INLINE static inline __attribute__((always_inline)) /* becomes vector code within vector code only */
#else
#define SIL_I_INLINE static
#endif

#define SIL_I_BLOCK 64u     /* faces or edges handled at a time; arrays of them are padded to a multiple of it */
#define SIL_I_LANES 8u      /* segments whose distances are computed at a time */
#define SIL_I_LEVELS 12     /* of a tree: 8^12 leaves are more than there can be */
#define SIL_I_MANY 128u     /* in edge_kinds: the edge has more than two faces, listed in many_* */
#define SIL_I_LINES 79u     /* the kinds that can be asked for */
#define SIL_I_FOLDS 48u     /* SIL_CONVEX and SIL_CONCAVE */
#define SIL_I_TWO_SIDED 1u  /* in face_flags */
#define SIL_I_NO_AREA 2u    /* in face_flags: corners exactly on a line, or nearer to one than t_junction_distance */
#define SIL_I_PIECE 4u      /* in face_flags: of a face that was cut, not the one whose sign they all take */
#define SIL_I_BORROWS 6u    /* in face_flags: takes the sign of another face */
#define SIL_I_NO_SHADOW 32u /* in face_flags, and 64, 128: plainly edge-on along x, y, z in the rest positions */
#define SIL_I_PI 3.14159265358979323846

/* Positions and what follows from them: one in the mesh (rest), one in a pose that was set. */
typedef struct sil_i_shape {
    float *position;    /* x y z of each welded vertex; zero where it is not finite */
    unsigned char *bad; /* 1: not finite */
    float *plane[4];    /* unit normal and offset of each face, about the centre and divided by scale; all 0: unknown */
    double low[3], high[3];  /* box of the vertices that faces have */
    double center[3], scale; /* |position - center| <= scale on each axis; scale is a power of two */
    size_t bad_count;
} sil_i_shape;

struct sil_mesh {
    sil_allocator allocator;
    sil_mesh_info info;
    size_t vertex_count, unique_count, face_count, edge_count;
    uint32_t *welded;          /* the caller's vertex -> welded vertex */
    uint32_t *origin;          /* welded vertex -> smallest of the caller's */
    unsigned char *referenced; /* welded vertices: 1 where a kept face has it */
    uint32_t *corner;          /* three welded vertices a face */
    uint32_t *source;          /* face -> the caller's triangle */
    unsigned char *face_flags;
    uint32_t *face_edge;    /* three a face: edge from corner i to corner i + 1 */
    uint32_t *edge_vertex;  /* two welded vertices an edge, the smaller first */
    uint32_t *edge_face[2]; /* the edge's first two faces; the same one twice where it has one */
    unsigned char *edge_kinds;
    uint32_t *flat_face,
        *flat_root; /* faces with SIL_I_BORROWS, rising, and the face whose sign each takes, or SIL_NONE */
    size_t flat_count, piece_count;
    uint32_t *many_edge, *many_first, *many_face; /* edges with SIL_I_MANY, rising, and their faces */
    size_t many_count;
    sil_i_shape rest;
    struct sil_i_patches *patches;
    struct sil_i_hierarchy *hierarchy; /* NULL: none */
    int wide;                          /* does this machine have the instructions of SIL_I_WIDE? */
};

struct sil_pose {
    const sil_mesh *mesh;
    unsigned char *front; /* of each face in the last view: 1 in front */
    size_t looked;        /* patches that the hierarchy left to look at in the last view; 0: it was not used */
    int is_set;
    sil_i_shape shape; /* allocated by the first sil_pose_set */
    void *scratch;
    size_t scratch_size;
    uint32_t *tracked; /* edges of the last sil_track, rising */
    size_t tracked_count, tracked_capacity;
    double zone_sine;         /* 0: there is no dead zone */
    unsigned char *zone_last; /* of each face: 1 if it was in front; NULL: never asked for */
    int zone_remembers;
};

SIL_DEF const char *sil_result_string(sil_result result) {
    switch (result) {
#define SIL_I_CASE(name, text)                                                                                         \
    case name:                                                                                                         \
        return text;
        SIL_RESULTS(SIL_I_CASE)
#undef SIL_I_CASE
    case SIL_RESULT_COUNT:
        break;
    }
    return "not a sil_result";
}

/* ---- memory ---- */

/* An allocator, what was taken from it, and whether it ever failed: a row of allocations is checked once. */
typedef struct sil_i_heap {
    sil_allocator allocator;
    size_t bytes;
    int failed;
} sil_i_heap;

static void *sil_i_default_alloc(size_t size, void *user) {
    (void)user;
    return SIL_MALLOC(size);
}

static void sil_i_default_free(void *memory, void *user) {
    (void)user;
    SIL_FREE(memory);
}

static void *sil_i_take(sil_i_heap *heap, size_t count, size_t size) {
    void *memory;
    if (heap->failed || (size != 0 && count > ((size_t)-1) / size)) {
        heap->failed = 1;
        return NULL;
    }
    size *= count;
    if (size == 0)
        size = 1;
    memory = heap->allocator.alloc_fn(size, heap->allocator.user);
    if (memory)
        heap->bytes += size;
    else
        heap->failed = 1;
    return memory;
}

static uint32_t *sil_i_take_words(sil_i_heap *heap, size_t count) {
    return (uint32_t *)sil_i_take(heap, count, sizeof(uint32_t));
}

static unsigned char *sil_i_take_bytes(sil_i_heap *heap, size_t count) {
    unsigned char *bytes = (unsigned char *)sil_i_take(heap, count, 1);
    if (bytes)
        memset(bytes, 0, count);
    return bytes;
}

static void sil_i_give(const sil_allocator *allocator, void *memory) {
    if (memory)
        allocator->free_fn(memory, allocator->user);
}

static size_t sil_i_padded(size_t count) {
    return (count + SIL_I_BLOCK - 1) / SIL_I_BLOCK * SIL_I_BLOCK;
}

static int sil_i_has_wide(void) {
#ifdef SIL_I_WIDE
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi");
#else
    return 0;
#endif
}

/* ---- numbers as bits: what compiler flags cannot change ---- */

static uint32_t sil_i_float_bits(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static int sil_i_finite(float value) {
    return (sil_i_float_bits(value) & 0x7f800000u) != 0x7f800000u;
}

static int sil_i_all_finite(const float *values, int count) {
    int i;
    for (i = 0; i < count; ++i)
        if (!sil_i_finite(values[i]))
            return 0;
    return 1;
}

static float sil_i_infinity(void) {
    const uint32_t bits = 0x7f800000u;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static double sil_i_abs(double value) {
    return value < 0 ? -value : value;
}

static double sil_i_larger(double a, double b) {
    return a > b ? a : b;
}

static double sil_i_mix(double a, double b, double t) {
    return (1 - t) * a + t * b; /* exactly a and b at 0 and 1 */
}

/* A number as sign * mantissa * 2^exponent. */
typedef struct sil_i_number {
    uint64_t mantissa;
    int exponent;
    int negative;
} sil_i_number;

static sil_i_number sil_i_from_float(float value) {
    const uint32_t bits = sil_i_float_bits(value);
    const int exponent = (int)(bits >> 23 & 0xffu);
    sil_i_number number;
    number.negative = (int)(bits >> 31);
    number.mantissa = (bits & 0x7fffffu) | (exponent ? 0x800000u : 0u);
    number.exponent = (exponent ? exponent : 1) - 150;
    return number;
}

/* Without trailing zeros, so that simple numbers have short mantissas. *finite is cleared where the value is not. */
static sil_i_number sil_i_from_double(double value, int *finite) {
    sil_i_number number;
    uint64_t bits;
    int exponent;
    memcpy(&bits, &value, sizeof bits);
    exponent = (int)(bits >> 52 & 0x7ffu);
    if (exponent == 0x7ff)
        *finite = 0;
    number.negative = (int)(bits >> 63);
    number.mantissa = bits & (((uint64_t)1 << 52) - 1);
    if (exponent)
        number.mantissa |= (uint64_t)1 << 52;
    number.exponent = (exponent ? exponent : 1) - 1075;
    while (number.mantissa && !(number.mantissa & 1)) {
        number.mantissa >>= 1;
        ++number.exponent;
    }
    return number;
}

static int sil_i_bit_length(uint64_t value) {
    int length = 0;
    while (value) {
        value >>= 1;
        ++length;
    }
    return length;
}

/* Ten bits to every third one of thirty. */
static uint32_t sil_i_spread_bits(uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}

/* ---- the exact sign of a face ---- */

/* A sum of products as a fixed-point integer of 40 limbs of 32 bits, each held in 64 so that carries wait until the
   end. The lowest bit stands for 2^-672: below the least product, 2^-200 (eye) * 2^-149 * 2^-149 * 2^-149 = 2^-647. The
   greatest, 2^130 * 2^128 * 2^128 times 18 terms and 2 * 2^384 times 6, stay below 2^394; limb 40 begins at 2^608. */
#define SIL_I_LIMBS 40
#define SIL_I_LOWEST (-672)

typedef struct sil_i_sum {
    int64_t limb[SIL_I_LIMBS];
} sil_i_sum;

/* sum += f0 * f1 * ... * 2^exponent, or -= . At most four factors. */
static void sil_i_sum_add(sil_i_sum *sum, const uint32_t *factors, int count, int exponent, int negative) {
    uint32_t product[5] = {1, 0, 0, 0, 0};
    const int bit = exponent - SIL_I_LOWEST;
    int i, j, at = bit / 32, shift = bit % 32;
    SIL_ASSERT(bit >= 0 && at + 6 < SIL_I_LIMBS && count <= 4);
    for (i = 0; i < count; ++i) {
        uint64_t carry = 0;
        for (j = 0; j <= i; ++j) {
            carry += (uint64_t)product[j] * factors[i];
            product[j] = (uint32_t)(carry & 0xffffffffu);
            carry >>= 32;
        }
        product[j] = (uint32_t)carry;
    }
    for (j = 0; j <= count; ++j) {
        const uint64_t shifted = (uint64_t)product[j] << shift;
        const int64_t low = (int64_t)(shifted & 0xffffffffu), high = (int64_t)(shifted >> 32);
        sum->limb[at + j] += negative ? -low : low;
        sum->limb[at + j + 1] += negative ? -high : high;
    }
}

static int sil_i_sum_sign(const sil_i_sum *sum) {
    int64_t carry = 0;
    int i, nonzero = 0;
    for (i = 0; i < SIL_I_LIMBS; ++i) {
        const int64_t value = sum->limb[i] + carry;
        const int64_t low = (int64_t)((uint64_t)value & 0xffffffffu);
        nonzero |= low != 0;
        carry = (value - low) / 4294967296; /* exact: rounds down for negative values too */
    }
    return carry < 0 ? -1 : nonzero || carry > 0;
}

/* The eye as all faces see it: rounded once, as numbers of three sorts that are one and the same value, apart from
   plane, which is the eye for the float planes of a shape: relative to its centre and scale. */
typedef struct sil_i_eye {
    double e[4];
    sil_i_number number[4];
    float plane[4];
    float limit;    /* a face is decided by its float plane where that is further than this from 0 */
    unsigned along; /* bits of SIL_I_NO_SHADOW: all axes along which a direction goes; 0 for a point */
    int valid;
} sil_i_eye;

/* sum += p * q * t[2] * t[...], t an eye coordinate of up to 53 bits in two factors. */
static void sil_i_sum_term(sil_i_sum *sum, const sil_i_number *p, const sil_i_number *q, const sil_i_number *r,
                           const sil_i_number *t, int negative) {
    uint32_t factors[4];
    int count = 2, exponent = p->exponent + q->exponent + t->exponent;
    const uint32_t high = (uint32_t)(t->mantissa >> 32);
    if (!p->mantissa || !q->mantissa || !t->mantissa || (r && !r->mantissa))
        return;
    negative ^= p->negative ^ q->negative ^ t->negative;
    factors[0] = (uint32_t)p->mantissa;
    factors[1] = (uint32_t)q->mantissa;
    if (r) {
        factors[count++] = (uint32_t)r->mantissa;
        exponent += r->exponent;
        negative ^= r->negative;
    }
    factors[count++] = (uint32_t)(t->mantissa & 0xffffffffu);
    sil_i_sum_add(sum, factors, count, exponent, negative);
    if (high) {
        factors[count - 1] = high;
        sil_i_sum_add(sum, factors, count, exponent + 32, negative);
    }
}

/* The sign of det[b-a, c-a, e-w*a] over the input itself, where no difference was rounded:
   e . (a x b + b x c + c x a) - w * det[a, b, c]. Exact, so rotating the corners changes nothing and reversing them
   negates it. */
static int sil_i_exact_sign(const float *a, const float *b, const float *c, const sil_i_eye *eye) {
    sil_i_number p[3][3];
    sil_i_sum sum;
    int i, k;
    for (k = 0; k < 3; ++k) {
        p[0][k] = sil_i_from_float(a[k]);
        p[1][k] = sil_i_from_float(b[k]);
        p[2][k] = sil_i_from_float(c[k]);
    }
    memset(&sum, 0, sizeof sum);
    for (k = 0; k < 3; ++k) {
        const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        if (eye->number[k].mantissa)
            for (i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3;
                sil_i_sum_term(&sum, &p[i][k1], &p[j][k2], NULL, &eye->number[k], 0);
                sil_i_sum_term(&sum, &p[i][k2], &p[j][k1], NULL, &eye->number[k], 1);
            }
        sil_i_sum_term(&sum, &p[0][k], &p[1][k1], &p[2][k2], &eye->number[3], 1);
        sil_i_sum_term(&sum, &p[0][k], &p[1][k2], &p[2][k1], &eye->number[3], 0);
    }
    return sil_i_sum_sign(&sum);
}

static int sil_i_same(float a, float b) {
    const uint32_t x = sil_i_float_bits(a), y = sil_i_float_bits(b);
    return x == y || ((x | y) & 0x7fffffffu) == 0;
}

/* Is the shadow of a face along axis k plainly nothing? Two corners fall together in it, or all three are level. */
static int sil_i_no_shadow(const float *a, const float *b, const float *c, int k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const int ab[2] = {sil_i_same(a[i], b[i]), sil_i_same(a[j], b[j])};
    const int ac[2] = {sil_i_same(a[i], c[i]), sil_i_same(a[j], c[j])};
    return (ab[0] && ab[1]) || (ac[0] && ac[1]) || (sil_i_same(b[i], c[i]) && sil_i_same(b[j], c[j])) ||
           (ab[0] && ac[0]) || (ab[1] && ac[1]);
}

/* Are three points on a line: is each coordinate of the face's normal exactly zero? */
static int sil_i_collinear(const float *a, const float *b, const float *c) {
    sil_i_eye axis;
    int k;
    for (k = 0; k < 3; ++k) {
        memset(&axis, 0, sizeof axis);
        axis.number[k].mantissa = 1;
        if (sil_i_exact_sign(a, b, c, &axis) != 0)
            return 0;
    }
    return 1;
}

/* The same sign in double, or 0 where rounding might have changed it. With unit roundoff u = 2^-53: each difference of
   two floats has relative error u, a product of two of them 3u, the difference of two products 4u of the sum of their
   magnitudes; g = e - w*a has 2u of |e| + |w*a|; product and sums add 4u. In all at most 10u plus terms in u^2 of
   `size`, and 16u are allowed, since `size` is itself rounded; fused operations only round less. 2^-70 makes up for
   machines that take subnormal floats for zero: that is off by 2^-125 at most, and 2^-70 * 16u = 2^-119. */
static int sil_i_filtered_sign(const float *a, const float *b, const float *c, const sil_i_eye *eye) {
    double u[3], v[3], g[3], su[3], sv[3], sg[3], det, size, limit;
    const double tiny = 8.470329472543003e-22; /* 2^-70 */
    int k;
    for (k = 0; k < 3; ++k) {
        u[k] = (double)b[k] - (double)a[k];
        v[k] = (double)c[k] - (double)a[k];
        g[k] = eye->e[k] - eye->e[3] * (double)a[k];
        su[k] = sil_i_abs(u[k]) + tiny;
        sv[k] = sil_i_abs(v[k]) + tiny;
        sg[k] = sil_i_abs(eye->e[k]) + sil_i_abs(eye->e[3]) * (sil_i_abs((double)a[k]) + tiny);
    }
    det = (u[1] * v[2] - u[2] * v[1]) * g[0] + (u[2] * v[0] - u[0] * v[2]) * g[1] + (u[0] * v[1] - u[1] * v[0]) * g[2];
    size = (su[1] * sv[2] + su[2] * sv[1]) * sg[0] + (su[2] * sv[0] + su[0] * sv[2]) * sg[1] +
           (su[0] * sv[1] + su[1] * sv[0]) * sg[2];
    limit = size * 1.7763568394002505e-15; /* 16 * 2^-53 */
    return det > limit ? 1 : det < -limit ? -1 : 0;
}

/* Is the eye's coordinate exactly that of a corner (or, for a direction, zero)? 0 also where that is hard to tell. */
static int sil_i_eye_level(const sil_i_eye *eye, int k, float corner) {
    const sil_i_number *e = &eye->number[k], *w = &eye->number[3];
    sil_i_number a = sil_i_from_float(corner);
    if (!w->mantissa || !a.mantissa)
        return !e->mantissa;
    if (w->mantissa != 1 || w->exponent != 0)
        return 0;
    while (!(a.mantissa & 1)) {
        a.mantissa >>= 1;
        ++a.exponent;
    }
    return a.mantissa == e->mantissa && a.exponent == e->exponent && a.negative == e->negative;
}

/* Is the sign zero for a reason that can be seen by comparing coordinates? Views along an axis of a box, a prism or a
   cylinder, where a large part of the faces is edge-on, would spend their time in the exact sum. On each axis k either
   the eye is level with the face, or the face's shadow along k is nothing: two corners fall together or all three are
   level in another coordinate. */
static int sil_i_plainly_zero(const float *a, const float *b, const float *c, const sil_i_eye *eye) {
    int k;
    for (k = 0; k < 3; ++k)
        if (!sil_i_no_shadow(a, b, c, k) && !sil_i_eye_level(eye, k, a[k]))
            return 0;
    return 1;
}

/* value * 2^power, for powers of any size; exact as long as the result is no subnormal. */
static double sil_i_scaled(double value, int power) {
    return ldexp(value, power);
}

/* Moves the eye's coordinates to a common scale and cuts off low bits, as THE EYE in the manual says. */
static void sil_i_eye_round(sil_i_eye *eye) {
    int i, top = -100000, shift, weight = 0;
    for (i = 0; i < 3; ++i)
        if (eye->number[i].mantissa) {
            const int t = eye->number[i].exponent + sil_i_bit_length(eye->number[i].mantissa);
            top = t > top ? t : top;
        }
    if (eye->number[3].mantissa) {
        weight = eye->number[3].exponent + sil_i_bit_length(eye->number[3].mantissa);
        shift = 1 - weight;
        if (top + shift > 130)
            shift = 130 - top;
    } else
        shift = 1 - top;
    for (i = 0; i < 4; ++i) {
        sil_i_number *n = &eye->number[i];
        n->exponent += shift;
        if (n->exponent < -200) {
            const int cut = -200 - n->exponent;
            n->mantissa = cut < 64 ? n->mantissa >> cut : 0;
            n->exponent = -200;
        }
        if (!n->mantissa)
            n->exponent = 0;
        eye->e[i] = sil_i_scaled((double)n->mantissa, n->exponent);
        if (n->negative)
            eye->e[i] = -eye->e[i];
    }
}

/* The eye for the float planes: t = n . e' - d * w' with e' = (e - w * center) / scale, all divided by the largest.
   With v = 2^-24: unit normals are within v + 2^-25 of the truth a coordinate (see sil_i_face_plane), so are offsets,
   of which |d| <= 3; e' and w' are rounded by v; the sum of four products by 4v. In all less than 8v of |e'x| + |e'y| +
   |e'z| + 3 |w'|; 16v are allowed. The double subtractions of the centre, from the eye and from a corner, add 2u of |e|
   + w |center| each; 2^-50 is allowed. */
static void sil_i_eye_for_planes(sil_i_eye *eye, const sil_i_shape *shape) {
    double e[4], largest = 0, size = 0, lost = 0;
    int i;
    for (i = 0; i < 3; ++i) {
        e[i] = (eye->e[i] - eye->e[3] * shape->center[i]) / shape->scale;
        lost += (sil_i_abs(eye->e[i]) + sil_i_abs(eye->e[3] * shape->center[i])) / shape->scale;
    }
    e[3] = eye->e[3];
    for (i = 0; i < 4; ++i)
        largest = sil_i_larger(largest, sil_i_abs(e[i]));
    largest = sil_i_larger(largest, lost * 8.881784197001252e-16); /* nothing but rounding left: decides no face */
    for (i = 0; i < 4; ++i) {
        e[i] = largest > 0 ? e[i] / largest : 0;
        size += (i < 3 ? 1 : 3) * sil_i_abs(e[i]);
        eye->plane[i] = (float)e[i];
    }
    lost = largest > 0 ? lost / largest : 0;
    eye->limit = (float)(size * 9.5367431640625e-7 + lost * 8.881784197001252e-16 + 1e-30);
}

static void sil_i_eye_make(sil_i_eye *eye, const sil_view *view, const sil_i_shape *shape) {
    int i, finite = 1;
    memset(eye, 0, sizeof *eye);
    for (i = 0; i < 4; ++i)
        eye->number[i] = sil_i_from_double(view->eye[i], &finite);
    if (!finite ||
        !(eye->number[0].mantissa | eye->number[1].mantissa | eye->number[2].mantissa | eye->number[3].mantissa))
        return;
    if (eye->number[3].mantissa && eye->number[3].negative)
        for (i = 0; i < 4; ++i)
            eye->number[i].negative ^= 1;
    eye->valid = 1;
    sil_i_eye_round(eye);
    sil_i_eye_for_planes(eye, shape);
    for (i = 0; i < 3 && !eye->number[3].mantissa; ++i)
        if (eye->number[i].mantissa)
            eye->along |= SIL_I_NO_SHADOW << i;
}

/* Sign of det[b-a, c-a, p-w*a] for a point (w = 1) or a direction (w = 0) whose coordinates are floats. */
static int sil_i_side_of(const float *a, const float *b, const float *c, const float *p, int w) {
    sil_i_eye eye;
    int k, sign, finite = 1;
    memset(&eye, 0, sizeof eye);
    for (k = 0; k < 3; ++k) {
        eye.e[k] = (double)p[k];
        eye.number[k] = sil_i_from_double(eye.e[k], &finite);
    }
    eye.e[3] = w;
    eye.number[3].mantissa = (uint64_t)w;
    sign = sil_i_filtered_sign(a, b, c, &eye);
    if (!sign && !sil_i_plainly_zero(a, b, c, &eye))
        sign = sil_i_exact_sign(a, b, c, &eye);
    return sign;
}

/* On which side of a face's plane in rest is a point? 1 in front of it, 0 exactly in it. */
static int sil_i_off_plane(const sil_mesh *mesh, uint32_t face, const float *point) {
    const uint32_t *corner = mesh->corner + 3 * (size_t)face;
    const float *p = mesh->rest.position;
    return sil_i_side_of(p + 3 * (size_t)corner[0], p + 3 * (size_t)corner[1], p + 3 * (size_t)corner[2], point, 1);
}

/* Do two faces with an area lie exactly in one plane and look the same way? */
static int sil_i_same_plane(const sil_mesh *mesh, uint32_t f, uint32_t g) {
    const sil_i_shape *rest = &mesh->rest;
    int i;
    if (f == SIL_NONE || g == SIL_NONE)
        return 0;
    if (!(rest->plane[0][f] * rest->plane[0][g] + rest->plane[1][f] * rest->plane[1][g] +
              rest->plane[2][f] * rest->plane[2][g] >
          0.5f))
        return 0; /* or there is no plane */
    for (i = 0; i < 3; ++i)
        if (sil_i_off_plane(mesh, f, rest->position + 3 * (size_t)mesh->corner[3 * (size_t)g + (size_t)i]) != 0)
            return 0;
    return 1;
}

/* The place of the first of some rising words that is not below a value. */
static size_t sil_i_find_word(const uint32_t *words, size_t count, uint32_t value) {
    size_t low = 0, high = count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (words[middle] < value)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The face whose sign a face with SIL_I_BORROWS takes, or SIL_NONE. */
static uint32_t sil_i_root(const sil_mesh *mesh, uint32_t face) {
    const size_t at = sil_i_find_word(mesh->flat_face, mesh->flat_count, face);
    SIL_ASSERT(at < mesh->flat_count && mesh->flat_face[at] == face);
    return mesh->flat_root[at];
}

/* Is the face in front, where its float plane does not tell? */
static int sil_i_front_unsure(const sil_mesh *mesh, const sil_i_shape *shape, const sil_i_eye *eye, uint32_t face) {
    const float *corner[3];
    int i, sign;
    if (!eye->valid)
        return 0;
    if (mesh->face_flags[face] & SIL_I_BORROWS) {
        face = sil_i_root(mesh, face);
        if (face == SIL_NONE)
            return 0;
    }
    if (shape == &mesh->rest && eye->along && (mesh->face_flags[face] & eye->along) == eye->along)
        return 0; /* plainly edge-on: no shadow along any axis that the direction has a part in */
    for (i = 0; i < 3; ++i) {
        const uint32_t vertex = mesh->corner[3 * (size_t)face + (size_t)i];
        if (shape->bad_count && shape->bad[vertex])
            return 0;
        corner[i] = shape->position + 3 * (size_t)vertex;
    }
    sign = sil_i_filtered_sign(corner[0], corner[1], corner[2], eye);
    if (!sign && !sil_i_plainly_zero(corner[0], corner[1], corner[2], eye))
        sign = sil_i_exact_sign(corner[0], corner[1], corner[2], eye);
    return sign > 0;
}

static int sil_i_front(const sil_mesh *mesh, const sil_i_shape *shape, const sil_i_eye *eye, uint32_t face) {
    const float t = shape->plane[0][face] * eye->plane[0] + shape->plane[1][face] * eye->plane[1] +
                    shape->plane[2][face] * eye->plane[2] - shape->plane[3][face] * eye->plane[3];
    if (t > eye->limit)
        return 1;
    if (t < -eye->limit)
        return 0;
    return sil_i_front_unsure(mesh, shape, eye, face);
}

/* 64 faces from `first` on by their float planes: 1 in front[] where they surely are. Returns which are in doubt. */
static uint64_t sil_i_front_block_plain(const sil_i_shape *shape, const sil_i_eye *eye, size_t first,
                                        unsigned char *front) {
    const float ex = eye->plane[0], ey = eye->plane[1], ez = eye->plane[2], ew = eye->plane[3], limit = eye->limit;
    const float *nx = shape->plane[0] + first, *ny = shape->plane[1] + first;
    const float *nz = shape->plane[2] + first, *d = shape->plane[3] + first;
    uint64_t unsure = 0;
    float t[SIL_I_BLOCK];
    size_t i;
    int any = 0;
    for (i = 0; i < SIL_I_BLOCK; ++i)
        t[i] = nx[i] * ex + ny[i] * ey + nz[i] * ez - d[i] * ew;
    for (i = 0; i < SIL_I_BLOCK; ++i)
        any |= (t[i] <= limit) & (t[i] >= -limit);
    for (i = 0; i < SIL_I_BLOCK; ++i)
        front[i] = (unsigned char)(t[i] > limit);
    for (i = 0; any && i < SIL_I_BLOCK; ++i)
        unsure |= (uint64_t)((t[i] <= limit) & (t[i] >= -limit)) << i;
    return unsure;
}

#ifdef SIL_I_WIDE

/* What comparisons of 32 numbers left, a byte each, in order: packing is within halves. */
SIL_I_WIDE static __m256i sil_i_pack_wide(__m256i a, __m256i b, __m256i c, __m256i d) {
    const __m256i bytes = _mm256_packs_epi16(_mm256_packs_epi32(a, b), _mm256_packs_epi32(c, d));
    return _mm256_permutevar8x32_epi32(bytes, _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
}

SIL_I_WIDE static __m256 sil_i_plane_wide(const sil_i_shape *shape, const sil_i_eye *eye, size_t first) {
    const __m256 x = _mm256_mul_ps(_mm256_loadu_ps(shape->plane[0] + first), _mm256_set1_ps(eye->plane[0]));
    const __m256 y = _mm256_mul_ps(_mm256_loadu_ps(shape->plane[1] + first), _mm256_set1_ps(eye->plane[1]));
    const __m256 z = _mm256_mul_ps(_mm256_loadu_ps(shape->plane[2] + first), _mm256_set1_ps(eye->plane[2]));
    const __m256 d = _mm256_mul_ps(_mm256_loadu_ps(shape->plane[3] + first), _mm256_set1_ps(eye->plane[3]));
    return _mm256_sub_ps(_mm256_add_ps(_mm256_add_ps(x, y), z), d);
}

SIL_I_WIDE static __m256i sil_i_greater_wide(__m256 a, __m256 b) {
    return _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_GT_OQ));
}

SIL_I_WIDE static uint64_t sil_i_front_block_wide(const sil_i_shape *shape, const sil_i_eye *eye, size_t first,
                                                  unsigned char *front) {
    const __m256 high = _mm256_set1_ps(eye->limit), low = _mm256_set1_ps(-eye->limit);
    uint64_t sure = 0;
    size_t i;
    for (i = 0; i < SIL_I_BLOCK; i += 32) {
        const __m256 a = sil_i_plane_wide(shape, eye, first + i), b = sil_i_plane_wide(shape, eye, first + i + 8);
        const __m256 c = sil_i_plane_wide(shape, eye, first + i + 16);
        const __m256 d = sil_i_plane_wide(shape, eye, first + i + 24);
        const __m256i fronts = sil_i_pack_wide(sil_i_greater_wide(a, high), sil_i_greater_wide(b, high),
                                               sil_i_greater_wide(c, high), sil_i_greater_wide(d, high));
        const __m256i backs = sil_i_pack_wide(sil_i_greater_wide(low, a), sil_i_greater_wide(low, b),
                                              sil_i_greater_wide(low, c), sil_i_greater_wide(low, d));
        _mm256_storeu_si256((__m256i *)(void *)(front + i), _mm256_and_si256(fronts, _mm256_set1_epi8(1)));
        sure |= (uint64_t)(uint32_t)_mm256_movemask_epi8(_mm256_or_si256(fronts, backs)) << i;
    }
    return ~sure;
}

#endif

static void sil_i_front_all(const sil_mesh *mesh, const sil_i_shape *shape, const sil_i_eye *eye,
                            unsigned char *front) {
    size_t first, i;
    if (!eye->valid) {
        memset(front, 0, sil_i_padded(mesh->face_count));
        return;
    }
    for (first = 0; first < mesh->face_count; first += SIL_I_BLOCK) {
        uint64_t unsure;
#ifdef SIL_I_WIDE
        if (mesh->wide)
            unsure = sil_i_front_block_wide(shape, eye, first, front + first);
        else
#endif
            unsure = sil_i_front_block_plain(shape, eye, first, front + first);
        for (i = first; unsure && i < mesh->face_count; ++i, unsure >>= 1)
            if (unsure & 1)
                front[i] = (unsigned char)sil_i_front_unsure(mesh, shape, eye, (uint32_t)i);
    }
}

/* ---- shapes: positions and planes ---- */

static int sil_i_shape_take(sil_i_heap *heap, sil_i_shape *shape, size_t vertices, size_t faces) {
    int k;
    const size_t padded = sil_i_padded(faces);
    shape->position = (float *)sil_i_take(heap, vertices, 3 * sizeof(float));
    shape->bad = sil_i_take_bytes(heap, vertices);
    for (k = 0; k < 4; ++k) {
        shape->plane[k] = (float *)sil_i_take(heap, padded, sizeof(float));
        if (shape->plane[k])
            memset(shape->plane[k], 0, padded * sizeof(float));
    }
    return !heap->failed;
}

static void sil_i_shape_give(const sil_allocator *allocator, sil_i_shape *shape) {
    int k;
    sil_i_give(allocator, shape->position);
    sil_i_give(allocator, shape->bad);
    for (k = 0; k < 4; ++k)
        sil_i_give(allocator, shape->plane[k]);
    memset(shape, 0, sizeof *shape);
}

static void sil_i_shape_set_vertex(sil_i_shape *shape, size_t vertex, const float *position) {
    float p[3];
    memcpy(p, position, sizeof p); /* strides may leave floats unaligned */
    shape->bad[vertex] = (unsigned char)!sil_i_all_finite(p, 3);
    if (shape->bad[vertex])
        memset(p, 0, sizeof p);
    memcpy(shape->position + 3 * vertex, p, sizeof p);
}

/* Box, centre and scale of the vertices that faces have. */
static void sil_i_shape_box(const sil_mesh *mesh, sil_i_shape *shape) {
    size_t i;
    int k, exponent, any = 0;
    double extent = 0;
    memset(shape->low, 0, sizeof shape->low);
    memset(shape->high, 0, sizeof shape->high);
    shape->bad_count = 0;
    for (i = 0; i < mesh->unique_count; ++i) {
        if (!mesh->referenced[i])
            continue;
        if (shape->bad[i]) {
            ++shape->bad_count;
            continue;
        }
        for (k = 0; k < 3; ++k) {
            const double x = (double)shape->position[3 * i + (size_t)k];
            shape->low[k] = any && shape->low[k] < x ? shape->low[k] : x;
            shape->high[k] = any && shape->high[k] > x ? shape->high[k] : x;
        }
        any = 1;
    }
    for (k = 0; k < 3; ++k) {
        shape->center[k] = 0.5 * (shape->low[k] + shape->high[k]);
        extent = sil_i_larger(extent, shape->high[k] - shape->center[k]);
    }
    (void)frexp(extent * 1.001, &exponent); /* the centre may be rounded */
    shape->scale = extent > 0 ? sil_i_scaled(1, exponent) : 1;
}

static void sil_i_normal(const sil_i_shape *shape, const uint32_t *corner, double normal[3], double *error) {
    const float *a = shape->position + 3 * (size_t)corner[0], *b = shape->position + 3 * (size_t)corner[1];
    const float *c = shape->position + 3 * (size_t)corner[2];
    const double tiny = 8.470329472543003e-22;
    double u[3], v[3], su[3], sv[3];
    int k;
    for (k = 0; k < 3; ++k) {
        u[k] = (double)b[k] - (double)a[k];
        v[k] = (double)c[k] - (double)a[k];
        su[k] = sil_i_abs(u[k]) + tiny;
        sv[k] = sil_i_abs(v[k]) + tiny;
    }
    normal[0] = u[1] * v[2] - u[2] * v[1];
    normal[1] = u[2] * v[0] - u[0] * v[2];
    normal[2] = u[0] * v[1] - u[1] * v[0];
    *error = 8.881784197001252e-16 * /* 8 * 2^-53: twice the 4u of each coordinate */
             (su[1] * sv[2] + su[2] * sv[1] + su[2] * sv[0] + su[0] * sv[2] + su[0] * sv[1] + su[1] * sv[0]);
}

/* The float plane of one face. Where the normal's error is more than 2^-26 of its length (a needle), or a corner is not
   finite, the plane stays zero: it decides nothing. Returns 0 then. */
static int sil_i_face_plane(const sil_mesh *mesh, sil_i_shape *shape, size_t face) {
    const uint32_t *corner = mesh->corner + 3 * face;
    const float *a = shape->position + 3 * (size_t)corner[0];
    double normal[3], error, length, offset = 0;
    int k;
    for (k = 0; k < 4; ++k)
        shape->plane[k][face] = 0;
    if (shape->bad[corner[0]] || shape->bad[corner[1]] || shape->bad[corner[2]])
        return 0;
    sil_i_normal(shape, corner, normal, &error);
    length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > error * 67108864.0))
        return 0;
    for (k = 0; k < 3; ++k) {
        shape->plane[k][face] = (float)(normal[k] / length);
        offset += normal[k] / length * (((double)a[k] - shape->center[k]) / shape->scale);
    }
    shape->plane[3][face] = (float)offset;
    return 1;
}

/* A face without area has the plane of the one whose sign it takes. */
static void sil_i_flat_planes(const sil_mesh *mesh, sil_i_shape *shape) {
    size_t i;
    int k;
    for (i = 0; i < mesh->flat_count; ++i)
        for (k = 0; k < 4; ++k)
            shape->plane[k][mesh->flat_face[i]] =
                mesh->flat_root[i] == SIL_NONE ? 0 : shape->plane[k][mesh->flat_root[i]];
}

/* ---- welding ---- */

static uint32_t sil_i_hash(uint32_t a, uint32_t b, uint32_t c) {
    uint32_t h = a * 0x9e3779b1u;
    h = (h ^ h >> 15) + b;
    h *= 0x85ebca77u;
    h = (h ^ h >> 13) + c;
    h *= 0xc2b2ae3du;
    return h ^ h >> 16;
}

static size_t sil_i_table_size(size_t entries) {
    size_t size = 16;
    while (size < 2 * entries)
        size *= 2;
    return size;
}

static const float *sil_i_given(const sil_mesh_desc *desc, size_t vertex) {
    const size_t stride = desc->position_stride ? desc->position_stride : 3 * sizeof(float);
    return (const float *)(const void *)((const char *)(const void *)desc->positions + vertex * stride);
}

static uint32_t sil_i_new_vertex(sil_mesh *mesh, const sil_mesh_desc *desc, size_t vertex) {
    const uint32_t welded = (uint32_t)mesh->unique_count++;
    sil_i_shape_set_vertex(&mesh->rest, welded, sil_i_given(desc, vertex));
    mesh->origin[welded] = (uint32_t)vertex;
    mesh->welded[vertex] = welded;
    return welded;
}

/* By equal position: an open-addressed table of vertices kept so far. */
static void sil_i_weld_equal(sil_mesh *mesh, const sil_mesh_desc *desc, uint32_t *table, size_t table_size) {
    size_t i, at;
    memset(table, 0xff, table_size * sizeof(uint32_t));
    for (i = 0; i < mesh->vertex_count; ++i) {
        uint32_t bits[3];
        int k, found = 0;
        memcpy(bits, sil_i_given(desc, i), sizeof bits);
        for (k = 0; k < 3; ++k)
            bits[k] = bits[k] == 0x80000000u ? 0 : bits[k];
        at = sil_i_hash(bits[0], bits[1], bits[2]) & (table_size - 1);
        while (table[at] != SIL_NONE && !found) {
            uint32_t kept[3];
            memcpy(kept, sil_i_given(desc, mesh->origin[table[at]]), sizeof kept);
            found = 1;
            for (k = 0; k < 3; ++k)
                found &= (kept[k] == 0x80000000u ? 0 : kept[k]) == bits[k];
            if (!found)
                at = (at + 1) & (table_size - 1);
        }
        if (found)
            mesh->welded[i] = table[at];
        else
            table[at] = sil_i_new_vertex(mesh, desc, i);
    }
}

static uint32_t sil_i_cell_hash(const int64_t *cell) {
    uint32_t part[3];
    int k;
    for (k = 0; k < 3; ++k)
        part[k] = (uint32_t)((uint64_t)cell[k] & 0xffffffffu) ^ (uint32_t)((uint64_t)cell[k] >> 32) * 0x27d4eb2fu;
    return sil_i_hash(part[0], part[1], part[2]);
}

/* The first kept vertex within the distance in the 27 cells around a vertex's own, or SIL_NONE. */
static uint32_t sil_i_weld_find(const sil_mesh *mesh, const float *p, const int64_t *cell, const uint32_t *heads,
                                size_t table_size, const uint32_t *next, double distance) {
    uint32_t best = SIL_NONE, other;
    int i, k;
    for (i = 0; i < 27; ++i) {
        int64_t neighbour[3];
        neighbour[0] = cell[0] + i % 3 - 1;
        neighbour[1] = cell[1] + i / 3 % 3 - 1;
        neighbour[2] = cell[2] + i / 9 - 1;
        for (other = heads[sil_i_cell_hash(neighbour) & (table_size - 1)]; other != SIL_NONE; other = next[other]) {
            double square = 0;
            for (k = 0; k < 3; ++k) {
                const double d = (double)p[k] - (double)mesh->rest.position[3 * (size_t)other + (size_t)k];
                square += d * d;
            }
            if (square <= distance * distance && other < best && !mesh->rest.bad[other])
                best = other;
        }
    }
    return best;
}

/* By distance: kept vertices in a grid of cells a little larger than the distance, in a table of lists. Further out
   than 2^62 cells floats are further apart than the distance, so that it does no harm to clamp there. */
static void sil_i_weld_close(sil_mesh *mesh, const sil_mesh_desc *desc, uint32_t *heads, size_t table_size,
                             uint32_t *next) {
    const double distance = (double)desc->weld_distance, size = distance * (1 + 9.5367431640625e-7);
    size_t i;
    memset(heads, 0xff, table_size * sizeof(uint32_t));
    for (i = 0; i < mesh->vertex_count; ++i) {
        int64_t cell[3];
        float p[3];
        uint32_t found, hash;
        int k;
        memcpy(p, sil_i_given(desc, i), sizeof p);
        if (!sil_i_all_finite(p, 3)) {
            (void)sil_i_new_vertex(mesh, desc, i);
            continue;
        }
        for (k = 0; k < 3; ++k) {
            const double c = floor((double)p[k] / size), edge = 4611686018427387904.0;
            cell[k] = (int64_t)(c > edge ? edge : c < -edge ? -edge : c);
        }
        found = sil_i_weld_find(mesh, p, cell, heads, table_size, next, distance);
        if (found != SIL_NONE) {
            mesh->welded[i] = found;
            continue;
        }
        found = sil_i_new_vertex(mesh, desc, i);
        hash = sil_i_cell_hash(cell) & (uint32_t)(table_size - 1);
        next[found] = heads[hash];
        heads[hash] = found;
    }
}

static void sil_i_build_vertices(sil_mesh *mesh, const sil_mesh_desc *desc, sil_i_heap *heap, sil_i_heap *scratch) {
    const size_t count = mesh->vertex_count;
    uint32_t *table, *next = NULL;
    size_t i, table_size;
    mesh->welded = sil_i_take_words(heap, count);
    mesh->origin = sil_i_take_words(heap, count);
    mesh->referenced = sil_i_take_bytes(heap, count);
    mesh->rest.position = (float *)sil_i_take(heap, count, 3 * sizeof(float));
    mesh->rest.bad = sil_i_take_bytes(heap, count);
    if (heap->failed)
        return;
    if (desc->weld_distance < 0) {
        for (i = 0; i < count; ++i)
            (void)sil_i_new_vertex(mesh, desc, i);
        return;
    }
    table_size = sil_i_table_size(count); /* what was taken before holds larger arrays: no overflow */
    table = sil_i_take_words(scratch, table_size);
    if (desc->weld_distance > 0)
        next = sil_i_take_words(scratch, count);
    if (!scratch->failed) {
        if (desc->weld_distance > 0)
            sil_i_weld_close(mesh, desc, table, table_size, next);
        else
            sil_i_weld_equal(mesh, desc, table, table_size);
    }
    sil_i_give(&scratch->allocator, table);
    sil_i_give(&scratch->allocator, next);
}

/* ---- faces ---- */

/* A face by its welded vertices in rising order; what it is then does not depend on the order it came in. */
typedef struct sil_i_triple {
    uint32_t vertex[3];
    uint32_t tag; /* 2 * the caller's triangle + 1 where the winding is reversed */
} sil_i_triple;

/* A stable counting sort by one of the three vertices. */
static void sil_i_sort_triples(const sil_i_triple *from, sil_i_triple *to, size_t count, int key, size_t *starts,
                               size_t keys) {
    size_t i, sum = 0;
    memset(starts, 0, keys * sizeof(size_t));
    for (i = 0; i < count; ++i)
        ++starts[from[i].vertex[key]];
    for (i = 0; i < keys; ++i) {
        const size_t here = starts[i];
        starts[i] = sum;
        sum += here;
    }
    for (i = 0; i < count; ++i)
        to[starts[from[i].vertex[key]]++] = from[i];
}

static void sil_i_swap_words(uint32_t *a, uint32_t *b) {
    const uint32_t t = *a;
    *a = *b;
    *b = t;
}

/* One triangle of the caller's into a triple; 0 where it is left out. */
static int sil_i_read_face(sil_mesh *mesh, const sil_mesh_desc *desc, size_t face, sil_i_triple *triple) {
    uint32_t reversed = 0, *v = triple->vertex;
    int i;
    for (i = 0; i < 3; ++i) {
        const size_t at = 3 * face + (size_t)i;
        const size_t vertex = desc->indices ? desc->indices[at] : at;
        if (vertex >= mesh->vertex_count || mesh->rest.bad[mesh->welded[vertex]]) {
            ++mesh->info.dropped_face_count;
            return 0;
        }
        v[i] = mesh->welded[vertex];
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
        ++mesh->info.degenerate_face_count;
        return 0;
    }
    for (i = 0; i < 3; ++i) /* three exchanges sort three */
        if (v[i % 2] > v[i % 2 + 1]) {
            sil_i_swap_words(&v[i % 2], &v[i % 2 + 1]);
            reversed ^= 1;
        }
    triple->tag = 2 * (uint32_t)face + reversed;
    return 1;
}

/* Sorted triples to faces: the same three vertices once. A face in both windings is two-sided and starts as the rising
   one. Corners are the triple, the last two exchanged where it is reversed. */
static void sil_i_merge_faces(sil_mesh *mesh, const sil_i_triple *triples, size_t count) {
    size_t i, j, faces = 0;
    for (i = 0; i < count; i = j) {
        uint32_t windings = 0, *corner = mesh->corner + 3 * faces;
        for (j = i; j < count && memcmp(triples[j].vertex, triples[i].vertex, sizeof triples[i].vertex) == 0; ++j)
            windings |= 1u << (triples[j].tag & 1);
        memcpy(corner, triples[i].vertex, sizeof triples[i].vertex);
        if (windings == 2)
            sil_i_swap_words(&corner[1], &corner[2]);
        mesh->face_flags[faces] = windings == 3 ? SIL_I_TWO_SIDED : 0;
        mesh->info.two_sided_face_count += windings == 3;
        mesh->info.duplicate_face_count += j - i - 1;
        mesh->source[faces++] = triples[i].tag / 2;
        mesh->referenced[corner[0]] = mesh->referenced[corner[1]] = mesh->referenced[corner[2]] = 1;
    }
    mesh->face_count = faces;
}

static void sil_i_build_faces(sil_mesh *mesh, const sil_mesh_desc *desc, size_t given, sil_i_heap *heap,
                              sil_i_heap *scratch) {
    sil_i_triple *first = (sil_i_triple *)sil_i_take(scratch, given, sizeof(sil_i_triple));
    sil_i_triple *second = (sil_i_triple *)sil_i_take(scratch, given, sizeof(sil_i_triple));
    size_t *starts = (size_t *)sil_i_take(scratch, mesh->unique_count, sizeof(size_t));
    size_t i, count = 0;
    if (!scratch->failed) {
        for (i = 0; i < given; ++i)
            count += (size_t)sil_i_read_face(mesh, desc, i, &first[count]);
        sil_i_sort_triples(first, second, count, 2, starts, mesh->unique_count);
        sil_i_sort_triples(second, first, count, 1, starts, mesh->unique_count);
        sil_i_sort_triples(first, second, count, 0, starts, mesh->unique_count);
        mesh->corner = sil_i_take_words(heap, 3 * count);
        mesh->source = sil_i_take_words(heap, count);
        mesh->face_flags = sil_i_take_bytes(heap, count);
        if (!heap->failed)
            sil_i_merge_faces(mesh, second, count);
    }
    sil_i_give(&scratch->allocator, first);
    sil_i_give(&scratch->allocator, second);
    sil_i_give(&scratch->allocator, starts);
}

/* Sorts words by rising value of the given bits, 11 at a time; the result is in `words`. */
static void sil_i_sort_words(uint64_t *words, uint64_t *spare, size_t count, int low, int high) {
    uint32_t starts[2048];
    size_t i;
    int bit;
    for (bit = low; bit < high; bit += 11) {
        uint32_t sum = 0;
        memset(starts, 0, sizeof starts);
        for (i = 0; i < count; ++i)
            ++starts[words[i] >> bit & 2047];
        for (i = 0; i < 2048; ++i) {
            const uint32_t here = starts[i];
            starts[i] = sum;
            sum += here;
        }
        for (i = 0; i < count; ++i)
            spare[starts[words[i] >> bit & 2047]++] = words[i];
        memcpy(words, spare, count * sizeof *words);
    }
}

/* A face where it is to be numbered: middle and unit normal, both within -1 .. 1. */
typedef struct sil_i_seat {
    float key[6];
    uint32_t face;
} sil_i_seat;

static int sil_i_seat_before(const sil_i_seat *a, const sil_i_seat *b, int k) {
    return a->key[k] < b->key[k] || (!(b->key[k] < a->key[k]) && a->face < b->face);
}

/* Moves the `nth` of the seats by key k to its place, smaller ones before it. Pivots are taken from anywhere, so that no
   order of the faces makes it slow. */
static void sil_i_select_seat(sil_i_seat *seats, size_t count, size_t nth, int k) {
    size_t low = 0, high = count;
    while (high - low > 1) {
        const uint32_t any = sil_i_hash((uint32_t)low, (uint32_t)high, (uint32_t)nth);
        const sil_i_seat pivot = seats[low + any % (high - low)];
        size_t i = low, j = high - 1;
        for (;;) {
            sil_i_seat swap;
            while (sil_i_seat_before(&seats[i], &pivot, k))
                ++i;
            while (sil_i_seat_before(&pivot, &seats[j], k))
                --j;
            if (i >= j)
                break;
            swap = seats[i];
            seats[i] = seats[j];
            seats[j] = swap;
            ++i;
            --j;
        }
        /* None before i is larger than the pivot, none from i on smaller. */
        if (nth < i)
            high = i;
        else
            low = i > low ? i : low + 1; /* the pivot may be the smallest, and first */
        if (nth < low)
            return;
    }
}

/* Halves faces again and again, across the widest of the six keys, into runs of a power of two times 32: patches, and
   nodes of the hierarchy, then hold faces that are close together and look the same way. */
static void sil_i_divide_seats(sil_i_seat *seats, size_t count) {
    while (count > 32) {
        float low[6], high[6];
        size_t i, half = 32;
        int k, widest = 0;
        memcpy(low, seats[0].key, sizeof low);
        memcpy(high, seats[0].key, sizeof high);
        for (i = 1; i < count; ++i)
            for (k = 0; k < 6; ++k) {
                const float x = seats[i].key[k];
                low[k] = x < low[k] ? x : low[k];
                high[k] = x > high[k] ? x : high[k];
            }
        for (k = 1; k < 6; ++k)
            if (high[k] - low[k] > high[widest] - low[widest])
                widest = k;
        while (2 * half < count)
            half *= 2;
        sil_i_select_seat(seats, count, half, widest);
        sil_i_divide_seats(seats, half);
        seats += half;
        count -= half;
    }
}

static void sil_i_seat_set(const sil_mesh *mesh, const uint32_t *corner, sil_i_seat *seat) {
    const float *a = mesh->rest.position + 3 * (size_t)corner[0], *b = mesh->rest.position + 3 * (size_t)corner[1];
    const float *c = mesh->rest.position + 3 * (size_t)corner[2];
    double normal[3], error, length;
    int k;
    sil_i_normal(&mesh->rest, corner, normal, &error);
    length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (k = 0; k < 3; ++k) {
        const double middle = ((double)a[k] + (double)b[k] + (double)c[k]) / 3;
        seat->key[k] = (float)((middle - mesh->rest.center[k]) / mesh->rest.scale);
        seat->key[3 + k] = length > 0 ? (float)(normal[k] / length) : 0;
    }
}

/* Numbers faces so that any 32 that follow each other from a multiple of 32 on are a small patch. Equal faces stay in the
   order of their vertices. */
static void sil_i_order_faces(sil_mesh *mesh, sil_i_heap *scratch) {
    const size_t count = mesh->face_count;
    sil_i_seat *seats = (sil_i_seat *)sil_i_take(scratch, count, sizeof *seats);
    uint32_t *old = sil_i_take_words(scratch, 5 * count); /* three corners, the source and the flags of each */
    size_t f;
    sil_i_shape_box(mesh, &mesh->rest);
    for (f = 0; f < count && !scratch->failed; ++f) {
        seats[f].face = (uint32_t)f;
        sil_i_seat_set(mesh, mesh->corner + 3 * f, &seats[f]);
        memcpy(old + 5 * f, mesh->corner + 3 * f, 3 * sizeof(uint32_t));
        old[5 * f + 3] = mesh->source[f];
        old[5 * f + 4] = mesh->face_flags[f];
    }
    if (!scratch->failed) {
        sil_i_divide_seats(seats, count);
        for (f = 0; f < count; ++f) {
            const uint32_t *from = old + 5 * (size_t)seats[f].face;
            memcpy(mesh->corner + 3 * f, from, 3 * sizeof(uint32_t));
            mesh->source[f] = from[3];
            mesh->face_flags[f] = (unsigned char)from[4];
        }
    }
    sil_i_give(&scratch->allocator, seats);
    sil_i_give(&scratch->allocator, old);
}

/* Planes of the rest positions, and which faces have no area: where the plane is sound there is some. */
static void sil_i_build_planes(sil_mesh *mesh, sil_i_heap *heap) {
    const size_t padded = sil_i_padded(mesh->face_count);
    size_t f;
    int k;
    for (k = 0; k < 4; ++k) {
        mesh->rest.plane[k] = (float *)sil_i_take(heap, padded, sizeof(float));
        if (mesh->rest.plane[k])
            memset(mesh->rest.plane[k], 0, padded * sizeof(float));
    }
    if (heap->failed)
        return;
    for (f = 0; f < mesh->face_count; ++f) {
        const uint32_t *corner = mesh->corner + 3 * f;
        const float *p = mesh->rest.position;
        for (k = 0; k < 3; ++k)
            if (sil_i_no_shadow(p + 3 * (size_t)corner[0], p + 3 * (size_t)corner[1], p + 3 * (size_t)corner[2], k))
                mesh->face_flags[f] = (unsigned char)(mesh->face_flags[f] | SIL_I_NO_SHADOW << k);
        if (sil_i_face_plane(mesh, &mesh->rest, f) || mesh->face_flags[f] & SIL_I_BORROWS)
            continue;
        if (sil_i_collinear(p + 3 * (size_t)corner[0], p + 3 * (size_t)corner[1], p + 3 * (size_t)corner[2])) {
            mesh->face_flags[f] |= SIL_I_NO_AREA;
            ++mesh->flat_count;
        }
    }
    mesh->info.degenerate_face_count += mesh->flat_count;
}

/* ---- edges ---- */

/* The two vertices of side i of a face (a "side" is 3 * face + i), the smaller first. */
static void sil_i_side(const sil_mesh *mesh, uint32_t side, uint32_t v[2]) {
    v[0] = mesh->corner[side];
    v[1] = mesh->corner[side % 3 == 2 ? side - 2 : side + 1];
    if (v[0] > v[1])
        sil_i_swap_words(&v[0], &v[1]);
}

static void sil_i_sort_sides(const sil_mesh *mesh, const uint32_t *from, uint32_t *to, int key, size_t *starts) {
    const size_t count = 3 * mesh->face_count;
    size_t i, sum = 0;
    uint32_t v[2];
    memset(starts, 0, mesh->unique_count * sizeof(size_t));
    for (i = 0; i < count; ++i) {
        sil_i_side(mesh, (uint32_t)i, v);
        ++starts[v[key]];
    }
    for (i = 0; i < mesh->unique_count; ++i) {
        const size_t here = starts[i];
        starts[i] = sum;
        sum += here;
    }
    for (i = 0; i < count; ++i) {
        const uint32_t side = from ? from[i] : (uint32_t)i;
        sil_i_side(mesh, side, v);
        to[starts[v[key]]++] = side;
    }
}

/* The end of the run of sides that are the same edge as the one at `at`. */
static size_t sil_i_run_end(const sil_mesh *mesh, const uint32_t *sides, size_t at) {
    uint32_t v[2], w[2];
    sil_i_side(mesh, sides[at], v);
    while (++at < 3 * mesh->face_count) {
        sil_i_side(mesh, sides[at], w);
        if (v[0] != w[0] || v[1] != w[1])
            break;
    }
    return at;
}

/* The faces of one edge, from its sides. Where there are more than two, faces without area only stay if the edge would
   otherwise have fewer than two: a sliver along a good edge must not make it non-manifold. Returns their number. */
static size_t sil_i_edge_faces(const sil_mesh *mesh, const uint32_t *sides, size_t count, uint32_t *faces) {
    size_t i, kept = 0;
    if (count > 2) {
        for (i = 0; i < count; ++i)
            if (!(mesh->face_flags[sides[i] / 3] & SIL_I_NO_AREA))
                faces[kept++] = sides[i] / 3;
        if (kept >= 2)
            return kept;
    }
    for (i = 0; i < count; ++i)
        faces[i] = sides[i] / 3;
    return count;
}

static int sil_i_take_edges(sil_mesh *mesh, sil_i_heap *heap, size_t edges, size_t many, size_t many_faces) {
    const size_t padded = sil_i_padded(edges);
    mesh->edge_vertex = sil_i_take_words(heap, 2 * edges);
    mesh->edge_face[0] = sil_i_take_words(heap, padded);
    mesh->edge_face[1] = sil_i_take_words(heap, padded);
    mesh->edge_kinds = sil_i_take_bytes(heap, padded);
    mesh->face_edge = sil_i_take_words(heap, 3 * mesh->face_count);
    mesh->many_edge = sil_i_take_words(heap, many);
    mesh->many_first = sil_i_take_words(heap, many + 1);
    mesh->many_face = sil_i_take_words(heap, many_faces);
    if (heap->failed)
        return 0;
    memset(mesh->edge_face[0], 0, padded * sizeof(uint32_t));
    memset(mesh->edge_face[1], 0, padded * sizeof(uint32_t));
    return 1;
}

/* Sorted sides to edges. `faces` has room for those of the edge with the most. */
static void sil_i_fill_edges(sil_mesh *mesh, const uint32_t *sides, uint32_t *faces) {
    size_t i, j, e = 0, listed = 0;
    mesh->many_first[0] = 0;
    for (i = 0; i < 3 * mesh->face_count; i = j, ++e) {
        size_t count, k;
        j = sil_i_run_end(mesh, sides, i);
        count = sil_i_edge_faces(mesh, sides + i, j - i, faces);
        sil_i_side(mesh, sides[i], mesh->edge_vertex + 2 * e);
        for (k = i; k < j; ++k)
            mesh->face_edge[sides[k]] = (uint32_t)e;
        mesh->edge_face[0][e] = faces[0];
        mesh->edge_face[1][e] = faces[count > 1 ? 1 : 0];
        if (count <= 2)
            continue;
        mesh->edge_kinds[e] = SIL_I_MANY;
        memcpy(mesh->many_face + listed, faces, count * sizeof(uint32_t));
        listed += count;
        mesh->many_edge[mesh->many_count++] = (uint32_t)e;
        mesh->many_first[mesh->many_count] = (uint32_t)listed;
    }
    mesh->edge_count = e;
}

/* Puts runs of sides that are one edge in the order of their first sides: an edge is numbered by its first face. */
static void sil_i_order_runs(const sil_mesh *mesh, const uint32_t *sides, uint32_t *run, uint32_t *out) {
    const size_t count = 3 * mesh->face_count;
    size_t i, j, n = 0;
    memset(run, 0xff, count * sizeof(uint32_t));
    for (i = 0; i < count; i = sil_i_run_end(mesh, sides, i))
        run[sides[i]] = (uint32_t)i;
    for (i = 0; i < count; ++i)
        if (run[i] != SIL_NONE)
            for (j = sil_i_run_end(mesh, sides, run[i]) - run[i]; j > 0; --j, ++n)
                out[n] = sides[run[i]++];
}

/* By counting sort of the sides, by their larger and then by their smaller vertex. */
static void sil_i_build_edges(sil_mesh *mesh, sil_i_heap *heap, sil_i_heap *scratch) {
    const size_t count = 3 * mesh->face_count;
    uint32_t *first = sil_i_take_words(scratch, count), *second = sil_i_take_words(scratch, count);
    uint32_t *third = sil_i_take_words(scratch, count);
    size_t *starts = (size_t *)sil_i_take(scratch, mesh->unique_count, sizeof(size_t));
    size_t i, j, edges = 0, many = 0, many_faces = 0;
    if (!scratch->failed) {
        sil_i_sort_sides(mesh, NULL, first, 1, starts);
        sil_i_sort_sides(mesh, first, third, 0, starts);
        sil_i_order_runs(mesh, third, first, second);
        for (i = 0; i < count; i = j, ++edges) {
            j = sil_i_run_end(mesh, second, i);
            if (sil_i_edge_faces(mesh, second + i, j - i, first) > 2) {
                ++many;
                many_faces += j - i;
            }
        }
        if (sil_i_take_edges(mesh, heap, edges, many, many_faces))
            sil_i_fill_edges(mesh, second, first);
    }
    sil_i_give(&scratch->allocator, first);
    sil_i_give(&scratch->allocator, second);
    sil_i_give(&scratch->allocator, third);
    sil_i_give(&scratch->allocator, starts);
}

/* ---- a tree over boxes ---- */

typedef struct sil_i_bounds {
    double low[3], high[3];
} sil_i_bounds;

/* Items in the order of a space-filling curve, their boxes, and boxes of eight boxes each up to a single one: box k of a
   level is around boxes 8 * k ... of the level below. For what is asked while a mesh is made, and for containment. */
typedef struct sil_i_bvh {
    sil_i_bounds *box;
    uint32_t *item;
    size_t count, first[SIL_I_LEVELS];
    unsigned levels; /* above the items' own */
} sil_i_bvh;

static void sil_i_bounds_none(sil_i_bounds *b) {
    int k;
    for (k = 0; k < 3; ++k) {
        b->low[k] = 1e300;
        b->high[k] = -1e300;
    }
}

static void sil_i_bounds_add(sil_i_bounds *b, const sil_i_bounds *other) {
    int k;
    for (k = 0; k < 3; ++k) {
        b->low[k] = other->low[k] < b->low[k] ? other->low[k] : b->low[k];
        b->high[k] = other->high[k] > b->high[k] ? other->high[k] : b->high[k];
    }
}

static void sil_i_bounds_point(sil_i_bounds *b, const float *p) {
    sil_i_bounds point;
    int k;
    for (k = 0; k < 3; ++k)
        point.low[k] = point.high[k] = (double)p[k];
    sil_i_bounds_add(b, &point);
}

static void sil_i_bvh_give(const sil_allocator *allocator, sil_i_bvh *tree) {
    sil_i_give(allocator, tree->box);
    sil_i_give(allocator, tree->item);
    memset(tree, 0, sizeof *tree);
}

/* Morton codes of the boxes' middles, with their numbers below. */
static void sil_i_bvh_codes(const sil_i_bounds *boxes, size_t count, uint64_t *codes) {
    sil_i_bounds all;
    double size = 0;
    size_t i;
    int k;
    sil_i_bounds_none(&all);
    for (i = 0; i < count; ++i)
        sil_i_bounds_add(&all, &boxes[i]);
    for (k = 0; k < 3; ++k)
        size = sil_i_larger(size, all.high[k] - all.low[k]);
    for (i = 0; i < count; ++i) {
        uint32_t code = 0;
        for (k = 0; k < 3; ++k) {
            const double middle = 0.5 * (boxes[i].low[k] + boxes[i].high[k]) - all.low[k];
            const double at = size > 0 ? middle / size * 1023 : 0;
            code |= sil_i_spread_bits((uint32_t)(at < 0 ? 0 : at > 1023 ? 1023 : at)) << k;
        }
        codes[i] = (uint64_t)code << 32 | i;
    }
}

/* Over the boxes, whose numbers are the items; they are not needed afterwards. Fails as the heap does. */
static void sil_i_bvh_make(sil_i_bvh *tree, const sil_i_bounds *boxes, size_t count, sil_i_heap *heap) {
    uint64_t *codes = (uint64_t *)sil_i_take(heap, count, sizeof(uint64_t));
    uint64_t *spare = (uint64_t *)sil_i_take(heap, count, sizeof(uint64_t));
    size_t i, width;
    memset(tree, 0, sizeof *tree);
    tree->count = count;
    tree->box = (sil_i_bounds *)sil_i_take(heap, count + count / 7 + SIL_I_LEVELS, sizeof(sil_i_bounds));
    tree->item = sil_i_take_words(heap, count);
    if (!heap->failed) {
        sil_i_bvh_codes(boxes, count, codes);
        sil_i_sort_words(codes, spare, count, 32, 62);
        for (i = 0; i < count; ++i) {
            tree->item[i] = (uint32_t)(codes[i] & 0xffffffffu);
            tree->box[i] = boxes[tree->item[i]];
        }
        for (width = count; width > 1; width = (width + 7) / 8) {
            const size_t below = tree->first[tree->levels];
            sil_i_bounds *above = tree->box + below + width;
            tree->first[++tree->levels] = below + width;
            for (i = 0; i < width; ++i) {
                if (i % 8 == 0)
                    sil_i_bounds_none(&above[i / 8]);
                sil_i_bounds_add(&above[i / 8], &tree->box[below + i]);
            }
        }
    }
    sil_i_give(&heap->allocator, codes);
    sil_i_give(&heap->allocator, spare);
}

/* A walk to all items whose boxes come within `pad` of a segment: a few more may come up, none is missed. */
typedef struct sil_i_walk {
    const sil_i_bvh *tree;
    double from[3], along[3], pad;
    uint32_t stack[8 * SIL_I_LEVELS];
    unsigned char level[8 * SIL_I_LEVELS];
    size_t top;
} sil_i_walk;

static void sil_i_walk_begin(sil_i_walk *walk, const sil_i_bvh *tree, const double *from, const double *to,
                             double pad) {
    int k;
    walk->tree = tree;
    walk->pad = pad;
    for (k = 0; k < 3; ++k) {
        walk->from[k] = from[k];
        walk->along[k] = to[k] - from[k];
    }
    walk->stack[0] = 0;
    walk->level[0] = (unsigned char)tree->levels;
    walk->top = tree->count != 0;
}

/* By slabs. Along an axis nothing is rounded but the place where the box begins, which allows for that. */
static int sil_i_walk_meets(const sil_i_walk *walk, const sil_i_bounds *box) {
    double begin = 0, end = 1;
    int k;
    for (k = 0; k < 3; ++k) {
        const double low = box->low[k] - walk->pad - walk->from[k], high = box->high[k] + walk->pad - walk->from[k];
        const double d = walk->along[k];
        double t0, t1;
        if ((low > 0 && high > 0 && d <= 0) || (low < 0 && high < 0 && d >= 0))
            return 0;
        if (!(sil_i_abs(d) > 1e-300))
            continue;
        t0 = (d > 0 ? low : high) / d - 1e-9;
        t1 = (d > 0 ? high : low) / d + 1e-9;
        begin = t0 > begin ? t0 : begin;
        end = t1 < end ? t1 : end;
    }
    return begin <= end;
}

/* The next item, or SIL_NONE. */
static uint32_t sil_i_walk_next(sil_i_walk *walk) {
    const sil_i_bvh *tree = walk->tree;
    while (walk->top) {
        const unsigned level = walk->level[--walk->top];
        const size_t at = walk->stack[walk->top];
        size_t width, i;
        if (!sil_i_walk_meets(walk, &tree->box[tree->first[level] + at]))
            continue;
        if (!level)
            return tree->item[at];
        width = tree->first[level] - tree->first[level - 1];
        for (i = 8 * at; i < 8 * at + 8 && i < width; ++i) {
            walk->stack[walk->top] = (uint32_t)i;
            walk->level[walk->top++] = (unsigned char)(level - 1);
        }
    }
    return SIL_NONE;
}

/* ---- cracks and slivers ---- */

/* Where a border is cut: side of a face, how far along it, at which vertex. */
typedef struct sil_i_slit {
    double along;
    uint32_t side, vertex;
} sil_i_slit;

/* The longest side of a face with area, whatever the order of the faces. */
static int sil_i_longest_side(const sil_mesh *mesh, uint32_t face) {
    double longest = -1;
    uint32_t best[2] = {0, 0};
    int i, k, side = 0;
    for (i = 0; i < 3; ++i) {
        double square = 0;
        uint32_t v[2];
        sil_i_side(mesh, 3 * face + (uint32_t)i, v);
        for (k = 0; k < 3; ++k) {
            const double d = (double)mesh->rest.position[3 * (size_t)v[1] + (size_t)k] -
                             (double)mesh->rest.position[3 * (size_t)v[0] + (size_t)k];
            square += d * d;
        }
        if (square > longest || (square >= longest && (v[0] < best[0] || (v[0] == best[0] && v[1] < best[1])))) {
            longest = square;
            memcpy(best, v, sizeof best);
            side = i;
        }
    }
    return side;
}

/* Twice the area of three points, squared. */
static double sil_i_area_square(const sil_mesh *mesh, const uint32_t *corner) {
    double n[3], error;
    sil_i_normal(&mesh->rest, corner, n, &error);
    return n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
}

/* Faces whose third corner is nearer to the longest side than the distance are as those without area. */
static void sil_i_mark_slivers(sil_mesh *mesh, double distance) {
    size_t f;
    int k;
    for (f = 0; f < mesh->face_count; ++f) {
        double length = 0;
        uint32_t v[2];
        sil_i_side(mesh, 3 * (uint32_t)f + (uint32_t)sil_i_longest_side(mesh, (uint32_t)f), v);
        for (k = 0; k < 3; ++k) {
            const double d = (double)mesh->rest.position[3 * (size_t)v[1] + (size_t)k] -
                             (double)mesh->rest.position[3 * (size_t)v[0] + (size_t)k];
            length += d * d;
        }
        if (sil_i_area_square(mesh, mesh->corner + 3 * f) <= distance * distance * length) {
            mesh->face_flags[f] |= SIL_I_NO_AREA;
            ++mesh->flat_count;
        }
    }
}

/* How far along the side the vertex is, if it is within the distance of its inside; else -1. The ends are the ends. */
static double sil_i_cut_at(const sil_mesh *mesh, const uint32_t end[2], uint32_t vertex, double distance) {
    const float *p = mesh->rest.position + 3 * (size_t)end[0], *q = mesh->rest.position + 3 * (size_t)end[1];
    const float *v = mesh->rest.position + 3 * (size_t)vertex;
    double length = 0, along = 0, to_p = 0, to_q = 0, aside = 0, t;
    int k;
    for (k = 0; k < 3; ++k) {
        const double d = (double)q[k] - (double)p[k], e = (double)v[k] - (double)p[k], f = (double)v[k] - (double)q[k];
        length += d * d;
        along += d * e;
        to_p += e * e;
        to_q += f * f;
    }
    if (!(along > 0) || !(along < length) || !(to_p > distance * distance) || !(to_q > distance * distance))
        return -1;
    t = along / length;
    for (k = 0; k < 3; ++k) {
        const double d = (double)v[k] - (double)p[k] - t * ((double)q[k] - (double)p[k]);
        aside += d * d;
    }
    return aside <= distance * distance ? t : -1;
}

/* The cuts of borders, from sides sorted by their vertices; of faces with area only. With `cuts` NULL they are counted.
   `tree` is over the vertices listed in `borders`. */
static size_t sil_i_find_cuts(const sil_mesh *mesh, const uint32_t *sides, const sil_i_bvh *tree,
                              const uint32_t *borders, double distance, sil_i_slit *cuts) {
    size_t i, j, count = 0;
    int k;
    for (i = 0; i < 3 * mesh->face_count; i = j) {
        uint32_t end[2], found;
        double p[2][3];
        sil_i_walk walk;
        j = sil_i_run_end(mesh, sides, i);
        if (j - i > 1 || mesh->face_flags[sides[i] / 3] & SIL_I_NO_AREA)
            continue;
        end[0] = mesh->corner[sides[i]];
        end[1] = mesh->corner[sides[i] % 3 == 2 ? sides[i] - 2 : sides[i] + 1];
        for (k = 0; k < 3; ++k) {
            p[0][k] = (double)mesh->rest.position[3 * (size_t)end[0] + (size_t)k];
            p[1][k] = (double)mesh->rest.position[3 * (size_t)end[1] + (size_t)k];
        }
        sil_i_walk_begin(&walk, tree, p[0], p[1], distance);
        while ((found = sil_i_walk_next(&walk)) != SIL_NONE) {
            const double t = sil_i_cut_at(mesh, end, borders[found], distance);
            if (t < 0)
                continue;
            if (cuts) {
                cuts[count].along = t;
                cuts[count].side = sides[i];
                cuts[count].vertex = borders[found];
            }
            ++count;
        }
    }
    return count;
}

/* Sorts cuts by side, then along it. */
static int sil_i_cut_before(const sil_i_slit *a, const sil_i_slit *b) {
    if (a->side != b->side)
        return a->side < b->side;
    if (a->along < b->along || b->along < a->along)
        return a->along < b->along;
    return a->vertex < b->vertex;
}

static void sil_i_sort_cuts(sil_i_slit *cuts, sil_i_slit *spare, size_t count) {
    size_t width, i, left, right;
    for (width = 1; width < count; width *= 2) {
        for (i = 0; i < count; i += 2 * width) {
            const size_t middle = i + width < count ? i + width : count;
            const size_t end = middle + width < count ? middle + width : count;
            size_t at = i;
            for (left = i, right = middle; left < middle || right < end; ++at) {
                const int take_right = left == middle || (right < end && sil_i_cut_before(&cuts[right], &cuts[left]));
                spare[at] = cuts[take_right ? right++ : left++];
            }
        }
        memcpy(cuts, spare, count * sizeof *cuts);
    }
}

/* Corners of the pieces of one face, and the one of them with the largest area first. */
typedef struct sil_i_pieces {
    const sil_mesh *mesh;
    uint32_t *corner;
    size_t count;
    double largest;
} sil_i_pieces;

static void sil_i_add_piece(sil_i_pieces *out, uint32_t a, uint32_t b, uint32_t c) {
    uint32_t *corner = out->corner + 3 * out->count;
    double area;
    int k;
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    area = sil_i_area_square(out->mesh, corner);
    if (out->count++ == 0 || area > out->largest) {
        for (k = 0; k < 3; ++k)
            sil_i_swap_words(&out->corner[k], &corner[k]);
        out->largest = area;
    }
}

/* Pieces from an apex to a way from one corner over cuts to another. */
static void sil_i_add_fan(sil_i_pieces *out, uint32_t apex, uint32_t from, const sil_i_slit *cuts, size_t count,
                          uint32_t to) {
    size_t i;
    for (i = 0; i < count; ++i) {
        sil_i_add_piece(out, apex, from, cuts[i].vertex);
        from = cuts[i].vertex;
    }
    sil_i_add_piece(out, apex, from, to);
}

/* A face with cuts on sides 0, 1, 2 (count[0] of them, and so on, all in a row) to pieces of which none is flat unless
   the face is. */
static void sil_i_cut_face(sil_i_pieces *out, const uint32_t *corner, const sil_i_slit *cuts, const size_t count[3]) {
    int s = 0, k;
    const sil_i_slit *first[3];
    uint32_t c0, c1, c2;
    for (k = 0; k < 3; ++k) {
        first[k] = cuts;
        cuts += count[k];
    }
    while (!count[s])
        ++s; /* turned so that side 0 has cuts */
    c0 = corner[s];
    c1 = corner[(s + 1) % 3];
    c2 = corner[(s + 2) % 3];
    if (count[s] > 1)
        sil_i_add_fan(out, c2, first[s][0].vertex, first[s] + 1, count[s] - 2, first[s][count[s] - 1].vertex);
    sil_i_add_fan(out, first[s][count[s] - 1].vertex, c1, first[(s + 1) % 3], count[(s + 1) % 3], c2);
    sil_i_add_fan(out, first[s][0].vertex, c2, first[(s + 2) % 3], count[(s + 2) % 3], c0);
}

/* Replaces each face that has cuts by its pieces, which share its source: the largest first, the others borrow its sign,
   so that the lines between pieces are never any. */
static void sil_i_cut_faces(sil_mesh *mesh, const sil_i_slit *cuts, size_t cut_count, size_t face_bytes,
                            sil_i_heap *heap) {
    const size_t faces = mesh->face_count + cut_count;
    uint32_t *corner = sil_i_take_words(heap, 3 * faces), *source = sil_i_take_words(heap, faces);
    unsigned char *flags = sil_i_take_bytes(heap, faces);
    size_t f, i, k, at = 0;
    for (f = 0, i = 0; f < mesh->face_count && !heap->failed; ++f) {
        size_t count[3] = {0, 0, 0}, all = i;
        sil_i_pieces out;
        while (all < cut_count && cuts[all].side / 3 == f)
            ++count[cuts[all++].side % 3];
        memset(&out, 0, sizeof out);
        out.mesh = mesh;
        out.corner = corner + 3 * at;
        if (all > i)
            sil_i_cut_face(&out, mesh->corner + 3 * f, cuts + i, count);
        else
            sil_i_add_piece(&out, mesh->corner[3 * f], mesh->corner[3 * f + 1], mesh->corner[3 * f + 2]);
        for (k = 0; k < out.count; ++k) {
            source[at + k] = mesh->source[f];
            flags[at + k] = (unsigned char)(mesh->face_flags[f] | (k ? SIL_I_PIECE : 0));
        }
        at += out.count;
        i = all;
    }
    sil_i_give(&heap->allocator, mesh->corner);
    sil_i_give(&heap->allocator, mesh->source);
    sil_i_give(&heap->allocator, mesh->face_flags);
    heap->bytes -= face_bytes;
    mesh->corner = corner;
    mesh->source = source;
    mesh->face_flags = flags;
    mesh->face_count = heap->failed ? 0 : at;
    mesh->piece_count = cut_count;
    mesh->info.t_junction_count = cut_count;
}

/* The vertices of borders, as boxes of no size. Returns their number. */
static size_t sil_i_list_borders(const sil_mesh *mesh, const uint32_t *sides, unsigned char *listed, uint32_t *borders,
                                 sil_i_bounds *boxes) {
    size_t i, j, count = 0;
    uint32_t v[2];
    int k;
    for (i = 0; i < 3 * mesh->face_count; i = j) {
        j = sil_i_run_end(mesh, sides, i);
        sil_i_side(mesh, sides[i], v);
        for (k = 0; k < 2 && j - i == 1; ++k)
            if (!listed[v[k]]) {
                listed[v[k]] = 1;
                sil_i_bounds_none(&boxes[count]);
                sil_i_bounds_point(&boxes[count], mesh->rest.position + 3 * (size_t)v[k]);
                borders[count++] = v[k];
            }
    }
    return count;
}

/* T-junctions: sides of one face only are cut at the vertices of others that lie on them. face_bytes: what the arrays
   of faces take. */
static void sil_i_close_cracks(sil_mesh *mesh, double distance, size_t face_bytes, sil_i_heap *heap,
                               sil_i_heap *scratch) {
    uint32_t *first = sil_i_take_words(scratch, 3 * mesh->face_count);
    uint32_t *sides = sil_i_take_words(scratch, 3 * mesh->face_count);
    size_t *starts = (size_t *)sil_i_take(scratch, mesh->unique_count, sizeof(size_t)), count;
    uint32_t *borders = sil_i_take_words(scratch, mesh->unique_count);
    unsigned char *listed = sil_i_take_bytes(scratch, mesh->unique_count);
    sil_i_bounds *boxes = (sil_i_bounds *)sil_i_take(scratch, mesh->unique_count, sizeof(sil_i_bounds));
    sil_i_bvh tree;
    memset(&tree, 0, sizeof tree);
    sil_i_mark_slivers(mesh, distance);
    if (!scratch->failed) {
        sil_i_sort_sides(mesh, NULL, first, 1, starts);
        sil_i_sort_sides(mesh, first, sides, 0, starts);
        count = sil_i_list_borders(mesh, sides, listed, borders, boxes);
        sil_i_bvh_make(&tree, boxes, count, scratch);
    }
    if (!scratch->failed && (count = sil_i_find_cuts(mesh, sides, &tree, borders, distance, NULL)) > 0) {
        sil_i_slit *cuts = (sil_i_slit *)sil_i_take(scratch, 2 * count, sizeof(sil_i_slit));
        if (mesh->face_count + count >= 0x10000000u)
            heap->failed = 1;
        if (!scratch->failed && !heap->failed) {
            (void)sil_i_find_cuts(mesh, sides, &tree, borders, distance, cuts);
            sil_i_sort_cuts(cuts, cuts + count, count);
            sil_i_cut_faces(mesh, cuts, count, face_bytes, heap);
        }
        sil_i_give(&scratch->allocator, cuts);
    }
    sil_i_bvh_give(&scratch->allocator, &tree);
    sil_i_give(&scratch->allocator, first);
    sil_i_give(&scratch->allocator, sides);
    sil_i_give(&scratch->allocator, starts);
    sil_i_give(&scratch->allocator, borders);
    sil_i_give(&scratch->allocator, listed);
    sil_i_give(&scratch->allocator, boxes);
}

/* ---- rays, exactly ---- */

/* On which side of the line a b a point lies, seen along an axis. A point on the line counts as moved by next to
   nothing along the one other axis, and by still less along the next: of the faces at an edge or a vertex that a ray
   meets, it then passes through one, or through none where they fold. 0: the line is a point. */
static int sil_i_side_along(const float *a, const float *b, const float *point, int axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    float direction[3] = {0, 0, 0};
    int sign;
    direction[axis] = 1;
    sign = sil_i_side_of(a, b, point, direction, 0);
    if (!sign)
        sign = (a[j] > b[j]) - (a[j] < b[j]);
    if (!sign)
        sign = (b[i] > a[i]) - (b[i] < a[i]);
    return sign;
}

/* How a ray from a point along an axis meets a face: 1 it passes through, 0 it does not, 2 the point lies in the face. */
static int sil_i_ray_meets(const sil_mesh *mesh, uint32_t face, const float *point, int axis) {
    const uint32_t *corner = mesh->corner + 3 * (size_t)face;
    const float *p[3];
    int k, turn = 0, height;
    for (k = 0; k < 3; ++k)
        p[k] = mesh->rest.position + 3 * (size_t)corner[k];
    for (k = 0; k < 3; ++k) {
        const int sign = sil_i_side_along(p[k], p[(k + 1) % 3], point, axis);
        if (!sign || (turn && sign != turn))
            return 0;
        turn = sign;
    }
    height = sil_i_side_of(p[0], p[1], p[2], point, 1);
    return !height ? 2 : height == -turn;
}

/* A ray among the faces of a mesh that a tree is over. */
typedef struct sil_i_ray {
    sil_i_walk walk;
    const sil_mesh *mesh;
    const float *point;
    int axis, touches;     /* touches: the point lies in a face */
    const uint32_t *label; /* of each face; NULL: all are met */
    uint32_t only;         /* the label of those that are */
} sil_i_ray;

static void sil_i_ray_begin(sil_i_ray *ray, const sil_mesh *mesh, const sil_i_bvh *tree, const float *point, int axis) {
    double from[3], to[3];
    int k;
    for (k = 0; k < 3; ++k)
        from[k] = to[k] = (double)point[k];
    to[axis] = 1e39; /* beyond all floats */
    sil_i_walk_begin(&ray->walk, tree, from, to, 0);
    ray->mesh = mesh;
    ray->point = point;
    ray->axis = axis;
    ray->touches = 0;
    ray->label = NULL;
    ray->only = 0;
}

/* The next face that the ray passes through, or SIL_NONE. */
static uint32_t sil_i_ray_next(sil_i_ray *ray) {
    uint32_t face;
    while ((face = sil_i_walk_next(&ray->walk)) != SIL_NONE) {
        const int is_met = !ray->label || ray->label[face] == ray->only;
        const int meets = is_met ? sil_i_ray_meets(ray->mesh, face, ray->point, ray->axis) : 0;
        if (meets == 1)
            return face;
        ray->touches |= meets == 2;
    }
    return SIL_NONE;
}

/* A tree over all faces. */
static void sil_i_face_tree(const sil_mesh *mesh, sil_i_bvh *tree, sil_i_heap *heap) {
    sil_i_bounds *boxes = (sil_i_bounds *)sil_i_take(heap, mesh->face_count, sizeof(sil_i_bounds));
    size_t i;
    for (i = 0; i < 3 * mesh->face_count && boxes; ++i) {
        if (i % 3 == 0)
            sil_i_bounds_none(&boxes[i / 3]);
        sil_i_bounds_point(&boxes[i / 3], mesh->rest.position + 3 * (size_t)mesh->corner[i]);
    }
    memset(tree, 0, sizeof *tree);
    if (boxes)
        sil_i_bvh_make(tree, boxes, mesh->face_count, heap);
    sil_i_give(&heap->allocator, boxes);
}

/* ---- what faces and edges are to each other ---- */

/* The face across an edge of exactly two faces, else SIL_NONE. */
static uint32_t sil_i_across(const sil_mesh *mesh, uint32_t edge, uint32_t face) {
    const uint32_t f0 = mesh->edge_face[0][edge], f1 = mesh->edge_face[1][edge];
    if (mesh->edge_kinds[edge] & SIL_I_MANY || f0 == f1)
        return SIL_NONE;
    return f0 == face ? f1 : f1 == face ? f0 : SIL_NONE;
}

/* Does the face pass along the edge from the smaller to the larger vertex? */
static int sil_i_rises(const sil_mesh *mesh, uint32_t face, uint32_t edge) {
    const uint32_t *corner = mesh->corner + 3 * (size_t)face, *v = mesh->edge_vertex + 2 * (size_t)edge;
    return (corner[0] == v[0] && corner[1] == v[1]) || (corner[1] == v[0] && corner[2] == v[1]) ||
           (corner[2] == v[0] && corner[0] == v[1]);
}

static void sil_i_reverse_face(sil_mesh *mesh, uint32_t face) {
    int k;
    sil_i_swap_words(&mesh->corner[3 * (size_t)face + 1], &mesh->corner[3 * (size_t)face + 2]);
    sil_i_swap_words(&mesh->face_edge[3 * (size_t)face], &mesh->face_edge[3 * (size_t)face + 2]);
    for (k = 0; k < 4; ++k)
        mesh->rest.plane[k][face] = -mesh->rest.plane[k][face];
}

/* Winds two-sided faces as their neighbours are: first from one-sided faces, then from the first face of each set that
   is left. Only across edges of two faces. */
static void sil_i_orient(sil_mesh *mesh, sil_i_heap *scratch) {
    uint32_t *queue;
    unsigned char *done;
    size_t begin = 0, end = 0, f, next = 0;
    if (!mesh->info.two_sided_face_count)
        return;
    queue = sil_i_take_words(scratch, mesh->face_count);
    done = sil_i_take_bytes(scratch, mesh->face_count);
    if (!scratch->failed) {
        for (f = 0; f < mesh->face_count; ++f)
            if (!(mesh->face_flags[f] & SIL_I_TWO_SIDED)) {
                done[f] = 1;
                queue[end++] = (uint32_t)f;
            }
        while (end < mesh->face_count || begin < end) {
            uint32_t face;
            int i;
            if (begin == end) {
                while (done[next])
                    ++next;
                done[next] = 1;
                queue[end++] = (uint32_t)next;
            }
            face = queue[begin++];
            for (i = 0; i < 3; ++i) {
                const uint32_t edge = mesh->face_edge[3 * (size_t)face + (size_t)i];
                const uint32_t other = sil_i_across(mesh, edge, face);
                if (other == SIL_NONE || done[other])
                    continue;
                if (sil_i_rises(mesh, face, edge) == sil_i_rises(mesh, other, edge))
                    sil_i_reverse_face(mesh, other);
                done[other] = 1;
                queue[end++] = other;
            }
        }
    }
    sil_i_give(&scratch->allocator, queue);
    sil_i_give(&scratch->allocator, done);
}

/* ---- SIL_MESH_ORIENT ---- */

/* A set of faces that are connected by edges of two faces. */
typedef struct sil_i_body {
    double volume; /* times 6, about a point of its own */
    double turned; /* area of the faces that were reversed, less that of the others */
    size_t seams;  /* neighbours that cannot be made to agree, twice each */
    uint32_t face; /* the first */
    int open, changed, reverse;
} sil_i_body;

/* Winds the faces of one body as the first one is. Returns how many faces it has: queue[0 ...]. */
static size_t sil_i_gather_body(sil_mesh *mesh, uint32_t start, uint32_t number, uint32_t *body_of,
                                unsigned char *turned, uint32_t *queue) {
    size_t begin = 0, end = 1;
    int i;
    body_of[start] = number;
    queue[0] = start;
    while (begin < end) {
        const uint32_t face = queue[begin++];
        for (i = 0; i < 3; ++i) {
            const uint32_t edge = mesh->face_edge[3 * (size_t)face + (size_t)i];
            const uint32_t other = sil_i_across(mesh, edge, face);
            if (other == SIL_NONE || body_of[other] != SIL_NONE)
                continue;
            if (sil_i_rises(mesh, face, edge) == sil_i_rises(mesh, other, edge)) {
                sil_i_reverse_face(mesh, other);
                turned[other] = 1;
            }
            body_of[other] = number;
            queue[end++] = other;
        }
    }
    return end;
}

/* What is to be known of a body, once its faces agree as far as they can. */
static void sil_i_measure_body(const sil_mesh *mesh, const uint32_t *faces, size_t count, const unsigned char *turned,
                               sil_i_body *body) {
    const float *origin = mesh->rest.position + 3 * (size_t)mesh->corner[3 * (size_t)faces[0]];
    size_t f;
    int i, k;
    memset(body, 0, sizeof *body);
    body->face = faces[0];
    for (f = 0; f < count; ++f) {
        const uint32_t face = faces[f], *corner = mesh->corner + 3 * (size_t)face;
        double n[3], error, square = 0;
        for (i = 0; i < 3; ++i) {
            const uint32_t edge = mesh->face_edge[3 * (size_t)face + (size_t)i];
            const uint32_t other = sil_i_across(mesh, edge, face);
            body->open |= other == SIL_NONE;
            body->seams += other != SIL_NONE && sil_i_rises(mesh, face, edge) == sil_i_rises(mesh, other, edge);
        }
        sil_i_normal(&mesh->rest, corner, n, &error);
        for (k = 0; k < 3; ++k) {
            const double from = (double)mesh->rest.position[3 * (size_t)corner[0] + (size_t)k] - (double)origin[k];
            body->volume += n[k] * from;
            square += n[k] * n[k];
        }
        /* A face in both windings has none of its own. */
        if (!(mesh->face_flags[face] & SIL_I_TWO_SIDED)) {
            body->turned += turned[face] ? sqrt(square) : -sqrt(square);
            body->changed |= turned[face];
        }
    }
}

/* Is the body inside an odd number of other solids? By most of three rays from a corner of it. */
static int sil_i_body_is_inside(const sil_mesh *mesh, const sil_i_bvh *tree, const sil_i_body *bodies,
                                const uint32_t *body_of, uint32_t number) {
    const float *point = mesh->rest.position + 3 * (size_t)mesh->corner[3 * (size_t)bodies[number].face];
    int axis, votes = 0;
    for (axis = 0; axis < 3; ++axis) {
        sil_i_ray ray;
        uint32_t face;
        int odd = 0;
        sil_i_ray_begin(&ray, mesh, tree, point, axis);
        while ((face = sil_i_ray_next(&ray)) != SIL_NONE) {
            const sil_i_body *other = &bodies[body_of[face]];
            odd ^= body_of[face] != number && !other->open && !other->seams;
        }
        votes += odd;
    }
    return votes >= 2;
}

/* Solids are to be wound outward, cavities in them inward, and so on; anything else as most of its area was. */
static void sil_i_judge_bodies(const sil_mesh *mesh, sil_i_body *bodies, uint32_t count, const uint32_t *body_of,
                               sil_i_heap *scratch) {
    sil_i_bvh tree;
    uint32_t i;
    size_t solids = 0;
    for (i = 0; i < count; ++i) {
        bodies[i].reverse = bodies[i].turned > 0;
        solids += !bodies[i].open && !bodies[i].seams;
    }
    memset(&tree, 0, sizeof tree);
    if (solids > 1)
        sil_i_face_tree(mesh, &tree, scratch);
    for (i = 0; i < count && !scratch->failed; ++i)
        if (!bodies[i].open && !bodies[i].seams && (bodies[i].volume < 0 || bodies[i].volume > 0)) {
            const int inside = solids > 1 && sil_i_body_is_inside(mesh, &tree, bodies, body_of, i);
            bodies[i].reverse = (bodies[i].volume < 0) != inside;
        }
    sil_i_bvh_give(&scratch->allocator, &tree);
}

static void sil_i_orient_all(sil_mesh *mesh, sil_i_heap *scratch) {
    uint32_t *body_of = sil_i_take_words(scratch, mesh->face_count), *queue;
    unsigned char *turned = sil_i_take_bytes(scratch, mesh->face_count);
    sil_i_body *bodies;
    uint32_t f, count = 0, at;
    queue = sil_i_take_words(scratch, mesh->face_count);
    bodies = (sil_i_body *)sil_i_take(scratch, mesh->face_count, sizeof(sil_i_body));
    if (!scratch->failed) {
        memset(body_of, 0xff, mesh->face_count * sizeof(uint32_t));
        for (f = 0; f < mesh->face_count; ++f)
            if (body_of[f] == SIL_NONE) {
                const size_t faces = sil_i_gather_body(mesh, f, count, body_of, turned, queue);
                sil_i_measure_body(mesh, queue, faces, turned, &bodies[count++]);
            }
        sil_i_judge_bodies(mesh, bodies, count, body_of, scratch);
    }
    for (at = 0; at < mesh->face_count && !scratch->failed; ++at) {
        if (bodies[body_of[at]].reverse) {
            sil_i_reverse_face(mesh, at);
            turned[at] ^= 1;
        }
        mesh->info.reversed_face_count +=
            turned[at] && !(mesh->face_flags[at] & (SIL_I_TWO_SIDED | SIL_I_PIECE)) ? 1u : 0u;
    }
    sil_i_give(&scratch->allocator, body_of);
    sil_i_give(&scratch->allocator, turned);
    sil_i_give(&scratch->allocator, queue);
    sil_i_give(&scratch->allocator, bodies);
}

/* ---- whose sign faces without one take ---- */

/* Lexicographic order of positions: along a line it is the order on the line. */
static int sil_i_before(const sil_mesh *mesh, uint32_t a, uint32_t b) {
    int k;
    for (k = 0; k < 3; ++k) {
        const float x = mesh->rest.position[3 * (size_t)a + (size_t)k];
        const float y = mesh->rest.position[3 * (size_t)b + (size_t)k];
        if (x < y || y < x)
            return x < y;
    }
    return a < b;
}

/* The longest edge of a face without area: the one across from the corner that lies between the other two. Exact where
   all three are on a line. */
static uint32_t sil_i_longest_edge(const sil_mesh *mesh, uint32_t face) {
    const uint32_t *corner = mesh->corner + 3 * (size_t)face;
    const float *p = mesh->rest.position;
    int i;
    if (!sil_i_collinear(p + 3 * (size_t)corner[0], p + 3 * (size_t)corner[1], p + 3 * (size_t)corner[2]))
        return mesh->face_edge[3 * (size_t)face + (size_t)sil_i_longest_side(mesh, face)];
    for (i = 0; i < 2; ++i)
        if (sil_i_before(mesh, corner[i], corner[(i + 1) % 3]) != sil_i_before(mesh, corner[i], corner[(i + 2) % 3]))
            break;
    return mesh->face_edge[3 * (size_t)face + (size_t)((i + 1) % 3)];
}

#define SIL_I_UNKNOWN 0xfffffffeu /* a root not looked for yet */
#define SIL_I_ON_PATH 0xfffffffdu /* on the path being followed */

/* Follows longest edges from a face without area to a face with a root, and gives that root to all on the way. */
static void sil_i_follow(const sil_mesh *mesh, uint32_t face, uint32_t *root, uint32_t *path) {
    size_t length = 0;
    uint32_t found;
    while (face != SIL_NONE && root[face] == SIL_I_UNKNOWN) {
        root[face] = SIL_I_ON_PATH;
        path[length++] = face;
        face = sil_i_across(mesh, sil_i_longest_edge(mesh, face), face);
    }
    found = face == SIL_NONE || root[face] == SIL_I_ON_PATH ? SIL_NONE : root[face];
    while (length)
        root[path[--length]] = found;
}

/* Faces whose way along longest edges ends nowhere take the root of a neighbour that has one, the nearest ones first.
   */
static void sil_i_spread(const sil_mesh *mesh, uint32_t *root, uint32_t *queue) {
    size_t begin = 0, end = 0, f;
    int i;
    for (f = 0; f < mesh->face_count; ++f)
        for (i = 0; i < 3 && root[f] == SIL_NONE; ++i) {
            const uint32_t other = sil_i_across(mesh, mesh->face_edge[3 * f + (size_t)i], (uint32_t)f);
            if (other != SIL_NONE && root[other] == other) {
                root[f] = other;
                queue[end++] = (uint32_t)f;
            }
        }
    while (begin < end) {
        const uint32_t face = queue[begin++];
        for (i = 0; i < 3; ++i) {
            const uint32_t other = sil_i_across(mesh, mesh->face_edge[3 * (size_t)face + (size_t)i], face);
            if (other != SIL_NONE && root[other] == SIL_NONE) {
                root[other] = root[face];
                queue[end++] = other;
            }
        }
    }
}

static void sil_i_build_roots(sil_mesh *mesh, sil_i_heap *heap, sil_i_heap *scratch) {
    uint32_t *root, *path;
    size_t f, at = 0;
    mesh->flat_count += mesh->piece_count;
    mesh->flat_face = sil_i_take_words(heap, mesh->flat_count);
    mesh->flat_root = sil_i_take_words(heap, mesh->flat_count);
    if (heap->failed || !mesh->flat_count)
        return;
    root = sil_i_take_words(scratch, mesh->face_count);
    path = sil_i_take_words(scratch, mesh->flat_count);
    if (!scratch->failed) {
        for (f = 0; f < mesh->face_count; ++f) /* the first piece comes before the others, and has area */
            root[f] = mesh->face_flags[f] & SIL_I_NO_AREA ? SIL_I_UNKNOWN
                      : mesh->face_flags[f] & SIL_I_PIECE ? root[f - 1]
                                                          : (uint32_t)f;
        for (f = 0; f < mesh->face_count; ++f)
            sil_i_follow(mesh, (uint32_t)f, root, path);
        sil_i_spread(mesh, root, path);
        for (f = 0; f < mesh->face_count; ++f)
            if (mesh->face_flags[f] & SIL_I_BORROWS) {
                mesh->flat_face[at] = (uint32_t)f;
                mesh->flat_root[at++] = root[f];
            }
        sil_i_flat_planes(mesh, &mesh->rest);
    }
    sil_i_give(&scratch->allocator, root);
    sil_i_give(&scratch->allocator, path);
}

/* The face that a face's sign and normal come from: itself, unless it has no area. */
static uint32_t sil_i_sign_face(const sil_mesh *mesh, uint32_t face) {
    return mesh->face_flags[face] & SIL_I_BORROWS ? sil_i_root(mesh, face) : face;
}

/* The angle between two faces' normals in degrees; `flipped` where the faces are wound in opposite senses. */
static double sil_i_dihedral(const sil_mesh *mesh, uint32_t face0, uint32_t face1, int flipped) {
    double n[2][3], cross[3], dot = 0, error;
    const uint32_t face[2] = {face0, face1};
    int i, k;
    for (i = 0; i < 2; ++i) {
        double length;
        sil_i_normal(&mesh->rest, mesh->corner + 3 * (size_t)face[i], n[i], &error);
        length = sqrt(n[i][0] * n[i][0] + n[i][1] * n[i][1] + n[i][2] * n[i][2]);
        for (k = 0; k < 3; ++k)
            n[i][k] = length > 0 ? n[i][k] / length : 0;
    }
    for (k = 0; k < 3; ++k) {
        cross[k] = n[0][(k + 1) % 3] * n[1][(k + 2) % 3] - n[0][(k + 2) % 3] * n[1][(k + 1) % 3];
        dot += n[0][k] * n[1][k];
    }
    return atan2(sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]), flipped ? -dot : dot) *
           (180 / SIL_I_PI);
}

/* The place of an edge with SIL_I_MANY in many_edge. */
static size_t sil_i_find_many(const sil_mesh *mesh, uint32_t edge) {
    return sil_i_find_word(mesh->many_edge, mesh->many_count, edge);
}

/* An edge of many where faces without area stayed because there are no two others: a border if only one of its faces
   takes a sign. */
static unsigned sil_i_sliver_kinds(sil_mesh *mesh, uint32_t edge) {
    const size_t at = sil_i_find_many(mesh, edge);
    uint32_t i, signs = 0;
    for (i = mesh->many_first[at]; i < mesh->many_first[at + 1]; ++i)
        signs += sil_i_sign_face(mesh, mesh->many_face[i]) != SIL_NONE;
    mesh->info.boundary_edge_count += signs == 1;
    return signs == 1 ? SIL_I_MANY | (unsigned)SIL_BOUNDARY : SIL_I_MANY;
}

/* What an edge is in every view, and the counts of it. */
static unsigned sil_i_fixed_kinds(sil_mesh *mesh, uint32_t edge, double crease) {
    const uint32_t f0 = mesh->edge_face[0][edge], f1 = mesh->edge_face[1][edge];
    const uint32_t s0 = sil_i_sign_face(mesh, f0), s1 = sil_i_sign_face(mesh, f1);
    int flipped;
    if (mesh->edge_kinds[edge] & SIL_I_MANY) {
        if ((mesh->face_flags[f0] | mesh->face_flags[f1]) & SIL_I_NO_AREA)
            return sil_i_sliver_kinds(mesh, edge);
        ++mesh->info.nonmanifold_edge_count;
        return SIL_I_MANY | SIL_NONMANIFOLD;
    }
    if (f0 == f1) {
        mesh->info.boundary_edge_count += s0 != SIL_NONE;
        return s0 != SIL_NONE ? SIL_BOUNDARY : 0;
    }
    if (s0 == SIL_NONE || s1 == SIL_NONE || s0 == s1)
        return 0;
    flipped = sil_i_rises(mesh, f0, edge) == sil_i_rises(mesh, f1, edge);
    if (!((mesh->face_flags[f0] | mesh->face_flags[f1]) & SIL_I_NO_AREA))
        mesh->info.flipped_edge_count += (size_t)flipped;
    else
        flipped = 0; /* a face without area has no sense of its own */
    if (!(sil_i_dihedral(mesh, s0, s1, flipped) > crease))
        return 0;
    ++mesh->info.crease_edge_count;
    return SIL_CREASE;
}

/* SIL_PART_BORDER where the faces of an edge are not all of one part. Faces without area are of that whose sign they
   take. */
static unsigned sil_i_part_border(sil_mesh *mesh, uint32_t edge, const uint32_t *parts) {
    const uint32_t *face = NULL;
    uint32_t pair[2], count = 2, known = SIL_NONE, i;
    if (!parts)
        return 0;
    pair[0] = mesh->edge_face[0][edge];
    pair[1] = mesh->edge_face[1][edge];
    face = pair;
    if (mesh->edge_kinds[edge] & SIL_I_MANY) {
        const size_t at = sil_i_find_many(mesh, edge);
        face = mesh->many_face + mesh->many_first[at];
        count = mesh->many_first[at + 1] - mesh->many_first[at];
    }
    for (i = 0; i < count; ++i) {
        const uint32_t from = sil_i_sign_face(mesh, face[i]);
        if (from != SIL_NONE && known != SIL_NONE && parts[mesh->source[from]] != parts[mesh->source[known]]) {
            ++mesh->info.part_border_edge_count;
            return SIL_PART_BORDER;
        }
        known = from != SIL_NONE ? from : known;
    }
    return 0;
}

/* SIL_CONVEX, SIL_CONCAVE or 0: on which side of its first face's plane is the third corner of the second? The sign of
   that corner, as an eye, is the same with the faces exchanged. */
static unsigned sil_i_fold(const sil_mesh *mesh, uint32_t edge) {
    const uint32_t f0 = mesh->edge_face[0][edge], f1 = mesh->edge_face[1][edge];
    const uint32_t *v = mesh->edge_vertex + 2 * (size_t)edge, *b = mesh->corner + 3 * (size_t)f1;
    int sign, k = 0;
    if (mesh->edge_kinds[edge] & SIL_I_MANY || f0 == f1 ||
        (mesh->face_flags[f0] | mesh->face_flags[f1]) & (SIL_I_TWO_SIDED | SIL_I_NO_AREA) ||
        sil_i_rises(mesh, f0, edge) == sil_i_rises(mesh, f1, edge))
        return 0;
    while (b[k] == v[0] || b[k] == v[1])
        ++k;
    sign = sil_i_off_plane(mesh, f0, mesh->rest.position + 3 * (size_t)b[k]);
    return sign < 0 ? SIL_CONVEX : sign > 0 ? SIL_CONCAVE : 0;
}

static uint32_t sil_i_find_set(uint32_t *parent, uint32_t face) {
    while (parent[face] != face) {
        parent[face] = parent[parent[face]];
        face = parent[face];
    }
    return face;
}

static void sil_i_join_sets(uint32_t *parent, uint32_t a, uint32_t b) {
    a = sil_i_find_set(parent, a);
    b = sil_i_find_set(parent, b);
    if (a < b)
        parent[b] = a;
    else
        parent[a] = b;
}

/* The component of each face, numbered by their first faces. Returns how many there are. */
static uint32_t sil_i_label_components(const sil_mesh *mesh, uint32_t *label) {
    uint32_t i, count = 0;
    for (i = 0; i < mesh->face_count; ++i)
        label[i] = i;
    for (i = 0; i < 3 * mesh->face_count; ++i) /* every face with the first of each of its edges */
        sil_i_join_sets(label, i / 3, mesh->edge_face[0][mesh->face_edge[i]]);
    for (i = 0; i < mesh->face_count; ++i)
        label[i] = sil_i_find_set(label, i);
    for (i = 0; i < mesh->face_count; ++i) /* a set's first face is its name, and comes before the others */
        label[i] = label[i] == i ? count++ : label[label[i]];
    return count;
}

static void sil_i_build_components(sil_mesh *mesh, sil_i_heap *scratch) {
    uint32_t *label = sil_i_take_words(scratch, mesh->face_count);
    size_t e;
    if (label)
        mesh->info.component_count = sil_i_label_components(mesh, label);
    mesh->info.closed = mesh->face_count > 0 && !mesh->info.boundary_edge_count;
    for (e = 0; e < mesh->many_count; ++e)
        if ((mesh->many_first[e + 1] - mesh->many_first[e]) % 2)
            mesh->info.closed = 0;
    sil_i_give(&scratch->allocator, label);
}

/* ---- patches and the hierarchy ---- */

#define SIL_I_PATCH 32u   /* faces of a patch */
#define SIL_I_PLACES 128u /* faces that a patch has to do with, at most: its own, and one across each of their edges */
#define SIL_I_WORTHWHILE 4000u /* edges from which on a mesh has a hierarchy unless told otherwise */

/* Patch i is faces 32 i .. 32 i + 31. An edge belongs to the patch of the first face that has it as a side; edges are
   numbered by those. A patch also knows the faces across its edges that are not its own, its rim: where all of them
   and its own have one sign it has no silhouette. Faces have places in a patch: its own from 0 on, the rim's from 32.
   All that is read of a patch to find and write its silhouettes is in one block of cache lines: its head, with a
   hierarchy the planes at its places (see sil_i_quantise), the places of its edges' faces (32 first and 32 second ones in
   turn; 0, 0 for an edge that has not two), and its edges' records (see sil_i_set_record). */
typedef struct sil_i_patches {
    size_t count;
    uint32_t *edge_first, *rim_first; /* of each patch, and the end; rims are multiples of 8 */
    uint32_t *rim;
    uint32_t *line;                /* of each patch: where its block begins, and the end */
    unsigned char *memory, *block; /* block: the first whole cache line of memory */
    uint32_t *special;             /* edges that are more than the border of two faces, rising */
    uint32_t *lone;                /* of these the ones of many faces, or of two that are not of the edge's patch */
    size_t special_count, lone_count;
} sil_i_patches;

#define SIL_I_LINE 64u /* bytes */

typedef struct sil_i_head {
    uint32_t edge_first, edge_count, places;
    uint32_t planes; /* lines of planes */
} sil_i_head;

/* Eight boxes around float planes (normal, offset), each about an origin of its own: a plane n, d of the shape has offset
   d - n . origin there, which varies little within a small patch of a curved surface. */
typedef struct sil_i_cones {
    float origin[3][SIL_I_LANES], mid[4][SIL_I_LANES], half[4][SIL_I_LANES];
} sil_i_cones;

/* Child k of cones i of a level is patch or cones 8 * i + k of the level below. */
typedef struct sil_i_hierarchy {
    sil_i_cones *cones;
    size_t first[SIL_I_LEVELS], count[SIL_I_LEVELS]; /* of each level from 1 on: its cones, and boxes in them */
    unsigned levels;
} sil_i_hierarchy;

static void sil_i_patches_give(const sil_allocator *allocator, sil_i_patches *p) {
    sil_i_give(allocator, p->edge_first);
    sil_i_give(allocator, p->rim_first);
    sil_i_give(allocator, p->rim);
    sil_i_give(allocator, p->line);
    sil_i_give(allocator, p->memory);
    sil_i_give(allocator, p->special);
    sil_i_give(allocator, p->lone);
}

static void sil_i_hierarchy_give(const sil_allocator *allocator, sil_i_hierarchy *h) {
    sil_i_give(allocator, h->cones);
}

/* The parts of a patch's block. */
SIL_I_INLINE const sil_i_head *sil_i_patch_head(const sil_i_patches *p, size_t patch) {
    return (const sil_i_head *)(const void *)(p->block + SIL_I_LINE * (size_t)p->line[patch]);
}

SIL_I_INLINE const int16_t *sil_i_patch_planes(const sil_i_head *head) {
    return (const int16_t *)(const void *)((const unsigned char *)head + SIL_I_LINE);
}

SIL_I_INLINE const unsigned char *sil_i_patch_sides(const sil_i_head *head) {
    return (const unsigned char *)head + SIL_I_LINE * (1 + (size_t)head->planes);
}

SIL_I_INLINE const uint32_t *sil_i_patch_records(const sil_i_head *head) {
    const size_t sides = (head->edge_count + 31) / 32;
    return (const uint32_t *)(const void *)((const unsigned char *)head +
                                            SIL_I_LINE * (1 + (size_t)head->planes + sides));
}

/* What sil_extract writes of an edge, with the front face first if that is its first one: a, b, the two faces; in the
   bits that faces' numbers leave free SIL_CONVEX or SIL_CONCAVE (the first), and whether a, b stay where the other face
   is the front one, since both pass the edge in the same sense (the second). */
static void sil_i_set_record(const sil_mesh *mesh, uint32_t edge, uint32_t record[4]) {
    const uint32_t f0 = mesh->edge_face[0][edge], f1 = mesh->edge_face[1][edge];
    const uint32_t *v = mesh->edge_vertex + 2 * (size_t)edge;
    const int rises = sil_i_rises(mesh, f0, edge);
    record[0] = mesh->origin[v[!rises]];
    record[1] = mesh->origin[v[rises]];
    record[2] = mesh->source[f0] | (mesh->edge_kinds[edge] & SIL_I_FOLDS) << 24;
    record[3] = mesh->source[f1] | (uint32_t)(sil_i_rises(mesh, f1, edge) == rises) << 28;
}

/* An edge that is told by its two faces alone is not found by patches but tried in every view: one of many faces, or one
   whose faces are of other patches, since it is numbered by a sliver that was left out of its faces. */
static int sil_i_is_lone(const sil_mesh *mesh, size_t edge, size_t patch) {
    const uint32_t f0 = mesh->edge_face[0][edge], f1 = mesh->edge_face[1][edge];
    return mesh->edge_kinds[edge] & SIL_I_MANY || (f0 / SIL_I_PATCH != patch && f1 / SIL_I_PATCH != patch);
}

static int sil_i_is_found_by_patch(const sil_mesh *mesh, size_t edge, size_t patch) {
    return mesh->edge_face[0][edge] != mesh->edge_face[1][edge] && !sil_i_is_lone(mesh, edge, patch);
}

/* The rim of a patch: the faces across its edges. Their places, and those of its own faces, are written to place[]: patch
   << 8 | place. Returns their number. */
static size_t sil_i_patch_rim(const sil_mesh *mesh, const sil_i_patches *p, uint32_t patch, uint32_t *place,
                              uint32_t *rim) {
    size_t e, count = 0;
    int k;
    for (e = p->edge_first[patch]; e < p->edge_first[patch + 1]; ++e)
        for (k = 0; k < 2 && sil_i_is_found_by_patch(mesh, e, patch); ++k) {
            const uint32_t face = mesh->edge_face[k][e];
            if (face / SIL_I_PATCH == patch)
                place[face] = patch << 8 | face % SIL_I_PATCH;
            else if (place[face] >> 8 != patch) {
                place[face] = patch << 8 | (uint32_t)(SIL_I_PATCH + count);
                rim[count++] = face;
            }
            SIL_ASSERT(SIL_I_PATCH + count <= SIL_I_PLACES);
        }
    return count;
}

/* All of a patch's block but for the planes. */
static void sil_i_fill_block(const sil_mesh *mesh, const sil_i_patches *p, size_t patch, const uint32_t *place,
                             uint32_t planes) {
    unsigned char *block = p->block + SIL_I_LINE * (size_t)p->line[patch];
    const uint32_t first = p->edge_first[patch];
    unsigned char *sides;
    uint32_t *records;
    sil_i_head head;
    uint32_t i;
    memset(&head, 0, sizeof head);
    head.edge_first = first;
    head.edge_count = p->edge_first[patch + 1] - first;
    head.places = SIL_I_PATCH + p->rim_first[patch + 1] - p->rim_first[patch];
    head.planes = planes;
    memcpy(block, &head, sizeof head);
    sides = block + SIL_I_LINE * (1 + (size_t)planes);
    records = (uint32_t *)(void *)(sides + SIL_I_LINE * (size_t)((head.edge_count + 31) / 32));
    for (i = 0; i < head.edge_count; ++i) {
        const uint32_t e = first + i, f0 = mesh->edge_face[0][e], f1 = mesh->edge_face[1][e];
        if (!sil_i_is_found_by_patch(mesh, e, patch))
            continue;
        sides[i / 32 * 64 + i % 32] = (unsigned char)(place[f0] & 255);
        sides[i / 32 * 64 + i % 32 + 32] = (unsigned char)(place[f1] & 255);
        sil_i_set_record(mesh, e, records + 4 * (size_t)i);
    }
}

/* Where the edges of each patch begin. */
static void sil_i_share_edges(const sil_mesh *mesh, sil_i_patches *p) {
    size_t side;
    uint32_t seen = 0;
    for (side = 0; side < 3 * mesh->face_count; ++side) {
        if (side % (3 * SIL_I_PATCH) == 0)
            p->edge_first[side / (3 * SIL_I_PATCH)] = seen;
        seen = mesh->face_edge[side] >= seen ? mesh->face_edge[side] + 1 : seen;
    }
    p->edge_first[p->count] = (uint32_t)mesh->edge_count;
}

/* Lists or, without lists, counts edges that are candidates for other reasons than the signs in their patch. */
static void sil_i_list_edges(const sil_mesh *mesh, sil_i_patches *p) {
    size_t patch, e;
    p->special_count = p->lone_count = 0;
    for (patch = 0; patch < p->count; ++patch)
        for (e = p->edge_first[patch]; e < p->edge_first[patch + 1]; ++e) {
            const int lone = sil_i_is_lone(mesh, e, patch);
            if (lone && p->lone)
                p->lone[p->lone_count] = (uint32_t)e;
            if ((lone || mesh->edge_kinds[e] & ~SIL_I_FOLDS) && p->special)
                p->special[p->special_count] = (uint32_t)e;
            p->lone_count += (size_t)lone;
            p->special_count += lone || mesh->edge_kinds[e] & ~SIL_I_FOLDS;
        }
}

/* Rims and blocks: counted first, then filled. */
static void sil_i_fill_patches(const sil_mesh *mesh, sil_i_patches *p, int planes, sil_i_heap *heap, uint32_t *place) {
    uint32_t rim[SIL_I_PLACES], patch, lines;
    size_t i, count;
    int pass;
    p->rim_first[0] = p->line[0] = 0;
    for (pass = 0; pass < 2; ++pass) {
        memset(place, 0xff, mesh->face_count * sizeof(uint32_t));
        for (patch = 0; patch < p->count; ++patch) {
            const uint32_t edges = p->edge_first[patch + 1] - p->edge_first[patch];
            count = sil_i_patch_rim(mesh, p, patch, place, rim);
            p->rim_first[patch + 1] =
                p->rim_first[patch] + (uint32_t)((count + SIL_I_LANES - 1) / SIL_I_LANES * SIL_I_LANES);
            lines = planes ? (SIL_I_PATCH + p->rim_first[patch + 1] - p->rim_first[patch]) / SIL_I_LANES : 0;
            p->line[patch + 1] = p->line[patch] + 1 + lines + (edges + 31) / 32 + (edges + 3) / 4;
            for (i = p->rim_first[patch]; pass && i < p->rim_first[patch + 1]; ++i) {
                const size_t at = i - p->rim_first[patch];
                p->rim[i] = rim[at < count ? at : count - 1]; /* the last one again, up to a multiple of 8 */
            }
            if (pass)
                sil_i_fill_block(mesh, p, patch, place, lines);
        }
        if (pass)
            return;
        p->rim = sil_i_take_words(heap, p->rim_first[p->count]);
        lines = p->line[p->count] + 5; /* vectors are read past ends */
        p->memory = (unsigned char *)sil_i_take(heap, lines, SIL_I_LINE);
        if (heap->failed)
            return;
        memset(p->memory, 0, SIL_I_LINE * (size_t)lines);
        p->block = p->memory + (SIL_I_LINE - (size_t)(uintptr_t)p->memory % SIL_I_LINE) % SIL_I_LINE;
    }
}

static int sil_i_wants_hierarchy(const sil_mesh *mesh, unsigned flags) {
    return mesh->face_count && !(flags & SIL_MESH_NO_HIERARCHY) &&
           (flags & SIL_MESH_HIERARCHY || mesh->edge_count >= SIL_I_WORTHWHILE);
}

/* After everything else of the mesh. Patches' numbers have 24 bits, as meshes have less than 2^28 faces. */
static void sil_i_build_patches(sil_mesh *mesh, unsigned flags, sil_i_heap *heap, sil_i_heap *scratch) {
    sil_i_patches *p = mesh->patches = (sil_i_patches *)sil_i_take(heap, 1, sizeof *p);
    uint32_t *place;
    if (!p)
        return;
    memset(p, 0, sizeof *p);
    p->count = (mesh->face_count + SIL_I_PATCH - 1) / SIL_I_PATCH;
    p->edge_first = sil_i_take_words(heap, p->count + 1);
    p->rim_first = sil_i_take_words(heap, p->count + 1);
    p->line = sil_i_take_words(heap, p->count + 1);
    place = sil_i_take_words(scratch, mesh->face_count);
    if (!heap->failed) {
        sil_i_share_edges(mesh, p);
        sil_i_list_edges(mesh, p);
        p->special = sil_i_take_words(heap, p->special_count);
        p->lone = sil_i_take_words(heap, p->lone_count);
    }
    if (!heap->failed && !scratch->failed)
        sil_i_list_edges(mesh, p);
    if (!heap->failed && !scratch->failed)
        sil_i_fill_patches(mesh, p, sil_i_wants_hierarchy(mesh, flags), heap, place);
    sil_i_give(&scratch->allocator, place);
}

/* The face at a place in a patch; places that no face has stand for another of its faces. */
static uint32_t sil_i_face_at(const sil_mesh *mesh, size_t patch, size_t place) {
    const sil_i_patches *p = mesh->patches;
    const size_t own = patch * SIL_I_PATCH + place;
    if (place >= SIL_I_PATCH)
        return p->rim[p->rim_first[patch] + place - SIL_I_PATCH];
    return (uint32_t)(own < mesh->face_count ? own : mesh->face_count - 1);
}

static size_t sil_i_patch_places(const sil_i_patches *p, size_t patch) {
    return SIL_I_PATCH + p->rim_first[patch + 1] - p->rim_first[patch];
}

/* Are all faces of a patch and its rim exactly in one plane, on the same side of it? Then it has no silhouette in any
   view and is never looked at: flat sides of CAD models, which may be exactly edge-on. */
static int sil_i_patch_is_flat(const sil_mesh *mesh, size_t patch) {
    const size_t places = sil_i_patch_places(mesh->patches, patch);
    const uint32_t first = sil_i_sign_face(mesh, sil_i_face_at(mesh, patch, 0));
    size_t place;
    if (first == SIL_NONE)
        return 0;
    for (place = 1; place < places; ++place)
        if (!sil_i_same_plane(mesh, first, sil_i_sign_face(mesh, sil_i_face_at(mesh, patch, place))))
            return 0;
    return 1;
}

/* A float plane about an origin: n, d - n . origin. */
static void sil_i_plane_about(const sil_i_shape *shape, uint32_t face, const double origin[3], double plane[4]) {
    int k;
    plane[3] = (double)shape->plane[3][face];
    for (k = 0; k < 3; ++k) {
        plane[k] = (double)shape->plane[k][face];
        plane[3] -= plane[k] * origin[k];
    }
}

/* The box of patches first .. end - 1 but for those that are flat (in the bits of `never`). Middles are rounded, and half
   sizes taken from there and rounded up. Without a plane in it a box is smaller than nothing: surely of one sign. */
static void sil_i_cone_set(const sil_mesh *mesh, const unsigned char *never, size_t first, size_t end,
                           sil_i_cones *cones, size_t lane) {
    double low[4] = {1e9, 1e9, 1e9, 1e9}, high[4] = {-1e9, -1e9, -1e9, -1e9}, origin[3], plane[4];
    size_t patch, place;
    int k, any = 0;
    for (patch = first; patch < end; ++patch)
        for (place = 0; place < SIL_I_PATCH && !never[patch]; ++place) {
            const float *p = mesh->rest.position + 3 * (size_t)mesh->corner[3 * sil_i_face_at(mesh, patch, place)];
            any = 1;
            for (k = 0; k < 3; ++k) {
                const double x = ((double)p[k] - mesh->rest.center[k]) / mesh->rest.scale;
                low[k] = x < low[k] ? x : low[k];
                high[k] = x > high[k] ? x : high[k];
            }
        }
    for (k = 0; k < 3; ++k) {
        cones->origin[k][lane] = any ? (float)(0.5 * (low[k] + high[k])) : 0;
        origin[k] = (double)cones->origin[k][lane];
        low[k] = 1e9;
        high[k] = -1e9;
    }
    for (patch = first; patch < end; ++patch) {
        const size_t places = never[patch] ? 0 : sil_i_patch_places(mesh->patches, patch);
        for (place = 0; place < places; ++place) {
            sil_i_plane_about(&mesh->rest, sil_i_face_at(mesh, patch, place), origin, plane);
            for (k = 0; k < 4; ++k) {
                low[k] = plane[k] < low[k] ? plane[k] : low[k];
                high[k] = plane[k] > high[k] ? plane[k] : high[k];
            }
        }
    }
    for (k = 0; k < 4; ++k) {
        const float mid = any ? (float)(0.5 * (low[k] + high[k])) : 0;
        const double half = sil_i_larger(high[k] - (double)mid, (double)mid - low[k]);
        cones->mid[k][lane] = mid;
        cones->half[k][lane] = any ? (float)(half * 1.000001 + 1e-15) : -1e30f;
    }
}

#define SIL_I_FINE 32767.0 /* steps from the middle of a box to its side */

/* A patch's planes as 16-bit steps from the middle of its box; eight faces' nx, ny in turn, then their nz, d. A face
   without a plane has four zeros: its t is 0, always in doubt. */
static void sil_i_quantise(const sil_mesh *mesh, const sil_i_hierarchy *h, size_t patch) {
    sil_i_head *head = (sil_i_head *)(void *)(mesh->patches->block + SIL_I_LINE * (size_t)mesh->patches->line[patch]);
    const sil_i_cones *c = &h->cones[h->first[1] + patch / SIL_I_LANES];
    const size_t lane = patch % SIL_I_LANES;
    size_t place;
    int k;
    for (place = 0; place < head->places; ++place) {
        const uint32_t face = sil_i_face_at(mesh, patch, place);
        int16_t *out = (int16_t *)(void *)((unsigned char *)head + SIL_I_LINE) + 32 * (place / 8) + 2 * (place % 8);
        double origin[3], plane[4];
        for (k = 0; k < 3; ++k)
            origin[k] = (double)c->origin[k][lane];
        sil_i_plane_about(&mesh->rest, face, origin, plane);
        for (k = 0; k < 4; ++k) {
            const double steps = (plane[k] - (double)c->mid[k][lane]) / (double)c->half[k][lane] * SIL_I_FINE;
            out[k / 2 * 16 + k % 2] = (int16_t)floor(steps + 0.5);
        }
    }
}

static void sil_i_fill_hierarchy(const sil_mesh *mesh, sil_i_hierarchy *h, unsigned char *never) {
    const size_t patches = mesh->patches->count;
    size_t count = patches, spans = 1, i;
    for (i = 0; i < patches; ++i)
        never[i] = (unsigned char)sil_i_patch_is_flat(mesh, i);
    h->first[1] = 0;
    for (;;) { /* `count` boxes of `spans` patches each, and boxes of nothing up to a multiple of eight */
        h->count[++h->levels] = count;
        for (i = 0; i < (count + SIL_I_LANES - 1) / SIL_I_LANES * SIL_I_LANES; ++i) {
            const size_t first = i * spans < patches ? i * spans : patches;
            const size_t end = patches - first < spans ? patches : first + spans;
            sil_i_cone_set(mesh, never, first, end, &h->cones[h->first[h->levels] + i / SIL_I_LANES], i % SIL_I_LANES);
        }
        count = (count + SIL_I_LANES - 1) / SIL_I_LANES;
        spans *= SIL_I_LANES;
        if (count == 1)
            break;
        h->first[h->levels + 1] = h->first[h->levels] + count;
    }
    for (i = 0; i < patches; ++i)
        if (!never[i])
            sil_i_quantise(mesh, h, i);
}

static void sil_i_build_hierarchy(sil_mesh *mesh, unsigned flags, sil_i_heap *heap, sil_i_heap *scratch) {
    const size_t before = heap->bytes;
    unsigned char *never;
    sil_i_hierarchy *h;
    size_t i, planes = 0;
    if (!sil_i_wants_hierarchy(mesh, flags))
        return;
    mesh->hierarchy = h = (sil_i_hierarchy *)sil_i_take(heap, 1, sizeof *h);
    if (!h)
        return;
    memset(h, 0, sizeof *h);
    h->cones = (sil_i_cones *)sil_i_take(heap, mesh->patches->count / 7 + SIL_I_LEVELS, sizeof(sil_i_cones));
    never = sil_i_take_bytes(scratch, mesh->patches->count);
    if (!heap->failed && !scratch->failed)
        sil_i_fill_hierarchy(mesh, h, never);
    for (i = 0; i < mesh->patches->count; ++i)
        planes += sil_i_patch_head(mesh->patches, i)->planes;
    mesh->info.hierarchy_bytes = heap->bytes - before + SIL_I_LINE * planes;
    sil_i_give(&scratch->allocator, never);
}

static void sil_i_build(sil_mesh *mesh, const sil_mesh_desc *desc, size_t triangles, sil_i_heap *heap) {
    sil_i_heap scratch = *heap;
    double crease = (double)desc->crease_degrees;
    size_t e, before, face_bytes;
    if (crease <= 0)
        crease = crease < 0 ? 1e-9 : 30; /* 1e-9: rounding of what is flat */
    sil_i_build_vertices(mesh, desc, heap, &scratch);
    before = heap->bytes;
    if (!heap->failed && !scratch.failed)
        sil_i_build_faces(mesh, desc, triangles, heap, &scratch);
    face_bytes = heap->bytes - before;
    if (!heap->failed && !scratch.failed)
        sil_i_order_faces(mesh, &scratch);
    if (!heap->failed && !scratch.failed && desc->t_junction_distance > 0)
        sil_i_close_cracks(mesh, (double)desc->t_junction_distance, face_bytes, heap, &scratch);
    if (!heap->failed && !scratch.failed)
        sil_i_build_planes(mesh, heap);
    if (!heap->failed && !scratch.failed)
        sil_i_build_edges(mesh, heap, &scratch);
    if (!heap->failed && !scratch.failed && desc->flags & SIL_MESH_ORIENT)
        sil_i_orient_all(mesh, &scratch);
    if (!heap->failed && !scratch.failed && !(desc->flags & SIL_MESH_ORIENT))
        sil_i_orient(mesh, &scratch);
    if (!heap->failed && !scratch.failed)
        sil_i_build_roots(mesh, heap, &scratch);
    if (!heap->failed && !scratch.failed) {
        for (e = 0; e < mesh->edge_count; ++e)
            mesh->edge_kinds[e] =
                (unsigned char)(sil_i_fixed_kinds(mesh, (uint32_t)e, crease) | sil_i_fold(mesh, (uint32_t)e) |
                                sil_i_part_border(mesh, (uint32_t)e, desc->face_parts));
        sil_i_build_components(mesh, &scratch);
        sil_i_build_patches(mesh, desc->flags, heap, &scratch);
        if (!heap->failed && !scratch.failed)
            sil_i_build_hierarchy(mesh, desc->flags, heap, &scratch);
    }
    heap->failed |= scratch.failed;
}

static sil_result sil_i_check_desc(const sil_mesh_desc *desc, size_t *triangles) {
    size_t indices;
    if (!desc || (!desc->positions && desc->vertex_count) || (!desc->indices && desc->index_count) ||
        (desc->position_stride && desc->position_stride < 3 * sizeof(float)) ||
        (!desc->allocator.alloc_fn) != (!desc->allocator.free_fn) || !sil_i_finite(desc->weld_distance) ||
        !sil_i_finite(desc->crease_degrees) || !sil_i_finite(desc->t_junction_distance) ||
        desc->t_junction_distance < 0)
        return SIL_INVALID_ARGUMENT;
    indices = desc->indices ? desc->index_count : desc->vertex_count;
    if (indices % 3)
        return SIL_INCOMPLETE_TRIANGLE;
    *triangles = indices / 3;
    if (desc->vertex_count >= SIL_NONE || *triangles >= 0x10000000u)
        return SIL_TOO_LARGE;
    return SIL_OK;
}

static void sil_i_log(const sil_mesh_desc *desc, int level, sil_result code) {
    if (desc && desc->log_fn)
        desc->log_fn(level, (int)code, sil_result_string(code), desc->log_user);
}

static void sil_i_finish_info(sil_mesh *mesh, const sil_i_heap *heap) {
    mesh->info.vertex_count = mesh->vertex_count;
    mesh->info.unique_vertex_count = mesh->unique_count;
    mesh->info.face_count = mesh->face_count - mesh->piece_count;
    mesh->info.edge_count = mesh->edge_count;
    mesh->info.bytes = heap->bytes;
}

SIL_DEF sil_mesh *sil_mesh_create(const sil_mesh_desc *desc, sil_result *result) {
    size_t triangles = 0;
    sil_result code = sil_i_check_desc(desc, &triangles);
    sil_mesh *mesh = NULL;
    if (code == SIL_OK) {
        sil_i_heap heap;
        memset(&heap, 0, sizeof heap);
        heap.allocator = desc->allocator;
        if (!heap.allocator.alloc_fn) {
            heap.allocator.alloc_fn = sil_i_default_alloc;
            heap.allocator.free_fn = sil_i_default_free;
        }
        mesh = (sil_mesh *)sil_i_take(&heap, 1, sizeof *mesh);
        if (mesh) {
            memset(mesh, 0, sizeof *mesh);
            mesh->allocator = heap.allocator;
            mesh->vertex_count = desc->vertex_count;
            mesh->wide = sil_i_has_wide();
            sil_i_build(mesh, desc, triangles, &heap);
            sil_i_finish_info(mesh, &heap);
        }
        if (heap.failed) {
            code = SIL_OUT_OF_MEMORY;
            sil_mesh_destroy(mesh);
            mesh = NULL;
        }
    }
    if (code != SIL_OK)
        sil_i_log(desc, SIL_LOG_ERROR, code);
    if (mesh && mesh->info.dropped_face_count)
        sil_i_log(desc, SIL_LOG_WARNING, SIL_DROPPED_FACES);
    if (mesh && mesh->info.flipped_edge_count)
        sil_i_log(desc, SIL_LOG_WARNING, SIL_FLIPPED_EDGES);
    if (result)
        *result = code;
    return mesh;
}

SIL_DEF void sil_mesh_destroy(sil_mesh *mesh) {
    sil_allocator allocator;
    if (!mesh)
        return;
    allocator = mesh->allocator;
    sil_i_give(&allocator, mesh->welded);
    sil_i_give(&allocator, mesh->origin);
    sil_i_give(&allocator, mesh->referenced);
    sil_i_give(&allocator, mesh->corner);
    sil_i_give(&allocator, mesh->source);
    sil_i_give(&allocator, mesh->face_flags);
    sil_i_give(&allocator, mesh->face_edge);
    sil_i_give(&allocator, mesh->edge_vertex);
    sil_i_give(&allocator, mesh->edge_face[0]);
    sil_i_give(&allocator, mesh->edge_face[1]);
    sil_i_give(&allocator, mesh->edge_kinds);
    sil_i_give(&allocator, mesh->flat_face);
    sil_i_give(&allocator, mesh->flat_root);
    sil_i_give(&allocator, mesh->many_edge);
    sil_i_give(&allocator, mesh->many_first);
    sil_i_give(&allocator, mesh->many_face);
    sil_i_shape_give(&allocator, &mesh->rest);
    if (mesh->patches)
        sil_i_patches_give(&allocator, mesh->patches);
    sil_i_give(&allocator, mesh->patches);
    if (mesh->hierarchy)
        sil_i_hierarchy_give(&allocator, mesh->hierarchy);
    sil_i_give(&allocator, mesh->hierarchy);
    sil_i_give(&allocator, mesh);
}

SIL_DEF sil_mesh_info sil_mesh_get_info(const sil_mesh *mesh) {
    sil_mesh_info info;
    memset(&info, 0, sizeof info);
    return mesh ? mesh->info : info;
}

/* ---- poses ---- */

SIL_DEF sil_pose *sil_pose_create(const sil_mesh *mesh, sil_result *result) {
    sil_i_heap heap;
    sil_pose *pose = NULL;
    sil_result code = mesh ? SIL_OK : SIL_INVALID_ARGUMENT;
    if (mesh) {
        memset(&heap, 0, sizeof heap);
        heap.allocator = mesh->allocator;
        pose = (sil_pose *)sil_i_take(&heap, 1, sizeof *pose);
        if (pose) {
            memset(pose, 0, sizeof *pose);
            pose->mesh = mesh;
            pose->front = sil_i_take_bytes(&heap, sil_i_padded(mesh->face_count));
        }
        if (heap.failed) {
            if (pose)
                sil_i_give(&heap.allocator, pose->front);
            sil_i_give(&heap.allocator, pose);
            pose = NULL;
            code = SIL_OUT_OF_MEMORY;
        }
    }
    if (result)
        *result = code;
    return pose;
}

SIL_DEF void sil_pose_destroy(sil_pose *pose) {
    sil_allocator allocator;
    if (!pose)
        return;
    allocator = pose->mesh->allocator;
    sil_i_shape_give(&allocator, &pose->shape);
    sil_i_give(&allocator, pose->front);
    sil_i_give(&allocator, pose->scratch);
    sil_i_give(&allocator, pose->tracked);
    sil_i_give(&allocator, pose->zone_last);
    sil_i_give(&allocator, pose);
}

SIL_DEF sil_result sil_pose_set(sil_pose *pose, const float *positions, size_t stride) {
    const sil_mesh *mesh;
    size_t i;
    if (!pose || (stride && stride < 3 * sizeof(float)))
        return SIL_INVALID_ARGUMENT;
    mesh = pose->mesh;
    pose->is_set = pose->is_set && positions;
    if (!positions)
        return SIL_OK;
    if (!pose->shape.position) {
        sil_i_heap heap;
        memset(&heap, 0, sizeof heap);
        heap.allocator = mesh->allocator;
        if (!sil_i_shape_take(&heap, &pose->shape, mesh->unique_count, mesh->face_count)) {
            sil_i_shape_give(&heap.allocator, &pose->shape);
            return SIL_OUT_OF_MEMORY;
        }
    }
    stride = stride ? stride : 3 * sizeof(float);
    for (i = 0; i < mesh->unique_count; ++i) {
        const char *given = (const char *)(const void *)positions + mesh->origin[i] * stride;
        sil_i_shape_set_vertex(&pose->shape, i, (const float *)(const void *)given);
    }
    sil_i_shape_box(mesh, &pose->shape);
    for (i = 0; i < mesh->face_count; ++i)
        (void)sil_i_face_plane(mesh, &pose->shape, i);
    sil_i_flat_planes(mesh, &pose->shape);
    pose->is_set = 1;
    return SIL_OK;
}

static const sil_i_shape *sil_i_shape_of(const sil_mesh *mesh, const sil_pose *pose) {
    return pose && pose->is_set ? &pose->shape : &mesh->rest;
}

/* ---- views ---- */

SIL_DEF sil_view sil_view_perspective(const double eye[3]) {
    sil_view view;
    memcpy(view.eye, eye, 3 * sizeof(double));
    view.eye[3] = 1;
    return view;
}

SIL_DEF sil_view sil_view_orthographic(const double toward_eye[3]) {
    sil_view view;
    memcpy(view.eye, toward_eye, 3 * sizeof(double));
    view.eye[3] = 0;
    return view;
}

/* out = a * b, column-major. */
static void sil_i_multiply(const double a[16], const double b[16], double out[16]) {
    int row, column, k;
    for (column = 0; column < 4; ++column)
        for (row = 0; row < 4; ++row) {
            double sum = 0;
            for (k = 0; k < 4; ++k)
                sum += a[4 * k + row] * b[4 * column + k];
            out[4 * column + row] = sum;
        }
}

static void sil_i_widen(const float *from, double *to, int count) {
    int i;
    for (i = 0; i < count; ++i)
        to[i] = (double)from[i];
}

/* The determinant of rows r0, r1, r2 of a 4x4 matrix without column `skip`. */
static double sil_i_minor(const double m[16], int r0, int r1, int r2, int skip) {
    const int c0 = 4 * (skip == 0), c1 = 4 * (skip <= 1 ? 2 : 1), c2 = 4 * (skip <= 2 ? 3 : 2);
    return m[c0 + r0] * (m[c1 + r1] * m[c2 + r2] - m[c2 + r1] * m[c1 + r2]) -
           m[c1 + r0] * (m[c0 + r1] * m[c2 + r2] - m[c2 + r1] * m[c0 + r2]) +
           m[c2 + r0] * (m[c0 + r1] * m[c1 + r2] - m[c1 + r1] * m[c0 + r2]);
}

/* Is the volume that the first three columns span nothing but rounding, next to the product of their lengths? */
static int sil_i_is_singular(const double m[16]) {
    double product = 1;
    int i;
    for (i = 0; i < 12; i += 4)
        product *= sqrt(m[i] * m[i] + m[i + 1] * m[i + 1] + m[i + 2] * m[i + 2]);
    return !(sil_i_abs(sil_i_minor(m, 0, 1, 2, 3)) > 1e-14 * product);
}

/* The eye of a scene, in the mesh's coordinates: the centre of projection is the point that has no place on the screen,
   clip x, y and w are all 0 there. Returns 1 where its sign had to be turned, that is where left and right on the
   screen are exchanged. */
static int sil_i_eye_point(const double mv[16], const double p[16], double eye[4]) {
    double clip[16], toward;
    int i, negate;
    sil_i_multiply(p, mv, clip);
    for (i = 0; i < 4; ++i)
        eye[i] = sil_i_minor(clip, 0, 1, 3, i) * (i % 2 ? -1 : 1);
    toward = eye[0] * mv[2] + eye[1] * mv[6] + eye[2] * mv[10] + eye[3] * mv[14];
    negate = eye[3] < 0 || (!(eye[3] > 0) && toward < 0);
    for (i = 0; i < 4; ++i)
        eye[i] = negate ? -eye[i] : eye[i];
    return negate;
}

SIL_DEF sil_result sil_view_from_matrices(const float model_view[16], const float projection[16], sil_view *view) {
    double mv[16], p[16], eye[4], largest = 0;
    int i;
    if (!view)
        return SIL_INVALID_ARGUMENT;
    memset(view, 0, sizeof *view);
    if (!model_view || !projection || !sil_i_all_finite(model_view, 16) || !sil_i_all_finite(projection, 16))
        return SIL_INVALID_ARGUMENT;
    sil_i_widen(model_view, mv, 16);
    sil_i_widen(projection, p, 16);
    (void)sil_i_eye_point(mv, p, eye);
    for (i = 0; i < 4; ++i)
        largest = sil_i_larger(largest, sil_i_abs(eye[i]));
    if (!(largest > 0) || sil_i_is_singular(mv))
        return SIL_INVALID_ARGUMENT;
    for (i = 0; i < 4; ++i)
        view->eye[i] = eye[i] / largest;
    return SIL_OK;
}

/* ---- containment ---- */

SIL_DEF sil_result sil_mesh_components(const sil_mesh *mesh, uint32_t *components, size_t triangle_count) {
    sil_i_heap heap;
    uint32_t *label;
    size_t i;
    if (!mesh || (!components && triangle_count))
        return SIL_INVALID_ARGUMENT;
    memset(&heap, 0, sizeof heap);
    heap.allocator = mesh->allocator;
    label = sil_i_take_words(&heap, mesh->face_count);
    if (!label)
        return SIL_OUT_OF_MEMORY;
    (void)sil_i_label_components(mesh, label);
    for (i = 0; i < triangle_count; ++i)
        components[i] = SIL_NONE;
    for (i = 0; i < mesh->face_count; ++i)
        if (mesh->source[i] < triangle_count)
            components[mesh->source[i]] = label[i];
    sil_i_give(&heap.allocator, label);
    return SIL_OK;
}

/* What is to be known of one mesh, however many parts share it. Samples are 4 * face + i: corner i, or 3, the middle. */
typedef struct sil_i_inner {
    const sil_mesh *mesh;
    sil_i_bvh tree;
    uint32_t count, *label, *sample, *sample_first;
    unsigned char *open;
    sil_i_bounds *box;
} sil_i_inner;

/* One component of one part. */
typedef struct sil_i_solid {
    uint32_t part, component;
} sil_i_solid;

typedef struct sil_i_site {
    sil_i_inner *inner;
    double model[12], inverse[12]; /* 3 x 4, column-major */
    int invertible;
    uint32_t first, end; /* components */
} sil_i_site;

typedef struct sil_i_pair {
    uint32_t inside, around;
} sil_i_pair;

typedef struct sil_i_world {
    sil_i_heap heap;
    const sil_part *parts;
    size_t part_count, inner_count, solid_count, pair_count, pair_room;
    sil_i_inner *inner;
    sil_i_site *place;
    sil_i_solid *solid;
    sil_i_bvh tree; /* over the boxes of solids */
    sil_i_pair *pair;
    uint32_t *hits, *stamp, *touched; /* of each part: samples of the part being tried that are within it */
} sil_i_world;

static void sil_i_inner_mark_open(sil_i_inner *in) {
    const sil_mesh *mesh = in->mesh;
    size_t e;
    for (e = 0; e < mesh->edge_count; ++e)
        if (mesh->edge_kinds[e] & SIL_BOUNDARY)
            in->open[in->label[mesh->edge_face[0][e]]] = 1;
    for (e = 0; e < mesh->many_count; ++e)
        if ((mesh->many_first[e + 1] - mesh->many_first[e]) % 2)
            in->open[in->label[mesh->edge_face[0][mesh->many_edge[e]]]] = 1;
}

/* Boxes of the components, and their samples, spread evenly over the faces as these are numbered: along a curve. */
static void sil_i_inner_fill(sil_i_inner *in, size_t samples, sil_i_heap *heap) {
    const sil_mesh *mesh = in->mesh;
    uint32_t *faces = sil_i_take_words(heap, in->count), *seen = sil_i_take_words(heap, in->count), c;
    uint64_t some;
    size_t i, f, total = 0;
    for (c = 0; c < in->count && !heap->failed; ++c) {
        faces[c] = seen[c] = 0;
        sil_i_bounds_none(&in->box[c]);
    }
    for (f = 0; f < mesh->face_count && !heap->failed; ++f) {
        ++faces[in->label[f]];
        for (i = 0; i < 3; ++i)
            sil_i_bounds_point(&in->box[in->label[f]], mesh->rest.position + 3 * (size_t)mesh->corner[3 * f + i]);
    }
    for (c = 0; c < in->count && !heap->failed; ++c) {
        in->sample_first[c] = (uint32_t)total;
        total += samples < 4 * (size_t)faces[c] ? samples : 4 * (size_t)faces[c];
    }
    in->sample = sil_i_take_words(heap, total);
    for (i = 0; i < 4 * mesh->face_count && !heap->failed; ++i) {
        c = in->label[i / 4];
        some = samples < 4 * (size_t)faces[c] ? samples : 4 * (size_t)faces[c];
        if ((seen[c] + 1) * some / (4 * (uint64_t)faces[c]) != seen[c] * some / (4 * (uint64_t)faces[c]))
            in->sample[in->sample_first[c]++] = (uint32_t)i;
        ++seen[c];
    }
    for (c = in->count; c > 0 && !heap->failed; --c) /* they have moved to the next one's */
        in->sample_first[c] = in->sample_first[c - 1];
    if (!heap->failed)
        in->sample_first[0] = 0;
    sil_i_give(&heap->allocator, faces);
    sil_i_give(&heap->allocator, seen);
}

static void sil_i_inner_make(sil_i_inner *in, size_t samples, sil_i_heap *heap) {
    in->label = sil_i_take_words(heap, in->mesh->face_count);
    if (heap->failed)
        return;
    in->count = sil_i_label_components(in->mesh, in->label);
    in->open = sil_i_take_bytes(heap, in->count);
    in->box = (sil_i_bounds *)sil_i_take(heap, in->count, sizeof(sil_i_bounds));
    in->sample_first = sil_i_take_words(heap, (size_t)in->count + 1);
    if (!heap->failed)
        sil_i_inner_mark_open(in);
    if (!heap->failed)
        sil_i_inner_fill(in, samples, heap);
    if (!heap->failed)
        sil_i_face_tree(in->mesh, &in->tree, heap);
}

static void sil_i_map(const double m[12], const double p[3], double out[3]) {
    int k;
    for (k = 0; k < 3; ++k)
        out[k] = m[k] * p[0] + m[3 + k] * p[1] + m[6 + k] * p[2] + m[9 + k];
}

/* 0 where it is not finite. */
static int sil_i_site_read(sil_i_site *place, const float transform[16]) {
    const double zero[3] = {0, 0, 0};
    double m[16] = {0}, det, back[3];
    int i, k, all_zero = 1;
    for (i = 0; i < 16; ++i)
        all_zero &= sil_i_same(transform[i], 0);
    for (i = 0; i < 4; ++i)
        for (k = 0; k < 3; ++k) {
            m[4 * i + k] = all_zero ? i == k : (double)transform[4 * i + k];
            place->model[3 * i + k] = m[4 * i + k];
        }
    m[15] = 1;
    if (!sil_i_all_finite(transform, 16))
        return 0;
    det = sil_i_minor(m, 0, 1, 2, 3);
    place->invertible = !sil_i_is_singular(m) && sil_i_abs(det) > 0;
    for (i = 0; i < 3 && place->invertible; ++i)
        for (k = 0; k < 3; ++k) {
            const int r = (k + 1) % 3, s = (k + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            place->inverse[3 * k + i] = (m[4 * c + r] * m[4 * d + s] - m[4 * d + r] * m[4 * c + s]) / det;
        }
    for (k = 0; k < 3; ++k)
        place->inverse[9 + k] = 0;
    sil_i_map(place->model, zero, back);
    if (place->invertible) {
        sil_i_map(place->inverse, back, m);
        for (k = 0; k < 3; ++k)
            place->inverse[9 + k] = -m[k];
    }
    return 1;
}

/* Box of a component in the world: around the corners of its box. */
static void sil_i_site_box(const sil_i_site *place, uint32_t component, sil_i_bounds *out) {
    const sil_i_bounds *box = &place->inner->box[component];
    int i, k;
    sil_i_bounds_none(out);
    for (i = 0; i < 8; ++i) {
        sil_i_bounds corner;
        double p[3];
        for (k = 0; k < 3; ++k)
            p[k] = i >> k & 1 ? box->high[k] : box->low[k];
        sil_i_map(place->model, p, corner.low);
        memcpy(corner.high, corner.low, sizeof corner.high);
        sil_i_bounds_add(out, &corner);
    }
    for (k = 0; k < 3; ++k) { /* what rounding may have moved */
        const double more = 1e-12 * (sil_i_abs(out->low[k]) + sil_i_abs(out->high[k]));
        out->low[k] -= more;
        out->high[k] += more;
    }
}

static void sil_i_sample_at(const sil_i_site *place, uint32_t sample, double out[3]) {
    const sil_mesh *mesh = place->inner->mesh;
    const uint32_t *corner = mesh->corner + 3 * (size_t)(sample / 4);
    double p[3];
    int k;
    for (k = 0; k < 3; ++k) {
        const double a = (double)mesh->rest.position[3 * (size_t)corner[0] + (size_t)k];
        const double b = (double)mesh->rest.position[3 * (size_t)corner[1] + (size_t)k];
        const double c = (double)mesh->rest.position[3 * (size_t)corner[2] + (size_t)k];
        p[k] = sample % 4 == 0 ? a : sample % 4 == 1 ? b : sample % 4 == 2 ? c : (a + b + c) / 3;
    }
    sil_i_map(place->model, p, out);
}

/* Is a point of the world within a component? 2: in its surface. */
static int sil_i_site_has(const sil_i_site *place, uint32_t component, const double point[3]) {
    const sil_i_inner *in = place->inner;
    double p[3];
    float at[3];
    int axis, k, votes = 0;
    sil_i_map(place->inverse, point, p);
    for (k = 0; k < 3; ++k) {
        if (!(p[k] >= in->box[component].low[k] && p[k] <= in->box[component].high[k]))
            return 0;
        at[k] = (float)p[k];
    }
    for (axis = 0; axis < 3; ++axis) {
        sil_i_ray ray;
        uint32_t face;
        int odd = 0;
        sil_i_ray_begin(&ray, in->mesh, &in->tree, at, axis);
        ray.label = in->label;
        ray.only = component;
        while ((face = sil_i_ray_next(&ray)) != SIL_NONE)
            odd ^= 1;
        if (ray.touches)
            return 2;
        votes += odd;
    }
    return votes >= 2;
}

static void sil_i_add_pair(sil_i_world *w, uint32_t inside, uint32_t around) {
    if (w->pair_count == w->pair_room) {
        sil_i_pair *more = (sil_i_pair *)sil_i_take(&w->heap, 2 * w->pair_room + 64, sizeof *more);
        if (!more)
            return;
        if (w->pair_count)
            memcpy(more, w->pair, w->pair_count * sizeof *more);
        sil_i_give(&w->heap.allocator, w->pair);
        w->pair = more;
        w->pair_room = 2 * w->pair_room + 64;
    }
    w->pair[w->pair_count].inside = inside;
    w->pair[w->pair_count++].around = around;
}

/* Counts a point of a part for all parts that it is within, once each. */
static void sil_i_try_point(sil_i_world *w, uint32_t part, const double point[3], uint32_t stamp, uint32_t *touched) {
    sil_i_walk walk;
    uint32_t found;
    sil_i_walk_begin(&walk, &w->tree, point, point, 0);
    while ((found = sil_i_walk_next(&walk)) != SIL_NONE) {
        const sil_i_solid *s = &w->solid[found];
        int has;
        if (s->part == part || w->stamp[s->part] == stamp)
            continue;
        has = sil_i_site_has(&w->place[s->part], s->component, point);
        if (!has)
            continue;
        w->stamp[s->part] = stamp;
        if (!w->hits[2 * (size_t)s->part] && !w->hits[2 * (size_t)s->part + 1])
            w->touched[(*touched)++] = s->part;
        ++w->hits[2 * (size_t)s->part + (has == 2)];
    }
}

/* All points of one part, and what they say. */
static void sil_i_try_part(sil_i_world *w, uint32_t part, uint32_t *stamp, uint32_t *facts) {
    const sil_i_site *place = &w->place[part];
    uint32_t touched = 0, i, total = place->inner->sample_first[place->end] - place->inner->sample_first[place->first];
    for (i = place->inner->sample_first[place->first]; i < place->inner->sample_first[place->end]; ++i) {
        double point[3];
        sil_i_sample_at(place, place->inner->sample[i], point);
        sil_i_try_point(w, part, point, ++*stamp, &touched);
    }
    for (i = 0; i < touched; ++i) {
        const uint32_t around = w->touched[i], within = w->hits[2 * (size_t)around],
                       on = w->hits[2 * (size_t)around + 1];
        w->hits[2 * (size_t)around] = w->hits[2 * (size_t)around + 1] = 0;
        if (within && within + on == total)
            sil_i_add_pair(w, part, around);
        else if (within) {
            facts[part] |= SIL_PART_CROSSES;
            facts[around] |= SIL_PART_CROSSES;
        }
    }
}

/* The parent is that one of the parts around which has the most around itself, but less than the part: no circles. */
static void sil_i_choose_parents(const sil_i_world *w, uint32_t *depth, uint32_t *parents, uint32_t *facts) {
    size_t i;
    memset(depth, 0, w->part_count * sizeof *depth);
    for (i = 0; i < w->pair_count; ++i) {
        ++depth[w->pair[i].inside];
        facts[w->pair[i].around] |= SIL_PART_ENCLOSES;
    }
    for (i = 0; i < w->pair_count; ++i) {
        const uint32_t inside = w->pair[i].inside, around = w->pair[i].around, best = parents[inside];
        if (depth[around] < depth[inside] &&
            (best == SIL_NONE || depth[around] > depth[best] || (depth[around] == depth[best] && around < best)))
            parents[inside] = around;
    }
}

/* One sil_i_inner for each mesh: those of parts that share one are found by a table. */
static sil_result sil_i_world_read(sil_i_world *w, size_t samples) {
    const size_t table_size = sil_i_table_size(w->part_count);
    uint32_t *table = sil_i_take_words(&w->heap, table_size), i;
    sil_result result = SIL_OK;
    w->inner = (sil_i_inner *)sil_i_take(&w->heap, w->part_count, sizeof *w->inner);
    w->place = (sil_i_site *)sil_i_take(&w->heap, w->part_count, sizeof *w->place);
    if (!w->heap.failed) {
        memset(table, 0xff, table_size * sizeof *table);
        memset(w->inner, 0, w->part_count * sizeof *w->inner);
        memset(w->place, 0, w->part_count * sizeof *w->place);
    }
    for (i = 0; i < w->part_count && !w->heap.failed && result == SIL_OK; ++i) {
        const sil_mesh *mesh = w->parts[i].mesh;
        const uint64_t name = (uint64_t)(size_t)mesh;
        size_t at = sil_i_hash((uint32_t)(name & 0xffffffffu), (uint32_t)(name >> 32), 0) & (table_size - 1);
        while (table[at] != SIL_NONE && w->inner[table[at]].mesh != mesh)
            at = (at + 1) & (table_size - 1);
        if (table[at] == SIL_NONE) {
            table[at] = (uint32_t)w->inner_count;
            w->inner[w->inner_count].mesh = mesh;
            sil_i_inner_make(&w->inner[w->inner_count++], samples, &w->heap);
        }
        w->place[i].inner = &w->inner[table[at]];
        w->place[i].end = w->place[i].inner->count;
        if (w->parts[i].component) {
            w->place[i].first = w->parts[i].component - 1;
            w->place[i].end = w->parts[i].component;
        }
        if (!w->heap.failed &&
            (w->place[i].end > w->place[i].inner->count || !sil_i_site_read(&w->place[i], w->parts[i].transform)))
            result = SIL_INVALID_ARGUMENT;
    }
    sil_i_give(&w->heap.allocator, table);
    return w->heap.failed ? SIL_OUT_OF_MEMORY : result;
}

/* The closed components of all parts that are not flattened, and a tree over their boxes. */
static void sil_i_world_solids(sil_i_world *w, uint32_t *facts) {
    sil_i_bounds *boxes;
    uint32_t i, c;
    size_t count = 0;
    for (i = 0; i < w->part_count; ++i)
        count += w->place[i].end - w->place[i].first;
    w->solid = (sil_i_solid *)sil_i_take(&w->heap, count, sizeof *w->solid);
    boxes = (sil_i_bounds *)sil_i_take(&w->heap, count, sizeof *boxes);
    for (i = 0; i < w->part_count && !w->heap.failed; ++i) {
        const sil_i_site *place = &w->place[i];
        facts[i] = place->end > place->first && place->invertible ? SIL_PART_CLOSED : 0;
        for (c = place->first; c < place->end; ++c)
            if (place->inner->open[c] || !place->invertible)
                facts[i] &= ~(uint32_t)SIL_PART_CLOSED;
            else {
                sil_i_site_box(place, c, &boxes[w->solid_count]);
                w->solid[w->solid_count].part = i;
                w->solid[w->solid_count++].component = c;
            }
    }
    if (!w->heap.failed)
        sil_i_bvh_make(&w->tree, boxes, w->solid_count, &w->heap);
    sil_i_give(&w->heap.allocator, boxes);
}

static void sil_i_world_try(sil_i_world *w, uint32_t *parents, uint32_t *facts) {
    const size_t count = w->part_count;
    uint32_t part, stamp = 0;
    w->hits = sil_i_take_words(&w->heap, 2 * count);
    w->stamp = sil_i_take_words(&w->heap, count);
    w->touched = sil_i_take_words(&w->heap, count);
    if (w->heap.failed)
        return;
    memset(w->hits, 0, 2 * count * sizeof *w->hits);
    memset(w->stamp, 0, count * sizeof *w->stamp);
    for (part = 0; part < count && !w->heap.failed; ++part)
        sil_i_try_part(w, part, &stamp, facts);
    if (!w->heap.failed)
        sil_i_choose_parents(w, w->touched, parents, facts);
}

static void sil_i_world_give(sil_i_world *w) {
    const sil_allocator *a = &w->heap.allocator;
    size_t i;
    for (i = 0; i < w->inner_count; ++i) {
        sil_i_bvh_give(a, &w->inner[i].tree);
        sil_i_give(a, w->inner[i].label);
        sil_i_give(a, w->inner[i].open);
        sil_i_give(a, w->inner[i].box);
        sil_i_give(a, w->inner[i].sample);
        sil_i_give(a, w->inner[i].sample_first);
    }
    sil_i_give(a, w->inner);
    sil_i_give(a, w->place);
    sil_i_give(a, w->solid);
    sil_i_bvh_give(a, &w->tree);
    sil_i_give(a, w->pair);
    sil_i_give(a, w->hits);
    sil_i_give(a, w->stamp);
    sil_i_give(a, w->touched);
}

SIL_DEF sil_result sil_containment(const sil_part *parts, size_t part_count, size_t samples, uint32_t *parents,
                                   uint32_t *facts) {
    sil_i_world w;
    sil_result result;
    uint32_t *own_facts;
    size_t i;
    for (i = 0; i < part_count; ++i)
        if (!parts || !parents || !parts[i].mesh)
            return SIL_INVALID_ARGUMENT;
    if (part_count >= SIL_NONE)
        return SIL_TOO_LARGE;
    if (!part_count)
        return SIL_OK;
    memset(&w, 0, sizeof w);
    w.parts = parts;
    w.part_count = part_count;
    w.heap.allocator = parts[0].mesh->allocator;
    own_facts = sil_i_take_words(&w.heap, part_count);
    result = sil_i_world_read(&w, samples ? samples : 24);
    if (result == SIL_OK) {
        for (i = 0; i < part_count; ++i)
            parents[i] = SIL_NONE;
        sil_i_world_solids(&w, own_facts);
        if (!w.heap.failed)
            sil_i_world_try(&w, parents, own_facts);
        result = w.heap.failed ? SIL_OUT_OF_MEMORY : SIL_OK;
    }
    if (result == SIL_OK && facts)
        memcpy(facts, own_facts, part_count * sizeof *facts);
    sil_i_world_give(&w);
    sil_i_give(&w.heap.allocator, own_facts);
    return result;
}

/* ---- extraction ---- */

/* How the faces of one call are told apart: by signs found before, or, without a pose, one at a time. */
typedef struct sil_i_signs {
    const sil_mesh *mesh;
    const sil_i_shape *shape;
    const unsigned char *front; /* NULL: ask for each */
    sil_i_eye eye;
    int in_view; /* 0: there is no eye */
} sil_i_signs;

static int sil_i_is_front(const sil_i_signs *signs, uint32_t face) {
    return signs->front ? signs->front[face] : sil_i_front(signs->mesh, signs->shape, &signs->eye, face);
}

/* A pose may have vertices that are not finite: faces that have one are backs. */
static void sil_i_clear_bad_faces(const sil_mesh *mesh, const sil_i_shape *shape, unsigned char *front) {
    size_t i;
    if (shape->bad_count)
        for (i = 0; i < 3 * mesh->face_count; ++i)
            if (shape->bad[mesh->corner[i]])
                front[i / 3] = 0;
}

/* The first front and the first back face of an edge of many; faces that take no sign are neither. Without an eye all
   are backs. */
static void sil_i_many_faces(const sil_i_signs *signs, uint32_t edge, uint32_t found[2]) {
    const sil_mesh *mesh = signs->mesh;
    const size_t at = sil_i_find_many(mesh, edge);
    uint32_t i;
    found[0] = found[1] = SIL_NONE;
    for (i = mesh->many_first[at]; i < mesh->many_first[at + 1]; ++i) {
        const uint32_t face = mesh->many_face[i];
        if (sil_i_sign_face(mesh, face) != SIL_NONE) {
            uint32_t *slot = &found[sil_i_is_front(signs, face) ? 0 : 1];
            if (*slot == SIL_NONE)
                *slot = face;
        }
    }
}

/* All kinds of an edge in the view, and its two faces with a front one first. */
static unsigned sil_i_classify(const sil_i_signs *signs, uint32_t edge, uint32_t face[2]) {
    const sil_mesh *mesh = signs->mesh;
    unsigned kinds = mesh->edge_kinds[edge];
    face[0] = mesh->edge_face[0][edge];
    face[1] = mesh->edge_face[1][edge];
    if (kinds & SIL_I_MANY) {
        uint32_t found[2];
        sil_i_many_faces(signs, edge, found);
        kinds &= SIL_NONMANIFOLD | SIL_BOUNDARY | SIL_PART_BORDER;
        if (found[0] != SIL_NONE && found[1] != SIL_NONE) {
            kinds |= SIL_SILHOUETTE;
            memcpy(face, found, sizeof found);
        } else if (kinds & SIL_BOUNDARY)
            face[0] = face[1] = found[found[0] == SIL_NONE];
    } else if (signs->in_view) {
        const int front0 = sil_i_is_front(signs, face[0]), front1 = sil_i_is_front(signs, face[1]);
        const unsigned flags = mesh->face_flags[face[0]] & (unsigned)mesh->face_flags[face[1]];
        if (front0 != front1)
            kinds = SIL_SILHOUETTE | (kinds & SIL_I_FOLDS);
        else if (!front0 && !(flags & SIL_I_TWO_SIDED))
            kinds &= SIL_BOUNDARY;
        if (front1 && !front0)
            sil_i_swap_words(&face[0], &face[1]);
    }
    return kinds;
}

static int sil_i_edge_is_bad(const sil_i_signs *signs, uint32_t edge) {
    const uint32_t *v = signs->mesh->edge_vertex + 2 * (size_t)edge;
    return signs->shape->bad_count && (signs->shape->bad[v[0]] || signs->shape->bad[v[1]]);
}

static void sil_i_write_edge(const sil_i_signs *signs, uint32_t edge, unsigned kinds, uint32_t face[2], sil_edge *out) {
    const sil_mesh *mesh = signs->mesh;
    const uint32_t *v = mesh->edge_vertex + 2 * (size_t)edge;
    int rises, front = signs->in_view ? sil_i_is_front(signs, face[0]) : 1;
    /* Where both are alike, the one that passes from the smaller to the larger vertex is first. */
    if (!(kinds & SIL_SILHOUETTE) && face[0] != face[1] && !sil_i_rises(mesh, face[0], edge) &&
        sil_i_rises(mesh, face[1], edge))
        sil_i_swap_words(&face[0], &face[1]);
    rises = sil_i_rises(mesh, face[0], edge);
    if (!front && mesh->face_flags[face[0]] & SIL_I_TWO_SIDED)
        rises = !rises; /* its other side is in front */
    out->a = mesh->origin[v[rises ? 0 : 1]];
    out->b = mesh->origin[v[rises ? 1 : 0]];
    out->face[0] = mesh->source[face[0]];
    out->face[1] = face[1] == face[0] ? SIL_NONE : mesh->source[face[1]];
    out->edge = edge;
    out->kinds = kinds;
}

/* What a call of sil_extract writes. Edges that are candidates whatever the signs of two faces are (of many faces, and of
   other kinds asked for) are put between the silhouettes found, by rising number. */
typedef struct sil_i_edges_out {
    sil_edge *edges;
    size_t capacity, count;
    unsigned kinds;
    const uint32_t *other, *other_end;
} sil_i_edges_out;

static void sil_i_edges_begin(const sil_mesh *mesh, unsigned kinds, sil_edge *edges, size_t capacity,
                              sil_i_edges_out *out) {
    const int special = (kinds & (SIL_I_LINES & ~(unsigned)SIL_SILHOUETTE)) != 0;
    out->edges = edges;
    out->capacity = capacity;
    out->count = 0;
    out->kinds = kinds & SIL_I_LINES;
    out->other = special ? mesh->patches->special : mesh->patches->lone;
    out->other_end = out->other + (special ? mesh->patches->special_count : mesh->patches->lone_count);
}

static void sil_i_extract_one(const sil_i_signs *signs, uint32_t edge, sil_i_edges_out *out) {
    uint32_t face[2];
    unsigned found;
    if (sil_i_edge_is_bad(signs, edge))
        return;
    found = sil_i_classify(signs, edge, face);
    if (!(found & out->kinds))
        return;
    if (out->edges && out->count < out->capacity)
        sil_i_write_edge(signs, edge, found, face, &out->edges[out->count]);
    ++out->count;
}

/* The other candidates up to an edge, without it. */
static void sil_i_extract_others(const sil_i_signs *signs, uint32_t end, sil_i_edges_out *out) {
    for (; out->other < out->other_end && *out->other < end; ++out->other)
        sil_i_extract_one(signs, *out->other, out);
    out->other += out->other < out->other_end && *out->other == end;
}

/* A silhouette of two faces from its record; `second`: the second one is in front. Without a branch. */
SIL_I_INLINE void sil_i_write_silhouette(const uint32_t *record, uint32_t edge, uint32_t second, sil_edge *out) {
    const uint32_t turned = second & ~(record[3] >> 28), number = 0x0fffffffu;
    out->a = record[turned];
    out->b = record[1 - turned];
    out->face[0] = record[2 + second] & number;
    out->face[1] = record[3 - second] & number;
    out->edge = edge;
    out->kinds = SIL_SILHOUETTE | record[2] >> 28 << 4;
}

/* The place of the lowest bit that is set; there is one. */
SIL_I_INLINE unsigned sil_i_lowest_bit(uint64_t word) {
#if defined(__GNUC__) && !defined(__TINYC__)
    return (unsigned)__builtin_ctzll(word);
#else
    unsigned bit = 0;
    while (!(word >> bit & 255))
        bit += 8;
    while (!(word >> bit & 1))
        ++bit;
    return bit;
#endif
}

#ifdef SIL_I_WIDE
/* The same by one shuffle: as it stands, a with b and the faces exchanged, or the faces only. */
SIL_I_WIDE static inline void sil_i_write_silhouette_wide(const uint32_t *record, uint32_t edge, uint32_t second,
                                                          sil_edge *out) {
    static const int32_t orders[3][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 3, 2}};
    const uint64_t kinds = SIL_SILHOUETTE | record[2] >> 28 << 4;
    const int32_t *order = orders[second + (second & record[3] >> 28)];
    const __m128 words = _mm_loadu_ps((const float *)(const void *)record);
    const __m128i edge_of =
        _mm_castps_si128(_mm_permutevar_ps(words, _mm_loadu_si128((const __m128i *)(const void *)order)));
    const uint64_t rest = edge | kinds << 32;
    _mm_storeu_si128((__m128i *)(void *)out, _mm_and_si128(edge_of, _mm_setr_epi32(-1, -1, 0x0fffffff, 0x0fffffff)));
    memcpy((unsigned char *)out + 16, &rest, sizeof rest);
}
#endif

/* Silhouettes of two faces among 64 edges from `start` on: bits in `differ`, and in `second` where the second face is in
   front. */
SIL_I_INLINE void sil_i_write_silhouettes(const sil_i_signs *signs, const uint32_t *record, uint32_t start,
                                          uint64_t differ, uint64_t second, sil_i_edges_out *out, int wide) {
    const int plain = !signs->shape->bad_count && (out->other == out->other_end || *out->other > start + 63);
    if (plain && out->edges && out->count <= out->capacity && out->capacity - out->count >= 64) {
        sil_edge *at = out->edges + out->count;
        for (; differ; differ &= differ - 1, ++at) {
            const unsigned bit = sil_i_lowest_bit(differ);
#ifdef SIL_I_WIDE
            if (wide)
                sil_i_write_silhouette_wide(record + 4 * bit, start + bit, (uint32_t)(second >> bit & 1), at);
            else
#endif
                sil_i_write_silhouette(record + 4 * bit, start + bit, (uint32_t)(second >> bit & 1), at);
        }
        (void)wide;
        out->count = (size_t)(at - out->edges);
        return;
    }
    for (; differ; differ &= differ - 1) {
        const unsigned bit = sil_i_lowest_bit(differ);
        sil_i_extract_others(signs, start + bit, out);
        if (sil_i_edge_is_bad(signs, start + bit))
            continue;
        if (out->edges && out->count < out->capacity)
            sil_i_write_silhouette(record + 4 * bit, start + bit, (uint32_t)(second >> bit & 1),
                                   &out->edges[out->count]);
        ++out->count;
    }
}

/* ---- the signs of a patch ---- */

/* 1 for each place in a patch whose face is in front: 64 places a word. */
typedef uint64_t sil_i_mask[SIL_I_PLACES / 64];

/* An eye for the planes of eight patches in whole numbers. A plane of a patch is n = mid + half * q / 32767, and its t =
   mid . x + sum of half * x * q / 32767, x the eye about the patch's origin. With G the largest |half * x| and W = half *
   x * 16383 / G rounded, t is near mid . x + G / (32767 * 16383) * sum of W * q. That sum is a whole number below 2^31
   that no compiler flag changes. It is off by at most 4 * 32767 * 0.51 for the rounding of W and 4 * 16384 * 0.51 for
   that of q, 1e5 in all; 2^17 are allowed, and the same four limits as in sil_i_undecided for floats. */
typedef struct sil_i_patch_eyes {
    int32_t weight[2][SIL_I_LANES];                 /* of nx, ny and of nz, d: 16 bits each */
    int32_t above[SIL_I_LANES], below[SIL_I_LANES]; /* sums above are in front, sums below are not */
} sil_i_patch_eyes;

#define SIL_I_WEIGHT 16383.0f
#define SIL_I_UNIT 536821761.0f /* 16383 * 32767 */
#define SIL_I_SLACK 131072.0f
#define SIL_I_MOST 2147483520.0f /* the largest float below 2^31, above every sum */

static uint32_t sil_i_weight(float x) {
    return (uint32_t)(int32_t)(x + (x < 0 ? -0.5f : 0.5f)) & 0xffffu;
}

static void sil_i_patch_eye_plain(const sil_i_cones *c, size_t i, const sil_i_eye *eye, sil_i_patch_eyes *out) {
    const float ew = eye->plane[3];
    float g[4], t = -c->mid[3][i] * ew, largest = 1e-20f, unit, above, below;
    int k;
    g[3] = -c->half[3][i] * ew;
    for (k = 0; k < 3; ++k) {
        const float x = eye->plane[k] - ew * c->origin[k][i];
        g[k] = c->half[k][i] * x;
        t += c->mid[k][i] * x;
    }
    for (k = 0; k < 4; ++k)
        largest = fabsf(g[k]) > largest ? fabsf(g[k]) : largest;
    for (k = 0; k < 4; ++k)
        g[k] *= SIL_I_WEIGHT / largest;
    unit = SIL_I_UNIT / largest;
    above = (4 * eye->limit - t) * unit + SIL_I_SLACK;
    below = (-4 * eye->limit - t) * unit - SIL_I_SLACK;
    out->weight[0][i] = (int32_t)(sil_i_weight(g[0]) | sil_i_weight(g[1]) << 16);
    out->weight[1][i] = (int32_t)(sil_i_weight(g[2]) | sil_i_weight(g[3]) << 16);
    out->above[i] = (int32_t)(above > SIL_I_MOST ? SIL_I_MOST : above < -SIL_I_MOST ? -SIL_I_MOST : above);
    out->below[i] = (int32_t)(below > SIL_I_MOST ? SIL_I_MOST : below < -SIL_I_MOST ? -SIL_I_MOST : below);
}

/* Which of eight boxes may hold planes of either sign, or some that are not sure: bits. A plane is sure where |t| is more
   than eye->limit. With v = 2^-24 and S = |ex| + |ey| + |ez| + 3 |ew|, of which the limit is more than 16v: origins are
   at most 1 on each axis, offsets about them at most 3.5, so that the terms of t and of r are each at most
   S + 3.5 |ew| < 2.2 S, and with 7 roundings for each of the two sums the error of t and r together is below
   2 * 7v * 2.2 S < 2 * limit. One limit for the planes, two for this, and one to spare. */
static unsigned sil_i_undecided_plain(const sil_i_cones *c, const sil_i_eye *eye) {
    const float ex = eye->plane[0], ey = eye->plane[1], ez = eye->plane[2], ew = eye->plane[3];
    const float pad = 4 * eye->limit, aw = fabsf(ew);
    float gap[SIL_I_LANES];
    unsigned bits = 0, i;
    for (i = 0; i < SIL_I_LANES; ++i) {
        const float x = ex - ew * c->origin[0][i], y = ey - ew * c->origin[1][i], z = ez - ew * c->origin[2][i];
        const float t = c->mid[0][i] * x + c->mid[1][i] * y + c->mid[2][i] * z - c->mid[3][i] * ew;
        const float r =
            c->half[0][i] * fabsf(x) + c->half[1][i] * fabsf(y) + c->half[2][i] * fabsf(z) + c->half[3][i] * aw;
        gap[i] = fabsf(t) - (r + pad);
    }
    for (i = 0; i < SIL_I_LANES; ++i)
        bits |= (unsigned)!(gap[i] > 0) << i;
    return bits;
}

/* The places of a patch by their sums. Returns whether there are places in doubt, bits in `unsure`. */
static int sil_i_patch_signs_plain(const int16_t *plane, size_t places, const int32_t eye[4], sil_i_mask front,
                                   sil_i_mask unsure) {
    int32_t w[4];
    size_t place;
    int k;
    for (k = 0; k < 4; ++k)
        w[k] = (int16_t)((uint32_t)eye[k / 2] >> k % 2 * 16 & 0xffffu);
    front[0] = front[1] = unsure[0] = unsure[1] = 0;
    for (place = 0; place < places; place += 8, plane += 32) {
        unsigned fronts = 0, backs = 0;
        for (k = 0; k < 8; ++k) {
            const int16_t *q = plane + 2 * k;
            const int32_t sum = w[0] * q[0] + w[1] * q[1] + w[2] * q[16] + w[3] * q[17];
            fronts |= (unsigned)(sum > eye[2]) << k;
            backs |= (unsigned)(sum < eye[3]) << k;
        }
        front[place / 64] |= (uint64_t)fronts << place % 64;
        unsure[place / 64] |= (uint64_t)(255u & ~(fronts | backs)) << place % 64;
    }
    return (unsure[0] | unsure[1]) != 0;
}

/* Of up to 64 edges by their sides, which have their faces' signs differ, and of which the second face is in front. */
static uint64_t sil_i_patch_edges_plain(const unsigned char *side, size_t count, const sil_i_mask front,
                                        uint64_t *second) {
    uint64_t fronts[2] = {0, 0};
    size_t i;
    for (i = 0; i < count; ++i) {
        const unsigned s0 = side[i / 32 * 64 + i % 32], s1 = side[i / 32 * 64 + i % 32 + 32];
        fronts[0] |= (front[s0 / 64] >> s0 % 64 & 1) << i;
        fronts[1] |= (front[s1 / 64] >> s1 % 64 & 1) << i;
    }
    *second = fronts[1];
    return fronts[0] ^ fronts[1];
}

#ifdef SIL_I_WIDE

/* Written without loops, which gcc leaves as loops at -O2. */

SIL_I_WIDE static __m256 sil_i_load_wide(const float *from) {
    return _mm256_loadu_ps(from);
}

/* The eye about eight origins, on one axis. */
SIL_I_WIDE static __m256 sil_i_about_wide(const sil_i_cones *c, const sil_i_eye *eye, int axis) {
    return _mm256_sub_ps(_mm256_set1_ps(eye->plane[axis]),
                         _mm256_mul_ps(_mm256_set1_ps(eye->plane[3]), sil_i_load_wide(c->origin[axis])));
}

/* Two rows of 16-bit weights as one of pairs. */
SIL_I_WIDE static void sil_i_pairs_wide(__m256 low, __m256 high, int32_t *out) {
    const __m256i pairs =
        _mm256_blend_epi16(_mm256_cvtps_epi32(low), _mm256_slli_epi32(_mm256_cvtps_epi32(high), 16), 0xaa);
    _mm256_storeu_si256((__m256i *)(void *)out, pairs);
}

SIL_I_WIDE static void sil_i_clamp_wide(__m256 x, int32_t *out) {
    x = _mm256_max_ps(_mm256_set1_ps(-SIL_I_MOST), _mm256_min_ps(_mm256_set1_ps(SIL_I_MOST), x));
    _mm256_storeu_si256((__m256i *)(void *)out, _mm256_cvtps_epi32(x));
}

/* sil_i_undecided_plain, and sil_i_patch_eye_plain of all eight where any is undecided. */
SIL_I_WIDE static unsigned sil_i_undecided_wide(const sil_i_cones *c, const sil_i_eye *eye, sil_i_patch_eyes *out) {
    const __m256 sign = _mm256_set1_ps(-0.0f), pad = _mm256_set1_ps(4 * eye->limit);
    const __m256 x = sil_i_about_wide(c, eye, 0), y = sil_i_about_wide(c, eye, 1), z = sil_i_about_wide(c, eye, 2);
    const __m256 w = _mm256_set1_ps(-eye->plane[3]);
    const __m256 hx = sil_i_load_wide(c->half[0]), hy = sil_i_load_wide(c->half[1]);
    const __m256 hz = sil_i_load_wide(c->half[2]), hd = sil_i_load_wide(c->half[3]);
    const __m256 gx = _mm256_mul_ps(hx, _mm256_andnot_ps(sign, x)), gy = _mm256_mul_ps(hy, _mm256_andnot_ps(sign, y));
    const __m256 gz = _mm256_mul_ps(hz, _mm256_andnot_ps(sign, z)), gd = _mm256_mul_ps(hd, _mm256_andnot_ps(sign, w));
    const __m256 t = _mm256_add_ps(
        _mm256_add_ps(_mm256_mul_ps(sil_i_load_wide(c->mid[0]), x), _mm256_mul_ps(sil_i_load_wide(c->mid[1]), y)),
        _mm256_add_ps(_mm256_mul_ps(sil_i_load_wide(c->mid[2]), z), _mm256_mul_ps(sil_i_load_wide(c->mid[3]), w)));
    const __m256 r = _mm256_add_ps(_mm256_add_ps(gx, gy), _mm256_add_ps(_mm256_add_ps(gz, gd), pad));
    const unsigned bits = 255u ^ (unsigned)_mm256_movemask_ps(_mm256_cmp_ps(_mm256_andnot_ps(sign, t), r, _CMP_GT_OQ));
    if (bits && out) {
        /* Boxes of nothing have sizes below nothing: no weights, as exceptions may be trapped. */
        const __m256 zero = _mm256_setzero_ps(), wx = _mm256_mul_ps(_mm256_max_ps(hx, zero), x);
        const __m256 wy = _mm256_mul_ps(_mm256_max_ps(hy, zero), y), wz = _mm256_mul_ps(_mm256_max_ps(hz, zero), z);
        const __m256 wd = _mm256_mul_ps(_mm256_max_ps(hd, zero), w);
        const __m256 largest =
            _mm256_max_ps(_mm256_max_ps(_mm256_max_ps(gx, gy), _mm256_max_ps(gz, gd)), _mm256_set1_ps(1e-20f));
        const __m256 one = _mm256_div_ps(_mm256_set1_ps(SIL_I_WEIGHT), largest);
        const __m256 unit = _mm256_mul_ps(one, _mm256_set1_ps(32767.0f)), slack = _mm256_set1_ps(SIL_I_SLACK);
        sil_i_pairs_wide(_mm256_mul_ps(wx, one), _mm256_mul_ps(wy, one), out->weight[0]);
        sil_i_pairs_wide(_mm256_mul_ps(wz, one), _mm256_mul_ps(wd, one), out->weight[1]);
        sil_i_clamp_wide(_mm256_add_ps(_mm256_mul_ps(_mm256_sub_ps(pad, t), unit), slack), out->above);
        sil_i_clamp_wide(_mm256_sub_ps(_mm256_mul_ps(_mm256_add_ps(pad, t), _mm256_xor_ps(sign, unit)), slack),
                         out->below);
    }
    return bits;
}

/* The sums of eight places. */
SIL_I_WIDE static __m256i sil_i_sums_wide(const int16_t *plane, __m256i w0, __m256i w1) {
    const __m256i *q = (const __m256i *)(const void *)plane;
    return _mm256_add_epi32(_mm256_madd_epi16(_mm256_loadu_si256(q), w0),
                            _mm256_madd_epi16(_mm256_loadu_si256(q + 1), w1));
}

/* 32 places at a time; what lies behind the last is cut off. */
SIL_I_WIDE static int sil_i_patch_signs_wide(const int16_t *plane, size_t places, const int32_t eye[4],
                                             sil_i_mask front, sil_i_mask unsure) {
    const __m256i w0 = _mm256_set1_epi32(eye[0]), w1 = _mm256_set1_epi32(eye[1]);
    const __m256i above = _mm256_set1_epi32(eye[2]), below = _mm256_set1_epi32(eye[3]);
    size_t place;
    front[0] = front[1] = unsure[0] = unsure[1] = 0;
    for (place = 0; place < places; place += 32, plane += 128) {
        const __m256i a = sil_i_sums_wide(plane, w0, w1), b = sil_i_sums_wide(plane + 32, w0, w1);
        const __m256i c = sil_i_sums_wide(plane + 64, w0, w1), d = sil_i_sums_wide(plane + 96, w0, w1);
        const __m256i fronts = sil_i_pack_wide(_mm256_cmpgt_epi32(a, above), _mm256_cmpgt_epi32(b, above),
                                               _mm256_cmpgt_epi32(c, above), _mm256_cmpgt_epi32(d, above));
        const __m256i backs = sil_i_pack_wide(_mm256_cmpgt_epi32(below, a), _mm256_cmpgt_epi32(below, b),
                                              _mm256_cmpgt_epi32(below, c), _mm256_cmpgt_epi32(below, d));
        const uint32_t here = places - place < 32 ? ((uint32_t)1 << (places - place)) - 1 : 0xffffffffu;
        front[place / 64] |= (uint64_t)((uint32_t)_mm256_movemask_epi8(fronts) & here) << place % 64;
        unsure[place / 64] |= (uint64_t)(~(uint32_t)_mm256_movemask_epi8(_mm256_or_si256(fronts, backs)) & here)
                              << place % 64;
    }
    return (unsure[0] | unsure[1]) != 0;
}

SIL_I_WIDE static uint32_t sil_i_nonzero_wide(const unsigned char *bytes) {
    const __m256i b = _mm256_loadu_si256((const __m256i *)(const void *)bytes);
    return (uint32_t)_mm256_movemask_epi8(_mm256_cmpgt_epi8(b, _mm256_setzero_si256()));
}

/* 32 sides at a time: a byte of the mask and a bit of that are looked up for each by one instruction. */
SIL_I_WIDE static uint32_t sil_i_look_up_wide(const unsigned char *side, __m256i bytes) {
    const __m256i bits = _mm256_set1_epi64x((long long)0x8040201008040201u);
    const __m256i s = _mm256_loadu_si256((const __m256i *)(const void *)side);
    const __m256i at = _mm256_and_si256(_mm256_srli_epi16(s, 3), _mm256_set1_epi8(15));
    const __m256i bit = _mm256_shuffle_epi8(bits, _mm256_and_si256(s, _mm256_set1_epi8(7)));
    const __m256i byte = _mm256_shuffle_epi8(bytes, at);
    return (uint32_t)_mm256_movemask_epi8(_mm256_cmpeq_epi8(_mm256_and_si256(byte, bit), bit));
}

SIL_I_WIDE static uint64_t sil_i_patch_edges_wide(const unsigned char *side, size_t count, const sil_i_mask front,
                                                  uint64_t *second) {
    const __m256i bytes = _mm256_broadcastsi128_si256(_mm_set_epi64x((long long)front[1], (long long)front[0]));
    const uint64_t all = count < 64 ? ((uint64_t)1 << count) - 1 : ~(uint64_t)0;
    uint64_t f0 = sil_i_look_up_wide(side, bytes), f1 = sil_i_look_up_wide(side + 32, bytes);
    f0 |= (uint64_t)sil_i_look_up_wide(side + 64, bytes) << 32;
    f1 |= (uint64_t)sil_i_look_up_wide(side + 96, bytes) << 32;
    *second = f1;
    return (f0 ^ f1) & all;
}

#endif

/* The three steps by vectors or one by one: `wide` is a constant wherever these end up. */

SIL_I_INLINE unsigned sil_i_undecided(const sil_i_cones *c, const sil_i_eye *eye, sil_i_patch_eyes *out, int wide) {
    unsigned bits, i;
#ifdef SIL_I_WIDE
    if (wide)
        return sil_i_undecided_wide(c, eye, out);
#endif
    (void)wide;
    bits = sil_i_undecided_plain(c, eye);
    for (i = 0; out && i < SIL_I_LANES; ++i)
        if (bits >> i & 1)
            sil_i_patch_eye_plain(c, i, eye, out);
    return bits;
}

SIL_I_INLINE int sil_i_patch_signs(const int16_t *plane, size_t places, const int32_t eye[4], sil_i_mask front,
                                   sil_i_mask unsure, int wide) {
#ifdef SIL_I_WIDE
    if (wide)
        return sil_i_patch_signs_wide(plane, places, eye, front, unsure);
#endif
    (void)wide;
    return sil_i_patch_signs_plain(plane, places, eye, front, unsure);
}

SIL_I_INLINE uint64_t sil_i_patch_edges(const unsigned char *side, size_t count, const sil_i_mask front,
                                        uint64_t *second, int wide) {
#ifdef SIL_I_WIDE
    if (wide)
        return sil_i_patch_edges_wide(side, count, front, second);
#endif
    (void)wide;
    return sil_i_patch_edges_plain(side, count, front, second);
}

/* From the signs of all faces, or, where there are none, one by one; of the places in `which`. */
static void sil_i_gather_signs(const sil_i_signs *signs, size_t patch, const sil_i_mask which, sil_i_mask front) {
    const unsigned along = signs->front || signs->shape != &signs->mesh->rest ? 0 : signs->eye.along;
    size_t word;
    for (word = 0; word < SIL_I_PLACES / 64; ++word) {
        uint64_t left = which[word];
        for (; left; left &= left - 1) {
            const unsigned bit = sil_i_lowest_bit(left);
            const uint32_t face = sil_i_face_at(signs->mesh, patch, 64 * word + bit);
            if (along && (signs->mesh->face_flags[face] & along) == along &&
                !(signs->mesh->face_flags[face] & SIL_I_BORROWS))
                continue; /* plainly edge-on, before its plane is fetched */
            front[word] |= (uint64_t)sil_i_is_front(signs, face) << bit;
        }
    }
}

/* From the signs of all faces: the patch's own are in a row. */
SIL_I_INLINE void sil_i_pick_signs(const sil_i_signs *signs, size_t patch, size_t places, sil_i_mask front, int wide) {
    const uint32_t *rim = signs->mesh->patches->rim + signs->mesh->patches->rim_first[patch];
    const unsigned char *own = signs->front + patch * SIL_I_PATCH;
    size_t i;
    (void)wide;
#ifdef SIL_I_WIDE
    if (wide)
        front[0] = sil_i_nonzero_wide(own);
    else
#endif
        for (i = 0; i < SIL_I_PATCH; ++i)
            front[0] |= (uint64_t)own[i] << i;
    for (i = SIL_I_PATCH; i < places; ++i)
        front[i / 64] |= (uint64_t)signs->front[rim[i - SIL_I_PATCH]] << i % 64;
}

static void sil_i_all_places(size_t places, sil_i_mask all) {
    all[0] = places < 64 ? ((uint64_t)1 << places) - 1 : ~(uint64_t)0;
    all[1] = places <= 64 ? 0 : places < 128 ? ((uint64_t)1 << (places - 64)) - 1 : ~(uint64_t)0;
}

/* Patches are handled a batch at a time, in three steps, and what a step reads is asked for in the one before: memory
   answers a hundred times slower than a core computes, but many requests at once. */
#define SIL_I_BATCH 16u

typedef struct sil_i_batch {
    const sil_i_signs *signs;
    sil_i_edges_out *out;
    size_t count, looked;
    int sparse; /* are the patches of the batch scattered? Those in a row are fetched by the machine itself */
    const sil_i_head *head[SIL_I_BATCH];
    uint32_t patch[SIL_I_BATCH];
    int32_t eye[SIL_I_BATCH][4]; /* weights, above, below */
    size_t runs;                 /* of up to 64 edges that have silhouettes */
    const uint32_t *record[SIL_I_BATCH];
    uint32_t start[SIL_I_BATCH];
    uint64_t differ[SIL_I_BATCH], second[SIL_I_BATCH];
} sil_i_batch;

static void sil_i_batch_begin(sil_i_batch *batch, const sil_i_signs *signs, sil_i_edges_out *out) {
    batch->signs = signs;
    batch->out = out;
    batch->count = batch->looked = batch->runs = 0;
    batch->sparse = 0;
}

SIL_I_INLINE void sil_i_fetch(const void *memory, size_t lines) {
#if defined(__GNUC__) && !defined(__TINYC__)
    const char *at = (const char *)memory;
    for (; lines > 0; --lines, at += SIL_I_LINE)
        __builtin_prefetch(at);
#else
    (void)memory;
    (void)lines;
#endif
}

SIL_I_INLINE void sil_i_batch_write(sil_i_batch *batch, int wide) {
    size_t i;
    for (i = 0; i < batch->runs; ++i)
        sil_i_write_silhouettes(batch->signs, batch->record[i], batch->start[i], batch->differ[i], batch->second[i],
                                batch->out, wide);
    batch->runs = 0;
}

/* Finds the silhouettes of a patch whose faces' signs are known. */
SIL_I_INLINE void sil_i_batch_find(sil_i_batch *batch, const sil_i_head *head, const sil_i_mask front, int wide) {
    const unsigned char *sides = sil_i_patch_sides(head);
    const uint32_t *records = sil_i_patch_records(head);
    uint32_t i;
    sil_i_mask all;
    sil_i_all_places(head->places, all);
    if (!(front[0] | front[1]) || (front[0] == all[0] && front[1] == all[1]))
        return;
    for (i = 0; i < head->edge_count; i += 64) {
        const uint32_t left = head->edge_count - i < 64 ? head->edge_count - i : 64;
        const size_t run = batch->runs;
        uint64_t differ = sil_i_patch_edges(sides + 2 * i, left, front, &batch->second[run], wide);
        batch->record[run] = records + 4 * (size_t)i;
        batch->start[run] = head->edge_first + i;
        batch->differ[run] = differ;
        batch->runs += differ != 0;
        while (batch->sparse && differ) { /* four records are a line */
            const unsigned bit = sil_i_lowest_bit(differ) & ~3u;
            sil_i_fetch(batch->record[run] + 4 * bit, 1);
            differ &= ~((uint64_t)15 << bit);
        }
        if (batch->runs == SIL_I_BATCH)
            sil_i_batch_write(batch, wide);
    }
}

/* ---- the search of the hierarchy ---- */

SIL_I_INLINE void sil_i_batch_run(sil_i_batch *batch, int wide) {
    size_t i;
    batch->sparse = batch->count && batch->patch[batch->count - 1] - batch->patch[0] > 2 * SIL_I_BATCH;
    for (i = 0; i < batch->count; ++i) {
        const sil_i_head *head = batch->head[i];
        sil_i_mask front, unsure;
        if (sil_i_patch_signs(sil_i_patch_planes(head), head->places, batch->eye[i], front, unsure, wide))
            sil_i_gather_signs(batch->signs, batch->patch[i], unsure, front);
        sil_i_batch_find(batch, head, front, wide);
    }
    sil_i_batch_write(batch, wide);
    batch->looked += batch->count;
    batch->count = 0;
}

/* A patch that may have silhouettes. */
SIL_I_INLINE void sil_i_batch_add(sil_i_batch *batch, size_t patch, const sil_i_patch_eyes *eyes, int wide) {
    const sil_i_patches *p = batch->signs->mesh->patches;
    const size_t lane = patch % SIL_I_LANES, i = batch->count++;
    batch->patch[i] = (uint32_t)patch;
    batch->head[i] = sil_i_patch_head(p, patch);
    batch->eye[i][0] = eyes->weight[0][lane];
    batch->eye[i][1] = eyes->weight[1][lane];
    batch->eye[i][2] = eyes->above[lane];
    batch->eye[i][3] = eyes->below[lane];
    sil_i_fetch(batch->head[i], 9); /* head, planes, sides */
    if (batch->count == SIL_I_BATCH)
        sil_i_batch_run(batch, wide);
}

/* Looks at all patches that may have silhouettes, in rising order. Returns their number. */
SIL_I_INLINE size_t sil_i_hunt_by(const sil_i_signs *signs, sil_i_edges_out *out, int wide) {
    const sil_i_hierarchy *h = signs->mesh->hierarchy;
    uint32_t stack[(SIL_I_LANES - 1) * SIL_I_LEVELS + 1];
    unsigned char level[(SIL_I_LANES - 1) * SIL_I_LEVELS + 1];
    size_t top = 1;
    sil_i_batch batch;
    sil_i_batch_begin(&batch, signs, out);
    stack[0] = 0;
    level[0] = (unsigned char)h->levels;
    while (top) {
        const unsigned below = level[--top] - 1u;
        const size_t at = stack[top];
        const size_t left = h->count[below + 1] - at * SIL_I_LANES;
        const sil_i_cones *cones = &h->cones[h->first[below + 1] + at];
        sil_i_patch_eyes eyes;
        unsigned k, bits = sil_i_undecided(cones, &signs->eye, below ? NULL : &eyes, wide);
        if (left < SIL_I_LANES) /* boxes of nothing, which an eye too far off for float planes does not leave out */
            bits &= (1u << left) - 1;
        if (below)
            for (k = SIL_I_LANES; k-- > 0;) { /* the first on top of the stack */
                stack[top] = (uint32_t)(at * SIL_I_LANES + k);
                level[top] = (unsigned char)below;
                top += bits >> k & 1;
            }
        else
            for (; bits; bits &= bits - 1)
                sil_i_batch_add(&batch, at * SIL_I_LANES + sil_i_lowest_bit(bits), &eyes, wide);
    }
    sil_i_batch_run(&batch, wide);
    return batch.looked;
}

/* All patches, from the signs of their faces. */
SIL_I_INLINE void sil_i_scan_by(const sil_i_signs *signs, sil_i_edges_out *out, int wide) {
    const sil_i_patches *p = signs->mesh->patches;
    size_t patch;
    sil_i_batch batch;
    sil_i_batch_begin(&batch, signs, out);
    for (patch = 0; patch < p->count; ++patch) {
        const sil_i_head *head = sil_i_patch_head(p, patch);
        sil_i_mask all, front = {0, 0};
        if (signs->front)
            sil_i_pick_signs(signs, patch, head->places, front, wide);
        else {
            sil_i_all_places(head->places, all);
            sil_i_gather_signs(signs, patch, all, front);
        }
        sil_i_batch_find(&batch, head, front, wide);
    }
    sil_i_batch_write(&batch, wide);
}

static size_t sil_i_hunt_plain(const sil_i_signs *signs, sil_i_edges_out *out) {
    return sil_i_hunt_by(signs, out, 0);
}

static void sil_i_scan_plain(const sil_i_signs *signs, sil_i_edges_out *out) {
    sil_i_scan_by(signs, out, 0);
}

#ifdef SIL_I_WIDE
SIL_I_WIDE static size_t sil_i_hunt_wide(const sil_i_signs *signs, sil_i_edges_out *out) {
    return sil_i_hunt_by(signs, out, 1);
}

SIL_I_WIDE static void sil_i_scan_wide(const sil_i_signs *signs, sil_i_edges_out *out) {
    sil_i_scan_by(signs, out, 1);
}
#endif

static size_t sil_i_hunt(const sil_i_signs *signs, sil_i_edges_out *out) {
#ifdef SIL_I_WIDE
    if (signs->mesh->wide)
        return sil_i_hunt_wide(signs, out);
#endif
    return sil_i_hunt_plain(signs, out);
}

static void sil_i_scan(const sil_i_signs *signs, sil_i_edges_out *out) {
#ifdef SIL_I_WIDE
    if (signs->mesh->wide) {
        sil_i_scan_wide(signs, out);
        return;
    }
#endif
    sil_i_scan_plain(signs, out);
}

/* ---- the dead zone ---- */

SIL_DEF sil_result sil_pose_set_dead_zone(sil_pose *pose, double sine, unsigned flags) {
    if (!pose || !(sine >= 0 && sine < 1) || flags & ~(unsigned)SIL_ZONE_REMEMBER)
        return SIL_INVALID_ARGUMENT;
    if (flags & SIL_ZONE_REMEMBER && !pose->zone_last) {
        const sil_allocator *a = &pose->mesh->allocator;
        pose->zone_last = (unsigned char *)a->alloc_fn(pose->mesh->face_count + 1, a->user);
        if (!pose->zone_last)
            return SIL_OUT_OF_MEMORY;
    }
    if (pose->zone_last)
        memset(pose->zone_last, 0, pose->mesh->face_count);
    pose->zone_sine = sine;
    pose->zone_remembers = (flags & SIL_ZONE_REMEMBER) != 0;
    return SIL_OK;
}

/* Divides a vector by its largest coordinate, so that its square has a range to be in. */
static void sil_i_shrink(double v[3]) {
    const double size = sil_i_larger(sil_i_abs(v[0]), sil_i_larger(sil_i_abs(v[1]), sil_i_abs(v[2])));
    int k;
    for (k = 0; k < 3 && size > 0; ++k)
        v[k] /= size;
}

/* |n . w| <= sine |n| |w|, w from the middle of the corners to the eye, in double. */
static int sil_i_in_zone(const sil_i_shape *shape, const uint32_t *corner, const sil_i_eye *eye, double sine) {
    const float *a = shape->position + 3 * (size_t)corner[0], *b = shape->position + 3 * (size_t)corner[1];
    const float *c = shape->position + 3 * (size_t)corner[2];
    double u[3], v[3], w[3], n[3], dot = 0, nn = 0, ww = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        u[k] = (double)b[k] - (double)a[k];
        v[k] = (double)c[k] - (double)a[k];
        w[k] = 3 * eye->e[k] - eye->e[3] * ((double)a[k] + (double)b[k] + (double)c[k]);
    }
    sil_i_shrink(u);
    sil_i_shrink(v);
    sil_i_shrink(w);
    for (k = 0; k < 3; ++k)
        n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    sil_i_shrink(n);
    for (k = 0; k < 3; ++k) {
        dot += n[k] * w[k];
        nn += n[k] * n[k];
        ww += w[k] * w[k];
    }
    return dot * dot <= sine * sine * nn * ww;
}

/* Changes exact signs of all faces to those with the pose's zone. Planes tell cheaply which faces surely are outside:
   in their space |n . w| <= sine |w| and |w| <= |e| + sqrt(3) |ew|. */
static void sil_i_zone_apply(sil_pose *pose, const sil_i_shape *shape, const sil_i_eye *eye) {
    const sil_mesh *mesh = pose->mesh;
    const double ex = (double)eye->plane[0], ey = (double)eye->plane[1], ez = (double)eye->plane[2];
    const double reach = sqrt(ex * ex + ey * ey + ez * ez) + 1.7320509 * sil_i_abs((double)eye->plane[3]);
    const float edge = (float)(1.001 * pose->zone_sine * reach) + 2 * eye->limit;
    unsigned char *front = pose->front, *last = pose->zone_remembers ? pose->zone_last : NULL;
    size_t f;
    for (f = 0; f < mesh->face_count; ++f) {
        const float t = shape->plane[0][f] * eye->plane[0] + shape->plane[1][f] * eye->plane[1] +
                        shape->plane[2][f] * eye->plane[2] - shape->plane[3][f] * eye->plane[3];
        const uint32_t *corner = mesh->corner + 3 * f;
        if (shape->bad_count && (shape->bad[corner[0]] | shape->bad[corner[1]] | shape->bad[corner[2]]))
            continue;
        if (t <= edge && t >= -edge && !(mesh->face_flags[f] & SIL_I_BORROWS) &&
            sil_i_in_zone(shape, corner, eye, pose->zone_sine))
            front[f] = last ? last[f] : 0;
        if (last)
            last[f] = front[f];
    }
    for (f = 0; f < mesh->flat_count; ++f)
        if (mesh->flat_root[f] != SIL_NONE)
            front[mesh->flat_face[f]] = front[mesh->flat_root[f]];
}

SIL_DEF size_t sil_extract(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, unsigned kinds, sil_edge *edges,
                           size_t capacity) {
    sil_i_signs signs;
    sil_i_edges_out out;
    size_t looked = 0;
    int search, zone;
    if (!mesh || (pose && pose->mesh != mesh))
        return 0;
    memset(&signs, 0, sizeof signs);
    signs.mesh = mesh;
    signs.shape = sil_i_shape_of(mesh, pose);
    sil_i_edges_begin(mesh, kinds, edges, capacity, &out);
    zone = pose && pose->zone_sine > 0;
    search = mesh->hierarchy && signs.shape == &mesh->rest && !zone;
    if (view) {
        signs.in_view = 1;
        sil_i_eye_make(&signs.eye, view, signs.shape);
        if (pose && (!search || (size_t)(out.other_end - out.other) > mesh->face_count / 8)) {
            sil_i_front_all(mesh, signs.shape, &signs.eye, pose->front);
            if (zone && signs.eye.valid)
                sil_i_zone_apply(pose, signs.shape, &signs.eye);
            sil_i_clear_bad_faces(mesh, signs.shape, pose->front);
            signs.front = pose->front;
        }
        if (kinds & SIL_SILHOUETTE && signs.eye.valid) {
            if (search)
                looked = sil_i_hunt(&signs, &out);
            else
                sil_i_scan(&signs, &out);
        }
    }
    sil_i_extract_others(&signs, SIL_NONE, &out);
    if (pose)
        pose->looked = looked;
    return out.count;
}

/* ---- the tracker ---- */

/* Exact deadlines (how far may the eye move before a patch has to be looked at again?) were tried and dropped: they leave
   out too few of the patches that the hierarchy looks at (docs/silhouette.md has the figures). */

static int sil_i_track_room(sil_pose *pose, size_t count) {
    const sil_allocator *a = &pose->mesh->allocator;
    size_t room = 2 * pose->tracked_capacity;
    uint32_t *memory;
    if (count <= pose->tracked_capacity)
        return 1;
    room = room > count ? room : count;
    memory = (uint32_t *)a->alloc_fn(room * sizeof(uint32_t), a->user);
    if (!memory)
        return 0;
    if (pose->tracked_count)
        memcpy(memory, pose->tracked, pose->tracked_count * sizeof(uint32_t));
    sil_i_give(a, pose->tracked);
    pose->tracked = memory;
    pose->tracked_capacity = room;
    return 1;
}

SIL_DEF size_t sil_track(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, unsigned kinds, sil_edge *edges,
                         size_t capacity, sil_changes *changes) {
    size_t count, i = 0, j = 0;
    if (!changes)
        return 0;
    changes->entered_count = changes->left_count = 0;
    if (!mesh || !pose || pose->mesh != mesh)
        return 0;
    count = sil_extract(mesh, pose, view, kinds, edges, capacity);
    if (count > (edges ? capacity : 0))
        return count;
    if (!sil_i_track_room(pose, count)) {
        changes->entered_count = changes->left_count = (size_t)-1;
        return 0;
    }
    while (i < count || j < pose->tracked_count) {
        const uint32_t now = i < count ? edges[i].edge : SIL_NONE;
        const uint32_t last = j < pose->tracked_count ? pose->tracked[j] : SIL_NONE;
        if (now < last && changes->entered && changes->entered_count < changes->capacity)
            changes->entered[changes->entered_count] = now;
        if (last < now && changes->left && changes->left_count < changes->capacity)
            changes->left[changes->left_count] = last;
        changes->entered_count += now < last;
        changes->left_count += last < now;
        i += now <= last;
        j += last <= now;
    }
    for (i = 0; i < count; ++i)
        pose->tracked[i] = edges[i].edge;
    pose->tracked_count = count;
    return count;
}

/* ---- chains ---- */

/* An end of an edge in a set: 2 * (place in rising order) + 0 for the end a, 1 for the end b. */
typedef struct sil_i_chains {
    const sil_mesh *mesh;
    const sil_edge *edges;
    size_t count;     /* edges without repetition */
    uint32_t without; /* edges of all these kinds are left out */
    uint64_t *keys;   /* (edge << 32 | index), then (vertex << 32 | end) */
    uint32_t *order;  /* place -> index in edges */
    uint32_t *table;  /* edge -> place, open-addressed */
    size_t table_size;
    uint32_t *link; /* end -> the end that it goes on with, or SIL_NONE */
    unsigned char *done;
} sil_i_chains;

static void sil_i_sift(uint64_t *keys, size_t at, size_t count) {
    const uint64_t key = keys[at];
    size_t child;
    while ((child = 2 * at + 1) < count) {
        if (child + 1 < count && keys[child + 1] > keys[child])
            ++child;
        if (keys[child] <= key)
            break;
        keys[at] = keys[child];
        at = child;
    }
    keys[at] = key;
}

static void sil_i_sort_keys(uint64_t *keys, size_t count) {
    size_t i;
    for (i = 1; i < count && keys[i - 1] <= keys[i]; ++i)
        ;
    if (i >= count)
        return; /* sil_extract's order */
    for (i = count / 2; i-- > 0;)
        sil_i_sift(keys, i, count);
    for (i = count; i-- > 1;) {
        const uint64_t top = keys[0];
        keys[0] = keys[i];
        keys[i] = top;
        sil_i_sift(keys, 0, i);
    }
}

static size_t sil_i_chain_size(size_t edges) {
    return edges * (2 * sizeof(uint64_t) + sizeof(uint32_t) * 3 + 1) + sil_i_table_size(edges) * sizeof(uint32_t);
}

/* Memory for one call: the pose's, made larger where it is too small, or without a pose new. */
static void *sil_i_scratch(const sil_mesh *mesh, sil_pose *pose, size_t size) {
    void *memory;
    if (pose && pose->scratch_size >= size)
        return pose->scratch;
    memory = mesh->allocator.alloc_fn(size, mesh->allocator.user);
    if (memory && pose) {
        sil_i_give(&mesh->allocator, pose->scratch);
        pose->scratch = memory;
        pose->scratch_size = size;
    }
    return memory;
}

SIL_DEF sil_result sil_pose_reserve(sil_pose *pose, size_t edge_count) {
    if (!pose)
        return SIL_INVALID_ARGUMENT;
    if (edge_count > pose->mesh->edge_count)
        edge_count = pose->mesh->edge_count;
    return sil_i_scratch(pose->mesh, pose, sil_i_chain_size(edge_count) + 1) && sil_i_track_room(pose, edge_count)
               ? SIL_OK
               : SIL_OUT_OF_MEMORY;
}

/* Shares out the scratch memory and fills order and table: edges by rising index, each once. */
static void sil_i_chains_begin(sil_i_chains *c, size_t count, void *memory) {
    size_t i, at;
    c->table_size = sil_i_table_size(count);
    c->keys = (uint64_t *)memory;
    c->table = (uint32_t *)(void *)(c->keys + 2 * count);
    c->order = c->table + c->table_size;
    c->link = c->order + count;
    c->done = (unsigned char *)(void *)(c->link + 2 * count);
    for (i = 0, at = 0; i < count; ++i)
        if (c->edges[i].edge < c->mesh->edge_count && (c->edges[i].kinds & c->without) != c->without)
            c->keys[at++] = (uint64_t)c->edges[i].edge << 32 | i;
    sil_i_sort_keys(c->keys, at);
    for (i = 0, c->count = 0; i < at; ++i)
        if (i == 0 || c->keys[i] >> 32 != c->keys[i - 1] >> 32)
            c->order[c->count++] = (uint32_t)(c->keys[i] & 0xffffffffu);
    memset(c->table, 0xff, c->table_size * sizeof(uint32_t));
    memset(c->link, 0xff, 2 * c->count * sizeof(uint32_t));
    memset(c->done, 0, c->count);
    for (i = 0; i < c->count; ++i) {
        size_t slot = sil_i_hash(c->edges[c->order[i]].edge, 0, 0) & (c->table_size - 1);
        while (c->table[slot] != SIL_NONE)
            slot = (slot + 1) & (c->table_size - 1);
        c->table[slot] = (uint32_t)i;
    }
}

static const sil_edge *sil_i_place(const sil_i_chains *c, uint32_t place) {
    return &c->edges[c->order[place]];
}

static uint32_t sil_i_line_kinds(const sil_i_chains *c, uint32_t place) {
    return sil_i_place(c, place)->kinds & SIL_I_LINES;
}

static uint32_t sil_i_find_place(const sil_i_chains *c, uint32_t edge) {
    size_t slot = sil_i_hash(edge, 0, 0) & (c->table_size - 1);
    while (c->table[slot] != SIL_NONE) {
        if (sil_i_place(c, c->table[slot])->edge == edge)
            return c->table[slot];
        slot = (slot + 1) & (c->table_size - 1);
    }
    return SIL_NONE;
}

/* The welded vertex at an end. Only the edge's own vertices are believed, whatever a and b are. */
static uint32_t sil_i_end_vertex(const sil_i_chains *c, uint32_t end) {
    const sil_edge *edge = sil_i_place(c, end / 2);
    const uint32_t *v = c->mesh->edge_vertex + 2 * (size_t)edge->edge;
    const int reversed = edge->a == c->mesh->origin[v[1]];
    return v[(end & 1) != (uint32_t)reversed];
}

static uint32_t sil_i_front_face(const sil_i_chains *c, uint32_t place) {
    const sil_edge *edge = sil_i_place(c, place);
    const uint32_t f0 = c->mesh->edge_face[0][edge->edge], f1 = c->mesh->edge_face[1][edge->edge];
    return c->mesh->source[f1] == edge->face[0] ? f1 : f0;
}

/* From an end of a silhouette through the front faces around the vertex to the next silhouette of the set, which must
   see the last of these faces as its own front. The way back is the same, so that links are mutual. */
static uint32_t sil_i_turn(const sil_i_chains *c, uint32_t end) {
    const sil_mesh *mesh = c->mesh;
    const uint32_t vertex = sil_i_end_vertex(c, end), start = sil_i_place(c, end / 2)->edge;
    uint32_t edge = start, face = sil_i_front_face(c, end / 2);
    while (face != SIL_NONE) {
        uint32_t i, next = SIL_NONE, place;
        for (i = 0; i < 3; ++i) {
            const uint32_t e = mesh->face_edge[3 * (size_t)face + i];
            const uint32_t *v = mesh->edge_vertex + 2 * (size_t)e;
            if (e != edge && (v[0] == vertex || v[1] == vertex))
                next = e;
        }
        if (next == SIL_NONE || next == start)
            return SIL_NONE;
        place = sil_i_find_place(c, next);
        if (place != SIL_NONE && sil_i_line_kinds(c, place) == SIL_SILHOUETTE) {
            if (sil_i_front_face(c, place) != face)
                return SIL_NONE;
            return 2 * place + (sil_i_end_vertex(c, 2 * place) != vertex);
        }
        edge = next;
        face = sil_i_across(mesh, edge, face);
    }
    return SIL_NONE;
}

/* Links the two ends among keys[0 .. count - 1], all at one vertex, that are the only ones of these kinds. Silhouettes
   keep their direction: an end b with an end a. */
static void sil_i_link_kind(const sil_i_chains *c, const uint64_t *keys, size_t count, uint32_t kinds) {
    uint32_t found[2] = {0, 0};
    size_t i, matches = 0;
    for (i = 0; i < count; ++i) {
        const uint32_t end = (uint32_t)(keys[i] & 0xffffffffu);
        if (sil_i_line_kinds(c, end / 2) != kinds)
            continue;
        if (matches < 2)
            found[matches] = end;
        ++matches;
    }
    if (matches == 2 && (kinds != SIL_SILHOUETTE || (found[0] ^ found[1]) & 1u)) {
        c->link[found[0]] = found[1];
        c->link[found[1]] = found[0];
    }
}

/* Links the ends that are left, where exactly two of the same kinds meet at a vertex. */
static void sil_i_link_pairs(const sil_i_chains *c) {
    size_t i, j, k, left = 0;
    for (i = 0; i < 2 * c->count; ++i)
        if (c->link[i] == SIL_NONE)
            c->keys[left++] = (uint64_t)sil_i_end_vertex(c, (uint32_t)i) << 32 | i;
    sil_i_sort_keys(c->keys, left);
    for (i = 0; i < left; i = j) {
        uint32_t seen[(SIL_I_LINES + 32) / 32] = {0, 0, 0}; /* kinds that were looked at; a bit each */
        for (j = i; j < left && c->keys[j] >> 32 == c->keys[i] >> 32; ++j)
            ;
        for (k = i; k < j; ++k) {
            const uint32_t kinds = sil_i_line_kinds(c, (uint32_t)(c->keys[k] & 0xffffffffu) / 2);
            if (!(seen[kinds / 32] >> kinds % 32 & 1)) {
                seen[kinds / 32] |= 1u << kinds % 32;
                sil_i_link_kind(c, c->keys + i, j - i, kinds);
            }
        }
    }
}

static void sil_i_link_turns(const sil_i_chains *c) {
    uint32_t i;
    for (i = 0; i < 2 * c->count; ++i)
        if (c->link[i] == SIL_NONE && sil_i_line_kinds(c, i / 2) == SIL_SILHOUETTE) {
            const uint32_t other = sil_i_turn(c, i);
            if (other != SIL_NONE && other != i && c->link[other] == SIL_NONE) {
                c->link[i] = other;
                c->link[other] = i;
            }
        }
}

typedef struct sil_i_strip_out {
    sil_strip *strips;
    size_t strip_capacity, strip_count;
    uint32_t *vertices;
    size_t vertex_capacity, vertex_count;
} sil_i_strip_out;

static void sil_i_write_vertex(const sil_i_chains *c, sil_i_strip_out *out, uint32_t end) {
    if (out->vertices && out->vertex_count < out->vertex_capacity)
        out->vertices[out->vertex_count] = c->mesh->origin[sil_i_end_vertex(c, end)];
    ++out->vertex_count;
}

/* The strip that an edge is in: back from its end a to where the strip begins, then forward to where it ends. */
static void sil_i_write_strip(const sil_i_chains *c, sil_i_strip_out *out, uint32_t place) {
    const size_t first = out->vertex_count;
    uint32_t begin = 2 * place, end;
    int closed = 0;
    while (c->link[begin] != SIL_NONE && !closed) {
        begin = c->link[begin] ^ 1u;
        closed = begin == 2 * place;
    }
    sil_i_write_vertex(c, out, begin);
    end = begin;
    do {
        c->done[end / 2] = 1;
        sil_i_write_vertex(c, out, end ^ 1u);
        end = c->link[end ^ 1u];
    } while (end != SIL_NONE && end != begin);
    if (out->strips && out->strip_count < out->strip_capacity) {
        sil_strip *strip = &out->strips[out->strip_count];
        strip->first = (uint32_t)first;
        strip->count = (uint32_t)(out->vertex_count - first);
        strip->id = sil_i_place(c, place)->edge;
        strip->kinds = sil_i_line_kinds(c, place);
        strip->closed = (uint32_t)closed;
    }
    ++out->strip_count;
}

/* ---- corners of chains ---- */

typedef struct sil_i_corners {
    const sil_i_shape *shape;
    double matrix[16], width, height; /* width 0: not on the screen */
    double limit;                     /* radians */
} sil_i_corners;

/* Where a welded vertex is for the measure of turns; 0 where it has no place. */
static int sil_i_corner_place(const sil_i_corners *corners, uint32_t vertex, double place[3]) {
    const float *p = corners->shape->position + 3 * (size_t)vertex;
    const double *m = corners->matrix;
    double out[4];
    int k;
    for (k = 0; k < 4; ++k)
        out[k] = m[k] * (double)p[0] + m[4 + k] * (double)p[1] + m[8 + k] * (double)p[2] + m[12 + k];
    memcpy(place, out, 3 * sizeof *place);
    if (corners->shape->bad[vertex])
        return 0;
    if (!(corners->width > 0))
        return 1;
    if (!(out[3] > 0))
        return 0;
    place[0] = 0.5 * corners->width * out[0] / out[3];
    place[1] = 0.5 * corners->height * out[1] / out[3];
    place[2] = 0;
    return 1;
}

/* The angle by which a line turns at p[1] on its way from p[0] to p[2]; 0 where it has no direction. Its tangent, not
   its cosine, is precise for small angles. */
static double sil_i_turning(double p[3][3]) {
    double u[3], v[3], c[3], dot = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        u[k] = p[1][k] - p[0][k];
        v[k] = p[2][k] - p[1][k];
        dot += u[k] * v[k];
    }
    for (k = 0; k < 3; ++k)
        c[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    return atan2(sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]), dot);
}

static void sil_i_unlink_corners(const sil_i_chains *c, const sil_i_corners *corners) {
    double p[3][3];
    uint32_t end;
    for (end = 0; end < 2 * c->count; ++end) {
        const uint32_t other = c->link[end];
        if (other == SIL_NONE || other < end)
            continue;
        if (sil_i_corner_place(corners, sil_i_end_vertex(c, end ^ 1u), p[0]) &&
            sil_i_corner_place(corners, sil_i_end_vertex(c, end), p[1]) &&
            sil_i_corner_place(corners, sil_i_end_vertex(c, other ^ 1u), p[2]) && sil_i_turning(p) > corners->limit)
            c->link[end] = c->link[other] = SIL_NONE;
    }
}

static void sil_i_cut_corners(const sil_i_chains *c, const sil_pose *pose, const sil_chain_desc *desc) {
    sil_i_corners corners;
    int i, given = 0;
    if (!(desc->corner_degrees > 0) || !sil_i_finite(desc->corner_degrees) || !sil_i_all_finite(desc->matrix, 16) ||
        !sil_i_finite(desc->viewport_width) || !sil_i_finite(desc->viewport_height))
        return;
    memset(&corners, 0, sizeof corners);
    corners.shape = sil_i_shape_of(c->mesh, pose);
    corners.limit = (double)desc->corner_degrees * (SIL_I_PI / 180);
    sil_i_widen(desc->matrix, corners.matrix, 16);
    for (i = 0; i < 16; ++i)
        given |= sil_i_abs(corners.matrix[i]) > 0;
    for (i = 0; !given && i < 4; ++i)
        corners.matrix[5 * i] = 1;
    if (desc->viewport_width > 0 && desc->viewport_height > 0) {
        corners.width = (double)desc->viewport_width;
        corners.height = (double)desc->viewport_height;
    }
    sil_i_unlink_corners(c, &corners);
}

SIL_DEF size_t sil_chain_corners(const sil_mesh *mesh, sil_pose *pose, const sil_chain_desc *desc,
                                 const sil_edge *edges, size_t edge_count, sil_strip *strips, size_t strip_capacity,
                                 uint32_t *vertices, size_t vertex_capacity, size_t *vertices_needed) {
    sil_i_chains c;
    sil_i_strip_out out;
    void *memory;
    uint32_t i;
    memset(&out, 0, sizeof out);
    out.strips = strips;
    out.strip_capacity = strip_capacity;
    out.vertices = vertices;
    out.vertex_capacity = vertex_capacity;
    if (vertices_needed)
        *vertices_needed = 0;
    if (!mesh || !edges || !edge_count || (pose && pose->mesh != mesh))
        return 0;
    memory = edge_count < 0x40000000u && edge_count < (size_t)-1 / 64
                 ? sil_i_scratch(mesh, pose, sil_i_chain_size(edge_count))
                 : NULL;
    if (!memory) {
        if (vertices_needed)
            *vertices_needed = (size_t)-1;
        return 0;
    }
    memset(&c, 0, sizeof c);
    c.mesh = mesh;
    c.edges = edges;
    c.without = desc && desc->flags & SIL_CHAIN_NO_CONCAVE ? SIL_SILHOUETTE | SIL_CONCAVE : SIL_NONE;
    sil_i_chains_begin(&c, edge_count, memory);
    sil_i_link_turns(&c);
    sil_i_link_pairs(&c);
    if (desc)
        sil_i_cut_corners(&c, pose, desc);
    for (i = 0; i < c.count; ++i)
        if (!c.done[i])
            sil_i_write_strip(&c, &out, i);
    if (!pose)
        sil_i_give(&mesh->allocator, memory);
    if (vertices_needed)
        *vertices_needed = out.vertex_count;
    return out.strip_count;
}

SIL_DEF size_t sil_chain(const sil_mesh *mesh, sil_pose *pose, const sil_edge *edges, size_t edge_count,
                         sil_strip *strips, size_t strip_capacity, uint32_t *vertices, size_t vertex_capacity,
                         size_t *vertices_needed) {
    return sil_chain_corners(mesh, pose, NULL, edges, edge_count, strips, strip_capacity, vertices, vertex_capacity,
                             vertices_needed);
}

/* ---- smooth silhouettes ---- */

typedef struct sil_i_smooth {
    const sil_mesh *mesh;
    const sil_i_shape *shape;
    double eye[4];
    double *value;       /* of each welded vertex: n * (eye - w * position) */
    double *normal;      /* x y z, of length 1 or 0 */
    unsigned char *done; /* faces */
    unsigned flags;
    sil_smooth_point *points;
    size_t point_capacity, point_count;
    sil_strip *strips;
    size_t strip_capacity, strip_count;
} sil_i_smooth;

static double sil_i_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void sil_i_make_unit(double v[3]) {
    const double square = sil_i_dot(v, v), length = sqrt(square);
    int k;
    for (k = 0; k < 3; ++k)
        v[k] = square > 0 && square < 1e300 ? v[k] / length : 0;
}

/* Sums of the normals that were given. Those that are not finite are left out. */
static void sil_i_smooth_given(const sil_i_smooth *s, const float *normals, size_t stride) {
    size_t i;
    int k;
    for (i = 0; i < s->mesh->vertex_count; ++i) {
        float n[3];
        double unit[3];
        memcpy(n, (const char *)(const void *)normals + stride * i, sizeof n);
        if (s->mesh->welded[i] >= s->mesh->unique_count || !sil_i_all_finite(n, 3))
            continue;
        sil_i_widen(n, unit, 3);
        sil_i_make_unit(unit);
        for (k = 0; k < 3; ++k)
            s->normal[3 * (size_t)s->mesh->welded[i] + (size_t)k] += unit[k];
    }
}

/* Normals from the faces, by Max's weights (Journal of Graphics Tools 4, 1999): the cross product of a corner's sides
   over the squares of their lengths. No angle is needed, and on a sphere the sum is exact. */
static void sil_i_smooth_made(const sil_i_smooth *s) {
    const sil_mesh *mesh = s->mesh;
    size_t i;
    int k;
    for (i = 0; i < 3 * mesh->face_count; ++i) {
        const size_t face = i - i % 3;
        const float *p = s->shape->position + 3 * (size_t)mesh->corner[i];
        const float *q = s->shape->position + 3 * (size_t)mesh->corner[face + (i + 1) % 3];
        const float *r = s->shape->position + 3 * (size_t)mesh->corner[face + (i + 2) % 3];
        double u[3], v[3], weight;
        for (k = 0; k < 3; ++k) {
            u[k] = (double)q[k] - (double)p[k];
            v[k] = (double)r[k] - (double)p[k];
        }
        weight = sil_i_dot(u, u) * sil_i_dot(v, v);
        if (weight > 0)
            for (k = 0; k < 3; ++k)
                s->normal[3 * (size_t)mesh->corner[i] + (size_t)k] +=
                    (u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]) / weight;
    }
}

static double sil_i_smooth_value(const sil_i_smooth *s, const double normal[3], const double place[3]) {
    double sum = 0;
    int k;
    for (k = 0; k < 3; ++k)
        sum += normal[k] * (s->eye[k] - s->eye[3] * place[k]);
    return sum;
}

static void sil_i_smooth_values(const sil_i_smooth *s) {
    size_t i;
    for (i = 0; i < s->mesh->unique_count; ++i) {
        double place[3];
        sil_i_widen(s->shape->position + 3 * i, place, 3);
        sil_i_make_unit(s->normal + 3 * i);
        s->value[i] = sil_i_smooth_value(s, s->normal + 3 * i, place);
    }
}

/* The side of a face, 0 to 2, where the value falls from positive to negative (falls = 1) or rises; 3: there is none. */
static uint32_t sil_i_smooth_side(const sil_i_smooth *s, uint32_t face, int falls) {
    const uint32_t *corner = s->mesh->corner + 3 * (size_t)face;
    uint32_t i;
    for (i = 0; i < 3; ++i)
        if (s->shape->bad_count && s->shape->bad[corner[i]])
            return 3;
    for (i = 0; i < 3; ++i) {
        const int from = s->value[corner[i]] >= 0, to = s->value[corner[(i + 1) % 3]] >= 0;
        if (from != to && from == falls)
            return i;
    }
    return 3;
}

/* From a crossed edge of a face through it to the other one. */
static uint32_t sil_i_smooth_other(const sil_i_smooth *s, uint32_t face, uint32_t edge) {
    const uint32_t *edges = s->mesh->face_edge + 3 * (size_t)face;
    const uint32_t in = edges[sil_i_smooth_side(s, face, 1)], out = edges[sil_i_smooth_side(s, face, 0)];
    return in == edge ? out : in;
}

/* The face on the other side of a crossed edge, SIL_NONE where the line ends. */
static uint32_t sil_i_smooth_across(const sil_i_smooth *s, uint32_t face, uint32_t edge) {
    const uint32_t other = sil_i_across(s->mesh, edge, face);
    return other == SIL_NONE || sil_i_smooth_side(s, other, 1) == 3 ? SIL_NONE : other;
}

/* The cubic over an edge from a to b that is at right angles to both normals. */
static void sil_i_smooth_curve(const double a[3], const double b[3], const double *na, const double *nb, double t,
                               double out[3]) {
    double d[3], along_a, along_b;
    int k;
    for (k = 0; k < 3; ++k)
        d[k] = b[k] - a[k];
    along_a = sil_i_dot(d, na);
    along_b = sil_i_dot(d, nb);
    for (k = 0; k < 3; ++k) {
        const double from = d[k] - along_a * na[k], to = d[k] - along_b * nb[k], r = 1 - t;
        out[k] = r * r * (1 + 2 * t) * a[k] + t * t * (3 - 2 * t) * b[k] + t * r * (r * from - t * to);
    }
}

/* The crossing on the cubic between t = 0 and 1, where the value has different signs, by regula falsi; an end that
   stays twice counts half (the Illinois rule), so that both close in. */
static double sil_i_smooth_root(const sil_i_smooth *s, const double a[3], const double b[3], const double *na,
                                const double *nb, double low_value, double high_value) {
    double low = 0, high = 1, t = 0.5, place[3], normal[3];
    int step, k, stayed = 0;
    for (step = 0; step < 24 && high - low > 1e-12; ++step) {
        double value;
        t = low_value / (low_value - high_value);
        t = low + (t > 0 ? t < 1 ? t : 1 : 0) * (high - low);
        sil_i_smooth_curve(a, b, na, nb, t, place);
        for (k = 0; k < 3; ++k)
            normal[k] = sil_i_mix(na[k], nb[k], t);
        value = sil_i_smooth_value(s, normal, place);
        if (!(sil_i_abs(value) > 0))
            break;
        if ((value > 0) == (low_value > 0)) {
            high_value *= stayed == 1 ? 0.5 : 1;
            low = t;
            low_value = value;
            stayed = 1;
        } else {
            low_value *= stayed == 2 ? 0.5 : 1;
            high = t;
            high_value = value;
            stayed = 2;
        }
    }
    return t;
}

static void sil_i_smooth_write(sil_i_smooth *s, uint32_t edge) {
    const uint32_t *v = s->mesh->edge_vertex + 2 * (size_t)edge;
    const double *na = s->normal + 3 * (size_t)v[0], *nb = s->normal + 3 * (size_t)v[1];
    const double from = s->value[v[0]], to = s->value[v[1]];
    const size_t at = s->point_count++;
    double a[3], b[3], place[3], normal[3], t;
    sil_smooth_point *point;
    int k;
    if (!s->points || at >= s->point_capacity)
        return;
    point = &s->points[at];
    sil_i_widen(s->shape->position + 3 * (size_t)v[0], a, 3);
    sil_i_widen(s->shape->position + 3 * (size_t)v[1], b, 3);
    t = from / (from - to); /* one is negative and the other is not */
    t = t > 0 ? t < 1 ? t : 1 : 0;
    if (s->flags & SIL_SMOOTH_HERMITE) {
        t = sil_i_abs(from) > 0 ? sil_i_smooth_root(s, a, b, na, nb, from, to) : 0;
        sil_i_smooth_curve(a, b, na, nb, t, place);
    }
    for (k = 0; k < 3; ++k) {
        if (!(s->flags & SIL_SMOOTH_HERMITE))
            place[k] = sil_i_mix(a[k], b[k], t);
        normal[k] = sil_i_mix(na[k], nb[k], t);
    }
    sil_i_make_unit(normal);
    for (k = 0; k < 3; ++k) {
        point->position[k] = (float)place[k];
        point->normal[k] = (float)normal[k];
    }
    point->edge = edge;
    point->a = s->mesh->origin[v[0]];
    point->b = s->mesh->origin[v[1]];
    point->t = (float)t;
}

/* The line through a face: back to where it begins, or to the face itself, then forward. */
static void sil_i_smooth_strip(sil_i_smooth *s, uint32_t face) {
    const uint32_t start = face, *edges = s->mesh->face_edge + 3 * (size_t)face;
    const size_t first = s->point_count;
    uint32_t edge = edges[sil_i_smooth_side(s, face, 1)], next, id;
    int closed = 0;
    while ((next = sil_i_smooth_across(s, face, edge)) != SIL_NONE && !closed) {
        face = next;
        edge = sil_i_smooth_other(s, face, edge);
        closed = face == start;
    }
    if (closed) /* once around: the edge by which it came back in */
        edge = edges[sil_i_smooth_side(s, start, 1)];
    id = edge;
    sil_i_smooth_write(s, edge);
    for (next = face; next != SIL_NONE && !s->done[next]; next = sil_i_smooth_across(s, face, edge)) {
        face = next;
        s->done[face] = 1;
        edge = sil_i_smooth_other(s, face, edge);
        id = edge < id ? edge : id;
        sil_i_smooth_write(s, edge);
    }
    if (s->strips && s->strip_count < s->strip_capacity) {
        sil_strip *strip = &s->strips[s->strip_count];
        strip->first = (uint32_t)first;
        strip->count = (uint32_t)(s->point_count - first);
        strip->id = id;
        strip->kinds = SIL_SILHOUETTE;
        strip->closed = (uint32_t)closed;
    }
    ++s->strip_count;
}

/* The eye with its largest coordinate 1 and w not negative; 0 where it is none. */
static int sil_i_smooth_eye(const sil_view *view, double eye[4]) {
    double largest = 0;
    int k, finite = 1;
    for (k = 0; k < 4; ++k) {
        (void)sil_i_from_double(view->eye[k], &finite);
        largest = sil_i_larger(largest, sil_i_abs(view->eye[k]));
    }
    if (!finite || !(largest > 0))
        return 0;
    for (k = 0; k < 4; ++k)
        eye[k] = (view->eye[3] < 0 ? -view->eye[k] : view->eye[k]) / largest;
    return 1;
}

SIL_DEF size_t sil_smooth(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, const float *normals,
                          size_t normal_stride, unsigned flags, sil_smooth_point *points, size_t point_capacity,
                          sil_strip *strips, size_t strip_capacity, size_t *points_needed) {
    sil_i_smooth s;
    void *memory;
    uint32_t face;
    memset(&s, 0, sizeof s);
    if (points_needed)
        *points_needed = 0;
    if (!mesh || !view || (pose && pose->mesh != mesh) || (normal_stride && normal_stride < 3 * sizeof(float)) ||
        !sil_i_smooth_eye(view, s.eye))
        return 0;
    memory = sil_i_scratch(mesh, pose, mesh->unique_count * 4 * sizeof(double) + mesh->face_count + 1);
    if (!memory) {
        if (points_needed)
            *points_needed = (size_t)-1;
        return 0;
    }
    s.mesh = mesh;
    s.shape = sil_i_shape_of(mesh, pose);
    s.normal = (double *)memory;
    s.value = s.normal + 3 * mesh->unique_count;
    s.done = (unsigned char *)(void *)(s.value + mesh->unique_count);
    s.flags = flags;
    s.points = points;
    s.point_capacity = point_capacity;
    s.strips = strips;
    s.strip_capacity = strip_capacity;
    memset(s.normal, 0, 3 * mesh->unique_count * sizeof *s.normal);
    memset(s.done, 0, mesh->face_count);
    if (normals)
        sil_i_smooth_given(&s, normals, normal_stride ? normal_stride : 3 * sizeof(float));
    else
        sil_i_smooth_made(&s);
    sil_i_smooth_values(&s);
    for (face = 0; face < mesh->face_count; ++face)
        if (!s.done[face] && sil_i_smooth_side(&s, face, 1) < 3)
            sil_i_smooth_strip(&s, face);
    if (!pose)
        sil_i_give(&mesh->allocator, memory);
    if (points_needed)
        *points_needed = s.point_count;
    return s.strip_count;
}

/* ---- distances ---- */

/* Eight segments for the inner loop, one array a coordinate: both ends, and 1 / length^2 or 0. */
typedef struct sil_i_lanes {
    float px[SIL_I_LANES], py[SIL_I_LANES], pz[SIL_I_LANES];
    float qx[SIL_I_LANES], qy[SIL_I_LANES], qz[SIL_I_LANES];
    float inverse[SIL_I_LANES];
} sil_i_lanes;

/* A block of them, for trying all pairs. */
typedef struct sil_i_segments {
    int endless; /* q is then the direction */
    sil_i_lanes lanes[SIL_I_BLOCK / SIL_I_LANES];
    uint32_t index[SIL_I_BLOCK]; /* in the caller's array */
    float low[3], high[3];       /* box around them */
    size_t count;
} sil_i_segments;

/* The mesh's coordinates to the world's, about the box's centre and divided by its size there, so that neither an
   offset nor a scale costs precision or range. */
typedef struct sil_i_frame {
    double model[9], center[3], scale, shrink; /* shrink = 1 / scale, a power of two */
    const sil_i_shape *shape;
} sil_i_frame;

/* 0 where the matrix is not finite. NULL or all zero is the identity. */
static int sil_i_frame_make(sil_i_frame *frame, const sil_i_shape *shape, const float *model) {
    int i, k, zero = 1;
    double size = 0;
    memset(frame, 0, sizeof *frame);
    frame->shape = shape;
    for (i = 0; model && i < 9; ++i)
        zero &= (sil_i_float_bits(model[i]) & 0x7fffffffu) == 0;
    if (!zero && !sil_i_all_finite(model, 9))
        return 0;
    for (i = 0; i < 9; ++i)
        frame->model[i] = zero ? i % 4 == 0 : (double)model[i];
    for (i = 0; i < 3; ++i) {
        double row = 0;
        frame->center[i] = shape->center[i];
        for (k = 0; k < 3; ++k)
            row += sil_i_abs(frame->model[3 * k + i]) * (shape->high[k] - shape->low[k]);
        size = sil_i_larger(size, row);
    }
    (void)frexp(size, &i);
    frame->scale = size > 0 ? sil_i_scaled(1, i) : 1;
    frame->shrink = 1 / frame->scale;
    return 1;
}

static void sil_i_to_frame(const sil_i_frame *frame, const float p[3], double out[3]) {
    double d[3];
    int i;
    for (i = 0; i < 3; ++i)
        d[i] = (double)p[i] - frame->center[i];
    for (i = 0; i < 3; ++i)
        out[i] = (frame->model[i] * d[0] + frame->model[3 + i] * d[1] + frame->model[6 + i] * d[2]) * frame->shrink;
}

/* A point whose distance is asked for. Further away than 10^12 sizes of the mesh, where squares may leave float's
   range, it is brought back to there along its way from the centre; returns by what to multiply the distance found. */
static double sil_i_point(const sil_i_frame *frame, const float p[3], float v[3]) {
    const double furthest = 1e12;
    double out[3], largest, grow;
    int k;
    sil_i_to_frame(frame, p, out);
    largest = sil_i_larger(sil_i_abs(out[0]), sil_i_larger(sil_i_abs(out[1]), sil_i_abs(out[2])));
    grow = largest > furthest ? largest / furthest : 1;
    for (k = 0; k < 3; ++k)
        v[k] = (float)(largest > furthest ? out[k] / grow : out[k]);
    return grow;
}

static float sil_i_unscaled(const sil_i_frame *frame, float square, double grow) {
    return (float)(sqrt((double)square) * grow * frame->scale);
}

/* One segment into a lane; 0 where its edge is not of this mesh or has an end that is not finite. */
static int sil_i_load_lane(const sil_mesh *mesh, const sil_i_frame *frame, uint32_t edge, int endless, sil_i_lanes *s,
                           size_t lane) {
    const uint32_t *v = edge < mesh->edge_count ? mesh->edge_vertex + 2 * (size_t)edge : NULL;
    double p[3], q[3], square;
    int k;
    if (!v || frame->shape->bad[v[0]] || frame->shape->bad[v[1]])
        return 0;
    sil_i_to_frame(frame, frame->shape->position + 3 * (size_t)v[0], p);
    sil_i_to_frame(frame, frame->shape->position + 3 * (size_t)v[1], q);
    square = (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]) + (q[2] - p[2]) * (q[2] - p[2]);
    for (k = 0; k < 3 && endless; ++k)
        q[k] = square > 1e-30 ? (q[k] - p[k]) / sqrt(square) : 0;
    s->px[lane] = (float)p[0];
    s->py[lane] = (float)p[1];
    s->pz[lane] = (float)p[2];
    s->qx[lane] = (float)q[0];
    s->qy[lane] = (float)q[1];
    s->qz[lane] = (float)q[2];
    s->inverse[lane] = square > 1e-30 ? (float)(1 / square) : 0; /* shorter than 1e-15 of the mesh: a point */
    return 1;
}

static void sil_i_copy_lane(const sil_i_lanes *from, size_t at, sil_i_lanes *to, size_t lane) {
    to->px[lane] = from->px[at];
    to->py[lane] = from->py[at];
    to->pz[lane] = from->pz[at];
    to->qx[lane] = from->qx[at];
    to->qy[lane] = from->qy[at];
    to->qz[lane] = from->qz[at];
    to->inverse[lane] = from->inverse[at];
}

/* Widens a box to hold eight segments; `any` is 0 where there is no box yet. */
static void sil_i_bound_lanes(const sil_i_lanes *s, float low[3], float high[3], int any) {
    const float *p[3], *q[3];
    size_t i;
    int k;
    p[0] = s->px;
    p[1] = s->py;
    p[2] = s->pz;
    q[0] = s->qx;
    q[1] = s->qy;
    q[2] = s->qz;
    for (k = 0; k < 3; ++k) {
        if (!any)
            low[k] = high[k] = p[k][0];
        for (i = 0; i < SIL_I_LANES; ++i) {
            const float less = p[k][i] < q[k][i] ? p[k][i] : q[k][i], more = p[k][i] < q[k][i] ? q[k][i] : p[k][i];
            low[k] = less < low[k] ? less : low[k];
            high[k] = more > high[k] ? more : high[k];
        }
    }
}

/* Is the whole block further away than the nearest so far? The margin, in units of the mesh's size, is more than the
   rounding of a distance, so that leaving the block out changes nothing. Endless lines are never out of reach. */
static int sil_i_out_of_reach(const sil_i_segments *s, const float v[3], float best) {
    float square = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        const float below = s->low[k] - v[k], above = v[k] - s->high[k];
        const float d = below > 0 ? below : above > 0 ? above : 0;
        square += d * d;
    }
    return !s->endless && square > best * 1.0001f + 1e-7f;
}

/* The next block of edges, from edges[*next]; the rest of a last block repeats its last segment. */
static void sil_i_load_segments(const sil_mesh *mesh, const sil_i_frame *frame, const sil_edge *edges,
                                size_t edge_count, size_t *next, sil_i_segments *s) {
    size_t n = 0, i;
    for (; *next < edge_count && n < SIL_I_BLOCK; ++*next)
        if (sil_i_load_lane(mesh, frame, edges[*next].edge, s->endless, &s->lanes[n / SIL_I_LANES], n % SIL_I_LANES))
            s->index[n++] = (uint32_t)*next;
    s->count = n;
    for (; n && n < SIL_I_BLOCK; ++n) {
        sil_i_copy_lane(&s->lanes[(n - 1) / SIL_I_LANES], (n - 1) % SIL_I_LANES, &s->lanes[n / SIL_I_LANES],
                        n % SIL_I_LANES);
        s->index[n] = s->index[n - 1];
    }
    for (i = 0; n && i < SIL_I_BLOCK / SIL_I_LANES; ++i)
        sil_i_bound_lanes(&s->lanes[i], s->low, s->high, i > 0);
}

/* Squared distances of one point to eight segments. The foot is m * p + t * q relative to the point, with m + t = 1, and
   exactly p or q at the ends: segments that share an end where it is the nearest point then tie exactly. The larger of a
   number and 0 is written as half its sum with its magnitude, which is exact, and has no branch: compilers then make
   vector code of it at -O2 too. */
static void sil_i_squares(const sil_i_lanes *s, const float v[3], float square[SIL_I_LANES]) {
    const float x = v[0], y = v[1], z = v[2];
    float feet[SIL_I_LANES], ends[SIL_I_LANES];
    size_t i;
    for (i = 0; i < SIL_I_LANES; ++i) {
        const float px = s->px[i] - x, py = s->py[i] - y, pz = s->pz[i] - z;
        const float qx = s->qx[i] - x, qy = s->qy[i] - y, qz = s->qz[i] - z;
        const float ex = s->qx[i] - s->px[i], ey = s->qy[i] - s->py[i], ez = s->qz[i] - s->pz[i];
        const float along = -(px * ex + py * ey + pz * ez) * s->inverse[i];
        const float rest = 1 - 0.5f * (along + fabsf(along));
        const float m = 0.5f * (rest + fabsf(rest)), t = 1 - m;
        const float rx = m * px + t * qx, ry = m * py + t * qy, rz = m * pz + t * qz;
        feet[i] = rx * rx + ry * ry + rz * rz;
        ends[i] = qx * qx + qy * qy + qz * qz;
    }
    for (i = 0; i < SIL_I_LANES; ++i) /* exactly 0 at q, though t is rounded */
        square[i] = ends[i] < feet[i] ? ends[i] : feet[i];
}

/* The same for endless lines: q is the direction, a unit vector or zero. */
static void sil_i_squares_endless(const sil_i_lanes *s, const float v[3], float square[SIL_I_LANES]) {
    const float x = v[0], y = v[1], z = v[2];
    float result[SIL_I_LANES]; /* of its own, so that compilers know that it is no part of s */
    size_t i;
    for (i = 0; i < SIL_I_LANES; ++i) {
        const float px = s->px[i] - x, py = s->py[i] - y, pz = s->pz[i] - z;
        const float t = px * s->qx[i] + py * s->qy[i] + pz * s->qz[i];
        const float rx = px - t * s->qx[i], ry = py - t * s->qy[i], rz = pz - t * s->qz[i];
        result[i] = rx * rx + ry * ry + rz * rz;
    }
    memcpy(square, result, sizeof result);
}

/* The least of `count` numbers, a multiple of 8. */
static float sil_i_least(const float *square, size_t count) {
    float lane[SIL_I_LANES];
    size_t i, k;
    memcpy(lane, square, sizeof lane);
    for (i = SIL_I_LANES; i < count; i += SIL_I_LANES)
        for (k = 0; k < SIL_I_LANES; ++k)
            lane[k] = square[i + k] < lane[k] ? square[i + k] : lane[k];
    for (k = 1; k < SIL_I_LANES; ++k)
        lane[0] = lane[k] < lane[0] ? lane[k] : lane[0];
    return lane[0];
}

/* Takes what a block improves at one vertex. `held` is the nearest edge so far, in the caller's array. */
static void sil_i_improve(const sil_i_segments *s, const sil_edge *edges, const float square[SIL_I_BLOCK], float *best,
                          uint32_t *held) {
    const float least = sil_i_least(square, SIL_I_BLOCK);
    size_t i;
    if (least > *best)
        return;
    if (held)
        for (i = 0; i < s->count; ++i)
            if (square[i] <= least &&
                (*held == SIL_NONE || least < *best || edges[s->index[i]].edge < edges[*held].edge)) {
                *held = s->index[i];
                *best = least;
            }
    *best = least;
}

static void sil_i_try_block(const sil_i_segments *s, const sil_edge *edges, const float v[3], float *best,
                            uint32_t *held) {
    float square[SIL_I_BLOCK];
    size_t i;
    if (sil_i_out_of_reach(s, v, *best))
        return;
    for (i = 0; i < SIL_I_BLOCK / SIL_I_LANES; ++i)
        if (s->endless)
            sil_i_squares_endless(&s->lanes[i], v, square + i * SIL_I_LANES);
        else
            sil_i_squares(&s->lanes[i], v, square + i * SIL_I_LANES);
    sil_i_improve(s, edges, square, best, held);
}

SIL_DEF sil_result sil_distances(const sil_mesh *mesh, const sil_pose *pose, const sil_edge *edges, size_t edge_count,
                                 const sil_distance_desc *desc, size_t first_vertex, size_t vertex_count,
                                 float *distances, uint32_t *nearest) {
    sil_i_frame frame;
    sil_i_segments segments;
    float v[3];
    size_t i, next = 0;
    if (!mesh || (pose && pose->mesh != mesh) || (!edges && edge_count) || edge_count >= SIL_NONE ||
        first_vertex > mesh->vertex_count || vertex_count > mesh->vertex_count - first_vertex ||
        (!distances && vertex_count) ||
        !sil_i_frame_make(&frame, sil_i_shape_of(mesh, pose), desc ? desc->model : NULL))
        return SIL_INVALID_ARGUMENT;
    segments.endless = desc && desc->flags & SIL_DISTANCE_INFINITE_LINE;
    for (i = 0; i < vertex_count; ++i) {
        distances[i] = sil_i_infinity();
        if (nearest)
            nearest[i] = SIL_NONE;
    }
    while (next < edge_count) {
        sil_i_load_segments(mesh, &frame, edges, edge_count, &next, &segments);
        for (i = 0; i < vertex_count && segments.count; ++i) {
            const size_t vertex = mesh->welded[first_vertex + i];
            if (frame.shape->bad[vertex])
                continue;
            (void)sil_i_point(&frame, frame.shape->position + 3 * vertex, v);
            sil_i_try_block(&segments, edges, v, &distances[i], nearest ? &nearest[i] : NULL);
        }
    }
    for (i = 0; i < vertex_count; ++i)
        if (sil_i_finite(distances[i])) {
            const float *p = frame.shape->position + 3 * (size_t)mesh->welded[first_vertex + i];
            distances[i] = sil_i_unscaled(&frame, distances[i], sil_i_point(&frame, p, v));
        }
    return SIL_OK;
}

/* ---- distances by a tree ---- */

/* Eight boxes, as middles and half sizes. */
typedef struct sil_i_boxes {
    float mid[3][SIL_I_LANES], half[3][SIL_I_LANES];
} sil_i_boxes;

#define SIL_I_CHUNK 1024u    /* points that are put in an order of their own at a time */
#define SIL_I_GROUP 32u      /* points that are looked for together */
#define SIL_I_FEW 8u         /* of these, points that share a shorter list of leaves */
#define SIL_I_CANDIDATES 24u /* most leaves that may hold the nearest segment of some point of a group */

/* Segments in the order of a space-filling curve, eight a leaf, and boxes around each eight leaves, each eight of these,
   and so on. Child k of box group i of a level is group or leaf 8 * i + k of the level below. */
struct sil_edge_tree {
    const sil_mesh *mesh;
    sil_i_frame frame;
    int built;
    size_t capacity; /* edges */
    size_t bytes;
    void *memory;                 /* what follows is in it */
    uint64_t *keys;               /* place on the curve << 32 | index in the caller's array */
    sil_i_lanes *leaf;            /* the last one repeats its last segment */
    uint32_t *index, *edge;       /* of each lane: in the caller's array, and that edge's index */
    sil_i_boxes *box;             /* level 1 first */
    size_t first[SIL_I_LEVELS];   /* of each level in box; level 0 is the leaves */
    size_t leaf_count, box_count; /* box_count: of the level made last */
    unsigned levels;              /* the level of the one topmost group; 0: no edges */
};

SIL_DEF sil_edge_tree *sil_edge_tree_create(const sil_mesh *mesh, sil_result *result) {
    sil_edge_tree *tree = NULL;
    sil_result code = mesh ? SIL_OK : SIL_INVALID_ARGUMENT;
    if (mesh) {
        tree = (sil_edge_tree *)mesh->allocator.alloc_fn(sizeof *tree, mesh->allocator.user);
        if (tree) {
            memset(tree, 0, sizeof *tree);
            tree->mesh = mesh;
            tree->bytes = sizeof *tree;
        } else
            code = SIL_OUT_OF_MEMORY;
    }
    if (result)
        *result = code;
    return tree;
}

SIL_DEF void sil_edge_tree_destroy(sil_edge_tree *tree) {
    if (!tree)
        return;
    sil_i_give(&tree->mesh->allocator, tree->memory);
    sil_i_give(&tree->mesh->allocator, tree);
}

static sil_result sil_i_tree_room(sil_edge_tree *tree, size_t edge_count) {
    size_t leaves, boxes, lanes;
    size_t size;
    char *memory;
    if (tree->memory && edge_count <= tree->capacity)
        return SIL_OK;
    if (edge_count > (size_t)-1 / 128)
        return SIL_OUT_OF_MEMORY;
    leaves = edge_count / SIL_I_LANES + 1;
    lanes = leaves * SIL_I_LANES;
    boxes = leaves / 7 + SIL_I_LEVELS;
    size =
        lanes * (sizeof(uint64_t) + 2 * sizeof(uint32_t)) + leaves * sizeof(sil_i_lanes) + boxes * sizeof(sil_i_boxes);
    memory = (char *)tree->mesh->allocator.alloc_fn(size, tree->mesh->allocator.user);
    if (!memory)
        return SIL_OUT_OF_MEMORY;
    sil_i_give(&tree->mesh->allocator, tree->memory);
    tree->built = 0;
    tree->capacity = edge_count;
    tree->bytes = sizeof *tree + size;
    tree->memory = memory;
    tree->keys = (uint64_t *)(void *)memory;
    tree->index = (uint32_t *)(void *)(tree->keys + lanes);
    tree->edge = tree->index + lanes;
    tree->leaf = (sil_i_lanes *)(void *)(tree->edge + lanes);
    tree->box = (sil_i_boxes *)(void *)(tree->leaf + leaves);
    return SIL_OK;
}

SIL_DEF sil_result sil_edge_tree_reserve(sil_edge_tree *tree, size_t edge_count) {
    if (!tree)
        return SIL_INVALID_ARGUMENT;
    return sil_i_tree_room(tree, edge_count > tree->mesh->edge_count ? tree->mesh->edge_count : edge_count);
}

SIL_DEF size_t sil_edge_tree_bytes(const sil_edge_tree *tree) {
    return tree ? tree->bytes : 0;
}

/* The place of an edge's middle on a curve through cubes within cubes. */
static uint32_t sil_i_curve(const sil_i_frame *frame, const uint32_t vertex[2]) {
    double p[3], q[3];
    uint32_t code = 0;
    int k;
    sil_i_to_frame(frame, frame->shape->position + 3 * (size_t)vertex[0], p);
    sil_i_to_frame(frame, frame->shape->position + 3 * (size_t)vertex[1], q);
    for (k = 0; k < 3; ++k) {
        const double at = (0.5 * (p[k] + q[k]) + 0.5) * 1023; /* within [-0.5, 0.5] */
        code |= sil_i_spread_bits((uint32_t)(at < 0 ? 0 : at > 1023 ? 1023 : at)) << k;
    }
    return code;
}

/* Box k of the group `at`, around low .. high. Half sizes are rounded up. */
static void sil_i_set_box(sil_i_boxes *at, size_t k, const float low[3], const float high[3]) {
    int i;
    for (i = 0; i < 3; ++i) {
        const float mid = 0.5f * (low[i] + high[i]);
        const float half = high[i] - mid > mid - low[i] ? high[i] - mid : mid - low[i];
        at->mid[i][k] = mid;
        at->half[i][k] = half * 1.000001f + 1e-30f;
    }
}

/* The level above one of `count` leaves or groups. Places without a child have a box that no search reaches. */
static void sil_i_tree_level(sil_edge_tree *tree, size_t count) {
    const unsigned level = tree->levels;
    const float nowhere[3] = {1e18f, 1e18f, 1e18f};
    size_t i, k, j;
    tree->first[level + 1] = level ? tree->first[level] + tree->box_count : 0;
    tree->box_count = (count + SIL_I_LANES - 1) / SIL_I_LANES;
    for (i = 0; i < tree->box_count * SIL_I_LANES; ++i) {
        sil_i_boxes *at = &tree->box[tree->first[level + 1] + i / SIL_I_LANES];
        float low[3], high[3];
        if (i >= count) {
            sil_i_set_box(at, i % SIL_I_LANES, nowhere, nowhere);
            continue;
        }
        if (level == 0)
            sil_i_bound_lanes(&tree->leaf[i], low, high, 0);
        for (k = 0; k < 3 && level; ++k) {
            const sil_i_boxes *child = &tree->box[tree->first[level] + i];
            low[k] = 1e18f;
            high[k] = -1e18f;
            for (j = 0; j < SIL_I_LANES && child->mid[k][j] < 1e17f; ++j) {
                const float less = child->mid[k][j] - child->half[k][j], more = child->mid[k][j] + child->half[k][j];
                low[k] = less < low[k] ? less : low[k];
                high[k] = more > high[k] ? more : high[k];
            }
        }
        sil_i_set_box(at, i % SIL_I_LANES, low, high);
    }
    ++tree->levels;
}

SIL_DEF sil_result sil_edge_tree_build(sil_edge_tree *tree, const sil_pose *pose, const sil_edge *edges,
                                       size_t edge_count, const sil_distance_desc *desc) {
    const sil_mesh *mesh = tree ? tree->mesh : NULL;
    size_t i, count = 0, known = 0, n = 0;
    if (!tree)
        return SIL_INVALID_ARGUMENT;
    tree->built = 0;
    if ((pose && pose->mesh != mesh) || (!edges && edge_count) || edge_count >= SIL_NONE ||
        (desc && desc->flags & SIL_DISTANCE_INFINITE_LINE) ||
        !sil_i_frame_make(&tree->frame, sil_i_shape_of(mesh, pose), desc ? desc->model : NULL))
        return SIL_INVALID_ARGUMENT;
    for (i = 0; i < edge_count; ++i)
        known += edges[i].edge < mesh->edge_count;
    if (sil_i_tree_room(tree, known) != SIL_OK)
        return SIL_OUT_OF_MEMORY;
    for (i = 0; i < edge_count; ++i)
        if (edges[i].edge < mesh->edge_count)
            tree->keys[count++] =
                (uint64_t)sil_i_curve(&tree->frame, mesh->edge_vertex + 2 * (size_t)edges[i].edge) << 32 | i;
    sil_i_sort_keys(tree->keys, count);
    for (i = 0; i < count; ++i) {
        const uint32_t index = (uint32_t)(tree->keys[i] & 0xffffffffu), edge = edges[index].edge;
        if (!sil_i_load_lane(mesh, &tree->frame, edge, 0, &tree->leaf[n / SIL_I_LANES], n % SIL_I_LANES))
            continue;
        tree->index[n] = index;
        tree->edge[n++] = edge;
    }
    for (; n % SIL_I_LANES; ++n) {
        sil_i_copy_lane(&tree->leaf[n / SIL_I_LANES], (n - 1) % SIL_I_LANES, &tree->leaf[n / SIL_I_LANES],
                        n % SIL_I_LANES);
        tree->index[n] = tree->index[n - 1];
        tree->edge[n] = tree->edge[n - 1];
    }
    tree->leaf_count = n / SIL_I_LANES;
    tree->levels = 0;
    if (n)
        sil_i_tree_level(tree, tree->leaf_count);
    while (n && tree->box_count > 1)
        sil_i_tree_level(tree, tree->box_count);
    tree->built = 1;
    return SIL_OK;
}

/* A leaf (level 0) or group to be looked at, and the square of its box's distance. */
typedef struct sil_i_visit {
    float square;
    uint32_t at;
    unsigned level;
} sil_i_visit;

/* Puts the children within reach on the stack, the nearest on top. */
static size_t sil_i_push_children(const sil_edge_tree *tree, sil_i_visit parent, const float v[3], float reach,
                                  sil_i_visit *stack, size_t top) {
    const sil_i_boxes *box = &tree->box[tree->first[parent.level] + parent.at];
    const float x = v[0], y = v[1], z = v[2];
    const size_t bottom = top;
    float square[SIL_I_LANES];
    size_t i, j;
    for (i = 0; i < SIL_I_LANES; ++i) {
        const float dx = fabsf(x - box->mid[0][i]) - box->half[0][i], ox = 0.5f * (dx + fabsf(dx));
        const float dy = fabsf(y - box->mid[1][i]) - box->half[1][i], oy = 0.5f * (dy + fabsf(dy));
        const float dz = fabsf(z - box->mid[2][i]) - box->half[2][i], oz = 0.5f * (dz + fabsf(dz));
        square[i] = ox * ox + oy * oy + oz * oz;
    }
    for (i = 0; i < SIL_I_LANES; ++i) {
        if (square[i] > reach)
            continue;
        for (j = top++; j > bottom && stack[j - 1].square < square[i]; --j)
            stack[j] = stack[j - 1];
        stack[j].square = square[i];
        stack[j].at = (uint32_t)(parent.at * SIL_I_LANES + i);
        stack[j].level = parent.level - 1;
    }
    return top;
}

/* The leaves that may hold the nearest segment of some point within `radius` of v. */
typedef struct sil_i_near {
    float v[3], radius;
    float least; /* square of the distance of v to the nearest segment */
    float reach; /* squares above this are out of reach: (distance to the nearest + 2 * radius)^2 and a margin that is
                    more than the rounding of a distance, as in sil_i_out_of_reach */
    size_t count;
    uint32_t leaf[SIL_I_CANDIDATES];
    float square[SIL_I_CANDIDATES]; /* least of each leaf */
} sil_i_near;

static void sil_i_near_start(sil_i_near *found) {
    found->least = found->reach = 3e38f;
    found->count = 0;
}

/* A leaf, if it is within reach. Returns 0 where there is no room for it. */
static int sil_i_near_add(const sil_edge_tree *tree, sil_i_near *found, uint32_t leaf) {
    float square[SIL_I_LANES], least;
    sil_i_squares(&tree->leaf[leaf], found->v, square);
    least = sil_i_least(square, SIL_I_LANES);
    if (least > found->reach)
        return 1;
    if (found->count == SIL_I_CANDIDATES)
        return 0;
    found->leaf[found->count] = leaf;
    found->square[found->count++] = least;
    if (least < found->least) {
        const float reach = sqrtf(least) + 2 * found->radius;
        found->least = least;
        found->reach = reach * reach * 1.001f + 1e-7f;
    }
    return 1;
}

/* Leaves that were taken before the nearest was known. */
static void sil_i_near_sift(sil_i_near *found) {
    size_t i, kept = 0;
    for (i = 0; i < found->count; ++i)
        if (found->square[i] <= found->reach) {
            found->square[kept] = found->square[i];
            found->leaf[kept++] = found->leaf[i];
        }
    found->count = kept;
}

/* Fills *found from its v and radius, beginning with a leaf that is likely to be close. 0: there are too many. */
static int sil_i_collect(const sil_edge_tree *tree, uint32_t first, sil_i_near *found) {
    sil_i_visit stack[(SIL_I_LANES - 1) * SIL_I_LEVELS + 1];
    size_t top = 1;
    sil_i_near_start(found);
    (void)sil_i_near_add(tree, found, first);
    stack[0].square = 0;
    stack[0].at = 0;
    stack[0].level = tree->levels;
    while (top) {
        const sil_i_visit visit = stack[--top];
        if (visit.square > found->reach)
            continue;
        if (visit.level)
            top = sil_i_push_children(tree, visit, found->v, found->reach, stack, top);
        else if (visit.at != first && !sil_i_near_add(tree, found, visit.at))
            return 0;
    }
    sil_i_near_sift(found);
    return 1;
}

/* Points that are looked for at a time: where, and which of the caller's, in any order. */
typedef struct sil_i_points {
    float v[SIL_I_CHUNK][3];
    double grow[SIL_I_CHUNK];
    size_t first; /* of the caller's */
    uint16_t order[SIL_I_CHUNK], spare[SIL_I_CHUNK], code[SIL_I_CHUNK];
    size_t count;
} sil_i_points;

/* Is this place's edge first among those at the same distance? */
static int sil_i_is_first(const sil_edge_tree *tree, size_t place, size_t held) {
    return tree->edge[place] < tree->edge[held] ||
           (tree->edge[place] == tree->edge[held] && tree->index[place] < tree->index[held]);
}

/* Takes what one leaf improves at a point; *best is 3e38 before the first. */
static void sil_i_improve_by_leaf(const sil_edge_tree *tree, uint32_t leaf, const float v[3], float *best,
                                  size_t *held) {
    float square[SIL_I_LANES];
    const size_t first = (size_t)leaf * SIL_I_LANES;
    const float bound = *best;
    int any = 0;
    size_t i;
    sil_i_squares(&tree->leaf[leaf], v, square);
    for (i = 0; i < SIL_I_LANES; ++i)
        any |= square[i] <= bound;
    if (!any)
        return;
    for (i = 0; i < SIL_I_LANES; ++i)
        if (square[i] < *best || (square[i] <= *best && sil_i_is_first(tree, first + i, *held))) {
            *best = square[i];
            *held = first + i;
        }
}

/* The nearest segment of one point, by the tree alone; from the place *held on. */
static float sil_i_search(const sil_edge_tree *tree, const float v[3], size_t *held) {
    sil_i_visit stack[(SIL_I_LANES - 1) * SIL_I_LEVELS + 1];
    float best = 3e38f;
    const uint32_t first = (uint32_t)(*held / SIL_I_LANES);
    size_t top = 1;
    sil_i_improve_by_leaf(tree, first, v, &best, held);
    stack[0].square = 0;
    stack[0].at = 0;
    stack[0].level = tree->levels;
    while (top) {
        const sil_i_visit visit = stack[--top];
        const float reach = best * 1.001f + 1e-7f;
        if (visit.square > reach)
            continue;
        if (visit.level)
            top = sil_i_push_children(tree, visit, v, reach, stack, top);
        else if (visit.at != first)
            sil_i_improve_by_leaf(tree, visit.at, v, &best, held);
    }
    return best;
}

static void sil_i_answer(const sil_edge_tree *tree, const sil_i_points *points, size_t i, float square, size_t place,
                         float *distances, uint32_t *nearest) {
    const size_t slot = points->first + points->order[i];
    distances[slot] = sil_i_unscaled(&tree->frame, square, points->grow[points->order[i]]);
    if (nearest)
        nearest[slot] = tree->index[place];
}

/* The box of points first .. end - 1 in their order. */
static void sil_i_points_box(const sil_i_points *points, size_t first, size_t end, float low[3], float high[3]) {
    size_t i;
    int k;
    for (k = 0; k < 3; ++k) {
        low[k] = high[k] = points->v[points->order[first]][k];
        for (i = first + 1; i < end; ++i) {
            const float x = points->v[points->order[i]][k];
            low[k] = x < low[k] ? x : low[k];
            high[k] = x > high[k] ? x : high[k];
        }
    }
}

/* Puts points in the order of a space-filling curve, of 32 places each way through their box: by counting, twice. */
static void sil_i_points_sort(sil_i_points *points) {
    float low[3], high[3], scale[3];
    uint16_t starts[256];
    size_t i;
    int k, pass;
    sil_i_points_box(points, 0, points->count, low, high);
    /* Coordinates are about 1 here. What is flat to within nothing has no places: its quotient would be infinite. */
    for (k = 0; k < 3; ++k)
        scale[k] = high[k] - low[k] > 1e-30f ? 31.9f / (high[k] - low[k]) : 0;
    for (i = 0; i < points->count; ++i) {
        uint32_t code = 0;
        for (k = 0; k < 3; ++k)
            code |= sil_i_spread_bits((uint32_t)((points->v[points->order[i]][k] - low[k]) * scale[k]) & 31u) << k;
        points->code[points->order[i]] = (uint16_t)code;
    }
    for (pass = 0; pass < 2; ++pass) {
        const uint16_t *from = pass ? points->spare : points->order;
        uint16_t *to = pass ? points->order : points->spare;
        uint16_t sum = 0;
        memset(starts, 0, sizeof starts);
        for (i = 0; i < points->count; ++i)
            ++starts[points->code[from[i]] >> 8 * pass & 255];
        for (i = 0; i < 256; ++i) {
            const uint16_t here = starts[i];
            starts[i] = sum;
            sum = (uint16_t)(sum + here);
        }
        for (i = 0; i < points->count; ++i)
            to[starts[points->code[from[i]] >> 8 * pass & 255]++] = from[i];
    }
}

/* The middle and the radius of points first .. end - 1. */
static void sil_i_near_bound(const sil_i_points *points, size_t first, size_t end, sil_i_near *found) {
    float low[3], high[3], square = 0;
    int k;
    sil_i_points_box(points, first, end, low, high);
    for (k = 0; k < 3; ++k) {
        found->v[k] = 0.5f * (low[k] + high[k]);
        square += 0.25f * (high[k] - low[k]) * (high[k] - low[k]);
    }
    found->radius = sqrtf(square) * 1.001f + 1e-7f;
}

/* Leaves by rising distance from v, which is put in place of its square. */
static void sil_i_near_sort(sil_i_near *found) {
    size_t i, j;
    for (i = 0; i < found->count; ++i) {
        const uint32_t leaf = found->leaf[i];
        const float distance = sqrtf(found->square[i]);
        for (j = i; j > 0 && found->square[j - 1] > distance; --j) {
            found->leaf[j] = found->leaf[j - 1];
            found->square[j] = found->square[j - 1];
        }
        found->leaf[j] = leaf;
        found->square[j] = distance;
    }
}

/* A few points against the leaves found for their group, the nearest to their middle first, as far as a leaf's
   distance from the middle less that of the point from there is not more than the point's best. */
static void sil_i_few(const sil_edge_tree *tree, const sil_i_points *points, size_t first, size_t end,
                      const sil_i_near *found, size_t *held, float *distances, uint32_t *nearest) {
    sil_i_near fewer;
    size_t i, k;
    sil_i_near_bound(points, first, end, &fewer);
    sil_i_near_start(&fewer);
    for (i = 0; i < found->count; ++i)
        (void)sil_i_near_add(tree, &fewer, found->leaf[i]);
    sil_i_near_sift(&fewer);
    sil_i_near_sort(&fewer);
    for (i = first; i < end; ++i) {
        const float *v = points->v[points->order[i]];
        const float x = v[0] - fewer.v[0], y = v[1] - fewer.v[1], z = v[2] - fewer.v[2];
        const float away = sqrtf(x * x + y * y + z * z);
        float best = 3e38f;
        for (k = 0; k < fewer.count; ++k) {
            const float apart = fewer.square[k] * 0.99999f - away * 1.00001f; /* both are rounded, and may be large */
            if (apart > 0 && apart * apart > best * 1.001f + 1e-7f)
                break;
            sil_i_improve_by_leaf(tree, fewer.leaf[k], v, &best, held);
        }
        sil_i_answer(tree, points, i, best, *held, distances, nearest);
    }
}

/* Points first .. end - 1 together if they are close to each other, else in halves, else one by one. *held: the place
   of the nearest segment of the point before. */
static void sil_i_group(const sil_edge_tree *tree, const sil_i_points *points, size_t first, size_t end, size_t *held,
                        float *distances, uint32_t *nearest) {
    sil_i_near found;
    size_t i;
    if (end - first <= SIL_I_FEW / 2) {
        for (i = first; i < end; ++i) {
            const float square = sil_i_search(tree, points->v[points->order[i]], held);
            sil_i_answer(tree, points, i, square, *held, distances, nearest);
        }
        return;
    }
    sil_i_near_bound(points, first, end, &found);
    if (sil_i_collect(tree, (uint32_t)(*held / SIL_I_LANES), &found)) {
        for (i = first; i < end; i += SIL_I_FEW)
            sil_i_few(tree, points, i, i + SIL_I_FEW < end ? i + SIL_I_FEW : end, &found, held, distances, nearest);
        return;
    }
    sil_i_group(tree, points, first, first + (end - first) / 2, held, distances, nearest);
    sil_i_group(tree, points, first + (end - first) / 2, end, held, distances, nearest);
}

/* The next points of the caller's (vertex NULL) or of the mesh; those that have no distance are answered at once. */
static void sil_i_take_points(const sil_edge_tree *tree, const char *given, size_t stride, const uint32_t *vertex,
                              size_t end, sil_i_points *points, float *distances, uint32_t *nearest) {
    size_t i;
    points->count = 0;
    for (i = points->first; i < end; ++i) {
        const uint16_t at = (uint16_t)(i - points->first);
        float p[3];
        memcpy(p, given + (vertex ? vertex[i] : i) * stride, sizeof p); /* strides may leave floats unaligned */
        if (!tree->levels || !sil_i_all_finite(p, 3) || (vertex && tree->frame.shape->bad[vertex[i]])) {
            distances[i] = sil_i_infinity();
            if (nearest)
                nearest[i] = SIL_NONE;
            continue;
        }
        points->grow[at] = sil_i_point(&tree->frame, p, points->v[at]);
        points->order[points->count++] = at;
    }
}

static void sil_i_ask(const sil_edge_tree *tree, const char *given, size_t stride, const uint32_t *vertex, size_t count,
                      float *distances, uint32_t *nearest) {
    sil_i_points points;
    size_t i, held = 0;
    for (points.first = 0; points.first < count; points.first += SIL_I_CHUNK) {
        const size_t left = count - points.first, end = points.first + (left < SIL_I_CHUNK ? left : SIL_I_CHUNK);
        sil_i_take_points(tree, given, stride, vertex, end, &points, distances, nearest);
        if (points.count)
            sil_i_points_sort(&points);
        for (i = 0; i < points.count; i += SIL_I_GROUP)
            sil_i_group(tree, &points, i, i + SIL_I_GROUP < points.count ? i + SIL_I_GROUP : points.count, &held,
                        distances, nearest);
    }
}

SIL_DEF sil_result sil_distances_by_tree(const sil_edge_tree *tree, size_t first_vertex, size_t vertex_count,
                                         float *distances, uint32_t *nearest) {
    if (!tree || !tree->built || first_vertex > tree->mesh->vertex_count ||
        vertex_count > tree->mesh->vertex_count - first_vertex || (!distances && vertex_count))
        return SIL_INVALID_ARGUMENT;
    sil_i_ask(tree, (const char *)(const void *)tree->frame.shape->position, 3 * sizeof(float),
              tree->mesh->welded + first_vertex, vertex_count, distances, nearest);
    return SIL_OK;
}

SIL_DEF sil_result sil_distances_at(const sil_edge_tree *tree, const float *points, size_t stride, size_t count,
                                    float *distances, uint32_t *nearest) {
    if (!tree || !tree->built || (count && (!points || !distances)) || (stride && stride < 3 * sizeof(float)))
        return SIL_INVALID_ARGUMENT;
    sil_i_ask(tree, (const char *)(const void *)points, stride ? stride : 3 * sizeof(float), NULL, count, distances,
              nearest);
    return SIL_OK;
}

SIL_DEF float sil_max_distance(const sil_mesh *mesh, const sil_pose *pose, const float model[9]) {
    sil_i_frame frame;
    double largest = 0;
    size_t i;
    if (!mesh || (pose && pose->mesh != mesh) || !sil_i_frame_make(&frame, sil_i_shape_of(mesh, pose), model))
        return 0;
    for (i = 0; i < mesh->unique_count; ++i) {
        double p[3];
        if (!mesh->referenced[i] || frame.shape->bad[i])
            continue;
        sil_i_to_frame(&frame, frame.shape->position + 3 * i, p);
        largest = sil_i_larger(largest, p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    }
    return (float)(sqrt(largest) * frame.scale);
}

/* ---- candidates of triangles ---- */

SIL_DEF size_t sil_edge_tree_order(const sil_edge_tree *tree, uint32_t *order, size_t capacity) {
    const size_t places = tree && tree->built ? tree->leaf_count * SIL_I_LANES : 0;
    size_t i, count = 0;
    for (i = 0; i < places; ++i) {
        if (i && tree->index[i] == tree->index[i - 1])
            break; /* the last leaf repeats its last segment */
        if (order && count < capacity)
            order[count] = tree->index[i];
        ++count;
    }
    return count;
}

/* d^2(x), the square of the distance of a point x to a segment (or to a box), is convex in x, for both are convex sets.
   Within a triangle it lies therefore
   - below the plane through its values at the corners,
   - above its tangent plane at any point: with f the foot of the middle c, d^2(c) + 2 (c - f) . (x - c).
   Where the first of one segment is below the second of another at all three corners, it is so in all of the triangle,
   and the other is nowhere the nearest. Only the square of the triangle's size is lost by this, where a test by the
   middle's distance and the radius loses the size itself: far from a dense outline that keeps a few edges instead of
   a stretch that grows with the root of the distance. */
typedef struct sil_i_facet {
    float middle[3], corner[3][3]; /* in the tree's frame */
    float margin;                  /* more than the rounding of a square, corners' and segments' coordinates included */
    float high[3];                 /* squares at the corners of the segment nearest to the middle, and the margin */
} sil_i_facet;

#define SIL_I_SUITORS 64u /* candidates that are compared with each other */

typedef struct sil_i_suitors {
    uint32_t index[SIL_I_SUITORS];
    float low[SIL_I_SUITORS][3], high[SIL_I_SUITORS][3]; /* tangent at the corners; squares there and the margin */
    size_t count;
} sil_i_suitors;

typedef struct sil_i_listing {
    uint32_t *out;
    size_t capacity, count;
} sil_i_listing;

static float sil_i_larger_float(float a, float b) {
    return a > b ? a : b;
}

/* The tangent planes at the middle, at the three corners, of eight segments. */
static void sil_i_tangents(const sil_i_lanes *s, const sil_i_facet *facet, float low[3][SIL_I_LANES]) {
    const float x = facet->middle[0], y = facet->middle[1], z = facet->middle[2];
    size_t i;
    int k;
    for (i = 0; i < SIL_I_LANES; ++i) {
        const float px = s->px[i] - x, py = s->py[i] - y, pz = s->pz[i] - z;
        const float ex = s->qx[i] - s->px[i], ey = s->qy[i] - s->py[i], ez = s->qz[i] - s->pz[i];
        const float along = -(px * ex + py * ey + pz * ez) * s->inverse[i];
        const float above = 0.5f * (along + fabsf(along)), rest = 1 - above;
        const float t = 1 - 0.5f * (rest + fabsf(rest)); /* within 0 and 1, without a branch: see sil_i_squares */
        const float fx = px + t * ex, fy = py + t * ey, fz = pz + t * ez;
        for (k = 0; k < 3; ++k) {
            const float *c = facet->corner[k];
            low[k][i] = fx * (fx - 2 * (c[0] - x)) + fy * (fy - 2 * (c[1] - y)) + fz * (fz - 2 * (c[2] - z));
        }
    }
}

/* The same of one of eight boxes: its foot is the middle, moved into it. */
static int sil_i_box_is_beaten(const sil_i_boxes *box, size_t i, const sil_i_facet *facet) {
    float foot[3];
    int k;
    for (k = 0; k < 3; ++k) {
        const float d = box->mid[k][i] - facet->middle[k], half = box->half[k][i];
        foot[k] = d > half ? d - half : d < -half ? d + half : 0;
    }
    for (k = 0; k < 3; ++k) {
        const float *c = facet->corner[k];
        const float low = foot[0] * (foot[0] - 2 * (c[0] - facet->middle[0])) +
                          foot[1] * (foot[1] - 2 * (c[1] - facet->middle[1])) +
                          foot[2] * (foot[2] - 2 * (c[2] - facet->middle[2]));
        if (!(low > facet->high[k]))
            return 0;
    }
    return 1;
}

/* Leaves out the segments that another one beats. Two never beat each other: low is at most high less the margin. */
static void sil_i_suitors_sift(sil_i_suitors *s) {
    unsigned char beaten[SIL_I_SUITORS];
    size_t i, j, kept = 0;
    for (i = 0; i < s->count; ++i) {
        beaten[i] = 0;
        for (j = 0; j < s->count && !beaten[i]; ++j)
            beaten[i] = s->low[i][0] > s->high[j][0] && s->low[i][1] > s->high[j][1] && s->low[i][2] > s->high[j][2];
    }
    for (i = 0; i < s->count; ++i)
        if (!beaten[i]) {
            s->index[kept] = s->index[i];
            memcpy(s->low[kept], s->low[i], sizeof s->low[0]);
            memcpy(s->high[kept++], s->high[i], sizeof s->high[0]);
        }
    s->count = kept;
}

static void sil_i_suitors_list(sil_i_suitors *s, sil_i_listing *list) {
    size_t i;
    sil_i_suitors_sift(s);
    for (i = 0; i < s->count; ++i, ++list->count)
        if (list->count < list->capacity)
            list->out[list->count] = s->index[i];
    s->count = 0;
}

/* The segments of a leaf that the one nearest to the middle does not beat. */
static void sil_i_leaf_suitors(const sil_edge_tree *tree, const sil_i_facet *facet, uint32_t leaf, sil_i_suitors *s,
                               sil_i_listing *list) {
    float low[3][SIL_I_LANES], square[3][SIL_I_LANES];
    const size_t first = (size_t)leaf * SIL_I_LANES;
    size_t i;
    int k, any = 0;
    sil_i_tangents(&tree->leaf[leaf], facet, low);
    for (i = 0; i < SIL_I_LANES; ++i)
        any |= !(low[0][i] > facet->high[0] && low[1][i] > facet->high[1] && low[2][i] > facet->high[2]);
    for (k = 0; k < 3 && any; ++k)
        sil_i_squares(&tree->leaf[leaf], facet->corner[k], square[k]);
    for (i = 0; i < SIL_I_LANES && any; ++i) {
        if (low[0][i] > facet->high[0] && low[1][i] > facet->high[1] && low[2][i] > facet->high[2])
            continue;
        if (i && tree->index[first + i] == tree->index[first + i - 1])
            break; /* the last leaf repeats its last segment */
        if (s->count == SIL_I_SUITORS)
            sil_i_suitors_list(s, list);
        s->index[s->count] = tree->index[first + i];
        for (k = 0; k < 3; ++k) {
            s->low[s->count][k] = low[k][i];
            s->high[s->count][k] = square[k][i] + facet->margin;
        }
        ++s->count;
    }
}

/* *held: the place of a segment that is likely to be near; then that of the one nearest to the middle. */
static void sil_i_facet_start(const sil_edge_tree *tree, sil_i_facet *facet, size_t *held) {
    float square[3][SIL_I_LANES], farthest = sil_i_search(tree, facet->middle, held), extent = 1, radius = 0;
    int k, i;
    for (k = 0; k < 3; ++k) {
        float reach = 0;
        sil_i_squares(&tree->leaf[*held / SIL_I_LANES], facet->corner[k], square[k]);
        farthest = sil_i_larger_float(farthest, square[k][*held % SIL_I_LANES]);
        for (i = 0; i < 3; ++i) {
            const float d = facet->corner[k][i] - facet->middle[i];
            extent = sil_i_larger_float(extent, fabsf(facet->corner[k][i]));
            reach += d * d;
        }
        radius = sil_i_larger_float(radius, reach);
    }
    facet->margin = 2e-6f * extent * (sqrtf(radius) + sqrtf(farthest)) + 1e-30f;
    for (k = 0; k < 3; ++k)
        facet->high[k] = square[k][*held % SIL_I_LANES] + facet->margin;
}

static void sil_i_facet_list(const sil_edge_tree *tree, sil_i_facet *facet, sil_i_listing *list) {
    sil_i_visit stack[(SIL_I_LANES - 1) * SIL_I_LEVELS + 1];
    sil_i_suitors suitors;
    size_t top = 1, i;
    suitors.count = 0;
    stack[0].at = 0;
    stack[0].level = tree->levels;
    while (top) {
        const sil_i_visit visit = stack[--top];
        if (!visit.level) {
            sil_i_leaf_suitors(tree, facet, visit.at, &suitors, list);
            continue;
        }
        for (i = SIL_I_LANES; i--;) { /* the first child on top */
            const sil_i_boxes *box = &tree->box[tree->first[visit.level] + visit.at];
            if (!(box->mid[0][i] < 1e17f) || sil_i_box_is_beaten(box, i, facet))
                continue;
            stack[top].at = (uint32_t)(visit.at * SIL_I_LANES + i);
            stack[top++].level = visit.level - 1;
        }
    }
    sil_i_suitors_list(&suitors, list);
}

/* Takes a triangle's corners; 0 where one is missing. *everything: one is so far away that it was brought nearer. */
static int sil_i_facet_take(const sil_edge_tree *tree, const char *positions, size_t stride, size_t vertex_count,
                            const uint32_t *indices, size_t triangle, sil_i_facet *facet, int *everything) {
    int k, i;
    *everything = 0;
    for (k = 0; k < 3; ++k) {
        const size_t at = 3 * triangle + (size_t)k, vertex = indices ? indices[at] : at;
        float p[3];
        if (vertex >= vertex_count)
            return 0;
        memcpy(p, positions + vertex * stride, sizeof p);
        if (!sil_i_all_finite(p, 3))
            return 0;
        *everything |= sil_i_point(&tree->frame, p, facet->corner[k]) > 1;
    }
    for (i = 0; i < 3; ++i)
        facet->middle[i] = (facet->corner[0][i] + facet->corner[1][i] + facet->corner[2][i]) * (1 / 3.0f);
    return 1;
}

SIL_DEF sil_result sil_candidates(const sil_edge_tree *tree, const float *positions, size_t stride, size_t vertex_count,
                                  const uint32_t *indices, size_t triangle_count, uint32_t *offsets,
                                  uint32_t *candidates, size_t capacity, size_t *needed) {
    sil_i_listing list;
    size_t i, held = 0;
    if (!tree || !tree->built || (triangle_count && !positions) || !offsets || (capacity && !candidates) || !needed ||
        (stride && stride < 3 * sizeof(float)))
        return SIL_INVALID_ARGUMENT;
    list.out = candidates;
    list.capacity = capacity;
    list.count = *needed = 0;
    offsets[0] = 0;
    for (i = 0; i < triangle_count; ++i) {
        sil_i_facet facet;
        int everything, k;
        if (tree->levels &&
            sil_i_facet_take(tree, (const char *)(const void *)positions, stride ? stride : 3 * sizeof(float),
                             vertex_count, indices, i, &facet, &everything)) {
            sil_i_facet_start(tree, &facet, &held);
            for (k = 0; k < 3 && everything; ++k)
                facet.high[k] = facet.margin = 3e38f;
            sil_i_facet_list(tree, &facet, &list);
        }
        *needed = list.count;
        if (list.count >= SIL_NONE)
            return SIL_TOO_LARGE;
        offsets[i + 1] = (uint32_t)list.count;
    }
    return SIL_OK;
}

/* ---- ribbons ---- */

#define SIL_I_DASHES 64       /* lengths in a pattern */
#define SIL_I_PERIODS 65536.0 /* of dashes in one segment; more are drawn as a whole line */
#define SIL_I_TURN 1048576.0  /* arc, as it is given out, starts again there */
#define SIL_I_OUTER_STEP 2.0  /* pixels from one look at the image to the next */
#define SIL_I_OUTER_RAMP 8.0  /* pixels in which a line goes from thin to heavy */

/* Where a point is drawn. */
typedef struct sil_i_spot {
    double x, y, depth, slack, arc;
    double along; /* in the dashes */
    double half;  /* of the width */
} sil_i_spot;

/* A vertex of a strip, before anything is cut. */
typedef struct sil_i_stop {
    double clip[4], along, half;
    int known;
} sil_i_stop;

typedef struct sil_i_pen {
    const sil_mesh *mesh; /* NULL: desc->points */
    const sil_i_shape *shape;
    const sil_ribbon_desc *desc;
    double model_view[16], projection[16];
    double width, height;          /* viewport */
    double heavy, thin;            /* factors */
    double light[2];               /* on the screen, of length 1, or its opposite where left and right are exchanged */
    double reach[2];               /* where lines are heavy and thin */
    double low;                    /* clip z >= low * w: -1 or 0 */
    double dash_end[SIL_I_DASHES]; /* pixels from the pattern's begin */
    size_t dash_count;
    const sil_strip *strip;
    const uint32_t *vertices;
    double half;             /* of the strip's width, before the factors of its vertices */
    double step;             /* largest angle of one part of a round cap or join */
    double guard_x, guard_y; /* |clip x| <= guard_x * w */
    double phase, length;    /* of the strip; its length is known where it has a taper */
    double arc;              /* so far along the strip, unclipped */
    double arc_turn;         /* what is taken off an arc that is given out */
    double level;            /* WEIGHT_OUTER: from 0, thin, to 1, heavy; negative: not known yet */
    sil_i_spot last;         /* where the pen is */
    double direction[2];     /* of the segment before */
    double way[2];           /* of the piece that is cut into dashes */
    int down;                /* a segment ended at `last` */
    int started;             /* something of the strip was drawn */
    int dotted;              /* something of it was to be drawn that has no length, at `dot` */
    sil_i_spot dot;
    int joins_start; /* the first segment began uncut in a closed strip: the cap there waits for the end */
    sil_i_spot start;
    double start_direction[2];
    sil_ribbon_vertex *out;
    size_t capacity, count;
} sil_i_pen;

/* One corner: an offset from a spot on the centre line. */
static void sil_i_pen_vertex(sil_i_pen *pen, const sil_i_spot *spot, double dx, double dy, size_t at) {
    sil_ribbon_vertex *v = &pen->out[at];
    v->x = (float)(spot->x + dx);
    v->y = (float)(spot->y + dy);
    v->depth = (float)spot->depth;
    v->slack = (float)spot->slack;
    v->center_x = (float)spot->x;
    v->center_y = (float)spot->y;
    v->arc = (float)sil_i_larger(spot->arc - pen->arc_turn, 0);
    v->kinds = pen->strip->kinds;
}

/* A triangle with corners at three spots, offset by o[0..1], o[2..3], o[4..5]. */
static void sil_i_pen_triangle(sil_i_pen *pen, const sil_i_spot *a, const sil_i_spot *b, const sil_i_spot *c,
                               const double o[6]) {
    if (pen->out && pen->capacity >= 3 && pen->count <= pen->capacity - 3) {
        sil_i_pen_vertex(pen, a, o[0], o[1], pen->count);
        sil_i_pen_vertex(pen, b, o[2], o[3], pen->count + 1);
        sil_i_pen_vertex(pen, c, o[4], o[5], pen->count + 2);
    }
    pen->count += 3;
}

/* A fan about a spot from the offset n by an angle (positive: counter-clockwise), in `parts` parts. */
static void sil_i_pen_fan(sil_i_pen *pen, const sil_i_spot *spot, const double n[2], double angle, int parts) {
    const double cosine = cos(angle / parts), sine = sin(angle / parts);
    double o[6] = {0, 0, 0, 0, 0, 0};
    int i;
    o[2] = n[0];
    o[3] = n[1];
    for (i = 0; i < parts; ++i) {
        o[4] = o[2] * cosine - o[3] * sine;
        o[5] = o[2] * sine + o[3] * cosine;
        sil_i_pen_triangle(pen, spot, spot, spot, o);
        o[2] = o[4];
        o[3] = o[5];
    }
}

static int sil_i_pen_parts(const sil_i_pen *pen, double angle) {
    const double parts = ceil(sil_i_abs(angle) / pen->step);
    return parts < 1 ? 1 : (int)parts;
}

static void sil_i_pen_cap(sil_i_pen *pen, const sil_i_spot *spot, double dx, double dy) {
    const double n[2] = {dy * spot->half, -dx * spot->half}; /* to the right of the way out */
    if (!(spot->half > 0))
        return;
    if (pen->desc->cap == SIL_CAP_ROUND)
        sil_i_pen_fan(pen, spot, n, SIL_I_PI, sil_i_pen_parts(pen, SIL_I_PI));
    if (pen->desc->cap == SIL_CAP_SQUARE) {
        const double x = dx * spot->half, y = dy * spot->half;
        double o[6];
        o[0] = n[0];
        o[1] = n[1];
        o[2] = n[0] + x;
        o[3] = n[1] + y;
        o[4] = x - n[0];
        o[5] = y - n[1];
        sil_i_pen_triangle(pen, spot, spot, spot, o);
        o[2] = o[4];
        o[3] = o[5];
        o[4] = -n[0];
        o[5] = -n[1];
        sil_i_pen_triangle(pen, spot, spot, spot, o);
    }
}

/* The wedge on the outer side of a turn. */
static void sil_i_pen_join(sil_i_pen *pen, const sil_i_spot *spot, const double from[2], const double to[2]) {
    const double cross = from[0] * to[1] - from[1] * to[0], dot = from[0] * to[0] + from[1] * to[1];
    const double angle = atan2(cross, dot), side = angle > 0 ? 1 : -1; /* a line that turns back: either */
    const double n[2] = {side * from[1] * spot->half, -side * from[0] * spot->half};
    if (pen->desc->join == SIL_JOIN_NONE || sil_i_abs(angle) * spot->half < 1e-4)
        return;
    if (pen->desc->join == SIL_JOIN_ROUND)
        sil_i_pen_fan(pen, spot, n, angle, sil_i_pen_parts(pen, angle));
    else {
        double o[6] = {0, 0, 0, 0, 0, 0};
        o[2] = n[0];
        o[3] = n[1];
        o[4] = side * to[1] * spot->half;
        o[5] = -side * to[0] * spot->half;
        sil_i_pen_triangle(pen, spot, spot, spot, o);
    }
}

static void sil_i_pen_quad(sil_i_pen *pen, const sil_i_spot *a, const sil_i_spot *b, const double d[2]) {
    double o[6];
    if (!(a->half > 0 || b->half > 0))
        return;
    o[0] = -d[1] * a->half;
    o[1] = d[0] * a->half;
    o[2] = -o[0];
    o[3] = -o[1];
    o[4] = -d[1] * b->half;
    o[5] = d[0] * b->half;
    sil_i_pen_triangle(pen, a, a, b, o);
    o[0] = o[2];
    o[1] = o[3];
    o[2] = -o[4];
    o[3] = -o[5];
    sil_i_pen_triangle(pen, a, b, b, o);
}

/* Depth per motion of one pixel's size toward the eye. With J the derivative of the place on the screen, in pixels, by
   the place in eye space: its rows' cross product is the direction along which the place does not change, that is the
   way to the eye, and its length is pixels of area per area across that way. */
static double sil_i_slack(const sil_i_pen *pen, const double clip[4]) {
    const double *p = pen->projection;
    const double w = clip[3], scale = pen->low < 0 ? 0.5 : 1;
    double jx[3], jy[3], jz[3], cross[3], area, change = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        jx[k] = 0.5 * pen->width * (p[4 * k] - clip[0] / w * p[4 * k + 3]) / w;
        jy[k] = 0.5 * pen->height * (p[4 * k + 1] - clip[1] / w * p[4 * k + 3]) / w;
        jz[k] = scale * (p[4 * k + 2] - clip[2] / w * p[4 * k + 3]) / w;
    }
    for (k = 0; k < 3; ++k)
        cross[k] = jx[(k + 1) % 3] * jy[(k + 2) % 3] - jx[(k + 2) % 3] * jy[(k + 1) % 3];
    area = sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
    if (!(area > 0))
        return 0;
    for (k = 0; k < 3; ++k)
        change += jz[k] * (cross[k] / area);
    return sil_i_abs(change) / sqrt(area);
}

static void sil_i_screen(const sil_i_pen *pen, const double clip[4], double *x, double *y) {
    *x = 0.5 * pen->width * (clip[0] / clip[3] + 1);
    *y = 0.5 * pen->height * (clip[1] / clip[3] + 1);
}

/* Rounding can leave a cut point outside when a coordinate is many powers of ten larger at the other end. */
static void sil_i_spot_clamp(const sil_i_pen *pen, sil_i_spot *spot) {
    const double x = 0.5 * pen->width * (pen->guard_x - 1), y = 0.5 * pen->height * (pen->guard_y - 1);
    spot->x = spot->x < -x ? -x : spot->x > pen->width + x ? pen->width + x : spot->x;
    spot->y = spot->y < -y ? -y : spot->y > pen->height + y ? pen->height + y : spot->y;
}

static double sil_i_gap(const sil_i_spot *a, const sil_i_spot *b) {
    return sqrt((b->x - a->x) * (b->x - a->x) + (b->y - a->y) * (b->y - a->y));
}

/* The spot of the point at t between two vertices; its arc is not known yet. */
static sil_i_spot sil_i_spot_at(const sil_i_pen *pen, const sil_i_stop *a, const sil_i_stop *b, double t) {
    sil_i_spot spot;
    double clip[4], depth;
    int k;
    for (k = 0; k < 4; ++k)
        clip[k] = sil_i_mix(a->clip[k], b->clip[k], t);
    depth = clip[2] / clip[3];
    sil_i_screen(pen, clip, &spot.x, &spot.y);
    depth = pen->low < 0 ? 0.5 * depth + 0.5 : depth;
    spot.depth = depth < 0 ? 0 : depth > 1 ? 1 : depth;
    spot.slack = sil_i_slack(pen, clip);
    spot.arc = 0;
    spot.along = sil_i_mix(a->along, b->along, t);
    spot.half = sil_i_mix(a->half, b->half, t);
    return spot;
}

/* The spot at t between two spots of one segment, where everything is linear on the screen. */
static sil_i_spot sil_i_spot_mix(const sil_i_spot *a, const sil_i_spot *b, double t) {
    sil_i_spot spot;
    spot.x = sil_i_mix(a->x, b->x, t);
    spot.y = sil_i_mix(a->y, b->y, t);
    spot.depth = sil_i_mix(a->depth, b->depth, t);
    spot.slack = sil_i_mix(a->slack, b->slack, t);
    spot.arc = sil_i_mix(a->arc, b->arc, t);
    spot.along = sil_i_mix(a->along, b->along, t);
    spot.half = sil_i_mix(a->half, b->half, t);
    return spot;
}

/* Cuts t[0] .. t[1] to where a quantity that goes from a to b is not negative. 0 where nothing is left. */
static int sil_i_cut(double a, double b, double t[2]) {
    if (a < 0 && b < 0)
        return 0;
    if (a < 0)
        t[0] = sil_i_larger(t[0], a / (a - b));
    if (b < 0) {
        const double at = a / (a - b);
        t[1] = at < t[1] ? at : t[1];
    }
    return t[0] <= t[1];
}

/* To the depth range and in front of the eye. */
static int sil_i_cut_depth(const sil_i_pen *pen, const double *a, const double *b, double t[2]) {
    const double least = 1e-9 * sil_i_larger(sil_i_abs(a[3]), sil_i_abs(b[3]));
    return (a[3] > 0 || b[3] > 0) && sil_i_cut(a[3] - least, b[3] - least, t) &&
           sil_i_cut(a[2] - pen->low * a[3], b[2] - pen->low * b[3], t) && sil_i_cut(a[3] - a[2], b[3] - b[2], t);
}

/* To the viewport and what is around it. */
static int sil_i_cut_sides(const sil_i_pen *pen, const double *a, const double *b, double t[2]) {
    const double gx = pen->guard_x, gy = pen->guard_y;
    return sil_i_cut(gx * a[3] + a[0], gx * b[3] + b[0], t) && sil_i_cut(gx * a[3] - a[0], gx * b[3] - b[0], t) &&
           sil_i_cut(gy * a[3] + a[1], gy * b[3] + b[1], t) && sil_i_cut(gy * a[3] - a[1], gy * b[3] - b[1], t);
}

static void sil_i_pen_lift(sil_i_pen *pen) {
    if (pen->down)
        sil_i_pen_cap(pen, &pen->last, pen->direction[0], pen->direction[1]);
    pen->down = 0;
}

/* Draws to a spot from where the pen is (down) or from `from`. `keep_cap`: the start of a closed strip. */
static void sil_i_pen_draw(sil_i_pen *pen, const sil_i_spot *from, const sil_i_spot *to, int keep_cap) {
    sil_i_spot start = *from;
    double length, d[2];
    if (pen->down) { /* short segments that were left out may lie between */
        start.x = pen->last.x;
        start.y = pen->last.y;
    }
    length = sil_i_gap(&start, to);
    if (length < 1e-4) { /* too short to have a direction: the next segment begins where this one did */
        pen->dotted = 1;
        pen->dot = start;
        return;
    }
    d[0] = (to->x - start.x) / length;
    d[1] = (to->y - start.y) / length;
    if (pen->down) {
        sil_i_spot corner = start;
        corner.half = sil_i_larger(start.half, pen->last.half);
        sil_i_pen_join(pen, &corner, pen->direction, d);
    } else if (keep_cap) {
        pen->joins_start = 1;
        pen->start = start;
        memcpy(pen->start_direction, d, sizeof d);
    } else
        sil_i_pen_cap(pen, &start, -d[0], -d[1]);
    sil_i_pen_quad(pen, &start, to, d);
    pen->last = *to;
    memcpy(pen->direction, d, sizeof d);
    pen->down = pen->started = 1;
}

/* A strip or a dash that is a point on the screen. */
static void sil_i_pen_dot(sil_i_pen *pen, const sil_i_spot *spot, double dx, double dy) {
    const double n[2] = {spot->half, 0};
    if (pen->desc->cap == SIL_CAP_ROUND && spot->half > 0)
        sil_i_pen_fan(pen, spot, n, 2 * SIL_I_PI, sil_i_pen_parts(pen, 2 * SIL_I_PI));
    if (pen->desc->cap == SIL_CAP_SQUARE) {
        sil_i_pen_cap(pen, spot, dx, dy);
        sil_i_pen_cap(pen, spot, -dx, -dy);
    }
}

/* ---- ribbons: dashes, tapers, outer lines ---- */

/* One interval of the dashes, drawn or left out; `ends`: the piece ends where the interval does. */
static void sil_i_pen_dash(sil_i_pen *pen, const sil_i_spot *from, const sil_i_spot *to, size_t index, int ends,
                           int keep_cap) {
    const double low = index ? pen->dash_end[index - 1] : 0;
    if (index & 1)
        sil_i_pen_lift(pen);
    else if (pen->dash_end[index] > low)
        sil_i_pen_draw(pen, from, to, keep_cap);
    if (ends) {
        sil_i_pen_lift(pen);
        if (!(index & 1) && !(pen->dash_end[index] > low))
            sil_i_pen_dot(pen, to, pen->way[0], pen->way[1]);
    }
}

/* A piece of a segment, cut where its dashes end; `along` may run either way. Boundaries come from counting intervals
   and never from adding lengths up, so that each is passed once. */
static void sil_i_pen_dashes(sil_i_pen *pen, const sil_i_spot *from, const sil_i_spot *to, int keep_cap) {
    const size_t count = pen->dash_count;
    const double span = to->along - from->along, period = count ? pen->dash_end[count - 1] : 0;
    const double *end = pen->dash_end;
    const double length = sil_i_gap(from, to);
    double turn, rest;
    sil_i_spot at = *from;
    size_t i = 0;
    if (!count || !(sil_i_abs(span) <= SIL_I_PERIODS * period) || !(sil_i_abs(from->along) <= 1e12 * period)) {
        sil_i_pen_draw(pen, from, to, keep_cap);
        return;
    }
    pen->way[0] = length > 0 ? (to->x - from->x) / length : 1;
    pen->way[1] = length > 0 ? (to->y - from->y) / length : 0;
    turn = floor(from->along / period);
    rest = from->along - turn * period;
    while (i + 1 < count && (end[i] < rest || (end[i] <= rest && (i ? end[i - 1] : 0) < end[i])))
        ++i;
    for (;;) {
        const double bound = turn * period + (span < 0 ? (i ? end[i - 1] : 0) : end[i]);
        const int ends = span < 0 ? bound > to->along : bound < to->along;
        const double t = ends ? (bound - from->along) / span : 1;
        const sil_i_spot next = ends ? sil_i_spot_mix(from, to, t > 0 ? t : 0) : *to;
        sil_i_pen_dash(pen, &at, &next, i, ends, keep_cap);
        if (!ends)
            return;
        keep_cap = 0;
        at = next;
        if (span < 0) {
            turn -= i == 0;
            i = (i ? i : count) - 1;
        } else {
            turn += i + 1 == count;
            i = (i + 1) % count;
        }
    }
}

/* Is there nothing at a place on the screen? Beyond the image's border it is as at the border. */
static int sil_i_is_background(const sil_i_pen *pen, double x, double y) {
    const sil_image *image = pen->desc->image;
    const size_t stride = image->stride ? image->stride : image->width;
    const double u = x / pen->width * image->width, v = y / pen->height * image->height;
    const size_t column = !(u > 0) ? 0 : u < image->width ? (size_t)u : image->width - 1u;
    const size_t row = !(v > 0) ? 0 : v < image->height ? (size_t)v : image->height - 1u;
    if (!image->depth)
        return image->ids[row * stride + column] == image->background;
    return image->flags & SIL_IMAGE_REVERSED ? !(image->depth[row * stride + column] > 0)
                                             : !(image->depth[row * stride + column] < 1);
}

/* Does a spot of a line that runs along d border the background, one and a half pixels of the coarser grid to a side?
 */
static int sil_i_is_outer(const sil_i_pen *pen, const sil_i_spot *spot, const double d[2]) {
    const sil_image *image = pen->desc->image;
    const double pixel = sil_i_larger(1, sil_i_larger(pen->width / image->width, pen->height / image->height));
    const double x = -1.5 * pixel * d[1], y = 1.5 * pixel * d[0];
    return sil_i_is_background(pen, spot->x + x, spot->y + y) || sil_i_is_background(pen, spot->x - x, spot->y - y);
}

static double sil_i_outer_half(const sil_i_pen *pen, double half, double level) {
    half *= sil_i_mix(pen->thin, pen->heavy, level);
    return half < 2048 ? half : 2048;
}

/* The piece from t0 to t1 of a segment, whose level changes from one to the other. */
static void sil_i_pen_outer_piece(sil_i_pen *pen, const sil_i_spot *from, const sil_i_spot *to, double t0, double t1,
                                  const double level[2], int keep_cap) {
    sil_i_spot a = sil_i_spot_mix(from, to, t0), b = sil_i_spot_mix(from, to, t1);
    a.half = sil_i_outer_half(pen, a.half, level[0]);
    b.half = sil_i_outer_half(pen, b.half, level[1]);
    sil_i_pen_dashes(pen, &a, &b, keep_cap && !(t0 > 0));
}

/* WEIGHT_OUTER looks at the image every two pixels and changes from thin to heavy in eight, so that a pixel of doubt
   makes no step. Everything else passes through. */
static void sil_i_pen_outer(sil_i_pen *pen, const sil_i_spot *from, const sil_i_spot *to, int keep_cap) {
    const double length = sil_i_gap(from, to), most = ceil(length / SIL_I_OUTER_STEP);
    const int count = most < 1 ? 1 : most < 65536 ? (int)most : 65536;
    double level[2], d[2];
    int i, done = 0;
    if (pen->desc->weight != SIL_WEIGHT_OUTER || !(length > 0)) {
        sil_i_pen_dashes(pen, from, to, keep_cap);
        return;
    }
    d[0] = (to->x - from->x) / length;
    d[1] = (to->y - from->y) / length;
    for (i = 0; i < count; ++i) {
        const sil_i_spot middle = sil_i_spot_mix(from, to, (i + 0.5) / count);
        const double wanted = sil_i_is_outer(pen, &middle, d), step = length / count / SIL_I_OUTER_RAMP;
        level[0] = level[1] = pen->level < 0 ? wanted : pen->level;
        pen->level = wanted > level[0] ? level[0] + step : level[0] - step;
        pen->level = sil_i_abs(wanted - level[0]) <= step ? wanted : pen->level;
        if (sil_i_abs(pen->level - level[0]) > 0) { /* first what was constant */
            if (i > done)
                sil_i_pen_outer_piece(pen, from, to, (double)done / count, (double)i / count, level, keep_cap);
            level[1] = pen->level;
            sil_i_pen_outer_piece(pen, from, to, (double)i / count, (i + 1.0) / count, level, keep_cap);
            done = i + 1;
        }
    }
    level[0] = level[1] = pen->level;
    if (done < count)
        sil_i_pen_outer_piece(pen, from, to, (double)done / count, 1, level, keep_cap);
}

static double sil_i_taper(const sil_i_pen *pen, double arc) {
    const double end = pen->length - arc, near_end = arc < end ? arc : end, taper = (double)pen->desc->taper;
    return near_end <= 0 ? 0 : near_end < taper ? near_end / taper : 1;
}

/* The visible part of a segment. Tapers are linear between their two ends and where these meet. */
static void sil_i_pen_run(sil_i_pen *pen, const sil_i_spot *from, const sil_i_spot *to, int keep_cap) {
    const double taper = (double)pen->desc->taper;
    const double bends[3] = {taper < 0.5 * pen->length ? taper : 0.5 * pen->length,
                             taper < 0.5 * pen->length ? pen->length - taper : 0.5 * pen->length, to->arc};
    sil_i_spot a = *from, b;
    int i;
    if (!(taper > 0) || pen->strip->closed) {
        sil_i_pen_outer(pen, from, to, keep_cap);
        return;
    }
    a.half *= sil_i_taper(pen, a.arc);
    for (i = 0; i < 3; ++i) {
        if (i < 2 && !(bends[i] > a.arc && bends[i] < to->arc))
            continue;
        b = i < 2 ? sil_i_spot_mix(from, to, (bends[i] - from->arc) / (to->arc - from->arc)) : *to;
        b.half *= sil_i_taper(pen, b.arc);
        sil_i_pen_outer(pen, &a, &b, 0);
        a = b;
    }
}

/* ---- ribbons: segments and strips ---- */

/* What of a segment lies before the eye and within the depth range: its two spots, with arcs. */
static int sil_i_pen_reaches(sil_i_pen *pen, const sil_i_stop *a, const sil_i_stop *b, double t[2], sil_i_spot *from,
                             sil_i_spot *to) {
    t[0] = 0;
    t[1] = 1;
    if (!a->known || !b->known || !sil_i_cut_depth(pen, a->clip, b->clip, t))
        return 0;
    *from = sil_i_spot_at(pen, a, b, t[0]);
    *to = sil_i_spot_at(pen, a, b, t[1]);
    from->arc = pen->arc;
    to->arc = pen->arc += sil_i_gap(from, to);
    if (!pen->desc->along) {
        from->along = from->arc + pen->phase;
        to->along = to->arc + pen->phase;
    }
    return 1;
}

/* Cuts a spot off at t, where the rest of it is linear on the screen. */
static void sil_i_spot_cut(const sil_i_pen *pen, const sil_i_stop *a, const sil_i_stop *b, double t,
                           const sil_i_spot whole[2], sil_i_spot *spot) {
    const double length = sil_i_gap(&whole[0], &whole[1]);
    const sil_i_spot exact = sil_i_spot_at(pen, a, b, t);
    const double part = length > 0 ? sil_i_gap(&whole[0], &exact) / length : 0;
    *spot = sil_i_spot_mix(&whole[0], &whole[1], part < 1 ? part : 1);
    spot->x = exact.x;
    spot->y = exact.y;
    spot->depth = exact.depth;
    spot->slack = exact.slack;
}

/* One segment, between two vertices. */
static void sil_i_pen_segment(sil_i_pen *pen, const sil_i_stop *a, const sil_i_stop *b, int keep_cap) {
    double t[2], uncut[2];
    sil_i_spot whole[2], spot[2];
    int k;
    if (!sil_i_pen_reaches(pen, a, b, t, &whole[0], &whole[1])) {
        sil_i_pen_lift(pen);
        return;
    }
    memcpy(uncut, t, sizeof t);
    if (!sil_i_cut_sides(pen, a->clip, b->clip, t)) {
        sil_i_pen_lift(pen);
        return;
    }
    if (t[0] > 0)
        sil_i_pen_lift(pen);
    for (k = 0; k < 2; ++k) {
        spot[k] = whole[k];
        if (sil_i_abs(t[k] - uncut[k]) > 0)
            sil_i_spot_cut(pen, a, b, t[k], whole, &spot[k]);
        sil_i_spot_clamp(pen, &spot[k]);
    }
    pen->arc_turn = SIL_I_TURN * floor(spot[0].arc / SIL_I_TURN);
    sil_i_pen_run(pen, &spot[0], &spot[1], keep_cap && !(t[0] > 0));
    if (t[1] < 1)
        sil_i_pen_lift(pen);
}

/* The place of a strip's vertex; 0 where it has none. */
static int sil_i_pen_place(const sil_i_pen *pen, size_t i, float place[3]) {
    const sil_ribbon_desc *desc = pen->desc;
    const size_t at = (size_t)pen->strip->first + i;
    uint32_t vertex = pen->vertices ? pen->vertices[at] : (uint32_t)at;
    if (desc->points) {
        const size_t stride = desc->point_stride ? desc->point_stride : 3 * sizeof(float);
        if (vertex >= desc->point_count)
            return 0;
        memcpy(place, (const char *)(const void *)desc->points + stride * vertex, 3 * sizeof(float));
        return sil_i_all_finite(place, 3);
    }
    if (vertex >= pen->mesh->vertex_count || pen->shape->bad[pen->mesh->welded[vertex]])
        return 0;
    vertex = pen->mesh->welded[vertex];
    memcpy(place, pen->shape->position + 3 * (size_t)vertex, 3 * sizeof(float));
    return 1;
}

/* Clip coordinates of a place. Returns its distance from the eye along the view. */
static double sil_i_to_clip(const sil_i_pen *pen, const float p[3], double clip[4]) {
    double eye[4];
    int k;
    for (k = 0; k < 4; ++k)
        eye[k] = pen->model_view[k] * (double)p[0] + pen->model_view[4 + k] * (double)p[1] +
                 pen->model_view[8 + k] * (double)p[2] + pen->model_view[12 + k];
    for (k = 0; k < 4; ++k)
        clip[k] = pen->projection[k] * eye[0] + pen->projection[4 + k] * eye[1] + pen->projection[8 + k] * eye[2] +
                  pen->projection[12 + k] * eye[3];
    return -eye[2];
}

/* Clip coordinates of a strip's vertex, and its distance from the eye along the view. */
static int sil_i_pen_project(const sil_i_pen *pen, size_t i, double clip[4], double *distance) {
    float p[3];
    if (!sil_i_pen_place(pen, i, p))
        return 0;
    *distance = sil_i_to_clip(pen, p, clip);
    return 1;
}

/* ---- ribbons: weights ---- */

/* WEIGHT_LIGHT: by the way outward, to the right of the line's way through the vertices on both sides of this one. */
static double sil_i_light_factor(const sil_i_pen *pen, size_t i) {
    const sil_strip *strip = pen->strip;
    const size_t last = strip->count - 1u;
    const size_t before = i ? i - 1 : strip->closed ? last - (last > 0) : 0;
    const size_t after = i < last ? i + 1 : strip->closed && last > 0 ? 1 : last;
    double clip[4], p[2][2], dx, dy, length, unused;
    int k;
    if (!(strip->kinds & (SIL_SILHOUETTE | SIL_BOUNDARY)))
        return sil_i_mix(pen->thin, pen->heavy, 0.5);
    for (k = 0; k < 2; ++k) {
        if (!sil_i_pen_project(pen, k ? after : before, clip, &unused) || !(clip[3] > 0))
            return sil_i_mix(pen->thin, pen->heavy, 0.5);
        sil_i_screen(pen, clip, &p[k][0], &p[k][1]);
    }
    dx = p[1][0] - p[0][0];
    dy = p[1][1] - p[0][1];
    length = sqrt(dx * dx + dy * dy);
    if (!(length > 1e-6) || !(length < 1e30))
        return sil_i_mix(pen->thin, pen->heavy, 0.5);
    return sil_i_mix(pen->thin, pen->heavy, 0.5 - 0.5 * (dy * pen->light[0] - dx * pen->light[1]) / length);
}

static double sil_i_weight_factor(const sil_i_pen *pen, size_t i, double distance) {
    double t;
    switch (pen->desc->weight) {
    case SIL_WEIGHT_THICK_THIN:
        return pen->strip->kinds & (SIL_SILHOUETTE | SIL_BOUNDARY) ? pen->heavy : pen->thin;
    case SIL_WEIGHT_PERSPECTIVE:
        t = pen->reach[1] - pen->reach[0];
        t = t > 0 || t < 0 ? (distance - pen->reach[0]) / t : distance > pen->reach[0];
        return sil_i_mix(pen->heavy, pen->thin, t > 0 ? t < 1 ? t : 1 : 0);
    case SIL_WEIGHT_LIGHT:
        return sil_i_light_factor(pen, i);
    case SIL_WEIGHT_ONE:
    case SIL_WEIGHT_OUTER: /* between vertices: sil_i_pen_outer */
        break;
    }
    return 1;
}

static double sil_i_vertex_factor(const float *widths, size_t at) {
    const float factor = widths ? widths[at] : 1.0f;
    return sil_i_finite(factor) && factor > 0 ? (double)factor : 0;
}

static sil_i_stop sil_i_pen_stop(const sil_i_pen *pen, size_t i) {
    const size_t at = (size_t)pen->strip->first + i;
    sil_i_stop stop;
    double distance = 0;
    memset(&stop, 0, sizeof stop);
    stop.known = sil_i_pen_project(pen, i, stop.clip, &distance);
    if (!stop.known)
        return stop;
    stop.half = pen->half * sil_i_vertex_factor(pen->desc->widths, at) * sil_i_weight_factor(pen, i, distance);
    stop.half = stop.half < 2048 ? stop.half : 2048;
    if (pen->desc->along) {
        stop.along = (double)pen->desc->along[at];
        stop.known = sil_i_finite(pen->desc->along[at]);
    }
    return stop;
}

/* The length that tapers need before the first segment is drawn. */
static void sil_i_pen_measure(sil_i_pen *pen) {
    sil_i_stop stop[2];
    sil_i_spot from, to;
    double t[2];
    size_t i;
    stop[0] = sil_i_pen_stop(pen, 0);
    for (i = 1; i < pen->strip->count; ++i) {
        stop[i % 2] = sil_i_pen_stop(pen, i);
        (void)sil_i_pen_reaches(pen, &stop[(i + 1) % 2], &stop[i % 2], t, &from, &to);
    }
    pen->length = pen->arc;
    pen->arc = 0;
}

/* The width of the strip's kind, and what follows from it for the widest place. */
static void sil_i_pen_width(sil_i_pen *pen) {
    const sil_ribbon_desc *desc = pen->desc;
    double tolerance = desc->tolerance > 0 ? (double)desc->tolerance : 0.1;
    double width = desc->width > 0 ? (double)desc->width : 1.5, widest = desc->widths ? 0 : 1, margin;
    size_t i;
    int k = 0;
    while (k < 4 && !(pen->strip->kinds >> k & 1))
        ++k;
    if (desc->width_scale[k] > 0)
        width *= (double)desc->width_scale[k];
    width = width > 4096 ? 4096 : width;
    pen->half = 0.5 * width;
    for (i = 0; desc->widths && i < pen->strip->count; ++i)
        widest = sil_i_larger(widest, sil_i_vertex_factor(desc->widths, pen->strip->first + i));
    if (desc->weight != SIL_WEIGHT_ONE)
        widest *= sil_i_larger(pen->heavy, pen->thin);
    width *= widest;
    width = width > 4096 ? 4096 : width;
    tolerance = tolerance < 1.0 / 64 ? 1.0 / 64 : tolerance;
    pen->step = tolerance < 0.145 * width ? 2 * acos(1 - tolerance / (0.5 * width)) : 0.5 * SIL_I_PI;
    margin = width + 2;
    pen->guard_x = 1 + 2 * margin / pen->width;
    pen->guard_y = 1 + 2 * margin / pen->height;
}

static void sil_i_pen_strip(sil_i_pen *pen, size_t index) {
    sil_i_stop stop[2];
    size_t i;
    sil_i_pen_width(pen);
    pen->phase = pen->desc->phases && sil_i_finite(pen->desc->phases[index]) ? (double)pen->desc->phases[index] : 0;
    pen->arc = pen->arc_turn = 0;
    pen->level = -1;
    pen->down = pen->started = pen->dotted = pen->joins_start = 0;
    if (pen->desc->taper > 0 && !pen->strip->closed)
        sil_i_pen_measure(pen);
    stop[0] = sil_i_pen_stop(pen, 0);
    for (i = 1; i < pen->strip->count; ++i) {
        stop[i % 2] = sil_i_pen_stop(pen, i);
        sil_i_pen_segment(pen, &stop[(i + 1) % 2], &stop[i % 2], pen->strip->closed && i == 1);
    }
    if (pen->joins_start && pen->down) {
        pen->last.half = sil_i_larger(pen->last.half, pen->start.half);
        sil_i_pen_join(pen, &pen->last, pen->direction, pen->start_direction);
        return;
    }
    sil_i_pen_lift(pen);
    if (pen->joins_start)
        sil_i_pen_cap(pen, &pen->start, -pen->start_direction[0], -pen->start_direction[1]);
    if (pen->dotted && !pen->started)
        sil_i_pen_dot(pen, &pen->dot, 1, 0);
}

/* Distances along the view of the nearest and the farthest corner of the box around the mesh. */
static void sil_i_pen_box(sil_i_pen *pen) {
    int i, k;
    for (i = 0; i < 8; ++i) {
        double distance = -pen->model_view[14];
        for (k = 0; k < 3; ++k)
            distance -= pen->model_view[4 * k + 2] * (i >> k & 1 ? pen->shape->high[k] : pen->shape->low[k]);
        pen->reach[0] = i && pen->reach[0] < distance ? pen->reach[0] : distance;
        pen->reach[1] = i && pen->reach[1] > distance ? pen->reach[1] : distance;
    }
}

static void sil_i_pen_weigh(sil_i_pen *pen) {
    const sil_ribbon_desc *desc = pen->desc;
    double eye[4], length;
    pen->heavy = desc->heavy > 0 ? (double)desc->heavy : 2;
    pen->thin = desc->thin > 0 ? (double)desc->thin : 1;
    sil_i_widen(desc->reach, pen->reach, 2);
    if (pen->shape && !(sil_i_abs(pen->reach[0]) > 0) && !(sil_i_abs(pen->reach[1]) > 0))
        sil_i_pen_box(pen);
    sil_i_widen(desc->light, pen->light, 2);
    length = sqrt(pen->light[0] * pen->light[0] + pen->light[1] * pen->light[1]);
    if (!(length > 0)) {
        pen->light[0] = -1;
        pen->light[1] = 1;
        length = sqrt(2.0);
    }
    if (sil_i_eye_point(pen->model_view, pen->projection, eye))
        length = -length;
    pen->light[0] /= length;
    pen->light[1] /= length;
}

static int sil_i_image_ok(const sil_image *image) {
    return image && (image->depth || image->ids) && image->width && image->height &&
           (!image->stride || image->stride >= image->width);
}

static int sil_i_ribbon_desc_ok(const sil_ribbon_desc *desc) {
    return sil_i_all_finite(desc->model_view, 16) && sil_i_all_finite(desc->projection, 16) &&
           sil_i_finite(desc->viewport_width) && sil_i_finite(desc->viewport_height) && sil_i_finite(desc->width) &&
           sil_i_finite(desc->tolerance) && sil_i_all_finite(desc->width_scale, 5) && desc->viewport_width > 0 &&
           desc->viewport_height > 0 && sil_i_finite(desc->heavy) && sil_i_finite(desc->thin) &&
           sil_i_all_finite(desc->light, 2) && sil_i_all_finite(desc->reach, 2) && sil_i_finite(desc->taper) &&
           (desc->weight != SIL_WEIGHT_OUTER || sil_i_image_ok(desc->image)) &&
           (!desc->point_stride || desc->point_stride >= 3 * sizeof(float));
}

/* Adds the lengths up. Whether they make sense: an even number, none negative, together neither 0 nor infinite. */
static int sil_i_read_dashes(const sil_ribbon_desc *desc, double *end, size_t *count) {
    double sum = 0;
    size_t i;
    *count = 0;
    if (!desc->dashes)
        return 1;
    if (!desc->dash_count || desc->dash_count % 2 || desc->dash_count > SIL_I_DASHES)
        return 0;
    for (i = 0; i < desc->dash_count; ++i) {
        if (!sil_i_finite(desc->dashes[i]) || desc->dashes[i] < 0)
            return 0;
        end[i] = sum += (double)desc->dashes[i];
    }
    *count = desc->dash_count;
    return sum > 0;
}

/* What all strips of a call have in common. 0 where the arguments make no sense. */
static int sil_i_pen_make(sil_i_pen *pen, const sil_mesh *mesh, const sil_pose *pose, const sil_strip *strips,
                          const uint32_t *vertices, const sil_ribbon_desc *desc) {
    memset(pen, 0, sizeof *pen);
    if ((pose && pose->mesh != mesh) || !strips || !desc || !sil_i_ribbon_desc_ok(desc) ||
        (!desc->points && (!mesh || !vertices)) || !sil_i_read_dashes(desc, pen->dash_end, &pen->dash_count))
        return 0;
    pen->mesh = mesh;
    pen->shape = mesh ? sil_i_shape_of(mesh, pose) : NULL;
    pen->desc = desc;
    sil_i_widen(desc->model_view, pen->model_view, 16);
    sil_i_widen(desc->projection, pen->projection, 16);
    pen->width = (double)desc->viewport_width;
    pen->height = (double)desc->viewport_height;
    pen->low = desc->flags & SIL_RIBBON_ZERO_TO_ONE ? 0 : -1;
    pen->vertices = vertices;
    sil_i_pen_weigh(pen);
    return 1;
}

SIL_DEF size_t sil_ribbons(const sil_mesh *mesh, const sil_pose *pose, const sil_strip *strips, size_t strip_count,
                           const uint32_t *vertices, const sil_ribbon_desc *desc, sil_ribbon_vertex *out,
                           size_t capacity) {
    sil_i_pen pen;
    size_t i;
    if (!sil_i_pen_make(&pen, mesh, pose, strips, vertices, desc))
        return 0;
    pen.out = out;
    pen.capacity = capacity;
    for (i = 0; i < strip_count; ++i) {
        pen.strip = &strips[i];
        if (strips[i].count)
            sil_i_pen_strip(&pen, i);
    }
    return pen.count;
}

/* ---- dashes that stay ---- */

#define SIL_I_MARK_NEAR 4.0   /* pixels: closer vertices have no mark of their own */
#define SIL_I_MARK_FAR 8.0    /* pixels: longer segments have marks in between */
#define SIL_I_MARK_CELL 10.0  /* pixels: the grid in which marks are found */
#define SIL_I_MARK_REACH 10.0 /* pixels: what is farther from where it was expected is another line */
#define SIL_I_MARK_LEAVE 3.0  /* pixels: a line is left for another only where that is closer by this */
#define SIL_I_MARK_SLIDE 0.5  /* of the contour's motion: how far dashes may move toward being even */

/* A place on a line of the last frame. */
typedef struct sil_i_mark {
    float place[3];      /* in the mesh or among the points */
    double x, y;         /* where it was on the screen */
    double now_x, now_y; /* where that place is seen in this frame */
    double along;
    uint32_t kinds, strip;
    uint32_t next; /* in the same cell of the grid */
    int joined;    /* the next mark is on the same line */
    int seen;      /* now_x and now_y are on the screen or near it */
} sil_i_mark;

/* What is known of a strip's vertex in this frame. */
typedef struct sil_i_bead {
    double x, y, arc;
    double offset;  /* along - way * arc */
    uint32_t strip; /* of the last frame, that it was found on */
    double motion;  /* of the contour since the last frame, pixels */
    int seen, found;
} sil_i_bead;

struct sil_dashes {
    sil_allocator allocator;
    sil_i_mark *mark, *fresh; /* of the last frame, of this one */
    size_t mark_count, mark_capacity, fresh_count, fresh_capacity;
    uint32_t *head; /* of the lists of marks, by a cell's hash */
    size_t head_count, head_capacity;
    uint32_t strip;   /* that is being followed */
    sil_i_bead *bead; /* its vertices */
    size_t bead_capacity;
};

SIL_DEF sil_dashes *sil_dashes_create(const sil_allocator *allocator, sil_result *result) {
    sil_allocator used;
    sil_dashes *dashes = NULL;
    memset(&used, 0, sizeof used);
    if (allocator)
        used = *allocator;
    if (!used.alloc_fn && !used.free_fn) {
        used.alloc_fn = sil_i_default_alloc;
        used.free_fn = sil_i_default_free;
    }
    if (used.alloc_fn && used.free_fn)
        dashes = (sil_dashes *)used.alloc_fn(sizeof *dashes, used.user);
    if (result)
        *result = dashes ? SIL_OK : used.alloc_fn && used.free_fn ? SIL_OUT_OF_MEMORY : SIL_INVALID_ARGUMENT;
    if (dashes) {
        memset(dashes, 0, sizeof *dashes);
        dashes->allocator = used;
    }
    return dashes;
}

SIL_DEF void sil_dashes_destroy(sil_dashes *dashes) {
    sil_allocator allocator;
    if (!dashes)
        return;
    allocator = dashes->allocator;
    sil_i_give(&allocator, dashes->mark);
    sil_i_give(&allocator, dashes->fresh);
    sil_i_give(&allocator, dashes->head);
    sil_i_give(&allocator, dashes->bead);
    sil_i_give(&allocator, dashes);
}

SIL_DEF void sil_dashes_forget(sil_dashes *dashes) {
    if (dashes)
        dashes->mark_count = 0;
}

/* An array with room for `wanted` elements, twice as many as before; its first `keep` bytes stay. NULL: no memory, and
   the array is as it was. */
static void *sil_i_grown(const sil_allocator *allocator, void *array, size_t *capacity, size_t wanted, size_t size,
                         size_t keep) {
    void *memory;
    size_t room = *capacity * 2 > wanted ? *capacity * 2 : wanted;
    if (*capacity >= wanted && array)
        return array;
    if (room > (size_t)-1 / size)
        return NULL;
    memory = allocator->alloc_fn(room * size, allocator->user);
    if (!memory)
        return NULL;
    if (keep)
        memcpy(memory, array, keep);
    sil_i_give(allocator, array);
    *capacity = room;
    return memory;
}

static size_t sil_i_mark_cell(const sil_dashes *dashes, double x, double y, int right, int up) {
    const uint32_t column = (uint32_t)(int32_t)floor(x / SIL_I_MARK_CELL) + (uint32_t)right;
    const uint32_t row = (uint32_t)(int32_t)floor(y / SIL_I_MARK_CELL) + (uint32_t)up;
    return sil_i_hash(column, row, 0) & (dashes->head_count - 1);
}

/* On the screen, or a little beside it. */
static int sil_i_is_seen(const sil_i_pen *pen, const double clip[4], double *x, double *y) {
    const double margin = 64;
    if (!(clip[3] > 0))
        return 0;
    sil_i_screen(pen, clip, x, y);
    return *x > -margin && *x<pen->width + margin && * y> - margin && *y < pen->height + margin && *x < 1e9 && *y < 1e9;
}

/* Puts the marks of the last frame where their places are seen now. */
static void sil_i_marks_place(sil_dashes *dashes, const sil_i_pen *pen) {
    double clip[4];
    size_t i;
    memset(dashes->head, 0xff, dashes->head_count * sizeof *dashes->head);
    for (i = 0; i < dashes->mark_count; ++i) {
        sil_i_mark *mark = &dashes->mark[i];
        (void)sil_i_to_clip(pen, mark->place, clip);
        mark->seen = sil_i_is_seen(pen, clip, &mark->now_x, &mark->now_y);
        if (mark->seen) {
            uint32_t *head = &dashes->head[sil_i_mark_cell(dashes, mark->now_x, mark->now_y, 0, 0)];
            mark->next = *head;
            *head = (uint32_t)i;
        }
    }
}

/* The nearest place of the last frame's lines. */
typedef struct sil_i_match {
    double distance;   /* pixels, with what is added to lines other than that which is followed; at first the reach */
    double along, way; /* there; way: 1 where the dashes run as the strip does, else -1 */
    double x, y;       /* where it was on the screen */
    uint32_t mark;     /* of equally near ones the first */
} sil_i_match;

/* Does the line that goes on from one mark continue what the vertex before followed? A loop's begin does not continue
   its end. */
static int sil_i_continues(const sil_i_mark *mark, const sil_i_match *before, double step, double period) {
    return mark->strip == before->mark && sil_i_abs(mark->along - before->along) <= 2 * (step + period);
}

/* Tries the line from one mark to the next, for a line of direction d at x, y. */
static void sil_i_match_try(const sil_dashes *dashes, uint32_t i, const sil_i_bead *bead, const double d[2],
                            int continues, sil_i_match *match) {
    const sil_i_mark *a = &dashes->mark[i], *b = a->joined ? a + 1 : a;
    const double ex = b->now_x - a->now_x, ey = b->now_y - a->now_y, square = ex * ex + ey * ey;
    double t, dx, dy, turn, distance;
    if (!b->seen || !(square > 0))
        return;
    t = ((bead->x - a->now_x) * ex + (bead->y - a->now_y) * ey) / square;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    dx = bead->x - sil_i_mix(a->now_x, b->now_x, t);
    dy = bead->y - sil_i_mix(a->now_y, b->now_y, t);
    if (dx * dx + dy * dy > match->distance * match->distance) /* most are */
        return;
    turn = (ex * d[0] + ey * d[1]) / sqrt(square);
    distance = sqrt(dx * dx + dy * dy) + (continues ? 0 : SIL_I_MARK_LEAVE);
    if (sil_i_abs(turn) < 0.5 || distance > match->distance || (!(distance < match->distance) && i >= match->mark))
        return;
    match->distance = distance;
    match->along = sil_i_mix(a->along, b->along, t);
    match->way = (turn > 0) == (b->along >= a->along) ? 1 : -1;
    match->x = sil_i_mix(a->x, b->x, t);
    match->y = sil_i_mix(a->y, b->y, t);
    match->mark = i;
}

/* before: what the vertex before followed, with its strip for a mark; `step` pixels back. */
static int sil_i_match_find(const sil_dashes *dashes, const sil_i_pen *pen, const sil_i_bead *bead, const double d[2],
                            const sil_i_match *before, double step, sil_i_match *match) {
    const double period = pen->dash_end[pen->dash_count - 1];
    int right, up;
    memset(match, 0, sizeof *match);
    match->distance = SIL_I_MARK_REACH;
    match->mark = SIL_NONE;
    for (up = -1; up <= 1; ++up)
        for (right = -1; right <= 1; ++right) {
            uint32_t i = dashes->head[sil_i_mark_cell(dashes, bead->x, bead->y, right, up)];
            for (; i != SIL_NONE; i = dashes->mark[i].next)
                if (dashes->mark[i].kinds == pen->strip->kinds)
                    sil_i_match_try(dashes, i, bead, d, sil_i_continues(&dashes->mark[i], before, step, period), match);
        }
    return match->mark != SIL_NONE;
}

/* Where the strip's vertices are on the screen, and arcs between them. */
static void sil_i_beads_place(const sil_i_pen *pen, sil_i_bead *bead) {
    double clip[2][4], t[2], part, unused;
    int known[2];
    size_t i;
    for (i = 0; i < pen->strip->count; ++i) {
        sil_i_bead *b = &bead[i];
        memset(b, 0, sizeof *b);
        known[i % 2] = sil_i_pen_project(pen, i, clip[i % 2], &unused);
        b->seen = known[i % 2] && sil_i_is_seen(pen, clip[i % 2], &b->x, &b->y);
        if (i == 0)
            continue;
        b->arc = bead[i - 1].arc;
        t[0] = 0;
        t[1] = 1;
        if (known[0] && known[1] && sil_i_cut_depth(pen, clip[(i + 1) % 2], clip[i % 2], t)) {
            double x[2], y[2], at[4];
            int k, e;
            for (e = 0; e < 2; ++e) {
                for (k = 0; k < 4; ++k)
                    at[k] = sil_i_mix(clip[(i + 1) % 2][k], clip[i % 2][k], t[e]);
                sil_i_screen(pen, at, &x[e], &y[e]);
            }
            part = t[1] - t[0] > 1e-3 ? t[1] - t[0] : 1e-3; /* what lies behind the eye is as what lies before it */
            b->arc += sqrt((x[1] - x[0]) * (x[1] - x[0]) + (y[1] - y[0]) * (y[1] - y[0])) / part;
        }
    }
}

/* The direction of a strip at a vertex, from its neighbours. 0 where it has none. */
static int sil_i_bead_direction(const sil_i_pen *pen, const sil_i_bead *bead, size_t i, double d[2]) {
    const size_t last = pen->strip->count - 1u;
    const sil_i_bead *a = &bead[i ? i - 1 : 0], *b = &bead[i < last ? i + 1 : last];
    double length;
    a = a->seen ? a : &bead[i];
    b = b->seen ? b : &bead[i];
    d[0] = b->x - a->x;
    d[1] = b->y - a->y;
    length = sqrt(d[0] * d[0] + d[1] * d[1]);
    if (!(length > 1e-6))
        return 0;
    d[0] /= length;
    d[1] /= length;
    return 1;
}

/* Takes over what is found of the last frame; offset is where in the dashes it was. Returns how many more vertices
   found that the dashes run as the strip does than against it. */
static double sil_i_beads_match(const sil_dashes *dashes, const sil_i_pen *pen, sil_i_bead *bead) {
    double votes = 0, arc = 0, d[2];
    sil_i_match match, before;
    size_t i;
    memset(&before, 0, sizeof before);
    before.mark = SIL_NONE;
    for (i = 0; i < pen->strip->count; ++i) {
        sil_i_bead *b = &bead[i];
        if (!b->seen || !sil_i_bead_direction(pen, bead, i, d) ||
            !sil_i_match_find(dashes, pen, b, d, &before, b->arc - arc, &match))
            continue;
        before = match;
        before.mark = b->strip = dashes->mark[match.mark].strip;
        arc = b->arc;
        b->found = 1;
        b->offset = match.along;
        b->motion = sqrt((b->x - match.x) * (b->x - match.x) + (b->y - match.y) * (b->y - match.y));
        votes += match.way;
    }
    return votes;
}

/* From what was found along the strip to offsets. Where the line of the last frame goes on, so do they; from one line
   to another, and where a loop closed, they differ by as little as whole periods allow. */
static int sil_i_beads_unwrap(const sil_i_pen *pen, sil_i_bead *bead, double way) {
    const double period = pen->dash_end[pen->dash_count - 1];
    double found = 0, before = 0;
    uint32_t strip = SIL_NONE;
    size_t i;
    for (i = 0; i < pen->strip->count; ++i) {
        sil_i_bead *b = &bead[i];
        double step;
        if (!b->found)
            continue;
        step = b->offset - way * b->arc - found;
        found += step;
        if (b->strip != strip || sil_i_abs(step) > 2 * period)
            step -= period * floor(step / period + (strip == SIL_NONE ? 0 : 0.5));
        b->offset = before += step;
        strip = b->strip;
    }
    return strip != SIL_NONE;
}

/* Moves offsets toward their mean, as far as the contour's motion covers it. Vertices without one take their
   neighbour's. */
static void sil_i_beads_even(const sil_i_pen *pen, sil_i_bead *bead) {
    const size_t count = pen->strip->count;
    const double period = pen->dash_end[pen->dash_count - 1];
    double sum = 0, least = 0, most = 0, mean, last;
    size_t i, found = 0;
    for (i = 0; i < count; ++i)
        if (bead[i].found) {
            sum += bead[i].offset;
            least = !found || bead[i].offset < least ? bead[i].offset : least;
            most = !found || bead[i].offset > most ? bead[i].offset : most;
            ++found;
        }
    mean = sum / (double)found;
    last = mean;
    for (i = 0; i < count; ++i)
        if (bead[i].found) {
            const double slide = SIL_I_MARK_SLIDE * bead[i].motion, wanted = mean - bead[i].offset;
            bead[i].offset += wanted > slide ? slide : wanted < -slide ? -slide : wanted;
            if (most - least > 0.5 * bead[count - 1].arc + period) /* stretched too far: anew */
                bead[i].offset = mean;
        }
    for (i = count; i-- > 0;)
        last = bead[i].found ? bead[i].offset : last; /* the first one found */
    for (i = 0; i < count; ++i) {
        last = bead[i].found ? bead[i].offset : last;
        bead[i].offset = last;
    }
}

/* Leaves a mark at t of the segment that ends at vertex i. */
static int sil_i_mark_leave(sil_dashes *dashes, const sil_i_pen *pen, const float *along, size_t i, double t,
                            double s) {
    float a[3], b[3];
    double clip[4];
    sil_i_mark *mark;
    int k;
    mark = (sil_i_mark *)sil_i_grown(&dashes->allocator, dashes->fresh, &dashes->fresh_capacity,
                                     dashes->fresh_count + 1, sizeof *mark, dashes->fresh_count * sizeof *mark);
    if (!mark)
        return 0;
    dashes->fresh = mark;
    mark += dashes->fresh_count;
    memset(mark, 0, sizeof *mark);
    if (!sil_i_pen_place(pen, i - 1, a) || !sil_i_pen_place(pen, i, b))
        return 1;
    for (k = 0; k < 3; ++k)
        mark->place[k] = (float)sil_i_mix((double)a[k], (double)b[k], t);
    (void)sil_i_to_clip(pen, mark->place, clip);
    mark->kinds = pen->strip->kinds;
    mark->strip = dashes->strip;
    mark->along = sil_i_mix((double)along[i - 1], (double)along[i], s);
    if (sil_i_is_seen(pen, clip, &mark->x, &mark->y)) {
        mark->joined = 1;
        ++dashes->fresh_count;
    } else if (dashes->fresh_count)
        mark[-1].joined = 0;
    return 1;
}

/* Marks along a strip, none closer than four pixels to the next but the last, none farther than eight. */
static int sil_i_marks_leave(sil_dashes *dashes, const sil_i_pen *pen, const sil_i_bead *bead, const float *along) {
    const size_t count = pen->strip->count, before = dashes->fresh_count;
    double clip[2][4], since = SIL_I_MARK_NEAR, unused;
    size_t i;
    for (i = 1; i < count; ++i) {
        const double length = bead[i].arc - bead[i - 1].arc, most = ceil(length / SIL_I_MARK_FAR);
        const int parts = most < 1 ? 1 : most < 4096 ? (int)most : 4096;
        int k, ok = 1;
        since += length;
        if (since < SIL_I_MARK_NEAR && i > 1 && i + 1 < count)
            continue;
        if (!sil_i_pen_project(pen, i - 1, clip[0], &unused) || !sil_i_pen_project(pen, i, clip[1], &unused) ||
            !(clip[0][3] > 0) || !(clip[1][3] > 0)) {
            if (dashes->fresh_count > before)
                dashes->fresh[dashes->fresh_count - 1].joined = 0;
            continue;
        }
        for (k = i > 1 && dashes->fresh_count > before; k <= parts && ok; ++k) {
            /* even steps on the screen, the places in the mesh that are seen there */
            const double s = (double)k / parts, near_end = s * clip[0][3], far_end = (1 - s) * clip[1][3];
            ok = sil_i_mark_leave(dashes, pen, along, i, near_end / (near_end + far_end), s);
        }
        since = 0;
        if (!ok)
            return 0;
    }
    if (dashes->fresh_count > before)
        dashes->fresh[dashes->fresh_count - 1].joined = 0;
    return 1;
}

static int sil_i_dashes_strip(sil_dashes *dashes, const sil_i_pen *pen, float *along) {
    const double period = pen->dash_end[pen->dash_count - 1];
    const size_t count = pen->strip->count;
    sil_i_bead *bead = dashes->bead;
    double way, whole;
    size_t i;
    sil_i_beads_place(pen, bead);
    way = sil_i_beads_match(dashes, pen, bead) < 0 ? -1 : 1;
    if (sil_i_beads_unwrap(pen, bead, way))
        sil_i_beads_even(pen, bead);
    /* whole periods do not matter, and small numbers are precise floats */
    whole = period * floor((way * bead[0].arc + bead[0].offset) / period);
    for (i = 0; i < count; ++i)
        along[i] = (float)(way * bead[i].arc + bead[i].offset - whole);
    return sil_i_marks_leave(dashes, pen, bead, along);
}

static int sil_i_dashes_room(sil_dashes *dashes, const sil_strip *strips, size_t strip_count) {
    size_t i, longest = 1, heads = 64;
    void *memory;
    for (i = 0; i < strip_count; ++i)
        longest = strips[i].count > longest ? strips[i].count : longest;
    while (heads < dashes->mark_count)
        heads *= 2;
    memory = sil_i_grown(&dashes->allocator, dashes->bead, &dashes->bead_capacity, longest, sizeof *dashes->bead, 0);
    if (!memory)
        return 0;
    dashes->bead = (sil_i_bead *)memory;
    memory = sil_i_grown(&dashes->allocator, dashes->head, &dashes->head_capacity, heads, sizeof *dashes->head, 0);
    if (!memory)
        return 0;
    dashes->head = (uint32_t *)memory;
    dashes->head_count = heads;
    return 1;
}

SIL_DEF sil_result sil_dashes_follow(sil_dashes *dashes, const sil_mesh *mesh, const sil_pose *pose,
                                     const sil_strip *strips, size_t strip_count, const uint32_t *vertices,
                                     const sil_ribbon_desc *desc, float *along) {
    sil_i_pen pen;
    sil_i_mark *marks;
    size_t i;
    if (!dashes || !along || !sil_i_pen_make(&pen, mesh, pose, strips, vertices, desc) || !pen.dash_count)
        return SIL_INVALID_ARGUMENT;
    dashes->fresh_count = 0;
    if (!sil_i_dashes_room(dashes, strips, strip_count))
        return SIL_OUT_OF_MEMORY;
    sil_i_marks_place(dashes, &pen);
    for (i = 0; i < strip_count; ++i) {
        pen.strip = &strips[i];
        dashes->strip = (uint32_t)i;
        if (strips[i].count && !sil_i_dashes_strip(dashes, &pen, along + strips[i].first))
            return SIL_OUT_OF_MEMORY;
    }
    marks = dashes->mark;
    dashes->mark = dashes->fresh;
    dashes->fresh = marks;
    i = dashes->mark_capacity;
    dashes->mark_capacity = dashes->fresh_capacity;
    dashes->fresh_capacity = i;
    dashes->mark_count = dashes->fresh_count;
    return SIL_OK;
}

#endif /* SILHOUETTE_IMPLEMENTATION_ONCE */
#endif /* SILHOUETTE_IMPLEMENTATION */

/*
MIT License

Copyright (c) 2026 the Glassine authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
