/** The stage with its transport alone, for a frame in another page: as large as the frame, and the way to all the rest. */
import type { ReadonlySignal } from '@preact/signals';
import type { ComponentType } from 'preact';
import { useMemo } from 'preact/hooks';
import { createUi, UiContext } from '../context.ts';
import { StageOverlay } from '../stage/stageOverlay.tsx';
import { Transport } from '../stage/transport.tsx';
import { text } from '../words.ts';
import { Announcer } from './announcer.tsx';
import { commandsOf } from './commands.ts';
import { Messages } from './messages.tsx';
import { Canvas, useTheme, type ShellProps } from './shell.tsx';
import './embedded.css';

export interface EmbeddedShellProps extends Omit<ShellProps, 'features' | 'onForget'> {
  /** Of the whole page, with what is shown here; absent where there is none. */
  address?: () => string;
  /** Beside the stage, while `shown`. */
  plots: { shown: ReadonlySignal<boolean>; Body: ComponentType | undefined };
}

export function EmbeddedShell({
  app,
  methods,
  formulations,
  onCanvas,
  sceneText,
  sceneError,
  origin,
  address,
  plots: { shown, Body },
}: EmbeddedShellProps) {
  const ui = useMemo(() => createUi(app, methods, formulations, [], commandsOf([]), origin), [app]);
  useTheme(app);
  return (
    <UiContext.Provider value={ui}>
      <div class={`shell embedded ${shown.value ? 'with-plots' : ''}`}>
        <main key="stage" id="stage" class="stage" tabIndex={-1} aria-label={text.view.scene}>
          <Canvas onCanvas={onCanvas} sceneText={sceneText} />
          <StageOverlay sceneError={sceneError} />
          {address && (
            <a
              class="whole-page"
              href={location.pathname}
              target="_blank"
              rel="noopener"
              data-testid="whole-page"
              onClick={(event) => (event.currentTarget.href = address())}
            >
              {text.embedded.whole}
            </a>
          )}
        </main>
        {shown.value && Body ? (
          <section class="embedded-plots" aria-label={text.embedded.plots}>
            <Body />
          </section>
        ) : null}
        <Transport />
      </div>
      <Messages />
      <Announcer />
    </UiContext.Provider>
  );
}
