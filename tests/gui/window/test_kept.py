#!/usr/bin/python3
"""Runs that are kept beside the next one: named by what was changed, seen as curves and as ghosts. The truth is uniform
motion without gravity: a mass at 1 m/s is at 0.5 m after 0.5 s, one at 2 m/s at 1 m."""
import re

from harness import App, check, check_close, main, mass, scene, wait

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
        run(app)
        plot = app.find(None, re.compile("^Graph of "))
        for _ in range(60):
            if any(node.has("focused") and node.name == plot.name for node in app.tree.refresh()):
                break
            app.press("Tab")
        app.press("s")  # of both runs, and what is too long for the screen is scrolled
        told = wait(lambda: app.look("label", re.compile("Mean = ")), "the statistics").name
        for name, mean in (("Ball: Vx 1 m/s", -1.75), ("Ball: Vx 2 m/s", -1.5)):
            check(f"\n\n{name}\n" in f"\n\n{told}", f"{name} is not told of in “{told}”")
            part = told[f"\n{told}".index(f"\n{name}\n"):]
            check_close(float(re.search("Mean = −([0-9.]+) m", part).group(1)), -mean, 1e-9, f"mean of {name} (m)")
        x, y, width, height = app.settled(app.find("button", "Close", inside=app.find(None, "Statistics")))
        check(y + height <= 900, "the button is on the screen")
        app.press("Escape")
        app.gone(None, "Statistics")
        app.focus_window()
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


def test_legend_without_room_tells_its_names_whole(display):
    """While the pointer is over it, and nowhere else."""
    long_name = "A Ball With a Name That Is Much Too Long For Any Legend However Broad the Graph May Ever Become"
    names = [f"{long_name} {i}" for i in range(6)]
    balls = [mass(name, -2, i, velocity=[1, 0]) for i, name in enumerate(names)]
    graph = {"curves": [{"block": name, "quantity": "x"} for name in names]}
    with App(display, scene(*balls, duration=0.5, graphs=[graph])) as app:
        run(app)
        x, y, width, height = app.settled(app.find(None, re.compile("^Graph of ")))

        def told():
            return app.look("label", re.compile("\n".join(f"{name}.*" for name in names)))

        app.xdotool("mousemove", int(x + width / 2), int(y + 0.7 * height))
        wait(lambda: told() is None, "nothing to be told over the curves")
        app.xdotool("mousemove", int(x + width / 2), int(y + 42))
        wait(told, "the names")
        app.xdotool("mousemove", int(x + width / 2), int(y + 0.7 * height))
        wait(lambda: told() is None, "them to go")


if __name__ == "__main__":
    main()
