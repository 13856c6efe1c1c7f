import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const gaits: Feature = {
  id: 'gaits',
  order: 65,
  document: 'gaits.md',
  tool: {
    title: firstWords.open,
    icon: 'gaits',
    size: 'narrow',
    keep: true,
    Body: later(async () => (await import('./gaitsTool.tsx')).GaitsTool),
  },
};
