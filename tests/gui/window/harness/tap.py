"""Runs the functions test_* of a file, one after the other on one display, and reports as TAP."""
import os
import pathlib
import signal
import sys
import time
import traceback

from .display import Display


class Failure(AssertionError):
    """Something was not as it has to be."""


def check(condition, what):
    if not condition:
        raise Failure(what)


def check_equal(actual, expected, what):
    check(actual == expected, f"{what}: {actual!r}, expected {expected!r}")


def check_close(actual, expected, tolerance, what):
    check(abs(actual - expected) <= tolerance, f"{what}: {actual!r}, expected {expected!r} within {tolerance:g}")


def say(text):
    for line in str(text).rstrip().splitlines():
        print("#", line, flush=True)


def keep_picture(display):
    folder = pathlib.Path(os.environ.get("G_TEST_BUILDDIR", "/tmp")) / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{display.name}.png"
    display.picture().write_png(file)
    say(f"what it looked like: {file}")


def run_one(test, display):
    """Whether it passed."""
    try:
        test(display)
        return True
    except Exception:
        say(traceback.format_exc())
        return False


def run_patiently(test, display):
    """Whether it passed. A hand is sometimes quicker than a program that shares its processor with others, so what fails is
    tried once more, from a new start; that is said, and what fails twice has failed."""
    if run_one(test, display):
        return True
    say("once more")
    return run_one(test, display)


def run_all(tests, wanted, display, group):
    """How many of them failed."""
    print(f"1..{len(wanted)}", flush=True)
    failed = 0
    for number, name in enumerate(wanted, 1):
        display.name = f"{group}-{name}"
        start = time.monotonic()
        passed = run_patiently(tests[name], display)
        failed += not passed
        print(f"{'ok' if passed else 'not ok'} {number} {name}", flush=True)
        say(f"{time.monotonic() - start:.1f} s")
    return failed


def main(module="__main__"):
    """Runs the tests of the file that calls it, or those named on the command line."""
    names = vars(sys.modules[module])
    tests = {name[5:].replace("_", "-"): function for name, function in names.items()
             if name.startswith("test_") and callable(function)}
    wanted = sys.argv[1:] or list(tests)
    group = pathlib.Path(sys.argv[0]).stem.removeprefix("test_")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("taken too long"))  # so that what was started is ended
    display = Display()
    try:
        failed = run_all(tests, wanted, display, group)
    finally:
        display.close()
    sys.exit(1 if failed else 0)
