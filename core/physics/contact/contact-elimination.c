/* Which bodies, rows and equations an elimination is of, and where its products go; see the header. */
#include "physics/contact/elimination-private.h"

static gboolean is_of_group(const TinkerModel *model, const int32_t *group, int32_t first, int32_t point)
{
    return point < model->bodies && group[point] == group[first];
}

/* Numbers the rows of the group; -1: of another. Answers how many. */
static int32_t number_rows(const TinkerModel *model, const int32_t *group, int32_t first, int32_t *number)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t count = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        gboolean own = FALSE;
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            own |= is_of_group(model, group, first, all->points[e]);
        number[row] = own ? count++ : -1;
    }
    return count;
}

static gboolean allot(TinkerContactElimination *self, gsize ends, gsize products)
{
    self->body = g_try_new0(EliminationBody, MAX(self->bodies, 1));
    self->ends = g_try_new0(EliminationEnd, MAX(ends, 1));
    self->slots = g_try_new0(int, MAX(products, 1));
    self->least = g_try_new0(double, MAX(self->rows, 1));
    self->mu = g_try_new0(double, MAX(self->rows, 1));
    self->diagonal = g_try_new0(int, MAX(self->rows, 1));
    return self->body != NULL && self->ends != NULL && self->slots != NULL && self->least != NULL && self->mu != NULL &&
           self->diagonal != NULL;
}

/* Lists bodies with the ends of rows on them. */
static void list_bodies(TinkerContactElimination *self, const int32_t *group, int32_t first, const int32_t *number)
{
    const TinkerConstraints *all = &self->model->constraints;
    int32_t bodies = 0, ends = 0, products = 0;
    for (int32_t i = 0; i < self->model->bodies; i++) {
        if (!is_of_group(self->model, group, first, i)) continue;
        EliminationBody *body = &self->body[bodies++];
        *body = (EliminationBody){.body = i, .inverse_mass = self->model->inverse_mass[i], .first_end = ends};
        body->first_product = products;
        for (int32_t k = all->body_starts[i]; k < all->body_starts[i + 1]; k++) {
            const int32_t entry = all->body_entries[k];
            self->ends[ends++] = (EliminationEnd){number[all->row_of[entry]], entry};
        }
        body->end_count = ends - body->first_end;
        products += body->end_count * body->end_count;
    }
}

/* The pattern, and where every product goes. FALSE: no memory. */
static gboolean find_slots(TinkerContactElimination *self, gsize products)
{
    g_autofree int *rows = g_try_new(int, MAX(products, 1)), *columns = g_try_new(int, MAX(products, 1));
    gsize count = 0;
    if (rows == NULL || columns == NULL) return FALSE;
    for (int pass = 0; pass < 2; pass++) {
        count = 0;
        for (int32_t i = 0; i < self->bodies; i++) {
            const EliminationEnd *ends = self->ends + self->body[i].first_end;
            const int32_t n = self->body[i].end_count;
            for (int32_t k = 0; k < n * n; k++) {
                const int row = ends[k / n].row, column = ends[k % n].row;
                if (pass == 1)
                    self->slots[self->body[i].first_product + k] = tinker_sparse_ldu_slot(self->ldu, row, column);
                if (row == column) continue;
                rows[count] = row;
                columns[count++] = column;
            }
        }
        if (pass == 0) self->ldu = tinker_sparse_ldu_new(self->rows, rows, columns, count);
        if (self->ldu == NULL) return FALSE;
    }
    for (int32_t row = 0; row < self->rows; row++)
        self->diagonal[row] = tinker_sparse_ldu_slot(self->ldu, row, row);
    return TRUE;
}

TinkerContactElimination *tinker_contact_elimination_new(TinkerModel *model, const int32_t *group, int32_t first,
                                                         double *by_body)
{
    const TinkerConstraints *all = &model->constraints;
    g_autofree int32_t *number = g_try_new0(int32_t, MAX(all->rows, 1));
    if (number == NULL) return NULL;
    TinkerContactElimination *self = g_new0(TinkerContactElimination, 1);
    gsize ends = 0, products = 0;
    self->model = model;
    self->by_body = by_body;
    self->rows = number_rows(model, group, first, number);
    for (int32_t i = 0; i < model->bodies; i++) {
        if (!is_of_group(model, group, first, i)) continue;
        const gsize count = (gsize)(all->body_starts[i + 1] - all->body_starts[i]);
        self->bodies++;
        ends += count;
        products += count * count;
    }
    gboolean done = products <= G_MAXINT32 && allot(self, ends, products);
    if (done) list_bodies(self, group, first, number);
    if (!done || !find_slots(self, products)) g_clear_pointer(&self, tinker_contact_elimination_free);
    return self;
}

void tinker_contact_elimination_free(TinkerContactElimination *self)
{
    if (self == NULL) return;
    tinker_sparse_ldu_free(self->ldu);
    gpointer arrays[] = {self->body,  self->ends,     self->slots,    self->mu,
                         self->least, self->diagonal, self->equation, self->along};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

gsize tinker_contact_elimination_fill(const TinkerContactElimination *self)
{
    return 2 * tinker_sparse_ldu_fill(self->ldu);
}

gint64 tinker_contact_elimination_solves(const TinkerContactElimination *self)
{
    return self->solves;
}

gboolean tinker_contact_elimination_make_room(TinkerContactElimination *self, gsize count)
{
    if (count <= self->room) return TRUE;
    g_free(self->equation);
    g_free(self->along);
    self->room = 2 * count;
    self->equation = g_try_new0(EliminationEquation, self->room);
    self->along = g_try_new(double, self->room);
    if (self->equation == NULL || self->along == NULL) self->room = 0;
    return self->room > 0;
}

void tinker_contact_elimination_take(TinkerContactElimination *self, const TinkerContactEquation *equations,
                                     int32_t count)
{
    EliminationBody *body = self->body, *const end = body + self->bodies;
    for (int32_t k = 0; k < count; body++) {
        const int32_t of = equations[k].body, first = k;
        while (body < end && body->body != of)
            (body++)->count = 0;
        g_assert(body < end);
        while (k < count && equations[k].body == of)
            k++;
        body->first = first;
        body->count = k - first;
    }
    for (; body < end; body++)
        body->count = 0;
    self->of = equations;
    self->equations = count;
}
