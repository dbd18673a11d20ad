/* What the two files of fragments share: the waveforms that a text does not hold. */
#ifndef TINKER_CORE_FRAGMENT_PRIVATE_H
#define TINKER_CORE_FRAGMENT_PRIVATE_H

#include "scene/history/fragment.h"
#include "scene/write/writer.h"

/* The key under which a fragment says what its waveforms are kept as. */
#define FRAGMENT_KEY "waveforms"

/* What was kept under this name: the waveforms' texts to SceneKeptWaveform; NULL where nothing is. (transfer full) */
GHashTable *fragment_kept(const char *token);

#endif
