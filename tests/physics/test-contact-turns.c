/* When changes of one contact count as turns at one instant: a motion is the same whenever it begins. */
#include <glib.h>

#include "physics/event/contact-run-private.h"
#include "physics/island/island-run.h"

/* Whether a contact that sticks and slips every `interval` (s) goes by turns after some of that, from a time on, where
 * usual steps are 1 ms long. */
static gboolean goes_by_turns(double from, double interval)
{
    TinkerIslandRun run = {.state.t = from};
    TinkerContactRun contact_run = {.run = &run, .usual = 1e-3, .turns = tinker_contact_turns_new()};
    const TinkerTrigger triggers[] = {{.kind = TINKER_TRIGGER_FORWARD, .body = 3, .plate = 1, .row = -1},
                                      {.kind = TINKER_TRIGGER_SPEED, .body = 3, .plate = 1, .row = -1}};
    for (int i = 0; i < 100; i++, run.state.t += interval)
        tinker_contact_run_note_turn(&contact_run, &triggers[i % 2]);
    const gboolean goes = tinker_contact_run_goes_by_turns(&contact_run, &triggers[0]);
    g_array_unref(contact_run.turns);
    return goes;
}

static void test_any_time(void)
{
    static const double starts[] = {1e-3, 1, 1e5};
    for (gsize i = 0; i < G_N_ELEMENTS(starts); i++) {
        g_assert_false(goes_by_turns(starts[i], 5e-3));
        g_assert_false(goes_by_turns(starts[i], 1e-4));
        g_assert_true(goes_by_turns(starts[i], 1e-9));
        g_assert_true(goes_by_turns(starts[i], 0));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/contact-turns/any-time", test_any_time);
    return g_test_run();
}
