/* Films: pictures of the same size in order, joined to a GIF, WebM or MP4 by the ffmpeg program, or written as numbered
 * PNG files. A film is written beside its place and put there when it is whole: what is given up or fails leaves
 * nothing, and a film that was there before stays as it was. */
#ifndef TINKER_HOST_FILM_H
#define TINKER_HOST_FILM_H

#include <cairo.h>

#include "common/program/file-set.h"

typedef struct _TinkerFilm TinkerFilm;

/* Whether films can be joined here. */
gboolean tinker_film_can_join(void);

/* Whether the film of this path is one file, which ffmpeg joins; else it becomes numbered pictures. */
gboolean tinker_film_is_joined(const char *path);

/* Begins the film `path`. Its ending says what is written: .gif, .webm, .mp4, or .png for numbered pictures.
 * (transfer full) */
TinkerFilm *tinker_film_new(const char *path, int width, int height, double frames_per_second, GError **error);

/* Asked often, from then on: where it answers TRUE, the call under way fails with TINKER_CLI_ERROR_STOPPED. */
void tinker_film_set_cancelled(TinkerFilm *film, gboolean (*cancelled)(void *data), void *data);

/* The next picture: an image surface of format RGB24 and of the film's size. */
gboolean tinker_film_add(TinkerFilm *film, cairo_surface_t *picture, GError **error);

/* Waits until the film is written, and puts it in its place. */
gboolean tinker_film_finish(TinkerFilm *film, GError **error);

/* Adds what a film of `count` pictures writes to a command's files; see tinker_file_set_add_output. */
gboolean tinker_film_add_outputs(TinkerFileSet *files, const char *option, const char *path, double count,
                                 GError **error);

/* Gives up a film that was not finished: nothing of it is left. */
void tinker_film_free(TinkerFilm *film);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFilm, tinker_film_free)

/* Whether a path ends in ".png" or the like, in capitals or not. */
gboolean tinker_path_has_ending(const char *path, const char *ending);

#endif
