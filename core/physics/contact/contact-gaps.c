/* Bodies that meet each other, and those that turn, as contact sees them: their outlines, and their gap functions for a
 * state of the model. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/contact/contacts-private.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/shapes/outline-parts.h"

/* Corners of a box, and of a top. */
#define BOX_CORNERS 4
/* So many bodies of a scene may meet each other: any two of them are a pair, of which 200 bytes are kept and places for
 * its gap functions are set aside, up to 15 kB of two boxes. */
#define MOST_SHAPES 256
/* So many others a body counts as whose shape are its points, which may have as many corners as 16 boxes. */
#define OF_POINTS 4

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
    const gboolean wide = half_width > 0, high = half_height > 0;
    const int32_t count = wide && high ? BOX_CORNERS : wide || high ? 2 : 1;
    memcpy(corners, wide ? box : upright, 2 * (gsize)count * sizeof(double));
    *outline = (TinkerOutline){TINKER_OUTLINE_POLYGON, hypot(half_width, half_height), count, corners};
}

/* The points of a body whose shape they are; NULL: of another, or where they are more than contact takes. */
static const TinkerPointList *points_of(const TinkerBlockBatch *batch, int32_t row)
{
    if (batch->block_class->physics->body->shape != TINKER_SHAPE_OUTLINE || batch->point_list_count == 0) return NULL;
    const TinkerPointList *points = &batch->point_lists[row * batch->point_list_count];
    return points->count >= 3 && points->count <= TINKER_MOST_CORNERS ? points : NULL;
}

/* What is not convex lies behind its corners cut into triangles. */
static void take_points(TinkerOutline *outline, double *corners, const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerPointList *points = points_of(batch, row);
    const double origin[] = {tinker_block_batch_meaning(batch, row, TINKER_MEANING_CENTRE_OF_MASS, 0, 0),
                             tinker_block_batch_meaning(batch, row, TINKER_MEANING_CENTRE_OF_MASS, 1, 0)};
    const int32_t count = tinker_outline_normalise(points->points, points->count, origin, corners);
    *outline = (TinkerOutline){TINKER_OUTLINE_POLYGON, 0, count, corners, 0, NULL};
    for (int32_t i = 0; i < count; i++)
        outline->radius = fmax(outline->radius, hypot(corners[2 * i], corners[2 * i + 1]));
    if (tinker_outline_is_convex(corners, count)) return;
    double *triangles = corners + 2 * points->count;
    tinker_outline_cut(corners, count, triangles);
    outline->triangle_count = count - 2;
    outline->triangles = triangles;
}

/* How many doubles its outline takes at most. */
static gsize room_of(const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerPointList *points = points_of(batch, row);
    return points == NULL ? 2 * BOX_CORNERS : (2 + 6) * (gsize)points->count;
}

static void take_outline(TinkerOutline *outline, double *corners, const TinkerBlockBatch *batch, int32_t row)
{
    const TinkerBody *body = batch->block_class->physics->body;
    if (body->shape == TINKER_SHAPE_OUTLINE) {
        take_points(outline, corners, batch, row);
        return;
    }
    const double width = half_of(batch, row, TINKER_MEANING_WIDTH), height = half_of(batch, row, TINKER_MEANING_HEIGHT);
    const double radius = tinker_block_batch_meaning(batch, row, TINKER_MEANING_RADIUS, 0, 0);
    if (body->shape == TINKER_SHAPE_DISC)
        *outline = (TinkerOutline){TINKER_OUTLINE_DISC, radius, 0, NULL};
    else if (body->shape == TINKER_SHAPE_BOX)
        take_box(outline, corners, width, height);
}

/* What makes a body of this class meet others (TINKER_MEANING_...); TINKER_MEANING_NONE: nothing does. */
static int32_t meets_by(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class == NULL ? NULL : block_class->physics;
    if (physics == NULL || physics->body == NULL || physics->body->shape == TINKER_SHAPE_NONE)
        return TINKER_MEANING_NONE;
    if (physics->body->degrees_of_freedom == 3) return TINKER_MEANING_SOLID;
    const gboolean box = physics->body->degrees_of_freedom == 2 && physics->body->shape == TINKER_SHAPE_BOX;
    return box ? TINKER_MEANING_COLLIDES : TINKER_MEANING_NONE;
}

static gboolean meets_others(const TinkerBlockBatch *batch, int32_t row)
{
    const int32_t meaning = meets_by(batch->block_class);
    if (meaning == TINKER_MEANING_NONE || tinker_block_batch_meaning(batch, row, meaning, 0, 0) == 0) return FALSE;
    return batch->block_class->physics->body->shape != TINKER_SHAPE_OUTLINE || points_of(batch, row) != NULL;
}

int32_t tinker_model_meeting_bodies(const TinkerModel *model)
{
    int32_t count = 0;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; meets_by(batch->block_class) != TINKER_MEANING_NONE && row < batch->count; row++)
            count += meets_others(batch, row);
    }
    return count;
}

/* Of the whole scene, up to so many; one whose shape are its points as `of_points`. */
static int32_t count_meeting(TinkerScene *scene, int32_t most, int32_t of_points)
{
    int32_t count = 0;
    for (int32_t i = 0; count < most && i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        const int32_t meaning = meets_by(block_class);
        if (meaning == TINKER_MEANING_NONE) continue;
        const int32_t column = tinker_block_class_meaning_column(block_class, meaning);
        if (column < 0 || tinker_scene_get(scene, block, column) == 0) continue;
        count += block_class->physics->body->shape == TINKER_SHAPE_OUTLINE ? of_points : 1;
    }
    return count;
}

gboolean tinker_model_bodies_meet(const TinkerModel *model)
{
    return count_meeting(model->scene, MOST_SHAPES + 1, OF_POINTS) <= MOST_SHAPES;
}

char *tinker_contacts_unmet(const TinkerModel *model)
{
    if (tinker_model_meeting_bodies(model) < 2 || tinker_model_bodies_meet(model)) return NULL;
    return g_strdup_printf(
        _("contact by events is worked out among at most %d bodies of a scene (a plate counts as %d): the "
          "%d that could meet here pass through each other (with contacts as impulses they meet)"),
        MOST_SHAPES, OF_POINTS, count_meeting(model->scene, G_MAXINT32, 1));
}

/* Those of bodies that meet others; *room is the first that is free of contacts->corners. */
static void find_bodies(TinkerContacts *contacts, double **room)
{
    const TinkerModel *model = contacts->model;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++) {
            const int32_t body = tinker_model_centre(model, batch->ids[row]);
            if (body < 0 || body >= model->bodies || !meets_others(batch, row)) continue;
            TinkerOutline *outline = &contacts->outlines[body];
            take_outline(outline, *room, batch, row);
            *room += room_of(batch, row);
            contacts->reach[body] = outline->radius;
            contacts->angle[body] = tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0);
        }
    }
}

/* How many doubles all of them take at most. */
static gsize room_of_all(const TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    gsize room = 2 * BOX_CORNERS * (gsize)contacts->plate_count + 1;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        for (int32_t row = 0; row < batch->count; row++)
            if (meets_others(batch, row)) room += room_of(batch, row);
    }
    return room;
}

void tinker_contacts_find_outlines(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    const gsize count = (gsize)model->bodies + (gsize)contacts->plate_count;
    contacts->outlines = g_new0(TinkerOutline, MAX(count, 1));
    contacts->corners = g_new0(double, room_of_all(contacts));
    double *corners = contacts->corners;
    find_bodies(contacts, &corners);
    for (int32_t k = 0; k < contacts->plate_count; k++, corners += 2 * BOX_CORNERS) {
        const TinkerPlate *plate = &contacts->plates[k];
        const double ends[] = {-plate->half_width, plate->half_height, plate->half_width, plate->half_height};
        memcpy(corners, ends, sizeof(ends));
        contacts->outlines[model->bodies + k] =
            (TinkerOutline){TINKER_OUTLINE_TOP, hypot(plate->half_width, plate->half_height), 2, corners};
    }
}

/* States ----------------------------------------------------------------------------------------------------------- */

static TinkerBodyPose pose_of(const TinkerModel *model, const TinkerTouchingPair *pair, int which)
{
    const TinkerPoint *at = &model->point[pair->point[which]];
    const TinkerTurn *turn = pair->point[which] < model->bodies ? tinker_model_turn(model, pair->point[which]) : NULL;
    TinkerBodyPose pose = {at->x, at->y, pair->angle[which], at->vx, at->vy, 0, pair->cosine[which], pair->sine[which]};
    if (turn != NULL) {
        pose.angle = turn->angle;
        pose.rate = turn->rate;
        pose.cosine = turn->cosine;
        pose.sine = turn->sine;
    } else if (pair->turned != NULL && which == 1) {
        pose.angle += pair->turned->angle;
        pose.rate = pair->turned->rate;
        pose.cosine = cos(pose.angle);
        pose.sine = sin(pose.angle);
    }
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

/* How one of the frames of what resists turning is turned. */
static TinkerPose turned_frame(const TinkerModel *model, const TinkerPlate *plate, int side)
{
    const int32_t point = plate->frame[side];
    const TinkerTurn *turn = point < model->bodies ? tinker_model_turn(model, point) : NULL;
    const TinkerPlace *place = plate->frame_turned[side];
    if (turn != NULL) return (TinkerPose){turn->angle, turn->rate, 0};
    return place != NULL ? (TinkerPose){place->angle, place->rate, place->angular_acceleration} : (TinkerPose){0, 0, 0};
}

static TinkerContactPlace resisting_place(const TinkerContacts *contacts, const TinkerPlate *plate)
{
    const TinkerPose on = turned_frame(contacts->model, plate, 0), by = turned_frame(contacts->model, plate, 1);
    const double speed = plate->arm * (on.rate - by.rate);
    return (TinkerContactPlace){
        .tangential_speed = speed, .along_speed = speed, .rolled = plate->arm * (on.angle - by.angle)};
}

TinkerContactPlace tinker_contact_gap_place(const TinkerContacts *contacts, int32_t number)
{
    TinkerGap gap;
    if (contacts->plates[number].arm > 0) return resisting_place(contacts, &contacts->plates[number]);
    measure(contacts, &contacts->plates[number], &gap);
    return place_of(&gap);
}

double tinker_contact_gap_alone(const TinkerContacts *contacts, int32_t number)
{
    const TinkerPlate *plate = &contacts->plates[number];
    if (plate->arm > 0) return resisting_place(contacts, plate).gap;
    const TinkerBodyPose first = pose_of(contacts->model, plate->pair, 0),
                         second = pose_of(contacts->model, plate->pair, 1);
    return tinker_gap_alone(plate->gap, &first, &second);
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

/* The seat of a gap function, in the world: a point of the edge, and where it faces. */
static void seat_line(const TinkerContacts *contacts, const TinkerPlate *plate, double point[2], double normal[2])
{
    const TinkerBodyPose pose = pose_of(contacts->model, plate->pair, 1 - plate->gap->tip_of);
    const double *seat = plate->gap->seat, *out = plate->gap->normal;
    point[0] = pose.x + pose.cosine * seat[0] - pose.sine * seat[1];
    point[1] = pose.y + pose.sine * seat[0] + pose.cosine * seat[1];
    normal[0] = pose.cosine * out[0] - pose.sine * out[1];
    normal[1] = pose.sine * out[0] + pose.cosine * out[1];
}

/* Edges of a notch that one body touches are not one line; and what resists rolling is no corner. */
gboolean tinker_contacts_on_one_line(const TinkerContacts *contacts, int32_t number, int32_t other)
{
    const TinkerPlate *plate = &contacts->plates[number], *beside = &contacts->plates[other];
    if (plate->gap == NULL || plate->gap->round || beside->pair != plate->pair || beside->gap->round) return FALSE;
    if (plate->arm > 0 || beside->arm > 0) return FALSE;
    if (number == other) return TRUE;
    double at[2], off[2], normal[2], facing[2];
    seat_line(contacts, plate, at, normal);
    seat_line(contacts, beside, off, facing);
    const double reach = fmin(plate->pair->outline[0]->radius, plate->pair->outline[1]->radius);
    const double apart = normal[0] * (off[0] - at[0]) + normal[1] * (off[1] - at[1]);
    return fabs(normal[0] * facing[1] - normal[1] * facing[0]) <= TINKER_ONE_LINE &&
           fabs(apart) <= TINKER_ONE_LINE * reach;
}

double tinker_contact_pair_overlap(TinkerContacts *contacts, TinkerTouchingPair *pair)
{
    tinker_contacts_fill_pair(contacts, pair);
    const TinkerBodyPose first = pose_of(contacts->model, pair, 0), second = pose_of(contacts->model, pair, 1);
    return tinker_outlines_overlap(pair->outline[0], &first, pair->outline[1], &second);
}

/* What a support's own motion adds. */
static void add_support(const TinkerModel *model, const TinkerTouchingPair *pair, const TinkerGap *gap, int side,
                        TinkerContactEntries *entries)
{
    const double *a = model->point_acceleration + 2 * pair->point[1];
    const TinkerPoint *at = &model->point[pair->point[1]];
    const double rate = pair->turned != NULL ? pair->turned->rate : 0,
                 alpha = pair->turned != NULL ? pair->turned->angular_acceleration : 0;
    for (int which = 0; which < 2; which++) {
        const double *row = gap->row[which] + 3 * side;
        entries->of_supports[which] += row[0] * at->vx + row[1] * at->vy + row[2] * rate;
        entries->drift[which] += row[0] * a[0] + row[1] * a[1] + row[2] * alpha;
    }
}

static void add_entry(TinkerContactEntries *entries, int32_t coordinate, double normal, double tangential)
{
    entries->coordinate[entries->count] = coordinate;
    entries->row[0][entries->count] = normal;
    entries->row[1][entries->count++] = tangential;
}

/* Of what resists turning: no normal, and turns alone. The places of its bodies stand beside them with nothing, so that
 * what cancels there at rest is cleared as well. */
static void resisting_entries(const TinkerContacts *contacts, const TinkerPlate *plate, TinkerContactEntries *entries)
{
    const TinkerModel *model = contacts->model;
    *entries = (TinkerContactEntries){0};
    for (int side = 0; side < 2; side++) {
        const int32_t point = plate->frame[side];
        const double arm = side == 0 ? plate->arm : -plate->arm;
        const TinkerTurn *turn = point < model->bodies ? tinker_model_turn(model, point) : NULL;
        const TinkerPose pose = turned_frame(model, plate, side);
        if (point >= model->bodies) {
            entries->of_supports[1] += arm * pose.rate;
            entries->drift[1] += arm * pose.acceleration;
        }
        if (turn == NULL) continue;
        add_entry(entries, 2 * point, 0, 0);
        add_entry(entries, 2 * point + 1, 0, 0);
        add_entry(entries, tinker_model_turn_of(model, point), 0, arm / turn->gyration);
    }
}

void tinker_contact_gap_entries(const TinkerContacts *contacts, int32_t number, TinkerContactEntries *entries)
{
    const TinkerModel *model = contacts->model;
    const TinkerPlate *plate = &contacts->plates[number];
    TinkerGap gap;
    if (plate->arm > 0) {
        resisting_entries(contacts, plate, entries);
        return;
    }
    measure(contacts, plate, &gap);
    *entries = (TinkerContactEntries){
        .drift = {gap.drift[0], gap.drift[1]},
        .normal = {gap.normal[0], gap.normal[1]},
        .point = {gap.point[0] - plate->pair->lift * gap.normal[0], gap.point[1] - plate->pair->lift * gap.normal[1]}};
    for (int side = 0; side < 2; side++) {
        const int32_t point = plate->pair->point[side == 0 ? plate->gap->tip_of : 1 - plate->gap->tip_of];
        if (point >= model->bodies) {
            add_support(model, plate->pair, &gap, side, entries);
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
