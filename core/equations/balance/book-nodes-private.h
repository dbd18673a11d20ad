/* The times at which the books look at a run. */
#ifndef TINKER_CORE_BOOK_NODES_PRIVATE_H
#define TINKER_CORE_BOOK_NODES_PRIVATE_H

#include <glib.h>

typedef enum {
    TINKER_NODE_INSIDE, /* of a panel, with a weight */
    TINKER_NODE_START,
    TINKER_NODE_END,
    TINKER_NODE_BEFORE, /* just before an instant at which velocities may jump, */
    TINKER_NODE_AFTER,  /* and at it */
} TinkerNodeKind;

typedef struct {
    double time, weight; /* s */
    TinkerNodeKind kind;
    double since; /* s: of one after instants, the first of them */
} TinkerBookNode;

/* Instants that are too near to one another to be told apart: the first and the last. */
typedef struct {
    double first, last; /* s */
} TinkerBookCut;

/* The nodes from one time to another, ascending, with about so many panels; pieces end at the cuts (of
 * TinkerBookCut, ascending), where velocities may jump or do not. (transfer full) */
GArray *tinker_book_nodes(double from, double to, const GArray *cuts, gboolean jump, int panels);

#endif
