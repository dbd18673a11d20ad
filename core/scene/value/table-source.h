/* Waveforms that are tables in files: what a scene's file says of one, and reading one for a scene that is there
 * already. The format is docs/reference/scene-format.md. */
#ifndef TINKER_CORE_TABLE_SOURCE_H
#define TINKER_CORE_TABLE_SOURCE_H

#include "scene/store/scene.h"

#define TINKER_TABLE_MOST_COLUMN 1000000

/* The members of the object {"table": ...} of a scene's file. */
typedef struct {
    const char *file; /* in UTF-8, relative to the scene's folder, in which it must lie */
    int column;       /* from 1 to TINKER_TABLE_MOST_COLUMN; column 0 is the time */
    double scale;
    TinkerTableKind kind;
} TinkerTableSource;

/* Reads a table as a waveform for the property; `path` is the scene's file, whose folder holds it. The scene knows from
 * then on how to write it. Keys that this program does not know are taken over from `former` (may be NULL), the table
 * in its place until now. Errors are those of reading a scene: of the file with its line and column. (transfer full) */
TinkerWaveform *tinker_scene_read_table(TinkerScene *scene, const char *path, const TinkerTableSource *source,
                                        const TinkerPropertyType *property, TinkerWaveform *former, GError **error);

/* The file that a table of the scene was read from, relative to the scene's folder; NULL where it was not read from
 * one. (transfer full) */
char *tinker_scene_table_file(const TinkerScene *scene, TinkerWaveform *waveform);

/* The files of all tables that the scene names, relative to its folder, each once and in no order; also of those in
 * what is kept as it was read: blocks of missing types and unknown keys. Of char *. (transfer full) */
GPtrArray *tinker_scene_table_files(const TinkerScene *scene);

#endif
