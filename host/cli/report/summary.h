/* The summary of a run, for programs (JSON) and for people (text). */
#ifndef TINKER_CLI_SUMMARY_H
#define TINKER_CLI_SUMMARY_H

#include <stdio.h>

#include "physics/system/summary.h"

/* What a summary is written from; everything is borrowed. */
typedef struct {
    TinkerScene *scene;
    const char *scene_name; /* of the file */
    const TinkerSummary *run;
    const GPtrArray *libraries; /* of char *: paths of the plugin files opened */
    const GPtrArray *warnings;  /* of char * */
    gboolean has_until;         /* the run was to end at a condition: */
    const char *stopped_by;     /* the one that held; NULL: none did */
} TinkerRunReport;

/* JSON with the keys of docs/reference/cli.md. A number that is not finite is null. */
void tinker_summary_write_json(const TinkerRunReport *report, FILE *file);

/* A short account for people. */
void tinker_summary_write_text(const TinkerRunReport *report, FILE *file);

#endif
