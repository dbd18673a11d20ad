/* The pattern of the factor that pile-direct.c solves with: three coordinates a body, of pairs that are near. */
#include <string.h>

#include "numerics/solve/sparse-ldl.h"
#include "physics/impulse/pile.h"

/* Pairs for each body up to which a factor is worth while: of stacks and chains it is as sparse as they are; where more
 * are near, sweeps cost less. */
#define MOST_PAIRS 1.25
/* The same where constraints tie some of them together, which sweeps have to solve for each time. */
#define MOST_PAIRS_TIED 3

TinkerPileDirect *tinker_pile_direct_new(const TinkerPile *pile)
{
    const gsize shapes = (gsize)pile->shapes, bodies = (gsize)pile->solved_count;
    TinkerPileDirect *direct = g_new0(TinkerPileDirect, 1);
    direct->number = g_new(int32_t, shapes);
    for (gsize i = 0; i < shapes; i++)
        direct->number[i] = -1;
    for (int32_t i = 0; i < pile->solved_count; i++)
        direct->number[pile->solved[i]] = i;
    direct->diagonal = g_new0(int32_t, 6 * bodies);
    direct->right = g_new0(double, 3 * bodies);
    direct->bodies = g_new0(TinkerPileBody, shapes);
    return direct;
}

void tinker_pile_direct_free(TinkerPileDirect *direct)
{
    if (direct == NULL) return;
    tinker_sparse_ldl_free(direct->ldl);
    tinker_pile_tied_free(direct->tied);
    gpointer arrays[] = {direct->number, direct->diagonal, direct->between,
                         direct->right,  direct->guess,    direct->bodies};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(direct);
}

void tinker_pile_direct_forget(TinkerPileDirect *direct)
{
    tinker_sparse_ldl_free(direct->ldl);
    direct->ldl = NULL;
    direct->tried = FALSE;
}

/* The pattern of what is near. */
static void open_pattern(TinkerPile *pile)
{
    TinkerPileDirect *direct = pile->direct;
    const gsize bodies = (gsize)pile->solved_count;
    gsize pairs = 0, count = 0;
    direct->tried = TRUE;
    for (guint i = 0; i < pile->near->len; i++)
        pairs += g_array_index(pile->near, TinkerPileNear, i).second < pile->model->bodies;
    if ((double)pairs > (pile->joints != NULL ? MOST_PAIRS_TIED : MOST_PAIRS) * (double)bodies) return;
    const gsize most = 9 * pairs + 6 * bodies + (direct->tied != NULL ? direct->tied->slot_count : 0);
    g_autofree int *rows = g_new(int, most), *columns = g_new(int, most);
    for (gsize i = 0; i < bodies; i++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < r; c++, count++) {
                rows[count] = (int)(3 * i) + r;
                columns[count] = (int)(3 * i) + c;
            }
    for (guint i = 0; i < pile->near->len; i++) {
        const TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, i);
        if (near->second >= pile->model->bodies) continue;
        for (int k = 0; k < 9; k++, count++) {
            rows[count] = 3 * direct->number[near->first] + k / 3;
            columns[count] = 3 * direct->number[near->second] + k % 3;
        }
    }
    if (direct->tied != NULL) count += tinker_pile_tied_pattern(pile, rows + count, columns + count);
    direct->ldl = tinker_sparse_ldl_new(3 * pile->solved_count, rows, columns, count);
    if (direct->ldl == NULL) return;
    if (direct->tied != NULL) tinker_pile_tied_find_slots(pile);
    for (gsize i = 0; i < bodies; i++)
        for (int r = 0, k = 0; r < 3; r++)
            for (int c = 0; c <= r; c++, k++)
                direct->diagonal[6 * i + (gsize)k] =
                    tinker_sparse_ldl_slot(direct->ldl, (int)(3 * i) + r, (int)(3 * i) + c);
    if (9 * pile->near->len > direct->between_size) {
        direct->between_size = 18 * (gsize)pile->near->len;
        direct->between = g_renew(int32_t, direct->between, direct->between_size);
    }
    for (guint i = 0; i < pile->near->len; i++) {
        const TinkerPileNear *near = &g_array_index(pile->near, TinkerPileNear, i);
        for (int k = 0; near->second < pile->model->bodies && k < 9; k++)
            direct->between[9 * i + (guint)k] = tinker_sparse_ldl_slot(
                direct->ldl, 3 * direct->number[near->first] + k / 3, 3 * direct->number[near->second] + k % 3);
    }
}

gboolean tinker_pile_has_direct(TinkerPile *pile)
{
    if (!pile->direct->tried) open_pattern(pile);
    return pile->direct->ldl != NULL;
}
