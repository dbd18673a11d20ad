/* Lines of masses for the exact method, all numbers from a seed. */
#ifndef TEST_LINEAR_RECIPE_H
#define TEST_LINEAR_RECIPE_H

#include "linear-case.h"

typedef struct {
    int32_t size;
    gboolean rayleigh, held, drag, signals;
    double stiffest;
} Recipe;

/* A line with some cross links. */
void recipe_cook(LinearCase *test, const Recipe *recipe, guint32 seed);

/* A case that stands by itself. */
void recipe_copy_case(LinearCase *to, const LinearCase *from);

#endif
