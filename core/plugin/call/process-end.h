/* Ends of the process that are no signal. */
#ifndef TINKER_PLUGIN_PROCESS_END_H
#define TINKER_PLUGIN_PROCESS_END_H

#include <glib.h>

/* The status of a program that ends because the system does not give what it needs: a file, memory. */
#define TINKER_STATUS_FILE 5

/* Says what the plugin at work did, or where none is `otherwise`, writes out the record, and ends the process with that
 * status. */
G_NORETURN void tinker_crash_end_with(int status, const char *what, const char *otherwise);

#endif
