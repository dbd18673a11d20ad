/* What nearly every file includes, compiled once for each library (-Db_pch): half of the time of a small file is its
 * headers. Each file still includes what it uses. */
#include <glib.h>
