/** The camera, the hand that turns it, and following the board. */
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RIDER_FIELD, type RiderPlace } from '../actors/rider.ts';
import { FIELD_OF_VIEW, type Triple } from './views.ts';

/** Length of a change of view (ms). */
const GLIDE = 160;
const DEGREES = 180 / Math.PI;

export class CameraRig {
  readonly camera: PerspectiveCamera;
  private readonly controls: OrbitControls;
  private readonly requestRender: () => void;
  /** A change of view under way; `began` is the animation frame's own time (ms), null before its first frame. */
  private glide: { began: number | null; from: Placement; to: Placement } | null = null;
  private still: boolean;
  /** Between a gesture and the end of its inertia. */
  private settling = false;
  private quiet = false;

  constructor(canvas: HTMLCanvasElement, reducedMotion: boolean, requestRender: () => void) {
    this.camera = new PerspectiveCamera(DEGREES * FIELD_OF_VIEW, 1, 0.02, 100);
    this.camera.up.set(0, 0, 1); // before the controls, which read it once
    this.camera.position.set(1, -1.6, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = 0.12;
    this.controls.maxDistance = 40;
    this.controls.maxPolarAngle = 0.497 * Math.PI; // the eye stays above the level of what it looks at
    this.controls.dampingFactor = 0.15;
    this.requestRender = requestRender;
    this.still = reducedMotion;
    this.setReducedMotion(reducedMotion);
    this.controls.addEventListener('change', () => {
      if (!this.quiet) requestRender();
    });
    this.controls.addEventListener('start', () => {
      this.glide = null;
    });
    this.controls.addEventListener('end', () => {
      this.settling = this.controls.enableDamping;
      requestRender();
    });
  }

  get target(): Vector3 {
    return this.controls.target;
  }

  get distance(): number {
    return this.camera.position.distanceTo(this.controls.target);
  }

  /** Height of the picture at a metre's distance (m). */
  get spread(): number {
    return 2 * Math.tan(this.camera.fov / DEGREES / 2);
  }

  setReducedMotion(reduced: boolean): void {
    this.still = reduced;
    this.controls.enableDamping = !reduced;
  }

  /** @param lift shares of the height by which all is drawn higher than in the middle */
  setAspect(aspect: number, lift = 0): void {
    this.camera.setViewOffset(aspect, 1, 0, lift, aspect, 1);
  }

  /** Goes to a place: at once, or gliding where motion is welcome. */
  go(camera: Triple, target: Triple, instantly: boolean): void {
    const to = { camera: new Vector3(...camera), target: new Vector3(...target) };
    if (instantly || this.still) {
      this.glide = null;
      this.put(to.camera, to.target);
    } else {
      this.glide = { began: null, from: { camera: this.camera.position.clone(), target: this.target.clone() }, to };
    }
    this.requestRender();
  }

  /** Sits on the subject: the hand does not turn it there. Null gets off; `go` then says where to. */
  ride(place: RiderPlace | null): void {
    const { camera, controls } = this;
    if (!place && controls.enabled) return;
    camera.fov = DEGREES * (place ? RIDER_FIELD : FIELD_OF_VIEW);
    controls.enabled = place === null;
    camera.up.set(...(place?.up ?? ([0, 0, 1] as const)));
    if (place) {
      this.glide = null;
      this.settling = false;
      camera.position.set(...place.eye);
      controls.target.set(...place.target);
      camera.lookAt(controls.target);
    }
    camera.updateProjectionMatrix();
  }

  /** Comes nearer or goes farther by a factor, the way it looks. */
  dolly(factor: number): void {
    const stand = (place: Placement): Vector3 =>
      place.camera.sub(place.target).multiplyScalar(factor).add(place.target);
    if (this.glide) for (const place of [this.glide.from, this.glide.to]) stand(place);
    this.put(stand({ camera: this.camera.position.clone(), target: this.target }), this.target.clone());
  }

  /** Moves camera and target together (m), also what a change of view is heading for. */
  shift(delta: Vector3): void {
    if (this.glide)
      for (const place of [this.glide.from, this.glide.to]) {
        place.camera.add(delta);
        place.target.add(delta);
      }
    this.put(this.camera.position.clone().add(delta), this.target.clone().add(delta));
  }

  /** Before each picture; `now` is the animation frame's time (ms). Asks for another picture while in motion. */
  update(now: number): void {
    if (this.glide) {
      this.glide.began ??= now;
      const share = Math.min(1, (now - this.glide.began) / GLIDE);
      const eased = share * share * (3 - 2 * share);
      const { from, to } = this.glide;
      this.put(from.camera.clone().lerp(to.camera, eased), from.target.clone().lerp(to.target, eased));
      if (share < 1) this.requestRender();
      else this.glide = null;
    } else if (this.settling) {
      if (this.quietly(() => this.controls.update())) this.requestRender();
      else this.settling = false;
    }
    const { distance } = this;
    this.camera.near = Math.max(0.01, 0.02 * distance);
    this.camera.far = 20 + 40 * distance;
    this.camera.updateProjectionMatrix();
  }

  dispose(): void {
    this.controls.dispose();
  }

  private put(camera: Vector3, target: Vector3): void {
    this.camera.position.copy(camera);
    this.controls.target.copy(target);
    this.quietly(() => this.controls.update());
  }

  /** The controls report moves that we made ourselves; those ask for no second picture. */
  private quietly<T>(work: () => T): T {
    this.quiet = true;
    try {
      return work();
    } finally {
      this.quiet = false;
    }
  }
}

interface Placement {
  camera: Vector3;
  target: Vector3;
}
