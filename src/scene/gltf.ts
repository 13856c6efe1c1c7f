/** The bodies and their motion as binary glTF 2.0: one node a body, one clip, Y up as glTF demands. */
import {
  type BufferGeometry, type KeyframeTrack, type MeshStandardMaterial, type Object3D,
  AnimationClip, Group, Mesh, Quaternion, QuaternionKeyframeTrack, Scene, Vector3, VectorKeyframeTrack, Matrix4,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { parsePair } from './bodies.ts';
import type { BodyModel, Cast, MeshPair } from './contract.ts';
import { dress } from './materials.ts';
import { MeshError } from './meshText.ts';
import { palettes, type Theme } from './palette.ts';

export interface GlbInput {
  title: string;
  models: Readonly<Record<string, MeshPair>>;
  cast: Cast;
  theme: Theme;
  /** Keyframes (s), rising; the file's clock starts at the first. */
  times: Float64Array;
  /** For each time 12 numbers per body, as in `Frame`. */
  poses: Float64Array;
  /** For each time `wheels` angles (rad), as in `Frame`. */
  wheelAngles: Float64Array;
  wheels: number;
  generator: string;
  /** What `asset.extras` holds. */
  extras: object;
}

/** Throws `MeshError` for a mesh that can't be read. */
export async function glbOf(input: GlbInput): Promise<Uint8Array<ArrayBuffer>> {
  const scene = new Scene();
  scene.name = input.title;
  const upright = new Group();
  upright.name = 'z-up';
  upright.rotation.x = -Math.PI / 2;
  scene.add(upright);
  const times = Float32Array.from(input.times, (t) => t - input.times[0]!);
  const tracks: KeyframeTrack[] = [];
  input.cast.bodies.forEach((model, body) => {
    const { root, wheel } = bodyOf(model, input);
    upright.add(root);
    tracks.push(...bodyTracks(root, body, times, input));
    if (wheel) tracks.push(wheelTrack(wheel, model.spin!.contact, times, input));
  });
  for (const model of input.cast.fixtures) upright.add(bodyOf(model, input).root);
  const exporter = new GLTFExporter();
  exporter.register((writer) => ({
    writer,
    afterParse: () => {
      const { json } = writer as unknown as { json: { asset: Record<string, unknown> } };
      json.asset = { ...json.asset, generator: input.generator, extras: input.extras };
    },
  }));
  const clip = new AnimationClip(input.title, -1, tracks);
  const file = (await exporter.parseAsync(scene, { binary: true, animations: [clip], includeCustomExtensions: false })) as ArrayBuffer;
  return new Uint8Array(file);
}

/** A body in its own frame, its wheel (if it has one of its own) about its hub. */
function bodyOf(model: BodyModel, { models, theme }: GlbInput): { root: Group; wheel: Group | null } {
  const pair = models[model.model];
  if (!pair) throw new MeshError(`There is no model “${model.model}” for the body “${model.id}”`);
  const group = parsePair(pair, model.model);
  const root = new Group();
  root.name = model.id;
  group.traverse((child) => {
    if (child instanceof Mesh) plain(child as Mesh<BufferGeometry, MeshStandardMaterial | MeshStandardMaterial[]>, model, theme);
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
function plain(mesh: Mesh<BufferGeometry, MeshStandardMaterial | MeshStandardMaterial[]>, model: BodyModel, theme: Theme): void {
  for (const name of Object.keys(mesh.geometry.attributes)) if (name !== 'position' && name !== 'normal') mesh.geometry.deleteAttribute(name);
  mesh.geometry = mergeVertices(mesh.geometry, 1e-7);
  for (const surface of [mesh.material].flat()) {
    dress(surface, model.part, palettes[theme], true);
    surface.emissive.multiplyScalar(surface.emissiveIntensity);
    surface.emissiveIntensity = 1;
    surface.userData = {};
  }
}

function bodyTracks(root: Group, body: number, times: Float32Array, { poses, cast }: GlbInput): KeyframeTrack[] {
  const stride = 12 * cast.bodies.length;
  const positions = new Float32Array(3 * times.length);
  const turns = new Float64Array(4 * times.length);
  const matrix = new Matrix4();
  const turn = new Quaternion();
  for (let k = 0; k < times.length; k++) {
    const p = poses.subarray(stride * k + 12 * body, stride * k + 12 * body + 12) as unknown as Row;
    positions.set([p[0], p[1], p[2]], 3 * k);
    matrix.set(p[3], p[4], p[5], 0, p[6], p[7], p[8], 0, p[9], p[10], p[11], 0, 0, 0, 0, 1);
    turn.setFromRotationMatrix(matrix).normalize().toArray(turns as unknown as number[], 4 * k);
  }
  continuous(turns);
  root.position.fromArray(positions, 0);
  root.quaternion.fromArray(turns, 0);
  return [new VectorKeyframeTrack(`${root.uuid}.position`, times, positions), new QuaternionKeyframeTrack(`${root.uuid}.quaternion`, times, turns)];
}

function wheelTrack(wheel: Group, contact: number, times: Float32Array, { wheelAngles, wheels }: GlbInput): KeyframeTrack {
  const turns = new Float64Array(4 * times.length);
  for (let k = 0; k < times.length; k++) {
    const half = (wheelAngles[wheels * k + contact] ?? 0) / 2;
    turns[4 * k + 1] = Math.sin(half);
    turns[4 * k + 3] = Math.cos(half);
  }
  continuous(turns);
  wheel.quaternion.fromArray(turns, 0);
  return new QuaternionKeyframeTrack(`${wheel.uuid}.quaternion`, times, turns);
}

/** Turns each quaternion (x y z w) to the sign nearer to the one before: players then take the short way between them. */
export function continuous(turns: Float64Array): void {
  for (let o = 4; o < turns.length; o += 4) {
    let dot = 0;
    for (let i = 0; i < 4; i++) dot += turns[o + i]! * turns[o - 4 + i]!;
    if (dot < 0) for (let i = 0; i < 4; i++) turns[o + i] = -turns[o + i]!;
  }
}

type Row = [number, number, number, number, number, number, number, number, number, number, number, number];
