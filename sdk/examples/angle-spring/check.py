"""The angle spring against closed forms. Run by `meson test`."""
import csv
import io
import json
import math
import os
import subprocess
import unittest

TINKER, PLUGINS = os.environ["TINKER"], os.environ["PLUGINS"]


def tinker(verb, scene, *options):
    command = [TINKER, verb, "-", "--plugins", PLUGINS, *options]
    return subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False)


def run(scene, columns, **options):
    """The rows of the record, as {time: {column: value}}."""
    done = tinker("run", scene, "--columns", columns, "--csv", "-",
                  *(text for key, value in options.items() for text in ("--" + key, value)))
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    rows = csv.DictReader(io.StringIO(done.stdout))
    table = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in rows]
    return {row["time"]: row for row in table}


def mass(name, kilograms, place, velocity=(0, 0)):
    return {"type": "mass", "name": name, "mass": kilograms, "position": list(place), "velocity": list(velocity)}


def spring(ends, **properties):
    return {"type": "angle-spring", "name": "Spring", "ends": ends, **properties}


def arm(rest_angle, turn, stiffness=2.0):
    """0.5 kg on an arm of 0.6 m, let go when turned this far from rest."""
    angle = rest_angle + turn
    return {"tinker": 1, "run": {"duration": 5, "interval": 0.05, "tolerance": 1e-12}, "blocks": [
        {"type": "support", "name": "Frame", "solid": False},
        mass("Tip", 0.5, [0.6 * math.cos(angle), 0.6 * math.sin(angle)]),
        {"type": "rod", "ends": ["Frame", "Tip"]},
        spring([{"block": "Frame", "at": [1, 0]}, "Frame", "Tip"], stiffness=stiffness, rest_angle=rest_angle)]}


class Arm(unittest.TestCase):
    RATE = math.sqrt(2.0 / (0.5 * 0.6**2))

    def test_scene(self):
        with open("angle-spring.tinker.json", encoding="utf-8") as file:
            record = run(json.load(file), "Spring.angle", tolerance="1e-12")
        for t, row in record.items():
            self.assertAlmostEqual(row["Spring.angle"], math.pi + 2.8 * math.cos(self.RATE * t), delta=1e-9)

    def test_any_angle(self):
        """m l^2 turn'' = -k turn exactly, so turn = A cos(w t) for small and large A, wherever rest is: the angle runs over
        180 deg and over 0 without a jump."""
        for rest_angle in (0.0, 1.0, math.pi, -2.5, 2 * math.pi):
            for turn in (1e-3, 1.5, 2.9):
                for t, row in run(arm(rest_angle, turn), "Spring.angle,Spring.moment,Spring.energy").items():
                    expected = turn * math.cos(self.RATE * t)
                    self.assertAlmostEqual(row["Spring.angle"], rest_angle + expected, delta=2e-9)
                    self.assertAlmostEqual(row["Spring.moment"], 2 * expected, delta=4e-9)
                    self.assertAlmostEqual(row["Spring.energy"], expected**2, delta=2e-8)

    def test_too_far(self):
        for turn in (math.radians(171), math.pi):
            done = tinker("run", arm(0.0, turn))
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("Spring", done.stderr)
            self.assertIn("more than 170 deg from the rest angle", done.stderr)

    def test_runs_into_its_range(self):
        """Thrown fast enough, the arm reaches 170 deg: the run ends there, with what was recorded."""
        fast = arm(0.0, 0.0)
        fast["blocks"][1]["velocity"] = [0, 0.6 * self.RATE * 4]
        done = tinker("run", fast, "--csv", "-")
        self.assertEqual(done.returncode, 1)
        self.assertIn("more than 170 deg from the rest angle", done.stderr)
        rows = [line for line in done.stdout.splitlines() if line and line[0].isdigit()]
        reached = math.asin(math.radians(170) / 4) / self.RATE
        self.assertAlmostEqual(float(rows[-1].split(",")[0]), reached, delta=0.05)

    def test_no_arm(self):
        done = tinker("run", {"tinker": 1, "blocks": [mass("A", 1, [0, 0]), mass("B", 1, [0, 0]), mass("C", 1, [1, 0]),
                                                      spring(["A", "B", "C"])]})
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("an arm has no length", done.stderr)


class Molecule(unittest.TestCase):
    """Three free masses in a row, joined by rods, with the spring at the middle one."""

    def scene(self, bend):
        places = [[-math.cos(bend) * 0.5, math.sin(bend) * 0.5], [0, 0], [math.cos(bend) * 0.5, math.sin(bend) * 0.5]]
        return {"tinker": 1, "run": {"duration": 4, "interval": 0.05, "tolerance": 1e-12}, "blocks": [
            mass("A", 1, places[0], [0.3, 0.1]), mass("B", 3, places[1], [0.3, 0.1]), mass("C", 1, places[2], [0.3, 0.1]),
            {"type": "rod", "ends": ["A", "B"]}, {"type": "rod", "ends": ["B", "C"]},
            spring(["A", "B", "C"], stiffness=2, rest_angle="180 deg")]}

    def test_frequency(self):
        """Bending of a linear molecule, w^2 = (k / l^2) (2 / m + 4 / M): Landau, Lifshitz, Mechanics, 24, problem 1."""
        done = tinker("modes", self.scene(0.0), "--json", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        rates = [mode["angular_frequency"] for mode in json.loads(done.stdout)["modes"]]
        self.assertAlmostEqual(max(rates), math.sqrt(2 / 0.5**2 * (2 / 1 + 4 / 3)), delta=1e-6)

    def test_conserves(self):
        """Large bends: momentum, angular momentum about the moving centre and energy stay."""
        masses = {"A": 1.0, "B": 3.0, "C": 1.0}
        columns = ",".join(f"{n}.{c}" for n in masses for c in ("x", "y", "vx", "vy"))
        start = None
        for row in run(self.scene(0.7), columns + ",Spring.energy").values():
            px = sum(m * row[n + ".vx"] for n, m in masses.items())
            py = sum(m * row[n + ".vy"] for n, m in masses.items())
            turn = sum(m * (row[n + ".x"] * row[n + ".vy"] - row[n + ".y"] * row[n + ".vx"]) for n, m in masses.items())
            energy = row["Spring.energy"] + sum(m / 2 * (row[n + ".vx"] ** 2 + row[n + ".vy"] ** 2)
                                                for n, m in masses.items())
            now = (px, py, turn, energy)
            start = start or now
            for value, first in zip(now, start):
                self.assertAlmostEqual(value, first, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
