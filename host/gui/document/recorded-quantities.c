/* Quantities are cheap to record as long as there are few of them; so most runs have all, and a graph that is added
 * afterwards has its curve at once. The energies of the scene are not cheap where those given and taken have to be
 * added up for every sample: under a hand that turns a number that would take most of the time. */
#include "gui/document/recorded-quantities.h"

#include "measure/formula.h"
#include "physics/record/columns.h"
#include "scene/store/quantities.h"

#define MOST 4000 /* quantities that are recorded although nobody asked for them */

static void add_quantities(GArray *columns, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class == NULL || block_class->graph == NULL) return;
    for (TinkerQuantity of = {block, 0}; of.quantity < block_class->quantity_count; of.quantity++)
        g_array_append_val(columns, of);
}

static void add_named(GArray *columns, TinkerScene *scene, const char *name, const char *id)
{
    TinkerBlockId block;
    if (!tinker_scene_find_owner(scene, name, &block)) return;
    const TinkerQuantity of = {block, tinker_scene_find_quantity(scene, block, id)};
    if (of.quantity >= 0) g_array_append_val(columns, of);
}

/* What depends on the time alone needs some record all the same. */
static void add_expression(GArray *columns, TinkerScene *scene, const char *expression)
{
    static const TinkerQuantity any = {TINKER_NO_BLOCK, TINKER_SCENE_KINETIC};
    g_autoptr(GArray) needed = tinker_columns_new();
    g_autoptr(TinkerFormula) formula = tinker_formula_new(scene, expression, needed, NULL);
    for (guint i = 0; i < needed->len; i++) {
        const TinkerColumn *column = &g_array_index(needed, TinkerColumn, i);
        const TinkerQuantity of = {column->block, column->quantity};
        g_array_append_val(columns, of);
    }
    if (formula != NULL && needed->len == 0) g_array_append_val(columns, any);
}

static void add_graphed(GArray *columns, TinkerScene *scene, const TinkerSceneGraph *graph)
{
    for (guint k = 0; k < graph->curves->len; k++) {
        const TinkerSceneCurve *curve = g_ptr_array_index(graph->curves, k);
        if (curve->expression != NULL) add_expression(columns, scene, curve->expression);
        if (curve->block == NULL) continue;
        add_named(columns, scene, curve->block, curve->quantity);
        add_named(columns, scene, curve->block, graph->against);
    }
}

static void add_metered(GArray *columns, TinkerScene *scene, const TinkerSceneInstrument *meter)
{
    TinkerBlockId block;
    if (tinker_instrument_controls(meter) || !tinker_scene_find_owner(scene, meter->block, &block)) return;
    TinkerQuantity of = {block, tinker_scene_find_quantity(scene, block, meter->of)};
    if (of.quantity >= 0) g_array_append_val(columns, of);
}

static int compare(const void *left, const void *right)
{
    const TinkerQuantity *l = left, *r = right;
    if (l->block != r->block) return l->block < r->block ? -1 : 1;
    return (l->quantity > r->quantity) - (l->quantity < r->quantity);
}

static void remove_repeated(GArray *columns)
{
    g_array_sort(columns, compare);
    guint kept = 0;
    for (guint i = 0; i < columns->len; i++) {
        TinkerQuantity *quantities = (TinkerQuantity *)(gpointer)columns->data;
        if (kept == 0 || compare(&quantities[kept - 1], &quantities[i]) != 0) quantities[kept++] = quantities[i];
    }
    g_array_set_size(columns, kept);
}

/* All there are, or as many as are too many. */
static void add_all(GArray *columns, TinkerScene *scene, gboolean energies)
{
    const int32_t count = tinker_scene_block_count(scene);
    for (int32_t place = 0; place < count && columns->len <= MOST; place++)
        add_quantities(columns, scene, tinker_scene_block_at(scene, place));
    for (TinkerQuantity of = {TINKER_NO_BLOCK, 0}; energies && of.quantity < TINKER_SCENE_QUANTITIES; of.quantity++)
        g_array_append_val(columns, of);
}

static void add_shown(GArray *columns, TinkerScene *scene)
{
    GPtrArray *graphs = tinker_scene_graphs(scene);
    for (guint i = 0; i < graphs->len; i++)
        add_graphed(columns, scene, g_ptr_array_index(graphs, i));
    GPtrArray *instruments = tinker_scene_instruments(scene);
    for (guint i = 0; i < instruments->len; i++)
        add_metered(columns, scene, g_ptr_array_index(instruments, i));
}

static void add_selected(GArray *columns, TinkerDocument *document)
{
    int selected;
    const TinkerBlockId *selection = tinker_document_selection(document, &selected);
    for (int i = 0; i < selected && columns->len <= MOST; i++)
        add_quantities(columns, tinker_document_scene(document), selection[i]);
}

static void add_asked(GArray *columns, TinkerScene *scene, const GArray *asked)
{
    for (guint i = 0; i < asked->len; i++) {
        TinkerQuantity of = g_array_index(asked, TinkerQuantity, i);
        const TinkerBlockId other = tinker_quantity_other(of.quantity);
        if (other != TINKER_NO_BLOCK && !tinker_scene_has_block(scene, other)) continue;
        if (of.block == TINKER_NO_BLOCK || tinker_scene_has_block(scene, of.block)) g_array_append_val(columns, of);
    }
}

GArray *tinker_recorded_quantities(TinkerDocument *document, const GArray *asked, gboolean brief)
{
    TinkerScene *scene = tinker_document_scene(document);
    GArray *columns = g_array_new(FALSE, FALSE, sizeof(TinkerQuantity));
    add_all(columns, scene, !brief);
    const gboolean all = columns->len <= MOST;
    if (!all) g_array_set_size(columns, 0);
    add_shown(columns, scene);
    if (!all) add_selected(columns, document);
    add_asked(columns, scene, asked);
    remove_repeated(columns);
    return columns;
}
