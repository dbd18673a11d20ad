/* Writing places as one step that keeps lengths.
 *
 * A length that is left to the drawing follows the bodies. That is right while a scene is drawn, and wrong for a start
 * condition: a spring that is to be stretched would take the stretched length for its rest. Such a length is therefore
 * given explicitly where the step changes the distance of the ends; a rigid connector, which has no other length,
 * refuses. */
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/start-private.h"
#include "scene/frame/overlaps.h"

/* A connector with a length, as it was before the step. */
typedef struct {
    TinkerBlockId connector;
    TinkerSceneEnd ends[2];
    double distance, length; /* m */
    gboolean follows;        /* the length is left to the drawing, which the step has changed */
} Span;

typedef struct {
    GArray *spans;   /* of Span */
    GArray *centres; /* of StartPlace: of the same bodies */
} Before;

double start_distance(const TinkerFrame *frame, TinkerSceneEnd a, TinkerSceneEnd b)
{
    double from[2], to[2];
    tinker_frame_end(frame, a, from);
    tinker_frame_end(frame, b, to);
    return hypot(to[0] - from[0], to[1] - from[1]);
}

void start_velocity_of(const TinkerFrame *frame, TinkerBlockId body, double velocity[2])
{
    for (int32_t k = 0; k < 2; k++)
        velocity[k] = tinker_frame_meaning(frame, body, TINKER_MEANING_VELOCITY, k, 0);
}

char *start_quantity_text(TinkerScene *scene, double si, TinkerDimension dimension)
{
    return tinker_quantity_brief(si, dimension, tinker_scene_head(scene)->units);
}

/* Every connector with a length of which an end is on one of the bodies. */
static GArray *note_spans(const TinkerFrame *frame, const GArray *places)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    GArray *spans = g_array_new(FALSE, FALSE, sizeof(Span));
    g_autofree gboolean *moved = g_new0(gboolean, MAX(tinker_scene_id_limit(scene), 1));
    for (guint i = 0; i < places->len; i++)
        moved[g_array_index(places, StartPlace, i).body] = !isnan(g_array_index(places, StartPlace, i).place[0]);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        Span span = {.connector = tinker_scene_block_at(scene, i)};
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, span.connector);
        if (!start_has_rest_length(block_class) && !start_keeps_length(block_class)) continue;
        gboolean touched = FALSE, attached = TRUE;
        for (int32_t e = 0; e < 2; e++) {
            span.ends[e] = tinker_scene_end(scene, span.connector, e);
            attached &= span.ends[e].block != TINKER_NO_BLOCK;
            touched |= attached && moved[span.ends[e].block];
        }
        if (!attached || !touched) continue;
        span.distance = start_distance(frame, span.ends[0], span.ends[1]);
        span.length = tinker_frame_meaning(frame, span.connector, TINKER_MEANING_LENGTH, 0, NAN);
        g_array_append_val(spans, span);
    }
    return spans;
}

static GArray *note_centres(const TinkerFrame *frame, const GArray *places)
{
    GArray *centres = g_array_new(FALSE, FALSE, sizeof(StartPlace));
    for (guint i = 0; i < places->len; i++) {
        StartPlace centre = START_PLACE_AS_IT_IS(g_array_index(places, StartPlace, i).body);
        tinker_frame_centre(frame, centre.body, &centre.place[0], &centre.place[1], &centre.orientation);
        g_array_append_val(centres, centre);
    }
    return centres;
}

static gboolean write_place(TinkerHistory *history, TinkerScene *scene, const StartPlace *place, GError **error)
{
    const TinkerBlockId body = place->body;
    return (!place->lies || tinker_history_lay_on(history, body, place->plate, place->along, error)) &&
           (isnan(place->place[0]) ||
            start_set_meaning(history, scene, body, TINKER_MEANING_POSITION, place->place, error)) &&
           (isnan(place->orientation) ||
            start_set_meaning(history, scene, body, TINKER_MEANING_ORIENTATION, &place->orientation, error)) &&
           (isnan(place->velocity[0]) ||
            start_set_meaning(history, scene, body, TINKER_MEANING_VELOCITY, place->velocity, error)) &&
           (isnan(place->rate) ||
            start_set_meaning(history, scene, body, TINKER_MEANING_ANGULAR_VELOCITY, &place->rate, error));
}

static gboolean refuse_span(TinkerScene *scene, const Span *span, double distance, GError **error)
{
    const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    g_autofree char *kept = start_quantity_text(scene, span->length, length);
    g_autofree char *asked = start_quantity_text(scene, distance, length);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                _("%s: its length is %s, but its ends would be %s apart (ask for a place that it allows, or detach it "
                  "first)"),
                tinker_scene_block_name(scene, span->connector), kept, asked);
    return FALSE;
}

/* What rounding of the ends' places may make of their distance. */
static double noise_of(const TinkerFrame *frame, const Span *span)
{
    double reach = 0;
    for (int e = 0; e < 2; e++) {
        double place[2];
        tinker_frame_end(frame, span->ends[e], place);
        reach += fabs(place[0]) + fabs(place[1]);
    }
    return 16 * DBL_EPSILON * reach;
}

/* Finds out whether the length must be given explicitly. FALSE where a connector would have to change its length. */
static gboolean check_length(const TinkerFrame *after, Span *span, GError **error)
{
    TinkerScene *scene = tinker_frame_scene(after);
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, span->connector);
    double distance = start_distance(after, span->ends[0], span->ends[1]);
    span->follows = FALSE;
    if (fabs(distance - span->distance) <= noise_of(after, span)) return TRUE;
    if (start_keeps_length(block_class)) {
        double excess = distance - span->length, excess_before = span->distance - span->length;
        if (start_is_rigid(block_class)) {
            excess = fabs(excess);
            excess_before = fabs(excess_before);
        }
        if (excess > START_FITS * span->length && excess > excess_before)
            return refuse_span(scene, span, distance, error);
        if (start_is_rigid(block_class)) return TRUE;
    }
    span->follows = !tinker_scene_property_given(scene, span->connector, block_class->meanings[TINKER_MEANING_LENGTH]);
    return TRUE;
}

static gboolean check_lengths(const TinkerFrame *after, GArray *spans, GError **error)
{
    for (guint i = 0; i < spans->len; i++)
        if (!check_length(after, &g_array_index(spans, Span, i), error)) return FALSE;
    return TRUE;
}

/* How far a body's side was in front of the top that it overlaps now; plates do not move. */
static double gap_before(const TinkerFrame *after, const GArray *centres, const TinkerOverlap *overlap)
{
    for (guint i = 0; i < centres->len; i++) {
        const StartPlace *before = &g_array_index(centres, StartPlace, i);
        double x, y, orientation;
        if (before->body != overlap->body) continue;
        tinker_frame_centre(after, overlap->body, &x, &y, &orientation);
        return -overlap->depth - overlap->normal[0] * (x - before->place[0]) -
               overlap->normal[1] * (y - before->place[1]);
    }
    return -overlap->depth;
}

/* No body goes from the front of a plate into it. One that hangs behind may: it passes plates from there. */
static gboolean check_plates(const TinkerFrame *after, const GArray *centres, GError **error)
{
    TinkerScene *scene = tinker_frame_scene(after);
    g_autoptr(GArray) overlaps = tinker_overlaps_new(after);
    for (guint i = 0; i < overlaps->len; i++) {
        const TinkerOverlap *overlap = &g_array_index(overlaps, TinkerOverlap, i);
        if (gap_before(after, centres, overlap) < -TINKER_TOUCHING) continue;
        const char *plate = tinker_scene_block_name(scene, overlap->plate);
        g_autofree char *depth = start_quantity_text(scene, overlap->depth, (TinkerDimension)TINKER_DIMENSION_LENGTH);
        g_set_error(
            error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
            _("%s would start %s below the top of %s (ask for a place in front of it, or move %s out of the way)"),
            tinker_scene_block_name(scene, overlap->body), depth, plate, plate);
        return FALSE;
    }
    return TRUE;
}

static gboolean write_all(TinkerHistory *history, TinkerScene *scene, const GArray *places, const Before *before,
                          GError **error)
{
    for (guint i = 0; i < places->len; i++)
        if (!write_place(history, scene, &g_array_index(places, StartPlace, i), error)) return FALSE;
    TinkerFrame *after = tinker_frame_new(scene, error);
    gboolean fits =
        after != NULL && check_plates(after, before->centres, error) && check_lengths(after, before->spans, error);
    tinker_frame_free(after);
    for (guint i = 0; fits && i < before->spans->len; i++) {
        const Span *span = &g_array_index(before->spans, Span, i);
        if (span->follows &&
            !start_set_meaning(history, scene, span->connector, TINKER_MEANING_LENGTH, &span->length, error))
            return FALSE;
    }
    return fits;
}

gboolean start_places_write(TinkerHistory *history, TinkerScene *scene, const char *title, const GArray *places,
                            GError **error)
{
    TinkerFrame *frame = tinker_frame_new(scene, error);
    if (frame == NULL) return FALSE;
    g_autoptr(GArray) spans = note_spans(frame, places), centres = note_centres(frame, places);
    const Before before = {spans, centres};
    tinker_frame_free(frame);
    tinker_history_begin(history, title, NULL);
    gboolean written = write_all(history, scene, places, &before, error);
    if (written)
        tinker_history_end(history);
    else
        tinker_history_abort(history);
    return written;
}
