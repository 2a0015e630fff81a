// Fresh random numbers for every run. The seed is printed; SG_SEED=<number> in the environment repeats a run.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <random>
#include <string_view>

namespace sg::proof {

// This run's seed: SG_SEED, or fresh entropy. Printed on first use.
std::uint64_t run_seed();

class Random {
public:
    // Each name has its own stream, so that one case repeats alone as it did among others.
    explicit Random(std::string_view name);

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    // Every order of magnitude between low and high (both positive) is equally likely.
    double magnitude(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    double sign() { return coin() ? 1.0 : -1.0; }
    bool coin() { return below(2) == 0; }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

    glm::dvec2 direction2() {
        double angle = uniform(0.0, 2.0 * 3.14159265358979323846);
        return {std::cos(angle), std::sin(angle)};
    }
    // Uniform on the unit sphere.
    glm::dvec3 direction() {
        double z = uniform(-1.0, 1.0);
        return {direction2() * std::sqrt(1.0 - z * z), z};
    }
    glm::dvec3 within(double half) {
        return {uniform(-half, half), uniform(-half, half), uniform(-half, half)};
    }

    // Anything a register can hold: zeros, denormals, huge and tiny numbers, infinities, not-a-number.
    float wild() {
        static constexpr float kSpecial[] = {0.0f,
                                             -0.0f,
                                             1.0f,
                                             -1.0f,
                                             1e-45f,
                                             1e-38f,
                                             -1e-30f,
                                             1e30f,
                                             -1e38f,
                                             3e38f,
                                             128.0f,
                                             std::numeric_limits<float>::infinity(),
                                             -std::numeric_limits<float>::infinity(),
                                             std::numeric_limits<float>::quiet_NaN()};
        if (coin()) return kSpecial[below(static_cast<int>(std::size(kSpecial)))];
        return static_cast<float>(sign() * magnitude(1e-30, 1e30));
    }

    // The same, numbers alone.
    float wild_number() {
        for (;;)
            if (const float x = wild(); std::isfinite(x)) return x;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace sg::proof
