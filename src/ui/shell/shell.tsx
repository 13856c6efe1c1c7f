/** The page around the scene. It owns no state of the laboratory: everything comes from `app`. */
import { useSignalEffect } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { App } from '../../app/app.ts';
import type { CaseInfo } from '../../app/state/cases.ts';
import { Announcer } from './announcer.tsx';
import { commandsOf } from './commands.ts';
import { createUi, UiContext, useUi } from '../context.ts';
import type { FormulationChoice, MethodChoice } from '../context.ts';
import type { Feature } from '../feature.ts';
import { later } from '../kit/later.tsx';
import { Slot } from '../slot.tsx';
import { useKeyboard } from './keyboard.ts';
import { useMedia } from '../kit/media.ts';
import { Messages } from './messages.tsx';
import { useOnScreenKeyboard } from './onScreenKeyboard.ts';
import { LeftPanel, Sheet, Tools } from './panels.tsx';
import { SkipLinks } from './skipLinks.tsx';
import { StageOverlay } from '../stage/stageOverlay.tsx';
import { StatusLine } from './statusLine.tsx';
import { text } from '../words.ts';
import { TopBar } from './topBar.tsx';
import { Transport } from '../stage/transport.tsx';

export interface ShellProps {
  app: App;
  methods: readonly MethodChoice[];
  formulations: readonly FormulationChoice[];
  /** Called once, when the canvas is in the page. */
  onCanvas(canvas: HTMLCanvasElement): void;
  /** What the scene shows, in words. */
  sceneText: ReadonlySignal<string>;
  /** Why there is no scene (no WebGL), or null. */
  sceneError: ReadonlySignal<string | null>;
  /** The case the draft came from; without it, the last case whose scenario the draft was. */
  origin?: ReadonlySignal<CaseInfo | null>;
  features: readonly Feature[];
  /** Takes away what this browser stores for the page. */
  onForget?: () => void;
}

const HelpDialog = later(async () => (await import('./helpDialog.tsx')).HelpDialog);

/** A phone, or a tablet held upright; the same words stand in phone.css. */
export const PHONE = '(max-width: 760px), (max-width: 1024px) and (orientation: portrait)';

export function Shell({
  app,
  methods,
  formulations,
  onCanvas,
  sceneText,
  sceneError,
  origin,
  features,
  onForget,
}: ShellProps) {
  const ui = useMemo(() => createUi(app, methods, formulations, features, commandsOf(features), origin), [app]);
  const phone = useMedia(PHONE);
  useTheme(app);
  useKeyboard(ui);
  useOnScreenKeyboard();
  return (
    <UiContext.Provider value={ui}>
      <SkipLinks />
      <div class="shell">
        <TopBar />
        {phone ? null : <LeftPanel />}
        <main key="stage" id="stage" class="stage" tabIndex={-1} aria-label={text.view.scene}>
          <Canvas onCanvas={onCanvas} sceneText={sceneText} />
          <StageOverlay sceneError={sceneError} />
        </main>
        <Slot name="card" />
        {phone ? null : <Tools />}
        <Transport />
        {phone ? <Sheet /> : null}
        <StatusLine />
      </div>
      <Messages />
      <Slot name="dialog" />
      <Help onForget={onForget} />
      <Announcer />
    </UiContext.Provider>
  );
}

function Help({ onForget }: { onForget: ShellProps['onForget'] | undefined }) {
  return useUi().app.state.dialog.value === 'keys' ? <HelpDialog onForget={onForget} /> : null;
}

export function Canvas({ onCanvas, sceneText }: Pick<ShellProps, 'onCanvas' | 'sceneText'>) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => onCanvas(canvas.current!), []);
  return (
    <>
      <canvas ref={canvas} role="img" aria-label={text.view.scene} aria-describedby="scene-text" data-testid="scene" />
      <p id="scene-text" class="hidden" aria-live="polite" data-testid="scene-text">
        {sceneText}
      </p>
    </>
  );
}

export function useTheme(app: App): void {
  useSignalEffect(() => {
    const root = document.documentElement;
    root.dataset['theme'] = app.state.theme.value;
    const surface = getComputedStyle(root).getPropertyValue('--surface').trim();
    if (surface) document.querySelector('meta[name=theme-color]')?.setAttribute('content', surface);
  });
}
