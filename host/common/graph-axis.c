/* The axes of graphs: title, unit and factor come from the block's class and the scene's system of units. */
#include "graph-axis.h"

#include <glib/gi18n.h>

TinkerGraphAxis tinker_graph_axis_time(void)
{
    return (TinkerGraphAxis){N_("Time"), "s", 1, TINKER_DIMENSION_TIME, TINKER_NO_BLOCK};
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

void tinker_csv_axis(TinkerCsvWriter *writer, const TinkerScene *scene, const TinkerGraphAxis *axis, gboolean several,
                     gboolean units)
{
    const char *block = several && axis->block != TINKER_NO_BLOCK ? tinker_scene_block_name(scene, axis->block) : "";
    g_autofree char *title = tinker_axis_label(axis->title, units ? axis->unit : "");
    g_autofree char *heading = g_strconcat(block, *block != '\0' ? " " : "", title, NULL);
    tinker_csv_text(writer, heading);
}
