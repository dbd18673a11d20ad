#!/usr/bin/python3
"""A film of the scene: asked for by menu, dialog and file name, shown as it goes on, cancelled. What is called ffmpeg is a script,
so that the window is the same wherever it is tested; the film itself is tested in tests/gui/test-film-task.c."""
import os
import re

from harness import App, colours, check, check_equal, main, mass, scene, support, wait

TAKES_ALL = "#!/bin/sh\nfor last; do :; done\nexec /bin/cat >\"${last#file:}\"\n"
BYTES = 640 * 480 * 4  # of a picture


def environment(display, home, script):
    """One in which ffmpeg is this script, and comes first."""
    programs = home / "programs"
    programs.mkdir()
    (programs / "ffmpeg").write_text(script)
    (programs / "ffmpeg").chmod(0o700)
    return {"PATH": f"{programs}:{os.environ['PATH']}"}


def app_with(display, script, duration):
    home = display.new_home()
    return App(display, scene(mass("A", 0, 0, velocity=[1, 0]), duration=duration), home=home,
               environment=environment(display, home, script))


def ask_for_film(app):
    app.click("Main Menu")
    app.choose("Export Film…")
    return app.find(None, "Export Film")


def left_over(app):
    return [file.name for file in app.home.iterdir() if "film" in file.name]


def test_film_is_exported(display):
    with app_with(display, TAKES_ALL, duration=1) as app:
        dialog = ask_for_film(app)
        app.find_text("in 26 pictures")
        app.click(re.compile("^Export…"), inside=dialog)
        app.save_dialog("Save Film", app.home / "film.mp4")
        wait(lambda: (app.home / "film.mp4").exists(), "the film")
        check_equal((app.home / "film.mp4").stat().st_size, 26 * BYTES, "bytes of all pictures")
        app.find_text("Saved as film.mp4")
        app.gone("progress bar", "Progress of the film")
        check_equal(left_over(app), ["film.mp4"], "files")


def test_graphs_below_the_motion(display):
    """What goes to ffmpeg has the colour of curves, blue first, where graphs are asked for."""
    home = display.new_home()
    graphed = scene(mass("A", 0, 0, velocity=[1, 0]), duration=1, graphs=[{"block": "A", "quantity": "x"}])
    curve = bytes(reversed(colours.CURVE))
    with App(display, graphed, home=home, environment=environment(display, home, TAKES_ALL)) as app:
        for name, wanted in (("plain.mp4", False), ("graphs.mp4", True)):
            dialog = ask_for_film(app)
            if wanted:
                app.click(app.find("check box", "Graphs below the Motion", inside=dialog))
            app.click(re.compile("^Export…"), inside=dialog)
            app.save_dialog("Save Film", app.home / name)
            wait((app.home / name).exists, "the film")
            check_equal(curve in (app.home / name).read_bytes(), wanted, f"a curve in {name}")
            app.gone("progress bar", "Progress of the film")


def test_arrows_of_forces_in_the_film(display):
    """As the canvas shows them: of a body at rest on its floor the normal force has a colour of its own."""
    home = display.new_home()
    normal = bytes(reversed(colours.NORMAL))
    resting = scene(support("Floor", 0, 0), mass("Box", 0, 0.6), {"type": "gravity", "name": "Gravity"}, duration=0.2)
    with App(display, resting, home=home, environment=environment(display, home, TAKES_ALL)) as app:
        for name, wanted in (("plain.mp4", False), ("arrows.mp4", True)):
            if wanted:
                app.activate("show-forces")
            dialog = ask_for_film(app)
            app.click(re.compile("^Export…"), inside=dialog)
            app.save_dialog("Save Film", app.home / name)
            wait((app.home / name).exists, "the film")
            check_equal(normal in (app.home / name).read_bytes(), wanted, f"an arrow in {name}")
            app.gone("progress bar", "Progress of the film")


def test_film_is_cancelled(display):
    with app_with(display, "#!/bin/sh\nexec /bin/sleep 1000\n", duration=100) as app:
        ask_for_film(app)
        app.press("Return")
        app.save_dialog("Save Film", app.home / "film.gif")
        app.find("progress bar", "Progress of the film")
        check(not app.is_enabled("export-film"), "there is one film at a time")
        app.place("Mass")  # all else goes on
        app.click("Cancel")
        app.find_text("The film was cancelled")
        app.gone("progress bar", "Progress of the film")
        check_equal(left_over(app), [], "files")
        check(app.is_enabled("export-film"), "another film can be asked for")


def test_closing_cancels(display):
    with app_with(display, "#!/bin/sh\nexec /bin/sleep 1000\n", duration=100) as app:
        ask_for_film(app)
        app.press("Return")
        app.save_dialog("Save Film", app.home / "film.gif")
        app.find("progress bar", "Progress of the film")
        app.press("ctrl+w")
        wait(lambda: app.process.poll() is not None, "the end")
        check_equal(left_over(app), [], "files")


def test_failure_is_told(display):
    with app_with(display, "#!/bin/sh\necho 'No space left on device' >&2\nexit 1\n", duration=1) as app:
        ask_for_film(app)
        app.press("Return")
        app.save_dialog("Save Film", app.home / "film.webm")
        dialog = app.find("dialog", "The Film Was Not Exported")
        app.find_text("No space left on device")
        app.click("Close", inside=dialog)
        check_equal(left_over(app), [], "files")


if __name__ == "__main__":
    main()
