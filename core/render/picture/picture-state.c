/* What a picture shows by default, and the state that a block is drawn in. */
#include "render/picture/painter-private.h"

uint32_t tinker_picture_state(const TinkerPicture *picture, const TinkerPiece *piece)
{
    uint32_t state = 0;
    for (int32_t end = 0; end < piece->instance.ends; end++)
        if (!piece->instance.end[end].attached) state |= TINKER_STATE_DETACHED;
    if (picture->selected != NULL && picture->selected[piece->block]) state |= TINKER_STATE_SELECTED;
    if (picture->options->highlighted == piece->block) state |= TINKER_STATE_HIGHLIGHTED;
    return state;
}

TinkerPaintOptions tinker_paint_options_default(void)
{
    return (TinkerPaintOptions){
        .theme = tinker_theme_find("light"), .show_grid = TRUE, .show_labels = TRUE, .highlighted = TINKER_NO_BLOCK};
}
