/** The pointer's push: presses on a point of a body and drags it about in the plane through it that faces the camera. */
import type { PushByDrag, Pick, SceneOptions } from '../contract.ts';

/** How far from a body a press still pushes it (CSS pixels). */
const REACH = { mouse: 3, touch: 14 } as const;
/** A press as near to the bodies as this was meant for one of them (CSS pixels): missing it moves nothing, the camera least. */
const MISS = 80;

type Point = readonly [number, number, number];

/** What a push needs of the scene. */
export interface PushScene {
  pick(x: number, y: number, reach: number): Pick | null;
  /** Whether a place on the screen is within so many CSS pixels of what bounds a body. */
  near(x: number, y: number, pixels: number): boolean;
  /** Where the pointer at a place on the screen takes the point that stands here in the body's frame. */
  reachTo(x: number, y: number, at: Pick): Point | null;
  /** How fast the camera goes along with what it follows, m/s. */
  pace(): Point;
}

export class PushDrag {
  when: PushByDrag = 'never';
  private readonly canvas: HTMLCanvasElement;
  private readonly scene: PushScene;
  private readonly tell: Listener;
  private pressed: { pointer: number; at: Pick; x: number; y: number; last: Point } | null = null;
  /** The pointer of a push that missed: nobody hears of it until it is lifted. */
  private missed: number | null = null;
  private readonly undo = new AbortController();

  /** Made before the camera's own controls or not: it hears of a press first, and keeps those that are its own. */
  constructor(canvas: HTMLCanvasElement, scene: PushScene, tell: Listener) {
    this.canvas = canvas;
    this.scene = scene;
    this.tell = tell;
    const options = { capture: true, signal: this.undo.signal };
    canvas.addEventListener('pointerdown', (event) => this.press(event), options);
    canvas.addEventListener('pointermove', (event) => this.move(event), options);
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      canvas.addEventListener(type, (event) => this.lift(event), options);
    window.addEventListener('blur', () => this.release(), { signal: this.undo.signal });
  }

  get active(): boolean {
    return this.pressed !== null;
  }

  /** After the bodies or the camera have moved: the pointer stays where it is on the screen. */
  follow(): void {
    const { pressed } = this;
    if (!pressed) return;
    const target = this.scene.reachTo(pressed.x, pressed.y, pressed.at);
    if (!target || target.every((value, i) => value === pressed.last[i])) return;
    pressed.last = target;
    this.tell.onPushMove?.(target, this.scene.pace());
  }

  release(): void {
    if (!this.pressed) return;
    this.pressed = null;
    this.canvas.style.cursor = '';
    this.tell.onPushEnd?.();
  }

  dispose(): void {
    this.undo.abort();
    this.release();
  }

  private press(event: PointerEvent): void {
    if (this.pressed) return event.stopImmediatePropagation();
    const wanted = this.when === 'always' || (this.when === 'shift' && event.shiftKey);
    if (!wanted || event.button !== 0) return;
    const [x, y] = this.place(event);
    const at = this.scene.pick(x, y, event.pointerType === 'touch' ? REACH.touch : REACH.mouse);
    if (!at) {
      if (!event.shiftKey && !this.scene.near(x, y, MISS)) return;
      this.missed = event.pointerId;
      return event.stopImmediatePropagation();
    }
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.style.cursor = 'grabbing';
    this.pressed = { pointer: event.pointerId, at, x, y, last: at.world };
    this.tell.onPushStart?.(at);
  }

  private move(event: PointerEvent): void {
    const { pressed } = this;
    if (event.pointerId === this.missed && event.buttons !== 0) return event.stopImmediatePropagation();
    if (!pressed) return this.hover(event);
    event.stopImmediatePropagation();
    if (pressed.pointer !== event.pointerId) return;
    [pressed.x, pressed.y] = this.place(event);
    this.follow();
  }

  private lift(event: PointerEvent): void {
    if (event.pointerId === this.missed) {
      this.missed = null;
      return event.stopImmediatePropagation();
    }
    if (!this.pressed) return;
    event.stopImmediatePropagation();
    if (this.pressed.pointer === event.pointerId) this.release();
  }

  /** Tells a mouse that it could push here. */
  private hover(event: PointerEvent): void {
    if (event.pointerType !== 'mouse' || event.buttons !== 0 || this.when === 'never') return;
    const ready =
      (this.when === 'always' || event.shiftKey) && this.scene.pick(...this.place(event), REACH.mouse) !== null;
    const cursor = ready ? 'grab' : '';
    if (this.canvas.style.cursor !== cursor) this.canvas.style.cursor = cursor;
  }

  private place(event: PointerEvent): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}

type Listener = { [K in 'onPushStart' | 'onPushMove' | 'onPushEnd']?: SceneOptions[K] | undefined };
