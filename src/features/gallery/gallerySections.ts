/** Which cases the gallery shows for a search, and under which heading each stands. */
import type { CaseInfo } from '../../app/state/cases.ts';

/** Headings in their order: our own cases, the report's chapters, then what comes from papers. */
export const sectionIds = ['board', '3.2', '3.3', '3.4', '3.5', 'papers'] as const;
export type SectionId = (typeof sectionIds)[number];

export function sectionOf({ chapter, source }: CaseInfo): SectionId {
  const found = sectionIds.find((id) => chapter === id || chapter?.startsWith(`${id}.`));
  return found ?? (source ? 'papers' : 'board');
}

/** @param systemTitle the name of the case's system, which is searched too */
export function matches(one: CaseInfo, words: string, systemTitle: string): boolean {
  const about = [
    one.id,
    one.title,
    one.summary,
    one.source,
    one.figure,
    one.chapter,
    systemTitle,
    one.scenario.control?.type,
  ]
    .join(' ')
    .toLowerCase();
  return words
    .toLowerCase()
    .split(/\s+/)
    .every((word) => about.includes(word));
}

/** Sections that have cases, each with its own in their order. */
export function sectionsOf(cases: readonly CaseInfo[]): { id: SectionId; cases: readonly CaseInfo[] }[] {
  return sectionIds
    .map((id) => ({ id, cases: cases.filter((one) => sectionOf(one) === id) }))
    .filter((section) => section.cases.length > 0);
}
