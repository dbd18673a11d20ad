/* The plan of a scene, for programs (JSON) and for people (text). */
#ifndef TINKER_CLI_PLAN_REPORT_H
#define TINKER_CLI_PLAN_REPORT_H

#include <stdio.h>

#include "physics/model/model.h"
#include "physics/plan/plan.h"

/* What a report is written from; everything is borrowed. */
typedef struct {
    TinkerScene *scene;
    const char *scene_name; /* of the file */
    TinkerModelSizes sizes;
    const TinkerPlan *plan;
    const GPtrArray *libraries; /* of char *: paths of the plugin files opened */
    const GPtrArray *warnings;  /* of char * */
} TinkerPlanReport;

/* JSON with the keys of docs/reference/cli.md. A number that is not finite is null. */
void tinker_plan_write_json(const TinkerPlanReport *report, FILE *file);

/* A short account for people. */
void tinker_plan_write_text(const TinkerPlanReport *report, FILE *file);

#endif
