/**
 * Gates on the floor: two posts, a bar over them and a line between them, in the colour of what is to come next. Loaded with
 * the first gate; of three.js it has what it is given, so that the first view's file stays whole.
 */
import type * as three from 'three';
import type { GateModel } from '../contract.ts';
import type { Palette } from '../palette.ts';

type Kit = Pick<typeof three, 'BoxGeometry' | 'Group' | 'Mesh' | 'MeshBasicMaterial'>;
type Box = three.Mesh<three.BoxGeometry, three.MeshBasicMaterial>;

/** Height of the bar, thickness of post and bar, width of the line on the floor, m. */
const HEIGHT = 1.9;
const THICK = 0.05;
const LINE = 0.08;

const OPACITY = { done: 0.25, next: 1, ahead: 0.6 } as const;

export class Gates {
  private readonly scene: three.Scene;
  private readonly kit: Kit;
  private readonly drawn: three.Group[] = [];
  private readonly box: three.BoxGeometry;
  /** Neither shade nor fog: where to go is seen from afar. */
  private readonly looks: Readonly<Record<GateModel['state'], three.MeshBasicMaterial>>;

  constructor(scene: three.Scene, palette: Palette, kit: Kit) {
    const look = (opacity: number) =>
      new kit.MeshBasicMaterial({ transparent: opacity < 1, opacity, fog: false, toneMapped: false });
    this.scene = scene;
    this.kit = kit;
    this.box = new kit.BoxGeometry(1, 1, 1);
    this.looks = { done: look(OPACITY.done), next: look(OPACITY.next), ahead: look(OPACITY.ahead) };
    this.setPalette(palette);
  }

  /** @param floor height that they stand at, m */
  set(list: readonly GateModel[], floor: number): void {
    while (this.drawn.length > list.length) this.scene.remove(this.drawn.pop()!);
    while (this.drawn.length < list.length) this.drawn.push(this.build());
    list.forEach((gate, i) => this.place(this.drawn[i]!, gate, floor));
  }

  setPalette({ accent, label }: Palette): void {
    for (const [state, material] of Object.entries(this.looks)) material.color.set(state === 'next' ? accent : label);
  }

  dispose(): void {
    this.set([], 0);
    this.box.dispose();
    for (const material of Object.values(this.looks)) material.dispose();
  }

  private build(): three.Group {
    const group = new this.kit.Group();
    for (let part = 0; part < 4; part++) {
      const mesh = new this.kit.Mesh(this.box, this.looks.ahead);
      mesh.renderOrder = 1;
      group.add(mesh);
    }
    this.scene.add(group);
    return group;
  }

  private place(group: three.Group, { x, y, heading, half, state }: GateModel, floor: number): void {
    group.position.set(x, y, floor);
    group.rotation.z = heading;
    const [left, right, bar, line] = group.children as [Box, Box, Box, Box];
    left.position.set(0, half, HEIGHT / 2);
    right.position.set(0, -half, HEIGHT / 2);
    left.scale.set(THICK, THICK, HEIGHT);
    right.scale.copy(left.scale);
    bar.position.z = HEIGHT;
    bar.scale.set(THICK, 2 * half, THICK);
    line.position.z = 0.002;
    line.scale.set(LINE, 2 * half, 0.001);
    for (const mesh of group.children as Box[]) mesh.material = this.looks[state];
  }
}
