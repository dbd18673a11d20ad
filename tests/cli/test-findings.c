/* tinker check and what other verbs tell of a scene with mistakes: where, and how many. */
#include <string.h>

#include "fixture.h"

/* Every "FILE:LINE:" of the text, in order, is at a line no less than the one before. */
static void assert_lines_ascend(const char *text, int count)
{
    g_autoptr(GRegex) place = g_regex_new("json:(\\d+):\\d+: ", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    int last = 0, found = 0;
    for (g_regex_match(place, text, 0, &match); g_match_info_matches(match); g_match_info_next(match, NULL), found++) {
        g_autofree char *line = g_match_info_fetch(match, 1);
        g_assert_cmpint(atoi(line), >=, last);
        last = atoi(line);
    }
    g_assert_cmpint(found, ==, count);
}

static void test_check(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *bad = cli_write(fixture, "bad.json",
                                     "{\"tinker\": 1,\n"
                                     " \"run\": {\"duration\": -3},\n"
                                     " \"blocks\": [\n"
                                     "  {\"type\": \"mass\", \"mass\": \"3 ft\"},\n"
                                     "  {\"type\": \"spring\", \"ends\": [\"Mass 0\", \"Mass 7\"]},\n"
                                     "  {\"type\": \"mass\", \"name\": \"Mass 0\", \"widht\": 1}\n"
                                     " ]}\n");
    g_autoptr(TestProgram) program = cli_run_badly(fixture, "check @bad.json", 3);
    g_assert_cmpstr(program->output, ==, "");
    assert_lines_ascend(program->error, 4);
    cli_assert_holds(program->error, "json:2:");
    cli_assert_holds(program->error, "a mass (kg) was expected");
    cli_assert_holds(program->error, "\"Mass 7\"");
    cli_assert_holds(program->error, "did you mean \"width\"");
    cli_assert_holds(program->error, ": warning: ");

    g_autofree char *good = cli_write(fixture, "good.json", OSCILLATOR);
    g_autoptr(TestProgram) clean = cli_run_well(fixture, "check @good.json");
    g_assert_cmpstr(clean->output, ==, "no mistakes found\n");
    g_assert_cmpstr(clean->error, ==, "");
}

static void test_check_of_model(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *loose = cli_write(fixture, "loose.json",
                                       "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"},"
                                       "{\"type\": \"spring\", \"ends\": [[0, 1], [1, 2]]},"
                                       "{\"type\": \"rod\", \"ends\": [\"Mass 0\", [1, 2]]}]}");
    g_autoptr(TestProgram) detached = cli_run_badly(fixture, "check @loose.json", 3);
    cli_assert_holds(detached->error, "Spring 0: end 1 of 2 is detached");
    cli_assert_holds(detached->error, "Spring 0: end 2 of 2 is detached");
    cli_assert_holds(detached->error, "Rod 0: end 2 of 2 is detached");

    g_autofree char *long_rod =
        cli_write(fixture, "rod.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"support\","
                  "\"position\": [1, 0]}, {\"type\": \"rod\", \"ends\": [\"Mass 0\", \"Support 0\"],"
                  "\"length\": 2}]}");
    g_autoptr(TestProgram) misfit = cli_run_badly(fixture, "check @rod.json", 3);
    cli_assert_holds(misfit->error, "Rod 0");

    g_autofree char *pulley = cli_write(fixture, "pulley.json",
                                        "{\"tinker\": 1, \"blocks\": [{\"type\": \"pulley\"}, {\"type\": \"sprng\"}]}");
    g_autoptr(TestProgram) missing = cli_run_badly(fixture, "check @pulley.json", 4);
    cli_assert_holds(missing->error, "\"pulley\"");
    cli_assert_holds(missing->error, "did you mean \"spring\"");

    g_autofree char *method = cli_write(fixture, "method.json",
                                        "{\"tinker\": 1, \"run\": {\"method\": \"rk5\"},"
                                        "\"blocks\": [{\"type\": \"mass\"}]}");
    g_autoptr(TestProgram) unknown = cli_run_badly(fixture, "check @method.json", 3);
    cli_assert_holds(unknown->error, "did you mean \"rk4\"");
}

/* A verb that cannot go on tells where the rest is. */
static void test_further_findings(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *bad = cli_write(fixture, "bad.json",
                                     "{\"tinker\": 1, \"Blocks\": [], \"blocks\": ["
                                     "{\"type\": \"mass\", \"mass\": -1}]}");
    g_autoptr(TestProgram) unread = cli_run_badly(fixture, "run @bad.json", 3);
    cli_assert_holds(unread->error, "bad.json\" lists all 2 findings\n");

    g_autofree char *lone =
        cli_write(fixture, "lone.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": -1}]}");
    g_autoptr(TestProgram) one = cli_run_badly(fixture, "run @lone.json", 3);
    g_assert_null(strstr(one->error, "findings"));

    g_autofree char *loose = cli_write(fixture, "loose.json",
                                       "{\"tinker\": 1, \"Blocks\": [], \"blocks\": ["
                                       "{\"type\": \"spring\", \"ends\": [[0, 1], [1, 2]]}]}");
    g_autoptr(TestProgram) refused = cli_run_badly(fixture, "graph @loose.json 'Spring 0.tension' -o -", 3);
    cli_assert_holds(refused->error, "unknown key \"Blocks\"");
    cli_assert_holds(refused->error, "loose.json\" lists all 3 findings\n");
    g_autoptr(TestProgram) check = cli_run_badly(fixture, "check @loose.json", 3);
    g_auto(GStrv) lines = g_strsplit(check->error, "\n", -1);
    g_assert_cmpuint(g_strv_length(lines), ==, 3 + 1);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/verbs/check", test_check);
    cli_test_add("/verbs/check-of-model", test_check_of_model);
    cli_test_add("/verbs/further-findings", test_further_findings);
    return g_test_run();
}
