#pragma once
// Several reals side by side, so that one formula serves one bead node or some of them at once. Each lane is
// computed in the order in which it would be alone: the same bits.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace drawbead {

/// 16 bytes are what every 64-bit processor computes at once, 32 what AVX2 does. No function may pass the
/// wider ones in a file that is not compiled for AVX2.
template <class S, std::size_t bytes>
struct LaneTypes;
template <>
struct LaneTypes<double, 16> {
    using Vector [[gnu::vector_size(16)]] = double;
    using Mask [[gnu::vector_size(16)]] = int64_t;
};
template <>
struct LaneTypes<double, 32> {
    using Vector [[gnu::vector_size(32)]] = double;
    using Mask [[gnu::vector_size(32)]] = int64_t;
};
template <>
struct LaneTypes<float, 16> {
    using Vector [[gnu::vector_size(16)]] = float;
    using Mask [[gnu::vector_size(16)]] = int32_t;
};

template <class Scalar, std::size_t bytes = 16>
struct Lanes {
    static constexpr std::size_t count = bytes / sizeof(Scalar);
    using Vector = typename LaneTypes<Scalar, bytes>::Vector;
    using Mask = typename LaneTypes<Scalar, bytes>::Mask; ///< all bits of a lane, or none

    Vector v{};

    Lanes() = default;
    template <class Number>
        requires std::is_arithmetic_v<Number>
    Lanes(Number all) {
        for (std::size_t i = 0; i < count; ++i)
            v[i] = static_cast<Scalar>(all);
    }
    explicit Lanes(Vector vector) : v(vector) {}
    Scalar operator[](std::size_t lane) const { return v[lane]; }

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
    friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
    Lanes& operator+=(Lanes b) { return *this = *this + b; }
    Lanes& operator-=(Lanes b) { return *this = *this - b; }

    friend Mask operator<(Lanes a, Lanes b) { return a.v < b.v; }
    friend Mask operator<=(Lanes a, Lanes b) { return a.v <= b.v; }
    friend Mask operator>(Lanes a, Lanes b) { return a.v > b.v; }
    friend Mask operator>=(Lanes a, Lanes b) { return a.v >= b.v; }
    friend Mask is_zero(Lanes a) { return a.v == Vector{}; }

    friend Lanes select(Mask which, Lanes yes, Lanes no) { return Lanes(which ? yes.v : no.v); }
    friend Lanes min(Lanes a, Lanes b) { return select(b < a, b, a); }
    friend Lanes max(Lanes a, Lanes b) { return select(a < b, b, a); }
    friend Lanes abs(Lanes a) { return Lanes(Vector(Mask(a.v) & ~sign_bit())); }
    friend Lanes copysign(Lanes size, Lanes sign) {
        return Lanes(Vector((Mask(size.v) & ~sign_bit()) | (Mask(sign.v) & sign_bit())));
    }
    friend Lanes sqrt(Lanes a) {
#ifdef __AVX__
        if constexpr (bytes == 32) return Lanes(Vector(_mm256_sqrt_pd(__m256d(a.v))));
#endif
#ifdef __SSE2__
        if constexpr (bytes == 16 && sizeof(Scalar) == 8)
            return Lanes(Vector(_mm_sqrt_pd(__m128d(a.v))));
        else if constexpr (bytes == 16)
            return Lanes(Vector(_mm_sqrt_ps(__m128(a.v))));
#endif
        for (std::size_t i = 0; i < count; ++i)
            a.v[i] = std::sqrt(a.v[i]);
        return a;
    }

private:
    static Mask sign_bit() { return Mask(Lanes(Scalar(-0.0)).v); }
};

template <class Real>
struct ScalarOf {
    using Type = Real;
};
template <class Scalar, std::size_t bytes>
struct ScalarOf<Lanes<Scalar, bytes>> {
    using Type = Scalar;
};
/// The type of one lane; of a single real, its own.
template <class Real>
using Scalar = typename ScalarOf<Real>::Type;

/// What a comparison of two reals gives: bool, or a mask.
template <class Real>
using MaskOf = decltype(Real() < Real());

// The same for a single real.
template <class Real>
constexpr Real select(bool which, Real yes, Real no) {
    return which ? yes : no;
}
constexpr bool is_zero(double a) {
    return a == 0;
}
constexpr bool both(bool a, bool b) {
    return a && b;
}
template <class Mask>
    requires(!std::is_same_v<Mask, bool>)
[[gnu::always_inline]] inline Mask both(Mask a, Mask b) {
    return a & b;
}

} // namespace drawbead
