export default `system "Snakeboard"

# J. Ostrowski, A. Lewis, R. Murray, J. Burdick, "Nonholonomic mechanics and locomotion: the snakeboard example", ICRA 1994:
# the rider's rotor and both axles are driven. This gait goes forward.
coordinate x, y [m] "centre of the board"
coordinate theta [rad] "heading"
coordinate psi [rad] "rotor, on the board"
coordinate phi_f [rad] "front axle, on the board" first
coordinate phi_b [rad] "back axle, on the board" second

parameter m [kg] = 6 positive "mass of the whole"
parameter J [kg·m²] = 0.016 positive "inertia of the board"
parameter Jr [kg·m²] = 0.072 positive "inertia of the rotor"
parameter Jw [kg·m²] = 0.0013 positive "inertia of each axle"
parameter l [m] = 0.2 positive "axle from the centre"
parameter swing [rad] = 0.7 "amplitude of the rotor"
parameter steer [rad] = 0.3 "amplitude of the axles"
parameter frequency [rad/s] = 1 "frequency of both"

frame board = world turned z theta
frame rotor = board turned z psi
frame front = board turned z phi_f
frame back = board turned z phi_b
point centre = (x, y, 0)
point front_axle = centre + board(l, 0, 0)
point back_axle = centre - board(l, 0, 0)
body board mass m inertia (0, 0, J) at centre
body rotor inertia (0, 0, Jr) at centre + (0, 0, 0.1)
body front inertia (0, 0, Jw) at front_axle "front axle" first
body back inertia (0, 0, Jw) at back_axle "back axle" second

constraints rolling "Rolling: each axle moves along its wheels"
velocity dot(velocity(front_axle), front.y) = 0 in rolling "front axle"
velocity dot(velocity(back_axle), back.y) = 0 in rolling "back axle"
drive psi = swing sin(frequency t + pi/2)
drive phi_f = steer sin(frequency t + pi/4)
drive phi_b = -steer sin(frequency t + pi/4)

shape board box (2 l, 0.06, 0.02) at (0, 0, 0.05)
shape rotor box (0.36, 0.04, 0.02)
shape front box (0.03, 0.2, 0.03) at (0, 0, 0.025)
shape back box (0.03, 0.2, 0.03) at (0, 0, 0.025)
track centre
forward along x, y heading theta
show swing, steer, frequency
`;
