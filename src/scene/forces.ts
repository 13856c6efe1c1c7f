import * as THREE from 'three';
import type { Frame } from './contract.ts';
import type { Palette } from './palette.ts';

/** Metres drawn per newton, and the longest arrow: a board's weight (about 25 N a wheel) is a hand's breadth. */
export const METRES_PER_NEWTON = 0.006;
const LONGEST = 0.6;
const SHORTEST = 0.004;
const UP = new THREE.Vector3(0, 1, 0);

/** Thin for lateral, thick for vertical. */
const RADIUS = { lateral: 0.002, vertical: 0.004 } as const;

class Arrow {
  readonly group = new THREE.Group();
  readonly material = new THREE.MeshBasicMaterial({ toneMapped: false, depthTest: false, transparent: true, opacity: 0.95 });
  private readonly shaft: THREE.Mesh;
  private readonly head: THREE.Mesh;

  constructor(shaft: THREE.BufferGeometry, head: THREE.BufferGeometry) {
    this.shaft = new THREE.Mesh(shaft, this.material);
    this.head = new THREE.Mesh(head, this.material);
    // Drawn over the board: a force at the ground would be hidden by the wheel it acts on.
    this.shaft.renderOrder = this.head.renderOrder = 5;
    this.group.add(this.shaft, this.head);
  }

  point(origin: THREE.Vector3, vector: THREE.Vector3, radius: number): void {
    const length = Math.min(LONGEST, METRES_PER_NEWTON * vector.length());
    this.group.visible = length > SHORTEST;
    if (!this.group.visible) return;
    const head = Math.min(5 * radius, 0.6 * length);
    this.group.position.copy(origin);
    this.group.quaternion.setFromUnitVectors(UP, vector.clone().normalize());
    this.shaft.scale.set(radius, length - head, radius);
    this.head.scale.set(2.6 * radius, head, 2.6 * radius);
    this.head.position.y = length - head;
  }
}

/** Constraint forces on the wheels as arrows. */
export class Forces {
  readonly group = new THREE.Group();
  private readonly arrows: Arrow[] = [];
  // Unit geometries that stand on the origin and point along y.
  private readonly shaft = new THREE.CylinderGeometry(1, 1, 1, 10).translate(0, 0.5, 0);
  private readonly head = new THREE.ConeGeometry(1, 1, 14).translate(0, 0.5, 0);

  show(forces: Frame['forces'], palette: Palette): void {
    while (this.arrows.length < forces.length) {
      const arrow = new Arrow(this.shaft, this.head);
      this.arrows.push(arrow);
      this.group.add(arrow.group);
    }
    this.arrows.forEach((arrow, i) => {
      const force = forces[i];
      arrow.group.visible = force !== undefined;
      if (!force) return;
      arrow.material.color.set(palette[force.part]);
      arrow.point(new THREE.Vector3(...force.origin), new THREE.Vector3(...force.vector), RADIUS[force.kind]);
    });
  }
}
