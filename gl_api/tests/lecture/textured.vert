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
