/* Where the energy of a run is and where it went: layers that are stacked, and what they have to add up to. No widget.
 */
#ifndef TINKER_GUI_ENERGY_DATA_H
#define TINKER_GUI_ENERGY_DATA_H

#include "gui/document/player.h"
#include "render/plot/plot.h"

/* From the bottom up. */
typedef enum {
    TINKER_ENERGY_KINETIC,
    TINKER_ENERGY_POTENTIAL, /* above its least in the run */
    TINKER_ENERGY_STORED,
    TINKER_ENERGY_DAMPERS, /* taken since the start, as what follows */
    TINKER_ENERGY_FRICTION,
    TINKER_ENERGY_IMPACTS,
    TINKER_ENERGY_LAYERS,
} TinkerEnergyLayer;

typedef struct _TinkerEnergyData TinkerEnergyData;

/* Of what the player records. Takes references. (transfer full) */
TinkerEnergyData *tinker_energy_data_new(TinkerDocument *document, TinkerPlayer *player);
void tinker_energy_data_free(TinkerEnergyData *data);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerEnergyData, tinker_energy_data_free)

/* "Kinetic"; translated. */
const char *tinker_energy_layer_name(TinkerEnergyLayer layer);

/* Takes over what has been recorded since. A number that is another whenever the picture is. */
guint64 tinker_energy_data_update(TinkerEnergyData *data);
gboolean tinker_energy_data_is_behind(const TinkerEnergyData *data);

/* Samples; 0 before a run. */
gsize tinker_energy_data_count(const TinkerEnergyData *data);

/* Whether a layer has anything in the run so far, but rounding: else it is not shown. */
gboolean tinker_energy_data_has(const TinkerEnergyData *data, TinkerEnergyLayer layer);

/* What the layers are at the present time (J), and what they have to add up to: what there was at the start, and what
 * was given since. FALSE before a run. */
gboolean tinker_energy_data_now(const TinkerEnergyData *data, double layers[TINKER_ENERGY_LAYERS], double *sum);

/* The layers that have anything as areas over time, in the theme's colours of their numbers, and the sum as a dashed
 * line over them; borrowed until the next update. */
void tinker_energy_data_fill_plot(TinkerEnergyData *data, TinkerPlot *plot);

#endif
