/* Columns of a record, found by name. */
#include "physics/record/columns.h"

#include <string.h>

static void column_clear(gpointer data)
{
    g_free(((TinkerColumn *)data)->name);
}

GArray *tinker_columns_new(void)
{
    GArray *columns = g_array_new(FALSE, TRUE, sizeof(TinkerColumn));
    g_array_set_clear_func(columns, column_clear);
    return columns;
}

void tinker_columns_add_quantity(GArray *columns, TinkerScene *scene, TinkerBlockId block, int32_t quantity)
{
    const TinkerQuantityType type = tinker_scene_quantity_type(scene, block, quantity);
    TinkerColumn column = {
        .block = block,
        .quantity = quantity,
        .name = g_strconcat(tinker_scene_owner_name(scene, block), ".", type.id, NULL),
        .title = type.title,
        .dimension = type.dimension,
        .unit = block == TINKER_NO_BLOCK
                    ? tinker_unit_si_symbol(type.dimension)
                    : tinker_block_class_si_unit(tinker_scene_block_class(scene, block), type.id, type.dimension),
    };
    g_array_append_val(columns, column);
}

static void append_recorded(GArray *columns, TinkerScene *scene, gboolean connectable)
{
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block_class == NULL) continue;
        gboolean is_body = block_class->physics != NULL && block_class->physics->body != NULL;
        if (is_body != connectable) continue;
        for (int32_t q = 0; q < block_class->quantity_count; q++)
            if (block_class->quantities[q].flags & TINKER_RECORDED)
                tinker_columns_add_quantity(columns, scene, block, q);
    }
}

GArray *tinker_columns_default(TinkerScene *scene)
{
    GArray *columns = tinker_columns_new();
    append_recorded(columns, scene, TRUE);
    append_recorded(columns, scene, FALSE);
    return columns;
}

/* "Gravity, Pivot, Bob": the first of the names. */
static char *list_names(const char *const *names)
{
    const int most = 8;
    GString *list = g_string_new(NULL);
    for (int i = 0; i <= most && names[i] != NULL; i++)
        g_string_append_printf(list, "%s%s", i > 0 ? ", " : "", i < most ? names[i] : "...");
    if (names[0] == NULL) g_string_append(list, "none");
    return g_string_free(list, FALSE);
}

static gboolean unknown_block(TinkerScene *scene, const char *column, const char *block, GError **error)
{
    int32_t count = tinker_scene_block_count(scene);
    g_autofree const char **names = g_new0(const char *, count + 1);
    for (int32_t place = 0; place < count; place++)
        names[place] = tinker_scene_block_name(scene, tinker_scene_block_at(scene, place));
    const char *nearest = tinker_nearest_word(block, names);
    g_autofree char *known = nearest != NULL ? NULL : list_names(names);
    g_autofree char *others =
        nearest != NULL ? g_strdup_printf("; did you mean \"%s\"?", nearest) : g_strdup_printf(" (it has %s)", known);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME,
                "column \"%s\": the scene has no block \"%s\"%s (a column is BLOCK.QUANTITY, as in \"Mass 0.x\"%s)",
                column, block, others, strchr(column, '.') == NULL ? "; put quotes round a name with a space" : "");
    return FALSE;
}

/* "x, y, path length", of those that the block has. (transfer full) */
static char *known_quantities(TinkerScene *scene, TinkerBlockId block)
{
    g_auto(GStrv) names = tinker_scene_quantity_names(scene, block);
    return names[0] != NULL ? g_strjoinv(", ", names) : g_strdup("none");
}

static gboolean unknown_quantity(TinkerScene *scene, TinkerBlockId block, const char *column, const char *quantity,
                                 GError **error)
{
    g_autofree char *known = known_quantities(scene, block);
    g_auto(GStrv) names = tinker_scene_quantity_names(scene, block);
    const char *other = tinker_quantity_other_name(quantity);
    const char *nearest = other == NULL ? tinker_nearest_word(quantity, (const char *const *)names) : NULL;
    const gboolean is_reckoned = nearest == NULL && other == NULL && strpbrk(quantity, "+*/^<>=") != NULL;
    g_autofree char *guess =
        nearest != NULL
            ? g_strdup_printf("; did you mean \"%s\"?", nearest)
            : g_strdup(is_reckoned ? "; in an expression quantities stand in braces, as in {Mass 0.x}*2" : "");
    g_autofree char *pair =
        other != NULL ? g_strdup_printf(", as \"%s\" is not another block with a place", other) : g_strdup("");
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME,
                "column \"%s\": %s has no quantity \"%s\"%s%s (it has %s)", column,
                block == TINKER_NO_BLOCK ? "the scene" : "this block", quantity, pair, guess, known);
    return FALSE;
}

/* A name alone, of a block or of the scene. */
static gboolean no_quantity(TinkerScene *scene, TinkerBlockId block, const char *column, GError **error)
{
    g_auto(GStrv) names = tinker_scene_quantity_names(scene, block);
    if (names[0] == NULL) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME,
                    "column \"%s\": this block has no quantities (a column is BLOCK.QUANTITY, as in \"Mass 0.x\")",
                    column);
        return FALSE;
    }
    g_autofree char *known = known_quantities(scene, block);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME,
                "column \"%s\": the quantity is missing, as in \"%s.%s\" (it has %s)", column, column, names[0], known);
    return FALSE;
}

/* Nobody knows the quantities of a placeholder. */
static gboolean missing_type(TinkerScene *scene, TinkerBlockId block, const char *column, GError **error)
{
    g_autofree char *reason = tinker_scene_missing_reason(scene, block);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_TYPE, "column \"%s\": the block's type is missing: %s",
                column, reason);
    return FALSE;
}

gboolean tinker_columns_add(GArray *columns, TinkerScene *scene, const char *name, GError **error)
{
    TinkerBlockId block;
    const char *dot = strrchr(name, '.');
    if (dot == NULL && tinker_scene_find_owner(scene, name, &block)) return no_quantity(scene, block, name, error);
    if (dot == NULL) return unknown_block(scene, name, name, error);
    const char *id = tinker_scene_split_name(scene, name, &block);
    g_autofree char *owner = g_strndup(name, (gsize)(dot - name));
    if (id == NULL) return unknown_block(scene, name, owner, error);
    if (block != TINKER_NO_BLOCK && tinker_scene_block_class(scene, block) == NULL)
        return missing_type(scene, block, name, error);
    int32_t quantity = tinker_scene_find_quantity(scene, block, id);
    if (quantity < 0) return unknown_quantity(scene, block, name, id, error);
    tinker_columns_add_quantity(columns, scene, block, quantity);
    return TRUE;
}

gboolean tinker_columns_add_list(GArray *columns, TinkerScene *scene, const char *list, GError **error)
{
    g_auto(GStrv) parts = g_strsplit(list, ",", -1);
    for (guint i = 0; parts[i] != NULL; i++) {
        g_autofree char *name = g_strdup(g_strstrip(parts[i]));
        g_autoptr(GError) first = NULL;
        if (*name == '\0' && parts[i + 1] == NULL && i > 0) break;
        gboolean found = tinker_columns_add(columns, scene, name, &first);
        /* A block's name may hold commas: take in more parts until it is found. */
        for (guint j = i + 1; !found && parts[j] != NULL; j++) {
            g_autofree char *longer = g_strdup_printf("%s,%s", name, parts[j]);
            g_free(name);
            name = g_steal_pointer(&longer);
            found = tinker_columns_add(columns, scene, name, NULL);
            if (found) i = j;
        }
        if (!found) {
            g_propagate_error(error, g_steal_pointer(&first));
            return FALSE;
        }
    }
    return TRUE;
}

gboolean *tinker_columns_place(const GArray *columns)
{
    gboolean *places = g_new0(gboolean, columns->len + 1);
    for (guint c = 0; c < columns->len; c++) {
        const TinkerDimension dimension = g_array_index(columns, TinkerColumn, c).dimension;
        places[c] = dimension.mass == 0 && dimension.time == 0;
    }
    return places;
}

gboolean *tinker_columns_turn(const GArray *columns)
{
    gboolean *turns = g_new0(gboolean, columns->len + 1);
    for (guint c = 0; c < columns->len; c++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, c);
        turns[c] = column->block != TINKER_NO_BLOCK && column->quantity == TINKER_IMPLIED_ANGLE;
    }
    return turns;
}
