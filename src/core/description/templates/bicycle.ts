export default `system "Bicycle (Whipple)"

coordinate x [m] "rear contact, forward" second
coordinate y [m] "rear contact, to the left" second
coordinate yaw [rad] "heading, to the left"
coordinate roll [rad] "lean, to the right"
coordinate pitch [rad] "pitch of the rear frame, nose down"
coordinate steer [rad] "steer, to the right" first
coordinate rear_spin [rad] "rear wheel in its frame, forward" second
coordinate front_spin [rad] "front wheel in its fork, forward" first

parameter wheelbase [m] = 1.02 positive "wheelbase" group "Whole"
parameter trail [m] = 0.08 "trail" group "Whole"
parameter steerAxisTilt [deg] = 18 "steer axis tilt" group "Whole"
parameter gravity [m/s²] = 9.81 "gravity" group "Whole"
parameter rearRadius [m] = 0.3 positive "radius" group "Rear wheel"
parameter rearMass [kg] = 2 from 0 "mass" group "Rear wheel"
parameter rearIxx [kg·m²] = 0.0603 positive "inertia about a diameter" group "Rear wheel"
parameter rearIyy [kg·m²] = 0.12 positive "inertia about the axle" group "Rear wheel"
parameter frameX [m] = 0.3 "centre of mass, x" group "Rear frame and rider"
parameter frameZ [m] = -0.9 "centre of mass, z" group "Rear frame and rider"
parameter frameMass [kg] = 85 from 0 "mass" group "Rear frame and rider"
parameter frameIxx [kg·m²] = 9.2 from 0 "inertia xx" group "Rear frame and rider"
parameter frameIyy [kg·m²] = 11 from 0 "inertia yy" group "Rear frame and rider"
parameter frameIzz [kg·m²] = 2.8 from 0 "inertia zz" group "Rear frame and rider"
parameter frameIxz [kg·m²] = 2.4 "inertia xz" group "Rear frame and rider"
parameter forkX [m] = 0.9 "centre of mass, x" group "Front frame"
parameter forkZ [m] = -0.7 "centre of mass, z" group "Front frame"
parameter forkMass [kg] = 4 from 0 "mass" group "Front frame"
parameter forkIxx [kg·m²] = 0.05892 from 0 "inertia xx" group "Front frame"
parameter forkIyy [kg·m²] = 0.06 from 0 "inertia yy" group "Front frame"
parameter forkIzz [kg·m²] = 0.00708 from 0 "inertia zz" group "Front frame"
parameter forkIxz [kg·m²] = -0.00756 "inertia xz" group "Front frame"
parameter frontRadius [m] = 0.35 positive "radius" group "Front wheel"
parameter frontMass [kg] = 3 from 0 "mass" group "Front wheel"
parameter frontIxx [kg·m²] = 0.1405 positive "inertia about a diameter" group "Front wheel"
parameter frontIyy [kg·m²] = 0.28 positive "inertia about the axle" group "Front wheel"

constraints rolling "Rolling: no slip at either contact, both wheels on the ground"

# Lean and steer to the right are positive; x and z of the centres of mass and the inertias as the benchmark has them, z down.
frame heading = world turned z yaw
frame leaned = heading turned x roll
frame rear_frame = leaned turned y pitch
frame steering = rear_frame turned y -steerAxisTilt, z -steer
# The front frame's axes are those of the upright bicycle at zero steer.
frame front_frame = steering turned y steerAxisTilt
frame rear_wheel = rear_frame turned y rear_spin
frame front_wheel = steering turned y front_spin

point rear_contact = (x, y, 0)
point rear_hub = rear_contact + leaned(0, 0, rearRadius)
# Where the steering axis meets the ground, under the upright bicycle.
point on_axis = rear_hub + rear_frame(wheelbase + trail, 0, -rearRadius)
point front_hub = on_axis + front_frame(-trail, 0, frontRadius)
point frame_centre = rear_hub + rear_frame(frameX, 0, -frameZ - rearRadius)
point fork_centre = on_axis + front_frame(forkX - wheelbase - trail, 0, -forkZ)

body rear_wheel mass rearMass inertia (rearIxx, rearIyy, rearIxx) at rear_hub second
body rear_frame mass frameMass inertia (frameIxx, frameIyy, frameIzz, 0, -frameIxz, 0) at frame_centre origin rear_hub second
body front_frame mass forkMass inertia (forkIxx, forkIyy, forkIzz, 0, -forkIxz, 0) at fork_centre origin front_hub first
body front_wheel mass frontMass inertia (frontIxx, frontIyy, frontIxx) at front_hub first

# The lowest material point of each wheel: u points from it to the hub, f along the wheel.
u_r = unit(world.z - dot(rear_frame.y, world.z) rear_frame.y)
f_r = unit(cross(rear_frame.y, world.z))
v_r = velocity(rear_hub) - rearRadius cross(omega(rear_wheel), u_r)
u_f = unit(world.z - dot(steering.y, world.z) steering.y)
f_f = unit(cross(steering.y, world.z))
v_f = velocity(front_hub) - frontRadius cross(omega(front_wheel), u_f)
velocity dot(v_r, f_r) = 0 in rolling "rear along"
velocity dot(v_r, cross(world.z, f_r)) = 0 in rolling "rear across"
velocity dot(v_f, f_f) = 0 in rolling "front along"
velocity dot(v_f, cross(world.z, f_f)) = 0 in rolling "front across"
point front_contact = front_hub - frontRadius u_f
height front_contact.z = 0 in rolling solve pitch "the front wheel"

input tau_roll [N·m] on roll "torque that leans the rear frame, from outside" tracks roll
input tau_steer [N·m] on steer "steering torque between the frames" tracks steer
input tau_rear [N·m] on rear_spin "driving torque between rear frame and wheel"

shape rear_wheel disc rearRadius, 0.03
shape front_wheel disc frontRadius, 0.03
shape rear_frame path (0, 0, 0), (0.25, 0, 0.45), (0.75, 0, 0.5), (0.3, 0, 0.05), (0, 0, 0)
shape front_frame path (0, 0, 0), (-0.08, 0, 0.25), (-0.25, 0, 0.65)
speed along x, y heading yaw
`;
