import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { PinRun } from './pinRun.tsx';
import { firstWords } from './firstWords.ts';

export const compare: Feature = {
  id: 'compare',
  order: 80,
  document: 'page.md#compare',
  tool: {
    title: firstWords.open,
    icon: 'compare',
    size: 'wide',
    keep: true,
    Body: later(async () => (await import('./compareTool.tsx')).CompareTool),
  },
  runStatus: PinRun,
  commands: [
    {
      id: 'pin',
      label: firstWords.keep,
      keys: [{ key: 'b', line: { what: firstWords.pinKey } }],
      perform: ({ pinned }) => void pinned.pin(),
    },
  ],
};
