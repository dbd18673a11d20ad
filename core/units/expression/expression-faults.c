/* What is wrong with the text of an expression, and what was probably meant. */
#include "units/expression/expression-parse-private.h"

#include <glib/gi18n-lib.h>
#include <string.h>

#include "units/quantity/units.h"

#define FAILED       TINKER_READER_FAILED
#define LONGEST_NAME 32

static glong column_of(const Parser *parser, const char *place)
{
    return g_utf8_pointer_to_offset(parser->text, place) + 1;
}

int parser_fail(Parser *parser, TinkerWaveformError code, const char *place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_set_error(parser->error, TINKER_WAVEFORM_ERROR, code, "column %ld: %s", column_of(parser, place), message);
    return FAILED;
}

static gboolean is_of_name(gunichar c)
{
    return c == '_' || (c < 128 ? g_ascii_isalnum((char)c) : g_unichar_isalpha(c));
}

gsize parser_name_length(const char *at)
{
    const char *end = at;
    while (is_of_name(g_utf8_get_char(end)))
        end = g_utf8_next_char(end);
    return (gsize)(end - at);
}

/* What stands at `at`, quoted for a message: a name, a number, a character, or "the end". (transfer full) */
static char *quote(const char *at)
{
    if (*at == '\0') return g_strdup(_("the end"));
    gsize length = parser_name_length(at);
    if (length == 0) length = (gsize)(g_utf8_next_char(at) - at);
    return g_strdup_printf("\"%.*s%s\"", (int)MIN(length, LONGEST_NAME), at, length > LONGEST_NAME ? "..." : "");
}

/* Something stands where none of the grammar's signs can: says what was probably meant. */
int parser_fail_unexpected(Parser *parser, const char *expected)
{
    static const struct {
        const char *written, *meant;
    } signs[] = {{"−", "-"},
                 {"–", "-"},
                 {"×", "*"},
                 {"·", "*"},
                 {"÷", "/"},
                 {"≤", "<="},
                 {"≥", ">="},
                 {"≠", "!="},
                 {"=", "=="},
                 {"%", "mod(a, b)"},
                 {"&", N_("a product")},
                 {"|", "max(a, b)"}};
    parser_skip_blanks(parser);
    g_autofree char *found = quote(parser->at);
    for (gsize i = 0; i < G_N_ELEMENTS(signs); i++)
        if (g_str_has_prefix(parser->at, signs[i].written))
            return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, _("%s is not known; did you mean %s?"),
                               found, _(signs[i].meant));
    return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, _("%s is expected, not %s"), expected, found);
}

int parser_fail_name(Parser *parser, const char *start, const char *name)
{
    g_autoptr(GPtrArray) candidates = g_ptr_array_new();
    g_autoptr(GString) all = g_string_new("t, pi");
    g_ptr_array_add(candidates, (gpointer) "t");
    g_ptr_array_add(candidates, (gpointer) "pi");
    for (const char *const *each = parser->names; each != NULL && *each != NULL; each++) {
        g_ptr_array_add(candidates, (gpointer)*each);
        g_string_append_printf(all, ", %s", *each);
    }
    for (const TinkerFunction *function = tinker_functions; function->name != NULL; function++) {
        g_ptr_array_add(candidates, (gpointer)function->name);
        g_string_append_printf(all, ", %s", function->name);
    }
    g_ptr_array_add(candidates, NULL);
    g_autofree char *quoted = quote(start);
    const char *nearest = tinker_nearest_word(name, (const char *const *)candidates->pdata);
    if (nearest != NULL)
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, start,
                           _("unknown name %s; did you mean \"%s\"?"), quoted, nearest);
    if (parser->refer != NULL) /* where a quantity is what most often is meant */
        return parser_fail(
            parser, TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, start,
            _("unknown name %s (a quantity of a block stands in braces, as in {Mass 0.x}; without braces: %s)"), quoted,
            all->str);
    return parser_fail(parser, TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, start, _("unknown name %s; known are %s"), quoted,
                       all->str);
}

/* Something is left behind a whole expression. */
int parser_fail_behind(Parser *parser)
{
    if (*parser->at == ',')
        return parser_fail(
            parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at,
            _("a comma stands between the arguments of a function only; decimals have a point, as in 3.5"));
    if (*parser->at == ')')
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, _("\")\" closes no bracket"));
    if (*parser->at == '(' || g_ascii_isalnum(*parser->at)) {
        g_autofree char *found = quote(parser->at);
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at,
                           _("an operator is expected before %s; did you mean a product, *?"), found);
    }
    return parser_fail_unexpected(parser, _("an operator or the end"));
}

int parser_fail_arguments(Parser *parser, const TinkerFunction *function, const char *place)
{
    return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, place,
                       g_dngettext(GETTEXT_PACKAGE, "%s takes %d argument: %s", "%s takes %d arguments: %s",
                                   (gulong)function->arguments),
                       function->name, function->arguments, function->form);
}
