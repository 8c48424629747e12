//! The head that functions in C++ share: their scalar type, checks of lengths, sines and roots.

use std::fmt::Write;

use crate::formulation::Sines;
use crate::module::Module;
use crate::print::c::COptions;
use crate::print::c::body::CWriter;
use crate::print::c::declarations::number;
use crate::print::sines::{ANGLE, COSINE, SHIFTED, SINE, range, statements};
use crate::print::steps::{has_angles, has_roots};
use crate::print::walk::walk;
use crate::real::Real;

/// The namespace `detail`.
pub(super) fn text(module: &Module, options: &COptions<'_>) -> String {
    let number = number(module.scalar);
    let mut text = format!("namespace detail {{\n\n{LENGTHS}\n");
    // Writing to a string cannot fail.
    let _ = write!(
        text,
        "/* The first of these types that is a class; {number} if all are built in. */
template <class... All>
struct Own {{
    using type = {number};
}};

template <class A, class... Rest>
struct Own<A, Rest...> {{
    using type = std::conditional_t<std::is_arithmetic_v<A>, typename Own<Rest...>::type, A>;
}};

template <class... All>
using scalar = typename Own<std::decay_t<All>...>::type;
"
    );
    if has_angles(module) {
        text.push_str(SIN_COS);
        if module.sines == Sines::Own {
            text.push_str(&own_sines(module.scalar, options));
        }
    }
    if has_roots(module) {
        text.push_str(SQRT);
    }
    text + "\n} // namespace detail\n"
}

/// Checks of lengths.
const LENGTHS: &str = "\
template <class V, class = void>
struct HasSize : std::false_type {};

template <class V>
struct HasSize<V, std::void_t<decltype(std::tuple_size<V>::value)>> : std::true_type {};

template <class V, class = void>
struct IsOfEigen : std::false_type {};

template <class V>
struct IsOfEigen<V, std::void_t<decltype(V::SizeAtCompileTime)>> : std::true_type {};

/* Rejects arguments whose type has another length. */
template <std::size_t N, class V>
constexpr void check()
{
    if constexpr (std::is_array_v<V>) {
        static_assert(std::extent_v<V> == N, \"an argument has another length\");
    } else if constexpr (HasSize<V>::value) {
        static_assert(std::tuple_size<V>::value == N, \"an argument has another length\");
    } else if constexpr (IsOfEigen<V>::value) {
        static_assert(V::SizeAtCompileTime < 0 || V::SizeAtCompileTime == static_cast<int>(N),
            \"an argument has another length\");
    }
}
";

/// Sines of any type.
const SIN_COS: &str = "
template <class T>
struct Turn {
    T sine;
    T cosine;
};

template <class T>
Turn<T> sin_cos(const T& angle)
{
    using std::cos;
    using std::sin;
    return {sin(angle), cos(angle)};
}
";

/// Roots of any type.
const SQRT: &str = "
template <class T>
T root(const T& x)
{
    using std::sqrt;
    return sqrt(x);
}
";

/// Sines of built-in numbers.
fn own_sines(real: Real, options: &COptions<'_>) -> String {
    let options = COptions {
        templates: false,
        ..*options
    };
    let mut writer = CWriter::new(real, &options);
    walk(&mut writer, &statements(real));
    let statements = writer.text;
    let number = number(real);
    let (width, top) = match real {
        Real::F32 => (32, "0x80000000u"),
        Real::F64 | Real::Generic => (64, "0x8000000000000000u"),
    };
    let range = range(real);
    let (limit, turns, error) = (range.limit, range.turns, range.error);
    let (growth, end) = (range.growth, range.end);
    let places = width - 2;
    format!(
        "
/* Sine and cosine of an angle up to {limit} rad ({turns} turns), within {error} units in the last place.
 *
 * No branches. Beyond {limit} rad the error grows as {growth} |angle|, from {end} rad on results are meaningless and may
 * be infinite or NaN; NaN and infinite angles give NaN. Cody-Waite reduction to |r| <= pi/4, then minimax
 * polynomials. The sum `{SHIFTED}` has no bits for a fraction: its low bits hold the rounded integer.
 */
inline Turn<{number}> sin_cos({number} {ANGLE})
{{
{statements}
    /* In odd quadrants sine and cosine are exchanged, by bits. */
    std::uint{width}_t s, c, n;
    std::memcpy(&n, &{SHIFTED}, sizeof n);
    std::memcpy(&s, &{SINE}, sizeof s);
    std::memcpy(&c, &{COSINE}, sizeof c);
    const std::uint{width}_t exchanged = (s ^ c) & (0u - (n & 1u));
    s ^= exchanged ^ ((n << {places}) & {top});
    c ^= exchanged ^ (((n + 1u) << {places}) & {top});
    Turn<{number}> turn;
    std::memcpy(&turn.sine, &s, sizeof s);
    std::memcpy(&turn.cosine, &c, sizeof c);
    return turn;
}}
"
    )
}
