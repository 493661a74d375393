//! Light, materials, fog, generated texture coordinates and user clip planes: GL 2.1, sections
//! 2.11.4, 2.12, 2.14 and 3.10.

use crate::base::types::*;
use crate::calls::lighting::{fog, light, material};
use crate::calls::transform::{clip, texgen};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_lighting {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Setter in light {
        /// Sets a parameter of a light.
        lightf: glLightf (light: GLenum, pname: GLenum, param: GLfloat);
        /// Sets a parameter of a light.
        lighti: glLighti (light: GLenum, pname: GLenum, param: GLint);
        /// Sets a parameter of a light; positions and directions go through the model-view matrix.
        lightfv: glLightfv (light: GLenum, pname: GLenum, params: &'a [GLfloat]);
        /// Sets a parameter of a light; integers of colours are fractions.
        lightiv: glLightiv (light: GLenum, pname: GLenum, params: &'a [GLint]);
    }
    Refused in light {
        /// Reads a parameter of a light, in eye coordinates.
        get_lightfv: glGetLightfv (light: GLenum, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads a parameter of a light, in eye coordinates.
        get_lightiv: glGetLightiv (light: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Sets a parameter of the lighting model.
        light_modelf: glLightModelf (pname: GLenum, param: GLfloat);
        /// Sets a parameter of the lighting model.
        light_modeli: glLightModeli (pname: GLenum, param: GLint);
        /// Sets a parameter of the lighting model.
        light_modelfv: glLightModelfv (pname: GLenum, params: &'a [GLfloat]);
        /// Sets a parameter of the lighting model.
        light_modeliv: glLightModeliv (pname: GLenum, params: &'a [GLint]);
    }
    Allowed in material {
        /// Sets the shininess of a material.
        materialf: glMaterialf (face: GLenum, pname: GLenum, param: GLfloat), not_compiled;
        /// Sets the shininess of a material.
        materiali: glMateriali (face: GLenum, pname: GLenum, param: GLint), not_compiled;
        /// Sets a parameter of a material.
        materialfv: glMaterialfv (face: GLenum, pname: GLenum, params: &'a [GLfloat]), not_compiled;
        /// Sets a parameter of a material; integers of colours are fractions.
        materialiv: glMaterialiv (face: GLenum, pname: GLenum, params: &'a [GLint]), not_compiled;
    }
    Refused in material {
        /// Sets which colours of a material follow the current colour.
        color_material: glColorMaterial (face: GLenum, mode: GLenum);
        /// Reads a parameter of a material.
        get_materialfv: glGetMaterialfv
            (face: GLenum, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads a parameter of a material.
        get_materialiv: glGetMaterialiv (face: GLenum, pname: GLenum, params: &'a mut [GLint]);
    }
    Setter in fog {
        /// Sets a parameter of fog.
        fogf: glFogf (pname: GLenum, param: GLfloat);
        /// Sets a parameter of fog.
        fogi: glFogi (pname: GLenum, param: GLint);
        /// Sets a parameter of fog.
        fogfv: glFogfv (pname: GLenum, params: &'a [GLfloat]);
        /// Sets a parameter of fog.
        fogiv: glFogiv (pname: GLenum, params: &'a [GLint]);
    }
    Refused in texgen {
        /// Sets how the active unit generates a coordinate.
        tex_genf: glTexGenf (coord: GLenum, pname: GLenum, param: GLfloat);
        /// Sets how the active unit generates a coordinate.
        tex_geni: glTexGeni (coord: GLenum, pname: GLenum, param: GLint);
        /// Sets how the active unit generates a coordinate.
        tex_gend: glTexGend (coord: GLenum, pname: GLenum, param: GLdouble);
        /// Sets how the active unit generates a coordinate; eye planes go through the inverse of
        /// the model-view matrix.
        tex_genfv: glTexGenfv (coord: GLenum, pname: GLenum, params: &'a [GLfloat]);
        /// Sets how the active unit generates a coordinate.
        tex_geniv: glTexGeniv (coord: GLenum, pname: GLenum, params: &'a [GLint]);
        /// Sets how the active unit generates a coordinate.
        tex_gendv: glTexGendv (coord: GLenum, pname: GLenum, params: &'a [GLdouble]);
        /// Reads how the active unit generates a coordinate.
        get_tex_genfv: glGetTexGenfv (coord: GLenum, pname: GLenum, params: &'a mut [GLfloat]);
        /// Reads how the active unit generates a coordinate.
        get_tex_geniv: glGetTexGeniv (coord: GLenum, pname: GLenum, params: &'a mut [GLint]);
        /// Reads how the active unit generates a coordinate.
        get_tex_gendv: glGetTexGendv (coord: GLenum, pname: GLenum, params: &'a mut [GLdouble]);
    }
    Refused in clip {
        /// Sets a user clip plane, through the inverse of the model-view matrix.
        clip_plane: glClipPlane (plane: GLenum, equation: &'a [GLdouble]);
        /// Reads a user clip plane, in eye coordinates.
        get_clip_plane: glGetClipPlane (plane: GLenum, equation: &'a mut [GLdouble]);
    }
    } };
}
entry_points_lighting!(implement);
