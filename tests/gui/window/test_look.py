#!/usr/bin/python3
"""Looking at graphs: zoomed, moved on, read and measured. The truth is a throw straight up from 0 at 9.81 m/s under
gravity of 9.81 m/s²: it is highest at 1 s, at 4.905 m, and back at 0 after 2 s."""
import re

from harness import App, check, check_close, check_equal, colours, main, mass, scene, wait

GRAVITY = {"type": "gravity", "name": "Gravity"}
HEIGHT = {"block": "Ball", "quantity": "y"}
SPEED = {"block": "Ball", "quantity": "vy"}
SHOWS = re.compile(r"shows (\S+) to (\S+) s")


def thrown(*graphs, **more):
    return scene(mass("Ball", 0, 0, velocity=[0, 9.81]), GRAVITY, duration=2.5, graphs=list(graphs), **more)


def graph(app, name="^Graph of "):
    return app.find(None, re.compile(name))


def run(app):
    app.click("Play")
    wait(lambda: app.time() == 2.5 and not app.is_playing(), "the end of the run")


def shown(app, node):
    """The time from and to that a graph tells that it shows; None: all."""
    found = SHOWS.search(node.refreshed().description)
    return found and tuple(map(float, found.groups()))


def plot_box(app, node):
    """About where the curves are."""
    x, y, width, height = app.settled(node)
    return x + 60, y + 40, x + width - 20, y + height - 45


def focus(app, node):
    x, y, _, _ = app.settled(node)
    app._click_at(x + 40, y + 9)  # its title


def test_wheel_zooms_all_graphs_over_time(display):
    with App(display, thrown(HEIGHT, SPEED)) as app:
        run(app)
        height, speed = graph(app, "^Graph of .*Y Position"), graph(app, "^Graph of .*Y Velocity")
        check(shown(app, height) is None, "all is shown at first")
        left, top, right, bottom = plot_box(app, height)
        app.xdotool("mousemove", (left + right) / 2, (top + bottom) / 2, "click", 4, "click", 4, "click", 4)
        wait(lambda: shown(app, height), "it to be zoomed")
        wait(lambda: shown(app, height)[1] - shown(app, height)[0] < 1.5, "three steps of zoom")
        check_equal(shown(app, speed), shown(app, height), "times of both graphs")
        middle = sum(shown(app, height)) / 2
        check(0.8 < middle < 1.7, f"{middle} s is about the middle, where the pointer was")
        app.xdotool("mousemove", (left + right) / 2, (top + bottom) / 2, "click", "--repeat", 2, "--delay", 60, 1)
        wait(lambda: shown(app, height) is None and shown(app, speed) is None, "a double click to show all")


def test_wheel_scrolls_a_page_of_graphs(display):
    """Where there are more than fit; there Ctrl zooms. Beside the canvas, where all fit, the wheel alone does."""
    graphs = [{"block": "Ball", "quantity": quantity} for quantity in ("y", "vy", "ay", "x", "vx", "ax", "speed", "y", "vy")]
    with App(display, thrown(*graphs)) as app:
        run(app)
        app.click("Graphs", role="tab")
        app.find("button", "Add Graph")
        wait(lambda: app.settled(graph(app, "^Graph of .*Y Position"))[3] > 150, "the graphs of the page")
        first = graph(app, "^Graph of .*Y Position")
        left, top, right, bottom = plot_box(app, first)
        before = app.settled(first)
        app.xdotool("mousemove", (left + right) / 2, (top + bottom) / 2, "keydown", "ctrl", "click", 4, "keyup", "ctrl")
        wait(lambda: shown(app, first), "it to be zoomed with Ctrl")
        check_equal(app.settled(first), before, "its place")
        zoomed = shown(app, first)
        upper = (left, top, right, bottom)
        picture = app.picture().cut(upper)
        app.xdotool("mousemove", (left + right) / 2, (top + bottom) / 2, "click", 5)
        wait(lambda: app.picture().cut(upper) != picture, "the page to scroll")
        check_equal(shown(app, first), zoomed, "what it shows, which the wheel alone does not change")


def test_box_zooms(display):
    """A box over the middle third; one without height is of the time alone, as its height tells nothing here."""
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        node = graph(app)
        left, top, right, bottom = plot_box(app, node)
        third = (right - left) / 3
        app.drag_pixels((left + third, top + 20), (left + 2 * third, bottom - 20))
        wait(lambda: shown(app, node), "it to be zoomed")
        first, last = shown(app, node)
        check(0.6 < first < 1.1 and 1.3 < last < 1.9, f"{first} to {last} s is about the middle third")
        app.drag_pixels((left + third, bottom - 30), (left + 2 * third, bottom - 30), button=2)
        wait(lambda: shown(app, node)[0] < first - 0.1, "the middle button to take the curve along")
        check_close(shown(app, node)[1] - shown(app, node)[0], last - first, 1e-3, "length of time (s)")


def test_click_sets_the_time(display):
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        left, top, right, bottom = plot_box(app, graph(app))
        app._click_at(left + (right - left) / 2, bottom - 10)
        wait(lambda: 0.9 < app.time() < 1.6, "a time about the middle")


def test_keys(display):
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        node = graph(app)
        app.seek(0.1)
        focus(app, node)
        app.press("n")
        wait(lambda: app.time() == 1, "the highest point")
        wait(lambda: "y = 4.905 m" in node.refreshed().description, "its height to be told")
        app.press("c")
        app.press("n")
        wait(lambda: app.time() == 2, "the next zero")
        app.press("c")
        wait(lambda: "Δt = 1 s, Δy = −4.905 m, 1/Δt = 1 Hz" in node.refreshed().description, "what is measured")
        app.press("shift+c")
        wait(lambda: "Δt" not in node.refreshed().description, "the cursors to go")
        app.press("p")
        wait(lambda: app.time() == 1, "the one before")
        app.press("x")
        wait(lambda: shown(app, node), "it to be zoomed by key")
        first, last = shown(app, node)
        check_close(last - first, 2.5 / 1.5, 1e-3, "length of time (s)")
        app.press("ctrl+Right")
        wait(lambda: shown(app, node)[0] > first, "it to be moved on by key")
        check_close(shown(app, node)[0] - first, 0.2 * (last - first), 1e-3, "by a fifth (s)")
        app.press("0")
        wait(lambda: shown(app, node) is None, "all of it")


def test_two_cursors_by_mouse(display):
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        node = graph(app)
        left, top, right, bottom = plot_box(app, node)
        for share in (0.3, 0.6):
            app._click_at(left + share * (right - left), bottom - 15, keys=("ctrl",))
        text = wait(lambda: re.search(r"Δt = (\S+) s, Δy = (\S+) m, 1/Δt = (\S+) Hz", node.refreshed().description),
                    "two cursors")
        interval, _, rate = (float(number.replace("−", "-")) for number in text.groups())
        check(0.5 < interval < 1.0, f"{interval} s is about 0.3 of 2.5 s")
        check_close(rate, 1 / interval, 1e-4 * rate, "1/Δt (Hz)")


def test_cursor_takes_what_is_pointed_at(display):
    """Near the top of one of two curves it is that; elsewhere the curve that is nearer, whichever is the first."""
    graphs = {"curves": [{"block": "Ball", "quantity": "y"}, {"expression": "{Ball.y} - 10", "unit": "m", "title": "lower"}]}
    with App(display, thrown(graphs)) as app:
        run(app)
        node = graph(app)
        left, top, right, bottom = plot_box(app, node)

        def cursor(x, y):
            before = node.refreshed().description
            app._click_at(x, y, keys=("ctrl",))
            wait(lambda: node.refreshed().description != before, "a cursor")
            found = re.search(r"A: t = (\S+) s, y = (\S+) m", node.description)
            app.press("shift+c")
            wait(lambda: "A: " not in node.refreshed().description, "it to go")
            return tuple(float(number.replace("−", "-")) for number in found.groups())

        x = left + 0.7 * (right - left)
        time, height = cursor(x, bottom - 15)
        check_close(height, 9.81 * time - 9.81 / 2 * time ** 2 - 10, 2e-3, "the lower curve (m)")
        start, _ = cursor(left + 0.2 * (right - left), bottom - 15)
        summit = x + (1 - time) * 0.5 * (right - left) / (time - start)
        found = [cursor(summit + aside, top + down) for aside in (-9, 9) for down in (-2, 5, 12)]
        check(found.count((1, 4.905)) >= 2, f"{found}: the top where it is pointed at, a little beside it")


def test_cursor_is_what_the_pointer_reads(display):
    """Beside a steep part of the curve: where the pointer reads it, and not above or below the pointer."""
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        node = graph(app)
        left, top, right, bottom = box = plot_box(app, node)
        curve = wait(lambda: colours.places(app.picture(), box, colours.CURVE, least=0.95, most=1.05), "the curve")
        highest, lowest = min(y for _, y in curve), max(y for _, y in curve)
        middle = (left + right) / 2  # 1.25 s: on from there it falls
        flank = min((place for place in curve if place[0] > middle),
                    key=lambda place: abs(place[1] - (highest + 0.5 * (lowest - highest))))

        def cursor(x, y):
            app._click_at(x, y, keys=("ctrl",))
            found = wait(lambda: re.search(r"A: t = (\S+) s, y = (\S+) m", node.refreshed().description), "a cursor")
            app.press("shift+c")
            wait(lambda: "A: " not in node.refreshed().description, "it to go")
            return tuple(float(number.replace("−", "-")) for number in found.groups())

        beside = flank[0] - 14
        above, later = cursor(beside, bottom - 4)[0], cursor(beside + 40, top + 4)[0]  # far from the curve
        time, height = cursor(beside, flank[1])
        check_close(height, 9.81 * time - 9.81 / 2 * time ** 2, 1e-3, "the curve (m)")
        pixels = 40 * (time - above) / (later - above)
        check(2 < pixels < 14, f"{pixels} pixels to the right of the pointer, as far as the curve is 14 to its right")


def test_statistics(display):
    """Of the throw: the mean height of the first 2 s is 2/3 of the greatest; over all 2.5 s that of the parabola there."""
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        focus(app, graph(app))
        app.press("s")
        mean = 9.81 * 2.5 / 2 - 9.81 * 2.5 ** 2 / 6
        text = wait(lambda: app.look("label", re.compile("Mean = ")), "the statistics").name
        check_close(float(re.search(r"Mean = (\S+) m", text).group(1)), mean, 1e-4, "mean (m)")
        check_close(float(re.search(r"Greatest = (\S+) m", text).group(1)), 4.905, 1e-4, "greatest (m)")
        app.click("Close", inside=app.find(None, "Statistics"))


def test_statistics_between_cursors(display):
    """From the top to the ground, with 2/3 of the greatest height in the mean."""
    with App(display, thrown(HEIGHT)) as app:
        run(app)
        app.seek(0.1)
        focus(app, graph(app))
        for time in (1, 2):
            app.press("n")
            wait(lambda: app.time() == time, "the top, and then the ground")
            app.press("c")
        wait(lambda: "Δt = 1 s" in graph(app).refreshed().description, "cursors at the top and at the ground")
        app.press("s")
        text = wait(lambda: app.look("label", re.compile("between cursors A and B, from 1 to 2 s")), "the part").name
        check_close(float(re.search(r"Mean = (\S+) m", text).group(1)), 2 / 3 * 4.905, 1e-4, "mean of the part (m)")
        app.click("Close", inside=app.find(None, "Statistics"))


if __name__ == "__main__":
    main()
