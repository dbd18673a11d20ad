#!/bin/bash
# What bash completes: verbs, options of a verb, names of files.
#   test-completion.bash FOLDER-OF-TINKER COMPLETION
PATH=$1:$PATH
# shellcheck source=/dev/null
. "$2"
number=0
failed=0

# The words of a command line, the last one unfinished; what is expected comes first, separated by blanks.
completes() {
    local expected=$1
    shift
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _tinker
    number=$((number + 1))
    if [ "${COMPREPLY[*]}" = "$expected" ]; then
        echo "ok $number - $*"
    else
        echo "not ok $number - $*: ${COMPREPLY[*]}"
        failed=1
    fi
}

completes 'plan plugins' tinker pl
completes 'trade' tinker help tr
completes '--duration=' tinker run --dur
completes '--no-estimate' tinker run --no
completes 'show' tinker plugins sh
completes 'list show check describe refused new new-bundle' tinker plugins ''
completes 'support-motion support-turn support' tinker plugins show sup
completes 'rk4' tinker run a.json --method = rk
completes 'verlet verlet6' tinker run --method=verl
completes 'auto' tinker run --method au
completes '--help' tinker modes --he
completes "$2" tinker run "${2%sh}"
echo "1..$number"
exit $failed
