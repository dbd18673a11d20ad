/* The kit's outline: a survey tells what the library has, then every rule is tried on every subject. */
#include "conformance/rule/conformance.h"

#include <string.h>

#include "conformance/probe/child.h"
#include "conformance/probe/quiet.h"

typedef struct {
    TinkerCatalogue *catalogue;
    char *path;
    const TinkerConformanceOptions *options;
    TinkerConformanceFunc result;
    gpointer data;
    KitSheet *sheet;
    GError *error; /* why nothing more could be tried */
} Run;

/* What a child is told. */
typedef struct {
    const Run *run;
    KitTry try_it;
    const char *rule;
    char kind; /* of the subject: 'l' library, 't' type, 'i' integrator */
    const char *subject;
} Task;

/* Opening shares the time limit and the fate of whatever comes after it. */
static const TinkerLibraryEntry *open_library(KitCheck *check)
{
    g_autoptr(GError) error = NULL;
    kit_phase(check, "its entry or init");
    const TinkerLibraryEntry *entry = tinker_catalogue_add_file(check->catalogue, check->path, &error);
    if (entry == NULL) kit_fail(check, "%s", error->message);
    check->sheet->phase[0] = '\0';
    return entry;
}

static void survey(gpointer data)
{
    const Run *run = data;
    KitCheck check = {.catalogue = run->catalogue, .path = run->path, .sheet = run->sheet};
    const TinkerLibraryEntry *entry = open_library(&check);
    if (entry == NULL) return;
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < entry->types->len; i++)
        g_string_append_printf(names, "t%s\n", ((TinkerTypeEntry *)g_ptr_array_index(entry->types, i))->id);
    for (guint i = 0; i < entry->integrators->len; i++)
        g_string_append_printf(names, "i%s\n", (char *)g_ptr_array_index(entry->integrators, i));
    g_strlcpy(run->sheet->names, names->str, sizeof run->sheet->names);
}

static guint32 seed_of(const Task *task)
{
    return task->run->options->seed ^ g_str_hash(task->rule) ^ (g_str_hash(task->subject) * 31u);
}

static void work(gpointer data)
{
    const Task *task = data;
    KitCheck check = {.catalogue = task->run->catalogue, .path = task->run->path, .sheet = task->run->sheet};
    check.random = g_rand_new_with_seed(seed_of(task));
    check.objects = kit_objects_now();
    if (open_library(&check) == NULL) return;
    g_autoptr(GError) error = NULL;
    if (task->kind == 't') check.block_class = tinker_catalogue_type(check.catalogue, task->subject, &error);
    if (task->kind == 'i') check.integrator = tinker_catalogue_integrator(check.catalogue, task->subject, &error);
    if (error != NULL)
        kit_fail(&check, "%s", error->message);
    else
        task->try_it(&check);
}

static void report(const Run *run, const char *rule, const char *subject)
{
    const TinkerConformanceResult result = {rule, subject, (TinkerConformanceOutcome)run->sheet->outcome,
                                            run->sheet->text};
    run->result(&result, run->data);
}

static void try_rule(Run *run, const KitRule *rule, char kind, const char *subject)
{
    const KitTry try_it = kind == 'l' ? rule->library : kind == 't' ? rule->type : rule->integrator;
    if (try_it == NULL || (run->options->rule != NULL && strcmp(run->options->rule, rule->rule.name) != 0)) return;
    Task task = {run, try_it, rule->rule.name, kind, subject};
    if (run->error == NULL && kit_child_run(run->sheet, run->options->seconds, work, &task, &run->error))
        report(run, rule->rule.name, subject);
}

static void try_rules(Run *run, char kind, const char *subject)
{
    for (gsize i = 0; kit_rule(i)->rule.name != NULL; i++)
        try_rule(run, kit_rule(i), kind, subject);
}

static gboolean is_readable(const char *path, GError **error)
{
    g_autofree char *text = NULL;
    g_autoptr(GError) reason = NULL;
    if (g_file_test(path, G_FILE_TEST_IS_REGULAR) && g_file_get_contents(path, &text, NULL, &reason)) return TRUE;
    g_set_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_FILE, "%s: %s", path,
                reason != NULL ? reason->message : "there is no such file");
    return FALSE;
}

/* The survey's names are gone from the sheet once it is used again, so they come as a copy. */
static gboolean try_subjects(Run *run, char **names, GError **error)
{
    const char *wanted = run->options->type;
    gboolean found = wanted == NULL;
    if (wanted == NULL) try_rules(run, 'l', "");
    for (char **name = names; *name != NULL; name++) {
        if (**name == '\0' || (wanted != NULL && strcmp(*name + 1, wanted) != 0)) continue;
        try_rules(run, **name, *name + 1);
        found = TRUE;
    }
    if (run->error != NULL) {
        g_propagate_prefixed_error(error, g_steal_pointer(&run->error), "%s: ", run->path);
        return FALSE;
    }
    if (found) return TRUE;
    g_set_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_MISSING, "%s has no block type or integrator \"%s\"",
                run->path, wanted);
    return FALSE;
}

static gboolean try_all(Run *run, GError **error)
{
    if (!kit_child_run(run->sheet, run->options->seconds, survey, run, error)) {
        g_prefix_error(error, "%s: ", run->path);
        return FALSE;
    }
    if (run->sheet->outcome == TINKER_CONFORMANCE_FAILED) {
        report(run, kit_rule(0)->rule.name, "");
        return TRUE;
    }
    g_auto(GStrv) names = g_strsplit(run->sheet->names, "\n", -1);
    return try_subjects(run, names, error);
}

gboolean tinker_conformance_check(TinkerCatalogue *catalogue, const char *path, const TinkerConformanceOptions *options,
                                  TinkerConformanceFunc result, gpointer data, GError **error)
{
    if (!is_readable(path, error)) return FALSE;
    g_autofree char *absolute = g_canonicalize_filename(path, NULL);
    Run run = {catalogue, absolute, options, result, data, kit_sheet_new(error)};
    const gboolean tried = run.sheet != NULL && try_all(&run, error);
    kit_sheet_free(run.sheet);
    return tried;
}
