/* The models from formulas are what they are said to be: the clean ones closed, facing outward and not running into one
 * another, the dirty ones dirty in their own way. And the scene functions that make them. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "models.h"
#include "scene.h"

static bool is_dirty(const char *name) {
    return strncmp(name, "dirty_", 6) == 0;
}

/* Surfaces without an inside, or, of the bottle, without two sides. */
static bool is_sheet(const char *name) {
    static const char *const sheets[] = {"squares", "cylinders", "klein_bottle", "stream_surface"};
    for (size_t i = 0; i < sizeof sheets / sizeof *sheets; i++)
        if (strcmp(name, sheets[i]) == 0)
            return true;
    return false;
}

static bool is_solid(const char *name) {
    return !is_dirty(name) && !is_sheet(name);
}

static scene *make(const char *name) {
    scene *s = models_make(name);
    if (!s)
        fail_msg("model %s cannot be made", name);
    return s;
}

static const scene_part *find(const scene *s, const char *name) {
    size_t part = scene_find_part(s, name);
    if (part == SIZE_MAX)
        fail_msg("no part %s", name);
    return &s->parts[part];
}

static void subtract(const double a[3], const double b[3], double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void corner(const scene_mesh *mesh, size_t index, double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = (double)mesh->positions[3 * (size_t)mesh->indices[index] + i];
}

static void face_normal(const scene_mesh *mesh, size_t face, double normal[3]) {
    double p[3][3], u[3], v[3];
    for (size_t i = 0; i < 3; i++)
        corner(mesh, 3 * face + i, p[i]);
    subtract(p[1], p[0], u);
    subtract(p[2], p[0], v);
    cross(u, v, normal);
}

/* ---- what holds for every model -------------------------------------------------------------------------- */

static void check_mesh(const scene_mesh *mesh) {
    assert_true(mesh->index_count > 0 && mesh->index_count % 3 == 0);
    for (size_t i = 0; i < mesh->index_count; i++)
        assert_true(mesh->indices[i] < mesh->vertex_count);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double length = 0;
        for (size_t k = 0; k < 3; k++) {
            assert_true(isfinite(mesh->positions[3 * i + k]));
            length += (double)mesh->normals[3 * i + k] * (double)mesh->normals[3 * i + k];
        }
        assert_true(fabs(length - 1) < 1e-5);
    }
}

static void check_part(const scene *s, const scene_part *part, const char *model) {
    size_t length = strlen(model);
    assert_true(part->mesh < s->mesh_count);
    assert_true(strncmp(part->name, model, length) == 0 && (part->name[length] == '/' || part->name[length] == '\0'));
    for (size_t k = 0; k < 3; k++) /* clear, but never at full strength */
        assert_true(part->color[k] > 0.2f && part->color[k] < 0.9f);
    assert_true(part->opacity > 0 && part->opacity <= 1);
    const double *m = part->transform;
    double z[3];
    cross(&m[0], &m[4], z);
    assert_true(fabs(dot(z, &m[8]) - 1) < 1e-12); /* turned and moved, not mirrored or scaled */
}

static void every_model_is_sound(void **state) {
    (void)state;
    for (size_t i = 0; models_names[i]; i++) {
        scene *s = make(models_names[i]);
        assert_true(s->part_count > 0);
        for (size_t j = 0; j < s->mesh_count; j++)
            check_mesh(&s->meshes[j]);
        for (size_t j = 0; j < s->part_count; j++)
            check_part(s, &s->parts[j], models_names[i]);
        scene_destroy(s);
    }
}

static void unknown_names_make_nothing(void **state) {
    (void)state;
    assert_null(models_make("teapot"));
    assert_null(models_make(""));
    assert_null(models_make("mu"));
}

static void clean_models_are_closed_and_face_outward(void **state) {
    (void)state;
    for (size_t i = 0; models_names[i]; i++) {
        scene *s = make(models_names[i]);
        for (size_t j = 0; is_solid(models_names[i]) && j < s->mesh_count; j++) {
            double volume = 0;
            if (!scene_mesh_closed(&s->meshes[j], &volume))
                fail_msg("%s is not closed", s->meshes[j].name);
            if (!(volume > 0))
                fail_msg("%s faces inward: volume %g", s->meshes[j].name, volume);
        }
        scene_destroy(s);
    }
}

/* A vertex normal never looks away from its triangle, and no triangle of a clean model lacks area. */
static void clean_normals_follow_their_faces(void **state) {
    (void)state;
    for (size_t i = 0; models_names[i]; i++) {
        scene *s = make(models_names[i]);
        for (size_t j = 0; !is_dirty(models_names[i]) && j < s->mesh_count; j++) {
            const scene_mesh *mesh = &s->meshes[j];
            for (size_t c = 0; c < mesh->index_count; c++) {
                double face[3], own[3];
                face_normal(mesh, c / 3, face);
                for (size_t k = 0; k < 3; k++)
                    own[k] = (double)mesh->normals[3 * (size_t)mesh->indices[c] + k];
                assert_true(dot(face, face) > 0);
                if (dot(face, own) < 0.7 * sqrt(dot(face, face)))
                    fail_msg("%s: a normal is far from that of triangle %zu", mesh->name, c / 3);
            }
        }
        scene_destroy(s);
    }
}

static size_t vertices_at(const scene_mesh *mesh, const float place[3]) {
    size_t count = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        count += memcmp(&mesh->positions[3 * i], place, 3 * sizeof *place) == 0;
    return count;
}

static void normals_are_smooth_on_round_and_sharp_on_square_things(void **state) {
    (void)state;
    scene *s = make("shells");
    const scene_mesh *ball = &s->meshes[find(s, "shells/outer")->mesh], *box = &s->meshes[find(s, "shells/core")->mesh];
    for (size_t i = 0; i < ball->vertex_count; i++)
        assert_int_equal(vertices_at(ball, &ball->positions[3 * i]), 1);
    for (size_t i = 0; i < box->vertex_count; i++)
        assert_int_equal(vertices_at(box, &box->positions[3 * i]), 3);
    scene_destroy(s);
}

/* ---- parts keep apart ------------------------------------------------------------------------------------ */

typedef struct world_triangle {
    double p[3][3], low[3], high[3];
    size_t part;
} world_triangle;

static void to_world(const scene_part *part, const double p[3], double out[3]) {
    const double *m = part->transform;
    for (size_t row = 0; row < 3; row++)
        out[row] = m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row];
}

static world_triangle world_triangle_of(const scene *s, size_t part, size_t face) {
    world_triangle t = {.part = part};
    for (size_t i = 0; i < 3; i++) {
        double p[3];
        corner(&s->meshes[s->parts[part].mesh], 3 * face + i, p);
        to_world(&s->parts[part], p, t.p[i]);
    }
    for (size_t k = 0; k < 3; k++) {
        t.low[k] = fmin(t.p[0][k], fmin(t.p[1][k], t.p[2][k]));
        t.high[k] = fmax(t.p[0][k], fmax(t.p[1][k], t.p[2][k]));
    }
    return t;
}

static double volume6(const double a[3], const double b[3], const double c[3], const double d[3]) {
    double u[3], v[3], w[3], n[3];
    subtract(b, a, u);
    subtract(c, a, v);
    subtract(d, a, w);
    cross(u, v, n);
    return dot(n, w);
}

/* Whether the segment goes through the inside of the triangle. */
static bool pierces(const double a[3], const double b[3], const world_triangle *t) {
    double above = volume6(t->p[0], t->p[1], t->p[2], a), below = volume6(t->p[0], t->p[1], t->p[2], b);
    if (!((above > 0 && below < 0) || (above < 0 && below > 0)))
        return false;
    double x = volume6(a, b, t->p[0], t->p[1]), y = volume6(a, b, t->p[1], t->p[2]),
           z = volume6(a, b, t->p[2], t->p[0]);
    return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
}

static bool intersect(const world_triangle *s, const world_triangle *t) {
    for (size_t k = 0; k < 3; k++)
        if (s->low[k] > t->high[k] || t->low[k] > s->high[k])
            return false;
    for (size_t i = 0; i < 3; i++)
        if (pierces(s->p[i], s->p[(i + 1) % 3], t) || pierces(t->p[i], t->p[(i + 1) % 3], s))
            return true;
    return false;
}

static int compare_low(const void *a, const void *b) {
    double x = ((const world_triangle *)a)->low[0], y = ((const world_triangle *)b)->low[0];
    return x < y ? -1 : x > y;
}

/* Calls for each pair of triangles of different parts that cross. */
static void for_each_crossing(const scene *s, void (*tell)(const scene *, size_t, size_t, void *), void *user) {
    size_t count = 0, filled = 0;
    for (size_t i = 0; i < s->part_count; i++)
        count += s->meshes[s->parts[i].mesh].index_count / 3;
    world_triangle *all = malloc(count * sizeof *all);
    assert_non_null(all);
    for (size_t i = 0; i < s->part_count; i++)
        for (size_t face = 0; face < s->meshes[s->parts[i].mesh].index_count / 3; face++)
            all[filled++] = world_triangle_of(s, i, face);
    qsort(all, count, sizeof *all, compare_low);
    for (size_t i = 0; i < count; i++)
        for (size_t j = i + 1; j < count && all[j].low[0] <= all[i].high[0]; j++)
            if (all[i].part != all[j].part && intersect(&all[i], &all[j]))
                tell(s, all[i].part, all[j].part, user);
    free(all);
}

static void count_crossing(const scene *s, size_t a, size_t b, void *user) {
    size_t *counts = user; /* of the crank's shaft with its cylinder, and of all others */
    const char *x = s->parts[a].name, *y = s->parts[b].name;
    bool meant = (strcmp(x, "crank/shaft") == 0 && strcmp(y, "crank/cylinder") == 0) ||
                 (strcmp(y, "crank/shaft") == 0 && strcmp(x, "crank/cylinder") == 0);
    counts[meant ? 0 : 1]++;
    if (!meant && counts[1] == 1)
        print_message("%s runs into %s\n", x, y);
}

static void parts_do_not_run_into_one_another(void **state) {
    static const char *const names[] = {"mug", "gearbox", "shells"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        scene *s = make(names[i]);
        size_t counts[2] = {0};
        for_each_crossing(s, count_crossing, counts);
        assert_int_equal(counts[1], 0);
        scene_destroy(s);
    }
}

static void of_the_crank_only_the_shaft_goes_through_the_cylinder(void **state) {
    (void)state;
    scene *s = make("crank");
    size_t counts[2] = {0};
    for_each_crossing(s, count_crossing, counts);
    assert_true(counts[0] > 20);
    assert_int_equal(counts[1], 0);
    scene_destroy(s);
}

/* ---- single models --------------------------------------------------------------------------------------- */

/* How often a ray from a point goes through a part's surface. */
static size_t hits(const scene *s, const scene_part *part, const double from[3], const double to[3]) {
    size_t count = 0, index = (size_t)(part - s->parts);
    for (size_t face = 0; face < s->meshes[part->mesh].index_count / 3; face++) {
        world_triangle t = world_triangle_of(s, index, face);
        count += pierces(from, to, &t);
    }
    return count;
}

static void the_mug_has_two_boundaries_around_its_box(void **state) {
    (void)state;
    scene *s = make("mug");
    const double side[2][3] = {{1.2345, -100, 30.123}, {1.2345, 100, 30.123}}; /* beside the handle */
    const double down[2][3] = {{20.3, 13.7, 200}, {20.3, 13.7, -100}};
    const double handle[2][3] = {{100, 0.321, 51.2}, {45, 0.321, 51.2}};
    const scene_part *body = find(s, "mug/body"), *box = find(s, "mug/box");
    assert_int_equal(hits(s, body, side[0], side[1]), 4);
    assert_int_equal(hits(s, box, side[0], side[1]), 2);
    assert_int_equal(hits(s, body, down[0], down[1]), 2); /* open above, a floor below */
    assert_int_equal(hits(s, body, handle[0], handle[1]), 2);
    assert_true(body->opacity < 1 && box->opacity == 1);
    scene_destroy(s);
}

static size_t triangles_of(const scene *s) {
    size_t count = 0;
    for (size_t i = 0; i < s->part_count; i++)
        count += s->meshes[s->parts[i].mesh].index_count / 3;
    return count;
}

static void bounds_of_part(scene *s, const scene_part *part, double low[3], double high[3]) {
    for (size_t i = 0; i < s->part_count; i++)
        s->parts[i].hidden = &s->parts[i] != part;
    assert_true(scene_bounds(s, low, high));
    for (size_t i = 0; i < s->part_count; i++)
        s->parts[i].hidden = false;
}

static void the_gearbox_is_an_assembly(void **state) {
    (void)state;
    scene *s = make("gearbox");
    assert_true(s->part_count >= 20);
    assert_true(triangles_of(s) >= 20000);
    assert_int_equal(find(s, "gearbox/housing/bolt_front_1")->mesh, find(s, "gearbox/housing/bolt_back_14")->mesh);
    double outer_low[3], outer_high[3];
    bounds_of_part(s, find(s, "gearbox/housing/body"), outer_low, outer_high);
    size_t gears = 0;
    for (size_t i = 0; i < s->part_count; i++) {
        double low[3], high[3];
        if (!strstr(s->parts[i].name, "/gear_"))
            continue;
        gears++;
        bounds_of_part(s, &s->parts[i], low, high);
        for (size_t k = 0; k < 3; k++)
            assert_true(low[k] > outer_low[k] && high[k] < outer_high[k]);
    }
    assert_int_equal(gears, 8);
    scene_destroy(s);
}

static double tip_radius(const scene_mesh *mesh) {
    double radius = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        radius = fmax(radius, hypot((double)mesh->positions[3 * i], (double)mesh->positions[3 * i + 1]));
    return radius;
}

/* That they do not run into one another is tested above; here, that each reaches between the other's teeth. */
static void gears_mesh(void **state) {
    static const char *const pairs[4][2] = {{"gearbox/shaft_in/gear_1", "gearbox/layshaft/gear_1"},
                                            {"gearbox/shaft_in/gear_2", "gearbox/layshaft/gear_2"},
                                            {"gearbox/shaft_in/gear_3", "gearbox/layshaft/gear_3"},
                                            {"gearbox/layshaft/gear_4", "gearbox/shaft_out/gear_4"}};
    (void)state;
    scene *s = make("gearbox");
    for (size_t i = 0; i < 4; i++) {
        const scene_part *a = find(s, pairs[i][0]), *b = find(s, pairs[i][1]);
        double apart[3];
        subtract(&a->transform[12], &b->transform[12], apart);
        double overlap = tip_radius(&s->meshes[a->mesh]) + tip_radius(&s->meshes[b->mesh]) - sqrt(dot(apart, apart));
        assert_true(overlap > 3.9 && overlap < 4.1); /* twice the height above the pitch circle, which is one module */
    }
    scene_destroy(s);
}

/* ---- dirty models ---------------------------------------------------------------------------------------- */

typedef struct edge {
    uint32_t low, high;
    bool forward;
} edge;

typedef struct faults {
    size_t boundary, manifold, crowded, flipped; /* edges of one, of two, of more triangles; of two in one direction */
    size_t no_area, doubled;                     /* triangles */
} faults;

static int compare_edges(const void *a, const void *b) {
    const edge *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    return x->high < y->high ? -1 : x->high > y->high;
}

static void count_edges(const scene_mesh *mesh, const uint32_t *places, faults *found) {
    edge *edges = malloc(mesh->index_count * sizeof *edges);
    size_t count = 0;
    assert_non_null(edges);
    for (size_t i = 0; i < mesh->index_count; i++) {
        uint32_t a = places[mesh->indices[i]], b = places[mesh->indices[i % 3 == 2 ? i - 2 : i + 1]];
        if (a != b)
            edges[count++] = (edge){a < b ? a : b, a < b ? b : a, a < b};
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (size_t i = 0, end; i < count; i = end) {
        for (end = i + 1; end < count && compare_edges(&edges[i], &edges[end]) == 0;)
            end++;
        found->boundary += end - i == 1;
        found->manifold += end - i == 2;
        found->crowded += end - i > 2;
        found->flipped += end - i == 2 && edges[i].forward == edges[i + 1].forward;
    }
    free(edges);
}

static bool opposite(const uint32_t *places, const uint32_t *a, const uint32_t *b) {
    for (size_t i = 0; i < 3; i++)
        if (places[a[0]] == places[b[i]] && places[a[1]] == places[b[(i + 2) % 3]] &&
            places[a[2]] == places[b[(i + 1) % 3]])
            return true;
    return false;
}

static faults faults_of(const scene_mesh *mesh) {
    faults found = {0};
    uint32_t *places = malloc(mesh->vertex_count * sizeof *places);
    assert_non_null(places);
    assert_true(scene_weld(mesh->positions, mesh->vertex_count, places) <= mesh->vertex_count);
    count_edges(mesh, places, &found);
    for (size_t face = 0; face < mesh->index_count / 3; face++) {
        double normal[3];
        face_normal(mesh, face, normal);
        found.no_area += dot(normal, normal) < 1e-18;
        bool doubled = false;
        for (size_t other = 0; !doubled && other < mesh->index_count / 3; other++)
            doubled = other != face && opposite(places, &mesh->indices[3 * face], &mesh->indices[3 * other]);
        found.doubled += doubled;
    }
    free(places);
    return found;
}

static faults faults_in(const char *model, const char *part) {
    scene *s = make(model);
    faults found = faults_of(&s->meshes[find(s, part)->mesh]);
    scene_destroy(s);
    return found;
}

static void dirty_open_has_boundaries(void **state) {
    (void)state;
    faults half = faults_in("dirty_open", "dirty_open/outer_half"),
           sleeve = faults_in("dirty_open", "dirty_open/sleeve");
    assert_int_equal(half.boundary, 64);
    assert_int_equal(sleeve.boundary, 2 * 48);
    assert_int_equal(half.crowded + half.flipped + half.no_area + half.doubled, 0);
}

static void dirty_doubled_has_every_face_twice(void **state) {
    (void)state;
    faults box = faults_in("dirty_doubled", "dirty_doubled/box");
    assert_int_equal(box.doubled, 24);
    assert_int_equal(box.crowded, 18); /* all edges of twelve triangles */
    assert_int_equal(box.boundary + box.manifold, 0);
}

static void dirty_degenerate_has_faces_without_area_and_t_junctions(void **state) {
    (void)state;
    faults ball = faults_in("dirty_degenerate", "dirty_degenerate/sphere");
    assert_true(ball.no_area > 1000);
    assert_true(ball.boundary > 100); /* where the other side of an edge was not cut */
    assert_int_equal(ball.doubled, 0);
}

static void dirty_nonmanifold_has_crowded_edges(void **state) {
    (void)state;
    assert_int_equal(faults_in("dirty_nonmanifold", "dirty_nonmanifold/fins").crowded, 1);
    assert_int_equal(faults_in("dirty_nonmanifold", "dirty_nonmanifold/touching_boxes").crowded, 1);
    assert_int_equal(faults_in("dirty_nonmanifold", "dirty_nonmanifold/walled_box").crowded, 3); /* and a diagonal */
}

static void dirty_flipped_has_faces_inside_out_and_no_other_fault(void **state) {
    (void)state;
    faults ball = faults_in("dirty_flipped", "dirty_flipped/sphere"),
           box = faults_in("dirty_flipped", "dirty_flipped/box");
    assert_true(ball.flipped > 100);
    assert_true(box.flipped >= 4);
    assert_int_equal(ball.boundary + ball.crowded + ball.no_area + ball.doubled, 0);
    assert_int_equal(box.boundary + box.crowded + box.no_area + box.doubled, 0);
}

/* ---- sheets ---------------------------------------------------------------------------------------------- */

/* As faults_of, without the slow counts; and the longest edge, and whether both sides are to be seen. */
static faults edges_of_sheet(const char *model, const char *part, double *longest) {
    scene *s = make(model);
    const scene_mesh *mesh = &s->meshes[find(s, part)->mesh];
    faults found = {0};
    uint32_t *places = malloc(mesh->vertex_count * sizeof *places);
    assert_non_null(places);
    assert_true(scene_weld(mesh->positions, mesh->vertex_count, places) <= mesh->vertex_count);
    count_edges(mesh, places, &found);
    assert_true(mesh->two_sided);
    *longest = 0;
    for (size_t i = 0; i < mesh->index_count; i++) {
        double from[3], to[3], along[3];
        corner(mesh, i, from);
        corner(mesh, i % 3 == 2 ? i - 2 : i + 1, to);
        subtract(to, from, along);
        *longest = fmax(*longest, sqrt(dot(along, along)));
    }
    free(places);
    scene_destroy(s);
    return found;
}

static void sheets_have_the_boundaries_they_should(void **state) {
    (void)state;
    double longest;
    faults square = edges_of_sheet("squares", "squares/before", &longest);
    assert_int_equal(square.boundary, 4);
    assert_true(fabs(longest - 50 * sqrt(2)) < 1e-5);
    faults outer = edges_of_sheet("cylinders", "cylinders/outer", &longest);
    assert_int_equal(outer.boundary, 2 * 128);
    faults swept = edges_of_sheet("stream_surface", "stream_surface", &longest);
    assert_int_equal(swept.boundary, 2 * (479 + 159));
    printf("stream surface: longest edge %.2f\n", longest);
    assert_true(longest < 9); /* nowhere torn by the flow: it is 150 long */
    assert_int_equal(square.crowded + outer.crowded + swept.crowded, 0);
    assert_int_equal(square.flipped + outer.flipped + swept.flipped, 0);
}

/* Every edge has two faces, and yet they cannot all agree on a side. */
static void the_klein_bottle_is_closed_and_has_one_side(void **state) {
    (void)state;
    double longest;
    faults bottle = edges_of_sheet("klein_bottle", "klein_bottle", &longest);
    assert_int_equal(bottle.boundary + bottle.crowded, 0);
    assert_int_equal(bottle.manifold, 3 * 240 * 96);
    assert_int_equal(bottle.flipped, 96); /* one ring, where the tube meets itself turned over */
}

static void clean_parts_have_none_of_these(void **state) {
    (void)state;
    faults web = faults_in("crank", "crank/shaft"), core = faults_in("shells", "shells/core");
    assert_int_equal(web.boundary + web.crowded + web.flipped + web.no_area + web.doubled, 0);
    assert_int_equal(core.boundary + core.crowded + core.flipped + core.no_area + core.doubled, 0);
    assert_int_equal(core.manifold, 18);
}

/* ---- scene functions ------------------------------------------------------------------------------------- */

static void *copy_of(const void *bytes, size_t size) {
    void *copy = malloc(size);
    assert_non_null(copy);
    return memcpy(copy, bytes, size);
}

/* Four corners, each triangle with vertices of its own. */
static scene_mesh tetrahedron(void) {
    static const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const size_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    float positions[36], normals[36] = {0};
    uint32_t indices[12];
    for (size_t i = 0; i < 12; i++) {
        memcpy(&positions[3 * i], corners[faces[i]], sizeof corners[0]);
        indices[i] = (uint32_t)i;
    }
    for (size_t i = 0; i < 36; i++)
        if (positions[i] == 0 && i % 2)
            positions[i] = -0.0f; /* the same place as 0 */
    return (scene_mesh){.positions = copy_of(positions, sizeof positions),
                        .normals = copy_of(normals, sizeof normals),
                        .indices = copy_of(indices, sizeof indices),
                        .vertex_count = 12,
                        .index_count = 12};
}

static void free_arrays(scene_mesh *mesh) {
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->indices);
}

static void welding_finds_places(void **state) {
    (void)state;
    scene_mesh mesh = tetrahedron();
    uint32_t places[12];
    assert_int_equal(scene_weld(mesh.positions, 12, places), 4);
    assert_int_equal(places[0], places[3]);
    assert_int_equal(places[2], places[4]);
    assert_int_not_equal(places[0], places[1]);
    free_arrays(&mesh);
}

static void closedness_and_volume(void **state) {
    (void)state;
    scene_mesh mesh = tetrahedron();
    double volume;
    assert_true(scene_mesh_closed(&mesh, &volume));
    assert_true(fabs(volume - 1.0 / 6) < 1e-12);
    uint32_t kept = mesh.indices[10];
    mesh.indices[10] = mesh.indices[11];
    mesh.indices[11] = kept; /* one face inside out */
    assert_false(scene_mesh_closed(&mesh, NULL));
    mesh.index_count = 9; /* one face less */
    assert_false(scene_mesh_closed(&mesh, NULL));
    mesh.index_count = 0;
    assert_false(scene_mesh_closed(&mesh, NULL));
    free_arrays(&mesh);
}

static void normals_split_at_creases_only(void **state) {
    (void)state;
    scene_mesh sharp = tetrahedron(), smooth = tetrahedron();
    assert_true(scene_mesh_make_normals(&sharp, 35));
    assert_int_equal(sharp.vertex_count, 12);
    for (size_t face = 0; face < 4; face++)
        for (size_t i = 0; i < 3; i++) {
            double normal[3];
            face_normal(&sharp, face, normal);
            for (size_t k = 0; k < 3; k++)
                assert_true(fabs(normal[k] / sqrt(dot(normal, normal)) -
                                 (double)sharp.normals[3 * (size_t)sharp.indices[3 * face + i] + k]) < 1e-6);
        }
    assert_true(scene_mesh_make_normals(&smooth, 180));
    assert_int_equal(smooth.vertex_count, 4);
    for (size_t k = 0; k < 3; k++) /* at the origin, three equal faces meet */
        assert_true(fabs((double)smooth.normals[3 * (size_t)smooth.indices[0] + k] + 1 / sqrt(3)) < 1e-6);
    free_arrays(&sharp);
    free_arrays(&smooth);
}

/* Two sheets on one side of an edge, one inside out to the other: what lies on either is no continuation. */
static void normals_are_not_joined_across_flipped_neighbours(void **state) {
    (void)state;
    static const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0.1f};
    static const uint32_t indices[6] = {0, 1, 2, 0, 1, 3};
    scene_mesh mesh = {.positions = copy_of(positions, sizeof positions),
                       .indices = copy_of(indices, sizeof indices),
                       .vertex_count = 4,
                       .index_count = 6};
    assert_true(scene_mesh_make_normals(&mesh, 35));
    assert_int_equal(mesh.vertex_count, 6);
    free_arrays(&mesh);
}

static void vertices_that_are_equal_are_shared(void **state) {
    (void)state;
    scene_mesh mesh = tetrahedron();
    mesh.normals[0] = 1; /* one vertex at the origin differs from the two others there */
    assert_true(scene_mesh_share_vertices(&mesh));
    assert_int_equal(mesh.vertex_count, 5);
    assert_int_equal(mesh.indices[3], mesh.indices[6]);
    assert_int_not_equal(mesh.indices[0], mesh.indices[3]);
    double volume;
    assert_true(scene_mesh_closed(&mesh, &volume) && fabs(volume - 1.0 / 6) < 1e-12);
    free_arrays(&mesh);
}

static scene *tetrahedron_scene(int up_axis) {
    static const float grey[3] = {0.5f, 0.5f, 0.5f};
    scene *s = scene_create();
    assert_non_null(s);
    scene_mesh mesh = tetrahedron();
    assert_int_equal(scene_add_mesh(s, "mesh", &mesh), 0);
    double moved[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1};
    assert_int_equal(scene_add_part(s, "part", 0, moved, grey), 0);
    s->up_axis = up_axis;
    return s;
}

static void names_become_unique(void **state) {
    (void)state;
    scene *s = tetrahedron_scene(2);
    for (size_t i = 2; i < 3000; i++) {
        char expected[32];
        snprintf(expected, sizeof expected, "part#%zu", i);
        size_t part = scene_add_part(s, "part", 0, NULL, s->parts[0].color);
        assert_string_equal(s->parts[part].name, expected);
        assert_int_equal(scene_find_part(s, expected), part);
    }
    assert_int_equal(scene_find_part(s, "part#3000"), SIZE_MAX);
    scene_destroy(s);
}

static void merging_turns_and_names(void **state) {
    (void)state;
    scene *z_up = tetrahedron_scene(2);
    z_up->parts[0].opacity = 0.25f;
    scene *into = tetrahedron_scene(1);
    assert_true(scene_merge(into, z_up, "file"));
    assert_int_equal(into->part_count, 2);
    const scene_part *part = find(into, "file/part");
    assert_int_equal(part->mesh, 1);
    assert_true(part->opacity == 0.25f);
    double low[3], high[3];
    bounds_of_part(into, part, low, high);
    const double expected[2][3] = {{10, 30, -21}, {11, 31, -20}}; /* z is y now, and y points backward */
    for (size_t k = 0; k < 3; k++) {
        assert_true(fabs(low[k] - expected[0][k]) < 1e-12);
        assert_true(fabs(high[k] - expected[1][k]) < 1e-12);
    }
    scene_destroy(into);
}

static void bounds_leave_hidden_parts_out(void **state) {
    (void)state;
    scene *s = tetrahedron_scene(2);
    double low[3], high[3];
    assert_true(scene_bounds(s, low, high));
    assert_true(low[0] == 10 && high[0] == 11 && low[2] == 30 && high[2] == 31);
    s->parts[0].hidden = true;
    assert_false(scene_bounds(s, low, high));
    scene_destroy(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_model_is_sound),
        cmocka_unit_test(unknown_names_make_nothing),
        cmocka_unit_test(clean_models_are_closed_and_face_outward),
        cmocka_unit_test(clean_normals_follow_their_faces),
        cmocka_unit_test(normals_are_smooth_on_round_and_sharp_on_square_things),
        cmocka_unit_test(parts_do_not_run_into_one_another),
        cmocka_unit_test(of_the_crank_only_the_shaft_goes_through_the_cylinder),
        cmocka_unit_test(the_mug_has_two_boundaries_around_its_box),
        cmocka_unit_test(the_gearbox_is_an_assembly),
        cmocka_unit_test(gears_mesh),
        cmocka_unit_test(dirty_open_has_boundaries),
        cmocka_unit_test(dirty_doubled_has_every_face_twice),
        cmocka_unit_test(dirty_degenerate_has_faces_without_area_and_t_junctions),
        cmocka_unit_test(dirty_nonmanifold_has_crowded_edges),
        cmocka_unit_test(dirty_flipped_has_faces_inside_out_and_no_other_fault),
        cmocka_unit_test(clean_parts_have_none_of_these),
        cmocka_unit_test(sheets_have_the_boundaries_they_should),
        cmocka_unit_test(the_klein_bottle_is_closed_and_has_one_side),
        cmocka_unit_test(welding_finds_places),
        cmocka_unit_test(closedness_and_volume),
        cmocka_unit_test(normals_split_at_creases_only),
        cmocka_unit_test(normals_are_not_joined_across_flipped_neighbours),
        cmocka_unit_test(vertices_that_are_equal_are_shared),
        cmocka_unit_test(names_become_unique),
        cmocka_unit_test(merging_turns_and_names),
        cmocka_unit_test(bounds_leave_hidden_parts_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
