/* Runs every bundled scene and holds it against what is known about it: closed forms, amplitudes of linear systems,
 * conserved quantities worked out here from the record alone. Whatever the scene, the energy books must balance and the
 * rods must keep their lengths. */
#include <glib.h>

#include "contact-cases.h"
#include "mass-cases.h"
#include "mechanism-cases.h"
#include "meeting-cases.h"
#include "mistake-cases.h"
#include "oscillation-cases.h"
#include "program.h"
#include "rolling-cases.h"
#include "woodpecker-case.h"

typedef struct {
    const char *name;
    const char *duration; /* of the run whose books are looked at */
    void (*check)(const char *path);
    double books; /* what the balance of the books may miss, of the energy exchanged; 0: 1e-6 */
} SceneCase;

/* A throw by steps of first order loses m g^2 h / 2 a second, of each kilogram 0.05 W at a millisecond. */
#define FIRST_ORDER 0.005

static const SceneCase scene_cases[] = {
    {"balanced-arm", "6", check_balanced_arm},
    {"ball-in-a-box", "3", check_ball_in_a_box},
    {"base-excitation", "10", check_base_excitation},
    {"beats", "10", check_beats},
    {"block-and-tackle", "3", check_block_and_tackle},
    {"bouncing-balls", "8", check_bouncing_balls},
    {"compound-pendulum", "10", check_compound_pendulum},
    {"damped-oscillator", "10", check_damped_oscillator},
    {"dominoes", "1.5", check_dominoes},
    {"double-bar-pendulum", "10", check_double_bar_pendulum},
    {"double-pendulum", "10", check_double_pendulum},
    {"el-centro-block", "10", check_el_centro_block},
    {"falling-chain", "1", check_falling_chain},
    {"four-bar-coupler-curve", "8", check_four_bar_coupler_curve},
    {"four-bar-linkage", "10", check_four_bar},
    {"free-fall", "1", check_free_fall},
    {"friction-incline", "10", check_friction_incline},
    {"friction-oscillator", "6", check_friction_oscillator},
    {"gear-train", "3", check_gear_train},
    {"geneva-wheel", "2", check_geneva_wheel},
    {"hanging-cable", "3", check_hanging_cable},
    {"heavy-pulley", "1.2", check_heavy_pulley},
    {"incline-landing", "4", check_incline_landing},
    {"kapitza-pendulum", "4", check_kapitza},
    {"ladder-on-wall", "1", check_ladder_on_wall},
    {"lift-off", "4", check_lift_off},
    {"motor-on-mass", "10", check_motor_on_mass},
    {"newtons-cradle", "3.5", check_newtons_cradle},
    {"newtons-cradle-at-once", "2", check_newtons_cradle_at_once},
    {"normal-forces", "2", check_normal_forces},
    {"one-sided-support", "1.5", check_one_sided_support},
    {"pendulum", "10", check_pendulum},
    {"pendulum-wave", "10", check_pendulum_wave},
    {"pile-and-ball", "1.5", check_pile_and_ball, .books = FIRST_ORDER},
    {"pin-friction", "14", check_pin_friction},
    {"planetary-gear", "12", check_planetary_gear},
    {"projectiles", "2.5", check_projectiles},
    {"pulled-spool", "2", check_pulled_spool},
    {"quick-return", "6", check_quick_return},
    {"resonance", "10", check_resonance},
    {"rocking-block", "3", check_rocking_block},
    {"rod-tension", "3", check_rod_tension},
    {"rolling-resistance", "9", check_rolling_resistance},
    {"rolling-race", "2", check_rolling_race},
    {"rotating-spring-square", "10", check_rotating_square},
    {"scotch-yoke", "6", check_scotch_yoke},
    {"slider-crank", "2", check_slider_crank},
    {"sliding-ladder", "3", check_sliding_ladder},
    {"slipping-to-rolling", "2", check_slipping_to_rolling},
    {"spring-mass", "10", check_spring_mass},
    {"spring-mass-network", "5", check_network},
    {"spring-pendulum", "10", check_spring_pendulum},
    {"stick-slip-belt", "12", check_stick_slip_belt},
    {"stiff-chain", "10", check_stiff_chain},
    {"support-motion", "10", check_support_motion},
    {"terminal-velocity", "5", check_terminal_velocity},
    {"thrown-up", "1.2", check_thrown_up},
    {"tip-or-slide", "1.2", check_tip_or_slide},
    {"tuned-mass-damper", "10", check_tuned_mass_damper},
    {"woodpecker", "2.2", check_woodpecker},
    {"yo-yo", "1.5", check_yo_yo},
};

/* The scene as it is, with its own settings but for a shorter run, and then what is known about it. */
static void test_scene(gconstpointer data)
{
    const SceneCase *scene = data;
    g_autofree char *file = g_strconcat(scene->name, ".tinker.json", NULL);
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), file, NULL);
    cJSON *text = test_read_json(path);
    g_assert_true(cJSON_IsString(cJSON_GetObjectItemCaseSensitive(text, "title")));
    g_assert_true(cJSON_IsString(cJSON_GetObjectItemCaseSensitive(text, "description")));
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItemCaseSensitive(text, "graphs")), >, 0);
    cJSON_Delete(text);

    const char *check[] = {"check", path, NULL};
    g_autoptr(TestProgram) checked = test_program_run(check);
    g_assert_cmpint(checked->status, ==, 0);

    const char *options[] = {"--duration", scene->duration, NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    g_assert_cmpfloat(test_summary_number(run, "energy_balance_error"), <, scene->books> 0 ? scene->books : 1e-6);
    g_assert_cmpfloat(test_summary_number(run, "constraint_position_error"), <, 1e-10);
    scene->check(path);
}

/* Every scene of the folder is among the cases. */
static void test_all_are_here(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) folder = g_dir_open(g_getenv("TINKER_SCENES"), 0, &error);
    g_assert_no_error(error);
    guint scenes = 0;
    for (const char *name = g_dir_read_name(folder); name != NULL; name = g_dir_read_name(folder))
        scenes += g_str_has_suffix(name, ".tinker.json");
    g_assert_cmpuint(scenes, ==, G_N_ELEMENTS(scene_cases));
}

/* The earthquake record is the file it is said to be. */
static void test_record_is_unchanged(void)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), "el-centro-1940-ns.csv", NULL);
    g_autofree char *text = test_read_file(path);
    g_autofree char *sum = g_compute_checksum_for_string(G_CHECKSUM_SHA256, text, -1);
    g_assert_cmpstr(sum, ==, "c8db38c6a99e08c5b2446f4ce51b68d96a549ce4f6bab415aa4e5ba7c60c014d");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(scene_cases); i++) {
        g_autofree char *path = g_strconcat("/scenes/", scene_cases[i].name, NULL);
        g_test_add_data_func(path, &scene_cases[i], test_scene);
    }
    g_test_add_func("/folder/all-are-here", test_all_are_here);
    g_test_add_func("/folder/record-is-unchanged", test_record_is_unchanged);
    return g_test_run();
}
