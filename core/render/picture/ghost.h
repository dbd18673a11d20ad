/* A scene in two places at once: where it was in grey, where it is in colour, and arrows from one to the other. */
#ifndef TINKER_CORE_GHOST_H
#define TINKER_CORE_GHOST_H

#include "render/picture/painter.h"

typedef struct {
    TinkerFrame *from, *to; /* two frames of one scene */
    const char *caption;    /* beneath; may be NULL */
    gboolean arrows;
} TinkerGhost;

/* Draws it to .png, .svg or .pdf by the ending of `path`, both frames within the picture. Options as for a picture of
 * one frame; names stand beside the blocks as they are. */
gboolean tinker_ghost_to_file(const TinkerGhost *ghost, int width, int height, const TinkerPaintOptions *options,
                              const char *path, GError **error);

#endif
