import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { text as words } from './words.ts';

export const plots: Feature = {
  id: 'plots',
  order: 40,
  tool: {
    title: words.title,
    icon: 'plots',
    size: 'wide',
    Body: later(async () => (await import('./plotsTool.tsx')).PlotsTool),
  },
};
