import type { Signal } from '@preact/signals';
import { useUi } from '../context.ts';
import { Icon } from '../kit/controls.tsx';
import { Slot } from '../slot.tsx';
import { text } from '../words.ts';

export function TopBar({ keysOpen }: { keysOpen: Signal<boolean> }) {
  const { state } = useUi().app;
  const theme = state.theme.value;
  return (
    <header class="top">
      <h1 class="wordmark">{text.name}</h1>
      <Slot name="topStart" />
      <span class="spring" />
      <Slot name="topEnd" />
      <button
        type="button"
        class="quiet square"
        data-testid="theme"
        aria-label={text.top.theme(theme)}
        title={text.top.theme(theme)}
        onClick={() => {
          state.theme.value = theme === 'dark' ? 'light' : 'dark';
        }}
      >
        <Icon name={theme === 'dark' ? 'light' : 'dark'} />
      </button>
      <button
        type="button"
        class="quiet square help"
        data-testid="keys"
        aria-label={text.top.keys}
        title={`${text.top.keys} (?)`}
        onClick={() => {
          keysOpen.value = true;
        }}
      >
        ?
      </button>
    </header>
  );
}
