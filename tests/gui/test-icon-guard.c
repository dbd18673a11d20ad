/* A plugin that crashes in drawing its icon ends the program once: at the next start the icon is left out, the plugin
 * is named, and all other icons are there. */
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>

#include "files-fixture.h"
#include "gui/document/icon-guard.h"

#define SIZE 32

/* With the plugin that crashes. (transfer full) */
static TinkerCatalogue *open_exhibits(void)
{
    const char *folders[] = {g_getenv("TINKER_EXHIBITS"), g_getenv("TINKER_TEST_PLUGINS"), NULL};
    const TinkerCatalogueOptions options = {.folders = folders, .probe_program = g_getenv("TINKER_PROGRAM")};
    return tinker_catalogue_new(&options);
}

/* Whether there is ink where the icon is. */
static gboolean paints(TinkerCatalogue *catalogue, const char *type)
{
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type, &error);
    g_assert_no_error(error);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, SIZE, SIZE);
    cairo_t *cairo = cairo_create(surface);
    tinker_guarded_icon_paint(cairo, block_class, SIZE, SIZE, tinker_theme_find("light"));
    cairo_destroy(cairo);
    cairo_surface_flush(surface);
    const unsigned char *data = cairo_image_surface_get_data(surface);
    gboolean ink = FALSE;
    for (int i = 0; i < SIZE * cairo_image_surface_get_stride(surface); i++)
        ink |= data[i] != 0;
    cairo_surface_destroy(surface);
    return ink;
}

/* The start of a program. */
static void start(const char *type)
{
    g_autoptr(TinkerCatalogue) catalogue = open_exhibits();
    g_assert_true(paints(catalogue, "mass"));
    (void)paints(catalogue, type);
}

/* Answers the signal that ended it; 0: it ended well. */
static int run_start(const char *type)
{
    g_autofree char *program = g_file_read_link("/proc/self/exe", NULL);
    const char *words[] = {program, "child", type, NULL};
    int status = 0;
    g_assert_true(
        g_spawn_sync(NULL, (char **)words, NULL, G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL, NULL, NULL, &status, NULL));
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

static void test_crash(void)
{
    g_autoptr(GPtrArray) before = tinker_guarded_icon_notices();
    g_assert_cmpuint(before->len, ==, 0);
    g_assert_cmpint(run_start("spring"), ==, 0);
    g_assert_cmpint(run_start("crashing-drawing"), ==, SIGSEGV);
    g_assert_cmpint(run_start("crashing-drawing"), ==, 0);

    g_autoptr(TinkerCatalogue) catalogue = open_exhibits();
    g_assert_false(paints(catalogue, "crashing-drawing"));
    g_assert_true(paints(catalogue, "mass"));
    g_autoptr(GPtrArray) notices = tinker_guarded_icon_notices();
    g_assert_cmpuint(notices->len, ==, 1);
    TinkerNotice *notice = g_ptr_array_index(notices, 0);
    g_assert_nonnull(strstr(notice->text, "crashing-drawing"));
    g_assert_nonnull(strstr(notice->text, g_getenv("TINKER_EXHIBITS")));

    /* the user wants to see it again */
    notice->cure(notice->data);
    g_autoptr(GPtrArray) after = tinker_guarded_icon_notices();
    g_assert_cmpuint(after->len, ==, 0);
    g_assert_cmpint(run_start("crashing-drawing"), ==, SIGSEGV);
}

static void add_tests(void)
{
    g_test_add_func("/gui/icon-guard/crash", test_crash);
}

int main(int argc, char **argv)
{
    return files_fixture_main(argc, argv, add_tests, start);
}
