/* The jacobian of a model in which bodies turn, by coordinate: a place of such a body depends on its turn, too. */
#include "physics/constraint/constraints.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/system/jacobian-private.h"

int32_t tinker_jacobian_find_entry(const TinkerJacobian *self, int32_t row, int32_t column)
{
    int32_t low = self->row_starts[row], high = self->row_starts[row + 1];
    while (high - low > 1) {
        const int32_t middle = low + (high - low) / 2;
        if (self->columns[middle] > column)
            high = middle;
        else
            low = middle;
    }
    return low;
}

void tinker_jacobian_spread(const TinkerJacobian *self, double *values, int32_t on, int32_t of, double sign,
                            const double block[4])
{
    const TinkerModel *model = self->model;
    if (on >= model->first_support || of >= model->first_support) return;
    for (int k = 0; k < 4; k++) {
        TinkerCoordinateEntry rows[2], columns[2];
        const int32_t row_count = tinker_model_point_entries(model, on, k / 2, rows);
        const int32_t column_count = tinker_model_point_entries(model, of, k % 2, columns);
        for (int32_t r = 0; r < row_count; r++)
            for (int32_t c = 0; c < column_count; c++)
                values[tinker_jacobian_find_entry(self, rows[r].coordinate, columns[c].coordinate)] +=
                    sign * block[k] * rows[r].value * columns[c].value;
    }
}

/* The torque of a force F at the arm r changes as that turns: by -r . F an angle. */
TinkerStatus tinker_jacobian_add_turned_arms(TinkerJacobian *self)
{
    TinkerModel *model = self->model;
    const gint64 evaluations = model->evaluations;
    g_autofree double *a = g_new(double, model->coordinates);
    const TinkerStatus status = tinker_model_applied(model, a, FALSE);
    model->evaluations = evaluations;
    for (int32_t point = model->first_attachment; point < model->first_support; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        const double gyration = model->turns[model->turn_of[at->body]].gyration;
        const int32_t turn = tinker_model_turn_of(model, at->body);
        self->stiffness[tinker_jacobian_find_entry(self, turn, turn)] +=
            (at->arm[0] * at->force[0] + at->arm[1] * at->force[1]) / (gyration * gyration);
    }
    return status;
}

void tinker_jacobian_add_row_mass(const TinkerJacobian *self, int32_t row, double mass, double *values)
{
    const TinkerConstraints *all = &self->model->constraints;
    g_autofree TinkerCoordinateEntry *entries = tinker_constraints_row_room(all);
    const int32_t count = tinker_constraints_list_row(all, row, entries), n = self->model->coordinates;
    for (int32_t r = 0; r < count; r++)
        for (int32_t c = 0; c < count; c++) {
            if (entries[r].coordinate >= n || entries[c].coordinate >= n) continue;
            values[tinker_jacobian_find_entry(self, entries[r].coordinate, entries[c].coordinate)] +=
                mass * entries[r].value * entries[c].value;
        }
}

/* Whether the pattern has them all. A part of a row's matrix alone would hold each of two bodies by itself where they
 * are free to move together. */
static gboolean has_entries(const TinkerJacobian *self, const TinkerContactEntries *entries)
{
    for (int32_t r = 0; r < entries->count; r++)
        for (int32_t c = 0; c < entries->count; c++) {
            const int32_t at = tinker_jacobian_find_entry(self, entries->coordinate[r], entries->coordinate[c]);
            if (self->columns[at] != entries->coordinate[c]) return FALSE;
        }
    return TRUE;
}

void tinker_jacobian_add_gap_mass(const TinkerJacobian *self, const TinkerContact *contact, double *values)
{
    const int rows = contact->mode == TINKER_CONTACT_STICK ? 2 : 1; /* along the normal; along the tangent */
    TinkerContactEntries entries;
    tinker_contact_gap_entries(self->model->contacts, contact->plate, &entries);
    if (!has_entries(self, &entries)) return;
    for (int which = 0; which < rows; which++)
        for (int32_t r = 0; r < entries.count; r++)
            for (int32_t c = 0; c < entries.count; c++)
                values[tinker_jacobian_find_entry(self, entries.coordinate[r], entries.coordinate[c])] +=
                    self->model->mass[contact->body] * entries.row[which][r] * entries.row[which][c];
}
