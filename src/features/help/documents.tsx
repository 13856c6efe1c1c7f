/** The documents that come with the page, to be read in it. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { useUi } from '../../ui/context.ts';
import { LoadingPart } from '../../ui/kit/loadingPart.tsx';
import { Markdown } from '../../ui/kit/markdown.tsx';
import { words } from './words.ts';

const loaders = import.meta.glob<string>('../../../docs/*.md', { query: '?raw', import: 'default' });
const files = new Map(Object.entries(loaders).map(([path, load]) => [path.split('/').at(-1)!, load]));
/** Of those who work on the program. */
const NOT_SHOWN = new Set(['README.md', 'dependencies.md', 'adding-a-feature.md', 'adding-a-system.md', 'glossary.md']);
const LETTERS: Readonly<Record<string, string>> = { csv: 'CSV', ripstik: 'RipStik' };

const titleOf = (file: string): string => {
  const [first = '', ...rest] = file
    .replace(/\.md$/, '')
    .split('-')
    .map((word) => LETTERS[word] ?? word);
  return [first[0]!.toUpperCase() + first.slice(1), ...rest].join(' ');
};

export function Documents() {
  const { state } = useUi().app;
  const [open, setOpen] = useState<string | null>(null);
  const [text, setText] = useState<string | null>(null);
  const [failed, setFailed] = useState(false);
  const place = useRef('');
  const article = useRef<HTMLElement>(null);
  const show = (file: string, at = ''): void => {
    place.current = at;
    setText(null);
    setFailed(false);
    setOpen(file);
    files.get(file)!().then(setText, () => setFailed(true));
  };
  useEffect(() => {
    const [file = '', at] = (state.document.peek() ?? '').split('#');
    if (files.has(file)) show(file, at);
  }, []);
  useEffect(() => {
    if (text === null || !place.current) return;
    article.current?.querySelector(`[data-place="${CSS.escape(place.current)}"]`)?.scrollIntoView();
  }, [text]);
  if (open === null)
    return (
      <ul class="documents" data-testid="documents">
        {[...files.keys()]
          .filter((file) => !NOT_SHOWN.has(file))
          .map((file) => (
            <li key={file}>
              <button type="button" class="link" onClick={() => show(file)}>
                {titleOf(file)}
              </button>
            </li>
          ))}
      </ul>
    );
  return (
    <article ref={article} class="help-text" data-testid="document">
      <button type="button" class="link" onClick={() => setOpen(null)}>
        {words.back}
      </button>
      {text === null ? (
        <LoadingPart failed={failed} />
      ) : (
        <Markdown text={text} linkOf={(file, at) => (files.has(file) ? () => show(file, at) : null)} />
      )}
    </article>
  );
}
