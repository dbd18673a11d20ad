/* Books as JSON: docs/reference/books.md. */
#ifndef TINKER_CLI_BOOKS_JSON_H
#define TINKER_CLI_BOOKS_JSON_H

#include "equations/balance/books.h"

/* (transfer full, g_free) */
char *tinker_books_json(const TinkerBooks *books, TinkerScene *scene, const TinkerBlockId *bodies);

#endif
