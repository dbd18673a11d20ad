/* Units: the first byte chooses the dimension that is asked for and the system to write in, the rest is text. What was
 * read must read back from the text that is written of it, with the same bits. */
#include <math.h>
#include <string.h>

#include "fuzz-target.h"
#include "units/quantity/units.h"

static const TinkerDimension asked[] = {
    {0}, {.mass = 1}, {.length = 1}, {.time = 1}, {.angle = 1}, {.mass = 1, .length = 1, .time = -2},
};

static void check_value(double si, TinkerDimension dimension, TinkerUnitSystem system)
{
    if (!isfinite(si)) g_error("%g was accepted", si);
    g_autofree char *text = tinker_quantity_to_text(si, dimension, system);
    double again = 0;
    if (!tinker_quantity_parse(text, dimension, &again, NULL)) g_error("\"%s\" does not read back", text);
    if (memcmp(&si, &again, sizeof si) != 0) g_error("\"%s\" reads back as %.17g, not %.17g", text, again, si);
    g_autofree char *brief = tinker_quantity_brief(si, dimension, system);
    g_autofree char *formatted = tinker_quantity_format(si, dimension, NULL, system, 3);
    if (!g_utf8_validate(brief, -1, NULL) || !g_utf8_validate(formatted, -1, NULL)) g_error("text is not UTF-8");
}

static void check_error(gboolean good, const GError *error)
{
    if (good != (error == NULL)) g_error("an error without a failure, or the other way round");
    if (error != NULL && !g_utf8_validate(error->message, -1, NULL)) g_error("the message is not UTF-8");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0) return 0;
    TinkerDimension wanted = asked[data[0] % G_N_ELEMENTS(asked)];
    TinkerUnitSystem system = data[0] >= 128 ? TINKER_UNIT_SYSTEM_ENGLISH : TINKER_UNIT_SYSTEM_SI;
    g_autofree char *text = g_strndup((const char *)data + 1, size - 1);

    g_autoptr(GError) error = NULL;
    TinkerUnit unit = {0};
    gboolean good = tinker_unit_parse(text, &unit, &error);
    check_error(good, error);
    if (good) {
        if (!(isfinite(unit.factor) && unit.factor > 0)) g_error("a unit of %g was accepted", unit.factor);
        wanted = unit.dimension;
        g_autofree char *one = g_strconcat("1.5 ", text, NULL);
        double si = 0;
        if (tinker_quantity_parse(one, wanted, &si, NULL)) check_value(si, wanted, system);
    }
    double si = 0;
    g_clear_error(&error);
    good = tinker_quantity_parse(text, wanted, &si, &error);
    check_error(good, error);
    if (good) check_value(si, wanted, system);
    return 0;
}
