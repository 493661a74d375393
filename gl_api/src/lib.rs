//! OpenGL 2.1 over the rasterizer.
