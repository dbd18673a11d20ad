/* What the files of a graph's data share. */
#ifndef TINKER_GUI_GRAPH_DATA_PRIVATE_H
#define TINKER_GUI_GRAPH_DATA_PRIVATE_H

#include "gui/curve/graph-data.h"

#include "gui/curve/thin-path.h"

/* One curve. */
typedef struct {
    TinkerGraphSeries *series;
    TinkerKeptRun *run;  /* borrowed; NULL: the present one */
    guint generation;    /* of what is kept */
    char *name, *label;  /* of the curve, and in a legend */
    char *run_name;      /* NULL: of the present run */
    TinkerThinPath thin; /* of a path */
} GraphLine;

struct _TinkerGraphData {
    TinkerDocument *document;
    TinkerPlayer *player;

    /* The graph. */
    TinkerSceneGraph *graph; /* NULL at first */
    GPtrArray *lines;        /* of GraphLine: the present run's, then those of each run that is kept */
    guint own;               /* lines of the present run */
    char *title;
    char *x_label, *y_label, *right_label;
    gboolean over_time, is_spectrum, is_path;

    /* The record. */
    guint generation;
    double time;      /* s: the present */
    guint64 revision; /* of the picture */
    gboolean drawn_thin;

    /* What a plot borrows. */
    GArray *curves; /* of TinkerCurve */
    GArray *now;    /* of double: x and y of each curve at present, in turn */
    double axes_x[2], axes_y[2], floor_y[2], ranges[2][2];
};

static inline GraphLine *graph_line(const TinkerGraphData *data, guint number)
{
    return g_ptr_array_index(data->lines, number);
}

/* graph-texts.c: title, labels and names, as graph and runs are now. */
void graph_data_renew_texts(TinkerGraphData *data);

#endif
