/* Dimensions: comparing and naming them, and the units that their values are shown in. What the table has no entry for
 * is put together from base units: "kg m^3/s". */
#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

#include "units/quantity/units-private.h"

/* Symbols of the base units in the order of TinkerDimension. */
static const char *const si_bases[] = {"kg", "m", "s", "rad"};
static const char *const english_bases[] = {"slug", "ft", "s", "rad"};

/* A text that lives for ever, one copy for all who ask. g_intern_string would do, but it leaves a table behind whenever
 * it needs a larger one, and a file can have any number of dimensions in it. */
static const char *intern(const char *text)
{
    static GMutex mutex;
    static GStringChunk *texts;
    g_mutex_lock(&mutex);
    if (texts == NULL) texts = g_string_chunk_new(1024);
    const char *kept = g_string_chunk_insert_const(texts, text);
    g_mutex_unlock(&mutex);
    return kept;
}

static void append_power(GString *text, const char *base, int exponent)
{
    g_string_append(text, base);
    if (exponent != 1) g_string_append_printf(text, "^%d", exponent);
}

/* Numerators first; each denominator behind a `/` of its own, as the parser reads it. */
static const char *compose(TinkerDimension dimension, const char *const *bases)
{
    const int exponents[] = {dimension.mass, dimension.length, dimension.time, dimension.angle};
    g_autoptr(GString) text = g_string_new(NULL);
    for (int i = 0; i < 4; i++) {
        if (exponents[i] <= 0) continue;
        if (text->len > 0) g_string_append_c(text, ' ');
        append_power(text, bases[i], exponents[i]);
    }
    if (text->len == 0) g_string_append_c(text, '1');
    for (int i = 0; i < 4; i++) {
        if (exponents[i] >= 0) continue;
        g_string_append_c(text, '/');
        append_power(text, bases[i], -exponents[i]);
    }
    return intern(text->str);
}

const char *tinker_unit_in_ascii(const char *unit)
{
    if (g_str_is_ascii(unit)) return intern(unit);
    g_autoptr(GString) text = g_string_new(unit);
    g_string_replace(text, "·", " ", 0);
    g_string_replace(text, "²", "^2", 0);
    g_string_replace(text, "³", "^3", 0);
    return intern(text->str);
}

const char *tinker_unit_in_print(const char *unit)
{
    g_autoptr(GString) text = g_string_new(unit);
    g_string_replace(text, "*", "·", 0);
    g_string_replace(text, "^2", "²", 0);
    g_string_replace(text, "^3", "³", 0);
    return intern(text->str);
}

const char *tinker_unit_for(TinkerDimension dimension, TinkerUnitSystem system)
{
    const gboolean english = system == TINKER_UNIT_SYSTEM_ENGLISH;
    const TinkerDimensionEntry *entry = tinker_dimension_lookup(dimension);
    if (entry == NULL) return compose(dimension, english ? english_bases : si_bases);
    return english ? entry->english : entry->si;
}

const char *tinker_unit_si_symbol(TinkerDimension dimension)
{
    const TinkerDimension angle = {0, 0, 0, 1};
    if (tinker_dimension_equal(dimension, angle)) return "rad";
    return tinker_unit_in_ascii(tinker_unit_for(dimension, TINKER_UNIT_SYSTEM_SI));
}

const char *tinker_dimension_name(TinkerDimension dimension)
{
    const TinkerDimensionEntry *entry = tinker_dimension_lookup(dimension);
    return entry != NULL ? strchr(entry->phrase, ' ') + 1 : tinker_unit_si_symbol(dimension);
}

char *tinker_dimension_describe(TinkerDimension dimension)
{
    const TinkerDimensionEntry *entry = tinker_dimension_lookup(dimension);
    const char *symbol = tinker_unit_si_symbol(dimension);
    if (entry == NULL) return g_strdup_printf(_("a value in %s"), symbol);
    if (*symbol == '\0') return g_strdup(_(entry->phrase));
    return g_strdup_printf("%s (%s)", _(entry->phrase), symbol);
}
