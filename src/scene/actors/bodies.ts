/** The moving bodies: meshes from text, placed by pose. */
import {
  type BufferGeometry,
  type Group as GroupType,
  type Material,
  type Scene,
  type Matrix4,
  type MeshStandardMaterial,
  Box3,
  Group,
  Mesh,
  Vector3,
} from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import type { BodyModel, MeshPair } from '../contract.ts';
import { dress, surfaceFrom } from './materials.ts';
import { checkMaterials, checkMesh, MeshError } from './meshText.ts';
import type { Plain } from './plain.ts';
import type { Palette } from '../palette.ts';

/** Edges sharper than this (rad) stay edges where the file gives no normals. */
const CREASE = 0.6;

/** One pair as a group in the body's own frame (m). Throws `MeshError`; never touches the network. */
export function parsePair(pair: MeshPair, name: string): GroupType {
  const mesh = checkMesh(pair.mdl, `${name}.mdl`);
  const materials = checkMaterials(pair.mat, `${name}.mat`);
  try {
    const group = new OBJLoader().setMaterials(new MTLLoader().parse(materials, '')).parse(mesh);
    const withNormals = /^vn\s/m.test(mesh);
    group.traverse((child) => {
      if (!(child instanceof Mesh)) return;
      const part = child as Mesh<BufferGeometry, Material | Material[]>;
      if (!withNormals) part.geometry = toCreasedNormals(part.geometry, CREASE);
      part.material = Array.isArray(part.material) ? part.material.map(surfaceFrom) : surfaceFrom(part.material);
      part.castShadow = part.receiveShadow = true;
    });
    return group;
  } catch (error) {
    throw new MeshError(`${name}.mdl: ${error instanceof Error ? error.message : String(error)}`, { cause: error });
  }
}

interface Drawn {
  model: BodyModel;
  /** What it was built from. */
  pair: MeshPair;
  /** Moves with the pose. */
  root: GroupType;
  /** Spins about the hub's y axis; null on a body without a wheel of its own. */
  wheel: GroupType | null;
  surfaces: MeshStandardMaterial[];
  /** Bounds in the body's frame. */
  box: Box3;
}

const samePair = (a: MeshPair, b: MeshPair): boolean => a.mdl === b.mdl && a.mat === b.mat;
const sameModel = (a: BodyModel, b: BodyModel): boolean => JSON.stringify(a) === JSON.stringify(b);

const groupsOf = ({ root, wheel }: Drawn): GroupType[] => (wheel ? [root, wheel] : [root]);

/** Puts a group where pose `index` says; false when there is none. */
export function setPose(root: GroupType, poses: Float64Array, index: number): boolean {
  if (poses.length < 12 * (index + 1)) return false;
  const p = poses.subarray(12 * index, 12 * index + 12) as unknown as Row;
  root.matrix.set(p[3], p[4], p[5], p[0], p[6], p[7], p[8], p[1], p[9], p[10], p[11], p[2], 0, 0, 0, 1);
  root.matrixWorldNeedsUpdate = true;
  return true;
}

export class Bodies {
  /** Rises whenever a mesh is replaced. */
  version = 0;
  private readonly scene: Scene;
  private drawn: Drawn[] = [];
  /** What stands still, in world axes. */
  private fixtures: Drawn[] = [];
  private readonly hidden = new Set<number>();
  /** Materials of bodies that went: their shaders live on until the next picture has taken them over. */
  private retired: MeshStandardMaterial[] = [];
  private palette: Palette;
  private environment = false;
  /** Draws them with little; null with all there is. */
  private plain: Plain | null = null;
  /** Last poses and wheel angles, kept for bodies that come after them; the caller reuses its arrays. */
  private poses: Float64Array | null = null;
  private angles = new Float64Array(0);

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.palette = palette;
  }

  get count(): number {
    return this.drawn.length;
  }

  /** Replaces all bodies, or throws and leaves those that were there. */
  setModels(
    models: Readonly<Record<string, MeshPair>>,
    bodies: readonly BodyModel[],
    fixtures: readonly BodyModel[] = [],
  ): void {
    const before = new Set([...this.drawn, ...this.fixtures]);
    const build = (model: BodyModel): Drawn => {
      const pair = models[model.model];
      if (!pair) throw new MeshError(`There is no model “${model.model}” for the body “${model.id}”`);
      const same = [...before].find((body) => samePair(body.pair, pair) && sameModel(body.model, model));
      return same ?? this.build(model, pair, model.model);
    };
    const [next, still] = [bodies.map(build), fixtures.map(build)];
    const kept = new Set([...next, ...still]);
    for (const body of before) if (!kept.has(body)) this.remove(body);
    this.drawn = next;
    this.fixtures = still;
    for (const body of kept) if (!before.has(body)) this.add(body);
    this.version++;
    this.arrange();
  }

  /** Replaces one body (`front-caster`) or every body of one model (`caster`), or throws and leaves them. */
  replace(id: string, pair: MeshPair): void {
    const indices = this.drawn.flatMap(({ model }, i) => (model.id === id || model.model === id ? [i] : []));
    if (indices.length === 0) {
      const names = [...new Set(this.drawn.flatMap(({ model }) => [model.id, model.model]))].join(', ');
      throw new MeshError(`There is no body “${id}”${names === '' ? '' : `; the bodies are ${names}`}`);
    }
    const next = indices.map((i) => this.build(this.drawn[i]!.model, pair, id));
    indices.forEach((i, k) => {
      this.remove(this.drawn[i]!);
      this.drawn[i] = next[k]!;
      this.add(next[k]!);
    });
    this.version++;
    this.arrange();
  }

  /** Poses: 12 numbers per body, position then rotation by rows; null hides all. Angles (rad): as the bodies' `spin` counts them. */
  place(poses: Float64Array | null, wheelAngles: Float64Array): void {
    if (poses && this.poses?.length === poses.length) this.poses.set(poses);
    else this.poses = poses?.slice() ?? null;
    if (this.angles.length === wheelAngles.length) this.angles.set(wheelAngles);
    else this.angles = wheelAngles.slice();
    this.arrange();
  }

  setVisible(index: number, visible: boolean): void {
    if (visible) this.hidden.delete(index);
    else this.hidden.add(index);
    this.show(index);
  }

  setLook(palette: Palette, environment: boolean): void {
    this.palette = palette;
    this.environment = environment;
    for (const { model, surfaces } of [...this.drawn, ...this.fixtures])
      for (const s of surfaces) dress(s, model.role, palette, environment);
    if (this.plain) this.setPlain(this.plain);
  }

  /** Draws all bodies with little, or (null) with all there is. */
  setPlain(plain: Plain | null): void {
    const before = this.plain;
    this.plain = plain;
    for (const group of [...this.drawn, ...this.fixtures].flatMap(groupsOf)) {
      before?.take(group);
      plain?.put(group);
    }
    this.version++;
  }

  matrix(index: number): Matrix4 | null {
    return this.has(index) ? this.drawn[index]!.root.matrix : null;
  }

  /** Of a body's frame in world axes (m), or null. */
  originOf(index: number): Vector3 | null {
    return this.has(index) ? new Vector3().setFromMatrixPosition(this.drawn[index]!.root.matrix) : null;
  }

  /** The eight corners of the body's bounds, in world axes (m). */
  corners(index: number): Vector3[] {
    if (!this.has(index)) return [];
    const body = this.drawn[index]!;
    const { min, max } = body.box;
    return Array.from({ length: 8 }, (_, k) =>
      new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z).applyMatrix4(body.root.matrix),
    );
  }

  /** Height of the lowest corner of all bounds (m), or Infinity without bodies. */
  lowest(): number {
    let lowest = Infinity;
    for (const { box, root } of this.drawn) {
      const e = root.matrix.elements;
      let z = e[14]!;
      for (let i = 0; i < 3; i++) {
        const along = e[4 * i + 2]!;
        const corner = along > 0 ? box.min : box.max;
        z += along * corner.getComponent(i);
      }
      if (z < lowest) lowest = z;
    }
    return lowest;
  }

  /** Indices of the bodies whose wheel rolls on the ground below it. */
  wheeled(): number[] {
    return this.drawn.flatMap(({ model }, i) => (model.spin ? [i] : []));
  }

  /** Middle of a wheel's bounds in world axes (m), or null on a body without one. */
  wheelCentre(index: number): Vector3 | null {
    const wheel = this.drawn[index]?.wheel;
    return wheel ? new Box3().setFromObject(wheel, true).getCenter(new Vector3()) : null;
  }

  /** Lets go of what the last picture did without; to be called once it is drawn. */
  tidy(): void {
    for (const s of this.retired) s.dispose();
    this.retired = [];
  }

  dispose(): void {
    for (const body of [...this.drawn, ...this.fixtures]) this.remove(body);
    this.drawn = [];
    this.fixtures = [];
    this.tidy();
  }

  private build(model: BodyModel, pair: MeshPair, name: string): Drawn {
    const group = parsePair(pair, name);
    const root = new Group();
    root.matrixAutoUpdate = false;
    root.name = model.id;
    const box = new Box3().setFromObject(group);
    const surfaces: MeshStandardMaterial[] = [];
    group.traverse((child) => {
      if (child instanceof Mesh) surfaces.push(...([child.material].flat() as MeshStandardMaterial[]));
    });
    const spinning = model.spin ? group.children.filter((child) => /^wheel\b/i.test(child.name)) : [];
    let wheel: GroupType | null = null;
    if (model.spin && spinning.length > 0) {
      const hub = new Vector3(...model.spin.hub);
      wheel = new Group();
      wheel.userData['wheel'] = true;
      wheel.position.copy(hub);
      for (const child of spinning) {
        child.position.sub(hub);
        wheel.add(child);
      }
      root.add(wheel);
    }
    root.add(...group.children.slice());
    return { model, pair, root, wheel, surfaces, box };
  }

  /** The bodies' groups, in their order: a clone shares their geometry. */
  roots(): GroupType[] {
    return this.drawn.map(({ root }) => root);
  }

  modelOf(index: number): BodyModel | null {
    return this.drawn[index]?.model ?? null;
  }

  /** Whether a body is seen now. */
  shows(index: number): boolean {
    return this.drawn[index]?.root.visible ?? false;
  }

  /** Puts what is drawn where the last poses say. */
  private arrange(): void {
    this.drawn.forEach((body, i) => {
      this.show(i);
      if (!this.has(i)) return;
      setPose(body.root, this.poses!, i);
      if (body.wheel) body.wheel.rotation.y = this.angles[body.model.spin!.contact] ?? 0;
    });
  }

  /** Whether a body is drawn and has a pose. */
  private has(index: number): boolean {
    return index in this.drawn && this.poses !== null && this.poses.length >= 12 * (index + 1);
  }

  private show(index: number): void {
    const body = this.drawn[index];
    if (body) body.root.visible = this.has(index) && !this.hidden.has(index);
  }

  private add(body: Drawn): void {
    for (const s of body.surfaces) dress(s, body.model.role, this.palette, this.environment);
    for (const group of groupsOf(body)) this.plain?.put(group);
    this.scene.add(body.root);
  }

  private remove(body: Drawn): void {
    this.scene.remove(body.root);
    for (const group of groupsOf(body)) this.plain?.take(group);
    body.root.traverse((child) => {
      if (child instanceof Mesh) (child.geometry as BufferGeometry).dispose();
    });
    this.retired.push(...body.surfaces);
  }
}

type Row = [number, number, number, number, number, number, number, number, number, number, number, number];
