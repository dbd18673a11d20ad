/* Edits of many blocks at once: what is done of them is counted. A pass over the scene is made as often for many blocks
 * as for few, and each block is copied as often. */
#include "scene-fixture.h"

#include "scene/history/history.h"
#include "scene/store/scene-data.h"

static int passes, copies;

/* The wrapper stands before the function wherever another file calls it. */
#define WRAPPED(type, name, parameters)                                                                                \
    type __real_##name parameters;                                                                                     \
    __attribute__((visibility("default"))) type __wrap_##name parameters;                                              \
    type __wrap_##name parameters
#define COUNTING(counter, type, name, parameters, arguments)                                                           \
    WRAPPED(type, name, parameters)                                                                                    \
    {                                                                                                                  \
        counter++;                                                                                                     \
        return __real_##name arguments;                                                                                \
    }
#define COUNTING_CALL(counter, name, parameters, arguments)                                                            \
    WRAPPED(void, name, parameters)                                                                                    \
    {                                                                                                                  \
        counter++;                                                                                                     \
        __real_##name arguments;                                                                                       \
    }
COUNTING(passes, GArray *, scene_attached_to, (const TinkerScene *scene, GHashTable *blocks), (scene, blocks))
COUNTING(passes, GArray *, scene_graphs_of, (const TinkerScene *scene, GHashTable *blocks), (scene, blocks))
COUNTING(passes, GArray *, scene_placeholders_on, (const TinkerScene *scene, GHashTable *blocks), (scene, blocks))
COUNTING(passes, int32_t, scene_order_of, (const TinkerScene *scene, TinkerBlockId block), (scene, block))
COUNTING_CALL(passes, scene_table_remove, (TinkerScene * scene, SceneTable *table, GHashTable *blocks),
              (scene, table, blocks))
COUNTING_CALL(passes, scene_table_insert,
              (TinkerScene * scene, SceneTable *table, const SceneNewRow *rows, int32_t count),
              (scene, table, rows, count))
COUNTING(copies, SceneSnapshot *, scene_snapshot_take, (const TinkerScene *scene, TinkerBlockId block), (scene, block))

typedef struct {
    TinkerScene *scene;
    TinkerHistory *history;
    GArray *masses; /* of TinkerBlockId */
} Chain;

/* A chain of masses and springs. */
static Chain chain_new(int masses)
{
    Chain chain = {.scene = tinker_scene_new(scene_fixture_catalogue())};
    chain.history = tinker_history_new(chain.scene);
    chain.masses = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int i = 0; i < masses; i++) {
        TinkerBlockId mass = tinker_scene_add_block(chain.scene, scene_fixture_class("mass"), NULL, NULL);
        g_array_append_val(chain.masses, mass);
        if (i == 0) continue;
        TinkerBlockId spring = tinker_scene_add_block(chain.scene, scene_fixture_class("spring"), NULL, NULL);
        for (int end = 0; end < 2; end++) {
            TinkerSceneEnd to = {g_array_index(chain.masses, TinkerBlockId, i - 1 + end), 0, 0};
            g_assert_true(tinker_scene_set_end(chain.scene, spring, end, to, NULL));
        }
    }
    return chain;
}

static void chain_clear(Chain *chain)
{
    tinker_history_free(chain->history);
    tinker_scene_free(chain->scene);
    g_array_unref(chain->masses);
}

static const TinkerBlockId *first_of(const Chain *chain)
{
    return (const TinkerBlockId *)(gpointer)chain->masses->data;
}

/* Work, for so many blocks. */
typedef struct {
    int passes, copies;
} Work;

static Work counted(void)
{
    Work work = {passes, copies};
    passes = copies = 0;
    return work;
}

/* What removing the first `count` masses of a chain of twice as many, undoing and redoing it takes. */
static void remove_masses(int count, Work work[3])
{
    Chain chain = chain_new(2 * count);
    g_autofree char *before = tinker_scene_to_text(chain.scene, TINKER_WRITE_SI);
    counted();
    tinker_history_remove_blocks(chain.history, first_of(&chain), (gsize)count);
    work[0] = counted();
    g_assert_cmpint(tinker_scene_block_count(chain.scene), ==, 4 * count - 1 - count);
    g_autofree char *after = tinker_scene_to_text(chain.scene, TINKER_WRITE_SI);
    tinker_history_undo(chain.history);
    work[1] = counted();
    g_autofree char *undone = tinker_scene_to_text(chain.scene, TINKER_WRITE_SI);
    g_assert_cmpstr(undone, ==, before);
    tinker_history_redo(chain.history);
    work[2] = counted();
    g_autofree char *redone = tinker_scene_to_text(chain.scene, TINKER_WRITE_SI);
    g_assert_cmpstr(redone, ==, after);
    g_assert_null(tinker_history_can_redo(chain.history));
    tinker_history_undo(chain.history);
    g_assert_null(tinker_history_can_undo(chain.history)); /* one step it was */
    chain_clear(&chain);
}

static void test_remove(void)
{
    Work few[3], many[3];
    remove_masses(20, few);
    remove_masses(200, many);
    for (int i = 0; i < 3; i++)
        g_assert_cmpint(many[i].passes, ==, few[i].passes);
    /* each mass once, and the spring on it, all of which stay, before and after */
    g_assert_cmpint(many[0].copies, ==, 200 + 2 * 200);
    g_assert_cmpint(many[1].copies + many[2].copies, ==, 0);
}

/* As a drag does it: many steps that become one. */
static void drag_masses(int count, int frames, Work *work)
{
    Chain chain = chain_new(count);
    const int32_t position = scene_fixture_class("mass")->meanings[TINKER_MEANING_POSITION];
    g_autofree char *before = tinker_scene_to_text(chain.scene, TINKER_WRITE_SI);
    counted();
    for (int frame = 1; frame <= frames; frame++) {
        tinker_history_begin(chain.history, "Move", "drag");
        for (int i = 0; i < count; i++)
            g_assert_true(tinker_history_set(chain.history, first_of(&chain)[i], position, (double[]){i, frame}, NULL));
        tinker_history_end(chain.history);
    }
    *work = counted();
    tinker_history_undo(chain.history);
    g_assert_null(tinker_history_can_undo(chain.history));
    g_autofree char *undone = tinker_scene_to_text(chain.scene, TINKER_WRITE_SI);
    g_assert_cmpstr(undone, ==, before);
    chain_clear(&chain);
}

static void test_drag(void)
{
    Work work;
    drag_masses(100, 7, &work);
    g_assert_cmpint(work.passes, ==, 0);
    g_assert_cmpint(work.copies, ==, 2 * 100 * 7);
}

static void add_tests(void)
{
    g_test_add_func("/history-many/remove", test_remove);
    g_test_add_func("/history-many/drag", test_drag);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
