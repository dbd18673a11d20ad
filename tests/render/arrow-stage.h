/* A picture that arrows of forces are drawn on, with what was written on it. */
#ifndef TEST_ARROW_STAGE_H
#define TEST_ARROW_STAGE_H

#include "picture.h"
#include "render/draw/text.h"
#include "render/picture/arrows-private.h"

#define ARROW_WIDTH  600
#define ARROW_HEIGHT 400

/* 50 canvas units a metre, with the origin in the middle. */
extern const TinkerView arrow_view;

typedef struct {
    TestPicture *picture;
    GPtrArray *written; /* of TinkerWrittenText */
    TinkerArrowOptions options;
} ArrowStage;

/* Empty, in the ground of this theme, for arrows of `scale` (m/N). */
void arrow_stage_open(ArrowStage *stage, const char *theme, double scale);
void arrow_stage_close(ArrowStage *stage);

/* Leaves the context's matrix as it was. */
void arrow_stage_draw(ArrowStage *stage, const TinkerForceArrow *arrows, gsize count);

/* Text number i. Borrowed. */
const TinkerWrittenText *arrow_stage_written(const ArrowStage *stage, guint i);

/* Of a point from a box, canvas units. */
double arrow_distance_to(const double box[4], double x, double y);

/* No text leaves the picture or lies on another. */
void arrow_stage_assert_inside_and_apart(const ArrowStage *stage);

#endif
