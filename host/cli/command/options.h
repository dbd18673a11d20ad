/* Command lines: what all verbs share. A verb declares its options as GOptionEntry rows and its help as a
 * TinkerVerbHelp; texts are taken as G_OPTION_ARG_FILENAME, the one kind that GLib hands through byte by byte whatever
 * the locale. */
#ifndef TINKER_CLI_OPTIONS_H
#define TINKER_CLI_OPTIONS_H

#include <glib.h>

#include <tinker/types.h>

typedef struct {
    const char *verb;     /* "run", "plugins show" */
    const char *operands; /* "SCENE", as shown behind the verb */
    const char *summary;  /* sentences above the list of options */
    const char *examples; /* below it; one a line */
    int least_operands;
    int most_operands; /* -1: any number */
} TinkerVerbHelp;

/* What every verb takes, and its operands. */
typedef struct {
    char **plugin_folders; /* of --plugins; NULL: none */
    char **operands;       /* NULL-terminated, never NULL */
    int operand_count;
} TinkerCommandLine;

void tinker_command_line_clear(TinkerCommandLine *line);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerCommandLine, tinker_command_line_clear)

/* Reads a verb's command line; argv[0] is the verb. TRUE: go on; `status` is 0. FALSE: the help was asked for and
 * printed, or an error was reported; `status` is then the exit status. */
gboolean tinker_command_line_read(TinkerCommandLine *line, const TinkerVerbHelp *help, const GOptionEntry *entries,
                                  int argc, char **argv, int *status);

/* Reads the value of an option, "10 ms" or a plain number in SI. TINKER_CLI_ERROR_USAGE where it is not one of this
 * dimension, or is below `least` (or equal to it, with `open`). */
gboolean tinker_option_value(const char *option, const char *text, TinkerDimension dimension, double least,
                             gboolean open, double *si, GError **error);

/* Reads a whole number from `least` to `greatest`. */
gboolean tinker_option_integer(const char *option, const char *text, int least, int greatest, int *value,
                               GError **error);

/* Reads one of some words, and answers its place. */
gboolean tinker_option_choice(const char *option, const char *text, const char *const *words, int *place,
                              GError **error);

/* ` (did you mean "WORD"?)` where a candidate is near, else "". (transfer full) */
char *tinker_did_you_mean(const char *word, const char *const *candidates);

#endif
