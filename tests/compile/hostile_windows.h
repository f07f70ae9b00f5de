/* The real thing: everything that <windows.h> defines, min and max included. */
#include <windows.h>
