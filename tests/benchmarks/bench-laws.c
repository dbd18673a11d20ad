/* What a law that is typed costs: calls of the typed connector beside those of a spring of the same law that is
 * compiled (sdk/examples/cubic-spring), with one and with many in a batch. */
#include <math.h>
#include <string.h>
#include <tinker/sdk.h>

#include "build-catalogue.h"
#include "measure.h"
#include "report.h"
#include "scene/frame/batch.h"
#include "scene/read/scene-json.h"

const TinkerPlugin *tinker_plugin_v1(void); /* of the cubic spring, which is linked in */

#define MOST   1000
#define OFFSET 1.0 /* m: its length at rest */

/* One batch of connectors, and where they are. */
typedef struct {
    const TinkerLineLaw *law;
    TinkerBatch batch;
    double length[MOST], rate[MOST], result[MOST], unused[MOST];
} Calls;

typedef TinkerStatus (*Call)(Calls *calls);

static TinkerStatus call_tension(Calls *calls)
{
    return calls->law->tension(&calls->batch, calls->length, calls->rate, calls->result);
}

static TinkerStatus call_derivatives(Calls *calls)
{
    return calls->law->derivatives(&calls->batch, calls->length, calls->rate, calls->result, calls->unused);
}

static TinkerStatus call_energy(Calls *calls)
{
    return calls->law->energy(&calls->batch, calls->length, calls->result);
}

static const struct {
    const char *name;
    Call call;
} functions[] = {{"tension", call_tension}, {"derivatives", call_derivatives}, {"energy", call_energy}};

static const int sizes[] = {1, 10, MOST};

/* As BenchmarkWork: a unit is a call. */
typedef struct {
    Calls *calls;
    Call call;
} Timed;

static double time_calls(gint64 units, void *data)
{
    const Timed *timed = data;
    const double started = benchmark_processor_time();
    for (; units > 0; units--)
        if (timed->call(timed->calls) != TINKER_OK) g_error("a call failed");
    return benchmark_processor_time() - started;
}

static void place(Calls *calls)
{
    for (int i = 0; i < MOST; i++) {
        calls->length[i] = OFFSET + 0.3 * sin(i + 1.0);
        calls->rate[i] = cos(i + 1.0);
    }
}

static double stiffness(int i, gboolean alike)
{
    return alike ? 5 : 5 + 0.001 * i;
}

static double hardening(int i, gboolean alike)
{
    return alike ? 40 : 40 + 0.01 * i;
}

/* Of the type's interfaces, its physics. */
static const TinkerPhysics *physics_of(const TinkerBlockType *type)
{
    const TinkerInterface *interfaces = type->interfaces.data;
    int i = 0;
    while (strcmp(interfaces[i].id, TINKER_PHYSICS_INTERFACE) != 0)
        i++;
    return interfaces[i].vtable;
}

static void take_compiled(Calls *calls, int count, gboolean alike)
{
    static double k[MOST], c[MOST], rest[MOST];
    static const double *const columns[] = {k, c, rest};
    const TinkerBlockType *type = tinker_plugin_v1()->blocks.data;
    for (int i = 0; i < MOST; i++) {
        k[i] = stiffness(i, alike);
        c[i] = hardening(i, alike);
        rest[i] = OFFSET;
    }
    calls->law = physics_of(type)->line_law;
    calls->batch = (TinkerBatch){.struct_size = sizeof(TinkerBatch), .count = count, .ends = 2, .columns = columns};
}

/* A scene of typed connectors, each with a mass of its own. (transfer full) */
static char *scene_text(int count, const char *law, gboolean alike)
{
    GString *text = g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"S\"}");
    for (int i = 0; i < count; i++) {
        g_string_append_printf(text, ", {\"type\": \"mass\", \"name\": \"M%d\", \"position\": [1, 0]}", i);
        g_string_append_printf(text, ", {\"type\": \"law-connector\", \"ends\": [\"S\", \"M%d\"], %s", i, law);
        g_string_append_printf(text, ", \"a\": \"%.17g N/m\", \"b\": \"%.17g N/m^3\", \"c\": \"1 m\"}",
                               stiffness(i, alike), hardening(i, alike));
    }
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

typedef struct {
    TinkerScene *scene;
    GPtrArray *batches;
} Typed;

static Typed take_typed(Calls *calls, TinkerCatalogue *catalogue, int count, const char *law, gboolean alike)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *text = scene_text(count, law, alike);
    Typed typed = {.scene = tinker_scene_read_text(catalogue, text, strlen(text), NULL, NULL, &error)};
    if (typed.scene == NULL) g_error("%s", error->message);
    typed.batches = tinker_batches_new(typed.scene, NULL);
    for (guint i = 0; i < typed.batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(typed.batches, i);
        if (batch->law_count == 0) continue;
        calls->law = batch->block_class->physics->line_law;
        calls->batch = tinker_block_batch_view(batch, 0);
    }
    return typed;
}

/* Both answer the same, to rounding. */
static double difference(const Calls *a, const Calls *b)
{
    double most = 0;
    for (int i = 0; i < a->batch.count; i++)
        most = fmax(most, fabs(a->result[i] - b->result[i]) / (1 + fabs(b->result[i])));
    return most;
}

static void measure(BenchmarkReport *report, TinkerCatalogue *catalogue, int count, const char *kind, const char *law,
                    gboolean alike)
{
    static Calls compiled, by_hand;
    g_autofree char *scene = count == 1 ? g_strdup_printf("%s, one", kind)
                                        : g_strdup_printf("%s, %d%s", kind, count, alike ? " alike" : " of their own");
    if (!benchmark_report_wants(report, scene)) return;
    take_compiled(&compiled, count, alike);
    Typed typed = take_typed(&by_hand, catalogue, count, law, alike);
    place(&compiled);
    place(&by_hand);
    for (gsize i = 0; i < G_N_ELEMENTS(functions); i++) {
        Timed first = {&by_hand, functions[i].call}, second = {&compiled, functions[i].call};
        if (functions[i].call == call_energy && strcmp(kind, "potential") != 0) continue; /* it has none */
        BenchmarkTask typed_task = {.work = time_calls, .data = &first};
        BenchmarkTask compiled_task = {.work = time_calls, .data = &second};
        benchmark_time_pair(&typed_task, &compiled_task);
        if (difference(&by_hand, &compiled) > 1e-13) g_error("%s, %s: they differ", scene, functions[i].name);
        const double ns = 1e9 / count, floor = ns * compiled_task.timing.minimum;
        g_autofree char *call = g_strdup_printf("%s, a connector", functions[i].name);
        g_autofree char *beside = g_strdup_printf("%s, compiled", functions[i].name);
        g_autofree char *ratio = g_strdup_printf("%s, ratio", functions[i].name);
        benchmark_report_figure(report, scene, call, ns * typed_task.timing.minimum, "ns", NAN);
        benchmark_report_figure(report, scene, beside, floor, "ns", NAN);
        benchmark_report_figure(report, scene, ratio, ns * typed_task.timing.minimum / floor, "", 4);
    }
    g_ptr_array_unref(typed.batches);
    tinker_scene_free(typed.scene);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *kind, *law;
    } laws[] = {
        {"potential", "\"potential\": \"a/2*(L - c)^2 + b/4*(L - c)^4\""},
        {"tension", "\"tension\": \"a*(L - c) + b*(L - c)^3\""},
    };
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    TinkerCatalogue *catalogue = test_build_catalogue();
    for (gsize k = 0; k < G_N_ELEMENTS(laws); k++) {
        for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++) {
            measure(report, catalogue, sizes[i], laws[k].kind, laws[k].law, TRUE);
            if (sizes[i] > 1) measure(report, catalogue, sizes[i], laws[k].kind, laws[k].law, FALSE);
        }
    }
    tinker_catalogue_free(catalogue);
    return benchmark_report_end(report);
}
