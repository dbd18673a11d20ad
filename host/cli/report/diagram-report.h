/* A free-body diagram as JSON and as text. */
#ifndef TINKER_CLI_DIAGRAM_REPORT_H
#define TINKER_CLI_DIAGRAM_REPORT_H

#include <stdio.h>

#include "equations/balance/diagram.h"

/* (transfer full, g_free) */
char *tinker_diagram_json(const TinkerDiagram *diagram, TinkerScene *scene, const TinkerBlockId *blocks);

void tinker_diagram_write_text(const TinkerDiagram *diagram, TinkerScene *scene, const TinkerBlockId *blocks,
                               FILE *file);

#endif
