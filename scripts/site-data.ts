// What the site's pages know of the program, as JSON: the gallery in its chapters, links into the lab, the glossary.
// npm run site starts it and gives the file to write.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { builtInCases as cases } from '../src/app/state/cases.ts';
import { sectionsOf } from '../src/features/gallery/gallerySections.ts';
import { text as galleryWords } from '../src/features/gallery/words.ts';
import { readLesson, type Subject } from '../src/core/lessons/lesson.ts';
import { encodeLink } from '../src/core/scenario/link.ts';
import type { ScenarioFile } from '../src/core/scenario/types.ts';
import { systemMetas } from '../src/core/systems/registry.ts';
import { glossaryOf } from '../src/ui/glossaryText.ts';

const file = process.argv[2];
if (file === undefined) throw new Error('npm run site: the file to write is not named.');
const known = { cases, systems: systemMetas };

const linkTo = (subject: Subject, title: string, tool?: string): string => {
  const base = 'case' in subject ? cases.find(({ id }) => id === subject.case) : undefined;
  if ('case' in subject && !base) throw new Error(`there is no case "${subject.case}"`);
  const scenario = base?.scenario ?? ((subject as { scenario: unknown }).scenario as ScenarioFile);
  return encodeLink(
    { caseId: base?.id ?? null, ...(base ? {} : { title }), scenario, ...(tool ? { tool } : {}) },
    known,
  );
};

const gallery = sectionsOf(cases).map(({ id, families }) => ({
  title: galleryWords.sections[id],
  cases: families.flat().map((one) => ({
    id: one.id,
    title: one.title,
    summary: one.summary,
    system: systemMetas[one.scenario.system]!.title,
    link: linkTo({ case: one.id }, one.title),
  })),
}));

const lessons = readdirSync('lessons')
  .filter((name) => name.endsWith('.md'))
  .sort()
  .map((name) => {
    const { title, blocks } = readLesson(readFileSync(`lessons/${name}`, 'utf8'));
    const parts = blocks.flatMap((block) =>
      block.kind === 'text'
        ? []
        : [
            block.kind === 'live'
              ? { kind: 'live', title: block.title, link: linkTo(block.subject, block.title) }
              : { kind: 'question', text: block.text, hint: block.hint, unit: block.unit },
          ],
    );
    const first = blocks.find((block) => block.kind === 'live');
    return { file: name, title, parts, link: first ? linkTo(first.subject, first.title, 'lessons') : '' };
  });

const glossary = glossaryOf(readFileSync('docs/glossary.md', 'utf8'));
writeFileSync(file, JSON.stringify({ gallery, lessons, glossary }));
