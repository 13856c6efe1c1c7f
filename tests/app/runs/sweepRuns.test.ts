import { describe, expect, test } from 'vitest';
import { placesOf, runsOf, scenarioAt, Sweep, type SweepPlan } from '../../../src/app/runs/sweep.ts';
import { Pool } from '../../../src/compute/client/pool.ts';
import { SweepClient } from '../../../src/compute/client/sweepClient.ts';
import type { SweepCalls } from '../../../src/compute/services/sweepTypes.ts';
import type { Reduced } from '../../../src/core/sweep/reduceRun.ts';
import type { Handlers } from '../../../src/compute/remote/serve.ts';
import { NearWorker, turn } from '../../compute/nearWorker.ts';

/** A worker of the test: answers when told to. */
class Answering {
  static all: Answering[] = [];
  readonly near: NearWorker;
  asked: Parameters<Handlers<SweepCalls>['sweep.measure']>[0] | null = null;
  share: (share: number) => void = () => {};
  private resolve: (measured: Reduced) => void = () => {};
  private reject: (error: Error) => void = () => {};

  constructor() {
    Answering.all.push(this);
    const calls: Handlers<SweepCalls> = {
      'sweep.measure': (request, { emit }) => {
        this.asked = request;
        this.share = emit;
        return new Promise((resolve, reject) => {
          this.resolve = resolve;
          this.reject = reject;
        });
      },
    };
    this.near = new NearWorker({ sweep: () => Promise.resolve(calls) });
  }

  refuse(message: string): void {
    this.asked = null;
    this.reject(new Error(message));
  }

  measured(): void {
    const value = this.asked!.file.parameters!['a'] as number;
    this.asked = null;
    this.resolve({
      values: [10 * value],
      end: { reason: 'end', message: '', time: 1 },
      counts: {
        steps: 1,
        rejected: 0,
        evaluations: 0,
        jacobians: 0,
        factorizations: 0,
        energyDrift: 0,
        energyChange: 0,
        work: null,
        residual: 0,
      },
      seconds: 0,
      engine: 'typescript',
    });
  }
}

const until = async (what: () => boolean): Promise<void> => {
  while (!what()) await turn();
};

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
    return new Sweep(new Pool(() => new SweepClient(() => new Answering().near), 2));
  };
  const asked = (): Promise<void> => until(() => Answering.all.every(({ asked }) => asked !== null));
  const ended = (): boolean[] => Answering.all.map(({ near }) => near.terminated);

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
    await asked();
    one.share(0.5);
    await until(() => sweep.progress > 0);
    expect([sweep.done, sweep.progress]).toEqual([0, 0.5]);
    two.measured();
    await asked();
    expect([sweep.done, sweep.progress]).toEqual([1, 1.5]);
    expect(two.asked!.file).toEqual(scenarioAt(plan, 2));
    one.refuse('no');
    await until(() => {
      for (const worker of [two, one]) if (worker.asked) worker.measured();
      return sweep.state.value === 'ended';
    });
    expect(sweep.results.map((r) => r!.values[0])).toEqual([NaN, 20, 30, 10, 20, 30]);
    expect(sweep.results[0]).toMatchObject({ reason: 'refused', message: 'no' });
    expect([sweep.done, sweep.progress]).toEqual([6, 6]);
    await until(() => ended().every(Boolean));
  });

  test('keeps what is finished when it is cancelled', async () => {
    const sweep = fresh();
    sweep.start(plan);
    await asked();
    Answering.all[0]!.measured();
    await until(() => sweep.done === 1);
    await asked();
    sweep.cancel();
    for (const worker of Answering.all) worker.measured();
    await turn();
    expect(sweep.state.value).toBe('cancelled');
    expect([sweep.done, sweep.results.filter(Boolean).length]).toEqual([1, 1]);
    expect(sweep.results[0]!.values).toEqual([10]);
    expect(ended()).toEqual([true, true]);
  });

  test('goes on with a new worker after one that died', async () => {
    const sweep = fresh();
    const one = { ...plan, axes: [axis('parameters.a', [1, 2, 3])] };
    sweep.start(one);
    await asked();
    Answering.all[0]!.near.die('out of memory');
    await until(() => Answering.all.length === 3 && Answering.all[2]!.asked !== null);
    expect(sweep.results[0]!.message).toBe('the computation stopped unexpectedly (out of memory)');
    expect(Answering.all[2]!.asked!.file).toEqual(scenarioAt(one, 2));
    sweep.cancel();
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
