/* What <windows.h>, <X11/X.h> and leak checkers define, and what their users therefore include before our headers. */
#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#ifdef __cplusplus
#include <cmath>
#include <cstdlib>
#include <cstring>
#endif

#define near
#define far
#define None 0L
#define Status int
#define Bool int
#define Always 2
#define Success 0
#define True 1
#define False 0
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define NEAR
#define FAR
#define IN
#define OUT
#define CONST const
#define ERROR 0
#define NO_ERROR 0L
#define OPAQUE 2
#define TRANSPARENT 1
#define ABSOLUTE 1
#define RELATIVE 2
#define DIFFERENCE 11
#define STRICT 1
#define interface struct
#define small char
#define malloc(size) hostile_malloc(size, __FILE__, __LINE__)
#define free(block) hostile_free(block)
#define I _Complex_I

#ifdef __cplusplus
extern "C" {
#endif
void *hostile_malloc(size_t size, const char *file, int line);
void hostile_free(void *block);
#ifdef __cplusplus
}
#endif
