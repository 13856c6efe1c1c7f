import './file.css';
import type { Feature } from '../../ui/feature.ts';
import { DropOverlay } from './dropOverlay.tsx';
import { OpenButtons } from './openButtons.tsx';

export const file: Feature = {
  id: 'file',
  order: 90,
  topEnd: OpenButtons,
  dialog: DropOverlay,
};
