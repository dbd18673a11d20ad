/* What an edit of many blocks costs: removing 5 000 of 20 000, taking that back, and one frame of dragging 5 000. */
#include <math.h>

#include "build-catalogue.h"
#include "measure.h"
#include "report.h"
#include "scene/history/history.h"
#include "subject.h"

#define EDITED 5000
#define FRAMES 20

typedef struct {
    TinkerCatalogue *catalogue;
    TinkerScene *scene;
    TinkerHistory *history;
    TinkerBlockId masses[2 * EDITED];
} Chain;

static const TinkerBlockClass *class_of(Chain *chain, const char *type)
{
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(chain->catalogue, type, &error);
    if (block_class == NULL) g_error("%s", error->message);
    return block_class;
}

static void open_chain(Chain *chain)
{
    chain->catalogue = test_build_catalogue();
    chain->scene = tinker_scene_new(chain->catalogue);
    chain->history = tinker_history_new(chain->scene);
    for (int i = 0; i < 2 * EDITED; i++) {
        chain->masses[i] = tinker_scene_add_block(chain->scene, class_of(chain, "mass"), NULL, NULL);
        if (i == 0) continue;
        TinkerBlockId spring = tinker_scene_add_block(chain->scene, class_of(chain, "spring"), NULL, NULL);
        tinker_scene_set_end(chain->scene, spring, 0, (TinkerSceneEnd){chain->masses[i - 1], 0, 0}, NULL);
        tinker_scene_set_end(chain->scene, spring, 1, (TinkerSceneEnd){chain->masses[i], 0, 0}, NULL);
    }
}

static void report_time(BenchmarkReport *report, const char *what, double seconds)
{
    benchmark_report_figure(report, "5000 of 20000 blocks", what, 1e3 * seconds, "ms", NAN);
}

static void drag(Chain *chain, double y)
{
    const int32_t position = class_of(chain, "mass")->meanings[TINKER_MEANING_POSITION];
    tinker_history_begin(chain->history, "Move", "drag");
    for (int i = 0; i < EDITED; i++)
        tinker_history_set(chain->history, chain->masses[i], position, (double[]){i, y}, NULL);
    tinker_history_end(chain->history);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    g_autofree Chain *chain = g_new0(Chain, 1);
    open_chain(chain);
    double began = benchmark_processor_time();
    tinker_history_remove_blocks(chain->history, chain->masses, EDITED);
    report_time(report, "remove", benchmark_processor_time() - began);
    began = benchmark_processor_time();
    tinker_history_undo(chain->history);
    report_time(report, "undo", benchmark_processor_time() - began);
    began = benchmark_processor_time();
    for (int frame = 0; frame < FRAMES; frame++)
        drag(chain, 0.1 * frame);
    report_time(report, "a frame of a drag", (benchmark_processor_time() - began) / FRAMES);
    tinker_history_free(chain->history);
    tinker_scene_free(chain->scene);
    tinker_catalogue_free(chain->catalogue);
    return benchmark_report_end(report);
}
