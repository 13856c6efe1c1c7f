import { useUi } from '../../ui/context.ts';
import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

const ModeActions = later(async () => (await import('./modeActions.tsx')).ModeActions);

export const analysis: Feature = {
  id: 'analysis',
  order: 60,
  document: 'control.md',
  tool: {
    title: firstWords.open,
    icon: 'analysis',
    size: 'wide',
    Body: later(async () => (await import('./analysisTool.tsx')).AnalysisTool),
  },
  caption: () => (useUi().app.state.motion.value?.source === 'mode' ? <ModeActions /> : null),
};
