/* Which bodies may meet what: the pairs of shapes, and their gap functions. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/contact/contacts-private.h"
#include "physics/model/model-data.h"
#include "physics/shapes/unturned.h"

/* Functions of one pair of masses: of two boxes 4 corners over 4 edges, both ways. */
#define MOST_FUNCTIONS 32

/* Rods and ropes, which know no angles, keep nothing from meeting. */
GHashTable *tinker_contacts_joined_blocks(const TinkerModel *model)
{
    GHashTable *joined = g_hash_table_new_full(g_int64_hash, g_int64_equal, g_free, NULL);
    for (guint i = 0; i < model->constraints.batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(model->constraints.batches, TinkerConstraintBatch, i);
        const TinkerBlockBatch *batch = part->batch;
        const gboolean ties = part->constraint->joint != 0 || part->constraint->angles != 0;
        for (int32_t row = 0; ties && row < batch->count; row++) {
            const int32_t *ends = part->end_points + batch->end_offsets[row];
            if (batch->end_offsets[row + 1] - batch->end_offsets[row] < 2) continue;
            const gint64 a = tinker_model_block_of(model, ends[0]), b = tinker_model_block_of(model, ends[1]);
            const gint64 key = (MIN(a, b) << 32) | MAX(a, b);
            g_hash_table_add(joined, g_memdup2(&key, sizeof(key)));
        }
    }
    return joined;
}

gboolean tinker_contacts_are_joined(GHashTable *joined, gint64 a, gint64 b)
{
    const gint64 key = (MIN(a, b) << 32) | MAX(a, b);
    return g_hash_table_contains(joined, &key);
}

typedef struct {
    TinkerContacts *contacts;
    GHashTable *joined;
    GArray *pairs, *functions, *plates; /* plates: of the functions */
} Listing;

static void add_functions(Listing *listing, TinkerTouchingPair pair, const TinkerGapFunction *functions,
                          const TinkerPlate *like)
{
    pair.first = listing->contacts->plate_count + (int32_t)listing->functions->len;
    for (int which = 0; which < 2; which++) {
        pair.cosine[which] = cos(pair.angle[which]);
        pair.sine[which] = sin(pair.angle[which]);
    }
    g_array_append_vals(listing->functions, functions, (guint)pair.count);
    for (int32_t i = 0; i < pair.count; i++) {
        TinkerPlate plate = *like;
        plate.half_width = functions[i].half_width;
        plate.half_height = 0;
        g_array_append_val(listing->plates, plate);
    }
    g_array_append_val(listing->pairs, pair);
}

static void add_pair(Listing *listing, TinkerTouchingPair pair, const TinkerPlate *like)
{
    const int32_t most = tinker_gap_functions_most(pair.outline[0], pair.outline[1]);
    g_autofree TinkerGapFunction *functions = g_new(TinkerGapFunction, most);
    pair.count = tinker_gap_functions(pair.outline[0], pair.outline[1], functions, most);
    add_functions(listing, pair, functions, like);
}

/* Of two masses. */
static void add_unturned(Listing *listing, int32_t body, int32_t other, const TinkerPlate *like)
{
    const TinkerContacts *contacts = listing->contacts;
    const double *q = contacts->model->q_start,
                 way[2] = {q[2 * body] - q[2 * other], q[2 * body + 1] - q[2 * other + 1]};
    const TinkerOutline *outline = &contacts->outlines[body];
    TinkerGapFunction functions[MOST_FUNCTIONS];
    TinkerUnturned *both = g_new(TinkerUnturned, 1);
    tinker_unturned_init(both, outline, contacts->angle[body], &contacts->outlines[other], contacts->angle[other]);
    TinkerTouchingPair pair = {.point = {body, other}, .outline = {&both->point, &both->around}};
    pair.count = tinker_unturned_functions(both, outline, contacts->angle[body], way, functions, MOST_FUNCTIONS);
    g_ptr_array_add(contacts->unturned, both);
    add_functions(listing, pair, functions, like);
}

/* A mass meets a top as a point that stands off it: the seat is lifted to where the point is. It has no round seats,
 * and no corner of a top meets it. */
static void lift_for_mass(Listing *listing, double lift)
{
    TinkerTouchingPair *pair = &g_array_index(listing->pairs, TinkerTouchingPair, listing->pairs->len - 1);
    const guint first = (guint)(pair->first - listing->contacts->plate_count);
    TinkerGapFunction *edge = &g_array_index(listing->functions, TinkerGapFunction, first);
    pair->lift = lift;
    pair->count = 1;
    edge->rolls = FALSE;
    for (int k = 0; k < 2; k++)
        edge->seat[k] += lift * edge->normal[k];
    g_array_set_size(listing->functions, first + 1);
    g_array_set_size(listing->plates, first + 1);
}

/* All tops of a body that turns; of a mass those that a motion turns. */
static void add_supports_of(Listing *listing, int32_t body)
{
    static const TinkerOutline point = {.kind = TINKER_OUTLINE_DISC};
    const TinkerContacts *contacts = listing->contacts;
    const TinkerModel *model = contacts->model;
    const gboolean is_mass = !isnan(contacts->half_height[body]);
    for (int32_t k = 0; k < contacts->plate_count; k++) {
        TinkerPlate like = contacts->plates[k];
        if (is_mass && like.turned == NULL) continue;
        if (tinker_contacts_are_joined(listing->joined, model->body_blocks[body], like.block)) continue;
        like.surface = tinker_surface_between(&like.surface, &contacts->surfaces[body]);
        add_pair(listing,
                 (TinkerTouchingPair){
                     .point = {body, like.point},
                     .outline = {is_mass ? &point : &contacts->outlines[body], &contacts->outlines[model->bodies + k]},
                     .angle = {0, like.orientation},
                     .turned = like.turned},
                 &like);
        if (is_mass) lift_for_mass(listing, contacts->half_height[body]);
    }
}

/* With those that come behind it. */
static void add_bodies_of(Listing *listing, int32_t body)
{
    const TinkerContacts *contacts = listing->contacts;
    const TinkerModel *model = contacts->model;
    for (int32_t other = body + 1; other < model->bodies; other++) {
        const TinkerPlate like = {.block = model->body_blocks[other],
                                  .point = other,
                                  .surface =
                                      tinker_surface_between(&contacts->surfaces[body], &contacts->surfaces[other])};
        if (!tinker_contacts_has_outline(contacts, other)) continue;
        if (tinker_contacts_are_joined(listing->joined, model->body_blocks[body], like.block)) continue;
        if (tinker_model_turn_of(model, body) < 0 && tinker_model_turn_of(model, other) < 0) {
            add_unturned(listing, body, other, &like);
            continue;
        }
        add_pair(listing,
                 (TinkerTouchingPair){.point = {body, other},
                                      .outline = {&contacts->outlines[body], &contacts->outlines[other]},
                                      .angle = {contacts->angle[body], contacts->angle[other]}},
                 &like);
    }
}

/* What resists the rolling of a gap function; its arm is the radius of what rolls. */
static void add_resistance(TinkerContacts *contacts, int32_t number)
{
    TinkerPlate *bearer = &contacts->plates[number];
    const int32_t last = tinker_contacts_first_pin(contacts); /* there are no pins yet */
    contacts->resistance_count++;
    const double arm = fmax(bearer->gap->tip_radius, bearer->gap->seat_radius), share = bearer->surface.rolling / arm;
    bearer->resistance = last;
    contacts->plates[last] = *bearer;
    contacts->plates[last].resistance = 0;
    contacts->plates[last].surface = (TinkerSurface){share, share, 0, 0};
    contacts->plates[last].arm = arm;
    contacts->plates[last].bearer = number;
    for (int side = 0; side < 2; side++) {
        const int which = side == 0 ? bearer->gap->tip_of : 1 - bearer->gap->tip_of;
        contacts->plates[last].frame[side] = bearer->pair->point[which];
        contacts->plates[last].frame_turned[side] = which == 1 ? bearer->pair->turned : NULL;
    }
}

/* The arrays do not move any more: plates may point into them. */
static void keep_lists(TinkerContacts *contacts, Listing *listing)
{
    const guint functions = listing->functions->len;
    contacts->gap_count = (int32_t)functions;
    contacts->pair_count = (int32_t)listing->pairs->len;
    const guint most = (guint)contacts->plate_count + 2 * functions;
    contacts->plates = g_renew(TinkerPlate, contacts->plates, MAX(most, 1));
    if (functions > 0)
        memcpy(contacts->plates + contacts->plate_count, listing->plates->data, functions * sizeof(TinkerPlate));
    g_array_unref(listing->plates);
    contacts->pairs = (TinkerTouchingPair *)(gpointer)g_array_free(listing->pairs, FALSE);
    contacts->functions = (TinkerGapFunction *)(gpointer)g_array_free(listing->functions, FALSE);
    for (int32_t i = 0; i < contacts->pair_count; i++)
        for (int32_t k = 0; k < contacts->pairs[i].count; k++) {
            TinkerPlate *plate = &contacts->plates[contacts->pairs[i].first + k];
            plate->pair = &contacts->pairs[i];
            plate->gap = &contacts->functions[contacts->pairs[i].first + k - contacts->plate_count];
            if (plate->surface.rolling > 0 && plate->gap->rolls) add_resistance(contacts, contacts->pairs[i].first + k);
        }
}

void tinker_contacts_list_gaps(TinkerContacts *contacts, gboolean meet)
{
    const TinkerModel *model = contacts->model;
    Listing listing = {
        contacts, tinker_contacts_joined_blocks(model), g_array_new(FALSE, FALSE, sizeof(TinkerTouchingPair)),
        g_array_new(FALSE, FALSE, sizeof(TinkerGapFunction)), g_array_new(FALSE, FALSE, sizeof(TinkerPlate))};
    for (int32_t body = 0; body < model->bodies; body++) {
        contacts->first_gap[body] = contacts->plate_count + (int32_t)listing.functions->len;
        if (tinker_contacts_may_touch(contacts, body)) add_supports_of(&listing, body);
        if (meet && tinker_contacts_has_outline(contacts, body)) add_bodies_of(&listing, body);
    }
    contacts->bodies_listed = meet;
    contacts->first_gap[model->bodies] = contacts->plate_count + (int32_t)listing.functions->len;
    keep_lists(contacts, &listing);
    g_hash_table_unref(listing.joined);
}

/* Told of at the start ----------------------------------------------------------------------------------------------
 */

void tinker_contacts_tell_overlap(const TinkerContacts *contacts, const int32_t point[2], double overlap, guint *told,
                                  GPtrArray *warnings)
{
    TinkerModel *model = contacts->model;
    if (!(overlap > TINKER_TOUCHING) || ++*told > TINKER_OVERLAPS_TOLD) return;
    const char *first = tinker_scene_block_name(model->scene, tinker_model_block_of(model, point[0]));
    const char *second = tinker_scene_block_name(model->scene, tinker_model_block_of(model, point[1]));
    g_ptr_array_add(warnings,
                    g_strdup_printf(_("%s and %s overlap at the start, by %.4g m: they pass through each other until "
                                      "they have parted (place them apart, and they meet)"),
                                    first, second, overlap));
}

void tinker_contacts_tell_more_overlaps(guint told, GPtrArray *warnings)
{
    if (told <= TINKER_OVERLAPS_TOLD) return;
    g_ptr_array_add(warnings,
                    g_strdup_printf(_("and %u more pairs overlap at the start (mend the first ones, and these are "
                                      "told of)"),
                                    told - TINKER_OVERLAPS_TOLD));
}

void tinker_contacts_tell_overlaps(const TinkerContacts *contacts, GPtrArray *warnings)
{
    guint told = 0;
    for (int32_t i = 0; i < contacts->pair_count; i++) {
        const TinkerTouchingPair *pair = &contacts->pairs[i];
        tinker_contacts_tell_overlap(contacts, pair->point, tinker_contact_pair_overlap(contacts, pair), &told,
                                     warnings);
    }
    tinker_contacts_tell_more_overlaps(told, warnings);
}
