"""Waiting for something to become so. Nothing in these tests sleeps for a time that was guessed."""
import time

POLL = 0.02      # s
PATIENCE = 60.0  # s: under sanitizers and on a busy machine; what fails waits for it, what passes does not


class Gone(Exception):
    """The widget is no more, or not yet."""


class TooLate(Exception):
    """What was waited for did not come."""


def wait(condition, what, patience=PATIENCE):
    """Asks until the answer is true, and hands it over."""
    end = time.monotonic() + patience
    while True:
        try:
            answer = condition()
        except Gone:
            answer = None
        if answer:
            return answer
        if time.monotonic() > end:
            raise TooLate(f"waited {patience:g} s for {what}")
        time.sleep(POLL)
