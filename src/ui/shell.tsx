/** The page around the scene. It owns no state of the laboratory: everything comes from `app`. */
import { useSignal, useSignalEffect } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { App, CaseInfo } from '../app/types.ts';
import type { AnalysisProps } from './analysis/analysisView.tsx';
import { AnalysisPanel } from './analysisPanel.tsx';
import { Announcer } from './announcer.tsx';
import { createUi, UiContext } from './context.ts';
import type { FormulationChoice, MethodChoice } from './context.ts';
import { Dialog, KeysDialog, StepDialog } from './dialogs.tsx';
import { DropOverlay } from './dropOverlay.tsx';
import { useKeyboard } from './keyboard.ts';
import { later } from './later.tsx';
import { useMedia } from './media.ts';
import { Messages } from './messages.tsx';
import type { MethodsProps } from './methodsView.tsx';
import { LeftPanel, RightPanel, Sheet } from './panels.tsx';
import { StageOverlay } from './stageOverlay.tsx';
import { StatusLine } from './statusLine.tsx';
import { text } from './text.ts';
import { TopBar } from './topBar.tsx';
import { Transport } from './transport.tsx';
import './style.css';

const Methods = later(async () => (await import('./methodsView.tsx')).Methods);

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
  /** The comparison of methods and how its curves are drawn and saved. */
  comparing: MethodsProps;
  /** How loci are drawn and numbers saved. */
  analysing: AnalysisProps;
}

export const PHONE = '(max-width: 760px)';

export function Shell({ app, methods, formulations, onCanvas, sceneText, sceneError, origin, comparing, analysing }: ShellProps) {
  const ui = useMemo(() => createUi(app, methods, formulations, origin), [app]);
  const keysOpen = useSignal(false);
  const methodsOpen = useSignal(false);
  const analysisOpen = useSignal(false);
  const phone = useMedia(PHONE);
  useTheme(app);
  useKeyboard(app, keysOpen);
  return (
    <UiContext.Provider value={ui}>
      <div class="shell">
        <TopBar keysOpen={keysOpen} methodsOpen={methodsOpen} analysisOpen={analysisOpen} />
        {phone ? null : <LeftPanel />}
        <main key="stage" class="stage" aria-label={text.view.scene}>
          <Canvas onCanvas={onCanvas} sceneText={sceneText} />
          <StageOverlay sceneError={sceneError} />
        </main>
        {phone || analysisOpen.value ? null : <RightPanel />}
        {analysisOpen.value && <AnalysisPanel open={analysisOpen} {...analysing} />}
        <Transport />
        {phone ? <Sheet /> : null}
        <StatusLine />
      </div>
      <Messages />
      <StepDialog />
      <KeysDialog open={keysOpen} />
      {methodsOpen.value && (
        <Dialog title={text.methods.title} testId="methods-dialog" wide onClose={() => { methodsOpen.value = false; }}><Methods {...comparing} /></Dialog>
      )}
      <DropOverlay />
      <Announcer />
    </UiContext.Provider>
  );
}

function Canvas({ onCanvas, sceneText }: Pick<ShellProps, 'onCanvas' | 'sceneText'>) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => onCanvas(canvas.current!), []);
  return (
    <>
      <canvas ref={canvas} role="img" aria-label={text.view.scene} aria-describedby="scene-text" data-testid="scene" />
      <p id="scene-text" class="hidden" aria-live="polite" data-testid="scene-text">{sceneText}</p>
    </>
  );
}

function useTheme(app: App): void {
  useSignalEffect(() => {
    const root = document.documentElement;
    root.dataset['theme'] = app.state.theme.value;
    const surface = getComputedStyle(root).getPropertyValue('--surface').trim();
    if (surface) document.querySelector('meta[name=theme-color]')?.setAttribute('content', surface);
  });
}
