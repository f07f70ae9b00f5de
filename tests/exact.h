/* exact.h: the truth about the signs of faces, by exact expansions of doubles (after Shewchuk 1997). Include it after
   cmocka.h. */
#ifndef GLASSINE_TESTS_EXACT_H
#define GLASSINE_TESTS_EXACT_H

#include <math.h>
#include <stddef.h>

/* ---- exact expansions: sums of doubles that do not overlap, the largest last ---- */

typedef struct expansion {
    double term[1200];
    size_t count;
} expansion;

static inline void two_sum(double a, double b, double *sum, double *error) {
    const volatile double s = a + b;
    const volatile double bv = s - a, av = s - bv;
    const volatile double bd = b - bv, ad = a - av;
    *sum = s;
    *error = ad + bd;
}

static inline void split(double a, double *high, double *low) {
    const volatile double c = 134217729.0 * a; /* 2^27 + 1 */
    const volatile double d = c - a;
    *high = c - d;
    *low = a - *high;
}

static inline void two_product(double a, double b, double *product, double *error) {
    const volatile double p = a * b;
    double ah, al, bh, bl;
    volatile double e;
    split(a, &ah, &al);
    split(b, &bh, &bl);
    e = p - ah * bh;
    e = e - al * bh;
    e = e - ah * bl;
    *product = p;
    *error = al * bl - e;
}

static inline void add_term(expansion *x, double b) {
    size_t i, kept = 0;
    double error;
    for (i = 0; i < x->count; ++i) {
        two_sum(b, x->term[i], &b, &error);
        if (error != 0)
            x->term[kept++] = error;
    }
    if (b != 0)
        x->term[kept++] = b;
    x->count = kept;
    assert_true(kept < 1200);
}

/* out += sign * a * b */
static inline void add_product(expansion *out, const expansion *a, const expansion *b, double sign) {
    size_t i, j;
    for (i = 0; i < a->count; ++i)
        for (j = 0; j < b->count; ++j) {
            double p, e;
            two_product(sign * a->term[i], b->term[j], &p, &e);
            add_term(out, e);
            add_term(out, p);
        }
}

static inline int sign_of(const expansion *x) {
    return x->count ? (x->term[x->count - 1] > 0 ? 1 : -1) : 0;
}

static inline expansion difference(double a, double b) {
    expansion x;
    x.count = 0;
    add_term(&x, a);
    add_term(&x, -b);
    return x;
}

/* det[b-a, c-a, e-w*a] for w 0 or 1, of floats and of eyes whose last bits are far above those that doubles lack. */
static inline int true_sign(const float *a, const float *b, const float *c, const double eye[4], size_t *exact) {
    expansion u[3], v[3], g[3], minor, det;
    long double d = 0, size = 0;
    int k;
    /* By long double where that is beyond doubt, even if it is no longer than double, as under valgrind. */
    for (k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const long double w = (long double)eye[3] * (long double)a[k], e = (long double)eye[k];
        const long double p = ((long double)b[i] - (long double)a[i]) * ((long double)c[j] - (long double)a[j]);
        const long double q = ((long double)b[j] - (long double)a[j]) * ((long double)c[i] - (long double)a[i]);
        d += (p - q) * (e - w);
        size += (fabsl(p) + fabsl(q)) * (fabsl(e) + fabsl(w));
    }
    if (fabsl(d) > 1e-14L * size)
        return d > 0 ? 1 : -1;
    ++*exact;
    for (k = 0; k < 3; ++k) {
        u[k] = difference((double)b[k], (double)a[k]);
        v[k] = difference((double)c[k], (double)a[k]);
        g[k] = difference(eye[k], eye[3] * (double)a[k]);
    }
    det.count = 0;
    for (k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        minor.count = 0;
        add_product(&minor, &u[i], &v[j], 1);
        add_product(&minor, &u[j], &v[i], -1);
        add_product(&det, &minor, &g[k], 1);
    }
    return sign_of(&det);
}

#endif
