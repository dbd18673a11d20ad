/* Why an id is missing: it is misspelt, its library was refused, or there is nothing at all. */
#ifndef TINKER_PLUGIN_EXPLAIN_PRIVATE_H
#define TINKER_PLUGIN_EXPLAIN_PRIVATE_H

#include <glib.h>

/* What refusals have to do with a missing id, as tinker_catalogue_explain_refused; `libraries` is of
 * TinkerLibraryEntry. `sure`: a refused library has it by its manifest or file name. (transfer full) */
char *tinker_explain_refused(const GPtrArray *libraries, const char *id, gboolean *sure);

/* What comes behind "no plugin provides ...": the reason, or the nearest of the ids that are the keys of `provided`.
 * (transfer full) */
char *tinker_explain_missing(const GPtrArray *libraries, GHashTable *provided, const char *id);

#endif
