#!/usr/bin/python3
"""The spring-mass system of the tutorial, from an empty canvas, by mouse and keyboard alone: what a student does in the
first minutes. The run is compared with the closed form y = y0 - (m g / k) (1 - cos(w t)), w = sqrt(k / m)."""
import csv
import math

from harness import App, check, check_close, check_equal, main, wait

MOST_ACTIONS = 12  # clicks, keys and names that are typed


def test_spring_mass_from_nothing(display):
    with App(display) as app:
        app.click("Support")
        app.click("Mass")
        app.click_block("Support 0", keys=["shift"])
        app.click("Spring")
        app.click_block("Mass 0", button=3)
        app.choose("Add Graph", "Y Position")
        app.click("Play")
        wait(lambda: app.time() > 1.5, "some of the motion")
        app.right_click_graph()
        app.choose("Export Values To File…")
        file = app.home / "motion.csv"
        app.save_dialog("Export Values To File", file)
        wait(file.exists, "the file")
        check(app.actions_taken <= MOST_ACTIONS, f"it took {app.actions_taken} actions")
        with open(file, newline="") as opened:
            head, *rows = csv.reader(opened)
        check_equal(head, ["Time", "Y Position"], "head of the table")
        start = float(rows[0][1])
        omega, drop = math.sqrt(25 / 1), 1 * 9.81 / 25
        check(len(rows) > 50, f"{len(rows)} rows")
        for time, y in rows:
            check_close(float(y), start - drop * (1 - math.cos(omega * float(time))), 1e-6, f"y at {time} s")


if __name__ == "__main__":
    main()
