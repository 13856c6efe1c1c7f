import * as THREE from 'three';
import type { Palette } from './palette.ts';

/** Soft studio light: sky and bounce, a key light whose shadow follows the board, a low fill for undersides. */
export class Lights {
  readonly group = new THREE.Group();
  private readonly sky = new THREE.HemisphereLight(0xffffff, 0xffffff, 1.5);
  private readonly key = new THREE.DirectionalLight(0xffffff, 2.4);
  private readonly fill = new THREE.DirectionalLight(0xffffff, 1.1);
  private readonly keyOffset = new THREE.Vector3(0.9, -1.3, 3.2);

  constructor() {
    this.sky.position.set(0, 0, 1);
    const { shadow } = this.key;
    this.key.castShadow = true;
    shadow.mapSize.set(1024, 1024);
    // A box of 1.4 m around the board: all of it, at about 1.4 mm a texel.
    Object.assign(shadow.camera, { left: -0.7, right: 0.7, top: 0.7, bottom: -0.7, near: 0.5, far: 7 });
    shadow.radius = 5;
    shadow.bias = -0.0004;
    shadow.normalBias = 0.004;
    this.fill.position.set(-2, 1.5, -0.6);
    this.group.add(this.sky, this.key, this.key.target, this.fill);
  }

  setPalette(palette: Palette): void {
    this.sky.color.set(palette.sky);
    this.sky.groundColor.set(palette.bounce);
  }

  /** With an environment map the sky light would count twice. */
  setEnvironment(present: boolean): void {
    this.sky.intensity = present ? 0.7 : 1.5;
  }

  follow(x: number, y: number, z: number): void {
    this.key.target.position.set(x, y, z);
    this.key.position.copy(this.key.target.position).add(this.keyOffset);
  }
}
