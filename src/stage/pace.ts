/** Work on the page's own thread that is too long for one go: slices of a few milliseconds, between which the page lives. */

const SLICE_MS = 8;

export class Pace {
  private readonly signal: AbortSignal | undefined;
  private since = performance.now();

  constructor(signal?: AbortSignal) {
    this.signal = signal;
  }

  /** Whether it is time to `breathe`. */
  get over(): boolean {
    return performance.now() - this.since > SLICE_MS;
  }

  /** Lets the page live. @throws what the signal says when it was aborted */
  async breathe(): Promise<void> {
    await new Promise((done) => setTimeout(done));
    this.signal?.throwIfAborted();
    this.since = performance.now();
  }
}
