/* What libFuzzer and the replay call. */
#ifndef TEST_FUZZ_TARGET_H
#define TEST_FUZZ_TARGET_H

#include <stddef.h>
#include <stdint.h>

/* Takes any bytes. A finding is a crash, a report of a sanitizer, or an abort. Answers 0. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Called once before all others; optional. */
int LLVMFuzzerInitialize(int *argc, char ***argv);

#endif
