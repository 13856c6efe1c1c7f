/** The 3-D view: gets poses, tracks and forces, draws them when asked, and knows nothing of where they came from. */
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Camera,
  Color,
  Fog,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  Vector3,
  WebGLRenderTarget,
} from 'three';
import type { Gates } from './actors/gates.ts';
import type { Plain } from './actors/plain.ts';
import { CameraRig } from './camera/camera.ts';
import type { Frame, SceneOptions, ScreenBox, SceneView, Switches, ViewName } from './contract.ts';
import { openContext, watchContext } from './environment/device.ts';
import type { Haste } from './environment/haste.ts';
import { Focus } from './camera/focus.ts';
import { METRES_PER_NEWTON } from './overlay/forces.ts';
import { PushDrag } from './overlay/pushDrag.ts';
import { Inset } from './overlay/inset.ts';
import { releaseUploads } from './environment/lostContext.ts';
import { palettes } from './palette.ts';
import { Parts } from './actors/parts.ts';
import { boxOnScreen, onFacingPlane, pickBody, projected } from './overlay/picking.ts';
import { rendererFor } from './environment/renderer.ts';
import { Room } from './environment/room.ts';
import { liesDown, type Triple } from './camera/views.ts';
import { MARKS } from './overlay/words.ts';

export { NoWebGlError } from './environment/device.ts';

const MAX_PIXEL_RATIO = 2;
/** In a picture lower than this (CSS px) the buttons at its foot take much of it: all is drawn higher by this share of it. */
const LOW = 380;
const LIFT = 0.1;

/** Takes over a canvas. Throws `NoWebGlError` when there is no WebGL 2; everything else is drawn on demand. */
export function createScene(canvas: HTMLCanvasElement, options: SceneOptions): SceneView {
  const { gl, software } = openContext(canvas, options.still?.transparent);
  const renderer = rendererFor(canvas, gl, options.still?.transparent);
  let palette = palettes[options.theme];
  const scene = new Scene();
  const background = new Color(palette.background);
  const fog = new Fog(background, 5, 20);
  scene.background = options.still?.transparent ? null : background;
  scene.fog = fog;
  const parts = new Parts(scene, palette, software ? 1024 : 2048);
  const { bodies, trails, forces, ghosts } = parts;
  if (options.still?.transparent) parts.ground.hideDisc();
  if (options.still?.labels === false) parts.labels.setShown(false);
  const focus = new Focus();
  const pushDrag = new PushDrag(
    canvas,
    {
      pick: pickAt,
      near: nearBodies,
      reachTo,
      pace: () => (follow || view === 'rider' ? focus.pace(view) : [0, 0, 0]),
    },
    options,
  ); // hears of a press before the camera does
  const rig = new CameraRig(canvas, options.reducedMotion, requestRender);
  rig.camera.layers.enable(MARKS);
  const inset = new Inset();
  const room = new Room(gl, renderer, software, parts, () => {
    bodies.setLook(palette, parts.lights.hasRoom);
    requestRender();
  });
  room.set(options.quality ?? 'auto');
  /** Loaded when pictures must come soon. */
  let haste: Haste | null = null;
  /** Loaded with the first of them. */
  let gates: Gates | null = null;
  /** Loaded with the first picture in haste that leaves something out. */
  let plain: Plain | null = null;
  let hasty = false;
  let quality = options.quality ?? 'auto';

  const size = { width: 1, height: 1, ratio: 1 };
  let frames = 0;
  let requested = 0;
  let lost = false;
  let disposed = false;
  let announced = false;
  /** The last frame's parts that outlive it. */
  let time = 0;
  let shown = false;
  let arrows: Frame['forces'] = [];
  let view: ViewName = 'orbit';
  let follow = true;
  let switches: Switches = {
    trails: true,
    forces: false,
    names: false,
    frames: false,
    metresPerNewton: METRES_PER_NEWTON,
    level: true,
  };
  let scale = 0;

  function requestRender(): void {
    if (requested === 0 && !disposed && !lost) requested = requestAnimationFrame(render);
  }

  function render(now: number): void {
    requested = 0;
    rig.update(now);
    if (haste?.picture(now)) sharpen(haste);
    renderer.info.reset();
    const close = shown ? inset.place(focus, bodies) : null;
    draw();
    if (close) inset.draw(renderer, scene, close, size, look);
    bodies.tidy();
    frames++;
    if (!announced && shown && bodies.count > 0) {
      announced = true;
      options.onFirstFrame?.();
      requestRender(); // the second picture has no shaders to compile: it tells how fast the device is
    }
    const distance = view === 'rider' ? rig.camera.position.distanceTo(focus.position) : rig.distance;
    const pixels = size.height / (rig.spread * distance);
    if (Math.abs(pixels / scale - 1) > 0.005) options.onScale?.((scale = pixels));
  }

  function draw(): void {
    const { camera, target, distance } = rig;
    parts.labels.follow(target, distance);
    parts.labels.avoid(boxesOnScreen(), (world) => projected(world, camera, size));
    parts.handle.follow(camera);
    look(target, distance, camera.position.z);
    const done = room.watch(announced ? frames : 0);
    if (plain && haste?.plain) plain.draw(renderer, scene, camera);
    else renderer.render(scene, camera);
    done();
  }

  /** As fine as there is time for. */
  function sharpen({ plain }: Haste): void {
    parts.setPlain(plain);
    options.onCoarse?.(plain);
    setPlain(plain);
    fitCanvas();
    measure();
  }

  function setPlain(wanted: boolean): void {
    if (!wanted) {
      bodies.setPlain(null);
      ghosts.follow();
    } else
      void import('./actors/plain.ts').then(({ Plain }) => {
        if (!haste?.plain || disposed) return;
        plain ??= new Plain(
          {
            BufferAttribute,
            BufferGeometry,
            Camera,
            Mesh,
            MeshLambertMaterial,
            PlaneGeometry,
            ShaderMaterial,
            WebGLRenderTarget,
          },
          software,
        );
        bodies.setPlain(plain);
        ghosts.follow();
        requestRender();
      });
  }

  function fitCanvas(): void {
    renderer.setPixelRatio(size.ratio * (haste?.share ?? 1));
    renderer.setSize(size.width, size.height, false);
  }

  function hasten(): void {
    const wanted = hasty && quality !== 'high';
    if (!haste) {
      if (wanted)
        void import('./environment/haste.ts').then(({ Haste }) => {
          haste ??= new Haste(software);
          if (!disposed) hasten();
        });
      return;
    }
    const { share } = haste;
    haste.set(wanted);
    if (haste.share === share) return;
    sharpen(haste);
    redraw();
  }

  /** A canvas that changes its size is emptied: it must not be seen black until the next frame. */
  function redraw(): void {
    cancelAnimationFrame(requested);
    requested = 0;
    if (frames > 0 && !lost) render(performance.now());
    else requestRender();
  }

  /** What depends on where one stands. */
  function look(target: Vector3, distance: number, height: number): void {
    parts.ground.followView(target, distance, height);
    fog.near = 1.6 * distance + 1;
    fog.far = 4.4 * distance + 2.5;
  }

  function setFrame(frame: Frame | null): void {
    shown = frame !== null && frame.poses.length >= 12;
    bodies.place(shown ? frame!.poses : null, frame?.wheelAngles ?? new Float64Array(0));
    arrows = frame?.forces.map((f) => ({ ...f, origin: [...f.origin] as const, vector: [...f.vector] as const })) ?? [];
    time = frame?.time ?? Number.NEGATIVE_INFINITY;
    if (shown) followCast(frame!.poses);
    else parts.ground.clearBoard();
    show();
    pushDrag.follow();
  }

  /** Draws what the switches let through. */
  function show(): void {
    forces.set(arrows, switches.forces, switches.metresPerNewton);
    trails.show(time, switches.trails);
    parts.mark(switches, focus.plan.subject, focus.size);
    requestRender();
  }

  function followCast(poses: Float64Array): void {
    const { moved, stage, camera } = focus.take(poses, time, view, bodies);
    const { plan } = focus;
    if (!bodies.originOf(plan.subject)?.toArray().every(Number.isFinite)) return;
    if (stage) parts.setPlan(plan.floor, focus.size, focus.unit);
    parts.follow(plan, focus.heading, focus.position.z);
    if (view === 'rider') rig.ride(focus.ride(switches.level));
    else if (camera) go(true);
    else if (follow) rig.shift(moved);
  }

  function go(instantly: boolean): void {
    rig.ride(view === 'rider' ? focus.ride(switches.level) : null);
    measure();
    if (view === 'rider') return requestRender();
    const { camera, target } = focus.place(view, size.width / size.height, bodies);
    rig.go(camera, target, instantly);
  }

  function measure(): void {
    parts.resize({ perPixel: rig.spread / size.height, ratio: size.ratio * (haste?.share ?? 1) });
  }

  function pickAt(x: number, y: number, reach = 0) {
    return shown ? pickBody(x, y, reach, rig.camera, size, bodies) : null;
  }

  /** Of the bodies that are drawn; of those that a hand can take hold of. */
  function boxesOnScreen(solid = false): ScreenBox[] {
    return Array.from({ length: bodies.count }, (_, i) =>
      bodies.shows(i) && !(solid && bodies.modelOf(i)?.figure) ? boxOnScreen(i, rig.camera, size, bodies) : null,
    ).filter((box) => box !== null);
  }

  function nearBodies(x: number, y: number, pixels: number): boolean {
    return boxesOnScreen(true).some(
      ({ left, right, top, bottom }) =>
        x > left - pixels && x < right + pixels && y > top - pixels && y < bottom + pixels,
    );
  }

  function reachTo(x: number, y: number, at: { body: number; point: Triple }): Triple | null {
    const matrix = bodies.matrix(at.body);
    return matrix
      ? (onFacingPlane(x, y, new Vector3(...at.point).applyMatrix4(matrix), rig.camera, size)?.toArray() ?? null)
      : null;
  }

  const stopWatching = watchContext(
    canvas,
    () => {
      lost = true;
      cancelAnimationFrame(requested);
      requested = 0;
      pushDrag.release();
      room.lose();
      parts.labels.forget();
      releaseUploads(
        scene,
        (material) => (renderer.properties.get(material) as { uniforms?: Record<string, { value: unknown }> }).uniforms,
      );
      options.onContextLost?.();
    },
    () => {
      lost = false;
      requestRender();
      options.onContextRestored?.();
    },
  );

  return {
    setModels(models, cast) {
      bodies.setModels(models, cast.bodies, cast.fixtures);
      ghosts.follow();
      focus.setCast(cast);
      requestRender();
    },
    replaceBody(id, pair) {
      bodies.replace(id, pair);
      ghosts.follow();
      requestRender();
    },
    setFrame,
    setTrails(list) {
      trails.set(list);
      trails.show(time, switches.trails);
      requestRender();
    },
    setGhosts(list) {
      ghosts.set(list);
      requestRender();
    },
    setGates(list) {
      if (list.length > 0 || gates)
        void import('./actors/gates.ts').then(({ Gates }) => {
          gates ??= new Gates(scene, palette, {
            BoxGeometry,
            BufferAttribute,
            BufferGeometry,
            Color,
            Mesh,
            MeshBasicMaterial,
          });
          gates.set(list, focus.plan.floor);
          requestRender();
        });
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
      switches = { ...switches, ...next };
      if (view === 'rider') rig.ride(focus.ride(switches.level));
      show();
    },
    setQuality(next) {
      quality = next;
      room.set(next);
      hasten();
      requestRender(); // it is with a picture that a room begins to come
    },
    setHasty(next) {
      if (next === hasty) return;
      hasty = next;
      hasten();
    },
    setInset(box) {
      inset.box = box;
      requestRender();
    },
    setPushByDrag(when) {
      pushDrag.when = when;
    },
    setHandle(handle) {
      parts.handle.set(handle);
      requestRender();
    },
    pick: pickAt,
    project: (world) => projected(world, rig.camera, size),
    setTheme(theme) {
      palette = palettes[theme];
      background.set(palette.background);
      fog.color.set(palette.background);
      parts.setPalette(palette);
      gates?.setPalette(palette);
      show();
    },
    setReducedMotion: (reduced) => rig.setReducedMotion(reduced),
    resize(w, h, devicePixelRatio) {
      const before = size.width / size.height;
      size.width = Math.max(1, w);
      size.height = Math.max(1, h);
      size.ratio = Math.min(Math.max(devicePixelRatio, 0.25), options.still ? Infinity : MAX_PIXEL_RATIO);
      fitCanvas();
      const aspect = size.width / size.height;
      rig.setAspect(aspect, size.height < LOW && !options.still ? LIFT : 0);
      measure();
      if (view === 'top' && shown && liesDown(before) !== liesDown(aspect)) go(true);
      else if (view !== 'rider') rig.dolly(focus.dolly(view, before, aspect, bodies));
      redraw();
    },
    setBodyVisible(index, visible) {
      bodies.setVisible(index, visible);
      show();
    },
    placement: () => ({
      camera: rig.camera.position.toArray(),
      target: rig.target.toArray(),
      up: rig.camera.up.toArray(),
    }),
    setPlacement({ camera, target, up }) {
      if (view === 'rider') rig.ride({ eye: camera, target, up });
      else rig.go(camera, target, true);
      requestRender();
    },
    draw() {
      room.ready();
      cancelAnimationFrame(requested);
      render(performance.now());
      cancelAnimationFrame(requested);
      requested = 0;
    },
    requestRender,
    stats: () => ({
      frames,
      triangles: renderer.info.render.triangles,
      calls: renderer.info.render.calls,
      bodies: bodies.count,
      geometries: renderer.info.memory.geometries,
      textures: renderer.info.memory.textures,
      programs: renderer.info.programs?.length ?? 0,
    }),
    bodyPosition: (index) => bodies.originOf(index)?.toArray() ?? null,
    bodyMatrix: (index) => bodies.matrix(index)?.toArray() ?? null,
    screenBox: (index) => boxOnScreen(index, rig.camera, size, bodies),
    dispose() {
      disposed = true;
      cancelAnimationFrame(requested);
      stopWatching();
      gates?.dispose();
      plain?.dispose();
      for (const part of [pushDrag, rig, room, parts]) part.dispose();
      renderer.dispose();
    },
  };
}
