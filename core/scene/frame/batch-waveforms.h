/* The waveforms of a batch, what t alone switches in its laws, and what the last search for a break of them went
 * through.
 */
#ifndef TINKER_CORE_BATCH_WAVEFORMS_H
#define TINKER_CORE_BATCH_WAVEFORMS_H

#include "scene/frame/batch.h"

/* Gives a new batch the evaluators of its waveforms. */
void tinker_block_batch_copy_waveforms(TinkerBlockBatch *batch);

/* Follows what t alone switches in a law of a block, which then has a waveform's breaks (borrowed). */
void tinker_block_batch_add_switches(TinkerBlockBatch *batch, int32_t row, TinkerWaveform *switches);

/* The block whose break tinker_block_batch_next_break found. */
int32_t tinker_block_batch_break_row(const TinkerBlockBatch *batch);

/* The first pole (units/waveform/waveform-pole.h) in what it searched, and the block whose it is; INFINITY for none. */
double tinker_block_batch_next_pole(const TinkerBlockBatch *batch, int32_t *row);

#endif
