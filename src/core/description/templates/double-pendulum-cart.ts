export default `system "Double pendulum on a cart"

# Upright at rest: a regulator on the cart alone holds both rods.
coordinate X [m] "cart, to the right"
coordinate theta1 [rad] "lower rod, from upright" first
coordinate theta2 [rad] "upper rod, from upright" second

parameter M [kg] = 1 positive "cart mass"
parameter m1 [kg] = 0.3 positive "mass of the lower rod"
parameter m2 [kg] = 0.2 positive "mass of the upper rod"
parameter l1 [m] = 0.5 positive "length of the lower rod"
parameter l2 [m] = 0.4 positive "length of the upper rod"
parameter c [N·m·s/rad] = 0 from 0 "damping of each joint"
parameter gravity [m/s²] = 9.81 "gravity"

frame lower = world turned y theta1
frame upper = world turned y theta2
point pivot = (X, 0, 0)
point elbow = pivot + lower(0, 0, l1)
body cart mass M at pivot
body lower mass m1 inertia (0, m1 l1^2/12, 0) at pivot + lower(0, 0, l1/2) "lower rod" first
body upper mass m2 inertia (0, m2 l2^2/12, 0) at elbow + upper(0, 0, l2/2) "upper rod" second
damper c on theta1
damper c on theta1 - theta2

input f_X [N] on X "force on the cart"

shape cart box (0.3, 0.2, 0.1)
shape lower rod 0.015, l1 along z
shape upper rod 0.012, l2 along z
track elbow + upper(0, 0, l2) "tip"
show theta1, theta2
`;
