/* Scene files: reading, checking, writing. The format is docs/reference/scene-format.md. */
#ifndef TINKER_CORE_SCENE_JSON_H
#define TINKER_CORE_SCENE_JSON_H

#include "scene/store/scene.h"
#include "scene/value/findings.h"

/* Reads a scene from text. `path` (may be NULL) is what messages call it, and its folder is where table files are
 * looked for (NULL: the current one). Every mistake is added to `findings` (of TinkerFinding *, may be NULL), in the
 * order of the file. NULL if there is an error among them, and then `error` is the first: "FILE:LINE:COLUMN: message".
 * Blocks of types that nobody provides are kept as placeholders, with a warning. Unknown keys are kept, with a warning.
 * (transfer full) */
TinkerScene *tinker_scene_read_text(TinkerCatalogue *catalogue, const char *text, gsize length, const char *path,
                                    GPtrArray *findings, GError **error);

/* Reads a scene from a file, as tinker_scene_read_text() does from text; "-" is standard input. */
TinkerScene *tinker_scene_read_file(TinkerCatalogue *catalogue, const char *path, GPtrArray *findings, GError **error);

/* How numbers are written. */
typedef enum {
    TINKER_WRITE_SI,      /* plain numbers */
    TINKER_WRITE_ENGLISH, /* strings with English units, where they read back to the same bits */
} TinkerWriteUnits;

/* The scene's normal form: given properties alone, in the order of the descriptor; unknown keys and placeholders as
 * they were read. (transfer full) */
char *tinker_scene_to_text(TinkerScene *scene, TinkerWriteUnits units);

/* Writes it to a file, atomically: the old file stays until the new one is complete. "-" is standard output. */
gboolean tinker_scene_write_file(TinkerScene *scene, const char *path, TinkerWriteUnits units, GError **error);

#endif
