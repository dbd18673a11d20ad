/* Opening, compiling and stepping a scene; see the header. */
#include "subject.h"

#include <math.h>
#include <string.h>

#include "build-catalogue.h"
#include "measure.h"
#include "physics/compile/compile.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "scene/read/scene-json.h"

static void require(gboolean fine, const GError *error)
{
    if (!fine) g_error("%s", error != NULL ? error->message : "failed");
}

BenchmarkSubject benchmark_subject(const char *text, const char *method, double step)
{
    g_autoptr(GError) error = NULL;
    BenchmarkSubject subject = {.catalogue = test_build_catalogue(), .lap = INFINITY};
    subject.scene = tinker_scene_read_text(subject.catalogue, text, strlen(text), NULL, NULL, &error);
    require(subject.scene != NULL, error);
    subject.model = tinker_model_new(subject.scene, &error);
    require(subject.model != NULL, error);
    subject.options = tinker_run_options_of(subject.scene);
    subject.options.method = method;
    subject.options.step = step;
    benchmark_subject_restart(&subject);
    return subject;
}

void benchmark_subject_clear(BenchmarkSubject *subject)
{
    g_clear_pointer(&subject->simulation, tinker_simulation_free);
    g_clear_pointer(&subject->model, tinker_model_free);
    g_clear_pointer(&subject->scene, tinker_scene_free);
    g_clear_pointer(&subject->catalogue, tinker_catalogue_free);
}

void benchmark_subject_restart(BenchmarkSubject *subject)
{
    g_autoptr(GError) error = NULL;
    g_clear_pointer(&subject->simulation, tinker_simulation_free);
    subject->simulation = tinker_simulation_new(subject->model, &subject->options, &error);
    require(subject->simulation != NULL, error);
}

void benchmark_subject_step(BenchmarkSubject *subject)
{
    g_autoptr(GError) error = NULL;
    require(tinker_simulation_step(subject->simulation, &error), error);
}

double benchmark_subject_work(gint64 steps, void *data)
{
    BenchmarkSubject *subject = data;
    double seconds = 0;
    while (steps > 0) {
        if (tinker_simulation_time(subject->simulation) >= subject->lap) benchmark_subject_restart(subject);
        double started = benchmark_processor_time();
        for (; steps > 0 && tinker_simulation_time(subject->simulation) < subject->lap; steps--)
            benchmark_subject_step(subject);
        seconds += benchmark_processor_time() - started;
    }
    return seconds;
}

void benchmark_subject_place(BenchmarkSubject *subject, const char *block, double place[2])
{
    double velocity[2];
    TinkerBlockId id = tinker_scene_find_block(subject->scene, block);
    require(tinker_simulation_state(subject->simulation, id, place, velocity), NULL);
}
