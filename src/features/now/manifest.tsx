import './now.css';
import type { Feature } from '../../ui/feature.ts';
import { NowTool } from './nowPanel.tsx';
import { words } from './words.ts';

/** The one tool that is part of the first view; the code of the others is loaded when they are opened. */
export const now: Feature = {
  id: 'now',
  order: 30,
  document: 'page.md#now',
  tool: { title: words.title, icon: 'now', size: 'narrow', Body: NowTool },
};
