/* The MathML of the bundled scenes' equations as Chromium draws it: every element is known to the browser, nothing is
 * without a size, and fractions, powers, indices, dots, roots and brackets stand where a reader expects them, which a
 * script in the page measures (drawn-formulas.html). Skipped where there is no Chromium. */
#include <string.h>

#include "fixture.h"

#define VERDICT "<pre id=\"verdict\">"

/* (transfer full) */
static char *browser(void)
{
    static const char *const names[] = {"chromium", "chromium-browser", "google-chrome"};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        char *found = g_find_program_in_path(names[i]);
        if (found != NULL) return found;
    }
    return NULL;
}

/* What the script says of a page, with the entities of HTML in it. (transfer full) */
static char *verdict_on(CliFixture *fixture, const char *program, const char *page)
{
    g_autofree char *script_path = g_test_build_filename(G_TEST_DIST, "cli", "drawn-formulas.html", NULL);
    g_autofree char *script = test_read_file(script_path), *whole = g_strconcat(page, script, NULL);
    g_autofree char *path = cli_write(fixture, "page.html", whole), *uri = g_filename_to_uri(path, NULL, NULL);
    g_autofree char *profile = cli_path(fixture, "profile"), *own = g_strconcat("--user-data-dir=", profile, NULL);
    const char *const arguments[] = {program, "--headless=new",          "--no-sandbox", "--disable-gpu",
                                     own,     "--window-size=1100,1400", "--dump-dom",   uri,
                                     NULL};
    g_autofree char *output = NULL;
    g_autoptr(GError) error = NULL;
    g_spawn_sync(NULL, (char **)arguments, NULL, G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL, &output, NULL, NULL, &error);
    g_assert_no_error(error);
    const char *begin = strstr(output, VERDICT);
    const char *end = begin != NULL ? strstr(begin, "end of verdict") : NULL;
    g_assert_nonnull(end);
    begin += strlen(VERDICT);
    return g_strndup(begin, (gsize)(end - begin));
}

static void add_scene(CliFixture *fixture, GString *pages, const char *path)
{
    static const char *const forms[] = {"newton", "matrix", "angles"};
    for (gsize i = 0; i < G_N_ELEMENTS(forms); i++) {
        g_autofree char *words = g_strdup_printf("equations '%s' --form %s --as mathml", path, forms[i]);
        g_autoptr(TestProgram) program = cli_run_well(fixture, words);
        g_string_append(pages, program->output);
    }
}

/* What no bundled scene has: cases, comparisons, powers of sums, roots in fractions. */
#define LAWS                                                                                                           \
    "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [2, 1]},"                \
    "{\"type\": \"law-connector\", \"ends\": [\"Support 0\", \"Mass 0\"],"                                             \
    " \"tension\": \"if(L < 1, a*(L - 1)^3/sqrt(1 + L^2), exp(-L^2)*abs(rate))\", \"a\": \"3 N\"}]}"

static void test_scenes(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *program = browser();
    if (program == NULL) {
        g_test_skip("no Chromium is installed");
        return;
    }
    g_autoptr(GString) pages = g_string_new(NULL);
    g_autoptr(GDir) scenes = g_dir_open(g_getenv("TINKER_SCENES"), 0, NULL);
    g_assert_nonnull(scenes);
    int count = 0;
    for (const char *name; (name = g_dir_read_name(scenes)) != NULL;) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        g_autofree char *path = g_build_filename(g_getenv("TINKER_SCENES"), name, NULL);
        add_scene(fixture, pages, path);
        count++;
    }
    g_assert_cmpint(count, >=, 40);
    g_autofree char *laws = cli_write(fixture, "laws.json", LAWS);
    add_scene(fixture, pages, laws);
    g_autofree char *verdict = verdict_on(fixture, program, pages->str);
    g_test_message("%s", verdict);
    cli_assert_holds(verdict, " 0 faults.");
}

/* Each of these is wrong in one way, which the script is to say. */
static void test_faults(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *formula, *fault;
    } planted[] = {
        {"<mroot><mi>x</mi><mn>3</mn></mroot>", "mroot \"x3\" is unknown"},
        {"<mfrac><mi>x</mi></mfrac>", "mfrac \"x\" has 1 parts"},
        {"<msup><mi>x</mi><mn>2</mn><mn>3</mn></msup>", "msup \"x23\" has 3 parts"},
        {"<mi></mi>", "mi \"\" is empty"},
        {"<mi style=\"font-size: 0\">x</mi>", "mi \"x\" has no size"},
        {"<mrow style=\"display: none\"><mi>x</mi></mrow>", "mrow \"x\" has no size"},
        {"<msup style=\"display: inline\"><mi>x</mi><mn>2</mn></msup>", "msup \"x2\" has parts out of place"},
        {"<msup><mi>x</mi><mn style=\"position: relative; top: 12px\">2</mn></msup>", "has parts out of place"},
        {"<mfrac><mi style=\"position: relative; top: 30px\">x</mi><mi>y</mi></mfrac>", "has parts out of place"},
        {"<mover><mi style=\"position: relative; top: -30px\">x</mi><mo>˙</mo></mover>", "has parts out of place"},
        {"<mi>x</mi><mi style=\"position: relative; left: -20px\">y</mi>", "mi \"y\" stands on what is before it"},
        {"<mo "
         "stretchy=\"false\">[</mo><mtable><mtr><mtd><mi>x</mi></mtd></mtr><mtr><mtd><mi>y</mi></mtd></mtr></mtable>",
         "mo \"[\" has not grown"},
    };
    g_autofree char *program = browser();
    if (program == NULL) {
        g_test_skip("no Chromium is installed");
        return;
    }
    for (gsize i = 0; i < G_N_ELEMENTS(planted); i++) {
        g_autofree char *page =
            g_strdup_printf("<!DOCTYPE html>\n<math><mrow><mi>z</mi>%s</mrow></math>\n", planted[i].formula);
        g_autofree char *verdict = verdict_on(fixture, program, page);
        cli_assert_holds(verdict, planted[i].fault);
    }
}

/* Rows on one another, and what is wider than its cell. */
static void test_faults_of_rows(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *program = browser();
    if (program == NULL) {
        g_test_skip("no Chromium is installed");
        return;
    }
    g_autofree char *verdict = verdict_on(
        fixture, program,
        "<!DOCTYPE html>\n<div class=\"rows\"><table><tr><td><math><mi>x</mi></math></td></tr>"
        "<tr><td><math style=\"position: relative; top: -25px\"><mi>y</mi></math></td></tr></table></div>"
        "<div class=\"rows\"><table style=\"table-layout: fixed; width: 20px\"><tr><td><math><mtext>long words</mtext>"
        "</math></td></tr></table></div>");
    cli_assert_holds(verdict, "tr \"y\" stands on the row above it");
    cli_assert_holds(verdict, "math \"longwords\" runs out of its cell");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-drawn/scenes", test_scenes);
    cli_test_add("/cli/equations-drawn/faults", test_faults);
    cli_test_add("/cli/equations-drawn/faults-of-rows", test_faults_of_rows);
    return g_test_run();
}
