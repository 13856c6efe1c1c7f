export default `system "RipStik with a rider"

coordinate X [m] "rod centre, forward"
coordinate Y [m] "rod centre, to the left"
coordinate Z [m] "rod centre, height"
coordinate alpha [rad] "rod roll"
coordinate psi [rad] "pitch"
coordinate theta [rad] "yaw (heading)"
coordinate alpha_fp [rad] "front plate roll on the rod" first
coordinate alpha_bp [rad] "back plate roll on the rod" second
coordinate theta_fc [rad] "front caster steer" first
coordinate theta_bc [rad] "back caster steer" second
coordinate beta [rad] "rider’s lean"
coordinate crouch [m] "rider’s crouch" held
coordinate twist [rad] "twist of the hips" held

parameter rodMass [kg] = 2 from 0 "rod mass" group "Rod"
parameter rodLength [m] = 0.25 from 0 "rod length" group "Rod"
parameter rodRadius [m] = 0.02 from 0 "rod radius" group "Rod"
parameter plateMass [kg] = 1 from 0 "plate mass" group "Plates"
parameter plateLength [m] = 0.36 from 0 "plate length" group "Plates"
parameter plateWidth [m] = 0.22 from 0 "plate width" group "Plates"
parameter plateThickness [m] = 0.05 from 0 "plate thickness" group "Plates"
parameter plateOffset [m] = 0.26 from 0 "plate centre from rod centre" group "Plates"
parameter pivotDrop [m] = 0.05 "caster pivot below plate centre" group "Casters"
parameter casterAngle [deg] = 30 "caster angle" group "Casters"
parameter casterTrail [m] = 0.04 "caster trail" group "Casters"
parameter casterDrop [m] = 0.06 "skate point below pivot" group "Casters"
parameter casterMass [kg] = 0.5 from 0 "caster mass" group "Casters"
parameter wheelRadius [m] = 0.04 from 0 "wheel radius" group "Casters"
parameter gravity [m/s²] = 9.81 "gravity" group "World"
parameter torsionStiffness [N·m/rad] = 0 from 0 "torsion bar stiffness" group "Springs and losses"
parameter torsionDamping [N·m·s/rad] = 0 from 0 "torsion bar damping" group "Springs and losses"
parameter jointDamping [N·m·s/rad] = 0 from 0 "plate joint damping" group "Springs and losses"
parameter casterDamping [N·m·s/rad] = 0 from 0 "caster bearing damping" group "Springs and losses"
parameter wheelDrag [N·s/m] = 0 from 0 "wheel drag" group "Springs and losses"
parameter riderMass [kg] = 70 from 0 "rider’s mass" group "Rider"
parameter riderHeight [m] = 0.9 "rider’s centre of mass above the rod’s centre" group "Rider"
parameter riderIxx [kg·m²] = 8 from 0 "rider’s inertia in roll" group "Rider"
parameter riderIyy [kg·m²] = 8.5 from 0 "rider’s inertia in pitch" group "Rider"
parameter riderIzz [kg·m²] = 1.2 from 0 "rider’s inertia in yaw" group "Rider"
parameter ankleStiffness [N·m/rad] = 600 from 0 "stiffness of each ankle" group "Ankles"
parameter ankleDamping [N·m·s/rad] = 20 from 0 "damping of each ankle" group "Ankles"
parameter hipIzz [kg·m²] = 0.6 positive "hips and above: their part of the inertia in yaw" group "Legs and hips"
parameter legStiffness [N/m] = 4000 from 0 "stiffness of the legs" group "Legs and hips"
parameter legDamping [N·s/m] = 500 from 0 "damping of the legs" group "Legs and hips"
parameter hipStiffness [N·m/rad] = 40 from 0 "stiffness of the hips" group "Legs and hips"
parameter hipDamping [N·m·s/rad] = 3 from 0 "damping of the hips" group "Legs and hips"
preset street casterTrail = 0.04
preset authors casterTrail = -0.04

constraints rolling "Rolling: each skate moves in its own plane, on the ground"
constraints report "As the report: no world-Y motion of the skates, on the ground"

frame pitched = world turned z theta, y psi
frame rod = pitched turned x alpha
frame front_plate = rod turned x alpha_fp
frame back_plate = rod turned x alpha_bp
frame front_caster = front_plate turned y casterAngle, z theta_fc
frame back_caster = back_plate turned y casterAngle, z theta_bc

point centre = (X, Y, Z)
point front = centre + rod(plateOffset, 0, 0)
point back = centre - rod(plateOffset, 0, 0)
point front_skate = front + front_plate(0, 0, -pivotDrop) + front_caster(-casterTrail, 0, -casterDrop)
point back_skate = back + back_plate(0, 0, -pivotDrop) + back_caster(-casterTrail, 0, -casterDrop)

J_side = rodMass (3 rodRadius^2 + rodLength^2)/12
J_x = plateMass (plateWidth^2 + plateThickness^2)/12
J_y = plateMass (plateLength^2 + plateThickness^2)/12
J_z = plateMass (plateLength^2 + plateWidth^2)/12
J_c = casterMass wheelRadius^2
body rod mass rodMass inertia (rodMass rodRadius^2/2, J_side, J_side) at centre
body front_plate mass plateMass inertia (J_x, J_y, J_z) at front "front plate" first
body back_plate mass plateMass inertia (J_x, J_y, J_z) at back "back plate" second
body front_caster mass casterMass inertia (J_c/4, J_c/2, J_c/4) at front_skate "front caster" first
body back_caster mass casterMass inertia (J_c/4, J_c/2, J_c/4) at back_skate "back caster" second

# The rider leans about the axis of the pitched frame, his own roll beta; the centre of mass goes down along the body. Hips and
# above turn about that axis as a disc in it, a part of the whole.
frame rider = pitched turned x beta
frame torso = rider turned z twist
point middle = centre + rider(0, 0, riderHeight - crouch)
body rider mass riderMass inertia (riderIxx - hipIzz/2, riderIyy - hipIzz/2, riderIzz - hipIzz) at middle
body torso inertia (hipIzz/2, hipIzz/2, hipIzz) at middle "hips and above"
spring ankleStiffness on alpha + alpha_fp - beta
spring ankleStiffness on alpha + alpha_bp - beta
damper ankleDamping on alpha + alpha_fp - beta
damper ankleDamping on alpha + alpha_bp - beta
# Where crouch is 0 the legs carry the weight.
potential riderMass gravity crouch
spring legStiffness on crouch
damper legDamping on crouch
spring hipStiffness on twist
damper hipDamping on twist

spring torsionStiffness on alpha_fp - alpha_bp
damper torsionDamping on alpha_fp - alpha_bp
damper jointDamping on alpha_fp
damper jointDamping on alpha_bp
damper casterDamping on theta_fc
damper casterDamping on theta_bc
v_f = velocity(front_skate)
v_b = velocity(back_skate)
loss 1/2 wheelDrag dot(v_f, unit(cross(front_caster.y, world.z)))^2
loss 1/2 wheelDrag dot(v_b, unit(cross(back_caster.y, world.z)))^2

# Front across, front height, back across, back height.
velocity dot(v_f, front_caster.y) = 0 in rolling "front lateral"
velocity v_f.y = 0 in report "front lateral"
height front_skate.z = 0 in rolling, report solve Z "the front skate point"
velocity dot(v_b, back_caster.y) = 0 in rolling "back lateral"
velocity v_b.y = 0 in report "back lateral"
height back_skate.z = 0 in rolling, report solve psi "the back skate point"

# The lowest corner of either plate.
low_f = front.z - (abs(dot(front_plate.x, world.z)) plateLength + abs(dot(front_plate.y, world.z)) plateWidth + abs(dot(front_plate.z, world.z)) plateThickness)/2
low_b = back.z - (abs(dot(back_plate.x, world.z)) plateLength + abs(dot(back_plate.y, world.z)) plateWidth + abs(dot(back_plate.z, world.z)) plateThickness)/2
event touchdown "a corner of a plate reached the ground" min(low_f, low_b) in rolling, report

input tau_af [N·m] on alpha + alpha_fp - beta "front ankle torque" tracks alpha + alpha_fp
input tau_ab [N·m] on alpha + alpha_bp - beta "back ankle torque" tracks alpha + alpha_bp
input tau_fp [N·m] on alpha + alpha_fp "foot torque on the front plate" tracks alpha + alpha_fp
input tau_bp [N·m] on alpha + alpha_bp "foot torque on the back plate" tracks alpha + alpha_bp
input tau_twist [N·m] on alpha_fp - alpha_bp "torque between the plates" tracks alpha_fp
input tau_fc [N·m] on theta_fc "front steering motor" tracks theta_fc
input tau_bc [N·m] on theta_bc "back steering motor" tracks theta_bc
input f_crouch [N] on crouch "force of the legs, down" tracks crouch
input tau_twist_rider [N·m] on twist "torque of the hips" tracks twist

shape rider sphere 0.12
shape rider rod 0.05, riderHeight along z at (0, 0, -riderHeight/2)
shape torso rod 0.06, 0.5 along y at (0, 0, 0.3)
shape rod rod rodRadius, rodLength
shape front_plate box (plateLength, plateWidth, plateThickness)
shape back_plate box (plateLength, plateWidth, plateThickness)
shape front_caster cylinder wheelRadius, 0.024 along y at (0, 0, wheelRadius)
shape back_caster cylinder wheelRadius, 0.024 along y at (0, 0, wheelRadius)
track front_caster
track back_caster
forward along X, Y heading theta
`;
