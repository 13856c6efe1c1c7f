import { equations as equationWords } from './equations/words.ts';
import { text } from '../ui/words.ts';
import { text as plots } from './plots/words.ts';
import { later } from '../ui/kit/later.tsx';
import { NowTool } from './now/nowPanel.tsx';
import type { Tool } from '../ui/tool.ts';

/** The tools beside the scene, in the order of the rail. Only the first is part of the first view; the others are loaded when opened. */
export const tools: readonly Tool[] = [
  { id: 'now', title: text.panel.now, icon: 'now', size: 'narrow', Body: NowTool },
  {
    id: 'plots',
    title: plots.title,
    icon: 'plots',
    size: 'wide',
    Body: later(async () => (await import('./plots/plotsTool.tsx')).PlotsTool),
  },
  {
    id: 'equations',
    title: equationWords.open,
    icon: 'equations',
    size: 'wide',
    Body: later(async () => (await import('./equations/equationsTool.tsx')).EquationsTool),
  },
  {
    id: 'analysis',
    title: text.analysis.open,
    icon: 'analysis',
    size: 'wide',
    Body: later(async () => (await import('./analysis/analysisTool.tsx')).AnalysisTool),
  },
  {
    id: 'methods',
    title: text.methods.open,
    icon: 'methods',
    size: 'widest',
    keep: true,
    Body: later(async () => (await import('./methods/methodsTool.tsx')).MethodsTool),
  },
  {
    id: 'compare',
    title: text.compare.open,
    icon: 'compare',
    size: 'wide',
    keep: true,
    Body: later(async () => (await import('./compare/compareTool.tsx')).CompareTool),
  },
];
