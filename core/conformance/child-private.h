/* A piece of work in a process of its own: what becomes of it is known whatever the library does. */
#ifndef TINKER_CONFORMANCE_CHILD_PRIVATE_H
#define TINKER_CONFORMANCE_CHILD_PRIVATE_H

#include "conformance/kit-private.h"

/* Memory that a child shares with its parent. (transfer full) */
KitSheet *kit_sheet_new(void);
void kit_sheet_free(KitSheet *sheet);

/* Calls `work` in a child and waits, at most `seconds`. The child's outputs are thrown away but for what it says last where
 * it crashes. Afterwards `sheet` is decided: where the child did not come back, as failed, with what became of it. */
void kit_child_run(KitSheet *sheet, double seconds, void (*work)(gpointer data), gpointer data);

#endif
