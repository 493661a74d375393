#version 130
uniform sampler2D uTexUnit0;
in vec3 nNormal;
in vec4 vPosition;
out vec4 fragColor;

vec3 reflect(vec3 w, vec3 n){
    return n*(dot(w,n)*2.0) - w; // bounce vector
}

void main() {
    vec3 normal = normalize(vNormal);
    vec3 reflected = reflect(normalize(vec3(-vPosition)), normal);
    vec4 texColor0 = textureCube(uTexUnit0, reflected);
    fragColor = vec4(texColor0.r, texColor0.g, texColor0.b, 1.0);
}
