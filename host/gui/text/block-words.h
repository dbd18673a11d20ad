/* A block in words: for the outline, and for those who hear the scene instead of seeing it. No widget. */
#ifndef TINKER_GUI_BLOCK_WORDS_H
#define TINKER_GUI_BLOCK_WORDS_H

#include "scene/store/scene.h"

/* The title of its type, "Mass"; of a type that nobody provides, its id. Borrowed. */
const char *tinker_block_type_title(const TinkerScene *scene, TinkerBlockId block);

/* All of it: "Mass 0, Mass, at (0.00000 m, 2.00000 m)". (transfer full) */
char *tinker_block_words(TinkerScene *scene, TinkerBlockId block);

/* Whether a vector's own title has to come before the label of a component: "Centre X". It need not where the label or
 * the heading has it already. */
gboolean tinker_component_needs_title(const TinkerPropertyType *type, int32_t component);

/* A property where its heading is not beside it, in the words of its row: "Mass", "Centre X"; with the heading where
 * that stands for the title, "Global Position X", "Initial Velocity Vx". (transfer full) */
char *tinker_property_words(const TinkerPropertyType *type, int32_t component);

#endif
