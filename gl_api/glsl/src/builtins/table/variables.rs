//! The variables (GLSL 1.30 chapter 7): name, type, stages, availability, access, what it stands for.

use crate::builtins::variable::Access::{ReadOnly, ReadWrite};
use crate::builtins::variable::Builtin::{
    self, ClipDistance, ClipVertex, CullDistance, FragColor, FragCoord, FragData, FragDepth,
    FragStencilRef, FrontFacing, InstanceId, Layer, PointCoord, PointSize, Position, PrimitiveId,
    PrimitiveIdIn, SampleCount, SampleId, SampleMask, SamplePosition, SecondaryFragColor,
    SecondaryFragData, State, Varying, VertexId, ViewportIndex,
};
use crate::builtins::variable::StateArray::{self, EnvColor, TextureMatrix};
use crate::builtins::variable::VariableType::{
    self, Bool, Int, Ints, Mat, Mat4Array, OfVertices, Struct, StructArray, UnsizedFloats, Vec,
    Vec4Array,
};
use crate::builtins::variable::{Access, Incoming, Structure, VariableRow};
use crate::interface::MatrixForm::{Inverse, InverseTranspose, Plain, Transpose};
use crate::interface::Side::{Back, Front};
use crate::interface::StateMatrix::{ModelView, ModelViewProjection, Projection};
use crate::interface::StateVar::{
    self, DepthRange, Fog, LightModel, LightModelProduct, Material, Matrix, NormalMatrix,
    NormalScale, Point,
};
use crate::interface::TexCoord::{Q, R, S, T};
use crate::interface::TexGenPlane::{Eye, Object};
use crate::interface::{
    ATTRIB_COLOR, ATTRIB_FOG_COORD, ATTRIB_NORMAL, ATTRIB_SECONDARY_COLOR, ATTRIB_TEX_COORD,
    ATTRIB_VERTEX, VARYING_BACK_COLOR, VARYING_COLOR, VARYING_FOG, VARYING_SECONDARY_COLOR,
    VARYING_TEX_COORD,
};
use crate::language::Stages::{self, Any, Fragment, Geometry, Vertex, Vertices};
use crate::language::{Availability, EsVersions, Extension};
use crate::limits::{
    MAX_CLIP_DISTANCES, MAX_CLIP_PLANES, MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_CULL_DISTANCES,
    MAX_DRAW_BUFFERS, MAX_DUAL_SOURCE_DRAW_BUFFERS, MAX_GEOMETRY_OUTPUT_VERTICES,
    MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS, MAX_LIGHTS, MAX_SAMPLE_MASK_WORDS, MAX_STAGE_COMPONENTS,
    MAX_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_UNITS, MAX_UNIFORM_COMPONENTS, MAX_VARYING_FLOATS,
    MAX_VERTEX_ATTRIBS, MAX_VIEWPORTS, TEXEL_OFFSETS,
};

const DESKTOP_AND_ES: Availability = Availability::DESKTOP_AND_ES;
const DESKTOP: Availability = Availability::DESKTOP;
const V120: Availability = Availability::V120;
const V130: Availability = Availability::V130;
const V150: Availability = Availability::V150;
const DESKTOP_AND_ES_100: Availability = Availability::DESKTOP_AND_ES_100;
const ES: Availability = Availability::ES;
const ES_100: Availability = ES.and_es(EsVersions::Only100);
const ES_300: Availability = ES.and_es(EsVersions::From300);
/// Not in the core profile.
const COMPATIBILITY: Availability = DESKTOP.in_compatibility();
const DRAW_INSTANCED: Availability = Availability::extension(Extension::DrawInstanced);
const INSTANCE_ID: Availability = Availability::V140
    .or(Extension::DrawInstanced)
    .or(Extension::GpuShader4)
    .and_es(EsVersions::From300);
const VERTEX_ID: Availability =
    Availability::V130.or(Extension::GpuShader4).and_es(EsVersions::From300);
const FRAG_DEPTH_EXT: Availability = Availability::extension(Extension::FragDepth);
const CULL_DISTANCE: Availability = Availability::extension(Extension::CullDistance);
const CLIP_DISTANCE: Availability = V130.or(Extension::ClipDistance);
const VIEWPORT_ARRAY: Availability = Availability::extension(Extension::ViewportArray);
const VERTEX_LAYER: Availability = Availability::extension(Extension::AmdVertexShaderLayer);
const VERTEX_VIEWPORT: Availability =
    Availability::extension(Extension::AmdVertexShaderViewportIndex);
const FRAGMENT_LAYER: Availability = Availability::extension(Extension::FragmentLayerViewport);
const SECOND_COLOR: Availability = Availability::extension(Extension::EsBlendFuncExtended);
const SECOND_COLOR_100: Availability = SECOND_COLOR.extended_in(EsVersions::Only100);
const SAMPLE_SHADING: Availability = Availability::extension(Extension::SampleShading);
const STENCIL_EXPORT: Availability = Availability::extension(Extension::ShaderStencilExport);

/// A `vec4` for each texture unit.
const PER_UNIT: VariableType = Vec4Array(MAX_TEXTURE_UNITS);

const POINT: Structure = Structure {
    name: "gl_PointParameters",
    members: &[
        ("size", 1),
        ("sizeMin", 1),
        ("sizeMax", 1),
        ("fadeThresholdSize", 1),
        ("distanceConstantAttenuation", 1),
        ("distanceLinearAttenuation", 1),
        ("distanceQuadraticAttenuation", 1),
    ],
};
const MATERIAL: Structure = Structure {
    name: "gl_MaterialParameters",
    members: &[("emission", 4), ("ambient", 4), ("diffuse", 4), ("specular", 4), ("shininess", 1)],
};
const LIGHT_MODEL: Structure =
    Structure { name: "gl_LightModelParameters", members: &[("ambient", 4)] };
const LIGHT_MODEL_PRODUCT: Structure =
    Structure { name: "gl_LightModelProducts", members: &[("sceneColor", 4)] };
const FOG: Structure = Structure {
    name: "gl_FogParameters",
    members: &[("color", 4), ("density", 1), ("start", 1), ("end", 1), ("scale", 1)],
};
const LIGHT_SOURCE: Structure = Structure {
    name: "gl_LightSourceParameters",
    members: &[
        ("ambient", 4),
        ("diffuse", 4),
        ("specular", 4),
        ("position", 4),
        ("halfVector", 4),
        ("spotDirection", 3),
        ("spotExponent", 1),
        ("spotCutoff", 1),
        ("spotCosCutoff", 1),
        ("constantAttenuation", 1),
        ("linearAttenuation", 1),
        ("quadraticAttenuation", 1),
    ],
};
const LIGHT_PRODUCT: Structure = Structure {
    name: "gl_LightProducts",
    members: &[("ambient", 4), ("diffuse", 4), ("specular", 4)],
};
const DEPTH_RANGE: Structure =
    Structure { name: "gl_DepthRangeParameters", members: &[("near", 1), ("far", 1), ("diff", 1)] };

const fn row(
    name: &'static str,
    ty: VariableType,
    stages: Stages,
    availability: Availability,
    access: Access,
    builtin: Builtin,
) -> VariableRow {
    VariableRow { name, ty, stages, availability, access, builtin }
}

/// A conventional attribute of so many floats.
const fn attribute(name: &'static str, size: u8, location: u8) -> VariableRow {
    row(name, Vec(size), Vertex, COMPATIBILITY, ReadOnly, Builtin::Attribute(location))
}

/// A piece of state.
const fn state(name: &'static str, ty: VariableType, state: StateVar) -> VariableRow {
    row(name, ty, Any, COMPATIBILITY, ReadOnly, State(state))
}

/// State of each texture unit, light or plane.
const fn states(name: &'static str, ty: VariableType, states: StateArray) -> VariableRow {
    row(name, ty, Any, COMPATIBILITY, ReadOnly, Builtin::States(states))
}

/// What the fragment stage writes.
const fn output(
    name: &'static str,
    ty: VariableType,
    availability: Availability,
    builtin: Builtin,
) -> VariableRow {
    row(name, ty, Fragment, availability, ReadWrite, builtin)
}

/// A constant.
const fn limit(name: &'static str, value: i32, availability: Availability) -> VariableRow {
    row(name, Int, Any, availability, ReadOnly, Builtin::Limit(value))
}

/// A member of `gl_in`.
const fn incoming(
    name: &'static str,
    ty: VariableType,
    availability: Availability,
    member: Incoming,
) -> VariableRow {
    row(name, ty, Geometry, availability, ReadOnly, Builtin::Incoming(member))
}

/// A member of `gl_in` that the core profile does not have.
const fn old(name: &'static str, ty: VariableType, member: Incoming) -> VariableRow {
    incoming(name, ty, V150.in_compatibility(), member)
}

/// Every variable, of all stages.
pub static VARIABLES: [VariableRow; 141] = [
    row("gl_Position", Vec(4), Vertices, DESKTOP_AND_ES, ReadWrite, Position),
    row("gl_PointSize", Vec(1), Vertices, DESKTOP_AND_ES, ReadWrite, PointSize),
    row("gl_ClipVertex", Vec(4), Vertices, COMPATIBILITY, ReadWrite, ClipVertex),
    row("gl_VertexID", Int, Vertex, VERTEX_ID, ReadOnly, VertexId),
    row("gl_InstanceIDARB", Int, Vertex, DRAW_INSTANCED, ReadOnly, InstanceId),
    row("gl_InstanceID", Int, Vertex, INSTANCE_ID, ReadOnly, InstanceId),
    row("gl_ClipDistance", UnsizedFloats, Vertices, CLIP_DISTANCE, ReadWrite, ClipDistance),
    row("gl_ClipDistance", UnsizedFloats, Fragment, CLIP_DISTANCE, ReadOnly, ClipDistance),
    row("gl_CullDistance", UnsizedFloats, Vertices, CULL_DISTANCE, ReadWrite, CullDistance),
    row("gl_CullDistance", UnsizedFloats, Fragment, CULL_DISTANCE, ReadOnly, CullDistance),
    // Conventional attributes
    attribute("gl_Vertex", 4, ATTRIB_VERTEX),
    attribute("gl_Normal", 3, ATTRIB_NORMAL),
    attribute("gl_Color", 4, ATTRIB_COLOR),
    attribute("gl_SecondaryColor", 4, ATTRIB_SECONDARY_COLOR),
    attribute("gl_FogCoord", 1, ATTRIB_FOG_COORD),
    attribute("gl_MultiTexCoord0", 4, ATTRIB_TEX_COORD),
    attribute("gl_MultiTexCoord1", 4, ATTRIB_TEX_COORD + 1),
    attribute("gl_MultiTexCoord2", 4, ATTRIB_TEX_COORD + 2),
    attribute("gl_MultiTexCoord3", 4, ATTRIB_TEX_COORD + 3),
    attribute("gl_MultiTexCoord4", 4, ATTRIB_TEX_COORD + 4),
    attribute("gl_MultiTexCoord5", 4, ATTRIB_TEX_COORD + 5),
    attribute("gl_MultiTexCoord6", 4, ATTRIB_TEX_COORD + 6),
    attribute("gl_MultiTexCoord7", 4, ATTRIB_TEX_COORD + 7),
    // Built-in varyings
    row("gl_FrontColor", Vec(4), Vertices, COMPATIBILITY, ReadWrite, Varying(VARYING_COLOR)),
    row("gl_BackColor", Vec(4), Vertices, COMPATIBILITY, ReadWrite, Varying(VARYING_BACK_COLOR)),
    row(
        "gl_FrontSecondaryColor",
        Vec(4),
        Vertices,
        COMPATIBILITY,
        ReadWrite,
        Varying(VARYING_SECONDARY_COLOR),
    ),
    row(
        "gl_BackSecondaryColor",
        Vec(4),
        Vertices,
        COMPATIBILITY,
        ReadWrite,
        Varying(VARYING_BACK_COLOR + 4),
    ),
    row("gl_TexCoord", PER_UNIT, Vertices, COMPATIBILITY, ReadWrite, Varying(VARYING_TEX_COORD)),
    row("gl_FogFragCoord", Vec(1), Vertices, COMPATIBILITY, ReadWrite, Varying(VARYING_FOG)),
    row("gl_Color", Vec(4), Fragment, COMPATIBILITY, ReadOnly, Varying(VARYING_COLOR)),
    row(
        "gl_SecondaryColor",
        Vec(4),
        Fragment,
        COMPATIBILITY,
        ReadOnly,
        Varying(VARYING_SECONDARY_COLOR),
    ),
    row("gl_TexCoord", PER_UNIT, Fragment, COMPATIBILITY, ReadOnly, Varying(VARYING_TEX_COORD)),
    row("gl_FogFragCoord", Vec(1), Fragment, COMPATIBILITY, ReadOnly, Varying(VARYING_FOG)),
    // The geometry stage
    row("gl_PrimitiveIDIn", Int, Geometry, V150, ReadOnly, PrimitiveIdIn),
    row("gl_PrimitiveID", Int, Geometry, V150, ReadWrite, PrimitiveId),
    row("gl_Layer", Int, Geometry, V150, ReadWrite, Layer),
    row("gl_Layer", Int, Vertex, VERTEX_LAYER, ReadWrite, Layer),
    row("gl_Layer", Int, Fragment, FRAGMENT_LAYER, ReadOnly, Layer),
    row("gl_ViewportIndex", Int, Geometry, VIEWPORT_ARRAY, ReadWrite, ViewportIndex),
    row("gl_ViewportIndex", Int, Vertex, VERTEX_VIEWPORT, ReadWrite, ViewportIndex),
    row("gl_ViewportIndex", Int, Fragment, FRAGMENT_LAYER, ReadOnly, ViewportIndex),
    incoming("gl_in.gl_Position", OfVertices(&Vec(4)), V150, Incoming::Position),
    incoming("gl_in.gl_PointSize", OfVertices(&Vec(1)), V150, Incoming::PointSize),
    incoming("gl_in.gl_ClipDistance", OfVertices(&UnsizedFloats), V150, Incoming::ClipDistance),
    incoming(
        "gl_in.gl_CullDistance",
        OfVertices(&UnsizedFloats),
        CULL_DISTANCE,
        Incoming::CullDistance,
    ),
    old("gl_in.gl_ClipVertex", OfVertices(&Vec(4)), Incoming::ClipVertex),
    old("gl_in.gl_FrontColor", OfVertices(&Vec(4)), Incoming::Varying(VARYING_COLOR)),
    old("gl_in.gl_BackColor", OfVertices(&Vec(4)), Incoming::Varying(VARYING_BACK_COLOR)),
    old(
        "gl_in.gl_FrontSecondaryColor",
        OfVertices(&Vec(4)),
        Incoming::Varying(VARYING_SECONDARY_COLOR),
    ),
    old(
        "gl_in.gl_BackSecondaryColor",
        OfVertices(&Vec(4)),
        Incoming::Varying(VARYING_BACK_COLOR + 4),
    ),
    old("gl_in.gl_TexCoord", OfVertices(&PER_UNIT), Incoming::Varying(VARYING_TEX_COORD)),
    old("gl_in.gl_FogFragCoord", OfVertices(&Vec(1)), Incoming::Varying(VARYING_FOG)),
    // The fragment stage
    row("gl_FragCoord", Vec(4), Fragment, DESKTOP_AND_ES, ReadOnly, FragCoord),
    row("gl_PrimitiveID", Int, Fragment, V150.or(Extension::GpuShader4), ReadOnly, PrimitiveId),
    row("gl_FrontFacing", Bool, Fragment, DESKTOP_AND_ES, ReadOnly, FrontFacing),
    row("gl_PointCoord", Vec(2), Fragment, V120.and_es(EsVersions::All), ReadOnly, PointCoord),
    output("gl_FragColor", Vec(4), DESKTOP_AND_ES_100, FragColor),
    output("gl_FragData", Vec4Array(MAX_DRAW_BUFFERS), DESKTOP_AND_ES_100, FragData),
    output("gl_FragDepth", Vec(1), DESKTOP.and_es(EsVersions::From300), FragDepth),
    output("gl_FragDepthEXT", Vec(1), FRAG_DEPTH_EXT, FragDepth),
    output("gl_SecondaryFragColorEXT", Vec(4), SECOND_COLOR_100, SecondaryFragColor),
    output(
        "gl_SecondaryFragDataEXT",
        Vec4Array(MAX_DUAL_SOURCE_DRAW_BUFFERS),
        SECOND_COLOR_100,
        SecondaryFragData,
    ),
    row("gl_SampleID", Int, Fragment, SAMPLE_SHADING, ReadOnly, SampleId),
    row("gl_SamplePosition", Vec(2), Fragment, SAMPLE_SHADING, ReadOnly, SamplePosition),
    output("gl_SampleMask", Ints(MAX_SAMPLE_MASK_WORDS), SAMPLE_SHADING, SampleMask),
    row("gl_NumSamples", Int, Fragment, SAMPLE_SHADING, ReadOnly, SampleCount),
    output("gl_FragStencilRefARB", Int, STENCIL_EXPORT, FragStencilRef),
    // State of the context (GLSL 1.30 section 7.4)
    state("gl_ModelViewMatrix", Mat(4), Matrix(ModelView, Plain)),
    state("gl_ModelViewMatrixInverse", Mat(4), Matrix(ModelView, Inverse)),
    state("gl_ModelViewMatrixTranspose", Mat(4), Matrix(ModelView, Transpose)),
    state("gl_ModelViewMatrixInverseTranspose", Mat(4), Matrix(ModelView, InverseTranspose)),
    state("gl_ProjectionMatrix", Mat(4), Matrix(Projection, Plain)),
    state("gl_ProjectionMatrixInverse", Mat(4), Matrix(Projection, Inverse)),
    state("gl_ProjectionMatrixTranspose", Mat(4), Matrix(Projection, Transpose)),
    state("gl_ProjectionMatrixInverseTranspose", Mat(4), Matrix(Projection, InverseTranspose)),
    state("gl_ModelViewProjectionMatrix", Mat(4), Matrix(ModelViewProjection, Plain)),
    state("gl_ModelViewProjectionMatrixInverse", Mat(4), Matrix(ModelViewProjection, Inverse)),
    state("gl_ModelViewProjectionMatrixTranspose", Mat(4), Matrix(ModelViewProjection, Transpose)),
    state(
        "gl_ModelViewProjectionMatrixInverseTranspose",
        Mat(4),
        Matrix(ModelViewProjection, InverseTranspose),
    ),
    state("gl_NormalMatrix", Mat(3), NormalMatrix),
    state("gl_NormalScale", Vec(1), NormalScale),
    state("gl_Point", Struct(&POINT), Point),
    state("gl_FrontMaterial", Struct(&MATERIAL), Material(Front)),
    state("gl_BackMaterial", Struct(&MATERIAL), Material(Back)),
    state("gl_LightModel", Struct(&LIGHT_MODEL), LightModel),
    state("gl_FrontLightModelProduct", Struct(&LIGHT_MODEL_PRODUCT), LightModelProduct(Front)),
    state("gl_BackLightModelProduct", Struct(&LIGHT_MODEL_PRODUCT), LightModelProduct(Back)),
    state("gl_Fog", Struct(&FOG), Fog),
    states("gl_TextureMatrix", Mat4Array(MAX_TEXTURE_UNITS), TextureMatrix(Plain)),
    states("gl_TextureMatrixInverse", Mat4Array(MAX_TEXTURE_UNITS), TextureMatrix(Inverse)),
    states("gl_TextureMatrixTranspose", Mat4Array(MAX_TEXTURE_UNITS), TextureMatrix(Transpose)),
    states(
        "gl_TextureMatrixInverseTranspose",
        Mat4Array(MAX_TEXTURE_UNITS),
        TextureMatrix(InverseTranspose),
    ),
    states("gl_TextureEnvColor", PER_UNIT, EnvColor),
    states("gl_ClipPlane", Vec4Array(MAX_CLIP_PLANES), StateArray::ClipPlane),
    states("gl_EyePlaneS", PER_UNIT, StateArray::TexGen(Eye, S)),
    states("gl_EyePlaneT", PER_UNIT, StateArray::TexGen(Eye, T)),
    states("gl_EyePlaneR", PER_UNIT, StateArray::TexGen(Eye, R)),
    states("gl_EyePlaneQ", PER_UNIT, StateArray::TexGen(Eye, Q)),
    states("gl_ObjectPlaneS", PER_UNIT, StateArray::TexGen(Object, S)),
    states("gl_ObjectPlaneT", PER_UNIT, StateArray::TexGen(Object, T)),
    states("gl_ObjectPlaneR", PER_UNIT, StateArray::TexGen(Object, R)),
    states("gl_ObjectPlaneQ", PER_UNIT, StateArray::TexGen(Object, Q)),
    states("gl_LightSource", StructArray(&LIGHT_SOURCE, MAX_LIGHTS), StateArray::Light),
    states(
        "gl_FrontLightProduct",
        StructArray(&LIGHT_PRODUCT, MAX_LIGHTS),
        StateArray::LightProduct(Front),
    ),
    states(
        "gl_BackLightProduct",
        StructArray(&LIGHT_PRODUCT, MAX_LIGHTS),
        StateArray::LightProduct(Back),
    ),
    row("gl_DepthRange", Struct(&DEPTH_RANGE), Any, DESKTOP_AND_ES, ReadOnly, State(DepthRange)),
    // Implementation limits
    limit("gl_MaxDualSourceDrawBuffersEXT", MAX_DUAL_SOURCE_DRAW_BUFFERS as i32, SECOND_COLOR),
    limit("gl_MaxSamples", rasterizer::driver::MAX_SAMPLES as i32, SAMPLE_SHADING),
    limit("gl_MaxViewports", MAX_VIEWPORTS as i32, VIEWPORT_ARRAY),
    limit("gl_MaxLights", MAX_LIGHTS as i32, COMPATIBILITY),
    limit("gl_MaxClipPlanes", MAX_CLIP_PLANES as i32, COMPATIBILITY),
    limit("gl_MaxTextureUnits", MAX_TEXTURE_UNITS as i32, COMPATIBILITY),
    limit("gl_MaxTextureCoords", MAX_TEXTURE_UNITS as i32, COMPATIBILITY),
    limit("gl_MaxVertexAttribs", MAX_VERTEX_ATTRIBS as i32, DESKTOP_AND_ES),
    limit("gl_MaxVertexUniformComponents", MAX_UNIFORM_COMPONENTS, DESKTOP),
    limit("gl_MaxVaryingFloats", MAX_VARYING_FLOATS as i32, DESKTOP),
    limit("gl_MaxVertexTextureImageUnits", MAX_TEXTURE_IMAGE_UNITS as i32, DESKTOP_AND_ES),
    limit(
        "gl_MaxCombinedTextureImageUnits",
        MAX_COMBINED_TEXTURE_IMAGE_UNITS as i32,
        DESKTOP_AND_ES,
    ),
    limit("gl_MaxTextureImageUnits", MAX_TEXTURE_IMAGE_UNITS as i32, DESKTOP_AND_ES),
    limit("gl_MaxFragmentUniformComponents", MAX_UNIFORM_COMPONENTS, DESKTOP),
    limit("gl_MaxDrawBuffers", MAX_DRAW_BUFFERS as i32, DESKTOP_AND_ES),
    limit("gl_MaxVaryingComponents", MAX_VARYING_FLOATS as i32, V130),
    limit("gl_MaxClipDistances", MAX_CLIP_DISTANCES as i32, CLIP_DISTANCE),
    limit("gl_MaxCullDistances", MAX_CULL_DISTANCES as i32, CULL_DISTANCE),
    limit("gl_MaxCombinedClipAndCullDistances", MAX_CULL_DISTANCES as i32, CULL_DISTANCE),
    limit("gl_MaxVertexOutputComponents", MAX_STAGE_COMPONENTS as i32, V150),
    limit("gl_MaxGeometryInputComponents", MAX_STAGE_COMPONENTS as i32, V150),
    limit("gl_MaxGeometryOutputComponents", MAX_STAGE_COMPONENTS as i32, V150),
    limit("gl_MaxFragmentInputComponents", MAX_STAGE_COMPONENTS as i32, V150),
    limit("gl_MaxGeometryTextureImageUnits", MAX_TEXTURE_IMAGE_UNITS as i32, V150),
    limit("gl_MaxGeometryOutputVertices", MAX_GEOMETRY_OUTPUT_VERTICES as i32, V150),
    limit("gl_MaxGeometryTotalOutputComponents", MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS as i32, V150),
    limit("gl_MaxGeometryUniformComponents", MAX_UNIFORM_COMPONENTS, V150),
    limit("gl_MaxGeometryVaryingComponents", MAX_VARYING_FLOATS as i32, V150),
    limit("gl_MaxVertexUniformVectors", MAX_UNIFORM_COMPONENTS / 4, ES),
    limit("gl_MaxFragmentUniformVectors", MAX_UNIFORM_COMPONENTS / 4, ES),
    limit("gl_MaxVaryingVectors", MAX_VARYING_FLOATS as i32 / 4, ES_100),
    limit("gl_MaxVertexOutputVectors", MAX_VARYING_FLOATS as i32 / 4, ES_300),
    limit("gl_MaxFragmentInputVectors", MAX_VARYING_FLOATS as i32 / 4, ES_300),
    limit("gl_MinProgramTexelOffset", *TEXEL_OFFSETS.start(), V130.and_es(EsVersions::From300)),
    limit("gl_MaxProgramTexelOffset", *TEXEL_OFFSETS.end(), V130.and_es(EsVersions::From300)),
];
