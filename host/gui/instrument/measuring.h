/* A distance or an angle that is measured on the canvas between places, which may be points of bodies. No widget. */
#ifndef TINKER_GUI_MEASURING_H
#define TINKER_GUI_MEASURING_H

#include "gui/document/document.h"
#include "scene/frame/frame.h"

typedef enum { TINKER_RULER, TINKER_PROTRACTOR } TinkerMeasuringKind;

/* The places in the order in which they are taken: of a ruler its two ends; of a protractor the corner, and a place on
 * either leg. An end on no block stays at a place of the world. */
typedef struct {
    TinkerMeasuringKind kind;
    TinkerSceneEnd ends[3];
    int count; /* of ends that are known */
} TinkerMeasuring;

/* How many ends it takes. */
int tinker_measuring_whole(TinkerMeasuringKind kind);

/* The points that can be measured from, of TinkerSceneEnd: centres of bodies and supports, corners of those that turn
 * or stand, and ends of connectors. (transfer full) */
GArray *tinker_measuring_points(TinkerScene *scene);

/* The nearest of them within `reach` (m), else the place on the grid (m; 0: as it is). */
TinkerSceneEnd tinker_measuring_snap(const TinkerFrame *frame, double x, double y, double reach, double grid);

/* "2.500 m, Δx = 2.000 m, Δy = 1.500 m, 36.87°", not in full "2.500 m"; "36.87°" in the frame; NULL as long as it is
 * not whole. (transfer full) */
char *tinker_measuring_text(const TinkerMeasuring *measuring, const TinkerFrame *frame, gboolean in_full);

/* What keeps it from becoming a block: nothing is measured, or an end is on no block. NULL: nothing does. Borrowed. */
const char *tinker_measuring_why_not_kept(const TinkerMeasuring *measuring, TinkerScene *scene);
/* Makes a block of it, which is selected: one step for undo. FALSE where an end is on no block, or the error says why.
 */
gboolean tinker_measuring_keep(const TinkerMeasuring *measuring, TinkerDocument *document, GError **error);

#endif
