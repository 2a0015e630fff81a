struct Dent { float depth; };
const float kDepth = 2.0, kWidth[2] = float[2](1.0, 2.0);
float counter = 0.0;
vec3 dents(SgFrame frame) { return kDepth * frame.normal; }
