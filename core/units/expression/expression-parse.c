/* Reading an expression's text: a recursive descent over
 *     comparison = sum [ ("<" | "<=" | ">" | ">=" | "==" | "!=") sum ]
 *     sum        = product { ("+" | "-") product }
 *     product    = unary { ("*" | "/") unary }
 *     unary      = ("+" | "-") unary | power
 *     power      = primary [ "^" unary ]
 *     primary    = number | name | "{" quantity "}" | "t" | "pi" | "(" comparison ")"
 *                | function "(" comparison { "," comparison } ")"
 *
 * What is made of it, instructions or a tree, is the reader's affair. Depth and length are limited, so no text can
 * exhaust the stack or the memory. */
#include "units/expression/expression-parse-private.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define PI           3.14159265358979323846
#define LONGEST_TEXT 65536 /* bytes */
#define DEEPEST      200   /* levels of brackets, signs and powers */

static int parse_comparison(Parser *parser);
static int parse_unary(Parser *parser);

/* Every parse function answers the reader's handle of the value, or FAILED with the error set. */
#define FAILED TINKER_READER_FAILED

static gboolean accept(Parser *parser, const char *sign)
{
    parser_skip_blanks(parser);
    if (!g_str_has_prefix(parser->at, sign)) return FALSE;
    parser->at += strlen(sign);
    return TRUE;
}

static gboolean enter(Parser *parser)
{
    if (++parser->depth > DEEPEST) {
        parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, _("nested more than %d levels deep"), DEEPEST);
        return FALSE;
    }
    if (parser->reader->has_room(parser->into)) return TRUE;
    parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, _("the expression is too long"));
    return FALSE;
}

static int parse_number(Parser *parser)
{
    const char *start = parser->at;
    const char *end = start;
    while (g_ascii_isdigit(*end) || *end == '.')
        end++;
    if ((*end == 'e' || *end == 'E') && strspn(end + 1, "+-") <= 1 && g_ascii_isdigit(end[1 + strspn(end + 1, "+-")]))
        end += 1 + strspn(end + 1, "+-");
    while (g_ascii_isdigit(*end))
        end++;
    char *read;
    g_autofree char *digits = g_strndup(start, (gsize)(end - start));
    const double number = g_ascii_strtod(digits, &read);
    if (*read != '\0' || strcmp(digits, ".") == 0) {
        parser->at = start + (read - digits);
        return parser_fail_unexpected(parser, _("a number such as 1.5"));
    }
    if (!isfinite(number))
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start, _("the number is larger than 1.8e308"));
    parser->at = end;
    return parser->reader->number(parser->into, number);
}

static int parse_branch(Parser *parser, int truth, gboolean taken)
{
    parser->reader->enter_branch(parser->into, truth, taken);
    const int value = parse_comparison(parser);
    parser->reader->leave_branch(parser->into);
    return value;
}

/* The arguments behind the opening bracket. Those of an `if` stand under guards: what switches in the branch that is
 * not taken is no break. */
static gboolean parse_arguments(Parser *parser, const TinkerFunction *function, int arguments[TINKER_MOST_ARGUMENTS])
{
    const gboolean conditional = strcmp(function->name, "if") == 0;
    int count = 0;
    do {
        const char *start = parser->at;
        if (count == function->arguments) {
            parser_fail_arguments(parser, function, start);
            return FALSE;
        }
        const int value =
            conditional && count > 0 ? parse_branch(parser, arguments[0], count == 1) : parse_comparison(parser);
        if (value == FAILED) return FALSE;
        arguments[count] = conditional && count == 0 ? parser->reader->condition(parser->into, value) : value;
        count++;
    } while (accept(parser, ","));
    if (count < function->arguments && (parser_skip_blanks(parser), *parser->at == ')')) {
        parser_fail_arguments(parser, function, parser->at);
        return FALSE;
    }
    if (accept(parser, ")")) return TRUE;
    parser_fail_unexpected(parser, _("an operator, \",\" or \")\""));
    return FALSE;
}

static int parse_call(Parser *parser, const TinkerFunction *function, const char *start)
{
    int arguments[TINKER_MOST_ARGUMENTS];
    if (!accept(parser, "("))
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start, _("%s is a function, write %s"), function->name,
                           function->form);
    if (!parse_arguments(parser, function, arguments)) return FAILED;
    return parser->reader->function(parser->into, function, arguments);
}

static int parse_name(Parser *parser)
{
    const char *start = parser->at;
    const gsize length = parser_name_length(start);
    g_autofree char *name = g_strndup(start, length);
    parser->at += length;
    if (parser->names != NULL && g_strv_contains(parser->names, name)) return parser->reader->name(parser->into, name);
    if (strcmp(name, "t") == 0) return parser->reader->time(parser->into);
    if (strcmp(name, "pi") == 0) return parser->reader->number(parser->into, PI);
    const TinkerFunction *function = tinker_function_lookup(name);
    return function != NULL ? parse_call(parser, function, start) : parser_fail_name(parser, start, name);
}

/* What stands in braces is a name, whatever it is made of. */
static int parse_reference(Parser *parser)
{
    const char *start = parser->at, *end = strchr(start, '}');
    g_autofree char *why = NULL;
    if (parser->refer == NULL)
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start,
                           _("quantities in braces are not known here, only t"));
    if (end == NULL)
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start, _("\"{\" is not closed (as in {Mass 0.x})"));
    g_autofree char *symbol = g_strndup(start, (gsize)(end + 1 - start));
    if (!parser->refer(symbol, parser->data, &why))
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, start, "%s: %s", symbol, why);
    parser->at = end + 1;
    return parser->reader->name(parser->into, symbol);
}

static int parse_primary(Parser *parser)
{
    parser_skip_blanks(parser);
    if (*parser->at == '{') return parse_reference(parser);
    if (g_ascii_isdigit(*parser->at) || *parser->at == '.') return parse_number(parser);
    if (g_ascii_isalpha(*parser->at) || *parser->at == '_' || parser_name_length(parser->at) > 0)
        return parse_name(parser);
    if (!accept(parser, "(")) return parser_fail_unexpected(parser, _("a number, t, a function or \"(\""));
    const int value = parse_comparison(parser);
    if (value == FAILED || accept(parser, ")")) return value;
    return parser_fail_unexpected(parser, _("an operator or \")\""));
}

static int parse_power(Parser *parser)
{
    const int base = parse_primary(parser);
    if (base == FAILED || !accept(parser, "^")) return base;
    const int exponent = parse_unary(parser);
    return exponent == FAILED ? FAILED : parser->reader->operation(parser->into, TINKER_OP_POWER, base, exponent);
}

static int parse_unary(Parser *parser)
{
    if (!enter(parser)) return FAILED;
    int value;
    if (accept(parser, "-")) {
        value = parse_unary(parser);
        if (value != FAILED) value = parser->reader->operation(parser->into, TINKER_OP_NEGATE, value, -1);
    } else {
        value = accept(parser, "+") ? parse_unary(parser) : parse_power(parser);
    }
    parser->depth--;
    return value;
}

static int parse_product(Parser *parser)
{
    int value = parse_unary(parser);
    while (value != FAILED) {
        const gboolean product = accept(parser, "*");
        if (!product && !accept(parser, "/")) return value;
        const int factor = parse_unary(parser);
        if (factor == FAILED) return FAILED;
        const TinkerOperation operation = product ? TINKER_OP_MULTIPLY : TINKER_OP_DIVIDE;
        value = parser->reader->operation(parser->into, operation, value, factor);
    }
    return FAILED;
}

static int parse_sum(Parser *parser)
{
    int value = parse_product(parser);
    while (value != FAILED) {
        const gboolean sum = accept(parser, "+");
        if (!sum && !accept(parser, "-")) return value;
        const int term = parse_product(parser);
        if (term == FAILED) return FAILED;
        const TinkerOperation operation = sum ? TINKER_OP_ADD : TINKER_OP_SUBTRACT;
        value = parser->reader->operation(parser->into, operation, value, term);
    }
    return FAILED;
}

/* Which TinkerComparison stands here; -1 for none. */
static int accept_comparison(Parser *parser)
{
    static const char *const signs[] = {"<=", ">=", "==", "!=", "<", ">"};
    for (int i = 0; i < (int)G_N_ELEMENTS(signs); i++)
        if (accept(parser, signs[i])) return i;
    return -1;
}

static int parse_comparison(Parser *parser)
{
    const int a = parse_sum(parser);
    if (a == FAILED) return FAILED;
    const int sign = accept_comparison(parser);
    if (sign < 0) return a;
    const int b = parse_sum(parser);
    if (b == FAILED) return FAILED;
    const char *behind = parser->at;
    if (accept_comparison(parser) >= 0)
        return parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, behind,
                           _("comparisons do not chain; did you mean a product, (a < b)*(b < c)?"));
    return parser->reader->comparison(parser->into, (TinkerComparison)sign, a, b);
}

static gboolean check_text(Parser *parser)
{
    const char *end;
    if (strlen(parser->text) > LONGEST_TEXT) {
        parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->text, _("the expression is longer than %d bytes"),
                    LONGEST_TEXT);
        return FALSE;
    }
    if (g_utf8_validate(parser->text, -1, &end)) return TRUE;
    parser_fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, end, _("the text is not UTF-8 here"));
    return FALSE;
}

int tinker_expression_read(const char *text, const TinkerReadable *names, const TinkerReader *reader, void *into,
                           GError **error)
{
    Parser parser = {.text = text, .at = text, .reader = reader, .into = into, .error = error};
    if (names != NULL) {
        parser.names = names->names;
        parser.refer = names->refer;
        parser.data = names->data;
    }
    if (!check_text(&parser)) return FAILED;
    const int value = parse_comparison(&parser);
    if (value == FAILED) return FAILED;
    parser_skip_blanks(&parser);
    return *parser.at == '\0' ? value : parser_fail_behind(&parser);
}

const char *tinker_expression_find_equals(const char *text)
{
    gboolean braced = FALSE;
    for (const char *at = text; *at != '\0'; at++) {
        if (*at == '{' || *at == '}') braced = *at == '{';
        if (braced || *at != '=') continue;
        if (at[1] == '=' || (at > text && strchr("=<>!", at[-1]) != NULL)) continue;
        return at;
    }
    return NULL;
}
