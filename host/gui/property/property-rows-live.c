/* Rows of how things are: what a block's quantities are at the time that is shown. */
#include <glib/gi18n.h>

#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "gui/text/translate.h"

#define LIVE_DIGITS 4 /* as many as can be read while they change */

void property_rows_add_readings(PropertyBuilder *builder)
{
    const TinkerBlockClass *block_class = builder->block_class;
    gboolean english = builder->system == TINKER_UNIT_SYSTEM_ENGLISH;
    if (block_class->graph == NULL) return;
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        const TinkerQuantityType *type = &block_class->quantities[i];
        double value;
        if (!tinker_player_value(builder->player, builder->blocks[0], i, &value)) continue;
        TinkerPropertyRow *row = property_builder_add(
            builder, TINKER_ROW_READING, _("Now"), tinker_translate(type->title), tinker_translate(type->description));
        row->property = i;
        row->unit = tinker_block_class_unit(block_class, type->id, type->dimension, english);
        property_row_take_text(row, tinker_number_measured(value, row->unit, LIVE_DIGITS));
    }
}
