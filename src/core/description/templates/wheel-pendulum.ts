export default `system "Wheel and pendulum"

coordinate X [m] "hub, forward"
coordinate phi [rad] "rolled angle" second
coordinate psi [rad] = -pi/2 "pendulum, from the horizontal" first

parameter rho [m] = 0.5 positive "wheel radius" group "Wheel"
parameter m [kg] = 3 positive "wheel mass" group "Wheel"
parameter mP [kg] = 1 positive "pendulum mass" group "Pendulum"
parameter Jspin [kg·m²] = 2 positive "wheel inertia about the axle" group "Wheel"
parameter L [m] = 1 positive "centre of mass from hub" group "Pendulum"
parameter gravity [m/s²] = 9.81 "gravity" group "World"

constraints rolling "Rolling: X′ = ρ φ′"

# The pendulum is a thin rod of length 2 L.
kinetic 1/2 m X'^2 + 1/2 Jspin phi'^2
frame rod = world turned y psi
frame wheel = world turned y phi
point hub = (X, 0, rho)
body wheel at hub
body pendulum mass mP inertia (0, mP L^2/3, mP L^2/3) at hub + rod(L, 0, 0) in rod origin hub first
velocity X' = rho phi' in rolling
shape wheel disc rho, 0.05
shape pendulum rod 0.03, 2 L at (L, 0, 0)

input tau_phi [N·m] on phi "torque on the wheel" tracks phi
`;
