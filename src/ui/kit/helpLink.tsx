/** `?` at the head of a view: its page on the site that this page is part of, or its document in the help. */
import { useUi } from '../context.ts';
import { words } from './words.ts';

/** Where the site lies as seen from the page; empty where the page stands alone. */
declare const __RIPSTIK_SITE__: string;

/** @param document its file under docs/, with a place in it */
export function HelpLink({ document, title }: { document: string | undefined; title: string }) {
  const { actions } = useUi().app;
  if (document === undefined) return null;
  const shared = {
    class: 'quiet square help',
    'aria-label': words.helpOn(title),
    title: words.helpOn(title),
    'data-testid': 'view-help',
  };
  if (__RIPSTIK_SITE__)
    return (
      <a
        {...shared}
        href={`${__RIPSTIK_SITE__}docs/${document.replace('.md', '.html')}`}
        target="_blank"
        rel="noopener"
      >
        ?
      </a>
    );
  return (
    <button {...shared} type="button" onClick={() => actions.openDocument(document)}>
      ?
    </button>
  );
}
