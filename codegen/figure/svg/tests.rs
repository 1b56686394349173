use super::text::spread;
use super::*;

fn figure(points: Vec<Point>, role: Role) -> Figure {
    let curve = Curve { label: "a < b & \"c\"\u{1}".into(), role, points };
    let marker = Some(Marker { x: 1.0, label: "m".into() });
    let cell = Cell { curves: vec![curve.clone(), curve], marker, band: Some(0.5) };
    Figure {
        title: "<title>".into(),
        subtitle: "one\ntwo".into(),
        legend: (0..9).map(|k| Entry { name: "a < b & \"c\"".into(), role: Role::Rival(k) }).collect(),
        columns: vec![Column::default(), Column { title: "zoom".into(), x_range: Some((0.0, 1.5)) }],
        panels: vec![Panel { cells: vec![cell.clone(), cell], ..Panel::default() }, Panel::default()],
        ..Figure::default()
    }
}

/// Checks that tags nest, attributes are quoted and no number is NaN or infinite.
fn check(svg: &str) {
    let mut open = Vec::new();
    for piece in svg.split('<').skip(1) {
        let (tag, content) = piece.split_once('>').expect("a tag ends");
        assert!(!content.contains('"'), "{content}");
        assert!(tag.matches('"').count() % 2 == 0, "{tag}");
        assert!(!["NaN", "inf", "-0 "].iter().any(|bad| tag.contains(bad)), "{tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap());
        }
    }
    assert!(open.is_empty());
}

fn labels(low: f64, high: f64) -> Vec<String> {
    Axis::new(Range { low, high }, 5.0).labels().map(str::to_owned).collect()
}

#[test]
fn every_curve_gives_a_well_formed_document() {
    const NAN: f64 = f64::NAN;
    let curves: [&[Point]; 11] = [
        &[],
        &[(0.0, NAN), (1.0, f64::INFINITY)],
        &[(NAN, 1.0)],
        &[(1.0, 2.0)],
        &[(0.0, 3.0), (1.0, 3.0), (2.0, 3.0)],
        &[(0.0, 1e300), (1.0, -1e300), (2.0, 0.0)],
        &[(0.0, f64::MAX), (1.0, f64::MIN), (2.0, 5e-324)],
        &[(0.0, 1e-300), (1.0, 2e-300), (2.0, -1e-310)],
        &[(-1e308, 1.0), (1e308, 1.0 + f64::EPSILON)],
        &[(0.0, 1.0), (0.5, NAN), (1.0, 1.0), (1.2, NAN), (1.4, 2.0)],
        &[(2.0, 1.0), (0.0, 2.0), (1.0, 3.0)],
    ];
    for points in curves {
        let rivals = [Role::Rival(0), Role::Rival(9), Role::RivalError(3)];
        for role in [Role::Measured, Role::Reference, Role::Error, Role::Estimate].into_iter().chain(rivals) {
            check(&figure(points.to_vec(), role).to_string());
        }
    }
    check(&Figure::default().to_string());
}

#[test]
fn text_is_escaped() {
    let svg = figure(vec![(0.0, 1.0), (1.0, 2.0)], Role::Error).to_string();
    assert!(svg.contains("<title>&lt;title&gt;</title>"));
    assert!(svg.contains("a &lt; b &amp; &quot;c&quot;\u{fffd}</text>"));
}

#[test]
fn a_gap_interrupts_the_line_and_a_lone_point_is_a_dot() {
    let points = vec![(0.0, 0.0), (0.5, 1.0), (0.6, f64::NAN), (1.0, 1.0)];
    let svg = figure(points, Role::Estimate).to_string();
    let path = svg.lines().find(|line| line.contains("#0072b2\" stroke-width=\"1.15")).unwrap();
    assert_eq!((path.matches('M').count(), path.matches('L').count(), path.matches("h0").count()), (2, 1, 1));
}

#[test]
fn ticks_are_round_numbers() {
    assert_eq!(labels(0.0, 55.0), ["0", "10", "20", "30", "40", "50"]);
    assert_eq!(labels(-0.3, 0.31), ["−0.3", "−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"]);
    assert_eq!(labels(0.0, 2.5e6), ["0", "5e5", "1e6", "1.5e6", "2e6", "2.5e6"]);
    assert_eq!(labels(0.0, 4e-300), ["0", "1e−300", "2e−300", "3e−300", "4e−300"]);
}

#[test]
fn labels_are_pushed_apart_within_the_panel() {
    let close = |a: Vec<f64>, b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(close(spread(&[10.0, 50.0], 15.0, 100.0), &[10.0, 50.0]));
    assert!(close(spread(&[50.0, 50.0], 15.0, 100.0), &[42.5, 57.5]));
    assert!(close(spread(&[40.0, 50.0, 52.0], 15.0, 100.0), &[97.0 / 3.0, 142.0 / 3.0, 187.0 / 3.0]));
    assert!(close(spread(&[0.0, 1.0], 15.0, 100.0), &[0.0, 15.0]));
    assert!(close(spread(&[99.0, 100.0], 15.0, 100.0), &[85.0, 100.0]));
    assert!(close(spread(&[5.0, 5.0, 5.0], 15.0, 20.0), &[0.0, 15.0, 30.0]));
}

#[test]
fn coordinates_have_at_most_two_decimals_and_no_minus_zero() {
    assert_eq!([1.0, 2.345_6, -0.001, 1e5 / 3.0].map(|x| Px(x).to_string()), ["1", "2.35", "0", "33333.33"]);
}
