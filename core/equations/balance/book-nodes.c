#include "equations/balance/book-nodes-private.h"

#include <float.h>
#include <math.h>

#define POINTS 8
#define BEFORE 64 /* last digits of a time before it */

/* Half of the points on [-1, 1]; the others mirror them. */
static const double places[POINTS / 2] = {0.1834346424956498049394761, 0.5255324099163289858177390,
                                          0.7966664774136267395915539, 0.9602898564975362316835609};
static const double weights[POINTS / 2] = {0.3626837833783619829651504, 0.3137066458778872873379622,
                                           0.2223810344533744705443560, 0.1012285362903762591525314};

static void add(GArray *nodes, double time, double weight, TinkerNodeKind kind)
{
    const TinkerBookNode node = {time, weight, kind, time};
    g_array_append_val(nodes, node);
}

static void add_panel(GArray *nodes, double from, double to)
{
    const double middle = from + (to - from) / 2, half = (to - from) / 2;
    for (int i = -POINTS / 2; i < POINTS / 2; i++) {
        const int k = i < 0 ? -i - 1 : i;
        add(nodes, middle + (i < 0 ? -1 : 1) * places[k] * half, weights[k] * half, TINKER_NODE_INSIDE);
    }
}

GArray *tinker_book_nodes(double from, double to, const GArray *cuts, gboolean jump, int panels)
{
    GArray *nodes = g_array_new(FALSE, FALSE, sizeof(TinkerBookNode));
    double begin = from;
    add(nodes, from, 0, TINKER_NODE_START);
    for (guint i = 0; i <= cuts->len; i++) {
        const gboolean last = i == cuts->len;
        const TinkerBookCut cut = last ? (TinkerBookCut){to, to} : g_array_index(cuts, TinkerBookCut, i);
        const double end = cut.first;
        const int count = MAX(1, (int)ceil(panels * (end - begin) / (to - from)));
        for (int k = 0; k < count; k++)
            add_panel(nodes, begin + (end - begin) * k / count, begin + (end - begin) * (k + 1) / count);
        if (!last && jump) add(nodes, end - BEFORE * DBL_EPSILON * fabs(end), 0, TINKER_NODE_BEFORE);
        if (last || jump) add(nodes, cut.last, 0, last ? TINKER_NODE_END : TINKER_NODE_AFTER);
        g_array_index(nodes, TinkerBookNode, nodes->len - 1).since = end;
        begin = cut.last;
    }
    return nodes;
}
