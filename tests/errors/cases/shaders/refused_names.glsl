float sg_mine() { return 1.0; }
void main() {}
vec3 dents(SgFrame frame) { return sg_mine() * frame.normal; }
