/* Films in the background: what is written is a film of as many pictures as were asked for; what is cancelled or fails
 * leaves nothing, and what was there before stays. ffmpeg's part is played by scripts, where it is not about the film
 * itself. */
#include <glib/gstdio.h>
#include <string.h>

#include "folders.h"
#include "gui-fixture.h"
#include "gui/document/background.h"
#include "gui/film/film-task.h"
#include "program.h"

#define PATIENCE 60.0 /* s */

/* 1 s of fall: with 10 pictures a second, 11. */
#define FALL "'run': {'duration': 1, 'interval': 0.01}, 'blocks': [{'type': 'gravity'}, {'type': 'mass'}]"
/* More pictures than can be drawn while a test looks. */
#define LONG_FALL "'run': {'duration': 9000, 'interval': 1}, 'blocks': [{'type': 'gravity'}, {'type': 'mass'}]"

typedef struct {
    GuiFixture *scene;
    TinkerFilmTask *task;
    char *folder, *path; /* of the programs, and of what is looked for there */
} Fixture;

static void set_up(Fixture *fixture, gconstpointer data)
{
    fixture->scene = gui_fixture_new("");
    fixture->task = tinker_film_task_new();
    fixture->folder = g_dir_make_tmp("tinker-film-test-XXXXXX", NULL);
    fixture->path = g_strdup(g_getenv("PATH"));
}

static guint files_in(const Fixture *fixture)
{
    g_autoptr(GDir) folder = g_dir_open(fixture->folder, 0, NULL);
    guint count = 0;
    while (g_dir_read_name(folder) != NULL)
        count++;
    return count;
}

static void tear_down(Fixture *fixture, gconstpointer data)
{
    g_object_unref(fixture->task);
    g_assert_true(tinker_background_wait(60));
    gui_fixture_free(fixture->scene);
    g_setenv("PATH", fixture->path, TRUE);
    test_remove_all(fixture->folder);
    g_free(fixture->folder);
    g_free(fixture->path);
}

static void start(Fixture *fixture, const char *members, const char *name)
{
    g_autofree char *path = g_build_filename(fixture->folder, name, NULL);
    gui_fixture_start_scene(fixture->scene, members);
    const TinkerFilmSettings settings = {
        .path = path, .width = 64, .height = 48, .frames_per_second = 10, .speed = 1, .show_labels = TRUE};
    tinker_film_task_start(fixture->task, tinker_document_scene(fixture->scene->document), &settings);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_UNDER_WAY);
}

/* Fails where it is not over after a time that no slow machine needs. */
static void wait_for_end(Fixture *fixture)
{
    gint64 begun = g_get_monotonic_time();
    while (tinker_film_task_state(fixture->task) == TINKER_FILM_UNDER_WAY &&
           g_get_monotonic_time() - begun < (gint64)(1e6 * PATIENCE))
        gui_fixture_pass(5);
    g_assert_cmpint(tinker_film_task_state(fixture->task), !=, TINKER_FILM_UNDER_WAY);
}

static char *contents(const Fixture *fixture, const char *name, gsize *length)
{
    g_autofree char *path = g_build_filename(fixture->folder, name, NULL);
    char *text = NULL;
    g_assert_true(g_file_get_contents(path, &text, length, NULL));
    return text;
}

/* Passes over the sub-blocks of a GIF. */
static gsize after_blocks(const guchar *gif, gsize at)
{
    while (gif[at] != 0)
        at += 1 + (gsize)gif[at];
    return at + 1;
}

/* Passes over a table of colours, if these flags tell of one. */
static gsize after_colours(guchar flags, gsize at)
{
    return at + ((flags & 0x80) != 0 ? (gsize)3 << ((flags & 7) + 1) : 0);
}

/* The pictures of a GIF, by the format's own specification (GIF89a, 1990); its logical screen is checked. */
static int gif_pictures(const guchar *gif, gsize length)
{
    int count = 0;
    g_assert_cmpmem(gif, 6, "GIF89a", 6);
    g_assert_cmpint(gif[6] | gif[7] << 8, ==, 64);
    g_assert_cmpint(gif[8] | gif[9] << 8, ==, 48);
    gsize at = after_colours(gif[10], 13);
    while (at < length && gif[at] != 0x3b) {
        g_assert_true(gif[at] == 0x21 || gif[at] == 0x2c);
        count += gif[at] == 0x2c;
        at = gif[at] == 0x21 ? after_blocks(gif, at + 2) : after_blocks(gif, after_colours(gif[at + 9], at + 10) + 1);
    }
    g_assert_cmpuint(at, ==, length - 1);
    return count;
}

static void test_gif(Fixture *fixture, gconstpointer data)
{
    g_autofree char *ffmpeg = g_find_program_in_path("ffmpeg");
    if (ffmpeg == NULL) {
        g_test_skip("ffmpeg is not installed");
        return;
    }
    start(fixture, FALL, "fall.gif");
    wait_for_end(fixture);
    g_assert_cmpstr(tinker_film_task_failure(fixture->task), ==, NULL);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_WRITTEN);
    gsize length;
    g_autofree guchar *gif = (guchar *)contents(fixture, "fall.gif", &length);
    g_assert_cmpint(gif_pictures(gif, length), ==, 11);
    g_assert_cmpuint(files_in(fixture), ==, 1);
}

/* Every byte of every picture goes to the encoder, and what it writes is put in place. */
static void test_feeds_the_encoder(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg",
                         "#!/bin/sh\nfor last; do :; done\nexec /bin/cat >\"${last#file:}\"\n");
    start(fixture, FALL, "fall.mp4");
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_WRITTEN);
    gsize length;
    g_autofree char *pixels = contents(fixture, "fall.mp4", &length);
    g_assert_cmpuint(length, ==, 11 * 64 * 48 * 4);
    g_assert_true(memcmp(pixels, pixels + length - 64 * 48 * 4, 64 * 48 * 4) != 0); /* it moves */
    g_assert_cmpuint(files_in(fixture), ==, 2);
}

static void test_numbered(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", NULL);
    start(fixture, FALL, "fall.png");
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_WRITTEN);
    for (int i = 1; i <= 11; i++) {
        g_autofree char *name = g_strdup_printf("fall-%04d.png", i), *png = contents(fixture, name, NULL);
        g_assert_true(g_str_has_prefix(png, "\211PNG"));
    }
    g_assert_cmpuint(files_in(fixture), ==, 12);
}

/* y = -9.81 t^2 / 2 is -1.2 m after 0.494 s: pictures at 0, 0.1, 0.2, 0.3, 0.4 and there. */
static void test_stops(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", NULL);
    start(fixture, "'run': {'until': 't > 3; {Mass 0.y} = -1.2'}, 'blocks': [{'type': 'gravity'}, {'type': 'mass'}]",
          "fall.png");
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_WRITTEN);
    g_assert_cmpstr(tinker_film_task_stopped_by(fixture->task), ==, "{Mass 0.y} = -1.2");
    g_assert_cmpuint(files_in(fixture), ==, 7);
    start(fixture, FALL, "fall.png");
    wait_for_end(fixture);
    g_assert_null(tinker_film_task_stopped_by(fixture->task));
}

/* A film that was there before. */
static void put_old_film(Fixture *fixture, const char *name)
{
    g_autofree char *path = g_build_filename(fixture->folder, name, NULL);
    g_assert_true(g_file_set_contents(path, "old", 3, NULL));
}

static void assert_only_old_film(const Fixture *fixture, const char *name)
{
    g_autofree char *text = contents(fixture, name, NULL);
    g_assert_cmpstr(text, ==, "old");
    g_assert_cmpuint(files_in(fixture), ==, 2); /* and the programs */
}

static void cancel_after(Fixture *fixture, guint milliseconds)
{
    gui_fixture_pass(milliseconds);
    tinker_film_task_cancel(fixture->task);
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_CANCELLED);
    g_assert_null(tinker_film_task_failure(fixture->task));
}

/* Whether the encoder takes everything, or nothing, or does not end. */
static void test_cancels(Fixture *fixture, gconstpointer data)
{
    const guint moments[] = {0, 30, 400};
    test_pretend_program(fixture->folder, "ffmpeg", data);
    put_old_film(fixture, "fall.gif");
    for (gsize i = 0; i < G_N_ELEMENTS(moments); i++) {
        start(fixture, LONG_FALL, "fall.gif");
        cancel_after(fixture, moments[i]);
        assert_only_old_film(fixture, "fall.gif");
    }
}

static void test_cancels_the_end(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", "#!/bin/sh\n/bin/cat >/dev/null\nexec /bin/sleep 1000\n");
    start(fixture, FALL, "fall.gif");
    gint64 begun = g_get_monotonic_time();
    while (tinker_film_task_progress(fixture->task) < 1 && g_get_monotonic_time() - begun < (gint64)(1e6 * PATIENCE))
        gui_fixture_pass(5);
    cancel_after(fixture, 50);
    g_assert_cmpuint(files_in(fixture), ==, 1);
}

static void test_cancels_pictures(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", NULL);
    start(fixture, LONG_FALL, "fall.png");
    gint64 begun = g_get_monotonic_time();
    while (files_in(fixture) < 2 && g_get_monotonic_time() - begun < (gint64)(1e6 * PATIENCE))
        gui_fixture_pass(5);
    cancel_after(fixture, 0);
    g_assert_cmpuint(files_in(fixture), ==, 1);
}

/* The user reads the reason in ffmpeg's own words. */
static void test_encoder_fails(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", data);
    put_old_film(fixture, "fall.gif");
    start(fixture, FALL, "fall.gif");
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_FAILED);
    g_assert_nonnull(strstr(tinker_film_task_failure(fixture->task), "No space left on device"));
    assert_only_old_film(fixture, "fall.gif");
}

static void test_no_folder(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", data);
    start(fixture, FALL, data != NULL ? "none/fall.gif" : "none/fall.png");
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_FAILED);
    g_assert_nonnull(strstr(tinker_film_task_failure(fixture->task), "none/fall"));
    g_assert_cmpuint(files_in(fixture), ==, 1);
}

static void test_scene_cannot_run(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", NULL);
    start(fixture, "'blocks': [{'type': 'mass'}, {'type': 'spring', 'ends': ['Mass 0', [3, 0]]}]", "fall.png");
    wait_for_end(fixture);
    g_assert_cmpint(tinker_film_task_state(fixture->task), ==, TINKER_FILM_FAILED);
    g_assert_nonnull(strstr(tinker_film_task_failure(fixture->task), "Spring 0"));
    g_assert_cmpuint(files_in(fixture), ==, 1);
}

/* An owner may go at any time; nothing is left when its thread has ended. */
static void test_let_go(Fixture *fixture, gconstpointer data)
{
    test_pretend_program(fixture->folder, "ffmpeg", data);
    start(fixture, LONG_FALL, "fall.gif");
    gui_fixture_pass(200);
    g_object_unref(fixture->task);
    g_assert_true(tinker_background_wait(60));
    g_assert_cmpuint(files_in(fixture), ==, 1);
    fixture->task = tinker_film_task_new();
}

#define TAKES_ALL     "#!/bin/sh\nexec /bin/cat >/dev/null\n"
#define TAKES_NOTHING "#!/bin/sh\nexec /bin/sleep 1000\n"
#define FAILS_LATE    "#!/bin/sh\n/bin/cat >/dev/null\necho 'No space left on device' >&2\necho 'Failed' >&2\nexit 1\n"
#define FAILS_EARLY   "#!/bin/sh\necho 'No space left on device' >&2\nexit 1\n"

static void add(const char *path, const char *script, void (*test)(Fixture *fixture, gconstpointer data))
{
    g_test_add(path, Fixture, script, set_up, test, tear_down);
}

static void add_tests(void)
{
    add("/film-task/gif", NULL, test_gif);
    add("/film-task/feeds-the-encoder", NULL, test_feeds_the_encoder);
    add("/film-task/numbered", NULL, test_numbered);
    add("/film-task/stops", NULL, test_stops);
    add("/film-task/cancels", TAKES_ALL, test_cancels);
    add("/film-task/cancels-when-blocked", TAKES_NOTHING, test_cancels);
    add("/film-task/cancels-the-end", NULL, test_cancels_the_end);
    add("/film-task/cancels-pictures", NULL, test_cancels_pictures);
    add("/film-task/encoder-fails/late", FAILS_LATE, test_encoder_fails);
    add("/film-task/encoder-fails/early", FAILS_EARLY, test_encoder_fails);
    add("/film-task/no-folder/film", TAKES_ALL, test_no_folder);
    add("/film-task/no-folder/pictures", NULL, test_no_folder);
    add("/film-task/scene-cannot-run", NULL, test_scene_cannot_run);
    add("/film-task/let-go", TAKES_ALL, test_let_go);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
