/* A frame of its own is put through some times of the record. */
#include "gui/canvas/canvas-swept.h"

#include <math.h>

#include "render/picture/painter.h"

#define TIMES      60    /* that are looked at, */
#define MOST_BOXES 20000 /* and drawings at all of them together */
#define MOST_ADDED 400
#define SMALL_STEP 0.3 /* of a drawing's size: by less it is where it was */

static gboolean is_about(const double box[4], const double other[4])
{
    const double across = SMALL_STEP * (box[2] - box[0]), up = SMALL_STEP * (box[3] - box[1]);
    return fabs(box[0] - other[0]) <= across && fabs(box[2] - other[2]) <= across && fabs(box[1] - other[1]) <= up &&
           fabs(box[3] - other[3]) <= up;
}

/* Adds those that are elsewhere than they were when they were added last. */
static void add_moved(GArray *swept, GArray *last, GArray *now)
{
    for (guint i = 0; i < now->len && i < last->len && swept->len < MOST_ADDED; i++) {
        const double *box = (const double *)(gpointer)now->data + 4 * (gsize)i;
        double *before = (double *)(gpointer)last->data + 4 * (gsize)i;
        if (is_about(box, before)) continue;
        g_array_append_vals(swept, box, 1);
        for (int k = 0; k < 4; k++)
            before[k] = box[k];
    }
}

GArray *tinker_swept_boxes(TinkerPlayer *player, const TinkerView *view)
{
    GArray *swept = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    TinkerFrame *shown = tinker_player_frame(player), *frame;
    const double reached = tinker_player_reached(player);
    if (shown == NULL || !(reached > 0)) return swept;
    g_autoptr(GArray) last = tinker_painter_boxes(shown, view);
    const int times = MIN(TIMES, MOST_BOXES / MAX((int)last->len, 1));
    if ((frame = tinker_frame_new(tinker_frame_scene(shown), NULL)) == NULL) return swept;
    for (int i = 0; i <= times; i++) {
        if (!tinker_player_place(player, frame, reached * i / MAX(times, 1))) continue;
        g_autoptr(GArray) now = tinker_painter_boxes(frame, view);
        add_moved(swept, last, now);
    }
    tinker_frame_free(frame);
    return swept;
}
