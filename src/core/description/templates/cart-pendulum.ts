export default `system "Cart and pendulum"

coordinate X [m] "cart, to the right"
coordinate theta [rad] = pi/2 "pendulum, from the horizontal" first

parameter m1 [kg] = 0.3 positive "cart mass" group "Cart"
parameter m2 [kg] = 0.1 positive "pendulum mass" group "Pendulum"
parameter L [m] = 1 positive "centre of mass from pivot" group "Pendulum"
parameter gravity [m/s²] = 9.81 "gravity" group "World"

# A rod whose radius of gyration about its centre of mass is L, as the report's Eq. 17 has it.
frame rod = world turned y -theta
point pivot = (X, 0, 0)
body cart mass m1 at pivot
body pendulum mass m2 inertia (m2 L^2, m2 L^2, m2 L^2) at pivot + rod(L, 0, 0) in rod origin pivot first
shape cart box (0.4, 0.25, 0.16)
shape pendulum rod 0.02, L at (L/2, 0, 0)
shape pendulum sphere 0.08 at (L, 0, 0)

input f_X [N] on X "force on the cart" tracks X
`;
