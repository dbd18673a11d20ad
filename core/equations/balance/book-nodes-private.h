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
    guint panel;  /* of one inside: which, */
    int point;    /* and its number there */
} TinkerBookNode;

/* Instants that are too near to one another to be told apart: the first and the last. */
typedef struct {
    double first, last; /* s */
} TinkerBookCut;

/* Functions that panels are judged by: a power, two forces, a moment. */
#define TINKER_BOOK_FUNCTIONS 4
/* The last coefficients of a function's Legendre series, which are kept: those of P4 to P7. */
#define TINKER_BOOK_TOPS 4

/* What is integrated over as one. */
typedef struct {
    double from, to; /* s */
    guint piece;     /* it lies in: the number of the cut that ends it, or how many cuts there are */
    /* Of the polynomials through what the functions are at the points: */
    double top[TINKER_BOOK_FUNCTIONS][TINKER_BOOK_TOPS];
    double end[TINKER_BOOK_FUNCTIONS][2]; /* what they come to at both ends */
} TinkerBookPanel;

/* About so many panels from one time to another, ascending; pieces end at the cuts (of TinkerBookCut, ascending).
 * Element: TinkerBookPanel. (transfer full) */
GArray *tinker_book_panels(double from, double to, const GArray *cuts, int panels);

/* The nodes of the panels, ascending; at the cuts velocities may jump or do not. (transfer full) */
GArray *tinker_book_nodes(double from, double to, const GArray *panels, const GArray *cuts, gboolean jump);

/* Forgets what the panels have taken. */
void tinker_book_panels_clear(GArray *panels);

/* The functions at a node of a panel. */
void tinker_book_panel_take(TinkerBookPanel *panel, int point, const double values[TINKER_BOOK_FUNCTIONS]);

/* How far the panel that is off the most is off, in units of what is allowed. */
double tinker_book_panels_off(const GArray *panels, const double allowed[TINKER_BOOK_FUNCTIONS]);

/* Makes smaller the panels over which an integral is off by more than `allowed` (of each function), the worst first, as
 * long as there are not more than `most` of them; narrow ones where a function has a jump or a kink. What the panels
 * have taken is forgotten. FALSE: none was made. */
gboolean tinker_book_panels_refine(GArray *panels, const double allowed[TINKER_BOOK_FUNCTIONS], guint most);

/* Halves those that are wider, the widest first, within `most` as well. FALSE: none was. */
gboolean tinker_book_panels_halve(GArray *panels, double width, guint most);

#endif
