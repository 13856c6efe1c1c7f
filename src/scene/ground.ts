import * as THREE from 'three';
import type { Palette } from './palette.ts';

/** Radius of the ground disc (m); it follows the board, so it seems to have no end. */
const RADIUS = 14;
/** Metre labels on each side of the board. */
const LABEL_REACH = 3;

const VERTEX = /* glsl */ `
varying vec3 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xyz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

/** Lines one pixel wide at any distance (fwidth), 0.1 m fine and 1 m strong; fine ones fade before they alias. */
const FRAGMENT = /* glsl */ `
varying vec3 place;
uniform vec2 centre;
uniform vec3 ground, fineLine, strongLine, background;
float grid(vec2 p, float spacing, float width) {
  vec2 x = p / spacing;
  vec2 w = fwidth(x);
  vec2 d = abs(fract(x - 0.5) - 0.5) / max(w, vec2(1e-6));
  vec2 line = 1.0 - smoothstep(width - 0.5, width + 0.5, d);
  // Where a cell is only a few pixels wide the lines would moire: they fade first.
  vec2 clear = 1.0 - smoothstep(vec2(0.12), vec2(0.4), w);
  return max(line.x * clear.x, line.y * clear.y);
}
void main() {
  float far = smoothstep(1.5, ${RADIUS.toFixed(1)}, length(place.xy - centre));
  vec3 color = mix(ground, fineLine, 0.75 * grid(place.xy, 0.1, 0.5));
  color = mix(color, strongLine, grid(place.xy, 1.0, 0.8));
  gl_FragColor = vec4(mix(color, background, far), 1.0);
  #include <colorspace_fragment>
}`;

/**
 * Ground with a metric grid. It is drawn first and writes no depth, so that a board that falls through it,
 * as the report's does, stays visible.
 */
export class Ground {
  readonly group = new THREE.Group();
  private readonly grid: THREE.Mesh<THREE.CircleGeometry, THREE.ShaderMaterial>;
  private readonly shadow: THREE.Mesh<THREE.CircleGeometry, THREE.ShadowMaterial>;
  private readonly labels = new Map<string, THREE.Sprite>();
  private labelColour = '#000';
  private cell = '';

  constructor() {
    const uniforms = {
      centre: { value: new THREE.Vector2() },
      ground: { value: new THREE.Color() },
      fineLine: { value: new THREE.Color() },
      strongLine: { value: new THREE.Color() },
      background: { value: new THREE.Color() },
    };
    this.grid = new THREE.Mesh(
      new THREE.CircleGeometry(RADIUS, 48),
      new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, depthWrite: false, side: THREE.DoubleSide, toneMapped: false }),
    );
    this.grid.renderOrder = -2;
    this.shadow = new THREE.Mesh(new THREE.CircleGeometry(2.5, 32), new THREE.ShadowMaterial({ depthWrite: false }));
    this.shadow.receiveShadow = true;
    this.shadow.renderOrder = -1;
    this.group.add(this.grid, this.shadow);
  }

  setPalette(palette: Palette): void {
    const { uniforms } = this.grid.material;
    for (const name of ['ground', 'fineLine', 'strongLine', 'background'] as const) (uniforms[name]!.value as THREE.Color).set(palette[name]);
    this.shadow.material.opacity = palette.shadow;
    this.labelColour = palette.label;
    this.clearLabels();
  }

  /** Keeps the disc under the board and the labels on the metre lines near it. */
  follow(x: number, y: number): void {
    this.grid.position.set(x, y, 0);
    this.shadow.position.set(x, y, 0);
    (this.grid.material.uniforms['centre']!.value as THREE.Vector2).set(x, y);
    const cell = `${Math.round(x)},${Math.round(y)}`;
    if (cell === this.cell) return;
    this.cell = cell;
    this.placeLabels(Math.round(x), Math.round(y));
  }

  /** X along the metre line to the right of the board, Y along the one behind it. */
  private placeLabels(x: number, y: number): void {
    const wanted = new Map<string, [number, number]>();
    for (let i = -LABEL_REACH; i <= LABEL_REACH; i++) {
      wanted.set(`x ${x + i} m`, [x + i, y - 1]);
      wanted.set(`y ${y + i} m`, [x - 1, y + i]);
    }
    for (const [text, sprite] of this.labels) {
      if (wanted.has(text)) continue;
      this.drop(sprite);
      this.labels.delete(text);
    }
    for (const [text, [lx, ly]] of wanted) {
      const sprite = this.labels.get(text) ?? this.label(text);
      sprite.position.set(lx + 0.02, ly + 0.02, 0.004);
      this.labels.set(text, sprite);
      this.group.add(sprite);
    }
  }

  private label(text: string): THREE.Sprite {
    const canvas = document.createElement('canvas');
    canvas.width = 128;
    canvas.height = 32;
    const context = canvas.getContext('2d')!;
    context.font = '22px system-ui, sans-serif';
    context.fillStyle = this.labelColour;
    context.textBaseline = 'middle';
    context.fillText(text.replace('-', '−'), 2, 16);
    const map = new THREE.CanvasTexture(canvas);
    map.colorSpace = THREE.SRGBColorSpace;
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map, depthWrite: false, toneMapped: false }));
    sprite.center.set(0, 0);
    sprite.scale.set(0.2, 0.05, 1);
    sprite.renderOrder = -1;
    return sprite;
  }

  private clearLabels(): void {
    for (const sprite of this.labels.values()) this.drop(sprite);
    this.labels.clear();
    this.cell = '';
  }

  private drop(sprite: THREE.Sprite): void {
    this.group.remove(sprite);
    sprite.material.map?.dispose();
    sprite.material.dispose();
  }
}
