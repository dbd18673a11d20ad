/* What contacts of bodies that hang together cost: chains of rods that fall onto a floor, masses in a row of springs
 * that slide on one; and the equations of a few contacts by their matrix beside elimination. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "numerics/sharing/sharing.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/model/state.h"
#include "report.h"
#include "subject.h"

#define FLOOR                                                                                                          \
    "{\"type\": \"gravity\"}, {\"type\": \"support\", \"position\": [0, 0], \"width\": 3000, \"height\": 0.4, "        \
    "\"restitution\": 0, \"static_friction\": 0.3, \"dynamic_friction\": 0.3}"
#define MASS ", {\"type\": \"mass\", \"name\": \"m%d\", \"mass\": 1, \"width\": 0, \"height\": 0, "

/* Nearly level, half a metre over the floor: they fall, strike it here and there, fold and come to rest. */
static char *chain_of(int masses, const char *contacts)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "{\"tinker\": 1, \"run\": {\"contacts\": \"%s\"}, \"blocks\": [" FLOOR, contacts);
    for (int i = 0; i < masses; i++) {
        g_string_append_printf(text, MASS "\"position\": [%.17g, %.17g]}", i, i - 0.5 * masses, 0.5 + 0.05 * sin(i));
        if (i > 0) g_string_append_printf(text, ", {\"type\": \"rod\", \"ends\": [\"m%d\", \"m%d\"]}", i - 1, i);
    }
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

/* All touch; `slides`: they are pushed along at speeds of up to 1 m/s, and come to rest one by one. */
static char *row_of(int masses, gboolean slides)
{
    GString *text = g_string_new("{\"tinker\": 1, \"run\": {}, \"blocks\": [" FLOOR);
    for (int i = 0; i < masses; i++) {
        g_string_append_printf(text, MASS "\"position\": [%.17g, 0.2], \"velocity\": [%.17g, 0]}", i, i - 0.5 * masses,
                               slides ? sin(12.9898 * i) : 0.0);
        if (i > 0)
            g_string_append_printf(text,
                                   ", {\"type\": \"spring\", \"stiffness\": 100, \"rest_length\": %.17g, \"ends\": "
                                   "[\"m%d\", \"m%d\"]}",
                                   1 + 0.01 * sin(i), i - 1, i);
    }
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

/* One run of 1 s, once: they take seconds, and what is looked for is how they grow. */
static void measure_run(BenchmarkReport *report, const char *scene, char *text, const char *method, double step,
                        double goal)
{
    if (benchmark_report_wants(report, scene)) {
        BenchmarkSubject subject = benchmark_subject(text, method, step);
        g_autoptr(GError) error = NULL;
        subject.options.duration = subject.options.interval = 1;
        subject.options.estimate = FALSE;
        benchmark_subject_restart(&subject);
        const double started = benchmark_processor_time();
        if (!tinker_simulation_run(subject.simulation, NULL, NULL, NULL, &error)) g_error("%s", error->message);
        benchmark_report_figure(report, scene, "1 s", benchmark_processor_time() - started, "s", goal);
        benchmark_subject_clear(&subject);
    }
    g_free(text);
}

/* Equations -------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerContacts *contacts;
    TinkerContactElimination *elimination;
    TinkerContactEquation *equations;
    TinkerDenseSolve *solve;
    int count;
    double *matrix, *b, *x, *column;
} Equations;

/* Every matrix is another one than before, by rounding, as at each evaluation: of one and the same the factors are
 * kept.
 */
static double solve_by_matrix(gint64 units, void *data)
{
    Equations *self = data;
    const double started = benchmark_processor_time();
    for (; units > 0; units--) {
        const double other = 1 + (double)(units & 1) * DBL_EPSILON;
        for (int j = 0; j < self->count; j++) {
            const TinkerContactEquation *of = &self->equations[j];
            memset(self->column, 0, (gsize)self->contacts->model->coordinates * sizeof(double));
            tinker_contacts_push(self->contacts, of->body, of->force[0], of->force[1], self->column);
            for (int i = 0; i < self->count; i++)
                self->matrix[i * self->count + j] =
                    other * (self->equations[i].row[0] * self->column[2 * self->equations[i].body] +
                             self->equations[i].row[1] * self->column[2 * self->equations[i].body + 1]);
        }
        memcpy(self->x, self->b, (gsize)self->count * sizeof(double));
        tinker_dense_solve_factor(self->solve, self->matrix);
        tinker_dense_solve(self->solve, self->x);
    }
    return benchmark_processor_time() - started;
}

static double solve_by_elimination(gint64 units, void *data)
{
    Equations *self = data;
    const double started = benchmark_processor_time();
    for (; units > 0; units--) {
        tinker_contact_elimination_take(self->elimination, self->equations, self->count);
        tinker_contact_elimination_solve(self->elimination, self->b, self->x);
    }
    return benchmark_processor_time() - started;
}

static void measure_equations(BenchmarkReport *report, int masses, int count)
{
    g_autofree char *scene = g_strdup_printf("%d equations on %d rods", count, masses - 1);
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = chain_of(masses, "events");
    BenchmarkSubject subject = benchmark_subject(text, "rk4", 1e-3);
    TinkerModel *model = subject.model;
    TinkerContactElimination *elimination =
        tinker_contact_elimination_new(model, model->contacts->group, 0, model->contacts->column);
    Equations equations = {.contacts = model->contacts, .elimination = elimination, .count = count};
    const gsize n = (gsize)count;
    equations.equations = g_new0(TinkerContactEquation, n);
    equations.matrix = g_new0(double, n *n);
    equations.b = g_new0(double, n);
    equations.x = g_new0(double, n);
    equations.column = g_new0(double, 2 * (gsize)masses);
    equations.solve = tinker_dense_solve_new(count);
    for (int e = 0; e < count; e++) {
        equations.equations[e] = (TinkerContactEquation){(int32_t)(e * (masses - 1) / count), {0, 1}, {0.1, 1}, 0};
        equations.b[e] = sin(e);
    }
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (tinker_constraints_evaluate(model) != TINKER_OK || !tinker_contact_elimination_make_room(elimination, n))
        g_error("no equations");
    BenchmarkTask matrix = {.work = solve_by_matrix, .data = &equations}, other = matrix;
    other.work = solve_by_elimination;
    benchmark_time_pair(&matrix, &other);
    benchmark_report_figure(report, scene, "by matrix", 1e6 * matrix.timing.minimum, "µs", NAN);
    benchmark_report_figure(report, scene, "by elimination", 1e6 * other.timing.minimum, "µs", NAN);
    tinker_dense_solve_free(equations.solve);
    tinker_contact_elimination_free(elimination);
    gpointer arrays[] = {equations.equations, equations.matrix, equations.b, equations.x, equations.column};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    benchmark_subject_clear(&subject);
}

int main(int argc, char **argv)
{
    static const int counts[] = {1, 2, 4, 8, 16, 64};
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    tinker_share_set_threads(1);
    for (gsize k = 0; k < G_N_ELEMENTS(counts); k++)
        for (int masses = 80; masses <= 320; masses *= 4)
            measure_equations(report, masses, counts[k]);
    for (int masses = 250; masses <= 1000; masses *= 2) {
        g_autofree char *scene = g_strdup_printf("%d masses as impulses, chain onto a floor", masses);
        measure_run(report, scene, chain_of(masses, "impulse"), "rk4", 0.01, masses == 1000 ? 10 : NAN);
    }
    measure_run(report, "1000 masses in a row of springs, at rest", row_of(1000, FALSE), "dop853", 0.01, 1);
    measure_run(report, "1000 masses in a row of springs, sliding", row_of(1000, TRUE), "dop853", 0.01, 1);
    for (int masses = 80; masses <= 320; masses *= 2) {
        g_autofree char *scene = g_strdup_printf("%d masses by events, chain onto a floor", masses);
        measure_run(report, scene, chain_of(masses, "events"), "dop853", 0.01, masses == 320 ? 5 : NAN);
    }
    return benchmark_report_end(report);
}
