#!/usr/bin/env python3
"""Tells what failed in a run of "meson test": failures.py testlog.json

For each test that failed, a line "FAILED: NAME (RESULT)" and the end of what it printed, indented, up to an empty line.
"""
import json
import sys

LINES = 40


def last_lines(test):
    printed = test.get("stdout", "") + test.get("stderr", "")
    return [line for line in printed.splitlines() if line.strip()][-LINES:]


with open(sys.argv[1], encoding="utf-8") as log:
    for test in map(json.loads, log):
        if test["result"] not in ("OK", "EXPECTEDFAIL", "SKIP"):
            print(f"FAILED: {test['name']} ({test['result']})")
            for line in last_lines(test):
                print("    " + line)
            print()
