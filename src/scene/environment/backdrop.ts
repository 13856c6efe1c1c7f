/** What stands behind the ground: a studio's sweep that grows lighter above the horizon. Costs nothing where no horizon is in the picture. */
import { type Scene, type Vector3, BackSide, Color, CylinderGeometry, Mesh, ShaderMaterial } from 'three';
import type { Palette } from '../palette.ts';

/** Its height, per metre of the ground's reach. */
const HEIGHT = 0.9;

const vertexShader = /* glsl */ `
  varying float rise;
  void main() {
    rise = position.z;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const fragmentShader = /* glsl */ `
  varying float rise;
  uniform vec3 background, zenith;
  void main() {
    gl_FragColor = vec4(mix(background, zenith, smoothstep(0.0, 1.0, rise)), 1.0);
    #include <colorspace_fragment>
    gl_FragColor.rgb += (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
  }
`;

export class Backdrop {
  private readonly wall: Mesh<CylinderGeometry, ShaderMaterial>;

  constructor(scene: Scene, palette: Palette) {
    const uniforms = { background: { value: new Color() }, zenith: { value: new Color() } };
    const geometry = new CylinderGeometry(1, 1, 1, 64, 1, true).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    this.wall = new Mesh(
      geometry,
      new ShaderMaterial({
        uniforms,
        vertexShader,
        fragmentShader,
        side: BackSide,
        depthWrite: false,
        depthTest: false,
        toneMapped: false,
      }),
    );
    this.wall.renderOrder = -20;
    this.wall.frustumCulled = false;
    scene.add(this.wall);
    this.setPalette(palette);
  }

  setVisible(visible: boolean): void {
    this.wall.visible = visible;
  }

  setPalette(palette: Palette): void {
    const { background, zenith } = this.wall.material.uniforms;
    (background!.value as Color).set(palette.background);
    (zenith!.value as Color).set(palette.zenith);
  }

  /** Stands at the end of the ground, its foot as high as the eye, so that it ends where the ground seems to. */
  follow(target: Vector3, reach: number, eyeHeight: number): void {
    this.wall.position.set(target.x, target.y, eyeHeight);
    this.wall.scale.set(reach, reach, HEIGHT * reach);
    this.wall.updateMatrixWorld();
  }

  dispose(): void {
    this.wall.geometry.dispose();
    this.wall.material.dispose();
  }
}
