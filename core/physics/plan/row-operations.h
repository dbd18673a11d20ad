/* Operations that constraint rows are expected to take. */
#ifndef TINKER_CORE_ROW_OPERATIONS_H
#define TINKER_CORE_ROW_OPERATIONS_H

#include "physics/model/model.h"

/* Of an instance whose plugin is asked. */
#define TINKER_OPERATIONS_ASKED 80.0

/* For once: Jacobian, factor, solve. */
double tinker_row_operations(const TinkerModel *model);

/* That one Newton step towards the rows takes, and what comes before and behind them in a step. */
double tinker_row_operations_of_correction(const TinkerModel *model);
double tinker_row_operations_of_projection(const TinkerModel *model);

#endif
