/* The law that a block type states, read: expressions over the symbols of its properties and of its role. */
#ifndef TINKER_CORE_BLOCK_LAW_H
#define TINKER_CORE_BLOCK_LAW_H

#include "law/typed-law.h"
#include "plugin/catalogue/catalogue.h"
#include "units/expression/expression-tree.h"

typedef enum {
    TINKER_LAW_LINE,
    TINKER_LAW_FORCE,
    TINKER_LAW_FIELD,
    TINKER_LAW_CONSTRAINT,
    TINKER_LAW_MOTION,
    TINKER_LAW_NONE, /* of a body, or of a block that does nothing */
} TinkerLawRole;

TinkerLawRole tinker_law_role(const TinkerBlockClass *block_class);

/* Something that a law may name. */
typedef struct {
    char *name;
    int32_t property;     /* of the class; -1: it belongs to the role */
    int32_t column;       /* of the property's value */
    char component;       /* 'x' or 'y' of a vector; 0: the property is none */
    gboolean at_time;     /* a waveform: its value at t, or ... */
    gboolean at_start;    /* ... at the start */
    gboolean absent;      /* of an end that a block of the class may have, and this one has not: 0 */
    int32_t end;          /* of an end: its number, from 0; else -1 */
    const char *quantity; /* of an end: "x", "y", "vx", "vy", "theta", "omega", "turns", "x_start", ...; static */
    TinkerDimension dimension;
    double number; /* of a property that is a text: its number, SI */
} TinkerLawSymbol;

typedef struct {
    const char *symbol, *means; /* the plugin's own */
    TinkerDimension dimension;
    TinkerExpression *is;
} TinkerLawDefinition;

typedef struct {
    TinkerLawRole role;
    gboolean typed;      /* by the user: in plain SI numbers, whatever its units come to */
    GArray *symbols;     /* of TinkerLawSymbol */
    GArray *definitions; /* of TinkerLawDefinition, in the order in which each uses those before it */
} TinkerBlockLaw;

/* The law of a class whose blocks have so many ends (what it says of ends is written for each number). NULL without an
 * error where it states none, or nothing for this role; with one where it cannot be read: which equation, and why
 * (transfer full). */
TinkerBlockLaw *tinker_block_law_new(const TinkerBlockClass *block_class, int32_t ends, GError **error);
/* The law that is typed into a block (typed-law.h), whose texts these are: NULL without an error where the class has no
 * such properties, or all of them are empty. Errors as above. (transfer full) */
TinkerBlockLaw *tinker_block_law_new_typed(const TinkerBlockClass *block_class, int32_t ends,
                                           TinkerTypedLawTextFunc text_of, void *data, GError **error);
void tinker_block_law_free(TinkerBlockLaw *law);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerBlockLaw, tinker_block_law_free)

/* What an equation says of its symbol; NULL where there is none. Borrowed. */
const TinkerExpression *tinker_block_law_find(const TinkerBlockLaw *law, const char *symbol);

/* The whole of it. */
const TinkerLawDefinition *tinker_block_law_definition(const TinkerBlockLaw *law, const char *symbol);

/* Whether an equation uses a symbol. */
gboolean tinker_block_law_names(const TinkerBlockLaw *law, const char *symbol);

const TinkerLawSymbol *tinker_block_law_symbol(const TinkerBlockLaw *law, const char *name);

/* Whether a law's equation is one of the steps on the way, not one that its role asks for. */
gboolean tinker_law_is_step(const char *symbol);

#endif
