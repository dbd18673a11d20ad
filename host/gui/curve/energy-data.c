/* Each layer is the band between the sum of those below it and that sum with it. The potential energy of a field has no
 * zero of its own: it is counted from its least in the run, and the sum likewise. */
#include "gui/curve/energy-data.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "common/graph/graph-axis.h"

#define QUANTITIES (TINKER_ENERGY_LAYERS + 1) /* the last one is what was supplied */
#define EMPTY      1e-9                       /* of the highest: rounding, and nothing to see */

struct _TinkerEnergyData {
    TinkerDocument *document;
    TinkerPlayer *player;
    guint generation;
    guint64 revision;
    double now;
    TinkerSeriesCursor cursors[QUANTITIES];
    GArray *times[QUANTITIES], *values[QUANTITIES];   /* of double */
    gsize count;                                      /* samples that all have */
    GArray *tops[TINKER_ENERGY_LAYERS], *floor, *sum; /* of double */
    double least;                                     /* of the potential energy, that tops have */
    double greatest[TINKER_ENERGY_LAYERS], highest;   /* of any sample: of each layer; of all, or their sum */
    TinkerCurve curves[TINKER_ENERGY_LAYERS + 1];
    char *label;
};

static const int32_t quantities[QUANTITIES] = {TINKER_SCENE_KINETIC, TINKER_SCENE_POTENTIAL, TINKER_SCENE_STORED,
                                               TINKER_SCENE_DAMPERS, TINKER_SCENE_FRICTION,  TINKER_SCENE_IMPACTS,
                                               TINKER_SCENE_SUPPLIED};

const char *tinker_energy_layer_name(TinkerEnergyLayer layer)
{
    static const char *const names[] = {N_("Kinetic"), N_("Potential"), N_("Stored"),
                                        N_("Dampers"), N_("Friction"),  N_("Impacts")};
    return _(names[layer]);
}

static const double *numbers(const GArray *array)
{
    return (const double *)(gconstpointer)array->data;
}

static void forget(TinkerEnergyData *data)
{
    for (int i = 0; i < QUANTITIES; i++) {
        g_array_set_size(data->times[i], 0);
        g_array_set_size(data->values[i], 0);
        data->cursors[i] = (TinkerSeriesCursor){0};
    }
    data->count = 0;
    data->least = INFINITY;
}

/* The layers of sample i, and what they have to add up to. */
static void read_sample(const TinkerEnergyData *data, gsize i, double layers[TINKER_ENERGY_LAYERS], double *sum)
{
    double start = 0;
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++) {
        const double base = k == TINKER_ENERGY_POTENTIAL ? data->least : 0;
        layers[k] = numbers(data->values[k])[i] - base;
        start += numbers(data->values[k])[0] - base;
    }
    *sum = start + numbers(data->values[TINKER_ENERGY_LAYERS])[i];
}

/* Stacks the samples from `first` on. */
static void stack(TinkerEnergyData *data, gsize first)
{
    const double zero = 0;
    if (first == 0) {
        memset(data->greatest, 0, sizeof data->greatest);
        data->highest = 0;
    }
    GArray *const all[] = {data->tops[0], data->tops[1], data->tops[2], data->tops[3],
                           data->tops[4], data->tops[5], data->floor,   data->sum};
    for (gsize k = 0; k < G_N_ELEMENTS(all); k++)
        g_array_set_size(all[k], (guint)first);
    for (gsize i = first; i < data->count; i++) {
        double layers[TINKER_ENERGY_LAYERS], sum, top = 0;
        read_sample(data, i, layers, &sum);
        for (int k = 0; k < TINKER_ENERGY_LAYERS; k++) {
            top += layers[k];
            data->greatest[k] = fmax(data->greatest[k], fabs(layers[k]));
            data->highest = fmax(data->highest, data->greatest[k]);
            g_array_append_val(data->tops[k], top);
        }
        g_array_append_val(data->floor, zero);
        g_array_append_val(data->sum, sum);
    }
}

guint64 tinker_energy_data_update(TinkerEnergyData *data)
{
    const guint generation = tinker_player_generation(data->player);
    const double now = tinker_player_time(data->player), least_before = data->least;
    const gsize before = data->count;
    if (generation != data->generation) {
        forget(data);
        data->revision++;
    }
    data->generation = generation;
    gsize count = G_MAXSIZE;
    for (int i = 0; i < QUANTITIES; i++) {
        const TinkerQuantity of = {TINKER_NO_BLOCK, quantities[i]};
        data->cursors[i].at_events = TRUE;
        tinker_player_series(data->player, of, &data->cursors[i], data->times[i], data->values[i]);
        count = MIN(count, data->values[i]->len);
    }
    const double *potential = numbers(data->values[TINKER_ENERGY_POTENTIAL]);
    for (gsize i = data->count; i < count; i++)
        data->least = fmin(data->least, potential[i]);
    data->count = count;
    if (data->count != before || data->least != least_before) {
        stack(data, data->least == least_before ? MIN(before, data->count) : 0);
        data->revision++;
    }
    if (now != data->now) data->revision++;
    data->now = now;
    return data->revision;
}

gboolean tinker_energy_data_is_behind(const TinkerEnergyData *data)
{
    for (int i = 0; i < QUANTITIES; i++)
        if (data->cursors[i].behind) return TRUE;
    return FALSE;
}

gsize tinker_energy_data_count(const TinkerEnergyData *data)
{
    return data->count;
}

gboolean tinker_energy_data_has(const TinkerEnergyData *data, TinkerEnergyLayer layer)
{
    return data->greatest[layer] > EMPTY * data->highest;
}

gboolean tinker_energy_data_now(const TinkerEnergyData *data, double layers[TINKER_ENERGY_LAYERS], double *sum)
{
    if (data->count == 0) return FALSE;
    const double *times = numbers(data->times[0]);
    gsize next = tinker_curve_first_from(times, data->count, data->now);
    if (next >= data->count || (times[next] > data->now && next > 0)) next--;
    read_sample(data, next, layers, sum);
    return TRUE;
}

void tinker_energy_data_fill_plot(TinkerEnergyData *data, TinkerPlot *plot)
{
    int count = 0;
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++) {
        if (!tinker_energy_data_has(data, (TinkerEnergyLayer)k)) continue;
        data->curves[count] = (TinkerCurve){.x = numbers(data->times[0]),
                                            .y = numbers(data->tops[k]),
                                            .low = numbers(k > 0 ? data->tops[k - 1] : data->floor),
                                            .high = numbers(data->tops[k]),
                                            .filled = TRUE,
                                            .count = data->count,
                                            .colour = k};
        count++;
    }
    data->curves[count] = (TinkerCurve){.label = _("Start + supplied since"),
                                        .x = numbers(data->times[0]),
                                        .y = numbers(data->sum),
                                        .count = data->count,
                                        .role = TINKER_CURVE_GUIDE};
    count++;
    g_free(data->label);
    data->label = tinker_axis_label(_("Energy"), "J");
    plot->x_label = _("Time [s]");
    plot->y_label = data->label;
    plot->curves = data->curves;
    plot->curve_count = count;
    plot->cursor = &data->now;
}

TinkerEnergyData *tinker_energy_data_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerEnergyData *data = g_new0(TinkerEnergyData, 1);
    data->document = g_object_ref(document);
    data->player = g_object_ref(player);
    data->generation = tinker_player_generation(player);
    data->least = INFINITY;
    for (int i = 0; i < QUANTITIES; i++) {
        data->times[i] = g_array_new(FALSE, FALSE, sizeof(double));
        data->values[i] = g_array_new(FALSE, FALSE, sizeof(double));
    }
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
        data->tops[k] = g_array_new(FALSE, FALSE, sizeof(double));
    data->floor = g_array_new(FALSE, FALSE, sizeof(double));
    data->sum = g_array_new(FALSE, FALSE, sizeof(double));
    return data;
}

void tinker_energy_data_free(TinkerEnergyData *data)
{
    if (data == NULL) return;
    for (int i = 0; i < QUANTITIES; i++) {
        g_array_unref(data->times[i]);
        g_array_unref(data->values[i]);
    }
    for (int k = 0; k < TINKER_ENERGY_LAYERS; k++)
        g_array_unref(data->tops[k]);
    g_array_unref(data->floor);
    g_array_unref(data->sum);
    g_free(data->label);
    g_object_unref(data->player);
    g_object_unref(data->document);
    g_free(data);
}
