/* What the files of the unit system share: the table of units and the table of display units. */
#ifndef TINKER_UNITS_PRIVATE_H
#define TINKER_UNITS_PRIVATE_H

#include "units/quantity/units.h"

/* One symbol of the table: value in SI = factor * number. */
typedef struct {
    const char *symbol;
    double factor;
    TinkerDimension dimension;
} TinkerUnitEntry;

/* What a dimension is called, "a mass", and the units that it is displayed in. */
typedef struct {
    TinkerDimension dimension;
    const char *phrase; /* article and name, as translators need them */
    const char *si;
    const char *english;
} TinkerDimensionEntry;

/* The tables end with an entry without symbol or phrase. */
extern const TinkerUnitEntry tinker_unit_table[];
extern const TinkerDimensionEntry tinker_dimension_table[];

/* The entry of a symbol, or of a dimension; NULL where there is none. */
const TinkerUnitEntry *tinker_unit_lookup(const char *symbol);
const TinkerDimensionEntry *tinker_dimension_lookup(TinkerDimension dimension);

/* "a length (m)", "a plain number", "a value in kg m^3". (transfer full) */
char *tinker_dimension_describe(TinkerDimension dimension);

#endif
