/* Writing rows into a file that grows, which ends with a whole row whatever happens. */
#ifndef TINKER_CORE_WRITE_LINES_H
#define TINKER_CORE_WRITE_LINES_H

#include <glib.h>

/* Writes `size` bytes of whole lines where the file's descriptor stands. FALSE with errno where the file does not take
 * all of them, as on a full disk: then what follows the last whole line is taken out of it again. Pipes and devices
 * keep it. Calls async-signal-safe functions alone. */
gboolean tinker_write_lines(int file, const char *text, gsize size);

#endif
