/* Advice follows edits, is silent while a run is shown, and repairs what is there now. */
#include "gui/accuracy/advice-list.h"

#include "gui-fixture.h"

/* (1.2, -1.6) m/s is along the rod of direction (0.6, -0.8). */
#define PENDULUM                                                                                                       \
    "{'type': 'support', 'position': [0, 1]}, {'type': 'mass', 'position': [0.6, 0.2], 'velocity': [1.2, -1.6]},"      \
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}"
#define LONG_ROD                                                                                                       \
    "{'type': 'support'}, {'type': 'mass', 'position': [3, 4]},"                                                       \
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 4}"

/* A list, and how many findings are waited for. */
typedef struct {
    TinkerAdviceList *list;
    guint count;
} Wanted;

static gboolean has_come(void *data)
{
    const Wanted *wanted = data;
    return tinker_advice_list_findings(wanted->list)->len == wanted->count;
}

static void wait_for(TinkerAdviceList *list, guint count)
{
    Wanted wanted = {list, count};
    g_assert_true(gui_fixture_wait(has_come, &wanted));
}

static const TinkerAdvice *first_of(TinkerAdviceList *list)
{
    return g_ptr_array_index(tinker_advice_list_findings(list), 0);
}

static void move(GuiFixture *f, const char *name, double x, double y)
{
    TinkerBlockId block = gui_fixture_block(f, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_document_scene(f->document), block);
    tinker_document_begin(f->document, "Move", NULL);
    tinker_history_set(tinker_document_history(f->document), block, block_class->meanings[TINKER_MEANING_POSITION],
                       (double[]){x, y}, NULL);
    tinker_document_end(f->document);
}

static void test_finding_and_repair(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(PENDULUM);
    g_autoptr(TinkerAdviceList) list = tinker_advice_list_new(f->document, f->player);
    g_autoptr(GError) error = NULL;
    wait_for(list, 1);
    g_assert_cmpint(first_of(list)->kind, ==, TINKER_ADVICE_VELOCITY);
    g_assert_true(tinker_advice_list_repair(list, 0, &error));
    g_assert_no_error(error);
    g_assert_cmpfloat_with_epsilon(gui_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 0, 1e-14);
    g_assert_cmpfloat_with_epsilon(gui_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), 0, 1e-14);
    wait_for(list, 0);
    tinker_document_undo(f->document);
    g_assert_null(tinker_history_can_undo(tinker_document_history(f->document)));
    wait_for(list, 1);
}

/* What was found is 200 ms old when it is repaired: the length becomes what is drawn now. */
static void test_edited_since(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(LONG_ROD);
    g_autoptr(TinkerAdviceList) list = tinker_advice_list_new(f->document, f->player);
    g_autoptr(GError) error = NULL;
    wait_for(list, 1);
    move(f, "Mass 0", 0, 6);
    g_assert_true(tinker_advice_list_repair(list, 0, &error));
    g_assert_no_error(error);
    g_assert_cmpfloat_with_epsilon(gui_fixture_get(f, "Rod 0", TINKER_MEANING_LENGTH, 0), 6, 1e-14);
    wait_for(list, 0);
    move(f, "Mass 0", 0, 7);
    wait_for(list, 1);
    move(f, "Mass 0", 6, 0);
    g_assert_false(tinker_advice_list_repair(list, 0, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE);
    g_assert_cmpfloat_with_epsilon(gui_fixture_get(f, "Rod 0", TINKER_MEANING_LENGTH, 0), 6, 1e-14);
    wait_for(list, 0);
}

static void test_only_at_start(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(PENDULUM);
    g_autoptr(TinkerAdviceList) list = tinker_advice_list_new(f->document, f->player);
    TinkerBlockId culprit;
    wait_for(list, 1);
    g_assert_true(tinker_player_step(f->player, TRUE, &culprit, NULL));
    g_assert_cmpuint(tinker_advice_list_findings(list)->len, ==, 0);
    gui_fixture_pass(400);
    g_assert_cmpuint(tinker_advice_list_findings(list)->len, ==, 0);
    tinker_player_reset(f->player);
    wait_for(list, 1);
}

static void test_another_scene(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(PENDULUM);
    g_autoptr(TinkerAdviceList) list = tinker_advice_list_new(f->document, f->player);
    wait_for(list, 1);
    gui_fixture_start(f, "{'type': 'mass'}");
    g_assert_cmpuint(tinker_advice_list_findings(list)->len, ==, 0);
    gui_fixture_pass(400);
    g_assert_cmpuint(tinker_advice_list_findings(list)->len, ==, 0);
    gui_fixture_start(f, LONG_ROD);
    wait_for(list, 1);
}

static void count(guint *counter)
{
    ++*counter;
}

/* Nothing is told while edits follow one another; what is told in the end is of the last one. */
static void test_edits_in_a_row(void)
{
    g_autoptr(GuiFixture) f = gui_fixture_new(LONG_ROD);
    g_autoptr(TinkerAdviceList) list = tinker_advice_list_new(f->document, f->player);
    guint told = 0;
    g_signal_connect_swapped(list, "changed", G_CALLBACK(count), &told);
    for (int i = 0; i < 40; i++) {
        move(f, "Mass 0", 0, 5 + 0.1 * i);
        gui_fixture_pass(10);
    }
    g_assert_cmpuint(told, <=, 1); /* a machine may pause */
    wait_for(list, 1);
    gui_fixture_pass(400);
    g_assert_cmpfloat_with_epsilon(first_of(list)->length, 8.9, 1e-12);
}

/* It may go at any time of a look: waiting, looking, having looked. */
static void test_ends_while_looking(void)
{
    static const guint pauses[] = {0, 190, 200, 201, 205, 220};
    for (gsize i = 0; i < G_N_ELEMENTS(pauses); i++) {
        g_autoptr(GuiFixture) f = gui_fixture_new(PENDULUM);
        g_autoptr(TinkerAdviceList) list = tinker_advice_list_new(f->document, f->player);
        if (pauses[i] > 0) gui_fixture_pass(pauses[i]);
    }
    gui_fixture_pass(50);
}

static void add_tests(void)
{
    g_test_add_func("/advice-list/finding-and-repair", test_finding_and_repair);
    g_test_add_func("/advice-list/edited-since", test_edited_since);
    g_test_add_func("/advice-list/only-at-start", test_only_at_start);
    g_test_add_func("/advice-list/another-scene", test_another_scene);
    g_test_add_func("/advice-list/edits-in-a-row", test_edits_in_a_row);
    g_test_add_func("/advice-list/ends-while-looking", test_ends_while_looking);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
