#version 450
#extension GL_GOOGLE_include_directive : require
// a decal on a plane: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
