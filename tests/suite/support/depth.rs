//! How much is tried: enough to notice a mistake on every run, and far more with `DEADBEAT_DEEP=1`, with which `.ci/run`
//! runs all tests once. What is claimed is the same; otherwise random plants, Programs and texts are fewer, and
//! specifications are taken in the scalar that they name alone.

/// Whether everything is tried.
pub fn deep() -> bool {
    std::env::var("DEADBEAT_DEEP").is_ok_and(|value| value == "1")
}

/// The first, or the second where everything is tried.
pub fn trials<T>(usual: T, deeply: T) -> T {
    if deep() { deeply } else { usual }
}
