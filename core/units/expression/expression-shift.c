/* The text of an expression whose time is shifted, for files: what is run is compiled with the shift, see
 * tinker_program_parse, and reads as this text does. */
#include <string.h>

#include "units/expression/expression-tree.h"
#include "units/quantity/units.h"

/* How long a name or a number is; the e of 1e5 is no name. */
static gsize word_length(const char *at)
{
    gsize length = 0;
    while (g_ascii_isalnum(at[length]) || at[length] == '_' || at[length] == '.')
        length++;
    return length;
}

char *tinker_expression_shift_text(const char *text, double shift)
{
    char number[64];
    tinker_number_to_text(shift < 0 ? -shift : shift, number, sizeof number);
    GString *shifted = g_string_new(NULL);
    for (const char *at = text; *at != '\0';) {
        const gsize length = word_length(at);
        if (length == 1 && *at == 't')
            g_string_append_printf(shifted, "(t %c %s)", shift < 0 ? '-' : '+', number);
        else
            g_string_append_len(shifted, at, (gssize)MAX(length, 1));
        at += MAX(length, 1);
    }
    return g_string_free(shifted, FALSE);
}
