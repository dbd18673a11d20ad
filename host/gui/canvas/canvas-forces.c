/* The forces at a time are those at the start of a scene that goes on from there, so nothing of the run has to be kept
 * for them. How long an arrow is follows from the forces at the start of the run, all of them, and stays so: lengths
 * can be compared, over time and from body to body. */
#include "gui/canvas/canvas-forces.h"

#include <glib/gi18n.h>
#include <math.h>

#include "physics/run/acting-forces.h"
#include "render/picture/arrows.h"

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
    const TinkerBlockClass *on = tinker_scene_block_class(scene, force->on);
    return selected == 0 && on->physics->body->degrees_of_freedom > 0;
}

static gboolean has_force(const GArray *acting)
{
    for (guint i = 0; i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        if (hypot(force->fx, force->fy) > 0) return TRUE;
    }
    return FALSE;
}

/* One scale for a run: from the forces at its start, or where there are none from the first that there are. */
static void choose_scale(CanvasForces *forces, TinkerDocument *document, const TinkerView *view)
{
    const gboolean edited = forces->scaled_revision != forces->revision;
    if (forces->pixels > 0 && !(edited && forces->time == 0)) return;
    if (edited) forces->start_is_known_empty = FALSE;
    g_autoptr(GArray) start = tinker_acting_forces_array(), arrows = g_array_new(FALSE, TRUE, sizeof(TinkerForceArrow));
    const GArray *known = forces->acting;
    if (forces->time != 0 && !forces->start_is_known_empty) {
        tinker_acting_forces_at_start(tinker_document_scene(document), start, NULL);
        forces->start_is_known_empty = !has_force(start);
        if (!forces->start_is_known_empty) known = start;
    }
    for (guint i = 0; i < known->len; i++) {
        const TinkerActingForce *force = &g_array_index(known, TinkerActingForce, i);
        g_array_append_val(arrows, ((TinkerForceArrow){.fx = force->fx, .fy = force->fy}));
    }
    forces->scaled_revision = forces->revision;
    if (!has_force(known)) return;
    forces->pixels = view->scale * tinker_arrows_scale((const TinkerForceArrow *)(gpointer)arrows->data, arrows->len,
                                                       view, forces->pixels / view->scale);
}

static const struct {
    TinkerActingKind acting;
    TinkerArrowKind arrow;
    const char *word;
} kinds[] = {
    {TINKER_ACTING_FIELD, TINKER_ARROW_FIELD, N_("Field")},
    {TINKER_ACTING_NORMAL, TINKER_ARROW_NORMAL, N_("Normal force")},
    {TINKER_ACTING_FRICTION, TINKER_ARROW_FRICTION, N_("Friction")},
    {TINKER_ACTING_LINE, TINKER_ARROW_CONNECTOR, N_("Connector")},
    {TINKER_ACTING_CONSTRAINT, TINKER_ARROW_CONSTRAINT, N_("Constraint")},
    {TINKER_ACTING_ELEMENT, TINKER_ARROW_APPLIED, N_("Applied force")},
};

/* By its place in the list, whose last is what all others are. */
static gsize kind_of(TinkerActingKind acting)
{
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(kinds) && kinds[i].acting != acting)
        i++;
    return i;
}

static char *label_of(TinkerScene *scene, const TinkerActingForce *force)
{
    static const TinkerDimension dimension = TINKER_DIMENSION_FORCE;
    g_autofree char *value =
        tinker_quantity_format(hypot(force->fx, force->fy), dimension, NULL, tinker_scene_head(scene)->units, 2);
    gboolean contact = force->kind == TINKER_ACTING_NORMAL || force->kind == TINKER_ACTING_FRICTION;
    const char *by = tinker_scene_block_name(scene, force->by);
    return contact ? g_strdup_printf("%s (%s) %s", by, _(kinds[kind_of(force->kind)].word), value)
                   : g_strdup_printf("%s %s", by, value);
}

/* The key -------------------------------------------------------------------------------------------------------------
 */

/* Of the kinds that there are now, and how long a round force is. */
static void draw_key(cairo_t *cairo, const TinkerView *view, const GArray *arrows, const TinkerArrowOptions *options,
                     TinkerUnitSystem system)
{
    static const TinkerDimension dimension = TINKER_DIMENSION_FORCE;
    TinkerArrowWord words[G_N_ELEMENTS(kinds)];
    TinkerUnit unit = {1, TINKER_DIMENSION_FORCE};
    gsize count = 0;
    for (gsize k = 0; k < G_N_ELEMENTS(kinds); k++) {
        gboolean is_there = FALSE;
        for (guint i = 0; i < arrows->len && !is_there; i++)
            is_there = g_array_index(arrows, TinkerForceArrow, i).kind == kinds[k].arrow;
        if (is_there) words[count++] = (TinkerArrowWord){kinds[k].arrow, _(kinds[k].word)};
    }
    tinker_unit_parse(tinker_unit_for(dimension, system), &unit, NULL);
    TinkerArrowKey key = {
        .force = tinker_arrows_key_force(view, options->scale, unit.factor), .words = words, .word_count = count};
    g_autofree char *label = tinker_quantity_brief(key.force, dimension, system);
    key.label = label;
    tinker_arrows_draw_key(cairo, view, options, &key, NULL);
}

void canvas_forces_draw(CanvasForces *forces, cairo_t *cairo, TinkerDocument *document, TinkerPlayer *player,
                        const TinkerView *view, const CanvasForcesLook *look)
{
    update(forces, document, player);
    choose_scale(forces, document, view);
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(GPtrArray) labels = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GArray) arrows = g_array_new(FALSE, FALSE, sizeof(TinkerForceArrow));
    for (guint i = 0; i < forces->acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(forces->acting, TinkerActingForce, i);
        if (!shows(document, force, look->others)) continue;
        char *label = label_of(scene, force);
        g_ptr_array_add(labels, label);
        TinkerForceArrow arrow = {force->x, force->y, force->fx, force->fy, label, kinds[kind_of(force->kind)].arrow};
        g_array_append_val(arrows, arrow);
    }
    if (!(forces->pixels > 0)) return;
    const TinkerForceArrow *list = (const TinkerForceArrow *)(gpointer)arrows->data;
    TinkerArrowOptions options = {.theme = look->theme, .scale = look->factor * forces->pixels / view->scale};
    tinker_arrows_draw(cairo, view, list, arrows->len, &options);
    draw_key(cairo, view, arrows, &options, tinker_scene_head(scene)->units);
}
