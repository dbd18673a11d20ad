/* What is rounding of sample times. Each: its unit and what it is relative to; what it says; and where that was tried,
 * tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_RECORD_TOLERANCES_H
#define TINKER_RECORD_TOLERANCES_H

/* No unit; of the number of intervals: a duration that is a whole number of them within this ends with the last.
 * Held by: -. */
#define TINKER_WHOLE_INTERVALS 1e-9

#endif
