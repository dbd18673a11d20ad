/* All that is needed of a run is taken from its record as that grows, and forgotten when that is no longer true. */
#include "gui/canvas/canvas-vectors.h"

#include <math.h>

#include "scene/store/quantities.h"

#define MOST_BODIES 100  /* whose accelerations are looked through for the greatest */
#define MOST_NOTES  4000 /* of a trail */

/* A component of a body's acceleration. */
typedef struct {
    TinkerQuantity quantity;
    TinkerSeriesCursor cursor;
    double greatest; /* m/s^2 */
} Component;

struct _CanvasVectors {
    gboolean known;
    guint generation; /* of the player, that all below belongs to, */
    guint64 revision; /* and of the document's history, before there is a record */
    double greatest[TINKER_VECTOR_KINDS];
    TinkerSeriesCursor cursor;
    TinkerMotionTrail *trail; /* NULL: nothing is recorded */
    double spacing;           /* s: of its notes */
    GArray *components;       /* of Component, x and y of each body in turn */
    GArray *now;              /* of TinkerMotionVector */
};

CanvasVectors *canvas_vectors_new(void)
{
    CanvasVectors *vectors = g_new0(CanvasVectors, 1);
    vectors->components = g_array_new(FALSE, FALSE, sizeof(Component));
    vectors->now = tinker_motion_vectors_array();
    return vectors;
}

void canvas_vectors_free(CanvasVectors *vectors)
{
    tinker_motion_trail_free(vectors->trail);
    g_array_unref(vectors->components);
    g_array_unref(vectors->now);
    g_free(vectors);
}

static gboolean is_body(TinkerScene *scene, TinkerBlockId block)
{
    return tinker_scene_has_block(scene, block) && tinker_block_moves(scene, block);
}

gboolean canvas_vectors_shows(TinkerDocument *document, TinkerBlockId body)
{
    TinkerScene *scene = tinker_document_scene(document);
    int selected, bodies = 0;
    const TinkerBlockId *selection = tinker_document_selection(document, &selected);
    if (!is_body(scene, body)) return FALSE;
    for (int i = 0; i < selected; i++) {
        if (selection[i] == body) return TRUE;
        bodies += is_body(scene, selection[i]);
    }
    return bodies == 0;
}

/* The record ------------------------------------------------------------------------------------------------------- */

static void begin_anew(CanvasVectors *vectors, TinkerDocument *document, TinkerPlayer *player)
{
    TinkerScene *scene = tinker_document_scene(document);
    const double duration = tinker_player_duration(player);
    vectors->known = TRUE;
    vectors->generation = tinker_player_generation(player);
    vectors->revision = tinker_history_revision(tinker_document_history(document));
    vectors->cursor = (TinkerSeriesCursor){0};
    for (int k = 0; k < TINKER_VECTOR_KINDS; k++)
        vectors->greatest[k] = 0;
    g_clear_pointer(&vectors->trail, tinker_motion_trail_free);
    vectors->trail = tinker_motion_trail_new(scene, tinker_motion_trail_spacing(duration));
    vectors->spacing = duration / MOST_NOTES;
    g_array_set_size(vectors->components, 0);
    int count;
    const TinkerBlockId *bodies = tinker_motion_trail_bodies(vectors->trail, &count);
    for (int i = 0; i < MIN(count, MOST_BODIES); i++) {
        const Component x = {{bodies[i], tinker_scene_find_quantity(scene, bodies[i], "ax")}, {0}, 0};
        const Component y = {{bodies[i], tinker_scene_find_quantity(scene, bodies[i], "ay")}, {0}, 0};
        if (x.quantity.quantity < 0 || y.quantity.quantity < 0) continue;
        g_array_append_val(vectors->components, x);
        g_array_append_val(vectors->components, y);
    }
}

/* The trail's bodies are the record's, in the order of the scene both. */
static void take_sample(double time, const TinkerBlockId *bodies, const TinkerBodySample *samples, int count,
                        void *data)
{
    CanvasVectors *vectors = data;
    double *speed = &vectors->greatest[TINKER_VECTOR_VELOCITY];
    for (int i = 0; i < count; i++)
        *speed = fmax(*speed, hypot(samples[i].vx, samples[i].vy));
    int expected;
    const TinkerBlockId *wanted = tinker_motion_trail_bodies(vectors->trail, &expected);
    const double reached = tinker_motion_trail_reached(vectors->trail);
    if (expected != count || (reached >= 0 && time < reached + vectors->spacing)) return;
    g_autofree double *poses = g_new(double, 3 * (gsize)count + 3);
    for (int i = 0; i < count; i++) {
        if (wanted[i] != bodies[i]) return;
        poses[3 * i] = samples[i].x;
        poses[3 * i + 1] = samples[i].y;
        poses[3 * i + 2] = samples[i].orientation;
    }
    tinker_motion_trail_note(vectors->trail, time, poses);
}

static void take_accelerations(CanvasVectors *vectors, TinkerPlayer *player)
{
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GArray) values = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < vectors->components->len; i++) {
        Component *component = &g_array_index(vectors->components, Component, i);
        g_array_set_size(times, 0);
        g_array_set_size(values, 0);
        (void)tinker_player_series(player, component->quantity, &component->cursor, times, values);
        for (guint k = 0; k < values->len; k++) {
            const double value = fabs(g_array_index(values, double, k));
            if (isfinite(value)) component->greatest = fmax(component->greatest, value);
        }
    }
    double *greatest = &vectors->greatest[TINKER_VECTOR_ACCELERATION];
    for (guint i = 0; i + 1 < vectors->components->len; i += 2)
        *greatest = fmax(*greatest, hypot(g_array_index(vectors->components, Component, i).greatest,
                                          g_array_index(vectors->components, Component, i + 1).greatest));
}

void canvas_vectors_update(CanvasVectors *vectors, TinkerDocument *document, TinkerPlayer *player)
{
    const gboolean edited = vectors->revision != tinker_history_revision(tinker_document_history(document)) &&
                            tinker_player_state(player) == TINKER_PLAYER_SETUP;
    if (!vectors->known || edited || vectors->generation != tinker_player_generation(player))
        begin_anew(vectors, document, player);
    tinker_player_visit(player, &vectors->cursor, take_sample, vectors);
    take_accelerations(vectors, player);
}

double canvas_vectors_greatest(const CanvasVectors *vectors, TinkerVectorKind kind)
{
    return vectors->greatest[kind];
}

const TinkerMotionTrail *canvas_vectors_trail(const CanvasVectors *vectors)
{
    return vectors->trail;
}

/* Now -------------------------------------------------------------------------------------------------------------- */

typedef struct {
    GArray *vectors;
    TinkerFrame *frame;
} Velocities;

static void add_velocities(G_GNUC_UNUSED double time, const TinkerBlockId *bodies, const TinkerBodySample *samples,
                           int count, void *data)
{
    const Velocities *to = data;
    for (int i = 0; i < count; i++)
        if (tinker_scene_has_block(tinker_frame_scene(to->frame), bodies[i]))
            tinker_motion_vectors_add_velocity(to->vectors, to->frame, bodies[i], samples[i].vx, samples[i].vy);
}

/* Before there is a record, what bodies set off with. */
static void add_start_velocities(const Velocities *to)
{
    TinkerScene *scene = tinker_frame_scene(to->frame);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId body = tinker_scene_block_at(scene, place);
        if (!tinker_block_moves(scene, body)) continue;
        const double vx = tinker_frame_meaning(to->frame, body, TINKER_MEANING_VELOCITY, 0, 0);
        const double vy = tinker_frame_meaning(to->frame, body, TINKER_MEANING_VELOCITY, 1, 0);
        tinker_motion_vectors_add_velocity(to->vectors, to->frame, body, vx, vy);
    }
}

const GArray *canvas_vectors_now(CanvasVectors *vectors, TinkerDocument *document, TinkerPlayer *player,
                                 const TinkerVectorChoice *choice, const GArray *acting)
{
    Velocities velocities = {vectors->now, tinker_player_frame(player)};
    g_array_set_size(vectors->now, 0);
    if (velocities.frame == NULL) return vectors->now;
    if (choice->kinds[TINKER_VECTOR_VELOCITY] && !tinker_player_visit_now(player, add_velocities, &velocities))
        add_start_velocities(&velocities);
    tinker_motion_vectors_add_forces(vectors->now, velocities.frame, acting, choice);
    tinker_motion_vectors_measure(vectors->now, vectors->greatest);
    for (guint i = vectors->now->len; i-- > 0;)
        if (!canvas_vectors_shows(document, g_array_index(vectors->now, TinkerMotionVector, i).of))
            g_array_remove_index(vectors->now, i);
    return vectors->now;
}
