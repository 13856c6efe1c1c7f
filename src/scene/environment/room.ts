/** The room that metals mirror: made when it can be afforded or is asked for, and never in the way of the first picture. */
import type { WebGLRenderer } from 'three';
import type { Quality } from '../contract.ts';
import { whenIdle } from './device.ts';
import type { Parts } from '../actors/parts.ts';
import type * as Studio from './studio.ts';

/** What makes it, once it is loaded. */
let studio: typeof Studio | null = null;

/** Before a picture that cannot wait: what a room takes. Rejects where it can't be fetched. */
export async function loadStudio(): Promise<void> {
  studio ??= await import('./studio.ts');
}

/** A picture that takes longer than this (ms) says that the device cannot afford the environment. */
const SLOW_PICTURE = 60;

export class Room {
  private readonly gl: WebGL2RenderingContext;
  private readonly renderer: WebGLRenderer;
  private readonly software: boolean;
  private readonly parts: Parts;
  private readonly changed: () => void;
  private quality: Quality = 'auto';
  private state: 'wanted' | 'coming' | 'made' | 'refused' = 'refused';
  private over = false;

  /** @param changed called when the room has come or gone */
  constructor(
    gl: WebGL2RenderingContext,
    renderer: WebGLRenderer,
    software: boolean,
    parts: Parts,
    changed: () => void,
  ) {
    this.gl = gl;
    this.renderer = renderer;
    this.software = software;
    this.parts = parts;
    this.changed = changed;
  }

  set(quality: Quality): void {
    if (quality === this.quality && this.state !== 'refused') return;
    this.quality = quality;
    const rich = quality === 'high' || (quality === 'auto' && !this.software);
    if (rich && this.state === 'refused') this.state = 'wanted';
    if (rich || this.state === 'refused') return;
    this.state = 'refused';
    if (!this.parts.lights.hasRoom) return;
    this.parts.lights.dropRoom();
    this.changed();
  }

  /** Before a picture is drawn, `drawn` having been since there was something to see; what it returns is called after. */
  watch(drawn: number): () => void {
    if (this.state !== 'wanted' || drawn < 1) return () => undefined;
    const measured = this.quality === 'auto' && drawn === 1;
    const began = measured ? performance.now() : 0;
    return () => {
      if (measured) this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits until it is drawn
      this.state = 'refused';
      if (measured && performance.now() - began >= SLOW_PICTURE) return;
      this.state = 'coming';
      whenIdle(() => this.make());
    };
  }

  /** For a picture that cannot wait: what would come is made now. */
  ready(): void {
    if (this.state === 'wanted') this.state = 'coming';
    this.make();
  }

  /** The context is lost, and with it the room: what there was, or was to come, is made again when there is one. */
  lose(): void {
    if (this.state === 'made' || this.state === 'coming') this.state = 'wanted';
    if (!this.parts.lights.hasRoom) return;
    this.parts.lights.dropRoom();
    this.changed();
  }

  dispose(): void {
    this.over = true;
  }

  private make(): void {
    if (this.over || this.state !== 'coming' || this.gl.isContextLost()) return;
    if (!studio) {
      // What could not be fetched is done without, until it is asked for again.
      void loadStudio().then(
        () => this.make(),
        () => (this.state = 'refused'),
      );
      return;
    }
    this.state = 'made';
    this.parts.lights.setRoom(studio.roomLight(this.renderer));
    this.changed();
  }
}
