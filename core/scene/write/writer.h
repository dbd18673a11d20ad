/* What the files that write a scene share. */
#ifndef TINKER_CORE_WRITER_H
#define TINKER_CORE_WRITER_H

#include "scene/json/position-scanner.h"
#include "scene/read/scene-json.h"
#include "scene/store/scene-data.h"

/* A waveform that a fragment's text does not hold all of. */
typedef struct {
    TinkerWaveform *waveform;
    char *source; /* see TinkerScene; NULL: none */
} SceneKeptWaveform;

typedef struct {
    TinkerScene *scene;
    TinkerWriteUnits units;
    GString *out;
    guint8 *named; /* by id: some end or graph names the block; made when first needed */

    /* Of a fragment, else NULL. */
    const guint8 *only; /* by id: whether the block is in it */
    GHashTable *texts;  /* what a waveform that needs its source is written as, to the SceneKeptWaveform; both owned */
} SceneWriter;

/* The members "blocks" and "graphs" of the top level, each on a line of its own, with a comma in front. */
void scene_write_blocks(SceneWriter *writer);
void scene_write_graphs(SceneWriter *writer);
/* "controls" and "meters", where there are any. */
void scene_write_instruments(SceneWriter *writer);

void scene_write_vector(SceneWriter *writer, const double values[2], TinkerDimension dimension);

/* A key inside an object on one line, with a comma in front where one is due. */
void scene_write_key(SceneWriter *writer, const char *key);
void scene_write_text_member(SceneWriter *writer, const char *key, const char *text);
void scene_write_number_member(SceneWriter *writer, const char *key, double value, TinkerDimension dimension);

/* Members that are text already; NULL for none. */
void scene_write_extras(SceneWriter *writer, const char *extras);

void scene_write_block(SceneWriter *writer, TinkerBlockId id);

#endif
