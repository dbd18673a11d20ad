/* Pictures: the options that say what they look like, and a scene's frame at some time. */
#ifndef TINKER_CLI_PICTURE_H
#define TINKER_CLI_PICTURE_H

#include "cli/command/run-arguments.h"
#include "common/overlay/motion-trail.h"
#include "common/overlay/motion-vectors.h"
#include "render/picture/painter.h"

typedef struct {
    char *size, *theme;
    gboolean forces;
} TinkerPictureArguments;

void tinker_picture_arguments_clear(TinkerPictureArguments *arguments);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerPictureArguments, tinker_picture_arguments_clear)

#define TINKER_PICTURE_LOOK_ENTRIES(arguments, size_)                                                                  \
    {"size", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).size, "Width and height in pixels (" size_ ")", "WxH"},         \
    {                                                                                                                  \
        "theme", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).theme,                                                      \
            "Colours: light, dark, print, contrast-light or contrast-dark (light)", "NAME"                             \
    }

#define TINKER_PICTURE_ENTRIES(arguments, size_)                                                                       \
    {"forces", 0, 0, G_OPTION_ARG_NONE, &(arguments).forces, "Draw the forces on what can move, and their key", NULL}, \
        TINKER_PICTURE_LOOK_ENTRIES(arguments, size_)

/* What is drawn over the blocks beside single forces. */
typedef struct {
    TinkerVectorChoice vectors;
    gboolean trail;
    char *marks;
} TinkerOverlayArguments;

void tinker_overlay_arguments_clear(TinkerOverlayArguments *arguments);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerOverlayArguments, tinker_overlay_arguments_clear)

#define TINKER_OVERLAY_ENTRIES(arguments)                                                                              \
    {"velocity",                                                                                                       \
     0,                                                                                                                \
     0,                                                                                                                \
     G_OPTION_ARG_NONE,                                                                                                \
     &(arguments).vectors.kinds[TINKER_VECTOR_VELOCITY],                                                               \
     "Draw the velocity of what can move",                                                                             \
     NULL},                                                                                                            \
        {"acceleration",          0,   0, G_OPTION_ARG_NONE, &(arguments).vectors.kinds[TINKER_VECTOR_ACCELERATION],   \
         "Draw its acceleration", NULL},                                                                               \
        {"net-force",                                                                                                  \
         0,                                                                                                            \
         0,                                                                                                            \
         G_OPTION_ARG_NONE,                                                                                            \
         &(arguments).vectors.kinds[TINKER_VECTOR_NET_FORCE],                                                          \
         "Draw the sum of the forces on it",                                                                           \
         NULL},                                                                                                        \
        {"trail", 0, 0, G_OPTION_ARG_NONE, &(arguments).trail, "Draw where it has been, at equal times", NULL},        \
    {                                                                                                                  \
        "marks", 0, 0, G_OPTION_ARG_FILENAME, &(arguments).marks, "Time between the marks of a trail", "S"             \
    }

/* The time between the marks of a trail up to `time` (s): as given, or a round one. 0 where there is no trail. Errors:
 * TINKER_CLI_ERROR_USAGE. */
gboolean tinker_overlay_arguments_marks(const TinkerOverlayArguments *arguments, double time, double *every,
                                        GError **error);

/* Reads size and theme; `width` and `height` keep what they hold where no size is given. Errors:
 * TINKER_CLI_ERROR_USAGE. */
gboolean tinker_picture_arguments_read(const TinkerPictureArguments *arguments, int *width, int *height,
                                       const TinkerTheme **theme, GError **error);

/* Whether a file (NULL: none) would be a picture by its ending, whether one is drawn with that or not. */
gboolean tinker_path_is_picture(const char *path);

/* Of a verb that writes texts and pictures: whether the output's ending is that of a picture. Errors,
 * TINKER_CLI_ERROR_USAGE: `as`, the text that is asked for (NULL: none is), does not go with it; or size and theme are
 * given and it is no picture. */
gboolean tinker_picture_or_text(const TinkerPictureArguments *arguments, const char *path, const char *as,
                                gboolean *is_picture, GError **error);

/* Checks that an output is given, has one of these endings (".png", ...; NULL-terminated), and can be written; answers
 * the ending's place, or -1 with `error` set. */
int tinker_picture_ending(const char *path, const char *const *endings, GError **error);

/* What a picture shows of the run beside the frame; NULL and FALSE: not wanted. */
typedef struct {
    GArray *forces;                       /* of TinkerActingForce: receives those that act at the time */
    TinkerVectorChoice choice;            /* of the vectors */
    GArray *vectors;                      /* of TinkerMotionVector: receives those of the time */
    double greatest[TINKER_VECTOR_KINDS]; /* SI: receives those of the whole run */
    TinkerMotionTrail *trail;             /* receives the poses up to the time */
} TinkerPictureCourse;

/* Brings a frame of the scene to `time` by running the scene up to it; t = 0 is the frame as it is made. Where vectors
 * are wanted, the run goes on to the scene's duration, for one scale at whatever time; that it fails on the way there
 * does not matter. */
gboolean tinker_picture_run_to(TinkerFrame *frame, const TinkerOpenScene *open, const TinkerRunArguments *arguments,
                               double time, TinkerPictureCourse *course, GError **error);

/* A table for TinkerPaintOptions.faults. (transfer full) */
GHashTable *tinker_picture_faults_new(void);
/* Warns of what is in it. */
void tinker_picture_report_faults(GHashTable *faults);

#endif
