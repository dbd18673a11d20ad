/* What may touch what: compiling. */
#include "physics/contact/contacts-private.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/contact/contact-neighbours.h"
#include "physics/contact/contact-pins.h"
#include "physics/contact/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

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

/* What constraints tie together, and what may meet besides. */
static void find_groups(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    const TinkerConstraints *all = &model->constraints;
    tinker_sets_begin(contacts->tied, model->bodies);
    for (int32_t row = 0; row < all->rows; row++)
        tinker_contacts_tie(model, row, contacts->tied);
    tinker_sets_settle(contacts->tied, model->bodies);
    memcpy(contacts->group, contacts->tied, (gsize)model->bodies * sizeof(int32_t));
    for (int32_t row = 0; row < all->rows; row++)
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            if (all->points[e] < model->bodies) contacts->held[all->points[e]] = TRUE;
    for (int32_t i = 0; i < contacts->pair_count; i++)
        if (contacts->pairs[i].point[1] < model->bodies)
            tinker_sets_join(contacts->group, contacts->pairs[i].point[0], contacts->pairs[i].point[1]);
    tinker_sets_settle(contacts->group, model->bodies);
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

int32_t tinker_contacts_plate_of_part(TinkerContacts *contacts, const TinkerContacts *part,
                                      const TinkerContact *contact, int32_t body)
{
    const int32_t gaps = part->plate_count, others = gaps + part->gap_count;
    const int32_t later = contacts->first_gap[body] - part->first_gap[contact->body];
    const TinkerPlate *plate = &part->plates[contact->plate];
    if (contact->plate < gaps) return contact->plate;
    if (contact->plate < others) {
        tinker_contacts_fill_plate(contacts, contact->plate + later);
        return contact->plate + later;
    }
    if (plate->bearer >= 0) return contacts->plates[plate->bearer + later].resistance;
    int32_t pin = tinker_contacts_first_pin(contacts);
    while (pin < tinker_contacts_plates(contacts) - 1 && contacts->plates[pin].block != plate->block)
        pin++;
    return pin;
}

static void open_books_of(TinkerModel *model, const TinkerPlate *plate)
{
    if (plate->surface.dynamic_friction > 0) model->has_book[TINKER_BOOK_FRICTION] = TRUE;
    if (plate->moving) model->has_book[TINKER_BOOK_SUPPORT_MOTION] = model->more_than_lines = TRUE;
}

/* Those that contacts write into: which books there are does not change in a run. Of gap functions their pairs tell. */
static void open_books(TinkerContacts *contacts)
{
    TinkerModel *model = contacts->model;
    for (int32_t i = 0; i < contacts->pair_count; i++)
        if (tinker_contact_pair_surface(contacts, &contacts->pairs[i]).dynamic_friction > 0)
            model->has_book[TINKER_BOOK_FRICTION] = TRUE;
    for (int32_t k = 0; k < contacts->plate_count; k++)
        open_books_of(model, &contacts->plates[k]);
    for (int32_t k = contacts->plate_count + contacts->gap_count; k < tinker_contacts_plates(contacts); k++)
        open_books_of(model, &contacts->plates[k]);
}

/* Scenes list them in this order. */
static TinkerImpactLaw law_of(TinkerScene *scene)
{
    int law = 0;
    while (!g_str_equal(tinker_scene_impact_laws[law], tinker_scene_head(scene)->run.impact_law))
        law++;
    return (TinkerImpactLaw)law;
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
                         contacts->asked,
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
                         contacts->unturned,
                         contacts->corners,
                         contacts->pins.free,
                         contacts->pins.answers,
                         contacts->pins.found,
                         contacts->pins.before};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(contacts);
}

int32_t tinker_contacts_outlines(const TinkerContacts *contacts)
{
    int32_t count = 0;
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        count += tinker_contacts_has_outline(contacts, i);
    return count;
}

gboolean tinker_contacts_can_meet(const TinkerContacts *contacts)
{
    return contacts != NULL && (contacts->plate_count > 0 || tinker_contacts_outlines(contacts) > 1);
}

static gboolean leaves(const TinkerContactPlace *place)
{
    return place->normal_speed > 1e-12 * fmax(fabs(place->tangential_speed), TINKER_SLOWEST);
}

static gboolean pair_touches(TinkerContacts *contacts, TinkerTouchingPair *pair)
{
    if (tinker_contact_pair_is_apart(contacts, pair)) return FALSE;
    tinker_contacts_fill_pair(contacts, pair);
    for (int32_t k = pair->first; k < pair->first + pair->count; k++) {
        const TinkerContactPlace place = tinker_contact_gap_place(contacts, k);
        if (fabs(place.gap) <= TINKER_TOUCHING && tinker_contact_gap_is_over(contacts, k, TINKER_TOUCHING) &&
            !leaves(&place))
            return TRUE;
    }
    return FALSE;
}

gboolean tinker_contacts_touch(TinkerContacts *contacts)
{
    if (contacts->pin_count > 0) return TRUE;
    for (int32_t body = 0; body < contacts->model->bodies; body++)
        for (int32_t k = 0; k < contacts->plate_count; k++) {
            TinkerContactPlace place = tinker_contact_place(contacts, body, k);
            double beside = fabs(place.along) - contacts->plates[k].half_width;
            if (fabs(place.gap) <= TINKER_TOUCHING && beside <= TINKER_TOUCHING && !leaves(&place)) return TRUE;
        }
    for (int32_t i = 0; i < contacts->pair_count; i++)
        if (pair_touches(contacts, &contacts->pairs[i])) return TRUE;
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
