#!/usr/bin/python3
"""Runs that are kept beside the next one: named by what was changed, seen as curves and as ghosts. The truth is uniform
motion without gravity: a mass at 1 m/s is at 0.5 m after 0.5 s, one at 2 m/s at 1 m."""
import re

from harness import App, main, mass, scene, wait

GRAPH = {"block": "Ball", "quantity": "x"}


def sliding():
    return scene(mass("Ball", -2, 0, velocity=[1, 0]), duration=0.5, graphs=[GRAPH])


def run(app):
    app.click("Play")
    wait(lambda: app.time() == 0.5 and not app.is_playing(), "the end of the run")


def plot_picture(app):
    x, y, width, height = app.settled(app.find(None, re.compile("^Graph of ")))
    return app.picture().cut((x + 50, y + 30, x + width - 10, y + height - 30))


def test_kept_run_is_shown_renamed_and_taken_away(display):
    with App(display, sliding()) as app:
        app.press("ctrl+k")
        app.find_text("there is no run to keep")
        run(app)
        app.press("ctrl+k")
        app.find_text("Kept as “Run 1”")
        app.click_block("Ball")
        app.enter("Initial Velocity", "Vx", "2")
        app.press("ctrl+shift+k")
        dialog = app.find(None, "Kept Runs")
        app.find("text", "Name of Ball: Vx 1 m/s", inside=dialog)  # as in the legend of the graph
        app.press("Escape")
        app.gone(None, "Kept Runs")
        app.focus_window()
        run(app)
        app.press("ctrl+k")
        app.find_text("Kept as “Ball: Vx 2 m/s”")
        both = plot_picture(app)
        app.press("ctrl+shift+k")
        dialog = app.find(None, "Kept Runs")
        entry = app.find("text", "Name of Ball: Vx 1 m/s", inside=dialog)
        app.retype(entry, "slow")
        app.click("Show Ball: Vx 1 m/s", role="check box", inside=dialog)
        app.click("Remove Ball: Vx 2 m/s", inside=dialog)
        wait(lambda: app.look("button", re.compile("^Remove Ball"), inside=dialog) is None, "the second one to go")
        app.find("check box", "Show slow", inside=dialog)
        app.press("Escape")
        app.gone(None, "Kept Runs")
        app.focus_window()
        wait(lambda: plot_picture(app) != both, "one curve less")


if __name__ == "__main__":
    main()
