/** A second look at one place, in a corner of the picture. */
import { type Scene, type WebGLRenderer, PerspectiveCamera, Vector3 } from 'three';
import type { Bodies } from '../actors/bodies.ts';
import type { ScreenBox } from '../contract.ts';
import type { Focus } from '../camera/focus.ts';
import { FIELD_OF_VIEW, type Triple } from '../camera/views.ts';

interface Place {
  camera: Triple;
  target: Triple;
}

export class Inset {
  /** CSS pixels from the picture's top left corner; null without. */
  box: ScreenBox | null = null;
  private readonly camera = new PerspectiveCamera((FIELD_OF_VIEW * 180) / Math.PI, 1, 0.005, 50);
  private readonly target = new Vector3();

  constructor() {
    this.camera.up.set(0, 0, 1);
  }

  /** Where its camera stands now; null when there is nothing to come close to or no box. */
  place(focus: Focus, bodies: Bodies): Place | null {
    const { box } = this;
    if (!box || focus.plan.closeUp === null || box.right - box.left < 8 || box.bottom - box.top < 8) return null;
    return focus.closeUp((box.right - box.left) / (box.bottom - box.top), bodies);
  }

  /** Draws over what has been drawn; shadows are as they were. */
  draw(
    renderer: WebGLRenderer,
    scene: Scene,
    { camera, target }: Place,
    { width, height }: { width: number; height: number },
    look: (target: Vector3, distance: number, height: number) => void,
  ): void {
    const { left, top, right, bottom } = this.box!;
    const eye = this.camera;
    eye.aspect = (right - left) / (bottom - top);
    eye.position.set(...camera);
    eye.lookAt(this.target.set(...target));
    eye.updateProjectionMatrix();
    look(this.target, eye.position.distanceTo(this.target), eye.position.z);
    renderer.setViewport(left, height - bottom, right - left, bottom - top);
    renderer.setScissor(left, height - bottom, right - left, bottom - top);
    renderer.setScissorTest(true);
    renderer.shadowMap.autoUpdate = false;
    renderer.render(scene, eye);
    renderer.shadowMap.autoUpdate = true;
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
  }
}
