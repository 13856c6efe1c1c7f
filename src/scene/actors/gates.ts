/** Gates on the floor: two posts, a bar over them and a line between them, in the colour of what is to come next. */
import { type Scene, BoxGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial } from 'three';
import type { GateModel } from '../contract.ts';
import type { Palette } from '../palette.ts';

/** Height of the bar, thickness of post and bar, width of the line on the floor, m. */
const HEIGHT = 1.9;
const RADIUS = 0.03;
const LINE = 0.08;

const OPACITY = { done: 0.25, next: 1, ahead: 0.6 } as const;

export class Gates {
  private readonly scene: Scene;
  private palette: Palette;
  private floor = 0;
  private list: readonly GateModel[] = [];
  private readonly drawn: Group[] = [];
  private readonly post = new CylinderGeometry(RADIUS, RADIUS, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  private readonly bar = new BoxGeometry(2 * RADIUS, 1, 2 * RADIUS);
  /** Neither shade nor fog: where to go is seen from afar. */
  private readonly looks = {
    done: look(OPACITY.done),
    next: look(OPACITY.next),
    ahead: look(OPACITY.ahead),
  };

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.palette = palette;
    this.setPalette(palette);
  }

  set(list: readonly GateModel[]): void {
    this.list = list;
    while (this.drawn.length > list.length) this.scene.remove(this.drawn.pop()!);
    while (this.drawn.length < list.length) this.drawn.push(this.build());
    list.forEach((gate, i) => this.place(this.drawn[i]!, gate));
  }

  setPlan(floor: number): void {
    this.floor = floor;
    this.set(this.list);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const [state, material] of Object.entries(this.looks))
      material.color.set(state === 'next' ? this.palette.accent : this.palette.label);
  }

  dispose(): void {
    this.set([]);
    this.post.dispose();
    this.bar.dispose();
    for (const material of Object.values(this.looks)) material.dispose();
  }

  private build(): Group {
    const group = new Group();
    for (const geometry of [this.post, this.post, this.bar, this.bar]) {
      const mesh = new Mesh(geometry, this.looks.ahead);
      mesh.renderOrder = 1;
      group.add(mesh);
    }
    this.scene.add(group);
    return group;
  }

  private place(group: Group, { x, y, heading, half, state }: GateModel): void {
    group.position.set(x, y, this.floor);
    group.rotation.z = heading;
    const [left, right, bar, line] = group.children as [Mesh, Mesh, Mesh, Mesh];
    left.position.y = half;
    right.position.y = -half;
    left.scale.z = right.scale.z = HEIGHT;
    bar.position.z = HEIGHT;
    bar.scale.y = 2 * half;
    line.position.z = 0.002;
    line.scale.set(LINE / (2 * RADIUS), 2 * half, 0.01);
    for (const mesh of group.children as Mesh[]) mesh.material = this.looks[state];
  }
}

const look = (opacity: number): MeshBasicMaterial =>
  new MeshBasicMaterial({ transparent: opacity < 1, opacity, fog: false, toneMapped: false });
