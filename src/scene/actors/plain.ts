/**
 * Pictures that must come soon: of each body one mesh of fewer triangles with its colours in its points, in a surface that asks for
 * little, and, where a program on the processor draws, each pixel once in place of four times. Loaded with the first such picture; of
 * three.js it has what it is given, so that the first view's file stays whole.
 */
import type * as three from 'three';

type Kit = Pick<
  typeof three,
  | 'BufferAttribute'
  | 'BufferGeometry'
  | 'Camera'
  | 'Mesh'
  | 'MeshLambertMaterial'
  | 'PlaneGeometry'
  | 'ShaderMaterial'
  | 'WebGLRenderTarget'
>;
type Surface = three.MeshStandardMaterial;

/** Of a point: place, normal, colour. */
const FLOATS = 9;

/** Points within the same cube of this size are one, m: what is smaller is not seen from behind the rider. */
const CELL = 0.007;
/** Its normals are told apart by thirds of each axis. */
const TURNS = 1.5;

/**
 * Fewer triangles in place of many: corners in one cell of a grid are one point, where their normals and colours are near, and what is
 * left without an area goes. J. Rossignac and P. Borrel, Multi-resolution 3D approximations for rendering complex scenes (1993).
 *
 * @param corners of triangles, `FLOATS` numbers each
 * @param cell size of a cell, m
 * @returns points, `FLOATS` numbers each, and three indices a triangle
 */
export function clustered(corners: Float32Array, cell = CELL): { points: Float32Array; index: Uint32Array } {
  const count = corners.length / FLOATS;
  const cells = new Map<string, number>();
  const kinds = new Map<string, number>();
  const places: number[] = [];
  const points: number[] = [];
  /** Of each corner: its cell and its point. */
  const cellOf = new Uint32Array(count);
  const pointOf = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    const [x, y, z, nx, ny, nz, r, g, b] = corners.subarray(FLOATS * i, FLOATS * i + FLOATS) as unknown as Corner;
    const box = `${Math.round(x / cell)} ${Math.round(y / cell)} ${Math.round(z / cell)}`;
    let home = cells.get(box);
    if (home === undefined) {
      cells.set(box, (home = cells.size));
      places.push(x, y, z);
    }
    const kind = `${home} ${Math.round(TURNS * nx)} ${Math.round(TURNS * ny)} ${Math.round(TURNS * nz)} ${r} ${g} ${b}`;
    let point = kinds.get(kind);
    if (point === undefined) {
      kinds.set(kind, (point = kinds.size));
      // All points of a cell lie in one place: no gaps between them.
      points.push(places[3 * home]!, places[3 * home + 1]!, places[3 * home + 2]!, nx, ny, nz, r, g, b);
    }
    cellOf[i] = home;
    pointOf[i] = point;
  }
  const index: number[] = [];
  for (let i = 0; i < count; i += 3) {
    const [a, b, c] = [cellOf[i]!, cellOf[i + 1]!, cellOf[i + 2]!];
    if (a !== b && b !== c && c !== a) index.push(pointOf[i]!, pointOf[i + 1]!, pointOf[i + 2]!);
  }
  return { points: Float32Array.from(points), index: Uint32Array.from(index) };
}

type Corner = [number, number, number, number, number, number, number, number, number];

/** Of every corner of every triangle, in the frame of the group that the meshes hang in. */
function cornersOf(meshes: readonly three.Mesh[]): Float32Array {
  const corners = ({ geometry }: three.Mesh) => (geometry.index ?? geometry.getAttribute('position')).count;
  const out = new Float32Array(FLOATS * meshes.reduce((sum, mesh) => sum + corners(mesh), 0));
  let next = 0;
  for (const mesh of meshes) {
    mesh.updateMatrix();
    const { geometry, matrix } = mesh;
    const position = geometry.getAttribute('position');
    const normal = geometry.getAttribute('normal');
    const surfaces = [mesh.material].flat() as Surface[];
    const place = mesh.position.clone();
    const groups =
      geometry.groups.length > 0 ? geometry.groups : [{ start: 0, count: corners(mesh), materialIndex: 0 }];
    for (const { start, count, materialIndex } of groups) {
      const { color, emissiveIntensity } = surfaces[materialIndex ?? 0]!;
      const glow = 1 + emissiveIntensity;
      for (let i = start; i < start + count; i++, next += FLOATS) {
        const k = geometry.index ? geometry.index.getX(i) : i;
        place.fromBufferAttribute(position, k).applyMatrix4(matrix).toArray(out, next);
        place
          .fromBufferAttribute(normal, k)
          .transformDirection(matrix)
          .toArray(out, next + 3);
        out.set([glow * color.r, glow * color.g, glow * color.b], next + 6);
      }
    }
  }
  return out;
}

export class Plain {
  private readonly kit: Kit;
  private readonly material: three.MeshLambertMaterial;
  /** What hangs in a group in place of its own meshes, and which those are. */
  private readonly drawn = new Map<three.Group, { mesh: three.Mesh; hidden: readonly three.Object3D[] }>();

  private readonly sheet: Sheet | null;

  /** @param software whether a program on the processor draws */
  constructor(kit: Kit, software: boolean) {
    this.kit = kit;
    this.material = new kit.MeshLambertMaterial({ vertexColors: true });
    this.sheet = software ? new Sheet(kit) : null;
  }

  draw(renderer: three.WebGLRenderer, scene: three.Scene, camera: three.Camera): void {
    if (this.sheet) this.sheet.draw(renderer, scene, camera);
    else renderer.render(scene, camera);
  }

  /** Draws a group's own meshes as one; those that are seen through stay as they are. */
  put(group: three.Group): void {
    this.take(group);
    const meshes = group.children.filter((child) => child instanceof this.kit.Mesh) as three.Mesh[];
    const hidden = meshes.filter(({ material }) => [material].flat().every(({ transparent }) => !transparent));
    if (hidden.length === 0) return;
    const { points, index } = clustered(cornersOf(hidden));
    const { BufferAttribute, BufferGeometry } = this.kit;
    const geometry = new BufferGeometry();
    for (const [i, name] of ['position', 'normal', 'color'].entries()) {
      const values = new Float32Array(points.length / 3);
      for (let k = 0; k < values.length; k++) values[k] = points[FLOATS * Math.floor(k / 3) + 3 * i + (k % 3)]!;
      geometry.setAttribute(name, new BufferAttribute(values, 3));
    }
    geometry.setIndex(new BufferAttribute(index, 1));
    const mesh = new this.kit.Mesh(geometry, this.material);
    for (const one of hidden) one.visible = false;
    group.add(mesh);
    this.drawn.set(group, { mesh, hidden });
  }

  /** Its own meshes again. */
  take(group: three.Group): void {
    const drawn = this.drawn.get(group);
    if (!drawn) return;
    this.drawn.delete(group);
    group.remove(drawn.mesh);
    drawn.mesh.geometry.dispose();
    for (const one of drawn.hidden) one.visible = true;
  }

  dispose(): void {
    for (const group of [...this.drawn.keys()]) this.take(group);
    this.material.dispose();
    this.sheet?.dispose();
  }
}

/** A picture without smoothed edges, then put onto the canvas whole: a canvas that smooths them does so in every triangle. */
class Sheet {
  private readonly target: three.WebGLRenderTarget & { isXRRenderTarget?: boolean };
  private readonly quad: three.Mesh<three.PlaneGeometry, three.ShaderMaterial>;
  private readonly camera: three.Camera;

  constructor(kit: Kit) {
    this.target = new kit.WebGLRenderTarget(1, 1);
    const { texture } = this.target;
    // Colours as on the canvas, not the linear ones that three.js puts into a texture: it asks for no more than this name.
    this.target.isXRRenderTarget = true;
    texture.colorSpace = 'srgb';
    texture.internalFormat = 'RGBA8';
    this.camera = new kit.Camera();
    const look = new kit.ShaderMaterial({
      uniforms: { picture: { value: texture } },
      vertexShader: 'varying vec2 at; void main() { at = uv; gl_Position = vec4(2.0 * position.xy, 0.0, 1.0); }',
      fragmentShader:
        'varying vec2 at; uniform sampler2D picture; void main() { gl_FragColor = texture2D(picture, at); }',
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
    });
    this.quad = new kit.Mesh(new kit.PlaneGeometry(1, 1), look);
    this.quad.frustumCulled = false;
  }

  draw(renderer: three.WebGLRenderer, scene: three.Scene, camera: three.Camera): void {
    const { width, height } = renderer.domElement;
    const { target } = this;
    if (target.width !== width || target.height !== height) target.setSize(width, height);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    renderer.render(this.quad, this.camera);
  }

  dispose(): void {
    this.target.dispose();
    this.quad.geometry.dispose();
    this.quad.material.dispose();
  }
}
