/** Everything that stands in the scene besides its camera, in one hand. */
import type { Scene } from 'three';
import { Bodies } from './bodies.ts';
import type { StagePlan, Switches } from '../contract.ts';
import { Forces } from '../overlay/forces.ts';
import { Ghosts } from './ghosts.ts';
import { Ground } from '../environment/ground.ts';
import { Handle } from '../overlay/handle.ts';
import { Labels } from '../overlay/labels.ts';
import { Lights } from '../environment/lights.ts';
import { Marks } from '../overlay/marks.ts';
import type { Palette } from '../palette.ts';
import { Trails } from '../overlay/trails.ts';
import type { PixelSize } from '../overlay/words.ts';

export class Parts {
  readonly lights: Lights;
  readonly ground: Ground;
  readonly labels: Labels;
  readonly bodies: Bodies;
  readonly ghosts: Ghosts;
  readonly trails: Trails;
  readonly forces: Forces;
  readonly handle: Handle;
  readonly marks: Marks;

  constructor(scene: Scene, palette: Palette, shadowSize: number) {
    this.lights = new Lights(scene, palette, shadowSize);
    this.ground = new Ground(scene, palette);
    this.labels = new Labels(scene, palette);
    this.bodies = new Bodies(scene, palette);
    this.ghosts = new Ghosts(scene, palette, this.bodies);
    this.trails = new Trails(scene, palette);
    this.forces = new Forces(scene, palette);
    this.handle = new Handle(scene, palette);
    this.marks = new Marks(scene, palette, this.bodies);
  }

  setPalette(palette: Palette): void {
    const { lights, ground, labels, ghosts, trails, forces, handle, marks } = this;
    for (const part of [lights, ground, labels, ghosts, trails, forces, handle, marks]) part.setPalette(palette);
    this.bodies.setLook(palette, lights.hasRoom);
  }

  /** Height of the floor, largest extent of what stands on it, distance of the strong lines (m). */
  setPlan(floor: number, size: number, unit: number): void {
    this.lights.setSize(size);
    this.ground.setPlan(floor, size, unit);
    this.labels.setPlan(floor, unit);
    this.trails.setPlan(floor, size);
  }

  /** Without shadows, the ground's grain and its metres, which few pixels can't tell; of tracks the newest alone. */
  setPlain(plain: boolean): void {
    this.lights.setShadows(!plain);
    this.ground.setPlain(plain);
    this.trails.setShort(plain);
    this.labels.setShown(!plain);
  }

  /** Light and ground go with the subject. @param height (m) of a board that is not on both its wheels */
  follow({ subject, floor }: StagePlan, heading: number, height: number): void {
    const { bodies } = this;
    const at = bodies.originOf(subject)!.toArray();
    const [front, back] = bodies.wheeled().map((i) => bodies.originOf(i)?.toArray() ?? null);
    const lowest = front && back ? Math.min(front[2], back[2]) : height;
    this.ground.followBoard(at, heading, Math.abs(lowest), front ?? null, back ?? null);
    this.ground.uncover(bodies.lowest());
    this.lights.follow(...at, floor);
  }

  /** Another picture: how large its pixels are. */
  resize(pixel: PixelSize): void {
    for (const part of [this.labels, this.trails, this.ghosts, this.handle, this.marks]) part.resize(pixel);
  }

  /** Names and axes, once bodies have moved or switches have changed. */
  mark(switches: Switches, subject: number, size: number): void {
    this.marks.show(switches.names, switches.frames, subject, size);
  }

  dispose(): void {
    const { lights, ground, labels, ghosts, bodies, trails, forces, handle, marks } = this;
    for (const part of [lights, ground, labels, ghosts, bodies, trails, forces, handle, marks]) part.dispose();
  }
}
