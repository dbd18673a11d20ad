/* The derivatives of a linear form, which are constants. */
#include <string.h>

#include "physics/line/linear-form-data.h"
#include "physics/line/linear-form.h"

/* One place of the matrices before equal ones are added up. */
typedef struct {
    int32_t row, column;
    double stiffness, damping;
} Place;

static int compare_places(const void *left, const void *right)
{
    const Place *l = left, *r = right;
    if (l->row != r->row) return l->row < r->row ? -1 : 1;
    return (l->column > r->column) - (l->column < r->column);
}

static void add_place(GArray *places, int32_t row, int32_t column, double stiffness, double damping)
{
    Place place = {row, column, stiffness, damping};
    if (row >= 0 && column >= 0) g_array_append_val(places, place);
}

static GArray *collect_places(const TinkerLinearSystem *system)
{
    GArray *places = g_array_new(FALSE, FALSE, sizeof(Place));
    for (int32_t i = 0; i < system->size; i++)
        add_place(places, i, i, 0, system->drag != NULL ? system->drag[i] : 0);
    for (int32_t i = 0; i < system->edge_count; i++) {
        const TinkerLinearEdge *edge = &system->edges[i];
        add_place(places, edge->a, edge->a, edge->stiffness, edge->damping);
        add_place(places, edge->b, edge->b, edge->stiffness, edge->damping);
        add_place(places, edge->a, edge->b, -edge->stiffness, -edge->damping);
        add_place(places, edge->b, edge->a, -edge->stiffness, -edge->damping);
    }
    g_array_sort(places, compare_places);
    return places;
}

void tinker_linear_form_differentiate(TinkerLinearForm *form)
{
    if (form->columns != NULL) return;
    const TinkerLinearSystem *system = &form->system;
    g_autoptr(GArray) places = collect_places(system);
    form->row_starts = g_new0(int32_t, system->size + 1);
    form->columns = g_new0(int32_t, places->len + 1);
    form->stiffness = g_new0(double, places->len + 1);
    form->damping = g_new0(double, places->len + 1);
    int32_t entries = 0;
    for (guint i = 0; i < places->len; i++) {
        const Place *place = &g_array_index(places, Place, i);
        gboolean again = i > 0 && compare_places(place - 1, place) == 0;
        if (!again) {
            form->columns[entries++] = place->column;
            form->row_starts[place->row + 1] = entries;
        }
        form->stiffness[entries - 1] += place->stiffness;
        form->damping[entries - 1] += place->damping;
    }
    form->pattern = (TinkerPattern){system->size, entries, form->row_starts, form->columns};
}
