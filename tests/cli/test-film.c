/* Where films and numbered pictures end up: in their places when they are whole, and until then nowhere that the user
 * looks. ffmpeg's part is played by scripts. What a window does with films is in tests/gui/test-film-task.c. */
#include <glib/gstdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/film/film.h"
#include "folders.h"
#include "program.h"

#define WIDTH  8
#define HEIGHT 4

typedef struct {
    char *folder, *path; /* of films; of the programs before */
    cairo_surface_t *picture;
} Fixture;

static void set_up(Fixture *fixture, gconstpointer script)
{
    fixture->folder = g_dir_make_tmp("tinker-film-test-XXXXXX", NULL);
    fixture->path = g_strdup(g_getenv("PATH"));
    fixture->picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
    test_pretend_program(fixture->folder, "ffmpeg", script);
}

static void tear_down(Fixture *fixture, gconstpointer script)
{
    g_setenv("PATH", fixture->path, TRUE);
    test_remove_all(fixture->folder);
    cairo_surface_destroy(fixture->picture);
    g_free(fixture->folder);
    g_free(fixture->path);
}

static char *place_of(const Fixture *fixture, const char *name)
{
    return g_build_filename(fixture->folder, name, NULL);
}

static void put_old(const Fixture *fixture, const char *name)
{
    g_autofree char *path = place_of(fixture, name);
    g_assert_true(g_file_set_contents(path, "old", 3, NULL));
}

static gboolean is_old(const Fixture *fixture, const char *name)
{
    g_autofree char *path = place_of(fixture, name), *text = test_read_file(path);
    return strcmp(text, "old") == 0;
}

static guint files_in(const Fixture *fixture)
{
    g_autoptr(GDir) folder = g_dir_open(fixture->folder, 0, NULL);
    guint count = 0;
    while (g_dir_read_name(folder) != NULL)
        count++;
    return count;
}

/* A film with so many pictures, not finished. (transfer full) */
static TinkerFilm *begin(const Fixture *fixture, const char *name, int pictures)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *path = place_of(fixture, name);
    TinkerFilm *film = tinker_film_new(path, WIDTH, HEIGHT, 10, &error);
    g_assert_no_error(error);
    for (int i = 0; i < pictures; i++)
        g_assert_true(tinker_film_add(film, fixture->picture, NULL));
    return film;
}

/* Pictures of an earlier film are replaced by those of a film that is whole, and by no others. */
static void test_earlier_pictures(Fixture *fixture, gconstpointer script)
{
    put_old(fixture, "a-0001.png");
    put_old(fixture, "a-0003.png");
    TinkerFilm *given_up = begin(fixture, "a.png", 2);
    g_assert_true(is_old(fixture, "a-0001.png"));
    tinker_film_free(given_up);
    g_assert_true(is_old(fixture, "a-0001.png"));
    g_assert_cmpuint(files_in(fixture), ==, 3); /* and the programs */

    g_autoptr(TinkerFilm) film = begin(fixture, "a.png", 2);
    g_assert_true(tinker_film_finish(film, NULL));
    g_assert_false(is_old(fixture, "a-0001.png"));
    g_assert_false(is_old(fixture, "a-0002.png"));
    g_assert_true(is_old(fixture, "a-0003.png"));
    g_clear_pointer(&film, tinker_film_free);
    g_assert_cmpuint(files_in(fixture), ==, 4);
}

/* A picture's name is that of a folder: the film fails, says which, and the folder stays. */
static void test_folder_in_the_way(Fixture *fixture, gconstpointer script)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *folder = place_of(fixture, "a-0001.png");
    g_assert_cmpint(g_mkdir(folder, 0700), ==, 0);
    g_autoptr(TinkerFilm) film = begin(fixture, "a.png", 1);
    g_assert_false(tinker_film_finish(film, &error));
    g_autofree char *message = g_strdup_printf("%s: cannot be written: Is a directory", folder);
    g_assert_cmpstr(error->message, ==, message);
    g_clear_pointer(&film, tinker_film_free);
    g_assert_cmpuint(files_in(fixture), ==, 2);
}

/* The folder of a film's place may be on another file system than the link to it, so that is where it is written. */
static void test_link(Fixture *fixture, gconstpointer script)
{
    g_autofree char *elsewhere = place_of(fixture, "elsewhere"), *place = g_build_filename(elsewhere, "b.mp4", NULL);
    g_autofree char *link = place_of(fixture, "a.mp4");
    g_assert_cmpint(g_mkdir(elsewhere, 0700), ==, 0);
    put_old(fixture, "elsewhere/b.mp4");
    g_assert_cmpint(symlink(place, link), ==, 0);
    g_autoptr(TinkerFilm) film = begin(fixture, "a.mp4", 3);
    g_autoptr(GError) error = NULL;
    tinker_film_finish(film, &error);
    g_assert_no_error(error);
    g_autofree char *pixels = NULL;
    gsize length;
    g_assert_true(g_file_get_contents(place, &pixels, &length, NULL));
    g_assert_cmpuint(length, ==, 3 * WIDTH * HEIGHT * 4);
    g_assert_true(g_file_test(link, G_FILE_TEST_IS_SYMLINK));
}

/* Ctrl-C in a terminal reaches the program alone: ffmpeg would give up. */
static void test_group(Fixture *fixture, gconstpointer script)
{
    g_autofree char *place = place_of(fixture, "a.gif");
    g_autoptr(TinkerFilm) film = begin(fixture, "a.gif", 1);
    g_assert_true(tinker_film_finish(film, NULL));
    g_autofree char *group = test_read_file(place);
    g_assert_cmpint(atoi(group), >, 0);
    g_assert_cmpint(atoi(group), !=, getpgrp());
}

int main(int argc, char **argv)
{
    static const char *const tells_group = "#!/bin/sh\nfor last; do :; done\nread -r _ _ _ _ group _ </proc/$$/stat\n"
                                           "echo \"$group\" >\"${last#file:}\"\nexec /bin/cat >/dev/null\n";
    static const char *const writes_elsewhere =
        "#!/bin/sh\nfor last; do :; done\n"
        "case \"$last\" in */elsewhere/*) exec /bin/cat >\"${last#file:}\";; esac\nexit 1\n";
    g_test_init(&argc, &argv, NULL);
    g_test_add("/film/earlier-pictures", Fixture, NULL, set_up, test_earlier_pictures, tear_down);
    g_test_add("/film/folder-in-the-way", Fixture, NULL, set_up, test_folder_in_the_way, tear_down);
    g_test_add("/film/group", Fixture, tells_group, set_up, test_group, tear_down);
    g_test_add("/film/link", Fixture, writes_elsewhere, set_up, test_link, tear_down);
    return g_test_run();
}
