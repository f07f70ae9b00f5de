/* cc -std=c11 -O2 -I. bench/silhouette.c -o bench_silhouette -lm && ./bench_silhouette [FILE.csv]

   Time to find the silhouettes of one view, median over the views of a path, and of what comes after. The eye turns by one
   degree a frame, nearer and further away. Subjects:
     published  the papers' way: for each edge the product of its faces' signs, float normals, scalar code; it writes
                numbers of edges only
     brute      silhouette.h with a pose, made with SIL_MESH_NO_HIERARCHY: exact signs of all faces, then all patches
     hierarchy  the same by the hierarchy; bytes are those it adds
     tracker    sil_track by the hierarchy, with the edges that entered and left; bytes are those the pose keeps
   error_max is the largest number of edges, in every seventh view, that differ from those told one at a time.
   scene: _ortho are parallel views, _axes parallel ones along the axes. Subjects take turns, a path each, so that each
   finds in the caches what it left there itself. work `pose`: sil_pose_set and sil_extract of a moved mesh.
   BENCH=quick takes fewer views and leaves out 10^7 edges. BENCH_MESHES=FOLDER writes the meshes there for
   bench/vtk_feature_lines.py. The file is build/bench/silhouette.csv unless given; its folder must exist. */
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include "meshes.h"

/* How many indices are in one of two rising lists only. */
static size_t differing(const uint32_t *a, size_t a_count, const sil_edge *b, size_t b_count) {
    size_t i = 0, j = 0, both = 0;
    while (i < a_count && j < b_count) {
        both += a[i] == b[j].edge;
        if (a[i] < b[j].edge)
            ++i;
        else if (a[i] > b[j].edge)
            ++j;
        else {
            ++i;
            ++j;
        }
    }
    return a_count + b_count - 2 * both;
}

enum { PERSPECTIVE, PARALLEL, AXES };

/* View number i of a path that turns by `degrees` a view, or along the axes in turn. */
static sil_view view_number(size_t i, int kind, double degrees) {
    const double angle = 0.37 + degrees * SIL_I_PI / 180 * (double)i, radius = 3.5 + 1.5 * sin(0.21 * angle * 7);
    sil_view view;
    view.eye[0] = kind == AXES ? (double)(i % 3 == 0) : radius * cos(angle);
    view.eye[1] = kind == AXES ? (double)(i % 3 == 1) : radius * sin(angle);
    view.eye[2] = kind == AXES ? (double)(i % 3 == 2) : radius * 0.5 * sin(0.3 * angle);
    view.eye[3] = kind == PERSPECTIVE;
    return view;
}

static void report(FILE *csv, const char *work, const char *scene, size_t size, const char *subject, double ms,
                   size_t bytes, size_t errors, size_t found) {
    printf("%-8s %-17s %9zu  %-10s %9.4f ms %8.3f ns/edge %8.1f ns/line %11zu bytes  %zu edges differ\n", work, scene,
           size, subject, ms, 1e6 * ms / (double)size, found ? 1e6 * ms / (double)found : 0, bytes, errors);
    fprintf(csv, "%s,%s,%zu,%s,%.6f,%zu,%zu\n", work, scene, size, subject, ms, bytes, errors);
}

enum { PUBLISHED, BRUTE, HIERARCHY, TRACKER, SUBJECTS };
static const char *const subject_names[SUBJECTS] = {"published", "brute", "hierarchy", "tracker"};

/* Room for the answers of all views, taken once. */
typedef struct answers {
    uint32_t *found, *moved;
    sil_edge *edges, *truth;
    size_t room;
} answers;

static size_t answer(int subject, const published *p, sil_mesh *const meshes[2], sil_pose *const poses[2],
                     const sil_view *view, answers *a) {
    sil_changes changes;
    changes.entered = a->moved;
    changes.left = a->moved + a->room;
    changes.capacity = a->room;
    switch (subject) {
    case PUBLISHED:
        return run_published(p, meshes[0]->rest.position, view, a->found);
    case TRACKER:
        return sil_track(meshes[1], poses[1], view, SIL_SILHOUETTE, a->edges, a->room, &changes);
    default:
        return sil_extract(meshes[subject == HIERARCHY], poses[subject == HIERARCHY], view, SIL_SILHOUETTE, a->edges,
                           a->room);
    }
}

static size_t wrong_edges(int subject, sil_mesh *mesh, const sil_view *view, size_t count, answers *a) {
    const int wide = mesh->wide;
    size_t k, true_count;
    for (k = 0; k < count && subject != PUBLISHED; ++k)
        a->found[k] = a->edges[k].edge;
    mesh->wide = 0; /* without a pose and without vectors: face by face */
    true_count = sil_extract(mesh, NULL, view, SIL_SILHOUETTE, a->truth, a->room);
    mesh->wide = wide;
    return differing(a->found, count, a->truth, true_count);
}

/* meshes, poses: without and with a hierarchy. */
static void run_views(FILE *csv, const char *name, const published *p, sil_mesh *const meshes[2],
                      sil_pose *const poses[2], int kind, size_t views) {
    static const char *const suffix[3] = {"", "_ortho", "_axes"};
    const size_t size = meshes[0]->edge_count;
    double *times = (double *)need(views * sizeof(double)), medians[SUBJECTS];
    size_t i, found[SUBJECTS], errors[SUBJECTS] = {0}, bytes[SUBJECTS];
    char scene[64];
    answers a;
    int subject;
    a.room = size;
    a.found = (uint32_t *)need(3 * size * sizeof(uint32_t));
    a.moved = a.found + size;
    a.edges = (sil_edge *)need(size * sizeof(sil_edge));
    a.truth = (sil_edge *)need(size * sizeof(sil_edge));
    snprintf(scene, sizeof scene, "%s%s", name, suffix[kind]);
    for (subject = 0; subject < SUBJECTS; ++subject) {
        found[subject] = 0;
        for (i = 0; i < views; ++i) {
            const sil_view view = view_number(i, kind, 1);
            const double start = now_ms();
            const size_t count = answer(subject, p, meshes, poses, &view, &a);
            times[i] = now_ms() - start;
            found[subject] += count;
            if (i % 7 == 0) {
                const size_t wrong = wrong_edges(subject, meshes[0], &view, count, &a);
                errors[subject] = wrong > errors[subject] ? wrong : errors[subject];
            }
        }
        medians[subject] = median(times, views);
    }
    bytes[PUBLISHED] = p->bytes;
    bytes[BRUTE] = sil_mesh_get_info(meshes[0]).bytes + meshes[0]->face_count;
    bytes[HIERARCHY] = sil_mesh_get_info(meshes[1]).hierarchy_bytes;
    bytes[TRACKER] = poses[1]->tracked_capacity * sizeof(uint32_t);
    for (subject = 0; subject < SUBJECTS; ++subject)
        report(csv, "extract", scene, size, subject_names[subject], medians[subject], bytes[subject], errors[subject],
               found[subject] / views);
    printf(
        "  %zu silhouettes a view, %.2f %%; published / hierarchy %.1f, brute / hierarchy %.2f, published / brute %.1f\n",
        found[HIERARCHY] / views, 100.0 * (double)found[HIERARCHY] / (double)(views * size),
        medians[PUBLISHED] / medians[HIERARCHY], medians[BRUTE] / medians[HIERARCHY],
        medians[PUBLISHED] / medians[BRUTE]);
    free(times);
    free(a.found);
    free(a.edges);
    free(a.truth);
}

/* How far the eye may move before a face of the patch changes: the least distance to one of their planes. */
static double patch_slack(const sil_mesh *mesh, size_t patch, const double eye[3]) {
    const size_t places = sil_i_patch_places(mesh->patches, patch);
    double least = 1e9;
    size_t place;
    for (place = 0; place < places; ++place) {
        const uint32_t face = sil_i_face_at(mesh, patch, place);
        double t = -(double)mesh->rest.plane[3][face];
        int k;
        for (k = 0; k < 3; ++k)
            t += (double)mesh->rest.plane[k][face] * (eye[k] - mesh->rest.center[k]) / mesh->rest.scale;
        least = fmin(least, fabs(t));
    }
    return least * mesh->rest.scale;
}

/* What exact coherence could save at best: the patches whose deadline (in path length) passes in a frame, of which each
   would have to be looked at again, against those that the hierarchy looks at in that frame. */
static void run_deadlines(const sil_mesh *mesh, sil_pose *pose, const char *name) {
    static const double steps[4] = {0.05, 0.3, 1, 3};
    const size_t patches = mesh->patches->count, frames = 25;
    double *deadline = (double *)need(patches * sizeof(double));
    size_t step, frame, patch;
    for (step = 0; step < 4; ++step) {
        size_t due = 0, looked = 0;
        double path = 0, last[3] = {0, 0, 0};
        memset(deadline, 0, patches * sizeof(double));
        for (frame = 0; frame < frames; ++frame) {
            const sil_view view = view_number(frame, PERSPECTIVE, steps[step]);
            if (frame)
                path += sqrt((view.eye[0] - last[0]) * (view.eye[0] - last[0]) +
                             (view.eye[1] - last[1]) * (view.eye[1] - last[1]) +
                             (view.eye[2] - last[2]) * (view.eye[2] - last[2]));
            memcpy(last, view.eye, sizeof last);
            (void)sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0);
            looked += frame ? pose->looked : 0;
            for (patch = 0; patch < patches; ++patch)
                if (deadline[patch] <= path) {
                    deadline[patch] = path + patch_slack(mesh, patch, view.eye);
                    due += frame > 0;
                }
        }
        printf("  %s, %.2f degrees a frame: deadlines pass for %zu patches a frame, the hierarchy looks at %zu\n", name,
               steps[step], due / (frames - 1), looked / (frames - 1));
    }
    free(deadline);
}

static sil_ribbon_desc screen(void) {
    sil_ribbon_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.model_view[0] = desc.model_view[5] = desc.model_view[10] = desc.model_view[15] = 1;
    desc.model_view[14] = -4;
    desc.projection[0] = 1;
    desc.projection[5] = 1.5f;
    desc.projection[10] = -1.02f;
    desc.projection[11] = -1;
    desc.projection[14] = -0.2f;
    desc.viewport_width = 1280;
    desc.viewport_height = 853;
    return desc;
}

/* What comes after extraction, for one view; the median of nine runs each. Sizes: faces, edges, edges, and pairs of
   vertices and edges. */
static void run_rest(FILE *csv, const model *m, const sil_mesh *mesh, sil_pose *pose) {
    const sil_view view = view_number(1, PERSPECTIVE, 1);
    const sil_ribbon_desc desc = screen();
    sil_edge *edges = (sil_edge *)need(mesh->edge_count * sizeof *edges);
    const size_t count = sil_extract(mesh, pose, &view, SIL_SILHOUETTE, edges, mesh->edge_count);
    sil_strip *strips = (sil_strip *)need(count * sizeof *strips);
    uint32_t *vertices = (uint32_t *)need(2 * count * sizeof *vertices);
    float *distances = (float *)need(m->vertex_count * sizeof *distances);
    static const char *const work[4] = {"pose", "chain", "ribbons", "distances"};
    const size_t size[4] = {mesh->face_count, count, count, count * m->vertex_count};
    sil_ribbon_vertex *ribbons;
    double times[4][9];
    size_t i, strip_count, needed, room;
    int k;
    (void)sil_pose_reserve(pose, count);
    strip_count = sil_chain(mesh, pose, edges, count, strips, count, vertices, 2 * count, &needed);
    room = sil_ribbons(mesh, pose, strips, strip_count, vertices, &desc, NULL, 0);
    ribbons = (sil_ribbon_vertex *)need(room * sizeof *ribbons);
    for (i = 0; i < 9; ++i) {
        double at[5];
        at[0] = now_ms();
        (void)sil_pose_set(pose, m->positions, 0);
        at[1] = now_ms();
        (void)sil_chain(mesh, pose, edges, count, strips, count, vertices, 2 * count, &needed);
        at[2] = now_ms();
        (void)sil_ribbons(mesh, pose, strips, strip_count, vertices, &desc, ribbons, room);
        at[3] = now_ms();
        (void)sil_distances(mesh, pose, edges, count, NULL, 0, m->vertex_count, distances, NULL);
        at[4] = now_ms();
        for (k = 0; k < 4; ++k)
            times[k][i] = at[k + 1] - at[k];
    }
    (void)sil_pose_set(pose, NULL, 0);
    for (k = 0; k < 4; ++k) {
        qsort(times[k], 9, sizeof(double), compare_doubles);
        printf("%-12s %-12s %9lu  %-10s %9.3f ms\n", work[k], m->name, (unsigned long)size[k], "brute", times[k][4]);
        fprintf(csv, "%s,%s,%lu,brute,%.6f,0,0\n", work[k], m->name, (unsigned long)size[k], times[k][4]);
    }
    free(edges);
    free(strips);
    free(vertices);
    free(distances);
    free(ribbons);
}

/* A moved mesh, as skinning leaves it: new positions, then silhouettes, in every frame. */
static void run_pose(FILE *csv, const model *m, const sil_mesh *mesh, sil_pose *pose) {
    sil_edge *edges = (sil_edge *)need(mesh->edge_count * sizeof *edges);
    double set[9], extract[9];
    size_t i, count = 0;
    for (i = 0; i < 9; ++i) {
        const sil_view view = view_number(i, PERSPECTIVE, 1);
        const double start = now_ms();
        (void)sil_pose_set(pose, m->positions, 0);
        set[i] = now_ms() - start;
        count = sil_extract(mesh, pose, &view, SIL_SILHOUETTE, edges, mesh->edge_count);
        extract[i] = now_ms() - start - set[i];
    }
    (void)sil_pose_set(pose, NULL, 0);
    report(csv, "pose_set", m->name, mesh->edge_count, "brute", median(set, 9), 0, 0, count);
    report(csv, "pose_extract", m->name, mesh->edge_count, "brute", median(extract, 9), 0, 0, count);
    free(edges);
}

/* For bench/vtk_feature_lines.py: the numbers of vertices and triangles, then the arrays. */
static void write_mesh(const model *m) {
    const char *folder = getenv("BENCH_MESHES");
    const uint64_t counts[2] = {m->vertex_count, m->index_count / 3};
    char path[1024];
    FILE *file;
    if (!folder || m->index_count > 3000000)
        return;
    snprintf(path, sizeof path, "%s/%s_%zu.mesh", folder, m->name, m->index_count / 2);
    file = fopen(path, "wb");
    if (!file || fwrite(counts, sizeof counts, 1, file) != 1 ||
        fwrite(m->positions, 3 * sizeof(float), m->vertex_count, file) != m->vertex_count ||
        fwrite(m->indices, sizeof(uint32_t), m->index_count, file) != m->index_count || fclose(file) != 0) {
        fprintf(stderr, "benchmark: cannot write %s\n", path);
        exit(1);
    }
}

static void run_model(FILE *csv, model m, size_t views) {
    sil_mesh_desc desc;
    sil_mesh *meshes[2];
    sil_pose *poses[2];
    published p;
    size_t i;
    memset(&desc, 0, sizeof desc);
    desc.positions = m.positions;
    desc.vertex_count = m.vertex_count;
    desc.indices = m.indices;
    desc.index_count = m.index_count;
    write_mesh(&m);
    for (i = 0; i < 2; ++i) {
        const double start = now_ms();
        double ms;
        desc.flags = i ? SIL_MESH_HIERARCHY : SIL_MESH_NO_HIERARCHY;
        meshes[i] = sil_mesh_create(&desc, NULL);
        poses[i] = sil_pose_create(meshes[i], NULL);
        if (!meshes[i] || !poses[i]) {
            fputs("bench silhouette: out of memory\n", stderr);
            exit(1);
        }
        ms = now_ms() - start;
        report(csv, "create", m.name, meshes[i]->edge_count, i ? "hierarchy" : "brute", ms,
               sil_mesh_get_info(meshes[i]).bytes, 0, 0);
    }
    p = publish(meshes[0]);
    run_views(csv, m.name, &p, meshes, poses, PERSPECTIVE, views);
    run_views(csv, m.name, &p, meshes, poses, PARALLEL, views);
    run_views(csv, m.name, &p, meshes, poses, AXES, views / 3);
    if (m.index_count > 1500000 && m.index_count < 6000000 && strcmp(m.name, "shaft") != 0)
        run_deadlines(meshes[1], poses[1], m.name);
    run_pose(csv, &m, meshes[0], poses[0]);
    if (m.vertex_count < 100000 && m.vertex_count > 30000) /* all pairs of a larger one take too long */
        run_rest(csv, &m, meshes[0], poses[0]);
    free(p.edges);
    free(p.normals);
    for (i = 0; i < 2; ++i) {
        sil_pose_destroy(poses[i]);
        sil_mesh_destroy(meshes[i]);
    }
    free(m.positions);
    free(m.indices);
}

int main(int argc, char **argv) {
    static const size_t rings[4] = {80, 250, 800, 2580}, sides[4] = {42, 134, 420, 1292};
    static const size_t square[4] = {58, 183, 578, 1826}, cells[4] = {24, 76, 240, 745};
    const size_t views = is_quick() ? 31 : 101, sizes = is_quick() ? 3 : 4;
    FILE *csv = open_table(argc, argv, "build/bench/silhouette.csv");
    size_t i;
    model gooch;
    for (i = 0; i < sizes; ++i) {
        run_model(csv, make_torus(rings[i], sides[i]), views);
        run_model(csv, make_blob("blob", square[i], square[i], 0.1), views);
        run_model(csv, make_shaft(rings[i], sides[i]), views);
        run_model(csv, make_box(cells[i]), views);
        run_model(csv, make_blob("rough_blob", square[i], square[i], 0.3), views);
    }
    gooch = make_blob("gooch_sphere", 200, 198, 0); /* Gooch 1999, table 1: 78,804 faces */
    run_model(csv, gooch, views);
    gooch = make_shaft(103, 123); /* 24,999 */
    gooch.name = "gooch_s_crank";
    run_model(csv, gooch, views);
    gooch = make_shaft(290, 294); /* 169,999 */
    gooch.name = "gooch_l_crank";
    run_model(csv, gooch, views);
    return close_table(csv);
}
