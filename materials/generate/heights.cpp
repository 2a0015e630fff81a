#include "heights.hpp"

#include <array>
#include <cmath>

#include "shaping.hpp"

namespace sg::samples {
namespace {

enum Purpose : std::uint32_t {
    kTiltS = 1,
    kTiltT,
    kLift,
    kGrain,
    kMortar,
    kWear,
    kPlaceS,
    kPlaceT,
    kSlant,
    kLength,
    kDepth
};

double centred_random(int i, int j, std::uint32_t purpose) {
    return 2.0 * random_of(i, j, purpose) - 1.0;
}

// Distance to the border of a box with round corners, positive inside.
double inside_round_box(double x, double y, double half_width, double half_height, double radius) {
    const double dx = std::abs(x) - (half_width - radius), dy = std::abs(y) - (half_height - radius);
    if (dx > 0.0 && dy > 0.0) return radius - std::sqrt(dx * dx + dy * dy);
    return radius - std::max(dx, dy);
}

}  // namespace

// Running bond, 3 bricks across and 6 courses. Each brick is worn at its edge (more so at its lower one),
// lies a little higher or lower than its neighbours, and leans.
double brick_height(double s, double t) {
    constexpr double kWidth = 1.0 / 3.0, kHeight = 1.0 / 6.0, kJoint = 0.010;
    const int course = static_cast<int>(std::floor(t / kHeight));
    const double shifted = s / kWidth - (wrap(course, 2) ? 0.5 : 0.0);
    const int brick = wrap(static_cast<int>(std::floor(shifted)), 3), row = wrap(course, 6);
    const double x = (fraction(shifted) - 0.5) * kWidth, y = (fraction(t / kHeight) - 0.5) * kHeight;
    const double wear = 0.004 * (value_noise(s, t, 24, kWear) - 0.5);
    const double edge = inside_round_box(x, y, 0.5 * kWidth - kJoint, 0.5 * kHeight - kJoint, 0.012) + wear;
    const double edge_width = 0.014 + 0.010 * smooth(clamp01(y / kHeight + 0.5));
    const double rise = bevel(edge / edge_width);
    const double face = 0.014 + 0.003 * centred_random(brick, row, kLift) +
                        0.030 * centred_random(brick, row, kTiltS) * x +
                        0.070 * centred_random(brick, row, kTiltT) * y +
                        0.0010 * value_noise(s, t, 64, kGrain) + 0.0018 * value_noise(s, t, 20, kGrain);
    const double mortar = 0.0016 * value_noise(s, t, 48, kMortar);
    return mix(mortar, face, rise);
}

namespace {

struct Scratch {
    double s, t;              // its middle
    double along_s, along_t;  // unit direction
    double half_length, half_width, depth;
};

constexpr int kScratches = 56;

// Most run towards the lower right, one in eight across.
std::array<Scratch, kScratches> make_scratches() {
    std::array<Scratch, kScratches> out{};
    for (int i = 0; i < kScratches; ++i) {
        const double slant = i % 8 ? 0.35 + 0.3 * centred_random(i, 0, kSlant) : -1.6;
        const double length = std::sqrt(1.0 + slant * slant);
        out[static_cast<std::size_t>(i)] = {random_of(i, 0, kPlaceS),
                                            random_of(i, 0, kPlaceT),
                                            1.0 / length,
                                            slant / length,
                                            0.08 + 0.34 * random_of(i, 0, kLength) * random_of(i, 1, kLength),
                                            0.004 + 0.004 * random_of(i, 0, kTiltS),
                                            0.0010 + 0.0022 * random_of(i, 0, kDepth)};
    }
    return out;
}

// A groove with a steep wall on its upper side, a gentle one on its lower side, where a burr is thrown up.
double groove(double across) {
    if (across < -1.0 || across > 2.0) return 0.0;
    if (across < 0.0) return -bevel(1.0 + across);
    if (across < 1.0) return -1.0 + 1.35 * smooth(across);
    return 0.35 * (1.0 - smooth(across - 1.0));
}

double scratch_at(const Scratch& scratch, double s, double t) {
    const double ds = wrapped_difference(s, scratch.s), dt = wrapped_difference(t, scratch.t);
    const double along = (ds * scratch.along_s + dt * scratch.along_t) / scratch.half_length;
    const double across = (dt * scratch.along_s - ds * scratch.along_t) / scratch.half_width;
    if (std::abs(along) >= 1.0) return 0.0;
    const double taper = 1.0 - along * along * along * along;  // most of it is full deep, both ends run out
    return scratch.depth * taper * groove(across);
}

}  // namespace

double scratch_height(double s, double t) {
    static const std::array<Scratch, kScratches> kAll = make_scratches();
    double lowest = 0.0, highest = 0.0;
    for (const Scratch& scratch : kAll) {
        const double height = scratch_at(scratch, s, t);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return lowest + highest + 0.0004 * value_noise(s, t, 40, kGrain);
}

namespace {

// Twill: a warp thread (running along t) passes over two wefts and under one; each next thread one crossing
// later.
bool warp_is_over(int warp, int weft, int threads) {
    return wrap(wrap(warp, threads) + wrap(weft, threads), 3) != 0;
}

// +1 where a thread is on top of a crossing, -1 where it is below, smooth in between. `x` counts crossings
// along it.
template <class IsOver>
double undulation(double x, IsOver is_over) {
    const double centre = std::floor(x - 0.5);
    const int i = static_cast<int>(centre);
    const double a = is_over(i) ? 1.0 : -1.0, b = is_over(i + 1) ? 1.0 : -1.0;
    return mix(a, b, smooth(x - 0.5 - centre));
}

// A round thread with a twist of fibres; `across` in [-1, 1], `along` in crossings.
double thread(double across, double along, double twist) {
    return 1.0 - across * across + 0.09 * wave(3.0 * along + twist * across);
}

}  // namespace

// Twill 2/1 of 6 warp and 6 weft threads, all fibres twisted the same way.
double weave_height(double s, double t) {
    constexpr int kThreads = 6;
    constexpr double kThickness = 0.030, kCover = 0.94;
    const double x = s * kThreads, y = t * kThreads;
    const int warp = static_cast<int>(std::floor(x)), weft = static_cast<int>(std::floor(y));
    const double across_warp = (fraction(x) - 0.5) * 2.0 / kCover,
                 across_weft = (fraction(y) - 0.5) * 2.0 / kCover;
    const double warp_lift = undulation(y, [&](int j) { return warp_is_over(warp, j, kThreads); });
    const double weft_lift = undulation(x, [&](int i) { return !warp_is_over(i, weft, kThreads); });
    const double up = thread(across_warp, y, 0.8) + 0.55 * warp_lift;
    const double sideways = thread(across_weft, x, -0.8) + 0.55 * weft_lift;
    return kThickness * std::max(std::max(up, sideways), -0.4);
}

namespace {

// Rises slowly along x and drops steeply at the end: a shark's fin. Period 1, from 0 to 1.
double fin(double x) {
    const double f = fraction(x);
    return f < 0.85 ? f / 0.85 : (1.0 - f) / 0.15;
}

// Distance inside of an upright letter F, in the unit square.
double inside_f(double x, double y) {
    const double stem = inside_box(x, y, 0.22, 0.10, 0.38, 0.90);
    const double upper_bar = inside_box(x, y, 0.22, 0.10, 0.80, 0.26);
    const double lower_bar = inside_box(x, y, 0.22, 0.44, 0.66, 0.60);
    return std::max(stem, std::max(upper_bar, lower_bar));
}

}  // namespace

// A chart of four panels on flat ground: a raised F (upper left), fins rising along +s (upper right), fins
// rising along +t (lower left), and a dome beside a smaller dent (lower right).
double ramp_height(double s, double t) {
    constexpr double kFin = 0.020;
    const double x = fraction(2.0 * s), y = fraction(2.0 * t);
    const bool right = fraction(s) >= 0.5, low = fraction(t) >= 0.5;
    const double panel = clamp01(inside_box(x, y, 0.08, 0.08, 0.92, 0.92) / 0.03);
    if (!right && !low) return 0.018 * bevel(inside_f(x, y) / 0.06);
    if (right && !low) return panel * kFin * fin((x - 0.08) / 0.21);
    if (low && !right) return panel * kFin * fin((y - 0.08) / 0.21);
    const double dome = 1.0 - ((x - 0.40) * (x - 0.40) + (y - 0.42) * (y - 0.42)) / (0.30 * 0.30);
    const double dent = 1.0 - ((x - 0.80) * (x - 0.80) + (y - 0.78) * (y - 0.78)) / (0.13 * 0.13);
    return 0.075 * std::max(dome, 0.0) - 0.030 * std::max(dent, 0.0);
}

namespace {

constexpr int kPebbles = 7;  // along each side

struct Pebble {
    int i = 0, j = 0;  // its cell, not wrapped
    double x = 0.0, y = 0.0;
};

Pebble pebble_of(int i, int j) {
    const int wi = wrap(i, kPebbles), wj = wrap(j, kPebbles);
    return {i, j, i + 0.5 + 0.36 * centred_random(wi, wj, kPlaceS),
            j + 0.5 + 0.36 * centred_random(wi, wj, kPlaceT)};
}

double squared_distance(const Pebble& p, double x, double y) {
    return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
}

Pebble nearest_pebble(double x, double y, int i, int j) {
    Pebble best = pebble_of(i, j);
    for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
            const Pebble other = pebble_of(i + di, j + dj);
            if (squared_distance(other, x, y) < squared_distance(best, x, y)) best = other;
        }
    }
    return best;
}

// Distance from (x, y) to the nearest line half way between `home` and another pebble, rounded where lines
// meet.
double distance_to_border(const Pebble& home, double x, double y) {
    double product = 1.0;
    for (int dj = -2; dj <= 2; ++dj) {
        for (int di = -2; di <= 2; ++di) {
            if (di == 0 && dj == 0) continue;
            const Pebble other = pebble_of(home.i + di, home.j + dj);
            const double apart = std::sqrt(squared_distance(other, home.x, home.y));
            const double distance =
                (squared_distance(other, x, y) - squared_distance(home, x, y)) / (2.0 * apart);
            product *= bevel((distance - 0.04) / 0.42);
        }
    }
    return product;
}

}  // namespace

// Rounded stones, packed, each with a height of its own and lower on its lower right side.
double pebble_height(double s, double t) {
    const double x = s * kPebbles, y = t * kPebbles;
    const Pebble home =
        nearest_pebble(x, y, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
    const int i = wrap(home.i, kPebbles), j = wrap(home.j, kPebbles);
    const double size = 0.022 + 0.014 * random_of(i, j, kLift);
    const double lean = 1.0 - 0.30 * ((x - home.x) + 0.6 * (y - home.y));
    return size * distance_to_border(home, x, y) * lean + 0.0012 * value_noise(s, t, 32, kGrain);
}

// A large and a small dome, each the part of a sphere within 60 degrees of its top.
double dome_height(double s, double t) {
    auto dome = [&](double at_s, double at_t, double radius) {
        const double ds = wrapped_difference(s, at_s), dt = wrapped_difference(t, at_t);
        const double square = radius * radius - ds * ds - dt * dt;
        return square > 0.25 * radius * radius ? std::sqrt(square) - 0.5 * radius : 0.0;
    };
    return std::max(dome(0.34, 0.36, 0.28), dome(0.78, 0.8, 0.14));
}

// Ribs that run along t, four to the tile.
double rib_height(double s, double) {
    return 0.016 * wave(4.0 * s);
}

// Wind on water: seven trains of waves, most towards +s and +t, steep in front and long behind.
double ripple_height(double s, double t) {
    struct Train {
        int along_s, along_t;
        double height, phase;
    };
    constexpr Train kTrains[] = {{1, 2, 0.0150, 0.15},
                                 {3, 1, 0.0120, 0.62},
                                 {2, 5, 0.0055, 0.37},
                                 {-1, 4, 0.0060, 0.81},
                                 {5, 2, 0.0040, 0.05}};
    double sum = 0.0;
    for (const Train& train : kTrains) {
        const double x = train.along_s * s + train.along_t * t + train.phase;
        sum += train.height * wave(x + 0.09 * wave(x + 0.25));
    }
    return sum;
}

}  // namespace sg::samples
