/* Telling two tables of the net apart. */
#ifndef NET_COMPARE_H
#define NET_COMPARE_H

#include <glib.h>

/* Prints a line for each run that differs, then how many do and in what. With a folder where both have put what they
 * hashed (NULL: none), says by how much. Answers whether all are the same. */
gboolean net_compare(const GPtrArray *old, const GPtrArray *new, const char *store);

#endif
