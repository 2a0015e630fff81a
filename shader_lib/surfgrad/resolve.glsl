// From the sum of surface gradients to the bumped normal. Source: Mikkelsen 2020, Eq 5.
#ifndef SG_RESOLVE
#define SG_RESOLVE

// n' = normalize(n - g).
//   n: unit; g: the sum of all surface gradients, perpendicular to n.
// Result: unit for every g: where g is not a number or longer than 1e19, n itself; dot(result, n) >= 0 within rounding.
// Cost: 17 instructions. Source: Listing 1.
vec3 sg_resolve(vec3 n, vec3 g) {
    vec3 bumped = n - g;
    float square = dot(bumped, bumped);
    // False for not-a-number: then n.
    return square > 1e-30 && square < 1e38 ? bumped * inversesqrt(square) : n;
}

// "flip": the whole resolved normal turns with the side (glTF's rule).
//   resolved: unit; facing: +1 front, -1 back. Result: unit. Cost: 3 instructions.
//   Source: glTF 2.0, section 3.9.5 (double sided).
vec3 sg_flip(vec3 resolved, float facing) { return facing * resolved; }

// The normal of the inverted bump -H, from the normal of H: its mirror image about n.
//   n, resolved: unit. Result: unit. Cost: 7 instructions. Source: end of section 3.
vec3 sg_invert(vec3 n, vec3 resolved) { return 2.0 * dot(n, resolved) * n - resolved; }

#endif
