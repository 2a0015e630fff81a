// Arithmetic that every target agrees on, at the edges too.
// Source: the GLSL specification, 8.2 and 8.3, with a result where it leaves one undefined.
#ifndef SG_NUMBER
#define SG_NUMBER

// a / b.
//   a, b: any. Result: 0 where b is 0 or not a number. Cost: 4 instructions.
//   Source: the GLSL specification, section 5.9, with a result where it leaves one undefined.
float sg_divide(float a, float b) { return abs(b) > 0.0 ? a / b : 0.0; }

// a^b.
//   a: any, b: any. Result: 0 where a <= 0 or a is not a number (pow is undefined there), also for b = 0.
//   Cost: 5 instructions. Source: the GLSL specification, section 8.2, with a result where it leaves one undefined.
float sg_power(float a, float b) { return a > 0.0 ? pow(a, b) : 0.0; }

// A smooth step from 0 at `low` to 1 at `high`.
//   low, high, x: any. Result: 0..1; falls where low > high; where they are equal a jump to 1 from x >= low on; 0 where
//   any of the three is not a number.
// Cost: 18 instructions. Source: the GLSL specification, section 8.3, with a result where it leaves one undefined.
float sg_smoothstep(float low, float high, float x) {
    float width = high - low;
    // Without a width the edges are equal, or one of them is not a number: then x is behind neither.
    float t = abs(width) > 0.0 ? (x - low) / width : (x >= low && x >= high ? 1.0 : 0.0);
    float inside = t < 1.0 ? t : 1.0;
    float clamped = t > 0.0 ? inside : 0.0;
    return clamped * clamped * (3.0 - 2.0 * clamped);
}

#endif
