/* The numbered pictures of a film. They lie in a folder beside their places until all are there, so that one that is
 * given up leaves nothing, and those of a film that was there before stay. */
#ifndef TINKER_HOST_FILM_PICTURES_H
#define TINKER_HOST_FILM_PICTURES_H

#include <cairo.h>
#include <glib.h>

typedef struct _TinkerFilmPictures TinkerFilmPictures;

/* Name of the numbered picture `number`, from 1: "motion-0001.png" for "motion.gif". (transfer full) */
char *tinker_film_pictures_name(const char *path, int number);

/* For a film of this path; the names are those of tinker_film_pictures_name. NULL with TINKER_CLI_ERROR_FILE.
 * (transfer full) */
TinkerFilmPictures *tinker_film_pictures_new(const char *path, GError **error);

gboolean tinker_film_pictures_add(TinkerFilmPictures *pictures, cairo_surface_t *picture, GError **error);

/* Puts all in their places, in order. Where one cannot be, those before it are there already. */
gboolean tinker_film_pictures_finish(TinkerFilmPictures *pictures, GError **error);

/* Removes what is not in its place. */
void tinker_film_pictures_free(TinkerFilmPictures *pictures);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFilmPictures, tinker_film_pictures_free)

#endif
