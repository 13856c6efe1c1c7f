/** A tour of five steps: a card beside what it speaks of, with a mark around that. The page stays usable; Escape ends it at any step. */
import { useEffect, useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { text } from './words.ts';
import { placeBeside, type Rect } from './place.ts';
import { steps } from './steps.ts';

/** Around what is spoken of (CSS pixels). */
const MARGIN = 3;

export function Tour({ onEnd }: { onEnd(): void }) {
  const [at, setAt] = useState(0);
  const card = useRef<HTMLDivElement>(null);
  const heading = useRef<HTMLHeadingElement>(null);
  const [titleId, bodyId] = [useId(), useId()];
  const { target, place } = useBeside(at, card);
  useEffect(() => {
    const before = document.activeElement as HTMLElement | null;
    const onKeyDown = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || document.querySelector('dialog[open]')) return;
      event.preventDefault();
      onEnd();
    };
    // Before the page's own keys and panels see it.
    window.addEventListener('keydown', onKeyDown, true);
    return () => {
      window.removeEventListener('keydown', onKeyDown, true);
      (before?.isConnected && before !== document.body ? before : document.getElementById('stage'))?.focus();
    };
  }, []);
  // After what had the focus has been remembered.
  useEffect(() => heading.current?.focus({ preventScroll: true }), [at]);
  const words = text.steps[steps[at]!.id];
  const last = at === steps.length - 1;
  return (
    <>
      {target && <div class="tour-mark" aria-hidden="true" style={around(target)} />}
      <div
        ref={card}
        class="tour"
        role="dialog"
        aria-labelledby={titleId}
        aria-describedby={bodyId}
        data-testid="tour"
        style={place && { left: px(place.left), top: px(place.top) }}
      >
        <p class="tour-count">{text.of(at + 1, steps.length)}</p>
        <h2 id={titleId} ref={heading} tabIndex={-1}>
          {words.title}
        </h2>
        <p id={bodyId}>{words.body}</p>
        <div class="tour-buttons">
          <button type="button" class="quiet" data-testid="tour-skip" onClick={onEnd}>
            {text.skip}
          </button>
          <span class="spring" />
          {at > 0 && (
            <button type="button" data-testid="tour-back" onClick={() => setAt(at - 1)}>
              {text.back}
            </button>
          )}
          <button
            type="button"
            class="primary"
            data-testid="tour-next"
            onClick={() => (last ? onEnd() : setAt(at + 1))}
          >
            {last ? text.finish : text.next}
          </button>
        </div>
      </div>
    </>
  );
}

const px = (length: number): string => `${length}px`;

const around = ({ left, top, right, bottom }: Rect) => ({
  left: px(left - MARGIN),
  top: px(top - MARGIN),
  width: px(right - left + 2 * MARGIN),
  height: px(bottom - top + 2 * MARGIN),
});

/** Follows the target wherever scrolling and resizing take it. */
function useBeside(at: number, card: { current: HTMLDivElement | null }) {
  const [target, setTarget] = useState<Rect | null>(null);
  const [place, setPlace] = useState<{ left: number; top: number } | undefined>(undefined);
  useLayoutEffect(() => {
    const element = steps[at]!.target();
    const measure = () => {
      const { offsetWidth: width, offsetHeight: height } = card.current!;
      const page = { width: innerWidth, height: innerHeight };
      const box = element?.getBoundingClientRect();
      const seen =
        box && box.width > 0 && box.bottom > 0 && box.top < page.height
          ? { left: box.left, top: box.top, right: box.right, bottom: box.bottom }
          : null;
      setTarget(seen);
      setPlace(
        seen
          ? placeBeside(seen, { width, height }, page)
          : { left: (page.width - width) / 2, top: (page.height - height) / 2 },
      );
    };
    measure();
    // What the step opened takes its place in the next picture.
    const later = requestAnimationFrame(measure);
    addEventListener('resize', measure);
    addEventListener('scroll', measure, true);
    return () => {
      cancelAnimationFrame(later);
      removeEventListener('resize', measure);
      removeEventListener('scroll', measure, true);
    };
  }, [at]);
  return { target, place };
}
