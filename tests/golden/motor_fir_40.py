"""Writes motor_fir_40.json: the motor's window functional with 40 digits, by mpmath.

The plant is that of motor_twin.json; decimals are read as decimals. K = Phi^N O^+ by the normal
equations at 400 digits, M by the recursion; O has a condition of 1e4, so that 40 digits are certain.
"""
from mpmath import mp, mpf, matrix, expm, eye, nstr, zeros

mp.dps = 400
N, h = 100, mpf("0.001")
F = matrix([["0", "1", "0"], ["0", "-1", "15"], ["0", "-36.4", "-200"]])
B = matrix([["0", "0"], ["-35", "0"], ["0", "40"]])
C = matrix([["1", "0", "0"]])

whole = zeros(5, 5)
whole[0:3, 0:3] = F * h
whole[0:3, 3:5] = B * h
whole = expm(whole, method="taylor")
Phi, Gam = whole[0:3, 0:3], whole[0:3, 3:5]

rows = [C]
for _ in range(N):
    rows.append(rows[-1] * Phi)
O = matrix([[row[0, j] for j in range(3)] for row in rows])
W = Phi**N * ((O.T * O) ** -1) * O.T
K = [W[:, N - age] for age in range(N + 1)]

acc, M = eye(3) - K[0] * C, []
for age in range(1, N + 1):
    M.append(acc * Gam)
    acc = acc * Phi - K[age] * C
assert max(abs(x) for x in acc) < mpf(10) ** -300


def text(m):
    entry = lambda x: nstr(x, 40, min_fixed=0, max_fixed=0) if x else "0.0"
    return "[" + ", ".join("[" + ", ".join(entry(m[i, j]) for j in range(m.cols)) + "]" for i in range(m.rows)) + "]"


with open("motor_fir_40.json", "w") as file:
    lists = lambda ms: "[\n  " + ",\n  ".join(text(m) for m in ms) + "\n ]"
    file.write('{\n "Phi": ' + text(Phi) + ',\n "K": ' + lists(K) + ',\n "M": ' + lists(M) + "\n}\n")
