#include "random-scenes.h"

#include "random-draft.h"

const char *const random_scene_kinds[] = {
    "straight springs", "passing",     "plane springs",  "pendula",     "linkages",        "driven supports",
    "motors",           "wind",        "stiff",          "landing",     "bouncing",        "elastic bouncing",
    "incline",          "wedge",       "springs, floor", "rods, floor", "pendulum, floor", "moving floor",
    "stick and slip",   "wind, floor", "motor, floor",   NULL,
};

static void (*const writers[])(RandomDraft *) = {
    draft_write_straight,
    draft_write_passing,
    draft_write_plane,
    draft_write_pendulum,
    draft_write_linkage,
    draft_write_driven,
    draft_write_motors,
    draft_write_wind,
    draft_write_stiff,
    draft_write_landing,
    draft_write_bouncing,
    draft_write_elastic,
    draft_write_incline,
    draft_write_wedge,
    draft_write_springs_over_floor,
    draft_write_rods_onto_floor,
    draft_write_pendulum_onto_floor,
    draft_write_moving_floor,
    draft_write_stick_slip,
    draft_write_wind_over_floor,
    draft_write_motor_on_floor,
};

G_STATIC_ASSERT(G_N_ELEMENTS(writers) + 1 == G_N_ELEMENTS(random_scene_kinds));

RandomScene *random_scene_new(guint kind, guint32 seed)
{
    RandomScene *scene = g_new0(RandomScene, 1);
    const guint32 seeds[] = {kind, seed};
    g_autoptr(GRand) dice = g_rand_new_with_seed_array(seeds, G_N_ELEMENTS(seeds));
    g_autoptr(GString) blocks = g_string_new(NULL);
    RandomDraft draft = {dice, blocks, scene};
    scene->duration = draft_between(&draft, 1.5, 6);
    scene->rate = 5;
    writers[kind](&draft);
    scene->text = g_strdup_printf("{\"tinker\": 1, \"run\": {\"duration\": %.17g}, \"blocks\": [\n%s]}\n",
                                  scene->duration, blocks->str);
    g_strdelimit(scene->text, "'", '"');
    return scene;
}

void random_scene_free(RandomScene *scene)
{
    if (scene == NULL) return;
    g_free(scene->text);
    g_free(scene);
}
