/* A stage for drawings: one instance of a block, and a style whose helpers only take notes of where they were asked to
 * draw, and in which colours. */
#ifndef DRAWING_STAGE_H
#define DRAWING_STAGE_H

#include "plugin-fixture.h"

#define PI           3.14159265358979323846
#define SYMBOL       0.25 /* m */
#define STAGE_POINTS 4096 /* of all polylines of a drawing */

/* One call of a helper. */
typedef struct {
    const char *helper;
    int32_t colour, edge;  /* of a mark: whether it is attached */
    double x1, y1, x2, y2; /* of a polyline its first point and its last */
    double number;         /* rest length of a coil, radius of a circle, points of a polyline */
    const double *points;  /* of a polyline, x and y; else NULL */
} Note;

typedef struct {
    TinkerStyle style;
    Note notes[64];
    int count;
    double box[4]; /* what was drawn on, m */
    double points[2 * STAGE_POINTS];
    int point_count;
} Recorder;

/* One instance with default properties, at (1, 2), its ends at (1, 2) and (4, 6). */
typedef struct {
    BlockBatch *batch;
    double columns[32];
    TinkerEnd ends[4];
    TinkerInstance instance;
    uint32_t state; /* TINKER_STATE_..., to draw it in */
    Recorder recorder;
} Stage;

void stage_init(Stage *stage, const char *name);
void stage_set(Stage *stage, const char *property, double value);

/* Draws, and checks that the drawing stays in its bounds. */
void stage_draw(Stage *stage);

/* The n-th call of a helper, which must exist; how many there are. */
const Note *stage_note(const Stage *stage, const char *helper, int number);
int stage_notes(const Stage *stage, const char *helper);

void stage_assert_line(const Note *drawn, double x1, double y1, double x2, double y2);

#endif
