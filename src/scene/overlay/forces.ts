/** Constraint forces as arrows at the skate points: thin for lateral, thick for vertical, in the colour of their part. */
import {
  type Scene,
  ConeGeometry,
  Color,
  CylinderGeometry,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
} from 'three';
import type { Frame } from '../contract.ts';
import type { Palette } from '../palette.ts';

/** Metres of arrow per newton unless another scale is chosen: the same in every picture, so that arrows can be compared. */
export const METRES_PER_NEWTON = 0.01;
/** Longest arrow (m): a force beyond it is shown at this length. */
export const LONGEST = 0.6;
/** Forces below this (N) are not drawn. */
const LEAST = 0.05;
const MOST = 8;
const RADIUS = { lateral: 0.0025, vertical: 0.005 } as const;

/** Length (m) of the arrow for a force (N): proportional, then clamped. */
export function arrowLength(newtons: number, metresPerNewton = METRES_PER_NEWTON): number {
  return newtons < LEAST ? 0 : Math.min(newtons * metresPerNewton, LONGEST);
}

export class Forces {
  private readonly shafts: InstancedMesh;
  private readonly heads: InstancedMesh;
  /** The same arrows, faint, through the board that hides them. */
  private readonly ghosts: readonly [InstancedMesh, InstancedMesh];
  private readonly scene: Scene;
  private palette: Palette;
  private shown: Frame['forces'][number]['role'][] = [];

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.palette = palette;
    // Unit height from the origin along y, three's own axis for both.
    const shaft = new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0);
    const head = new ConeGeometry(1, 1, 16).translate(0, 0.5, 0);
    // Drawn after the ground, which would cover an arrow that dips below it.
    const solid = new MeshLambertMaterial({ toneMapped: false, transparent: true });
    const faint = new MeshBasicMaterial({
      toneMapped: false,
      transparent: true,
      opacity: 0.4,
      depthTest: false,
      depthWrite: false,
    });
    this.shafts = new InstancedMesh(shaft, solid, MOST);
    this.heads = new InstancedMesh(head, solid, MOST);
    this.ghosts = [new InstancedMesh(shaft, faint, MOST), new InstancedMesh(head, faint, MOST)];
    this.ghosts[0].instanceMatrix = this.shafts.instanceMatrix;
    this.ghosts[1].instanceMatrix = this.heads.instanceMatrix;
    for (const mesh of [this.shafts, this.heads, ...this.ghosts]) {
      mesh.frustumCulled = false;
      mesh.count = 0;
      mesh.visible = false;
      mesh.renderOrder = 5;
      scene.add(mesh);
    }
  }

  set(forces: Frame['forces'], visible: boolean, metresPerNewton = METRES_PER_NEWTON): void {
    let n = 0;
    this.shown = [];
    for (const force of visible ? forces : []) {
      const newtons = Math.hypot(...force.vector);
      const length = arrowLength(newtons, metresPerNewton);
      if (n === MOST || !(length > 0)) continue;
      this.place(n++, force, length, newtons);
      this.shown.push(force.role);
    }
    for (const mesh of [this.shafts, this.heads, ...this.ghosts]) {
      mesh.count = n;
      mesh.visible = n > 0;
    }
    this.shafts.instanceMatrix.needsUpdate = this.heads.instanceMatrix.needsUpdate = true;
    this.setPalette(this.palette);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.shown.forEach((role, i) => {
      this.shafts.setColorAt(i, colour.set(palette.role[role]));
      this.heads.setColorAt(i, colour);
    });
    this.ghosts[0].instanceColor = this.shafts.instanceColor;
    this.ghosts[1].instanceColor = this.heads.instanceColor;
    if (this.shafts.instanceColor) this.shafts.instanceColor.needsUpdate = true;
    if (this.heads.instanceColor) this.heads.instanceColor.needsUpdate = true;
  }

  dispose(): void {
    for (const mesh of [this.shafts, this.heads, ...this.ghosts]) {
      this.scene.remove(mesh);
      mesh.geometry.dispose();
      (mesh.material as MeshBasicMaterial).dispose();
      mesh.dispose();
    }
  }

  private place(i: number, force: Frame['forces'][number], length: number, newtons: number): void {
    const radius = RADIUS[force.kind];
    const tip = Math.min(7 * radius, 0.6 * length);
    const width = Math.min(2.6 * radius, 0.45 * tip);
    direction.set(...force.vector).divideScalar(newtons);
    turn.setFromUnitVectors(up, direction);
    start.set(...force.origin);
    this.shafts.setMatrixAt(i, matrix.compose(start, turn, size.set(radius, length - tip, radius)));
    start.addScaledVector(direction, length - tip);
    this.heads.setMatrixAt(i, matrix.compose(start, turn, size.set(width, tip, width)));
  }
}

const up = new Vector3(0, 1, 0);
const direction = new Vector3();
const start = new Vector3();
const size = new Vector3();
const turn = new Quaternion();
const matrix = new Matrix4();
const colour = new Color();
