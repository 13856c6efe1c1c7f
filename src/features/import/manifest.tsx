import './open.css';
import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { AskDialog } from './askDialog.tsx';
import { DataDoor } from './dataDoor.tsx';
import { FileNotes } from './fileNotes.tsx';
import { StageQuestions } from './questions.tsx';
import { words } from './words.ts';

export const importing: Feature = {
  id: 'import',
  order: 88,
  tool: {
    title: words.title,
    icon: 'table',
    size: 'wide',
    // an opened file is what one wants to read about
    wanted: ({ state }) => state.motion.value?.source === 'file',
    Body: later(async () => (await import('./importTool.tsx')).ImportTool),
  },
  caption: StageQuestions,
  noScene: DataDoor,
  notes: FileNotes,
  dialog: AskDialog,
};
