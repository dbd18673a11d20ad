#include "linear-recipe.h"

#include <math.h>

void recipe_copy_case(LinearCase *to, const LinearCase *from)
{
    *to = *from;
    to->system.context = to;
    to->system.linear = &to->linear;
    to->system.mass = to->linear.mass = to->mass;
    to->linear.drag = to->drag;
    to->linear.edges = to->edges;
    to->linear.anchors = to->anchors;
    to->linear.loads = to->loads;
    to->linear.forces = to->forces;
    to->linear.motions = to->motions;
}

void recipe_cook(LinearCase *test, const Recipe *recipe, guint32 seed)
{
    g_autoptr(GRand) rand = g_rand_new_with_seed(seed);
    case_init(test, recipe->size);
    case_keep_books(test);
    int32_t moving = case_anchor(test, 0.25);
    for (int32_t i = 0; i < recipe->size; i++) {
        test->mass[i] = exp(g_rand_double_range(rand, -2.0, 2.0));
        test->drag[i] = recipe->drag ? test->mass[i] * (recipe->rayleigh ? 0.3 : g_rand_double(rand)) : 0.0;
        test->q[i] = 1.0 + i + g_rand_double_range(rand, -0.1, 0.1);
        test->v[i] = g_rand_double_range(rand, -0.3, 0.3);
    }
    for (int32_t i = 0; i < recipe->size; i++) {
        if (i == 0 && !recipe->held) continue;
        double k = i % 2 ? recipe->stiffest : exp(g_rand_double_range(rand, 1.0, 3.0));
        double c = recipe->rayleigh ? 0.01 * k : g_rand_double(rand);
        case_edge(test, i == 0 ? moving : i - 1, i, k, c)->length = 0.9;
    }
    if (recipe->size > 3) case_edge(test, 0, 3, 3.0, recipe->rayleigh ? 0.03 : 0.5)->length = 3.2;
    case_load(test, recipe->size - 1, 3, 0.7);
    case_load(test, 0, -1, -0.4);
    if (!recipe->signals) return;
    int32_t wave = case_harmonic(test, 0.3, 2.3, 0.2), ramp = case_polynomial(test, 0.1, -0.05, 0.02, 0.003);
    case_force(test, recipe->size - 1, wave, 4, 1.5);
    case_force(test, 0, wave, 5, -0.5);
    case_force(test, recipe->size / 2, ramp, 4, 0.8);
    case_motion(test, moving, case_harmonic(test, 0.05, 7.0, 1.0), 1.0);
    case_motion(test, moving, ramp, 0.1);
}
