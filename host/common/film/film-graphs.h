/* The graphs of a scene in the pictures of its film: below the motion, side by side, each over the whole run, with a
 * line at the time of the picture. */
#ifndef TINKER_HOST_FILM_GRAPHS_H
#define TINKER_HOST_FILM_GRAPHS_H

#include <cairo.h>

#include "physics/record/columns.h"
#include "render/draw/theme.h"

typedef struct _TinkerFilmGraphs TinkerFilmGraphs;

/* A text in the language of whoever looks; it lives as long as the program. */
typedef const char *(*TinkerTextFunc)(const char *text);

/* Of the first graphs over time that show quantities, with their texts translated (NULL: in English); NULL where the
 * scene has none. (transfer full) */
TinkerFilmGraphs *tinker_film_graphs_new(TinkerScene *scene, TinkerTextFunc translate);
void tinker_film_graphs_free(TinkerFilmGraphs *graphs);

/* What a run is to record for them, of TinkerColumn. Borrowed. */
const GArray *tinker_film_graphs_columns(const TinkerFilmGraphs *graphs);
/* Takes a sample of these columns; forgets all but the first `count`. */
void tinker_film_graphs_add(TinkerFilmGraphs *graphs, double time, const double *values);
void tinker_film_graphs_cut(TinkerFilmGraphs *graphs, gsize count);

/* The height of a picture that is theirs, of `height`. */
double tinker_film_graphs_height(double height);
/* Draws them into the rectangle (0, 0, width, height), at the time `now` (s). */
void tinker_film_graphs_draw(const TinkerFilmGraphs *graphs, cairo_t *cairo, const TinkerTheme *theme, double width,
                             double height, double now);

#endif
