/* Runs with a plugin that goes wrong after t = 1 s; what tests of it share. */
#ifndef TEST_CLI_CRASH_FIXTURE_H
#define TEST_CLI_CRASH_FIXTURE_H

#include "fixture.h"

#define CRASH_COLUMNS "Mass 0.x,Mass 1.x"

/* Two blocks of the exhibit's type on two masses that fly at 1 and 2 m/s, as a.json; after t = 1 s the exhibit
 * misbehaves. */
void crash_write_scene(const CliFixture *fixture, const char *type);

/* Runs it for 3 s, into r.csv. (transfer full) */
TestProgram *crash_run_exhibit(const CliFixture *fixture, const char *type, const char *interval, const char *columns);

/* r.csv has rows of 0, 0.125, ... 1 s, and nothing after them: x = v t. */
void crash_assert_record(const CliFixture *fixture);

/* An exhibit's library under another name in the test's folder. (transfer full) */
char *crash_copy_exhibit(const CliFixture *fixture, const char *exhibit, const char *name);

#endif
