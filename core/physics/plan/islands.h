/* Islands: the parts of a model that nothing ties together. Each is a small model of its own, planned and stepped
 * apart.
 *
 * Which bodies belong together: partition.h. */
#ifndef TINKER_CORE_ISLANDS_H
#define TINKER_CORE_ISLANDS_H

#include "physics/line/linear-form.h"
#include "physics/model/model.h"

typedef struct {
    TinkerModel *model;       /* of this island alone; the whole model where it is the only one */
    gboolean owns_model;      /* else it is the whole one, borrowed */
    int32_t *body_of;         /* of each body of `model`: its number in the whole model */
    TinkerLinearForm *linear; /* NULL where the island is not linear */
} TinkerIsland;

/* The islands of a model, which they borrow; in the order of their first bodies. Element: TinkerIsland *. NULL with an
 * error of the model where a part does not compile. (transfer full) */
GPtrArray *tinker_islands_new(TinkerModel *whole, GError **error);

/* The islands of a run. With contact as `impulses` a model that has contacts is one island, stepped in the plane: its
 * parts cost less together than apart. */
GPtrArray *tinker_islands_for(TinkerModel *whole, gboolean impulses, GError **error);

#endif
