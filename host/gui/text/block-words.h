/* A block in words: for the outline, and for those who hear the scene instead of seeing it. No widget. */
#ifndef TINKER_GUI_BLOCK_WORDS_H
#define TINKER_GUI_BLOCK_WORDS_H

#include "scene/store/scene.h"

/* The title of its type, "Mass"; of a type that nobody provides, its id. Borrowed. */
const char *tinker_block_type_title(const TinkerScene *scene, TinkerBlockId block);

/* All of it: "Mass 0, Mass, at (0.00000 m, 2.00000 m)". (transfer full) */
char *tinker_block_words(TinkerScene *scene, TinkerBlockId block);

#endif
