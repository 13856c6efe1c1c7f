import type { WorkerLike } from '../remote/remoteWorker.ts';
import type { Metas } from './answer.ts';
import { ControlClient } from './controlClient.ts';
import { CsvClient } from './csvClient.ts';
import { GaitClient } from './gaitClient.ts';
import { LocusClient } from './locusClient.ts';
import { MechanicsClient } from './mechanicsClient.ts';
import { Pool } from './pool.ts';
import { RunClient } from './runClient.ts';
import { SweepClient } from './sweepClient.ts';

/** What a worker is started for; all are the same program, and the name is seen in the browser's tools. */
export type Purpose =
  'run' | 'trust' | 'control' | 'effect' | 'locus' | 'gait' | 'mechanics' | 'csv' | 'comparison' | 'sweep' | 'tests';

/** All that the page can have computed aside. A worker is started by the first call that needs it. */
export class Compute {
  readonly run: RunClient;
  /** Runs computed a second time. */
  readonly trust: RunClient;
  readonly control: ControlClient;
  /** Regulators tried in whole runs, beside the answers that are waited for. */
  readonly effect: ControlClient;
  readonly locus: LocusClient;
  readonly gait: GaitClient;
  readonly mechanics: MechanicsClient;
  readonly csv: CsvClient;
  /** A core stays with the page, which draws the runs that come. */
  readonly comparison: Pool<RunClient>;
  /** Every core: only numbers come back, and the page has its share whenever it asks. */
  readonly sweep: Pool<SweepClient>;
  /** Workers for what is loaded later, and how many make sense. */
  readonly later: { start(purpose: Purpose): WorkerLike; cores: number };

  /** @param cores of the machine */
  constructor(start: (purpose: Purpose) => WorkerLike, metas: Metas, cores: number) {
    this.run = new RunClient(() => start('run'));
    this.trust = new RunClient(() => start('trust'));
    this.control = new ControlClient(() => start('control'), metas);
    this.effect = new ControlClient(() => start('effect'), metas);
    this.locus = new LocusClient(() => start('locus'), metas);
    this.gait = new GaitClient(() => start('gait'));
    this.mechanics = new MechanicsClient(() => start('mechanics'));
    this.csv = new CsvClient(() => start('csv'));
    this.comparison = new Pool(() => new RunClient(() => start('comparison')), cores - 1);
    this.later = { start, cores };
    this.sweep = new Pool(() => new SweepClient(() => start('sweep')), cores);
  }
}
