import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const tests: Feature = {
  id: 'tests',
  order: 72,
  document: 'control.md#tests-of-a-vehicle',
  tool: {
    title: firstWords.open,
    icon: 'check',
    size: 'wide',
    keep: true,
    Body: later(async () => (await import('./testsTool.tsx')).TestsTool),
  },
};
