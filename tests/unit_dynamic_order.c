/* The order of painting of TR_SEE_SEQUENCE and the runs of masks, without GL: against qsort and by what must hold. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"

enum { COUNT = 400 };

static uint64_t dice = 1;

static double throw_dice(double low, double high) {
    dice = dice * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(dice >> 11) / 9007199254740992.0;
}

static tr_i_rank ranks[COUNT];

/* Many ties of every kind. */
static void throw_ranks(void) {
    memset(ranks, 0, sizeof ranks);
    for (uint32_t i = 0; i < COUNT; ++i) {
        ranks[i].depth = (double)(int)throw_dice(0, 12);
        ranks[i].id = (uint32_t)throw_dice(0, 200);
        ranks[i].lowest = ranks[i].id;
        ranks[i].group = (uint32_t)throw_dice(0, 30);
        ranks[i].rank = (int32_t)throw_dice(-2, 3);
        ranks[i].backdrop = throw_dice(0, 1) < 0.1;
    }
}

/* The reference's comparison, once more: farthest first, and so on. */
static int compare(const void *left, const void *right) {
    uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;
    const tr_i_rank *p = &ranks[a], *q = &ranks[b];
    if (p->backdrop != q->backdrop)
        return p->backdrop ? -1 : 1;
    if (p->depth < q->depth || p->depth > q->depth)
        return p->depth > q->depth ? -1 : 1;
    if (p->lowest != q->lowest)
        return p->lowest > q->lowest ? -1 : 1;
    if (p->rank != q->rank)
        return p->rank < q->rank ? -1 : 1;
    if (p->id != q->id)
        return p->id > q->id ? -1 : 1;
    return a > b ? -1 : a < b;
}

static void order_is_that_of_qsort(void **state) {
    uint32_t kept[COUNT], sorted[COUNT];
    (void)state;
    for (uint32_t i = 0; i < COUNT; ++i)
        kept[i] = i;
    for (int frame = 0; frame < 200; ++frame) {
        if (frame % 20 == 0)
            throw_ranks(); /* nothing is as it was: the heap */
        else               /* a few have moved: insertion */
            for (int k = 0; k < 5; ++k)
                ranks[(int)throw_dice(0, COUNT)].depth += throw_dice(-1, 1);
        for (uint32_t i = 0; i < COUNT; ++i)
            sorted[i] = i;
        qsort(sorted, COUNT, sizeof sorted[0], compare);
        tr_i_sort_coherently(ranks, tr_i_before_in_painting, kept, COUNT);
        assert_memory_equal(kept, sorted, sizeof sorted);
    }
}

static void groups_have_the_mean_of_their_middles(void **state) {
    uint32_t order[COUNT];
    tr_i_rank before[COUNT];
    (void)state;
    throw_ranks();
    memcpy(before, ranks, sizeof before);
    for (uint32_t i = 0; i < COUNT; ++i)
        order[i] = i;
    tr_i_sort_coherently(ranks, tr_i_before_in_groups, order, COUNT);
    tr_i_join_groups(ranks, order, COUNT);
    for (size_t i = 0; i < COUNT; ++i) {
        double sum = 0, members = 0;
        uint32_t lowest = UINT32_MAX;
        for (size_t k = 0; k < COUNT; ++k)
            if (k == i || (before[i].group && before[k].group == before[i].group)) {
                sum += before[k].depth;
                members += 1;
                lowest = before[k].id < lowest ? before[k].id : lowest;
            }
        assert_true(fabs(ranks[i].depth - sum / members) < 1e-9);
        assert_int_equal(ranks[i].lowest, lowest);
    }
}

static void bad_middles_come_first(void **state) {
    float view[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1};
    tr_unit unit;
    (void)state;
    memset(&unit, 0, sizeof unit);
    unit.center[2] = -2;
    assert_true(tr_i_middle(view, &unit) == 7);
    unit.center[1] = (float)NAN;
    assert_true(tr_i_middle(view, &unit) == TR_I_FARTHEST);
    unit.center[1] = (float)INFINITY;
    assert_true(tr_i_middle(view, &unit) == TR_I_FARTHEST);
}

static void runs_hold_masks_that_do_not_overlap(void **state) {
    static tr_i_mask masks[COUNT];
    tr_i_sequence seq;
    (void)state;
    for (int round = 0; round < 20; ++round) {
        int side = round % 2 ? 60 : 4; /* few, and more than there is room for in a run */
        uint32_t members[COUNT] = {0};
        memset(&seq, 0, sizeof seq);
        memset(masks, 0, sizeof masks);
        seq.masks.items = masks;
        for (size_t i = 0; i < COUNT; ++i) {
            int x = (int)throw_dice(0, 2000), y = (int)throw_dice(0, 2000);
            const int box[4] = {x, y, x + 1 + (int)throw_dice(0, side), y + 1 + (int)throw_dice(0, side)};
            memcpy(masks[i].box, box, sizeof box);
            seq.masks.count = i + 1;
            masks[i].run = tr_i_find_run(&seq, i);
            ++members[masks[i].run];
        }
        for (size_t i = 0; i < COUNT; ++i) {
            assert_true(members[i] <= TR_I_RUN);
            for (size_t k = 0; k < i; ++k) {
                const int *a = masks[i].box, *b = masks[k].box;
                bool overlap = false; /* by the definition: some pixel lies in both */
                for (int x = a[0]; x < a[2] && !overlap; ++x)
                    for (int y = a[1]; y < a[3] && !overlap; ++y)
                        overlap = x >= b[0] && x < b[2] && y >= b[1] && y < b[3];
                assert_true(overlap == (tr_i_boxes_meet(a, b) != 0));
                assert_false(overlap && masks[i].run == masks[k].run);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_is_that_of_qsort),
        cmocka_unit_test(groups_have_the_mean_of_their_middles),
        cmocka_unit_test(bad_middles_come_first),
        cmocka_unit_test(runs_hold_masks_that_do_not_overlap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
