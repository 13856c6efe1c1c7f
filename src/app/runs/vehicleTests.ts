import { signal } from '@preact/signals';
import type { Pool } from '../../compute/client/pool.ts';
import type { TestsClient } from '../../compute/client/testsClient.ts';
import type { TestAnswer } from '../../compute/services/testsTypes.ts';
import { runsOf } from '../../core/manoeuvres/run.ts';
import type { CheckedTest } from '../../core/manoeuvres/testFile.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { readonly } from '../state/signals.ts';

/** A run to be measured, of a test by its place. */
type TestRun = Parameters<TestsClient['measure']>[0] & { place: number };

/** Puts the scenario through its tests in workers of its own; what has come so far is there at any time. */
export class VehicleTests {
  private readonly ownState = signal<'empty' | 'computing' | 'ended' | 'cancelled'>('empty');
  private readonly ownVersion = signal(0);
  readonly state = readonly(this.ownState);
  /** Rises when an answer has come. */
  readonly version = readonly(this.ownVersion);
  /** By test, then by run. */
  answers: (TestAnswer | undefined)[][] = [];
  /** What the answers are of. */
  file: ScenarioFile | null = null;
  system = '';
  tests: readonly CheckedTest[] = [];
  private readonly pool: Pool<TestsClient>;

  constructor(pool: Pool<TestsClient>) {
    this.pool = pool;
  }

  /**
   * @param file the scenario as it stands
   * @param system its id
   * @param tests checked
   */
  start(file: ScenarioFile, system: string, tests: readonly CheckedTest[]): void {
    const all = tests.map((test) => runsOf(test, file));
    const counts = all.map(({ length }) => length);
    const runs = all.flatMap((ofTest, place) =>
      ofTest.map(({ file: of, designedFor }): TestRun => ({ place, test: tests[place]!, file: of, designedFor })),
    );
    [this.file, this.system, this.tests] = [file, system, tests];
    this.answers = counts.map((count) => new Array<TestAnswer | undefined>(count).fill(undefined));
    this.ownState.value = 'computing';
    this.ownVersion.value++;
    const firsts = counts.map((_, place) => runs.findIndex((run) => run.place === place));
    this.pool.start(
      runs.length,
      (lane, job, done) => {
        const { place, ...request } = runs[job]!;
        void lane.measure(request).then((answer) => {
          if (!answer) return;
          this.answers[place]![job - firsts[place]!] = answer.ok
            ? answer.value
            : { measured: answer.message, seconds: 0, picture: null };
          this.ownVersion.value++;
          done();
        });
      },
      () => (this.ownState.value = 'ended'),
    );
  }

  /** What was computed stays. */
  cancel(): void {
    if (this.state.peek() !== 'computing') return;
    this.pool.stop();
    this.ownState.value = 'cancelled';
  }
}
