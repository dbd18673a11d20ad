"""The pulley against closed forms. Run by `meson test`."""
import csv
import io
import json
import math
import os
import subprocess
import unittest

G = 9.81


def tinker(scene, *options):
    command = [os.environ["TINKER"], "run", "-", "--plugins", os.environ["PLUGINS"], *options]
    return subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False)


def run(scene, columns, **options):
    """The rows of the record, as {time: {column: value}}."""
    listed = [text for key, value in options.items() for text in ("--" + key, value)]
    done = tinker(scene, "--columns", columns, "--csv", "-", *listed)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    rows = csv.DictReader(io.StringIO(done.stdout))
    table = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in rows]
    return {row["time"]: row for row in table}


def gravity():
    return {"type": "gravity", "acceleration": G}


def beam(height=0):
    return {"type": "support", "name": "Beam", "position": [0, height], "solid": False}


def wheel(x):
    return {"block": "Beam", "at": [x, 0]}


def mass(name, kilograms, x, y, vy=0):
    return {"type": "mass", "name": name, "mass": kilograms, "position": [x, y], "velocity": [0, vy],
            "width": 0, "height": 0}


def rope(name, *ends, **properties):
    return {"type": "pulley", "name": name, "ends": list(ends), **properties}


def scene(*blocks, duration=1.5, **run_keys):
    return {"tinker": 1, "run": {"duration": duration, "interval": 0.05, **run_keys}, "blocks": list(blocks)}


class Taut(unittest.TestCase):
    def near(self, value, expected, scale=1.0):
        self.assertLessEqual(abs(value - expected), 1e-10 * scale, f"{value!r} instead of {expected!r}")

    def test_atwood(self):
        """a = g (m2 - m1) / (m1 + m2) and T = 2 g m1 m2 / (m1 + m2), from the first row on."""
        with open("pulley.tinker.json", encoding="utf-8") as file:
            atwood = json.load(file)
        a, tension = G * (3 - 2) / (3 + 2), 2 * G * 2 * 3 / (3 + 2)
        self.near(a, 1.962)
        self.near(tension, 23.544)
        for method in ("auto", "rk4", "verlet"):
            record = run(atwood, "Light.y,Heavy.y,Light.ay,Heavy.ay,Rope.tension,Rope.slack", method=method)
            self.assertEqual(len(record), 31)
            for t, row in record.items():
                self.near(row["Light.ay"], a)
                self.near(row["Heavy.ay"], -a)
                self.near(row["Rope.tension"], tension)
                self.near(row["Light.y"], 0.5 + a * t * t / 2)
                self.near(row["Heavy.y"], 3 - a * t * t / 2)
                self.near(row["Rope.slack"], 0)

    def test_movable_wheel(self):
        """2 a1 + a2 = 0: T = 3 g m1 m2 / (m1 + 4 m2) lifts the wheel twice."""
        m1, m2 = 5.0, 2.0
        tension = 3 * G * m1 * m2 / (m1 + 4 * m2)
        a1, a2 = 2 * tension / m1 - G, tension / m2 - G
        record = run(scene(gravity(), beam(), mass("Wheel", m1, 0, -2), mass("Load", m2, 1, -3),
                           rope("Rope", wheel(0), "Wheel", wheel(0), wheel(1), "Load")),
                     "Wheel.y,Load.y,Wheel.ay,Load.ay,Rope.tension")
        for t, row in record.items():
            self.near(row["Wheel.ay"], a1)
            self.near(row["Load.ay"], a2)
            self.near(row["Rope.tension"], tension)
            self.near(row["Wheel.y"], -2 + a1 * t * t / 2)
            self.near(row["Load.y"], -3 + a2 * t * t / 2, 10)

    def test_compound(self):
        """A rope over a wheel that hangs on a rope. With p of the wheel, 1/h = 1/b + 1/c:
        T2 = 2 h (g + aP), T1 = 2 T2 + p (g + aP) = P (g + aP), P = p + 4 h; so the wheel weighs P."""
        a, p, b, c = 3.0, 0.5, 1.0, 2.0
        h = b * c / (b + c)
        weighs = p + 4 * h
        up = G * (a - weighs) / (a + weighs)
        lower = 2 * h * (G + up)
        record = run(scene(gravity(), beam(), mass("A", a, -1, -4), mass("P", p, 0, -2), mass("B", b, 0, -4),
                           mass("C", c, 0, -5), rope("Upper", "A", wheel(-1), wheel(0), "P"),
                           rope("Lower", "B", "P", "C"), duration=0.5),
                     "A.ay,P.ay,B.ay,C.ay,Upper.tension,Lower.tension,P.y,B.y")
        for t, row in record.items():
            self.near(row["P.ay"], up)
            self.near(row["A.ay"], -up)
            self.near(row["B.ay"], lower / b - G)
            self.near(row["C.ay"], lower / c - G)
            self.near(row["Lower.tension"], lower)
            self.near(row["Upper.tension"], weighs * (G + up))
            self.near(row["P.y"], -2 + up * t * t / 2)
            self.near(row["B.y"], -4 + (lower / b - G) * t * t / 2)

    def test_moving_wheel(self):
        """A wheel that is lifted by s(t) lifts the other end of its rope by 2 s: T = m (g + 2 s'')."""
        lift = {"type": "support-motion", "ends": ["Hook"], "amplitude": 0.1, "frequency": 3, "waveform": "cosine",
                "angle": "90 deg"}
        hook = {"type": "support", "name": "Hook", "position": [0, 0], "solid": False}
        floor = {"type": "support", "name": "Floor", "position": [0, -2], "solid": False}
        record = run(scene(gravity(), hook, floor, lift, mass("Load", 2, 0, -1), rope("Rope", "Floor", "Hook", "Load")),
                     "Load.ay,Rope.tension")
        for t, row in record.items():
            s = -0.1 * 9 * math.cos(3 * t)
            self.near(row["Load.ay"], 2 * s, 10)
            self.near(row["Rope.tension"], 2 * (G + 2 * s), 10)


class Swinging(unittest.TestCase):
    """Atwood's machine whose lighter mass swings: with r, the length of its strand, and its angle from below,
    (M + m) r'' = m r angle'^2 + g (m cos(angle) - M),   r angle'' = -2 r' angle' - g sin(angle).
    For M = 3 m there is a second invariant beside the energy (N. Tufillaro, American Journal of Physics 54, 1986):
    r^2 angle' (r' cos(angle/2) - r angle'/2 sin(angle/2)) + g r^2 sin(angle/2) cos(angle/2)^2."""

    def test_swings(self):
        m, big, r, angle, dr, turning = 1.0, 3.0, 1.2, 1.0, 0.3, 0.8
        sine, cosine = math.sin(angle), math.cos(angle)
        bob = mass("Bob", m, 1 + r * sine, -r * cosine)
        bob["velocity"] = [dr * sine + r * turning * cosine, -dr * cosine + r * turning * sine]
        record = run(scene(gravity(), beam(), bob, mass("Weight", big, -1, -4, dr),
                           rope("Rope", "Bob", wheel(1), wheel(-1), "Weight"), duration=2, tolerance=1e-12),
                     "Bob.x,Bob.y,Bob.vx,Bob.vy,Weight.y,Weight.vy,Weight.ay,Rope.tension,Rope.slack")
        out = (m * r * turning**2 + G * (m * cosine - big)) / (m + big)
        self.assertAlmostEqual(record[0]["Weight.ay"], out, delta=1e-10)
        self.assertAlmostEqual(record[0]["Rope.tension"], big * (G + out), delta=1e-9)
        kept = []
        for row in record.values():
            x, y, vx, vy = row["Bob.x"] - 1, row["Bob.y"], row["Bob.vx"], row["Bob.vy"]
            r, now = math.hypot(x, y), math.atan2(x, -y)
            angle = now + 2 * math.pi * round((angle - now) / (2 * math.pi))  # it goes over the top
            dr, turning = (x * vx + y * vy) / r, (x * vy - y * vx) / (r * r)
            self.assertAlmostEqual(row["Rope.slack"], 0, delta=1e-12)
            energy = m / 2 * (vx**2 + vy**2) + big / 2 * row["Weight.vy"] ** 2 + G * (m * y + big * row["Weight.y"])
            s, c = math.sin(angle / 2), math.cos(angle / 2)
            kept.append((energy, r * r * turning * (dr * c - r * turning / 2 * s) + G * r * r * s * c * c))
        self.assertGreater(max(row["Bob.x"] for row in record.values()) - min(row["Bob.x"] for row in record.values()), 1)
        for energy, second in kept:
            self.assertAlmostEqual(energy, kept[0][0], delta=1e-8)
            self.assertAlmostEqual(second, kept[0][1], delta=1e-8)


class Slack(unittest.TestCase):
    def events(self, described):
        done = tinker(described, "--json", "-", "--csv", os.devnull)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_slack_and_taut_again(self):
        """Atwood's masses, the light one thrown up with v: both fall freely, the rope is taut again after v / g, where the
        light one is at rest and the other as fast as it was: the impulse v m1 m2 / (m1 + m2) makes them equally fast."""
        m1, m2, v = 2.0, 3.0, 4.0
        a, after = G * (m2 - m1) / (m1 + m2), v * m2 / (m1 + m2)
        thrown = scene(gravity(), beam(), mass("Light", m1, -1, -3, v), mass("Heavy", m2, 1, -2),
                       rope("Rope", "Light", wheel(-1), wheel(1), "Heavy"), duration=0.8)
        jerk = v / G
        for t, row in run(thrown, "Light.y,Light.vy,Heavy.vy,Rope.tension,Rope.slack").items():
            free = t < jerk
            self.assertAlmostEqual(row["Light.vy"], v - G * t if free else after + a * (t - jerk), delta=1e-9)
            self.assertAlmostEqual(row["Heavy.vy"], -G * t if free else -after - a * (t - jerk), delta=1e-9)
            self.assertAlmostEqual(row["Rope.tension"], 0 if free else 2 * G * m1 * m2 / (m1 + m2), delta=1e-9)
            self.assertAlmostEqual(row["Rope.slack"], v * t - G * t * t if free else 0, delta=1e-9)
        summary = self.events(thrown)
        taut = [event for event in summary["events"] if event["kind"] == "taut"]
        self.assertEqual(len(taut), 1)
        self.assertAlmostEqual(taut[0]["time"], jerk, delta=1e-10)
        taken = -summary["energy"]["contacts"]
        self.assertAlmostEqual(taken, v * v * m1 * m2 / (m1 + m2) / 2, delta=1e-8)

    def test_shorter_path(self):
        """A rope that is too long at the start lets both fall until its path is as long as it is."""
        done = run(scene(gravity(), beam(), mass("A", 1, -1, -1), mass("B", 1, 1, -1),
                         rope("Rope", "A", wheel(-1), wheel(1), "B", length=5), duration=1), "A.y,B.y,Rope.tension")
        last = done[1.0]
        self.assertAlmostEqual(last["A.y"], -1.5, delta=1e-10)
        self.assertAlmostEqual(last["B.y"], -1.5, delta=1e-10)
        self.assertAlmostEqual(last["Rope.tension"], G, delta=1e-10)

    def test_runs_into_a_wheel(self):
        """The light one is pulled into its wheel after sqrt(2 h / a): by then the run ends, and says why."""
        described = scene(gravity(), beam(), mass("Light", 2, -1, -2), mass("Heavy", 3, 1, -2),
                          rope("Rope", "Light", wheel(-1), wheel(1), "Heavy"), duration=3)
        end = math.sqrt(2 * 2 / (G / 5))
        for options in ((), ("--method", "rk4", "--step", "0.001")):
            done = tinker(described, "--csv", "-", *options)
            self.assertEqual(done.returncode, 1)
            self.assertIn("Rope: its constraint", done.stderr)
            self.assertIn("has run into a wheel", done.stderr)
            rows = [line for line in done.stdout.splitlines() if line[:1].isdigit()]
            self.assertAlmostEqual(float(rows[-1].split(",")[0]), end, delta=0.05)

    def test_too_short(self):
        """A rope that is shorter than its path is refused, with both lengths."""
        done = tinker(scene(beam(), mass("A", 1, -1, -1), mass("B", 1, 1, -1),
                            rope("Rope", "A", wheel(-1), wheel(1), "B", length=3.5)))
        self.assertEqual(done.returncode, 3)
        self.assertIn("Rope: its length is 3.5 m, but the path through its ends is 4 m long", done.stderr)


if __name__ == "__main__":
    unittest.main()
