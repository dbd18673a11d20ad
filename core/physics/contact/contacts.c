/* What may touch what: compiling, and the list of the equations of closed contacts. */
#include "physics/contact/contacts-private.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/contact/contact-pins.h"
#include "physics/contact/tolerances.h"
#include "physics/model/model-data.h"

/* Up to so many equations W solves them: one on 79 rods takes 0.36 us so and 1.5 us by elimination, four 1.5 us either
 * way, eight 3.0 and 1.6 us, 64 take 52 and 2.6 us (bench-contact-chains).. */
#define FEW_ROWS 8

/* As masses and supports have it. */
static int32_t shape_of(const TinkerBlockBatch *batch)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    if (physics == NULL || physics->body == NULL || physics->body->degrees_of_freedom == 3) return TINKER_SHAPE_NONE;
    return physics->body->shape;
}

static gboolean is_solid(const TinkerBlockBatch *batch, int32_t row)
{
    return tinker_block_batch_meaning(batch, row, TINKER_MEANING_SOLID, 0, 1) != 0 &&
           tinker_block_batch_meaning(batch, row, TINKER_MEANING_WIDTH, 0, 0) > 0;
}

static const TinkerPlace *turned_by_motion(const TinkerModel *model, TinkerBlockId block)
{
    const TinkerPlace *place =
        tinker_motions_moves(model->motions, block) ? tinker_motions_place(model->motions, block) : NULL;
    return place != NULL && place->turns ? place : NULL;
}

static void add_plate(TinkerContacts *contacts, const TinkerBlockBatch *batch, int32_t row)
{
    const double orientation = tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0);
    const TinkerPlace *turned = turned_by_motion(contacts->model, batch->ids[row]);
    const double angle = orientation + (turned != NULL ? turned->angle : 0);
    TinkerPlate *plate = &contacts->plates[contacts->plate_count++];
    *plate = (TinkerPlate){
        .block = batch->ids[row],
        .point = tinker_model_centre(contacts->model, batch->ids[row]),
        .orientation = orientation,
        .turned = turned,
        .normal = {-sin(angle), cos(angle)},
        .half_height = 0.5 * tinker_block_batch_meaning(batch, row, TINKER_MEANING_HEIGHT, 0, 0),
        .half_width = 0.5 * tinker_block_batch_meaning(batch, row, TINKER_MEANING_WIDTH, 0, 0),
        .surface = tinker_surface_of(batch, row, 0),
    };
    plate->moving = tinker_model_attachment(contacts->model, plate->point)->moving;
    contacts->moving_plates += plate->moving;
}

/* How many plates are solid, and whether any body has a shape. */
static int32_t count_plates(const TinkerModel *model, gboolean *any_body)
{
    int32_t plates = 0;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (shape_of(batch) == TINKER_SHAPE_BOX && batch->count > 0) *any_body = TRUE;
        for (int32_t row = 0; shape_of(batch) == TINKER_SHAPE_PLATE && row < batch->count; row++)
            plates += is_solid(batch, row);
    }
    return plates;
}

static void find_shapes(TinkerContacts *contacts, gboolean any_body)
{
    const TinkerModel *model = contacts->model;
    for (int32_t i = 0; i < model->bodies; i++)
        contacts->half_height[i] = NAN;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++) {
            int32_t point = tinker_model_centre(model, batch->ids[row]);
            if (shape_of(batch) == TINKER_SHAPE_BOX && point >= 0 && point < model->bodies)
                contacts->half_height[point] =
                    0.5 * tinker_block_batch_meaning(batch, row, TINKER_MEANING_HEIGHT, 0, 0);
            else if (any_body && shape_of(batch) == TINKER_SHAPE_PLATE && is_solid(batch, row))
                add_plate(contacts, batch, row);
        }
    }
}

static void find_surfaces(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++) {
            const int32_t point = tinker_model_centre(model, batch->ids[row]);
            if (point < 0 || point >= model->bodies) continue;
            contacts->surfaces[point] = tinker_surface_of(batch, row, NAN);
            contacts->own_surfaces |= tinker_surface_is_given(&contacts->surfaces[point]);
        }
    }
}

void tinker_contacts_tie(const TinkerModel *model, int32_t row, int32_t *sets)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t first = -1;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        if (all->points[e] >= model->bodies) continue;
        if (first >= 0) tinker_sets_join(sets, first, all->points[e]);
        first = all->points[e];
    }
}

static void name_by_first(int32_t *sets, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        sets[i] = tinker_sets_first(sets, i);
}

/* What constraints tie together, and what may meet besides. */
static void find_groups(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    const TinkerConstraints *all = &model->constraints;
    tinker_sets_begin(contacts->tied, model->bodies);
    for (int32_t row = 0; row < all->rows; row++)
        tinker_contacts_tie(model, row, contacts->tied);
    name_by_first(contacts->tied, model->bodies);
    memcpy(contacts->group, contacts->tied, (gsize)model->bodies * sizeof(int32_t));
    for (int32_t row = 0; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            if (all->points[e] < model->bodies) contacts->held[all->points[e]] = TRUE;
    for (int32_t i = 0; i < contacts->pair_count; i++)
        if (contacts->pairs[i].point[1] < model->bodies)
            tinker_sets_join(contacts->group, contacts->pairs[i].point[0], contacts->pairs[i].point[1]);
    name_by_first(contacts->group, model->bodies);
}

static void block_clear(gpointer data)
{
    TinkerContactBlock *block = data;
    tinker_dense_solve_free(block->solve[FALSE]);
    tinker_dense_solve_free(block->solve[TRUE]);
}

static void measure_thickness(TinkerContacts *contacts)
{
    double plate = 0, body = 0;
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        body = fmax(body, contacts->reach[i]);
    for (int32_t i = 0; i < contacts->plate_count; i++)
        plate = fmax(plate, contacts->plates[i].half_height);
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        body = fmax(body, contacts->half_height[i]); /* fmax passes over what is no number */
    contacts->thickness = plate + body;
}

/* Those that contacts write into: which books there are does not change in a run. */
static void open_books(TinkerContacts *contacts)
{
    TinkerModel *model = contacts->model;
    for (int32_t k = 0; k < tinker_contacts_plates(contacts); k++) {
        const TinkerPlate *plate = &contacts->plates[k];
        if (plate->surface.dynamic_friction > 0) model->has_book[TINKER_BOOK_FRICTION] = TRUE;
        if (plate->moving) model->has_book[TINKER_BOOK_SUPPORT_MOTION] = model->more_than_lines = TRUE;
    }
}

static TinkerImpactLaw law_of(TinkerScene *scene)
{
    int law = 0;
    while (law < TINKER_IMPACT_LAWS &&
           g_strcmp0(tinker_impact_law_names[law], tinker_scene_head(scene)->run.impact_law) != 0)
        law++;
    return law < TINKER_IMPACT_LAWS ? (TinkerImpactLaw)law : TINKER_IMPACT_NEWTON;
}

TinkerContacts *tinker_contacts_new(TinkerModel *model)
{
    gboolean any_body = FALSE;
    int32_t plates = count_plates(model, &any_body);
    const int32_t meeting = tinker_model_meeting_bodies(model);
    any_body |= meeting > 0;
    if (!any_body) plates = 0;
    const gboolean meet = meeting > 1 && tinker_model_bodies_meet(model);
    const int32_t pins = tinker_model_rubbing_pins(model);
    if (plates == 0 && meeting < 2 && pins == 0 && model->constraints.unilateral == NULL) return NULL;
    TinkerContacts *contacts = g_new0(TinkerContacts, 1);
    contacts->model = model;
    contacts->impact_law = law_of(model->scene);
    contacts->plates = g_new0(TinkerPlate, MAX(plates, 1));
    contacts->half_height = g_new0(double, MAX(model->bodies, 1));
    contacts->held = g_new0(gboolean, MAX(model->bodies, 1));
    contacts->surfaces = g_new0(TinkerSurface, MAX(model->bodies, 1));
    contacts->group = g_new0(int32_t, MAX(model->bodies, 1));
    contacts->tied = g_new0(int32_t, MAX(model->bodies, 1));
    contacts->touching = g_new0(int32_t, MAX(model->bodies, 1));
    contacts->reach = g_new0(double, MAX(model->bodies, 1));
    contacts->angle = g_new0(double, MAX(model->bodies, 1));
    contacts->unturned = g_ptr_array_new_with_free_func(g_free);
    contacts->first_gap = g_new0(int32_t, model->bodies + 1);
    contacts->entries = g_array_new(FALSE, TRUE, sizeof(TinkerContactEntries));
    contacts->closed = g_array_new(FALSE, TRUE, sizeof(TinkerContact));
    contacts->pressings = g_array_new(FALSE, TRUE, sizeof(TinkerPressing));
    contacts->rows = g_array_new(FALSE, TRUE, sizeof(TinkerContactRow));
    contacts->simple = g_array_new(FALSE, TRUE, sizeof(int32_t));
    contacts->blocks = g_array_new(FALSE, TRUE, sizeof(TinkerContactBlock));
    g_array_set_clear_func(contacts->blocks, block_clear);
    contacts->eliminated = g_ptr_array_new();
    for (int k = 0; k < 2; k++)
        contacts->eliminations[k] = g_new0(TinkerContactElimination *, MAX(model->bodies, 1));
    contacts->column = g_new0(double, (gsize)MAX(model->coordinates, 1));
    contacts->before = g_new0(double, (gsize)MAX(model->coordinates, 1));
    contacts->acts = g_new0(double, (gsize)MAX(model->coordinates, 1));
    contacts->accelerations = g_new0(double, (gsize)MAX(model->coordinates, 1));
    find_shapes(contacts, any_body);
    find_surfaces(contacts);
    tinker_contacts_find_outlines(contacts);
    tinker_contacts_list_gaps(contacts, meet);
    tinker_contacts_list_pins(contacts, pins);
    find_groups(contacts);
    measure_thickness(contacts);
    open_books(contacts);
    return contacts;
}

void tinker_contacts_free(TinkerContacts *contacts)
{
    if (contacts == NULL) return;
    g_array_unref(contacts->closed);
    g_ptr_array_unref(contacts->unturned);
    g_array_unref(contacts->pressings);
    g_array_unref(contacts->rows);
    g_array_unref(contacts->entries);
    g_array_unref(contacts->simple);
    g_array_unref(contacts->blocks);
    g_ptr_array_unref(contacts->eliminated);
    for (int32_t i = 0; i < 2 * contacts->model->bodies; i++)
        tinker_contact_elimination_free(contacts->eliminations[i % 2][i / 2]);
    gpointer arrays[] = {contacts->plates,
                         contacts->half_height,
                         contacts->held,
                         contacts->surfaces,
                         contacts->group,
                         contacts->tied,
                         contacts->touching,
                         contacts->delassus,
                         contacts->demand,
                         contacts->accelerations,
                         contacts->column,
                         contacts->before,
                         contacts->acts,
                         contacts->base,
                         contacts->found,
                         contacts->eliminations[0],
                         contacts->eliminations[1],
                         contacts->equations[FALSE],
                         contacts->equations[TRUE],
                         contacts->reach,
                         contacts->angle,
                         contacts->first_gap,
                         contacts->outlines,
                         contacts->pairs,
                         contacts->functions,
                         contacts->corners,
                         contacts->pins.free,
                         contacts->pins.answers,
                         contacts->pins.found,
                         contacts->pins.before};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(contacts);
}

gboolean tinker_contacts_can_meet(const TinkerContacts *contacts)
{
    int32_t outlines = 0;
    for (int32_t i = 0; contacts != NULL && i < contacts->model->bodies; i++)
        outlines += tinker_contacts_has_outline(contacts, i);
    return outlines > 1 || (contacts != NULL && contacts->plate_count > 0);
}

static gboolean leaves(const TinkerContactPlace *place)
{
    return place->normal_speed > 1e-12 * fmax(fabs(place->tangential_speed), TINKER_SLOWEST);
}

gboolean tinker_contacts_touch(const TinkerContacts *contacts)
{
    if (contacts->pin_count > 0) return TRUE;
    for (int32_t body = 0; body < contacts->model->bodies; body++)
        for (int32_t k = 0; k < contacts->plate_count; k++) {
            TinkerContactPlace place = tinker_contact_place(contacts, body, k);
            double beside = fabs(place.along) - contacts->plates[k].half_width;
            if (fabs(place.gap) <= TINKER_TOUCHING && beside <= TINKER_TOUCHING && !leaves(&place)) return TRUE;
        }
    for (int32_t k = contacts->plate_count; k < contacts->plate_count + contacts->gap_count; k++) {
        const TinkerContactPlace place = tinker_contact_gap_place(contacts, k);
        if (fabs(place.gap) <= TINKER_TOUCHING && tinker_contact_gap_is_over(contacts, k, TINKER_TOUCHING) &&
            !leaves(&place))
            return TRUE;
    }
    return FALSE;
}

gboolean tinker_contacts_are_round(const TinkerContacts *contacts)
{
    for (int32_t body = 0; body < contacts->model->bodies; body++)
        if (tinker_contacts_has_outline(contacts, body) && contacts->outlines[body].kind != TINKER_OUTLINE_DISC)
            return FALSE;
    return TRUE;
}

double tinker_contacts_extent(const TinkerContacts *contacts)
{
    double extent = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPoint *at = &contacts->model->point[contact->body];
        const TinkerPoint *base = &contacts->model->point[contacts->plates[contact->plate].point];
        extent = fmax(extent, hypot(at->x - base->x, at->y - base->y));
    }
    return extent;
}

/* Equations -------------------------------------------------------------------------------------------------------- */

static int by_body(const void *left, const void *right)
{
    const TinkerContact *l = left, *r = right;
    if (l->body != r->body) return l->body < r->body ? -1 : 1;
    return l->plate < r->plate ? -1 : l->plate > r->plate;
}

static gboolean stands_alone(const TinkerContacts *contacts, guint number)
{
    const GArray *closed = contacts->closed;
    int32_t body = g_array_index(closed, TinkerContact, number).body;
    if (contacts->held[body] || tinker_contacts_has_outline(contacts, body)) return FALSE;
    if (tinker_contacts_is_gap(contacts, tinker_contacts_closed(contacts, number))) return FALSE;
    if (number > 0 && g_array_index(closed, TinkerContact, number - 1).body == body) return FALSE;
    return number + 1 == closed->len || g_array_index(closed, TinkerContact, number + 1).body != body;
}

/* Entries of one more gap function. */
static int32_t add_entries(TinkerContacts *contacts)
{
    g_array_set_size(contacts->entries, contacts->entries->len + 1);
    return (int32_t)contacts->entries->len - 1;
}

/* What resists rolling holds as an equation of its own, or turns along with the normal force of what bears it. */
static void add_resistance(TinkerContacts *contacts, int32_t number)
{
    const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)number);
    const double weight = sqrt(contacts->model->mass[contact->body]);
    const int32_t entries = add_entries(contacts);
    const gboolean pin = tinker_contacts_is_pin(contacts, contact);
    if (contact->mode == TINKER_CONTACT_SMOOTH) return;
    if (contact->mode == TINKER_CONTACT_STICK || pin) {
        TinkerContactRow row = {number, TRUE, {0, 0}, {0, 0}, weight, entries, 0, -1, -1, 0, 0};
        if (pin) row.pin_slope = tinker_contact_slip_share(contacts, contact);
        g_array_append_val(contacts->rows, row);
        return;
    }
    for (guint i = 0; i < contacts->rows->len; i++) {
        TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        if (row->contact != contact->bearer || row->tangential) continue;
        row->resisting = number;
        row->resisting_entries = entries;
        row->resisting_share = tinker_contact_slip_share(contacts, contact);
    }
}

static void add_rows(TinkerContacts *contacts, int32_t number)
{
    const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)number);
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    if (tinker_contacts_resists(contacts, contact)) {
        add_resistance(contacts, number);
        return;
    }
    double nx = plate->normal[0], ny = plate->normal[1], share = tinker_contact_slip_share(contacts, contact);
    double weight = sqrt(contacts->model->mass[contact->body]);
    const int32_t entries = plate->gap != NULL ? add_entries(contacts) : -1;
    TinkerContactRow normal = {number, FALSE, {nx, ny}, {nx + share * ny, ny - share * nx}, weight, entries, share,
                               -1,     -1,    0};
    g_array_append_val(contacts->rows, normal);
    if (contact->mode != TINKER_CONTACT_STICK) return;
    TinkerContactRow tangential = {number, TRUE, {ny, -nx}, {ny, -nx}, weight, entries, 0, -1, -1, 0, 0};
    g_array_append_val(contacts->rows, tangential);
}

/* What constraints tie together and what touches: what acts on one of these bodies moves no other. */
static void find_touching(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    memcpy(contacts->touching, contacts->tied, (gsize)model->bodies * sizeof(int32_t));
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerTouchingPair *pair = contacts->plates[tinker_contacts_closed(contacts, i)->plate].pair;
        if (pair != NULL && pair->point[1] < model->bodies)
            tinker_sets_join(contacts->touching, pair->point[0], pair->point[1]);
    }
    name_by_first(contacts->touching, model->bodies);
}

static int32_t set_of(const TinkerContacts *contacts, const TinkerContactRow *row)
{
    return contacts->touching[tinker_contacts_closed(contacts, (guint)row->contact)->body];
}

static int by_set(const void *left, const void *right, void *data)
{
    const TinkerContactRow *l = left, *r = right;
    const int32_t of_l = set_of(data, l), of_r = set_of(data, r);
    if (of_l != of_r) return of_l < of_r ? -1 : 1;
    if (l->contact != r->contact) return l->contact < r->contact ? -1 : 1;
    return l->tangential - r->tangential;
}

/* Whether constraints tie all that a body may meet to it. */
static gboolean is_all_tied(const TinkerContacts *contacts, int32_t body)
{
    const int32_t group = contacts->group[body];
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        if (contacts->group[i] == group && contacts->tied[i] != group) return FALSE;
    return TRUE;
}

TinkerContactElimination *tinker_contacts_elimination(TinkerContacts *contacts, gboolean may_meet, int32_t body)
{
    const gboolean others = may_meet && !is_all_tied(contacts, body);
    const int32_t *sets = others ? contacts->group : contacts->tied;
    TinkerContactElimination **own = &contacts->eliminations[others][sets[body]];
    if (*own == NULL) *own = tinker_contact_elimination_new(contacts->model, sets, body, contacts->column);
    return *own;
}

/* Whether no body has more equations than elimination takes: those of one body stand together. */
static gboolean may_be_eliminated(const TinkerContacts *contacts, guint first, guint count)
{
    guint of_one = 0;
    int32_t body = -1;
    if (contacts->model->constraints.turn_count > 0) return FALSE;
    for (guint i = first; i < first + count; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const int32_t next = tinker_contacts_closed(contacts, (guint)row->contact)->body;
        if (row->entries >= 0) return FALSE;
        of_one = next == body ? of_one + 1 : 1;
        body = next;
        if (of_one > TINKER_MOST_EQUATIONS) return FALSE;
    }
    return TRUE;
}

/* Rows that may be eliminated are of bodies that constraints alone join: what touches besides has entries. FALSE: no
 * memory. */
static gboolean add_block(TinkerContacts *contacts, guint first, guint count)
{
    const int32_t contact = g_array_index(contacts->rows, TinkerContactRow, first).contact;
    TinkerContactBlock block = {.first = (int32_t)first, .count = (int32_t)count};
    block.held = contacts->held[tinker_contacts_closed(contacts, (guint)contact)->body];
    for (guint i = first; i < first + count; i++)
        block.held |= g_array_index(contacts->rows, TinkerContactRow, i).entries >= 0;
    if (block.held && count > FEW_ROWS && may_be_eliminated(contacts, first, count)) {
        block.elimination =
            tinker_contacts_elimination(contacts, FALSE, tinker_contacts_closed(contacts, (guint)contact)->body);
        g_array_append_val(contacts->blocks, block);
        if (block.elimination != NULL) g_ptr_array_add(contacts->eliminated, block.elimination);
        return block.elimination != NULL && tinker_contact_elimination_make_room(block.elimination, count);
    }
    for (int moves = FALSE; moves <= TRUE; moves++)
        block.solve[moves] = tinker_dense_solve_new(block.count);
    g_array_append_val(contacts->blocks, block);
    return block.solve[FALSE] != NULL && block.solve[TRUE] != NULL;
}

/* Rows of one set stand together and are solved together. Answers the entries of all their matrices, at least 1; 0: no
 * memory. */
static gsize find_blocks(TinkerContacts *contacts)
{
    gsize entries = 0;
    find_touching(contacts);
    g_array_sort_with_data(contacts->rows, by_set, contacts);
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data;
    for (guint first = 0, end; first < contacts->rows->len; first = end) {
        for (end = first + 1;
             end < contacts->rows->len && set_of(contacts, &rows[end]) == set_of(contacts, &rows[first]);)
            end++;
        if (!add_block(contacts, first, end - first)) return 0;
        TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, contacts->blocks->len - 1);
        block->matrix = entries;
        if (block->elimination == NULL) entries += (gsize)(end - first) * (end - first);
    }
    return MAX(entries, 1);
}

static void list_equations(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const int32_t body = tinker_contacts_closed(contacts, (guint)row->contact)->body;
        TinkerContactEquation equation = {body, {row->row[0], row->row[1]}, {row->force[0], row->force[1]}, 0};
        contacts->equations[FALSE][i] = equation;
        memcpy(equation.force, equation.row, sizeof(equation.force));
        contacts->equations[TRUE][i] = equation;
    }
}

static gboolean make_equations(TinkerContacts *contacts, gsize count)
{
    for (int moves = FALSE; moves <= TRUE; moves++) {
        g_free(contacts->equations[moves]);
        contacts->equations[moves] = g_try_new(TinkerContactEquation, count);
    }
    return contacts->equations[FALSE] != NULL && contacts->equations[TRUE] != NULL;
}

/* What it held is not kept. FALSE: no memory. */
static gboolean make_room(double **array, gsize count)
{
    g_free(*array);
    *array = g_try_new(double, count);
    return *array != NULL;
}

/* FALSE: no memory. `entries`: of all blocks' matrices. */
static gboolean allot_pins(TinkerContacts *contacts, gsize rows, gsize entries)
{
    TinkerContactPins *pins = &contacts->pins;
    return make_room(&pins->free, 2 * rows) && make_room(&pins->answers, 2 * entries) &&
           make_room(&pins->found, rows) && make_room(&pins->before, rows);
}

/* FALSE: no memory. */
static gboolean allot_rows(TinkerContacts *contacts)
{
    const gsize rows = contacts->rows->len, entries = rows > 0 ? find_blocks(contacts) : 1;
    if (rows == 0) return TRUE;
    if (entries == 0 || !make_room(&contacts->delassus, entries) || !make_room(&contacts->demand, rows) ||
        !make_room(&contacts->base, rows) || !make_room(&contacts->found, rows) || !make_equations(contacts, rows))
        return FALSE;
    if (contacts->pin_count > 0 && !allot_pins(contacts, rows, entries)) return FALSE;
    list_equations(contacts);
    tinker_contacts_take_shares(contacts);
    return TRUE;
}

void tinker_contacts_take_shares(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
        contacts->base[i] = (row->tangential ? contact->base_friction : contact->base_normal) / row->weight;
    }
}

static void clear_rows(TinkerContacts *contacts)
{
    g_array_set_size(contacts->rows, 0);
    g_array_set_size(contacts->entries, 0);
    g_array_set_size(contacts->simple, 0);
    g_array_set_size(contacts->blocks, 0);
    g_ptr_array_set_size(contacts->eliminated, 0);
    contacts->any_slip_friction = FALSE;
    contacts->model->book_power[TINKER_BOOK_FRICTION] = 0;
}

/* Of one body, what resists comes behind all that touches. */
static void find_bearers(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        contact->bearer = -1;
        for (guint k = i; tinker_contacts_resists(contacts, contact) && k-- > 0;)
            if (tinker_contacts_closed(contacts, k)->plate == contacts->plates[contact->plate].bearer)
                contact->bearer = (int32_t)k;
    }
}

/* One that closes or opens leaves most of them in order. */
static void sort_closed(TinkerContacts *contacts)
{
    for (guint i = 1; i < contacts->closed->len; i++) {
        if (by_body(tinker_contacts_closed(contacts, i - 1), tinker_contacts_closed(contacts, i)) <= 0) continue;
        g_array_sort(contacts->closed, by_body);
        return;
    }
}

TinkerStatus tinker_contacts_list_rows(TinkerContacts *contacts)
{
    sort_closed(contacts);
    clear_rows(contacts);
    find_bearers(contacts);
    g_array_set_size(contacts->simple, contacts->closed->len);
    int32_t *simple = (int32_t *)(void *)contacts->simple->data, alone = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (tinker_contact_slip_share(contacts, contact) != 0) contacts->any_slip_friction = TRUE;
        if (stands_alone(contacts, i))
            simple[alone++] = (int32_t)i;
        else
            add_rows(contacts, (int32_t)i);
    }
    g_array_set_size(contacts->simple, (guint)alone);
    if (allot_rows(contacts)) return TINKER_OK;
    const gsize count = contacts->closed->len;
    tinker_contacts_open_all(contacts);
    return tinker_contacts_lack_memory(contacts, count);
}

void tinker_contacts_open_all(TinkerContacts *contacts)
{
    g_array_set_size(contacts->closed, 0);
    clear_rows(contacts);
}

TinkerStatus tinker_contacts_lack_memory(const TinkerContacts *contacts, gsize count)
{
    TinkerModel *model = contacts->model;
    model->lacks_memory = TRUE;
    tinker_model_tell_failure(model, _("there is no memory for the equations of %zu contacts at once"), count);
    return TINKER_FAILED;
}
