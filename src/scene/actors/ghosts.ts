/** Other motions of the cast: translucent, shadowless, in the geometry of the bodies themselves. */
import { type Group, type Scene, Mesh, MeshLambertMaterial, Vector3 } from 'three';
import { type Bodies, setPose } from './bodies.ts';
import type { Ghost } from '../contract.ts';
import type { Palette } from '../palette.ts';
import { type PixelSize, Word } from '../overlay/words.ts';

const OPACITY = 0.34;

interface Drawn {
  /** Copies of the bodies' roots, with the wheel of each that has one. */
  roots: Group[];
  wheels: (Group | null)[];
  material: MeshLambertMaterial;
  word: Word;
  /** The last of it, for a cast in other meshes. */
  ghost: Ghost;
}

export class Ghosts {
  private readonly scene: Scene;
  private readonly bodies: Bodies;
  private palette: Palette;
  private size: PixelSize = { perPixel: 1e-3, ratio: 1 };
  private readonly drawn = new Map<string, Drawn>();
  /** Of ghosts that went, for those to come: what is new has its shaders compiled anew. */
  private readonly spare: Pick<Drawn, 'material' | 'word'>[] = [];
  /** Of the bodies whose geometry is borrowed. */
  private version = -1;

  constructor(scene: Scene, palette: Palette, bodies: Bodies) {
    this.scene = scene;
    this.palette = palette;
    this.bodies = bodies;
  }

  set(ghosts: readonly Ghost[]): void {
    const ids = new Set(ghosts.map(({ id }) => id));
    for (const id of [...this.drawn.keys()]) if (!ids.has(id)) this.remove(id);
    for (const ghost of ghosts) {
      if (!this.drawn.has(ghost.id)) this.add(ghost);
      this.place(this.drawn.get(ghost.id)!, ghost);
    }
  }

  /** After the bodies have changed their meshes. */
  follow(): void {
    if (this.version === this.bodies.version) return;
    this.version = this.bodies.version;
    const kept = [...this.drawn.values()].map(({ ghost }) => ghost);
    for (const id of [...this.drawn.keys()]) this.remove(id);
    this.set(kept);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const { word, ghost } of this.drawn.values()) word.write(ghost.label, palette, ghost.tint);
  }

  resize(size: PixelSize): void {
    this.size = size;
    for (const { word } of this.drawn.values()) word.resize(size);
  }

  dispose(): void {
    for (const id of [...this.drawn.keys()]) this.remove(id);
    for (const { material, word } of this.spare.splice(0)) {
      material.dispose();
      word.dispose();
    }
  }

  private add(ghost: Ghost): void {
    this.version = this.bodies.version;
    const { material, word } = this.spare.pop() ?? {
      material: new MeshLambertMaterial({ transparent: true, opacity: OPACITY, toneMapped: false }),
      word: new Word(this.scene),
    };
    word.resize(this.size);
    const roots = this.bodies.roots().map((root) => {
      const copy = root.clone(true);
      copy.visible = true;
      copy.traverse((child) => {
        if (!(child instanceof Mesh)) return;
        child.material = material;
        child.castShadow = child.receiveShadow = false;
        child.renderOrder = 2;
      });
      this.scene.add(copy);
      return copy;
    });
    const wheels = roots.map(
      (root) => (root.children.find((child) => child.userData['wheel']) as Group | undefined) ?? null,
    );
    this.drawn.set(ghost.id, { roots, wheels, material, word, ghost });
  }

  private place(drawn: Drawn, ghost: Ghost): void {
    const { roots, wheels, material, word } = drawn;
    drawn.ghost = { ...ghost, poses: ghost.poses.slice(), wheelAngles: ghost.wheelAngles.slice() };
    material.color.set(ghost.tint);
    material.emissive.set(ghost.tint).multiplyScalar(0.25);
    roots.forEach((root, i) => {
      root.visible = setPose(root, ghost.poses, i);
      const wheel = wheels[i];
      if (wheel) wheel.rotation.y = ghost.wheelAngles[this.bodies.modelOf(i)?.spin?.contact ?? -1] ?? 0;
    });
    word.write(ghost.label, this.palette, ghost.tint);
    const first = roots[0];
    if (first?.visible) word.put(new Vector3().setFromMatrixPosition(first.matrix), 24);
    else word.hide();
  }

  private remove(id: string): void {
    const drawn = this.drawn.get(id);
    if (!drawn) return;
    this.scene.remove(...drawn.roots);
    drawn.word.hide();
    this.spare.push({ material: drawn.material, word: drawn.word });
    this.drawn.delete(id);
  }
}
