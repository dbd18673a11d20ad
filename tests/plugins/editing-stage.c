#include "editing-stage.h"

#include <math.h>

static void stage_set(const TinkerEditor *editor, int32_t column, double value)
{
    EditingStage *stage = editor->context;
    g_assert_cmpint(column, >=, 0);
    g_assert_cmpint(column, <, block_columns(stage->block));
    stage->columns[column] = value;
    stage->calls++;
}

static void stage_set_end(const TinkerEditor *editor, int32_t end, double x, double y)
{
    EditingStage *stage = editor->context;
    g_assert_cmpint(end, >=, 0);
    g_assert_cmpint(end, <, stage->instance.ends);
    stage->ends[end] = (TinkerEnd){x, y, 0, 0, 0};
    stage->calls++;
}

void editing_init(EditingStage *stage, const char *name)
{
    g_autoptr(BlockBatch) defaults = block_batch_new(block_open(name), 1);
    *stage = (EditingStage){.block = defaults->block, .edit = block_interface(defaults->block, TINKER_EDIT_INTERFACE)};
    for (int32_t column = 0; column < block_columns(stage->block); column++) {
        stage->columns[column] = defaults->columns[column][0];
    }
    stage->instance = (TinkerInstance){.struct_size = sizeof(TinkerInstance),
                                       .ends = stage->block->most_ends,
                                       .name = name,
                                       .columns = stage->columns,
                                       .end = stage->ends,
                                       .symbol_size = 0.2};
    stage->editor = (TinkerEditor){
        .struct_size = sizeof(TinkerEditor), .context = stage, .set = stage_set, .set_end = stage_set_end};
}

double *editing_column(EditingStage *stage, const char *property)
{
    return &stage->columns[block_column(stage->block, property)];
}

int32_t editing_hit(EditingStage *stage, double x, double y)
{
    return stage->edit->hit(&stage->instance, x, y, EDITING_REACH);
}

void editing_move(EditingStage *stage, int32_t part, double dx, double dy)
{
    stage->edit->move(&stage->instance, part, dx, dy, &stage->editor);
}

void editing_move_absolute(EditingStage *stage, int32_t part, double x, double y)
{
    stage->edit->move_absolute(&stage->instance, part, x, y, &stage->editor);
}

gboolean editing_find_handle(EditingStage *stage, int32_t part, TinkerHandle *found)
{
    TinkerHandle handles[8];
    const int32_t count = stage->edit->handles(&stage->instance, handles, 8);
    for (int32_t k = 0; k < count; k++) {
        if (handles[k].part == part) {
            *found = handles[k];
            return TRUE;
        }
    }
    return FALSE;
}

void editing_drag_handle(EditingStage *stage, int32_t part, double x, double y)
{
    TinkerHandle handle = {0};
    g_assert_true(editing_find_handle(stage, part, &handle));
    editing_move(stage, part, x - handle.x, y - handle.y);
}
