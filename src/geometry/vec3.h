#pragma once
// Three reals. Sums run left to right and nothing is contracted, so results do not change with build flags.
#include <cmath>

namespace drawbead {

template <class Real>
struct BasicVec3 {
    Real x = 0, y = 0, z = 0;

    friend constexpr BasicVec3 operator+(BasicVec3 a, BasicVec3 b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr BasicVec3 operator-(BasicVec3 a, BasicVec3 b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr BasicVec3 operator-(BasicVec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr BasicVec3 operator*(Real s, BasicVec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr BasicVec3 operator*(BasicVec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr BasicVec3 operator/(BasicVec3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
    friend constexpr bool operator==(const BasicVec3&, const BasicVec3&) = default;
    constexpr BasicVec3& operator+=(BasicVec3 b) { return *this = *this + b; }
};

using Vec3 = BasicVec3<double>;

// The default serves calls with a list in braces, from which nothing can be deduced.
template <class Real = double>
constexpr Real dot(BasicVec3<Real> a, BasicVec3<Real> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real = double>
constexpr BasicVec3<Real> cross(BasicVec3<Real> a, BasicVec3<Real> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real = double>
constexpr Real squared_norm(BasicVec3<Real> a) {
    return dot(a, a);
}
template <class Real = double>
Real norm(BasicVec3<Real> a) {
    using std::sqrt;
    return sqrt(squared_norm(a));
}
template <class Real = double>
Real distance(BasicVec3<Real> a, BasicVec3<Real> b) {
    return norm(b - a);
}

} // namespace drawbead
