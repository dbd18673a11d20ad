#!/usr/bin/python3
"""Running, pausing, stepping, looking back, starting again."""
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


if __name__ == "__main__":
    main()
