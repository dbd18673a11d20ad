/* memory: results and inputs lie against pages that nobody may touch, inputs in pages that nobody may write. Each
 * function is called twice: with everything ending where a forbidden page begins, and beginning where one ends. Also
 * here: speed. */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#include "conformance/probe/state.h"

#define GUARD_PAGES 64
#define MOST_AREAS  64

/* Memory with a forbidden stretch before and behind. */
typedef struct {
    char *whole, *inside;
    gsize whole_size, inside_size;
    const char *name;
    gboolean input;
} Area;

static Area areas[MOST_AREAS];
static int area_count;
static KitSheet *sheet_of_fault;

static gsize page_size(void)
{
    return (gsize)sysconf(_SC_PAGESIZE);
}

/* Room for `size` bytes, its end (or its beginning) at a forbidden page. */
static void *guarded(gsize size, gboolean at_end, const char *name, gboolean input)
{
    const gsize page = page_size(), inside = MAX((size + page - 1) / page, 1) * page, guard = GUARD_PAGES * page;
    if (area_count == MOST_AREAS) g_error("more arguments than guarded areas");
    Area *area = &areas[area_count++];
    *area = (Area){NULL, NULL, inside + 2 * guard, inside, name, input};
    area->whole = mmap(NULL, area->whole_size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (area->whole == MAP_FAILED) g_error("no memory for guarded pages");
    area->inside = area->whole + guard;
    mprotect(area->inside, inside, PROT_READ | PROT_WRITE);
    return at_end ? area->inside + inside - size : area->inside;
}

static void *guarded_copy(const void *from, gsize size, gboolean at_end, const char *name)
{
    void *copy = guarded(size, at_end, name, TRUE);
    if (size > 0) memcpy(copy, from, size);
    return copy;
}

static void protect_inputs(void)
{
    for (int i = 0; i < area_count; i++)
        if (areas[i].input) mprotect(areas[i].inside, areas[i].inside_size, PROT_READ);
}

static void free_areas(void)
{
    for (int i = 0; i < area_count; i++)
        munmap(areas[i].whole, areas[i].whole_size);
    area_count = 0;
}

static gboolean was_write(const void *context)
{
#if defined(__x86_64__)
    return (((const ucontext_t *)context)->uc_mcontext.gregs[REG_ERR] & 2) != 0;
#else
    return TRUE;
#endif
}

/* Runs on a stack of its own in a process that is done for: what is written is what the parent reads. */
static void tell_fault(int number, siginfo_t *info, void *context)
{
    const char *at = info->si_addr;
    for (int i = 0; i < area_count; i++) {
        const Area *area = &areas[i];
        if (at < area->whole || at >= area->whole + area->whole_size) continue;
        const gboolean inside = at >= area->inside && at < area->inside + area->inside_size;
        snprintf(sheet_of_fault->text, sizeof sheet_of_fault->text, "%s %s %s \"%s\"", sheet_of_fault->phase,
                 was_write(context) ? "writes" : "reads",
                 inside              ? "to its input"
                 : at < area->inside ? "before the beginning of"
                                     : "beyond the end of",
                 area->name);
        sheet_of_fault->outcome = TINKER_CONFORMANCE_FAILED;
        sheet_of_fault->decided = 1;
        _exit(1);
    }
    signal(number, SIG_DFL);
    raise(number);
}

static void catch_faults(KitSheet *sheet)
{
    static char stack[65536];
    const stack_t alternate = {.ss_sp = stack, .ss_size = sizeof stack};
    struct sigaction action = {.sa_sigaction = tell_fault, .sa_flags = SA_SIGINFO | SA_ONSTACK};
    sheet_of_fault = sheet;
    sigaltstack(&alternate, NULL);
    sigaction(SIGSEGV, &action, NULL);
    sigaction(SIGBUS, &action, NULL);
}

#define GUARD(array, count, name) guarded_copy(array, (gsize)(count) * sizeof *(array), at_end, name)

static void call_guarded(KitCheck *check, const KitFunction *function, const KitState *state, gboolean at_end)
{
    const int32_t ends = kit_state_end_count(state), rows = kit_state_rows(state),
                  columns = state->block_class->column_count;
    g_autofree const double **views = g_new0(const double *, columns + 1);
    TinkerBatch view = kit_state_view(state, views);
    for (int32_t c = 0; c < columns && c < MOST_AREAS / 2; c++)
        views[c] = GUARD(state->columns[c], state->count, "columns");
    const int32_t *offsets = GUARD(state->offsets, state->count + 1, "end_offsets");
    if (view.end_offsets != NULL) view.end_offsets = offsets;
    const TinkerBodies bodies = {sizeof(TinkerBodies),
                                 state->body_count,
                                 GUARD(state->bodies, state->body_count, "points"),
                                 GUARD(state->masses, state->body_count, "masses"),
                                 0,
                                 state->body_range};
    TinkerGraphInput graph = kit_state_graph_input(state);
    graph.accelerations = GUARD(state->accelerations, 2 * ends, "accelerations");
    if (graph.multipliers != NULL) graph.multipliers = GUARD(state->multipliers, rows * state->count, "multipliers");
    const TinkerPoint *points = GUARD(state->points, ends, "ends");
    graph.ends = points;
    if (graph.forces != NULL) graph.forces = GUARD(state->forces, 2 * ends, "forces");
    if (graph.contacts != NULL) graph.contacts = GUARD(state->contacts, 4 * state->count, "contacts");
    graph.poses = GUARD(state->poses, ends, "poses");
    if (graph.torques != NULL) graph.torques = GUARD(state->torques, ends, "torques");
    if (view.poses != NULL) {
        view.poses = graph.poses;
        view.placed = GUARD(state->placed, ends, "placed");
        view.placed_poses = GUARD(state->placed_poses, ends, "placed_poses");
        view.has_angle = GUARD(state->has_angle, ends, "has_angle");
    }
    if (graph.bodies != NULL) graph.bodies = bodies.points;
    if (graph.masses != NULL) graph.masses = bodies.masses;
    const double *lengths = GUARD(state->lengths, state->count, "length"),
                 *rates = GUARD(state->rates, state->count, "rate");
    void *outputs[KIT_MOST_OUTPUTS] = {NULL};
    for (int k = 0; k < function->output_count; k++) {
        const KitOutput *output = &function->outputs[k];
        const gsize size = output->integers ? sizeof(int32_t) : sizeof(double);
        outputs[k] =
            guarded(kit_output_entries(output, state) * (gsize)output->width * size, at_end, output->name, FALSE);
    }
    protect_inputs();
    kit_phase(check, "%s", function->name);
    function->call(function, state->block_class,
                   &(KitArguments){&view, lengths, rates, points, &bodies, &graph, outputs});
    free_areas();
}

void kit_try_memory(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    if (functions->len == 0) kit_skip(check, "it offers no function over batches");
    g_autoptr(KitState) state = functions->len == 0 ? NULL : kit_state_new(check, KIT_COUNT - 1);
    catch_faults(check->sheet);
    for (guint i = 0; state != NULL && i < functions->len; i++) {
        call_guarded(check, &g_array_index(functions, KitFunction, i), state, TRUE);
        call_guarded(check, &g_array_index(functions, KitFunction, i), state, FALSE);
    }
    signal(SIGSEGV, SIG_DFL);
    signal(SIGBUS, SIG_DFL);
}

/* speed ------------------------------------------------------------------------------------------------------------ */

#define TIMED_COUNT 256
#define TIMED_CALLS 2000

void kit_try_speed(KitCheck *check)
{
    static const char *const names[] = {"tension", "force", "rows_at", "motion", "rotation"};
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    const KitFunction *function = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(names) && function == NULL; i++)
        function = kit_function(functions, names[i]);
    if (function == NULL) {
        kit_skip(check, "it offers no function that is called inside a step");
        return;
    }
    const gboolean field = function->outputs[0].extent == KIT_BODIES;
    g_autoptr(KitState) state = kit_state_new(check, field ? 1 : TIMED_COUNT);
    if (state == NULL) return;
    g_autofree const double **views = g_new0(const double *, check->block_class->column_count + 1);
    TinkerBatch view = kit_state_view(state, views);
    const TinkerBodies bodies = {sizeof(TinkerBodies), state->body_count, state->bodies, state->masses, 0,
                                 state->body_range};
    g_autoptr(KitAnswer) room = kit_call_well(check, function, state);
    if (room == NULL) return;
    const KitArguments with = {
        &view, state->lengths, state->rates, state->points, &bodies, NULL, (void *const *)room->values};
    const gint64 start = g_get_monotonic_time();
    for (int i = 0; i < TIMED_CALLS; i++)
        function->call(function, check->block_class, &with);
    const double elapsed = (double)(g_get_monotonic_time() - start) * 1e3 / TIMED_CALLS;
    kit_tell(check, "%s takes %.3g ns a%s", function->name, elapsed / (field ? state->body_count : state->count),
             field ? " body" : "n instance");
}
