# SciPy's solvers on the scenes of bench-precision: peer-scipy.py SCENE prints one JSON object a line. What has no closed form
# is judged by who reads: the state at the end is printed. Without SciPy the status is 3.
import json
import sys
import time
from math import cos, pi, sin

try:
    import numpy as np
    from scipy.integrate import solve_ivp
    from scipy.linalg import expm
except ImportError:
    sys.exit(3)

GRAVITY = 9.81


def timed(solve, most=5):
    """Seconds, middle and least, and what was solved."""
    times = []
    while len(times) < most and sum(times) < 1.0:
        started = time.process_time()
        solved = solve()
        times.append(time.process_time() - started)
    return sorted(times)[len(times) // 2], min(times), solved


def show(scene, form, method, tolerance, median, least, **outcome):
    row = dict(scene=scene, form=form, method=method, tolerance=tolerance, median=median, least=least, **outcome)
    print(json.dumps(row), flush=True)


def oscillator(t, y):
    return [y[1], -25 * y[0] - 0.4 * y[1]]


def oscillator_truth(t):
    decay = 0.2
    frequency = np.sqrt(25 - decay * decay)
    return np.exp(-decay * t) * (np.cos(frequency * t) + decay / frequency * np.sin(frequency * t))


def pendulum(t, y):
    x1, y1, x2, y2, u1, v1, u2, v2 = y
    rx, ry, wx, wy = x2 - x1, y2 - y1, u2 - u1, v2 - v1
    a, b, c = x1 * x1 + y1 * y1, x1 * rx + y1 * ry, 2 * (rx * rx + ry * ry)
    first, second = GRAVITY * y1 - (u1 * u1 + v1 * v1), -(wx * wx + wy * wy)
    inverse = 1 / (a * c - b * b)
    l1, l2 = (c * first + b * second) * inverse, (a * second + b * first) * inverse
    return [u1, v1, u2, v2, l1 * x1 - l2 * rx, l1 * y1 - l2 * ry - GRAVITY, l2 * rx, l2 * ry - GRAVITY]


def angles(t, y):
    difference = y[0] - y[1]
    s, c = sin(difference), cos(difference)
    first = -s * y[3] ** 2 - 2 * GRAVITY * sin(y[0])
    second = s * y[2] ** 2 - GRAVITY * sin(y[1])
    inverse = 1 / (2 - c * c)
    return [y[2], y[3], (first - c * second) * inverse, (2 * second - c * first) * inverse]


def smooth(scene, form, rates, duration, start):
    for method in ["DOP853", "RK45", "LSODA", "Radau"]:
        for tolerance in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11]:
            if method == "Radau" and tolerance < 1e-6:
                continue
            median, least, solved = timed(
                lambda: solve_ivp(rates, (0, duration), start, method=method, rtol=tolerance, atol=tolerance), 3)
            if scene == "S1":
                outcome = dict(error=float(np.max(np.abs(solved.y[0] - oscillator_truth(solved.t)))))
            else:
                outcome = dict(end=solved.y[:, -1].tolist())
            show(scene, form, method, tolerance, median, least, **outcome)


def chain():
    n = 50
    k = np.array([1e2, 1e8] * (n // 2))
    c = 0.02 * np.sqrt(k)

    def tridiagonal(of):
        return np.diag(of + np.append(of[1:], 0)) - np.diag(of[1:], 1) - np.diag(of[1:], -1)

    order = np.arange(2 * n).reshape(2, n).T.ravel()  # x and v in turns: a band
    halves = np.block([[np.zeros((n, n)), np.eye(n)], [-tridiagonal(k), -tridiagonal(c)]])
    matrix = halves[np.ix_(order, order)]
    start = np.zeros(2 * n)
    start[0::2] = [(i // 2 + 1) / 25 for i in range(n)]
    median, least, end = timed(lambda: expm(10 * matrix) @ start)
    show("S6", "Cartesian", "expm", 0, median, least, end=end.tolist())
    # BDF and LSODA are no match: 22 s and 4 s at the loosest of these tolerances
    for tolerance in [1e-3, 1e-4, 1e-5]:
        median, least, solved = timed(
            lambda: solve_ivp(lambda t, y: matrix @ y, (0, 10), start, method="Radau", rtol=tolerance,
                              atol=0.01 * tolerance, jac=matrix), 3)
        show("S6", "Cartesian", "Radau", tolerance, median, least, end=solved.y[:, -1].tolist())


scene = sys.argv[1]
if scene == "S1":
    smooth("S1", "Cartesian", oscillator, 100, [1, 0])
elif scene == "S2":
    smooth("S2", "Cartesian", pendulum, 5, [1, 0, 2, 0, 0, 0, 0, 0])
    smooth("S2", "angles", angles, 5, [pi / 2, pi / 2, 0, 0])
elif scene == "S6":
    chain()
