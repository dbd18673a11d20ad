/* The terms that a linearisation is the sum of. */
#include "physics/linearise/linearise-private.h"
#include "physics/model/points.h"

void tinker_linear_begin_term(const TinkerLinearisation *linear, GArray *terms, double weight)
{
    TinkerLinearTerm term = {weight, linear->entries->len, 0};
    g_array_append_val(terms, term);
}

void tinker_linear_add_entry(TinkerLinearisation *linear, GArray *terms, int32_t coordinate, double value)
{
    TinkerLinearEntry entry = {coordinate, value};
    if (value == 0) return;
    g_array_append_val(linear->entries, entry);
    g_array_index(terms, TinkerLinearTerm, terms->len - 1).count++;
}

void tinker_linear_add_point(TinkerLinearisation *linear, const TinkerModel *model, GArray *terms, int32_t point,
                             double x, double y)
{
    const double parts[2] = {x, y};
    for (int axis = 0; axis < 2; axis++) {
        TinkerCoordinateEntry entries[2];
        const int32_t count = tinker_model_point_entries(model, point, axis, entries);
        for (int32_t k = 0; k < count; k++)
            tinker_linear_add_entry(linear, terms, entries[k].coordinate, parts[axis] * entries[k].value);
    }
}
