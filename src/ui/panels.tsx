/** Where the panels stand: at the sides, or on a phone in a sheet with tabs. */
import { useComputed, useSignal, useSignalEffect } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { useUi } from './context.ts';
import { Icon } from './controls.tsx';
import { Experiment } from './experiment.tsx';
import { FilePanel } from './filePanel.tsx';
import { NowPanel } from './nowPanel.tsx';
import { text } from './text.ts';

export function SidePanel({ side, title, startsOpen = true, children }: { side: 'left' | 'right'; title: string; startsOpen?: boolean; children: ComponentChildren }) {
  const [open, setOpen] = useState(startsOpen);
  const label = open ? text.panel.fold(title) : text.panel.unfold(title);
  return (
    <aside class={`panel ${side}${open ? '' : ' folded'}`} aria-label={title}>
      <div class="panel-head">
        {open && <h2>{title}</h2>}
        <button type="button" class="quiet square" aria-expanded={open} aria-label={label} title={label} data-testid={`fold-${side}`} onClick={() => setOpen(!open)}>
          <Icon name={(side === 'left') === open ? 'left' : 'right'} />
        </button>
        {!open && <span class="folded-title" aria-hidden="true">{title}</span>}
      </div>
      {/* hidden, not gone: text that stands in a field survives folding */}
      <div class="panel-body" hidden={!open}>{children}</div>
    </aside>
  );
}

export function LeftPanel() {
  return <SidePanel side="left" title={text.panel.experiment}><Experiment /></SidePanel>;
}

export function RightPanel() {
  const { state } = useUi().app;
  const isFile = useComputed(() => state.motion.value?.source === 'file');
  return (
    <SidePanel side="right" title={text.panel.now} startsOpen={innerWidth >= 1200}>
      <div class="scroll">
        <NowPanel />
        {isFile.value && <section class="file-section" aria-label={text.panel.file}><h3>{text.panel.file}</h3><FilePanel /></section>}
      </div>
    </SidePanel>
  );
}

const tabs = [
  { id: 'experiment', title: text.panel.experiment, Body: Experiment },
  { id: 'now', title: text.panel.now, Body: NowPanel },
  { id: 'file', title: text.panel.file, Body: FilePanel },
] as const;

export function Sheet() {
  const { state } = useUi().app;
  const current = useSignal<string>('experiment');
  // an opened file is what one wants to read about
  useSignalEffect(() => {
    if (state.motion.value?.source === 'file') current.value = 'file';
  });
  const onKeyDown = (event: KeyboardEvent) => {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    const at = tabs.findIndex((tab) => tab.id === current.value);
    const next = tabs[(at + step + tabs.length) % tabs.length]!;
    current.value = next.id;
    document.getElementById(`tab-${next.id}`)?.focus();
  };
  return (
    <section class="sheet" aria-label={text.sheet}>
      <div class="tabs" role="tablist" onKeyDown={onKeyDown}>
        {tabs.map((tab) => (
          <button key={tab.id} type="button" role="tab" id={`tab-${tab.id}`} aria-selected={current.value === tab.id} aria-controls={`sheet-${tab.id}`}
            tabIndex={current.value === tab.id ? 0 : -1} data-testid={`tab-${tab.id}`} onClick={() => { current.value = tab.id; }}>{tab.title}</button>
        ))}
      </div>
      {tabs.map(({ id, Body }) => (
        <div key={id} id={`sheet-${id}`} class="tab-body" role="tabpanel" aria-labelledby={`tab-${id}`} hidden={current.value !== id}><Body /></div>
      ))}
    </section>
  );
}
