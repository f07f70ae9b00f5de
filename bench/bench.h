/* bench.h: what the benchmarks share: a clock, medians, memory that is there or ends the program, the table's file. */
#ifndef GLASSINE_BENCH_H
#define GLASSINE_BENCH_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static inline double now_ms(void) {
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return 1000.0 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static inline int compare_doubles(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* Of a number of them that is odd; sorts them. */
static inline double median(double *values, size_t count) {
    qsort(values, count, sizeof *values, compare_doubles);
    return values[count / 2];
}

static inline void *need(size_t size) {
    void *memory = malloc(size ? size : 1);
    if (!memory) {
        fputs("benchmark: out of memory\n", stderr);
        exit(1);
    }
    return memory;
}

/* BENCH=quick in the environment: a minute for all benchmarks. */
static inline bool is_quick(void) {
    const char *mode = getenv("BENCH");
    return mode && strcmp(mode, "quick") == 0;
}

/* The file named by the first argument, or `path`, with its head line. Its folder must exist. */
static inline FILE *open_table(int argc, char **argv, const char *path) {
    FILE *csv = fopen(argc > 1 ? argv[1] : path, "w");
    if (!csv) {
        fprintf(stderr, "benchmark: cannot write %s\n", argc > 1 ? argv[1] : path);
        exit(1);
    }
    fputs("work,scene,size,subject,milliseconds,bytes,error_max\n", csv);
    return csv;
}

static inline int close_table(FILE *csv) {
    if (fclose(csv) == 0)
        return 0;
    fputs("benchmark: the table could not be written\n", stderr);
    return 1;
}

#endif
