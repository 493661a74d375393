//! Which ways through the rasterizer ran: a log for tests ([`texunit::kernels`]).

texunit::logged_kernels! {
    /// A kernel between vertices and pixels.
    PixelKernel {
        EdgeTriangle = "triangles by blocks and edges",
        WindowTriangle = "small triangles, quad by quad",
        PackedTriangle = "small triangles, pixel by pixel",
        LargeTriangle = "large triangles, all blocks at once",
        SampledTriangle = "triangles of several samples",
        LargeSampledTriangle = "large triangles of several samples",
        SmoothTriangle = "antialiased polygons",
        AliasedLine = "aliased lines",
        SmoothLine = "antialiased lines",
        SampledLine = "lines of several samples",
        Box = "aliased points and sprites",
        Disc = "antialiased points",
        SampledDisc = "points of several samples",
        Stipple = "stippled polygons",
        Block = "a block of a shape as a batch",
        Quads = "quads of several shapes as a batch",
        Pixels = "pixels of several shapes as a batch",
        BlockGroup = "several blocks as a batch",
        Product = "blocks: texels times colours, stored as bytes",
        ProductSamples = "blocks: texels times colours, stored in each sample",
        ProductWritten = "blocks: texels times colours, written by the output stage",
        SampleShading = "a run of the program a sample",
        DepthOnly = "no colour is written",
        EarlyTests = "stencil and depth tests before the program",
        LateTests = "stencil and depth tests after the program",
        LargeDepthTest = "depth tests of all blocks of a large triangle",
        LargeStencil = "stencils of whole blocks of a large triangle",
        LargeSampleDepthTest = "depth tests of all blocks, of each sample",
        Covered = "a triangle that hides what a tile has before it",
        Clear = "clears within a pass",
        MachineCode = "machine code of programs",
        Interpreter = "the interpreter of programs",
    }
}
