/** A formula of a document, set through the DOM as the page's security policy asks; its LaTeX where it cannot be set. */
import { useEffect, useRef } from 'preact/hooks';

import type katexModule from 'katex';

export type Katex = typeof katexModule;

/** KaTeX and its style sheet, with whatever first shows a formula. @throws when the files cannot be had */
export const loadKatex = async (): Promise<Katex> =>
  (await Promise.all([import('katex'), import('katex/dist/katex.min.css')]))[0].default;

export function Math({ latex, display = false }: { latex: string; display?: boolean }) {
  const box = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    let gone = false;
    loadKatex()
      .then((katex) => {
        if (gone || !box.current) return;
        katex.render(latex, box.current, {
          output: 'htmlAndMathml',
          strict: false,
          throwOnError: false,
          displayMode: display,
        });
      })
      // Where it cannot be had, or cannot be set in this document, the LaTeX stays.
      .catch(() => {});
    return () => {
      gone = true;
    };
  }, [latex]);
  return (
    <span ref={box} class={display ? 'math display' : 'math'} {...(display ? { tabIndex: 0 } : {})}>
      {latex}
    </span>
  );
}
