/* A graph comes to the front as a copy behind the last one of the list, whose original is then removed. */
#include "gui/curve/graph-edit.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#define MARGIN    16.0 /* widget units, of a new graph to the border and to others */
#define GAP       8.0
#define NEAR_GAP  2.0 /* about what moves out of the way of others, */
#define NEAR_STEP 6.0 /* and how finely a place for it is looked for */
#define STEPS     12  /* places that are tried along each side */

static const TinkerSceneGraph *graph_of(TinkerDocument *document, int number)
{
    return g_ptr_array_index(tinker_scene_graphs(tinker_document_scene(document)), number);
}

int tinker_graph_add(TinkerDocument *document, TinkerBlockId block, const char *quantity, const char *against,
                     const double place[2], const double size[2], GError **error)
{
    g_autoptr(TinkerSceneGraph) graph = tinker_scene_graph_new();
    tinker_scene_graph_add(graph, tinker_scene_block_name(tinker_document_scene(document), block), quantity);
    if (against != NULL) {
        g_free(graph->against);
        graph->against = g_strdup(against);
    }
    graph->has_place = place != NULL;
    graph->has_size = size != NULL;
    if (place != NULL) memcpy(graph->place, place, sizeof graph->place);
    if (size != NULL) memcpy(graph->size, size, sizeof graph->size);
    tinker_document_begin(document, _("Add Graph"), NULL);
    int32_t number = tinker_history_add_graph(tinker_document_history(document), graph, error);
    tinker_document_end(document);
    return number;
}

void tinker_graph_remove(TinkerDocument *document, int number)
{
    tinker_document_begin(document, _("Delete Graph"), NULL);
    tinker_history_remove_graph(tinker_document_history(document), number);
    tinker_document_end(document);
}

static gboolean same_pair(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

int tinker_graph_move(TinkerDocument *document, int number, const double place[2], const double size[2],
                      gboolean in_front, const char *merge)
{
    const TinkerSceneGraph *before = graph_of(document, number);
    int last = (int)tinker_scene_graphs(tinker_document_scene(document))->len - 1;
    gboolean moved = place != NULL && !(before->has_place && same_pair(place, before->place));
    gboolean resized = size != NULL && !(before->has_size && same_pair(size, before->size));
    gboolean raised = in_front && number != last;
    if (!moved && !resized && !raised) return number;
    /* The texts are the original's, and copied by the history. */
    TinkerSceneGraph graph = *before;
    if (place != NULL) memcpy(graph.place, place, sizeof graph.place);
    if (size != NULL) memcpy(graph.size, size, sizeof graph.size);
    graph.has_place |= place != NULL;
    graph.has_size |= size != NULL;
    TinkerHistory *history = tinker_document_history(document);
    const char *title = resized ? _("Resize Graph") : moved ? _("Move Graph") : _("Raise Graph");
    tinker_document_begin(document, title, merge);
    if (!raised) {
        tinker_history_change_graph(history, number, &graph, NULL);
    } else if (tinker_history_add_graph(history, &graph, NULL) >= 0) {
        tinker_history_remove_graph(history, number);
        number = last;
    }
    tinker_document_end(document);
    return number;
}

void tinker_graph_dock(TinkerDocument *document, int number)
{
    TinkerSceneGraph graph = *graph_of(document, number);
    if (!graph.has_place) return;
    graph.has_place = FALSE;
    tinker_document_begin(document, _("Dock Graph"), NULL);
    tinker_history_change_graph(tinker_document_history(document), number, &graph, NULL);
    tinker_document_end(document);
}

/* Curves ----------------------------------------------------------------------------------------------------------- */

static gboolean change(TinkerDocument *document, int number, const TinkerSceneGraph *graph, GError **error)
{
    tinker_document_begin(document, _("Change Graph"), NULL);
    const gboolean done = tinker_history_change_graph(tinker_document_history(document), number, graph, error);
    tinker_document_end(document);
    return done;
}

gboolean tinker_graph_add_curve(TinkerDocument *document, int number, const TinkerSceneCurve *curve, GError **error)
{
    g_autoptr(TinkerSceneGraph) graph = tinker_scene_graph_copy(graph_of(document, number));
    TinkerSceneCurve *added = tinker_scene_graph_add(graph, NULL, NULL);
    added->block = g_strdup(curve->block);
    added->quantity = g_strdup(curve->quantity);
    added->expression = g_strdup(curve->expression);
    added->table = g_strdup(curve->table);
    added->title = g_strdup(curve->title);
    added->unit = g_strdup(curve->unit);
    added->column = curve->column;
    added->time_column = curve->time_column;
    added->axis = curve->axis;
    return change(document, number, graph, error);
}

gboolean tinker_graph_remove_curve(TinkerDocument *document, int number, guint curve, GError **error)
{
    g_autoptr(TinkerSceneGraph) graph = tinker_scene_graph_copy(graph_of(document, number));
    if (graph->curves->len < 2) return TRUE;
    g_ptr_array_remove_index(graph->curves, curve);
    return change(document, number, graph, error);
}

gboolean tinker_graph_set_curve_axis(TinkerDocument *document, int number, guint curve, int axis, GError **error)
{
    g_autoptr(TinkerSceneGraph) graph = tinker_scene_graph_copy(graph_of(document, number));
    ((TinkerSceneCurve *)g_ptr_array_index(graph->curves, curve))->axis = axis;
    return change(document, number, graph, error);
}

gboolean tinker_graph_set_logarithmic(TinkerDocument *document, int number, int axis, gboolean logarithmic,
                                      GError **error)
{
    g_autoptr(TinkerSceneGraph) graph = tinker_scene_graph_copy(graph_of(document, number));
    graph->logarithmic[axis] = logarithmic;
    return change(document, number, graph, error);
}

gboolean tinker_graph_set_against(TinkerDocument *document, int number, const char *against, GError **error)
{
    g_autoptr(TinkerSceneGraph) graph = tinker_scene_graph_copy(graph_of(document, number));
    g_free(graph->against);
    graph->against = g_strdup(against);
    for (int axis = 0; axis < 2; axis++)
        graph->has_range[axis] = graph->logarithmic[axis] = FALSE;
    return change(document, number, graph, error);
}

/* Room ------------------------------------------------------------------------------------------------------------- */

static double covered(const TinkerGraphBox *a, const TinkerGraphBox *b)
{
    double width = fmin(a->x + a->width, b->x + b->width) - fmax(a->x, b->x);
    double height = fmin(a->y + a->height, b->y + b->height) - fmax(a->y, b->y);
    return width > 0 && height > 0 ? width * height : 0;
}

static double covered_of_all(const TinkerGraphBox *box, const TinkerGraphBox *taken, int count)
{
    double sum = 0;
    for (int k = 0; k < count; k++)
        sum += covered(box, &taken[k]);
    return sum;
}

gboolean tinker_graph_move_to_room(TinkerGraphBox *box, double width, double height, const TinkerGraphBox *taken,
                                   int count)
{
    const double right = fmax(width - box->width - NEAR_GAP, 0), bottom = fmax(height - box->height - NEAR_GAP, 0);
    const TinkerGraphBox wanted = *box;
    double least = INFINITY;
    if (covered_of_all(box, taken, count) == 0) return TRUE;
    for (double x = fmin(NEAR_GAP, right); x <= right; x += NEAR_STEP)
        for (double y = fmin(NEAR_GAP, bottom); y <= bottom; y += NEAR_STEP) {
            const double away = hypot(x - wanted.x, y - wanted.y);
            const TinkerGraphBox around = {x - NEAR_GAP, y - NEAR_GAP, box->width + 2 * NEAR_GAP,
                                           box->height + 2 * NEAR_GAP};
            if (away >= least || covered_of_all(&around, taken, count) > 0) continue;
            least = away;
            box->x = x;
            box->y = y;
        }
    return isfinite(least);
}

void tinker_graph_find_room(TinkerGraphBox *box, double width, double height, const TinkerGraphBox *taken, int count)
{
    double right = fmax(width - box->width - MARGIN, 0), bottom = fmax(height - box->height - MARGIN, 0);
    double left = fmin(MARGIN, right), top = fmin(MARGIN, bottom), least = INFINITY;
    TinkerGraphBox best = *box;
    for (int i = 0; i < STEPS * STEPS; i++) {
        TinkerGraphBox tried = *box, around;
        tried.x = right - (right - left) * (i / STEPS) / (STEPS - 1);
        tried.y = top + (bottom - top) * (i % STEPS) / (STEPS - 1);
        around = (TinkerGraphBox){tried.x - GAP, tried.y - GAP, tried.width + 2 * GAP, tried.height + 2 * GAP};
        const double sum = covered_of_all(&around, taken, count);
        if (sum >= least) continue;
        least = sum;
        best = tried;
    }
    *box = best;
}
