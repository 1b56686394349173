#!/usr/bin/env python3
"""Prints every constant of this crate as Rust source. Needs mpmath.

Polynomials are minimax fits (Remez exchange) of a power series in t, weighted
so that the error counts where it reaches the result; they are printed as
unsigned fixed point with 64 fraction bits. Each line's comment gives the
largest weighted error as a power of two.
"""
from mpmath import (atan, atanh, cos, exp, floor, log, lu_solve, matrix, mp, mpf, nint, pi, sqrt,
                    tanh)

mp.prec = 400


def remez(f, weight, lo, hi, n):
    """Coefficients c of sum c[k] t^k, k < n, minimising max |f - p| * weight."""
    lo, hi = mpf(lo), mpf(hi)
    points = [(lo + hi) / 2 - (hi - lo) / 2 * cos(pi * (2 * k + 1) / (2 * n + 2))
              for k in range(n + 1)]
    grid = [lo + (hi - lo) * (1 - cos(pi * (k + mpf(1) / 2) / 400)) / 2 for k in range(400)]
    values = [(t, f(t), weight(t)) for t in grid]
    for _ in range(12):
        rows = matrix(n + 1, n + 1)
        rhs = matrix(n + 1, 1)
        for i, t in enumerate(points):
            for k in range(n):
                rows[i, k] = t ** k
            rows[i, n] = (-1) ** i / weight(t)
            rhs[i] = f(t)
        c = list(lu_solve(rows, rhs))[:n]
        errors = [(t, (v - sum(a * t ** k for k, a in enumerate(c))) * w) for t, v, w in values]
        extrema = []
        for t, e in errors:
            if extrema and (extrema[-1][1] > 0) == (e > 0):
                if abs(e) > abs(extrema[-1][1]):
                    extrema[-1] = (t, e)
            else:
                extrema.append((t, e))
        while len(extrema) > n + 1:
            extrema.pop(0 if abs(extrema[0][1]) < abs(extrema[-1][1]) else -1)
        if len(extrema) < n + 1:
            break
        points = [t for t, _ in extrema]
    return c, max(abs(e) for _, e in errors)


def hexed(value, digits=16):
    text = f"{int(value):0{digits}X}"
    return "0x" + "_".join(text[i:i + 4] for i in range(0, len(text), 4))


def array(name, kind, values, digits=16):
    body = "".join(f"    {hexed(v, digits)},\n" for v in values)
    print(f"const {name}: [{kind}; {len(values)}] = [\n{body}];")


def fixed(value, bits=64):
    return nint(value * mpf(2) ** bits)


def polynomial(name, f, weight, lo, hi, n):
    c, error = remez(f, weight, lo, hi, n)
    print(f"// {name}: largest error 2^{float(log(error, 2)):.1f}")
    array(name, "u64", [fixed(abs(a)) for a in c])


def constant(name, value, bits):
    print(f"const {name}: u64 = {hexed(fixed(value, bits))};")


def series(terms):
    """A function given by its power series, for arguments where a formula cancels."""
    return lambda t: sum(c * t ** k for k, c in enumerate(terms))


def factorial_series(first):
    out, value = [], mpf(1)
    for k in range(1, 80):
        value /= k
        if k >= first and (k - first) % 2 == 0:
            out.append((-1) ** len(out) * value)
    return out


TINY = mpf(2) ** -40
quarter = (pi / 4) ** 2 * (1 + TINY)

polynomial("SINE", series(factorial_series(3)), lambda t: t, TINY, quarter, 7)
polynomial("COSINE", series(factorial_series(2)), lambda t: t, TINY, quarter, 8)
polynomial("EXP2", lambda t: (exp(t * log(mpf(2))) - 1) / t, lambda t: t, TINY, mpf(1) / 16, 7)
polynomial("ATANH", lambda t: (atanh(sqrt(t)) / sqrt(t) - 1) / t, lambda t: t,
           TINY, (3 - 2 * sqrt(mpf(2))) ** 2 * (1 + TINY), 8)
polynomial("ATAN", lambda t: (1 - atan(sqrt(t)) / sqrt(t)) / t, lambda t: t,
           TINY, mpf(1) / 64, 7)
polynomial("TANH", lambda t: (1 - tanh(sqrt(t)) / sqrt(t)) / t, lambda t: t,
           TINY, mpf(1) / 64, 6)
polynomial("LOG_ODD", series([mpf(1) / (2 * k + 3) for k in range(40)]), lambda t: t,
           TINY, mpf(1) / 1024, 5)
polynomial("LOG_EVEN", series([mpf(1) / (2 * k + 4) for k in range(40)]), lambda t: t * sqrt(t),
           TINY, mpf(1) / 1024, 5)

# First guess of 1/sqrt(v) on [1/4, 1], lowered so that it is never too large.
c, error = remez(lambda t: 1 / sqrt(t), lambda t: sqrt(t), mpf(1) / 4, mpf(1), 3)
print(f"// RECIPROCAL_ROOT: at most 2^{float(log(2 * error, 2)):.1f} too small, 30 fraction bits")
array("RECIPROCAL_ROOT", "u64", [floor(abs(a) * (1 - error - mpf(2) ** -24) * 2 ** 30) for a in c], 8)

array("EXP2_TABLE", "u64", [fixed(mpf(2) ** (mpf(k) / 16), 63) for k in range(16)])
array("ARC_TABLE", "u64", [fixed(atan(mpf(k) / 4), 63 - e)
                           for k, e in ((1, -3), (2, -2), (3, -1), (4, -1))])
constant("PI", pi, 62)
constant("LN_2", log(mpf(2)), 64)
constant("ROOT_TWO", sqrt(mpf(2)), 63)
log2e = floor(2 ** mpf(127) / log(mpf(2)))
print(f"const LOG2_E: u64 = {hexed(int(log2e) >> 64)};")
print(f"const LOG2_E_LOW: u64 = {hexed(int(log2e) & (2**64 - 1))};")

# Reciprocals of [1 + k/32, 1 + (k+1)/32) in 1/256, exactly 1 and 1/2 at the ends.
reciprocals = [256] + [int(nint(256 / (1 + (mpf(k) + mpf(1) / 2) / 32))) for k in range(1, 31)] + [128]
array("RECIPROCAL", "u32", reciprocals, 4)
logs = [int(floor(-log(mpf(c) / 256) / log(mpf(2)) * mpf(2) ** 126)) for c in reciprocals]
array("LOG2_HIGH", "u64", [v >> 64 for v in logs])
array("LOG2_LOW", "u64", [v & (2 ** 64 - 1) for v in logs])
worst = max(abs(c / 256 * (1 + (k + d) / 32) - 1) for k, c in enumerate(reciprocals) for d in (0, 1))
print(f"// largest |m c - 1|: {float(worst)} < {1 / 32}")

# 2/pi, 32 bits to a word, after one word of zeros (f32) and after two (f64).
with mp.workprec(1600):
    bits = int(floor(2 / pi * mpf(2) ** (32 * 40)))
words = [0] + [(bits >> (32 * (39 - k))) & 0xFFFFFFFF for k in range(40)]
array("TWO_OVER_PI_F32", "u32", words[:9], 8)
array("TWO_OVER_PI_F64", "u32", [0] + words[:39], 8)
