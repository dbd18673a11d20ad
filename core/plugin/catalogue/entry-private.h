/* What is known of a library at one time. An entry is filled in by whoever makes it and never changed once others can
 * see it: news of a library is another entry. It goes when nobody holds it. */
#ifndef TINKER_PLUGIN_ENTRY_PRIVATE_H
#define TINKER_PLUGIN_ENTRY_PRIVATE_H

#include "plugin/catalogue/catalogue.h"
#include "plugin/catalogue/manifest-private.h"

/* Of a library about which nothing is known yet. (transfer full) */
TinkerLibraryEntry *tinker_library_entry_new(const char *path, const char *folder_kind);

/* Another holder of the same entry, in any thread. (transfer full) */
TinkerLibraryEntry *tinker_library_entry_ref(TinkerLibraryEntry *entry);
void tinker_library_entry_unref(TinkerLibraryEntry *entry);

/* An array that holds entries. (transfer full) */
GPtrArray *tinker_library_entries_new(void);

/* An entry for the library of another, with nothing known of it but where it was found. (transfer full) */
TinkerLibraryEntry *tinker_library_entry_anew(const TinkerLibraryEntry *entry);

/* An entry for the library of another, with all that is known of it, and refused for this reason. (transfer full) */
TinkerLibraryEntry *tinker_library_entry_refused(const TinkerLibraryEntry *entry, const char *reason);

/* While it is being filled in: takes over what a manifest says, which keeps its texts no longer. */
void tinker_library_entry_take(TinkerLibraryEntry *entry, TinkerManifest *manifest);

/* Whether a refused library's manifest or file name says that it has the type or integrator. */
gboolean tinker_library_entry_suggests(const TinkerLibraryEntry *entry, const char *id);

#endif
