/* What is known of the bundled woodpecker. The check runs the scene at this path. */
#ifndef TEST_WOODPECKER_CASE_H
#define TEST_WOODPECKER_CASE_H

void check_woodpecker(const char *path);

#endif
