/* Reading units and quantities. A unit is factors between product signs (space, `*`, `·`, `-` between letters) and `/`,
 * each a symbol of the table with an optional power: "m^2", "m²", "s^-1". `1` may stand before a `/`. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "units/quantity/units-private.h"

#define LONGEST_SYMBOL 32  /* bytes of an unknown symbol that a message quotes */
#define MOST_IN_RUN    4   /* units that letters without a sign between them are taken for */
#define LARGEST_POWER  128 /* what a dimension can hold, and so what is written of one; sums are checked apart */
#define DIMENSIONS     4

/* Reads `text` from `at` on; `offset` is what comes before `text` in the user's text, in characters. */
typedef struct {
    const char *text;
    const char *at;
    const char *unit; /* where the unit begins */
    int sign;         /* of the factor that is read: -1 behind a `/` */
    glong offset;
    const TinkerDimension *wanted; /* for suggestions; NULL where anything goes */
    GError **error;
} UnitReader;

GQuark tinker_units_error_quark(void)
{
    return g_quark_from_static_string("tinker-units-error-quark");
}

static glong column_of(const UnitReader *reader, const char *place)
{
    return reader->offset + g_utf8_pointer_to_offset(reader->text, place) + 1;
}

static gboolean fail(const UnitReader *reader, TinkerUnitsError code, const char *place, const char *message)
{
    g_set_error(reader->error, TINKER_UNITS_ERROR, code, "column %ld: %s", column_of(reader, place), message);
    return FALSE;
}

/* The units in the table that have this dimension, or the two it is displayed in: "\"m\", \"mm\" or \"ft\"". */
static char *units_of(TinkerDimension dimension)
{
    g_autoptr(GPtrArray) units = g_ptr_array_new();
    for (const TinkerUnitEntry *entry = tinker_unit_table; entry->symbol != NULL; entry++)
        if (tinker_dimension_equal(entry->dimension, dimension)) g_ptr_array_add(units, (gpointer)entry->symbol);
    if (units->len == 0) {
        const char *si = tinker_unit_for(dimension, TINKER_UNIT_SYSTEM_SI);
        const char *english = tinker_unit_for(dimension, TINKER_UNIT_SYSTEM_ENGLISH);
        if (*si != '\0') g_ptr_array_add(units, (gpointer)si);
        if (strcmp(si, english) != 0) g_ptr_array_add(units, (gpointer)english);
    }
    g_autoptr(GString) list = g_string_new(NULL);
    for (guint i = 0; i < units->len; i++) {
        if (i > 0) g_string_append(list, i + 1 < units->len ? ", " : _(" or "));
        g_string_append_printf(list, "\"%s\"", (const char *)units->pdata[i]);
    }
    return g_string_free(g_steal_pointer(&list), FALSE);
}

static gsize symbol_length(const char *at)
{
    const char *end = at;
    for (;;) {
        if (g_str_has_prefix(end, "°")) {
            end += strlen("°");
        } else if (g_ascii_isalpha(*end) || (end > at && g_ascii_isdigit(*end)) || *end == '_') {
            end++;
        } else {
            return (gsize)(end - at);
        }
    }
}

/* Whether the whole unit can be one of the wanted dimension with `meant` in the place of these letters. */
static gboolean may_fit(const UnitReader *reader, const char *start, gsize length, const char *meant)
{
    TinkerUnit unit;
    g_autofree char *text =
        g_strdup_printf("%.*s%s%s", (int)(start - reader->unit), reader->unit, meant, start + length);
    /* one that is wrong once more, farther on, says nothing yet */
    return reader->wanted == NULL || !tinker_unit_parse(text, &unit, NULL) ||
           tinker_dimension_equal(unit.dimension, *reader->wanted);
}

/* A run of letters that is no unit as so many units of the table, each with the digits of its power: "Nm" is "N m",
 * "s2" is "s^2". The part of it that is left is at `run`, what was made of the others is in `meant`. FALSE, with
 * `meant` as it was, where nothing fits. */
static gboolean split_run(const UnitReader *reader, const char *start, const char *run, int parts, GString *meant)
{
    const gsize length = symbol_length(start), before = meant->len;
    for (const TinkerUnitEntry *entry = tinker_unit_table; entry->symbol != NULL; entry++) {
        if (!g_str_has_prefix(run, entry->symbol)) continue;
        const char *digits = run + strlen(entry->symbol);
        const gsize power = strspn(digits, "0123456789");
        const gboolean is_last = digits + power == start + length;
        if (is_last != (parts == 1)) continue;
        g_string_append_printf(meant, "%s%s%s%.*s", before > 0 ? reader->sign < 0 ? "/" : " " : "", entry->symbol,
                               power > 0 ? "^" : "", (int)power, digits);
        if (is_last ? may_fit(reader, start, length, meant->str)
                    : split_run(reader, start, digits + power, parts - 1, meant))
            return TRUE;
        g_string_truncate(meant, before);
    }
    return FALSE;
}

/* The unit that was probably meant by a symbol that there is not; NULL where none comes near. (transfer full) */
static char *unit_meant(const UnitReader *reader, const char *start, const char *symbol)
{
    const char *candidates[64];
    gsize count = 0;
    for (const TinkerUnitEntry *entry = tinker_unit_table; entry->symbol != NULL; entry++) {
        g_assert(count + 1 < G_N_ELEMENTS(candidates));
        if (may_fit(reader, start, strlen(symbol), entry->symbol)) candidates[count++] = entry->symbol;
    }
    candidates[count] = NULL;
    const char *nearest = tinker_nearest_word(symbol, candidates);
    g_autoptr(GString) split = g_string_new(NULL);
    for (int parts = 1; parts <= MOST_IN_RUN && (nearest == NULL || reader->wanted != NULL); parts++)
        if (split_run(reader, start, start, parts, split)) return g_strdup(split->str);
    return g_strdup(nearest);
}

static gboolean fail_unknown(const UnitReader *reader, const char *start, gsize length)
{
    if (reader->error == NULL) return FALSE; /* nobody asks why */
    const gboolean whole = length <= LONGEST_SYMBOL;
    g_autofree char *cut = g_strndup(start, MIN(length, LONGEST_SYMBOL));
    g_autofree char *symbol = g_utf8_make_valid(cut, -1);
    g_autofree char *meant = whole ? unit_meant(reader, start, symbol) : NULL;
    g_autofree char *choice = NULL;
    if (meant != NULL) {
        choice = g_strdup_printf(_("; did you mean \"%s\"?"), meant);
    } else if (reader->wanted != NULL) {
        g_autofree char *units = units_of(*reader->wanted);
        choice = *units != '\0' ? g_strdup_printf(_("; did you mean %s?"), units)
                                : g_strdup(_("; a plain number is expected here"));
    }
    g_autofree char *message =
        g_strdup_printf(_("unknown unit \"%s%s\"%s"), symbol, whole ? "" : "...", choice != NULL ? choice : "");
    return fail(reader, TINKER_UNITS_ERROR_UNKNOWN, start, message);
}

static gboolean skip(const char **at, const char *sign)
{
    if (!g_str_has_prefix(*at, sign)) return FALSE;
    *at += strlen(sign);
    return TRUE;
}

static void skip_blanks(const char **at)
{
    while (**at == ' ' || **at == '\t')
        (*at)++;
}

/* One digit as it stands behind `^`, or raised: "²". Answers -1 where there is none. */
static int read_digit(const char **at, gboolean raised)
{
    static const char *const raised_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (!raised) return g_ascii_isdigit(**at) ? *(*at)++ - '0' : -1;
    for (int digit = 0; digit < 10; digit++)
        if (skip(at, raised_digits[digit])) return digit;
    return -1;
}

/* An optional power behind a symbol; 1 where there is none. */
static gboolean read_power(UnitReader *reader, int *power)
{
    const char *start = reader->at;
    const gboolean raised = !skip(&reader->at, "^");
    const gboolean negative = skip(&reader->at, raised ? "⁻" : "-");
    int digit = read_digit(&reader->at, raised);
    *power = 1;
    if (digit < 0) {
        if (raised && !negative) return TRUE;
        return fail(reader, TINKER_UNITS_ERROR_SYNTAX, start, _("a whole number is expected as the power, as in m^2"));
    }
    *power = 0;
    for (; digit >= 0; digit = read_digit(&reader->at, raised)) {
        *power = *power * 10 + digit;
        if (*power > LARGEST_POWER) return fail(reader, TINKER_UNITS_ERROR_SYNTAX, start, _("the power is too large"));
    }
    if (negative) *power = -*power;
    return TRUE;
}

/* One factor with its power, multiplied onto the unit; `sign` is -1 behind a `/`. */
static gboolean read_factor(UnitReader *reader, int sign, double *factor, int exponents[DIMENSIONS])
{
    const char *start = reader->at;
    const gsize length = symbol_length(start);
    reader->sign = sign;
    if (length == 0) {
        const char *message =
            *start == '\0' ? _("a unit is missing at the end") : _("a unit is expected here, such as m, kg or lbf/ft");
        return fail(reader, TINKER_UNITS_ERROR_SYNTAX, start, message);
    }
    char symbol[LONGEST_SYMBOL + 1];
    g_strlcpy(symbol, start, MIN(sizeof symbol, length + 1));
    const TinkerUnitEntry *entry = length < sizeof symbol ? tinker_unit_lookup(symbol) : NULL;
    if (entry == NULL) return fail_unknown(reader, start, length);

    int power;
    reader->at += length;
    if (!read_power(reader, &power)) return FALSE;
    power *= sign;
    *factor *= power == 1 ? entry->factor : power == -1 ? 1 / entry->factor : pow(entry->factor, power);

    const int own[] = {entry->dimension.mass, entry->dimension.length, entry->dimension.time, entry->dimension.angle};
    gboolean fits = isfinite(*factor) && *factor > 0;
    for (int i = 0; i < DIMENSIONS; i++) {
        exponents[i] += power * own[i];
        fits = fits && exponents[i] >= G_MININT8 && exponents[i] <= G_MAXINT8;
    }
    return fits || fail(reader, TINKER_UNITS_ERROR_SYNTAX, start, _("the unit is out of range"));
}

/* The sign between two factors: 1 for a product, -1 for `/`, 0 at the end. */
static int read_sign(UnitReader *reader)
{
    const char *before = reader->at;
    skip_blanks(&reader->at);
    if (*reader->at == '\0') return 0;
    int sign = 1;
    if (skip(&reader->at, "/")) {
        sign = -1;
    } else if (*before == '-' && g_ascii_isalpha(before[1])) {
        reader->at++;
    } else if (!skip(&reader->at, "*") && !skip(&reader->at, "·") && !skip(&reader->at, "⋅") && reader->at == before) {
        return 1; /* nothing stands between: read_factor says what is wrong */
    }
    skip_blanks(&reader->at);
    return sign;
}

static gboolean read_unit(UnitReader *reader, TinkerUnit *unit)
{
    int exponents[DIMENSIONS] = {0};
    double factor = 1;
    int sign = 1;
    skip_blanks(&reader->at);
    reader->unit = reader->at;
    if (*reader->at == '1' && !g_ascii_isdigit(reader->at[1])) {
        reader->at++;
        const char *behind = reader->at;
        sign = read_sign(reader);
        if (sign > 0) return fail(reader, TINKER_UNITS_ERROR_SYNTAX, behind, _("a \"/\" is expected here, as in 1/s"));
    }
    if (*reader->at == '\0' && sign > 0) sign = 0;
    for (; sign != 0; sign = read_sign(reader))
        if (!read_factor(reader, sign, &factor, exponents)) return FALSE;
    unit->factor = factor;
    unit->dimension =
        (TinkerDimension){(int8_t)exponents[0], (int8_t)exponents[1], (int8_t)exponents[2], (int8_t)exponents[3]};
    return TRUE;
}

static gboolean check_text(const char *text, GError **error)
{
    const char *end;
    if (g_utf8_validate(text, -1, &end)) return TRUE;
    g_set_error(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_SYNTAX, "column %ld: %s",
                g_utf8_pointer_to_offset(text, end) + 1, _("the text is not UTF-8 here"));
    return FALSE;
}

/* The end of a decimal number at `at`, or `at` itself; "nan", "inf" and hexadecimal digits are none. */
static const char *number_end(const char *at)
{
    const char *end = at;
    if (*end == '+' || *end == '-') end++;
    const char *digits = end;
    while (g_ascii_isdigit(*end))
        end++;
    gsize count = (gsize)(end - digits);
    if (*end == '.') {
        const char *decimals = ++end;
        while (g_ascii_isdigit(*end))
            end++;
        count += (gsize)(end - decimals);
    }
    if (count == 0) return at;
    if (*end == 'e' || *end == 'E') {
        const char *exponent = end + 1;
        if (*exponent == '+' || *exponent == '-') exponent++;
        if (g_ascii_isdigit(*exponent)) {
            while (g_ascii_isdigit(*exponent))
                exponent++;
            end = exponent;
        }
    }
    return end;
}

/* A comma where a number has none: between its whole part and its decimals, as other languages write it, or between
 * thousands. `comma` is in the number that begins at `start`. */
static gboolean fail_comma(const UnitReader *reader, const char *start, const char *comma)
{
    const char *end = comma;
    int commas = 0;
    for (; g_ascii_isdigit(*end) || (*end == ',' && g_ascii_isdigit(end[1])); end++)
        commas += *end == ',';
    const gboolean decimals = commas == 1 && *end != '.';
    g_autoptr(GString) meant = g_string_new_len(start, end - start);
    g_string_replace(meant, ",", decimals ? "." : "", 0);
    g_string_append(meant, end); /* decimals, and a power of ten */
    g_string_truncate(meant, (gsize)(number_end(meant->str) - meant->str));
    g_autofree char *message =
        g_strdup_printf(decimals ? _("decimals stand behind a point, not a comma; did you mean \"%s\"?")
                                 : _("no commas stand between thousands; did you mean \"%s\"?"),
                        meant->str);
    return fail(reader, TINKER_UNITS_ERROR_SYNTAX, comma, message);
}

gboolean tinker_unit_parse(const char *text, TinkerUnit *unit, GError **error)
{
    if (!check_text(text, error)) return FALSE;
    UnitReader reader = {.text = text, .at = text, .error = error};
    return read_unit(&reader, unit);
}

gboolean tinker_quantity_parse(const char *text, TinkerDimension wanted, double *si, GError **error)
{
    if (!check_text(text, error)) return FALSE;
    UnitReader reader = {.text = text, .at = text, .wanted = &wanted, .error = error};
    skip_blanks(&reader.at);
    const char *start = reader.at;
    const char *end = number_end(start);
    const char *comma = end > start ? end : start + strspn(start, "+-");
    if (*comma == ',' && g_ascii_isdigit(comma[1])) return fail_comma(&reader, start, comma);
    if (end == start)
        return fail(&reader, TINKER_UNITS_ERROR_SYNTAX, start, _("a number is expected here, as in 12 or 12 in"));

    g_autofree char *digits = g_strndup(start, (gsize)(end - start));
    const double number = g_ascii_strtod(digits, NULL);
    TinkerUnit unit = {1, wanted};
    reader.at = end;
    skip_blanks(&reader.at);
    const char *unit_start = reader.at;
    if (*unit_start != '\0' && !read_unit(&reader, &unit)) return FALSE;

    if (!tinker_dimension_equal(unit.dimension, wanted)) {
        g_autofree char *expected = tinker_dimension_describe(wanted);
        g_autofree char *found = tinker_dimension_describe(unit.dimension);
        g_autofree char *message = g_strdup_printf(_("%s was expected, \"%s\" is %s"), expected, text, found);
        return fail(&reader, TINKER_UNITS_ERROR_DIMENSION, unit_start, message);
    }
    const double value = number * unit.factor;
    if (!isfinite(value)) return fail(&reader, TINKER_UNITS_ERROR_SYNTAX, start, _("the number is out of range"));
    *si = value;
    return TRUE;
}
