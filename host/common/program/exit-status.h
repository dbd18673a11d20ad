/* What the program tells its caller: the exit status, and one line on standard error for everything that went wrong. */
#ifndef TINKER_HOST_EXIT_STATUS_H
#define TINKER_HOST_EXIT_STATUS_H

#include <glib.h>

enum {
    TINKER_EXIT_DONE = 0,
    TINKER_EXIT_RUN_FAILED = 1, /* what was computed up to then is written */
    TINKER_EXIT_USAGE = 2,
    TINKER_EXIT_SCENE = 3,  /* the scene is wrong */
    TINKER_EXIT_PLUGIN = 4, /* missing or refused */
    TINKER_EXIT_FILE = 5,   /* could not be read or written; or memory could not be had */
};

typedef enum {
    TINKER_CLI_ERROR_USAGE,   /* an option or operand that cannot be */
    TINKER_CLI_ERROR_FILE,    /* an output that cannot be written */
    TINKER_CLI_ERROR_STOPPED, /* the caller stopped it */
} TinkerCliError;
#define TINKER_CLI_ERROR (tinker_cli_error_quark())
GQuark tinker_cli_error_quark(void);

/* The exit status that an error of the core, of GLib or of the program stands for. */
int tinker_exit_status(const GError *error);

/* Turns an error, if there is one, into TINKER_CLI_ERROR_USAGE (but for a missing plugin): what was asked for on the
 * command line is the user's fault, whatever part of the core found it. "--OPTION: " is put before the message;
 * `option` may be NULL. */
void tinker_blame_option(const char *option, GError **error);

/* What the lines on standard error begin with: "tinker" at first. Static. */
void tinker_report_as(const char *program);

/* Writes "tinker: MESSAGE" to standard error, with "SCENE: " before the message where `scene` is given, the message
 * does not begin with it and it is not about the command line. Answers the exit status. */
int tinker_report_error(const char *scene, const GError *error);

/* Writes "tinker: warning: TEXT" to standard error. */
void tinker_report_warning(const char *format, ...) G_GNUC_PRINTF(1, 2);

/* Writes "tinker: TEXT" to standard error: something the user should know that is no mistake. */
void tinker_report_note(const char *format, ...) G_GNUC_PRINTF(1, 2);

#endif
