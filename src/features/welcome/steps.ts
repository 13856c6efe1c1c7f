/** The five stops of the tour: what each speaks of, and what has to be open for it to be seen. */
import type { text } from './words.ts';

export interface Step {
  id: keyof typeof text.steps;
  /** Null when the page does not show it. */
  target(): HTMLElement | null;
}

const byId = (testId: string) => document.querySelector<HTMLElement>(`[data-testid="${testId}"]`);

/** Unfolds the panel, or turns the phone's sheet to it. */
function openPanel(): void {
  const fold = byId('fold-left');
  if (fold?.getAttribute('aria-expanded') === 'false') fold.click();
  const tab = byId('tab-experiment');
  if (tab?.getAttribute('aria-selected') === 'false') tab.click();
}

export const steps: readonly Step[] = [
  { id: 'cases', target: () => byId('case-menu') },
  {
    id: 'run',
    target() {
      openPanel();
      return document.querySelector<HTMLElement>('.run-bar');
    },
  },
  { id: 'play', target: () => document.querySelector<HTMLElement>('.transport') },
  {
    id: 'tools',
    target: () => document.querySelector<HTMLElement>('.rail') ?? document.querySelector<HTMLElement>('.tabs'),
  },
  {
    id: 'control',
    target() {
      openPanel();
      const section = byId('control')?.closest('details') ?? null;
      if (section) section.open = true;
      const head = section?.querySelector('summary') ?? null;
      head?.scrollIntoView({ block: 'center' });
      return head;
    },
  },
];
