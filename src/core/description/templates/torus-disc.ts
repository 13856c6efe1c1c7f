export default `system "Rolling torus disc"

# A body whose rim is a tube of radius b about a circle of radius a: a hoop, a disc (b = 0), a tyre, a coin.
coordinate x, y [m] "centre"
coordinate yaw [rad] "heading, to the left"
coordinate lean [rad] "lean, to the right" first
coordinate spin [rad] "rolled angle" second

parameter m [kg] = 1 positive "mass"
parameter a [m] = 0.2 positive "radius of the centre circle"
parameter b [m] = 0.02 from 0 "radius of the tube"
parameter A [kg·m²] = 0.02025 positive "inertia about a diameter" note "m (a²/2 + 5 b²/8) for a solid torus"
parameter C [kg·m²] = 0.0403 positive "inertia about the axle" note "m (a² + 3 b²/4) for a solid torus"
parameter gravity [m/s²] = 9.81 "gravity"

frame heading = world turned z yaw
frame leaned = heading turned x lean
frame disc = leaned turned y spin
point centre = (x, y, b + a cos(lean))
body disc mass m inertia (A, C, A) at centre "disc"

# The material point that touches the ground does not move.
to_contact = -a leaned.z - b world.z
v_contact = velocity(centre) + cross(omega(disc), to_contact)
constraints rolling "Rolling: no slip"
velocity dot(v_contact, heading.x) = 0 in rolling "along"
velocity dot(v_contact, heading.y) = 0 in rolling "across"

input tau_lean [N·m] on lean "leaning torque, from outside"
input tau_spin [N·m] on spin "driving torque"
event fallen "it lies on its side" cos(lean) - 0.05

shape disc disc a + b, 2 b + 0.004
track centre + to_contact "contact"
speed along x, y heading yaw
show x_dot, lean, a, b
`;
