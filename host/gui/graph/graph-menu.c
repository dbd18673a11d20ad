/* A phase plot is offered for a quantity and its rate. That one is the rate of another is told by their dimensions:
 * among what is recorded, the first of one dimension goes with the first of that over time, the second with the second.
 */
#include "gui/graph/graph-menu.h"

#include <glib/gi18n.h>

#include "gui/text/translate.h"
#include "units/quantity/units.h"

#define FEW 6 /* quantities that are all seen at once */

gboolean tinker_block_class_has_graphs(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->graph != NULL && block_class->quantity_count > 0;
}

static void append(GMenu *menu, const char *label, const char *quantity, const char *against)
{
    g_autofree char *target = against != NULL ? g_strconcat(quantity, "/", against, NULL) : g_strdup(quantity);
    g_autoptr(GMenuItem) item = g_menu_item_new(label, NULL);
    g_menu_item_set_action_and_target_value(item, "win.add-graph", g_variant_new_string(target));
    g_menu_append_item(menu, item);
}

static gboolean is_recorded(const TinkerQuantityType *quantity)
{
    return (quantity->flags & TINKER_RECORDED) != 0;
}

/* How many recorded quantities before this one have its dimension. */
static int rank_of(const TinkerBlockClass *block_class, int32_t quantity)
{
    int rank = 0;
    for (int32_t i = 0; i < quantity; i++)
        rank +=
            is_recorded(&block_class->quantities[i]) &&
            tinker_dimension_equal(block_class->quantities[i].dimension, block_class->quantities[quantity].dimension);
    return rank;
}

static gboolean is_rate_of(const TinkerBlockClass *block_class, int32_t rate, int32_t quantity)
{
    const TinkerQuantityType *a = &block_class->quantities[rate], *b = &block_class->quantities[quantity];
    if (!is_recorded(a) || !is_recorded(b)) return FALSE;
    TinkerDimension expected = b->dimension;
    expected.time--;
    return tinker_dimension_equal(a->dimension, expected) &&
           rank_of(block_class, rate) == rank_of(block_class, quantity);
}

static void append_phase(GMenu *menu, const TinkerBlockClass *block_class, int32_t y, int32_t x)
{
    const TinkerQuantityType *of_y = &block_class->quantities[y], *of_x = &block_class->quantities[x];
    g_autofree char *label =
        g_strdup_printf(_("%s over %s"), tinker_translate(of_y->title), tinker_translate(of_x->title));
    append(menu, label, of_y->id, of_x->id);
}

static GMenu *phase_plots(const TinkerBlockClass *block_class)
{
    static const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    GMenu *menu = g_menu_new();
    for (int32_t x = 0; x < block_class->quantity_count; x++)
        for (int32_t y = 0; y < block_class->quantity_count; y++)
            if (is_rate_of(block_class, y, x)) append_phase(menu, block_class, y, x);
    /* The path in the plane. */
    for (int32_t x = 0, y = 1; y < block_class->quantity_count; x++, y++) {
        const TinkerQuantityType *of_x = &block_class->quantities[x], *of_y = &block_class->quantities[y];
        if (is_recorded(of_x) && is_recorded(of_y) && tinker_dimension_equal(of_x->dimension, length) &&
            tinker_dimension_equal(of_y->dimension, length))
            append_phase(menu, block_class, y, x);
    }
    return menu;
}

static void append_submenu(GMenu *menu, const char *label, GMenu *submenu)
{
    g_autoptr(GMenu) section = g_menu_new();
    if (g_menu_model_get_n_items(G_MENU_MODEL(submenu)) == 0) return;
    g_menu_append_submenu(section, label, G_MENU_MODEL(submenu));
    g_menu_append_section(menu, NULL, G_MENU_MODEL(section));
}

GMenuModel *tinker_graph_menu_new(const TinkerBlockClass *block_class)
{
    GMenu *menu = g_menu_new();
    if (!tinker_block_class_has_graphs(block_class)) return G_MENU_MODEL(menu);
    g_autoptr(GMenu) common = g_menu_new(), others = g_menu_new(), phases = phase_plots(block_class);
    gboolean usual = FALSE;
    for (int32_t i = 0; i < block_class->quantity_count; i++)
        usual |= is_recorded(&block_class->quantities[i]);
    const gboolean all_alike = !usual || block_class->quantity_count <= FEW;
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        const TinkerQuantityType *quantity = &block_class->quantities[i];
        append(all_alike || is_recorded(quantity) ? common : others, tinker_translate(quantity->title), quantity->id,
               NULL);
    }
    g_menu_append_section(menu, NULL, G_MENU_MODEL(common));
    append_submenu(menu, _("More Quantities"), others);
    append_submenu(menu, _("Phase Plot"), phases);
    return G_MENU_MODEL(menu);
}

/* Of which all curves are quantities; NULL where there is no such class. */
static const TinkerBlockClass *common_class(const TinkerScene *scene, const TinkerSceneGraph *graph)
{
    const TinkerBlockClass *common = NULL;
    for (guint i = 0; i < graph->curves->len; i++) {
        const TinkerSceneCurve *curve = g_ptr_array_index(graph->curves, i);
        const TinkerBlockId block =
            curve->block != NULL ? tinker_scene_find_block(scene, curve->block) : TINKER_NO_BLOCK;
        const TinkerBlockClass *its = block != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, block) : NULL;
        if (its == NULL || (common != NULL && its != common)) return NULL;
        common = its;
    }
    return common;
}

static void append_over(GMenu *menu, const TinkerSceneGraph *graph, const char *label, const char *against)
{
    if (g_str_equal(graph->against, against)) return;
    g_autoptr(GMenuItem) item = g_menu_item_new(label, NULL);
    g_menu_item_set_action_and_target_value(item, "graph.against", g_variant_new_string(against));
    g_menu_append_item(menu, item);
}

GMenuModel *tinker_graph_over_menu_new(const TinkerScene *scene, const TinkerSceneGraph *graph)
{
    GMenu *menu = g_menu_new();
    const TinkerBlockClass *common = common_class(scene, graph);
    append_over(menu, graph, _("Time"), "time");
    append_over(menu, graph, _("Frequency (Spectrum)"), "frequency");
    for (int32_t i = 0; common != NULL && i < common->quantity_count; i++)
        if (is_recorded(&common->quantities[i]))
            append_over(menu, graph, tinker_translate(common->quantities[i].title), common->quantities[i].id);
    return G_MENU_MODEL(menu);
}
