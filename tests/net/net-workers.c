/* Handing out scenes to processes; see the header. */
#include "net-workers.h"

#include <stdatomic.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "build-catalogue.h"
#include "net-run.h"
#include "net-table.h"
#include "numerics/sharing/sharing.h"

#define MOST_PROCESSES 64

/* What the processes share. */
typedef struct {
    atomic_uint next;               /* scene that nobody has begun */
    atomic_uint at[MOST_PROCESSES]; /* the last one that each has begun */
} Shared;

typedef struct {
    pid_t process;
    FILE *lines; /* what it writes, and we read when it has ended */
} Worker;

/* A method or a block that is missing would be a hole in the net. */
static gboolean has_all_plugins(TinkerCatalogue *catalogue, GError **error)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (library->refused == NULL) continue;
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_FAILED, "the library %s was refused: %s", library->path,
                    library->refused);
        return FALSE;
    }
    return TRUE;
}

/* What a process does, and its exit status. */
static int work(const GPtrArray *scenes, GHashTable *wanted, const char *store, Shared *shared, int number, FILE *lines)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerCatalogue) catalogue = test_build_catalogue();
    g_autoptr(GPtrArray) table = net_table_new();
    tinker_share_set_threads(1);
    if (!has_all_plugins(catalogue, &error)) {
        fprintf(stderr, "net: %s\n", error->message);
        return 1;
    }
    for (guint i; (i = atomic_fetch_add(&shared->next, 1)) < scenes->len;) {
        atomic_store(&shared->at[number], i);
        if (net_run_scene(catalogue, g_ptr_array_index(scenes, i), wanted, store, table, &error)) continue;
        fprintf(stderr, "net: %s\n", error->message);
        return 1;
    }
    g_autofree char *text = net_table_to_text(table);
    return fputs(text, lines) < 0 || fflush(lines) != 0;
}

static gboolean begin(Worker *worker, const GPtrArray *scenes, GHashTable *wanted, const char *store, Shared *shared,
                      int number)
{
    worker->lines = tmpfile();
    worker->process = worker->lines != NULL ? fork() : -1;
    if (worker->process == 0) _exit(work(scenes, wanted, store, shared, number, worker->lines));
    return worker->process > 0;
}

/* Waits for it, and takes what it wrote. */
static gboolean end(Worker *worker, const char *last_scene, GPtrArray *table, GError **error)
{
    int status = 0;
    char part[65536];
    gsize read;
    g_autoptr(GString) text = g_string_new(NULL);
    if (waitpid(worker->process, &status, 0) < 0 || status != 0) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_FAILED,
                    "a process ended with %s %d; the last scene that it began is %s",
                    WIFSIGNALED(status) ? "signal" : "status",
                    WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status), last_scene);
        return FALSE;
    }
    rewind(worker->lines);
    while ((read = fread(part, 1, sizeof part, worker->lines)) > 0)
        g_string_append_len(text, part, (gssize)read);
    return net_table_add_text(table, text->str, error);
}

GPtrArray *net_run_all(const GPtrArray *scenes, GHashTable *wanted, const char *store, int processes, GError **error)
{
    Worker workers[MOST_PROCESSES];
    Shared *shared = mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    g_autoptr(GPtrArray) table = net_table_new();
    const int count = CLAMP(processes, 1, MOST_PROCESSES);
    gboolean fine = shared != MAP_FAILED;
    int begun = 0;
    while (fine && begun < count && begin(&workers[begun], scenes, wanted, store, shared, begun))
        begun++;
    if (begun < count) {
        g_set_error_literal(error, G_FILE_ERROR, G_FILE_ERROR_FAILED, "no process could be started");
        fine = FALSE;
    }
    for (int i = 0; i < begun; i++) {
        const guint last = atomic_load(&shared->at[i]);
        const char *name = scenes->len > 0 ? ((NetScene *)g_ptr_array_index(scenes, last))->name : "none";
        fine = end(&workers[i], name, table, fine ? error : NULL) && fine;
        fclose(workers[i].lines);
    }
    if (shared != MAP_FAILED) munmap(shared, sizeof *shared);
    if (!fine) return NULL;
    net_table_sort(table);
    return g_steal_pointer(&table);
}
