#version 330 core

in vec4 face_colour;
out vec4 result;

void main() { result = face_colour; }
