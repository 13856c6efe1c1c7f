/** The ground: a disc of fine concrete around what is looked at, with a metric grid and a pool of light, that fades into the background. */
import {
  type Scene,
  type Vector3,
  CircleGeometry,
  Color,
  DoubleSide,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  Vector2,
  Vector4,
} from 'three';
import { Backdrop } from './backdrop.ts';
import { grainTexture } from './grain.ts';
import type { Palette } from '../palette.ts';
import { softShadow } from './softShadow.ts';

/** Size of the shadow's catcher, per metre of what is lit: what the shadow camera sees, seen aslant. */
const CATCHER = 1.5;

/** Least opacity of the ground, and from what depth to what depth of a body, per metre of its size, it becomes so. Bounds reach a little below what they hold. */
const THINNEST = 0.3;
const SHALLOW = 0.05;
const DEEP = 0.15;

const vertexShader = /* glsl */ `
  varying vec2 ground;
  void main() {
    vec4 place = modelMatrix * vec4(position, 1.0);
    ground = place.xy;
    gl_Position = projectionMatrix * viewMatrix * place;
  }
`;

const fragmentShader = /* glsl */ `
  varying vec2 ground;
  uniform vec2 centre;
  uniform float reach, opacity, contact, unit, pool;
  uniform vec3 background, rim, surface, fine, strong;
  uniform sampler2D grain; // r: clouds, g: specks, both about one half
  uniform vec4 board;    // x, y, heading, height of the board
  uniform vec4 skates;   // x, y of both skate points
  uniform vec2 heights;  // of both skate points

  // Coverage of lines one cell apart, each 'width' pixels wide; lines closer than two pixels melt into a tone.
  vec2 lines(float cell, float width) {
    vec2 c = ground / cell;
    vec2 perPixel = max(fwidth(c), 1e-6);
    vec2 away = abs(fract(c - 0.5) - 0.5) / perPixel;
    return clamp(0.5 + 0.5 * width - away, 0.0, 1.0) * (1.0 - smoothstep(0.08, 0.4, perPixel));
  }

  float blob(vec2 place, float size, float height) {
    vec2 d = ground - place;
    float spread = size + 0.6 * max(height, 0.0);
    return exp(-dot(d, d) / (spread * spread)) * size * size / (spread * spread);
  }

  void main() {
    float away = length(ground - centre) / reach;
    float near = 1.0 - smoothstep(0.1, 1.0, away);
    vec2 lit = (ground - centre) / pool;
    vec3 colour = mix(background, mix(rim, surface, 1.0 / (1.0 + dot(lit, lit))), near);

    #ifndef PLAIN
    // Clouds some decimetres wide; specks of some millimetres, gone where they would be smaller than a pixel.
    float texture = texture2D(grain, ground / (14.0 * unit)).r + texture2D(grain, ground / (0.9 * unit)).g - 1.0;
    colour *= 1.0 + 0.11 * near * texture;

    // Light that the board keeps from the ground: long and soft below the deck, small and dark at the wheels.
    vec2 d = ground - board.xy;
    vec2 along = vec2(cos(board.z) * d.x + sin(board.z) * d.y, cos(board.z) * d.y - sin(board.z) * d.x);
    float spread = 1.0 + 4.0 * max(board.w, 0.0);
    vec2 e = along / (vec2(0.36, 0.12) * spread);
    float dark = 0.6 * exp(-dot(e, e)) / (spread * spread);
    dark += 0.7 * blob(skates.xy, 0.03, heights.x) + 0.7 * blob(skates.zw, 0.03, heights.y);
    colour *= 1.0 - contact * min(dark, 1.0);

    #endif
    vec2 thin = lines(0.1 * unit, 1.0);
    vec2 thick = lines(unit, 1.3);
    colour = mix(colour, fine, near * max(thin.x, thin.y) * 0.9);
    colour = mix(colour, strong, sqrt(near) * near * max(thick.x, thick.y));
    gl_FragColor = vec4(colour, opacity);
    #include <colorspace_fragment>
    // Eight bits show steps in a gradient this slow.
    gl_FragColor.rgb += (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
  }
`;

export class Ground {
  private readonly disc: Mesh<CircleGeometry, ShaderMaterial>;
  private readonly catcher: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly backdrop: Backdrop;
  private readonly uniforms = {
    centre: { value: new Vector2() },
    reach: { value: 6 },
    opacity: { value: 1 },
    contact: { value: 0 },
    unit: { value: 1 },
    pool: { value: 2 },
    grain: { value: grainTexture() },
    rim: { value: new Color() },
    background: { value: new Color() },
    surface: { value: new Color() },
    fine: { value: new Color() },
    strong: { value: new Color() },
    board: { value: new Vector4(0, 0, 0, 1e3) },
    skates: { value: new Vector4() },
    heights: { value: new Vector2(1e3, 1e3) },
  };
  private strength = 0;
  private shown = false;
  private plain = false;
  /** Of the ground: what is below it is seen through it, the more the deeper it is. */
  private cover = 1;
  private floor = 0;
  private size = 0.88;

  constructor(scene: Scene, palette: Palette) {
    // Neither writes depth: ground, shadow, labels and tracks lie in one plane and are simply drawn in this order.
    const material = new ShaderMaterial({
      uniforms: this.uniforms,
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
      toneMapped: false,
    });
    this.disc = new Mesh(new CircleGeometry(1, 96), material);
    this.disc.frustumCulled = false;
    this.disc.renderOrder = -10;
    this.catcher = new Mesh(new PlaneGeometry(CATCHER, CATCHER), softShadow());
    this.catcher.receiveShadow = true;
    this.catcher.renderOrder = -9;
    this.backdrop = new Backdrop(scene, palette);
    scene.add(this.disc, this.catcher);
    this.setPalette(palette);
  }

  /** Only the shadow stays. */
  hideDisc(): void {
    this.disc.visible = false;
    this.backdrop.setVisible(false);
  }

  /** Without the shadow, the clouds and specks, the light that the board keeps away, and the sweep behind it. */
  setPlain(plain: boolean): void {
    if (plain === this.plain) return;
    this.plain = plain;
    this.catcher.visible &&= !plain;
    this.backdrop.setVisible(!plain && this.disc.visible);
    const { material } = this.disc;
    if (plain) material.defines['PLAIN'] = '';
    else delete material.defines['PLAIN'];
    material.needsUpdate = true;
  }

  setPalette(palette: Palette): void {
    const { background, rim, surface, fine, strong } = this.uniforms;
    this.backdrop.setPalette(palette);
    background.value.set(palette.background);
    rim.value.set(palette.groundRim);
    surface.value.set(palette.ground);
    fine.value.set(palette.gridFine);
    strong.value.set(palette.gridStrong);
    this.catcher.material.uniforms['opacity']!.value = palette.light.shadow;
    this.strength = palette.light.contact;
    if (this.shown) this.uniforms.contact.value = this.strength;
  }

  /** Height of the floor, largest extent of what stands on it, distance of the strong lines (m). */
  setPlan(floor: number, size: number, unit: number): void {
    this.floor = floor;
    this.size = size;
    this.uniforms.unit.value = unit;
    this.catcher.scale.setScalar(size);
  }

  /** Position (m) and heading (rad) of the subject. Skates: the points of a board that touch the ground, front then back; null without. */
  followBoard(position: Triple, heading: number, height: number, front: Triple | null, back: Triple | null): void {
    // The soft shade has a board's form: there is none without one.
    this.uniforms.board.value.set(position[0], position[1], heading, front || back ? height : 1e3);
    this.uniforms.skates.value.set(front?.[0] ?? 0, front?.[1] ?? 0, back?.[0] ?? 0, back?.[1] ?? 0);
    this.uniforms.heights.value.set(Math.abs(front?.[2] ?? 1e3), Math.abs(back?.[2] ?? 1e3));
    this.uniforms.contact.value = this.strength;
    this.shown = true;
    this.catcher.position.set(position[0], position[1], this.floor);
    this.catcher.visible = !this.plain && position[2] >= this.floor - 0.23 * this.size;
  }

  /** What fell through (free bodies know no ground) is seen through it. @param lowest height of what reaches deepest (m) */
  uncover(lowest: number): void {
    const depth = (this.floor - lowest) / this.size;
    this.cover = 1 - (1 - THINNEST) * Math.min(Math.max((depth - SHALLOW) / (DEEP - SHALLOW), 0), 1);
  }

  clearBoard(): void {
    this.uniforms.contact.value = 0;
    this.shown = false;
    this.catcher.visible = false;
    this.cover = 1;
  }

  /** Fades around the target (m); `distance` is the camera's from it, and sets how far the ground is drawn. */
  followView(target: Vector3, distance: number, eyeHeight: number): void {
    const reach = 2.2 + 3.2 * distance;
    this.uniforms.centre.value.set(target.x, target.y);
    this.uniforms.reach.value = reach;
    this.uniforms.pool.value = 0.9 * distance;
    this.uniforms.opacity.value = eyeHeight < this.floor ? THINNEST : this.cover;
    this.disc.position.set(target.x, target.y, this.floor);
    this.disc.scale.setScalar(reach);
    this.disc.updateMatrixWorld();
    this.backdrop.follow(target, reach, eyeHeight);
  }

  dispose(): void {
    this.uniforms.grain.value.dispose();
    this.backdrop.dispose();
    for (const mesh of [this.disc, this.catcher]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }
}

type Triple = readonly [number, number, number];
