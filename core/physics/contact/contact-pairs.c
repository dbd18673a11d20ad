/* Which bodies may meet what: the pairs of shapes, and their gap functions. */
#include <math.h>
#include <string.h>

#include "physics/contact/contacts-private.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
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

/* Listing ---------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerContacts *contacts;
    GHashTable *joined;
    GArray *pairs;
    GArray *functions; /* of one pair, for work */
    int32_t gaps, resistances, unturned;
} Listing;

static gboolean is_unturned(const TinkerModel *model, const TinkerTouchingPair *pair)
{
    return pair->top < 0 && tinker_model_turn_of(model, pair->point[0]) < 0 &&
           tinker_model_turn_of(model, pair->point[1]) < 0;
}

TinkerSurface tinker_contact_pair_surface(const TinkerContacts *contacts, const TinkerTouchingPair *pair)
{
    const TinkerSurface *own = &contacts->surfaces[pair->point[0]];
    if (pair->top >= 0) return tinker_surface_between(&contacts->plates[pair->top].surface, own);
    return tinker_surface_between(own, &contacts->surfaces[pair->point[1]]);
}

/* A mass meets a top as a point that stands off it: the seat is lifted to where the point is. It has no round seats,
 * and no corner of a top meets it. */
static int32_t lift_for_mass(TinkerGapFunction *edge, double lift)
{
    edge->rolls = FALSE;
    for (int k = 0; k < 2; k++)
        edge->seat[k] += lift * edge->normal[k];
    return 1;
}

/* Writes the gap functions of a pair, at most `room`; answers how many there are. Of two masses `both` gets what they
 * have in place of outlines. */
static int32_t find_functions(const TinkerContacts *contacts, const TinkerTouchingPair *pair, TinkerUnturned *both,
                              TinkerGapFunction *list, int32_t room)
{
    const int32_t body = pair->point[0], other = pair->point[1];
    if (is_unturned(contacts->model, pair)) {
        const TinkerOutline *outline = &contacts->outlines[body];
        const double angle = contacts->angle[body];
        tinker_unturned_init(both, outline, angle, &contacts->outlines[other], contacts->angle[other]);
        return tinker_unturned_functions(both, outline, angle, pair->way, list, room);
    }
    const int32_t count = tinker_gap_functions(pair->outline[0], pair->outline[1], list, room);
    const gboolean is_mass = pair->top >= 0 && !isnan(contacts->half_height[body]);
    return is_mass ? lift_for_mass(list, pair->lift) : count;
}

static void add_pair(Listing *listing, TinkerTouchingPair pair)
{
    const TinkerContacts *contacts = listing->contacts;
    const TinkerModel *model = contacts->model;
    const double *q = model->q_start;
    TinkerUnturned both;
    pair.first = contacts->plate_count + listing->gaps;
    pair.unturned = is_unturned(model, &pair) ? listing->unturned++ : -1;
    if (pair.unturned >= 0)
        for (int k = 0; k < 2; k++)
            pair.way[k] = q[2 * pair.point[0] + k] - q[2 * pair.point[1] + k];
    for (int which = 0; which < 2; which++) {
        pair.cosine[which] = cos(pair.angle[which]);
        pair.sine[which] = sin(pair.angle[which]);
    }
    const int32_t most =
        pair.unturned >= 0 ? MOST_FUNCTIONS : tinker_gap_functions_most(pair.outline[0], pair.outline[1]);
    g_array_set_size(listing->functions, (guint)most);
    TinkerGapFunction *functions = (TinkerGapFunction *)(gpointer)listing->functions->data;
    pair.count = find_functions(contacts, &pair, &both, functions, most);
    pair.rolls = tinker_contact_pair_surface(contacts, &pair).rolling > 0;
    for (int32_t i = 0; pair.rolls && i < pair.count; i++)
        listing->resistances += functions[i].rolls;
    listing->gaps += pair.count;
    g_array_append_val(listing->pairs, pair);
}

/* All tops of a body that turns; of a mass those that a motion turns. */
static void add_supports_of(Listing *listing, int32_t body)
{
    static const TinkerOutline point = {.kind = TINKER_OUTLINE_DISC};
    const TinkerContacts *contacts = listing->contacts;
    const TinkerModel *model = contacts->model;
    const gboolean is_mass = !isnan(contacts->half_height[body]);
    for (int32_t k = 0; k < contacts->plate_count; k++) {
        const TinkerPlate *top = &contacts->plates[k];
        if (is_mass && top->turned == NULL) continue;
        if (tinker_contacts_are_joined(listing->joined, model->body_blocks[body], top->block)) continue;
        add_pair(listing, (TinkerTouchingPair){.point = {body, top->point},
                                               .outline = {is_mass ? &point : &contacts->outlines[body],
                                                           &contacts->outlines[model->bodies + k]},
                                               .angle = {0, top->orientation},
                                               .turned = top->turned,
                                               .lift = is_mass ? contacts->half_height[body] : 0,
                                               .top = k,
                                               .moving = top->moving});
    }
}

/* With those that come behind it. */
static void add_bodies_of(Listing *listing, int32_t body)
{
    const TinkerContacts *contacts = listing->contacts;
    const TinkerModel *model = contacts->model;
    for (int32_t other = body + 1; other < model->bodies; other++) {
        if (!tinker_contacts_has_outline(contacts, other)) continue;
        if (tinker_contacts_are_joined(listing->joined, model->body_blocks[body], model->body_blocks[other])) continue;
        TinkerTouchingPair pair = {.point = {body, other},
                                   .outline = {&contacts->outlines[body], &contacts->outlines[other]},
                                   .angle = {contacts->angle[body], contacts->angle[other]},
                                   .top = -1};
        if (is_unturned(model, &pair)) pair.angle[0] = pair.angle[1] = 0; /* it is in their shapes */
        add_pair(listing, pair);
    }
}

/* Filling ---------------------------------------------------------------------------------------------------------- */

void tinker_contacts_fill_pair(TinkerContacts *contacts, TinkerTouchingPair *pair)
{
    if (pair->filled) return;
    pair->filled = TRUE;
    TinkerUnturned *both = pair->unturned >= 0 ? &contacts->unturned[pair->unturned] : NULL;
    TinkerGapFunction *functions = &contacts->functions[pair->first - contacts->plate_count];
    const TinkerModel *model = contacts->model;
    TinkerPlate like = {.point = pair->point[1]};
    find_functions(contacts, pair, both, functions, MAX(pair->count, 1));
    if (both != NULL) {
        pair->outline[0] = &both->point;
        pair->outline[1] = &both->around;
    }
    if (pair->top >= 0)
        like = contacts->plates[pair->top];
    else
        like.block = model->body_blocks[pair->point[1]];
    like.surface = tinker_contact_pair_surface(contacts, pair);
    like.half_height = 0;
    like.pair = pair;
    for (int32_t i = 0; i < pair->count; i++) {
        TinkerPlate *plate = &contacts->plates[pair->first + i];
        *plate = like;
        plate->half_width = functions[i].half_width;
        plate->gap = &functions[i];
    }
}

void tinker_contacts_fill_plate(TinkerContacts *contacts, int32_t number)
{
    int32_t first = 0, last = contacts->pair_count - 1;
    while (first < last) {
        const int32_t middle = first + (last - first + 1) / 2;
        if (contacts->pairs[middle].first <= number)
            first = middle;
        else
            last = middle - 1;
    }
    if (number >= contacts->plate_count) tinker_contacts_fill_pair(contacts, &contacts->pairs[first]);
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

/* What a pair may touch with is filled in when it comes near for the first time, as far as nothing resists its rolling:
 * until then it takes no memory, since the system gives none to what was cleared and never written. The arrays do not
 * move any more, so that plates may point into them. */
static void keep_lists(TinkerContacts *contacts, Listing *listing)
{
    const gsize tops = (gsize)contacts->plate_count, gaps = (gsize)listing->gaps;
    TinkerPlate *plates = g_new0(TinkerPlate, MAX(tops + gaps + (gsize)listing->resistances, 1));
    memcpy(plates, contacts->plates, tops * sizeof(TinkerPlate));
    g_free(contacts->plates);
    contacts->plates = plates;
    contacts->gap_count = listing->gaps;
    contacts->functions = g_new0(TinkerGapFunction, MAX(gaps, 1));
    contacts->unturned = g_new0(TinkerUnturned, MAX(listing->unturned, 1));
    contacts->pair_count = (int32_t)listing->pairs->len;
    contacts->pairs = (TinkerTouchingPair *)(gpointer)g_array_free(listing->pairs, FALSE);
    g_array_unref(listing->functions);
    for (int32_t i = 0; i < contacts->pair_count; i++) {
        TinkerTouchingPair *pair = &contacts->pairs[i];
        if (pair->rolls) tinker_contacts_fill_pair(contacts, pair);
        for (int32_t k = pair->first; pair->rolls && k < pair->first + pair->count; k++)
            if (contacts->plates[k].gap->rolls) add_resistance(contacts, k);
    }
}

void tinker_contacts_list_gaps(TinkerContacts *contacts, gboolean meet)
{
    const TinkerModel *model = contacts->model;
    Listing listing = {contacts,
                       tinker_contacts_joined_blocks(model),
                       g_array_new(FALSE, FALSE, sizeof(TinkerTouchingPair)),
                       g_array_new(FALSE, FALSE, sizeof(TinkerGapFunction)),
                       0,
                       0,
                       0};
    for (int32_t body = 0; body < model->bodies; body++) {
        contacts->first_gap[body] = contacts->plate_count + listing.gaps;
        if (tinker_contacts_may_touch(contacts, body)) add_supports_of(&listing, body);
        if (meet && tinker_contacts_has_outline(contacts, body)) add_bodies_of(&listing, body);
    }
    contacts->bodies_listed = meet;
    contacts->first_gap[model->bodies] = contacts->plate_count + listing.gaps;
    keep_lists(contacts, &listing);
    g_hash_table_unref(listing.joined);
}
