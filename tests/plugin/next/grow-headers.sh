#!/bin/sh
# Headers as the next minor version might have them: every struct that may grow has grown.
# usage: grow-headers.sh FOLDER HEADER OUTPUT
# A struct may grow if it has a struct_size; it gets the member `next_member`. TINKER_NEXT is defined.
set -eu
awk '
/^typedef struct Tinker[A-Za-z]* \{/ { inside = 1; grows = 0 }
inside && /struct_size;/ { grows = 1 }
/^\} Tinker[A-Za-z]*;/ { if (inside && grows) print "    double next_member[3];"; inside = 0 }
/^#define TINKER_ABI_MINOR / { print "#define TINKER_ABI_MINOR " ($3 + 1); print "#define TINKER_NEXT 1"; changed = 1; next }
{ print }
END { if (FILENAME ~ /types\.h$/ && !changed) { print "no TINKER_ABI_MINOR to raise" > "/dev/stderr"; exit 1 } }
' "$1/$2" > "$3"
