/* Pictures: the options that say what they look like, and a scene's frame at some time. */
#ifndef TINKER_CLI_PICTURE_H
#define TINKER_CLI_PICTURE_H

#include "cli/command/run-arguments.h"
#include "render/picture/painter.h"

typedef struct {
    char *size, *theme;
    gboolean forces;
} TinkerPictureArguments;

void tinker_picture_arguments_clear(TinkerPictureArguments *arguments);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerPictureArguments, tinker_picture_arguments_clear)

#define TINKER_PICTURE_ENTRIES(arguments, size_)                                                                       \
    {"forces", 0, 0, G_OPTION_ARG_NONE, &(arguments).forces, "Draw the forces on what can move, and their key", NULL}, \
        {"size", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).size, "Width and height in pixels (" size_ ")", "WxH"},     \
    {                                                                                                                  \
        "theme", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).theme,                                                      \
            "Colours: light, dark, print, contrast-light or contrast-dark (light)", "NAME"                             \
    }

/* Reads size and theme; `width` and `height` keep what they hold where no size is given. Errors:
 * TINKER_CLI_ERROR_USAGE. */
gboolean tinker_picture_arguments_read(const TinkerPictureArguments *arguments, int *width, int *height,
                                       const TinkerTheme **theme, GError **error);

/* Checks that an output is given, has one of these endings (".png", ...; NULL-terminated), and can be written; answers
 * the ending's place, or -1 with `error` set. */
int tinker_picture_ending(const char *path, const char *const *endings, GError **error);

/* Brings a frame of the scene to `time` by running the scene up to it; t = 0 is the frame as it is made. `forces`
 * (tinker_acting_forces_array; NULL: not wanted) receives those that act then. */
gboolean tinker_picture_run_to(TinkerFrame *frame, const TinkerOpenScene *open, const TinkerRunArguments *arguments,
                               double time, GArray *forces, GError **error);

/* A table for TinkerPaintOptions.faults. (transfer full) */
GHashTable *tinker_picture_faults_new(void);
/* Warns of what is in it. */
void tinker_picture_report_faults(GHashTable *faults);

#endif
