export default `system "Chaplygin sleigh"

coordinate x [m] "blade, forward"
coordinate y [m] "blade, to the left"
coordinate theta [rad] "heading" first

parameter mass [kg] = 1 positive "mass" group "Sleigh"
parameter a [m] = 0.2 "centre of mass ahead of the blade" group "Sleigh"
parameter inertia [kg·m²] = 0.05 positive "inertia about the centre of mass" group "Sleigh"
parameter gravity [m/s²] = 9.81 "gravity" group "World"

constraints rolling "Blade: no motion across its heading"

frame sleigh = world turned z theta
point blade = (x, y, 0)
body sleigh mass mass inertia (0, 0, inertia) at blade + sleigh(a, 0, 0) origin blade
velocity dot(velocity(blade), sleigh.y) = 0 in rolling "lateral"
shape sleigh box (0.5, 0.3, 0.06) at (0.1, 0, 0.06)
track blade
forward along x, y heading theta

input tau_theta [N·m] on theta "turning torque" tracks theta
`;
