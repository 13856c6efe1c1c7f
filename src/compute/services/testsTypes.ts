import type { Measured } from '../../core/manoeuvres/run.ts';
import type { CheckedTest } from '../../core/manoeuvres/testFile.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { Call } from '../remote/protocol.ts';

export interface TestsCalls {
  /** One run of a test. The scenario is checked in the worker; a run that can't begin answers with why. */
  'tests.measure': Call<TestRequest, TestAnswer>;
}

export interface TestRequest {
  test: CheckedTest;
  /** What is run, and what its controller is designed for. */
  file: ScenarioFile;
  designedFor: ScenarioFile;
}

export interface TestAnswer {
  measured: Measured | string;
  seconds: number;
  /** Curves for a picture, at most a few hundred points: the path on the ground and what is measured over time. */
  picture: { x: number[]; y: number[] } | null;
}
