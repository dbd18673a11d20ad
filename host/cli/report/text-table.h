/* Tables for people: columns as wide as their widest cell. */
#ifndef TINKER_CLI_TEXT_TABLE_H
#define TINKER_CLI_TEXT_TABLE_H

#include <stdio.h>

#include <glib.h>

typedef struct _TinkerTextTable TinkerTextTable;

/* `alignments` has one letter a column: 'l' or 'r'. `indent` spaces stand before every row. (transfer full) */
TinkerTextTable *tinker_text_table_new(const char *alignments, int indent);
void tinker_text_table_free(TinkerTextTable *table);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerTextTable, tinker_text_table_free)

/* The next cell, row by row. */
void tinker_text_table_add(TinkerTextTable *table, const char *text);
void tinker_text_table_add_format(TinkerTextTable *table, const char *format, ...) G_GNUC_PRINTF(2, 3);

/* Fills what is left of the row with empty cells. */
void tinker_text_table_end_row(TinkerTextTable *table);

void tinker_text_table_write(const TinkerTextTable *table, FILE *file);

#endif
