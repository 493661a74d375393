function love.conf(t)
  t.identity = "detgl-client"
  t.window.width = 320
  t.window.height = 240
  t.modules.audio = false
  t.modules.sound = false
  t.modules.joystick = false
  t.modules.physics = false
end
