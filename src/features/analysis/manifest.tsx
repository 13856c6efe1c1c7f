import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { ModeActions } from './modeActions.tsx';
import { firstWords } from './firstWords.ts';

export const analysis: Feature = {
  id: 'analysis',
  order: 60,
  tool: {
    title: firstWords.open,
    icon: 'analysis',
    size: 'wide',
    Body: later(async () => (await import('./analysisTool.tsx')).AnalysisTool),
  },
  caption: ModeActions,
};
