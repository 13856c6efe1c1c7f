import { useUi } from '../context.ts';
import { Icon } from '../kit/controls.tsx';
import { Slot } from '../slot.tsx';
import { text } from '../words.ts';

export function TopBar() {
  const { state, actions } = useUi().app;
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
        onClick={() => actions.set('theme', theme === 'dark' ? 'light' : 'dark')}
      >
        <Icon name={theme === 'dark' ? 'light' : 'dark'} />
      </button>
      <button
        type="button"
        class="quiet square help"
        data-testid="keys"
        aria-label={text.top.keys}
        title={`${text.top.keys} (?)`}
        onClick={() => actions.openDialog('keys')}
      >
        ?
      </button>
    </header>
  );
}
