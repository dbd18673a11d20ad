/* Equations and diagrams of wheels, with gears, drives, cords and ropes, and of what rolls and slides, against closed
 * forms. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"
#include "written.h"

/* Wheels of I1, I2 and I3 that a torque M sets going, the second geared to the first by i, the third inside the second
 * by k: theta_2 = -i theta_1, theta_3 = k theta_2, so that (I1 + i^2 I2 + i^2 k^2 I3) alpha_1 = M. What the first gear
 * carries is what turns the second and the third. */
static void test_gears(CliFixture *fixture, gconstpointer data)
{
    const double inertia[] = {0.5, 2, 3}, i = 0.4, k = 1.5, torque = 7;
    const double alpha = torque / (inertia[0] + i * i * inertia[1] + i * i * k * k * inertia[2]);
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"A\", \"solid\": false, \"inertia\": 0.5},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"B\", \"solid\": false, \"inertia\": 2, "
        "\"orientation\": 0.3},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"C\", \"solid\": false, \"inertia\": 3},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"A\"]}, {\"type\": \"pin\", \"ends\": [\"Axle\", \"B\"]},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"C\"]},"
        "{\"type\": \"gear\", \"name\": \"Outer\", \"ends\": [\"A\", \"B\"], \"ratio\": 0.4},"
        "{\"type\": \"gear\", \"name\": \"Inner\", \"ends\": [\"B\", \"C\"], \"ratio\": 1.5, \"internal\": true},"
        "{\"type\": \"torque\", \"name\": \"Motor\", \"ends\": [\"A\", \"Axle\"], \"amplitude\": 7}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "λ_4"), -i * alpha * (inertia[1] + k * k * inertia[2]), 1e-12);
    written_assert_near(written_symbol(root, "λ_5"), -i * k * alpha * inertia[2], 1e-12);
    cJSON_Delete(root);
    /* the wheels' bearings carry what gears do to them together: it is on no other wheel */
    root = written_json(fixture, "books @scene.json --block A --block B --block C --to 2 --as json");
    const cJSON *angular = cJSON_GetObjectItem(root, "angular");
    const double scale = cJSON_GetObjectItem(angular, "scale")->valuedouble;
    written_assert_near(cJSON_GetArrayItem(cJSON_GetObjectItem(angular, "angular_momentum"), 1)->valuedouble,
                        (inertia[0] - i * inertia[1] - i * k * inertia[2]) * alpha * 2, 1e-9 * scale);
    written_assert_near(cJSON_GetObjectItem(angular, "residual")->valuedouble, 0, 1e-9 * scale);
    g_assert_nonnull(cJSON_GetObjectItem(cJSON_GetObjectItem(angular, "impulses"), "Outer"));
    cJSON_Delete(root);
    static const char *const lines[] = {"0 = θ₂ − θ0_4,2 + i₄ (θ₁ − θ0_4,1) ", "0 = θ₃ − θ0_5,2 − i₅ (θ₂ − θ0_5,1) ",
                                        "+ M   Outer + Motor", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* Two wheels on an arm: what a gear does to one of the three has its opposite on no single one of the others. */
static void test_gear_has_no_partner(CliFixture *fixture, gconstpointer data)
{
    static const char gear[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"support\", \"name\": \"Axle\", \"position\": [0, 0], \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Arm\", \"length\": 0.5, \"position\": [0.25, 0], \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"D1\", \"radius\": 0.3, \"position\": [0, 0], \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"D2\", \"radius\": 0.2, \"position\": [0.5, 0], \"solid\": false},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", {\"block\": \"Arm\", \"at\": [-0.25, 0]}]},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"D1\"]},"
        "{\"type\": \"pin\", \"ends\": [{\"block\": \"Arm\", \"at\": [0.25, 0]}, \"D2\"]},"
        "{\"type\": \"torque\", \"name\": \"Drive\", \"ends\": [\"D1\"], \"amplitude\": 3},"
        "{\"type\": \"gear\", \"name\": \"G\", \"ends\": [\"D1\", \"D2\", \"Arm\"]}]}";
    static const char *const bodies[] = {"D1", "D2", "Arm"};
    g_autofree char *scene = cli_write(fixture, "scene.json", gear);
    for (gsize i = 0; i < G_N_ELEMENTS(bodies); i++) {
        g_autofree char *command = g_strdup_printf("diagram @scene.json --block %s --time 0.1", bodies[i]);
        g_autofree char *as_json = g_strconcat(command, " --as json", NULL);
        g_autoptr(TestProgram) page = cli_run_well(fixture, command);
        g_assert_null(strstr(page->output, "G, end"));
        g_assert_null(strstr(page->output, "on to"));
        cJSON *root = written_json(fixture, as_json);
        const cJSON *force;
        int found = 0;
        cJSON_ArrayForEach(force, cJSON_GetObjectItem(root, "forces"))
        {
            if (strcmp(cJSON_GetObjectItem(force, "from")->valuestring, "G") != 0) continue;
            g_assert_true(cJSON_IsNull(cJSON_GetObjectItem(force, "partner")));
            found++;
        }
        g_assert_cmpint(found, ==, 1);
        cJSON_Delete(root);
    }
}

/* A crank that is driven as n t + A cos(omega t): it takes I theta'' = -I A omega^2 at the start. */
static void test_drive(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Crank\", \"solid\": false, \"inertia\": 0.5},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"Crank\"]},"
        "{\"type\": \"drive\", \"name\": \"Drive\", \"ends\": [\"Crank\", \"Axle\"], \"speed\": 2, \"waveform\": "
        "\"cosine\", \"amplitude\": 0.3, \"frequency\": 5}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "λ_2"), -0.5 * 0.3 * 25, 1e-12);
    cJSON_Delete(root);
    static const char *const lines[] = {"− n t − (u − u0)   Drive", "u0 = A ", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A heavy wheel between two loads on cords, of 2 kg, 3 kg and 5 kg: a = (5 - 3) g / (3 + 5 + 2/2), with the tensions
 * 3 (g + a) and 5 (g - a), which turn the wheel by their radius. */
static void test_cords(CliFixture *fixture, gconstpointer data)
{
    const double g = 9.81, a = (5 - 3) * g / (3 + 5 + 1);
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Axle\", \"position\": [0, 5], \"solid\": false},"
        "{\"type\": \"disc\", \"name\": \"Wheel\", \"mass\": 2, \"radius\": 0.3, \"position\": [0, 5], \"solid\": "
        "false},"
        "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [\"Axle\", \"Wheel\"]},"
        "{\"type\": \"mass\", \"name\": \"Light\", \"mass\": 3, \"position\": [-0.3, 3]},"
        "{\"type\": \"mass\", \"name\": \"Heavy\", \"mass\": 5, \"position\": [0.3, 3]},"
        "{\"type\": \"cord\", \"name\": \"To light\", \"ends\": [\"Wheel\", \"Light\"], \"side\": \"right\"},"
        "{\"type\": \"cord\", \"name\": \"To heavy\", \"ends\": [\"Wheel\", \"Heavy\"], \"side\": \"left\"}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --at 0.3 --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "λ_2"), -3 * (g + a), 1e-9);
    written_assert_near(written_symbol(root, "λ_3"), -5 * (g - a), 1e-9);
    cJSON_Delete(root);
    static const char *const lines[] = {"I₁ θ̈₁ = λ₂ (1 − 2 f₂) R₂ + λ₃ R₃", "m₂ ÿ₂ = −m₂ g + λ₂ e_2,2y", "2π R₂", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A rope names its neighbours: at its first end the wheel, at the wheel both loads. Its tension is 2 m M g / (m + M).
 */
static void test_rope(CliFixture *fixture, gconstpointer data)
{
    static const char atwood[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"
        "{\"type\": \"support\", \"name\": \"Wheel\", \"position\": [0, 3], \"solid\": false},"
        "{\"type\": \"mass\", \"name\": \"Light\", \"mass\": 1, \"position\": [-0.001, 1]},"
        "{\"type\": \"mass\", \"name\": \"Heavy\", \"mass\": 3, \"position\": [0.001, 1]},"
        "{\"type\": \"rope\", \"name\": \"Rope\", \"ends\": [\"Light\", \"Wheel\", \"Heavy\"]}]}";
    g_autofree char *scene = cli_write(fixture, "scene.json", atwood);
    cJSON *root = written_json(fixture, "diagram @scene.json --block Light --time 0.1 --as json");
    const cJSON *force = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 1);
    g_assert_cmpstr(cJSON_GetObjectItem(force, "from")->valuestring, ==, "Rope");
    g_assert_cmpstr(cJSON_GetObjectItem(force, "partner")->valuestring, ==, "Wheel");
    written_assert_near(cJSON_GetArrayItem(cJSON_GetObjectItem(force, "force"), 1)->valuedouble, 15, 1e-4);
    cJSON_Delete(root);
    root = written_json(fixture, "diagram @scene.json --block Wheel --time 0.1 --as json");
    const cJSON *both = cJSON_GetObjectItem(cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 0), "partner");
    g_assert_cmpint(cJSON_GetArraySize(both), ==, 2);
    g_assert_cmpstr(cJSON_GetArrayItem(both, 0)->valuestring, ==, "Light");
    g_assert_cmpstr(cJSON_GetArrayItem(both, 1)->valuestring, ==, "Heavy");
    cJSON_Delete(root);
    root = written_json(fixture, "equations @scene.json --at 0.1 --as json");
    written_assert_near(written_symbol(root, "λ"), -15, 1e-4);
    cJSON_Delete(root);
}

/* A rope from a load to a place on a beam that hangs upside down, to another and to a second load: each part of it has
 * a name, and what is known of a beam upside down is not left as sin and cos. */
static void test_spans(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
                  "{\"type\": \"support\", \"name\": \"Beam\", \"position\": [0, 3], \"orientation\": \"180 deg\", "
                  "\"solid\": false},"
                  "{\"type\": \"mass\", \"name\": \"M1\", \"position\": [-1, 0]}, {\"type\": \"mass\", \"name\": "
                  "\"M2\", \"position\": [1, 0]},"
                  "{\"type\": \"rope\", \"name\": \"Rope\", \"ends\": [\"M1\", {\"block\": \"Beam\", \"at\": [1, 0]},"
                  "{\"block\": \"Beam\", \"at\": [-1, 0]}, \"M2\"]}]}");
    static const char *const lines[] = {"L = L₁ + L₂ + L₃ ",
                                        "L₁ = √((−a₂x − x₁)² + (Y − y₁)²) ",
                                        "Rope: span 1, from M1 to Beam\n",
                                        "Rope: span 3, from Beam to M2\n",
                                        "L₃ = 3 m\n",
                                        NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const double expected = 9.81;
    written_assert_near(written_symbol(root, "λ"), -expected, 1e-12);
    cJSON_Delete(root);
    static const char *const rows[] = {"Rope, end 2  constraint", "on to M1 and Beam\n", "Rope, end 3  constraint",
                                       "on to Beam and M2\n", NULL};
    written_assert_page(fixture, "diagram @scene.json --block Beam", rows);
}

/* A disc and a hoop that roll down a plank of slope a: with k = I / m r^2, N = m g cos a, f = m g sin a k / (1 + k) up
 * the plank, and f turns it by f r. A box that slides is pushed at two corners, with N in sum m g cos a. */
static void test_rolling(CliFixture *fixture, gconstpointer data)
{
    const double slope = 0.3, g = 9.81, c = cos(slope), s = sin(slope), mass = 2, r = 0.25;
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Plank\", \"width\": 40, \"height\": 0.4, \"orientation\": %.17g,"
        " \"static_friction\": 0.6, \"dynamic_friction\": 0.1},"
        "{\"type\": \"disc\", \"name\": \"Disc\", \"mass\": 2, \"radius\": %g, \"position\": [%.17g, %.17g]},"
        "{\"type\": \"disc\", \"name\": \"Hoop\", \"mass\": 2, \"radius\": %g, \"inertia\": 0.125, \"position\": "
        "[%.17g, "
        "%.17g]}]}",
        -slope, r, s * (0.2 + r), c * (0.2 + r), r, s * (0.2 + r) + 3 * c, c * (0.2 + r) - 3 * s);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    written_assert_near(written_symbol(root, "N_1"), mass * g * c, 1e-9);
    written_assert_near(written_symbol(root, "N_2"), mass * g * c, 1e-9);
    written_assert_near(written_symbol(root, "f_1"), -mass * g * s / 3, 1e-9);
    written_assert_near(written_symbol(root, "f_2"), -mass * g * s / 2, 1e-9);
    cJSON_Delete(root);
    static const char *const lines[] = {"I₁ θ̈₁ = f₁ R₁",
                                        "− (H / 2 + R₁) ",
                                        "+ R₁ θ₁ − s0₁ ",
                                        "I₂ θ̈₂ = f₂ R₂",
                                        "friction force, sticks while |f₁| ≤ μs N₁)",
                                        "μs = 0.6 ",
                                        NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A box that slides: pushed at its two lower corners, whose forces make up its weight, and whose moments with
 * friction's cancel, so that the front carries more, N2 - N1 = mu m g h / w. */
static void test_sliding_box(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\", \"name\": \"Gravity\"},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"width\": 40, \"height\": 0.4, \"static_friction\": 0.3, "
        "\"dynamic_friction\": 0.3},"
        "{\"type\": \"box\", \"name\": \"Box\", \"mass\": 2, \"width\": 0.8, \"height\": 0.4, \"position\": [0, 0.4], "
        "\"velocity\": [2, 0]}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    const double weight = 2 * 9.81, a = written_symbol(root, "N_1"), b = written_symbol(root, "N_2");
    written_assert_near(a + b, weight, 1e-9);
    written_assert_near(fabs(b - a), 0.3 * weight * 0.4 / 0.8, 1e-9);
    cJSON_Delete(root);
    static const char *const lines[] = {"I θ̈ = r₁x N₁ + r₁y σ₁ μd N₁ + r₂x N₂ + r₂y σ₂ μd N₂", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-wheels/gears", test_gears);
    cli_test_add("/cli/equations-wheels/gear-has-no-partner", test_gear_has_no_partner);
    cli_test_add("/cli/equations-wheels/drive", test_drive);
    cli_test_add("/cli/equations-wheels/cords", test_cords);
    cli_test_add("/cli/equations-wheels/rope", test_rope);
    cli_test_add("/cli/equations-wheels/spans", test_spans);
    cli_test_add("/cli/equations-wheels/rolling", test_rolling);
    cli_test_add("/cli/equations-wheels/sliding-box", test_sliding_box);
    return g_test_run();
}
