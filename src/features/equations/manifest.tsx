import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const equations: Feature = {
  id: 'equations',
  order: 50,
  document: 'page.md#equations',
  tool: {
    title: firstWords.open,
    icon: 'equations',
    size: 'wide',
    Body: later(async () => (await import('./equationsTool.tsx')).EquationsTool),
  },
};
