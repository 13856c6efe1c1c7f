/** Reads the glossary's document: for the page, and for the site's build, which has no bundler's imports. */
export interface GlossaryEntry {
  /** The heading in lower-kebab, as a link into the document has it. */
  id: string;
  term: string;
  meaning: string;
}

export const idOf = (term: string): string =>
  term
    .toLowerCase()
    .replace(/[^a-z0-9 -]/g, '')
    .trim()
    .replace(/ +/g, '-');

export function glossaryOf(text: string): GlossaryEntry[] {
  return text
    .split(/^## /m)
    .slice(1)
    .map((part) => {
      const [term = '', ...lines] = part.split('\n');
      return {
        id: idOf(term),
        term: term.trim(),
        meaning: lines.join(' ').replace(/`/g, '').replace(/\s+/g, ' ').trim(),
      };
    });
}
