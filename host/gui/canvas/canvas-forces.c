/* How long the arrow of a force is follows from the forces at the start of the run, all of them; while later ones would
 * be longer than half of the view, from those. Of a velocity or an acceleration it follows from the greatest of the
 * run. So lengths can be compared, over time and from body to body. */
#include "gui/canvas/canvas-forces.h"

#include <math.h>

#include "common/overlay/force-arrows.h"
#include "gui/canvas/canvas-vectors.h"
#include "gui/document/forces-now.h"
#include "physics/run/acting-forces.h"

struct _CanvasForces {
    double pixels;                 /* canvas units per N, for a factor of 1; 0: not known yet */
    double peak_pixels;            /* likewise, while forces have outgrown that; 0: they have not */
    guint64 scaled_revision;       /* of the document's history, that it belongs to */
    gboolean start_is_known_empty; /* no force acts at the start of that revision */
    CanvasVectors *vectors;
    double vector_pixels[TINKER_VECTOR_KINDS]; /* canvas units per SI unit, likewise */
    GArray *spots;                             /* of TinkerSpot: where what was drawn last */
};

CanvasForces *canvas_forces_new(void)
{
    CanvasForces *forces = g_new0(CanvasForces, 1);
    forces->vectors = canvas_vectors_new();
    forces->spots = tinker_spots_new();
    return forces;
}

void canvas_forces_free(CanvasForces *forces)
{
    canvas_vectors_free(forces->vectors);
    g_array_unref(forces->spots);
    g_free(forces);
}

void canvas_forces_forget(CanvasForces *forces)
{
    forces->pixels = forces->peak_pixels = 0;
    for (int k = 0; k < TINKER_VECTOR_KINDS; k++)
        forces->vector_pixels[k] = 0;
}

/* Whether the force is to be seen: of selected bodies those on them, unless `others` those that they exert, too; of
 * selected connectors and fields theirs; with nothing selected those on all that can move. */
static gboolean shows(TinkerDocument *document, const TinkerActingForce *force, gboolean others)
{
    TinkerScene *scene = tinker_document_scene(document);
    int selected;
    const TinkerBlockId *selection = tinker_document_selection(document, &selected);
    if (!tinker_scene_has_block(scene, force->on) || !tinker_scene_has_block(scene, force->by)) return FALSE;
    for (int i = 0; i < selected; i++) {
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, selection[i]);
        gboolean is_body = block_class != NULL && block_class->meanings[TINKER_MEANING_POSITION] >= 0;
        if (selection[i] == force->on || (selection[i] == force->by && (others || !is_body))) return TRUE;
    }
    return selected == 0 && tinker_force_acts_on_moving(scene, force);
}

/* One scale for a run: from the forces at its start, or where there are none from the first that there are. */
static void choose_scale(CanvasForces *forces, const GArray *acting, TinkerDocument *document, double time,
                         const TinkerView *view)
{
    const guint64 revision = tinker_history_revision(tinker_document_history(document));
    const gboolean edited = forces->scaled_revision != revision;
    if (forces->pixels > 0 && !(edited && time == 0)) return;
    if (edited) forces->start_is_known_empty = FALSE;
    g_autoptr(GArray) start = tinker_acting_forces_array();
    const GArray *known = acting;
    if (time != 0 && !forces->start_is_known_empty) {
        tinker_acting_forces_at_start(tinker_document_scene(document), start, NULL);
        forces->start_is_known_empty = !tinker_force_arrows_any(start);
        if (!forces->start_is_known_empty) known = start;
    }
    forces->scaled_revision = revision;
    if (!tinker_force_arrows_any(known)) return;
    forces->pixels = tinker_force_arrows_scale(known, view, forces->pixels);
}

/* The scale for what acts now: that of the run, and while forces have outgrown it, as in a blow, one of their own. */
static double scale_now(CanvasForces *forces, const GArray *acting, const TinkerView *view)
{
    const gboolean outgrown = tinker_force_arrows_outgrow(acting, view, forces->pixels);
    forces->peak_pixels = outgrown ? tinker_force_arrows_scale(acting, view, forces->peak_pixels) : 0;
    return outgrown ? forces->peak_pixels : forces->pixels;
}

static gboolean is_shown(TinkerBlockId body, void *document)
{
    return canvas_vectors_shows(document, body);
}

/* How far apart in time the marks are that were drawn; NULL where there are none. (transfer full) */
static char *draw_trails(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                         const TinkerView *view, const CanvasForcesLook *look)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    const TinkerMotionTrail *trail = canvas_vectors_trail(forces->vectors);
    if (!look->trails || trail == NULL || tinker_player_time(player) == 0) return NULL;
    tinker_motion_trail_draw(trail, cairo, view, look->theme, tinker_player_time(player), is_shown, document);
    return tinker_quantity_brief(tinker_motion_trail_every(trail), seconds,
                                 tinker_scene_head(tinker_document_scene(document))->units);
}

/* The single forces to be seen. (transfer full) */
static GArray *shown_forces(TinkerDocument *document, const GArray *acting, const CanvasForcesLook *look)
{
    GArray *shown = tinker_acting_forces_array();
    for (guint i = 0; look->forces && i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        if (shows(document, force, look->others)) g_array_append_val(shown, *force);
    }
    return shown;
}

void canvas_forces_draw(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                        const TinkerView *view, const CanvasForcesLook *look)
{
    const gboolean any = tinker_vector_choice_any(&look->vectors);
    g_array_set_size(forces->spots, 0);
    if (!look->forces && !look->trails && !any) return;
    const gboolean asks_forces =
        look->forces || look->vectors.kinds[TINKER_VECTOR_ACCELERATION] || look->vectors.kinds[TINKER_VECTOR_NET_FORCE];
    g_autoptr(GArray) none = tinker_acting_forces_array();
    const GArray *acting = asks_forces ? tinker_forces_now(document, player) : none;
    if (asks_forces) choose_scale(forces, acting, document, tinker_player_time(player), view);
    if (look->trails || any) canvas_vectors_update(forces->vectors, document, player);
    g_autofree char *marks = draw_trails(forces, cairo, document, player, view, look);
    g_autoptr(GArray) shown = shown_forces(document, acting, look);
    const double pixels = scale_now(forces, acting, view);
    TinkerForceArrows arrows = {.scene = tinker_document_scene(document),
                                .frame = tinker_player_frame(player),
                                .acting = shown,
                                .pixels = look->factor * pixels,
                                .texts = look->texts,
                                .marks = marks,
                                .lit = look->lit,
                                .spots = forces->spots};
    if (any || marks != NULL)
        arrows.vectors = canvas_vectors_now(forces->vectors, document, player, &look->vectors, acting);
    for (int k = 0; any && k < TINKER_VECTOR_KINDS; k++) {
        const double greatest = canvas_vectors_greatest(forces->vectors, k);
        forces->vector_pixels[k] = tinker_motion_vectors_scale(greatest, view, forces->vector_pixels[k]);
        arrows.vector_pixels[k] = look->factor * forces->vector_pixels[k];
    }
    tinker_force_arrows_draw(&arrows, cairo, view, look->theme);
}

const GArray *canvas_forces_spots(const CanvasForces *forces)
{
    return forces->spots;
}
