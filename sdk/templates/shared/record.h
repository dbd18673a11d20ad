/* For tests: runs a scene with `tinker run` and reads its record row by row. */
#ifndef RECORD_H
#define RECORD_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RECORD_MOST_COLUMNS 8 /* with the time; may be raised */

typedef struct {
    FILE *output;
    int columns;                       /* with the time */
    int rows;                          /* read so far */
    int failures;                      /* values that were not as expected, and lines that are no row */
    double value[RECORD_MOST_COLUMNS]; /* of the last row: the time (s), then the columns in the order asked for */
} Record;

/* A word of the command as one word of the shell. */
static inline void record_add_quoted(char *command, size_t room, const char *word)
{
    size_t used = strlen(command);
    if (used + 4 * strlen(word) + 4 > room) {
        fprintf(stderr, "the paths are too long\n");
        exit(2);
    }
    char *to = command + used;
    *to++ = ' ';
    *to++ = '\'';
    for (; *word != '\0'; word++) {
        if (*word == '\'') {
            memcpy(to, "'\\''", 4);
            to += 4;
        } else {
            *to++ = *word;
        }
    }
    memcpy(to, "'", 2);
}

/* The columns of a record with this heading, which has to be a whole line; ends the test where they are too many. */
static inline int record_count_columns(const char *heading)
{
    int columns = 1, quoted = 0;
    for (const char *at = heading; *at != '\0'; at++) {
        if (*at == '"') quoted = !quoted;
        columns += *at == ',' && !quoted;
    }
    if (columns <= RECORD_MOST_COLUMNS && strchr(heading, '\n') != NULL) return columns;
    fprintf(stderr, "the record has %d columns or more, at most %d are read: raise RECORD_MOST_COLUMNS in record.h\n",
            columns, RECORD_MOST_COLUMNS);
    exit(2);
}

/* The record of the scene, with these columns. The test is called as TEST TINKER SCENE PLUGIN-FOLDER [OPTIONS of run].
 */
static inline Record record_run(int argc, char **argv, const char *columns)
{
    static char command[16384];
    char heading[4096];
    if (argc < 4) {
        fprintf(stderr, "usage: %s TINKER SCENE PLUGIN-FOLDER [OPTIONS]\n", argv[0]);
        exit(2);
    }
    command[0] = '\0';
    const char *const words[] = {argv[1], "run", argv[2], "--plugins", argv[3], "--csv", "-", "--columns", columns};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        record_add_quoted(command, sizeof command, words[i]);
    for (int i = 4; i < argc; i++)
        record_add_quoted(command, sizeof command, argv[i]);
    Record record = {.output = popen(command, "r")};
    if (record.output == NULL || fgets(heading, sizeof heading, record.output) == NULL) {
        fprintf(stderr, "there is no record of:%s\n", command);
        exit(1);
    }
    record.columns = record_count_columns(heading);
    return record;
}

/* Reads the next row; 0 after the last one. What is no row ("# invalid from t = 1 s") is told, and has the test fail.
 */
static inline int record_next(Record *record)
{
    char line[4096];
    while (fgets(line, sizeof line, record->output) != NULL) {
        char *place = line, *end = line;
        int column = 0;
        while (column < record->columns) {
            record->value[column] = strtod(place, &end);
            if (end == place) break;
            column++;
            if (*end != ',') break;
            place = end + 1;
        }
        if (column == record->columns && *end == '\n') {
            record->rows++;
            return 1;
        }
        fprintf(stderr, "the record has a line that is no row of %d numbers: %s", record->columns, line);
        record->failures++;
    }
    return 0;
}

/* A value of the last row has to be this one. Written so that a NaN fails. */
static inline void record_expect(Record *record, const char *what, double value, double expected, double tolerance)
{
    if (fabs(value - expected) <= tolerance) return;
    fprintf(stderr, "t = %g: %s is %.17g, expected was %.17g\n", record->value[0], what, value, expected);
    record->failures++;
}

/* The exit status of the test: 0 where the run was good and all was as expected. */
static inline int record_finish(Record *record)
{
    const int status = pclose(record->output);
    if (record->rows == 0) fprintf(stderr, "the record is empty\n");
    return status == 0 && record->rows > 0 && record->failures == 0 ? 0 : 1;
}

#endif
