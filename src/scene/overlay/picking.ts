/** Between places on the screen and places in the world. */
import { type PerspectiveCamera, Matrix4, Plane, Raycaster, Vector2, Vector3 } from 'three';
import type { Bodies } from '../actors/bodies.ts';
import type { Pick, ScreenBox } from '../contract.ts';

/** CSS pixels. */
interface Size {
  width: number;
  height: number;
}

const caster = new Raycaster();
const cursor = new Vector2();

function aim(x: number, y: number, camera: PerspectiveCamera, { width, height }: Size): Raycaster {
  camera.updateMatrixWorld();
  cursor.set((2 * x) / width - 1, 1 - (2 * y) / height);
  caster.setFromCamera(cursor, camera);
  return caster;
}

/** The first visible body on the line of sight through a place on the screen; with a reach, through the places around it too. */
export function pickBody(
  x: number,
  y: number,
  reach: number,
  camera: PerspectiveCamera,
  size: Size,
  bodies: Bodies,
): Pick | null {
  const rings = [
    [0, 1],
    ...(reach > 0
      ? [
          [reach / 2, 8],
          [reach, 12],
        ]
      : []),
  ] as const;
  for (const [radius, count] of rings)
    for (let k = 0; k < count; k++) {
      const angle = (2 * Math.PI * k) / count;
      const found = hit(x + radius * Math.cos(angle), y + radius * Math.sin(angle), camera, size, bodies);
      if (found) return found;
    }
  return null;
}

function hit(x: number, y: number, camera: PerspectiveCamera, size: Size, bodies: Bodies): Pick | null {
  const ray = aim(x, y, camera, size);
  let best: { body: number; distance: number; point: Vector3 } | null = null;
  bodies.roots().forEach((root, body) => {
    if (!root.visible || bodies.modelOf(body)?.figure) return;
    root.updateWorldMatrix(true, true);
    const first = ray.intersectObject(root, true)[0];
    if (first && first.distance < (best?.distance ?? Infinity))
      best = { body, distance: first.distance, point: first.point };
  });
  // TypeScript does not see what the loop assigns.
  const found = best as { body: number; point: Vector3 } | null;
  if (!found) return null;
  const point = found.point.clone().applyMatrix4(inverse.copy(bodies.matrix(found.body)!).invert());
  return { body: found.body, point: point.toArray(), world: found.point.toArray() };
}

/** Where the line of sight through a place on the screen meets the plane through a point (m) that faces the camera. */
export function onFacingPlane(
  x: number,
  y: number,
  through: Vector3,
  camera: PerspectiveCamera,
  size: Size,
): Vector3 | null {
  const ray = aim(x, y, camera, size).ray;
  camera.getWorldDirection(normal);
  return ray.intersectPlane(plane.setFromNormalAndCoplanarPoint(normal, through), new Vector3());
}

/** CSS pixels from the top left corner; null behind the camera. */
export function projected(
  world: readonly [number, number, number],
  camera: PerspectiveCamera,
  { width, height }: Size,
): { x: number; y: number } | null {
  camera.updateMatrixWorld();
  const seen = normal.set(...world).applyMatrix4(camera.matrixWorldInverse);
  if (seen.z >= 0) return null;
  seen.applyMatrix4(camera.projectionMatrix);
  return { x: ((seen.x + 1) / 2) * width, y: ((1 - seen.y) / 2) * height };
}

/** The body's bounds as projected; null when it is not drawn or reaches behind the camera. */
export function boxOnScreen(index: number, camera: PerspectiveCamera, size: Size, bodies: Bodies): ScreenBox | null {
  const corners = bodies.corners(index).map((corner) => projected(corner.toArray(), camera, size));
  if (corners.length === 0 || corners.includes(null)) return null;
  const [xs, ys] = [corners.map((c) => c!.x), corners.map((c) => c!.y)];
  return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
}

const inverse = new Matrix4();
const normal = new Vector3();
const plane = new Plane();
