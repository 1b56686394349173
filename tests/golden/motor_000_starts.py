"""Writes motor_000_starts.json: the first 50 ms of the paper's observers of the motor, by mpmath with 25 digits.

Before the delay of 0.1 s is over nothing is delayed, so that a Taylor method can do it. It settles what the two
files traj_motor_000_*.json are good for: their integrator is wrong by up to 5e-11 in these first steps.
Run it in this folder.
"""
import json
from mpmath import mp, mpf, nstr, odefun, sin

mp.dps = 25
GOLDEN = json.load(open("motor_000.json"), parse_float=mpf)
A3 = mpf("36.4")


def run(k, by_omega, times, step):
    g = GOLDEN[f"k{k}"]
    R, H, S = [r[0] for r in g["R"]], [r[0] for r in g["H"]], g["Sinv"]

    def estimate(x, y):
        b = [x[8 + i] - x[6 + i] for i in range(2)]
        return [x[3 + i] + R[i] * (y - x[5]) + S[i][0] * b[0] + S[i][1] * b[1] for i in range(2)]

    def rhs(t, x):
        y, u = x[10] if by_omega else x[0], sin(3 * t)
        v = y - x[5]
        return [
            x[1], 15 * x[2] - 35 * sin(x[0]) - x[1], 40 * u - A3 * x[1] - 200 * x[2],
            -x[3] + 15 * x[4] - 35 * sin(y), -A3 * x[3] - 200 * x[4] + 40 * u, x[3] - k * x[5] + k * y,
            -k * x[6] + H[0] * v, -k * x[7] + H[1] * v,
            (1 - 2 * k) * x[8] + A3 * x[9] + H[0] * v, -15 * x[8] + (200 - 2 * k) * x[9] + H[1] * v,
            estimate(x, y)[0] if by_omega else mpf(0),
        ]

    x, t, rows = [mpf("0.5"), mpf(1), mpf(2)] + [mpf(0)] * 8, mpf(0), []
    for _ in range(int(times[-1] / step + mpf("0.5"))):
        x[10] = x[0]
        x, t = list(odefun(rhs, t, x)(t + step)), t + step
        x[10] = x[0]
        if any(abs(t - time) < step / 2 for time in times):
            e = estimate(x, x[0])
            values = [e[0] - x[1], e[1] - x[2]] if by_omega else x[6:10]
            rows.append([nstr(t, 3)] + [nstr(v, 20) for v in values])
    return rows


def written(rows):
    return "[\n" + ",\n".join("  [" + ", ".join(row) + "]" for row in rows) + "\n ]"


two = run(100, True, [mpf(c) for c in ("0.01", "0.02", "0.03", "0.04", "0.05")], mpf("0.005"))
one = run(150, False, [mpf(c) for c in ("0.02", "0.04")], mpf("0.02"))
with open("motor_000_starts.json", "w") as file:
    file.write('{\n "doc": "t and err11, err12 of Theorem 2 at k = 100; t and psi_1, psi_2 of Theorem 1 at k = 150",\n')
    file.write(f' "thm2_k100": {written(two)},\n "thm1_k150": {written(one)}\n}}\n')
