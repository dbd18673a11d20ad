/* Numbers are shown with a point in every locale, as in files and messages. What is typed may have the comma of the
 * locale; where that is no comma, none is read as a point: "1,000" is a thousand to some and one to others. */
#include "gui/text/number-text.h"

#include <glib/gi18n.h>
#include <langinfo.h>
#include <locale.h>
#include <math.h>
#include <string.h>

#include "law/value.h"
#include "units/expression/expression-tree.h"

#define DECIMALS  5
#define TOO_SMALL 1e-3  /* units: of less the decimals show fewer than three digits */
#define TOO_LONG  1e9   /* units: so much is wider than a field */
#define ROUNDING  1e-12 /* units: less is what rounding leaves of a place at 0 */
#define DIGITS    6     /* significant ones, of what has an exponent */
#define NOTHING   1e-30 /* in SI: less is what blows and rounding leave of a measured 0 */

/* Of the user's locale, which the program itself does not write numbers by. */
static gboolean locale_has_comma(void)
{
    static gsize known; /* 1: a point or what else there may be, 2: a comma */
    if (g_once_init_enter(&known)) {
        locale_t numeric = newlocale(LC_NUMERIC_MASK, "", (locale_t)0);
        gboolean comma = numeric != (locale_t)0 && strcmp(nl_langinfo_l(RADIXCHAR, numeric), ",") == 0;
        if (numeric != (locale_t)0) freelocale(numeric);
        g_once_init_leave(&known, comma ? 2 : 1);
    }
    return known == 2;
}

/* (transfer full) */
static char *with_point(const char *text)
{
    char *plain = g_strstrip(g_strdup(text)), *comma = strchr(plain, ',');
    gboolean is_decimal = comma != NULL && locale_has_comma() && strpbrk(comma + 1, ",.") == NULL &&
                          memchr(plain, '.', (gsize)(comma - plain)) == NULL;
    if (is_decimal) *comma = '.';
    return plain;
}

/* There is no time in a number. */
static double no_value(const char *symbol, void *data)
{
    return NAN;
}

static gboolean read_formula(const char *text, double *value, GError **error)
{
    static const char *const no_names[] = {NULL};
    g_autoptr(TinkerExpression) formula = tinker_expression_parse(text, no_names, error);
    if (formula == NULL) return FALSE;
    *value = tinker_expression_value(formula, no_value, NULL);
    if (isfinite(*value)) return TRUE;
    g_set_error(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_SYNTAX, _("“%s” is no number"), text);
    return FALSE;
}

/* "2*9.81" in the unit that is shown, "2*9.81 m/s^2" in the one behind it: the first space that has a formula before it
 * and a unit behind it is between the two. */
static gboolean read_quantity_formula(const char *text, TinkerDimension dimension, const char *unit, double *si,
                                      GError **error)
{
    TinkerUnit behind;
    if (read_formula(text, si, error)) {
        TinkerUnit shown = {1, {0, 0, 0, 0}};
        tinker_unit_parse(unit, &shown, NULL);
        *si *= shown.factor;
        return TRUE;
    }
    for (const char *space = strchr(text, ' '); space != NULL; space = strchr(space + 1, ' ')) {
        g_autofree char *formula = g_strndup(text, (gsize)(space - text));
        if (!tinker_unit_parse(space + 1, &behind, NULL) || !read_formula(formula, si, NULL)) continue;
        char number[G_ASCII_DTOSTR_BUF_SIZE];
        g_autofree char *worked_out = g_strconcat(g_ascii_dtostr(number, sizeof number, *si), space, NULL);
        g_clear_error(error);
        return tinker_quantity_parse(worked_out, dimension, si, error);
    }
    return FALSE;
}

/* Whether a term of a sum ends at this sign: what follows is another number, not a unit as in "N-m". */
static gboolean ends_term(const char *sign)
{
    if (*sign != '+' && *sign != '-') return FALSE;
    const char *next = sign + 1 + strspn(sign + 1, " ");
    return g_ascii_isdigit(*next) || *next == '.' || *next == '(';
}

/* Of a number or formula with its unit; bare ones are no terms beside those that have one: "6 m-3" might be meant for a
 * power. */
static gboolean read_term(const char *text, gsize length, TinkerDimension dimension, double *si)
{
    g_autofree char *term = g_strndup(text, length);
    g_strstrip(term);
    return !read_formula(term, si, NULL) &&
           (tinker_quantity_parse(term, dimension, si, NULL) || read_quantity_formula(term, dimension, "", si, NULL));
}

/* "6.13 m-3 m": each term with a unit of its own. */
static gboolean read_sum(const char *text, TinkerDimension dimension, double *si)
{
    const char *start = text;
    double sum = 0, sign = 1, term;
    for (const char *at = text; *at != '\0'; at++) {
        if (at == start || !ends_term(at) || !read_term(start, (gsize)(at - start), dimension, &term)) continue;
        sum += sign * term;
        sign = *at == '-' ? -1 : 1;
        start = at + 1;
    }
    if (start == text || !read_term(start, strlen(start), dimension, &term)) return FALSE;
    *si = sum + sign * term;
    return isfinite(*si);
}

gboolean tinker_number_read(const char *text, TinkerDimension dimension, const char *unit, double *si, GError **error)
{
    static const TinkerDimension none = {0, 0, 0, 0};
    g_autofree char *plain = with_point(text);
    GError *cause = NULL, *of_formula = NULL;
    TinkerUnit shown;
    gboolean is_bare = strspn(plain, "0123456789.+-eE") == strlen(plain);
    if (is_bare && tinker_unit_parse(unit, &shown, NULL) && tinker_quantity_parse(plain, none, si, NULL)) {
        *si *= shown.factor;
        return TRUE;
    }
    if (tinker_quantity_parse(plain, dimension, si, &cause)) return TRUE;
    if (read_quantity_formula(plain, dimension, unit, si, &of_formula) || read_sum(plain, dimension, si)) {
        g_clear_error(&of_formula);
        g_error_free(cause);
        return TRUE;
    }
    const gboolean is_formula = strpbrk(plain, "*(") != NULL;
    if (is_formula || strchr(plain, ',') == NULL) {
        g_propagate_error(error, is_formula ? of_formula : cause);
        g_error_free(is_formula ? cause : of_formula);
        return FALSE;
    }
    g_error_free(cause);
    g_error_free(of_formula);
    g_set_error_literal(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_SYNTAX,
                        _("A number is written with a point and without thousands separators, as in 3.5."));
    return FALSE;
}

char *tinker_number_write(double si, TinkerDimension dimension, const char *unit, TinkerUnitSystem system,
                          gboolean trims)
{
    g_autofree char *brief = tinker_quantity_significant(si, dimension, unit, system, DIGITS);
    const double size = fabs(g_ascii_strtod(brief, NULL));
    if (size >= TOO_LONG || (size >= ROUNDING && size < TOO_SMALL)) return g_steal_pointer(&brief);
    char *text = tinker_quantity_format(si, dimension, unit, system, DECIMALS), *point = strchr(text, '.');
    if (!trims || point == NULL) return text;
    char *end = point + 1 + strspn(point + 1, "0123456789"), *last = end;
    while (last[-1] == '0')
        last--;
    if (last[-1] == '.') last--;
    memmove(last, end, strlen(end) + 1);
    return text;
}

char *tinker_number_short(double si, const char *unit, int digits)
{
    char number[G_ASCII_DTOSTR_BUF_SIZE], format[16];
    TinkerUnit shown = {1, {0, 0, 0, 0}};
    tinker_unit_parse(unit, &shown, NULL);
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    g_ascii_formatd(number, sizeof number, format, si / shown.factor);
    return *unit == '\0' ? g_strdup(number) : g_strdup_printf("%s %s", number, unit);
}

char *tinker_number_measured(double si, const char *unit, int digits)
{
    return tinker_number_short(fabs(si) < NOTHING ? 0 : si, unit, digits);
}
