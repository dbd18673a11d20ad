/* The forces at a time are those at the start of a scene that goes on from there, so nothing of the run has to be kept
 * for them. How long an arrow is follows from the forces at the start of the run, all of them, and stays so: lengths
 * can be compared, over time and from body to body. */
#include "gui/canvas/canvas-forces.h"

#include <math.h>

#include "force-arrows.h"
#include "physics/run/acting-forces.h"

#define PATIENCE 5 /* parts of the time that working them out took: so long are they shown */

struct _CanvasForces {
    GArray *acting;   /* of TinkerActingForce */
    double time;      /* s: that they belong to */
    guint64 revision; /* of the document's history */
    gboolean known;
    gint64 stale_at;               /* us: not worked out anew before, while it plays */
    double pixels;                 /* canvas units per N, for a factor of 1; 0: not known yet */
    guint64 scaled_revision;       /* of the document's history, that it belongs to */
    gboolean start_is_known_empty; /* no force acts at the start of that revision */
};

CanvasForces *canvas_forces_new(void)
{
    CanvasForces *forces = g_new0(CanvasForces, 1);
    forces->acting = tinker_acting_forces_array();
    return forces;
}

void canvas_forces_free(CanvasForces *forces)
{
    g_array_unref(forces->acting);
    g_free(forces);
}

static void update(CanvasForces *forces, TinkerDocument *document, TinkerPlayer *player)
{
    guint64 revision = tinker_history_revision(tinker_document_history(document));
    double time = tinker_player_time(player);
    gboolean same_scene = forces->known && forces->revision == revision;
    if (same_scene && forces->time == time) return;
    gint64 began = g_get_monotonic_time();
    gboolean playing = tinker_player_state(player) == TINKER_PLAYER_PLAYING;
    if (same_scene && playing && began < forces->stale_at) return;
    g_autoptr(TinkerScene) scene = tinker_player_scene_now(player);
    if (scene == NULL || !tinker_acting_forces_at_start(scene, forces->acting, NULL))
        g_array_set_size(forces->acting, 0);
    forces->known = TRUE;
    forces->revision = revision;
    forces->time = time;
    gint64 now = g_get_monotonic_time();
    forces->stale_at = now + PATIENCE * (now - began);
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
static void choose_scale(CanvasForces *forces, TinkerDocument *document, const TinkerView *view)
{
    const gboolean edited = forces->scaled_revision != forces->revision;
    if (forces->pixels > 0 && !(edited && forces->time == 0)) return;
    if (edited) forces->start_is_known_empty = FALSE;
    g_autoptr(GArray) start = tinker_acting_forces_array();
    const GArray *known = forces->acting;
    if (forces->time != 0 && !forces->start_is_known_empty) {
        tinker_acting_forces_at_start(tinker_document_scene(document), start, NULL);
        forces->start_is_known_empty = !tinker_force_arrows_any(start);
        if (!forces->start_is_known_empty) known = start;
    }
    forces->scaled_revision = forces->revision;
    if (!tinker_force_arrows_any(known)) return;
    forces->pixels = tinker_force_arrows_scale(known, view, forces->pixels);
}

void canvas_forces_draw(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                        const TinkerView *view, const CanvasForcesLook *look)
{
    update(forces, document, player);
    choose_scale(forces, document, view);
    g_autoptr(GArray) shown = tinker_acting_forces_array();
    for (guint i = 0; i < forces->acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(forces->acting, TinkerActingForce, i);
        if (shows(document, force, look->others)) g_array_append_val(shown, *force);
    }
    const TinkerForceArrows arrows = {
        .scene = tinker_document_scene(document), .acting = shown, .pixels = look->factor * forces->pixels};
    tinker_force_arrows_draw(&arrows, cairo, view, look->theme);
}
