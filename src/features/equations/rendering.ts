/** KaTeX and its style sheet, loaded once; formulas are set a few at a time, so that the page stays free in between. */
import { loadKatex as load, type Katex } from '../../ui/kit/math.tsx';
import { setMarks, type Typeset } from '../../core/model/typeset.ts';

/** Setting goes on for this long (ms) before the page gets its turn. */
const SLICE = 8;

let katex: Katex | null = null;
const waiting: (() => void)[] = [];
let busy = false;

/** @throws when the files cannot be had */
export async function loadKatex(): Promise<void> {
  katex = await load();
}

/** LaTeX as KaTeX takes it: every symbol carries its name. */
export function withNames(latex: string, symbols: Typeset['symbols']): string {
  return setMarks(latex, symbols, (name, letter) => String.raw`\htmlData{symbol=${name}}{${letter}}`);
}

/** `\htmlData` alone is trusted: the formulas are the program's own. */
export const OPTIONS = {
  output: 'htmlAndMathml',
  strict: false,
  throwOnError: true,
  trust: ({ command }: { command: string }) => command === '\\htmlData',
} as const;

/** Sets a formula into an element through the DOM, as the page's security policy asks, when its turn comes. */
export function setSoon(
  element: HTMLElement,
  latex: string,
  symbols: Typeset['symbols'],
  failed: () => void,
): () => void {
  const task = (): void => {
    try {
      katex!.render(withNames(latex, symbols), element, { ...OPTIONS, displayMode: false });
    } catch {
      failed();
    }
  };
  waiting.push(task);
  if (!busy) {
    busy = true;
    setTimeout(work);
  }
  return () => {
    const at = waiting.indexOf(task);
    if (at >= 0) waiting.splice(at, 1);
  };
}

function work(): void {
  const until = performance.now() + SLICE;
  while (waiting.length > 0 && performance.now() < until) waiting.shift()!();
  busy = waiting.length > 0;
  if (busy) setTimeout(work);
}
