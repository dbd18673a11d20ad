/* Hubs: bodies with so many rows that the products of every two of them would fill S. What the multipliers do to such a
 * body is left an unknown of its own, u = M_h^-1 J_h^T x, behind the multipliers:
 *
 *   (S'     J_h ) (x)   (b)
 *   (J_h^T  -M_h) (u) = (0),   S = S' + J_h M_h^-1 J_h^T,
 *
 * S' of all other bodies. A plank on a thousand links costs as much as a thousand links then, and what of its rows hang
 * on it alone shows in as many numbers as it has coordinates (tinker_constraints_count_dependent). */
#include "physics/compile/constraint-parts.h"
#include "physics/constraint/repeated-rows.h"
#include "physics/model/points.h"

/* Entries in the matrix: of fewer the products cost less than rows that are dependent without their hub. */
#define ENTRIES_OF_A_HUB 128

static int32_t entries_in_matrix(const TinkerConstraints *all, int32_t body)
{
    int32_t count = 0;
    for (int32_t p = all->body_starts[body]; p < all->body_starts[body + 1]; p++)
        count += !tinker_row_repeats(all, all->row_of[all->body_entries[p]]);
    return count;
}

gboolean tinker_constraints_find_hubs(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    for (int32_t i = 0; i < model->bodies; i++) {
        const int32_t entries = entries_in_matrix(all, i);
        if (entries < ENTRIES_OF_A_HUB) continue;
        if (all->hubs == NULL) all->hubs = g_try_new0(int32_t, model->bodies);
        if (all->hubs == NULL) return FALSE;
        all->hubs[i] = all->rows + all->border;
        all->border += tinker_model_turn_of(model, i) < 0 ? 2 : 3;
        all->hub_entry_count += 3 * entries;
    }
    if (all->border == 0) return TRUE;
    all->hub_entries = g_try_new0(TinkerHubEntry, all->hub_entry_count);
    all->hub_masses = g_try_new0(TinkerHubMass, all->border);
    all->bordered = g_try_new0(double, all->rows + all->border);
    all->hub_entry_count = 0;
    return all->hub_entries != NULL && all->hub_masses != NULL && all->bordered != NULL;
}

static void add_entry(TinkerConstraints *all, int32_t row, int32_t unknown, int32_t entry)
{
    all->hub_entries[all->hub_entry_count++] = (TinkerHubEntry){.row = row, .unknown = unknown, .entry = entry};
}

void tinker_constraints_list_hubs(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    for (int32_t i = 0; all->hubs != NULL && i < model->bodies; i++)
        for (int32_t p = all->body_starts[i]; all->hubs[i] > 0 && p < all->body_starts[i + 1]; p++) {
            const int32_t entry = all->body_entries[p], row = all->row_of[entry];
            if (tinker_row_repeats(all, row)) continue;
            for (int32_t k = 0; k < 2; k++)
                add_entry(all, row, all->hubs[i] + k, 2 * entry + k);
        }
    for (int32_t k = 0; all->hubs != NULL && k < all->turn_count; k++) {
        const int32_t body = all->points[all->turns[k].entry], row = all->turns[k].row;
        if (all->hubs[body] > 0 && !tinker_row_repeats(all, row))
            add_entry(all, row, all->hubs[body] + 2, 2 * all->entries + k);
    }
}

void tinker_constraints_place_hubs(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    for (int32_t k = 0; k < all->hub_entry_count; k++) {
        TinkerHubEntry *of = &all->hub_entries[k];
        of->slot = tinker_sparse_ldl_slot(all->ldl, of->row, of->unknown);
    }
    for (int32_t i = 0; all->hubs != NULL && i < model->bodies; i++)
        for (int32_t k = 0; all->hubs[i] > 0 && k < (tinker_model_turn_of(model, i) < 0 ? 2 : 3); k++) {
            const int32_t unknown = all->hubs[i] + k;
            all->hub_masses[unknown - all->rows] =
                (TinkerHubMass){tinker_sparse_ldl_slot(all->ldl, unknown, unknown), model->mass[i]};
        }
}
