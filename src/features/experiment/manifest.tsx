import './experiment.css';
import type { Feature } from '../../ui/feature.ts';
import { Experiment } from './experiment.tsx';
import { words } from './words.ts';

export const experiment: Feature = {
  id: 'experiment',
  order: 10,
  document: 'page.md#experiment',
  panel: { title: words.title, Body: Experiment },
};
