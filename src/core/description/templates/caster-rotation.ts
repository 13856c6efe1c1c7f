export default `system "Caster rotation"

coordinate theta_c [rad] "caster steer" first

parameter casterAngle [deg] = 30 "caster angle" group "Caster"
parameter casterTrail [m] = -0.05 "caster trail" group "Caster"
parameter casterDrop [m] = 0.095 "skate point below pivot" group "Caster"
parameter casterMass [kg] = 0.5 positive "caster mass" group "Caster"
parameter wheelRadius [m] = 0.04 positive "wheel radius" group "Caster"
parameter gravity [m/s²] = 0 "gravity" group "World"

frame caster = world turned y casterAngle, z theta_c
point pivot = (0, 0, 0)
point skate = pivot + caster(-casterTrail, 0, -casterDrop)
J = casterMass wheelRadius^2
body caster mass casterMass inertia (J/4, J/2, J/4) at skate first
shape caster cylinder wheelRadius, 0.024 along y at (0, 0, wheelRadius)
track skate "skate point"

input tau_c [N·m] on theta_c "torque about the steering axis" tracks theta_c
`;
