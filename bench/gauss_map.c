/* cc -std=c11 -O2 -I. bench/gauss_map.c -o bench_gauss_map -lm && ./bench_gauss_map [FILE.csv]

   The trees that silhouette.h's hierarchy was chosen among, on the same meshes and views:
     gauss      Gooch 1999, section 5.1.2: edges as arcs on the sphere of directions, each at the lowest level whose
                spherical triangle (octahedron, split in four) holds it; parallel views only
     overlap    the same with bins that overlap: triangles grown by a quarter of their height on each side
     cones      Sander 2000 in its simplest form: patches with a cone of normals anchored at a point, one cone test a node
                on the patches of silhouette.h, in a tree of eight
     spheres    cone of normals and sphere of positions, as The Dark Mod and FCPW have them
     hierarchy  silhouette.h
   Printed: edges stored at each level (Gooch's table 2) and milliseconds a view against testing every edge (his table 1);
   for trees over patches how many of the patches each would look at. error_max: silhouettes missed or found twice. */
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include "meshes.h"

#define LEVELS 5

typedef struct vec {
    double x[3];
} vec;

static double dot(vec a, vec b) {
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

static vec cross(vec a, vec b) {
    const vec c = {
        {a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
    return c;
}

static vec middle(vec a, vec b) {
    const vec m = {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
    const double length = sqrt(dot(m, m));
    const vec unit = {{m.x[0] / length, m.x[1] / length, m.x[2] / length}};
    return unit;
}

/* ---- the Gauss map ---- */

typedef struct bin {
    vec corner[3];
    uint32_t *edges;
    size_t count, room;
} bin;

typedef struct gauss_map {
    bin *bins; /* level l begins at first[l]; child k of bin i is 4 i + k */
    size_t first[LEVELS + 1];
    uint32_t *rest; /* edges that no bin of the first level holds */
    size_t rest_count, edge_count;
    double grow; /* 0: triangles do not overlap */
} gauss_map;

static void bin_add(bin *b, uint32_t edge) {
    if (b->count == b->room) {
        b->room = b->room ? 2 * b->room : 8;
        b->edges = (uint32_t *)realloc(b->edges, b->room * sizeof(uint32_t));
        if (!b->edges)
            exit(1);
    }
    b->edges[b->count++] = edge;
}

static void gauss_bins(gauss_map *g) {
    size_t level, i, total = 0, count = 8;
    int k;
    for (level = 0; level <= LEVELS; ++level, count *= 4) {
        g->first[level] = total;
        total += level < LEVELS ? count : 0;
    }
    g->bins = (bin *)need(total * sizeof(bin));
    memset(g->bins, 0, total * sizeof(bin));
    for (i = 0; i < 8; ++i)
        for (k = 0; k < 3; ++k)
            g->bins[i].corner[k].x[k] = i >> k & 1 ? -1 : 1;
    for (level = 0; level + 1 < LEVELS; ++level)
        for (i = g->first[level]; i < g->first[level + 1]; ++i) {
            const vec *c = g->bins[i].corner;
            const vec m[3] = {middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
            const vec parts[4][3] = {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}};
            for (k = 0; k < 4; ++k)
                memcpy(g->bins[g->first[level + 1] + 4 * (i - g->first[level]) + (size_t)k].corner, parts[k],
                       sizeof parts[k]);
        }
}

/* Is a direction within a spherical triangle, grown by a share of its height? The triangle is convex, so that it holds
   an arc if it holds both ends. */
static bool bin_holds(const gauss_map *g, const bin *b, vec n) {
    int k;
    for (k = 0; k < 3; ++k) {
        const vec side = cross(b->corner[k], b->corner[(k + 1) % 3]);
        const double height = dot(side, b->corner[(k + 2) % 3]), at = dot(side, n) / height;
        if (!(at >= -g->grow))
            return false;
    }
    return true;
}

/* The deepest bin among some of a level, or below, that holds an arc; where bins overlap there may be several ways down. */
static void gauss_find(const gauss_map *g, size_t level, size_t first, size_t count, const vec n[2], size_t *deepest,
                       size_t *best) {
    size_t i;
    for (i = first; i < first + count && *deepest < LEVELS; ++i)
        if (bin_holds(g, &g->bins[i], n[0]) && bin_holds(g, &g->bins[i], n[1])) {
            if (level + 1 > *deepest) {
                *deepest = level + 1;
                *best = i;
            }
            if (level + 1 < LEVELS)
                gauss_find(g, level + 1, g->first[level + 1] + 4 * (i - g->first[level]), 4, n, deepest, best);
        }
}

static void gauss_add(gauss_map *g, uint32_t edge, vec n0, vec n1) {
    const vec n[2] = {n0, n1};
    size_t deepest = 0, best = 0;
    gauss_find(g, 0, 0, 8, n, &deepest, &best);
    if (deepest)
        bin_add(&g->bins[best], edge);
    else
        g->rest[g->rest_count++] = edge;
}

static vec normal_of(const published *p, uint32_t face) {
    const float *n = p->normals + 3 * (size_t)face;
    const vec v = {{(double)n[0], (double)n[1], (double)n[2]}};
    return v;
}

static gauss_map gauss_make(const published *p, double grow) {
    gauss_map g;
    uint32_t e;
    memset(&g, 0, sizeof g);
    g.grow = grow;
    g.edge_count = p->edge_count;
    g.rest = (uint32_t *)need(p->edge_count * sizeof(uint32_t));
    gauss_bins(&g);
    for (e = 0; e < p->edge_count; ++e)
        gauss_add(&g, e, normal_of(p, p->edges[e].face[0]), normal_of(p, p->edges[e].face[1]));
    return g;
}

static size_t gauss_test(const published *p, const uint32_t *edges, size_t count, const float d[3], uint32_t *out) {
    size_t i, found = 0;
    for (i = 0; i < count; ++i) {
        const plain_edge *e = &p->edges[edges[i]];
        const float *n0 = p->normals + 3 * (size_t)e->face[0], *n1 = p->normals + 3 * (size_t)e->face[1];
        const float d0 = n0[0] * d[0] + n0[1] * d[1] + n0[2] * d[2], d1 = n1[0] * d[0] + n1[1] * d[1] + n1[2] * d[2];
        if (d0 * d1 < 0)
            out[found++] = edges[i];
    }
    return found;
}

/* A corner of a grown triangle: as far outside of the two sides that meet there as its bin allows. */
static vec grown_corner(const gauss_map *g, const bin *b, int k) {
    const vec *c = b->corner, *i = &c[(k + 1) % 3], *j = &c[(k + 2) % 3];
    const vec back = {{-g->grow * (i->x[0] + j->x[0]), -g->grow * (i->x[1] + j->x[1]), -g->grow * (i->x[2] + j->x[2])}};
    const double half = dot(back, c[k]), along = -half + sqrt(fmax(half * half - dot(back, back) + 1, 0));
    const vec corner = {{back.x[0] + along * c[k].x[0], back.x[1] + along * c[k].x[1], back.x[2] + along * c[k].x[2]}};
    return corner;
}

/* A bin on one side of the view's plane holds no silhouette: the triangle, or a cap around the grown triangle. */
static bool bin_is_cut(const gauss_map *g, const bin *b, vec d) {
    const vec c = middle(middle(b->corner[0], b->corner[1]), b->corner[2]);
    double low = 2, high = -2, reach = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        const double t = dot(b->corner[k], d);
        low = fmin(low, t);
        high = fmax(high, t);
        if (g->grow > 0)
            reach = fmax(reach, 1.05 * acos(fmax(dot(grown_corner(g, b, k), c), -1)));
    }
    if (g->grow > 0)
        return reach >= SIL_I_PI / 2 || fabs(dot(c, d)) <= sin(reach) * sqrt(dot(d, d));
    return low <= 1e-6 && high >= -1e-6;
}

static size_t gauss_query(const gauss_map *g, const published *p, vec d, uint32_t *out) {
    const float direction[3] = {(float)d.x[0], (float)d.x[1], (float)d.x[2]};
    size_t stack[8 + 4 * LEVELS], levels[8 + 4 * LEVELS], top = 0, found;
    int k;
    found = gauss_test(p, g->rest, g->rest_count, direction, out);
    for (; top < 8; ++top) {
        stack[top] = top;
        levels[top] = 0;
    }
    while (top) {
        const size_t i = stack[--top], level = levels[top];
        if (!bin_is_cut(g, &g->bins[i], d))
            continue;
        found += gauss_test(p, g->bins[i].edges, g->bins[i].count, direction, out + found);
        for (k = 0; k < 4 && level + 1 < LEVELS; ++k) {
            stack[top] = g->first[level + 1] + 4 * (i - g->first[level]) + (size_t)k;
            levels[top++] = level + 1;
        }
    }
    return found;
}

static void gauss_print(const gauss_map *g, const char *name) {
    size_t level, i;
    printf("  %-8s at no level %zu, then by level:", name, g->rest_count);
    for (level = 0; level < LEVELS; ++level) {
        size_t count = 0;
        for (i = g->first[level]; i < g->first[level + 1]; ++i)
            count += g->bins[i].count;
        printf(" %zu", count);
    }
    printf("\n");
}

static size_t gauss_bytes(const gauss_map *g) {
    return g->first[LEVELS] * sizeof(bin) + g->edge_count * sizeof(uint32_t);
}

static void gauss_free(gauss_map *g) {
    size_t i;
    for (i = 0; i < g->first[LEVELS]; ++i)
        free(g->bins[i].edges);
    free(g->bins);
    free(g->rest);
}

/* ---- cones over patches ---- */

typedef struct cone {
    double axis[3], centre[3], sine, cosine, radius; /* of the normals, of the places */
    double front,
        back; /* anchors: the eye beyond that along the axis from the centre sees nothing but fronts, or backs */
} cone;

static cone cone_of(const sil_mesh *mesh, size_t patch) {
    const size_t places = sil_i_patch_places(mesh->patches, patch);
    const sil_i_shape *rest = &mesh->rest;
    double low[3] = {9, 9, 9}, high[3] = {-9, -9, -9}, length = 0, least = 1;
    cone c;
    size_t i;
    int k;
    memset(&c, 0, sizeof c);
    for (i = 0; i < places; ++i) {
        const uint32_t f = sil_i_face_at(mesh, patch, i);
        for (k = 0; k < 3; ++k) {
            const double x =
                ((double)rest->position[3 * (size_t)mesh->corner[3 * (size_t)f] + (size_t)k] - rest->center[k]) /
                rest->scale;
            low[k] = fmin(low[k], x);
            high[k] = fmax(high[k], x);
            c.axis[k] += (double)rest->plane[k][f];
        }
    }
    for (k = 0; k < 3; ++k) {
        length += c.axis[k] * c.axis[k];
        c.centre[k] = 0.5 * (low[k] + high[k]);
        c.radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    c.radius = sqrt(c.radius);
    length = sqrt(length);
    for (k = 0; k < 3; ++k)
        c.axis[k] /= length > 0 ? length : 1;
    for (i = 0; i < places; ++i) {
        const uint32_t f = sil_i_face_at(mesh, patch, i);
        double t = 0;
        for (k = 0; k < 3; ++k)
            t += c.axis[k] * (double)rest->plane[k][f];
        least = fmin(least, t);
    }
    c.cosine = fmax(least, 0);
    c.sine = sqrt(1 - c.cosine * c.cosine);
    c.front = -1e9;
    c.back = 1e9;
    for (i = 0; i < places && c.cosine > 1e-3; ++i) { /* planes meet the axis through the centre: Sander's anchors */
        const uint32_t f = sil_i_face_at(mesh, patch, i);
        double t = (double)rest->plane[3][f], along = 0;
        for (k = 0; k < 3; ++k) {
            t -= (double)rest->plane[k][f] * c.centre[k];
            along += (double)rest->plane[k][f] * c.axis[k];
        }
        c.front = fmax(c.front, t / along);
        c.back = fmin(c.back, t / along);
    }
    return c;
}

/* Is the eye in the cone of fronts, or of backs, with its tip at an anchor? 0: it may see either. */
static bool anchored_decides(const cone *c, const double e[3]) {
    int k, side;
    for (side = 0; side < 2 && c->cosine > 1e-3; ++side) {
        const double tip = side ? c->back : c->front;
        double along = 0, square = 0;
        for (k = 0; k < 3; ++k) {
            const double x = e[k] - c->centre[k] - tip * c->axis[k];
            along += x * c->axis[k];
            square += x * x;
        }
        if ((side ? -along : along) > c->sine * sqrt(square)) /* within 90 degrees less the normals' angle */
            return true;
    }
    return false;
}

/* The angle between the axis and the sight of the sphere's centre, against the angles of the normals and the sphere. */
static bool sphere_decides(const cone *c, const double e[3]) {
    double along = 0, square = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        const double x = e[k] - c->centre[k];
        along += x * c->axis[k];
        square += x * x;
    }
    if (square <= c->radius * c->radius)
        return false;
    return fabs(along) / sqrt(square) > sin(fmin(asin(c->sine) + asin(c->radius / sqrt(square)), SIL_I_PI / 2));
}

/* How many patches each test would look at; all by one linear pass, so that only the tests are compared. */
static void compare_cones(const model *m, const sil_mesh *mesh, sil_pose *pose) {
    const size_t patches = mesh->patches->count;
    cone *cones = (cone *)need(patches * sizeof *cones);
    size_t i, patch, boxes = 0, anchored = 0, spheres = 0;
    for (patch = 0; patch < patches; ++patch)
        cones[patch] = cone_of(mesh, patch);
    for (i = 0; i < 60; ++i) {
        const double angle = 0.1 * (double)i, radius = 2.2 + 2 * sin(0.7 * angle);
        const double eye[3] = {radius * cos(angle), radius * sin(angle), 0.4 * radius * sin(0.3 * angle)};
        const sil_view view = sil_view_perspective(eye);
        double e[3];
        int k;
        for (k = 0; k < 3; ++k)
            e[k] = (eye[k] - mesh->rest.center[k]) / mesh->rest.scale;
        (void)sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0);
        boxes += pose->looked;
        for (patch = 0; patch < patches; ++patch) {
            anchored += !anchored_decides(&cones[patch], e);
            spheres += !sphere_decides(&cones[patch], e);
        }
    }
    printf(
        "  %s: of %zu patches are looked at, by boxes of planes %zu, by anchored cones %zu, by cone and sphere %zu\n",
        m->name, patches, boxes / 60, anchored / 60, spheres / 60);
    free(cones);
}

/* ---- tables ---- */

static void row(FILE *csv, const char *scene, const char *subject, const published *p, double ms, size_t bytes,
                size_t errors, double naive) {
    printf("  %-14s %8zu edges  %-10s %9.4f ms  published / it %6.1f  %zu edges differ\n", scene, p->edge_count,
           subject, ms, naive / ms, errors);
    fprintf(csv, "extract_ortho,%s,%zu,%s,%.6f,%zu,%zu\n", scene, p->edge_count, subject, ms, bytes, errors);
}

static int compare_numbers(const void *a, const void *b) {
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return x < y ? -1 : x > y;
}

static size_t differences(uint32_t *a, size_t a_count, const uint32_t *b, size_t b_count) {
    size_t i = 0, j = 0, count = 0;
    qsort(a, a_count, sizeof *a, compare_numbers);
    while (i < a_count || j < b_count) {
        const uint32_t x = i < a_count ? a[i] : UINT32_MAX, y = j < b_count ? b[j] : UINT32_MAX;
        count += x != y;
        i += x <= y;
        j += y <= x;
    }
    return count;
}

static void run_model(FILE *csv, model m, size_t views) {
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    published p;
    gauss_map maps[2];
    double *times[4];
    uint32_t *found, *truth;
    sil_edge *edges;
    size_t i, j, errors[2] = {0, 0}, lines = 0;
    memset(&desc, 0, sizeof desc);
    desc.positions = m.positions;
    desc.vertex_count = m.vertex_count;
    desc.indices = m.indices;
    desc.index_count = m.index_count;
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = sil_mesh_create(&desc, NULL);
    pose = sil_pose_create(mesh, NULL);
    if (!mesh || !pose)
        exit(1);
    p = publish(mesh);
    maps[0] = gauss_make(&p, 0);
    maps[1] = gauss_make(&p, 0.25);
    found = (uint32_t *)need(p.edge_count * sizeof *found);
    truth = (uint32_t *)need(p.edge_count * sizeof *truth);
    edges = (sil_edge *)need(p.edge_count * sizeof *edges);
    for (j = 0; j < 4; ++j)
        times[j] = (double *)need(views * sizeof(double));
    for (i = 0; i < views; ++i) {
        const double angle = 0.37 + 0.0175 * (double)i;
        const double toward[3] = {cos(angle), sin(angle), 0.4 * sin(0.3 * angle)};
        const vec d = {{toward[0], toward[1], toward[2]}};
        const sil_view view = sil_view_orthographic(toward);
        double start = now_ms();
        const size_t count = run_published(&p, mesh->rest.position, &view, truth);
        times[0][i] = now_ms() - start;
        for (j = 0; j < 2; ++j) {
            size_t here;
            start = now_ms();
            here = gauss_query(&maps[j], &p, d, found);
            times[1 + j][i] = now_ms() - start;
            here = differences(found, here, truth, count);
            errors[j] = here > errors[j] ? here : errors[j];
        }
        start = now_ms();
        (void)sil_extract(mesh, pose, &view, SIL_SILHOUETTE, edges, p.edge_count);
        times[3][i] = now_ms() - start;
        lines += count;
    }
    printf("%s: %zu faces, %zu edges, %zu silhouettes a view\n", m.name, mesh->face_count, p.edge_count, lines / views);
    gauss_print(&maps[0], "gauss");
    gauss_print(&maps[1], "overlap");
    {
        const double naive = median(times[0], views);
        row(csv, m.name, "published", &p, naive, p.bytes, 0, naive);
        row(csv, m.name, "gauss", &p, median(times[1], views), gauss_bytes(&maps[0]), errors[0], naive);
        row(csv, m.name, "overlap", &p, median(times[2], views), gauss_bytes(&maps[1]), errors[1], naive);
        row(csv, m.name, "hierarchy", &p, median(times[3], views), mesh->info.hierarchy_bytes, 0, naive);
    }
    compare_cones(&m, mesh, pose);
    gauss_free(&maps[0]);
    gauss_free(&maps[1]);
    for (j = 0; j < 4; ++j)
        free(times[j]);
    free(found);
    free(truth);
    free(edges);
    free(p.edges);
    free(p.normals);
    free(m.positions);
    free(m.indices);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
}

int main(int argc, char **argv) {
    const size_t views = is_quick() ? 31 : 101;
    FILE *csv = open_table(argc, argv, "build/bench/gauss_map.csv");
    model m = make_blob("gooch_sphere", 200, 198, 0); /* Gooch 1999, table 1: 78,804 faces */
    run_model(csv, m, views);
    m = make_shaft(103, 123); /* 24,999 */
    m.name = "gooch_s_crank";
    run_model(csv, m, views);
    m = make_shaft(290, 294); /* 169,999 */
    m.name = "gooch_l_crank";
    run_model(csv, m, views);
    run_model(csv, make_torus(800, 420), views);
    return close_table(csv);
}
