//! What shaders compute without effect: mostly behind uniform values, all of them 0 but `one`, which is 1.

use crate::left_out::feature::{Feature, Reason};
use crate::left_out::scene::*;

fn plain() {
    program("    gl_FragColor = texel * color;");
}

macro_rules! shaders {
    ($($name:literal $what:literal $body:literal $(because $reason:expr)?;)*) => {
        &[$(Feature::state($name, $what, plain, || program($body), draw_quad)$(.because($reason))?),*]
    };
}

pub(super) const LIST: &[Feature] = shaders! {
    "texture-times-zero" "a second texture times a uniform that is 0"
        "    gl_FragColor = texel * color + texture2D(second, at * 2.0) * u;";
    "mix-zero" "mix of two textures by a uniform that is 0"
        "    gl_FragColor = mix(texel, texture2D(second, at * 2.0), u) * color;";
    "mix-one" "mix of two textures by a uniform that is 1"
        "    gl_FragColor = mix(texture2D(second, at * 2.0), texel, one) * color;";
    "times-one" "a product with a uniform that is 1"
        "    gl_FragColor = texel * color * one;";
    "plus-zero" "a sum with a uniform that is 0"
        "    gl_FragColor = texel * color + u;";
    "branch" "a branch behind a uniform that is false"
        "    vec4 c = texel * color;\n    if (flag) c = sqrt(texture2D(second, at * 3.0) * c + 0.25);\n    gl_FragColor = c;";
    "branch-compare" "a branch behind a comparison of a uniform"
        "    vec4 c = texel * color;\n    if (u > 0.5) c = sqrt(texture2D(second, at * 3.0) * c + 0.25);\n    gl_FragColor = c;";
    "choice" "a choice by a uniform that is always the same side"
        "    gl_FragColor = (flag ? texture2D(second, at * 3.0) : texel) * color;";
    "loop" "a loop that runs as often as a uniform says: never"
        "    vec4 c = texel * color;\n    for (int i = 0; i < count; i++) c += texture2D(second, at * float(i + 2));\n    gl_FragColor = c;";
    "discard" "a discard behind a uniform that is false"
        "    if (flag) discard;\n    gl_FragColor = texel * color;";
    "discard-never" "a discard that never happens, by the range of what it compares"
        "    if (u > 1.5) discard;\n    gl_FragColor = texel * color;";
    "varying-unread" "a varying that the vertex shader writes and the fragment shader does not read"
        "    gl_FragColor = texel * color;";
    "varying-zero" "a varying times a uniform that is 0"
        "    gl_FragColor = texel * color + unread * u;" because Reason::NotLeftOut;
    "result-unread" "a value that reaches no output"
        "    vec4 c = sin(color * 3.0);\n    gl_FragColor = texel * color;";
    "target-missing" "a second target that the framebuffer has not"
        "    gl_FragData[1] = sin(color * 3.0);\n    gl_FragData[0] = texel * color;";
    "depth-same" "a depth that is written where there is no depth test"
        "    gl_FragDepth = sin(color.x);\n    gl_FragColor = texel * color;";
    "lod-bias" "a lookup whose bias is a uniform that is 0"
        "    gl_FragColor = texture2D(first, at, u) * color;";
};
