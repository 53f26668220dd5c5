// Vectors of eight numbers for the engines' loops, which include this file with STRIDOR_ISA and STRIDOR_WIDTH set: one
// register of AVX-512, two of AVX2, four of the baseline.

#pragma once

// a call would pass vectors through memory
#define STRIDOR_INLINE inline __attribute__((always_inline))

namespace stridor::integration::STRIDOR_ISA {

namespace {

// as many numbers as a register of the set holds
constexpr int width = STRIDOR_WIDTH;
constexpr int parts = lanes / width;
using Part = double __attribute__((vector_size(width * sizeof(double))));

// eight numbers
struct Vector {
    Part part[parts];
};

STRIDOR_INLINE Vector load(const double* numbers) {
    // part by part: a copy of the whole would go through memory in other pieces
    Vector v;
    for (int k = 0; k < parts; ++k)
        __builtin_memcpy(&v.part[k], numbers + k * width, sizeof(Part));
    return v;
}

STRIDOR_INLINE Vector load(const Lanes& lane) {
    return load(lane.at);
}

STRIDOR_INLINE void save(const Vector& v, double* numbers) {
    for (int k = 0; k < parts; ++k)
        __builtin_memcpy(numbers + k * width, &v.part[k], sizeof(Part));
}

STRIDOR_INLINE void save(const Vector& v, Lanes& lane) {
    save(v, lane.at);
}

STRIDOR_INLINE Vector of(double a, double b, double c, double d, double e, double f, double g, double h) {
    const double numbers[lanes] = {a, b, c, d, e, f, g, h};
    Vector v;
    for (int k = 0; k < parts; ++k)
        for (int i = 0; i < width; ++i)
            v.part[k][i] = numbers[k * width + i];
    return v;
}

template <typename Each>
STRIDOR_INLINE Vector each(Each operation) {
    Vector v;
    for (int k = 0; k < parts; ++k)
        v.part[k] = operation(k);
    return v;
}

STRIDOR_INLINE Vector operator+(const Vector& a, const Vector& b) {
    return each([&](int k) { return a.part[k] + b.part[k]; });
}
STRIDOR_INLINE Vector operator+(const Vector& a, double b) {
    return each([&](int k) { return a.part[k] + b; });
}
STRIDOR_INLINE Vector operator-(const Vector& a, const Vector& b) {
    return each([&](int k) { return a.part[k] - b.part[k]; });
}
STRIDOR_INLINE Vector operator*(const Vector& a, const Vector& b) {
    return each([&](int k) { return a.part[k] * b.part[k]; });
}
STRIDOR_INLINE Vector operator*(const Vector& a, double b) {
    return each([&](int k) { return a.part[k] * b; });
}
STRIDOR_INLINE Vector larger(const Vector& a, const Vector& b) {
    return each([&](int k) { return a.part[k] > b.part[k] ? a.part[k] : b.part[k]; });
}
STRIDOR_INLINE Vector smaller(const Vector& a, const Vector& b) {
    return each([&](int k) { return a.part[k] < b.part[k] ? a.part[k] : b.part[k]; });
}

// a part with its halves exchanged, then its quarters, then its eighths: after combining with
// itself, all lanes are alike
template <int step>
STRIDOR_INLINE Part exchanged(const Part& p) {
#if STRIDOR_WIDTH == 2
    return __builtin_shufflevector(p, p, 0 ^ step, 1 ^ step);
#elif STRIDOR_WIDTH == 4
    return __builtin_shufflevector(p, p, 0 ^ step, 1 ^ step, 2 ^ step, 3 ^ step);
#else
    return __builtin_shufflevector(p, p, 0 ^ step, 1 ^ step, 2 ^ step, 3 ^ step, 4 ^ step, 5 ^ step, 6 ^ step,
                                   7 ^ step);
#endif
}

template <typename Combine>
STRIDOR_INLINE double reduced(const Vector& v, Combine combine) {
    Part all = v.part[0];
    for (int k = 1; k < parts; ++k)
        all = combine(all, v.part[k]);
    if constexpr (width >= 8) all = combine(all, exchanged<4>(all));
    if constexpr (width >= 4) all = combine(all, exchanged<2>(all));
    all = combine(all, exchanged<1>(all));
    return all[0];
}

STRIDOR_INLINE double largest(const Vector& v) {
    return reduced(v, [](const Part& a, const Part& b) -> Part { return a > b ? a : b; });
}

STRIDOR_INLINE double smallest(const Vector& v) {
    return reduced(v, [](const Part& a, const Part& b) -> Part { return a < b ? a : b; });
}

// (v0 + v1) + (v2 + v3) and (v4 + v5) + (v6 + v7)
STRIDOR_INLINE void sums_of_four(const Vector& v, double& first, double& second) {
    if constexpr (width >= 4) {
        const auto sum = [](Part p) {
            p = p + exchanged<1>(p);
            return Part(p + exchanged<2>(p));
        };
        first = sum(v.part[0])[0];
        second = width == 8 ? sum(v.part[0])[4 % width] : sum(v.part[parts - 1])[0];
    } else {
        alignas(64) double n[lanes];
        save(v, n);
        first = (n[0] + n[1]) + (n[2] + n[3]);
        second = (n[4] + n[5]) + (n[6] + n[7]);
    }
}

}  // namespace

}  // namespace stridor::integration::STRIDOR_ISA
