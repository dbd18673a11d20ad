/* Equations and diagrams of bodies that turn and are held, against closed forms, and how they are written. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"
#include "written.h"

/* A disc of 3 N m/rad that is turned by 0.2 rad: the spring's torque stands in the diagram, and is all there is. */
static void test_torque(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Disc\", \"solid\": false, \"orientation\": 0.2},"
        "{\"type\": \"pin\", \"ends\": [\"Axle\", \"Disc\"]},"
        "{\"type\": \"torsional-spring\", \"name\": \"Coil\", \"ends\": [\"Axle\", \"Disc\"], \"stiffness\": 3, "
        "\"rest_angle\": 0}]}");
    cJSON *root = written_json(fixture, "diagram @scene.json --block Disc --time 0 --as json");
    const cJSON *each, *forces = cJSON_GetObjectItem(root, "forces");
    double torque = 0;
    cJSON_ArrayForEach(each, forces) if (strcmp(cJSON_GetObjectItem(each, "from")->valuestring, "Coil") == 0) torque +=
        cJSON_GetObjectItem(each, "torque")->valuedouble;
    written_assert_near(torque, -0.6, 1e-15);
    written_assert_near(cJSON_GetObjectItem(cJSON_GetObjectItem(root, "kinetic"), "torque")->valuedouble, -0.6, 1e-15);
    cJSON_Delete(root);
}

/* A damper from a place on a beam that swings: its end there moves by omega x r. */
static void test_turned_support(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Beam\", \"solid\": false},"
                  "{\"type\": \"support-turn\", \"ends\": [\"Beam\"], \"waveform\": \"sine\", \"amplitude\": 0.5, "
                  "\"frequency\": 3},"
                  "{\"type\": \"mass\", \"name\": \"Bob\", \"position\": [1, -2]},"
                  "{\"type\": \"damper\", \"ends\": [{\"block\": \"Beam\", \"at\": [1, 0]}, \"Bob\"]}]}");
    static const char *const lines[] = {
        "φ̇ = A ω cos(ω t)", "((x − a₁x cos(φ)) (ẋ + φ̇ a₁x sin(φ)) + (y − a₁x sin(φ)) (ẏ − φ̇ a₁x cos(φ))) / L", NULL};
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    written_assert_all(root);
    cJSON_Delete(root);
    written_assert_page(fixture, "equations @scene.json", lines);
}

/* A level beam pinned at both ends: the two pins share what pushes along it as they like, and each carries half of its
 * weight. */
static void test_redundant(CliFixture *fixture, gconstpointer data)
{
    static const char beam[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 1}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"
        "{\"type\": \"support\", \"name\": \"Left\", \"position\": [-1, 0], \"solid\": false},"
        "{\"type\": \"support\", \"name\": \"Right\", \"position\": [1, 0], \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Beam\", \"mass\": 3, \"length\": 2, \"position\": [0, 0]},"
        "{\"type\": \"pin\", \"name\": \"Pin 0\", \"ends\": [\"Left\", {\"block\": \"Beam\", \"at\": [-1, 0]}]},"
        "{\"type\": \"pin\", \"name\": \"Pin 1\", \"ends\": [\"Right\", {\"block\": \"Beam\", \"at\": [1, 0]}]}]}";
    g_autofree char *scene = cli_write(fixture, "scene.json", beam);
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const cJSON *rows = cJSON_GetObjectItem(root, "constraints"), *row;
    cJSON_ArrayForEach(row, rows)
    {
        const char *multiplier = cJSON_GetObjectItem(row, "multiplier")->valuestring;
        const gboolean along = strstr(multiplier, "λx") != NULL;
        g_assert_cmpint(cJSON_IsTrue(cJSON_GetObjectItem(row, "redundant")), ==, along);
        written_assert_near(written_symbol(root, multiplier), along ? 0 : 15, 1e-9);
    }
    g_assert_cmpint(cJSON_GetArraySize(rows), ==, 4);
    cJSON_Delete(root);
}

/* The couple that a diagram has from a block. */
static double couple_from(CliFixture *fixture, const char *command, const char *from)
{
    cJSON *root = written_json(fixture, command);
    const cJSON *force;
    double couple = NAN;
    cJSON_ArrayForEach(force, cJSON_GetObjectItem(root, "forces"))
    {
        if (strcmp(cJSON_GetObjectItem(force, "from")->valuestring, from) == 0)
            couple = cJSON_GetObjectItem(force, "torque")->valuedouble;
    }
    cJSON_Delete(root);
    return couple;
}

/* A beam of length L welded at its root, loaded by F at its tip: the root holds it with the moment F L. */
static void test_welded_beam(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Beam\", \"mass\": 2, \"length\": 3, \"position\": [1.5, 0],"
        " \"orientation\": 0},"
        "{\"type\": \"weld\", \"name\": \"Root\", \"ends\": [\"Wall\", {\"block\": \"Beam\", \"at\": [-1.5, 0]}]},"
        "{\"type\": \"law-force\", \"name\": \"Load\", \"ends\": [{\"block\": \"Beam\", \"at\": [1.5, 0]}],"
        " \"force_y\": \"-a\", \"a\": \"7 N\"}]}");
    written_assert_near(couple_from(fixture, "diagram @scene.json --block Beam --time 0.2 --as json", "Root"), 7 * 3,
                        1e-12);
}

/* A drive that holds a bar level: m g L/2 about the pin. */
static void test_holding_drive(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.5}, \"blocks\": ["
        "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10},"
        "{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Bar\", \"mass\": 2, \"length\": 3, \"position\": [1.5, 0],"
        " \"orientation\": 0},"
        "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [\"Wall\", {\"block\": \"Bar\", \"at\": [-1.5, 0]}]},"
        "{\"type\": \"drive\", \"name\": \"Drive\", \"ends\": [\"Wall\", \"Bar\"], \"speed\": 0}]}");
    written_assert_near(couple_from(fixture, "diagram @scene.json --block Bar --time 0.2 --as json", "Drive"),
                        2 * 10 * 1.5, 1e-12);
}

/* Torques are in N m, energies in J. */
static void test_units(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", \"solid\": false},"
                  "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"A\", \"solid\": false}, {\"type\": \"disc\", "
                  "\"position\": [0, 0], \"name\": \"B\", "
                  "\"solid\": false},"
                  "{\"type\": \"pin\", \"ends\": [\"Axle\", \"A\"]}, {\"type\": \"pin\", \"ends\": [\"Axle\", \"B\"]},"
                  "{\"type\": \"gear\", \"name\": \"Pair\", \"ends\": [\"A\", \"B\"]},"
                  "{\"type\": \"torsional-spring\", \"name\": \"Spring\", \"ends\": [\"Axle\", \"A\"]},"
                  "{\"type\": \"torque\", \"name\": \"Motor\", \"ends\": [\"A\", \"Axle\"], \"amplitude\": 7}]}");
    cJSON *root = written_json(fixture, "equations @scene.json --as json");
    const cJSON *each;
    int torques = 0, energies = 0;
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(root, "symbols"))
    {
        const char *unit = cJSON_GetObjectItem(each, "unit")->valuestring;
        g_assert_cmpstr(unit, !=, "J");
        torques += strcmp(unit, "N m") == 0;
    }
    cJSON_ArrayForEach(each, cJSON_GetObjectItem(root, "definitions"))
    {
        const cJSON *means = cJSON_GetObjectItem(each, "means");
        const gboolean stored = means != NULL && strcmp(means->valuestring, "stored energy") == 0;
        g_assert_true((strcmp(cJSON_GetObjectItem(each, "unit")->valuestring, "J") == 0) == stored);
        energies += stored;
    }
    g_assert_cmpint(torques, ==, 2); /* the gear's multiplier, the motor's amplitude */
    g_assert_cmpint(energies, ==, 1);
    cJSON_Delete(root);
}

/* A weld's multipliers have Greek letters in their indices, which LaTeX knows as commands alone. A real LaTeX reads the
 * page where there is one. */
static void test_latex(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "scene.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"Wall\", \"solid\": false},"
        "{\"type\": \"bar\", \"name\": \"Beam\", \"length\": 3, \"position\": [1.5, 0], \"orientation\": 0},"
        "{\"type\": \"weld\", \"name\": \"Root\", \"ends\": [\"Wall\", {\"block\": \"Beam\", \"at\": [-1.5, 0]}]}]}");
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --as latex");
    g_assert_true(g_str_is_ascii(strstr(page->output, "\\begin{document}")));
    cli_assert_holds(page->output, "{\\lambda}_{\\theta}");
    g_autofree char *program = g_find_program_in_path("pdflatex");
    if (program == NULL) return;
    g_autofree char *folder = g_path_get_dirname(scene), *source = cli_write(fixture, "page.tex", page->output);
    const char *command[] = {program, "-interaction=nonstopmode", "-halt-on-error", source, NULL};
    g_autoptr(GError) error = NULL;
    g_autofree char *said = NULL;
    int status = 0;
    g_spawn_sync(folder, (char **)command, NULL, G_SPAWN_DEFAULT, NULL, NULL, &said, NULL, &status, &error);
    g_assert_no_error(error);
    if (status != 0) g_error("LaTeX does not read the page: %s", said);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-turning/torque", test_torque);
    cli_test_add("/cli/equations-turning/redundant", test_redundant);
    cli_test_add("/cli/equations-turning/welded-beam", test_welded_beam);
    cli_test_add("/cli/equations-turning/holding-drive", test_holding_drive);
    cli_test_add("/cli/equations-turning/latex", test_latex);
    cli_test_add("/cli/equations-turning/units", test_units);
    cli_test_add("/cli/equations-turning/turned-support", test_turned_support);
    return g_test_run();
}
