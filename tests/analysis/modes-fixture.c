/* A scene and its modes. */
#include "modes-fixture.h"

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
