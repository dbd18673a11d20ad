/* The accounts of books as lists of entries with names: forces and momentum along x and y, energy, angular momentum. */
#ifndef TINKER_COMMON_BOOKS_ACCOUNTS_H
#define TINKER_COMMON_BOOKS_ACCOUNTS_H

#include "common/diagram/books-picture.h"

/* Which of the numbers an account is of. */
typedef enum {
    TINKER_ACCOUNT_FORCE_X,
    TINKER_ACCOUNT_FORCE_Y,
    TINKER_ACCOUNT_ENERGY,
    TINKER_ACCOUNT_ANGULAR,
    TINKER_ACCOUNT_MOMENTUM_X,
    TINKER_ACCOUNT_MOMENTUM_Y,
    TINKER_ACCOUNTS
} TinkerAccountKind;

typedef struct {
    char *name;
    double value;
    gboolean total; /* it stands by itself: what was there, what came of it */
    TinkerPointed what;
} TinkerAccountEntry;

typedef struct {
    char *title;
    TinkerDimension dimension;
    GArray *entries; /* of TinkerAccountEntry */
    const TinkerBookBalance *balance;
} TinkerAccount;

/* To be cleared. What is rounding alone is 0. */
TinkerAccount tinker_account_of(const TinkerBooksPicture *picture, TinkerAccountKind which);
void tinker_account_clear(TinkerAccount *account);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerAccount, tinker_account_clear)

/* Where there is no room for all, the least become one. */
void tinker_account_gather(TinkerAccount *account, guint most);

/* What an entry of the books, or a part of it, is of: in the books of one body the forces on it alone. */
TinkerPointed tinker_account_thing(const TinkerBooksPicture *picture, const TinkerBookEntry *entry, int part);

/* The point that angular impulse and momentum are about: "the origin", "(1 m, 2 m)". (transfer full) */
char *tinker_books_about(const TinkerBooks *books, TinkerScene *scene);

/* What a part of an entry is called (books.h): "Spring 0", "Floor (Normal force)". (transfer full) */
char *tinker_book_part_name(const TinkerBooks *books, TinkerScene *scene, const TinkerBookEntry *entry, int part);

#endif
