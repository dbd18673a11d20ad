/* Parts of which every linear form is put together. */
#include <string.h>

#include "physics/line/linear-form-data.h"
#include "physics/model/model-data.h"

/* What most models have none of: made with the first. */
static void append(GArray **array, guint size, gconstpointer item)
{
    if (*array == NULL) *array = g_array_new(FALSE, FALSE, size);
    g_array_append_vals(*array, item, 1);
}

static int32_t length(const GArray *array)
{
    return array != NULL ? (int32_t)array->len : 0;
}

static gconstpointer items(const GArray *array)
{
    return array != NULL ? array->data : NULL;
}

/* One piece of memory for all arrays whose length is known from the start. */
void tinker_form_allot(TinkerLinearForm *form, gsize edges, gsize anchors)
{
    const gsize n = (gsize)form->system.size, sorted = form->one_coordinate ? edges + 1 : 0;
    form->room = g_malloc0((4 * n + 3 * anchors + 1) * sizeof(double) + anchors * sizeof(int32_t) +
                           edges * sizeof(TinkerLinearEdge) + 2 * sorted * sizeof(TinkerStraightEdge));
    form->edges = form->room;
    form->inner = (TinkerStraightEdge *)(gpointer)(form->edges + edges);
    form->anchored = form->inner + sorted;
    form->mass = (double *)(gpointer)(form->anchored + sorted);
    form->load = form->mass + n;
    form->drag = form->shafts == NULL && form->model->field_drag != 0 ? form->load + n : NULL;
    form->inverse_mass = form->load + 2 * n;
    form->anchors = form->load + 3 * n;
    form->anchor_place = form->anchors + anchors;
    form->anchor_speed = form->anchor_place + anchors;
    form->anchor_points = (int32_t *)(gpointer)(form->anchor_speed + anchors + 1);
}

void tinker_form_add_load(TinkerLinearForm *form, int32_t target, int32_t book, double force)
{
    TinkerConstantLoad load = {target, book, force};
    if (force != 0) append(&form->loads, sizeof load, &load);
}

int32_t tinker_form_add_input(TinkerLinearForm *form, const TinkerBlockBatch *batch, int32_t column, int32_t row)
{
    TinkerInput input = {tinker_block_batch_evaluator(batch, column, row), form->system.signal_count, 0};
    if (input.evaluator != NULL) input.signals = tinker_waveform_signals(input.evaluator);
    if (input.signals == 0) return -1;
    form->system.signal_count += input.signals;
    append(&form->inputs, sizeof input, &input);
    return length(form->inputs) - 1;
}

void tinker_form_use_input(TinkerLinearForm *form, GArray **uses, int32_t target, int32_t number, int32_t book,
                           double factor)
{
    const TinkerInput *input = &g_array_index(form->inputs, TinkerInput, (guint)number);
    for (int32_t i = 0; i < input->signals && factor != 0; i++) {
        TinkerSignalUse use = {target, input->first_signal + i, book, 0, factor};
        append(uses, sizeof use, &use);
    }
}

void tinker_form_drive(TinkerLinearForm *form, int32_t target, int32_t input, int32_t book, double factor)
{
    TinkerDrive drive = {target, input, book, factor};
    tinker_form_use_input(form, &form->forces, target, input, book, factor);
    append(&form->drives, sizeof drive, &drive);
}

static void close_system(TinkerLinearForm *form)
{
    TinkerLinearSystem *system = &form->system;
    const TinkerModel *model = form->model;
    system->struct_size = sizeof(TinkerLinearSystem);
    system->load_count = length(form->loads);
    system->force_count = length(form->forces);
    system->motion_count = length(form->motions);
    system->mass = form->mass;
    system->drag = form->drag;
    system->edges = form->edges;
    system->anchors = form->anchors;
    system->loads = items(form->loads);
    system->forces = items(form->forces);
    system->motions = items(form->motions);
    system->damper_book = tinker_model_book_index(model, TINKER_BOOK_DAMPERS);
    system->drag_book = tinker_model_book_index(model, TINKER_BOOK_FIELDS);
    system->support_book = tinker_model_book_index(model, TINKER_BOOK_SUPPORT_MOTION);
}

/* Lays the edges out for the loops of a step. */
static void sort_edges(TinkerLinearForm *form)
{
    const TinkerLinearSystem *system = &form->system;
    memcpy(form->anchor_place, system->anchors, (gsize)system->anchor_count * sizeof(double));
    for (int32_t i = 0; i < system->edge_count; i++) {
        const TinkerLinearEdge *edge = &system->edges[i];
        TinkerStraightEdge sorted = {edge->a, edge->b, edge->stiffness, edge->tension - edge->stiffness * edge->length,
                                     edge->damping};
        if (MIN(edge->a, edge->b) >= 0) {
            form->inner[form->inner_count++] = sorted;
            continue;
        }
        sorted.a = -1 - MIN(edge->a, edge->b);
        sorted.b = MAX(edge->a, edge->b);
        form->anchored[form->anchored_count++] = sorted;
    }
    for (int32_t i = 0; i < system->load_count; i++)
        form->load[system->loads[i].target] += system->loads[i].force;
}

void tinker_form_close(TinkerLinearForm *form)
{
    close_system(form);
    for (int32_t i = 0; i < form->system.size; i++)
        form->inverse_mass[i] = 1 / form->mass[i];
    if (form->one_coordinate) sort_edges(form);
}
