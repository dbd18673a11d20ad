/* Rows of constraints in the factor that pile-direct.c solves with: over all bodies that they hold, always guessed to
 * act. What it leaves of them is solved exactly afterwards (pile-joints.c). */
#include "physics/constraint/constraints.h"
#include "physics/impulse/pile.h"
#include "physics/model/points.h"

/* K over the mass that a row moves: long chains are soft beside one of their rows. */
#define STIFF 1e8

/* The unknown of a coordinate; -1: of a support. */
static int32_t unknown_of(const TinkerPile *pile, int32_t coordinate)
{
    const TinkerModel *model = pile->model;
    if (coordinate >= model->coordinates) return -1;
    const int32_t body = tinker_model_moved_by(model, coordinate);
    return 3 * pile->direct->number[body] + (coordinate < 2 * model->bodies ? coordinate % 2 : 2);
}

/* A row as it was evaluated last, each unknown once; answers how many there are. */
static int32_t list_row(const TinkerPile *pile, int32_t row, TinkerCoordinateEntry *list)
{
    const int32_t count = tinker_constraints_list_row(&pile->model->constraints, row, list);
    int32_t kept = 0;
    for (int32_t i = 0; i < count; i++) {
        const TinkerCoordinateEntry entry = {unknown_of(pile, list[i].coordinate), list[i].value};
        int32_t at = 0;
        if (entry.coordinate < 0) continue;
        while (at < kept && list[at].coordinate != entry.coordinate)
            at++;
        if (at == kept) list[kept++] = (TinkerCoordinateEntry){entry.coordinate, 0};
        list[at].value += entry.value;
    }
    return kept;
}

TinkerPileTied *tinker_pile_tied_new(const TinkerPile *pile)
{
    const TinkerConstraints *all = &pile->model->constraints;
    g_autofree TinkerCoordinateEntry *list = tinker_constraints_row_room(all);
    TinkerPileTied *tied = g_new0(TinkerPileTied, 1);
    tied->rows = g_array_new(FALSE, TRUE, sizeof(TinkerPileTiedRow));
    gsize entries = 0, slots = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        if (!pile->joints->has[row]) continue;
        const gsize count = (gsize)list_row(pile, row, list);
        const TinkerPileTiedRow next = {.row = row, .count = (int32_t)count, .first = entries, .first_slot = slots};
        g_array_append_val(tied->rows, next);
        entries += count;
        slots += count * (count + 1) / 2;
    }
    tied->entries = g_new0(TinkerCoordinateEntry, MAX(entries, 1));
    tied->slots = g_new0(int32_t, MAX(slots, 1));
    tied->slot_count = slots;
    tied->room = g_steal_pointer(&list);
    return tied;
}

void tinker_pile_tied_free(TinkerPileTied *tied)
{
    if (tied == NULL) return;
    g_array_unref(tied->rows);
    g_free(tied->entries);
    g_free(tied->slots);
    g_free(tied->room);
    g_free(tied);
}

static TinkerPileTiedRow *tied_row(const TinkerPileTied *tied, guint number)
{
    return &g_array_index(tied->rows, TinkerPileTiedRow, number);
}

/* Takes the rows as they were evaluated last. */
static void take_rows(const TinkerPile *pile)
{
    TinkerPileTied *tied = pile->direct->tied;
    for (guint i = 0; i < tied->rows->len; i++) {
        TinkerPileTiedRow *row = tied_row(tied, i);
        double moves = 0;
        list_row(pile, row->row, tied->room);
        for (int32_t k = 0; k < row->count; k++) {
            const TinkerCoordinateEntry *entry = &tied->room[k];
            tied->entries[row->first + (gsize)k] = *entry;
            moves += entry->value * entry->value * pile->bodies[pile->solved[entry->coordinate / 3]].inverse_mass;
        }
        row->stiff = moves > 0 ? STIFF / moves : 0;
    }
}

gsize tinker_pile_tied_pattern(const TinkerPile *pile, int *rows, int *columns)
{
    const TinkerPileTied *tied = pile->direct->tied;
    gsize count = 0;
    take_rows(pile);
    for (guint i = 0; i < tied->rows->len; i++) {
        const TinkerCoordinateEntry *entries = tied->entries + tied_row(tied, i)->first;
        for (int32_t k = 0; k < tied_row(tied, i)->count; k++)
            for (int32_t l = 0; l < k; l++, count++) {
                rows[count] = entries[k].coordinate;
                columns[count] = entries[l].coordinate;
            }
    }
    return count;
}

void tinker_pile_tied_find_slots(const TinkerPile *pile)
{
    TinkerPileTied *tied = pile->direct->tied;
    for (guint i = 0; i < tied->rows->len; i++) {
        const TinkerPileTiedRow *row = tied_row(tied, i);
        const TinkerCoordinateEntry *entries = tied->entries + row->first;
        int32_t *slot = tied->slots + row->first_slot;
        for (int32_t k = 0; k < row->count; k++)
            for (int32_t l = 0; l <= k; l++)
                *slot++ = tinker_sparse_ldl_slot(pile->direct->ldl, entries[k].coordinate, entries[l].coordinate);
    }
}

void tinker_pile_tied_add_values(const TinkerPile *pile, double *values)
{
    TinkerPileTied *tied = pile->direct->tied;
    take_rows(pile);
    for (guint i = 0; i < tied->rows->len; i++) {
        const TinkerPileTiedRow *row = tied_row(tied, i);
        const TinkerCoordinateEntry *entries = tied->entries + row->first;
        const int32_t *slot = tied->slots + row->first_slot;
        for (int32_t k = 0; k < row->count; k++)
            for (int32_t l = 0; l <= k; l++)
                values[*slot++] += row->stiff * entries[k].value * entries[l].value;
    }
}

/* What a row misses of what is wanted, by the bodies' velocities and, where there is one, a change of all. */
static double misses(const TinkerPile *pile, const TinkerPileBody *bodies, const double *change,
                     const TinkerPileTiedRow *row)
{
    const TinkerCoordinateEntry *entries = pile->direct->tied->entries + row->first;
    double sum = -pile->joints->wanted[row->row];
    for (int32_t k = 0; k < row->count; k++) {
        const int32_t at = entries[k].coordinate;
        sum += entries[k].value * (bodies[pile->solved[at / 3]].v[at % 3] + (change != NULL ? change[at] : 0));
    }
    return sum;
}

void tinker_pile_tied_add_right(const TinkerPile *pile, double *right)
{
    const TinkerPileTied *tied = pile->direct->tied;
    for (guint i = 0; i < tied->rows->len; i++) {
        const TinkerPileTiedRow *row = tied_row(tied, i);
        const TinkerCoordinateEntry *entries = tied->entries + row->first;
        const double push = -row->stiff * misses(pile, pile->bodies, NULL, row);
        for (int32_t k = 0; k < row->count; k++)
            right[entries[k].coordinate] += push * entries[k].value;
    }
}

void tinker_pile_tied_take_solution(TinkerPile *pile, const double *change)
{
    const TinkerPileTied *tied = pile->direct->tied;
    for (guint i = 0; i < tied->rows->len; i++) {
        const TinkerPileTiedRow *row = tied_row(tied, i);
        const TinkerCoordinateEntry *entries = tied->entries + row->first;
        const double push = -row->stiff * misses(pile, pile->direct->bodies, change, row);
        for (int32_t k = 0; k < row->count; k++) {
            TinkerPileBody *body = &pile->bodies[pile->solved[entries[k].coordinate / 3]];
            body->v[entries[k].coordinate % 3] += body->inverse_mass * push * entries[k].value;
        }
    }
}
