/* The numbered pictures of a film: "1", "2", ... in the folder until they get their names. */
#include "common/film/film-pictures.h"

#include <errno.h>

#include <glib/gstdio.h>

#include "common/film/film.h"
#include "common/program/exit-status.h"
#include "files/unfinished.h"

struct _TinkerFilmPictures {
    char *path;
    TinkerUnfinished folder;
    int count;
};

static gboolean fail(const char *path, const char *reason, GError **error)
{
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: cannot be written: %s", path, reason);
    return FALSE;
}

char *tinker_film_pictures_name(const char *path, int number)
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name == NULL ? path : name, '.');
    gsize stem = dot == NULL ? strlen(path) : (gsize)(dot - path);
    return g_strdup_printf("%.*s-%04d.png", (int)stem, path, number);
}

TinkerFilmPictures *tinker_film_pictures_new(const char *path, GError **error)
{
    g_autofree char *parent = g_path_get_dirname(path);
    TinkerUnfinished folder;
    tinker_unfinished_clean(parent);
    if (!tinker_unfinished_folder(&folder, parent)) {
        fail(path, g_strerror(errno), error);
        return NULL;
    }
    TinkerFilmPictures *pictures = g_new0(TinkerFilmPictures, 1);
    pictures->path = g_strdup(path);
    pictures->folder = folder;
    return pictures;
}

/* (transfer full) */
static char *unfinished_name(const TinkerFilmPictures *pictures, int number)
{
    return g_strdup_printf("%s/%d", pictures->folder.path, number);
}

gboolean tinker_film_pictures_add(TinkerFilmPictures *pictures, cairo_surface_t *picture, GError **error)
{
    g_autofree char *unfinished = unfinished_name(pictures, ++pictures->count);
    g_autofree char *name = tinker_film_pictures_name(pictures->path, pictures->count);
    cairo_status_t status = cairo_surface_write_to_png(picture, unfinished);
    return status == CAIRO_STATUS_SUCCESS || fail(name, cairo_status_to_string(status), error);
}

gboolean tinker_film_pictures_finish(TinkerFilmPictures *pictures, GError **error)
{
    for (int number = 1; number <= pictures->count; number++) {
        g_autofree char *unfinished = unfinished_name(pictures, number);
        g_autofree char *name = tinker_film_pictures_name(pictures->path, number);
        if (g_rename(unfinished, name) != 0) return fail(name, g_strerror(errno), error);
    }
    return TRUE;
}

void tinker_film_pictures_free(TinkerFilmPictures *pictures)
{
    if (pictures == NULL) return;
    tinker_unfinished_clear(&pictures->folder);
    g_free(pictures->path);
    g_free(pictures);
}
