/* The axes of graphs: title, unit and factor come from the block's class and the scene's system of units. */
#include "common/graph/graph-axis.h"

#include <glib/gi18n.h>
#include <string.h>

TinkerGraphAxis tinker_graph_axis_time(void)
{
    return (TinkerGraphAxis){N_("Time"), "s", 1, TINKER_DIMENSION_TIME, TINKER_NO_BLOCK};
}

TinkerGraphAxis tinker_graph_axis_frequency(void)
{
    return (TinkerGraphAxis){"Frequency", "Hz", 1, {.time = -1}, TINKER_NO_BLOCK};
}

TinkerGraphAxis tinker_graph_axis(TinkerScene *scene, TinkerBlockId block, int32_t quantity)
{
    const TinkerQuantityType type = tinker_scene_quantity_type(scene, block, quantity);
    const TinkerUnitSystem system = tinker_scene_head(scene)->units;
    const char *name = block == TINKER_NO_BLOCK
                           ? tinker_unit_for(type.dimension, system)
                           : tinker_block_class_unit(tinker_scene_block_class(scene, block), type.id, type.dimension,
                                                     system == TINKER_UNIT_SYSTEM_ENGLISH);
    TinkerUnit unit = {1, type.dimension};
    if (name[0] != '\0' && !tinker_unit_parse(name, &unit, NULL)) unit.factor = 1;
    return (TinkerGraphAxis){type.title, name, 1 / unit.factor, type.dimension, block};
}

char *tinker_axis_label(const char *title, const char *unit)
{
    return unit[0] != '\0' ? g_strdup_printf("%s [%s]", title, unit) : g_strdup(title);
}

gboolean tinker_graph_axes_of_path(const TinkerGraphAxis *x, const TinkerGraphAxis *y)
{
    static const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    return tinker_dimension_equal(x->dimension, length) && tinker_dimension_equal(y->dimension, length);
}

TinkerGraphAxis tinker_graph_axis_of_value(TinkerScene *scene, const char *title, const TinkerDimension *dimension,
                                           const char *wanted)
{
    static const TinkerDimension none = {0};
    const char *shown = dimension != NULL ? tinker_unit_for(*dimension, tinker_scene_head(scene)->units) : "";
    const char *name = wanted != NULL ? wanted : shown;
    TinkerUnit unit = {1, none};
    const gboolean fits = dimension != NULL && name[0] != '\0' && tinker_unit_parse(name, &unit, NULL) &&
                          tinker_dimension_equal(unit.dimension, *dimension);
    return (TinkerGraphAxis){g_intern_string(title), g_intern_string(name), fits ? 1 / unit.factor : 1,
                             dimension != NULL ? *dimension : none, TINKER_NO_BLOCK};
}

char *tinker_graph_axes_label(const TinkerGraphAxis *axes, guint count)
{
    const char *second = NULL; /* title */
    gboolean two_titles = TRUE, same_unit = TRUE;
    if (count == 0) return NULL;
    for (guint i = 1; i < count; i++) {
        if (second == NULL && strcmp(axes[0].title, axes[i].title) != 0) second = axes[i].title;
        if (strcmp(axes[0].title, axes[i].title) != 0 && strcmp(second, axes[i].title) != 0) two_titles = FALSE;
        if (strcmp(axes[0].unit, axes[i].unit) != 0) same_unit = FALSE;
    }
    if (!same_unit) return g_strdup(_("units as in the legend"));
    if (second == NULL) return tinker_axis_label(axes[0].title, axes[0].unit);
    g_autofree char *name = two_titles ? g_strdup_printf("%s, %s", axes[0].title, second)
                                       : g_strdup(tinker_dimension_name(axes[0].dimension));
    if (!two_titles) name[0] = g_ascii_toupper(name[0]);
    return tinker_axis_label(name, axes[0].unit);
}

void tinker_csv_axis(TinkerCsvWriter *writer, const TinkerScene *scene, const TinkerGraphAxis *axis, gboolean several)
{
    const char *block = several && axis->block != TINKER_NO_BLOCK ? tinker_scene_block_name(scene, axis->block) : "";
    g_autofree char *heading = g_strconcat(block, *block != '\0' ? " " : "", axis->title, NULL);
    tinker_csv_text(writer, heading);
}
