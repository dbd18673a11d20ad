/* The greatest of the vectors, which gives them their scale, is that of all pictures that are left when the first one
 * is drawn. */
#include "common/film/film-arrows.h"

#include <math.h>

#include "common/overlay/force-arrows.h"
#include "render/draw/text.h"

/* So much stronger than in the first picture, forces are what the film's scale is for. */
#define MUCH_STRONGER 5.0

struct _TinkerFilmArrows {
    TinkerScene *scene;
    TinkerFilmOverlay overlay;
    TinkerActingForces *acting; /* NULL: not asked for */
    GArray *now;                /* of TinkerActingForce: scratch */
    GArray *first;              /* likewise: of the picture whose scale forces have; the first in which any is not 0 */
    GPtrArray *forces;          /* of GArray of TinkerActingForce, a picture each */
    GPtrArray *vectors;         /* of GArray of TinkerMotionVector, likewise */
    TinkerMotionTrail *trail;   /* NULL: no paths */
    char *marks;                /* for the key; NULL: no paths */

    /* While pictures are drawn. */
    TinkerForceArrows drawn;
    GPtrArray *texts; /* of TinkerWrittenText */
    double greatest[TINKER_VECTOR_KINDS];
    double time; /* s: of the picture */
};

gboolean tinker_film_overlay_any(const TinkerFilmOverlay *overlay)
{
    return overlay->forces || overlay->marks > 0 || tinker_vector_choice_any(&overlay->vectors);
}

TinkerFilmArrows *tinker_film_arrows_new(TinkerModel *model, TinkerScene *scene, const TinkerFilmOverlay *overlay)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    TinkerFilmArrows *arrows = g_new0(TinkerFilmArrows, 1);
    const gboolean *kinds = overlay->vectors.kinds;
    arrows->scene = scene;
    arrows->overlay = *overlay;
    if (overlay->forces || kinds[TINKER_VECTOR_ACCELERATION] || kinds[TINKER_VECTOR_NET_FORCE])
        arrows->acting = tinker_acting_forces_new(model);
    arrows->now = tinker_acting_forces_array();
    arrows->first = tinker_acting_forces_array();
    arrows->forces = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    arrows->vectors = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    arrows->texts = tinker_written_texts_new();
    if (!(overlay->marks > 0)) return arrows;
    arrows->trail = tinker_motion_trail_new(scene, overlay->marks);
    arrows->marks = tinker_quantity_brief(overlay->marks, seconds, tinker_scene_head(scene)->units);
    return arrows;
}

void tinker_film_arrows_free(TinkerFilmArrows *arrows)
{
    if (arrows == NULL) return;
    g_clear_pointer(&arrows->acting, tinker_acting_forces_free);
    g_clear_pointer(&arrows->trail, tinker_motion_trail_free);
    g_array_unref(arrows->now);
    g_array_unref(arrows->first);
    g_ptr_array_unref(arrows->forces);
    g_ptr_array_unref(arrows->vectors);
    g_ptr_array_unref(arrows->texts);
    g_free(arrows->marks);
    g_free(arrows);
}

void tinker_film_arrows_note(TinkerFilmArrows *arrows, const TinkerFrame *frame)
{
    if (arrows->trail != NULL) tinker_motion_trail_note_frame(arrows->trail, frame);
}

static GArray *take_vectors(TinkerFilmArrows *arrows, TinkerSimulation *simulation, TinkerFrame *frame)
{
    GArray *vectors = tinker_motion_vectors_array();
    const TinkerVectorChoice *choice = &arrows->overlay.vectors;
    if (choice->kinds[TINKER_VECTOR_VELOCITY]) tinker_motion_vectors_add_velocities(vectors, frame, simulation);
    tinker_motion_vectors_add_forces(vectors, frame, arrows->now, choice);
    return vectors;
}

gboolean tinker_film_arrows_add(TinkerFilmArrows *arrows, TinkerSimulation *simulation, TinkerFrame *frame,
                                GError **error)
{
    if (arrows->acting != NULL && !tinker_acting_forces_at(arrows->acting, simulation, arrows->now, error))
        return FALSE;
    if (tinker_force_arrows_greatest(arrows->now) > MUCH_STRONGER * tinker_force_arrows_greatest(arrows->first)) {
        g_array_set_size(arrows->first, 0);
        g_array_append_vals(arrows->first, arrows->now->data, arrows->now->len);
    }
    GArray *forces = tinker_acting_forces_array();
    if (arrows->overlay.forces) g_array_append_vals(forces, arrows->now->data, arrows->now->len);
    tinker_force_arrows_keep_moving(arrows->scene, forces);
    g_ptr_array_add(arrows->forces, forces);
    g_ptr_array_add(arrows->vectors, take_vectors(arrows, simulation, frame));
    return TRUE;
}

void tinker_film_arrows_cut(TinkerFilmArrows *arrows, gsize count)
{
    if (count < arrows->forces->len) g_ptr_array_set_size(arrows->forces, (int)count);
    if (count < arrows->vectors->len) g_ptr_array_set_size(arrows->vectors, (int)count);
    if (count > 0) return;
    g_array_set_size(arrows->first, 0);
    if (arrows->trail != NULL) tinker_motion_trail_clear(arrows->trail);
}

static void draw_over(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data)
{
    TinkerFilmArrows *arrows = data;
    if (arrows->trail != NULL) tinker_motion_trail_draw(arrows->trail, cairo, view, theme, arrows->time, NULL, NULL);
    tinker_force_arrows_over(cairo, view, theme, &arrows->drawn);
}

static void begin_drawing(TinkerFilmArrows *arrows)
{
    for (int k = 0; k < TINKER_VECTOR_KINDS; k++)
        arrows->greatest[k] = 0;
    for (guint i = 0; i < arrows->vectors->len; i++)
        tinker_motion_vectors_measure(g_ptr_array_index(arrows->vectors, i), arrows->greatest);
    arrows->drawn = (TinkerForceArrows){.scene = arrows->scene,
                                        .at_start = arrows->first,
                                        .greatest = arrows->greatest,
                                        .texts = arrows->texts,
                                        .marks = arrows->marks};
}

void tinker_film_arrows_dress(TinkerFilmArrows *arrows, gsize picture, TinkerFrame *frame, TinkerPaintOptions *paint)
{
    if (picture == 0) begin_drawing(arrows);
    arrows->time = tinker_frame_time(frame);
    arrows->drawn.frame = frame;
    arrows->drawn.acting = g_ptr_array_index(arrows->forces, picture);
    arrows->drawn.vectors = g_ptr_array_index(arrows->vectors, picture);
    g_ptr_array_set_size(arrows->texts, 0);
    paint->texts = arrows->texts;
    paint->over = draw_over;
    paint->over_data = arrows;
}
