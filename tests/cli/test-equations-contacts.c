/* Equations of bodies that touch each other and the ends of tops, against closed forms: what the terms of a body add up
 * to is its acceleration, and what is held is 0. */
#include <math.h>
#include <string.h>

#include "written.h"

#define GRAVITY 9.81

static void assert_acceleration(const cJSON *root, const char *block, const double expected[3])
{
    static const char *const parts[] = {"x", "y", "torque"};
    WrittenValues known = written_values(root);
    const cJSON *body, *term;
    cJSON_ArrayForEach(body, cJSON_GetObjectItem(root, "bodies"))
    {
        double sum[3] = {0, 0, 0};
        if (strcmp(cJSON_GetObjectItem(body, "block")->valuestring, block) != 0) continue;
        cJSON_ArrayForEach(term, cJSON_GetObjectItem(body, "terms")) for (int k = 0; k < 3; k++) sum[k] +=
            written_value(&known, cJSON_GetObjectItem(term, parts[k]));
        for (int k = 0; k < 3; k++) {
            const cJSON *by = cJSON_GetObjectItem(body, k < 2 ? "mass" : "inertia");
            written_assert_near(sum[k] / written_value(&known, by), expected[k], 1e-8);
        }
        g_hash_table_unref(known.values);
        return;
    }
    g_error("there is no body %s", block);
}

static void assert_held(const cJSON *root, int count)
{
    WrittenValues known = written_values(root);
    const cJSON *each;
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(root, "constraints"))
        written_assert_near(written_value(&known, cJSON_GetObjectItem(each, "g")), 0, 1e-12);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "constraints")), ==, count);
    g_hash_table_unref(known.values);
}

/* A block on a wedge that is free to slide, both smooth: with M and m, slope a and D = M + m sin^2 a the wedge has
 * -m g sin a cos a / D, the block M g sin a cos a / D and down (M + m) g sin^2 a / D. */
static void test_wedge(CliFixture *fixture, gconstpointer data)
{
    const double a = 0.6, wide = 3, high = wide * tan(a), wedge = 4, block = 1;
    const double from_top = 0.5, half = 0.1, s = sin(a), c = cos(a), d = wedge + block * s * s;
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -0.2], \"width\": 40, \"static_friction\": 0,"
        " \"dynamic_friction\": 0},"
        "{\"type\": \"plate\", \"name\": \"Wedge\", \"mass\": %g, \"corners\": [[0, 0], [%g, 0], [0, %.17g]],"
        " \"position\": [%.17g, %.17g], \"static_friction\": 0, \"dynamic_friction\": 0},"
        "{\"type\": \"box\", \"name\": \"Block\", \"mass\": %g, \"width\": 0.3, \"height\": %g, \"orientation\": %.17g,"
        " \"position\": [%.17g, %.17g], \"static_friction\": 0, \"dynamic_friction\": 0}]}",
        wedge, wide, high, wide / 3, high / 3, block, 2 * half, -a, from_top * c + half * s,
        high - from_top * s + half * c);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "equations @scene.json --at 0.2 --as json");
    written_assert_all(root);
    const double of_wedge[] = {-block * GRAVITY * s * c / d, 0, 0};
    const double of_block[] = {wedge * GRAVITY * s * c / d, -(wedge + block) * GRAVITY * s * s / d, 0};
    assert_acceleration(root, "Wedge", of_wedge);
    assert_acceleration(root, "Block", of_block);
    assert_held(root, 4);
    cJSON_Delete(root);
    static const char *const lines[] = {"ẍ₁ = −N_1,2,1 cos(θ₁ + β₁) − N_1,2,2 cos(θ₁ + β₁)", "a_1,2,1", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A box that is drawn away under another that slides on it: mu g above, (F - mu m g) / M below. */
static void test_sliding_boxes(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -0.2], \"width\": 60, \"static_friction\": 0,"
        " \"dynamic_friction\": 0},"
        "{\"type\": \"box\", \"name\": \"Lower\", \"mass\": 5, \"width\": 3, \"height\": 0.4, \"position\": [0, 0.2],"
        " \"static_friction\": 0.45, \"dynamic_friction\": 0.2},"
        "{\"type\": \"box\", \"name\": \"Upper\", \"mass\": 2, \"width\": 0.4, \"height\": 0.4, \"position\": [0, 0.6],"
        " \"static_friction\": 0.45, \"dynamic_friction\": 0.45},"
        "{\"type\": \"motor\", \"name\": \"Pull\", \"ends\": [\"Lower\"], \"waveform\": {\"expression\": \"40\"}}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --at 0.3 --as json");
    written_assert_all(root);
    const double of_upper[] = {0.3 * GRAVITY, 0, 0}, of_lower[] = {(40 - 0.3 * 2 * GRAVITY) / 5, 0, 0};
    assert_acceleration(root, "Upper", of_upper);
    assert_acceleration(root, "Lower", of_lower);
    cJSON_Delete(root);
    static const char *const lines[] = {"f_1,2,1 = −σ_1,2,1 √(μd₁ μd₂) N_1,2,1", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A disc that is let go on a disc that is held and rolls off it: g sin a / (1 + k) along, k = 1/2, and a third of
 * m g sin a is friction. */
static void test_rolling_off(CliFixture *fixture, gconstpointer data)
{
    const double a = 0.3, large = 1, small = 0.25, along = GRAVITY * sin(a) / 1.5;
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Base\", \"solid\": false},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Dome\", \"radius\": %g}, {\"type\": \"weld\", "
        "\"ends\": [\"Base\", "
        "\"Dome\"]},"
        "{\"type\": \"disc\", \"name\": \"Ball\", \"mass\": 2, \"radius\": %g, \"position\": [%.17g, %.17g],"
        " \"static_friction\": 0.9, \"dynamic_friction\": 0.9}]}",
        large, small, (large + small) * sin(a), (large + small) * cos(a));
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    const double of_ball[] = {along * cos(a), -along * sin(a), -along / small}, of_dome[] = {0, 0, 0};
    assert_acceleration(root, "Ball", of_ball);
    assert_acceleration(root, "Dome", of_dome);
    cJSON_Delete(root);
    root = written_json(fixture, "equations @scene.json --at 0.2 --as json");
    assert_held(root, 5);
    cJSON_Delete(root);
    static const char *const lines[] = {"sticks while", "atan2", NULL};
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A smooth disc that is drawn against the corner of a step: with p between the vertical and the way from the corner to
 * the centre the corner gives F / sin p and the floor the rest of the weight. */
static void test_step(CliFixture *fixture, gconstpointer data)
{
    const double r = 0.5, step = 0.2, p = acos((r - step) / r), force = 10, weight = 2 * GRAVITY;
    g_autofree char *text = g_strdup_printf(
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [-3, -0.2], \"width\": 6.1, \"static_friction\": 0,"
        " \"dynamic_friction\": 0},"
        "{\"type\": \"support\", \"name\": \"Step\", \"position\": [%.17g, 0.1], \"height\": 0.2, \"width\": 2,"
        " \"static_friction\": 0, \"dynamic_friction\": 0},"
        "{\"type\": \"disc\", \"name\": \"Wheel\", \"mass\": 2, \"radius\": %g, \"position\": [0, %g]},"
        "{\"type\": \"motor\", \"ends\": [\"Wheel\"], \"waveform\": {\"expression\": \"10\"}}]}",
        r * sin(p) + 1, r, r);
    g_autofree char *scene = cli_write(fixture, "scene.json", text);
    cJSON *root = written_json(fixture, "equations @scene.json --at 0.1 --as json");
    written_assert_all(root);
    const double at_rest[] = {0, 0, 0};
    assert_acceleration(root, "Wheel", at_rest);
    assert_held(root, 2);
    written_assert_near(written_symbol(root, "N_2"), force / sin(p), 1e-9);
    written_assert_near(written_symbol(root, "N_1"), weight - force / tan(p), 1e-9);
    cJSON_Delete(root);
}

/* A plank that lies over two blocks touches their four corners, which bear its weight. */
static void test_plank(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Left\", \"position\": [-1, -0.2], \"width\": 0.2},"
        "{\"type\": \"support\", \"name\": \"Right\", \"position\": [1, -0.2], \"width\": 0.2},"
        "{\"type\": \"box\", \"name\": \"Plank\", \"mass\": 3, \"width\": 4, \"height\": 0.1, \"position\": [0.2, "
        "0.05]}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    const double at_rest[] = {0, 0, 0};
    assert_acceleration(root, "Plank", at_rest);
    assert_held(root, 8);
    cJSON_Delete(root);
}

/* Three boxes that slide apart under a fourth, thrown at them: contact as impulses. In each step momentum changes by
 * what the terms add up to; turning is as the record has it, which the diagram shows. */
static void test_impulses(CliFixture *fixture, gconstpointer data)
{
    static const char *const blocks[] = {"A", "B", "C", "D"};
    static const double times[] = {0.05, 0.16, 0.3, 0.45, 0.6};
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 1, \"step\": 0.001, \"contacts\": \"impulse\"}, \"blocks\": ["
        "{\"type\": \"gravity\"},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -0.2], \"width\": 60,"
        " \"static_friction\": 0.5, \"dynamic_friction\": 0.4},"
        "{\"type\": \"box\", \"name\": \"A\", \"width\": 0.4, \"height\": 0.4, \"position\": [0, 0.2]},"
        "{\"type\": \"box\", \"name\": \"B\", \"width\": 0.4, \"height\": 0.4, \"position\": [0.41, 0.2]},"
        "{\"type\": \"box\", \"name\": \"C\", \"width\": 0.4, \"height\": 0.4, \"position\": [0.2, 0.6]},"
        "{\"type\": \"disc\", \"name\": \"D\", \"mass\": 3, \"radius\": 0.2, \"position\": [-1, 0.7],"
        " \"velocity\": [6, 0]}]}");
    for (gsize i = 0; i < G_N_ELEMENTS(times) * G_N_ELEMENTS(blocks); i++) {
        const double at = times[i / G_N_ELEMENTS(blocks)], mass = i % G_N_ELEMENTS(blocks) == 3 ? 3 : 1;
        const char *block = blocks[i % G_N_ELEMENTS(blocks)];
        g_autofree char *equations = g_strdup_printf("equations @scene.json --at %g --as json", at),
                        *books = g_strdup_printf("books @scene.json --block %s --from %.3f --to %.3f --as json", block,
                                                 at - 0.001, at),
                        *diagram = g_strdup_printf("diagram @scene.json --block %s --time %g --as json", block, at);
        cJSON *root = written_json(fixture, equations), *kept = written_json(fixture, books),
              *drawn = written_json(fixture, diagram);
        const cJSON *momentum = cJSON_GetObjectItem(cJSON_GetObjectItem(kept, "momentum"), "momentum");
        const cJSON *from = cJSON_GetArrayItem(momentum, 0), *to = cJSON_GetArrayItem(momentum, 1);
        double a[3];
        for (int k = 0; k < 2; k++)
            a[k] = (cJSON_GetArrayItem(to, k)->valuedouble - cJSON_GetArrayItem(from, k)->valuedouble) / (0.001 * mass);
        a[2] = cJSON_GetObjectItem(cJSON_GetObjectItem(drawn, "kinetic"), "torque")->valuedouble /
               cJSON_GetObjectItem(drawn, "inertia")->valuedouble;
        assert_acceleration(root, block, a);
        cJSON_Delete(root);
        cJSON_Delete(kept);
        cJSON_Delete(drawn);
    }
    static const char *const lines[] = {"(contact as impulses: its forces are the means of the last step)", NULL};
    written_assert_page(fixture, "equations @scene.json --at 0.3", lines);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-contacts/wedge", test_wedge);
    cli_test_add("/cli/equations-contacts/sliding-boxes", test_sliding_boxes);
    cli_test_add("/cli/equations-contacts/rolling-off", test_rolling_off);
    cli_test_add("/cli/equations-contacts/step", test_step);
    cli_test_add("/cli/equations-contacts/plank", test_plank);
    cli_test_add("/cli/equations-contacts/impulses", test_impulses);
    return g_test_run();
}
