/* A hash of texts that come from files. */
#ifndef TINKER_CORE_TEXT_HASH_H
#define TINKER_CORE_TEXT_HASH_H

#include <glib.h>

/* Seeded anew in every process, so that no file can be made whose names all fall on one place; for g_hash_table_new. */
guint tinker_text_hash(gconstpointer text);

#endif
