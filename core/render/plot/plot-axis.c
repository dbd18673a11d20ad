/* An axis: its range, its ticks, and labels that can be read. Numbers whose digits would fill the margin are shortened:
 * a power of ten moves into the unit of the axis's title ("Y Position [10⁻⁹ m]"), and a constant that all ticks share
 * is taken off and named there ("Y Position − 9.81 [10⁻⁶ m]"). */
#include <math.h>
#include <string.h>

#include "render/plot/plot-private.h"

#define CONSTANT_RANGE    1e-8 /* of the values: what varies less is the error of a run, and shown as constant */
#define MOST_DIGITS       5    /* of a label, before an offset is taken off */
#define LEAST_EXPONENT    (-2) /* of the greatest label, without a factor */
#define GREATEST_EXPONENT 4

/* How labels are shortened: shown = (value - offset) / 10^exponent. */
typedef struct {
    double offset;
    int offset_decimals;
    int exponent;
} Shortening;

void tinker_axis_set_range(TinkerAxis *axis, double least, double greatest, double margin)
{
    axis->empty = !(least <= greatest);
    if (axis->empty) {
        least = axis->logarithmic ? 1 : 0;
        greatest = axis->logarithmic ? 10 : 1;
        margin = 0;
    }
    if (axis->logarithmic) {
        axis->low = log10(CLAMP(least, TINKER_AXIS_LEAST, TINKER_AXIS_GREATEST));
        axis->high = log10(CLAMP(greatest, TINKER_AXIS_LEAST, TINKER_AXIS_GREATEST));
        if (axis->high - axis->low < 1e-9) {
            axis->low -= 0.5;
            axis->high += 0.5;
        }
    } else {
        axis->low = CLAMP(least, -TINKER_AXIS_GREATEST, TINKER_AXIS_GREATEST);
        axis->high = CLAMP(greatest, -TINKER_AXIS_GREATEST, TINKER_AXIS_GREATEST);
        double size = fmax(fabs(axis->low), fabs(axis->high));
        if (size < TINKER_AXIS_LEAST) {
            axis->low = -1;
            axis->high = 1;
        } else if (axis->high - axis->low <= CONSTANT_RANGE * size) {
            double middle = axis->low / 2 + axis->high / 2;
            axis->low = middle - 0.1 * size;
            axis->high = middle + 0.1 * size;
        }
    }
    double room = margin * (axis->high - axis->low);
    axis->low -= room;
    axis->high += room;
}

void tinker_axis_clear(TinkerAxis *axis)
{
    for (int i = 0; i < axis->tick_count; i++)
        g_clear_pointer(&axis->labels[i], g_free);
    axis->tick_count = 0;
    g_clear_pointer(&axis->title, g_free);
}

/* Labels
 * --------------------------------------------------------------------------------------------------------------- */

static int decade_of(double value)
{
    return value == 0 ? 0 : (int)floor(log10(fabs(value)) + 1e-9);
}

static double greatest_of(const double *values, int count, double offset)
{
    double greatest = 0;
    for (int i = 0; i < count; i++)
        greatest = fmax(greatest, fabs(values[i] - offset));
    return greatest;
}

static Shortening shorten(const double *values, int count)
{
    Shortening shortening = {0};
    double greatest = greatest_of(values, count, 0);
    if (count >= 2) {
        double step = values[1] - values[0], range = values[count - 1] - values[0];
        if (decade_of(greatest) - decade_of(step) >= MOST_DIGITS) {
            int decade = decade_of(range) + 1;
            double unit = pow(10, decade);
            shortening.offset = round((values[0] / 2 + values[count - 1] / 2) / unit) * unit;
            shortening.offset_decimals = -decade;
            greatest = greatest_of(values, count, shortening.offset);
        }
    }
    int exponent = decade_of(greatest);
    if (exponent > GREATEST_EXPONENT || exponent < LEAST_EXPONENT) shortening.exponent = 3 * (int)floor(exponent / 3.0);
    return shortening;
}

static char *number_label(double value, const Shortening *shortening, int places)
{
    /* The power is taken in two halves: 10^308 and beyond is not a double. */
    int half = shortening->exponent / 2;
    double shown = (value - shortening->offset) / pow(10, half) / pow(10, shortening->exponent - half);
    char format[8], number[512];
    g_snprintf(format, sizeof format, "%%.%df", places);
    if (fabs(shown) < 0.5 * pow(10, -places)) shown = 0;
    g_ascii_formatd(number, sizeof number, format, shown);
    GString *label = g_string_new(NULL);
    tinker_text_append_number(label, number);
    return g_string_free(label, FALSE);
}

static void append_offset(GString *title, const Shortening *shortening)
{
    double size = fabs(shortening->offset);
    int digits = CLAMP(decade_of(size) + shortening->offset_decimals + 1, 1, 17);
    char format[8], number[64];
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    g_ascii_formatd(number, sizeof number, format, size);
    g_string_append(title, shortening->offset > 0 ? " − " : " + ");
    tinker_text_append_number(title, number);
}

/* "Y Position [m]" with its offset and factor. */
static char *title_of(const char *label, const Shortening *shortening)
{
    label = label ? label : "";
    if (shortening->offset == 0 && shortening->exponent == 0) return g_strdup(label);
    const char *bracket = g_str_has_suffix(label, "]") ? strrchr(label, '[') : NULL;
    gsize name_length = bracket ? (gsize)(bracket - label) : strlen(label);
    g_autofree char *name = g_strchomp(g_strndup(label, name_length));
    g_autofree char *unit = bracket ? g_strndup(bracket + 1, strlen(bracket) - 2) : g_strdup("");
    GString *title = g_string_new(name);
    if (shortening->offset != 0) append_offset(title, shortening);
    if (shortening->exponent != 0) {
        g_string_append(title, title->len ? " [" : "[");
        tinker_text_append_power(title, shortening->exponent);
        if (*unit) g_string_append_c(title, ' ');
    } else if (bracket) {
        g_string_append(title, title->len ? " [" : "[");
    }
    if (bracket || shortening->exponent != 0) {
        g_string_append(title, unit);
        g_string_append_c(title, ']');
    }
    return g_string_free(title, FALSE);
}

/* Ticks
 * ---------------------------------------------------------------------------------------------------------------- */

static void set_number_ticks(TinkerAxis *axis, double low, double high, int most, const char *label)
{
    double values[TINKER_PLOT_MOST_TICKS];
    int decimals, count = 0;
    /* One tick tells no scale; the step before the one that leaves less than two of them never has more than five. */
    for (int room = most; room <= MAX(most, 5) && count < 2; room++)
        count = tinker_plot_ticks(low, high, room, values, &decimals);
    Shortening shortening = shorten(values, count);
    /* Steps of more than 1 have digits behind the point once they are divided by a factor. */
    int step = count >= 2 ? decade_of(values[1] - values[0]) : 0;
    int places = CLAMP(shortening.exponent - step, 0, 17);
    for (int i = 0; i < count; i++) {
        axis->ticks[i] = axis->logarithmic ? log10(values[i]) : values[i];
        axis->labels[i] = number_label(values[i], &shortening, places);
    }
    axis->tick_count = count;
    axis->title = title_of(label, &shortening);
}

/* Powers of ten, every one or every n-th. */
static void set_decade_ticks(TinkerAxis *axis, int most, const char *label)
{
    int first = (int)ceil(axis->low - 1e-9), last = (int)floor(axis->high + 1e-9);
    int stride = (last - first) / MAX(most, 1) + 1;
    first = (int)ceil((double)first / stride) * stride;
    for (int decade = first; decade <= last && axis->tick_count < TINKER_PLOT_MOST_TICKS; decade += stride) {
        GString *text = g_string_new(NULL);
        tinker_text_append_power(text, decade);
        axis->ticks[axis->tick_count] = decade;
        axis->labels[axis->tick_count++] = g_string_free(text, FALSE);
    }
    axis->decade_stride = stride;
    axis->title = g_strdup(label ? label : "");
}

/* 1, 2 and 5 times powers of ten, as plain numbers. FALSE where fewer than three of them lie on the axis, or more than
 * `most` do. */
static gboolean set_one_two_five_ticks(TinkerAxis *axis, int most, const char *label)
{
    static const int mantissas[] = {1, 2, 5};
    double values[TINKER_PLOT_MOST_TICKS];
    int count = 0, lowest = (int)floor(axis->low), highest = (int)floor(axis->high);
    if (lowest < LEAST_EXPONENT || highest > GREATEST_EXPONENT) return FALSE;
    for (int decade = lowest; decade <= highest; decade++) {
        for (gsize i = 0; i < G_N_ELEMENTS(mantissas); i++) {
            double value = mantissas[i] * pow(10, decade), place = log10(value);
            if (place < axis->low - 1e-9 || place > axis->high + 1e-9) continue;
            if (count == most) return FALSE;
            values[count++] = value;
        }
    }
    if (count < 3) return FALSE;
    for (int i = 0; i < count; i++) {
        axis->ticks[i] = log10(values[i]);
        axis->labels[i] = number_label(values[i], &(Shortening){0}, MAX(-decade_of(values[i]), 0));
    }
    axis->tick_count = count;
    axis->title = g_strdup(label ? label : "");
    return TRUE;
}

void tinker_axis_choose_ticks(TinkerAxis *axis, int most, const char *label)
{
    tinker_axis_clear(axis);
    most = CLAMP(most, 2, TINKER_PLOT_MOST_TICKS);
    axis->decade_stride = 0;
    gboolean numbered = axis->logarithmic && axis->high - axis->low < 2;
    if (numbered && set_one_two_five_ticks(axis, most, label)) return;
    if (axis->logarithmic && floor(axis->high + 1e-9) - ceil(axis->low - 1e-9) + 1 >= 2)
        set_decade_ticks(axis, most, label);
    else if (axis->logarithmic)
        set_number_ticks(axis, pow(10, axis->low), pow(10, axis->high), MIN(most, 6), label);
    else
        set_number_ticks(axis, axis->low, axis->high, most, label);
}
