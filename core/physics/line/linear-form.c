/* Building the linear form: every part of the model adds its edges, loads and inputs, or says that it is not linear. */
#include "physics/line/linear-form.h"
#include "physics/line/linear-form-data.h"
#include "physics/model/model-data.h"

#include <math.h>
#include <string.h>

/* A model on a line has one coordinate a body, any other two. */
static int32_t axes(const TinkerLinearForm *form)
{
    return form->straight ? 1 : 2;
}

/* The part of a vector that acts along the coordinate's axis. */
static double component(const TinkerLinearForm *form, const double *vector, int32_t axis)
{
    const double *direction = form->line.direction;
    return form->straight ? vector[0] * direction[0] + vector[1] * direction[1] : vector[axis];
}

/* Whether nothing of the model is nonlinear whatever the geometry. A line between two supports moves nothing, but takes
 * part in the energy books, which have no room for it in the linear form. */
static gboolean laws_are_linear(const TinkerModel *model)
{
    for (int32_t i = 0; i < model->lines.count; i++)
        if (MIN(model->lines.a[i], model->lines.b[i]) >= model->bodies) return FALSE;
    return model->bodies > 0 && model->turning == 0 && model->constraints.rows == 0 && model->asked_lines->len == 0 &&
           model->asked_forces->len == 0 && model->asked_fields->len == 0;
}

/* Springs without length pull as vectors; dampers do not. */
static gboolean lines_have_no_length(const TinkerMergedLines *lines)
{
    for (int32_t i = 0; i < lines->count; i++)
        if (lines->length[i] != 0 || lines->tension[i] != 0 || lines->damping[i] != 0) return FALSE;
    return TRUE;
}

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
static void allot(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    const gsize n = (gsize)form->system.size, edges = (gsize)axes(form) * (gsize)model->lines.count;
    const gsize anchors = (gsize)axes(form) * (gsize)(model->points - model->first_support);
    const gsize sorted = form->straight ? edges + 1 : 0;
    form->room = g_malloc0((3 * n + 3 * anchors + 1) * sizeof(double) + anchors * sizeof(int32_t) +
                           edges * sizeof(TinkerLinearEdge) + 2 * sorted * sizeof(TinkerStraightEdge));
    form->edges = form->room;
    form->inner = (TinkerStraightEdge *)(gpointer)(form->edges + edges);
    form->anchored = form->inner + sorted;
    form->mass = (double *)(gpointer)(form->anchored + sorted);
    form->load = form->mass + n;
    form->drag = model->field_drag != 0 ? form->load + n : NULL;
    form->anchors = form->load + 2 * n;
    form->anchor_place = form->anchors + anchors;
    form->anchor_speed = form->anchor_place + anchors;
    form->anchor_points = (int32_t *)(gpointer)(form->anchor_speed + anchors + 1);
}

static void add_mass_and_drag(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    int32_t per_body = axes(form), n = form->system.size;
    for (int32_t i = 0; i < n; i++) {
        form->mass[i] = model->mass[i / per_body];
        if (form->drag != NULL) form->drag[i] = model->field_drag;
    }
}

static void add_load(TinkerLinearForm *form, int32_t target, int32_t book, double force)
{
    TinkerConstantLoad load = {target, book, force};
    if (force != 0) append(&form->loads, sizeof load, &load);
}

static void add_loads(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    int32_t fields = tinker_model_book_index(model, TINKER_BOOK_FIELDS);
    int32_t motors = tinker_model_book_index(model, TINKER_BOOK_MOTORS);
    for (int32_t i = 0; i < model->bodies; i++) {
        for (int32_t axis = 0; axis < axes(form); axis++) {
            int32_t target = axes(form) * i + axis;
            add_load(form, target, -1, model->mass[i] * component(form, model->field_acceleration, axis));
            add_load(form, target, fields, component(form, model->field_force, axis));
            if (model->constant_force != NULL)
                add_load(form, target, motors, component(form, model->constant_force + 2 * i, axis));
        }
    }
}

/* The input of a waveform; -1 where it has no form. */
static int32_t add_input(TinkerLinearForm *form, const TinkerBlockBatch *batch, int32_t column, int32_t row)
{
    TinkerInput input = {tinker_block_batch_evaluator(batch, column, row), form->system.signal_count, 0};
    if (input.evaluator != NULL) input.signals = tinker_waveform_signals(input.evaluator);
    if (input.signals == 0) return -1;
    form->system.signal_count += input.signals;
    append(&form->inputs, sizeof input, &input);
    return length(form->inputs) - 1;
}

/* Every signal of the input is used alike. */
static void use_input(TinkerLinearForm *form, GArray **uses, int32_t target, int32_t number, int32_t book,
                      double factor)
{
    const TinkerInput *input = &g_array_index(form->inputs, TinkerInput, (guint)number);
    for (int32_t i = 0; i < input->signals && factor != 0; i++) {
        TinkerSignalUse use = {target, input->first_signal + i, book, 0, factor};
        append(uses, sizeof use, &use);
    }
}

static gboolean add_driven(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    int32_t motors = tinker_model_book_index(model, TINKER_BOOK_MOTORS);
    for (guint i = 0; i < model->driven->len; i++) {
        const TinkerDrivenForce *driven = &g_array_index(model->driven, TinkerDrivenForce, i);
        if (driven->point >= model->bodies) continue;
        int32_t input = add_input(form, driven->batch, tinker_driven_column(driven), driven->row);
        if (input < 0) return FALSE;
        for (int32_t axis = 0; axis < axes(form); axis++) {
            TinkerDrive drive = {axes(form) * driven->point + axis, input, motors,
                                 component(form, driven->direction, axis)};
            use_input(form, &form->forces, drive.target, input, motors, drive.factor);
            append(&form->drives, sizeof drive, &drive);
        }
    }
    return TRUE;
}

/* The first anchor of a model's point: one for each axis. */
static int32_t anchor_of(TinkerLinearForm *form, int32_t *anchors, int32_t point)
{
    const TinkerModel *model = form->model;
    int32_t number = point - model->first_support;
    if (anchors[number] >= 0) return anchors[number];
    double place[2];
    tinker_model_start_place(model, point, place);
    anchors[number] = form->system.anchor_count;
    for (int32_t axis = 0; axis < axes(form); axis++) {
        form->anchor_points[form->system.anchor_count] = point;
        form->anchors[form->system.anchor_count++] = component(form, place, axis);
    }
    return anchors[number];
}

static void add_edges(TinkerLinearForm *form, int32_t *anchors)
{
    const TinkerModel *model = form->model;
    const TinkerMergedLines *lines = &model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        int32_t ends[2] = {lines->a[i], lines->b[i]}, first[2];
        for (int end = 0; end < 2; end++)
            first[end] = ends[end] < model->bodies ? axes(form) * ends[end] : -1 - anchor_of(form, anchors, ends[end]);
        for (int32_t axis = 0; axis < axes(form); axis++) {
            TinkerLinearEdge edge = {first[0] < 0 ? first[0] - axis : first[0] + axis,
                                     first[1] < 0 ? first[1] - axis : first[1] + axis,
                                     lines->stiffness[i],
                                     lines->length[i],
                                     lines->damping[i],
                                     lines->tension[i]};
            form->edges[form->system.edge_count++] = edge;
        }
    }
}

static gboolean add_motion(TinkerLinearForm *form, const int32_t *anchors, const TinkerBlockBatch *batch)
{
    const TinkerModel *model = form->model;
    g_autofree double *direction = g_new0(double, 2 * (gsize)batch->count);
    g_autofree int32_t *columns = g_new0(int32_t, batch->count);
    if (!tinker_motion_directions(batch, direction, columns)) return FALSE;
    for (int32_t row = 0; row < batch->count; row++) {
        TinkerBlockId support = batch->end[batch->end_offsets[row]].block;
        int32_t input = -1;
        for (int32_t p = 0; p < model->points - model->first_support; p++) {
            if (anchors[p] < 0 || tinker_model_attachment(model, model->first_support + p)->block != support) continue;
            if (input < 0) input = add_input(form, batch, columns[row], row);
            if (input < 0) return FALSE;
            for (int32_t axis = 0; axis < axes(form); axis++)
                use_input(form, &form->motions, anchors[p] + axis, input, -1,
                          component(form, direction + 2 * row, axis));
        }
    }
    return TRUE;
}

static gboolean add_geometry(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    gsize points = (gsize)(model->points - model->first_support);
    g_autofree int32_t *anchors = g_new(int32_t, MAX(points, 1));
    for (gsize i = 0; i < points; i++)
        anchors[i] = -1;
    add_edges(form, anchors);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->block_class->physics == NULL || batch->block_class->physics->motion == NULL) continue;
        if (!add_motion(form, anchors, batch)) return FALSE;
    }
    return TRUE;
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

TinkerLinearForm *tinker_linear_form_new(TinkerModel *model)
{
    if (!laws_are_linear(model)) return NULL;
    TinkerLine line = {{1, 0}, {0, 0}};
    gboolean straight = tinker_model_find_line(model, &line) && tinker_model_growth_across(model, &line) == 0;
    if (!straight && !lines_have_no_length(&model->lines)) return NULL;
    TinkerLinearForm *form = g_new0(TinkerLinearForm, 1);
    form->model = model;
    form->straight = straight;
    form->line = line;
    form->system.size = axes(form) * model->bodies;
    allot(form);
    add_mass_and_drag(form);
    add_loads(form);
    if (!add_driven(form) || !add_geometry(form)) {
        tinker_linear_form_free(form);
        return NULL;
    }
    close_system(form);
    if (straight) sort_edges(form);
    return form;
}

void tinker_linear_form_free(TinkerLinearForm *form)
{
    if (form == NULL) return;
    GArray *arrays[] = {form->loads, form->forces, form->motions, form->inputs, form->drives};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        if (arrays[i] != NULL) g_array_unref(arrays[i]);
    gpointer memory[] = {form->room, form->row_starts, form->columns, form->stiffness, form->damping};
    for (gsize i = 0; i < G_N_ELEMENTS(memory); i++)
        g_free(memory[i]);
    g_free(form);
}

const TinkerLinearSystem *tinker_linear_form_system(const TinkerLinearForm *form)
{
    return &form->system;
}

gboolean tinker_linear_form_is_straight(const TinkerLinearForm *form, double direction[2])
{
    if (form->straight && direction != NULL) memcpy(direction, form->line.direction, sizeof(form->line.direction));
    return form->straight;
}

double tinker_model_sideways_growth(TinkerModel *model)
{
    TinkerLine line;
    if (!laws_are_linear(model) || !tinker_model_find_line(model, &line)) return 0;
    return tinker_model_growth_across(model, &line);
}

TinkerStatus tinker_linear_form_signals(TinkerLinearForm *form, TinkerSignal *signals)
{
    double t = form->model->time;
    for (int32_t i = 0; i < length(form->inputs); i++) {
        const TinkerInput *input = &g_array_index(form->inputs, TinkerInput, i);
        tinker_waveform_form(input->evaluator, t, &signals[input->first_signal]);
    }
    return TINKER_OK;
}

void tinker_linear_form_expand(const TinkerLinearForm *form, const double *x, const double *u, double *q, double *v)
{
    gsize bytes = (gsize)form->system.size * sizeof(double);
    if (!form->straight) {
        memcpy(q, x, bytes);
        memcpy(v, u, bytes);
        return;
    }
    const TinkerLine *line = &form->line;
    for (int32_t i = 0; i < form->system.size; i++) {
        for (int k = 0; k < 2; k++) {
            q[2 * i + k] = line->offset[k] + x[i] * line->direction[k];
            v[2 * i + k] = u[i] * line->direction[k];
        }
    }
}

void tinker_linear_form_reduce(const TinkerLinearForm *form, const double *q, const double *v, double *x, double *u)
{
    gsize bytes = (gsize)form->system.size * sizeof(double);
    if (!form->straight) {
        memcpy(x, q, bytes);
        memcpy(u, v, bytes);
        return;
    }
    for (int32_t i = 0; i < form->system.size; i++) {
        x[i] = component(form, q + 2 * i, 0);
        u[i] = component(form, v + 2 * i, 0);
    }
}

gboolean tinker_linear_form_holds(const TinkerLinearForm *form, const double *q, const double *v, double extent,
                                  double speed)
{
    const TinkerLine *line = &form->line;
    for (int32_t i = 0; form->straight && i < form->model->bodies; i++) {
        double off = tinker_line_across(line, q[2 * i] - line->offset[0], q[2 * i + 1] - line->offset[1]);
        double aside = tinker_line_across(line, v[2 * i], v[2 * i + 1]);
        if (off > TINKER_LINE_ACROSS * extent || aside > TINKER_LINE_ACROSS * speed) return FALSE;
    }
    return TRUE;
}
