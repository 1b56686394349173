//! The words of units: what each is in the seven base units of the SI, exactly.

/// Powers of metre, kilogram, second, ampere, kelvin, mole and candela.
pub(super) type Powers = [i32; 7];

/// A word: what it is, its size in SI units as numerator, denominator and power of pi, whether prefixes such as `k` go
/// before it.
pub(super) struct Word {
    pub(super) name: &'static str,
    pub(super) powers: Powers,
    pub(super) size: (i64, i64, i32),
    pub(super) prefixed: bool,
}

const NONE: Powers = [0; 7];
const LENGTH: Powers = [1, 0, 0, 0, 0, 0, 0];
const SPEED: Powers = [1, 0, -1, 0, 0, 0, 0];
const MASS: Powers = [0, 1, 0, 0, 0, 0, 0];
const TIME: Powers = [0, 0, 1, 0, 0, 0, 0];
const RATE: Powers = [0, 0, -1, 0, 0, 0, 0];
const CHARGE: Powers = [0, 0, 1, 1, 0, 0, 0];
const TEMPERATURE: Powers = [0, 0, 0, 0, 1, 0, 0];
const FORCE: Powers = [1, 1, -2, 0, 0, 0, 0];
const PRESSURE: Powers = [-1, 1, -2, 0, 0, 0, 0];
const ENERGY: Powers = [2, 1, -2, 0, 0, 0, 0];
const POWER: Powers = [2, 1, -3, 0, 0, 0, 0];
const VOLUME: Powers = [3, 0, 0, 0, 0, 0, 0];

const fn prefixed(name: &'static str, powers: Powers) -> Word {
    Word { name, powers, size: (1, 1, 0), prefixed: true }
}

const fn scaled(name: &'static str, powers: Powers, size: (i64, i64, i32)) -> Word {
    Word { name, powers, size, prefixed: false }
}

const fn both(name: &'static str, powers: Powers, size: (i64, i64, i32)) -> Word {
    Word { name, powers, size, prefixed: true }
}

/// An angle is a number, as in the SI: a torque over a moment of inertia is in rad/s^2. A temperature in degrees Celsius
/// is one in kelvin, since rates and differences are what equations are of.
pub(super) const WORDS: &[Word] = &[
    prefixed("m", LENGTH),
    both("g", MASS, (1, 1_000, 0)),
    both("t", MASS, (1_000, 1, 0)),
    prefixed("s", TIME),
    prefixed("A", [0, 0, 0, 1, 0, 0, 0]),
    prefixed("K", TEMPERATURE),
    prefixed("mol", [0, 0, 0, 0, 0, 1, 0]),
    prefixed("cd", [0, 0, 0, 0, 0, 0, 1]),
    prefixed("lm", [0, 0, 0, 0, 0, 0, 1]),
    prefixed("lx", [-2, 0, 0, 0, 0, 0, 1]),
    prefixed("rad", NONE),
    prefixed("sr", NONE),
    prefixed("Hz", RATE),
    prefixed("N", FORCE),
    prefixed("Pa", PRESSURE),
    both("bar", PRESSURE, (100_000, 1, 0)),
    prefixed("J", ENERGY),
    prefixed("W", POWER),
    both("Wh", ENERGY, (3_600, 1, 0)),
    prefixed("C", CHARGE),
    both("Ah", CHARGE, (3_600, 1, 0)),
    prefixed("V", [2, 1, -3, -1, 0, 0, 0]),
    prefixed("VA", POWER),
    prefixed("F", [-2, -1, 4, 2, 0, 0, 0]),
    prefixed("ohm", [2, 1, -3, -2, 0, 0, 0]),
    prefixed("Ohm", [2, 1, -3, -2, 0, 0, 0]),
    prefixed("Ω", [2, 1, -3, -2, 0, 0, 0]),
    prefixed("\u{2126}", [2, 1, -3, -2, 0, 0, 0]),
    prefixed("S", [-2, -1, 3, 2, 0, 0, 0]),
    prefixed("H", [2, 1, -2, -2, 0, 0, 0]),
    prefixed("Wb", [2, 1, -2, -1, 0, 0, 0]),
    prefixed("T", [0, 1, -2, -1, 0, 0, 0]),
    both("l", VOLUME, (1, 1_000, 0)),
    both("L", VOLUME, (1, 1_000, 0)),
    scaled("sec", TIME, (1, 1, 0)),
    scaled("min", TIME, (60, 1, 0)),
    scaled("h", TIME, (3_600, 1, 0)),
    scaled("hr", TIME, (3_600, 1, 0)),
    scaled("day", TIME, (86_400, 1, 0)),
    scaled("10", NONE, (10, 1, 0)),
    scaled("%", NONE, (1, 100, 0)),
    scaled("ppm", NONE, (1, 1_000_000, 0)),
    scaled("deg", NONE, (1, 180, 1)),
    scaled("degree", NONE, (1, 180, 1)),
    scaled("°", NONE, (1, 180, 1)),
    scaled("arcmin", NONE, (1, 10_800, 1)),
    scaled("arcsec", NONE, (1, 648_000, 1)),
    scaled("rev", NONE, (2, 1, 1)),
    scaled("turn", NONE, (2, 1, 1)),
    scaled("rpm", RATE, (1, 30, 1)),
    scaled("degC", TEMPERATURE, (1, 1, 0)),
    scaled("°C", TEMPERATURE, (1, 1, 0)),
    scaled("degF", TEMPERATURE, (5, 9, 0)),
    scaled("°F", TEMPERATURE, (5, 9, 0)),
    scaled("gn", [1, 0, -2, 0, 0, 0, 0], (980_665, 100_000, 0)),
    scaled("in", LENGTH, (254, 10_000, 0)),
    scaled("ft", LENGTH, (3_048, 10_000, 0)),
    scaled("mi", LENGTH, (1_609_344, 1_000, 0)),
    scaled("mph", SPEED, (44_704, 100_000, 0)),
    scaled("kn", SPEED, (1_852, 3_600, 0)),
    scaled("lb", MASS, (45_359_237, 100_000_000, 0)),
    scaled("lbf", FORCE, (44_482_216_152_605, 10_000_000_000_000, 0)),
    scaled("psi", PRESSURE, (6_894_757_293_168, 1_000_000_000, 0)),
    scaled("atm", PRESSURE, (101_325, 1, 0)),
];

/// Prefixes with their power of ten.
pub(super) const PREFIXES: &[(&str, i32)] = &[
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("da", 1),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
];
