/** What a display shows in a second, at least: what is missing of it was dropped, ms. */
const INTERVAL = 1000 / 60;

/** How long it takes from a key to the picture that shows what came of it, and how many pictures were left out. */
export class Measure {
  readonly latencies: number[] = [];
  dropped = 0;
  frames = 0;
  private waiting: { given: number; time: number }[] = [];
  private last: number | null = null;

  /** A command given then (ms) acts from this time of the ride on (s). */
  told(given: number, time: number): void {
    this.waiting.push({ given, time });
  }

  /** A picture of the ride at this time (s) is drawn and handed to the display, now (ms). */
  shown(now: number, time: number): void {
    const seen = this.waiting.filter((one) => one.time < time);
    this.waiting = this.waiting.filter((one) => one.time >= time);
    this.latencies.push(...seen.map(({ given }) => now - given));
  }

  /** The display asks for a picture, now (ms). */
  frame(now: number): void {
    this.frames++;
    if (this.last !== null) {
      const missed = Math.round((now - this.last) / INTERVAL) - 1;
      if (missed > 0) {
        this.dropped += missed;
        this.frames += missed;
      }
    }
    this.last = now;
  }

  /** ms; null before anything was told. */
  get latency(): number | null {
    return this.latencies.length > 0 ? median(this.latencies) : null;
  }
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor((sorted.length - 1) / 2)]!;
}
