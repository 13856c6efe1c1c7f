import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const plots: Feature = {
  id: 'plots',
  order: 40,
  document: 'page.md#plots',
  tool: {
    title: firstWords.open,
    icon: 'plots',
    size: 'wide',
    Body: later(async () => (await import('./plotsTool.tsx')).PlotsTool),
  },
};
