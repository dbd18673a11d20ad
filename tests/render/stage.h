/* A scene that is painted into a picture in memory, for tests of the painter. */
#ifndef TEST_STAGE_H
#define TEST_STAGE_H

#include "picture.h"
#include "render/picture/painter-private.h"

#define TEST_STAGE_WIDTH  600
#define TEST_STAGE_HEIGHT 400

typedef struct {
    TinkerScene *scene;
    TinkerFrame *frame;
    TestPicture *picture;
    TinkerView view;
    TinkerPaintOptions options;
    GPtrArray *written; /* of TinkerWrittenText: the texts of the picture that was painted last */
} TestStage;

/* These lines as `blocks`, 50 pixels to a metre about the world's origin, without grid and labels. */
void test_stage_open(TestStage *stage, const char *blocks);
void test_stage_close(TestStage *stage);

/* Paints, and checks that the context is left as it was. */
void test_stage_paint(TestStage *stage);

/* Pixels near a colour of the theme. */
int test_stage_shown(const TestStage *stage, int colour);

/* The text as it was written, or NULL. */
const TinkerWrittenText *test_stage_text(const TestStage *stage, const char *text);

#endif
