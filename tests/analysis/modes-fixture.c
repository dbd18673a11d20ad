/* A scene and its modes. */
#include "modes-fixture.h"

#include <math.h>

ModesFixture *modes_fixture_new(gboolean rest, const char *blocks)
{
    g_autoptr(GError) error = NULL;
    ModesFixture *fixture = g_new0(ModesFixture, 1);
    fixture->scene = physics_scene(NULL, blocks);
    fixture->analysis = tinker_mode_analysis_new(fixture->scene, rest, &error);
    if (fixture->analysis == NULL) g_error("%s", error->message);
    return fixture;
}

void modes_fixture_free(ModesFixture *fixture)
{
    tinker_mode_analysis_free(fixture->analysis);
    tinker_scene_free(fixture->scene);
    g_free(fixture);
}

ModesFixture *modes_about_rest(const char *blocks)
{
    return modes_fixture_new(TRUE, blocks);
}

const TinkerMode *modes_at(const ModesFixture *fixture, guint place)
{
    g_assert_cmpuint(place, <, fixture->analysis->modes->len);
    return g_ptr_array_index(fixture->analysis->modes, place);
}

guint modes_count(const ModesFixture *fixture, TinkerModeKind kind)
{
    guint count = 0;
    for (guint i = 0; i < fixture->analysis->modes->len; i++)
        count += modes_at(fixture, i)->kind == kind;
    return count;
}

void modes_assert_relative(const char *what, double value, double truth, double bound)
{
    if (fabs(value - truth) <= bound * fabs(truth)) return;
    g_test_message("%s: %.17g instead of %.17g, off by %.2e", what, value, truth, value / truth - 1);
    g_test_fail();
}

void modes_assert_frequencies(const ModesFixture *fixture, const double *truth, guint count)
{
    guint place = 0;
    g_assert_cmpuint(modes_count(fixture, TINKER_MODE_OSCILLATION), ==, count);
    for (guint i = 0; i < fixture->analysis->modes->len && place < count; i++) {
        if (modes_at(fixture, i)->kind != TINKER_MODE_OSCILLATION) continue;
        g_autofree char *what = g_strdup_printf("frequency %u", place);
        modes_assert_relative(what, modes_at(fixture, i)->natural, truth[place++], 1e-10);
    }
}
