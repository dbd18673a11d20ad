/* How a rule says what it found. */
#include <stdio.h>
#include <string.h>

#include "conformance/probe/kit.h"

__attribute__((format(printf, 3, 0))) static void decide(KitCheck *check, TinkerConformanceOutcome outcome,
                                                         const char *format, va_list arguments)
{
    KitSheet *sheet = check->sheet;
    if (sheet->decided) return;
    vsnprintf(sheet->text, sizeof sheet->text, format, arguments);
    sheet->outcome = (int32_t)outcome;
    sheet->decided = 1;
}

void kit_fail(KitCheck *check, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    decide(check, TINKER_CONFORMANCE_FAILED, format, arguments);
    va_end(arguments);
}

void kit_skip(KitCheck *check, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    decide(check, TINKER_CONFORMANCE_SKIPPED, format, arguments);
    va_end(arguments);
}

void kit_tell(KitCheck *check, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    decide(check, TINKER_CONFORMANCE_PASSED, format, arguments);
    va_end(arguments);
}

gboolean kit_decided(const KitCheck *check)
{
    return check->sheet->decided != 0;
}

void kit_phase(KitCheck *check, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(check->sheet->phase, sizeof check->sheet->phase, format, arguments);
    va_end(arguments);
}
