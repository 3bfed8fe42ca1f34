//! The exponential of a small matrix by scaling and squaring of its Taylor polynomial:
//! C. Moler and C. Van Loan, SIAM Review 45 (2003), method 3.

/// Of the polynomial: `0.5^19/19! = 2e-23` for the scaled matrix.
const DEGREE: u32 = 18;

/// The product of an n by n matrix and one of n rows, both row by row.
pub(crate) fn product(a: &[f64], b: &[f64], n: usize) -> Vec<f64> {
    let columns = b.len() / n;
    let mut c = vec![0.0; b.len()];
    for (row, out) in a.chunks_exact(n).zip(c.chunks_exact_mut(columns)) {
        for (factor, line) in row.iter().zip(b.chunks_exact(columns)) {
            for (sum, entry) in out.iter_mut().zip(line) {
                *sum += factor * entry;
            }
        }
    }
    c
}

/// The largest sum of magnitudes of a row.
fn norm(matrix: &[f64], n: usize) -> f64 {
    let sums = matrix
        .chunks_exact(n)
        .map(|row| row.iter().map(|entry| entry.abs()).sum());
    sums.fold(0.0, f64::max)
}

/// `e^M` for an n by n matrix of finite numbers.
pub(crate) fn exponential(matrix: &[f64], n: usize) -> Vec<f64> {
    // norm = f 2^e with f in [1/2, 1): 2^-(e+1) takes it to 1/2 at most.
    let (_, exponent) = libm::frexp(norm(matrix, n));
    let squarings = (exponent + 1).max(0);
    let small: Vec<f64> = matrix
        .iter()
        .map(|entry| libm::ldexp(*entry, -squarings))
        .collect();
    // Horner: 1 + M/1 (1 + M/2 (1 + ...)).
    let mut power = identity(n);
    for k in (1..=DEGREE).rev() {
        power = product(&small, &power, n);
        for entry in &mut power {
            *entry /= f64::from(k);
        }
        for i in 0..n {
            power[i * n + i] += 1.0;
        }
    }
    for _ in 0..squarings {
        power = product(&power, &power, n);
    }
    power
}

fn identity(n: usize) -> Vec<f64> {
    let mut matrix = vec![0.0; n * n];
    for i in 0..n {
        matrix[i * n + i] = 1.0;
    }
    matrix
}
