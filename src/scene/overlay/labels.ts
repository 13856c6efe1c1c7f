/** Metre labels on the ground's strong lines: along x and along y through the crossing nearest to what is looked at. */
import {
  type Scene,
  type Vector3,
  CanvasTexture,
  LinearFilter,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector2,
} from 'three';
import type { Palette } from '../palette.ts';
import { MARKS, type PixelSize } from './words.ts';
import type { ScreenBox } from '../contract.ts';
import type { Triple } from '../camera/views.ts';

/** Labels to either side of the crossing. */
const SIDE = 4;
/** Height of a label (CSS pixels); the text is a little smaller. */
const HEIGHT = 18;
const ASPECT = 4;
/** Width of what is written on a label (CSS pixels). */
const WRITTEN = 44;
const MINUS = '\u2212';
const THIN_SPACE = '\u2009';
/** The y label of the crossing itself, which carries x: none. */
const CROSSING = 2 * SIDE + 1;
/** Textures kept when they go out of sight. */
const KEPT = 64;

/** `x −3 m` with a true minus sign and a thin space before the unit. */
export function metreLabel(axis: 'x' | 'y', metres: number): string {
  const rounded = Number(metres.toFixed(3));
  return `${axis} ${rounded < 0 ? MINUS : ''}${Math.abs(rounded)}${THIN_SPACE}m`;
}

/** Metres between labels at a distance (m), in steps of 1, 2, 5, 10 strong lines, `unit` (m) apart. */
export function labelStep(distance: number, unit = 1): number {
  return unit * ([1, 2, 5].find((step) => distance < 7 * step * unit) ?? 10);
}

export class Labels {
  private readonly sprites: Sprite[] = [];
  private readonly textures = new Map<string, CanvasTexture>();
  private readonly scene: Scene;
  private colour: string;
  private shown = '';
  private ratio = 1;
  private unit = 1;
  private floor = 0;
  private hidden = false;

  constructor(scene: Scene, palette: Palette) {
    this.scene = scene;
    this.colour = palette.label;
    for (let i = 0; i < 2 * (2 * SIDE + 1); i++) {
      const sprite = new Sprite(
        new SpriteMaterial({ sizeAttenuation: false, depthWrite: false, transparent: true, toneMapped: false }),
      );
      sprite.renderOrder = -8;
      sprite.layers.set(MARKS);
      sprite.center = new Vector2(0, 1.05);
      this.sprites.push(sprite);
    }
    scene.add(...this.sprites);
  }

  setShown(shown: boolean): void {
    this.hidden = !shown;
    this.shown = '';
    for (const sprite of this.sprites) sprite.visible = false;
  }

  setPalette(palette: Palette): void {
    if (palette.label === this.colour) return;
    this.colour = palette.label;
    this.forget();
  }

  /** Height of the floor, distance of the strong lines (m). */
  setPlan(floor: number, unit: number): void {
    this.floor = floor;
    this.unit = unit;
    this.shown = '';
  }

  /** Labels keep their size on the screen. */
  resize({ perPixel, ratio }: PixelSize): void {
    const scale = perPixel * HEIGHT;
    for (const sprite of this.sprites) sprite.scale.set(ASPECT * scale, scale, 1);
    if (this.ratio === ratio) return;
    this.ratio = ratio;
    this.forget();
  }

  /** Rewrites the labels when the nearest crossing or the step changed: rarely. */
  follow(target: Vector3, distance: number): void {
    if (this.hidden) return;
    const step = labelStep(distance, this.unit);
    const x = step * Math.round(target.x / step);
    const y = step * Math.round(target.y / step);
    const state = `${x} ${y} ${step}`;
    if (state === this.shown) return;
    this.shown = state;
    if (this.textures.size > KEPT) this.forgetTextures();
    let next = 0;
    for (let k = -SIDE; k <= SIDE; k++) {
      this.write(this.sprites[next++]!, metreLabel('x', x + k * step), x + k * step, y, Math.abs(k));
      const beside = this.sprites[next++]!;
      if (k !== 0) this.write(beside, metreLabel('y', y + k * step), x, y + k * step, Math.abs(k));
    }
  }

  /** A label that would run into a body is not drawn. @param place on the screen (CSS pixels) of a point (m) */
  avoid(boxes: readonly ScreenBox[], place: (world: Triple) => { x: number; y: number } | null): void {
    if (this.hidden) return;
    this.sprites.forEach((sprite, i) => {
      if (i === CROSSING) return void (sprite.visible = false);
      const at = place(sprite.position.toArray());
      sprite.visible =
        at !== null &&
        !boxes.some(
          ({ left, right, top, bottom }) =>
            at.x < right && at.x + WRITTEN > left && at.y < bottom && at.y + HEIGHT > top,
        );
    });
  }

  dispose(): void {
    this.scene.remove(...this.sprites);
    for (const sprite of this.sprites) sprite.material.dispose();
    this.forgetTextures();
  }

  private write(sprite: Sprite, text: string, x: number, y: number, away: number): void {
    sprite.position.set(x, y, this.floor);
    sprite.material.map = this.textureOf(text);
    sprite.material.opacity = 1 - (0.75 * away) / SIDE;
    sprite.material.needsUpdate = true;
  }

  private textureOf(text: string): CanvasTexture {
    const known = this.textures.get(text);
    if (known) return known;
    const canvas = document.createElement('canvas');
    const scale = 2 * Math.max(1, this.ratio);
    canvas.width = HEIGHT * ASPECT * scale;
    canvas.height = HEIGHT * scale;
    const context = canvas.getContext('2d');
    if (context) {
      context.scale(scale, scale);
      context.font = '500 12px system-ui, sans-serif';
      context.textBaseline = 'middle';
      context.fillStyle = this.colour;
      context.fillText(text, 5, HEIGHT / 2);
    }
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    texture.minFilter = LinearFilter;
    texture.generateMipmaps = false;
    this.textures.set(text, texture);
    return texture;
  }

  /** Writes every label anew. */
  forget(): void {
    this.forgetTextures();
    this.shown = '';
  }

  private forgetTextures(): void {
    for (const texture of this.textures.values()) texture.dispose();
    this.textures.clear();
  }
}
