"""Writes kalman.json: steady and first gains of two Kalman filters and two observers by poles, with 30 digits.

Independent of the generator: noise over a sample by Gauss-Legendre quadrature, the steady gain by the covariance
recursion run until it stands still, both by mpmath with 80 digits; poles by comparing the characteristic polynomial,
a linear system. scipy's solvers (solve_discrete_are, place_poles) must agree to what doubles leave.
Run it in this folder: needs mpmath, numpy, scipy.
"""
import json
import numpy as np
from mpmath import cos, diag, exp, expm, eye, fabs, lu_solve, matrix, mp, mpf, nstr, quad, sin, zeros
from scipy.linalg import solve_discrete_are
from scipy.signal import place_poles

mp.dps = 80


def entries(m):
    return [[nstr(m[i, j], 30) for j in range(m.cols)] for i in range(m.rows)]


def numpy(m):
    return np.array([[float(m[i, j]) for j in range(m.cols)] for i in range(m.rows)])


def over_a_sample(a, density, h):
    n = a.rows
    def entry(i, j):
        def kernel(s):
            e = expm(a * s, method="taylor")
            return (e * density * e.T)[i, j]
        return quad(kernel, [0, h])
    q = zeros(n, n)
    for i in range(n):
        for j in range(i, n):
            q[i, j] = q[j, i] = entry(i, j)
    return q


def call(phi, c, q, r, p):
    p = phi * p * phi.T + q
    k = p * c.T * (c * p * c.T + r) ** -1
    p = p - k * c * p
    return k, (p + p.T) / 2


def kalman(phi, c, q, r, start, first):
    p, gains = start, []
    for _ in range(first):
        k, p = call(phi, c, q, r, p)
        gains.append(k)
    while True:
        last, (k, p) = k, call(phi, c, q, r, p)
        if max(fabs(x) for x in k - last) < mpf(10) ** -45:
            break
    x = solve_discrete_are(numpy(phi).T, numpy(c).T, numpy(q), numpy(r))
    other = x @ numpy(c).T @ np.linalg.inv(numpy(c) @ x @ numpy(c).T + numpy(r))
    off = np.abs(other - numpy(k)).max() / np.abs(other).max()
    print("scipy is off by", off)
    assert off < 1e-8
    return {"steady": entries(k), "first": [entries(g) for g in gains]}


def characteristic(m):
    """Highest power first, by Faddeev and LeVerrier."""
    n, b, c = m.rows, eye(m.rows), [mpf(1)]
    for k in range(1, n + 1):
        b = m * b
        c.append(-sum(b[i, i] for i in range(n)) / k)
        b = b + c[-1] * eye(n)
    return c


def poles(phi, c, wanted, roots):
    """K is affine in the coefficients of (I - K C) Phi: n + 1 evaluations give the system."""
    n = phi.rows
    base = characteristic(phi)[1:]
    columns = zeros(n, n)
    for j in range(n):
        k = zeros(n, 1)
        k[j] = 1
        moved = characteristic(phi - k * c * phi)[1:]
        for i in range(n):
            columns[i, j] = moved[i] - base[i]
    k = lu_solve(columns, matrix([wanted[i + 1] - base[i] for i in range(n)]))
    off = characteristic(phi - k * c * phi)
    assert max(fabs(a - b) for a, b in zip(off, wanted)) < mpf(10) ** -60
    placed = place_poles(numpy(phi).T, (numpy(c) @ numpy(phi)).T, np.array([complex(r) for r in roots]))
    print("place_poles is off by", np.abs(placed.gain_matrix[0] - numpy(k)[:, 0]).max() / np.abs(numpy(k)).max())
    return {"gain": [nstr(x, 30) for x in k]}


def product(roots):
    c = [mpf(1)]
    for r in roots:
        c = [(c[i] if i < len(c) else 0) - (r * c[i - 1] if i else 0) for i in range(len(c) + 1)]
    return [x.real if hasattr(x, "real") else x for x in c]


# specs/two_mass_kalman.toml: motor and load on an elastic shaft, both angles measured.
stiffness, damping, motor, load = mpf(400), mpf("0.2"), mpf("0.01"), mpf("0.05")
a = matrix([
    [0, 0, 1, 0], [0, 0, 0, 1],
    [-stiffness / motor, stiffness / motor, -damping / motor, damping / motor],
    [stiffness / load, -stiffness / load, damping / load, -damping / load],
])
h = mpf("5e-4")
phi = expm(a * h, method="taylor")
c = matrix([[1, 0, 0, 0], [0, 1, 0, 0]])
q = over_a_sample(a, diag([0, 0, mpf(4), mpf("0.5")]), h)
r = diag([mpf("1e-12"), mpf("2e-11")]) / h
start = diag([r[0, 0], r[1, 1], mpf(10) ** 4, mpf(10) ** 4])
two_mass = kalman(phi, c, q, r, start, 8)

# The load's angle alone; given as covariances per sample.
one = kalman(phi, c[1, :], diag([mpf("1e-12"), mpf("1e-12"), mpf("1e-4"), mpf("1e-5")]), matrix([[mpf("1e-8")]]),
             diag([mpf("0.25"), mpf("1e-8"), mpf(100), mpf(100)]), 8)

# The same by poles, rad/s.
slow = [mp.mpc(-200, 150), mp.mpc(-200, -150), mpf(-300), mpf(-120)]
roots = [exp(s * h) for s in slow]
load_poles = poles(phi, c[1, :], product(roots), roots)

# The inverted pendulum of specs/pendulum.toml without its sine, sampled at 1 kHz.
a2 = matrix([[0, 1], [0, mpf("-0.067227")]])
phi2 = expm(a2 * mpf("1e-3"), method="taylor")
roots2 = [exp(mpf(s) * mpf("1e-3")) for s in (-40, -60)]
pendulum_poles = poles(phi2, matrix([[1, 0]]), product(roots2), roots2)


def show(value, depth):
    if isinstance(value, dict):
        inside = ",\n".join(" " * depth + f'"{k}": {show(v, depth + 1)}' for k, v in value.items())
        return "{\n" + inside + "\n" + " " * (depth - 1) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(show(v, depth) for v in value) + "]"
    return value if isinstance(value, str) else json.dumps(value)


with open("kalman.json", "w") as file:
    file.write(show({
        "two_mass": {"q": entries(q), **two_mass}, "load_alone": one,
        "load_poles": load_poles, "pendulum_poles": pendulum_poles,
    }, 1) + "\n")
