//! The elementary functions of `geometry::math` give the bits that they gave when this was written, on every platform.
//!
//! They come from the crate `libm`, of which the manifest asks for 0.2.16 or any later 0.2. If a function fails here
//! after an update of that crate, meshes may differ in last places from those of the releases before. Then either hold
//! it back (`cargo update -p libm --precise VERSION`), or take the digest that the failure names, in a commit that
//! updates `Cargo.lock`, says so in the changelog, and asks in the manifest for the new version at least. If a function
//! fails on one platform alone, the promise of the same bytes is broken there: report it to `libm`.

use trimalla::geometry::math;

#[test]
fn every_function_gives_the_bits_that_it_gave() {
    for (name, function, expected) in FUNCTIONS {
        let found = digest(function);
        assert_eq!(found, expected, "{name} gives other bits: the digest is {found:#x}, not {expected:#x}");
    }
}

/// That a digest depends on each bit: of all results, the last one is another by one last place.
#[test]
fn one_last_place_is_noticed() {
    let tampered = |d: &mut Draws| {
        let result = math::sin(d.number(-30, 60));
        if d.drawn == 3 * RESULTS { result.next_up() } else { result }
    };
    assert_ne!(digest(tampered), digest(FUNCTIONS[0].1));
}

/// A function of arguments that are drawn.
type Function = fn(&mut Draws) -> f64;

/// The functions, each with its result on the arguments that are drawn next, and the [`digest`] of 4096 results.
const FUNCTIONS: [(&str, Function, u64); 13] = [
    ("sin", |d| math::sin(d.number(-30, 60)), 0x13f0_c9d3_03fb_d48b),
    ("cos", |d| math::cos(d.number(-30, 60)), 0xd798_4631_c324_a6f6),
    ("tan", |d| math::tan(d.number(-30, 60)), 0x7044_5797_f930_3c2c),
    ("asin", |d| math::asin(d.number(-30, -1)), 0x0258_1502_897a_2035),
    ("acos", |d| math::acos(d.number(-30, -1)), 0x33c0_02a2_5a60_bc20),
    ("atan", |d| math::atan(d.number(-30, 60)), 0x97ad_4378_99ae_4aae),
    ("atan2", |d| math::atan2(d.number(-30, 30), d.number(-30, 30)), 0x4628_2f4f_d807_cf28),
    ("hypot", |d| math::hypot(d.number(-300, 300), d.number(-300, 300)), 0xe6d4_e48b_08ba_c36f),
    ("exp", |d| math::exp(d.number(-30, 8)), 0x30c8_a23c_3d0c_310d),
    ("ln", |d| math::ln(d.number(-1000, 1000).abs()), 0x84b0_fe16_840e_b358),
    ("log10", |d| math::log10(d.number(-1000, 1000).abs()), 0xc3b6_2ee3_115d_361c),
    ("pow", |d| math::pow(d.number(-10, 10).abs(), d.number(-8, 5)), 0x143f_647f_ee71_0e37),
    ("cbrt", |d| math::cbrt(d.number(-1000, 1000)), 0xe730_6bfa_23d8_4296),
];

/// So many results a function.
const RESULTS: usize = 4096;

/// Numbers drawn one after the other (`SplitMix64`).
struct Draws {
    state: u64,
    drawn: usize,
}

impl Draws {
    fn next(&mut self) -> u64 {
        self.drawn += 1;
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number of either sign with a binary exponent from `low` to `high`; one in eight has but a few bits.
    fn number(&mut self, low: i64, high: i64) -> f64 {
        let exponent = low + (self.next() % (high - low + 1) as u64) as i64;
        let bits = self.next();
        let mantissa = if self.next() % 8 == 0 { bits & (0xf << 48) } else { bits & ((1 << 52) - 1) };
        f64::from_bits((bits & (1 << 63)) | (((1023 + exponent) as u64) << 52) | mantissa)
    }
}

/// The bits of all results of a function as one number (FNV-1a).
fn digest(function: Function) -> u64 {
    let mut draws = Draws { state: 2026, drawn: 0 };
    let results = (0..RESULTS).map(|_| function(&mut draws).to_bits());
    let bytes = results.flat_map(u64::to_le_bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |digest, byte| (digest ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}
