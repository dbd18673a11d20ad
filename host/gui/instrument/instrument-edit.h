/* Changes of the list of controls and meters, each as one step for undo. No widget. */
#ifndef TINKER_GUI_INSTRUMENT_EDIT_H
#define TINKER_GUI_INSTRUMENT_EDIT_H

#include "gui/document/document.h"

/* Where a new one stands (m), and whether it makes way for blocks, since no run was known when the place was chosen. */
typedef struct {
    double at[2];
    gboolean makes_way;
} TinkerInstrumentPlace;

/* Adds a control of a number of a block, "stiffness" or "velocity.x", with a range about its value and a round
 * step; what is on or off gets a switch. `place` may be NULL. */
gboolean tinker_control_add(TinkerDocument *document, TinkerBlockId block, const char *name,
                            const TinkerInstrumentPlace *place, GError **error);
/* Adds a meter of a quantity; of the scene where `block` is TINKER_NO_BLOCK. */
gboolean tinker_meter_add(TinkerDocument *document, TinkerBlockId block, const char *quantity,
                          const TinkerInstrumentPlace *place, GError **error);
void tinker_instrument_remove(TinkerDocument *document, int number);
/* To a place (m) of the user's, from which it makes no way any more. */
void tinker_instrument_move(TinkerDocument *document, int number, const double place[2], const char *merge);
void tinker_instrument_set_kind(TinkerDocument *document, int number, TinkerInstrumentKind kind);
gboolean tinker_instrument_set_range(TinkerDocument *document, int number, double from, double to, double step,
                                     GError **error);

/* The kind as people read it. Borrowed. */
const char *tinker_instrument_kind_title(TinkerInstrumentKind kind);

/* "Spring 0: Stiffness". (transfer full) */
char *tinker_instrument_title(const TinkerScene *scene, const TinkerSceneInstrument *instrument);
/* The unit that it is shown in; "" for none. Static or interned. */
const char *tinker_instrument_unit(TinkerScene *scene, const TinkerSceneInstrument *instrument);

#endif
