/** What stands in the stage's corners: the frame around the inset, the length of a force. */
import { useEffect, useRef } from 'preact/hooks';
import { legendBar } from '../../app/state/forceScale.ts';
import { useUi } from '../context.ts';
import { formatShort, THIN } from '../kit/format.ts';
import { text } from '../words.ts';

/** The frame tells the scene where to draw; without it nothing is drawn. */
export function Inset({ title }: { title: string }) {
  const { actions } = useUi().app;
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const own = frame.current!;
    const stage = own.closest('.stage')!;
    const measure = () => {
      const [a, b] = [own.getBoundingClientRect(), stage.getBoundingClientRect()];
      actions.setInsetBox({
        left: a.left - b.left,
        top: a.top - b.top,
        right: a.right - b.left,
        bottom: a.bottom - b.top,
      });
    };
    const observer = new ResizeObserver(measure);
    observer.observe(own);
    observer.observe(stage);
    measure();
    return () => {
      observer.disconnect();
      actions.setInsetBox(null);
    };
  }, []);
  return (
    <div class="inset" ref={frame} data-testid="inset">
      <span class="inset-title">{title}</span>
    </div>
  );
}

/** A bar as long as the arrow of a round force is at the distance of what is looked at. */
export function ForceLegend() {
  const { state } = useUi().app;
  const bar = legendBar(state.metresPerNewton.value, state.pixelsPerMetre.value);
  if (!bar) return null;
  const force = `${formatShort(bar.newtons, 3)}${THIN}N`;
  return (
    <p class="force-legend" data-testid="force-legend" aria-label={text.viewMenu.legend(force)}>
      <svg width={Math.ceil(bar.pixels) + 2} height="12" aria-hidden="true">
        <path d={`M1 2v8M1 6h${bar.pixels.toFixed(1)}m-7 -3.5l7 3.5l-7 3.5`} />
      </svg>
      <span aria-hidden="true">{force}</span>
    </p>
  );
}
