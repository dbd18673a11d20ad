/* The motion of a scene as a film: one run records where the bodies are at every picture's time; then every picture is
 * drawn with one view, that of the box that holds all of them. */
#ifndef TINKER_HOST_MOTION_FILM_H
#define TINKER_HOST_MOTION_FILM_H

#include "common/film/film-arrows.h"
#include "common/film/film-graphs.h"
#include "physics/run/simulation.h"
#include "render/picture/painter.h"

/* A film of more pictures, an hour long, is a slip: a speed or rate of the wrong size. */
#define TINKER_MOTION_FILM_MOST_PICTURES 100000

typedef struct _TinkerMotionFilm TinkerMotionFilm;

/* The scene must stay as it is until the motion is freed. (transfer full) */
TinkerMotionFilm *tinker_motion_film_new(TinkerScene *scene, GError **error);
void tinker_motion_film_free(TinkerMotionFilm *motion);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerMotionFilm, tinker_motion_film_free)

/* What the pictures show beside the blocks, and one picture every `spacing` (s): answers the interval at which the run
 * is to be sampled. Where paths are shown there are samples between the pictures, too. To be called before the run. */
double tinker_motion_film_show(TinkerMotionFilm *motion, const TinkerFilmOverlay *overlay, double spacing);
/* The model that is run, borrowed until the last sample, and when its run ends (s). To be called before the run. */
void tinker_motion_film_begin(TinkerMotionFilm *motion, TinkerModel *model, double end);

/* The pictures show the scene's graphs, too, below the motion, if it has any over time, with their texts translated
 * (NULL: in English). To be called before the run, which is to record the columns below. */
void tinker_motion_film_show_graphs(TinkerMotionFilm *motion, TinkerTextFunc translate);
/* What the run is to record, of TinkerColumn; NULL: nothing. Borrowed. */
const GArray *tinker_motion_film_columns(const TinkerMotionFilm *motion);

/* A TinkerSampleFunc with a TinkerMotionFilm as its data: takes a picture's places from a run of the scene. */
gboolean tinker_motion_film_sample(TinkerSimulation *simulation, double time, const double *values, void *motion,
                                   GError **error);

/* A TinkerSampleTaker's other function: forgets all pictures, since the run begins again. */
void tinker_motion_film_begin_again(void *motion);

/* Forgets what a failed run is not to be believed in: all after this time (s). Answers how many pictures there are. */
gsize tinker_motion_film_cut(TinkerMotionFilm *motion, double valid_until);

/* How a motion is drawn. */
typedef struct {
    const char *path;                  /* of the film; see film.h */
    int width, height;                 /* pixels */
    double frames_per_second;          /* of the film */
    TinkerPaintOptions paint;          /* its memory is the film's own */
    gboolean (*cancelled)(void *data); /* asked often; TRUE gives the film up, nothing is left. May be NULL */
    gboolean (*enough)(void *data);    /* asked before a picture; TRUE ends the film before it. May be NULL */
    void (*progress)(double done, double whole,
                     void *data); /* pictures; all are done before the last work of joining them */
    void *data;                   /* of the three */
} TinkerFilmDrawing;

/* Draws the motion as a film. `drawn` tells how many pictures it has. Errors: TINKER_CLI_ERROR_FILE, and
 * TINKER_CLI_ERROR_STOPPED where it was cancelled. */
gboolean tinker_motion_film_write(TinkerMotionFilm *motion, const TinkerFilmDrawing *drawing, gsize *drawn,
                                  GError **error);

#endif
