/* A net under changes that are to change nothing: hashes of the records of many scenes under every method, and what two
 * tables of them differ in. See README.md. */
#include <glib/gstdio.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "net-compare.h"
#include "net-scenes.h"
#include "net-table.h"
#include "net-workers.h"
#include "numerics/sharing/sharing.h"

#define USAGE                                                                                                          \
    "write FILE | compare OLD NEW | check FILE\n\n"                                                                    \
    "  write    runs every scene by every method and writes a line each\n"                                             \
    "  compare  lists what differs between two such files; ends with status 1 where anything does\n"                   \
    "  check    runs again what is in a file, and compares"

enum { DIFFERS = 1, WRONG_USE = 2, FAILED = 5 };

typedef struct {
    char *records, *only, *like;
    gint processes;
} Options;

static int fail(const GError *error)
{
    fprintf(stderr, "net: %s\n", error->message);
    return FAILED;
}

/* The runs that a file names. (transfer full) */
static GHashTable *runs_of(const char *path, GError **error)
{
    g_autoptr(GPtrArray) table = net_table_read(path, error);
    if (table == NULL) return NULL;
    GHashTable *runs = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (guint i = 0; i < table->len; i++) {
        char **line = g_ptr_array_index(table, i);
        g_hash_table_add(runs, g_strdup_printf("%s\t%s", line[NET_SCENE], line[NET_METHOD]));
    }
    return runs;
}

/* Runs scenes in the folder where their tables are found. NULL and a message where that fails. */
static GPtrArray *run_all(const Options *options, const char *like, GError **error)
{
    g_autofree char *folder = net_scenes_folder();
    g_autofree char *store = options->records != NULL ? g_canonicalize_filename(options->records, NULL) : NULL;
    g_autofree char *here = g_get_current_dir();
    g_autoptr(GHashTable) wanted = like != NULL ? runs_of(like, error) : NULL;
    if (like != NULL && wanted == NULL) return NULL;
    g_autoptr(GPtrArray) scenes = net_scenes_new(options->only, error);
    if (scenes == NULL) return NULL;
    if ((store != NULL && g_mkdir_with_parents(store, 0777) != 0) || g_chdir(folder) != 0) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_FAILED, "%s or %s cannot be used", store, folder);
        return NULL;
    }
    GPtrArray *table = net_run_all(scenes, wanted, store, options->processes, error);
    if (g_chdir(here) != 0) g_warning("%s is no more", here);
    return table;
}

static int write_table(const Options *options, const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) table = run_all(options, options->like, &error);
    if (table == NULL || !net_table_write(table, path, &error)) return fail(error);
    printf("%u runs\n", table->len);
    return EXIT_SUCCESS;
}

static int compare(const Options *options, const char *old_path, const char *new_path)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) old = net_table_read(old_path, &error);
    g_autoptr(GPtrArray) new = old != NULL ? net_table_read(new_path, &error) : NULL;
    if (new == NULL) return fail(error);
    return net_compare(old, new, options->records) ? EXIT_SUCCESS : DIFFERS;
}

static int check(const Options *options, const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GPtrArray) old = net_table_read(path, &error);
    if (old == NULL) return fail(error);
    g_autoptr(GPtrArray) new = run_all(options, path, &error);
    if (new == NULL) return fail(error);
    return net_compare(old, new, options->records) ? EXIT_SUCCESS : DIFFERS;
}

int main(int argc, char **argv)
{
    Options options = {.processes = (gint)g_get_num_processors()};
    const GOptionEntry entries[] = {
        {"records", 0, 0, G_OPTION_ARG_FILENAME, &options.records,
         "Put what is hashed into FOLDER, each under its hash; compare: find it there", "FOLDER"},
        {"only", 0, 0, G_OPTION_ARG_STRING, &options.only, "Only scenes whose name contains TEXT", "TEXT"},
        {"like", 0, 0, G_OPTION_ARG_FILENAME, &options.like, "write: only the runs that are in FILE", "FILE"},
        {"processes", 'j', 0, G_OPTION_ARG_INT, &options.processes, "How many run at a time", "N"},
        G_OPTION_ENTRY_NULL,
    };
    g_autoptr(GError) error = NULL;
    g_autoptr(GOptionContext) context = g_option_context_new(USAGE);
    g_option_context_add_main_entries(context, entries, NULL);
    int status = WRONG_USE;
    tinker_share_set_threads(1); /* a run's companion is stepped where runs are cut by the number of questions */
    if (!g_option_context_parse(context, &argc, &argv, &error))
        fprintf(stderr, "net: %s\n", error->message);
    else if (argc == 3 && g_str_equal(argv[1], "write"))
        status = write_table(&options, argv[2]);
    else if (argc == 4 && g_str_equal(argv[1], "compare"))
        status = compare(&options, argv[2], argv[3]);
    else if (argc == 3 && g_str_equal(argv[1], "check"))
        status = check(&options, argv[2]);
    else
        fprintf(stderr, "usage: net %s\n", USAGE);
    g_free(options.records);
    g_free(options.only);
    g_free(options.like);
    return status;
}
