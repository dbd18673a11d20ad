/* One block on a canvas, and the editor that changes it: carries out what it is told on the instance itself. */
#ifndef TEST_EDITING_STAGE_H
#define TEST_EDITING_STAGE_H

#include "plugin-fixture.h"

#define PI            3.14159265358979323846
#define EDITING_REACH 0.05

typedef struct {
    const TinkerBlockType *block;
    const TinkerEdit *edit;
    double columns[32];
    TinkerEnd ends[2];
    TinkerInstance instance;
    TinkerEditor editor;
    int calls;
} EditingStage;

/* Of a block type that is installed, with its defaults. */
void editing_init(EditingStage *stage, const char *name);
/* The first column of a property. Borrowed. */
double *editing_column(EditingStage *stage, const char *property);

/* What the block answers, and does. */
int32_t editing_hit(EditingStage *stage, double x, double y);
void editing_move(EditingStage *stage, int32_t part, double dx, double dy);
void editing_move_absolute(EditingStage *stage, int32_t part, double x, double y);
gboolean editing_find_handle(EditingStage *stage, int32_t part, TinkerHandle *found);

/* A handle that is dragged somewhere lies there afterwards. */
void editing_drag_handle(EditingStage *stage, int32_t part, double x, double y);

#endif
