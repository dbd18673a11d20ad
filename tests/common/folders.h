/* Folders that tests make. */
#ifndef TEST_FOLDERS_H
#define TEST_FOLDERS_H

/* Removes a file, or a folder with all that is in it, but not what links in it lead to. */
void test_remove_all(const char *path);

#endif
