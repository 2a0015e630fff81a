// Angles between pictures of normals: per pixel, as numbers, and as a picture with a scale.
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "runtime/picture.hpp"

namespace sg::proof {

// Degrees per pixel, rows from the top; not a number where neither picture has anything.
struct Angles {
    std::uint32_t width = 0, height = 0;
    std::vector<double> degrees;

    Angles(std::uint32_t w, std::uint32_t h)
        : width(w), height(h), degrees(std::size_t{w} * h, std::numeric_limits<double>::quiet_NaN()) {}
    [[nodiscard]] double& at(std::uint32_t x, std::uint32_t y) { return degrees[std::size_t{y} * width + x]; }
    [[nodiscard]] double at(std::uint32_t x, std::uint32_t y) const {
        return degrees[std::size_t{y} * width + x];
    }
};

// Degrees between two vectors of any length; 180 where one is zero or not finite.
double angle_degrees(glm::dvec3 a, glm::dvec3 b);

// Between two pictures of one size. A pixel that only one of them shows counts as 180.
Angles angles_between(const runtime::Picture& a, const runtime::Picture& b);

struct Numbers {
    double median = 0, p95 = 0, p99 = 0, max = 0;  // degrees; 0 without pixels
    std::size_t count = 0;
};
Numbers numbers_of(std::vector<double> degrees);  // those that are numbers
// "median 0.012  p95 0.034  p99 0.056  max 1.2 degrees, 1234 pixels"
std::string text_of(const Numbers& numbers);

// The least of 0.01, 0.02, 0.05, 0.1, ... 180 that is not below the angle.
double round_scale(double degrees);
// For the eye: from black (0) over violet, red and yellow to white (`scale` and more); transparent where
// there is nothing. Below the picture, if it is at least 96 pixels wide, a bar that says so in degrees.
asset::Image angle_map(const Angles& angles, double scale);
// Raw degrees in red, green and blue, alpha 1 where there is an angle.
runtime::Picture angle_values(const Angles& angles);

}  // namespace sg::proof
