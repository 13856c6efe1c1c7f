/** One formula: typeset, its symbols explained when pointed at or walked through by keys, its LaTeX to be copied. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { marksOf, setMarks } from '../../core/model/typeset.ts';
import { equations as words } from './words.ts';
import { inWords, useBook } from './context.ts';
import { setSoon } from './rendering.ts';

export function Formula({ latex, title, label }: { latex: string; title: string; label?: string }) {
  const { typeset, pointed } = useBook();
  const box = useRef<HTMLDivElement>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => setSoon(box.current!, latex, typeset.symbols, () => setFailed(true)), [latex, typeset]);
  const onKeyDown = (event: KeyboardEvent) => {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    const marks = marksOf(latex);
    if (step === 0 || marks.length === 0) return;
    event.preventDefault();
    const at = marks.indexOf(pointed.peek() ?? '');
    pointed.value = marks[at < 0 ? (step > 0 ? 0 : marks.length - 1) : (at + step + marks.length) % marks.length]!;
  };
  return (
    <div class="formula">
      {label && <span class="formula-label">{label}</span>}
      <div class="formula-line">
        <div
          ref={box}
          class="formula-box"
          tabIndex={0}
          role="group"
          aria-label={words.formula(title)}
          data-latex={setMarks(latex, typeset.symbols)}
          onKeyDown={onKeyDown}
        >
          {failed && (
            <span class="error" role="alert">
              {words.failed}
            </span>
          )}
        </div>
        <Copy latex={latex} title={title} />
      </div>
    </div>
  );
}

function Copy({ latex, title }: { latex: string; title: string }) {
  const { typeset, said } = useBook();
  const [done, setDone] = useState(false);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  useEffect(() => () => clearTimeout(timer.current), []);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(setMarks(latex, typeset.symbols));
      said.value = words.copy.done;
      setDone(true);
      clearTimeout(timer.current);
      timer.current = setTimeout(() => setDone(false), 1500);
    } catch {
      said.value = words.copy.failed;
    }
  };
  return (
    <button
      type="button"
      class="quiet copy-latex"
      aria-label={words.copy.label(title)}
      title={words.copy.label(title)}
      onClick={() => void copy()}
    >
      {done ? '✓' : words.copy.short}
    </button>
  );
}

/** A letter in a table, in the same type as in the formulas. @param said in words too, where it stands alone */
export function Letter({ mark, said = false }: { mark: string; said?: boolean }) {
  const book = useBook();
  const { typeset } = book;
  const box = useRef<HTMLSpanElement>(null);
  useEffect(() => setSoon(box.current!, String.raw`\s{${mark}}`, typeset.symbols, () => undefined), [mark, typeset]);
  return (
    <>
      <span ref={box} class="letter" aria-hidden={said} />
      {said && <span class="hidden">{inWords(book, mark)}</span>}
    </>
  );
}
