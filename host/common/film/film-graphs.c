/* A record of its own of the quantities: the times, and a series of values for each column, in displayed units. */
#include "common/film/film-graphs.h"

#include "common/graph/graph-axis.h"
#include "common/graph/graph-names.h"
#include "render/plot/plot.h"
#include "scene/store/quantities.h"

#define MOST        3   /* graphs: of more, none could be read */
#define MOST_CURVES 8   /* of one */
#define SHARE       0.4 /* of a picture's height */

typedef struct {
    int count;
    int columns[MOST_CURVES];  /* numbers */
    char *labels[MOST_CURVES]; /* in the legend */
    char *title, *x_label, *y_label;
} Graph;

struct _TinkerFilmGraphs {
    TinkerScene *scene;
    TinkerTextFunc translate; /* NULL: texts are English */
    GArray *columns;          /* of TinkerColumn */
    GArray *axes;             /* of TinkerGraphAxis: of each column */
    GArray *times;            /* of double */
    GPtrArray *series;        /* of GArray of double: of each column */
    Graph graphs[MOST];
    int count;
};

static const char *in_language(const TinkerFilmGraphs *graphs, const char *text)
{
    return graphs->translate != NULL ? graphs->translate(text) : text;
}

static void name_curves(const TinkerFilmGraphs *graphs, const TinkerSceneGraph *from, Graph *graph)
{
    TinkerCurveName names[MOST_CURVES];
    const guint count = (guint)graph->count;
    for (guint i = 0; i < count; i++) {
        const TinkerGraphAxis *axis = &g_array_index(graphs->axes, TinkerGraphAxis, graph->columns[i]);
        names[i] = (TinkerCurveName){tinker_scene_owner_name(graphs->scene, axis->block), axis->title};
    }
    for (guint i = 0; i < count; i++)
        graph->labels[i] = tinker_curve_legend(&names[i], names, count);
    const gboolean has_title = from->title != NULL && from->title[0] != '\0';
    graph->title = has_title ? g_strdup(from->title) : tinker_curves_title(names, count);
}

/* Takes the curves that are quantities; FALSE where there are none. */
static gboolean take_graph(TinkerFilmGraphs *graphs, const TinkerSceneGraph *from, Graph *graph)
{
    *graph = (Graph){0};
    if (!g_str_equal(from->against, "time")) return FALSE;
    for (guint i = 0; i < from->curves->len && graph->count < MOST_CURVES; i++) {
        const TinkerSceneCurve *curve = g_ptr_array_index(from->curves, i);
        TinkerBlockId block;
        if (curve->block == NULL || !tinker_scene_find_owner(graphs->scene, curve->block, &block)) continue;
        const int32_t quantity = tinker_scene_find_quantity(graphs->scene, block, curve->quantity);
        if (quantity < 0) continue;
        TinkerGraphAxis axis = tinker_graph_axis(graphs->scene, block, quantity);
        axis.title = in_language(graphs, axis.title);
        graph->columns[graph->count++] = (int)graphs->columns->len;
        tinker_columns_add_quantity(graphs->columns, graphs->scene, block, quantity);
        g_array_append_val(graphs->axes, axis);
        g_ptr_array_add(graphs->series, g_array_new(FALSE, FALSE, sizeof(double)));
    }
    if (graph->count == 0) return FALSE;
    const TinkerGraphAxis time = tinker_graph_axis_time();
    graph->x_label = tinker_axis_label(in_language(graphs, time.title), time.unit);
    name_curves(graphs, from, graph);
    graph->y_label =
        tinker_graph_axes_label(&g_array_index(graphs->axes, TinkerGraphAxis, graph->columns[0]), (guint)graph->count);
    return TRUE;
}

TinkerFilmGraphs *tinker_film_graphs_new(TinkerScene *scene, TinkerTextFunc translate)
{
    TinkerFilmGraphs *graphs = g_new0(TinkerFilmGraphs, 1);
    GPtrArray *all = tinker_scene_graphs(scene);
    graphs->scene = scene;
    graphs->translate = translate;
    graphs->columns = tinker_columns_new();
    graphs->axes = g_array_new(FALSE, FALSE, sizeof(TinkerGraphAxis));
    graphs->times = g_array_new(FALSE, FALSE, sizeof(double));
    graphs->series = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    for (guint i = 0; i < all->len && graphs->count < MOST; i++)
        graphs->count += take_graph(graphs, g_ptr_array_index(all, i), &graphs->graphs[graphs->count]);
    if (graphs->count > 0) return graphs;
    tinker_film_graphs_free(graphs);
    return NULL;
}

void tinker_film_graphs_free(TinkerFilmGraphs *graphs)
{
    if (graphs == NULL) return;
    for (int i = 0; i < graphs->count; i++) {
        g_free(graphs->graphs[i].title);
        g_free(graphs->graphs[i].x_label);
        g_free(graphs->graphs[i].y_label);
        for (int k = 0; k < graphs->graphs[i].count; k++)
            g_free(graphs->graphs[i].labels[k]);
    }
    g_array_unref(graphs->columns);
    g_array_unref(graphs->axes);
    g_array_unref(graphs->times);
    g_ptr_array_unref(graphs->series);
    g_free(graphs);
}

const GArray *tinker_film_graphs_columns(const TinkerFilmGraphs *graphs)
{
    return graphs->columns;
}

void tinker_film_graphs_add(TinkerFilmGraphs *graphs, double time, const double *values)
{
    g_array_append_val(graphs->times, time);
    for (guint i = 0; i < graphs->series->len; i++) {
        const double shown = values[i] * g_array_index(graphs->axes, TinkerGraphAxis, i).per_si;
        g_array_append_val(g_ptr_array_index(graphs->series, i), shown);
    }
}

void tinker_film_graphs_cut(TinkerFilmGraphs *graphs, gsize count)
{
    if (count >= graphs->times->len) return;
    g_array_set_size(graphs->times, (guint)count);
    for (guint i = 0; i < graphs->series->len; i++)
        g_array_set_size(g_ptr_array_index(graphs->series, i), (guint)count);
}

double tinker_film_graphs_height(double height)
{
    return SHARE * height;
}

static void draw_graph(const TinkerFilmGraphs *graphs, const Graph *graph, cairo_t *cairo, const TinkerTheme *theme,
                       double width, double height, double now)
{
    TinkerCurve curves[MOST_CURVES] = {0};
    for (int i = 0; i < graph->count; i++) {
        const int column = graph->columns[i];
        const GArray *values = g_ptr_array_index(graphs->series, (guint)column);
        curves[i] = (TinkerCurve){
            .label = graph->count > 1 ? graph->labels[i] : NULL,
            .x = (const double *)(gpointer)graphs->times->data,
            .y = (const double *)(gpointer)values->data,
            .count = values->len,
            .colour = i,
        };
    }
    const TinkerPlot plot = {
        .title = graph->title,
        .x_label = graph->x_label,
        .y_label = graph->y_label,
        .curves = curves,
        .curve_count = graph->count,
        .theme = theme,
        .compact = TRUE,
        .cursor = &now,
    };
    tinker_plot_draw(cairo, &plot, width, height);
}

void tinker_film_graphs_draw(const TinkerFilmGraphs *graphs, cairo_t *cairo, const TinkerTheme *theme, double width,
                             double height, double now)
{
    const double each = width / graphs->count;
    for (int i = 0; i < graphs->count; i++) {
        cairo_save(cairo);
        cairo_translate(cairo, i * each, 0);
        cairo_rectangle(cairo, 0, 0, each, height);
        cairo_clip(cairo);
        draw_graph(graphs, &graphs->graphs[i], cairo, theme, each, height, now);
        cairo_restore(cairo);
    }
}
