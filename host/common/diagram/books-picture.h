/* The books of bodies as a picture: for each way of keeping them what was there before, what every force gave, each bar
 * where the one before it ended, and what came of it. */
#ifndef TINKER_HOST_BOOKS_PICTURE_H
#define TINKER_HOST_BOOKS_PICTURE_H

#include <cairo.h>

#include "common/overlay/pointed.h"
#include "equations/balance/books.h"
#include "render/draw/theme.h"

/* Everything is borrowed. */
typedef struct {
    TinkerScene *scene;
    const TinkerBooks *books;
    const TinkerBlockId *bodies; /* that they are of, ended by TINKER_NO_BLOCK */
    const TinkerTheme *theme;
    const TinkerPointed *lit; /* whose bars stand out from others, where there are any; NULL: nobody's */
    GArray *spots;            /* of TinkerSpot: receives where rows of forces are; NULL: nobody asks */
} TinkerBooksPicture;

/* Draws them over all of width and height; `data` is a TinkerBooksPicture. */
void tinker_books_draw(cairo_t *cairo, double width, double height, void *data);

/* The point that angular impulse and momentum are about: "the origin", "(1 m, 2 m)". (transfer full) */
char *tinker_books_about(const TinkerBooks *books, TinkerScene *scene);

/* What a part of an entry is called (books.h): "Spring 0", "Floor (Normal force)". (transfer full) */
char *tinker_book_part_name(const TinkerBooks *books, TinkerScene *scene, const TinkerBookEntry *entry, int part);

#endif
