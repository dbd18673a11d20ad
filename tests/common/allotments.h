/* How often memory was allotted, for tests of code that must not. Programs that count are linked with
 * `allotments_link_args`, which put these wrappers before the functions that allot. */
#ifndef TEST_ALLOTMENTS_H
#define TEST_ALLOTMENTS_H

extern _Atomic int allotments; /* of all threads */

#endif
