/* The forces at a time are those of a scene that goes on from the sample before it, so nothing of the run has to be
 * kept for them. */
#include "gui/document/forces-now.h"

#include "physics/run/acting-forces.h"

#define PATIENCE 5    /* parts of the time that working them out took: so long are they shown */
#define LONGEST  0.03 /* s: of the way from the sample before; behind it those of the sample are shown */
#define DATA     "tinker-forces-now"

typedef struct {
    GArray *acting;   /* of TinkerActingForce */
    double time;      /* s: that they belong to */
    guint64 revision; /* of the document's history */
    gboolean known;
    gint64 stale_at; /* us: not worked out anew before, while it plays */
} ForcesNow;

static void forces_now_free(gpointer data)
{
    g_array_unref(((ForcesNow *)data)->acting);
    g_free(data);
}

/* The player's own, made at the first call. */
static ForcesNow *forces_of(TinkerPlayer *player)
{
    ForcesNow *forces = g_object_get_data(G_OBJECT(player), DATA);
    if (forces != NULL) return forces;
    forces = g_new0(ForcesNow, 1);
    forces->acting = tinker_acting_forces_array();
    g_object_set_data_full(G_OBJECT(player), DATA, forces, forces_now_free);
    return forces;
}

/* Those so long behind the start of a scene, or where that takes too long or fails, at its start. */
static gboolean list(TinkerScene *scene, double behind, GArray *acting)
{
    return (behind > 0 && tinker_acting_forces_after(scene, behind, LONGEST, acting, NULL)) ||
           tinker_acting_forces_at_start(scene, acting, NULL);
}

const GArray *tinker_forces_now(TinkerDocument *document, TinkerPlayer *player)
{
    ForcesNow *forces = forces_of(player);
    guint64 revision = tinker_history_revision(tinker_document_history(document));
    double time = tinker_player_time(player);
    gboolean same_scene = forces->known && forces->revision == revision;
    if (same_scene && forces->time == time) return forces->acting;
    gint64 began = g_get_monotonic_time();
    gboolean playing = tinker_player_state(player) == TINKER_PLAYER_PLAYING;
    if (same_scene && playing && began < forces->stale_at) return forces->acting;
    double behind = 0;
    g_autoptr(TinkerScene) scene = tinker_player_scene_now(player, &behind);
    if (scene == NULL || !list(scene, behind, forces->acting)) g_array_set_size(forces->acting, 0);
    forces->known = TRUE;
    forces->revision = revision;
    forces->time = time;
    gint64 now = g_get_monotonic_time();
    forces->stale_at = now + PATIENCE * (now - began);
    return forces->acting;
}
