/* Many merged lines, cut into parts that threads share.
 *
 * A part has a run of points for its own, and the lines that begin at them. It adds up forces on its own points in
 * place; forces on points of other parts go to slots of its own, which are added to those points afterwards, part by
 * part in order. The cut depends on the lines alone, so every sum has the same order and the same bits however many
 * threads there are. */
#ifndef TINKER_CORE_LINE_PARTS_H
#define TINKER_CORE_LINE_PARTS_H

#include "physics/model/model-data.h"

/* The parts of a model's lines, which are sorted by their first ends; makes room for the slots in model->force. NULL
 * where there are few lines, or most of them run from part to part. (transfer full) */
TinkerLineParts *tinker_line_parts_new(TinkerModel *model);
void tinker_line_parts_free(TinkerLineParts *parts);

/* model->force becomes the forces of all lines, for the state in the points. Answers the power that dampers take. */
double tinker_line_parts_forces(TinkerModel *model);

#endif
