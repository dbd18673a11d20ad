/* The one way in which the programs write text for people: with control characters escaped
 * (units/quantity/plain-text.h), whatever file, plugin or argument it comes from. */
#ifndef TINKER_HOST_PRINT_H
#define TINKER_HOST_PRINT_H

#include <glib.h>
#include <stdio.h>

/* One line; a line feed in it is escaped, too, and one is added behind it. */
void tinker_print_line(FILE *file, const char *format, ...) G_GNUC_PRINTF(2, 3);

/* A text of several lines, as it is or as JSON; a line feed is added behind it. */
void tinker_print_text(FILE *file, const char *text);

#endif
