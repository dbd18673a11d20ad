/* Films: raw frames down a pipe to ffmpeg, or numbered pictures. Nothing waits for ffmpeg without looking whether it
 * still should. */
#include "common/film/film.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <glib/gstdio.h>

#include "common/film/film-pictures.h"
#include "common/program/exit-status.h"
#include "files/unfinished.h"

#define LOOK_AGAIN 20  /* ms */
#define COMPLAINT  400 /* bytes of what ffmpeg says that are looked at */

struct _TinkerFilm {
    char *path; /* as given */
    int width, height;
    TinkerFilmPictures *pictures; /* NULL: ffmpeg joins them, with what follows */
    char *place;                  /* the path, or what it leads to as a link */
    TinkerUnfinished unfinished;  /* what ffmpeg writes, beside that */
    gboolean joined;
    GPid encoder;
    int pipe;       /* to the encoder; -1: closed */
    int complaints; /* what it says; -1: nowhere */
    gboolean (*cancelled)(void *data);
    void *data;
};

gboolean tinker_path_has_ending(const char *path, const char *ending)
{
    gsize length = strlen(path), tail = strlen(ending);
    return length >= tail && g_ascii_strcasecmp(path + length - tail, ending) == 0;
}

gboolean tinker_film_can_join(void)
{
    g_autofree char *program = g_find_program_in_path("ffmpeg");
    return program != NULL;
}

gboolean tinker_film_is_joined(const char *path)
{
    return !tinker_path_has_ending(path, ".png");
}

gboolean tinker_film_add_outputs(TinkerFileSet *files, const char *option, const char *path, double count,
                                 GError **error)
{
    if (tinker_film_is_joined(path)) return tinker_file_set_add_output(files, option, path, error);
    for (int number = 1; number <= count; number++) {
        g_autofree char *picture = tinker_film_pictures_name(path, number);
        if (!tinker_file_set_add_output(files, option, picture, error)) return FALSE;
    }
    return TRUE;
}

void tinker_film_set_cancelled(TinkerFilm *film, gboolean (*cancelled)(void *data), void *data)
{
    film->cancelled = cancelled;
    film->data = data;
}

static gboolean fail(const char *path, const char *what, const char *reason, GError **error)
{
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: %s: %s", path, what, reason);
    return FALSE;
}

static gboolean is_stopped(TinkerFilm *film, GError **error)
{
    if (film->cancelled == NULL || !film->cancelled(film->data)) return FALSE;
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_STOPPED, "%s: the film was given up", film->path);
    return TRUE;
}

/* The encoder ------------------------------------------------------------------------------------------------------ */

/* A GIF gets a palette of its own, made from all its pictures; films for players get even sides and the one pixel
 * format that all of them know. */
static const char *filter_for(const char *path)
{
    if (tinker_path_has_ending(path, ".gif"))
        return "split[a][b];[a]palettegen=reserve_transparent=0[p];[b][p]paletteuse=dither=none";
    return "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p";
}

/* An empty file in the folder where the film will be, with the film's ending: ffmpeg goes by that. A link stays a link:
 * the file that it leads to is replaced. */
static gboolean begin_file(TinkerFilm *film, GError **error)
{
    char *real = realpath(film->path, NULL);
    film->place = g_strdup(real != NULL ? real : film->path);
    free(real);
    g_autofree char *folder = g_path_get_dirname(film->place);
    tinker_unfinished_clean(folder);
    return tinker_unfinished_file(&film->unfinished, folder, strrchr(film->path, '.'), 0666) ||
           fail(film->path, "cannot be written", g_strerror(errno), error);
}

/* What ffmpeg says goes to a file that has no name any more: a pipe would have to be emptied meanwhile. */
static int open_complaints(void)
{
    g_autofree char *name = NULL;
    int file = g_file_open_tmp("tinker-film-XXXXXX", &name, NULL);
    if (file >= 0) (void)g_unlink(name);
    return file;
}

/* Ctrl-C goes to all processes of a group. It is for the program to answer, which then ends the film well. */
static void leave_group(gpointer data)
{
    setpgid(0, 0);
}

static gboolean start_encoder(TinkerFilm *film, double frames_per_second, GError **error)
{
    char rate[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_dtostr(rate, sizeof rate, frames_per_second);
    g_autofree char *size = g_strdup_printf("%dx%d", film->width, film->height);
    g_autofree char *output = g_strdup_printf("file:%s", film->unfinished.path);
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
    film->complaints = open_complaints();
    GSpawnFlags flags = G_SPAWN_SEARCH_PATH | G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_CLOEXEC_PIPES;
    if (!g_spawn_async_with_pipes_and_fds(NULL, words, NULL, flags, leave_group, NULL, -1, -1, film->complaints, NULL,
                                          NULL, 0, &film->encoder, &film->pipe, NULL, NULL, &reason))
        return fail(film->path, "ffmpeg cannot be started", reason->message, error);
    /* an encoder that ends early is told by the write that fails */
    signal(SIGPIPE, SIG_IGN);
    (void)fcntl(film->pipe, F_SETFL, O_NONBLOCK);
    film->joined = TRUE;
    return TRUE;
}

/* The first line of what ffmpeg said: those behind it follow from that. (transfer full) */
static char *first_complaint(TinkerFilm *film)
{
    char text[COMPLAINT + 1] = "";
    ssize_t count = film->complaints < 0 ? 0 : pread(film->complaints, text, COMPLAINT, 0);
    text[MAX(count, 0)] = '\0';
    text[strcspn(text, "\n")] = '\0';
    g_autofree char *valid = g_utf8_make_valid(text, -1);
    return *valid != '\0' ? g_steal_pointer(&valid) : g_strdup("it does not say why");
}

static void close_pipe(TinkerFilm *film)
{
    if (film->pipe >= 0) close(film->pipe);
    film->pipe = -1;
}

/* Waits for the encoder's end; whether it says that all went well. */
static gboolean end_encoder(TinkerFilm *film, GError **error)
{
    int status = 0;
    pid_t ended = 0;
    close_pipe(film);
    while (ended == 0 || (ended < 0 && errno == EINTR)) {
        ended = waitpid(film->encoder, &status, WNOHANG);
        if (ended != 0) continue;
        if (is_stopped(film, error)) return FALSE;
        g_usleep(1000 * LOOK_AGAIN);
    }
    film->joined = FALSE;
    if (ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return TRUE;
    g_autofree char *complaint = first_complaint(film);
    return fail(film->path, "ffmpeg could not write the film", complaint, error);
}

static void kill_encoder(TinkerFilm *film)
{
    close_pipe(film);
    kill(film->encoder, SIGKILL);
    while (waitpid(film->encoder, NULL, 0) < 0 && errno == EINTR)
        continue;
    film->joined = FALSE;
}

/* Waits until the encoder takes more. */
static gboolean wait_for_encoder(TinkerFilm *film, GError **error)
{
    struct pollfd wanted = {.fd = film->pipe, .events = POLLOUT};
    while (poll(&wanted, 1, LOOK_AGAIN) <= 0)
        if (is_stopped(film, error)) return FALSE;
    return TRUE;
}

static gboolean send(TinkerFilm *film, const unsigned char *bytes, gsize count, GError **error)
{
    while (count > 0) {
        if (!wait_for_encoder(film, error)) return FALSE;
        ssize_t sent = write(film->pipe, bytes, count);
        if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (sent < 0) {
            /* what it ended of is told in its own words */
            return end_encoder(film, error)
                       ? fail(film->path, "ffmpeg takes no more pictures", g_strerror(EPIPE), error)
                       : FALSE;
        }
        bytes += sent;
        count -= (gsize)sent;
    }
    return TRUE;
}

/* The film --------------------------------------------------------------------------------------------------------- */

TinkerFilm *tinker_film_new(const char *path, int width, int height, double frames_per_second, GError **error)
{
    g_autoptr(TinkerFilm) film = g_new0(TinkerFilm, 1);
    film->path = g_strdup(path);
    film->width = width;
    film->height = height;
    film->pipe = film->complaints = -1;
    if (!tinker_film_is_joined(path)) {
        film->pictures = tinker_film_pictures_new(path, error);
        return film->pictures != NULL ? g_steal_pointer(&film) : NULL;
    }
    if (!begin_file(film, error) || !start_encoder(film, frames_per_second, error)) return NULL;
    return g_steal_pointer(&film);
}

gboolean tinker_film_add(TinkerFilm *film, cairo_surface_t *picture, GError **error)
{
    if (is_stopped(film, error)) return FALSE;
    if (film->pictures != NULL) return tinker_film_pictures_add(film->pictures, picture, error);
    cairo_surface_flush(picture);
    const unsigned char *pixels = cairo_image_surface_get_data(picture);
    int stride = cairo_image_surface_get_stride(picture);
    for (int row = 0; row < film->height; row++)
        if (!send(film, pixels + (gsize)row * (gsize)stride, (gsize)film->width * 4, error)) return FALSE;
    return TRUE;
}

static gboolean put_in_place(TinkerFilm *film, GError **error)
{
    return tinker_unfinished_finish(&film->unfinished, film->place) ||
           fail(film->path, "cannot be written", g_strerror(errno), error);
}

gboolean tinker_film_finish(TinkerFilm *film, GError **error)
{
    if (film->pictures != NULL) return tinker_film_pictures_finish(film->pictures, error);
    return end_encoder(film, error) && put_in_place(film, error);
}

void tinker_film_free(TinkerFilm *film)
{
    if (film == NULL) return;
    if (film->joined) kill_encoder(film);
    tinker_unfinished_clear(&film->unfinished);
    if (film->complaints >= 0) close(film->complaints);
    tinker_film_pictures_free(film->pictures);
    g_free(film->place);
    g_free(film->path);
    g_free(film);
}
