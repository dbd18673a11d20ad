/* Makes a film of a scene, in a thread. No widget. Signals:
 *   "changed"     it began or ended
 *   "progress"    further than before
 */
#ifndef TINKER_GUI_FILM_TASK_H
#define TINKER_GUI_FILM_TASK_H

#include <glib-object.h>

#include "common/film/film-arrows.h"
#include "scene/store/scene.h"

#define TINKER_TYPE_FILM_TASK (tinker_film_task_get_type())
G_DECLARE_FINAL_TYPE(TinkerFilmTask, tinker_film_task, TINKER, FILM_TASK, GObject)

/* What the film is to be. */
typedef struct {
    const char *path;         /* its ending says what is written; see film.h */
    int width, height;        /* pixels */
    double frames_per_second; /* of the film */
    double speed;             /* times real time */
    gboolean show_labels, show_grid, show_graphs;
    gboolean show_trails;   /* with marks at times that suit the duration */
    TinkerFilmOverlay over; /* its marks are not looked at */
} TinkerFilmSettings;

typedef enum {
    TINKER_FILM_NONE, /* not asked for yet */
    TINKER_FILM_UNDER_WAY,
    TINKER_FILM_WRITTEN,
    TINKER_FILM_CUT_SHORT, /* written, but the run failed: as far as it is to be believed */
    TINKER_FILM_CANCELLED, /* nothing is left of it */
    TINKER_FILM_FAILED,    /* likewise */
} TinkerFilmState;

/* How many pictures a film of so long a run (s) has. */
double tinker_film_settings_pictures(const TinkerFilmSettings *settings, double duration);

/* (transfer full) */
TinkerFilmTask *tinker_film_task_new(void);

/* Begins, on a copy of the scene as it is now. One that is under way is given up. Settings are copied. */
void tinker_film_task_start(TinkerFilmTask *task, TinkerScene *scene, const TinkerFilmSettings *settings);
/* Gives it up soon. */
void tinker_film_task_cancel(TinkerFilmTask *task);

TinkerFilmState tinker_film_task_state(TinkerFilmTask *task);
/* Share of the work that is done, 0 to 1; at 1 the film still has to be joined. */
double tinker_film_task_progress(TinkerFilmTask *task);
/* Of the film that was asked for last. Borrowed until the next start. */
const char *tinker_film_task_path(TinkerFilmTask *task);
/* Why it failed or was cut short, or NULL. Borrowed until the next start. */
const char *tinker_film_task_failure(TinkerFilmTask *task);
/* The condition of the scene that ended the film that was written last, or NULL. Borrowed until the next start. */
const char *tinker_film_task_stopped_by(TinkerFilmTask *task);

#endif
