export default `system "Casterboard robot"

coordinate x [m] "centre, forward"
coordinate y [m] "centre, to the left"
coordinate theta [rad] "heading"
coordinate phi_f [rad] "front plate, to the left" first
coordinate phi_r [rad] "rear plate, to the left" second

parameter l1 [m] = 0.095 positive "caster from centre" group "Board"
parameter l2 [m] = 0.115 positive "weight from roll axis" group "Weights"
parameter m1 [kg] = 1.29 positive "board mass" group "Board"
parameter m2 [kg] = 0.29 positive "mass of each weight" group "Weights"
parameter J [kg·m²] = 0.00388075 positive "board inertia about the vertical" group "Board"
parameter a [deg] = 70 from 0 to 85.9436692696235 "caster angle" group "Board"
parameter c [N·s/m] = 0.8 from 0 "drag" group "Losses"
parameter gravity [m/s²] = 9.81 "gravity" group "World"
preset table J = 0.039

constraints rolling "Rolling: each caster moves along its heading"

# Weights on both plates swing sideways; the roll of a plate steers its caster.
frame board = world turned z theta
point centre = (x, y, 0)
point front = centre + board(l1, 0, 0)
point rear = centre - board(l1, 0, 0)
psi_f = atan(tan(a) sin(phi_f))
psi_r = atan(tan(a) sin(phi_r))
frame front_wheel = board turned z psi_f
frame rear_wheel = board turned z psi_r
frame front_arm = board turned x -phi_f
frame rear_arm = board turned x -phi_r

kinetic 1/2 m1 (x'^2 + y'^2) + 1/2 J theta'^2
v_f = velocity(front + board(0, l2 phi_f, 0))
v_r = velocity(rear + board(0, l2 phi_r, 0))
kinetic 1/2 m2 (dot(v_f, v_f) + dot(v_r, v_r))
loss 1/2 c (x'^2 + y'^2) + c l1^2 theta'^2

# Each caster moves along its heading.
velocity dot(velocity(front), -front_wheel.y) = 0 in rolling "front caster"
velocity dot(velocity(rear), -rear_wheel.y) = 0 in rolling "rear caster"

point axis = (0, 0, l1/2)
body body at centre + axis in board "board"
body front_arm at front + axis first
body rear_arm at rear + axis second
body front_wheel at front first
body rear_wheel at rear second
shape body box (2 l1, 0.02, 0.02)
shape front_arm rod 0.008, l2 along z at (0, 0, l2/2)
shape rear_arm rod 0.008, l2 along z at (0, 0, l2/2)
shape front_wheel disc 0.02, 0.01 at (0, 0, 0.02)
shape rear_wheel disc 0.02, 0.01 at (0, 0, 0.02)
track front_wheel
track rear_wheel
forward along x, y heading theta

input tau_f [N·m] on phi_f "torque on the front weight" tracks phi_f
input tau_r [N·m] on phi_r "torque on the rear weight" tracks phi_r
`;
