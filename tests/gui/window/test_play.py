#!/usr/bin/python3
"""Running, pausing, stepping, looking back, starting again."""
import os
import re

from harness import App, check, check_close, check_equal, main, mass, scene, wait
from harness.scenes import connector

GRAVITY = {"type": "gravity", "name": "Gravity"}


def falling(**more):
    return scene(mass("Ball", 0, 3), GRAVITY, **more)


def test_space_plays_and_pauses(display):
    with App(display, falling()) as app:
        app.click_world(2, 2)
        app.press("space")
        app.find("button", "Pause")
        wait(lambda: app.time() > 0.1, "time to pass")
        app.press("space")
        app.find("button", "Play")
        paused = app.time()
        app.show_width()
        check_equal(app.time(), paused, "time while paused")
        app.click("Play")
        wait(lambda: app.time() > paused, "time to pass again")


def test_reset_goes_back_to_what_is_edited(display):
    with App(display, falling()) as app:
        app.show_width()
        before = app.still_picture(-1, -2, 1, 4)
        app.click("Play")
        wait(lambda: app.time() > 0.3, "time to pass")
        app.click("Reset to the Start")
        wait(lambda: app.time() == 0 and not app.is_playing(), "the start")
        wait(lambda: app.picture().cut(app.area(-1, -2, 1, 4)) == before, "the picture of the start")
        check_equal(app.blocks()["Ball"]["position"], [0, 3], "place")


def test_reset_by_key(display):
    with App(display, falling()) as app:
        app.click_world(2, 2)
        app.press("period", "period")
        wait(lambda: app.time() == 0.02, "two steps")
        app.press("Home")
        wait(lambda: app.time() == 0, "the start")


def test_steps_are_samples(display):
    with App(display, falling()) as app:
        for number in (1, 2, 3):
            app.click("One Sample Forward")
            wait(lambda: app.time() == round(0.01 * number, 2), f"sample {number}")
        app.click("One Sample Back")
        wait(lambda: app.time() == 0.02, "sample 2 again")
        check(not app.is_playing(), "it is paused")


def test_time_line_looks_back(display):
    with App(display, falling(duration=1)) as app:
        app.click("Play")
        wait(lambda: app.time() == 1 and not app.is_playing(), "the end of the run")
        app.seek(0.5)
        check_close(app.time(), 0.5, 0.06, "time in the middle of the line")
        check(not app.is_playing(), "it is paused")


def test_play_at_the_end_begins_again(display):
    with App(display, falling(duration=3)) as app:  # long enough to be seen by one who is slow to look
        app.click("Play")
        wait(lambda: app.time() == 3 and not app.is_playing(), "the end")
        app.click("Play")
        wait(lambda: app.time() < 3, "the beginning")
        wait(lambda: app.time() == 3 and not app.is_playing(), "the end again")


def test_stops_when_a_condition_holds(display):
    """A fall of 1.2 m takes sqrt(2.4 / 9.81) s = 0.4946 s."""
    with App(display, falling(duration=2)) as app:
        app.show_width()
        app.click_world(3, -1)  # nothing: the scene itself
        app.enter("Run", "Stop When", "{Ball.y} = 1.8; event(impact)")
        app.wait_read("Run", "Stop When", "{Ball.y} = 1.8; event(impact)")
        check_equal(app.saved()["run"]["until"], "{Ball.y} = 1.8; event(impact)", "condition in the file")
        app.click("Play")
        wait(lambda: app.time() == 0.49 and not app.is_playing(), "the stop, to the decimals that are shown")
        app.find_text("0.4946 s: Stopped where {Ball.y} = 1.8")
        check_equal(app.find("slider", "Time line").description, "0.4946 s: Stopped where {Ball.y} = 1.8", "its mark")


def test_hand_pulls_while_it_plays(display):
    """Without gravity a body at rest stays, until a hand takes it to the right."""
    blocks = (mass("Ball", 0, 0), connector("hand", "Hand", "Ball", place=[0, 1.6], pulls=True, damping=10))
    with App(display, scene(*blocks, duration=60)) as app:
        app.show_width()
        app.click_world(0, 1.0)
        app.click("Play")
        wait(lambda: app.time() > 0.2, "time to pass")
        before = app.time()
        app.drag((0, 1.6), (3, 1.6))
        wait(lambda: app.time() > before + 1, "time to go on")
        check(app.is_playing(), "it plays on")
        check_equal(app.blocks()["Hand"]["place"], [3, 1.6], "place of the hand in the file")


def test_play_back_follows_the_clock(display):
    """Whatever the frame rate: 1 s of the run takes 1 s. That it takes no more, a busy machine cannot show."""
    import time
    with App(display, falling(duration=1.5)) as app:
        play, start = app.find("button", "Play"), time.monotonic()
        app.click(play)
        wait(lambda: app.time() == 1.5, "the end")
        check(time.monotonic() - start > 1.45, f"1.5 s took {time.monotonic() - start:.2f} s")


def test_drag_after_the_start_goes_back_first(display):
    with App(display, falling(), home=display.patient_home()) as app:
        app.show_width()
        app.click("One Sample Forward")
        wait(lambda: app.time() > 0, "a step")
        app.drag((0.2, 3.2), (2.2, 3.2))
        app.find_text("Back at the start")
        wait(lambda: app.time() == 0, "the start")
        check_equal(app.blocks()["Ball"]["position"], [0, 3], "nothing was moved")


def test_run_that_fails_says_why_and_keeps_what_there_is(display):
    motor = connector("motor", "Motor", "Ball", waveform={"expression": "sqrt(0.5 - t)"})
    with App(display, scene(mass("Ball", 0, 0), motor, duration=1)) as app:
        app.click("Play")
        dialog = app.find("dialog", "The Run Stopped")
        app.find_text("Motor: at t = 0.5 s its waveform has no finite value")
        app.click("Close", inside=dialog)
        app.gone("dialog")
        check_close(app.time(), 0.5, 0.011, "the last instant")
        app.seek(0.4)
        check_close(app.time(), 0.4, 0.1, "an earlier instant")


def test_looking_for_the_end_is_told_and_given_up(display):
    """Nothing can be shown before it is known where the run stops, which takes long where that is never."""
    content = scene(mass("A", 0, 0, velocity=[1e-6, 0]), duration=1e6, interval=0.01)
    content["run"]["until"] = "{A.x} > 1e9"
    with App(display, content) as app:
        app.click("Play")
        app.find_text("Looking for where the run stops…")
        app.find_text("looking for where it stops: ")
        keep = os.environ.get("TINKER_PICTURES")
        if keep:
            app.picture().write_png(f"{keep}/looking.png")
        app.click("Cancel")
        wait(lambda: not app.is_playing(), "it to be given up")
        wait(lambda: app.look("label", re.compile("looking for where it stops")) is None, "the status to say no more of it")
        check_equal(app.time(), 0, "time")


if __name__ == "__main__":
    main()
