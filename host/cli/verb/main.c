/* tinker, the program without a window: finds the verb and hands over. No call of setlocale: numbers are read and
 * written in the C locale everywhere. */
#include <glib.h>
#include <stdio.h>
#include <string.h>

#include "cli/command/options.h"
#include "cli/verb/verbs.h"
#include "common/program/exit-status.h"
#include "common/program/program-start.h"

typedef struct {
    const char *name;
    const char *summary;
    int (*run)(int argc, char **argv);
} TinkerVerb;

static const TinkerVerb verbs[] = {
    {"run", "run a scene; write its record as CSV and a summary", tinker_verb_run},
    {"graph", "draw quantities over time, or write them as CSV", tinker_verb_graph},
    {"render", "draw the scene as a picture", tinker_verb_render},
    {"animate", "draw the motion as a film", tinker_verb_animate},
    {"check", "list every mistake in a scene", tinker_verb_check},
    {"convert", "write a scene back in its normal form, in either system of units", tinker_verb_convert},
    {"plan", "tell what is modelled, how it would be stepped and why, and what it would cost", tinker_verb_plan},
    {"equations", "write the equations of motion that a scene stands for", tinker_verb_equations},
    {"diagram", "list the forces on a body, and what they add up to", tinker_verb_diagram},
    {"books", "keep the books of bodies: Newton, work and energy, impulse and momentum", tinker_verb_books},
    {"plugins", "list, show, check and describe blocks and methods", tinker_verb_plugins},
    {"trade", "measure speed against accuracy; advise a method and its step", tinker_verb_trade},
    {"modes", "natural frequencies, damping ratios, mode shapes, frequency response", tinker_verb_modes},
    {"bench", "time the steps of a scene by method", tinker_verb_bench},
    {"demo", "run the bundled spring-mass scene and write its record, graph and picture", tinker_verb_demo},
};

static void print_usage(FILE *file)
{
    fputs("Usage: tinker VERB [OPTION...] [OPERAND...]\n\n"
          "Runs scenes of masses, springs, dampers, rods and supports, and writes what they do.\n\n",
          file);
    for (gsize i = 0; i < G_N_ELEMENTS(verbs); i++)
        fprintf(file, "  %-9s %s\n", verbs[i].name, verbs[i].summary);
    fputs(
        "\nA scene of - is standard input, an output of - is standard output.\n"
        "`tinker VERB --help` lists the options of a verb and shows examples; `tinker --version` tells the version.\n\n"
        "Exit status: 0 done, 1 the run failed, 2 usage, 3 the scene is wrong, 4 a plugin is missing or refused,\n"
        "5 a file could not be read or written, or there was not enough memory.\n",
        file);
}

static const TinkerVerb *find_verb(const char *name)
{
    for (gsize i = 0; i < G_N_ELEMENTS(verbs); i++)
        if (strcmp(verbs[i].name, name) == 0) return &verbs[i];
    return NULL;
}

static int report_unknown_verb(const char *name)
{
    const char *names[G_N_ELEMENTS(verbs) + 1] = {NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(verbs); i++)
        names[i] = verbs[i].name;
    g_autofree char *hint = tinker_did_you_mean(name, names);
    tinker_report_note("unknown %s \"%s\"%s", name[0] == '-' ? "option" : "verb", name,
                       hint[0] != '\0' ? hint : " (see tinker --help)");
    return TINKER_EXIT_USAGE;
}

/* `tinker help VERB` is `tinker VERB --help`. */
static int help_of(const char *name)
{
    const TinkerVerb *verb = find_verb(name);
    if (verb == NULL) return report_unknown_verb(name);
    char *words[] = {(char *)verb->name, (char *)"--help", NULL};
    return verb->run(2, words);
}

/* What was told on standard output may not have reached it: a full disk, a closed pipe. */
static int finish(int status)
{
    if (fflush(stdout) == 0 && !ferror(stdout)) return status;
    if (status != TINKER_EXIT_DONE) return status;
    tinker_report_note("standard output: cannot be written");
    return TINKER_EXIT_FILE;
}

static int dispatch(int argc, char **argv)
{
    if (argc < 2) {
        print_usage(stderr);
        return TINKER_EXIT_USAGE;
    }
    const char *name = argv[1];
    if (strcmp(name, "help") == 0 && argc > 2) return help_of(argv[2]);
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        print_usage(stdout);
        return TINKER_EXIT_DONE;
    }
    if (strcmp(name, "--version") == 0) {
        printf("tinker %s\n", TINKER_VERSION);
        return TINKER_EXIT_DONE;
    }
    const TinkerVerb *verb = find_verb(name);
    return verb == NULL ? report_unknown_verb(name) : verb->run(argc - 1, argv + 1);
}

int main(int argc, char **argv)
{
    tinker_program_start("tinker");
    return finish(dispatch(argc, argv));
}
