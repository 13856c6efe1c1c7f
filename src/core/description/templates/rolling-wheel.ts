export default `system "Rolling wheel"

coordinate X [m] "hub, forward"
coordinate Y [m] "hub, to the left"
coordinate theta [rad] "heading" first
coordinate phi [rad] "rolled angle" second

parameter m [kg] = 1 positive "wheel mass" group "Wheel"
parameter rho [m] = 1 positive "wheel radius" group "Wheel"
parameter Jroll [kg·m²] = 1 positive "inertia about the vertical" group "Wheel"
parameter Jspin [kg·m²] = 1 positive "inertia about the axle" group "Wheel"
parameter gravity [m/s²] = 9.81 "gravity" group "World"

constraints rolling "Rolling: X′ = ρ φ′ cos θ, Y′ = ρ φ′ sin θ"

kinetic 1/2 m (X'^2 + Y'^2) + 1/2 Jroll theta'^2 + 1/2 Jspin phi'^2
velocity X' = rho phi' cos(theta) in rolling
velocity Y' = rho phi' sin(theta) in rolling

frame heading = world turned z theta
frame wheel = heading turned y phi
body wheel at (X, Y, rho)
shape wheel disc rho, 0.05

input tau_theta [N·m] on theta "steering torque" tracks theta
input tau_phi [N·m] on phi "driving torque" tracks phi
`;
