/* What `tinker equations` writes, read back and worked out. */
#ifndef TEST_CLI_WRITTEN_H
#define TEST_CLI_WRITTEN_H

#include <cjson/cJSON.h>

#include "fixture.h"

/* What a command of the program writes, as JSON, which is for the caller to delete. */
cJSON *written_json(CliFixture *fixture, const char *command);

/* The value of a symbol. */
double written_symbol(const cJSON *root, const char *name);

/* Fails the test unless nothing is left as a number that no law says. */
void written_assert_all(const cJSON *root);

void written_assert_near(double value, double expected, double within);

/* Fails the test unless the page of a command holds each of these texts, which end with NULL. */
void written_assert_page(CliFixture *fixture, const char *command, const char *const lines[]);

/* Values by name, and what stands for a name. */
typedef struct {
    GHashTable *values; /* name to double */
    const cJSON *definitions[2];
} WrittenValues;

/* Those of a page's symbols and definitions; the caller frees `values`. */
WrittenValues written_values(const cJSON *root);
void written_know(WrittenValues *known, const char *name, double value);

/* What an expression is worth, by the forms that equations have. */
double written_value(const WrittenValues *known, const cJSON *expression);

#endif
