/* The command line of tinker-gui. */
#ifndef TINKER_GUI_COMMAND_LINE_H
#define TINKER_GUI_COMMAND_LINE_H

#include <gio/gio.h>

/* A picture to be taken of the window. */
typedef struct {
    char *file;  /* PNG */
    char *scene; /* NULL: the empty window */
    double time; /* s; NAN: the scene as placed */
    int width, height;
    gboolean dark, high_contrast;
    char *select; /* a block's name; may be NULL */
    char *page;   /* may be NULL */
    char *panel;  /* may be NULL */
    gboolean forces, velocity, acceleration, net_force, trail, measure;
} TinkerScreenshot;

typedef struct {
    gboolean version, new_scene;
    char **plugin_folders;        /* absolute; may be NULL */
    TinkerScreenshot *screenshot; /* may be NULL */
} TinkerCommandLine;

/* Tells the application which options there are. */
void tinker_command_line_add(GApplication *application);

/* What was given. Errors are the user's. */
gboolean tinker_command_line_read(TinkerCommandLine *line, GVariantDict *options, GError **error);
void tinker_command_line_clear(TinkerCommandLine *line);

#endif
