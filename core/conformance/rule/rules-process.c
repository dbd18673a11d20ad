/* process: what the process has one of for all its parts is left as it was found, by the library as it is opened and by
 * the functions of its block types. The host puts back what was changed by opening and by `prepare`, and by nothing
 * else. */
#include "conformance/probe/state.h"
#include "plugin/call/library.h"
#include "plugin/call/process-state.h"

void kit_try_library_process(KitCheck *check)
{
    const char *changed = tinker_library_changed_process(check->path);
    if (changed != NULL) kit_fail(check, "opening it changes %s", changed);
}

/* Takes what was saved before the function was called. */
static void look(KitCheck *check, const char *function, TinkerProcessState *saved)
{
    g_autofree char *changed = tinker_process_state_restore(saved);
    if (changed != NULL) kit_fail(check, "%s changes %s", function, changed);
}

void kit_try_process(KitCheck *check)
{
    const TinkerPhysics *physics = check->block_class->physics;
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    g_autoptr(KitState) state = functions->len == 0 ? NULL : kit_state_new(check, KIT_COUNT);
    if (functions->len == 0) kit_skip(check, "it offers no function over batches");
    if (state == NULL) return;
    if (physics != NULL && physics->prepare != NULL) {
        g_autofree const double **columns = g_new0(const double *, check->block_class->column_count + 1);
        TinkerBatch view = kit_state_view(state, columns);
        kit_phase(check, "prepare");
        TinkerProcessState *saved = tinker_process_state_save();
        physics->prepare(&view);
        look(check, "prepare", saved);
    }
    for (guint i = 0; i < functions->len; i++) {
        const KitFunction *function = &g_array_index(functions, KitFunction, i);
        TinkerProcessState *saved = tinker_process_state_save();
        kit_answer_free(kit_call(check, function, state));
        look(check, function->name, saved);
    }
}
