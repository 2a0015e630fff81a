// From the sum of surface gradients to the bumped normal. Source: Mikkelsen 2020, Eq 5.
#ifndef SG_RESOLVE
#define SG_RESOLVE

// n' = normalize(n - g).
//   n: unit; g: the sum of all surface gradients, perpendicular to n.
// Result: unit for every finite input; where g is not a number or has no finite length, n itself.
// Cost: about 10 instructions. Source: Listing 1.
vec3 sg_resolve(vec3 n, vec3 g) {
    vec3 bumped = n - g;
    float square = dot(bumped, bumped);
    // Written so that the branch that NaN takes is the safe one; 1e30 keeps the square finite.
    bool usable = square > 1e-30 && square < 1e30;
    return usable ? bumped * inversesqrt(square) : n;
}

// "flip": the whole resolved normal turns with the side (glTF's rule). facing: +1 front, -1 back.
vec3 sg_flip(vec3 resolved, float facing) { return facing * resolved; }

// The normal of the inverted bump -H, from the normal of H: a mirror image of it about n. Source: end of section 3.
vec3 sg_invert(vec3 n, vec3 resolved) { return reflect(-resolved, n); }

#endif
