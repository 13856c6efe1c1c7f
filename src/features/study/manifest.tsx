import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const study: Feature = {
  id: 'study',
  order: 82,
  document: 'sweeps.md',
  tool: {
    title: firstWords.title,
    icon: 'study',
    size: 'widest',
    keep: true,
    Body: later(async () => (await import('./studyTool.tsx')).StudyTool),
  },
};
