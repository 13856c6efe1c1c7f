/** The bodies and their motion as binary glTF 2.0: one node a body, one clip, Y up as glTF demands. */
import { type BufferGeometry, type MeshStandardMaterial, type Object3D, Group, Mesh, Scene, Vector3 } from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { parsePair } from '../actors/bodies.ts';
import type { BodyModel, Cast, MeshPair } from '../contract.ts';
import { withAnimation } from './glbFile.ts';
import { BodyKeys, TimeKeys, WheelKeys } from './keyframes.ts';
import { dress } from '../actors/materials.ts';
import { MeshError } from '../actors/meshText.ts';
import { palettes, type Theme } from '../palette.ts';

export interface GlbInput {
  title: string;
  models: Readonly<Record<string, MeshPair>>;
  cast: Cast;
  theme: Theme;
  /** Keyframes (s), rising; the file's clock starts at the first. */
  times: Float64Array;
  /** Poses (12 numbers per body) and wheel angles (rad) at a time, as in `Frame`; read at once and not kept. */
  at(time: number): { poses: Float64Array; wheelAngles: Float64Array };
  generator: string;
  /** What `asset.extras` holds. */
  extras: object;
  /** After each body and each keyframe, with how many of these are done: a promise where the page wants to live for a moment. */
  pause?(keys: number): Promise<void> | null;
}

interface Moving {
  root: Group;
  body: BodyKeys;
  wheel: { group: Group; contact: number; keys: WheelKeys } | null;
}

/** Throws `MeshError` for a mesh that can't be read, and what `pause` throws. */
export async function glbOf(input: GlbInput): Promise<Blob> {
  const { cast, times, title, pause } = input;
  const scene = new Scene();
  scene.name = title;
  const upright = new Group();
  upright.name = 'z-up';
  upright.rotation.x = -Math.PI / 2;
  scene.add(upright);
  const moving: Moving[] = [];
  for (const model of cast.bodies) {
    const { root, wheel } = bodyOf(model, input);
    upright.add(root);
    moving.push({
      root,
      body: new BodyKeys(),
      wheel: wheel && { group: wheel, contact: model.spin!.contact, keys: new WheelKeys() },
    });
    await pause?.(0);
  }
  for (const model of cast.fixtures) upright.add(bodyOf(model, input).root);
  const clock = new TimeKeys();
  for (let k = 0; k < times.length; k++) {
    const { poses, wheelAngles } = input.at(times[k]!);
    clock.push(times[k]! - times[0]!);
    moving.forEach(({ body, wheel }, i) => {
      body.push(poses, 12 * i);
      wheel?.keys.push(wheelAngles[wheel.contact] ?? 0);
    });
    if (k === 0) moving.forEach((one, i) => stand(one, poses, 12 * i));
    const wait = pause?.(k + 1);
    if (wait) await wait;
  }
  const { file, nodeOf } = await stillGlb(scene, input);
  return withAnimation(
    file,
    title,
    clock,
    moving.flatMap(({ root, body, wheel }) => [
      { node: nodeOf(root), keys: body },
      ...(wheel ? [{ node: nodeOf(wheel.group), keys: wheel.keys }] : []),
    ]),
  );
}

/** In the first keyframe: what a viewer without animation shows. */
function stand({ root, body, wheel }: Moving, poses: Float64Array, offset: number): void {
  root.position.fromArray(poses as unknown as number[], offset);
  root.quaternion.fromArray(body.turn as unknown as number[]);
  if (wheel) wheel.group.quaternion.fromArray(wheel.keys.turn as unknown as number[]);
}

/** The scene without motion, and the file's number of each node. */
async function stillGlb(
  scene: Scene,
  { generator, extras }: GlbInput,
): Promise<{ file: ArrayBuffer; nodeOf(object: Object3D): number }> {
  const exporter = new GLTFExporter();
  let nodes = new Map<Object3D, number>();
  exporter.register((writer) => ({
    writer,
    afterParse: () => {
      const { json, nodeMap } = writer as unknown as {
        json: { asset: Record<string, unknown> };
        nodeMap: Map<Object3D, number>;
      };
      json.asset = { ...json.asset, generator, extras };
      nodes = nodeMap;
    },
  }));
  const file = (await exporter.parseAsync(scene, {
    binary: true,
    trs: true,
    includeCustomExtensions: false,
  })) as ArrayBuffer;
  return { file, nodeOf: (object) => nodes.get(object)! };
}

/** A body in its own frame, its wheel (if it has one of its own) about its hub. */
function bodyOf(model: BodyModel, { models, theme }: GlbInput): { root: Group; wheel: Group | null } {
  const pair = models[model.model];
  if (!pair) throw new MeshError(`There is no model “${model.model}” for the body “${model.id}”`);
  const group = parsePair(pair, model.model);
  const root = new Group();
  root.name = model.id;
  group.traverse((child) => {
    if (child instanceof Mesh)
      plain(child as Mesh<BufferGeometry, MeshStandardMaterial | MeshStandardMaterial[]>, model, theme);
  });
  const spinning = model.spin ? group.children.filter((child) => /^wheel\b/i.test(child.name)) : [];
  let wheel: Group | null = null;
  if (spinning.length > 0) {
    const hub = new Vector3(...model.spin!.hub);
    wheel = new Group();
    wheel.name = `${model.id}-wheel`;
    wheel.position.copy(hub);
    for (const child of spinning) child.position.sub(hub);
    wheel.add(...spinning);
    root.add(wheel);
  }
  root.add(...group.children.slice());
  root.traverse((child: Object3D) => {
    if (child instanceof Mesh) child.name = `${model.id}-${child.name || 'part'}`;
  });
  return { root, wheel };
}

/** Geometry without what nothing uses, surfaces without what glTF has no word for. */
function plain(
  mesh: Mesh<BufferGeometry, MeshStandardMaterial | MeshStandardMaterial[]>,
  model: BodyModel,
  theme: Theme,
): void {
  for (const name of Object.keys(mesh.geometry.attributes))
    if (name !== 'position' && name !== 'normal') mesh.geometry.deleteAttribute(name);
  mesh.geometry = mergeVertices(mesh.geometry, 1e-7);
  for (const surface of [mesh.material].flat()) {
    dress(surface, model.role, palettes[theme], true);
    surface.emissive.multiplyScalar(surface.emissiveIntensity);
    surface.emissiveIntensity = 1;
    surface.userData = {};
  }
}
