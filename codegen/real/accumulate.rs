//! The exact sum of products, word by word in one place: no memory is asked for and nothing is rounded until all
//! products are in.

use dashu_base::{BitTest, Sign};
use dashu_int::{DoubleWord, IBig, UBig, Word};

use super::number::{Real, count, size};

/// Factors of more bits are left to faster algorithms than that of school.
const FACTOR: usize = 1_280;

/// A sum that spreads over more bits costs more than its rounding would.
const SPREAD: usize = 10_240;

// What is summed exactly must not depend on the machine's words: both limits are of bits.
const BITS: usize = Word::BITS as usize;

/// `mantissa * 2^exponent`: the sum of the products, none of which is zero, exactly; `None` where that would cost more
/// than rounding on the way.
pub(super) fn sum(pairs: &[(&Real, &Real)]) -> Option<(IBig, i64)> {
    let low = pairs.iter().map(|(a, b)| a.exponent + b.exponent).min()?;
    let bits = |x: &Real| x.mantissa.bit_len();
    let longest = pairs.iter().map(|(a, b)| bits(a).max(bits(b))).max()?;
    let highest = pairs.iter().map(|(a, b)| size(bits(a) + bits(b)) + a.exponent + b.exponent - low).max()?;
    let spread = count(highest);
    if longest > FACTOR || spread > SPREAD {
        return None;
    }
    // A product has a word more than its bits at each end; two hold the carries of any number of terms.
    let spread = spread / BITS + 4;
    // What is added and what is taken away, and a product on its way there.
    let (mut plus, mut minus, mut product) = (vec![0; spread], vec![0; spread], [0; 2 * (FACTOR / BITS + 1)]);
    for (a, b) in pairs {
        let ((sign_a, a_words), (sign_b, b_words)) = (a.mantissa.as_sign_words(), b.mantissa.as_sign_words());
        let product = &mut product[..a_words.len() + b_words.len()];
        multiply(a_words, b_words, product);
        let shift = count(a.exponent + b.exponent - low);
        let sum = if sign_a * sign_b == Sign::Positive { &mut plus } else { &mut minus };
        add_shifted(&mut sum[shift / BITS..], product, shift % BITS);
    }
    Some((IBig::from(UBig::from_words(&plus)) - IBig::from(UBig::from_words(&minus)), low))
}

/// The low word of a double one, and the high one.
#[expect(clippy::cast_possible_truncation, reason = "the halves of a double word")]
fn halves(double: DoubleWord) -> (Word, Word) {
    (double as Word, (double >> BITS) as Word)
}

/// `product = a * b`, as at school.
fn multiply(a: &[Word], b: &[Word], product: &mut [Word]) {
    product.fill(0);
    for (at, factor) in a.iter().enumerate() {
        let (row, mut carry) = (&mut product[at..=at + b.len()], 0);
        for (sum, other) in row.iter_mut().zip(b) {
            let whole = DoubleWord::from(*factor) * DoubleWord::from(*other) + DoubleWord::from(*sum);
            (*sum, carry) = halves(whole + DoubleWord::from(carry));
        }
        row[b.len()] = carry;
    }
}

/// `sum += addend * 2^bits` for less than a word of bits.
fn add_shifted(sum: &mut [Word], addend: &[Word], bits: usize) {
    let (mut below, mut carry) = (0, 0);
    let (low, high) = sum.split_at_mut(addend.len());
    for (sum, word) in low.iter_mut().zip(addend) {
        let (shifted, rest) = halves(DoubleWord::from(*word) << bits);
        (*sum, carry) = halves(DoubleWord::from(*sum) + DoubleWord::from(shifted | below) + DoubleWord::from(carry));
        below = rest;
    }
    for sum in high {
        if below == 0 && carry == 0 {
            break;
        }
        (*sum, carry) = halves(DoubleWord::from(*sum) + DoubleWord::from(below) + DoubleWord::from(carry));
        below = 0;
    }
}
