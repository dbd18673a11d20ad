/* A frame of its own is put through some times of the record. */
#include "gui/canvas/canvas-swept.h"

#include <math.h>

#include "render/picture/painter.h"

#define TIMES      60    /* that are looked at, */
#define MOST_BOXES 20000 /* and drawings at all of them together */
#define MOST_ADDED 400
#define SMALL_STEP 0.3  /* of a drawing's size: by less it is where it was */
#define MUCH_MORE  1.25 /* times what was recorded when a run that still goes on was looked at */

void tinker_swept_clear(TinkerSwept *swept)
{
    g_clear_pointer(&swept->boxes, g_array_unref);
}

static gboolean is_about(const double box[4], const double other[4])
{
    const double across = SMALL_STEP * (box[2] - box[0]), up = SMALL_STEP * (box[3] - box[1]);
    return fabs(box[0] - other[0]) <= across && fabs(box[2] - other[2]) <= across && fabs(box[1] - other[1]) <= up &&
           fabs(box[3] - other[3]) <= up;
}

/* Adds those that are elsewhere than they were when they were added last; with the first of these, where they began.
 */
static void add_moved(GArray *boxes, GArray *last, gboolean *have_moved, GArray *now)
{
    for (guint i = 0; i < now->len && i < last->len && boxes->len < MOST_ADDED; i++) {
        const double *box = (const double *)(gpointer)now->data + 4 * (gsize)i;
        double *before = (double *)(gpointer)last->data + 4 * (gsize)i;
        if (is_about(box, before)) continue;
        if (!have_moved[i]) g_array_append_vals(boxes, before, 1);
        have_moved[i] = TRUE;
        g_array_append_vals(boxes, box, 1);
        for (int k = 0; k < 4; k++)
            before[k] = box[k];
    }
}

static void look(GArray *boxes, TinkerPlayer *player, double reached, const TinkerView *view)
{
    TinkerFrame *shown = tinker_player_frame(player), *frame;
    if (shown == NULL || !(reached > 0)) return;
    if ((frame = tinker_frame_new(tinker_frame_scene(shown), NULL)) == NULL) return;
    if (tinker_player_place(player, frame, 0)) {
        g_autoptr(GArray) last = tinker_painter_boxes(frame, view);
        g_autofree gboolean *have_moved = g_new0(gboolean, last->len + 1);
        const int times = MAX(MIN(TIMES, MOST_BOXES / MAX((int)last->len, 1)), 1);
        for (int i = 1; i <= times; i++) {
            if (!tinker_player_place(player, frame, reached * i / times)) continue;
            g_autoptr(GArray) now = tinker_painter_boxes(frame, view);
            add_moved(boxes, last, have_moved, now);
        }
    }
    tinker_frame_free(frame);
}

static gboolean is_known(const TinkerSwept *swept, TinkerPlayer *player, double reached)
{
    TinkerRunStatus status;
    const gboolean goes_on = tinker_player_status(player, &status) && !status.finished;
    return reached == swept->reached || (goes_on && reached > swept->reached && reached < MUCH_MORE * swept->reached);
}

const GArray *tinker_swept_boxes(TinkerSwept *swept, TinkerDocument *document, TinkerPlayer *player,
                                 const TinkerView *view)
{
    const guint64 revision = tinker_history_revision(tinker_document_history(document));
    const guint generation = tinker_player_generation(player);
    const double reached = tinker_player_reached(player);
    if (swept->boxes != NULL && swept->revision == revision && swept->generation == generation &&
        swept->scale == view->scale && is_known(swept, player, reached))
        return swept->boxes;
    tinker_swept_clear(swept);
    *swept = (TinkerSwept){
        g_array_new(FALSE, FALSE, 4 * sizeof(double)), revision, generation, reached, view->scale, swept->looked + 1};
    look(swept->boxes, player, reached, view);
    return swept->boxes;
}
