import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const methods: Feature = {
  id: 'methods',
  order: 70,
  document: 'page.md#methods',
  tool: {
    title: firstWords.open,
    icon: 'methods',
    size: 'widest',
    keep: true,
    Body: later(async () => (await import('./methodsTool.tsx')).MethodsTool),
  },
};
