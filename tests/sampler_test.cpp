// SPDX-License-Identifier: MIT
#include "core/sampler.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

#include "core/rng.h"

using namespace tress;

TEST_CASE("every dimension has one value in each of 2^k intervals, over any aligned block of 2^k indices") {
    for (uint32_t dimension : {0u, 1u, 2u, 3u, 4u, 7u, 1001u})
        for (uint32_t bits = 0; bits <= 10; ++bits)
            for (uint32_t block : {0u, 1u, 5u}) {
                CAPTURE(dimension);
                CAPTURE(bits);
                CAPTURE(block);
                const uint32_t count = 1u << bits;
                std::set<uint32_t> intervals;
                for (uint32_t i = 0; i < count; ++i)
                    intervals.insert(uint32_t(sobol_sample(77, block * count + i, dimension) * float(count)));
                CHECK(intervals.size() == count);
            }
}

TEST_CASE("the first two dimensions of a group put one point in every elementary box") {
    for (uint64_t key : {0ull, 1ull, 0xdeadbeefull})
        for (uint32_t first : {0u, 4u, 40u})
            for (uint32_t bits = 1; bits <= 8; ++bits)
                for (uint32_t across = 0; across <= bits; ++across) {
                    const uint32_t count = 1u << bits, columns = 1u << across, rows = count / columns;
                    std::set<uint32_t> boxes;
                    for (uint32_t i = 0; i < count; ++i) {
                        const Vec2 p = sobol_sample2(key, 3 * count + i, first);
                        boxes.insert(uint32_t(p.x * float(columns)) * rows + uint32_t(p.y * float(rows)));
                    }
                    CAPTURE(bits);
                    CAPTURE(across);
                    CHECK(boxes.size() == count);
                }
}

TEST_CASE("128 points of a group put 8 into each of the 16 boxes cut once along every axis") {
    // The net of dimensions 1 to 4 has t = 3 (1 + 2 + 3 - 3 for polynomials of degrees 1, 2, 3): with 2^7 points every
    // box cut once along each of the four axes holds exactly 2^3.
    std::vector<int> count(16, 0);
    for (uint32_t i = 0; i < 128; ++i) {
        const glm::vec4 p = sobol_sample4(9, i, 8);
        ++count[size_t(p.x >= 0.5f) + 2 * size_t(p.y >= 0.5f) + 4 * size_t(p.z >= 0.5f) + 8 * size_t(p.w >= 0.5f)];
    }
    for (int n : count) CHECK(n == 8);
}

TEST_CASE("values are in [0, 1), and joint look-ups equal single ones") {
    const Sampler sampler{hash(3, 4), 0xffffffffu};
    const glm::vec4 four = sampler.get4(12);
    CHECK(sampler.get2(12) == Vec2(four.x, four.y));
    CHECK(sampler.get2(14) == Vec2(four.z, four.w));
    for (uint32_t dimension = 0; dimension < 4; ++dimension) CHECK(sampler.get(12 + dimension) == four[int(dimension)]);
    for (uint32_t i = 0; i < 100000; ++i) {
        const float value = sobol_sample(i, i * 2654435761u, i % 97);
        CHECK_UNARY(value >= 0);
        CHECK_UNARY(value < 1);
    }
}

namespace {

/// Correlation of two streams over `count` samples.
template <class A, class B>
double correlation(uint32_t count, const A& a, const B& b) {
    double sum = 0;
    for (uint32_t i = 0; i < count; ++i) sum += (double(a(i)) - 0.5) * (double(b(i)) - 0.5);
    return 12 * sum / count;
}

}  // namespace

TEST_CASE("keys, groups and first samples are uncorrelated") {
    // n independent pairs correlate with a deviation of n^-1/2; 4.5 deviations are met once in 150,000 tries.
    const uint32_t count = 4096;
    const double bound = 4.5 / std::sqrt(double(count));
    for (uint32_t other = 1; other <= 8; ++other) {
        CAPTURE(other);
        const auto base = [](uint32_t i) { return sobol_sample(0, i, 0); };
        CHECK(std::abs(correlation(count, base, [&](uint32_t i) { return sobol_sample(other, i, 0); })) < bound);
        CHECK(std::abs(correlation(count, base, [&](uint32_t i) { return sobol_sample(0, i, 4 * other); })) < bound);
        // The same sample of neighbouring keys, as of neighbouring pixels.
        CHECK(std::abs(correlation(
                  count, [](uint32_t i) { return sobol_sample(i, 0, 0); },
                  [&](uint32_t i) { return sobol_sample(i + other, 0, 0); })) < bound);
        // One key's first sample along two dimensions, of one group too.
        CHECK(std::abs(correlation(
                  count, [](uint32_t i) { return sobol_sample(i, 0, 0); },
                  [&](uint32_t i) { return sobol_sample(i, 0, other); })) < bound);
    }
}

TEST_CASE("over keys, every bit below the leading ones is as good as random") {
    // The scramble must flip a bit independently of its neighbours: of sample 0 and 1 the second bits agree half the
    // time.
    int agree = 0;
    const int keys = 1 << 14;
    for (int key = 0; key < keys; ++key) {
        const uint32_t a = uint32_t(sobol_sample(uint64_t(key), 0, 0) * 16),
                       b = uint32_t(sobol_sample(uint64_t(key), 1, 0) * 16);
        CHECK_UNARY((a >> 3) != (b >> 3));
        agree += ((a >> 2) & 1) == ((b >> 2) & 1);
    }
    CHECK(std::abs(agree - keys / 2) < 4.5 * 0.5 * std::sqrt(double(keys)));
}

TEST_CASE("the error of a smooth integral falls faster than 1 / N") {
    // Root mean square over keys of the error of the integral of x y^2 exp(z) over the unit cube. Scrambled nets give
    // about N^-3/2 for smooth integrands (Owen 1997); independent samples N^-1/2.
    const double exact = 0.5 / 3 * (std::exp(1.0) - 1);
    const auto error = [&](uint32_t count) {
        double squares = 0;
        const int keys = 64;
        for (int key = 0; key < keys; ++key) {
            double sum = 0;
            for (uint32_t i = 0; i < count; ++i) {
                const glm::dvec4 p(sobol_sample4(uint64_t(key), i, 0));
                sum += p.x * p.y * p.y * std::exp(p.z);
            }
            squares += square(sum / count - exact);
        }
        return std::sqrt(squares / keys);
    };
    const double few = error(64), many = error(4096);
    const double order = std::log(few / many) / std::log(64.0);
    MESSAGE("error at 64: ", few, ", at 4096: ", many, ", order ", order);
    CHECK(order > 1.2);
}
