#version 450
#extension GL_GOOGLE_include_directive : require
// carved pebbles with fine pebbles on them: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
