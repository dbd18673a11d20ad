/* Escaped as a whole, so that nobody has to know which part of a line came from outside. */
#include "common/program/print.h"

#include <stdarg.h>

#include "units/quantity/plain-text.h"

void tinker_print_line(FILE *file, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *line = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_autofree char *escaped = tinker_text_escaped(line, FALSE);
    fprintf(file, "%s\n", escaped);
}

void tinker_print_text(FILE *file, const char *text)
{
    g_autofree char *escaped = tinker_text_escaped(text, TRUE);
    fprintf(file, "%s\n", escaped);
}
