import { useCommand, useUi } from '../context.ts';
import { Icon } from '../kit/controls.tsx';
import { Slot } from '../slot.tsx';
import { text } from '../words.ts';

export function TopBar() {
  const theme = useUi().app.state.theme.value;
  const [changeTheme, showKeys] = [useCommand('theme'), useCommand('keys')];
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
        aria-label={changeTheme.label}
        title={changeTheme.title}
        onClick={changeTheme.perform}
      >
        <Icon name={theme === 'dark' ? 'light' : 'dark'} />
      </button>
      <button
        type="button"
        class="quiet square help"
        data-testid="keys"
        aria-label={showKeys.label}
        title={showKeys.title}
        onClick={showKeys.perform}
      >
        ?
      </button>
    </header>
  );
}
