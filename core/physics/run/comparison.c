/* The companion is a simulation of its own, on a model of its own: nothing that it does can change a bit of the run.
 * Each island's is stepped along with the run's, and compared at points of its steps and at samples, so that what is
 * claimed does not depend on how often somebody looks. */
#include "physics/run/comparison-private.h"

#include <math.h>

#include "physics/compile/compile.h"
#include "physics/island/island-run.h"
#include "physics/record/columns.h"

/* us: so long a companion that nobody waits for any more has to catch up. */
#define GRACE 300000

/* Asked by the companion now and then. */
static gboolean is_late(void *data)
{
    TinkerComparison *self = data;
    const TinkerRunOptions *options = &self->of_the_run;
    gint64 deadline = atomic_load(&self->deadline);
    if (deadline == 0 && options->cancelled != NULL && g_thread_self() == self->owner &&
        options->cancelled(options->data)) {
        tinker_comparison_hurry(self);
        deadline = atomic_load(&self->deadline);
    }
    return deadline > 0 && g_get_monotonic_time() >= deadline;
}

static gboolean open_companion(TinkerComparison *self, TinkerIslandRuns *runs, const GArray *columns, GError **error)
{
    self->model = tinker_model_new(runs->model->scene, error);
    if (self->model == NULL) return FALSE;
    TinkerIslandRuns *companion = self->companion = tinker_companion_new(runs, self->model, error);
    if (companion == NULL) return FALSE;
    companion->options.cancelled = is_late;
    companion->options.data = self;
    if (columns != NULL && runs->options.bands) {
        self->columns = columns->len;
        self->findings.bands = self->bands = g_new0(double, columns->len + 1);
        tinker_island_runs_take_columns(companion, columns);
        self->turns = tinker_columns_turn(columns);
        self->places = tinker_columns_place(columns);
    }
    for (guint i = 0; i < self->islands; i++) {
        ComparisonPart *part = &self->parts[i];
        TinkerIslandRun *other = g_ptr_array_index(companion->runs, i);
        part->ends = tinker_companion_ends_new(other);
        part->marks = g_array_new(FALSE, FALSE, sizeof(ComparisonMark));
        part->kept = g_new0(double, 2 * TINKER_MOST_STEP_POINTS * (gsize)other->model->coordinates);
        other->abandoned = part->factor == 0 && self->bands == NULL; /* nobody asks where it is */
    }
    return TRUE;
}

TinkerComparison *tinker_comparison_new(TinkerIslandRuns *runs, const GArray *columns, GError **error)
{
    TinkerComparison *self = g_new0(TinkerComparison, 1);
    gboolean compares = FALSE;
    self->sizes = g_array_new(FALSE, FALSE, sizeof(int32_t));
    self->islands = runs->runs->len;
    self->coordinates = runs->model->coordinates;
    self->parts = g_new0(ComparisonPart, self->islands);
    self->q = g_new0(double, (gsize)self->coordinates + 1);
    self->v = g_new0(double, (gsize)self->coordinates + 1);
    self->findings = (TinkerFindings){.predictable_until = INFINITY};
    self->owner = g_thread_self();
    self->of_the_run = runs->options;
    for (guint i = 0; i < self->islands; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(runs->runs, i);
        g_array_append_val(self->sizes, run->model->coordinates);
        self->parts[i].factor = tinker_companion_factor(run);
        compares |= self->parts[i].factor > 0;
    }
    if (!compares || open_companion(self, runs, columns, error)) return self;
    tinker_comparison_free(self);
    return NULL;
}

void tinker_comparison_free(TinkerComparison *self)
{
    if (self == NULL) return;
    for (guint i = 0; i < self->islands; i++) {
        tinker_companion_ends_free(self->parts[i].ends);
        g_clear_pointer(&self->parts[i].marks, g_array_unref);
        g_free(self->parts[i].kept);
    }
    tinker_island_runs_free(self->companion);
    tinker_model_free(self->model);
    g_array_unref(self->sizes);
    gpointer arrays[] = {self->parts, self->q, self->v, self->bands, self->turns, self->places, self->findings.failure};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

gboolean tinker_comparison_has_companion(const TinkerComparison *self)
{
    return self->companion != NULL;
}

guint tinker_comparison_columns(const TinkerComparison *self)
{
    return self->columns;
}

gsize tinker_comparison_step_bytes(const TinkerComparison *self, guint island, int32_t points)
{
    const int32_t coordinates = g_array_index(self->sizes, int32_t, island);
    return sizeof(TinkerStepNews) + 2 * (gsize)coordinates * (gsize)points * sizeof(double);
}

gsize tinker_comparison_sample_bytes(const TinkerComparison *self)
{
    const gsize states = self->companion != NULL ? 2 * (gsize)self->coordinates : 0;
    return sizeof(TinkerSampleNews) + self->islands * sizeof(TinkerIslandNews) +
           (states + self->columns) * sizeof(double);
}

void tinker_comparison_take(void *comparison, const void *news)
{
    TinkerComparison *self = comparison;
    if (g_atomic_int_get(&self->state) != TINKER_COMPARISON_GOES_ON) return;
    if (*(const TinkerNewsKind *)news == TINKER_NEWS_STEP)
        comparison_take_step(self, news);
    else
        comparison_take_sample(self, news);
}

TinkerComparisonState tinker_comparison_state(const TinkerComparison *self)
{
    return (TinkerComparisonState)g_atomic_int_get(&self->state);
}

void tinker_comparison_stop(TinkerComparison *self)
{
    atomic_store(&self->deadline, 1);
}

void tinker_comparison_hurry(TinkerComparison *self)
{
    gint64 none = 0;
    atomic_compare_exchange_strong(&self->deadline, &none, g_get_monotonic_time() + GRACE);
}

TinkerFindings *tinker_comparison_findings(TinkerComparison *self)
{
    return &self->findings;
}
