/* Names in braces are found while the text is parsed, so that what is wrong with one has a column. */
#include "scene/store/scene-expression.h"

#include <glib/gi18n-lib.h>
#include <string.h>

static gboolean is_number(const TinkerPropertyType *property)
{
    return property->kind == TINKER_KIND_REAL || property->kind == TINKER_KIND_INTEGER ||
           property->kind == TINKER_KIND_SWITCH || property->kind == TINKER_KIND_VECTOR;
}

static char *unknown_block(const TinkerScene *scene, const char *name)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new();
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++)
        g_ptr_array_add(names, (gpointer)tinker_scene_block_name(scene, tinker_scene_block_at(scene, place)));
    g_ptr_array_add(names, NULL);
    const char *dot = strrchr(name, '.');
    g_autofree char *block = dot != NULL ? g_strndup(name, (gsize)(dot - name)) : g_strdup(name);
    const char *nearest = tinker_nearest_word(block, (const char *const *)names->pdata);
    if (nearest != NULL) return g_strdup_printf(_("there is no block \"%s\"; did you mean \"%s\"?"), block, nearest);
    return g_strdup_printf(_("there is no block \"%s\" (in braces stands BLOCK.QUANTITY, as in {Mass 0.x})"), block);
}

static char *unknown_quantity(const TinkerScene *scene, TinkerBlockId block, const char *name)
{
    g_autoptr(GStrvBuilder) builder = g_strv_builder_new();
    g_auto(GStrv) quantities = tinker_scene_quantity_names(scene, block);
    const TinkerBlockClass *block_class = block == TINKER_NO_BLOCK ? NULL : tinker_scene_block_class(scene, block);
    g_strv_builder_addv(builder, (const char **)quantities);
    for (int32_t p = 0; block_class != NULL && p < block_class->property_count; p++)
        if (is_number(&block_class->properties[p])) g_strv_builder_add(builder, block_class->properties[p].id);
    g_auto(GStrv) known = g_strv_builder_end(builder);
    g_autofree char *list = g_strjoinv(", ", known);
    const char *nearest = tinker_nearest_word(name, (const char *const *)known);
    g_autofree char *guess = nearest != NULL ? g_strdup_printf(_("; did you mean \"%s\"?"), nearest)
                                             : g_strdup_printf(_(" (it has %s)"), list);
    return g_strdup_printf(_("%s has no quantity or property \"%s\"%s"), tinker_scene_owner_name(scene, block), name,
                           guess);
}

/* Finds "BLOCK.QUANTITY" or "BLOCK.PROPERTY"; FALSE where it is neither, and `why` says so (transfer full). */
static gboolean find_reference(const TinkerScene *scene, const char *name, TinkerReference *reference, char **why)
{
    TinkerBlockId block;
    const char *rest = tinker_scene_split_name(scene, name, &block);
    if (rest == NULL) {
        *why = unknown_block(scene, name);
        return FALSE;
    }
    TinkerNumber number;
    *reference = (TinkerReference){.block = block, .quantity = tinker_scene_find_quantity(scene, block, rest)};
    if (reference->quantity >= 0)
        reference->dimension = tinker_scene_quantity_type(scene, block, reference->quantity).dimension;
    if (reference->quantity >= 0) return TRUE;
    if (!tinker_scene_find_number(scene, block, rest, &number)) {
        *why = unknown_quantity(scene, block, rest);
        return FALSE;
    }
    reference->column = number.column;
    reference->dimension = number.type->dimension;
    return TRUE;
}

typedef struct {
    const TinkerScene *scene;
    GArray *references;
} Finder;

static gboolean find(const char *symbol, void *data, char **why)
{
    Finder *finder = data;
    TinkerReference reference;
    g_autofree char *name = g_strndup(symbol + 1, strlen(symbol) - 2);
    for (guint i = 0; i < finder->references->len; i++)
        if (strcmp(g_array_index(finder->references, TinkerReference, i).symbol, symbol) == 0) return TRUE;
    if (!find_reference(finder->scene, name, &reference, why)) return FALSE;
    reference.symbol = g_intern_string(symbol);
    g_array_append_val(finder->references, reference);
    return TRUE;
}

TinkerSceneExpression *tinker_scene_expression_new(const TinkerScene *scene, const char *text, GError **error)
{
    Finder finder = {scene, g_array_new(FALSE, FALSE, sizeof(TinkerReference))};
    TinkerExpression *tree = tinker_expression_parse_quantities(text, find, &finder, error);
    if (tree == NULL) {
        g_array_unref(finder.references);
        return NULL;
    }
    TinkerSceneExpression *expression = g_new(TinkerSceneExpression, 1);
    *expression = (TinkerSceneExpression){tree, finder.references};
    return expression;
}

void tinker_scene_expression_free(TinkerSceneExpression *expression)
{
    if (expression == NULL) return;
    tinker_expression_unref(expression->tree);
    g_array_unref(expression->references);
    g_free(expression);
}

/* Renaming --------------------------------------------------------------------------------------------------------- */

/* "Mass 0.distance to Mass 1" once a block has another name; NULL where it names it nowhere. */
static char *renamed_reference(const char *name, const char *from, const char *to)
{
    const gsize length = strlen(from);
    const gboolean owner = g_str_has_prefix(name, from) && name[length] == '.';
    const char *dot = owner ? name + length : strstr(name, ".distance to ");
    if (dot == NULL) return NULL;
    g_autofree char *before = owner ? g_strdup(to) : g_strndup(name, (gsize)(dot - name));
    g_autofree char *other = tinker_quantity_renamed(dot + 1, from, to);
    return owner || other != NULL ? g_strconcat(before, ".", other != NULL ? other : dot + 1, NULL) : NULL;
}

char *tinker_scene_expression_renamed(const char *text, const char *from, const char *to)
{
    g_autoptr(GString) result = g_string_new(NULL);
    gboolean changed = FALSE;
    for (const char *open = strchr(text, '{'), *close; open != NULL; open = strchr(text, '{')) {
        close = strchr(open, '}');
        if (close == NULL) break;
        g_autofree char *name = g_strndup(open + 1, (gsize)(close - open - 1));
        g_autofree char *renamed = renamed_reference(name, from, to);
        g_string_append_len(result, text, open + 1 - text);
        g_string_append(result, renamed != NULL ? renamed : name);
        g_string_append_c(result, '}');
        changed |= renamed != NULL;
        text = close + 1;
    }
    g_string_append(result, text);
    return changed ? g_strdup(result->str) : NULL;
}
