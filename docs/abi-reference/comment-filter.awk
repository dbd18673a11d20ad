# The SDK's comments in the form that doxygen reads: the first of a file is about the file, a ruled line is only for the eye, one
# behind code is about what stands before it, any other is about what follows.
FNR == 1 {
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/^\/\*/, "/** @file " name "\n *")
    print
    next
}
/^\/\* .*---+ \*\/$/ { print ""; next }
/^ *\/\*/ { sub(/\/\*/, "/**") }
/[^ ].*\/\*[^*]/ { sub(/\/\*/, "/**<") }
{ print }
