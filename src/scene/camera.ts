import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { ViewName } from './contract.ts';

/** A slightly long lens: little distortion of a board half a metre away. */
const FIELD_OF_VIEW = 28;

/** Where a view looks from: along heading, to the left of it, and up, in metres for a landscape frame. */
export const viewOffsets: Readonly<Record<ViewName, { from: readonly [number, number, number]; at: 'board' | 'front-caster' }>> = {
  orbit: { from: [1.25, -1.45, 0.95], at: 'board' },
  front: { from: [2.1, 0, 0.12], at: 'board' },
  side: { from: [0, -2.3, 0.12], at: 'board' },
  // Straight down leaves the orbit no direction to turn in; a hair behind keeps the heading up.
  top: { from: [-0.004, 0, 2.6], at: 'board' },
  caster: { from: [0.26, -0.52, 0.1], at: 'front-caster' },
};

/** Camera and orbit; in follow mode both move with what the view looks at. */
export class Camera {
  readonly camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.02, 60);
  readonly controls: OrbitControls;
  follow = true;
  view: ViewName = 'orbit';
  private readonly focus = new THREE.Vector3();
  private readonly moved = new THREE.Vector3();

  constructor(element: HTMLElement, changed: () => void) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.minDistance = 0.15;
    this.controls.maxDistance = 12;
    this.controls.maxPolarAngle = 0.497 * Math.PI; // the eye stays above the level of what it looks at
    this.controls.addEventListener('change', changed);
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / height;
    // A narrow frame keeps the width of a square one, so that the board still fits.
    const half = THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2);
    this.camera.fov = this.camera.aspect >= 1.25 ? FIELD_OF_VIEW : THREE.MathUtils.radToDeg(2 * Math.atan((Math.tan(half) * 1.25) / this.camera.aspect));
    this.camera.updateProjectionMatrix();
  }

  /** What the current view looks at now; in follow mode the camera comes along (height stays, or bumps would shake it). */
  track(point: THREE.Vector3): void {
    this.moved.subVectors(point, this.focus);
    this.focus.copy(point);
    if (!this.follow) return;
    if (this.view !== 'caster') this.moved.z = 0;
    this.camera.position.add(this.moved);
    this.controls.target.add(this.moved);
    this.controls.update();
  }

  /** Looks at a point from the view's own direction relative to a heading (rad, about z). */
  setView(view: ViewName, point: THREE.Vector3, heading: number): void {
    this.view = view;
    this.focus.copy(point);
    const [ahead, left, up] = viewOffsets[view].from;
    const c = Math.cos(heading);
    const s = Math.sin(heading);
    this.controls.target.copy(point);
    this.camera.position.set(point.x + ahead * c - left * s, point.y + ahead * s + left * c, point.z + up);
    this.controls.update();
  }
}
