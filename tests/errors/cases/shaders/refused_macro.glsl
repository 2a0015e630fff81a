#define DECLARE(name) vec3 name(SgFrame frame) { return frame.normal; }
DECLARE(dents)
