/* Messages about a block, with the place of the block in the scene's file. */
#ifndef TINKER_CLI_BLOCK_PLACES_H
#define TINKER_CLI_BLOCK_PLACES_H

#include "scene/read/scene-json.h"

/* "FILE:LINE:COLUMN: MESSAGE" where the message begins with the name of a block, "Rod 0: ..."; else, and where the file
 * cannot be read once more (standard input), "FILE: MESSAGE". `path` is the file's, `name` what messages call it,
 * `places` is kept for the next message: NULL at first, and the caller's to unref. (transfer full) */
char *tinker_placed_message(TinkerScene *scene, const char *path, const char *name, GArray **places,
                            const char *message);

#endif
