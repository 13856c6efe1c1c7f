export default `system "Rattleback"

# T. R. Kane, D. A. Levinson, "Realistic mathematical modeling of the rattleback", Int. J. Non-Linear Mechanics 17 (1982): an
# ellipsoid whose axes of inertia are turned against those of its shape. Spun the wrong way, it rattles and turns back.
coordinate x, y [m] "centre of the ellipsoid"
coordinate yaw [rad] "heading"
coordinate pitch [rad] "pitch" first
coordinate roll [rad] "roll" second

parameter m [kg] = 1 positive "mass"
parameter a [m] = 0.2 positive "half axis, along"
parameter b [m] = 0.03 positive "half axis, across"
parameter c [m] = 0.02 positive "half axis, up"
parameter h [m] = 0.01 "centre of mass below the ellipsoid's"
parameter Ixx [kg·m²] = 0.0002 positive "inertia xx"
parameter Iyy [kg·m²] = 0.0016 positive "inertia yy"
parameter Izz [kg·m²] = 0.0017 positive "inertia zz"
parameter Ixy [kg·m²] = -0.00002 "inertia xy: which way it turns back"
parameter sigma [N·m·s/rad] = 0 from 0 "loss of all turning"
parameter gravity [m/s²] = 9.81 "gravity"

frame stone = world turned z yaw, y pitch, x roll
# The lowest point of the ellipsoid, from its centre.
u1 = dot(stone.x, world.z)
u2 = dot(stone.y, world.z)
u3 = dot(stone.z, world.z)
s = sqrt(a^2 u1^2 + b^2 u2^2 + c^2 u3^2)
to_contact = -stone(a^2 u1, b^2 u2, c^2 u3)/s
point centre = (x, y, s)
body stone mass m inertia (Ixx, Iyy, Izz, Ixy, 0, 0) at centre + stone(0, 0, -h) origin centre

v_contact = velocity(centre) + cross(omega(stone), to_contact)
constraints rolling "Rolling: no slip"
velocity v_contact.x = 0 in rolling "along x"
velocity v_contact.y = 0 in rolling "along y"
loss 1/2 sigma dot(omega(stone), omega(stone))

shape stone box (1.6 a, 1.6 b, c) at (0, 0, -c/2)
track centre + to_contact "contact"
show yaw_dot, pitch, Ixy
`;
