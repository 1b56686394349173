//! Gauss collocation with a fixed step: order twice the stages, solved by fixed-point iteration. Where the step
//! divides a delay, delayed values exist at the very same stages, so that delays cost no accuracy.

/// The slope of x at a stage and a time.
pub type Slope<'a> = &'a dyn Fn(usize, f64, &[f64]) -> Vec<f64>;

/// The method.
pub struct Collocation {
    /// c, in (0, 1).
    nodes: Vec<f64>,
    /// b.
    weights: Vec<f64>,
    /// a: by stage, what each stage's slope adds.
    sums: Vec<Vec<f64>>,
}

impl Collocation {
    /// With so many stages.
    pub fn new(stages: u32) -> Self {
        let nodes: Vec<f64> = (1..=stages).map(|i| 0.5 - 0.5 * root(stages, i)).collect();
        let weights: Vec<f64> = nodes.iter().map(|c| weight(stages, 2.0 * c - 1.0) / 2.0).collect();
        let basis = |j: usize, x: f64| -> f64 {
            let others = nodes.iter().enumerate().filter(|(m, _)| *m != j);
            others.map(|(_, c)| (x - c) / (nodes[j] - c)).product()
        };
        // The integral of a basis polynomial up to a node, by the same quadrature, which is exact for it.
        let sum = |c: f64, j: usize| -> f64 { nodes.iter().zip(&weights).map(|(x, w)| c * w * basis(j, c * x)).sum() };
        let sums = nodes.iter().map(|c| (0..nodes.len()).map(|j| sum(*c, j)).collect()).collect();
        Self { nodes, weights, sums }
    }

    /// x(t + h) of x' = rhs(stage, t, x), and x at the stages.
    pub fn step(&self, rhs: Slope, t: f64, h: f64, x: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        // Each iteration gains a digit or more where h times the fastest rate is below 1.
        const ITERATIONS: usize = 30;
        let advanced = |factors: &[f64], slopes: &[Vec<f64>]| -> Vec<f64> {
            let by = |j: usize| factors.iter().zip(slopes).map(|(factor, slope)| factor * slope[j]).sum::<f64>();
            x.iter().enumerate().map(|(j, x)| x + h * by(j)).collect()
        };
        let mut stages = vec![x.to_vec(); self.nodes.len()];
        let mut slopes = Vec::new();
        for _ in 0..ITERATIONS {
            slopes = (0..stages.len()).map(|i| rhs(i, t + h * self.nodes[i], &stages[i])).collect();
            stages = self.sums.iter().map(|factors| advanced(factors, &slopes)).collect();
        }
        (advanced(&self.weights, &slopes), stages)
    }
}

/// P and P' of Legendre's polynomial.
fn legendre(degree: u32, x: f64) -> (f64, f64) {
    let (mut before, mut now) = (1.0, x);
    for k in 2..=degree {
        let k = f64::from(k);
        (before, now) = (now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k);
    }
    (now, f64::from(degree) * (x * now - before) / (x * x - 1.0))
}

/// The i-th root, from the right, by Newton's method.
fn root(degree: u32, i: u32) -> f64 {
    let start = (std::f64::consts::PI * (f64::from(i) - 0.25) / (f64::from(degree) + 0.5)).cos();
    (0..10).fold(start, |x, _| {
        let (value, slope) = legendre(degree, x);
        x - value / slope
    })
}

fn weight(degree: u32, x: f64) -> f64 {
    let (_, slope) = legendre(degree, x);
    2.0 / ((1.0 - x * x) * slope * slope)
}
