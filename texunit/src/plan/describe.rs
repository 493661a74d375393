//! The decisions of a plan as one line of text.

use super::lod_range::LodRange;
use super::texture::{Alpha, Anisotropy, LevelSelection, SampleKernel, Texture, WhyGeneral};
use crate::sampler::Seamless;

impl WhyGeneral {
    /// The rest of a sentence.
    fn describe(self) -> &'static str {
        match self {
            Self::Probes => "anisotropic footprints of this shape or wrap mode take several probes",
            Self::Filters => "min and mag of a cube or an array have different filters",
            Self::Shape => "the image has one axis, or three",
            Self::Blocks => "texels are compressed",
            Self::Format => "texels are not all bytes, halves, floats or depths of 24 bits",
            Self::Border => "faces or layers have border texels",
            Self::Wrap => "faces or layers have a wrap mode that reads the border or mirrors once",
            Self::Fetch => "texels are fetched by their numbers",
        }
    }
}

impl SampleKernel {
    /// The kernel's name, and why it is the general one.
    pub(super) fn describe(self) -> String {
        match self {
            Self::UniformLevel(_) => "kernel of uniform levels".to_owned(),
            Self::Scattered(_) => "kernel of scattered lanes".to_owned(),
            Self::RowScan => "kernel of row scans".to_owned(),
            Self::General(why) => format!("general kernel: because {}", why.describe()),
        }
    }
}

impl Texture {
    pub(super) fn describe(&self) -> String {
        let Self { shape, format, size, wrap, .. } = self;
        let mut sides = 3;
        while sides > shape.axes() && size[sides - 1] == 1 {
            sides -= 1;
        }
        let size = size[..sides].iter().map(u32::to_string).collect::<Vec<_>>().join("x");
        let mut line = format!("{shape:?} {format:?} {size}, wrap");
        for wrap in &wrap[..shape.axes()] {
            line += &format!(" {wrap:?}");
        }
        if self.seamless == Seamless::On {
            line += ", seamless";
        }
        if let Some(op) = self.compare {
            line += &format!(", depth compare {op:?} before the filter");
        }
        match &self.level_selection {
            LevelSelection::Fixed { filter, level, why, bias: _ } => {
                line += &format!(", {filter:?} of level {level} (from the base), no LOD: {why}");
            }
            LevelSelection::PerLane { min, mag, range, anisotropy } => {
                let LodRange { mipmap, last, magnified_to, .. } = range;
                line += &format!(
                    ", min {min:?} mipmap {mipmap:?} of levels 0 to {last} (from the base), \
                     mag {mag:?} up to lambda {magnified_to}, LOD per lane"
                );
                line += &match anisotropy {
                    Anisotropy::Off => String::new(),
                    Anisotropy::Probes(most) => {
                        format!(", up to {most} probes along the major axis")
                    }
                    Anisotropy::Scan(most) => {
                        format!(", row by row along the major axis up to {most} times the minor")
                    }
                };
            }
        }
        if self.alpha == Alpha::One && format.channels() == 4 {
            line += "; left out: alpha (it is 1 everywhere)";
        }
        line
    }
}
