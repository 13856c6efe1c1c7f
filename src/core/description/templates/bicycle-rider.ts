export default `system "Bicycle with a leaning rider"

coordinate x [m] "rear contact, forward" second
coordinate y [m] "rear contact, to the left" second
coordinate yaw [rad] "heading, to the left"
coordinate roll [rad] "lean, to the right"
coordinate pitch [rad] "pitch of the rear frame, nose down"
coordinate steer [rad] "steer, to the right" first
coordinate rear_spin [rad] "rear wheel in its frame, forward" second
coordinate front_spin [rad] "front wheel in its fork, forward" first
coordinate lean [rad] "upper body on the frame, to the right"

parameter wheelbase [m] = 1.121 positive "wheelbase" group "Whole"
parameter trail [m] = 0.0685808540382 "trail" group "Whole"
parameter steerAxisTilt [rad] = 0.399680398707 "steer axis tilt" group "Whole"
parameter gravity [m/s²] = 9.81 "gravity" group "Whole"
parameter rearRadius [m] = 0.340958858855 positive "radius" group "Rear wheel"
parameter rearMass [kg] = 3.11 from 0 "mass" group "Rear wheel"
parameter rearIxx [kg·m²] = 0.0904106601579 positive "inertia about a diameter" group "Rear wheel"
parameter rearIyy [kg·m²] = 0.152467620286 positive "inertia about the axle" group "Rear wheel"
parameter frameX [m] = 0.374570794542 "centre of mass, x" group "Rear frame with legs"
parameter frameZ [m] = -0.681592725778 "centre of mass, z" group "Rear frame with legs"
parameter frameMass [kg] = 33.044 from 0 "mass" group "Rear frame with legs"
parameter frameIxx [kg·m²] = 2.18917391377 from 0 "inertia xx" group "Rear frame with legs"
parameter frameIyy [kg·m²] = 2.9922715238 from 0 "inertia yy" group "Rear frame with legs"
parameter frameIzz [kg·m²] = 1.61787114693 from 0 "inertia zz" group "Rear frame with legs"
parameter frameIxz [kg·m²] = -0.27087131147 "inertia xz" group "Rear frame with legs"
parameter forkX [m] = 0.866949640247 "centre of mass, x" group "Front frame"
parameter forkZ [m] = -0.748236400835 "centre of mass, z" group "Front frame"
parameter forkMass [kg] = 3.22 from 0 "mass" group "Front frame"
parameter forkIxx [kg·m²] = 0.253379594731 from 0 "inertia xx" group "Front frame"
parameter forkIyy [kg·m²] = 0.246138810935 from 0 "inertia yy" group "Front frame"
parameter forkIzz [kg·m²] = 0.0955770796289 from 0 "inertia zz" group "Front frame"
parameter forkIxz [kg·m²] = -0.0720452391817 "inertia xz" group "Front frame"
parameter frontRadius [m] = 0.34352982332 positive "radius" group "Front wheel"
parameter frontMass [kg] = 2.02 from 0 "mass" group "Front wheel"
parameter frontIxx [kg·m²] = 0.0883819364527 positive "inertia about a diameter" group "Front wheel"
parameter frontIyy [kg·m²] = 0.149389340425 positive "inertia about the axle" group "Front wheel"
parameter hingeZ [m] = -1.011421527346159 "axis of the lean, z" group "Upper body"
parameter riderX [m] = 0.231223496809401 "centre of mass, x" group "Upper body"
parameter riderZ [m] = -1.283035074598082 "centre of mass, z" group "Upper body"
parameter riderMass [kg] = 48.816 from 0 "mass" group "Upper body"
parameter riderIxx [kg·m²] = 2.038073562525466 from 0 "inertia xx" group "Upper body"
parameter riderIyy [kg·m²] = 1.692108544034995 from 0 "inertia yy" group "Upper body"
parameter riderIzz [kg·m²] = 1.100753962972129 from 0 "inertia zz" group "Upper body"
parameter riderIxz [kg·m²] = 0.002113501449812 "inertia xz" group "Upper body"
parameter leanStiffness [N·m/rad] = 0 from 0 "stiffness of the waist" group "Upper body"
parameter leanDamping [N·m·s/rad] = 0 from 0 "damping of the waist" group "Upper body"

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
frame rider = rear_frame turned x lean

point rear_contact = (x, y, 0)
point rear_hub = rear_contact + leaned(0, 0, rearRadius)
# Where the steering axis meets the ground, under the upright bicycle.
point on_axis = rear_hub + rear_frame(wheelbase + trail, 0, -rearRadius)
point front_hub = on_axis + front_frame(-trail, 0, frontRadius)
point frame_centre = rear_hub + rear_frame(frameX, 0, -frameZ - rearRadius)
point hinge = rear_hub + rear_frame(0, 0, -hingeZ - rearRadius)
point rider_centre = hinge + rider(riderX, 0, hingeZ - riderZ)
point fork_centre = on_axis + front_frame(forkX - wheelbase - trail, 0, -forkZ)

body rear_wheel mass rearMass inertia (rearIxx, rearIyy, rearIxx) at rear_hub second
body rear_frame mass frameMass inertia (frameIxx, frameIyy, frameIzz, 0, -frameIxz, 0) at frame_centre origin rear_hub second
body front_frame mass forkMass inertia (forkIxx, forkIyy, forkIzz, 0, -forkIxz, 0) at fork_centre origin front_hub first
body front_wheel mass frontMass inertia (frontIxx, frontIyy, frontIxx) at front_hub first
body rider mass riderMass inertia (riderIxx, riderIyy, riderIzz, 0, -riderIxz, 0) at rider_centre origin hinge
spring leanStiffness on lean
damper leanDamping on lean

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
input tau_lean [N·m] on lean "torque between upper body and frame" tracks lean

shape rear_wheel disc rearRadius, 0.03
shape front_wheel disc frontRadius, 0.03
shape rear_frame path (0, 0, 0), (0.25, 0, 0.45), (0.75, 0, 0.5), (0.3, 0, 0.05), (0, 0, 0)
shape front_frame path (0, 0, 0), (-0.08, 0, 0.25), (-0.25, 0, 0.65)
shape rider path (0.27, 0, 0), (0.55, 0, 0.5), (0.65, 0, 0.7)
speed along x, y heading yaw
`;
