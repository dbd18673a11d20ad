/* What `tinker modes` says: tables for people, JSON for programs, pictures. */
#ifndef TINKER_CLI_MODE_REPORT_H
#define TINKER_CLI_MODE_REPORT_H

#include <stdio.h>

#include "cli/report/mode-response.h"
#include "common/program/file-set.h"
#include "render/picture/painter.h"

typedef struct {
    TinkerScene *scene;
    const TinkerModeAnalysis *analysis;
    guint count;                        /* modes that are told of */
    const TinkerModeResponse *response; /* NULL: none was asked for */
    const GPtrArray *warnings;          /* of char * */
} TinkerModeReport;

void tinker_mode_report_write_text(const TinkerModeReport *report, FILE *file);
void tinker_mode_report_write_json(const TinkerModeReport *report, FILE *file);

/* Adds the `count` pictures of an output to the command's files; see tinker_file_set_add_output. */
gboolean tinker_mode_pictures_add(TinkerFileSet *files, const char *path, guint count, GError **error);

/* One picture a mode: "out.png" becomes "out-1.png", "out-2.png", ... */
gboolean tinker_mode_report_draw(const TinkerModeReport *report, const TinkerTheme *theme, int width, int height,
                                 const char *path, GError **error);

#endif
