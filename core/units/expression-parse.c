/* From text to a program: a recursive descent over
 *     comparison = sum [ ("<" | "<=" | ">" | ">=" | "==" | "!=") sum ]
 *     sum        = product { ("+" | "-") product }
 *     product    = unary { ("*" | "/") unary }
 *     unary      = ("+" | "-") unary | power
 *     power      = primary [ "^" unary ]
 *     primary    = number | "t" | "pi" | function "(" comparison { "," comparison } ")" | "(" comparison ")"
 * Depth and length are limited, so no text can exhaust the stack or the memory. */
#include <math.h>
#include <string.h>

#include "units/expression-private.h"
#include "units/units.h"

#define PI                 3.14159265358979323846
#define LONGEST_TEXT       65536 /* bytes */
#define MOST_INSTRUCTIONS  32768
#define SHIFT_INSTRUCTIONS 3   /* of a shifted time, so that what was read once can be shifted */
#define DEEPEST            200 /* levels of brackets, signs and powers */
#define LONGEST_NAME       32

typedef struct {
    const char *text;
    const char *at;
    TinkerBuilder builder;
    int time; /* the instruction that `t` means where time is shifted; -1 where it is not */
    int depth;
    GError **error;
} Parser;

static int parse_comparison(Parser *parser);
static int parse_unary(Parser *parser);

/* Every parse function answers the instruction that holds the value, or FAILED with the error set. */
#define FAILED (-1)

static glong column_of(const Parser *parser, const char *place)
{
    return g_utf8_pointer_to_offset(parser->text, place) + 1;
}

G_GNUC_PRINTF(4, 5)
static int fail(Parser *parser, TinkerWaveformError code, const char *place, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_set_error(parser->error, TINKER_WAVEFORM_ERROR, code, "column %ld: %s", column_of(parser, place), message);
    return FAILED;
}

static void skip_blanks(Parser *parser)
{
    while (*parser->at == ' ' || *parser->at == '\t' || *parser->at == '\n' || *parser->at == '\r')
        parser->at++;
}

static gboolean accept(Parser *parser, const char *sign)
{
    skip_blanks(parser);
    if (!g_str_has_prefix(parser->at, sign)) return FALSE;
    parser->at += strlen(sign);
    return TRUE;
}

static gsize name_length(const char *at)
{
    gsize length = 0;
    while (g_ascii_isalnum(at[length]) || at[length] == '_')
        length++;
    return length;
}

/* What stands at `at`, quoted for a message: a name, a number, a character, or "the end". (transfer full) */
static char *quote(const char *at)
{
    if (*at == '\0') return g_strdup("the end");
    gsize length = name_length(at);
    if (length == 0) length = (gsize)(g_utf8_next_char(at) - at);
    return g_strdup_printf("\"%.*s%s\"", (int)MIN(length, LONGEST_NAME), at, length > LONGEST_NAME ? "..." : "");
}

/* Something stands where none of the grammar's signs can: says what was probably meant. */
static int fail_unexpected(Parser *parser, const char *expected)
{
    static const struct {
        const char *written, *meant;
    } signs[] = {{"−", "-"},  {"–", "-"},  {"×", "*"},  {"·", "*"},         {"÷", "/"},         {"≤", "<="},
                 {"≥", ">="}, {"≠", "!="}, {"=", "=="}, {"%", "mod(a, b)"}, {"&", "a product"}, {"|", "max(a, b)"}};
    skip_blanks(parser);
    g_autofree char *found = quote(parser->at);
    for (gsize i = 0; i < G_N_ELEMENTS(signs); i++)
        if (g_str_has_prefix(parser->at, signs[i].written))
            return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, "%s is not known; did you mean %s?", found,
                        signs[i].meant);
    return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, "%s is expected, not %s", expected, found);
}

static gboolean enter(Parser *parser)
{
    if (++parser->depth > DEEPEST) {
        fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, "nested more than %d levels deep", DEEPEST);
        return FALSE;
    }
    if (parser->builder.program->code->len > MOST_INSTRUCTIONS + (parser->time >= 0 ? SHIFT_INSTRUCTIONS : 0)) {
        fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, "the expression is too long");
        return FALSE;
    }
    return TRUE;
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
        return fail_unexpected(parser, "a number such as 1.5");
    }
    if (!isfinite(number))
        return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start, "the number is larger than 1.8e308");
    parser->at = end;
    return tinker_build(&parser->builder, TINKER_OP_CONSTANT, -1, -1, -1, number);
}

static int fail_name(Parser *parser, const char *start, const char *name)
{
    g_autoptr(GPtrArray) candidates = g_ptr_array_new();
    g_autoptr(GString) all = g_string_new("t, pi");
    g_ptr_array_add(candidates, (gpointer) "t");
    g_ptr_array_add(candidates, (gpointer) "pi");
    for (const TinkerFunction *function = tinker_functions; function->name != NULL; function++) {
        g_ptr_array_add(candidates, (gpointer)function->name);
        g_string_append_printf(all, ", %s", function->name);
    }
    g_ptr_array_add(candidates, NULL);
    g_autofree char *quoted = quote(start);
    const char *nearest = tinker_nearest_word(name, (const char *const *)candidates->pdata);
    if (nearest != NULL)
        return fail(parser, TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, start, "unknown name %s; did you mean \"%s\"?", quoted,
                    nearest);
    return fail(parser, TINKER_WAVEFORM_ERROR_UNKNOWN_NAME, start, "unknown name %s; known are %s", quoted, all->str);
}

static int parse_branch(Parser *parser, int truth, gboolean taken)
{
    const int outer = parser->builder.guard;
    parser->builder.guard = tinker_program_add_guard(parser->builder.program, (TinkerGuard){truth, outer, taken});
    const int value = parse_comparison(parser);
    parser->builder.guard = outer;
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
            fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start, "%s takes %d argument%s: %s", function->name,
                 function->arguments, function->arguments > 1 ? "s" : "", function->form);
            return FALSE;
        }
        const int value =
            conditional && count > 0 ? parse_branch(parser, arguments[0], count == 1) : parse_comparison(parser);
        if (value == FAILED) return FALSE;
        arguments[count] =
            conditional && count == 0 ? tinker_build(&parser->builder, TINKER_OP_TRUTH, value, -1, -1, 0) : value;
        count++;
    } while (accept(parser, ","));
    if (count < function->arguments && (skip_blanks(parser), *parser->at == ')')) {
        fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, "%s takes %d arguments: %s", function->name,
             function->arguments, function->form);
        return FALSE;
    }
    if (accept(parser, ")")) return TRUE;
    fail_unexpected(parser, "an operator, \",\" or \")\"");
    return FALSE;
}

static int parse_call(Parser *parser, const TinkerFunction *function, const char *start)
{
    int arguments[TINKER_MOST_ARGUMENTS];
    if (!accept(parser, "("))
        return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, start, "%s is a function, write %s", function->name,
                    function->form);
    if (!parse_arguments(parser, function, arguments)) return FAILED;
    return tinker_build_function(&parser->builder, function, arguments);
}

static int parse_name(Parser *parser)
{
    const char *start = parser->at;
    const gsize length = name_length(start);
    g_autofree char *name = g_strndup(start, length);
    parser->at += length;
    if (strcmp(name, "t") == 0 && parser->time >= 0) return parser->time;
    if (strcmp(name, "t") == 0) return tinker_build(&parser->builder, TINKER_OP_TIME, -1, -1, -1, 0);
    if (strcmp(name, "pi") == 0) return tinker_build(&parser->builder, TINKER_OP_CONSTANT, -1, -1, -1, PI);
    const TinkerFunction *function = tinker_function_lookup(name);
    return function != NULL ? parse_call(parser, function, start) : fail_name(parser, start, name);
}

static int parse_primary(Parser *parser)
{
    skip_blanks(parser);
    if (g_ascii_isdigit(*parser->at) || *parser->at == '.') return parse_number(parser);
    if (g_ascii_isalpha(*parser->at) || *parser->at == '_') return parse_name(parser);
    if (!accept(parser, "(")) return fail_unexpected(parser, "a number, t, a function or \"(\"");
    const int value = parse_comparison(parser);
    if (value == FAILED || accept(parser, ")")) return value;
    return fail_unexpected(parser, "an operator or \")\"");
}

static int parse_power(Parser *parser)
{
    const int base = parse_primary(parser);
    if (base == FAILED || !accept(parser, "^")) return base;
    const int exponent = parse_unary(parser);
    return exponent == FAILED ? FAILED : tinker_build(&parser->builder, TINKER_OP_POWER, base, exponent, -1, 0);
}

static int parse_unary(Parser *parser)
{
    if (!enter(parser)) return FAILED;
    int value;
    if (accept(parser, "-")) {
        value = parse_unary(parser);
        if (value != FAILED) value = tinker_build(&parser->builder, TINKER_OP_NEGATE, value, -1, -1, 0);
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
        value = tinker_build(&parser->builder, operation, value, factor, -1, 0);
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
        value = tinker_build(&parser->builder, operation, value, term, -1, 0);
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
        return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, behind,
                    "comparisons do not chain; did you mean a product, (a < b)*(b < c)?");
    return tinker_build_comparison(&parser->builder, (TinkerComparison)sign, a, b);
}

/* Something is left behind a whole expression. */
static int fail_behind(Parser *parser)
{
    if (*parser->at == ',')
        return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at,
                    "a comma stands between the arguments of a function only; decimals have a point, as in 3.5");
    if (*parser->at == ')') return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at, "\")\" closes no bracket");
    if (*parser->at == '(' || g_ascii_isalnum(*parser->at)) {
        g_autofree char *found = quote(parser->at);
        return fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, parser->at,
                    "an operator is expected before %s; did you mean a product, *?", found);
    }
    return fail_unexpected(parser, "an operator or the end");
}

/* t + shift, once for all places that name t. */
static void build_shifted_time(Parser *parser, double shift)
{
    const int time = tinker_build(&parser->builder, TINKER_OP_TIME, -1, -1, -1, 0);
    const int offset = tinker_build(&parser->builder, TINKER_OP_CONSTANT, -1, -1, -1, shift);
    parser->time = tinker_build(&parser->builder, TINKER_OP_ADD, time, offset, -1, 0);
}

static gboolean check_text(Parser *parser)
{
    const char *end;
    if (strlen(parser->text) > LONGEST_TEXT) {
        g_set_error(parser->error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_SYNTAX,
                    "column 1: the expression is longer than %d bytes", LONGEST_TEXT);
        return FALSE;
    }
    if (g_utf8_validate(parser->text, -1, &end)) return TRUE;
    fail(parser, TINKER_WAVEFORM_ERROR_SYNTAX, end, "the text is not UTF-8 here");
    return FALSE;
}

TinkerProgram *tinker_program_parse(const char *text, double shift, GError **error)
{
    g_autoptr(TinkerProgram) program = tinker_program_new();
    Parser parser = {.text = text, .at = text, .builder = {program, -1}, .time = -1, .error = error};
    if (!check_text(&parser)) return NULL;
    if (shift != 0) build_shifted_time(&parser, shift);
    const int value = parse_comparison(&parser);
    if (value == FAILED) return NULL;
    skip_blanks(&parser);
    if (*parser.at != '\0') {
        fail_behind(&parser);
        return NULL;
    }
    tinker_program_finish(program, value);
    return g_steal_pointer(&program);
}
