/** The pull of a hand: a line from the place that is held to where the hand is, an arrowhead, and the force in words. */
import {
  type PerspectiveCamera,
  type Scene,
  ConeGeometry,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Handle as Pull } from '../contract.ts';
import type { Palette } from '../palette.ts';
import { MARKS, type PixelSize, Word } from './words.ts';

/** CSS pixels. */
const WIDTH = 3;
const TIP = 14;
const DOT = 4;

export class Handle {
  private readonly scene: Scene;
  private readonly line: LineSegments2;
  private readonly tip: Mesh<ConeGeometry, MeshBasicMaterial>;
  private readonly dot: Mesh<SphereGeometry, MeshBasicMaterial>;
  private readonly word: Word;
  private readonly from = new Vector3();
  private readonly to = new Vector3();
  private palette: Palette;
  private label = '';
  private perPixel = 1e-3;

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.palette = palette;
    const geometry = new LineSegmentsGeometry().setPositions([0, 0, 0, 0, 0, 1]);
    // Over everything: what one pulls at is never hidden behind what one pulls.
    this.line = new LineSegments2(
      geometry,
      new LineMaterial({ linewidth: WIDTH, depthTest: false, transparent: true, toneMapped: false }),
    );
    const material = new MeshBasicMaterial({ depthTest: false, transparent: true, toneMapped: false, fog: false });
    this.tip = new Mesh(new ConeGeometry(0.36, 1, 16).translate(0, -0.5, 0), material);
    this.dot = new Mesh(new SphereGeometry(1, 16, 12), material);
    for (const part of [this.line, this.tip, this.dot]) {
      part.renderOrder = 18;
      part.frustumCulled = false;
      part.layers.set(MARKS);
      part.visible = false;
      scene.add(part);
    }
    this.word = new Word(scene);
    this.setPalette(palette);
  }

  set(pull: Pull | null): void {
    for (const part of [this.line, this.tip, this.dot]) part.visible = pull !== null;
    if (!pull) return this.word.hide();
    this.from.set(...pull.from);
    this.to.set(...pull.to);
    this.label = pull.label;
    this.word.write(pull.label, this.palette, this.palette.accent);
    this.word.put(this.to, 12);
    this.dot.position.copy(this.from);
    this.tip.position.copy(this.to);
    direction.subVectors(this.to, this.from);
    if (direction.lengthSq() > 0) this.tip.quaternion.setFromUnitVectors(up, direction.normalize());
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.line.material.color.set(palette.accent);
    this.tip.material.color.set(palette.accent);
    this.word.write(this.label, palette, palette.accent);
  }

  resize(size: PixelSize): void {
    this.perPixel = size.perPixel;
    this.word.resize(size);
  }

  /** Before each picture: keeps its size on the screen. */
  follow(camera: PerspectiveCamera): void {
    if (!this.line.visible) return;
    const pixel = (place: Vector3): number => this.perPixel * place.distanceTo(camera.position);
    const length = this.from.distanceTo(this.to);
    const tip = Math.min(TIP * pixel(this.to), 0.6 * length);
    this.dot.scale.setScalar(DOT * pixel(this.from));
    this.tip.scale.setScalar(Math.max(tip, 1e-6));
    direction
      .subVectors(this.to, this.from)
      .multiplyScalar(length > 0 ? 1 - tip / length : 1)
      .add(this.from);
    this.line.geometry.setPositions([...this.from.toArray(), ...direction.toArray()]);
  }

  dispose(): void {
    for (const part of [this.line, this.tip, this.dot]) {
      this.scene.remove(part);
      part.geometry.dispose();
      part.material.dispose();
    }
    this.word.dispose();
  }
}

const up = new Vector3(0, 1, 0);
const direction = new Vector3();
