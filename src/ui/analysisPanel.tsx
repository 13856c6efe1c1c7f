/** The place of the analysis beside the scene. What is in it is loaded when it is first opened. */
import type { Signal } from '@preact/signals';
import type { ComponentType } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { AnalysisProps } from './analysis/analysisView.tsx';
import { Icon } from './controls.tsx';
import { text } from './text.ts';

type View = ComponentType<AnalysisProps>;

export function AnalysisPanel({ open, ...props }: AnalysisProps & { open: Signal<boolean> }) {
  const [View, setView] = useState<View | null>(null);
  const [failed, setFailed] = useState(false);
  const heading = useRef<HTMLHeadingElement>(null);
  useEffect(() => {
    heading.current?.focus();
    import('./analysis/analysisView.tsx').then((module) => setView(() => module.AnalysisView), () => setFailed(true));
  }, []);
  const close = () => {
    open.value = false;
    document.querySelector<HTMLElement>('[data-testid=analysis-open]')?.focus();
  };
  return (
    <aside class="panel analysis-panel" aria-labelledby="analysis-title" data-testid="analysis-panel"
      onKeyDown={(event) => { if (event.key === 'Escape' && !event.defaultPrevented) close(); }}>
      <div class="panel-head">
        <h2 id="analysis-title" ref={heading} tabIndex={-1}>{text.analysis.title}</h2>
        <button type="button" class="quiet square" aria-label={text.close} title={text.close} data-testid="analysis-close" onClick={close}><Icon name="close" /></button>
      </div>
      {View ? <View {...props} /> : <p class="hint pad" role={failed ? 'alert' : 'status'}>{failed ? text.analysis.notLoaded : text.analysis.loading}</p>}
    </aside>
  );
}
