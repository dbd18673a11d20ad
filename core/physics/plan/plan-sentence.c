/* How a plan's sentences are put together. */
#include "physics/plan/plan-words-private.h"

#include <stdarg.h>

void plan_say(GPtrArray *sentences, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(sentences, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

const char *plan_counted(char buffer[128], const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_vsnprintf(buffer, 128, format, arguments);
    va_end(arguments);
    return buffer;
}
