#version 130

uniform sampler2D uTexUnit0;
in vec2 vTexCoord;
out vec4 fragColor;
void main() {
    vec4 texColor0 = texture2D(uTexUnit0, vTexCoord);
    fragColor = texColor0;
}
