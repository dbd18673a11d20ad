/* Films: pictures of the same size in order, joined to a GIF, WebM or MP4 by the ffmpeg program where it is installed,
 * else written as numbered PNG files. */
#ifndef TINKER_CLI_FILM_H
#define TINKER_CLI_FILM_H

#include <cairo.h>
#include <glib.h>

typedef struct _TinkerFilm TinkerFilm;

/* Whether films can be joined here. */
gboolean tinker_film_can_join(void);

/* Begins the film `path`. Its ending says what is written: .gif, .webm, .mp4, or .png for numbered pictures; without
 * ffmpeg the pictures are numbered whatever it is. (transfer full) */
TinkerFilm *tinker_film_new(const char *path, int width, int height, double frames_per_second, GError **error);

/* The next picture: an image surface of format RGB24 and of the film's size. */
gboolean tinker_film_add(TinkerFilm *film, cairo_surface_t *picture, GError **error);

/* Waits until the film is written. A film that failed is removed. */
gboolean tinker_film_finish(TinkerFilm *film, GError **error);

/* Name of the numbered picture `number`, from 1: "motion-0001.png" for "motion.gif". (transfer full) */
char *tinker_film_picture_name(const char *path, int number);

void tinker_film_free(TinkerFilm *film);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFilm, tinker_film_free)

#endif
