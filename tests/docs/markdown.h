/* What the tests of the documentation read out of a Markdown file: its marked listings and its links. */
#ifndef TEST_MARKDOWN_H
#define TEST_MARKDOWN_H

#include <glib.h>

/* A fenced listing below a line `<!-- KIND: ARGUMENT in FOLDER -->`. */
typedef struct {
    char *kind; /* "listing": the file whose text it is; "output": what the program prints for these arguments */
    char *argument;
    char *folder; /* of an output: where the program runs, relative to the document; or empty */
    char *text;
} MarkdownListing;

/* All marked listings of a text, of MarkdownListing *. Fails the test where a mark has no fenced listing below it.
 * (transfer full) */
GPtrArray *markdown_listings(const char *text);

/* The targets of links to files, without their #fragments; of char *. (transfer full) */
GPtrArray *markdown_links(const char *text);

/* All Markdown files of the project, as absolute paths. (transfer full) */
GPtrArray *markdown_files(const char *sources);

/* A file or a folder of the sources, by its path in them. (transfer full) */
char *markdown_source_path(const char *relative);

#endif
