/* Bodies that lay on a top by their own position, and stayed where they were when it was moved or turned: they hang in
 * the air now, which hardly anybody wants. Bodies that were laid on it (tinker_scene_lies_on) go along. Signal:
 * "changed". */
#ifndef TINKER_GUI_LEFT_BEHIND_H
#define TINKER_GUI_LEFT_BEHIND_H

#include "gui/document/document.h"

#define TINKER_TYPE_LEFT_BEHIND (tinker_left_behind_get_type())
G_DECLARE_FINAL_TYPE(TinkerLeftBehind, tinker_left_behind, TINKER, LEFT_BEHIND, GObject)

typedef struct {
    TinkerBlockId body, plate;
    double along;    /* m: where it lay on the top */
    double place[2]; /* m: where it is */
} TinkerLying;

/* Takes a reference. (transfer full) */
TinkerLeftBehind *tinker_left_behind_new(TinkerDocument *document);

/* Of TinkerLying: both blocks are there. Borrowed, valid until "changed". */
const GArray *tinker_left_behind_bodies(TinkerLeftBehind *left);

/* Lays the body back where it lay on the top, as one step for undo. */
gboolean tinker_left_behind_lay(TinkerDocument *document, const TinkerLying *lying, GError **error);

#endif
