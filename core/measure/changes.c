/* Numbers of blocks and of the run, one after another. */
#include "measure/changes.h"

#include <math.h>
#include <string.h>

#define MOST 2 /* that are told */

typedef struct {
    GString *text;
    int count;
    gboolean only_before; /* what it was, and not what it became */
} Changes;

static void add(Changes *changes, const char *what, double before, double after, const char *unit)
{
    if (before == after || (isnan(before) && isnan(after))) return;
    if (changes->count++ >= MOST) return;
    g_string_append_printf(changes->text, "%s%s %.6g", changes->count > 1 ? ", " : "", what, before);
    if (!changes->only_before) g_string_append_printf(changes->text, " → %.6g", after);
    g_string_append_printf(changes->text, "%s%s", unit[0] != '\0' ? " " : "", unit);
}

static void add_property(Changes *changes, TinkerScene *scenes[2], const TinkerBlockId blocks[2],
                         const TinkerBlockClass *block_class, int32_t p)
{
    const TinkerPropertyType *property = &block_class->properties[p];
    const gboolean vector = property->kind == TINKER_KIND_VECTOR;
    if (!vector && property->kind != TINKER_KIND_REAL && property->kind != TINKER_KIND_INTEGER &&
        property->kind != TINKER_KIND_SWITCH)
        return;
    if (strcmp(property->id, "local_origin") == 0) return; /* which moves nothing */
    for (int32_t k = 0; k < (vector ? 2 : 1); k++) {
        const int32_t column = block_class->first_columns[p] + k;
        const char *title =
            vector && property->component_titles[k] != NULL ? property->component_titles[k] : property->title;
        g_autofree char *what = g_strdup_printf("%s: %s", tinker_scene_block_name(scenes[0], blocks[0]), title);
        const char *unit = tinker_block_class_unit(block_class, property->id, property->dimension,
                                                   tinker_scene_head(scenes[0])->units == TINKER_UNIT_SYSTEM_ENGLISH);
        TinkerUnit read = {1, property->dimension};
        if (unit[0] != '\0' && !tinker_unit_parse(unit, &read, NULL)) read.factor = 1;
        add(changes, what, tinker_scene_get(scenes[0], blocks[0], column) / read.factor,
            tinker_scene_get(scenes[1], blocks[1], column) / read.factor, unit);
    }
}

static char *list_changes(TinkerScene *before, TinkerScene *after, gboolean only_before)
{
    TinkerScene *scenes[2] = {before, after};
    g_autoptr(GString) text = g_string_new(NULL);
    Changes changes = {text, 0, only_before};
    for (int32_t place = 0; place < tinker_scene_block_count(before); place++) {
        const TinkerBlockId block = tinker_scene_block_at(before, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(before, block);
        const TinkerBlockId blocks[2] = {block, tinker_scene_find_block(after, tinker_scene_block_name(before, block))};
        if (block_class == NULL || blocks[1] == TINKER_NO_BLOCK) continue;
        const TinkerBlockClass *other = tinker_scene_block_class(after, blocks[1]);
        if (other == NULL || strcmp(other->type->id, block_class->type->id) != 0) continue;
        for (int32_t p = 0; p < MIN(block_class->property_count, other->property_count); p++)
            add_property(&changes, scenes, blocks, block_class, p);
    }
    const TinkerRunSettings *a = &tinker_scene_head(before)->run, *b = &tinker_scene_head(after)->run;
    add(&changes, "step", a->step, b->step, "s");
    add(&changes, "tolerance", a->tolerance, b->tolerance, "");
    add(&changes, "accuracy", a->accuracy, b->accuracy, "");
    if (changes.count > MOST) g_string_append_printf(text, ", and %d more", changes.count - MOST);
    return changes.count > 0 ? g_strdup(text->str) : NULL;
}

char *tinker_scene_changes(TinkerScene *before, TinkerScene *after)
{
    return list_changes(before, after, FALSE);
}

char *tinker_scene_values_changed(TinkerScene *before, TinkerScene *after)
{
    return list_changes(before, after, TRUE);
}
