/* Plots above one another in one picture, as amplitude and phase of a frequency response. */
#ifndef TINKER_CORE_PLOT_STACK_H
#define TINKER_CORE_PLOT_STACK_H

#include "render/plot/plot.h"

typedef struct {
    TinkerPlot plot;
    double share; /* of the picture's height */
} TinkerStackedPlot;

/* Draws them from the top down to .png, .svg or .pdf by the ending. */
gboolean tinker_plot_stack_to_file(const TinkerStackedPlot *plots, int count, int width, int height, const char *path,
                                   GError **error);

#endif
