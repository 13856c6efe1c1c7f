/** Words in the scene that keep their size on the screen, on a veil that keeps them readable. */
import { type Scene, CanvasTexture, LinearFilter, Sprite, SpriteMaterial, SRGBColorSpace, type Vector3 } from 'three';
import type { Palette } from '../palette.ts';

/** What only the large picture shows: words and marks, not the inset. */
export const MARKS = 1;
/** CSS pixels. */
const HEIGHT = 18;
const PADDING = 5;
const FONT = '600 12px system-ui, sans-serif';

/** What a picture's pixels are: their size at a metre's distance (m), and how many of the device's make one. */
export interface PixelSize {
  perPixel: number;
  ratio: number;
}

export class Word {
  readonly sprite: Sprite;
  private readonly scene: Scene;
  private text = '';
  private colour = '';
  private veil = '';
  private size: PixelSize = { perPixel: 1e-3, ratio: 1 };
  private width = 0;

  constructor(scene: Scene) {
    this.scene = scene;
    this.sprite = new Sprite(
      new SpriteMaterial({
        sizeAttenuation: false,
        depthTest: false,
        depthWrite: false,
        transparent: true,
        toneMapped: false,
        fog: false,
      }),
    );
    this.sprite.renderOrder = 20;
    this.sprite.layers.set(MARKS);
    this.sprite.visible = false;
    scene.add(this.sprite);
  }

  /** @param colour CSS; the palette's label without one */
  write(text: string, palette: Palette, colour = palette.label): void {
    if (text === this.text && colour === this.colour && palette.background === this.veil) return;
    this.text = text;
    this.colour = colour;
    this.veil = palette.background;
    if (text !== '') this.draw();
  }

  /** Above a place (m), by so many CSS pixels. */
  put(place: Vector3, above = 10): void {
    this.sprite.position.copy(place);
    this.sprite.center.set(0.5, -above / HEIGHT);
    this.sprite.visible = this.text !== '';
  }

  hide(): void {
    this.sprite.visible = false;
  }

  resize(size: PixelSize): void {
    const sharper = size.ratio !== this.size.ratio;
    this.size = size;
    if (sharper && this.text) this.draw();
    else this.fit();
  }

  dispose(): void {
    this.scene.remove(this.sprite);
    this.sprite.material.map?.dispose();
    this.sprite.material.dispose();
  }

  private fit(): void {
    this.sprite.scale.set(this.width * this.size.perPixel, HEIGHT * this.size.perPixel, 1);
  }

  private draw(): void {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('2d');
    if (!context) return;
    const scale = 2 * Math.max(1, this.size.ratio);
    context.font = FONT;
    this.width = Math.ceil(context.measureText(this.text).width) + 2 * PADDING;
    canvas.width = this.width * scale;
    canvas.height = HEIGHT * scale;
    context.scale(scale, scale);
    context.globalAlpha = 0.78;
    context.fillStyle = this.veil;
    context.beginPath();
    context.roundRect(0, 0, this.width, HEIGHT, 4);
    context.fill();
    context.globalAlpha = 1;
    context.font = FONT;
    context.textBaseline = 'middle';
    context.fillStyle = this.colour;
    context.fillText(this.text, PADDING, HEIGHT / 2 + 0.5);
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    texture.minFilter = LinearFilter;
    texture.generateMipmaps = false;
    this.sprite.material.map?.dispose();
    this.sprite.material.map = texture;
    this.sprite.material.needsUpdate = true;
    this.fit();
  }
}
