import * as THREE from 'three';
import { Bodies } from './bodies.ts';
import { Camera, viewOffsets } from './camera.ts';
import type { Cast, Frame, ViewName } from './contract.ts';
import { environmentWorthIt, makeEnvironment } from './environment.ts';
import { Forces } from './forces.ts';
import { Ground } from './ground.ts';
import { Lights } from './lights.ts';
import { palettes, type Palette } from './palette.ts';
import { Trails } from './trails.ts';

export class NoWebGlError extends Error {
  override name = 'NoWebGlError';
}

export interface SceneOptions {
  theme: 'light' | 'dark';
  onContextLost?(): void;
  onContextRestored?(): void;
}

/** Body whose pose is the board's place and heading, and the one the close-up looks at. */
const LEADER = 0;
const CLOSE_UP = 3;

/**
 * The 3-D view: a pure function of the last frame it was given. It renders on demand, one picture per change,
 * and keeps no loop running.
 * @throws NoWebGlError from the constructor
 */
export class SceneView {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera: Camera;
  private readonly bodies = new Bodies();
  private readonly ground = new Ground();
  private readonly lights = new Lights();
  private readonly trails = new Trails();
  private readonly forces = new Forces();
  private palette: Palette;
  private frame: Frame | null = null;
  private asked = 0;
  private frames = 0;
  private placed = false;
  private readonly focus = new THREE.Vector3();

  constructor(canvas: HTMLCanvasElement, options: SceneOptions) {
    try {
      this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    } catch (error) {
      throw new NoWebGlError(`The 3-D view needs WebGL 2, which this browser does not offer${error instanceof Error && error.message ? ` (${error.message})` : ''}. Everything else works: runs, files and numbers.`);
    }
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.camera = new Camera(canvas, () => this.requestRender());
    this.scene.add(this.ground.group, this.trails.group, this.bodies.group, this.lights.group, this.forces.group);
    this.palette = palettes[options.theme];
    this.setTheme(options.theme);
    canvas.addEventListener('webglcontextlost', (event) => {
      // Without this the browser never gives the context back.
      event.preventDefault();
      options.onContextLost?.();
    });
    canvas.addEventListener('webglcontextrestored', () => {
      options.onContextRestored?.();
      this.requestRender();
    });
  }

  /** Bodies and their meshes. @throws Error for a bad mesh, with the previous ones left in place */
  setCast(cast: Cast): void {
    this.bodies.set(cast.parts, cast.models, cast.hubs, this.palette);
    if (this.frame) this.bodies.pose(this.frame.poses);
    this.requestRender();
  }

  setFrame(frame: Frame): void {
    this.frame = frame;
    this.bodies.pose(frame.poses);
    this.bodies.spin(frame.wheelAngles);
    this.forces.show(frame.forces, this.palette);
    this.trails.show(frame.trails, frame.time);
    const [x, y, z] = [frame.poses[0]!, frame.poses[1]!, frame.poses[2]!];
    this.ground.follow(x, y);
    this.lights.follow(x, y, z);
    if (!this.placed) {
      this.placed = true;
      this.setView(this.camera.view);
    } else {
      this.camera.track(this.pointOfInterest());
    }
    this.requestRender();
  }

  setView(view: ViewName): void {
    this.camera.view = view;
    if (!this.frame) return;
    const { poses } = this.frame;
    // Heading: the leader's x axis on the ground.
    this.camera.setView(view, this.pointOfInterest(), Math.atan2(poses[12 * LEADER + 6]!, poses[12 * LEADER + 3]!));
    this.requestRender();
  }

  /** A new motion: the next frame places the camera afresh. */
  restart(): void {
    this.placed = false;
  }

  setFollow(follow: boolean): void {
    this.camera.follow = follow;
  }

  setSwitches(switches: { trails: boolean; forces: boolean }): void {
    this.trails.group.visible = switches.trails;
    this.forces.group.visible = switches.forces;
    this.requestRender();
  }

  setTheme(theme: 'light' | 'dark'): void {
    const palette = (this.palette = palettes[theme]);
    this.scene.background = new THREE.Color(palette.background);
    this.renderer.toneMappingExposure = palette.exposure;
    this.ground.setPalette(palette);
    this.lights.setPalette(palette);
    this.trails.setPalette(palette);
    this.bodies.recolour(palette);
    if (this.frame) {
      this.ground.follow(this.frame.poses[0]!, this.frame.poses[1]!);
      this.forces.show(this.frame.forces, palette);
    }
    this.requestRender();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    if (width < 1 || height < 1) return;
    this.renderer.setPixelRatio(Math.min(pixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    // Setting the size clears the canvas: draw at once, or it flashes.
    this.draw();
  }

  /** Adds reflections where they cost little; call when idle. */
  improve(): void {
    if (this.scene.environment || !environmentWorthIt(this.renderer)) return;
    this.scene.environment = makeEnvironment(this.renderer);
    this.scene.environmentIntensity = 0.5;
    this.lights.setEnvironment(true);
    this.requestRender();
  }

  requestRender(): void {
    if (this.asked === 0) this.asked = requestAnimationFrame(() => this.draw());
  }

  stats(): { frames: number; triangles: number; calls: number; bodies: number } {
    const { triangles, calls } = this.renderer.info.render;
    return { frames: this.frames, triangles, calls, bodies: this.bodies.count };
  }

  /** Body to world, by columns (three's order), or null. */
  bodyMatrix(index: number): number[] | null {
    return this.bodies.matrixOf(index)?.toArray() ?? null;
  }

  setBodyVisible(index: number, visible: boolean): void {
    this.bodies.setVisible(index, visible);
    this.requestRender();
  }

  /** A body's box on the screen, CSS pixels from the canvas' corner, or null. */
  screenBox(index: number): { left: number; top: number; right: number; bottom: number } | null {
    const box = this.bodies.boxOf(index);
    if (!box) return null;
    const size = this.renderer.getSize(new THREE.Vector2());
    const corner = new THREE.Vector3();
    const result = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
    for (let i = 0; i < 8; i++) {
      corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z).project(this.camera.camera);
      const [x, y] = [((corner.x + 1) / 2) * size.x, ((1 - corner.y) / 2) * size.y];
      result.left = Math.min(result.left, x);
      result.right = Math.max(result.right, x);
      result.top = Math.min(result.top, y);
      result.bottom = Math.max(result.bottom, y);
    }
    return result;
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    this.camera.controls.dispose();
    this.renderer.dispose();
  }

  private pointOfInterest(): THREE.Vector3 {
    const closeUp = viewOffsets[this.camera.view].at === 'front-caster' && this.bodies.count > CLOSE_UP;
    const o = 12 * (closeUp ? CLOSE_UP : LEADER);
    const { poses } = this.frame!;
    return this.focus.set(poses[o]!, poses[o + 1]!, poses[o + 2]! + (closeUp ? 0.04 : 0));
  }

  private draw(): void {
    cancelAnimationFrame(this.asked);
    this.asked = 0;
    this.frames++;
    this.renderer.render(this.scene, this.camera.camera);
  }
}
