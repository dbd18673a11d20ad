/* Nothing that a scene or an argument says reaches a terminal raw, and a message is one line, whatever names are in it.
 */
#include <string.h>

#include "fixture.h"

/* In every text that a scene can have: ESC [ 31 m, which turns a terminal red, BEL, the CSI of ISO 8859-1, and a line
 * feed. */
#define BAD "\\u001b[31m\\u0007\\u009b\\n"

/* No control character but the line feeds and tabs that the program writes itself. */
static void assert_plain(const char *words, const char *text)
{
    for (const char *c = text; *c != '\0'; c++) {
        const gboolean control = g_ascii_iscntrl(*c) && *c != '\n' && *c != '\t';
        const gboolean of_latin = (guchar)c[0] == 0xc2 && (guchar)c[1] >= 0x80 && (guchar)c[1] < 0xa0;
        if (control || of_latin) g_error("%s: byte 0x%02x is printed", words, (guchar)*c);
    }
}

static void assert_lines_of_program(const char *words, const char *text)
{
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    for (char **line = lines; *line != NULL; line++)
        if (**line != '\0' && !g_str_has_prefix(*line, "tinker: "))
            g_error("%s: \"%s\" is half a message", words, *line);
}

/* Each of these is a mistake, or a warning. */
static void test_findings(CliFixture *fixture, gconstpointer data)
{
    static const char *const scenes[] = {
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"M" BAD "\"}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"x" BAD "\"}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"k" BAD "\": 1}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": \"3 k" BAD "\"}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"on\": \"M" BAD "\"}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"spring\", \"ends\": [\"A" BAD "\", \"B\"]}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"motor\", \"ends\": [\"Mass 0\"], "
        "\"waveform\": "
        "{\"expression\": \"sin" BAD "(t)\"}}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"motor\", \"ends\": [\"Mass 0\"], "
        "\"waveform\": "
        "{\"table\": \"a" BAD ".csv\"}}]}",
        "{\"tinker\": 1, \"run\": {\"method\": \"rk" BAD "\"}, \"blocks\": [{\"type\": \"mass\"}]}",
        "{\"tinker\": 1, \"run\": {\"contacts\": \"x" BAD "\"}, \"blocks\": [{\"type\": \"mass\"}]}",
        "{\"tinker\": 1, \"units\": \"S" BAD "\", \"blocks\": [{\"type\": \"mass\"}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}], \"graphs\": [{\"block\": \"A" BAD
        "\", \"quantity\": \"y\"}]}",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}], \"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"y" BAD
        "\"}]}",
        "{\"tinker\": 1, \"a" BAD "\": 1, \"a" BAD "\": 2, \"blocks\": []}",
        "{\"tinker\": 1, \x1b}",
    };
    static const char *const verbs[] = {"check", "run", "plan"};
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        g_autofree char *scene = cli_write(fixture, "a.json", scenes[i]);
        for (gsize v = 0; v < G_N_ELEMENTS(verbs); v++) {
            g_autofree char *words = g_strdup_printf("%s @a.json", verbs[v]);
            g_autoptr(TestProgram) program = cli_run(fixture, words);
            assert_plain(scenes[i], program->output);
            assert_plain(scenes[i], program->error);
            if (v == 0) assert_lines_of_program(scenes[i], program->error);
            if (v == 0) g_assert_cmpstr(program->error, !=, "");
        }
    }
}

/* The title of a scene that is good, in everything that goes to standard output. */
static void test_title(CliFixture *fixture, gconstpointer data)
{
    static const char *const words[] = {
        "run @a.json",
        "run @a.json --json -",
        "run @a.json --csv -",
        "plan @a.json",
        "plan @a.json --json -",
        "modes @a.json",
        "check @a.json",
        "convert @a.json -o -",
        "graph @a.json 'Mass 0.y' -o @a.csv",
        "bench @a.json --seconds 0.01",
    };
    g_autofree char *scene = cli_write(fixture, "a.json",
                                       "{\"tinker\": 1, \"title\": \"T" BAD "\", \"description\": \"D" BAD "\", \"k" BAD
                                       "\": \"v" BAD "\xc2\x9b\", \"blocks\": [{\"type\": \"gravity\"}, "
                                       "{\"type\": \"mass\"}]}");
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autoptr(TestProgram) program = cli_run_well(fixture, words[i]);
        assert_plain(words[i], program->output);
        assert_plain(words[i], program->error);
    }
    g_autoptr(TestProgram) run = cli_run_well(fixture, "run @a.json");
    g_assert_true(g_str_has_prefix(run->output, "T\\u001b[31m\\u0007\\u009b\\n\n  method"));
}

static void test_arguments(CliFixture *fixture, gconstpointer data)
{
    static const char *const words[] = {
        "'x\x1b[31m\ny'",
        "run '@no\x1b[31m\nfile.json'",
        "run @a.json --columns 'Mass 0.x\x1b\n'",
        "run @a.json --method 'x\x1b\n'",
        "run @a.json --csv '@no\x1b\n/folder.csv'",
        "run @a.json '--x\x1b\ny'",
        "graph @a.json 'A\x1b\n.y' -o @a.png",
        "plugins show 'x\x1b\n'",
    };
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autoptr(TestProgram) program = cli_run(fixture, words[i]);
        assert_plain(words[i], program->output);
        assert_plain(words[i], program->error);
        assert_lines_of_program(words[i], program->error);
        g_assert_cmpstr(program->error, !=, "");
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/terminal/findings", test_findings);
    cli_test_add("/terminal/title", test_title);
    cli_test_add("/terminal/arguments", test_arguments);
    return g_test_run();
}
