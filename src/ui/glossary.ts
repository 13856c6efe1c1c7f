/** The glossary, read from its document: one source for the page and for readers of the documents. */
import source from '../../docs/glossary.md?raw';
import { glossaryOf, type GlossaryEntry } from './glossaryText.ts';

export { idOf, type GlossaryEntry } from './glossaryText.ts';

export const glossary: readonly GlossaryEntry[] = glossaryOf(source);
