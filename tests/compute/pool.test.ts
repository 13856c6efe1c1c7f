import { describe, expect, test } from 'vitest';
import { Pool } from '../../src/compute/client/pool.ts';

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
    const pool = new Pool(() => (lanes.push(new Lane()), lanes[lanes.length - 1]!), 3);
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
    const pool = new Pool(() => new Lane(), 1);
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
    const pool = new Pool(() => (lanes.push(new Lane()), lanes[lanes.length - 1]!), 2);
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
