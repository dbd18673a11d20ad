# To be sourced by .ci/run and .ci/nightly: checks that count what passed and failed, also beside each other.

reports=$(mktemp -d)
lines=()
# Each line of parts is a process group of its own, so that it ends with us, however we end.
set -m
end_lines() {
    local line
    for line in ${lines[@]+"${lines[@]}"}; do kill -- "-$line" 2>/dev/null; done
    rm -rf "$reports"
}
trap end_lines EXIT
trap 'exit 1' INT TERM

# Runs a function, which calls some parts in turn, beside others.
line() {
    "$@" &
    lines+=("$!")
}

# part NAME COMMAND...: runs it, and tells what it printed when it has ended, not mixed with others.
part() {
    local name=$1 start=$SECONDS status=0
    shift
    printf '==> Started: %s\n' "$name"
    "$@" </dev/null >"$reports/$name.output" 2>&1 || status=$?
    exec 8>>"$reports/lock"
    flock 8
    cat "$reports/$name.output"
    printf '==> Ended after %d s: %s\n' $((SECONDS - start)) "$name"
    printf '%s %s\n' "$status" "$name" >>"$reports/ended"
    exec 8>&-
}

# Repeats what a part that failed said of it: the tests that failed, or else the end of its output.
tell_failure() {
    local output=$1 name=$2
    printf '\n==> Failed: %s\n' "$name"
    if grep -q '^FAILED: ' "$output"; then
        sed -n '/^FAILED: /,/^$/p' "$output"
    else
        tail -n 60 "$output"
    fi
}

# Waits for all lines and adds up the counts of the last lines of their parts, of which there are to be so many; a part that ended
# without counts has failed as a whole, and so has one that did not end.
sum_up() {
    local expected=$1 passed=0 failed=0 ended=0 status name counts
    wait
    touch "$reports/ended"
    while read -r status name; do
        ended=$((ended + 1))
        if counts=$(tail -n 1 "$reports/$name.output" | grep -E '^[0-9]+ passed, [0-9]+ failed$'); then
            passed=$((passed + ${counts%% passed*}))
            counts=${counts#*, }
            counts=${counts%% failed*}
            failed=$((failed + counts))
            if [ "$status" -ne 0 ] && [ "$counts" -eq 0 ]; then failed=$((failed + 1)); fi
        else
            counts=1
            failed=$((failed + 1))
        fi
        if [ "$status" -ne 0 ] || [ "$counts" -ne 0 ]; then tell_failure "$reports/$name.output" "$name"; fi
    done <"$reports/ended"
    if [ "$ended" -lt "$expected" ]; then
        printf '\n==> Failed: %d parts did not end\n' $((expected - ended))
        failed=$((failed + expected - ended))
    fi
    printf '%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ]
}
