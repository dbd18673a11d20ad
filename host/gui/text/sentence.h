/* Messages of the core as sentences. They begin with a small letter and have no full stop, as on the command line. */
#ifndef TINKER_GUI_SENTENCE_H
#define TINKER_GUI_SENTENCE_H

#include "scene/store/scene.h"

/* With a capital and a full stop, where there is neither yet. (transfer full) */
char *tinker_sentence(const char *message);

/* Translates a message, but the name of a block of the scene stays as it is where the message begins with it. (transfer
 * full) */
char *tinker_sentence_in(TinkerScene *scene, const char *message);

/* A message of a typed text without the column that it begins with, "column 3: ..."; the column, from 1, or 0 where it
 * has none, goes to `column` (may be NULL). A part of the message. */
const char *tinker_without_column(const char *message, int *column);

/* Puts the titles of a block's properties in the place of their ids, word by word: "dynamic_friction is above ..." is
 * “Dynamic coefficient” there. The class may be NULL. (transfer full) */
char *tinker_with_titles(const char *message, const TinkerBlockClass *block_class);

#endif
