/** The built-in cases as cards: picture, what to look at, where it comes from. One click runs one. */
import { useComputed, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { CaseInfo } from '../app/types.ts';
import { text } from '../text/gallery.ts';
import { replaceDraft, useUi } from './context.ts';
import './style/gallery.css';

export function Gallery({ onClose }: { onClose(): void }) {
  const ui = useUi();
  const { app } = ui;
  const word = useSignal('');
  const grid = useRef<HTMLDivElement>(null);
  const search = useRef<HTMLInputElement>(null);
  // it comes into a dialog that is open already, where the browser sees to no focus any more
  useEffect(() => search.current?.focus(), []);
  const titleOf = (c: CaseInfo): string => app.systemOf(c.scenario.system)?.meta.title ?? c.scenario.system;
  const found = useComputed(() => {
    const words = word.value.toLowerCase().split(/\s+/).filter(Boolean);
    return app.cases.filter((c) => {
      const about = [c.id, c.title, c.summary, c.source, c.figure, c.chapter, titleOf(c), c.scenario.control?.type].join(' ').toLowerCase();
      return words.every((w) => about.includes(w));
    });
  });
  const groups = [...new Set(found.value.map(titleOf))];
  const choose = (id: string) => {
    onClose();
    replaceDraft(ui, () => app.actions.loadCase(id));
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const cards = [...(grid.current?.querySelectorAll<HTMLButtonElement>('.card') ?? [])];
    const at = cards.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === 'Enter' && at < 0) return cards[0]?.click();
    const row = cards.filter((card) => card.offsetTop === cards[0]?.offsetTop).length;
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: at < 0 ? 1 : row, ArrowUp: -row }[event.key];
    if (step === undefined || (at < 0 && event.key !== 'ArrowDown')) return;
    event.preventDefault();
    cards[Math.min(Math.max(at + step, 0), cards.length - 1)]?.focus();
  };
  return (
    <div class="gallery" onKeyDown={onKeyDown}>
      <div class="gallery-bar">
        <input ref={search} type="search" class="gallery-search" aria-label={text.search} placeholder={text.placeholder} data-testid="gallery-search" value={word.value} onInput={(e) => { word.value = e.currentTarget.value; }} />
        <span class="hint" role="status">{found.value.length > 0 ? text.count(found.value.length) : text.none(word.value)}</span>
      </div>
      <div ref={grid}>
        {groups.map((group) => (
          <section key={group} aria-label={group}>
            <h3>{group}</h3>
            <div class="cards">
              {found.value.filter((c) => titleOf(c) === group).map((c) => <Card key={c.id} of={c} current={c.id === ui.origin.value?.id} theme={app.state.theme.value} onChoose={() => choose(c.id)} />)}
            </div>
          </section>
        ))}
      </div>
    </div>
  );
}

function Card({ of: c, current, theme, onChoose }: { of: CaseInfo; current: boolean; theme: string; onChoose(): void }) {
  const from = [c.figure, c.chapter && text.section(c.chapter)].filter(Boolean).join(', ') || c.source;
  const kind = c.scenario.control?.type;
  return (
    <button type="button" class="card" aria-current={current ? 'true' : undefined} data-testid={`case-${c.id}`} onClick={onChoose}>
      <img src={`cases/${c.id}-${theme}.webp`} width="320" height="200" alt="" loading="lazy" />
      <span class="card-title">{c.title}{kind && <span class="badge">{text[kind]}</span>}</span>
      <span class="card-look">{c.summary}</span>
      {(from || current) && <span class="card-from">{[current ? text.now : '', from].filter(Boolean).join(' · ')}</span>}
    </button>
  );
}
