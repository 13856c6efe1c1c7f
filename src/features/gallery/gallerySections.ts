/** Which cases the gallery shows for a search, and under which heading each stands. */
import type { CaseInfo } from '../../app/state/cases.ts';

/** Headings in their order: the board itself, what it is made of, how its motion is had, how it is held up, who rides it. */
export const sectionIds = ['board', 'parts', 'mathematics', 'control', 'rider'] as const;
export type SectionId = (typeof sectionIds)[number];

/** Systems that belong to one chapter, whatever is done with them. */
const CHAPTERS: Readonly<Record<string, SectionId>> = {
  'caster-rotation': 'parts',
  'rolling-wheel': 'parts',
  'stiff-decay': 'mathematics',
  'chaplygin-sleigh': 'mathematics',
  bicycle: 'mathematics',
  'bicycle-rider': 'rider',
  'cart-pendulum': 'control',
  'wheel-pendulum': 'control',
  'ripstik-rider': 'rider',
  'casterboard-robot': 'rider',
};

/** Of the board: what the report computes with it is mathematics, what a regulator holds up control. */
export function sectionOf({ scenario, chapter }: CaseInfo): SectionId {
  const own = CHAPTERS[scenario.system];
  if (own) return own;
  return scenario.control?.type === 'lqr' ? 'control' : chapter ? 'mathematics' : 'board';
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

/** Cases that differ in one thing, together; the first stands for them. */
export type Family = readonly [CaseInfo, ...CaseInfo[]];

/** Sections that have cases, each with its own in their order. */
export function sectionsOf(cases: readonly CaseInfo[]): { id: SectionId; families: readonly Family[] }[] {
  return sectionIds
    .map((id) => ({ id, families: familiesOf(cases.filter((one) => sectionOf(one) === id)) }))
    .filter((section) => section.families.length > 0);
}

function familiesOf(cases: readonly CaseInfo[]): Family[] {
  const families = new Map<string, [CaseInfo, ...CaseInfo[]]>();
  for (const one of cases) {
    const key = one.among ? `among ${one.among.id}` : one.id;
    const family = families.get(key);
    if (family) family.push(one);
    else families.set(key, [one]);
  }
  return [...families.values()];
}
