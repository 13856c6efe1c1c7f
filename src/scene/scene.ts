/** The 3-D view: gets poses, tracks and forces, draws them when asked, and knows nothing of where they came from. */
import { Color, Fog, NeutralToneMapping, PCFShadowMap, Scene, Vector3, WebGLRenderer } from 'three';
import { Bodies } from './bodies.ts';
import { CameraRig } from './camera.ts';
import type { Frame, Quality, SceneOptions, SceneView, ViewName } from './contract.ts';
import { openContext, whenIdle } from './device.ts';
import { Focus } from './focus.ts';
import { Forces } from './forces.ts';
import { Ground } from './ground.ts';
import { Labels } from './labels.ts';
import { Lights } from './lights.ts';
import { palettes } from './palette.ts';
import { Trails } from './trails.ts';
import type { Triple } from './views.ts';

export { NoWebGlError } from './device.ts';

/** A picture that takes longer than this (ms) says that the device cannot afford the environment. */
const SLOW_PICTURE = 60;
const MAX_PIXEL_RATIO = 2;

/** Takes over a canvas. Throws `NoWebGlError` when there is no WebGL 2; everything else is drawn on demand. */
export function createScene(canvas: HTMLCanvasElement, options: SceneOptions): SceneView {
  const { gl, software } = openContext(canvas, options.still?.transparent);
  const quality: Quality = options.quality ?? 'auto';
  const rich = quality === 'high' || (quality === 'auto' && !software);

  const renderer = new WebGLRenderer({ canvas, context: gl, alpha: options.still?.transparent === true });
  renderer.toneMapping = NeutralToneMapping; // keeps the colours that mean something
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;

  let palette = palettes[options.theme];
  const scene = new Scene();
  const background = new Color(palette.background);
  const fog = new Fog(background, 5, 20);
  scene.background = options.still?.transparent ? null : background;
  scene.fog = fog;
  const lights = new Lights(scene, palette, rich ? 2048 : 1024);
  const ground = new Ground(scene, palette);
  const labels = new Labels(scene, palette);
  const bodies = new Bodies(scene, palette);
  const trails = new Trails(scene, palette);
  const forces = new Forces(scene, palette);
  if (options.still?.transparent) ground.hideDisc();
  if (options.still?.labels === false) labels.hide();
  const focus = new Focus();
  const rig = new CameraRig(canvas, options.reducedMotion, requestRender);

  let width = 1;
  let height = 1;
  let frames = 0;
  let requested = 0;
  let lost = false;
  let disposed = false;
  let announced = false;
  let roomPending = 0;
  /** The last frame's parts that outlive it. */
  let time = 0;
  let shown = false;
  let arrows: Frame['forces'] = [];
  let view: ViewName = 'orbit';
  let follow = true;
  let switches = { trails: true, forces: false };

  function requestRender(): void {
    if (requested === 0 && !disposed && !lost) requested = requestAnimationFrame(render);
  }

  function render(now: number): void {
    requested = 0;
    rig.update(now);
    const { target, distance } = rig;
    ground.followView(target, distance, rig.camera.position.z);
    labels.follow(target, distance);
    fog.near = 1.6 * distance + 1;
    fog.far = 4.4 * distance + 2.5;
    const measured = quality === 'auto' && rich && frames === 1;
    const began = measured ? performance.now() : 0;
    renderer.render(scene, rig.camera);
    frames++;
    if (!announced && shown && bodies.count > 0) {
      announced = true;
      options.onFirstFrame?.();
      requestRender(); // the second picture has no shaders to compile: it tells how fast the device is
    }
    if (rich && roomPending === 0 && !lights.hasRoom && announced && frames > 1) {
      if (measured) gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
      if (!measured || performance.now() - began < SLOW_PICTURE) roomPending = whenIdle(makeRoom);
      else roomPending = -1;
    }
  }

  function makeRoom(): void {
    if (disposed || lost) return;
    lights.makeRoom(renderer);
    bodies.setLook(palette, true);
    requestRender();
  }

  function setFrame(frame: Frame | null): void {
    shown = frame !== null && frame.poses.length >= 12;
    bodies.place(shown ? frame!.poses : null, frame?.wheelAngles ?? new Float64Array(0));
    arrows = frame?.forces.map((f) => ({ ...f, origin: [...f.origin] as const, vector: [...f.vector] as const })) ?? [];
    time = frame?.time ?? Number.NEGATIVE_INFINITY;
    if (shown) followCast(frame!.poses);
    else ground.clearBoard();
    forces.set(arrows, switches.forces);
    trails.show(time, switches.trails);
    requestRender();
  }

  function followCast(poses: Float64Array): void {
    const { moved, stage, camera } = focus.take(poses, view, bodies);
    const { plan, position, heading } = focus;
    const body = (i: number | undefined): Triple | null => (i === undefined || poses.length < 12 * (i + 1) ? null : [poses[12 * i]!, poses[12 * i + 1]!, poses[12 * i + 2]!]);
    const at = body(plan.subject)!;
    if (!at.every(Number.isFinite)) return;
    if (stage) {
      lights.setSize(focus.size);
      ground.setPlan(plan.floor, focus.size, focus.unit);
      labels.setPlan(plan.floor, focus.unit);
    }
    const [front, back] = bodies.wheeled().map((i) => body(i));
    const lowest = front && back ? Math.min(front[2], back[2]) : position.z;
    ground.followBoard(at, heading, Math.abs(lowest), front ?? null, back ?? null);
    lights.follow(...at, plan.floor);
    if (camera) go(true);
    else if (follow) rig.shift(moved);
  }

  function go(instantly: boolean): void {
    const { camera, target } = focus.place(view, width / height, bodies);
    rig.go(camera, target, instantly);
  }

  function look(): void {
    background.set(palette.background);
    fog.color.set(palette.background);
    lights.setPalette(palette);
    for (const part of [ground, labels, trails, forces]) part.setPalette(palette);
    bodies.setLook(palette, lights.hasRoom);
    requestRender();
  }

  function contextLost(event: Event): void {
    event.preventDefault(); // without it the browser never gives the context back
    lost = true;
    cancelAnimationFrame(requested);
    requested = 0;
    options.onContextLost?.();
  }

  function contextRestored(): void {
    lost = false;
    const hadRoom = lights.hasRoom;
    lights.dropRoom(); // its picture was on the card
    bodies.setLook(palette, false);
    if (hadRoom) roomPending = 0;
    requestRender();
    options.onContextRestored?.();
  }

  canvas.addEventListener('webglcontextlost', contextLost);
  canvas.addEventListener('webglcontextrestored', contextRestored);

  return {
    setModels(models, cast) {
      bodies.setModels(models, cast.bodies, cast.fixtures);
      focus.setCast(cast);
      requestRender();
    },
    replaceBody(id, pair) {
      bodies.replace(id, pair);
      requestRender();
    },
    setFrame,
    setTrails(list) {
      trails.set(list);
      trails.show(time, switches.trails);
      requestRender();
    },
    setView(name) {
      view = name;
      go(!shown);
    },
    setFollow(value) {
      if (value && !follow && shown) go(false);
      follow = value;
    },
    setSwitches(next) {
      switches = { ...next };
      forces.set(arrows, switches.forces);
      trails.show(time, switches.trails);
      requestRender();
    },
    setTheme(theme) {
      palette = palettes[theme];
      look();
    },
    setReducedMotion: (reduced) => rig.setReducedMotion(reduced),
    resize(w, h, devicePixelRatio) {
      width = Math.max(1, w);
      height = Math.max(1, h);
      const ratio = Math.min(Math.max(devicePixelRatio, 0.25), options.still ? Infinity : MAX_PIXEL_RATIO);
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      rig.setAspect(width / height);
      labels.resize(height, ratio);
      requestRender();
    },
    setBodyVisible(index, visible) {
      bodies.setVisible(index, visible);
      requestRender();
    },
    placement: () => ({ camera: rig.camera.position.toArray(), target: rig.target.toArray() }),
    setPlacement: (camera, target) => rig.go(camera, target, true),
    draw() {
      if (rich && !lights.hasRoom) makeRoom();
      cancelAnimationFrame(requested);
      render(performance.now());
      cancelAnimationFrame(requested);
      requested = 0;
    },
    requestRender,
    stats: () => ({ frames, triangles: renderer.info.render.triangles, calls: renderer.info.render.calls, bodies: bodies.count }),
    bodyPosition(index) {
      const matrix = bodies.matrix(index);
      return matrix ? (new Vector3().setFromMatrixPosition(matrix).toArray() as [number, number, number]) : null;
    },
    bodyMatrix: (index) => bodies.matrix(index)?.toArray() ?? null,
    screenBox(index) {
      rig.camera.updateMatrixWorld();
      const corners = bodies.corners(index).map((corner) => corner.project(rig.camera));
      if (corners.length === 0 || corners.some(({ z }) => z > 1)) return null;
      const xs = corners.map(({ x }) => ((x + 1) / 2) * width);
      const ys = corners.map(({ y }) => ((1 - y) / 2) * height);
      return { left: Math.min(...xs), top: Math.min(...ys), right: Math.max(...xs), bottom: Math.max(...ys) };
    },
    dispose() {
      disposed = true;
      cancelAnimationFrame(requested);
      canvas.removeEventListener('webglcontextlost', contextLost);
      canvas.removeEventListener('webglcontextrestored', contextRestored);
      for (const part of [rig, lights, ground, labels, bodies, trails, forces]) part.dispose();
      renderer.dispose();
    },
  };
}
