/* A library that could be any other BLAS: it has none of its functions, and ends the program that loads it. */
#include <stdlib.h>

__attribute__((constructor)) static void refuse(void)
{
    abort();
}
