/* unit_extraction.c with the arithmetic that -ffast-math allows (gcc; other compilers run it as it is). */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "fast-math")
#endif
#include "unit_extraction.c"
