import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

export const lessons: Feature = {
  id: 'lessons',
  order: 92,
  document: 'lessons.md',
  tool: {
    title: firstWords.open,
    icon: 'lessons',
    size: 'narrow',
    keep: true,
    Body: later(async () => (await import('./lessonsTool.tsx')).LessonsTool),
  },
};
