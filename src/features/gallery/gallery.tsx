/** The built-in cases as cards: picture, what to look at, where it comes from. One click runs one. */
import { useComputed, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { CaseInfo } from '../../app/state/cases.ts';
import { text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { matches, sectionsOf, type Family } from './gallerySections.ts';
import './gallery.css';

const STILL = '(prefers-reduced-motion: reduce)';

export function Gallery({ onClose }: { onClose(): void }) {
  const ui = useUi();
  const { app } = ui;
  const word = useSignal('');
  const grid = useRef<HTMLDivElement>(null);
  const search = useRef<HTMLInputElement>(null);
  // The dialog stood empty until this part was loaded.
  useEffect(() => search.current?.focus(), []);
  const titleOf = (c: CaseInfo): string => app.systemOf(c.scenario.system)?.meta.title ?? c.scenario.system;
  const found = useComputed(() => app.cases.filter((c) => matches(c, word.value.trim(), titleOf(c))));
  const choose = (id: string) => {
    onClose();
    app.actions.loadCase(id);
  };
  const sections = sectionsOf(found.value);
  const firstOfReport = sections.find(({ families }) => families.some((family) => family.some((c) => c.chapter)))?.id;
  return (
    <div
      class="gallery"
      onKeyDown={(event) =>
        moveOverCards(event, [...(grid.current?.querySelectorAll<HTMLButtonElement>('.card, .card-choice') ?? [])])
      }
    >
      <div class="gallery-bar">
        <input
          ref={search}
          type="search"
          class="gallery-search"
          aria-label={text.search}
          placeholder={text.placeholder}
          data-testid="gallery-search"
          value={word.value}
          onInput={(e) => {
            word.value = e.currentTarget.value;
          }}
        />
        <span class="hint" role="status">
          {found.value.length > 0 ? text.count(found.value.length) : text.none(word.value)}
        </span>
        <span class="hint gallery-keys">{text.keys}</span>
      </div>
      <div ref={grid}>
        {sections.map(({ id, families }) => (
          <section key={id} aria-label={text.sections[id]} data-testid={`gallery-${id}`}>
            <h3>{text.sections[id]}</h3>
            {id === firstOfReport && <p class="hint">{text.report}</p>}
            <div class="cards">
              {families.map((family) => (
                <Card
                  key={family[0].id}
                  family={family}
                  system={titleOf(family[0])}
                  current={ui.origin.value?.id}
                  theme={app.state.theme.value}
                  onChoose={choose}
                />
              ))}
            </div>
          </section>
        ))}
      </div>
    </div>
  );
}

/** Arrows go to the next card that way, Home and End to the first and last; Enter in the search takes the first that is found. */
function moveOverCards(event: KeyboardEvent, cards: readonly HTMLButtonElement[]): void {
  const at = cards.indexOf(document.activeElement as HTMLButtonElement);
  if (at < 0 && event.key === 'Enter') cards[0]?.click();
  if (at < 0 && event.key !== 'ArrowDown') return;
  const goal = at < 0 ? cards[0] : nextCard(cards, at, event.key);
  if (!goal) return;
  event.preventDefault();
  goal.focus();
}

function nextCard(cards: readonly HTMLButtonElement[], at: number, key: string): HTMLButtonElement | undefined {
  const step = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: cards.length - 1 }[key];
  if (step !== undefined) return cards[Math.min(Math.max(step, 0), cards.length - 1)];
  const way = { ArrowDown: 1, ArrowUp: -1 }[key];
  if (way === undefined) return undefined;
  // Rows of different sections have different lengths: the nearest card of the next row.
  const here = cards[at]!.getBoundingClientRect();
  const beyond = cards
    .filter((card) => card.classList.contains('card'))
    .map((card) => ({ card, box: card.getBoundingClientRect() }))
    .filter(({ box }) => way * (box.top - here.top) > 1);
  const row = Math.min(...beyond.map(({ box }) => way * box.top));
  const inRow = beyond.filter(({ box }) => way * box.top < row + 1);
  return (
    inRow.sort((a, b) => Math.abs(a.box.left - here.left) - Math.abs(b.box.left - here.left))[0]?.card ?? cards[at]
  );
}

/** What happens in a case, over its picture as soon as it is there: a strip of frames (`npm run pictures -- cases`). */
function Loop({ name }: { name: string }) {
  const here = useSignal(false);
  return (
    <img
      class="card-loop"
      hidden={!here.value}
      src={`cases/${name}-loop.webp`}
      alt=""
      data-testid="card-loop"
      onLoad={() => (here.value = true)}
    />
  );
}

/** A case; of several that differ in one thing the first, or what a choice under it is pointed at. */
function Card({
  family,
  system,
  current,
  theme,
  onChoose,
}: {
  family: Family;
  system: string;
  current: string | undefined;
  theme: string;
  onChoose(id: string): void;
}) {
  const pointed = useSignal<CaseInfo | null>(null);
  const lively = useSignal(false);
  const enliven = (now: boolean) => () => void (lively.value = now && !matchMedia(STILL).matches);
  const first = family[0];
  const c = pointed.value ?? first;
  const from = [c.figure, c.chapter && text.section(c.chapter)].filter(Boolean).join(', ') || c.source;
  const kind = c.scenario.control?.type;
  const here = family.some(({ id }) => id === current);
  const point = (one: CaseInfo | null) => () => void (pointed.value = one);
  return (
    <div
      class="card-frame"
      onMouseEnter={enliven(true)}
      onMouseLeave={enliven(false)}
      onFocusIn={enliven(true)}
      onFocusOut={enliven(false)}
    >
      <button
        type="button"
        class="card"
        aria-current={here ? 'true' : undefined}
        data-testid={`case-${first.id}`}
        onClick={() => onChoose(first.id)}
      >
        <span class="card-picture">
          <img src={`cases/${c.id}-${theme}.webp`} width="360" height="225" alt="" loading="lazy" decoding="async" />
          {lively.value && <Loop key={c.id} name={`${c.id}-${theme}`} />}
        </span>
        <span class="card-title">{c.title}</span>
        <span class="badges">
          <span class="badge">{system}</span>
          {kind && <span class="badge strong">{text[kind]}</span>}
        </span>
        <span class="card-look">{c.summary}</span>
        {(from || here) && <span class="card-from">{[here ? text.now : '', from].filter(Boolean).join(' · ')}</span>}
      </button>
      {family.length > 1 && (
        <div class="card-choices" role="group" aria-label={text.choices(first.title)} onMouseLeave={point(null)}>
          {family.map((one) => (
            <button
              key={one.id}
              type="button"
              class="card-choice"
              title={one.title}
              aria-current={one.id === current ? 'true' : undefined}
              data-testid={one === first ? `choice-${one.id}` : `case-${one.id}`}
              onMouseEnter={point(one)}
              onFocus={point(one)}
              onBlur={point(null)}
              onClick={() => onChoose(one.id)}
            >
              {one.among!.value}
            </button>
          ))}
        </div>
      )}
    </div>
  );
}
