import { type Material, Mesh, type Object3D, PerspectiveCamera, Scene, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { bodyPoint, bodyVelocity, firmness, springForce } from '../../src/app/push/pointerPush.ts';
import { speedFor } from '../../src/app/runs/modePreview.ts';
import { speeds } from '../../src/app/state/playbackClock.ts';
import { ripstikView } from '../../src/core/systems/ripstik/view.ts';
import { Bodies } from '../../src/scene/actors/bodies.ts';
import { Trajectory } from '../../src/core/motion/trajectory.ts';
import { Follower } from '../../src/scene/camera/follower.ts';
import { Ghosts } from '../../src/scene/actors/ghosts.ts';
import { palettes } from '../../src/scene/palette.ts';
import { onFacingPlane, pickBody, projected } from '../../src/scene/overlay/picking.ts';
import { riderPlace } from '../../src/scene/actors/rider.ts';
import { type Block, placeView } from '../../src/scene/camera/views.ts';
import { FORCE_SCALES, legendBar, scaleIndex } from '../../src/app/state/forceScale.ts';

const size = { width: 640, height: 480 };

function camera(): PerspectiveCamera {
  const eye = new PerspectiveCamera(30, size.width / size.height, 0.01, 100);
  eye.up.set(0, 0, 1);
  eye.position.set(2, -3, 1.5);
  eye.lookAt(0.2, 0.1, 0);
  eye.updateMatrixWorld();
  return eye;
}

/** A cube of side 0.2 m about its origin. */
const CUBE = `o cube
${[0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 1 ? 0.1 : -0.1} ${k & 2 ? 0.1 : -0.1} ${k & 4 ? 0.1 : -0.1}`).join('\n')}
usemtl plastic
${['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}`).join('\n')}
`;

function cubes(...places: readonly [number, number, number][]): Bodies {
  const bodies = new Bodies(new Scene(), palettes.light);
  bodies.setModels(
    { cube: { mdl: CUBE, mat: 'newmtl plastic\nKd 0.5 0.5 0.5\n' } },
    places.map((_, i) => ({ id: `cube-${i}`, role: 'neutral' as const, model: 'cube' })),
  );
  const [c, s] = [Math.cos(0.5), Math.sin(0.5)];
  bodies.place(
    Float64Array.from(places.flatMap((place) => [...place, c, -s, 0, s, c, 0, 0, 0, 1])),
    new Float64Array(0),
  );
  return bodies;
}

describe('ghosts', () => {
  const at = (x: number): Float64Array => Float64Array.of(x, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
  const ghost = (id: string, x: number) => ({
    id,
    label: '',
    tint: '#0072B2',
    poses: at(x),
    wheelAngles: new Float64Array(0),
  });
  const meshesOf = (root: Object3D): Mesh[] => {
    const list: Mesh[] = [];
    root.traverse((child) => child instanceof Mesh && list.push(child));
    return list;
  };

  test('share the geometry of the bodies, cast no shadow, and go where they are told', () => {
    const scene = new Scene();
    const bodies = cubes([0, 0, 0]);
    const ghosts = new Ghosts(scene, palettes.light, bodies);
    const poses = at(2);
    ghosts.set([{ ...ghost('a', 2), poses }, ghost('b', 3)]);
    poses.fill(0); // not kept
    const groups = (): Object3D[] => scene.children.filter((child) => child.name === 'cube-0');
    expect(groups().map((group) => group.matrix.elements[12])).toEqual([2, 3]);
    const own = meshesOf(bodies.roots()[0]!)[0]!;
    for (const mesh of groups().flatMap(meshesOf)) {
      expect(mesh.geometry).toBe(own.geometry);
      expect([mesh.castShadow, mesh.receiveShadow, (mesh.material as Material).transparent]).toEqual([
        false,
        false,
        true,
      ]);
    }
    const kept = groups()[0];
    ghosts.set([ghost('a', 5)]);
    expect(groups()).toEqual([kept]);
    expect(kept!.matrix.elements[12]).toBe(5);
    ghosts.set([]);
    expect(groups()).toEqual([]);
  });

  test('take up other meshes of the cast where they are', () => {
    const scene = new Scene();
    const bodies = cubes([0, 0, 0]);
    const ghosts = new Ghosts(scene, palettes.light, bodies);
    ghosts.set([ghost('a', 4)]);
    bodies.replace('cube-0', { mdl: CUBE, mat: 'newmtl plastic\nKd 0.5 0.5 0.5\n' });
    ghosts.follow();
    const [group] = scene.children.filter((child) => child.name === 'cube-0');
    expect(group!.matrix.elements[12]).toBe(4);
    expect(meshesOf(group!)[0]!.geometry).toBe(meshesOf(bodies.roots()[0]!)[0]!.geometry);
  });
});

describe('picking', () => {
  test('finds the body under the place, the nearest of several, and the point in its own frame', () => {
    const eye = camera();
    // The second stands behind the first on the line of sight.
    const behind = new Vector3(0.2, 0.1, 0)
      .sub(eye.position)
      .multiplyScalar(0.4)
      .add(new Vector3(0.2, 0.1, 0));
    const bodies = cubes([0.2, 0.1, 0], [behind.x, behind.y, behind.z]);
    const at = projected([0.2, 0.1, 0], eye, size)!;
    const found = pickBody(at.x, at.y, 0, eye, size, bodies)!;
    expect(found.body).toBe(0);
    expect(Math.max(...found.point.map(Math.abs))).toBeCloseTo(0.1, 7); // on a face
    const back = new Vector3(...found.point).applyMatrix4(bodies.matrix(0)!);
    expect(back.distanceTo(new Vector3(...found.world))).toBeLessThan(1e-9);
    const again = projected(found.world, eye, size)!;
    expect(Math.hypot(again.x - at.x, again.y - at.y)).toBeLessThan(1e-6);
    bodies.setVisible(0, false);
    expect(pickBody(at.x, at.y, 0, eye, size, bodies)!.body).toBe(1);
  });

  test('reaches around the place only as far as it is told', () => {
    const eye = camera();
    const bodies = cubes([0.2, 0.1, 0]);
    const xs = Array.from({ length: size.width }, (_, x) => x).filter((x) => pickBody(x, 240, 0, eye, size, bodies));
    const edge = Math.max(...xs);
    expect(pickBody(edge + 6, 240, 0, eye, size, bodies)).toBeNull();
    expect(pickBody(edge + 6, 240, 14, eye, size, bodies)?.body).toBe(0);
    expect(pickBody(5, 5, 14, eye, size, bodies)).toBeNull();
  });
});

describe('the plane of the hand', () => {
  test('goes through the point, faces the camera, and is met under the pointer', () => {
    const eye = camera();
    const through = new Vector3(0.3, -0.2, 0.1);
    const ahead = eye.getWorldDirection(new Vector3());
    for (const [x, y] of [
      [320, 240],
      [100, 400],
      [600, 30],
    ] as const) {
      const target = onFacingPlane(x, y, through, eye, size)!;
      expect(target.clone().sub(through).dot(ahead)).toBeCloseTo(0, 9);
      const seen = projected(target.toArray(), eye, size)!;
      expect(Math.hypot(seen.x - x, seen.y - y)).toBeLessThan(1e-6);
    }
  });

  test('nothing behind the camera is on the screen', () => {
    expect(projected([4, -6, 3], camera(), size)).toBeNull();
  });
});

test('a pushed point goes with its body, and the force of its spring is stiffness times distance', () => {
  const [c, s] = [Math.cos(0.5), Math.sin(0.5)];
  const poses = Float64Array.from([...new Array<number>(12).fill(0), 1, 2, 3, c, -s, 0, s, c, 0, 0, 0, 1]);
  const at = bodyPoint(poses, 1, [0.3, 0, 0.1]);
  expect(at.map((x, i) => x - [1 + 0.3 * c, 2 + 0.3 * s, 3.1][i]!).every((x) => Math.abs(x) < 1e-12)).toBe(true);
  expect(springForce({ stiffness: 50, target: [1, 2, 3] }, [1, 2, 3.2])).toBeCloseTo(10, 9);
});

test('a body goes as fast as its coordinates say', () => {
  const trajectory = new Trajectory(
    ['t', ...ripstikView.meta.coordinates.flatMap(({ name }) => [name, `${name}_dot`])],
    1,
  );
  const row: Record<string, number> = { X_dot: 1.5, Y_dot: -0.5, Z: 0.1, theta: 0.3, theta_dot: 2 };
  trajectory.append(
    trajectory.columns.map((name) => Float64Array.of(row[name] ?? 0)),
    1,
  );
  const rod = bodyVelocity({ system: ripstikView, parameters: {}, trajectory }, 0, 0);
  const front = bodyVelocity({ system: ripstikView, parameters: {}, trajectory }, 0, 1);
  for (const [c, value] of [1.5, -0.5, 0].entries()) expect(rod[c]).toBeCloseTo(value, 7);
  // Nothing but the heading turns, at 2 rad/s: across the line between the two, as fast as it is long.
  const poses = new Float64Array(12 * ripstikView.meta.bodies.length);
  ripstikView.poses(
    Float64Array.from(ripstikView.meta.coordinates, ({ name }) => row[name] ?? 0),
    Float64Array.from(ripstikView.meta.parameters, (p) => p.default),
    poses,
  );
  const [dx, dy] = [poses[12]! - poses[0]!, poses[13]! - poses[1]!];
  expect(front[0] - rod[0]).toBeCloseTo(-2 * dy, 7);
  expect(front[1] - rod[1]).toBeCloseTo(2 * dx, 7);
});

test('the hand is as firm as what it moves is heavy', () => {
  const light = firmness({ system: ripstikView, parameters: { rodMass: 1, plateMass: 0.5, casterMass: 0.25 } });
  const heavy = firmness({ system: ripstikView, parameters: { rodMass: 4, plateMass: 2, casterMass: 1 } });
  expect(heavy.stiffness / light.stiffness).toBeGreaterThan(1.5);
  expect(heavy.damping / heavy.stiffness).toBeCloseTo(light.damping / light.stiffness, 2);
});

describe('following', () => {
  test('what moves steadily is followed without a lag, however the time is cut', () => {
    const follower = new Follower(1, 6);
    for (let t = 0; t < 4; t += 0.013 + 0.01 * Math.sin(7 * t)) follower.take([2 + 3 * t], t);
    const late = 4.01;
    follower.take([2 + 3 * late], late);
    expect(follower.at[0]).toBeCloseTo(2 + 3 * late, 6);
  });

  test('what shakes is smoothed; a jump of time takes the place as it is', () => {
    const follower = new Follower(1, 6);
    let most = 0;
    for (let t = 0; t < 5; t += 0.01) {
      follower.take([Math.sin(2 * Math.PI * 5 * t)], t);
      if (t > 2) most = Math.max(most, Math.abs(follower.at[0]!));
    }
    expect(most).toBeLessThan(0.5);
    follower.take([7], 1);
    expect(follower.at[0]).toBe(7);
    follower.take([9], 3);
    expect(follower.at[0]).toBe(9);
    // And goes on from there as fast as the goal does, without a start of its own.
    for (const t of [3.02, 3.05, 3.1]) {
      follower.take([9 + 2 * (t - 3)], t);
      expect(follower.at[0]).toBeCloseTo(9 + 2 * (t - 3), 9);
      expect(follower.speed[0]).toBeCloseTo(2, 9);
    }
  });
});

test('the rider looks ahead along the nose, level or leaning', () => {
  const level = riderPlace(0.88, [3, 1, 0.1], 0.7, null);
  const ahead = level.target.map((x, i) => x - level.eye[i]!);
  expect(Math.atan2(ahead[1]!, ahead[0]!)).toBeCloseTo(0.7, 12);
  expect(level.eye[2]).toBeGreaterThan(0.5);
  expect(level.up).toEqual([0, 0, 1]);
  const leaning = riderPlace(0.88, [3, 1, 0.1], 0, [0, -Math.sin(0.4), Math.cos(0.4)]);
  expect(leaning.up[1]).toBeCloseTo(-Math.sin(0.4), 12);
  expect(leaning.eye[1]).toBeLessThan(1);
});

test('a narrow picture stands off just as far as its width asks', () => {
  const board: Block = { low: [-0.44, -0.11, -0.1], high: [0.44, 0.11, 0.05] };
  const far = (aspect: number): number => {
    const { camera: at, target } = placeView('orbit', board, [0, 0, 0], 0, aspect);
    return Math.hypot(...at.map((x, i) => x - target[i]!));
  };
  // 430 by 750 pixels.
  expect(far(430 / 750)).toBeGreaterThan(2 * far(2));
  expect(far(3)).toBeCloseTo(far(2.5), 9); // from some width on the height decides
});

test('the bar of the legend is as long as the arrow of a round force', () => {
  for (const scale of FORCE_SCALES)
    for (const pixels of [40, 333, 2500]) {
      const bar = legendBar(scale, pixels)!;
      expect(bar.pixels).toBeCloseTo(bar.newtons * scale * pixels, 9);
      expect(bar.pixels).toBeGreaterThanOrEqual(32 * (1 - 1e-9));
      expect(bar.pixels).toBeLessThanOrEqual(80 * (1 + 1e-9));
      expect(bar.newtons.toExponential()).toMatch(/^[125]e/);
    }
  expect(legendBar(0.01, 0)).toBeNull();
  FORCE_SCALES.forEach((scale, i) => expect(scaleIndex(1.02 * scale)).toBe(i));
});

test('a mode is played at a speed at which it can be watched', () => {
  expect(speedFor(0.08, speeds)).toBe(1 / 64);
  expect(speedFor(5, speeds)).toBe(1);
  expect(speedFor(1e6, speeds)).toBe(4);
});
