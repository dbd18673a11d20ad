/* Forces as arrows, each with what it comes from and how large it is, and the key: the same in the window, in pictures
 * and in films. */
#include "force-arrows.h"

#include <glib/gi18n.h>
#include <math.h>

gboolean tinker_force_arrows_any(const GArray *acting)
{
    for (guint i = 0; i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        if (hypot(force->fx, force->fy) > 0) return TRUE;
    }
    return FALSE;
}

double tinker_force_arrows_scale(const GArray *acting, const TinkerView *view, double previous)
{
    g_autoptr(GArray) arrows = g_array_new(FALSE, TRUE, sizeof(TinkerForceArrow));
    for (guint i = 0; i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        g_array_append_val(arrows, ((TinkerForceArrow){.fx = force->fx, .fy = force->fy}));
    }
    return view->scale * tinker_arrows_scale((const TinkerForceArrow *)(gpointer)arrows->data, arrows->len, view,
                                             previous / view->scale);
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

const char *tinker_force_arrow_word(TinkerArrowKind kind)
{
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(kinds) && kinds[i].arrow != kind)
        i++;
    return _(kinds[i].word);
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
        for (guint i = 0; i < arrows->len && !is_there; i++) {
            const TinkerForceArrow *arrow = &g_array_index(arrows, TinkerForceArrow, i);
            is_there = arrow->kind == kinds[k].arrow && hypot(arrow->fx, arrow->fy) > 0;
        }
        if (is_there) words[count++] = (TinkerArrowWord){kinds[k].arrow, _(kinds[k].word)};
    }
    tinker_unit_parse(tinker_unit_for(dimension, system), &unit, NULL);
    TinkerArrowKey key = {
        .force = tinker_arrows_key_force(view, options->scale, unit.factor), .words = words, .word_count = count};
    g_autofree char *label = tinker_quantity_brief(key.force, dimension, system);
    key.label = label;
    tinker_arrows_draw_key(cairo, view, options, &key, NULL);
}

/* By a block, or on one. */
static gboolean is_of(const TinkerActingForce *force, TinkerBlockId block)
{
    return force->by == block || force->on == block;
}

static gboolean any_is_lit(const TinkerForceArrows *forces)
{
    for (guint i = 0; forces->lit != TINKER_NO_BLOCK && i < forces->acting->len; i++)
        if (is_of(&g_array_index(forces->acting, TinkerActingForce, i), forces->lit)) return TRUE;
    return FALSE;
}

void tinker_force_arrows_draw(const TinkerForceArrows *forces, cairo_t *cairo, const TinkerView *view,
                              const TinkerTheme *theme)
{
    if (!(forces->pixels > 0)) return;
    const gboolean some_lit = any_is_lit(forces);
    g_autoptr(GPtrArray) labels = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GArray) arrows = g_array_new(FALSE, FALSE, sizeof(TinkerForceArrow));
    for (guint i = 0; i < forces->acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(forces->acting, TinkerActingForce, i);
        char *label = label_of(forces->scene, force);
        g_ptr_array_add(labels, label);
        TinkerForceArrow arrow = {force->x, force->y, force->fx, force->fy, label, kinds[kind_of(force->kind)].arrow};
        if (some_lit && !is_of(force, forces->lit)) arrow.look = TINKER_ARROW_FADED;
        g_array_append_val(arrows, arrow);
    }
    TinkerArrowOptions options = {.theme = theme, .scale = forces->pixels / view->scale};
    tinker_arrows_draw(cairo, view, (const TinkerForceArrow *)(gpointer)arrows->data, arrows->len, &options);
    draw_key(cairo, view, arrows, &options, tinker_scene_head(forces->scene)->units);
}

gboolean tinker_force_acts_on_moving(TinkerScene *scene, const TinkerActingForce *force)
{
    const TinkerBlockClass *on = tinker_scene_block_class(scene, force->on);
    return on != NULL && on->physics->body->degrees_of_freedom > 0;
}

void tinker_force_arrows_keep_moving(TinkerScene *scene, GArray *acting)
{
    for (guint i = acting->len; i-- > 0;)
        if (!tinker_force_acts_on_moving(scene, &g_array_index(acting, TinkerActingForce, i)))
            g_array_remove_index(acting, i);
}

/* Over a picture ------------------------------------------------------------------------------------------------------
 */

void tinker_force_arrows_over(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data)
{
    TinkerForceArrows *forces = data;
    if (!(forces->pixels > 0) && tinker_force_arrows_any(forces->acting))
        forces->pixels = tinker_force_arrows_scale(
            forces->at_start != NULL && tinker_force_arrows_any(forces->at_start) ? forces->at_start : forces->acting,
            view, 0);
    tinker_force_arrows_draw(forces, cairo, view, theme);
}
