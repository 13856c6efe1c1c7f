import { cpus } from 'node:os';

/**
 * Times of repeated work. Processor time of this process decides, because a machine that is shared stretches wall
 * time; both are given. Spread is the quartiles over the samples; a checksum of what was computed goes with them.
 */

/** Warm-up before anything is counted, in samples' lengths: by then the code is optimised. */
const WARM_UP = 6;
/** Milliseconds of one look whether the background is still, and how many looks at the most. */
const LOOK = 20;
const MOST_LOOKS = 200;

export interface Machine {
  processor: string;
  cores: number;
  node: string;
  v8: string;
  platform: string;
}

/** Microseconds per unit of work. */
export interface Times {
  /** Of processor time, as are the quartiles and the least. */
  median: number;
  quartiles: readonly [number, number];
  least: number;
  wallMedian: number;
  samples: number;
  /** Units of work in each sample. */
  count: number;
}

/** Something to be timed: does `count` units and returns a number that depends on all of them. */
export type Work = (count: number) => number;

export interface MeasureOptions {
  samples: number;
  /** Least processor time of one sample, s. */
  seconds: number;
}

export const THOROUGH: MeasureOptions = { samples: 21, seconds: 0.04 };
/** For a smoke test: the numbers mean nothing. */
export const QUICK: MeasureOptions = { samples: 3, seconds: 0.0005 };

export function machine(): Machine {
  const list = cpus();
  return {
    processor: list[0]?.model.trim() ?? 'unknown',
    cores: list.length,
    node: process.versions.node,
    v8: process.versions.v8,
    platform: `${process.platform} ${process.arch}`,
  };
}

/** Processor time of this process, s. */
export function processorTime(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}

/** Times several kinds of work in turns, so that whatever disturbs the machine disturbs all of them. */
export function measureTogether<Name extends string>(
  works: Readonly<Record<Name, Work>>,
  options: MeasureOptions,
): Record<Name, Times> {
  const names = Object.keys(works) as Name[];
  for (const name of names) warmUp(works[name], WARM_UP * options.seconds);
  settle();
  const counts = names.map((name) => countFor(works[name], options.seconds));
  settle();
  const taken = names.map(() => ({ processor: [] as number[], wall: [] as number[] }));
  for (let sample = 0; sample < options.samples; sample++) {
    names.forEach((name, k) => {
      const wall = performance.now();
      const processor = processorTime();
      works[name](counts[k]!);
      taken[k]!.processor.push((1e6 * (processorTime() - processor)) / counts[k]!);
      taken[k]!.wall.push((1e3 * (performance.now() - wall)) / counts[k]!);
    });
  }
  return Object.fromEntries(
    names.map((name, k) => [name, timesOf(taken[k]!.processor, taken[k]!.wall, counts[k]!)]),
  ) as Record<Name, Times>;
}

function warmUp(work: Work, seconds: number): void {
  const until = performance.now() + 1000 * seconds;
  do work(64);
  while (performance.now() < until);
}

/** How many units fill a sample; the better of two tries, so that a disturbed one does not make samples too short. */
function countFor(work: Work, seconds: number): number {
  for (let count = 16; ; count *= 2) {
    if (Math.min(timeOf(work, count), timeOf(work, count)) >= seconds) return count;
  }
}

function timeOf(work: Work, count: number): number {
  const from = processorTime();
  work(count);
  return processorTime() - from;
}

/** Waits until the compilers in the background have nothing left to do: their time would count as ours. */
export function settle(): void {
  const still = new Int32Array(new SharedArrayBuffer(4));
  for (let look = 0; look < MOST_LOOKS; look++) {
    const from = processorTime();
    Atomics.wait(still, 0, 0, LOOK);
    if (processorTime() - from < (0.1 * LOOK) / 1000) return;
  }
}

export function timesOf(processor: readonly number[], wall: readonly number[], count: number): Times {
  return {
    median: quantile(processor, 0.5),
    quartiles: [quantile(processor, 0.25), quantile(processor, 0.75)],
    least: Math.min(...processor),
    wallMedian: quantile(wall, 0.5),
    samples: processor.length,
    count,
  };
}

/** By linear interpolation between order statistics. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  const at = share * (sorted.length - 1);
  const below = sorted[Math.floor(at)]!;
  return below + (at - Math.floor(at)) * (sorted[Math.ceil(at)]! - below);
}

/** Numbers folded into one, all digits of each deciding: two runs that computed the same print the same. */
export class Checksum {
  private state = 0x811c9dc5;
  private readonly number = new Float64Array(1);
  private readonly words = new Uint32Array(this.number.buffer);

  add(value: number): void {
    this.number[0] = value;
    for (const word of this.words) this.state = Math.imul(this.state ^ word, 0x01000193) >>> 0;
  }

  get text(): string {
    return this.state.toString(16).padStart(8, '0');
  }
}
