/* What the tests of drags share: a scene of two masses, a floor and a spring, with its history. */
#ifndef TEST_DRAG_STAGE_H
#define TEST_DRAG_STAGE_H

#include "edit/drag.h"
#include "scene-fixture.h"

#define REACH 0.1

typedef struct {
    TinkerScene *scene;
    TinkerHistory *history;
    char *before; /* the scene as text */
} Stage;

void stage_set_up(Stage *stage, gconstpointer data);
void stage_tear_down(Stage *stage, gconstpointer data);

/* A test of a stage. */
#define stage_add(path, function) g_test_add(path, Stage, NULL, stage_set_up, function, stage_tear_down)

TinkerBlockId stage_block(const Stage *stage, const char *name);
/* (transfer full) */
TinkerDrag *stage_grab(Stage *stage, const char *name, int32_t part, double x, double y);

/* A component of the property with a meaning. */
double stage_value(const TinkerScene *scene, const char *name, int32_t meaning, int32_t component);
void stage_expect_place(const Stage *stage, const char *name, double x, double y);
/* The scene is as it was read, and nothing can be undone. */
void stage_expect_untouched(const Stage *stage);

#endif
