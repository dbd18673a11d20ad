/* What the files that write a scene share. */
#ifndef TINKER_CORE_WRITE_PRIVATE_H
#define TINKER_CORE_WRITE_PRIVATE_H

#include "scene/position-scanner.h"
#include "scene/scene-json.h"
#include "scene/scene-private.h"

typedef struct {
    TinkerScene *scene;
    TinkerWriteUnits units;
    GString *out;
    guint8 *named; /* by id: some end or graph names the block; made when first needed */
} SceneWriter;

/* A number; in English units where the text reads back to the same bits. */
void scene_write_number(SceneWriter *writer, double value, TinkerDimension dimension);
void scene_write_vector(SceneWriter *writer, const double values[2], TinkerDimension dimension);

/* A key inside an object on one line, with a comma in front where one is due. */
void scene_write_key(SceneWriter *writer, const char *key);
void scene_write_text_member(SceneWriter *writer, const char *key, const char *text);
void scene_write_number_member(SceneWriter *writer, const char *key, double value, TinkerDimension dimension);

/* Members that are text already; NULL for none. */
void scene_write_extras(SceneWriter *writer, const char *extras);

void scene_write_block(SceneWriter *writer, TinkerBlockId id);

#endif
