/* Films: raw frames down a pipe to ffmpeg, or numbered pictures. */
#include "film.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <glib/gstdio.h>

#include "exit-status.h"
#include "output.h"

struct _TinkerFilm {
    char *path;
    int width, height;
    int pictures; /* written as numbered files */
    gboolean joined;
    GPid encoder;
    int pipe; /* to the encoder; -1: closed */
};

gboolean tinker_film_can_join(void)
{
    g_autofree char *program = g_find_program_in_path("ffmpeg");
    return program != NULL;
}

char *tinker_film_picture_name(const char *path, int number)
{
    const char *name = strrchr(path, '/');
    const char *dot = strrchr(name == NULL ? path : name, '.');
    gsize stem = dot == NULL ? strlen(path) : (gsize)(dot - path);
    return g_strdup_printf("%.*s-%04d.png", (int)stem, path, number);
}

/* A GIF gets a palette of its own, made from all its pictures; films for players get even sides and the one pixel
 * format that all of them know. */
static const char *filter_for(const char *path)
{
    if (tinker_path_has_ending(path, ".gif"))
        return "split[a][b];[a]palettegen=reserve_transparent=0[p];[b][p]paletteuse=dither=none";
    return "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p";
}

static gboolean start_encoder(TinkerFilm *film, double frames_per_second, GError **error)
{
    char rate[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_dtostr(rate, sizeof rate, frames_per_second);
    g_autofree char *size = g_strdup_printf("%dx%d", film->width, film->height);
    g_autofree char *output = g_strdup_printf("file:%s", film->path);
    const char *pixels = G_BYTE_ORDER == G_LITTLE_ENDIAN ? "bgr0" : "0rgb";
    const char *words[] = {"ffmpeg",
                           "-loglevel",
                           "error",
                           "-y",
                           "-f",
                           "rawvideo",
                           "-pix_fmt",
                           pixels,
                           "-s",
                           size,
                           "-r",
                           rate,
                           "-i",
                           "-",
                           "-an",
                           "-filter_complex",
                           filter_for(film->path),
                           output,
                           NULL};
    g_autoptr(GError) reason = NULL;
    if (!g_spawn_async_with_pipes(NULL, (char **)words, NULL, G_SPAWN_SEARCH_PATH | G_SPAWN_DO_NOT_REAP_CHILD, NULL,
                                  NULL, &film->encoder, &film->pipe, NULL, NULL, &reason)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: ffmpeg cannot be started: %s", film->path,
                    reason->message);
        return FALSE;
    }
    /* an encoder that ends early is told by the write that fails */
    signal(SIGPIPE, SIG_IGN);
    film->joined = TRUE;
    return TRUE;
}

TinkerFilm *tinker_film_new(const char *path, int width, int height, double frames_per_second, GError **error)
{
    g_autoptr(TinkerFilm) film = g_new0(TinkerFilm, 1);
    film->path = g_strdup(path);
    film->width = width;
    film->height = height;
    film->pipe = -1;
    if (!tinker_path_has_ending(path, ".png") && tinker_film_can_join() &&
        !start_encoder(film, frames_per_second, error))
        return NULL;
    return g_steal_pointer(&film);
}

static gboolean send(TinkerFilm *film, const unsigned char *bytes, gsize count, GError **error)
{
    while (count > 0) {
        ssize_t sent = write(film->pipe, bytes, count);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) {
            g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: ffmpeg takes no more pictures: %s",
                        film->path, g_strerror(errno));
            return FALSE;
        }
        bytes += sent;
        count -= (gsize)sent;
    }
    return TRUE;
}

static gboolean write_picture(TinkerFilm *film, cairo_surface_t *picture, GError **error)
{
    g_autofree char *name = tinker_film_picture_name(film->path, ++film->pictures);
    cairo_status_t status = cairo_surface_write_to_png(picture, name);
    if (status == CAIRO_STATUS_SUCCESS) return TRUE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: cannot be written: %s", name,
                cairo_status_to_string(status));
    return FALSE;
}

gboolean tinker_film_add(TinkerFilm *film, cairo_surface_t *picture, GError **error)
{
    if (!film->joined) return write_picture(film, picture, error);
    cairo_surface_flush(picture);
    const unsigned char *pixels = cairo_image_surface_get_data(picture);
    int stride = cairo_image_surface_get_stride(picture);
    for (int row = 0; row < film->height; row++)
        if (!send(film, pixels + (gsize)row * (gsize)stride, (gsize)film->width * 4, error)) return FALSE;
    return TRUE;
}

/* Ends the encoder; whether it says that all went well. */
static gboolean end_encoder(TinkerFilm *film)
{
    if (film->pipe >= 0) close(film->pipe);
    film->pipe = -1;
    int status = 0;
    pid_t ended;
    do {
        ended = waitpid(film->encoder, &status, 0);
    } while (ended < 0 && errno == EINTR);
    g_spawn_close_pid(film->encoder);
    film->joined = FALSE;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

gboolean tinker_film_finish(TinkerFilm *film, GError **error)
{
    if (!film->joined || end_encoder(film)) return TRUE;
    (void)g_unlink(film->path);
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: ffmpeg could not write the film", film->path);
    return FALSE;
}

void tinker_film_free(TinkerFilm *film)
{
    if (film == NULL) return;
    if (film->joined) {
        (void)end_encoder(film);
        (void)g_unlink(film->path);
    }
    g_free(film->path);
    g_free(film);
}
