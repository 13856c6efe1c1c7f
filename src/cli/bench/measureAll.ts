import { loadavg } from 'node:os';
import { bench } from './bench.ts';
import { apart, here } from './apart.ts';
import { QUICK, THOROUGH } from './measure.ts';
import { limit } from './limit.ts';
import { race } from './race.ts';
import { summaryOf, type Results } from './report.ts';
import { rival } from './rival.ts';
import { ownError, rivals } from './rivals.ts';
import { sweep } from './sweep.ts';
import { BRIEF, FULL, problems, workPrecision, type Problem, type WorkReport } from './workPrecision.ts';

/** Of the falling board, s. */
const RACE_SECONDS = { full: 60, quick: 0.5 } as const;
const SWEEP_RUNS = { full: 1024, quick: 4 } as const;

export interface Measured {
  results: Results;
  work: Record<Problem, WorkReport>;
}

/** One run of everything; `say` hears what is being measured. */
export async function measureAll(quick: boolean, say: (what: string) => void): Promise<Measured> {
  const [options, settings, call] = quick ? ([QUICK, BRIEF, here] as const) : ([THOROUGH, FULL, apart] as const);
  const load = loadavg()[0]!;
  say('MuJoCo beside us');
  const beside = await rival(options);
  say('accelerations and steps per second');
  const own = bench(options, call);
  const work = Object.fromEntries(
    (Object.keys(problems) as Problem[]).map((problem) => {
      say(`work and precision: ${problem} board`);
      return [problem, workPrecision(problem, settings, call)];
    }),
  ) as Record<Problem, WorkReport>;
  say('the falling board');
  const duration = quick ? RACE_SECONDS.quick : RACE_SECONDS.full;
  const precision = { coasting: summaryOf(work.coasting), falling: summaryOf(work.falling) };
  const entries = race(duration, call);
  say('where the time goes');
  const limits = limit(duration, options, call);
  say('the sweep');
  const runs = quick ? SWEEP_RUNS.quick : SWEEP_RUNS.full;
  const swept = sweep(runs, call);
  say('the rivals in Python');
  const others = quick ? [] : rivals(runs, say);
  return {
    results: {
      ...own,
      load,
      rival: beside,
      precision,
      race: { duration, entries },
      limit: limits,
      sweep: { ...swept, error: ownError(runs), rivals: others },
    },
    work,
  };
}
