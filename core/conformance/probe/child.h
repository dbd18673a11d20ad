/* A piece of work in a process of its own: what becomes of it is known whatever the library does. */
#ifndef TINKER_CONFORMANCE_CHILD_H
#define TINKER_CONFORMANCE_CHILD_H

#include "conformance/probe/kit.h"

/* Memory that a child shares with its parent; TINKER_PLUGIN_ERROR_FILE where there is none. (transfer full) */
KitSheet *kit_sheet_new(GError **error);
void kit_sheet_free(KitSheet *sheet);

/* Calls `work` in a child and waits, at most `seconds` of processor time, or some times as long where it does nothing.
 * The child's outputs are thrown away but for what it says last where it crashes. Afterwards `sheet` is decided: where
 * the child did not come back, as failed, with what became of it. FALSE where there was no process to be had:
 * TINKER_PLUGIN_ERROR_FILE. */
gboolean kit_child_run(KitSheet *sheet, double seconds, void (*work)(gpointer data), gpointer data, GError **error);

#endif
