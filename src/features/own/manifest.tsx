import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const own: Feature = {
  id: 'own',
  order: 55,
  document: 'own-systems.md',
  tool: {
    title: firstWords.open,
    icon: 'own',
    size: 'widest',
    keep: true,
    Body: later(async () => (await import('./ownTool.tsx')).OwnTool),
  },
};
