/** Where the panels stand: what is run at the left, the open tool and the rail of tools at the right; on a phone all in a sheet with tabs. */
import { useSignal, useSignalEffect } from '@preact/signals';
import type { ComponentType } from 'preact';
import { useRef, useState } from 'preact/hooks';
import { text } from '../words.ts';
import { useUi } from '../context.ts';
import { Icon } from '../kit/controls.tsx';
import { HelpLink } from '../kit/helpLink.tsx';
import type { Ui } from '../context.ts';

/** The one that stands at the left. */
const usePanel = () =>
  useUi().features.flatMap(({ id, document, panel }) => (panel ? [{ id, document, ...panel }] : []))[0];

export function LeftPanel() {
  const [open, setOpen] = useState(true);
  const panel = usePanel();
  const { state } = useUi().app;
  useSignalEffect(() => {
    if (state.wantedField.value) setOpen(true);
  });
  if (!panel) return null;
  const { title, document, Body } = panel;
  const label = open ? text.panel.fold(title) : text.panel.unfold(title);
  return (
    <aside class={`panel left${open ? '' : ' folded'}`} aria-label={title}>
      <div class="panel-head">
        {open && (
          <>
            <h2>{title}</h2>
            <HelpLink document={document} title={title} />
          </>
        )}
        <button
          type="button"
          class="quiet square"
          aria-expanded={open}
          aria-label={label}
          title={label}
          data-testid="fold-left"
          onClick={() => setOpen(!open)}
        >
          <Icon name={open ? 'left' : 'right'} />
        </button>
        {!open && (
          <span class="folded-title" aria-hidden="true">
            {title}
          </span>
        )}
      </div>
      {/* hidden, not gone: text that stands in a field survives folding */}
      <div class="panel-body" hidden={!open}>
        <Body />
      </div>
    </aside>
  );
}

/** Those that are shown, and those that keep what they were doing. */
function useOpened(tools: Ui['tools'], open: string | null): Ui['tools'] {
  const opened = useRef(new Set<string>());
  if (open !== null) opened.current.add(open);
  return tools.filter(({ id, keep }) => id === open || (keep && opened.current.has(id)));
}

export function Tools() {
  const {
    app: { state, actions },
    tools,
  } = useUi();
  const open = state.tool.value;
  const current = tools.find(({ id }) => id === open);
  const fold = () => {
    document.querySelector<HTMLElement>(`[data-testid="tool-${open}"]`)?.focus();
    actions.set('tool', null);
  };
  return (
    <div class="right">
      {useOpened(tools, open).map(({ id, title, document, size, Body }) => (
        <aside
          key={id}
          id={`tool-panel-${id}`}
          class={`panel tool ${size}`}
          aria-label={title}
          hidden={id !== open}
          data-testid={`tool-panel-${id}`}
          onKeyDown={(event) => {
            if (event.key === 'Escape' && !event.defaultPrevented) fold();
          }}
        >
          <div class="panel-head">
            <h2>{title}</h2>
            <HelpLink document={document} title={title} />
            <button
              type="button"
              class="quiet square"
              aria-label={text.panel.fold(title)}
              title={text.panel.fold(title)}
              data-testid="fold-right"
              onClick={fold}
            >
              <Icon name="right" />
            </button>
          </div>
          <Body />
        </aside>
      ))}
      <nav class="rail" aria-label={text.panel.tools}>
        {tools.map(({ id, title, icon }) => (
          <button
            key={id}
            type="button"
            class="rail-button"
            aria-expanded={current?.id === id}
            aria-controls={`tool-panel-${id}`}
            data-testid={`tool-${id}`}
            onClick={() => actions.set('tool', open === id ? null : id)}
          >
            <Icon name={icon} />
            <span>{title}</span>
          </button>
        ))}
      </nav>
    </div>
  );
}

/** A tab that comes forward by itself, as a file's does, may stand beyond the strip's end. */
function bringIntoStrip(tab: HTMLElement): void {
  const strip = tab.parentElement!;
  const [own, all] = [tab.getBoundingClientRect(), strip.getBoundingClientRect()];
  if (own.left < all.left) strip.scrollLeft -= all.left - own.left;
  else if (own.right > all.right) strip.scrollLeft += own.right - all.right;
}

export function Sheet() {
  const { app, tools } = useUi();
  const { state, actions } = app;
  const panel = usePanel();
  const current = useSignal(panel?.id ?? tools[0]?.id ?? '');
  const opened = useOpened(tools, current.value);
  // what asks for a tool asks for its tab
  useSignalEffect(() => {
    if (state.tool.value !== null) current.value = state.tool.value;
  });
  useSignalEffect(() => {
    for (const { id, wanted } of tools) if (wanted?.(app)) current.value = id;
  });
  useSignalEffect(() => {
    if (state.wantedField.value && panel) current.value = panel.id;
  });
  useSignalEffect(() => {
    const tab = document.getElementById(`tab-${current.value}`);
    if (tab) bringIntoStrip(tab);
  });
  const bodies: { id: string; title: string; document: string | undefined; Body: ComponentType; there: boolean }[] = [
    ...(panel ? [{ ...panel, there: true }] : []),
    ...tools.map((tool) => ({ ...tool, there: opened.includes(tool) })),
  ];
  const show = (id: string) => {
    current.value = id;
    actions.set('tool', tools.some((tool) => tool.id === id) ? id : null);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    const at = bodies.findIndex(({ id }) => id === current.value);
    const next = bodies[(at + step + bodies.length) % bodies.length]!;
    show(next.id);
    document.getElementById(`tab-${next.id}`)?.focus();
  };
  const shown = bodies.find(({ id }) => id === current.value);
  return (
    <section class="sheet" aria-label={text.sheet}>
      <div class="tab-strip">
        <div class="tabs" role="tablist" onKeyDown={onKeyDown}>
          {bodies.map(({ id, title }) => (
            <button
              key={id}
              type="button"
              role="tab"
              id={`tab-${id}`}
              class={id === panel?.id ? 'first' : undefined}
              aria-selected={current.value === id}
              aria-controls={`sheet-${id}`}
              tabIndex={current.value === id ? 0 : -1}
              data-testid={`tab-${id}`}
              onClick={() => show(id)}
            >
              {title}
            </button>
          ))}
        </div>
        {shown && <HelpLink document={shown.document} title={shown.title} />}
      </div>
      {bodies.map(({ id, title, Body, there }) => (
        <div
          key={id}
          id={`sheet-${id}`}
          class={id === panel?.id ? 'tab-body first' : 'tab-body'}
          role="tabpanel"
          aria-labelledby={`tab-${id}`}
          hidden={current.value !== id}
        >
          <h2 class="hidden">{title}</h2>
          {there && <Body />}
        </div>
      ))}
    </section>
  );
}
