import { describe, expect, test } from 'vitest';
import { Pool } from '../../src/compute/pool.ts';
import { placesOf, runsOf, scenarioAt, Sweep, type SweepPlan } from '../../src/app/runs/sweep.ts';
import type { SweepReply, SweepRequest } from '../../src/compute/sweepProtocol.ts';

class Lane {
  closed = false;
  close(): void {
    this.closed = true;
  }
}

const turn = (): Promise<void> => new Promise((done) => setTimeout(done));

describe('a pool', () => {
  test('computes every job once, in order, never more at a time than there are lanes', async () => {
    const lanes: Lane[] = [];
    const pool = new Pool(() => (lanes.push(new Lane()), lanes[lanes.length - 1]!), 4);
    const begun: number[] = [];
    const over: (() => void)[] = [];
    let most = 0;
    let finished = 0;
    pool.start(
      10,
      (lane, job, done) => {
        expect(lane.closed).toBe(false);
        begun.push(job);
        over.push(done);
        most = Math.max(most, over.length);
      },
      () => finished++,
    );
    expect(begun).toEqual([0, 1, 2]);
    while (over.length > 0) {
      over.pop()!();
      await turn();
    }
    expect(begun).toEqual([...Array(10).keys()]);
    expect([most, finished, lanes.length]).toEqual([3, 1, 3]);
    expect(lanes.every((l) => l.closed)).toBe(true);
  });

  test('jobs that are over at once do not nest, and one told twice counts once', async () => {
    const pool = new Pool(() => new Lane(), 2);
    let depth = 0;
    let jobs = 0;
    let finished = 0;
    pool.start(
      5000,
      (_lane, _job, done) => {
        expect(depth++).toBe(0);
        jobs++;
        done();
        done();
        depth--;
      },
      () => finished++,
    );
    await turn();
    expect([jobs, finished]).toEqual([5000, 1]);
  });

  test('hears nothing of what it stopped', async () => {
    const lanes: Lane[] = [];
    const pool = new Pool(() => (lanes.push(new Lane()), lanes[lanes.length - 1]!), 3);
    const over: (() => void)[] = [];
    let finished = 0;
    pool.start(
      4,
      (_lane, _job, done) => void over.push(done),
      () => finished++,
    );
    pool.stop();
    for (const done of over) done();
    await turn();
    expect([over.length, finished]).toEqual([2, 0]);
    expect(lanes.every((l) => l.closed)).toBe(true);
  });
});

/** A worker of the test: answers when told to. */
class Answering {
  static all: Answering[] = [];
  static dead = 0;
  onmessage: ((event: { data: SweepReply }) => void) | null = null;
  onerror: ((event: { message: string }) => void) | null = null;
  asked: SweepRequest | null = null;
  constructor() {
    Answering.all.push(this);
  }
  postMessage(request: SweepRequest): void {
    this.asked = request;
  }
  terminate(): void {
    Answering.dead++;
  }
  say(reply: SweepReply): void {
    this.onmessage?.({ data: reply });
  }
  measured(): void {
    const { job, file } = this.asked!;
    const value = file.parameters!['a'] as number;
    this.say({
      type: 'measured',
      job,
      values: [10 * value],
      end: { reason: 'end', message: '', time: 1 },
      counts: { steps: 1, rejected: 0, evaluations: 0, jacobians: 0, factorizations: 0, energyDrift: 0, residual: 0 },
      seconds: 0,
    });
  }
}

const axis = (path: string, values: readonly number[]) => ({
  path,
  label: path,
  unit: '',
  angle: false,
  values: values.map((value) => ({ value, label: String(value) })),
});
const plan: SweepPlan = {
  title: 'test',
  file: { version: 1, system: 'ripstik' },
  axes: [axis('parameters.a', [1, 2, 3]), axis('initial.b', [10, 20])],
  measures: [{ kind: 'time' }],
};

describe('a sweep', () => {
  const fresh = (): Sweep => {
    Answering.all = [];
    Answering.dead = 0;
    return new Sweep(() => new Answering() as unknown as Worker, 3);
  };

  test('goes through every pair, the first fastest', () => {
    expect(runsOf(plan)).toBe(6);
    expect(Array.from({ length: 6 }, (_, job) => placesOf(plan, job))).toEqual([
      [0, 0],
      [1, 0],
      [2, 0],
      [0, 1],
      [1, 1],
      [2, 1],
    ]);
    expect(scenarioAt(plan, 4)).toEqual({ version: 1, system: 'ripstik', parameters: { a: 2 }, initial: { b: 20 } });
  });

  test('keeps each answer in its place; progress counts runs under way', async () => {
    const sweep = fresh();
    sweep.start(plan);
    const [one, two] = Answering.all as [Answering, Answering];
    one.say({ type: 'progress', job: 0, share: 0.5 });
    expect([sweep.done, sweep.progress]).toEqual([0, 0.5]);
    two.measured();
    await turn();
    expect([sweep.done, sweep.progress, two.asked!.job]).toEqual([1, 1.5, 2]);
    one.say({ type: 'refused', job: 0, path: '', message: 'no' });
    await turn();
    for (let k = 0; k < 6; k++) {
      for (const worker of [two, one]) if (sweep.done < 6 && !sweep.results[worker.asked!.job]) worker.measured();
      await turn();
    }
    expect(sweep.state.value).toBe('ended');
    expect(sweep.results.map((r) => r!.values[0])).toEqual([NaN, 20, 30, 10, 20, 30]);
    expect(sweep.results[0]).toMatchObject({ reason: 'refused', message: 'no' });
    expect(Answering.dead).toBe(2);
  });

  test('keeps what is finished when it is cancelled', async () => {
    const sweep = fresh();
    sweep.start(plan);
    Answering.all[0]!.measured();
    await turn();
    sweep.cancel();
    for (const worker of Answering.all) worker.measured();
    await turn();
    expect(sweep.state.value).toBe('cancelled');
    expect([sweep.done, sweep.results.filter(Boolean).length]).toEqual([1, 1]);
    expect(sweep.results[0]!.values).toEqual([10]);
  });

  test('goes on with a new worker after one that died', async () => {
    const sweep = fresh();
    sweep.start({ ...plan, axes: [axis('parameters.a', [1, 2, 3])] });
    Answering.all[0]!.onerror?.({ message: 'out of memory' });
    await turn();
    expect(sweep.results[0]!.message).toContain('out of memory');
    expect(Answering.all).toHaveLength(3);
    expect(Answering.all[2]!.asked!.job).toBe(2);
  });

  test('of too many runs is refused', () => {
    const many = axis(
      'parameters.a',
      Array.from({ length: 50 }, (_, i) => i),
    );
    expect(() => fresh().start({ ...plan, axes: [many, { ...many, path: 'initial.b' }] })).toThrow(
      /2500 runs are more than the 2000/,
    );
  });
});
