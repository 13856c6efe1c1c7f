export default `system "Twistcar"

# Two bodies on an axle each, hinged: whoever twists the handlebar to and fro drives it forward. O. Chakon, Y. Or, "Analysis
# of underactuated dynamic locomotion systems using perturbation expansion: the twistcar toy example", J. Nonlinear Sci. 27 (2017).
coordinate x, y [m] "rear axle"
coordinate theta [rad] "heading"
coordinate phi [rad] "handlebar, on the body" first

parameter m [kg] = 10 positive "mass of body and rider"
parameter J [kg·m²] = 0.4 positive "their inertia"
parameter d [m] = 0.1 "their centre of mass ahead of the rear axle"
parameter l1 [m] = 0.4 positive "hinge ahead of the rear axle"
parameter m2 [kg] = 1 from 0 "mass of the steering arm"
parameter J2 [kg·m²] = 0.01 positive "its inertia"
parameter l2 [m] = 0.1 "front axle behind the hinge"
parameter c [N·s/m] = 0.5 from 0 "drag of the body"

frame car = world turned z theta
frame arm = car turned z phi
point rear = (x, y, 0)
point hinge = rear + car(l1, 0, 0)
point front = hinge - arm(l2, 0, 0)
body car mass m inertia (0, 0, J) at rear + car(d, 0, 0) origin rear
body arm mass m2 inertia (0, 0, J2) at front "steering arm" first
loss 1/2 c dot(velocity(rear), velocity(rear))

constraints rolling "Rolling: each axle moves along its wheels"
velocity dot(velocity(rear), car.y) = 0 in rolling "rear axle"
velocity dot(velocity(front), arm.y) = 0 in rolling "front axle"
input tau_phi [N·m] on phi "torque between body and handlebar"

shape car box (l1 + 0.1, 0.25, 0.04) at (l1/2, 0, 0.15)
shape car cylinder 0.05, 0.3 along y at (0, 0, 0.05)
shape arm cylinder 0.05, 0.2 along y at (0, 0, 0.05)
shape arm rod 0.012, 0.25 along z at (l2, 0, 0.2)
shape arm rod 0.012, 0.4 along y at (l2, 0, 0.32)
track rear
track front
forward along x, y heading theta
show c, l2
`;
