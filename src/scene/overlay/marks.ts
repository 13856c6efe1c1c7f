/** What is written on the bodies: their names, and axes at their origins. */
import { type Scene, AxesHelper, Color, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Bodies } from '../actors/bodies.ts';
import type { Palette } from '../palette.ts';
import { MARKS, type PixelSize, Word } from './words.ts';

/** Length of an axis, per metre of the cast's largest extent. */
const AXIS = 0.11;
const AXES = ['x', 'y', 'z'] as const;

/** Body frames in the colours that every tool gives x, y and z. */
function triad(material: LineMaterial): LineSegments2 {
  const axes = new AxesHelper(1);
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(axes.geometry.getAttribute('position').array as Float32Array);
  geometry.setColors(AXES.flatMap((axis) => [...AXIS_COLOURS[axis], ...AXIS_COLOURS[axis]]));
  axes.dispose();
  const line = new LineSegments2(geometry, material);
  line.matrixAutoUpdate = false;
  line.frustumCulled = false;
  line.renderOrder = 12;
  line.layers.set(MARKS);
  return line;
}

/** Red, green, blue, moderated so that each is seen on both grounds. */
const AXIS_COLOURS = {
  x: new Color('#e0524a').toArray() as [number, number, number],
  y: new Color('#3d9b4b').toArray() as [number, number, number],
  z: new Color('#4a7bea').toArray() as [number, number, number],
};

export class Marks {
  private readonly scene: Scene;
  private readonly bodies: Bodies;
  private palette: Palette;
  private pixel: PixelSize = { perPixel: 1e-3, ratio: 1 };
  private readonly material = new LineMaterial({
    linewidth: 2.5,
    vertexColors: true,
    depthTest: false,
    transparent: true,
    toneMapped: false,
    fog: false,
  });
  private names: Word[] = [];
  private triads: LineSegments2[] = [];
  /** At the tips of the subject's axes. */
  private letters: Word[] = [];

  constructor(scene: Scene, palette: Palette, bodies: Bodies) {
    this.scene = scene;
    this.palette = palette;
    this.bodies = bodies;
  }

  /** Puts what is wanted where the bodies are. @param size the cast's largest extent (m) */
  show(names: boolean, frames: boolean, subject: number, size: number): void {
    const { bodies } = this;
    resizeList(this.names, names ? bodies.count : 0, () => this.word());
    resizeList(this.letters, frames && bodies.count > 0 ? 3 : 0, () => this.word());
    while (this.triads.length > (frames ? bodies.count : 0)) {
      const gone = this.triads.pop()!;
      this.scene.remove(gone);
      gone.geometry.dispose();
    }
    while (frames && this.triads.length < bodies.count) {
      const line = triad(this.material);
      this.triads.push(line);
      this.scene.add(line);
    }
    this.names.forEach((word, i) => {
      const corners = bodies.shows(i) ? bodies.corners(i) : [];
      const model = bodies.modelOf(i);
      if (corners.length === 0 || !model || model.label === '') return word.hide();
      word.write(model.label ?? model.id, this.palette, this.palette.role[model.role]);
      const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
      for (const corner of corners) {
        low.min(corner);
        high.max(corner);
      }
      word.put(low.add(high).multiplyScalar(0.5).setZ(high.z), 8);
    });
    this.triads.forEach((line, i) => {
      const matrix = bodies.matrix(i);
      line.visible = matrix !== null && bodies.shows(i) && bodies.modelOf(i)?.label !== '';
      if (!line.visible) return;
      line.matrix.copy(matrix!).scale(place.setScalar(AXIS * size));
      line.matrixWorldNeedsUpdate = true;
    });
    this.letters.forEach((word, k) => {
      const matrix = bodies.matrix(subject);
      if (!matrix || !bodies.shows(subject)) return word.hide();
      word.write(AXES[k]!, this.palette, `#${new Color(...AXIS_COLOURS[AXES[k]!]).getHexString()}`);
      word.put(
        place
          .set(0, 0, 0)
          .setComponent(k, 1.12 * AXIS * size)
          .applyMatrix4(matrix),
        -9,
      );
    });
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
  }

  resize(pixel: PixelSize): void {
    this.pixel = pixel;
    for (const word of [...this.names, ...this.letters]) word.resize(pixel);
  }

  dispose(): void {
    this.show(false, false, 0, 1);
    this.material.dispose();
  }

  private word(): Word {
    const word = new Word(this.scene);
    word.resize(this.pixel);
    return word;
  }
}

function resizeList(list: Word[], count: number, make: () => Word): void {
  while (list.length > count) list.pop()!.dispose();
  while (list.length < count) list.push(make());
}

const place = new Vector3();
