/* Building the linear form: every part of the model adds its edges, loads and inputs, or says that it is not linear. */
#include "physics/line/linear-form.h"
#include "physics/line/linear-form-data.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

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

static void add_mass_and_drag(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    int32_t per_body = axes(form), n = form->system.size;
    for (int32_t i = 0; i < n; i++) {
        form->mass[i] = model->mass[i / per_body];
        if (form->drag != NULL) form->drag[i] = model->field_drag;
    }
}

static void add_loads(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    int32_t fields = tinker_model_book_index(model, TINKER_BOOK_FIELDS);
    int32_t motors = tinker_model_book_index(model, TINKER_BOOK_MOTORS);
    for (int32_t i = 0; i < model->bodies; i++) {
        for (int32_t axis = 0; axis < axes(form); axis++) {
            int32_t target = axes(form) * i + axis;
            tinker_form_add_load(form, target, -1, model->mass[i] * component(form, model->field_acceleration, axis));
            tinker_form_add_load(form, target, fields, component(form, model->field_force, axis));
            if (model->constant_force != NULL)
                tinker_form_add_load(form, target, motors, component(form, model->constant_force + 2 * i, axis));
        }
    }
}

static gboolean add_driven(TinkerLinearForm *form)
{
    const TinkerModel *model = form->model;
    int32_t motors = tinker_model_book_index(model, TINKER_BOOK_MOTORS);
    for (guint i = 0; i < model->driven->len; i++) {
        const TinkerDrivenForce *driven = &g_array_index(model->driven, TinkerDrivenForce, i);
        if (driven->point >= model->bodies) continue;
        int32_t input = tinker_form_add_input(form, driven->batch, tinker_driven_column(driven), driven->row);
        if (input < 0) return FALSE;
        for (int32_t axis = 0; axis < axes(form); axis++)
            tinker_form_drive(form, axes(form) * driven->point + axis, input, motors,
                              component(form, driven->direction, axis));
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
            if (input < 0) input = tinker_form_add_input(form, batch, columns[row], row);
            if (input < 0) return FALSE;
            for (int32_t axis = 0; axis < axes(form); axis++)
                tinker_form_use_input(form, &form->motions, anchors[p] + axis, input, -1,
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

TinkerLinearForm *tinker_linear_form_new(TinkerModel *model)
{
    if (model->turning > 0) return tinker_shafts_form_new(model);
    if (!laws_are_linear(model)) return NULL;
    TinkerLine line = {{1, 0}, {0, 0}};
    gboolean straight = tinker_model_find_line(model, &line) && tinker_model_growth_across(model, &line) == 0;
    if (!straight && !lines_have_no_length(&model->lines)) return NULL;
    TinkerLinearForm *form = g_new0(TinkerLinearForm, 1);
    form->model = model;
    form->one_coordinate = form->straight = straight;
    form->line = line;
    form->system.size = axes(form) * model->bodies;
    tinker_form_allot(form, (gsize)axes(form) * (gsize)model->lines.count,
                      (gsize)axes(form) * (gsize)(model->points - model->first_support));
    add_mass_and_drag(form);
    add_loads(form);
    if (!add_driven(form) || !add_geometry(form)) {
        tinker_linear_form_free(form);
        return NULL;
    }
    tinker_form_close(form);
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
    tinker_shafts_free(form->shafts);
    g_free(form);
}

const TinkerLinearSystem *tinker_linear_form_system(const TinkerLinearForm *form)
{
    return &form->system;
}

gboolean tinker_linear_form_is_reduced(const TinkerLinearForm *form)
{
    return form->one_coordinate;
}

gboolean tinker_linear_form_is_of_shafts(const TinkerLinearForm *form)
{
    return form->shafts != NULL;
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
    for (guint i = 0; form->inputs != NULL && i < form->inputs->len; i++) {
        const TinkerInput *input = &g_array_index(form->inputs, TinkerInput, i);
        tinker_waveform_form(input->evaluator, t, &signals[input->first_signal]);
    }
    return TINKER_OK;
}

void tinker_linear_form_expand(const TinkerLinearForm *form, const double *x, const double *u, double *q, double *v)
{
    gsize bytes = (gsize)form->system.size * sizeof(double);
    if (form->shafts != NULL) {
        tinker_shafts_expand(form, x, u, q, v);
        return;
    }
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
    if (form->shafts != NULL) {
        tinker_shafts_reduce(form, q, v, x, u);
        return;
    }
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
