/* What a film shows over its pictures: forces, velocities, accelerations and net forces as arrows, each kind in one
 * scale for the whole film, and the paths of bodies, with marks at equal times, up to the picture. */
#ifndef TINKER_HOST_FILM_ARROWS_H
#define TINKER_HOST_FILM_ARROWS_H

#include "common/overlay/motion-trail.h"
#include "common/overlay/motion-vectors.h"
#include "physics/run/acting-forces.h"
#include "physics/run/simulation.h"

/* What is wanted. */
typedef struct {
    gboolean forces;
    TinkerVectorChoice vectors;
    double marks; /* s between the marks of paths; 0: no paths */
} TinkerFilmOverlay;

gboolean tinker_film_overlay_any(const TinkerFilmOverlay *overlay);

typedef struct _TinkerFilmArrows TinkerFilmArrows;

/* Of the model that is run, and of its scene, borrowed until the last sample and until it is freed. (transfer full) */
TinkerFilmArrows *tinker_film_arrows_new(TinkerModel *model, TinkerScene *scene, const TinkerFilmOverlay *overlay);
void tinker_film_arrows_free(TinkerFilmArrows *arrows);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFilmArrows, tinker_film_arrows_free)

/* At a sample, with the frame at its places: a point of the paths; */
void tinker_film_arrows_note(TinkerFilmArrows *arrows, const TinkerFrame *frame);
/* and where the sample is a picture, its forces and vectors. */
gboolean tinker_film_arrows_add(TinkerFilmArrows *arrows, TinkerSimulation *simulation, TinkerFrame *frame,
                                GError **error);
/* Forgets all pictures but the first `count`, and with all of them the paths. */
void tinker_film_arrows_cut(TinkerFilmArrows *arrows, gsize count);

/* Lets a picture be drawn with what belongs over it, as far as the frame's time; options are valid until the next. */
void tinker_film_arrows_dress(TinkerFilmArrows *arrows, gsize picture, TinkerFrame *frame, TinkerPaintOptions *paint);

#endif
