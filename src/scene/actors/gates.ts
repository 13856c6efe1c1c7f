/**
 * Gates on the floor: two posts, a bar over them and a line between them, in the colour of what is to come next; all of them in one
 * mesh. Loaded with the first gate; of three.js it has what it is given, so that the first view's file stays whole.
 */
import type * as three from 'three';
import type { GateModel } from '../contract.ts';
import type { Palette } from '../palette.ts';

type Kit = Pick<
  typeof three,
  'BoxGeometry' | 'BufferAttribute' | 'BufferGeometry' | 'Color' | 'Mesh' | 'MeshBasicMaterial'
>;
type Triple = readonly [number, number, number];

/** Height of the bar, thickness of post and bar, width of the line on the floor, m. */
const HEIGHT = 1.9;
const THICK = 0.05;
const LINE = 0.08;

const OPACITY = { done: 0.25, next: 1, ahead: 0.6 } as const;

/** Middle and size of each box of a gate, along it, across it and up, m. */
const boxes = (half: number): readonly (readonly [Triple, Triple])[] => [
  [
    [0, half, HEIGHT / 2],
    [THICK, THICK, HEIGHT],
  ],
  [
    [0, -half, HEIGHT / 2],
    [THICK, THICK, HEIGHT],
  ],
  [
    [0, 0, HEIGHT],
    [THICK, 2 * half, THICK],
  ],
  [
    [0, 0, 0.002],
    [LINE, 2 * half, 0.001],
  ],
];

export class Gates {
  private readonly scene: three.Scene;
  private readonly kit: Kit;
  private readonly box: three.BoxGeometry;
  private readonly mesh: three.Mesh<three.BufferGeometry, three.MeshBasicMaterial>;
  private palette: Palette;
  private list: readonly GateModel[] = [];
  private floor = 0;

  constructor(scene: three.Scene, palette: Palette, kit: Kit) {
    this.scene = scene;
    this.kit = kit;
    this.palette = palette;
    this.box = new kit.BoxGeometry(1, 1, 1);
    // Neither shade nor fog: where to go is seen from afar.
    const look = new kit.MeshBasicMaterial({ vertexColors: true, transparent: true, fog: false, toneMapped: false });
    this.mesh = new kit.Mesh(new kit.BufferGeometry(), look);
    this.mesh.renderOrder = 1;
    scene.add(this.mesh);
  }

  /** @param floor height that they stand at, m */
  set(list: readonly GateModel[], floor: number): void {
    Object.assign(this, { list, floor });
    this.build();
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.build();
  }

  dispose(): void {
    this.scene.remove(this.mesh);
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.box.dispose();
  }

  private build(): void {
    const { box, kit, list, floor, palette } = this;
    const corners = box.getAttribute('position').array;
    const triangles = box.index!.array;
    const [points, colours, index]: number[][] = [[], [], []];
    // The last first: what is farther along the course lies behind.
    for (const { x, y, heading, half, state } of [...list].reverse()) {
      const { r, g, b } = new kit.Color(state === 'next' ? palette.accent : palette.label);
      const [c, s] = [Math.cos(heading), Math.sin(heading)];
      for (const [middle, size] of boxes(half)) {
        const first = points!.length / 3;
        for (let i = 0; i < corners.length; i += 3) {
          const [along, across, up] = middle.map((m, k) => m + size[k]! * corners[i + k]!) as [number, number, number];
          points!.push(x + c * along - s * across, y + s * along + c * across, floor + up);
          colours!.push(r, g, b, OPACITY[state]);
        }
        for (const corner of triangles) index!.push(first + corner);
      }
    }
    this.mesh.geometry.dispose();
    const geometry = new kit.BufferGeometry();
    geometry.setAttribute('position', new kit.BufferAttribute(Float32Array.from(points!), 3));
    geometry.setAttribute('color', new kit.BufferAttribute(Float32Array.from(colours!), 4));
    geometry.setIndex(index!);
    this.mesh.geometry = geometry;
    this.mesh.visible = list.length > 0;
  }
}
