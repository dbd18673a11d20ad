/* Books for people: as text, and as CSV. */
#ifndef TINKER_CLI_BOOKS_REPORT_H
#define TINKER_CLI_BOOKS_REPORT_H

#include <stdio.h>

#include "equations/balance/books.h"

void tinker_books_write_text(const TinkerBooks *books, TinkerScene *scene, const TinkerBlockId *bodies, FILE *file);

/* A row a force: its name, force at the end, work, impulse, angular impulse. */
void tinker_books_write_csv(const TinkerBooks *books, TinkerScene *scene, FILE *file);

#endif
