//! Sizes of the components of stored formats, as queries report them (GL 2.1, section 6.1.3).

use texunit::format::{BaseFormat, Format};

/// Bits of a component of a stored format, as `glGetTexLevelParameter` reports them.
pub(crate) fn component_bits(format: Format, component: Component) -> i32 {
    use BaseFormat::{Alpha, Depth, Intensity, Luminance, LuminanceAlpha, Red, Rg, Rgb, Rgba};
    let base = format.base();
    let there = match component {
        Component::Red => matches!(base, Red | Rg | Rgb | Rgba),
        Component::Green => matches!(base, Rg | Rgb | Rgba),
        Component::Blue => matches!(base, Rgb | Rgba),
        Component::Alpha => matches!(base, Alpha | LuminanceAlpha | Rgba),
        Component::Luminance => matches!(base, Luminance | LuminanceAlpha),
        Component::Intensity => matches!(base, Intensity),
        Component::Depth => matches!(base, Depth),
        Component::Stencil => format.has_stencil(),
    };
    if component == Component::Stencil {
        return format.info().stencil.bits as i32;
    }
    let channel = match component {
        Component::Red | Component::Luminance | Component::Intensity => 0,
        Component::Depth | Component::Stencil => 0,
        Component::Green => 1,
        Component::Blue => 2,
        Component::Alpha => format.channels() - 1,
    };
    if there { format.channel_bits(channel) as i32 } else { 0 }
}

/// A component whose size can be queried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Component {
    Red,
    Green,
    Blue,
    Alpha,
    Luminance,
    Intensity,
    Depth,
    Stencil,
}
