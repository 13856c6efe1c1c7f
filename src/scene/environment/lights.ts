/** Studio light: a wide sky, one key light with the shadow, and (where affordable) a room to mirror. */
import { type Scene, DirectionalLight, HemisphereLight, type Texture } from 'three';
import type { Palette } from '../palette.ts';

/** Half of the shadowed square and where the key light stands, both per metre of what is lit: steep, so that the shadow lies under it and tells its height. */
const REACH = 0.7;
const KEY = [0.57, -0.48, 1.93] as const;

export class Lights {
  private readonly scene: Scene;
  private readonly hemisphere = new HemisphereLight();
  private readonly key = new DirectionalLight();
  private room: Texture | null = null;
  private palette: Palette;
  private size = 0.88;

  constructor(scene: Scene, palette: Palette, shadowSize: number) {
    this.scene = scene;
    this.palette = palette;
    this.hemisphere.position.set(0, 0, 1); // its axis: up is z here
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(shadowSize, shadowSize);
    this.key.shadow.radius = 7;
    this.key.shadow.bias = -0.0004;
    this.setSize(this.size);
    scene.add(this.hemisphere, this.key, this.key.target);
    this.setPalette(palette);
  }

  get hasRoom(): boolean {
    return this.room !== null;
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.hemisphere.color.set(palette.sky);
    this.hemisphere.groundColor.set(palette.bounce);
    this.key.color.set(palette.key);
    this.key.intensity = palette.light.key;
    // The room brings its own soft light: the sky gives way to it.
    this.hemisphere.intensity = palette.light.hemisphere * (this.room ? 0.45 : 1);
    this.scene.environmentIntensity = palette.light.environment;
  }

  setShadows(shown: boolean): void {
    this.key.castShadow = shown;
  }

  /** Largest extent of what is lit (m); the board's is 0.88. */
  setSize(size: number): void {
    this.size = size;
    const reach = REACH * size;
    Object.assign(this.key.shadow.camera, {
      left: -reach,
      right: reach,
      top: reach,
      bottom: -reach,
      near: 0.1 * size,
      far: 5.1 * size,
    });
    this.key.shadow.camera.updateProjectionMatrix();
    this.key.shadow.normalBias = 0.0045 * size;
  }

  /** Keeps the shadow around the subject (m). One high above the floor takes its light down with it. */
  follow(x: number, y: number, z: number, floor: number): void {
    const { size } = this;
    const height = Math.min(Math.max(z - floor, 0), 2.3 * size);
    this.key.target.position.set(x, y, z - height);
    this.key.position.set(x + KEY[0] * size, y + KEY[1] * size, z + KEY[2] * size);
  }

  /** @param light of a room, from then on the scene's own */
  setRoom(light: Texture): void {
    this.dropRoom();
    this.room = light;
    this.scene.environment = light;
    this.setPalette(this.palette);
  }

  dropRoom(): void {
    this.room?.dispose();
    this.room = null;
    this.scene.environment = null;
    this.setPalette(this.palette);
  }

  dispose(): void {
    this.dropRoom();
    this.key.shadow.map?.dispose();
  }
}
