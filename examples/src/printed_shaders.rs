//! The shaders of *CS380, Texture Mapping*, exactly as its slides print them, mistakes included.

/// Slide 14: a matrix times a `vec2`.
pub const SQUARE_VERTEX_SHADER: &str = "\
#version 130
uniform float uVertexScale;
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec2 aVertex;
in vec2 aTexCoord;
in vec3 aColor;
out vec3 vColor;
out vec2 vTexCoord;

void main()
{
    gl_Position = vec4(uProjMatrix * uModelViewMatrix * aVertex);
    vColor = aColor;
    vTexCoord = aTexCoord;
}
";

/// Slide 15.
pub const SQUARE_FRAGMENT_SHADER: &str = "\
#version 130

uniform sampler2D uTexUnit0;
in vec2 vTexCoord;
out vec4 fragColor;

void main() {
    vec4 texColor0 = texture2D(uTexUnit0, vTexCoord);
    fragColor = texColor0;
}
";

/// Slide 22: a `sampler2D` handed to `textureCube`, `nNormal` for `vNormal`.
pub const ENVIRONMENT_FRAGMENT_SHADER: &str = "\
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
";

/// Slide 30: `aTexCoord` is declared, `vTexCoord` written.
pub const PROJECTOR_VERTEX_SHADER: &str = "\
#version 130

uniform mat4 uModelViewMatrix;
uniform mat4 uProjMatrix;

uniform mat4 uSProjMatrix;
uniform mat4 uSModelViewMatrix;

in vec4 aVertex;
out vec4 aTexCoord;

void main(){
    vTexCoord = uSProjMatrix * uSModelViewMatrix * aVertex;
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

/// Slide 31: `vTexUnit0` for `uTexUnit0`, and names as in the vertex shader.
pub const PROJECTOR_FRAGMENT_SHADER: &str = "\
#version 130

uniform sampler2D vTexUnit0;

in vec4 aTexCoord;
out vec4 fragColor;

void main(){
    vec2 tex2;
    tex2.x = vTexCoord.x/vTexCoord.w;
    tex2.y = vTexCoord.y/vTexCoord.w;
    vec4 texColor0 = texture2D(vTexUnit0, tex2);
    fragColor = texColor0;
}
";

/// Not the lecture's, which prints no vertex shader for slide 22.
pub const ENVIRONMENT_VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uProjMatrix;
uniform mat4 uModelViewMatrix;
in vec4 aVertex;
in vec3 aNormal;
out vec3 vNormal;
out vec4 vPosition;

void main() {
    vNormal = vec3(uModelViewMatrix * vec4(aNormal, 0.0));
    vPosition = uModelViewMatrix * aVertex;
    gl_Position = uProjMatrix * vPosition;
}
";
