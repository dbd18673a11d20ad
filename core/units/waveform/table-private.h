/* Tables: a function of time given by rows. Private to this room.
 *
 * Piece p lies between row p - 1 and row p; piece 0 is before the first row, piece `rows` behind the last. */
#ifndef TINKER_TABLE_PRIVATE_H
#define TINKER_TABLE_PRIVATE_H

#include "units/waveform/waveform.h"

#define TINKER_TABLE_MOST_ROWS  10000000
#define TINKER_TABLE_MOST_BYTES (256 << 20) /* of a file */

typedef struct {
    gsize rows;
    double *times;
    double *values;
    TinkerTableKind kind;
    int column;              /* of the file that it was read from; 0: none */
    double scale;            /* that the values have been multiplied by */
    double *speeds, *places; /* of an acceleration: what it has grown to at each row, from rest at the first */
    double *bends;           /* of a smooth value: the spline's second derivative at each row; made when asked for */
} TinkerTable;

/* Takes both arrays, also on failure. (transfer full) */
TinkerTable *tinker_table_new(double *times, double *values, gsize rows, TinkerTableKind kind, GError **error);
void tinker_table_free(TinkerTable *table);

/* Reads the rows of a file, see tinker_waveform_new_table_file. (transfer full) */
TinkerTable *tinker_table_read(const char *path, int column, double scale, TinkerTableKind kind, GError **error);

/* Makes the spline ready, once; from any thread. TINKER_WAVEFORM_ERROR_FILE where there is no memory for it. */
gboolean tinker_table_prepare_spline(TinkerTable *table, GError **error);

/* The number of rows up to and including t: the piece right of t. */
gsize tinker_table_piece(const TinkerTable *table, double t);

/* Value and two derivatives at t by piece `piece`. */
void tinker_table_evaluate(const TinkerTable *table, gsize piece, gboolean smooth, double t, double result[3]);

#endif
