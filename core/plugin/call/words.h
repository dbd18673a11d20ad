/* What a plugin says in words while it is at work: why it failed. */
#ifndef TINKER_CORE_WORDS_H
#define TINKER_CORE_WORDS_H

#include "plugin/descriptor/block-class.h"

/* A text that a plugin answered, as one line of valid UTF-8: line ends and other control characters become blanks,
 * bytes that are no text become U+FFFD, and what is longer than 1000 bytes is cut off. The text is read while the note
 * of a call stands (call.h), so that an address that leads nowhere is blamed on the plugin. One of block_class and
 * method is NULL. NULL where there is no text, or an empty one. (transfer full) */
char *tinker_plugin_words(const TinkerBlockClass *block_class, const TinkerIntegrator *method, const char *text);

#endif
