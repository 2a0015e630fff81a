#version 450
#extension GL_GOOGLE_include_directive : require
// magnified heights, forward: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
