/* Sentences that the core composes, in German: those that the window shows, and none of the command line. */
#include <string.h>

#include "analysis/start/advice.h"
#include "german.h"
#include "gui-fixture.h"
#include "gui/text/sentence.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"
#include "scene/read/scene-json.h"
#include "scene/store/scene-expression.h"
#include "units/quantity/units.h"

/* k = 100 N/m and m = 1 kg swing at 10 rad/s, and rk4 is stable up to sqrt(8)/10 s = 0.283 s. */
#define OSCILLATOR                                                                                                     \
    "'blocks': [{'type': 'support'}, {'type': 'mass', 'position': [3, 0]}, {'type': 'spring', 'ends': "                \
    "['Support 0', 'Mass 0'], 'stiffness': 100, 'rest_length': 2}], 'run': {'duration': 2, 'interval': 0.5, "          \
    "'method': '%s', 'step': %s}"

static void assert_begins(const char *text, const char *beginning)
{
    if (!g_str_has_prefix(text, beginning)) g_test_message("“%s” instead of “%s”", text, beginning);
    g_assert_true(g_str_has_prefix(text, beginning));
}

static gboolean has_beginning(const GPtrArray *texts, const char *beginning)
{
    for (guint i = 0; i < texts->len; i++)
        if (g_str_has_prefix(g_ptr_array_index(texts, i), beginning)) return TRUE;
    return FALSE;
}

static gboolean warns(const GPtrArray *warnings, const char *beginning)
{
    g_autoptr(GPtrArray) texts = tinker_warnings_texts(warnings);
    return has_beginning(texts, beginning);
}

static void start_oscillator(GuiFixture *fixture, const char *method, const char *step)
{
    g_autofree char *members = g_strdup_printf(OSCILLATOR, method, step);
    gui_fixture_start_scene(fixture, members);
}

/* The blocks are found by their names, whatever the language. */
static void test_advice(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new("{'type': 'support'}, {'type': 'mass', 'position': [3, 4]}, {'type': 'rod', 'ends': "
                        "['Support 0', 'Mass 0'], 'length': 4}");
    g_autoptr(GPtrArray) all = tinker_advice_new(tinker_document_scene(fixture->document));
    g_assert_cmpuint(all->len, ==, 1);
    const TinkerAdvice *advice = g_ptr_array_index(all, 0);
    assert_begins(advice->message, "Rod 0: die Länge ist 4 m, aber die Enden liegen zu Beginn 5 m auseinander (");
    g_assert_cmpstr(advice->repair, ==, "Länge wie gezeichnet verwenden");
    g_assert_cmpint(g_array_index(advice->blocks, TinkerBlockId, 0), ==, gui_fixture_block(fixture, "Rod 0"));
}

static TinkerPlan *plan_of(GuiFixture *fixture)
{
    g_autoptr(GError) error = NULL;
    TinkerScene *scene = tinker_document_scene(fixture->document);
    const TinkerRunOptions options = tinker_run_options_of(scene);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_autoptr(GPtrArray) islands = tinker_islands_for(model, options.impulses, &error);
    g_assert_no_error(error);
    TinkerPlan *plan = tinker_plan_new(model, islands, &options, &error);
    g_assert_no_error(error);
    return plan;
}

/* With one and with many, and with parts in another order than in English. */
static void test_plan(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    start_oscillator(fixture, "auto", "0.01");
    g_autoptr(TinkerPlan) automatic = plan_of(fixture);
    g_assert_cmpstr(((TinkerIslandPlan *)g_ptr_array_index(automatic->islands, 0))->reason, ==,
                    "die Bewegung ist linear: ihre exakte Lösung stimmt bis auf die Rundung, bei jedem Schritt");
    g_assert_true(has_beginning(automatic->modelled, "1 Verbindung mit linearem Kraftgesetz, gerechnet als 1 Linie"));
    g_assert_true(has_beginning(automatic->modelled, "1 Körper als Punkte mit je zwei Koordinaten: 2 Freiheitsgrade"));
    start_oscillator(fixture, "rk4", "0.3");
    g_autoptr(TinkerPlan) unstable = plan_of(fixture);
    g_assert_true(warns(unstable->warnings,
                        "rk4 ist hier bis zu einer Schrittweite von 0.283 s stabil, die Schrittweite ist "
                        "0.3 s: der Lauf wird divergieren (Abhilfe: eine Schrittweite von "));
}

/* At 0.2 s it is stable, but takes energy away. */
static void test_run(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    start_oscillator(fixture, "rk4", "0.2");
    TinkerScene *scene = tinker_document_scene(fixture->document);
    const TinkerRunOptions options = tinker_run_options_of(scene);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    g_assert_no_error(error);
    g_assert_true(tinker_simulation_run(simulation, NULL, NULL, NULL, &error));
    g_assert_no_error(error);
    const GPtrArray *warnings = tinker_simulation_summary(simulation)->warnings;
    g_assert_true(warns(warnings, "die Energiebilanz weicht um bis zu "));
    for (guint i = 0; i < warnings->len; i++)
        g_assert_null(strstr(tinker_warnings_text(warnings, i), " step"));
}

static void assert_fault(TinkerScene *scene, const char *expression, const char *expected)
{
    g_autoptr(GError) error = NULL;
    int column;
    g_assert_null(tinker_scene_expression_new(scene, expression, &error));
    g_assert_cmpstr(tinker_without_column(error->message, &column), ==, expected);
    g_assert_cmpint(column, >, 0);
}

/* What is wrong with what is typed: the column is taken off, the rest is a sentence. */
static void test_typed(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new("{'type': 'mass', 'position': [0, 2]}");
    TinkerScene *scene = tinker_document_scene(fixture->document);
    assert_fault(scene, "{Mas 0.y}", "{Mas 0.y}: es gibt keinen Baustein „Mas 0“; ist „Mass 0“ gemeint?");
    assert_fault(scene, "{Mass 0.vz}", "{Mass 0.vz}: Mass 0 hat keine Größe oder Eigenschaft „vz“; ist „vx“ gemeint?");
    assert_fault(scene, "2 t", "vor \"t\" fehlt ein Rechenzeichen; ist ein Produkt gemeint, *?");
    assert_fault(scene, "2*", "erwartet wird eine Zahl, t, eine Funktion oder „(“, nicht das Ende");
    assert_fault(scene, "sin(t, 2)", "sin braucht 1 Argument: sin(x)");
    g_autoptr(GError) torque = NULL, length = NULL;
    double value;
    g_assert_false(tinker_quantity_parse("3 Nm", (TinkerDimension){1, 2, -2, 0}, &value, &torque));
    g_assert_cmpstr(torque->message, ==, "column 3: unbekannte Einheit „Nm“; ist „N m“ gemeint?");
    g_assert_false(tinker_quantity_parse("3 kg", (TinkerDimension){0, 1, 0, 0}, &value, &length));
    g_assert_cmpstr(length->message, ==, "column 3: erwartet war eine Länge (m), „3 kg“ ist eine Masse (kg)");
}

/* What is wrong with a file that is opened; keys and what is quoted stay as they are in the file. */
static void test_scene_file(void)
{
    static const struct {
        const char *blocks, *expected;
    } cases[] = {
        {"[{\"type\": \"mass\" \"name\": \"A\"}]", "kein JSON: erwartet wird „,“ oder „}“, hier steht „\"“"},
        {"[{\"type\": \"mass\",}]", "kein JSON: vor „}“ steht ein Komma (nehmen Sie es weg)"},
        {"[7]", "blocks[0]: ein Baustein ist ein Objekt, {\"type\": ...}"},
        {"[{\"type\": \"mass\", \"name\": \"A\", \"mass\": true}]",
         "A: mass: erwartet wird eine Zahl oder ein Text mit einer Einheit, gegeben ist true"},
        {"[{\"type\": \"mass\", \"name\": \"A\", \"position\": [1]}]",
         "A: position: ein Vektor hat 2 Zahlen, [x, y], gegeben sind 1"},
        {"[{\"type\": \"mass\", \"name\": \"A\", \"mass\": \"3 m\"}]",
         "A: mass: erwartet war eine Masse (kg), „3 m“ ist eine Länge (m)"},
        {"[{\"type\": \"spring\", \"name\": \"K\", \"ends\": [[0, 0]]}]",
         "K: ends: „spring“ hat 2 Enden, gegeben sind 1"},
        {"[{\"type\": \"mass\", \"name\": \"Bob\"}, {\"type\": \"spring\", \"name\": \"K\", \"ends\": [\"Bib\", [0, "
         "0]]}]",
         "K: Ende 1: es gibt keinen Baustein „Bib“ (ist „Bob“ gemeint?)"},
    };
    g_autoptr(GuiFixture) fixture = gui_fixture_new("");
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"blocks\": %s}", cases[i].blocks);
        TinkerScene *scene = tinker_scene_read_text(tinker_document_catalogue(fixture->document), text, strlen(text),
                                                    "scene", NULL, &error);
        g_assert_null(scene);
        g_assert_nonnull(error);
        if (!g_str_has_suffix(error->message, cases[i].expected))
            g_test_message("“%s” instead of “%s”", error->message, cases[i].expected);
        g_assert_true(g_str_has_suffix(error->message, cases[i].expected));
    }
}

static char *output_of_plan(const char *path, const char *locale)
{
    const char *plan[] = {g_getenv("TINKER_PROGRAM"), "plan", path, "--method", "rk4", "--step", "0.3", NULL};
    char *output = NULL;
    g_setenv("LC_ALL", locale, TRUE);
    g_setenv("LANGUAGE", "de", TRUE);
    german_run_tool(plan, &output);
    g_unsetenv("LANGUAGE");
    g_setenv("LC_ALL", GERMAN_LOCALE, TRUE);
    return output;
}

/* What it writes is read by programs. */
static void test_command_line_stays_english(void)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), "spring-mass.tinker.json", NULL);
    g_autofree char *german = output_of_plan(path, GERMAN_LOCALE), *plain = output_of_plan(path, "C");
    g_assert_nonnull(strstr(german, "as points with two coordinates each: 2 degrees of freedom"));
    g_assert_cmpstr(german, ==, plain);
}

static void add_tests(void)
{
    g_test_add_func("/gui/translated-sentences/advice", test_advice);
    g_test_add_func("/gui/translated-sentences/plan", test_plan);
    g_test_add_func("/gui/translated-sentences/run", test_run);
    g_test_add_func("/gui/translated-sentences/typed", test_typed);
    g_test_add_func("/gui/translated-sentences/scene-file", test_scene_file);
    g_test_add_func("/gui/translated-sentences/command-line", test_command_line_stays_english);
}

int main(int argc, char **argv)
{
    german_begin();
    const int status = scene_fixture_main(argc, argv, add_tests);
    german_end();
    return status;
}
