-- LÖVE: a shader, a canvas of four samples, a mesh, a stencil, text and blending. Writes the third
-- frame as PPM: love FOLDER OUT.

local out, shader, canvas, mesh, image
local frames = 0

function love.load(arguments)
  out = arguments[1]
  shader = love.graphics.newShader([[
    extern number time;
    vec4 effect(vec4 color, Image texture, vec2 coords, vec2 pixel) {
      vec2 wave = vec2(sin(coords.y * 20.0 + time), cos(coords.x * 20.0));
      return Texel(texture, coords + 0.02 * wave) * color;
    }
  ]])
  canvas = love.graphics.newCanvas(100, 100, { msaa = 4 })
  mesh = love.graphics.newMesh({
    { 0, 0, 0, 0, 1, 0, 0, 1 },
    { 80, 0, 1, 0, 0, 1, 0, 1 },
    { 80, 60, 1, 1, 0, 0, 1, 1 },
    { 0, 60, 0, 1, 1, 1, 0, 1 },
  }, "fan")
  local texels = love.image.newImageData(64, 64)
  texels:mapPixel(function(x, y)
    return x / 64, y / 64, ((x + y) % 16) / 16, 1
  end)
  image = love.graphics.newImage(texels, { mipmaps = true })
end

local function onto_canvas()
  love.graphics.setCanvas(canvas)
  love.graphics.clear(0, 0, 0, 0)
  love.graphics.circle("fill", 50, 50, 40)
  love.graphics.setColor(1, 0, 0)
  love.graphics.setLineWidth(5)
  love.graphics.line(8, 8, 90, 95)
  love.graphics.setColor(1, 1, 1)
  love.graphics.setCanvas()
end

local function write(picture)
  local file = assert(io.open(out, "wb"))
  file:write(string.format("P6\n%d %d\n255\n", picture:getDimensions()))
  local rows = {}
  for y = 0, picture:getHeight() - 1 do
    for x = 0, picture:getWidth() - 1 do
      local r, g, b = picture:getPixel(x, y)
      local byte = function(value) return math.floor(value * 255 + 0.5) end
      rows[#rows + 1] = string.char(byte(r), byte(g), byte(b))
    end
  end
  file:write(table.concat(rows))
  file:close()
  love.event.quit()
end

function love.draw()
  love.graphics.clear(0.2, 0.3, 0.4)
  onto_canvas()
  love.graphics.draw(canvas, 200, 10)
  love.graphics.setShader(shader)
  shader:send("time", 1.5)
  love.graphics.draw(image, 15, 15, 0, 1.8, 1.8)
  love.graphics.setShader()
  love.graphics.draw(mesh, 130, 140, 0.3)
  love.graphics.print("Hello, DetGL", 15, 160, 0, 1.3, 1.3)
  love.graphics.stencil(function()
    love.graphics.circle("fill", 265, 175, 40)
  end, "replace", 1)
  love.graphics.setStencilTest("greater", 0)
  love.graphics.draw(image, 215, 125, 0, 2, 2)
  love.graphics.setStencilTest()
  love.graphics.setBlendMode("add")
  love.graphics.setColor(0.5, 0.2, 0.1)
  love.graphics.rectangle("fill", 80, 80, 120, 50, 10, 10)
  love.graphics.setBlendMode("alpha")
  love.graphics.setScissor(0, 200, 80, 40)
  love.graphics.setColor(0, 1, 0)
  love.graphics.ellipse("line", 40, 216, 48, 16)
  love.graphics.setScissor()
  love.graphics.setColor(1, 1, 1)
  frames = frames + 1
  if frames == 3 then
    love.graphics.captureScreenshot(write)
  end
end
