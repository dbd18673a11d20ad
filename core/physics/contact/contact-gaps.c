/* Bodies that turn, as contact sees them: their outlines, the pairs of them that may touch, and the gap functions of
 * these pairs, each of which is a plate of its own behind the tops. */
#include <math.h>
#include <string.h>

#include "physics/contact/contacts-private.h"
#include "physics/model/model-data.h"

/* Corners of a box, and of a top. */
#define BOX_CORNERS 4
/* Functions of one pair: of two boxes 4 corners over 4 edges, both ways. */
#define MOST_FUNCTIONS 32
/* So many bodies of a scene may meet each other; each pair costs its gap functions. */
#define MOST_SHAPES 64
/* Between two bodies, of which neither says how rough it is, and how it rebounds. */
#define USUAL_FRICTION    0.5
#define USUAL_RESTITUTION 0

/* Outlines --------------------------------------------------------------------------------------------------------- */

static double half_of(const TinkerBlockBatch *batch, int32_t row, int32_t meaning)
{
    return 0.5 * tinker_block_batch_meaning(batch, row, meaning, 0, 0);
}

static void take_box(TinkerOutline *outline, double *corners, double half_width, double half_height)
{
    const double box[] = {-half_width, -half_height, half_width,  -half_height,
                          half_width,  half_height,  -half_width, half_height};
    const double upright[] = {0, -half_height, 0, half_height};
    const gboolean line = !(half_width > 0) || !(half_height > 0);
    memcpy(corners, half_width > 0 ? box : upright, (line ? 4 : 8) * sizeof(double));
    *outline = (TinkerOutline){TINKER_OUTLINE_POLYGON, hypot(half_width, half_height), line ? 2 : BOX_CORNERS, corners};
}

static gboolean take_outline(TinkerOutline *outline, double *corners, const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerBody *body = batch->block_class->physics->body;
    const double width = half_of(batch, row, TINKER_MEANING_WIDTH), height = half_of(batch, row, TINKER_MEANING_HEIGHT);
    const double radius = tinker_block_batch_meaning(batch, row, TINKER_MEANING_RADIUS, 0, 0);
    if (body->shape == TINKER_SHAPE_DISC)
        *outline = (TinkerOutline){TINKER_OUTLINE_DISC, radius, 0, NULL};
    else if (body->shape == TINKER_SHAPE_BOX)
        take_box(outline, corners, width, height);
    return outline->radius > 0;
}

static gboolean is_solid_body(const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    return physics != NULL && physics->body != NULL && physics->body->degrees_of_freedom == 3 &&
           physics->body->shape != TINKER_SHAPE_NONE &&
           tinker_block_batch_meaning(batch, row, TINKER_MEANING_SOLID, 0, 0) != 0;
}

int32_t tinker_model_solid_bodies(const TinkerModel *model)
{
    int32_t count = 0;
    for (guint i = 0; model->turning > 0 && i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++)
            count += is_solid_body(batch, row);
    }
    return count;
}

gboolean tinker_model_bodies_meet(const TinkerModel *model)
{
    int32_t shapes = 0;
    for (int32_t i = 0; i < tinker_scene_block_count(model->scene); i++) {
        const TinkerBlockClass *block_class =
            tinker_scene_block_class(model->scene, tinker_scene_block_at(model->scene, i));
        const TinkerPhysics *physics = block_class == NULL ? NULL : block_class->physics;
        if (physics == NULL || physics->body == NULL || physics->body->degrees_of_freedom != 3) continue;
        shapes += physics->body->shape != TINKER_SHAPE_NONE;
    }
    return shapes <= MOST_SHAPES;
}

static void find_outlines(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    const gsize count = (gsize)model->bodies + (gsize)contacts->plate_count;
    contacts->outlines = g_new0(TinkerOutline, MAX(count, 1));
    contacts->corners = g_new0(double, MAX(2 * BOX_CORNERS * count, 1));
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++) {
            const int32_t body = tinker_model_centre(model, batch->ids[row]);
            if (body < 0 || body >= model->bodies || !is_solid_body(batch, row)) continue;
            TinkerOutline *outline = &contacts->outlines[body];
            if (take_outline(outline, contacts->corners + 2 * BOX_CORNERS * (gsize)body, batch, row))
                contacts->reach[body] = outline->radius;
        }
    }
    for (int32_t k = 0; k < contacts->plate_count; k++) {
        const TinkerPlate *plate = &contacts->plates[k];
        double *corners = contacts->corners + 2 * BOX_CORNERS * ((gsize)model->bodies + (gsize)k);
        const double ends[] = {-plate->half_width, plate->half_height, plate->half_width, plate->half_height};
        memcpy(corners, ends, sizeof(ends));
        contacts->outlines[model->bodies + k] =
            (TinkerOutline){TINKER_OUTLINE_TOP, hypot(plate->half_width, plate->half_height), 2, corners};
    }
}

/* Pairs ------------------------------------------------------------------------------------------------------------ */

/* The pairs of blocks that a joint, a gear or a rack holds together: these do not meet. Rods and ropes, which know no
 * angles, keep nothing from meeting. (transfer full) */
static GHashTable *joined_blocks(const TinkerModel *model)
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

static gboolean is_joined(GHashTable *joined, gint64 a, gint64 b)
{
    const gint64 key = (MIN(a, b) << 32) | MAX(a, b);
    return g_hash_table_contains(joined, &key);
}

typedef struct {
    TinkerContacts *contacts;
    GHashTable *joined;
    GArray *pairs, *functions, *plates; /* plates: of the functions */
} Listing;

static void add_pair(Listing *listing, TinkerTouchingPair pair, const TinkerPlate *like)
{
    TinkerGapFunction functions[MOST_FUNCTIONS];
    pair.count = tinker_gap_functions(pair.outline[0], pair.outline[1], functions, MOST_FUNCTIONS);
    pair.first = listing->contacts->plate_count + (int32_t)listing->functions->len;
    g_array_append_vals(listing->functions, functions, (guint)pair.count);
    for (int32_t i = 0; i < pair.count; i++) {
        TinkerPlate plate = *like;
        plate.half_width = functions[i].half_width;
        plate.half_height = 0;
        g_array_append_val(listing->plates, plate);
    }
    g_array_append_val(listing->pairs, pair);
}

static void add_supports_of(Listing *listing, int32_t body)
{
    const TinkerContacts *contacts = listing->contacts;
    const TinkerModel *model = contacts->model;
    for (int32_t k = 0; k < contacts->plate_count; k++) {
        const TinkerPlate *plate = &contacts->plates[k];
        if (is_joined(listing->joined, model->body_blocks[body], plate->block)) continue;
        add_pair(listing,
                 (TinkerTouchingPair){.point = {body, plate->point},
                                      .outline = {&contacts->outlines[body], &contacts->outlines[model->bodies + k]},
                                      .angle = {0, plate->orientation}},
                 plate);
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
                                  .static_friction = USUAL_FRICTION,
                                  .dynamic_friction = USUAL_FRICTION,
                                  .restitution = USUAL_RESTITUTION};
        if (!(contacts->reach[other] > 0)) continue;
        if (is_joined(listing->joined, model->body_blocks[body], like.block)) continue;
        add_pair(listing,
                 (TinkerTouchingPair){.point = {body, other},
                                      .outline = {&contacts->outlines[body], &contacts->outlines[other]}},
                 &like);
    }
}

/* The arrays do not move any more: plates may point into them. */
static void keep_lists(TinkerContacts *contacts, Listing *listing)
{
    const guint functions = listing->functions->len;
    contacts->gap_count = (int32_t)functions;
    contacts->pair_count = (int32_t)listing->pairs->len;
    contacts->plates = g_renew(TinkerPlate, contacts->plates, MAX((guint)contacts->plate_count + functions, 1));
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
        }
}

void tinker_contacts_list_gaps(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    Listing listing = {contacts, joined_blocks(model), g_array_new(FALSE, FALSE, sizeof(TinkerTouchingPair)),
                       g_array_new(FALSE, FALSE, sizeof(TinkerGapFunction)),
                       g_array_new(FALSE, FALSE, sizeof(TinkerPlate))};
    const gboolean meet = tinker_model_bodies_meet(model);
    find_outlines(contacts);
    for (int32_t body = 0; body < model->bodies; body++) {
        contacts->first_gap[body] = contacts->plate_count + (int32_t)listing.functions->len;
        if (contacts->reach[body] > 0) add_supports_of(&listing, body);
        if (contacts->reach[body] > 0 && meet) add_bodies_of(&listing, body);
    }
    contacts->first_gap[model->bodies] = contacts->plate_count + (int32_t)listing.functions->len;
    keep_lists(contacts, &listing);
    g_hash_table_unref(listing.joined);
}

/* States ----------------------------------------------------------------------------------------------------------- */

static TinkerBodyPose pose_of(const TinkerModel *model, const TinkerTouchingPair *pair, int which)
{
    const TinkerPoint *at = &model->point[pair->point[which]];
    TinkerBodyPose pose = {at->x, at->y, pair->angle[which], at->vx, at->vy, 0};
    const int32_t turn =
        pair->point[which] < model->bodies && model->turn_of != NULL ? model->turn_of[pair->point[which]] : -1;
    if (turn < 0) return pose;
    pose.angle = model->turns[turn].angle;
    pose.rate = model->turns[turn].rate;
    return pose;
}

static void measure(const TinkerContacts *contacts, const TinkerPlate *plate, TinkerGap *gap)
{
    const TinkerBodyPose first = pose_of(contacts->model, plate->pair, 0),
                         second = pose_of(contacts->model, plate->pair, 1);
    tinker_gap_measure(plate->gap, &first, &second, gap);
}

static TinkerContactPlace place_of(const TinkerGap *gap)
{
    return (TinkerContactPlace){gap->gap,         gap->along,  gap->normal_speed, gap->tangential_speed,
                                gap->along_speed, gap->rolled, gap->period};
}

TinkerContactPlace tinker_contact_gap_place(const TinkerContacts *contacts, int32_t number)
{
    TinkerGap gap;
    measure(contacts, &contacts->plates[number], &gap);
    return place_of(&gap);
}

gboolean tinker_contact_gap_is_over(const TinkerContacts *contacts, int32_t number, double tolerance)
{
    const TinkerPlate *plate = &contacts->plates[number];
    TinkerGap gap;
    if (plate->pair->passes) return FALSE;
    const TinkerBodyPose first = pose_of(contacts->model, plate->pair, 0),
                         second = pose_of(contacts->model, plate->pair, 1);
    tinker_gap_measure(plate->gap, &first, &second, &gap);
    return tinker_gap_is_over(plate->gap, &first, &second, &gap, tolerance);
}

double tinker_contact_pair_overlap(const TinkerContacts *contacts, const TinkerTouchingPair *pair)
{
    const TinkerBodyPose first = pose_of(contacts->model, pair, 0), second = pose_of(contacts->model, pair, 1);
    return tinker_outlines_overlap(pair->outline[0], &first, pair->outline[1], &second);
}

/* What a support's own motion adds. */
static void add_support(const TinkerModel *model, int32_t point, const TinkerGap *gap, int side,
                        TinkerContactEntries *entries)
{
    const double *a = model->point_acceleration + 2 * point;
    const TinkerPoint *at = &model->point[point];
    for (int which = 0; which < 2; which++) {
        const double *row = gap->row[which] + 3 * side;
        entries->of_supports[which] += row[0] * at->vx + row[1] * at->vy;
        entries->drift[which] += row[0] * a[0] + row[1] * a[1];
    }
}

static void add_entry(TinkerContactEntries *entries, int32_t coordinate, double normal, double tangential)
{
    entries->coordinate[entries->count] = coordinate;
    entries->row[0][entries->count] = normal;
    entries->row[1][entries->count++] = tangential;
}

void tinker_contact_gap_entries(const TinkerContacts *contacts, int32_t number, TinkerContactEntries *entries)
{
    const TinkerModel *model = contacts->model;
    const TinkerPlate *plate = &contacts->plates[number];
    TinkerGap gap;
    measure(contacts, plate, &gap);
    *entries = (TinkerContactEntries){.drift = {gap.drift[0], gap.drift[1]},
                                      .normal = {gap.normal[0], gap.normal[1]},
                                      .point = {gap.point[0], gap.point[1]}};
    for (int side = 0; side < 2; side++) {
        const int32_t point = plate->pair->point[side == 0 ? plate->gap->tip_of : 1 - plate->gap->tip_of];
        if (point >= model->bodies) {
            add_support(model, point, &gap, side, entries);
            continue;
        }
        const double *normal = gap.row[0] + 3 * side, *tangential = gap.row[1] + 3 * side;
        const int32_t turn = tinker_model_turn_of(model, point);
        add_entry(entries, 2 * point, normal[0], tangential[0]);
        add_entry(entries, 2 * point + 1, normal[1], tangential[1]);
        if (turn < 0) continue;
        const double gyration = model->turns[turn - 2 * model->bodies].gyration;
        add_entry(entries, turn, normal[2] / gyration, tangential[2] / gyration);
    }
}

double tinker_contact_times(const TinkerContactEntries *entries, int which, const double *by_coordinate)
{
    double sum = 0;
    for (int32_t k = 0; k < entries->count; k++)
        sum += entries->row[which][k] * by_coordinate[entries->coordinate[k]];
    return sum;
}
