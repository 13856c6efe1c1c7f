/** The strip that a wheel leaves: one quad a segment, with mitred joints, in the ground's plane or facing the camera, fading with age. */
import {
  BufferAttribute,
  Color,
  DynamicDrawUsage,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  ShaderMaterial,
  Sphere,
  UniformsLib,
  UniformsUtils,
} from 'three';

const vertexShader = /* glsl */ `
  #include <common>
  #include <fog_pars_vertex>
  attribute vec2 corner;                                // along the segment 0 or 1; across it -1 or 1
  attribute vec3 before, start, end, after;
  attribute float startTime, endTime;
  uniform float halfWidth, leastPixels, perPixel, now, fade, flatness;
  varying float strength, across;

  vec3 side(vec3 from, vec3 to, vec3 eye) {
    vec3 normal = mix(normalize(eye - from), vec3(0.0, 0.0, 1.0), flatness);
    vec3 out3 = cross(normal, to - from);
    float size = length(out3);
    return size > 1e-9 ? out3 / size : vec3(0.0);
  }

  void main() {
    vec3 place = mix(start, end, corner.x);
    vec3 own = side(start, end, cameraPosition);
    vec3 next = corner.x < 0.5 ? side(before, start, cameraPosition) : side(end, after, cameraPosition);
    vec3 middle = own + next;
    float square = dot(middle, middle);
    // Where the path turns back on itself a mitre has no end.
    vec3 joint = square > 1.2 ? 2.0 * middle / square : own;
    float half3 = max(halfWidth, 0.5 * leastPixels * perPixel * distance(place, cameraPosition));
    vec4 mvPosition = viewMatrix * vec4(place + corner.y * half3 * joint, 1.0);
    gl_Position = projectionMatrix * mvPosition;
    float age = max(0.0, now - mix(startTime, endTime, corner.x));
    strength = 0.35 + 0.65 * exp(-age / fade);
    across = corner.y;
    #include <fog_vertex>
  }
`;

const fragmentShader = /* glsl */ `
  #include <fog_pars_fragment>
  uniform vec3 colour;
  varying float strength, across;
  void main() {
    // Soft at its edges, as rubber rubs off.
    float edge = 1.0 - smoothstep(0.72, 1.0, abs(across));
    gl_FragColor = vec4(colour, strength * mix(0.55, 1.0, edge));
    #include <colorspace_fragment>
    #include <fog_fragment>
  }
`;

export type MarkMaterial = ShaderMaterial & {
  uniforms: Record<'halfWidth' | 'leastPixels' | 'perPixel' | 'now' | 'fade' | 'flatness', { value: number }> & {
    colour: { value: Color };
  };
};

export function markMaterial(): MarkMaterial {
  const own = {
    halfWidth: { value: 0.006 },
    leastPixels: { value: 2.2 },
    perPixel: { value: 1e-3 },
    now: { value: 0 },
    fade: { value: 4 },
    flatness: { value: 1 },
    colour: { value: new Color() },
  };
  // The scene's fog is put into these by the renderer.
  const uniforms = { ...UniformsUtils.clone(UniformsLib.fog), ...own };
  return new ShaderMaterial({
    uniforms,
    vertexShader,
    fragmentShader,
    transparent: true,
    depthWrite: false,
    fog: true,
    toneMapped: false,
    side: 2,
  }) as unknown as MarkMaterial;
}

/** A strip over points and times that are padded by one at either end: segment i runs from point i + 1 to point i + 2. */
export class MarkStrip {
  readonly mesh: Mesh<InstancedBufferGeometry, MarkMaterial>;
  private readonly places: InstancedInterleavedBuffer;
  private readonly times: InstancedInterleavedBuffer;
  private without = 0;

  /** @param points 3 floats each; `times` one each (s); both are read where they are */
  constructor(points: Float32Array, times: Float32Array, material: MarkMaterial) {
    const geometry = new InstancedBufferGeometry();
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    geometry.setAttribute('corner', new BufferAttribute(Float32Array.of(0, -1, 1, -1, 0, 1, 1, 1), 2));
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(12), 3)); // three wants one
    this.places = new InstancedInterleavedBuffer(points, 3, 1);
    this.times = new InstancedInterleavedBuffer(times, 1, 1);
    for (const buffer of [this.places, this.times]) buffer.setUsage(DynamicDrawUsage);
    geometry.instanceCount = 0;
    geometry.boundingSphere = new Sphere(undefined, Number.MAX_VALUE); // for sorting only; measuring it would read every point
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false; // its bounds would have to be measured again with every point
    this.mesh.renderOrder = -7;
    this.read(geometry, 0);
    this.draw(0);
  }

  /** Points from this one on (of `count`, paddings included) have changed. */
  changed(from: number, count: number): void {
    this.places.addUpdateRange(3 * from, 3 * (count - from));
    this.times.addUpdateRange(from, count - from);
    this.places.needsUpdate = this.times.needsUpdate = true;
  }

  /** So many segments, without the first ones. */
  draw(segments: number, without = 0): void {
    const { geometry } = this.mesh;
    if (without !== this.without) this.read(geometry, without);
    geometry.instanceCount = segments - without;
    this.mesh.visible = segments > without;
  }

  /** The first segment that is drawn is this one: three.js looks at an attribute's offset once. */
  private read(geometry: InstancedBufferGeometry, first: number): void {
    this.without = first;
    for (const [i, name] of ['before', 'start', 'end', 'after'].entries())
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.places, 3, 3 * (first + i)));
    for (const [i, name] of ['startTime', 'endTime'].entries())
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.times, 1, first + i + 1));
  }
}
