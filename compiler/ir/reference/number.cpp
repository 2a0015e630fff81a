#include "ir/reference/number.hpp"

#include <cmath>

namespace sg::ref {

double divide(double a, double b) {
    return b == 0.0 || std::isnan(b) ? 0.0 : a / b;
}

double positive_power(double a, double b) {
    return a > 0.0 ? std::pow(a, b) : 0.0;
}

double smoothstep(double low, double high, double x) {
    if (low == high) return x >= low ? 1.0 : 0.0;
    const double t = (x - low) / (high - low);
    if (!(t > 0.0)) return 0.0;
    return t < 1.0 ? t * t * (3.0 - 2.0 * t) : 1.0;
}

}  // namespace sg::ref
