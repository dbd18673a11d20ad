/* The table that the net writes: a line a run, sorted, its columns parted by tabs. */
#ifndef NET_TABLE_H
#define NET_TABLE_H

#include <glib.h>

enum {
    NET_SCENE,
    NET_METHOD,
    NET_STATUS,   /* "done"; "missed" its accuracy; "stopped", by itself; "cut", by the net's limit; "refused" */
    NET_SAMPLES,  /* how many */
    NET_RECORD,   /* SHA-256 of names and values of all columns; "-" without samples, and so are the others */
    NET_ESTIMATE, /* of how far each may be off */
    NET_SUMMARY,  /* of energies, events, warnings and how islands were stepped */
    NET_STEPS,
    NET_EVALUATIONS,
    NET_MESSAGE, /* of the error; "-" for none */
    NET_COLUMNS,
};

extern const char *const net_column_names[];

/* An array of lines: each is NET_COLUMNS strings, ended by NULL. (transfer full) */
GPtrArray *net_table_new(void);

/* Adds a line. Tabs and line feeds in the message become spaces. `fields` are borrowed. */
void net_table_add(GPtrArray *table, const char *const *fields);

void net_table_sort(GPtrArray *table);

/* By scene, then method; as strcmp. */
int net_line_compare(char *const *left, char *const *right);

/* The lines as text, without a heading. (transfer full) */
char *net_table_to_text(const GPtrArray *table);
gboolean net_table_add_text(GPtrArray *table, const char *text, GError **error);

/* As a file, with a heading, which is sorted when it is read. */
gboolean net_table_write(const GPtrArray *table, const char *path, GError **error);
GPtrArray *net_table_read(const char *path, GError **error);

#endif
