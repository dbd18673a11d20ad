/* Searching texts for words as people type them: by their beginnings, and whatever their endings. No widget. */
#ifndef TINKER_GUI_WORD_SEARCH_H
#define TINKER_GUI_WORD_SEARCH_H

#include <glib.h>

/* The words of a text in the form that they are compared in, without case and accents. (transfer full) */
GStrv tinker_search_words(const char *text);

/* The stems of what is typed, one a word: "springs" and "oscillations" are "spring" and "oscill". Endings of English
 * and German alike. (transfer full) */
GStrv tinker_search_stems(const char *typed);

/* Whether each stem begins one of the words, or, as words are put together, is a part of one if it is long enough. */
gboolean tinker_search_finds(char **words, char **stems);

#endif
