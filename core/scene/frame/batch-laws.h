/* The typed laws of a batch. */
#ifndef TINKER_CORE_BATCH_LAWS_H
#define TINKER_CORE_BATCH_LAWS_H

#include "scene/frame/batch.h"

/* Compiles the laws of a new batch, which has its waveforms. */
void tinker_block_batch_compile_laws(TinkerBlockBatch *batch);

#endif
