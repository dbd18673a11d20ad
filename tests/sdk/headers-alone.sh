#!/bin/sh
# Compiles every header of the SDK alone, as C and as C++ of several years, and before and after cairo's own header.
# usage: headers-alone.sh FOLDER-OF-TINKER C-COMPILER C++-COMPILER; reports in TAP.
set -u
folder=$1
c_compiler=$2
cpp_compiler=$3
include=$(dirname "$folder")
cairo=$(pkg-config --cflags cairo 2>/dev/null) || cairo=
number=0
failed=0

# try NAME COMPILER LANGUAGE STANDARD SOURCE: one test.
try() {
    number=$((number + 1))
    # $2 and $cairo are command lines: their words are meant to be split.
    if output=$(printf '%s\n' "$5" | $2 -x "$3" -std="$4" -Wall -Wextra -pedantic -Werror -I"$include" $cairo \
        -fsyntax-only - 2>&1); then
        echo "ok $number $1 $4"
    else
        echo "not ok $number $1 $4"
        printf '%s\n' "$output" | sed 's/^/# /'
        failed=1
    fi
}

# in_all_standards NAME SOURCE
in_all_standards() {
    for standard in c99 c11 c17; do
        try "$1" "$c_compiler" c $standard "$2"
    done
    [ -n "$cpp_compiler" ] || return 0
    for standard in c++11 c++20; do
        try "$1" "$cpp_compiler" c++ $standard "$2"
    done
}

for header in "$folder"/*.h; do
    name=$(basename "$header")
    in_all_standards "$name" "#include <tinker/$name>"
done
if [ -n "$cairo" ]; then
    for name in render.h sdk.h; do
        in_all_standards "$name before cairo.h" "#include <tinker/$name>
#include <cairo.h>
struct _cairo *same(cairo_t *cairo);
struct _cairo *same(cairo_t *cairo) { return cairo; }"
        in_all_standards "$name after cairo.h" "#include <cairo.h>
#include <tinker/$name>
cairo_t *same(struct _cairo *cairo);
cairo_t *same(struct _cairo *cairo) { return cairo; }"
    done
fi
echo "1..$number"
exit $failed
