"""Random mechanisms of bodies that turn, run by the program and, from the same numbers, by SciPy.

    random_mechanisms.py TINKER [--scenes N] [--first SEED] [--keep FOLDER]

A scene has one to four bars, discs and boxes, joints between them and a fixed support (pins, slots, sliders, rods, gears), and springs,
dampers and torques. The equations here are written in plain coordinates (x, y, angle) with multipliers for the second derivatives
of the joints, and solved by DOP853 to 1e-11; the program is asked for an accuracy of 1e-8. After a second both must have
every body at the same place and angle to 1e-6. Prints TAP; a scene that fails is kept in FOLDER.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np
from scipy.integrate import solve_ivp

GRAVITY = 9.81
AGREE = 1e-6


def rotation(angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]])


class Mechanism:
    """A random scene: its blocks as the program reads them, and what the equations here need."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.blocks = [{"type": "support", "name": "S", "position": [0, 0], "solid": False}]
        self.falls = self.random.random() < 0.8
        if self.falls:
            self.blocks.append({"type": "gravity"})
        self.mass, self.start, self.joints, self.forces = [], [], [], []
        for number in range(self.random.randint(1, 4)):
            self.add_body(number)
        for number in range(self.bodies):
            if self.random.random() >= 0.25:
                self.add_joint(number)
        if self.bodies >= 2 and self.random.random() < 0.3:
            self.add_gear()
        for _ in range(self.random.randint(1, 4)):
            self.add_force()

    @property
    def bodies(self):
        return len(self.start) // 3

    def add_body(self, number):
        draw = self.random.uniform
        kind = self.random.choice(["bar", "bar", "disc", "box"])
        mass = round(draw(0.5, 3), 2)
        place, angle = [round(draw(-2, 2), 3), round(draw(-2, 2), 3)], round(draw(-3, 3), 3)
        sizes = {"bar": {"length": round(draw(0.5, 2), 2)}, "disc": {"radius": round(draw(0.2, 0.6), 2)},
                 "box": {"width": round(draw(0.3, 1), 2), "height": round(draw(0.3, 1), 2)}}[kind]
        inertia = {"bar": lambda length: length ** 2 / 12, "disc": lambda radius: radius ** 2 / 2,
                   "box": lambda width, height: (width ** 2 + height ** 2) / 12}[kind](**sizes)
        self.mass += [mass, mass, mass * inertia]
        self.start += place + [angle]
        self.blocks.append({"type": kind, "name": f"B{number}", "mass": mass, "position": place, "orientation": angle,
                            "solid": False, **sizes})

    def local(self, body, place):
        """A place of the start in a body's own axes; body -1 is the support at the origin."""
        if body < 0:
            return [float(place[0]), float(place[1])]
        x, y, angle = self.start[3 * body:3 * body + 3]
        return [float(v) for v in rotation(-angle) @ (np.array(place) - [x, y])]

    def beside(self, body):
        """A place near a body."""
        x, y = self.start[3 * body:3 * body + 2]
        return [x + self.random.uniform(-0.5, 0.5), y + self.random.uniform(-0.5, 0.5)]

    @staticmethod
    def end(body, at):
        return {"block": Mechanism.name(body), "at": at}

    @staticmethod
    def name(body):
        return "S" if body < 0 else f"B{body}"

    def add_joint(self, body):
        other = self.random.choice([-1] + list(range(body)))
        kind = self.random.choice(["pin", "pin", "slot", "slider", "rod"])
        place = self.beside(body)
        far = place
        values = {}
        if kind == "rod":
            far = [place[0] + self.random.uniform(0.3, 1.5), place[1] + self.random.uniform(-1, 1)]
        elif kind != "pin":
            values = {"angle": round(self.random.uniform(-1.5, 1.5), 3)}
        a, b = self.local(other, far), self.local(body, place)
        self.blocks.append({"type": kind, "ends": [self.end(other, a), self.end(body, b)], **values})
        self.joints.append((kind, other, body, a, b, values.get("angle")))

    def add_gear(self):
        i, j = self.random.sample(range(self.bodies), 2)
        ratio, internal = round(self.random.uniform(0.5, 2), 2), self.random.random() < 0.5
        self.blocks.append({"type": "gear", "ends": [f"B{i}", f"B{j}"], "ratio": ratio, "internal": internal})
        self.joints.append(("gear", i, j, -ratio if internal else ratio, None, None))

    def add_force(self):
        draw = self.random.uniform
        body = self.random.randrange(self.bodies)
        other = self.random.choice([-1] + [k for k in range(self.bodies) if k != body])
        kind = self.random.choice(["spring", "damper", "torsional-spring", "torsional-damper", "torque"])
        values = {"spring": {"stiffness": round(draw(5, 60), 1), "rest_length": round(draw(0.5, 2), 2)},
                  "damper": {"damping": round(draw(0.1, 3), 1)},
                  "torsional-spring": {"stiffness": round(draw(0.5, 10), 1), "rest_angle": round(draw(-1, 1), 2)},
                  "torsional-damper": {"damping": round(draw(0.05, 0.5), 2)},
                  "torque": {"amplitude": round(draw(0.2, 2), 2), "frequency": round(draw(0, 2), 2),
                             "phase": round(draw(0, 6), 2)}}[kind]
        place = self.beside(body)
        far = [place[0] + draw(0.8, 2.5), place[1] + draw(-1, 1)]
        a, b = self.local(other, far), self.local(body, place)
        if kind in ("spring", "damper"):
            ends = [self.end(other, a), self.end(body, b)]
        elif kind == "torque":
            ends = [self.name(body)] + ([self.name(other)] if other >= 0 else [])
        else:
            ends = [self.name(other), self.name(body)]
        self.blocks.append({"type": kind, "ends": ends, **values})
        self.forces.append((kind, other, body, a, b, values))

    def scene(self):
        return {"tinker": 1, "run": {"duration": 1.0}, "blocks": self.blocks}


class Equations:
    """The accelerations of a mechanism."""

    def __init__(self, mechanism):
        self.m = mechanism
        self.n = 3 * mechanism.bodies
        self.mass = np.array(mechanism.mass)

    def point(self, q, v, body, at):
        """Place, velocity, their rows, and what the rows' own change adds to the acceleration, of a point of a body."""
        rows = np.zeros((2, self.n))
        if body < 0:
            return np.array(at), np.zeros(2), rows, np.zeros(2)
        k = 3 * body
        arm = rotation(q[k + 2]) @ np.array(at)
        rows[0, k] = rows[1, k + 1] = 1
        rows[:, k + 2] = -arm[1], arm[0]
        return q[k:k + 2] + arm, rows @ v, rows, -arm * v[k + 2] ** 2

    def turn(self, q, v, body):
        row = np.zeros(self.n)
        if body < 0:
            return 0.0, 0.0, row
        row[3 * body + 2] = 1
        return q[3 * body + 2], v[3 * body + 2], row

    def joint(self, q, v, kind, other, body, a, b, angle):
        """Rows G and g with G acceleration + g = 0."""
        if kind == "gear":
            return [self.turn(q, v, body)[2] + a * self.turn(q, v, other)[2]], [0.0]
        place_a, speed_a, rows_a, rest_a = self.point(q, v, other, a)
        place_b, speed_b, rows_b, rest_b = self.point(q, v, body, b)
        d, w, rows, rest = place_b - place_a, speed_b - speed_a, rows_b - rows_a, rest_b - rest_a
        if kind == "pin":
            return list(rows), list(rest)
        if kind == "rod":
            return [d @ rows], [w @ w + d @ rest]
        at, rate, row = self.turn(q, v, other)
        along, across = rotation(angle + at) @ [1, 0], rotation(angle + at) @ [0, 1]
        found = [across @ rows - (along @ d) * row], [across @ rest - 2 * rate * (along @ w) - rate ** 2 * (across @ d)]
        if kind == "slider":
            found[0].append(self.turn(q, v, body)[2] - row)
            found[1].append(0.0)
        return found

    def force(self, t, q, v, kind, other, body, a, b, values):
        """The generalised force of a connector."""
        if kind in ("spring", "damper"):
            place_a, speed_a, rows_a, _ = self.point(q, v, other, a)
            place_b, speed_b, rows_b, _ = self.point(q, v, body, b)
            d = place_b - place_a
            length = np.linalg.norm(d)
            along = d / length
            pull = (values["stiffness"] * (length - values["rest_length"]) if kind == "spring"
                    else values["damping"] * (along @ (speed_b - speed_a)))
            return -pull * (along @ (rows_b - rows_a))
        at_a, rate_a, row_a = self.turn(q, v, other)
        at_b, rate_b, row_b = self.turn(q, v, body)
        if kind == "torque":
            return values["amplitude"] * math.cos(values["frequency"] * t + values["phase"]) * (row_b - row_a)
        torque = (values["stiffness"] * (at_b - at_a - values["rest_angle"]) if kind == "torsional-spring"
                  else values["damping"] * (rate_b - rate_a))
        return -torque * (row_b - row_a)

    def __call__(self, t, state):
        q, v = state[:self.n], state[self.n:]
        force = np.zeros(self.n)
        if self.m.falls:
            force[1::3] -= GRAVITY * self.mass[1::3]
        for of in self.m.forces:
            force += self.force(t, q, v, *of)
        acceleration = force / self.mass
        rows, rest = [], []
        for of in self.m.joints:
            more = self.joint(q, v, *of)
            rows += more[0]
            rest += more[1]
        if rows:
            g = np.array(rows)
            # Redundant joints: any multipliers that solve the equations give the same motion.
            multipliers = np.linalg.lstsq((g / self.mass) @ g.T, -(np.array(rest) + g @ acceleration), rcond=1e-12)[0]
            acceleration = acceleration + (g.T @ multipliers) / self.mass
        return np.concatenate([v, acceleration])

    def end(self):
        start = np.concatenate([self.m.start, np.zeros(self.n)])
        found = solve_ivp(self, (0, 1), start, method="DOP853", rtol=1e-11, atol=1e-12)
        if not found.success:
            raise ArithmeticError(found.message)
        return found.y[:self.n, -1]


def run(program, mechanism, path):
    """Places and angles of the bodies after a second, by the program."""
    path.write_text(json.dumps(mechanism.scene()))
    columns = ",".join(f"B{k}.{what}" for k in range(mechanism.bodies) for what in ("x", "y", "angle"))
    done = subprocess.run([program, "run", path, "--accuracy", "1e-8", "--at", "1", "--columns", columns, "--csv", "-"],
                          capture_output=True, text=True, timeout=120, check=False)
    if done.returncode != 0:
        raise ArithmeticError(done.stderr.strip())
    return np.array([float(value) for value in done.stdout.strip().split("\n")[-1].split(",")[1:]])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="TINKER")
    parser.add_argument("--scenes", type=int, default=30)
    parser.add_argument("--first", type=int, default=0, metavar="SEED")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    options = parser.parse_args()
    failed = 0
    print(f"1..{options.scenes}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.scenes):
            seed = options.first + number
            mechanism = Mechanism(seed)
            path = pathlib.Path(folder) / f"mechanism-{seed}.tinker.json"
            try:
                off = np.abs(run(options.program, mechanism, path) - Equations(mechanism).end()).max()
                fine, note = off <= AGREE, f"off by {off:.1e}"
            except ArithmeticError as error:
                fine, note = False, str(error).replace("\n", " ")
            print(f"{'ok' if fine else 'not ok'} {number + 1} - mechanism {seed}: {note}", flush=True)
            if not fine:
                failed += 1
                if options.keep is not None:
                    (options.keep / path.name).write_text(path.read_text())
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
