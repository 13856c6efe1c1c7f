/** What a draft comes from: a built-in case, or a scenario that was opened. */
import type { Case } from '../../core/cases/case.ts';
import { cases } from '../../core/systems/registry.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';

export interface CaseInfo {
  /** Empty for what is no built-in case. */
  id: string;
  title: string;
  /** One line: what to look at. */
  summary: string;
  scenario: ScenarioFile;
  /** Where it comes from: figure and section of the report, or a paper. */
  source?: string | undefined;
  figure?: string | undefined;
  chapter?: string | undefined;
  /** Of cases that differ in one thing: what they share, and this one's value. */
  among?: Case['among'] | undefined;
  /** Where its picture is taken. */
  picture?: Case['picture'] | undefined;
}

export const builtInCases: readonly CaseInfo[] = cases.map(({ look, ...one }) => ({ ...one, summary: look }));

/** A scenario that is no built-in case. */
export const ownCase = (title: string, scenario: ScenarioFile): CaseInfo => ({ id: '', title, summary: '', scenario });

/** A system nobody has made a case for starts with everything at its default. */
export const firstCaseOf = ({ id, title }: SystemMeta): CaseInfo =>
  builtInCases.find((c) => c.scenario.system === id) ?? ownCase(title, { version: 1, system: id });
