/* A folder of its own for a test, with small scenes in it, and the program run there. */
#ifndef TEST_CLI_FIXTURE_H
#define TEST_CLI_FIXTURE_H

#include "program.h"

/* A mass of 1 kg let go at the origin under 9.81 m/s^2: y = -9.81 t^2 / 2, which a method of order 2 or more steps
 * exactly. */
#define FREE_FALL                                                                                                      \
    "{\"tinker\": 1, \"title\": \"Fall\", \"run\": {\"duration\": 1, \"interval\": 0.01, \"method\": \"rk4\", "        \
    "\"step\": 0.01},\n \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"mass\"}],\n"                                \
    " \"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"y\"}]}\n"

/* A mass of 1 kg on a spring of 100 N/m from a support: angular frequency 10 rad/s. */
#define OSCILLATOR                                                                                                     \
    "{\"tinker\": 1, \"run\": {\"duration\": 2, \"interval\": 0.5, \"method\": \"rk4\", \"step\": 0.001},\n"           \
    " \"blocks\": [{\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [3, 0]},\n"                             \
    "  {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100, \"rest_length\": 2}]}\n"

typedef struct {
    char *folder;
} CliFixture;

void cli_fixture_set_up(CliFixture *fixture, gconstpointer data);
void cli_fixture_tear_down(CliFixture *fixture, gconstpointer data);

/* Path of a file in the folder. (transfer full) */
char *cli_path(const CliFixture *fixture, const char *name);

/* Writes a file there; answers its path. (transfer full) */
char *cli_write(const CliFixture *fixture, const char *name, const char *text);

/* Text of a file there. (transfer full) */
char *cli_read(const CliFixture *fixture, const char *name);

/* Runs `tinker` with these words, split as a shell does it; "@" at the start of a word stands for the folder and a
 * slash. (transfer full) */
TestProgram *cli_run(const CliFixture *fixture, const char *words);
/* Runs `tinker` as cli_run() does; fails the test unless it exits with 0, or with `status`. (transfer full) */
TestProgram *cli_run_well(const CliFixture *fixture, const char *words);
TestProgram *cli_run_badly(const CliFixture *fixture, const char *words, int status);

/* Starts the program, its outputs thrown away. */
GPid cli_start(const CliFixture *fixture, const char *words);
/* Sends it a Ctrl-C and waits; answers its exit status, -1 where it did not end of itself. */
int cli_interrupt(GPid process);

/* Fails the test where `text` does not hold `part`. */
void cli_assert_holds(const char *text, const char *part);

/* A file there begins with these bytes, and has more. */
void cli_assert_begins(const CliFixture *fixture, const char *name, const char *magic);
#define CLI_PNG_BEGINS "\x89PNG\r\n\x1a\n"

/* A file there is a picture of this size in pixels. */
void cli_assert_png_size(const CliFixture *fixture, const char *name, guint width, guint height);

void cli_test_add(const char *path, void (*test)(CliFixture *fixture, gconstpointer data));

#endif
