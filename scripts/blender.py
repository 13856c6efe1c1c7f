"""Opens an exported GLB in Blender and compares what moves there with the CSV of the same run.

    pip install bpy            # Blender as a Python module; its Python version must match
    python scripts/blender.py run.glb run.csv [rod]

Export both files of one run of the board in the page, the GLB with a keyframe at every row. The rod's frame has its origin
at (X, Y, Z) and the rotation Rz(theta) Ry(psi) Rx(alpha), so that Blender's world matrix of it is compared without any of
the program's own code. Every other body must move. Ends with status 1 where one does not, or a number differs by more than
1e-5 (the file holds 32-bit floats).
"""

import csv
import sys
from math import pi

import bpy
from mathutils import Matrix

TOLERANCE = 1e-5
# The importer turns every node's own axes from Y up to Z up.
AXES = Matrix.Rotation(pi / 2, 4, "X")
SAMPLES = 50


def main(glb: str, table: str, rod: str = "rod") -> int:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=glb)
    scene = bpy.context.scene
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    moving = [o for o in scene.objects if o.animation_data and (o.animation_data.action or o.animation_data.nla_tracks)]
    print(f"Blender {bpy.app.version_string}: {len(scene.objects)} objects, {len(moving)} animated: {', '.join(sorted(o.name for o in moving))}")
    bodies = {o.name: o for o in scene.objects}
    if rod not in bodies:
        print(f"no object is called '{rod}'; say which is the rod, as third argument")
        return 1
    fps = scene.render.fps / scene.render.fps_base
    first, worst = {}, 0.0
    changed = dict.fromkeys((o.name for o in moving), 0.0)
    for row in rows[:: max(1, len(rows) // SAMPLES)]:
        value = {name: float(row[name]) for name in ("t", "X", "Y", "Z", "alpha", "psi", "theta")}
        frame = value["t"] * fps
        scene.frame_set(int(frame), subframe=frame - int(frame))
        turn = Matrix.Rotation(value["theta"], 4, "Z") @ Matrix.Rotation(value["psi"], 4, "Y") @ Matrix.Rotation(value["alpha"], 4, "X")
        expected = Matrix.Translation((value["X"], value["Y"], value["Z"])) @ turn
        found = bodies[rod].matrix_world @ AXES
        worst = max(worst, *(abs(found[i][j] - expected[i][j]) / max(1, abs(expected[i][j])) for i in range(3) for j in range(4)))
        for o in moving:
            start = first.setdefault(o.name, o.matrix_basis.copy())
            changed[o.name] = max(changed[o.name], *(abs(o.matrix_basis[i][j] - start[i][j]) for i in range(3) for j in range(4)))
    still = [name for name, most in changed.items() if most < 1e-4]
    print(f"largest difference of '{rod}' from the run: {worst:.1e} over {min(SAMPLES, len(rows))} moments; bodies that stand still: {', '.join(still) or 'none'}")
    return 0 if worst <= TOLERANCE and not still else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) in (3, 4) else __doc__)
