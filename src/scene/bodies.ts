import * as THREE from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import type { BodyPart, MeshPair } from './contract.ts';
import { materialFor } from './materials.ts';
import type { Palette } from './palette.ts';

/** One rigid body on the stage: an object whose matrix is the pose, and the wheel in it that can spin. */
class Body {
  readonly root = new THREE.Group();
  readonly part: BodyPart['part'];
  private wheel: THREE.Group | null = null;

  constructor(id: string, part: BodyPart['part']) {
    this.root.name = id;
    this.root.matrixAutoUpdate = false;
    this.part = part;
  }

  /** Puts other meshes in place; `hub` is the wheel's centre in the body's frame. */
  dress(model: THREE.Group, hub: THREE.Vector3): void {
    this.clear();
    this.wheel = new THREE.Group();
    this.wheel.position.copy(hub);
    this.root.add(this.wheel);
    for (const mesh of [...model.children]) {
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      if (mesh.name === 'wheel' && mesh instanceof THREE.Mesh) {
        (mesh.geometry as THREE.BufferGeometry).translate(-hub.x, -hub.y, -hub.z);
        this.wheel.add(mesh);
      } else {
        this.root.add(mesh);
      }
    }
  }

  spin(angle: number): void {
    if (this.wheel) this.wheel.rotation.y = angle;
  }

  recolour(palette: Palette): void {
    this.root.traverse((object) => {
      if (!(object instanceof THREE.Mesh)) return;
      for (const material of [object.material].flat() as THREE.MeshStandardMaterial[]) {
        if (material.name === 'accent') material.color.set(palette[this.part]);
      }
    });
  }

  clear(): void {
    this.root.traverse((object) => {
      if (!(object instanceof THREE.Mesh)) return;
      (object.geometry as THREE.BufferGeometry).dispose();
      for (const material of [object.material].flat() as THREE.Material[]) material.dispose();
    });
    this.root.clear();
    this.wheel = null;
  }
}

/** All bodies of the system on the stage, in the order of their poses. */
export class Bodies {
  readonly group = new THREE.Group();
  private list: Body[] = [];
  private readonly matrix = new THREE.Matrix4();

  /** Replaces every body. `hubs` are wheel centres by body; bodies without one have none to spin. */
  set(parts: readonly BodyPart[], models: readonly MeshPair[], hubs: readonly (readonly [number, number, number])[], palette: Palette): void {
    // All are read before any is put in place: a bad file leaves the stage as it was.
    const read = parts.map((part, i) => readModel(part.id, models[i]!, palette[part.part]));
    for (const body of this.list) body.clear();
    this.group.clear();
    this.list = parts.map((part, i) => {
      const body = new Body(part.id, part.part);
      body.dress(read[i]!, new THREE.Vector3(...hubs[i]!));
      this.group.add(body.root);
      return body;
    });
  }

  get count(): number {
    return this.list.length;
  }

  pose(poses: Float64Array): void {
    this.list.forEach((body, i) => {
      const o = 12 * i;
      this.matrix.set(
        poses[o + 3]!, poses[o + 4]!, poses[o + 5]!, poses[o]!,
        poses[o + 6]!, poses[o + 7]!, poses[o + 8]!, poses[o + 1]!,
        poses[o + 9]!, poses[o + 10]!, poses[o + 11]!, poses[o + 2]!,
        0, 0, 0, 1,
      );
      body.root.matrix.copy(this.matrix);
      body.root.matrixWorldNeedsUpdate = true;
    });
  }

  /** Wheel angles (rad) by body. */
  spin(angles: ReadonlyMap<number, number>): void {
    for (const [body, angle] of angles) this.list[body]?.spin(angle);
  }

  recolour(palette: Palette): void {
    for (const body of this.list) body.recolour(palette);
  }

  setVisible(index: number, visible: boolean): void {
    const body = this.list[index];
    if (body) body.root.visible = visible;
  }

  matrixOf(index: number): THREE.Matrix4 | null {
    return this.list[index]?.root.matrix ?? null;
  }

  boxOf(index: number): THREE.Box3 | null {
    const body = this.list[index];
    return body ? new THREE.Box3().setFromObject(body.root) : null;
  }
}

/**
 * Meshes of a .mdl/.mat pair (Wavefront OBJ and MTL text).
 * @throws Error naming the body and what is wrong with its file
 */
export function readModel(id: string, pair: MeshPair, accent: string): THREE.Group {
  const creator = new MTLLoader().parse(pair.mat, '');
  creator.preload();
  const model = new OBJLoader().setMaterials(creator).parse(pair.mdl);
  let triangles = 0;
  for (const object of model.children) {
    if (!(object instanceof THREE.Mesh)) continue;
    const geometry = object.geometry as THREE.BufferGeometry;
    const positions = geometry.getAttribute('position');
    if (!(positions.array as Float32Array).every(Number.isFinite)) throw new Error(`${id}.mdl: a face of "${object.name}" names a point that does not exist or is not a number`);
    triangles += positions.count / 3;
    const materials = ([object.material].flat() as THREE.Material[]).map((m) => materialFor(m, accent));
    object.material = Array.isArray(object.material) ? materials : materials[0]!;
  }
  if (triangles === 0) throw new Error(`${id}.mdl: there are no faces in it; a mesh needs v and f lines`);
  return model;
}
