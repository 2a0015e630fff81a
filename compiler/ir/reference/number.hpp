// Arithmetic of the graph that is defined everywhere: where the mathematics has no answer, the answer is 0.
#pragma once

namespace sg::ref {

// a / b; 0 where b is 0 or not a number.
double divide(double a, double b);
// a^b for a > 0; 0 for any other a. (`power` of checked.hpp refuses those.)
double positive_power(double a, double b);
// The cubic from 0 at `low` to 1 at `high`, flat at both and beyond. low = high: a jump to 1 from x = low on.
// 0 where x is not a number.
double smoothstep(double low, double high, double x);

}  // namespace sg::ref
