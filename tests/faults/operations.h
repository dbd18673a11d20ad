/* What is tried with faults: commands of the program and parts of the core, run in a child with a library put before
 * the C library (LD_PRELOAD). */
#ifndef TEST_FAULTS_OPERATIONS_H
#define TEST_FAULTS_OPERATIONS_H

#include "fixture.h"

/* Where an operation writes, there is a file with this before. */
#define FAULT_OLD_TEXT "what was there before\n"

/* An operation: the words of a command line, "@" standing for the folder; and the file that it writes. */
typedef struct {
    const char *name;
    gboolean worker; /* a part of the core, see worker.c; else the program */
    const char *words;
    const char *output; /* in the folder; NULL: none that stays */
    gboolean replaced;  /* as a whole: what was there before is not lost */
    const char *named;  /* part of what a message about a file names; "@": the folder; NULL: the output */
} FaultOperation;

extern const FaultOperation fault_operations[];
extern const gsize fault_operation_count;

/* Writes what the operation reads, and the old text where it will write. */
void fault_write_inputs(const CliFixture *fixture, const FaultOperation *operation);

/* Runs the operation behind the library `shim`, with a fault or (NULL) without. (transfer full) */
TestProgram *fault_run(const CliFixture *fixture, const FaultOperation *operation, const char *shim, const char *fault);

/* The file by which the library tells that it came to the fault. (transfer full) */
char *fault_mark(const CliFixture *fixture);

/* What the operation wrote; nothing where there is no file. (transfer full) */
GBytes *fault_written(const CliFixture *fixture, const FaultOperation *operation);

/* Whether it writes a report, as JSON. */
gboolean fault_writes_report(const FaultOperation *operation);

/* Whether the operation wrote what it writes without a fault, times that were measured aside. */
gboolean fault_is_whole(const CliFixture *fixture, const FaultOperation *operation, GBytes *reference);

/* Nothing is left lying about: temporary files would be. */
void fault_assert_no_leftovers(const CliFixture *fixture);

#endif
