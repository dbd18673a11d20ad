/* The forces at a time are those at the start of a scene that goes on from there, so nothing of the run has to be kept for them. */
#include "canvas-forces.h"

#include <math.h>

#include "physics/acting-forces.h"
#include "render/arrows.h"

#define PATIENCE 5 /* parts of the time that working them out took: so long are they shown */

struct _CanvasForces {
    GArray *acting;   /* of TinkerActingForce */
    double time;      /* s: that they belong to */
    guint64 revision; /* of the document's history */
    gboolean known;
    gint64 stale_at; /* us: not worked out anew before, while it plays */
    double scale;    /* m per N */
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

/* Whether the forces on this block are to be seen. */
static gboolean shows(TinkerDocument *document, const TinkerActingForce *force)
{
    TinkerScene *scene = tinker_document_scene(document);
    int selected;
    const TinkerBlockId *selection = tinker_document_selection(document, &selected);
    if (!tinker_scene_has_block(scene, force->on) || !tinker_scene_has_block(scene, force->by)) return FALSE;
    gboolean any_body = FALSE;
    for (int i = 0; i < selected; i++) {
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, selection[i]);
        if (selection[i] == force->on || selection[i] == force->by) return TRUE;
        any_body = any_body || (block_class != NULL && block_class->meanings[TINKER_MEANING_POSITION] >= 0);
    }
    const TinkerBlockClass *on = tinker_scene_block_class(scene, force->on);
    return !any_body && selected == 0 && on->physics->body->degrees_of_freedom > 0;
}

static char *label_of(TinkerScene *scene, const TinkerActingForce *force)
{
    static const TinkerDimension dimension = TINKER_DIMENSION_FORCE;
    g_autofree char *value =
        tinker_quantity_format(hypot(force->fx, force->fy), dimension, NULL, tinker_scene_head(scene)->units, 2);
    static const char *const of_contacts[] = {
        [TINKER_ACTING_NORMAL] = "normal force", [TINKER_ACTING_FRICTION] = "friction"};
    gboolean contact = force->kind == TINKER_ACTING_NORMAL || force->kind == TINKER_ACTING_FRICTION;
    const char *by = tinker_scene_block_name(scene, force->by);
    return contact ? g_strdup_printf("%s (%s) %s", by, of_contacts[force->kind], value)
                   : g_strdup_printf("%s %s", by, value);
}

void canvas_forces_draw(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                        const TinkerView *view, const TinkerTheme *theme)
{
    update(forces, document, player);
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(GPtrArray) labels = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GArray) arrows = g_array_new(FALSE, FALSE, sizeof(TinkerForceArrow));
    for (guint i = 0; i < forces->acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(forces->acting, TinkerActingForce, i);
        if (!shows(document, force)) continue;
        g_ptr_array_add(labels, label_of(scene, force));
        TinkerForceArrow arrow = {
            force->x, force->y, force->fx, force->fy, g_ptr_array_index(labels, labels->len - 1), (int)force->by};
        g_array_append_val(arrows, arrow);
    }
    const TinkerForceArrow *list = (const TinkerForceArrow *)(gpointer)arrows->data;
    forces->scale = tinker_arrows_scale(list, arrows->len, view, forces->scale);
    TinkerArrowOptions options = {.theme = theme, .scale = forces->scale};
    tinker_arrows_draw(cairo, view, list, arrows->len, &options);
}
